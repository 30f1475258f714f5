/* rom/condense/follow.c - static displacement of condensed modes by a force: see follow.h.
 *
 *   e, n         tangent and normal; eps, k, g of struct hawser__place
 *   lambda       change of the end force
 *
 * V2 has no derivatives of the strains, so the strains z follow from the force point by point, with
 * lambda from the condition that the ends stay fixed:
 *
 *     a = eps (p_a - lambda.e)      b = (p_b - lambda.n)/k      c = (p_c - lambda_z)/k
 *
 * (with springs and bending stiffness as in ties.c), minus the part along the kept modes, Phi_s times
 * the work of p on it over omega_s^2.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/order.h"
#include "core/report.h"
#include "core/vec3.h"
#include "modes/bending/bending.h"
#include "modes/grid.h"
#include "modes/label.h"
#include "rom/terms/absorbers.h"
#include "rom/condense/follow.h"

/* Largest entry, relative to the sum of the magnitudes of its terms, that counts as zero by
 * symmetry. */
#define ROUND_OFF 1e-11

/* --- nodes --- */

static void add_node(struct hawser__stations *to, double s, double weight)
{
	to->s[to->count] = s;
	to->place[to->count++] = hawser__place_at(to->modes, s, weight);
}

/* Nodes of a part of element e. */
static void add_part(struct hawser__stations *stations, int e, double from, double to)
{
	const struct hawser_grid *grid = &stations->modes->grid;
	double shrink = (to - from)/(grid->edge[e + 1] - grid->edge[e]);
	int whole = from == grid->edge[e] && to == grid->edge[e + 1];

	for (int k = 0; k < grid->order; k++) {
		int p = e*grid->order + k;

		if (whole)
			add_node(stations, grid->s[p], grid->weight[p]);
		else
			add_node(stations, from + 0.5*(to - from)*(1.0 + grid->node[k]),
			         shrink*grid->weight[p]);
	}
	stations->edge[++stations->parts] = to;
}

/* slope [3] = those of a mode, at the points with these weights. */
static void combine(double *slope, const double *of, const double *weight, int order)
{
	double a = 0.0, b = 0.0, c = 0.0; /* no array, which would be in memory */

	for (int k = 0; k < order; k++, of += 3) {
		a += weight[k]*of[0];
		b += weight[k]*of[1];
		c += weight[k]*of[2];
	}
	slope[0] = a;
	slope[1] = b;
	slope[2] = c;
}

/* weight [order] is scratch. */
static void set_slopes(struct hawser__stations *to, double *weight)
{
	const struct hawser_grid *grid = &to->modes->grid;
	size_t points = (size_t)grid->points, count = (size_t)to->count;

	for (size_t i = 0, p = 0; i < count; i++) {
		size_t first;
		int is_point;

		/* NOLINTNEXTLINE(clang-analyzer-core.UndefinedBinaryOperatorResult): count are set */
		while (p < points && grid->s[p] < to->s[i])
			p++;
		is_point = p < points && grid->s[p] == to->s[i];
		/* NOLINTNEXTLINE(clang-analyzer-core.CallAndMessage): the same */
		first = is_point ? p : (size_t)(hawser__grid_weights(weight, grid, to->s[i])*grid->order);
		for (size_t j = 0; j < (size_t)to->moving; j++) {
			double *slope = to->slope + (j*count + i)*3;
			const double *of = to->modes->slope + (j*points + first)*3;

			if (is_point)
				memcpy(slope, of, 3*sizeof *slope);
			else
				combine(slope, of, weight, grid->order);
		}
	}
}

static enum hawser_status set_ties(struct hawser__stations *stations, struct hawser_report *report)
{
	enum hawser_status status = hawser__bend_make(&stations->bend, &stations->modes->statics,
	                                              stations->edge, stations->parts,
	                                              stations->modes->grid.order, stations->place, report);

	return status ? status : hawser__ties_make(&stations->ties, stations->modes, stations->bend,
	                                           stations->place, stations->s, stations->count, report);
}

/* Add to all [*count] what divides the cable beside a cut, where a force that jumps there makes a
 * boundary layer, unless an edge is near. */
static void divide_layers(double *all, int *count, const struct hawser_modes *modes, double cut)
{
	const struct hawser_grid *grid = &modes->grid;
	double wide = hawser__layer_at(&modes->statics, cut)*0.4*grid->order;

	for (int side = -1; side <= 1; side++) {
		double at = cut + side*wide;
		int good = at > 0.0 && at < modes->statics.l;

		for (int e = 0; e <= grid->elements && side != 0; e++)
			good &= fabs(grid->edge[e] - at) > 0.1*wide;
		if (good || side == 0)
			all[(*count)++] = at;
	}
}

static enum hawser_status make(struct hawser__stations *stations, const struct hawser_modes *modes,
                               int moving, const double *cut, int cuts,
                               struct hawser_report *report)
{
	const struct hawser_grid *grid = &modes->grid;
	size_t parts = (size_t)grid->elements + (size_t)cuts, most = parts*(size_t)grid->order;
	int next = 0;

	*stations = (struct hawser__stations){.modes = modes, .moving = moving};
	stations->edge = hawser__hold(&stations->hold, parts + 1, sizeof *stations->edge);
	stations->s = hawser__hold(&stations->hold, most, sizeof *stations->s);
	stations->place = hawser__hold(&stations->hold, most, sizeof *stations->place);
	stations->slope = hawser__hold(&stations->hold, 3*most*(size_t)moving + 1, sizeof *stations->slope);
	stations->p = hawser__hold(&stations->hold, 3*most, sizeof *stations->p);
	stations->z = hawser__hold(&stations->hold, 3*most, sizeof *stations->z);
	if (stations->hold.short_of_memory)
		return hawser__no_memory(report, "rom");
	stations->edge[0] = grid->edge[0];
	for (int e = 0; e < grid->elements; e++) {
		double from = grid->edge[e];

		for (; next < cuts && cut[next] < grid->edge[e + 1]; next++)
			if (cut[next] > from) {
				add_part(stations, e, from, cut[next]);
				from = cut[next];
			}
		add_part(stations, e, from, grid->edge[e + 1]);
	}
	set_slopes(stations, stations->z); /* z is not yet used */
	return set_ties(stations, report);
}

enum hawser_status hawser__stations_make(struct hawser__stations *stations,
                                         const struct hawser_modes *modes, int moving,
                                         const double *cut, int cuts, struct hawser_report *report)
{
	double *all;
	int count = 0;
	enum hawser_status status;

	if (!(modes->statics.bending.EI > 0.0) || cuts == 0)
		return make(stations, modes, moving, cut, cuts, report);
	*stations = (struct hawser__stations){.modes = modes};
	all = malloc(3*(size_t)cuts*sizeof *all);
	if (!all)
		return hawser__no_memory(report, "rom");
	for (int i = 0; i < cuts; i++)
		divide_layers(all, &count, modes, cut[i]);
	qsort(all, (size_t)count, sizeof *all, hawser__ascending);
	status = make(stations, modes, moving, all, count, report);
	free(all);
	return status;
}

void hawser__stations_clear(struct hawser__stations *stations)
{
	hawser__hold_clear(&stations->hold);
	hawser__ties_free(stations->ties);
	hawser__bend_free(stations->bend);
	*stations = (struct hawser__stations){.count = 0};
}

/* --- displacement --- */

/* Work of p on the strains. */
static double work_on(const struct hawser__stations *stations, const double *strain)
{
	double sum = 0.0;

	for (int i = 0; i < stations->count; i++) {
		const double *p = stations->p + 3*i, *x = strain + 3*i;

		sum += stations->place[i].weight*(p[0]*x[0] + p[1]*x[1] + p[2]*x[2]);
	}
	return sum;
}

/* Take mode s out of the response. */
static void remove_mode(struct hawser__stations *stations, int s)
{
	const struct hawser_modes *modes = stations->modes;
	const struct hawser__ties *ties = stations->ties;
	int width = 3*stations->count;
	const double *slope = stations->slope + (size_t)s*(size_t)width;
	double omega = modes->mode[s].omega, part = work_on(stations, slope), u[3];

	if (modes->statics.elastic) {
		hawser__modes_attached(u, modes, s, modes->statics.attachments + 1);
		part += hawser__dot(stations->beyond, u);
	}
	for (int i = 0; modes->stroke && i < modes->statics.attachments; i++)
		part += stations->load[i]*hawser__stroke(modes, s, i);
	part /= omega*omega;
	for (int i = 0; modes->stroke && i < modes->statics.attachments; i++)
		stations->stroke[i] -= part*hawser__stroke(modes, s, i);
	for (int m = 0; m < hawser__ties_springs(ties); m++) {
		hawser__modes_attached(u, modes, s, ties->spring[m].attachment);
		stations->stretch[m] -= part*hawser__dot(u, ties->spring[m].way);
	}
	cblas_daxpy(width, -part, slope, 1, stations->z, 1);
}

void hawser__follow(struct hawser__stations *stations)
{
	const struct hawser_modes *modes = stations->modes;
	struct hawser__ties *ties = stations->ties;

	memcpy(stations->z, stations->p, 3*(size_t)stations->count*sizeof *stations->z);
	memcpy(ties->beyond, stations->beyond, sizeof ties->beyond);
	hawser__ties_answer(ties, stations->z);
	for (int m = 0; m < hawser__ties_springs(ties); m++)
		stations->stretch[m] = hawser__ties_stretch(ties, m);
	/* a spring to a free mass carries no static force of the cable, only that on the stroke itself */
	for (int i = 0; modes->stroke && i < modes->statics.attachments; i++)
		stations->stroke[i] = stations->load[i] != 0.0
			? stations->load[i]/hawser__absorber_stiffness(&modes->statics, i) : 0.0;
	for (int s = 0; s < stations->moving; s++)
		remove_mode(stations, s);
	hawser__ties_start(stations->start, ties, stations->stretch);
}

/* T_jk; *size: the sum of the absolute values of its terms. */
static double stiffness(double *size, const struct hawser__stations *stations, int j, int k)
{
	const double *x = stations->slope + (size_t)j*3*(size_t)stations->count;
	const double *y = stations->slope + (size_t)k*3*(size_t)stations->count;
	const double *z = stations->z;
	double sum = 0.0;

	*size = 0.0;
	for (int i = 0; i < stations->count; i++, x += 3, y += 3, z += 3) {
		const struct hawser__place *at = &stations->place[i];
		double scale = at->weight/(at->g2*at->eps), term[5];

		term[0] = scale*z[0]*(x[1]*y[1] + x[2]*y[2]);
		term[1] = scale*x[0]*y[1]*z[1];
		term[2] = scale*x[0]*y[2]*z[2];
		term[3] = scale*y[0]*x[1]*z[1];
		term[4] = scale*y[0]*x[2]*z[2];
		for (int t = 0; t < 5; t++) {
			sum += term[t];
			*size += fabs(term[t]);
		}
	}
	return sum;
}

int hawser__follow_stiffness(double *T, const struct hawser__stations *stations)
{
	size_t n = (size_t)stations->modes->n;
	int any = 0;

	memset(T, 0, n*n*sizeof *T);
	for (int k = 0; k < stations->moving; k++)
		for (int j = 0; j <= k; j++) {
			double size, value = stiffness(&size, stations, j, k);

			if (fabs(value) <= ROUND_OFF*size)
				value = 0.0;
			T[j*(int)n + k] = T[k*(int)n + j] = value;
			any |= value != 0.0;
		}
	return any;
}
