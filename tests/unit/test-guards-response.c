/* Errors of the response and of reduced models that the program does not cause, or only for unusual
 * models: statuses and messages.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>

#include <hawser/backbone.h>
#include <hawser/beam_motion.h>
#include <hawser/choose.h>
#include <hawser/linear.h>
#include <hawser/scales.h>

#include "response/floquet/monodromy.h"
#include "rom/condense/condense.h"
#include "rom/choose/drive.h"
#include "rom/condense/inertia.h"
#include "rom/terms/travel.h"
#include "tests/modes-span.h"
#include "tests/tap.h"

static struct hawser_report report;
static const enum hawser_status argument = HAWSER_ERR_ARGUMENT, lost = HAWSER_ERR_CONVERGENCE;

static void refused(enum hawser_status got, enum hawser_status want, const char *message)
{
	ok(got == want && report.status == want && strstr(report.message, message), "%s: %s",
	   hawser_status_name(got), report.message);
	report = (struct hawser_report){.status = HAWSER_OK};
}

/* Arrays belong to the caller. */
static struct hawser_rom bare(int n, double *D, double *K)
{
	return (struct hawser_rom){.n = n, .D = D, .K = K, .length = 1.0, .time = 1.0, .force = 1.0};
}

static int compiled(struct hawser_rom *rom)
{
	return ok(hawser_rom_compile(rom, &report) == HAWSER_OK, "a model: %s", report.message);
}

static void release(struct hawser_rom *rom)
{
	struct hawser_rom kernel = {.kernel = rom->kernel};

	hawser_rom_clear(&kernel);
	rom->kernel = NULL;
}

/* --- free motions --- */

static void refused_backbone(struct hawser_rom *rom, struct hawser_backbone_options options,
                             const char *message)
{
	struct hawser_backbone backbone = {.n = 0};

	options.hi = 10.0;
	if (compiled(rom))
		refused(hawser_backbone_trace(&backbone, rom, &options, &report), lost, message);
	hawser_backbone_clear(&backbone);
	release(rom);
}

static void backbones(void)
{
	double D[4] = {0.0}, K[4] = {1.0}, K2[4] = {1.0, 0.0, 0.0, 2e8}, K3[4] = {1.0, 0.0, 0.0, -1e5};
	struct hawser_cubic C = {0, 0, 0, 0, -1.0};
	struct hawser_quad Q[2] = {{0, 0, 1, 1e4}, {1, 0, 0, 5e3}};
	struct hawser_rom soft = bare(1, D, K), fast = bare(2, D, K2), falling = bare(2, D, K3);
	struct hawser_backbone_options options = {.mode = 0};

	/* of u'' + u - u^3 the motions end at the saddle at 1, where the period is infinite */
	soft.cubics = 1;
	soft.C = &C;
	options.size = 10.0;
	options.lo = 1e-6;
	refused_backbone(&soft, options, "the curve is lost at Omega ");
	options.size = 1e6;
	refused_backbone(&soft, options, "no free motion of amplitude 1e+03 was found near mode 1");
	fast.quads = 2;
	fast.Q = Q;
	options.size = 1.0;
	options.tolerance = 1e-13;
	refused_backbone(&fast, options, "integration steps in half a period are not enough");
	options.tolerance = 1e-9;
	refused_backbone(&falling, options, "the multipliers of a free motion were not found");
}

/* --- multipliers --- */

static void not_a_matrix(void *context, double *A, double t)
{
	(void)context, (void)t;
	for (int i = 0; i < 4; i++)
		A[i] = 1e200;
}

static void eigenvalues(void)
{
	double D[4] = {0.1, 0.0, 0.0, 0.1}, K[4] = {1e-320, 1e200, 1e200, 1.0}, wave[4] = {0, 1, 1, 0};
	double log_modulus[4], angle[4], error, growth, frequency[2];
	struct hawser_harmonic harmonic = {.k = 1, .phase = HAWSER_COS, .omega_power = 2, .K = wave};
	struct hawser_rom rom = bare(2, D, K);
	struct hawser_linear *linear;
	int growing;

	refused(hawser_periodic_multipliers(log_modulus, angle, &error, not_a_matrix, NULL, 2, 1.0,
	                                    &report), HAWSER_ERR_NAN, " has no solution");
	if (!ok(hawser_linear_open(&linear, 2, &report) == HAWSER_OK, "room"))
		return;
	refused(hawser_linear_growth(linear, &growth, &growing, frequency, &rom, &report),
	        HAWSER_ERR_NAN, "the stiffness of coordinate 0 lies too far");
	K[0] = 1.0, K[1] = K[2] = 0.0;
	rom.harmonics = 1;
	rom.harmonic = &harmonic;
	refused(hawser_linear_multipliers(linear, log_modulus, angle, &error, &rom, 1e155, &report),
	        HAWSER_ERR_NAN, "the transition matrix of a period is not finite");
	hawser_linear_free(linear);
}

/* --- stiff coordinates that must not be condensed --- */

/* Largest logarithm of the multipliers of x'' + 0.05 x' + K x = 0 with K = [1; a b; b a] over a
 * period of Omega = 1, with the normal or the finer steps. */
static double fastest_growth(double a, double b, int finer)
{
	double T[9] = {2.0, 0, 0, 0, 2.0*a, 2.0*b, 0, 2.0*b, 2.0*a}, K[9] = {0.0};
	double D[9] = {0.05, 0, 0, 0, 0.05, 0, 0, 0, 0.05}, log_modulus[6] = {NAN}, angle[6];
	struct hawser__monodromy monodromy;
	struct hawser_rom rom = bare(3, D, K);

	if (hawser__monodromy_init(&monodromy, 3, &report))
		return NAN;
	monodromy.finer = finer;
	if (hawser__monodromy_multipliers(&monodromy, log_modulus, angle, &rom, T, 0, 1.0, &report))
		log_modulus[0] = NAN;
	hawser__monodromy_release(&monodromy);
	return log_modulus[0];
}

/* Two stiff coordinates with a coupling for which their relative motion has the stiffness a - b. */
static void coupled(void)
{
	for (int finer = 0; finer < 2; finer++) {
		double want = 2.0*M_PI*(sqrt(1.0 + 0.025*0.025) - 0.025);

		close_to(fastest_growth(1e6, 1e6 + 1.0, finer), want, 1e-6, "unstable by coupling");
		close_to(fastest_growth(1e6, 1e6 - 4.0, finer), -0.05*M_PI, 1e-6, "slow by coupling");
		close_to(fastest_growth(1e6, 1e5, finer), -0.05*M_PI, 1e-6, "both fast");
		want = 2.0*M_PI*(sqrt(9e4 + 0.025*0.025) - 0.025);
		close_to(fastest_growth(1e6, 1.09e6, finer), want, 1e-4*want, "unstable, and fast");
	}
}

/* --- multiple scales --- */

static void resonances(void)
{
	enum { N = HAWSER_RESONANT_MOST + 1 };
	double D[N*N] = {0.0}, K[N*N] = {0.0}, f[N] = {1.0}, x[2], omega;
	struct hawser_harmonic harmonic = {.k = 1, .phase = HAWSER_COS, .f = f};
	struct hawser_quad Q = {0, 0, 0, 1.0};
	struct hawser_rom rom = bare(N, D, K);
	struct hawser_resonance resonance;
	struct hawser_modulation modulation = {.rom = NULL};

	for (int j = 0; j < N; j++) {
		D[j*(N + 1)] = 0.05;
		K[j*(N + 1)] = 1.0 + 0.001*j;
	}
	rom.harmonics = 1;
	rom.harmonic = &harmonic;
	if (!compiled(&rom))
		return;
	refused(hawser_resonance_find(&resonance, &rom, 0.9, 1.1, &report), argument,
	        "more than 8 modes are near 1, 2 or 3 times");
	resonance = (struct hawser_resonance){.count = 2, .mode = {0, 1}, .order = {1, 1}, .omega0 = 1.0};
	if (ok(!hawser_modulation_derive(&modulation, &rom, &resonance, &report), "two modes"))
		refused(hawser_subharmonic_start(&modulation, x, &omega, 0.9, 1.1, &report), argument,
		        "a subharmonic motion of 2 modes has no closed form");
	hawser_modulation_clear(&modulation);
	release(&rom);
	/* superharmonic: the square of the load drives the mode, unlike in a subharmonic resonance */
	rom.n = 1;
	rom.quads = 1;
	rom.Q = &Q;
	resonance = (struct hawser_resonance){.count = 1, .mode = {0}, .order = {2}, .omega0 = 0.5};
	if (compiled(&rom) &&
	    ok(!hawser_modulation_derive(&modulation, &rom, &resonance, &report), "one mode"))
		refused(hawser_subharmonic_start(&modulation, x, &omega, 0.45, 0.55, &report), argument,
		        "other terms than a subharmonic resonance's");
	hawser_modulation_clear(&modulation);
	release(&rom);
}

/* --- models --- */

static void models(void)
{
	double D[9] = {0, 1, 0, -1, 0, 0, 0, 0, 0}, K[9] = {1, 0, 0, 0, 2, 0, 0, 0, 4};
	double complex a[3];
	struct hawser_ramp ramp = {.time = 0.0};
	struct hawser_rom rom = bare(0, D, K);

	refused(hawser_rom_compile(&rom, &report), argument, "a model of 0 coordinates");
	rom.n = 3;
	rom.ramp = &ramp;
	refused(hawser_rom_compile(&rom, &report), argument, "the ramp takes the time 0");
	rom.ramp = NULL;
	refused(hawser__respond(&rom, a, 2.0, &report), HAWSER_ERR_NO_SOLUTION,
	        "the linear response at Omega 2 is infinite");
}

static void beams(void)
{
	const struct hawser_beam beam = {.theta = 1.0, .tension = 1.0, .rotary = -1.0};
	struct hawser_beam_integrals is;
	struct hawser_rom rom;
	double B[16];

	if (!ok(!hawser_beam_method(0)->fill(&is, beam.ends, 4, &report), "integrals"))
		return;
	for (int modes = 2; modes <= 4; modes += 2)
		refused(hawser_rom_from_beam(&rom, B, modes, &is, &beam, &report), lost,
		        "the mass matrix of 4 functions is not positive");
	hawser_beam_integrals_clear(&is);
}

/* --- modes --- */

static void at_rest(const struct hawser_modes *modes)
{
	const struct hawser_scene scene = {.damping = {.alpha = 0.01}, .load = {.present = 1,
		.per_length = {1e-3, 1e-3, 0.0}, .extent = {0.0, 1.0}}};
	const double w = modes->mode[0].omega;
	struct hawser_choice choice = {.n = 0};
	double *u = calloc((size_t)modes->n*16, sizeof *u);

	if (ok(u && !hawser_choose(&choice, modes, &scene, 0.9*w, 1.1*w, 0.05, &report), "chosen: %s",
	       report.message))
		refused(hawser_choice_weigh(&choice, u, 16, w, 1, &report), HAWSER_ERR_NAN,
		        "a motion at rest or not finite");
	hawser_choice_clear(&choice);
	free(u);
}

static void without_shapes(struct hawser_modes *modes)
{
	struct hawser__condensed condensed = {.n = 0};
	struct hawser_rom_inertia inertia;
	struct hawser_rom rom = {.n = 0};
	struct hawser_modes with;
	double ones[8] = {1, 1, 1, 1, 1, 1, 1, 1}, keep = modes->slope[1];

	if (ok(!hawser__condense(&condensed, modes, modes->n, &report), "condensed")) {
		modes->statics.epsilon = 1e-320;
		refused(hawser__inertia_extend(&with, &inertia, modes, &condensed, ones, ones, 0.0,
		                               &report), HAWSER_ERR_NAN,
		        "the second-order shapes of ");
		hawser_modes_clear(&with);
	}
	hawser__condensed_clear(&condensed);
	modes->statics.motion.nu = 0.1;
	modes->slope[1] = NAN;
	refused(hawser__rom_travel(&rom, modes, NULL, &report), HAWSER_ERR_NAN,
	        "the shapes of the modes 1 and 1 are not finite");
	modes->slope[1] = keep;
}

CASE(unit_guards_response)
{
	struct hawser_statics statics = scaled_span(1e-3, 0.3, 0.0);
	struct hawser_modes_options options = {.n = 8};
	struct hawser_modes modes = {.n = 0};

	backbones();
	eigenvalues();
	coupled();
	resonances();
	models();
	beams();
	if (ok(!hawser_modes_solve(&modes, &statics, &options, &report), "modes")) {
		at_rest(&modes);
		without_shapes(&modes);
	}
	hawser_modes_clear(&modes);
	return done_testing();
}
