/* net/motion/motion-law.c - forces, tangents and the energy ledger of a step; see net/motion/motion.h.
 *
 * S, L    d0 + d1 and l0 + l1 of an element
 * g       S/L: the work of a force sigma*g over the step is sigma*(l1 - l0)
 *
 * Kelvin-Voigt damping adds c*(p1 - p0)/h to sigma, in all schemes; what pushes is cut off, since
 * a cable cannot. Both only dissipate.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <float.h>
#include <math.h>
#include <string.h>

#include "core/hot.h"
#include "core/vec3.h"
#include "net/motion/motion-events.h"

/* Of a force, what its round-off is as a part of the residual's scale, whose tolerance is 5000 ulps. */
static const double ROUND = 1e-3;
enum { CREEPS = 20 }; /* iterations of a law of straight pieces: 2 where nothing gets slack or taut */

static inline double smaller(double a, double b)
{
	return a < b ? a : b;
}

/* What the mass of an element makes of the vectors at its ends. */
static inline double square(const struct hawser__motion *motion, const double a[3], const double b[3])
{
	return (0.5 - motion->far)*(hawser__dot(a, a) + hawser__dot(b, b)) +
	       2.0*motion->far*hawser__dot(a, b);
}

/* Length and signed stretch of an element whose vector is D + delta. */
static inline double stretch(double *p, const struct hawser__motion_element *el,
                             const double delta[3], const double d[3])
{
	double l = sqrt(hawser__dot(d, d)), sum = l + el->l_ref, more = 0.0;

	HAWSER_UNROLL
	for (int k = 0; k < 3; k++)
		more += (el->D[k] + d[k])*delta[k];
	*p = el->p_ref - el->lag + (sum > 0.0 ? more/sum : 0.0);
	return l;
}

/* What an element does in the step: a force on its end b of gradient*g + end*e1, and their
 * derivatives by l1. dl = l1 - l0. */
struct forces {
	double gradient, slope, end, end_slope, dl;
};

/* sigma = (W1 - W0)/(l1 - l0), without its cancellation. */
static void discrete(struct forces *f, const struct hawser__motion_element *el)
{
	double p0 = el->p, p1 = el->p1, k = el->k;

	if (el->law) {
		f->gradient = hawser__table_mean(&f->slope, el, p0, p1);
	} else if (p0 > 0.0 && p1 > 0.0) {
		f->gradient = 0.5*k*(p0 + p1);
		f->slope = 0.5*k;
	} else if (p1 > 0.0) { /* l1 - l0 >= p1 */
		double ratio = smaller(p1/f->dl, 1.0);

		f->gradient = 0.5*k*p1*ratio;
		f->slope = k*ratio*(1.0 - 0.5*ratio);
	} else if (p0 > 0.0) {
		double ratio = smaller(-p0/f->dl, 1.0);

		f->gradient = 0.5*k*p0*ratio;
		f->slope = 0.5*k*ratio*ratio;
	}
}

void hawser__motion_in_line(struct hawser__motion_element *el, const struct hawser_net_cable *cable,
                            double L0, double T)
{
	if (!cable || !(cable->dynamic > 0.0))
		return;
	el->k = cable->dynamic/L0;
	el->creep = cable->EA*el->k/(cable->dynamic - cable->EA);
	el->loss = cable->viscosity/L0;
	el->rest = T/el->creep;
	el->p_ref -= el->rest;
}

/* In line with a spring beside a dashpot, which take the mean tension of the step: loss*d/h +
 * creep*(mean of its stretch), d the change of its stretch. Both sides are monotone in d. */
static void creep(struct forces *f, struct hawser__motion_element *el, double h)
{
	const double own = el->loss/h + 0.5*el->creep, p1 = el->p1, dl = f->dl, rest = el->rest + el->lag;
	double d = 0.0, step = INFINITY;

	for (int i = 0; i < CREEPS && fabs(step) > DBL_EPSILON*fabs(p1 - el->p); i++) {
		el->p1 = p1 - d;
		f->dl = dl - d;
		f->gradient = f->slope = 0.0;
		discrete(f, el);
		step = (f->gradient - el->creep*rest - own*d)/(own + f->slope);
		d += step;
	}
	el->p1 = p1 - d;
	el->lag1 = el->lag + d;
	f->slope *= own/(own + f->slope);
}

static inline void forces(struct forces *f, struct hawser__motion_element *el,
                          const struct hawser__motion_rule *rule, double h)
{
	f->gradient = f->slope = f->end = f->end_slope = 0.0;
	el->lag1 = el->lag;
	if (rule->weight < 0.0) {
		if (el->creep > 0.0)
			creep(f, el, h);
		else
			discrete(f, el);
	} else if (el->p1 > 0.0) {
		f->end = rule->weight*el->k*el->p1;
		f->end_slope = rule->weight*el->k;
	}
	if (el->c > 0.0 && (el->p > el->zero || el->p1 > el->zero)) {
		double rate = (hawser__larger(el->p1, el->zero) - hawser__larger(el->p, el->zero))/h;
		double whole = f->gradient + f->end + el->c*rate;

		if (whole < 0.0) {
			f->gradient = -f->end;
			f->slope = -f->end_slope;
		} else {
			f->gradient += el->c*rate;
			f->slope += el->p1 > el->zero ? el->c/h : 0.0;
		}
	}
}

/* Vector, length and stretch of an element at the end of the step. Over all elements before anything
 * else: roots and divisions of several elements are then under way at once. */
static inline void move(struct hawser__motion_element *el, const double *xa, const double *xb)
{
	double delta[3], d1[3], sum;

	HAWSER_UNROLL
	for (int k = 0; k < 3; k++) {
		delta[k] = el->delta[k] + (xb[k] - xa[k]);
		d1[k] = el->D[k] + delta[k];
	}
	memcpy(el->d1, d1, sizeof d1);
	el->l1 = stretch(&el->p1, el, delta, d1);
	sum = el->l + el->l1;
	el->inverse = sum > 0.0 ? 1.0/sum : 0.0;
	el->inverse1 = el->l1 > 0.0 ? 1.0/el->l1 : 0.0;
}

static inline void block(double B[9], const struct hawser__motion_element *el, const struct forces *f,
                         const double g[3], const double e1[3])
{
	double middle = f->gradient*el->inverse, last = f->end*el->inverse1, round = middle + last;
	double skew = f->slope - middle, along = f->end_slope - last;

	HAWSER_UNROLL
	for (int i = 0; i < 3; i++) {
		HAWSER_UNROLL
		for (int j = 0; j < 3; j++)
			B[3*i + j] = (skew*g[i] + along*e1[i])*e1[j];
		B[4*i] += round;
	}
}

static inline double element(struct hawser__motion *motion, int number,
                             const struct hawser__motion_rule *rule, double h, int tangent)
{
	struct hawser__motion_element *el = &motion->element[number];
	const double *xa = motion->x[el->a], *xb = motion->x[el->b];
	const double *ya = motion->acc[el->a], *yb = motion->acc[el->b];
	const double *wa = motion->vel[el->a], *wb = motion->vel[el->b];
	double g[3], e1[3], most, *ra = motion->r[el->a], *rb = motion->r[el->b];
	const double far = motion->far, near = 0.5 - far, part = rule->weight < 0.0 ? 1.0 : rule->weight;
	struct forces f;

	HAWSER_UNROLL
	for (int k = 0; k < 3; k++) {
		g[k] = (el->d[k] + el->d1[k])*el->inverse;
		e1[k] = el->d1[k]*el->inverse1;
	}
	f.dl = g[0]*(xb[0] - xa[0]) + g[1]*(xb[1] - xa[1]) + g[2]*(xb[2] - xa[2]);
	forces(&f, el, rule, h);
	el->T1 = f.gradient + f.end;
	most = fabs(el->T1);
	HAWSER_UNROLL
	for (int k = 0; k < 3; k++) {
		double F = f.gradient*g[k] + f.end*e1[k] - part*el->F_ref[k];
		double a = el->m*ya[k] + el->drag*wa[k], b = el->m*yb[k] + el->drag*wb[k];

		ra[k] += near*a + far*b - F;
		rb[k] += near*b + far*a + F;
		most = hawser__larger(fabs(F) + fabs(a) + fabs(b), most);
	}
	if (tangent) {
		block(motion->B[number], el, &f, g, e1);
		if (motion->other)
			memcpy(motion->other[number], motion->B[number], sizeof *motion->other);
		motion->mass[number][0] = (rule->m[0]*el->m + rule->c[0]*el->drag)*(0.5 - motion->far);
		motion->mass[number][1] = (rule->m[0]*el->m + rule->c[0]*el->drag)*motion->far;
	}
	return most;
}

void hawser__motion_residual(struct hawser__motion *motion, const struct hawser__motion_rule *rule,
                             double h, int tangent)
{
	double most = 0.0;

	for (int i = 0; i < motion->nodes; i++) {
		const int *free = motion->mesh->unknown[i];

		HAWSER_UNROLL
		for (int k = 0; k < 3; k++) {
			double x = motion->x[i][k], v = motion->v0[i][k], a = motion->a0[i][k];

			motion->acc[i][k] = free[k] < 0 ? (motion->v[i][k] - v)/h
				: rule->m[0]*x + rule->m[1]*v + rule->m[2]*a;
			motion->vel[i][k] = free[k] < 0 && rule->weight < 0.0 ? x/h
				: rule->c[0]*x + rule->c[1]*v + rule->c[2]*a;
			motion->r[i][k] = motion->mesh->mass[i]*motion->acc[i][k] - motion->load[i][k];
		}
		/* nothing may hold a body whose cable has parted, or that falls on an obstacle */
		for (int k = 0; k < 3; k++)
			if (motion->events || motion->bodies || (motion->contact && free[k] >= 0))
				most = hawser__larger(most, fabs(motion->load[i][k]));
		if (tangent)
			motion->point[i] = rule->m[0]*motion->mesh->mass[i];
	}
	for (int e = 0; e < motion->elements; e++)
		move(&motion->element[e], motion->x[motion->element[e].a], motion->x[motion->element[e].b]);
	for (int e = 0; e < motion->elements; e++)
		most = hawser__larger(element(motion, e, rule, h, tangent), most);
	if (motion->block && tangent)
		memset(motion->block, 0, (size_t)motion->nodes*sizeof *motion->block);
	if (motion->attached)
		most = hawser__larger(hawser__attached_residual(motion, rule, tangent), most);
	if (motion->bed)
		most = hawser__larger(hawser__bed_residual(motion, rule, h, tangent), most);
	if (motion->water)
		most = hawser__larger(hawser__water_residual(motion, rule, tangent), most);
	/* a rate is the difference of two stretches over h, with the round-off of displacements */
	motion->scale = hawser__larger(most, ROUND*motion->damps/h*motion->reach);
}

/* Force of the beginning of the step, of the part 1 - weight, added to the load. */
static void beginning(struct hawser__motion *motion, double part)
{
	for (int e = 0; e < motion->elements; e++) {
		const struct hawser__motion_element *el = &motion->element[e];
		double T = el->l > 0.0 ? hawser__elastic_tension(el, el->p)/el->l : 0.0;

		for (int k = 0; k < 3; k++) {
			double F = part*(T*el->d[k] - el->F_ref[k]);

			motion->load[el->a][k] += F;
			motion->load[el->b][k] -= F;
		}
	}
}

void hawser__motion_prepare(struct hawser__motion *motion, const struct hawser__motion_rule *rule,
                            double h)
{
	size_t size = (size_t)motion->nodes*sizeof *motion->wave;

	for (int e = 0; e < motion->elements; e++) {
		struct hawser__motion_element *el = &motion->element[e];

		for (int k = 0; k < 3; k++) {
			el->delta[k] = motion->u0[el->b][k] - motion->u0[el->a][k];
			el->d[k] = el->D[k] + el->delta[k];
		}
		el->l = stretch(&el->p, el, el->delta, el->d);
	}
	motion->reach = 0.0;
	for (int i = 0; i < motion->nodes && motion->damps > 0.0; i++)
		for (int k = 0; k < 3; k++)
			motion->reach = fmax(motion->reach, fabs(motion->u0[i][k]));
	memset(motion->wave, 0, size);
	if (rule->weight < 0.0) {
		hawser__motion_waves(motion->wave, motion->mesh, motion->t + h/2.0, 1.0);
	} else {
		hawser__motion_waves(motion->wave, motion->mesh, motion->t + h, rule->weight);
		hawser__motion_waves(motion->wave, motion->mesh, motion->t, 1.0 - rule->weight);
	}
	for (int i = 0; i < motion->nodes; i++)
		for (int k = 0; k < 3; k++)
			motion->load[i][k] = motion->base[i][k] + motion->wave[i][k];
	if (rule->weight >= 0.0 && rule->weight < 1.0)
		beginning(motion, 1.0 - rule->weight);
	if (motion->water)
		hawser__water_prepare(motion, rule, h);
	if (motion->bed)
		hawser__bed_prepare(motion);
}

/* Strain energy beyond the reference's, less the work of the reference's force: with s = l -
 * l_ref both taut it is k*s^2/2 + k*p_ref*(delta^2 - s^2)/(2*l_ref), without cancellation. */
static double strain_of(const struct hawser__motion_element *el, double p, const double delta[3])
{
	double rest = hawser__larger(el->p_ref, 0.0), s = p - el->p_ref, all = s + el->lag;

	if (el->law) {
		double slope, T = hawser__table_tension(el, el->p_ref);

		return (hawser__table_mean(&slope, el, el->p_ref, p) - T)*s +
		       (T > 0.0 ? 0.5*T*(hawser__dot(delta, delta) - s*s)/el->l_ref : 0.0);
	}
	if (p > 0.0 && rest > 0.0)
		return 0.5*el->k*(s*s + rest*(hawser__dot(delta, delta) - all*all)/el->l_ref) +
		       0.5*el->creep*el->lag*el->lag;
	p = hawser__larger(p, 0.0);
	return 0.5*el->k*(p - rest)*(p + rest) + el->creep*el->lag*(el->rest + 0.5*el->lag) -
	       hawser__dot(el->F_ref, delta);
}

void hawser__motion_energies(struct hawser__motion *motion)
{
	double kinetic = 0.0, strain = 0.0, loads = 0.0;

	for (int e = 0; e < motion->elements; e++) {
		const struct hawser__motion_element *el = &motion->element[e];
		const double *va = motion->v[el->a], *vb = motion->v[el->b];
		double delta[3], d[3], p;

		for (int k = 0; k < 3; k++) {
			delta[k] = motion->u[el->b][k] - motion->u[el->a][k];
			d[k] = el->D[k] + delta[k];
		}
		(void)stretch(&p, el, delta, d);
		kinetic += 0.5*el->m*square(motion, va, vb);
		strain += strain_of(el, p, delta);
	}
	for (int i = 0; i < motion->nodes; i++) {
		kinetic += 0.5*motion->mesh->mass[i]*hawser__dot(motion->v[i], motion->v[i]);
		loads += hawser__dot(motion->base[i], motion->u[i]);
	}
	if (motion->attached)
		hawser__attached_energies(&kinetic, &strain, motion);
	strain += motion->bed ? hawser__bed_energy(motion) : 0.0;
	motion->added = motion->water ? hawser__water_kinetic(motion) : 0.0;
	motion->energy.kinetic = kinetic + motion->added;
	motion->energy.potential = strain - loads + (motion->events ? motion->events->offset : 0.0);
}

/* The mass of a support gets its momentum at the mean of its velocities, which is not its mean
 * velocity: what this adds to the work of r over the increment. */
static double inertia(const struct hawser__motion *motion, double h)
{
	double work = 0.0;

	for (int i = 0; i < motion->nodes; i++)
		for (int k = 0; k < 3; k++)
			if (motion->mesh->unknown[i][k] < 0)
				work += motion->mesh->mass[i]*motion->acc[i][k]*
				        (0.5*h*(motion->v0[i][k] + motion->v[i][k]) - motion->x[i][k]);
	for (int e = 0; e < motion->elements; e++) {
		const struct hawser__motion_element *el = &motion->element[e];
		const int end[2] = {el->a, el->b};

		for (int side = 0; side < 2; side++)
			for (int k = 0; k < 3; k++) {
				int i = end[side], j = end[!side];

				if (motion->mesh->unknown[i][k] >= 0)
					continue;
				work += el->m*((0.5 - motion->far)*motion->acc[i][k] + motion->far*motion->acc[j][k])*
				        (0.5*h*(motion->v0[i][k] + motion->v[i][k]) - motion->x[i][k]);
			}
	}
	return work;
}

void hawser__motion_account(struct hawser__motion *motion, const struct hawser__motion_rule *rule,
                            double h)
{
	double work = 0.0, lost = 0.0;

	for (int e = 0; e < motion->elements; e++) {
		struct hawser__motion_element *el = &motion->element[e];
		const double *xa = motion->x[el->a], *xb = motion->x[el->b];
		double p0 = hawser__larger(el->p, el->zero), p1 = hawser__larger(el->p1, el->zero);
		double dl = el->p1 - el->p, T = 0.0, slope;

		lost += el->drag/h*square(motion, xa, xb);
		if (el->c > 0.0 && (p0 > el->zero || p1 > el->zero)) {
			T = el->law ? (el->T1 - hawser__table_mean(&slope, el, el->p, el->p1))*dl
				: rule->weight < 0.0 ? el->T1*dl - 0.5*el->k*(p1 - p0)*(p1 + p0)
				                     : el->c*(p1 - p0)*dl/h;
			lost += T;
		}
		lost += el->loss/h*(el->lag1 - el->lag)*(el->lag1 - el->lag);
		el->lag = el->lag1;
	}
	for (int i = 0; i < motion->nodes; i++)
		for (int k = 0; k < 3; k++) {
			double x = motion->x[i][k];

			work += motion->wave[i][k]*x;
			if (motion->mesh->unknown[i][k] < 0) /* r: what the support adds, with the mass */
				work += motion->r[i][k]*x;
		}
	if (motion->tables || motion->mesh->motions)
		work += inertia(motion, h);
	motion->energy.work += work;
	motion->energy.dissipated += lost + (motion->attached ? hawser__attached_loss(motion, h) : 0.0);
	if (motion->bed)
		hawser__bed_account(motion, h);
	if (motion->water)
		hawser__water_account(motion, h);
	hawser__motion_balance(motion);
}

void hawser__motion_balance(struct hawser__motion *motion)
{
	const struct hawser__motion_energy *energy = &motion->energy;
	double error, most, before = motion->added;

	hawser__motion_energies(motion);
	motion->energy.work += motion->added - before; /* with its inertia in the forces of the water */
	error = energy->kinetic + energy->potential - motion->start_energy - energy->work +
	        energy->dissipated;
	most = fmax(fmax(energy->kinetic, fabs(energy->potential - motion->start_energy)),
	            fmax(fabs(energy->work), energy->dissipated));
	motion->most_energy = fmax(motion->most_energy, most);
	motion->closure = fmax(motion->closure, fabs(error));
}

int hawser__motion_tensions(double *T, const struct hawser__motion *motion)
{
	int slack = 0;

	for (int e = 0; e < motion->elements; e++) {
		const struct hawser__motion_element *el = &motion->element[e];
		double delta[3], d[3], p;

		for (int k = 0; k < 3; k++) {
			delta[k] = motion->u[el->b][k] - motion->u[el->a][k];
			d[k] = el->D[k] + delta[k];
		}
		(void)stretch(&p, el, delta, d);
		T[e] = hawser__motion_tension(motion, e, d, p);
		slack += !el->rod && (p < el->zero || (p > el->zero && T[e] == 0.0));
	}
	return slack;
}
