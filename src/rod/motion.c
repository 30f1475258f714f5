/* rod/motion.c - generalised-alpha on R^3 x SO(3) (motion.h).
 *
 * Bruels, Cardona (2010), Arnold, Bruels (2007): with the velocities u (v and spin), their rates u' and
 * the scheme's own rates a, in a step of length h,
 *   (1 - am) a1 + am a0 = (1 - af) u1' + af u0'
 *   d = h u0 + h^2 ((1/2 - b) a0 + b a1),  u1 = u0 + h ((1 - g) a0 + g a1)
 *   x1 = x0 + d_x,  R1 = R0 exp(d_turn),  and at its end: inertia(u1', u1) = forces
 *   am = (2 rho - 1)/(rho + 1), af = rho/(rho + 1), g = 1/2 + af - am, b = (1/2 + g)^2/4.
 * The rotation is an increment in the step, so that nothing is singular after any number of turns.
 * Order 2 for any rho; Newmark's method with damping (g > 1/2 alone) has order 1. a is that at the time
 * am - af steps later, and a step of another length begins with a as far off as its own.
 *
 * Unknowns of Newton's method are moves and turns of the state: d_turn changes by Ji(d_turn) times
 * the turn, so that only the blocks of inertia get Ji, and the matrix of the elements none.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "rod/motion.h"
#include "rod/so3.h"

enum {
	ITERATIONS = 12, /* of a step: those that converge take 2 to 5 */
	SPLITS = 10      /* a step that has no solution is made in 2^SPLITS parts at most */
};
#define TOLERANCE 1e-11 /* lengths of the rod and rad: what an increment of Newton's method may leave */
#define NEAR 1e-8       /* increments that are smaller and do not fall are round-off */
#define SLOW 0.2        /* the matrix is made anew if increments fall by less */
#define SQUARE 30.0     /* an increment with a new matrix leaves at most this times its square */
#define SPUN 2.0        /* rad, of a node in a step: Ji is singular at 2 pi */
#define GROW 2.0        /* of a step's length, at most */
#define SHRINK 0.2      /* at least */
#define SAFETY 0.8      /* steps are so much shorter than their errors would let them be */
#define STEADY 1.2      /* a step that may be longer by less is kept, and the factors with it */
#define SHORTEST 1e-9   /* of the time: steps that are not made shorter for their error */

struct scheme {
	double am, af, g, b, c; /* c: of the local error, c h^3 x''' */
};

/* c: x = (1 + 2 c h^2 D^2) times the exact one, by series of the scheme's difference operators. */
static struct scheme scheme_of(double rho)
{
	struct scheme s = {.am = (2.0*rho - 1.0)/(rho + 1.0), .af = rho/(rho + 1.0)};
	double v;

	s.g = 0.5 + s.af - s.am;
	s.b = 0.25*(0.5 + s.g)*(0.5 + s.g);
	v = 0.5*s.g*(1.0 - s.g) - 1.0/24.0 + 0.5*(s.af*(1.0 - s.af) - s.am*(1.0 - s.am));
	s.c = 0.5*fabs(v + s.b + 1.0/12.0 - 0.5*s.g);
	return s;
}

/* --- memory --- */

enum hawser_status hawser__rod_motion_open(struct hawser__rod_motion *motion,
                                           struct hawser__rod_mesh *mesh,
                                           struct hawser_report *report)
{
	size_t nodes = (size_t)mesh->nodes;
	double (**const six[])[6] = {
		&motion->velocity, &motion->rate, &motion->mean, &motion->step, &motion->past, &motion->past2,
		&motion->velocity0, &motion->rate0, &motion->mean0, &motion->applied, &motion->applied0,
		&motion->pushed, &motion->pushed0, &motion->reaction, &motion->reaction0};
	int good = 1;

	memset(motion, 0, sizeof *motion);
	motion->mesh = mesh;
	motion->rho_inf = mesh->rod->rho_inf >= 0.0 ? mesh->rod->rho_inf : 0.8;
	motion->alpha = mesh->rod->alpha;
	for (size_t i = 0; i < sizeof six/sizeof *six; i++)
		good = (*six[i] = calloc(nodes, sizeof **six[i])) != NULL && good;
	motion->mass = calloc(nodes, sizeof *motion->mass);
	motion->factor = calloc((size_t)mesh->rod->loads + 1, sizeof *motion->factor);
	motion->node0 = calloc(nodes, sizeof *motion->node0);
	motion->Ji = calloc(nodes, sizeof *motion->Ji);
	if (!good || !motion->mass || !motion->factor || !motion->node0 || !motion->Ji) {
		hawser__rod_motion_clear(motion);
		return hawser__no_memory(report, "rod");
	}
	for (int e = 0; e < mesh->elements; e++) {
		const struct hawser_rod_segment *of = &mesh->rod->segment[mesh->segment[e]];

		for (int k = 0; k < 2; k++)
			for (int j = 0; j < 4; j++)
				motion->mass[e + k][j] += 0.5*mesh->element[e].h*(j ? of->inertia[j - 1] : of->rho);
	}
	return HAWSER_OK;
}

void hawser__rod_motion_clear(struct hawser__rod_motion *motion)
{
	double (*six[])[6] = {
		motion->velocity, motion->rate, motion->mean, motion->step, motion->past, motion->past2,
		motion->velocity0, motion->rate0, motion->mean0, motion->applied, motion->applied0,
		motion->pushed, motion->pushed0, motion->reaction, motion->reaction0};

	for (size_t i = 0; i < sizeof six/sizeof *six; i++)
		free(six[i]);
	free(motion->mass);
	free(motion->factor);
	free(motion->node0);
	free(motion->Ji);
	memset(motion, 0, sizeof *motion);
}

static enum hawser_status undefined(const struct hawser__rod_motion *motion,
                                    struct hawser_report *report)
{
	return hawser__fail(report, HAWSER_ERR_NAN, "rod", "at %.9g s the forces are not finite: a "
	                    "load, a motion or a stiffness is out of range", motion->t);
}

enum hawser_status hawser__rod_motion_begin(struct hawser__rod_motion *motion, int first,
                                            struct hawser_report *report)
{
	struct hawser__rod_mesh *mesh = motion->mesh;
	double sum = 0.0;

	motion->past_h = motion->past2_h = motion->factor_h = 0.0;
	hawser__rod_motion_factors(motion, motion->t, 1);
	hawser__rod_motion_hold(motion, motion->t);
	if (hawser__rod_motion_rates(motion, motion->t))
		return motion->bent >= 0
			? hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "rod", "at %.9g s the element from %.6g m "
			               "to %.6g m turns by pi or more: give more elements", motion->t,
			               mesh->s[motion->bent], mesh->s[motion->bent + 1])
			: hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "rod", "at %.9g s the motion is not "
			               "determined: a node has no mass or no inertia, or a load refuses",
			               motion->t);
	for (int i = 0; i < mesh->nodes; i++)
		for (int k = 0; k < HAWSER__ROD_FREE; k++)
			sum += fabs(motion->rate[i][k]) + fabs(motion->velocity[i][k]);
	if (!isfinite(sum))
		return undefined(motion, report);
	memcpy(motion->mean, motion->rate, (size_t)mesh->nodes*sizeof *motion->mean);
	if (!first)
		return HAWSER_OK;
	motion->energy = (struct hawser__rod_energy){0};
	memset(&motion->momentum, 0, sizeof motion->momentum);
	motion->energy_lost = motion->momentum_gap = motion->angular_gap = motion->most_momentum =
	                      motion->most_angular = motion->most_energy = 0.0;
	hawser__rod_motion_sum(motion);
	motion->start_energy = motion->energy.kinetic + motion->energy.strain + motion->energy.height;
	memcpy(motion->start, motion->momentum.linear, 3*sizeof *motion->start);
	memcpy(motion->start + 3, motion->momentum.angular, 3*sizeof *motion->start);
	return HAWSER_OK;
}

/* --- a step --- */

/* The state, from the increments of the step. Returns 1 if a node turns too far. */
static int place(struct hawser__rod_motion *motion, const struct scheme *s, double h)
{
	struct hawser__rod_mesh *mesh = motion->mesh;

	motion->spun = -1;
	for (int i = 0; i < mesh->nodes; i++) {
		struct hawser__rod_node *node = &mesh->node[i];
		const double *d = motion->step[i];

		*node = motion->node0[i];
		for (int k = 0; k < 3; k++)
			node->x[k] += d[k];
		hawser__quaternion_turn(node->q, d + 3);
		if (!(hawser__dot(d + 3, d + 3) < SPUN*SPUN))
			motion->spun = i;
		for (int k = 0; k < HAWSER__ROD_FREE; k++) {
			double u = motion->velocity0[i][k], a = motion->mean0[i][k];
			double a1 = (d[k] - h*u - h*h*(0.5 - s->b)*a)/(s->b*h*h);

			motion->mean[i][k] = a1;
			motion->velocity[i][k] = u + h*((1.0 - s->g)*a + s->g*a1);
			motion->rate[i][k] = ((1.0 - s->am)*a1 + s->am*a - s->af*motion->rate0[i][k])/
			                     (1.0 - s->af);
		}
	}
	hawser__rod_motion_hold(motion, motion->t + h);
	return motion->spun >= 0;
}

/* Increments of held ends, as they have moved; their mean rates are the rates. */
static void held_steps(struct hawser__rod_motion *motion)
{
	struct hawser__rod_mesh *mesh = motion->mesh;

	for (int end = 0; end < 2; end++) {
		int i = end ? mesh->nodes - 1 : 0;
		const unsigned char *held = mesh->held + (long)HAWSER__ROD_FREE*i;
		double by[6], between[4];

		for (int k = 0; k < 3; k++)
			by[k] = mesh->node[i].x[k] - motion->node0[i].x[k];
		hawser__quaternion_between(between, motion->node0[i].q, mesh->node[i].q);
		(void)hawser__quaternion_log(by + 3, between);
		for (int k = 0; k < HAWSER__ROD_FREE; k++)
			if (held[k]) {
				motion->step[i][k] = by[k];
				motion->mean[i][k] = motion->rate[i][k];
			}
	}
}

/* First increments: the polynomial through the places of the last steps, with the velocity; an
 * extrapolation of rates would excite what is stiff. */
static void predict(struct hawser__rod_motion *motion, double h)
{
	double h1 = motion->past_h, all = h1 + motion->past2_h;

	for (int i = 0; i < motion->mesh->nodes; i++)
		for (int k = 0; k < HAWSER__ROD_FREE; k++) {
			double u = motion->velocity0[i][k], square = 0.5*motion->rate0[i][k], cube = 0.0, near, far;

			if (h1 > 0.0)
				square = near = (u*h1 - motion->past[i][k])/(h1*h1);
			if (h1 > 0.0 && motion->past2_h > 0.0) {
				far = (u*all - motion->past[i][k] - motion->past2[i][k])/(all*all);
				cube = (near - far)/motion->past2_h;
				square = near + cube*h1;
			}
			motion->step[i][k] = motion->mesh->held[HAWSER__ROD_FREE*i + k]
				? 0.0 : h*(u + h*(square + h*cube));
		}
}

/* Add the solution to the increments; returns the largest, in lengths of the rod and rad. */
static double correct(struct hawser__rod_motion *motion)
{
	const struct hawser__rod_mesh *mesh = motion->mesh;
	double most = 0.0;

	for (int i = 0; i < mesh->n; i++)
		if (mesh->held[i])
			mesh->r[i] = 0.0; /* round-off of the factors */
	for (int i = 0; i < mesh->nodes; i++) {
		const double *by = mesh->r + (long)HAWSER__ROD_FREE*i;
		double turn[3], size = sqrt(hawser__dot(by, by))/mesh->rod->length +
		                       sqrt(hawser__dot(by + 3, by + 3));

		if (!isfinite(size))
			return INFINITY;
		most = fmax(most, size);
		hawser__apply(turn, motion->Ji[i], by + 3);
		for (int k = 0; k < 3; k++) {
			motion->step[i][k] += by[k];
			motion->step[i][3 + k] += turn[k];
		}
	}
	return most;
}

/* Factors of the matrix; 1: it is singular. mesh->r is not solved for yet. */
static int factor(struct hawser__rod_motion *motion, double h)
{
	struct hawser__rod_mesh *mesh = motion->mesh;

	for (int i = 0; i < mesh->n; i++)
		if (mesh->held[i])
			(void)hawser__band_hold(&mesh->band, i);
	motion->factored++;
	motion->contraction = 1.0; /* not known */
	motion->factor_h = h;
	return hawser__band_factor(&mesh->band);
}

static void turns(struct hawser__rod_motion *motion)
{
	for (int i = 0; i < motion->mesh->nodes; i++) {
		struct hawser__so3 at;

		hawser__so3_at(&at, motion->step[i] + 3);
		hawser__so3_ji(motion->Ji[i], &at);
	}
}

/* Newton's method for the increments; 1: it has converged. The matrix is that of an earlier step as
 * long as increments fall quickly with it. */
static int newton(struct hawser__rod_motion *motion, const struct scheme *s, double h)
{
	struct hawser__rod_mesh *mesh = motion->mesh;
	double last = INFINITY, left;
	int anew = motion->factor_h != h;

	motion->by_place = 1.0;
	motion->to_velocity = s->g/(s->b*h);
	motion->to_rate = (1.0 - s->am)/(s->b*h*h*(1.0 - s->af));
	motion->undefined = 0;
	for (int i = 0; i < ITERATIONS; i++) {
		double size, ratio;

		if (place(motion, s, h))
			return 0;
		if (i == 0)
			held_steps(motion);
		turns(motion);
		if (hawser__rod_motion_form(motion, motion->t + h, anew))
			return 0;
		if (anew && factor(motion, h))
			return 0;
		hawser__band_solve(&mesh->band, mesh->r);
		size = correct(motion);
		motion->iterations++;
		motion->increment = size;
		motion->undefined = !isfinite(size);
		if (motion->undefined)
			return 0;
		ratio = i > 0 ? size/last : anew ? 1.0 : motion->contraction;
		if (i > 0)
			motion->contraction = fmax(0.3*motion->contraction, ratio);
		left = anew ? fmin(SQUARE*size*size, size) : ratio < 1.0 ? size*ratio/(1.0 - ratio) : size;
		if (left <= TOLERANCE || (i > 0 && size < NEAR && ratio > 0.5))
			return !place(motion, s, h);
		anew = i > 0 && ratio > SLOW;
		last = size;
	}
	return 0;
}

static void keep(struct hawser__rod_motion *motion, double h)
{
	size_t nodes = (size_t)motion->mesh->nodes;
	double part = motion->past_h > 0.0 ? h/motion->past_h : 1.0;

	memcpy(motion->node0, motion->mesh->node, nodes*sizeof *motion->node0);
	memcpy(motion->velocity0, motion->velocity, nodes*sizeof *motion->velocity);
	memcpy(motion->rate0, motion->rate, nodes*sizeof *motion->rate);
	memcpy(motion->applied0, motion->applied, nodes*sizeof *motion->applied);
	memcpy(motion->pushed0, motion->pushed, nodes*sizeof *motion->pushed);
	memcpy(motion->reaction0, motion->reaction, nodes*sizeof *motion->reaction);
	memcpy(motion->mean0, motion->mean, nodes*sizeof *motion->mean);
	if (part != 1.0)
		for (size_t i = 0; i < nodes; i++)
			for (int k = 0; k < HAWSER__ROD_FREE; k++)
				motion->mean0[i][k] = motion->rate[i][k] +
				                      part*(motion->mean[i][k] - motion->rate[i][k]);
}

/* The state as before the step; its mean rates belong to a step of the last length again. */
static void restore(struct hawser__rod_motion *motion, double h)
{
	size_t nodes = (size_t)motion->mesh->nodes;
	double part = motion->past_h > 0.0 ? motion->past_h/h : 1.0;

	memcpy(motion->mesh->node, motion->node0, nodes*sizeof *motion->node0);
	memcpy(motion->velocity, motion->velocity0, nodes*sizeof *motion->velocity);
	memcpy(motion->rate, motion->rate0, nodes*sizeof *motion->rate);
	memcpy(motion->applied, motion->applied0, nodes*sizeof *motion->applied);
	memcpy(motion->pushed, motion->pushed0, nodes*sizeof *motion->pushed);
	memcpy(motion->reaction, motion->reaction0, nodes*sizeof *motion->reaction);
	for (size_t i = 0; i < nodes; i++)
		for (int k = 0; k < HAWSER__ROD_FREE; k++)
			motion->mean[i][k] = motion->rate0[i][k] + part*(motion->mean0[i][k] - motion->rate0[i][k]);
}

/* Largest local error, c h^3 x''', by the increments of the last steps, turns times the rod's length; 0
 * if it is not known. */
static double local_error(const struct hawser__rod_motion *motion, const struct scheme *s, double h)
{
	double h1 = motion->past_h, h2 = motion->past2_h, most = 0.0, a0, a1, part;

	if (h1 <= 0.0 || h2 <= 0.0)
		return 0.0;
	a0 = 2.0/(h + h1);
	a1 = 2.0/(h1 + h2);
	part = 3.0/(h + h1 + h2)*s->c*h*h*h;
	for (int i = 0; i < motion->mesh->nodes; i++)
		for (int k = 0; k < HAWSER__ROD_FREE; k++) {
			double third = a0*motion->step[i][k]/h - (a0 + a1)*motion->past[i][k]/h1 +
			               a1*motion->past2[i][k]/h2;

			most = fmax(most, fabs(third)*(k < 3 ? 1.0 : motion->mesh->rod->length));
		}
	return part*most;
}

static void finish(struct hawser__rod_motion *motion, double h)
{
	double (*swap)[6] = motion->past2;

	/* supports and loads of the state itself: the last ones were before the last increment */
	(void)hawser__rod_motion_form(motion, motion->t + h, 0);
	motion->h = h;
	motion->t += h;
	hawser__rod_motion_account(motion, h);
	motion->past2 = motion->past;
	motion->past = swap;
	memcpy(motion->past, motion->step, (size_t)motion->mesh->nodes*sizeof *motion->step);
	motion->past2_h = motion->past_h;
	motion->past_h = h;
	motion->drift += motion->error;
	motion->steps++;
}

/* Try one step; 0: the state is as before, since there was no solution (motion->error 0) or its
 * local error, motion->error, is more than limit. */
static int attempt(struct hawser__rod_motion *motion, double h, double limit)
{
	struct scheme s = scheme_of(motion->rho_inf);
	int done;

	keep(motion, h);
	hawser__rod_motion_factors(motion, motion->t + h, 0);
	predict(motion, h);
	done = newton(motion, &s, h);
	motion->error = done ? local_error(motion, &s, h) : 0.0;
	if (done && motion->error <= limit) {
		finish(motion, h);
		return 1;
	}
	motion->factor_h = 0.0;
	restore(motion, h);
	return 0;
}

static enum hawser_status failed(const struct hawser__rod_motion *motion, double h,
                                 struct hawser_report *report)
{
	const struct hawser__rod_mesh *mesh = motion->mesh;

	if (motion->refused)
		return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "rod", "at %.9g s the loads are not "
		                    "defined", motion->t);
	if (motion->undefined)
		return undefined(motion, report);
	if (motion->bent >= 0)
		return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "rod", "at %.9g s the element from %.6g "
		                    "m to %.6g m turns by pi or more: give more elements", motion->t,
		                    mesh->s[motion->bent], mesh->s[motion->bent + 1]);
	if (motion->spun >= 0)
		return hawser__fail(report, HAWSER_ERR_CONVERGENCE, "rod", "at %.9g s the rod at %.6g m "
		                    "turns by more than %g rad in a step of %.3g s: give a shorter step",
		                    motion->t, mesh->s[motion->spun], SPUN, h);
	return hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, "rod", ITERATIONS, motion->increment,
	                       "at %.9g s no step of %.3g s or longer has a solution: give a shorter "
	                       "step, or more elements", motion->t, h);
}

static enum hawser_status split(struct hawser__rod_motion *motion, double h, int depth,
                                struct hawser_report *report)
{
	enum hawser_status status;

	if (attempt(motion, h, INFINITY))
		return HAWSER_OK;
	if (depth == 0)
		return failed(motion, h, report);
	motion->splits++;
	status = split(motion, 0.5*h, depth - 1, report);
	return status ? status : split(motion, 0.5*h, depth - 1, report);
}

enum hawser_status hawser__rod_motion_step(struct hawser__rod_motion *motion, double h,
                                           struct hawser_report *report)
{
	return split(motion, h, SPLITS, report);
}

enum hawser_status hawser__rod_motion_adapt(struct hawser__rod_motion *motion, double *h, double end,
                                            double tolerance, struct hawser_report *report)
{
	for (;;) {
		double left = end - motion->t, step = *h >= left ? left : *h > 0.5*left ? 0.5*left : *h, f;
		int least = step <= SHORTEST*fmax(fabs(end), left);

		if (attempt(motion, step, least ? INFINITY : tolerance)) {
			f = motion->error > 0.0 ? SAFETY*cbrt(tolerance/motion->error) : GROW;
			/* the same length again saves factors; what was left of the interval says nothing */
			if (f < 1.0 || f > STEADY || step != *h)
				*h = step < *h && f >= 1.0 ? *h : step*fmin(fmax(f, SHRINK), GROW);
			return HAWSER_OK;
		}
		if (least)
			return failed(motion, step, report);
		motion->rejected++;
		f = motion->error > 0.0 ? fmin(SAFETY*cbrt(tolerance/motion->error), SAFETY) : SHRINK;
		*h = step*fmax(f, SHRINK);
	}
}
