/* cli/curves/frf_curves.c - the curves of a frequency response in a panel: stable parts solid, unstable
 * ones dashed, events marked by kind, natural frequencies as thin vertical lines.
 *
 * A curve is cut where its stability changes, at the located event, so that no line style runs over
 * a bifurcation. Between two points it is a cubic over the arclength that goes beyond neither of them
 * (Steffen, Astron. Astrophys. 239 (1990) 443): long steps show no corners.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "cli/curves/frf_picture.h"

/* In a darker shade of the colour of their curve: sweeps, and overlays, dotted or dash-dotted. */
static const char *const dark[] = {"#003A66", "#7A2E00"};
/* Another response: the colour of its curve, paler. */
static const char *const pale[] = {"#A6CBE3", "#F0C3A2"};

#define FLAT 3e-4 /* of the picture's width and of the largest amplitude; chosen */
enum { MOST_PIECES = 12 };

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

/* The abscissa (c below 0) or the amplitude of curve c. */
static double value(const struct cli_frf_picture *of, int c, int i)
{
	return c < 0 ? cli_frf_x(of, i) : cli_frf_amplitude(of, c, i);
}

static double secant(const struct cli_frf_picture *of, int c, int i, double *length)
{
	const struct hawser_frf_point *point = of->result->frf->point;

	*length = point[i + 1].arc - point[i].arc;
	return *length > 0.0 ? (value(of, c, i + 1) - value(of, c, i))/ *length : 0.0;
}

/* The derivative by the arclength at point i: none where the value is largest or least. */
static double slope(const struct cli_frf_picture *of, int c, int i)
{
	int before = i > 0 && goes_on(of, i - 1), after = goes_on(of, i);
	double h[2] = {0.0, 0.0}, s[2] = {0.0, 0.0}, whole;

	if (before)
		s[0] = secant(of, c, i - 1, &h[0]);
	if (after)
		s[1] = secant(of, c, i, &h[1]);
	if (!before || !after)
		return s[0] + s[1];
	if (!(s[0]*s[1] > 0.0))
		return 0.0;
	whole = fabs(s[0]*h[1] + s[1]*h[0])/(h[0] + h[1]);
	return copysign(fmin(whole, 2.0*fmin(fabs(s[0]), fabs(s[1]))), s[0]);
}

/* The value at a part of the way from point i to the next. */
static double within(const struct cli_frf_picture *of, int c, int i, double part)
{
	double h, s, a, b;

	if (!goes_on(of, i))
		return value(of, c, i);
	s = secant(of, c, i, &h);
	a = slope(of, c, i);
	b = slope(of, c, i + 1);
	return value(of, c, i) + h*part*(a + part*(3.0*s - 2.0*a - b + part*(a + b - 2.0*s)));
}

/* The part of the way from point `after` to the next at which an event is. */
static double part_of(const struct cli_frf_picture *of, const struct hawser_frf_event *event)
{
	const struct hawser_frf_point *point = of->result->frf->point;
	int after = event->after, last = after + 1 < of->result->frf->points ? after + 1 : after;
	double whole = point[last].arc - point[after].arc;

	return whole > 0.0 ? fmin(fmax((event->arc - point[after].arc)/whole, 0.0), 1.0) : 0.0;
}

static void put_event(struct cli_frf_picture *of, int c, const struct hawser_frf_event *event)
{
	hawser__figure_put(&of->figure, cli_frf_event_x(of, event),
	                   within(of, c, event->after, part_of(of, event)));
}

/* Where stability changes between points i and i + 1: at an event (returned), or in the middle. */
static const struct hawser_frf_event *change(const struct cli_frf_picture *of, int i)
{
	const struct hawser_frf *frf = of->result->frf;

	for (int k = 0; k < frf->events; k++)
		if (frf->event[k].after == i)
			return &frf->event[k];
	return NULL;
}

/* What lies between two parts of the way from point i to the next, as many places as keep the line of
 * chords within FLAT of the picture. */
static void put_between(struct cli_frf_picture *of, int c, int i, double from, double to, double most)
{
	double middle = 0.5*(from + to), off = 0.0;
	int pieces;

	for (int k = -1; k <= c; k += c + 1) {
		double chord = 0.5*(within(of, k, i, from) + within(of, k, i, to));

		off = fmax(off, fabs(within(of, k, i, middle) - chord)/(k < 0 ? of->high - of->low : most));
	}
	pieces = off > FLAT ? (int)fmin(MOST_PIECES, ceil(sqrt(off/FLAT))) : 1;
	for (int k = 1; k < pieces; k++) {
		double part = from + (to - from)*k/pieces;

		hawser__figure_put(&of->figure, within(of, -1, i, part), within(of, c, i, part));
	}
}

/* The stable or the unstable parts of curve c. */
static void put_parts(struct cli_frf_picture *of, int c, int unstable)
{
	double most = 0.0;

	for (int i = 0; i < of->result->frf->points; i++)
		most = fmax(most, cli_frf_amplitude(of, c, i));
	for (int i = 0; i < of->result->frf->points; i++) {
		int mine = is_unstable(of, i) == unstable;
		int flips = goes_on(of, i) && is_unstable(of, i) != is_unstable(of, i + 1);
		const struct hawser_frf_event *event = flips ? change(of, i) : NULL;
		double at = event ? part_of(of, event) : flips ? 0.5 : 1.0;

		if (mine)
			hawser__figure_put(&of->figure, cli_frf_x(of, i), cli_frf_amplitude(of, c, i));
		if (mine && goes_on(of, i))
			put_between(of, c, i, 0.0, at, most);
		if (event)
			put_event(of, c, event);
		else if (flips)
			hawser__figure_put(&of->figure, within(of, -1, i, at), within(of, c, i, at));
		if (mine && (flips || !goes_on(of, i)))
			hawser__figure_gap(&of->figure);
		else if (flips)
			put_between(of, c, i, at, 1.0, most);
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
