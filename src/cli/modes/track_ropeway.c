/* cli/modes/track_ropeway.c - see modes_result.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/model/axis.h"
#include "cli/frame/progress.h"
#include "cli/modes/modes_result.h"
#include "core/report.h"
#include "output/drawing/figure.h"

#define PASSING "with lines lc rgb '#909090' lw 0.8 dt (3,3)" /* of carriers */

/* Values of a sweep of campbell and irvine: by default, and at most. */
enum { POINTS = 41, MOST = CLI_KEY_SWEEP_MOST };
#define FASTEST "10 m/s" /* ropeways run at up to some 12 m/s, chairlifts at 5 */
#define AROUND 2.0       /* irvine: the tension of the scene over and times this */

static const char *const tension_name[] = {"counterweight", "T0", "length0", "T_empty"};
static const char *const unit_name[] = {"rad/s", "Hz"};

/* --- the scene at a value --- */

static enum hawser_status open_at(struct hawser_ropeway *rw, void *context, double value,
                                  struct hawser_report *report)
{
	const struct cli_track *t = context;
	struct cli_common common = *t->common;
	char set[CLI_KEY_SWEEP_SET] = "";
	int load_case;
	enum hawser_status status;

	if (t->swept == CLI_SWEPT_KEY)
		cli_key_sweep_at(&common, set, &t->sweep, t->common, value);
	status = cli_ropeway_open(rw, &load_case, &common, t->command, &t->choice, report);
	if (status)
		return cli_key_sweep_blame(report, status, &t->sweep, set);
	if (t->swept == CLI_SWEPT_SPEED) {
		rw->speed = value;
		rw->sliding = rw->sliding == HAWSER_ROPEWAY_REST ? HAWSER_ROPEWAY_RUNNING : rw->sliding;
		if (rw->hold == HAWSER_ROPEWAY_HOLD_AUTO) /* at the speed 0 as at all others */
			rw->hold = HAWSER_ROPEWAY_HOLD_SLIP;
	}
	if (t->swept == CLI_SWEPT_TENSION)
		rw->value = value;
	return HAWSER_OK;
}

static enum hawser_status open_span(struct hawser_obstacles *span, const struct cli_common *common,
                                    const struct cli_track *t, struct hawser_report *report)
{
	static const char *const name[] = {"slip", "stick"};
	enum hawser_status status = cli_read_obstacles(span, common, report);

	return status || !t->choice.contact ? status
		: cli_choose(&span->modes, t->command, "contact", t->choice.contact, name, 2, report);
}

static enum hawser_status open_span_at(struct hawser_obstacles *span, void *context, double value,
                                       struct hawser_report *report)
{
	const struct cli_track *t = context;
	struct cli_common common;
	char set[CLI_KEY_SWEEP_SET];

	cli_key_sweep_at(&common, set, &t->sweep, t->common, value);
	return cli_key_sweep_blame(report, open_span(span, &common, t, report), &t->sweep, set);
}

/* --- what is swept --- */

static enum hawser_status range_of(double *from, double *to, struct cli_track *t,
                                   struct hawser_report *report)
{
	const struct hawser_ropeway *rw = &t->ropeway;
	enum cli_sign sign = t->swept == CLI_SWEPT_SPEED ? CLI_NOT_NEGATIVE : CLI_ABOVE_ZERO;
	int length = t->swept == CLI_SWEPT_TENSION && rw->tension == HAWSER_ROPEWAY_LENGTH0;
	enum hawser_status status;

	*from = t->swept == CLI_SWEPT_SPEED ? 0.0 : length ? rw->value*1.0005 : rw->value/AROUND;
	*to = length ? rw->value*0.9995 : rw->value*AROUND;
	snprintf(t->sweep.key, sizeof t->sweep.key, "%s",
	         t->swept == CLI_SWEPT_SPEED ? "speed" : tension_name[rw->tension]);
	snprintf(t->sweep.si, sizeof t->sweep.si, "%s",
	         t->swept == CLI_SWEPT_SPEED ? "m/s" : length ? "m" : "N");
	status = cli_quantity(from, t->from, t->sweep.si, sign, t->command, "from", report);
	if (!status)
		status = cli_quantity(to, t->to || t->swept == CLI_SWEPT_TENSION ? t->to : FASTEST, t->sweep.si,
		                      sign, t->command, "to", report);
	t->points = t->points ? t->points : POINTS;
	if (!status && (*from == *to || t->points > MOST))
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, t->command, "--from and --to are both %.9g "
		                      "%s, or --points is above %d: give a range, and 2 to %d points", *from,
		                      t->sweep.si, MOST, MOST);
	return status;
}

static enum hawser_status place(struct cli_track *t, struct hawser_report *report)
{
	double from = 0.0, to = 0.0;
	enum hawser_status status;

	t->sweep.command = t->command;
	t->sweep.over = t->over;
	t->sweep.logarithmic = t->logarithmic;
	t->sweep.example = t->obstacles ? "obstacles.s0.circle.centre.1=-8 m:-5 m:41"
	                                : "ropeway.towers.p0.at.1=15 m:20 m:41";
	if (t->swept == CLI_SWEPT_KEY)
		return cli_key_sweep_read(&t->sweep, report);
	status = range_of(&from, &to, t, report);
	t->sweep.points = t->points;
	return status ? status : cli_key_sweep_place(&t->sweep, from, to, report);
}

/* --- the result --- */

static struct cli_head head(const void *of)
{
	const struct cli_track *t = of;

	return cli_si_head(t->common, t->command, "spectral elements, piece by piece", t,
	                   cli_track_view(t));
}

/* Where the rope leaves an obstacle, or comes to touch one. */
static void touched_comments(struct hawser__table *table, const struct cli_track *t)
{
	const struct hawser_ropeway_track *track = &t->track;

	if (t->obstacles)
		hawser__table_comment(table, "obstacles touched: %d of %d at %s = %.9g%s%s",
		                      track->sample[0].touched, t->span.line.sheaves, t->sweep.key,
		                      track->sample[0].value, *t->sweep.si ? " " : "", t->sweep.si);
	for (int i = 1; i < track->samples; i++)
		if (track->sample[i].touched != track->sample[i - 1].touched)
			hawser__table_comment(table, "between %s = %.9g and %.9g%s%s: %d touched", t->sweep.key,
			                      track->sample[i - 1].value, track->sample[i].value,
			                      *t->sweep.si ? " " : "", t->sweep.si, track->sample[i].touched);
}

static void resonance_comments(struct hawser__table *table, const struct cli_track *t)
{
	if (t->harmonics > 0 && t->distance > 0.0)
		hawser__table_comment(table, "excitation: n*2*pi*v/%.10g m, n up to %d; meetings with the "
		                      "branches are interpolated", t->distance, t->harmonics);
	for (int i = 0; i < t->resonances; i++) {
		const struct hawser_campbell_resonance *at = &t->resonance[i];

		hawser__table_comment(table, "resonance: harmonic %d with branch %d (%s) at %.8g m/s, omega = "
		                      "%.8g rad/s", at->harmonic, at->branch + 1,
		                      hawser_plane_name(t->track.plane[at->branch]), at->speed, at->omega);
	}
}

static void comments(struct hawser__table *table, const void *of)
{
	const struct cli_track *t = of;
	const struct hawser_ropeway_track *track = &t->track;
	int unsure = 0;

	for (int i = 0; i < track->samples; i++)
		unsure += track->sample[i].unsure;
	hawser__table_comment(table, "%s from %.9g to %.9g%s%s%s%s", t->sweep.key,
	                      track->sample[0].value, track->sample[track->samples - 1].value,
	                      *t->sweep.si ? " " : "", t->sweep.si, t->obstacles ? "" : "; case ",
	                      t->obstacles ? "" : t->ropeway.load_case[t->load_case].name);
	hawser__table_comment(table, "%d modal solutions; least squared correlation of a branch %.3g",
	                      track->solves, track->least_correlation);
	if (unsure > 0)
		hawser__table_comment(table, "at %d values a branch was continued by shapes that had changed "
		                      "by more than a half", unsure);
	touched_comments(table, t);
	resonance_comments(table, t);
	for (int i = 0; i < track->crossovers; i++) {
		const struct hawser_ropeway_track_crossover *at = &track->crossover[i];

		char pair[48];

		if (at->below < 0 || at->above < 0)
			snprintf(pair, sizeof pair, "branch %d and one that is not followed",
			         1 + (at->below < 0 ? at->above : at->below));
		else
			snprintf(pair, sizeof pair, "branches %d and %d", at->below + 1, at->above + 1);
		hawser__table_comment(table, "%s at %s = %.9g%s%s: %s, omega = %.9g rad/s, relative gap %.2e",
		                      at->veers ? "veering" : "crossing", t->sweep.key, at->value,
		                      *t->sweep.si ? " " : "", t->sweep.si, pair, at->omega, at->gap);
	}
	if (track->interrupted)
		hawser__table_comment(table, "interrupted");
	if (track->ended)
		hawser__table_comment(table, "the sweep ends before %s = %.9g%s%s: %s", t->sweep.key,
		                      track->end,
		                      *t->sweep.si ? " " : "", t->sweep.si, track->why.message);
}

/* Lines of the passing of carriers, each with its number where it leaves the panel. */
static void draw_harmonics(struct hawser__figure *figure, const struct cli_track *t, double last,
                           double high)
{
	for (int k = 1; t->distance > 0.0 && k <= t->harmonics; k++) {
		double slope = k*2.0*M_PI/t->distance/(t->hertz ? 2.0*M_PI : 1.0), x = fmin(last, high/slope);

		hawser__figure_label(figure, x, slope*x,
		                     "right offset -0.6,-0.5 tc rgb '#606060' font ',8'", "%d",
		                     k);
		hawser__figure_function(figure, NULL, "%.9g*x " PASSING,
		                        slope*figure->at.x.axis->per/figure->at.y.axis->per);
	}
}

static double shown_frequency(const struct cli_track *t, double omega)
{
	return t->hertz ? omega/(2.0*M_PI) : omega;
}

/* Branches have the colour of their plane. */
static void draw_branches(struct hawser__figure *figure, const struct cli_track *t)
{
	const struct hawser_ropeway_track *track = &t->track;

	for (int k = 0; k < 2*track->branches; k++) { /* those of the plane first */
		int b = k % track->branches, out = k/track->branches;

		for (int i = 0; i < track->samples && (track->plane[b] == HAWSER_OUT_OF_PLANE) == out; i++)
			hawser__figure_put(figure, track->sample[i].value,
			                   shown_frequency(t, track->point[i*track->branches + b].omega));
		hawser__figure_draw(figure, out ? "out-of-plane" : "in-plane", out
		                    ? "with lines lt 3 lw 1.1 dt (9,5)" : "with lines lt 1 lw 1.4");
	}
	for (int i = 0; i < t->resonances; i++)
		hawser__figure_put(figure, t->resonance[i].speed, shown_frequency(t, t->resonance[i].omega));
	hawser__figure_draw(figure, "resonance", "with points pt 12 ps 0.8 lw 1.2 lc rgb '#d55e00'");
	for (int veers = 0; veers < 2; veers++) {
		for (int i = 0; i < track->crossovers; i++)
			if (track->crossover[i].veers == veers)
				hawser__figure_put(figure, track->crossover[i].value,
				                   shown_frequency(t, track->crossover[i].omega));
		if (veers)
			hawser__figure_draw(figure, "veering", "with points pt 7 ps 0.6 lc rgb 'black'");
		else
			hawser__figure_draw(figure, "crossing", "with points pt 6 ps 0.7 lc rgb 'black'");
	}
}

/* Numbers of the branches at the last sample, moved apart where they would meet. */
static void draw_numbers(struct hawser__figure *figure, const struct cli_track *t, double tall)
{
	const double apart = 0.028; /* of the height of the axis: between two numbers */
	const struct hawser_ropeway_track *track = &t->track;
	const struct hawser_ropeway_track_sample *last = &track->sample[track->samples - 1];
	const struct hawser_ropeway_track_point *point =
		track->point + (track->samples - 1)*track->branches;
	double before = -INFINITY, from = -INFINITY;

	for (int k = 0; k < track->branches; k++) {
		int next = -1;

		for (int b = 0; b < track->branches; b++)
			if (point[b].omega > from && (next < 0 || point[b].omega < point[next].omega))
				next = b;
		if (next < 0)
			break;
		from = point[next].omega;
		before = fmax(shown_frequency(t, from), before + apart*tall);
		hawser__figure_label(figure, last->value, before, last->value > track->sample[0].value
		                     ? "left offset 0.6,0 font ',8'" : "left offset -1.4,0 font ',8'", "%d",
		                     next + 1);
	}
}

static enum hawser_status draw(const char *path, const void *of, struct hawser_report *report)
{
	static const char *const title[] = {"Counterweight", "Tension {/:Italic T}_0",
	                                    "Length of the loop", "Tension of the empty rope"};
	const double height = 12.0; /* cm */
	const struct cli_track *t = of;
	const struct hawser_ropeway_track *track = &t->track;
	double first = track->sample[0].value, last = track->sample[track->samples - 1].value;
	double low = INFINITY, high = 0.0, margin;
	char label[160];
	const char *what = t->swept == CLI_SWEPT_SPEED ? "Speed {/:Italic v}" : title[t->ropeway.tension];
	struct hawser__axis x, y = hawser__axis_of("Frequency", t->hertz ? "Hz" : "rad/s", 0.0);
	struct hawser__figure figure = {0};
	enum hawser_status status = hawser__figure_begin(&figure, path, 17.0, height, report);

	if (status)
		return status;
	if (t->swept == CLI_SWEPT_KEY) {
		cli_key_title(label, sizeof label, t->sweep.key);
		what = label;
	}
	x = hawser__axis_of(what, t->sweep.si, fmax(fabs(t->sweep.value[0]),
	                                            fabs(t->sweep.value[t->sweep.points - 1])));
	for (int i = 0; i < track->samples*track->branches; i++) {
		low = fmin(low, shown_frequency(t, track->point[i].omega));
		high = fmax(high, shown_frequency(t, track->point[i].omega));
	}
	low = t->distance > 0.0 && t->harmonics > 0 ? 0.0 : low; /* the lines begin at 0 */
	margin = fmax(0.06*(high - low), 1e-3*high);
	low = fmax(low - margin, 0.0);
	high += margin;
	hawser__figure_panel(&figure, &(struct hawser__panel_frame){0.125, 0.955,
		HAWSER__LEGEND_CM/height, 0.97,
		.x = {&x, fmin(first, last), fmax(first, last), .tics = 8, .logarithmic = t->logarithmic},
		.y = {&y, low, high, .tics = 8}});
	draw_harmonics(&figure, t, fmax(first, last), high);
	draw_branches(&figure, t);
	draw_numbers(&figure, t, high - low);
	if (t->distance > 0.0 && t->harmonics > 0)
		hawser__legend_once(&figure.legend, "passing of carriers, and its multiples", PASSING);
	return hawser__figure_finish(&figure, report);
}

static const struct cli_showing showing = {
	.head = head, .comments = comments, .rows = &cli_track_rows, .fields = cli_track_member,
	.draw = draw};

/* Where the harmonics of the passing of carriers meet the branches. */
static enum hawser_status resonances(struct cli_track *t, struct hawser_report *report)
{
	const struct hawser_ropeway_track *track = &t->track;
	size_t values = (size_t)track->samples*(size_t)track->branches;
	struct hawser_campbell campbell = {.stations = track->samples, .branches = track->branches};
	enum hawser_status status;

	campbell.station = calloc((size_t)track->samples, sizeof *campbell.station);
	campbell.im = calloc(values + 1, sizeof *campbell.im);
	status = campbell.station && campbell.im ? HAWSER_OK : hawser__no_memory(report, t->command);
	for (int i = 0; i < track->samples && !status; i++)
		campbell.station[i].speed = track->sample[i].value;
	for (size_t i = 0; i < values && !status; i++)
		campbell.im[i] = track->point[i].omega;
	if (!status)
		status = hawser_campbell_resonances(&t->resonance, &t->resonances, &campbell, t->distance,
		                                    t->harmonics, report);
	free(campbell.station);
	free(campbell.im);
	return status;
}

static enum hawser_status follow(struct cli_track *t, struct hawser_report *report)
{
	struct cli_watch watch = {.progress = {.quiet = t->common->quiet}};
	enum hawser_status status = hawser_ropeway_track_solve(&t->track,
		&(struct hawser_ropeway_track_options){
			.value = t->sweep.value, .points = t->sweep.points, .open = t->obstacles ? NULL : open_at,
			.open_obstacles = t->obstacles ? open_span_at : NULL, .context = t,
			.load_case = t->load_case, .n = t->n, .progress = {cli_watch, &watch}}, report);

	cli_progress_end(&watch.progress);
	return status || !(t->distance > 0.0) || t->harmonics < 1 ? status : resonances(t, report);
}

static enum hawser_status solve(struct cli_track *t, struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	t->hertz = 1;
	if (t->unit)
		status = cli_choose(&t->hertz, t->command, "unit", t->unit, unit_name, 2, report);
	if (!status)
		status = t->obstacles ? open_span(&t->span, t->common, t, report)
		                      : cli_ropeway_open(&t->ropeway, &t->load_case, t->common, t->command,
		                                         &t->choice, report);
	if (!status && t->swept == CLI_SWEPT_SPEED) {
		t->distance = t->ropeway.spacing;
		status = cli_quantity(&t->distance, t->spacing, "m", CLI_ABOVE_ZERO, t->command, "spacing",
		                      report);
	}
	if (!status)
		status = place(t, report);
	if (!status)
		status = cli_track_name_spans(t, report);
	if (!status)
		status = follow(t, report);
	return status;
}

enum hawser_status cli_track_run(struct cli_track *t, struct hawser_report *report)
{
	enum hawser_status status = cli_outputs_check_scales(t->common, t->logarithmic ? "x" : "", report);

	if (!status)
		status = solve(t, report);
	if (!status)
		status = cli_show(t->common, &showing, t, report);
	hawser_ropeway_track_clear(&t->track);
	hawser_ropeway_clear(&t->ropeway);
	hawser_obstacles_clear(&t->span);
	free(t->sweep.value);
	free(t->resonance);
	free(t->name);
	return status;
}
