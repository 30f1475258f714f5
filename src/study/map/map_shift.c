/* study/map/map_shift.c - how far boundaries of stability of one model lie from those of a better one.
 *
 * Boundaries of a plane have an error by what their model leaves out. On a few lines across the plane
 * the edges of the widest unstable region are located in both models, by bisection of the number of
 * instabilities between points that no other boundary separates from them. The distance is what the
 * better model adds; nothing is linearised, so that it holds for regions of every kind.
 *
 * Error by what both models lack: what follows the fluctuating speed has its stiffness and the first
 * correction for its inertia in them (answer_make.c). The next terms, gyroscopic forces on it and
 * higher powers of Omega, are taken for a quarter of that correction. Chosen: the largest part that
 * models with the exact energy and all functions showed is a seventh. Models about rest lack all of it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include <hawser/map.h>

static const double next_terms = 0.25, safety = 1.5;
enum { MOST = 12, STEPS = 11 }; /* crossings of a line; halvings of a bracket, to 1/2000 of it */

/* The models that are compared. */
enum { OWN, BETTER, SWAPPED, MODELS };

struct shifts {
	struct hawser_map_field field[MODELS];
	void *worker[MODELS];
	int models, along;
	double from, to; /* of the line */
};

/* The number of instabilities of a model at t on a line; -1: there is none. */
static enum hawser_status number(int *count, const struct shifts *s, int model, double other, double t,
                                 struct hawser_report *report)
{
	const struct hawser_map_field *field = &s->field[model];
	struct hawser_map_sample sample;
	double x = s->along == 0 ? t : other, y = s->along == 0 ? other : t;
	enum hawser_status status = HAWSER_OK;

	if (field->prepare)
		status = field->prepare(field->context, &x, &y, 1, 1, report);
	if (!status)
		status = field->point(s->worker[model], &sample, NULL, x, y, report);
	*count = !status && sample.code == HAWSER_MAP_OK ? sample.number : -1;
	return status;
}

struct edge {
	double at, reach; /* no other boundary is within reach */
	int rise;         /* 1 or -1: where the number is larger */
};

/* *at: the edge in a model; NAN: not within reach. */
static enum hawser_status place(double *at, const struct shifts *s, int model, double other,
                                const struct edge *edge, struct hawser_report *report)
{
	double low = fmax(edge->at - edge->reach, s->from), high = fmin(edge->at + edge->reach, s->to);
	int a, b = 0, n;
	enum hawser_status status = number(&a, s, model, other, low, report);

	*at = NAN;
	if (!status)
		status = number(&b, s, model, other, high, report);
	if (status || a < 0 || b < 0 || (b - a)*edge->rise <= 0)
		return status;
	for (int i = 0; i < STEPS && !status; i++) {
		double middle = 0.5*(low + high);

		status = number(&n, s, model, other, middle, report);
		if (n < 0)
			return status;
		*((n - a)*edge->rise > 0 ? &high : &low) = middle;
	}
	*at = 0.5*(low + high);
	return status;
}

/* Compare one edge of a region of this width. */
static enum hawser_status compare(struct hawser_map_shift *to, const struct shifts *s, double other,
                                  const struct edge *edge, double width, struct hawser_report *report)
{
	double at[MODELS] = {0.0}, shift;
	enum hawser_status status = HAWSER_OK;

	for (int m = 0; m < s->models && !status; m++)
		status = place(&at[m], s, m, other, edge, report);
	if (status || isnan(at[OWN]))
		return status;
	shift = safety*(isnan(at[BETTER]) ? edge->reach : fabs(at[BETTER] - at[OWN]));
	if (s->models > SWAPPED && !isnan(at[SWAPPED]))
		shift += (s->field[OWN].responds ? next_terms : 1.0)*fabs(at[SWAPPED] - at[OWN]);
	to->compared++;
	to->distance = fmax(to->distance, shift);
	to->share = fmax(to->share, shift/width);
	return HAWSER_OK;
}

/* The widest region between two of the crossings; *first is -1 if there is none. */
static void widest(int *first, const struct hawser_map_line *line, const int *between, int count)
{
	double most = 0.0;

	*first = -1;
	for (int i = 0; i + 1 < count; i++)
		if (between[i] >= 0 && between[i + 2] >= 0 && between[i + 1] > between[i] &&
		    between[i + 1] > between[i + 2] && line->at[i + 1] - line->at[i] > most) {
			*first = i;
			most = line->at[i + 1] - line->at[i];
		}
}

static enum hawser_status compare_line(struct hawser_map_shift *to, const struct shifts *s,
                                       const struct hawser_map_line *line, struct hawser_report *report)
{
	int count = line->count < MOST ? line->count : MOST, between[MOST + 1], first;
	enum hawser_status status = HAWSER_OK;

	for (int i = 0; i <= count && !status; i++) {
		double low = i > 0 ? line->at[i - 1] : s->from, high = i < line->count ? line->at[i] : s->to;

		status = number(&between[i], s, OWN, line->other, 0.5*(low + high), report);
	}
	if (status || count < 2)
		return status;
	widest(&first, line, between, count);
	for (int side = 0; side < 2 && first >= 0 && !status; side++) {
		int i = first + side, next = side ? i + 1 : i - 1;
		double width = line->at[first + 1] - line->at[first];
		double beside = next >= 0 && next < line->count ? fabs(line->at[next] - line->at[i]) : width;
		const struct edge edge = {line->at[i], fmin(0.25*width, 0.5*beside), side ? -1 : 1};

		status = compare(to, s, line->other, &edge, width, report);
	}
	return status;
}

static enum hawser_status open_models(struct shifts *s, const struct hawser_map_source *source,
                                      const struct hawser_map_source *better,
                                      struct hawser_report *report)
{
	struct hawser_map_source of[MODELS] = {*source, *better, *source};
	enum hawser_status status = HAWSER_OK;

	s->models = source->waves > 0 ? MODELS : SWAPPED;
	of[SWAPPED].swapped = 1;
	for (int m = 0; m < s->models && !status; m++) {
		of[m].quantity = "multiplier";
		status = hawser_map_cable_open(&s->field[m], &of[m], report);
		if (!status)
			status = s->field[m].open(&s->worker[m], s->field[m].context, report);
	}
	return status;
}

enum hawser_status hawser_map_shift(struct hawser_map_shift *to, const struct hawser_map_source *source,
                                    const struct hawser_map_source *better, int along,
                                    const struct hawser_map_line *line, int lines,
                                    struct hawser_report *report)
{
	struct shifts s = {.along = along, .from = fmin(source->from[along], source->to[along]),
	                   .to = fmax(source->from[along], source->to[along])};
	enum hawser_status status = open_models(&s, source, better, report);

	*to = (struct hawser_map_shift){.compared = 0};
	for (int i = 0; i < lines && !status; i++)
		status = compare_line(to, &s, &line[i], report);
	for (int m = 0; m < s.models; m++) {
		if (s.worker[m])
			s.field[m].close(s.worker[m]);
		hawser_map_cable_close(&s.field[m]);
	}
	return status;
}
