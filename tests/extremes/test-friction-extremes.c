/* Contact with friction: impossible input is refused with a status and a message that names it, and
 * extreme but possible input is solved.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "tests/friction-random.h"
#include "tests/tap.h"

static struct friction_case of;
static struct hawser_contact_reply reply[FRICTION_NODES];
static struct hawser_friction_counts counts;
static struct hawser_report report;
static double u[FRICTION_NODES][3];

static void refused(enum hawser_status want, const char *part)
{
	enum hawser_status status;

	report.message[0] = '\0';
	status = friction_solve(u, reply, &counts, &of, &report);
	ok(status == want && strstr(report.message, part), "%s: \"%s\"", hawser_status_name(status),
	   report.message);
}

/* Two nodes with a link, the first at a floor. */
static void two(void)
{
	static const double up[3] = {0.0, 1.0, 0.0};

	memset(&of, 0, sizeof of);
	of.nodes = 2;
	of.contacts = 1;
	of.link[0][1] = 1;
	for (int k = 0; k < 9; k += 4) {
		of.diagonal[0][k] = of.diagonal[1][k] = 3.385;
		of.off[0][k] = -1.0;
	}
	of.right[0][1] = of.right[1][1] = -1.0;
	of.contact[0].friction = 0.3;
	hawser_contact_frame(&of.contact[0], up);
}

static void numbers(void)
{
	two();
	of.contact[0].friction = INFINITY;
	refused(HAWSER_ERR_ARGUMENT, "contact 0: the friction coefficient is inf");
	of.contact[0].friction = -0.1;
	refused(HAWSER_ERR_ARGUMENT, "is -0.1; it is 0 or more");
	of.contact[0].friction = NAN;
	refused(HAWSER_ERR_NAN, "friction coefficient is nan");
	two();
	of.contact[0].restitution = 1.1;
	refused(HAWSER_ERR_ARGUMENT, "restitution is 1.1");
	two();
	of.contact[0].gap_rate = NAN;
	refused(HAWSER_ERR_NAN, "contact 0: the gap rate (nan m/s)");
	two();
	of.diagonal[1][4] = NAN;
	refused(HAWSER_ERR_NAN, "the block of M of node 1");
	two();
	of.off[0][4] = INFINITY;
	refused(HAWSER_ERR_NAN, "the block of M of link 0");
	two();
	of.right[1][2] = NAN;
	refused(HAWSER_ERR_NAN, "the right side p of node 1");
	two();
	of.diagonal[1][1] = 0.5;
	refused(HAWSER_ERR_ARGUMENT, "node 1 is not symmetric");
}

static void shapes(void)
{
	static const double zero[3] = {0.0}, down[3] = {0.0, -1.0, 0.0}, left[3] = {-1.0, 0.0, 0.0};
	struct hawser_contact contact;

	ok(!hawser_contact_frame(&contact, zero), "a normal of length 0 makes no frame");
	two();
	memset(of.contact[0].normal, 0, sizeof of.contact[0].normal);
	refused(HAWSER_ERR_ARGUMENT, "normal and tangents are not orthogonal unit vectors");
	two();
	of.contact[0].node = 2;
	refused(HAWSER_ERR_ARGUMENT, "node 2 is none of the nodes 0 to 1");
	two();
	of.held[0] = 2;
	refused(HAWSER_ERR_ARGUMENT, "direction y of node 0 is held");
	two();
	of.link[0][1] = 5;
	refused(HAWSER_ERR_ARGUMENT, "link 0 joins node 0 and node 5");
	two();
	of.contacts = 2; /* floor and ceiling that move towards each other */
	hawser_contact_frame(&of.contact[1], down);
	of.contact[1].gap_rate = -0.2;
	refused(HAWSER_ERR_NO_SOLUTION, "contacts of node 0 contradict each other");
	of.contact[1].gap_rate = 0.2;
	refused(HAWSER_OK, "");
	two();
	of.contacts = 3; /* two walls and a floor that leave no room */
	hawser_contact_frame(&of.contact[1], left);
	contact = of.contact[1];
	contact.normal[0] = 0.8;
	contact.normal[1] = -0.6;
	hawser_contact_frame(&of.contact[2], contact.normal);
	of.contact[0].gap_rate = -1.0;
	refused(HAWSER_ERR_NO_SOLUTION, "contradict each other");
	of.contact[0].gap_rate = 1.0;
	refused(HAWSER_OK, "");
	of.contacts = 5;
	of.contact[0].gap_rate = 0.0;
	for (int c = 1; c < 5; c++)
		of.contact[c] = of.contact[0];
	refused(HAWSER_ERR_ARGUMENT, "more than 4 contacts");
	two();
	of.nodes = 3; /* a ring */
	of.rings = 1;
	for (int n = 0; n < 3; n++) {
		of.link[n][0] = n;
		of.link[n][1] = (n + 1)%3;
		for (int k = 0; k < 9; k += 4)
			of.diagonal[n][k] = 3.385, of.off[n][k] = n ? -1e-3 : -1.0;
	}
	of.contacts = 2;
	of.contact[1] = of.contact[0];
	refused(HAWSER_ERR_ARGUMENT, "where the links form no chains, a node may have one");
	of.contacts = 1;
	refused(HAWSER_OK, "");
	of.diagonal[2][4] = -1.0;
	refused(HAWSER_ERR_NO_SOLUTION, "not positive definite");
	two();
	for (int c = 1; c < 3; c++)
		of.contact[c] = of.contact[0];
	of.contacts = 3;
	refused(HAWSER_OK, "");
	ok(fabs(reply[0].impulse[0] + reply[1].impulse[0] + reply[2].impulse[0] - 1.0 - 1.0/3.385) < 1e-9,
	   "the same contact three times: impulses %g %g %g", reply[0].impulse[0], reply[1].impulse[0],
	   reply[2].impulse[0]);
}

static void masses(void)
{
	two();
	of.diagonal[0][0] = of.diagonal[0][4] = of.diagonal[0][8] = 0.0;
	refused(HAWSER_ERR_NO_SOLUTION, "not positive definite");
	two();
	for (int k = 0; k < 9; k += 4)
		of.diagonal[0][k] = 1.0, of.diagonal[1][k] = 0.9;
	refused(HAWSER_ERR_NO_SOLUTION, "not positive definite");
}

/* The same problem in other units has the same states; friction without practical limit sticks. */
static void sizes(void)
{
	static const double factor[] = {1e-60, 1e-9, 1e9, 1e60};
	struct hawser_friction_counts first;

	friction_random(&of, 7, 0.6, 1e3);
	refused(HAWSER_OK, "");
	first = counts;
	for (int i = 0; i < 4; i++) {
		friction_random(&of, 7, 0.6, 1e3);
		for (int n = 0; n < of.nodes; n++) {
			for (int k = 0; k < 9; k++) {
				of.diagonal[n][k] *= factor[i];
				of.off[n][k] *= factor[i];
			}
			for (int k = 0; k < 3; k++)
				of.right[n][k] *= of.held[n] & 1U << k ? 1.0 : factor[i];
		}
		refused(HAWSER_OK, "");
		ok(counts.open == first.open && counts.stick == first.stick && counts.slip == first.slip,
		   "M times %g: open %d, stick %d, slip %d", factor[i], counts.open, counts.stick,
		   counts.slip);
	}
	two();
	of.contact[0].friction = 1e9;
	of.right[0][0] = 3.0;
	refused(HAWSER_OK, "");
	ok(reply[0].state == HAWSER_CONTACT_STICK && fabs(u[0][0]) < 1e-12,
	   "friction 1e9: %s, %.1e m/s", hawser_contact_state_name(reply[0].state), u[0][0]);
	two();
	of.right[0][1] = of.right[1][1] = 0.0;
	refused(HAWSER_OK, "");
	ok(counts.residual == 0.0 && counts.balance == 0.0, "nothing acts: nothing moves");
	of.contacts = 0;
	refused(HAWSER_OK, "");
}

CASE(extremes_friction_extremes)
{
	numbers();
	shapes();
	masses();
	sizes();
	return done_testing();
}
