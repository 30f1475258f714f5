/* response/locus/folds_image.c - folds of motions that are nearly mirror images of others.
 *
 * A cable that swings out of its plane may do so in two ways that are reflections of each other, half
 * a period apart. A small load in the plane makes them different motions, each with its own fold
 * curves, as near to each other as that load is small; a response leads to one of them. Reflections
 * u_j -> s_j u_j are those under which the model without its load stays the same (signs.h). An image,
 * shifted by half a period or not, is one of the load too as far as the load fits:
 *
 *     sum (s_j (-1)^k f_jk - f_jk)^2 < (UNLIKE)^2 sum f_jk^2        shifted; without (-1)^k if not
 *
 * If the sum is zero, the image has the same Omega and load, and is no curve of its own.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "response/branch/signs.h"
#include "response/locus/folds_search.h"

#define UNLIKE 0.5 /* chosen */
#define NEAR 1e-2  /* relative difference of Omega within which an image is looked for; chosen */

/* Relative size of what does not fit of the load after a reflection, shifted by half a period or not;
 * 0: all fits. */
static double misfit(const struct hawser_rom *rom, const int *sign, int shifted)
{
	double gap = 0.0, sum = 0.0;

	for (int h = 0; h < rom->harmonics; h++)
		for (int j = 0; rom->harmonic[h].f && j < rom->n; j++) {
			double f = rom->harmonic[h].f[j];
			int same = sign[j]*(shifted && rom->harmonic[h].k % 2 ? -1 : 1);

			gap += pow((same - 1)*f, 2);
			sum += f*f;
		}
	return sum > 0.0 ? sqrt(gap/sum) : 0.0;
}

/* z, an orbit by harmonic balance, becomes its image. */
static void reflect(const struct hawser__orbit *orbit, double *z, const int *sign, int shifted)
{
	int n = orbit->n;

	for (int i = 0; i < orbit->size - 1; i++)
		z[i] *= sign[i % n]*(shifted && (i/n + 1)/2 % 2 ? -1 : 1);
}

/* The curve through the image of the fold z, if it has one. */
static enum hawser_status image(struct hawser__fold_search *search, double *z, const int *sign,
                                int shifted)
{
	const struct hawser__orbit *orbit = hawser__fold_orbit(&search->fold);
	int size = search->fold.size, failed;
	double omega = z[size - 2];
	enum hawser_status status;

	reflect(orbit, z, sign, shifted);
	status = hawser__walk_begin_orbit(&search->walk, z, z[size - 1], &failed);
	reflect(orbit, z, sign, shifted);
	if (status == HAWSER_ERR_CONVERGENCE)
		return HAWSER_OK;
	failed |= status || fabs(search->walk.start.z[size - 2] - omega) > NEAR*omega;
	return failed ? status : hawser__fold_new(search);
}

/* Whether the reflection was among the first `count`, or reflects nothing. */
static int is_old(const int *flip, int count, int n)
{
	const int *last = flip + (size_t)count*(size_t)n;
	int moved = 0;

	for (int j = 0; j < n; j++)
		moved |= last[j] < 0;
	for (int i = 0; i < count; i++)
		if (memcmp(flip + (size_t)i*(size_t)n, last, (size_t)n*sizeof *flip) == 0)
			return 1;
	return !moved;
}

/* flip [n][n]: those that differ. */
static enum hawser_status reflections(struct hawser__fold_search *search, int *flip, int *count)
{
	const struct hawser_rom *rom = search->rom;
	size_t n = (size_t)rom->n;
	unsigned char *member = calloc(n, 1);
	double *G = calloc(n*n, sizeof *G);
	struct hawser__signs signs = {.n = 0};
	enum hawser_status status = member && G ? hawser__signs_init(&signs, rom, G, search->report)
	                                        : hawser__no_memory(search->report, "folds");

	*count = 0;
	for (int j = 0; !status && j < rom->n; j++) {
		int none = 1;

		status = hawser__signs_flip(&signs, member, j, flip + (size_t)*count*n, &none,
		                            search->report);
		*count += !status && !none && !is_old(flip, *count, rom->n);
	}
	hawser__signs_free(&signs);
	free(G);
	free(member);
	return status;
}

enum hawser_status hawser__fold_images(struct hawser__fold_search *search)
{
	const struct hawser_rom *rom = search->rom;
	size_t n = (size_t)rom->n, bytes = (size_t)search->fold.size*sizeof(double);
	int *flip = calloc(n*(n + 1), sizeof *flip), count = 0;
	double *z = malloc(bytes);
	enum hawser_status status = flip && z ? HAWSER_OK : hawser__no_memory(search->report, "folds");

	if (!status && !search->options->first) /* of one response only, they are not asked for */
		status = reflections(search, flip, &count);
	if (!status) {
		memcpy(z, search->walk.start.z, bytes);
		status = hawser__fold_new(search);
	}
	for (int i = 0; !status && i < count; i++) {
		const int *sign = flip + (size_t)i*n;
		double here = misfit(rom, sign, 0), there = misfit(rom, sign, 1), least = fmin(here, there);

		if (least > 0.0 && least < UNLIKE && !hawser__fold_ended(search))
			status = image(search, z, sign, there < here);
	}
	free(z);
	free(flip);
	return status;
}
