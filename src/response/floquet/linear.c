/* response/floquet/linear.c - eigenvalues about rest, and Floquet multipliers of Hill's equation.
 *
 *    w      frequencies by which displacements are scaled: for (w u, u') the matrix of an undamped
 *           oscillator is skew, and LAPACK finds its eigenvalues to the last bits
 *    z      angle in rad that the fastest coordinate turns in a step of the collocation
 *
 * The multipliers are computed by monodromy.h. Along a branch its number of steps follows from the
 * previous point. Here it is chosen anew for each model, from the highest frequency and the
 * strongest damping, so that no result depends on previous computations.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <float.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/linear.h>

#include "core/order.h"
#include "core/report.h"
#include "response/floquet/linear_margin.h"
#include "response/floquet/monodromy.h"
#include "rom/build/build.h"
#include "rom/file/entries.h"
#include "rom/terms/terms.h"

#define BLOCK 34      /* dgeev's workspace divided by the order: blocks of 32; also the samples of
                       * estimate() */
#define SAMPLES 3     /* further computations of the multipliers for their error estimate */
/* A multiplier counts as outside if the logarithm of its modulus exceeds this and its error. A map
 * extrapolates from there to the boundary (study/map/map_doubt.c), for which it is well above most
 * errors. */
#define COUNTS 1e-8
#define GROWS 1e-8    /* smallest growth that counts, relative to the largest modulus: round-off of
                       * two eigenvalues that nearly coincide */

#define NOTHING 1e-13 /* smaller growth, relative to the largest modulus, is round-off and set to 0 */

struct hawser_linear {
	int n, finer;
	double *matrix;        /* [2n][2n] column-major */
	double *re, *im;       /* [2n] */
	double *scale;         /* [n] w */
	double *work;          /* [BLOCK 2n] */
	double *frequency;     /* [n] */
	double *series;        /* [2 order + 1][n][n] K as a Fourier series */
	size_t room;           /* number of doubles allocated for series */
	double margin[2];      /* of the last call: see linear_margin.h */
	double *bound;         /* [2n] growth above which a rate counts */
	struct hawser__circle circle;
	struct hawser__monodromy monodromy;
};

enum hawser_status hawser_linear_open(struct hawser_linear **linear, int n,
                                      struct hawser_report *report)
{
	struct hawser_linear *l = calloc(1, sizeof *l);
	size_t m = 2*(size_t)n;

	*linear = NULL;
	if (!l)
		return hawser__no_memory(report, "linear");
	l->n = n;
	l->finer = 1;
	l->matrix = calloc(m*m + 3*m + m + BLOCK*m, sizeof *l->matrix);
	if (!l->matrix || hawser__monodromy_init(&l->monodromy, n, report)) {
		free(l->matrix);
		free(l);
		return hawser__no_memory(report, "linear");
	}
	l->re = l->matrix + m*m;
	l->im = l->re + m;
	l->bound = l->im + m;
	l->scale = l->bound + m;
	l->frequency = l->scale + n;
	l->work = l->frequency + n;
	*linear = l;
	return HAWSER_OK;
}

void hawser_linear_free(struct hawser_linear *linear)
{
	if (!linear)
		return;
	hawser__monodromy_release(&linear->monodromy);
	free(linear->series);
	free(linear->matrix);
	free(linear);
}

void hawser_linear_refine(struct hawser_linear *linear, int finer)
{
	linear->finer = finer > 1 ? finer : 1;
}

void hawser__linear_haste(struct hawser_linear *linear, int on)
{
	linear->monodromy.hasty = on;
}

enum hawser_status hawser__linear_rough(struct hawser_linear *linear, double *log_modulus,
                                        double *argument, int *m, const struct hawser_rom *rom,
                                        double omega, struct hawser_report *report)
{
	int finer = linear->finer;
	enum hawser_status status;

	linear->monodromy.rough = linear->finer = 1;
	status = hawser_linear_multipliers(linear, log_modulus, argument, NULL, rom, omega, report);
	*m = 2*linear->monodromy.kept;
	linear->monodromy.rough = 0;
	linear->finer = finer;
	return status;
}

int hawser__linear_kept(const struct hawser_linear *linear, double *neglected)
{
	*neglected = linear->monodromy.neglected;
	return linear->monodromy.kept;
}

void hawser__linear_margin(const struct hawser_linear *linear, double margin[2])
{
	margin[0] = linear->margin[0];
	margin[1] = linear->margin[1];
}

struct hawser__circle hawser__linear_circle(const struct hawser_linear *linear)
{
	return linear->circle;
}

/* Margins from rates [2n] that have the error `error` and count above l->bound. */
static void keep_margin(struct hawser_linear *l, const double *rate, double error)
{
	double least = HUGE_VAL, most = -HUGE_VAL;

	for (int i = 0; i < 2*l->n; i++) {
		if (rate[i] > l->bound[i])
			least = fmin(least, rate[i]);
		else
			most = fmax(most, rate[i]);
	}
	l->margin[0] = least - error;
	l->margin[1] = most + error;
}

/* [0 w; -K/w -D], column-major. */
static void fill(struct hawser_linear *l, const struct hawser_rom *rom)
{
	int n = rom->n, m = 2*n;

	memset(l->matrix, 0, (size_t)m*m*sizeof *l->matrix);
	for (int q = 0; q < n; q++) {
		double diagonal = fabs(rom->K[q*n + q]);

		l->scale[q] = diagonal > 0.0 ? sqrt(diagonal) : 1.0;
		l->matrix[(size_t)(n + q)*m + q] = l->scale[q];
		for (int p = 0; p < n; p++) {
			l->matrix[(size_t)q*m + n + p] = -rom->K[p*n + q]/l->scale[q];
			l->matrix[(size_t)(n + q)*m + n + p] = -rom->D[p*n + q];
		}
	}
}

/* One frequency per pair, ascending; real eigenvalues give zeros. */
static void read_frequencies(struct hawser_linear *l)
{
	int found = 0;

	memset(l->frequency, 0, (size_t)l->n*sizeof *l->frequency);
	for (int i = 0; i < 2*l->n && found < l->n; i++)
		if (l->im[i] > 0.0)
			l->frequency[found++] = l->im[i];
	qsort(l->frequency, (size_t)l->n, sizeof *l->frequency, hawser__ascending);
}

static enum hawser_status eigenvalues(struct hawser_linear *l, const struct hawser_rom *rom,
                                      struct hawser_report *report)
{
	int m = 2*l->n, info;
	double unused;
	enum hawser_status status = hawser__numbers_check(rom, HAWSER_ERR_NAN, report);

	if (status)
		return status;
	fill(l, rom);
	/* LAPACK would print a message to standard error about a NaN */
	for (int e = 0; e < m*m; e++)
		if (!isfinite(l->matrix[e]))
			return hawser__fail(report, HAWSER_ERR_NAN, "linear",
			                    "eigenvalues about rest: the stiffness of coordinate %d lies too "
			                    "far from what couples it to another for double precision",
			                    e/m);
	info = LAPACKE_dgeev_work(LAPACK_COL_MAJOR, 'N', 'N', m, l->matrix, m, l->re, l->im, &unused, 1,
	                          &unused, 1, l->work, BLOCK*m);
	if (info)
		return hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, "linear", info, 0.0,
		                       "the QR algorithm for the eigenvalues did not converge "
		                       "(order %d, info %d)", m, info);
	read_frequencies(l);
	return HAWSER_OK;
}

enum hawser_status hawser_linear_growth(struct hawser_linear *linear, double *growth, int *growing,
                                        double *frequency, const struct hawser_rom *rom,
                                        struct hawser_report *report)
{
	enum hawser_status status = hawser__more_refuse(rom, "the stability of rest", report);
	double largest = 0.0;

	if (!status)
		status = eigenvalues(linear, rom, report);
	if (status)
		return status;
	*growth = -INFINITY;
	*growing = 0;
	for (int i = 0; i < 2*linear->n; i++)
		largest = fmax(largest, hypot(linear->re[i], linear->im[i]));
	for (int i = 0; i < 2*linear->n; i++) {
		*growth = fmax(*growth, linear->re[i]);
		*growing += linear->re[i] > GROWS*largest && linear->im[i] >= 0.0;
	}
	for (int i = 0; i < 2*linear->n; i++)
		linear->bound[i] = GROWS*largest;
	keep_margin(linear, linear->re, NOTHING*largest);
	if (fabs(*growth) <= NOTHING*largest)
		*growth = 0.0;
	memcpy(frequency, linear->frequency, (size_t)linear->n*sizeof *frequency);
	return HAWSER_OK;
}

/* K and its harmonics as a series; *order is its highest harmonic. */
static enum hawser_status collect(struct hawser_linear *l, int *order, const struct hawser_rom *rom,
                                  double omega, struct hawser_report *report)
{
	size_t n2 = (size_t)rom->n*rom->n, need;

	*order = 0;
	for (int h = 0; h < rom->harmonics; h++)
		if ((rom->harmonic[h].K || (rom->inertia.shapes > 0 && rom->harmonic[h].f)) &&
		    rom->harmonic[h].k > *order)
			*order = rom->harmonic[h].k;
	need = (2*(size_t)*order + 1)*n2;
	if (need > l->room) {
		free(l->series);
		l->series = malloc(need*sizeof *l->series);
		l->room = l->series ? need : 0;
		if (!l->series)
			return hawser__no_memory(report, "linear");
	}
	memset(l->series, 0, need*sizeof *l->series);
	for (size_t e = 0; e < n2; e++)
		l->series[e] = 2.0*rom->K[e];
	for (int h = 0; h < rom->harmonics; h++) {
		const struct hawser_harmonic *harmonic = &rom->harmonic[h];
		size_t row = hawser__series_row(harmonic);
		double factor = hawser__series_factor(harmonic, omega);

		for (size_t e = 0; harmonic->K && e < n2; e++)
			l->series[row*n2 + e] += factor*harmonic->K[e];
		/* second-order shapes represent condensed modes: about rest they have their static response
		 * to the load */
		if (harmonic->f)
			hawser__rom_held(l->series + row*n2, rom, harmonic->f, factor);
	}
	return HAWSER_OK;
}

enum hawser_status hawser__linear_series(struct hawser_linear *linear,
                                         struct hawser__variational *system,
                                         const struct hawser_rom *rom, double omega,
                                         struct hawser_report *report)
{
	enum hawser_status status;

	*system = (struct hawser__variational){.n = rom->n, .omega = omega};
	status = collect(linear, &system->order, rom, omega, report);
	system->K = linear->series;
	if (!status)
		status = hawser__monodromy_damping(&linear->monodromy, system, rom, report);
	return status;
}

/* The frequencies at rest of a component of w coordinates, ascending. */
static enum hawser_status rest_of(struct hawser_linear *l, double *frequency, const int *member,
                                  int w, struct hawser_report *report)
{
	int n = l->n, m = 2*w, coupled = 0, info;
	double unused;

	memset(l->matrix, 0, (size_t)m*m*sizeof *l->matrix);
	for (int q = 0; q < w; q++) {
		double own = 0.5*fabs(l->series[member[q]*(n + 1)]), scale = own > 0.0 ? sqrt(own) : 1.0;

		l->matrix[(size_t)(w + q)*m + q] = scale;
		for (int p = 0; p < w; p++) {
			size_t e = (size_t)member[p]*n + member[q];
			double k = 0.5*l->series[e], d = 0.5*l->monodromy.damping[e];

			coupled |= p != q && (k != 0.0 || d != 0.0);
			l->matrix[(size_t)q*m + w + p] = -k/scale;
			l->matrix[(size_t)(w + q)*m + w + p] = -d;
		}
	}
	for (int q = 0; q < w && !coupled; q++) {
		size_t e = (size_t)member[q]*(n + 1);
		double d = 0.25*l->monodromy.damping[e];

		frequency[q] = sqrt(fmax(0.5*l->series[e] - d*d, 0.0));
	}
	if (!coupled)
		return HAWSER_OK;
	info = LAPACKE_dgeev_work(LAPACK_COL_MAJOR, 'N', 'N', m, l->matrix, m, l->re, l->im, &unused, 1,
	                          &unused, 1, l->work, BLOCK*2*n);
	if (info)
		return hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, "linear", info, 0.0,
		                       "the QR algorithm for the frequencies at rest did not converge "
		                       "(order %d, info %d)", m, info);
	qsort(l->im, (size_t)m, sizeof *l->im, hawser__ascending);
	for (int q = 0; q < w; q++)
		frequency[q] = fmax(l->im[w + q], 0.0);
	return HAWSER_OK;
}

enum hawser_status hawser__linear_exponents(struct hawser_linear *linear, double *to,
                                            const struct hawser_rom *rom, double omega,
                                            struct hawser_report *report)
{
	struct hawser__monodromy *monodromy = &linear->monodromy;
	int n = linear->n, begin = 0, w;
	double *part = to + 1 + n;
	struct hawser__variational system;
	enum hawser_status status;

	to[0] = omega;
	memcpy(to + 1 + 2*n, monodromy->grouped, 4*(size_t)n*sizeof *to);
	status = hawser__linear_series(linear, &system, rom, omega, report);
	if (!status)
		hawser__monodromy_parts(monodromy, &system);
	for (; begin < n && !status; begin += w) {
		const int *member = monodromy->member + begin;

		for (w = 0; begin + w < n && monodromy->part[member[w]] == monodromy->part[*member]; w++)
			;
		status = rest_of(linear, linear->frequency, member, w, report);
		for (int q = 0; q < w; q++) {
			to[1 + member[q]] = linear->frequency[q];
			part[member[q]] = *member;
		}
	}
	return status;
}

static enum hawser_status multipliers(struct hawser_linear *linear, double *log_modulus,
                                      double *argument, const struct hawser_rom *rom, double omega,
                                      int order, struct hawser_report *report)
{
	linear->monodromy.finer = linear->finer;
	return hawser__monodromy_multipliers(&linear->monodromy, log_modulus, argument, rom,
	                                     linear->series, order, omega, report);
}

/* Largest distance of the logarithm of a multiplier from the nearest unused one of `other`, whose
 * order changes. It is relative above 1. */
static double change(const double *log_modulus, const double *argument, double *other,
                     double *other_argument, int m)
{
	double worst = 0.0;

	for (int i = 0; i < m; i++) {
		double least = INFINITY;
		int at = i;

		for (int k = i; k < m; k++) {
			double d = hypot(log_modulus[i] - other[k],
			                 remainder(argument[i] - other_argument[k], 2.0*M_PI));

			if (d < least) {
				least = d;
				at = k;
			}
		}
		worst = fmax(worst, least/fmax(1.0, fabs(log_modulus[i])));
		other[at] = other[i];
		other_argument[at] = other_argument[i];
	}
	return worst;
}

/* Compute the multipliers SAMPLES more times, with more steps; the last result is returned. Their
 * differences show the effect of step errors and round-off, which is large at double multipliers
 * and if a motion grows and decays in turn. Each number of steps rounds differently, so that all
 * four results hardly agree by chance, as two sometimes do. Round-off that is the same in all of
 * them (the nodes, pi) acts like a relative change of the data; therefore Omega is changed by
 * round-off as well. The estimate is twice the largest difference, since both results have errors. */
static enum hawser_status estimate(struct hawser_linear *linear, double *log_modulus,
                                   double *argument, double *error, const struct hawser_rom *rom,
                                   double omega, int order, struct hawser_report *report)
{
	static const double nudge[SAMPLES] = {2.0*DBL_EPSILON, -2.0*DBL_EPSILON, 0.0}; /* changes of
	                                                                                * Omega */
	int m = 2*linear->n;
	size_t size = (size_t)m*sizeof(double);
	double *sample = linear->work; /* [SAMPLES][2][m] */
	enum hawser_status status = HAWSER_OK;

	*error = linear->monodromy.spread;
	for (int i = 0; i < SAMPLES && !status; i++) {
		memcpy(sample + 2*i*m, log_modulus, size);
		memcpy(sample + (2*i + 1)*m, argument, size);
		linear->monodromy.more = i + 1;
		status = multipliers(linear, log_modulus, argument, rom, omega*(1.0 + nudge[i]), order,
		                     report);
		*error = fmax(*error, linear->monodromy.spread);
	}
	linear->monodromy.more = 0;
	for (int i = 0; i < SAMPLES && !status; i++)
		*error = fmax(*error, 2.0*change(log_modulus, argument, sample + 2*i*m,
		                                 sample + (2*i + 1)*m, m));
	return status;
}

enum hawser_status hawser_linear_multipliers(struct hawser_linear *linear, double *log_modulus,
                                             double *argument, double *error,
                                             const struct hawser_rom *rom, double omega,
                                             struct hawser_report *report)
{
	int order;
	enum hawser_status status = hawser__numbers_check(rom, HAWSER_ERR_NAN, report);

	if (!status && !(omega > 0.0 && isfinite(omega)))
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "linear",
		                      "multipliers at Omega %g: it must be positive and finite", omega);
	if (!status)
		status = hawser__more_refuse(rom, "the stability of rest", report);
	if (!status)
		status = hawser__periods_refuse(rom, "the stability of rest", report);
	if (!status && rom->exact && rom->harmonics > 0)
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "linear",
		                      "multipliers about rest of the full-order model (model.energy: exact) "
		                      "leave out what excites it, which acts through its response alone: "
		                      "set model.energy=quartic, or ask for those of the response (hawser "
		                      "hill --orbit)");
	if (!status)
		status = collect(linear, &order, rom, omega, report);
	if (!status)
		status = multipliers(linear, log_modulus, argument, rom, omega, order, report);
	if (!status && error)
		status = estimate(linear, log_modulus, argument, error, rom, omega, order, report);
	if (status)
		return status;
	linear->circle = hawser__circle_count(linear->bound, log_modulus, argument, 2*linear->n,
	                                      linear->monodromy.loss, linear->monodromy.neglected);
	linear->circle.unstable = 0;
	for (int i = 0; i < 2*linear->n; i++) {
		linear->bound[i] = fmax(linear->bound[i], COUNTS);
		linear->circle.unstable += log_modulus[i] > linear->bound[i];
	}
	keep_margin(linear, log_modulus, linear->monodromy.spread);
	return HAWSER_OK;
}
