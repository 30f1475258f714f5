/* Loads of a towed cable in motion: their derivatives by places, turns, velocities and spins against
 * differences; winds in time.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>

#include "tests/tap.h"
#include "tow/motion.h"

enum { FREE = HAWSER__ROD_FREE, MOST = 6*FREE };
#define STEP 1e-5 /* of differences: m, rad, m/s, rad/s */

static void forces(double *f, struct hawser__tow_run *run, int tangent)
{
	struct hawser__rod_mesh *mesh = run->motion.mesh;

	(void)hawser__rod_strains(mesh);
	memset(run->motion.pushed, 0, (size_t)mesh->nodes*sizeof *run->motion.pushed);
	if (tangent)
		hawser__band_zero(&mesh->band);
	(void)hawser__tow_push(run, &run->motion, 0.3, tangent);
	memcpy(f, run->motion.pushed, (size_t)mesh->n*sizeof *f);
}

/* Change unknown j of a node by `by`: its place or turn, or its velocity or spin. */
static void change(struct hawser__tow_run *run, int node, int j, int velocity, double by)
{
	double turn[3] = {0.0};

	if (velocity) {
		run->motion.velocity[node][j] += by;
	} else if (j < 3) {
		run->motion.mesh->node[node].x[j] += by;
	} else {
		turn[j - 3] = by;
		hawser__quaternion_turn(run->motion.mesh->node[node].q, turn);
	}
}

static void compare(struct hawser__tow_run *run, const char *what)
{
	struct hawser__rod_mesh *mesh = run->motion.mesh;
	double f[2][MOST], none[MOST], worst = 0.0, most = 0.0;

	for (int velocity = 0; velocity < 2; velocity++)
		for (int c = 0; c < mesh->n; c++) {
			struct hawser__rod_node node = mesh->node[c/FREE];
			double kept[6];

			memcpy(kept, run->motion.velocity[c/FREE], sizeof kept);
			for (int side = 0; side < 2; side++) {
				change(run, c/FREE, c%FREE, velocity, side ? STEP : -STEP);
				forces(f[side], run, 0);
				mesh->node[c/FREE] = node;
				memcpy(run->motion.velocity[c/FREE], kept, sizeof kept);
			}
			run->motion.by_place = !velocity;
			run->motion.to_velocity = velocity;
			forces(none, run, 1);
			for (int r = 0; r < mesh->n; r++) {
				double by = (f[1][r] - f[0][r])/(2.0*STEP);
				double own = abs(r - c) > HAWSER__BAND_SIDE
				             ? 0.0 : -*hawser__band_at(&mesh->band, r, c);

				worst = fmax(worst, fabs(by - own));
				most = fmax(most, fabs(own));
			}
		}
	ok(worst < 2e-8*most, "%s: derivatives are those of the loads: %.1e of %.1e", what, worst, most);
}

/* Some state that is not symmetric, near the one at rest. */
static void disturb(struct hawser__tow_run *run)
{
	struct hawser__rod_mesh *mesh = run->motion.mesh;

	for (int i = 0; i < mesh->nodes; i++) {
		double turn[3] = {0.11*i - 0.2, 0.07*i, 0.13 - 0.05*i};

		for (int k = 0; k < 3; k++)
			mesh->node[i].x[k] += 0.013*sin(2.385*i + k);
		hawser__quaternion_turn(mesh->node[i].q, turn);
		for (int k = 0; k < FREE; k++)
			run->motion.velocity[i][k] += 1.7*cos(1.1*i + 0.9*k);
	}
	for (int e = 0; e < mesh->elements; e++) {
		run->phase[e] = 0.7*e + 0.4;
		run->swing[e] = 30.0;
	}
	for (int i = 0; i < mesh->nodes; i++)
		for (int k = 0; k < 9; k++)
			run->motion.Ji[i][k] = k%4 == 0;
}

static void loads(struct hawser_tow *tow, const char *what)
{
	struct hawser__tow_run run;
	struct hawser_report report = {0};

	if (ok(!hawser__tow_run_open(&run, tow, 1, 1.0, &report), "%s: %s", what, report.message)) {
		hawser__rod_motion_factors(&run.motion, 0.3, 0);
		disturb(&run);
		compare(&run, what);
	}
	hawser__tow_run_close(&run);
}

CASE(property_tow_loads)
{
	static struct hawser_waypoint gust[3] = {{.t = 0.0, .at = {{1.0, 0.0, 2.0}}},
	                                         {.t = 2.0, .at = {{3.0, 4.0, 2.0}}},
	                                         {.t = 5.0, .at = {{3.0, 1.0, -4.0}}}};
	struct hawser_tow_segment cable = {.length = 3.0, .rho = 0.2, .EA = 2e3, .EI = 0.7,
	                                   .diameter = 0.02,
	                                   .normal = 1.3, .tangential = 0.03, .elements = 4, .lift = 0.6,
	                                   .strouhal = 0.22};
	struct hawser_tow tow = {
		.g = 9.81, .density = 1.2, .segment = &cable, .segments = 1, .wind = {2.0, 0.0, 3.0},
		.body = {.kind = HAWSER_TOW_RING, .mass = 9.0, .offset = 0.8, .joint = HAWSER_TOW_SPRING,
		         .torsion = 30.0,
		         .ring = {.radius = 0.4, .segments = 2048, .drag = {1.2, 0.03, 1.2, 0.02}}}};
	struct hawser_report report;
	double origin[3] = {0.0}, velocity[3] = {7.0, 0.0, 1.0}, wind[3];

	if (!ok(!hawser_path_straight(&tow.path, origin, velocity, 0.0, HAWSER_PATH_RAMP_SMOOTH, &report),
	        "path"))
		return done_testing();
	loads(&tow, "a ring on a spring");
	tow.body.joint = HAWSER_TOW_JOINT;
	loads(&tow, "a ring on a joint");
	tow.body.joint = HAWSER_TOW_CLAMPED;
	tow.gust = gust;
	tow.gusts = 3;
	loads(&tow, "a clamped ring, wind in time");
	tow.body = (struct hawser_tow_body){.kind = HAWSER_TOW_MASS, .mass = 9.0, .CdA = 0.2};
	loads(&tow, "a mass");
	tow.winch = (struct hawser_rod_winch){.on = 1, .speed = 2.0, .rise = 0.4};
	loads(&tow, "a mass on a cable that is paid out");
	hawser__tow_wind(wind, &tow, 1.0);
	ok(wind[0] == 2.0 && wind[1] == 2.0 && wind[2] == 2.0, "wind between two times");
	hawser__tow_wind(wind, &tow, 4.0);
	ok(wind[0] == 3.0 && fabs(wind[1] - 2.0) < 1e-15 && fabs(wind[2] + 2.0) < 1e-15, "the next two");
	hawser__tow_wind(wind, &tow, 9.0);
	ok(wind[2] == -4.0, "after the last time it stays");
	return done_testing();
}
