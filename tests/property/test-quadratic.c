/* Eigenvalues of M q'' + (C + G) q' + K q = 0: closed forms, two routes of the library, problems at
 * and beyond divergence and flutter, damping; accuracy of low eigenvalues of a stiff problem.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <complex.h>
#include <stdlib.h>

#include "modes/complex/quadratic.h"
#include "tests/tap.h"

enum { N = 24 };

struct matrices {
	double M[N*N], C[N*N], G[N*N], K[N*N];
};

/* Travelling string with bending mu2, in sines on [0, 1], in well-conditioned other coordinates,
 * which leave the eigenvalues unchanged. */
static void string_of(struct matrices *m, double nu, double mu2, double c)
{
	memset(m, 0, sizeof *m);
	for (int j = 0; j < N; j++) {
		double w = (j + 1)*M_PI;

		m->M[j*N + j] = 1.0;
		m->C[j*N + j] = c;
		m->K[j*N + j] = w*w*(1.0 - nu*nu) + mu2*w*w*w*w;
		for (int k = 0; k < N; k++)
			if ((j + k)%2)
				m->G[j*N + k] = 8.0*nu*(j + 1.0)*(k + 1.0)/((j - k)*(j + k + 2.0));
	}
}

/* A := R'A R. */
static void mix(double *A)
{
	double R[N*N], B[N*N];

	for (int i = 0; i < N; i++)
		for (int j = 0; j < N; j++)
			R[i*N + j] = (i == j) + 0.3*sin(1.0 + 2.3*i + 1.7*i*j)/N;
	for (int i = 0; i < N; i++)
		for (int j = 0; j < N; j++) {
			B[i*N + j] = 0.0;
			for (int k = 0; k < N; k++)
				B[i*N + j] += A[i*N + k]*R[k*N + j];
		}
	for (int i = 0; i < N; i++)
		for (int j = 0; j < N; j++) {
			A[i*N + j] = 0.0;
			for (int k = 0; k < N; k++)
				A[i*N + j] += R[k*N + i]*B[k*N + j];
		}
}

struct spectrum {
	int count;
	struct hawser__eigenvalue value[2*N];
	double vector[2*N*2*N];
};

static int solve(struct spectrum *s, const struct matrices *m, int gyroscopic, int wanted)
{
	double B[N*N];
	struct hawser__quadratic problem = {N, m->M, B, m->K, gyroscopic};
	struct hawser_report report = {.message = ""};

	for (int i = 0; i < N*N; i++)
		B[i] = m->C[i] + m->G[i];
	if (!hawser__quadratic_eigen(s->value, s->vector, NULL, &s->count, &problem, 1.9, wanted, &report))
		return 1;
	printf("# %s\n", report.message);
	return 0;
}

/* Largest |P x| relative to the size of its terms, over all vectors, with the original matrices. */
static double misfit(const struct spectrum *s, const struct matrices *m)
{
	double worst = 0.0;

	for (int k = 0; k < s->count; k++) {
		double complex lambda = s->value[k].re + I*s->value[k].im;
		double miss = 0.0, size = 0.0;

		for (int i = 0; i < N; i++) {
			double complex sum = 0.0;
			double terms = 0.0;

			for (int j = 0; j < N; j++) {
				double complex x = s->vector[2*N*k + j] + I*s->vector[2*N*k + N + j];
				double complex inert = lambda*lambda*m->M[i*N + j], stiff = m->K[i*N + j];
				double complex turning = lambda*(m->G[i*N + j] + m->C[i*N + j]);

				sum += (inert + turning + stiff)*x;
				terms += (cabs(inert) + cabs(turning) + cabs(stiff))*cabs(x);
			}
			miss = fmax(miss, cabs(sum));
			size = fmax(size, terms);
		}
		worst = fmax(worst, miss/size);
	}
	return worst;
}

/* Largest relative distance of an eigenvalue of `a` from the nearest of `b`, over the stated
 * error. */
static double apart(const struct spectrum *a, const struct spectrum *b, int count)
{
	double worst = 0.0;

	for (int k = 0; k < count; k++) {
		double nearest = HUGE_VAL;

		for (int j = 0; j < b->count; j++)
			nearest = fmin(nearest, hypot(a->value[k].re - b->value[j].re,
			                              a->value[k].im - b->value[j].im)
			               /hypot(a->value[k].re, a->value[k].im));
		worst = fmax(worst, nearest);
	}
	return worst;
}

/* The mirror image of an eigenvalue off the imaginary axis is an eigenvalue too. */
static int on_axes(const struct spectrum *s)
{
	int held = 1;

	for (int k = 0; k < s->count; k++) {
		int paired = s->value[k].re == 0.0;

		for (int j = 0; j < s->count && !paired; j++)
			paired = fabs(s->value[j].re + s->value[k].re) <= 1e-11*fabs(s->value[k].re) &&
			         fabs(s->value[j].im - s->value[k].im) <= 1e-11*hypot(s->value[k].re,
			                                                             s->value[k].im);
		held &= paired;
	}
	return held;
}

/* The gyroscopic route against the general one, and transformed coordinates against the original
 * ones. */
static void test_routes(double nu, double mu2, int growing)
{
	static struct spectrum own, general, mixed;
	static struct matrices m;
	double off;
	int growth = 0;

	string_of(&m, nu, mu2, 0.0);
	if (!ok(solve(&own, &m, 1, N) && solve(&general, &m, 0, 2*N), "speed %g, bending %g", nu, mu2))
		return;
	for (int k = 0; k < own.count; k++)
		growth += own.value[k].re > 0.0;
	ok(growth == growing, "%d of %d eigenvalues grow", growth, own.count);
	ok(on_axes(&own), "pairs +-lambda, and no real part elsewhere");
	off = apart(&own, &general, N/2);
	ok(off < 1e-11, "the general route agrees: %.1e", off);
	off = misfit(&own, &m);
	ok(off < 1e-13, "the vectors solve it: %.1e", off);
	mix(m.M);
	mix(m.C);
	mix(m.G);
	mix(m.K);
	if (ok(solve(&mixed, &m, 1, N), "with a mass matrix")) {
		off = apart(&own, &mixed, N/2);
		ok(off < 1e-10, "the same in mixed coordinates: %.1e", off);
		off = misfit(&mixed, &m);
		ok(off < 1e-13, "their vectors solve theirs: %.1e", off);
		ok(on_axes(&mixed), "and nothing leaves the axes");
	}
}

/* K = omega^2, no G, C = 2 zeta omega: lambda = omega (-zeta +- sqrt(zeta^2 - 1)). */
static void test_damped(void)
{
	static struct spectrum s;
	static struct matrices m;
	double worst = 0.0;

	memset(&m, 0, sizeof m);
	for (int j = 0; j < N; j++) {
		double omega = 1.3*pow(1.9, j), zeta = j%3 == 2 ? 1.31 : 0.021;

		m.M[j*N + j] = 1.0;
		m.K[j*N + j] = omega*omega;
		m.C[j*N + j] = 2.0*zeta*omega;
	}
	if (!ok(solve(&s, &m, 0, 2*N), "separate oscillators over seven decades, some overdamped"))
		return;
	ok(s.count == N + N/3, "%d eigenvalues with im >= 0", s.count);
	for (int k = 0; k < s.count; k++) {
		double nearest = HUGE_VAL;

		for (int j = 0; j < N; j++) {
			double omega = 1.3*pow(1.9, j), zeta = j%3 == 2 ? 1.31 : 0.021;
			double complex root = csqrt(zeta*zeta - 1.0 + 0.0*I);

			for (int sign = -1; sign <= 1; sign += 2) {
				double complex lambda = omega*(-zeta + sign*root);

				nearest = fmin(nearest, cabs(s.value[k].re + I*s.value[k].im - lambda)
				               /cabs(lambda));
			}
		}
		worst = fmax(worst, nearest);
	}
	ok(worst < 1e-13, "each to full relative accuracy: %.1e", worst);
}

/* q1'' + 2 g q2' - q1 = 0 and q2'' - 2 g q1' - q2 = 0: K is negative and is stabilised by the
 * gyroscopic force from g = 1 on: lambda = i (g +- sqrt(g^2 - 1)). */
static void test_gyroscopic_stability(void)
{
	const double M[4] = {1.0, 0.0, 0.0, 1.0}, K[4] = {-1.0, 0.0, 0.0, -1.0};

	for (double g = 0.5; g < 3.0; g += 0.4) {
		double G[4] = {0.0, 2.0*g, -2.0*g, 0.0}, worst = 0.0;
		struct hawser__quadratic problem = {2, M, G, K, 1};
		double complex root = csqrt(g*g - 1.0 + 0.0*I);
		struct hawser__eigenvalue value[4];
		struct hawser_report report;
		int axis = 1, found;

		if (!ok(!hawser__quadratic_eigen(value, NULL, NULL, &found, &problem, 0.7, 4, &report),
		        "two degrees of freedom, %g", g))
			continue;
		for (int k = 0; k < found; k++) {
			double nearest = HUGE_VAL;

			for (int sign = -1; sign <= 1; sign += 2) {
				double complex lambda = I*(g + sign*root);

				nearest = fmin(nearest, cabs(value[k].re + I*value[k].im - lambda));
				nearest = fmin(nearest, cabs(value[k].re - I*value[k].im - lambda));
			}
			axis &= (value[k].re == 0.0) == (g > 1.0);
			worst = fmax(worst, nearest);
		}
		ok(axis && found == 2 && worst < 1e-13, "gyroscopic force %g: %s, off by %.1e", g,
		   g > 1.0 ? "turns" : "grows", worst);
	}
}

static void test_failures(void)
{
	static struct matrices m;
	const struct hawser__quadratic problem = {N, m.M, m.G, m.K, 0};
	struct hawser__eigenvalue value[N];
	struct hawser_report report = {.message = ""};
	int found;

	string_of(&m, 0.5, 0.0, 0.0);
	m.K[5] = NAN;
	ok(hawser__quadratic_eigen(value, NULL, NULL, &found, &problem,
	                           1.0, N, &report) == HAWSER_ERR_NAN && !found, "%s", report.message);
	ok(hawser__quadratic_eigen(value, NULL, NULL, &found, &problem,
	                           0.0, N, &report) == HAWSER_ERR_ARGUMENT, "%s", report.message);
}

CASE(property_quadratic)
{
	test_routes(0.0, 0.0, 0);
	test_routes(0.613, 0.0, 0);
	test_routes(0.97, 0.013, 0);
	test_routes(1.13, 0.013, 1);
	test_routes(1.24, 0.013, 0); /* two negative stiffnesses, stabilised by G */
	test_routes(1.35, 0.013, 1);
	test_routes(3.3, 0.013, 2);
	test_damped();
	test_gyroscopic_stability();
	test_failures();
	return done_testing();
}
