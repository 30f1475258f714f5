/* rom/condense/basis.c - see basis.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "modes/label.h"
#include "rom/condense/basis.h"
#include "rom/terms/absorbers.h"
#include "statics/frame.h"

enum { EACH = 4 }; /* numbers of an absorber */

/* Where the numbers of absorbers begin. */
static int absorbers_of(const struct hawser__basis *m)
{
	return m->own + 3*hawser__points(&m->modes->statics);
}

static void set_roots(struct hawser__basis *m)
{
	const struct hawser_statics *st = &m->modes->statics;
	double *stiff = m->stiff + m->tail;

	for (int p = 0; p < m->own; p++) {
		const struct hawser__place *at = &m->stations.place[p/3];

		m->mass[p] = sqrt(at->weight);
		stiff[p] = sqrt(p%3 == 0 ? at->weight/at->eps : at->weight*at->k);
	}
	for (int i = 0; i < 3*hawser__points(st); i++) {
		int point = i/3, end = point - st->attachments;
		const double *k = end < 0 ? st->attached[point].spring : st->held[end].stiffness;

		m->mass[m->own + i] = sqrt(hawser__point_bare(st, point));
		m->stiff[i] = sqrt(isfinite(k[i%3]) ? k[i%3]*st->span.d/st->H : 0.0);
	}
	for (int i = 0; m->modes->stroke && i < st->attachments; i++) {
		int at = absorbers_of(m) + EACH*i;

		for (int c = 0; c < 3; c++)
			m->mass[at + c] = sqrt(hawser__point_absorber(st, i));
		m->stiff[at + 3 - m->own] = sqrt(hawser__absorber_stiffness(st, i));
	}
}

enum hawser_status hawser__basis_make(struct hawser__basis *m, const struct hawser_modes *modes,
                                        int most, struct hawser_report *report)
{
	enum hawser_status status;
	size_t width;

	*m = (struct hawser__basis){.modes = modes, .own = 3*modes->grid.points};
	m->tail = absorbers_of(m) - m->own + (modes->stroke ? EACH*modes->statics.attachments : 0);
	m->width = 2*m->own + m->tail;
	width = (size_t)m->width;
	m->row = hawser__hold(&m->hold, (size_t)most*width, sizeof *m->row);
	m->mass = hawser__hold(&m->hold, width, sizeof *m->mass);
	m->stiff = hawser__hold(&m->hold, width, sizeof *m->stiff);
	m->work = hawser__hold(&m->hold, width, sizeof *m->work);
	if (m->hold.short_of_memory)
		return hawser__no_memory(report, "rom");
	status = hawser__stations_make(&m->stations, modes, 0, NULL, 0, report);
	if (status)
		return status;
	set_roots(m);
	return hawser__reference_init(&m->reference, &modes->grid, modes->grid.order - 1, report);
}

void hawser__basis_clear(struct hawser__basis *m)
{
	hawser__reference_clear(&m->reference);
	hawser__stations_clear(&m->stations);
	hawser__hold_clear(&m->hold);
}

/* --- rows --- */

static void set_absorbers(const struct hawser__basis *m, double *row, const double *stroke)
{
	const struct hawser_statics *st = &m->modes->statics;

	for (int i = 0; m->modes->stroke && i < st->attachments; i++) {
		const double *u = row + m->own + 3*i, *a = st->attached[i].absorber_axis;
		double *to = row + absorbers_of(m) + EACH*i;

		for (int c = 0; c < 3; c++)
			to[c] = u[c] + stroke[i]*a[c];
		to[3] = stroke[i];
	}
}

void hawser__basis_put(struct hawser__basis *m, double *row, const double *strain,
                         const double start[3], const double *stroke)
{
	const struct hawser_grid *grid = &m->modes->grid;
	const struct hawser_statics *st = &m->modes->statics;
	int points = grid->points;
	double *along = m->work;

	hawser__displacement(along, grid, &m->reference, st, strain, start, along + m->own);
	for (int p = 0; p < points; p++) {
		struct hawser_frame_point at = hawser_statics_frame(st, grid->s[p]);
		const double v[3] = {along[p], along[points + p], along[2*points + p]};

		hawser__frame_in(row + 3*p, &at, v);
	}
	for (int i = 0; i < 3*hawser__points(st); i++)
		hawser__grid_at(row + m->own + i, grid, along + i%3*points, 1, 1, hawser__point(st, i/3).s);
	set_absorbers(m, row, stroke);
	memcpy(row + m->own + m->tail, strain, (size_t)m->own*sizeof *row);
}

void hawser__basis_mode(const struct hawser__basis *m, double *row,
                          const struct hawser_modes *of, int k)
{
	for (int p = 0; p < m->own; p += 3)
		hawser_modes_at(of, row + p, row + m->own + m->tail + p, k, m->modes->grid.s[p/3]);
	for (int i = 0; i < hawser__points(&of->statics); i++)
		hawser__modes_attached(row + m->own + 3*i, of, k, i);
	set_absorbers(m, row, of->stroke ? of->stroke + k*of->statics.attachments : NULL);
}

void hawser__basis_take(struct hawser_modes *with, int k, const struct hawser__basis *m,
                          const double *row, double omega)
{
	size_t own = (size_t)m->own;
	struct hawser_mode *mode = &with->mode[k];

	memcpy(with->shape + (size_t)k*own, row, own*sizeof *row);
	memcpy(with->slope + (size_t)k*own, row + m->own + m->tail, own*sizeof *row);
	for (int i = 0; with->stroke && i < with->statics.attachments; i++)
		with->stroke[k*with->statics.attachments + i] = row[absorbers_of(m) + EACH*i + 3];
	mode->omega = omega;
	mode->place = k + 1;
	(void)hawser__mode_label(with, k);
	mode->plane = mode->out_of_plane_share > 0.5 ? HAWSER_OUT_OF_PLANE : HAWSER_IN_PLANE;
}

/* --- products --- */

double hawser__basis_product(const struct hawser__basis *m, const double *x, const double *y)
{
	double sum = 0.0;

	for (int p = 0; p < m->own + m->tail; p++)
		sum += m->mass[p]*m->mass[p]*x[p]*y[p];
	return sum;
}

enum hawser_status hawser__basis_products(double *mass, double *stiffness,
                                            const struct hawser__basis *m, int count,
                                            struct hawser_report *report)
{
	int used = m->own + m->tail, bent = hawser__bend_width(m->stations.bend);
	double *scaled = hawser__numbers((size_t)count, (size_t)(used > bent ? used : bent));

	if (!scaled)
		return hawser__no_memory(report, "rom");
	for (int part = 0; part < 2; part++) {
		const double *root = part ? m->stiff : m->mass;

		for (int i = 0; i < count*used; i++)
			scaled[i] = root[i%used]*m->row[i/used*m->width + part*m->own + i%used];
		cblas_dsyrk(CblasRowMajor, CblasLower, CblasNoTrans, count, used, 1.0, scaled, used, 0.0,
		            part ? stiffness : mass, count);
	}
	hawser__bend_gram(stiffness, m->stations.bend, scaled, m->row + used, m->width, count);
	free(scaled);
	return HAWSER_OK;
}
