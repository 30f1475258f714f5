/* tests/nets/comparison.c - methods of the statics of nets on the same nets: what each solves, and
 * how fast.
 *
 * A net counts as solved if the method says so and a certificate that shares nothing with it agrees
 * (certificate.c). Times are processor times of whole solutions, from the net to its
 * tensions.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/order.h"
#include "core/progress.h"
#include "core/report.h"
#include "tests/nets/comparison.h"

enum {
	STEPS = 20000,   /* of relaxation: a tenth of a second for 100 elements; some need 1e6 */
	CHORD_MOST = 100, /* of mixed from the chord: it would give up where forces stay at their bound */
	REPEATS = 3
};
/* Solutions that take less are timed again: interrupts are as long. */
#define SHORT_SECS 1e-3
#define NOISE 1e-4     /* of the chord: what two-sided, regularised and mixed solve of random cables is
                        * then what an independent program finds (doc/theory-net.md) */
#define TOLERANCE 1e-7 /* of the weight: what relaxation reaches, and engineers need */

static const struct net_way ways[] = {
	{"automatic", "automatic", 0, 0},
	{"interior-point", "interior-point", 0, 0},
	{"cone", "cone", 0, 0},
	{"mixed", "mixed", 0, 0},
	{"mixed/chord", "mixed", 1, CHORD_MOST},
	{"forces", "forces", 0, 0},
	{"two-sided", "two-sided", 1, 0},
	{"two-sided/density", "two-sided", 0, 0},
	{"regularised", "regularised", 1, 0},
	{"regularised/density", "regularised", 0, 0},
	{"descent", "descent", 1, 0},
	{"relaxation", "relaxation", 0, 0},
};
enum { WAYS = sizeof ways/sizeof *ways };

void net_comparison_clear(struct net_comparison *comparison)
{
	free(comparison->outcome);
	free(comparison->score);
	memset(comparison, 0, sizeof *comparison);
}

/* --- one net --- */

static enum hawser_status judge(struct net_outcome *outcome, const struct hawser_net *net,
                                const struct hawser_net_statics *st, struct hawser_report *report)
{
	struct net_certificate certificate;
	enum hawser_status status = net_certify(&certificate, net, st, report);

	if (status)
		return status;
	outcome->iterations = st->iterations;
	outcome->angle = certificate.angle;
	outcome->residual = certificate.residual/certificate.weight;
	outcome->end = certificate.right ? NET_SOLVED
	             : certificate.compressed > 0 && !strcmp(st->method, "two-sided") ? NET_COMPRESSED
	                                                                              : NET_WRONG;
	return HAWSER_OK;
}

/* Solve, judge the first solution, and repeat a short one. A method that finds nothing is an outcome;
 * anything else that fails is wrong with the net. */
static enum hawser_status one(struct net_outcome *outcome, const struct hawser_net *net,
                              const struct net_way *way, unsigned seed,
                              const struct net_comparison_options *options,
                              struct hawser_report *report)
{
	struct hawser_net_options choice = {.iterations = way->iterations, .tolerance = TOLERANCE};
	int repeats = options->repeats > 0 ? options->repeats : REPEATS;
	enum hawser_status status = HAWSER_OK;

	*outcome = (struct net_outcome){.end = NET_FAILED, .seconds = INFINITY, .angle = NAN,
	                                .residual = NAN};
	net_start_at(way->chord, options->noise > 0.0 ? options->noise : NOISE, seed);
	if (!strcmp(way->method, "relaxation"))
		choice.iterations = options->steps > 0 ? options->steps : STEPS;
	for (int i = 0; !status && i < repeats && (i == 0 || outcome->seconds < SHORT_SECS); i++) {
		struct hawser_report own = {0};
		struct hawser_net_statics st;
		double began = hawser__processor_seconds();
		enum hawser_status found = hawser__net_solve_by(&st, net, net_method(way->method), &choice,
		                                                &own);

		outcome->seconds = fmin(outcome->seconds, hawser__processor_seconds() - began);
		if (!found && i == 0)
			status = judge(outcome, net, &st, report);
		hawser_net_statics_clear(&st);
		if (found == HAWSER_ERR_CONVERGENCE || found == HAWSER_ERR_NAN) {
			outcome->iterations = own.iteration;
			break;
		}
		if (found) {
			*report = own;
			status = found;
		}
	}
	return status;
}

/* --- scores --- */

static double least(const struct net_comparison *of, int net)
{
	double least = INFINITY;

	for (int w = 0; w < of->ways; w++) {
		const struct net_outcome *outcome = &of->outcome[w*of->nets + net];

		if (outcome->end == NET_SOLVED)
			least = fmin(least, outcome->seconds);
	}
	return least;
}

void net_comparison_profile(double *value, const struct net_comparison *comparison,
                                   int way, int iterations)
{
	for (int i = 0; i < comparison->nets; i++) {
		const struct net_outcome *outcome = &comparison->outcome[way*comparison->nets + i];

		value[i] = outcome->end != NET_SOLVED ? INFINITY
		         : iterations ? outcome->iterations : outcome->seconds/least(comparison, i);
	}
	qsort(value, (size_t)comparison->nets, sizeof *value, hawser__ascending);
}

/* Of `count` numbers in ascending order: the least one that half, nine tenths or all do not exceed. */
static void quantiles(double q[NET_QUANTILES], const double *value, int count)
{
	static const double part[NET_QUANTILES] = {0.5, 0.9, 1.0};

	for (int k = 0; k < NET_QUANTILES; k++)
		q[k] = count > 0 ? value[(int)ceil(part[k]*count) - 1] : NAN;
}

static void score(struct net_comparison *of, int w, double *value)
{
	struct net_score *score = &of->score[w];
	int *count[] = {&score->solved, &score->compressed, &score->failed, &score->wrong}, solved = 0;
	double ratio[NET_QUANTILES];

	for (int i = 0; i < of->nets; i++) {
		const struct net_outcome *outcome = &of->outcome[w*of->nets + i];

		++*count[outcome->end];
		if (outcome->end != NET_SOLVED)
			continue;
		value[solved++] = outcome->seconds;
		score->best += (outcome->seconds <= least(of, i))/(double)of->nets;
	}
	qsort(value, (size_t)solved, sizeof *value, hawser__ascending);
	quantiles(score->seconds, value, solved);
	net_comparison_profile(value, of, w, 0);
	quantiles(ratio, value, solved);
	score->ratio = ratio[0];
	net_comparison_profile(value, of, w, 1);
	quantiles(score->iterations, value, solved);
}

/* --- all nets --- */

static enum hawser_status open(struct net_comparison *of, const struct net_comparison_options *options,
                               struct hawser_report *report)
{
	of->nets = options->nets;
	of->score = calloc(WAYS, sizeof *of->score);
	of->outcome = calloc(WAYS*(size_t)of->nets, sizeof *of->outcome);
	if (!of->score || !of->outcome)
		return hawser__no_memory(report, "net");
	for (int i = 0; i < WAYS; i++)
		if (!options->way || !strcmp(options->way, ways[i].name))
			of->score[of->ways++].way = &ways[i];
	return of->ways ? HAWSER_OK
	                : hawser__fail(report, HAWSER_ERR_ARGUMENT, "net", "there is no method %.40s in "
	                               "this comparison", options->way);
}

static enum hawser_status all_ways(struct net_comparison *of, int i,
                                   const struct net_comparison_options *options,
                                   struct hawser_report *report)
{
	const struct net_cable cable = net_cable(options->seed, (unsigned)i);
	struct hawser_net net;
	enum hawser_status status = net_cable_open(&net, &cable, report);

	for (int w = 0; w < of->ways && !status; w++)
		status = one(&of->outcome[w*of->nets + i], &net, of->score[w].way, (unsigned)i, options,
		             report);
	hawser_net_clear(&net);
	return status;
}

enum hawser_status net_compare(struct net_comparison *comparison,
                               const struct net_comparison_options *options,
                               struct hawser_report *report)
{
	double *value = calloc((size_t)options->nets, sizeof *value);
	enum hawser_status status;

	memset(comparison, 0, sizeof *comparison);
	status = value ? open(comparison, options, report) : hawser__no_memory(report, "net");
	for (int i = 0; i < comparison->nets && !status; i++)
		status = all_ways(comparison, i, options, report);
	for (int w = 0; w < comparison->ways && !status; w++)
		score(comparison, w, value);
	free(value);
	if (status)
		net_comparison_clear(comparison);
	return status;
}
