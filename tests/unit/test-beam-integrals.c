/* The integrals of every discretisation against numerical quadrature of its functions, the end
 * conditions, and symmetries of the matrices of a beam.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include <hawser/beam.h>

#include "tests/tap.h"

enum { SIZE = 7, MOST = 16, PANELS = 84, ORDER = 5 };

static const double node[ORDER] = {0.0469100770306680, 0.2307653449471585, 0.5,
                                   0.7692346550528415, 0.9530899229693320};
static const double weight[ORDER] = {0.1184634425280945, 0.2393143352496832, 0.2844444444444444,
                                     0.2393143352496832, 0.1184634425280945};

static void quadrature(double sum[6][MOST*MOST], const struct hawser_beam_method *row,
                       enum hawser_beam_ends ends, int n)
{
	double s[3][MOST];

	for (int p = 0; p < PANELS*ORDER; p++) {
		double x = (p/ORDER + node[p%ORDER])/PANELS, w = weight[p%ORDER]/PANELS;

		for (int d = 0; d < 3; d++)
			row->at(s[d], ends, SIZE, d, x);
		for (int j = 0; j < n; j++)
			for (int k = 0; k < n; k++) {
				int at = j*n + k;

				sum[0][at] += w*s[0][j]*s[0][k];
				sum[1][at] += w*s[1][j]*s[1][k];
				sum[2][at] += w*s[2][j]*s[2][k];
				sum[3][at] += w*x*s[1][j]*s[1][k];
				sum[4][at] += w*s[0][j]*s[1][k];
				sum[5][at] += w*s[1][j]*s[2][k];
			}
	}
}

static void integrals(const struct hawser_beam_method *row, enum hawser_beam_ends ends)
{
	static const char *const name[] = {"s s", "s' s'", "s'' s''", "x s' s'", "s s'", "s' s''"};
	static double sum[6][MOST*MOST];
	struct hawser_beam_integrals is;
	struct hawser_report report;
	const double *got[6];
	double outside = 0.0;

	if (!ok(row->fill(&is, ends, SIZE, &report) == HAWSER_OK, "%s, ends %d", row->name, ends))
		return;
	got[0] = is.ss, got[1] = is.s1s1, got[2] = is.s2s2;
	got[3] = is.xs1s1, got[4] = is.ss1, got[5] = is.s1s2;
	memset(sum, 0, sizeof sum);
	quadrature(sum, row, ends, is.n);
	for (int i = 0; i < 6; i++) {
		double worst = 0.0, size = 0.0;

		for (int at = 0; at < is.n*is.n; at++) {
			worst = fmax(worst, fabs(got[i][at] - sum[i][at]));
			size = fmax(size, fabs(sum[i][at]));
			if (abs(at/is.n - at%is.n) > is.band)
				outside = fmax(outside, fabs(sum[i][at]));
		}
		ok(worst <= 1e-12*size, "%s, ends %d: %s off by %.1e of %.1e", row->name, ends, name[i],
		   worst, size);
	}
	ok(outside <= 1e-12, "nothing outside the band of %d: %.1e", is.band, outside);
	hawser_beam_integrals_clear(&is);
}

static void at_ends(const struct hawser_beam_method *row, enum hawser_beam_ends ends)
{
	double s[MOST] = {0.0}, worst = 0.0;

	for (int d = 0; d <= (ends == HAWSER_ENDS_CLAMPED); d++)
		for (int x = 0; x < 2; x++) {
			row->at(s, ends, SIZE, d, x);
			for (int k = 0; k < MOST; k++)
				worst = fmax(worst, fabs(s[k]));
		}
	ok(worst <= 1e-12, "%s, ends %d: the functions keep to the ends' conditions, %.1e", row->name,
	   ends, worst);
}

/* Largest a_jk + sign*a_kj. */
static double part(const double *a, int n, double sign)
{
	double worst = 0.0;

	for (int j = 0; j < n; j++)
		for (int k = 0; k < n; k++)
			worst = fmax(worst, fabs(a[j*n + k] + sign*a[k*n + j]));
	return worst;
}

static void nature(const struct hawser_beam_method *row)
{
	struct hawser_beam beam = {.theta = 1.0, .tension = 2.0, .weight = 0.7, .rotary = 0.01,
	        .speed = 0.9};
	struct hawser_beam_integrals is;
	struct hawser_report report;
	double M[MOST*MOST], C[MOST*MOST], K[MOST*MOST];

	if (!ok(row->fill(&is, HAWSER_ENDS_SIMPLE, SIZE, &report) == HAWSER_OK, "%s", row->name))
		return;
	hawser_beam_matrices(M, C, K, &is, &beam);
	ok(part(M, is.n, -1.0) <= 1e-14 && part(K, is.n, -1.0) <= 1e-10, "%s: M and K symmetric",
	        row->name);
	ok(part(C, is.n, 1.0) > 1e-4, "%s: C not skew where rotary momentum flows through: %.1e", row->name,
	   part(C, is.n, 1.0));
	beam.moment = HAWSER_MOMENT_BALANCED;
	hawser_beam_matrices(M, C, K, &is, &beam);
	ok(part(C, is.n, 1.0) <= 1e-12, "%s: and skew where the moment balances it: %.1e", row->name,
	   part(C, is.n, 1.0));
	hawser_beam_integrals_clear(&is);
}

CASE(unit_beam_integrals)
{
	const struct hawser_beam_method *row;
	struct hawser_beam_integrals is;
	struct hawser_report report = {.message = ""};

	for (int i = 0; (row = hawser_beam_method(i)); i++) {
		for (int ends = HAWSER_ENDS_SIMPLE; ends <= HAWSER_ENDS_CLAMPED; ends++) {
			integrals(row, (enum hawser_beam_ends)ends);
			at_ends(row, (enum hawser_beam_ends)ends);
			ok(row->fill(&is, (enum hawser_beam_ends)ends, 0, &report) == HAWSER_ERR_ARGUMENT,
			   "%s of none is refused: %s", row->name, report.message);
		}
		nature(row);
	}
	hawser_beam_integrals_clear(NULL);
	return done_testing();
}
