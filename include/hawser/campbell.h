/* hawser/campbell.h - natural frequencies of a travelling cable along a sweep of its speed: the
 * Campbell diagram.
 *
 * At each speed the scene's cable has its steady state (struct hawser_motion) and about that its
 * gyroscopic modes (gyroscopic.h). Branches are followed by the bi-orthogonal correlation of their
 * shapes, as those of the Irvine diagram are (irvine.h): a veering does not swap them, however narrow.
 * doc/theory-campbell.md.
 *
 * Up to the speed at which the steady state ends the apparent cable is under tension, so that K is
 * positive definite, the eigenvalues are imaginary and nothing diverges or flutters: the end of the
 * steady state is the one critical speed of a cable. The other kinds are for models that have them.
 * Damping is left out, and re is 0 but for methods whose matrices are not symmetric.
 *
 * SI, and rad/s: the scale of time changes along a sweep.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CAMPBELL_H
#define HAWSER_CAMPBELL_H

#include <hawser/gyroscopic.h>
#include <hawser/irvine.h>

#ifdef __cplusplus
extern "C" {
#endif

enum hawser_critical_kind {
	HAWSER_CRITICAL_DIVERGENCE = 0, /* an eigenvalue leaves 0 along the real axis */
	HAWSER_CRITICAL_FLUTTER,        /* a pair leaves the imaginary axis */
	HAWSER_CRITICAL_NO_STEADY_STATE /* the steady state ends: a fold of the taut and the slack one */
};

struct hawser_critical {
	double speed; /* m/s */
	enum hawser_critical_kind kind;
	enum hawser_plane plane;
};

struct hawser_campbell_station {
	struct hawser_statics statics; /* with its apparent quantities */
	double speed; /* m/s */
	double moved; /* m/s, off its place in the grid; as in struct hawser_irvine_station */
	int inserted; /* 0: one of the points asked for; 1: added by the refinement */
	int unsure;   /* 1: three or more branches changed their shapes within the smallest step before it,
	               * and were taken in the order of their frequencies */
};

/* Two branches in the plane at their closest; numbers as in struct hawser_irvine_crossover. */
struct hawser_campbell_crossover {
	enum hawser_crossover_kind kind;
	double speed;             /* m/s */
	int below, above;
	double omega;             /* rad/s, mean of the two */
	double gap, relative_gap; /* rad/s, and over omega */
};

struct hawser_campbell {
	const char *method; /* static string */
	double limit;       /* m/s, speed at which the steady state ends */
	int stations, branches, crossovers, criticals;
	int in_plane;       /* branches in the plane; they come first, by number */
	int solves;         /* modal solutions it took */
	int basis;          /* the most functions a component that one of them took */
	int unsure;         /* stations that are */
	double least_correlation; /* as in struct hawser_irvine, of the energy's product */
	struct hawser_campbell_station *station;     /* [stations] by speed */
	struct hawser_irvine_branch *branch;         /* [branches] numbered at the first station */
	struct hawser_campbell_crossover *crossover; /* [crossovers] by speed */
	struct hawser_critical *critical;            /* [criticals] of the range that was swept */
	double *re, *im;            /* [stations][branches] eigenvalues, rad/s, im >= 0 */
	double *residual;           /* [stations][branches] as in struct hawser_complex_mode */
	double *downstream;         /* [stations][branches] the same */
	int *place;                 /* [stations][branches] from 0, by frequency in its plane */
	enum hawser_family *family; /* [stations][branches] by the larger share of the kinetic energy */
};

/* Zeros: the defaults. */
struct hawser_campbell_options {
	double from, to; /* m/s, from < to; to 0: see hawser_campbell_range. Beyond the limit the sweep ends
	                  * at it, and gets closer in steps of a quarter of what is left */
	int points;      /* stations before refinement, >= 2, equidistant; 0: 100 */
	int n;           /* branches: the lowest at `from`, both planes together; 0: 10 */
	const char *method; /* of hawser_complex_modes_methods; NULL: "spectral" */
	int basis;          /* as in struct hawser_modes_options */
	double tolerance;   /* the same */
	double correlation; /* as in struct hawser_irvine_options */
	double crossing;    /* the same */
};

/* *to: the limit of the scene's cable (hawser_statics_limit, less what its fluctuation takes), where
 * its tension ends the steady state; else twice the speed of transverse waves, sqrt(T0/rho), but not
 * beyond sqrt(EA/rho), which is *limit then. Statuses: HAWSER_ERR_ARGUMENT (a scene without travel),
 * those of hawser_statics_limit. */
enum hawser_status hawser_campbell_range(double *to, double *limit,
                                         const struct hawser_scene *scene,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;

/* Sweep, of a scene that has travel; its speed is not used, its fluctuation and hold are. *campbell is
 * overwritten, release with hawser_campbell_clear. Statuses: HAWSER_ERR_ARGUMENT (range, counts, a
 * scene without travel), HAWSER_ERR_NO_SOLUTION (no steady state at `from`), and those of
 * hawser_statics_travel and hawser_complex_modes_solve. */
enum hawser_status hawser_campbell_trace(struct hawser_campbell *campbell,
                                         const struct hawser_scene *scene,
                                         const struct hawser_campbell_options *options,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_campbell_clear(struct hawser_campbell *campbell);

/* What rides on the cable at a spacing of d excites it at n 2 pi v/d: where those lines meet the
 * branches, between the stations by straight lines. */
struct hawser_campbell_resonance {
	int harmonic, branch; /* n from 1; index from 0 */
	double speed, omega;  /* m/s, rad/s */
};
/* *resonance: all of them up to the given harmonic, [*count], by harmonic, branch and speed; release
 * with free(). HAWSER_ERR_ARGUMENT (a spacing that is not positive, no harmonic), HAWSER_ERR_MEMORY. */
enum hawser_status hawser_campbell_meet(struct hawser_campbell_resonance **resonance, int *count,
                                        const struct hawser_campbell *campbell, double spacing,
                                        int harmonics, struct hawser_report *report)
	HAWSER_MUST_CHECK;

const char *hawser_critical_name(enum hawser_critical_kind kind); /* "no-steady-state" */

#ifdef __cplusplus
}
#endif
#endif
