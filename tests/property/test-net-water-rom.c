/* The force of the water on a net's model: its derivatives against differences, in a current and waves
 * with each stretching, with a buoy at the surface, a line through it and a support that moves; and the
 * force at rest. SPDX-License-Identifier: GPL-3.0-or-later */
#include <string.h>

#include <hawser/document.h>
#include <hawser/net_rom.h>

#include "tests/tap.h"

enum { MODES = 5, MOST = 24 };

static struct hawser_report report;

static const char scene[] =
	"kind: net\n"
	"nodes: {A: [0, -40, 0], J: {}, B: [12, 2.385, 2]}\n"
	"cables:\n"
	"  - {name: c1, from: A, to: J, EA: 2e7, rho: 3, length0: 39.6, elements: 8, diameter: 0.05,\n"
	"     drag: {normal: 1.2, tangential: 0.3}, added_mass: {normal: 0.9, tangential: 0.2}}\n"
	"  - {name: c2, from: J, to: B, EA: 1e6, rho: 2, length0: 10, elements: 8, diameter: 0.4,\n"
	"     drag: {normal: 1.1, tangential: 0.1}, added_mass: {normal: 1, tangential: 0}}\n"
	"supports: {A: fixed, B: {motion: {x: {amplitude: 0.4, multiple: 1, phase: 0.3}}}}\n"
	"buoys: {J: {mass: 900, volume: 2, CdA: 2, added_mass: 0.5}}\n"
	"water: {density: 1025, depth: 50, current: {table: [[-40, 0.1, 0, 0.3], [0, 0.9, 0.1, -0.2]]},\n"
	"  waves: {height: 3, period: 7, heading: 35, phase: 0.4}, stretching: %s}\n";

static int make(struct hawser_rom *rom, const char *stretching, const char *more)
{
	const struct hawser_net_rom_options options = {.n = MODES, .raw = 1};
	struct hawser_document document;
	struct hawser_net net = {.nodes = 0};
	struct hawser_modes modes;
	char text[2048];
	FILE *file;
	int good, size = snprintf(text, sizeof text, scene, stretching);

	size += snprintf(text + size, sizeof text - (size_t)size, "%s", more);
	file = fmemopen(text, (size_t)size, "r");
	good = ok(!hawser_document_read(&document, file, "water", &report) &&
	          !hawser_net_of(&net, &document, NULL, 0, &report) &&
	          !hawser_net_rom_build(rom, &modes, &net, &options, &report), "%s%s", stretching,
	          report.message);
	fclose(file);
	hawser_document_clear(&document);
	hawser_net_clear(&net);
	hawser_modes_clear(&modes);
	return good;
}

/* slope [n] += part of the difference of accelerations at x + h and x - h. */
static void differ(double *slope, const struct hawser_rom *rom, const double *u, const double *v,
                   double tau, const double *omega, double *x, double h, double part)
{
	double keep = *x, a[MOST], back[MOST];

	*x = keep + h;
	hawser_rom_acceleration(rom, a, u, v, tau, *omega);
	*x = keep - h;
	hawser_rom_acceleration(rom, back, u, v, tau, *omega);
	*x = keep;
	for (int j = 0; j < rom->n; j++)
		slope[j] += part*(a[j] - back[j])/(2.0*h);
}

/* The largest difference of derivatives by u, v and Omega in worst [3], and the largest of those by v
 * and Omega in size [3]; by u they are hidden behind K, and are of the size of those by v. */
static void compare(double worst[3], double size[3], const struct hawser_rom *rom, double *u, double *v,
                    double tau, double omega)
{
	double a[MOST], by_u[MOST*MOST], by_v[MOST*MOST], by_omega[MOST];
	int n = rom->n;

	hawser_rom_acceleration_jacobian(rom, a, by_u, by_v, by_omega, u, v, tau, omega);
	for (int i = 0; i <= 2*n; i++) {
		double *x = i < n ? &u[i] : i < 2*n ? &v[i - n] : &omega, slope[MOST] = {0.0};
		int kind = i/n < 2 ? i/n : 2;
		double h = 1e-6/(1.0 + 0.2*sqrt(rom->K[i%n*(n + 1)])); /* stiff ones are light, and move far */

		differ(slope, rom, u, v, tau, &omega, x, h, 4.0/3.0);
		differ(slope, rom, u, v, tau, &omega, x, 2.0*h, -1.0/3.0);
		for (int j = 0; j < n; j++) {
			double is = kind == 0 ? by_u[j*n + i] : kind == 1 ? by_v[j*n + i - n] : by_omega[j];

			worst[kind] = fmax(worst[kind], fabs(is - slope[j]));
			size[kind] = kind ? fmax(size[kind], fabs(is)) : size[0];
		}
	}
	size[0] = size[1];
}

CASE(property_net_water_rom)
{
	static const char *const stretching[] = {"wheeler", "none", "vertical", "extrapolate"};

	for (int s = 0; s < 4; s++) {
		double u[MOST] = {0.0}, v[MOST] = {0.0};
		double worst[3] = {0.0}, size[3] = {0.0};
		struct hawser_rom rom;

		if (!make(&rom, stretching[s], ""))
			continue;
		ok(rom.n <= MOST && hawser_rom_loaded(&rom), "  %d coordinates", rom.n);
		for (int t = 0; t < 6; t++) {
			for (int j = 0; j < rom.n; j++) {
				u[j] = 4e-3*cos(2.385*(t*rom.n + j))/(1.0 + 0.01*rom.K[j*(rom.n + 1)]);
				v[j] = 6e-3*sin(1.7*(t*rom.n + j))/(1 + j);
			}
			compare(worst, size, &rom, u, v, 1.1*t + 0.45, 0.9*rom.time);
		}
		memset(v, 0, sizeof v);
		memset(u, 0, sizeof u);
		u[2] = 1e-6;
		close_to(hawser_rom_energy(&rom, u, v), 0.5e-12*rom.K[2*(rom.n + 1)], 1e-3,
		         "  the energy has its potential");
		ok(worst[0] < 1e-7*size[0] && worst[1] < 1e-7*size[1] && worst[2] < 1e-7*size[2],
		   "  derivatives by u, v, Omega within %.1e, %.1e, %.1e of differences", worst[0]/size[0],
		   worst[1]/size[1], worst[2]/size[2]);
		hawser_rom_clear(&rom);
	}
	return done_testing();
}
