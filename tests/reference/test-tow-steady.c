/* Steady states of towed bodies: numbers of an independent program, closed forms, the balance of a
 * ring in an orbit, and what is refused.
 *
 * D: Dehadrai, 2018; its e1 (down), e2, e3 are -y, x, z here. The numbers of D's cases are those of a
 * program with a beam on whose end the ring is clamped; the tilts of a string are those of the scalar
 * equation tan(tilt) = F_h/(W + F_v).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <string.h>

#include <hawser/tow.h>

#include "rod/so3.h"
#include "tests/tap.h"

#define PI 3.14159265358979323846 /* to the digits of a double */
static const double origin[3] = {0.0};

/* A cable of nylon in air of 1.2 kg/m^3, with a ring. */
static struct hawser_tow with_ring(struct hawser_tow_segment *cable, double length, double r, double cn,
                                   double mass, double radius, double tube, double offset)
{
	*cable = (struct hawser_tow_segment){.length = length, .rho = 1150.0*PI*r*r, .EA = INFINITY,
	                                     .diameter = 2.0*r, .normal = cn};
	return (struct hawser_tow){
		.g = 9.81, .density = 1.2, .segment = cable, .segments = 1,
		.body = {.kind = HAWSER_TOW_RING, .mass = mass, .offset = offset,
		         .ring = {.radius = radius, .segments = 256, .drag = {1.2, tube, cn, 0.0}}}};
}

/* E = 4 GPa. */
static void stiffen(struct hawser_tow_segment *cable)
{
	cable->EI = 4e9*PI/4.0*pow(0.5*cable->diameter, 4.0);
	cable->elements = 200;
}

static int solve(struct hawser_tow_steady *steady, struct hawser_tow *tow, double speed, double radius,
                 const char *what)
{
	struct hawser_report report = {0};
	double velocity[3] = {speed, 0.0, 0.0};
	enum hawser_status status =
		radius > 0.0 ? hawser_path_orbit(&tow->path, origin, radius, speed, 0.0,
		                                 HAWSER_PATH_RAMP_SMOOTH, &report)
		             : hawser_path_straight(&tow->path, origin, velocity, 0.0, HAWSER_PATH_RAMP_SMOOTH,
		                                    &report);

	if (!status)
		status = hawser_tow_steady_solve(steady, tow, &report);
	/* of a rod round-off: of places over an element's length, times a stiffness of 1000 tensions */
	return ok(!status && steady->residual < (steady->bent ? 1e-9 : 1e-10), "%s: residual %.1e %s",
	          what, status ? 0.0 : steady->residual, report.message);
}

/* tan(tilt) = F_h/(W + F_v), by bisection. */
static double scalar_tilt(const struct hawser_tow *tow, double speed)
{
	double low = 0.0, high = 0.5*PI, u[3] = {-speed, 0.0, 0.0};

	for (int i = 0; i < 60; i++) {
		double tilt = 0.5*(low + high), axis[3] = {-sin(tilt), -cos(tilt), 0.0};
		struct hawser_ring_drag drag;

		hawser_ring_drag(&drag, &tow->body.ring, u, axis, origin);
		if (-drag.force[0] > tan(tilt)*(tow->body.mass*tow->g - drag.force[1]))
			low = tilt;
		else
			high = tilt;
	}
	return -0.5*(low + high);
}

static void tilts(void)
{
	static const struct {
		double speed, tilt, digits, top;
	} row[] = {{13.0, -0.07164, 5e-6, 0.0}, {25.0, -0.2630, 5e-5, 0.0}, {40.0, -0.6287, 5e-5, 0.0},
	           {27.8, -0.5129, 5e-5, 5752.0}, {32.8, -0.6779, 5e-5, 7205.0}};

	for (size_t i = 0; i < sizeof row/sizeof *row; i++) {
		struct hawser_tow_segment cable;
		struct hawser_tow tow = i < 3 ? with_ring(&cable, 10.0, 0.005, 1.3, 50.0, 1.0, 0.05, 1.0)
		                              : with_ring(&cable, 14.0, 0.004, 1.2, 435.0, 11.0, 0.07, 16.0);
		struct hawser_tow_steady steady;

		if (!solve(&steady, &tow, row[i].speed, 0.0, i < 3 ? "D 5.2.3" : "D 5.3"))
			continue;
		close_to(steady.tilt, scalar_tilt(&tow, row[i].speed), 1e-9, "the scalar equation");
		ok(row[i].top == 0.0 || fabs(steady.tension_top - row[i].top) < 0.5, "top %.2f N",
		   steady.tension_top);
		ok(fabs(steady.rotation[2] - steady.tilt) < 1e-12 && fabs(steady.attitude[3] -
		   sin(0.5*steady.tilt)) < 1e-12, "rotation and quaternion");
		hawser_tow_steady_clear(&steady);
		stiffen(&cable);
		if (!solve(&steady, &tow, row[i].speed, 0.0, "as a beam"))
			continue;
		ok(fabs(steady.tilt - row[i].tilt) <= row[i].digits, "%g m/s: tilt %g: %.6f", row[i].speed,
		   row[i].tilt, steady.tilt);
		ok(steady.bent && steady.mesh_error < 2e-6, "mesh error %.1e m", steady.mesh_error);
		hawser_tow_steady_clear(&steady);
	}
}

/* The normal drag with which the scalar equation has D's tilts: not those of a cylinder. */
static void wanted_drag(void)
{
	static const struct {
		double speed, tilt, cn, half;
	} row[] = {{13.0, -0.4, 7.4, 0.05}, {27.8, -0.75, 1.91, 0.005}, {32.8, -0.9, 1.81, 0.005}};

	for (int i = 0; i < 3; i++) {
		double low = 1.0, high = 10.0;

		for (int k = 0; k < 16; k++) {
			struct hawser_tow_segment cable;
			double cn = 0.5*(low + high);
			struct hawser_tow tow = i < 1 ? with_ring(&cable, 10.0, 0.005, cn, 50.0, 1.0, 0.05, 1.0)
			                              : with_ring(&cable, 14.0, 0.004, cn, 435.0, 11.0, 0.07, 16.0);

			tow.body.ring.segments = 32;
			*(scalar_tilt(&tow, row[i].speed) > row[i].tilt ? &low : &high) = cn;
		}
		ok(fabs(low - row[i].cn) < row[i].half, "D's tilt of %g rad at %g m/s needs cn = %g: %.4f",
		   row[i].tilt, row[i].speed, row[i].cn, low);
	}
}

/* D 5.1.5 as a beam of nylon of 6 mm, whose ends take no moment. */
static void glauert(void)
{
	struct hawser_tow_segment cable = {.length = 1.0, .EA = 4e9*PI*9e-6, .EI = 4e9*PI/4.0*81e-12,
	                                   .diameter = 0.006, .elements = 200,
	                                   .normal = 10.0/(0.5*1.2*0.006*400.0)};
	struct hawser_tow tow = {.g = 9.81, .density = 1.2, .segment = &cable, .segments = 1,
	                         .body = {.kind = HAWSER_TOW_MASS, .mass = 20.0,
	                                  .CdA = 10.0/(0.5*1.2*400.0)}};
	struct hawser_tow_steady steady;

	if (!solve(&steady, &tow, 20.0, 0.0, "D 5.1.5, a beam on a hinge"))
		return;
	ok(fabs(-steady.end[0] - 0.076305) < 6e-7 && fabs(steady.state.depth - 0.998722) < 6e-7,
	   "beam of 6 mm (0.076305, 0.998722): (%.7f, %.7f)", -steady.end[0], steady.state.depth);
	hawser_tow_steady_clear(&steady);
	/* D: the thinner, the nearer to the string. One of 1 mm stretches by T/EA = 6 %. */
	cable.diameter = 0.001;
	cable.EA /= 36.0;
	cable.EI /= 1296.0;
	cable.elements = 20;
	cable.normal *= 6.0;
	if (!solve(&steady, &tow, 20.0, 0.0, "1 mm"))
		return;
	ok(fabs(hypot(steady.end[0], steady.state.depth)/hypot(0.076173, 0.996988) - 1.06) < 5e-3,
	   "a beam of 1 mm (%.4f, %.4f): 6 %% longer", -steady.end[0], steady.state.depth);
	hawser_tow_steady_clear(&steady);
	cable.diameter = 0.006;
	cable.EA *= 36.0;
	cable.EI *= 1296.0;
	cable.elements = 200;
	cable.normal /= 6.0;
	tow.clamped = 1;
	if (!solve(&steady, &tow, 20.0, 0.0, "clamped"))
		return;
	ok(fabs(steady.point[0].along[1] + 1.0) < 1e-14 && -steady.end[0] < 0.0745,
	   "it leaves the towing point downwards, and swings less: %.6f", -steady.end[0]);
	hawser_tow_steady_clear(&steady);
}

/* D 5.2.1: a wind at 45 degrees. */
static void hover(void)
{
	struct hawser_tow_segment cable;
	struct hawser_tow tow = with_ring(&cable, 10.0, 0.01, 1.3, 10.0, 0.08, 0.0025, 0.8);
	struct hawser_tow_steady steady;

	tow.wind[0] = tow.wind[2] = 40.0*sqrt(0.5);
	if (!solve(&steady, &tow, 0.0, 0.0, "D 5.2.1"))
		return;
	close_to(hypot(steady.rotation[0], steady.rotation[2]), -scalar_tilt(&tow, 40.0), 1e-9,
	         "the scalar equation");
	/* the segments of the ring are not symmetric to the wind */
	close_to(steady.rotation[0], -steady.rotation[2], 1e-8, "toward the wind");
	ok(fabs(steady.tension_top - 123.5) < 0.05, "top 123.5 N: %.3f", steady.tension_top);
	hawser_tow_steady_clear(&steady);
	stiffen(&cable);
	if (!solve(&steady, &tow, 0.0, 0.0, "as a beam"))
		return;
	/* the drag of the cable, 25 N/m, is large against its tension, and turns the clamped ring */
	ok(fabs(steady.rotation[2] - 0.0487) < 5e-5 && fabs(steady.rotation[0] + 0.0487) < 5e-5,
	   "rotation 0.0487: %.6f, %.6f", steady.rotation[2], steady.rotation[0]);
	ok(fabs(steady.tension_top - 123.687) < 5e-3, "top: %.4f N", steady.tension_top);
	hawser_tow_steady_clear(&steady);
	tow.body.joint = HAWSER_TOW_JOINT;
	if (!solve(&steady, &tow, 0.0, 0.0, "with a joint"))
		return;
	close_to(hypot(steady.rotation[0], steady.rotation[2]), -scalar_tilt(&tow, 40.0), 1e-9,
	         "the scalar equation, whatever the cable");
	hawser_tow_steady_clear(&steady);
}

static void closed_forms(void)
{
	struct hawser_tow_segment cable = {.length = 50.0, .rho = 0.3, .EA = INFINITY, .diameter = 0.01,
	                                   .normal = 1.2};
	struct hawser_tow tow = {.g = 9.81, .density = 1.2, .segment = &cable, .segments = 1};
	struct hawser_tow_steady steady;
	double w = 0.3*9.81, D = 0.5*1.2*1.2*0.01*400.0, angle, T, p;

	if (solve(&steady, &tow, 20.0, 0.0, "a free end")) {
		angle = acos((sqrt(w*w + 4.0*D*D) - w)/(2.0*D));
		/* the angle from the flow: the normal part of it is V sin, so that w cos = D sin^2 */
		close_to(steady.state.depth, 50.0*sin(angle), 1e-9, "critical angle: straight");
		close_to(steady.tension_top, w*50.0*sin(angle), 1e-9, "its tension");
		hawser_tow_steady_clear(&steady);
	}
	/* D 5.1.5, Glauert's string: no weight, so that T is constant; from the mass on p = tan(angle) */
	cable = (struct hawser_tow_segment){.length = 1.0, .EA = INFINITY, .diameter = 0.01,
	                                    .normal = 10.0/(0.5*1.2*0.01*400.0)};
	tow.body = (struct hawser_tow_body){.kind = HAWSER_TOW_MASS, .mass = 20.0,
	                                    .CdA = 10.0/(0.5*1.2*400.0)};
	if (solve(&steady, &tow, 20.0, 0.0, "D 5.1.5")) {
		T = hypot(20.0*9.81, 10.0);
		p = 10.0/(20.0*9.81);
		close_to(steady.tension_top, T, 1e-12, "constant tension");
		close_to(-steady.end[0], T/10.0*(hypot(1.0, p + 10.0/T) - hypot(1.0, p)), 1e-9, "its way back");
		close_to(steady.state.depth, T/10.0*(asinh(p + 10.0/T) - asinh(p)), 1e-9, "its depth");
		ok(fabs(-steady.end[0] - 0.076173) < 5e-7 && fabs(steady.state.depth - 0.996988) < 5e-7,
		   "(0.076173, 0.996988)");
		hawser_tow_steady_clear(&steady);
	}
	/* at rest, with a stretch: T = (m + rho (L - s)) g */
	cable = (struct hawser_tow_segment){.length = 7.3, .rho = 0.4, .EA = 3e4, .diameter = 0.01,
	                                    .normal = 1.2};
	if (solve(&steady, &tow, 0.0, 0.0, "at rest")) {
		close_to(steady.tension_top, (20.0 + 0.4*7.3)*9.81, 1e-13, "weight");
		close_to(steady.state.depth, 7.3*(1.0 + (20.0 + 0.2*7.3)*9.81/3e4), 1e-13, "stretch");
		ok(steady.tilt == 0.0 && steady.attitude[0] == 1.0, "it hangs down");
		hawser_tow_steady_clear(&steady);
	}
}

static void orbit(void)
{
	struct hawser_tow_segment cable = {.length = 100.0, .rho = 0.3, .EA = INFINITY, .diameter = 0.01,
	                                   .normal = 1.2};
	struct hawser_tow tow = {.g = 9.81, .density = 1.2, .segment = &cable, .segments = 1,
	                         .body = {.kind = HAWSER_TOW_MASS, .mass = 20.0, .CdA = 0.1}};
	struct hawser_tow_steady steady;

	if (!solve(&steady, &tow, 20.0, 100.0, "an orbit"))
		return;
	ok(fabs(steady.state.depth - 76.854) < 5e-4, "depth 76.854 m: %.5f", steady.state.depth);
	ok(fabs(steady.state.radius - 131.738) < 5e-4, "radius 131.738 m: %.5f", steady.state.radius);
	ok(fabs(steady.state.lag*180.0/PI - 27.629) < 5e-4, "lag 27.629 degrees: %.5f",
	   steady.state.lag*180.0/PI);
	ok(fabs(steady.tension_top - 496.89) < 5e-3, "top 496.89 N: %.4f", steady.tension_top);
	ok(fabs(steady.point[0].x[0] - 100.0) < 1e-9 && fabs(steady.point[0].x[2]) < 1e-9 &&
	   steady.end[2] < 0.0, "from the towing point; the body is behind");
	ok(steady.mesh_error < 1e-6 && steady.others == 0, "mesh error %.1e m", steady.mesh_error);
	hawser_tow_steady_clear(&steady);
}

/* The same as a rod of nylon, from a hinge: an independent program has it within 1.1 mm of the
 * string. */
static void orbit_bent(void)
{
	struct hawser_tow_segment cable = {.length = 100.0, .rho = 0.3, .EA = INFINITY, .diameter = 0.01,
	                                   .normal = 1.2, .elements = 150};
	struct hawser_tow tow = {.g = 9.81, .density = 1.2, .segment = &cable, .segments = 1,
	                         .body = {.kind = HAWSER_TOW_MASS, .mass = 20.0, .CdA = 0.1}};
	struct hawser_tow_steady steady, string;

	if (!solve(&string, &tow, 20.0, 100.0, "an orbit"))
		return;
	cable.EI = 1.96;
	if (solve(&steady, &tow, 20.0, 100.0, "an orbit, bent")) {
		double most = 0.0;

		for (int i = 0; i < steady.points; i++) {
			const double *a = steady.point[i].x, *b = string.point[i].x;

			most = fmax(most, hypot(hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]));
		}
		ok(steady.bent && most < 1.1e-3 && most > 1e-5, "%.2e m from the string", most);
		ok(steady.mesh_error < 1e-3, "mesh error %.1e m", steady.mesh_error);
		hawser_tow_steady_clear(&steady);
	}
	hawser_tow_steady_clear(&string);
}

static void cross(double *c, const double *a, const double *b)
{
	c[0] = a[1]*b[2] - a[2]*b[1];
	c[1] = a[2]*b[0] - a[0]*b[2];
	c[2] = a[0]*b[1] - a[1]*b[0];
}

/* The ring's forces and moments, summed again in the state that is found; it hangs on the cable. */
static void ring_in_orbit(double mass, double R, double offset, double speed, double radius)
{
	struct hawser_tow_segment cable;
	struct hawser_tow tow = with_ring(&cable, 14.0, 0.004, 1.2, mass, R, 0.07, offset);
	struct hawser_tow_steady steady;
	struct hawser_ring_drag drag;
	double spin[3] = {0.0}, u[3], rim[3], n[3], moment[3], h[3], part[3], along, hung = 0.0, r = 0.07;
	/* where it is as wide as its orbit, the segments, which turn with the frame, leave more */
	const double tight = radius > 10.0 ? 3e-12 : 1e-5;

	cable.length = radius > 10.0 ? 14.0 : 0.9; /* wound up, a long one has many states to look for */
	if (!solve(&steady, &tow, speed, radius, "a ring in an orbit"))
		return;
	spin[1] = steady.spin;
	cross(u, steady.centre, spin); /* the origin is on the axis */
	hawser_ring_drag(&drag, &tow.body.ring, u, steady.axis, spin);
	for (int k = 0; k < 3; k++) {
		n[k] = drag.force[k] + mass*((k == 1 ? -9.81 : 0.0) +
		                             (k == 1 ? 0.0 : spin[1]*spin[1]*steady.centre[k]));
		hung += steady.axis[k]*n[k];
	}
	ok(hypot(hypot(n[0] - steady.body_force[0], n[1] - steady.body_force[1]),
	         n[2] - steady.body_force[2]) < tight*hung,
	   "weight, inertia and drag are the force on the cable, %.6g N along the axis", hung);
	/* angular momentum of a torus: m ((R^2/2 + 5 r^2/8) spin + (R^2/2 + r^2/8) (spin.a) a) */
	along = spin[1]*steady.axis[1];
	for (int k = 0; k < 3; k++)
		h[k] = mass*((0.5*R*R + 0.625*r*r)*spin[k] + (0.5*R*R + 0.125*r*r)*along*steady.axis[k]);
	cross(part, spin, h);
	for (int k = 0; k < 3; k++)
		rim[k] = offset*steady.axis[k];
	cross(moment, rim, n);
	for (int k = 0; k < 3; k++)
		moment[k] += drag.moment[k] - part[k];
	along = moment[0]*steady.axis[0] + moment[1]*steady.axis[1] + moment[2]*steady.axis[2];
	for (int k = 0; k < 3; k++)
		moment[k] -= along*steady.axis[k];
	ok(hypot(hypot(moment[0], moment[1]), moment[2]) < tight*hung*fmax(offset, R),
	   "no moment across the axis: %.1e Nm", hypot(hypot(moment[0], moment[1]), moment[2]));
	hawser_tow_steady_clear(&steady);
}

/* Drag along the tube alone, in a flow upwards that bears 99.6 % of the weight: of both attitudes with
 * the axis in the line of the force that one is shown in which the ring hangs. */
static void nearly_borne(void)
{
	struct hawser_tow_segment cable;
	struct hawser_tow tow = with_ring(&cable, 14.0, 0.004, 0.0, 8.28, 4.82, 0.811, 0.6);
	struct hawser_tow_steady steady;
	double along = 0.0;

	tow.density = tow.body.ring.drag.density = 1025.0;
	tow.body.ring.drag.normal = 0.0;
	tow.body.ring.drag.tangential = 0.02;
	tow.wind[1] = 0.479;
	tow.wind[2] = -2.29;
	if (!solve(&steady, &tow, 0.0, 0.0, "a ring that is nearly borne"))
		return;
	for (int k = 0; k < 3; k++)
		along += steady.axis[k]*steady.body_force[k];
	ok(along > 0.0 && fabs(steady.tilt) < 0.5*PI, "it hangs: %.6g N along its axis, tilt %.6f", along,
	   steady.tilt);
	hawser_tow_steady_clear(&steady);
}

/* A ring on a torsional spring: between clamped and free, and the moment of the spring balances it. */
static void spring(double radius)
{
	/* in an orbit drag on the ring has a moment about its axis, which a weak spring yields to */
	const double torsion[] = {radius > 0.0 ? 0.1 : 1e-6, 40.0, 1e9};
	const double near = radius > 0.0 ? 1e-3 : 1e-6;
	struct hawser_tow_segment cable;
	struct hawser_tow tow = with_ring(&cable, 10.0, 0.01, 1.3, 10.0, 0.08, 0.0025, 0.8);
	struct hawser_tow_steady steady;
	double tilt[3], limit[2];

	cable.EI = 4e9*PI/4.0*1e-8;
	cable.elements = 40;
	for (int k = 0; k < 2; k++) {
		tow.body.joint = k ? HAWSER_TOW_CLAMPED : HAWSER_TOW_JOINT;
		if (!solve(&steady, &tow, 40.0, radius, k ? "clamped" : "on a joint"))
			return;
		limit[k] = steady.tilt;
		hawser_tow_steady_clear(&steady);
	}
	tow.body.joint = HAWSER_TOW_SPRING;
	for (int k = 0; k < 3; k++) {
		const struct hawser_tow_point *end;
		double arm[3], moment[3], angle[3];

		tow.body.torsion = torsion[k];
		if (!solve(&steady, &tow, 40.0, radius, "on a spring"))
			return;
		tilt[k] = steady.tilt;
		end = &steady.point[steady.points - 1];
		for (int i = 0; i < 3; i++)
			arm[i] = tow.body.offset*steady.axis[i];
		cross(moment, arm, steady.body_force);
		cross(angle, end->along, steady.axis);
		if (k == 1 && radius == 0.0)
			close_to(torsion[k]*asin(sqrt(angle[0]*angle[0] + angle[1]*angle[1] + angle[2]*angle[2])),
			         sqrt(moment[0]*moment[0] + moment[1]*moment[1] + moment[2]*moment[2]), 1e-5,
			         "the spring's moment is that of the ring's pull");
		hawser_tow_steady_clear(&steady);
	}
	ok(fabs(tilt[0] - limit[0]) < near && fabs(tilt[2] - limit[1]) < 1e-6 &&
	   (tilt[1] - tilt[0])*(tilt[2] - tilt[1]) > 0.0, "tilt: joint %.6f, springs %.6f %.6f %.6f, "
	   "clamped %.6f", limit[0], tilt[0], tilt[1], tilt[2], limit[1]);
}

static void refused(struct hawser_tow *tow, double speed, double radius, const char *text)
{
	struct hawser_tow_steady steady;
	struct hawser_report report = {0};
	double velocity[3] = {speed, 0.0, 0.0};
	enum hawser_status status =
		radius > 0.0 ? hawser_path_orbit(&tow->path, origin, radius, speed, 0.0,
		                                 HAWSER_PATH_RAMP_SMOOTH, &report)
		             : hawser_path_straight(&tow->path, origin, velocity, 0.0, HAWSER_PATH_RAMP_SMOOTH,
		                                    &report);

	if (radius < 0.0)
		tow->path.kind = HAWSER_PATH_WAYPOINTS;
	if (!status)
		status = hawser_tow_steady_solve(&steady, tow, &report);
	ok(status == HAWSER_ERR_ARGUMENT && strstr(report.message, text), "%s", report.message);
}

static void refusals(void)
{
	struct hawser_tow_segment cable = {.length = 10.0, .EA = INFINITY};
	struct hawser_tow tow = {.g = 9.81, .segment = &cable};

	refused(&tow, 5.0, 0.0, "has no cable");
	tow.segments = 1;
	refused(&tow, 5.0, 0.0, "no mass");
	cable.rho = 1.0;
	refused(&tow, 5.0, -1.0, "waypoints has no steady state");
	tow.wind[2] = 3.0;
	refused(&tow, 5.0, 10.0, "horizontal wind");
}

/* What 32 segments of a ring leave, against 1024: stated, and no more than it is. */
static void ring_errors(void)
{
	double points = 0.0, body = 0.0, least = INFINITY;

	for (int i = 0; i < 8; i++) {
		struct hawser_tow_segment cable;
		double part = 0.1*i;
		struct hawser_tow tow = with_ring(&cable, 14.0, 0.004, 1.3, 60.0, 1.0 + part, 0.05, 0.6 + part);
		struct hawser_tow_steady st[2] = {{.points = 0}};
		struct hawser_report report;
		double centre[3], force[3], axis[3], off;

		cable.elements = 30;
		tow.path = (struct hawser_path){.kind = i < 6 ? HAWSER_PATH_STRAIGHT : HAWSER_PATH_ORBIT,
			.speed = 13.0, .velocity = {13.0 + i, 0.0, 0.0}, .radius = 60.0};
		tow.body.ring.drag.tangential = 0.02;
		for (int k = 0; k < 2; k++) {
			tow.body.ring.segments = k ? 1024 : 32;
			if (hawser_tow_steady_solve(&st[k], &tow, &report))
				return (void)ok(0, "ring %d: %s", i, report.message);
		}
		for (int k = 0; k < 3; k++) {
			centre[k] = st[0].centre[k] - st[1].centre[k];
			force[k] = st[0].body_force[k] - st[1].body_force[k];
			axis[k] = st[0].axis[k] - st[1].axis[k];
		}
		off = fmax(hawser__norm(force)/hawser__norm(st[1].body_force), hawser__norm(axis));
		points = fmax(points, hawser__norm(centre)/st[0].mesh_error);
		body = fmax(body, off/st[0].ring_error);
		least = fmin(least, off/st[0].ring_error);
		for (int k = 0; k < 2; k++)
			hawser_tow_steady_clear(&st[k]);
	}
	ok(points < 1.0 && body < 1.0, "32 segments: %.2f, %.2f of the stated errors", points, body);
	ok(least > 0.3, "and at least %.2f of them", least);
}

CASE(reference_tow_steady)
{
	tilts();
	wanted_drag();
	hover();
	glauert();
	closed_forms();
	orbit();
	orbit_bent();
	ring_in_orbit(435.0, 11.0, 16.0, 13.9, 60.0);
	ring_in_orbit(575.0, 2.6, 13.0, 33.4, 2.85); /* so fast that a vertical pendulum is not stable */
	ring_in_orbit(17.4, 3.8, 0.6, 1.38, 0.64);   /* held flat by its own inertia */
	ring_in_orbit(44.0, 1.0, 0.0, 4.0, 5.0);     /* its centre is in the joint */
	nearly_borne();
	spring(0.0);
	spring(60.0);
	ring_errors();
	refusals();
	return done_testing();
}
