/* Travelling beams by two routes: closed forms, shooting, three discretisations and their orders of
 * convergence, symmetries, boundaries against safe speeds at single parameters.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include <hawser/beam.h>

#include "tests/beam-shooting.h"
#include "tests/beam-near.h"

static const double pi = 3.14159265358979323846;

enum { LEGENDRE, SINE, HERMITE };

static struct hawser_beam_limits limits(struct hawser_beam beam, int row, int size)
{
	struct hawser_beam_limits result = {0};
	struct hawser_beam_integrals is;
	struct hawser_report report = {0};

	if (hawser_beam_method(row)->fill(&is, beam.ends, size, &report) ||
	    hawser_beam_limits(&result, &is, &beam, 5, &report)) {
		ok(0, "%s", report.message);
		result.v_crit = result.v_first = result.v_bif = NAN;
	}
	hawser_beam_integrals_clear(&is);
	return result;
}

static void closed_forms(void)
{
	static const double mu[] = {0.3, 1.0, 2.385, 10.0, 20.0};

	for (int i = 0; i < 5; i++) {
		double m2 = mu[i]*mu[i], S = 20.0 + 37.1*i, r2 = 1.0/(S*S);
		double euler = sqrt(pi*pi + m2), rayleigh = euler/sqrt(1.0 + pi*pi*r2);
		struct hawser_beam beam = {.theta = 1.0, .tension = m2};

		near_to(limits(beam, LEGENDRE, 24).v_crit/euler, 1.0, 1e-12, "level, mu %g", mu[i]);
		near_to(limits(beam, SINE, 7).v_crit/euler, 1.0, 1e-12, "level, mu %g, sines", mu[i]);
		beam.rotary = r2;
		if (mu[i] < S)
			near_to(limits(beam, LEGENDRE, 24).v_crit/rayleigh, 1.0, 1e-11, "Rayleigh, mu %g, S %g",
			         mu[i], S);
		beam.rotary = 0.0;
		beam.ends = HAWSER_ENDS_CLAMPED;
		near_to(limits(beam, LEGENDRE, 24).v_crit/sqrt(4.0*pi*pi + m2), 1.0, 1e-11,
		         "clamped, mu %g", mu[i]);
	}
}

static void strings(void)
{
	struct hawser_beam beam = {.theta = 0.0, .tension = 1.0};
	struct hawser_beam_integrals is;
	struct hawser_report report = {0};
	struct hawser_beam_eigenvalue value[5];
	int found = 0;

	if (!ok(hawser_beam_method(LEGENDRE)->fill(&is, HAWSER_ENDS_SIMPLE, 40, &report) == HAWSER_OK,
	        "string"))
		return;
	for (beam.speed = -0.4; beam.speed < 0.7; beam.speed += 0.35) {
		enum hawser_status status = hawser_beam_eigenvalues(value, NULL, &found, &is, &beam, 5,
		                                                    &report);

		ok(status == HAWSER_OK && found == 5, "string at v = %g: %s", beam.speed, report.message);
		for (int n = 1; n <= found; n++) {
			near_to(value[n - 1].im/(n*pi*(1.0 - beam.speed*beam.speed)), 1.0, 1e-10,
			         "mode %d is n pi (1 - v^2)", n);
			ok(value[n - 1].re == 0.0, "and on the axis to the last bit");
		}
	}
	hawser_beam_integrals_clear(&is);
	beam.weight = 0.4;
	near_to(limits(beam, LEGENDRE, 10).v_crit, sqrt(0.6), 1e-15,
	        "a string's speed is that of its waves");
}

static void at_rest(void)
{
	struct hawser_beam beam = {.theta = 0.7, .tension = 3.1, .rotary = 0.013, .drag = 1.7};
	struct hawser_beam_integrals is;
	struct hawser_report report = {0};
	struct hawser_beam_eigenvalue value[4];
	int found = 0;
	enum hawser_status status;

	if (!ok(hawser_beam_method(LEGENDRE)->fill(&is, HAWSER_ENDS_SIMPLE, 30, &report) == HAWSER_OK,
	        "rest"))
		return;
	status = hawser_beam_eigenvalues(value, NULL, &found, &is, &beam, 4, &report);
	ok(status == HAWSER_OK && found == 4, "at rest: %s", report.message);
	for (int n = 1; n <= found; n++) {
		double k2 = n*n*pi*pi, m = 1.0 + beam.rotary*k2;
		double re = -0.5*beam.drag/m, w2 = (beam.theta*k2*k2 + beam.tension*k2)/m;

		near_to(value[n - 1].re, re, 1e-10, "mode %d: damping", n);
		near_to(value[n - 1].im/sqrt(w2 - re*re), 1.0, 1e-11, "and frequency");
	}
	hawser_beam_integrals_clear(&is);
}

static void shooting(void)
{
	static const struct {
		const char *name;
		struct hawser_beam beam;
	} row[] = {
		{"upright", {.theta = 1.0, .tension = 1.0, .weight = 10.0}},
		{"upright, taut", {.theta = 1.0, .tension = 100.0, .weight = 10.0}},
		{"downwards", {.theta = 0.8, .tension = 1.7, .weight = -3.3}},
		{"clamped", {.theta = 1.3, .tension = 2.1, .weight = 6.0, .ends = HAWSER_ENDS_CLAMPED}},
		{"balanced", {.theta = 1.0, .tension = 1.0, .weight = 10.0, .rotary = 0.0025,
		              .moment = HAWSER_MOMENT_BALANCED}},
		{"drag", {.theta = 1.0, .tension = 1.0, .weight = 10.0, .drag = 5.0}},
		{"drag and rotary inertia", {.theta = 1.0, .tension = 1.0, .weight = 10.0, .rotary = 0.0025,
		                             .drag = 10.0}},
	};

	for (size_t i = 0; i < sizeof row/sizeof *row; i++) {
		double v = limits(row[i].beam, LEGENDRE, 28).v_crit;
		double shot = shooting_speed(&row[i].beam, 0.98*v, 1.02*v);

		if (row[i].beam.moment == HAWSER_MOMENT_BALANCED) /* its end condition is not y'' = 0 */
			ok(fabs(v - shot) < 0.02 && v != shot, "%s: %.10g near the free moment's %.10g",
			   row[i].name, v, shot);
		else
			near_to(v/shot, 1.0, 1e-10, "%s: %.12g is the shot %.12g", row[i].name, v, shot);
	}
}

/* Errors of the upright beam's safe speed at two sizes each, from which the order follows. */
static void orders(void)
{
	const struct hawser_beam beam = {.theta = 1.0, .tension = 1.0, .weight = 10.0};
	const struct hawser_beam taut = {.theta = 1.0, .tension = 100.0, .weight = 10.0};
	double exact = limits(beam, LEGENDRE, 40).v_crit, best = limits(taut, LEGENDRE, 40).v_crit;
	double sine[2], hermite[2], legendre[3], order;

	for (int i = 0; i < 2; i++) {
		sine[i] = limits(beam, SINE, 10 << i).v_crit/exact - 1.0;
		hermite[i] = limits(beam, HERMITE, 8 << i).v_crit/exact - 1.0;
	}
	for (int i = 0; i < 3; i++)
		legendre[i] = fabs(limits(beam, LEGENDRE, 4 + 3*i).v_crit/exact - 1.0);
	order = log2(sine[0]/sine[1]);
	ok(sine[1] > 0.0 && order > 4.0 && order < 9.0, "sines: from above, order %.2f, errors %.1e %.1e",
	   order, sine[0], sine[1]);
	order = log2(hermite[0]/hermite[1]);
	ok(fabs(order - 4.0) < 0.15, "Hermite elements: order %.3f", order);
	ok(legendre[1] < 1e-2*legendre[0] && legendre[2] < 1e-2*legendre[1],
	   "Legendre: errors %.1e, %.1e, %.1e fall faster than any power", legendre[0], legendre[1],
	   legendre[2]);
	for (int row = 0; row < 3; row++) {
		double error = limits(taut, row, 9).v_crit/best - 1.0;

		ok(fabs(error) < 1e-3, "%s with 9, mu 10: %.1e (D 9.4: within 0.1 %%)",
		   hawser_beam_method(row)->name, error);
	}
}

static enum hawser_status by_weight(struct hawser_beam *beam, void *context, double parameter,
                                    struct hawser_report *report)
{
	(void)report;
	*beam = *(struct hawser_beam *)context;
	beam->weight = parameter;
	return HAWSER_OK;
}

/* Every point of a boundary is the safe speed at its parameter; the end is where the column buckles. */
static void boundary(double drag)
{
	struct hawser_beam beam = {.theta = 1.0, .tension = 1.0, .drag = drag};
	const struct hawser_beam_family family = {by_weight, &beam};
	const struct hawser_beam_boundary_options options = {.from = 0.0, .to = 25.0, .modes = 4};
	struct hawser_beam_boundary curve;
	struct hawser_beam_integrals is;
	struct hawser_report report = {0};
	enum hawser_status status;
	double worst = 0.0, least = INFINITY, end = 0.0;

	if (!ok(hawser_beam_method(LEGENDRE)->fill(&is, HAWSER_ENDS_SIMPLE, 24, &report) == HAWSER_OK,
	        "boundary"))
		return;
	status = hawser_beam_boundary(&curve, &is, &family, &options, &report);
	ok(status == HAWSER_OK && curve.points > 40, "drag %g: %d points %s", drag, curve.points,
	   report.message);
	for (int i = 0; !status && i < curve.points; i++) {
		struct hawser_beam here = beam;

		if (curve.point[i].speed < least) {
			least = curve.point[i].speed;
			end = curve.point[i].parameter;
		}
		if (i%(getenv("HAWSER_LONG") ? 7 : 28) || curve.point[i].speed < 0.1)
			continue;
		here.weight = curve.point[i].parameter;
		worst = fmax(worst, fabs(curve.point[i].speed/limits(here, LEGENDRE, 24).v_crit - 1.0));
	}
	ok(worst < 1e-10, "its points are safe speeds to %.1e", worst);
	/* (1/2) rho - T = pi^2 would be the column of mean compression; the exact one by the static ODE */
	beam.weight = end;
	beam.drag = 0.0;
	ok(least < 1e-9 && fabs(shooting_determinant(&beam, 0.0)) < 1e-8,
	   "it comes down to %.1e at rho %.8f, where the column buckles: %.1e", least, end,
	   shooting_determinant(&beam, 0.0));
	hawser_beam_boundary_clear(&curve);
	hawser_beam_integrals_clear(&is);
}

/* Without drag, travel up and travel down are equivalent. With the flux of rotary momentum they are
 * not, and both have growing modes. */
static void directions(void)
{
	struct hawser_beam beam = {.theta = 1.0, .tension = 1.0, .weight = 10.0, .rotary = 0.0025,
	                           .speed = -1.0};
	struct hawser_beam_limits up, down;

	down = limits(beam, LEGENDRE, 40);
	beam.speed = 1.0;
	up = limits(beam, LEGENDRE, 40);
	ok(up.v_crit == 0.0 && up.cause == HAWSER_BEAM_BY_FLUX && up.v_first == 0.0 && up.slope > 0.0,
	   "upwards the first mode grows, slope %.6g", up.slope);
	ok(down.v_crit == 0.0 && down.cause == HAWSER_BEAM_BY_FLUX && down.v_first > 2.0 &&
	   down.slope > 0.0, "downwards high modes do, slope %.3g, and the first not up to %.6g",
	           down.slope,
	   down.v_first);
	beam.moment = HAWSER_MOMENT_BALANCED;
	up = limits(beam, LEGENDRE, 40);
	ok(up.cause == HAWSER_BEAM_DIVERGES && up.v_crit > 2.3,
	        "with balanced moments none does below %.10g",
	   up.v_crit);
}

/* Number of growing modes at a speed. */
static int growing(struct hawser_beam beam, const struct hawser_beam_integrals *is, double speed)
{
	struct hawser_beam_eigenvalue value[8];
	int found = 0, count = 0;

	beam.speed = speed;
	if (hawser_beam_eigenvalues(value, NULL, &found, is, &beam, 8, NULL))
		return -1;
	for (int i = 0; i < found; i++)
		count += value[i].re > 0.0;
	return count;
}

/* A change of stability is located to 1e-13 with a tenth of the eigenvalue problems that bisection
 * needs (43), also near the ends of the range and where the first frequency vanishes too. */
static void located(void)
{
	static const double range[][2] = {{20.2, 20.3}, {20.9, 21.0}, {21.2, 21.35}};
	static const enum hawser_beam_event_kind kind[] = {HAWSER_BEAM_DIVERGENCE, HAWSER_BEAM_CALM,
	                                                   HAWSER_BEAM_FLUTTER};
	const struct hawser_beam beam = {.theta = 1.0, .tension = 400.0, .drag = 0.5};
	struct hawser_beam_integrals is;

	if (!ok(!hawser_beam_method(LEGENDRE)->fill(&is, beam.ends, 38, NULL), "a damped beam of mu 20"))
		return;
	for (int i = 0; i < 3; i++) {
		struct hawser_beam_sweep_options options = {.from = range[i][0], .to = range[i][1],
		                                            .points = 2, .branches = 4, .loose = 1};
		struct hawser_beam_sweep sweep;
		double v;

		if (!ok(!hawser_beam_sweep(&sweep, &is, &beam, &options, NULL) && sweep.events == 1 &&
		        sweep.event[0].kind == kind[i], "%s between %g and %g",
		        hawser_beam_event_name(kind[i]), options.from, options.to))
			continue;
		v = sweep.event[0].speed;
		ok(growing(beam, &is, v*(1.0 - 1e-11)) == sweep.event[0].growing[0] &&
		   growing(beam, &is, v*(1.0 + 1e-11)) == sweep.event[0].growing[1],
		   "at %.12g: %d growing modes below, %d above", v, sweep.event[0].growing[0],
		   sweep.event[0].growing[1]);
		ok(sweep.solves <= 24, "by %d eigenvalue problems", sweep.solves);
		hawser_beam_sweep_clear(&sweep);
	}
	hawser_beam_integrals_clear(&is);
}

CASE(property_beam)
{
	located();
	closed_forms();
	strings();
	at_rest();
	shooting();
	orders();
	boundary(0.0);
	boundary(3.0);
	directions();
	return done_testing();
}
