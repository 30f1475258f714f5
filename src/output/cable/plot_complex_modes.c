/* output/cable/plot_complex_modes.c - modes of a travelling cable, one panel per mode: real and
 * imaginary parts; their downstream and upstream waves; the displaced span during half a period.
 *
 * A motion is the real part of (shape) exp(i omega t): the real part is the shape at t = 0, the
 * imaginary part the shape a quarter of a period earlier.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>

#include "output/output.h"
#include "output/drawing/panels.h"
#include "output/drawing/style.h"

enum { samples = 161, moments = 4 };
static const double enlarged = 0.08; /* of the chord: largest displacement drawn */
static const char *const fading[moments] = {"#08306b", "#2f7ebc", "#7fb8dc", "#c3d9ee"};

static double largest_of(const struct hawser_modes *modes, int k, int c)
{
	double largest = 0.0, shape[6];

	for (int i = 0; i < samples; i++) {
		hawser_modes_at(modes, shape, NULL, k, modes->statics.l*i/(samples - 1));
		largest = fmax(largest, hypot(shape[c], shape[3 + c]));
	}
	return largest;
}

static int leading(const struct hawser_mode *mode)
{
	if (mode->plane == HAWSER_OUT_OF_PLANE)
		return 2;
	return mode->axial_share > mode->normal_share ? 0 : 1;
}

/* Actual unstretched arclength. */
static double abscissa(const struct hawser_modes *modes, const struct hawser__axis *S, double s)
{
	return s*modes->statics.span.d*(1.0 - modes->statics.motion.mach2)/S->per;
}

static double extent(const struct hawser_modes *modes, int panels)
{
	double largest = 0.0;

	for (int k = 0; k < panels; k++)
		for (int c = 0; c < 3; c++)
			largest = fmax(largest, largest_of(modes, k, c));
	return 1.12*largest;
}

static void title(FILE *script, const struct hawser_modes *modes, int k)
{
	const struct hawser_mode *mode = &modes->mode[k];

	hawser__panels_frequency(script, k, mode->omega/modes->time_unit, leading(mode) == 0
	                         ? "longitudinal" : hawser_plane_name(mode->plane));
}

static enum hawser_status begin(struct hawser__picture *picture, struct hawser__panels *at,
                                const char *path, const struct hawser_modes *modes,
                                struct hawser_report *report)
{
	*at = hawser__panels_arrange(modes->n);
	return hawser__picture_begin(picture, path, 17.0, at->height, report);
}

/* Ranges of shapes over the arclength, common to all panels. */
static void axes(struct hawser__picture *picture, const struct hawser__panels *at,
                 const struct hawser_modes *modes, const struct hawser__axis *S)
{
	double end = abscissa(modes, S, modes->statics.l), range = extent(modes, at->panels);

	fprintf(picture->script,
	        "set xrange [0:%.9g]\nset yrange [%.4g:%.4g]\nset xzeroaxis lt 7 lw 0.4\n",
	        end, -range, range);
	hawser__picture_tics(picture, 'x', 0.0, end, at->columns > 2 ? 4 : 6);
}

static void moments_legend(struct hawser__legend *legend)
{
	static const char *const name[moments] = {"{/:Italic t} = 0", "1/8", "2/8", "3/8 period"};

	for (int m = 0; m < moments; m++)
		hawser__legend_add(legend, name[m], "with lines lc rgb '%s'", fading[m]);
}

/* --- real and imaginary parts --- */

static void component(FILE *script, int k, int c, double times)
{
	fprintf(script,
	        "$mode%d using 1:($%d*%g) with lines lt %d, $mode%d using 1:($%d*%g) with lines lt %d "
	                "dt (4,4)", k, c + 2, times, c == 0 ? 2 : c == 1 ? 1 : 3, k, c + 5, times,
	        c == 0 ? 2 : c == 1 ? 1 : 3);
}

static void components(FILE *script, const struct hawser_modes *modes, int k)
{
	double P = largest_of(modes, k, 0), Q = largest_of(modes, k, 1);
	double timesP = hawser__panels_magnify(P, Q), timesQ = hawser__panels_magnify(Q, P);

	fputs("unset label 1\n", script);
	if (modes->mode[k].plane == HAWSER_OUT_OF_PLANE) {
		fputs("plot ", script);
		component(script, k, 2, 1.0);
		fputs("\n", script);
		return;
	}
	if (timesP > 1.0 || timesQ > 1.0)
		fprintf(script, "set label 1 '{/:Italic %s} × %g' at graph 0.03, graph 0.08 left "
		                "tc lt %d\n", timesP > 1.0 ? "P" : "Q", fmax(timesP, timesQ),
		        timesP > 1.0 ? 2 : 1);
	fputs("plot ", script);
	component(script, k, 0, timesP);
	fputs(", ", script);
	component(script, k, 1, timesQ);
	fputs("\n", script);
}

enum hawser_status hawser__plot_complex_modes(const char *path,
                                              const struct hawser_modes *modes,
                                              const struct hawser__axis *S,
                                              struct hawser_report *report)
{
	struct hawser__picture picture;
	struct hawser__legend entries = {0};
	struct hawser__panels at;
	enum hawser_status status = begin(&picture, &at, path, modes, report);
	FILE *script = picture.script;

	if (status)
		return status;
	for (int k = 0; k < at.panels; k++) {
		fprintf(script, "$mode%d << END\n", k);
		for (int i = 0; i < samples; i++) {
			double s = modes->statics.l*i/(samples - 1), x[6];

			hawser_modes_at(modes, x, NULL, k, s);
			fprintf(script, "%.9g %.9g %.9g %.9g %.9g %.9g %.9g\n", abscissa(modes, S, s), x[0],
			        x[1], x[2], x[3], x[4], x[5]);
		}
		fputs("END\n", script);
	}
	axes(&picture, &at, modes, S);
	for (int k = 0; k < at.panels; k++) {
		hawser__panels_open(&picture, &at, k, S->title, "Shape (–)");
		title(script, modes, k);
		components(script, modes, k);
	}
	hawser__legend_add(&entries, "axial {/:Italic P}", "with lines lt 2");
	hawser__legend_add(&entries, "normal {/:Italic Q}", "with lines lt 1");
	hawser__legend_add(&entries, "out of plane {/:Italic B}", "with lines lt 3");
	hawser__legend_add(&entries, "real", "with lines lt 7");
	hawser__legend_add(&entries, "imaginary part", "with lines lt 7 dt (4,4)");
	hawser__legend_draw(&picture, &entries);
	return hawser__picture_finish(&picture, report);
}

/* --- waves: the leading component at instants of half a period, with its two waves --- */

enum hawser_status hawser__plot_waves(const char *path, const struct hawser_modes *modes,
                                      const struct hawser__axis *S,
                                      struct hawser_report *report)
{
	struct hawser__picture picture;
	struct hawser__legend entries = {0};
	struct hawser__panels at;
	enum hawser_status status = begin(&picture, &at, path, modes, report);
	FILE *script = picture.script;

	if (status)
		return status;
	for (int k = 0; k < at.panels; k++) {
		int c = leading(&modes->mode[k]);

		fprintf(script, "$mode%d << END\n", k);
		for (int i = 0; i < samples; i++) {
			double s = modes->statics.l*i/(samples - 1), x[6], with[6], against[6];

			hawser_modes_at(modes, x, NULL, k, s);
			hawser_complex_modes_waves(modes, with, against, k, s);
			fprintf(script, "%.9g %.9g %.9g %.9g", abscissa(modes, S, s),
			        hypot(x[c], x[3 + c]), with[c], against[c]);
			for (int m = 0; m < moments; m++)
				fprintf(script, " %.9g", x[c]*cos(M_PI*m/moments) - x[3 + c]*sin(M_PI*m/moments));
			fputs("\n", script);
		}
		fputs("END\n", script);
	}
	axes(&picture, &at, modes, S);
	for (int k = 0; k < at.panels; k++) {
		hawser__panels_open(&picture, &at, k, S->title,
		                    "Leading component (–)");
		title(script, modes, k);
		fprintf(script, "plot $mode%d using 1:2 with lines lt 7 lw 0.7 dt (8,6), "
		                "$mode%d using 1:(-$2) with lines lt 7 lw 0.7 dt (8,6)", k, k);
		for (int m = moments - 1; m >= 0; m--)
			fprintf(script, ", $mode%d using 1:%d with lines lc rgb '%s'", k, 5 + m, fading[m]);
		fprintf(script, ", $mode%d using 1:3 with lines lt 3 lw 1.1 dt (4,4), "
		                "$mode%d using 1:4 with lines lt 2 lw 1.1 dt (4,4)\n", k, k);
	}
	moments_legend(&entries);
	hawser__legend_add(&entries, "envelope", "with lines lt 7 lw 0.7 dt (8,6)");
	hawser__legend_add(&entries, "downstream wave", "with lines lt 3 lw 1.1 dt (4,4)");
	hawser__legend_add(&entries, "upstream wave", "with lines lt 2 lw 1.1 dt (4,4)");
	hawser__legend_draw(&picture, &entries);
	return hawser__picture_finish(&picture, report);
}

/* --- the span at instants of half a period --- */

/* Columns: x and y (z out of plane) of the steady state, then of each instant. */
static void passing_data(FILE *script, const struct hawser_modes *modes, int k, double per)
{
	const struct hawser_statics *st = &modes->statics;
	double most = fmax(largest_of(modes, k, 0),
	                   fmax(largest_of(modes, k, 1), largest_of(modes, k, 2)));
	double scale = enlarged*hypot(st->span.d, st->span.h)/most;
	int out = modes->mode[k].plane == HAWSER_OUT_OF_PLANE;

	fprintf(script, "$mode%d << END\n", k);
	for (int i = 0; i < samples; i++) {
		double s = st->l*i/(samples - 1), shape[6];
		struct hawser_profile_point rest = hawser_statics_at(st, s*st->span.d);
		struct hawser_frame_point frame = hawser_statics_frame(st, s);

		hawser_modes_at(modes, shape, NULL, k, s);
		fprintf(script, "%.9g %.9g", rest.x/per, out ? 0.0 : rest.y/per);
		for (int m = 0; m < moments; m++) {
			double c = scale*cos(M_PI*m/moments), n = scale*sin(M_PI*m/moments);
			double P = c*shape[0] - n*shape[3], Q = c*shape[1] - n*shape[4];
			double B = c*shape[2] - n*shape[5];

			fprintf(script, " %.9g %.9g", (rest.x + (out ? 0.0 : P*frame.ex - Q*frame.ey))/per,
			        (out ? B : rest.y + P*frame.ey + Q*frame.ex)/per);
		}
		fputs("\n", script);
	}
	fputs("END\n", script);
}

static void heights(double *low, double *high, const struct hawser_statics *st, double per)
{
	double margin = 1.15*enlarged*hypot(st->span.d, st->span.h);

	*low = *high = 0.0;
	for (int i = 0; i < samples; i++) {
		double y = hawser_statics_at(st, st->length0*i/(samples - 1)).y;

		*low = fmin(*low, y);
		*high = fmax(*high, y);
	}
	*low = (*low - margin)/per;
	*high = (*high + margin)/per;
}

enum hawser_status hawser__plot_passing(const char *path, const struct hawser_modes *modes,
                                        struct hawser_report *report)
{
	const struct hawser_span *span = &modes->statics.span;
	struct hawser__picture picture;
	struct hawser__legend entries = {0};
	struct hawser__panels at;
	enum hawser_status status = begin(&picture, &at, path, modes, report);
	const struct hawser__axis x = hawser__axis_of("Distance {/:Italic x}", "m", 0.0);
	const struct hawser__axis y = hawser__axis_of("{/:Italic y} or {/:Italic z}", "m", 0.0);
	FILE *script = picture.script;
	double low, high;

	if (status)
		return status;
	for (int k = 0; k < at.panels; k++)
		passing_data(script, modes, k, x.per);
	heights(&low, &high, &modes->statics, y.per);
	fprintf(script, "set xrange [%.9g:%.9g]\nset yrange [%.9g:%.9g]\n", -0.03*span->d/x.per,
	        1.03*span->d/x.per, low, high);
	hawser__picture_tics(&picture, 'x', 0.0, span->d/x.per, at.columns > 2 ? 4 : 6);
	hawser__picture_tics(&picture, 'y', low, high, 5);
	for (int k = 0; k < at.panels; k++) {
		hawser__panels_open(&picture, &at, k, x.title, y.title);
		title(script, modes, k);
		fprintf(script, "plot $mode%d using 1:2 with lines lt 7 lw 0.8 dt (8,6)", k);
		for (int m = moments - 1; m >= 0; m--)
			fprintf(script, ", $mode%d using %d:%d with lines lc rgb '%s'", k, 3 + 2*m, 4 + 2*m,
			        fading[m]);
		fputs("\n", script);
	}
	hawser__legend_add(&entries, "steady state", "with lines lt 7 lw 0.8 dt (8,6)");
	moments_legend(&entries);
	hawser__legend_draw(&picture, &entries);
	return hawser__picture_finish(&picture, report);
}
