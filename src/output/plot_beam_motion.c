/* output/plot_beam_motion.c - free motion of travelling beams: deflection, its logarithm, and the
 * rate of the energy of the material, as in D figures 9.10 and 9.11.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>

#include "output/output.h"

static void data(FILE *script, const struct hawser__beam_histories *histories)
{
	for (int i = 0; i < histories->count; i++) {
		const struct hawser__beam_history *history = &histories->history[i];

		fprintf(script, "$h%d << END\n", i);
		for (int k = 0; k < history->rows; k++)
			fprintf(script, "%.9g %.9g %.9g\n", history->time[k], history->y[k], history->rate[k]);
		fputs("END\n", script);
	}
}

static void lines(FILE *script, const struct hawser__beam_histories *histories, const char *what)
{
	for (int i = 0; i < histories->count; i++)
		fprintf(script, "%s$h%d using 1:%s with lines lt %d lw 1.3", i ? ", " : "plot ", i, what, i
		        + 1);
	fputc('\n', script);
}

/* The ranges, common to all panels of a column. */
static void ranges(struct hawser__picture *out, const struct hawser__beam_histories *histories,
        int rate)
{
	double low = INFINITY, high = -INFINITY, margin;

	for (int i = 0; i < histories->count; i++)
		for (int k = 0; k < histories->history[i].rows; k++) {
			const struct hawser__beam_history *history = &histories->history[i];
			double value = rate ? history->rate[k] : history->y[k];

			low = fmin(low, value);
			high = fmax(high, value);
		}
	margin = high > low ? 0.06*(high - low) : 1.0;
	fprintf(out->script, "set yrange [%.9g:%.9g]\n", low - margin, high + margin);
	hawser__picture_tics(out, 'y', low, high, 5);
}

enum hawser_status hawser__plot_beam_motion(const char *path,
                                            const struct hawser__beam_histories *histories,
                                            struct hawser_report *report)
{
	struct hawser__picture out;
	enum hawser_status status = hawser__picture_begin(&out, path, 15.0, 15.6, report);
	const struct hawser__beam_history *first = histories->history;
	const char *length = histories->dimensional ? "m" : "–";
	FILE *script = out.script;
	double end = first->time[first->rows - 1];

	if (status)
		return status;
	data(script, histories);
	fprintf(script, "set xrange [0:%.12g]\nset format x ''\n", end);
	hawser__picture_tics(&out, 'x', 0.0, end, 8);
	hawser__picture_panel(&out, 0.15, 0.97, 0.71, 0.98);
	ranges(&out, histories, 0);
	hawser__picture_ylabel(&out, "Deflection {/:Italic y} (%s)", length);
	lines(script, histories, "2");
	hawser__picture_panel(&out, 0.15, 0.97, 0.42, 0.67);
	fputs("set autoscale y\nset logscale y\nset ytics autofreq\nset format y '10^{%L}'\n", script);
	hawser__picture_ylabel(&out, "|{/:Italic y}| (%s)", length);
	lines(script, histories, "(abs($2))");
	hawser__picture_panel(&out, 0.15, 0.97, 0.13, 0.38);
	fprintf(script, "unset logscale y\nset format y '%%g'\nset format x '%%g'\n"
	                "set xlabel 'Time {/:Italic t} (%s)' offset 0,0.3\n",
	        histories->dimensional ? "s" : "–");
	ranges(&out, histories, 1);
	hawser__picture_ylabel(&out, "Energy rate (–)");
	if (histories->count > 1) {
		fputs("set key at screen 0.55,0.010 center bottom horizontal samplen 2.5 width -1\n", script);
		for (int i = 0; i < histories->count; i++)
			fprintf(script, "%s$h%d using 1:3 with lines lt %d lw 1.3 title '%s'",
			        i ? ", " : "plot ", i, i + 1, histories->history[i].label);
		fputc('\n', script);
	} else {
		lines(script, histories, "3");
	}
	return hawser__picture_finish(&out, report);
}
