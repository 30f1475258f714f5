/* bench/tow - steady states and motions of towed bodies: error and processor time.
 *
 *     bench/tow
 *
 * (a) Steady states, strings and rods: mesh error, residual, milliseconds. (b) The U-turn of D 5.2.5
 * in a head wind of 5 m/s, 20 and 100 elements: the tilt for t > 50 s (0.042 rad), the change of the
 * body's place by half the local error, energy that is lost, and how many times as fast as the motion
 * itself. The status is 1 if a tilt is wrong.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>

#include <hawser/tow.h>

#include "bench/clock.h"

#define PI 3.14159265358979323846 /* to the digits of a double */
enum { TIMES = 20 }; /* of a steady state */
static const double origin[3] = {0.0};

static struct hawser_tow with_ring(struct hawser_tow_segment *cable, double length, double r, double cn,
                                   double mass, double radius, double tube, double offset)
{
	*cable = (struct hawser_tow_segment){.length = length, .rho = 1150.0*PI*r*r, .EA = 4e9*PI*r*r,
	                                     .diameter = 2.0*r, .normal = cn, .elements = 100};
	return (struct hawser_tow){
		.g = 9.81, .density = 1.2, .segment = cable, .segments = 1,
		.body = {.kind = HAWSER_TOW_RING, .mass = mass, .offset = offset,
		         .ring = {.radius = radius, .drag = {1.2, tube, cn, 0.0}}}};
}

static int steady(const char *what, struct hawser_tow *tow, double speed, double radius)
{
	struct hawser_tow_steady out;
	struct hawser_report report = {0};
	double velocity[3] = {speed, 0.0, 0.0}, secs = cpu_secs(), residual = 0.0, error = 0.0;
	enum hawser_status status =
		radius > 0.0 ? hawser_path_orbit(&tow->path, origin, radius, speed, 0.0,
		                                 HAWSER_PATH_RAMP_SMOOTH, &report)
		             : hawser_path_straight(&tow->path, origin, velocity, 0.0, HAWSER_PATH_RAMP_SMOOTH,
		                                    &report);

	for (int i = 0; i < TIMES && !status; i++) {
		status = hawser_tow_steady_solve(&out, tow, &report);
		if (status)
			break;
		residual = out.residual;
		error = out.mesh_error;
		hawser_tow_steady_clear(&out);
	}
	printf("%-38s  residual %.1e  mesh error %.1e m  %6.2f ms  %s\n", what, residual, error,
	       1e3*(cpu_secs() - secs)/TIMES, report.message);
	return status != HAWSER_OK;
}

static int turn(int elements)
{
	struct hawser_tow_segment cable;
	struct hawser_tow tow = with_ring(&cable, 10.0, 0.005, 1.3, 50.0, 1.0, 0.05, 1.0);
	struct hawser_waypoint point[4] = {{.t = 0.0}};
	struct hawser_tow_options options = {.every = 0.25};
	struct hawser_tow_motion motion[2] = {{.samples = 0}};
	struct hawser_report report = {0};
	double tilt = 0.0, off = 0.0, secs[2] = {0.0};
	enum hawser_status status;

	cable.EI = 4e9*PI/4.0*pow(0.005, 4.0);
	cable.elements = elements;
	tow.wind[0] = -5.0;
	for (int i = 0; i < 4; i++) {
		point[i].t = (const double [4]){0.0, 30.0, 70.0, 100.0}[i];
		point[i].at[0][0] = i == 1 || i == 2 ? 100.0 : 0.0;
		point[i].at[0][2] = i >= 2 ? 100.0 : 0.0;
		point[i].given[0] = 1;
		point[i].given[1] = point[i].given[2] = i == 0 || i == 3;
	}
	status = hawser_path_waypoints(&tow.path, point, 4, HAWSER_MINIMISE_SNAP, &report);
	for (int k = 0; k < 2 && !status; k++) {
		options.tolerance = k ? 5e-6 : 1e-5;
		secs[k] = cpu_secs();
		status = hawser_tow_move(&motion[k], &tow, &options, &report);
		secs[k] = cpu_secs() - secs[k];
	}
	for (int i = 0; i < motion[0].samples && !status; i++) {
		const double *a = motion[0].sample[i].body, *b = motion[1].sample[i].body;

		off = fmax(off, hypot(hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]));
		if (motion[0].sample[i].t > 50.0)
			tilt = fmax(tilt, motion[0].sample[i].tilt);
	}
	printf("%3d elements: tilt %.4f rad, %.1e m by half the local error, energy %.1e, %ld steps, "
	       "%.2f s: %.0f times as fast  %s\n", elements, tilt, off, motion[0].closure,
	       motion[0].steps, secs[0], 100.0/secs[0], report.message);
	for (int k = 0; k < 2; k++)
		hawser_tow_motion_clear(&motion[k]);
	hawser_path_clear(&tow.path);
	return status || fabs(tilt - 0.042) > 5e-4;
}

int main(void)
{
	struct hawser_tow_segment cable;
	struct hawser_tow tow = with_ring(&cable, 14.0, 0.004, 1.2, 435.0, 11.0, 0.07, 16.0);
	int bad = steady("ring, straight, string", &tow, 27.8, 0.0);

	bad |= steady("ring, orbit of 60 m, string", &tow, 13.9, 60.0);
	cable.EI = 4e9*PI/4.0*pow(0.004, 4.0);
	bad |= steady("ring, straight, rod of 2 x 100 elements", &tow, 27.8, 0.0);
	bad |= steady("ring, orbit of 60 m, rod", &tow, 13.9, 60.0);
	bad |= turn(20);
	bad |= turn(100);
	return bad;
}
