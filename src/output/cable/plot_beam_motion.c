/* output/cable/plot_beam_motion.c - free motion of travelling beams: deflection, its logarithm, and the
 * rate of the energy of the material, as in D figures 9.10 and 9.11.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>

#include "output/output.h"
#include "output/drawing/style.h"

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

/* cm: height of the three panels, gap between them, room above the first one, and below the last one
 * where there is no legend */
static const double high = 4.0, gap = 0.6, above = 0.3, below = 2.0;

/* Panel k, from the top. */
static void panel(struct hawser__picture *out, int k)
{
	double upper = out->height - above - k*(high + gap);

	hawser__picture_panel(out, 0.15, 0.97, (upper - high)/out->height, upper/out->height);
}

enum hawser_status hawser__plot_beam_motion(const char *path,
                                            const struct hawser__beam_histories *histories,
                                            struct hawser_report *report)
{
	const struct hawser__beam_history *first = histories->history;
	const double width = 15.0, end = first->time[first->rows - 1];
	struct hawser__legend entries = {0};
	struct hawser__picture out;
	enum hawser_status status;
	FILE *script;

	for (int i = 0; histories->count > 1 && i < histories->count; i++)
		hawser__legend_add(&entries, histories->history[i].label, "with lines lt %d lw 1.3", i + 1);
	status = hawser__picture_begin(&out, path, width, above + 3.0*high + 2.0*gap +
	                               (entries.count ? hawser__legend_cm(&entries, width) : below),
	                               report);
	if (status)
		return status;
	script = out.script;
	data(script, histories);
	fprintf(script, "set xrange [0:%.12g]\nset format x ''\n", end);
	hawser__picture_tics(&out, 'x', 0.0, end, 8);
	panel(&out, 0);
	ranges(&out, histories, 0);
	hawser__picture_ylabel(&out, "%s", histories->y.title);
	lines(script, histories, "2");
	panel(&out, 1);
	fputs("set autoscale y\nset logscale y\nset ytics autofreq\nset format y '10^{%L}'\n", script);
	hawser__picture_ylabel(&out, "|{/:Italic y}| (%s)", histories->y.unit);
	lines(script, histories, "(abs($2))");
	panel(&out, 2);
	fprintf(script, "unset logscale y\nset format y '%%g'\nset format x '%%g'\n"
	                "set xlabel '%s' offset 0,0.3\n", histories->time.title);
	ranges(&out, histories, 1);
	hawser__picture_ylabel(&out, "%s", histories->rate.title);
	lines(script, histories, "3");
	if (entries.count)
		hawser__legend_draw(&out, &entries);
	return hawser__picture_finish(&out, report);
}
