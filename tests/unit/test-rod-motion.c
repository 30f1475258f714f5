/* Time steps of rods: the tangent against differences, with bodies, loads by a function and moving
 * ends; a rigid body that turns freely; order in step and mesh; the rotor over many turns.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "rod/motion.h"
#include "rod/run.h"
#include "rod/so3.h"
#include "tests/tap.h"

#define PI 3.14159265358979323846

static unsigned long seed = 2385;

static double number(void) /* -1 to 1 */
{
	seed = (seed*1103515245UL + 12345UL) & 0x7fffffffUL;
	return 2.0*(double)seed/0x7fffffff - 1.0;
}

static struct hawser_rod_segment segment = {
	.length = 2.385, .rho = 1.3, .EA = 900.0, .GA = {700.0, 500.0}, .EI = {31.0, 17.0}, .GJ = 23.0,
	.curvature = {0.1, -0.2, 0.3}, .inertia = {0.07, 0.05, 0.02}, .elements = 4};

static struct hawser_rod rod_of(struct hawser_rod_segment *of, struct hawser_rod_load *load, int loads)
{
	return (struct hawser_rod){
		.segment = of, .segments = 1, .length = of->length, .load = load, .loads = loads,
		.hold = {HAWSER_ROD_CLAMPED, HAWSER_ROD_FREE}, .tangent = {1.0, 0.0, 0.0},
		.normal = {0.0, 1.0, 0.0}, .g = 9.81, .rho_inf = 0.8};
}

/* A load that depends on all: f = A x + B q1 + C v on a node and its neighbour, and its derivatives. */
static double A[36], C[36];

static int drag(void *data, struct hawser__rod_motion *motion, double t, int tangent)
{
	(void)data;
	(void)t;
	for (int i = 1; i < motion->mesh->nodes; i++) {
		double f[6], R[9], turns[36] = {0.0}, at[36], skew[9], m[3], fixed[3] = {1.2, -0.4, 0.7};

		hawser__quaternion_matrix(R, motion->mesh->node[i].q);
		hawser__apply_left(m, R, fixed); /* a moment of fixed direction */
		for (int r = 0; r < 6; r++) {
			f[r] = r < 3 ? 0.0 : m[r - 3];
			for (int c = 0; c < 6; c++)
				f[r] += C[6*r + c]*motion->velocity[i][c] +
				        (c < 3 ? A[6*r + c]*motion->mesh->node[i - 1].x[c] : 0.0);
		}
		hawser__rod_push(motion, i, f);
		hawser__skew(skew, m);
		for (int r = 0; r < 3; r++)
			for (int c = 0; c < 3; c++)
				turns[6*(3 + r) + 3 + c] = skew[3*r + c];
		for (int k = 0; k < 36; k++)
			at[k] = k % 6 < 3 ? A[k] : 0.0;
		if (tangent) {
			hawser__rod_push_tangent(motion, i, i, turns, C);
			hawser__rod_push_tangent(motion, i, i - 1, at, NULL);
		}
	}
	return 0;
}

/* Velocities and rates are functions of the turn of the step, Ji times that of the state. */
static void move(struct hawser__rod_motion *motion, const double *by, double part)
{
	hawser__rod_move(motion->mesh, by, part);
	for (int i = 0; i < motion->mesh->nodes; i++) {
		double d[6];

		memcpy(d, by + (long)6*i, sizeof d);
		hawser__apply(d + 3, motion->Ji[i], by + (long)6*i + 3);
		for (int k = 0; k < 6; k++) {
			motion->velocity[i][k] += part*motion->to_velocity*d[k];
			motion->rate[i][k] += part*motion->to_rate*d[k];
		}
	}
}

static void tangent(void)
{
	struct hawser_rod_load load = {.from = 2.385, .to = 2.385, .force = {1.0, -2.0, 3.0},
	                               .moment = {0.3, 0.2, 0.7}, .follower = 1};
	struct hawser_rod rod = rod_of(&segment, &load, 1);
	struct hawser__rod_mesh mesh;
	struct hawser__rod_motion motion;
	struct hawser__rod_body body = {.node = 4, .mass = 2.7, .offset = {0.4, -0.2, 0.3},
	                                .inertia = {0.5, 0.1, 0.0, 0.1, 0.7, 0.2, 0.0, 0.2, 0.9}};
	struct hawser_report report;
	double by[30], plus[30], minus[30], product[30] = {0.0}, worst = 0.0, size = 0.0;
	const double eps = 1e-6;

	ok(hawser__rod_mesh_open(&mesh, &rod, 1, &report) == HAWSER_OK &&
	   hawser__rod_motion_open(&motion, &mesh, &report) == HAWSER_OK, "a mesh that moves");
	motion.body = &body;
	motion.bodies = 1;
	motion.alpha = 0.31;
	motion.loading = drag;
	for (int k = 0; k < 36; k++) {
		A[k] = number();
		C[k] = number();
	}
	for (int i = 0; i < mesh.n; i++)
		by[i] = mesh.held[i] ? 0.0 : number();
	hawser__rod_move(&mesh, by, 0.2);
	for (int i = 0; i < mesh.n; i++)
		motion.velocity[i/6][i % 6] = mesh.held[i] ? 0.0 : number();
	for (int i = 0; i < mesh.n; i++)
		motion.rate[i/6][i % 6] = mesh.held[i] ? 0.0 : 5.0*number();
	for (int i = 0; i < mesh.nodes; i++) {
		struct hawser__so3 at;
		double turn[3] = {0.3*number(), 0.5*number(), 0.4*number()};

		hawser__so3_at(&at, turn);
		hawser__so3_ji(motion.Ji[i], &at);
	}
	motion.by_place = 1.0;
	motion.to_velocity = 3.0;
	motion.to_rate = 11.0;
	hawser__rod_motion_factors(&motion, 0.0, 0);
	for (int i = 0; i < mesh.n; i++)
		by[i] = mesh.held[i] ? 0.0 : number();
	(void)hawser__rod_motion_form(&motion, 0.0, 1);
	for (int i = 0; i < mesh.n; i++)
		for (int j = i > 11 ? i - 11 : 0; j <= i + 11 && j < mesh.n; j++)
			product[i] += mesh.held[i] ? 0.0 : *hawser__band_at(&mesh.band, i, j)*by[j];
	move(&motion, by, eps);
	(void)hawser__rod_motion_form(&motion, 0.0, 0);
	memcpy(plus, mesh.r, sizeof plus);
	move(&motion, by, -2.0*eps);
	(void)hawser__rod_motion_form(&motion, 0.0, 0);
	memcpy(minus, mesh.r, sizeof minus);
	for (int i = 0; i < mesh.n; i++) {
		worst = fmax(worst, fabs(product[i] + (plus[i] - minus[i])/(2.0*eps)));
		size = fmax(size, fabs(product[i]));
	}
	ok(worst < 1e-8*size, "tangent with a body, drag and loads against differences: %.1e", worst/size);
	hawser__rod_motion_clear(&motion);
	hawser__rod_mesh_clear(&mesh);
}

/* --- motions by the library --- */

static struct hawser_rod_motion run(const struct hawser_rod *rod, double until, double step,
                                    int elements, double probe)
{
	struct hawser_rod_motion_options options = {.until = until, .every = 0.1*until, .step = step,
	                                            .probe = &probe, .probes = 1, .skip_error = 1};
	struct hawser_rod_motion motion;
	struct hawser_report report;

	rod->segment[0].elements = elements;
	if (hawser_rod_integrate(&motion, rod, &options, &report))
		ok(0, "%s", report.message);
	return motion;
}

/* Three steps, each half the last, have differences in the ratio 4; three meshes too. */
static void order(void)
{
	double table[3][2] = {{0.0, 0.0}, {0.2, 1.0}, {0.4, 0.0}};
	struct hawser_rod_load load = {.from = 2.385, .to = 2.385, .force = {0.0, 20.0, 9.0},
	                               .moment = {2.0, 0.0, 0.0}, .factor = table, .factors = 3};
	struct hawser_rod rod = rod_of(&segment, &load, 1);
	struct hawser_rod_motion of[3];
	double first, second;

	for (int mesh = 0; mesh < 2; mesh++) {
		for (int i = 0; i < 3; i++)
			of[i] = run(&rod, 1.0, mesh ? 0.01 : 0.002/(1 << i), mesh ? 8 << i : 8, rod.length);
		first = second = 0.0;
		for (int k = 0; k < 3; k++) {
			first += pow(of[0].x[10][k] - of[1].x[10][k], 2.0);
			second += pow(of[1].x[10][k] - of[2].x[10][k], 2.0);
		}
		first = 0.5*log2(first/second);
		ok(first > 1.85 && first < 2.15, "order of the %s: %.3f", mesh ? "mesh" : "step", first);
		for (int i = 0; i < 3; i++)
			hawser_rod_motion_clear(&of[i]);
	}
}

/* The rotor over more turns than 22.5 pi: its length, energy and turns. */
static void turns(void)
{
	struct hawser_rod_segment blade = {
		.length = 10.0, .rho = 1.2, .EA = 2.8e7, .GA = {1e7, 1e7}, .EI = {1.4e4, 1.4e4}, .GJ = 1.4e4,
		.inertia = {12e-4, 6e-4, 6e-4}, .elements = 4};
	struct hawser_rod rod = rod_of(&blade, NULL, 0);
	struct hawser_rod_motion motion;
	double worst = 0.0, turned;

	/* at full speed at once: the rod is stretched, and vibrates along itself */
	rod.g = 0.0;
	rod.drive[0] = (struct hawser_rod_drive){.axis = {0.0, 0.0, 1.0}, .speed = PI};
	motion = run(&rod, getenv("HAWSER_LONG") ? 100.0 : 22.5, 0.01, 4, rod.length);
	for (int i = 0; i < motion.rows; i++)
		worst = fmax(worst, fabs(hypot(motion.x[i][0], motion.x[i][1])/10.0 - 1.0));
	turned = motion.turned[motion.rows - 1];
	close_to(turned, 0.5*motion.reached, 2e-4, "22.5 pi of the rotor and more, in revolutions");
	ok(worst > 5e-6 && worst < 3e-5, "its length grows by at most %.1e: forces at rest 1.4e-5", worst);
	ok(motion.splits == 0 && fabs(motion.kinetic[motion.rows - 1]/2035.64 - 1.0) < 5e-4,
	   "no step fails; kinetic energy %.2f J, 2035.64 J of the rigid chain",
	   motion.kinetic[motion.rows - 1]);
	hawser_rod_motion_clear(&motion);
}

/* A body in the last node of a rod without weight, released from the side: a pendulum of two lengths
 * whose energy is constant; the ledgers close at order 2. */
static void body(void)
{
	struct hawser_rod_segment cable = {
		.length = 2.0, .rho = 0.1, .EA = 2e4, .GA = {1e4, 1e4}, .EI = {0.5, 0.5}, .GJ = 0.5,
		.inertia = {2e-4, 1e-4, 1e-4}, .elements = 6};
	struct hawser_rod rod = rod_of(&cable, NULL, 0);
	struct hawser__rod_body mass = {.node = 6, .mass = 3.0, .offset = {0.5, 0.1, 0.0},
	                                .inertia = {0.2, 0, 0, 0, 0.3, 0, 0, 0, 0.25}};
	double lost[2], gap[2];
	struct hawser_report report;

	rod.hold[0] = HAWSER_ROD_HINGED;
	rod.rho_inf = 1.0;
	for (int k = 0; k < 2; k++) {
		struct hawser__rod_mesh mesh;
		struct hawser__rod_motion motion;
		int steps = 100 << k;
		enum hawser_status status = hawser__rod_mesh_open(&mesh, &rod, 1, &report);

		if (!status)
			status = hawser__rod_motion_open(&motion, &mesh, &report);
		motion.body = &mass;
		motion.bodies = 1;
		if (!status)
			status = hawser__rod_motion_begin(&motion, 1, &report);
		for (int i = 0; i < steps && !status; i++)
			status = hawser__rod_motion_step(&motion, 0.6/steps, &report);
		lost[k] = fabs(motion.energy_lost)/motion.most_energy;
		gap[k] = motion.angular_gap/motion.most_angular;
		if (status)
			ok(0, "%s", report.message);
		hawser__rod_motion_clear(&motion);
		hawser__rod_mesh_clear(&mesh);
	}
	ok(lost[1] < 1e-3 && lost[0] > 2.5*lost[1], "a body in a node: energy to %.1e, %.1e", lost[0],
	   lost[1]);
	ok(gap[1] < 1e-3 && gap[0] > 2.5*gap[1], "angular momentum to %.1e, %.1e", gap[0], gap[1]);
}

CASE(unit_rod_motion)
{
	tangent();
	order();
	turns();
	body();
	return done_testing();
}
