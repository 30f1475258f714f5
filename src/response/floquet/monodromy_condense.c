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
 * be symmetric, and D may vary. F is computed at equidistant phases and differentiated as the
 * trigonometric polynomial through them, by a matrix: so many functions at so few phases take less
 * time than with fast transforms.
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
#include <cblas.h>
#include <lapacke.h>
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "response/floquet/condensation.h"

#define SETTLED 1e-9       /* relative change of N at which the iteration ends; chosen, far below the
                            * errors that are admitted */
#define SETTLED_FAR 1e-5   /* the same for a model with rest: its iterations are long, and the
                            * errors of events are those of sharper multipliers; chosen */
#define SLIGHT 0.1         /* part of these errors by harmonics of N that are left out; chosen */
#define MORE 6             /* harmonics of N beyond twice those of K; chosen */
#define GUESS 10.0         /* of a model with rest: expected error up to which coordinates are tried,
                            * over the admitted one. It is mostly far above the error of the
                            * iteration, which decides; chosen */
#define LEVEL 10.0         /* factor on GUESS from a level to the next higher one
                            * (hawser__monodromy.expected); chosen */
#define LOWEST (-3)        /* level, where few coordinates are condensed; chosen */
#define HIGHEST (HAWSER__EXPECTED + 2) /* level of a model with rest; chosen */
#define STAY 32            /* orbits before a higher level is tried, after one was too high; chosen */
#define BEARABLE 1e-2      /* largest error of a model with rest: steps that do not resolve its fast
                            * coordinates are worse; chosen */
#define ASIDE 1.0          /* harmonics beyond the highest resonance that a hasty computation
                            * includes; chosen */

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

/* Sorts the coordinates of a list by their components. */
static void sort(int *list, int count, const int *part)
{
	for (int i = 1; i < count; i++) {
		int own = list[i], j = i;

		for (; j > 0 && part[list[j - 1]] > part[own]; j--)
			list[j] = list[j - 1];
		list[j] = own;
	}
}

/* The number of coordinates of a list from `first` on that are of one component. */
static int run_of(const int *list, int first, int count, const int *part, int own)
{
	int end = first;

	while (end < count && part[list[end]] == own)
		end++;
	return end - first;
}

/* The blocks of the coordinates, which are sorted by them. A block of none but fast ones matters to
 * no other. */
static void divide(struct hawser__condensation *work, struct hawser__monodromy *monodromy)
{
	int s = 0, f = 0;

	sort(monodromy->slow, work->ns, monodromy->part);
	sort(monodromy->fast, work->nf, monodromy->part);
	work->blocks = 0;
	work->wide_F = work->wide_N = 0;
	while (s < work->ns || f < work->nf) {
		int of_slow = s < work->ns ? monodromy->part[monodromy->slow[s]] : INT_MAX;
		int of_fast = f < work->nf ? monodromy->part[monodromy->fast[f]] : INT_MAX;
		int own = of_slow < of_fast ? of_slow : of_fast;
		struct hawser__block *block = &work->block[work->blocks++];

		*block = (struct hawser__block){
			.ns = run_of(monodromy->slow, s, work->ns, monodromy->part, own),
			.nf = run_of(monodromy->fast, f, work->nf, monodromy->part, own),
			.s = s, .f = f, .F = work->wide_F, .N = work->wide_N,
		};
		s += block->ns;
		f += block->nf;
		work->wide_F += 2*(size_t)block->nf*block->ns;
		work->wide_N += 2*(size_t)block->ns*block->ns;
	}
}

static enum hawser_status make_room(struct hawser__condensation *work,
                                    struct hawser__monodromy *monodromy,
                                    struct hawser_report *report)
{
	size_t n = (size_t)work->n, ns = (size_t)work->ns, nf = (size_t)work->nf;
	size_t rows = (size_t)work->rows, wide = (size_t)work->columns;
	struct {
		double **at;
		size_t size;
	} part[] = {
		{&work->basis, rows*wide},         {&work->turn, rows*rows},
		{&work->sorted, wide*n*n},
		{&work->K, rows*n*n},              {&work->D, (work->next_D ? rows : 1)*n*n},
		{&work->F, rows*work->wide_F},     {&work->F1, rows*work->wide_F},
		{&work->rate, rows*work->wide_F},  {&work->N, rows*work->wide_N},
		{&work->before, rows*work->wide_N}, {&work->inverse, rows*nf*nf},
		{&work->part, nf},                 {&work->series, wide*work->wide_N},
		{&work->result[0], wide*ns*ns},    {&work->result[1], wide*ns*ns},
	};
	size_t need = 0, count = sizeof part/sizeof part[0];

	for (size_t p = 0; p < count; p++)
		need += part[p].size;
	if (hawser__monodromy_room(monodromy, need, report))
		return HAWSER_ERR_MEMORY;
	for (size_t p = 0, begin = 0; p < count; begin += part[p++].size)
		*part[p].at = monodromy->room + begin;
	return HAWSER_OK;
}

/* A series of n by n matrices at `rows` phases, with sorted coordinates. */
static void sample(const struct hawser__condensation *work, double *value, int rows,
                   const double *series, int order, const int *slow, const int *fast)
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
	            work->basis, work->columns, work->sorted, n*n, 0.0, value, n*n);
}

/* The number of harmonics of a series of ns by ns matrices without the last ones, whose sizes,
 * relative to `scale`, add up to at most `negligible`. Their sum is added to *left_out. */
static int count_harmonics(const double *series, const struct hawser__condensation *work,
                           double scale, double negligible, double *left_out)
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
static double transform(const struct hawser__condensation *work, double top)
{
	int ns = work->ns, columns = 2*work->order + 1, wide = (int)work->wide_N;
	double last = 0.0;

	for (int i = 0; i < work->rows; i++)
		work->basis[(size_t)i*work->columns] = 1.0; /* the constant is obtained twice */
	cblas_dgemm(CblasRowMajor, CblasTrans, CblasNoTrans, columns, wide, work->rows, 2.0/work->rows,
	            work->basis, work->columns, work->N, wide, 0.0, work->series, wide);
	for (int side = 0; side < 2; side++)
		memset(work->result[side], 0, (size_t)columns*ns*ns*sizeof(double));
	for (int b = 0; b < work->blocks; b++) {
		const struct hawser__block *block = &work->block[b];

		for (int row = 0; row < 2*columns*block->ns; row++) { /* of K, D, K, ... */
			int r = row/2/block->ns, s = row/2%block->ns;

			memcpy(work->result[row%2] + ((size_t)r*ns + block->s + s)*ns + block->s,
			       work->series + (size_t)r*wide + block->N + (2*(size_t)s + row%2)*block->ns,
			       block->ns*sizeof(double));
		}
	}
	for (size_t e = (size_t)(columns - 2)*ns*ns; e < (size_t)columns*ns*ns; e++)
		last = fmax(last, fmax(fabs(work->result[0][e])/(top*top),
		                       fabs(work->result[1][e])/top));
	return last;
}

/* work->turn: half a cotangent of half the angle with an even number of phases, where the highest sine
 * is not sampled, and half a cosecant with an odd one (Trefethen, Spectral Methods in MATLAB, 2000,
 * ch. 3). */
static void fill_turn(const struct hawser__condensation *work)
{
	int rows = work->rows;

	for (int apart = 0; apart < rows; apart++) {
		double half = M_PI*apart/rows, sign = apart%2 ? -0.5 : 0.5;
		double value = apart == 0 ? 0.0 : sign*(rows%2 ? 1.0/sin(half) : 1.0/tan(half));

		for (int i = 0; i < rows; i++)
			work->turn[(size_t)((i + apart)%rows)*rows + i] = value;
	}
}

/* Whether D [n][n] couples no coordinates. */
static int is_diagonal(const double *D, int n)
{
	for (int e = 0; e < n*n; e++)
		if (D[e] != 0.0 && e%(n + 1) != 0)
			return 0;
	return 1;
}

/* Prepares the iteration; returns 1 if K_ff is singular or not positive at a phase. */
static int prepare(struct hawser__condensation *work, const struct hawser__monodromy *monodromy,
                   const struct hawser__variational *system)
{
	hawser__monodromy_phases(work->basis, work->rows, (work->columns - 1)/2);
	fill_turn(work);
	sample(work, work->K, work->rows, system->K, system->order, monodromy->slow, monodromy->fast);
	sample(work, work->D, work->next_D ? work->rows : 1, system->D, system->order_d,
	       monodromy->slow, monodromy->fast);
	work->apart = !work->next_D && is_diagonal(work->D, work->n);
	for (int i = 0; i < work->rows; i++)
		for (int b = 0; b < work->blocks; b++)
			if (work->block[b].nf > 0 && hawser__condense_invert(work, monodromy, &work->block[b], i))
				return 1;
	return 0;
}

static double settled(const struct hawser__monodromy *monodromy)
{
	return monodromy->sharper ? 0.1*HAWSER__SHARPER : monodromy->rest ? SETTLED_FAR : SETTLED;
}

/* Condenses the fast coordinates. Sets monodromy->left_out, infinite if nothing can be condensed, or
 * work->singular; *work has the result. */
static enum hawser_status try_condense(struct hawser__condensation *work,
                                       struct hawser__monodromy *monodromy,
                                       const struct hawser__variational *system,
                                       struct hawser_report *report)
{
	enum hawser_status status;

	monodromy->left_out = INFINITY;
	work->last = 0.0;
	if (work->nf == 0 || work->ns == 0 || !hawser__fast_separate(monodromy, system, work->nf))
		return HAWSER_OK;
	divide(work, monodromy);
	if ((status = make_room(work, monodromy, report)))
		return status;
	if (prepare(work, monodromy, system)) {
		work->singular = 1;
		return HAWSER_OK;
	}
	monodromy->left_out = hawser__condense_settle(work, monodromy, system->omega, settled(monodromy));
	work->last = transform(work, monodromy->top);
	monodromy->left_out += work->last;
	return HAWSER_OK;
}

/* N has infinitely many harmonics. Along a branch as many are included first as the last N needed,
 * which may be fewer than K has; there and in haste a few beyond those of K, and as many as for
 * comparison where the last ones are not negligible. The matrices at the phases have all harmonics of
 * K: fewer phases leave out nothing but harmonics of F. */
static enum hawser_status try_orders(struct hawser__condensation *work,
                                     struct hawser__monodromy *monodromy,
                                     const struct hawser__variational *system,
                                     struct hawser_report *report)
{
	int order = system->order > system->order_d ? system->order : system->order_d;
	int most = MORE + order*(monodromy->haste && !monodromy->rough ? 6 : 2);
	int strict = (monodromy->finer && !monodromy->haste) || monodromy->sharper;
	int usual = strict ? most : (int)fmin(MORE + order + order/4, most);
	double negligible = fmax(SETTLED, settled(monodromy));
	enum hawser_status status;

	work->order = strict || monodromy->finer || monodromy->needed == 0
	              ? usual : (int)fmin(monodromy->needed + MORE, usual);
	for (;;) {
		int fewer = work->order < usual;

		work->columns = 2*(work->order > order ? work->order : order) + 1;
		work->rows = 2*work->order + 1;
		status = try_condense(work, monodromy, system, report);
		if (status || work->order >= most || !(work->last > (fewer ? SLIGHT : 1.0)*negligible))
			return status;
		work->order = fewer ? usual : most;
	}
}

/* The slow and fast coordinates of a level. */
static void split(struct hawser__condensation *work, struct hawser__monodromy *monodromy,
                  const struct hawser__variational *system, double limit, int level)
{
	int expected = level < 0 ? 0 : level < HAWSER__EXPECTED ? level : HAWSER__EXPECTED;

	monodromy->top = hawser__fast_split(monodromy, system, limit*pow(LEVEL, level - expected),
	                                    expected, &work->ns);
	work->nf = work->n - work->ns;
}

/* Levels downwards until the error is at most `most`, or the one of the least error. The first is that
 * of the last orbit, since the next one is similar, or a higher one. */
static enum hawser_status descend(struct hawser__condensation *work,
                                  struct hawser__monodromy *monodromy,
                                  const struct hawser__variational *system, double limit, double most,
                                  struct hawser_report *report)
{
	int along = monodromy->rest && !monodromy->sharper, lowest = along ? LOWEST : 0, tried = -1;
	int higher = along && monodromy->stay == 0 && monodromy->expected < HIGHEST;
	int begin = (int)fmax(lowest, monodromy->expected + higher), level = begin, best = begin;
	double least = INFINITY;
	enum hawser_status status = HAWSER_OK;

	for (;; level--) {
		split(work, monodromy, system, limit, level);
		if (work->ns != tried)
			status = try_orders(work, monodromy, system, report);
		tried = work->ns;
		if (monodromy->left_out < least) {
			least = monodromy->left_out;
			best = level;
		}
		if (status || least <= most || level == lowest || work->nf == 0)
			break;
	}
	if (!status && monodromy->left_out > least) {
		split(work, monodromy, system, limit, level = best);
		status = try_orders(work, monodromy, system, report);
	}
	if (along)
		monodromy->stay = level < begin ? STAY : monodromy->stay > 0 ? monodromy->stay - 1 : 0;
	if (!monodromy->sharper)
		monodromy->expected = level;
	return status;
}

/* Factor from harmonics of K that are left out, relative to two frequencies, to the error of N,
 * relative to the squared frequency `top`. */
static double reach_of(const struct hawser__condensation *work,
                       const struct hawser__monodromy *monodromy)
{
	double most = 0.0;

	for (int row = 0; row < work->rows; row++)
		for (int b = 0; b < work->blocks; b++) {
			const struct hawser__block *block = &work->block[b];
			const double *F = work->F + (size_t)row*work->wide_F + block->F;

			for (int s = 0; s < block->ns; s++) {
				double sum = monodromy->frequency[monodromy->slow[block->s + s]];

				for (int f = 0; f < block->nf; f++)
					sum += fabs(F[2*(size_t)f*block->ns + s])*
					       monodromy->frequency[monodromy->fast[block->f + f]];
				most = fmax(most, sum/monodromy->top);
			}
		}
	return most*most;
}

/* The highest frequency of a coordinate that vibrates: an overdamped one has none to be resolved. */
static double fastest_of(const struct hawser__monodromy *monodromy,
                         const struct hawser__variational *system)
{
	double top = 0.0;

	for (int j = 0; j < system->n; j++)
		if (0.25*system->D[(size_t)j*(system->n + 1)] < monodromy->frequency[j])
			top = fmax(top, monodromy->frequency[j]);
	return top;
}

enum hawser_status hawser__monodromy_condense(struct hawser__monodromy *monodromy,
                                            struct hawser__variational *system, int *kept,
                                            struct hawser_report *report)
{
	int n = system->n, order = system->order;
	double top = 0.0, slowest = INFINITY, noise = monodromy->sharper ? 0.0 : SLIGHT*settled(monodromy);
	double limit = monodromy->rough ? HAWSER__ROUGHER
	               : monodromy->rest && monodromy->sharper ? HAWSER__SHARPER
	               : monodromy->haste ? HAWSER__HASTE : HAWSER__NEGLECTED;
	double guess = monodromy->rest && !monodromy->sharper ? GUESS : 1.0;
	double most = monodromy->sharper ? HAWSER__SHARPER : limit;
	struct hawser__condensation work = {.n = n, .pivot = monodromy->pivot, .block = monodromy->block};
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
	else if ((status = hawser__monodromy_resonances(monodromy, system, &noise, report)))
		return status;
	if (monodromy->finer) /* if Omega is far below all coordinates, the slowest are integrated */
		monodromy->fastest = fmax(monodromy->fastest, slowest);
	if (monodromy->haste) /* a strict computation includes the inertia of slow motions beyond their
	                       * resonance */
		monodromy->fastest += ASIDE*system->omega;
	work.symmetric = system->order_d == 0 && hawser__fast_symmetric(system->K, system->order, n);
	work.next_D = system->order_d > 0 ? (size_t)n*n : 0;
	status = descend(&work, monodromy, system, guess*limit, most, report);
	if (status)
		return status;
	if (monodromy->left_out > (monodromy->rest && !monodromy->sharper ? BEARABLE : most)) {
		monodromy->top = fastest_of(monodromy, system);
		system->order = monodromy->rest ? order : system->order;
		if (!work.singular || monodromy->finer)
			return HAWSER_OK;
		return hawser__fail(report, HAWSER_ERR_CONVERGENCE, "floquet",
		                    "the stiffness of the fast coordinates is singular at some phase of "
		                    "the motion at Omega %g: keep fewer modes", system->omega);
	}
	if (monodromy->rest && !monodromy->sharper)
		monodromy->left_out += noise*reach_of(&work, monodromy);
	*system = (struct hawser__variational){.n = work.ns, .K = work.result[0], .D = work.result[1],
		.omega = system->omega};
	most = SLIGHT*(monodromy->sharper ? HAWSER__SHARPER : settled(monodromy));
	system->order = count_harmonics(system->K, &work, monodromy->top*monodromy->top, most,
	                                &monodromy->left_out);
	system->order_d = count_harmonics(system->D, &work, monodromy->top, most,
	                                  &monodromy->left_out);
	monodromy->neglected = M_PI*monodromy->top/system->omega*monodromy->left_out;
	if (!monodromy->sharper)
		monodromy->needed = system->order > system->order_d ? system->order : system->order_d;
	*kept = work.ns;
	return HAWSER_OK;
}
