/* Parametric excitation of an oscillator with a cubic term: rest becomes unstable at two period
 * doublings, where motions of twice the period begin.
 *
 *      u" + c u' + (1 + h cos(Omega t)) u + alpha u^3 = 0        u = a cos(Omega t/2 + phase) + ...
 *
 * To first order (A. H. Nayfeh and D. T. Mook, Nonlinear Oscillations (1979) sec. 5.7), with sigma =
 * 1 - Omega^2/4:
 *
 *      rest     sigma^2 + (c Omega/2)^2 = (h/2)^2 at both period doublings
 *      motions  3 alpha a^2/4 = -sigma +- sqrt((h/2)^2 - (c Omega/2)^2), stable with +
 *
 * What this leaves out is of the next order: it falls with h and c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <hawser/branches.h>

#include "tests/tap.h"

#define ALPHA 0.6

static int make(struct hawser_rom *rom, double c, double h)
{
	char name[] = "/tmp/hawser-mathieu-XXXXXX", text[400];
	int file = mkstemp(name), fine;

	snprintf(text, sizeof text, "{\"n\": 1, \"K\": [[1]], \"D\": [[%.17g]], \"C\": [[0, 0, 0, 0, %g]],"
	         " \"harmonics\": [{\"k\": 1, \"phase\": \"cos\", \"K\": [[%.17g]]}]}", c, ALPHA, h);
	fine = file >= 0 && write(file, text, strlen(text)) > 0;
	fine = fine && !hawser_rom_open(rom, name, NULL);
	close(file);
	remove(name);
	return fine;
}

/* The largest relative distance of the branch's a^2 from the closed form, for motions of some size. */
static double distance(const struct hawser_frf *branch, double c, double h, double sign)
{
	double worst = 0.0;

	for (int p = 0; p < branch->points; p++) {
		double omega = branch->point[p].omega, a = branch->coordinate[p];
		double X = omega*omega/4.0 - 1.0 + sign*sqrt(h*h/4.0 - c*c*omega*omega/4.0);

		if (X > 0.2*h)
			worst = fmax(worst, fabs(0.75*ALPHA*a*a/X - 1.0));
	}
	return worst;
}

/* off [0]: of the period doublings, relative to h; [1], [2]: of both branches. */
static void compare(double off[3], double scale, const char *method)
{
	double c = 0.2*scale, h = scale;
	struct hawser_frf_options options = {.from = 2.0 - h, .to = 2.0 + 2.0*h, .method = method,
		.step_max = 0.02, .samples = HAWSER_NONE};
	struct hawser_report report = {.message = ""};
	struct hawser_rom rom;
	struct hawser_frf frf, branch;

	off[0] = off[1] = off[2] = NAN;
	if (!ok(make(&rom, c, h), "a model") ||
	    !ok(!hawser_frf_trace(&frf, &rom, &options, &report) && frf.events == 2, "rest %s",
	        report.message))
		return;
	off[0] = 0.0;
	for (int e = 0; e < 2; e++) {
		double omega = frf.event[e].omega, sigma = 1.0 - omega*omega/4.0;

		off[0] = fmax(off[0], fabs(fabs(sigma) - sqrt(h*h/4.0 - c*c*omega*omega/4.0))/h);
		if (!ok(frf.event[e].kind == HAWSER_PERIOD_DOUBLING &&
		        !hawser_branch_switch(&branch, &rom, &frf, e, &options, &report), "%s: the branch at "
		        "Omega %.9g %s", method, omega, report.message))
			break;
		ok(branch.period == 2 && branch.points > 20 && branch.end == HAWSER_END_RANGE &&
		   (branch.point[branch.points/2].unstable == 0) == (e == 0), "of period 2, %s",
		   e == 0 ? "stable" : "unstable");
		off[1 + e] = distance(&branch, c, h, e == 0 ? 1.0 : -1.0);
		hawser_frf_clear(&branch);
	}
	hawser_frf_clear(&frf);
	hawser_rom_clear(&rom);
}

static void check(const char *method)
{
	static const char *const name[] = {"period doublings", "stable motions", "unstable motions"};
	double coarse[3], fine[3];

	compare(coarse, 0.04, method);
	compare(fine, 0.02, method);
	for (int i = 0; i < 3; i++)
		ok(fine[i] < 0.03 && fabs(coarse[i]/fine[i] - 2.0) < 0.1, "%s: %s off by %.2e "
		   "and %.2e", method, name[i], coarse[i], fine[i]);
}

CASE(property_mathieu_duffing)
{
	check("shooting");
	check("balance");
	return done_testing();
}
