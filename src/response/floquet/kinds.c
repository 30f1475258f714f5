/* response/floquet/kinds.c - multipliers and their kinds (floquet.h) from one matrix, the product over
 * the period, by LAPACK's QR algorithm.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <lapacke.h>
#include <math.h>
#include <string.h>

#include "response/floquet/floquet.h"
#include "response/floquet/monodromy.h"
#include "rom/terms/terms.h"

#define POTENTIAL 1e-9 /* largest asymmetry of forces that derive from a potential, relative; chosen */
#define LARGEST 1e4    /* norm of the product over the modulus of its smallest multiplier, which has
                        * twelve digits then; chosen */

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

/* That of the eigenvector v [2][2 w], real and imaginary part, of w displacements, which are multiplied
 * by their frequencies scale[p], or scale[member[p]], and velocities. */
static double kind_of(const double *v, const double *scale, const int *member, int w)
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

/* The rows of the product are columns there, and the vectors from the left those of the product from
 * the right, for the conjugate. */
int hawser__floquet_vectors(double *log_modulus, double *argument, double *kind, double *product, int m,
                            const double *scale, const int *member, double *v, double *work)
{
	double *re = work, *im = re + m, *own = im + m, unused;
	int info = LAPACKE_dgeev_work(LAPACK_COL_MAJOR, kind ? 'V' : 'N', 'N', m, product, m, re, im, v, m,
	                              &unused, 1, own, HAWSER__EIGEN_WORK*m);

	for (int i = 0; i < m && !info; i++) {
		log_modulus[i] = log(hypot(re[i], im[i]));
		argument[i] = atan2(im[i], re[i]);
		if (kind && im[i] > 0.0)
			kind[i] = kind[i + 1] = kind_of(v + (size_t)i*m, scale, member, m/2);
	}
	return info;
}

int hawser__floquet_directly(double *log_modulus, double *argument, double *kind, double *work,
                             const double *segment, int segments, const struct hawser_rom *rom,
                             double omega)
{
	int n = rom->n, m = 2*n;
	double *product = work, *scale = product + (size_t)m*m, *room = scale + m, damping = 0.0;
	double norm;
	int known;

	memset(kind, 0, (size_t)m*sizeof *kind);
	multiply_all(product, room, segment, segments, m);
	for (int j = 0; j < m; j++)
		scale[j] = j < n ? sqrt(fmax(rom->K[(size_t)j*(n + 1)], omega*omega)) : 1.0;
	for (int e = 0; e < m*m; e++)
		product[e] *= scale[e/m]/scale[e%m];
	for (int j = 0; j < n; j++)
		damping = fmax(damping, rom->D[(size_t)j*(n + 1)]);
	norm = cblas_dnrm2(m*m, product, 1);
	known = norm*exp(damping*2.0*M_PI/omega) < LARGEST &&
	        !hawser__floquet_vectors(log_modulus, argument, has_kinds(rom) ? kind : NULL, product, m,
	                                 scale, NULL, room, room + (size_t)m*m);
	if (known)
		hawser__floquet_sort(log_modulus, argument, kind, m);
	/* off its diagonal D may damp more */
	known = known && norm < LARGEST*exp(log_modulus[m - 1]);
	if (!known)
		memset(kind, 0, (size_t)m*sizeof *kind);
	return known;
}
