/* output/curves/plot_integrate.c - a time response: history, phase plane of its settled part, spectrum.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <string.h>

#include "output/output.h"

/* A spectrum is drawn for this number of decades below its peak, up to the last frequency at which
 * it exceeds this fraction of the peak. Smaller values are leakage of the window, or round-off. */
static const double decades = 7.0, part_of_peak = 1e-4;

/* Prefixes of the histories in SI. Each signal has the largest one with which its tic labels are short.
 * Spectra are in m, and what the user has chosen is shown as it is. */
static const struct prefix {
	double least, times; /* m: it is for signals of at least this size */
	const char *prefix;
} prefixes[] = {{0.02, 1.0, ""}, {2e-5, 1e3, "m"}, {0.0, 1e6, "µ"}};

static const struct prefix *prefix_of(const struct hawser__history *history, int k)
{
	const struct prefix *prefix = prefixes;
	double largest = 0.0;

	if (!history->scaled || strcmp(history->y.unit, "m") != 0)
		return prefix;
	for (int i = 0; i < history->rows; i++)
		largest = fmax(largest, fabs(history->signal[k].value[i]));
	while (largest > 0.0 && largest < prefix->least)
		prefix++;
	return prefix;
}

/* Shown values of signal k per value, and the end of its title: displacement and velocity. */
struct unit {
	double y, rate;
	char y_end[HAWSER__MARKUP_SIZE + 8], rate_end[HAWSER__MARKUP_SIZE + 8];
};

static void ending(char *text, size_t size, const char *prefix, const char *unit)
{
	snprintf(text, size, "%s%s%s%s", *unit ? " (" : "", *unit ? prefix : "", unit, *unit ? ")" : "");
}

static struct unit unit_of(const struct hawser__history *history, int k)
{
	const struct prefix *prefix = prefix_of(history, k);
	int plain = strcmp(history->rate.unit, "m/s") == 0; /* not chosen by itself */
	struct unit unit = {.y = prefix->times/history->y.per,
	                    .rate = (plain ? prefix->times : 1.0)/history->rate.per};

	ending(unit.y_end, sizeof unit.y_end, prefix->prefix, history->y.unit);
	ending(unit.rate_end, sizeof unit.rate_end, plain ? prefix->prefix : "", history->rate.unit);
	return unit;
}

static void data(FILE *script, const struct hawser__history *history)
{
	int i, k;

	for (k = 0; k < history->signals; k++) {
		const struct hawser__plot_signal *signal = &history->signal[k];
		const struct unit unit = unit_of(history, k);

		fprintf(script, "$history%d << END\n", k);
		for (i = 0; i < history->rows; i++)
			fprintf(script, "%.9g %.7g %.7g\n", history->time[i], unit.y*signal->value[i],
			        unit.rate*signal->rate[i]);
		fprintf(script, "END\n$spectrum%d << END\n", k);
		for (i = 1; i < history->bins; i++)
			fprintf(script, "%.9g %.7g\n", history->frequency[i]/history->spectrum.per,
			        signal->amplitude[i]/history->amplitude.per);
		fputs("END\n", script);
	}
}

static double peak(const struct hawser__history *history)
{
	double largest = 0.0;
	int i, k;

	for (k = 0; k < history->signals; k++)
		for (i = 1; i < history->bins; i++)
			largest = fmax(largest, history->signal[k].amplitude[i]);
	return largest;
}

/* Largest frequency drawn: 1.1 times the last one with an amplitude above `least`, but at least
 * three times the forcing frequency. The Nyquist frequency may be much larger. */
static double last_frequency(const struct hawser__history *history, double least)
{
	int i, k, last = 1;

	for (k = 0; k < history->signals; k++)
		for (i = 1; i < history->bins; i++)
			if (history->signal[k].amplitude[i] > least && i > last)
				last = i;
	return fmax(1.1*history->frequency[last], 3.0*history->forcing);
}

/* Range of the settled part. */
static void span(double *low, double *high, const struct hawser__history *history,
                 const double *column)
{
	int i;

	*low = INFINITY;
	*high = -INFINITY;
	for (i = history->settled_from; i < history->rows; i++) {
		*low = fmin(*low, column[i]);
		*high = fmax(*high, column[i]);
	}
}

/* Lines, or points of a section. */
static void style(char *how, size_t size, const struct hawser__history *history, int k)
{
	if (history->section)
		snprintf(how, size, "points lt %d pt 7 ps 0.15", k + 1);
	else
		snprintf(how, size, "lines lt %d lw 0.8", k + 1);
}

static void time_panel(struct hawser__picture *picture, const struct hawser__history *history,
                       int k)
{
	const struct hawser__plot_signal *signal = &history->signal[k];
	int last = k + 1 == history->signals;
	FILE *script = picture->script;
	char how[HAWSER__MARKUP_SIZE];

	fputs("set xtics autofreq\nset ytics autofreq\n", script);
	fprintf(script, "set xrange [%.9g:%.9g]\nset format x '%s'\n", history->time[0],
	        history->time[history->rows - 1], last ? "%g" : "");
	if (last)
		fprintf(script, "set xlabel '%s' offset 0,0.3\n", history->time_title);
	else
		fputs("unset xlabel\n", script);
	hawser__picture_ylabel(picture, "%s%s", signal->label, unit_of(history, k).y_end);
	style(how, sizeof how, history, k);
	fprintf(script, "plot $history%d using 1:2 with %s\n", k, how);
}

static void phase_panel(struct hawser__picture *picture, const struct hawser__history *history,
                        int k)
{
	const struct unit unit = unit_of(history, k);
	double low, high;
	char how[HAWSER__MARKUP_SIZE];

	style(how, sizeof how, history, k);
	span(&low, &high, history, history->signal[k].value);
	hawser__picture_tics(picture, 'x', unit.y*low, unit.y*high, 3);
	span(&low, &high, history, history->signal[k].rate);
	hawser__picture_tics(picture, 'y', unit.rate*low, unit.rate*high, 5);
	fprintf(picture->script, "set autoscale x\nset format x '%%g'\nset xlabel '%s%s' "
	                         "offset 0,0.3\n",
	        history->signal[k].label, unit.y_end);
	hawser__picture_ylabel(picture, "Velocity%s", unit.rate_end);
	fprintf(picture->script, "plot $history%d every ::%d using 2:3 with %s\n", k,
	        history->settled_from, how);
}

static void spectrum(struct hawser__picture *picture, const struct hawser__history *history)
{
	FILE *script = picture->script;
	double largest = peak(history), highest = history->frequency[history->bins - 1];
	double end = fmin(last_frequency(history, part_of_peak*largest), highest)/history->spectrum.per;
	double forcing = history->forcing/history->spectrum.per;
	int k;

	fprintf(script, "unset xzeroaxis\nset ytics autofreq\nset xlabel '%s' offset 0,0.3\n",
	        history->spectrum.title);
	hawser__picture_ylabel(picture, "%s", history->amplitude.title);
	largest /= history->amplitude.per;
	fprintf(script, "set xrange [0:%.6g]\n", end);
	if (largest > 0.0) {
		fprintf(script, "set yrange [%.3g:%.3g]\n", largest*pow(10.0, -decades), 5.0*largest);
		hawser__picture_log_tics(picture, "y", largest*pow(10.0, -decades), 5.0*largest, 30.0);
	}
	hawser__picture_tics(picture, 'x', 0.0, end, 10);
	if (forcing > 0.0)
		fprintf(script, "set arrow 1 from first %.9g, graph 0 to first %.9g, graph 1 nohead lt 7 "
		                "lw 0.5 dt (4,4)\nset label 1 'forcing' at first %.9g, graph 1 "
		                "offset 0.3,-0.3 font ',8'\n",
		        forcing, forcing, forcing);
	fputs("set key at screen 0.55,0.012 center bottom horizontal samplen 3\nplot ", script);
	for (k = 0; k < history->signals; k++)
		fprintf(script, "%s$spectrum%d using 1:2 with lines lt %d lw 1 title '%s'",
		        k ? ", " : "", k, k + 1, history->signal[k].label);
	fputc('\n', script);
}

/* One row per signal, with history and phase plane; below them the spectra of all signals. */
enum hawser_status hawser__plot_integrate(const char *path, const struct hawser__history *history,
                                          struct hawser_report *report)
{
	double height = 7.2 + 5.0*history->signals, tall = 5.0/height, top = 1.0 - 0.4/height;
	struct hawser__picture picture;
	enum hawser_status status = hawser__picture_begin(&picture, path, 17.0, height, report);
	int k;

	if (status)
		return status;
	data(picture.script, history);
	fputs("set xzeroaxis lt 7 lw 0.4\n", picture.script);
	for (k = 0; k < history->signals; k++) {
		double base = top - tall*(k + 1) + 1.95/height, roof = top - tall*k;

		hawser__picture_panel(&picture, 0.13, 0.60, base, roof);
		time_panel(&picture, history, k);
		hawser__picture_panel(&picture, 0.775, 0.975, base, roof);
		phase_panel(&picture, history, k);
	}
	hawser__picture_panel(&picture, 0.13, 0.975, 2.3/height, top - tall*k);
	spectrum(&picture, history);
	return hawser__picture_finish(&picture, report);
}
