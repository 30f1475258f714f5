/* hawser/span_motion.h - the motion of a span by a mesh of cable elements, beside that of its reduced
 * models: the same load, from rest, over the same time.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_SPAN_MOTION_H
#define HAWSER_SPAN_MOTION_H

#include <hawser/net_span.h>
#include <hawser/study.h>

#ifdef __cplusplus
extern "C" {
#endif

struct hawser_motions_options {
	double Omega;        /* rad/s, > 0 */
	double until, every; /* s: end, and interval of the rows */
	double after;        /* s: differences and largest values are those of the rows from here on */
	int elements;        /* 0: 120 */
	double step;         /* s, of the mesh: as in struct hawser_net_span_motion_options */
	const struct hawser_fidelity_choice *choice; /* [choices] raw, condensed or full */
	int choices;
	struct hawser_progress progress;
};

/* What the mesh or a model has come to. Probe p and axis k are [p][k]. */
struct hawser_motions_run {
	char name[HAWSER_FIDELITY_NAME]; /* "mesh 120", "condensed 9" */
	enum hawser_status status;       /* of a model; if it failed, tensions and slack_at are those
	                                  * before, and x, largest and difference are not set */
	struct hawser_report report;
	int n;                  /* unknowns, or coordinates */
	double seconds;         /* processor time, with the making of the model */
	double (*x)[3];         /* [rows*HAWSER_SPAN_PROBES] m, displacements */
	double largest[HAWSER_SPAN_PROBES][3];    /* m */
	/* Of a model: root mean square of the difference from the mesh over that of the mesh's
	 * displacement. Of the mesh: of its estimated error. NAN where the mesh does not move. */
	double difference[HAWSER_SPAN_PROBES][3];
	double least, least_at; /* N, s: least tension; of the mesh at all steps, of a model at the rows
	                         * and between, four or more times while an axial wave runs along */
	double slack_at, slack_S; /* s: when tension is first lost (of a model: below 0); NAN: never. m:
	                           * where, from end A; NAN: not known */
};

struct hawser_motions {
	int rows, runs, interrupted;
	struct hawser_motions_run *run; /* [runs] the mesh, then the models */
	double (*off)[3];               /* [rows*HAWSER_SPAN_PROBES] m, estimated errors of the mesh */
	struct hawser_net_motion motion; /* of the mesh: times, energies, tensions */
	int elements, other;            /* of the mesh, and of the one by which its error is estimated */
	double step;                    /* s; 0: by the local error */
	double other_seconds;
};

/* Statuses of hawser_net_span_integrate; HAWSER_ERR_ARGUMENT if a fidelity is none of raw, condensed
 * and full. A model that fails has its status in its run. Release by hawser_motions_clear. */
enum hawser_status hawser_motions_compare(struct hawser_motions *motions,
                                          const struct hawser_scene *scene,
                                          const struct hawser_statics *statics,
                                          const struct hawser_motions_options *options,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_motions_clear(struct hawser_motions *motions);

#ifdef __cplusplus
}
#endif
#endif
