/* tow/steady_rod.c - the cable as a geometrically exact rod in a steady state, also in an orbit.
 *
 *   P        stiffness that stands for a rigid one
 *
 * The mesh, its elements and their tangent are those of rods (src/rod), the loads and their
 * derivatives are in steady_rod_loads.c, and Newton's method begins at the string. Rigid directions
 * (no EA, no GA) have the law N = P (w - w0), in which w0 is moved by -N/P as the iteration ends
 * (augmented Lagrangian, Hestenes 1969), so that the strain is 0 to round-off although P is only
 * some thousand times the tension, which keeps Newton's steps long. If it fails, GJ and EI grow from a
 * small part of theirs; if that fails, the cable moves
 * from the string with damping and without inertia, as rods do (rod/solve.c).
 *
 * A ring is clamped to the last node, or to a node of its own with a torsional spring between both, or
 * hangs on a joint without moment; then its attitude is that of hawser__tow_body_near. A hinge at the
 * towing point leaves bending free and holds the twist, which nothing else holds.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "tow/steady.h"

enum { ITERATIONS = 40,  /* of Newton's method: 5 to 12 are usual */
       STAGES = 40,      /* of growing stiffness: 7 if none fails */
       MOTION = 400,     /* steps of the damped motion */
       FREE = HAWSER__ROD_FREE };
#define TOLERANCE 1e-10 /* of the last increment, in lengths of the cable and rad */
#define ROUND 1e-7      /* an increment that is smaller and does not fall is round-off */
#define LONGEST 0.5     /* rad and lengths, of a step */
#define RIGID 1e3       /* P over the tension */
#define NEAR 1e-2       /* increments below which rigid strains are corrected */
#define LINK 1e-6       /* of the cable's length: that of the element which has the ring's own node; its
                         * stiffness is 0 */
#define SOFT 1e-4       /* part of GJ and EI with which they begin to grow */
#define STIFFER 4.0     /* factor of a stage, less after one that fails */
#define COIL 10.0       /* rad that a string turns in all; those of 15 and more that were tried are
                         * not found with 3200 elements either */
#define BEND 0.03       /* rad that it may turn in an element: with 0.07 one was not found */
#define THIN 1e-2       /* least EI over T h^2: layers below a tenth of an element are not resolved, and
                         * would let rotations alternate from node to node */

static const char where[] = "tow steady";

/* --- the mesh --- */

static double strongest(const struct hawser_tow_point *point, int points)
{
	double most = 0.0;

	for (int i = 0; i < points; i++)
		most = fmax(most, point[i].tension);
	return most;
}

static void describe(struct hawser__tow_rod *b, int parts, double tension)
{
	const struct hawser_tow *tow = b->frame->tow;
	double stiff = 0.0;

	for (int i = 0; i < tow->segments; i++) {
		const struct hawser_tow_segment *from = &tow->segment[i];
		struct hawser_rod_segment *to = &b->rod.segment[i];
		double h;

		to->elements = parts*(from->elements ? from->elements : HAWSER_TOW_ELEMENTS);
		h = from->length/to->elements;
		to->length = from->length;
		to->rho = from->rho;
		to->EI[0] = to->EI[1] = from->EI;
		to->GJ = from->GJ > 0.0 ? from->GJ : to->EI[0];
		to->line = (struct hawser_water_line){from->diameter, from->normal, from->tangential,
		                                      from->added_normal, from->added_tangential};
		stiff = fmax(stiff, to->EI[0]/(h*h));
		b->rod.length += from->length;
	}
	b->rigid = RIGID*tension + 0.01*stiff;
	for (int i = 0; i < tow->segments; i++) {
		const struct hawser_tow_segment *from = &tow->segment[i];
		struct hawser_rod_segment *to = &b->rod.segment[i];

		to->EA = isfinite(from->EA) ? from->EA : b->rigid;
		to->GA[0] = to->GA[1] = from->GA > 0.0 ? from->GA : b->rigid;
	}
	b->rod.segments = tow->segments;
	b->rod.g = tow->g;
	b->rod.water = tow->water;
	b->rod.hold[0] = tow->clamped ? HAWSER_ROD_CLAMPED : HAWSER_ROD_HINGED;
	b->rod.hold[1] = HAWSER_ROD_FREE;
	b->rod.tangent[1] = -1.0;
	b->rod.normal[0] = 1.0;
}

/* A node of its own for a ring on a spring: behind an element without stiffness and mass. */
static void add_joint(struct hawser__tow_rod *b)
{
	struct hawser_rod_segment *link = &b->rod.segment[b->rod.segments++];

	link->length = LINK*b->rod.length;
	link->elements = 1;
	b->rod.length += link->length;
}

static enum hawser_status open_rod(struct hawser__tow_rod *b, int parts, double tension,
                                   struct hawser_report *report)
{
	const struct hawser_tow *tow = b->frame->tow;
	int spring = tow->body.kind == HAWSER_TOW_RING &&
	             (tow->body.joint == HAWSER_TOW_SPRING ||
	              (tow->body.joint == HAWSER_TOW_JOINT && b->moves));
	enum hawser_status status;

	b->links = spring;
	b->rod.segment = calloc((size_t)tow->segments + 1, sizeof *b->rod.segment);
	if (!b->rod.segment)
		return hawser__no_memory(report, where);
	describe(b, parts, tension);
	if (spring)
		add_joint(b);
	status = hawser__rod_mesh_open(&b->mesh, &b->rod, 1, report);
	if (status)
		return status;
	b->end = b->mesh.nodes - 1;
	b->mesh.water.lift = b->frame->lift;
	memcpy(b->mesh.water.velocity, b->frame->velocity, sizeof b->frame->velocity);
	if (b->mesh.water.of && tow->body.kind == HAWSER_TOW_MASS) {
		b->mesh.water.buoy.node = b->end;
		b->mesh.water.buoy.of = (struct hawser_water_buoy){0.0, tow->body.volume, tow->body.CdA,
		                                                   tow->body.added};
	}
	b->last = b->end - spring;
	if (spring) {
		const struct hawser__rod_element *el = &b->mesh.element[b->last - 1];

		b->spring[0] = fmax(b->rigid, b->moves ? el->EA[0] : 0.0)/el->h;
		b->spring[1] = tow->body.torsion;
		for (int k = 3; k < FREE && b->hung; k++)
			b->mesh.held[FREE*b->end + k] = 1;
	}
	b->mesh.held[3] = 1;
	hawser__rod_loads(&b->mesh, NULL, 1.0);
	return HAWSER_OK;
}

void hawser__tow_rod_close(struct hawser__tow_rod *b)
{
	hawser__rod_mesh_clear(&b->mesh);
	free(b->rod.segment);
}

/* --- the start --- */

/* The shortest turn of the axes q that brings e1 along t. */
static void aim(double q[4], const double t[3])
{
	double R[9], from[3], v[3], turn[3], sine, angle;

	hawser__quaternion_matrix(R, q);
	for (int k = 0; k < 3; k++)
		from[k] = R[3*k];
	hawser__cross(v, from, t);
	sine = hawser__norm(v);
	angle = atan2(sine, hawser__dot(from, t));
	hawser__apply_left(turn, R, v);
	for (int k = 0; k < 3; k++)
		turn[k] = sine > 0.0 ? turn[k]*(angle/sine) : k == 2 ? angle : 0.0;
	hawser__quaternion_turn(q, turn);
}

/* The string's state at the nodes; point [elements of the scene + 1], parts elements between two. */
static void start(struct hawser__tow_rod *b, const struct hawser_tow_point *point, int parts,
                  const struct hawser__tow_end *body)
{
	struct hawser__rod_node *node = b->mesh.node;

	for (int i = 0; i <= b->last; i++) {
		const struct hawser_tow_point *before = &point[i/parts];
		const struct hawser_tow_point *after = i%parts ? before + 1 : before;
		double part = (double)(i%parts)/parts, along[3], size, h = after->s - before->s;

		for (int k = 0; k < 3; k++) {
			double d = after->x[k] - before->x[k], first = h*before->along[k] - d;
			double second = h*after->along[k] - d;

			/* cubic: chords at right angles to the sections, where they could not shear */
			node[i].x[k] = (1.0 - part)*before->x[k] + part*after->x[k] +
			               part*(1.0 - part)*((1.0 - part)*first - part*second);
			along[k] = (1.0 - part)*before->along[k] + part*after->along[k];
		}
		size = hawser__norm(along);
		for (int k = 0; k < 3; k++)
			along[k] /= size;
		if (i)
			memcpy(node[i].q, node[i - 1].q, sizeof node[i].q);
		if (i || !b->frame->tow->clamped)
			aim(node[i].q, along);
	}
	if (b->end > b->last) {
		node[b->end] = node[b->last];
		aim(node[b->end].q, body->axis);
	}
}

/* GJ and EI times `part`, but at least that of an element where the string has this tension. */
static void thicken(struct hawser__tow_rod *b, const struct hawser_tow_point *point, int parts,
                    double part)
{
	b->raised = 0;
	for (int e = 0; e < b->last; e++) {
		struct hawser__rod_element *el = &b->mesh.element[e];
		const struct hawser_rod_segment *of = &b->rod.segment[b->mesh.segment[e]];
		double least = THIN*fmax(point[e/parts].tension, point[e/parts + 1].tension)*el->h*el->h;

		b->raised += of->EI[0] < least || of->EI[1] < least;
		for (int k = 0; k < 3; k++)
			el->EI[k] = fmax(part*(k ? of->EI[k - 1] : of->GJ), least);
	}
}

/* --- the iteration --- */

static double largest(const struct hawser__tow_rod *b, const double *step)
{
	double most = 0.0;

	for (int i = 0; i < b->mesh.nodes; i++) {
		const double *by = step + (long)FREE*i;

		most = fmax(most, fmax(hawser__norm(by)/b->rod.length, hawser__norm(by + 3)));
		if (!isfinite(by[0] + by[1] + by[2] + by[3] + by[4] + by[5]))
			return INFINITY;
	}
	return most;
}

/* An increment into mesh.r; its size. `damping` 0: Newton's. */
static double increment(struct hawser__tow_rod *b, double damping)
{
	struct hawser__rod_mesh *mesh = &b->mesh;

	hawser__tow_rod_assemble(b);
	for (int e = 0; e < b->last && damping > 0.0; e++)
		for (int k = 0; k < HAWSER__ROD_PAIR; k++) {
			double h = mesh->element[e].h;

			*hawser__band_at(&mesh->band, FREE*e + k, FREE*e + k) += damping*h*(k%FREE < 3 ? 1.0 : h*h);
		}
	for (int i = 0; i < mesh->n; i++)
		if (mesh->held[i]) {
			(void)hawser__band_hold(&mesh->band, i);
			mesh->r[i] = 0.0;
		}
	if (hawser__band_factor(&mesh->band))
		return INFINITY;
	hawser__band_solve(&mesh->band, mesh->r);
	return largest(b, mesh->r);
}

/* Rigid directions: their strain is taken out of the law. */
static void correct(struct hawser__tow_rod *b)
{
	for (int e = 0; e < b->last; e++) {
		struct hawser__rod_element *el = &b->mesh.element[e];
		const struct hawser_tow_segment *of = &b->frame->tow->segment[b->mesh.segment[e]];
		int rigid[3] = {!isfinite(of->EA), !(of->GA > 0.0), !(of->GA > 0.0)};

		for (int k = 0; k < 3; k++)
			if (rigid[k])
				el->w0[k] = (k == 0) - b->mesh.strain[e].N[k]/el->EA[k];
	}
	for (int k = 0; k < 3 && b->end > b->last; k++)
		b->pull[k] += b->spring[0]*(b->mesh.node[b->end].x[k] - b->mesh.node[b->last].x[k]);
	(void)hawser__rod_strains(&b->mesh);
}

/* Newton's method from the state. 1: done. */
static int newton(struct hawser__tow_rod *b, double *size)
{
	double before = INFINITY;

	for (int i = 0; i < ITERATIONS; i++) {
		double scale;

		*size = increment(b, 0.0);
		if (!(*size < INFINITY))
			return 0;
		scale = *size > LONGEST ? LONGEST/ *size : 1.0;
		hawser__rod_move(&b->mesh, b->mesh.r, scale);
		if (hawser__rod_strains(&b->mesh) >= 0)
			return 0;
		if (before < NEAR && (*size <= TOLERANCE || (*size < ROUND && *size > 0.5*before)))
			return 1;
		if (*size < NEAR)
			correct(b);
		before = *size;
	}
	return *size < ROUND;
}

/* The damped motion from the state, as in rod/solve.c; 1: it is near an equilibrium. */
static int settle(struct hawser__tow_rod *b, double tension, double *size)
{
	double unit = tension/(b->rod.length*b->rod.length), t = 0.01;
	size_t nodes = (size_t)b->mesh.nodes*sizeof *b->mesh.node;

	for (int i = 0; i < MOTION && t > 1e-12; i++) {
		memcpy(b->mesh.kept, b->mesh.node, nodes);
		*size = increment(b, unit/t);
		if (*size < LONGEST) {
			hawser__rod_move(&b->mesh, b->mesh.r, 1.0);
			if (hawser__rod_strains(&b->mesh) < 0) {
				t *= *size < 0.2*LONGEST ? 3.0 : 1.0;
				if (t > 1e6 && *size < NEAR)
					return 1;
				continue;
			}
		}
		memcpy(b->mesh.node, b->mesh.kept, nodes);
		(void)hawser__rod_strains(&b->mesh);
		t *= 0.25;
	}
	return 0;
}

/* Newton's method as GJ and EI grow from SOFT times theirs, with which the rod is nearly the string;
 * 1: done. */
static int stiffen(struct hawser__tow_rod *b, const struct hawser_tow_point *string, int parts,
                   double *size)
{
	double part = SOFT, before = SOFT, factor = STIFFER;
	size_t nodes = (size_t)b->mesh.nodes*sizeof *b->mesh.node;

	memcpy(b->mesh.kept, b->mesh.node, nodes);
	for (int i = 0; i < STAGES; i++) {
		thicken(b, string, parts, part);
		if (hawser__rod_strains(&b->mesh) < 0 && newton(b, size)) {
			if (part == 1.0)
				return 1;
			memcpy(b->mesh.kept, b->mesh.node, nodes);
			before = part;
		} else {
			if (part == SOFT)
				return 0;
			memcpy(b->mesh.node, b->mesh.kept, nodes);
			factor = sqrt(factor);
		}
		part = fmin(before*factor, 1.0);
	}
	return 0;
}

/* --- the result --- */

/* Largest force that is not balanced over the tension, moment over that times the length; held
 * directions have none. */
static double residual(struct hawser__tow_rod *b, double tension)
{
	double worst = 0.0;

	hawser__tow_rod_assemble(b);
	for (int i = 0; i < b->mesh.n; i++)
		if (!b->mesh.held[i])
			worst = fmax(worst, fabs(b->mesh.r[i])/(tension*(i%FREE < 3 ? 1.0 : b->rod.length)));
	return worst;
}

/* At node i: of the element after it, or of the last one before it, with the load on its half. */
static void lay(struct hawser_tow_point *point, const struct hawser__tow_rod *b, int i)
{
	int e = i < b->last ? i : i - 1, side = i > e;
	const struct hawser__rod_element *el = &b->mesh.element[e];
	const struct hawser_tow *tow = b->frame->tow;
	double f[HAWSER__ROD_PAIR], q[3], w[3], R[9], sign = side ? 1.0 : -1.0;

	hawser__rod_forces(f, NULL, el, &b->mesh.strain[e]);
	hawser__tow_rod_drag(q, NULL, NULL, b, e);
	hawser__tow_gravity(w, b->frame, b->mesh.node[i].x);
	hawser__quaternion_matrix(R, b->mesh.node[i].q);
	point->s = b->mesh.s[i];
	point->tension = 0.0;
	memcpy(point->x, b->mesh.node[i].x, sizeof point->x);
	for (int k = 0; k < 3; k++) {
		if (b->mesh.water.of)
			q[k] = b->mesh.water.load[e][side][k]/(0.5*el->h);
		q[k] += tow->segment[b->mesh.segment[e]].rho*w[k];
		point->along[k] = R[3*k];
		point->tension += (sign*f[6*side + k] - sign*0.5*el->h*q[k])*R[3*k];
	}
	point->curvature = hypot(f[6*side + 4]/el->EI[1], f[6*side + 5]/el->EI[2]);
}

/* What to do where no equilibrium was found, by how much the string turns. */
static enum hawser_status lost(const struct hawser__tow_rod *b, const struct hawser_tow_point *string,
                               double size, struct hawser_report *report)
{
	int elements = hawser__tow_elements(b->frame->tow);
	double most = 0.0, all = 0.0;

	for (int i = 0; i < elements; i++) {
		double sine[3], angle;

		hawser__cross(sine, string[i].along, string[i + 1].along);
		angle = atan2(hawser__norm(sine), hawser__dot(string[i].along, string[i + 1].along));
		most = fmax(most, angle);
		all += angle;
	}
	if (all > COIL)
		return hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, where, ITERATIONS, size,
		                       "the bent cable was not found: as a string it is a coil that turns by "
		                       "%.3g rad, where small forces move the free end far; lower the speed, "
		                       "widen the orbit or shorten the cable", all);
	return hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, where, ITERATIONS, size,
	                       "the bent cable was not found: as a string it turns by up to %.2g rad in "
	                       "an element; give cable.segments.elements more, for example %d, or a "
	                       "smaller EI", most, (int)ceil(elements*fmax(most/BEND, 2.0)));
}

static enum hawser_status find(struct hawser__tow_rod *b, const struct hawser_tow_point *string,
                               int parts, const struct hawser__tow_end *body, double tension,
                               struct hawser_report *report)
{
	double size = INFINITY;
	int found;

	thicken(b, string, parts, 1.0);
	start(b, string, parts, body);
	found = hawser__rod_strains(&b->mesh) < 0 && newton(b, &size);
	if (!found) {
		start(b, string, parts, body);
		found = stiffen(b, string, parts, &size);
		thicken(b, string, parts, 1.0);
	}
	if (!found) {
		start(b, string, parts, body);
		found = hawser__rod_strains(&b->mesh) < 0 && settle(b, tension, &size) && newton(b, &size);
	}
	return found ? HAWSER_OK : lost(b, string, size, report);
}

enum hawser_status hawser__tow_rod_solve(struct hawser__tow_rod *b,
                                         const struct hawser_tow_point *string, int parts,
                                         const struct hawser__tow_end *body,
                                         struct hawser_report *report)
{
	double tension = strongest(string, hawser__tow_elements(b->frame->tow) + 1);
	enum hawser_status status = open_rod(b, parts, tension, report);

	b->now = *body;
	if (!status)
		status = find(b, string, parts, body, tension, report);
	if (!status)
		b->now.residual = residual(b, tension);
	if (!status && b->links && b->hung)
		aim(b->mesh.node[b->end].q, b->now.axis);
	return status;
}

int hawser__tow_hangs(const struct hawser_tow *tow)
{
	return tow->body.kind != HAWSER_TOW_RING || tow->body.joint == HAWSER_TOW_JOINT;
}

enum hawser_status hawser__tow_bend(struct hawser_tow_point *point, struct hawser__tow_end *body,
                                    const struct hawser__tow_frame *frame,
                                    const struct hawser_tow_point *string, int parts,
                                    struct hawser_report *report)
{
	struct hawser__tow_rod b = {.frame = frame, .hung = hawser__tow_hangs(frame->tow) ? body : NULL};
	enum hawser_status status = hawser__tow_rod_solve(&b, string, parts, body, report);

	for (int i = 0; !status && i <= hawser__tow_elements(frame->tow); i++)
		lay(&point[i], &b, i*parts);
	if (!status) {
		*body = b.now;
		body->raised = b.raised;
	}
	hawser__tow_rod_close(&b);
	return status;
}
