/* rom/choose/cycle.c - collocation with trigonometric polynomials at M = 2*order + 1 equidistant
 * phases.
 *
 *    U       [M][n] coordinates at the phases tau_i = 2 pi i/M
 *    D1      [M][M] derivative by tau of the interpolating trigonometric polynomial; D2 = D1 D1
 *    R       [M][n] residual Omega^2 D2 U - acceleration(U, Omega D1 U, tau, Omega)
 *
 * For smooth orbits the error falls geometrically with M. The orbit only starts a continuation that
 * corrects it, so that the order is fixed: four times the highest harmonic of the forcing, plus
 * twelve. L. N. Trefethen, Spectral Methods in MATLAB (2000), ch. 3.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/hold.h"
#include "core/report.h"
#include "rom/choose/drive.h"

static const double settled = 1e-12;   /* last Newton step relative to the size of the orbit; near
                                        * round-off */
static const double least_step = 1e-3; /* smallest step of the growing forcing; chosen */
enum { ITERATIONS = 20 };

struct collocation {
	struct hawser_rom rom; /* the model with its forcing scaled; owns only harmonic and force */
	double *force;         /* [harmonics][n] */
	double omega;
	int n, M;
	double *D1, *D2;       /* [M][M] */
	double *U, *V, *keep;  /* [M][n] */
	double *R;             /* [M][n] */
	double *J;             /* [M*n][M*n] */
	double *by_u, *by_v;   /* [n][n] */
	double *by_omega;      /* [n] */
	lapack_int *pivot;
	int starved;           /* 1: LAPACK got no workspace */
	struct hawser__hold hold; /* its arrays */
};

static void collocation_clear(struct collocation *c)
{
	free(c->rom.harmonic);
	hawser__hold_clear(&c->hold);
}

static void differentiation(struct collocation *c)
{
	int M = c->M;

	for (int i = 0; i < M; i++)
		for (int k = 0; k < M; k++)
			c->D1[i*M + k] = i == k ? 0.0
			                 : ((i - k)%2 ? -0.5 : 0.5)/sin((i - k)*M_PI/M);
	for (int i = 0; i < M; i++)
		for (int k = 0; k < M; k++) {
			double sum = 0.0;

			for (int j = 0; j < M; j++)
				sum += c->D1[i*M + j]*c->D1[j*M + k];
			c->D2[i*M + k] = sum;
		}
}

static int collocation_make(struct collocation *c, const struct hawser_rom *rom, int order,
                            double omega)
{
	size_t n = (size_t)rom->n, M = 2*(size_t)order + 1, h = (size_t)rom->harmonics;

	*c = (struct collocation){.rom = *rom, .omega = omega, .n = rom->n, .M = (int)M};
	c->rom.harmonic = malloc((h + 1)*sizeof *c->rom.harmonic);
	c->force = hawser__hold(&c->hold, h*n + 1, sizeof *c->force);
	c->D1 = hawser__hold(&c->hold, M*M, sizeof *c->D1);
	c->D2 = hawser__hold(&c->hold, M*M, sizeof *c->D2);
	c->U = hawser__hold(&c->hold, M*n, sizeof *c->U);
	c->V = hawser__hold(&c->hold, M*n, sizeof *c->V);
	c->keep = hawser__hold(&c->hold, M*n, sizeof *c->keep);
	c->R = hawser__hold(&c->hold, M*n, sizeof *c->R);
	c->J = hawser__hold(&c->hold, M*n*M*n, sizeof *c->J);
	c->by_u = hawser__hold(&c->hold, n*n, sizeof *c->by_u);
	c->by_v = hawser__hold(&c->hold, n*n, sizeof *c->by_v);
	c->by_omega = hawser__hold(&c->hold, n, sizeof *c->by_omega);
	c->pivot = hawser__hold(&c->hold, M*n, sizeof *c->pivot);
	if (!c->rom.harmonic || c->hold.short_of_memory)
		return 0;
	differentiation(c);
	return 1;
}

/* Forcing vectors times `part`; parametric terms stay. */
static void set_forcing(struct collocation *c, const struct hawser_rom *rom, double part)
{
	for (int h = 0; h < rom->harmonics; h++) {
		double *f = c->force + (size_t)h*rom->n;

		c->rom.harmonic[h] = rom->harmonic[h];
		for (int j = 0; rom->harmonic[h].f && j < rom->n; j++)
			f[j] = part*rom->harmonic[h].f[j];
		if (rom->harmonic[h].f)
			c->rom.harmonic[h].f = f;
	}
}

/* The rows of R and J of one phase; needs V. */
static void assemble_phase(struct collocation *c, int i)
{
	int n = c->n, M = c->M;
	double *r = c->R + i*n, w = c->omega;

	hawser_rom_acceleration_jacobian(&c->rom, r, c->by_u, c->by_v, c->by_omega, c->U + i*n,
	                                 c->V + i*n, 2.0*M_PI*i/M, w);
	for (int j = 0; j < n; j++) {
		double *row = c->J + (size_t)(i*n + j)*M*n, sum = 0.0;

		for (int k = 0; k < M; k++) {
			double d2 = w*w*c->D2[i*M + k], d1 = w*c->D1[i*M + k];

			sum += d2*c->U[k*n + j];
			for (int m = 0; m < n; m++)
				row[k*n + m] = -d1*c->by_v[j*n + m];
			row[k*n + j] += d2;
		}
		for (int m = 0; m < n; m++)
			row[i*n + m] -= c->by_u[j*n + m];
		r[j] = sum - r[j];
	}
}

static void assemble(struct collocation *c)
{
	int n = c->n, M = c->M;

	memset(c->V, 0, (size_t)M*n*sizeof *c->V);
	for (int i = 0; i < M; i++)
		for (int k = 0; k < M; k++)
			for (int j = 0; j < n; j++)
				c->V[i*n + j] += c->omega*c->D1[i*M + k]*c->U[k*n + j];
	for (int i = 0; i < M; i++)
		assemble_phase(c, i);
}

static double largest(const double *v, int count)
{
	double result = 0.0;

	for (int i = 0; i < count; i++)
		result = isfinite(v[i]) ? fmax(result, fabs(v[i])) : INFINITY;
	return result;
}

/* Newton's method from U; returns 1 if it converged. *residual: its last step, relative. */
static int newton(struct collocation *c, double *residual)
{
	int size = c->M*c->n, info;

	for (int i = 0; i < ITERATIONS; i++) {
		assemble(c);
		if (!isfinite(largest(c->R, size)))
			return 0;
		info = LAPACKE_dgesv(LAPACK_ROW_MAJOR, size, 1, c->J, size, c->pivot, c->R, 1);
		c->starved |= hawser__lapack_starved(info);
		if (info)
			return 0;
		for (int k = 0; k < size; k++)
			c->U[k] -= c->R[k];
		*residual = largest(c->R, size)/fmax(largest(c->U, size), 1e-300);
		if (largest(c->R, size) == 0.0 || *residual < settled)
			return 1;
	}
	return 0;
}

/* With the whole forcing at once, then in steps that are halved if Newton's method fails. */
static int grow(struct collocation *c, const struct hawser_rom *rom, double *residual)
{
	size_t bytes = (size_t)c->M*c->n*sizeof *c->U;
	double done = 0.0, step = 1.0;

	while (done < 1.0 && step >= least_step && !c->starved) {
		double next = fmin(done + step, 1.0);

		set_forcing(c, rom, next);
		memcpy(c->keep, c->U, bytes);
		if (newton(c, residual)) {
			done = next;
		} else {
			memcpy(c->U, c->keep, bytes);
			step /= 2.0;
		}
	}
	return done >= 1.0;
}

static void transform(struct hawser__cycle *cycle, const struct collocation *c)
{
	int n = c->n, M = c->M;

	for (int h = 0; h <= cycle->order; h++)
		for (int i = 0; i < M; i++) {
			double angle = 2.0*M_PI*((h*i)%M)/M, scale = (h ? 2.0 : 1.0)/M;

			for (int j = 0; j < n; j++) {
				cycle->cosine[h*n + j] += scale*cos(angle)*c->U[i*n + j];
				cycle->sine[h*n + j] += scale*sin(angle)*c->U[i*n + j];
			}
		}
}

void hawser__cycle_clear(struct hawser__cycle *cycle)
{
	free(cycle->cosine);
	free(cycle->sine);
	memset(cycle, 0, sizeof *cycle);
}

enum hawser_status hawser__cycle_find(struct hawser__cycle *cycle, const struct hawser_rom *rom,
                                      double omega, struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;
	struct collocation c;
	double residual = INFINITY;
	int highest = 1;

	for (int h = 0; h < rom->harmonics; h++)
		highest = rom->harmonic[h].k > highest ? rom->harmonic[h].k : highest;
	*cycle = (struct hawser__cycle){.n = rom->n, .order = 4*highest + 12};
	cycle->cosine = calloc((size_t)(cycle->order + 1)*rom->n, sizeof *cycle->cosine);
	cycle->sine = calloc((size_t)(cycle->order + 1)*rom->n, sizeof *cycle->sine);
	if (!collocation_make(&c, rom, cycle->order, omega) || !cycle->cosine || !cycle->sine)
		status = hawser__no_memory(report, "rom");
	else if (!grow(&c, rom, &residual))
		status = c.starved ? hawser__no_memory(report, "rom")
			: hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, "rom", ITERATIONS, residual,
			                  "no periodic orbit was found at Omega = %g (scaled) to start the "
			                  "exported continuation: the last Newton step is %.1e of the orbit; "
			                  "start it further from resonance", omega, residual);
	else
		transform(cycle, &c);
	collocation_clear(&c);
	if (status)
		hawser__cycle_clear(cycle);
	return status;
}
