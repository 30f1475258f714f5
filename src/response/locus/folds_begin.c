/* response/locus/folds_begin.c - the first point of a fold curve, from a fold of a response.
 *
 * The best initial value is an orbit that harmonic balance has found at the fold. If only a state
 * is known, Newton's method starts at the orbit through that state. If it converges to another fold
 * nearby, the response between the two points beside the fold is followed to the point at which its
 * tangent has no Omega component, and one more correction gives the fold.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "continuation/false_position.h"
#include "response/locus/folds_walk.h"

#define MOST_ITERATIONS 30 /* iterations of false position with halvings: 1e-9 of the step in the
                            * worst case */
#define NEAR_FOLD 1e-4 /* largest Omega component of the unit tangent at the fold, relative to its
                        * size at the ends; chosen */

/* row = the direction of one unknown. */
static void only(double *row, int size, int place)
{
	memset(row, 0, (size_t)size*sizeof *row);
	row[place] = 1.0;
}

/* Correct start->z at its Omega and load, with the number of harmonics that it needs. At the fold
 * itself the Jacobian is singular; the state is then kept unchanged. */
static enum hawser_status settle(struct hawser__fold_walk *walk)
{
	struct hawser__orbit *orbit = hawser__fold_orbit(walk->fold);
	double *z = walk->start.z, *trial = walk->scratch.z;
	int size = walk->fold->size, again = 1;
	enum hawser_status status = HAWSER_OK;

	only(walk->direction, size, size - 2);
	while (!status && again) {
		struct hawser__correction correction;

		memcpy(trial, z, (size_t)size*sizeof *z);
		if (hawser__orbit_correct(orbit, trial, &correction, walk->direction,
		                          walk->options->tolerance))
			break;
		memcpy(z, trial, (size_t)size*sizeof *z);
		hawser__walk_metric(walk, z);
		status = orbit->ops->refine(orbit, &again, walk->options->tolerance, z[size - 2],
		                            walk->report);
	}
	return status;
}

/* From an orbit near the fold, start->z, to the fold at the same load. */
static enum hawser_status converge(struct hawser__fold_walk *walk, int *failed)
{
	struct hawser__fold_station *start = &walk->start;
	int size = walk->fold->size;
	double load = start->z[size - 1];
	enum hawser_status status = hawser__fold_border(walk->fold, start->z, walk->report);

	*failed = 1;
	if (status)
		return status;
	only(walk->direction, size, size - 1);
	if ((status = hawser__walk_correct(walk, start, walk->direction, failed)) || *failed)
		return status;
	start->z[size - 1] = load;
	hawser__walk_metric(walk, start->z);
	hawser__walk_finish(walk, start, walk->direction);
	start->arc = 0.0;
	return HAWSER_OK;
}

enum hawser_status hawser__walk_begin_orbit(struct hawser__fold_walk *walk, const double *y,
                                            double load, int *failed)
{
	struct hawser__balance *balance = &walk->fold->balance;
	double *z = walk->start.z;
	int n = balance->base.n, last = balance->base.size - 1;
	enum hawser_status status;

	*failed = 1;
	hawser__load_set(&walk->fold->load, load);
	memcpy(z, y, ((size_t)last + 1)*sizeof *z);
	z[last + 1] = load;
	memset(balance->active, 0, (size_t)(balance->top + 1)*(size_t)n);
	for (int h = 0; h <= balance->top; h++)
		for (int j = 0; j < n; j++)
			balance->active[h*n + j] = z[hawser__cos(n, h, j)] != 0.0 ||
			                           (h && z[hawser__sin(n, h, j)] != 0.0);
	hawser__balance_seed(balance);
	if ((status = hawser__balance_arrange(balance, walk->report)))
		return status;
	hawser__walk_metric(walk, z);
	return converge(walk, failed);
}

/* start->z = the periodic orbit through a state [2n]. */
static enum hawser_status orbit_at(struct hawser__fold_walk *walk, const double *x, double omega,
                                   double load)
{
	struct hawser__orbit *orbit = hawser__fold_orbit(walk->fold);
	double *z = walk->start.z;
	enum hawser_status status;

	hawser__load_set(&walk->fold->load, load);
	if ((status = orbit->ops->from_state(orbit, z, x, omega, walk->report)))
		return status;
	z[walk->fold->size - 1] = load;
	hawser__walk_metric(walk, z);
	return settle(walk);
}

enum hawser_status hawser__walk_begin(struct hawser__fold_walk *walk, const double *x, double omega,
                                      double load, int *failed)
{
	enum hawser_status status = orbit_at(walk, x, omega, load);

	*failed = 1;
	return status ? status : converge(walk, failed);
}

/* start->z = the orbit at fraction s of the chord from lo to hi, in the plane normal to it; *turn is
 * the Omega component of the response's tangent there. */
static int chord(struct hawser__fold_walk *walk, double s, double *turn)
{
	struct hawser__orbit *orbit = hawser__fold_orbit(walk->fold);
	struct hawser__correction correction;
	double *z = walk->start.z, *t = walk->scratch.t;

	for (int i = 0; i < walk->fold->size; i++)
		z[i] = walk->lo.z[i] + s*walk->direction[i];
	if (hawser__orbit_correct(orbit, z, &correction, walk->direction, walk->options->tolerance))
		return 1;
	hawser__orbit_tangent(orbit, t);
	*turn = t[orbit->size - 1]/orbit->W;
	return 0;
}

/* start->z = the orbit between lo and hi at which the tangent has almost no Omega component. */
static int turning_point(struct hawser__fold_walk *walk)
{
	struct hawser__bracketed in = {.a = 0.0, .b = 1.0};
	double first;

	if (chord(walk, in.a, &in.fa) || chord(walk, in.b, &in.fb) || !(in.fa*in.fb < 0.0))
		return 1;
	first = fmax(fabs(in.fa), fabs(in.fb));
	for (int i = 0; i < MOST_ITERATIONS; i++) {
		double s = hawser__false_position(&in, i), turn;

		if (chord(walk, s, &turn))
			return 1;
		if (fabs(turn) <= NEAR_FOLD*first)
			return 0;
		hawser__false_position_take(&in, s, turn);
	}
	return 1;
}

enum hawser_status hawser__walk_begin_between(struct hawser__fold_walk *walk, const double *xa,
                                              double omega_a, const double *xb, double omega_b,
                                              double load, int *failed)
{
	int size = walk->fold->size;
	enum hawser_status status = orbit_at(walk, xa, omega_a, load);

	*failed = 1;
	if (status)
		return status;
	memcpy(walk->lo.z, walk->start.z, (size_t)size*sizeof(double));
	if ((status = orbit_at(walk, xb, omega_b, load)))
		return status;
	for (int i = 0; i < size; i++)
		walk->direction[i] = walk->start.z[i] - walk->lo.z[i];
	return turning_point(walk) ? HAWSER_OK : converge(walk, failed);
}
