/* hawser/ropeway_modes.h - natural modes of a ropeway about its statics: both lanes, the carriage of
 * the bottom station with its counterweight, the bullwheels, the carriers.
 *
 * The carriage moves along x if the tension is given by a counterweight or as T0, and if it has a
 * mass; its bullwheel turns; that of the drive keeps its speed, or turns if drive.inertia is given.
 * The rope on a bullwheel moves with it and does not stretch. A ropeway of one lane has half of the
 * carriage, and no bullwheels. The theory is in doc/theory-ropeway-modes.md.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROPEWAY_MODES_H
#define HAWSER_ROPEWAY_MODES_H

#include <hawser/obstacles.h>
#include <hawser/progress.h>
#include <hawser/ropeway.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { HAWSER_ROPEWAY_FREEDOMS = 3 }; /* at most: carriage, bottom bullwheel, drive bullwheel */

struct hawser_ropeway_modes_options {
	int n;            /* number of modes of both planes together; 0: 6 */
	double tolerance; /* required relative error of each frequency, 0: 1e-9 */
	int printed;      /* as in struct hawser_line_modes_options */
};

/* What the rope does on its sheaves in the modes of this state: as the scene says, or by itself. */
enum hawser_line_contact_kind hawser_ropeway_holds(const struct hawser_ropeway_statics *st);
/* The bodies that move ends of the rope; returns their number. */
int hawser_ropeway_freedoms(struct hawser_line_freedom freedom[HAWSER_ROPEWAY_FREEDOMS],
                            const struct hawser_ropeway_statics *st);
/* Modes about a state: real ones at rest, complex ones (modes->gyroscopic) if the rope runs. *modes is
 * overwritten, and refers to *st; release it with hawser_line_modes_clear. Statuses: those of
 * hawser_line_modes_running. */
enum hawser_status hawser_ropeway_modes_solve(struct hawser_line_modes *modes,
                                              const struct hawser_ropeway_statics *st,
                                              const struct hawser_ropeway_modes_options *options,
                                              struct hawser_report *report) HAWSER_MUST_CHECK;

/* The span between two towers (or stations) of a lane to which each span of the modes belongs.
 * of [modes->spans]: lane*(towers + 1) + number, counted from the bottom station; -1: within the train
 * of sheaves of one tower. */
void hawser_ropeway_modes_spans(int *of, const struct hawser_line_modes *modes,
                                const struct hawser_ropeway_statics *st);

/* --- frequencies along a sweep: of the tension, the speed, a tower's height, the phase ---
 *
 * Of a ropeway, or of a span over obstacles: its free parts, from one obstacle to the next, are the
 * spans; an obstacle that the rope passes clear of divides them where the rope is above or below its
 * centre. */

struct hawser_ropeway_track_options {
	const double *value; /* [points] of what is swept, ascending or descending */
	int points;
	/* Open the scene at a value, one or the other; what is opened is cleared by the sweep. Calls are
	 * from the caller's thread. */
	enum hawser_status (*open)(struct hawser_ropeway *ropeway, void *context, double value,
	                           struct hawser_report *report);
	enum hawser_status (*open_obstacles)(struct hawser_obstacles *obstacles, void *context,
	                                     double value, struct hawser_report *report);
	void *context;
	int load_case;       /* index of a case */
	int n;               /* number of branches: the lowest at the first value; 0: 6 */
	double tolerance;    /* as in struct hawser_ropeway_modes_options */
	int threads;         /* 0: hawser's default; the result does not depend on it */
	struct hawser_progress progress;
};

/* A branch at a value. */
struct hawser_ropeway_track_point {
	double omega, residual; /* rad/s; NAN: the branch is lost, by shapes that change too much */
	double share;           /* of the kinetic energy, in this span: */
	int span;               /* lane*(towers + 1) + number, from the bottom station */
};

struct hawser_ropeway_track_sample {
	double value;
	int inserted;           /* 1: between two of the values asked for */
	int unsure;             /* 1: branches were continued with shapes that had changed much */
	double T0;              /* N, at the bottom station, or at end A */
	int gyroscopic;         /* 1: the rope runs */
	int touched;            /* number of obstacles that the rope touches; of a ropeway 0 */
};

/* Where two branches of a plane change their order, or come closest. */
struct hawser_ropeway_track_crossover {
	int veers;              /* 0: they cross, each with its shape; 1: they exchange their shapes */
	double value, omega;    /* omega: mean of the two, rad/s */
	double gap;             /* relative to omega; 0: between spans that do not interact */
	int below, above;       /* branches from 0; -1: one that is not among those asked for */
};

struct hawser_ropeway_track {
	int samples, branches, crossovers, solves;
	struct hawser_ropeway_track_sample *sample;       /* [samples] */
	struct hawser_ropeway_track_point *point;         /* [samples][branches] */
	enum hawser_plane *plane;                         /* [branches] */
	struct hawser_ropeway_track_crossover *crossover; /* [crossovers] by sample */
	double least_correlation; /* of a branch's shapes at neighbouring samples, squared */
	int ended;              /* 1: at `end` the line has no solution any more, and the sweep ends */
	double end;
	struct hawser_report why;
	int interrupted;        /* 1: by options.progress; the sweep ends early */
};

/* Follow the lowest modes along a sweep by their shapes; doc/theory-ropeway-modes.md. Without a
 * solution at the first value its status is returned; a later one ends the sweep. Other statuses:
 * HAWSER_ERR_ARGUMENT, HAWSER_ERR_MEMORY. */
enum hawser_status hawser_ropeway_track_solve(struct hawser_ropeway_track *track,
                                              const struct hawser_ropeway_track_options *options,
                                              struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_ropeway_track_clear(struct hawser_ropeway_track *track);

#ifdef __cplusplus
}
#endif
#endif
