/* cli/model/natural.c - undamped natural frequencies of a model, for marks and for multiples such as
 * 0.6w1.
 *
 *   K, D, M   stiffness, damping and mass of the coordinates that are modes: q'' + D q' + K q = 0 was
 *             multiplied by the inverse of M
 *   G         inv(M) times the skew part of M D: the gyroscopic forces
 *
 * The frequencies are those of q'' + G q' + K q = 0. K of a model built by this program is diagonal; K
 * of other models may be any matrix. Eigenvalues off the imaginary axis have no frequency and are
 * omitted.
 *
 * In a model of a travelling cable, coordinates are modes of the apparent cable at rest, and the
 * gyroscopic forces couple them with all others: few coordinates are far from the frequencies of
 * the cable (one has none of the coupling). The scene of such a cable therefore has the
 * frequencies of its complex modes, which hawser modes prints.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <cblas.h>
#include <hawser/gyroscopic.h>
#include <lapacke.h>

#include "cli/frame/cli.h"
#include "cli/model/made.h"
#include "core/hold.h"
#include "core/order.h"
#include "core/report.h"

/* Terms of one factor. */
static void add_terms(double *K, double *D, const struct hawser_term *term, int terms, size_t n)
{
	for (int t = 0; t < terms; t++)
		if (term[t].factors == 1)
			(term[t].rates ? D : K)[(size_t)term[t].j*n + (size_t)term[t].factor[0]] += term[t].value;
}

int cli_linear(double *K, double *D, const struct hawser_rom *rom)
{
	size_t n = (size_t)rom->n;
	int turns = 0;

	memcpy(K, rom->K, n*n*sizeof *K);
	memcpy(D, rom->D, n*n*sizeof *D);
	add_terms(K, D, rom->term, rom->terms, n);
	for (int h = 0; h < rom->harmonics; h++) {
		const struct hawser_harmonic *at = &rom->harmonic[h];

		if (at->k != 0)
			continue;
		turns |= at->omega_power > 0 && (at->K || at->D || at->terms);
		if (at->omega_power > 0)
			continue;
		for (size_t i = 0; at->K && i < n*n; i++)
			K[i] += at->K[i];
		add_terms(K, D, at->term, at->terms, n);
	}
	return turns;
}

/* Static shapes of dampers and of condensed modes (labels of rom/build) are coordinates without mode,
 * which K and the mass do not couple with modes. Wakes (rom/terms/wake.c) are no motions of the
 * cable. */
static int is_shape(const struct hawser_rom *rom, size_t j)
{
	static const char *const shape[] = {"damper shape", "second-order shape", "wake "};
	int is = 0;

	for (size_t k = 0; k < sizeof shape/sizeof *shape && rom->label && rom->label[j]; k++)
		is |= strncmp(rom->label[j], shape[k], strlen(shape[k])) == 0;
	return is;
}

/* part [count][count]: the rows and columns of all [n][n] that are modes; returns their number. */
static size_t of_modes(double *part, const double *all, const struct hawser_rom *rom)
{
	size_t n = (size_t)rom->n, count = 0, to = 0;

	for (size_t j = 0; j < n; j++)
		count += !is_shape(rom, j);
	for (size_t j = 0; j < n; j++)
		for (size_t k = 0; k < n && !is_shape(rom, j); k++)
			if (!is_shape(rom, k))
				part[to++] = all[j*n + k];
	return count;
}

/* A [n][n] becomes its gyroscopic part; returns 1 if there is any. In coordinates of unknown mass only
 * a pair of entries with opposite signs is sure to be of that kind. */
static int keep_skew(double *A, size_t n, int mass_known)
{
	int any = 0;

	for (size_t j = 0; j < n; j++) {
		A[j*n + j] = 0.0;
		for (size_t k = 0; k < j; k++) {
			double a = A[j*n + k], b = A[k*n + j], skew = 0.5*(a - b);
			int here = fabs(skew) > 1e-12*(fabs(a) + fabs(b)) && (mass_known || a*b < 0.0);

			A[j*n + k] = !here ? 0.0 : mass_known ? skew : a;
			A[k*n + j] = !here ? 0.0 : mass_known ? -skew : b;
			any |= here;
		}
	}
	return any;
}

/* G [n][n] as above; M [n][n] and pivot [n] are scratch. Returns 1 if it is not zero, or 0. */
static int gyroscopic(double *G, double *M, lapack_int *pivot, const struct hawser_rom *rom,
                      const double *D, int *info)
{
	size_t n = of_modes(G, D, rom);
	int m = (int)n, any;

	if (!rom->mass)
		return keep_skew(G, n, rom->scaled);
	of_modes(G, rom->mass, rom);
	of_modes(M, D, rom);
	cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, m, m, m, 1.0, G, m, M, m, 0.0, M + n*n, m);
	memcpy(M, G, n*n*sizeof *M);
	memcpy(G, M + n*n, n*n*sizeof *G);
	any = keep_skew(G, n, 1);
	if (any)
		*info = LAPACKE_dgesv(LAPACK_ROW_MAJOR, m, m, M, m, pivot, G, m);
	return any;
}

/* A [2n][2n] = [0 I; -K -G]. */
static void first_order(double *A, const double *K, const double *G, size_t n)
{
	memset(A, 0, 4*n*n*sizeof *A);
	for (size_t j = 0; j < n; j++) {
		double *upper = A + 2*n*j, *lower = A + 2*n*(n + j);

		upper[n + j] = 1.0;
		for (size_t k = 0; k < n; k++) {
			lower[k] = -K[j*n + k];
			lower[n + k] = -G[j*n + k];
		}
	}
}

/* The frequency of an eigenvalue of K, or (turning) of the first-order system; 0: it has none. */
static double frequency(double re, double im, int turning)
{
	if (turning)
		return im > 0.0 && fabs(re) <= 1e-6*im ? im : 0.0;
	return re > 0.0 && fabs(im) <= 1e-9*re ? sqrt(re) : 0.0;
}

/* omega [rom->n]: those of the reduced model. */
static enum hawser_status of_rom(double *omega, int *count, const struct hawser_rom *rom,
                                 struct hawser_report *report)
{
	size_t n = (size_t)rom->n, size;
	double *K = malloc((8*n*n + 4*n)*sizeof *K), *G = hawser__behind(K, n*n);
	double *A = hawser__behind(G, n*n), *re = hawser__behind(A, 4*n*n);
	double *linear = hawser__behind(re, 4*n);
	lapack_int *pivot = malloc(n*sizeof *pivot);
	int info = 0, turning;
	enum hawser_status status = HAWSER_OK;

	*count = 0;
	if (!K || !pivot) {
		status = hawser__no_memory(report, "natural");
		goto out;
	}
	(void)cli_linear(linear, linear + n*n, rom);
	turning = gyroscopic(G, A, pivot, rom, linear + n*n, &info);
	n = of_modes(K, linear, rom);
	size = turning ? 2*n : n;
	if (turning)
		first_order(A, K, G, n);
	if (info == 0)
		info = LAPACKE_dgeev(LAPACK_ROW_MAJOR, 'N', 'N', (lapack_int)size, turning ? A : K,
		                     (lapack_int)size, re, re + size, NULL, 1, NULL, 1);
	for (size_t j = 0; info == 0 && j < size; j++)
		if ((omega[*count] = frequency(re[j], re[size + j], turning)) > 0.0)
			++*count;
	if (hawser__lapack_starved(info))
		status = hawser__no_memory(report, "natural");
	qsort(omega, (size_t)*count, sizeof *omega, hawser__ascending);
out:
	free(pivot);
	free(K);
	return status;
}

/* Those of the complex modes in place of the first ones. */
static enum hawser_status of_travel(struct cli_model *model, struct hawser_report *report)
{
	struct hawser_modes_options options = cli_modes_options(&model->scene);
	struct hawser_modes modes;
	enum hawser_status status;

	if (options.n > model->naturals)
		options.n = model->naturals;
	if (options.n < 1)
		return HAWSER_OK;
	status = hawser_steady_modes_solve(&modes, &model->statics, &options, report);
	if (status)
		return status;
	for (int k = 0; k < modes.n; k++)
		model->natural[k] = modes.mode[k].omega/modes.time_unit*model->rom.time;
	hawser_modes_clear(&modes);
	qsort(model->natural, (size_t)model->naturals, sizeof *model->natural, hawser__ascending);
	return HAWSER_OK;
}

int cli_natural_number(const struct cli_model *model, int k)
{
	const struct hawser_modes *modes = model->made ? &model->made->modes.modes : NULL;

	return modes && k < modes->n ? modes->mode[k].place : k + 1;
}

enum hawser_status cli_natural(struct cli_model *model, struct hawser_report *report)
{
	int most = model->automatic ? model->modes.n : model->rom.n;
	enum hawser_status status = HAWSER_OK;

	free(model->natural); /* of a model that has been made again */
	model->natural = calloc((size_t)most + 1, sizeof *model->natural);
	if (!model->natural)
		return hawser__no_memory(report, "natural");
	if (model->automatic) {
		model->naturals = most;
		for (int k = 0; k < most; k++)
			model->natural[k] = model->modes.mode[k].omega;
	} else if (!model->rom.first) { /* otherwise K is not a stiffness */
		status = of_rom(model->natural, &model->naturals, &model->rom, report);
	}
	if (!status && model->has_scene && model->statics.motion.nu != 0.0)
		status = of_travel(model, report);
	return status;
}
