/* Motions and modes of nets in water against closed forms, an integrator of ordinary differential
 * equations, and numbers of two other programs (doc/water.md).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <hawser/net_modes.h>
#include <hawser/net_motion.h>

#include "net/water/water.h"
#include "tests/tap.h"

struct swim {
	struct hawser_net net;
	struct hawser_net_node node[2];
	struct hawser_net_cable cable;
	struct hawser_water_level level;
};

/* One cable from A, of this length, with water far below the surface. */
static void swim_of(struct swim *swim, const double A[3], const double B[3], double length0, double EA,
                    double rho, double diameter, int elements)
{
	static char name[] = "swim";

	memset(swim, 0, sizeof *swim);
	swim->net = (struct hawser_net){.name = name, .g = 9.81, .node = swim->node, .cable = &swim->cable,
	                                .nodes = 2, .cables = 1,
	                                .dynamics = {.rho_inf = -1.0},
	                                .water = {.density = 1025.0, .current = &swim->level}};
	for (int i = 0; i < 2; i++) {
		swim->node[i] = (struct hawser_net_node){.name = {(char)('A' + i)}, .placed = 1, .support = 1,
		                                         .held = {1, 1, 1}};
		memcpy(swim->node[i].x, i ? B : A, sizeof swim->node[i].x);
	}
	swim->cable = (struct hawser_net_cable){.name = "c", .from = 0, .to = 1, .EA = EA, .rho = rho,
	                                        .line = {diameter, 1.2, 0.02, 1.0, 0.1}, .value = length0,
	                                        .elements = elements, .elements_given = 1};
}

static int swum(struct hawser_net_motion *motion, const struct swim *swim, double until, double every,
                double step, const struct hawser_net_probe *probe)
{
	const struct hawser_net_motion_options options = {.until = until, .every = every, .step = step,
	                                                  .probe = probe, .probes = 1};
	struct hawser_report report = {0};
	enum hawser_status status = hawser_net_integrate(motion, &swim->net, &options, &report);

	return ok(!status, "%s", status ? report.message : "a motion in water") &&
	       ok(motion->closure < 1e-10, "the ledger closes to %.1e", motion->closure);
}

static void small(struct swim swim)
{
	struct hawser_net_modes modes = {0};
	struct hawser_report report = {0};

	swim.net.node = swim.node;
	swim.net.cable = &swim.cable;
	swim.net.water.current = &swim.level;
	swim.net.dynamics.releases = 0;
	swim.cable.EA = 1e13;
	memset(swim.node[1].held, 0, 3);
	swim.node[1].support = 0;
	if (ok(!hawser_net_modes_solve(&modes, &swim.net, 2, &report), "W8: %s", report.message))
		close_to(2.0*M_PI/modes.omega[0], 9.497363, 1e-7, "W8: period of small motions");
	hawser_net_modes_clear(&modes);
}

/* The buoy on a rigid tether: its small motions, and from 0.5 rad. */
static void pendulum(void)
{
	static const double at[2][2] = {{5.0501, -0.2361234}, {9.8858, 0.1567916}};
	struct hawser_net_motion motion = {0};
	int released = 1;
	struct swim swim;

	swim_of(&swim, (const double[3]){0.0, -50.0, 0.0},
	        (const double[3]){20.0*sin(0.5), -50.0 + 20.0*cos(0.5), 0.0}, 20.0, 1e8, 0.0, 0.0, 1);
	swim.node[1].buoy = (struct hawser_water_buoy){1200.0, 4.0, 0.5, 0.5};
	swim.node[1].mass = 1200.0;
	swim.net.dynamics.release = &released;
	swim.net.dynamics.releases = 1;
	small(swim);
	for (int i = 0; i < 2; i++) {
		if (!swum(&motion, &swim, at[i][0], at[i][0], 0.01, &(struct hawser_net_probe){1, -1, 0.0}))
			return;
		close_to(motion.x[motion.rows - 1][0], 20.0*sin(at[i][1]), 1e-3, "W8: place of the buoy");
		hawser_net_motion_clear(&motion);
	}
}

/* A level cable that sinks from rest, all at one speed. */
static void sinks(void)
{
	struct hawser_net_motion motion = {0};
	int released[2] = {0, 1};
	struct swim swim;

	swim_of(&swim, (const double[3]){0.0, -50.0, 0.0}, (const double[3]){10.0, -50.0, 0.0}, 10.0, 1e6,
	        12.0, 0.08, 1);
	swim.net.dynamics.release = released;
	swim.net.dynamics.releases = 2;
	if (swum(&motion, &swim, 0.2983513, 0.2983513, 5e-4, &(struct hawser_net_probe){1, -1, 0.0}))
		close_to(-motion.v[motion.rows - 1][1], 0.8899195, 1e-4, "W6: speed of sinking");
	hawser_net_motion_clear(&motion);
}

/* A buoy that weighs nothing in the water, on a slack line, goes with a current that grows with
 * time. */
static void drifts(void)
{
	char path[] = P_tmpdir "/hawser-current-XXXXXX";
	static const char rows[] = "# t ux uy uz\n0 0 0 0\n5 0.5 0 0.1\n10 1 0 0.2\n";
	struct hawser_net_motion motion = {0};
	int released = 1, handle = mkstemp(path);
	struct swim swim;

	if (handle < 0 || write(handle, rows, sizeof rows - 1) != (ssize_t)sizeof rows - 1)
		exit(99);
	close(handle);
	swim_of(&swim, (const double[3]){0.0, -50.0, 0.0}, (const double[3]){20.0, -50.0, 0.0}, 90.0, 1e6,
	        0.0, 0.0, 1);
	swim.net.water.levels = 1;
	swim.net.water.file = path;
	swim.node[1].buoy = (struct hawser_water_buoy){2050.0, 2.0, 1.3, 0.5};
	swim.node[1].mass = 2050.0;
	swim.net.dynamics.release = &released;
	swim.net.dynamics.releases = 1;
	if (swum(&motion, &swim, 7.3, 7.3, 0.1, &(struct hawser_net_probe){1, -1, 0.0})) {
		close_to(motion.v[motion.rows - 1][0], 0.73, 1e-12, "velocity with the current");
		close_to(motion.v[motion.rows - 1][2], 0.146, 1e-12, "velocity with the current along z");
	}
	hawser_net_motion_clear(&motion);
	remove(path);
}

/* The speeds at which cables of three directions sink steadily: the loads are in balance. */
static void steady(void)
{
	static const double turned[3] = {0.0, M_PI/2.0, M_PI/6.0};
	static const double speed[3][2] = {{0.0, -1.168496}, {0.0, -5.106552}, {2.583408, -2.747162}};
	struct hawser_report report = {0};
	struct hawser__mesh mesh;
	struct swim swim;

	swim_of(&swim, (const double[3]){0.0, -50.0, 0.0}, (const double[3]){1.0, -50.0, 0.0}, 1.0, 1e6,
	        12.0, 0.08, 1);
	if (!ok(!hawser__mesh_build(&mesh, &swim.net, &report), "a mesh"))
		return;
	for (int i = 0; i < 3; i++) {
		const double c = cos(turned[i]), s = sin(turned[i]), d[3] = {c, -s, 0.0};
		struct hawser__water_past past[2] = {{.height = -50.0}, {.height = -50.0}};
		struct hawser__water_end end[2];
		double f[2];

		for (int k = 0; k < 2; k++)
			past[0].r[k] = past[1].r[k] = -speed[i][k];
		hawser__water_ends(end, &mesh, 0, d, past, 1);
		f[0] = end[0].load[0] + end[1].load[0];
		f[1] = end[0].load[1] + end[1].load[1] - 12.0*9.81;
		ok(hypot(f[0], f[1]) < 2e-5*12.0*9.81, "W6: sinks steadily at %.0f degrees: %.1e N/m are "
		   "left",
		   turned[i]*180.0/M_PI, hypot(f[0], f[1]));
	}
	hawser__mesh_clear(&mesh);
}

/* The derivatives of the loads on an element by everything, against differences. */
static void slopes(void)
{
	struct hawser_report report = {0};
	struct hawser__mesh mesh;
	struct hawser__water_past past[2] = {
		{-0.3, {0.0}, {1.1, -0.4, 0.3}, {0.2, 0.5, -0.1}, {0.3, -0.2, 0.7}},
		{0.2, {0.0}, {0.9, -0.2, 0.1}, {0.1, 0.4, -0.2}, {0.1, -0.3, 0.5}}};
	double d[3] = {0.8, 0.5, -0.3}, off[4] = {0.0};
	const double h = 1e-6;
	struct swim swim;

	swim_of(&swim, (const double[3]){0.0}, (const double[3]){1.0}, 1.0, 1e6, 12.0, 0.08, 1);
	if (!ok(!hawser__mesh_build(&mesh, &swim.net, &report), "a mesh"))
		return;
	mesh.water->band = 0.7;
	for (int which = 0; which < 12; which++) {
		double *of = which < 3 ? &d[which] : which < 6 ? &past[1].r[which - 3]
			: which < 9 ? &past[1].a[which - 6] : &past[which - 9 > 0].height;
		struct hawser__water_end end[2], up[2], down[2];

		if (which == 11)
			break;
		hawser__water_ends(end, &mesh, 0, d, past, 1);
		*of += h;
		hawser__water_ends(up, &mesh, 0, d, past, 1);
		*of -= 2.0*h;
		hawser__water_ends(down, &mesh, 0, d, past, 1);
		*of += h;
		for (int k = 0; k < 3; k++) {
			double slope = which < 3 ? end[1].by_d[k][which] : which < 6 ? end[1].by_r[k][which - 3]
				: which < 9 ? -end[1].mass[k][which - 6] : end[1].by_y[which - 9][k];

			off[which/3] = fmax(off[which/3], fabs(slope - (up[1].load[k] - down[1].load[k])/(2.0*h)));
		}
	}
	ok(off[0] < 1e-6 && off[1] < 1e-6 && off[2] < 1e-6 && off[3] < 1e-5,
	   "derivatives by direction, velocity, acceleration, height: %.1e, %.1e, %.1e, %.1e", off[0],
	   off[1], off[2], off[3]);
	hawser__mesh_clear(&mesh);
}

/* The taut string with added mass, without weight. */
static void string_modes(void)
{
	struct hawser_net_modes modes = {0};
	struct hawser_report report = {0};
	struct swim swim;

	swim_of(&swim, (const double[3]){0.0, -50.0, 0.0}, (const double[3]){101.0, -50.0, 0.0}, 100.0, 5e6,
	        8.2, 0.1, 40);
	swim.cable.line.added_tangential = 0.2;
	swim.net.g = 0.0;
	if (ok(!hawser_net_modes_solve(&modes, &swim.net, 30, &report), "modes in water%s",
	       report.message)) {
		close_to(modes.omega[0]/(2.0*M_PI), 0.2759709, 2e-4, "W7: first mode across");
		close_to(modes.omega[3]/(2.0*M_PI), 2.0*0.2759709, 6e-4, "W7: second mode across");
		for (int i = 0; i < modes.n; i++)
			if (modes.along[i] > 0.99) {
				close_to(modes.omega[i]/(2.0*M_PI), 3.569596, 2e-4, "W7: first mode along");
				break;
			}
	}
	hawser_net_modes_clear(&modes);
}

/* A floating sphere on a soft line: the waterplane is its spring. */
static void heave(void)
{
	struct hawser_net_modes modes = {0};
	struct hawser_net_statics st = {0};
	struct hawser_report report = {0};
	struct swim swim;

	swim_of(&swim, (const double[3]){0.0, -100.0, 0.0}, (const double[3]){0.0}, 99.0, 2e5, 0.0, 0.0, 1);
	swim.node[1].buoy = (struct hawser_water_buoy){3000.0, 8.0, 3.0, 0.5};
	swim.node[1].mass = 3000.0;
	memset(swim.node[1].held, 0, 3);
	if (ok(!hawser_net_solve(&st, &swim.net, NULL, &report), "a buoy that floats: %s",
	       report.message) &&
	    ok(!hawser_net_modes_solve(&modes, &swim.net, 3, &report), "its modes")) {
		double r = cbrt(0.75*8.0/M_PI), h = r - st.x[1][1], wet = M_PI*h*h*(3.0*r - h)/3.0;
		double k = 2e5/99.0 + 1025.0*9.81*M_PI*h*(2.0*r - h), m = 3000.0 + 0.5*1025.0*wet;

		close_to(1025.0*9.81*wet, 3000.0*9.81 + st.member[0].T_to, 1e-9, "it carries the weight");
		close_to(modes.omega[2], sqrt(k/m), 1e-9, "heave");
	}
	hawser_net_statics_clear(&st);
	hawser_net_modes_clear(&modes);
}

/* A tether with a buoy in regular waves: the range of its motion and of the pull on the bed. */
static void tethered(void)
{
	const struct hawser_waves_given given = {.height = 4.0, .period = 9.0, .depth = 60.0, .ramp = 18.0,
	                                         .stretching = HAWSER_STRETCH_NONE};
	struct hawser_net_motion motion = {0};
	struct hawser_report report = {0};
	double least = INFINITY, most = -INFINITY;
	struct swim swim;

	swim_of(&swim, (const double[3]){0.0, -60.0, 0.0}, (const double[3]){0.0, -12.0, 0.0}, 48.0, 8e6,
	        6.0, 0.08, 10);
	swim.node[1].buoy = (struct hawser_water_buoy){3000.0, 8.0, 3.0, 0.5};
	swim.node[1].mass = 3000.0;
	memset(swim.node[1].held, 0, 3);
	swim.node[1].support = 0;
	if (ok(!hawser_waves_make(&swim.net.water.waves, &given, &report), "waves") &&
	    swum(&motion, &swim, 90.0, 0.1, 0.05, &(struct hawser_net_probe){1, -1, 0.0})) {
		for (int i = 0; i < motion.rows; i++)
			if (motion.time[i] >= 81.0) {
				least = fmin(least, motion.x[i][0]);
				most = fmax(most, motion.x[i][0]);
			}
		close_to(least, -2.075, 3e-3, "W12: least x of the buoy");
		close_to(most, 2.726, 3e-3, "W12: largest x of the buoy");
	}
	hawser_net_motion_clear(&motion);
	hawser_waves_clear(&swim.net.water.waves);
}

/* The heave of a fairlead, in a table of its places. */
static int heaves(char *path)
{
	int handle = mkstemp(path);
	FILE *file = handle < 0 ? NULL : fdopen(handle, "w");

	for (int i = 0; i <= 2404 && file; i++) {
		double t = 0.025*i, q = fmin(t/20.0, 1.0), part = q*q*q*(10.0 - 15.0*q + 6.0*q*q);

		fprintf(file, "%.17g 0 %.17g 0\n", t, part*sin(2.0*M_PI*t/10.0));
	}
	return file && !fclose(file);
}

/* A chain on a bed that gives way, whose upper end heaves: the ranges of the forces at both ends. */
static void heaved(void)
{
	static const double expected[2][2] = {{855.9e3, 943.8e3}, {1049.5e3, 1146.3e3}};
	char path[] = "/tmp/hawser-heave-XXXXXX";
	struct hawser_surface surface = {.kind = HAWSER_SURFACE_PLANE, .normal = {0.0, 1.0, 0.0},
	                                 .stiffness = 3e6, .damping = 3e5};
	const struct hawser_net_probe probe[2] = {{0, -1, 0.0}, {1, -1, 0.0}};
	const struct hawser_net_motion_options options = {.until = 60.0, .every = 0.1, .step = 0.05,
	                                                  .probe = probe, .probes = 2};
	struct hawser_net_motion motion = {0};
	struct hawser_report report = {0};
	double range[2][2] = {{INFINITY, 0.0}, {INFINITY, 0.0}};
	struct swim swim;

	swim_of(&swim, (const double[3]){0.0}, (const double[3]){796.732, 186.0, 0.0}, 835.5, 753.6e6,
	        113.35, 0.0766, 40);
	swim.cable.line = (struct hawser_water_line){0.0766, 2.0, 0.4, 1.0, 0.0};
	swim.net.water.surface = 186.0;
	swim.net.surface = &surface;
	swim.net.surfaces = 1;
	swim.node[1].table = path;
	if (!ok(heaves(path), "a table"))
		return;
	if (ok(!hawser_net_integrate(&motion, &swim.net, &options, &report), "a chain%s", report.message)) {
		ok(motion.closure < 1e-10, "the ledger closes to %.1e", motion.closure);
		for (int i = 0; i < 2*motion.rows; i++) {
			double f = hypot(motion.pull[i][0], motion.pull[i][1]);

			if (motion.time[i/2] < 50.0)
				continue;
			range[i%2][0] = fmin(range[i%2][0], f);
			range[i%2][1] = fmax(range[i%2][1], f);
		}
		for (int i = 0; i < 4; i++)
			close_to(range[i/2][i%2], expected[i/2][i%2], 5e-4, "a pull on a support");
	}
	hawser_net_motion_clear(&motion);
	unlink(path);
}

CASE(reference_net_water_motion)
{
	pendulum();
	sinks();
	drifts();
	steady();
	slopes();
	string_modes();
	heave();
	tethered();
	heaved();
	return done_testing();
}
