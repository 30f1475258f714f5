/* output/cable/plot_modes.c - mode shapes, one panel per mode: components over the unstretched
 * arclength, or the displaced span. SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>

#include "output/output.h"
#include "output/drawing/panels.h"
#include "output/drawing/style.h"

#define MARK "pt 7 ps 0.5 lc rgb 'black'" /* of attachments */

enum { most_panels = HAWSER__PANELS, samples = 161 };
static const double enlarged = 0.08; /* of the chord: largest displacement drawn */

static double largest_of(const struct hawser_modes *modes, int k, int c)
{
	double largest = 0.0, shape[3];
	int i;

	for (i = 0; i < samples; i++) {
		hawser_modes_at(modes, shape, NULL, k, modes->statics.l*i/(samples - 1));
		largest = fmax(largest, fabs(shape[c]));
	}
	return largest;
}

static void data(FILE *script, const struct hawser_modes *modes, int k, double per)
{
	const struct hawser_statics *statics = &modes->statics;
	double shape[3];
	int i;

	fprintf(script, "$mode%d << END\n", k);
	for (i = 0; i < samples; i++) {
		double s = statics->l*i/(samples - 1);

		hawser_modes_at(modes, shape, NULL, k, s);
		fprintf(script, "%.9g %.9g %.9g %.9g\n", s*statics->span.d/per, shape[0], shape[1],
		        shape[2]);
	}
	fputs("END\n", script);
}

/* Common range of all panels; normalised shapes are of order 1. */
static double extent(const struct hawser_modes *modes, int panels)
{
	double largest = 0.0;
	int k, c;

	for (k = 0; k < panels; k++)
		for (c = 0; c < 3; c++)
			largest = fmax(largest, largest_of(modes, k, c));
	return 1.12*largest;
}

static void title(FILE *script, const struct hawser_modes *modes, int k)
{
	const struct hawser_mode *mode = &modes->mode[k];

	hawser__panels_frequency(script, k, mode->omega/modes->time_unit,
	                         mode->family == HAWSER_LONGITUDINAL ? "longitudinal"
	                                                             : hawser_plane_name(mode->plane));
}

static void components(FILE *script, const struct hawser_modes *modes, int k)
{
	double P = largest_of(modes, k, 0), Q = largest_of(modes, k, 1);
	double timesP = hawser__panels_magnify(P, Q), timesQ = hawser__panels_magnify(Q, P);

	fputs("unset label 1\n", script);
	if (modes->mode[k].plane == HAWSER_OUT_OF_PLANE) {
		fprintf(script, "plot $mode%d using 1:4 with lines lt 3\n", k);
		return;
	}
	if (timesP > 1.0 || timesQ > 1.0)
		fprintf(script, "set label 1 '{/:Italic %s} × %g' at graph 0.03, graph 0.08 left "
		                "tc lt %d\n", timesP > 1.0 ? "P" : "Q", fmax(timesP, timesQ),
		        timesP > 1.0 ? 2 : 1);
	fprintf(script, "plot $mode%d using 1:($2*%g) with lines lt 2 dt (10,5), "
	                "$mode%d using 1:($3*%g) with lines lt 1\n", k, timesP, k, timesQ);
}

static void legend(struct hawser__picture *picture)
{
	struct hawser__legend entries = {0};

	hawser__legend_add(&entries, "axial {/:Italic P}", "with lines lt 2 dt (10,5)");
	hawser__legend_add(&entries, "normal {/:Italic Q}", "with lines lt 1");
	hawser__legend_add(&entries, "out of plane {/:Italic B}", "with lines lt 3");
	hawser__legend_draw(picture, &entries);
}

enum hawser_status hawser__plot_modes(const char *path, const struct hawser_modes *modes,
                                      const struct hawser__axis *S,
                                      struct hawser_report *report)
{
	const struct hawser__panels at = hawser__panels_arrange(modes->n);
	struct hawser__picture picture;
	enum hawser_status status = hawser__picture_begin(&picture, path, 17.0, at.height, report);
	FILE *script = picture.script;
	double range;
	int k;

	if (status)
		return status;
	range = extent(modes, at.panels);
	for (k = 0; k < at.panels; k++)
		data(script, modes, k, S->per);
	fprintf(script, "set xrange [0:%.9g]\nset yrange [%.4g:%.4g]\nset xzeroaxis lt 7 lw 0.4\n",
	        modes->statics.length0/S->per, -range, range);
	hawser__picture_tics(&picture, 'x', 0.0, modes->statics.length0/S->per, at.columns > 2 ? 4 : 6);
	for (k = 0; k < at.panels; k++) {
		hawser__panels_open(&picture, &at, k, S->title, "Shape (–)");
		title(script, modes, k);
		components(script, modes, k);
	}
	legend(&picture);
	return hawser__picture_finish(&picture, report);
}

/* --- the displaced span --- */

/* Columns 1 to 6: x and height of the point s at rest and displaced in both directions. */
static void displaced_point(FILE *script, const struct hawser_modes *modes, int k, double s,
                            double scale, double per)
{
	const struct hawser_statics *st = &modes->statics;
	struct hawser_profile_point rest = hawser_statics_at(st, s*st->span.d);
	struct hawser_frame_point frame = hawser_statics_frame(st, s);
	int out = modes->mode[k].plane == HAWSER_OUT_OF_PLANE;
	double dx, dy, shape[3];

	hawser_modes_at(modes, shape, NULL, k, s);
	dx = out ? 0.0 : scale*(shape[0]*frame.ex - shape[1]*frame.ey);
	dy = out ? scale*shape[2] : scale*(shape[0]*frame.ey + shape[1]*frame.ex);
	if (st->space)
		dx = dy = 0.0;
	for (int c = 0; c < 3 && st->space; c++) {
		dx += out ? 0.0 : scale*shape[c]*frame.axis[c][0];
		dy += scale*shape[c]*frame.axis[c][out ? 2 : 1];
	}
	if (out)
		rest.y = rest.z; /* 0 but in space */
	fprintf(script, "%.9g %.9g %.9g %.9g %.9g %.9g\n", rest.x/per, rest.y/per, (rest.x + dx)/per,
	        (rest.y + dy)/per, (rest.x - dx)/per, (rest.y - dy)/per);
}

/* The span, with its kinks, and the attachments. */
static void displaced_data(FILE *script, const struct hawser_modes *modes, int k, double per)
{
	const struct hawser_statics *st = &modes->statics;
	double chord = hypot(st->span.d, st->span.h), most = 0.0, scale;
	int i, c, next = 0;

	for (c = 0; c < 3; c++)
		most = fmax(most, largest_of(modes, k, c));
	scale = enlarged*chord/most;
	fprintf(script, "$mode%d << END\n", k);
	for (i = 0; i < samples; i++) {
		double s = st->l*i/(samples - 1);

		for (; next < st->attachments && st->attached[next].s < s; next++)
			displaced_point(script, modes, k, st->attached[next].s, scale, per);
		displaced_point(script, modes, k, s, scale, per);
	}
	fprintf(script, "END\n$attached%d << END\n", k);
	for (i = 0; i < st->attachments; i++)
		displaced_point(script, modes, k, st->attached[i].s, scale, per);
	fputs("END\n", script);
}

/* Lowest and highest point of all in-plane panels. */
static void heights(double *low, double *high, const struct hawser_modes *modes, double per)
{
	const struct hawser_statics *st = &modes->statics;
	double margin = 1.15*enlarged*hypot(st->span.d, st->span.h);
	int i;

	*low = *high = 0.0;
	for (i = 0; i < samples; i++) {
		double y = hawser_statics_at(st, st->length0*i/(samples - 1)).y;

		*low = fmin(*low, y);
		*high = fmax(*high, y);
	}
	*low = (*low - margin)/per;
	*high = (*high + margin)/per;
}

static void displaced_legend(struct hawser__picture *picture, int attachments)
{
	struct hawser__legend entries = {0};

	hawser__legend_add(&entries, "at rest", "with lines lt 7 lw 0.8 dt (8,6)");
	hawser__legend_add(&entries, "in the plane", "with lines lt 1");
	hawser__legend_add(&entries, "from above, {/:Italic z}", "with lines lt 3");
	hawser__legend_add(&entries, "half a period later", "with lines lt 7 lw 0.7 dt (3,3)");
	if (attachments > 0)
		hawser__legend_add(&entries, "attachments", "with points " MARK);
	hawser__legend_draw(picture, &entries);
}

enum hawser_status hawser__plot_displaced(const char *path, const struct hawser_modes *modes,
                                          struct hawser_report *report)
{
	const struct hawser__panels at = hawser__panels_arrange(modes->n);
	const struct hawser_span *span = &modes->statics.span;
	struct hawser__picture picture;
	enum hawser_status status = hawser__picture_begin(&picture, path, 17.0, at.height, report);
	const struct hawser__axis x = hawser__axis_of("Distance {/:Italic x}", "m", 0.0);
	const struct hawser__axis y = hawser__axis_of("{/:Italic y} or {/:Italic z}, shape enlarged", "m",
	                                              0.0);
	FILE *script = picture.script;
	double low, high;
	int k;

	if (status)
		return status;
	for (k = 0; k < at.panels; k++)
		displaced_data(script, modes, k, x.per);
	heights(&low, &high, modes, y.per);
	/* common range of all panels; z is drawn about 0 */
	fprintf(script, "set xrange [%.9g:%.9g]\nset yrange [%.9g:%.9g]\n", -0.03*span->d/x.per,
	        1.03*span->d/x.per, low, high);
	hawser__picture_tics(&picture, 'x', 0.0, span->d/x.per, at.columns > 2 ? 4 : 6);
	hawser__picture_tics(&picture, 'y', low, high, 5);
	for (k = 0; k < at.panels; k++) {
		int out = modes->mode[k].plane == HAWSER_OUT_OF_PLANE;

		hawser__panels_open(&picture, &at, k, x.title, y.title);
		title(script, modes, k);
		fprintf(script, "plot $mode%d using 1:2 with lines lt 7 lw 0.8 dt (8,6), "
		                "$mode%d using 3:4 with lines lt %d, "
		                "$mode%d using 5:6 with lines lt %d lw 0.7 dt (3,3)", k, k, out ? 3 : 1, k,
		        out ? 3 : 1);
		if (modes->statics.attachments > 0)
			fprintf(script, ", $attached%d using 3:4 with points " MARK, k);
		fputc('\n', script);
	}
	displaced_legend(&picture, modes->statics.attachments);
	return hawser__picture_finish(&picture, report);
}
