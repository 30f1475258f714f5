/* tests/extremes/traces-check.h - conditions that every sweep with followed branches must meet, over
 * the tension (hawser/irvine.h) or over the speed (hawser/campbell.h).
 *
 * At a station each branch must be the mode of the same order number in a separate modal solution,
 * and the number of frequencies below the highest one must be that of the index theorem of Morse. At
 * a speed the same theorem holds for the Hermitian problem, with the momentum P = F - i nu omega X
 * conjugate to X:
 *
 *   Theta = (P - i w X) (P + i w X)^-1 is unitary, and has an eigenvalue 1 where X is singular;
 *   w      omega (k + nu^2)^1/2, the mean impedance of the two waves (k: stiffness)
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_TESTS_TRACES_CHECK_H
#define HAWSER_TESTS_TRACES_CHECK_H

#include <hawser/campbell.h>

#include "tests/extremes/sweep.h"
#include "tests/extremes/modes-count.h"
#include "tests/gyroscopic-shooting.h"

enum { TRUTH_MODES = 700 };

/* A sweep over the tension or over the speed. */
struct trace {
	int stations, branches, in, points; /* asked ones */
	int crossovers;
	const double *omega, *residual; /* [stations][branches] */
	const int *place;
	const enum hawser_family *family;
	const enum hawser_symmetry *symmetry; /* NULL at a speed */
	double *x;                            /* [stations] apparent H, or the speed */
	double *moved;
	int *asked;                           /* [points] stations */
	struct hawser_campbell_crossover *at; /* [crossovers] `speed` is x */
};

static inline void trace_clear(struct trace *t)
{
	free(t->x);
	free(t->moved);
	free(t->asked);
	free(t->at);
}

static inline void trace_room(struct trace *t)
{
	t->x = calloc((size_t)t->stations, sizeof *t->x);
	t->moved = calloc((size_t)t->stations, sizeof *t->moved);
	t->asked = calloc((size_t)t->stations, sizeof *t->asked);
	t->at = calloc((size_t)t->crossovers + 1, sizeof *t->at);
	if (!t->x || !t->moved || !t->asked || !t->at)
		abort();
}

/* Frequencies at one station, by plane, rad/s. */
struct truth {
	struct hawser_statics statics;
	double unit; /* s */
	int count[2];
	double omega[2][TRUTH_MODES], residual[2][TRUTH_MODES];
};

static inline void truth_add(struct truth *truth, enum hawser_plane plane, double omega,
                             double residual)
{
	int k = truth->count[plane]++;

	truth->omega[plane][k] = omega/truth->unit;
	truth->residual[plane][k] = residual;
}

/* The lowest n of both planes together. */
static inline enum hawser_status truth_some(struct truth *truth, int n)
{
	const struct hawser_statics *st = &truth->statics;
	const struct hawser_modes_options options = {.n = n};
	int moves = st->motion.speed != 0.0 || st->motion.fluctuation != 0.0;
	struct hawser_modes c = {0};
	struct hawser_modes m = {0};
	enum hawser_status status = moves ? hawser_complex_modes_solve(&c, st, &options, NULL)
	                                  : hawser_modes_solve(&m, st, &options, NULL);

	truth->count[0] = truth->count[1] = 0;
	if (status)
		return status;
	truth->unit = moves ? c.time_unit : m.time_unit;
	for (int k = 0; k < n; k++)
		if (moves)
			truth_add(truth, c.mode[k].plane, c.mode[k].omega, c.mode[k].residual);
		else
			truth_add(truth, m.mode[k].plane, m.mode[k].omega, m.mode[k].residual);
	hawser_modes_clear(&m);
	hawser_modes_clear(&c);
	return status;
}

/* At least so many of each plane. */
static inline enum hawser_status truth_solve(struct truth *truth, int in, int out)
{
	enum hawser_status status = HAWSER_OK;

	for (int n = in + out + 3; n <= TRUTH_MODES && !status; n += 5 + n/4) {
		status = truth_some(truth, n);
		if (truth->count[0] >= in && truth->count[1] >= out)
			return status;
	}
	return status ? status : HAWSER_ERR_CONVERGENCE;
}

/* --- the index theorem at a speed --- */

/* Angles of the eigenvalues of Theta, each in (0, 2 pi], summed; D F^-1 is Hermitian. */
static inline double index_angles(turn D[2][2], turn F[2][2], turn detD, turn detF)
{
	int soft = cabsl(detF) >= cabsl(detD);
	turn (*A)[2] = soft ? D : F, (*B)[2] = soft ? F : D, det = soft ? detF : detD;
	long double a = creall((A[0][0]*B[1][1] - A[0][1]*B[1][0])/det);
	long double c = creall((A[1][1]*B[0][0] - A[1][0]*B[0][1])/det);
	long double b = cabsl((A[0][1]*B[0][0] - A[0][0]*B[0][1])/det);
	long double half = hypotl(0.5L*(a - c), b), big = 0.5L*(a + c) + (a + c < 0.0L ? -half : half);
	long double product = creall(soft ? detD/detF : detF/detD);
	double value[2] = {(double)big, big == 0.0L ? 0.0 : (double)(product/big)}, sum = 0.0;

	for (int k = 0; k < 2; k++)
		sum += count_angle(-2.0*(soft ? atan(value[k]) : atan2(1.0, value[k])));
	return sum;
}

/* Backward rotation of the determinant of Theta since last[2]; *sum is the sum of the angles. `gauge`
 * removes the common rotation of the two waves. */
static inline double index_turn(double *sum, turn last[2], const struct turn_problem *p,
                                long double s, const turn *y, turn gauge)
{
	long double u = p->eta + p->delta*s, T = sqrtl(1.0L + u*u), soft = (1.0L + p->epsilon*T)/T;
	long double ex = (p->ec + u*p->es)/T, ey = (u*p->ec - p->es)/T, turned;
	long double weight[2] = {powl(1.0L/p->epsilon + p->nu*p->nu, -0.25L),
	                         powl(1.0L/soft + p->nu*p->nu, -0.25L)};
	turn D[2][2], F[2][2], now[2], detD, detF;

	if (p->out_of_plane) {
		detD = p->omega*y[5]/weight[1];
		detF = (y[7] - I*p->nu*p->omega*y[5])*weight[1];
		*sum = count_angle(-2.0*atan2((double)creall(detD*conjl(detF)),
		                              (double)(cabsl(detF)*cabsl(detF))));
		if (cabsl(detD) > cabsl(detF))
			*sum = count_angle(-2.0*atan2((double)(cabsl(detD)*cabsl(detD)),
			                              (double)creall(detF*conjl(detD))));
		now[0] = detF + I*detD;
		now[1] = detF - I*detD;
	} else {
		for (int c = 0; c < 2; c++) {
			const turn *v = y + 4*c;
			turn P[2] = {v[2] - I*p->nu*p->omega*v[0], v[3] - I*p->nu*p->omega*v[1]};

			D[0][c] = p->omega*(v[0]*ex + v[1]*ey)/weight[0];
			D[1][c] = p->omega*(v[1]*ex - v[0]*ey)/weight[1];
			F[0][c] = (P[0]*ex + P[1]*ey)*weight[0];
			F[1][c] = (P[1]*ex - P[0]*ey)*weight[1];
		}
		detD = D[0][0]*D[1][1] - D[0][1]*D[1][0];
		detF = F[0][0]*F[1][1] - F[0][1]*F[1][0];
		for (int k = 0; k < 2; k++) {
			turn i = k ? -I : I;

			now[k] = (F[0][0] + i*D[0][0])*(F[1][1] + i*D[1][1])
			         - (F[0][1] + i*D[0][1])*(F[1][0] + i*D[1][0]);
		}
		*sum = index_angles(D, F, detD, detF);
	}
	turned = cargl(now[0]/last[0]*gauge) - cargl(now[1]/last[1]*gauge);
	last[0] = now[0];
	last[1] = now[1];
	return (double)turned;
}

/* Number of frequencies of the plane below omega (scaled) of a travelling cable; -1: not determined. */
static inline int index_below(const struct hawser_statics *st, enum hawser_plane plane,
                              double omega, int steps)
{
	long double um = (long double)st->eta + 0.5L*st->delta*st->l, root = sqrtl(1.0L + um*um);
	struct turn_problem p = {st->eta, st->delta, st->epsilon, st->motion.nu, 1.0L/root, um/root,
	                         omega, plane == HAWSER_OUT_OF_PLANE};
	turn y[TURN_STATE] = {0, 0, 1, 0, 0, 0, 0, 1}, last[2] = {1.0L, 1.0L};
	long double s = 0.0L, u, a = asinhl(p.eta), b = asinhl(p.eta + p.delta*st->l);
	double turned = 0.0, sum = 0.0, whole;

	index_turn(&sum, last, &p, 0.0L, y, 1.0L);
	for (int k = 1; k <= steps; k++) {
		long double x = a + (b - a)*k/steps, next = (long double)st->l*k/steps;

		if (b - a > 0.5L && k < steps)
			next = (sinhl(x) - p.eta)/p.delta;
		u = p.eta + 0.5L*p.delta*(s + next);
		turn_step(y, &p, s, next - s);
		turned += index_turn(&sum, last, &p, next, y,
		                     cexpl(-I*p.nu*p.omega*(next - s)
		                           *(1.0L/sqrtl(1.0L + u*u) + p.epsilon)));
		s = next;
	}
	whole = (sum + turned)/6.283185307179586;
	return fabs(whole - round(whole)) < 1e-3
		? (int)lround(whole) - (p.out_of_plane ? 1 : 2) : -1;
}

static inline int truth_below(const struct truth *truth, enum hawser_plane plane, double omega,
                              int place)
{
	const struct hawser_statics *st = &truth->statics;
	double bend = asinh(st->eta + st->delta*st->l) - asinh(st->eta);

	if (st->motion.speed == 0.0 && st->motion.fluctuation == 0.0)
		return count_below(st, plane, omega*truth->unit, 4*(12 + place + (int)(5.0*bend)));
	return index_below(st, plane, omega*truth->unit,
	                   30 + place*(2 + (int)fmin(st->motion.nu, 10.0)) + (int)(6.0*bend));
}

/* --- a station --- */

/* As sweep_keep; a wrong point stays wrong. */
static inline void trace_keep(struct sweep_point *point, double error, double stated)
{
	if (!isnan(point->error))
		sweep_keep(point, error, stated);
}

/* Mark a point as wrong, with the reason. */
static inline void trace_wrong(struct sweep_point *point, const char *format, ...)
{
	va_list list;

	if (!isnan(point->error)) {
		va_start(list, format);
		vsnprintf(point->report.message, sizeof point->report.message, format, list);
		va_end(list);
	}
	point->error = NAN;
}

/* All numbers must be finite and positive. Each order number occurs once, and the out-of-plane
 * branches are in ascending order. Each station occurs once, in the order of the sweep. */
static inline void trace_sound(struct sweep_point *point, const struct trace *t)
{
	int way = t->x[t->stations - 1] > t->x[0] ? 1 : -1, taken[TRUTH_MODES];
	int next = 0, added, before = 0;

	for (int i = 0; i < t->stations; i++) {
		memset(taken, 0, sizeof taken);
		if (i > 0 && !(way*(t->x[i] - t->x[i - 1]) > 0.0))
			trace_wrong(point, "stations %d and %d are out of order", i, i + 1);
		added = next >= t->points || t->asked[next] != i;
		next += !added;
		if (i > 0 && (added || before) && fabs(t->x[i] - t->x[i - 1]) < 1e-12*fabs(t->x[i]))
			trace_wrong(point, "stations %d and %d are one, at %.17g", i, i + 1, t->x[i]);
		before = added;
		for (int b = 0; b < t->branches; b++) {
			int at = i*t->branches + b, place = t->place[at];

			if (!(t->omega[at] > 0.0 && isfinite(t->omega[at]) && t->residual[at] >= 0.0 &&
			      isfinite(t->residual[at])))
				trace_wrong(point, "omega %g, residual %g of branch %d at station %d",
				            t->omega[at], t->residual[at], b, i);
			if (b >= t->in ? place != b - t->in : place < 0 || place >= TRUTH_MODES ||
			    taken[place]++)
				trace_wrong(point, "place %d of branch %d at station %d", place, b, i);
			for (int c = 0; c < b && b < t->in; c++)
				if ((t->place[at] - t->place[at - b + c])
				    *(t->omega[at] - t->omega[at - b + c]) < 0.0)
					trace_wrong(point, "branches %d and %d at station %d: frequencies "
					            "against their places", c, b, i);
		}
	}
}

static inline int truth_alone(const struct truth *truth, int plane, int k, double width)
{
	const double *omega = truth->omega[plane];

	return (k == 0 || omega[k - 1] < omega[k]*(1.0 - width)) &&
	       (k + 1 >= truth->count[plane] || omega[k + 1] > omega[k]*(1.0 + width));
}

/* The branches of station i against modes at truth->statics, which are solved here. */
static inline void trace_station(struct sweep_point *point, const struct trace *t, int i,
                                 struct truth *truth)
{
	int top[2] = {-1, -1}, from[2] = {-1, -1};

	for (int b = 0; b < t->branches; b++) {
		int plane = b >= t->in, place = t->place[i*t->branches + b];

		if (place > top[plane]) {
			top[plane] = place;
			from[plane] = b;
		}
	}
	if (truth_solve(truth, top[0] + 2, top[1] + 2)) {
		trace_wrong(point, "no modes at station %d, x %.17g", i, t->x[i]);
		return;
	}
	for (int b = 0; b < t->branches; b++) {
		int at = i*t->branches + b, plane = b >= t->in, k = t->place[at];
		double omega = truth->omega[plane][k];

		trace_keep(point, fabs(t->omega[at]/omega - 1.0),
		           t->residual[at] + truth->residual[plane][k]);
	}
	for (int plane = 0; plane < 2; plane++) {
		int k = top[plane], below, above;
		double omega, width;

		if (k < 0)
			continue;
		omega = t->omega[i*t->branches + from[plane]];
		width = 1e-6 + 4.0*t->residual[i*t->branches + from[plane]];
		if (width > 1e-2 || !truth_alone(truth, plane, k, 2.0*width))
			continue;
		below = truth_below(truth, (enum hawser_plane)plane, omega*(1.0 - width), k + 1);
		above = truth_below(truth, (enum hawser_plane)plane, omega*(1.0 + width), k + 1);
		if (below != k || above != k + 1)
			trace_wrong(point, "station %d, x %.17g: place %d of plane %d, but %d frequencies lie "
			            "below and %d with it", i, t->x[i], k, plane, below, above);
	}
}

/* --- crossovers --- */

/* Between stations i - 1 and i the order of the branches must change by the crossings that are listed
 * there, and by no others. No crossover may be listed twice. */
static inline void trace_order(struct sweep_point *point, const struct trace *t)
{
	int way = t->x[t->stations - 1] > t->x[0] ? 1 : -1, next = 0;
	int place[TRUTH_MODES];

	for (int i = 0; i < t->crossovers; i++)
		for (int j = 0; j < i; j++)
			if (((t->at[i].below == t->at[j].below && t->at[i].above == t->at[j].above) ||
			     (t->at[i].below == t->at[j].above && t->at[i].above == t->at[j].below)) &&
			    fabs(t->at[i].speed/t->at[j].speed - 1.0) < 1e-8)
				trace_wrong(point, "branches %d and %d meet twice at %.17g", t->at[i].below,
				            t->at[i].above, t->at[i].speed);
	for (int i = 0; i < t->stations; i++) {
		const int *now = t->place + (size_t)i*(size_t)t->branches;
		int swaps = 0;

		for (; i > 0 && next < t->crossovers && way*t->at[next].speed < way*t->x[i]; next++) {
			int a = t->at[next].below - 1, b = t->at[next].above - 1;

			if (t->at[next].kind != HAWSER_CROSSING)
				continue;
			if (a < t->in && b < t->in && place[b] != place[a] + 1)
				swaps = -1;
			if (a < t->in)
				place[a]++;
			if (b < t->in)
				place[b]--;
		}
		for (int b = 0; b < t->in && i > 0; b++)
			if (now[b] != place[b] || swaps < 0)
				trace_wrong(point, "branch %d has place %d at station %d, x %.17g, by the "
				            "crossings listed it is %d", b + 1, now[b], i, t->x[i], place[b]);
		memcpy(place, now, (size_t)t->in*sizeof *place);
	}
}

/* --- two sweeps of the same --- */

/* The branch with this order number at station i, in plane (out 0) or out of plane (1); -1: none. */
static inline int trace_at_place(const struct trace *t, int i, int out, int place)
{
	for (int b = out ? t->in : 0; b < (out ? t->branches : t->in); b++)
		if (t->place[i*t->branches + b] == place)
			return b;
	return -1;
}

/* 1: at station i branch b is within 1e-8 of another in-plane branch. */
static inline int trace_close(const struct trace *t, int i, int b)
{
	const double *omega = t->omega + i*t->branches;

	for (int c = 0; c < t->in; c++)
		if (c != b && fabs(omega[c]/omega[b] - 1.0) < 1e-8)
			return 1;
	return 0;
}

/* Each branch of t must be a branch of `other` at all requested points that both have. `other` has
 * `step` times as many steps; a negative step means the opposite direction. Returns the number of
 * branches compared. */
static inline int trace_same(struct sweep_point *point, const struct trace *t,
                             const struct trace *other, int step)
{
	int compared = 0;

	for (int b = 0; b < t->branches; b++) {
		int partner = -1, out = b >= t->in;

		for (int k = 0; k < t->points; k++) {
			int i = t->asked[k];
			int j = other->asked[step < 0 ? other->points - 1 - k : k*step];

			if (t->moved[i] != 0.0 || other->moved[j] != 0.0 || trace_close(t, i, b))
				continue;
			if (partner < 0)
				partner = trace_at_place(other, j, out, t->place[i*t->branches + b]);
			if (partner < 0)
				break;
			if (other->place[j*other->branches + partner] != t->place[i*t->branches + b])
				trace_wrong(point, "branch %d has place %d at point %d (x %.17g), place %d with "
				            "%d times the steps", b, t->place[i*t->branches + b], k, t->x[i],
				            other->place[j*other->branches + partner], step);
		}
		compared += partner >= 0;
		if (step > 0 && partner >= 0 && partner != b && t->moved[0] == 0.0)
			trace_wrong(point, "branch %d is branch %d with %d times the steps", b, partner, step);
	}
	return compared;
}

#endif
