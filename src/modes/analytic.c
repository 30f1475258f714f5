/* modes/analytic.c - closed forms for constant tension and curvature, with an error bound.
 *
 *   T, g, kappa   tension, stretch and curvature, as constants: their values at mid-length
 *   k^2           T/g: square of the speed of transverse waves; 1/epsilon: of longitudinal ones
 *   z             s/l - 1/2
 *   X             omega*l/(2*speed): half the phase from end to end
 *   f, h          leading component (B; Q of a transverse, P of a longitudinal mode) and the other
 *                 one in the plane: h' = sigma*kappa*(f - mean of f), sigma +1 (transverse) or -1
 *   lambda^2      (kappa*l)^2/(epsilon*k^2), Irvine's, for transverse modes; epsilon*(kappa*l*k)^2
 *                 for longitudinal ones
 *   A, mu         compliance operator of the plane, 1/omega^2
 *
 * B 4.1.3 and 4.1.4 (doc/theory-modes.md has the derivation, doc/errata.md the misprints). In modes
 * with sin X = 0, f has zero mean and causes no tension (no rotation, for longitudinal modes); the
 * others have tan X = X - 4 X^3/lambda^2. As tan X - X rises in every interval between poles, and
 * 4 X^3/lambda^2 too, each of ((m-1/2)pi, (m+1/2)pi), m = 1, 2..., has exactly one root, and (0,
 * pi/2) none. With X = (m-1/2)pi + y the equation is lambda^2 cos y + X (lambda^2 - 4 X^2) sin y =
 * 0, which has no poles, is positive at y = 0 and negative at pi, so that no root is missed or
 * found twice, not even at the crossover lambda = 2 m pi, where the root coincides with one of sin
 * X = 0.
 *
 * The error estimate is a rigorous bound: for unit Phi and any mu an eigenvalue of A lies within
 * |A Phi - mu Phi| of mu (Weinstein), and A is exact up to quadrature.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/order.h"
#include "core/report.h"
#include "modes/analytic.h"
#include "modes/label.h"
#include "modes/spectral.h"

enum { FUNCTIONS_MAX = 1200, APPLICATIONS = 3 };
enum { BOUND_WORK = 9 }; /* rows */

/* Constants of the profile. */
struct constants {
	double l, kappa, speed[HAWSER__WAVE_KINDS], lambda2[HAWSER__WAVE_KINDS];
};

static struct constants constants_of(const struct hawser_statics *st)
{
	double u = st->eta + 0.5*st->delta*st->l, T = hypot(1.0, u), kl, across, along;
	struct constants c = {.l = st->l, .kappa = st->delta/(T*T)};

	kl = c.kappa*c.l;
	across = sqrt(T/(1.0 + st->epsilon*T));
	along = 1.0/sqrt(st->epsilon);
	c.speed[HAWSER__OUT_OF_PLANE] = c.speed[HAWSER__TRANSVERSE] = across;
	c.speed[HAWSER__LONGITUDINAL] = along;
	c.lambda2[HAWSER__TRANSVERSE] = pow(kl*along/across, 2.0);
	c.lambda2[HAWSER__LONGITUDINAL] = pow(kl*across/along, 2.0);
	return c;
}

/* The root between (m-1/2)pi and (m+1/2)pi, by bisection in y down to the last digit of X. */
static double root(int m, double lambda2)
{
	double low = 0.0, high = M_PI, pole = (m - 0.5)*M_PI;

	while (high - low > 1e-16*pole) {
		double y = 0.5*(low + high), X = pole + y;

		if (y <= low || y >= high)
			break;
		if (lambda2*cos(y) + X*(lambda2 - 4.0*X*X)*sin(y) > 0.0)
			low = y;
		else
			high = y;
	}
	return pole + 0.5*(low + high);
}

/* The first n of each kind; the first n of all are then among them. */
static void find(struct hawser__wave *wave, const struct hawser_statics *st, int n)
{
	const struct constants c = constants_of(st);

	for (int i = 0; i < HAWSER__WAVE_KINDS*n; i++) {
		enum hawser__wave_kind kind = (enum hawser__wave_kind)(i/n);
		int j = i%n, m = j/2 + 1, even = kind != HAWSER__OUT_OF_PLANE && j%2 == 0;
		double X = kind == HAWSER__OUT_OF_PLANE ? 0.5*M_PI*(j + 1)
		           : even ? root(m, c.lambda2[kind]) : m*M_PI;

		wave[i] = (struct hawser__wave){.omega = 2.0*X*c.speed[kind]/c.l, .phase = X, .kind = kind,
		                                .even = even};
	}
}

/* f, f', h, h' at z. */
static void evaluate(double *value, const struct hawser__wave *wave, const struct constants *c,
                     double z)
{
	double X = wave->phase, angle = 2.0*X*(wave->even ? z : z + 0.5);
	double sigma = wave->kind == HAWSER__TRANSVERSE ? c->kappa : -c->kappa, reach = 0.5*c->l/X;

	if (wave->even) {
		value[0] = cos(X) - cos(angle);
		value[1] = sin(angle)/reach;
		value[2] = sigma*reach*(2.0*z*sin(X) - sin(angle));
		value[3] = sigma*(sin(X)/X - cos(angle));
	} else {
		value[0] = sin(angle);
		value[1] = cos(angle)/reach;
		value[2] = sigma*reach*(1.0 - cos(angle));
		value[3] = sigma*value[0];
	}
}

/* Sample the closed-form shape, and its exact derivatives in the local frame of the exact
 * profile. */
static void sample(struct hawser_modes *modes, int k, const struct hawser__wave *wave,
                   const struct constants *c)
{
	const struct hawser_statics *st = &modes->statics;
	double *shape = modes->shape + (size_t)k*3*(size_t)modes->grid.points;
	double *slope = modes->slope + (size_t)k*3*(size_t)modes->grid.points;

	for (int i = 0; i < modes->grid.points; i++, shape += 3, slope += 3) {
		double s = modes->grid.s[i], u = st->eta + st->delta*s, v[4];
		double kappa = st->delta/(1.0 + u*u);

		evaluate(v, wave, c, s/c->l - 0.5);
		if (wave->kind == HAWSER__OUT_OF_PLANE) {
			shape[2] = v[0];
			slope[2] = v[1];
		} else {
			int lead = wave->kind == HAWSER__TRANSVERSE;

			shape[lead] = v[0];
			shape[1 - lead] = v[2];
			slope[lead] = v[1];
			slope[1 - lead] = v[3];
			slope[0] -= kappa*shape[1];
			slope[1] += kappa*shape[0];
		}
	}
}

/* Displacements of mode k in the fixed axes of the cable's planes. */
static void unfold(double *X, const struct hawser_modes *modes, const double *field, int k)
{
	int points = modes->grid.points;
	const double *shape = modes->shape + (size_t)k*3*(size_t)points;

	for (int i = 0; i < points; i++, shape += 3)
		if (modes->mode[k].plane == HAWSER_OUT_OF_PLANE) {
			X[i] = shape[2];
		} else {
			X[i] = field[i]*shape[0] - field[points + i]*shape[1];
			X[points + i] = field[points + i]*shape[0] + field[i]*shape[1];
		}
}

/* The smallest of Weinstein's bounds for Phi, A Phi, A A Phi..., with mu their Rayleigh quotients,
 * plus the round-off of A, without which the bound could be 0 for an exact closed form. work
 * [9][points]. */
static double bound(struct hawser_modes *modes, const struct hawser__cable *cable, int k,
                    double *work)
{
	const struct hawser_grid *grid = &modes->grid;
	const struct hawser__plane *plane = &cable->plane[modes->mode[k].plane];
	int values = plane->D*grid->points;
	double *X = work, *Y = work + 2*grid->points, *rest = work + 4*grid->points;
	double omega = modes->mode[k].omega, best = HUGE_VAL, norm, mu, r;

	unfold(X, modes, cable->field, k);
	for (int j = 0; j < APPLICATIONS; j++) {
		norm = sqrt(hawser__compliance_product(X, X, plane->D, grid));
		for (int i = 0; i < values; i++)
			/* unfold() fills `values` numbers */
			/* NOLINTNEXTLINE(clang-analyzer-core.uninitialized.Assign) */
			Y[i] = X[i] /= norm;
		hawser__compliance_apply(Y, rest, omega, plane, grid, &cable->reference,
		                         rest + values);
		mu = hawser__compliance_product(X, Y, plane->D, grid);
		for (int i = 0; i < values; i++)
			rest[i] = Y[i] - mu*X[i];
		r = sqrt(hawser__compliance_product(rest, rest, plane->D, grid));
		best = fmin(best, fmax(sqrt(mu + r) - 1.0, 1.0 - sqrt(fmax(mu - r, 0.0))));
		memcpy(X, Y, (size_t)values*sizeof *X);
	}
	return best + hawser__spectral_round_off(grid->elements);
}

static void fill(struct hawser_modes *modes, int k, const struct hawser__wave *wave,
                 const struct hawser__cable *cable, double *work)
{
	const struct constants c = constants_of(&modes->statics);

	sample(modes, k, wave, &c);
	modes->mode[k].residual = bound(modes, cable, k, work);
}

static const struct hawser__closed_forms at_rest = {1, BOUND_WORK, find, fill};

/* --- common to cables at rest and travelling ones --- */

/* The grid on which closed forms are sampled: elements of degree p, `basis` functions per
 * component, enough to resolve the given number of waves. */
static enum hawser_status choose_grid(int *elements, int *p, int *basis,
                                      const struct hawser_statics *statics,
                                      const struct hawser_modes_options *options, int waves,
                                      struct hawser_report *report)
{
	int n = options->n;

	*elements = hawser__cable_elements(statics);
	*p = options->basis > 0 ? hawser__cable_split(elements, statics, options->basis)
	                        : hawser__cable_degree(*elements, waves);
	*basis = *p**elements - 1;
	if (*basis > FUNCTIONS_MAX)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes",
		                    "shapes of %d functions a component are asked (%d modes), more "
		                    "than the %d that this method samples: lower model.basis, or "
		                    "ask for fewer modes", *basis, n, FUNCTIONS_MAX);
	if (n > 3**basis)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes",
		                    "%d modes asked on a grid that samples %d (%d functions a component): "
		                    "ask for fewer modes, or raise model.basis to %d or more", n,
		                    3**basis, *basis, 2*n);
	return HAWSER_OK;
}

static enum hawser_status check_bounds(const struct hawser_modes *modes,
                                       const struct hawser_modes_options *options,
                                       struct hawser_report *report)
{
	double worst = 0.0;

	for (int k = 0; k < modes->n; k++)
		worst = fmax(worst, modes->mode[k].residual);
	if (options->basis > 0 || worst <= options->tolerance)
		return HAWSER_OK;
	return hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, "modes", 1, worst,
	                       "the closed forms are within a relative error of %.1e of the first %d "
	                       "frequencies, where %.1e was asked: they have no resolution to raise; "
	                       "leave the tolerance away to have them with their error, or take the "
	                       "method spectral", worst, options->n, options->tolerance);
}

/* The n lowest modes, on the grid of the cable, which becomes that of the modes. */
static enum hawser_status sample_all(struct hawser_modes *modes,
                                     const struct hawser__closed_forms *forms,
                                     struct hawser__cable *cable, const struct hawser__wave *wave,
                                     int n, struct hawser_report *report)
{
	size_t points = (size_t)cable->grid.points;
	enum hawser_status status = hawser__modes_allocate(modes, n, cable->grid.points, report);
	double *work = calloc((size_t)forms->work*points, sizeof *work);

	modes->grid = cable->grid;
	if (!work && !status)
		status = hawser__no_memory(report, "modes");
	for (int k = 0; k < n && !status; k++) {
		modes->mode[k].plane = wave[k].kind == HAWSER__OUT_OF_PLANE ? HAWSER_OUT_OF_PLANE
		                                                            : HAWSER_IN_PLANE;
		modes->mode[k].omega = wave[k].omega;
		forms->fill(modes, k, wave + k, cable, work);
	}
	cable->grid = (struct hawser_grid){0};
	free(work);
	return status ? status : hawser__modes_label(modes, report);
}

enum hawser_status hawser__closed_forms_solve(struct hawser_modes *modes,
                                              const struct hawser__closed_forms *forms,
                                              const struct hawser_statics *statics,
                                              const struct hawser_modes_options *options,
                                              struct hawser_report *report)
{
	int n = options->n, elements, p;
	struct hawser__cable cable = {0};
	struct hawser__wave *wave;
	enum hawser_status status;

	status = choose_grid(&elements, &p, &modes->basis, statics, options, forms->wavelengths*n,
	                     report);
	if (status)
		return status;
	wave = malloc(HAWSER__WAVE_KINDS*(size_t)n*sizeof *wave);
	if (!wave)
		return hawser__no_memory(report, "modes");
	forms->find(wave, statics, n);
	qsort(wave, HAWSER__WAVE_KINDS*(size_t)n, sizeof *wave, hawser__ascending);
	status = hawser__cable_init(&cable, statics, elements, p, report);
	if (!status)
		status = sample_all(modes, forms, &cable, wave, n, report);
	if (!status)
		status = check_bounds(modes, options, report);
	hawser__cable_clear(&cable);
	free(wave);
	return status;
}

enum hawser_status hawser__analytic_solve(struct hawser_modes *modes,
                                          const struct hawser_statics *statics,
                                          const struct hawser_modes_options *options,
                                          struct hawser_report *report)
{
	return hawser__closed_forms_solve(modes, &at_rest, statics, options, report);
}
