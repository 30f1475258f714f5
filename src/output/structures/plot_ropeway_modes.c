/* output/structures/plot_ropeway_modes.c - see plot_ropeway_modes.h. A motion in the plane is
 * drawn along the line and across it as the page shows the line, since heights and distances
 * have different scales; one out of the plane is drawn upwards. A complex shape is turned such
 * that it is largest at t = 0, and drawn then and a quarter of a period later, when a standing
 * wave would be straight. SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <complex.h>
#include <math.h>
#include <string.h>

#include "output/drawing/panels.h"
#include "output/structures/plot_ropeway_modes.h"
#include "output/drawing/style.h"

#define WIDTH 22.0       /* cm: as the pictures of the statics of ropeways */
#define LEFT_CM 2.8      /* of the first panel: tic labels and the title of the axis */
#define RIGHT_CM 0.35    /* of the last panel: half of its last tic label */
#define GAP_CM 0.6       /* between two columns */
#define PANEL_CM 3.5     /* height of a panel: with half of the width, a line of a common slope */
#define TITLE_CM 0.95    /* above a panel */
#define FOOT_CM 2.7      /* tics, axis title, legend */
#define LARGEST_CM 0.75  /* largest displacement on the page */
enum { PER_PIECE = 48, ALONE = 3 }; /* points of a piece; up to so many modes have the whole width */

static const char *const colour[] = {"#0072B2", "#D55E00"};
static const char *const faint[] = {"#8fc1e0", "#f0b48a"};
/* Of the points of contact, by enum hawser_line_contact_kind: open, closed, with a hub. */
static const char *const mark[] = {"pt 6 ps 0.6", "pt 5 ps 0.5", "pt 2 ps 0.6"};
static const char *const said[] = {"the rope slips", "the rope sticks", "the sheaves roll"};

struct frame {
	const struct hawser__ropeway_modes_picture *of;
	struct hawser__axis x, y;
	double from[2], to[2]; /* m */
	double per[2];         /* m of distance and of height per cm */
	int panels, columns, rows;
	double height, wide;   /* cm: of the picture, of a panel */
};

static double complex component(const double *shape, int parts, int c)
{
	return parts > 1 ? shape[c] + I*shape[3 + c] : shape[c];
}

/* Displacement of the point S of a lane along the page, in both directions. */
static void displacement(double complex u[2], const struct frame *frame, int k, int lane, double S)
{
	const struct hawser_line_modes *modes = frame->of->modes;
	double shape[6], angle;
	int parts = modes->gyroscopic ? 2 : 1;

	hawser_line_at(modes->lane[lane], NULL, &angle, NULL, NULL, NULL, S);
	angle = atan2(sin(angle)/frame->per[1], cos(angle)/frame->per[0]);
	hawser_line_modes_at(shape, NULL, modes, k, lane, S/modes->length_unit);
	u[0] = component(shape, parts, 0)*cos(angle) - component(shape, parts, 1)*sin(angle);
	u[1] = component(shape, parts, 0)*sin(angle) + component(shape, parts, 1)*cos(angle);
	if (modes->mode[k].plane == HAWSER_OUT_OF_PLANE) {
		u[0] = 0.0;
		u[1] = component(shape, parts, 2);
	}
}

static double S_of(const struct hawser_line_piece *piece, int i)
{
	return piece->S0 + (piece->S1 - piece->S0)*i/PER_PIECE;
}

/* The largest displacement of mode k, as a complex number. */
static double complex largest_of(const struct frame *frame, int k)
{
	double complex most = 0.0, u[2];

	for (int lane = 0; lane < frame->of->modes->lanes; lane++) {
		const struct hawser_line_statics *line = frame->of->modes->lane[lane];

		for (int p = 0; p < line->pieces; p++)
			for (int i = 0; i <= PER_PIECE; i++) {
				displacement(u, frame, k, lane, S_of(&line->piece[p], i));
				for (int c = 0; c < 2; c++)
					if (cabs(u[c]) > cabs(most))
						most = u[c];
			}
	}
	return most;
}

/* Columns: the place at rest, at t = 0 and a quarter of a period later. */
static void place(FILE *script, const struct frame *frame, int k, int lane, double S,
                  double complex scale)
{
	double x[2];
	double complex u[2];

	hawser_line_at(frame->of->modes->lane[lane], x, NULL, NULL, NULL, NULL, S);
	displacement(u, frame, k, lane, S);
	for (int c = 0; c < 2; c++)
		u[c] *= scale;
	u[0] *= frame->per[0];
	u[1] *= frame->per[1];
	fprintf(script, "%.8g %.8g %.8g %.8g %.8g %.8g\n", x[0]/frame->x.per, x[1]/frame->y.per,
	        (x[0] + creal(u[0]))/frame->x.per, (x[1] + creal(u[1]))/frame->y.per,
	        (x[0] - cimag(u[0]))/frame->x.per, (x[1] - cimag(u[1]))/frame->y.per);
}

static void data(FILE *script, const struct frame *frame, int k)
{
	const struct hawser_line_modes *modes = frame->of->modes;
	double complex most = largest_of(frame, k), scale = LARGEST_CM/most;

	if (!modes->gyroscopic)
		scale = LARGEST_CM/cabs(most);
	for (int lane = 0; lane < modes->lanes; lane++) {
		const struct hawser_line_statics *line = modes->lane[lane];

		fprintf(script, "$rope%d_%d << END\n", k, lane);
		for (int p = 0; p < line->pieces; p++)
			for (int i = 0; i < PER_PIECE + (p + 1 == line->pieces); i++)
				place(script, frame, k, lane, S_of(&line->piece[p], i), scale);
		fprintf(script, "END\n$carriers%d_%d << END\nNaN NaN NaN NaN NaN NaN\n", k, lane);
		for (int i = 0; i < frame->of->carriers[lane]; i++)
			place(script, frame, k, lane, line->line->mass[i].S, scale);
		fputs("END\n", script);
	}
}

static void tower_data(FILE *script, const struct frame *frame)
{
	const struct hawser__ropeway_modes_picture *of = frame->of;

	fputs("$towers << END\nNaN NaN NaN\n", script);
	for (int i = 0; i < of->towers; i++)
		fprintf(script, "%.8g %.8g %.8g\n", of->tower[i][0]/frame->x.per,
		        of->tower[i][1]/frame->y.per,
		        of->posts ? (frame->from[1] - of->tower[i][1])/frame->y.per : 0.0);
	fprintf(script, "END\n$stations << END\n%.8g %.8g\n%.8g %.8g\nEND\n",
	        of->end[0][0]/frame->x.per, of->end[0][1]/frame->y.per, of->end[1][0]/frame->x.per,
	        of->end[1][1]/frame->y.per);
}

static void title(FILE *script, const struct frame *frame, int k)
{
	const struct hawser__ropeway_modes_picture *of = frame->of;
	const struct hawser_mode *mode = &of->modes->mode[k];
	const double *share = of->share + (size_t)k*(size_t)of->spans;
	const char *what = mode->family == HAWSER_LONGITUDINAL ? "longitudinal"
	                                                       : hawser_plane_name(mode->plane);
	int most = 0, lanes = of->modes->lanes;
	char text[160];

	for (int i = 0; i < of->spans; i++)
		most = share[i] > share[most] ? i : most;
	snprintf(text, sizeof text, "%s,  %.0f %% in %.70s%s", what, 100.0*share[most], of->name[most],
	         lanes == 1 ? "" : most >= of->spans/lanes ? ", down" : ", up");
	hawser__panels_frequency(script, k, mode->omega/of->modes->time_unit, text);
}

static void draw(FILE *script, const struct frame *frame, int k)
{
	const struct hawser_line_modes *modes = frame->of->modes;

	fputs("plot $towers using 1:2:(0):3 with vectors nohead lc rgb '#b0b0b0' lw 1.2", script);
	for (int i = modes->lanes - 1; i >= 0; i--)
		fprintf(script, ", $rope%d_%d using 1:2 with lines lc rgb '#808080' lw 0.7", k, i);
	for (int i = modes->lanes - 1; i >= 0 && modes->gyroscopic; i--)
		fprintf(script, ", $rope%d_%d using 5:6 with lines lc rgb '%s' lw 1.0", k, i, faint[i]);
	for (int i = modes->lanes - 1; i >= 0; i--)
		fprintf(script, ", $rope%d_%d using 3:4 with lines lc rgb '%s' lw 1.5, "
		        "$carriers%d_%d using 3:4 with points pt %d ps 0.4 lc rgb '%s'", k, i, colour[i], k, i,
		        i ? 6 : 7, colour[i]);
	fprintf(script, ", $towers using 1:2 with points %s lc rgb 'black'"
	        ", $stations using 1:2 with points pt 5 ps 0.7 lc rgb 'black'\n", mark[modes->contact]);
}

static struct hawser__legend legend(const struct frame *frame)
{
	const struct hawser_line_modes *modes = frame->of->modes;
	struct hawser__legend entries = {0};
	char text[64];

	for (int i = 0; i < modes->lanes; i++)
		hawser__legend_add(&entries, modes->lanes == 1 ? "mode" : i ? "lane down" : "lane up",
		                   "with lines lc rgb '%s' lw 1.5", colour[i]);
	for (int i = 0; i < modes->lanes && modes->gyroscopic; i++)
		hawser__legend_add(&entries, modes->lanes == 1 ? "a quarter period later"
		                   : i ? "down, a quarter period later" : "up, a quarter period later",
		                   "with lines lc rgb '%s' lw 1.0", faint[i]);
	hawser__legend_add(&entries, "equilibrium", "with lines lc rgb '#808080' lw 0.7");
	for (int i = 0; i < modes->lanes; i++)
		if (frame->of->carriers[i] > 0)
			hawser__legend_add(&entries, i ? "carriers down" : "carriers up",
			                   "with points pt %d ps 0.4 lc rgb '%s'", i ? 6 : 7, colour[i]);
	if (frame->of->towers > 0) {
		snprintf(text, sizeof text, "%s: %s", frame->of->what, said[modes->contact]);
		hawser__legend_add(&entries, text, "with points %s lc rgb 'black'", mark[modes->contact]);
	}
	return entries;
}

static void measure(struct frame *frame)
{
	const struct hawser__ropeway_modes_picture *of = frame->of;
	int n = frame->of->modes->n;
	double tall, room = PANEL_CM - 2.0*LARGEST_CM - 0.4; /* cm, for the line at rest */

	frame->panels = n < HAWSER__PANELS ? n : HAWSER__PANELS;
	frame->columns = n <= ALONE ? 1 : 2;
	frame->rows = (frame->panels + frame->columns - 1)/frame->columns;
	frame->wide = (WIDTH - LEFT_CM - RIGHT_CM - (frame->columns - 1)*GAP_CM)/frame->columns;
	for (int c = 0; c < 2; c++) {
		frame->from[c] = fmin(of->end[0][c], of->end[1][c]);
		frame->to[c] = fmax(of->end[0][c], of->end[1][c]);
	}
	for (int lane = 0; lane < of->modes->lanes; lane++)
		for (int i = 0; i < PER_PIECE*of->modes->lane[lane]->pieces; i++) {
			const struct hawser_line_statics *line = of->modes->lane[lane];
			double x[2];

			hawser_line_at(line, x, NULL, NULL, NULL, NULL,
			               S_of(&line->piece[i/PER_PIECE], i % PER_PIECE));
			frame->from[1] = fmin(frame->from[1], x[1]);
			frame->to[1] = fmax(frame->to[1], x[1]);
		}
	/* not less than a twentieth of the length, so that a level line does not fill the panel */
	tall = fmax(frame->to[1] - frame->from[1], 0.05*(frame->to[0] - frame->from[0]));
	frame->per[1] = tall/room;
	frame->from[1] -= (LARGEST_CM + 0.2)*frame->per[1];
	frame->to[1] = frame->from[1] + PANEL_CM*frame->per[1];
	tall = 0.02*(frame->to[0] - frame->from[0]);
	frame->from[0] -= tall;
	frame->to[0] += tall;
	frame->per[0] = (frame->to[0] - frame->from[0])/frame->wide;
	frame->x = hawser__axis_of("Distance {/:Italic x}", "m", 0.0);
	frame->y = hawser__axis_of("Height {/:Italic y}, displacement enlarged", "m", 0.0);
}

static void panel(struct hawser__picture *picture, const struct frame *frame, int k)
{
	int column = k % frame->columns, last = k + frame->columns >= frame->panels;
	int row = k/frame->columns;
	double left = LEFT_CM + column*(frame->wide + GAP_CM);
	double top = frame->height - TITLE_CM - row*(PANEL_CM + TITLE_CM);

	fprintf(picture->script, "set format x '%s'\nset format y '%s'\n", last ? "%g" : "",
	        column == 0 ? "%g" : "");
	if (last)
		fprintf(picture->script, "set xlabel '%s' offset 0,0.4\n", frame->x.title);
	else
		fputs("unset xlabel\n", picture->script);
	hawser__picture_panel(picture, left/WIDTH, (left + frame->wide)/WIDTH,
	                      (top - PANEL_CM)/frame->height, top/frame->height);
	fputs("unset label\n", picture->script);
	if (k == 0) {
		picture->middle = 0.5*(frame->height - TITLE_CM + FOOT_CM)/frame->height;
		hawser__picture_ylabel(picture, "%s", frame->y.title);
	}
}

enum hawser_status hawser__plot_ropeway_modes(const char *path,
                                              const struct hawser__ropeway_modes_picture *of,
                                              struct hawser_report *report)
{
	struct frame frame = {.of = of};
	struct hawser__legend entries;
	struct hawser__picture picture;
	enum hawser_status status;
	double foot;

	measure(&frame);
	entries = legend(&frame);
	foot = fmax(FOOT_CM, hawser__legend_cm(&entries, WIDTH));
	frame.height = foot + frame.rows*(PANEL_CM + TITLE_CM);
	status = hawser__picture_begin(&picture, path, WIDTH, frame.height, report);
	if (status)
		return status;
	for (int k = 0; k < frame.panels; k++)
		data(picture.script, &frame, k);
	tower_data(picture.script, &frame);
	fprintf(picture.script, "set xrange [%.8g:%.8g]\nset yrange [%.8g:%.8g]\n",
	        frame.from[0]/frame.x.per, frame.to[0]/frame.x.per, frame.from[1]/frame.y.per,
	        frame.to[1]/frame.y.per);
	hawser__picture_tics(&picture, 'x', frame.from[0]/frame.x.per, frame.to[0]/frame.x.per,
	                     frame.columns > 1 ? 6 : 10);
	hawser__picture_tics(&picture, 'y', frame.from[1]/frame.y.per, frame.to[1]/frame.y.per, 5);
	for (int k = 0; k < frame.panels; k++) {
		panel(&picture, &frame, k);
		title(picture.script, &frame, k);
		draw(picture.script, &frame, k);
	}
	hawser__legend_draw(&picture, &entries);
	return hawser__picture_finish(&picture, report);
}
