/* rom/condense/fields.h - terms of a model that contain fields with a given motion: of the supports, or
 * the static response to the load.
 *
 * The fields are coordinates of the energy like those of the model, each with a periodic function of
 * the phase as its value. In the equation of coordinate u_j the terms of degree 3 in the energy then
 * give f (s s) and K (s u), those of degree 4 f (s s s), K (s s u) and Q (s u u).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_FIELDS_H
#define HAWSER_ROM_FIELDS_H

#include <hawser/rom.h>

#include "rom/condense/support.h"

enum {
	HAWSER__LOAD_FIELDS = 6, /* most responses to the load; further ones are left out */
	HAWSER__FIELDS_MOST = HAWSER__SUPPORT_MOST + HAWSER__LOAD_FIELDS,
	HAWSER__FIELDS_PAIRS = HAWSER__FIELDS_MOST*(HAWSER__FIELDS_MOST + 1)/2,
	HAWSER__FIELDS_TRIPLES = HAWSER__FIELDS_PAIRS*(HAWSER__FIELDS_MOST + 2)/3
};

/* Least change of the tension, relative, by the slopes of a response to the load that counts;
 * chosen. */
#define HAWSER__FAINT_FIELD 2e-5

/* What multiplies a product of signals. */
struct hawser__fields_share {
	double *f, *K; /* [n], [n][n] of the model; NULL if there is none */
	int quads;
	struct hawser_quad *Q; /* [quads] */
};

struct hawser__fields {
	int size;   /* coordinates of the model */
	int moving; /* of which so many come before the fields in the tensors, and the others behind them */
	int count;  /* of the fields */
	int ends;   /* the first fields, of the supports; of the others, the responses to the load, the
	             * stiffness K (s u) is left out, since the model has it */
	struct hawser__signal signal[HAWSER__FIELDS_MOST]; /* [count] */
	struct hawser__fields_share one[HAWSER__FIELDS_MOST], two[HAWSER__FIELDS_PAIRS],
		three[HAWSER__FIELDS_TRIPLES];
};

/* Sort the entries of Q and C of `tensors` that contain fields. HAWSER_ERR_MEMORY. */
enum hawser_status hawser__fields_sort(struct hawser__fields *fields, const struct hawser_rom *tensors,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;
/* Add them to the model as harmonics; or as terms of its history, in which field i has the signal
 * number[i]. HAWSER_ERR_MEMORY. */
enum hawser_status hawser__fields_spread(struct hawser_rom *rom, const struct hawser__fields *fields,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;
enum hawser_status hawser__fields_give(struct hawser_rom *rom, struct hawser__fields *fields,
                                       const int *number,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__fields_clear(struct hawser__fields *fields);

/* --- load_fields.c: the static response of the condensed modes to the load, as fields of the
 * energy --- */

/* Field i has the factor cos(k tau), or sin(k tau) if sine[i]. */
struct hawser__load_fields {
	int count;
	double *strain; /* [count][points of the grid][3] a, b, c */
	enum hawser_plane plane[HAWSER__LOAD_FIELDS];
	int k[HAWSER__LOAD_FIELDS], sine[HAWSER__LOAD_FIELDS];
};

/* Variation of the stiffness of the first `moving` modes by the static response of the others to the
 * load and to the changes of the speed: added to the harmonics and the ramp of a model, which must
 * exist. The responses to the load that matter as fields, K-orthogonal to these modes, are in *fields,
 * zero on entry. Clear it, on failure too. HAWSER_ERR_SCENE: a load that is not on the cable. */
enum hawser_status hawser__rom_vary(struct hawser_rom *rom, struct hawser__load_fields *fields,
                                    const struct hawser_modes *modes, int moving,
                                    const struct hawser_scene *scene,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__load_fields_clear(struct hawser__load_fields *fields);

#endif
