/* rod/solve.c - the equilibrium of a mesh: Newton's method, load steps, and a damped motion.
 *
 * First the whole load at once; a step whose iteration fails, takes long or ends where the rod gives
 * way in more directions than before, as it may have gone to another equilibrium, is halved, one that
 * goes well doubled. So the equilibrium is the one that the rod comes to as the load grows: by the
 * whole load at once, some of random cantilevers under a force and a moment of fixed directions come
 * to others. The
 * iteration ends by its increment: forces of elements of 1e7 N are balanced no better than to 1e-9 N
 * times their number, so that a limit of the residual would be one of round-off. If the steps become
 * too short, as with a rod that hangs from a hinge and begins without stiffness, the rod moves under
 * the full load with so much damping that it has no inertia,
 *     D u' = r, by implicit Euler: (K + D/t) du = r
 * with steps t that grow as the motion allows, until they are Newton's (pseudo-transient continuation,
 * Kelley and Keyes 1998). With loads that have a potential, t is so small that K + D/t is positive
 * definite: each step then lowers the energy, and the motion ends at a stable equilibrium, where
 * Newton's method ends at any. So it is tried too where Newton's method has found an unstable one.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "rod/mesh.h"
#include "rod/so3.h"
#include "water/morison.h"

enum {
	ITERATIONS = 30,   /* of a load step: those that converge take 4 to 10 */
	QUICK = 7,         /* a step with no more is followed by a longer one, while the rod is stable, */
	LINEAR = 3,        /* as many as an equilibrium takes to which all is linear, as a moment alone; */
	LONG = 9,          /* and one with more is not taken: it may have gone to another equilibrium */
	MOTION = 3000,     /* steps of the damped motion */
	HALVINGS = 12      /* the shortest load step: 2^-12 of the load */
};
#define PATIENT 0.01  /* of the load: with steps so short the rod follows the load */
#define FAR 100.0     /* lengths or rad: an increment that is larger has nothing to do with the rod */
#define NEAR 1e-6     /* increments that are smaller and do not fall are round-off */
#define LEFT 1e-2     /* largest unbalanced force over loads and EI/L^2: 1e-6 if EA is not too large */
#define ASIDE 0.3     /* width of the curve in which an end is moved, over the straight distance */
#define CALM 0.1      /* lengths or rad: a step of the motion may be this large, and */
#define WILD 0.3      /* no larger */
#define GROWTH 3.0    /* of the motion's steps */
enum { SADDLE = 8 };  /* steps that do not move a rod that is at an unstable equilibrium */
#define NARROWER 0.25 /* of the height over which a rod comes out of the water */
#define NEWTON 1e9    /* units of time: a motion with such steps is Newton's method */

static double largest(const struct hawser__rod_mesh *mesh, const double *step)
{
	double most = 0.0;

	for (int i = 0; i < mesh->nodes; i++) {
		const double *by = step + (long)HAWSER__ROD_FREE*i;
		double moved = sqrt(hawser__dot(by, by))/mesh->rod->length;
		double turned = sqrt(hawser__dot(by + 3, by + 3));

		most = fmax(most, fmax(moved, turned));
		if (!(most < INFINITY && moved < INFINITY && turned < INFINITY))
			return INFINITY;
	}
	return most;
}

/* The offset of the end from the straight line to its goal, when it is moved in a curve. An end that
 * moves straight towards the start compresses the rod along its axis, and the rod buckles late, by a
 * jump. part: 0 to 1, of the way. */
static void aside(double by[3], const struct hawser__rod_mesh *mesh, double part)
{
	const double pi = acos(-1.0);
	double R[9], way[3], square, along, length, best = 0.0;

	hawser__quaternion_matrix(R, mesh->rest[0].q);
	for (int i = 0; i < 3; i++)
		way[i] = mesh->goal[1].x[i] - mesh->rest[mesh->nodes - 1].x[i];
	square = hawser__dot(way, way);
	memset(by, 0, 3*sizeof *by);
	for (int e = 1; e < 3 && square > 0.0 && best < 0.25; e++) { /* e2, or e3 if that is the way */
		double across[3];

		along = (R[e]*way[0] + R[3 + e]*way[1] + R[6 + e]*way[2])/square;
		for (int i = 0; i < 3; i++)
			across[i] = R[3*i + e] - along*way[i];
		length = sqrt(hawser__dot(across, across));
		if (length <= best)
			continue;
		best = length;
		for (int i = 0; i < 3; i++)
			by[i] = ASIDE*sin(pi*part)*sqrt(square)*across[i]/length;
	}
}

/* Where the ends are held: their increments to the part of the way to their goals. */
static void hold(struct hawser__rod_mesh *mesh, double part)
{
	double detour[3] = {0.0};

	if (mesh->detour)
		aside(detour, mesh, part);
	for (int end = 0; end < 2; end++) {
		int at = end ? mesh->nodes - 1 : 0;
		const struct hawser__rod_node *rest = &mesh->rest[at];
		double between[4], turn[3], goal[4], by[6];

		hawser__quaternion_between(between, rest->q, mesh->goal[end].q);
		if (between[0] < 0.0) /* the shorter way */
			for (int i = 0; i < 4; i++)
				between[i] = -between[i];
		(void)hawser__quaternion_log(turn, between);
		for (int i = 0; i < 3; i++) {
			turn[i] *= part;
			by[i] = rest->x[i] + part*(mesh->goal[end].x[i] - rest->x[i]) + end*detour[i] -
			        mesh->node[at].x[i];
		}
		memcpy(goal, rest->q, sizeof goal);
		hawser__quaternion_turn(goal, turn);
		hawser__quaternion_between(between, mesh->node[at].q, goal);
		(void)hawser__quaternion_log(by + 3, between);
		for (int k = 0; k < HAWSER__ROD_FREE; k++)
			if (mesh->held[HAWSER__ROD_FREE*at + k])
				mesh->r[HAWSER__ROD_FREE*at + k] = by[k];
	}
}

static int solve(struct hawser__rod_mesh *mesh, double part)
{
	hold(mesh, part);
	for (int i = 0; i < mesh->n; i++)
		if (mesh->held[i])
			mesh->r[i] *= hawser__band_hold(&mesh->band, i);
	if (hawser__band_factor(&mesh->band))
		return 1;
	hawser__band_solve(&mesh->band, mesh->r);
	return 0;
}

/* 1 if an element is turned inside out: it solves the equations, but no rod does this. */
static int inside_out(const struct hawser__rod_mesh *mesh)
{
	for (int e = 0; e < mesh->elements; e++)
		if (!(mesh->strain[e].w[0] > 0.0))
			return 1;
	return 0;
}

/* Newton's method at this part of the load; 1: it has converged. */
static int newton(struct hawser__rod_mesh *mesh, struct hawser__rod_effort *effort, double part,
                  double tolerance)
{
	double before = INFINITY, size;

	effort->bent = hawser__rod_strains(mesh);
	for (int i = 0; i < ITERATIONS && effort->bent < 0; i++) {
		hawser__rod_tangent(mesh);
		if (solve(mesh, part))
			return 0;
		size = largest(mesh, mesh->r);
		effort->iterations++;
		effort->increment = size;
		if (!(size < FAR))
			return 0;
		if (size > NEAR)
			hawser__rod_follow(mesh, mesh->r);
		else
			hawser__rod_move(mesh, mesh->r, 1.0);
		effort->bent = hawser__rod_strains(mesh);
		if (size <= tolerance || (size < NEAR && size > 0.5*before))
			return effort->bent < 0 && !inside_out(mesh);
		before = size;
	}
	return 0;
}

static void keep(struct hawser__rod_mesh *mesh, int back)
{
	memcpy(back ? mesh->node : mesh->kept, back ? mesh->kept : mesh->node,
	       (size_t)mesh->nodes*sizeof *mesh->node);
}

/* The load cannot be raised further: back to the equilibrium of the whole load, if it led to one. */
static int jumped(struct hawser__rod_mesh *mesh, struct hawser__rod_effort *effort, double part,
                  int other)
{
	effort->jump = effort->jump > 0.0 ? effort->jump : part;
	if (!other)
		return 0;
	memcpy(mesh->node, mesh->found, (size_t)mesh->nodes*sizeof *mesh->node);
	(void)hawser__rod_strains(mesh);
	return 1;
}

/* m: how far the node that is farthest from its place in mesh->found. */
static double apart(const struct hawser__rod_mesh *mesh)
{
	double most = 0.0;

	for (int i = 0; i < mesh->nodes; i++) {
		const double *a = mesh->node[i].x, *b = mesh->found[i].x;

		most = fmax(most, hypot(hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]));
	}
	return most;
}

/* Directions in which the rod gives way: of the symmetric part of the tangent, where loads have no
 * potential. */
static int negative(struct hawser__rod_mesh *mesh)
{
	hawser__rod_tangent(mesh);
	return hawser__band_negative(&mesh->band, mesh->held, mesh->work);
}

/* The load in steps; 1: done. any: 1, take whatever equilibrium a step leads to. */
static int raise(struct hawser__rod_mesh *mesh, struct hawser__rod_effort *effort,
                 const double *factor, int count, double tolerance, int any)
{
	double part = 0.0, by = 1.0/count;
	int other = 0, last = 0; /* 1: mesh->found is one under the whole load; negative pivots */

	while (part < 1.0) {
		double to = part + by > 1.0 - 1e-9 ? 1.0 : part + by;
		int before = effort->iterations, good, took, ways;

		keep(mesh, 0);
		hawser__rod_loads(mesh, factor, to);
		good = newton(mesh, effort, to, tolerance);
		took = effort->iterations - before;
		ways = good ? negative(mesh) : 0;
		if (good && (any || took <= LINEAR ||
		             (took <= LONG && (ways <= last || by*count < PATIENT)))) {
			part = to;
			last = ways;
			effort->steps++;
			if (took <= QUICK && (any || !ways) && by < 1.0/count)
				by *= 2.0;
			continue;
		}
		if (good && to == 1.0 && !other) {
			memcpy(mesh->found, mesh->node, (size_t)mesh->nodes*sizeof *mesh->node);
			other = 1;
		}
		keep(mesh, 1);
		by *= 0.5;
		if (by*count < ldexp(1.0, -HALVINGS))
			return jumped(mesh, effort, part, other);
	}
	effort->other = other ? apart(mesh) : 0.0;
	return 1;
}

/* Where the load cannot be raised so that the rod follows, any equilibria on the way. */
static int steps(struct hawser__rod_mesh *mesh, struct hawser__rod_effort *effort,
                 const double *factor, int count, double tolerance)
{
	if (raise(mesh, effort, factor, count, tolerance, 0))
		return 1;
	memcpy(mesh->node, mesh->rest, (size_t)mesh->nodes*sizeof *mesh->node);
	return raise(mesh, effort, factor, count, tolerance, 1);
}

/* N: all loads, moments as forces at the rod's length. */
static double loads(const struct hawser__rod_mesh *mesh)
{
	double force = 0.0;

	for (int i = 0; i < mesh->nodes; i++) {
		const struct hawser__rod_force *of = &mesh->sum[i];

		force += sqrt(hawser__dot(of->force, of->force)) + sqrt(hawser__dot(of->follow, of->follow)) +
		         (sqrt(hawser__dot(of->moment, of->moment)) + sqrt(hawser__dot(of->turn, of->turn)))/
		         mesh->rod->length;
	}
	return force;
}

/* D: per unit of length, such that the whole load moves the rod by its length in a unit of time; turns
 * of a node are damped as the motion of what is at an element's length. */
static double unit(const struct hawser__rod_mesh *mesh)
{
	double force = loads(mesh);

	for (int e = 0; e < mesh->elements && force == 0.0; e++)
		force = fmax(force, mesh->element[e].EI[1]/(mesh->rod->length*mesh->rod->length));
	return force/(mesh->rod->length*mesh->rod->length);
}

static void damp(struct hawser__rod_mesh *mesh, double d)
{
	for (int e = 0; e < mesh->elements; e++) {
		double h = mesh->element[e].h;

		for (int k = 0; k < HAWSER__ROD_PAIR; k++) {
			int at = HAWSER__ROD_FREE*e + k;

			*hawser__band_at(&mesh->band, at, at) += 0.5*d*h*(k % HAWSER__ROD_FREE < 3 ? 1.0 : h*h);
		}
	}
}

/* The damped motion from rest; 1: it has ended. */
static int flow(struct hawser__rod_mesh *mesh, struct hawser__rod_effort *effort, double tolerance,
                void (*advance)(struct hawser__rod_mesh *, const double *))
{
	double d = unit(mesh), t = 0.01, part = 0.0, before = INFINITY;
	int potential = hawser__rod_potential(mesh->rod), still = 0;
	int moved = mesh->rod->placed || mesh->rod->turned;

	effort->flow = 1;
	effort->steps = 0;
	memcpy(mesh->node, mesh->rest, (size_t)mesh->nodes*sizeof *mesh->node);

	for (int i = 0; i < MOTION; i++) {
		double size, to = fmin(part + fmin(0.05, t), 1.0); /* the ends move with the time */

		keep(mesh, 0);
		if (hawser__rod_strains(mesh) >= 0)
			return 0;
		hawser__rod_tangent(mesh);
		damp(mesh, d/t);
		effort->iterations++;
		if (potential && (!moved || part == 1.0) &&
		    hawser__band_negative(&mesh->band, mesh->held, mesh->work)) {
			t *= 0.5;
			continue;
		}
		if (!solve(mesh, to) && (size = largest(mesh, mesh->r)) < WILD) {
			advance(mesh, mesh->r);
			if (hawser__rod_strains(mesh) < 0) {
				part = to;
				effort->increment = size;
				effort->steps++;
				if (part == 1.0 && t >= NEWTON &&
				    (size <= tolerance || (size < NEAR && size > 0.5*before)))
					return 1;
				before = size;
				still = size <= tolerance && part == 1.0 && t < NEWTON ? still + 1 : 0;
				if (still > SADDLE + 60)
					return newton(mesh, effort, 1.0, tolerance);
				t *= size < CALM ? GROWTH : 1.0;
				continue;
			}
		}
		keep(mesh, 1);
		t *= 0.25;
		if (t < 1e-12)
			return 0;
	}
	return 0;
}

static void straight(struct hawser__rod_mesh *mesh, const double *step)
{
	hawser__rod_move(mesh, step, 1.0);
}

/* hawser__rod_follow allows longer steps; if an end compresses the rod, hawser__rod_move may be
 * needed. */
int hawser__rod_flow(struct hawser__rod_mesh *mesh, struct hawser__rod_effort *effort, double tolerance)
{
	return flow(mesh, effort, tolerance, hawser__rod_follow) ||
	       flow(mesh, effort, tolerance, straight);
}

/* A rod that floats is pushed up below the surface and down above it: it comes out of the water over
 * its whole length at first, and over a smaller height from step to step. 1: done. */
static int surface(struct hawser__rod_mesh *mesh, struct hawser__rod_effort *effort,
                   const double *factor, int count, double tolerance)
{
	double *band = &mesh->water.band, narrow = NARROWER, least = INFINITY;
	int done, failed = 0;

	for (int i = 0; i < mesh->rod->segments; i++)
		if (mesh->rod->segment[i].line.diameter > 0.0)
			least = fmin(least, HAWSER__WATER_BAND*mesh->rod->segment[i].line.diameter);
	*band = mesh->rod->length;
	memcpy(mesh->node, mesh->rest, (size_t)mesh->nodes*sizeof *mesh->node);
	done = steps(mesh, effort, factor, count, tolerance);
	hawser__rod_loads(mesh, factor, 1.0);
	if (!done)
		done = hawser__rod_flow(mesh, effort, tolerance);
	while (done && *band > 0.0) {
		double before = *band;

		keep(mesh, 0);
		*band = narrow*before > least ? narrow*before : 0.0;
		if (newton(mesh, effort, 1.0, tolerance)) {
			effort->steps++;
			failed = 0;
			continue;
		}
		keep(mesh, 1);
		*band = before;
		narrow = sqrt(narrow);
		done = ++failed < HALVINGS;
	}
	*band = 0.0;
	return done;
}

/* The largest unbalanced force of a node, N. scale: the loads and EI/L^2, against which it must be
 * small. stiff: the largest of EA and GA. With a very large EA rounded positions leave large
 * unbalanced forces, and section forces and stability are meaningless. */
static double unbalanced(struct hawser__rod_mesh *mesh, double *scale, double *stiff)
{
	double left = 0.0, bends = INFINITY;

	*stiff = 0.0;
	(void)hawser__rod_strains(mesh);
	hawser__rod_residual(mesh);
	for (int i = 0; i < mesh->nodes; i++)
		left = fmax(left, hawser__norm(mesh->r + (long)HAWSER__ROD_FREE*i));
	for (int e = 0; e < mesh->elements; e++) {
		const struct hawser__rod_element *el = &mesh->element[e];

		*stiff = fmax(*stiff, fmax(el->EA[0], fmax(el->EA[1], el->EA[2])));
		bends = fmin(bends, fmin(el->EI[1], el->EI[2]));
	}
	*scale = loads(mesh) + bends/(mesh->rod->length*mesh->rod->length);
	return left;
}

/* Accept the equilibrium, or fail with the reason. done: the iteration converged. */
static enum hawser_status found(struct hawser__rod_mesh *mesh, const struct hawser__rod_effort *effort,
                                int done, struct hawser_report *report)
{
	double scale, stiff, left = unbalanced(mesh, &scale, &stiff);

	if (done && left <= LEFT*scale)
		return HAWSER_OK;
	if (stiff*DBL_EPSILON > 0.01*LEFT*scale) {
		left = done ? left : stiff*DBL_EPSILON;
		return hawser__fail(report, HAWSER_ERR_CONVERGENCE, "statics", "EA and GA (up to %.2g N) "
		                    "are too large for double precision: rounding causes forces of "
		                    "%.2g N, and loads and EI/L^2 are %.2g N. Give at most %.0e N, with "
		                    "which the rod stretches by %.0e of its length", stiff, left, scale,
		                    0.1*stiff*LEFT*scale/left, 10.0*left/(LEFT*stiff));
	}
	if (effort->bent >= 0)
		return hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, "statics", effort->iterations,
		                       effort->increment, "no equilibrium found: the element from %.6g m to "
		                       "%.6g m turns by pi or more: give more elements, or smaller loads",
		                       mesh->s[effort->bent], mesh->s[effort->bent + 1]);
	return hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, "statics", effort->iterations,
	                       effort->increment, "no equilibrium found: neither load steps nor a damped "
	                       "motion under the full load came to one (last increment %.2e of the length, "
	                       "or rad): are ends held so that the rod cannot move away? Check the loads "
	                       "and their units; more elements help if one turns by pi or more",
	                       effort->increment);
}

enum hawser_status hawser__rod_equilibrium(struct hawser__rod_mesh *mesh,
                                           struct hawser__rod_effort *effort, int start, int count,
                                           const double *factors, double tolerance,
                                           struct hawser_report *report)
{
	const struct hawser_rod *rod = mesh->rod;
	double *factor = malloc(((size_t)rod->loads + 1)*sizeof *factor);
	int done = 0;

	*effort = (struct hawser__rod_effort){.bent = -1};
	if (!factor)
		return hawser__no_memory(report, "statics");
	for (int i = 0; i < rod->loads; i++)
		factor[i] = factors ? factors[i] : 1.0;
	hawser__rod_loads(mesh, factor, 1.0);
	if (!(unit(mesh) < INFINITY)) {
		free(factor);
		return hawser__fail(report, HAWSER_ERR_NAN, "statics", "a load or a stiffness of the rod "
		                    "is not a number");
	}
	if (start) {
		keep(mesh, 0);
		done = newton(mesh, effort, 1.0, tolerance);
		keep(mesh, !done);
	}
	if (start && !done)
		memcpy(mesh->node, mesh->rest, (size_t)mesh->nodes*sizeof *mesh->node);
	if (!done)
		done = steps(mesh, effort, factor, count, tolerance);
	hawser__rod_loads(mesh, factor, 1.0);
	if (!done)
		done = hawser__rod_flow(mesh, effort, tolerance);
	if (!done && mesh->water.of)
		done = surface(mesh, effort, factor, count, tolerance);
	if (!done && (rod->placed || rod->turned)) {
		mesh->detour = 1;
		memcpy(mesh->node, mesh->rest, (size_t)mesh->nodes*sizeof *mesh->node);
		done = steps(mesh, effort, factor, count, tolerance) ||
		       (hawser__rod_loads(mesh, factor, 1.0), hawser__rod_flow(mesh, effort, tolerance));
		mesh->detour = 0;
	}
	free(factor);
	return found(mesh, effort, done, report);
}
