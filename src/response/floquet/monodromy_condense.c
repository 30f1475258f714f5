/* response/floquet/monodromy_condense.c - variational equations without the coordinates that are
 * too fast to matter.
 *
 *    s, f    slow and fast coordinates
 *    y       (x_s, x_s')
 *
 * A full-order model has longitudinal and high transverse coordinates with frequencies up to 1e4
 * times Omega. They follow the slow ones, and their own fast motion does not take part in an
 * instability: an instability is due to a harmonic k of K and two coordinates with
 * w_i + w_j = k Omega, and requires that |K_k|/(2 sqrt(w_i w_j)) exceeds the damping. The highest
 * such k gives the frequency W = (k + 1) Omega up to which coordinates matter.
 *
 * The motions in which the fast coordinates only follow are those of the slow manifold
 *
 *      x_f = F y,    x_s'' = -N y,    N = [K_ss D_ss] + K_sf F + D_sf F_1
 *
 * with x_f' = F_1 y and x_f'' = F_2 y:
 *
 *      F_1 = F' + F Y,    F_2 = F_1' + F_1 Y,    y' = Y y,    Y = [0 1; -N]
 *
 * and the equations of the fast coordinates determine F:
 *
 *      K_ff F = -[K_fs D_fs] - D_ff F_1 - F_2
 *
 * F is computed by iteration of this equation, from the static response F = [-K_ff^-1 K_fs, 0]. Each
 * iteration reduces the error by the factor (w_s/w_f)^2, w_s the frequency of the fastest slow
 * coordinate and w_f that of the slowest fast one. The change of N in the last iteration is the
 * estimated error. The equations are exact for multipliers of motions in the manifold: K need not
 * be symmetric, and D may vary. F is computed at equidistant phases and differentiated by Fourier
 * transforms.
 *
 * Since coupling changes the frequencies of the fast coordinates, all their combinations are
 * examined: if one of them is slow or has no positive stiffness, no coordinate is condensed. If the
 * iteration does not converge, more coordinates are kept.
 *
 * If all frequencies are below `follow` times Omega, no coordinate is condensed.
 *
 * Reference: Chang, SIAM J. Math. Anal. 3 (1972), for the decoupling of fast and slow motions of
 * linear equations with variable coefficients.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <cblas.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "response/floquet/monodromy.h"
#include "response/time/planner.h"

#define SINGULAR 1e-8      /* ratio of a pivot of K_ff to the mean below which it counts as 0: far
                            * above round-off */
#define ITERATIONS 12      /* largest number; chosen */
#define SETTLED 1e-9       /* relative change of N at which the iteration ends; chosen, far below the
                            * errors that are admitted */
#define SETTLED_FAR 1e-6   /* the same for a model with rest: its iterations are long, and the
                            * errors of events are those of sharper multipliers; chosen */
#define SLIGHT 0.1         /* part of these errors by harmonics of N that are left out; chosen */
#define MORE 6             /* harmonics of N beyond twice those of K; chosen */
#define ASIDE 1.0          /* harmonics beyond the highest resonance that a hasty computation
                            * includes; chosen */

/* The coordinates of all matrices are ordered: the slow ones first. */
struct work {
	int n, ns, nf, rows, order; /* order of the result */
	int symmetric;              /* 1: K is, and D is constant */
	int *pivot;                 /* [n] */
	double *basis;              /* [rows][2 order + 1] */
	double *sorted;             /* [2 order + 1][n][n] coefficients of K or D */
	double *K, *D;              /* [rows][n][n]; D: [1][n][n] if it is constant */
	size_t next_D;              /* n^2, or 0 if D is constant */
	double *F, *F1, *rate;      /* [rows][nf][2 ns]; rate: time derivative of one of them */
	double *N, *before;         /* [rows][ns][2 ns] of this and the last iteration */
	double *inverse;            /* [rows][nf][nf] of K_ff */
	double *part;               /* [nf][2 ns] */
	double *series;             /* [2 order + 1][ns][2 ns] of N */
	double *result[2];          /* [2 order + 1][ns][ns] K and D of the slow coordinates */
	double last;                /* size of the last harmonic of N, relative as in reduce() */
};

enum hawser_status hawser__monodromy_room(struct hawser__monodromy *monodromy, size_t need,
                                          struct hawser_report *report)
{
	if (need <= monodromy->room_size)
		return HAWSER_OK;
	free(monodromy->room);
	monodromy->room = malloc(2*need*sizeof(double));
	monodromy->room_size = monodromy->room ? 2*need : 0;
	return monodromy->room ? HAWSER_OK : hawser__no_memory(report, "orbit");
}

static enum hawser_status make_room(struct work *work, struct hawser__monodromy *monodromy,
                                    struct hawser_report *report)
{
	size_t n = (size_t)work->n, ns = (size_t)work->ns, nf = (size_t)work->nf;
	size_t rows = (size_t)work->rows, wide = 2*(size_t)work->order + 1;
	struct {
		double **at;
		size_t size;
	} part[] = {
		{&work->basis, rows*wide},      {&work->sorted, wide*n*n},
		{&work->K, rows*n*n},           {&work->D, (work->next_D ? rows : 1)*n*n},
		{&work->F, 2*rows*nf*ns},       {&work->F1, 2*rows*nf*ns},
		{&work->rate, 2*rows*nf*ns},    {&work->N, 2*rows*ns*ns},
		{&work->before, 2*rows*ns*ns},  {&work->inverse, rows*nf*nf},
		{&work->part, 2*nf*ns + nf},    {&work->series, 2*wide*ns*ns},
		{&work->result[0], wide*ns*ns}, {&work->result[1], wide*ns*ns},
	};
	size_t need = 0, count = sizeof part/sizeof part[0];

	for (size_t p = 0; p < count; p++)
		need += part[p].size;
	if (hawser__monodromy_room(monodromy, need, report))
		return HAWSER_ERR_MEMORY;
	if (hawser__differentiate_prepare(&monodromy->rates, work->rows, 2*work->nf*work->ns))
		return hawser__no_memory(report, "orbit");
	for (size_t p = 0, begin = 0; p < count; begin += part[p++].size)
		*part[p].at = monodromy->room + begin;
	return HAWSER_OK;
}

/* A series of n by n matrices at `rows` phases, with sorted coordinates. */
static void sample(const struct work *work, double *value, int rows, const double *series, int order,
                   const int *slow, const int *fast)
{
	int n = work->n, ns = work->ns;

	for (int r = 0; r <= 2*order; r++)
		for (int i = 0; i < n; i++)
			for (int j = 0; j < n; j++) {
				int p = i < ns ? slow[i] : fast[i - ns];
				int q = j < ns ? slow[j] : fast[j - ns];

				work->sorted[((size_t)r*n + i)*n + j] =
					series[((size_t)r*n + p)*n + q];
			}
	cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, rows, n*n, 2*order + 1, 1.0,
	            work->basis, 2*work->order + 1, work->sorted, n*n, 0.0, value, n*n);
}

/* Whether the pivots of K_ff at one phase, in its factor U, are safely positive. The mean of K_ff
 * is positive (hawser__fast_separate), so that if K_ff is not positive at one phase, it is singular
 * at another. A pivot that is 0 but for round-off must not count as positive with any BLAS kernel:
 * the limit is far above the round-off of the largest entry. */
static int positive(const double *factor, const struct hawser__monodromy *monodromy, int nf)
{
	for (int f = 0; f < nf; f++) {
		double mean = monodromy->frequency[monodromy->fast[f]], pivot = factor[f*nf + f];

		if (!(pivot*pivot > SINGULAR*mean*mean))
			return 0;
	}
	return 1;
}

/* The inverse of K_ff at one phase; returns 1 if K_ff is singular, or symmetric and not positive. */
static int invert(const struct work *work, const struct hawser__monodromy *monodromy, int row)
{
	int n = work->n, ns = work->ns, nf = work->nf;
	const double *K_ff = work->K + (size_t)row*n*n + (size_t)ns*n + ns;
	double *inverse = work->inverse + (size_t)row*nf*nf;

	for (int f = 0; f < nf; f++)
		memcpy(inverse + (size_t)f*nf, K_ff + (size_t)f*n, nf*sizeof(double));
	if (!work->symmetric) /* the transpose of the inverse is the inverse of the transpose */
		return LAPACKE_dgetrf_work(LAPACK_COL_MAJOR, nf, nf, inverse, nf, work->pivot) ||
		       LAPACKE_dgetri_work(LAPACK_COL_MAJOR, nf, inverse, nf, work->pivot, work->part,
		                           nf);
	if (LAPACKE_dpotrf_work(LAPACK_COL_MAJOR, 'U', nf, inverse, nf) ||
	    !positive(inverse, monodromy, nf) ||
	    LAPACKE_dpotri_work(LAPACK_COL_MAJOR, 'U', nf, inverse, nf))
		return 1;
	for (int f = 0; f < nf; f++)
		for (int e = 0; e < f; e++)
			inverse[e*nf + f] = inverse[f*nf + e];
	return 0;
}

/* out [rows][columns] += factor a b; a has n columns a row, those of b and out are 2 ns apart. */
static void add_product(const struct work *work, double *out, double factor, const double *a, int rows,
                        int inner, const double *b)
{
	cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, rows, 2*work->ns, inner, factor, a,
	            work->n, b, 2*work->ns, 1.0, out, 2*work->ns);
}

/* N at one phase; returns its change relative to the squared frequency `top` (columns of x_s) and to
 * top (columns of x_s'). */
static double reduce(const struct work *work, int row, double top)
{
	int n = work->n, ns = work->ns, nf = work->nf;
	const double *K = work->K + (size_t)row*n*n, *D = work->D + row*work->next_D;
	double *N = work->N + 2*(size_t)row*ns*ns, *before = work->before + 2*(size_t)row*ns*ns;
	double change = 0.0;

	memcpy(before, N, 2*(size_t)ns*ns*sizeof(double));
	for (int s = 0; s < ns; s++) {
		memcpy(N + 2*(size_t)s*ns, K + (size_t)s*n, ns*sizeof(double));
		memcpy(N + 2*(size_t)s*ns + ns, D + (size_t)s*n, ns*sizeof(double));
	}
	add_product(work, N, 1.0, K + ns, ns, nf, work->F + 2*(size_t)row*nf*ns);
	add_product(work, N, 1.0, D + ns, ns, nf, work->F1 + 2*(size_t)row*nf*ns);
	for (int e = 0; e < 2*ns*ns; e++)
		change = fmax(change, fabs(N[e] - before[e])/(e%(2*ns) < ns ? top*top : top));
	return change;
}

/* out [nf][2 ns] = rate + F Y, the derivative of F y in time at one phase. */
static void derive(const struct work *work, double *out, const double *F, int row)
{
	int ns = work->ns, nf = work->nf;
	size_t at = 2*(size_t)row*nf*ns;

	if (out != work->rate + at)
		memcpy(out, work->rate + at, 2*(size_t)nf*ns*sizeof(double));
	for (int f = 0; f < nf; f++)
		cblas_daxpy(ns, 1.0, F + 2*(size_t)f*ns, 1, out + (2*(size_t)f + 1)*ns, 1);
	cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, nf, 2*ns, ns, -1.0, F + ns, 2*ns,
	            work->N + 2*(size_t)row*ns*ns, 2*ns, 1.0, out, 2*ns);
}

/* F at one phase from F_2 [nf][2 ns], which is overwritten, and F_1. */
static void follow(const struct work *work, double *F2, int row)
{
	int n = work->n, ns = work->ns, nf = work->nf;
	const double *K = work->K + (size_t)row*n*n + (size_t)ns*n;
	const double *D = work->D + row*work->next_D + (size_t)ns*n;
	size_t at = 2*(size_t)row*nf*ns;

	for (int f = 0; f < nf; f++) {
		cblas_daxpy(ns, 1.0, K + (size_t)f*n, 1, F2 + 2*(size_t)f*ns, 1);
		cblas_daxpy(ns, 1.0, D + (size_t)f*n, 1, F2 + (2*(size_t)f + 1)*ns, 1);
	}
	add_product(work, F2, 1.0, D + ns, nf, nf, work->F1 + at);
	cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, nf, 2*ns, nf, -1.0,
	            work->inverse + (size_t)row*nf*nf, nf, F2, 2*ns, 0.0, work->F + at, 2*ns);
}

/* The largest change of N over all phases. */
static double reduce_all(const struct work *work, double top)
{
	double change = 0.0;

	for (int i = 0; i < work->rows; i++)
		change = fmax(change, reduce(work, i, top));
	return change;
}

/* Iterates F from the static response, until N changes by less than `goal` or no longer less.
 * Returns the last change of N. */
static double settle(const struct work *work, const struct hawser__monodromy *monodromy,
                     double omega, double goal)
{
	size_t block = 2*(size_t)work->nf*work->ns;
	double change, last = INFINITY, top = monodromy->top;

	memset(work->N, 0, 2*(size_t)work->rows*work->ns*work->ns*sizeof(double));
	memset(work->F1, 0, work->rows*block*sizeof(double));
	for (int i = 0; i < work->rows; i++) {
		memset(work->part, 0, block*sizeof(double));
		follow(work, work->part, i);
		for (int f = 0; f < work->nf; f++) /* the static response has no part of x_s' */
			memset(work->F + i*block + (2*(size_t)f + 1)*work->ns, 0,
			       work->ns*sizeof(double));
	}
	reduce_all(work, top);
	for (int k = 0; k < ITERATIONS; k++) {
		hawser__differentiate(&monodromy->rates, work->rate, work->F, omega);
		for (int i = 0; i < work->rows; i++)
			derive(work, work->F1 + i*block, work->F + i*block, i);
		hawser__differentiate(&monodromy->rates, work->rate, work->F1, omega);
		for (int i = 0; i < work->rows; i++) {
			derive(work, work->rate + i*block, work->F1 + i*block, i);
			follow(work, work->rate + i*block, i);
		}
		change = reduce_all(work, top);
		if (change < goal || !(change < last))
			return change;
		last = change;
	}
	return last;
}

/* The number of harmonics of a series of ns by ns matrices without the last ones, whose sizes,
 * relative to `scale`, add up to at most `negligible`. Their sum is added to *left_out. */
static int count_harmonics(const double *series, const struct work *work, double scale,
                           double negligible, double *left_out)
{
	size_t block = (size_t)work->ns*work->ns;
	double sum = 0.0;

	for (int k = work->order; k > 0; k--) {
		const double *last = series + (2*(size_t)k - 1)*block;
		double part = 0.0;

		for (size_t e = 0; e < 2*block; e++)
			part = fmax(part, fabs(last[e]));
		if (sum + part/scale > negligible) {
			*left_out += sum;
			return k;
		}
		sum += part/scale;
	}
	*left_out += sum;
	return 0;
}

/* The series of K and D of the slow coordinates from N. Returns the size of the last harmonic,
 * relative as in reduce(). */
static double transform(const struct work *work, double top)
{
	int ns = work->ns, columns = 2*work->order + 1;
	double last = 0.0;

	for (int i = 0; i < work->rows; i++)
		work->basis[(size_t)i*columns] = 1.0; /* the constant is obtained twice */
	cblas_dgemm(CblasRowMajor, CblasTrans, CblasNoTrans, columns, 2*ns*ns, work->rows,
	            2.0/work->rows, work->basis, columns, work->N, 2*ns*ns, 0.0, work->series,
	            2*ns*ns);
	for (size_t r = 0; r < (size_t)columns*ns; r++)
		for (int side = 0; side < 2; side++)
			memcpy(work->result[side] + r*ns, work->series + (2*r + side)*ns,
			       ns*sizeof(double));
	for (size_t e = (size_t)(columns - 2)*ns*ns; e < (size_t)columns*ns*ns; e++)
		last = fmax(last, fmax(fabs(work->result[0][e])/(top*top),
		                       fabs(work->result[1][e])/top));
	return last;
}

/* Prepares the iteration; returns 1 if K_ff is singular or not positive at a phase. */
static int prepare(struct work *work, const struct hawser__monodromy *monodromy,
                   const struct hawser__variational *system)
{
	hawser__monodromy_phases(work->basis, work->rows, work->order);
	sample(work, work->K, work->rows, system->K, system->order, monodromy->slow, monodromy->fast);
	sample(work, work->D, work->next_D ? work->rows : 1, system->D, system->order_d,
	       monodromy->slow, monodromy->fast);
	for (int i = 0; i < work->rows; i++)
		if (invert(work, monodromy, i))
			return 1;
	return 0;
}

static double settled(const struct hawser__monodromy *monodromy)
{
	return monodromy->sharper ? 0.1*HAWSER__SHARPER : monodromy->rest ? SETTLED_FAR : SETTLED;
}

/* Condenses the coordinates that `limit` and the expected number of iterations allow. Sets
 * monodromy->left_out, infinite if nothing can be condensed; *work has the result. */
static enum hawser_status try_condense(struct work *work, struct hawser__monodromy *monodromy,
                                       const struct hawser__variational *system, double limit,
                                       int expected, struct hawser_report *report)
{
	enum hawser_status status;

	monodromy->left_out = INFINITY;
	work->last = 0.0;
	monodromy->top = hawser__fast_split(monodromy, system, limit, expected, &work->ns);
	work->nf = work->n - work->ns;
	if (work->nf == 0 || work->ns == 0 || !hawser__fast_separate(monodromy, system, work->nf))
		return HAWSER_OK;
	if ((status = make_room(work, monodromy, report)))
		return status;
	if (prepare(work, monodromy, system)) {
		if (monodromy->finer)
			return HAWSER_OK;
		return hawser__fail(report, HAWSER_ERR_CONVERGENCE, "floquet",
		                    "the stiffness of the fast coordinates is singular at some phase of "
		                    "the motion at Omega %g: keep fewer modes", system->omega);
	}
	monodromy->left_out = settle(work, monodromy, system->omega, settled(monodromy));
	work->last = transform(work, monodromy->top);
	monodromy->left_out += work->last;
	return HAWSER_OK;
}

/* N has infinitely many harmonics. Along a branch few of them beyond those of K are included first; if
 * the last of these is not negligible, as many as for comparison. */
static enum hawser_status try_orders(struct work *work, struct hawser__monodromy *monodromy,
                                     const struct hawser__variational *system, double limit,
                                     int expected, struct hawser_report *report)
{
	int order = system->order > system->order_d ? system->order : system->order_d;
	int most = MORE + order*(monodromy->haste && !monodromy->rough ? 6 : 2);
	enum hawser_status status;

	work->order = monodromy->finer || monodromy->sharper ? most : MORE + order + order/4;
	if (work->order > most)
		work->order = most;
	for (;;) {
		work->rows = hawser__planner_rows(2*work->order + 1);
		status = try_condense(work, monodromy, system, limit, expected, report);
		if (status || work->order >= most ||
		    !(work->last > fmax(SETTLED, settled(monodromy))))
			return status;
		work->order = most;
	}
}

enum hawser_status hawser__monodromy_condense(struct hawser__monodromy *monodromy,
                                              struct hawser__variational *system, int *kept,
                                              struct hawser_report *report)
{
	int n = system->n;
	double top = 0.0, slowest = INFINITY;
	double limit = monodromy->rough ? HAWSER__ROUGHER
	               : monodromy->rest && monodromy->sharper ? HAWSER__SHARPER
	               : monodromy->haste ? HAWSER__HASTE : HAWSER__NEGLECTED;
	double most = monodromy->sharper ? HAWSER__SHARPER : limit;
	struct work work = {.n = n, .pivot = monodromy->pivot};
	enum hawser_status status;

	*kept = n;
	monodromy->left_out = monodromy->neglected = 0.0;
	monodromy->fastest = INFINITY;
	for (int j = 0; j < n; j++) {
		double w2 = monodromy->rest ? monodromy->rest[(size_t)j*(n + 1)]
		                            : 0.5*system->K[(size_t)j*(n + 1)];

		monodromy->frequency[j] = sqrt(fmax(w2, system->omega*system->omega));
		top = fmax(top, monodromy->frequency[j]);
		slowest = fmin(slowest, monodromy->frequency[j]);
	}
	if (top < monodromy->follow*system->omega)
		return HAWSER_OK;
	if (!monodromy->rest)
		hawser__fast_find_range(monodromy, system);
	else if ((status = hawser__monodromy_resonances(monodromy, system, report)))
		return status;
	if (monodromy->finer) /* if Omega is far below all coordinates, the slowest are integrated */
		monodromy->fastest = fmax(monodromy->fastest, slowest);
	if (monodromy->haste) /* a strict computation includes the inertia of slow motions beyond their
	                       * resonance */
		monodromy->fastest += ASIDE*system->omega;
	work.symmetric = system->order_d == 0 && hawser__fast_symmetric(system);
	work.next_D = system->order_d > 0 ? (size_t)n*n : 0;
	for (int expected = monodromy->expected;; expected--) {
		status = try_orders(&work, monodromy, system, limit, expected, report);
		if (!monodromy->sharper) /* the next orbit is similar */
			monodromy->expected = expected;
		if (status || monodromy->left_out <= most || expected == 0)
			break;
	}
	if (status || monodromy->left_out > most)
		return status;
	*system = (struct hawser__variational){.n = work.ns, .K = work.result[0], .D = work.result[1],
		.omega = system->omega};
	most = SLIGHT*(monodromy->sharper ? HAWSER__SHARPER : settled(monodromy));
	system->order = count_harmonics(system->K, &work, monodromy->top*monodromy->top, most,
	                                &monodromy->left_out);
	system->order_d = count_harmonics(system->D, &work, monodromy->top, most,
	                                  &monodromy->left_out);
	monodromy->neglected = M_PI*monodromy->top/system->omega*monodromy->left_out;
	*kept = work.ns;
	return HAWSER_OK;
}
