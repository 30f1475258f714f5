/* rom/build/line_answer.c - the expansion of a rope over sheaves at the places of its model, and what
 * the modes that the model does not keep do under its load (ropeway/expand/expand_answer.c).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <math.h>
#include <stdlib.h>

#include "core/report.h"
#include "rom/build/line.h"

_Static_assert((int)HAWSER__LEXPAND_MORE >= (int)HAWSER__LOAD_FIELDS,
               "room for the fields among the shapes");

/* --- places --- */

/* On a piece of the rope, at s from its beginning, where the rope has the slope `angle`. */
struct place {
	int piece;
	double s, angle;
};

static int piece_at(const struct hawser__lmode *rope, int lane, double s)
{
	int found = 0;

	for (int i = 0; i < rope->pieces; i++)
		if (rope->piece[i].lane == lane && rope->piece[i].length > 0.0 && rope->piece[i].s0 <= s)
			found = i;
	return found;
}

/* The points of the line are the ends and the middle of every piece of the free rope. */
static struct place place_of(const struct hawser__line_source *source, int p)
{
	const struct hawser_rom_shapes *shapes = &source->rom->shapes;
	const struct hawser__lmode *rope = source->t->rope;
	int left = (p - shapes->points)/3, piece = 0;
	double s0, length;

	if (p < shapes->points) {
		piece = piece_at(rope, hawser__line_run(rope, p, &s0, &length), shapes->s[p]);
		return (struct place){piece, shapes->s[p] - rope->piece[piece].s0,
			atan2(shapes->tangent[2*p + 1], shapes->tangent[2*p])};
	}
	while (source->t->first[piece] < 0 || left-- > 0)
		piece++;
	return (struct place){piece, rope->piece[piece].length*((p - shapes->points)%3)/2.0, 0.0};
}

static void shape_at(double u[3], double slope[3], const void *of, int shape, int p)
{
	const struct hawser__line_source *source = of;
	struct place at = place_of(source, p);

	hawser__lexpand_shape_at(u, slope, source->t, shape, at.piece, at.s, at.angle);
}

static void pair_at(double u[3], double slope[3], const void *of, int pair, int p)
{
	const struct hawser__line_source *source = of;
	struct place at = place_of(source, p);

	hawser__lexpand_field_at(u, slope, source->t->rope, source->t->second +
	                         (size_t)pair*source->t->width, at.piece, at.s, at.angle);
}

static void field_at(double u[3], double slope[3], const void *of, const double *row, int p)
{
	const struct hawser__line_source *source = of;
	struct place at = place_of(source, p);

	hawser__lexpand_field_at(u, slope, source->t->rope, row, at.piece, at.s, at.angle);
}

/* --- derivatives --- */

static double fourth(const void *of, const int index[4])
{
	return hawser__lexpand_fourth(((const struct hawser__line_source *)of)->t, index);
}

/* Numbers of planes that occur an odd number of times have no energy. */
static int even(const void *of, const int index[4])
{
	const struct hawser__lexpand *t = ((const struct hawser__line_source *)of)->t;
	int out = 0;

	for (int i = 0; i < 4; i++)
		out += t->rope->system[t->shape[index[i]].system].plane == HAWSER_OUT_OF_PLANE;
	return out%2 == 0;
}

/* Change of the tension by the slopes of a shape, relative, if they stretched its system alone. */
static double tightens(const void *of, int shape)
{
	const struct hawser__lexpand *t = ((const struct hawser__line_source *)of)->t;
	const double *slope = t->slope + 3*(size_t)t->points*(size_t)shape;
	const struct hawser__lmode_system *system = &t->rope->system[t->shape[shape].system];
	double longer = 0.0, stretch = 0.0;

	for (int i = 0; i < system->segments; i++) {
		const struct hawser__lmode_segment *s = &system->segment[i];
		int first = t->first[s->index];

		for (int p = first; first >= 0 && p < first + s->grid.points; p++) {
			const double *a = slope + 3*p;

			longer += 0.5*t->weight[p]*(a[1]*a[1] + a[2]*a[2])/t->stretch[p];
			stretch += t->weight[p]*t->tau[p]*t->rope->epsilon;
		}
	}
	return stretch > 0.0 ? longer/stretch : 0.0;
}

static double damping(const void *of, const double *row, double omega2)
{
	(void)row;
	return 2.0*((const struct hawser__line_source *)of)->ratio*sqrt(omega2);
}

struct hawser__expanded hawser__line_expanded(const struct hawser__line_source *source)
{
	return (struct hawser__expanded){.of = source, .n = source->t->n, .equations = source->n,
		.third = source->t->third,
		.fourth = fourth, .even = even, .shape_at = shape_at, .pair_at = pair_at,
		.field_at = field_at, .tightens = tightens, .damping = damping};
}

/* --- the answers --- */

/* The static part in the systems of the rope that it moves, as shapes, while there is room. */
static void add_fields(struct hawser__answers *answers, struct hawser__lexpand_modes *own, int i)
{
	const double *x = hawser__driven_field(&answers->driven[i], 0), *strain = x;

	for (int k = 0; k < own->rope.systems; k++)
		strain += own->rope.system[k].size;
	for (int k = 0; k < own->rope.systems; k++) {
		const struct hawser__lmode_system *system = &own->rope.system[k];
		int moved = system->strains > 0 &&
		            strain[cblas_idamax(system->strains, strain, 1)] != 0.0;

		if (moved && answers->fields < HAWSER__LOAD_FIELDS) {
			own->shape[own->search.n + answers->fields] =
				(struct hawser__lexpand_shape){.system = k, .x = x, .strain = strain};
			answers->field[answers->fields].k = i/2 + 1;
			answers->field[answers->fields].sine = i%2;
			answers->field[answers->fields++].factor = answers->factor;
		}
		x += system->size;
		strain += system->strains;
	}
}

enum hawser_status hawser__line_answers_make(struct hawser__answers *answers, double *pull,
                                             struct hawser__lexpand_modes *own,
                                             const struct hawser_line_modes *modes,
                                             const struct hawser_line_rom_options *o,
                                             struct hawser_report *report)
{
	int passing = o->load == HAWSER_LINE_LOAD_PASSING, count = passing ? 2*o->harmonics : 1;
	enum hawser_status status = HAWSER_OK;

	if (o->load == HAWSER_LINE_LOAD_NONE)
		return HAWSER_OK;
	answers->factor = 1.0;
	answers->driven = calloc((size_t)count, sizeof *answers->driven);
	if (!answers->driven)
		return hawser__no_memory(report, "line rom");
	while (answers->count < count && !status) {
		int i = answers->count++;
		struct hawser__line_wave wave = passing ? hawser__line_wave(modes, o, i)
		                                        : (struct hawser__line_wave){.sine = 0};
		const struct hawser__lexpand_force force = {
			.pull = passing ? hawser__line_pull : NULL, .wave = &wave, .end = o->end,
			.motion = {o->amplitude[0]/modes->length_unit, o->amplitude[1]/modes->length_unit}};

		status = hawser__lexpand_answer(&answers->driven[i], pull, own, &force, report);
	}
	for (int i = 0; i < count && !status; i++)
		add_fields(answers, own, i);
	return status;
}
