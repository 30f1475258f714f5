/* tow/steady_string.c - the cable as a string in a steady state, integrated from its free end
 * upwards.
 *
 *   n      tension vector, T = |n|, t = n/T the direction away from the towing point
 *   q      load per unstretched length: weight and inertia rho (g - a), and drag f(u, t)
 *
 * With s from the towing point on, x' = (1 + T/EA) t and n' = -q. At the free end n is what the
 * body pulls with, so that this is an initial value problem in L - s, by the Runge-Kutta method of
 * order 4. Upwards the direction is drawn toward that in which the loads have no part across the
 * cable, so that errors decay. A free end without a body has no tension: there the cable is along
 * that direction itself (for a cable in straight flight all of it is, at the critical angle).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "tow/steady.h"
#include "water/morison.h"
#include "water/water.h"

void hawser__tow_flow(double u[3], const struct hawser__tow_frame *frame, const double x[3])
{
	const struct hawser_tow *tow = frame->tow;
	double wind[3], ignored[3];

	memcpy(wind, tow->wind, sizeof wind);
	if (tow->water.density > 0.0)
		hawser__water_current(wind, ignored, &tow->water, x[1] + frame->lift);

	/* the frame turns: the velocity of the point is spin * (y-axis) x x */
	u[0] = wind[0] - frame->velocity[0] - frame->spin*x[2];
	u[1] = wind[1] - frame->velocity[1];
	u[2] = wind[2] - frame->velocity[2] + frame->spin*x[0];
}

void hawser__tow_gravity(double w[3], const struct hawser__tow_frame *frame, const double x[3])
{
	w[0] = frame->spin*frame->spin*x[0];
	w[1] = -frame->tow->g;
	w[2] = frame->spin*frame->spin*x[2];
}

/* Of a cable at the height x[1] of the frame: the part of its drag that there is, 1 but at the surface
 * of water and above it, and its *buoyancy (N/m). */
static double wet(double *buoyancy, const struct hawser__tow_frame *frame,
                  const struct hawser_tow_segment *segment, const double x[3])
{
	const struct hawser_water *water = &frame->tow->water;
	double band = HAWSER__WATER_BAND*segment->diameter, part;

	*buoyancy = 0.0;
	if (!(water->density > 0.0 && band > 0.0))
		return 1.0;
	part = fmin(fmax((water->surface - x[1] - frame->lift)/band + 0.5, 0.0), 1.0);
	*buoyancy = part*water->density*M_PI*0.25*segment->diameter*segment->diameter*frame->tow->g;
	return part;
}

/* t = cos(angle) e + sin(angle) d */
static void turn(double *t, double *across, const double *e, const double *d, double angle)
{
	for (int i = 0; i < 3; i++) {
		t[i] = cos(angle)*e[i] + sin(angle)*d[i];
		across[i] = cos(angle)*d[i] - sin(angle)*e[i];
	}
}

void hawser__tow_direction(double t[3], const double weight[3], const double u[3],
                           void (*drag)(double f[3], const void *context, const double t[3]),
                           const void *context, int bisections)
{
	double w = hawser__norm(weight), speed = hawser__norm(u), e[3], d[3], across[3], low = 0.0, high;
	double along, side;

	for (int i = 0; i < 3; i++)
		e[i] = w > 0.0 ? weight[i]/w : speed > 0.0 ? u[i]/speed : i == 1 ? -1.0 : 0.0;
	along = hawser__dot(u, e);
	for (int i = 0; i < 3; i++)
		d[i] = u[i] - along*e[i];
	side = hawser__norm(d);
	memcpy(t, e, sizeof e);
	if (!(side > 0.0))
		return;
	for (int i = 0; i < 3; i++)
		d[i] /= side;
	/* across t there is drag alone at angle 0, and weight alone where t is along the flow */
	high = atan2(side, along);
	for (int k = 0; k < bisections; k++) {
		double middle = 0.5*(low + high), f[3];

		turn(t, across, e, d, middle);
		drag(f, context, t);
		if (hawser__dot(f, across) + hawser__dot(weight, across) > 0.0)
			low = middle;
		else
			high = middle;
	}
	turn(t, across, e, d, 0.5*(low + high));
}

/* --- the string --- */

struct string {
	const struct hawser__tow_frame *frame;
	const struct hawser_tow_segment *segment;
	struct hawser_drag drag;
	double fallback[3]; /* direction where there is no tension */
};

static struct hawser_drag drag_of(const struct hawser_tow *tow,
                                  const struct hawser_tow_segment *segment)
{
	return (struct hawser_drag){tow->density, 0.5*segment->diameter, segment->normal,
	                            segment->tangential};
}

/* State y: x, then n. Its derivatives by L - s. */
static void rates(double dy[6], const struct string *of, const double y[6])
{
	const double *n = &y[3];
	double T = hawser__norm(n), t[3], u[3], w[3], f[3], up;
	double part = wet(&up, of->frame, of->segment, y);

	for (int i = 0; i < 3; i++)
		t[i] = T > 0.0 ? n[i]/T : of->fallback[i];
	hawser__tow_flow(u, of->frame, y);
	hawser__tow_gravity(w, of->frame, y);
	hawser_drag_line(f, NULL, NULL, &of->drag, u, t);
	for (int i = 0; i < 3; i++) {
		dy[i] = -(1.0 + T/of->segment->EA)*t[i];
		dy[3 + i] = of->segment->rho*w[i] + part*f[i] + (i == 1 ? up : 0.0);
	}
}

static void step(double y[6], const struct string *of, double h)
{
	double k[4][6], z[6];
	static const double at[4] = {0.0, 0.5, 0.5, 1.0}, weight[4] = {1.0, 2.0, 2.0, 1.0};

	for (int stage = 0; stage < 4; stage++) {
		for (int i = 0; i < 6; i++)
			z[i] = y[i] + (stage ? at[stage]*h*k[stage - 1][i] : 0.0);
		rates(k[stage], of, z);
	}
	for (int stage = 0; stage < 4; stage++)
		for (int i = 0; i < 6; i++)
			y[i] += h/6.0*weight[stage]*k[stage][i];
}

static void line_drag(double f[3], const void *context, const double t[3])
{
	const struct string *of = context;
	double u[3];

	memcpy(u, of->fallback, sizeof u); /* holds the flow while the direction is sought */
	hawser_drag_line(f, NULL, NULL, &of->drag, u, t);
}

/* The direction of a free end without tension at x. */
static void free_direction(struct string *of, const double *x)
{
	double w[3], u[3], t[3], up, part = wet(&up, of->frame, of->segment, x);

	hawser__tow_flow(u, of->frame, x);
	hawser__tow_gravity(w, of->frame, x);
	for (int i = 0; i < 3; i++)
		w[i] = w[i]*of->segment->rho + (i == 1 ? up : 0.0);
	of->drag.density *= part;
	memcpy(of->fallback, u, sizeof u);
	hawser__tow_direction(t, w, u, line_drag, of, HAWSER__BISECTIONS);
	memcpy(of->fallback, t, sizeof t);
}

static int steps_of(const struct hawser_tow_segment *segment)
{
	return segment->elements ? segment->elements : HAWSER_TOW_ELEMENTS;
}

int hawser__tow_elements(const struct hawser_tow *tow)
{
	int sum = 0;

	for (int i = 0; i < tow->segments; i++)
		sum += steps_of(&tow->segment[i]);
	return sum;
}

static void store(struct hawser_tow_point *point, const struct string *of, const double *y, double s)
{
	double T = hawser__norm(&y[3]);

	point->s = s;
	point->tension = T;
	for (int i = 0; i < 3; i++) {
		point->x[i] = y[i];
		point->along[i] = T > 0.0 ? y[3 + i]/T : of->fallback[i];
	}
}

void hawser__tow_string(double top[3], double n[3], struct hawser_tow_point *point,
                        const struct hawser__tow_frame *frame, const double x[3],
                        const struct hawser__tow_end *end, int parts)
{
	const struct hawser_tow *tow = frame->tow;
	struct string of = {.frame = frame, .segment = &tow->segment[tow->segments - 1]};
	double y[6], from = 0.0;
	int last = hawser__tow_elements(tow);

	of.drag = drag_of(tow, of.segment);
	memcpy(y, x, 3*sizeof *y);
	memcpy(&y[3], end->force, 3*sizeof *y);
	if (hawser__norm(end->force) == 0.0)
		free_direction(&of, x);
	for (int i = 0; i < tow->segments; i++)
		from += tow->segment[i].length;
	if (point)
		store(&point[last], &of, y, from);
	for (int i = tow->segments - 1; i >= 0; i--) {
		int elements = steps_of(&tow->segment[i]), steps = (parts*elements + 1)/2;

		of.segment = &tow->segment[i];
		of.drag = drag_of(tow, of.segment);
		from -= of.segment->length;
		for (int k = 1; k <= steps; k++) {
			step(y, &of, of.segment->length/steps);
			if (point && parts == 2)
				store(&point[last - k], &of, y, from + of.segment->length*(1.0 - (double)k/steps));
			else if (point && k%2 == 0 && parts == 4)
				store(&point[last - k/2], &of, y, from + of.segment->length*(1.0 - (double)k/steps));
		}
		last -= elements;
	}
	memcpy(top, y, 3*sizeof *y);
	memcpy(n, &y[3], 3*sizeof *y);
}
