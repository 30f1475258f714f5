/* bench/correction.c - in-plane modes that respond at twice the frequency of the response: keep
 * them, or correct the cubic coefficient? Prints the largest amplitude (scaled) of the first
 * out-of-plane mode, and its folds over its frequency, for
 *
 *   static      every other mode condensed statically
 *   at w1       the cubic coefficient corrected by their dynamic response at 2 w1
 *   at Omega    the same at twice a frequency of the response, OMEGA w1
 *   kept        the listed modes kept, the others static
 *
 *   bench/correction SCENE OMEGA
 *
 * The correction is -(2/3) sum beta_s^2 (1/(w_s^2 - 4 W^2) - 1/w_s^2), beta_s = T_11s/2: its part
 * in the first harmonic.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include <hawser/hawser.h>

static struct hawser_report report;

/* T = D^3V3[Phi_1, Phi_1, Phi_s]; the first mode is out of plane, so that a = b = 0. */
static double third(const struct hawser_modes *modes, int s)
{
	size_t points = (size_t)modes->grid.points;
	const double *x = modes->slope, *z = modes->slope + 3*points*(size_t)s;
	double sum = 0.0;

	for (size_t p = 0; p < points; p++) {
		double g = 1.0 + hawser_statics_frame(&modes->statics, modes->grid.s[p]).strain;

		sum += modes->grid.weight[p]/(g*g*modes->statics.epsilon)*z[3*p]*x[3*p + 2]*x[3*p + 2];
	}
	return sum;
}

static int follow(const char *name, const struct hawser_rom *rom, double w)
{
	struct hawser_frf_options options = {.method = NULL};
	struct hawser_frf frf;
	double most = 0.0;

	options.from = 0.8*w;
	options.to = 1.3*w;
	options.step_max = 0.005;
	if (hawser_frf_trace(&frf, rom, &options, &report)) {
		printf("%-22s %s\n", name, report.message);
		hawser_frf_clear(&frf);
		return 1;
	}
	for (int i = 0; i < frf.points; i++)
		most = fmax(most, frf.coordinate[(size_t)i*frf.n]);
	printf("%-22s %.5f  ", name, most);
	for (int i = 0; i < frf.events; i++)
		if (frf.event[i].kind == HAWSER_FOLD)
			printf(" %.4f", frf.event[i].omega/w);
	putchar('\n');
	hawser_frf_clear(&frf);
	return 0;
}

/* The first `count` modes in an order of importance. */
static int keep(const struct hawser_modes *modes, const struct hawser_scene *scene, int count)
{
	int all[] = {0, 1, 3, 5, 9, 13, 17}, chosen[7], n = 0;
	struct hawser_modes subset;
	struct hawser_rom rom;
	char name[40];

	for (int k = 0; k < count; k++)
		chosen[n++] = all[k];
	if (hawser_modes_select(&subset, modes, chosen, n, &report) ||
	    hawser_rom_build(&rom, &subset, scene, &report))
		return 1;
	snprintf(name, sizeof name, "kept, %d to w%d", count, chosen[n - 1] + 1);
	if (count > 1)
		(void)follow(name, &rom, modes->mode[0].omega);
	else
		(void)follow("static", &rom, modes->mode[0].omega);
	hawser_rom_clear(&rom);
	hawser_modes_clear(&subset);
	return 0;
}

static int correct(const struct hawser_modes *modes, const struct hawser_scene *scene, double part)
{
	const int one[] = {0};
	double w = modes->mode[0].omega, W = part*w;
	struct hawser_modes subset;
	struct hawser_rom rom;
	char name[40];

	if (hawser_modes_select(&subset, modes, one, 1, &report) ||
	    hawser_rom_build(&rom, &subset, scene, &report))
		return 1;
	for (int s = 1; s < modes->n; s++) {
		double beta = 0.5*third(modes, s), ws2 = pow(modes->mode[s].omega, 2);

		rom.C[0].value -= 2.0/3.0*beta*beta*(1.0/(ws2 - 4.0*W*W) - 1.0/ws2);
	}
	snprintf(name, sizeof name, "corrected at %g w1", part);
	if (!hawser_rom_compile(&rom, &report))
		(void)follow(name, &rom, w);
	hawser_rom_clear(&rom);
	hawser_modes_clear(&subset);
	return 0;
}

int main(int argc, char **argv)
{
	static const char *const set[] = {"model.condense=static"};
	struct hawser_modes_options options = {.n = 40};
	struct hawser_scene scene;
	struct hawser_statics statics;
	struct hawser_modes modes;

	if (argc != 3) {
		fprintf(stderr, "usage: correction SCENE OMEGA\n");
		return 1;
	}
	if (hawser_scene_open(&scene, argv[1], set, 1, &report) ||
	    hawser_statics_scene(&statics, &scene, &report) ||
	    hawser_modes_solve(&modes, &statics, &options, &report) || keep(&modes, &scene, 1) ||
	    correct(&modes, &scene, 1.0) || correct(&modes, &scene, atof(argv[2]))) {
		fprintf(stderr, "%s\n", report.message);
		return 1;
	}
	for (int count = 3; count <= 7; count++)
		if (keep(&modes, &scene, count))
			return 1;
	hawser_modes_clear(&modes);
	hawser_scene_clear(&scene);
	return 0;
}
