/* Autonomous models: equilibria with their Hopf points, and limit cycles, against numbers by
 * collocation and by shooting of other programs, closed forms, and AUTO-07p.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdio.h>
#include <stdlib.h>

#include <hawser/branches.h>

#include "tests/tap.h"

#define DIGITS 1e-8 /* of the references; their amplitudes are those of samples */

/* A model of a file over one of its parameters. */
struct own {
	struct hawser_rom_source source;
	struct hawser_rom_family family;
	const struct hawser_rom *rom;
	struct hawser_frf frf;
	struct hawser_frf_options options;
	struct hawser_report report;
};

static void begin(struct own *own, const char *name, double from, double to)
{
	const char *path = source_file("tests/reference/autonomous/%s.json", name);

	*own = (struct own){.options = {.from = from, .to = to, .tolerance = 1e-11, .step_max = 0.1}};
	ok(!hawser_rom_source_open(&own->source, path, &own->report), "%s: read%s", name,
	   own->report.message);
}

static void set(struct own *own, const char *name, double value)
{
	int known;

	hawser_rom_source_set(&own->source, name, value, &known);
}

static void trace(struct own *own, const char *key)
{
	enum hawser_status status = hawser_parameter_open(&own->family, &own->source, key, 0.0,
	                                                  &own->report);

	own->options.family = &own->family;
	if (!status)
		status = own->family.model(own->family.context, &own->rom, own->options.from, &own->report);
	if (!status)
		status = hawser_frf_trace(&own->frf, own->rom, &own->options, &own->report);
	ok(!status, "%s is followed: %s", key, own->report.message);
}

static void end(struct own *own)
{
	hawser_frf_clear(&own->frf);
	hawser_parameter_close(&own->family);
	hawser_rom_source_clear(&own->source);
}

static const struct hawser_frf_event *event(const struct hawser_frf *frf, enum hawser_event_kind kind,
                                            int which)
{
	static const struct hawser_frf_event none = {.parameter = NAN, .hopf.l1 = NAN};

	for (int e = 0; e < frf->events; e++)
		if (frf->event[e].kind == kind && which-- == 0)
			return &frf->event[e];
	return &none;
}

static void hopf(const struct own *own, double at, double omega, double l1, const char *what)
{
	const struct hawser_frf_event *found = event(&own->frf, HAWSER_HOPF, 0);
	char text[80];

	snprintf(text, sizeof text, "%s: Hopf point", what);
	close_to(found->parameter, at, DIGITS, text);
	close_to(found->hopf.omega, omega, DIGITS, "its frequency");
	if (!isnan(l1))
		close_to(found->hopf.l1, l1, 3e-7, "its first Lyapunov coefficient");
}

/* The cycles at the first Hopf point. */
static void cycles(struct hawser_frf *branch, struct own *own)
{
	const struct hawser_frf_event *found = event(&own->frf, HAWSER_HOPF, 0);

	ok(!hawser_branch_switch(branch, own->rom, &own->frf, (int)(found - own->frf.event), &own->options,
	                         &own->report), "cycles are followed: %s", own->report.message);
}

/* Period, amplitude of coordinate j and multiplier i of the last cycle; NAN: not looked at. */
static void last(const struct hawser_frf *branch, double period, int j, double swing, int i,
                 double multiplier)
{
	int p = branch->points - 1, m = 2*branch->n;

	if (!ok(p > 0, "there are cycles"))
		return;
	close_to(2.0*M_PI/branch->point[p].omega, period, DIGITS, "period");
	close_to(branch->swing[p*branch->n + j], swing, 1e-6, "amplitude");
	if (!isnan(multiplier))
		close_to(exp(branch->multiplier[(p*m + i)*2]), multiplier, 3e-6, "multiplier");
	ok(branch->trivial[p] < 1e-8, "the multiplier that is 1 is off by %.1e", branch->trivial[p]);
}

static void check_brusselator(void)
{
	struct own own;
	struct hawser_frf branch = {0};

	begin(&own, "brusselator", 1.0, 3.0);
	trace(&own, "B");
	hopf(&own, 2.0, 1.0, -0.5, "Brusselator");
	cycles(&branch, &own);
	last(&branch, 7.156919921180, 0, 1.69060975, 0, 2.516376e-4);
	hawser_frf_clear(&branch);
	end(&own);
}

/* With its first period doubling, and the cycles of twice the period that begin there. */
static void check_adaptx(void)
{
	struct own own;
	struct hawser_frf branch = {0}, doubled = {0};
	const struct hawser_frf_event *found;

	begin(&own, "adaptx", 1.2, 0.6);
	trace(&own, "a");
	hopf(&own, 1.0, 1.0, -0.3, "adaptx");
	cycles(&branch, &own);
	found = event(&branch, HAWSER_PERIOD_DOUBLING, 0);
	close_to(found->parameter, 0.630302006158, DIGITS, "period doubling");
	close_to(2.0*M_PI/found->omega, 6.364071339442, DIGITS, "its period");
	ok(!hawser_branch_switch(&doubled, own.rom, &branch, (int)(found - branch.event), &own.options,
	                         &own.report), "the doubled cycles are followed: %s", own.report.message);
	ok(doubled.points > 1 && doubled.point[0].unstable == 0 &&
	   fabs(doubled.point[0].omega/found->omega - 0.5) < 1e-3, "they are stable, of twice the period");
	hawser_frf_clear(&doubled);
	hawser_frf_clear(&branch);
	own.options.to = 0.9;
	cycles(&branch, &own);
	last(&branch, 6.306235057458, 0, 0.322368656, 0, 0.636332938);
	hawser_frf_clear(&branch);
	end(&own);
}

/* From the branch point to the other equilibria, to their Hopf point, to unstable cycles. */
static void check_lorenz(void)
{
	struct own own, other;
	struct hawser_frf branch = {0};
	int m = 6;

	begin(&own, "lorenz", 0.5, 26.0);
	trace(&own, "r");
	close_to(event(&own.frf, HAWSER_BRANCH_POINT, 0)->parameter, 1.0, DIGITS, "Lorenz: branch point");
	other = own;
	ok(!hawser_branch_switch(&other.frf, own.rom, &own.frf, 0, &own.options, &own.report),
	   "the other equilibria are followed: %s", own.report.message);
	hopf(&other, 470.0/19.0, 9.624530063716, 2.655190e-4, "Lorenz");
	other.options.from = 26.0;
	other.options.to = 20.0;
	cycles(&branch, &other);
	last(&branch, 0.876552253492, 0, 5.207184427, 0, 1.402070818);
	ok(branch.points > 0 && branch.point[branch.points - 1].unstable == 1 &&
	   isnan(branch.multiplier[(size_t)(branch.points - 1)*2*(size_t)m + 4]),
	   "one multiplier is outside; of three, none is that of the relaxation");
	hawser_frf_clear(&branch);
	hawser_frf_clear(&other.frf);
	end(&own);
}

static void check_parkinson(void)
{
	struct own own;
	struct hawser_frf branch = {0};

	begin(&own, "parkinson", 3.0, 8.0);
	trace(&own, "U");
	hopf(&own, 3.388951327051, 1.0, -0.0159872464, "Parkinson");
	if (!getenv("HAWSER_LONG")) { /* the quicker one */
		own.options.method = "balance";
		own.options.tolerance = 1e-9;
	}
	cycles(&branch, &own);
	close_to(event(&branch, HAWSER_FOLD, 0)->parameter, 6.2198121722, DIGITS, "first fold of cycles");
	close_to(event(&branch, HAWSER_FOLD, 1)->parameter, 4.1936879711, DIGITS, "second");
	hawser_frf_clear(&branch);
	end(&own);
}

/* Quintic: cycles z = r exp(i t), with r^2 = (b2 + sqrt(b2^2 + 4 b1))/2. */
static void check_bautin(void)
{
	struct own own;
	struct hawser_frf branch = {0};
	double r2 = 0.5*(1.0 + sqrt(1.8));

	begin(&own, "bautin", -0.3, 0.2);
	trace(&own, "b1");
	hopf(&own, 0.0, 1.0, 2.0, "Bautin");
	cycles(&branch, &own);
	close_to(event(&branch, HAWSER_FOLD, 0)->parameter, -0.25, DIGITS, "fold of cycles");
	last(&branch, 2.0*M_PI, 0, sqrt(r2), 0, exp(2.0*M_PI*(2.0*r2 - 4.0*r2*r2)));
	hawser_frf_clear(&branch);
	end(&own);
}

static void check_belt(void)
{
	struct own own;
	struct hawser_frf branch = {0};

	begin(&own, "belt", 0.6, 0.45);
	trace(&own, "vb");
	hopf(&own, 0.5, 1.0, -0.45, "belt");
	cycles(&branch, &own);
	last(&branch, 6.422650117, 0, 0.453090922, 0, 0.55408499);
	hawser_frf_clear(&branch);
	end(&own);
}

/* p = 41/28 + d^2/2, w^2 = 2/7; without damping 7/2 - sqrt 2, where two pairs meet. */
static void check_ziegler(void)
{
	struct own own;

	begin(&own, "ziegler", 1.0, 3.0);
	trace(&own, "p");
	hopf(&own, 41.0/28.0 + 0.005, sqrt(2.0/7.0), NAN, "Ziegler");
	end(&own);
	begin(&own, "ziegler", 1.0, 3.0);
	set(&own, "d", 0.0);
	trace(&own, "p");
	close_to(event(&own.frf, HAWSER_HOPF, 0)->parameter, 3.5 - sqrt(2.0), DIGITS, "without damping");
	end(&own);
}

/* The symmetric cycle of the Lorenz equations at large r loses its symmetry where r falls, and the
 * two that begin there are stable (Sparrow, The Lorenz Equations, Springer 1982: 312.97). */
static void check_pitchfork(void)
{
	struct own own;
	struct hawser_frf branch = {0};
	double state[6] = {-37.18071269068926, 35.04454835529008, 376.53788000077304};
	const struct hawser_frf_event *found;

	begin(&own, "lorenz", 316.0, 310.0);
	own.options.start = state;
	own.options.tolerance = 1e-9;
	own.options.omega = -1.0;
	trace(&own, "r");
	found = event(&own.frf, HAWSER_BRANCH_POINT, 0);
	close_to(found->parameter, 312.9735, 2e-5, "branch point of cycles");
	if (!isfinite(found->parameter))
		return;
	ok(!hawser_branch_switch(&branch, own.rom, &own.frf, (int)(found - own.frf.event), &own.options,
	                         &own.report), "the other cycles are followed: %s", own.report.message);
	ok(branch.points > 1 && branch.point[branch.points - 1].unstable == 0 &&
	   own.frf.point[own.frf.points - 1].unstable == 1, "they are stable, the symmetric one is not");
	hawser_frf_clear(&branch);
	end(&own);
}

/* Two equal oscillators, whose pairs cross the axis together: cycles along a line, and round a circle
 * of radius sqrt(mu). Either may be rotated. */
static void check_together(void)
{
	struct own own;
	struct hawser_frf line = {0}, circle = {0};

	begin(&own, "o2", -0.1, 0.3);
	trace(&own, "mu");
	ok(own.frf.events == 2, "two Hopf points, %d events", own.frf.events);
	for (int k = 0; k < 2; k++) {
		const struct hawser_frf_event *found = event(&own.frf, HAWSER_HOPF, k);

		ok(fabs(found->parameter) < DIGITS && !found->suspected, "at %.1e", found->parameter);
		close_to(found->hopf.omega, 1.0, DIGITS, "frequency");
		close_to(found->hopf.swing, k ? 1.0 : 4.0, DIGITS, "square of the amplitude");
		ok(!hawser_branch_switch(k ? &circle : &line, own.rom, &own.frf, (int)(found - own.frf.event),
		                         &own.options, &own.report), "cycles %s", own.report.message);
	}
	last(&line, 6.318443203454, 0, 1.095950207, 1, 0.14865049);
	last(&line, 6.318443203454, 0, 1.095950207, 0, 0.14865049);
	last(&circle, 2.0*M_PI, 1, sqrt(0.3), 2, 0.15799796);
	if (ok(circle.points > 0, "a circle")) {
		const double *pair = circle.multiplier + (size_t)(circle.points - 1)*2*2*(size_t)circle.n;

		close_to(exp(pair[0])*cos(pair[1]), 2.50291935, 3e-8, "its multipliers");
		close_to(exp(pair[0])*fabs(sin(pair[1])), 0.25414604, 3e-8, "imaginary part");
	}
	hawser_frf_clear(&circle);
	hawser_frf_clear(&line);
	end(&own);
}

static void check_two(void)
{
	static const double row[][2] = {{1.0, 118.69191844}, {1.005, 111.26818391}, {1.02, 57.58242139},
	                                {1.1, 40.94124925}};
	struct own own;
	struct hawser_frf branch = {0};

	for (int k = 0; k < 4; k++) {
		begin(&own, "two", 30.0, k == 3 ? 70.0 : 130.0);
		set(&own, "oz", row[k][0]);
		trace(&own, "U");
		close_to(event(&own.frf, HAWSER_HOPF, 0)->parameter, row[k][1], DIGITS, "two modes gallop");
		if (k == 3) {
			cycles(&branch, &own);
			last(&branch, 2.0*M_PI/0.9987421337, 0, 14.45554764, 0, NAN);
			hawser_frf_clear(&branch);
		}
		end(&own);
	}
}

/* From a state that is no cycle's, and from beside an equilibrium, which is unstable everywhere. */
static void check_start(void)
{
	static const double state[] = {0.05, 2.0, 0.0, 0.0};
	static const double at[2][2] = {{4.72394978906, 4.79796645954}, {5.44218513218, 5.28571255274}};
	struct own own;
	struct hawser_frf branch = {0};

	for (int side = !getenv("HAWSER_LONG"); side < 2; side++) {
		begin(&own, "wake", 5.0, side ? 5.7 : 4.5);
		own.options.start = state;
		own.options.omega = HAWSER_NONE;
		own.options.method = side ? "balance" : "shooting";
		trace(&own, "Ur");
		close_to(own.frf.point[0].omega, 0.999362270926, DIGITS, "wake oscillator: frequency");
		close_to(own.frf.swing[0], 0.0574539429, 1e-6, "amplitude");
		for (int k = 0; k < 2; k++)
			close_to(event(&own.frf, HAWSER_FOLD, k)->parameter, at[side][k], DIGITS, "fold");
		end(&own);
	}
	begin(&own, "string8", 1.3, 1.34); /* where its wakes unlock */
	own.options.tolerance = 1e-9;
	trace(&own, "u");
	ok(!hawser_branch_switch(&branch, own.rom, &own.frf, -1, &own.options, &own.report),
	   "a string with its wakes %s", own.report.message);
	close_to(event(&branch, HAWSER_TORUS, 0)->parameter, 1.3215049, 3e-8, "torus point");
	hawser_frf_clear(&branch);
	end(&own);
	begin(&own, "vdp", getenv("HAWSER_LONG") ? 3.0 : 1.2, 1.0);
	trace(&own, "mu");
	ok(!hawser_branch_switch(&branch, own.rom, &own.frf, -1, &own.options, &own.report),
	   "van der Pol: the cycle beside an unstable equilibrium %s", own.report.message);
	last(&branch, 6.663286859323, 0, 2.008619594, 0, 8.59695064e-4);
	close_to(branch.swing[branch.points - 1], 2.00861986087484314, 1e-11,
	         "its amplitude, as published");
	if (getenv("HAWSER_LONG"))
		close_to(branch.multiplier[0], -34.9, 2e-3, "van der Pol, 3: logarithm of the multiplier");
	hawser_frf_clear(&branch);
	end(&own);
}

CASE(reference_autonomous)
{
	check_adaptx();
	check_lorenz();
	check_parkinson();
	check_belt();
	check_ziegler();
	check_together();
	check_pitchfork();
	check_two();
	check_start();
	if (getenv("HAWSER_LONG")) {
		check_brusselator();
		check_bautin();
	}
	return done_testing();
}
