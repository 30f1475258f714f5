/* net/modes/symmetry.c - the symmetry of an equilibrium, found from its places; see symmetry.h.
 *
 * c    mean of the places of all nodes of the mesh, which every symmetry keeps
 * C    sum of (x - c)*(x - c)'
 * a    the axis about which turns and mirror planes are sought: the normal of the net's own plane, or
 *      the vertical
 *
 * A node p goes to a node q at the same distance from the axis and the same height. The class of such
 * nodes with the fewest members therefore tells all candidates: the planes half-way between p and each
 * q of its class, the plane through p, and the turns from p to q. The plane at right angles to the
 * axis and those normal to the principal directions of C are candidates too: a plane of symmetry is
 * normal to a principal direction, so that a net without weight may have others. Each candidate is
 * tried node by node and cable by cable (symmetry-map.c).
 *
 * Of many planes through the axis the first is the one across the longest extent of the net, then the
 * one with most nodes in it, so that the choice turns with the net.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <lapacke.h>

#include "core/report.h"
#include "core/vec3.h"
#include "net/modes/symmetry.h"

enum { PLANES = 128, /* planes of symmetry that are compared */
       COLUMN = 102 /* LAPACK_COL_MAJOR */ };
static const double alike = 1e-3;   /* relative difference of second moments that counts as none */
static const double upright = 1e-3; /* cosine of two planes that are at right angles */

struct plane {
	double normal[3], places, elements, extent;
	int nodes; /* in it */
};

struct search {
	struct hawser__map_try try;
	double axis[3];
	double principal[3][3]; /* rows: eigenvectors of C, of ascending eigenvalues */
	double spread[3];       /* square roots of these eigenvalues over the number of nodes */
	struct plane plane[PLANES];
	int planes;
};

/* Make the length 1; 0 if it is 0. */
static int normalize(double a[3])
{
	double l = sqrt(hawser__dot(a, a));

	for (int k = 0; k < 3; k++)
		a[k] /= l > 0.0 ? l : 1.0;
	return l > 0.0;
}

static enum hawser_status moments(struct search *search, struct hawser_report *report)
{
	const struct hawser__mesh *mesh = search->try.mesh;
	double *c = search->try.centre, C[9] = {0.0}, value[3];
	int count = 0, info;

	for (int i = 0; i < mesh->nodes; i++)
		for (int k = 0; k < 3 && search->try.used[i]; k++) {
			c[k] += mesh->q[i][k];
			count += k == 0;
		}
	for (int k = 0; k < 3; k++)
		c[k] /= count;
	for (int i = 0; i < mesh->nodes; i++) {
		double far = 0.0;

		for (int k = 0; k < 9 && search->try.used[i]; k++)
			C[k] += (mesh->q[i][k/3] - c[k/3])*(mesh->q[i][k%3] - c[k%3])/count;
		for (int k = 0; k < 3; k++)
			far += (mesh->q[i][k] - c[k])*(mesh->q[i][k] - c[k]);
		if (search->try.used[i])
			search->try.size = fmax(search->try.size, sqrt(far));
	}
	info = LAPACKE_dsyev(COLUMN, 'V', 'U', 3, C, 3, value);
	if (info != 0)
		return hawser__lapack_starved(info) ? hawser__no_memory(report, "net")
			: hawser__fail(report, HAWSER_ERR_NAN, "net", "%s", "a place of the net is not a number");
	for (int k = 0; k < 3; k++)
		search->spread[k] = sqrt(fmax(value[k], 0.0));
	memcpy(search->principal, C, sizeof C);
	return HAWSER_OK;
}

/* Largest distance of a node from the plane through the centre. */
static double off_plane(const struct search *search, const double normal[3])
{
	const struct hawser__mesh *mesh = search->try.mesh;
	double most = 0.0;

	for (int i = 0; i < mesh->nodes; i++) {
		double d[3];

		for (int k = 0; k < 3; k++)
			d[k] = mesh->q[i][k] - search->try.centre[k];
		if (search->try.used[i])
			most = fmax(most, fabs(hawser__dot(d, normal)));
	}
	return most;
}

/* The plane that the net lies in. On a line it is the vertical one, or that of x and y. */
static void lie(struct hawser__net_maps *maps, struct search *search)
{
	struct hawser_net_symmetry *found = &maps->found;
	double *normal = found->plane.normal, *line = search->principal[2];
	static const double up[3] = {0.0, 1.0, 0.0};

	memcpy(normal, search->principal[0], sizeof found->plane.normal);
	found->straight = search->spread[1] <= HAWSER__MAP_PLACES*search->try.size;
	if (found->straight) {
		hawser__cross(normal, line, up);
		if (sqrt(hawser__dot(normal, normal)) < upright)
			memcpy(normal, (double[3]){0.0, 0.0, 1.0}, sizeof found->plane.normal);
		normalize(normal);
	}
	found->plane.places = off_plane(search, normal);
	found->flat = 2.0*found->plane.places <= HAWSER__MAP_PLACES*search->try.size;
	found->straight = found->straight && found->flat;
	memcpy(search->axis, found->flat ? normal : up, sizeof search->axis);
	memcpy(found->plane.point, search->try.centre, sizeof found->plane.point);
}

static void mirror_map(double map[3][3], const double normal[3])
{
	for (int i = 0; i < 3; i++)
		for (int j = 0; j < 3; j++)
			map[i][j] = (i == j) - 2.0*normal[i]*normal[j];
}

/* About an axis of length 1 (Rodrigues). */
static void turn_map(double map[3][3], const double a[3], double angle)
{
	double c = cos(angle), s = sin(angle);
	const double skew[3][3] = {{0.0, -a[2], a[1]}, {a[2], 0.0, -a[0]}, {-a[1], a[0], 0.0}};

	for (int i = 0; i < 3; i++)
		for (int j = 0; j < 3; j++)
			map[i][j] = c*(i == j) + s*skew[i][j] + (1.0 - c)*a[i]*a[j];
}

/* Try a plane, and keep it if it is one of symmetry and new. */
static void try_plane(struct search *search, double normal[3])
{
	struct plane plane = {.nodes = 0};
	double map[3][3];

	if (search->planes == PLANES || !normalize(normal))
		return;
	for (int i = 0; i < search->planes; i++)
		if (fabs(hawser__dot(normal, search->plane[i].normal)) > 1.0 - 1e-6)
			return;
	mirror_map(map, normal);
	if (!hawser__map_holds(&search->try, map, &plane.places, &plane.elements))
		return;
	memcpy(plane.normal, normal, sizeof plane.normal);
	for (int i = 0; i < search->try.mesh->nodes; i++) {
		double d[3], off;

		for (int k = 0; k < 3; k++)
			d[k] = search->try.mesh->q[i][k] - search->try.centre[k];
		off = hawser__dot(d, normal);
		plane.extent += search->try.used[i] ? off*off : 0.0;
		plane.nodes += search->try.used[i] && fabs(off) <= HAWSER__MAP_PLACES*search->try.size;
	}
	search->plane[search->planes++] = plane;
}

/* --- candidates --- */

struct polar {
	double radius, height, across[3]; /* across: the part of x - c at right angles to the axis */
	int node;
};

static int by_radius(const void *a, const void *b)
{
	const struct polar *p = a, *q = b;

	return (p->radius > q->radius) - (p->radius < q->radius);
}

static int same_class(const struct polar *p, const struct polar *q, double tolerance)
{
	return fabs(p->radius - q->radius) <= tolerance && fabs(p->height - q->height) <= tolerance;
}

/* The nodes of the scene off the axis, by their distance: returns their number. */
static int polar(struct polar *list, const struct search *search, int nodes)
{
	int count = 0;

	for (int i = 0; i < nodes; i++) {
		struct polar *p = &list[count];

		for (int k = 0; k < 3; k++)
			p->across[k] = search->try.mesh->q[i][k] - search->try.centre[k];
		p->height = hawser__dot(p->across, search->axis);
		for (int k = 0; k < 3; k++)
			p->across[k] -= p->height*search->axis[k];
		p->radius = sqrt(hawser__dot(p->across, p->across));
		p->node = i;
		count += search->try.used[i] && p->radius > 10.0*HAWSER__MAP_PLACES*search->try.size;
	}
	qsort(list, (size_t)count, sizeof *list, by_radius);
	return count;
}

/* The class with the fewest members, the outermost of several: index of its first member. */
static int rarest(const struct polar *list, int count, double tolerance)
{
	int least = count + 1, chosen = 0;

	for (int i = 0, begin = 0; i < count; i++) {
		int size = 0;

		while (list[begin].radius < list[i].radius - tolerance)
			begin++;
		for (int j = begin; j < count && size <= least; j++) {
			if (list[j].radius > list[i].radius + tolerance)
				break;
			size += same_class(&list[i], &list[j], tolerance);
		}
		if (size <= least) {
			least = size;
			chosen = i;
		}
	}
	return chosen;
}

/* The smallest turn that holds: its number in a full circle. */
static int find_turn(struct search *search, const double *angle, int count)
{
	double done = 0.0, map[3][3], places, elements;

	for (;;) {
		double next = HUGE_VAL;

		for (int i = 0; i < count; i++)
			next = angle[i] > done && angle[i] < next ? angle[i] : next;
		if (next == HUGE_VAL)
			return 1;
		done = next;
		turn_map(map, search->axis, 2.0*M_PI/round(2.0*M_PI/next));
		if (fabs(2.0*M_PI/next - round(2.0*M_PI/next)) < 0.01 &&
		    hawser__map_holds(&search->try, map, &places, &elements))
			return (int)round(2.0*M_PI/next);
	}
}

static void candidates(struct hawser__net_maps *maps, struct search *search, struct polar *list,
                       double *angle, int count)
{
	double tolerance = 2.0*HAWSER__MAP_PLACES*search->try.size, normal[3];
	const struct polar *p = count ? &list[rarest(list, count, tolerance)] : NULL;
	int angles = 0;

	for (int j = 0; j < count; j++) {
		const struct polar *q = &list[j];
		double side[3];

		if (!same_class(p, q, tolerance))
			continue;
		for (int k = 0; k < 3; k++)
			normal[k] = p->across[k] - q->across[k];
		hawser__cross(side, p->across, q->across);
		if (p == q)
			hawser__cross(normal, search->axis, p->across);
		else {
			angle[angles] = atan2(hawser__dot(side, search->axis), hawser__dot(p->across, q->across));
			angle[angles] += angle[angles] < 0.0 ? 2.0*M_PI : 0.0;
			angles++;
		}
		try_plane(search, normal);
	}
	maps->found.turns = find_turn(search, angle, angles);
	for (int k = 0; k < 3 && !maps->found.flat; k++) {
		memcpy(normal, search->principal[k], sizeof normal);
		try_plane(search, normal);
	}
	if (!maps->found.flat) {
		memcpy(normal, search->axis, sizeof normal);
		try_plane(search, normal);
	}
}

/* --- the choice --- */

static int better(const struct plane *a, const struct plane *b)
{
	if (fabs(a->extent - b->extent) > alike*fmax(a->extent, b->extent))
		return a->extent > b->extent;
	return a->nodes > b->nodes;
}

static enum hawser_status keep(struct hawser__net_map *map, struct search *search,
                               struct hawser_report *report)
{
	double places, elements;

	map->partner = malloc(((size_t)search->try.mesh->nodes + 1)*sizeof *map->partner);
	if (!map->partner)
		return hawser__no_memory(report, "net");
	if (hawser__map_holds(&search->try, map->map, &places, &elements))
		memcpy(map->partner, search->try.partner, (size_t)search->try.mesh->nodes*sizeof *map->partner);
	return HAWSER_OK;
}

static enum hawser_status choose(struct hawser__net_maps *maps, struct search *search,
                                 struct hawser_report *report)
{
	struct hawser_net_symmetry *found = &maps->found;

	while (found->mirrors < HAWSER_NET_MIRRORS) {
		struct hawser_net_plane *mirror = &found->mirror[found->mirrors];
		const struct plane *best = NULL;
		enum hawser_status status;

		for (int i = 0; i < search->planes; i++) {
			const struct plane *plane = &search->plane[i];
			int free = 1;

			for (int k = 0; k < found->mirrors; k++)
				free &= fabs(hawser__dot(plane->normal, found->mirror[k].normal)) < upright;
			if (free && (!best || better(plane, best)))
				best = plane;
		}
		if (!best)
			return HAWSER_OK;
		memcpy(mirror->normal, best->normal, sizeof mirror->normal);
		memcpy(mirror->point, search->try.centre, sizeof mirror->point);
		mirror->places = best->places;
		mirror->elements = best->elements;
		mirror_map(maps->mirror[found->mirrors].map, mirror->normal);
		status = keep(&maps->mirror[found->mirrors], search, report);
		found->mirrors++;
		if (status)
			return status;
	}
	return HAWSER_OK;
}

static enum hawser_status search_all(struct hawser__net_maps *maps, struct search *search, int nodes,
                                     struct hawser_report *report)
{
	struct polar *list = malloc(((size_t)nodes + 1)*sizeof *list);
	double *angle = malloc(((size_t)nodes + 1)*sizeof *angle);
	struct hawser_net_symmetry *found = &maps->found;
	enum hawser_status status = HAWSER_OK;

	if (!list || !angle)
		status = hawser__no_memory(report, "net");
	else
		candidates(maps, search, list, angle, polar(list, search, nodes));
	memcpy(found->axis, search->axis, sizeof found->axis);
	memcpy(found->centre, search->try.centre, sizeof found->centre);
	if (!status && found->flat) {
		double places;

		mirror_map(maps->plane.map, found->plane.normal);
		found->flat = hawser__map_holds(&search->try, maps->plane.map, &places, &found->plane.elements);
		if (found->flat)
			status = keep(&maps->plane, search, report);
	}
	if (!status)
		status = choose(maps, search, report);
	if (!status && (found->turns > 2 || (found->turns == 2 && found->mirrors == 0))) {
		turn_map(maps->turn.map, found->axis, 2.0*M_PI/found->turns);
		status = keep(&maps->turn, search, report);
	}
	free(list);
	free(angle);
	return status;
}

enum hawser_status hawser__net_maps_open(struct hawser__net_maps *maps, const struct hawser__mesh *mesh,
                                         const double *T, int nodes, struct hawser_report *report)
{
	struct search *search = calloc(1, sizeof *search);
	enum hawser_status status;

	*maps = (struct hawser__net_maps){.found.turns = 1};
	if (!search)
		return hawser__no_memory(report, "net");
	status = hawser__map_open(&search->try, mesh, T, nodes, report);
	if (!status)
		status = moments(search, report);
	if (!status) {
		hawser__map_sort(&search->try);
		lie(maps, search);
		status = search_all(maps, search, nodes, report);
	}
	hawser__map_clear(&search->try);
	free(search);
	if (status)
		hawser__net_maps_clear(maps);
	return status;
}

void hawser__net_maps_clear(struct hawser__net_maps *maps)
{
	if (!maps)
		return;
	free(maps->plane.partner);
	free(maps->turn.partner);
	for (int k = 0; k < HAWSER_NET_MIRRORS; k++)
		free(maps->mirror[k].partner);
	memset(maps, 0, sizeof *maps);
}
