/* rod/motion_newton.c - a step of generalised-alpha on R^3 x SO(3), by Newton's method (motion.h).
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
#include <math.h>
#include <string.h>

#include "rod/motion.h"
#include "rod/so3.h"

enum { ITERATIONS = HAWSER__ROD_ITERATIONS };
#define TOLERANCE 1e-11 /* lengths of the rod and rad: what an increment of Newton's method may leave */
#define NEAR 1e-8       /* increments that are smaller and do not fall are round-off */
#define SLOW 0.1        /* the matrix is made anew if increments fall by less */
#define SQUARE 30.0     /* an increment with a new matrix leaves at most this times its square */
#define SAME 1e-6       /* steps that differ by less share factors */
#define UNSURE 0.05     /* the least contraction that is expected of factors of an earlier step */
#define SPUN HAWSER__ROD_SPUN /* rad */

/* c: x = (1 + 2 c h^2 D^2) times the exact one, by series of the scheme's difference operators. */
struct hawser__rod_scheme hawser__rod_scheme_of(double rho)
{
	struct hawser__rod_scheme s = {.am = (2.0*rho - 1.0)/(rho + 1.0), .af = rho/(rho + 1.0)};
	double v;

	s.g = 0.5 + s.af - s.am;
	s.b = 0.25*(0.5 + s.g)*(0.5 + s.g);
	v = 0.5*s.g*(1.0 - s.g) - 1.0/24.0 + 0.5*(s.af*(1.0 - s.af) - s.am*(1.0 - s.am));
	s.c = 0.5*fabs(v + s.b + 1.0/12.0 - 0.5*s.g);
	return s;
}

/* The state, from the increments of the step. Returns 1 if a node turns too far. */
static int place(struct hawser__rod_motion *motion, const struct hawser__rod_scheme *s, double h)
{
	struct hawser__rod_mesh *mesh = motion->mesh;

	motion->spun = motion->bent = -1;
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
void hawser__rod_motion_predict(struct hawser__rod_motion *motion, double h)
{
	double h1 = motion->past_h, all = h1 + motion->past2_h;

	for (int i = 0; i < motion->mesh->nodes; i++)
		for (int k = 0; k < HAWSER__ROD_FREE; k++) {
			double u = motion->velocity0[i][k], square = 0.5*motion->rate0[i][k], cube = 0.0;

			if (h1 > 0.0)
				square = (u*h1 - motion->past[i][k])/(h1*h1);
			if (h1 > 0.0 && motion->past2_h > 0.0) {
				double far = (u*all - motion->past[i][k] - motion->past2[i][k])/(all*all);

				cube = (square - far)/motion->past2_h;
				square += cube*h1;
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
	for (int i = 0; i < mesh->nodes; i++)
		memcpy(motion->factor_q[i], mesh->node[i].q, sizeof motion->factor_q[i]);
	motion->factored++;
	motion->contraction = 1.0; /* not known */
	motion->factor_h = h;
	return hawser__band_factor(&mesh->band);
}

/* The solution mesh->r. The factors are those of a state whose sections have turned since: forces
 * are turned back with them, and moves forth, so that a rod that turns as a rigid body keeps its
 * factors. */
static void solve(struct hawser__rod_motion *motion)
{
	struct hawser__rod_mesh *mesh = motion->mesh;
	double by[4], S[9], part[3];

	for (int back = 1; back >= 0; back--) {
		for (int i = 0; i < mesh->nodes; i++) {
			const double *q = mesh->node[i].q, *old = motion->factor_q[i];
			const double inverse[4] = {old[0], -old[1], -old[2], -old[3]};
			double *x = mesh->r + (long)HAWSER__ROD_FREE*i;

			hawser__quaternion_mul(by, q, inverse);
			hawser__quaternion_matrix(S, by);
			memcpy(part, x, sizeof part);
			if (back)
				hawser__apply_left(x, S, part);
			else
				hawser__apply(x, S, part);
		}
		if (back)
			hawser__band_solve(&mesh->band, mesh->r);
	}
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
int hawser__rod_motion_newton(struct hawser__rod_motion *motion,
                              const struct hawser__rod_scheme *s, double h)
{
	double last = INFINITY, left;
	int anew = fabs(motion->factor_h - h) > SAME*h;

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
		solve(motion);
		size = correct(motion);
		motion->iterations++;
		motion->increment = size;
		motion->undefined = !isfinite(size);
		if (motion->undefined)
			return 0;
		ratio = i > 0 ? size/last : anew ? 1.0 : fmax(motion->contraction, UNSURE);
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
