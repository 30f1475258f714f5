/* Motion of nets at its limits: nodes without mass, loads that are no numbers, steps that are far
 * too long, slack members at first, a support that stretches a cable by a half, runs that are
 * interrupted, 10^5 steps without damping; and motion in a plane, which the model leaves out of its
 * unknowns. SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <unistd.h>

#include <hawser/net_motion.h>

#include "tests/tap.h"

static struct hawser_report report;

struct scene {
	struct hawser_net net;
	struct hawser_net_node node[3];
	struct hawser_net_cable cable[2];
	struct hawser_net_load load, motion;
	int release;
};

/* Two cables from A over J to B, in the plane z = 0.7, with a load on J. */
static void begin(struct scene *s)
{
	static char name[] = "scene";

	memset(s, 0, sizeof *s);
	s->node[0] = (struct hawser_net_node){.name = "A", .placed = 1, .x = {0.3, 0.0, 0.7},
	                                      .held = {1, 1, 1}, .support = 1};
	s->node[1] = (struct hawser_net_node){.name = "J", .mass = 0.4};
	s->node[2] = (struct hawser_net_node){.name = "B", .placed = 1, .x = {4.2, 0.5, 0.7},
	                                      .held = {1, 1, 1}, .support = 1};
	s->cable[0] = (struct hawser_net_cable){.name = "a", .from = 0, .to = 1, .EA = 2385.0, .rho = 0.37,
	                                        .value = 2.3, .elements = 6};
	s->cable[1] = (struct hawser_net_cable){.name = "b", .from = 1, .to = 2, .EA = 1700.0, .rho = 0.21,
	                                        .value = 2.1, .elements = 5};
	s->load = (struct hawser_net_load){.node = 1, .cable = -1, .value = {0.5, 0.9, 0.0}, .harmonic = 1,
	                                   .Omega = 5.3};
	s->motion = (struct hawser_net_load){.node = 2, .cable = -1, .harmonic = 1, .Omega = 3.1,
	                                     .phase = 0.5*M_PI};
	s->net = (struct hawser_net){.name = name, .g = 9.81, .node = s->node, .cable = s->cable,
	                             .load = &s->load, .motion = &s->motion, .nodes = 3, .cables = 2,
	                             .loads = 1,
	                             .dynamics = {.release = &s->release}};
}

static enum hawser_status run(struct hawser_net_motion *motion, struct scene *s, const char *scheme,
                              double until, double step)
{
	static const struct hawser_net_probe probe[] = {{.node = 1, .cable = -1}};
	struct hawser_net_motion_options options = {.until = until, .every = until/10.0, .step = step,
	                                            .scheme = scheme, .probe = probe, .probes = 1};

	memset(&report, 0, sizeof report);
	return hawser_net_integrate(motion, &s->net, &options, &report);
}

static int all_finite(const struct hawser_net_motion *motion)
{
	for (int i = 0; i < motion->rows; i++)
		if (!isfinite(motion->x[i][0] + motion->x[i][1] + motion->x[i][2] + motion->kinetic[i]))
			return 0;
	return motion->rows == 11;
}

static double distance(const struct hawser_net_motion *a, const struct hawser_net_motion *b)
{
	double most = 0.0;

	for (int i = 0; i < a->rows && i < b->rows; i++)
		for (int k = 0; k < 3; k++)
			most = fmax(most, fabs(a->x[i][k] - b->x[i][k]));
	return most;
}

/* A load of 1e-200 N across the plane has the unknowns built, and moves nothing. */
static void plane(void)
{
	struct scene s;
	struct hawser_net_motion flat, space;

	for (int axis = 0; axis < 3; axis += 2) {
		begin(&s);
		if (axis == 0) { /* the plane x = 0.7 */
			for (int i = 0; i < 3; i++) {
				double x = s.node[i].x[0];

				s.node[i].x[0] = s.node[i].x[2];
				s.node[i].x[2] = x;
			}
			s.load.value[2] = s.load.value[0];
			s.load.value[0] = 0.0;
		}
		if (!ok(!run(&flat, &s, "energy", 2.0, 2e-3), "in a plane %s", report.message))
			return;
		s.load.value[axis] = 1e-200;
		if (!ok(!run(&space, &s, "energy", 2.0, 2e-3), "in space %s", report.message))
			return;
		ok(flat.still[axis] && !flat.still[2 - axis] && !flat.still[1] && !space.still[axis],
		   "nothing moves along %c", "xyz"[axis]);
		ok(3*flat.unknowns == 2*space.unknowns && flat.unknowns == 20, "%d unknowns instead of %d",
		   flat.unknowns, space.unknowns);
		ok(distance(&flat, &space) <= 1e-11, "the same motion to %.1e m", distance(&flat, &space));
		hawser_net_motion_clear(&flat);
		hawser_net_motion_clear(&space);
	}
}

static void no_mass(void)
{
	struct hawser_net_motion motion;
	struct scene s;
	enum hawser_status status;

	begin(&s);
	s.node[1].mass = 0.0;
	for (int c = 0; c < 2; c++) {
		s.cable[c].rho = 0.0;
		s.cable[c].elements = 1;
	}
	s.release = 2;
	s.net.dynamics.releases = 1;
	status = run(&motion, &s, "energy", 1.0, 1e-2);
	ok(status == HAWSER_ERR_ARGUMENT && strstr(report.message, "node J has none"),
	   "no mass: status %d: %s", status, report.message);
	if (!status)
		hawser_net_motion_clear(&motion);
	/* a released end of a cable with mass is no such node */
	begin(&s);
	s.release = 2;
	s.net.dynamics.releases = 1;
	status = run(&motion, &s, "energy", 1.0, 1e-3);
	ok(!status && all_finite(&motion) && motion.closure <= 1e-10,
	   "released: ledger to %.1e, %ld changes of slack and taut %s", motion.closure, motion.switches,
	   report.message);
	hawser_net_motion_clear(&motion);
}

static void no_number(void)
{
	struct hawser_net_motion motion;
	struct scene s;
	enum hawser_status status;

	for (int i = 0; i < 3; i++) {
		begin(&s);
		if (i == 0)
			s.load.value[1] = NAN;
		if (i == 1)
			s.load.Omega = INFINITY;
		if (i == 2) {
			s.motion.value[1] = NAN;
			s.net.motions = 1;
		}
		status = run(&motion, &s, NULL, 1.0, i == 0 ? 1e-2 : -1.0);
		ok(status == HAWSER_ERR_NAN, "not a number, case %d: "
		   "status %d: %s",
		   i, status, report.message);
		if (!status)
			hawser_net_motion_clear(&motion);
	}
}

/* Steps of two periods of the load: what is computed is coarse, but bounded, and its error is
 * stated. */
static void long_steps(void)
{
	for (int i = 0; hawser_net_scheme(i); i++) {
		struct hawser_net_motion motion;
		struct scene s;
		enum hawser_status status;

		begin(&s);
		s.net.alpha = 0.01;
		status = run(&motion, &s, hawser_net_scheme(i)->name, 25.0, 2.5);
		ok((!status && all_finite(&motion)) || (status == HAWSER_ERR_CONVERGENCE && *report.message),
		   "%s with steps of 2.5 s: status %d %s", hawser_net_scheme(i)->name, status, report.message);
		if (status)
			continue;
		printf("# %ld steps, %ld splits, stated error %.1e m, closure %.1e\n", motion.steps,
		       motion.splits,
		       motion.error, motion.closure);
		hawser_net_motion_clear(&motion);
	}
}

/* A heavy J hangs from A above it; the cable from J down to B is slack, and B falls away. */
static void slack(void)
{
	struct hawser_net_motion energy, cvode;
	struct scene s;

	begin(&s);
	s.node[2].x[0] = 0.3;
	s.node[2].x[1] = -4.0;
	s.node[1].mass = 9.0;
	s.motion.value[1] = -0.8;
	s.net.motions = 1;
	s.net.axial = 2e-3;
	if (!ok(!run(&energy, &s, "energy", 2.0, -1.0) && all_finite(&energy), "slack at first %s",
	        report.message))
		return;
	ok(energy.slack[0] >= 1 && energy.switches > 0 && energy.closure <= 1e-10,
	   "%d slack elements, %ld changes, ledger to %.1e", energy.slack[0], energy.switches,
	   energy.closure);
	if (ok(!run(&cvode, &s, "cvode", 2.0, -1.0) && all_finite(&cvode), "by CVODE %s", report.message))
		ok(distance(&energy, &cvode) <= 5.0*(energy.error + cvode.error), "%.1e m apart, stated "
		   "%.1e and %.1e",
		   distance(&energy, &cvode), energy.error, cvode.error);
	hawser_net_motion_clear(&energy);
	hawser_net_motion_clear(&cvode);
}

/* B moves 2.1 m away, half of the length of both cables. */
static void stretched(void)
{
	struct hawser_net_motion motion, cvode;
	struct scene s;

	begin(&s);
	s.motion.value[0] = -2.1;
	s.net.motions = 1;
	s.net.axial = 1e-3;
	if (!ok(!run(&motion, &s, "energy", 1.5, -1.0) && all_finite(&motion), "stretched by a half %s",
	        report.message))
		return;
	ok(motion.closure <= 1e-10 && motion.T[5] > 500.0, "ledger to %.1e, T = %.4g N", motion.closure,
	   motion.T[5]);
	if (ok(!run(&cvode, &s, "cvode", 1.5, -1.0), "by CVODE %s", report.message))
		ok(distance(&motion, &cvode) <= 5.0*(motion.error + cvode.error), "%.1e m apart, stated "
		   "%.1e and %.1e",
		   distance(&motion, &cvode), motion.error, cvode.error);
	hawser_net_motion_clear(&motion);
	hawser_net_motion_clear(&cvode);
}

static int after_some(void *data, const struct hawser_progress_state *state)
{
	(void)state;
	return ++*(int *)data > 4;
}

/* Interrupted after some rows; the state that is left goes on to the same end, bit by bit. */
static void interrupted(void)
{
	static const char file[] = "test-net-motion-extremes.state";
	struct hawser_net_motion whole, part, rest;
	struct hawser_net_motion_options options = {.until = 1.0, .every = 0.1, .step = -1.0};
	struct scene s;
	int asked = 0;
	enum hawser_status status;

	begin(&s);
	if (!ok(!hawser_net_integrate(&whole, &s.net, &options, &report), "whole %s", report.message))
		return;
	options.progress.function = after_some;
	options.progress.data = &asked;
	status = hawser_net_integrate(&part, &s.net, &options, &report);
	ok(!status && part.interrupted && part.rows < 11 &&
	   part.reached < 1.0, "interrupted at %g s after %d rows", part.reached, part.rows);
	ok(!hawser_net_state_write(&part, file, &report), "its state %s", report.message);
	options.progress.function = NULL;
	options.initial = file;
	ok(!hawser_net_integrate(&rest, &s.net, &options, &report), "goes on %s", report.message);
	ok(rest.states == whole.states &&
	   memcmp(rest.state, whole.state, (size_t)rest.states*sizeof *rest.state) == 0, "to the same "
	   "state");
	options.until = 0.2;
	hawser_net_motion_clear(&part);
	ok(hawser_net_integrate(&part, &s.net, &options, &report) == HAWSER_ERR_ARGUMENT,
	   "an end before the state: %s", report.message);
	(void)unlink(file);
	hawser_net_motion_clear(&whole);
	hawser_net_motion_clear(&rest);
}

/* The motion of a support by a table of times, against the harmonics that it was made of. */
static void table(void)
{
	static char file[] = "test-net-motion-extremes.table";
	struct hawser_net_motion motion, harmonic;
	struct scene s;
	FILE *stream = fopen(file, "w");

	if (!ok(stream != NULL, "a table"))
		return;
	for (int i = -4; i <= 404; i++)
		fprintf(stream, "%.17g 0 %.17g 0\n", 0.005*i, -0.2*sin(3.1*0.005*i));
	fclose(stream);
	begin(&s);
	s.motion.value[1] = 0.2;
	s.net.motions = 1;
	ok(!run(&harmonic, &s, "energy", 2.0, 2e-3), "harmonic motion %s", report.message);
	s.net.motions = 0;
	s.node[2].table = file;
	ok(!run(&motion, &s, "energy", 2.0, 2e-3), "by a table %s", report.message);
	ok(distance(&motion, &harmonic) <= 1e-6 && motion.still[2], "the same motion to %.1e m",
	   distance(&motion, &harmonic));
	ok(fabs(motion.work[10] - harmonic.work[10]) <= 1e-5*fabs(harmonic.work[10]) &&
	   motion.closure <= 1e-11, "and work, %.6g and %.6g J; ledger to %.1e", motion.work[10],
	   harmonic.work[10], motion.closure);
	hawser_net_motion_clear(&motion);
	hawser_net_motion_clear(&harmonic);
	(void)unlink(file);
}

/* Free motion from a support that is let go, without damping. */
static void endless(void)
{
	struct hawser_net_motion motion;
	struct scene s;
	int steps = getenv("HAWSER_LONG") ? 100000 : 20000;
	enum hawser_status status;

	begin(&s);
	s.release = 2;
	s.net.dynamics.releases = 1;
	s.net.loads = 0;
	status = run(&motion, &s, "energy", 1e-3*steps, 1e-3);
	ok(!status && motion.closure <= 1e-10 && motion.switches > steps/100,
	   "%ld steps without damping, %ld changes: energy to %.1e %s", motion.steps, motion.switches,
	   motion.closure, report.message);
	hawser_net_motion_clear(&motion);
}

CASE(extremes_net_motion_extremes)
{
	plane();
	no_mass();
	no_number();
	long_steps();
	slack();
	stretched();
	interrupted();
	table();
	endless();
	return done_testing();
}
