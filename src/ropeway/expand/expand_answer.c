/* ropeway/expand/expand_answer.c - what the modes that are not kept do under a force that oscillates
 * (modes/driven.h). A displacement of the whole rope is a row of states and strains.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <cblas.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "ropeway/expand/expand_modes.h"

struct work {
	const struct hawser__lmode *rope;
	const struct hawser__lexpand_modes *modes;
	size_t size, strains;  /* of all systems */
	double *load;          /* [size of a system] */
};

/* A row of a displacement. */
struct field {
	double *x, *strain;
};

static struct field field_of(const struct work *w, double *row)
{
	return (struct field){row, row + w->size};
}

/* --- products --- */

/* x'y in the inner product of M. */
static double product(const void *of, const double *x, const double *y)
{
	const struct work *w = of;
	double sum = 0.0;

	for (int i = 0; i < w->rope->systems; i++) {
		const struct hawser__lmode_system *system = &w->rope->system[i];

		hawser__lmode_inertia(w->load, x, system);
		sum += hawser__lmode_product(w->load, y, system);
		x += system->size;
		y += system->size;
	}
	return sum;
}

/* Where system `own` begins. */
static struct field part_of(const struct work *w,
                                            const struct field *field, int own)
{
	struct field part = *field;

	for (int i = 0; i < own; i++) {
		part.x += w->rope->system[i].size;
		part.strain += w->rope->system[i].strains;
	}
	return part;
}

/* field = P field. */
static void remove_kept(const struct work *w, const struct field *field)
{
	for (int k = 0; k < w->modes->search.n; k++) {
		const struct hawser__lexpand_shape *mode = &w->modes->shape[k];
		const struct hawser__lmode_system *system = &w->rope->system[mode->system];
		struct field part = part_of(w, field, mode->system);
		double sum;

		hawser__lmode_inertia(w->load, mode->x, system);
		sum = hawser__lmode_product(w->load, part.x, system);
		cblas_daxpy(system->size, -sum, mode->x, 1, part.x, 1);
		cblas_daxpy(system->strains, -sum, mode->strain, 1, part.strain, 1);
	}
}

/* to = P A from. */
static enum hawser_status follow(const void *of, double *to, const double *from,
                                 struct hawser_report *report)
{
	const struct work *w = of;
	struct field field = field_of(w, to);
	double *x = field.x, *strain = field.strain;

	(void)report; /* no memory is asked for */
	for (int i = 0; i < w->rope->systems; i++) {
		struct hawser__lmode_system *system = &w->rope->system[i];

		hawser__lmode_inertia(w->load, from, system);
		if (system->plane == HAWSER_IN_PLANE)
			hawser__lmode_static(x, strain, system, w->load);
		from += system->size;
		x += system->size;
		strain += system->strains;
	}
	remove_kept(w, &field);
	return HAWSER_OK;
}

/* --- the static response --- */

/* A force along y per length on one segment, in the frame of its displacements. */
static void pull_segment(double *load, const struct hawser__lmode *rope,
                         const struct hawser__lmode_segment *s,
                         const struct hawser__lexpand_force *force)
{
	const struct hawser__lmode_piece *piece = s->piece;
	double angle = atan2(piece->reference[1], piece->reference[0]);

	for (int p = 0; p < s->grid.points; p++) {
		double at = piece->s0 + s->grid.s[p], value = force->pull(force->wave, piece->lane, at);

		if (s->D == 1)
			hawser_line_at(rope->lane[piece->lane], NULL, &angle, NULL, NULL, NULL, at*rope->length);
		load[p] = value*sin(angle);
		if (s->D == 2)
			load[s->grid.points + p] = value*cos(angle);
	}
}

static void hold(const struct work *w, const struct field *z,
                 const struct hawser__lexpand_force *force)
{
	double *x = z->x, *strain = z->strain;

	for (int i = 0; i < w->rope->systems; i++) {
		struct hawser__lmode_system *system = &w->rope->system[i];

		memset(w->load, 0, (size_t)system->size*sizeof *w->load);
		for (int k = 0; system->plane == HAWSER_IN_PLANE && k < system->segments; k++)
			pull_segment(w->load + system->segment[k].at, w->rope, &system->segment[k], force);
		if (system->plane == HAWSER_IN_PLANE)
			hawser__lmode_static(x, strain, system, w->load);
		x += system->size;
		strain += system->strains;
	}
	remove_kept(w, z);
}

static enum hawser_status begin(struct work *w, struct hawser_report *report)
{
	size_t most = 1;

	for (int i = 0; i < w->rope->systems; i++) {
		size_t own = (size_t)w->rope->system[i].size;

		most = own > most ? own : most;
		w->size += own;
		w->strains += (size_t)w->rope->system[i].strains;
	}
	w->load = hawser__numbers(most, 1);
	return w->load ? HAWSER_OK : hawser__no_memory(report, "line rom");
}

enum hawser_status hawser__lexpand_answer(struct hawser__driven *answer, double *pull,
                                          const struct hawser__lexpand_modes *t,
                                          const struct hawser__lexpand_force *force,
                                          struct hawser_report *report)
{
	struct work w = {.rope = &t->rope, .modes = t};
	enum hawser_status status = begin(&w, report);
	const struct hawser__driven_by by = {.of = &w, .width = w.size + w.strains, .product = product,
	                                     .follow = follow};

	*answer = (struct hawser__driven){.known = 0};
	if (!status)
		status = hawser__driven_open(answer, by.width, report);
	if (!status) {
		const struct field z = field_of(&w, answer->field);

		if (force->pull)
			hold(&w, &z, force);
		else
			status = hawser__lexpand_drive(z.x, z.strain, pull, t, force, report);
	}
	if (!status)
		status = hawser__driven_find(answer, &by, report);
	free(w.load);
	return status;
}
