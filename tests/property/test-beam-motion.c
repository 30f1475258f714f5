/* Free motion of travelling beams: comparison with the matrix exponential; energies compared with
 * their rates.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include <hawser/beam_motion.h>

#include "tests/beam-near.h"

enum { N = 10, M = 2*N };

static const struct hawser_beam_method *legendre(void)
{
	return hawser_beam_method(0);
}

static void multiply(double *to, const double *a, const double *b)
{
	for (int i = 0; i < M; i++)
		for (int k = 0; k < M; k++) {
			double sum = 0.0;

			for (int j = 0; j < M; j++)
				sum += a[i*M + j]*b[j*M + k];
			to[i*M + k] = sum;
		}
}

/* exp(A t) by its series at t/2^s, squared s times. */
static void exponential(double *E, const double *A, double t)
{
	static double power[M*M], sum[M*M], next[M*M];
	enum { SQUARINGS = 24, TERMS = 18 };

	for (int i = 0; i < M*M; i++)
		power[i] = sum[i] = i%(M + 1) == 0;
	for (int k = 1; k <= TERMS; k++) {
		multiply(next, power, A);
		for (int i = 0; i < M*M; i++) {
			power[i] = next[i]*t/ldexp(k, SQUARINGS);
			sum[i] += power[i];
		}
	}
	for (int k = 0; k < SQUARINGS; k++) {
		multiply(next, sum, sum);
		memcpy(sum, next, sizeof sum);
	}
	memcpy(E, sum, sizeof sum);
}

/* Deflection at mid-span by the matrix exponential, from the first row. */
static void against_exponential(const char *name, struct hawser_beam beam)
{
	static double A[M*M], E[M*M], B[24*24], s[24];
	const struct hawser_beam_motion_options options = {.until = 2.0, .every = 1.0, .modes = N,
	                                                   .rtol = 1e-12};
	struct hawser_beam_motion motion;
	struct hawser_beam_integrals is;
	struct hawser_rom rom;
	struct hawser_report report = {0};
	double state[M] = {0.0}, y = 0.0;
	enum hawser_status status = hawser_beam_motion(&motion, legendre(), 24, &beam, &options, &report);

	if (!ok(status == HAWSER_OK && motion.rows == 3, "%s: %s", name, report.message))
		return;
	status = legendre()->fill(&is, beam.ends, 24, &report);
	if (!status)
		status = hawser_rom_from_beam(&rom, B, N, &is, &beam, &report);
	if (!ok(status == HAWSER_OK, "%s: model %s", name, report.message))
		return;
	for (int i = 0; i < N; i++)
		for (int k = 0; k < N; k++) {
			A[i*M + N + k] = i == k;
			A[(N + i)*M + k] = -rom.K[i*N + k];
			A[(N + i)*M + N + k] = -rom.D[i*N + k];
		}
	exponential(E, A, 2.0);
	/* the initial shape in these coordinates: 0.01 sin(pi x) by quadrature, u = B^T M b = int phi
	 * (f - r^2 f'') */
	for (int p = 0; p < 2000; p++) {
		double x = (p + 0.5)/2000.0, sine = sin(M_PI*x);
		double f = beam.ends ? 0.01*sine*sine : 0.01*sine;
		double slope = beam.ends ? 0.02*M_PI*sine*cos(M_PI*x) : 0.01*M_PI*cos(M_PI*x);
		double phi, dphi;

		for (int k = 0; k < N; k++) {
			phi = dphi = 0.0;
			legendre()->at(s, beam.ends, 24, 0, x);
			for (int j = 0; j < is.n; j++)
				phi += s[j]*B[j*N + k];
			legendre()->at(s, beam.ends, 24, 1, x);
			for (int j = 0; j < is.n; j++)
				dphi += s[j]*B[j*N + k];
			state[k] += (phi*f + beam.rotary*dphi*slope)/2000.0;
		}
	}
	legendre()->at(s, beam.ends, 24, 0, 0.5);
	for (int j = 0; j < is.n; j++)
		for (int k = 0; k < N; k++) {
			double u = 0.0;

			for (int m = 0; m < M; m++)
				u += E[k*M + m]*state[m];
			y += s[j]*B[j*N + k]*u;
		}
	near_to(motion.y[2], y, 1e-8, "%s: y is the exponential's %.10g", name, y);
	hawser_rom_clear(&rom);
	hawser_beam_integrals_clear(&is);
	hawser_beam_motion_clear(&motion);
}

/* The integral of the rates by Simpson's rule is the change of the energies. */
static void rates(const char *name, struct hawser_beam beam)
{
	const struct hawser_beam_motion_options options = {.until = 0.5, .every = 0.5/8000, .modes = N,
	                                                   .rtol = 1e-12};
	struct hawser_beam_motion m;
	struct hawser_report report = {0};
	enum hawser_status status = hawser_beam_motion(&m, legendre(), 24, &beam, &options, &report);
	double energy = 0.0, jacobi = 0.0, step = 0.5/8000, size = 0.0;
	int last = m.rows - 1 - (m.rows - 1)%2;

	if (!ok(status == HAWSER_OK, "%s: %s", name, report.message))
		return;
	for (int i = 0; i < last; i += 2) {
		energy += step/3.0*(m.change[i] + 4.0*m.change[i + 1] + m.change[i + 2]);
		jacobi += step/3.0*(m.leaves[i] + 4.0*m.leaves[i + 1] + m.leaves[i + 2]);
		size = fmax(size, fabs(m.energy[i]));
	}
	near_to((m.energy[0] + energy - m.energy[last])/size, 0.0, 1e-9,
	        "%s: E is the integral of its rate",
	         name);
	near_to((m.jacobi[0] + jacobi - m.jacobi[last])/size, 0.0, 1e-9, "%s: so is Jacobi's energy", name);
	if (beam.drag == 0.0 && (beam.moment || beam.rotary == 0.0 || beam.ends))
		near_to((m.jacobi[last] - m.jacobi[0])/size, 0.0, 1e-9, "%s: which is constant", name);
	hawser_beam_motion_clear(&m);
}

/* For a shape that satisfies the end conditions at every order (an eigenvector), the power of the
 * field at the ends, of the weight and of the drag is dE/dt. The difference decreases with the
 * number of functions. */
static double balance(struct hawser_beam beam, int size)
{
	enum { POINTS = 40001 }; /* linear interpolation between the rows: third derivatives show it */
	static double deflection[POINTS], rate[POINTS];
	struct hawser_beam_eigenvalue value;
	struct hawser_beam_integrals is;
	struct hawser_beam_motion m;
	struct hawser_report report = {0};
	struct hawser_beam_motion_options options = {.until = 1e-3, .every = 1e-3, .points = POINTS,
		.deflection = deflection, .rate = rate, .rtol = 1e-11};
	double vector[2*40], s[40], off;
	int found = 0;
	enum hawser_status status = legendre()->fill(&is, beam.ends, size, &report);

	if (!status)
		status = hawser_beam_eigenvalues(&value, vector, &found, &is, &beam, 1, &report);
	for (int p = 0; !status && p < POINTS; p++) {
		double re = 0.0, im = 0.0;

		legendre()->at(s, beam.ends, size, 0, p/(POINTS - 1.0));
		for (int j = 0; j < is.n; j++) {
			/* a phase at which no term is zero */
			re += s[j]*(0.8*vector[j] - 0.6*vector[is.n + j]);
			im += s[j]*(0.6*vector[j] + 0.8*vector[is.n + j]);
		}
		deflection[p] = re;
		rate[p] = value.re*re - value.im*im;
	}
	if (!status)
		status = hawser_beam_motion(&m, legendre(), size, &beam, &options, &report);
	if (!ok(status == HAWSER_OK, "motion from an eigenvector %s", report.message))
		return INFINITY;
	off = fabs(m.ends[0] + m.weight[0] + m.drag[0] - m.change[0])/
	      (fabs(m.ends[0]) + fabs(m.weight[0]) + fabs(m.drag[0]));
	hawser_beam_motion_clear(&m);
	hawser_beam_integrals_clear(&is);
	return off;
}

CASE(property_beam_motion)
{
	static const struct {
		const char *name;
		struct hawser_beam beam;
	} row[] = {
		{"level", {.theta = 1.0, .tension = 1.0, .speed = 3.0}},
		{"upright", {.theta = 1.0, .tension = 1.0, .weight = 10.0, .speed = 2.0}},
		{"beyond", {.theta = 1.0, .tension = 1.0, .weight = 10.0, .speed = 2.5}},
		{"all", {.theta = 1.0, .tension = 1.0, .weight = 10.0, .speed = 2.0, .drag = 2.0,
		        .rotary = 0.0025}},
		{"balanced", {.theta = 1.0, .tension = 1.0, .weight = 10.0, .speed = 2.0, .rotary = 0.0025,
		              .moment = HAWSER_MOMENT_BALANCED}},
		{"clamped", {.theta = 1.0, .tension = 1.0, .weight = 10.0, .speed = 2.0, .rotary = 0.0025,
		             .ends = HAWSER_ENDS_CLAMPED}},
	};
	struct hawser_beam_motion_options wrong = {.until = 1.0, .every = 0.1, .x = 1.5};
	struct hawser_beam_motion motion;
	struct hawser_report report = {0};
	enum hawser_status status;

	/* without HAWSER_LONG: upright, all, balanced and clamped */
	for (size_t i = 0; i < sizeof row/sizeof *row; i++) {
		double few, many;

		if (i%2 == 0 && i < 4 && !getenv("HAWSER_LONG"))
			continue;
		against_exponential(row[i].name, row[i].beam);
		rates(row[i].name, row[i].beam);
		few = balance(row[i].beam, 6);
		many = balance(row[i].beam, 12);
		ok(many < 2e-5 && many < 0.1*few,
		        "%s: balance at the ends off by %.1e with 6 functions, %.1e with 12",
		   row[i].name, few, many);
	}
	status = hawser_beam_motion(&motion, legendre(), 12, &row[0].beam, &wrong, &report);
	ok(status == HAWSER_ERR_ARGUMENT, "x beyond the beam: %s", report.message);
	hawser_beam_motion_clear(NULL);
	return done_testing();
}
