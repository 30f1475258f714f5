/* response/time/beam_model.c - a travelling beam as a reduced model: M b'' + C b' + K b = 0 in
 * coordinates u, b = B u, with B^T M B = I.
 *
 * B is the inverse of the Cholesky factor of M, for all functions; or its columns are the first
 * modes of the beam at rest. The latter omit what the functions do not resolve: high frequencies,
 * which only shorten the steps, and, for a Rayleigh beam with free moments, spurious growth.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>

#include <cblas.h>
#include <lapacke.h>

#include <hawser/beam_motion.h>

#include "core/report.h"

static enum hawser_status failed(int n, int info, struct hawser_report *report)
{
	if (hawser__lapack_starved(info))
		return hawser__no_memory(report, "beam");
	return hawser__fail(report, HAWSER_ERR_CONVERGENCE, "beam",
	                    "the mass matrix of %d functions is not positive in double precision",
	                    n);
}

/* B = U^-1 with M = U^T U */
static enum hawser_status all_functions(double *B, double *M, int n, struct hawser_report *report)
{
	int info;

	memset(B, 0, (size_t)n*(size_t)n*sizeof *B);
	for (int i = 0; i < n; i++)
		B[(size_t)i*(size_t)n + (size_t)i] = 1.0;
	info = LAPACKE_dpotrf(LAPACK_ROW_MAJOR, 'U', n, M, n);
	if (info)
		return failed(n, info, report);
	cblas_dtrsm(CblasRowMajor, CblasLeft, CblasUpper, CblasNoTrans, CblasNonUnit, n, n, 1.0, M, n,
	        B, n);
	return HAWSER_OK;
}

/* The first m modes at rest. */
static enum hawser_status modes_at_rest(double *B, double *M, int m,
                                        const struct hawser_beam_integrals *is,
                                        const struct hawser_beam *beam, struct hawser_report *report)
{
	size_t n = (size_t)is->n;
	double *A = malloc((2*n*n + n)*sizeof *A), *unused = A ? A + n*n : NULL;
	struct hawser_beam rest = *beam;
	int info;

	if (!A)
		return hawser__no_memory(report, "beam");
	rest.speed = 0.0;
	hawser_beam_matrices(M, unused, A, is, &rest);
	info = LAPACKE_dsygv(LAPACK_ROW_MAJOR, 1, 'V', 'U', is->n, A, is->n, M, is->n, unused);
	for (size_t i = 0; !info && i < n; i++)
		memcpy(B + i*(size_t)m, A + i*n, (size_t)m*sizeof *B);
	free(A);
	return info ? failed(is->n, info, report) : HAWSER_OK;
}

/* to [m][m] = B^T A B */
static void project(double *to, const double *A, const double *B, double *room, int n, int m)
{
	cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, n, m, n, 1.0, A, n, B, m, 0.0, room, m);
	cblas_dgemm(CblasRowMajor, CblasTrans, CblasNoTrans, m, m, n, 1.0, B, m, room, m, 0.0, to, m);
}

enum hawser_status hawser_rom_from_beam(struct hawser_rom *rom, double *B, int modes,
                                        const struct hawser_beam_integrals *is,
                                        const struct hawser_beam *beam, struct hawser_report *report)
{
	int n = is->n, m = modes > 0 && modes < n ? modes : n, has_units = beam->time > 0.0;
	size_t square = (size_t)n*(size_t)n;
	double *M = malloc(4*square*sizeof *M);
	enum hawser_status status;

	*rom = (struct hawser_rom){.n = m, .length = has_units ? beam->length : 1.0,
	                           .time = has_units ? beam->time : 1.0, .force = 1.0};
	rom->D = malloc((size_t)m*(size_t)m*sizeof *rom->D);
	rom->K = malloc((size_t)m*(size_t)m*sizeof *rom->K);
	if (!M || !rom->D || !rom->K) {
		status = hawser__no_memory(report, "beam");
		goto done;
	}
	hawser_beam_matrices(M, M + square, M + 2*square, is, beam);
	status = m < n ? modes_at_rest(B, M, m, is, beam, report) : all_functions(B, M, n, report);
	if (status)
		goto done;
	project(rom->D, M + square, B, M + 3*square, n, m);
	project(rom->K, M + 2*square, B, M + 3*square, n, m);
	status = hawser_rom_compile(rom, report);
done:
	free(M);
	if (status)
		hawser_rom_clear(rom);
	return status;
}
