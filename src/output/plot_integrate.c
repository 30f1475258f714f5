/* output/plot_integrate.c - a time response: history, phase plane of its settled part, spectrum.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>

#include "output/output.h"

/* Shown of a spectrum: so many decades below its peak, up to the last frequency at which it reaches
 * this part of the peak. Further down are the window's leakage and round-off. */
static const double decades = 7.0, part_of_peak = 1e-4;

static void data(FILE *script, const struct hawser__history *history)
{
	int i, k;

	for (k = 0; k < history->signals; k++) {
		const struct hawser__signal *signal = &history->signal[k];

		fprintf(script, "$history%d << END\n", k);
		for (i = 0; i < history->rows; i++)
			fprintf(script, "%.9g %.7g %.7g\n", history->time[i], signal->value[i],
			        signal->rate[i]);
		fprintf(script, "END\n$spectrum%d << END\n", k);
		for (i = 1; i < history->bins; i++)
			fprintf(script, "%.9g %.7g\n", history->frequency[i], signal->amplitude[i]);
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

static double reach(const struct hawser__history *history)
{
	double largest = 0.0;
	int i, k;

	for (k = 0; k < history->signals; k++)
		for (i = history->settled_from; i < history->rows; i++)
			largest = fmax(largest, fabs(history->signal[k].value[i]));
	return largest;
}

static void curves(FILE *script, const struct hawser__history *history, const char *block,
                   const char *columns, const char *style, int titled)
{
	int k;

	fputs("plot ", script);
	for (k = 0; k < history->signals; k++) {
		fprintf(script, "%s$%s%d %s with lines lt %d %s ", k ? ", " : "", block, k, columns,
		        k + 1, style);
		if (titled)
			fprintf(script, "title '%s'", history->signal[k].label);
		else
			fputs("notitle", script);
	}
	fputc('\n', script);
}

/* Frequencies up to where something happens, not up to Nyquist's, however fine the output. */
static double last_frequency(const struct hawser__history *history, double least)
{
	int i, k, last = 1;

	for (k = 0; k < history->signals; k++)
		for (i = 1; i < history->bins; i++)
			if (history->signal[k].amplitude[i] > least && i > last)
				last = i;
	return fmax(1.1*history->frequency[last], 3.0*history->forcing);
}

static void spectrum(struct hawser__picture *picture, const struct hawser__history *history)
{
	FILE *script = picture->script;
	double largest = peak(history), highest = history->frequency[history->bins - 1];
	double end = fmin(last_frequency(history, part_of_peak*largest), highest);

	fprintf(script, "unset xzeroaxis\nset xlabel 'Frequency (%s)'\n",
	        history->scaled ? "Hz" : "1/time");
	fprintf(script, "set ylabel 'Amplitude%s'\n", history->scaled ? " (m)" : "");
	if (largest > 0.0)
		fprintf(script, "set logscale y\nset format y '10^{%%T}'\nset yrange [%.3g:%.3g]\n"
		                "set xrange [0:%.6g]\n", largest*pow(10.0, -decades), 3.0*largest, end);
	hawser__picture_xtics(picture, 0.0, end, 5);
	if (history->forcing > 0.0)
		fprintf(script, "set arrow 1 from first %.9g, graph 0 to first %.9g, graph 1 nohead lt 7 "
		                "lw 0.5 dt (4,4)\nset label 1 'forcing' at first %.9g, graph 0.97 "
		                "offset 0.4,0 font ',8'\n",
		        history->forcing, history->forcing, history->forcing);
	curves(script, history, "spectrum", "using 1:2", "lw 1", 0);
}

enum hawser_status hawser__plot_integrate(const char *path, const struct hawser__history *history,
                                          struct hawser_report *report)
{
	struct hawser__picture picture;
	enum hawser_status status = hawser__picture_begin(&picture, path, 17.0, 13.0, report);
	const char *length = history->scaled ? " (m)" : "", *rate = history->scaled ? " (m/s)" : "";
	FILE *script = picture.script;

	if (status)
		return status;
	data(script, history);
	fputs("set key at screen 0.55,0.012 center bottom horizontal samplen 3\n"
	      "set xzeroaxis lt 7 lw 0.4\n", script);
	fprintf(script, "set xlabel 'Time {/:Italic t}%s' offset 0,0.3\nset ylabel 'Displacement%s'\n",
	        history->scaled ? " (s)" : "", length);
	fprintf(script, "set xrange [%.9g:%.9g]\n", history->time[0],
	        history->time[history->rows - 1]);
	hawser__picture_panel(&picture, 0.115, 0.975, 0.66, 0.97);
	curves(script, history, "history", "using 1:2", "lw 0.8", 1);
	fprintf(script, "set key off\nset autoscale x\nset xlabel 'Displacement%s'\n"
	                "set ylabel 'Velocity%s'\n", length, rate);
	hawser__picture_panel(&picture, 0.115, 0.48, 0.175, 0.52);
	hawser__picture_xtics(&picture, -reach(history), reach(history), 5);
	fprintf(script, "first = %d\n", history->settled_from);
	curves(script, history, "history", "every ::first using 2:3", "lw 0.8", 0);
	hawser__picture_panel(&picture, 0.615, 0.975, 0.175, 0.52);
	spectrum(&picture, history);
	return hawser__picture_finish(&picture, report);
}
