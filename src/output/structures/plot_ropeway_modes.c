/* output/structures/plot_ropeway_modes.c - see structures.h. A motion in the plane is
 * drawn along the line and across it as the page shows the line, since heights and distances
 * have different scales; one out of the plane is drawn upwards. A complex shape is turned such
 * that it is largest at t = 0, and drawn then and a quarter of a period later, when a standing
 * wave would be straight. SPDX-License-Identifier: GPL-3.0-or-later */
#include <complex.h>
#include <math.h>
#include <string.h>

#include "output/drawing/figure.h"
#include "output/structures/structures.h"

#define WIDTH 22.0       /* cm: as the pictures of the statics of ropeways */
#define LEFT_CM 2.8      /* of the first panel: tic labels and the title of the axis */
#define RIGHT_CM 0.35    /* of the last panel: half of its last tic label */
#define GAP_CM 0.6       /* between two columns */
#define PANEL_CM 3.5     /* height of a panel: with half of the width, a line of a common slope */
#define TITLE_CM 0.95    /* above a panel */
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
	double wide;           /* cm, of a panel */
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

/* The place of a point, displaced by the real part of scale times the shape. */
static void put_place(struct hawser__figure *figure, const struct frame *frame, int k, int lane,
                      double S,
                      double complex scale)
{
	double complex u[2];
	double x[2];

	hawser_line_at(frame->of->modes->lane[lane], x, NULL, NULL, NULL, NULL, S);
	displacement(u, frame, k, lane, S);
	hawser__figure_put(figure, x[0] + creal(u[0]*scale)*frame->per[0],
	                   x[1] + creal(u[1]*scale)*frame->per[1]);
}

static void put_rope(struct hawser__figure *figure, const struct frame *frame, int k, int lane,
                     double complex scale)
{
	const struct hawser_line_statics *line = frame->of->modes->lane[lane];

	for (int p = 0; p < line->pieces; p++)
		for (int i = 0; i < PER_PIECE + (p + 1 == line->pieces); i++)
			put_place(figure, frame, k, lane, S_of(&line->piece[p], i), scale);
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

static void draw_towers(struct hawser__figure *figure, const struct frame *frame)
{
	const struct hawser__ropeway_modes_picture *of = frame->of;

	for (int i = 0; i < of->towers; i++)
		hawser__figure_row(figure, "xyXY", (double[]){of->tower[i][0], of->tower[i][1], 0.0,
		                   of->posts ? frame->from[1] - of->tower[i][1] : 0.0});
	hawser__figure_draw(figure, NULL, "using 1:2:3:4 with vectors nohead lc rgb '#b0b0b0' lw 1.2");
}

static void draw_places(struct hawser__figure *figure, const struct frame *frame)
{
	const struct hawser__ropeway_modes_picture *of = frame->of;
	char text[64];

	snprintf(text, sizeof text, "%s: %s", of->what, said[of->modes->contact]);
	for (int i = 0; i < of->towers; i++)
		hawser__figure_put(figure, of->tower[i][0], of->tower[i][1]);
	hawser__figure_draw(figure, text, "with points %s lc rgb 'black'", mark[of->modes->contact]);
	for (int i = 0; i < 2; i++)
		hawser__figure_put(figure, of->end[i][0], of->end[i][1]);
	hawser__figure_draw(figure, NULL, "with points pt 5 ps 0.7 lc rgb 'black'");
}

static void draw_mode(struct hawser__figure *figure, const struct frame *frame, int k)
{
	const struct hawser_line_modes *modes = frame->of->modes;
	double complex most = largest_of(frame, k), scale = LARGEST_CM/(modes->gyroscopic ? most
	                                                                : cabs(most));

	draw_towers(figure, frame);
	for (int i = modes->lanes - 1; i >= 0; i--) {
		put_rope(figure, frame, k, i, 0.0);
		hawser__figure_draw(figure, NULL, "with lines lc rgb '#808080' lw 0.7");
	}
	for (int i = modes->lanes - 1; i >= 0 && modes->gyroscopic; i--) {
		put_rope(figure, frame, k, i, I*scale); /* a quarter of a period later */
		hawser__figure_draw(figure, NULL, "with lines lc rgb '%s' lw 1.0", faint[i]);
	}
	for (int i = modes->lanes - 1; i >= 0; i--) {
		put_rope(figure, frame, k, i, scale);
		hawser__figure_draw(figure, NULL, "with lines lc rgb '%s' lw 1.5", colour[i]);
		for (int c = 0; c < frame->of->carriers[i]; c++)
			put_place(figure, frame, k, i, modes->lane[i]->line->mass[c].S, scale);
		hawser__figure_draw(figure, NULL,
		                    "with points pt %d ps 0.4 lc rgb '%s'", i ? 6 : 7, colour[i]);
	}
	draw_places(figure, frame);
}

/* Entries that precede those of what is drawn. */
static void add_entries(struct hawser__legend *legend, const struct hawser_line_modes *modes,
                        const int *carriers /* [modes->lanes] */)
{
	for (int i = 0; i < modes->lanes; i++)
		hawser__legend_add(legend, modes->lanes == 1 ? "mode" : i ? "lane down" : "lane up",
		                   "with lines lc rgb '%s' lw 1.5", colour[i]);
	for (int i = 0; i < modes->lanes && modes->gyroscopic; i++)
		hawser__legend_add(legend, modes->lanes == 1 ? "a quarter period later"
		                   : i ? "down, a quarter period later" : "up, a quarter period later",
		                   "with lines lc rgb '%s' lw 1.0", faint[i]);
	for (int i = 0; i < modes->lanes; i++)
		if (carriers[i] > 0)
			hawser__legend_add(legend, i ? "carriers down" : "carriers up",
			                   "with points pt %d ps 0.4 lc rgb '%s'", i ? 6 : 7, colour[i]);
	hawser__legend_once(legend, "equilibrium", "with lines lc rgb '#808080' lw 0.7");
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

enum hawser_status hawser__plot_ropeway_modes(const char *path,
                                              const struct hawser__ropeway_modes_picture *of,
                                              struct hawser_report *report)
{
	struct frame frame = {.of = of};
	struct hawser__figure figure = {0};
	double foot = HAWSER__LEGEND_CM, height;
	enum hawser_status status;

	measure(&frame);
	height = foot + frame.rows*(PANEL_CM + TITLE_CM);
	status = hawser__figure_begin(&figure, path, WIDTH, height, report);
	if (status)
		return status;
	add_entries(&figure.legend, of->modes, of->carriers);
	for (int k = 0; k < frame.panels; k++) {
		int column = k % frame.columns, row = k/frame.columns;
		double left = LEFT_CM + column*(frame.wide + GAP_CM);
		double top = height - TITLE_CM - row*(PANEL_CM + TITLE_CM);

		hawser__figure_panel(&figure, &(struct hawser__panel_frame){left/WIDTH,
			(left + frame.wide)/WIDTH,
			(top - PANEL_CM)/height, top/height,
			.x = {&frame.x, frame.from[0], frame.to[0], .tics = frame.columns > 1 ? 6 : 10,
			      .bare = k + frame.columns < frame.panels},
			.y = {&frame.y, frame.from[1], frame.to[1], .tics = 5, .bare = column > 0,
			      .untitled = k > 0}});
		figure.out.middle = 0.5*(height - TITLE_CM + foot)/height;
		title(figure.out.script, &frame, k);
		draw_mode(&figure, &frame, k);
	}
	return hawser__figure_finish(&figure, report);
}
