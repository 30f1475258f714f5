/* study/identify/identify_match.c - to which modes measured frequencies belong.
 *
 * What is given by number is taken first. The other measurements of a plane, and then those whose plane
 * is not known, are assigned to the modes left in ascending order of frequency:
 *
 *    D_ij   least cost of the measurements up to i if i belongs to candidate j:
 *           min over j' < j of D_(i-1)j' + skip (j - j' - 1), plus (w log(s computed_j/measured_i))^2
 *
 * For a sum of convex functions of the difference of logarithms, no crossing assignment is better.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include "core/report.h"
#include "study/identify/identify.h"

static const char where[] = "identify";
enum { ANY = -1, PLANES = 2 };

int hawser__fit_given(const struct hawser_measured *measured)
{
	return measured->place > 0 || measured->number > 0;
}

/* One call of hawser__fit_match. */
struct match {
	const struct hawser__fit *fit;
	const struct hawser_modes *modes;
	double scale;
	struct hawser__mate *mate; /* [count] */
	int *taken;                /* [n] of the modes */
	int *row, *candidate;      /* [count], [n] of this plane, by frequency */
	int rows, candidates;
	double *cost;              /* [count][n] D */
	int *from;                 /* [count][n] */
};

static double square(const struct hawser__fit *fit, const struct hawser_modes *modes, double scale,
                     int i, int k)
{
	double left = log(scale*modes->mode[k].omega/modes->time_unit/fit->measured[i].omega);

	left *= fit->weight[i];
	return left*left;
}

static enum hawser_status give(struct match *match, int i, struct hawser_report *report)
{
	const struct hawser_measured *measured = &match->fit->measured[i];

	for (int k = 0; k < match->modes->n; k++) {
		const struct hawser_mode *mode = &match->modes->mode[k];

		if (measured->place ? mode->place != measured->place
		                    : mode->number != measured->number ||
		                      (int)mode->plane != measured->plane)
			continue;
		if (match->taken[k])
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
			                    "measurement %d: its mode has another measurement too", i + 1);
		if (measured->plane != ANY && (int)mode->plane != measured->plane)
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
			                    "measurement %d: mode %d of the scene is %s: give the number in its "
			                    "plane, or other starting values", i + 1, measured->place,
			                    hawser_plane_name(mode->plane));
		match->mate[i] = (struct hawser__mate){(int)mode->plane, mode->number};
		match->taken[k] = 1;
		return HAWSER_OK;
	}
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
	                    "measurement %d: the scene has no such mode among its lowest %d", i + 1,
	                    match->modes->n);
}

/* The rows of this plane whose modes are not given, by frequency, and the modes left. */
static void collect(struct match *match, int plane)
{
	const struct hawser_measured *measured = match->fit->measured;

	match->rows = match->candidates = 0;
	for (int i = 0; i < match->fit->count; i++) {
		int at = match->rows;

		if (hawser__fit_given(&measured[i]) || measured[i].plane != plane)
			continue;
		for (; at > 0 && measured[match->row[at - 1]].omega > measured[i].omega; at--)
			match->row[at] = match->row[at - 1];
		match->row[at] = i;
		match->rows++;
	}
	for (int k = 0; k < match->modes->n; k++)
		if (!match->taken[k] && (plane == ANY || (int)match->modes->mode[k].plane == plane))
			match->candidate[match->candidates++] = k;
}

static void fill(struct match *match)
{
	int n = match->candidates;

	for (int i = 0; i < match->rows; i++)
		for (int j = i; j < n; j++) {
			double least = i ? INFINITY : HAWSER_IDENTIFY_SKIP*j;
			int from = -1;

			for (int before = i - 1; i > 0 && before < j; before++) {
				double cost = match->cost[(i - 1)*n + before] +
				              HAWSER_IDENTIFY_SKIP*(j - before - 1);

				if (cost < least) {
					least = cost;
					from = before;
				}
			}
			match->cost[i*n + j] = least + square(match->fit, match->modes, match->scale,
			                                      match->row[i], match->candidate[j]);
			match->from[i*n + j] = from;
		}
}

static enum hawser_status align(struct match *match, int *skipped, int plane,
                                struct hawser_report *report)
{
	int n, best;

	collect(match, plane);
	n = match->candidates;
	if (match->rows == 0)
		return HAWSER_OK;
	if (n < match->rows)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
		                    "%d measurements for %d modes", match->rows, n);
	fill(match);
	best = match->rows - 1;
	for (int j = best + 1; j < n; j++)
		if (match->cost[(match->rows - 1)*n + j] < match->cost[(match->rows - 1)*n + best])
			best = j;
	*skipped += best + 1 - match->rows;
	for (int i = match->rows - 1; i >= 0; i--) {
		const struct hawser_mode *mode = &match->modes->mode[match->candidate[best]];

		match->mate[match->row[i]] = (struct hawser__mate){(int)mode->plane, mode->number};
		match->taken[match->candidate[best]] = 1;
		best = match->from[i*n + best];
	}
	return HAWSER_OK;
}

enum hawser_status hawser__fit_match(struct hawser__mate *mate, int *skipped,
                                     const struct hawser__fit *fit,
                                     const struct hawser_modes *modes, double scale,
                                     struct hawser_report *report)
{
	size_t count = (size_t)fit->count, n = (size_t)modes->n;
	struct match match = {fit, modes, scale, mate, calloc(n, sizeof(int)),
	                      malloc(count*sizeof(int)), malloc(n*sizeof(int)), 0, 0,
	                      malloc(count*n*sizeof(double)), malloc(count*n*sizeof(int))};
	enum hawser_status status = HAWSER_OK;

	*skipped = 0;
	if (!match.taken || !match.row || !match.candidate || !match.cost || !match.from)
		status = hawser__no_memory(report, where);
	for (int i = 0; i < fit->count && !status; i++)
		if (hawser__fit_given(&fit->measured[i]))
			status = give(&match, i, report);
	for (int plane = 0; plane < PLANES && !status; plane++)
		status = align(&match, skipped, plane, report);
	if (!status)
		status = align(&match, skipped, ANY, report);
	free(match.taken);
	free(match.row);
	free(match.candidate);
	free(match.cost);
	free(match.from);
	return status;
}

static int taken(const struct hawser__fit *fit, const struct hawser_mode *mode)
{
	for (int i = 0; i < fit->count; i++)
		if (fit->mate[i].plane == (int)mode->plane && fit->mate[i].number == mode->number)
			return 1;
	return 0;
}

void hawser__fit_doubt(struct hawser_identified *identified, const struct hawser__fit *fit,
                       const struct hawser_modes *modes)
{
	identified->doubtful = -1;
	identified->doubt = INFINITY;
	for (int i = 0; i < fit->count; i++) {
		const struct hawser_measured *measured = &fit->measured[i];
		const struct hawser_mode *own = hawser__fit_find(modes, fit->mate[i]);

		for (int k = 0; k < modes->n && own && !hawser__fit_given(measured); k++) {
			const struct hawser_mode *mode = &modes->mode[k];
			double more = square(fit, modes, 1.0, i, k) -
			              square(fit, modes, 1.0, i, (int)(own - modes->mode));

			if (taken(fit, mode) || more >= identified->doubt ||
			    (measured->plane != ANY && (int)mode->plane != measured->plane))
				continue;
			identified->doubtful = i;
			identified->doubt = more;
			identified->other_plane = mode->plane;
			identified->other_number = mode->number;
		}
	}
}
