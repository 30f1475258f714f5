/* Towed bodies in water: a free cable at its angle (W5), a steady state that stays, a body that a ship
 * tows through waves against the net that tows the same line.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <hawser/net_motion.h>
#include <hawser/tow.h>

#include "tests/tap.h"

static struct hawser_water_level level[2];
static struct hawser_tow_segment segment;

static struct hawser_tow tow_of(double length, double rho, double tangential)
{
	level[0] = (struct hawser_water_level){-100.0, {-0.2, 0.0, 0.1}};
	level[1] = (struct hawser_water_level){0.0, {0.5, 0.0, 0.4}};
	segment = (struct hawser_tow_segment){
		.length = length, .rho = rho, .EA = 2e5, .EI = 1.0, .diameter = 0.02, .normal = 1.2,
		.tangential = tangential, .added_normal = 1.0, .added_tangential = 0.1, .elements = 20};
	return (struct hawser_tow){.g = 9.81, .density = 1025.0, .segment = &segment, .segments = 1,
	                           .water = {.density = 1025.0, .current = level}};
}

/* At 2 m/s without a body: straight, 17.54475 degrees below the towing point, 317.0023 N. */
static void angle(void)
{
	struct hawser_tow tow = tow_of(100.0, 0.8, 0.015);
	struct hawser_tow_steady steady = {0};
	struct hawser_report report = {0};
	const double degree = acos(-1.0)/180.0;

	segment.EA = INFINITY;
	segment.EI = 0.0;
	tow.path = (struct hawser_path){.kind = HAWSER_PATH_STRAIGHT, .to = INFINITY,
	                                .velocity = {2.0, 0.0, 0.0}, .origin = {0.0, -10.0, 0.0}};
	if (!ok(hawser_tow_steady_solve(&steady, &tow, &report) == HAWSER_OK, "W5: %s", report.message))
		return;
	close_to(steady.tension_top, 317.0023, 2e-7, "W5: tension");
	close_to(steady.state.depth, 100.0*sin(17.54475*degree), 2e-7, "W5: depth");
	hawser_tow_steady_clear(&steady);
}

/* Towed by a ship that gets under way, in a current that changes with the depth. */
static struct hawser_tow ship(double ramp)
{
	struct hawser_tow tow = tow_of(40.0, 1.2, 0.015);

	tow.path = (struct hawser_path){
		.kind = HAWSER_PATH_STRAIGHT, .to = INFINITY, .velocity = {1.5, 0.0, 0.3},
		.origin = {0.0, -3.0, 0.0}, .ramp_time = ramp};
	tow.body = (struct hawser_tow_body){.kind = HAWSER_TOW_MASS, .mass = 300.0, .CdA = 0.3,
	                                    .volume = 0.2, .added = 0.5, .inertia = 1.0};
	tow.water.levels = 2;
	return tow;
}

static void stays(void)
{
	const struct hawser_tow_options options = {.until = 20.0, .every = 20.0};
	struct hawser_tow tow = ship(0.0);
	struct hawser_tow_motion motion = {0};
	struct hawser_report report = {0};

	if (!ok(hawser_tow_move(&motion, &tow, &options, &report) == HAWSER_OK && motion.samples == 2,
	        "steady towing: %s", report.message))
		return;
	for (int k = 0; k < 3; k++)
		ok(fabs(motion.sample[1].end[k] - motion.sample[0].end[k] - 20.0*tow.path.velocity[k]) < 1e-6,
		   "the end stays where it is below the ship: %.8f, %.8f m", motion.sample[0].end[k],
		   motion.sample[1].end[k] - 20.0*tow.path.velocity[k]);
	hawser_tow_motion_clear(&motion);
}

/* The places of the towing point as a table of displacements. */
static int write_path(char *name, const struct hawser_path *path)
{
	int file = mkstemp(name);
	FILE *stream = file < 0 ? NULL : fdopen(file, "w");
	struct hawser_report report;
	double state[HAWSER_PATH_ORDERS][3];

	for (int i = 0; stream && i <= 300; i++) {
		if (hawser_path_at(state, path, 0.1*i, &report))
			break;
		fprintf(stream, "%.17g", 0.1*i);
		for (int k = 0; k < 3; k++)
			fprintf(stream, " %.17g", state[0][k] - path->origin[k]);
		fputc('\n', stream);
	}
	return stream && !fclose(stream);
}

static void net(void)
{
	static char name[] = "towed", path[] = "path-XXXXXX";
	const struct hawser_tow_options options = {.until = 20.0, .every = 10.0, .step = 0.02};
	const struct hawser_net_probe probe = {1, -1, 0.0};
	const struct hawser_net_motion_options same = {.until = 20.0, .every = 10.0, .step = 0.02,
	                                               .probe = &probe, .probes = 1};
	struct hawser_tow tow = ship(10.0);
	struct hawser_tow_motion motion = {0};
	struct hawser_net_motion other = {0};
	struct hawser_report report = {0};
	struct hawser_net_node node[2] = {{.name = "A", .x = {0.0, -3.0, 0.0}, .placed = 1, .support = 1,
	                                   .held = {1, 1, 1}, .table = path},
	                                  {.name = "B", .mass = 300.0, .buoy = {300.0, 0.2, 0.3, 0.5}}};
	struct hawser_net_cable cable = {.name = "c", .to = 1, .EA = 2e5, .rho = 1.2, .value = 40.0,
	                                 .line = {0.02, 1.2, 0.015, 1.0, 0.1}, .elements = 40,
	                                 .elements_given = 1};
	struct hawser_net line = {.name = name, .g = 9.81, .node = node, .cable = &cable, .nodes = 2,
	                          .cables = 1, .dynamics = {.rho_inf = -1.0}};

	segment.elements = 40;
	tow.water.given = (struct hawser_waves_given){.height = 4.0, .period = 7.0, .depth = 100.0,
	                                              .ramp = 7.0, .heading = 0.5};
	ok(write_path(path, &tow.path), "path of the ship");
	ok(hawser_waves_make(&tow.water.waves, &tow.water.given, &report) == HAWSER_OK, "waves");
	line.water = tow.water;
	if (ok(hawser_tow_move(&motion, &tow, &options, &report) == HAWSER_OK && motion.samples == 3,
	       "towed through waves: %s", report.message) &&
	    ok(hawser_net_integrate(&other, &line, &same, &report) == HAWSER_OK && other.rows == 3,
	       "a net: %s", report.message)) {
		for (int i = 3; i < 9; i++)
			ok(fabs(motion.sample[i/3].body[i%3] - other.x[i/3][i%3]) < 1.2e-4, "%c of the body at %d "
			   "s: %.6f, of the net %.6f m", "xyz"[i%3], 10*(i/3), motion.sample[i/3].body[i%3],
			   other.x[i/3][i%3]);
		ok(fabs(motion.closure) < 1e-6, "the ledger closes to %.1e", motion.closure);
	}
	unlink(path);
	hawser_tow_motion_clear(&motion);
	hawser_net_motion_clear(&other);
	hawser_waves_clear(&tow.water.waves);
}

CASE(reference_tow_water)
{
	angle();
	stays();
	net();
	return done_testing();
}
