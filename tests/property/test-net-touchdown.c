/* net/motion/motion-touchdown.c: the energy of an element that lies in part: its derivatives against
 * differences, the work of its mean force, and the weight that it holds on a rigid plane.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "net/motion/motion-bed.h"
#include "tests/tap.h"

static const double SIZE = 20.0, WEIGHT = 870.0, TENSION = 5e5;

static struct hawser__touchdown element(double stiffness)
{
	return (struct hawser__touchdown){.k = stiffness, .w = WEIGHT, .curvature = WEIGHT/TENSION,
	                                  .L = SIZE};
}

static double at(const struct hawser__touchdown *of, double a, double b)
{
	double F[2], s[2] = {a, b};

	return hawser__touchdown_energy(F, NULL, of, s);
}

static void derivatives(const struct hawser__touchdown *of, double a, double b)
{
	const double d = 2e-7, s[2] = {a, b};
	double F[2], F_s[2][2], size = of->w*of->L;

	(void)hawser__touchdown_energy(F, F_s, of, s);
	for (int i = 0; i < 2; i++) {
		double up[2] = {a + (i ? 0.0 : d), b + (i ? d : 0.0)}, more[2];
		double down[2] = {a - (i ? 0.0 : d), b - (i ? d : 0.0)}, less[2];
		double change = hawser__touchdown_energy(more, NULL, of, up) -
		                hawser__touchdown_energy(less, NULL, of, down);

		close_to(change/(2.0*d)/size, F[i]/size, 1e-7, "force of an end");
		for (int j = 0; j < 2; j++)
			close_to((more[j] - less[j])/(2.0*d)/of->k, F_s[j][i]/of->k, 1e-5, "its derivative");
	}
}

static void mean(struct hawser__touchdown *of, double a, double b, double c, double e)
{
	const double s0[2] = {a, b}, s1[2] = {c, e}, d = 2e-7;
	double F[2], F_s[2][2];

	hawser__touchdown_begin(of, s0);
	hawser__touchdown_mean(F, F_s, of, s0, s1);
	close_to((F[0]*(c - a) + F[1]*(e - b))/of->w, (at(of, c, e) - at(of, a, b))/of->w, 1e-10,
	         "the work is the change of the energy");
	for (int i = 0; i < 2; i++) {
		double up[2] = {c + (i ? 0.0 : d), e + (i ? d : 0.0)}, more[2];
		double down[2] = {c - (i ? 0.0 : d), e - (i ? d : 0.0)}, less[2], unused[2][2];

		hawser__touchdown_mean(more, unused, of, s0, up);
		hawser__touchdown_mean(less, unused, of, s0, down);
		for (int j = 0; j < 2; j++)
			close_to((more[j] - less[j])/(2.0*d)/of->k, F_s[j][i]/of->k, 1e-5,
			         "derivative of the mean force");
	}
}

/* On a plane that hardly gives way, the bar and what is added hold the weight of the free length. */
static void free_end(void)
{
	const struct hawser__touchdown of = element(1e15);
	const double length = 7.3, s[2] = {0.0, -0.5*of.curvature*length*length};
	double F[2];

	(void)hawser__touchdown_energy(F, NULL, &of, s);
	close_to(0.5*WEIGHT*SIZE - TENSION*s[1]/SIZE - F[1], WEIGHT*length, 1e-4, "weight that is held");
	close_to(0.5 + TENSION*s[1]/SIZE/SIZE/WEIGHT - F[0]/SIZE/WEIGHT, 0.0, 1e-5,
	         "none at the end that lies");
}

CASE(property_net_touchdown)
{
	struct hawser__touchdown of = element(2.3e6), soft = element(4e3);
	const double lies = 0.5*WEIGHT*SIZE/of.k, top = 0.5*of.curvature*SIZE*SIZE;

	derivatives(&of, lies*1.3, -0.3*top);
	derivatives(&of, lies*0.6, -0.3*top);
	derivatives(&of, -0.05*top, -0.2*top);
	derivatives(&of, lies*0.5, lies*0.8);
	derivatives(&of, lies*1.1, lies*0.8);
	derivatives(&soft, 0.3, -0.1);
	derivatives(&soft, 1.0, 0.4);
	mean(&of, lies*1.3, -0.3*top, lies*1.4, -0.35*top);
	mean(&of, lies*0.7, -0.3*top, lies*1.4, lies);
	mean(&of, -0.1*top, -2.0*top, lies*0.4, -0.2*top);
	mean(&soft, 0.3, -0.1, 0.2, 0.4);
	mean(&of, lies*0.7, lies*0.8, lies*0.7001, lies*0.8003);
	free_end();
	ok(at(&of, 2.0*lies, -1.0001*top) == 0.0, "nothing where all of it is free");
	close_to(at(&of, 2.0*lies, -0.9999*top), 0.0, 1e-9, "up to there");
	return done_testing();
}
