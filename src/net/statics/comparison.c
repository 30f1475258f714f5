/* net/statics/comparison.c - methods of the statics of nets on the same nets: what each solves, and
 * how fast.
 *
 * A net counts as solved if the method says so and a certificate that shares nothing with it agrees
 * (net/statics/certificate.c). Times are processor times of whole solutions, from the net to its
 * tensions.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/net_comparison.h>

#include "core/order.h"
#include "core/progress.h"
#include "core/report.h"

enum {
	MOST = 1000000,  /* nets: their outcomes take half a gigabyte */
	NETS = 1600,     /* random cables: as many as in B 3.2.3 */
	STEPS = 20000,   /* of relaxation: a tenth of a second for 100 elements; some need 1e6 */
	CHORD_MOST = 100, /* of mixed from the chord: it would give up where forces stay at their bound */
	REPEATS = 3
};
/* Solutions that take less are timed again: interrupts are as long. Scenes are few: longer ones too. */
#define SHORT_SECS 1e-3
#define SHORT_SCENE_SECS 0.1
#define TOLERANCE 1e-7 /* of the weight: what relaxation reaches, and engineers need */

static const struct hawser_net_way ways[] = {
	{"automatic", "automatic", HAWSER_NET_START_OWN, 0},
	{"interior-point", "interior-point", HAWSER_NET_START_OWN, 0},
	{"cone", "cone", HAWSER_NET_START_OWN, 0},
	{"mixed", "mixed", HAWSER_NET_START_OWN, 0},
	{"mixed/chord", "mixed", HAWSER_NET_START_CHORD, CHORD_MOST},
	{"forces", "forces", HAWSER_NET_START_OWN, 0},
	{"two-sided", "two-sided", HAWSER_NET_START_OWN, 0},
	{"two-sided/density", "two-sided", HAWSER_NET_START_DENSITY, 0},
	{"regularised", "regularised", HAWSER_NET_START_OWN, 0},
	{"regularised/density", "regularised", HAWSER_NET_START_DENSITY, 0},
	{"descent", "descent", HAWSER_NET_START_OWN, 0},
	{"relaxation", "relaxation", HAWSER_NET_START_OWN, 0},
};
enum { WAYS = sizeof ways/sizeof *ways };

const struct hawser_net_way *hawser_net_way(int index)
{
	return index >= 0 && index < WAYS ? &ways[index] : NULL;
}

const char *hawser_net_end_name(enum hawser_net_end end)
{
	static const char *const name[] = {"solved", "compressed", "failed", "wrong"};

	return (size_t)end < sizeof name/sizeof *name ? name[end] : "?";
}

void hawser_net_comparison_clear(struct hawser_net_comparison *comparison)
{
	if (!comparison)
		return;
	free(comparison->random);
	free(comparison->outcome);
	free(comparison->score);
	memset(comparison, 0, sizeof *comparison);
}

/* --- one net --- */

static enum hawser_status judge(struct hawser_net_outcome *outcome, const struct hawser_net *net,
                                const struct hawser_net_statics *st, struct hawser_report *report)
{
	struct hawser_net_certificate certificate;
	enum hawser_status status = hawser_net_certify(&certificate, net, st, report);

	if (status)
		return status;
	outcome->iterations = st->iterations;
	outcome->angle = certificate.angle;
	outcome->residual = certificate.residual/certificate.weight;
	outcome->end = st->compressed > 0 ? HAWSER_NET_COMPRESSED
	             : certificate.right ? HAWSER_NET_SOLVED : HAWSER_NET_WRONG;
	return HAWSER_OK;
}

/* Solve, judge the first solution, and repeat a short one. A method that finds nothing is an outcome;
 * anything else that fails is wrong with the net. */
static enum hawser_status one(struct hawser_net_outcome *outcome, const struct hawser_net *net,
                              const struct hawser_net_way *way, unsigned seed,
                              const struct hawser_net_comparison_options *options,
                              struct hawser_report *report)
{
	struct hawser_net_options choice = {.method = way->method, .start = way->start, .seed = seed,
	                                    .iterations = way->iterations, .noise = options->noise,
	                                    .tolerance = options->tolerance > 0.0 ? options->tolerance
	                                                                          : TOLERANCE};
	int repeats = options->repeats > 0 ? options->repeats : REPEATS;
	double brief = options->net ? SHORT_SCENE_SECS : SHORT_SECS;
	enum hawser_status status = HAWSER_OK;

	*outcome = (struct hawser_net_outcome){.end = HAWSER_NET_FAILED, .seconds = INFINITY,
	                                       .angle = NAN, .residual = NAN};
	if (!strcmp(way->method, "relaxation"))
		choice.iterations = options->steps > 0 ? options->steps : options->net ? 0 : STEPS;
	for (int i = 0; !status && i < repeats && (i == 0 || outcome->seconds < brief); i++) {
		struct hawser_report own = {0};
		struct hawser_net_statics st;
		double began = hawser__processor_seconds();
		enum hawser_status found = hawser_net_solve(&st, net, &choice, &own);

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

static double least(const struct hawser_net_comparison *of, int net)
{
	double least = INFINITY;

	for (int w = 0; w < of->ways; w++) {
		const struct hawser_net_outcome *outcome = &of->outcome[w*of->nets + net];

		if (outcome->end == HAWSER_NET_SOLVED)
			least = fmin(least, outcome->seconds);
	}
	return least;
}

void hawser_net_comparison_profile(double *value, const struct hawser_net_comparison *comparison,
                                   int way, int iterations)
{
	for (int i = 0; i < comparison->nets; i++) {
		const struct hawser_net_outcome *outcome = &comparison->outcome[way*comparison->nets + i];

		value[i] = outcome->end != HAWSER_NET_SOLVED ? INFINITY
		         : iterations ? outcome->iterations : outcome->seconds/least(comparison, i);
	}
	qsort(value, (size_t)comparison->nets, sizeof *value, hawser__ascending);
}

/* Of `count` numbers in ascending order: the least one that half, nine tenths or all do not exceed. */
static void quantiles(double q[HAWSER_NET_QUANTILES], const double *value, int count)
{
	static const double part[HAWSER_NET_QUANTILES] = {0.5, 0.9, 1.0};

	for (int k = 0; k < HAWSER_NET_QUANTILES; k++)
		q[k] = count > 0 ? value[(int)ceil(part[k]*count) - 1] : NAN;
}

static void score(struct hawser_net_comparison *of, int w, double *value)
{
	struct hawser_net_score *score = &of->score[w];
	int *count[] = {&score->solved, &score->compressed, &score->failed, &score->wrong}, solved = 0;
	double ratio[HAWSER_NET_QUANTILES];

	for (int i = 0; i < of->nets; i++) {
		const struct hawser_net_outcome *outcome = &of->outcome[w*of->nets + i];

		++*count[outcome->end];
		if (outcome->end != HAWSER_NET_SOLVED)
			continue;
		value[solved++] = outcome->seconds;
		score->best += (outcome->seconds <= least(of, i))/(double)of->nets;
		score->angle = fmax(score->angle, outcome->angle);
		score->residual = fmax(score->residual, outcome->residual);
	}
	qsort(value, (size_t)solved, sizeof *value, hawser__ascending);
	quantiles(score->seconds, value, solved);
	hawser_net_comparison_profile(value, of, w, 0);
	quantiles(ratio, value, solved);
	score->ratio = ratio[0];
	hawser_net_comparison_profile(value, of, w, 1);
	quantiles(score->iterations, value, solved);
}

/* --- all nets --- */

static enum hawser_status open(struct hawser_net_comparison *of,
                               const struct hawser_net_comparison_options *options,
                               struct hawser_report *report)
{
	size_t nets;

	of->nets = options->nets > 0 ? options->nets : NETS;
	of->seed = options->seed;
	nets = (size_t)of->nets;
	if (of->nets > MOST)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "net", "%d nets are too many to compare: at "
		                    "most %d", of->nets, MOST);
	of->score = calloc(WAYS, sizeof *of->score);
	of->random = options->net ? NULL : calloc(nets, sizeof *of->random);
	of->outcome = calloc(WAYS*nets, sizeof *of->outcome);
	if (!of->score || !of->outcome || (!options->net && !of->random))
		return hawser__no_memory(report, "net");
	for (int i = 0; i < WAYS; i++)
		if (!options->way || !strcmp(options->way, ways[i].name))
			of->score[of->ways++].way = &ways[i];
	if (of->ways == 0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "net", "there is no method %.40s in this "
		                    "comparison (hawser compare statics --help lists them)", options->way);
	return HAWSER_OK;
}

static enum hawser_status all_ways(struct hawser_net_comparison *of, int i,
                                   struct hawser_net_outcome *to,
                                   const struct hawser_net_comparison_options *options,
                                   struct hawser_report *report)
{
	struct hawser_net own = {0};
	const struct hawser_net *net = options->net ? &options->net[i] : &own;
	enum hawser_status status = HAWSER_OK;

	if (!options->net) {
		of->random[i] = hawser_net_random(options->seed, (unsigned)i);
		status = hawser_net_random_open(&own, &of->random[i], report);
	}
	for (int w = 0; w < of->ways && !status; w++)
		status = one(&to[w], net, of->score[w].way, (unsigned)i, options, report);
	hawser_net_clear(&own);
	return status;
}

/* Outcomes of net i are put at [i][ways] first, so that fewer nets are left whole. */
static void transpose(struct hawser_net_comparison *of, const struct hawser_net_outcome *from)
{
	for (int w = 0; w < of->ways; w++)
		for (int i = 0; i < of->nets; i++)
			of->outcome[w*of->nets + i] = from[i*of->ways + w];
}

static enum hawser_status run(struct hawser_net_comparison *of, struct hawser_net_outcome *to,
                              const struct hawser_net_comparison_options *options,
                              struct hawser_report *report)
{
	double began = hawser__wall_seconds();
	enum hawser_status status = HAWSER_OK;

	for (int i = 0; i < of->nets && !status; i++) {
		struct hawser_progress_state state = hawser__progress_state("statics", "nets", i, began);

		state.expected = of->nets;
		state.fresh = i;
		state.fraction = (double)i/of->nets;
		if (hawser__told_to_stop(&options->progress, &state)) {
			of->interrupted = 1;
			of->nets = i;
			break;
		}
		status = all_ways(of, i, &to[(size_t)i*(size_t)of->ways], options, report);
	}
	if (!status)
		transpose(of, to);
	return status;
}

enum hawser_status hawser_net_compare(struct hawser_net_comparison *comparison,
                                      const struct hawser_net_comparison_options *options,
                                      struct hawser_report *report)
{
	static const struct hawser_net_comparison_options defaults = {0};
	struct hawser_net_outcome *to = NULL;
	double *value = NULL;
	enum hawser_status status;

	memset(comparison, 0, sizeof *comparison);
	options = options ? options : &defaults;
	status = open(comparison, options, report);
	if (!status) {
		to = calloc((size_t)comparison->nets*(size_t)comparison->ways, sizeof *to);
		value = calloc((size_t)comparison->nets, sizeof *value);
		status = to && value ? run(comparison, to, options, report) : hawser__no_memory(report, "net");
	}
	for (int w = 0; w < comparison->ways && !status; w++)
		score(comparison, w, value);
	free(to);
	free(value);
	if (status)
		hawser_net_comparison_clear(comparison);
	return status;
}
