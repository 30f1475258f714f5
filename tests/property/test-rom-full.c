/* The full-order model by other routes. Its force is the gradient of its energy and its tangent the
 * derivative of its force (by integrals along lines, to round-off). To fourth order it equals the
 * expanded model. Under a constant load its equilibrium is the elastic catenary of the resultant of
 * weight and load, in the plane of the resultant and the chord, for which the statics has a closed
 * form.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <lapacke.h>
#include <stdlib.h>

#include <hawser/rom.h>

#include "rom/energy/kernel.h"
#include "tests/modes-span.h"
#include "tests/tap.h"

enum { MAX = 100, NODES = 24 };

static double uniform(void)
{
	return 2.0*rand()/RAND_MAX - 1.0;
}

/* Random slopes of order `size`. */
static void draw(double *u, const struct hawser_rom *rom, double size)
{
	for (int j = 0; j < rom->n; j++)
		u[j] = size*uniform()/sqrt(rom->K[j*rom->n + j]);
}

static double norm(const double *v, int n)
{
	double sum = 0.0;

	for (int j = 0; j < n; j++)
		sum += v[j]*v[j];
	return sqrt(sum);
}

/* Nodes and weights of Gauss's rule on [-1, 1], by bisection between approximate zeros. */
static void gauss(double *x, double *w)
{
	for (int i = 0; i < NODES; i++) {
		double z = cos(M_PI*(i + 0.75)/(NODES + 0.5)), slope = 1.0;

		for (int k = 0; k < 20; k++) {
			double below = 1.0, value = z;

			for (int j = 2; j <= NODES; j++) {
				double next = ((2*j - 1)*z*value - (j - 1)*below)/j;

				below = value;
				value = next;
			}
			slope = NODES*(z*value - below)/(z*z - 1.0);
			z -= value/slope;
		}
		x[i] = z;
		w[i] = 2.0/((1.0 - z*z)*slope*slope);
	}
}

/* Along u + t w, t in [-1, 1]: differences of energy and force between the ends against integrals
 * of force and tangent. */
static void check_line(const struct hawser_rom *rom, const double *u, double size, const char *name)
{
	int n = rom->n;
	double w[MAX], at[MAX], f[2][MAX], rest[MAX] = {0.0}, x[NODES], weight[NODES];
	double energy, work = 0.0, sum[MAX] = {0.0}, scale, *T = malloc((size_t)n*n*sizeof *T);
	double asymmetry = 0.0;

	gauss(x, weight);
	draw(w, rom, size);
	for (int i = 0; i < 2; i++) {
		for (int j = 0; j < n; j++)
			at[j] = u[j] + (i ? w[j] : -w[j]);
		hawser_rom_restoring(rom, f[i], at);
	}
	energy = hawser_rom_energy(rom, at, rest);
	for (int j = 0; j < n; j++)
		at[j] = u[j] - w[j];
	energy -= hawser_rom_energy(rom, at, rest);
	for (int i = 0; T && i < NODES; i++) {
		double force[MAX];

		for (int j = 0; j < n; j++)
			at[j] = u[j] + x[i]*w[j];
		hawser_rom_tangent(rom, force, T, at);
		for (int j = 0; j < n; j++) {
			work += weight[i]*force[j]*w[j];
			for (int k = 0; k < n; k++) {
				sum[j] += weight[i]*T[j*n + k]*w[k];
				asymmetry += fabs(T[j*n + k] - T[k*n + j]);
			}
		}
	}
	scale = fabs(energy) + norm(f[0], n)*norm(w, n);
	ok(fabs(energy - work) < 1e-12*scale, "%s: energy is the work of the force, %.1e", name,
	   fabs(energy - work)/scale);
	for (int j = 0; j < n; j++)
		sum[j] -= f[1][j] - f[0][j];
	scale = norm(f[0], n) + norm(f[1], n);
	ok(norm(sum, n) < 1e-11*scale, "%s: force is the integral of the tangent, %.1e", name,
	   norm(sum, n)/scale);
	ok(asymmetry == 0.0, "%s: the tangent is symmetric to the last bit", name);
	free(T);
}

static void check_rest(const struct hawser_rom *rom, const struct hawser_statics *st,
                       const char *name)
{
	struct hawser_modes_options options = {.n = 8, .tolerance = 1e-11};
	struct hawser_modes modes;
	int n = rom->n, zero = 1, ascending = 1;
	double u[MAX] = {0.0}, f[MAX], *T = malloc((size_t)n*n*sizeof *T), worst = 0.0, low = 0.0;

	hawser_rom_tangent(rom, f, T, u);
	for (int j = 0; j < n; j++) {
		zero = zero && f[j] == 0.0;
		ascending = ascending && (j == 0 || rom->K[j*n + j] >= rom->K[(j - 1)*(n + 1)]);
		for (int k = 0; k < n; k++)
			worst = fmax(worst, fabs(T[j*n + k] - rom->K[j*n + k])/
			                    sqrt(rom->K[j*n + j]*rom->K[k*n + k]));
	}
	ok(zero && hawser_rom_energy(rom, u, u) == 0.0, "%s: no force and no energy at rest", name);
	ok(worst < 1e-12, "%s: the tangent at rest is K, %.1e", name, worst);
	ok(ascending, "%s: ascending frequencies", name);
	if (ok(!hawser_modes_solve(&modes, st, &options, NULL), "%s: modes", name))
		for (int j = 0; j < modes.n; j++)
			low = fmax(low, fabs(sqrt(rom->K[j*n + j])/modes.mode[j].omega - 1.0));
	ok(low < 1e-9, "%s: frequencies of the lowest modes, %.1e", name, low);
	hawser_modes_clear(&modes);
	free(T);
}

/* Many states in one call, some of them in the plane, against single calls. */
static void check_batch(const struct hawser_rom *rom, const char *name)
{
	enum { COUNT = 37 };
	size_t n = (size_t)rom->n;
	double *u = calloc(COUNT*n, sizeof *u), *f = malloc(COUNT*n*sizeof *f);
	double *T = malloc(COUNT*n*n*sizeof *T), *one = malloc(n*n*sizeof *one), g[MAX];
	double *work = malloc(hawser__rom_tangents_work(rom, COUNT)*sizeof *work), worst = 0.0;

	for (size_t i = 0; i < COUNT; i++) {
		draw(u + i*n, rom, 0.2);
		for (size_t j = 0; j < n; j++)
			if (i > 3 && strncmp(rom->label[j], "out", 3) == 0)
				u[i*n + j] = 0.0;
	}
	for (int count = 5; count <= COUNT; count += 32) {
		hawser__rom_tangents(rom, f, T, u, count, work);
		for (size_t i = 0; i < (size_t)count; i++) {
			double scale = 0.0;

			hawser_rom_tangent(rom, g, one, u + i*n);
			for (size_t j = 0; j < n*n; j++)
				scale = fmax(scale, fabs(one[j]));
			for (size_t j = 0; j < n*n; j++)
				worst = fmax(worst, fabs(one[j] - T[i*n*n + j])/scale);
			scale = norm(g, (int)n);
			for (size_t j = 0; j < n; j++)
				worst = fmax(worst, fabs(g[j] - f[i*n + j])/scale);
		}
		hawser__rom_tangents(rom, T, NULL, u, count, work);
		for (size_t j = 0; j < (size_t)count*n; j++)
			worst = fmax(worst, fabs(T[j] - f[j])/(1.0 + fabs(f[j])));
	}
	ok(worst < 1e-13, "%s: many states at once are those one by one, %.1e", name, worst);
	free(u);
	free(f);
	free(T);
	free(one);
	free(work);
}

/* Compression up to a reversed cable: a longitudinal mode alone, with an amplitude at which the
 * compressive strain at a probe is `part` times the strain that cancels the static tension. */
static void check_compression(const struct hawser_rom *rom, double part, const char *name)
{
	const struct hawser_rom_shapes *shapes = &rom->shapes;
	double u[MAX] = {0.0}, stretch = shapes->stretch[0], tension;
	const double *d;
	int k = 0;

	while (!strstr(rom->label[k], "longitudinal"))
		k++;
	d = shapes->slope + (size_t)k*(size_t)shapes->points*3;
	u[k] = -part*(stretch - 1.0)/d[0];
	tension = shapes->EA*(hypot(stretch + u[k]*d[0], u[k]*d[1]) - 1.0);
	if (part*(stretch - 1.0) < 1.0)
		ok(tension < 0.0, "%s: tension %.3g N", name, tension);
	close_to(hawser_rom_tension(rom, 0, u), tension, 1e-9, name);
	check_line(rom, u, 1e-3, name);
}

/* The expanded model on the same modes: the difference of the energies is of fifth degree. */
static void check_order(const struct hawser_statics *st, const char *name)
{
	struct hawser_modes modes;
	struct hawser_rom exact = {0}, quartic = {0};
	double u[MAX], v[MAX], f[MAX], g[MAX], left[3];
	int built = !hawser_modes_basis(&modes, st, 5, 5, NULL) &&
	            !hawser_rom_build_exact(&exact, &modes, NULL, NULL) &&
	            !hawser_rom_build(&quartic, &modes, NULL, NULL), n = modes.n;

	if (!ok(built, "%s: two models on the same modes", name))
		return;
	draw(u, &exact, 0.1);
	for (int i = 0; i < 3; i++) {
		for (int j = 0; j < n; j++)
			v[j] = u[j]*pow(0.5, i);
		hawser_rom_restoring(&exact, f, v);
		hawser_rom_restoring(&quartic, g, v);
		for (int j = 0; j < n; j++)
			f[j] -= g[j];
		left[i] = norm(f, n);
	}
	ok(fabs(log2(left[1]/left[2]) - 4.0) < 0.2,
	   "%s: exact less expanded force is of order 4 (%.3f, then %.3f)", name,
	   log2(left[0]/left[1]), log2(left[1]/left[2]));
	hawser_rom_clear(&exact);
	hawser_rom_clear(&quartic);
	hawser_modes_clear(&modes);
}

static void check_model(double epsilon, double delta, double hs, int functions, double size,
                        const char *name)
{
	struct hawser_statics st = span_of(epsilon, delta, hs);
	struct hawser_report report = {0};
	struct hawser_modes modes = {0};
	struct hawser_rom rom, dense = {0};
	double u[MAX];

	if (!ok(!hawser_rom_build_full(&rom, &st, NULL, functions, &report) &&
	        !hawser_modes_basis(&modes, &st, functions, functions, &report) &&
	        !hawser_rom_build_exact(&dense, &modes, NULL, &report), "%s: %s", name,
	        report.message))
		return;
	check_rest(&rom, &st, name);
	draw(u, &rom, size);
	check_line(&rom, u, size, name);
	check_batch(&rom, name);
	/* the same coordinates, with the energy integrated by a dense rule */
	check_compression(&dense, 2.0, "half as much compression as there was tension");
	check_compression(&dense, 1.3/(rom.shapes.stretch[0] - 1.0), "turned round");
	hawser_rom_clear(&rom);
	hawser_rom_clear(&dense);
	hawser_modes_clear(&modes);
}

/* --- static response to a constant load --- */

/* Coordinates u at which the restoring force is `part` of f. */
static int settle(double *u, const struct hawser_rom *rom, const double *f, double part)
{
	int n = rom->n, left = 60;
	double *T = malloc((size_t)n*n*sizeof *T), r[MAX], size = 1.0;
	lapack_int pivot[MAX];

	while (T && size > 1e-13 && left--) {
		hawser_rom_tangent(rom, r, T, u);
		for (int j = 0; j < n; j++)
			r[j] = part*f[j] - r[j];
		if (LAPACKE_dgesv(LAPACK_ROW_MAJOR, n, 1, T, n, pivot, r, 1))
			break;
		for (int j = 0; j < n; j++)
			u[j] += r[j];
		size = norm(r, n)/norm(u, n);
	}
	free(T);
	return size < 1e-10;
}

/* The catenary under weight and load (N/m, along x, y, z): displacement [3] from the unloaded one,
 * and tension, at unstretched length S. It lies in the plane of the chord and the resultant. */
static double catenary(double xyz[3], const struct hawser_statics *st, const double load[3], double S)
{
	double F[3] = {load[0], load[1] - st->span.rho*st->span.g, load[2]}, size = norm(F, 3);
	double chord[3] = {st->span.d, st->span.h, 0.0}, rise = 0.0, across[3], d;
	struct hawser_span span = st->span;
	struct hawser_profile_point at, rest = hawser_statics_at(st, S);
	struct hawser_statics loaded;

	for (int i = 0; i < 3; i++)
		rise -= chord[i]*F[i]/size;
	for (int i = 0; i < 3; i++)
		across[i] = chord[i] + rise*F[i]/size;
	d = norm(across, 3);
	span.d = d;
	span.h = rise;
	span.g = size/span.rho;
	if (hawser_statics_solve(&loaded, &span, HAWSER_GIVEN_LENGTH0, st->length0, HAWSER_BRANCH_TAUT,
	                         NULL))
		return NAN;
	at = hawser_statics_at(&loaded, S);
	for (int i = 0; i < 3; i++)
		xyz[i] = across[i]/d*at.x - F[i]/size*at.y;
	xyz[0] -= rest.x;
	xyz[1] -= rest.y;
	return at.T;
}

/* Errors of the displacement, relative to its largest value, and of the tension, with `functions`
 * functions. */
static double static_error(double *tension, const struct hawser_statics *st,
                           const struct hawser_scene *scene, int functions)
{
	struct hawser_rom rom;
	double u[MAX] = {0.0}, worst = 0.0, largest = 0.0;
	int good = !hawser_rom_build_full(&rom, st, scene, functions, NULL);

	for (int step = 1; good && step <= 4; step++)
		good = settle(u, &rom, rom.harmonic->f, step/4.0);
	*tension = good ? 0.0 : INFINITY;
	for (int p = 0; good && p < rom.shapes.points; p++) {
		double got[3], want[3], T;

		T = catenary(want, st, scene->load.per_length, rom.shapes.s[p]*st->span.d);
		hawser_rom_displacement(&rom, got, p, u);
		for (int i = 0; i < 3; i++) {
			worst = fmax(worst, fabs(got[i]*rom.length - want[i]));
			largest = fmax(largest, fabs(want[i]));
		}
		*tension = fmax(*tension, fabs(hawser_rom_tension(&rom, p, u)/T - 1.0));
	}
	hawser_rom_clear(&rom);
	return good ? worst/largest : INFINITY;
}

static void check_static(struct hawser_span span, enum hawser_given given, double value,
                         const double load[3], const double most[3], const char *name)
{
	static const int functions[3] = {6, 12, 20};
	struct hawser_scene scene = {.load = {.present = 1, .frame = HAWSER_FRAME_GLOBAL,
	                                      .extent = {0.0, 1.0}}};
	struct hawser_statics st;

	memcpy(scene.load.per_length, load, sizeof scene.load.per_length);
	if (!ok(!hawser_statics_solve(&st, &span, given, value, HAWSER_BRANCH_TAUT, NULL), "%s", name))
		return;
	for (int i = 0; i < 3; i++) {
		double tension, error = static_error(&tension, &st, &scene, functions[i]);

		ok(error < most[i] && tension < 100.0*most[i],
		   "%s: %d functions, displacement %.1e < %.1e, tension %.1e", name, functions[i],
		   error, most[i], tension);
	}
}

CASE(property_rom_full)
{
	struct hawser_statics st = span_of(3.1e-3, 0.93, 0.27);

	check_model(3.1e-2, 0.93, 0.27, 20, 0.05, "soft inclined");
	check_model(2.0e-4, 0.18, 0.04, 20, 0.03, "chairlift");
	check_model(3.1e-3, 4.7, -0.6, 33, 0.05, "deep sag");
	check_model(1e-7, 0.5, 0.0, 24, 0.03, "stiff");
	check_model(1e-10, 0.53, 0.11, 18, 0.01, "nearly inextensible");
	check_order(&st, "inclined");
	st = span_of(2.0e-4, 0.18, 0.0);
	check_order(&st, "level");
	check_static((struct hawser_span){4e8, 6.0, 9.81, 250.0, 10.0}, HAWSER_GIVEN_T0, 8e4,
	             (const double[3]){0.0, -47.0, 0.0}, (const double[3]){1e-6, 1e-10, 1e-10},
	             "chairlift, more weight");
	check_static((struct hawser_span){4e8, 6.0, 9.81, 250.0, 10.0}, HAWSER_GIVEN_T0, 8e4,
	             (const double[3]){13.0, 21.0, 38.0}, (const double[3]){1e-4, 1e-8, 1e-10},
	             "chairlift, oblique load");
	check_static((struct hawser_span){2e6, 3.0, 9.81, 100.0, -40.0}, HAWSER_GIVEN_LENGTH0, 140.0,
	             (const double[3]){-4.0, 6.0, 17.0}, (const double[3]){5e-2, 5e-4, 5e-6},
	             "deep sag, oblique load");
	return done_testing();
}
