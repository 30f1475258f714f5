/* output/structures/plot_track.c - see plot_track.h. Branches have the colour of their plane,
 * and their number at the end, moved apart where they would meet.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>

#include "core/report.h"
#include "output/structures/plot_track.h"
#include "output/drawing/style.h"

#define WIDTH 17.0  /* cm */
#define HEIGHT 12.0 /* cm */
#define APART 0.028 /* of the height of the axis: between two numbers */
#define IN_PLANE "lt 1 lw 1.4"
#define RESONANCE "pt 12 ps 0.8 lw 1.2 lc rgb '#d55e00'"
#define OUT_OF_PLANE "lt 3 lw 1.1 dt (9,5)"

static double y_of(const struct hawser__track_picture *of, int i, int b)
{
	return of->track->point[i*of->track->branches + b].omega/of->y_per;
}

static void data(FILE *script, const struct hawser__track_picture *of)
{
	const struct hawser_ropeway_track *t = of->track;

	fputs("$track << END\n", script);
	for (int i = 0; i < t->samples; i++) {
		fprintf(script, "%.12g", t->sample[i].value/of->x_per);
		for (int b = 0; b < t->branches; b++)
			fprintf(script, " %.9g", y_of(of, i, b));
		fputc('\n', script);
	}
	fputs("END\n", script);
	for (int veers = 0; veers < 2; veers++) {
		fprintf(script, "$marks%d << END\nNaN NaN\n", veers);
		for (int i = 0; i < t->crossovers; i++)
			if (t->crossover[i].veers == veers)
				fprintf(script, "%.12g %.9g\n", t->crossover[i].value/of->x_per,
				        t->crossover[i].omega/of->y_per);
		fputs("END\n", script);
	}
	fputs("$resonances << END\nNaN NaN\n", script);
	for (int i = 0; i < of->resonances; i++)
		fprintf(script, "%.12g %.9g\n", of->resonance[i].speed/of->x_per,
		        of->resonance[i].omega/of->y_per);
	fputs("END\n", script);
}

/* The number of each line of the excitation, where it leaves the panel. */
static void harmonics(FILE *script, const struct hawser__track_picture *of, double high, double last)
{
	for (int k = 1; k <= of->harmonics; k++) {
		double slope = k*of->slope*of->x_per/of->y_per, x = fmin(last, high/slope);

		fprintf(script, "set label '%d' at %.9g,%.9g right offset -0.6,-0.5 tc rgb '#606060' "
		        "font ',8'\n", k, x, slope*x);
	}
}

/* Numbers of the branches at the last sample, by height. */
static enum hawser_status numbers(FILE *script, const struct hawser__track_picture *of, double low,
                                  double high, struct hawser_report *report)
{
	const struct hawser_ropeway_track *t = of->track;
	int *taken = calloc((size_t)t->branches + 1, sizeof *taken), last = t->samples - 1;
	double before = -HUGE_VAL;

	if (!taken)
		return hawser__no_memory(report, "picture");
	fputs("$numbers << END\nNaN NaN none\n", script);
	for (;;) {
		int next = -1;

		for (int b = 0; b < t->branches; b++)
			if (!taken[b] && isfinite(y_of(of, last, b)) &&
			    (next < 0 || y_of(of, last, b) < y_of(of, last, next)))
				next = b;
		if (next < 0)
			break;
		taken[next] = 1;
		before = fmax(y_of(of, last, next), before + APART*(high - low));
		fprintf(script, "%.12g %.9g %d\n", t->sample[last].value/of->x_per, before, next + 1);
	}
	fputs("END\n", script);
	free(taken);
	return HAWSER_OK;
}

static void draw(FILE *script, const struct hawser__track_picture *of)
{
	const struct hawser_ropeway_track *t = of->track;

	fputs("plot NaN notitle", script);
	for (int k = 1; k <= of->harmonics; k++)
		fprintf(script, ", %.9g*x with lines lc rgb '#909090' lw 0.8 dt (3,3)",
		        k*of->slope*of->x_per/of->y_per);
	for (int b = 0; b < t->branches; b++)
		fprintf(script, ", $track using 1:%d with lines %s", b + 2,
		        t->plane[b] == HAWSER_OUT_OF_PLANE ? OUT_OF_PLANE : IN_PLANE);
	if (of->resonances > 0)
		fputs(", $resonances using 1:2 with points " RESONANCE, script);
	fprintf(script, ", $marks0 using 1:2 with points pt 6 ps 0.7 lc rgb 'black'"
	        ", $marks1 using 1:2 with points pt 7 ps 0.6 lc rgb 'black'"
	        ", $numbers using 1:2:3 with labels left offset %g,0 font ',8'\n",
	        t->sample[t->samples - 1].value > t->sample[0].value ? 0.6 : -1.4);
}

static void legend(struct hawser__picture *picture, const struct hawser__track_picture *of)
{
	const struct hawser_ropeway_track *t = of->track;
	struct hawser__legend entries = {0};
	int out = 0, marks[2] = {0};

	for (int b = 0; b < t->branches; b++)
		out += t->plane[b] == HAWSER_OUT_OF_PLANE;
	for (int i = 0; i < t->crossovers; i++)
		marks[t->crossover[i].veers]++;
	if (out < t->branches)
		hawser__legend_add(&entries, "in-plane", "with lines " IN_PLANE);
	if (out > 0)
		hawser__legend_add(&entries, "out-of-plane", "with lines " OUT_OF_PLANE);
	if (marks[0])
		hawser__legend_add(&entries, "crossing", "with points pt 6 ps 0.7 lc rgb 'black'");
	if (marks[1])
		hawser__legend_add(&entries, "veering", "with points pt 7 ps 0.6 lc rgb 'black'");
	if (of->resonances > 0)
		hawser__legend_add(&entries, "resonance", "with points " RESONANCE);
	if (of->harmonics > 0)
		hawser__legend_add(&entries, "passing of carriers, and its multiples",
		                   "with lines lc rgb '#909090' lw 0.8 dt (3,3)");
	hawser__legend_draw(picture, &entries);
}

enum hawser_status hawser__plot_track(const char *path, const struct hawser__track_picture *of,
                                      struct hawser_report *report)
{
	const struct hawser_ropeway_track *t = of->track;
	double x0 = t->sample[0].value/of->x_per, x1 = t->sample[t->samples - 1].value/of->x_per;
	double low = HUGE_VAL, high = 0.0, margin;
	struct hawser__picture picture;
	enum hawser_status status = hawser__picture_begin(&picture, path, WIDTH, HEIGHT, report);
	FILE *script = picture.script;

	if (status)
		return status;
	for (int i = 0; i < t->samples; i++)
		for (int b = 0; b < t->branches; b++) {
			low = fmin(low, y_of(of, i, b));
			high = fmax(high, y_of(of, i, b));
		}
	low = of->harmonics > 0 ? 0.0 : low; /* the lines begin at 0 */
	margin = fmax(0.06*(high - low), 1e-3*high);
	low = fmax(low - margin, 0.0);
	high += margin;
	data(script, of);
	status = numbers(script, of, low, high, report);
	if (status) {
		hawser__picture_abort(&picture);
		return status;
	}
	hawser__picture_panel(&picture, 0.125, 0.955, HAWSER__LEGEND_CM/HEIGHT, 0.97);
	fprintf(script, "set xrange [%.12g:%.12g]\nset yrange [%.9g:%.9g]\nset datafile missing 'nan'\n"
	        "set xlabel '%s'\n", fmin(x0, x1), fmax(x0, x1), low, high, of->x_title);
	if (of->logarithmic)
		hawser__picture_log_tics(&picture, "x", fmin(x0, x1), fmax(x0, x1));
	else
		hawser__picture_tics(&picture, 'x', fmin(x0, x1), fmax(x0, x1), 8);
	hawser__picture_tics(&picture, 'y', low, high, 8);
	hawser__picture_ylabel(&picture, "%s", of->y_title);
	harmonics(script, of, high, fmax(x0, x1));
	draw(script, of);
	legend(&picture, of);
	return hawser__picture_finish(&picture, report);
}
