/* output/cable/plot_curves.c - a cable over its tension: compatibility curves (B Figure 4.1), and the
 * deflection of static models (B Figure 2.6).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>

#include "output/output.h"
#include "output/drawing/style.h"

enum hawser_status hawser__plot_compatibility(const char *path, const struct hawser_statics *here,
                                              const struct hawser_statics *curve, int points,
                                              const struct hawser__axis *axis,
                                              struct hawser_report *report)
{
	struct hawser__picture picture;
	enum hawser_status status = hawser__picture_begin(&picture, path, 17.0, 9.4, report);
	struct hawser__legend entries = {0};
	FILE *script = picture.script;
	char name[80];
	int i;

	if (status)
		return status;
	fputs("$curve << END\n", script);
	for (i = 0; i < points; i++)
		fprintf(script, "%.9g %.9g %.9g\n", curve[i].delta, curve[i].eta, curve[i].epsilon);
	fprintf(script, "END\n$here << END\n%.9g %.9g %.9g\nEND\n", here->delta, here->eta,
	        here->epsilon);
	fprintf(script, "set logscale y\nset format y '10^{%%L}'\n"
	        "set logscale x\nset format x '10^{%%L}'\nset xlabel '%s'\n", axis[0].title);
	hawser__picture_panel(&picture, 0.13, 0.53, 0.29, 0.96);
	hawser__picture_ylabel(&picture, "%s", axis[2].title);
	fputs("plot $curve using 1:3 with lines lt 1, $here using 1:3 with points pt 7 ps 1 lt 2\n",
	      script);
	fprintf(script, "unset logscale x\nset format x '%%g'\nunset label\nset format y ''\n"
	        "set xlabel '%s'\n", axis[1].title);
	hawser__picture_panel(&picture, 0.60, 0.96, 0.29, 0.96);
	hawser__picture_tics(&picture, 'x', curve[0].eta < curve[points - 1].eta ? curve[0].eta : 0.0,
	                     fmax(curve[0].eta, curve[points - 1].eta), 5);
	fputs("plot $curve using 2:3 with lines lt 1, $here using 2:3 with points pt 7 ps 1 lt 2\n",
	      script);
	snprintf(name, sizeof name, "this cable, {/:Italic h/d} = %.4g", here->hs);
	hawser__legend_add(&entries, name, "with lines lt 1");
	hawser__legend_add(&entries, "scene", "with points pt 7 ps 1 lt 2");
	hawser__legend_draw(&picture, &entries);
	return hawser__picture_finish(&picture, report);
}

/* Columns: delta, the sag over the span of every model, the relative errors of all but the
 * first. */
static void deflection_data(FILE *script, const struct hawser__deflections *d)
{
	int i, k;

	fputs("$curve << END\n", script);
	for (i = 0; i < d->points; i++) {
		fprintf(script, "%.9g", d->curve[i].delta);
		for (k = 0; k < d->models; k++)
			fprintf(script, " %.12g", d->curve[k*d->points + i].sag/d->here->span.d);
		for (k = 1; k < d->models; k++)
			fprintf(script, " %.9g", fabs(d->curve[k*d->points + i].sag/d->curve[i].sag - 1.0));
		fputs("\n", script);
	}
	fputs("END\n", script);
}

enum hawser_status hawser__plot_deflections(const char *path, const struct hawser__deflections *d,
                                            struct hawser_report *report)
{
	static const char *const dash[] = {"solid", "(14,5)", "(5,4)", "(14,4,3,4)"};
	struct hawser__picture picture;
	enum hawser_status status = hawser__picture_begin(&picture, path, 16.0, 13.0, report);
	struct hawser__legend entries = {0};
	FILE *script = picture.script;
	int k;

	if (status)
		return status;
	deflection_data(script, d);
	fprintf(script, "set logscale x\nset xrange [%.9g:%.9g]\nset logscale y\nset format y '10^{%%L}'\n"
	                "set format x ''\n", d->curve[d->points - 1].delta, d->curve[0].delta);
	fprintf(script, "set arrow 1 from %.9g, graph 0 to %.9g, graph 1 nohead lt 7 lw 0.8 dt (4,4)\n",
	        d->here->delta, d->here->delta);
	hawser__picture_panel(&picture, 0.13, 0.97, 0.60, 0.97);
	hawser__picture_ylabel(&picture, "Sag over span (–)");
	fputs("plot ", script);
	for (k = 0; k < d->models; k++)
		fprintf(script, "%s$curve using 1:%d with lines lt %d dt %s", k ? ", " : "", k + 2, k + 1,
		        dash[k < 4 ? k : 3]);
	fprintf(script, "\nset format x '10^{%%L}'\nset xlabel '%s'\n", d->x.title);
	hawser__picture_panel(&picture, 0.13, 0.97, 0.22, 0.55);
	hawser__picture_ylabel(&picture, "Relative error of sag (–)");
	fputs("plot ", script);
	for (k = 1; k < d->models; k++)
		fprintf(script, "%s$curve using 1:%d with lines lt %d dt %s", k > 1 ? ", " : "",
		        1 + d->models + k, k + 1, dash[k < 4 ? k : 3]);
	fputs("\n", script);
	for (k = 0; k < d->models; k++)
		hawser__legend_add(&entries, d->name[k], "with lines lt %d dt %s", k + 1,
		                   dash[k < 4 ? k : 3]);
	hawser__legend_add(&entries, "scene", "with lines lt 7 lw 0.8 dt (4,4)");
	hawser__legend_draw(&picture, &entries);
	return hawser__picture_finish(&picture, report);
}
