/* beam/hermite.c - cubic Hermite finite elements of equal length h, as D 9.0.
 *
 * The unknowns are the deflection and h times the slope at each node, in that order; unknowns
 * that a boundary condition fixes are left out. The integrands are products of two cubics, times
 * x at most. Their degree is at most 7, so four Gauss points integrate them exactly.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stddef.h>

#include "beam/sample.h"
#include "core/report.h"

enum { LOCAL = 4, GAUSS = 4 };

static const double node[GAUSS] = {0.069431844202973712, 0.330009478207571868,
                                   0.669990521792428132, 0.930568155797026288};
static const double weight[GAUSS] = {0.173927422568726929, 0.326072577431273071,
                                     0.326072577431273071, 0.173927422568726929};

/* The element's functions at t in [0, 1], or their derivatives with respect to t. */
static void cubics(double p[LOCAL], int derivative, double t)
{
	if (derivative == 0) {
		p[0] = (1.0 - t)*(1.0 - t)*(1.0 + 2.0*t);
		p[1] = t*(1.0 - t)*(1.0 - t);
		p[2] = t*t*(3.0 - 2.0*t);
		p[3] = -t*t*(1.0 - t);
	} else if (derivative == 1) {
		p[0] = -6.0*t*(1.0 - t);
		p[1] = (1.0 - t)*(1.0 - 3.0*t);
		p[2] = 6.0*t*(1.0 - t);
		p[3] = t*(3.0*t - 2.0);
	} else if (derivative == 2) {
		p[0] = 12.0*t - 6.0;
		p[1] = 6.0*t - 4.0;
		p[2] = 6.0 - 12.0*t;
		p[3] = 6.0*t - 2.0;
	} else {
		p[0] = 12.0;
		p[1] = p[3] = 6.0;
		p[2] = -12.0;
	}
}

/* Index of the unknown of local function i of element e, or -1 if a boundary condition fixes it. */
static int unknown(enum hawser_beam_ends ends, int elements, int e, int i)
{
	int global = 2*e + i, last = 2*elements;

	if (global == 0 || global == last)
		return -1;
	if (ends == HAWSER_ENDS_CLAMPED)
		return global == 1 || global == last + 1 ? -1 : global - 2;
	return global < last ? global - 1 : global - 2;
}

static void add(struct hawser_beam_integrals *is, size_t at, double w, double x, double h,
                const double s[3][LOCAL], int i, int j)
{
	is->ss[at] += w*s[0][i]*s[0][j];
	is->s1s1[at] += w*s[1][i]*s[1][j]/(h*h);
	is->s2s2[at] += w*s[2][i]*s[2][j]/(h*h*h*h);
	is->xs1s1[at] += w*x*s[1][i]*s[1][j]/(h*h);
	is->ss1[at] += w*s[0][i]*s[1][j]/h;
	is->s1s2[at] += w*s[1][i]*s[2][j]/(h*h*h);
}

static void element(struct hawser_beam_integrals *is, enum hawser_beam_ends ends, int elements, int e)
{
	const double h = 1.0/elements;

	for (int g = 0; g < GAUSS; g++) {
		double s[3][LOCAL];

		for (int d = 0; d < 3; d++)
			cubics(s[d], d, node[g]);
		for (int i = 0; i < LOCAL; i++)
			for (int j = 0; j < LOCAL; j++) {
				int row = unknown(ends, elements, e, i), column = unknown(ends, elements, e, j);

				if (row >= 0 && column >= 0)
					add(is, (size_t)row*(size_t)is->n + (size_t)column, h*weight[g],
					    (e + node[g])*h, h, s, i, j);
			}
	}
}

static enum hawser_status fill(struct hawser_beam_integrals *is, enum hawser_beam_ends ends,
                               int elements, struct hawser_report *report)
{
	int clamped = ends == HAWSER_ENDS_CLAMPED;
	enum hawser_status status;

	if (elements < 1 + clamped)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "beam",
		                    "%d elements: give at least %d", elements, 1 + clamped);
	status = hawser__beam_integrals_init(is, 2*elements - 2*clamped, 3, report);
	for (int e = 0; !status && e < elements; e++)
		element(is, ends, elements, e);
	return status;
}

static void at(double *s, enum hawser_beam_ends ends, int elements, int derivative, double x)
{
	const double h = 1.0/elements;
	int n = 2*elements - (ends == HAWSER_ENDS_CLAMPED ? 2 : 0), e = (int)(x*elements);
	double p[LOCAL];

	if (e >= elements)
		e = elements - 1;
	for (int k = 0; k < n; k++)
		s[k] = 0.0;
	cubics(p, derivative, x*elements - e);
	for (int i = 0; i < LOCAL; i++) {
		int k = unknown(ends, elements, e, i);

		if (k >= 0)
			s[k] = p[i]/pow(h, derivative);
	}
}

const struct hawser_beam_method hawser__beam_hermite = {
	"hermite", "finite elements with Hermite's cubics", "D 9.0, Bathe 2006", fill, at,
};
