/* Rods in water: against a string of two other programs (W2), an integrator of the angle of a rigid rod
 * (W21, and in waves: bench/rod-waves.py), free sinking (W6), and nets, whose cables do not bend.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/net_motion.h>
#include <hawser/rod_motion.h>

#include "tests/tap.h"

enum { MOST_ROWS = 30 };

static struct hawser_rod_segment segment;
static struct hawser_water_level level;

/* Rigid, of the bench: 20 m long, 0.8 m thick, hinged 60 m below the surface, at this angle. */
static struct hawser_rod pole(double angle)
{
	level = (struct hawser_water_level){0.0, {0.0}};
	segment = (struct hawser_rod_segment){
		.length = 20.0, .rho = 200.0, .EA = 20e9, .GA = {8e9, 8e9}, .EI = {200e9, 200e9}, .GJ = 100e9,
		.inertia = {16.0, 8.0, 8.0}, .line = {0.8, 1.0, 0.0, 1.0, 0.0}};
	return (struct hawser_rod){
		.segment = &segment, .segments = 1, .length = 20.0, .g = 9.81,
		.hold = {HAWSER_ROD_HINGED, HAWSER_ROD_FREE}, .at = {0.0, -60.0, 0.0},
		.tangent = {sin(angle), cos(angle), 0.0}, .normal = {cos(angle), -sin(angle), 0.0},
		.rho_inf = 0.8, .water = {.density = 1025.0, .current = &level}};
}

static struct hawser_rod_motion run(const struct hawser_rod *rod, double until, double every,
                                    double step, int elements, double probe)
{
	const struct hawser_rod_motion_options options = {.until = until, .every = every, .step = step,
	                                                  .probe = &probe, .probes = 1, .skip_error = 1};
	struct hawser_rod_motion motion = {0};
	struct hawser_report report = {0};

	rod->segment->elements = elements;
	ok(hawser_rod_integrate(&motion, rod, &options, &report) == HAWSER_OK, "a rod in water: %s",
	   report.message);
	return motion;
}

/* Angles of the pole at these rows, extrapolated from 10 and 20 elements. */
static void angles(double *angle, const struct hawser_rod *rod, const int *row, int rows, double until,
                   double every)
{
	for (int mesh = 0; mesh < 2; mesh++) {
		struct hawser_rod_motion motion = run(rod, until, every, 0.01, 10 << mesh, 20.0);

		for (int i = 0; i < rows && motion.rows > row[i]; i++) {
			double now = atan2(motion.x[row[i]][0], motion.x[row[i]][1] + 60.0);

			angle[i] = mesh ? now + (now - angle[i])/3.0 : now;
		}
		hawser_rod_motion_clear(&motion);
	}
}

static void rigid(void)
{
	static const double want[] = {0.04777027, -0.05420999, 0.04110826, -0.01436293, -0.0060602};
	static const int row[] = {5, 7, 9, 11, 13}, last = 1;
	struct hawser_rod rod = pole(0.3);
	double angle[MOST_ROWS] = {0.0};
	struct hawser_report report = {0};

	rod.from_rest = 1;
	angles(angle, &rod, &last, 1, 7.0939, 7.0939);
	ok(fabs(angle[0] + 0.0573358) < 3e-6, "W21: %.7f rad at 7.0939 s, from 0.3 rad", angle[0]);
	rod = pole(0.0);
	rod.water.given = (struct hawser_waves_given){.height = 4.0, .period = 9.0, .depth = 60.0,
	                                              .ramp = 9.0, .stretching = HAWSER_STRETCH_NONE};
	ok(hawser_waves_make(&rod.water.waves, &rod.water.given, &report) == HAWSER_OK, "waves");
	angles(angle, &rod, row, 5, 26.0, 2.0);
	for (int i = 0; i < 5; i++)
		ok(fabs(angle[i] - want[i]) < 3e-6, "in waves at %d s: %.7f rad, integrated %.7f", 2*row[i],
		   angle[i], want[i]);
	hawser_waves_clear(&rod.water.waves);
}

/* Steps of half the length leave less than a third of what the ledger lacks, and of the change of the
 * angle. */
static void order(void)
{
	struct hawser_rod rod = pole(0.0);
	struct hawser_report report = {0};
	double x[3] = {0.0}, closure[3] = {0.0};

	rod.water.given = (struct hawser_waves_given){.height = 4.0, .period = 9.0, .depth = 60.0,
	                                              .ramp = 9.0, .stretching = HAWSER_STRETCH_NONE};
	ok(hawser_waves_make(&rod.water.waves, &rod.water.given, &report) == HAWSER_OK, "waves");
	for (int i = 0; i < 3; i++) {
		struct hawser_rod_motion motion = run(&rod, 12.0, 12.0, 0.08/(1 << i), 4, 20.0);

		closure[i] = motion.closure;
		if (motion.rows == 2)
			x[i] = motion.x[1][0];
		hawser_rod_motion_clear(&motion);
	}
	ok(closure[1] < closure[0]/3.0 && closure[2] < closure[1]/3.0 && closure[2] < 1e-5,
	   "the ledger closes to %.1e, %.1e, %.1e", closure[0], closure[1], closure[2]);
	ok(fabs((x[0] - x[1])/(x[1] - x[2]) - 4.0) < 0.2, "order of the steps: differences in the ratio "
	   "%.3f", (x[0] - x[1])/(x[1] - x[2]));
	hawser_waves_clear(&rod.water.waves);
}

/* W2: 300 m in a uniform current, between supports. */
static void string(void)
{
	static const double A[] = {10654.75, 5079.19, 3794.18}, B[] = {-2652.88, -11045.70, 5838.36};
	struct hawser_rod_statics st = {0};
	struct hawser_report report = {0};
	struct hawser_rod rod = pole(0.0);
	double most = 0.0;

	segment = (struct hawser_rod_segment){
		.length = 300.0, .rho = 12.0, .EA = 20e6, .GA = {20e6, 20e6}, .EI = {1.0, 1.0}, .GJ = 1.0,
		.line = {0.12, 1.2, 0.02, 1.0, 0.0}, .elements = 100};
	rod.length = 300.0;
	rod.at[1] = -200.0;
	rod.hold[1] = HAWSER_ROD_HINGED;
	rod.placed = 1;
	rod.end_at[0] = 200.0;
	rod.water.levels = 1;
	memcpy(level.u, (const double[3]){0.8, 0.0, 0.6}, sizeof level.u);
	ok(hawser_rod_solve(&st, &rod, &(struct hawser_rod_options){.skip_error = 1}, &report) ==
	   HAWSER_OK, "a line in a current: %s", report.message);
	for (int k = 0; k < 3; k++)
		most = fmax(most, fmax(fabs(st.force[0][k] + A[k]), fabs(st.force[1][k] + B[k])));
	ok(most < 2e-4*11045.70, "W2 as a rod: forces on supports to %.2g N", most);
	ok(fabs(st.wet - 300.0) < 1e-3 && !st.judged, "%.6f m are wet, and nothing is said of stability",
	   st.wet);
	hawser_rod_statics_clear(&st);
}

/* A hose that rises from a hinge 5 m below the surface and floats: away from there its weight is that
 * of the water displaced, and the height follows from the part of a section that is wet. */
static void floats(void)
{
	const double part = 10.0/(1025.0*0.01*acos(-1.0));
	struct hawser_rod_statics st = {0};
	struct hawser_report report = {0};
	struct hawser_rod rod = pole(0.0);

	segment = (struct hawser_rod_segment){
		.length = 60.0, .rho = 10.0, .EA = 20e6, .GA = {8e6, 8e6}, .EI = {2e4, 2e4}, .GJ = 15e3,
		.line = {0.2, 1.2, 0.02, 1.0, 0.0}, .elements = 40};
	rod.length = 60.0;
	rod.at[1] = -5.0;
	memcpy(rod.tangent, (const double[3]){1.0, 0.0, 0.0}, sizeof rod.tangent);
	memcpy(rod.normal, (const double[3]){0.0, 1.0, 0.0}, sizeof rod.normal);
	if (ok(hawser_rod_solve(&st, &rod, &(struct hawser_rod_options){.skip_error = 1}, &report) ==
	       HAWSER_OK, "a hose that floats: %s", report.message)) {
		close_to(st.point[36].x[1], 0.002*(0.5 - part), 1e-7, "its height on the surface, m");
		close_to(600.0*9.81 - st.force[0][1], st.wet*1025.0*9.81*0.01*acos(-1.0), 1e-9,
		         "its buoyancy, N");
		ok(st.judged && !st.negative, "it is stable");
	}
	hawser_rod_statics_clear(&st);
}

/* W6: a free rod, level and without a bend, sinks at one speed. */
static void sinking(void)
{
	struct hawser_rod rod = pole(0.0);
	struct hawser_rod_motion motion;

	segment = (struct hawser_rod_segment){
		.length = 10.0, .rho = 12.0, .EA = 1e6, .GA = {1e6, 1e6}, .EI = {1e4, 1e4}, .GJ = 1e4,
		.inertia = {2.0, 1.0, 1.0}, .line = {0.08, 1.2, 0.02, 1.0, 0.1}};
	rod.length = 10.0;
	rod.hold[0] = HAWSER_ROD_FREE;
	memcpy(rod.tangent, (const double[3]){1.0, 0.0, 0.0}, sizeof rod.tangent);
	memcpy(rod.normal, (const double[3]){0.0, 1.0, 0.0}, sizeof rod.normal);
	motion = run(&rod, 0.2983513, 0.2983513, 0.003, 4, 5.0);
	if (motion.rows == 2)
		close_to(-motion.v[1][1], 0.8899195, 2e-5, "W6, level: speed at 0.2983513 s");
	hawser_rod_motion_clear(&motion);
	motion = run(&rod, 3.0, 3.0, 0.01, 4, 5.0);
	if (motion.rows == 2)
		close_to(-motion.v[1][1], 1.168496, 1e-6, "W6, level: the speed that it comes to");
	hawser_rod_motion_clear(&motion);
}

/* A slack line in a current and oblique waves, as a rod that hardly bends and as a cable of a net. */
static void net(void)
{
	static char name[] = "line";
	const struct hawser_net_probe probe = {-1, 0, 0.5};
	const struct hawser_net_motion_options options = {.until = 12.0, .every = 4.0, .step = 0.04,
	                                                  .probe = &probe, .probes = 1};
	struct hawser_report report = {0};
	struct hawser_rod rod = pole(0.0);
	double apart[2] = {0.0};
	struct hawser_net_node node[2] = {{.name = "A", .x = {0.0, -30.0, 0.0}}, {.name = "B"}};
	struct hawser_net_cable one = {.name = "c", .to = 1, .EA = 20e6, .rho = 18.0, .value = 62.0,
	                               .line = {0.12, 1.2, 0.02, 1.0, 0.1}, .elements_given = 1};
	struct hawser_net line = {.name = name, .g = 9.81, .node = node, .cable = &one, .nodes = 2,
	                          .cables = 1, .dynamics = {.rho_inf = -1.0}};

	segment = (struct hawser_rod_segment){
		.length = 62.0, .rho = 18.0, .EA = 20e6, .GA = {8e6, 8e6}, .EI = {1.0, 1.0}, .GJ = 1.0,
		.inertia = {2e-4, 1e-4, 1e-4}, .line = one.line};
	rod.length = 62.0;
	rod.at[1] = -30.0;
	rod.hold[1] = HAWSER_ROD_HINGED;
	rod.placed = rod.water.levels = 1;
	rod.end_at[0] = node[1].x[0] = 50.0;
	rod.end_at[1] = node[1].x[1] = -10.0;
	memcpy(level.u, (const double[3]){0.5, 0.0, 0.3}, sizeof level.u);
	memcpy(rod.tangent, (const double[3]){1.0, 0.0, 0.0}, sizeof rod.tangent);
	memcpy(rod.normal, (const double[3]){0.0, 1.0, 0.0}, sizeof rod.normal);
	rod.water.given = (struct hawser_waves_given){.height = 6.0, .period = 8.0, .depth = 60.0,
	                                              .ramp = 4.0, .heading = 0.4};
	ok(hawser_waves_make(&rod.water.waves, &rod.water.given, &report) == HAWSER_OK, "waves");
	for (int i = 0; i < 2; i++) {
		node[i].placed = node[i].support = 1;
		memset(node[i].held, 1, sizeof node[i].held);
	}
	line.water = rod.water;
	for (int mesh = 0; mesh < 2; mesh++) {
		struct hawser_rod_motion motion = run(&rod, 12.0, 4.0, 0.04, 30 << mesh, 31.0);
		struct hawser_net_motion cable = {0};

		one.elements = 30 << mesh;
		ok(hawser_net_integrate(&cable, &line, &options, &report) == HAWSER_OK, "a net: %s",
		   report.message);
		for (int i = 0; i < 12 && motion.rows == 4 && cable.rows == 4; i++)
			apart[mesh] = fmax(apart[mesh], fabs(motion.x[i/3][i%3] - cable.x[i/3][i%3]));
		ok(motion.rows == 4 && fabs(motion.x[2][2] - motion.x[1][2]) > 0.1, "it moves");
		hawser_net_motion_clear(&cable);
		hawser_rod_motion_clear(&motion);
	}
	ok(apart[1] < 1e-4 && apart[1] < apart[0]/3.0, "a rod and a cable in waves, 30 and 60 elements: "
	   "middles apart by %.2g and %.2g m", apart[0], apart[1]);
	hawser_waves_clear(&rod.water.waves);
}

CASE(reference_rod_water)
{
	rigid();
	order();
	string();
	floats();
	sinking();
	net();
	return done_testing();
}
