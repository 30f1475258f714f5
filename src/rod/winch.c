/* rod/winch.c - length in time of a rod with a winch, and the mesh of that length (motion.h).
 *
 * Between rows of speeds the acceleration is that of spins (drive.c), (v1 - v0)/T (1 - cos(2 pi t/T)),
 * so that l, l' and l'' are continuous. Lengths have the cubic spline whose speed is 0 at both ends.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "rod/motion.h"
#include "rod/so3.h"

enum { LOOKED = 4096 };  /* times of a run at which the length is looked at before it */
#define LEAST 0.05       /* of the length at t = 0: the default of `least` */
#define TURN 6.28318530717958647692 /* 2 pi, to the digits of a double */

/* --- length in time --- */

/* What a change of speed from v0 to v1 in T has paid out after t <= T, and its derivatives. */
static void change(double l[3], double v0, double v1, double T, double t)
{
	double p = TURN/T, by = (v1 - v0)/T;

	l[0] = v0*t + by*(0.5*t*t - (1.0 - cos(p*t))/(p*p));
	l[1] = v0 + by*(t - sin(p*t)/p);
	l[2] = by*(1.0 - cos(p*t));
}

static void by_speeds(double l[3], const struct hawser__rod_winch *winch, double t)
{
	const double (*row)[2] = (const double (*)[2])winch->as->row;
	int n = winch->as->rows, i = 0;

	while (i < n && row[i][0] <= t)
		i++;
	l[2] = 0.0;
	if (i == 0 || i == n) {
		int at = i ? n - 1 : 0;

		l[1] = row[at][1];
		l[0] = winch->curve[at] + l[1]*(t - row[at][0]);
		return;
	}
	change(l, row[i - 1][1], row[i][1], row[i][0] - row[i - 1][0], t - row[i - 1][0]);
	l[0] += winch->curve[i - 1];
}

static void by_lengths(double l[3], const struct hawser__rod_winch *winch, double t)
{
	const double (*row)[2] = (const double (*)[2])winch->as->row;
	const double *curve = winch->curve;
	int n = winch->as->rows, i = 0;
	double h, a, b;

	while (i < n && row[i][0] <= t)
		i++;
	l[1] = l[2] = 0.0;
	l[0] = row[i ? n - 1 : 0][1];
	if (i == 0 || i == n)
		return;
	h = row[i][0] - row[i - 1][0];
	b = (t - row[i - 1][0])/h;
	a = 1.0 - b;
	l[0] = a*row[i - 1][1] + b*row[i][1] +
	       h*h/6.0*((a*a*a - a)*curve[i - 1] + (b*b*b - b)*curve[i]);
	l[1] = (row[i][1] - row[i - 1][1])/h +
	       h/6.0*((1.0 - 3.0*a*a)*curve[i - 1] + (3.0*b*b - 1.0)*curve[i]);
	l[2] = a*curve[i - 1] + b*curve[i];
}

void hawser__rod_winch_at(double l[3], const struct hawser__rod_winch *winch, double t)
{
	const struct hawser_rod_winch *as = winch->as;

	if (as->rows && as->lengths) {
		by_lengths(l, winch, t);
	} else if (as->rows) {
		by_speeds(l, winch, t);
	} else if (t - winch->from < as->rise) {
		change(l, 0.0, as->speed, as->rise, t - winch->from);
		l[0] += winch->first;
	} else {
		l[0] = winch->first + as->speed*(t - winch->from - 0.5*as->rise);
		l[1] = as->speed;
		l[2] = 0.0;
	}
}

/* Second derivatives of the spline at its rows, by elimination; work [rows]. */
static void spline(double *curve, double *work, const double (*row)[2], int n)
{
	double h = row[1][0] - row[0][0], slope = (row[1][1] - row[0][1])/h;

	work[0] = 0.5;
	curve[0] = 3.0*slope/h;
	for (int i = 1; i < n; i++) {
		double before = h, last = slope, pivot;

		h = i < n - 1 ? row[i + 1][0] - row[i][0] : 0.0;
		slope = i < n - 1 ? (row[i + 1][1] - row[i][1])/h : 0.0;
		pivot = 2.0*(before + h) - before*work[i - 1];
		work[i] = h/pivot;
		curve[i] = (6.0*(slope - last) - before*curve[i - 1])/pivot;
	}
	for (int i = n - 2; i >= 0; i--)
		curve[i] -= work[i]*curve[i + 1];
}

/* curve, and for speeds the length at each row, with the first one at t = 0. */
static enum hawser_status rows(struct hawser__rod_winch *winch, struct hawser_report *report)
{
	const struct hawser_rod_winch *as = winch->as;
	double *work = calloc((size_t)as->rows + 1, sizeof *work), at[3];

	winch->curve = hawser__hold(&winch->hold, (size_t)as->rows + 1, sizeof *winch->curve);
	if (!work || winch->hold.short_of_memory) {
		free(work);
		return hawser__no_memory(report, "rod");
	}
	if (as->lengths && as->rows)
		spline(winch->curve, work, (const double (*)[2])as->row, as->rows);
	for (int i = 1; i < as->rows && !as->lengths; i++)
		winch->curve[i] = winch->curve[i - 1] + 0.5*(as->row[i][0] - as->row[i - 1][0])*
		                                        (as->row[i][1] + as->row[i - 1][1]);
	if (as->rows && !as->lengths) {
		by_speeds(at, winch, winch->from);
		for (int i = 0; i < as->rows; i++)
			winch->curve[i] += winch->first - at[0];
	}
	free(work);
	return HAWSER_OK;
}

/* --- memory --- */

/* The run is looked at before it begins: the length must be `least` or more. */
static enum hawser_status long_enough(const struct hawser__rod_winch *winch, double until,
                                      struct hawser_report *report)
{
	double least = winch->as->least > 0.0 ? winch->as->least : LEAST*winch->first, l[3];

	for (int i = 0; i <= LOOKED; i++) {
		double t = winch->from + (until - winch->from)*i/LOOKED;

		hawser__rod_winch_at(l, winch, t);
		if (!(l[0] >= least))
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rod", "at %.6g s the winch leaves %.6g "
			                    "m of the first segment, less than %.6g m: end the run before, haul in "
			                    "less, or give a smaller winch.least", t, l[0], least);
	}
	return HAWSER_OK;
}

enum hawser_status hawser__rod_winch_open(struct hawser__rod_winch *winch,
                                          const struct hawser__rod_mesh *mesh, double from,
                                          double until, struct hawser_report *report)
{
	const struct hawser_rod *rod = mesh->rod;
	double s = 0.0, l[3];
	enum hawser_status status;

	memset(winch, 0, sizeof *winch);
	if (!rod->winch.on)
		return HAWSER_OK;
	while (winch->elements < mesh->elements && mesh->segment[winch->elements] == 0)
		winch->elements++;
	winch->from = from;
	winch->first = rod->segment[0].length;
	winch->part = hawser__hold(&winch->hold, (size_t)winch->elements, sizeof *winch->part);
	winch->left = hawser__hold(&winch->hold, (size_t)winch->elements + 1, sizeof *winch->left);
	winch->slip = hawser__hold(&winch->hold, (size_t)mesh->nodes, sizeof *winch->slip);
	winch->slip0 = hawser__hold(&winch->hold, (size_t)mesh->nodes, sizeof *winch->slip0);
	winch->as = &rod->winch;
	if (winch->hold.short_of_memory)
		return hawser__no_memory(report, "rod");
	for (int e = 0; e < winch->elements; e++) {
		winch->left[e] = 1.0 - s;
		winch->part[e] = mesh->element[e].h/winch->first;
		s += winch->part[e];
	}
	status = rows(winch, report);
	if (status)
		return status;
	hawser__rod_winch_at(l, winch, from);
	if (fabs(l[0] - winch->first) > 1e-9*winch->first)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rod", "winch.lengths: at %.9g s it is %.9g "
		                    "m, and the first segment has %.9g m: make them the same", from, l[0],
		                    winch->first);
	return long_enough(winch, until, report);
}

enum hawser_status hawser__rod_winch_same(const struct hawser__rod_motion *motion, double length,
                                          const char *path, struct hawser_report *report)
{
	if (!motion->winch.as || fabs(motion->winch.length - length) <= 1e-9*length)
		return HAWSER_OK;
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rod", "%s is a state with %.9g m of the "
	                    "first segment at %g s, and with this winch it has %.9g m then: give the winch "
	                    "of the first run", path, length, motion->t, motion->winch.length);
}

void hawser__rod_winch_clear(struct hawser__rod_winch *winch)
{
	hawser__hold_clear(&winch->hold);
	memset(winch, 0, sizeof *winch);
}

/* --- the mesh --- */

void hawser__rod_winch_set(struct hawser__rod_motion *motion, double t)
{
	struct hawser__rod_winch *winch = &motion->winch;
	struct hawser__rod_mesh *mesh = motion->mesh;
	double l[3], s = 0.0;

	if (!winch->as)
		return;
	hawser__rod_winch_at(l, winch, t);
	winch->length = l[0];
	winch->speed = l[1];
	winch->rate = l[2];
	for (int e = 0; e < winch->elements; e++)
		hawser__rod_stretch(&mesh->element[e], winch->part[e]*l[0]);
	for (int e = 0; e < mesh->elements; e++)
		mesh->s[e + 1] = s += mesh->element[e].h;
	hawser__rod_motion_masses(motion);
}

/* --- the beginning --- */

/* The rod at rest: its nodes go along its curve, and beyond the segment it moves as a rigid body. If
 * the end is held, the difference is shared out along the rod. */
static void begin_at_rest(struct hawser__rod_motion *motion)
{
	struct hawser__rod_mesh *mesh = motion->mesh;
	const struct hawser__rod_winch *winch = &motion->winch;
	int n = winch->elements, last = mesh->nodes - 1;
	const double *turn = mesh->element[n - 1].k0;
	double w[3], R[9], end[2][3], to[3];

	memcpy(end[0], motion->velocity[0], sizeof end[0]);
	memcpy(end[1], motion->velocity[last], sizeof end[1]);
	hawser__quaternion_matrix(R, mesh->node[n].q);
	hawser__apply(w, R, turn);
	for (int i = 0; i < mesh->nodes; i++) {
		double speed = winch->speed*(i < n ? 1.0 - winch->left[i] : 1.0), own[9], arm[3], v[3] = {0.0};
		double spin[3];

		hawser__quaternion_matrix(own, mesh->node[i].q);
		for (int k = 0; k < 3; k++)
			arm[k] = mesh->node[i].x[k] - mesh->node[n].x[k];
		if (i > n)
			hawser__cross(v, w, arm);
		hawser__apply_left(spin, own, w);
		for (int k = 0; k < 3; k++) {
			motion->velocity[i][k] += speed*((i > n ? R : own)[3*k] + v[k]);
			motion->velocity[i][3 + k] += speed*(i > n ? spin[k] : turn[k]);
		}
	}
	memcpy(to, motion->velocity[last], sizeof to);
	for (int i = 1; i <= last && mesh->held[HAWSER__ROD_FREE*last]; i++)
		for (int k = 0; k < 3; k++) {
			double part = mesh->s[i]/mesh->s[last];

			motion->velocity[i][k] += (1.0 - part)*end[0][k] + part*(end[1][k] - to[k]);
		}
}

/* Derivative of what is not balanced by the length, mesh->r. */
static void by_length(struct hawser__rod_motion *motion)
{
	struct hawser__rod_mesh *mesh = motion->mesh;
	const struct hawser__rod_winch *winch = &motion->winch;
	double f[HAWSER__ROD_PAIR];

	memset(mesh->sum, 0, (size_t)mesh->nodes*sizeof *mesh->sum);
	for (int e = 0; e < winch->elements; e++)
		for (int k = 0; k < 2; k++)
			hawser__rod_force_add(&mesh->sum[e + k], &mesh->line[e], 0.5*winch->part[e]);
	for (int i = 0; i < mesh->nodes; i++)
		hawser__rod_load(mesh->r + (long)HAWSER__ROD_FREE*i, mesh, i);
	for (int e = 0; e < winch->elements; e++) {
		struct hawser__rod_strain by = mesh->strain[e];

		/* forces are linear in N and M, which change with h; h (N x w) changes with N alone */
		hawser__rod_strain_by_length(&by, &mesh->element[e]);
		hawser__rod_forces(f, NULL, &mesh->element[e], &by);
		for (int i = 0; i < HAWSER__ROD_PAIR; i++)
			mesh->r[HAWSER__ROD_FREE*e + i] -= winch->part[e]*f[i];
	}
	hawser__rod_loads(mesh, motion->factor, 1.0);
}

int hawser__rod_winch_begin(struct hawser__rod_motion *motion, int rest)
{
	struct hawser__rod_mesh *mesh = motion->mesh;
	int both = mesh->held[mesh->n - HAWSER__ROD_FREE]; /* else the rod moves with its start */

	if (!motion->winch.as || motion->winch.speed == 0.0)
		return 0;
	hawser__rod_motion_hold(motion, motion->t);
	if (rest) {
		begin_at_rest(motion);
		return 0;
	}
	if (hawser__rod_strains(mesh) >= 0)
		return 1;
	hawser__rod_tangent(mesh);
	by_length(motion);
	for (int i = 0; i < mesh->n; i++)
		if (mesh->held[i]) {
			double speed = motion->velocity[i/HAWSER__ROD_FREE][i % HAWSER__ROD_FREE];

			mesh->r[i] = hawser__band_hold(&mesh->band, i)*(both ? speed/motion->winch.speed : 0.0);
		}
	if (hawser__band_factor(&mesh->band))
		return 1;
	hawser__band_solve(&mesh->band, mesh->r);
	for (int i = 0; i < mesh->n; i++) {
		double *velocity = &motion->velocity[i/HAWSER__ROD_FREE][i % HAWSER__ROD_FREE];

		if (!isfinite(mesh->r[i]))
			return 1;
		*velocity += mesh->held[i] ? 0.0 : motion->winch.speed*mesh->r[i];
	}
	return 0;
}
