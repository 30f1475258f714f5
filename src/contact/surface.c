/* contact/surface.c - obstacles: gap of a point, its derivatives, and how the surface moves.
 *
 * g, n, H  gap, its gradient and its second derivatives
 * d        vector from the nearest point of a segment, or from the axis of a circle
 *
 * The gap is the signed distance, so that |n| = 1 and H*n = 0: the force of a contact is r*n, whatever
 * the kind. Where the nearest point of a segment is one of its ends, the gap is the distance from that
 * end, as of a circle of radius 0: a cable passes the edge of a table. It is never negative there, and
 * jumps behind the segment; hawser_surface_clear_of brings points to the free side first.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include <hawser/surface.h>

#include "contact/heights.h"
#include "core/report.h"
#include "core/vec3.h"

static const char *const kinds[] = {"plane", "segment", "circle", "profile", "grid"};
static const char *const sides[] = {"above", "below", "left", "right", "inside", "around"};

/* Distance from a line along z through c; outwards is the direction there, curved 1/distance. */
static double round_gap(double n[3], double *curved, const double c[3], const double x[3])
{
	double d[2] = {x[0] - c[0], x[1] - c[1]}, l = hypot(d[0], d[1]);

	n[0] = l > 0.0 ? d[0]/l : 0.0;
	n[1] = l > 0.0 ? d[1]/l : 1.0;
	n[2] = 0.0;
	*curved = l > 0.0 ? 1.0/l : 0.0;
	return l;
}

static double flat_gap(double n[3], const struct hawser_surface *surface, const double x[3])
{
	memcpy(n, surface->normal, 3*sizeof *n);
	return hawser__dot(n, (double[3]){x[0] - surface->at[0], x[1] - surface->at[1],
	                                  x[2] - surface->at[2]});
}

/* The part of the way from the first to the other end of a segment nearest to x: 0 to 1 between. */
static double part_of(const struct hawser_surface *surface, const double x[3])
{
	double way[2] = {surface->to[0] - surface->at[0], surface->to[1] - surface->at[1]};

	return ((x[0] - surface->at[0])*way[0] + (x[1] - surface->at[1])*way[1])/
	       (way[0]*way[0] + way[1]*way[1]);
}

double hawser_surface_gap(double *normal, double (*hessian)[3], const struct hawser_surface *surface,
                          const double *x)
{
	double n[3], curved = 0.0, g, part = 0.5;
	int inside = surface->side == HAWSER_SIDE_INSIDE;

	if (surface->heights)
		return hawser__heights_gap(normal ? normal : n, hessian, surface->heights, x);
	if (surface->kind == HAWSER_SURFACE_SEGMENT)
		part = part_of(surface, x);
	if (surface->kind == HAWSER_SURFACE_CIRCLE)
		g = round_gap(n, &curved, surface->at, x) - surface->radius;
	else if (part < 0.0 || part > 1.0)
		g = round_gap(n, &curved, part < 0.0 ? surface->at : surface->to, x);
	else
		g = flat_gap(n, surface, x);
	for (int i = 0; hessian && i < 3; i++)
		for (int j = 0; j < 3; j++) {
			double one = i == j && i < 2 ? 1.0 : 0.0;

			hessian[i][j] = curved > 0.0 ? (inside ? -curved : curved)*(one - n[i]*n[j]) : 0.0;
		}
	for (int k = 0; normal && k < 3; k++)
		normal[k] = inside ? -n[k] : n[k];
	return inside ? -g : g;
}

void hawser_surface_velocity(double *v, const struct hawser_surface *surface, const double *x)
{
	double n[3], curved, l = 1.0;

	memcpy(v, surface->velocity, 3*sizeof *v);
	if (surface->kind == HAWSER_SURFACE_PLANE)
		return;
	if (surface->heights) {
		(void)hawser__heights_gap(n, NULL, surface->heights, x);
		v[0] = surface->speed*n[1];
		v[1] = -surface->speed*n[0];
	} else if (surface->kind == HAWSER_SURFACE_CIRCLE) {
		round_gap(n, &curved, surface->at, x);
		v[0] = -surface->speed*n[1];
		v[1] = surface->speed*n[0];
	} else {
		l = hypot(surface->to[0] - surface->at[0], surface->to[1] - surface->at[1]);
		for (int k = 0; k < 2; k++)
			v[k] = surface->speed*(surface->to[k] - surface->at[k])/l;
	}
	v[2] = 0.0;
}

/* y of the surface at x[0], x[2] along the free side, sign 1 above and -1 below; 0 if it is not
 * there. */
static int height(double *y, const struct hawser_surface *surface, const double x[3],
                  double sign)
{
	double a = surface->at[0], b = surface->to[0], half;

	if (surface->heights) {
		*y = hawser_heights_at(surface->heights, x[0], x[2]);
		return 1;
	}
	if (surface->kind == HAWSER_SURFACE_SEGMENT) {
		if (x[0] < fmin(a, b) || x[0] > fmax(a, b))
			return 0;
		*y = surface->at[1] + (surface->to[1] - surface->at[1])*(x[0] - a)/(b - a);
		return 1;
	}
	half = surface->radius*surface->radius - (x[0] - a)*(x[0] - a);
	if (half < 0.0)
		return 0;
	*y = surface->at[1] + sign*sqrt(half);
	return 1;
}

int hawser_surface_clear_of(double *x, const struct hawser_surface *surface)
{
	double n[3], y, sign = surface->side == HAWSER_SIDE_BELOW ? -1.0 : 1.0, g, part;

	if (surface->kind == HAWSER_SURFACE_PLANE || surface->side == HAWSER_SIDE_INSIDE ||
	    surface->side == HAWSER_SIDE_AROUND) {
		g = hawser_surface_gap(n, NULL, surface, x);
		for (int k = 0; g < 0.0 && k < 3; k++)
			x[k] -= g*n[k];
		return g < 0.0;
	}
	if (surface->side == HAWSER_SIDE_LEFT || surface->side == HAWSER_SIDE_RIGHT) {
		part = part_of(surface, x);
		g = flat_gap(n, surface, x);
		if (part < 0.0 || part > 1.0 || g >= 0.0)
			return 0;
		x[0] -= g*n[0];
		return 1;
	}
	if (!height(&y, surface, x, sign) || sign*(x[1] - y) >= 0.0)
		return 0;
	x[1] = y;
	return 1;
}

int hawser_surface_convex(const struct hawser_surface *surface)
{
	return surface->kind == HAWSER_SURFACE_PLANE || surface->side == HAWSER_SIDE_INSIDE ||
	       (surface->heights && surface->heights->convex);
}

static enum hawser_status fail(struct hawser_report *report, const char *message)
{
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, "contact", "%s", message);
}

static enum hawser_status plane(struct hawser_surface *surface, struct hawser_report *report)
{
	double l = sqrt(hawser__dot(surface->normal, surface->normal)), across;

	if (!(l > 0.0) || !isfinite(l))
		return fail(report, "plane.normal has no direction: give, for example, [0, 1, 0] for a floor");
	for (int k = 0; k < 3; k++)
		surface->normal[k] /= l;
	across = hawser__dot(surface->normal, surface->velocity);
	if (fabs(across) > 1e-9*sqrt(hawser__dot(surface->velocity, surface->velocity)))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "contact", "velocity has %.6g m/s along the "
		                    "normal of the plane: a surface moves along itself, give a vector in the "
		                    "plane", across);
	return HAWSER_OK;
}

/* The normal to the left of the way from the first to the other end, or its opposite. */
static enum hawser_status segment(struct hawser_surface *surface, struct hawser_report *report)
{
	double d[2] = {surface->to[0] - surface->at[0], surface->to[1] - surface->at[1]};
	double l = hypot(d[0], d[1]), sign;
	int upright = surface->side == HAWSER_SIDE_LEFT || surface->side == HAWSER_SIDE_RIGHT;

	if (!(l > 0.0))
		return fail(report, "segment.from and segment.to are one point: give two");
	if (upright != (d[0] == 0.0))
		return fail(report, upright ? "side must be above or below of a segment that is not vertical"
		                            : "side must be left or right of a vertical segment");
	surface->normal[0] = -d[1]/l;
	surface->normal[1] = d[0]/l;
	surface->normal[2] = 0.0;
	sign = upright ? (surface->side == HAWSER_SIDE_RIGHT ? 1.0 : -1.0)*surface->normal[0]
	               : (surface->side == HAWSER_SIDE_BELOW ? -1.0 : 1.0)*surface->normal[1];
	for (int k = 0; k < 2 && sign < 0.0; k++)
		surface->normal[k] = -surface->normal[k];
	return HAWSER_OK;
}

enum hawser_status hawser_surface_settle(struct hawser_surface *surface, struct hawser_report *report)
{
	const double all[] = {
		surface->at[0], surface->at[1], surface->at[2], surface->to[0], surface->to[1],
		surface->normal[0], surface->normal[1], surface->normal[2], surface->radius,
		surface->friction, surface->velocity[0], surface->velocity[1], surface->velocity[2],
		surface->speed};
	int circle = surface->kind == HAWSER_SURFACE_CIRCLE;
	int ground = surface->kind == HAWSER_SURFACE_PLANE || surface->heights;

	for (size_t i = 0; i < sizeof all/sizeof *all; i++)
		if (!isfinite(all[i]))
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "contact", "%s has a number that is not "
			                    "finite: give finite ones", kinds[surface->kind]);
	if (!(surface->axial >= 0.0) || !isfinite(surface->axial) ||
	    (surface->axial > 0.0 && (!ground ||
	                              !(hawser__norm(surface->velocity) + surface->stiffness > 0.0))))
		return fail(report, "friction: axial and transverse are of a plane with a velocity, or of a "
		            "plane, profile or grid with a stiffness: give one of these, or one number");
	if (surface->friction < 0.0 || surface->radius < 0.0)
		return fail(report, "friction and radius must not be negative");
	if (!(surface->stiffness >= 0.0) || !(surface->damping >= 0.0) ||
	    !isfinite(surface->stiffness + surface->damping))
		return fail(report, "stiffness and damping must be numbers from 0 on");
	if (!ground && surface->stiffness > 0.0)
		return fail(report, "stiffness is of planes, profiles and grids: leave it out");
	if (surface->damping > 0.0 && !(surface->stiffness > 0.0))
		return fail(report, "damping is of a bed that gives way: give its stiffness too");
	if (((surface->side == HAWSER_SIDE_INSIDE || surface->side == HAWSER_SIDE_AROUND) && !circle) ||
	    ((surface->side == HAWSER_SIDE_LEFT || surface->side == HAWSER_SIDE_RIGHT) &&
	     surface->kind != HAWSER_SURFACE_SEGMENT))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "contact", "side: a %s has no side %s",
		                    kinds[surface->kind], sides[surface->side]);
	if (surface->rotation != HAWSER_SURFACE_LOCKED && !(circle && surface->radius > 0.0))
		return fail(report, "rotation is of a circle with a radius above 0: leave it out");
	if (surface->rotation == HAWSER_SURFACE_FREE && surface->speed != 0.0)
		return fail(report, "velocity is of a surface that something moves, and rotation is free: "
		            "leave one of them out");
	if (!(surface->inertia >= 0.0) || !isfinite(surface->inertia))
		return fail(report, "inertia must be a number from 0 on");
	if (surface->inertia > 0.0 && surface->rotation != HAWSER_SURFACE_FREE)
		return fail(report, "inertia is of a circle that turns with the cable: give rotation: free, or "
		            "leave it out");
	if (surface->side == HAWSER_SIDE_INSIDE && !(surface->radius > 0.0))
		return fail(report, "circle.radius is 0, and side is inside: there is no room");
	if (surface->kind >= HAWSER_SURFACE_PROFILE && !surface->heights)
		return fail(report, "a profile or grid has no heights: give them");
	if (surface->heights) {
		const struct hawser_heights *of = surface->heights;

		surface->at[0] = of->x[of->nx - 1];
		surface->at[1] = of->y[of->nx*of->nz - 1];
		surface->at[2] = of->z[of->nz - 1];
	}
	return circle || surface->heights ? HAWSER_OK
	       : surface->kind == HAWSER_SURFACE_PLANE ? plane(surface, report) : segment(surface, report);
}
