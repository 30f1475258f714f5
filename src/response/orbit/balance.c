/* response/orbit/balance.c - see balance.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "response/orbit/balance.h"
#include "rom/energy/exact.h"

/* Limits: number of harmonics of the load, and number of coefficients, which is the order of a dense
 * matrix that is factorised. */
#define MOST_HARMONICS 120
#define MOST_COEFFICIENTS 6000
/* Lowest limit of the harmonics of a full-order model: a taut span needs this many for 1e-6. */
#define LEAST_RESOLVED 24

static const struct hawser__orbit_ops ops;

static int highest(const struct hawser_rom *rom)
{
	int k = 1;

	for (int p = 0; p < rom->harmonics; p++)
		k = rom->harmonic[p].k > k ? rom->harmonic[p].k : k;
	return k;
}

int hawser__balance_lowest(const struct hawser_rom *rom)
{
	int k = 0;

	for (int p = 0; p < rom->harmonics; p++)
		if (rom->harmonic[p].k > 0 && (k == 0 || rom->harmonic[p].k < k))
			k = rom->harmonic[p].k;
	k = rom->base > k ? rom->base : k;
	return k > 1 ? k : 1;
}

enum hawser_status hawser__balance_init(struct hawser__balance *balance,
                                        const struct hawser_rom *rom, struct hawser_report *report)
{
	size_t n = (size_t)rom->n, size;
	enum hawser_status status = HAWSER_OK;

	memset(balance, 0, sizeof *balance);
	balance->strict = 1.0;
	balance->base.ops = &ops;
	balance->base.counted = 1;
	hawser__blocks_init(&balance->blocks);
	balance->top = (int)fmin(MOST_HARMONICS*hawser__balance_lowest(rom),
	                         (MOST_COEFFICIENTS/rom->n - 1)/2);
	if (balance->top < 2*highest(rom))
		balance->top = 2*highest(rom);
	size = n*(2*(size_t)balance->top + 1) + 1;
	balance->active = hawser__hold(&balance->hold, (size_t)balance->top + 1, n);
	balance->coarse = hawser__hold(&balance->hold, (size_t)balance->top + 1, n);
	balance->first = hawser__hold(&balance->hold, (size_t)balance->top + 2, sizeof(int));
	balance->list = hawser__hold(&balance->hold, ((size_t)balance->top + 1)*n, sizeof(int));
	balance->place = hawser__hold(&balance->hold, size, sizeof(int));
	balance->slot = hawser__hold(&balance->hold, size, sizeof(int));
	balance->given = hawser__hold(&balance->hold, size, sizeof(double));
	balance->at = hawser__hold(&balance->hold, size, sizeof(double));
	balance->wave = hawser__hold(&balance->hold, size, sizeof(double));
	balance->direction = hawser__hold(&balance->hold, size, sizeof(double));
	balance->row = hawser__hold(&balance->hold, size, sizeof(double));
	balance->kept = hawser__hold(&balance->hold, size, sizeof(double));
	balance->orbit = hawser__hold(&balance->hold, size, sizeof(double));
	balance->before = hawser__hold(&balance->hold, size, sizeof(double));
	balance->stiffness = hawser__hold(&balance->hold, n, sizeof(double));
	balance->damping = hawser__hold(&balance->hold, n, sizeof(double));
	balance->size_u = hawser__hold(&balance->hold, n, sizeof(double));
	balance->size_v = hawser__hold(&balance->hold, n, sizeof(double));
	if (balance->hold.short_of_memory)
		status = hawser__no_memory(report, "orbit");
	if (!status)
		status = hawser__orbit_init(&balance->base, rom, (int)size, report);
	if (!status)
		status = hawser__monodromy_init(&balance->monodromy, rom->n, report);
	if (!status) {
		hawser__balance_set_damping(balance);
		hawser__balance_seed(balance);
		status = hawser__balance_arrange(balance, report);
	}
	if (status)
		hawser__balance_release(balance);
	return status;
}

/* The harmonics of a full-order model end at its highest out-of-plane frequency, because its
 * basis resolves no faster waves. The frequencies above belong to stretching modes that the basis
 * does not resolve and that have hardly any damping. Harmonics near them would cause spurious
 * resonances, too narrow to be followed and, for a slack span, arbitrarily many. Expanded models
 * need no such limit, since their coordinates are modes that the basis resolves. */
static void balance_limit(struct hawser__balance *balance, double lowest)
{
	const struct hawser_rom *rom = balance->base.rom;
	double top = 0.0, most;

	for (int j = rom->exact ? rom->exact->in : rom->n; j < rom->n; j++)
		top = fmax(top, rom->K[(size_t)rom->exact->index[j]*(rom->n + 1)]);
	/* in space two thirds of the modes are waves across */
	if (rom->exact && rom->exact->in + rom->exact->out > rom->n)
		top = rom->K[(size_t)(2*rom->n/3)*((size_t)rom->n + 1)];
	most = fmax(fmax(LEAST_RESOLVED, 2*highest(rom)), ceil(sqrt(top)/lowest));
	balance->limited = top > 0.0 && most < balance->top;
	if (balance->limited)
		balance->top = (int)most;
}

void hawser__balance_release(struct hawser__balance *balance)
{
	hawser__hold_clear(&balance->hold);
	free(balance->other_samples);
	free(balance->other_defect);
	free(balance->basis);
	free(balance->base.samples);
	free(balance->force);
	free(balance->tangent);
	free(balance->work);
	free(balance->defect);
	free(balance->by_omega);
	free(balance->T);
	free(balance->rates);
	free(balance->slope);
	free(balance->shift);
	free(balance->resist);
	free(balance->matrix);
	free(balance->pivot);
	free(balance->rhs);
	free(balance->row_scale);
	free(balance->col_scale);
	free(balance->lu);
	free(balance->krylov);
	free(balance->flexible);
	free(balance->image);
	free(balance->cause);
	free(balance->effect);
	free(balance->moved);
	free(balance->border);
	free(balance->near);
	free(balance->rest);
	free(balance->free);
	free(balance->top_block);
	free(balance->top_factors);
	free(balance->top_pivot);
	hawser__blocks_release(&balance->blocks);
	hawser__monodromy_release(&balance->monodromy);
	hawser__orbit_free(&balance->base);
	memset(balance, 0, sizeof *balance);
}

static void clear(struct hawser__orbit *orbit)
{
	hawser__balance_release((struct hawser__balance *)orbit);
	free(orbit);
}

/* Mean over the period of u and v, by Parseval; shooting takes the mean over its nodes. */
static void metric(struct hawser__orbit *orbit, const double *y)
{
	struct hawser__balance *balance = (struct hawser__balance *)orbit;
	int n = orbit->n, last = orbit->size - 1;
	double omega = hawser__orbit_omega(orbit, y), sum = 0.0;

	for (int j = 0; j < n; j++) {
		double u = orbit->freely ? 0.0 : y[j]*y[j], v = 0.0;

		for (int h = 1; h <= balance->top; h++) {
			double a = y[hawser__cos(n, h, j)], b = y[hawser__sin(n, h, j)];

			u += 0.5*(a*a + b*b);
			v += 0.5*(a*a + b*b)*h*h*omega*omega;
		}
		balance->size_u[j] = sqrt(u);
		balance->size_v[j] = sqrt(v);
		sum += u + v;
	}
	/* The size of an orbit at rest (parametric excitation only) is 0. */
	orbit->X = sum > 0.0 ? sqrt(sum) : 1.0;
	for (int j = 0; j < n; j++) {
		double u, v;

		u = balance->size_u[j] = fmax(balance->size_u[j], HAWSER_SCALE_FLOOR*orbit->X);
		v = balance->size_v[j] = fmax(balance->size_v[j], HAWSER_SCALE_FLOOR*orbit->X);
		orbit->weight[j] = 1.0/(u*u*2*n);
		for (int h = 1; h <= balance->top; h++)
			orbit->weight[hawser__cos(n, h, j)] = orbit->weight[hawser__sin(n, h, j)] =
				0.5*(1.0/(u*u) + h*h*omega*omega/(v*v))/(2*n);
	}
	orbit->W = HAWSER_OMEGA_WIDTH*hawser__orbit_extent(orbit, y);
	orbit->weight[last] = 1.0/(orbit->W*orbit->W);
}

/* Defect of an active pair as the rms of a state: divided by its stiffness, but not near resonance,
 * because the inverse of the Jacobian accounts for the resonance. */
static double defect_of(const struct hawser__balance *balance, int h, int j, double omega)
{
	int n = balance->base.n;
	double c = balance->defect[hawser__cos(n, h, j)];
	double s = h ? balance->defect[hawser__sin(n, h, j)] : 0.0, w2 = h*h*omega*omega;

	return sqrt((c*c + s*s)*(h ? 0.5 : 1.0)*(1.0 + w2))/(fabs(balance->stiffness[j]) + w2);
}

static double defects(struct hawser__orbit *orbit, const double *y, int derive)
{
	struct hawser__balance *balance = (struct hawser__balance *)orbit;
	int n = orbit->n;
	double omega = hawser__orbit_omega(orbit, y), solved = 0.0, missing = 0.0, beyond = 0.0;

	if (hawser__orbit_place(orbit, y[orbit->size - 1]))
		return NAN;
	if (orbit->freely) /* of the model at another parameter */
		hawser__balance_set_damping(balance);
	hawser__balance_evaluate(balance, y, derive);
	for (int h = 0; h <= balance->reach; h++)
		for (int j = 0; j < n; j++) {
			int on = h <= balance->order && balance->active[h*n + j];
			double d = on ? defect_of(balance, h, j, omega)
			              : hawser__balance_missing(balance, NULL, h, j, omega);

			*(on ? &solved : h <= balance->top ? &missing : &beyond) += d*d;
		}
	balance->open = sqrt(missing);
	orbit->mesh = sqrt(missing + beyond);
	orbit->cost.stages += orbit->rows;
	if (derive)
		orbit->cost.flows++;
	else
		orbit->cost.maps++;
	return sqrt(solved)/orbit->X;
}

/* Leave out the multiplier of a cycle that is 1: the nearest to it. */
static void take_trivial(struct hawser__orbit *orbit)
{
	int least = 0;

	for (int i = 1; i < orbit->m; i++)
		if (hypot(orbit->log_modulus[i], orbit->argument[i]) <
		    hypot(orbit->log_modulus[least], orbit->argument[least]))
			least = i;
	orbit->trivial = hypot(orbit->log_modulus[least], orbit->argument[least]);
	for (int i = least; i + 1 < orbit->m; i++) {
		orbit->log_modulus[i] = orbit->log_modulus[i + 1];
		orbit->argument[i] = orbit->argument[i + 1];
		orbit->kind[i] = orbit->kind[i + 1];
	}
	orbit->kind[orbit->m - 1] = 0.0;
	hawser__orbit_idle(orbit, orbit->m - 1);
}

static enum hawser_status multipliers(struct hawser__orbit *orbit, struct hawser_report *report)
{
	struct hawser__balance *balance = (struct hawser__balance *)orbit;
	enum hawser_status status;

	hawser__balance_transform(balance);
	status = hawser__monodromy_multipliers(&balance->monodromy, orbit->log_modulus, orbit->argument,
	                                       orbit->rom, balance->T, balance->spread,
	                                       hawser__orbit_omega(orbit, balance->at), report);
	orbit->cost.dense += balance->monodromy.operations;
	balance->monodromy.operations = 0.0;
	orbit->multiplier_error = balance->monodromy.neglected;
	orbit->product_error = balance->monodromy.loss;
	orbit->product_round_off = balance->monodromy.round_off;
	if (status)
		return status;
	memcpy(orbit->kind, balance->monodromy.kind, (size_t)orbit->m*sizeof(double));
	if (orbit->freely)
		take_trivial(orbit);
	else
		hawser__orbit_determinant(orbit, balance->turn);
	return HAWSER_OK;
}

/* The cosines and sines of a cycle that is shifted along its motion change into each other. */
static void shift(struct hawser__orbit *orbit, double *dy, const double *y)
{
	const struct hawser__balance *balance = (const struct hawser__balance *)orbit;
	int n = orbit->n;

	memset(dy, 0, (size_t)orbit->size*sizeof *dy);
	for (int h = 1; h <= balance->top; h++)
		for (int j = 0; j < n; j++) {
			dy[hawser__cos(n, h, j)] = h*y[hawser__sin(n, h, j)];
			dy[hawser__sin(n, h, j)] = -h*y[hawser__cos(n, h, j)];
		}
}

static int parts(struct hawser__orbit *orbit, double **defect, double **column)
{
	struct hawser__balance *balance = (struct hawser__balance *)orbit;

	*defect = balance->defect;
	*column = balance->by_omega;
	return (2*balance->reach + 1)*orbit->n;
}

static void add_wave(struct hawser__orbit *orbit, double *y, const double *pq, int k, double omega)
{
	int n = orbit->n;

	(void)omega;
	for (int j = 0; j < n; j++) {
		y[hawser__cos(n, k, j)] += pq[j];
		y[hawser__sin(n, k, j)] += pq[n + j];
	}
}

static void state(const struct hawser__orbit *orbit, double *x, const double *y)
{
	const struct hawser__balance *balance = (const struct hawser__balance *)orbit;
	int n = orbit->n;
	double omega = hawser__orbit_omega(orbit, y);

	for (int j = 0; j < n; j++) {
		x[j] = y[j];
		x[n + j] = 0.0;
		for (int h = 1; h <= balance->top; h++) {
			x[j] += y[hawser__cos(n, h, j)];
			x[n + j] += h*omega*y[hawser__sin(n, h, j)];
		}
	}
}

static const struct hawser__orbit_ops ops = {
	metric, defects, hawser__balance_factor, hawser__balance_solve,
	hawser__balance_error, multipliers, hawser__balance_refine, hawser__balance_relax,
	hawser__balance_enrich, hawser__balance_sharpen, add_wave, hawser__balance_from_state, state,
	clear, NULL, NULL, parts, shift,
};

static enum hawser_status open_method(struct hawser__orbit **orbit, const struct hawser_rom *rom,
                                      const struct hawser_frf_options *options,
                                      struct hawser_report *report)
{
	struct hawser__balance *balance = malloc(sizeof *balance);
	enum hawser_status status;

	*orbit = NULL;
	if (!balance)
		return hawser__no_memory(report, "frf");
	status = hawser__balance_init(balance, rom, report);
	if (!status)
		balance_limit(balance, fmin(options->from, options->to));
	if (status)
		free(balance);
	else
		*orbit = &balance->base;
	return status;
}

/* The steps of shooting follow the fastest coordinate. The steps of the multipliers of harmonic
 * balance follow it only up to a limit (monodromy.h). Below that limit shooting takes a quarter to
 * three quarters of the time of harmonic balance (1 to 20 coordinates), above it five times as long
 * and more (24 to 60). So it is with a coordinate that decays as fast (the shape of the force of a
 * damper on a stay: 12 s against 2.5 s). */
static int suits(const struct hawser_rom *rom, const struct hawser_frf_options *options)
{
	double limit = HAWSER__FOLLOW*fmin(options->from, options->to), top = 0.0;

	for (int j = 0; j < rom->n; j++) {
		size_t own = (size_t)j*((size_t)rom->n + 1);

		top = fmax(top, fmax(sqrt(rom->K[own]), rom->D[own]));
	}
	return top > limit;
}

const struct hawser__orbit_method hawser__balance_method = {
	{"balance", "harmonic balance with as many harmonics as each coordinate needs",
	 "Cameron and Griffin 1989; Krack and Gross 2019", 0},
	open_method, suits,
};
