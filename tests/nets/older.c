/* tests/nets/older.c - the methods that the library does not have, as rows of a table, and where they
 * begin.
 *
 * What a user without any idea of the shape would give, and what B begins with, are straight cables.
 * Some noise is added, since straight cables have no stiffness across.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "core/random.h"
#include "tests/nets/comparison.h"

static const struct hawser__net_method methods[] = {
	{{"mixed", "Newton's method for positions and forces, for nets without slack members",
	  "this program"}, net_mixed, 0},
	{{"two-sided", "Newton's method with the law of bars: elements may be compressed",
	  "B (3.17), (3.21)"}, net_two_sided, 0},
	{{"regularised", "Newton's method, compressed elements without force and with a stiffness",
	  "B (3.25), (3.26)"}, net_regularised, 0},
	{{"descent", "Newton's method with the true tangent, made definite, and steps that lower the "
	  "energy", "B (3.25)"}, net_descent, 0},
	{{"relaxation", "dynamic relaxation with kinetic damping: explicit steps, no matrix",
	  "B 3.2.4"}, net_relaxation, 0},
};

const struct hawser__net_method *net_older(int index)
{
	return index >= 0 && (size_t)index < sizeof methods/sizeof *methods ? &methods[index] : NULL;
}

const struct hawser__net_method *net_method(const char *name)
{
	for (int i = 0; net_older(i); i++)
		if (!strcmp(net_older(i)->shown.name, name))
			return net_older(i);
	for (int i = 0; hawser__net_method(i); i++)
		if (!strcmp(hawser__net_method(i)->shown.name, name))
			return hawser__net_method(i);
	return NULL;
}

static struct {
	int chord;
	double noise;
	uint64_t seed;
} begin;

void net_start_at(int chord, double noise, unsigned seed)
{
	begin.chord = chord;
	begin.noise = noise;
	begin.seed = seed;
}

static void straighten(struct hawser__mesh *mesh)
{
	uint64_t state = begin.seed;

	for (int c = 0; c < mesh->cables; c++) {
		int first = mesh->first[c], n = mesh->first[c + 1] - first;
		const double *a = mesh->q[mesh->end[first][0]], *b = mesh->q[mesh->end[first + n - 1][1]];
		double size = begin.noise*sqrt((a[0] - b[0])*(a[0] - b[0]) + (a[1] - b[1])*(a[1] - b[1]) +
		                               (a[2] - b[2])*(a[2] - b[2]));

		for (int i = 1; i < n; i++)
			for (int k = 0; k < 3; k++)
				mesh->q[mesh->inner[c] + i - 1][k] = a[k] + (b[k] - a[k])*i/n +
				                                     size*(2.0*hawser__random(&state) - 1.0);
	}
}

void net_start(struct hawser__net_work *work)
{
	struct hawser__mesh *mesh = work->mesh;

	if (begin.chord)
		straighten(mesh);
	memcpy(work->start, mesh->q, (size_t)mesh->nodes*sizeof *mesh->q);
}
