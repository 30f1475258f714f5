/* tow/motion_loads.c - drag, vortex shedding, the joint and the body of a cable in motion, and their
 * derivatives by places, turns, velocities and spins.
 *
 *   u, d     flow at the middle of an element, the wind less the mean of its nodes' velocities; its
 *            chord x2 - x1, L = |d|, t = d/L, P = 1 - t t'; p = P u; with a winch the velocity of the
 *            material, that of the nodes and c d/h (rod/motion.h)
 *   f        drag f(u, d) and shedding c |p| (t x u), c = density r ck sin(phase), per length; half of
 *            both on each node
 *   R, w     axes of the body's node, its spin in these; a = R e1, l its arm; v_c = v + R (w x l e1)
 *
 * The phase of vortex shedding has the rate 2 pi St |p|/d. It is a state of each element, moved on
 * with the mean of the rates at both ends of a step, and within a step by the rate at its beginning:
 * both are of order 2.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "tow/motion.h"

enum { FREE = HAWSER__ROD_FREE };
#define TURN 6.28318530717958647692 /* 2 pi, to the digits of a double */

void hawser__tow_wind(double wind[3], const struct hawser_tow *tow, double t)
{
	int i = 0, end = tow->gusts - 1;
	double part;

	memcpy(wind, tow->wind, 3*sizeof *wind);
	if (!tow->gusts)
		return;
	while (end - i > 1) {
		int middle = (i + end)/2;

		if (tow->gust[middle].t < t)
			i = middle;
		else
			end = middle;
	}
	part = fmin(fmax((t - tow->gust[i].t)/(tow->gust[i + 1].t - tow->gust[i].t), 0.0), 1.0);
	for (int k = 0; k < 3; k++)
		wind[k] = tow->gust[i].at[0][k] + part*(tow->gust[i + 1].at[0][k] - tow->gust[i].at[0][k]);
}

static void flow_at(double u[3], double d[3], const struct hawser__rod_motion *motion,
                    const double wind[3], int e)
{
	const struct hawser__rod_node *node = &motion->mesh->node[e];
	double through = hawser__rod_winch_through(motion, e)/motion->mesh->element[e].h;

	for (int k = 0; k < 3; k++) {
		d[k] = node[1].x[k] - node[0].x[k];
		u[k] = wind[k] - 0.5*(motion->velocity[e][k] + motion->velocity[e + 1][k]) - through*d[k];
	}
}

/* Add the force of shedding per length, and its derivatives by u and d. */
static void shed(double f[3], double (*f_u)[3], double (*f_d)[3], double c, const double u[3],
                 const double d[3])
{
	double L = hawser__norm(d), t[3], p[3], tu[3], a, norm;

	for (int k = 0; k < 3; k++)
		t[k] = d[k]/L;
	a = hawser__dot(t, u);
	for (int k = 0; k < 3; k++)
		p[k] = u[k] - a*t[k];
	norm = hawser__norm(p);
	hawser__cross(tu, t, u);
	for (int j = 0; j < 3; j++) {
		double unit[3] = {j == 0, j == 1, j == 2}, dt[3], by_u[3], by_t[3];
		double pj = norm > 0.0 ? p[j]/norm : 0.0;

		f[j] += c*norm*tu[j];
		for (int k = 0; k < 3; k++)
			dt[k] = (unit[k] - t[j]*t[k])/L;
		hawser__cross(by_u, t, unit);
		hawser__cross(by_t, dt, u);
		for (int i = 0; i < 3; i++) {
			f_u[i][j] += c*(norm*by_u[i] + pj*tu[i]);
			/* |p| changes by -a (p.dt)/|p|, and p.dt is p_j/L */
			f_d[i][j] += c*(norm*by_t[i] - a*pj/L*tu[i]);
		}
	}
}

static void put(double to[36], int row, int column, double (*A)[3], double factor)
{
	for (int i = 0; i < 3; i++)
		for (int j = 0; j < 3; j++)
			to[6*(row + i) + column + j] += factor*A[i][j];
}

static void push_element(struct hawser__tow_run *run, const double wind[3], double t, int e,
                         int tangent)
{
	struct hawser__rod_motion *motion = &run->motion;
	const struct hawser_tow_segment *of = &run->own.segment[motion->mesh->segment[e]];
	struct hawser_drag drag = {run->own.density, 0.5*of->diameter, of->normal, of->tangential};
	double u[3], d[3], f[3], f_u[3][3], f_d[3][3], half = 0.5*motion->mesh->element[e].h;
	double force[6] = {0.0}, by[36] = {0.0}, at[36];
	double through = hawser__rod_winch_through(motion, e)/motion->mesh->element[e].h;

	flow_at(u, d, motion, wind, e);
	hawser_drag_line(f, f_u, f_d, &drag, u, d);
	if (of->lift > 0.0)
		shed(f, f_u, f_d, run->own.density*drag.radius*of->lift*
		     sin(run->phase[e] + (t - run->at)*run->swing[e]), u, d);
	for (int k = 0; k < 3; k++)
		force[k] = half*f[k];
	for (int i = 0; i < 2; i++)
		hawser__rod_push(motion, e + i, force);
	if (!tangent)
		return;
	put(by, 0, 0, f_u, -0.5*half);
	for (int i = 0; i < 3 && through != 0.0; i++) /* the flow, too, changes with d */
		for (int j = 0; j < 3; j++)
			f_d[i][j] -= through*f_u[i][j];
	for (int j = 0; j < 2; j++) {
		memset(at, 0, sizeof at);
		put(at, 0, 0, f_d, j ? half : -half);
		for (int i = 0; i < 2; i++)
			hawser__rod_push_tangent(motion, e + i, e + j, at, by);
	}
}

/* The spring between the end of the cable and the ring, see steady_rod_loads.c. */
static void push_joint(struct hawser__tow_run *run, int tangent)
{
	const struct hawser__tow_rod *b = &run->rod;
	const struct hawser__rod_node *node = &b->mesh.node[b->last];
	const double *psi = b->mesh.strain[b->last].psi;
	struct hawser__so3 so3;
	double f[6], Ji[9];

	hawser__so3_at(&so3, psi);
	hawser__so3_ji(Ji, &so3);
	for (int n = 0; n < 2; n++) {
		double sign = n ? -1.0 : 1.0;

		for (int k = 0; k < 3; k++) {
			f[k] = sign*b->spring[0]*(node[1].x[k] - node[0].x[k]);
			f[3 + k] = sign*b->spring[1]*psi[k];
		}
		hawser__rod_push(&run->motion, b->last + n, f);
		for (int c = 0; c < 2 && tangent; c++) {
			double at[36] = {0.0};

			for (int i = 0; i < 3; i++) {
				at[7*i] = n == c ? -b->spring[0] : b->spring[0];
				for (int j = 0; j < 3; j++)
					at[6*(3 + i) + 3 + j] = sign*b->spring[1]*(c ? Ji[3*i + j] : -Ji[3*j + i]);
			}
			hawser__rod_push_tangent(&run->motion, b->last + n, b->last + c, at, NULL);
		}
	}
}

/* Force on a body, and its derivatives by the flow and, of a ring, its turn and spin; see drag.h. */
static void body_drag(struct hawser_ring_drag *drag, const struct hawser__tow_run *run,
                      const double u[3], const double axis[3], const double spin[3])
{
	const struct hawser_tow_body *body = &run->own.body;

	if (body->kind == HAWSER_TOW_RING) {
		hawser_ring_drag(drag, &body->ring, u, axis, spin);
		return;
	}
	memset(drag, 0, sizeof *drag);
	hawser_drag_body(drag->force, drag->force_u, 0.5*run->own.density*body->CdA, u);
}

/* Column j of the derivatives of force and moment on the body's node, in the order of its unknowns. */
static void column(double to[36], const struct hawser_ring_drag *drag, const double du[3],
                   const double turned[3], const double spun[3], const double a[3], double l, int j)
{
	double df[3], dm[3], part[3], da[3];

	for (int i = 0; i < 3; i++) {
		df[i] = hawser__dot(drag->force_u[i], du) + hawser__dot(drag->force_turn[i], turned) +
		        hawser__dot(drag->force_spin[i], spun);
		dm[i] = hawser__dot(drag->moment_u[i], du) + hawser__dot(drag->moment_turn[i], turned) +
		        hawser__dot(drag->moment_spin[i], spun);
	}
	hawser__cross(part, a, df);
	for (int i = 0; i < 3; i++)
		dm[i] += l*part[i];
	hawser__cross(da, turned, a);
	hawser__cross(part, da, drag->force);
	for (int i = 0; i < 3; i++) {
		to[6*i + j] = df[i];
		to[6*(3 + i) + j] = dm[i] + l*part[i]; /* in the scene's axes so far */
	}
}

/* Moments of the columns into the axes of the section; there the moment itself turns, too. */
static void turn_moments(double to[36], const double R[9], const double *moment)
{
	double part[36], skew[9];

	memcpy(part, to, sizeof part);
	for (int i = 0; i < 3; i++)
		for (int j = 0; j < 6; j++)
			to[6*(3 + i) + j] = R[i]*part[18 + j] + R[3 + i]*part[24 + j] + R[6 + i]*part[30 + j];
	if (!moment)
		return;
	hawser__skew(skew, moment);
	for (int k = 0; k < 9; k++)
		to[6*(3 + k/3) + 3 + k%3] += skew[k];
}

static void push_body(struct hawser__tow_run *run, const double wind[3], int tangent)
{
	struct hawser__rod_motion *motion = &run->motion;
	int end = run->rod.end;
	const double *v = motion->velocity[end], *w = v + 3;
	double l = run->own.body.kind == HAWSER_TOW_RING ? run->own.body.offset : 0.0;
	double R[9], a[3], u[3], swing[3], moved[3], spin[3], moment[3], f[6], at[36] = {0.0}, by[36];
	struct hawser_ring_drag drag;

	hawser__quaternion_matrix(R, motion->mesh->node[end].q);
	hawser__cross(swing, w, (const double [3]){l, 0.0, 0.0});
	hawser__apply(moved, R, swing);
	hawser__apply(spin, R, w);
	for (int k = 0; k < 3; k++) {
		a[k] = R[3*k];
		u[k] = wind[k] - v[k] - moved[k];
	}
	body_drag(&drag, run, u, a, spin);
	hawser__cross(moment, a, drag.force);
	for (int k = 0; k < 3; k++) {
		moment[k] = l*moment[k] + drag.moment[k];
		f[k] = drag.force[k];
	}
	hawser__apply_left(f + 3, R, moment);
	hawser__rod_push(motion, end, f);
	for (int j = 0; j < 3 && tangent; j++) {
		const double none[3] = {0.0}, own[3] = {j == 0, j == 1, j == 2}, arm[3] = {l, 0.0, 0.0};
		const double unit[3] = {-own[0], -own[1], -own[2]};
		double turn[3] = {R[j], R[3 + j], R[6 + j]}, part[3], du[3];

		column(by, &drag, unit, none, none, a, l, j); /* by velocity: the flow against it */
		hawser__cross(part, arm, own);
		hawser__apply(du, R, part);
		column(by, &drag, du, none, turn, a, l, 3 + j);
		/* the axes turn about R_j, and with them the spin and the velocity of the centre */
		hawser__cross(part, turn, moved);
		for (int k = 0; k < 3; k++)
			du[k] = -part[k];
		hawser__cross(part, turn, spin);
		column(at, &drag, du, turn, part, a, l, 3 + j);
	}
	if (!tangent)
		return;
	turn_moments(by, R, NULL);
	turn_moments(at, R, f + 3);
	hawser__rod_push_tangent(motion, end, end, at, by);
}

int hawser__tow_push(void *data, struct hawser__rod_motion *motion, double t, int tangent)
{
	struct hawser__tow_run *run = data;
	double wind[3];

	if (motion->mesh->water.of)
		return hawser__rod_water_push(NULL, motion, t, tangent);
	hawser__tow_wind(wind, run->tow, t);
	for (int e = 0; e < run->rod.last; e++)
		push_element(run, wind, t, e, tangent);
	if (run->rod.links)
		push_joint(run, tangent);
	if (run->own.body.kind != HAWSER_TOW_NO_BODY)
		push_body(run, wind, tangent);
	return 0;
}

void hawser__tow_shed(struct hawser__tow_run *run)
{
	const struct hawser__rod_motion *motion = &run->motion;
	double wind[3], h = motion->t - run->at;

	run->frequency = 0.0;
	hawser__tow_wind(wind, run->tow, motion->t);
	for (int e = 0; e < run->rod.last; e++) {
		const struct hawser_tow_segment *of = &run->own.segment[motion->mesh->segment[e]];
		double u[3], d[3], tu[3], rate;

		if (!(of->lift > 0.0))
			continue;
		flow_at(u, d, motion, wind, e);
		hawser__cross(tu, d, u);
		rate = TURN*of->strouhal*hawser__norm(tu)/hawser__norm(d)/of->diameter; /* |p| = |t x u| */
		run->phase[e] = fmod(run->phase[e] + 0.5*h*(run->swing[e] + rate), TURN);
		run->swing[e] = rate;
		run->frequency = fmax(run->frequency, rate/TURN);
	}
	run->at = motion->t;
}
