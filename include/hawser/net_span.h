/* hawser/net_span.h - the cable of a span as a net: a chain of cable elements between the two ends.
 *
 * The unstretched length is that of the span's statics, so that it does not matter what gives the
 * tension. Forces of the mesh differ from those of the statics by its error, which falls with the
 * square of the number of elements.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_NET_SPAN_H
#define HAWSER_NET_SPAN_H

#include <hawser/modes.h>
#include <hawser/net_motion.h>

#ifdef __cplusplus
extern "C" {
#endif

/* What has no counterpart in a mesh is refused by HAWSER_ERR_SCENE, which names the key: an
 * inextensible cable, bending stiffness, travel, elastic supports, dampers to a deck, cubic
 * absorbers. */
struct hawser_net_span_options {
	int elements; /* of the whole cable, 2 or more; 0: 120. With attachments, whose parts have an even
	               * number, nearly so many */
	int still;    /* 1: without load, moving ends and damping, which are not looked at: for
	               * statics and modes. 0: damping other than alpha is refused too */
	double Omega; /* rad/s, of the load and of moving ends; > 0 if the scene has them, but with
	               * `still` */
};
void hawser_net_span_settle(struct hawser_net_span_options *options);

/* *net: the span of `scene`, whose statics (hawser_statics_scene) are given. Nodes: the ends A and B,
 * then the attachments along the cable; cables: the parts between them, from A to B, whose elements
 * have nearly equal lengths. A local load is along e, n and z of the static shape; its forces on
 * the nodes have the same work as the load on displacements that are linear between nodes. Release
 * by hawser_net_clear. Statuses: HAWSER_ERR_SCENE, HAWSER_ERR_ARGUMENT (elements, Omega),
 * HAWSER_ERR_MEMORY. */
enum hawser_status hawser_net_span(struct hawser_net *net, const struct hawser_scene *scene,
                                   const struct hawser_statics *statics,
                                   const struct hawser_net_span_options *options,
                                   struct hawser_report *report) HAWSER_MUST_CHECK;

/* --- statics --- */

/* Errors of a mesh against the elastic catenary; relative, `place` in m: the largest distance of a node
 * from its place on the catenary. */
struct hawser_net_span_error {
	double H, T0, T1, length, sag, place;
};

struct hawser_net_span_statics {
	/* H, T0, T1, V0, V1, length, sag, eta, epsilon and delta are those of the mesh; what else there is,
	 * Irvine's parameters too, is the catenary's. Only for output: other functions need the latter. */
	struct hawser_statics statics;
	int points;
	struct hawser_profile_point *point; /* [points] nodes from end A to end B, in the axes of the
	                                     * statics; T at the ends is that of the supports, else the
	                                     * mean of both elements */
	struct hawser_net_span_error error;
	double residual, floor; /* N, as in struct hawser_net_statics */
	int elements;
	const char *method;
};
/* The equilibrium of the mesh. Statuses of hawser_net_span and hawser_net_solve. */
enum hawser_status hawser_net_span_solve(struct hawser_net_span_statics *mesh,
                                         const struct hawser_scene *scene,
                                         const struct hawser_statics *statics, int elements,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_net_span_statics_clear(struct hawser_net_span_statics *mesh);

/* --- modes --- */

/* The first n modes of the mesh, in the structure that other methods return (method "fe", basis:
 * elements). `residual` is an estimate of the error of the mesh, from a second one with half the
 * elements. elements 0: 120. HAWSER_ERR_ARGUMENT if n is not 1 to elements/2 - 1; statuses of
 * hawser_net_modes_solve. */
enum hawser_status hawser_net_span_modes(struct hawser_modes *modes, const struct hawser_scene *scene,
                                         const struct hawser_statics *statics, int n, int elements,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;

/* --- motion --- */

enum { HAWSER_SPAN_PROBES = 3 }; /* at a quarter, half and three quarters of the unstretched length */
const char *hawser_net_span_probe(int probe); /* "quarter", "mid", "three_quarter" */

struct hawser_net_span_motion_options {
	struct hawser_net_span_options mesh;
	double until, every; /* s: end, and interval of the rows; every 0: until/200 */
	double step;         /* s, longest; negative: by the local error; 0: a 1000th of the period of the
	                      * highest multiple of Omega in the load, or of the time in which a
	                      * transverse wave runs to end B and back, if that is shorter */
	double tolerance;    /* as in struct hawser_net_motion_options */
	const char *scheme;  /* row of hawser_net_scheme; NULL: the first */
	int single;          /* 1: without the second mesh, so that no error is known */
	struct hawser_progress progress;
};

struct hawser_net_span_motion {
	int rows, interrupted;
	struct hawser_net_motion motion; /* of the mesh; its probes are those above */
	double (*x)[3];     /* [rows*3] m: displacements of the probes from the equilibrium */
	double (*off)[3];   /* [rows*3] m: estimated errors of these; NULL: not known */
	double step;        /* s; 0: by the local error */
	double slack_S;     /* m, from end A: where tension is first lost; NAN: nowhere */
	int elements, other; /* of the mesh, and of the second one; 0: there was none */
	double seconds, other_seconds; /* processor time of both */
};
/* The motion from rest under the load and with the moving ends of a scene. A second run with half the
 * elements and steps twice as long gives the error: both are of order 2, so that a third of the
 * difference is the error of the first. Where ends move, displacements are from the equilibrium
 * without their motion, and the run begins in the equilibrium with them where they are at t = 0. An
 * interrupted run has the rows before. Statuses of hawser_net_integrate. Release by _clear. */
enum hawser_status hawser_net_span_integrate(struct hawser_net_span_motion *run,
                                             const struct hawser_scene *scene,
                                             const struct hawser_statics *statics,
                                             const struct hawser_net_span_motion_options *options,
                                             struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_net_span_motion_clear(struct hawser_net_span_motion *run);

#ifdef __cplusplus
}
#endif
#endif
