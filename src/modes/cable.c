/* modes/cable.c - the static cable on a Gauss-Legendre grid.
 *
 *   u        slope eta + delta*s; theta = asinh(u)
 *   psi      angle of the tangent e from the tangent at mid-length: the frame of the displacements
 *   sa, sb   sqrt(compliance) of stretch and rotation: sa^2 = epsilon, sb^2 = g/T, T = sqrt(1+u^2),
 *            g = 1 + epsilon*T
 *
 * T and psi have branch points at u = +-i, at the distance 1/delta from the lowest point. With
 * elements of equal length in theta the distance of the branch points, relative to the element, is
 * the same for all elements. One degree therefore suits all elements for any sag
 * (doc/theory-modes.md, "Elements").
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include "core/report.h"
#include "modes/cable.h"

static const double theta_span = 2.5; /* largest element, in theta */
enum { LEAST_DEGREE = 3 };

/* u just before attachment i, or at end B for i = attachments; and just after i - 1. The loads up to a
 * point are summed in the same way everywhere, so that u is the same to the last bit. Returns u'. */
static double ends_of(double *first, double *last, const struct hawser_statics *st, int i)
{
	double load = 0.0;

	if (st->space)
		return hawser__space_slopes(first, last, st, i);
	for (int k = 0; k < i; k++)
		load += st->attached[k].jump[1];
	*first = st->eta + st->delta*((i > 0 ? st->attached[i - 1].s : 0.0) + load);
	*last = st->eta + st->delta*((i < st->attachments ? st->attached[i].s : st->l) + load);
	return st->delta;
}

/* Elements of the piece of cable before attachment i. */
static int elements_of(const struct hawser_statics *st, int i)
{
	double first, last;

	(void)ends_of(&first, &last, st, i);
	return (int)fmax(1.0, ceil((asinh(last) - asinh(first))/theta_span));
}

int hawser__cable_elements(const struct hawser_statics *st)
{
	double range = asinh(st->eta + st->delta*st->l) - asinh(st->eta);
	int sum = 0;

	if (st->attachments > 0) {
		for (int i = 0; i <= st->attachments; i++)
			sum += elements_of(st, i);
		return sum;
	}
	return range <= theta_span ? 1 : (int)ceil(range/theta_span);
}

int hawser__cable_coarse(const struct hawser__cable *cable)
{
	int elements = cable->grid.elements;
	double range = asinh(cable->edges[elements]) - asinh(cable->edges[0]);

	return !cable->pieces && range > 2.0*theta_span*elements;
}

/* Slopes u[elements+1], positions of the edges, and lengths of the elements. Near the lowest point
 * of a very slack cable an element is much shorter than its distance from end A. Its length as a
 * difference of positions, and u as eta + delta*s, would lose accuracy by cancellation. */
static void place_edges(double *u, double *edge, double *length, int elements,
                        const struct hawser_statics *st)
{
	double first = asinh(st->eta), last = asinh(st->eta + st->delta*st->l);

	for (int e = 0; e <= elements; e++) {
		u[e] = sinh(first + (last - first)*e/elements);
		edge[e] = (u[e] - st->eta)/st->delta;
	}
	edge[0] = 0.0;
	edge[elements] = st->l;
	for (int e = 0; e < elements; e++)
		length[e] = elements == 1 ? st->l : (u[e + 1] - u[e])/st->delta;
}

/* The loads up to the middle of the length: u there is eta + delta*(l/2 + them). */
static double load_to_middle(const struct hawser_statics *st)
{
	double load = 0.0;

	for (int i = 0; i < st->attachments; i++)
		if (st->attached[i].s < 0.5*st->l)
			load += st->attached[i].jump[1];
	return load;
}

/* The same with attachments: u[elements] at the beginning of each element, and bent[elements], the
 * difference of that from u at mid-length, without cancellation. Sets the edges of the lumps. */
static void place_pieces(struct hawser__cable *t, double *u, double *bent, double *edge,
                         double *length, const struct hawser_statics *st)
{
	double load = 0.0, middle = 0.5*st->l + load_to_middle(st);

	for (int i = 0, e = 0; i <= st->attachments; i++) {
		int count = elements_of(st, i);
		double first, last, rate, from = i > 0 ? st->attached[i - 1].s : 0.0;
		double to = i < st->attachments ? st->attached[i].s : st->l;

		rate = ends_of(&first, &last, st, i);
		for (int k = 0; k < count; k++, e++) {
			double low = asinh(first), high = asinh(last);

			u[e] = k == 0 ? first : sinh(low + (high - low)*k/count);
			edge[e] = k == 0 ? from : from + (u[e] - first)/rate;
			bent[e] = st->delta*(edge[e] + load - middle);
			if (k > 0)
				length[e - 1] = (u[e] - u[e - 1])/rate;
		}
		length[e - 1] = count == 1 ? to - from : (last - u[e - 1])/rate;
		edge[e] = to;
		u[e] = last;
		if (i == st->attachments)
			break;
		load += st->attached[i].jump[1];
		for (int q = 0; q < HAWSER__PLANES; q++)
			t->lump[q][i + st->elastic] = (struct hawser__lump){e, st->attached[i].m};
	}
}

/* The springs of elastic supports: a direction of stiffness k is displaced by 1/sqrt(k) where the
 * energy of the spring is 1/2. */
static void place_joints(struct hawser__cable *t, const double axis[3][HAWSER__MAX_D],
                         const struct hawser_statics *st)
{
	int count[HAWSER__PLANES] = {0};

	for (int end = 0; end < 2; end++)
		for (int a = 0; a < 3; a++) {
			int plane = a == 2 && !st->space ? HAWSER_OUT_OF_PLANE : HAWSER_IN_PLANE;
			double root = sqrt(st->H/(st->held[end].stiffness[a]*st->span.d));

			if (root > 0.0)
				t->joint[plane][count[plane]++] = (struct hawser__joint){
					end, {root*axis[a][0], root*axis[a][1], root*axis[a][2]}};
		}
	for (int q = 0; q < HAWSER__PLANES; q++) {
		t->lump[q][0] = (struct hawser__lump){0, st->held[0].m};
		t->lump[q][st->attachments + 1] = (struct hawser__lump){t->grid.elements, st->held[1].m};
		t->plane[q].joints = count[q];
		t->plane[q].joint = t->joint[q];
	}
}

/* Absorbers, whose mass is taken from that of their lump. Each moves in one plane (methods.c). */
static void place_absorbers(struct hawser__cable *t, const double axis[3][HAWSER__MAX_D],
                            const struct hawser_statics *st)
{
	for (int i = 0; i < st->attachments; i++) {
		const struct hawser_attached *at = &st->attached[i];
		const double *a = at->absorber_axis;
		int q = a[2] != 0.0 && !st->space ? HAWSER_OUT_OF_PLANE : HAWSER_IN_PLANE;
		struct hawser__absorber *to = &t->absorber[q][t->plane[q].absorbers];

		if (!(at->absorber > 0.0))
			continue;
		*to = (struct hawser__absorber){.lump = i + st->elastic, .mass = at->absorber,
		                                .root = sqrt(st->H/(at->absorber_stiffness*st->span.d))};
		for (int c = 0; c < t->plane[q].D; c++)
			to->a[c] = q == HAWSER_IN_PLANE ? a[0]*axis[0][c] + a[1]*axis[1][c] + a[2]*axis[2][c]
			                                : a[2];
		t->lump[q][to->lump].mass = at->m - at->absorber;
		t->plane[q].absorbers++;
	}
	for (int q = 0; q < HAWSER__PLANES; q++)
		t->plane[q].absorber = t->absorber[q];
}

/* Springs along x, y and z: the axes of the displacements in the plane are tangent and normal at
 * mid-length. */
static void place_springs(struct hawser__cable *t, const struct hawser_statics *st)
{
	double um = st->eta + st->delta*(0.5*st->l + load_to_middle(st)), cm = sqrt(1.0 + um*um);
	double axis[3][HAWSER__MAX_D] = {{1.0/cm, -um/cm}, {um/cm, 1.0/cm}, {1.0, 0.0}};
	int count[HAWSER__PLANES] = {0};

	if (st->space)
		hawser__space_axes(axis, st);
	for (int i = 0; i < st->attachments; i++)
		for (int a = 0; a < 3; a++) {
			int plane = a == 2 && !st->space ? HAWSER_OUT_OF_PLANE : HAWSER_IN_PLANE;
			double root = sqrt(st->attached[i].spring[a]*st->span.d/st->H);

			if (root > 0.0)
				t->spring[plane][count[plane]++] = (struct hawser__spring){
					i + st->elastic, {root*axis[a][0], root*axis[a][1], root*axis[a][2]}};
		}
	if (st->elastic)
		place_joints(t, axis, st);
	place_absorbers(t, axis, st);
	for (int q = 0; q < HAWSER__PLANES; q++) {
		t->plane[q].lumps = st->attachments + 2*st->elastic;
		t->plane[q].lump = t->lump[q];
		t->plane[q].springs = count[q];
		t->plane[q].spring = t->spring[q];
	}
}

/* The angle of the tangent is measured from that at mid-length, where u - um = delta*(s - l/2) has
 * no cancellation, so that the small angles of a nearly straight cable are accurate for any
 * slope. */
static void fill_fields(double *field, const struct hawser_grid *grid, const double *edge_slope,
                        const double *edge_bent, const struct hawser_statics *st)
{
	double um = st->eta + st->delta*(0.5*st->l + load_to_middle(st)), cm = sqrt(1.0 + um*um);
	int points = grid->points;

	for (int i = 0; i < points; i++) {
		int e = i/grid->order;
		double x = grid->node[i%grid->order], T, u, bent;

		if (st->attachments > 0) {
			bent = edge_bent[e] + st->delta*(grid->s[i] - grid->edge[e]);
			u = um + bent;
		} else if (grid->elements == 1) {
			bent = 0.5*st->delta*st->l*x;
			u = um + bent;
		} else {
			u = edge_slope[e] + 0.5*(edge_slope[e + 1] - edge_slope[e])*(1.0 + x);
			bent = u - um;
		}
		T = sqrt(1.0 + u*u);
		field[i] = (1.0 + u*um)/(T*cm);
		field[points + i] = bent/(T*cm);
		field[2*points + i] = sqrt((1.0 + st->epsilon*T)/T);
	}
}

static void fill_directions(struct hawser__cable *t, double sa)
{
	int points = t->grid.points;
	const double *cosine = t->field, *sine = t->field + points, *sb = t->field + 2*points;
	double *d = t->direction;

	for (int i = 0; i < points; i++) {
		d[i] = sa*cosine[i];
		d[points + i] = sa*sine[i];
		d[2*points + i] = -sb[i]*sine[i];
		d[3*points + i] = sb[i]*cosine[i];
		d[4*points + i] = sb[i];
	}
	t->plane[HAWSER_IN_PLANE] = (struct hawser__plane){.D = 2, .direction = d};
	t->plane[HAWSER_OUT_OF_PLANE] = (struct hawser__plane){.D = 1, .direction = d + 4*points};
}

void hawser__cable_fields(double *shape, double *slope, const struct hawser__cable *cable, int plane,
                          const double *strain, const double *displacement)
{
	int points = cable->grid.points;
	const double *cosine = cable->field, *sine = cosine + points, *sb = sine + points;
	const double *x = displacement, *y = displacement + points;

	if (cable->space) {
		hawser__space_shape(shape, slope, cable, strain, displacement);
		return;
	}
	for (int i = 0; i < points; i++, shape += 3, slope += 3) {
		if (plane == HAWSER_OUT_OF_PLANE) {
			shape[2] = x[i];
			slope[2] = sb[i]*strain[i];
			continue;
		}
		shape[0] = cosine[i]*x[i] + sine[i]*y[i];
		shape[1] = cosine[i]*y[i] - sine[i]*x[i];
		slope[0] = cable->sa*strain[i];
		slope[1] = sb[i]*strain[points + i];
	}
}

void hawser__cable_strokes(double *stroke, const struct hawser__cable *cable, int q,
                           const double *strain)
{
	const struct hawser__plane *plane = &cable->plane[q];
	int first = plane->D*cable->grid.points + plane->springs + plane->joints;

	for (int i = 0; i < plane->absorbers; i++)
		stroke[plane->absorber[i].lump - cable->elastic] =
			plane->absorber[i].root*strain[first + i];
}

int hawser__cable_degree(int elements, int n)
{
	double waves = 0.5*M_PI*(0.5*n + 1.0);

	if (elements == 1)
		return (int)ceil(waves + 2.0*cbrt(waves)) + 9;
	return 17 + (int)ceil(waves/elements) + elements/4;
}

int hawser__cable_degree_attached(const struct hawser_statics *st, int n)
{
	double longest = 0.0, waves;

	for (int i = 0; i <= st->attachments; i++)
		longest = fmax(longest, (i < st->attachments ? st->attached[i].s : st->l) -
		                                (i > 0 ? st->attached[i - 1].s : 0.0));
	waves = 0.5*M_PI*(0.5*n + 1.0)*longest/st->l;
	return (int)ceil(waves + 2.0*cbrt(waves)) + 9;
}

int hawser__cable_split(int *elements, const struct hawser_statics *statics, int basis)
{
	int wanted = hawser__cable_elements(statics), room = (basis + 1)/LEAST_DEGREE;

	if (statics->attachments > 0 && room < wanted) { /* kinks are at edges of elements */
		*elements = wanted;
		return LEAST_DEGREE;
	}
	*elements = wanted < room ? wanted : room > 1 ? room : 1;
	return (basis + 1)/ *elements;
}

void hawser__cable_clear(struct hawser__cable *cable)
{
	hawser__grid_clear(&cable->grid);
	hawser__reference_clear(&cable->reference);
	free(cable->edges);
	free(cable->field);
	free(cable->direction);
	*cable = (struct hawser__cable){0};
}

enum hawser_status hawser__cable_init(struct hawser__cable *cable,
                                      const struct hawser_statics *statics, int elements, int p,
                                      struct hawser_report *report)
{
	size_t edges = (size_t)elements + 1, points;
	enum hawser_status status;

	*cable = (struct hawser__cable){.sa = sqrt(statics->epsilon), .elastic = statics->elastic,
	                                .space = statics->space};
	cable->edges = malloc(4*edges*sizeof *cable->edges);
	if (!cable->edges)
		return hawser__no_memory(report, "modes");
	if (statics->attachments > 0)
		place_pieces(cable, cable->edges, cable->edges + 3*edges, cable->edges + edges,
		             cable->edges + 2*edges, statics);
	else
		place_edges(cable->edges, cable->edges + edges, cable->edges + 2*edges, elements, statics);
	status = hawser__grid_init(&cable->grid, elements, 2*p, cable->edges + edges,
	                           cable->edges + 2*edges, report);
	if (!status)
		status = hawser__reference_init(&cable->reference, &cable->grid, p, report);
	if (status)
		return status;
	points = (size_t)cable->grid.points;
	cable->field = malloc((statics->space ? 10 : HAWSER__FIELDS)*points*sizeof *cable->field);
	cable->direction = malloc((statics->space ? 9 : 5)*points*sizeof *cable->direction);
	if (!cable->field || !cable->direction)
		return hawser__no_memory(report, "modes");
	if (statics->space) {
		hawser__space_fields(cable, statics);
	} else {
		fill_fields(cable->field, &cable->grid, cable->edges, cable->edges + 3*edges, statics);
		fill_directions(cable, cable->sa);
	}
	cable->pieces = statics->attachments > 0;
	if (statics->attachments > 0 || statics->elastic)
		place_springs(cable, statics);
	return HAWSER_OK;
}
