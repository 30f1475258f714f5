/* Vortex shedding: a string with wake oscillators at eight places, and one with an oscillator for its
 * mode, against numbers of the equations of a sine (collocation and shooting agree on them). The cables
 * are thin, stiff and weightless, so that they are strings.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include <hawser/integrate.h>

#include "tests/tap.h"
#include "tests/unit/scene-text.h"

static struct hawser_report report;

static const char string[] =
	"g: 0.001\ncable: {EA: 5 MN, rho: %.17g}\nspan: {d: 40 m, h: 0 m}\n"
	"tension: {H: 200 N, state: loaded}\ndamping: {ratio: %g}\nwind: {speed: %.17g,\n"
	"  direction: [0, 1, 0], density: 1000, diameter: 4 mm, wake: {at: %s, lift: %.17g}}\n";

static int build(struct hawser_rom *rom, const char *text)
{
	const struct hawser_modes_options options = {.n = 2};
	struct hawser_scene scene;
	struct hawser_statics statics;
	struct hawser_modes modes = {.n = 0};
	int done;

	*rom = (struct hawser_rom){.n = 0};
	if (!ok(!read_text(&scene, text, NULL, &report), "a scene %s", report.message))
		return 0;
	done = ok(!hawser_statics_scene(&statics, &scene, &report) &&
	          !hawser_modes_solve(&modes, &statics, &options, &report) &&
	          !hawser_rom_build(rom, &modes, &scene, &report), "a model %s", report.message);
	hawser_modes_clear(&modes);
	hawser_scene_clear(&scene);
	return done;
}

/* Half the height of the motion at mid-span over the diameter after 130 s, and its frequency in rad/s
 * from the times at which it passes 0 upwards. */
static double settled(double *omega, const struct hawser_rom *rom)
{
	enum { last = 1000 };
	double *initial = calloc(2*(size_t)rom->n, sizeof *initial), most = 0.0, first = NAN, now = NAN;
	double before = NAN;
	const struct hawser_integrate_options options = {
		.until = 130.0/rom->time, .every = 0.01/rom->time, .rtol = 1e-7, .atol = 1e-11,
		.initial = initial};
	struct hawser_trajectory run = {.rows = 0};
	int passed = 0;

	initial[0] = 0.001/rom->length;
	for (int j = 2; j < rom->n; j++)
		initial[j] = 2.0/rom->length;
	ok(!hawser_integrate(&run, rom, &options, &report), "a run %s", report.message);
	for (int i = run.rows > last ? run.rows - last : 0; i < run.rows; i++) {
		const struct hawser_rom_moment still = {.omega = 1.0};
		double at[3], z;

		hawser_rom_displacement_at(rom, at, 1, run.state + (size_t)i*2*(size_t)rom->n, &still);
		z = at[2]*rom->length;
		most = fmax(most, fabs(z));
		if (before < 0.0 && z >= 0.0) {
			now = 0.01*(i - z/(z - before));
			first = passed++ ? first : now;
		}
		before = z;
	}
	*omega = 2.0*acos(-1.0)*(passed - 1)/(now - first);
	hawser_trajectory_clear(&run);
	free(initial);
	return most/0.004;
}

static void check(const char *at, double mass, double ratio, double lift, double reduced, double want,
                  double frequency)
{
	const double pi = acos(-1.0), added = 1000.0*pi/4.0*16e-6, first = pi/40.0*sqrt(200.0/mass);
	struct hawser_rom rom;
	char text[512];
	double omega, size;

	/* reduced: 2 pi St U/D over the natural frequency */
	snprintf(text, sizeof text, string, mass - added, ratio, reduced*first*0.004/(0.4*pi), at, lift);
	if (build(&rom, text)) {
		size = settled(&omega, &rom);
		close_to(size, want, 5e-4, "amplitude at mid-span over the diameter");
		close_to(omega/first, frequency, 2e-4, "frequency over that of the string");
	}
	hawser_rom_clear(&rom);
}

CASE(reference_wakes)
{
	/* mass 2.5 density D^2, lift 0.02 16 pi^2 St^2 2.5; at Ur = 5 of a mass of 2.0354 density D^2 */
	check("8", 0.04, 0.0031, 0.02*4.0*acos(-1.0)*acos(-1.0)*0.16*2.5, 1.1, 0.312651486, 1.01708683);
	check("modes", 0.0325663706, 0.003, 0.3, 1.0, 0.2523133, 0.962911/0.979580949);
	return done_testing();
}
