/* hawser/campbell.h - natural frequencies of a travelling cable along a sweep of its speed: the
 * Campbell diagram.
 *
 * At each speed the sweep computes the steady state (struct hawser_motion) and its gyroscopic modes
 * (gyroscopic.h). Branches are followed by the bi-orthogonal correlation of their shapes, as in the
 * Irvine diagram (irvine.h), so that branches are not swapped at a veering, however narrow it is.
 * doc/theory-campbell.md has the algorithm.
 *
 * Wherever the steady state exists, the apparent cable is under tension, so that K is positive
 * definite, the eigenvalues are imaginary, and neither divergence nor flutter occurs. The only
 * critical speed of a cable is therefore the speed at which the steady state ends. The other kinds
 * serve other models. Damping is neglected; re is 0 except for methods whose matrices are not
 * symmetric.
 *
 * Quantities are in SI, frequencies in rad/s, not scaled, since the time unit varies along a sweep.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CAMPBELL_H
#define HAWSER_CAMPBELL_H

#include <hawser/gyroscopic.h>
#include <hawser/irvine.h>
#include <hawser/progress.h>

#ifdef __cplusplus
extern "C" {
#endif

enum hawser_critical_kind {
	HAWSER_CRITICAL_DIVERGENCE = 0, /* an eigenvalue leaves 0 along the real axis */
	HAWSER_CRITICAL_FLUTTER,        /* a pair leaves the imaginary axis */
	HAWSER_CRITICAL_NO_STEADY_STATE /* the steady state ends: the taut and the slack one meet in a
	                                 * fold */
};

struct hawser_critical {
	double speed; /* m/s */
	enum hawser_critical_kind kind;
	enum hawser_plane plane;
};

struct hawser_campbell_station {
	struct hawser_statics statics; /* with the apparent quantities */
	double speed; /* m/s */
	double moved; /* m/s, distance from the requested grid point; as in struct
	               * hawser_irvine_station */
	int inserted; /* 0: a requested point; 1: added by the refinement */
	int unsure;   /* 1: three or more branches changed their shapes within the smallest step before
	               * this station, and were continued in the order of their frequencies */
};

/* The point at which two in-plane branches are closest; numbers as in struct
 * hawser_irvine_crossover. */
struct hawser_campbell_crossover {
	enum hawser_crossover_kind kind;
	double speed;             /* m/s */
	int below, above;
	double omega;             /* rad/s, mean of the two frequencies */
	double gap, relative_gap; /* rad/s, and over omega */
};

struct hawser_campbell {
	const char *method; /* static string */
	double limit;       /* m/s, speed at which the steady state ends */
	int stations, branches, crossovers, criticals;
	int in_plane;       /* branches in the plane; they come first, by number */
	int solves;         /* number of modal solutions computed */
	int basis;          /* largest number of functions per component in these solutions */
	int unsure;         /* number of stations with `unsure` set */
	double least_correlation; /* as in struct hawser_irvine, with the inner product of the energy */
	struct hawser_campbell_station *station;     /* [stations] by speed */
	struct hawser_irvine_branch *branch;         /* [branches] numbered at the first station */
	struct hawser_campbell_crossover *crossover; /* [crossovers] by speed */
	struct hawser_critical *critical;            /* [criticals] within the range of the sweep */
	double *re, *im;            /* [stations][branches] eigenvalues, rad/s, im >= 0 */
	double *residual;           /* [stations][branches] error estimates, struct
	                             * hawser_complex_mode */
	double *downstream;         /* [stations][branches] as in struct hawser_mode */
	int *place;                 /* [stations][branches] from 0, by frequency in its plane */
	enum hawser_family *family; /* [stations][branches] by the larger share of the kinetic energy */
	void *held; /* memory of the arrays */
};

/* A member that is 0 has its default. */
struct hawser_campbell_options {
	double from, to; /* m/s, from < to; to 0: see hawser_campbell_range. If `to` exceeds the limit,
	                  * the sweep approaches the limit in steps of a quarter of the remaining
	                  * distance */
	int points;      /* stations before refinement, >= 2, equidistant; 0: 100 */
	int n;           /* number of branches: the lowest at `from`, both planes together; 0: 10 */
	const char *method; /* name of a hawser_complex_modes_method; NULL: "spectral" */
	int basis;          /* as in struct hawser_modes_options */
	double tolerance;   /* as in struct hawser_modes_options */
	double correlation; /* as in struct hawser_irvine_options */
	double crossing;    /* as in struct hawser_irvine_options */
	struct hawser_progress progress; /* called after each station; its answer does not end the sweep */
};

/* *limit: the largest speed of a steady state (hawser_statics_limit, reduced by the effect of the
 * fluctuation). *to, the default end of a sweep: *limit if it follows from a held tension; if
 * *limit is sqrt(EA/rho), twice the speed of transverse waves, sqrt(T0/rho), but at most *limit.
 * Statuses: HAWSER_ERR_ARGUMENT (a scene without travel), those of hawser_statics_limit. */
enum hawser_status hawser_campbell_range(double *to, double *limit,
                                         const struct hawser_scene *scene,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;

/* Sweep the speed of a scene with travel. The sweep uses travel.fluctuation and travel.hold of the
 * scene, not its travel.speed. *campbell is overwritten; release it with hawser_campbell_clear.
 * Statuses: HAWSER_ERR_ARGUMENT (range, counts, a scene without travel), HAWSER_ERR_NO_SOLUTION (no
 * steady state at `from`), and those of hawser_statics_travel and hawser_complex_modes_solve. */
enum hawser_status hawser_campbell_trace(struct hawser_campbell *campbell,
                                         const struct hawser_scene *scene,
                                         const struct hawser_campbell_options *options,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_campbell_clear(struct hawser_campbell *campbell);

/* Carriers on the cable at a spacing of d excite it at the frequencies n 2 pi v/d. A resonance is
 * an intersection of such a line with a branch, which is interpolated linearly between the
 * stations. */
struct hawser_campbell_resonance {
	int harmonic, branch; /* n from 1; index from 0 */
	double speed, omega;  /* m/s, rad/s */
};
/* *resonance [*count]: all resonances up to the given harmonic, ordered by harmonic, branch and
 * speed; release with free(). Statuses: HAWSER_ERR_ARGUMENT (spacing or harmonics not positive),
 * HAWSER_ERR_MEMORY. */
enum hawser_status hawser_campbell_resonances(struct hawser_campbell_resonance **resonance,
                                              int *count, const struct hawser_campbell *campbell,
                                              double spacing, int harmonics,
                                              struct hawser_report *report)
	HAWSER_MUST_CHECK;

const char *hawser_critical_name(enum hawser_critical_kind kind); /* "no-steady-state" */

#ifdef __cplusplus
}
#endif
#endif
