/* The fold's equations: the exact gradient of the fold condition against difference quotients, on a
 * model with every kind of term.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include <hawser/folds.h>

#include "response/locus/folds_walk.h"
#include "rom/build/model.h"
#include "tests/tap.h"

static double *copy(const double *from, size_t count)
{
	double *to = malloc(count*sizeof *to);

	memcpy(to, from, count*sizeof *to);
	return to;
}

/* Tensors without a potential, gyroscopic damping, a second harmonic with parametric terms. */
static int make(struct hawser_rom *rom)
{
	static const double K[] = {1.0, 0.13, 0.11, 4.2}, D[] = {0.03, 0.02, -0.02, 0.05};
	static const double f[] = {0.15, 0.07}, g[] = {0.02, -0.01};
	static const double PK[] = {0.02, 0.013, 0.0, 0.03}, PD[] = {0.01, 0.0, 0.007, -0.02};
	static const struct hawser_quad Q[] = {{0, 0, 1, 0.05}, {1, 0, 0, 0.06}, {1, 1, 1, -0.03}};
	static const struct hawser_cubic C[] = {{0, 0, 0, 0, 0.1}, {0, 0, 0, 1, 0.04},
	                                        {1, 0, 1, 1, 0.07}, {1, 1, 1, 1, 0.2}};

	if (hawser__rom_init(rom, 2, NULL))
		return 1;
	memcpy(rom->K, K, sizeof K);
	memcpy(rom->D, D, sizeof D);
	rom->quads = 3;
	rom->Q = malloc(sizeof Q);
	memcpy(rom->Q, Q, sizeof Q);
	rom->cubics = 4;
	rom->C = malloc(sizeof C);
	memcpy(rom->C, C, sizeof C);
	rom->harmonics = 2;
	rom->harmonic = calloc(2, sizeof *rom->harmonic);
	rom->harmonic[0] = (struct hawser_harmonic){.k = 1, .f = copy(f, 2)};
	rom->harmonic[1] = (struct hawser_harmonic){.k = 2, .phase = HAWSER_SIN, .omega_power = 1,
		.f = copy(g, 2), .K = copy(PK, 4), .D = copy(PD, 4)};
	return hawser_rom_compile(rom, NULL) != HAWSER_OK;
}

/* g with unknown i displaced by h; the borders do not change. */
static double moved(struct hawser__fold *fold, const double *z, int i, double h)
{
	double *other = copy(z, (size_t)fold->size), residual, g;

	other[i] += h;
	g = hawser__fold_evaluate(fold, &residual, other, NULL) ? NAN : fold->g;
	free(other);
	return g;
}

/* The exact derivative with respect to an unknown of size `unit` in the scaled system. */
static double quotient(struct hawser__fold *fold, const double *z, int i, double unit)
{
	double h = 1e-3*unit;

	/* fourth order: the remaining error is round-off, some 1e-12 over the step */
	return (8.0*(moved(fold, z, i, h) - moved(fold, z, i, -h)) -
	        (moved(fold, z, i, 2.0*h) - moved(fold, z, i, -2.0*h)))/(12.0*h)*unit;
}

static void check_gradient(struct hawser__fold *fold, const double *z)
{
	int P = fold->balance.unknowns, last = fold->size - 1;
	double *gradient = copy(fold->g_y, (size_t)P), *scale = copy(fold->balance.col_scale, (size_t)P);
	double g_omega = fold->g_omega, g_load = fold->g_load, W = fold->balance.base.W;
	double largest = 0.0, worst = 0.0;

	for (int i = 0; i < P; i++)
		largest = fmax(largest, fabs(gradient[i]));
	for (int i = 0; i < P; i++)
		worst = fmax(worst, fabs(quotient(fold, z, fold->balance.slot[i], scale[i]) -
		                         gradient[i]));
	ok(P > 20 && worst < 1e-8*largest, "g_y of %d coefficients: off by %.1e of the largest, %.2e", P,
	   worst/largest, largest);
	close_to(quotient(fold, z, last - 1, W), g_omega, 1e-7, "g_Omega");
	close_to(quotient(fold, z, last, fold->L), g_load, 1e-7, "g_load");
	free(gradient);
	free(scale);
}

/* dF/dload against the defects at two loads; they are linear in the load. */
static void check_load(struct hawser__fold *fold, const double *z)
{
	int P = fold->balance.unknowns, last = fold->size - 1;
	double *by_load = malloc((size_t)P*sizeof *by_load), *F = malloc((size_t)P*sizeof *F);
	double *other = copy(z, (size_t)fold->size), residual, worst = 0.0;

	other[last] += 0.5;
	ok(!hawser__fold_evaluate(fold, &residual, other, NULL), "evaluated at another load");
	memcpy(F, fold->F, (size_t)P*sizeof *F);
	ok(!hawser__fold_evaluate(fold, &residual, z, NULL), "and at the fold");
	ok(residual < 1e-10, "residual there: %.1e", residual);
	hawser__fold_by_load(fold, by_load);
	for (int i = 0; i < P; i++)
		worst = fmax(worst, fabs((F[i] - fold->F[i])/0.5 - by_load[i]));
	ok(worst < 1e-13, "F_load: off by %.1e", worst);
	free(by_load);
	free(F);
	free(other);
}

/* The null vectors are those of the Jacobian: F does not change to second order along the curve. */
static void check_tangent(struct hawser__fold_walk *walk)
{
	struct hawser__fold *fold = walk->fold;
	double *other = copy(walk->start.z, (size_t)fold->size), residual[2], g[2];

	hawser__walk_finish(walk, &walk->start, walk->start.t);
	for (int k = 0; k < 2; k++) {
		double h = k ? 1e-3 : 2e-3;

		for (int i = 0; i < fold->size; i++)
			other[i] = walk->start.z[i] + h*walk->start.t[i];
		ok(!hawser__fold_evaluate(fold, &residual[k], other, NULL), "a step of %g", h);
		g[k] = fold->g;
	}
	ok(fabs(log2(residual[0]/residual[1]) - 2.0) < 0.05, "defect falls with order %.3f",
	   log2(residual[0]/residual[1]));
	ok(fabs(log2(fabs(g[0]/g[1])) - 2.0) < 0.1, "g falls with order %.3f",
	   log2(fabs(g[0]/g[1])));
	free(other);
}

/* The nearest point before the first fold of the response. */
static int begin(struct hawser__fold_walk *walk, const struct hawser_rom *rom)
{
	struct hawser_frf_options options = {.method = NULL};
	struct hawser_frf frf;
	int found = 0, failed = 1;

	options.from = 0.8;
	options.to = 1.6;
	if (hawser_frf_trace(&frf, rom, &options, NULL))
		return 0;
	for (int e = 0; e < frf.events && !found; e++)
		if (frf.event[e].kind == HAWSER_FOLD) {
			int p = frf.event[e].after;

			found = !hawser__walk_begin(walk, frf.state + 4*(size_t)p,
			                            frf.point[p].omega, 1.0, &failed) && !failed;
			close_to(walk->start.z[walk->fold->size - 2], frf.event[e].omega, 1e-9,
			         "the fold is the response's");
		}
	hawser_frf_clear(&frf);
	return found;
}

/* From states so far away on both sides that Newton's method alone does not converge. */
static void check_between(struct hawser__fold_walk *walk, const struct hawser_rom *rom)
{
	struct hawser_frf_options options = {.method = NULL};
	int failed = 1, size = walk->fold->size;
	double *z = copy(walk->start.z, (size_t)size);
	struct hawser_frf frf;

	options.from = 0.8;
	options.to = 1.6;
	if (!ok(!hawser_frf_trace(&frf, rom, &options, NULL), "traced"))
		return;
	for (int e = 0; e < frf.events; e++) {
		int a = frf.event[e].after - 3, b = frf.event[e].after + 4;

		if (frf.event[e].kind != HAWSER_FOLD || a < 0 || b >= frf.points)
			continue;
		ok(!hawser__walk_begin_between(walk, frf.state + 4*(size_t)a, frf.point[a].omega,
		                               frf.state + 4*(size_t)b, frf.point[b].omega, 1.0,
		                               &failed) && !failed, "begun between %d and %d", a, b);
		close_to(walk->start.z[size - 2], frf.event[e].omega, 1e-9, "the fold between them");
		ok(!hawser__walk_begin_between(walk, frf.state + 4*(size_t)a, frf.point[a].omega,
		                               frf.state + 4*(size_t)(a + 1),
		                               frf.point[a + 1].omega, 1.0, &failed) && failed,
		   "none where there is none");
		/* the same orbit of the fold as by harmonic balance */
		ok(!hawser__walk_begin_orbit(walk, z, 1.0, &failed) && !failed, "from the orbit");
		close_to(walk->start.z[size - 2], z[size - 2], 1e-12, "the same fold");
		break;
	}
	hawser_frf_clear(&frf);
	free(z);
}

CASE(unit_folds)
{
	struct hawser_folds_options options = {.method = NULL};
	struct hawser__fold_walk walk;
	struct hawser__fold fold;
	struct hawser_rom rom;
	double residual;

	options.from = 0.8;
	options.to = 1.6;
	options.tolerance = 1e-11;
	if (ok(!make(&rom), "model") && ok(!hawser__fold_open(&fold, &rom, NULL), "opened") &&
	    ok(!hawser__walk_open(&walk, &fold, &options, NULL), "walk") &&
	    ok(begin(&walk, &rom), "a fold found")) {
		check_load(&fold, walk.start.z);
		ok(!hawser__fold_evaluate(&fold, &residual, walk.start.z, NULL), "evaluated");
		ok(fabs(fold.g) < 1e-10, "g = %.1e at the fold", fold.g);
		check_gradient(&fold, walk.start.z);
		ok(!hawser__fold_evaluate(&fold, &residual, walk.start.z, NULL), "again");
		check_tangent(&walk);
		check_between(&walk, &rom);
	}
	hawser__walk_clear(&walk);
	hawser__fold_close(&fold);
	hawser_rom_clear(&rom);
	return done_testing();
}
