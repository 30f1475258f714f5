/* The stability of the same motion must be the same by map, hill, hill --Omega and the frequency
 * response, for a scene and for its exported model: random scenes at rest and travelling, with
 * loads in and out of the plane, and every treatment of omitted modes. Then two scenes whose
 * results are known from a full-order program.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <unistd.h>

#include <hawser/frf.h>
#include <hawser/hill.h>
#include <hawser/linear.h>
#include <hawser/map.h>

#include "tests/tap.h"
#include "tests/unit/scene-text.h"

enum { MOST = 64 }; /* multipliers */

static unsigned long long state = 2385;

static double drawn(double from, double to)
{
	state = state*6364136223846793005ULL + 1442695040888963407ULL;
	return from + (to - from)*(double)(state >> 11)/9007199254740992.0;
}

/* --- a random scene --- */

static const char *const damping[] = {"ratio: %.4g", "alpha: %.4g",
                                      "rayleigh: {mass: %.4g, stiffness: 1e-5}"};
static const char *const damping_key[] = {"damping.ratio", "damping.alpha", "damping.rayleigh.mass"};

struct drawn_scene {
	struct hawser_scene scene;
	const char *keys[4]; /* as a second axis that keeps the scene's value */
};

static int draw(struct drawn_scene *to, char *text, size_t size)
{
	double d = pow(10.0, drawn(0.5, 2.6)), h = d*drawn(-0.5, 0.5), rho = drawn(0.3, 20.0);
	double sag = d*pow(10.0, drawn(-2.3, -0.9)), H = rho*9.81*d*d/(8.0*sag), wave = sqrt(H/rho);
	int kind = (int)drawn(0.0, 5.0), damped = (int)drawn(0.0, 3.0), length;
	double rate = 0.002*wave/d, size_of[] = {drawn(1e-4, 0.02), rate*rho, rate};
	char D[128];

	snprintf(D, sizeof D, damping[damped], size_of[damped]);
	length = snprintf(text, size, "cable: {EA: %.6g, rho: %.6g}\nspan: {d: %.6g, h: %.6g}\n"
	                  "tension: {sag: %.6g}\ndamping: {%s}\n"
	                  "model: {modes: %d, condense: %s, inertia: %s}\n",
	                  H*pow(10.0, drawn(2.0, 4.5)), rho, d, h, sag, D, (int)drawn(1.0, 7.0),
	                  drawn(0.0, 1.0) < 0.3 ? "none" : "static",
	                  drawn(0.0, 1.0) < 0.5 ? "auto" : "none");
	if (kind < 3)
		length += snprintf(text + length, size - (size_t)length, "load: {frame: %s, per_length: "
		                   "[%.4g, %.4g, %.4g], extent: [%.3g, %.3g]}\n",
		                   kind == 2 ? "global" : "local",
		                   kind == 1 ? 0.0 : rho*drawn(0.1, 8.0),
		                   kind == 0 ? 0.0 : rho*drawn(0.01, 1.0),
		                   kind == 0 ? 0.0 : rho*drawn(0.01, 1.0), kind == 2 ? drawn(0.0, 0.4) : 0.0,
		                   kind == 2 ? drawn(0.6, 1.0) : 1.0);
	else
		length += snprintf(text + length, size - (size_t)length, "travel: {speed: %.4g, fluctuation: "
		                   "%.4g, hold: %s}\n", wave*drawn(0.01, 0.2), wave*drawn(0.01, 0.2),
		                   kind == 3 ? "tension" : "length");
	to->keys[0] = damping_key[damped];
	to->keys[1] = kind < 3 ? "load.per_length[0]" : "travel.fluctuation";
	to->keys[2] = "cable.rho";
	to->keys[3] = "factor.load";
	return length < (int)size && !read_text(&to->scene, text, NULL, NULL);
}

/* --- the answers --- */

struct answer {
	double largest;
	int outside;
};

static struct answer of_list(const double *log_modulus, int m)
{
	struct answer answer = {log_modulus[0], 0};

	for (int i = 0; i < m; i++)
		answer.outside += log_modulus[i] > 1e-8;
	return answer;
}

static void source_of(struct hawser_map_source *source, const struct hawser_scene *scene,
                      const struct hawser_rom *rom, const char *key)
{
	*source = (struct hawser_map_source){.scene = scene, .rom = rom, .key = {"Omega", key},
		.quantity = "multiplier", .rest = 1};
}

static int by_map(struct answer *answer, const struct hawser_map_source *source, double omega,
                  double at, struct hawser_report *report)
{
	struct hawser_map_sample sample = {.code = HAWSER_MAP_OK};
	struct hawser_map_field field;
	void *worker = NULL;
	int good = !hawser_map_cable_open(&field, source, report) &&
	           !field.open(&worker, field.context, report) &&
	           !field.prepare(field.context, &omega, &at, 1, 1, report) &&
	           !field.point(worker, &sample, NULL, omega, at, report) && sample.code == HAWSER_MAP_OK;

	*answer = (struct answer){log(sample.value), sample.number};
	if (field.close)
		field.close(worker);
	hawser_map_cable_close(&field);
	return good;
}

static int by_hill(struct answer *answer, const struct hawser_map_source *source, double omega,
                   double at, struct hawser_report *report)
{
	double log_modulus[MOST], argument[MOST];
	struct hawser_hill_field field;
	int good = !hawser_hill_cable_open(&field, source, report) && field.m <= MOST &&
	           !field.multipliers(field.context, log_modulus, argument, omega, at, report);

	if (good)
		*answer = of_list(log_modulus, field.m);
	hawser_hill_cable_close(&field);
	return good;
}

static int by_linear(struct answer *answer, double *error, const struct hawser_rom *rom, double omega,
                     struct hawser_report *report)
{
	double log_modulus[MOST], argument[MOST];
	struct hawser_linear *linear = NULL;
	int good = 2*rom->n <= MOST && !hawser_linear_open(&linear, rom->n, report) &&
	           !hawser_linear_multipliers(linear, log_modulus, argument, error, rom, omega*rom->time,
	                                      report);

	if (good)
		*answer = of_list(log_modulus, 2*rom->n);
	hawser_linear_free(linear);
	return good;
}

static int by_response(struct answer *answer, const struct hawser_rom *rom, double omega,
                       struct hawser_report *report)
{
	struct hawser_frf_options options = {.method = NULL};
	struct hawser_frf frf;
	int good;

	options.from = omega*rom->time;
	options.to = 1.1*options.from;
	options.max_points = 1;
	options.samples = HAWSER_NONE;
	good = !hawser_frf_trace(&frf, rom, &options, report) && frf.points > 0;
	if (good)
		*answer = of_list(frf.multiplier, 0);
	if (good) {
		answer->largest = frf.multiplier[0];
		answer->outside = frf.point[0].unstable;
	}
	hawser_frf_clear(&frf);
	return good;
}

/* Multipliers that coincide, or are near the circle, are counted within their error. */
static int alike(const struct answer *a, const struct answer *b, double error)
{
	double near = 1e-9 + 10.0*error;

	return fabs(a->largest - b->largest) <= near*fmax(1.0, fabs(a->largest)) &&
	       (a->outside == b->outside || fabs(a->largest) <= 1e-7 + near);
}

static int exported(struct hawser_rom *back, const struct hawser_rom *rom)
{
	char path[] = "stability-XXXXXX";
	int fd = mkstemp(path), good = fd >= 0;

	if (!good)
		return 0;
	close(fd);
	good = !hawser_rom_save(rom, path, NULL) && !hawser_rom_open(back, path, NULL);
	unlink(path);
	return good;
}

/* One frequency by all routes. Returns the number of multipliers outside, or -1 if they differ. */
static int compare(const struct drawn_scene *drawn_scene, const struct hawser_rom *rom,
                   const struct hawser_rom *back, double omega, int responds)
{
	struct hawser_report report = {.message = ""};
	struct hawser_map_source source;
	struct answer want, got;
	double error;
	int same = by_linear(&want, &error, rom, omega, &report);

	for (int k = 0; same && k < 4; k++) {
		const char *key = drawn_scene->keys[k];
		double at = 1.0;

		if (k < 3 && hawser_scene_get(&drawn_scene->scene, &at, key, &report))
			return -1;
		source_of(&source, &drawn_scene->scene, NULL, key);
		same = by_map(&got, &source, omega, at, &report) && alike(&want, &got, error);
		if (!same)
			printf("# map over %s: %.12g, %d for %.12g, %d; %s\n", key, got.largest, got.outside,
			       want.largest, want.outside, report.message);
	}
	if (same) {
		same = by_hill(&got, &source, omega, 1.0, &report) && alike(&want, &got, error);
		source_of(&source, NULL, back, "factor.load");
		same = same && by_map(&got, &source, omega, 1.0, &report) && alike(&want, &got, error) &&
		       by_hill(&got, &source, omega, 1.0, &report) && alike(&want, &got, error);
		if (!same)
			printf("# hill, or the file: %.12g, %d for %.12g, %d; %s\n", got.largest, got.outside,
			       want.largest, want.outside, report.message);
	}
	if (same && responds) {
		struct answer a = {0.0, 0}, b = a;

		same = by_response(&a, rom, omega, &report) == by_response(&b, back, omega, &report) &&
		       alike(&a, &b, 1e-8);
	}
	return same ? want.outside : -1;
}

static void random_scenes(int count)
{
	int compared = 0, unstable = 0, differ = 0;

	for (int i = 0; i < count; i++) {
		struct drawn_scene one = {.keys = {NULL}};
		struct hawser_modes modes = {.n = 0};
		struct hawser_rom rom = {.n = 0}, back = {.n = 0};
		struct hawser_statics statics;
		char text[1024];
		struct hawser_modes_options options = {.n = 0};

		if (!draw(&one, text, sizeof text)) {
			ok(0, "a scene: %s", text);
			continue;
		}
		options.n = one.scene.model.modes;
		if (!hawser_statics_scene(&statics, &one.scene, NULL) &&
		    !hawser_modes_solve(&modes, &statics, &options, NULL) &&
		    !hawser_rom_build(&rom, &modes, &one.scene, NULL) && exported(&back, &rom)) {
			int j = (int)drawn(0.0, modes.n), k = (int)drawn(0.0, modes.n), m = 1 + (i&1), found;
			double sum = (modes.mode[j].omega + modes.mode[k].omega)/modes.time_unit;

			found = compare(&one, &rom, &back, sum/m*drawn(0.998, 1.002), i%4 == 0);
			if (found < 0)
				printf("# scene %d, not the same answer:\n%s", i, text);
			compared++;
			unstable += found > 0;
			differ += found < 0;
		}
		hawser_rom_clear(&rom);
		hawser_rom_clear(&back);
		hawser_modes_clear(&modes);
		hawser_scene_clear(&one.scene);
	}
	ok(compared > count/2 && unstable > compared/20 && differ == 0,
	   "%d random scenes, %d of them unstable: %d with different answers", compared, unstable, differ);
}

/* --- scenes that were known --- */

static void known(const char *text, const char *key, double omega, double want, double tolerance)
{
	struct hawser_report report = {.message = ""};
	struct hawser_map_source source;
	struct hawser_scene scene;
	struct answer answer = {0.0, 0};
	double at;
	int good;

	if (!ok(!read_text(&scene, text, NULL, &report) && !hawser_scene_get(&scene, &at, key, &report),
	        "the scene: %s", report.message))
		return;
	source_of(&source, &scene, NULL, key);
	good = by_map(&answer, &source, omega, at, &report);
	ok(good && fabs(exp(answer.largest) - want) < tolerance && answer.outside > 0,
	   "map: %.5f, %d outside, for %.5f; %s", exp(answer.largest), answer.outside, want,
	   report.message);
	good = by_hill(&answer, &source, omega, at, &report);
	ok(good && fabs(exp(answer.largest) - want) < tolerance, "hill: %.5f; %s", exp(answer.largest),
	   report.message);
	hawser_scene_clear(&scene);
}

/* The load drives no kept mode: the response is rest, and the multipliers are the same. */
static void about_a_response(void)
{
	static const char text[] = "cable: {EA: 1 MN, rho: 2}\nspan: {d: 50, h: 0}\ntension: {sag: 0.7}\n"
	                           "damping: {ratio: 0.001}\nload: {frame: local, per_length: [0, 6, 0]}\n"
	                           "model: {modes: 1, inertia: none}\n";
	struct hawser_report report = {.message = ""};
	struct hawser_modes modes = {.n = 0};
	struct hawser_rom rom = {.n = 0};
	struct hawser_map_source source;
	struct hawser_statics statics;
	struct hawser_scene scene;
	const struct hawser_modes_options options = {.n = 1};
	struct answer rest = {0.0, 0}, response = {1.0, 0};
	double omega = 0.0;
	int good = !read_text(&scene, text, NULL, &report) &&
	           !hawser_statics_scene(&statics, &scene, &report) &&
	           !hawser_modes_solve(&modes, &statics, &options, &report) &&
	           !hawser_rom_build(&rom, &modes, &scene, &report);

	if (good) {
		omega = 2.0*modes.mode[0].omega/modes.time_unit;
		source_of(&source, &scene, NULL, "damping.ratio");
		good = modes.mode[0].plane == HAWSER_OUT_OF_PLANE &&
		       by_map(&rest, &source, omega, 0.001, &report) &&
		       by_response(&response, &rom, omega, &report);
	}
	ok(good && rest.outside == 1 && alike(&rest, &response, 1e-10),
	   "in-plane load on an out-of-plane mode: %.9g about rest, %.9g about the response; %s",
	   rest.largest, response.largest, report.message);
	hawser_rom_clear(&rom);
	hawser_modes_clear(&modes);
	hawser_scene_clear(&scene);
}

/* For the full-order model multipliers about rest are refused, since at rest nothing excites it
 * parametrically. */
static void refused(void)
{
	static const char text[] = "cable: {EA: 1 MN, rho: 2}\nspan: {d: 50, h: 0}\ntension: {sag: 0.7}\n"
	                           "damping: {ratio: 0.001}\nload: {frame: local, per_length: [0, 6, 0]}\n"
	                           "model: {energy: exact, basis: 4}\n";
	struct hawser_report report = {.message = ""};
	struct hawser_map_source source;
	struct hawser_map_field field;
	struct hawser_statics statics;
	struct hawser_scene scene;
	struct hawser_rom rom = {.n = 0};
	struct answer answer;
	double error;
	int good = !read_text(&scene, text, NULL, &report) &&
	           !hawser_statics_scene(&statics, &scene, &report) &&
	           !hawser_rom_build_full(&rom, &statics, &scene, 4, &report);

	source_of(&source, &scene, NULL, "damping.ratio");
	ok(good && hawser_map_cable_open(&field, &source, &report) == HAWSER_ERR_ARGUMENT, "%s",
	   report.message);
	ok(good && !by_linear(&answer, &error, &rom, 3.0, &report), "%s", report.message);
	hawser_rom_clear(&rom);
	hawser_scene_clear(&scene);
}

CASE(property_same_stability)
{
	/* full order with the exact energy, about the response: 1.01965; the model of 5 modes has 1.02065,
	 * and 1.02066 without the response to the load as a field */
	known("cable: {EA: 400 MN, rho: 6 kg/m}\nspan: {d: 250 m, h: 10 m}\ntension: {T0: 80 kN}\n"
	      "damping: {ratio: 0.01 %}\nload: {frame: local, per_length: [40 N/m, 0, 0]}\n"
	      "model: {modes: 5}\n", "damping.ratio", 4.345, 1.02065, 1e-5);
	/* full order: 1.01393 */
	known("cable: {EA: 9 MN, rho: 2.2 kg/m}\nspan: {d: 40 m, h: -22 m}\ntension: {sag: 1.1 m}\n"
	      "damping: {ratio: 0.4 %}\ntravel: {speed: 3, fluctuation: 4, hold: length}\n"
	      "model: {modes: 7}\n", "travel.fluctuation", 13.0, 1.01393, 1e-5);
	about_a_response();
	refused();
	random_scenes(getenv("HAWSER_LONG") ? 200 : 24);
	return done_testing();
}
