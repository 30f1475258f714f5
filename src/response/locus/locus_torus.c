/* response/locus/locus_torus.c - the first Lyapunov coefficient of a torus; its passage through
 * resonances.
 *
 * With u = u_0 + (A v exp(i kappa tau) + c.c.) + |A|^2 h + (A^2 k exp(2 i kappa tau) + c.c.), the
 * equation of the amplitude is, from its solvability,
 *
 *      w^H (dH/dlambda) v A' = - (w^H f_2(v, h) + w^H f_2(conj v, k) + w^H f_3(v, v, conj v)/2) A |A|^2
 *
 *      F_y h = - f_2(v, conj v),     H(2 kappa) k = - f_2(v, v)/2
 *
 * with the second and third derivatives f_2, f_3 of the forces. The torus attracts what begins near it
 * and its orbit where the real part of the coefficient, divided by that of A', is negative.
 *
 * Where kappa becomes 0 or 1/2, the locus ends in general: beyond is the same curve with the conjugate
 * v. If the multipliers of the pair stay semisimple, as in a motion with circular symmetry, it passes.
 *
 * Reference: Kuznetsov, Elements of Applied Bifurcation Theory, 2004, sections 5.4 and 9.6.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <lapacke.h>
#include <math.h>
#include <string.h>

#include "response/locus/locus_walk.h"
#include "rom/energy/kernel.h"

#define FAR 0.03  /* largest distance of kappa from its end at which both sides are compared; chosen */
#define SAME 1e-6 /* of points that are the same, relative to the ranges; chosen */

struct second {
	double complex *vv;      /* [rows][n] f_2(v, v) */
	double complex *adjoint; /* [rows][n] the row w^H f_2(conj v, .) */
	double *square;          /* [rows][n] f_2(v, conj v) */
	double complex third;    /* w^H f_3(v, v, conj v) */
	double complex *adjoint_v; /* [rows][n] as adjoint, for velocities; only with terms, whose f_2 and
	                          * f_3 are those of velocities too */
	double complex *rate;    /* [rows][n] scratch */
	double mean;             /* of |v|^2 */
};

/* What follows from x, the real or the imaginary part of v. */
static int add_part(struct hawser__locus *locus, struct second *sums, int imaginary)
{
	int n = locus->n, rows = locus->rows;
	double *x = locus->force + (size_t)rows*n, h; /* behind the forces */
	const double complex turn = imaginary ? I : 1.0;

	for (int k = 0; k < rows*n; k++)
		x[k] = imaginary ? cimag(locus->vt[k]) : creal(locus->vt[k]);
	if (!((h = hawser__locus_both_sides(locus, x, imaginary)) > 0.0))
		return 1;
	sums->mean += cblas_ddot(rows*n, x, 1, x, 1)/rows;
	for (int r = 0; r < rows; r++)
		for (int i = 0; i < n; i++) {
			size_t at = (size_t)r*n + i;
			const double *p = locus->plus + at*n, *m = locus->minus + at*n;
			const double *T = locus->tangent + at*n;
			double complex w = conj(locus->wt[at]), first = 0.0, again = 0.0;

			for (int j = 0; j < n; j++) {
				double complex v = locus->vt[(size_t)r*n + j];
				double slope = (p[j] - m[j])/(2.0*h);

				first += slope*v;
				again += (p[j] + m[j] - 2.0*T[j])/(h*h)*v;
				sums->square[at] += slope*x[(size_t)r*n + j];
				sums->adjoint[(size_t)r*n + j] += conj(turn)*slope*w;
			}
			for (int j = 0; locus->more && j < n; j++) {
				double complex v = locus->omega*locus->dv[(size_t)r*n + j];
				double ahead = locus->plus_v[at*n + j], back = locus->minus_v[at*n + j];
				double slope = (ahead - back)/(2.0*h);

				first += slope*v;
				again += (ahead + back - 2.0*locus->slope[at*n + j])/(h*h)*v;
				sums->square[at] += slope*(imaginary ? cimag(v) : creal(v));
				sums->adjoint_v[(size_t)r*n + j] += conj(turn)*slope*w;
			}
			sums->vv[at] += turn*first;
			sums->third += w*again;
		}
	return 0;
}

/* w^H f_2(v, h). */
static double complex through_orbit(struct hawser__locus *locus, const struct second *sums)
{
	int n = locus->n, P = locus->coefficients, columns = 2*locus->width + 1;
	double *h = locus->rhs;
	double complex sum = 0.0;

	hawser__locus_transform(locus, h, sums->square);
	cblas_dscal(P, -1.0, h, 1);
	LAPACKE_dgetrs_work(LAPACK_COL_MAJOR, 'N', P, 1, locus->J_factors, P, locus->pivot, h, P);
	for (int r = 0; r < locus->rows; r++)
		for (int k = 0; k < 2*locus->order + 1; k++)
			for (int j = 0; j < n; j++)
				sum += locus->q[(size_t)r*n + j]*h[k*n + j]*locus->basis[(size_t)r*columns + k];
	return sum + hawser__locus_through_velocities(locus, h);
}

/* w^H f_2(conj v, k), NAN where H(2 kappa) is singular (a resonance 1:3). */
static double complex through_double(struct hawser__locus *locus, const struct second *sums)
{
	int n = locus->n, wide = locus->wide, rows = locus->rows, blocks = locus->blocks;
	double complex *k = locus->wave, sum = 0.0;
	const double complex one = 1.0, none = 0.0, factor = -0.5/rows;

	for (int r = 0; r < rows; r++) {
		const double complex turn = cexp(-I*(2.0*M_PI*locus->kappa*r/rows));

		for (int j = 0; j < n; j++)
			sums->vv[(size_t)r*n + j] *= turn;
	}
	cblas_zgemm(CblasRowMajor, CblasConjTrans, CblasNoTrans, blocks, n, rows, &factor,
	            locus->exponential, blocks, sums->vv, n, &none, k, n);
	hawser__locus_hill(locus, 2.0*locus->kappa, 0);
	for (int i = 0; i < wide; i++)
		k[i] *= locus->scale[i];
	if (LAPACKE_zgesv_work(LAPACK_COL_MAJOR, wide, 1, locus->A, wide, locus->pivot, k, wide))
		return NAN;
	locus->solves++;
	for (int i = 0; i < wide; i++)
		k[i] *= locus->scale[i];
	cblas_zgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, rows, n, blocks, &one, locus->exponential,
	            blocks, k, n, &none, sums->vv, n);
	for (int i = 0; i < wide; i++)
		k[i] *= I*locus->omega*(locus->low + i/n + 2.0*locus->kappa);
	if (locus->more)
		cblas_zgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, rows, n, blocks, &one,
		            locus->exponential, blocks, k, n, &none, sums->rate, n);
	for (int r = 0; r < rows; r++) {
		const double complex turn = cexp(I*(2.0*M_PI*locus->kappa*r/rows));

		for (int j = 0; j < n; j++)
			sum += sums->adjoint[(size_t)r*n + j]*turn*sums->vv[(size_t)r*n + j];
		for (int j = 0; locus->more && j < n; j++)
			sum += sums->adjoint_v[(size_t)r*n + j]*turn*sums->rate[(size_t)r*n + j];
	}
	return sum;
}

double hawser__locus_lyapunov(struct hawser__locus *locus)
{
	/* the derivatives of v have served, but the first one for terms */
	struct second sums = {.vv = locus->more ? locus->kept[0] : locus->dv, .adjoint = locus->ddv,
		.square = locus->square, .adjoint_v = locus->kept[1], .rate = locus->kept[2]};
	size_t count = (size_t)locus->rows*locus->n;
	double complex rate = locus->g_kappa/(-I*locus->omega), all;

	memset(sums.vv, 0, count*sizeof *sums.vv);
	memset(sums.adjoint, 0, count*sizeof *sums.adjoint);
	memset(sums.square, 0, count*sizeof *sums.square);
	if (locus->more)
		memset(sums.adjoint_v, 0, count*sizeof *sums.adjoint_v);
	hawser__rom_tangents(locus->rom, locus->force, locus->tangent, locus->u, locus->rows, locus->work);
	hawser__locus_terms(locus, locus->tangent, locus->slope, locus->u, locus->du);
	if (add_part(locus, &sums, 0) || add_part(locus, &sums, 1))
		return NAN;
	all = through_orbit(locus, &sums);
	all += through_double(locus, &sums) + 0.5*sums.third;
	return -creal(all/rate)/sums.mean;
}

/* scratch = the curve at kappa, near `from`. */
static enum hawser_status at_angle(struct hawser__locus_walk *walk,
                                   const struct hawser__locus_station *from, double kappa, int *failed)
{
	hawser__locus_station_copy(walk, &walk->scratch, from);
	memset(walk->spare, 0, (size_t)walk->room*sizeof(double));
	walk->spare[LOCUS_KAPPA] = 1.0;
	walk->scratch.z[LOCUS_KAPPA] = kappa;
	return hawser__locus_correct(walk, &walk->scratch, walk->spare, failed);
}

enum hawser_status hawser__locus_pass(struct hawser__locus_walk *walk, double end, int *passes)
{
	double inside = fabs(walk->here.z[LOCUS_KAPPA] - end);
	double beyond = fabs(walk->next.z[LOCUS_KAPPA] - end);
	double far = fmin(FAR, fmax(inside, beyond)), side = end > 0.0 ? 1.0 : -1.0, z[2];
	const double *extent = walk->locus->extent;
	int failed;
	enum hawser_status status = at_angle(walk, &walk->next, end + side*far, &failed);

	*passes = 0;
	if (status || failed)
		return status;
	memcpy(z, walk->scratch.z, sizeof z);
	status = at_angle(walk, &walk->here, end - side*far, &failed);
	if (status || failed)
		return status;
	*passes = fmax(fabs(z[0] - walk->scratch.z[0])/extent[0],
	               fabs(z[1] - walk->scratch.z[1])/extent[1]) > SAME;
	return HAWSER_OK;
}

/* The same orbit with the conjugate of v, whose harmonics have the opposite sign. */
static void conjugate(const struct hawser__locus *locus, double complex *x, double end)
{
	int n = locus->n, partner = -(int)(2.0*end), last = locus->low + locus->blocks - 1;

	for (int m = locus->low; m <= last; m++)
		for (int j = 0; j < n; j++) {
			int to = partner - m;
			double complex *a = x + (size_t)(m - locus->low)*n + j, *b, keep = conj(*a);

			if (to < locus->low || to > last) {
				*a = 0.0; /* beyond the harmonics */
				continue;
			}
			b = x + (size_t)(to - locus->low)*n + j;
			if (to == m)
				*a = keep;
			if (to > m) {
				*a = conj(*b);
				*b = keep;
			}
		}
}

static void turn_back(struct hawser__locus_station *station, double end)
{
	station->z[LOCUS_KAPPA] = 2.0*end - station->z[LOCUS_KAPPA];
	station->t[LOCUS_KAPPA] *= -1.0;
}

void hawser__locus_mirror(struct hawser__locus_walk *walk, double end)
{
	struct hawser__locus_station *next = &walk->next;

	turn_back(&walk->before, end);
	turn_back(&walk->prev, end);
	turn_back(&walk->here, end);
	turn_back(next, end);
	conjugate(walk->locus, next->b, end);
	conjugate(walk->locus, next->c, end);
	next->point.angle = 2.0*M_PI*next->z[LOCUS_KAPPA];
	hawser__locus_test_angle(walk->locus, next);
}
