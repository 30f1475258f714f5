/* response/time/lyapunov.c - see hawser/lyapunov.h.
 *
 *    Q      orthonormal directions, as rows [m][m]
 *    A      derivative of the flow over a segment of a period
 *    g      [period][m] logarithms of the growth of the directions over a period
 *
 * After each segment A Q is made orthonormal again, and the logarithms of the lengths are added up
 * (Benettin, Galgani, Giorgilli and Strelcyn, Meccanica 15 (1980) 9). A comes from the same steps as
 * the motion, so that it is the derivative of the computed flow.
 *
 * The average over time has the weights exp(-1/(s (1 - s))), 0 < s < 1 (Das, Saiki, Sander and Yorke,
 * Nonlinearity 30 (2017) 4111). On periodic and quasi-periodic motions its error falls faster than
 * every power of the time, where that of the plain mean falls with the time only: the directions of a
 * complex pair of multipliers turn. On chaotic motions it is a mean like any other; it costs a third of
 * the samples.
 *
 * Error: eight blocks of time are averaged in the same way, and the scatter of their mean is that of
 * eight independent values (Student's factor for 95 %). The integration is repeated with half as many
 * steps from the same state, and the difference is added in squares; on a chaotic motion this is a
 * second sample.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/lyapunov.h>

#include "core/progress.h"
#include "core/report.h"
#include "response/time/flow.h"
#include "response/orbit/shooting.h"
#include "response/time/stepper.h"

#define WHERE "lyapunov"
#define BLOCKS 8 /* enough for a scatter, and as long as possible; chosen */
#define STUDENT 2.365 /* 97.5 % quantile of seven degrees of freedom */
#define MOST_STEPS 4000 /* per segment; chosen */

struct walk {
	const struct hawser_lyapunov_options *options;
	struct hawser__flow flow;
	int m, segments, steps;
	double rtol, turn; /* turn: phase at the beginning, modulo a period */
	double size;       /* largest norm of a state so far */
	double *x, *start; /* [m] */
	double *A, *b, *Q, *next; /* [m][m], [m], [m][m] twice */
	double *g;         /* [periods][m] */
	double *began;     /* [m][m] Q at the beginning of the period */
};

static int allocate(struct walk *walk, long periods)
{
	size_t m = (size_t)walk->m, block = m*m;
	double *memory = calloc(4*block + 3*m, sizeof *memory);

	walk->g = calloc((size_t)periods*m, sizeof *walk->g);
	walk->A = memory;
	if (!memory || !walk->g)
		return 1;
	walk->Q = memory + block;
	walk->next = memory + 2*block;
	walk->began = memory + 3*block;
	walk->x = memory + 4*block;
	walk->start = walk->x + m;
	walk->b = walk->start + m;
	return 0;
}

static void release(struct walk *walk)
{
	hawser__flow_clear(&walk->flow);
	free(walk->A);
	free(walk->g);
}

/* Q becomes that of A Q; the logarithms of the lengths are added to g [m]. */
static void turn(struct walk *walk, double *g)
{
	int m = walk->m;
	double *swap = walk->next;

	cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasTrans, m, m, m, 1.0, walk->Q, m, walk->A, m, 0.0,
	            walk->next, m);
	for (int i = 0; i < m; i++) {
		double *row = walk->next + (size_t)i*m, length;

		for (int pass = 0; pass < 2; pass++) /* the second removes the round-off of the first */
			for (int k = 0; k < i; k++) {
				const double *other = walk->next + (size_t)k*m;

				cblas_daxpy(m, -cblas_ddot(m, other, 1, row, 1), other, 1, row, 1);
			}
		length = cblas_dnrm2(m, row, 1);
		g[i] += log(length);
		cblas_dscal(m, 1.0/length, row, 1);
	}
	walk->next = walk->Q;
	walk->Q = swap;
}

/* A period with the present steps; returns its estimated error. */
static double pass(struct walk *walk, double *g)
{
	struct hawser__stretch stretch = {.h = 2.0*M_PI/walk->segments/walk->steps, .steps = walk->steps,
	                                  .count = 1};
	double error = 0.0;

	memset(g, 0, (size_t)walk->m*sizeof *g);
	for (int s = 0; s < walk->segments; s++) {
		stretch.tau = walk->turn + s*2.0*M_PI/walk->segments;
		error += hawser__flow_derive(&walk->flow, walk->x, walk->A, walk->b, NULL, &stretch,
		                             walk->options->omega);
		turn(walk, g);
	}
	return error;
}

/* A period whose error is as required, unless `fixed` is set. */
static enum hawser_status period(struct walk *walk, long index, int fixed,
                                 struct hawser_report *report)
{
	size_t m = (size_t)walk->m;
	double *g = walk->g + (size_t)index*m, error;

	memcpy(walk->start, walk->x, m*sizeof *walk->x);
	memcpy(walk->began, walk->Q, m*m*sizeof *walk->Q);
	for (;;) {
		error = pass(walk, g);
		walk->size = fmax(walk->size, cblas_dnrm2(walk->m, walk->start, 1));
		if (fixed || error <= walk->rtol*walk->size || !(walk->size > 0.0))
			break;
		if (2*walk->steps > MOST_STEPS)
			break;
		walk->steps += walk->steps/2 + 1;
		memcpy(walk->x, walk->start, m*sizeof *walk->x);
		memcpy(walk->Q, walk->began, m*m*sizeof *walk->Q);
	}
	for (size_t i = 0; i < m; i++)
		if (!isfinite(walk->x[i]) || !isfinite(g[i]))
			return hawser__fail(report, HAWSER_ERR_NAN, WHERE,
			                    "the motion escapes in period %ld of the average: lower the load, "
			                    "or start from another state", index + 1);
	if (!fixed && !(error <= walk->rtol*walk->size) && walk->size > 0.0)
		return hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, WHERE, (int)index, error/walk->size,
		                       "a period needs more than %d steps for the tolerance %.1g (estimated "
		                       "error %.2g): raise rtol", walk->steps*walk->segments, walk->rtol,
		                       error/walk->size);
	return HAWSER_OK;
}

/* All periods, from the initial state. */
static enum hawser_status go(struct walk *walk, int fixed, int *interrupted,
                             struct hawser_report *report)
{
	const struct hawser_lyapunov_options *options = walk->options;
	size_t m = (size_t)walk->m;
	double began = hawser__wall_seconds();
	enum hawser_status status = HAWSER_OK;

	memcpy(walk->x, options->initial, m*sizeof *walk->x);
	memset(walk->Q, 0, m*m*sizeof *walk->Q);
	for (size_t i = 0; i < m; i++) /* velocities first, so that no direction is special */
		walk->Q[i*m + (i + m/2)%m] = 1.0;
	for (long k = 0; k < options->periods && !status && !*interrupted; k++) {
		struct hawser_progress_state state;

		status = period(walk, k, fixed, report);
		if (status || !hawser__is_watched(&options->progress))
			continue;
		state = hawser__progress_state("Lyapunov exponents", "periods", k + 1, began);
		state.fraction = (0.5*fixed + (double)(k + 1)/(double)options->periods)/(1.0 + 0.5*fixed);
		*interrupted = hawser__told_to_stop(&options->progress, &state);
	}
	return status;
}

/* Weighted mean of g over periods from `first`, of direction i. */
static double mean(const struct walk *walk, long first, long count, int i)
{
	double sum = 0.0, weights = 0.0;

	for (long k = 0; k < count; k++) {
		double s = ((double)k + 0.5)/(double)count, weight = exp(-1.0/(s*(1.0 - s)));

		sum += weight*walk->g[(size_t)(first + k)*(size_t)walk->m + (size_t)i];
		weights += weight;
	}
	return sum/weights;
}

/* The exponents of the walk (fine: error not yet known), or the error from a second one. */
static void collect(struct hawser_lyapunov *result, const struct walk *walk, int second)
{
	long all = walk->options->periods, first = all/10, count = all - first, block = count/BLOCKS;
	double per = walk->options->omega/(2.0*M_PI);

	result->averaged = count;
	for (int i = 0; i < walk->m; i++) {
		double whole = per*mean(walk, first, count, i), middle = 0.0, sum = 0.0, part[BLOCKS];

		if (second) {
			result->error[i] = hypot(result->scatter[i], whole - result->exponent[i]);
			continue;
		}
		for (int b = 0; b < BLOCKS; b++)
			middle += (part[b] = per*mean(walk, first + b*block, block, i))/BLOCKS;
		for (int b = 0; b < BLOCKS; b++)
			sum += (part[b] - middle)*(part[b] - middle);
		result->exponent[i] = whole;
		result->scatter[i] = STUDENT*sqrt(sum/(BLOCKS*(BLOCKS - 1.0)));
	}
}

/* Descending; neighbours whose directions settled slowly may be out of order. */
static void sort(struct hawser_lyapunov *result)
{
	for (int i = 1; i < result->m; i++)
		for (int k = i; k > 0 && result->exponent[k] > result->exponent[k - 1]; k--) {
			double *const column[] = {result->exponent, result->error, result->scatter};

			for (int c = 0; c < 3; c++) {
				double kept = column[c][k];

				column[c][k] = column[c][k - 1];
				column[c][k - 1] = kept;
			}
		}
}

static enum hawser_status check(const struct hawser_rom *rom,
                                const struct hawser_lyapunov_options *options,
                                struct hawser_report *report)
{
	const char *why = rom->ramp ? "its speed changes once and for all (travel.braking)"
	                  : rom->history ? "it is moved or loaded by a table over time"
	                  : rom->first ? "it is of first order: its velocities are no states" : NULL;

	if (why)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, WHERE,
		                    "no Lyapunov exponents of this model: %s", why);
	if (rom->periods > 1)
		return hawser__periods_refuse(rom, "the search for Lyapunov exponents", report);
	if (!(options->omega > 0.0) || !isfinite(options->omega))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, WHERE,
		                    "the frequency (Omega) is %g: it must be positive", options->omega);
	if (!(options->rtol >= 0.0) || options->rtol >= 1.0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, WHERE,
		                    "the relative tolerance (rtol) is %g: it must be positive and below 1",
		                    options->rtol);
	if (options->periods < HAWSER_LYAPUNOV_FEWEST)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, WHERE,
		                    "Lyapunov exponents are averages over %d periods or more, and there "
		                    "are %ld after the transient: lengthen the run (--until), or end "
		                    "the transient earlier (--after)", HAWSER_LYAPUNOV_FEWEST,
		                    options->periods);
	return HAWSER_OK;
}

enum hawser_status hawser_lyapunov_find(struct hawser_lyapunov *result, const struct hawser_rom *rom,
                                        const struct hawser_lyapunov_options *options,
                                        struct hawser_report *report)
{
	struct walk walk = {.options = options, .m = 2*rom->n,
	                    .rtol = options->rtol > 0.0 ? options->rtol : HAWSER_DEFAULT_RTOL};
	enum hawser_status status;

	memset(result, 0, sizeof *result);
	if ((status = check(rom, options, report)))
		return status;
	walk.segments = hawser__shooting_segments(rom, options->omega);
	walk.steps = hawser__shooting_steps(rom, options->omega, walk.segments);
	walk.turn = hawser__stepper_turned(options->omega, options->begin, 0.0);
	result->m = walk.m;
	result->exponent = calloc(3*(size_t)walk.m, sizeof *result->exponent);
	if (!result->exponent || allocate(&walk, options->periods))
		status = hawser__no_memory(report, WHERE);
	else
		status = hawser__flow_init(&walk.flow, rom, report);
	if (!status) {
		result->error = result->exponent + walk.m;
		result->scatter = result->error + walk.m;
		status = go(&walk, 0, &result->interrupted, report);
	}
	if (!status && !result->interrupted) {
		result->steps = walk.steps*walk.segments;
		collect(result, &walk, 0);
		walk.steps = (walk.steps + 1)/2;
		status = go(&walk, 1, &result->interrupted, report);
	}
	if (!status && !result->interrupted) {
		collect(result, &walk, 1);
		sort(result);
	}
	release(&walk);
	return status;
}

void hawser_lyapunov_clear(struct hawser_lyapunov *result)
{
	if (!result)
		return;
	free(result->exponent);
	memset(result, 0, sizeof *result);
}
