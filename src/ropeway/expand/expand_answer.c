/* ropeway/expand/expand_answer.c - what the modes that are not kept do under a force that oscillates
 * (modes/driven.h). A displacement of the whole rope is a row of states and strains.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "ropeway/expand/expand.h"

/* --- products --- */

/* x'y in the inner product of M. */
static void products(const void *of, double *part, const double *x, int count, const double *y)
{
	const struct hawser__lexpand_work *w = of;
	size_t width = hawser__lexpand_width(w->rope);

	memset(part, 0, (size_t)count*sizeof *part);
	for (int i = 0; i < w->rope->systems; i++) {
		const struct hawser__lmode_system *system = &w->rope->system[i];

		hawser__lmode_inertia(w->load, y, system);
		for (int j = 0; j < count; j++)
			part[j] += hawser__lmode_product(w->load, x + (size_t)j*width, system);
		x += system->size;
		y += system->size;
	}
}

double hawser__lexpand_stiffness(const void *work, const double *x, const double *y)
{
	const struct hawser__lexpand_work *w = work;
	const double *strain = x, *other = y;
	double sum = 0.0;

	for (int i = 0; i < w->rope->systems; i++) {
		strain += w->rope->system[i].size;
		other += w->rope->system[i].size;
	}
	for (int i = 0; i < w->rope->systems; i++) {
		const struct hawser__lmode_system *system = &w->rope->system[i];

		sum += hawser__lmode_stiffness(x, strain, y, other, system);
		x += system->size;
		y += system->size;
		strain += system->strains;
		other += system->strains;
	}
	return sum;
}

/* row = P row. */
static void remove_kept(const struct hawser__lexpand_work *w, double *row)
{
	for (int k = 0; k < w->modes->search.n; k++) {
		const struct hawser__lexpand_shape *mode = &w->modes->shape[k];
		const struct hawser__lmode_system *system = &w->rope->system[mode->system];
		struct hawser__lexpand_part part = hawser__lexpand_part(w->rope, row, mode->system);
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
	const struct hawser__lexpand_work *w = of;

	(void)report; /* no memory is asked for */
	for (int i = 0; i < w->rope->systems; i++) {
		struct hawser__lmode_system *system = &w->rope->system[i];
		struct hawser__lexpand_part part = hawser__lexpand_part(w->rope, to, i);

		hawser__lmode_inertia(w->load, from, system);
		if (system->size > 0 && w->load[cblas_idamax(system->size, w->load, 1)] != 0.0) {
			hawser__lmode_static(part.x, part.strain, system, w->load);
		} else {
			memset(part.x, 0, (size_t)system->size*sizeof *part.x);
			memset(part.strain, 0, (size_t)system->strains*sizeof *part.strain);
		}
		from += system->size;
	}
	remove_kept(w, to);
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

static void hold(const struct hawser__lexpand_work *w, double *row,
                 const struct hawser__lexpand_force *force)
{
	for (int i = 0; i < w->rope->systems; i++) {
		struct hawser__lmode_system *system = &w->rope->system[i];
		struct hawser__lexpand_part part = hawser__lexpand_part(w->rope, row, i);

		memset(w->load, 0, (size_t)system->size*sizeof *w->load);
		for (int k = 0; system->plane == HAWSER_IN_PLANE && k < system->segments; k++)
			pull_segment(w->load + system->segment[k].at, w->rope, &system->segment[k], force);
		if (system->plane == HAWSER_IN_PLANE)
			hawser__lmode_static(part.x, part.strain, system, w->load);
	}
	remove_kept(w, row);
}

enum hawser_status hawser__lexpand_by(struct hawser__driven_by *by, struct hawser__lexpand_work *w,
                                      const struct hawser__lexpand_modes *t,
                                      struct hawser_report *report)
{
	size_t most = 1;

	for (int i = 0; i < t->rope.systems; i++)
		most = (size_t)t->rope.system[i].size > most ? (size_t)t->rope.system[i].size : most;
	*w = (struct hawser__lexpand_work){.rope = &t->rope, .modes = t,
	                                   .load = hawser__numbers(most, 1)};
	*by = (struct hawser__driven_by){.of = w, .width = hawser__lexpand_width(&t->rope),
	                                 .products = products, .follow = follow};
	return w->load ? HAWSER_OK : hawser__no_memory(report, "line rom");
}

enum hawser_status hawser__lexpand_answer(struct hawser__driven *answer, double *pull,
                                          const struct hawser__lexpand_modes *t,
                                          const struct hawser__lexpand_force *force,
                                          struct hawser_report *report)
{
	struct hawser__lexpand_work w;
	struct hawser__driven_by by;
	enum hawser_status status = hawser__lexpand_by(&by, &w, t, report);

	*answer = (struct hawser__driven){.known = 0};
	if (!status)
		status = hawser__driven_open(answer, by.width, report);
	if (!status && force->pull)
		hold(&w, answer->field, force);
	else if (!status)
		status = hawser__lexpand_drive(answer->field, pull, t, force, report);
	if (!status)
		status = hawser__driven_find(answer, &by, report);
	free(w.load);
	return status;
}
