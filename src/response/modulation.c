/* response/modulation.c - the modulation equations of hawser/scales.h, collected from the tensors.
 *
 * With u = sum over carriers of z_v c_v exp(i h_v tau), z an amplitude, its conjugate or 1:
 *
 *   second order   for every pair v <= w: the force q = Q(c_v, c_w) (twice, for v < w) at the harmonic
 *                  h = h_v + h_w. Where it meets a mode of R at its own harmonic it is secular, a
 *                  monomial of the equation; on every other mode it has the answer
 *                  -q/(omega_s^2 - h^2 Omega_0^2)
 *   third order    at the harmonic p_r, on mode r: 2 Q(c_v, answer to the pair w, x), and C of the three
 *
 * Damping and the load enter their own equations at once. Nothing else is of third order: so equilibria
 * of the equations are what a balance of harmonics gives to that order.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "response/modulation.h"

static const char where[] = "multiple scales";

/* A resonance of a mode out of R nearer than this leaves no digits. */
#define EXACT 1e-9
/* Monomials below this part of the largest of their degree are round-off of parity. */
#define NOTHING 1e-14

/* Of a mode s: its place in R, or -1. */
static int place_of(const struct hawser_resonance *resonance, int s)
{
	for (int r = 0; r < resonance->count; r++)
		if (resonance->mode[r] == s)
			return r;
	return -1;
}

/* --- carriers --- */

static enum hawser_status check(const struct hawser_rom *rom, const struct hawser_resonance *resonance,
                                struct hawser_report *report)
{
	double largest = 0.0, off = 0.0;

	if (rom->exact)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
		                    "the exact strain energy has no quadratic and cubic terms to derive "
		                    "from: take model.energy: quartic");
	for (int i = 0; i < rom->harmonics; i++)
		if (rom->harmonic[i].D || rom->harmonic[i].K)
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
			                    "parametric terms (D, K of harmonic %d) are not part of the "
			                    "method here: take shooting or balance", i + 1);
	for (int j = 0; j < rom->n; j++)
		for (int k = 0; k < rom->n; k++) {
			double K = fabs(rom->K[j*rom->n + k]);

			*(j == k ? &largest : &off) = fmax(K, j == k ? largest : off);
		}
	if (off > 1e-12*largest)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
		                    "K is not diagonal (%.3g off the diagonal): give the model in its "
		                    "modes' coordinates", off);
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

/* Direct response at harmonic k of all modes but those of R with that order; 0 where there is none. */
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

/* Whether harmonic entry i is the first with its k that has a load. */
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
		double complex *c = add_carrier(m, v, v < R ? resonance->order[v] : -resonance->order[v - R]);

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

/* --- monomials --- */

static int degree(const int factor[3])
{
	return (factor[0] >= 0) + (factor[1] >= 0) + (factor[2] >= 0);
}

/* Variables in ascending order, -1 last. */
static void sort(int factor[3])
{
	for (int pass = 0; pass < 2; pass++)
		for (int i = 0; i < 2; i++)
			if (factor[i + 1] >= 0 && (factor[i] < 0 || factor[i + 1] < factor[i])) {
				int keep = factor[i];

				factor[i] = factor[i + 1];
				factor[i + 1] = keep;
			}
}

static enum hawser_status add_monomial(struct hawser_modulation *m, int *capacity, int equation,
                                       const int given[3], double complex value,
                                       struct hawser_report *report)
{
	int factor[3] = {given[0], given[1], given[2]};

	if (value == 0.0)
		return HAWSER_OK;
	sort(factor);
	for (int i = 0; i < m->monomials; i++)
		if (m->monomial[i].equation == equation &&
		    !memcmp(m->monomial[i].factor, factor, sizeof factor)) {
			m->monomial[i].re += creal(value);
			m->monomial[i].im += cimag(value);
			return HAWSER_OK;
		}
	if (m->monomials == *capacity) {
		int more = *capacity ? 2 * *capacity : 32;
		struct hawser_monomial *larger = realloc(m->monomial, (size_t)more*sizeof *larger);

		if (!larger)
			return hawser__no_memory(report, where);
		m->monomial = larger;
		*capacity = more;
	}
	m->monomial[m->monomials].equation = equation;
	memcpy(m->monomial[m->monomials].factor, factor, sizeof factor);
	m->monomial[m->monomials].re = creal(value);
	m->monomial[m->monomials++].im = cimag(value);
	return HAWSER_OK;
}

static int compare(const void *left, const void *right)
{
	const struct hawser_monomial *a = left, *b = right;
	int d = a->equation - b->equation;

	if (!d)
		d = degree(a->factor) - degree(b->factor);
	for (int i = 0; !d && i < 3; i++)
		d = a->factor[i] - b->factor[i];
	return d;
}

/* Leave out what is zero but for round-off, and sort. */
static void tidy(struct hawser_modulation *m)
{
	double largest[4] = {0.0};
	int kept = 0;

	for (int i = 0; i < m->monomials; i++) {
		int d = degree(m->monomial[i].factor);

		largest[d] = fmax(largest[d], hypot(m->monomial[i].re, m->monomial[i].im));
	}
	for (int i = 0; i < m->monomials; i++)
		if (hypot(m->monomial[i].re, m->monomial[i].im) >
		    NOTHING*largest[degree(m->monomial[i].factor)])
			m->monomial[kept++] = m->monomial[i];
	m->monomials = kept;
	if (kept)
		qsort(m->monomial, (size_t)kept, sizeof *m->monomial, compare);
}

/* --- forces --- */

/* q [n] += weight*Q(a, b), symmetric in a and b. */
static void quadratic(double complex *q, const struct hawser_rom *rom, const double complex *a,
                      const double complex *b, double weight)
{
	for (int i = 0; i < rom->quads; i++) {
		const struct hawser_quad *e = &rom->Q[i];

		q[e->j] += weight*e->value*0.5*(a[e->k]*b[e->l] + a[e->l]*b[e->k]);
	}
}

/* What C has, on mode s, for the product of three different or equal carriers: every distinct order of
 * them once. */
static double complex cubic(const struct hawser_rom *rom, int s, const double complex *const c[3],
                            const int id[3])
{
	static const int order[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
	double complex sum = 0.0;
	int times = id[0] == id[1] && id[1] == id[2] ? 6
	            : id[0] == id[1] || id[1] == id[2] || id[0] == id[2] ? 2 : 1;

	for (int i = 0; i < rom->cubics; i++) {
		const struct hawser_cubic *e = &rom->C[i];

		if (e->j != s)
			continue;
		for (int p = 0; p < 6; p++)
			sum += e->value*c[order[p][0]][e->k]*c[order[p][1]][e->l]*c[order[p][2]][e->m];
	}
	return sum/times;
}

/* Second-order response of mode s to q at harmonic h; secular where it is one of R at its own. */
static enum hawser_status answer(struct hawser_modulation *m, double complex *w, int s, int h,
                                 double complex q, struct hawser_report *report)
{
	double k = hawser__stiffness(m->rom, s), f = h*m->resonance.omega0, gap = h ? fabs(k/(f*f) - 1.0) : 1.0;
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

static enum hawser_status second_order(struct hawser_modulation *m, int *capacity, double complex *q,
                                       struct hawser_report *report)
{
	int n = m->rom->n;
	enum hawser_status status = HAWSER_OK;

	for (int w = 0; w < m->carriers; w++)
		for (int v = 0; v <= w; v++) {
			const struct hawser_carrier *a = &m->carrier[v], *b = &m->carrier[w];
			double complex *pair = hawser__complex(m->pair) + (size_t)(w*(w + 1)/2 + v)*(size_t)n;
			const int factor[3] = {a->variable, b->variable, -1};

			memset(q, 0, (size_t)n*sizeof *q);
			quadratic(q, m->rom, hawser__complex(a->c), hawser__complex(b->c), v == w ? 1.0 : 2.0);
			for (int s = 0; !status && s < n; s++) {
				int r = place_of(&m->resonance, s), h = a->h + b->h;

				status = answer(m, &pair[s], s, h, q[s], report);
				if (!status && r >= 0 && h == m->resonance.order[r])
					status = add_monomial(m, capacity, r, factor, q[s], report);
			}
			if (status)
				return status;
		}
	return status;
}

/* 2 Q(c_x, answer to v, w) and C(c_v, c_w, c_x) in the equations whose harmonic they have. */
static enum hawser_status third_order(struct hawser_modulation *m, int *capacity, double complex *q,
                                      int v, int w, int x, struct hawser_report *report)
{
	int n = m->rom->n, h = m->carrier[v].h + m->carrier[w].h + m->carrier[x].h;
	const int id[3] = {v, w, x};
	const int factor[3] = {m->carrier[v].variable, m->carrier[w].variable, m->carrier[x].variable};
	const double complex *const c[3] = {hawser__complex(m->carrier[v].c), hawser__complex(m->carrier[w].c),
	                                    hawser__complex(m->carrier[x].c)};
	enum hawser_status status = HAWSER_OK;

	memset(q, 0, (size_t)n*sizeof *q);
	quadratic(q, m->rom, c[2], hawser__complex(m->pair) + (size_t)(w*(w + 1)/2 + v)*(size_t)n, 2.0);
	for (int r = 0; !status && r < m->resonance.count; r++) {
		int s = m->resonance.mode[r];

		if (h != m->resonance.order[r])
			continue;
		status = add_monomial(m, capacity, r, factor, q[s], report);
		if (!status && w <= x)
			status = add_monomial(m, capacity, r, factor, cubic(m->rom, s, c, id), report);
	}
	return status;
}

enum hawser_status hawser_modulation_derive(struct hawser_modulation *m, const struct hawser_rom *rom,
                                            const struct hawser_resonance *resonance,
                                            struct hawser_report *report)
{
	enum hawser_status status = check(rom, resonance, report);
	double complex *q = NULL;
	int capacity = 0;

	memset(m, 0, sizeof *m);
	if (status)
		return status;
	m->rom = rom;
	m->resonance = *resonance;
	m->nearest = INFINITY;
	status = carriers(m, report);
	if (status)
		goto done;
	m->pair = calloc((size_t)m->carriers*((size_t)m->carriers + 1)*(size_t)rom->n, sizeof *m->pair);
	q = calloc((size_t)rom->n, sizeof *q);
	if (!m->pair || !q) {
		status = hawser__no_memory(report, where);
		goto done;
	}
	status = second_order(m, &capacity, q, report);
	for (int w = 0; !status && w < m->carriers; w++)
		for (int v = 0; !status && v <= w; v++)
			for (int x = 0; !status && x < m->carriers; x++)
				status = third_order(m, &capacity, q, v, w, x, report);
	tidy(m);
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
	free(m->carrier);
	free(m->monomial);
	free(m->pair);
	memset(m, 0, sizeof *m);
}
