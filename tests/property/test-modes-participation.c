/* tests/property/test-modes-participation.c - shares of the kinetic energy, participation factors
 * and modal effective masses: closed forms for a straight string, and sums over all modes.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include "tests/modes-span.h"
#include "tests/tap.h"

static int solve(struct hawser_modes *m, const struct hawser_statics *st, const char *method, int n)
{
	struct hawser_modes_options options = {.n = n, .method = method, .any_error = 1};
	struct hawser_report report = {0};

	return ok(!hawser_modes_solve(m, st, &options, &report), "%s, %d modes %s", method, n,
	          report.message);
}

/* Modes sqrt(2/l) sin(k pi s/l): the integral is sqrt(2 l)*2/(k pi) for odd k, and the effective mass
 * 8/(k pi)^2. Level, so that x is along the cable and y across it. */
static void straight(const char *method, double tolerance)
{
	struct hawser_statics st = scaled_span(0.0831, 1e-7, 0.0);
	int seen[3] = {0};
	struct hawser_modes m;

	if (!solve(&m, &st, method, getenv("HAWSER_LONG") ? 20 : 18))
		return;
	for (int i = 0; i < m.n; i++) {
		const struct hawser_mode *mode = m.mode + i;
		int axis = mode->plane == HAWSER_OUT_OF_PLANE ? 2
		           : mode->family == HAWSER_TRANSVERSE, k = ++seen[axis];
		double want = k%2 ? 8.0/(k*M_PI*k*M_PI) : 0.0;

		close_to(mode->effective_mass[axis], want, tolerance, "effective mass");
		/* the sign makes the first half-wave positive; y may point to n or to -n */
		close_to(fabs(mode->participation[axis]), sqrt(want*st.l), sqrt(tolerance)*1e-2,
		         "participation factor");
	}
	ok(seen[0] > 1 && seen[1] > 4 && seen[2] > 4, "all three directions were there");
	hawser_modes_clear(&m);
}

static void shares(const char *method, const struct hawser_statics *st)
{
	double worst = 0.0, least = 1.0;
	struct hawser_modes m;
	int named = 1;

	if (!solve(&m, st, method, 15))
		return;
	for (int i = 0; i < m.n; i++) {
		const struct hawser_mode *mode = m.mode + i;
		double P = mode->axial_share, Q = mode->normal_share, B = mode->out_of_plane_share;

		worst = fmax(worst, fabs(P + Q + B - 1.0));
		least = fmin(least, fmin(P, fmin(Q, B)));
		named &= mode->plane == HAWSER_OUT_OF_PLANE ? B == 1.0 : B == 0.0;
		named &= (mode->family == HAWSER_LONGITUDINAL) == (P > 0.5);
		for (int c = 0; c < 3; c++)
			worst = fmax(worst, fabs(mode->effective_mass[c] -
			                         pow(mode->participation[c], 2.0)/st->l));
	}
	ok(worst < 1e-13 && least >= 0.0, "%s: shares are of one whole, to %.1e", method, worst);
	ok(named, "%s: and agree with plane and family", method);
	hawser_modes_clear(&m);
}

/* The difference of the sum along an axis from 1 decreases as 1/n: with twice the modes it is half
 * as large. */
static void sums(double epsilon, double delta, double hs)
{
	struct hawser_statics st = scaled_span(epsilon, delta, hs);
	double missing[3][3];
	struct hawser_modes m;

	printf("# epsilon %g, delta %g, hs %g\n", epsilon, delta, hs);
	for (int i = 0; i < 3; i++) {
		if (!solve(&m, &st, "spectral", 60 << i))
			return;
		for (int c = 0; c < 3; c++) {
			missing[i][c] = 1.0;
			for (int k = 0; k < m.n; k++)
				missing[i][c] -= m.mode[k].effective_mass[c];
		}
		hawser_modes_clear(&m);
	}
	for (int c = 0; c < 3; c++) {
		double first = missing[0][c]/missing[1][c], second = missing[1][c]/missing[2][c];

		ok(missing[2][c] > 0.0 && missing[2][c] < 0.02, "%c: 240 modes carry all but %.1e",
		   "xyz"[c], missing[2][c]);
		ok(first > 1.7 && first < 2.3 && second > 1.7 && second < 2.3,
		   "%c: the rest halves, by %.3f and %.3f", "xyz"[c], first, second);
	}
}

CASE(property_modes_participation)
{
	struct hawser_statics st = scaled_span(2.385e-3, 0.147, 0.3), soft = scaled_span(0.2, 0.3, 0.1);
	const struct hawser_modes_method *row;

	for (int i = 0; (row = hawser_modes_method(i)); i++) {
		straight(row->name, fmin(1e-4, 1e2*row->tolerance));
		shares(row->name, &st);
		shares(row->name, &soft);
	}
	sums(0.0831, 0.4, 0.3);
	if (getenv("HAWSER_LONG"))
		sums(0.31, 1.1, -0.7);
	return done_testing();
}
