/* study/hill_seed.c - where boundaries begin: changes of sign of a test function on lines across
 * the rectangle, and pairs of them hidden between two samples, where the function has a minimum of
 * its modulus. SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/progress.h"
#include "core/report.h"
#include "study/hill.h"

#define ROUND_OFF 1e-13 /* of a test function that touches zero */
#define NUDGE 1e-6      /* for the gradient */

struct line {
	double from[2], along[2];
	int samples;
	double *g; /* [samples + 1][HAWSER_HILL_KINDS] */
};

static void place(double at[2], const struct line *line, double s)
{
	at[0] = line->from[0] + s*line->along[0];
	at[1] = line->from[1] + s*line->along[1];
}

/* g > 0 on the left of *way. */
static int direction(struct hawser__hill *hill, int kind, double way[2], const double at[2])
{
	double slope[2], length;

	for (int k = 0; k < 2; k++) {
		double up[2] = {at[0], at[1]}, down[2] = {at[0], at[1]};

		up[k] += NUDGE;
		down[k] -= NUDGE;
		slope[k] = hawser__hill_at(hill, kind, up) - hawser__hill_at(hill, kind, down);
	}
	length = hypot(slope[0], slope[1]);
	way[0] = slope[1]/length;
	way[1] = -slope[0]/length;
	return length > 0.0 && !hill->status;
}

/* Does the pair of multipliers that a torus asks for stand on the circle? The product of two real
 * ones may be 1, too. */
static int genuine(struct hawser__hill *hill, int kind, const double at[2])
{
	if (kind != HAWSER_HILL_TORUS)
		return 1;
	hawser__hill_at(hill, kind, at);
	for (int i = 0; i < hill->field->m; i++)
		if (fabs(hill->log_modulus[i]) < 1e-5 && fabs(sin(hill->argument[i])) > 1e-3)
			return 1;
	return 0;
}

static void reverse(struct hawser_hill_boundary *boundary)
{
	for (int i = 0, j = boundary->points - 1; i < j; i++, j--)
		for (int k = 0; k < 2; k++) {
			double keep = boundary->at[2*i + k];

			boundary->at[2*i + k] = boundary->at[2*j + k];
			boundary->at[2*j + k] = keep;
		}
}

/* Follow backwards: a step back has the right on its left, so the function's sign is turned. What
 * comes out runs forwards: it is followed to one end, and from there all the way. */
static void follow_from(struct hawser__hill *hill, int kind, const double at[2],
                        const double way[2])
{
	struct hawser_hill_chart *chart = hill->chart;
	struct hawser_hill_boundary *larger = realloc(chart->boundary,
	                                              ((size_t)chart->boundaries + 1)*sizeof *larger);
	struct hawser_hill_boundary *boundary, back = {.kind = kind};
	double ahead[2] = {way[0], way[1]}, behind[2] = {-way[0], -way[1]};

	if (!larger) {
		hill->status = hawser__no_memory(hill->report, "hill");
		return;
	}
	chart->boundary = larger;
	boundary = &chart->boundary[chart->boundaries];
	*boundary = (struct hawser_hill_boundary){.kind = kind};
	back.at = malloc(2*sizeof *back.at);
	if (!back.at) {
		hill->status = hawser__no_memory(hill->report, "hill");
		return;
	}
	back.points = back.capacity = 1;
	memcpy(back.at, at, 2*sizeof *at);
	hill->backwards = 1;
	hawser__hill_follow(hill, &back, behind);
	hill->backwards = 0;
	reverse(&back);
	*boundary = back;
	chart->boundaries++;
	if (!hill->status && !chart->interrupted)
		hawser__hill_follow(hill, boundary, ahead);
}

static void try_root(struct hawser__hill *hill, int kind, const struct line *line, double lo,
                     double hi,
                     double g_lo, double g_hi)
{
	double s = hawser__hill_root(hill, kind, line->from, line->along, lo, hi, g_lo, g_hi), at[2],
	        way[2];

	place(at, line, s);
	if (!hill->status && direction(hill, kind, way, at) &&
	    !hawser__hill_known(hill, kind, at, way) &&
	    genuine(hill, kind, at))
		follow_from(hill, kind, at, way);
}

/* Between three samples of one sign the middle one is the smallest: is there a place of the other
 * sign? By golden sections. */
static void look_between(struct hawser__hill *hill, int kind, const struct line *line, double lo,
                         double hi,
                         double sign)
{
	const double golden = 0.3819660112501051;
	double a = lo, b = hi, s = lo + golden*(hi - lo), t = hi - golden*(hi - lo), at[2], gs, gt;

	place(at, line, s);
	gs = sign*hawser__hill_at(hill, kind, at);
	place(at, line, t);
	gt = sign*hawser__hill_at(hill, kind, at);
	for (int i = 0; i < 60 && !hill->status && gs > 0.0 && gt > 0.0 && b - a > 1e-9; i++) {
		if (gs < gt) {
			b = t;
			t = s;
			gt = gs;
			s = a + golden*(b - a);
			place(at, line, s);
			gs = sign*hawser__hill_at(hill, kind, at);
		} else {
			a = s;
			s = t;
			gs = gt;
			t = b - golden*(b - a);
			place(at, line, t);
			gt = sign*hawser__hill_at(hill, kind, at);
		}
	}
	if (gs < -ROUND_OFF || gt < -ROUND_OFF) {
		double middle = gs < gt ? s : t, g = sign*fmin(gs, gt), ends[2];

		place(at, line, lo);
		ends[0] = hawser__hill_at(hill, kind, at);
		place(at, line, hi);
		ends[1] = hawser__hill_at(hill, kind, at);
		try_root(hill, kind, line, lo, middle, ends[0], g);
		try_root(hill, kind, line, middle, hi, g, ends[1]);
	}
}

static void search(struct hawser__hill *hill, const struct line *line)
{
	double ds = 1.0/line->samples;
	int kinds = hill->field->m > 2 ? HAWSER_HILL_KINDS : HAWSER_HILL_TORUS;

	for (int i = 0; i <= line->samples && !hill->status; i++) {
		double at[2];

		place(at, line, i*ds);
		hawser__hill_at(hill, HAWSER_HILL_PLUS, at);
		for (int kind = 0; kind < kinds; kind++)
			line->g[i*HAWSER_HILL_KINDS + kind] = hawser__hill_test(hill, kind);
	}
	for (int kind = 0; kind < kinds; kind++)
		for (int i = 0; i < line->samples && !hill->status && !hill->chart->interrupted; i++) {
			const double *g = line->g + i*HAWSER_HILL_KINDS + kind;
			double next = g[HAWSER_HILL_KINDS], sign = *g < 0.0 ? -1.0 : 1.0;

			if (sign*next < 0.0)
				try_root(hill, kind, line, i*ds, (i + 1)*ds, *g, next);
			else if (i > 0 && sign*g[-HAWSER_HILL_KINDS] > fabs(*g) && sign*next > fabs(*g))
				look_between(hill, kind, line, (i - 1)*ds, (i + 1)*ds, sign);
		}
}

static void all_lines(struct hawser__hill *hill, double *g)
{
	int lines = hill->options->lines;

	/* upper edge first: most tongues are widest there */
	for (int k = lines; k >= 0 && !hill->status && !hill->chart->interrupted; k--) {
		const struct line across = {{0.0, k > 0 ? (double)k/lines : 1e-3}, {1.0, 0.0},
		                            hill->options->samples, g};
		const struct line up = {{(double)k/lines, 1e-3}, {0.0, 0.999}, hill->options->samples, g};

		search(hill, &across);
		search(hill, &up);
	}
}

/* Back to the caller's units. */
static void scale(struct hawser_hill_chart *chart, const struct hawser_hill_options *options)
{
	for (int b = 0; b < chart->boundaries; b++)
		for (int i = 0; i < 2*chart->boundary[b].points; i++) {
			double *at = &chart->boundary[b].at[i];

			*at = options->from[i%2] + (options->to[i%2] - options->from[i%2])**at;
		}
}

enum hawser_status hawser__hill_check(const struct hawser_hill_options *options,
                                      struct hawser_report *report)
{
	for (int k = 0; k < 2; k++)
		if (!(isfinite(options->from[k]) && isfinite(options->to[k]) &&
		      options->from[k] < options->to[k]))
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "hill",
			                    "a rectangle from %g to %g: give the smaller end first",
			                    options->from[k], options->to[k]);
	if (options->lines < 1 || options->samples < 4 || !(options->step > 1e-5 &&
	                                                    options->step < 0.5))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "hill",
		                    "%d lines of %d samples, steps of %g: give 1, 4 and 1e-5 at least",
		                    options->lines, options->samples, options->step);
	return HAWSER_OK;
}

enum hawser_status hawser_hill_trace(struct hawser_hill_chart *chart,
                                     const struct hawser_hill_field *field,
                                     const struct hawser_hill_options *options,
                                     struct hawser_report *report)
{
	struct hawser_hill_options settled = *options;
	struct hawser__hill hill = {.field = field, .options = &settled, .chart = chart, .report =
	                            report, .began = hawser__wall_seconds()};
	size_t m = (size_t)field->m;
	double *g;

	memset(chart, 0, sizeof *chart);
	hawser_hill_settle(&settled);
	options = &settled;
	if ((hill.status = hawser__hill_check(options, report)))
		return hill.status;
	hill.log_modulus = calloc(5*m, sizeof(double));
	hill.used = calloc(m, sizeof *hill.used);
	g = calloc(((size_t)options->samples + 1)*HAWSER_HILL_KINDS, sizeof *g);
	if (!hill.log_modulus || !hill.used || !g) {
		hill.status = hawser__no_memory(report, "hill");
	} else {
		hill.argument = hill.log_modulus + m;
		hill.work = hill.argument + m;
		all_lines(&hill, g);
		scale(chart, options);
	}
	free(hill.log_modulus);
	free(hill.used);
	free(g);
	if (hill.status)
		hawser_hill_clear(chart);
	return hill.status;
}

void hawser_hill_clear(struct hawser_hill_chart *chart)
{
	if (!chart)
		return;
	for (int b = 0; b < chart->boundaries; b++)
		free(chart->boundary[b].at);
	free(chart->boundary);
	free(chart->tongue);
	memset(chart, 0, sizeof *chart);
}
