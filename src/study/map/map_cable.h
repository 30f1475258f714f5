/* study/map/map_cable.h - shared parts of the field of a scene or a model: structures (map_structure.c)
 * and points (map_cable.c). SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STUDY_MAP_CABLE_H
#define HAWSER_STUDY_MAP_CABLE_H

#include <hawser/map.h>

#include "response/orbit/start.h"

/* --- map_quantity.c: the quantity of a map of a cable at a point: a row of a table --- */

/* The workspace of a thread for models of up to n coordinates. */
struct hawser__map_room {
	int n;
	int finer; /* factor on the number of steps for multipliers; 0 and 1: unchanged */
	struct hawser_linear *linear;
	double *log_modulus, *argument; /* [2n] */
	double *frequency;              /* [n] */
	double *exponents;              /* [HAWSER__EXPONENTS(n)] */
};
enum hawser_status hawser__map_room_fit(struct hawser__map_room *room, int n,
                                        struct hawser_report *report);
void hawser__map_room_clear(struct hawser__map_room *room);

struct hawser__map_quantity {
	struct hawser_map_quantity about;
	double threshold;
	/* Computes value and number of the sample of a model at the scaled omega (0: none). A failure is
	 * that of the point, except for lack of memory and the like. */
	enum hawser_status (*measure)(struct hawser__map_room *room, struct hawser_map_sample *sample,
	                              const struct hawser_rom *rom, double omega,
	                              struct hawser_report *report);
	int resonant; /* parametric: 1: instabilities lie where sums of frequencies are multiples of
	               * Omega */
};
const struct hawser__map_quantity *hawser__map_quantity(const char *name);

/* The first stage of the computation that a parameter affects, the last stage first. */
enum hawser__reach {
	HAWSER__REACH_OMEGA = 0,
	HAWSER__REACH_LOAD,
	HAWSER__REACH_DAMPING,
	HAWSER__REACH_PARAMETER, /* of a model's file */
	HAWSER__REACH_RATES, /* the damping of the scene: D only */
	HAWSER__REACH_MODEL, /* the load of the scene, the motion of its supports */
	HAWSER__REACH_STRUCTURE
};

struct hawser__structure {
	double value;
	enum hawser_status status; /* status of the computation of this structure */
	struct hawser_report report;
	struct hawser_modes modes;
	struct hawser_rom rom;
	int used; /* 1: needed in the present preparation */
};

struct hawser__map_cable {
	struct hawser_map_source source;
	const struct hawser__map_quantity *quantity;
	enum hawser__reach reach[2];
	int varies;     /* the parameter on which structures depend: 0, 1; 2: both, -1: none */
	int models;     /* 1: a parameter changes the model that is made from the same modes */
	int damps;      /* 1: a parameter changes only D of a linear model */
	int moves;      /* 1: a linear quantity, about the periodic response */
	int n;            /* coordinates with exponents among the marks; 0: none */
	int marks;        /* of a point: margins and exponents */
	struct hawser__structure *kept; /* [count] ascending value */
	size_t count, room;
	char *identity;
	struct hawser_map_condensed condensed;
	struct hawser__map_guides *guides; /* from which responses start, or NULL */
};

/* map_point.c: the functions open, close and point of the field. */
enum hawser_status hawser__map_worker_open(void **to, void *context, struct hawser_report *report);
void hawser__map_worker_close(void *worker);
enum hawser_status hawser__map_worker_point(void *worker, struct hawser_map_sample *sample,
                                            double *marks, double x, double y,
                                            struct hawser_report *report);

static inline int hawser__map_has_parameter(const struct hawser__map_cable *cable)
{
	return cable->reach[0] == HAWSER__REACH_PARAMETER || cable->reach[1] == HAWSER__REACH_PARAMETER;
}
/* The file with the values of its parameters at a point, which are put into parameter
 * [HAWSER_PARAMETERS]. */
void hawser__map_cable_file(struct hawser_rom_source *to, struct hawser_parameter *parameter,
                            const struct hawser__map_cable *cable, const double at[2]);

static inline int hawser__map_omega_is_axis(const struct hawser__map_cable *cable)
{
	return cable->reach[0] == HAWSER__REACH_OMEGA || cable->reach[1] == HAWSER__REACH_OMEGA;
}

/* Count the multipliers that were computed last. */
void hawser__map_condensed_note(struct hawser_map_condensed *condensed,
                                const struct hawser__map_room *room);

/* The scene with the parameters set that affect stages up to `least`; must not be cleared. */
enum hawser_status hawser__map_cable_axes(struct hawser_scene *scene,
                                          const struct hawser__map_cable *cable,
                                          const double at[2], enum hawser__reach least,
                                          struct hawser_report *report);
/* Whether the quantity takes a model with its tensors. */
static inline int hawser__map_cable_whole(const struct hawser__map_cable *cable)
{
	return cable->quantity->about.nonlinear || cable->moves;
}
/* Build the model that the quantity requires. */
enum hawser_status hawser__map_cable_model(struct hawser_rom *rom,
                                           const struct hawser__map_cable *cable,
                                           const struct hawser_modes *modes,
                                           const struct hawser_scene *scene,
                                           struct hawser_report *report);

/* Compute statics, modes and, unless a parameter changes it, the model. If this fails, the
 * structure keeps the report, and every point with this structure returns it. */
void hawser__structure_build(struct hawser__structure *to, const struct hawser__map_cable *cable,
                             const double at[2]);
void hawser__structure_clear(struct hawser__structure *structure);
/* The stored structure for this value of the parameter, or NULL. */
struct hawser__structure *hawser__structure_find(const struct hawser__map_cable *cable,
                                                 double value);
/* Compute the structures that the points need. */
enum hawser_status hawser__structure_prepare(void *context, const double *x, const double *y,
                                             int count, int threads, struct hawser_report *report);

/* map_guide.c. _prepare: hawser_map_field.prepare. _guide: the orbits from which the response at a
 * point starts, of what _prepare has computed, or NULL; they may be in *own, which the caller clears.
 * _guided: 0: it has not. */
enum hawser_status hawser__map_prepare(void *context, const double *x, const double *y, int count,
                                       int threads, struct hawser_report *report);
enum hawser_status hawser__map_guide(const struct hawser__way **guide, struct hawser__way *own,
                                     const struct hawser__map_cable *cable, double x, double y);
int hawser__map_guided(const struct hawser__map_cable *cable, double x, double y);
void hawser__map_guides_free(struct hawser__map_guides *guides);
/* The number of coordinates of the model at this point, with or without a response. */
enum hawser_status hawser__map_worker_coordinates(void *worker, int *n, const double at[2],
                                                  struct hawser_report *report);
/* The orbits that the response at x, y passes on its way from rest, none where there is no model. */
enum hawser_status hawser__map_worker_way(void *worker, struct hawser__way *way,
                                          const struct hawser__way *guide, double x, double y);

/* _room: the workspace of a map's worker, with the multipliers of its last point. _refine:
 * multiplies the number of steps per period, from the next point on. */
const struct hawser__map_room *hawser__map_worker_room(void *worker, int finer);

/* The model at a point and the forcing frequency in SI units; both are valid until the next point
 * or call of the worker. *steady: 1: statics or modes failed; 2: the response. Statuses of the
 * statics, the modes and the model. */
enum hawser_status hawser__map_worker_model(void *worker, const struct hawser_rom **rom,
                                            double *omega, int *steady, double x, double y,
                                            struct hawser_report *report);
/* What the worker maps. */
const struct hawser__map_cable *hawser__map_worker_cable(const void *worker);
/* 1: the structure of a point is stored; 0: the point computes its own. */
int hawser__map_worker_prepared(void *worker, double x, double y);
/* After the model or the value of a point failed: 1 if its code reports this, 0 if the map must
 * fail. */
int hawser__map_own_failure(struct hawser_map_sample *sample, enum hawser_status status, int steady);
/* The parameter (1: x, 2: y) along which no new statics and modes are needed, while they are needed
 * along the other; 0: neither or both. */
int hawser__map_cable_cheap(const void *context);

#endif
