/* Modes of a travelling cable: the waves of a shape, modes without tension, comparison, every
 * failure.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <complex.h>

#include "tests/gyroscopic-span.h"
#include "tests/tap.h"

/* The waves add up to the shape; for a cable without weight they are those of a string. */
static void test_waves(void)
{
	const struct hawser_span span = {1e6, 2.385, 1e-8, 71.3, 0.0};
	struct hawser_modes modes;
	struct hawser_statics st;
	double sum = 0.0, level = 0.0, share = 0.0;

	if (!ok(travel(&st, span, 7310.0, 31.7, HAWSER_HOLD_TENSION) && solve(&modes, &st, 8, 0, NULL),
	        "a string"))
		return;
	for (int k = 0; k < 8; k++) {
		int c = modes.mode[k].plane == HAWSER_OUT_OF_PLANE ? 2 : 1;
		double nu = st.motion.nu, r = sqrt(1.0/(1.0 + st.epsilon) + nu*nu), slow = pow(r - nu, 2.0);

		share = fmax(share, fabs(modes.mode[k].downstream - slow/(slow + pow(r + nu, 2.0))));
		for (double s = 0.013; s < st.l; s += 0.0371) {
			double x[6], with[6], against[6], half = sqrt(0.5/st.l);

			hawser_modes_at(&modes, x, NULL, k, s);
			hawser_complex_modes_waves(&modes, with, against, k, s);
			for (int i = 0; i < 6; i++)
				sum = fmax(sum, fabs(with[i] + against[i] - x[i]));
			level = fmax(level, fabs(hypot(with[c], with[3 + c]) - half));
			level = fmax(level, fabs(hypot(against[c], against[3 + c]) - half));
		}
	}
	ok(sum < 1e-13, "two waves make the shape: %.1e", sum);
	ok(level < 1e-9, "of constant and equal amplitude: %.1e", level);
	ok(share < 1e-9, "the kinetic energy goes with the square of their speeds in the cable: %.1e",
	   share);
	hawser_modes_clear(&modes);
}

/* In-plane mode 3 of a level span at p = 1/3 has no dynamic tension (doc/theory-gyroscopic.md). */
static double mean_tension(double speed)
{
	const struct hawser_span level = {100e6, 5.0, 9.81, 100.0, 0.0};
	struct hawser_modes modes;
	struct hawser_statics st;
	double complex sum = 0.0;

	if (!travel(&st, level, T0, speed, HAWSER_HOLD_TENSION) || !solve(&modes, &st, 8, 0, NULL))
		return NAN;
	for (int k = 0; k < 8; k++) {
		const double *a = modes.slope + (size_t)k*6*(size_t)modes.grid.points;

		if (modes.mode[k].plane != HAWSER_IN_PLANE || modes.mode[k].number != 3)
			continue;
		for (int i = 0; i < modes.grid.points; i++)
			sum += modes.grid.weight[i]*(a[3*i] + I*a[3*modes.grid.points + 3*i]);
		sum /= sqrt(st.epsilon)*modes.mode[k].omega;
	}
	hawser_modes_clear(&modes);
	return cabs(sum);
}

static void test_no_tension(void)
{
	double before = mean_tension(42.44), at = mean_tension(43.44), after = mean_tension(44.44);

	ok(at < 1e-4 && before > 50.0*at && after > 50.0*at,
	   "a mode without dynamic tension at one speed: %.1e, %.1e, %.1e", before, at, after);
}

/* The kind of modes depends on the speed; a selection of complex modes has the same shapes. */
static void test_steady(void)
{
	const int kept[2] = {1, 4};
	const struct hawser_modes_options options = {.n = 6};
	struct hawser_modes modes, few;
	struct hawser_statics st;
	double x[6], y[6], off = 0.0;

	if (!ok(travel(&st, table_5_3, T0, 61.3, HAWSER_HOLD_TENSION) &&
	        !hawser_steady_modes_solve(&modes, &st, &options, NULL) && modes.gyroscopic &&
	        hawser_steady_modes_method(&st, 1) == hawser_complex_modes_method(1) &&
	        !hawser_steady_modes_method(&st, 3), "a cable that travels has complex modes"))
		return;
	ok(!hawser_modes_select(&few, &modes, kept, 2, NULL) && few.gyroscopic && few.n == 2,
	   "two of them");
	for (int i = 0; i < 2; i++) {
		hawser_modes_at(&few, x, NULL, i, 0.3719*st.l);
		hawser_modes_at(&modes, y, NULL, kept[i], 0.3719*st.l);
		for (int c = 0; c < 6; c++)
			off = fmax(off, fabs(x[c] - y[c]));
	}
	ok(off == 0.0 && few.mode[1].omega == modes.mode[4].omega, "with their shapes");
	hawser_modes_clear(&few);
	hawser_modes_clear(&modes);
	st.motion = (struct hawser_motion){.speed = 0.0};
	ok(!hawser_steady_modes_solve(&modes, &st, &options, NULL) && !modes.gyroscopic &&
	   modes.mode[0].re == 0.0 && modes.mode[0].condition == 1.0 && modes.mode[0].downstream == 0.5 &&
	   hawser_steady_modes_method(&st, 3) == hawser_modes_method(3) &&
	   !hawser_steady_modes_method(&st, 4) && !hawser_steady_modes_method(&st, -1),
	   "at rest they are real");
	hawser_modes_clear(&modes);
}

/* Comparison with the same modes at another phase, with a finer solution, and failures. */
static void test_compare(void)
{
	struct hawser_modes fine, coarse, other;
	struct hawser_modes_error error[6];
	struct hawser_report report = {.message = ""};
	struct hawser_statics st, longer;
	enum hawser_status status;
	double frequency = 0.0, shape = 0.0;

	if (!ok(travel(&st, table_5_3, T0, 61.3, HAWSER_HOLD_TENSION) &&
	        travel(&longer, table_5_3, 0.3*T0, 11.3, HAWSER_HOLD_TENSION) && solve(&fine, &st, 12,
	                                                                               0, NULL) &&
	        solve(&coarse, &st, 6, 13, NULL) && solve(&other, &longer, 6, 0,
	                                                  NULL), "three results"))
		return;
	for (int i = 0; i < 6*6*coarse.grid.points; i++) /* multiplied by i: a quarter of a period
	                                                  * later */
		if (i/(3*coarse.grid.points)%2 == 0) {
			double re = coarse.shape[i];

			coarse.shape[i] = -coarse.shape[i + 3*coarse.grid.points];
			coarse.shape[i + 3*coarse.grid.points] = re;
		}
	status = hawser_modes_compare(error, &coarse, &fine, &report);
	for (int k = 0; k < 6 && !status; k++) {
		frequency = fmax(frequency, error[k].frequency);
		shape = fmax(shape, error[k].shape);
	}
	ok(!status && frequency < 1e-9 && shape > 1e-7 && shape < 1e-3,
	   "a coarse one in another phase: %.1e, shapes %.1e", frequency, shape);
	status = hawser_modes_compare(error, &fine, &coarse, &report);
	ok(status == HAWSER_ERR_ARGUMENT && strstr(report.message, "ask for more"), "%s",
	   report.message);
	status = hawser_modes_compare(error, &other, &fine, &report);
	ok(status == HAWSER_ERR_ARGUMENT && strstr(report.message, "different spans"), "%s",
	   report.message);
	fine.gyroscopic = 0;
	status = hawser_modes_compare(error, &coarse, &fine, &report);
	fine.gyroscopic = 1;
	ok(status == HAWSER_ERR_ARGUMENT && strstr(report.message, "complex"), "%s", report.message);
	coarse.mode[1].omega = NAN;
	status = hawser_modes_compare(error, &coarse, &fine, &report);
	ok(status == HAWSER_ERR_NAN, "%s", report.message);
	hawser_modes_clear(&fine);
	hawser_modes_clear(&coarse);
	hawser_modes_clear(&other);
}

/* --- failures --- */

static void fails(const struct hawser_statics *st, struct hawser_modes_options options,
                  enum hawser_status wanted, const char *word)
{
	struct hawser_modes modes;
	struct hawser_report report = {0};
	enum hawser_status status = hawser_complex_modes_solve(&modes, st, &options, &report);

	ok(status == wanted && strstr(report.message, word) && !modes.mode && !modes.shape,
	   "status %d, \"%s\" in: %s", (int)status, word, report.message);
	hawser_modes_clear(&modes);
}

static void test_failures(void)
{
	struct hawser_statics st, broken;

	if (!ok(travel(&st, table_5_3, T0, 30.0, HAWSER_HOLD_TENSION), "30 m/s"))
		return;
	fails(&st, (struct hawser_modes_options){.n = 0}, HAWSER_ERR_ARGUMENT, "at least one");
	fails(&st, (struct hawser_modes_options){.n = 2, .basis = -1}, HAWSER_ERR_ARGUMENT, "basis");
	fails(&st, (struct hawser_modes_options){.n = 2, .tolerance = 1.0}, HAWSER_ERR_ARGUMENT,
	      "tolerance");
	fails(&st, (struct hawser_modes_options){.n = 2, .method = "fdm"}, HAWSER_ERR_ARGUMENT,
	      "no method \"fdm\"");
	fails(&st, (struct hawser_modes_options){.n = 40, .basis = 8}, HAWSER_ERR_ARGUMENT, "raise");
	fails(&st, (struct hawser_modes_options){.n = 9, .basis = 401}, HAWSER_ERR_ARGUMENT, "lower");
	fails(&st, (struct hawser_modes_options){.n = 2000}, HAWSER_ERR_ARGUMENT, "fewer");
	fails(&st, (struct hawser_modes_options){.n = 4, .tolerance = 1e-17}, HAWSER_ERR_CONVERGENCE,
	      "1e-13");
	fails(&st, (struct hawser_modes_options){.n = 4, .tolerance = 1e-9, .method = "analytic"},
	      HAWSER_ERR_CONVERGENCE, "closed forms");
	fails(&st, (struct hawser_modes_options){.n = 2000, .method = "analytic"}, HAWSER_ERR_ARGUMENT,
	      "samples");
	fails(&st, (struct hawser_modes_options){.n = 40, .basis = 9, .method = "analytic"},
	      HAWSER_ERR_ARGUMENT, "samples");
	fails(&st, (struct hawser_modes_options){.n = 3, .tolerance = 1e-9, .method = "fdm-source"},
	      HAWSER_ERR_CONVERGENCE, "points");
	fails(&st, (struct hawser_modes_options){.n = 3, .basis = 251, .method = "fdm-source"},
	      HAWSER_ERR_ARGUMENT, "dense");
	fails(&st, (struct hawser_modes_options){.n = 9, .basis = 8, .method = "fdm-source"},
	      HAWSER_ERR_ARGUMENT, "raise");
	broken = st;
	broken.eta = NAN;
	fails(&broken, (struct hawser_modes_options){.n = 2}, HAWSER_ERR_NAN, "eta");
	broken = st;
	broken.motion.nu = NAN;
	fails(&broken, (struct hawser_modes_options){.n = 2}, HAWSER_ERR_NAN, "speed");
	broken = st;
	broken.delta = -1.0;
	fails(&broken, (struct hawser_modes_options){.n = 2}, HAWSER_ERR_ARGUMENT, "delta");
	broken = st;
	broken.epsilon = 0.0;
	fails(&broken, (struct hawser_modes_options){.n = 2}, HAWSER_ERR_NO_SOLUTION, "inextensible");
	hawser_modes_clear(NULL);
}

CASE(unit_gyroscopic)
{
	test_waves();
	test_no_tension();
	test_steady();
	test_compare();
	test_failures();
	ok(hawser_complex_modes_method(2)->solve && !hawser_complex_modes_method(3), "three rows");
	return done_testing();
}
