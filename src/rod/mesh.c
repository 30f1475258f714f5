/* rod/mesh.c - see mesh.h: nodes at the ends of segments and loads, and evenly between them; the rod at
 * rest. The nodes at rest are on the curve of constant curvature and twist itself, and w0 is that of
 * these nodes, so that the rest is without strain.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/order.h"
#include "core/report.h"
#include "rod/mesh.h"
#include "rod/so3.h"

/* Elements of a mesh: the state and the matrix of one are some 2 kB each. */
enum { MOST = 200000 };
#define APART 1e-9 /* of the length: points that are closer are one */

/* s of the points that have to be nodes, in order. Returns their number. */
static int breaks(double *s, const struct hawser_rod *rod)
{
	int count = 0, kept = 0;
	double end = 0.0;

	s[count++] = 0.0;
	for (int i = 0; i < rod->segments; i++)
		s[count++] = end += rod->segment[i].length;
	for (int i = 0; i < rod->loads; i++) {
		s[count++] = rod->load[i].from;
		s[count++] = rod->load[i].to;
	}
	qsort(s, (size_t)count, sizeof *s, hawser__ascending);
	for (int i = 0; i < count; i++)
		if (kept == 0 || s[i] - s[kept - 1] > APART*rod->length)
			s[kept++] = s[i];
	return kept;
}

static int segment_of(const struct hawser_rod *rod, double s)
{
	double end = 0.0;
	int i = 0;

	for (; i < rod->segments - 1; i++) {
		end += rod->segment[i].length;
		if (s < end)
			break;
	}
	return i;
}

/* Elements between two breaks: their part of those of the segment. */
static double elements_of(const struct hawser_rod *rod, double from, double to, int refine)
{
	const struct hawser_rod_segment *segment = &rod->segment[segment_of(rod, 0.5*(from + to))];

	return fmax(floor(segment->elements*(to - from)/segment->length + 0.5), 1.0)*refine;
}

static void make_element(struct hawser__rod_mesh *mesh, int e, double h, int segment)
{
	const struct hawser_rod_segment *from = &mesh->rod->segment[segment];
	struct hawser__rod_element *el = &mesh->element[e];
	struct hawser__rod_node *a = &mesh->rest[e], *b = &mesh->rest[e + 1];
	struct hawser__so3 at;
	double psi[3], J[9], R[9], step[3], d[3];

	*el = (struct hawser__rod_element){.h = h, .EA = {from->EA, from->GA[0], from->GA[1]},
	                                   .EI = {from->GJ, from->EI[0], from->EI[1]}};
	mesh->segment[e] = segment;
	for (int i = 0; i < 3; i++) {
		el->k0[i] = from->curvature[i];
		psi[i] = h*el->k0[i];
	}
	*b = *a;
	hawser__so3_at(&at, psi);
	hawser__so3_jr(J, &at);
	hawser__quaternion_matrix(R, a->q);
	/* x2 - x1 = R1 int exp(k0 s) e1 ds = h R1 Jr(psi)'e1 */
	for (int i = 0; i < 3; i++)
		step[i] = h*J[i];
	hawser__apply(d, R, step);
	for (int i = 0; i < 3; i++)
		b->x[i] += d[i];
	hawser__quaternion_turn(b->q, psi);
	(void)hawser__rod_strain(&mesh->strain[e], el, a);
	memcpy(el->w0, mesh->strain[e].w, sizeof el->w0);
}

static int node_at(const struct hawser__rod_mesh *mesh, double s)
{
	int i = 0;

	while (i < mesh->nodes - 1 && mesh->s[i] < s - 0.5*APART*mesh->rod->length)
		i++;
	return i;
}

/* Axes from a tangent and a normal, which need not be at right angles. */
static void axes(double q[4], const double tangent[3], const double normal[3])
{
	double R[9], e[3][3], along, length = sqrt(hawser__dot(tangent, tangent));

	for (int i = 0; i < 3; i++)
		e[0][i] = tangent[i]/length;
	along = hawser__dot(e[0], normal);
	for (int i = 0; i < 3; i++)
		e[1][i] = normal[i] - along*e[0][i];
	length = sqrt(hawser__dot(e[1], e[1]));
	for (int i = 0; i < 3; i++)
		e[1][i] /= length;
	hawser__cross(e[2], e[0], e[1]);
	for (int i = 0; i < 3; i++)
		for (int k = 0; k < 3; k++)
			R[3*i + k] = e[k][i];
	hawser__quaternion_of(q, R);
}

static void hold(struct hawser__rod_mesh *mesh)
{
	const struct hawser_rod *rod = mesh->rod;

	mesh->goal[0] = mesh->rest[0];
	mesh->goal[1] = mesh->rest[mesh->nodes - 1];
	if (rod->placed)
		memcpy(mesh->goal[1].x, rod->end_at, sizeof rod->end_at);
	if (rod->turned)
		axes(mesh->goal[1].q, rod->end_tangent, rod->end_normal);
	for (int end = 0; end < 2; end++) {
		const struct hawser__rod_element *el = &mesh->element[end ? mesh->elements - 1 : 0];
		unsigned char *held = mesh->held + (end ? mesh->n - HAWSER__ROD_FREE : 0);

		for (int k = 0; k < HAWSER__ROD_FREE; k++)
			held[k] = rod->hold[end] == HAWSER_ROD_CLAMPED ||
			          (rod->hold[end] == HAWSER_ROD_HINGED && k < 3);
		mesh->spin[end] = rod->hold[end] == HAWSER_ROD_CLAMPED ? 0.0 : el->EI[0]/el->h;
	}
}

static enum hawser_status allocate(struct hawser__rod_mesh *mesh, struct hawser_report *report)
{
	size_t nodes = (size_t)mesh->nodes, elements = (size_t)mesh->elements, n = (size_t)mesh->n;

	mesh->s = hawser__hold(&mesh->hold, nodes, sizeof *mesh->s);
	mesh->segment = hawser__hold(&mesh->hold, elements, sizeof *mesh->segment);
	mesh->place = hawser__hold(&mesh->hold, 2*(size_t)mesh->rod->loads + 1, sizeof *mesh->place);
	mesh->element = hawser__hold(&mesh->hold, elements, sizeof *mesh->element);
	mesh->strain = hawser__hold(&mesh->hold, elements, sizeof *mesh->strain);
	mesh->rest = hawser__hold(&mesh->hold, nodes, sizeof *mesh->rest);
	mesh->node = hawser__hold(&mesh->hold, nodes, sizeof *mesh->node);
	mesh->kept = hawser__hold(&mesh->hold, nodes, sizeof *mesh->kept);
	mesh->found = hawser__hold(&mesh->hold, nodes, sizeof *mesh->found);
	mesh->line = hawser__hold(&mesh->hold, elements, sizeof *mesh->line);
	mesh->point = hawser__hold(&mesh->hold, nodes, sizeof *mesh->point);
	mesh->sum = hawser__hold(&mesh->hold, nodes, sizeof *mesh->sum);
	mesh->held = hawser__hold(&mesh->hold, n, sizeof *mesh->held);
	mesh->r = hawser__hold(&mesh->hold, n, sizeof *mesh->r);
	mesh->work = hawser__hold(&mesh->hold, n*(HAWSER__BAND_SIDE + 1), sizeof *mesh->work);
	if (mesh->rod->water.density > 0.0) {
		mesh->water.of = &mesh->rod->water;
		mesh->water.load = hawser__hold(&mesh->hold, elements, sizeof *mesh->water.load);
		mesh->water.buoy.node = -1;
	}
	if (mesh->hold.short_of_memory)
		return hawser__no_memory(report, "rod");
	return hawser__band_open(&mesh->band, mesh->n, report);
}

static enum hawser_status count(struct hawser__rod_mesh *mesh, const double *at, int breaks, int refine,
                                struct hawser_report *report)
{
	double total = 0.0;

	for (int i = 0; i < breaks - 1; i++)
		total += elements_of(mesh->rod, at[i], at[i + 1], refine);
	if (total > MOST)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rod", "a mesh of %.0f elements is larger "
		                    "than %d: give fewer elements", total, MOST);
	mesh->elements = (int)total;
	mesh->nodes = mesh->elements + 1;
	mesh->n = HAWSER__ROD_FREE*mesh->nodes;
	return allocate(mesh, report);
}

static void fill(struct hawser__rod_mesh *mesh, const double *at, int breaks, int refine)
{
	const struct hawser_rod *rod = mesh->rod;
	int e = 0;

	memcpy(mesh->rest[0].x, rod->at, sizeof rod->at);
	axes(mesh->rest[0].q, rod->tangent, rod->normal);
	for (int i = 0; i < breaks - 1; i++) {
		int parts = (int)elements_of(rod, at[i], at[i + 1], refine);
		int segment = segment_of(rod, 0.5*(at[i] + at[i + 1]));

		for (int k = 0; k < parts; k++, e++) {
			make_element(mesh, e, (at[i + 1] - at[i])/parts, segment);
			mesh->s[e + 1] = at[i] + (at[i + 1] - at[i])*(k + 1)/parts;
		}
	}
	for (int i = 0; i < rod->loads; i++) {
		mesh->place[2*i] = node_at(mesh, rod->load[i].from);
		mesh->place[2*i + 1] = node_at(mesh, rod->load[i].to);
	}
	hold(mesh);
	memcpy(mesh->node, mesh->rest, (size_t)mesh->nodes*sizeof *mesh->node);
}

enum hawser_status hawser__rod_mesh_open(struct hawser__rod_mesh *mesh, const struct hawser_rod *rod,
                                         int refine, struct hawser_report *report)
{
	double *at = calloc((size_t)(1 + rod->segments + 2*rod->loads), sizeof *at);
	enum hawser_status status;
	int breaks_of = 0;

	memset(mesh, 0, sizeof *mesh);
	mesh->rod = rod;
	if (!at)
		return hawser__no_memory(report, "rod");
	breaks_of = breaks(at, rod);
	status = count(mesh, at, breaks_of, refine, report);
	if (!status)
		fill(mesh, at, breaks_of, refine);
	free(at);
	if (status)
		hawser__rod_mesh_clear(mesh);
	return status;
}

void hawser__rod_mesh_clear(struct hawser__rod_mesh *mesh)
{
	hawser__water_flow_clear(&mesh->water.flow);
	hawser__hold_clear(&mesh->hold);
	hawser__band_clear(&mesh->band);
	memset(mesh, 0, sizeof *mesh);
}
