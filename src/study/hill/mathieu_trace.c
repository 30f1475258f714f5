/* study/hill/mathieu_trace.c - the boundaries of Mathieu's equation over a rectangle, tongue by tongue
 * (hill.h).
 *
 *    p   parameter along a boundary. Without damping, and for tongue 0, p is epsilon. With damping a
 *        tongue begins at its tip, |epsilon| = opens, and |epsilon| = opens + p^2; the lower boundary
 *        has p < 0
 *
 * Successive points of a boundary are at most a step apart. Where a boundary enters or leaves the
 * rectangle, a point lies on the edge.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "core/grow.h"
#include "core/progress.h"
#include "core/report.h"
#include "study/hill/hill.h"

#define FIRST 64          /* initial number of parts of a boundary; chosen */
#define DEEPEST 40        /* largest number of times a part is halved; chosen, beyond what a step
                           * can need */
#define HALVINGS 80       /* halvings of a search for a tip or for an edge of the rectangle: more
                           * than a double has bits */

struct walk {
	struct hawser_hill_chart *chart;
	const struct hawser_hill_options *options;
	struct hawser_report *report;
	double damping;
	int order, upper;      /* upper: 1: the upper boundary; without damping only */
	double opens, sign;    /* with damping: |epsilon| of the tip, and sign of epsilon */
	int begun;             /* 1: the last boundary of the chart is incomplete */
	int seen;              /* 1: the tongue intersects the rectangle */
	double width[2];
};

struct at {
	double p, point[2];
	int open;
};

static int tipped(const struct walk *walk)
{
	return walk->damping > 0.0 && walk->order > 0;
}

static enum hawser_status find(struct at *at, struct walk *walk, double p)
{
	struct hawser__tongue tongue;
	double epsilon = tipped(walk) ? walk->sign*(walk->opens + p*p) : p;
	int upper = tipped(walk) ? p > 0.0 : walk->upper;
	enum hawser_status status = hawser__mathieu_tongue(&tongue, walk->order, epsilon,
	                                                   walk->damping, 1, walk->report);

	walk->chart->evaluations++;
	*at = (struct at){p, {tongue.edge[upper], epsilon}, status ? 0 : tongue.open || !tipped(walk)};
	if (status || !(tongue.edge[upper] >= walk->options->from[0] &&
	                tongue.edge[upper] <= walk->options->to[0]))
		return status;
	walk->seen = 1;
	walk->width[0] = fmin(walk->width[0], tongue.width);
	walk->width[1] = fmax(walk->width[1], tongue.width);
	walk->chart->truncation = fmax(walk->chart->truncation,
	                               tongue.truncation/fmax(1.0, fabs(tongue.edge[upper])));
	return HAWSER_OK;
}

/* -1, 0 or 1: left of the rectangle, in it, right of it. */
static int side(const struct walk *walk, const struct at *at)
{
	return at->point[0] < walk->options->from[0] ? -1 : at->point[0] > walk->options->to[0];
}

static double apart(const struct walk *walk, const struct at *a, const struct at *b)
{
	double d[2];

	for (int k = 0; k < 2; k++)
		d[k] = (b->point[k] - a->point[k])/(walk->options->to[k] - walk->options->from[k]);
	return hypot(d[0], d[1]);
}

/* --- output --- */

static enum hawser_status begin(struct walk *walk)
{
	struct hawser_hill_chart *chart = walk->chart;

	if (hawser__more(&chart->boundary, chart->boundaries, sizeof *chart->boundary))
		return hawser__no_memory(walk->report, "hill");
	chart->boundary[chart->boundaries++] = (struct hawser_hill_boundary){
		.kind = walk->order%2 ? HAWSER_HILL_MINUS : HAWSER_HILL_PLUS, .named = 1,
		.order = walk->order, .upper = walk->upper};
	walk->begun = 1;
	return HAWSER_OK;
}

static enum hawser_status write_point(struct walk *walk, const double point[2])
{
	struct hawser_hill_chart *chart = walk->chart;
	enum hawser_status status = walk->begun ? HAWSER_OK : begin(walk);

	if (!status && chart->boundary[chart->boundaries - 1].points >= walk->options->max_points)
		chart->boundary[chart->boundaries - 1].limited = 1;
	if (status || chart->boundary[chart->boundaries - 1].limited)
		return status;
	return hawser__hill_append(&chart->boundary[chart->boundaries - 1], point, walk->report);
}

/* Output the point on the edge of the rectangle between `in`, inside, and `out`, outside. */
static enum hawser_status write_edge(struct walk *walk, const struct at *in, const struct at *out)
{
	double limit = side(walk, out) < 0 ? walk->options->from[0] : walk->options->to[0];
	struct at a = *in, b = *out, middle = *in;
	double point[2];

	for (int i = 0; i < HALVINGS; i++) {
		double p = 0.5*(a.p + b.p);
		enum hawser_status status = find(&middle, walk, p);

		if (status)
			return status;
		if (p == a.p || p == b.p)
			break;
		*(side(walk, &middle) ? &b : &a) = middle;
	}
	point[0] = limit;
	point[1] = middle.point[1];
	return write_point(walk, point);
}

/* The boundary from a to b; a is output if it is in the rectangle. */
static enum hawser_status write_part(struct walk *walk, const struct at *a, const struct at *b)
{
	int from = side(walk, a), to = side(walk, b);
	enum hawser_status status = HAWSER_OK;

	if (!a->open || !b->open) {
		walk->begun = 0;
		return b->open && !to ? write_point(walk, b->point) : HAWSER_OK;
	}
	if (from && !to)
		status = write_edge(walk, b, a);
	else if (to && !from)
		status = write_edge(walk, a, b);
	if (to)
		walk->begun = 0;
	return status || to ? status : write_point(walk, b->point);
}

static enum hawser_status part(struct walk *walk, const struct at *a, const struct at *b, int depth)
{
	double far = apart(walk, a, b);
	struct at middle;
	enum hawser_status status;

	if (depth == 0 || far <= walk->options->step ||
	    (side(walk, a)*side(walk, b) > 0 && far < 1.0))
		return write_part(walk, a, b);
	status = find(&middle, walk, 0.5*(a->p + b->p));
	if (!status)
		status = part(walk, a, &middle, depth - 1);
	return status ? status : part(walk, &middle, b, depth - 1);
}

static enum hawser_status boundary(struct walk *walk, double from, double to)
{
	struct at a, b;
	enum hawser_status status;

	walk->begun = 0;
	if (!(from < to))
		return HAWSER_OK;
	status = find(&a, walk, from);
	if (status)
		return status;
	if (a.open && !side(walk, &a) && (status = write_point(walk, a.point)))
		return status;
	for (int i = 1; i <= FIRST; i++) {
		if ((status = find(&b, walk, from + (to - from)*i/FIRST)) ||
		    (status = part(walk, &a, &b, DEEPEST)))
			return status;
		a = b;
	}
	return HAWSER_OK;
}

/* --- tongues --- */

/* With damping: the smallest epsilon in [0, most] at which the tongue exists. */
static enum hawser_status find_tip(struct walk *walk, double most)
{
	double closed = 0.0, open = INFINITY;
	struct hawser__tongue tongue;
	enum hawser_status status = HAWSER_OK;

	for (int i = 1; i <= FIRST && !status && isinf(open); i++) {
		double epsilon = most*i/FIRST;

		status = hawser__mathieu_tongue(&tongue, walk->order, epsilon, walk->damping, 0,
		                                walk->report);
		*(tongue.open ? &open : &closed) = epsilon;
	}
	walk->opens = open;
	for (int i = 0; i < HALVINGS && !status && isfinite(open); i++) {
		double middle = 0.5*(closed + open);

		if (middle == closed || middle == open)
			break;
		status = hawser__mathieu_tongue(&tongue, walk->order, middle, walk->damping, 0,
		                                walk->report);
		*(tongue.open ? &open : &closed) = middle;
		walk->opens = open;
	}
	return status;
}

/* Both boundaries with damping for one sign of epsilon, |epsilon| from `from` to `to`. */
static enum hawser_status around(struct walk *walk, double from, double to)
{
	double low = sqrt(fmax(from - walk->opens, 0.0)), high = sqrt(to - walk->opens);
	enum hawser_status status;

	if (!(to > walk->opens))
		return HAWSER_OK;
	if (low == 0.0)
		return boundary(walk, -high, high);
	status = boundary(walk, -high, -low);
	return status ? status : boundary(walk, low, high);
}

/* The position of a tongue that does not exist with this damping is that of its middle. */
static enum hawser_status look(struct walk *walk)
{
	const double *from = walk->options->from, *to = walk->options->to;
	double keep = walk->damping;
	enum hawser_status status = HAWSER_OK;
	struct at at;

	walk->damping = 0.0;
	for (int i = 0; i <= FIRST && !status; i++)
		status = find(&at, walk, from[1] + (to[1] - from[1])*i/FIRST);
	walk->damping = keep;
	walk->width[0] = walk->width[1] = 0.0;
	return status;
}

static enum hawser_status tongue(struct walk *walk)
{
	double low = walk->options->from[1], high = walk->options->to[1];
	enum hawser_status status;

	if (!tipped(walk)) {
		status = HAWSER_OK;
		for (walk->upper = walk->order == 0; walk->upper < 2 && !status; walk->upper++)
			status = boundary(walk, low, high);
		return status;
	}
	walk->upper = 0;
	if ((status = find_tip(walk, fmax(fabs(low), fabs(high)))))
		return status;
	if (isinf(walk->opens))
		return look(walk);
	walk->sign = 1.0;
	status = around(walk, fmax(low, 0.0), high);
	walk->sign = -1.0;
	return status ? status : around(walk, fmax(-high, 0.0), -low);
}

static enum hawser_status note(struct walk *walk)
{
	struct hawser_hill_chart *chart = walk->chart;

	if (!walk->seen || walk->order == 0)
		return HAWSER_OK;
	if (hawser__more(&chart->tongue, chart->tongues, sizeof *chart->tongue))
		return hawser__no_memory(walk->report, "hill");
	chart->tongue[chart->tongues++] = (struct hawser_hill_tongue){walk->order,
		{walk->width[0], walk->width[1]}, walk->damping > 0.0 ? walk->opens : 0.0};
	return HAWSER_OK;
}

/* Whether this tongue and those above lie to the right of the rectangle: judged by the lower boundary
 * at epsilon = 0 and at the largest |epsilon|. */
static enum hawser_status beyond(int *right, struct walk *walk)
{
	double most = fmax(fabs(walk->options->from[1]), fabs(walk->options->to[1]));
	struct hawser__tongue far;
	enum hawser_status status = hawser__mathieu_tongue(&far, walk->order, most, 0.0, 0, walk->report);

	*right = (double)walk->order*walk->order > walk->options->to[0] &&
	         far.edge[0] > walk->options->to[0];
	return status;
}

enum hawser_status hawser_mathieu_trace(struct hawser_hill_chart *chart, double damping,
                                        const struct hawser_hill_options *options,
                                        struct hawser_report *report)
{
	struct hawser_hill_options settled = *options;
	struct hawser__span span = {.began = hawser__wall_seconds()};
	enum hawser_status status;

	memset(chart, 0, sizeof *chart);
	hawser_hill_settle(&settled);
	options = &settled;
	status = hawser__hill_check(options, report);
	for (int r = 0, right = 0; !status && !right && !chart->interrupted; r++) {
		struct walk walk = {.chart = chart, .options = options, .report = report,
			.damping = damping, .order = r, .width = {INFINITY, 0.0}};

		status = beyond(&right, &walk);
		if (!status && !right)
			status = tongue(&walk);
		if (!status && !right)
			status = note(&walk);
		if (!status)
			chart->interrupted = hawser__hill_told_to_stop(options, chart->boundaries, 0,
			                                               &span);
	}
	if (status)
		hawser_hill_clear(chart);
	return status;
}
