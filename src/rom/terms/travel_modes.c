/* rom/terms/travel_modes.c - coordinates of a travelling cable with the gyroscopic forces on the modes
 * that are not kept.
 *
 *    G, nu      integrals of Phi_j . Phi_k', and the scaled speed (travel.c)
 *    z_k        static response of the condensed modes to the force Phi_k' (follow.h)
 *    S_jk       integral of Phi_j' . z_k, the sum of G_js G_ks/w_s^2 over the modes s that are not kept
 *    y, lambda  K y = lambda (1 + 4 nu^2 S) y
 *
 * A kept mode that moves pulls the others by -2 nu u.' Phi_k'; they follow by -2 nu z_k u.', and their
 * velocity pulls the kept ones by -4 nu^2 S u.. to first order: a mass, which lowers all frequencies.
 * Without it those of n modes are too high by n^-3. Shapes sum y_j Phi_j, for which this mass and the
 * stiffness are diagonal, take the place of the modes; they span the same space, so that all else is as
 * for modes. Each takes the place of the mode that it has most of, and its plane, number and symmetry.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/hold.h"
#include "core/report.h"
#include "modes/label.h"
#include "rom/condense/follow.h"
#include "rom/terms/travel.h"

/* p of the force Phi_k', by parts: its work on v is that of -Phi_k on v'. */
static void pull(struct hawser__stations *stations, int k)
{
	for (int i = 0; i < stations->count; i++) {
		double *p = stations->p + 3*i;

		hawser_modes_at(stations->modes, p, NULL, k, stations->s[i]);
		for (int c = 0; c < 3; c++)
			p[c] = -p[c];
	}
}

/* M [n][n] = 1 + 4 nu^2 S. */
static enum hawser_status inertia(double *M, const struct hawser_modes *modes,
                                  struct hawser_report *report)
{
	struct hawser__stations stations;
	enum hawser_status status = hawser__stations_make(&stations, modes, modes->n, NULL, 0, report);
	size_t n = (size_t)modes->n, width = status ? 0 : 3*(size_t)stations.count;
	double *all = malloc((n*width + 1)*sizeof *all), nu = modes->statics.motion.nu;

	if (!status && !all)
		status = hawser__no_memory(report, "rom");
	for (size_t k = 0; !status && k < n; k++) {
		pull(&stations, (int)k);
		memcpy(all + k*width, stations.p, width*sizeof *all);
	}
	for (size_t k = 0; !status && k < n; k++) {
		memcpy(stations.p, all + k*width, width*sizeof *all);
		hawser__follow(&stations);
		for (size_t j = 0; j < n; j++) {
			double sum = 0.0;

			for (size_t i = 0; i < width; i++)
				sum += stations.place[i/3].weight*all[j*width + i]*stations.z[i];
			M[j*n + k] = 4.0*nu*nu*sum + (j == k ? 1.0 : 0.0);
		}
	}
	free(all);
	hawser__stations_clear(&stations);
	return status;
}

struct work {
	double *M, *K, *lambda, *y; /* y [n]: a shape as a sum of all modes */
	char *taken;                /* [n] places */
	struct hawser__hold hold;
};

/* The place of the mode own[m] that y has most of, among those not taken. */
static int most_of(struct work *w, const int *own, int m)
{
	int best = -1;

	for (int j = 0; j < m; j++)
		if (!w->taken[own[j]] && (best < 0 || fabs(w->y[own[j]]) > fabs(w->y[best])))
			best = own[j];
	w->taken[best] = 1;
	return best;
}

/* Shape y takes the place `to`. */
static void place(struct hawser_modes *with, double *turned, const struct hawser_modes *modes,
                  const double *y, double lambda, int to)
{
	size_t row = 3*(size_t)modes->grid.points;
	double sign = y[to] < 0.0 ? -1.0 : 1.0, *shape = with->shape + (size_t)to*row;
	double *slope = with->slope + (size_t)to*row;

	memset(shape, 0, row*sizeof *shape);
	memset(slope, 0, row*sizeof *slope);
	for (int j = 0; j < modes->n; j++) {
		cblas_daxpy((int)row, sign*y[j], modes->shape + (size_t)j*row, 1, shape, 1);
		cblas_daxpy((int)row, sign*y[j], modes->slope + (size_t)j*row, 1, slope, 1);
		turned[j*modes->n + to] = sign*y[j];
	}
	with->mode[to].omega = sqrt(lambda);
}

/* The shapes of one plane, of which the modes own[m] are; all [n][n] is the mass. */
static enum hawser_status turn(struct hawser_modes *with, double *turned,
                               const struct hawser_modes *modes, const int *own, int m,
                               const double *all, struct work *w, struct hawser_report *report)
{
	int n = modes->n;
	lapack_int info;

	for (int j = 0; j < m; j++)
		for (int k = 0; k < m; k++) {
			w->M[j*m + k] = all[own[j]*n + own[k]];
			w->K[j*m + k] = j == k ? pow(modes->mode[own[j]].omega, 2) : 0.0;
		}
	info = m > 0 ? LAPACKE_dsygv(LAPACK_COL_MAJOR, 1, 'V', 'U', m, w->K, m, w->M, m, w->lambda) : 0;
	if (info)
		return hawser__lapack_starved(info) ? hawser__no_memory(report, "rom")
		       : hawser__fail(report, HAWSER_ERR_NAN, "rom", "the eigenvalue solver met a "
		                      "not-a-number with %d modes: check EA, rho, d, the speed and the "
		                      "tension of the span", m);
	for (int e = 0; e < m; e++) {
		memset(w->y, 0, (size_t)n*sizeof *w->y);
		for (int j = 0; j < m; j++)
			w->y[own[j]] = w->K[e*m + j];
		place(with, turned, modes, w->y, w->lambda[e], most_of(w, own, m));
	}
	return HAWSER_OK;
}

/* Not where the speed changes: the mass would too, and its mean alone moves boundaries of stability by
 * more than both together. Nor of the shapes of complex modes, in whose space the gyroscopic forces
 * are complete. */
static int carries(const struct hawser_modes *modes, const struct hawser_scene *scene)
{
	const struct hawser_motion *motion = &modes->statics.motion;

	return scene && scene->model.condense == HAWSER_CONDENSE_STATIC &&
	       scene->model.inertia != HAWSER_INERTIA_NONE && motion->nu != 0.0 && motion->swing == 0.0 &&
	       !(scene->travel.braking > 0.0) && !modes->gyroscopic && !modes->spanned;
}

enum hawser_status hawser__travel_modes(struct hawser_modes *with, double **turned,
                                        const struct hawser_modes *modes,
                                        const struct hawser_scene *scene, struct hawser_report *report)
{
	size_t n = (size_t)modes->n;
	struct work w = {.y = NULL};
	double *all;
	int *own;
	enum hawser_status status;

	*with = (struct hawser_modes){.n = 0};
	*turned = NULL;
	if (!carries(modes, scene))
		return HAWSER_OK;
	all = hawser__hold(&w.hold, n*n, sizeof *all);
	own = hawser__hold(&w.hold, n, sizeof *own);
	w.M = hawser__hold(&w.hold, n*n, sizeof *w.M);
	w.K = hawser__hold(&w.hold, n*n, sizeof *w.K);
	w.lambda = hawser__hold(&w.hold, n, sizeof *w.lambda);
	w.y = hawser__hold(&w.hold, n, sizeof *w.y);
	w.taken = hawser__hold(&w.hold, n, 1);
	*turned = calloc(n*n, sizeof **turned);
	status = w.hold.short_of_memory || !*turned ? hawser__no_memory(report, "rom")
	         : hawser__modes_extend(with, modes, 0, report);
	if (!status)
		status = inertia(all, modes, report);
	for (int plane = HAWSER_IN_PLANE; !status && plane <= HAWSER_OUT_OF_PLANE; plane++) {
		int m = 0;

		for (int j = 0; j < modes->n; j++)
			if ((int)modes->mode[j].plane == plane)
				own[m++] = j;
		status = turn(with, *turned, modes, own, m, all, &w, report);
	}
	hawser__hold_clear(&w.hold);
	if (status)
		hawser_modes_clear(with);
	return status;
}
