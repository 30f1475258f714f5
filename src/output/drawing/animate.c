/* output/drawing/animate.c - see animate.h: one gnuplot script with a plot for each frame.
 *
 * A motion in a plane is drawn over its coordinates; in space it is seen in perspective, with a bar of
 * a round length instead of tics. SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>
#include <strings.h>

#include "core/report.h"
#include "output/drawing/animate.h"
#include "output/drawing/labels.h"
#include "output/output.h"
#include "output/drawing/perspective.h"
#include "output/drawing/picture_choice.h"

#define WIDTH 16.0   /* cm */
#define HEIGHT 12.0  /* cm */
#define PER_CM 40.0  /* pixels: 640 x 480 */
#define LEFT 0.12    /* panel, over the width or height */
#define RIGHT 0.96   /* the same: room for half a number */
#define BOTTOM 0.12  /* of the height: tics and the axis's title */
#define TOP 0.90     /* of the height: the time is above */
#define SHORTEST 5.0 /* s, of playing: less cannot be followed */
#define LONGEST 20.0 /* s: more is not waited for */
enum { WAVE_LINES = 3, WAVE_POINTS = 80 }; /* of the surface of the water: along x, over the width */
enum { LEAST_DELAY = 2 }; /* 1/100 s: browsers show shorter ones with 1/10 s */

enum hawser_status hawser__animate_check(const char *path, const char *command,
                                         struct hawser_report *report)
{
	size_t length = path ? strlen(path) : 0;

	if (!path)
		return HAWSER_OK;
	if (length < 5 || strcasecmp(path + length - 4, ".gif") != 0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, command, "--animate %s: an animation is a "
		                    "GIF, whose name must end in .gif", path);
	return hawser__picture_check_gif(path, report);
}

struct view {
	const struct hawser__animation *of;
	struct hawser__eye eye;
	struct hawser__box box, seen;
	int flat; /* 1: x and y are coordinates */
};

static void see(double to[2], const struct view *view, const double x[3])
{
	hawser__eye_see(to, &view->eye, x);
	for (int k = 0; k < 2 && view->flat; k++)
		to[k] += view->eye.middle[k];
}

static const double *place(const struct hawser__animation *of, int row, int point)
{
	return of->x[(long)row*of->points + point];
}

/* What has the mark and the trail. */
static const double *mark(const struct hawser__animation *of, int row)
{
	return of->mark ? of->mark[row] : place(of, row, of->points - 1);
}

/* A place on the surface of the water: point number i of a line along x; lines are over the width. */
static void wave(double x[3], const struct view *view, int line, int i, int row)
{
	static const double none[3];
	const double *origin = view->of->origin ? view->of->origin[row] : none;
	const struct hawser__box *box = &view->box;
	const struct hawser_water *water = view->of->water;

	x[0] = box->low[0] + (box->high[0] - box->low[0])*i/(WAVE_POINTS - 1);
	x[1] = water->surface - origin[1];
	x[2] = box->low[2] + (box->high[2] - box->low[2])*line/(WAVE_LINES - 1);
	if (water->waves.count)
		x[1] += hawser_waves_elevation(&water->waves, (const double[3]){x[0] + origin[0], 0.0,
		                               x[2] + origin[2]}, view->of->time[row]);
}

/* Lines of the obstacles: into the script or, if it is NULL, into the box of what is seen. */
static void obstacles(FILE *script, struct view *view)
{
	struct hawser__pen pen = {NULL, script, &view->seen, &view->eye, {0.0, 0.0}};

	for (int k = 0; k < 2 && view->flat; k++)
		pen.shift[k] = view->eye.middle[k];
	for (int i = 0; i < view->of->surfaces; i++)
		hawser__pen_surface(&pen, &view->of->surface[i], &view->box);
}

static void look(struct view *view)
{
	const struct hawser__animation *of = view->of;
	long all = (long)of->rows*of->points;
	double to[2];

	for (long i = 0; i < all; i++)
		hawser__box_add(&view->box, of->x[i], 3);
	hawser__eye_look(&view->eye, &view->box, HAWSER__IN_SPACE, NULL);
	view->flat = view->eye.elevation == 0.0;
	for (long i = 0; i < all; i++) {
		see(to, view, of->x[i]);
		hawser__box_add(&view->seen, to, 2);
	}
	obstacles(NULL, view);
	for (int i = 0; i < 8 && of->water; i++) { /* corners of what the waves fill */
		const double rise = fmax(0.5*of->water->given.height, of->water->given.Hs);
		const double level = of->water->surface - (of->origin ? of->origin[0][1] : 0.0);
		const double x[3] = {(i & 1 ? view->box.high : view->box.low)[0],
		                     level + (i & 2 ? rise : -rise),
		                     (i & 4 ? view->box.high : view->box.low)[2]};

		see(to, view, x);
		hawser__box_add(&view->seen, to, 2);
	}
}

/* A bar of 1, 2 or 5 times a power of ten, below the panel, for what is seen in perspective. */
static void bar(FILE *script, const struct view *view)
{
	double wide = (view->seen.high[0] - view->seen.low[0])/(RIGHT - LEFT)/WIDTH;
	double tall = (view->seen.high[1] - view->seen.low[1])/(TOP - BOTTOM)/HEIGHT;
	double least = 2.0*fmax(wide, tall), end = view->seen.high[0], power, length; /* 2 cm or more */

	if (!(least > 0.0))
		return;
	power = pow(10.0, floor(log10(least)));
	length = least <= power ? power : least <= 2.0*power ? 2.0*power
	         : least <= 5.0*power ? 5.0*power : 10.0*power;
	fprintf(script, "set arrow 900 from %.9g, screen 0.06 to %.9g, screen 0.06 heads size screen "
	        "0.004,90 lw 1.5 lc rgb '#404040'\nset label 900 '%g m' at %.9g, screen 0.035 center\n",
	        end - length, end, length, end - 0.5*length);
}

static void put(FILE *script, const struct view *view, const double x[3])
{
	double to[2];

	see(to, view, x);
	fprintf(script, "%.6g %.6g\n", to[0], to[1]);
}

/* The line, or the elements of a net, those that follow each other as one line; supports. */
static void shape(FILE *script, const struct view *view, int row)
{
	const struct hawser__animation *of = view->of;

	fputs("$line << END\n", script);
	for (int i = 0; i < of->points && !of->end; i++)
		put(script, view, place(of, row, i));
	for (int e = 0; e < of->elements; e++) {
		if (e == 0 || of->end[e][0] != of->end[e - 1][1]) {
			fputs(e > 0 ? "\n" : "", script);
			put(script, view, place(of, row, of->end[e][0]));
		}
		put(script, view, place(of, row, of->end[e][1]));
	}
	fputs("END\n", script);
	if (!of->helds)
		return;
	fputs("$supports << END\n", script);
	for (int i = 0; i < of->helds; i++)
		put(script, view, place(of, row, of->held[i]));
	fputs("END\n", script);
}

static void water(FILE *script, const struct view *view, int row)
{
	fputs("$water << END\n", script);
	for (int line = 0; line < WAVE_LINES; line++) {
		for (int i = 0; i < WAVE_POINTS; i++) {
			double x[3];

			wave(x, view, line, i, row);
			put(script, view, x);
		}
		fputs("\n", script);
	}
	fputs("END\n", script);
}

static void frame(FILE *script, const struct view *view, int row, int digits)
{
	const struct hawser__animation *of = view->of;
	double to[2] = {0.0};

	shape(script, view, row);
	if (of->water)
		water(script, view, row);
	see(to, view, mark(of, row));
	fprintf(script, "set label 901 '{/:Italic t} = %.*f s%s%s' at screen 0.5, screen 0.955 "
	        "center\n", digits, of->time[row], of->note ? ", " : "", of->note ? of->note : "");
	fprintf(script, "plot %s%s$trail every ::0::%d using 1:2 with lines lc rgb '#c0c0c0' lw 1, "
	        "$line using 1:2 with lines lt 1 lw 2, %s'+' using (%.6g):(%.6g) every ::0::0 with points "
	        "pt 7 ps 1 lc rgb '#D55E00'\n", of->water
	        ? "$water using 1:2 with lines lw 1 lc rgb '#56B4E9', " : "", of->surfaces
	        ? "$obstacles using 1:2 with lines lw 2 lc rgb '#999999', " : "", row, of->helds
	        ? "$supports using 1:2 with points pt 9 ps 1.2 lc rgb 'black', " : "", to[0], to[1]);
}

static int row_of(const struct hawser__animation *of, int index, int frames)
{
	return frames > 1 ? (int)floor((double)index*(of->rows - 1)/(frames - 1) + 0.5) : 0;
}

static void axes(FILE *script, const struct view *view)
{
	struct hawser__corner corner = {1.0, 0.8, WIDTH, HEIGHT};

	hawser__eye_fit(script, &view->seen, (RIGHT - LEFT)*WIDTH, (TOP - BOTTOM)*HEIGHT);
	if (view->flat) {
		fputs("set xlabel '{/:Italic x} (m)'\nset ylabel '{/:Italic y} (m)'\n", script);
		return;
	}
	fputs("unset border\nunset xtics\nunset ytics\nunset grid\n", script);
	hawser__eye_axes(script, &view->eye, &corner);
	bar(script, view);
}

enum hawser_status hawser__animate(const char *path, const struct hawser__animation *of,
                                   struct hawser_report *report)
{
	struct view view = {.of = of};
	struct hawser__picture picture;
	int most = of->frames > 0 ? of->frames : HAWSER__ANIMATE_FRAMES, digits;
	int frames = of->rows < most ? of->rows : most;
	double all = of->time[of->rows - 1] - of->time[0], play, each, size[2];
	enum hawser_status status = hawser__picture_begin(&picture, path, WIDTH, HEIGHT, report);

	if (status)
		return status;
	each = all/(frames > 1 ? frames - 1 : 1);
	play = fmin(fmax(all, SHORTEST), LONGEST);
	digits = each > 0.0 ? (int)fmin(fmax(ceil(-log10(each) + 0.3), 0.0), 9.0) : 3;
	look(&view);
	hawser__picture_size(size, WIDTH, HEIGHT);
	/* without multiplot each plot is a frame */
	fprintf(picture.script, "unset multiplot\nset terminal gif animate delay %d optimize size "
	        "%.0f,%.0f enhanced font 'Sans,10' background '#ffffff' linewidth 1.5\n",
	        (int)fmax(100.0*play/frames + 0.5, LEAST_DELAY), size[0]*PER_CM, size[1]*PER_CM);
	hawser__picture_panel(&picture, LEFT, RIGHT, BOTTOM, TOP);
	axes(picture.script, &view);
	fputs("$trail << END\n", picture.script);
	for (int row = 0; row < of->rows; row++)
		put(picture.script, &view, mark(of, row));
	fputs("END\n", picture.script);
	if (of->surfaces) {
		fputs("$obstacles << END\n", picture.script);
		obstacles(picture.script, &view);
		fputs("END\n", picture.script);
	}
	for (int i = 0; i < frames; i++)
		frame(picture.script, &view, row_of(of, i, frames), digits);
	return hawser__picture_finish(&picture, report);
}
