/* output/structures/plot_net_modes.c - see structures.h. Each panel has the equilibrium in
 * grey and the net displaced, in the same perspective and scale. A plane net is seen aslant, so
 * that motion in its plane and across it are both visible.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/drawing/figure.h"
#include "output/drawing/perspective.h"
#include "output/structures/structures.h"

#define LARGEST 0.12 /* of the size of the net: largest displacement drawn */
#define WIDTH 17.0   /* cm */
#define FOOT 1.5     /* cm, of the legend */
/* Most points drawn with thick lines; points drawn, about, but for the ends of cables. */
enum { FEW = 400, DRAWN = 400 };

static size_t index_of(const struct hawser_net_modes *modes, int k, int point)
{
	return (size_t)k*(size_t)modes->points + (size_t)point;
}

/* Place of a point in mode k, or in the equilibrium if k is negative. */
static void place(double x[3], const struct hawser_net_modes *modes, int k, int point, double scale)
{
	for (int i = 0; i < 3; i++) {
		x[i] = modes->place[point][i];
		if (k >= 0)
			x[i] += scale*modes->point[index_of(modes, k, point)][i];
	}
}

/* Puts a mode, or the equilibrium, or (figure is NULL) adds it to what is seen. */
static void put_shape(struct hawser__figure *figure, struct hawser__box *seen,
                      const struct hawser_net_modes *modes, const struct hawser__eye *eye, int k)
{
	int apart = 1 + modes->points/DRAWN;

	for (int p = 0, along = 0; p < modes->points; p++, along++) {
		int last = p + 1 == modes->points || modes->cable[p + 1] != modes->cable[p];
		double x[3], to[2];

		place(x, modes, k, p, k < 0 ? 0.0 : LARGEST*eye->size);
		hawser__eye_see(to, eye, x);
		if (!figure) {
			hawser__box_add(seen, to, 2);
			continue;
		}
		if (p > 0 && modes->cable[p] != modes->cable[p - 1]) {
			hawser__figure_gap(figure);
			along = 0;
		}
		if (along % apart == 0 || last)
			hawser__figure_put(figure, to[0], to[1]);
	}
}

/* What the mode is, in a few words: the title has room for some 12 letters after the frequency. */
static void describe(char *text, size_t size, const struct hawser_net_modes *modes, int k)
{
	const char *plane = hawser_net_plane_side(modes->parity[k][0]);
	int most = 0;

	for (int i = 1; i < 3; i++)
		if (modes->share[k][i] > modes->share[k][most])
			most = i;
	if (modes->along[k] > 0.5)
		snprintf(text, size, "longitudinal");
	else if (plane)
		snprintf(text, size, "%s", plane);
	else
		snprintf(text, size, "%.0f %% {/:Italic %c}", 100.0*modes->share[k][most], "xyz"[most]);
}

/* Symmetry, waves and pair, below the title: "sym/anti, 1 wave, pair 2", or "symmetric". */
static void subtitle(FILE *script, const struct hawser_net_modes *modes, int k)
{
	const char *comma = "";
	int mirrors = modes->symmetry.mirrors;

	fputs("set label '", script);
	for (int i = 0; i < mirrors; i++, comma = i < mirrors ? "/" : ", ") {
		const char *side = hawser_net_side(modes->parity[k][1 + i]);

		int letters = mirrors == 1 ? 13 : side[0] == 's' ? 3 : side[0] == 'a' ? 4 : 5;

		fprintf(script, "%s%.*s", comma, letters, side);
	}
	if (modes->waves[k] >= 0) {
		fprintf(script, "%s%d wave%s", comma, modes->waves[k], modes->waves[k] == 1 ? "" : "s");
		comma = ", ";
	}
	if (modes->pair[k] >= 0)
		fprintf(script, "%spair %d", comma, modes->pair[k] + 1);
	fputs("' at graph 0.5, graph 1.0 center tc rgb '#606060'\n", script);
}

/* Without room for the titles of axes. */
static struct hawser__panels arrange(int modes)
{
	struct hawser__panels at = hawser__panels_arrange(modes);

	at.height = FOOT + 4.3*at.rows;
	at.bottom = FOOT/at.height;
	at.left = 0.03;
	at.width = (1.0 - at.left)/at.columns;
	at.tall = (at.top - at.bottom)/at.rows;
	return at;
}

static struct hawser__eye eye_of(const struct hawser_net_modes *modes)
{
	struct hawser__box box = {.any = 0};
	struct hawser__eye eye;

	for (int p = 0; p < modes->points; p++)
		hawser__box_add(&box, modes->place[p], 3);
	hawser__eye_look(&eye, &box, HAWSER__ASLANT,
	                 modes->symmetry.flat ? modes->symmetry.plane.normal : NULL);
	return eye;
}

enum hawser_status hawser__plot_net_modes(const char *path, const struct hawser_net_modes *modes,
                                          struct hawser_report *report)
{
	const struct hawser__panels at = arrange(modes->n);
	const struct hawser__corner corner = {WIDTH - 1.0, 0.75, WIDTH, at.height};
	const double line = modes->points <= FEW ? 1.6 : modes->points <= 10*FEW ? 0.9 : 0.5;
	struct hawser__eye eye = eye_of(modes);
	struct hawser__box seen = {.any = 0};
	struct hawser__figure figure = {0};
	char text[80];
	enum hawser_status status = hawser__figure_begin(&figure, path, WIDTH, at.height, report);

	if (status)
		return status;
	for (int k = -1; k < at.panels; k++)
		put_shape(NULL, &seen, modes, &eye, k);
	for (int k = 0; k < at.panels; k++) {
		hawser__panels_open(&figure, &at, k, &(struct hawser__panel_frame){.view = 1,
			.x = {.from = seen.low[0], .to = seen.high[0]}, .y = {.from = seen.low[1],
			                                                      .to = seen.high[1]}});
		describe(text, sizeof text, modes, k);
		hawser__panels_frequency(figure.out.script, k, modes->omega[k], text);
		subtitle(figure.out.script, modes, k);
		if (k == 0)
			hawser__eye_axes(figure.out.script, &eye, &corner);
		put_shape(&figure, NULL, modes, &eye, -1);
		hawser__figure_draw(&figure, NULL, "with lines lw %g lc rgb '#a8a8a8'", line);
		put_shape(&figure, NULL, modes, &eye, k);
		hawser__figure_draw(&figure, NULL, "with lines lt 1 lw %g", line);
	}
	snprintf(text, sizeof text, "%s, displaced by %.0f %% of the size of the net",
	         at.panels > 1 ? "modes" : "mode", 100.0*LARGEST);
	hawser__legend_once(&figure.legend, "equilibrium", "with lines lw 1.6 lc rgb '#a8a8a8'");
	hawser__legend_once(&figure.legend, text, "with lines lt 1");
	return hawser__figure_finish(&figure, report);
}
