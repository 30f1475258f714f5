/* response/backbone/modulation.c - the modulation equations of hawser/scales.h, from the tensors of the
 * model.
 *
 * With u = sum over carriers of z_v c_v exp(i h_v tau), z an amplitude, its conjugate or 1:
 *
 *    second order   every pair v <= w causes the force q = Q(c_v, c_w) (twice, for v < w) at the
 *                   harmonic h = h_v + h_w. If this is the harmonic of a mode of R, the force is
 *                   secular: a monomial of the equation of the mode. Every other mode has the
 *                   response -q/(omega_s^2 - h^2 Omega_0^2)
 *    parametric     K u + D u' of a harmonic with each carrier is a force of second order likewise;
 *                   its Q u u with each pair of carriers is one of third order
 *    third order    at the harmonic p_r, on mode r: 2 Q(c_v, response), C of three carriers, and the
 *                   parametric force of a response
 *
 * Damping and load are first-order terms of their equations. These are all terms up to third order,
 * so that the equilibria of the equations agree with harmonic balance to that order.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/grow.h"
#include "core/report.h"
#include "response/backbone/modulation.h"
#include "rom/terms/drag.h"
#include "rom/terms/terms.h"

static const char where[] = "multiple scales";

/* A resonance of a mode outside R that is nearer than this leaves no accurate digits. */
#define EXACT 1e-9

/* Index of mode s in R, or -1. */
static int place_of(const struct hawser_resonance *resonance, int s)
{
	for (int r = 0; r < resonance->count; r++)
		if (resonance->mode[r] == s)
			return r;
	return -1;
}

/* --- carriers --- */

enum hawser_status hawser__modal(const struct hawser_rom *rom, const char *function,
                                 struct hawser_report *report)
{
	double off = hawser_rom_off_diagonal(rom);

	return off > 1e-12 ? hawser__fail(report, HAWSER_ERR_ARGUMENT, function, "K is not diagonal (%.3g "
	                                  "of its largest entry off the diagonal): give the model in its "
	                                  "modes' coordinates, as hawser nnm and mms take it", off)
	                   : HAWSER_OK;
}

static enum hawser_status check(const struct hawser_rom *rom,
                                const struct hawser_resonance *resonance,
                                struct hawser_report *report)
{
	enum hawser_status status;

	if (rom->drag)
		return hawser__drag_refuse(rom, "the method of multiple scales", report);
	if (hawser__rom_more(rom))
		return hawser__more_refuse(rom, "the method of multiple scales", report);
	if (rom->periods > 1)
		return hawser__periods_refuse(rom, "the method of multiple scales", report);
	if (rom->exact)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
		                    "the exact strain energy has no quadratic and cubic terms to derive "
		                    "from: take model.energy: quartic");
	status = hawser__modal(rom, where, report);
	if (status)
		return status;
	if (resonance->count < 1 || resonance->count > HAWSER_RESONANT_MOST ||
	    !(resonance->omega0 > 0.0 && isfinite(resonance->omega0)))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
		                    "%d resonant modes at the reference frequency %g: give 1 to %d, and a "
		                    "positive frequency", resonance->count, resonance->omega0,
		                    HAWSER_RESONANT_MOST);
	for (int r = 0; r < resonance->count; r++)
		if (resonance->mode[r] < (r ? resonance->mode[r - 1] + 1 : 0) ||
		    resonance->mode[r] >= rom->n || resonance->order[r] < 1)
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
			                    "resonant mode %d with order %d: modes are 1 to %d, ascending, "
			                    "orders from 1", resonance->mode[r] + 1, resonance->order[r],
			                    rom->n);
	return HAWSER_OK;
}

/* Direct response at harmonic k of all modes except those of R with this order; returns 0 if there
 * is none. */
static int direct(double complex *c, const struct hawser_rom *rom,
                  const struct hawser_resonance *resonance, int k)
{
	double w = k*resonance->omega0;
	double complex unused;
	int any = 0;

	for (int s = 0; s < rom->n; s++) {
		int r = place_of(resonance, s);
		double complex f = hawser__load(&unused, rom, s, k, resonance->omega0);

		c[s] = 0.0;
		if (f == 0.0 || (r >= 0 && resonance->order[r] == k))
			continue;
		c[s] = f/(hawser__stiffness(rom, s) - w*w + I*w*rom->D[(size_t)s*((size_t)rom->n + 1)]);
		any = 1;
	}
	return any;
}

/* Whether harmonic entry i is the first one with its k that has a load. */
static int first_with(const struct hawser_rom *rom, int i)
{
	if (!rom->harmonic[i].f)
		return 0;
	for (int j = 0; j < i; j++)
		if (rom->harmonic[j].f && rom->harmonic[j].k == rom->harmonic[i].k)
			return 0;
	return 1;
}

static double complex *add_carrier(struct hawser_modulation *m, int variable, int h)
{
	struct hawser_carrier *carrier = &m->carrier[m->carriers];

	carrier->variable = variable;
	carrier->h = h;
	carrier->c = calloc((size_t)m->rom->n, 2*sizeof *carrier->c);
	if (carrier->c)
		m->carriers++;
	return carrier->c ? hawser__complex(carrier->c) : NULL;
}

static enum hawser_status carriers(struct hawser_modulation *m, struct hawser_report *report)
{
	const struct hawser_rom *rom = m->rom;
	const struct hawser_resonance *resonance = &m->resonance;
	int R = resonance->count;

	m->carrier = calloc(2*((size_t)R + (size_t)rom->harmonics), sizeof *m->carrier);
	if (!m->carrier)
		return hawser__no_memory(report, where);
	for (int v = 0; v < 2*R; v++) {
		double complex *c = add_carrier(m, v, v < R ?
		                                resonance->order[v] : -resonance->order[v - R]);

		if (!c)
			return hawser__no_memory(report, where);
		c[resonance->mode[v%R]] = 1.0;
	}
	for (int i = 0; i < rom->harmonics; i++) {
		int k = rom->harmonic[i].k;
		double complex *c, *conjugate;

		if (!first_with(rom, i))
			continue;
		c = add_carrier(m, -1, k);
		if (!c)
			return hawser__no_memory(report, where);
		if (!direct(c, rom, resonance, k)) {
			free(m->carrier[--m->carriers].c);
			continue;
		}
		conjugate = add_carrier(m, -1, -k);
		if (!conjugate)
			return hawser__no_memory(report, where);
		for (int s = 0; s < rom->n; s++)
			conjugate[s] = conj(c[s]);
	}
	return HAWSER_OK;
}

/* --- forces --- */

/* q [n] += weight*Q(a, b), symmetric in a and b. */
static void quadratic_of(double complex *q, const struct hawser_quad *Q, int quads,
                         const double complex *a, const double complex *b, double complex weight)
{
	for (int i = 0; i < quads; i++) {
		const struct hawser_quad *e = &Q[i];

		q[e->j] += weight*e->value*0.5*(a[e->k]*b[e->l] + a[e->l]*b[e->k]);
	}
}

static void quadratic(double complex *q, const struct hawser_rom *rom, const double complex *a,
                      const double complex *b, double weight)
{
	quadratic_of(q, rom->Q, rom->quads, a, b, weight);
}

/* The terms of C, on mode s, for the product of three carriers: each distinct order of them once. */
static double complex cubic(const struct hawser_rom *rom, int s, const double complex *const c[3],
                            const int id[3])
{
	static const int order[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1},
	                                {2, 1, 0}};
	double complex sum = 0.0;
	int times = id[0] == id[1] && id[1] == id[2] ? 6
	            : id[0] == id[1] || id[1] == id[2] || id[0] == id[2] ? 2 : 1;

	for (int i = 0; i < rom->cubics; i++) {
		const struct hawser_cubic *e = &rom->C[i];

		if (e->j != s)
			continue;
		for (int p = 0; p < 6; p++)
			/* NOLINTNEXTLINE(clang-analyzer-core.NullDereference): callers give three carriers */
			sum += e->value*c[order[p][0]][e->k]*c[order[p][1]][e->l]*c[order[p][2]][e->m];
	}
	return sum/times;
}

/* Second-order response of mode s to q at harmonic h; if s is in R and h is its harmonic, the force
 * is secular. */
static enum hawser_status answer(struct hawser_modulation *m, double complex *w, int s, int h,
                                 double complex q, struct hawser_report *report)
{
	double k = hawser__stiffness(m->rom, s), f = h*m->resonance.omega0, gap =
	        h ? fabs(k/(f*f) - 1.0) : 1.0;
	int r = place_of(&m->resonance, s);

	*w = 0.0;
	if (q == 0.0 || (r >= 0 && abs(h) == m->resonance.order[r]))
		return HAWSER_OK;
	if (gap < EXACT || k == 0.0)
		return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, where,
		                    "mode %d is exactly resonant at %d times the reference frequency: make "
		                    "it one of the resonant modes", s + 1, abs(h));
	*w = -q/(k - f*f);
	if (gap < m->nearest) {
		m->nearest = gap;
		m->nearest_mode = s;
		m->nearest_harmonic = abs(h);
	}
	return HAWSER_OK;
}

/* Allocate one more response, all zero; NULL when out of memory. */
static struct hawser_answer *add_answer(struct hawser_modulation *m)
{
	struct hawser_answer *answer;

	if (hawser__more(&m->answer, m->answers, sizeof *m->answer))
		return NULL;
	answer = &m->answer[m->answers];
	answer->c = calloc((size_t)m->rom->n, 2*sizeof *answer->c);
	if (answer->c)
		m->answers++;
	return answer->c ? answer : NULL;
}

/* The response of all modes to the force q [n] at harmonic h, and its secular terms. */
static enum hawser_status respond(struct hawser_modulation *m,
                                  const double complex *q, int a, int b, int h,
                                  struct hawser_report *report)
{
	struct hawser_answer *all = add_answer(m);
	const int factor[3] = {a, b, -1};
	enum hawser_status status = HAWSER_OK;

	if (!all)
		return hawser__no_memory(report, where);
	all->factor[0] = a;
	all->factor[1] = b;
	all->h = h;
	for (int s = 0; !status && s < m->rom->n; s++) {
		int r = place_of(&m->resonance, s);

		status = answer(m, &hawser__complex(all->c)[s], s, h, q[s], report);
		if (!status && r >= 0 && h == m->resonance.order[r])
			status = hawser__monomial_add(m, r, factor, q[s], report);
	}
	return status;
}

/* q [n] = half of (K + i h Omega_0 D) c of a harmonic of the model: its part at h + k (sign 1) or h
 * - k (sign -1). */
static void parametric(double complex *q, const struct hawser_modulation *m,
                       const struct hawser_harmonic *harmonic, const double complex *c, int h,
                       int sign)
{
	int n = m->rom->n;
	double complex half = harmonic->phase == HAWSER_COS ? 0.5 : -0.5*I*sign;

	half *= pow(m->resonance.omega0, harmonic->omega_power);
	for (int j = 0; j < n; j++) {
		q[j] = 0.0;
		for (int k = 0; k < n; k++) {
			double stiff = harmonic->K ? harmonic->K[j*n + k] : 0.0;
			double damp = harmonic->D ? harmonic->D[j*n + k] : 0.0;

			q[j] += half*(stiff + I*(h*m->resonance.omega0*damp))*c[k];
		}
	}
}

static enum hawser_status second_order(struct hawser_modulation *m,
                                       double complex *q, struct hawser_report *report)
{
	const struct hawser_rom *rom = m->rom;
	enum hawser_status status = HAWSER_OK;

	for (int w = 0; !status && w < m->carriers; w++) {
		const struct hawser_carrier *b = &m->carrier[w];

		for (int v = 0; !status && v <= w; v++) {
			const struct hawser_carrier *a = &m->carrier[v];

			memset(q, 0, (size_t)rom->n*sizeof *q);
			quadratic(q, rom, hawser__complex(a->c), hawser__complex(b->c), v == w ? 1.0 : 2.0);
			status = respond(m, q, a->variable, b->variable, a->h + b->h, report);
		}
		for (int i = 0; !status && i < 2*rom->harmonics; i++) {
			const struct hawser_harmonic *harmonic = &rom->harmonic[i/2];
			int sign = i%2 ? -1 : 1;

			if (!harmonic->K && !harmonic->D)
				continue;
			parametric(q, m, harmonic, hawser__complex(b->c), b->h, sign);
			status = respond(m, q, b->variable, -1, b->h + sign*harmonic->k, report);
		}
	}
	return status;
}

/* Add the force q [n] at harmonic h to the equations that have this harmonic. */
static enum hawser_status collect(struct hawser_modulation *m,
                                  const double complex *q, int h, const int factor[3],
                                  struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	for (int r = 0; !status && r < m->resonance.count; r++)
		if (h == m->resonance.order[r])
			status = hawser__monomial_add(m, r, factor, q[m->resonance.mode[r]],
			                      report);
	return status;
}

/* The third-order terms of a response with every carrier and every parametric harmonic. */
static enum hawser_status of_answer(struct hawser_modulation *m,
                                    double complex *q, const struct hawser_answer *answer,
                                    struct hawser_report *report)
{
	const struct hawser_rom *rom = m->rom;
	int factor[3] = {answer->factor[0], answer->factor[1], -1};
	enum hawser_status status = HAWSER_OK;

	for (int v = 0; !status && v < m->carriers; v++) {
		const struct hawser_carrier *a = &m->carrier[v];

		memset(q, 0, (size_t)rom->n*sizeof *q);
		quadratic(q, rom, hawser__complex(a->c), hawser__complex(answer->c), 2.0);
		factor[2] = a->variable;
		status = collect(m, q, a->h + answer->h, factor, report);
	}
	factor[2] = -1;
	for (int i = 0; !status && i < 2*rom->harmonics; i++) {
		const struct hawser_harmonic *harmonic = &rom->harmonic[i/2];
		int sign = i%2 ? -1 : 1;

		if (!harmonic->K && !harmonic->D)
			continue;
		parametric(q, m, harmonic, hawser__complex(answer->c), answer->h, sign);
		status = collect(m, q, answer->h + sign*harmonic->k, factor, report);
	}
	return status;
}

/* The terms of C for every three carriers. */
static enum hawser_status of_three(struct hawser_modulation *m,
                                   int v, int w,
                                   int x, struct hawser_report *report)
{
	const struct hawser_carrier *a = &m->carrier[v], *b = &m->carrier[w], *c = &m->carrier[x];
	const int id[3] = {v, w, x}, factor[3] = {a->variable, b->variable, c->variable};
	const double complex *const field[3] = {hawser__complex(a->c), hawser__complex(b->c),
	                                        hawser__complex(c->c)};
	enum hawser_status status = HAWSER_OK;

	for (int r = 0; !status && r < m->resonance.count; r++)
		if (a->h + b->h + c->h == m->resonance.order[r])
			status = hawser__monomial_add(m, r, factor,
			                      cubic(m->rom, m->resonance.mode[r], field, id), report);
	return status;
}

/* The terms of the harmonics' Q, for every two carriers. */
static enum hawser_status of_varying(struct hawser_modulation *m,
                                     double complex *q, int v, int w, struct hawser_report *report)
{
	const struct hawser_rom *rom = m->rom;
	const struct hawser_carrier *a = &m->carrier[v], *b = &m->carrier[w];
	const int factor[3] = {a->variable, b->variable, -1};
	enum hawser_status status = HAWSER_OK;

	for (int i = 0; !status && i < 2*rom->harmonics; i++) {
		const struct hawser_harmonic *harmonic = &rom->harmonic[i/2];
		int sign = i%2 ? -1 : 1;
		double complex half = harmonic->phase == HAWSER_COS ? 0.5 : -0.5*I*sign;

		if (harmonic->quads == 0)
			continue;
		memset(q, 0, (size_t)rom->n*sizeof *q);
		quadratic_of(q, harmonic->Q, harmonic->quads, hawser__complex(a->c),
		             hawser__complex(b->c), v == w ? half : 2.0*half);
		status = collect(m, q, a->h + b->h + sign*harmonic->k, factor, report);
	}
	return status;
}

enum hawser_status hawser_modulation_derive(struct hawser_modulation *m,
                                            const struct hawser_rom *rom,
                                            const struct hawser_resonance *resonance,
                                            struct hawser_report *report)
{
	enum hawser_status status = check(rom, resonance, report);
	double complex *q = NULL;

	memset(m, 0, sizeof *m);
	if (status)
		return status;
	m->rom = rom;
	m->resonance = *resonance;
	m->nearest = INFINITY;
	status = carriers(m, report);
	if (!status && !(q = calloc((size_t)rom->n, sizeof *q)))
		status = hawser__no_memory(report, where);
	if (!status)
		status = second_order(m, q, report);
	for (int i = 0; !status && i < m->answers; i++)
		status = of_answer(m, q, &m->answer[i], report);
	for (int w = 0; !status && w < m->carriers; w++)
		for (int v = 0; !status && v <= w; v++)
			status = of_varying(m, q, v, w, report);
	for (int x = 0; !status && x < m->carriers; x++)
		for (int w = 0; !status && w <= x; w++)
			for (int v = 0; !status && v <= w; v++)
				status = of_three(m, v, w, x, report);
	if (status)
		goto done;
	hawser__monomials_tidy(m);
done:
	free(q);
	if (status)
		hawser_modulation_clear(m);
	return status;
}

void hawser_modulation_clear(struct hawser_modulation *m)
{
	if (!m)
		return;
	for (int i = 0; i < m->carriers; i++)
		free(m->carrier[i].c);
	for (int i = 0; i < m->answers; i++)
		free(m->answer[i].c);
	free(m->carrier);
	free(m->answer);
	free(m->monomial);
	memset(m, 0, sizeof *m);
}
