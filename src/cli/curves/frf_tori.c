/* cli/curves/frf_tori.c - see frf_tori.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/curves/frf_over.h"
#include "cli/curves/frf_tori.h"
#include "cli/curves/frf_picture.h"
#include "cli/frame/view.h"
#include "core/report.h"

#define NEAR 1e-6 /* relative distance of two torus points that are the same; chosen */

enum hawser_status cli_tori_check(const char *method, struct hawser_report *report)
{
	if (method && strcmp(method, "multiple-scales") == 0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "frf",
		                    "--tori: circles of the model's period map begin at its torus points, and "
		                    "those of --method multiple-scales are approximations: use shooting or "
		                    "balance");
	return HAWSER_OK;
}

/* Whether a curve ends at this event. */
static int known(const struct hawser_tori *tori, int curves, const struct hawser_frf *frf, int event)
{
	double at = frf->event[event].parameter;

	for (int k = 0; k < curves; k++) {
		if (tori[k].branch == frf->branch && tori[k].to == event)
			return 1;
		if (fabs(tori[k].from_at - at) < NEAR*fabs(at) || fabs(tori[k].to_at - at) < NEAR*fabs(at))
			return 1;
	}
	return 0;
}

static int torus_points(const struct hawser_frf *frf)
{
	int count = 0;

	for (int e = 0; e < frf->events; e++)
		count += frf->event[e].kind == HAWSER_TORUS && frf->event[e].located;
	return count;
}

/* The curves from the events of a branch. */
static enum hawser_status trace_branch(struct hawser_tori *tori, int *curves,
                                       const struct hawser_frf *frf, const struct hawser_rom *rom,
                                       const struct hawser_tori_options *options,
                                       struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	for (int e = 0; e < frf->events && !status && !cli_interrupted(); e++) {
		struct hawser_tori *now = tori + *curves;

		if (frf->event[e].kind != HAWSER_TORUS || !frf->event[e].located ||
		    known(tori, *curves, frf, e))
			continue;
		status = hawser_tori_trace(now, rom, frf, e, options, report);
		now->curve = ++*curves;
		if (status == HAWSER_ERR_CONVERGENCE ||
		    (status == HAWSER_ERR_ARGUMENT && frf->branch > 1)) {
			now->end = HAWSER_TORI_LOST;
			snprintf(now->lost, sizeof now->lost, "%s", report->message);
			status = HAWSER_OK;
		}
	}
	return status;
}

enum hawser_status cli_tori_trace(struct hawser_tori **tori, struct cli_frf_result *result,
                                  int end_at_slack, struct hawser_report *report)
{
	struct cli_watch watch = {{.quiet = result->common->quiet}, "tori"};
	const struct cli_over *over = result->over;
	struct hawser_tori_options choice = {.family = over ? &over->family : NULL,
		.from = over ? over->from : result->from, .to = over ? over->to : result->to,
		.end_at_slack = end_at_slack, .progress = {cli_watch, &watch}};
	int room = torus_points(result->frf);
	enum hawser_status status;

	for (int k = 0; k < result->others; k++)
		room += torus_points(result->other[k].frf);
	result->tori = *tori = calloc((size_t)room + 1, sizeof **tori);
	if (!*tori)
		return hawser__no_memory(report, "frf");
	status = trace_branch(*tori, &result->curves, result->frf, &result->model->rom, &choice, report);
	for (int k = 0; k < result->others && !status; k++)
		status = trace_branch(*tori, &result->curves, result->other[k].frf, &result->model->rom,
		                      &choice, report);
	cli_progress_end(&watch.progress);
	return status;
}

void cli_tori_clear(struct hawser_tori *tori, int curves)
{
	for (int k = 0; tori && k < curves; k++)
		hawser_tori_clear(&tori[k]);
	free(tori);
}

HAWSER__OF(is_stable, double, struct hawser_tori_point, of->unstable + of->undecided == 0)

/* --- comments --- */

static const char *sentence(enum hawser_tori_end end)
{
	switch (end) {
	case HAWSER_TORI_RANGE: return "the tori reach an end of the range";
	case HAWSER_TORI_TORUS_POINT: return "the tori shrink to a periodic motion";
	case HAWSER_TORI_MAX_POINTS: return "as many tori as are allowed";
	case HAWSER_TORI_INTERRUPTED: return "interrupted; the curve is incomplete";
	case HAWSER_TORI_SLACK: return "on the next torus the cable goes slack";
	case HAWSER_TORI_ROUGH: return "the torus loses its smoothness";
	case HAWSER_TORI_LOST: return "no torus is found beyond";
	}
	return "";
}

static void comment(struct hawser__table *table, const struct cli_frf_result *result, int k)
{
	const struct hawser_tori *tori = &result->tori[k];
	/* NOLINTNEXTLINE(clang-analyzer-core.NullDereference): k is below their number */
	const struct hawser_tori_point *last = tori->point + tori->points - 1;
	double per = cli_per_omega(result->model), worst = 0.0;
	const struct cli_over *over = result->over;
	double per_at = over ? 1.0 : per;
	const char *unit = cli_unit(result->model, " rad/s");
	int stable = 0;

	if (tori->points == 0) {
		hawser__table_comment(table, "tori %d: none from the torus point at %s: %s", k + 1,
		                      cli_frf_place(result, tori->from_at, tori->from_at).text, tori->lost);
		return;
	}
	for (int i = 0; i < tori->points; i++) {
		stable += is_stable(&tori->point[i]) > 0.0;
		worst = fmax(worst, tori->point[i].error);
	}
	hawser__table_comment(table, "tori %d: from the torus point of branch %d at %s = %.12g to %.12g"
	                      "%s, %d tori, %d of them stable, largest error %.1e", k + 1, tori->branch,
	                      over ? over->axis.key : "Omega", tori->from_at*per_at,
	                      (isfinite(tori->to_at) ? tori->to_at : last->parameter)*per_at,
	                      over ? "" : unit, tori->points, stable, worst);
	hawser__table_comment(table, "tori %d: second frequency %.9g to %.9g%s, growth per period %.3g to "
	                      "%.3g", k + 1, tori->point[0].second*per, last->second*per, unit,
	                      tori->point[0].growth, last->growth);
	hawser__table_comment(table, "tori %d: end: %s - %s%s%s", k + 1, hawser_tori_end_name(tori->end),
	                      sentence(tori->end), *tori->lost ? ": " : "", tori->lost);
}

void cli_tori_comments(struct hawser__table *table, const struct cli_frf_result *result)
{
	if (result->tori && result->curves == 0)
		hawser__table_comment(table, "tori: none, since no torus point was located");
	for (int k = 0; k < result->curves; k++)
		comment(table, result, k);
}

/* --- fields --- */

HAWSER__LABELS(end_name, hawser_tori_end_name, enum hawser_tori_end)

#define OF(member) HAWSER__AT(struct hawser_tori_point, member)
#define TENSION_OF(which) HAWSER__ALONG(struct hawser_tori, tension), .stride = 2, .item = (which), \
	.unit = HAWSER__NEWTON, .when = CLI_TORI_TENSION
#define COMMON \
	{"parameter", "parameter", "value of the key of --over, in SI", OF(parameter), \
	 .when = CLI_TORI_OVER}, \
	{"Omega", "Omega", "forcing frequency", OF(omega), .unit = HAWSER__RAD_S}, \
	{"stable", "stable", "whether motions beside the torus approach it", \
	 HAWSER__FLAG_BY(is_stable)}, \
	{"unstable", "unstable", "directions in which they leave it", OF(unstable)}
#define COLUMNS(sign) \
	{NULL, "T_min", "", TENSION_OF(0)}, {NULL, "T_max", "", TENSION_OF(1)}, \
	{NULL, "residual", "", OF(residual)}, {NULL, "error", "", OF(error)}, \
	{NULL, "tori", "", HAWSER__IN(struct hawser_tori, curve)}, \
	{NULL, "extreme", "", HAWSER__CONSTANT_IS(sign)}

static const struct hawser__field most_field[] = {
	COMMON,
	CLI_AMPLITUDE(HAWSER__VECTOR_ALONG, struct hawser_tori, probe_most),
	CLI_COORDINATES(HAWSER__VECTOR_ALONG, struct hawser_tori, coordinate_most),
	COLUMNS(1),
	HAWSER__END,
};
static const struct hawser__field least_field[] = {
	COMMON,
	CLI_AMPLITUDE(HAWSER__VECTOR_ALONG, struct hawser_tori, probe_least),
	CLI_COORDINATES(HAWSER__VECTOR_ALONG, struct hawser_tori, coordinate_least),
	COLUMNS(-1),
	HAWSER__END,
};
const struct hawser__list cli_torus_most_list =
	HAWSER__STORED_ROWS(struct hawser_tori, point, points, most_field);
const struct hawser__list cli_torus_least_list =
	HAWSER__STORED_ROWS(struct hawser_tori, point, points, least_field);

static const struct hawser__field torus_field[] = {
	COMMON,
	{"undecided", NULL, "directions of which that is not known: within the error", OF(undecided)},
	{"rotation", NULL, "rotation number: rad per period of the load", OF(rotation)},
	{"second", NULL, "second frequency of the motion: rotation times Omega over 2 pi", OF(second),
	 .unit = HAWSER__RAD_S},
	{"growth", NULL, "largest logarithm of growth per period, not along the torus; < 0: it attracts",
	 OF(growth)},
	{"growth_error", NULL, "estimated error of it", OF(growth_error)},
	{"amplitude_least", NULL, "least of the largest displacements of a period of the load",
	 HAWSER__VECTOR_ALONG(struct hawser_tori, probe_least, cli_probes), .unit = HAWSER__M},
	{"amplitude", NULL, "greatest of them",
	 HAWSER__VECTOR_ALONG(struct hawser_tori, probe_most, cli_probes), .unit = HAWSER__M},
	{"coordinates_least", NULL, "least of the largest |u_j| of a period of the load",
	 HAWSER__VECTOR_ALONG(struct hawser_tori, coordinate_least, cli_coordinates), .unit = HAWSER__M},
	{"coordinates", NULL, "greatest of them",
	 HAWSER__VECTOR_ALONG(struct hawser_tori, coordinate_most, cli_coordinates), .unit = HAWSER__M},
	{"tension.min", NULL, "least tension on the torus", TENSION_OF(0)},
	{"tension.max", NULL, "greatest tension on the torus", TENSION_OF(1)},
	{"state", NULL, "u and u' of one of its motions at the start of a period",
	 HAWSER__VECTOR_ALONG(struct hawser_tori, state, cli_states), .unit = HAWSER__M},
	{"residual", NULL, "defect at the points of the circle, relative", OF(residual)},
	{"error", NULL, "defect between them, with half the length of steps, relative", OF(error)},
	{"circle", NULL, "points of the circle", OF(circle)},
	{"steps", NULL, "Runge-Kutta steps a period", OF(steps)},
	HAWSER__END,
};
#undef OF

HAWSER__GIVEN(has_end, struct hawser_tori, isfinite(of->to_at))

HAWSER__GIVEN(has_reason, struct hawser_tori, *of->lost != '\0')

#define OF(member) HAWSER__AT(struct hawser_tori, member)
const struct hawser__field cli_tori_field[] = {
	{"branch", NULL, "of the torus point at which the curve begins", OF(branch)},
	{"from", NULL, "Omega of that torus point", OF(from_at), .unit = HAWSER__RAD_S,
	 .when = CLI_TORI_PLAIN},
	{"to", NULL, "Omega of the torus point at which it ends", OF(to_at), .unit = HAWSER__RAD_S,
	 .given = has_end, .when = CLI_TORI_PLAIN},
	{"from", NULL, "its parameter, with --over", OF(from_at), .when = CLI_TORI_OVER},
	{"to", NULL, "likewise", OF(to_at), .given = has_end, .when = CLI_TORI_OVER},
	{"end", NULL, "why it ends", HAWSER__LABEL_AT(struct hawser_tori, end, end_name)},
	{"lost", NULL, "more about it", OF(lost), .given = has_reason},
	{"points", NULL, "tori", HAWSER__STORED(struct hawser_tori, point, points, torus_field)},
	HAWSER__END,
};
#undef OF

/* --- picture: a band between the least and the greatest amplitude, over the curve's Omega --- */

/* A curve of quasi-periodic motions, of one displacement or coordinate, with the torus points at
 * its ends: there the amplitude is that between the two of the torus beside it. */
struct band {
	const struct hawser_tori *tori;
	const double *least, *most; /* [tori->points] at a stride */
	size_t stride;
	int points; /* with those at the ends */
};

static struct band band_of(const struct cli_frf_picture *of, int c, const struct hawser_tori *tori)
{
	size_t source = (size_t)of->curve[c].source;
	const double *least = of->probed ? tori->probe_least : tori->coordinate_least;
	const double *most = of->probed ? tori->probe_most : tori->coordinate_most;

	if (tori->points == 0)
		return (struct band){.points = 0};
	return (struct band){tori, least + source, most + source,
		of->probed ? 3*(size_t)tori->probes : (size_t)tori->n,
		tori->points + 1 + isfinite(tori->to_at)};
}

/* Its torus at point i, counted from the torus point where it begins. */
static int torus_at(const struct band *band, int i)
{
	return i < 1 ? 0 : i > band->tori->points ? band->tori->points - 1 : i - 1;
}

static int unstable_at(const struct band *band, int i)
{
	return !(is_stable(&band->tori->point[torus_at(band, i)]) > 0.0);
}

static void put_edge(struct cli_frf_picture *of, const struct band *band, int i, int greatest)
{
	size_t row = (size_t)torus_at(band, i)*band->stride;
	double at = i < 1 ? band->tori->from_at : i > band->tori->points ? band->tori->to_at
	            : band->tori->point[i - 1].parameter;
	double value = i < 1 || i > band->tori->points ? 0.5*(band->least[row] + band->most[row])
	               : greatest ? band->most[row] : band->least[row];

	hawser__figure_put(&of->figure, at*(of->result->over ? 1.0 : of->per_omega),
	                   value*of->per_length);
}

/* Edges of all parts with this stability, one after the other; a part includes the first point of the
 * next one. Filled: there along the greatest amplitudes and back along the least. */
static void put_parts(struct cli_frf_picture *of, const struct band *band, int unstable, int filled)
{
	for (int i = 0, last; i < band->points; i = last + 1) {
		int to;

		for (last = i; last + 1 < band->points && unstable_at(band, last + 1) == unstable_at(band, i);)
			last++;
		to = last + 1 < band->points ? last + 1 : last;
		if (unstable != unstable_at(band, i))
			continue;
		for (int p = i; p <= to; p++)
			put_edge(of, band, p, 1);
		if (!filled)
			hawser__figure_gap(&of->figure);
		for (int p = i; p <= to; p++)
			put_edge(of, band, filled ? to - (p - i) : p, 0);
		hawser__figure_gap(&of->figure);
	}
}

/* The bands lie behind the curves; their edges are solid where the tori are stable, else dashed. */
void cli_tori_bands(struct cli_frf_picture *of, int panel)
{
	static const char *const fill[2][2] = {{"#9CC9E6", "#DCEBF5"}, {"#F2C097", "#FAE6D6"}};
	static const char *const edge[] = {"#4A93C0", "#D08A4E"};

	for (int filled = 1; filled >= 0; filled--)
		for (int n = 0; n < 2*of->curves; n++) {
			int c = n/2, unstable = 1 - n % 2;

			for (int k = 0; k < of->result->curves && of->curve[c].panel == panel; k++) {
				struct band band = band_of(of, c, &of->result->tori[k]);

				put_parts(of, &band, unstable, filled);
			}
			if (!filled) {
				hawser__figure_draw(&of->figure, NULL, "with lines lc rgb '%s' lw 0.7 %s", edge[c % 2],
				                    unstable ? HAWSER__UNSTABLE_DASH : "dt solid");
				continue;
			}
			hawser__figure_draw(&of->figure, NULL,
			                    "with filledcurves closed fc rgb '%s' fs solid noborder",
			                    fill[c % 2][unstable]);
			hawser__figure_again(&of->figure, unstable ? "unstable tori" : "tori",
			                     "using (NaN):1 with lines lw 8 lc rgb '%s'", fill[0][unstable]);
		}
}
