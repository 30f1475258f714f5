/* The error that a motion of a net states, and the control of steps by it: random nets against much
 * finer steps; CVODE as a judge of both.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include <hawser/net_motion.h>

#include "tests/net-random.h"
#include "tests/tap.h"

enum { ROWS = 20, JOINTS = 3 };
static struct hawser_report report;

/* Two or three supports, one to three joints between them, a harmonic load on one of the joints and a
 * support that moves. Slow waves take one to three seconds; axial waves are damped. */
static void draw(struct random_net *r, struct hawser_net_load *motion, uint64_t *state)
{
	int supports = 2 + (uniform(state) < 0.5), joints = 1 + (int)(JOINTS*uniform(state));
	double omega;

	memset(r, 0, sizeof *r);
	r->net = (struct hawser_net){.name = r->node[0].name, .g = 9.81, .node = r->node, .cable = r->cable,
	                             .load = r->load, .motion = motion, .nodes = supports + joints,
	                             .motions = 1};
	r->size = pow(10.0, 2.0*uniform(state));
	random_joints(r, state, supports);
	for (int i = supports; i < r->net.nodes; i++) {
		random_cable(r, state, i - supports, i, supports, HEAVY);
		random_cable(r, state, i, i + 1 < r->net.nodes ? i + 1 : 0, supports, HEAVY);
		r->node[i].mass *= 0.1;
	}
	for (int i = 0; i < r->net.cables; i++) {
		struct hawser_net_cable *cable = &r->cable[i];

		cable->EA = cable->rho*9.81*r->size*pow(10.0, 1.5 + 1.5*uniform(state));
		cable->elements = 4;
		r->weight += 9.81*cable->rho*cable->value;
	}
	omega = sqrt(9.81/r->size)*(0.5 + 2.0*uniform(state));
	*motion = (struct hawser_net_load){.node = 1, .cable = -1, .harmonic = 1, .Omega = 1.3*omega,
	                                   .phase = 1.5707963267948966};
	r->load[0] = (struct hawser_net_load){.node = supports, .cable = -1, .harmonic = 1, .Omega = omega};
	for (int k = 0; k < 3; k++) {
		motion->value[k] = 0.02*r->size*(2.0*uniform(state) - 1.0);
		r->load[0].value[k] = 0.1*r->weight*(2.0*uniform(state) - 1.0);
	}
	r->net.loads = 1;
	r->net.alpha = 0.05;
	r->net.axial = 0.01*sqrt(r->size/9.81);
}

static int run(struct hawser_net_motion *motion, const struct random_net *r, const char *scheme,
               double tolerance, int check)
{
	struct hawser_net_probe probe[JOINTS];
	struct hawser_net_motion_options options = {.step = -1.0, .tolerance = tolerance,
	                                            .scheme = scheme, .probe = probe, .check = check};

	for (int i = 0; i < r->net.nodes; i++)
		if (!r->node[i].support)
			probe[options.probes++] = (struct hawser_net_probe){.node = i, .cable = -1};
	options.until = 2.0*2.0*M_PI/r->load[0].Omega;
	options.every = options.until/ROWS;
	return ok(!hawser_net_integrate(motion, &r->net, &options, &report), "%s %g: %s", scheme, tolerance,
	          report.message);
}

/* Largest distance of the probes of two motions. */
static double distance(const struct hawser_net_motion *a, const struct hawser_net_motion *b)
{
	double most = 0.0;

	for (int i = 0; i < a->rows*a->probes; i++)
		for (int k = 0; k < 3; k++)
			most = fmax(most, fabs(a->x[i][k] - b->x[i][k]));
	return most;
}

/* Steps chosen by the error, against CVODE at 1e-9. The sum of the local errors is no bound where
 * cables get slack often: errors grow there. */
static void compare(const struct random_net *r, int number)
{
	struct hawser_net_motion coarse = {0}, fine = {0}, judge = {0};
	double off, apart;

	if (run(&coarse, r, "energy", 1e-6, 0) && run(&fine, r, "energy", 1e-8, 1) &&
	    run(&judge, r, "cvode", 1e-9, 0)) {
		off = distance(&coarse, &judge);
		apart = distance(&fine, &judge);
		printf("# net %d: %d cables, %.3g m, %ld changes of slack and taut; %ld, %ld and %ld steps\n",
		       number, r->net.cables, r->size, fine.switches, coarse.steps, fine.steps, judge.steps);
		ok(off <= coarse.error*(coarse.switches > 60 ? 50.0 : 1.2) && !coarse.checked,
		   "rtol 1e-6: %.2e m off, %.2f of the sum of local errors", off, off/coarse.error);
		ok(apart <= 3.0*fine.error && fine.error <= 5.0*apart && fine.checked,
		   "rtol 1e-8: %.2e m off, %.2f of what another run says", apart, apart/fine.error);
		ok(judge.error <= 0.1*fine.error, "CVODE states %.2e m", judge.error);
	}
	hawser_net_motion_clear(&coarse);
	hawser_net_motion_clear(&fine);
	hawser_net_motion_clear(&judge);
}

CASE(property_net_error)
{
	uint64_t state = 2385;

	for (int i = 0; i < (getenv("HAWSER_LONG") ? 100 : 5); i++) {
		struct random_net r;
		struct hawser_net_load move;

		draw(&r, &move, &state);
		compare(&r, i);
	}
	return done_testing();
}
