/* net/modes/symmetry-map.c - see symmetry.h.
 *
 * The image of a node of the scene is looked for among the nodes sorted along one direction, which is
 * parallel to no axis that users choose. The image of a cable is one between the images of its
 * ends, in the same or the opposite direction, with as many elements; its inner nodes and the
 * elements are compared one by one. Cables that lie side by side are told apart by what they are.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "net/modes/symmetry.h"

static const double direction[3] = {0.5377, 0.7071, 0.4593};
static const double same_matter = 1e-3;  /* relative difference of stiffness and mass of partners */
static const double same_tension = 1e-2; /* the tension depends on small differences of lengths */
static const double held = 1e-6;         /* sine of two directions that count as one */

struct hawser__map_key {
	double along;
	int node;
};

void hawser__map_clear(struct hawser__map_try *try)
{
	hawser__hold_clear(&try->hold);
	memset(try, 0, sizeof *try);
}

/* Nodes at the two ends of a cable. */
static int end_of(const struct hawser__mesh *mesh, int cable, int end)
{
	return mesh->end[end ? mesh->first[cable + 1] - 1 : mesh->first[cable]][end];
}

enum hawser_status hawser__map_open(struct hawser__map_try *try, const struct hawser__mesh *mesh,
                                    const double *T, int nodes, struct hawser_report *report)
{
	*try = (struct hawser__map_try){.mesh = mesh, .T = T, .nodes = nodes};
	try->used = hawser__hold(&try->hold, (size_t)mesh->nodes + 1, sizeof *try->used);
	try->partner = hawser__hold(&try->hold, (size_t)mesh->nodes + 1, sizeof *try->partner);
	try->key = hawser__hold(&try->hold, (size_t)nodes + 1, sizeof *try->key);
	try->first = hawser__hold(&try->hold, (size_t)nodes + 2, sizeof *try->first);
	try->incident = hawser__hold(&try->hold, 2*(size_t)mesh->cables + 1, sizeof *try->incident);
	try->taken = hawser__hold(&try->hold, (size_t)mesh->cables + 1, sizeof *try->taken);
	if (try->hold.short_of_memory)
		return hawser__no_memory(report, "net");
	try->noise = 10.0*hawser__mesh_floor(mesh);
	for (int e = 0; e < 2*mesh->elements; e++)
		try->used[mesh->end[e/2][e%2]] = 1;
	for (int i = 0; i < 3*mesh->nodes; i++)
		try->used[i/3] |= mesh->unknown[i/3][i%3] >= 0;
	for (int i = 0; i < 2*mesh->cables; i++)
		try->first[end_of(mesh, i/2, i%2) + 2]++;
	for (int i = 0; i < nodes; i++)
		try->first[i + 2] += try->first[i + 1];
	for (int i = 0; i < 2*mesh->cables; i++)
		try->incident[try->first[end_of(mesh, i/2, i%2) + 1]++] = i/2;
	return HAWSER_OK;
}

static int by_place(const void *a, const void *b)
{
	const struct hawser__map_key *p = a, *q = b;

	return (p->along > q->along) - (p->along < q->along);
}

static double along(const double x[3])
{
	return direction[0]*x[0] + direction[1]*x[1] + direction[2]*x[2];
}

void hawser__map_sort(struct hawser__map_try *try)
{
	for (int i = 0; i < try->nodes; i++)
		if (try->used[i])
			try->key[try->keys++] = (struct hawser__map_key){along(try->mesh->q[i]), i};
	qsort(try->key, (size_t)try->keys, sizeof *try->key, by_place);
}

/* Place of a node's image. */
static void move(double y[3], const struct hawser__map_try *try, const double map[3][3], int node)
{
	const double *x = try->mesh->q[node], *c = try->centre;

	for (int i = 0; i < 3; i++) {
		y[i] = c[i];
		for (int j = 0; j < 3; j++)
			y[i] += map[i][j]*(x[j] - c[j]);
	}
}

static double distance(const double a[3], const double b[3])
{
	return hypot(hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]);
}

/* Relative difference, with `spare` taken off. */
static double differs(double a, double b, double spare)
{
	double most = fmax(fabs(a), fabs(b)), off = fabs(a - b) - spare;

	return off > 0.0 && most > 0.0 ? off/most : 0.0;
}

/* Directions in which node i can move go to such of node j, and j has no others. */
static int moves_alike(const struct hawser__mesh *mesh, const double map[3][3], int i, int j)
{
	int free_i = 0, free_j = 0;

	for (int k = 0; k < 3; k++) {
		double a[3];

		hawser__mesh_axis(a, mesh, i, k);
		free_i += mesh->unknown[i][k] >= 0;
		free_j += mesh->unknown[j][k] >= 0;
		for (int l = 0; l < 3; l++) {
			double b[3], along = 0.0;

			hawser__mesh_axis(b, mesh, j, l);
			for (int m = 0; m < 9; m++)
				along += b[m/3]*map[m/3][m%3]*a[m%3];
			if (mesh->unknown[i][k] >= 0 && mesh->unknown[j][l] < 0 && fabs(along) > held)
				return 0;
		}
	}
	return free_i == free_j;
}

/* The same of springs to the ground. */
static int pushes_alike(const struct hawser__mesh *mesh, const double map[3][3], int i, int j)
{
	int alike = 1;

	for (int k = 0; k < 3; k++) {
		double image = 0.0;

		for (int l = 0; l < 3; l++)
			image += map[k][l]*map[k][l]*mesh->spring[i][l];
		alike &= differs(image, mesh->spring[j][k], 0.0) <= same_matter;
	}
	return alike;
}

/* The node of the scene nearest to the image of node i; -1: none there. */
static int partner_of(const struct hawser__map_try *try, const double map[3][3], int i, double *places)
{
	double y[3], least = HAWSER__MAP_PLACES*try->size, from;
	int low = 0, high = try->keys, found = -1;

	move(y, try, map, i);
	from = along(y) - least;
	while (low < high) {
		int mid = low + (high - low)/2;

		if (try->key[mid].along < from)
			low = mid + 1;
		else
			high = mid;
	}
	for (; low < try->keys && try->key[low].along <= from + 2.0*HAWSER__MAP_PLACES*try->size; low++) {
		double off = distance(y, try->mesh->q[try->key[low].node]);

		if (off <= least) {
			least = off;
			found = try->key[low].node;
		}
	}
	if (found >= 0 && (!moves_alike(try->mesh, map, i, found) ||
	                   !pushes_alike(try->mesh, map, i, found) ||
	                   differs(try->mesh->mass[i], try->mesh->mass[found], 0.0) > same_matter))
		return -1;
	*places = fmax(*places, found >= 0 ? least : 0.0);
	return found;
}

/* The absorber whose stroke is the image of that of absorber i; -1: there is none. */
static int stroke_of(const struct hawser__map_try *try, const double map[3][3], int i)
{
	const struct hawser__mesh *mesh = try->mesh;
	const struct hawser__mesh_absorber *own = &mesh->absorber[i], *other = mesh->absorber;

	for (; other < mesh->absorber + mesh->absorbers; other++) {
		double sign = map[other->axis][own->axis], image[3];

		for (int k = 0; k < 3; k++)
			image[k] = sign*(map[k][0]*own->e[0] + map[k][1]*own->e[1] + map[k][2]*own->e[2]);
		if (other->node == try->partner[own->node] && distance(image, other->e) < held &&
		    differs(own->mass, other->mass, 0.0) <= same_matter &&
		    differs(mesh->spring[own->at][own->axis], mesh->spring[other->at][other->axis], 0.0) <=
		    same_matter)
			return other->at;
	}
	return -1;
}

static int nodes_hold(struct hawser__map_try *try, const double map[3][3], double *places,
                      double *elements)
{
	int good = 1;

	memset(try->partner, 0xff, (size_t)try->mesh->nodes*sizeof *try->partner); /* -1 */
	for (int i = 0; i < try->nodes && good; i++) {
		int j = try->used[i] ? partner_of(try, map, i, places) : i;

		good = j >= 0;
		try->partner[i] = j;
		*elements = good ? fmax(*elements, differs(try->mesh->mass[i], try->mesh->mass[j], 0.0))
			: *elements;
	}
	for (int i = 0; i < try->mesh->absorbers && good; i++) {
		int at = try->mesh->absorber[i].at;

		try->partner[at] = stroke_of(try, map, i);
		good = try->partner[at] >= 0;
	}
	return good;
}

/* Number of the inner node `k`, 1 to elements - 1, from the one or the other end. */
static int inner(const struct hawser__mesh *mesh, int cable, int k, int backwards)
{
	int elements = mesh->first[cable + 1] - mesh->first[cable];

	return mesh->inner[cable] + (backwards ? elements - k : k) - 1;
}

/* Whether cable b is the image of cable a; then the partners of the inner nodes are set. */
static int matches(struct hawser__map_try *try, const double map[3][3], int a, int b, int backwards,
                   double *places, double *elements)
{
	const struct hawser__mesh *mesh = try->mesh;
	int count = mesh->first[a + 1] - mesh->first[a];
	double far = 0.0, unlike = 0.0;

	if (count != mesh->first[b + 1] - mesh->first[b])
		return 0;
	for (int k = 0; k < count; k++) {
		int e = mesh->first[a] + k, f = mesh->first[b] + (backwards ? count - 1 - k : k);
		double tension = differs(try->T[e], try->T[f], try->noise);
		double stiff = differs(mesh->EA[e]/mesh->length0[e], mesh->EA[f]/mesh->length0[f], 0.0);
		double heavy = differs(mesh->rho[e]*mesh->length0[e], mesh->rho[f]*mesh->length0[f], 0.0);
		double matter = fmax(stiff, heavy), y[3];

		if (matter > same_matter || tension > same_tension ||
		    (try->T[e] > 0.0) != (try->T[f] > 0.0))
			return 0;
		unlike = fmax(unlike, fmax(matter, tension));
		if (k == 0)
			continue;
		move(y, try, map, inner(mesh, a, k, 0));
		far = fmax(far, distance(y, mesh->q[inner(mesh, b, k, backwards)]));
	}
	if (!(far <= HAWSER__MAP_PLACES*try->size))
		return 0;
	*places = fmax(*places, far);
	*elements = fmax(*elements, unlike);
	for (int k = 1; k < count; k++)
		try->partner[inner(mesh, a, k, 0)] = inner(mesh, b, k, backwards);
	return 1;
}

static int cable_holds(struct hawser__map_try *try, const double map[3][3], int cable, double *places,
                       double *elements)
{
	const struct hawser__mesh *mesh = try->mesh;
	int from = try->partner[end_of(mesh, cable, 0)], to = try->partner[end_of(mesh, cable, 1)];

	for (int i = try->first[from]; i < try->first[from + 1]; i++) {
		int other = try->incident[i], a = end_of(mesh, other, 0), b = end_of(mesh, other, 1);

		if (try->taken[other] || !((a == from && b == to) || (a == to && b == from)))
			continue;
		if (matches(try, map, cable, other, a != from, places, elements)) {
			try->taken[other] = 1;
			return 1;
		}
	}
	return 0;
}

int hawser__map_holds(struct hawser__map_try *try, const double map[3][3], double *places,
                      double *elements)
{
	*places = *elements = 0.0;
	if (!nodes_hold(try, map, places, elements))
		return 0;
	memset(try->taken, 0, (size_t)try->mesh->cables);
	for (int c = 0; c < try->mesh->cables; c++)
		if (!cable_holds(try, map, c, places, elements))
			return 0;
	return 1;
}
