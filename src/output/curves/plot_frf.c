/* output/curves/plot_frf.c - a frequency response: amplitudes against Omega, stable parts solid,
 * unstable ones dashed, events marked by kind, natural frequencies as thin vertical lines.
 *
 * A curve is cut where its stability changes, at the located event, so that no line style runs over
 * a bifurcation.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>

#include "output/output.h"
#include "output/curves/plot_frf.h"
#include "output/drawing/style.h"

static const char unstable_dash[] = HAWSER__UNSTABLE_DASH;

/* Symbol of each kind of event: point type and size of gnuplot, and the name in the legend. The
 * symbols are hollow and small, since events are often close to each other. */
static const struct {
	int type;
	double size;
	const char *label;
} symbol[] = {
	[HAWSER_FOLD] = {6, 0.55, "fold"},
	[HAWSER_PERIOD_DOUBLING] = {8, 0.65, "period doubling"},
	[HAWSER_TORUS] = {4, 0.5, "torus"},
	[HAWSER_BRANCH_POINT] = {12, 0.65, "branch point"},
	[HAWSER_UNEXPLAINED] = {3, 0.6, "unexplained"},
	[HAWSER_SLACK] = {2, 0.7, "slack"},
};
enum { kinds = sizeof symbol/sizeof *symbol };

static const char gap_colour[] = "#f3dede";
static const char peak_style[] = "points pt 7 ps 0.3 lc rgb 'black'";
/* Of sweeps up and down, over the curve that they should lie on: gnuplot's point types. */
static const int sweep_type[] = {8, 10};
static const char sweep_size[] = "ps 0.6 lw 0.9";

static double between(double a, double b, double fraction)
{
	return a + fraction*(b - a);
}

/* Whether a line goes from point i to the next. */
static int goes_on(const struct hawser__response *response, int i)
{
	return i + 1 < response->points &&
	       (!response->branch || response->branch[i] == response->branch[i + 1]);
}

/* Amplitude of a curve at an event, by linear interpolation between the neighbouring points. */
static double at_event(const struct hawser__response *response, const double *amplitude,
                       const struct hawser__response_event *event)
{
	int next = goes_on(response, event->after) ? event->after + 1 : event->after;

	return between(amplitude[event->after], amplitude[next], event->fraction);
}

/* The event at which stability changes between points i and i + 1, or NULL. */
static const struct hawser__response_event *change(const struct hawser__response *response, int i)
{
	int k;

	for (k = 0; k < response->events; k++)
		if (response->event[k].after == i)
			return &response->event[k];
	return NULL;
}

/* The stable or the unstable parts of curve c, separated by blank lines. */
static void segments(FILE *script, const struct hawser__response *response, int c, int unstable)
{
	const double *amplitude = response->curve[c].amplitude;
	int i;

	fprintf(script, "$%s%d << END\n", unstable ? "unstable" : "stable", c);
	for (i = 0; i < response->points; i++) {
		int mine = (response->unstable[i] > 0) == unstable;
		int flips = goes_on(response, i) &&
		            (response->unstable[i] > 0) != (response->unstable[i + 1] > 0);
		const struct hawser__response_event *event = flips ? change(response, i) : NULL;

		if (mine)
			fprintf(script, "%.12g %.9g\n", response->omega[i], amplitude[i]);
		if (flips && event)
			fprintf(script, "%.12g %.9g\n", event->omega, at_event(response, amplitude, event));
		else if (flips)
			fprintf(script, "%.12g %.9g\n",
			        between(response->omega[i], response->omega[i + 1], 0.5),
			        between(amplitude[i], amplitude[i + 1], 0.5));
		if (mine && (flips || !goes_on(response, i)))
			fputc('\n', script);
	}
	fputs("NaN NaN\nEND\n", script);
}

static void events(FILE *script, const struct hawser__response *response, int c, int kind)
{
	const double *amplitude = response->curve[c].amplitude;
	int k;

	fprintf(script, "$event%d_%d << END\n", c, kind);
	for (k = 0; k < response->events; k++)
		if ((int)response->event[k].kind == kind)
			fprintf(script, "%.12g %.9g\n", response->event[k].omega,
			        at_event(response, amplitude, &response->event[k]));
	fputs("NaN NaN\nEND\n", script);
}

static void peaks(FILE *script, const struct hawser__response *response, int c)
{
	fprintf(script, "$peak%d << END\n", c);
	for (int k = 0; k < response->peaks; k++)
		if (response->peak[k].curve == c)
			fprintf(script, "%.12g %.9g\n", response->peak[k].omega,
			        response->peak[k].amplitude);
	fputs("NaN NaN\nEND\n", script);
}

static void sweeps(FILE *script, const struct hawser__response *response, int c)
{
	int s, i;

	for (s = 0; s < response->sweeps; s++) {
		const struct hawser__response_sweep *sweep = &response->sweep[s];

		fprintf(script, "$sweep%d_%d << END\n", c, s);
		for (i = 0; i < sweep->points; i++)
			fprintf(script, "%.12g %.9g\n", sweep->omega[i],
			        sweep->amplitude[c*sweep->points + i]);
		fputs("NaN NaN\nEND\n", script);
	}
}

/* Overlays are dotted or dash-dotted, in a darker shade of the colour of their curve. */
static const char *const overlay_dash[] = {"lw 1.2 dt (2,4)", "lw 1 dt (9,3,2,3)", "lw 1.2 dt (1,2)",
                                           "lw 1 dt (5,2,1,2,1,2)"};
static const char *const dark_colour[] = {"#003A66", "#7A2E00"};

/* Another response: the colour of its curve, paler. */
static const char *const pale_colour[] = {"#A6CBE3", "#F0C3A2"};

/* "lc rgb '#003A66' lw 1.2 dt (2,4)" */
static void overlay_style(char *style, size_t size, const struct hawser__response *response, int s,
                          int c)
{
	int beside = response->overlay[s].beside;

	if (beside)
		snprintf(style, size, "lc rgb '%s' lw 1.1 %s", pale_colour[c % 2],
		         beside == 2 ? unstable_dash : "dt solid");
	else
		snprintf(style, size, "lc rgb '%s' %s", dark_colour[c % 2], overlay_dash[s%4]);
}

static void overlays(FILE *script, const struct hawser__response *response, int c)
{
	for (int s = 0; s < response->overlays; s++) {
		const struct hawser__response_overlay *overlay = &response->overlay[s];

		fprintf(script, "$overlay%d_%d << END\n", c, s);
		for (int i = 0; i < overlay->points; i++) {
			double amplitude = overlay->amplitude[c*overlay->points + i];

			if (isfinite(amplitude))
				fprintf(script, "%.12g %.9g\n", overlay->omega[i], amplitude);
			else
				fputc('\n', script);
		}
		fputs("NaN NaN\nEND\n", script);
	}
}

static void data(FILE *script, const struct hawser__response *response)
{
	int c, kind;

	for (c = 0; c < response->curves; c++) {
		segments(script, response, c, 0);
		segments(script, response, c, 1);
		for (kind = 0; kind < kinds; kind++)
			events(script, response, c, kind);
		peaks(script, response, c);
		sweeps(script, response, c);
		overlays(script, response, c);
		hawser__tori_data(script, response, c);
	}
}

static int has_kind(const struct hawser__response *response, int kind)
{
	int k;

	for (k = 0; k < response->events; k++)
		if ((int)response->event[k].kind == kind)
			return 1;
	return 0;
}

static int has_unstable(const struct hawser__response *response)
{
	int i;

	for (i = 0; i < response->points; i++)
		if (response->unstable[i] > 0)
			return 1;
	return 0;
}

static int shown(const struct hawser__response *response, int k)
{
	double lo = fmin(response->from, response->to), hi = fmax(response->from, response->to);

	return response->natural[k] >= lo && response->natural[k] <= hi;
}

void hawser__frf_naturals(FILE *script, const struct hawser__response *response, double low,
                          double high)
{
	int k;

	fputs("unset arrow\n", script);
	for (k = 0; k < response->naturals; k++)
		if (response->natural[k] >= low && response->natural[k] <= high)
			fprintf(script, "set arrow %d from first %.12g, graph 0 to first %.12g, graph 1 nohead "
			                "lc rgb '#808080' lw 0.6 dt (4,4) back\n",
			        k + 1, response->natural[k], response->natural[k]);
}

/* Labels of the natural frequencies above the panel. Labels that would overlap are joined: "ω_1,
 * ω_2". A label that would extend beyond the picture is aligned with the end of the panel. */
static void natural_labels(FILE *script, const struct hawser__response *response)
{
	double span = fabs(response->to - response->from), width = 0.045*span;
	double most = fmax(response->from, response->to);

	for (int k = 0, next; k < response->naturals; k = next) {
		double end = response->natural[k] + width;

		for (next = k + 1; shown(response, k) && next < response->naturals &&
		                   shown(response, next) && response->natural[next] < end; next++)
			end += width;
		if (!shown(response, k))
			continue;
		if (end > most + 0.5*width)
			fprintf(script, "set label %d at graph 1.0, graph 1.0 right offset 1.5,0.6", k + 1);
		else
			fprintf(script, "set label %d at first %.12g, graph 1.0 left offset -0.5,0.6", k + 1,
			        response->natural[k]);
		fprintf(script, " tc rgb '#505050' '");
		for (int j = k; j < next; j++)
			fprintf(script, "%sω_{%d}", j > k ? ", " : "", j + 1);
		fputs("'\n", script);
	}
}

/* Largest amplitude of another response in the range of Omega; 0 for other overlays. */
static double largest_beside(const struct hawser__response *response,
                             const struct hawser__response_overlay *overlay, int c)
{
	double low = fmin(response->from, response->to), high = fmax(response->from, response->to);
	double most = 0.0;

	for (int i = 0; overlay->beside && i < overlay->points; i++)
		if (overlay->omega[i] >= low && overlay->omega[i] <= high)
			most = fmax(most, overlay->amplitude[c*overlay->points + i]); /* fmax ignores a NAN */
	return most;
}

/* Range of the axis over all curves of a panel; a linear axis begins at zero. */
static void range(struct hawser__picture *picture, const struct hawser__response *response,
                  int panel)
{
	FILE *script = picture->script;
	double least = INFINITY, most = 0.0;
	int c, i;

	for (c = 0; c < response->curves; c++)
		for (i = 0; response->curve[c].panel == panel && i < response->points; i++) {
			double a = response->curve[c].amplitude[i];

			most = fmax(most, a);
			least = a > 0.0 ? fmin(least, a) : least;
		}
	for (c = 0; c < response->curves; c++)
		most = response->curve[c].panel == panel ? fmax(most, hawser__tori_largest(response, c)) : most;
	for (c = 0; c < response->curves; c++)
		for (int s = 0; response->curve[c].panel == panel && s < response->overlays; s++)
			most = fmax(most, largest_beside(response, &response->overlay[s], c));
	if (response->logarithmic && least < most) {
		least = fmax(0.8*least, 1e-12*most);
		fprintf(script, "set yrange [%.4g:%.4g]\n", least, 1.5*most);
		hawser__picture_log_tics(picture, "y", least, 1.5*most, 30.0);
		return;
	}
	fprintf(script, "unset logscale y\nset format y '%%g'\nset yrange [0:%s]\n",
	        most > 0.0 ? "*" : "1");
	hawser__picture_tics(picture, 'y', 0.0, most, 6);
}

/* Order of drawing: unstable below stable, symbols on top. */
void hawser__frf_curves(FILE *script, const struct hawser__response *response, int panel)
{
	const char *comma = "plot ";
	char style[96];
	int c, kind, s;

	hawser__tori_bands(script, &comma, response, panel);
	for (c = 0; c < response->curves; c++)
		for (s = 0; response->curve[c].panel == panel && s < response->overlays; s++) {
			if (!response->overlay[s].beside)
				continue;
			overlay_style(style, sizeof style, response, s, c);
			fprintf(script, "%s$overlay%d_%d with lines %s", comma, c, s, style);
			comma = ", ";
		}
	for (c = 0; c < response->curves; c++) {
		if (response->curve[c].panel != panel)
			continue;
		fprintf(script, "%s$unstable%d with lines lt %d lw 1 %s", comma, c, c % 2 + 1,
		        unstable_dash);
		fprintf(script, ", $stable%d with lines lt %d", c, c % 2 + 1);
		comma = ", ";
		for (s = 0; s < response->overlays; s++) {
			overlay_style(style, sizeof style, response, s, c);
			if (!response->overlay[s].beside)
				fprintf(script, ", $overlay%d_%d with lines %s", c, s, style);
		}
		for (s = 0; s < response->sweeps; s++)
			fprintf(script, ", $sweep%d_%d with points pt %d %s lc rgb '%s'", c, s,
			        sweep_type[s], sweep_size, dark_colour[c % 2]);
	}
	for (c = 0; c < response->curves; c++)
		for (kind = 0; response->curve[c].panel == panel && kind < kinds; kind++)
			fprintf(script, ", $event%d_%d with points pt %d ps %g lw 0.6 lc rgb 'black'", c, kind,
			        symbol[kind].type, symbol[kind].size);
	for (c = 0; c < response->curves; c++)
		if (response->curve[c].panel == panel && response->peaks > 0)
			fprintf(script, ", $peak%d with %s", c, peak_style);
	fputc('\n', script);
}

/* An overlay is drawn for each curve of the panel, in a colour of its own: each is an entry. */
static void overlay_entries(struct hawser__legend *entries, const struct hawser__response *response)
{
	char title[120], style[96];

	for (int c = 0; c < response->curves && response->curve[c].panel == 0; c++)
		for (int s = 0; s < response->overlays; s++) {
			const char *curve = response->curve[c].label;

			if (!*response->overlay[s].label)
				continue;
			overlay_style(style, sizeof style, response, s, c);
			snprintf(title, sizeof title, "%s%s%s", response->overlay[s].label,
			         *curve ? ", " : "", curve);
			hawser__legend_add(entries, title, "with lines %s", style);
		}
}

static void legend(struct hawser__legend *entries, const struct hawser__response *response)
{
	for (int c = 0; c < response->curves && response->curve[c].panel == 0; c++)
		if (*response->curve[c].label)
			hawser__legend_add(entries, response->curve[c].label, "with lines lt %d", c % 2 + 1);
	hawser__legend_add(entries, "stable", "with lines lt 7");
	if (has_unstable(response))
		hawser__legend_add(entries, "unstable", "with lines lt 7 lw 1 %s", unstable_dash);
	for (int kind = 0; kind < kinds; kind++)
		if (has_kind(response, kind))
			hawser__legend_add(entries, symbol[kind].label,
			                   "with points pt %d ps %g lw 0.6 lc rgb 'black'", symbol[kind].type,
			                   symbol[kind].size);
	hawser__tori_legend(entries, response);
	if (response->peaks > 0)
		hawser__legend_add(entries, "peak", "with %s", peak_style);
	for (int s = 0; s < response->sweeps; s++)
		hawser__legend_add(entries, response->sweep[s].label,
		                   "with points pt %d %s lc rgb '%s'", sweep_type[s], sweep_size,
		                   dark_colour[0]);
	overlay_entries(entries, response);
}

static void frequency_title(FILE *script, const struct hawser__response *response)
{
	fprintf(script, "set format x '%%g'\nset xlabel '%s'\n", response->x_title);
}

/* From the top of the picture down to `bottom`, both as parts of its height. */
static void panels(struct hawser__picture *picture, const struct hawser__response *response,
                   double bottom)
{
	double top = 1.0 - 0.8/picture->height, tall = (top - bottom)/response->panels;
	double low = fmin(response->from, response->to), high = fmax(response->from, response->to);
	FILE *script = picture->script;

	fprintf(script, "set xrange [%.12g:%.12g]\nset format x ''\n", low, high);
	hawser__picture_tics(picture, 'x', low, high, 10);
	for (int k = 0; k < response->panels; k++) {
		double base = top - tall*(k + 1);

		hawser__picture_panel(picture, 0.13, 0.965, base,
		                      base + tall - (k ? 0.45/picture->height : 0.0));
		if (k + 1 == response->panels)
			frequency_title(script, response);
		hawser__frf_naturals(script, response, low, high);
		if (k == 0)
			natural_labels(script, response);
		else
			fputs("unset label\n", script);
		hawser__picture_ylabel(picture, "%s", response->panel_label[k]);
		range(picture, response, k);
		hawser__frf_curves(script, response, k);
	}
}

enum hawser_status hawser__plot_frf(const char *path, const struct hawser__response *response,
                                    struct hawser_report *report)
{
	struct hawser__frf_detail detail[HAWSER__FRF_DETAILS];
	int details = hawser__frf_crowds(detail, response);
	const double width = 17.0;
	double below = details ? hawser__frf_details_cm(response) : 0.0, room, height;
	struct hawser__legend entries = {0};
	struct hawser__picture picture;
	enum hawser_status status;

	legend(&entries, response);
	if (response->gaps > 0)
		hawser__legend_add(&entries, "no branch found", "with lines lw 8 lc rgb '%s'", gap_colour);
	room = hawser__legend_cm(&entries, width);
	height = room + 0.65 + 5.6*response->panels + below;
	status = hawser__picture_begin(&picture, path, width, height, report);
	if (status)
		return status;
	data(picture.script, response);
	for (int k = 0; k < response->gaps; k++)
		fprintf(picture.script, "set object %d rectangle from first %.12g, graph 0 to first %.12g, "
		                        "graph 1 behind fc rgb '%s' fs solid noborder\n",
		        HAWSER__FRF_DETAILS + k + 1, response->gap[2*k], response->gap[2*k + 1], gap_colour);
	for (int k = 0; k < details; k++)
		fprintf(picture.script, "set object %d rectangle from first %.12g, graph 0 to first %.12g, "
		                        "graph 1 behind fc rgb '#ececec' fs solid noborder\n", k + 1,
		        detail[k].from, detail[k].to);
	panels(&picture, response, (room + below)/height);
	if (details)
		hawser__frf_details(&picture, response, room, detail, details);
	hawser__legend_draw(&picture, &entries);
	return hawser__picture_finish(&picture, report);
}
