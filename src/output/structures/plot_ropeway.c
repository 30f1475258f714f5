/* output/structures/plot_ropeway.c - see structures.h. The arrows of the reactions have their
 * true direction on the page, and lengths in proportion to their force.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "output/structures/structures.h"

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
static const char *const carriers_title[] = {"carriers up", "carriers down"};

struct frame {
	const struct hawser_ropeway *rw;
	const struct hawser_ropeway_statics *st;
	const struct hawser_ropeway_worst *worst;
	struct hawser__axis x, y, T, R;
	double from[2], to[2], largest; /* of the panel of the line, m; N */
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

static void draw_lane(struct hawser__figure *figure, const struct frame *frame, int lane)
{
	const struct hawser_ropeway_lane *of = &frame->st->lane[lane];

	hawser__plot_rope(figure, &frame->st->lane[lane].st, 0, PER_PIECE);
	hawser__figure_draw(figure, NULL, "with lines lc rgb '%s' lw 1.4", colour[lane]);
	for (int i = 0; i < of->carriers; i++)
		hawser__figure_row(figure, "xyXY", (double[]){of->st.carrier[i].x[0],
		                                              of->st.carrier[i].x[1], 0.0,
		                                              -frame->rw->hanger});
	hawser__figure_draw(figure, NULL, "using 1:2:3:4 with vectors nohead lc rgb '%s' lw 0.8",
	                    colour[lane]);
	hawser__figure_again(figure, carriers_title[lane],
	                     "using 1:($2 + $4) with points pt %d ps 0.55 lc rgb '%s'", lane ? 6 : 7,
	                     colour[lane]);
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
static void draw_reactions(struct hawser__figure *figure, const struct frame *frame, int lane)
{
	const double per[2] = {(frame->to[0] - frame->from[0])/((RIGHT - LEFT)*WIDTH),
	                       (frame->to[1] - frame->from[1])/LINE_CM};
	char settings[60];

	snprintf(settings, sizeof settings, "center font ',7.5' tc rgb '%s'", colour[lane]);
	for (int i = 0; i < frame->rw->towers && frame->largest > 0.0; i++) {
		const struct hawser_ropeway_contact *c = &frame->st->lane[lane].contact[i];
		double y = frame->rw->tower[i].at[1], foot = frame->rw->tower[i].at[0] + lane*0.12*per[0];
		double tip = y + farther(frame, i)/frame->largest*ARROW_CM*per[1], d[2];
		double up = c->reaction[1] < 0.0 ? -1.0 : 1.0;

		for (int k = 0; k < 2; k++)
			d[k] = c->reaction[k]/frame->largest*ARROW_CM*per[k];
		if (!c->touches)
			continue;
		hawser__figure_row(figure, "xyXY", (double[]){foot, y, d[0], d[1]});
		if (frame->rw->towers <= NAMED)
			hawser__figure_label(figure, foot + d[0], tip + up*(0.28 + lane*0.36)*per[1], settings,
			                     "%.3g",
			                     c->reaction[1]/frame->R.per);
	}
	hawser__figure_draw(figure, NULL, "using 1:2:3:4 with vectors head filled size screen 0.007,18 "
	                    "lc rgb '%s' lw 1.2", colour[lane]);
}

static void draw_towers(struct hawser__figure *figure, const struct frame *frame)
{
	const struct hawser_ropeway *rw = frame->rw;
	double low = frame->from[1] + 0.035*(frame->to[1] - frame->from[1]);

	for (int i = 0; i < rw->towers; i++) {
		const double *at = rw->tower[i].at;

		hawser__figure_row(figure, "xyXY", (double[]){at[0], at[1], 0.0, frame->from[1] - at[1]});
		if (rw->towers <= NAMED)
			hawser__figure_name(figure, at[0], low, "left offset 0.4, 0 font ',8'", rw->tower[i].name);
	}
	hawser__figure_draw(figure, NULL, "using 1:2:3:4 with vectors nohead lc rgb '#8a8a8a' lw 1.6");
}

static void draw_line(struct hawser__figure *figure, const struct frame *frame)
{
	draw_towers(figure, frame);
	for (int i = frame->st->lanes - 1; i >= 0; i--)
		draw_lane(figure, frame, i);
	hawser__figure_put(figure, frame->rw->bottom[0], frame->rw->bottom[1]);
	hawser__figure_put(figure, frame->rw->top[0], frame->rw->top[1]);
	hawser__figure_draw(figure, NULL, "with points pt 5 ps 1 lc rgb 'black'");
	for (int i = frame->st->lanes - 1; i >= 0; i--)
		draw_reactions(figure, frame, i);
}

static void draw_envelope(struct hawser__figure *figure, const struct frame *frame, int lane)
{
	const struct hawser_ropeway_lane_range *of = &frame->worst->lane[lane];

	for (int i = 0; i < (frame->rw->towers + 1)*HAWSER_ROPEWAY_ENVELOPE; i++)
		hawser__figure_row(figure, "xyy", (double[]){of->place[i][0], of->envelope[i].min,
		                                             of->envelope[i].max});
	hawser__figure_draw(figure, NULL,
	                    "using 1:2:3 with filledcurves fs transparent solid 0.25 noborder "
	                    "lc rgb '%s'", colour[lane]);
	for (int column = 2; column < 4; column++)
		hawser__figure_again(figure, NULL, "using 1:%d with lines lc rgb '%s' lw 0.8", column,
		                     colour[lane]);
}

static void draw_tension(struct hawser__figure *figure, const struct frame *frame)
{
	for (int i = 0; i < frame->st->lanes && frame->worst; i++)
		draw_envelope(figure, frame, i);
	for (int i = 0; i < frame->st->lanes; i++) {
		hawser__plot_rope(figure, &frame->st->lane[i].st, 1, PER_PIECE);
		hawser__figure_draw(figure, NULL, "with lines lc rgb '%s' lw %g", colour[i],
		                    frame->worst ? 0.6 : 1.4);
	}
}

static void draw_pressing(struct hawser__figure *figure, const struct frame *frame)
{
	hawser__figure_function(figure, NULL, "0 with lines lc rgb '#404040' lw 0.8");
	for (int i = 0; i < frame->st->lanes; i++) {
		for (int k = 0; k < frame->rw->towers; k++) {
			const struct hawser_ropeway_range *range = &frame->worst->lane[i].tower[k].pressing;

			hawser__figure_row(figure, "xyXY", (double[]){
				frame->rw->tower[k].at[0] + i*0.006*(frame->to[0] - frame->from[0]), range->min, 0.0,
				range->max - range->min});
		}
		hawser__figure_draw(figure, NULL, "using 1:2:3:4 with vectors nohead lc rgb '%s' lw 4",
		                    colour[i]);
		hawser__figure_again(figure, NULL, "using 1:2 with points pt 7 ps 0.5 lc rgb '%s'", colour[i]);
	}
}

/* Entries that precede those of what is drawn, or follow them. */
static void add_entries(struct hawser__legend *legend, const struct frame *frame, int after)
{
	char title[64 + HAWSER__MARKUP_SIZE];

	for (int i = 0; i < frame->st->lanes && !after; i++)
		hawser__legend_add(legend, lane_title[i], "with lines lc rgb '%s' lw 1.4", colour[i]);
	for (int i = 0; i < frame->st->lanes && !after; i++)
		if (frame->st->lane[i].carriers > 0)
			hawser__legend_add(legend, carriers_title[i], "with points pt %d ps 0.55 lc rgb '%s'",
			                   i ? 6 : 7,
			                   colour[i]);
	if (!after)
		return;
	hawser__legend_once(legend, "towers", "with lines lc rgb '#8a8a8a' lw 1.6");
	snprintf(title, sizeof title, "force of battery on rope, vertical part in %s", frame->R.unit);
	if (frame->rw->towers > 0)
		hawser__legend_once(legend, title, "with vectors head filled lc rgb '#404040' lw 1.2");
	if (frame->worst)
		hawser__legend_once(legend, "least to largest over the phases",
		                    "with lines lc rgb '#8a8a8a' lw 6");
}

enum hawser_status hawser__plot_ropeway(const char *path, const struct hawser_ropeway *rw,
                                        const struct hawser_ropeway_statics *st,
                                        const struct hawser_ropeway_worst *worst,
                                        struct hawser_report *report)
{
	struct frame frame = {.rw = rw, .st = st, .worst = worst};
	struct hawser__figure figure = {0};
	int panels = worst ? 3 : 2;
	double top = LINE_CM + (panels - 1)*(OTHER_CM + GAP_CM) + HAWSER__LEGEND_CM, height = top + 0.3;
	enum hawser_status status = hawser__figure_begin(&figure, path, WIDTH, height, report);

	if (status)
		return status;
	measure(&frame);
	add_entries(&figure.legend, &frame, 0);
	for (int k = 0; k < panels; k++) {
		const struct hawser__axis *y[] = {&frame.y, &frame.T, &frame.R};
		double tall = k ? OTHER_CM : LINE_CM;

		hawser__figure_panel(&figure, &(struct hawser__panel_frame){LEFT, RIGHT, (top - tall)/height,
			top/height, .x = {&frame.x, frame.from[0], frame.to[0], .bare = k + 1 < panels},
			.y = {.axis = y[k], .from = k ? 0.0 : frame.from[1], .to = k ? 0.0 : frame.to[1]}});
		top -= tall + GAP_CM;
		if (k == 0)
			draw_line(&figure, &frame);
		else if (k == 1)
			draw_tension(&figure, &frame);
		else
			draw_pressing(&figure, &frame);
	}
	add_entries(&figure.legend, &frame, 1);
	return hawser__figure_finish(&figure, report);
}
