/* Condensed modes near and below the forcing frequency: displacement, velocity and tension contain
 * their linear response, against sums over all modes of a basis.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <complex.h>
#include <stdlib.h>
#include <unistd.h>

#include <hawser/accuracy.h>
#include "tests/tap.h"
#include "tests/velocity.h"

enum { FUNCTIONS = 24, PHASES = 8 };

static unsigned long long seed = 2385;

/* Uniform in (from, to). */
static double draw(double from, double to)
{
	seed = seed*6364136223846793005ULL + 1442695040888963407ULL;
	return from + (to - from)*(double)(seed >> 11)/9007199254740992.0;
}

static struct hawser_scene scene_of(double EA, double rho, double d, double h, double sag,
                                    double ratio, const double load[3])
{
	struct hawser_scene scene = {.cable = {.EA = EA, .rho = rho}, .span = {d, h}, .g = 9.81};

	scene.tension.given = HAWSER_GIVEN_SAG;
	scene.tension.value = sag;
	scene.load.present = 1;
	scene.load.frame = HAWSER_FRAME_GLOBAL;
	memcpy(scene.load.per_length, load, sizeof scene.load.per_length);
	scene.load.extent[1] = 1.0;
	scene.damping.kind = HAWSER_DAMPING_RATIO;
	scene.damping.ratio = ratio;
	scene.model.modes = HAWSER_MODES_AUTO;
	scene.model.accuracy = 0.01;
	scene.model.condense = HAWSER_CONDENSE_STATIC;
	scene.model.inertia = HAWSER_INERTIA_AUTO;
	return scene;
}

/* --- the reference: a linear model of all modes of a basis --- */

static int basis(struct hawser_rom *all, const struct hawser_statics *st,
                 const struct hawser_scene *scene)
{
	struct hawser_modes modes = {.n = 0};
	int failed = hawser_modes_basis(&modes, st, FUNCTIONS, FUNCTIONS, NULL) ||
	             hawser_rom_build_linear(all, &modes, scene, NULL);

	hawser_modes_clear(&modes);
	return failed;
}

/* Response of mode s to harmonic h: its phasor at the phase 0 of that harmonic. */
static double complex response(const struct hawser_rom *all, int h, int s, double omega)
{
	const struct hawser_harmonic *harmonic = &all->harmonic[h];
	double W = harmonic->k*omega, K = all->K[s*(all->n + 1)], D = all->D[s*(all->n + 1)];

	return harmonic->f[s]*pow(omega, harmonic->omega_power)*
	       (harmonic->phase == HAWSER_SIN ? -I : 1.0)/(K - W*W + I*W*D);
}

/* xyz [3] += phasor of the displacement at shape point p by harmonic h, of all modes except those
 * marked in left_out [all->n] (NULL: none). */
static void add_modes(double complex xyz[3], const struct hawser_rom *all, int h, int p,
                      const int *left_out, double omega)
{
	const double *tangent = all->shapes.tangent + 2*p;
	double complex local[3] = {0.0};

	for (int s = 0; s < all->n; s++)
		for (int i = 0; i < 3 && (!left_out || !left_out[s]); i++)
			local[i] += response(all, h, s, omega)*
			            all->shapes.shape[((size_t)s*all->shapes.points + p)*3 + i];
	xyz[0] += local[0]*tangent[0] - local[1]*tangent[1];
	xyz[1] += local[0]*tangent[1] + local[1]*tangent[0];
	xyz[2] += local[2];
}

/* --- the response to a requested accuracy, component by component --- */

/* Largest difference of a probe's amplitude at one frequency, relative to that of the same
 * component; components below `faint` of the largest one are compared with the largest one. */
static double difference(const double *probe, const struct hawser_rom *all, double omega, double faint)
{
	double want[9], most = 0.0, worst = 0.0;

	for (int p = 0; p < 3; p++) {
		double complex xyz[3] = {0.0};

		add_modes(xyz, all, 0, p, NULL, omega);
		for (int i = 0; i < 3; i++) {
			want[3*p + i] = cabs(xyz[i]);
			most = fmax(most, want[3*p + i]);
		}
	}
	for (int c = 0; c < 9; c++)
		worst = fmax(worst, fabs(probe[c] - want[c])/fmax(want[c], faint*most));
	return worst;
}

/* A load small enough for a linear motion. A choice of modes keeps those with the largest
 * displacements: here not the first out-of-plane mode, which is below the range. The static series
 * alone gives z at mid-span 6 to 14 times too large. */
static void check_scene(void)
{
	struct hawser_scene scene = scene_of(30e6, 3.0, 100.0, 0.0, 1.84, 0.005,
	                                     (const double[3]){5e-5, 4e-5, 5e-5});
	struct hawser_accuracy_options options = {.most = 0};
	struct hawser_accuracy accuracy = {.tries = 0};
	struct hawser_modes_options first = {.n = 1};
	struct hawser_modes modes = {.n = 0};
	struct hawser_rom all = {.n = 0};
	struct hawser_report report = {.message = ""};
	struct hawser_statics st;
	double worst = 0.0;

	if (!ok(!hawser_statics_scene(&st, &scene, &report) &&
	        !hawser_modes_solve(&modes, &st, &first, &report), "the span%s", report.message))
		return;
	options.frf.from = 1.7*modes.mode[0].omega;
	options.frf.to = 2.07*modes.mode[0].omega;
	options.frf.samples = HAWSER_NONE;
	if (ok(!hawser_accuracy_trace(&accuracy, &st, &scene, &options, &report) &&
	       !basis(&all, &st, &scene), "its response%s", report.message)) {
		for (int i = 0; i < accuracy.frf.points; i++)
			worst = fmax(worst, difference(accuracy.frf.probe + 9*(size_t)i, &all,
			                               accuracy.frf.point[i].omega, 1e-2));
		ok(accuracy.rom.n < 8 && worst < 2e-3, "%d modes for 1 %%: largest difference of a "
		   "component is %.1e of it at %d points", accuracy.rom.n, worst, accuracy.frf.points);
	}
	hawser_accuracy_clear(&accuracy);
	hawser_rom_clear(&all);
	hawser_modes_clear(&modes);
}

/* --- models in linear motion --- */

/* Amplitudes of the probes [9] of a model in linear motion under its first harmonic: the components
 * at the forcing frequency, from PHASES phases of a period. */
static void linear_motion(double *probe, const struct hawser_rom *rom, double omega)
{
	double complex sum[9] = {0.0};

	for (int t = 0; t < PHASES; t++) {
		struct hawser_rom_moment moment = {.tau = 2.0*M_PI*t/PHASES, .omega = omega};
		double u[100];

		for (int j = 0; j < rom->n; j++)
			u[j] = creal(response(rom, 0, j, omega)*cexp(I*moment.tau));
		for (int p = 0; p < 3; p++) {
			double xyz[3];

			hawser_rom_displacement_at(rom, xyz, p, u, &moment);
			for (int i = 0; i < 3; i++)
				sum[3*p + i] += 2.0/PHASES*xyz[i]*cexp(-I*moment.tau);
		}
	}
	for (int c = 0; c < 9; c++)
		probe[c] = cabs(sum[c]);
}

static double worst_over(const struct hawser_rom *rom, const struct hawser_rom *all, double from,
                         double to)
{
	double worst = 0.0;

	for (int i = 0; i < 15; i++) {
		double omega = from + i*(to - from)/14.0, probe[9];

		linear_motion(probe, rom, omega);
		worst = fmax(worst, difference(probe, all, omega, 5e-2));
	}
	return worst;
}

/* For a range about one of the six lowest modes: the model of a choice, and that of the n lowest
 * modes, also if the range is far above them. */
static void check_span(int number)
{
	double d = 50.0*draw(1.0, 4.0), rho = draw(0.5, 5.0);
	double sag = draw(0.005, 0.15)*d, EA = rho*9.81*d*d/(8.0*sag)/pow(10.0, draw(-5.0, -3.0));
	const double load[3] = {1e-4*draw(0.2, 1.0), 1e-4*draw(0.2, 1.0), 1e-4*draw(0.2, 1.0)};
	struct hawser_scene scene = scene_of(EA, rho, d, draw(-0.5, 0.5)*d, sag, draw(0.003, 0.03), load);
	struct hawser_modes_options six = {.n = 6}, few = {.n = 1 + (int)draw(0.0, 5.0)};
	struct hawser_modes modes = {.n = 0}, kept = {.n = 0}, looked_at = {.n = 0};
	struct hawser_rom all = {.n = 0}, rom = {.n = 0}, lowest = {.n = 0};
	struct hawser_choice choice = {.n = 0};
	struct hawser_report report = {.message = ""};
	struct hawser_statics st;
	double omega, from, to, off[2] = {0.0};
	int failed = hawser_statics_scene(&st, &scene, &report) ||
	             hawser_modes_solve(&modes, &st, &six, &report);

	omega = failed ? 1.0 : modes.mode[(int)draw(0.0, 6.0)].omega;
	from = omega*draw(0.8, 0.99);
	to = omega*draw(1.01, 1.2);
	failed = failed || basis(&all, &st, &scene) ||
	         hawser_accuracy_choose(&choice, &looked_at, &st, &scene, from, to, 0.01, &report) ||
	         hawser_choice_build(&rom, &choice, &scene, &report) ||
	         hawser_modes_solve(&kept, &st, &few, &report) ||
	         hawser_rom_build(&lowest, &kept, &scene, &report) ||
	         hawser_rom_know_below(&lowest, &kept, &scene, 4.0*to, &report);
	if (!failed) {
		off[0] = worst_over(&rom, &all, from, to);
		off[1] = worst_over(&lowest, &all, from, to);
	}
	ok(!failed && off[0] < 5e-3 && off[1] < 5e-3, "span %d, sag %.3g: %d chosen modes, largest "
	   "difference of a component %.1e of it; the lowest %d: %.1e%s", number, sag/d, rom.n, off[0],
	   lowest.n, off[1], report.message);
	hawser_choice_clear(&choice);
	hawser_modes_clear(&modes);
	hawser_modes_clear(&kept);
	hawser_modes_clear(&looked_at);
	hawser_rom_clear(&all);
	hawser_rom_clear(&rom);
	hawser_rom_clear(&lowest);
}

/* --- every harmonic, for a cable with a fluctuating speed --- */

enum { KEPT = 4, KNOWN = 30 };
static const int kept[KEPT] = {1, 4, 5, 11};

static void check_file(const struct hawser_rom *rom, double omega)
{
	const double u[KEPT] = {0.01, -0.02, 0.015, 0.004};
	struct hawser_rom_moment moment = {.tau = 1.1, .omega = omega};
	char name[] = "/tmp/hawser-known-XXXXXX";
	int file = mkstemp(name);
	struct hawser_rom back = {.n = 0};
	double a[3], b[3];

	if (!ok(file >= 0 && !hawser_rom_save(rom, name, NULL) && !hawser_rom_open(&back, name, NULL),
	        "to a file and back"))
		return;
	hawser_rom_displacement_at(rom, a, 2, u, &moment);
	hawser_rom_displacement_at(&back, b, 2, u, &moment);
	ok(!memcmp(a, b, sizeof a) && back.known.reach == rom->known.reach &&
	   hawser_rom_tension_at(rom, 1, u, &moment) == hawser_rom_tension_at(&back, 1, u, &moment),
	   "which keeps the known modes to the last bit");
	hawser_rom_clear(&back);
	close(file);
	remove(name);
}

/* Displacement and tension with the kept modes at rest, to first order, against sums over all other
 * modes of a basis: for modes above the known ones the relative error of the response is
 * (W/omega_s)^4. */
static void check_sums(const struct hawser_rom *full, const struct hawser_rom *all, double omega)
{
	struct hawser_rom first_order = *full;
	const struct hawser_rom *rom = &first_order;
	const double rest[KEPT] = {0.0};
	struct hawser_rom_moment moment = {.tau = 0.4, .omega = omega};
	int left_out[100] = {0};
	double most = 0.0, off = 0.0, pull[2] = {0.0}, limit;

	first_order.ends = NULL;
	for (int j = 0; j < KEPT; j++)
		left_out[kept[j]] = 1;
	for (int p = 0; p < 3; p++) {
		double got[3], want[3] = {0.0}, strain = 0.0;

		for (int h = 0; h < all->harmonics; h++) {
			double complex turn = cexp(I*all->harmonic[h].k*0.4), xyz[3] = {0.0};

			add_modes(xyz, all, h, p, left_out, omega);
			for (int i = 0; i < 3; i++)
				want[i] += creal(turn*xyz[i]);
			for (int s = 0; s < all->n; s++)
				strain += left_out[s] ? 0.0 : creal(turn*response(all, h, s, omega))*
				          all->shapes.slope[((size_t)s*all->shapes.points + p)*3];
		}
		hawser_rom_displacement_at(rom, got, p, rest, &moment);
		for (int i = 0; i < 3; i++) {
			most = fmax(most, fabs(want[i]));
			off = fmax(off, fabs(got[i] - want[i]));
		}
		strain *= rom->shapes.EA/(1.0 - rom->shapes.mach2);
		pull[0] = fmax(pull[0], fabs(strain));
		pull[1] = fmax(pull[1], fabs(hawser_rom_tension_at(rom, p, rest, &moment) - strain -
		                             hawser_rom_tension(rom, p, rest)));
	}
	limit = pow(all->harmonic[all->harmonics - 1].k*omega/rom->known.reach, 4);
	ok(off < limit*most && pull[1] < 1e-2*pull[0], "Omega %.3g, modes known to %.3g: displacement and "
	   "tension of the modes left out are off by %.1e and %.1e", omega, rom->known.reach, off/most,
	   pull[1]/pull[0]);
}

static void check_harmonics(double speed, double swing)
{
	struct hawser_scene scene = scene_of(4e6, 2.385, 97.3, 11.0, 3.1, 0.01,
	                                     (const double[3]){0.2, 0.7, 0.5});
	struct hawser_modes_options lowest = {.n = KNOWN};
	struct hawser_modes modes = {.n = 0}, subset = {.n = 0};
	struct hawser_rom rom = {.n = 0}, all = {.n = 0}, linear = {.n = 0};
	struct hawser_report report = {.message = ""};
	struct hawser_statics st;
	int before, failed;

	scene.travel.present = speed > 0.0;
	scene.travel.speed = speed;
	scene.travel.fluctuation = swing;
	if (!ok(!hawser_statics_scene(&st, &scene, &report) &&
	        !hawser_modes_solve(&modes, &st, &lowest, &report) &&
	        !hawser_modes_select(&subset, &modes, kept, KEPT, &report) &&
	        !hawser_rom_build(&rom, &subset, &scene, &report) &&
	        !hawser_rom_build_linear(&linear, &modes, &scene, &report) &&
	        !hawser_rom_know(&rom, &linear, kept, KEPT, &report) && !basis(&all, &st, &scene),
	        "at %g m/s +- %g%s", speed, swing, report.message))
		return;
	for (int i = 0; i < 3; i++)
		check_sums(&rom, &all, (i == 0 ? 0.9 : i == 1 ? 1.31 : 2.2)*modes.mode[2].omega);
	check_velocity(&rom, 3, 1.31*modes.mode[2].omega, (double[KEPT]){0.01, -0.02, 0.015, 0.004},
	               (double[KEPT]){0.3, 0.1, -0.2, 0.25}, 1e-7);
	check_file(&rom, 1.31*modes.mode[2].omega);
	before = rom.known.modes;
	failed = hawser_rom_know(&rom, &all, kept, KEPT, &report);
	ok(!failed && before == KNOWN - KEPT && rom.known.modes == all.n - KEPT,
	   "known modes are replaced: %d by %d", before, rom.known.modes);
	all.harmonic[0].k = 3;
	failed = hawser_rom_know(&rom, &all, kept, KEPT, &report);
	ok(failed == HAWSER_ERR_ARGUMENT, "modes under other forces are refused: %s", report.message);
	hawser_rom_clear(&rom);
	hawser_rom_clear(&all);
	hawser_rom_clear(&linear);
	hawser_modes_clear(&modes);
	hawser_modes_clear(&subset);
}

CASE(property_rom_known)
{
	int spans = getenv("HAWSER_LONG") ? 40 : 3;

	check_harmonics(0.0, 0.0);
	check_harmonics(5.0, 0.6);
	check_scene();
	for (int i = 0; i < spans; i++)
		check_span(i + 1);
	done_testing();
	return 0;
}
