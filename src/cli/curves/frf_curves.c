/* cli/curves/frf_curves.c - the curves of a frequency response in a panel: stable parts solid, unstable
 * ones dashed, events marked by kind, natural frequencies as thin vertical lines.
 *
 * A curve is cut where its stability changes, at the located event, so that no line style runs over
 * a bifurcation.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>

#include "cli/curves/frf_over.h"
#include "cli/curves/frf_picture.h"

/* In a darker shade of the colour of their curve: sweeps, and overlays, dotted or dash-dotted. */
static const char *const dark[] = {"#003A66", "#7A2E00"};
/* Another response: the colour of its curve, paler. */
static const char *const pale[] = {"#A6CBE3", "#F0C3A2"};

static double between(double a, double b, double fraction)
{
	return a + fraction*(b - a);
}

double cli_frf_x(const struct cli_frf_picture *of, int i)
{
	const struct hawser_frf_point *point = &of->result->frf->point[i];

	return of->result->over ? point->parameter : point->omega*of->per_omega;
}

double cli_frf_event_x(const struct cli_frf_picture *of, const struct hawser_frf_event *event)
{
	return of->result->over ? event->parameter : event->omega*of->per_omega;
}

/* An entry of a list of rows, of probes or of coordinates. */
static double entry(const struct cli_frf_picture *of, const double *probe, const double *coordinate,
                    int c, int i)
{
	const struct hawser_frf *frf = of->result->frf;
	size_t stride = of->probed ? 3*(size_t)frf->probes : (size_t)frf->n;
	size_t at = (size_t)i*stride + (size_t)of->curve[c].source;

	return of->per_length*(of->probed ? probe[at] : coordinate[at]);
}

double cli_frf_amplitude(const struct cli_frf_picture *of, int c, int i)
{
	return entry(of, of->result->frf->probe, of->result->frf->coordinate, c, i);
}

/* Whether a line goes from point i to the next. */
static int goes_on(const struct cli_frf_picture *of, int i)
{
	return i + 1 < of->result->frf->points && (!of->branch || of->branch[i] == of->branch[i + 1]);
}

static int is_unstable(const struct cli_frf_picture *of, int i)
{
	return of->result->frf->point[i].unstable > 0;
}

/* The amplitude at an event, by linear interpolation between the neighbouring points. */
static void put_event(struct cli_frf_picture *of, int c, const struct hawser_frf_event *event)
{
	const struct hawser_frf_point *point = of->result->frf->point;
	int after = event->after, next = goes_on(of, after) ? after + 1 : after;
	int last = after + 1 < of->result->frf->points ? after + 1 : after;
	double whole = point[last].arc - point[after].arc, part = event->arc - point[after].arc;

	hawser__figure_put(&of->figure, cli_frf_event_x(of, event),
	                   between(cli_frf_amplitude(of, c, after), cli_frf_amplitude(of, c, next),
	                           whole > 0.0 ? fmin(fmax(part/whole, 0.0), 1.0) : 0.0));
}

/* Where stability changes between points i and i + 1: at an event, or in the middle. */
static void put_change(struct cli_frf_picture *of, int c, int i)
{
	const struct hawser_frf *frf = of->result->frf;

	for (int k = 0; k < frf->events; k++)
		if (frf->event[k].after == i) {
			put_event(of, c, &frf->event[k]);
			return;
		}
	hawser__figure_put(&of->figure, between(cli_frf_x(of, i), cli_frf_x(of, i + 1), 0.5),
	                   between(cli_frf_amplitude(of, c, i), cli_frf_amplitude(of, c, i + 1), 0.5));
}

/* The stable or the unstable parts of curve c. */
static void put_parts(struct cli_frf_picture *of, int c, int unstable)
{
	for (int i = 0; i < of->result->frf->points; i++) {
		int mine = is_unstable(of, i) == unstable;
		int flips = goes_on(of, i) && is_unstable(of, i) != is_unstable(of, i + 1);

		if (mine)
			hawser__figure_put(&of->figure, cli_frf_x(of, i), cli_frf_amplitude(of, c, i));
		if (flips)
			put_change(of, c, i);
		if (mine && (flips || !goes_on(of, i)))
			hawser__figure_gap(&of->figure);
	}
}

/* A line over the curves, such as a backbone; another response pale and behind them. */
static void draw_overlay(struct cli_frf_picture *of, int c, int s)
{
	static const char *const dash[] = {"lw 1.2 dt (2,4)", "lw 1 dt (9,3,2,3)", "lw 1.2 dt (1,2)",
	                                   "lw 1 dt (5,2,1,2,1,2)"};
	const struct cli_overlay *overlay = &of->result->overlay[s];
	const char *curve = of->curve[c].label;
	char title[120];

	for (int i = 0; i < overlay->points; i++)
		hawser__figure_put(&of->figure, overlay->omega[i]*of->per_omega,
		                   entry(of, overlay->probe, overlay->coordinate, c, i));
	snprintf(title, sizeof title, "%s%s%.60s", overlay->label, *curve ? ", " : "", curve);
	hawser__figure_draw(&of->figure, *overlay->label && of->curve[c].panel == 0 ? title : NULL,
	                    "with lines lc rgb '%s' %s", (overlay->beside ? pale : dark)[c % 2],
	                    !overlay->beside ? dash[s % 4] : overlay->beside == 2
	                    ? "lw 1.1 " HAWSER__UNSTABLE_DASH : "lw 1.1 dt solid");
}

/* Of sweeps up and down, over the curve that they should lie on. */
static void draw_sweep(struct cli_frf_picture *of, int c, int s)
{
	const struct hawser_sweep *run = &of->result->sweep[s].run;

	for (int i = 0; i < run->points; i++)
		hawser__figure_put(&of->figure, run->omega[i]*of->per_omega,
		                   entry(of, run->probe, run->coordinate, c, i));
	hawser__figure_draw(&of->figure, of->result->sweep[s].direction > 0 ? "up-sweep" : "down-sweep",
	                    "with points pt %d ps 0.6 lw 0.9 lc rgb '%s'", s ? 10 : 8, dark[c % 2]);
}

/* The symbols are hollow and small, since events are often close to each other. */
static void draw_events(struct cli_frf_picture *of, int c)
{
	static const struct {
		const char *title, *symbol;
	} kind[] = {
		[HAWSER_FOLD] = {"fold", "pt 6 ps 0.9"},
		[HAWSER_PERIOD_DOUBLING] = {"period doubling", "pt 8 ps 1.0"},
		[HAWSER_TORUS] = {"torus", "pt 4 ps 0.85"},
		[HAWSER_BRANCH_POINT] = {"branch point", "pt 12 ps 1.05"},
		[HAWSER_UNEXPLAINED] = {"unexplained", "pt 3 ps 0.6"},
		[HAWSER_SLACK] = {"slack", "pt 2 ps 0.7"},
		[HAWSER_HOPF] = {"Hopf point", "pt 14 ps 1.0"},
	};
	const struct hawser_frf *frf = of->result->frf;

	for (int k = 0; k < (int)(sizeof kind/sizeof *kind); k++) {
		if (!kind[k].title)
			continue;
		for (int e = 0; e < frf->events; e++)
			if ((int)frf->event[e].kind == k)
				put_event(of, c, &frf->event[e]);
		hawser__figure_draw(&of->figure, kind[k].title, "with points %s lw 1.0 lc rgb 'black'",
		                    kind[k].symbol);
	}
}

static void draw_peaks(struct cli_frf_picture *of, int c)
{
	for (int i = 0; i < of->result->peaks; i++) {
		const struct hawser_landmark *peak = &of->result->peak[i];
		int source = peak->probe < 0 ? peak->axis : 3*peak->probe + peak->axis;

		if (peak->kind == HAWSER_LANDMARK_PEAK && source == of->curve[c].source &&
		    (peak->probe >= 0) == of->probed)
			hawser__figure_put(&of->figure, peak->omega*of->per_omega, of->per_length*peak->size);
	}
	hawser__figure_draw(&of->figure, "peak", "with points pt 7 ps 0.3 lc rgb 'black'");
}

/* Order of drawing: unstable below stable, symbols on top. */
void cli_frf_curves(struct cli_frf_picture *of, int panel)
{
	const struct cli_frf_result *result = of->result;

	for (int k = 0; k < result->model->naturals && !result->over; k++) {
		double omega = result->model->natural[k]*of->per_omega;

		if (omega >= of->low && omega <= of->high)
			hawser__figure_upright(&of->figure, NULL, omega, "lc rgb '#808080' lw 0.6 dt (4,4) back");
	}
	cli_tori_bands(of, panel);
	for (int c = 0; c < of->curves; c++)
		for (int s = 0; s < result->overlays && of->curve[c].panel == panel; s++)
			if (result->overlay[s].beside)
				draw_overlay(of, c, s);
	for (int c = 0; c < of->curves; c++) {
		if (of->curve[c].panel != panel)
			continue;
		put_parts(of, c, 1);
		hawser__figure_draw(&of->figure, NULL, "with lines lt %d lw 1 " HAWSER__UNSTABLE_DASH,
		                    c % 2 + 1);
		put_parts(of, c, 0);
		hawser__figure_draw(&of->figure, NULL, "with lines lt %d", c % 2 + 1);
		for (int s = 0; s < result->overlays; s++)
			if (!result->overlay[s].beside)
				draw_overlay(of, c, s);
		for (int s = 0; s < result->sweeps; s++)
			draw_sweep(of, c, s);
	}
	for (int c = 0; c < of->curves; c++)
		if (of->curve[c].panel == panel)
			draw_events(of, c);
	for (int c = 0; c < of->curves; c++)
		if (of->curve[c].panel == panel)
			draw_peaks(of, c);
}
