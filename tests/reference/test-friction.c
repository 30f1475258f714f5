/* Contact with friction in one step against closed forms.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/friction.h>

#include "tests/tap.h"

enum { MOST = 900 };
#define PI 3.14159265358979323846

static int link_of[MOST][2];
static double diagonal[MOST][9], off[MOST][9], right[MOST][3], u[MOST][3];
static unsigned char held[MOST];
static struct hawser_contact contact[MOST];
static struct hawser_contact_reply reply[MOST];
static struct hawser_friction_counts counts;
static struct hawser_report report;

static struct hawser_friction_problem problem(int contacts)
{
	return (struct hawser_friction_problem){
		.diagonal = (const double (*)[9])diagonal, .off = (const double (*)[9])off,
		.right = (const double (*)[3])right, .held = held, .contact = contact, .contacts = contacts};
}

static void clear(void)
{
	memset(diagonal, 0, sizeof diagonal);
	memset(off, 0, sizeof off);
	memset(right, 0, sizeof right);
	memset(held, 0, sizeof held);
	memset(contact, 0, sizeof contact);
	for (int i = 0; i + 1 < MOST; i++) {
		link_of[i][0] = i;
		link_of[i][1] = i + 1;
	}
}

/* Add a*I + b*d*d^T of the element from node i to the next. */
static void element(int i, double a, double b, const double d[3])
{
	for (int j = 0; j < 9; j++) {
		double value = (j%4 ? 0.0 : a) + b*d[j/3]*d[j%3];

		diagonal[i][j] += value;
		diagonal[i + 1][j] += value;
		off[i][j] -= value;
	}
}

static int solved(int nodes, int contacts)
{
	const struct hawser_friction_problem of = problem(contacts);
	struct hawser_friction *solver;
	enum hawser_status status = hawser_friction_open(&solver, nodes, (const int (*)[2])link_of,
	                                                 nodes - 1, contacts, &report);

	if (!status)
		status = hawser_friction_solve(solver, u, reply, &counts, &of, NULL, &report);
	if (status)
		printf("# %s\n", report.message);
	hawser_friction_clear(solver);
	return !status;
}

/* A cable over the corners of a polygon of turning angle beta, pulled until it slides at all of them:
 * each corner multiplies the tension by (cos(d/2) + mu sin(d/2))/(cos(d/2) - mu sin(d/2)), d = beta/n,
 * which is exp(mu beta) for n without limit. u are displacements, k the stiffness of an element. */
static double capstan(int n, double mu, double beta, double pull)
{
	const double k = 2385.0, T0 = 10.0, delta = beta/n;
	double first[3], last[3], T[2];

	clear();
	for (int e = 0; e <= n; e++) {
		const double d[3] = {cos(e*delta), -sin(e*delta), 0.0};

		element(e, 0.0, k, d);
		for (int i = 0; i < 3; i++) {
			right[e][i] += T0*d[i];
			right[e + 1][i] -= T0*d[i];
		}
		memcpy(e ? last : first, d, sizeof d);
	}
	for (int i = 0; i <= n + 1; i++)
		held[i] = i && i <= n ? 4 : 7;
	memset(right[0], 0, sizeof right[0]);
	for (int i = 0; i < 3; i++)
		right[n + 1][i] = pull*last[i];
	for (int c = 0; c < n; c++) {
		const double normal[3] = {sin((c + 0.5)*delta), cos((c + 0.5)*delta), 0.0};

		contact[c].node = c + 1;
		contact[c].friction = mu;
		hawser_contact_frame(&contact[c], normal);
		for (int i = 0; i < 9; i++) /* the elements alone do not hold the corners without contact */
			diagonal[c + 1][i] += k*normal[i/3]*normal[i%3];
	}
	if (!solved(n + 2, n))
		return NAN;
	T[0] = T0;
	T[1] = T0;
	for (int i = 0; i < 3; i++) {
		T[0] += k*first[i]*(u[1][i] - u[0][i]);
		T[1] += k*last[i]*(u[n + 1][i] - u[n][i]);
	}
	return T[1]/T[0];
}

static void polygons(void)
{
	double d = PI/20.0, corner = (cos(d) + 0.3*sin(d))/(cos(d) - 0.3*sin(d));

	close_to(capstan(10, 0.3, PI, 1.0), 2.588356, 2e-7, "capstan polygon of 10 corners, as printed");
	ok(counts.slip == 10, "all corners slip: %d", counts.slip);
	close_to(capstan(10, 0.3, PI, 1.0), pow(corner, 10.0), 1e-13, "to round-off");
	close_to(capstan(10, 0.3, PI, -0.02), pow(corner, -10.0), 1e-13, "pushed back");
	d = 2.385/600.0;
	corner = (cos(d) + 0.45*sin(d))/(cos(d) - 0.45*sin(d));
	close_to(capstan(300, 0.45, 2.385, 30.0), pow(corner, 300.0), 1e-11, "300 corners");
}

/* A string of tension 1 and length 1 under the load 8 touches the floor 1/2 below its ends over
 * 1 - sqrt(1/2) of its length: the floor bears 8 - 4 sqrt(2) = 2.343146. */
static double floor_force(int n, double mu)
{
	static const double across[3] = {0.0, 1.0, 0.0};
	const double h = 1.0/(n + 1);
	double sum = 0.0;

	clear();
	for (int e = 0; e <= n; e++)
		element(e, 1.0/h, 0.0, across);
	for (int i = 0; i <= n + 1; i++) {
		held[i] = i && i <= n ? 5 : 7;
		right[i][1] = i && i <= n ? -8.0*h : 0.0;
	}
	for (int c = 0; c < n; c++) {
		contact[c] = (struct hawser_contact){.node = c + 1, .friction = mu, .gap_rate = 0.5};
		hawser_contact_frame(&contact[c], across);
	}
	if (!solved(n + 2, n))
		return NAN;
	for (int c = 0; c < n; c++)
		sum += reply[c].impulse[0];
	return sum;
}

static void floors(void)
{
	const double exact = 8.0 - 4.0*sqrt(2.0);

	for (int n = 50; n <= 800; n *= 4)
		close_to(floor_force(n, 0.0), exact, 2.0/(n*n), "string on a floor");
	close_to(floor_force(800, 0.3), exact, 2.0/(800*800), "string on a floor with friction");
}

/* One node of mass m on a floor: p is its momentum without contact. */
static void one(double m, double px, double py, double mu, double e, double before)
{
	static const double up[3] = {0.0, 2.0, 0.0};

	clear();
	for (int k = 0; k < 3; k++)
		diagonal[0][4*k] = m;
	right[0][0] = px;
	right[0][1] = py;
	contact[0] = (struct hawser_contact){.friction = mu, .restitution = e, .before = before};
	hawser_contact_frame(&contact[0], up);
}

static void nodes(void)
{
	one(2.385, 0.7, -3.1, 0.3, 0.0, 0.0);
	ok(solved(1, 1) && reply[0].state == HAWSER_CONTACT_STICK, "a push within the cone sticks");
	close_to(reply[0].impulse[1], -0.7, 1e-14, "its tangential impulse");
	one(2.385, 1.7, -3.1, 0.3, 0.0, 0.0);
	ok(solved(1, 1) && reply[0].state == HAWSER_CONTACT_SLIP, "a push outside of the cone slips");
	close_to(u[0][0], (1.7 - 0.93)/2.385, 1e-14, "its velocity");
	close_to(counts.power, 0.93*(1.7 - 0.93)/2.385, 1e-13, "work of friction");
	one(2.385, 1.7, 3.1, 0.3, 0.0, 0.0);
	ok(solved(1, 1) && reply[0].state == HAWSER_CONTACT_OPEN && reply[0].impulse[0] == 0.0 &&
	   reply[0].impulse[1] == 0.0, "a node that leaves is open, its impulse exactly 0");
	one(2.0, 0.5, -4.0, 0.1, 1.0, -2.0);
	ok(solved(1, 1), "restitution 1");
	close_to(u[0][1], 2.0, 1e-14, "returns the normal velocity");
	close_to(u[0][0], 0.0, 1e-14, "and the impulse of 8 N s stops it along the floor");
	one(2.0, 0.5, -4.0, 0.01, 0.4, -2.0);
	ok(solved(1, 1), "restitution 0.4");
	close_to(u[0][1], 0.8, 1e-14, "normal velocity after");
	one(2.0, 0.5, -4.0, 0.1, 0.4, -2.0);
	contact[0].gap_rate = 2.5;
	ok(solved(1, 1) && reply[0].state == HAWSER_CONTACT_OPEN,
	   "the obstacle is not reached in the step: open");
	one(2.0, 0.0, -4.0, 0.2, 0.0, 0.0);
	contact[0].surface[0] = 1.1;
	ok(solved(1, 1) && reply[0].state == HAWSER_CONTACT_SLIP, "a moving surface drags");
	close_to(u[0][0], 0.4, 1e-14, "velocity of the dragged node");
}

/* A node in the corner of a floor and a wall. */
static void corner(void)
{
	static const double left[3] = {-1.0, 0.0, 0.0};

	for (int rough = 0; rough < 2; rough++) {
		one(2.385, 1.7, -3.1, 0.3*rough, 0.0, 0.0);
		contact[1].friction = 0.2*rough;
		hawser_contact_frame(&contact[1], left);
		ok(solved(1, 2), "a corner with friction %g", 0.3*rough);
		close_to(hypot(u[0][0], u[0][1]), 0.0, 1e-11, "stops the node");
		close_to(reply[0].impulse[0] + reply[1].impulse[1]*contact[1].tangent[0][1], 3.1, 1e-9,
		         "what bears it");
	}
	one(2.385, 1.7, 3.1, 0.0, 0.0, 0.0);
	hawser_contact_frame(&contact[1], left);
	ok(solved(1, 2) && reply[0].state == HAWSER_CONTACT_OPEN, "it leaves the floor along the wall");
	close_to(reply[1].impulse[0], 1.7, 1e-14, "impulse of the wall");
}

CASE(reference_friction)
{
	polygons();
	floors();
	nodes();
	corner();
	return done_testing();
}
