/* rom-export-values MODEL STEM: the model's equations for other programs, and in STEM.txt its forces
 * and derivatives at random states, for tests/reference/rom-export.sh: n, then for each state t, Omega,
 * u, v, acceleration, by_u, by_v, by_omega at fixed phase.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include <hawser/rom.h>

enum { MOST = 10, STATES = 5 };

static double noise(unsigned *seed)
{
	*seed = *seed*1664525u + 1013904223u;
	return (*seed >> 8)/8388608.0 - 1.0;
}

static void put(FILE *out, const double *x, int count)
{
	for (int i = 0; i < count; i++)
		fprintf(out, "%.17g ", x[i]);
}

int main(int argc, char **argv)
{
	double x[2*MOST], a[MOST], by_u[MOST*MOST], by_v[MOST*MOST], by_omega[MOST];
	static const char *const format[] = {"coco", "matcont", "bifurcationkit"};
	static const char *const short_name[] = {"coco", "matcont", "julia"};
	struct hawser_report report = {.message = ""};
	struct hawser_rom rom;
	unsigned seed = 5u;
	char path[400];
	FILE *out;
	int n, failed = argc != 3 || hawser_rom_open(&rom, argv[1], &report) || rom.n > MOST;

	for (int k = 0; k < 3 && !failed; k++) {
		snprintf(path, sizeof path, "%s_%s", argv[2], short_name[k]);
		failed = hawser_rom_export(&rom, format[k], path, &report) != HAWSER_OK;
	}
	if (argc == 3)
		snprintf(path, sizeof path, "%s.txt", argv[2]);
	if (failed || !(out = fopen(path, "w"))) {
		fprintf(stderr, "%s\n", report.message);
		return 1;
	}
	n = rom.n;
	fprintf(out, "%d\n", n);
	for (int s = 0; s < STATES; s++) {
		double t = 2.0*noise(&seed), omega = 1.0 + 0.5*noise(&seed);

		for (int i = 0; i < 2*n; i++)
			x[i] = noise(&seed);
		hawser_rom_acceleration_jacobian(&rom, a, by_u, by_v, by_omega, x, x + n, omega*t, omega);
		fprintf(out, "%.17g %.17g ", t, omega);
		put(out, x, 2*n);
		put(out, a, n);
		put(out, by_u, n*n);
		put(out, by_v, n*n);
		put(out, by_omega, n);
		fputc('\n', out);
	}
	fclose(out);
	hawser_rom_clear(&rom);
	return 0;
}
