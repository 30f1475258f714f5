/* Linear stability: growth rates and multipliers in closed form, independence of earlier calls, and
 * each failure; keys of a scene set by number.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdio.h>

#include <hawser/hawser.h>

#include "tests/tap.h"
#include "tests/unit/scene-text.h"

static void growth(struct hawser_linear *linear)
{
	/* u'' + 2 nu G u' + K u with K = -1, -1.44: gyroscopically stable where 4 nu^2 > (1 + 1.2)^2 */
	double K[4] = {-1.0, 0.0, 0.0, -1.44}, D[4] = {0.0, 2.5, -2.5, 0.0}, w[2], most;
	struct hawser_rom rom = {.n = 2, .K = K, .D = D, .time = 1.0};
	struct hawser_report report = {.status = HAWSER_OK};
	enum hawser_status status = hawser_linear_growth(linear, &most, &(int){0}, w, &rom, &report);
	int growing;
	/* w^4 - (nu^2 - 2.44) w^2 + 1.44 = 0 */
	double sum = 6.25 - 2.44, low = 0.5*(sum - sqrt(sum*sum - 4.0*1.44));

	ok(!status && most == 0.0, "stabilised by gyroscopic terms: %g", most);
	D[0] = 1e-11;
	status = hawser_linear_growth(linear, &most, &(int){0}, w, &rom, &report);
	ok(!status && most > 1e-13 && most < 1e-10, "what little grows is not round-off: %g", most);
	D[0] = 0.0;
	close_to(w[0], sqrt(low), 1e-13, "slow frequency");
	close_to(w[1], 1.2/sqrt(low), 1e-13, "fast frequency");
	D[1] = D[2] = 0.0;
	D[0] = 0.3;
	status = hawser_linear_growth(linear, &most, &growing, w, &rom, &report);
	ok(!status && growing == 2 && w[0] == 0.0 && w[1] == 0.0, "both grow without: %d", growing);
	close_to(most, 1.2, 1e-13, "at the larger rate");
	K[3] = NAN;
	status = hawser_linear_growth(linear, &most, &growing, w, &rom, &report);
	ok(status == HAWSER_ERR_NAN && strstr(report.message, "entry 1, 1 of the model's stiffness K"),
	   "%s", report.message);
}

static void multipliers(struct hawser_linear *linear)
{
	double K[4] = {1.0, 0.0, 0.0, 90.0}, D[4] = {0.06, 0.0, 0.0, 0.4}, K1[4] = {0.3, 0.1, 0.1, 2.0};
	struct hawser_harmonic harmonic = {.k = 1, .phase = HAWSER_COS, .K = K1};
	struct hawser_rom rom = {.n = 2, .K = K, .D = D, .time = 1.0}, excited = rom;
	struct hawser_report report = {.status = HAWSER_OK};
	double modulus[2][4], argument[4], error;
	enum hawser_status status = hawser_linear_multipliers(linear, modulus[0], argument, &error, &rom,
	                                                      1.3, &report);

	ok(!status && error < 1e-9, "without excitation, stated error %.1e", error);
	close_to(modulus[0][0], -0.03*2.0*M_PI/1.3, 1e-10, "the slow one decays by its damping");
	close_to(modulus[0][3], -0.2*2.0*M_PI/1.3, 1e-10, "so does the fast one");
	excited.harmonics = 1;
	excited.harmonic = &harmonic;
	status = hawser_linear_multipliers(linear, modulus[0], argument, &error, &excited, 2.0, &report);
	ok(!status && modulus[0][0] > 0.0, "twice the frequency excites: %g", modulus[0][0]);
	close_to(modulus[0][0] + modulus[0][1] + modulus[0][2] + modulus[0][3], -0.46*M_PI, 1e-10,
	         "Liouville");
	status = hawser_linear_multipliers(linear, modulus[1], argument, &error, &excited, 0.11, &report);
	ok(!status, "a slow excitation");
	status = hawser_linear_multipliers(linear, modulus[1], argument, &error, &excited, 2.0, &report);
	ok(!status && memcmp(modulus[0], modulus[1], sizeof *modulus) == 0,
	   "leaves no trace in the next result");
	status = hawser_linear_multipliers(linear, modulus[1], argument, &error, &excited, 0.0, &report);
	ok(status == HAWSER_ERR_ARGUMENT && strstr(report.message, "must be positive"), "%s",
	   report.message);
	D[0] = INFINITY;
	status = hawser_linear_multipliers(linear, modulus[1], argument, &error, &excited, 2.0, &report);
	ok(status == HAWSER_ERR_NAN && strstr(report.message, "entry 0, 0 of the model's damping D"), "%s",
	   report.message);
}

static void set(struct hawser_scene *scene, const char *path, double value, enum hawser_status want,
                const char *message)
{
	struct hawser_report report = {.status = HAWSER_OK};
	enum hawser_status status = hawser_scene_set(scene, path, value, &report);
	double got = NAN;

	if (!status)
		status = hawser_scene_get(scene, &got, path, NULL);
	ok(status == want && (want ? strstr(report.message, message) != NULL : got == value),
	   "%s = %g: %s", path, value, want ? report.message : "set");
}

static void scenes(void)
{
	static const char text[] = "cable: {EA: 100 MN, rho: 5}\nspan: {d: 80, h: 5}\n"
		"tension: {H: 8e4}\nload: {frame: local, per_length: [0, 1, 2], extent: [0, 0.5]}\n";
	struct hawser_scene scene;

	if (!ok(!read_text(&scene, text, NULL, NULL), "a scene"))
		return;
	set(&scene, "span.h", -3.25, HAWSER_OK, "");
	set(&scene, "load.per_length[2]", 7.5, HAWSER_OK, "");
	set(&scene, "load.extent[0]", 0.25, HAWSER_OK, "");
	set(&scene, "model.modes", 7.0, HAWSER_OK, "");
	set(&scene, "load.extent[0]", 0.5, HAWSER_ERR_SCENE, "out of range");
	set(&scene, "model.modes", 7.5, HAWSER_ERR_SCENE, "a whole number, within [1, 1000]");
	set(&scene, "tension.H", -1.0, HAWSER_ERR_SCENE,
	    "tension.H = -1 N is out of range: it must be > 0");
	set(&scene, "tension.T0", 1.0, HAWSER_ERR_ARGUMENT, "does not give tension.T0");
	set(&scene, "span.q", 1.0, HAWSER_ERR_ARGUMENT, "no key span.q");
	hawser_scene_clear(&scene);
}

CASE(unit_linear)
{
	struct hawser_linear *linear;

	if (!ok(hawser_linear_open(&linear, 2, NULL) == HAWSER_OK, "a workspace"))
		return done_testing();
	growth(linear);
	multipliers(linear);
	hawser_linear_free(linear);
	hawser_linear_free(NULL);
	scenes();
	return done_testing();
}
