/* What of lines and spheres is wet, against sums over many parts and differences.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include <hawser/water.h>

#include "tests/tap.h"
#include "water/water.h"

enum { CUTS = 20000 };

static void line_at(double a, double b, double surface, double band)
{
	struct hawser__wet wet, up, down;
	double sum[2] = {0.0}, step = 1e-6*band, moved[2] = {a, b};

	hawser__wet_line(&wet, surface, band, (const double[2]){a, b});
	for (int i = 0; i < CUTS; i++) {
		double s = (i + 0.5)/CUTS, y = a + (b - a)*s;
		double f = fmin(fmax((surface - y)/band + 0.5, 0.0), 1.0)/CUTS;

		sum[0] += f*(1.0 - s);
		sum[1] += f*s;
	}
	for (int i = 0; i < 2; i++) {
		ok(fabs(wet.part[i] - sum[i]) < 1e-8, "wet part at end %d from %g to %g: %.9g", i, a, b,
		   wet.part[i]);
		moved[i] += step;
		hawser__wet_line(&up, surface, band, moved);
		moved[i] -= 2.0*step;
		hawser__wet_line(&down, surface, band, moved);
		moved[i] += step;
		for (int j = 0; j < 2; j++)
			ok(fabs(wet.by[j][i]*band - (up.part[j] - down.part[j])/(2.0*step)*band) < 2e-6,
			   "its derivative %g", wet.by[j][i]*band);
	}
}

CASE(unit_wet)
{
	static const double y[][2] = {{-3.1, -2.2}, {2.1, 3.7}, {-3.1, 2.385}, {2.385, -3.1}, {0.71, 0.71},
	                              {0.6, 0.93}, {0.55, -2.0}, {0.9, 0.2}, {0.9, 1.9}};
	struct hawser_water_level level[2] = {{-10.0, {0.5, 0.0, 0.1}}, {-2.0, {1.3, 0.0, -0.2}}};
	const struct hawser_water water = {.density = 1000.0, .current = level, .levels = 2};
	double by, change, u[3], u_y[3];

	for (size_t i = 0; i < sizeof y/sizeof *y; i++)
		line_at(y[i][0], y[i][1], 0.7, 0.831);
	close_to(hawser__wet_sphere(&by, 0.3, 2.385, 0.3), 0.5*2.385, 1e-14, "half of a sphere");
	close_to(by, -M_PI*pow(0.75*2.385/M_PI, 2.0/3.0), 1e-14, "its circle");
	change = hawser__wet_sphere(&by, 0.3, 2.385, 0.501) - hawser__wet_sphere(&by, 0.3, 2.385, 0.499);
	(void)hawser__wet_sphere(&by, 0.3, 2.385, 0.5);
	close_to(change/0.002, by, 1e-5, "derivative of a cap");
	ok(hawser__wet_sphere(&by, 0.3, 2.385, -9.0) == 2.385 && by == 0.0, "below the surface");
	ok(hawser__wet_sphere(&by, 0.3, 2.385, 9.0) == 0.0 && by == 0.0, "above it");
	hawser__water_current(u, u_y, &water, -4.0);
	close_to(u[0], 1.1, 1e-15, "current between two heights");
	close_to(u_y[0], 0.1, 1e-15, "its derivative");
	hawser__water_current(u, u_y, &water, 3.0);
	ok(u[0] == 1.3 && u[2] == -0.2 && u_y[0] == 0.0, "current above the last height");
	return done_testing();
}
