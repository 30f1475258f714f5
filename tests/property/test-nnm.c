/* Nonlinear normal modes: Duffing's equation against its elliptic integral; the two masses of Kerschen
 * et al. (2009): closure, action and stability by integration in time, the tongue of the 3:1 resonance,
 * which reaches the other mode's motions, branches of three periods, refusals.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
#include <gsl/gsl_sf_ellint.h>

#include <hawser/nnm.h>

#include "tests/tap.h"

static struct hawser_rom rom;
static struct hawser_report report;
static double at_tongue[2]; /* Omega and energy where the tongue meets the second mode */

/* x1'' + 2 x1 - x2 + x1^3/2 = 0, x2'' + 2 x2 - x1 = 0, in the modes' coordinates (x1 -+ x2)/sqrt 2. */
static int two_masses(void)
{
	static const double share[] = {0.125, 0.375, 0.375, 0.125};

	rom = (struct hawser_rom){.n = 2, .cubics = 8, .length = 1.0, .time = 1.0, .force = 1.0};
	rom.D = calloc(4, sizeof(double));
	rom.K = calloc(4, sizeof(double));
	rom.C = calloc(8, sizeof *rom.C);
	if (!rom.D || !rom.K || !rom.C)
		return 1;
	rom.K[0] = 1.0;
	rom.K[3] = 3.0;
	for (int i = 0; i < 8; i++)
		rom.C[i] = (struct hawser_cubic){.j = i/4, .k = i%4 > 2, .l = i%4 > 1, .m = i%4 > 0,
			.value = share[i%4]};
	return hawser_rom_compile(&rom, &report) != HAWSER_OK;
}

enum { STATE = 5, ALL = STATE + 16 }; /* the motion and its action; then four neighbouring motions */

static int slope(double t, const double y[], double dy[], void *unused)
{
	double x = (y[0] + y[1])*M_SQRT1_2, f = 0.5*x*x*x*M_SQRT1_2, stiff = 0.75*x*x;

	(void)t;
	(void)unused;
	dy[0] = y[2];
	dy[1] = y[3];
	dy[2] = -y[0] - f;
	dy[3] = -3.0*y[1] - f;
	dy[4] = y[2]*y[2] + y[3]*y[3];
	for (int i = STATE; i < ALL; i += 4) {
		dy[i] = y[i + 2];
		dy[i + 1] = y[i + 3];
		dy[i + 2] = -y[i] - stiff*(y[i] + y[i + 1]);
		dy[i + 3] = -3.0*y[i + 1] - stiff*(y[i] + y[i + 1]);
	}
	return GSL_SUCCESS;
}

/* Multipliers are wrong at single motions, so that all of them are integrated, which takes a
 * second. The action over a period from u0, and the distance of its end from its start, relative.
 * Two of the four multipliers are 1, and `trace` becomes the sum of the others, whose product is
 * 1. */
static double action(double *gap, double *trace, const double *u0, double omega)
{
	gsl_odeiv2_system system = {slope, NULL, ALL, NULL};
	gsl_odeiv2_driver *driver =
		gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, 1e-3, 1e-11, 1e-12);
	double t = 0.0, y[ALL] = {u0[0], u0[1]};

	*gap = INFINITY;
	for (int i = 0; i < 4; i++)
		y[STATE + 5*i] = 1.0;
	if (driver && gsl_odeiv2_driver_apply(driver, &t, 2.0*M_PI/omega, y) == GSL_SUCCESS)
		*gap = hypot(hypot(y[0] - u0[0], y[1] - u0[1]), hypot(y[2], y[3])/omega)/
		       hypot(u0[0], u0[1]);
	gsl_odeiv2_driver_free(driver);
	*trace = -2.0;
	for (int i = 0; i < 4; i++)
		*trace += y[STATE + 5*i];
	return y[4]/(2.0*M_PI);
}

static void check_tongue(void)
{
	struct hawser_nnm nnm;
	struct hawser_nnm_options options = {.mode = 0, .energy = 1e4};
	double gap, worst = 0.0, sum = 0.0, before, start, most = 0.0, trace;
	int wrong = 0, both[2] = {0, 0};
	const struct hawser_backbone *motion;

	if (!ok(hawser_nnm_trace(&nnm, &rom, &options, &report) == HAWSER_OK, "the first mode %s",
	        report.message))
		return;
	motion = &nnm.curve[0].motion;
	start = before = action(&gap, &trace, motion->start, motion->point[0].omega);
	for (int i = 1; i < motion->points; i++) {
		const struct hawser_backbone_point *p = &motion->point[i];
		double here = action(&gap, &trace, motion->start + 2*(size_t)i, p->omega);

		worst = fmax(worst, gap);
		if (fabs(fabs(trace) - 2.0) > 1e-6) { /* otherwise within the error of the integration */
			both[fabs(trace) > 2.0]++;
			wrong += p->unstable != (fabs(trace) > 2.0);
		}
		sum += 0.5*(p->omega + p[-1].omega)*(here - before);
		before = here;
		most = fmax(most, p[-1].energy - p->energy);
	}
	ok(worst < 1e-7, "every motion closes in time: %.1e", worst);
	ok(wrong == 0 && both[0] > 400 && both[1] > 200,
	   "of %d stable and %d unstable motions %d have another count", both[0], both[1], wrong);
	ok(fabs(sum/(motion->point[motion->points - 1].energy - motion->point[0].energy) - 1.0) < 1e-4 &&
	   start > 0.0, "the energy is the integral of the frequency over the action: %.1e",
	   sum/(motion->point[motion->points - 1].energy - motion->point[0].energy) - 1.0);
	ok(motion->end == HAWSER_BACKBONE_ENERGY && most > 0.0,
	   "through the tongue, where the energy falls, to the largest energy");
	at_tongue[0] = motion->branches > 1 ? motion->branch[1].omega : NAN;
	at_tongue[1] = motion->branches > 1 ? motion->branch[1].energy : NAN;
	hawser_nnm_clear(&nnm);
}

static void check_branches(void)
{
	struct hawser_nnm nnm;
	struct hawser_nnm_options options = {.mode = 1, .energy = 400.0, .periods = 3, .depth = 1};
	const struct hawser_backbone_branch *meets;
	double gap, trace, worst = 0.0, alone = INFINITY;

	if (!ok(hawser_nnm_trace(&nnm, &rom, &options, &report) == HAWSER_OK && nnm.lost == 0,
	        "the second mode, three periods %s", report.message))
		return;
	if (!ok(nnm.curve[0].motion.branches == 3 && nnm.curves > 3, "three branch points, %d curves",
	        nnm.curves))
		return;
	meets = &nnm.curve[0].motion.branch[2];
	ok(fabs(3.0*at_tongue[0]/meets->omega - 1.0) < 1e-6 &&
	   fabs(at_tongue[1]/meets->energy - 1.0) < 1e-4,
	   "the tongue meets it at a third of its frequency: %.9g, %.9g", 3.0*at_tongue[0], meets->omega);
	for (int c = 1; c < nnm.curves; c++) {
		const struct hawser_backbone *motion = &nnm.curve[c].motion;

		for (int i = 0; i < motion->points; i += 17) {
			action(&gap, &trace, motion->start + 2*(size_t)i, motion->point[i].omega/3.0);
			worst = fmax(worst, gap);
		}
		action(&gap, &trace, motion->start + 2*(size_t)(motion->points/2),
		       motion->point[motion->points/2].omega);
		alone = fmin(alone, gap);
		ok(nnm.curve[c].born > 1 || motion->end == HAWSER_BACKBONE_MEETS,
		   "branch %d returns to a branch point", c);
	}
	ok(worst < 1e-6 && alone > 1e-3, "motions close after three periods, and not before: %.1e, %.1e",
	   worst, alone);
	hawser_nnm_clear(&nnm);
}

static void check_duffing(void)
{
	struct hawser_nnm nnm;
	struct hawser_nnm_options options = {.mode = 0, .energy = 1e4};
	double worst = 0.0;

	rom = (struct hawser_rom){.n = 1, .cubics = 1, .length = 1.0, .time = 1.0, .force = 1.0};
	rom.D = calloc(1, sizeof(double));
	rom.K = calloc(1, sizeof(double));
	rom.C = calloc(1, sizeof *rom.C);
	if (!rom.D || !rom.K || !rom.C)
		return;
	rom.K[0] = 1.0;
	rom.C[0].value = 0.3;
	options.hi = 50.0;
	if (!ok(!hawser_rom_compile(&rom, &report) && !hawser_nnm_trace(&nnm, &rom, &options, &report),
	        "Duffing"))
		return;
	for (int i = 0; i < nnm.curve[0].motion.points; i++) {
		double a = nnm.curve[0].motion.start[i], g = 0.3*a*a, stiff = 1.0 + g;
		double exact = M_PI*sqrt(stiff)/
		               (2.0*gsl_sf_ellint_Kcomp(sqrt(0.5*g/stiff), GSL_PREC_DOUBLE));

		worst = fmax(worst, fabs(nnm.curve[0].motion.point[i].omega/exact - 1.0));
	}
	ok(worst < 1e-9, "over %d points to an energy of 1e4: %.1e", nnm.curve[0].motion.points, worst);
	hawser_nnm_clear(&nnm);
	hawser_rom_clear(&rom);
}

CASE(property_nnm)
{
	struct hawser_nnm nnm;

	gsl_set_error_handler_off();
	if (ok(!two_masses(), "two masses")) {
		struct hawser_nnm_options wrong = {.mode = 2}, deep = {.depth = -1};

		check_tongue();
		check_branches();
		ok(hawser_nnm_trace(&nnm, &rom, &wrong, &report) == HAWSER_ERR_ARGUMENT, "%s", report.message);
		hawser_nnm_clear(&nnm);
		ok(hawser_nnm_trace(&nnm, &rom, &deep, &report) == HAWSER_ERR_ARGUMENT, "%s", report.message);
		hawser_nnm_clear(&nnm);
	}
	hawser_rom_clear(&rom);
	check_duffing();
	return done_testing();
}
