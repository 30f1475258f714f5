/* net/modes/modes-label.c - what the modes of a net are with respect to its symmetry; see symmetry.h.
 *
 * P      a map of the net onto itself as a matrix: (P*x) at a node's partner is map*(x at the node)
 * p_ij   x_i'*M*P*x_j. Of a mode alone, p is 1 if it is symmetric and -1 if it is antisymmetric; for a
 *        turn by 2*pi/n, p = cos(2*pi*waves/n)
 *
 * Any vectors that span the modes of one frequency are such modes. P takes them to each other, and the
 * planes are at right angles, so that their maps commute, also with the sum of a turn and its
 * opposite: the eigenvectors of 8*p(plane) + 4*p(mirror 1) + 2*p(mirror 2) + p(mirror 3) +
 * (p(turn) + p(turn)')/4 are symmetric or antisymmetric to each plane and have one number of waves. A
 * trace of K is added, so that frequencies that are not quite equal stay apart where nothing else
 * decides.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <cblas.h>
#include <lapacke.h>

#include "core/hold.h"
#include "core/report.h"
#include "net/modes/symmetry.h"

enum { COLUMN = 102 /* LAPACK_COL_MAJOR */ };
static const double sure = 0.98;    /* parity of a mode that is symmetric: 99 % of its energy */
static const double closest = 1e-8; /* least relative difference of omega^2 of two frequencies */
static const double loosest = 1e-6; /* and the largest, where the symmetry holds less well */
static const double trace = 1e-3;   /* weight of K in the choice, over the loosest difference */
static const double same_turn = 0.02; /* difference of p from cos(2*pi*waves/n) */

const char *hawser_net_side(double parity)
{
	return isnan(parity) ? NULL : parity >= sure ? "symmetric" : parity <= -sure ? "antisymmetric"
		: "mixed";
}

const char *hawser_net_plane_side(double parity)
{
	return parity >= sure ? "in-plane" : parity <= -sure ? "out-of-plane" : NULL;
}

/* y = P*x. */
static void apply(double *y, const double *x, const struct hawser__mesh *mesh,
                  const struct hawser__net_map *map)
{
	for (int i = 0; i < mesh->nodes; i++) {
		const int *to = mesh->unknown[map->partner[i]];
		double at[3], image[3], axis[3];

		hawser__eigen_place(at, x, mesh, i);
		for (int k = 0; k < 3; k++)
			image[k] = map->map[k][0]*at[0] + map->map[k][1]*at[1] + map->map[k][2]*at[2];
		for (int k = 0; k < 3; k++) {
			hawser__mesh_axis(axis, mesh, map->partner[i], k);
			if (to[k] >= 0)
				y[to[k]] = axis[0]*image[0] + axis[1]*image[1] + axis[2]*image[2];
		}
	}
}

/* p_ij of `count` modes from number `first` on: p [count][count]; work [2][unknowns]. */
static void project(double *p, const struct hawser__eigen *eigen, const struct hawser__net_map *map,
                    int first, int count, double *work)
{
	int n = eigen->mesh->unknowns;
	const double *x = eigen->x + (size_t)first*(size_t)n;

	for (int j = 0; j < count; j++) {
		apply(work, x + (size_t)j*(size_t)n, eigen->mesh, map);
		hawser__eigen_mass(work + n, work, eigen->mesh, 7U);
		cblas_dgemv(CblasColMajor, CblasTrans, n, count, 1.0, x, n, work + n, 1, 0.0, p + j*count, 1);
	}
}

static const struct hawser__net_map *plane_of(const struct hawser__net_maps *maps, int k)
{
	const struct hawser__net_map *map = k == 0 ? &maps->plane : &maps->mirror[k - 1];

	return map->partner ? map : NULL;
}

/* Eigenvectors of that sum, the largest eigenvalue first, in place of the modes. */
static enum hawser_status turn(struct hawser__eigen *eigen, const struct hawser__net_maps *maps,
                               int first, int count, double *work, struct hawser_report *report)
{
	int n = eigen->mesh->unknowns, info;
	size_t q = (size_t)count, size = q*(size_t)n;
	double *sum = calloc(2*q*q + q + size, sizeof *sum), *p = hawser__behind(sum, q*q);
	double *value = hawser__behind(p, q*q), *copy = hawser__behind(value, q);
	double *x = eigen->x + (size_t)first*(size_t)n;
	const double *omega2 = eigen->value + first;

	if (!sum)
		return hawser__no_memory(report, "net");
	for (int k = 0; k <= HAWSER_NET_MIRRORS; k++) {
		if (!plane_of(maps, k))
			continue;
		project(p, eigen, plane_of(maps, k), first, count, work);
		cblas_daxpy(count*count, ldexp(1.0, 3 - k), p, 1, sum, 1);
	}
	if (maps->turn.partner) {
		project(p, eigen, &maps->turn, first, count, work);
		for (int i = 0; i < count*count; i++)
			sum[i] += 0.25*(p[i] + p[i % count*count + i/count]);
	}
	for (int i = 0; i < count; i++)
		sum[i*(count + 1)] -= trace*(omega2[i]/omega2[0] - 1.0)/loosest;
	info = LAPACKE_dsyevd(COLUMN, 'V', 'L', count, sum, count, value);
	if (info == 0) {
		memcpy(copy, x, size*sizeof *x);
		for (int j = 0; j < count; j++)
			cblas_dgemv(CblasColMajor, CblasNoTrans, n, count, 1.0, copy, n,
			            sum + (size_t)(count - 1 - j)*q, 1, 0.0, x + (size_t)j*(size_t)n, 1);
	}
	free(sum);
	return info == 0 ? HAWSER_OK : hawser__lapack_starved(info) ? hawser__no_memory(report, "net")
		: hawser__fail(report, HAWSER_ERR_NAN, "net", "%s: a mode is not a number", eigen->name);
}

/* omega^2 of modes that have been turned, in ascending order where nothing else decides. */
static void measure(struct hawser__eigen *eigen, int first, int count, double *work)
{
	int n = eigen->mesh->unknowns;

	for (int j = first; j < first + count; j++) {
		const double *x = eigen->x + (size_t)j*(size_t)n;
		double energy;

		hawser__eigen_stiffness(work, x, eigen);
		energy = cblas_ddot(n, x, 1, work, 1);
		hawser__eigen_mass(work, x, eigen->mesh, 7U);
		eigen->value[j] = energy/cblas_ddot(n, x, 1, work, 1);
	}
}

static double tolerance_of(const struct hawser__net_maps *maps)
{
	const struct hawser_net_symmetry *found = &maps->found;
	double most = 0.0;

	for (int k = 0; k < found->mirrors; k++)
		most = fmax(most, found->mirror[k].elements);
	return fmin(fmax(closest, 10.0*most), loosest);
}

/* Number of modes that share the frequency of mode `first`. */
static int shared(const struct hawser__eigen *eigen, int first, double tolerance)
{
	int last = first;

	while (last + 1 < eigen->found && eigen->value[last + 1] - eigen->value[last] <=
	       tolerance*eigen->value[last + 1])
		last++;
	return last - first + 1;
}

/* The number of waves around the axis; -1 if the mode is none of one number. */
static int waves_of(double p, int turns)
{
	int waves = (int)lround(acos(fmin(fmax(p, -1.0), 1.0))*turns/(2.0*M_PI));

	return fabs(p - cos(2.0*M_PI*waves/turns)) <= same_turn ? waves : -1;
}

/* Whether modes j and k, of a frequency that `count` modes share, are partners: with turns, modes
 * of the same number of waves, which must be neither 0 nor turns/2; else two modes alone. */
static int are_partners(const int *waves, int j, int k, int count, int turns)
{
	if (waves[j] < 0)
		return count == 2;
	return waves[j] == waves[k] && waves[j] > 0 && 2*waves[j] < turns;
}

static void pairs(struct hawser_net_modes *modes, const int *waves, int first, int count)
{
	for (int j = first; j < first + count && j < modes->n; j++)
		for (int k = j + 1; k < first + count && modes->pair[j] < 0; k++) {
			if (!are_partners(waves, j, k, count, modes->symmetry.turns) ||
			    (k < modes->n && modes->pair[k] >= 0))
				continue;
			modes->pair[j] = k;
			if (k < modes->n)
				modes->pair[k] = j;
		}
}

static enum hawser_status choose(struct hawser__eigen *eigen, const struct hawser__net_maps *maps,
                                 double *work, struct hawser_report *report)
{
	double tolerance = tolerance_of(maps);
	enum hawser_status status = HAWSER_OK;
	int changed = 0;

	for (int first = 0, count; first < eigen->found && !status; first += count) {
		count = shared(eigen, first, tolerance);
		if (count == 1 || (maps->found.mirrors == 0 && !maps->found.flat && !maps->turn.partner))
			continue;
		status = turn(eigen, maps, first, count, work, report);
		if (!status)
			measure(eigen, first, count, work);
		changed = 1;
	}
	return status || !changed ? status : hawser__eigen_bound(eigen, report);
}

enum hawser_status hawser__net_modes_label(struct hawser_net_modes *modes, struct hawser__eigen *eigen,
                                           const struct hawser__net_maps *maps,
                                           struct hawser_report *report)
{
	size_t n = (size_t)eigen->mesh->unknowns;
	double tolerance = tolerance_of(maps), *work = malloc(2*(n + 1)*sizeof *work);
	int *waves = malloc(((size_t)eigen->found + 1)*sizeof *waves);
	enum hawser_status status = work && waves ? choose(eigen, maps, work, report)
		: hawser__no_memory(report, "net");

	for (int j = 0; j < eigen->found && !status; j++) {
		double p;

		waves[j] = -1;
		if (maps->turn.partner) {
			project(&p, eigen, &maps->turn, j, 1, work);
			waves[j] = waves_of(p, maps->found.turns);
		}
		for (int k = 0; k <= HAWSER_NET_MIRRORS && j < modes->n; k++) {
			p = NAN;
			if (plane_of(maps, k))
				project(&p, eigen, plane_of(maps, k), j, 1, work);
			modes->parity[j][k] = p;
		}
		if (j < modes->n) {
			modes->waves[j] = waves[j];
			modes->pair[j] = -1;
		}
	}
	for (int first = 0, count; first < eigen->found && !status; first += count) {
		count = shared(eigen, first, tolerance);
		pairs(modes, waves, first, count);
	}
	free(work);
	free(waves);
	return status;
}
