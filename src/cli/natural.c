/* cli/natural.c - undamped natural frequencies of a model, for marks and for multiples such as
 * 0.6w1.
 *
 * K of a model built by this program is diagonal; K of other models may be any matrix. Complex
 * eigenvalues and those that are not positive have no frequency and are omitted.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <lapacke.h>

#include "cli/cli.h"
#include "core/report.h"

/* Static shapes of dampers (labels of rom/build.c) are coordinates without mode. K and the mass do not
 * couple them with modes. */
static int is_shape(const struct hawser_rom *rom, size_t j)
{
	return rom->label && rom->label[j] && strncmp(rom->label[j], "damper shape", 12) == 0;
}

/* K [count][count] of the coordinates that are modes; returns their number. */
static size_t of_modes(double *K, const struct hawser_rom *rom)
{
	size_t n = (size_t)rom->n, count = 0, to = 0;

	for (size_t j = 0; j < n; j++)
		count += !is_shape(rom, j);
	for (size_t j = 0; j < n; j++)
		for (size_t k = 0; k < n && !is_shape(rom, j); k++)
			if (!is_shape(rom, k))
				K[to++] = rom->K[j*n + k];
	return count;
}

static int compare(const void *a, const void *b)
{
	double x = *(const double *)a, y = *(const double *)b;

	return (x > y) - (x < y);
}

enum hawser_status cli_natural(double *omega, int *count, const struct hawser_rom *rom,
                               struct hawser_report *report)
{
	size_t n = (size_t)rom->n;
	double *work = malloc((n*n + 2*n)*sizeof *work), *re, *im;
	size_t j;
	int info;

	*count = 0;
	if (rom->first) { /* K is not a stiffness */
		free(work);
		return HAWSER_OK;
	}
	if (!work)
		return hawser__no_memory(report, "natural");
	re = work + n*n;
	im = re + n;
	n = of_modes(work, rom);
	info = LAPACKE_dgeev(LAPACK_ROW_MAJOR, 'N', 'N', (lapack_int)n, work, (lapack_int)n, re, im, NULL,
	                     1, NULL, 1);
	for (j = 0; info == 0 && j < n; j++)
		if (re[j] > 0.0 && fabs(im[j]) <= 1e-9*re[j])
			omega[(*count)++] = sqrt(re[j]);
	free(work);
	if (hawser__lapack_starved(info))
		return hawser__no_memory(report, "natural");
	qsort(omega, (size_t)*count, sizeof *omega, compare);
	return HAWSER_OK;
}
