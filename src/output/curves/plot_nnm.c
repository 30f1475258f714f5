/* output/curves/plot_nnm.c - see plot_nnm.h. Unstable motions are dashed; branches have other
 * colours than the mode's own curve. SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>

#include "output/curves/plot_nnm.h"
#include "output/drawing/style.h"

static const char *const style[] = {"lc rgb '#0072B2' lw 1.8", "lc rgb '#D55E00' lw 1.3",
                                    "lc rgb '#009E73' lw 1.3"};
enum { STYLES = sizeof style/sizeof *style };

/* The points of a curve, with gaps where they are not stable (0) or not unstable (1). */
static void curve_data(FILE *script, const struct hawser__nnm_picture *of, int c, int unstable,
                       double *low, double *high)
{
	const struct hawser_backbone *motion = &of->nnm->curve[c].motion;

	fprintf(script, "$%s%d << END\n", unstable ? "unstable" : "stable", c);
	for (int i = 0; i < motion->points; i++) {
		const struct hawser_backbone_point *p = &motion->point[i];
		int here = (p->unstable > 0) == unstable;
		int before = i > 0 && (motion->point[i - 1].unstable > 0) == unstable;

		if (!(p->energy > 0.0))
			continue;
		if (here || before) /* up to the first point of the other kind */
			fprintf(script, "%.12g %.12g\n", p->energy*of->per[0], p->omega*of->per[1]);
		if (!here)
			fputs("\n", script);
		*low = fmin(*low, p->omega*of->per[1]);
		*high = fmax(*high, p->omega*of->per[1]);
	}
	fputs("NaN NaN\nEND\n", script);
}

static int mark_data(FILE *script, const struct hawser__nnm_picture *of)
{
	int count = 0;

	fputs("$marks << END\n", script);
	for (int c = 0; c < of->nnm->curves; c++)
		for (int b = 0; b < of->nnm->curve[c].motion.branches; b++, count++)
			fprintf(script, "%.12g %.12g\n", of->nnm->curve[c].motion.branch[b].energy*of->per[0],
			        of->nnm->curve[c].motion.branch[b].omega*of->per[1]);
	fputs("NaN NaN\nEND\n", script);
	return count;
}

enum hawser_status hawser__plot_nnm(const char *path, const struct hawser__nnm_picture *of,
                                    struct hawser_report *report)
{
	struct hawser__picture picture;
	struct hawser__legend entries = {0};
	enum hawser_status status = hawser__picture_begin(&picture, path, 16.0, 11.5, report);
	FILE *script = picture.script;
	double low = INFINITY, high = -INFINITY, room;
	int marks, curves = of->nnm->curves;

	if (status)
		return status;
	for (int c = 0; c < curves; c++)
		for (int unstable = 0; unstable < 2; unstable++)
			curve_data(script, of, c, unstable, &low, &high);
	marks = mark_data(script, of);
	hawser__picture_panel(&picture, 0.14, 0.965, 0.25, 0.97);
	fputs("set logscale x\nset format x '10^{%T}'\n", script);
	room = high > low ? 0.04*(high - low) : 0.01*high;
	fprintf(script, "set yrange [%.12g:%.12g]\n", low - room, high + room);
	hawser__picture_tics(&picture, 'y', low - room, high + room, 7);
	fprintf(script, "set xlabel '%s'\n", of->axis[0].title);
	hawser__picture_ylabel(&picture, "%s", of->axis[1].title);
	fputs("plot ", script);
	for (int c = 0; c < curves; c++) {
		int depth = of->nnm->curve[c].depth;
		const char *look = style[depth < STYLES ? depth : STYLES - 1];

		fprintf(script, "$stable%d with lines %s, $unstable%d with lines %s dt (6,4), ", c, look,
		        c, look);
	}
	fputs("$marks with points pt 7 ps 0.5 lc rgb 'black'\n", script);
	hawser__legend_add(&entries, "the mode", "with lines %s", style[0]);
	if (curves > 1)
		hawser__legend_add(&entries, "branches", "with lines %s", style[1]);
	hawser__legend_add(&entries, "unstable", "with lines lc rgb '#404040' lw 1.3 dt (6,4)");
	if (marks)
		hawser__legend_add(&entries, "branch points", "with points pt 7 ps 0.5 lc rgb 'black'");
	hawser__legend_draw(&picture, &entries);
	return hawser__picture_finish(&picture, report);
}
