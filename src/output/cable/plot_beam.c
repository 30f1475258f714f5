/* output/cable/plot_beam.c - eigenvalues of a travelling beam over its speed: imaginary parts
 * above, real parts below, as in D figures 9.1, 9.4 and 9.5.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>

#include "output/output.h"
#include "output/drawing/style.h"

/* Columns: speed, then im, largest re, smallest re of every branch. */
static void data(FILE *script, const struct hawser__beam_picture *picture)
{
	for (int i = 0; i < picture->variants; i++) {
		const struct hawser__beam_curve *curve = &picture->curve[i];
		const struct hawser_beam_sweep *sweep = curve->sweep;

		fprintf(script, "$v%d << END\n", i);
		for (int k = 0; k < sweep->stations; k++) {
			fprintf(script, "%.12g", sweep->station[k].speed*curve->per_speed);
			for (int b = 0; b < sweep->branches; b++) {
				int cell = k*sweep->branches + b;

				fprintf(script, " %.9g %.9g %.9g", sweep->im[cell]*curve->per_im,
				        sweep->re[2*cell]*curve->per_re,
				        sweep->re[2*cell + 1]*curve->per_re);
			}
			fputc('\n', script);
		}
		fputs("END\n", script);
	}
}

static void range(double *low, double *high, const struct hawser__beam_picture *picture, int real)
{
	*low = real ? INFINITY : 0.0;
	*high = -INFINITY;
	for (int i = 0; i < picture->variants; i++) {
		const struct hawser__beam_curve *curve = &picture->curve[i];
		int cells = curve->sweep->stations*curve->sweep->branches;

		for (int k = 0; k < (real ? 2*cells : cells); k++) {
			double value = real ? curve->sweep->re[k]*curve->per_re
			                    : curve->sweep->im[k]*curve->per_im;

			*low = fmin(*low, value);
			*high = fmax(*high, value);
		}
	}
	if (!(*high > *low)) {
		*low -= 1.0;
		*high += 1.0;
	}
}

static void lines(FILE *script, const struct hawser__beam_picture *picture, int real)
{
	const char *comma = "plot ";

	for (int i = 0; i < picture->variants; i++)
		for (int b = 0; b < picture->curve[i].sweep->branches; b++)
			for (int part = 0; part < (real ? 2 : 1); part++) {
				fprintf(script, "%s$v%d using 1:%d with lines lt %d lw 1.4", comma, i,
				        2 + 3*b + (real ? 1 + part : 0), picture->variants > 1 ? i + 1 : b%6 + 1);
				comma = ", ";
			}
	fputc('\n', script);
}

/* Marks at changes of stability, over both panels. */
static void marks(FILE *script, const struct hawser__beam_picture *picture)
{
	int number = 1;

	for (int i = 0; i < picture->variants; i++) {
		const struct hawser__beam_curve *curve = &picture->curve[i];

		for (int k = 0; k < curve->sweep->events; k++, number++) {
			double speed = curve->sweep->event[k].speed*curve->per_speed;

			fprintf(script, "set arrow %d from %.12g, graph 0 to %.12g, graph 1 nohead lt %d lw 0.8 "
			                "dt %s\n", number, speed, speed, picture->variants > 1 ? i + 1 : 7,
			        curve->sweep->event[k].kind == HAWSER_BEAM_CALM ? "(2,4)" : "(8,5)");
		}
	}
}

/* 1 if an instability ends (`ends` nonzero) or begins within the range. */
static int has_event(const struct hawser__beam_picture *picture, int ends)
{
	for (int i = 0; i < picture->variants; i++)
		for (int k = 0; k < picture->curve[i].sweep->events; k++)
			if ((picture->curve[i].sweep->event[k].kind == HAWSER_BEAM_CALM) == ends)
				return 1;
	return 0;
}

static void legend(struct hawser__picture *out, const struct hawser__beam_picture *picture)
{
	struct hawser__legend entries = {0};
	char name[32];

	for (int b = 0; picture->variants == 1 && b < picture->curve->sweep->branches && b < 6; b++) {
		snprintf(name, sizeof name, "mode %d", b + 1);
		hawser__legend_add(&entries, name, "with lines lt %d lw 1.4", b + 1);
	}
	for (int i = 0; i < picture->variants && picture->variants > 1; i++)
		hawser__legend_add(&entries, picture->curve[i].label, "with lines lt %d lw 1.4", i + 1);
	if (has_event(picture, 0))
		hawser__legend_add(&entries, "instability begins", "with lines lt 7 lw 0.8 dt (8,5)");
	if (has_event(picture, 1))
		hawser__legend_add(&entries, "instability ends", "with lines lt 7 lw 0.8 dt (2,4)");
	hawser__legend_draw(out, &entries);
}

static void panel(struct hawser__picture *out, const struct hawser__beam_picture *picture, int real)
{
	FILE *script = out->script;
	double low, high, margin;

	range(&low, &high, picture, real);
	margin = 0.04*(high - low);
	hawser__picture_panel(out, 0.14, 0.97, real ? 0.255 : 0.635, real ? 0.59 : 0.97);
	fprintf(script, "set yrange [%.9g:%.9g]\n", real ? low - margin : 0.0, high + margin);
	hawser__picture_tics(out, 'y', low, high, 6);
	if (real)
		fprintf(script, "set format x '%%g'\nset xlabel '%s' offset 0,0.3\n",
		        picture->speed.title);
	else
		fputs("set format x ''\nunset xlabel\n", script);
	hawser__picture_ylabel(out, "%s", real ? picture->re.title : picture->im.title);
	lines(script, picture, real);
}

enum hawser_status hawser__plot_beam_sweep(const char *path, const struct hawser__beam_picture *picture,
                                           struct hawser_report *report)
{
	struct hawser__picture out;
	enum hawser_status status = hawser__picture_begin(&out, path, 15.0, 14.2, report);
	double low = INFINITY, high = -INFINITY;

	if (status)
		return status;
	for (int i = 0; i < picture->variants; i++) {
		const struct hawser__beam_curve *curve = &picture->curve[i];

		for (int k = 0; k < curve->sweep->stations; k++) {
			low = fmin(low, curve->sweep->station[k].speed*curve->per_speed);
			high = fmax(high, curve->sweep->station[k].speed*curve->per_speed);
		}
	}
	data(out.script, picture);
	marks(out.script, picture);
	fprintf(out.script, "set xrange [%.12g:%.12g]\n", low, high);
	hawser__picture_tics(&out, 'x', low, high, 8);
	panel(&out, picture, 0);
	panel(&out, picture, 1);
	legend(&out, picture);
	return hawser__picture_finish(&out, report);
}
