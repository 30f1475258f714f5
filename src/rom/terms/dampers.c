/* rom/terms/dampers.c - dampers at points of the cable.
 *
 *   h_i    axis of damper i, c_i its coefficient (scaled by sqrt(rho H)), s_i its point
 *   D_jk   sum of c_i (h_i.Phi_j(s_i)) (h_i.Phi_k(s_i))
 *   z_i    static displacement of the modes that are not kept by a unit force along h_i at s_i
 *
 * The force of a damper makes a kink, which a few modes do not have: with modes alone the damping of
 * the first mode of a stay converges as 1/n, and the optimal size of the damper is far off. The
 * displacements z_i have the kink. Their vibration modes in the space of all z_i, which are
 * orthogonal to the kept modes with respect to mass and stiffness, become further coordinates, and
 * the damping of the lower modes converges as 1/n^3 (mode acceleration; for a damper on a taut string
 * J. A. Main, N. P. Jones, J. Eng. Mech. 128 (2002) 1062, S. Krenk, J. Appl. Mech. 67 (2000) 772).
 *
 * The damper of an absorber and its cubic spring pull at the stroke s: their unit force has the static
 * response s = 1/k without any displacement of the cable, of which the part of the kept modes is
 * removed, too.
 *
 * The work of the force on a displacement v is that of -h_i on v' beyond s_i, and of h_i on v at
 * end B, which moves if it is on springs.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/hold.h"
#include "core/report.h"
#include "modes/grid.h"
#include "modes/label.h"
#include "rom/terms/absorbers.h"
#include "rom/condense/bend.h"
#include "rom/build/build.h"
#include "rom/terms/dampers.h"
#include "rom/condense/follow.h"

enum { MOST = 4*HAWSER_ATTACH_MAX, STROKE = 3, MARKS = HAWSER_ATTACH_MAX + 2 };
/* Squared frequencies above this multiple of the lowest one belong to shapes that are linear
 * combinations of the others up to round-off. */
static const double dependent = 1e12;

int hawser__has_dampers(const struct hawser_statics *st)
{
	int any = 0;

	for (int i = 0; i < st->attachments; i++)
		for (int c = 0; c < 3; c++)
			any |= st->attached[i].damper[c] > 0.0;
	return any;
}

int hawser__has_springs(const struct hawser_statics *st)
{
	int any = 0;

	for (int i = 0; i < st->attachments; i++)
		for (int c = 0; c < 3; c++)
			any |= st->attached[i].spring[c] > 0.0;
	return any;
}

/* to [n][n] += for every point of label.h the sum over axes of factor[axis] times the displacements
 * of two modes. */
static void add_points(double *to, const struct hawser_modes *modes,
                       double (*factor)(const struct hawser_statics *st, int i, int axis,
                                        double value), double value)
{
	const struct hawser_statics *st = &modes->statics;
	int n = modes->n;

	for (int i = 0; i < hawser__points(st); i++)
		for (int j = 0; j < n; j++) {
			double u[3], v[3];

			hawser__modes_attached(u, modes, j, i);
			hawser_statics_to_global(st, u, u);
			for (int k = 0; k < n; k++) {
				hawser__modes_attached(v, modes, k, i);
				hawser_statics_to_global(st, v, v);
				for (int c = 0; c < 3; c++)
					to[j*n + k] += factor(st, i, c, value)*u[c]*v[c];
			}
		}
}

static double damping(const struct hawser_statics *st, int i, int axis, double alpha)
{
	double drag = alpha*hawser__point_bare(st, i); /* D has it, but still air acts on the cable only */

	return i < st->attachments ? st->attached[i].damper[axis]/sqrt(st->span.rho*st->H) - drag : -drag;
}

static double stiffness(const struct hawser_statics *st, int i, int axis, double unused)
{
	double k = i < st->attachments ? st->attached[i].spring[axis]
	                               : st->held[i - st->attachments].stiffness[axis];

	(void)unused;
	return isfinite(k) ? k*st->span.d/st->H : 0.0;
}

void hawser__dampers_add(double *D, const struct hawser_modes *modes, double alpha)
{
	add_points(D, modes, damping, alpha);
}

void hawser__springs_add(double *K, const struct hawser_modes *modes)
{
	add_points(K, modes, stiffness, 0.0);
}

/* --- shapes --- */

struct work {
	const struct hawser_modes *modes;
	struct hawser__stations stations;   /* the points of the grid */
	struct hawser__reference reference;
	int count, points;
	double *shape, *slope;  /* [count][points][3] in the local frame */
	double *kink;           /* [count][MARKS][3] along x, y, z at the points of label.h */
	double *start;          /* [count][3] the same of end A */
	double *stroke;         /* [count][HAWSER_ATTACH_MAX] of absorbers */
	double *along;          /* [2][3][points] */
	double *bent;           /* [count] rows of bend.h */
	struct hawser__hold hold;
};

static int work_make(struct work *work)
{
	size_t count = (size_t)work->count, points = (size_t)work->points;

	work->shape = hawser__hold(&work->hold, 3*count*points, sizeof *work->shape);
	work->slope = hawser__hold(&work->hold, 3*count*points, sizeof *work->slope);
	work->kink = hawser__hold(&work->hold, 3*count*MARKS, sizeof *work->kink);
	work->start = hawser__hold(&work->hold, count, 3*sizeof *work->start);
	work->stroke = hawser__hold(&work->hold, count, HAWSER_ATTACH_MAX*sizeof *work->stroke);
	work->along = hawser__hold(&work->hold, 6*points, sizeof *work->along);
	return !work->hold.short_of_memory;
}

static void work_clear(struct work *work)
{
	hawser__stations_clear(&work->stations);
	hawser__reference_clear(&work->reference);
	hawser__hold_clear(&work->hold);
}

/* Strains and displacement of end A of the response to a unit force along axis at attachment i, or,
 * with the axis STROKE, on the stroke of its absorber. */
static void respond(struct work *work, double *slope, double *start, int i, int axis)
{
	const struct hawser_statics *st = &work->modes->statics;

	for (int p = 0; p < work->points; p++) {
		struct hawser_frame_point at = hawser_statics_frame(st, work->stations.s[p]);
		double h = work->stations.s[p] > st->attached[i].s ? -1.0 : 0.0, *to;

		to = work->stations.p + 3*(size_t)p;
		to[0] = axis == 0 ? h*at.ex : axis == 1 ? h*at.ey : 0.0;
		to[1] = axis == 0 ? -h*at.ey : axis == 1 ? h*at.ex : 0.0;
		to[2] = axis == 2 ? h : 0.0;
	}
	memset(work->stations.beyond, 0, sizeof work->stations.beyond);
	memset(work->stations.load, 0, sizeof work->stations.load);
	*(axis == STROKE ? &work->stations.load[i] : &work->stations.beyond[axis]) = 1.0;
	hawser__follow(&work->stations);
	if (st->elastic)
		memcpy(start, work->stations.start, 3*sizeof *start);
	memcpy(slope, work->stations.z, 3*(size_t)work->points*sizeof *slope);
}

/* Displacement of strains and of end A, at the points of the grid and those of label.h. */
static void integrate(struct work *work, double *shape, double *kink, const double *slope,
                      const double start[3])
{
	const struct hawser_modes *modes = work->modes;
	const struct hawser_statics *st = &modes->statics;
	int points = work->points;
	double *global = work->along, *along = work->along + 3*points;

	for (int p = 0; p < points; p++) {
		struct hawser_frame_point at = hawser_statics_frame(st, modes->grid.s[p]);
		const double *f = slope + 3*p;

		global[p] = f[0]*at.ex - f[1]*at.ey;
		global[points + p] = f[0]*at.ey + f[1]*at.ex;
		global[2*points + p] = f[2];
	}
	for (int c = 0; c < 3; c++) {
		(void)hawser__grid_running(along + c*points, &modes->grid, &work->reference,
		                           global + c*points);
		for (int p = 0; p < points; p++)
			along[c*points + p] += start[c];
		for (int i = 0; i < hawser__points(st); i++)
			hawser__grid_at(kink + 3*i + c, &modes->grid, along + c*points, 1, 1,
			                hawser__point(st, i).s);
	}
	for (int p = 0; p < points; p++) {
		struct hawser_frame_point at = hawser_statics_frame(st, modes->grid.s[p]);
		double x = along[p], y = along[points + p];

		shape[3*p] = x*at.ex + y*at.ey;
		shape[3*p + 1] = y*at.ex - x*at.ey;
		shape[3*p + 2] = along[2*points + p];
	}
}

/* Mass and stiffness of the absorber at attachment i, of two displacements there and their strokes. */
static void add_absorber(double *M, double *K, const struct hawser_statics *st, int i,
                         const double x[3], const double y[3], const double *stroke,
                         const double *other)
{
	const double *a = st->attached[i].absorber_axis;

	for (int c = 0; c < 3; c++)
		*M += st->attached[i].absorber*(x[c] + stroke[i]*a[c])*(y[c] + other[i]*a[c]);
	*K += hawser__absorber_stiffness(st, i)*stroke[i]*other[i];
}

/* Mass and stiffness of the responses, [count][count]. */
static void matrices(const struct work *work, double *mass, double *stiff)
{
	const struct hawser_statics *st = &work->modes->statics;
	const struct hawser__bend *bend = work->stations.bend;
	size_t row = 3*(size_t)work->points, wide = (size_t)hawser__bend_width(bend);

	for (int a = 0; a < work->count && bend; a++)
		hawser__bend_rows(work->bent + (size_t)a*wide, bend, work->slope + (size_t)a*row);
	for (int a = 0; a < work->count; a++)
		for (int b = 0; b < work->count; b++) {
			const double *x = work->shape + a*row, *y = work->shape + b*row;
			const double *v = work->slope + a*row, *w = work->slope + b*row;
			double M = 0.0, K = 0.0;

			for (int p = 0; p < work->points; p++, x += 3, y += 3, v += 3, w += 3) {
				const struct hawser__place *at = &work->stations.place[p];

				M += at->weight*(x[0]*y[0] + x[1]*y[1] + x[2]*y[2]);
				K += at->weight*(v[0]*w[0]/at->eps + at->k*(v[1]*w[1] + v[2]*w[2]));
			}
			x = work->kink + 3*MARKS*a;
			y = work->kink + 3*MARKS*b;
			for (int i = 0; i < hawser__points(st); i++, x += 3, y += 3) {
				M += hawser__point_bare(st, i)*(x[0]*y[0] + x[1]*y[1] + x[2]*y[2]);
				for (int c = 0; c < 3; c++)
					K += stiffness(st, i, c, 0.0)*x[c]*y[c];
				if (i < st->attachments && st->attached[i].absorber > 0.0)
					add_absorber(&M, &K, st, i, x, y, work->stroke + HAWSER_ATTACH_MAX*a,
					             work->stroke + HAWSER_ATTACH_MAX*b);
			}
			for (size_t i = 0; i < wide; i++)
				K += work->bent[(size_t)a*wide + i]*work->bent[(size_t)b*wide + i];
			mass[a*work->count + b] = M;
			stiff[a*work->count + b] = K;
		}
}

/* Append the vibration modes `vector` (columns) with 1/omega^2 mu [count], ascending in mu. */
static enum hawser_status append(struct hawser_modes *with, const struct work *work,
                                 const double *vector, const double *mu, int taken,
                                 struct hawser_report *report)
{
	size_t row = 3*(size_t)work->points;
	int n = work->modes->n;
	enum hawser_status status = hawser__modes_extend(with, work->modes, taken, report);

	for (int k = 0; !status && k < taken; k++) {
		int column = work->count - 1 - k; /* descending mu: ascending omega */
		struct hawser_mode *mode = &with->mode[n + k];

		for (int a = 0; a < work->count && with->stroke; a++)
			for (int i = 0; i < with->statics.attachments; i++)
				with->stroke[(n + k)*with->statics.attachments + i] +=
					vector[a*work->count + column]*work->stroke[a*HAWSER_ATTACH_MAX + i];
		for (int a = 0; a < work->count; a++)
			for (size_t i = 0; i < row; i++) {
				double part = vector[a*work->count + column];

				with->shape[(size_t)(n + k)*row + i] += part*work->shape[a*row + i];
				with->slope[(size_t)(n + k)*row + i] += part*work->slope[a*row + i];
			}
		mode->omega = 1.0/sqrt(mu[column]);
		mode->place = n + k + 1;
		(void)hawser__mode_label(with, n + k);
		mode->plane = mode->out_of_plane_share > 0.5 ? HAWSER_OUT_OF_PLANE : HAWSER_IN_PLANE;
	}
	return status;
}

static enum hawser_status vibrate(struct hawser_modes *with, const struct work *work,
                                  struct hawser_report *report)
{
	int count = work->count, taken = 0;
	size_t square = (size_t)count*(size_t)count;
	double *mass = malloc(2*square*sizeof *mass), *stiff = mass + square;
	double mu[MOST];
	enum hawser_status status = mass ? HAWSER_OK : hawser__no_memory(report, "rom");

	if (status)
		return status;
	matrices(work, mass, stiff);
	if (LAPACKE_dsygv(LAPACK_ROW_MAJOR, 1, 'V', 'L', count, mass, count, stiff, count, mu))
		status = hawser__fail(report, HAWSER_ERR_NAN, "rom",
		                      "the static shapes of the dampers' forces are linearly dependent or "
		                      "not finite: move dampers apart, or keep fewer modes");
	while (!status && taken < count &&
	       mu[count - 1 - taken]*dependent > mu[count - 1] && mu[count - 1 - taken] > 0.0)
		taken++;
	if (!status && taken > 0)
		status = append(with, work, mass, mu, taken, report);
	free(mass);
	return status;
}

enum hawser_status hawser__dampers_extend(struct hawser_modes *with,
                                          const struct hawser_modes *modes,
                                          struct hawser_report *report)
{
	const struct hawser_statics *st = &modes->statics;
	struct work work = {.modes = modes, .points = modes->grid.points};
	int axis[MOST], at[MOST];
	enum hawser_status status;

	*with = (struct hawser_modes){.n = 0};
	for (int i = 0; i < st->attachments; i++)
		for (int c = 0; c <= STROKE; c++)
			if (c == STROKE ? hawser__absorber_forced(st, i) : st->attached[i].damper[c] > 0.0) {
				at[work.count] = i;
				axis[work.count++] = c;
			}
	if (work.count == 0)
		return HAWSER_OK;
	status = work_make(&work) ? HAWSER_OK : hawser__no_memory(report, "rom");
	if (!status)
		status = hawser__stations_make(&work.stations, modes, modes->n, NULL, 0, report);
	if (!status)
		status = hawser__reference_init(&work.reference, &modes->grid, modes->grid.order - 1,
		                                report);
	if (!status && work.stations.bend) {
		work.bent = hawser__hold(&work.hold, (size_t)work.count*
		                         (size_t)hawser__bend_width(work.stations.bend), sizeof *work.bent);
		status = work.bent ? HAWSER_OK : hawser__no_memory(report, "rom");
	}
	for (int a = 0; !status && a < work.count; a++) {
		size_t row = (size_t)a*3*(size_t)work.points;
		double *start = work.start + 3*(size_t)a;

		respond(&work, work.slope + row, start, at[a], axis[a]);
		memcpy(work.stroke + a*HAWSER_ATTACH_MAX, work.stations.stroke, sizeof work.stations.stroke);
		integrate(&work, work.shape + row, work.kink + (size_t)a*3*MARKS, work.slope + row, start);
	}
	if (!status)
		status = vibrate(with, &work, report);
	work_clear(&work);
	if (status)
		hawser_modes_clear(with);
	return status;
}

static enum hawser_status rigid_only(const struct hawser_scene *scene, struct hawser_report *report)
{
	if (scene->model.modes == HAWSER_MODES_AUTO)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
		                    "model.modes: auto does not know elastic supports: give a number of modes");
	return HAWSER_OK;
}

enum hawser_status hawser__rom_attached(struct hawser_modes *with, const struct hawser_modes *modes,
                                        const struct hawser_scene *scene,
                                        struct hawser_report *report)
{
	const struct hawser_statics *st = &modes->statics;
	enum hawser_status status = hawser__rom_real(modes, report);

	*with = (struct hawser_modes){.n = 0};
	if (!status && st->elastic && scene)
		status = rigid_only(scene, report);
	if (status || !scene || st->attachments == 0 || !(st->epsilon > 0.0))
		return status;
	if (scene->model.modes == HAWSER_MODES_AUTO && modes->stroke)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
		                    "model.modes: auto does not know absorbers of attachments: give a number "
		                    "of modes");
	if (scene->model.modes == HAWSER_MODES_AUTO && hawser__has_dampers(st))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
		                    "model.modes: auto does not know dampers of attachments: give a number "
		                    "of modes");
	return hawser__dampers_extend(with, modes, report);
}
