/* response/backbone/modulation_terms.c - the list of monomials of the modulation equations.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/grow.h"
#include "core/report.h"
#include "response/backbone/modulation.h"

static const char where[] = "multiple scales";

/* Monomials below this fraction of the largest of their degree are zero by parity but for
 * round-off. */
#define NOTHING 1e-14

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

enum hawser_status hawser__monomial_add(struct hawser_modulation *m, int equation,
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
	if (hawser__more(&m->monomial, m->monomials, sizeof *m->monomial))
		return hawser__no_memory(report, where);
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

void hawser__monomials_tidy(struct hawser_modulation *m)
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
