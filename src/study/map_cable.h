/* study/map_cable.h - the parts of the field of a scene or a model: structures (map_structure.c),
 * and points (map_cable.c). SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STUDY_MAP_CABLE_H
#define HAWSER_STUDY_MAP_CABLE_H

#include "study/map_quantity.h"

/* To which part of the way from scene to value a parameter matters, ascending. */
enum hawser__reach {
	HAWSER__REACH_OMEGA = 0,
	HAWSER__REACH_LOAD,
	HAWSER__REACH_DAMPING,
	HAWSER__REACH_RATES, /* the scene's damping: D alone */
	HAWSER__REACH_MODEL, /* the scene's load */
	HAWSER__REACH_STRUCTURE
};

struct hawser__structure {
	double value;
	enum hawser_status status; /* why there is none */
	struct hawser_report report;
	struct hawser_modes modes;
	struct hawser_rom rom;
	int used; /* in this preparation */
};

struct hawser__map_cable {
	struct hawser_map_source source;
	const struct hawser__map_quantity *quantity;
	enum hawser__reach reach[2];
	int varies;     /* the axis on which structures depend, 2: both, -1: none */
	int models;     /* an axis changes the model, made from the same modes */
	int damps;      /* an axis changes nothing but D of a linear model */
	int n, multiples; /* lines: frequencies, and multiples of Omega; 0: none */
	int marks;        /* of a point: margins; for lines the frequencies and Omega */
	struct hawser__structure *kept; /* [count] ascending value */
	size_t count, room;
	char *identity;
	struct hawser_map_condensed condensed;
};

/* map_point.c: open, close and point of the field. */
enum hawser_status hawser__map_worker_open(void **to, void *context, struct hawser_report *report);
void hawser__map_worker_close(void *worker);
enum hawser_status hawser__map_worker_point(void *worker, struct hawser_map_sample *sample,
                                            double *marks, double x, double y,
                                            struct hawser_report *report);

static inline int hawser__map_omega_is_axis(const struct hawser__map_cable *cable)
{
	return cable->reach[0] == HAWSER__REACH_OMEGA || cable->reach[1] == HAWSER__REACH_OMEGA;
}

/* Count the last multipliers of the room. */
void hawser__map_condensed_note(struct hawser_map_condensed *condensed,
                                const struct hawser__map_room *room);

/* The scene with the axes set that reach as far as `least`; not to be cleared. */
enum hawser_status hawser__map_cable_axes(struct hawser_scene *scene,
                                          const struct hawser__map_cable *cable,
                                          const double at[2], enum hawser__reach least,
                                          struct hawser_report *report);
/* The model that the quantity asks for. */
enum hawser_status hawser__map_cable_model(struct hawser_rom *rom,
                                           const struct hawser__map_cable *cable,
                                           const struct hawser_modes *modes,
                                           const struct hawser_scene *scene,
                                           struct hawser_report *report);

/* Statics, modes and, unless an axis changes it, the model. A failure is kept with its report:
 * every point that needs this structure tells it. */
void hawser__structure_build(struct hawser__structure *to, const struct hawser__map_cable *cable,
                             const double at[2]);
void hawser__structure_clear(struct hawser__structure *structure);
/* The one kept for a value of the axis that varies structures, or NULL. */
struct hawser__structure *hawser__structure_find(const struct hawser__map_cable *cable,
                                                 double value);
/* hawser_map_field.prepare: keep those that the points need. */
enum hawser_status hawser__structure_prepare(void *context, const double *x, const double *y,
                                             int count, int threads, struct hawser_report *report);

/* The room of a map's worker, with the multipliers of its last point; from its next point on with
 * so many times the steps a period. */
const struct hawser__map_room *hawser__map_worker_room(void *worker, int finer);

/* The model at a point and the forcing frequency in SI units, which serve until the worker's next
 * point or call. *steady: statics or modes failed. Statuses of the statics, the modes and the
 * model. */
enum hawser_status hawser__map_worker_model(void *worker, const struct hawser_rom **rom,
                                            double *omega, int *steady, double x, double y,
                                            struct hawser_report *report);
/* Whether the structure of a point is kept, or the point makes its own. */
int hawser__map_worker_prepared(void *worker, double x, double y);
/* What becomes of a point whose model, or value, failed: 1 where its code tells, 0 where all
 * fails. */
int hawser__map_own_failure(struct hawser_map_sample *sample, enum hawser_status status, int steady);
/* The axis, 1 x or 2 y, along which no statics and modes are made anew though they are along the
 * other; 0: neither or both. */
int hawser__map_cable_cheap(const void *context);

#endif
