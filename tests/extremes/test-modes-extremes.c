/* tests/extremes/test-modes-extremes.c - modes in extreme cases: nearly inextensible, nearly straight,
 * very slack, very steep, very soft; many modes and one mode.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include "tests/modes-shooting.h"
#include "tests/modes-span.h"
#include "tests/tap.h"

static void corner(double epsilon, double delta, double hs, int n, int steps)
{
	struct hawser_statics st = scaled_span(epsilon, delta, hs);
	struct hawser_modes_options options = {.n = n};
	struct hawser_report report = {0};
	struct hawser_modes m;
	double stated = 0.0;
	int tried[] = {0, n/3, n - 1};

	if (!ok(!hawser_modes_solve(&m, &st, &options, &report), "epsilon %g, delta %g, hs %g, "
	        "%d modes %s", epsilon, delta, hs, n, report.message))
		return;
	for (int k = 0; k < n; k++)
		stated = fmax(stated, m.mode[k].residual);
	ok(stated <= 1e-10, "stated error %.1e with %d functions", stated, m.basis);
	for (int i = 0; i < 3; i++) {
		const struct hawser_mode *mode = m.mode + tried[i];
		double error;

		shoot_frequency(&st, mode->plane, mode->omega, steps, &error);
		ok(error <= mode->residual, "mode %d of %d: true error %.1e, stated %.1e",
		   tried[i] + 1, n, error, mode->residual);
	}
	hawser_modes_clear(&m);
}

/* From a scene's quantities: 1e14 N of stiffness, all through the statics. */
static void stiff_scene(void)
{
	struct hawser_span span = {.EA = 1e14, .rho = 6.0, .g = 9.81, .d = 250.0, .h = 10.0};
	struct hawser_modes_options options = {.n = 10};
	struct hawser_statics st;
	struct hawser_modes m;
	struct hawser_report report = {0};

	if (!ok(!hawser_statics_solve(&st, &span, HAWSER_GIVEN_T0, 80e3, HAWSER_BRANCH_TAUT, &report),
	        "statics %s", report.message) ||
	    !ok(!hawser_modes_solve(&m, &st, &options, &report), "modes %s", report.message))
		return;
	for (int k = 0; k < 10; k += 3) {
		double error;

		shoot_frequency(&st, m.mode[k].plane, m.mode[k].omega, 20, &error);
		ok(error <= m.mode[k].residual && error < 1e-12, "EA 1e14 N, mode %d: error %.1e",
		   k + 1, error);
	}
	close_to(m.time_unit, 250.0*sqrt(6.0/st.H), 1e-15, "unit of time");
	hawser_modes_clear(&m);
}

/* For every request a method returns finite numbers in ascending order, or a reason. 1: it does not. */
static int ask(const char *method, const struct hawser_statics *st, int n, int basis)
{
	struct hawser_modes_options options = {.n = n, .basis = basis, .method = method};
	struct hawser_report report = {0};
	struct hawser_modes m;
	enum hawser_status status = hawser_modes_solve(&m, st, &options, &report);
	int good = 1;

	for (int k = 0; k < m.n; k++) {
		good &= isfinite(m.mode[k].omega) && m.mode[k].omega > 0.0;
		good &= isfinite(m.mode[k].residual) && m.mode[k].residual > 0.0;
		good &= k == 0 || m.mode[k].omega >= m.mode[k - 1].omega;
	}
	for (int i = 0; i < 3*m.n*m.grid.points; i++)
		good &= isfinite(m.shape[i]) && isfinite(m.slope[i]);
	if (status)
		good = strlen(report.message) > 20 && m.n == 0 && status != HAWSER_ERR_MEMORY;
	if (!good)
		printf("# %s, %d modes, %d functions, epsilon %g, delta %g: %s %s\n", method, n, basis,
		       st->epsilon, st->delta, hawser_status_name(status), report.message);
	hawser_modes_clear(&m);
	return !good;
}

static void every_method(void)
{
	const double spans[][3] = {{1e-4, 0.1, 0.2}, {1e-14, 1e-9, 0.0}, {1e-12, 25.0, 3.0},
	                           {3.0, 0.2, 1.0}, {1e-300, 1e-6, 0.0}, {1e-9, 0.3, 1e6}};
	const int bases[] = {1, 2, 3, 4, 5, 7, 12, 41, getenv("HAWSER_LONG") ? 300 : 110};
	const struct hawser_modes_method *row;

	for (int i = 0; (row = hawser_modes_method(i)); i++) {
		int bad = 0;

		for (size_t j = 0; j < sizeof spans/sizeof spans[0]; j++) {
			struct hawser_statics st = scaled_span(spans[j][0], spans[j][1], spans[j][2]);

			for (size_t b = 0; b < sizeof bases/sizeof bases[0]; b++) {
				bad += ask(row->name, &st, 1, bases[b]);
				bad += ask(row->name, &st, 7, bases[b]);
				bad += ask(row->name, &st, 3*bases[b] > 24 ? 24 : 3*bases[b], bases[b]);
			}
		}
		ok(bad == 0, "%s: hard spans on small and large bases, %d wrong", row->name, bad);
	}
}

CASE(extremes_modes_extremes)
{
	corner(1e-14, 1e-7, 0.0, 10, 20);
	corner(1e-14, 1e-7, 20.0, 10, 20);
	corner(1e-14, 0.5, -20.0, 10, 20);
	corner(1e-14, 20.0, 0.0, 10, 60);
	corner(1e-14, 20.0, 20.0, 10, 60);
	corner(1e-13, 35.0, 0.0, 10, 240);
	corner(30.0, 0.01, 0.3, 10, 20);
	corner(1e-9, 0.8, 0.3, 1, 20);
	corner(1e-9, 0.8, 0.3, 90, 150);
	stiff_scene();
	every_method();
	return done_testing();
}
