/* The tensors against the exact strain energy, by a second route: along u = t r the energy and its
 * gradient are analytic in t. Their Taylor coefficients are integrals over a circle in the complex
 * plane, without truncation error (the radius is smaller than the distance to the nearest zero of
 * |q'|).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <complex.h>
#include <stdlib.h>

#include "modes/grid.h"
#include "rom/energy/project.h"
#include "tests/modes-span.h"
#include "tests/rom-entries.h"
#include "tests/tap.h"

enum { MAX = 12, CIRCLE = 64 };

static double uniform(void)
{
	return 2.0*rand()/RAND_MAX - 1.0;
}

/* Integrand of the energy: shapes and static stretch at quadrature points. */
struct cable {
	int n, points;
	double epsilon;
	double *weight, *strain; /* [points] static strain, g - 1 */
	double *slope;           /* [n][points][3] */
};

/* Each element is divided into `cuts` parts, with the grid's own rule in each. */
static struct cable sample(const struct hawser_modes *modes, int cuts)
{
	const struct hawser_grid *grid = &modes->grid;
	struct cable cable = {.n = modes->n, .points = grid->points*cuts,
	                      .epsilon = modes->statics.epsilon};
	int p = 0;

	cable.weight = malloc((size_t)cable.points*sizeof(double));
	cable.strain = malloc((size_t)cable.points*sizeof(double));
	cable.slope = malloc((size_t)cable.points*(size_t)cable.n*3*sizeof(double));
	for (int piece = 0; piece < grid->elements*cuts; piece++)
		for (int i = 0; i < grid->order; i++, p++) {
			int e = piece/cuts;
			double width = (grid->edge[e + 1] - grid->edge[e])/cuts, shape[3];
			double s = grid->edge[e] + width*(piece%cuts + 0.5*(1.0 + grid->node[i]));

			cable.weight[p] = grid->weight[e*grid->order + i]/cuts;
			cable.strain[p] = hawser_statics_frame(&modes->statics, s).strain;
			for (int j = 0; j < modes->n; j++)
				hawser_modes_at(modes, shape, cable.slope + (j*cable.points + p)*3, j, s);
		}
	return cable;
}

static void cable_free(struct cable *cable)
{
	free(cable->weight);
	free(cable->strain);
	free(cable->slope);
}

/* Exact energy, and its gradient with respect to every coordinate, at u = t r. */
static long double complex exact(const struct cable *cable, long double complex *gradient,
                                 long double complex t, const double *r)
{
	long double complex energy = 0.0L;

	for (int j = 0; j < cable->n; j++)
		gradient[j] = 0.0L;
	for (int p = 0; p < cable->points; p++) {
		long double rest = cable->strain[p], w = cable->weight[p]/(long double)cable->epsilon;
		long double complex d[3] = {0.0L}, more, norm, strain;

		for (int j = 0; j < cable->n; j++)
			for (int i = 0; i < 3; i++)
				d[i] += t*r[j]*cable->slope[(j*cable->points + p)*3 + i];
		/* |q'|^2 - 1 without cancellation, for strains of 1e-10 */
		more = rest*(2.0L + rest) + d[0]*(2.0L*(1.0L + rest) + d[0]) + d[1]*d[1] + d[2]*d[2];
		d[0] += 1.0L + rest;
		norm = csqrtl(d[0]*d[0] + d[1]*d[1] + d[2]*d[2]);
		strain = more/(norm + 1.0L);
		energy += w*strain*strain/2.0L;
		for (int j = 0; j < cable->n; j++) {
			const double *slope = cable->slope + (j*cable->points + p)*3;

			gradient[j] += w*strain/norm*(d[0]*slope[0] + d[1]*slope[1] + d[2]*slope[2]);
		}
	}
	return energy;
}

/* Radius of the circle: at most a third of the distance to the nearest zero of |q'| along r. It
 * makes the orders about equal, so that the round-off of the largest one does not exceed the
 * others. */
static long double radius_for(const struct cable *cable, const double *r)
{
	long double largest = 0.0L;

	for (int p = 0; p < cable->points; p++) {
		long double sum = 0.0L;

		for (int i = 0; i < 3; i++) {
			long double d = 0.0L;

			for (int j = 0; j < cable->n; j++)
				d += r[j]*cable->slope[(j*cable->points + p)*3 + i];
			sum += d*d;
		}
		largest = fmaxl(largest, sqrtl(sum)/(1.0L + cable->strain[p]));
	}
	return fminl(1.0L/3.0L, sqrtl(10.0L*cable->epsilon))/largest;
}

/* energy[k], gradient[k][j]: coefficients of t^k, k = 0..4. */
static void taylor(const struct cable *cable, double *energy, double (*gradient)[MAX],
                   const double *r, long double radius)
{
	long double complex g[MAX], e;

	memset(energy, 0, 5*sizeof *energy);
	memset(gradient, 0, 5*sizeof *gradient);
	for (int i = 0; i < CIRCLE; i++) {
		long double complex turn = cexpl(2.0L*M_PIl*I*i/CIRCLE), power = 1.0L;

		e = exact(cable, g, radius*turn, r);
		for (int k = 0; k < 5; k++) {
			energy[k] += (double)(creall(e/power)/CIRCLE);
			for (int j = 0; j < cable->n; j++)
				gradient[k][j] += (double)(creall(g[j]/power)/CIRCLE);
			power *= radius*turn;
		}
	}
}

/* The same from the lists of the model: order 2 is K, 3 is Q, 4 is C. */
static void listed(const struct hawser_rom *rom, double *energy, double (*gradient)[MAX],
                   const double *r)
{
	memset(gradient, 0, 5*sizeof *gradient);
	for (int j = 0; j < rom->n; j++)
		for (int k = 0; k < rom->n; k++)
			gradient[1][j] += rom->K[j*rom->n + k]*r[k];
	for (int i = 0; i < rom->quads; i++)
		gradient[2][rom->Q[i].j] += rom->Q[i].value*r[rom->Q[i].k]*r[rom->Q[i].l];
	for (int i = 0; i < rom->cubics; i++)
		gradient[3][rom->C[i].j] += rom->C[i].value*r[rom->C[i].k]*r[rom->C[i].l]*
		                            r[rom->C[i].m];
	for (int order = 2; order < 5; order++) {
		energy[order] = 0.0;
		for (int j = 0; j < rom->n; j++)
			energy[order] += r[j]*gradient[order - 1][j]/order;
	}
}

static double largest_of(const double *v, int n)
{
	double largest = 0.0;

	for (int j = 0; j < n; j++)
		largest = fmax(largest, fabs(v[j]));
	return largest;
}

/* Several directions: error of each order relative to its largest value. */
static void compare(const struct hawser_rom *rom, const struct cable *cable, double tolerance,
                    const char *what)
{
	double error[2][5] = {{0.0}};

	for (int trial = 0; trial < 4; trial++) {
		double r[MAX], e[5], w[5], g[5][MAX], v[5][MAX];

		for (int j = 0; j < rom->n; j++)
			r[j] = uniform()/rom->K[j*rom->n + j]; /* directions in which no mode dominates */
		taylor(cable, e, g, r, radius_for(cable, r));
		listed(rom, w, v, r);
		for (int order = 2; order < 5; order++) {
			double scale = largest_of(g[order - 1], rom->n);

			if (largest_of(v[order - 1], rom->n) == 0.0) /* one mode has no Q, so that nothing
			                                              * changes */
				scale = largest_of(g[1], rom->n)/powl(radius_for(cable, r), order - 2);
			error[0][order] = fmax(error[0][order], fabs(e[order] - w[order])/
			                       fmax(fabs(e[order]), scale*largest_of(r, rom->n)));
			for (int j = 0; j < rom->n; j++)
				error[1][order] = fmax(error[1][order], fabs(g[order - 1][j] -
				                       v[order - 1][j])/scale);
		}
	}
	for (int order = 2; order < 5; order++) {
		ok(error[0][order] < tolerance, "%s: energy's order %d: %.1e < %.0e", what, order,
		   error[0][order], tolerance);
		ok(error[1][order] < tolerance, "%s: every equation's order %d: %.1e < %.0e", what,
		   order - 1, error[1][order], tolerance);
	}
}

/* Second derivatives of the quadratic energy by quadrature. */
static void quadrature(double *stiffness, const struct hawser_modes *modes)
{
	int n = modes->n, points = modes->grid.points;

	for (int j = 0; j < n; j++)
		for (int k = 0; k < n; k++) {
			const double *x = modes->slope + 3*j*points, *y = modes->slope + 3*k*points;
			double sum = 0.0;

			for (int p = 0; p < points; p++, x += 3, y += 3) {
				/* not g - 1: eps may be 1e-12 */
				double strain = hawser_statics_frame(&modes->statics, modes->grid.s[p]).strain;

				sum += modes->grid.weight[p]/modes->statics.epsilon*
				       (x[0]*y[0] + strain/(1.0 + strain)*(x[1]*y[1] + x[2]*y[2]));
			}
			stiffness[j*n + k] = sum;
		}
}

/* K from the quadrature against diag(omega^2). */
static void check_stiffness(const struct hawser_modes *modes, const struct hawser_rom *rom)
{
	double K[MAX*MAX], worst = 0.0;
	int n = rom->n, diagonal = 1;

	quadrature(K, modes);
	for (int i = 0; i < n*n; i++) {
		double scale = sqrt(rom->K[(i/n)*(n + 1)]*rom->K[(i%n)*(n + 1)]);

		worst = fmax(worst, fabs(K[i] - rom->K[i])/scale);
		diagonal = diagonal && (i/n == i%n || rom->K[i] == 0.0);
	}
	ok(diagonal, "K is diagonal");
	ok(worst < 1e-12, "K from the grid is diag(omega^2): %.1e < 1e-12", worst);
}

static void check_parity(const struct hawser_modes *modes, const struct hawser_rom *rom)
{
	int parity[MAX], level = hawser__rom_mirror(parity, modes), odd = 0, out[MAX];

	for (int j = 0; j < rom->n; j++)
		out[j] = modes->mode[j].plane == HAWSER_OUT_OF_PLANE;
	for (int i = 0; i < rom->quads; i++) {
		const struct hawser_quad *q = &rom->Q[i];

		odd += (out[q->j] + out[q->k] + out[q->l])%2;
		odd += level && (parity[q->j] + parity[q->k] + parity[q->l])%2;
	}
	for (int i = 0; i < rom->cubics; i++) {
		const struct hawser_cubic *c = &rom->C[i];

		odd += (out[c->j] + out[c->k] + out[c->l] + out[c->m])%2;
		odd += level && (parity[c->j] + parity[c->k] + parity[c->l] + parity[c->m])%2;
	}
	ok(odd == 0, "no entry that symmetry makes zero (level: %d)", level);
	ok(level == (modes->statics.hs == 0.0), "mirror symmetry counts for level spans only");
	ok(hawser_rom_asymmetry(rom) < 1e-15, "permutation symmetry: %.1e < 1e-15",
	   hawser_rom_asymmetry(rom));
}

static void check_span(const char *name, double epsilon, double delta, double hs, int n,
                       double tolerance)
{
	struct hawser_statics statics = scaled_span(epsilon, delta, hs);
	struct hawser_modes_options options = {.n = n, .tolerance = 1e-12};
	struct hawser_report report = {0};
	struct hawser_modes modes;
	struct hawser_rom rom;

	statics.V0 = statics.eta;
	statics.V1 = statics.eta + statics.delta*statics.l;
	if (!ok(!hawser_modes_solve(&modes, &statics, &options, &report), "%s: modes %s", name,
	        report.message))
		return;
	if (ok(!hawser_rom_build(&rom, &modes, NULL, &report), "%s: model %s", name,
	       report.message)) {
		for (int cuts = 1; cuts <= 3; cuts += 2) {
			struct cable cable = sample(&modes, cuts);
			char what[120];

			snprintf(what, sizeof what, "%s, grid cut in %d", name, cuts);
			compare(&rom, &cable, tolerance, what);
			cable_free(&cable);
		}
		check_stiffness(&modes, &rom);
		check_parity(&modes, &rom);
	}
	hawser_rom_clear(&rom);
	hawser_modes_clear(&modes);
}

/* --- a taut cable without weight: sines, and everything in closed form --- */

/* Modes 0, 1 out of plane (n = 1, 2), 2 along the cable (k = 2), 3 transverse in the plane (n =
 * 1). */
static void string_modes(struct hawser_modes *modes, double epsilon)
{
	double l = 1.0/(1.0 + epsilon), edge[2] = {0.0, l}, root = sqrt(2.0/l);
	const int number[4] = {1, 2, 2, 1}, component[4] = {2, 2, 0, 1};

	memset(modes, 0, sizeof *modes);
	modes->statics = (struct hawser_statics){.span = {.EA = 1.0/epsilon, .rho = 1.0, .d = 1.0},
		.H = 1.0, .epsilon = epsilon, .l = l};
	modes->time_unit = 1.0;
	modes->n = 4;
	modes->mode = calloc(4, sizeof *modes->mode);
	if (hawser__grid_init(&modes->grid, 1, 48, edge, NULL, NULL))
		return;
	modes->shape = calloc((size_t)modes->grid.points*12, sizeof(double));
	modes->slope = calloc((size_t)modes->grid.points*12, sizeof(double));
	for (int j = 0; j < 4; j++) {
		double wave = number[j]*M_PI/l;

		modes->mode[j] = (struct hawser_mode){.omega = wave*sqrt(l), .plane = j < 2,
			.family = j == 2, .symmetry = number[j] == 2};
		for (int p = 0; p < modes->grid.points; p++) {
			size_t place = ((size_t)j*modes->grid.points + p)*3 + component[j];

			modes->shape[place] = root*sin(wave*modes->grid.s[p]);
			modes->slope[place] = root*wave*cos(wave*modes->grid.s[p]);
		}
	}
	modes->mode[2].omega = 2.0*M_PI/l/sqrt(epsilon);
}

/* With c_n = sqrt(2/l) (n pi/l) cos(n pi s/l): the integral of c_1^4 is 3 pi^4/(2 l^5), of
 * c_n^2 c_m^2 is n^2 m^2 pi^4/l^5, of a_2 c_1^2 is pi^3 sqrt(2)/l^3.5. */
static void check_string(void)
{
	const double epsilon = 0.0137, g = 1.0 + epsilon, l = 1.0/g, unit = pow(M_PI, 4)/pow(l, 5);
	const double V4 = 1.0/(g*g*g*epsilon), V3 = 1.0/(g*g*epsilon);
	struct hawser_report report = {0};
	struct hawser_modes modes;
	struct hawser_rom rom;
	double K[16];

	string_modes(&modes, epsilon);
	ok(!hawser_rom_build(&rom, &modes, NULL, &report), "taut string: model %s", report.message);
	quadrature(K, &modes);
	for (int j = 0; j < 4; j++)
		close_to(K[5*j], rom.K[5*j], 1e-12, "taut string: stiffness");
	close_to(cubic_of(&rom, 0, 0, 0, 0), 0.75*V4*unit, 1e-12, "C_1111 = (1/(2 eps g^3)) int c^4");
	close_to(cubic_of(&rom, 1, 1, 1, 1), 12.0*V4*unit, 1e-12, "C_2222 = 16 C_1111");
	close_to(cubic_of(&rom, 0, 0, 1, 1), 1.5*4.0*V4*unit, 1e-12, "C_1122");
	close_to(cubic_of(&rom, 0, 0, 3, 3), 0.5*1.5*V4*unit, 1e-12, "C of the two planes");
	close_to(cubic_of(&rom, 0, 0, 2, 2), -4.0*V4*unit, 1e-12, "C along and across");
	close_to(quad_of(&rom, 2, 0, 0), 0.5*V3*M_SQRT2*pow(M_PI, 3)/pow(l, 3.5), 1e-12, "Q_211");
	close_to(quad_of(&rom, 0, 0, 2), V3*M_SQRT2*pow(M_PI, 3)/pow(l, 3.5), 1e-12, "Q_112");
	close_to(quad_of(&rom, 2, 3, 3), quad_of(&rom, 2, 0, 0), 1e-14, "Q the same in both planes");
	ok(cubic_of(&rom, 0, 0, 0, 1) == 0.0, "nothing turns the first sine into the second");
	hawser_rom_clear(&rom);
	hawser_modes_clear(&modes);
}

/* With the longitudinal mode that it drives condensed statically, an out-of-plane mode has the
 * cubic coefficient of a string with uniform tension (Kirchhoff, Carrier), pi^4/(2 eps l^5): two
 * thirds of the entry of C. */
static void check_carrier(void)
{
	const double epsilon = 1e-8;
	struct hawser_modes modes;
	struct hawser_rom rom;
	double T, condensed;

	string_modes(&modes, epsilon);
	if (!ok(!hawser_rom_build(&rom, &modes, NULL, NULL), "stiff string"))
		return;
	T = quad_of(&rom, 0, 0, 2);
	condensed = cubic_of(&rom, 0, 0, 0, 0) - T*T/(2.0*rom.K[2*4 + 2]);
	close_to(condensed, pow(M_PI, 4)/(2.0*epsilon*pow(modes.statics.l, 5)), 1e-7,
	         "condensed cubic coefficient of a taut string");
	hawser_rom_clear(&rom);
	hawser_modes_clear(&modes);
}

CASE(property_rom_energy)
{
	srand(2385);
	check_span("soft inclined", 0.031, 0.93, 0.27, 9, 1e-11);
	check_span("chairlift", 1.99e-4, 0.1836, 0.04, 7, 1e-11);
	check_span("deep sag", 3.1e-3, 4.7, -0.6, 8, 1e-11);
	check_span("level", 5.3e-3, 0.61, 0.0, 10, 1e-11);
	check_span("one mode", 1.3e-3, 0.21, 0.1, 1, 1e-11);
	check_span("nearly inextensible", 1e-10, 0.53, 0.11, 8, 1e-11);
	check_string();
	check_carrier();
	return done_testing();
}
