/* bench/estimates-net.c - hawser statics of nets: the error of tensions by the mesh (estimates.h),
 * against a mesh of FINER times as many elements. Where a cable folds, tensions
 * are of first order, and by chance a coarse mesh may be closer than a fine one; the doubt about the
 * reference is twice its distance from a mesh of half its elements, and is no error of the coarse one.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "bench/estimates.h"
#include "tests/net-random.h"

enum { FINER = 16, FEWEST = 4, MOST = 24 };
/* Tensions are solved to this part of the loads. */
static const double round_off = 1e-10;

/* The largest difference of a tension at an end, or of the largest tension, over the scale that
 * hawser_net_mesh_error states its error by. */
static double difference(const struct hawser_net_statics *coarse, const struct hawser_net_statics *fine)
{
	double largest = 0.0, most = 0.0;

	for (int i = 0; i < coarse->cables; i++)
		largest = fmax(largest, coarse->member[i].T_max);
	for (int i = 0; i < fine->cables; i++) {
		const struct hawser_net_member *a = &coarse->member[i], *b = &fine->member[i];
		double off = fmax(fabs(a->T_max - b->T_max),
		                  fmax(fabs(a->T_from - b->T_from), fabs(a->T_to - b->T_to)));

		most = fmax(most, off/fmax(a->T_max, 0.01*largest));
	}
	return most;
}

int estimate_net(struct tally *tally, struct chance *chance)
{
	struct random_net r;
	struct hawser_net_statics coarse = {.nodes = 0}, fine = {.nodes = 0}, half = {.nodes = 0};
	struct hawser_net_mesh_error error;
	int elements = chance_int(chance, FEWEST, MOST), refused;

	random_net(&r, &chance->state, chance_unit(chance) < 0.7 ? HEAVY : SOME_LIGHT);
	if (chance_unit(chance) < 0.3)
		random_wind(&r, &chance->state);
	for (int i = 0; i < r.net.cables; i++)
		r.cable[i].elements = r.cable[i].rho > 0.0 ? elements : 1;
	refused = hawser_net_solve(&coarse, &r.net, NULL, NULL) ||
	          hawser_net_mesh_error(&error, &r.net, &coarse, NULL) || isnan(error.tension);
	for (int i = 0; i < r.net.cables; i++)
		r.cable[i].elements *= FINER/2;
	refused = refused || hawser_net_solve(&half, &r.net, NULL, NULL);
	for (int i = 0; i < r.net.cables; i++)
		r.cable[i].elements *= 2;
	refused = refused || hawser_net_solve(&fine, &r.net, NULL, NULL);
	if (!refused)
		tally_note(tally, fmax(difference(&coarse, &fine) - 2.0*difference(&half, &fine), 0.0),
		           error.tension + round_off, "%d cables of %d elements, %s",
		           r.net.cables, elements, error.exact ? "exact" : "by meshes");
	hawser_net_statics_clear(&half);
	hawser_net_statics_clear(&fine);
	hawser_net_statics_clear(&coarse);
	return refused;
}
