/* Nets on obstacles against closed forms: a mooring line on a seabed, with and without friction; the
 * polygon of the capstan; a chain dragged over a floor; a cable that hangs into a valley of two planes,
 * turned in space; a rope over the edge of a table.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/net.h>

#include "tests/tap.h"

static int solved(struct hawser_net *net, struct hawser_net_statics *st, const char *scene,
                  const char *const *set, size_t sets)
{
	struct hawser_report report;
	const char *path = source_file("notebooks-data/scenes/%s.yaml", scene);
	enum hawser_status status;

	status = hawser_net_open(net, path, set, sets, &report);
	if (!status)
		status = hawser_net_solve(st, net, NULL, &report);
	return ok(!status, "%s: %s", scene, status ? report.message : "solved");
}

/* The capstan's scene, with the obstacle and so on of `set`, is refused. */
static void refused(const char *const *set, size_t sets, enum hawser_status expected, const char *words)
{
	struct hawser_net net;
	struct hawser_net_statics st;
	struct hawser_report report;
	const char *path = source_file("notebooks-data/scenes/net-capstan.yaml");
	enum hawser_status status;

	status = hawser_net_open(&net, path, set, sets, &report);
	if (!status)
		status = hawser_net_solve(&st, &net, NULL, &report);
	ok(status == expected && strstr(report.message, words), "refused: %s", report.message);
	hawser_net_statics_clear(&st);
	hawser_net_clear(&net);
}

static double sum(const struct hawser_net_statics *st)
{
	double r = 0.0;

	for (int i = 0; i < st->contacts; i++)
		r += st->contact[i].r;
	return r;
}

/* Elastic catenary and seabed: the exact values were computed with 16 digits for the case of MoorPy's
 * test (400 m, 200 m, 500 m, 800 N/m, EA 7.51e12 N). */
static void seabed(void)
{
	static const char *const set[] = {"cables.line.elements=400", "contact={sliding: none}"};
	struct hawser_net net;
	struct hawser_net_statics st;
	double w = 81.549439*9.81, half = 500.0/400*w/2.0;

	if (solved(&net, &st, "net-seabed", set, 2)) {
		close_to(st.reaction[1][0], 96643.4535, 1e-5, "H at the fairlead, N");
		close_to(st.reaction[1][1], 237751.7680, 1e-5, "V at the fairlead, N");
		close_to(sum(&st)/w, 202.810290, 1e-5, "length on the seabed, m");
		ok(st.gap >= 0.0 && st.gap <= 1e-14*st.energy && st.apart <= 1e-12, "gap %.1e J, penetration "
		   "%.1e m", st.gap, st.apart);
		ok(fabs(st.reaction[0][1]) <= 1e-6*half, "the anchor bears nothing of the line: %.1e N",
		   st.reaction[0][1]);
		close_to(st.member[0].T_from, 96643.4535, 1e-5, "tension at the anchor, N");
	}
	hawser_net_statics_clear(&st);
	hawser_net_clear(&net);
	if (solved(&net, &st, "net-seabed", set, 1)) {
		int slides = 1;

		for (int i = 0; i < st.contacts; i++) {
			const struct hawser_net_contact *c = &st.contact[i];

			slides = slides && !c->sticks && fabs(c->friction[0] + 0.1*c->r) <= 1e-9*c->r;
		}
		ok(slides, "all of it slides towards the fairlead");
		close_to(st.reaction[1][0], 96643.4535, 1e-5, "H is that without friction");
		close_to(-st.reaction[0][0], 80418.63, 1e-5, "force on the anchor, N");
		close_to(st.member[0].T_from, 80418.63, 1e-5, "tension at the anchor, N");
	}
	hawser_net_statics_clear(&st);
	hawser_net_clear(&net);
}

/* At each node of a drum, with angles a, b of the rope to the surface before and behind,
 * T_b/T_a = (cos a + mu*sin a)/(cos b - mu*sin b); of the polygon, the power of one of them. */
static void capstan(void)
{
	const double mu = 0.3;
	struct hawser_net net;
	struct hawser_net_statics st;
	double worst = 0.0, T = 0.0, first = 0.0;

	if (solved(&net, &st, "net-capstan", NULL, 0)) {
		for (int i = 1; i < st.points - 1; i++) {
			const double *p = st.point[i - 1].x, *q = st.point[i].x, *r = st.point[i + 1].x;
			double n[2] = {q[0]/hypot(q[0], q[1]), q[1]/hypot(q[0], q[1])};
			double before[2] = {q[0] - p[0], q[1] - p[1]}, behind[2] = {r[0] - q[0], r[1] - q[1]};
			double a = asin((before[0]*n[0] + before[1]*n[1])/hypot(before[0], before[1]));
			double b = asin(-(behind[0]*n[0] + behind[1]*n[1])/hypot(behind[0], behind[1]));
			double ratio = (cos(a) + mu*sin(a))/(cos(b) - mu*sin(b)), last;

			/* a point has the mean of the tensions before and behind it */
			first = i > 1 ? first : 2.0*st.point[i].T/(1.0 + ratio);
			last = i > 1 ? T : first;
			T = last*ratio;
			worst = fmax(worst, fabs(2.0*st.point[i].T - last - T)/T);
		}
		ok(st.contacts == 12 && worst < 1e-9, "the law of each of %d nodes: %.1e", st.contacts, worst);
		close_to(T/first, 2.588356, 1e-6, "ratio of the tensions");
		/* the ends are held on the drum: half an element more of it rubs at each */
		close_to(log(st.member[0].T_to/st.member[0].T_from), 1.1*log(2.588356), 1e-3,
		         "with the ends");
		ok(isinf(st.gap), "outside a circle there is no bound of the energy");
	}
	hawser_net_statics_clear(&st);
	hawser_net_clear(&net);
}

/* Lifted length s = -mu*h + sqrt(mu^2 h^2 + h^2 + 2 mu h L), H = mu*w*(L - s), V = w*s. */
static void drag(void)
{
	static const double mus[] = {1.0, 0.385};
	static const char *const set[] = {"obstacles.floor.friction=1", "obstacles.floor.friction=0.385"};
	struct hawser_net net;
	struct hawser_net_statics st;

	for (int i = 0; i < 2; i++) {
		double mu = mus[i], h = 0.04, L = 1.2, w = 0.15*9.81;
		double s = -mu*h + sqrt(mu*mu*h*h + h*h + 2.0*mu*h*L);

		if (solved(&net, &st, "net-drag", &set[i], 1)) {
			close_to(st.reaction[1][0], mu*w*(L - s), 1e-4, "pull of a chain on a floor that moves, N");
			close_to(st.reaction[1][1], w*s, 1e-4, "weight of what is lifted, N");
			ok(!st.contact[0].sticks && st.apart < 1e-12, "it slides");
		}
		hawser_net_statics_clear(&st);
		hawser_net_clear(&net);
	}
}

/* Two routes to one equilibrium: obstacles that are turned about y with the net. */
static void turned(void)
{
	struct hawser_report report;
	struct hawser_net_statics st[2];
	double angle = 0.785;

	for (int i = 0; i < 2; i++) {
		struct hawser_net net;
		char nodes[200], planes[400];
		double c = cos(i*angle), s = sin(i*angle);
		const char *set[] = {nodes, planes, "cables.line.length0=520", "cables.line.EA=1e7",
		                     "contact={sliding: none}"};
		const char *path = source_file("notebooks-data/scenes/net-seabed.yaml");

		snprintf(nodes, sizeof nodes, "nodes={A: [0, 0, 0], B: [%.17g, 30, %.17g]}", 400.0*c, 400.0*s);
		snprintf(planes, sizeof planes, "obstacles=[{plane: {point: [0, 0, 0], normal: [%.17g, 1, "
		         "%.17g]}}, {plane: {point: [0, -90, 0], normal: [%.17g, 1, %.17g]}}]", 0.385*c,
		         0.385*s, -0.2*c, -0.2*s);
		ok(!hawser_net_open(&net, path, set, 5, &report) &&
		   !hawser_net_solve(&st[i], &net, NULL, &report), "a valley");
		hawser_net_clear(&net);
	}
	close_to(st[1].energy, st[0].energy, 1e-10, "its energy does not change as it is turned");
	close_to(hypot(st[1].reaction[1][0], st[1].reaction[1][2]), fabs(st[0].reaction[1][0]), 1e-9,
	         "H, N");
	ok(st[0].contacts == st[1].contacts && st[0].contacts > 10, "%d nodes touch", st[0].contacts);
	for (int i = 0; i < 2; i++)
		hawser_net_statics_clear(&st[i]);
}

/* A rope without weight and friction is drawn over the edge of a table. Nodes do not stay on the end of
 * the segment, and an element that cuts it has different tensions on both sides. Round, the edge leaves
 * them equal but for the corners of the mesh, whose angles are h/R = 0.15: less than 0.15^2/8 of the
 * tension. */
static void edge(void)
{
	static const char *const set[] = {
		"nodes={A: [0, 0.2, 0], B: [2, -1, 0]}",
		"cables=[{name: c, from: A, to: B, EA: 10 kN, rho: 0.15 kg/m, length0: 2.35, elements: 43}]",
		"obstacles=[{segment: {from: [0.2, 0], to: [1, 0]}}]", "contact={sliding: none}",
		"cables.c.elements=40", "cables.c.elements=160",
		"obstacles=[{segment: {from: [0.2,0], to: [1,0]}}, {circle: {centre: [1,-0.1], radius: 0.1}}]"};
	const char *const forty[] = {set[0], set[1], set[2], set[3], set[4]};
	const char *const round[] = {set[0], set[1], set[6], set[3], set[5]};
	struct hawser_net net;
	struct hawser_net_statics st;

	refused(set, 4, HAWSER_ERR_NO_SOLUTION, "goes through obstacle s0 at (0.991788, 0) m");
	refused(forty, 5, HAWSER_ERR_CONVERGENCE, "at the end (1, 0) m of obstacle s0");
	if (solved(&net, &st, "net-capstan", round, 5))
		close_to(hypot(st.reaction[1][0], st.reaction[1][1])/
		         hypot(st.reaction[0][0], st.reaction[0][1]), 1.0, 2.8e-3,
		         "no friction on a round edge");
	hawser_net_statics_clear(&st);
	hawser_net_clear(&net);
}

CASE(reference_net_contact)
{
	seabed();
	capstan();
	drag();
	turned();
	edge();
	return done_testing();
}
