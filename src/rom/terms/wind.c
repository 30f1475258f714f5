/* rom/terms/wind.c - the force of a wind on a moving cable, as terms of a model.
 *
 *   f_i      series of the force along e_i in the velocities v_1, v_2 to the third order
 *            (statics/wind.c)
 *   v_i      sum of u_k' w_ik (modes/complex/wind.c)
 *   T_jkl    - integral over the cable of sum_i w_ij times the symmetric tensor of the quadratic part
 *            of f_i, in which (v_1)^p (v_2)^q becomes the mean of the products w w over all orders of
 *            the indices; and T_jklm of the cubic part
 *
 * A term's value is that tensor times the number of different orders of its indices, k <= l <= m. The
 * linear part is D, and the constant one belongs to the statics. Motions of modes that are not kept are
 * left out.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>

#include "core/report.h"
#include "modes/complex/wind.h"
#include "rom/terms/wind.h"

/* Coordinates with terms: those of 60 are 2.4 million. */
enum { MOST = 60 };
/* Terms below this part of the largest of their order are zero but for round-off. */
static const double nothing = 1e-13;

/* The products of the motions of up to three coordinates at a point, in the order of
 * hawser__wind_power: only those of order `factors` are set. w [2][n]. */
static void products(double to[HAWSER__WIND_TERMS], const double *w, int n, const int *index,
                     int factors)
{
	for (int t = 0; t < HAWSER__WIND_TERMS; t++) {
		int along = hawser__wind_power[t][0], across = hawser__wind_power[t][1], ways = 0;

		to[t] = 0.0;
		if (along + across != factors)
			continue;
		for (int choice = 0; choice < 1 << factors; choice++) { /* bit c: factor c is across */
			double product = 1.0;
			int bits = 0;

			for (int c = 0; c < factors; c++) {
				int bit = choice >> c & 1;

				product *= w[bit*n + index[c]];
				bits += bit;
			}
			to[t] += bits == across ? product : 0.0;
			ways += bits == across;
		}
		to[t] /= ways;
	}
}

/* Different orders of ascending indices. */
static int orders(const int *index, int factors)
{
	int different = 1;

	for (int c = 1; c < factors; c++)
		different += index[c] > index[c - 1];
	return factors == 2 ? different : different == 3 ? 6 : different == 2 ? 3 : 1;
}

/* The next indices in lexicographic order, each at least the one before; 0: there are none. */
static int advance(int *index, int factors, int n)
{
	for (int c = factors - 1; c >= 0; c--)
		if (index[c] + 1 < n) {
			int next = index[c] + 1;

			for (; c < factors; c++)
				index[c] = next;
			return 1;
		}
	return 0;
}

/* value [n] of the terms with these velocities, of all equations. */
static void integrate(double *value, const struct hawser__flow_points *flow,
                      const double (*series)[2][HAWSER__WIND_TERMS], const int *index, int factors)
{
	int n = flow->n, count = orders(index, factors);

	for (int j = 0; j < n; j++)
		value[j] = 0.0;
	for (int i = 0; i < flow->points; i++) {
		const double *w = flow->shape + (size_t)2*i*n;
		double product[HAWSER__WIND_TERMS], f[2] = {0.0};

		products(product, w, n, index, factors);
		for (int t = 0; t < HAWSER__WIND_TERMS; t++)
			for (int c = 0; c < 2; c++)
				f[c] += series[i][c][t]*product[t];
		for (int j = 0; j < n; j++)
			value[j] -= flow->weight[i]*count*(w[j]*f[0] + w[n + j]*f[1]);
	}
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

/* The terms of second and third order, to a model that has none. */
static enum hawser_status add_terms(struct hawser_rom *rom, const struct hawser__flow_points *flow,
                                    struct hawser_report *report)
{
	int n = flow->n, pairs = n*(n + 1)/2, all = pairs + pairs*(n + 2)/3;
	double (*series)[2][HAWSER__WIND_TERMS], *value;

	if (n > MOST)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
		                    "wind.form: cubic is for models of at most %d coordinates, and this one "
		                    "has %d: give wind.form: exact, which hawser integrate takes, or keep "
		                    "fewer modes", MOST, n);
	series = calloc((size_t)flow->points, sizeof *series);
	value = calloc((size_t)n, sizeof *value);
	rom->term = calloc((size_t)n*(size_t)all + 1, sizeof *rom->term);
	if (series && value && rom->term)
		for (int i = 0; i < flow->points; i++)
			if (flow->speed[i] > 0.0) /* drag of air at rest has no series */
				hawser__section_series(series[i], flow->at[i], flow->speed[i]);
	for (int factors = 2; series && value && rom->term && factors < 4; factors++) {
		int index[3] = {0}, first = rom->terms;

		do {
			integrate(value, flow, (const double (*)[2][HAWSER__WIND_TERMS])series, index, factors);
			for (int j = 0; j < n; j++)
				rom->term[rom->terms++] = (struct hawser_term){
					.j = j, .factors = factors, .rates = factors,
					.factor = {index[0], index[1], factors > 2 ? index[2] : 0}, .value = value[j]};
		} while (advance(index, factors, n));
		prune(rom, first);
	}
	free(series);
	free(value);
	return series && value && rom->term ? HAWSER_OK : hawser__no_memory(report, "rom");
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
