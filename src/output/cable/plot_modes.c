/* output/cable/plot_modes.c - mode shapes, one panel per mode: components over the unstretched
 * arclength; of a travelling cable their downstream and upstream waves; or the displaced span.
 *
 * A motion is the real part of (shape) exp(i omega t): the real part is the shape at t = 0, the
 * imaginary part, which modes of a cable at rest do not have, the shape a quarter of a period earlier.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "output/drawing/figure.h"
#include "output/output.h"

#define MARK "with points pt 7 ps 0.5 lc rgb 'black'" /* of attachments */

enum { samples = 161, moments = 4 };
static const double enlarged = 0.08; /* of the chord: largest displacement drawn */
static const char *const fading[moments] = {"#08306b", "#2f7ebc", "#7fb8dc", "#c3d9ee"};
static const char *const moment[moments] = {"{/:Italic t} = 0", "1/8", "2/8", "3/8 period"};

static void shape_at(double shape[6], const struct hawser_modes *modes, int k, double s)
{
	for (int c = 3; c < 6; c++)
		shape[c] = 0.0;
	hawser_modes_at(modes, shape, NULL, k, s);
}

static double s_of(const struct hawser_modes *modes, int i)
{
	return modes->statics.l*i/(samples - 1);
}

static double largest_of(const struct hawser_modes *modes, int k, int c)
{
	double largest = 0.0, shape[6];

	for (int i = 0; i < samples; i++) {
		shape_at(shape, modes, k, s_of(modes, i));
		largest = fmax(largest, hypot(shape[c], shape[3 + c]));
	}
	return largest;
}

/* Actual unstretched arclength. */
static double arclength(const struct hawser_modes *modes, double s)
{
	return s*modes->statics.span.d*(1.0 - modes->statics.motion.mach2);
}

static int leading(const struct hawser_mode *mode)
{
	if (mode->plane == HAWSER_OUT_OF_PLANE)
		return 2;
	return mode->axial_share > mode->normal_share ? 0 : 1;
}

static void title(FILE *script, const struct hawser_modes *modes, int k)
{
	const struct hawser_mode *mode = &modes->mode[k];
	int along = modes->gyroscopic ? leading(mode) == 0 : mode->family == HAWSER_LONGITUDINAL;

	hawser__panels_frequency(script, k, mode->omega/modes->time_unit,
	                         along ? "longitudinal" : hawser_plane_name(mode->plane));
}

struct drawing {
	struct hawser__figure figure;
	const struct hawser_modes *modes;
	struct hawser__panels at;
	struct hawser__panel_frame frame; /* common to all panels */
};

static enum hawser_status begin(struct drawing *of, const char *path, struct hawser_report *report)
{
	of->at = hawser__panels_arrange(of->modes->n);
	return hawser__figure_begin(&of->figure, path, 17.0, of->at.height, report);
}

/* --- components over the arclength --- */

/* Normalised shapes are of order 1. */
static void set_ranges(struct drawing *of, const struct hawser__axis *S,
                       const struct hawser__axis *shape)
{
	double largest = 0.0;

	for (int k = 0; k < of->at.panels; k++)
		for (int c = 0; c < 3; c++)
			largest = fmax(largest, largest_of(of->modes, k, c));
	of->frame = (struct hawser__panel_frame){
		.x = {S, 0.0, arclength(of->modes, of->modes->statics.l), .tics = of->at.columns > 2 ? 4 : 6},
		.y = {.axis = shape, .from = -1.12*largest, .to = 1.12*largest}};
	fputs("set xzeroaxis lt 7 lw 0.4\n", of->figure.out.script);
}

/* A component, real or imaginary parts, times a factor. */
static void draw_component(struct drawing *of, int k, int c, int imaginary, double times)
{
	static const char *const name[] = {"axial {/:Italic P}", "normal {/:Italic Q}",
	                                   "out of plane {/:Italic B}"};
	static const int colour[] = {2, 1, 3};
	double shape[6];

	for (int i = 0; i < samples; i++) {
		shape_at(shape, of->modes, k, s_of(of->modes, i));
		hawser__figure_put(&of->figure, arclength(of->modes, s_of(of->modes, i)),
		                   times*shape[c + 3*imaginary]);
	}
	hawser__figure_draw(&of->figure, imaginary ? NULL : name[c], "with lines lt %d%s", colour[c],
	                    imaginary ? " dt (4,4)" : c == 0 && !of->modes->gyroscopic ? " dt (10,5)" : "");
}

static void draw_components(struct drawing *of, int k)
{
	double P = largest_of(of->modes, k, 0), Q = largest_of(of->modes, k, 1);
	double times[] = {hawser__panels_magnify(P, Q), hawser__panels_magnify(Q, P), 1.0};
	int out = of->modes->mode[k].plane == HAWSER_OUT_OF_PLANE, one = times[0] > 1.0 ? 0 : 1;

	if (!out && times[one] > 1.0)
		fprintf(of->figure.out.script, "set label '{/:Italic %c} × %g' at graph 0.03, graph 0.08 left "
		        "tc lt %d\n", "PQ"[one], times[one], 2 - one);
	for (int c = out ? 2 : 0; c < (out ? 3 : 2); c++)
		for (int imaginary = 0; imaginary <= of->modes->gyroscopic; imaginary++)
			draw_component(of, k, c, imaginary, times[c]);
}

enum hawser_status hawser__plot_modes(const char *path, const struct hawser_modes *modes,
                                      const struct hawser__axis *S,
                                      struct hawser_report *report)
{
	static const struct hawser__axis shape = {"Shape (–)", "", 1.0};
	struct drawing of = {.modes = modes};
	enum hawser_status status = begin(&of, path, report);

	if (status)
		return status;
	hawser__legend_once(&of.figure.legend, "axial {/:Italic P}", modes->gyroscopic
	                    ? "with lines lt 2" : "with lines lt 2 dt (10,5)");
	hawser__legend_once(&of.figure.legend, "normal {/:Italic Q}", "with lines lt 1");
	hawser__legend_once(&of.figure.legend, "out of plane {/:Italic B}", "with lines lt 3");
	set_ranges(&of, S, &shape);
	for (int k = 0; k < of.at.panels; k++) {
		hawser__panels_open(&of.figure, &of.at, k, &of.frame);
		title(of.figure.out.script, modes, k);
		draw_components(&of, k);
	}
	if (modes->gyroscopic) {
		hawser__legend_once(&of.figure.legend, "real", "with lines lt 7");
		hawser__legend_once(&of.figure.legend, "imaginary part", "with lines lt 7 dt (4,4)");
	}
	return hawser__figure_finish(&of.figure, report);
}

/* --- waves: the leading component at instants of half a period, with its two waves --- */

/* What: from 0, the instants; then the envelope above and below, the downstream and the upstream
 * wave. */
enum { ABOVE = moments, BELOW, DOWNSTREAM, UPSTREAM };

static void put_wave(struct drawing *of, int k, int what)
{
	int c = leading(&of->modes->mode[k]);

	for (int i = 0; i < samples; i++) {
		double s = s_of(of->modes, i), x[6], with[6], against[6], size, angle = M_PI*what/moments;

		shape_at(x, of->modes, k, s);
		hawser_complex_modes_waves(of->modes, with, against, k, s);
		size = hypot(x[c], x[3 + c]);
		hawser__figure_put(&of->figure, arclength(of->modes, s), what == ABOVE ? size
		                   : what == BELOW ? -size : what == DOWNSTREAM ? with[c]
		                   : what == UPSTREAM ? against[c] : x[c]*cos(angle) - x[3 + c]*sin(angle));
	}
}

enum hawser_status hawser__plot_waves(const char *path, const struct hawser_modes *modes,
                                      const struct hawser__axis *S,
                                      struct hawser_report *report)
{
	static const struct hawser__axis component = {"Leading component (–)", "", 1.0};
	struct drawing of = {.modes = modes};
	enum hawser_status status = begin(&of, path, report);

	if (status)
		return status;
	set_ranges(&of, S, &component);
	for (int m = 0; m < moments; m++)
		hawser__legend_add(&of.figure.legend, moment[m], "with lines lc rgb '%s'", fading[m]);
	for (int k = 0; k < of.at.panels; k++) {
		hawser__panels_open(&of.figure, &of.at, k, &of.frame);
		title(of.figure.out.script, modes, k);
		for (int what = ABOVE; what <= BELOW; what++) {
			put_wave(&of, k, what);
			hawser__figure_draw(&of.figure, "envelope", "with lines lt 7 lw 0.7 dt (8,6)");
		}
		for (int m = moments - 1; m >= 0; m--) {
			put_wave(&of, k, m);
			hawser__figure_draw(&of.figure, NULL, "with lines lc rgb '%s'", fading[m]);
		}
		for (int what = DOWNSTREAM; what <= UPSTREAM; what++) {
			put_wave(&of, k, what);
			hawser__figure_draw(&of.figure, what == UPSTREAM ? "upstream wave" : "downstream wave",
			                    "with lines lt %d lw 1.1 dt (4,4)", what == UPSTREAM ? 2 : 3);
		}
	}
	return hawser__figure_finish(&of.figure, report);
}

/* --- the displaced span: in the plane about the static profile; out of it, seen from above --- */

/* A point at an instant of the motion, angle from 0 to 2 pi; at rest with scale 0. */
static void put_point(struct drawing *of, int k, double s, double scale, double angle)
{
	const struct hawser_statics *st = &of->modes->statics;
	struct hawser_profile_point rest = hawser_statics_at(st, s*st->span.d);
	struct hawser_frame_point frame = hawser_statics_frame(st, s);
	int out = of->modes->mode[k].plane == HAWSER_OUT_OF_PLANE;
	double shape[6], at[3], dx, dy;

	shape_at(shape, of->modes, k, s);
	for (int c = 0; c < 3; c++)
		at[c] = scale*(cos(angle)*shape[c] - sin(angle)*shape[3 + c]);
	dx = out ? 0.0 : at[0]*frame.ex - at[1]*frame.ey;
	dy = out ? at[2] : at[0]*frame.ey + at[1]*frame.ex;
	if (st->space)
		dx = dy = 0.0;
	for (int c = 0; c < 3 && st->space; c++) {
		dx += out ? 0.0 : at[c]*frame.axis[c][0];
		dy += at[c]*frame.axis[c][out ? 2 : 1];
	}
	hawser__figure_put(&of->figure, rest.x + dx, (out ? rest.z : rest.y) + dy); /* z 0 but in space */
}

/* The span, with its kinks. */
static void put_span(struct drawing *of, int k, double scale, double angle)
{
	const struct hawser_statics *st = &of->modes->statics;
	int next = 0;

	for (int i = 0; i < samples; i++) {
		for (; next < st->attachments && st->attached[next].s < s_of(of->modes, i); next++)
			put_point(of, k, st->attached[next].s, scale, angle);
		put_point(of, k, s_of(of->modes, i), scale, angle);
	}
}

/* A mode of a cable at rest: now, and half a period later. */
static void draw_displaced(struct drawing *of, int k, double scale)
{
	const struct hawser_statics *st = &of->modes->statics;
	int colour = of->modes->mode[k].plane == HAWSER_OUT_OF_PLANE ? 3 : 1;

	put_span(of, k, scale, 0.0);
	hawser__figure_draw(&of->figure, NULL, "with lines lt %d", colour);
	put_span(of, k, scale, M_PI);
	hawser__figure_draw(&of->figure, NULL, "with lines lt %d lw 0.7 dt (3,3)", colour);
	for (int i = 0; i < st->attachments; i++)
		put_point(of, k, st->attached[i].s, scale, 0.0);
	hawser__figure_draw(&of->figure, "attachments", MARK);
}

static void draw_moments(struct drawing *of, int k, double scale)
{
	for (int m = moments - 1; m >= 0; m--) {
		put_span(of, k, scale, M_PI*m/moments);
		hawser__figure_draw(&of->figure, NULL, "with lines lc rgb '%s'", fading[m]);
	}
}

/* Lowest and highest point of all in-plane panels; z is drawn about 0. */
static void heights(double *low, double *high, const struct hawser_statics *st)
{
	double margin = 1.15*enlarged*hypot(st->span.d, st->span.h);

	*low = *high = 0.0;
	for (int i = 0; i < samples; i++) {
		double y = hawser_statics_at(st, st->length0*i/(samples - 1)).y;

		*low = fmin(*low, y);
		*high = fmax(*high, y);
	}
	*low -= margin;
	*high += margin;
}

static void add_entries(struct hawser__legend *legend, int moving)
{
	hawser__legend_once(legend, moving ? "steady state" : "at rest", "with lines lt 7 lw 0.8 dt (8,6)");
	for (int m = 0; m < moments && moving; m++)
		hawser__legend_add(legend, moment[m], "with lines lc rgb '%s'", fading[m]);
	if (moving)
		return;
	hawser__legend_once(legend, "in the plane", "with lines lt 1");
	hawser__legend_once(legend, "from above, {/:Italic z}", "with lines lt 3");
	hawser__legend_once(legend, "half a period later", "with lines lt 7 lw 0.7 dt (3,3)");
}

enum hawser_status hawser__plot_displaced(const char *path, const struct hawser_modes *modes,
                                          struct hawser_report *report)
{
	const struct hawser_span *span = &modes->statics.span;
	const struct hawser__axis x = hawser__axis_of("Distance {/:Italic x}", "m", 0.0);
	const struct hawser__axis y = hawser__axis_of(
		modes->gyroscopic ? "{/:Italic y} or {/:Italic z}"
		                  : "{/:Italic y} or {/:Italic z}, shape enlarged", "m", 0.0);
	struct drawing of = {.modes = modes};
	double low, high;
	enum hawser_status status = begin(&of, path, report);

	if (status)
		return status;
	heights(&low, &high, &modes->statics);
	of.frame = (struct hawser__panel_frame){
		.x = {&x, -0.03*span->d, 1.03*span->d, .tics = of.at.columns > 2 ? 5 : 7},
		.y = {&y, low, high, .tics = 5}};
	add_entries(&of.figure.legend, modes->gyroscopic);
	for (int k = 0; k < of.at.panels; k++) {
		double most = fmax(largest_of(modes, k, 0),
		                   fmax(largest_of(modes, k, 1), largest_of(modes, k, 2)));
		double scale = enlarged*hypot(span->d, span->h)/most;

		hawser__panels_open(&of.figure, &of.at, k, &of.frame);
		title(of.figure.out.script, modes, k);
		put_span(&of, k, 0.0, 0.0);
		hawser__figure_draw(&of.figure, NULL, "with lines lt 7 lw 0.8 dt (8,6)");
		if (modes->gyroscopic)
			draw_moments(&of, k, scale);
		else
			draw_displaced(&of, k, scale);
	}
	return hawser__figure_finish(&of.figure, report);
}
