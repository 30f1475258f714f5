/* contact/friction-newton.c - semismooth Newton iteration for contact and friction.
 *
 * The unknowns are velocities alone (friction-chain.c). With sigma = 0 a step is that of an active
 * set: from a start near the solution, such as the step before, a few of them are exact. From far away
 * a stiff cable lets one node slip an iteration, and states may repeat. There the law is smoothed and
 * sigma falls to 0 along the path of solutions, with a line search on |F|, which takes some 25
 * iterations for any number of nodes; from a point of the path the steps with sigma = 0 finish.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "contact/friction.h"
#include "core/report.h"

/* Steps with sigma = 0 in a row; a start from the step before takes 2 to 4. */
enum { FINISH = 12 };
/* Attempts in turn until one arrives, each from the velocities without contact: along the path, where
 * the next sigma is this part of the last, or by full steps with sigma = 0 (part 0); with the scales of
 * the contacts times rho. */
static const struct attempt {
	double part, rho;
} attempts[] = {{0.5, 1.0}, {0.7, 1.0}, {0.0, 1.0}, {0.0, 0.1}, {0.0, 10.0}, {0.5, 4.0}, {0.5, 0.25},
                {0.0, 0.01}, {0.0, 100.0}, {0.7, 16.0}, {0.7, 0.0625}};
enum { ATTEMPTS = sizeof attempts/sizeof *attempts };
/* Most full steps of an attempt */
enum { FULL = 30 };
/* A point is on the path if |F| is at most this times sigma for each contact. */
static const double near = 1.0;
/* sigma over the largest force where the path ends; and from where a finish is tried */
static const double sigma_least = 1e-10, sigma_finish = 1e-2;
/* Of the line search: least decrease of |F|^2, shortest step, and the shortest that is no stall. */
static const double decrease = 1e-4, shortest = 1e-4, stalled = 1e-2;
enum { STALLS = 4 };

struct iteration {
	struct hawser_friction *of;
	double (*u)[3];
	struct hawser__friction_where at; /* `sum` with the last smoothing */
	double tolerance;
	int count, most, singular;
};

/* Make r and w those of u. */
static void arrive(struct iteration *it, double sigma)
{
	it->at = hawser__friction_arrive(it->of, sigma, (const double (*)[3])it->u);
}

static int solved(const struct iteration *it)
{
	double roundoff = hawser__friction_roundoff(it->of, (const double (*)[3])it->u);

	return it->at.error <= it->tolerance*it->at.scale + roundoff;
}

/* Newton's step. Returns 0 if its matrix is singular. */
static int step(struct iteration *it, double sigma, int elsewhere)
{
	const struct hawser__step_law law = {sigma, elsewhere};

	it->count++;
	if (hawser__friction_step(it->of, &law))
		return 1;
	it->singular = 1;
	return 0;
}

static void keep(struct iteration *it, int back)
{
	struct hawser_friction *of = it->of;
	size_t size = (size_t)of->nodes*sizeof *it->u;

	memcpy(back ? it->u : of->kept, back ? of->kept : it->u, size);
	for (int c = 0; c < of->of->contacts && of->corners; c++)
		memcpy(back ? of->touch[c].r : of->second[c].kept, back ? of->second[c].kept : of->touch[c].r,
		       sizeof of->touch[c].r);
}

/* Full steps with sigma = 0 while they get nearer: 1 if they reach the solution, else u as before. */
static int finish(struct iteration *it, int elsewhere)
{
	double before = HUGE_VAL;

	keep(it, 0);
	for (int i = 0; i < FINISH && it->count < it->most; i++) {
		if (!step(it, 0.0, elsewhere))
			break;
		elsewhere = 0;
		hawser__friction_move(it->of, it->u, 1.0);
		arrive(it, 0.0);
		if (solved(it))
			return 1;
		if (i > 1 && !(it->at.sum < before))
			break;
		before = it->at.sum;
	}
	keep(it, 1);
	arrive(it, 0.0);
	return 0;
}

/* A step of the path with a line search: its length, 0 if there is none. */
static double search(struct iteration *it, double sigma)
{
	const double before = hawser__friction_look(it->of, sigma).sum;
	double t = 1.0;

	if (!step(it, sigma, 0))
		return 0.0;
	hawser__friction_move(it->of, it->u, 1.0);
	arrive(it, sigma);
	while (!(it->at.sum <= (1.0 - decrease*t)*before)) {
		hawser__friction_move(it->of, it->u, -0.5*t);
		arrive(it, sigma);
		t *= 0.5;
		if (t < shortest)
			return 0.0;
	}
	return t;
}

/* From the velocities without contact along the path. 1: solved. */
static int path(struct iteration *it, double sigma, double factor)
{
	const double contacts = it->of->of->contacts;
	int stalls = 0;
	double wanted = sigma_finish*sigma;

	while (sigma > sigma_least*it->at.scale && it->count < it->most) {
		double t = search(it, sigma), sum = it->at.sum;

		if (solved(it)) {
			(void)finish(it, 0); /* to round-off */
			return 1;
		}
		stalls = t < stalled ? stalls + 1 : 0;
		if (t == 0.0 || stalls > STALLS)
			return 0;
		if (sum > near*near*sigma*sigma*contacts)
			continue;
		if (sigma <= wanted) {
			if (finish(it, 0))
				return 1;
			wanted = sigma_finish*sigma;
		}
		sigma *= factor;
	}
	return finish(it, 0);
}

/* Back to the velocities without contact and without impulses. */
static void release(struct iteration *it)
{
	memcpy(it->u, it->of->free, (size_t)it->of->nodes*sizeof *it->u);
	for (int c = 0; c < it->of->of->contacts; c++)
		memset(it->of->touch[c].r, 0, sizeof it->of->touch[c].r);
}

/* Full steps with sigma = 0 that may also get farther: where the line search on |F| is caught at a
 * least value that is not 0, they may leave it. */
static int full(struct iteration *it)
{
	for (int i = 0; i < FULL && it->count < it->most; i++) {
		if (!step(it, 0.0, 0))
			return 0;
		hawser__friction_move(it->of, it->u, 1.0);
		arrive(it, 0.0);
		if (solved(it))
			return 1;
	}
	return 0;
}

/* The solution does not depend on the scales rho, the way to it does. */
static void scale(struct iteration *it, double by)
{
	for (int c = 0; c < it->of->of->contacts; c++)
		it->of->touch[c].rho *= by;
}

static int attempt(struct iteration *it, const struct attempt *by)
{
	int done;

	scale(it, by->rho);
	release(it);
	arrive(it, 0.0);
	done = solved(it) || (by->part > 0.0 ? path(it, it->at.scale, by->part) : full(it));
	scale(it, 1.0/by->rho);
	arrive(it, 0.0);
	return done;
}

static int cold(struct iteration *it)
{
	int done = 0;

	for (int i = 0; i < ATTEMPTS && !done; i++)
		done = attempt(it, &attempts[i]);
	return done;
}

int hawser__friction_warm(struct hawser_friction *of, double (*u)[3],
                          struct hawser_friction_counts *counts,
                          const struct hawser_friction_options *options)
{
	struct iteration it = {.of = of, .u = u, .tolerance = options->tolerance, .most = options->most};
	int done = finish(&it, 1);

	counts->iterations = it.count;
	return done;
}

enum hawser_status hawser__friction_newton(struct hawser_friction *of, double (*u)[3],
                                           struct hawser_friction_counts *counts,
                                           const struct hawser_friction_options *options,
                                           struct hawser_report *report)
{
	struct iteration it = {.of = of, .u = u, .tolerance = options->tolerance, .most = options->most,
	                       .count = counts->iterations};
	int done = cold(&it);
	double error = it.at.error/it.at.scale;

	counts->iterations = it.count;
	if (done)
		return HAWSER_OK;
	return hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, "friction", it.count, error,
	                       "contact and friction: not solved in %d iterations, residual %.2e%s; make "
	                       "the step shorter", it.count, error,
	                       it.singular ? " (a matrix was singular)" : "");
}
