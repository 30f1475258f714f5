/* Free motions that are never at rest: a pair of equal coordinates on a circle, in closed form; random
 * models with a plane of symmetry, and gyroscopic ones, whose motions are integrated in time
 * (closure, the action's derivative, stability by differences); refusals.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_complex_math.h>
#include <gsl/gsl_eigen.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include <hawser/nnm.h>

#include "tests/tap.h"

enum { N = 3, M = 2*N };

static struct hawser_rom rom;
static struct hawser_report report;
static int turned_motions, unstable_motions, checked;

static double random_in(double lo, double hi)
{
	static unsigned long long state = 88172645463325252ull;

	state ^= state << 13;
	state ^= state >> 7;
	state ^= state << 17;
	return lo + (hi - lo)*(double)(state >> 11)/9007199254740992.0;
}

static void order(int *i, int count)
{
	for (int a = 0; a < count; a++)
		for (int b = a + 1; b < count; b++)
			if (i[b] < i[a]) {
				int keep = i[a];

				i[a] = i[b];
				i[b] = keep;
			}
}

/* The forces of an energy with random coefficients; its terms have an even number of factors whose
 * `parity` is 1. G couples coordinates of different parity. */
static int random_model(const int *parity, double gyroscopic, double shift)
{
	double e3[N][N][N], e4[N][N][N][N];

	rom = (struct hawser_rom){.n = N, .length = 1.0, .time = 1.0, .force = 1.0,
		.D = calloc(N*N, sizeof(double)), .K = calloc(N*N, sizeof(double)),
		.Q = calloc(N*N*N, sizeof *rom.Q), .C = calloc(N*N*N*N, sizeof *rom.C)};
	for (int i = 0; i < N*N*N; i++)
		(&e3[0][0][0])[i] = random_in(-0.3, 0.3);
	for (int i = 0; i < N*N*N*N; i++)
		(&e4[0][0][0][0])[i] = random_in(-0.1, 0.1);
	for (int j = 0; j < N; j++) {
		rom.K[j*(N + 1)] = j == 0 ? 1.0 : pow((j < 2 ? 1.0 + shift : 2.4) + random_in(0.0, 0.1), 2.0);
		for (int k = 0; k < j; k++) {
			double g = parity[j] != parity[k] ? gyroscopic*random_in(0.3, 1.0) : 0.0;

			rom.D[j*N + k] = g;
			rom.D[k*N + j] = -g;
		}
		e4[j][j][j][j] = random_in(0.1, 0.4);
		for (int k = 0; k < N; k++)
			for (int l = k; l < N; l++) {
				int i[3] = {j, k, l};

				order(i, 3);
				if ((parity[j] + parity[k] + parity[l])%2 == 0)
					rom.Q[rom.quads++] = (struct hawser_quad){j, k, l,
						e3[i[0]][i[1]][i[2]]*((i[0] == j) + (i[1] == j) + (i[2] == j))};
				for (int m = l; m < N; m++) {
					int q[4] = {j, k, l, m};

					order(q, 4);
					if ((parity[j] + parity[k] + parity[l] + parity[m])%2 == 0)
						rom.C[rom.cubics++] = (struct hawser_cubic){j, k, l, m,
							e4[q[0]][q[1]][q[2]][q[3]]*
							((q[0] == j) + (q[1] == j) + (q[2] == j) + (q[3] == j))};
				}
			}
	}
	return hawser_rom_compile(&rom, &report) != HAWSER_OK;
}

/* u, v, and the action times 2 pi: the integral of (v + G u/2) v. */
static int slope(double t, const double y[], double dy[], void *unused)
{
	(void)t;
	(void)unused;
	dy[2*rom.n] = 0.0;
	for (int j = 0; j < rom.n; j++) {
		double p = y[rom.n + j], f = -rom.K[j*rom.n + j]*y[j];

		for (int k = 0; k < rom.n; k++) {
			p += 0.5*rom.D[j*rom.n + k]*y[k];
			f -= rom.D[j*rom.n + k]*y[rom.n + k];
		}
		dy[j] = y[rom.n + j];
		dy[rom.n + j] = f;
		dy[2*rom.n] += p*y[rom.n + j];
	}
	for (int i = 0; i < rom.quads; i++)
		dy[rom.n + rom.Q[i].j] -= rom.Q[i].value*y[rom.Q[i].k]*y[rom.Q[i].l];
	for (int i = 0; i < rom.cubics; i++)
		dy[rom.n + rom.C[i].j] -= rom.C[i].value*y[rom.C[i].k]*y[rom.C[i].l]*y[rom.C[i].m];
	return GSL_SUCCESS;
}

/* y [2n + 1] after the time T. */
static int advance(double *y, double T)
{
	gsl_odeiv2_system system = {slope, NULL, 2*(size_t)rom.n + 1, NULL};
	gsl_odeiv2_driver *driver =
		gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, 1e-2, 1e-12, 1e-12);
	double t = 0.0;
	int failed = !driver || gsl_odeiv2_driver_apply(driver, &t, T, y) != GSL_SUCCESS;

	gsl_odeiv2_driver_free(driver);
	return failed;
}

static void state(double *y, const struct hawser_backbone *motion, int i)
{
	const double *start = motion->start + (size_t)i*rom.n;

	y[2*rom.n] = 0.0;
	for (int j = 0; j < rom.n; j++) {
		y[j] = motion->sign[j] > 0 ? start[j] : 0.0;
		y[rom.n + j] = motion->sign[j] > 0 ? 0.0 : start[j]*motion->point[i].omega;
	}
}

/* The action, and the distance of the end of the period from its start, relative. */
static double action(double *gap, const struct hawser_backbone *motion, int i)
{
	double y[M + 1] = {0.0}, start[M + 1] = {0.0}, size = 0.0, sum = 0.0;

	state(start, motion, i);
	memcpy(y, start, sizeof y);
	*gap = INFINITY;
	if (advance(y, 2.0*M_PI/motion->point[i].omega))
		return NAN;
	for (int j = 0; j < 2*rom.n; j++) {
		size += start[j]*start[j];
		sum += (y[j] - start[j])*(y[j] - start[j]);
	}
	*gap = sqrt(sum/size);
	return y[2*rom.n]/(2.0*M_PI);
}

/* The largest multiplier, from central differences of integrations. */
static double largest(const struct hawser_backbone *motion, int i)
{
	gsl_matrix *matrix = gsl_matrix_alloc(M, M);
	gsl_vector_complex *value = gsl_vector_complex_alloc(M);
	gsl_eigen_nonsymm_workspace *room = gsl_eigen_nonsymm_alloc(M);
	double most = 0.0, h = 1e-5;

	for (int k = 0; k < M; k++) {
		double up[M + 1], down[M + 1];

		state(up, motion, i);
		state(down, motion, i);
		up[k] += h;
		down[k] -= h;
		if (advance(up, 2.0*M_PI/motion->point[i].omega) ||
		    advance(down, 2.0*M_PI/motion->point[i].omega))
			most = NAN;
		for (int j = 0; j < M; j++)
			gsl_matrix_set(matrix, (size_t)j, (size_t)k, (up[j] - down[j])/(2.0*h));
	}
	gsl_eigen_nonsymm(matrix, value, room);
	for (int j = 0; j < M; j++)
		most = fmax(most, gsl_complex_abs(gsl_vector_complex_get(value, (size_t)j)));
	gsl_eigen_nonsymm_free(room);
	gsl_vector_complex_free(value);
	gsl_matrix_free(matrix);
	return most;
}

/* Of dE = Omega dJ over the points i to i + 2 with the actions J: what it misses by parabolas over the
 * distance along the curve, relative to their difference from straight lines and round-off. */
static double law_of(const struct hawser_backbone *motion, int i, const double *J)
{
	const struct hawser_backbone_point *p = &motion->point[i];
	double s[3] = {0.0}, curved = 0.0, straight = 0.0;

	for (int k = 1; k < 3; k++) {
		double sum = pow(p[k].omega - p[k - 1].omega, 2.0);

		for (int j = 0; j < rom.n; j++)
			sum += pow(motion->start[(i + k)*rom.n + j] - motion->start[(i + k - 1)*rom.n + j], 2.0);
		s[k] = s[k - 1] + sqrt(sum);
		straight += 0.5*(p[k].omega + p[k - 1].omega)*(J[k] - J[k - 1]);
	}
	for (int g = -1; g <= 1; g += 2) { /* Gauss' rule, exact for these cubics */
		double at = 0.5*s[2]*(1.0 + g/sqrt(3.0)), omega = 0.0, rate = 0.0;

		for (int k = 0; k < 3; k++) {
			double a = s[(k + 1)%3], b = s[(k + 2)%3], under = (s[k] - a)*(s[k] - b);

			omega += p[k].omega*(at - a)*(at - b)/under;
			rate += J[k]*(2.0*at - a - b)/under;
		}
		curved += 0.5*s[2]*omega*rate;
	}
	return fabs(curved - (p[2].energy - p[0].energy))/
	       (fabs(curved - straight) + 1e-8*p[2].energy);
}

/* Every motion closes, and the energy grows by Omega times the action. */
static void check_curve(const struct hawser_nnm_curve *curve, double *gap, double *law, int *wrong)
{
	const struct hawser_backbone *motion = &curve->motion;
	int whirls = 0, step = 1 + motion->points/12;

	for (int j = 0; j < rom.n; j++)
		whirls |= motion->sign[j] < 0;
	turned_motions += whirls ? motion->points : 0;
	for (int i = 0; i + 2 < motion->points; i += step) {
		double g[3], J[3];

		for (int k = 0; k < 3; k++) {
			J[k] = action(&g[k], motion, i + k);
			*gap = fmax(*gap, g[k]);
		}
		*law = fmax(*law, law_of(motion, i, J));
		if (whirls && i%(4*step) == 0) {
			double most = largest(motion, i);

			checked++;
			unstable_motions += motion->point[i].unstable > 0;
			if (fabs(most - 1.0) > 1e-2 && (most > 1.01) != (motion->point[i].unstable > 0))
				++*wrong;
		}
	}
}

static void check_models(const char *what, int count, double gyroscopic, double shift)
{
	static const int parity[N] = {0, 1, 0};
	double gap = 0.0, law = 0.0;
	int failed = 0, wrong = 0, curves = 0, before = turned_motions;

	unstable_motions = checked = 0;
	for (int i = 0; i < count; i++) {
		struct hawser_nnm nnm;
		struct hawser_nnm_options options = {.mode = i%2, .energy = 0.6, .depth = 1, .max_points = 150};

		failed += random_model(parity, gyroscopic, shift) ||
		          hawser_nnm_trace(&nnm, &rom, &options, &report) != HAWSER_OK;
		for (int c = 0; !failed && c < nnm.curves; c++)
			check_curve(&nnm.curve[c], &gap, &law, &wrong);
		curves += nnm.curves;
		failed += nnm.lost > 0;
		hawser_nnm_clear(&nnm);
		hawser_rom_clear(&rom);
	}
	ok(failed == 0, "%s: %d models, %d curves, none lost %s", what, count, curves,
	   failed ? report.message : "");
	ok(turned_motions > before + 50, "%d motions are never at rest", turned_motions - before);
	ok(gap < 1e-7, "they close after a period: %.1e", gap);
	ok(law < 1.0, "dE = Omega dJ, by parabolas within their difference from lines: %.1e of it", law);
	ok(wrong == 0, "stability of %d, %d unstable, as by differences", checked, unstable_motions);
}

/* u'' + u + (u^2 + w^2) u = 0, the same for w; on a circle of radius a: Omega^2 = 1 + a^2, the energy
 * is a^2 + 3/4 a^4, and the action Omega a^2. */
static void check_circle(void)
{
	struct hawser_nnm nnm, plane;
	struct hawser_nnm_options options = {.mode = 0, .quadrature = 2, .energy = 20.0, .depth = 1};
	double worst = 0.0, round = 0.0;

	rom = (struct hawser_rom){.n = 2, .cubics = 4, .length = 1.0, .time = 1.0, .force = 1.0,
		.D = calloc(4, sizeof(double)), .K = calloc(4, sizeof(double)), .C = calloc(4, sizeof *rom.C)};
	rom.K[0] = rom.K[3] = 1.0;
	rom.C[0] = (struct hawser_cubic){0, 0, 0, 0, 1.0};
	rom.C[1] = (struct hawser_cubic){0, 0, 1, 1, 1.0};
	rom.C[2] = (struct hawser_cubic){1, 0, 0, 1, 1.0};
	rom.C[3] = (struct hawser_cubic){1, 1, 1, 1, 1.0};
	if (!ok(!hawser_rom_compile(&rom, &report) && !hawser_nnm_trace(&nnm, &rom, &options, &report),
	        "a pair in quadrature %s", report.message))
		return;
	for (int i = 0; i < nnm.curve[0].motion.points; i++) {
		const double *u = nnm.curve[0].motion.start + 2*(size_t)i;
		const struct hawser_backbone_point *p = &nnm.curve[0].motion.point[i];

		worst = fmax(worst, fabs(p->omega/sqrt(1.0 + u[0]*u[0]) - 1.0));
		worst = fmax(worst, fabs(p->energy/(u[0]*u[0]*(1.0 + 0.75*u[0]*u[0])) - 1.0));
		round = fmax(round, fabs(u[1]/u[0] - 1.0));
	}
	ok(worst < 1e-8 && nnm.curve[0].motion.sign[1] == -1, "frequency and energy of %d circles: %.1e",
	   nnm.curve[0].motion.points, worst);
	ok(round < 1e-6, "both coordinates have the same amplitude: %.1e", round);
	options.quadrature = 0;
	ok(!hawser_nnm_trace(&plane, &rom, &options, &report) && plane.curve[0].motion.branches == 0,
	   "the plane motion, which may be turned, has no branch points");
	hawser_nnm_clear(&nnm);
	hawser_nnm_clear(&plane);
	rom.K[3] = 1.1;
	options.quadrature = 2;
	ok(hawser_nnm_trace(&nnm, &rom, &options, &report) == HAWSER_ERR_ARGUMENT, "%s", report.message);
	hawser_nnm_clear(&nnm);
	options.quadrature = 3;
	ok(hawser_nnm_trace(&nnm, &rom, &options, &report) == HAWSER_ERR_ARGUMENT, "%s", report.message);
	hawser_nnm_clear(&nnm);
	rom.K[3] = 1.0;
	rom.C[1] = (struct hawser_cubic){0, 0, 0, 1, 1.0};
	options.quadrature = 2;
	ok(!hawser_rom_compile(&rom, &report) &&
	   hawser_nnm_trace(&nnm, &rom, &options, &report) == HAWSER_ERR_ARGUMENT, "%s", report.message);
	hawser_nnm_clear(&nnm);
	rom.D[1] = 0.2;
	rom.D[2] = -0.2;
	options.quadrature = 0;
	ok(hawser_nnm_trace(&nnm, &rom, &options, &report) == HAWSER_ERR_ARGUMENT, "%s", report.message);
	hawser_nnm_clear(&nnm);
	hawser_rom_clear(&rom);
}

CASE(property_nnm_whirl)
{
	int count = getenv("HAWSER_LONG") ? 60 : 6;

	gsl_set_error_handler_off();
	check_circle();
	check_models("a plane of symmetry", count, 0.0, 0.0);
	check_models("gyroscopic", count, 0.3, 0.3);
	return done_testing();
}
