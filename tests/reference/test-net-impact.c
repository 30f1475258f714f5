/* Nets that touch obstacles in time, against closed forms: a mass that bounces; one that a moving floor
 * takes along; a cable that is dragged over a floor, and one that falls on it. In all of them no step
 * adds energy, and the ledger closes.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include <hawser/net_motion.h>

#include "tests/tap.h"

static int moved(struct hawser_net *net, struct hawser_net_motion *motion,
                 const struct hawser_net_motion_options *options, const char *scene,
                 const char *const *set, size_t sets)
{
	struct hawser_report report;
	const char *path = source_file("notebooks-data/scenes/%s.yaml", scene);
	enum hawser_status status;

	status = hawser_net_open(net, path, set, sets, &report);
	if (!status)
		status = hawser_net_integrate(motion, net, options, &report);
	return ok(!status, "%s: %s", scene, status ? report.message : "moves");
}

/* Energy without the work from outside never grows; and all is in the ledger. */
static void kept(const struct hawser_net_motion *motion)
{
	double grows = 0.0, size = 0.0, apart = 0.0;

	for (int i = 1; i < motion->rows; i++) {
		double lost = motion->dissipated[i] - motion->dissipated[i - 1];
		double own = motion->friction[i] + motion->impacts[i] - motion->friction[i - 1] -
		             motion->impacts[i - 1];

		size = fmax(size, fabs(motion->dissipated[i]) + motion->kinetic[i]);
		grows = fmax(grows, fmax(-lost, -own));
		apart = fmax(apart, motion->apart[i]);
	}
	ok(motion->closure <= 1e-11, "the ledger closes to %.1e", motion->closure);
	ok(grows <= 1e-12*size, "contacts and damping only take energy: at most %.1e of %.3g J", grows,
	   size);
	ok(apart <= 1e-12 && motion->laws <= 1e-11, "gaps to %.1e m, laws to %.1e", apart, motion->laws);
}

/* A fall of 1 m. After bounce n the energy is e^(2n) of that of the fall, to round-off: that of an
 * impact does not depend on the step. The time of impact n is (1 + 2*(e + .. + e^(n-1)))*sqrt(2/g). */
static void bounces(double e)
{
	const struct hawser_net_probe at = {.node = 1, .cable = -1};
	const struct hawser_net_motion_options options = {.until = 2.0, .every = 1e-3, .probe = &at,
	                                                  .probes = 1};
	char text[64];
	const char *const set[] = {text};
	struct hawser_net net;
	struct hawser_net_motion motion;
	const double fall = sqrt(2.0/9.81), all = 2.0*9.81;
	double when = fall, energy = all, worst = 0.0, late = 0.0;
	int count = 0;

	snprintf(text, sizeof text, "contact.restitution=%.17g", e);
	if (moved(&net, &motion, &options, "net-impact", set, 1)) {
		kept(&motion);
		for (int i = 1; i < motion.rows && count < 4; i++) {
			if (motion.impacts[i] - motion.impacts[i - 1] <= 1e-9 && motion.touching[i] == 0)
				continue;
			energy *= e*e;
			worst = fmax(worst, fabs(motion.impacts[i] - (all - energy))/all);
			late = fmax(late, fabs(motion.time[i] - when));
			when += 2.0*fall*pow(e, ++count);
		}
		ok(count == 4 || (e == 1.0 && count == 2), "%d bounces with e = %g", count, e);
		close_to(worst, 0.0, 1e-13, "energies after impacts");
		ok(late <= 3e-3*(count + 1), "times of impacts, at most %.2g s late", late);
	}
	hawser_net_motion_clear(&motion);
	hawser_net_clear(&net);
}

/* The floor moves at v: friction brings the mass to v in v/(mu*g), and the slip is v^2/(2*mu*g). On a
 * floor with the slope atan(0.29) it stays. */
static void slides(void)
{
	static const char *const set[] = {"obstacles.floor.velocity=[1.7 m/s, 0, 0]", "nodes.B=[0, 0, 0]",
	                                  "contact.restitution=0"};
	static const char *const slope[] = {
		"obstacles=[{plane: {point: [0, 0], normal: [-0.29, 1]}, friction: 0.3}]",
		"nodes.B=[0, 0, 0]", "contact.restitution=0"};
	const struct hawser_net_probe at = {.node = 1, .cable = -1};
	struct hawser_net_motion_options options = {.until = 1.0, .every = 0.1, .probe = &at, .probes = 1};
	struct hawser_net net;
	struct hawser_net_motion motion;
	double stop = 1.7*1.7/(2.0*0.3*9.81), error[2];

	for (int i = 0; i < 2; i++) {
		options.step = i ? 0.5e-3 : 1e-3;
		if (moved(&net, &motion, &options, "net-impact", set, 3)) {
			error[i] = fabs(1.7 - motion.x[motion.rows - 1][0] - stop);
			kept(&motion);
			close_to(motion.dissipated[motion.rows - 1], 2.0*9.81*0.3*stop, 1e-6,
			         "heat of the slip, J");
			close_to(motion.v[motion.rows - 1][0], 1.7, 1e-14, "taken along");
		}
		hawser_net_motion_clear(&motion);
		hawser_net_clear(&net);
	}
	ok(error[0] <= 1e-6 && error[1] <= error[0], "slip to %.1e m, and %.1e m with half the step",
	   error[0], error[1]);
	if (moved(&net, &motion, &options, "net-impact", slope, 3)) {
		ok(fabs(motion.x[motion.rows - 1][0]) <= 1e-6 && motion.v[motion.rows - 1][0] == 0.0 &&
		   motion.sliding[motion.rows - 1] == 0, "it sticks on a slope below mu");
		close_to(motion.contacts ? motion.contact[0].r : 0.0, 2.0*9.81/sqrt(1.0 + 0.29*0.29), 1e-12,
		         "normal force, N");
	}
	hawser_net_motion_clear(&motion);
	hawser_net_clear(&net);
}

/* B Table 3.2: the tension at the start, and then the mean pull mu*w*(L - s) + alpha*v*L, of which s is
 * the lifted part (doc/theory-contact.md); all nodes on the floor slide. */
static void dragged(void)
{
	const struct hawser_net_probe at = {.node = 1, .cable = -1};
	const struct hawser_net_motion_options options = {.until = 3.0, .every = 0.5, .probe = &at,
	                                                  .probes = 1};
	char table[5000];
	const char *const set[] = {table};
	struct hawser_net net;
	struct hawser_net_motion motion;
	const double h = 0.04, L = 1.2, w = 0.15*9.81, s = -h + sqrt(2.0*h*h + 2.0*h*L);

	snprintf(table, sizeof table, "supports.B={table: '%s'}",
	         source_file("notebooks-data/scenes/net-dragged.txt"));
	if (moved(&net, &motion, &options, "net-dragged", set, 1)) {
		int last = motion.rows - 1;

		kept(&motion);
		/* 16.18 N of the equilibrium, and EA*axial*v/length0 of the first element, of slope 0.063 */
		close_to(motion.T[0], 16.18 + 30400.0*1e-4*0.5/0.02*0.998, 1e-3, "tension at the start, N");
		close_to((motion.work[last] - motion.work[last - 2])/0.5, w*(L - s) + 0.011*0.5*L, 3e-3,
		         "mean pull over 1 s, N");
		ok(motion.touching[last] >= 44 && motion.sliding[last] == motion.touching[last],
		   "%d nodes touch, %d slide", motion.touching[last], motion.sliding[last]);
	}
	hawser_net_motion_clear(&motion);
	hawser_net_clear(&net);
}

/* A cable that swings down onto a floor, and comes to rest there. */
static void falls(void)
{
	const struct hawser_net_probe at = {.node = 1, .cable = -1};
	const struct hawser_net_motion_options options = {.until = 1.0, .every = 0.05, .probe = &at,
	                                                  .probes = 1};
	struct hawser_net net;
	struct hawser_net_motion motion;

	if (moved(&net, &motion, &options, "net-pendulum", NULL, 0)) {
		kept(&motion);
		ok(motion.touching[motion.rows - 1] > 2 && motion.x[motion.rows - 1][1] >= -1.2 - 1e-12,
		   "it lies on the floor");
	}
	hawser_net_motion_clear(&motion);
	hawser_net_clear(&net);
}

/* A mass on a floor that moves comes to the wedge of the floor and a circle, where normals meet at
 * asin(0.6), 36.9 degrees. At rest there, with a force A of the circle, its friction b*A and N of
 * the floor: A*0.8 - b*A*0.6 + w = N, mu*N = A*0.6 + b*A*0.8, where |b| may be less than the
 * coefficient. With b = 0 none is positive beyond mu = 0.75 = tan(angle), as tan(angle + atan(b))
 * tells for any b. */
static void wedge(double mu, double most, int held)
{
	const struct hawser_net_probe at = {.node = 1, .cable = -1};
	const struct hawser_net_motion_options options = {.until = 2.5, .every = 0.1, .probe = &at,
	                                                  .probes = 1};
	char obstacles[300];
	const char *path = source_file("notebooks-data/scenes/net-impact.yaml");
	const char *const set[] = {"nodes={A: [0, 3, 0], B: [1, 0, 0]}", obstacles,
	                           "contact={restitution: 0}"};
	struct hawser_net net;
	struct hawser_net_motion motion = {0};
	struct hawser_report report;
	enum hawser_status status;

	snprintf(obstacles, sizeof obstacles, "obstacles=[{name: floor, plane: {point: [0, 0], normal: "
	         "[0, 1]}, friction: %g, velocity: [-0.5, 0]}, {name: k, circle: {centre: [0, 0.4], "
	         "radius: 0.5}, "
	         "friction: %g}]", mu, most);
	status = hawser_net_open(&net, path, set, 3, &report);
	if (!status)
		status = hawser_net_integrate(&motion, &net, &options, &report);
	if (!held)
		ok(status == HAWSER_ERR_NO_SOLUTION && strstr(report.message, "floor and k"), "refused: %s",
		   report.message);
	else if (ok(!status && motion.contacts == 2, "mu %g and %g: %s", mu, most,
	            status ? report.message : "moves")) {
		const struct hawser_net_contact *floor = &motion.contact[0], *k = &motion.contact[1];
		double b = hypot(k->friction[0], k->friction[1])/k->r;
		double A = mu*2.0*9.81/(0.6 + 0.8*b - mu*(0.8 - 0.6*b));

		close_to(motion.x[motion.rows - 1][0], 0.3, 1e-9, "x where the mass is held, m");
		ok(b <= most*(1.0 + 1e-9), "friction %g of the circle", b);
		close_to(k->r, A, 1e-9, "force of the circle, N");
		close_to(floor->r, 2.0*9.81 + A*(0.8 - 0.6*b), 1e-9, "force of the floor, N");
	}
	hawser_net_motion_clear(&motion);
	hawser_net_clear(&net);
}

CASE(reference_net_impact)
{
	bounces(0.7);
	bounces(0.0);
	bounces(1.0);
	slides();
	dragged();
	falls();
	wedge(0.5, 0.0, 1);
	wedge(0.9, 0.3, 1);
	wedge(0.9, 0.0, 0);
	return done_testing();
}
