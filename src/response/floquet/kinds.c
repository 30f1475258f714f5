/* response/floquet/kinds.c - the kinds of multipliers (floquet.h), by the eigenvectors of the product
 * of transition matrices.
 *
 * Kinds need no digits: the product is formed at once, with displacements scaled by their
 * frequencies, and each multiplier of the periodic QR algorithm takes the kind of the eigenvalue that
 * is nearest to it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <cblas.h>
#include <lapacke.h>
#include <math.h>
#include <string.h>

#include "response/floquet/floquet.h"
#include "response/floquet/monodromy.h"
#include "rom/terms/terms.h"

#define POTENTIAL 1e-9 /* largest asymmetry of forces that derive from a potential, relative; chosen */
#define LARGEST 1e8    /* norm of the product above which round-off hides its eigenvalues; chosen */
#define SAME 1e-3      /* distance of two logarithms up to which they are of one multiplier; chosen */

/* Whether K and D are symmetric, and D is constant. */
static int has_kinds(const struct hawser_rom *rom)
{
	if (hawser__rom_more(rom) || rom->drag || rom->first || rom->mass ||
	    !(rom->exact || hawser_rom_asymmetry(rom) <= POTENTIAL) ||
	    !hawser__fast_symmetric(rom->D, 0, rom->n))
		return 0;
	for (int h = 0; h < rom->harmonics; h++) {
		const struct hawser_harmonic *harmonic = &rom->harmonic[h];

		if (harmonic->D || harmonic->quads > 0 ||
		    (harmonic->K && !hawser__fast_symmetric(harmonic->K, 0, rom->n)))
			return 0;
	}
	return 1;
}

double hawser__floquet_kind(const double *v, const double *scale, const int *member, int w)
{
	const double *re = v, *im = v + 2*(size_t)w;
	double form = 0.0, norm = 0.0;

	for (int p = 0; p < w; p++) {
		double weight = 1.0/scale[member ? member[p] : p];

		form += 2.0*weight*(re[p]*im[w + p] - im[p]*re[w + p]);
		norm += weight*(re[p]*re[p] + im[p]*im[p] + re[w + p]*re[w + p] + im[w + p]*im[w + p]);
	}
	return form/norm;
}

/* The product [m][m] of transition matrices; room [m][m]. */
static void multiply_all(double *product, double *room, const double *segment, int segments, int m)
{
	size_t block = (size_t)m*m;

	memcpy(product, segment, block*sizeof *product);
	for (int i = 1; i < segments; i++) {
		memcpy(room, product, block*sizeof *room);
		cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, m, m, m, 1.0,
		            segment + (size_t)i*block, m, room, m, 0.0, product, m);
	}
}

/* Index of the eigenvalue re + i im [m] with this logarithm, or -1. */
static int find(const double *re, const double *im, int m, double log_modulus, double argument)
{
	int best = -1;
	double least = SAME;

	for (int i = 0; i < m; i++) {
		double off = im[i] > 0.0 ? hypot(log(hypot(re[i], im[i])) - log_modulus,
		                                 atan2(im[i], re[i]) - argument) : INFINITY;

		if (off < least) {
			least = off;
			best = i;
		}
	}
	return best;
}

void hawser__floquet_kinds(double *kind, double *work, const double *segment, int segments,
                           const double *log_modulus, const double *argument,
                           const struct hawser_rom *rom, double omega)
{
	int n = rom->n, m = 2*n;
	double *product = work, *v = product + (size_t)m*m, *scale = v + (size_t)m*m;
	double *re = scale + m, *im = re + m, *own = im + m, unused;

	memset(kind, 0, (size_t)m*sizeof *kind);
	if (!has_kinds(rom))
		return;
	multiply_all(product, v, segment, segments, m);
	for (int j = 0; j < m; j++)
		scale[j] = j < n ? sqrt(fmax(rom->K[(size_t)j*(n + 1)], omega*omega)) : 1.0;
	for (int e = 0; e < m*m; e++)
		product[e] *= scale[e/m]/scale[e%m];
	if (!(cblas_dnrm2(m*m, product, 1) < LARGEST) ||
	    LAPACKE_dgeev_work(LAPACK_COL_MAJOR, 'V', 'N', m, product, m, re, im, v, m, &unused, 1, own,
	                       HAWSER__EIGEN_WORK*m))
		return;
	for (int i = 0; i < m; i++) {
		int at = find(re, im, m, log_modulus[i], fabs(argument[i]));

		if (at >= 0)
			kind[i] = hawser__floquet_kind(v + (size_t)at*m, scale, NULL, n);
	}
}
