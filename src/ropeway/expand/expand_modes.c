/* ropeway/expand/expand_modes.c - modes as the shapes of an expansion, on grids that resolve
 * products of four of them. SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "ropeway/expand/expand.h"

/* Gauss quadrature with the nodes of a grid for twice the frequency integrates products of four
 * waves. */
static const double wider = 2.0;
/* Strain of hangers under the weight: of a shape its difference keeps ten digits, and 1e-6 is what it
 * changes of a frequency at most. */
static const double soft = 1e-6;

/* Of a state and the shape that was made of it, whose sign may have been changed
 * (modes_label.c). */
static double sign_of(const double *x, const struct hawser__lmode_system *system,
                      const struct hawser_line_modes *modes, int k)
{
	double sum = 0.0;

	for (int i = 0; i < system->segments; i++) {
		const struct hawser__lmode_segment *s = &system->segment[i];
		const double *u = modes->shape + 3*((size_t)k*(size_t)modes->points +
		                                    (size_t)modes->piece[s->index].first);
		const double *v = x + s->at;
		int points = s->grid.points;

		for (int p = 0; p < points; p++, u += 3) {
			if (s->D == 2)
				sum += u[0]*(s->cosine[p]*v[p] + s->sine[p]*v[points + p]) +
				       u[1]*(s->cosine[p]*v[points + p] - s->sine[p]*v[p]);
			else
				sum += v[p]*(s->sb ? u[2] : u[0]);
		}
	}
	return sum < 0.0 ? -1.0 : 1.0;
}

/* Largest speed of waves across the rope. */
static double fastest(const struct hawser__lmode *rope)
{
	double most = 0.0;

	for (int i = 0; i < rope->systems; i++)
		for (int k = 0; k < rope->system[i].segments; k++) {
			const struct hawser__lmode_segment *s = &rope->system[i].segment[k];

			if (!s->arc && s->piece->length > 0.0)
				most = fmax(most, s->piece->length/hawser__lmode_phase(s, rope));
		}
	return most;
}

enum hawser_status hawser__lexpand_modes_open(struct hawser__lexpand_modes *t,
                                              struct hawser_line_modes *modes,
                                              const struct hawser_line_statics *const *lane, int lanes,
                                              const struct hawser_line_modes_options *options,
                                              double wave,
                                              struct hawser_report *report)
{
	struct hawser_line_modes_options o = *options;
	enum hawser_status status;
	double omega;

	*t = (struct hawser__lexpand_modes){.shape = NULL};
	*modes = (struct hawser_line_modes){.n = 0};
	status = hawser__lmode_settle(&o, lane, lanes, report);
	if (!status)
		status = hawser__lmode_open(&t->rope, lane, lanes, &o, soft, report);
	if (!status)
		status = hawser__lmode_search_open(&t->search, &t->rope, o.n, report);
	if (status)
		return status;
	t->shape = calloc((size_t)o.n + HAWSER__LEXPAND_MORE, sizeof *t->shape);
	if (!t->shape)
		return hawser__no_memory(report, "line rom");
	status = hawser__lmode_find(&t->search, report);
	if (!status)
		status = hawser__lmode_refine_all(&omega, &t->search, wider,
		                                  wave*t->rope.length*fastest(&t->rope), report);
	if (!status && hawser__lmode_worst(&t->search) > o.tolerance)
		status = hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, "line rom", 0,
		                         hawser__lmode_worst(&t->search), "the first %d frequencies have an "
		                         "estimated relative error of %.1e where %.1e was asked: ask for fewer "
		                         "modes, or for a larger tolerance", o.n,
		                         hawser__lmode_worst(&t->search), o.tolerance);
	if (!status)
		status = hawser__lmode_fill(modes, &t->search, omega, report);
	for (int k = 0; k < o.n && !status; k++) {
		const struct hawser__lmode_choice *choice = &t->search.choice[k];
		const struct hawser__lmode_pairs *pairs = &t->search.pairs[choice->system];
		const struct hawser__lmode_system *system = &t->rope.system[choice->system];
		double *x = pairs->x + (size_t)choice->pair*(size_t)system->size;
		double *strain = pairs->strain + (size_t)choice->pair*(size_t)system->strains;
		double sign = sign_of(x, system, modes, k);

		cblas_dscal(system->size, sign, x, 1);
		cblas_dscal(system->strains, sign, strain, 1);
		t->shape[k] = (struct hawser__lexpand_shape){.system = choice->system, .x = x,
			.strain = strain, .omega = pairs->omega[choice->pair]};
	}
	return status;
}

/* Rows kept[count] of an array of rows of `row` bytes. */
static void keep_rows(void *array, size_t row, const int *kept, int count)
{
	char *to = array;

	for (int i = 0; i < count && row > 0; i++)
		memmove(to + (size_t)i*row, to + (size_t)kept[i]*row, row);
}

void hawser__lexpand_modes_keep(struct hawser__lexpand_modes *t, struct hawser_line_modes *modes,
                                const int *kept, int count)
{
	const size_t field = 3*sizeof(double);

	keep_rows(t->shape, sizeof *t->shape, kept, count);
	keep_rows(t->search.choice, sizeof *t->search.choice, kept, count);
	keep_rows(modes->mode, sizeof *modes->mode, kept, count);
	keep_rows(modes->shape, (size_t)modes->points*field, kept, count);
	keep_rows(modes->slope, (size_t)modes->points*field, kept, count);
	keep_rows(modes->share, (size_t)modes->spans*sizeof(double), kept, count);
	keep_rows(modes->mass_at, (size_t)modes->masses*field, kept, count);
	keep_rows(modes->freedom_at, (size_t)modes->freedoms*sizeof(double), kept, count);
	modes->n = t->search.n = count;
}

void hawser__lexpand_modes_clear(struct hawser__lexpand_modes *t)
{
	hawser__lmode_search_clear(&t->search);
	free(t->shape);
	hawser__lmode_clear(&t->rope);
	*t = (struct hawser__lexpand_modes){.shape = NULL};
}
