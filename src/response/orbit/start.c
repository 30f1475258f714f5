/* response/orbit/start.c - see start.h.
 *
 * The linear response to a harmonic s f cos(k tau) (or sin) is u = p cos(k tau) + q sin(k tau) with
 *
 *      [ K - w^2     w D   ] [p]   [f]
 *      [  -w D     K - w^2 ] [q] = [0]          w = k Omega        (sin: the right side is [0 f])
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <float.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/hold.h"
#include "core/report.h"
#include "response/orbit/balance.h"
#include "response/orbit/load.h"
#include "response/orbit/shooting.h"
#include "response/orbit/start.h"

#define SMALLEST_LOAD_STEP 1e-4 /* fraction of the load: if a smaller step is needed, there is a
                                 * fold in the load; chosen */
#define SETTLE_PERIODS 400 /* periods of the motion from rest before the attempt ends; chosen */
#define SETTLE_FLOPS 1e11 /* operations, 5 s with 16 coordinates and 13 s with 5, as counted, after
                           * which it ends too, and */
#define SETTLE_EXACT 4e9  /* the same with exact energy, whose products are short: some take 1e9 a
                           * period, and the curves of detour.c lead there sooner; chosen */
#define SETTLE_TRY 20 /* periods between two attempts of Newton's method; chosen */
#define FAR 0.2 /* distance from the linear response, relative to it, from which on another orbit may
                 * have been found; chosen */
#define STEEP 2.0 /* relative change of a coordinate with the load, over that of the load, from which on
                   * it is near a fold or a resonance: it has not passed two folds; chosen */
/* Where only the orbit that grows out of rest is wanted; chosen: */
#define BOLD 0.5        /* first step of the load */
#define AIM 0.1         /* distance of an orbit from the predicted one, relative to it, for which the
                         * next step is meant */
#define FASTER 4.0      /* largest ratio of two steps */
#define NEAR 0.3        /* largest distance of an orbit from the scaled one before, relative to it: one
                         * that is farther may be another orbit */
#define LOST 0.01 /* largest relative effect of round-off on the forces; chosen */

/* Fill matrix [2n][2n] row-major and pq [2n] for one harmonic. */
static void linear_system(double *matrix, double *pq, const struct hawser_rom *rom,
                          const struct hawser_harmonic *harmonic, double omega)
{
	int n = rom->n, m = 2*n, shift = harmonic->phase == HAWSER_COS ? 0 : n;
	double w = harmonic->k*omega;

	memset(pq, 0, (size_t)m*sizeof *pq);
	for (int j = 0; j < n; j++) {
		pq[shift + j] = harmonic->f[j]*pow(omega, harmonic->omega_power);
		for (int k = 0; k < n; k++) {
			double stiff = rom->K[j*n + k] - (j == k ? w*w : 0.0), damp = w*rom->D[j*n + k];

			matrix[(size_t)j*m + k] = matrix[(size_t)(n + j)*m + n + k] = stiff;
			matrix[(size_t)j*m + n + k] = damp;
			matrix[(size_t)(n + j)*m + k] = -damp;
		}
	}
}

/* Whether the round-off of K - w^2, relative to K and w^2, changes the forces by more than a
 * hundredth of the loads: w is then an undamped resonance to the last digits. A condition number
 * would not show this, since stiff coordinates make it large in any case. */
static int undetermined(const double *pq, const struct hawser_rom *rom,
                        const struct hawser_harmonic *harmonic, double omega)
{
	int n = rom->n;
	double w = harmonic->k*omega, load = 0.0, lost = 0.0;

	for (int j = 0; j < n; j++) {
		double sum = w*w*(fabs(pq[j]) + fabs(pq[n + j]));

		for (int k = 0; k < n; k++)
			sum += fabs(rom->K[j*n + k])*(fabs(pq[k]) + fabs(pq[n + k]));
		lost = fmax(lost, DBL_EPSILON*sum);
		load = fmax(load, fabs(harmonic->f[j])*pow(omega, harmonic->omega_power));
	}
	return !(lost <= LOST*load);
}

static enum hawser_status linear_response(double *y, struct hawser__orbit *orbit,
                                          double omega, struct hawser_report *report)
{
	const struct hawser_rom *rom = orbit->rom;
	int m = orbit->m;
	double *matrix = malloc((size_t)m*m*sizeof *matrix), *pq = malloc((size_t)m*sizeof *pq);
	int *pivot = malloc((size_t)m*sizeof *pivot), info;
	enum hawser_status status = HAWSER_OK;

	if (!matrix || !pq || !pivot)
		status = hawser__no_memory(report, "frf");
	memset(y, 0, (size_t)(orbit->size - 1)*sizeof *y);
	for (int h = 0; !status && h < rom->harmonics; h++) {
		/* NOLINTNEXTLINE(clang-analyzer-core.uninitialized.Branch): all harmonics are filled */
		if (!rom->harmonic[h].f)
			continue;
		linear_system(matrix, pq, rom, &rom->harmonic[h], omega);
		info = LAPACKE_dgesv(LAPACK_ROW_MAJOR, m, 1, matrix, m, pivot, pq, 1);
		if (hawser__lapack_starved(info))
			status = hawser__no_memory(report, "frf");
		else if ((info || undetermined(pq, rom, &rom->harmonic[h], omega)) && hawser__rom_more(rom))
			continue; /* u = 0 need not be near the motion: its linear part says nothing */
		else if (info || undetermined(pq, rom, &rom->harmonic[h], omega))
			status = hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "frf",
			                      "the linear response at Omega %.9g%s is infinite "
			                      "(undamped resonance): start elsewhere, or add damping",
			                      HAWSER_SHOWN(rom, omega));
		else
			orbit->ops->add_wave(orbit, y, pq, rom->harmonic[h].k, omega);
	}
	free(matrix);
	free(pq);
	free(pivot);
	return status;
}

/* Newton's method at fixed Omega (the border is the direction of Omega), then on a discretisation
 * that is fine enough for the orbit: with a coarse one, increasing the load could lead to a
 * spurious orbit. Returns 1 if Newton's method fails, 2 if no discretisation is fine enough (see
 * the report), 3 when out of memory. */
static int correct_at(double *y, struct hawser__orbit *orbit,
                      struct hawser__correction *correction, double omega, double tolerance,
                      struct hawser_report *report)
{
	double *row = orbit->spare;
	enum hawser_status status;
	int again = 1;

	y[orbit->size - 1] = omega;
	while (again) {
		memset(row, 0, (size_t)orbit->size*sizeof *row);
		orbit->ops->metric(orbit, y);
		row[orbit->size - 1] = orbit->W;
		if (hawser__orbit_correct(orbit, y, correction, row, tolerance))
			return 1;
		status = orbit->ops->refine(orbit, &again, tolerance, omega, report);
		if (status)
			return status == HAWSER_ERR_MEMORY ? 3 : 2;
	}
	return 0;
}

/* The orbit at the whole load, or on the way there: `guess` corrected. Of a lone one an orbit that is
 * rough and near the guess comes first, since a fine one takes more harmonics. *growth becomes the
 * ratio of the next step to this one. Returns what correct_at does. */
static int correct_lone(double *y, struct hawser__orbit *orbit, double *growth,
                        struct hawser__correction *correction, const double *guess, double omega,
                        double tolerance, double rough, int whole,
                        struct hawser_report *report)
{
	int failed = correct_at(y, orbit, correction, omega, fmax(tolerance, rough), report);
	int count = orbit->size - 1;
	double off = failed ? 0.0 : hawser__orbit_distance(y, count, guess, count, orbit->n,
	                                                  fmax(tolerance, rough));

	if (failed || !(off <= NEAR))
		return failed ? failed : 1;
	*growth = fmin(FASTER, sqrt(AIM/fmax(off, DBL_EPSILON)));
	return whole ? correct_at(y, orbit, correction, omega, tolerance, report) : 0;
}

/* Along the way of another model: from its lowest load to its highest one in as few orbits as lead
 * there. Returns what correct_at does of the last orbit. */
static int follow(struct hawser__climb *climb, double *y, struct hawser__orbit *orbit,
                  struct hawser__correction *correction, double omega, double tolerance,
                  const struct hawser__raised *raised, struct hawser_report *report)
{
	const struct hawser__way *guide = raised->guide;
	int count = orbit->size - 1, top = guide->count - 1, here = -1, next = 0, failed = 0;

	while (here < top && here < next && failed < 2) {
		double load = guide->passed[next].load;

		hawser__load_set(&climb->weak, load);
		hawser__way_predict(y, guide, next, here, climb->good, count);
		memcpy(climb->guess, y, (size_t)count*sizeof *y);
		failed = correct_lone(y, orbit, &climb->growth, correction, climb->guess, omega, tolerance,
		                      raised->rough, load == 1.0, report);
		if (!failed) {
			failed = hawser__climb_pass(climb, y, load, orbit, raised);
			here = next;
			next = top;
		} else {
			next = here + (next - here)/2;
		}
	}
	return failed;
}

/* The orbit y at the whole load by the curve over it from the last orbit; returns what correct_at
 * does. */
static int round_up(double *y, struct hawser__climb *climb, struct hawser__orbit *orbit,
                    struct hawser__correction *correction, double omega, double tolerance,
                    const struct hawser__raised *raised, struct hawser_report *report)
{
	int failed = hawser__climb_arc(y, climb, orbit, correction, omega, raised, report);

	orbit->rom = &climb->weak.rom;
	hawser__load_set(&climb->weak, 1.0);
	y[orbit->size - 1] = omega;
	if (failed || climb->load == 1.0)
		return failed;
	failed = correct_at(y, orbit, correction, omega, tolerance, report);
	return failed ? failed : hawser__climb_pass(climb, y, 1.0, orbit, raised);
}

int hawser__start_spent(const struct hawser__orbit *orbit, const struct hawser__raised *raised)
{
	return raised->most > 0.0 && hawser_orbit_work(&orbit->cost, orbit->rom) > raised->most;
}

/* Increase the load from zero to its value, in steps that grow while Newton's method converges, from
 * the line through the last two orbits: with the last one scaled, steps of a full-order model with
 * harmonics of moving ends shrank to 1e-3.
 * *failed is that of correct_at. */
static enum hawser_status raise_load(double *y, struct hawser__orbit *orbit, int *failed,
                                     struct hawser__correction *correction, double omega,
                                     double tolerance, struct hawser__raised *raised,
                                     struct hawser_report *report)
{
	const struct hawser_rom *rom = orbit->rom;
	struct hawser__climb climb;
	enum hawser_status status = hawser__climb_open(&climb, orbit, raised->lone ? BOLD : 0.1, report);
	int rounds;

	if (status)
		goto done;
	/* cppcheck-suppress autoVariables ; until it has its own again, below */
	orbit->rom = &climb.weak.rom;
	*failed = !raised->guide ? 0 : follow(&climb, y, orbit, correction, omega, tolerance, raised,
	                                      report);
	/* at the whole load, an orbit before tells whether a fold is between */
	rounds = climb.load > 0.0 && (climb.load < 1.0 || climb.last_load > 0.0);
	while (*failed < 2 && !status && (climb.load < 1.0 || rounds)) {
		double next = fmin(1.0, climb.load + climb.step);

		if (rounds) {
			*failed = round_up(y, &climb, orbit, correction, omega, tolerance, raised, report);
			break;
		}
		hawser__load_set(&climb.weak, next);
		for (int i = 0; i + 1 < orbit->size; i++)
			y[i] = climb.load > 0.0 ? climb.good[i] + (climb.good[i] - climb.last[i])*
			                          (next - climb.load)/(climb.load - climb.last_load) : 0.0;
		if (climb.load == 0.0 && (status = linear_response(y, orbit, omega, report)))
			break;
		memcpy(climb.guess, y, (size_t)orbit->size*sizeof *y);
		*failed = raised->lone
		          ? correct_lone(y, orbit, &climb.growth, correction, climb.guess, omega, tolerance,
		                         raised->rough, next == 1.0, report)
		          : correct_at(y, orbit, correction, omega, tolerance, report);
		if (!*failed) {
			climb.step = climb.growth*(next - climb.load);
			*failed = hawser__climb_pass(&climb, y, next, orbit, raised);
		} else if (*failed == 1) {
			rounds = raised->lone && climb.load > 0.0;
			climb.step *= 0.5;
			if (climb.step < SMALLEST_LOAD_STEP || hawser__start_spent(orbit, raised))
				break;
		}
	}
	if (!status && *failed)
		status = *failed == 3 ? HAWSER_ERR_MEMORY : HAWSER_ERR_CONVERGENCE;
	if (status == HAWSER_ERR_CONVERGENCE && *failed == 1) {
		raised->load = climb.peak;
		raised->turned = hawser__climb_turned(&climb);
		if (climb.load > 0.0)
			orbit->ops->state(orbit, raised->x, climb.good);
	}
	orbit->rom = rom;
done:
	hawser__climb_close(&climb);
	return status;
}

/* Integrate from rest until the motion is periodic; start Newton's method from it at intervals. */
static enum hawser_status settle(double *y, struct hawser__orbit *orbit,
                                 struct hawser__correction *correction, double omega,
                                 double tolerance, struct hawser_report *report)
{
	const struct hawser_rom *rom = orbit->rom;
	int m = orbit->m, steps = hawser__shooting_steps(rom, omega, 1);
	struct hawser__stretch period = {.h = 2.0*M_PI/steps, .steps = steps, .count = 1};
	struct hawser__flow flow;
	double *x = calloc((size_t)m, sizeof *x);
	enum hawser_status status = hawser__flow_init(&flow, rom, report);
	double most = rom->exact ? SETTLE_EXACT : SETTLE_FLOPS;
	int found = 0, failed, periods = 0;

	if (!status && !x)
		status = hawser__no_memory(report, "frf");
	if (!status)
		periods = (int)fmin(SETTLE_PERIODS, most/(steps*hawser__flow_flops(&flow, 0)));
	if (periods < SETTLE_TRY)
		periods = 0;
	for (int p = 1; !status && !found && p <= periods; p++) {
		hawser__flow_map(&flow, x, NULL, &period, omega);
		if (!isfinite(cblas_dnrm2(m, x, 1)))
			break;
		if (p%SETTLE_TRY == 0 &&
		    !(status = orbit->ops->from_state(orbit, y, x, omega, report))) {
			failed = correct_at(y, orbit, correction, omega, tolerance, report);
			found = !failed;
			status = failed == 3 ? HAWSER_ERR_MEMORY : HAWSER_OK;
		}
	}
	hawser__flow_clear(&flow);
	free(x);
	return status || found ? status : HAWSER_ERR_CONVERGENCE;
}

/* dy [size]: Newton's step from the orbit y to where the load is 0, which is minus the load times the
 * slope of the orbit over it. */
static enum hawser_status unload(double *dy, const double *y, struct hawser__orbit *orbit,
                                 struct hawser_report *report)
{
	const struct hawser_rom *rom = orbit->rom;
	struct hawser__load none;
	enum hawser_status status = hawser__load_open(&none, rom, report);

	if (!status) {
		hawser__load_set(&none, 0.0);
		orbit->rom = &none.rom;
		(void)orbit->ops->defects(orbit, y, 0);
		orbit->rom = rom;
		orbit->ops->solve(orbit, dy, 0, 0.0);
		orbit->cost.solves++;
	}
	hawser__load_clear(&none);
	return status;
}

/* Whether coordinate j of the orbit y, by balance, is opposite to its linear response beside the motion
 * of the others, which may drive it against the load. beside [size]: scratch. */
static int opposed(double *beside, const double *y, struct hawser__orbit *orbit, int j, double omega,
                   double least)
{
	struct hawser__balance *balance = (struct hawser__balance *)orbit;
	int n = orbit->n, count = orbit->size - 1;

	memcpy(beside, y, (size_t)orbit->size*sizeof *y);
	for (int i = j; i < count; i += n)
		beside[i] = 0.0;
	(void)orbit->ops->defects(orbit, beside, 1);
	for (int h = 0; h <= balance->order; h++) {
		double answer[2] = {0.0, 0.0};

		(void)hawser__balance_missing(balance, answer, h, j, omega);
		beside[hawser__cos(n, h, j)] = answer[0];
		if (h > 0)
			beside[hawser__sin(n, h, j)] = answer[1];
	}
	return hawser__orbit_reversed(y, count, beside, count, n, j, least);
}

enum hawser_status hawser__start_reversed(double *size, const double *y, struct hawser__orbit *orbit,
                                          double omega, double from, double to,
                                          struct hawser_report *report)
{
	int n = orbit->n, count = orbit->size - 1, known = 0;
	double *linear = calloc(3*(size_t)orbit->size, sizeof *linear);
	double *dy = hawser__behind(linear, (size_t)orbit->size);
	double *beside = hawser__behind(dy, (size_t)orbit->size);
	double all = cblas_dnrm2(count, y, 1);
	enum hawser_status status = linear ? linear_response(linear, orbit, omega, report)
	                                   : hawser__no_memory(report, "frf");

	*size = 0.0;
	for (int j = 0; !status && j < n; j++) {
		double own = cblas_dnrm2(count/n, y + j, n);

		if (own >= to*all || (*size > 0.0 && own >= *size*all) ||
		    !hawser__orbit_reversed(y, count, linear, count, n, j, from*all))
			continue;
		if (!known)
			status = unload(dy, y, orbit, report);
		known = 1;
		if (!status && cblas_dnrm2(count/n, dy + j, n) < STEEP*own &&
		    opposed(beside, y, orbit, j, omega, from*all))
			*size = own/all;
	}
	free(linear);
	return status == HAWSER_ERR_NO_SOLUTION ? HAWSER_OK : status; /* a resonance without damping */
}

/* Whether y, known to `rough`, is far from the linear response. */
static enum hawser_status strayed(int *far, const double *y, struct hawser__orbit *orbit, double omega,
                                  double rough, struct hawser_report *report)
{
	double *linear = calloc((size_t)orbit->size, sizeof *linear);
	int count = orbit->size - 1;
	enum hawser_status status = linear ? linear_response(linear, orbit, omega, report)
	                                   : hawser__no_memory(report, "frf");

	if (!status)
		*far = !(hawser__orbit_distance(y, count, linear, count, orbit->n, rough) <= FAR);
	free(linear);
	return status;
}

enum hawser_status hawser__start(double *y, struct hawser__orbit *orbit,
                                 struct hawser__correction *correction, const double *start,
                                 double omega, double tolerance, struct hawser__raised *raised,
                                 struct hawser_report *report)
{
	const double rough = raised->lone ? fmax(tolerance, raised->rough) : tolerance;
	enum hawser_status status;
	int failed, far = 0;

	raised->load = -1.0;
	if (raised->slow || (raised->guide && !raised->way)) /* the linear response did not lead there */
		return raise_load(y, orbit, &failed, correction, omega, tolerance, raised, report);
	status = start ? orbit->ops->from_state(orbit, y, start, omega, report)
	               : linear_response(y, orbit, omega, report);
	if (status)
		return status;
	failed = correct_at(y, orbit, correction, omega, rough, report);
	if (failed == 3)
		return HAWSER_ERR_MEMORY;
	if (!failed && raised->lone && (status = strayed(&far, y, orbit, omega, rough, report)))
		return status;
	if (!failed && raised->lone && !far)
		failed = correct_at(y, orbit, correction, omega, tolerance, report);
	if (!failed && !far && raised->way && hawser__way_add(raised->way, 1.0, y, orbit->size - 1))
		failed = 3;
	if (failed != 1 && !far)
		return failed == 3 ? HAWSER_ERR_MEMORY : failed ? HAWSER_ERR_CONVERGENCE : HAWSER_OK;
	if (start)
		return hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, "frf",
		                       correction->iterations, correction->residual,
		                       "the given start does not lead to a periodic orbit at Omega "
		                       "%.9g%s (residual %.2g): it is to be a state at phase 0 of the "
		                       "load, as after whole periods",
		                       HAWSER_SHOWN(orbit->rom, omega), correction->residual);
	status = raise_load(y, orbit, &failed, correction, omega, tolerance, raised, report);
	if (status != HAWSER_ERR_CONVERGENCE || failed == 2 || raised->lone ||
	    hawser__start_spent(orbit, raised))
		return status;
	return settle(y, orbit, correction, omega, tolerance, report);
}
