/* Modes of a travelling cable: closed form of the taut cable, integration of the equations with a
 * complex frequency, the cable at rest, reversal of the travel, orthogonality, resolutions, speeds
 * near the limit.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include "tests/gyroscopic-shooting.h"
#include "tests/gyroscopic-span.h"
#include "tests/tap.h"

/* --- a taut flat cable: omega_n = n pi sqrt(T g/rho)/d (1 - rho g v^2/T), g the stretch --- */

/* Integral of conj(closed form)*mode, both of norm 1: its modulus is 1 if they are equal. */
static double likeness(const struct hawser_modes *modes, int k, int n, double phase)
{
	const struct hawser_grid *grid = &modes->grid;
	const double *re = modes->shape + (size_t)k*6*(size_t)grid->points, *im = re + 3*grid->points;
	int c = modes->mode[k].plane == HAWSER_OUT_OF_PLANE ? 2 : 1;
	double complex sum = 0.0;

	for (int i = 0; i < grid->points; i++) {
		double t = grid->s[i]/modes->statics.l;

		sum += grid->weight[i]*sqrt(2.0/modes->statics.l)*sin(n*M_PI*t)*cexp(-I*phase*t)
		       *(re[3*i + c] + I*im[3*i + c]);
	}
	return cabs(sum);
}

static void test_taut(double share)
{
	const struct hawser_span span = {1e6, 2.385, 1e-8, 71.3, 0.0};
	const double T = 7310.0, stretch = 1.0 + T/span.EA;
	double v = share*sqrt(T/(span.rho*stretch)), worst = 0.0, unlike = 0.0;
	struct hawser_modes modes;
	struct hawser_statics st;

	if (!ok(travel(&st, span, T, v, HAWSER_HOLD_TENSION), "taut at %g of the wave speed", share) ||
	    !ok(solve(&modes, &st, 20, 0, NULL), "solved"))
		return;
	for (int k = 0; k < modes.n; k++) {
		int n = modes.mode[k].number;
		double exact = n*M_PI/span.d*sqrt(T*stretch/span.rho)*(1.0 - share*share);
		double c2 = 1.0/(1.0 + st.epsilon), r = sqrt(c2 + st.motion.nu*st.motion.nu);

		worst = fmax(worst, fabs(modes.mode[k].omega/modes.time_unit/exact - 1.0));
		unlike = fmax(unlike, fabs(likeness(&modes, k, n, n*M_PI*st.motion.nu/r) - 1.0));
	}
	ok(worst < 1e-8, "omega_n = n pi (1 - nu^2) within 1e-8: %.1e", worst);
	ok(unlike < 1e-8, "shapes sin(n pi s) exp(i n pi nu s/r): %.1e", unlike);
	hawser_modes_clear(&modes);
}

/* --- another route --- */

static void test_shooting(const struct hawser_statics *st, int n, int steps, double tolerance,
                          const char *what)
{
	struct hawser_modes modes;
	double worst = 0.0, growth = 0.0, doubt = 0.0, stated = 0.0;

	if (!ok(solve(&modes, st, n, 0, NULL), "%s: %d modes", what, n))
		return;
	for (int k = 0; k < n; k++) {
		double error;
		double complex omega = turn_frequency(st, modes.mode[k].plane, modes.mode[k].omega, steps,
		                                      &error);

		worst = fmax(worst, cabs(omega/modes.mode[k].omega - 1.0));
		growth = fmax(growth, fabs(cimag(omega))/creal(omega));
		doubt = fmax(doubt, error);
		stated = fmax(stated, modes.mode[k].residual);
	}
	printf("# %s: nu %.4g, %d functions, shooting's own %.1e, imaginary part %.1e\n", what,
	       st->motion.nu, modes.basis, doubt, growth);
	ok(worst < tolerance, "%s: integrated equations agree: %.1e, stated %.1e", what, worst, stated);
	ok(worst <= stated + doubt + 1e-14, "%s: no more off than stated", what);
	hawser_modes_clear(&modes);
}

/* --- rest, slow travel --- */

static void test_rest(const char *method)
{
	struct hawser_modes_options options = {.n = 12, .method = method};
	struct hawser_modes turning, slow;
	struct hawser_modes resting;
	struct hawser_statics st;
	struct hawser_report report;
	double worst = 0.0, shape = 0.0;
	int same = 1;

	if (!ok(travel(&st, table_5_3, T0, 0.0, HAWSER_HOLD_TENSION) &&
	        !hawser_modes_solve(&resting, &st, &options, &report) &&
	        solve(&turning, &st, 12, 0, method),
	        "%s at rest", method))
		return;
	for (int k = 0; k < 12; k++) {
		size_t size = 3*(size_t)resting.grid.points, at = (size_t)k*size;
		double plus = 0.0, minus = 0.0;

		same &= turning.mode[k].omega == resting.mode[k].omega && turning.mode[k].re == 0.0 &&
		        turning.mode[k].plane == resting.mode[k].plane &&
		        turning.mode[k].residual == resting.mode[k].residual;
		for (size_t i = 0; i < size; i++) {
			plus = fmax(plus, fabs(turning.shape[2*at + i] - resting.shape[at + i]));
			minus = fmax(minus, fabs(turning.shape[2*at + i] + resting.shape[at + i]));
			same &= turning.shape[2*at + size + i] == 0.0;
		}
		shape = fmax(shape, fmin(plus, minus));
	}
	ok(same, "%s: the resting frequencies, bit for bit, and no imaginary part of a shape", method);
	ok(shape < 1e-14, "%s: the resting shapes: %.1e", method, shape);
	if (ok(travel(&st, table_5_3, T0, 1e-8, HAWSER_HOLD_TENSION) && solve(&slow, &st, 12, 0,
	                                                                      method),
	       "%s at 1e-8 m/s", method)) {
		for (int k = 0; k < 12; k++)
			worst = fmax(worst, fabs(slow.mode[k].omega/turning.mode[k].omega - 1.0));
		/* both analytic methods order the modes of a plane in the same way, but the two planes may
		 * be interleaved differently */
		ok(worst < 1e-12 || strcmp(method, "spectral") != 0, "%s: as at rest: %.1e", method, worst);
		hawser_modes_clear(&slow);
	}
	hawser_modes_clear(&turning);
	hawser_modes_clear(&resting);
}

/* --- reversal and orthogonality --- */

static void test_reversal(void)
{
	struct hawser_modes there, back;
	struct hawser_statics st, reversed;
	double frequency = 0.0, shape = 0.0, stream = 0.0;

	if (!ok(travel(&st, table_5_3, T0, 61.3, HAWSER_HOLD_TENSION) &&
	        travel(&reversed, table_5_3, T0, -61.3, HAWSER_HOLD_TENSION) &&
	        solve(&there, &st, 14, 0, NULL) && solve(&back, &reversed, 14, 0, NULL), "both ways"))
		return;
	for (int k = 0; k < 14; k++) {
		size_t size = 3*(size_t)there.grid.points, at = (size_t)k*2*size;

		frequency = fmax(frequency, fabs(back.mode[k].omega/there.mode[k].omega - 1.0));
		stream = fmax(stream, fabs(back.mode[k].downstream + there.mode[k].downstream - 1.0));
		for (size_t i = 0; i < size; i++) {
			shape = fmax(shape, fabs(there.shape[at + i] - back.shape[at + i]));
			shape = fmax(shape, fabs(there.shape[at + size + i] + back.shape[at + size + i]));
		}
	}
	ok(frequency < 1e-13, "travel the other way has the same frequencies: %.1e", frequency);
	ok(shape < 1e-10, "and the conjugate shapes: %.1e", shape);
	ok(stream < 1e-9, "with the waves' parts exchanged: %.1e", stream);
	hawser_modes_clear(&there);
	hawser_modes_clear(&back);
}

/* Energy product of modes j and k: strain energy plus omega_j omega_k times the mass, complex. */
static double complex energy(const struct hawser_modes *m, int j, int k)
{
	const struct hawser_grid *grid = &m->grid;
	size_t size = 3*(size_t)grid->points;
	const double *xj = m->shape + (size_t)j*2*size, *xk = m->shape + (size_t)k*2*size;
	const double *dj = m->slope + (size_t)j*2*size, *dk = m->slope + (size_t)k*2*size;
	double complex sum = 0.0;

	for (int i = 0; i < grid->points; i++) {
		double u = m->statics.eta + m->statics.delta*grid->s[i], T = hypot(1.0, u);
		double soft[3] = {1.0/m->statics.epsilon, T/(1.0 + m->statics.epsilon*T), 0.0};

		soft[2] = soft[1];
		for (int c = 0; c < 3; c++) {
			size_t at = 3*(size_t)i + (size_t)c;
			double complex u1 = xj[at] - I*xj[size + at], u2 = xk[at] + I*xk[size + at];
			double complex d1 = dj[at] - I*dj[size + at], d2 = dk[at] + I*dk[size + at];

			sum += grid->weight[i]*(soft[c]*d1*d2 + m->mode[j].omega*m->mode[k].omega*u1*u2);
		}
	}
	return sum;
}

static void test_orthogonality(double speed)
{
	struct hawser_modes modes;
	struct hawser_statics st;
	double worst = 0.0, norm = 0.0;

	if (!ok(travel(&st, table_5_3, T0, speed, HAWSER_HOLD_TENSION) && solve(&modes, &st, 16, 0,
	                                                                        NULL),
	        "16 modes at %g m/s", speed))
		return;
	for (int j = 0; j < 16; j++) {
		double own = creal(energy(&modes, j, j)), mass = 0.0;

		for (int k = 0; k < j; k++)
			worst = fmax(worst, cabs(energy(&modes, j, k))
			             /sqrt(own*creal(energy(&modes, k, k))));
		for (int i = 0; i < 6*modes.grid.points; i++)
			mass += modes.grid.weight[i%(3*modes.grid.points)/3]
			        *pow(modes.shape[(size_t)j*6*(size_t)modes.grid.points + (size_t)i], 2.0);
		norm = fmax(norm, fabs(mass - 1.0));
	}
	ok(worst < 1e-11, "%g m/s: orthogonal in energy: %.1e", speed, worst);
	ok(norm < 1e-13, "%g m/s: of norm 1: %.1e", speed, norm);
	hawser_modes_clear(&modes);
}

/* --- all resolutions, and the errors of the other methods --- */

static void test_resolutions(struct hawser_span span, double tension, double speed,
                             const char *what)
{
	static const int basis[] = {20, 23, 31, 47, 64, 90, 128, 200};
	int most = getenv("HAWSER_LONG") ? 8 : 6, held = 1, honest = 1, n = 14;
	struct hawser_modes exact, modes;
	struct hawser_statics st;

	if (!ok(travel(&st, span, tension, speed, HAWSER_HOLD_TENSION) && solve(&exact, &st, n, 0,
	                                                                        NULL),
	        "%s at %g m/s", what, speed))
		return;
	for (int b = 0; b < most; b++) {
		if (!ok(solve(&modes, &st, n, basis[b], NULL), "%d functions", basis[b]))
			continue;
		for (int k = 0; k < n; k++) {
			double off = fabs(modes.mode[k].omega/exact.mode[k].omega - 1.0);

			held &= fabs(modes.mode[k].re) <= 1e-10*modes.mode[k].omega;
			honest &= off <= modes.mode[k].residual + exact.mode[k].residual;
		}
		hawser_modes_clear(&modes);
	}
	ok(held, "%s at %g m/s: no real part at any resolution", what, speed);
	ok(honest, "%s at %g m/s: no more off than stated", what, speed);
	hawser_modes_clear(&exact);
}

/* Method `method` at two resolutions (0: its own) against the converged method. A bound states that
 * a frequency of the plane lies within this distance. */
static void test_bound(const char *method, double speed, int basis, double at_most)
{
	struct hawser_modes exact, modes;
	struct hawser_statics st;
	double worst = 0.0, stated = 0.0;
	int n = 8, held = 1;

	if (!ok(travel(&st, table_5_3, T0, speed, HAWSER_HOLD_TENSION) && solve(&exact, &st, 3*n, 0,
	                                                                        NULL) &&
	        solve(&modes, &st, n, basis, method), "%s at %g m/s", method, speed))
		return;
	for (int k = 0; k < n; k++) {
		double nearest = HUGE_VAL;

		for (int j = 0; j < 3*n; j++)
			if (exact.mode[j].plane == modes.mode[k].plane)
				nearest = fmin(nearest, fabs(modes.mode[k].omega/exact.mode[j].omega - 1.0));
		held &= nearest <= modes.mode[k].residual;
		worst = fmax(worst, nearest);
		stated = fmax(stated, modes.mode[k].residual);
	}
	ok(held, "%s at %g m/s, %d: off %.1e, stated %.1e", method, speed, modes.basis, worst, stated);
	ok(stated < at_most, "%s at %g m/s: a bound worth stating: %.1e", method, speed, stated);
	hawser_modes_clear(&exact);
	hawser_modes_clear(&modes);
}

static void test_source_growth(void)
{
	struct hawser_modes modes;
	struct hawser_statics st;
	double before = 0.0, growth = 0.0;

	ok(travel(&st, table_5_3, T0, 50.0, HAWSER_HOLD_TENSION), "50 m/s");
	for (int points = 30; points <= 60; points += 30) {
		if (!solve(&modes, &st, 6, points - 1, "fdm-source"))
			continue;
		before = growth;
		growth = 0.0;
		for (int k = 0; k < 6; k++)
			growth = fmax(growth, modes.mode[k].re/modes.mode[k].omega);
		hawser_modes_clear(&modes);
	}
	ok(growth > 1e-8, "the source's finite differences grow: %.1e of im", growth);
	ok(before/growth > 3.5 && before/growth < 4.5,
	   "with half the interval to a quarter: an error of the discretisation (%.2f)", before/growth);
}

/* --- up to the limit speed --- */

static void test_limit(double share)
{
	struct hawser_modes modes;
	struct hawser_statics st;
	struct hawser_report report;
	double limit;
	enum hawser_status status = hawser_statics_limit(&limit, &table_5_3, HAWSER_GIVEN_T0, T0,
	                                                 HAWSER_BRANCH_TAUT, HAWSER_HOLD_TENSION,
	                                                 &report);
	char what[80];

	if (!ok(!status, "limit speed") ||
	    !ok(travel(&st, table_5_3, T0, share*limit, HAWSER_HOLD_TENSION),
	        "steady state at %.7g of it",
	        share))
		return;
	snprintf(what, sizeof what, "%.7g of %.6g m/s", share, limit);
	test_shooting(&st, 8, 60, 1e-10, what);
	if (solve(&modes, &st, 8, 0, NULL)) {
		ok(modes.mode[0].omega > 0.0 && modes.mode[0].re == 0.0, "%s: turns, and does not grow", what);
		hawser_modes_clear(&modes);
	}
}

CASE(property_gyroscopic)
{
	/* the fictitious cable of B Table 5.1, on the span of Table 5.3, soft: EA 1 MN, rho 3 kg/m */
	const struct hawser_span soft = {1e6, 3.0, 9.81, 100.0, 33.0}, deep = {40e6, 6.0, 9.81, 100.0,
	                                                                       33.0};
	struct hawser_statics st;

	for (double share = 0.0; share < 0.95; share += 0.13)
		test_taut(share);
	test_taut(0.999);
	test_rest("spectral");
	test_rest("analytic");
	test_reversal();
	test_orthogonality(50.0);
	test_orthogonality(125.0);
	if (travel(&st, table_5_3, T0, 89.86, HAWSER_HOLD_TENSION))
		test_shooting(&st, 20, 60, 1e-12, "B Table 5.3 at 89.86 m/s");
	if (travel(&st, soft, 50e3, 97.3, HAWSER_HOLD_TENSION))
		test_shooting(&st, 16, 60, 1e-12, "soft and steep");
	if (travel(&st, deep, 9e3, 41.7, HAWSER_HOLD_LENGTH))
		test_shooting(&st, 10, 120, 1e-11, "deep, length held");
	test_resolutions(table_5_3, T0, 12.0, "B Table 5.2");
	test_resolutions(table_5_3, T0, 120.0, "B Table 5.3");
	test_resolutions(soft, 50e3, 97.3, "B Table 5.1, fictitious");
	test_resolutions(deep, 100e3, 8.0, "B Table 5.1, hauling rope");
	test_bound("analytic", 12.0, 0, 3e-3);
	test_bound("analytic", 100.0, 0, 0.1);
	test_bound("analytic", -100.0, 0, 0.1);
	test_bound("fdm-source", 12.0, 0, 0.02);
	test_bound("fdm-source", 100.0, 120, 0.02);
	test_source_growth();
	test_limit(0.999);
	test_limit(0.999999);
	return done_testing();
}
