/* response/time/surge_lone.c - linear response of uncoupled modes to a change of the travel speed.
 *
 * During the ramp and after its end, forces are polynomials of time or sines, so that the response of a
 * mode with constant stiffness and damping is known in closed form: a forced motion, and a free one
 * with the roots of r^2 + D r + K = 0.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <complex.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "response/time/surge_parts.h"

static double stiffness(const struct hawser__lone_modes *lone, int s)
{
	return lone->rom->K[(size_t)s*((size_t)lone->rom->n + 1)];
}

static double damping(const struct hawser__lone_modes *lone, int s)
{
	return lone->rom->D[(size_t)s*((size_t)lone->rom->n + 1)];
}

/* Coefficients [3] of the force of the ramp on mode s, a polynomial of time. */
static void ramp_force(double c[3], const struct hawser__lone_modes *lone, int s)
{
	const struct hawser_ramp *ramp = lone->rom->ramp;
	double f[HAWSER_RAMP_TERMS];

	memset(c, 0, 3*sizeof *c);
	if (!ramp)
		return;
	for (int i = 0; i < HAWSER_RAMP_TERMS; i++)
		f[i] = ramp->term[i].f ? ramp->term[i].f[s] : 0.0;
	if (lone->over) {
		c[0] = f[HAWSER_RAMP_LINEAR] + f[HAWSER_RAMP_SQUARE];
		return;
	}
	c[0] = f[HAWSER_RAMP_RATE]/ramp->time;
	c[1] = f[HAWSER_RAMP_LINEAR]/ramp->time;
	c[2] = f[HAWSER_RAMP_SQUARE]/(ramp->time*ramp->time);
}

/* Forced motion of mode s at time t: value and rate; and the static response to the force. */
static void forced(double motion[2], double *held, const struct hawser__lone_modes *lone, int s,
                   double t, double omega)
{
	double k = stiffness(lone, s), d = damping(lone, s), c[3], p[3];

	ramp_force(c, lone, s);
	p[2] = c[2]/k;
	p[1] = (c[1] - 2.0*d*p[2])/k;
	p[0] = (c[0] - d*p[1] - 2.0*p[2])/k;
	motion[0] = p[0] + t*(p[1] + t*p[2]);
	motion[1] = p[1] + 2.0*t*p[2];
	*held = (c[0] + t*(c[1] + t*c[2]))/k;
	for (int h = 0; h < lone->rom->harmonics; h++) {
		const struct hawser_harmonic *harmonic = &lone->rom->harmonic[h];
		double w = harmonic->k*omega;
		double complex force, answer;

		if (!harmonic->f)
			continue;
		force = harmonic->f[s]*pow(omega, harmonic->omega_power)*cexp(I*w*t)*
		        (harmonic->phase == HAWSER_SIN ? -I : 1.0);
		answer = force/(k - w*w + I*w*d);
		motion[0] += creal(answer);
		motion[1] += creal(I*w*answer);
		*held += creal(force)/k;
	}
}

static void free_motion(double motion[2], const struct hawser__lone_modes *lone, int s, double t)
{
	double complex value = 0.0, rate = 0.0;

	for (int i = 0; i < 2; i++) {
		double complex root = lone->root[2*s + i];
		double complex term = lone->swing[2*s + i]*cexp(root*(t - lone->begin));

		value += term;
		rate += root*term;
	}
	motion[0] = creal(value);
	motion[1] = creal(rate);
}

/* Start the free motion from the state of mode s at time t. */
static void begin_mode(struct hawser__lone_modes *lone, int s, const double state[2], double t,
                       double omega)
{
	double complex *root = lone->root + 2*(size_t)s, *swing = lone->swing + 2*(size_t)s;
	double motion[2], held, y, v;

	forced(motion, &held, lone, s, t, omega);
	y = state[0] - motion[0];
	v = state[1] - motion[1];
	swing[0] = (v - root[1]*y)/(root[0] - root[1]);
	swing[1] = y - swing[0];
}

int hawser__lone_modes_make(struct hawser__lone_modes *lone, const struct hawser_rom *rom, int first,
                            double omega)
{
	const double rest[2] = {0.0, 0.0};
	size_t n = (size_t)rom->n;

	*lone = (struct hawser__lone_modes){.rom = rom, .first = first};
	lone->y = calloc(n, sizeof *lone->y);
	lone->held = calloc(n, sizeof *lone->held);
	lone->root = calloc(2*n, sizeof *lone->root);
	lone->swing = calloc(2*n, sizeof *lone->swing);
	if (!lone->y || !lone->held || !lone->root || !lone->swing)
		return 0;
	for (int s = first; s < rom->n; s++) {
		double half = 0.5*damping(lone, s), k = stiffness(lone, s);
		double complex root = csqrt(half*half - k);

		/* critical damping: the roots coincide; a small difference is harmless */
		if (cabs(root) < 1e-6*sqrt(k))
			root = 1e-6*sqrt(k);
		lone->root[2*s] = -half + root;
		lone->root[2*s + 1] = -half - root;
		begin_mode(lone, s, rest, 0.0, omega);
	}
	return 1;
}

void hawser__lone_modes_clear(struct hawser__lone_modes *lone)
{
	free(lone->y);
	free(lone->held);
	free(lone->root);
	free(lone->swing);
	*lone = (struct hawser__lone_modes){.first = 0};
}

/* At the end of the ramp the force has a different form. */
static void pass_end(struct hawser__lone_modes *lone, double omega)
{
	double end = lone->rom->ramp->time;

	for (int s = lone->first; s < lone->rom->n; s++) {
		double state[2], motion[2], held;

		lone->over = 0;
		forced(motion, &held, lone, s, end, omega);
		free_motion(state, lone, s, end);
		state[0] += motion[0];
		state[1] += motion[1];
		lone->over = 1;
		/* the free motion of each mode begins anew; the common start time is set after all */
		begin_mode(lone, s, state, end, omega);
	}
	lone->over = 1;
	lone->begin = end;
}

void hawser__lone_modes_at(struct hawser__lone_modes *lone, double t, double omega)
{
	if (lone->rom->ramp && !lone->over && t >= lone->rom->ramp->time)
		pass_end(lone, omega);
	for (int s = 0; s < lone->rom->n; s++) {
		double motion[2], more[2];

		forced(motion, &lone->held[s], lone, s, t, omega);
		if (s < lone->first)
			continue;
		free_motion(more, lone, s, t);
		lone->y[s] = motion[0] + more[0];
	}
}
