/* The law of a contact: derivatives against central differences, and its zeros against Coulomb's law.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "contact/friction.h"
#include "tests/friction-random.h"
#include "tests/tap.h"

/* Largest difference of Cr and Cu from central differences of F. */
static double slopes(struct hawser__friction_touch *touch, double sigma)
{
	const double step = 1e-6;
	double most = 0.0, high[3], low[3];
	struct hawser__touch_rows rows;

	hawser__touch_linearise(&rows, touch, sigma, NULL);
	for (int j = 0; j < 6; j++) {
		double *x = j < 3 ? &touch->r[j] : &touch->w[j - 3], kept = *x;

		*x = kept + step;
		(void)hawser__touch_law(high, touch, sigma);
		*x = kept - step;
		(void)hawser__touch_law(low, touch, sigma);
		*x = kept;
		for (int i = 0; i < 3; i++) {
			double exact = j < 3 ? rows.Cr[3*i + j] : rows.Cu[3*i + j - 3];

			most = fmax(most, fabs((high[i] - low[i])/(2.0*step) - exact));
		}
	}
	return most;
}

static void derivatives(void)
{
	static struct friction_case of = {.state = 2385};
	static const double sigma[] = {0.0, 1e-3, 0.3};
	struct hawser__friction_touch touch = {.next = -1};
	int state[3] = {0};

	for (int s = 0; s < 3; s++) {
		double most = 0.0;

		for (int i = 0; i < 300; i++) {
			for (int k = 0; k < 3; k++) {
				touch.r[k] = friction_between(&of, -1.0, 1.0) + (k ? 0.0 : 0.5);
				touch.w[k] = friction_between(&of, -0.3, 0.3);
			}
			touch.mu = friction_between(&of, 0.1, 1.9);
			touch.rho = friction_between(&of, 0.3, 3.0);
			if (s == 1) /* the curvature near a corner is 1/sigma: away from it */
				touch.r[0] += touch.r[0] > 0.2 ? 0.5 : -0.9;
			most = fmax(most, slopes(&touch, sigma[s]));
			state[hawser__touch_state(&touch)]++;
		}
		ok(most < (s == 1 ? 1e-4 : 1e-7), "derivatives at sigma %g: largest difference %.1e", sigma[s],
		   most);
	}
	ok(state[0] > 50 && state[1] > 50 && state[2] > 50, "open %d, stick %d, slip %d times", state[0],
	   state[1], state[2]);
}

/* |r - P_K(r - rho*(w + mu |w_T| n))|, P_K: projection on Coulomb's cone |r_T| <= mu r_N. */
static double saxce(const struct hawser__friction_touch *touch)
{
	const double mu = touch->mu, rho = touch->rho;
	double v[3], tangent, along;

	v[0] = touch->r[0] - rho*(touch->w[0] + mu*hypot(touch->w[1], touch->w[2]));
	v[1] = touch->r[1] - rho*touch->w[1];
	v[2] = touch->r[2] - rho*touch->w[2];
	tangent = hypot(v[1], v[2]);
	if (mu*tangent <= -v[0]) {
		memset(v, 0, sizeof v);
	} else if (tangent > mu*v[0]) {
		along = (v[0] + mu*tangent)/(1.0 + mu*mu);
		v[0] = along;
		v[1] *= mu*along/tangent;
		v[2] *= mu*along/tangent;
	}
	return hypot(hypot(touch->r[0] - v[0], touch->r[1] - v[1]), touch->r[2] - v[2]);
}

/* r and w of a state make F and the error of De Saxce zero; others do not. */
static void zeros(void)
{
	static const struct {
		double r[3], w[3], fails;
	} point[] = {
		{{0.0, 0.0, 0.0}, {0.7, -0.3, 0.2}, 0.0},
		{{2.0, 0.3, -0.4}, {0.0, 0.0, 0.0}, 0.0},
		{{2.0, 0.6, -0.8}, {0.0, -0.3, 0.4}, 0.0},
		{{2.0, 0.6, -0.8}, {0.0, 0.3, -0.4}, 1.0},
		{{2.0, 0.3, -0.4}, {0.0, -0.3, 0.4}, 1.0},
		{{2.0, 0.9, -1.2}, {0.0, 0.0, 0.0}, 1.0},
		{{2.0, 0.0, 0.0}, {0.1, 0.0, 0.0}, 1.0},
		{{-0.5, 0.0, 0.0}, {0.0, 0.0, 0.0}, 1.0},
		{{0.0, 0.0, 0.0}, {-0.1, 0.0, 0.0}, 1.0},
	};

	for (int i = 0; i < (int)(sizeof point/sizeof *point); i++) {
		struct hawser__friction_touch touch = {.mu = 0.5, .rho = 1.7, .next = -1};
		double law[3], F, error;

		memcpy(touch.r, point[i].r, sizeof touch.r);
		memcpy(touch.w, point[i].w, sizeof touch.w);
		(void)hawser__touch_law(law, &touch, 0.0);
		F = fabs(law[0]) + fabs(law[1]) + fabs(law[2]);
		error = saxce(&touch);
		ok(point[i].fails ? F > 1e-3 && error > 1e-3 : F < 1e-15 && error < 1e-15,
		   "point %d: F %.2e, error %.2e", i, F, error);
	}
}

CASE(unit_friction_law)
{
	derivatives();
	zeros();
	return done_testing();
}
