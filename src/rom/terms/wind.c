/* rom/terms/wind.c - the force of a wind on a moving cable, as terms of a model.
 *
 *   f_i      series of the force along e_i in the velocities v_1, v_2 to the third order
 *            (statics/wind.c)
 *   v_i      sum of u_k' w_ik (modes/complex/wind.c)
 *   T_jkl    - integral over the cable of sum_i w_ij times the symmetric tensor of the quadratic part
 *            of f_i along the motions k and l; and T_jklm of the cubic part
 *   form     that tensor [2][2] or [2][2][2] by directions, which is contracted index by index
 *
 * A term's value is T times the number of different orders of its indices, k <= l <= m. The
 * linear part is D, and the constant one belongs to the statics. Motions of modes that are not kept are
 * left out.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <math.h>
#include <stdlib.h>

#include "core/hold.h"
#include "core/report.h"
#include "modes/complex/wind.h"
#include "rom/terms/wind.h"

/* Coordinates with terms: those of 60 are 2.4 million. */
enum { MOST = 60 };
/* Terms below this part of the largest of their order are zero but for round-off. */
static const double nothing = 1e-13;

/* Different orders of ascending indices. */
static int orders(const int *index, int factors)
{
	int different = 1;

	for (int c = 1; c < factors; c++)
		different += index[c] > index[c - 1];
	return factors == 2 ? different : different == 3 ? 6 : different == 2 ? 3 : 1;
}

/* form [2][2][2] (2: [2][2]) of f_i: the parts of order `factors` of the series, each divided among the
 * places with as many directions across. */
static void set_form(double *form, const double *series, int factors)
{
	static const double ways[2][4] = {{1.0, 2.0, 1.0}, {1.0, 3.0, 3.0, 1.0}};

	for (int place = 0; place < 1 << factors; place++) {
		int across = hawser__wind_across(place);

		form[place] = series[hawser__wind_term(factors, across)]/ways[factors - 2][across];
	}
}

/* to [size] = form [2][size] along a motion. */
static void contract(double *to, const double *form, double along, double across, int size)
{
	for (int i = 0; i < size; i++)
		to[i] = along*form[i] + across*form[size + i];
}

/* f [products]: weight f_i of all ascending indices at a point, in lexicographic order, times their
 * orders. w [2][n]. */
static void expand_at(double *f, const double *series, double weight, const double *w, int n,
                      int factors)
{
	double form[8], by_one[4], by_two[2];
	int size = 1 << (factors - 1);

	set_form(form, series, factors);
	for (int k = 0; k < n; k++) {
		contract(by_one, form, w[k], w[n + k], size);
		for (int l = k; l < n; l++) {
			if (factors == 2) {
				*f++ = weight*orders((int[]){k, l}, 2)*(w[l]*by_one[0] + w[n + l]*by_one[1]);
				continue;
			}
			contract(by_two, by_one, w[l], w[n + l], 2);
			for (int m = l; m < n; m++)
				*f++ = weight*orders((int[]){k, l, m}, 3)*(w[m]*by_two[0] + w[n + m]*by_two[1]);
		}
	}
}

/* The next indices in lexicographic order, each at least the one before. */
static void advance(int *index, int factors, int n)
{
	int c = factors - 1;

	while (c > 0 && index[c] + 1 == n)
		c--;
	for (int next = index[c] + 1; c < factors; c++)
		index[c] = next;
}

/* Remove the terms from `first` on that are zero but for round-off. */
static void prune(struct hawser_rom *rom, int first)
{
	double most = 0.0;
	int kept = first;

	for (int i = first; i < rom->terms; i++)
		most = fmax(most, fabs(rom->term[i].value));
	for (int i = first; i < rom->terms; i++)
		if (fabs(rom->term[i].value) > nothing*most)
			rom->term[kept++] = rom->term[i];
	rom->terms = kept;
}

/* value [products][n]: - the integral of the force of these products on each coordinate; f [2 points]
 * [products] is for work. */
static void integrate(double *value, double *f, const struct hawser__flow_points *flow,
                      const double (*series)[HAWSER__WIND_TERMS], int factors, int products)
{
	int n = flow->n;

	for (int i = 0; i < 2*flow->points; i++)
		expand_at(f + (size_t)i*products, series[i], flow->weight[i/2],
		          flow->shape + (size_t)2*(i/2)*n, n, factors);
	cblas_dgemm(CblasRowMajor, CblasTrans, CblasNoTrans, products, n, 2*flow->points, -1.0, f,
	            products, flow->shape, n, 0.0, value, n);
}

/* The terms of second and third order, to a model that has none. */
static enum hawser_status add_terms(struct hawser_rom *rom, const struct hawser__flow_points *flow,
                                    struct hawser_report *report)
{
	int n = flow->n, pairs = n*(n + 1)/2, most = pairs*(n + 2)/3;
	double *value, *f, (*series)[HAWSER__WIND_TERMS];

	if (n > MOST)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
		                    "wind.form: cubic is for models of at most %d coordinates, and this one "
		                    "has %d: give wind.form: exact, which hawser integrate and frf take, "
		                    "or keep fewer modes", MOST, n);
	value = hawser__numbers((size_t)most, (size_t)n);
	f = hawser__numbers((size_t)most, 2*(size_t)flow->points);
	series = calloc(2*(size_t)flow->points, sizeof *series);
	for (int i = 0; series && i < flow->points; i++)
		if (flow->speed[i] > 0.0) /* drag of air at rest has no series */
			hawser__section_series(series + 2*i, flow->at[i], flow->speed[i]);
	rom->term = calloc((size_t)n*((size_t)pairs + (size_t)most) + 1, sizeof *rom->term);
	for (int factors = 2; value && f && series && rom->term && factors < 4; factors++) {
		int index[3] = {0}, first = rom->terms, products = factors == 2 ? pairs : most;

		integrate(value, f, flow, (const double (*)[HAWSER__WIND_TERMS])series, factors, products);
		for (int p = 0; p < products; p++, advance(index, factors, n))
			for (int j = 0; j < n; j++)
				rom->term[rom->terms++] = (struct hawser_term){
					.j = j, .factors = factors, .rates = factors,
					.factor = {index[0], index[1], factors > 2 ? index[2] : 0},
					.value = value[p*n + j]};
		prune(rom, first);
	}
	free(series);
	free(f);
	free(value);
	return value && f && series && rom->term ? HAWSER_OK : hawser__no_memory(report, "rom");
}

enum hawser_status hawser__wind_take(struct hawser_rom *rom, struct hawser__flow_points *flow,
                                     int whole, struct hawser_report *report)
{
	enum hawser_status status;

	hawser__flow_damping(rom->D, flow);
	status = whole ? add_terms(rom, flow, report) : HAWSER_OK;
	hawser__flow_points_clear(flow);
	return status;
}

enum hawser_status hawser__wind_add(struct hawser_rom *rom, const struct hawser_modes *modes,
                                    const struct hawser_scene *scene, int whole,
                                    struct hawser_report *report)
{
	struct hawser__flow_points flow;

	if (!scene || !scene->wind.present || (whole && scene->wind.form == HAWSER_WIND_EXACT))
		return HAWSER_OK;
	if (!whole && scene->wind.wake.present)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
		                    "linear questions do not take the wakes of wind.wake, whose motion is not "
		                    "small: remove it, or integrate");
	if (hawser__flow_points(&flow, modes, scene))
		return hawser__wind_take(rom, &flow, whole, report);
	hawser__flow_points_clear(&flow);
	return hawser__no_memory(report, "rom");
}
