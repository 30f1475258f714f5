/* modes/complex/gyroscopic_analytic.c - closed forms for a travelling cable of constant tension and
 * curvature.
 *
 *   c, kappa    wave speed (transverse or longitudinal) and curvature at mid-length, as constants
 *   r, p        sqrt(c^2 + nu^2), nu/r: waves run at r + nu with the cable, at r - nu against it
 *   Y           omega r l/c^2: half the difference of the two waves' phases from end to end
 *   q           p Y: half the sum of them
 *   m, y        Y = 2 m pi + y, |y| <= pi
 *   Lambda^2    (kappa l r)^2/(epsilon c^4), transverse; (kappa l r)^2 T/g/c^4, longitudinal
 *   f, h        leading component and the other one in the plane: h' = sigma*kappa*(f - mean of f)
 *
 * B 5.3.3 and 5.3.4 in the variables of the apparent cable, with S in [0, l]
 * (doc/theory-gyroscopic.md). Out of the plane Y = k pi. In the plane
 *
 *   F(Y) = cos pY - cos Y - (1 - p^2)(Y/2)(1 - Y^2/Lambda^2) sin Y = 0,
 *
 * F <= 0 at even multiples of pi and F >= 0 at odd ones, so that each interval between neighbouring
 * multiples from pi on contains a root. Roots are stored as y, which retains its relative accuracy
 * when at a low speed two roots nearly coincide at 2 m pi (y is then of order p^2).
 *
 * The error estimate is Weinstein's bound (complex_mode.c).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <complex.h>
#include <math.h>

#include "modes/analytic.h"
#include "modes/complex/gyroscopic.h"
#include "modes/label.h"

enum { APPLICATIONS = 3 };

struct constants {
	double l, kappa, nu;
	double c2[HAWSER__WAVE_KINDS], r[HAWSER__WAVE_KINDS], p[HAWSER__WAVE_KINDS];
	double Lambda2[HAWSER__WAVE_KINDS];
};

static struct constants constants_of(const struct hawser_statics *st)
{
	double u = st->eta + 0.5*st->delta*st->l, T = hypot(1.0, u);
	struct constants c = {.l = st->l, .kappa = st->delta/(T*T), .nu = st->motion.nu};

	c.c2[HAWSER__OUT_OF_PLANE] = c.c2[HAWSER__TRANSVERSE] = T/(1.0 + st->epsilon*T);
	c.c2[HAWSER__LONGITUDINAL] = 1.0/st->epsilon;
	for (int k = 0; k < HAWSER__WAVE_KINDS; k++) {
		double other = c.c2[k == HAWSER__LONGITUDINAL ? HAWSER__TRANSVERSE : HAWSER__LONGITUDINAL];

		c.r[k] = sqrt(c.c2[k] + c.nu*c.nu);
		c.p[k] = c.nu/c.r[k];
		c.Lambda2[k] = pow(c.kappa*c.l*c.r[k]/c.c2[k], 2.0)*other;
	}
	return c;
}

/* F at Y = 2 m pi + y: cos pY - cos y as a product, which does not cancel. */
static double F(double Y, double y, double p, double Lambda2)
{
	double q = p*Y;

	return -2.0*sin(0.5*(q + y))*sin(0.5*(q - y))
	       - (1.0 - p*p)*0.5*Y*(1.0 - Y*Y/Lambda2)*sin(y);
}

/* The root between k pi and (k + 1) pi, k >= 1: F <= 0 where y = 0, F >= 0 where |y| = pi. */
static struct hawser__wave root(int k, double p, double Lambda2)
{
	int m = (k + 1)/2;
	double side = k%2 ? -1.0 : 1.0, low = 0.0, high = M_PI;

	while (high - low > 1e-16*high && high > 1e-300) {
		double middle = 0.5*(low + high), y = side*middle;

		if (middle <= low || middle >= high)
			break;
		if (F(2.0*m*M_PI + y, y, p, Lambda2) > 0.0)
			high = middle;
		else
			low = middle;
	}
	return (struct hawser__wave){.phase = 2.0*m*M_PI + side*high, .y = side*high};
}

/* The first n of each kind; the first n of all are then among them. */
static void find(struct hawser__wave *wave, const struct hawser_statics *st, int n)
{
	const struct constants c = constants_of(st);

	for (int i = 0; i < HAWSER__WAVE_KINDS*n; i++) {
		enum hawser__wave_kind kind = (enum hawser__wave_kind)(i/n);
		int k = i%n + 1;

		wave[i] = (struct hawser__wave){.phase = k*M_PI};
		if (kind != HAWSER__OUT_OF_PLANE)
			wave[i] = root(k, c.p[kind], c.Lambda2[kind]);
		wave[i].kind = kind;
		wave[i].omega = wave[i].phase*c.c2[kind]/(c.r[kind]*c.l);
	}
}

/* f = a exp(i Y (p+1) t) + b exp(i Y (p-1) t) - d, t = s/l. */
struct form {
	double complex a, b, d;
	double complex up, down; /* i Y (p+1), i Y (p-1): against the travel, and with it */
	double complex mean;
	double sigma;            /* sigma*kappa */
};

static struct form form_of(const struct hawser__wave *wave, const struct constants *c)
{
	double p = c->p[wave->kind], q = p*wave->phase, y = wave->y;
	struct form f = {.up = I*wave->phase*(p + 1.0), .down = I*wave->phase*(p - 1.0)};

	if (wave->kind == HAWSER__OUT_OF_PLANE) { /* sin(Y t) exp(i q t) */
		f.a = -0.5*I;
		f.b = 0.5*I;
		return f;
	}
	f.a = sin(0.5*(y - q))*cexp(-0.5*I*y);
	f.b = sin(0.5*(y + q))*cexp(0.5*I*y);
	f.d = sin(y)*cexp(0.5*I*q);
	f.mean = f.a*(cexp(f.up) - 1.0)/f.up + f.b*(cexp(f.down) - 1.0)/f.down - f.d;
	f.sigma = wave->kind == HAWSER__TRANSVERSE ? c->kappa : -c->kappa;
	return f;
}

/* f, f', h, h' at t. */
static void evaluate(double complex *value, const struct form *f, double l, double t)
{
	double complex up = f->a*cexp(f->up*t), down = f->b*cexp(f->down*t);

	value[0] = up + down - f->d;
	value[1] = (f->up*up + f->down*down)/l;
	value[2] = f->sigma*l*((up - f->a)/f->up + (down - f->b)/f->down - f->d*t - f->mean*t);
	value[3] = f->sigma*(value[0] - f->mean);
}

/* Sample the closed-form shape, and its exact derivatives in the local frame of the exact
 * profile. */
static void sample(struct hawser_modes *modes, int k, const struct hawser__wave *wave,
                   const struct constants *c)
{
	const struct hawser_statics *st = &modes->statics;
	const struct form form = form_of(wave, c);
	int points = modes->grid.points;
	int lead = wave->kind == HAWSER__OUT_OF_PLANE ? 2 : wave->kind == HAWSER__TRANSVERSE;
	double *shape = modes->shape + (size_t)k*6*(size_t)points;
	double *slope = modes->slope + (size_t)k*6*(size_t)points;

	for (int i = 0; i < points; i++, shape += 3, slope += 3) {
		double s = modes->grid.s[i], u = st->eta + st->delta*s;
		double kappa = st->delta/(1.0 + u*u);
		double complex v[4];

		evaluate(v, &form, c->l, s/c->l);
		for (int part = 0; part < 2; part++) {
			double *x = shape + part*3*points, *dx = slope + part*3*points;

			x[lead] = part ? cimag(v[0]) : creal(v[0]);
			dx[lead] = part ? cimag(v[1]) : creal(v[1]);
			if (lead == 2)
				continue;
			x[1 - lead] = part ? cimag(v[2]) : creal(v[2]);
			dx[1 - lead] = part ? cimag(v[3]) : creal(v[3]);
			dx[0] -= kappa*x[1];
			dx[1] += kappa*x[0];
		}
	}
}

static void fill(struct hawser_modes *modes, int k, const struct hawser__wave *wave,
                 const struct hawser__cable *cable, double *work)
{
	const struct constants c = constants_of(&modes->statics);
	struct hawser_mode *mode = modes->mode + k;
	size_t first = (size_t)k*hawser__modes_row(modes);
	struct hawser__complex iterate;

	sample(modes, k, wave, &c);
	hawser__complex_init(&iterate, cable, mode->plane, c.nu, work);
	hawser__complex_load(&iterate, modes->shape + first, modes->slope + first);
	iterate.omega = mode->omega;
	mode->residual = hawser__complex_bound(&iterate, APPLICATIONS);
	hawser__complex_step(&iterate);
	mode->condition = iterate.condition;
}

/* The upstream wave has up to twice the wavenumber of the mode at rest. */
static const struct hawser__closed_forms travelling = {2, HAWSER__COMPLEX_WORK, find, fill};

enum hawser_status hawser__gyroscopic_analytic(struct hawser_modes *modes,
                                               const struct hawser_statics *statics,
                                               const struct hawser_modes_options *options,
                                               struct hawser_report *report)
{
	if (statics->motion.nu == 0.0)
		return hawser__gyroscopic_at_rest(modes, statics, options, "analytic", report);
	return hawser__closed_forms_solve(modes, &travelling, statics, options, report);
}
