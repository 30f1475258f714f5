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
#include <cblas.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/hold.h"
#include "core/report.h"
#include "core/vec3.h"
#include "modes/label.h"
#include "rom/terms/absorbers.h"
#include "rom/build/build.h"
#include "rom/terms/dampers.h"
#include "rom/condense/follow.h"
#include "rom/condense/basis.h"
#include "statics/frame.h"

enum { MOST = 4*HAWSER_ATTACH_MAX, STROKE = 3 };
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

static double damping(const struct hawser_statics *st, int i, int axis, double alpha)
{
	double drag = alpha*hawser__point_bare(st, i); /* D has it, but still air acts on the cable only */

	return i < st->attachments ? st->attached[i].damper[axis]/sqrt(st->span.rho*st->H) - drag : -drag;
}

/* Displacement of a mode at point i along x, y, z, or along the axes of its dampers. */
static void displaced(double u[3], const struct hawser_modes *modes, int mode, int i, int of_dampers)
{
	double axis[3][3], global[3];

	hawser__modes_attached(u, modes, mode, i);
	hawser_statics_to_global(&modes->statics, global, u);
	memcpy(u, global, sizeof global);
	if (!of_dampers)
		return;
	hawser_statics_damper(axis, &modes->statics, i);
	for (int c = 0; c < 3; c++)
		u[c] = hawser__dot(axis[c], global);
}

/* to [n][n] += for every point of label.h the sum over axes, of dampers their own, of factor[axis]
 * times the displacements of two modes. */
static void add_points(double *to, const struct hawser_modes *modes,
                       double (*factor)(const struct hawser_statics *st, int i, int axis,
                                        double value), double value)
{
	const struct hawser_statics *st = &modes->statics;
	int n = modes->n;

	for (int i = 0; i < hawser__points(st); i++)
		for (int j = 0; j < n; j++) {
			double u[3], v[3];

			displaced(u, modes, j, i, factor == damping);
			for (int k = 0; k < n; k++) {
				displaced(v, modes, k, i, factor == damping);
				for (int c = 0; c < 3; c++)
					to[j*n + k] += factor(st, i, c, value)*u[c]*v[c];
			}
		}
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
	struct hawser__stations stations;  /* the points of the grid */
	struct hawser__basis basis;    /* a row a force, then one more */
	int count;
};

static void work_clear(struct work *work)
{
	hawser__stations_clear(&work->stations);
	hawser__basis_clear(&work->basis);
}

/* The response to a unit force along axis at attachment i, or, with the axis STROKE, on the stroke of
 * its absorber. */
static void respond(struct work *work, double *row, int i, int axis)
{
	struct hawser__stations *stations = &work->stations;
	const struct hawser_statics *st = &work->modes->statics;
	double own[3][3], pull[3] = {0.0};

	hawser_statics_damper(own, st, i);
	for (int c = 0; c < 3 && axis != STROKE; c++)
		pull[c] = -own[axis][c];
	for (int p = 0; p < stations->count; p++) {
		struct hawser_frame_point at = hawser_statics_frame(st, stations->s[p]);

		memset(stations->p + 3*p, 0, 3*sizeof *stations->p);
		if (stations->s[p] > st->attached[i].s)
			hawser__frame_in(stations->p + 3*p, &at, pull);
	}
	memset(stations->beyond, 0, sizeof stations->beyond);
	memset(stations->load, 0, sizeof stations->load);
	if (axis == STROKE)
		stations->load[i] = 1.0;
	else
		memcpy(stations->beyond, own[axis], sizeof stations->beyond);
	hawser__follow(stations);
	hawser__basis_put(&work->basis, row, stations->z, stations->start, stations->stroke);
}

/* Append the vibration modes `vector` (columns) with 1/omega^2 mu [count], ascending in mu. */
static enum hawser_status append(struct hawser_modes *with, const struct work *work,
                                 const double *vector, const double *mu, int taken,
                                 struct hawser_report *report)
{
	const struct hawser__basis *basis = &work->basis;
	int count = work->count, width = basis->width;
	double *row = basis->row + (size_t)count*(size_t)width;
	enum hawser_status status = hawser__modes_extend(with, work->modes, taken, report);

	for (int k = 0; !status && k < taken; k++) {
		int column = count - 1 - k; /* descending mu: ascending omega */

		cblas_dgemv(CblasRowMajor, CblasTrans, count, width, 1.0, basis->row, width,
		            vector + column, count, 0.0, row, 1);
		hawser__basis_take(with, work->modes->n + k, basis, row, 1.0/sqrt(mu[column]));
	}
	return status;
}

static enum hawser_status vibrate(struct hawser_modes *with, const struct work *work,
                                  struct hawser_report *report)
{
	int count = work->count, taken = 0;
	size_t square = (size_t)count*(size_t)count;
	double *mass = malloc(2*square*sizeof *mass), *stiff = hawser__behind(mass, square);
	double mu[MOST];
	enum hawser_status status = mass ? HAWSER_OK : hawser__no_memory(report, "rom");

	if (status)
		return status;
	status = hawser__basis_products(mass, stiff, &work->basis, count, report);
	if (!status && LAPACKE_dsygv(LAPACK_ROW_MAJOR, 1, 'V', 'L', count, mass, count, stiff, count, mu))
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

/* The modes, followed by the static shapes of the forces of dampers, also of absorbers and of their
 * cubic springs (dampers.c). with->n = 0 if there are none, or no shapes beyond the modes. */
static enum hawser_status dampers_extend(struct hawser_modes *with,
                                         const struct hawser_modes *modes,
                                         struct hawser_report *report)
{
	const struct hawser_statics *st = &modes->statics;
	struct work work = {.modes = modes};
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
	status = hawser__basis_make(&work.basis, modes, work.count + 1, report);
	if (!status)
		status = hawser__stations_make(&work.stations, modes, modes->n, NULL, 0, report);
	for (int a = 0; !status && a < work.count; a++)
		respond(&work, work.basis.row + (size_t)a*(size_t)work.basis.width, at[a], axis[a]);
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
	return dampers_extend(with, modes, report);
}
