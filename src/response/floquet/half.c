/* response/floquet/half.c - see half.h.
 *
 * With R the change of sign of the velocities, and of the coordinates whose sign is -1, the flow
 * backwards in time is R times the flow times R. A motion that R reverses has R x = x at phase 0 and
 * at half the period: the velocities of coordinates with sign 1, and the displacements of the others,
 * vanish there ("bound"). The others ("open") are unknown; velocities are divided by Omega.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/determinant.h"
#include "core/grow.h"
#include "core/report.h"
#include "response/floquet/half.h"

static const char where[] = "backbone";

#define FIRST_STEPS_A_PERIOD 6 /* per period of the fastest coordinate, whose frequency, and with it
                                * those of resonances with it, then has a relative error of 9e-8;
                                * chosen */
#define MOST_STEPS 20000 /* enough for a coordinate 2500 times as fast as the motion */

static struct hawser__half *of(struct hawser__orbit *orbit)
{
	return (struct hawser__half *)orbit;
}

static void metric(struct hawser__orbit *orbit, const double *y)
{
	struct hawser__half *half = of(orbit);
	int n = orbit->n;
	double sum = 0.0;

	for (int j = 0; j < n; j++)
		sum += y[j]*y[j];
	orbit->X = sum > 0.0 ? sqrt(sum) : 1.0;
	for (int j = 0; j < n; j++) {
		half->scale[j] = fmax(fabs(y[j]), HAWSER_SCALE_FLOOR*orbit->X);
		orbit->weight[j] = 1.0/(half->scale[j]*half->scale[j]*n);
	}
	orbit->W = HAWSER_OMEGA_WIDTH*fabs(y[n]);
	orbit->weight[n] = 1.0/(orbit->W*orbit->W);
}

/* The second half of the samples is the first half in reverse order, reflected. */
static void mirror(struct hawser__half *half)
{
	int n = half->base.n, steps = half->steps;

	memcpy(half->base.samples + (size_t)steps*n, half->x, (size_t)n*sizeof(double));
	for (int i = 1; i < steps; i++)
		for (int j = 0; j < n; j++)
			half->base.samples[(size_t)(steps + i)*n + j] =
				half->sign[j]*half->base.samples[(size_t)(steps - i)*n + j];
}

/* Index in the state of what of coordinate j is open or bound, with its sign or (other) the opposite
 * one. */
static int open_at(const struct hawser__half *half, int j, int other)
{
	return (half->sign[j] < 0) != other ? half->base.n + j : j;
}

static int bound_at(const struct hawser__half *half, int j, int other)
{
	return open_at(half, j, !other);
}

/* An entry of the derivative of the flow, in units of the coordinates. */
static double scaled(const struct hawser__half *half, int row, int column)
{
	int n = half->base.n;
	double omega = half->y[n], value = half->A[(size_t)row*2*n + column];

	return value*(column < n ? 1.0 : omega)/(row < n ? 1.0 : omega);
}

double hawser__half_entry(const struct hawser__half *half, int j, int k, int other)
{
	return scaled(half, bound_at(half, j, other), open_at(half, k, other));
}

double hawser__half_length(const struct hawser__half *half, int j, int other)
{
	double sum = 0.0;

	for (int k = 0; k < 2*half->base.n; k++) {
		double part = scaled(half, bound_at(half, j, other), k);

		sum += part*part;
	}
	return sqrt(sum);
}

/* The same by Omega. */
static double entry_omega(const struct hawser__half *half, int j)
{
	int n = half->base.n, row = bound_at(half, j, 0);
	double value = half->b[row];

	for (int k = 0; k < n; k++)
		if (half->sign[k] < 0)
			value += half->A[(size_t)row*2*n + n + k]*half->y[k];
	return row < n ? value : value/half->y[n];
}

void hawser__half_state(const struct hawser__half *half, double *x, const double *y)
{
	int n = half->base.n;

	for (int j = 0; j < n; j++) {
		x[j] = half->sign[j] < 0 ? 0.0 : y[j];
		x[n + j] = half->sign[j] < 0 ? y[j]*y[n] : 0.0;
	}
}

/* What is bound, at half the period; as an amplitude. */
static double bound_of(const struct hawser__half *half, int j)
{
	int row = bound_at(half, j, 0);

	if (half->class_of[j])
		return 0.0;
	return row < half->base.n ? half->x[row] : half->x[row]/half->y[half->base.n];
}

static double defects(struct hawser__orbit *orbit, const double *y, int derive)
{
	struct hawser__half *half = of(orbit);
	int n = orbit->n;
	struct hawser__stretch stretch = {.h = half->periods*M_PI/half->steps, .steps = half->steps,
		.count = 1};
	double sum = 0.0;

	memcpy(half->y, y, ((size_t)n + 1)*sizeof(double));
	hawser__half_state(half, half->x, y);
	if (derive) {
		orbit->mesh = hawser__flow_derive(&half->flow, half->x, half->A, half->b, orbit->samples,
		                                  &stretch, y[n]);
		mirror(half);
		orbit->cost.flows++;
	} else {
		orbit->mesh = hawser__flow_map(&half->flow, half->x, orbit->samples, &stretch, y[n]);
		orbit->cost.maps++;
	}
	for (int j = 0; j < n; j++) {
		double rest = bound_of(half, j);

		sum += rest*rest;
	}
	return sqrt(sum)/orbit->X;
}

static int factor(struct hawser__orbit *orbit, const double *row)
{
	struct hawser__half *half = of(orbit);
	int n = orbit->n, size = n + 1;

	for (int j = 0; j < n; j++) {
		int inside = half->class_of[j] == 0; /* the others stay at rest */

		for (int k = 0; k < n; k++)
			half->matrix[k*size + j] = inside && half->class_of[k] == 0
				? hawser__half_entry(half, j, k, 0)*half->scale[k]/half->scale[j]
				: j == k ? 1.0 : 0.0;
		half->matrix[n*size + j] = inside ? entry_omega(half, j)*orbit->W/half->scale[j] : 0.0;
		half->matrix[j*size + n] = inside ? orbit->weight[j]*row[j]*half->scale[j] : 0.0;
	}
	half->matrix[size*size - 1] = row[n]/orbit->W;
	return LAPACKE_dgetrf_work(LAPACK_COL_MAJOR, size, size, half->matrix, size, half->pivot) != 0;
}

static void solve(struct hawser__orbit *orbit, double *dy, int homogeneous, double last)
{
	struct hawser__half *half = of(orbit);
	int n = orbit->n, size = n + 1;

	for (int j = 0; j < n; j++)
		dy[j] = homogeneous ? 0.0 : -bound_of(half, j)/half->scale[j];
	dy[n] = last;
	LAPACKE_dgetrs_work(LAPACK_COL_MAJOR, 'N', size, 1, half->matrix, size, half->pivot, dy, size);
	for (int j = 0; j < n; j++)
		dy[j] *= half->scale[j];
	dy[n] *= orbit->W;
}

static int guess(struct hawser__orbit *orbit, const double *y, const double *row)
{
	return of(orbit)->guessing && hawser__orbit_guess(orbit, y, row);
}

double hawser__half_determinant(const struct hawser__half *half, double *sign)
{
	return hawser__determinant(sign, half->matrix, half->pivot, half->base.n + 1);
}

/* Product of a scaled vector with an unscaled one, in the metric. */
static double product(const struct hawser__half *half, const double *scaled, int stride,
                      const double *t)
{
	int n = half->base.n;
	double sum = scaled[(size_t)n*stride]*t[n]/half->base.W;

	for (int k = 0; k < n; k++)
		sum += scaled[(size_t)k*stride]*t[k]/half->scale[k]/n;
	return sum;
}

enum hawser_status hawser__half_other(const struct hawser__half *half, double *s, const double *t,
                                      struct hawser_report *report)
{
	int n = half->base.n, size = n + 1, info;
	double *room = malloc(((size_t)n*size + (size_t)size*size + 2*(size_t)n)*sizeof *room);
	double *vt, *singular, a, b, length = 0.0;

	if (!room)
		return hawser__no_memory(report, where);
	vt = room + (size_t)n*size;
	singular = vt + (size_t)size*size;
	for (int j = 0; j < n; j++) {
		int inside = half->class_of[j] == 0;

		for (int k = 0; k < n; k++)
			room[(size_t)k*n + j] = inside && half->class_of[k] == 0
				? hawser__half_entry(half, j, k, 0)*half->scale[k]/half->scale[j]
				: j == k ? 1.0 : 0.0;
		room[(size_t)n*n + j] = inside ? entry_omega(half, j)*half->base.W/half->scale[j] : 0.0;
	}
	info = LAPACKE_dgesvd(LAPACK_COL_MAJOR, 'N', 'A', n, size, room, n, singular, NULL, 1, vt, size,
	                      singular + n);
	/* rows n - 1 and n of vt */
	a = product(half, vt + n - 1, size, t);
	b = product(half, vt + n, size, t);
	for (int k = 0; k < size; k++) {
		double c = b*vt[(size_t)k*size + n - 1] - a*vt[(size_t)k*size + n];

		s[k] = c*(k < n ? half->scale[k] : half->base.W);
		length += c*c/(k < n ? n : 1);
	}
	for (int k = 0; k < size; k++)
		s[k] /= sqrt(length);
	free(room);
	return info ? hawser__fail(report, HAWSER_ERR_CONVERGENCE, where,
	                           "the curves at a branch point were not found") : HAWSER_OK;
}

static const struct hawser__orbit_ops ops = {
	.metric = metric, .defects = defects, .factor = factor, .solve = solve,
	.keep = hawser__orbit_keep, .guess = guess,
};

static enum hawser_status arrange(struct hawser__half *half, int steps, struct hawser_report *report)
{
	if (hawser__resize(&half->base.samples, 2*(size_t)steps*(size_t)half->base.n, sizeof(double)))
		return hawser__no_memory(report, where);
	half->steps = steps;
	half->base.rows = half->base.resolution = 2*steps;
	return HAWSER_OK;
}

static int first_steps(const struct hawser_rom *rom)
{
	double slow = INFINITY, fast = 0.0;

	for (int j = 0; j < rom->n; j++) {
		double k = fabs(rom->K[(size_t)j*((size_t)rom->n + 1)]);

		slow = k > 0.0 ? fmin(slow, k) : slow;
		fast = fmax(fast, k);
	}
	return (int)fmin(MOST_STEPS, fmax(16.0, ceil(0.5*FIRST_STEPS_A_PERIOD*sqrt(fast/slow))));
}

/* The gyroscopic forces of a travelling cable: the skew part of D. Entries of the size of round-off are
 * left out. */
static void skew_part(double *G, const struct hawser_rom *rom)
{
	int n = rom->n;
	double largest = 0.0;

	for (int j = 0; j < n; j++)
		largest = fmax(largest, fabs(rom->K[(size_t)j*((size_t)n + 1)]));
	largest = sqrt(largest);
	for (int i = 0; i < n*n; i++)
		largest = fmax(largest, fabs(rom->D[i]));
	for (int j = 0; j < n; j++)
		for (int k = 0; k < n; k++) {
			double g = 0.5*(rom->D[j*n + k] - rom->D[k*n + j]);

			G[j*n + k] = fabs(g) > 1e-12*largest ? g : 0.0;
		}
}

enum hawser_status hawser__half_init(struct hawser__half *half, const struct hawser_rom *rom,
                                     struct hawser_report *report)
{
	size_t n = (size_t)rom->n, m = 2*n, size = n + 1;
	enum hawser_status status;

	memset(half, 0, sizeof *half);
	half->base.ops = &ops;
	half->periods = 1;
	half->G = hawser__hold(&half->hold, n*n, sizeof(double));
	half->sign = hawser__hold(&half->hold, n, sizeof(int));
	half->class_of = hawser__hold(&half->hold, n, sizeof(int));
	half->y = hawser__hold(&half->hold, size, sizeof(double));
	half->x = hawser__hold(&half->hold, m, sizeof(double));
	half->A = hawser__hold(&half->hold, m*(m + 1), sizeof(double));
	half->scale = hawser__hold(&half->hold, n, sizeof(double));
	half->matrix = hawser__hold(&half->hold, size*size, sizeof(double));
	half->pivot = hawser__hold(&half->hold, size, sizeof(int));
	if (half->hold.short_of_memory)
		return hawser__no_memory(report, where);
	half->b = half->A + m*m;
	skew_part(half->G, rom);
	half->classes = 1;
	for (size_t j = 0; j < n; j++)
		half->sign[j] = 1;
	half->model = *rom;
	half->model.D = half->G;
	half->model.harmonics = 0;
	half->model.harmonic = NULL;
	half->model.ends = NULL;
	status = hawser__flow_init(&half->flow, &half->model, report);
	if (!status)
		status = hawser__orbit_init(&half->base, &half->model, (int)size, report);
	if (!status && hawser__orbit_remember(&half->base, half->A, m*(m + 1)))
		status = hawser__no_memory(report, where);
	return status ? status : arrange(half, first_steps(rom), report);
}

void hawser__half_release(struct hawser__half *half)
{
	hawser__flow_clear(&half->flow);
	hawser__orbit_free(&half->base);
	free(half->base.samples);
	hawser__hold_clear(&half->hold);
	memset(half, 0, sizeof *half);
}

enum hawser_status hawser__half_refine(struct hawser__half *half, struct hawser_report *report)
{
	if (2*half->steps > MOST_STEPS)
		return hawser__fail(report, HAWSER_ERR_CONVERGENCE, where,
		                    "%d integration steps in half a period are not enough: give a larger "
		                    "tolerance, or fewer modes", half->steps);
	return arrange(half, 2*half->steps, report);
}
