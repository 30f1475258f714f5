/* response/time/beam_motion.c - free motion of a travelling beam, and its energy balance.
 *
 *    dE/dt = [ T y' Dy - T v y'^2/2 ] + [ theta (Dy' y'' - Dy y''' - v y''^2/2) ]
 *          + [ r^2 (Dy D2y' - v (Dy')^2/2) ] - [ v (Dy)^2/2 ]            power at the supports
 *          + (v rho/2) int y'^2 - c int (Dy)^2
 *
 * [.] is the value at x = 1 minus that at 0 (derivation: doc/theory-beam.md). The terms are
 * computed from the fields and their derivatives up to the third, while dE/dt of the discretised
 * beam follows from its matrices. The two agree only if the equation with its end conditions is
 * solved.
 *
 * D (9.5.1) states the rate that follows the material, dE/dt + [v e] with the density e of E, for
 * theta = 1 and r = c = 0. Its last term is printed as rho v int y'^2, twice what follows from T' =
 * rho.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <cblas.h>

#include <hawser/beam_motion.h>

#include "core/report.h"

static const char where[] = "beam";
static const double pi = 3.14159265358979323846;

/* Gauss's points on [0, 1], for projections: exact to degree 9 on each panel. */
enum { GAUSS = 5, PANELS = 200 };
static const double node[GAUSS] = {0.0469100770306680, 0.2307653449471585, 0.5, 0.7692346550528415,
                                   0.9530899229693320};
static const double weight[GAUSS] = {0.1184634425280945, 0.2393143352496832, 0.2844444444444444,
                                     0.2393143352496832, 0.1184634425280945};

struct work {
	const struct hawser_beam_method *row;
	const struct hawser_beam *beam;
	const struct hawser_beam_motion_options *options;
	struct hawser_beam_integrals is;
	int size, n, m;  /* functions, coordinates */
	double *B;       /* [n][m] functions' coefficients from the coordinates */
	double *M;       /* [3][n][n] M, C, K */
	double *end;     /* [2][4][n] the functions at both ends, derivatives 0 to 3 */
	double *middle;  /* [n] at x */
	double *b;       /* [3][n] b, b', b'' */
	double *u;       /* [m] u'' */
	double *initial; /* [2m] u, u' */
	struct hawser_rom rom;
};

/* --- coefficients of a given shape --- */

static double shape(const struct work *work, const double *value, double x)
{
	const struct hawser_beam_motion_options *options = work->options;
	double amplitude = options->amplitude != 0.0 ? options->amplitude : 0.01, s = sin(pi*x), at;
	int i;

	if (!value)
		return amplitude*(work->beam->ends == HAWSER_ENDS_CLAMPED ? s*s : s);
	at = x*(options->points - 1);
	i = (int)at < options->points - 2 ? (int)at : options->points - 2;
	return value[i] + (at - i)*(value[i + 1] - value[i]);
}

/* Least squares: int s_j s_k b_k = int s_j f. */
static enum hawser_status project(double *b, struct work *work, const double *value,
                                  struct hawser_report *report)
{
	int n = work->n;
	double *G = malloc((size_t)n*(size_t)(n + 1)*sizeof *G), *s = G ? G + (size_t)n*(size_t)n : NULL;

	if (!G)
		return hawser__no_memory(report, where);
	memset(b, 0, (size_t)n*sizeof *b);
	for (int p = 0; p < PANELS*GAUSS; p++) {
		double x = (p/GAUSS + node[p%GAUSS])/PANELS, w = weight[p%GAUSS]/PANELS;

		work->row->at(s, work->beam->ends, work->size, 0, x);
		cblas_daxpy(n, w*shape(work, value, x), s, 1, b, 1);
	}
	memcpy(G, work->is.ss, (size_t)n*(size_t)n*sizeof *G);
	/* Gram's matrix is positive definite: elimination without pivoting is stable */
	for (int i = 0; i < n; i++)
		for (int k = i + 1; k < n; k++) {
			double factor = G[k*n + i]/G[i*n + i];

			cblas_daxpy(n - i, -factor, G + i*n + i, 1, G + k*n + i, 1);
			b[k] -= factor*b[i];
		}
	cblas_dtrsv(CblasRowMajor, CblasUpper, CblasNoTrans, CblasNonUnit, n, G, n, b, 1);
	free(G);
	return HAWSER_OK;
}

/* u = B^T M b */
static enum hawser_status start(struct work *work, struct hawser_report *report)
{
	int n = work->n, m = work->m;
	double *b = work->b, *Mb = b + n;
	enum hawser_status status = HAWSER_OK;

	memset(work->initial, 0, 2*(size_t)m*sizeof *work->initial);
	for (int half = 0; !status && half < 2; half++) {
		if (half == 1 && !work->options->rate)
			break;
		status = project(b, work, half ? work->options->rate : work->options->deflection, report);
		cblas_dgemv(CblasRowMajor, CblasNoTrans, n, n, 1.0, work->M, n, b, 1, 0.0, Mb, 1);
		cblas_dgemv(CblasRowMajor, CblasTrans, n, m, 1.0, work->B, m, Mb, 1, 0.0,
		            work->initial + half*m, 1);
	}
	return status;
}

/* --- energy --- */

static double form(const double *left, const double *A, const double *right, int n)
{
	double sum = 0.0;

	for (int i = 0; i < n; i++)
		sum += left[i]*cblas_ddot(n, A + (size_t)i*(size_t)n, 1, right, 1);
	return sum;
}

/* b, b', b'' from a row of the trajectory. */
static void coefficients(struct work *work, const double *state)
{
	int n = work->n, m = work->m;
	const double *u[3] = {state, state + m, work->u};

	cblas_dgemv(CblasRowMajor, CblasNoTrans, m, m, -1.0, work->rom.D, m, u[1], 1, 0.0, work->u, 1);
	cblas_dgemv(CblasRowMajor, CblasNoTrans, m, m, -1.0, work->rom.K, m, u[0], 1, 1.0, work->u, 1);
	for (int i = 0; i < 3; i++)
		cblas_dgemv(CblasRowMajor, CblasNoTrans, n, m, 1.0, work->B, m, u[i], 1, 0.0,
		            work->b + i*n, 1);
}

/* E and its rate, quadratic forms of b and b'. */
static void energy(double *value, double *change, const struct work *work)
{
	const struct hawser_beam_integrals *is = &work->is;
	const struct hawser_beam *beam = work->beam;
	const double *b = work->b, *r = b + work->n, *a = r + work->n;
	double v = beam->speed, r2 = beam->rotary, low = beam->tension - beam->weight;
	int n = work->n;
	double tension_bb = low*form(b, is->s1s1, b, n) + beam->weight*form(b, is->xs1s1, b, n);
	double tension_rb = low*form(r, is->s1s1, b, n) + beam->weight*form(r, is->xs1s1, b, n);

	*value = 0.5*(form(r, is->ss, r, n) + r2*form(r, is->s1s1, r, n) +
	              2.0*v*(form(r, is->ss1, b, n) + r2*form(r, is->s1s2, b, n)) +
	              v*v*(form(b, is->s1s1, b, n) + r2*form(b, is->s2s2, b, n)) +
	              beam->theta*form(b, is->s2s2, b, n) + tension_bb);
	*change = form(r, is->ss, a, n) + r2*form(r, is->s1s1, a, n) +
	          v*(form(a, is->ss1, b, n) + form(r, is->ss1, r, n) +
	             r2*(form(a, is->s1s2, b, n) + form(r, is->s1s2, r, n))) +
	          v*v*(form(r, is->s1s1, b, n) + r2*form(r, is->s2s2, b, n)) +
	          beam->theta*form(r, is->s2s2, b, n) + tension_rb;
}

/* Jacobi's energy, 1/2 (b'^T M b' + b^T K_sym b), and its rate: exact for the discretised beam too. */
static void jacobi(double *value, double *rate, const struct work *work)
{
	const double *b = work->b, *r = b + work->n;
	int n = work->n;
	size_t square = (size_t)n*(size_t)n;
	double skew = work->beam->drag*work->beam->speed*form(r, work->is.ss1, b, n);

	*value = 0.5*(form(r, work->M, r, n) + form(b, work->M + 2*square, b, n));
	*rate = -form(r, work->M + square, r, n) - skew;
}

/* The terms in brackets, and the density e, at one end. */
static void at_end(double *enters, double *density, const struct work *work, int end)
{
	const struct hawser_beam *beam = work->beam;
	const double *s = work->end + (size_t)end*4*(size_t)work->n, *b = work->b;
	const double *r = b + work->n, *a = r + work->n;
	double v = beam->speed, r2 = beam->rotary, theta = beam->theta;
	double T = beam->tension - (end ? 0.0 : beam->weight);
	int n = work->n;
	double y1 = cblas_ddot(n, s + n, 1, b, 1), y2 = cblas_ddot(n, s + 2*n, 1, b, 1);
	double y3 = cblas_ddot(n, s + 3*n, 1, b, 1);
	double r1 = cblas_ddot(n, s + n, 1, r, 1), second = cblas_ddot(n, s + 2*n, 1, r, 1);
	double Dy = v*y1, Dy1 = r1 + v*y2;
	double D2y1 = cblas_ddot(n, s + n, 1, a, 1) + 2.0*v*second + v*v*y3;

	*enters = T*(y1*Dy - 0.5*v*y1*y1) + theta*(Dy1*y2 - Dy*y3 - 0.5*v*y2*y2) +
	          r2*(Dy*D2y1 - 0.5*v*Dy1*Dy1) - 0.5*v*Dy*Dy;
	*density = 0.5*(Dy*Dy + r2*Dy1*Dy1 + theta*y2*y2 + T*y1*y1);
}

static void account(struct hawser_beam_motion *motion, struct work *work, int row, const double *state)
{
	const struct hawser_beam_integrals *is = &work->is;
	const struct hawser_beam *beam = work->beam;
	double v = beam->speed, enters[2], density[2];
	int n = work->n;

	coefficients(work, state);
	motion->y[row] = cblas_ddot(n, work->middle, 1, work->b, 1);
	energy(&motion->energy[row], &motion->change[row], work);
	for (int end = 0; end < 2; end++)
		at_end(&enters[end], &density[end], work, end);
	jacobi(&motion->jacobi[row], &motion->leaves[row], work);
	motion->ends[row] = enters[1] - enters[0];
	motion->weight[row] = 0.5*v*beam->weight*form(work->b, is->s1s1, work->b, n);
	motion->drag[row] = -beam->drag*(form(work->b + n, is->ss, work->b + n, n) +
	                                 2.0*v*form(work->b + n, is->ss1, work->b, n) +
	                                 v*v*form(work->b, is->s1s1, work->b, n));
	motion->material[row] = motion->ends[row] + motion->weight[row] + motion->drag[row] +
	                        v*(density[1] - density[0]);
}

/* --- all together --- */

static enum hawser_status rooms(struct work *work, struct hawser_report *report)
{
	size_t n = (size_t)work->n, square = n*n;
	double x = work->options->x > 0.0 ? work->options->x : 0.5;

	work->B = malloc((4*square + 15*n)*sizeof *work->B);
	if (!work->B)
		return hawser__no_memory(report, where);
	work->M = work->B + square;
	work->end = work->M + 3*square;
	work->middle = work->end + 8*n;
	work->b = work->middle + n;
	work->u = work->b + 3*n;
	work->initial = work->u + n;
	for (int end = 0; end < 2; end++)
		for (int d = 0; d < 4; d++)
			work->row->at(work->end + (size_t)(4*end + d)*n, work->beam->ends, work->size, d, end);
	work->row->at(work->middle, work->beam->ends, work->size, 0, x);
	hawser_beam_matrices(work->M, work->M + square, work->M + 2*square, &work->is, work->beam);
	return HAWSER_OK;
}

static enum hawser_status record(struct hawser_beam_motion *motion, struct work *work,
                                 const struct hawser_trajectory *run, struct hawser_report *report)
{
	size_t rows = (size_t)run->rows;

	motion->time = malloc(10*rows*sizeof *motion->time);
	if (!motion->time)
		return hawser__no_memory(report, where);
	motion->y = motion->time + rows;
	motion->energy = motion->y + rows;
	motion->change = motion->energy + rows;
	motion->ends = motion->change + rows;
	motion->weight = motion->ends + rows;
	motion->drag = motion->weight + rows;
	motion->material = motion->drag + rows;
	motion->jacobi = motion->material + rows;
	motion->leaves = motion->jacobi + rows;
	memcpy(motion->time, run->time, rows*sizeof *motion->time);
	for (int i = 0; i < run->rows; i++)
		account(motion, work, i, run->state + (size_t)i*2*(size_t)work->m);
	motion->rows = run->rows;
	motion->method = run->method;
	motion->steps = run->steps;
	return HAWSER_OK;
}

enum hawser_status hawser_beam_motion(struct hawser_beam_motion *motion,
                                      const struct hawser_beam_method *row, int size,
                                      const struct hawser_beam *beam,
                                      const struct hawser_beam_motion_options *options,
                                      struct hawser_report *report)
{
	struct work work = {.row = row, .beam = beam, .options = options, .size = size};
	struct hawser_integrate_options choice = {.until = options->until, .every = options->every,
		.rtol = options->rtol > 0.0 ? options->rtol : 1e-11,
		.method = options->method ? options->method : "adams"};
	struct hawser_trajectory run = {0};
	enum hawser_status status;

	memset(motion, 0, sizeof *motion);
	if (!(options->x >= 0.0 && options->x <= 1.0) || (options->deflection && options->points < 2))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
		                    "a motion at x = %g, from a shape with %d points: x is within 0 and 1, and "
		                    "a shape has 2 points at least", options->x, options->points);
	status = row->fill(&work.is, beam->ends, size, report);
	work.n = work.is.n;
	if (!status)
		status = rooms(&work, report);
	if (!status)
		status = hawser_rom_from_beam(&work.rom, work.B, options->modes, &work.is, beam, report);
	work.m = work.rom.n;
	if (!status)
		status = start(&work, report);
	choice.initial = work.initial;
	choice.atol = 1e-3*choice.rtol;
	if (!status)
		status = hawser_integrate(&run, &work.rom, &choice, report);
	if (!status)
		status = record(motion, &work, &run, report);
	hawser_trajectory_clear(&run);
	hawser_rom_clear(&work.rom);
	hawser_beam_integrals_clear(&work.is);
	free(work.B);
	if (status)
		hawser_beam_motion_clear(motion);
	return status;
}

void hawser_beam_motion_clear(struct hawser_beam_motion *motion)
{
	if (!motion)
		return;
	free(motion->time);
	memset(motion, 0, sizeof *motion);
}
