/* rom/condense/condense.c - static condensation in closed form.
 *
 *    a, b, c      derivative of a displacement in the local frame (e, n, z)
 *    eps          H/EA;  g static stretch |x'|;  k = sqrt(1+u^2)/g, the geometric stiffness
 *    alpha, beta, gamma   density of D^3V3[Phi_j, Phi_k, .] with respect to a, b, c:
 *                 alpha = (b_j b_k + c_j c_k)/(g^2 eps)
 *                 beta  = (a_j b_k + a_k b_j)/(g^2 eps),  gamma = (a_j c_k + a_k c_j)/(g^2 eps)
 *
 * w minimises the integral of a^2/(2 eps) + k (b^2 + c^2)/2 + alpha a + beta b + gamma c under the
 * only constraint on the strains, that the ends are fixed: it is the displacement that answers the
 * force -alpha, -beta, -gamma against the strains, without its part along the kept modes (follow.c).
 * This is exact up to quadrature, however stiff the cable is, while Galerkin's method would need a
 * converged basis. An absorber carries no static force, so that w has a stroke only in the part along
 * the kept modes.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "modes/grid.h"
#include "modes/pairing.h"
#include "rom/terms/absorbers.h"
#include "rom/condense/bend.h"
#include "rom/build/build.h"
#include "rom/condense/follow.h"
#include "rom/energy/project.h"
#include "rom/terms/ties.h"
#include "statics/frame.h"

struct hawser__place hawser__place_at(const struct hawser_modes *modes, double s, double weight)
{
	struct hawser_frame_point at = hawser_statics_frame(&modes->statics, s);
	double chord = hypot(1.0, modes->statics.hs), c = 1.0/chord, sine = modes->statics.hs/chord;
	double g = 1.0 + at.strain;
	struct hawser__place place = {.weight = weight, .eps = modes->statics.epsilon,
	                              .k = at.tension/g, .g2 = g*g};

	for (int k = 0; k < 3; k++) {
		place.axis[k][0] = at.axis[k][0]*c + at.axis[k][1]*sine;
		place.axis[k][1] = at.axis[k][1]*c - at.axis[k][0]*sine;
		place.axis[k][2] = at.axis[k][2];
	}
	return place;
}

/* p of the force of modes j and k: -alpha, -beta, -gamma. */
static void pull(struct hawser__stations *stations, int j, int k)
{
	const double *x = stations->slope + 3*(size_t)j*(size_t)stations->count;
	const double *y = stations->slope + 3*(size_t)k*(size_t)stations->count;
	double *p = stations->p;

	for (int i = 0; i < stations->count; i++, x += 3, y += 3, p += 3) {
		double scale = -1.0/(stations->place[i].g2*stations->place[i].eps);

		hawser__pair_force(p, x, y);
		for (int c = 0; c < 3; c++)
			p[c] *= scale;
	}
}

/* Strains, displacements at the springs and strokes, times the square roots of weight and stiffness;
 * their products are those of V2. */
static enum hawser_status set_pairing(struct hawser__condensed *condensed,
                                      const struct hawser__stations *work, const double *stretch,
                                      struct hawser_report *report)
{
	const struct hawser_statics *st = &work->modes->statics;
	int pairs = condensed->pairs, springs = hawser__ties_springs(work->ties);
	int points = condensed->points, absorbers = condensed->stroke ? st->attachments : 0;
	int width = 3*points + springs + absorbers + hawser__bend_width(work->bend);
	double *scaled = malloc((size_t)pairs*width*sizeof *scaled);

	if (!scaled)
		return hawser__no_memory(report, "rom");
	for (int x = 0; x < pairs; x++) {
		double *to = scaled + (size_t)x*width;

		for (int p = 0; p < condensed->points; p++, to += 3) {
			const struct hawser__place *at = &work->place[p];
			const double *strain = condensed->strain + ((size_t)x*condensed->points + p)*3;

			/* filled for each point */
			/* NOLINTNEXTLINE(clang-analyzer-core.UndefinedBinaryOperatorResult) */
			to[0] = sqrt(at->weight/at->eps)*strain[0];
			to[1] = sqrt(at->weight*at->k)*strain[1];
			to[2] = sqrt(at->weight*at->k)*strain[2];
		}
		for (int m = 0; m < springs; m++)
			to[m] = sqrt(work->ties->spring[m].k)*stretch[(size_t)x*springs + m];
		for (int i = 0; i < absorbers; i++)
			to[springs + i] = sqrt(hawser__absorber_stiffness(st, i))*
			                  condensed->stroke[(size_t)x*absorbers + i];
		if (work->bend)
			hawser__bend_rows(to + springs + absorbers, work->bend,
			                  condensed->strain + (size_t)x*points*3);
	}
	cblas_dsyrk(CblasRowMajor, CblasLower, CblasNoTrans, pairs, width, -1.0, scaled, width, 0.0,
	            condensed->pairing, pairs);
	free(scaled);
	return hawser__rom_pairing(condensed->pairing, work->modes, condensed->n, report);
}

/* The response to pair `pair`, which is in the stations. */
static void take(struct hawser__condensed *condensed, const struct hawser__stations *stations,
                 double *stretch, size_t pair)
{
	size_t row = 3*(size_t)condensed->points, springs = (size_t)hawser__ties_springs(stations->ties);
	size_t strokes = (size_t)stations->modes->statics.attachments;

	memcpy(condensed->strain + pair*row, stations->z, row*sizeof *stations->z);
	memcpy(condensed->start + 3*pair, stations->start, sizeof stations->start);
	memcpy(stretch + pair*springs, stations->stretch, springs*sizeof *stretch);
	if (condensed->stroke)
		memcpy(condensed->stroke + pair*strokes, stations->stroke, strokes*sizeof *stations->stroke);
}

enum hawser_status hawser__condense(struct hawser__condensed *condensed,
                                    const struct hawser_modes *modes, int moving,
                                    struct hawser_report *report)
{
	size_t pairs = (size_t)moving*((size_t)moving + 1)/2, points = (size_t)modes->grid.points, pair = 0;
	struct hawser__stations stations;
	enum hawser_status status = hawser__stations_make(&stations, modes, modes->n, NULL, 0, report);
	double *stretch = NULL;

	*condensed = (struct hawser__condensed){.n = moving, .points = (int)points, .pairs = (int)pairs};
	if (!status) {
		condensed->strain = malloc(3*pairs*points*sizeof *condensed->strain);
		condensed->start = malloc(3*pairs*sizeof *condensed->start);
		condensed->pairing = malloc(pairs*pairs*sizeof *condensed->pairing);
		if (modes->stroke)
			condensed->stroke = hawser__numbers(pairs, (size_t)modes->statics.attachments);
		stretch = hawser__numbers(pairs, (size_t)hawser__ties_springs(stations.ties));
		if (!condensed->strain || !condensed->start || !condensed->pairing || !stretch ||
		    (modes->stroke && !condensed->stroke))
			status = hawser__no_memory(report, "rom");
	}
	for (int k = 0; k < moving && !status; k++)
		for (int j = 0; j <= k; j++) {
			pull(&stations, j, k);
			hawser__follow(&stations);
			take(condensed, &stations, stretch, pair++);
		}
	if (!status)
		status = set_pairing(condensed, &stations, stretch, report);
	hawser__stations_clear(&stations);
	free(stretch);
	if (status)
		hawser__condensed_clear(condensed);
	return status;
}

void hawser__condensed_clear(struct hawser__condensed *condensed)
{
	free(condensed->strain);
	free(condensed->start);
	free(condensed->pairing);
	free(condensed->stroke);
	*condensed = (struct hawser__condensed){0};
}

void hawser__displacement(double *along, const struct hawser_grid *grid,
                          const struct hawser__reference *reference, const struct hawser_statics *st,
                          const double *strain, const double start[3], double *work)
{
	int points = grid->points;

	for (int p = 0; p < points; p++) {
		struct hawser_frame_point at = hawser_statics_frame(st, grid->s[p]);
		double v[3];

		hawser__frame_out(v, &at, strain + 3*p);
		for (int axis = 0; axis < 3; axis++)
			work[axis*points + p] = v[axis];
	}
	for (int axis = 0; axis < 3; axis++) {
		(void)hawser__grid_running(along + axis*points, grid, reference, work + axis*points);
		for (int p = 0; p < points; p++)
			along[axis*points + p] += start[axis];
	}
}

void hawser__displaced_at(double u[3], const struct hawser_rom *rom, const struct hawser_statics *st,
                          const struct hawser_grid *grid, const double *along, const double *stroke,
                          int p)
{
	struct hawser_frame_point at = hawser_statics_frame(st, rom->shapes.s[p]);
	int own = hawser__rom_stroke_point(st, p);
	double v[3];

	for (int axis = 0; axis < 3; axis++)
		if (own >= 0)
			v[axis] = stroke ? stroke[own]*st->attached[own].absorber_axis[axis] : 0.0;
		else
			hawser__grid_at(&v[axis], grid, along + axis*grid->points, 1, 1, rom->shapes.s[p]);
	if (st->space)
		memcpy(u, v, sizeof v); /* as in set_probe of build.c */
	else
		hawser__frame_in(u, &at, v);
}

enum hawser_status hawser__condensed_second(double *shape, double *slope, double *line,
                                            const struct hawser_rom *rom,
                                            const struct hawser__condensed *condensed,
                                            const struct hawser_modes *modes, int first, int pairs,
                                            struct hawser_report *report)
{
	const struct hawser_grid *grid = &modes->grid;
	const struct hawser_statics *st = &modes->statics;
	int points = rom->shapes.points, strokes = st->attachments;
	double *along = hawser__numbers(6, (size_t)grid->points);
	struct hawser__reference reference;
	enum hawser_status status = hawser__reference_init(&reference, grid, grid->order - 1, report);

	if (!status && !along)
		status = hawser__no_memory(report, "rom");
	for (int x = first; !status && x < first + pairs; x++) {
		const double *strain = condensed->strain + 3*(size_t)x*(size_t)grid->points;
		const double *stroke = condensed->stroke ? condensed->stroke + x*strokes : NULL;

		hawser__displacement(along, grid, &reference, st, strain, condensed->start + 3*x,
		                     along + 3*grid->points);
		for (int p = 0; p < points; p++, shape += 3, slope += 3) {
			hawser__displaced_at(shape, rom, st, grid, along, stroke, p);
			hawser__grid_at(slope, grid, strain, 3, 3, rom->shapes.s[p]);
		}
		for (int p = 0; p < rom->line.points; p++, line += 3)
			hawser__grid_at(line, grid, strain, 3, 3, rom->line.s[p]);
	}
	hawser__reference_clear(&reference);
	free(along);
	return status;
}
