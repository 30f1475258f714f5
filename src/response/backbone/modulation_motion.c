/* response/backbone/modulation_motion.c - the modulation equations at given amplitudes, and the
 * motion that they represent. SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "response/backbone/modulation.h"

double complex hawser__load(double complex *by_omega, const struct hawser_rom *rom, int s, int k,
                           double omega)
{
	double complex sum = 0.0;

	*by_omega = 0.0;
	for (int i = 0; i < rom->harmonics; i++) {
		const struct hawser_harmonic *harmonic = &rom->harmonic[i];
		double complex half = harmonic->phase == HAWSER_COS ? 0.5 : -0.5*I;

		if (!harmonic->f || harmonic->k != k)
			continue;
		sum += half*harmonic->f[s]*pow(omega, harmonic->omega_power);
		if (harmonic->omega_power)
			*by_omega += half*harmonic->f[s]*harmonic->omega_power
			             *pow(omega, harmonic->omega_power - 1);
	}
	return sum;
}

static double complex amplitude(const struct hawser_modulation *m, const double *x, int variable)
{
	int R = m->resonance.count;

	if (variable < 0)
		return 1.0;
	return variable < R ? x[variable] + I*x[R + variable]
	                    : x[variable - R] - I*x[variable];
}

/* Add the derivative g of equation r with respect to a variable: by real and imaginary part of its
 * amplitude. */
static void differentiate(double *by_x, int R, int r, int variable, double complex g)
{
	int s = variable%R;
	double complex by_im = variable < R ? I*g : -I*g;

	by_x[r*2*R + s] += creal(g);
	by_x[(R + r)*2*R + s] += cimag(g);
	by_x[r*2*R + R + s] += creal(by_im);
	by_x[(R + r)*2*R + R + s] += cimag(by_im);
}

static void nonlinear(const struct hawser_modulation *m, double complex *G, double *by_x,
                      const double *x)
{
	int R = m->resonance.count;

	for (int i = 0; i < m->monomials; i++) {
		const struct hawser_monomial *e = &m->monomial[i];
		double complex z[3], value = e->re + I*e->im;

		for (int f = 0; f < 3; f++)
			z[f] = amplitude(m, x, e->factor[f]);
		G[e->equation] += value*z[0]*z[1]*z[2];
		for (int f = 0; by_x && f < 3; f++)
			if (e->factor[f] >= 0)
				differentiate(by_x, R, e->equation, e->factor[f],
				              value*z[(f + 1)%3]*z[(f + 2)%3]);
	}
}

void hawser_modulation_equations(const struct hawser_modulation *m, double *G, double *by_x,
                                 double *by_omega, const double *x, double omega)
{
	const struct hawser_rom *rom = m->rom;
	int R = m->resonance.count;
	double complex sum[HAWSER_RESONANT_MOST] = {0.0};

	if (by_x)
		memset(by_x, 0, 4*(size_t)R*(size_t)R*sizeof *by_x);
	nonlinear(m, sum, by_x, x);
	for (int r = 0; r < R; r++) {
		int j = m->resonance.mode[r], p = m->resonance.order[r];
		double complex by_load, detuned = hawser__stiffness(rom, j) - p*p*omega*omega, slope;

		sum[r] += detuned*amplitude(m, x, r) - hawser__load(&by_load, rom, j, p, omega);
		slope = -2.0*p*p*omega*amplitude(m, x, r) - by_load;
		if (by_x)
			differentiate(by_x, R, r, r, detuned);
		for (int s = 0; s < R; s++) {
			double complex d = I*p*rom->D[j*rom->n + m->resonance.mode[s]];

			if (m->resonance.order[s] != p || d == 0.0)
				continue;
			sum[r] += d*omega*amplitude(m, x, s);
			slope += d*amplitude(m, x, s);
			if (by_x)
				differentiate(by_x, R, r, s, d*omega);
		}
		G[r] = creal(sum[r]);
		G[R + r] = cimag(sum[r]);
		if (by_omega) {
			by_omega[r] = creal(slope);
			by_omega[R + r] = cimag(slope);
		}
	}
}

/* The factor of an amplitude, or of a response. */
static double complex product(const struct hawser_modulation *m, const double *x,
                              const int factor[2])
{
	return amplitude(m, x, factor[0])*amplitude(m, x, factor[1]);
}

/* u [n] += the real part of wave*c; if v is not NULL, also its rate. */
static void add_part(double *u, double *v, double complex wave, double *c, double rate, int n)
{
	for (int s = 0; s < n; s++) {
		double complex part = wave*hawser__complex(c)[s];

		u[s] += creal(part);
		if (v)
			v[s] -= rate*cimag(part);
	}
}

static void motion(const struct hawser_modulation *m, double *u, double *v, const double *x,
                   double tau,
                   double omega)
{
	int n = m->rom->n;

	memset(u, 0, (size_t)n*sizeof *u);
	if (v)
		memset(v, 0, (size_t)n*sizeof *v);
	for (int i = 0; i < m->carriers; i++)
		add_part(u, v, amplitude(m, x, m->carrier[i].variable)*cexp(I*(m->carrier[i].h*tau)),
		         m->carrier[i].c, m->carrier[i].h*omega, n);
	for (int i = 0; i < m->answers; i++)
		add_part(u, v, product(m, x, m->answer[i].factor)*cexp(I*(m->answer[i].h*tau)),
		         m->answer[i].c, m->answer[i].h*omega, n);
}

void hawser_modulation_state(const struct hawser_modulation *m, double *state, const double *x,
                             double omega)
{
	motion(m, state, state + m->rom->n, x, 0.0, omega);
}

void hawser_modulation_motion(const struct hawser_modulation *m, double *u, const double *x,
                              double tau)
{
	motion(m, u, NULL, x, tau, 0.0);
}
