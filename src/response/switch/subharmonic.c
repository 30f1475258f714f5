/* response/switch/subharmonic.c - motions whose period is a multiple of the load's.
 *
 *    b      the period of the motion is b times that of the load; base frequency Omega/b
 *    D      omega^2 - p^2 Omega^2 + i p Omega c + kappa: factor of A
 *    beta   factor of A^2 conj(A)
 *    L      factor of conj(A)^q, q = 1 or 2: the term that sustains the motion
 *
 * An equilibrium of (D + beta |A|^2) A + L conj(A)^q = 0 other than 0 satisfies, with R = |A|^2, |D
 * + beta R|^2 = |L|^2 R^(q - 1), a quadratic equation for R. Its phase follows from A^(q + 1).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "core/report.h"
#include "response/time/flow.h"
#include "response/backbone/modulation.h"
#include "rom/terms/ends.h"
#include "rom/energy/kernel.h"

static const char where[] = "multiple scales";

enum hawser_status hawser_subharmonic_base(struct hawser_rom *rom, int b, struct hawser_report *report)
{
	if (b < 1)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
		                    "a motion of %d periods of the load: give 1 or more", b);
	if (rom->ends)
		rom->ends->base *= b;
	rom->base = (rom->base > 1 ? rom->base : 1)*b;
	for (int i = 0; i < rom->harmonics; i++) {
		struct hawser_harmonic *harmonic = &rom->harmonic[i];
		double factor = pow(b, harmonic->omega_power);

		harmonic->k *= b;
		for (int j = 0; harmonic->f && j < rom->n; j++)
			harmonic->f[j] *= factor;
		for (int e = 0; harmonic->D && e < rom->n*rom->n; e++)
			harmonic->D[e] *= factor;
		for (int e = 0; harmonic->K && e < rom->n*rom->n; e++)
			harmonic->K[e] *= factor;
		for (int e = 0; e < harmonic->terms; e++)
			harmonic->term[e].value *= factor;
		for (size_t e = 0; harmonic->answer && e < HAWSER__ANSWER(rom); e++)
			harmonic->answer[e] *= factor;
		for (size_t e = 0; harmonic->answer_line && e < HAWSER__ANSWER_LINE(rom); e++)
			harmonic->answer_line[e] *= factor;
		for (int e = 0; harmonic->known && e < rom->known.modes; e++)
			harmonic->known[e] *= factor;
	}
	return HAWSER_OK;
}

struct reduced {
	double complex D, beta, L;
	int q;
};

static enum hawser_status refuse(const struct hawser_modulation *m, struct hawser_report *report)
{
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
	                    "the equation of mode %d has other terms than a subharmonic resonance's: there "
	                    "the motion at rest of this mode is none, follow the response from that",
	                    m->resonance.mode[0] + 1);
}

static enum hawser_status reduce(struct reduced *r, const struct hawser_modulation *m, double omega,
                                 struct hawser_report *report)
{
	const struct hawser_rom *rom = m->rom;
	int j = m->resonance.mode[0], p = m->resonance.order[0];

	*r = (struct reduced){.D = hawser__stiffness(rom, j) - p*p*omega*omega
	                           + I*p*omega*rom->D[(size_t)j*((size_t)rom->n + 1)]};
	for (int i = 0; i < m->monomials; i++) {
		const struct hawser_monomial *e = &m->monomial[i];
		double complex value = e->re + I*e->im;
		int plain = 0, conjugate = 0;

		for (int f = 0; f < 3; f++) {
			plain += e->factor[f] == 0;
			conjugate += e->factor[f] == 1;
		}
		if (plain == 1 && conjugate == 0)
			r->D += value;
		else if (plain == 2 && conjugate == 1)
			r->beta += value;
		else if (plain == 0 && conjugate > 0 && conjugate < 3 && (!r->q || r->q == conjugate)) {
			r->L += value;
			r->q = conjugate;
		} else {
			return refuse(m, report);
		}
	}
	return HAWSER_OK;
}

/* The larger root; negative if there is none. */
static double square(const struct reduced *r)
{
	double a = creal(r->beta*conj(r->beta)), b = 2.0*creal(conj(r->D)*r->beta);
	double c = creal(r->D*conj(r->D)), l = creal(r->L*conj(r->L)), root;

	if (r->q == 1)
		c -= l;
	else
		b -= l;
	if (a == 0.0)
		return -1.0;
	root = b*b - 4.0*a*c;
	return root < 0.0 ? -1.0 : (-b + sqrt(root))/(2.0*a);
}

enum hawser_status hawser_subharmonic_start(const struct hawser_modulation *m, double *x,
                                            double *omega, double from, double to,
                                            struct hawser_report *report)
{
	enum { TRIALS = 400 };
	int first = -1, last = -1, at;
	struct reduced r;
	enum hawser_status status = HAWSER_OK;

	if (m->resonance.count != 1)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
		                    "a subharmonic motion of %d modes has no closed form to start from: "
		                    "name one", m->resonance.count);
	for (int i = 0; !status && i <= TRIALS; i++) {
		status = reduce(&r, m, from + (to - from)*i/TRIALS, report);
		if (status || !r.q || !(square(&r) > 0.0))
			continue;
		first = first < 0 ? i : first;
		last = i;
	}
	if (status)
		return status;
	if (last < 0)
		return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, where,
		                    "between %.6g and %.6g%s (of the motion) mode %d has no subharmonic "
		                    "motion: a larger load or less damping may bring one",
		                    from/m->rom->time, HAWSER_SHOWN(m->rom, to), m->resonance.mode[0] + 1);
	at = first == 0 ? 0 : last == TRIALS ? TRIALS : (first + last)/2;
	*omega = at == TRIALS ? to : from + (to - from)*at/TRIALS;
	status = reduce(&r, m, *omega, report);
	if (!status && !(square(&r) > 0.0)) { /* r is in a gap between two ranges */
		*omega = from + (to - from)*first/TRIALS;
		status = reduce(&r, m, *omega, report);
	}
	if (!status) {
		double R = square(&r);
		double complex A = sqrt(R)*cexp(I*carg(-r.L/(r.D + r.beta*R))/(r.q + 1));

		x[0] = creal(A);
		x[1] = cimag(A);
	}
	return status;
}
