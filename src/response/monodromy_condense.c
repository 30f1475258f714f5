/* response/monodromy_condense.c - variational equations without the coordinates that are too fast
 * to matter.
 *
 *    s, f    slow and fast coordinates
 *    w       frequencies of the mean stiffness
 *    G       K_ff^-1 K_fs: the static response of the fast coordinates is -G x_s
 *
 * A full-order model has longitudinal and high transverse coordinates with frequencies up to 1e4
 * times Omega. They respond quasi-statically to the slow ones, and their own fast motion does not
 * take part in an instability: an instability is due to a harmonic k of K and two coordinates with
 * w_i + w_j = k Omega, and requires that |K_k|/(2 sqrt(w_i w_j)) exceeds the damping. The highest
 * such k gives the frequency W = (k + 1) Omega up to which coordinates matter. A coordinate far
 * above W is fast if its neglected part, (G w/w_f)^2 relative to the stiffness, is small enough.
 *
 * With x_f = -G x_s in the equations, inertia included:
 *
 *      (1 + G'G) x'' + (2 G'dG + D_ss - D_sf G - G'D_fs + G'D_ff G) x'
 *         + (K_ss - K_sf G + G'ddG + (G'D_ff - D_sf) dG) x = 0
 *
 * (G' the transpose, dG and ddG derivatives in time). The condensed equations have the conservation
 * properties of the whole. G is computed at equidistant phases and differentiated as a Fourier
 * series.
 *
 * For a search K need not be symmetric, and D may vary: G' is then K_sf K_ff^-1.
 *
 * A coordinate is classified as fast by its own stiffness. Since coupling changes the frequencies
 * of the fast coordinates, all their combinations are examined: if one of them is slow or has no
 * positive stiffness, no coordinate is condensed.
 *
 * The multipliers of a model with fast coordinates are therefore approximate, while its orbits are
 * not, and folds follow from the tangent of the branch. If all frequencies are below `follow` times
 * Omega, no coordinate is condensed.
 *
 * Reference: Guyan, AIAA J. 3 (1965), for constant K.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <cblas.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "response/monodromy.h"

#define SINGULAR 1e-8      /* ratio of a pivot of K_ff to the mean below which it counts as 0: far
                            * above round-off */
#define ASIDE 1.0          /* harmonics beyond the highest resonance that a hasty computation
                            * includes; chosen */

/* --- the equations of the slow coordinates --- */

struct work {
	int n, ns, nf, rows, order; /* order of the result */
	double *basis;              /* [rows][columns], columns the larger of both orders' */
	int columns;
	double *K;                  /* [rows][n][n] */
	double *G, *dG, *ddG;       /* [rows][nf][ns] */
	double *left;               /* [rows][nf][ns] K_ff'^-1 K_sf', which is G where K is symmetric */
	double *damp;               /* [n][n] D at the present phase */
	int *pivot;                 /* NULL where K is symmetric and D constant */
	double *spectral;           /* [rows][rows] d/dtau */
	double *ff, *part;          /* [nf][nf]; [nf][ns] */
	double *M, *C, *B;          /* [ns][ns]; [rows][ns][ns] damping and stiffness */
	double *D, *T;              /* [2 order + 1][ns][ns] the result */
};

static enum hawser_status make_room(struct work *work, struct hawser__monodromy *monodromy,
                                    struct hawser_report *report)
{
	size_t n = (size_t)work->n, ns = (size_t)work->ns, nf = (size_t)work->nf;
	size_t rows = (size_t)work->rows, wide = 2*(size_t)work->order + 1;
	size_t need = rows*(size_t)work->columns + rows*n*n + n*n + 4*rows*nf*ns + rows*rows + nf*nf +
	              nf*ns + ns*ns + 2*rows*ns*ns + 2*wide*ns*ns;
	double *next;

	if (need > monodromy->room_size) {
		free(monodromy->room);
		monodromy->room = malloc(2*need*sizeof(double));
		monodromy->room_size = monodromy->room ? 2*need : 0;
	}
	if (!monodromy->room)
		return hawser__no_memory(report, "orbit");
	work->basis = next = monodromy->room;
	work->K = next += rows*(size_t)work->columns;
	work->G = next += rows*n*n;
	work->dG = next += rows*nf*ns;
	work->ddG = next += rows*nf*ns;
	work->left = work->pivot ? next += rows*nf*ns : work->G;
	work->damp = next += rows*nf*ns;
	work->spectral = next += n*n;
	work->ff = next += rows*rows;
	work->part = next += nf*nf;
	work->M = next += nf*ns;
	work->C = next += ns*ns;
	work->B = next += rows*ns*ns;
	work->D = next += rows*ns*ns;
	work->T = next + wide*ns*ns;
	return HAWSER_OK;
}

static void make_tables(struct work *work)
{
	int rows = work->rows;

	for (int i = 0; i < rows; i++) {
		double *row = work->basis + (size_t)i*work->columns;

		row[0] = 0.5;
		for (int c = 1; c < work->columns; c++) {
			double angle = 2.0*M_PI*(double)((long)i*((c + 1)/2)%rows)/rows;

			row[c] = c%2 ? cos(angle) : sin(angle);
		}
		/* derivative of the trigonometric interpolant through an odd number of phases */
		for (int j = 0; j < rows; j++)
			work->spectral[(size_t)i*rows + j] =
				i == j ? 0.0 : ((i + j)%2 ? -0.5 : 0.5)/sin(M_PI*(i - j)/rows);
	}
}

/* Whether the pivots of K_ff at one phase, in its factor U, are safely positive. The mean of K_ff
 * is positive (separate()), so that if K_ff is not positive at one phase, it is singular at
 * another. A pivot that is 0 but for round-off must not count as positive with any BLAS kernel: the
 * limit is far above the round-off of the largest entry. */
static int positive(const struct work *work, const struct hawser__monodromy *monodromy)
{
	int nf = work->nf;

	for (int f = 0; f < nf; f++) {
		double mean = monodromy->frequency[monodromy->fast[f]], pivot = work->ff[f*nf + f];

		if (!(pivot*pivot > SINGULAR*mean*mean))
			return 0;
	}
	return 1;
}

/* G and `left` at one phase for a K that is not symmetric; returns 1 if K_ff is singular. */
static int follow_both(struct work *work, const struct hawser__monodromy *monodromy, int row)
{
	const double *K = work->K + (size_t)row*work->n*work->n;
	size_t at = (size_t)row*work->nf*work->ns;
	int n = work->n, nf = work->nf, ns = work->ns;

	for (int f = 0; f < nf; f++)
		for (int e = 0; e < nf; e++) /* by columns */
			work->ff[e*nf + f] = K[(size_t)monodromy->fast[f]*n + monodromy->fast[e]];
	if (LAPACKE_dgetrf_work(LAPACK_COL_MAJOR, nf, nf, work->ff, nf, work->pivot))
		return 1;
	for (int side = 0; side < 2; side++) {
		double *to = side ? work->left + at : work->G + at;

		for (int f = 0; f < nf; f++)
			for (int s = 0; s < ns; s++) {
				int i = monodromy->fast[f], j = monodromy->slow[s];

				work->part[s*nf + f] = side ? K[(size_t)j*n + i] : K[(size_t)i*n + j];
			}
		if (LAPACKE_dgetrs_work(LAPACK_COL_MAJOR, side ? 'T' : 'N', nf, ns, work->ff, nf,
		                        work->pivot, work->part, nf))
			return 1;
		for (int f = 0; f < nf; f++)
			for (int s = 0; s < ns; s++)
				to[f*ns + s] = work->part[s*nf + f];
	}
	return 0;
}

/* G at one phase; returns 1 if K_ff is not positive. */
static int follow(struct work *work, const struct hawser__monodromy *monodromy, int row)
{
	const double *K = work->K + (size_t)row*work->n*work->n;
	double *G = work->G + (size_t)row*work->nf*work->ns;
	int n = work->n, nf = work->nf, ns = work->ns, info;

	for (int f = 0; f < nf; f++) {
		const double *from = K + (size_t)monodromy->fast[f]*n;

		for (int e = 0; e < nf; e++)
			work->ff[f*nf + e] = from[monodromy->fast[e]];
		for (int s = 0; s < ns; s++) /* by columns */
			work->part[s*nf + f] = from[monodromy->slow[s]];
	}
	info = LAPACKE_dposv_work(LAPACK_COL_MAJOR, 'U', nf, ns, work->ff, nf, work->part, nf);
	if (info || !positive(work, monodromy))
		return 1;
	for (int f = 0; f < nf; f++)
		for (int s = 0; s < ns; s++)
			G[f*ns + s] = work->part[s*nf + f];
	return 0;
}

/* D at one phase. */
static void damping_of(struct work *work, const struct hawser__variational *system, int row)
{
	int n2 = work->n*work->n;

	if (system->order_d > 0 || row == 0)
		cblas_dgemv(CblasRowMajor, CblasTrans, 2*system->order_d + 1, n2, 1.0, system->D, n2,
		            work->basis + (size_t)row*work->columns, 1, 0.0, work->damp, 1);
}

static double damping_at(const struct work *work, int i, int j)
{
	return work->damp[(size_t)i*work->n + j];
}

/* out [ns][ns] += factor G' x, x [nf][ns]. */
static void add_transposed(double *out, double factor, const double *G, const double *x,
                           const struct work *work)
{
	cblas_dgemm(CblasRowMajor, CblasTrans, CblasNoTrans, work->ns, work->ns, work->nf, factor, G,
	            work->ns, x, work->ns, 1.0, out, work->ns);
}

/* part [nf][ns] = D_ff x - D_fs where `slow`: the damping of the fast coordinates that acts through
 * G'. */
static void damp_fast(struct work *work, const struct hawser__monodromy *monodromy,
                      const double *x, int slow)
{
	for (int f = 0; f < work->nf; f++)
		for (int s = 0; s < work->ns; s++) {
			double sum = slow ? -damping_at(work, monodromy->fast[f], monodromy->slow[s])
			                  : 0.0;

			for (int e = 0; e < work->nf; e++) {
				double d = damping_at(work, monodromy->fast[f], monodromy->fast[e]);

				if (d != 0.0)
					sum += d*x[e*work->ns + s];
			}
			work->part[f*work->ns + s] = sum;
		}
}

/* out [ns][ns] -= D_sf x. */
static void damp_slow(double *out, const struct work *work, const struct hawser__monodromy *monodromy,
                      const double *x)
{
	for (int s = 0; s < work->ns; s++)
		for (int f = 0; f < work->nf; f++) {
			double d = damping_at(work, monodromy->slow[s], monodromy->fast[f]);

			if (d != 0.0)
				cblas_daxpy(work->ns, -d, x + (size_t)f*work->ns, 1,
				            out + (size_t)s*work->ns, 1);
		}
}

/* The equations at one phase, solved for x''; returns 1 if 1 + G'G is singular. */
static void transpose(double *square, int n)
{
	for (int i = 0; i < n; i++)
		for (int j = 0; j < i; j++) {
			double keep = square[i*n + j];

			square[i*n + j] = square[j*n + i];
			square[j*n + i] = keep;
		}
}

/* C and B multiplied by the inverse of an M that is not symmetric; returns 1 if it is singular. */
static int solve_inertia(struct work *work, double *C, double *B)
{
	int ns = work->ns;

	transpose(work->M, ns);
	transpose(C, ns);
	transpose(B, ns);
	if (LAPACKE_dgetrf_work(LAPACK_COL_MAJOR, ns, ns, work->M, ns, work->pivot) ||
	    LAPACKE_dgetrs_work(LAPACK_COL_MAJOR, 'N', ns, ns, work->M, ns, work->pivot, C, ns) ||
	    LAPACKE_dgetrs_work(LAPACK_COL_MAJOR, 'N', ns, ns, work->M, ns, work->pivot, B, ns))
		return 1;
	transpose(C, ns);
	transpose(B, ns);
	return 0;
}

static int reduce(struct work *work, const struct hawser__monodromy *monodromy,
                  const struct hawser__variational *system, int row)
{
	int n = work->n, ns = work->ns, nf = work->nf;
	size_t at = (size_t)row*nf*ns, square = (size_t)ns*ns;
	const double *K = work->K + (size_t)row*n*n;
	const double *G = work->G + at, *dG = work->dG + at, *ddG = work->ddG + at;
	const double *left = work->left + at;
	double *C = work->C + row*square, *B = work->B + row*square;

	damping_of(work, system, row);
	memset(work->M, 0, square*sizeof(double));
	for (int s = 0; s < ns; s++) {
		work->M[s*ns + s] = 1.0;
		for (int t = 0; t < ns; t++) {
			B[s*ns + t] = K[(size_t)monodromy->slow[s]*n + monodromy->slow[t]];
			C[s*ns + t] = damping_at(work, monodromy->slow[s], monodromy->slow[t]);
		}
	}
	add_transposed(work->M, 1.0, left, G, work);
	add_transposed(C, 2.0, left, dG, work);
	damp_slow(C, work, monodromy, G);
	damp_fast(work, monodromy, G, 1);
	add_transposed(C, 1.0, left, work->part, work);
	add_transposed(B, 1.0, left, ddG, work);
	damp_slow(B, work, monodromy, dG);
	damp_fast(work, monodromy, dG, 0);
	add_transposed(B, 1.0, left, work->part, work);
	/* left' K_fs = K_sf K_ff^-1 K_fs */
	for (int f = 0; f < nf; f++)
		for (int s = 0; s < ns; s++)
			work->part[f*ns + s] = K[(size_t)monodromy->fast[f]*n + monodromy->slow[s]];
	add_transposed(B, -1.0, left, work->part, work);
	if (work->pivot)
		return solve_inertia(work, C, B);
	/* M is symmetric: its upper triangle by columns is its lower one by rows, which LAPACKE would
	 * copy */
	return ns > 0 && (LAPACKE_dpotrf_work(LAPACK_COL_MAJOR, 'U', ns, work->M, ns) ||
	       (cblas_dtrsm(CblasRowMajor, CblasLeft, CblasLower, CblasNoTrans, CblasNonUnit, ns, ns,
	                    1.0, work->M, ns, C, ns),
	        cblas_dtrsm(CblasRowMajor, CblasLeft, CblasLower, CblasTrans, CblasNonUnit, ns, ns,
	                    1.0, work->M, ns, C, ns),
	        cblas_dtrsm(CblasRowMajor, CblasLeft, CblasLower, CblasNoTrans, CblasNonUnit, ns, ns,
	                    1.0, work->M, ns, B, ns),
	        cblas_dtrsm(CblasRowMajor, CblasLeft, CblasLower, CblasTrans, CblasNonUnit, ns, ns,
	                    1.0, work->M, ns, B, ns), 0));
}

static int condense(struct work *work, const struct hawser__monodromy *monodromy,
                    const struct hawser__variational *system)
{
	int n2 = work->n*work->n, rows = work->rows, block = work->nf*work->ns;
	int square = work->ns*work->ns;

	make_tables(work);
	cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, rows, n2, 2*system->order + 1, 1.0,
	            work->basis, work->columns, system->K, n2, 0.0, work->K, n2);
	for (int i = 0; i < rows; i++)
		if (work->pivot ? follow_both(work, monodromy, i) : follow(work, monodromy, i))
			return 1;
	cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, rows, block, rows, system->omega,
	            work->spectral, rows, work->G, block, 0.0, work->dG, block);
	cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, rows, block, rows, system->omega,
	            work->spectral, rows, work->dG, block, 0.0, work->ddG, block);
	for (int i = 0; i < rows; i++) {
		if (reduce(work, monodromy, system, i))
			return 1;
		work->basis[(size_t)i*work->columns] = 1.0; /* the constant is obtained twice */
	}
	cblas_dgemm(CblasRowMajor, CblasTrans, CblasNoTrans, 2*work->order + 1, square, rows,
	            2.0/rows, work->basis, work->columns, work->C, square, 0.0, work->D, square);
	cblas_dgemm(CblasRowMajor, CblasTrans, CblasNoTrans, 2*work->order + 1, square, rows,
	            2.0/rows, work->basis, work->columns, work->B, square, 0.0, work->T, square);
	return 0;
}

enum hawser_status hawser__monodromy_condense(struct hawser__monodromy *monodromy,
                                              struct hawser__variational *system, int *kept,
                                              struct hawser_report *report)
{
	int n = system->n;
	double top = 0.0, slowest = INFINITY, part;
	double limit = monodromy->sharper ? HAWSER__SHARPER : monodromy->rough ? HAWSER__ROUGHER
	               : monodromy->haste ? HAWSER__HASTE : HAWSER__NEGLECTED;
	struct work work = {.n = n};
	enum hawser_status status;

	*kept = n;
	monodromy->left_out = 0.0;
	monodromy->fastest = INFINITY;
	for (int j = 0; j < n; j++) {
		double w2 = 0.5*system->K[(size_t)j*(n + 1)];

		monodromy->frequency[j] = sqrt(fmax(w2, system->omega*system->omega));
		top = fmax(top, monodromy->frequency[j]);
		slowest = fmin(slowest, monodromy->frequency[j]);
	}
	if (top < monodromy->follow*system->omega)
		return HAWSER_OK;
	hawser__fast_find_range(monodromy, system);
	if (monodromy->finer) /* if Omega is far below all coordinates, the slowest are integrated */
		monodromy->fastest = fmax(monodromy->fastest, slowest);
	if (monodromy->haste) /* a strict computation includes the inertia of slow motions beyond their
	                       * resonance */
		monodromy->fastest += ASIDE*system->omega;
	if (system->order_d > 0 || !hawser__fast_symmetric(system)) {
		if (!monodromy->rough)
			return HAWSER_OK;
		work.pivot = monodromy->pivot;
	}
	for (int j = 0; j < n; j++)
		if ((part = hawser__fast_neglects(monodromy, system, j)) < limit) {
			monodromy->fast[work.nf++] = j;
			monodromy->left_out += part;
		} else {
			monodromy->slow[work.ns++] = j;
		}
	if (work.nf == 0 || work.ns == 0 || !hawser__fast_separate(monodromy, system, work.nf))
		return HAWSER_OK;
	work.order = system->order > system->order_d ? system->order : system->order_d;
	work.order *= monodromy->haste && !monodromy->rough ? 6 : 2;
	work.columns = 2*work.order + 1; /* G has infinitely many harmonics */
	work.rows = 2*work.order + 1; /* an odd number */
	if ((status = make_room(&work, monodromy, report)))
		return status;
	if (condense(&work, monodromy, system)) {
		if (monodromy->finer)
			return HAWSER_OK;
		return hawser__fail(report, HAWSER_ERR_CONVERGENCE, "floquet",
		                    "the stiffness of the fast coordinates is singular at some phase of "
		                    "the motion at Omega %g: keep fewer modes", system->omega);
	}
	*kept = work.ns;
	*system = (struct hawser__variational){.n = work.ns, .order = work.order,
		.order_d = work.order, .K = work.T, .D = work.D, .omega = system->omega};
	return HAWSER_OK;
}
