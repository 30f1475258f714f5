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
	if (!work)
		return hawser__no_memory(report, "natural");
	memcpy(work, rom->K, n*n*sizeof *work);
	re = work + n*n;
	im = re + n;
	info = LAPACKE_dgeev(LAPACK_ROW_MAJOR, 'N', 'N', rom->n, work, rom->n, re, im, NULL, 1, NULL, 1);
	for (j = 0; info == 0 && j < n; j++)
		if (re[j] > 0.0 && fabs(im[j]) <= 1e-9*re[j])
			omega[(*count)++] = sqrt(re[j]);
	free(work);
	if (hawser__lapack_starved(info))
		return hawser__no_memory(report, "natural");
	qsort(omega, (size_t)*count, sizeof *omega, compare);
	return HAWSER_OK;
}
