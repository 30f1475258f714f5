/* Boundaries of stability of the periodic response of a travelling cable whose speed fluctuates: edges
 * of the region at twice the first in-plane frequency against an outside program (full order, about the
 * moving response), and the error that is stated of them; map, hill and the response's multipliers
 * against each other; a response that jumps.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <string.h>

#include <hawser/frf.h>
#include <hawser/hill.h>
#include <hawser/map.h>

#include "tests/tap.h"
#include "tests/unit/scene-text.h"

#define LEVEL "cable: {EA: 1e8, rho: 5}\nspan: {d: 80, h: 0}\ntension: {H: 80000}\n" \
              "travel: {speed: 37.947331922020552, fluctuation: 2, hold: tension}\n"
#define INCLINED "cable: {EA: 1e8, rho: 5}\nspan: {d: 80, h: 5}\ntension: {H: 80000}\n" \
                 "damping: {alpha: 0.198305}\nmodel: {modes: 6}\n" \
                 "travel: {speed: 37.947331922020552, fluctuation: 5, hold: tension}\n"

enum { MOST = 128, WAVES = 8 };

static int open_field(struct hawser_hill_field *field, struct hawser_map_source *source,
                      struct hawser_scene *scene, const char *text)
{
	*source = (struct hawser_map_source){.scene = scene, .quantity = "multiplier",
		.waves = source->waves,
		.key = {"Omega", "travel.fluctuation"}, .from = {10.2, 0.1}, .to = {10.5, 9.0}};
	return !read_text(scene, text, NULL, NULL) && !hawser_hill_cable_open(field, source, NULL) &&
	       field->m <= MOST;
}

/* The square of the largest logarithm of a modulus, 0 where none is above round-off: near an edge it is
 * linear in Omega. */
static double square(const struct hawser_hill_field *field, double omega, double at)
{
	double log_modulus[MOST], argument[MOST];

	if (field->multipliers(field->context, log_modulus, argument, omega, at, NULL))
		return NAN;
	return log_modulus[0] > 1e-6 ? log_modulus[0]*log_modulus[0] : 0.0;
}

/* The edge near `guess` of a region that ends at `other`, from points inside: the square is the product
 * of both distances and a slowly varying factor. */
static double edge(const struct hawser_hill_field *field, double guess, double other, double at)
{
	double wide = other - guess, a = guess + 0.02*wide, b = guess + 0.06*wide;
	double f = square(field, a, at)/(other - a), g = square(field, b, at)/(other - b);

	return a - f*(b - a)/(g - f);
}

/* The model that map and hill choose there: the span of 8 complex modes. To 1e-3 of the width, beside
 * the rounding of the outside figures. */
static void outside(void)
{
	static const double known[][3] = {
		{2.0, 10.3043, 10.3608}, {0.5, 10.3266, 10.3408}, {8.0, 10.2039, 10.4241}};
	struct hawser_hill_field field = {.m = 0};
	struct hawser_map_source source = {.waves = WAVES};
	struct hawser_scene scene = {.loads = 0};
	int good = open_field(&field, &source, &scene, LEVEL);

	ok(good && field.responds && field.m == 4*WAVES, "the field is about the response");
	for (size_t k = 0; good && k < sizeof known/sizeof *known; k++) {
		double low = edge(&field, known[k][1], known[k][2], known[k][0]);
		double high = edge(&field, known[k][2], known[k][1], known[k][0]);
		double enough = 5e-5 + 1e-3*(known[k][2] - known[k][1]);

		ok(fabs(low - known[k][1]) < enough && fabs(high - known[k][2]) < enough,
		   "fluctuation %g m/s: %.5f to %.5f rad/s for %.4f to %.4f", known[k][0], low, high,
		   known[k][1], known[k][2]);
	}
	hawser_hill_cable_close(&field);
	hawser_scene_clear(&scene);
}

/* --- the stated error --- */

/* Of the scene's model (waves = 0) or the span of so many complex modes, at 2 m/s, from edges near
 * it. */
static struct hawser_map_shift stated(const char *text, int waves, int rest, double low, double high)
{
	double at[2] = {low, high};
	const struct hawser_map_line line = {2.0, 2, at};
	struct hawser_scene scene = {.loads = 0};
	struct hawser_map_source source = {.scene = &scene, .quantity = "multiplier", .waves = waves,
		.rest = rest, .key = {"Omega", "travel.fluctuation"}, .from = {10.2, 0.1}, .to = {10.5, 9.0}};
	struct hawser_map_source better = source;
	struct hawser_map_shift shift = {.compared = 0};

	better.waves = waves > 0 ? waves + 4 : WAVES;
	if (!read_text(&scene, text, NULL, NULL) &&
	    hawser_map_shift(&shift, &source, &better, 0, &line, 1, NULL))
		shift.compared = -1;
	hawser_scene_clear(&scene);
	return shift;
}

static void errors(void)
{
	struct hawser_map_shift own = stated(LEVEL, WAVES, 0, 10.304258, 10.360762);
	struct hawser_map_shift modes = stated(LEVEL "model: {modes: 12}\n", 0, 0, 10.3058, 10.3624);

	ok(own.compared == 2 && own.share < 1e-3 && own.distance > 1.7e-5,
	   "8 complex modes: %.1e rad/s stated, 1.7e-5 true (exact energy), %.1e of the width",
	   own.distance, own.share);
	ok(modes.compared == 2 && modes.distance > 0.0016 && modes.distance < 0.004,
	   "12 modes: %.1e rad/s stated, 0.0015 and 0.0016 true", modes.distance);
}

/* About rest, with alpha 0.1: the figures of 40 modes, which are off by some 5e-5 (20 modes: 10.3216 to
 * 10.3452). */
static double rest_edge(const struct hawser_map_field *field, void *worker, double stable,
                        double unstable)
{
	struct hawser_map_sample sample;

	for (int i = 0; i < 14; i++) {
		double middle = 0.5*(stable + unstable), at = 2.0;

		if (field->prepare(field->context, &middle, &at, 1, 1, NULL) ||
		    field->point(worker, &sample, NULL, middle, at, NULL))
			return NAN;
		*(sample.number > 0 ? &unstable : &stable) = middle;
	}
	return unstable;
}

static void about_rest(void)
{
	struct hawser_map_field field;
	struct hawser_scene scene = {.loads = 0};
	struct hawser_map_source source = {.scene = &scene, .quantity = "multiplier", .waves = WAVES,
		.rest = 1, .key = {"Omega", "travel.fluctuation"}, .from = {10.2, 0.1}, .to = {10.5, 9.0}};
	void *worker = NULL;
	int good = !read_text(&scene, LEVEL "damping: {alpha: 0.1}\n", NULL, NULL) &&
	           !hawser_map_cable_open(&field, &source, NULL) &&
	           !field.open(&worker, field.context, NULL);
	double low = good ? rest_edge(&field, worker, 10.30, 10.333) : NAN;
	double high = good ? rest_edge(&field, worker, 10.36, 10.333) : NAN;
	struct hawser_map_shift shift = stated(LEVEL "damping: {alpha: 0.1}\n", WAVES, 1, low, high);

	ok(fabs(low - 10.3212) < 1e-4 + shift.distance && fabs(high - 10.3449) < 1e-4 + shift.distance,
	   "alpha 0.1, about rest: %.5f to %.5f rad/s, %.1e stated, for 10.3212 to 10.3449", low, high,
	   shift.distance);
	ok(shift.compared == 2 && shift.share < 2e-2,
	   "%.1e of the width, by what follows without inertia", shift.share);
	field.close(worker);
	hawser_map_cable_close(&field);
	hawser_scene_clear(&scene);
}

/* --- three ways --- */

static double by_map(const struct hawser_map_source *source, double omega, double at)
{
	struct hawser_map_sample sample = {.code = HAWSER_MAP_OK};
	struct hawser_map_field field;
	void *worker = NULL;
	int good = !hawser_map_cable_open(&field, source, NULL) &&
	           !field.open(&worker, field.context, NULL) &&
	           !field.prepare(field.context, &omega, &at, 1, 1, NULL) &&
	           !field.point(worker, &sample, NULL, omega, at, NULL) &&
	           sample.code == HAWSER_MAP_OK && field.responds == !source->rest;

	field.close(worker);
	hawser_map_cable_close(&field);
	return good ? sample.value : NAN;
}

static double by_response(struct hawser_scene *scene, double omega, double at)
{
	const struct hawser_modes_options options = {.n = 6};
	struct hawser_frf_options choice = {.max_points = 1, .samples = HAWSER_NONE,
	                                    .tolerance = 1e-10};
	struct hawser_modes modes = {.n = 0};
	struct hawser_rom rom = {.n = 0};
	struct hawser_frf frf = {.n = 0};
	struct hawser_statics statics;
	double most = NAN;

	scene->travel.fluctuation = at;
	if (!hawser_statics_scene(&statics, scene, NULL) &&
	    !hawser_modes_solve(&modes, &statics, &options, NULL) &&
	    !hawser_rom_build(&rom, &modes, scene, NULL)) {
		choice.from = omega*rom.time;
		choice.to = 1.1*choice.from;
		if (!hawser_frf_trace(&frf, &rom, &choice, NULL))
			most = frf.multiplier[0];
	}
	hawser_frf_clear(&frf);
	hawser_rom_clear(&rom);
	hawser_modes_clear(&modes);
	return most;
}

static void three_ways(void)
{
	static const double at[][2] = {{10.31, 5.0}, {10.36, 6.3}, {10.25, 4.0}};
	struct hawser_hill_field field = {.m = 0};
	struct hawser_map_source source = {.waves = 0};
	struct hawser_scene scene = {.loads = 0};
	double growth, edges[2], decay = 0.0;
	int good = open_field(&field, &source, &scene, INCLINED);

	for (int k = 0; good && k < 3; k++) {
		double log_modulus[MOST], argument[MOST], map, response;

		good = !field.multipliers(field.context, log_modulus, argument, at[k][0], at[k][1], NULL);
		map = by_map(&source, at[k][0], at[k][1]);
		response = by_response(&scene, at[k][0], at[k][1]);
		ok(fabs(log(map) - response) < 1e-8 && fabs(log_modulus[0] - response) < 1e-8,
		   "%g rad/s, %g m/s: log %.9g by frf, %.9g by map, %.9g by hill", at[k][0], at[k][1],
		   response, log(map), log_modulus[0]);
		decay = log_modulus[0]*at[k][0]/(2.0*M_PI);
	}
	source.orbit = 1e-9; /* as hill has it */
	source.quantity = "growth";
	source.orbit = 1e-8; /* the responses of hill */
	growth = by_map(&source, at[2][0], at[2][1]);
	close_to(growth, decay, 1e-10, "growth from the multipliers");
	ok(growth < 0.0, "it is negative where all motions decay: %g", growth);
	source.quantity = "multiplier";
	source.rest = 1;
	edges[0] = by_map(&source, at[0][0], at[0][1]);
	source.rest = 0;
	edges[1] = by_map(&source, at[0][0], at[0][1]);
	ok(fabs(edges[0] - edges[1]) > 1e-3, "about rest %.6f, about the response %.6f", edges[0],
	   edges[1]);
	hawser_hill_cable_close(&field);
	hawser_scene_clear(&scene);
}

CASE(reference_response_edges)
{
	outside();
	errors();
	about_rest();
	three_ways();
	return done_testing();
}
