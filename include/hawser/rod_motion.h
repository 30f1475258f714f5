/* hawser/rod_motion.h - motion of a geometrically exact rod: time integration.
 *
 * A rod with a held end begins at rest, in its equilibrium under weight and the loads at t = 0 (before
 * a jump of a load at that time). A free rod, or one whose scene says so, begins at rest in its
 * unloaded shape. Held ends may move. A run can continue from the last state of another one.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROD_MOTION_H
#define HAWSER_ROD_MOTION_H

#include <hawser/progress.h>
#include <hawser/rod.h>
#include <hawser/status.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A scheme of time integration. */
struct hawser_rod_scheme {
	const char *name, *summary, *source;
	int order; /* 0: chosen by the scheme from step to step */
};
const struct hawser_rod_scheme *hawser_rod_scheme(int index); /* NULL beyond the last */

/* The whole rod at one time; valid during the call only. */
struct hawser_rod_frame {
	double t;
	int row, nodes;
	const double (*x)[3]; /* [nodes] m */
	const double (*q)[4]; /* [nodes] quaternions, see hawser_rod_point */
	const double *T, *M;  /* [nodes-1] N, N m: tension and moment in the middle of each element */
};

struct hawser_rod_motion_options {
	double until;        /* s, end */
	double every;        /* s, between rows; 0: until/400 */
	double step;         /* s, at most; 0: the scene's; negative, or 0 in both: by the local error */
	double tolerance;    /* of the local error of a place in a step, over the length of the rod;
	                      * 0: 1e-6 */
	const char *scheme;  /* row of hawser_rod_scheme; NULL: the first */
	double rho_inf;      /* 0: the scene's, or 0.8; HAWSER_NONE: 0 */
	const char *initial; /* file of a state; NULL: see above */
	const double *probe; /* [probes] m, unstretched lengths from the start; those at t = 0 if there is
	                      * a winch: they keep their shares of the first segment */
	int probes;
	int skip_error;      /* 1: without the two runs for step and mesh error */
	/* Called for each row; not 0 ends the run. May be NULL. */
	int (*frame)(void *data, const struct hawser_rod_frame *frame);
	void *data;
	struct hawser_progress progress;
};

struct hawser_rod_motion {
	int rows, probes, interrupted;
	double *time;        /* [rows] s */
	double (*x)[3];      /* [rows*probes] m, row by row */
	double (*v)[3];      /* [rows*probes] m/s */
	double *T, *M;       /* [rows*probes] N, N m: tension and moment of the element there */
	/* J. height: of the weight, counted from y = 0. Since the beginning: work of the loads of the
	 * scene, support: of the ends that are held, damped: by damping.alpha, lost: by the scheme. */
	double *kinetic, *strain, *height, *work, *support, *damped, *lost; /* [rows] */
	double (*momentum)[3], (*angular)[3]; /* [rows] N s; N m s, about the origin */
	double (*force)[3], (*moment)[3];     /* [rows] N, N m: of what holds the start, scene's axes */
	int nodes;
	double (*shape)[3];  /* [rows*nodes] m */
	double *water;       /* [rows] J, work of the water since the beginning: of buoyancy, drag and added
	                      * mass, whose kinetic energy is not in `kinetic` */
	double *winch;       /* [rows] J, work of the winch, with the energy of the material that enters */
	double *length;      /* [rows] m, unstretched */
	double *turned;      /* [rows] mean rotation of the rod about z since the beginning, revolutions */
	double closure;      /* largest |lost|, over the largest term of the ledger */
	double momentum_gap, angular_gap; /* N s, N m s: largest error of the ledgers of momentum */
	double local_error;  /* m, sum of the local errors of all steps */
	int checked;         /* 1: the next two are known */
	double step_error;   /* m, of places at all rows: from a run with each step in halves */
	double mesh_error;   /* m: from a run with twice as many elements */
	struct hawser_report unchecked; /* why not, if not by an option */
	double strain_most;  /* largest part of its length by which an element was strained, at rows */
	double reached;      /* s: less than options.until if interrupted */
	const char *scheme;
	double rho_inf;
	int elements, unknowns;
	long steps, iterations, factored, rejected, splits;
	double *state;       /* [states] for hawser_rod_state_write */
	void *held; /* memory of the arrays of rows */
	int states;
};

/* HAWSER_ERR_ARGUMENT: no mass or inertia, times; HAWSER_ERR_NO_SOLUTION, _CONVERGENCE, _NAN: the time
 * and what to do are in the report; HAWSER_ERR_IO, _MEMORY. */
enum hawser_status hawser_rod_integrate(struct hawser_rod_motion *motion, const struct hawser_rod *rod,
                                        const struct hawser_rod_motion_options *options,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_rod_motion_clear(struct hawser_rod_motion *motion);
/* Write the last state to a file, from which another run can go on. */
enum hawser_status hawser_rod_state_write(const struct hawser_rod_motion *motion, const char *path,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;

#ifdef __cplusplus
}
#endif
#endif
