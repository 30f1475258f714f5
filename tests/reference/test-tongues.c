/* Tongues of a damped travelling cable whose speed fluctuates, by map and by hill: the principal one
 * begins at 3.458 m/s, far above where its multipliers have met; and the same cable without damping
 * at rest on average, whose tongues are 1e-3 rad/s wide and lie in each other. All are about rest. The
 * figures are those of an outside program (multipliers on a fine grid, bisection).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <string.h>

#include <hawser/hill.h>
#include <hawser/map.h>

#include "tests/tap.h"
#include "tests/unit/scene-text.h"

#define CABLE "cable: {EA: 1e8, rho: 5}\nspan: {d: 80, h: 5}\ntension: {H: 80000}\nmodel: {modes: 6}\n"
#define TRAVELS "travel: {speed: 37.947331922020552, fluctuation: 6.324555320336759, hold: tension}\n"
static const char damped[] = CABLE TRAVELS "damping: {alpha: 0.198305}\n";
static const char undamped[] = CABLE "travel: {speed: 0, fluctuation: 10, hold: tension}\n";

/* Crossings of the line y = at, ascending, of a map or of a chart. */
enum { MOST = 32 };
struct crossings {
	double x[MOST];
	int count;
};

static void add(struct crossings *to, double x)
{
	int k = to->count < MOST ? to->count++ : MOST - 1;

	for (; k > 0 && to->x[k - 1] > x; k--)
		to->x[k] = to->x[k - 1];
	to->x[k] = x;
}

static struct crossings of_map(const struct hawser_map *map, double at)
{
	struct crossings found = {.count = 0};

	for (int k = 0; k < map->boundaries; k++)
		if (map->boundary[k].along == 0 && fabs(map->boundary[k].y - at) < 1e-9)
			add(&found, map->boundary[k].x);
	return found;
}

static struct crossings of_chart(const struct hawser_hill_chart *chart, double at)
{
	struct crossings found = {.count = 0};

	for (int b = 0; b < chart->boundaries; b++)
		for (int i = 0; i + 1 < chart->boundary[b].points; i++) {
			const double *p = chart->boundary[b].at + 2*i, *q = p + 2;

			if ((p[1] > at) != (q[1] > at))
				add(&found, p[0] + (q[0] - p[0])*(at - p[1])/(q[1] - p[1]));
		}
	return found;
}

/* Both sides of a tongue are among the crossings. */
static int has(const struct crossings *found, double low, double high, double within)
{
	for (int k = 0; k + 1 < found->count; k++)
		if (fabs(found->x[k] - low) < within && fabs(found->x[k + 1] - high) < within)
			return 1;
	return 0;
}

struct plane {
	struct hawser_scene scene;
	struct hawser_map_source source;
	double from[2], to[2];
	int points[2], lines, samples;
};

static int open_plane(struct plane *plane, const char *text)
{
	plane->source = (struct hawser_map_source){.scene = &plane->scene, .quantity = "multiplier",
		.key = {"Omega", "travel.fluctuation"}, .rest = 1};
	return read_text(&plane->scene, text, NULL, NULL) != HAWSER_OK;
}

static enum hawser_status map_of(struct hawser_map *map, const struct plane *plane)
{
	struct hawser_map_options options = {.threads = 1};
	struct hawser_map_field field;
	enum hawser_status status = hawser_map_cable_open(&field, &plane->source, NULL);

	memcpy(options.from, plane->from, sizeof options.from);
	memcpy(options.to, plane->to, sizeof options.to);
	memcpy(options.points, plane->points, sizeof options.points);
	*map = (struct hawser_map){.nx = 0};
	if (!status)
		status = hawser_map_trace(map, &field, &options, NULL);
	hawser_map_cable_close(&field);
	return status;
}

static enum hawser_status chart_of(struct hawser_hill_chart *chart, const struct plane *plane)
{
	struct hawser_hill_options options = {.lines = plane->lines, .samples = plane->samples};
	struct hawser_hill_field field;
	enum hawser_status status = hawser_hill_cable_open(&field, &plane->source, NULL);

	memcpy(options.from, plane->from, sizeof options.from);
	memcpy(options.to, plane->to, sizeof options.to);
	*chart = (struct hawser_hill_chart){.boundaries = 0};
	if (!status)
		status = hawser_hill_trace(chart, &field, &options, NULL);
	hawser_hill_cable_close(&field);
	return status;
}

/* The lowest point of the boundaries with x in [low, high]. */
static double tip(const struct hawser_hill_chart *chart, double low, double high)
{
	double least = INFINITY;

	for (int b = 0; b < chart->boundaries; b++)
		for (int i = 0; i < chart->boundary[b].points; i++) {
			const double *p = chart->boundary[b].at + 2*i;

			if (p[0] > low && p[0] < high)
				least = fmin(least, p[1]);
		}
	return least;
}

static void principal(void)
{
	struct plane plane = {.from = {9.9, 3.0}, .to = {10.7, 7.0}, .points = {9, 9}, .lines = 2,
		.samples = 24};
	struct hawser_hill_chart chart = {.boundaries = 0};
	struct hawser_map map = {.nx = 0};
	struct crossings by_map, by_hill;
	int failed = open_plane(&plane, damped) || map_of(&map, &plane) || chart_of(&chart, &plane);

	by_map = of_map(&map, 5.0);
	by_hill = of_chart(&chart, 5.0);
	ok(!failed && has(&by_map, 10.306, 10.370, 1.5e-3), "map: at 5 m/s unstable from 10.306 to 10.370");
	ok(!failed && has(&by_hill, 10.306, 10.370, 1.5e-3), "hill: the same");
	ok(fabs(tip(&chart, 10.30, 10.37) - 3.458) < 1e-3, "hill: it begins at 3.458 m/s: %.4f",
	   tip(&chart, 10.30, 10.37));
	by_map = of_map(&map, 3.5);
	ok(of_map(&map, 3.0).count == 0 && by_map.count == 2 && by_map.x[1] - by_map.x[0] < 0.02,
	   "map: at 3.5 m/s it is %.4f wide, a fifth of a cell, at 3 m/s there is none",
	   by_map.x[1] - by_map.x[0]);
	hawser_map_clear(&map);
	hawser_hill_clear(&chart);
	hawser_scene_clear(&plane.scene);
}

/* Two in-plane tongues within 0.1 rad/s, and a combination tongue. */
static void others(void)
{
	struct plane plane = {.from = {18.0, 0.0}, .to = {18.7, 0.8}, .points = {8, 9}, .lines = 2,
		.samples = 24};
	struct hawser_hill_chart chart = {.boundaries = 0};
	struct hawser_map map = {.nx = 0};
	struct crossings found;
	int failed = open_plane(&plane, damped) || map_of(&map, &plane) || chart_of(&chart, &plane);

	ok(!failed && fabs(tip(&chart, 18.2, 18.4) - 0.375) < 1e-3, "the tongue at 18.3 begins at 0.375: "
	   "%.4f", tip(&chart, 18.2, 18.4));
	found = of_map(&map, 0.4);
	ok(found.count == 4, "map: both tongues at 0.4 m/s: %d crossings", found.count);
	hawser_map_clear(&map);
	hawser_hill_clear(&chart);
	plane = (struct plane){.scene = plane.scene, .source = plane.source, .from = {13.2, 1.0},
		.to = {14.0, 1.4}, .points = {9, 9}};
	plane.source.scene = &plane.scene;
	failed = map_of(&map, &plane);
	found = of_map(&map, 1.25);
	ok(!failed && has(&found, 13.66, 13.69, 5e-3), "map: the combination tongue at 1.25 m/s, 13.66 to "
	   "13.69");
	hawser_map_clear(&map);
	hawser_scene_clear(&plane.scene);
}

/* Tongues of 0.001 rad/s, and one of 3e-5 (multipliers at steps of 1e-5: unstable from 9.92928 to
 * 9.92931): each crossing by hill is one by map. */
static void nested(void)
{
	struct plane plane = {.from = {9.85, 10.5}, .to = {9.93, 11.0}, .points = {17, 3}, .lines = 1,
		.samples = 16};
	struct hawser_hill_chart chart = {.boundaries = 0};
	struct hawser_map map = {.nx = 0};
	struct crossings by_map, by_hill;
	int failed = open_plane(&plane, undamped) || map_of(&map, &plane) || chart_of(&chart, &plane);
	double apart = 0.0;

	by_map = of_map(&map, 11.0);
	by_hill = of_chart(&chart, 11.0 - 1e-9);
	for (int k = 0; k < by_map.count && k < by_hill.count; k++)
		apart = fmax(apart, fabs(by_map.x[k] - by_hill.x[k]));
	ok(!failed && by_map.count == 10 && by_hill.count == 10,
	   "undamped, at 11 m/s five tongues: map %d, hill %d crossings", by_map.count, by_hill.count);
	ok(apart < 3e-4, "at the same places within %.1e", apart);
	ok(has(&by_hill, 9.8843, 9.8855, 2e-4) && has(&by_map, 9.8843, 9.8855, 2e-4), "one of them in "
	   "another, from 9.8843 to 9.8855");
	for (int b = 0; b < chart.boundaries; b++)
		failed |= chart.boundary[b].limited;
	ok(!failed, "no boundary was left before its end");
	hawser_map_clear(&map);
	hawser_hill_clear(&chart);
	hawser_scene_clear(&plane.scene);
}

/* The fluctuation displaces a tongue from its resonance at rest: cells that are narrower than that
 * must not hide it. Multipliers at 501 points from 11.024 to 11.029: unstable from 11.02616 to
 * 11.0271. */
static void fine(void)
{
	for (int points = 201; points < 3000; points = 10*points - 9) {
		struct plane plane = {.from = {10.0, 12.6491}, .to = {12.0, 12.65}, .points = {points, 2}};
		struct hawser_map map = {.nx = 0};
		struct crossings found;
		int failed = open_plane(&plane, undamped) || map_of(&map, &plane);

		found = of_map(&map, 12.6491);
		ok(!failed && has(&found, 11.02616, 11.0271, 3e-4), "a map with %d points a row has the tongue "
		   "at 11.026", points);
		hawser_map_clear(&map);
		hawser_scene_clear(&plane.scene);
	}
}

/* A fluctuation of 12.65 m/s displaces resonances by up to 0.1 rad/s, ten cells: the tongues are found
 * by multipliers of rows that are far from rest. Multipliers at steps of 2e-4 rad/s and below: 4.8944
 * to 4.8954, 5.0118 to 5.0126, and 2e-5 wide at 5.02973. From 5.0541 to 5.0548 (an outside program)
 * 2 w3 = 4 Omega is displaced by more than the distance of other frequencies from it. */
static void displaced(void)
{
	struct plane plane = {.from = {4.8, 12.0}, .to = {5.1, 12.65}, .points = {121, 3}};
	struct hawser_map map = {.nx = 0};
	struct crossings found;
	int failed = open_plane(&plane, undamped) || map_of(&map, &plane);

	found = of_map(&map, 12.65);
	ok(!failed && has(&found, 4.8945, 4.8954, 1e-4) && has(&found, 5.0118, 5.0126, 1e-4) &&
	   has(&found, 5.02972, 5.02974, 2e-5), "displaced tongues on rows far from rest: %d crossings",
	   found.count);
	ok(has(&found, 5.0541, 5.0548, 1e-4), "one that arguments and rates of multipliers tell");
	hawser_map_clear(&map);
	hawser_scene_clear(&plane.scene);
}

CASE(reference_tongues)
{
	principal();
	others();
	nested();
	fine();
	displaced();
	return done_testing();
}
