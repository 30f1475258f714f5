/* The whirling of a taut string: the motion in the loaded plane becomes unstable against motions across
 * it. Two equal oscillators (the first modes in both planes) whose stiffness grows with the whole
 * elongation, one of them loaded:
 *
 *      u" + c u' + u + alpha u (u^2 + w^2) = F cos(Omega t)
 *      w" + c w' + w + alpha w (u^2 + w^2) = 0
 *
 * To first order (averaging; R. Narasimha, J. Sound Vib. 8 (1968) 134; J. W. Miles, J. Acoust. Soc.
 * Am. 38 (1965) 855 and 75 (1984) 1505), with X = alpha a^2/4 of the plane motion of amplitude a and
 * sigma = 1 - Omega^2:
 *
 *      plane motion      a^2 ((sigma + 3 X)^2 + c^2) = F^2
 *      w = 0 is lost     (sigma + X)(sigma + 3 X) + c^2 = 0
 *
 * so that both branch points are at X = c cosh q, sigma = -c (2 cosh q + sinh q) with
 *
 *      cosh(q)^2 exp(-q) = alpha F^2/(8 c^3)
 *
 * whose least value 4/(3 sqrt 3), at tanh q = 1/2, is the threshold of the force: F^2 =
 * 32 c^3/(3 sqrt 3 alpha), three times that at which the plane motion begins to fold. The next order is
 * a part c of Omega - 1, so that the distance falls fourfold as c is halved.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <hawser/branches.h>

#include "tests/tap.h"

#define ALPHA 0.7

static int make(struct hawser_rom *rom, double c, double force)
{
	char name[] = "/tmp/hawser-whirling-XXXXXX", text[600];
	int file = mkstemp(name), fine;

	snprintf(text, sizeof text, "{\"n\": 2, \"K\": [[1, 0], [0, 1]], \"D\": [[%.17g, 0], [0, %.17g]],"
	         " \"C\": [[0, 0, 0, 0, %g], [0, 0, 1, 1, %g], [1, 1, 1, 1, %g], [1, 0, 0, 1, %g]],"
	         " \"harmonics\": [{\"k\": 1, \"phase\": \"cos\", \"f\": [%.17g, 0]}]}", c, c, ALPHA, ALPHA,
	         ALPHA, ALPHA, force);
	fine = file >= 0 && write(file, text, strlen(text)) > 0;
	fine = fine && !hawser_rom_open(rom, name, NULL);
	close(file);
	remove(name);
	return fine;
}

/* The closed form: q on one side of its least value, from F^2 over that of the threshold. */
static double place(double over, int side)
{
	double least = 4.0/(3.0*sqrt(3.0)), low = atanh(0.5), high = low + side*20.0;

	for (int i = 0; i < 200; i++) {
		double q = 0.5*(low + high);

		if (cosh(q)*cosh(q)*exp(-q) < over*least)
			low = q;
		else
			high = q;
	}
	return low;
}

static double threshold(double c)
{
	return sqrt(32.0*c*c*c/(3.0*sqrt(3.0)*ALPHA));
}

/* Omega of the branch points of the plane motion, in ascending order; returns their number. */
static int branch_points(double *omega, double c, double force, const char *method)
{
	struct hawser_frf_options options = {.from = 1.0 - 5.0*c, .to = 1.0 + 12.0*c, .method = method,
		.samples = HAWSER_NONE, .step_max = 0.05};
	struct hawser_report report = {.message = ""};
	struct hawser_rom rom;
	struct hawser_frf frf;
	int count = 0;

	if (!ok(make(&rom, c, force), "a model") ||
	    !ok(!hawser_frf_trace(&frf, &rom, &options, &report), "%s: response %s", method,
	        report.message))
		return -1;
	for (int e = 0; e < frf.events; e++)
		if (frf.event[e].kind == HAWSER_BRANCH_POINT && count < 4)
			omega[count++] = frf.event[e].omega;
	for (int p = 0; p < frf.points; p++)
		if (frf.coordinate[2*p + 1] != 0.0)
			count = -2;
	if (count == 2 && omega[0] > omega[1]) {
		double keep = omega[0];

		omega[0] = omega[1];
		omega[1] = keep;
	}
	hawser_frf_clear(&frf);
	hawser_rom_clear(&rom);
	return count;
}

static void check_threshold(const char *method)
{
	double c = 2e-3, omega[4];

	ok(branch_points(omega, c, 0.985*threshold(c), method) == 0, "%s: none below", method);
	ok(branch_points(omega, c, 1.015*threshold(c), method) == 2, "%s: two above", method);
	close_to(0.5*(omega[0] + omega[1]) - 1.0, 2.5*c/sqrt(3.0), 0.03, "which are born at this distance");
}

/* Their distance from the closed form at a force above the threshold is of second order: some squares
 * of their distance from 1, and a quarter with c halved, up to the next order, which is then halved. */
static void check_places(double over)
{
	double apart[2][3], omega[4], away[2];

	for (int k = 0; k < 3; k++) {
		double c = 4e-3/(1 << k);

		if (!ok(branch_points(omega, c, sqrt(over)*threshold(c), k%2 ? "balance" : "shooting") == 2,
		        "two branch points"))
			return;
		for (int side = 0; side < 2; side++) {
			double q = place(over, side ? 1 : -1), sigma = -c*(2.0*cosh(q) + sinh(q));

			away[side] = sqrt(1.0 - sigma) - 1.0;
			apart[side][k] = omega[side] - 1.0 - away[side];
		}
	}
	for (int side = 0; side < 2; side++) {
		double first = apart[side][0]/apart[side][1], second = apart[side][1]/apart[side][2];

		ok(fabs(apart[side][2]) < 4.0*away[side]*away[side] && fabs(first - 4.0) < 0.25 &&
		   fabs((second - 4.0)/(first - 4.0) - 0.5) < 0.06, "F^2 %g of the threshold: %.2e from the "
		   "closed form at Omega - 1 = %.1e; ratios %.3f, %.3f", over, apart[side][2], away[side],
		   first, second);
	}
}

CASE(property_whirling)
{
	check_threshold("shooting");
	check_threshold("balance");
	check_places(1.5);
	check_places(3.0);
	return done_testing();
}
