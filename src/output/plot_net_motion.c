/* output/plot_net_motion.c - see plot_net_motion.h. A direction in which nothing moves, and a kind of
 * energy that is always zero, are left out.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>

#include "output/plot_net_motion.h"
#include "output/style.h"

#define WIDTH 15.0   /* cm, of the picture */
#define LEFT 2.3     /* cm, of the panels: room for tics and titles */
#define RIGHT 14.6   /* cm, a margin */
#define PANEL 2.9    /* height */
#define GAP 0.55     /* between panels */
#define LEGEND 0.95  /* above a panel with a legend */
#define FOOT 1.35    /* below the last panel */
enum { TICS = 5, PROBES = 6, DIRECTIONS = 3, ENERGIES = 5 };
static const double moves = 1e-3;  /* of the largest displacement: less is no motion */
static const double still = 1e-12; /* of the largest coordinate: less is round-off */

struct drawing {
	struct hawser__picture picture;
	const struct hawser_net_motion *motion;
	const char *const *names;
	int probes, shown[DIRECTIONS], energies[ENERGIES], slack; /* slack: most elements */
	double low[DIRECTIONS + 1], high[DIRECTIONS + 1]; /* of displacements, and of energies */
	double displaced, tension, energy;                /* largest values */
	int rests;                                        /* 1: all moves by round-off only */
	double height, top;                /* cm: of the picture, of the next panel */
};

static double displacement(const struct drawing *drawing, int row, int probe, int k)
{
	const struct hawser_net_motion *motion = drawing->motion;

	return motion->x[row*motion->probes + probe][k] - motion->x[probe][k];
}

static double energy(const struct hawser_net_motion *motion, int row, int kind)
{
	const double *of[] = {motion->kinetic, motion->potential, NULL, motion->work, motion->dissipated};

	return of[kind] ? of[kind][row] : motion->kinetic[row] + motion->potential[row];
}

/* Widen the range of a direction or of the energies. All begin at zero. */
static void widen(struct drawing *drawing, int k, double value)
{
	drawing->low[k] = fmin(drawing->low[k], value);
	drawing->high[k] = fmax(drawing->high[k], value);
}

/* What there is to show. */
static void look(struct drawing *drawing)
{
	const struct hawser_net_motion *motion = drawing->motion;
	double energies[ENERGIES] = {0.0}, most[DIRECTIONS], far = 0.0;
	int directions = 0;

	drawing->probes = motion->probes < PROBES ? motion->probes : PROBES;
	for (int i = 0; i < motion->rows; i++) {
		for (int p = 0; p < drawing->probes; p++) {
			for (int k = 0; k < DIRECTIONS; k++) {
				widen(drawing, k, displacement(drawing, i, p, k));
				far = fmax(far, fabs(motion->x[p][k]));
			}
			drawing->tension = fmax(drawing->tension, motion->T[i*motion->probes + p]);
		}
		for (int k = 0; k < ENERGIES; k++) {
			energies[k] = fmax(energies[k], fabs(energy(motion, i, k)));
			widen(drawing, DIRECTIONS, energy(motion, i, k));
		}
		drawing->slack = motion->slack[i] > drawing->slack ? motion->slack[i] : drawing->slack;
	}
	for (int k = 0; k < DIRECTIONS; k++) {
		most[k] = fmax(drawing->high[k], -drawing->low[k]);
		drawing->displaced = fmax(drawing->displaced, most[k]);
	}
	drawing->rests = drawing->displaced <= still*far;
	for (int k = 0; k <= DIRECTIONS && drawing->rests; k++) {
		drawing->low[k] = -1.0;
		drawing->high[k] = 1.0;
	}
	for (int k = 0; k < DIRECTIONS; k++)
		directions += drawing->shown[k] = drawing->rests ? k == 1
			: most[k] > moves*drawing->displaced;
	for (int k = 0; k < ENERGIES; k++) {
		drawing->energies[k] = k < 3 || energies[k] > 0.0;
		drawing->energy = fmax(drawing->energy, energies[k]);
	}
	directions += drawing->slack > 0; /* panels, but for tension and energy */
	drawing->height = 2.0*LEGEND + (directions + 2)*PANEL + directions*GAP + FOOT;
	drawing->top = drawing->height;
}

static void data(struct drawing *drawing, double metres, double newtons, double joules)
{
	const struct hawser_net_motion *motion = drawing->motion;
	FILE *script = drawing->picture.script;

	fputs("$motion << END\n", script);
	for (int i = 0; i < motion->rows; i++) {
		fprintf(script, "%.9g %d", motion->time[i], motion->slack[i]);
		for (int k = 0; k < ENERGIES; k++)
			fprintf(script, " %.7g", energy(motion, i, k)/joules);
		for (int p = 0; p < drawing->probes; p++) {
			for (int k = 0; k < DIRECTIONS; k++)
				fprintf(script, " %.7g", displacement(drawing, i, p, k)/metres);
			fprintf(script, " %.7g", motion->T[i*motion->probes + p]/newtons);
		}
		fputs("\n", script);
	}
	fputs("END\n", script);
}

/* The next panel from above, `gap` below the one before; range of its values. */
static void panel(struct drawing *drawing, double gap, const char *title, int last, double low,
                  double high)
{
	FILE *script = drawing->picture.script;

	drawing->top -= gap;
	hawser__picture_panel(&drawing->picture, LEFT/WIDTH, RIGHT/WIDTH,
	                      (drawing->top - PANEL)/drawing->height, drawing->top/drawing->height);
	drawing->top -= PANEL;
	hawser__picture_ylabel(&drawing->picture, "%s", title);
	hawser__picture_tics(&drawing->picture, 'y', low, high, TICS);
	if (drawing->rests && low < 0.0)
		fprintf(script, "set yrange [%.9g:%.9g]\n", low, high);
	else
		fputs("set yrange [*:*]\n", script);
	fprintf(script, "set format x '%s'\n", last ? "%g" : "");
	if (last)
		fputs("set xlabel 'Time {/:Italic t} (s)' offset 0, 0.3\n", script);
}

/* Column `first` of each probe; with their names where `named`. */
static void probes(struct drawing *drawing, int first, int named)
{
	FILE *script = drawing->picture.script;

	for (int p = 0; p < drawing->probes; p++) {
		fprintf(script, "%s $motion using 1:%d with lines lt %d", p ? "," : "plot",
		        8 + 4*p + first, p + 1);
		if (named)
			fprintf(script, " title \"%s\" noenhanced", drawing->names[p]);
		else
			fputs(" notitle", script);
	}
	fputs("\n", script);
}

static void draw_energy(struct drawing *drawing)
{
	static const struct {
		const char *name, *style;
	} line[ENERGIES] = {{"kinetic", "lt 1"}, {"potential", "lt 2"}, {"sum", "lt 7 dt (8,4)"},
	                    {"work", "lt 3"}, {"dissipated", "lt 5"}};
	static const int order[ENERGIES] = {0, 1, 3, 4, 2}; /* the sum may coincide with the work */
	FILE *script = drawing->picture.script;
	const char *comma = "plot";

	for (int i = 0; i < ENERGIES; i++) {
		int k = order[i];

		if (!drawing->energies[k])
			continue;
		fprintf(script, "%s $motion using 1:%d with lines %s title '%s'", comma, 3 + k, line[k].style,
		        line[k].name);
		comma = ",";
	}
	fputs("\n", script);
}

static void draw(struct drawing *drawing, const struct hawser__axis *direction,
                 const struct hawser__axis *tension, const struct hawser__axis *energies)
{
	FILE *script = drawing->picture.script;
	int first = 1;

	fputs("set key on at graph 1, graph 1.14 right center horizontal\n", script);
	for (int k = 0; k < DIRECTIONS; k++) {
		if (!drawing->shown[k])
			continue;
		panel(drawing, first ? LEGEND : GAP, direction[k].title, 0,
		      drawing->low[k]/direction[k].per, drawing->high[k]/direction[k].per);
		probes(drawing, k, first);
		first = 0;
	}
	panel(drawing, GAP, tension->title, 0, 0.0, drawing->tension/tension->per);
	fputs("set yrange [0:*]\n", script);
	probes(drawing, DIRECTIONS, 0);
	panel(drawing, LEGEND, energies->title, !drawing->slack, drawing->low[DIRECTIONS]/energies->per,
	      drawing->high[DIRECTIONS]/energies->per);
	draw_energy(drawing);
	if (!drawing->slack)
		return;
	panel(drawing, GAP, "Slack elements", 1, 0.0, fmax(drawing->slack, 5.0));
	fputs("set yrange [0:*]\nplot $motion using 1:2 with steps lt 8 notitle\n", script);
}

enum hawser_status hawser__plot_net_motion(const char *path, const struct hawser_net_motion *motion,
                                           const char *const *names, struct hawser_report *report)
{
	struct drawing drawing = {.motion = motion, .names = names};
	struct hawser__axis direction[DIRECTIONS], tension, energies;
	enum hawser_status status;

	look(&drawing);
	for (int k = 0; k < DIRECTIONS; k++) {
		char quantity[64];

		snprintf(quantity, sizeof quantity, "{/:Italic %c} – {/:Italic %c}_0", "xyz"[k], "xyz"[k]);
		direction[k] = hawser__axis_of(quantity, "m", drawing.displaced);
	}
	tension = hawser__axis_of("Tension {/:Italic T}", "N", drawing.tension);
	energies = hawser__axis_of("Energy", "J", drawing.energy);
	status = hawser__picture_begin(&drawing.picture, path, WIDTH, drawing.height, report);
	if (status)
		return status;
	data(&drawing, direction[0].per, tension.per, energies.per);
	fprintf(drawing.picture.script, "set xrange [%.9g:%.9g]\n", motion->time[0],
	        motion->time[motion->rows - 1] > motion->time[0] ? motion->time[motion->rows - 1]
	                                                        : motion->time[0] + 1.0);
	draw(&drawing, direction, &tension, &energies);
	return hawser__picture_finish(&drawing.picture, report);
}
