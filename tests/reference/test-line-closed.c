/* Statics of a rope over sheaves against closed forms: the capstan as an arc, as a polygon and with
 * the rope's weight, running rope, and two spans over a pulley.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <hawser/line.h>

#include "tests/tap.h"

static const double R = 4.7, friction = 0.3; /* m, 1 */

/* A rope over one circle, or over `count` small ones that touch its inside. */
static int over(struct hawser_line_statics *st, struct hawser_line *line,
                struct hawser_line_sheave *sheave, int count)
{
	const double r = 0.01, half = 1.1; /* m; rad: the small circles are from -half to half */

	for (int k = 0; k < count; k++) {
		double a = count > 1 ? half*(2.0*k/(count - 1) - 1.0) : 0.0;

		sheave[k] = (struct hawser_line_sheave){.centre = {60.0, 0.0}, .radius = R, .side = 1,
		                                        .friction = friction};
		if (count == 1)
			continue;
		sheave[k].radius = r;
		sheave[k].centre[0] += (R - r)*sin(a);
		sheave[k].centre[1] = (R - r)*cos(a);
	}
	line->sheave = sheave;
	line->sheaves = count;
	return !hawser_line_solve(st, line, NULL);
}

/* T behind a capstan of n contacts, each of which deflects the rope by the angle/n and has its normal
 * in the middle of this angle; before it T is 1. */
static double polygon(double angle, int n)
{
	double half = angle/n/2.0;

	return pow((cos(half) + friction*sin(half))/(cos(half) - friction*sin(half)), n);
}

/* A rope without noticeable weight: exp(friction angle), over one circle or ten; the polygon tends
 * to it as n^-2. */
static void capstan(void)
{
	struct hawser_line_sheave sheave[10];
	struct hawser_line line = {.EA = 5e7, .rho = 1e-13, .g = 9.81, .A = {0.0, -140.0},
	                           .B = {131.0, -150.0}, .given = HAWSER_LINE_T_A, .value = 1e4,
	                           .sliding = HAWSER_LINE_TOWARD_B};
	struct hawser_line_statics st;
	double last = 0.0;

	close_to(polygon(acos(-1.0), 10), 2.588356, 2e-7, "polygon of 10 contacts over half a turn");
	for (int count = 1; count <= 10; count += 9) {
		double angle;

		if (!ok(over(&st, &line, sheave, count), "over %d circles", count))
			continue;
		angle = st.angle_A - st.angle_B;
		ok(angle > 2.2 && angle < 3.0, "it is deflected by %.4f rad", angle);
		close_to(st.T_B/st.T_A, exp(friction*angle), 1e-11, "capstan law");
		for (int n = 10; n <= 1000 && count == 1; n *= 10) {
			double off = polygon(angle, n)*st.T_A/st.T_B - 1.0;

			if (n > 10)
				close_to(last/off, 100.0, 2e-2, "the polygon tends to it as n^-2");
			last = off;
		}
		hawser_line_statics_clear(&st);
	}
}

/* Heavy inextensible rope on a circle, psi = -slope angle, T growing along it:
 * T = C e^(m psi) + w R ((1 - m^2) cos psi + 2 m sin psi)/(1 + m^2). */
static double particular(double w, double m, double psi)
{
	return w*R*((1.0 - m*m)*cos(psi) + 2.0*m*sin(psi))/(1.0 + m*m);
}

static void heavy(void)
{
	struct hawser_line_sheave sheave;
	struct hawser_line line = {.EA = INFINITY, .rho = 23.85, .g = 9.81, .A = {0.0, -31.0},
	                           .B = {108.0, -52.0}, .given = HAWSER_LINE_T_A, .value = 2.6e4};
	struct hawser_line_statics st;
	const enum hawser_line_sliding way[2] = {HAWSER_LINE_TOWARD_B, HAWSER_LINE_TOWARD_A};

	for (int i = 0; i < 2; i++) {
		const struct hawser_line_contact *c;
		double m = i ? -friction : friction, w = line.rho*line.g, C;

		line.sliding = way[i];
		if (!ok(over(&st, &line, &sheave, 1), "heavy rope"))
			continue;
		c = &st.contact[0];
		C = (c->T_in - particular(w, m, -c->angle_in))*exp(m*c->angle_in);
		close_to(c->T_out, C*exp(-m*c->angle_out) + particular(w, m, -c->angle_out), 1e-12,
		         "tension behind the circle");
		close_to(c->T_out, i ? c->T_out_min : c->T_out_max, 1e-12, "is what friction allows");
		hawser_line_statics_clear(&st);
	}
}

/* Of a running rope T - rho v^2 obeys the law. */
static void running(void)
{
	struct hawser_line_sheave sheave;
	struct hawser_line line = {.EA = INFINITY, .rho = 0.829, .g = 1e-9, .A = {0.0, -60.0},
	                           .B = {131.0, -70.0}, .given = HAWSER_LINE_T_A, .value = 645.0,
	                           .speed = 11.3, .sliding = HAWSER_LINE_TOWARD_B};
	struct hawser_line_statics st;
	double thrust = line.rho*line.speed*line.speed;

	if (!ok(over(&st, &line, &sheave, 1), "a running rope"))
		return;
	close_to((st.T_B - thrust)/(st.T_A - thrust), exp(friction*(st.angle_A - st.angle_B)), 1e-9,
	         "capstan law of T - rho v^2");
	hawser_line_statics_clear(&st);
}

/* Horizontal span of a level catenary of unstretched length L, m. */
static double span_of(double H, double w, double L, double EA)
{
	return 2.0*H/w*asinh(w*L/2.0/H) + H*L/EA;
}

/* code_aster SSNL100: 30 N/m, two spans of 100 m over a pulley without friction, 10 m paid in. Its
 * sag of 13.930 m is that of an inextensible rope (13.9304 m). Another program had 13.9397 m at
 * 2757.02 N with EA, which is 4e-5 off the closed form. */
static void pulley(void)
{
	struct hawser_line_sheave sheave = {.centre = {100.0, 0.0}, .side = 1};
	struct hawser_line line = {.EA = 5e7, .rho = 30.0/9.81, .g = 9.81, .B = {200.0, 0.0},
	                           .given = HAWSER_LINE_LENGTH0, .value = 210.0, .sheave = &sheave,
	                           .sheaves = 1};
	struct hawser_line_statics st;
	double x[2], lo = 100.0, hi = 1e5, T, sag;

	if (!ok(!hawser_line_solve(&st, &line, NULL), "two spans over a pulley"))
		return;
	for (int i = 0; i < 100; i++) {
		double H = lo + (hi - lo)/2.0;

		if (span_of(H, 30.0, 105.0, line.EA) < 100.0)
			lo = H;
		else
			hi = H;
	}
	T = hypot(lo, 30.0*52.5);
	sag = (T - lo)/30.0 + (T*T - lo*lo)/(60.0*line.EA);
	close_to(st.T_A*cos(st.angle_A), lo, 1e-11, "H by the closed form");
	close_to(lo, 2757.02, 4e-5, "  by another program");
	for (int i = 0; i < 2; i++) {
		hawser_line_at(&st, x, NULL, NULL, NULL, NULL, i ? 157.5 : 52.5);
		close_to(-x[1], sag, 1e-11, "sag by the closed form");
	}
	close_to(sag, 13.9397, 4e-5, "  by another program");
	hawser_line_statics_clear(&st);
	line.EA = INFINITY;
	if (!ok(!hawser_line_solve(&st, &line, NULL), "without stretch"))
		return;
	hawser_line_at(&st, x, NULL, NULL, NULL, NULL, 52.5);
	close_to(-x[1], 13.930, 4e-5, "sag of code_aster SSNL100");
	hawser_line_statics_clear(&st);
}

CASE(reference_line_closed)
{
	capstan();
	heavy();
	running();
	pulley();
	return done_testing();
}
