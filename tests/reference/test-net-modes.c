/* Modes of a span as a mesh, against those of its smooth cable: B's Table 4.2 by the spectral method
 * of this program (hawser modes), which shares no code. The mean of consistent and lumped mass has
 * the errors 5.1e-4 with 25 elements and 3.3e-5 with 100. A taut string without weight has pairs in
 * closed form.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include <hawser/net_modes.h>

#include "tests/tap.h"

static struct hawser_report report;

static int solve(struct hawser_net_modes *modes, int n, const double end[3], double length0, double EA,
                 double rho, double g, int elements)
{
	static char name[] = "span";
	struct hawser_net_node node[2] = {
		{.name = "A", .placed = 1, .held = {1, 1, 1}, .support = 1},
		{.name = "B", .placed = 1, .x = {end[0], end[1], end[2]}, .held = {1, 1, 1}, .support = 1}};
	struct hawser_net_cable cable = {.name = "c", .from = 0, .to = 1, .EA = EA, .rho = rho,
	                                 .value = length0, .elements = elements};
	struct hawser_net net = {.name = name, .g = g, .node = node, .cable = &cable, .nodes = 2,
	                         .cables = 1};

	return ok(!hawser_net_modes_solve(modes, &net, n, &report), "%d elements %s", elements,
	          report.message);
}

static double chairlift(int elements)
{
	static const double omega[6] = {1.4492191951771718, 2.8913030461370441, 2.8975072322718183,
	                                3.9834810133098721, 4.34600283033671, 5.7913713048682922};
	static const double end[3] = {250.0, 10.0, 0.0};
	struct hawser_net_modes modes;
	double worst = 0.0;

	if (!solve(&modes, 6, end, 250.502889155, 4e8, 6.0, 9.81, elements))
		return NAN;
	for (int j = 0; j < 6; j++)
		worst = fmax(worst, fabs(modes.omega[j]/omega[j] - 1.0));
	ok(modes.share[0][2] > 1.0 - 1e-9 && modes.share[1][2] < 1e-9, "planes of the first two modes");
	hawser_net_modes_clear(&modes);
	return worst;
}

/* g nearly 0: frequencies j*pi/L*sqrt(T/rho) in pairs; modal mass rho*L/2; of the mesh to order 4. */
static void string(void)
{
	static const double end[3] = {0.0, 0.0, 10.0};
	const double T = 1e5*(10.0/9.5 - 1.0), rho = 0.7*9.5/10.0;
	struct hawser_net_modes modes;
	double worst = 0.0, heavy = 0.0;

	if (!solve(&modes, 6, end, 9.5, 1e5, 0.7, 1e-9, 400))
		return;
	for (int j = 0; j < 6; j++) {
		double x = (j/2 + 1)*M_PI/800.0, exact = (j/2 + 1)*M_PI/10.0*sqrt(T/rho);
		/* of the mesh: 2/h*sin(x)/sqrt(1 - 2/6*sin(x)^2), x = j*pi/(2n), h = L/n */
		double mesh = 80.0*sin(x)/sqrt(1.0 - sin(x)*sin(x)/3.0)*sqrt(T/rho);

		worst = fmax(worst, fabs(modes.omega[j]/mesh - 1.0));
		heavy = fmax(heavy, fabs(modes.omega[j]/exact - 1.0));
	}
	ok(worst <= 1e-13, "string: frequencies of its mesh in closed form, %.1e", worst);
	ok(heavy <= 1e-8, "and of the string, %.1e", heavy);
	hawser_net_modes_clear(&modes);
}

CASE(reference_net_modes)
{
	double coarse = chairlift(25), fine = chairlift(100);

	ok(fabs(coarse - 5.1e-4) <= 0.05e-4, "25 elements: %.2e", coarse);
	ok(fabs(fine - 3.3e-5) <= 0.05e-5, "100 elements: %.2e", fine);
	string();
	return done_testing();
}
