/* Modes of rigid bodies and their response to waves: closed forms of a spar and of a tower on a
 * hinge, the determinant of K - omega^2 M with the stiffness of statics, and a motion in regular waves.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include <hawser/net_modes.h>
#include <hawser/net_motion.h>
#include <hawser/net_waves.h>

#include "tests/net-text.h"
#include "tests/tap.h"

enum { TEXT = 2000 };

/* A spar of mass m with its centre at `low`, free: heave, and pitch with the surge of it. */
static void spar(double D, double m, double low, double J)
{
	const double a = 1025.0*M_PI*D*D/4.0, h = m/a, up = low - 0.5*h;
	const double about = J + a*h*h*h/12.0 + a*h*up*up;
	char text[TEXT];
	struct hawser_net net = {0};
	struct hawser_net_modes modes = {0};
	struct hawser_report report = {0};

	snprintf(text, sizeof text, "kind: net\ng: 9.81\nwater: {density: 1025}\n"
	         "nodes: {a: [0, 8, 0], b: [0, %.17g, 0]}\n"
	         "bodies: {S: {nodes: [a, b], mass: %.17g, centre: [0, %.17g, 0], "
	         "inertia: [%.17g, %.17g, %.17g], rods: [{from: a, to: b, diameter: %.17g, "
	         "added_mass: {normal: 1}, elements: 200}]}}\n", -h, m, -low, J, 0.3*J, J, D);
	if (net_opened(&net, text, NULL) &&
	    ok(!hawser_net_modes_solve(&modes, &net, 6, &report), "a spar: %s", report.message)) {
		const double heave = sqrt(a*9.81/m), pitch = sqrt(m*9.81*up/(about - a*h*up*up*a*h/(m + a*h)));
		int at = fabs(modes.omega[5] - heave) < fabs(modes.omega[3] - heave) ? 5 : 3;

		ok(modes.omega[0] + modes.omega[1] + modes.omega[2] == 0.0, "surge, sway and yaw are free");
		close_to(modes.omega[at], heave, 1e-9, "heave, rad/s");
		close_to(modes.omega[at == 5 ? 3 : 5], pitch, 1e-4, "pitch, rad/s");
		close_to(modes.omega[4], pitch, 1e-4, "roll, rad/s");
	}
	hawser_net_modes_clear(&modes);
	hawser_net_clear(&net);
}

/* --- a lamp on three lines: the roots of det(K - omega^2 M) --- */

static double determinant(double A[6][6])
{
	double det = 1.0;

	for (int c = 0; c < 6; c++) {
		int best = c;

		for (int r = c; r < 6; r++)
			best = fabs(A[r][c]) > fabs(A[best][c]) ? r : best;
		for (int k = 0; k < 6 && best != c; k++) {
			double swap = A[c][k];

			A[c][k] = A[best][k];
			A[best][k] = swap;
		}
		det *= best == c ? A[c][c] : -A[c][c];
		for (int r = c + 1; r < 6; r++) {
			double part = A[r][c]/A[c][c];

			for (int k = c; k < 6; k++)
				A[r][k] -= part*A[c][k];
		}
	}
	return det;
}

/* Of the body about a place. */
static void mass(double M[6][6], const struct hawser_net_body *body, const double about[3])
{
	double d[3], S[3][3] = {{0.0}};

	for (int k = 0; k < 3; k++)
		d[k] = body->centre[k] - about[k];
	for (int k = 0; k < 3; k++) {
		S[k][(k + 1) % 3] = -d[(k + 2) % 3];
		S[k][(k + 2) % 3] = d[(k + 1) % 3];
	}
	memset(M, 0, 36*sizeof(double));
	for (int i = 0; i < 3; i++)
		for (int j = 0; j < 3; j++) {
			M[i][j] = i == j ? body->mass : 0.0;
			M[i][3 + j] = -body->mass*S[i][j];
			M[3 + i][j] = body->mass*S[i][j];
			for (int k = 0; k < 3; k++)
				M[3 + i][3 + j] += body->inertia[k]*body->axes[k][i]*body->axes[k][j] -
				                   body->mass*S[i][k]*S[k][j];
		}
}

static double of_omega(double K[6][6], double M[6][6], double omega)
{
	double A[6][6];

	for (int k = 0; k < 36; k++)
		A[k/6][k % 6] = K[k/6][k % 6] - omega*omega*M[k/6][k % 6];
	return determinant(A);
}

static void lamp(void)
{
	static const char text[] = "kind: net\ng: 9.81\n"
		"nodes: {P: [5, 10, 0], Q: [-3, 10, 4], R: [-2, 10, -5], a: [1, 0, 0], "
		" b: [-0.6, 0.2, 0.7], c: [-0.5, -0.1, -0.9]}\n"
		"supports: {P: fixed, Q: fixed, R: fixed}\ncables:\n"
		"- {name: p, from: P, to: a, length0: 10.8, EA: 1e6, rho: 0, elements: 1}\n"
		"- {name: q, from: Q, to: b, length0: 10.5, EA: 3e5, rho: 0, elements: 1}\n"
		"- {name: r, from: R, to: c, length0: 11.2, EA: 2e6, rho: 0, elements: 1}\n"
		"bodies: {B: {nodes: [a, b, c], mass: 800, centre: [0.1, -0.5, 0.05], "
		"inertia: [300, 250, 400]}}\n";
	struct hawser_net net = {0};
	struct hawser_net_modes modes = {0};
	struct hawser_net_statics st = {0};
	struct hawser_net_stiffness K = {0};
	struct hawser_report report = {0};
	double M[6][6];
	const int node = 3;

	if (net_opened(&net, text, NULL) &&
	    ok(!hawser_net_solve(&st, &net, NULL, &report), "at rest: %s", report.message) &&
	    ok(!hawser_net_stiffness_of(&K, &net, &node, 1, NULL, &report), "stiffness: %s",
	       report.message) &&
	    ok(!hawser_net_modes_solve(&modes, &net, 6, &report), "modes: %s", report.message)) {
		mass(M, &st.body[0], K.about);
		for (int j = 0; j < 6; j++) {
			double below = of_omega(K.K, M, modes.omega[j]*(1.0 - 1e-6));
			double above = of_omega(K.K, M, modes.omega[j]*(1.0 + 1e-6));

			ok(below*above < 0.0, "mode %d, %.6f rad/s, is a root of the determinant", j + 1,
			   modes.omega[j]);
		}
	}
	hawser_net_modes_clear(&modes);
	hawser_net_statics_clear(&st);
	hawser_net_clear(&net);
}

/* --- a tower on a hinge at the bed, or ballasted on springs of the bed: I a'' + K a = moment of the
 * waves --- */

static void tower(double h, double L, double D, double m, double T, int stands)
{
	const double a = 1025.0*M_PI*D*D/4.0, omega = 2.0*M_PI/T;
	const double k = hawser_wave_number(omega, h, 9.81);
	const double arm = L*sinh(k*L)/k - (cosh(k*L) - 1.0)/(k*k);
	const double moment = 2.0*a*omega*omega/sinh(k*h)*arm;
	const double base = 0.11, spring = stands ? 2.0*1e9*base*base : 0.0;
	const double stiff = 0.5*(a - m)*9.81*L*L + spring - omega*omega*(m + a)*L*L*L/3.0;
	const struct hawser_net_probe probe = {1, -1, 0.0};
	const struct hawser_net_waves_options options = {
		.from = omega, .to = omega, .points = 1, .probe = &probe, .probes = 1};
	char text[TEXT];
	struct hawser_net net = {0};
	struct hawser_net_waves waves = {0};
	struct hawser_report report = {0};

	snprintf(text, sizeof text, "kind: net\ng: 9.81\nnodes: {A: [0, %.17g, 0], B: [0, %.17g, 0]}\n"
	         "supports: {A: fixed}\n"
	         "water: {density: 1025, depth: %.17g, waves: {height: 1, period: %.17g}}\n"
	         "bodies: {R: {nodes: [A, B], rods: [{from: A, to: B, rho: %.17g, diameter: %.17g, "
	         "added_mass: {normal: 1}, elements: 100}]}}\n", -h, L - h, h, T, m, D);
	if (stands)
		snprintf(text, sizeof text, "kind: net\ng: 9.81\nnodes: {A: [0, %g, 0], B: [0, %.17g, 0], "
		         "c: [%g, %g, 0], d: [%g, %g, 0], e: [0, %g, 1], f: [0, %g, -1]}\n"
		         "obstacles: [{plane: {point: [0, %g], normal: [0, 1]}, stiffness: 1e9, "
		         "friction: 0.5}]\n"
		         "water: {density: 1025, depth: %.17g, waves: {height: 1, period: %.17g}}\n"
		         "bodies: {R: {nodes: [A, B, c, d, e, f], bearing: 1, mass: 5e5, centre: [0, %g, 0], "
		         "rods: [{from: A, to: B, rho: %.17g, diameter: %.17g, "
		         "added_mass: {normal: 1}, elements: 100}]}}\n", -h, L - h, base, -h, -base, -h, -h, -h,
		         -h, h, T, -h, m, D);
	if (net_opened(&net, text, NULL) && ok(!hawser_net_waves_solve(&waves, &net, &options, &report),
	                             "a tower in waves: %s", report.message)) {
		close_to(waves.x[0], L*fabs(moment/stiff), 2e-4, "its top, m/m");
		ok(waves.x[1] < (stands ? 1e-5 : 1e-12) && waves.x[2] < 1e-12, "along the waves: %.1e, %.1e",
		   waves.x[1], waves.x[2]);
	}
	hawser_net_waves_clear(&waves);
	hawser_net_clear(&net);
}

/* --- a float on two lines, in small waves: the linear response against a motion --- */

static void floats(double T)
{
	char text[TEXT];
	const double omega = 2.0*M_PI/T;
	const struct hawser_net_probe probe[2] = {{1, -1, 0.0}, {2, -1, 0.0}};
	const struct hawser_net_waves_options asked = {
		.from = omega, .to = omega, .points = 1, .probe = probe, .probes = 2};
	const struct hawser_net_motion_options options = {
		.until = 30.0*T, .every = T/20.0, .step = T/40.0, .probe = probe, .probes = 2};
	struct hawser_net net = {0};
	struct hawser_net_waves waves = {0};
	struct hawser_net_motion m = {0};
	struct hawser_report report = {0};

	snprintf(text, sizeof text, "kind: net\ng: 9.81\ndamping: {alpha: 300}\n"
	         "water: {density: 1025, depth: 30, waves: {height: 0.02, period: %g}, "
	         "stretching: none}\n"
	         "nodes: {P: [-9, -30, 0], a: [0, -9, 0], b: [0, -5, 0.4], Q: [12, -30, 3]}\n"
	         "supports: {P: fixed, Q: fixed}\ncables:\n"
	         "- {name: p, from: P, to: a, length0: 22, EA: 2e6, rho: 9, diameter: 0.05, "
	         "added_mass: {normal: 1}, elements: 4}\n"
	         "- {name: q, from: Q, to: a, length0: 23, EA: 2e6, rho: 9, diameter: 0.05, elements: 4}\n"
	         "buoys: {b: {volume: 3, CdA: 0, added_mass: 0.5}}\n"
	         "bodies: {R: {nodes: [a, b], mass: 1200, centre: [0, -7, 0.2], "
	         "inertia: [900, 900, 900], rods: [{from: a, to: b, diameter: 0.3, "
	         "added_mass: {normal: 1}, elements: 10}]}}\n", T);
	if (net_opened(&net, text, NULL) &&
	    ok(!hawser_net_waves_solve(&waves, &net, &asked, &report), "a float: %s", report.message) &&
	    ok(!hawser_net_integrate(&m, &net, &options, &report), "it moves: %s", report.message))
		for (int p = 0; p < 2; p++)
			for (int k = 0; k < 2; k++) {
				double c = 0.0, s = 0.0;

				for (int i = m.rows - 60; i < m.rows; i++) {
					c += m.x[i*2 + p][k]*cos(omega*m.time[i])/30.0;
					s += m.x[i*2 + p][k]*sin(omega*m.time[i])/30.0;
				}
				ok(fabs(hypot(c, s)/0.01 - waves.x[3*p + k]) < 0.01*waves.x[3*p],
				   "node %d, axis %d: %.4f, the motion %.4f m/m", p, k,
				   waves.x[3*p + k], hypot(c, s)/0.01);
			}
	hawser_net_motion_clear(&m);
	hawser_net_waves_clear(&waves);
	hawser_net_clear(&net);
}

CASE(reference_net_body_waves)
{
	spar(3.1, 2.1e5, 21.7, 1.9e7);
	lamp();
	tower(60.0, 45.0, 1.7, 700.0, 8.3, 0);
	tower(60.0, 45.0, 1.7, 700.0, 8.3, 1);
	floats(5.3);
	return done_testing();
}
