/* rom/build/net_place.c - the places of a net's model, and the expansion there.
 *
 * Displacements are along x, y, z. The strains a, b, c of the file are of cables with one EA. With r =
 * EA of the cable/EA of the model, and the stretch g' of g' - 1 = r (g - 1), the factors r of a and
 * sqrt(r g'/g) of b and c give the tension of the cable, to second order too.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "rom/build/net.h"

enum { FEW = 2 }; /* cables that have points at their quarters too; chosen for the width of tables */

static const struct {
	const char *name;
	double part;
} points[] = {{"mid", 0.5}, {"quarter", 0.25}, {"three_quarter", 0.75}};
enum { POINTS = sizeof points/sizeof *points };

/* --- the places --- */

/* At a part of a cable. */
static struct hawser__net_place on_cable(const struct hawser__mesh *mesh, int cable, double part)
{
	int first = mesh->first[cable], count = mesh->first[cable + 1] - first, left, right;
	double at = part*count;
	struct hawser__net_place place = {.weight = {0.5, 0.5}};

	left = at > 0.0 ? (int)ceil(at) - 1 : 0;
	right = at < count ? (int)at : count - 1;
	place.element[0] = first + left;
	place.element[1] = first + right;
	place.node[0] = mesh->end[first + right][0];
	place.node[1] = mesh->end[first + right][1];
	place.share = at - right;
	if (left == right && count > 1 && place.share != 0.5) { /* an end: beyond two middles of elements */
		place.element[1] += left ? -1 : 1;
		place.weight[0] = 1.5;
		place.weight[1] = -0.5;
	}
	for (int e = 0; e < first; e++)
		place.s += mesh->length0[e];
	place.s += at*mesh->length0[first];
	return place;
}

/* At a node, with the strain of its first element; 0: it has none, or is held. */
static int on_node(struct hawser__net_place *place, const struct hawser__mesh *mesh, int node)
{
	int held = 1;

	for (int k = 0; k < 3; k++)
		held = held && mesh->unknown[node][k] < 0;
	for (int c = 0; c < mesh->cables && !held; c++)
		for (int end = 0; end < 2; end++) {
			*place = on_cable(mesh, c, end);
			if (place->node[end] == node)
				return 1;
		}
	return 0;
}

static int elements_of(const struct hawser__mesh *mesh, int cable)
{
	return mesh->first[cable + 1] - mesh->first[cable];
}

/* Cables that have shape points. */
static int bending(const struct hawser__mesh *mesh)
{
	int count = 0;

	for (int c = 0; c < mesh->cables; c++)
		count += elements_of(mesh, c) > 1;
	return count;
}

static char *named(const struct hawser_net_cable *cable, const char *point)
{
	char text[HAWSER_NET_NAME + 20];

	snprintf(text, sizeof text, "%s_%s", cable->name, point);
	return strdup(text);
}

size_t hawser__net_points(const struct hawser_net *net)
{
	return (size_t)(net->nodes + net->absorbers + 6*net->cables);
}

enum hawser_status hawser__net_places(struct hawser__net_source *source, char **name,
                                      struct hawser_report *report)
{
	const struct hawser__mesh *mesh = &source->modal.mesh;
	const struct hawser_net *net = source->net;
	int each = bending(mesh) > FEW ? 1 : POINTS, count = 0;
	char text[HAWSER_NET_NAME + 8];

	for (int i = 0; i < net->nodes; i++)
		if (on_node(&source->place[count], mesh, i)) {
			name[count] = strdup(net->node[i].name);
			if (!name[count++])
				return hawser__no_memory(report, "net rom");
		}
	for (int i = 0; i < net->absorbers; i++) { /* its stroke */
		const struct hawser__mesh_absorber *of = &mesh->absorber[i];

		if (!on_node(&source->place[count], mesh, of->node))
			continue;
		source->place[count].node[0] = source->place[count].node[1] = of->at;
		name[count] = strdup(strcat(strcpy(text, "stroke_"), net->absorber[i].name));
		if (!name[count++])
			return hawser__no_memory(report, "net rom");
	}
	for (int c = 0; c < net->cables; c++)
		for (int k = 0; k < each && elements_of(mesh, c) > 1; k++) {
			source->place[count] = on_cable(mesh, c, points[k].part);
			name[count] = named(&net->cable[c], points[k].name);
			if (!name[count++])
				return hawser__no_memory(report, "net rom");
		}
	source->shapes = count;
	/* the line: the ends and the middle of every cable */
	for (int c = 0; c < net->cables; c++)
		for (int k = 0; k < (elements_of(mesh, c) > 1 ? 3 : 1); k++)
			source->place[count++] = on_cable(mesh, c, 0.5*k);
	source->places = count;
	return HAWSER_OK;
}

/* --- what is there --- */

static double strain_of(const struct hawser__net_source *source, int place)
{
	const struct hawser__net_place *at = &source->place[place];

	return at->weight[0]*source->t.strain[at->element[0]] +
	       at->weight[1]*source->t.strain[at->element[1]];
}

static double ratio_of(const struct hawser__net_source *source, int place)
{
	return source->modal.mesh.EA[source->place[place].element[0]]/source->EA;
}

double hawser__net_place_stretch(const struct hawser__net_source *source, int place)
{
	return 1.0 + ratio_of(source, place)*strain_of(source, place);
}

/* Of the strains of two elements, of the model's EA. */
static void strains(double slope[3], const struct hawser__net_source *source, int place,
                    const double left[3], const double right[3])
{
	const double *weight = source->place[place].weight;
	double r = ratio_of(source, place);
	double aside = sqrt(r*hawser__net_place_stretch(source, place)/(1.0 + strain_of(source, place)));

	for (int c = 0; c < 3; c++)
		slope[c] = (c ? aside : r)*(weight[0]*left[c] + weight[1]*right[c]);
}

static void between(double u[3], const struct hawser__net_source *source, int place,
                    const double from[3], const double to[3])
{
	double share = source->place[place].share;

	for (int c = 0; c < 3; c++)
		u[c] = (from[c] + share*(to[c] - from[c]))/source->length;
}

static void shape_at(double u[3], double slope[3], const void *of, int shape, int p)
{
	const struct hawser__net_source *source = of;
	const struct hawser__net_place *place = &source->place[p];
	size_t elements = (size_t)source->modal.mesh.elements, nodes = (size_t)source->modal.mesh.nodes;
	double (*field)[3] = source->t.shape + (size_t)shape*nodes;
	double (*own)[3] = source->t.slope + (size_t)shape*elements;

	between(u, source, p, field[place->node[0]], field[place->node[1]]);
	strains(slope, source, p, own[place->element[0]], own[place->element[1]]);
}

void hawser__net_at(double u[3], double slope[3], const struct hawser__net_source *source,
                    const double *row, int p)
{
	const struct hawser__net_place *place = &source->place[p];
	double from[3], to[3], left[3], right[3];

	hawser__eigen_place(from, row, &source->modal.mesh, place->node[0]);
	hawser__eigen_place(to, row, &source->modal.mesh, place->node[1]);
	hawser__nexpand_row_slope(left, &source->t, place->element[0], row);
	hawser__nexpand_row_slope(right, &source->t, place->element[1], row);
	between(u, source, p, from, to);
	strains(slope, source, p, left, right);
}

static void field_at(double u[3], double slope[3], const void *of, const double *row, int p)
{
	hawser__net_at(u, slope, of, row, p);
}

static void pair_at(double u[3], double slope[3], const void *of, int pair, int p)
{
	const struct hawser__net_source *source = of;

	hawser__net_at(u, slope, source,
	               source->t.second + (size_t)pair*(size_t)source->modal.mesh.unknowns, p);
}

/* --- derivatives --- */

static double fourth(const void *of, const int index[4])
{
	const struct hawser__nexpand *t = &((const struct hawser__net_source *)of)->t;

	return hawser__pairings(t->pairing, t->pairs, index);
}

static int even(const void *of, const int index[4])
{
	(void)of;
	(void)index; /* symmetry is not known */
	return 1;
}

/* Of the cable whose tension changes most. */
static double tightens(const void *of, int shape)
{
	const struct hawser__net_source *source = of;
	const struct hawser__mesh *mesh = &source->modal.mesh;
	double (*slope)[3] = source->t.slope + (size_t)shape*(size_t)mesh->elements, most = 0.0;

	for (int c = 0; c < mesh->cables; c++) {
		double longer = 0.0, stretch = 0.0;

		for (int e = mesh->first[c]; e < mesh->first[c + 1]; e++) {
			longer += 0.5*(slope[e][1]*slope[e][1] + slope[e][2]*slope[e][2])/
			          (1.0 + source->t.strain[e]);
			stretch += source->t.strain[e];
		}
		most = fmax(most, stretch > 0.0 ? longer/stretch : 0.0);
	}
	return most;
}

/* Of a motion whose mass is 1, as those of modes/driven.h. */
static double damping(const void *of, const double *row, double omega2)
{
	const struct hawser__net_source *source = of;
	double unit = source->mass*source->length*source->length/source->time;
	size_t nodes = (size_t)source->modal.mesh.nodes;
	double (*shape)[3] = calloc(nodes + 1, sizeof *shape), own = 0.0;

	if (shape) {
		hawser__net_spread(shape, source, row);
		own = hawser__net_damping(source, (const double (*)[3])shape, row)/unit;
	}
	free(shape);
	return own + 2.0*source->net->ratio*sqrt(omega2);
}

struct hawser__expanded hawser__net_expanded(const struct hawser__net_source *source)
{
	return (struct hawser__expanded){.of = source, .n = source->t.n,
		.equations = source->n, .third = source->t.third,
		.fourth = fourth, .even = even, .shape_at = shape_at, .pair_at = pair_at,
		.field_at = field_at, .tightens = tightens, .damping = damping};
}
