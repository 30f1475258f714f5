/* Cables that part and winches, in motions of nets: the front in a rope that parts, of which
 * closed forms are known; a load on a winch, against its equation of motion; and the balance of
 * energy through both, also on a floor. SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include <hawser/net_motion.h>

#include "tests/net-text.h"
#include "tests/tap.h"

static int moved(struct hawser_net_motion *m, const struct hawser_net *net, double until, double every,
                 double step, struct hawser_net_probe probe)
{
	const struct hawser_net_motion_options options = {
		.until = until, .every = every, .step = step, .probe = &probe, .probes = 1};
	struct hawser_report report = {0};
	enum hawser_status status = hawser_net_integrate(m, net, &options, &report);

	return ok(!status && m->closure < 1e-11, "the motion, its energy closed to %.1e: %s",
	          status ? NAN : m->closure, report.message);
}

/* The whole rope is under T; behind the front, which goes at c = sqrt(EA/m), it is slack and has
 * the velocity T/(m c). Parts at a node in its middle too: two fronts. */
static void rope(double part, const char *axial, int elements)
{
	const double EA = 5e6, m = 9.6, T = 5e4, c = sqrt(EA/m), v = T/(m*c);
	char text[600];
	struct hawser_net net;
	struct hawser_net_motion motion = {0};
	double at = part < 1.0 ? part - 1e-3 : 1.0;

	snprintf(text, sizeof text, "kind: net\ng: 0\nnodes: {A: [0,0,0], B: [101,0,0]}\n"
	         "cables: [{name: c, from: A, to: B, EA: 5e6, rho: 9.6, length0: 100, elements: %d}]\n"
	         "supports: {A: fixed, B: fixed}\ndamping: {axial: %s}\n"
	         "failures: [{cable: c, at: %g, time: 10 ms}]\n", elements, axial, part);
	if (net_opened(&net, text, NULL) &&
	    moved(&motion, &net, 0.07, 0.01, 0.0, (struct hawser_net_probe){-1, 0, at})) {
		double (*x)[3] = motion.x, fast = (x[5][0] - x[7][0])/0.02;

		if (*axial == '0')
			ok(fast > 1.3*v && fast < 1.35*v, "without damping %d elements go too fast: %.4g m/s, not "
			   "%.4g", elements, fast, v);
		else
			close_to(fast, v, part < 1.0 ? 2e-2 : 2e-4, "W13: velocity of the end, m/s");
		close_to(motion.failure[0].time, 0.01, 1e-12, "when it parted, s");
		close_to(motion.failure[0].tension, T, 1e-10, "under what, N");
		close_to(motion.x[1][0], 101.0*at, 1e-6, "at rest until then, m");
	}
	hawser_net_motion_clear(&motion);
	hawser_net_clear(&net);
}

/* A load M on a line without mass: M v' = EA (d/L - 1) - M g, d its depth; the winch takes in with
 * the speed V (q - sin(2 pi q)/(2 pi)), q = t/rise up to 1. By Runge and Kutta's rule. */
struct load {
	double M, EA, L, V, rise;
};

static double length_of(const struct load *of, double t)
{
	double q = fmin(t/of->rise, 1.0), r = of->rise;

	return of->L - of->V*(r*(0.5*q*q + (cos(2.0*M_PI*q) - 1.0)/(4.0*M_PI*M_PI)) + fmax(t - r, 0.0));
}

static void rates(double f[2], const struct load *of, double t, const double y[2])
{
	f[0] = y[1];
	f[1] = 9.81 - of->EA*fmax(y[0]/length_of(of, t) - 1.0, 0.0)/of->M;
}

static void advance(double y[2], const struct load *of, double t, double h)
{
	double f[4][2], at[2];

	rates(f[0], of, t, y);
	for (int i = 1; i < 4; i++) {
		for (int k = 0; k < 2; k++)
			at[k] = y[k] + (i < 3 ? 0.5*h : h)*f[i - 1][k];
		rates(f[i], of, t + (i < 3 ? 0.5*h : h), at);
	}
	for (int k = 0; k < 2; k++)
		y[k] += h/6.0*(f[0][k] + 2.0*f[1][k] + 2.0*f[2][k] + f[3][k]);
}

#define LIFT "kind: net\nnodes: {W: [0,0,0], J: {}}\ncables: [{name: c, from: W, to: J, " \
	"EA: 2e6, rho: 0, length0: 60, elements: 1}]\nsupports: {W: fixed}\nmasses: {J: 1743.75 kg}\n"

/* Largest differences of depth and tension. */
static void compare(double worst[2], const struct hawser_net_motion *motion, int row, double depth,
                    double T)
{
	worst[0] = fmax(worst[0], fabs(motion->x[row][1] + depth));
	worst[1] = fmax(worst[1], fabs(motion->T[row] - T));
}

/* Depth and tension over time, and the work: of the tension, T (1 + strain/2), on what is taken
 * in. */
static void winch(void)
{
	const struct load of = {1743.75, 2e6, 60.0, 1.0, 2.0};
	struct hawser_net net;
	struct hawser_net_motion motion = {0};
	double y[2] = {60.0*(1.0 + 1743.75*9.81/2e6), 0.0}, worst[2] = {0.0}, work = 0.0;
	const int rows = 120, fine = 40;

	if (net_opened(&net, LIFT "winches: {c: {end: W, speed: -1 m/s, rise: 2 s}}\n", NULL) &&
	    moved(&motion, &net, 3.0, 3.0/rows, 2.5e-4, (struct hawser_net_probe){1, -1, 0.0})) {
		for (int i = 1; i <= rows; i++) {
			for (int j = 0; j < fine; j++) {
				double t = ((i - 1)*fine + j)*3.0/(rows*fine), h = 3.0/(rows*fine), e[2];

				e[0] = y[0]/length_of(&of, t) - 1.0;
				advance(y, &of, t, h);
				e[1] = y[0]/length_of(&of, t + h) - 1.0;
				work += 0.5*of.EA*(e[0]*(1.0 + 0.5*e[0]) + e[1]*(1.0 + 0.5*e[1]))*
				        (length_of(&of, t) - length_of(&of, t + h));
			}
			compare(worst, &motion, i, y[0], of.EA*(y[0]/length_of(&of, i*3.0/rows) - 1.0));
		}
		ok(worst[0] < 1e-6 && worst[1] < 1.0, "depth by %.1e m, tension by %.1e N", worst[0], worst[1]);
		close_to(motion.work[rows], work, 1e-5, "work of the winch, J");
		close_to(motion.winch[0].length0, length_of(&of, 3.0), 1e-12, "its length at the end, m");
	}
	hawser_net_motion_clear(&motion);
	hawser_net_clear(&net);
}

/* The line parts under 19 kN; the load flies on. */
static void parts(void)
{
	const struct load of = {1743.75, 2e6, 60.0, 1.0, 2.0};
	struct hawser_net net;
	struct hawser_net_motion motion = {0};
	double y[2] = {60.0*(1.0 + 1743.75*9.81/2e6), 0.0}, t = 0.0, last = 0.0, T = 0.0, h = 1e-4;

	if (net_opened(&net, LIFT "winches: {c: {end: W, speed: -1 m/s, rise: 2 s}}\n"
	                     "failures: [{cable: c, at: J, tension: 19 kN}]\n", NULL) &&
	    moved(&motion, &net, 2.0, 0.1, 5e-4, (struct hawser_net_probe){1, -1, 0.0})) {
		for (; T < 19e3 && t < 2.0; t += h) {
			advance(y, &of, t, h);
			last = T;
			T = of.EA*(y[0]/length_of(&of, t + h) - 1.0);
		}
		t -= h*(T - 19e3)/(T - last);
		y[0] -= y[1]*h*(T - 19e3)/(T - last);
		close_to(motion.failure[0].time, t, 1e-5, "when it parts, s");
		close_to(motion.failure[0].tension, 19e3, 1e-8, "under what, N");
		t = 2.0 - t;
		close_to(motion.x[20][1], -(y[0] + y[1]*t + 0.5*9.81*t*t), 1e-5, "place of the load then, m");
		ok(motion.T[20] == 0.0, "nothing holds it");
	}
	hawser_net_motion_clear(&motion);
	hawser_net_clear(&net);
}

/* A winch that holds a tension while the load is pulled; and a cable on a rough floor that parts:
 * the balance of energy is closed. */
static void balances(void)
{
	static const char *const text[] = {
		LIFT "winches: {c: {end: W, tension: 18.5 kN, limit: 0.4 m/s}}\n",
		"kind: net\nnodes: {A: [0,0,0], B: [70,20,0]}\ncables: [{name: c, from: A, to: B, "
		"EA: 2e6, rho: 6, length0: 80, elements: 32}]\nsupports: {A: fixed, B: "
		"fixed}\nobstacles: [{plane: {point: [0,0], "
		"normal: [0,1]}, friction: 0.4}]\ndamping: {axial: 2 ms}\nfailures: [{cable: c, at: 70 "
		"%, time: "
		"0.2}, {cable: c, at: A, time: 0.3}]\n"};
	struct hawser_net net;
	struct hawser_net_motion motion = {0};

	if (net_opened(&net, text[0], NULL) &&
	    moved(&motion, &net, 20.0, 1.0, 5e-3, (struct hawser_net_probe){1, -1, 0.0}))
		close_to(motion.T[20], 1743.75*9.81, 3e-2, "tension by its band: the load goes up, N");
	ok(motion.x[20][1] > -60.0 && motion.work[20] > 0.0, "%.3f m", motion.x[20][1]);
	hawser_net_motion_clear(&motion);
	hawser_net_clear(&net);
	if (net_opened(&net, text[1], NULL) &&
	    moved(&motion, &net, 1.2, 0.1, 0.0, (struct hawser_net_probe){-1, 0, 0.1}))
		ok(motion.friction[12] > 0.0 && motion.failure[1].time == 0.3, "friction takes %.3g J",
		   motion.friction[12]);
	hawser_net_motion_clear(&motion);
	hawser_net_clear(&net);
}

/* A cable that is drawn over a rough bed, which gives way, parts there: both ends stay on the bed, and
 * share the friction. */
static void on_bed(void)
{
	static const char text[] =
		"kind: net\nnodes: {P: [-30, 0, 0], Q: [30, 0.5, 3]}\nsupports: {P: fixed, Q: {motion: "
		"{z: {amplitude: -3, Omega: 1.2}}}}\nobstacles: [{plane: {point: [0, 0], normal: [0, 1]}, "
		"stiffness: 3e6, damping: 3e5, friction: 0.5}]\ncables: [{name: c1, from: P, to: Q, EA: 5e6, "
		"rho: 20, diameter: 0.04, length0: 60.1, elements: 10}]\ndamping: {axial: 0.02, alpha: 5}\n"
		"failures: [{cable: c1, at: 50 %, time: 2.3}]\n";
	struct hawser_net net;
	struct hawser_net_motion motion = {0};

	if (net_opened(&net, text, NULL) &&
	    moved(&motion, &net, 4.0, 1.0, 0.01, (struct hawser_net_probe){-1, 0, 0.5}))
		ok(motion.touching[2] == 8 && motion.touching[4] == 10 && motion.friction[4] > 1e4,
		   "%d, then %d nodes touch", motion.touching[2], motion.touching[4]);
	hawser_net_motion_clear(&motion);
	hawser_net_clear(&net);
}

/* A sinker in water: on two lines of which one parts, and on a winch; numbers of two other programs. */
#define SINKER "masses: {J: 2000 kg}\nbuoys: {J: {volume: 0.25 m^3, CdA: 0.8 m^2, added_mass: 0.5}}\n" \
	"water: {density: 1025 kg/m^3, surface: 100 m}\n"
static void sinker(void)
{
	static const char *const text[] = {
		"kind: net\nnodes: {A: [-30,0,0], B: [30,0,0], J: {}}\ncables: [{name: a, from: A, to: J, "
		"EA: 2e6, rho: 0, length0: 50, elements: 1, diameter: 0}, {name: b, from: B, to: J, EA: 2e6, "
		"rho: 0, length0: 50, elements: 1, diameter: 0}]\nsupports: {A: fixed, B: fixed}\n" SINKER
		"failures: [{cable: b, at: J, time: 0}]\n",
		"kind: net\nnodes: {W: [0,0,0], J: {}}\ncables: [{name: c, from: W, to: J, EA: 2e6, rho: 0, "
		"length0: 60, elements: 1, diameter: 0}]\nsupports: {W: fixed}\n" SINKER
		"winches: {c: {end: W, speed: -1 m/s, rise: 2 s}}\n"};
	struct hawser_net net;
	struct hawser_net_motion motion = {0};
	const int rows = 2000;

	for (int i = 0; i < 2; i++) {
		double most = 0.0, at = 0.0, least = 0.0, until = 20.0;

		if (net_opened(&net, text[i], NULL) && moved(&motion, &net, until, until/rows, 2.5e-3,
		                                   (struct hawser_net_probe){i ? 1 : 2, -1, 0.0})) {
			for (int j = 0; j <= rows; j++) {
				at = motion.T[j] > most ? motion.time[j] : at;
				most = fmax(most, motion.T[j]);
				least = fmin(least, motion.x[j][0]);
			}
			close_to(most, i ? 20748.2 : 17536.9, 5e-5, i ? "W14: largest tension, N"
			                                                : "W13: largest tension, N");
			close_to(at, i ? 1.29 : 6.55, 3e-3, "when, s");
			if (i)
				close_to(motion.x[rows][1], -41.36, 2e-6, "W14: depth after 20 s, m");
			else
				close_to(least, -32.5919, 1e-5, "W13: furthest way, m");
			if (!i)
				close_to(motion.T[0], 10659.7, 1e-5, "tension before, N");
		}
		hawser_net_motion_clear(&motion);
		hawser_net_clear(&net);
	}
}

CASE(reference_net_events)
{
	sinker();
	rope(1.0, "2 ms", 50);
	rope(0.5, "4 ms", 50);
	rope(1.0, "0", 100);
	rope(1.0, "0", 400);
	winch();
	parts();
	balances();
	on_bed();
	return done_testing();
}
