/* cli/curves/frf_tori.c - see frf_tori.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/curves/frf_tori.h"
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
	double omega = frf->event[event].omega;

	for (int k = 0; k < curves; k++) {
		if (tori[k].branch == frf->branch && tori[k].to == event)
			return 1;
		if (fabs(tori[k].from_omega - omega) < NEAR*omega ||
		    fabs(tori[k].to_omega - omega) < NEAR*omega)
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
	struct hawser_tori_options choice = {.from = result->from, .to = result->to,
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

static double is_stable(const void *row)
{
	const struct hawser_tori_point *point = row;

	return point->unstable + point->undecided == 0;
}

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
	const struct hawser_tori_point *last = tori->point + tori->points - 1;
	double per = cli_per_omega(result->model), worst = 0.0;
	const char *unit = cli_unit(result->model, " rad/s");
	int stable = 0;

	if (tori->points == 0) {
		hawser__table_comment(table, "tori %d: none from the torus point at Omega = %.12g%s: %s", k + 1,
		                      tori->from_omega*per, unit, tori->lost);
		return;
	}
	for (int i = 0; i < tori->points; i++) {
		stable += is_stable(&tori->point[i]) > 0.0;
		worst = fmax(worst, tori->point[i].error);
	}
	hawser__table_comment(table, "tori %d: from the torus point of branch %d at Omega = %.12g to %.12g"
	                      "%s, %d tori, %d of them stable, largest error %.1e", k + 1, tori->branch,
	                      tori->from_omega*per,
	                      (isfinite(tori->to_omega) ? tori->to_omega : last->omega)*per, unit,
	                      tori->points, stable, worst);
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

static int has_end(const void *row, const void *parent)
{
	(void)parent;
	return isfinite(((const struct hawser_tori *)row)->to_omega);
}

static int has_reason(const void *row, const void *parent)
{
	(void)parent;
	return *((const struct hawser_tori *)row)->lost != '\0';
}

#define OF(member) HAWSER__AT(struct hawser_tori, member)
const struct hawser__field cli_tori_field[] = {
	{"branch", NULL, "of the torus point at which the curve begins", OF(branch)},
	{"from", NULL, "Omega of that torus point", OF(from_omega), .unit = HAWSER__RAD_S},
	{"to", NULL, "Omega of the torus point at which it ends", OF(to_omega), .unit = HAWSER__RAD_S,
	 .given = has_end},
	{"end", NULL, "why it ends", HAWSER__LABEL_AT(struct hawser_tori, end, end_name)},
	{"lost", NULL, "more about it", OF(lost), .given = has_reason},
	{"points", NULL, "tori", HAWSER__STORED(struct hawser_tori, point, points, torus_field)},
	HAWSER__END,
};
#undef OF

/* --- picture --- */

void cli_tori_undraw(struct hawser__response_torus *torus, int count)
{
	for (int k = 0; torus && k < count; k++)
		free(torus[k].omega);
	free(torus);
}

/* A torus point at an end: the amplitude is that between the two of the torus beside it. */
static void close_at(struct hawser__response_torus *torus, int to, int from, double omega, int curves)
{
	int P = torus->points;

	torus->omega[to] = omega;
	torus->unstable[to] = torus->unstable[from];
	for (int c = 0; c < curves; c++)
		torus->least[c*P + to] = torus->most[c*P + to] =
			0.5*(torus->least[c*P + from] + torus->most[c*P + from]);
}

static int draw_one(struct hawser__response_torus *torus, const struct hawser_tori *tori,
                    const int *source, int curves, int probed, double per_omega, double per_length)
{
	int shut = isfinite(tori->to_omega), P = tori->points + 1 + shut;
	size_t wide = probed ? 3*(size_t)tori->probes : (size_t)tori->n;
	const double *least = probed ? tori->probe_least : tori->coordinate_least;
	const double *most = probed ? tori->probe_most : tori->coordinate_most;
	double *memory = calloc((size_t)P*(2 + 2*(size_t)curves), sizeof *memory);

	if (!memory)
		return 1;
	*torus = (struct hawser__response_torus){.points = P, .omega = memory, .unstable = memory + P,
		.least = memory + 2*P, .most = memory + (2 + curves)*P};
	for (int i = 0; i < tori->points; i++) {
		torus->omega[i + 1] = tori->point[i].omega*per_omega;
		torus->unstable[i + 1] = !(is_stable(&tori->point[i]) > 0.0);
		for (int c = 0; c < curves; c++) {
			size_t at = (size_t)i*wide + (size_t)source[c];

			torus->least[c*P + i + 1] = least[at]*per_length;
			torus->most[c*P + i + 1] = most[at]*per_length;
		}
	}
	close_at(torus, 0, 1, tori->from_omega*per_omega, curves);
	if (shut)
		close_at(torus, P - 1, P - 2, tori->to_omega*per_omega, curves);
	return 0;
}

int cli_tori_draw(struct hawser__response_torus **torus, const struct cli_frf_result *result,
                  const int *source, int curves, int probed, double per_omega, double per_length)
{
	int failed = 0;

	*torus = calloc((size_t)result->curves + 1, sizeof **torus);
	for (int k = 0; *torus && k < result->curves && !failed; k++)
		if (result->tori[k].points > 0)
			failed = draw_one(*torus + k, &result->tori[k], source, curves, probed, per_omega,
			                  per_length);
	return failed || !*torus;
}
