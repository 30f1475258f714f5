/* output/structures/plot_ropeway.c - see plot_ropeway.h. The arrows of the reactions have their
 * true direction on the page, and lengths in proportion to their force.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>

#include "output/structures/plot_ropeway.h"
#include "output/drawing/style.h"

#define WIDTH 22.0        /* cm */
#define LEFT 0.118        /* of the panels, as a part of the width */
#define RIGHT 0.985       /* the same of their right ends: room for the last number */
#define LINE_CM 8.0       /* height of the panel of the line: numbers on arrows do not meet */
#define OTHER_CM 4.2      /* height of the other panels: five tics */
#define GAP_CM 0.7        /* between panels */
#define ARROW_CM 1.7      /* length of the arrow of the largest reaction */
enum { NAMED = 30, PER_PIECE = 12 };

static const char *const colour[] = {"#0072B2", "#D55E00"};
static const char *const lane_title[] = {"lane up", "lane down"};

struct frame {
	const struct hawser_ropeway *rw;
	const struct hawser_ropeway_statics *st;
	const struct hawser_ropeway_worst *worst;
	struct hawser__axis x, y, T, R;
	double from[2], to[2], largest; /* of the panel of the line, m; N */
	double height;                  /* of the picture, cm */
};

static void widen(struct frame *frame, const double x[2])
{
	for (int k = 0; k < 2; k++) {
		frame->from[k] = fmin(frame->from[k], x[k]);
		frame->to[k] = fmax(frame->to[k], x[k]);
	}
}

/* Room for arrows and their numbers above and below, and for the names of towers: these have sizes
 * on the page, so that the scale and the range follow from each other. */
static void make_room(struct frame *frame)
{
	double low = frame->from[1], high = frame->to[1];
	double tall = fmax(high - low, 0.05*(frame->to[0] - frame->from[0])), per = tall/(0.6*LINE_CM);

	for (int n = 0; n < 20; n++) {
		double above = 0.3, below = 0.9 + frame->rw->hanger/per;

		for (int i = 0; i < frame->st->lanes*frame->rw->towers; i++) {
			int lane = i/frame->rw->towers, k = i%frame->rw->towers;
			double up = frame->st->lane[lane].contact[k].reaction[1]/frame->largest*ARROW_CM;
			double y = frame->rw->tower[k].at[1];

			above = fmax(above, up > 0.0 ? (y - high)/per + up + 0.95 : 0.0);
			below = fmax(below, up < 0.0 ? (low - y)/per - up + 1.5 : 0.0);
		}
		per = tall/fmax(LINE_CM - above - below, 0.3*LINE_CM);
		frame->from[1] = low - below*per;
		frame->to[1] = low + tall + above*per;
	}
}

static void measure(struct frame *frame)
{
	const struct hawser_ropeway_statics *st = frame->st;
	double most = 0.0;

	for (int k = 0; k < 2; k++) {
		frame->from[k] = fmin(frame->rw->bottom[k], frame->rw->top[k]);
		frame->to[k] = fmax(frame->rw->bottom[k], frame->rw->top[k]);
	}
	for (int i = 0; i < st->lanes; i++) {
		const struct hawser_line_statics *line = &st->lane[i].st;

		for (int k = 0; k < line->pieces; k++) {
			widen(frame, line->piece[k].x1);
			most = fmax(most, fmax(line->piece[k].T0, line->piece[k].T1));
		}
		for (int k = 0; k < frame->rw->towers; k++)
			frame->largest = fmax(frame->largest, hypot(st->lane[i].contact[k].reaction[0],
			                                            st->lane[i].contact[k].reaction[1]));
	}
	make_room(frame);
	frame->from[0] -= 0.02*(frame->to[0] - frame->from[0]);
	frame->to[0] += 0.02*(frame->to[0] - frame->from[0]);
	frame->x = hawser__axis_of("Distance {/:Italic x}", "m", 0.0);
	frame->y = hawser__axis_of("Height {/:Italic y}", "m", 0.0);
	frame->T = hawser__axis_of("Tension {/:Italic T}", "N", most);
	frame->R = hawser__axis_of("Force on battery", "N", frame->largest);
}

static void rope_data(FILE *script, const struct frame *frame, int lane)
{
	const struct hawser_line_statics *line = &frame->st->lane[lane].st;

	fprintf(script, "$rope%d << END\n", lane);
	for (int i = 0; i < line->pieces; i++) {
		const struct hawser_line_piece *piece = &line->piece[i];

		for (int k = 0; k < PER_PIECE; k++) {
			double x[2], T;

			hawser_line_at(line, x, NULL, &T, NULL, NULL,
			               piece->S0 + (piece->S1 - piece->S0)*k/PER_PIECE);
			fprintf(script, "%.8g %.8g %.9g\n", x[0]/frame->x.per, x[1]/frame->y.per, T/frame->T.per);
		}
		fprintf(script, "%.8g %.8g %.9g\n", piece->x1[0]/frame->x.per, piece->x1[1]/frame->y.per,
		        piece->T1/frame->T.per);
	}
	fprintf(script, "END\n$carriers%d << END\nNaN NaN NaN\n", lane);
	for (int i = 0; i < frame->st->lane[lane].carriers; i++)
		fprintf(script, "%.8g %.8g %.8g\n", line->carrier[i].x[0]/frame->x.per,
		        line->carrier[i].x[1]/frame->y.per,
		        (line->carrier[i].x[1] - frame->rw->hanger)/frame->y.per);
	fputs("END\n", script);
}

/* The vertical reaction of a tower on the lane where it is larger. */
static double farther(const struct frame *frame, int tower)
{
	double most = 0.0;

	for (int i = 0; i < frame->st->lanes; i++) {
		double R = frame->st->lane[i].contact[tower].reaction[1];

		most = fabs(R) > fabs(most) ? R : most;
	}
	return most;
}

/* Reactions: the foot of the arrow, its vector, the number. Those of lane down are beside those of
 * lane up. */
static void reaction_data(FILE *script, const struct frame *frame, int lane)
{
	double wide = (RIGHT - LEFT)*WIDTH, per[2];

	per[0] = (frame->to[0] - frame->from[0])/wide;
	per[1] = (frame->to[1] - frame->from[1])/LINE_CM;
	fprintf(script, "$reaction%d << END\nNaN NaN NaN NaN NaN none\n", lane);
	for (int i = 0; i < frame->rw->towers && frame->largest > 0.0; i++) {
		const struct hawser_ropeway_contact *c = &frame->st->lane[lane].contact[i];
		double tip = frame->rw->tower[i].at[1] + farther(frame, i)/frame->largest*ARROW_CM*per[1];
		double foot = frame->rw->tower[i].at[0] + lane*0.12*per[0],
			   up = c->reaction[1] < 0.0 ? -1.0 : 1.0;
		double d[2];

		for (int k = 0; k < 2; k++)
			d[k] = c->reaction[k]/frame->largest*ARROW_CM*per[k];
		if (c->touches)
			fprintf(script, "%.8g %.8g %.8g %.8g %.8g %.3g\n", foot/frame->x.per,
			        frame->rw->tower[i].at[1]/frame->y.per, d[0]/frame->x.per, d[1]/frame->y.per,
			        (tip + up*(0.28 + lane*0.36)*per[1])/frame->y.per,
			        c->reaction[1]/frame->R.per);
	}
	fputs("END\n", script);
}

static void tower_data(FILE *script, const struct frame *frame)
{
	const struct hawser_ropeway *rw = frame->rw;

	fputs("$towers << END\nNaN NaN NaN none NaN\n", script);
	for (int i = 0; i < rw->towers; i++) {
		fprintf(script, "%.8g %.8g %.8g ", rw->tower[i].at[0]/frame->x.per,
		        rw->tower[i].at[1]/frame->y.per,
		        (frame->from[1] - rw->tower[i].at[1])/frame->y.per);
		hawser__picture_literal(script, rw->tower[i].name, 1);
		fprintf(script, " %.8g\n",
		        (frame->from[1] + 0.035*(frame->to[1] - frame->from[1]))/frame->y.per);
	}
	fprintf(script, "END\n$stations << END\n%.8g %.8g\n%.8g %.8g\nEND\n", rw->bottom[0]/frame->x.per,
	        rw->bottom[1]/frame->y.per, rw->top[0]/frame->x.per, rw->top[1]/frame->y.per);
}

static void envelope_data(FILE *script, const struct frame *frame, int lane)
{
	const struct hawser_ropeway_lane_range *of = &frame->worst->lane[lane];

	fprintf(script, "$envelope%d << END\n", lane);
	for (int i = 0; i < (frame->rw->towers + 1)*HAWSER_ROPEWAY_ENVELOPE; i++)
		fprintf(script, "%.8g %.9g %.9g\n", of->place[i][0]/frame->x.per,
		        of->envelope[i].min/frame->T.per, of->envelope[i].max/frame->T.per);
	fprintf(script, "END\n$pressing%d << END\nNaN NaN NaN\n", lane);
	for (int i = 0; i < frame->rw->towers; i++)
		fprintf(script, "%.8g %.9g %.9g\n",
		        (frame->rw->tower[i].at[0] + lane*0.006*(frame->to[0] - frame->from[0]))/frame->x.per,
		        of->tower[i].pressing.min/frame->R.per, of->tower[i].pressing.max/frame->R.per);
	fputs("END\n", script);
}

/* The next panel from the top, of this height (cm); *top is its upper edge, cm from the lower end. */
static void panel(struct hawser__picture *picture, const struct frame *frame, double *top, double tall,
                  const char *title)
{
	hawser__picture_panel(picture, LEFT, RIGHT, (*top - tall)/frame->height, *top/frame->height);
	hawser__picture_ylabel(picture, "%s", title);
	*top -= tall + GAP_CM;
}

static void draw_line(FILE *script, const struct frame *frame)
{
	fprintf(script, "set yrange [%.8g:%.8g]\nplot "
	        "$towers using 1:2:(0):3 with vectors nohead lc rgb '#8a8a8a' lw 1.6",
	        frame->from[1]/frame->y.per, frame->to[1]/frame->y.per);
	for (int i = frame->st->lanes - 1; i >= 0; i--)
		fprintf(script,
		        ", $rope%d using 1:2 with lines lc rgb '%s' lw 1.4, "
		        "$carriers%d using 1:2:(0):($3 - $2) with vectors nohead lc rgb '%s' lw 0.8, "
		        "$carriers%d using 1:3 with points pt %d ps 0.55 lc rgb '%s'",
		        i, colour[i], i, colour[i], i, i ? 6 : 7, colour[i]);
	fputs(", $stations using 1:2 with points pt 5 ps 1 lc rgb 'black'", script);
	for (int i = frame->st->lanes - 1; i >= 0; i--)
		fprintf(script, ", $reaction%d using 1:2:3:4 with vectors head filled size screen 0.007,18 "
		        "lc rgb '%s' lw 1.2", i, colour[i]);
	for (int i = 0; i < frame->st->lanes && frame->rw->towers <= NAMED; i++)
		fprintf(script, ", $reaction%d using ($1 + $3):5:6 with labels font ',7.5' tc rgb '%s'", i,
		        colour[i]);
	if (frame->rw->towers <= NAMED)
		fputs(", $towers using 1:5:4 with labels offset 0.4, 0 left font ',8'",
		      script);
	fputs("\nset yrange [*:*]\n", script);
}

static void draw_tension(FILE *script, const struct frame *frame)
{
	const char *separator = "plot ";

	for (int i = 0; i < frame->st->lanes && frame->worst; i++) {
		fprintf(script,
		        "%s$envelope%d using 1:2:3 with filledcurves fs transparent solid 0.25 noborder "
		        "lc rgb '%s', $envelope%d using 1:2 with lines lc rgb '%s' lw 0.8, "
		        "$envelope%d using 1:3 with lines lc rgb '%s' lw 0.8",
		        separator, i, colour[i], i, colour[i], i, colour[i]);
		separator = ", ";
	}
	for (int i = 0; i < frame->st->lanes; i++) {
		fprintf(script, "%s$rope%d using 1:3 with lines lc rgb '%s' lw %g", separator, i, colour[i],
		        frame->worst ? 0.6 : 1.4);
		separator = ", ";
	}
	fputs("\n", script);
}

static void draw_pressing(FILE *script, const struct frame *frame)
{
	fputs("set yrange [*:*]\nplot 0 with lines lc rgb '#404040' lw 0.8", script);
	for (int i = 0; i < frame->st->lanes; i++)
		fprintf(script,
		        ", $pressing%d using 1:2:(0):($3 - $2) with vectors nohead lc rgb '%s' lw 4, "
		        "$pressing%d using 1:2 with points pt 7 ps 0.5 lc rgb '%s'",
		        i, colour[i], i, colour[i]);
	fputs("\n", script);
}

static struct hawser__legend legend(const struct frame *frame)
{
	struct hawser__legend entries = {0};

	for (int i = 0; i < frame->st->lanes; i++)
		hawser__legend_add(&entries, lane_title[i], "with lines lc rgb '%s' lw 1.4", colour[i]);
	for (int i = 0; i < frame->st->lanes; i++)
		if (frame->st->lane[i].carriers > 0)
			hawser__legend_add(&entries, i ? "carriers down" : "carriers up",
			                   "with points pt %d ps 0.55 lc rgb '%s'", i ? 6 : 7, colour[i]);
	hawser__legend_add(&entries, "towers", "with lines lc rgb '#8a8a8a' lw 1.6");
	if (frame->rw->towers > 0) {
		char title[64 + HAWSER__MARKUP_SIZE];

		snprintf(title, sizeof title, "force of battery on rope, vertical part in %s", frame->R.unit);
		hawser__legend_add(&entries, title, "with vectors head filled lc rgb '#404040' lw 1.2");
	}
	if (frame->worst)
		hawser__legend_add(&entries, "least to largest over the phases",
		                   "with lines lc rgb '#8a8a8a' lw 6");
	return entries;
}

enum hawser_status hawser__plot_ropeway(const char *path, const struct hawser_ropeway *rw,
                                        const struct hawser_ropeway_statics *st,
                                        const struct hawser_ropeway_worst *worst,
                                        struct hawser_report *report)
{
	struct frame frame = {.rw = rw, .st = st, .worst = worst};
	struct hawser__legend entries;
	struct hawser__picture picture;
	enum hawser_status status;
	FILE *script;
	double top;

	measure(&frame);
	entries = legend(&frame);
	frame.height =
		LINE_CM + (worst ? 2 : 1)*(OTHER_CM + GAP_CM) + hawser__legend_cm(&entries, WIDTH) + 0.3;
	status = hawser__picture_begin(&picture, path, WIDTH, frame.height, report);
	if (status)
		return status;
	script = picture.script;
	for (int i = 0; i < st->lanes; i++) {
		rope_data(script, &frame, i);
		reaction_data(script, &frame, i);
		if (worst)
			envelope_data(script, &frame, i);
	}
	tower_data(script, &frame);
	fprintf(script, "set xrange [%.8g:%.8g]\nset format x ''\n", frame.from[0]/frame.x.per,
	        frame.to[0]/frame.x.per);
	top = frame.height - 0.3;
	panel(&picture, &frame, &top, LINE_CM, frame.y.title);
	draw_line(script, &frame);
	if (!worst)
		fprintf(script, "set format x '%%g'\nset xlabel '%s'\n", frame.x.title);
	panel(&picture, &frame, &top, OTHER_CM, frame.T.title);
	draw_tension(script, &frame);
	if (worst) {
		fprintf(script, "set format x '%%g'\nset xlabel '%s'\n", frame.x.title);
		panel(&picture, &frame, &top, OTHER_CM, frame.R.title);
		draw_pressing(script, &frame);
	}
	hawser__legend_draw(&picture, &entries);
	return hawser__picture_finish(&picture, report);
}
