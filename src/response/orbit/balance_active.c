/* response/orbit/balance_active.c - selection of the active pairs of an orbit (harmonic, coordinate).
 *
 * The defect of an inactive pair, divided by its linear dynamic stiffness
 *
 *   |(T_jj - (h Omega)^2) + i h Omega D_jj|        T_jj: mean over the period
 *
 * is the missing amplitude to first order. The root sum of squares of the missing amplitudes over
 * the orbit's size is the discretisation error, `mesh`. If it exceeds the tolerance, the pairs with
 * the largest missing amplitudes are activated until the rest is a quarter of the tolerance. The
 * pairs with the smallest amplitudes are dropped while the rest stays below a tenth of the
 * tolerance, so that a dropped pair is not soon needed again.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "response/orbit/balance.h"
#include "response/time/flow.h"
#include "response/time/planner.h"
#include "rom/energy/kernel.h"
#include "rom/terms/terms.h"

#define LEFT_OUT 0.25  /* error of the inactive pairs after activation, relative to the tolerance */
#define CUT_BACK 0.1   /* the same after pairs are dropped */
#define AHEAD 0.1      /* arclength over which a part that grows is kept; chosen */
#define SHARPER 0.03   /* error of the finer discretisation relative to that of the coarser one */
#define STRICTEST 1e-3 /* factor on the tolerance below which all pairs are active; chosen */
#define EASY 5e-3      /* estimated error below which this factor may return to 1; chosen */
#define FINEST 1e-14   /* smallest amplitude of a pair above round-off, relative to the orbit */
#define UNRESOLVED 0.01 /* largest part in harmonics that the basis does not resolve, relative to
                         * the orbit */
#define LEAST_STIFFNESS 1e-3 /* least dynamic stiffness (undamped resonance), relative to its terms */
/* Cost of an operation in blocks over that in a large matrix, including the products that a
 * factorisation by blocks needs. Of 1.5, 6 and 15, the value 6 took the least time for responses of
 * 10, 13, 17 and 30 coordinates, by up to 13 %. */
#define BLOCKS_SLOWER 6.0
#define BLOCKS_FROM 150 /* unknowns: a smaller matrix is factorised in less than a millisecond */
/* Number of highest harmonics that are corrected separately (balance_solve.c), because collocation
 * couples them to harmonics that the balanced equations do not have. This coupling decreases by a
 * factor of ten in one or two harmonics. In wide motions, which take two to three times as many
 * iterations, one more saves a quarter of them; elsewhere it takes 5 % longer than it saves. */
#define TOP 4
#define NOTHING 1e-15   /* missing amplitude of pairs that symmetry excludes, relative to the orbit */

/* --- layout --- */

void hawser__balance_seed(struct hawser__balance *balance)
{
	const struct hawser_rom *rom = balance->base.rom;
	int n = rom->n;

	for (int p = 0; p < rom->harmonics; p++) {
		const struct hawser_harmonic *harmonic = &rom->harmonic[p];
		unsigned char *on = balance->active + harmonic->k*n;

		for (int j = 0; harmonic->f && j < n; j++)
			on[j] |= harmonic->f[j] != 0.0;
		for (int pass = 0; pass < n; pass++)
			for (int e = 0; e < n*n; e++)
				if (on[e%n] && (rom->K[e] != 0.0 || rom->D[e] != 0.0))
					on[e/n] = 1;
	}
}

static int list_pairs(struct hawser__balance *balance)
{
	int n = balance->base.n, count = 0, unknowns = 0, *slot = balance->slot;

	balance->order = 0;
	for (int i = 0; i < balance->base.size; i++)
		balance->place[i] = -1;
	for (int h = 0; h <= balance->top; h++) {
		balance->first[h] = count;
		for (int j = 0; j < n; j++)
			if (balance->active[h*n + j]) {
				balance->list[count++] = j;
				slot[unknowns++] = hawser__cos(n, h, j);
				balance->order = h;
			}
		for (int q = balance->first[h]; h && q < count; q++)
			slot[unknowns++] = hawser__sin(n, h, balance->list[q]);
	}
	balance->first[balance->top + 1] = count;
	for (int i = 0; i < unknowns; i++)
		balance->place[slot[i]] = i;
	return unknowns;
}

/* Whether blocks are factorised faster than a matrix of `unknowns`. */
static int blocks_pay(const struct hawser__balance *balance, double unknowns)
{
	return !balance->dense && unknowns >= BLOCKS_FROM &&
	       BLOCKS_SLOWER*hawser__blocks_cost(balance) < 2.0/3.0*pow(unknowns, 3.0);
}

static void fill_basis(struct hawser__balance *balance)
{
	int rows = balance->base.rows, columns = 2*balance->width + 1;

	for (int i = 0; i < rows; i++)
		balance->basis[(size_t)i*columns] = 1.0;
	/* multiples of an angle of the grid are angles of the grid */
	for (int i = 0; i < rows; i++) {
		double c = cos(2.0*M_PI*i/rows), s = sin(2.0*M_PI*i/rows);

		balance->force[2*i] = c;
		balance->force[2*i + 1] = s;
	}
	for (int i = 0; i < rows; i++)
		for (int h = 1; h <= balance->width; h++) {
			int turn = (int)((long)i*h%rows);

			balance->basis[(size_t)i*columns + 2*h - 1] = balance->force[2*turn];
			balance->basis[(size_t)i*columns + 2*h] = balance->force[2*turn + 1];
		}
}

/* Allocate `count` values; old values are lost. */
static int room(double **array, size_t count)
{
	free(*array);
	*array = malloc((count + 1)*sizeof **array);
	return *array == NULL;
}

static int terms_room(struct hawser__balance *balance, size_t rows, size_t n)
{
	size_t series = (2*(size_t)balance->spread + 1)*n*n;
	int failed = room(&balance->rates, rows*n) | room(&balance->slope, rows*n*n) |
	             room(&balance->shift, rows*n) | room(&balance->resist, series);

	balance->monodromy.resist = balance->resist;
	balance->monodromy.resist_order = 0;
	if (!failed) /* until the first derivatives */
		memset(balance->resist, 0, series*sizeof(double));
	return failed;
}

static int make_room(struct hawser__balance *balance, int unknowns)
{
	size_t n = (size_t)balance->base.n, rows = (size_t)balance->base.rows;
	size_t square = (size_t)unknowns + 1, wide = (2*(size_t)balance->reach + 1)*n, top;

	free(balance->pivot);
	balance->pivot = malloc(square*sizeof(int));
	if (balance->blockwise) {
		balance->top_from = (int)fmax(0.0, balance->order - TOP + 1 - balance->top_more);
		balance->top_count = hawser__balance_top(balance, NULL, balance->top_from);
		top = (size_t)balance->top_count;
		free(balance->top_pivot);
		free(balance->top_factors);
		balance->top_pivot = malloc(square*sizeof(int));
		balance->top_factors = malloc(((top + 1)*top + 1)*sizeof(float));
		if (room(&balance->top_block, top*top) | !balance->top_pivot | !balance->top_factors)
			return 1;
	}
	return room(&balance->basis, rows*(2*(size_t)balance->width + 1)) |
	       room(&balance->base.samples, rows*n) | room(&balance->force, rows*(n + 2)) |
	       room(&balance->tangent, rows*n*n) |
	       room(&balance->work, hawser__rom_tangents_work(balance->base.rom, (int)rows)) |
	       room(&balance->defect, wide) | room(&balance->by_omega, wide) |
	       room(&balance->other_samples, rows*n) | room(&balance->other_defect, wide) |
	       room(&balance->T, (2*(size_t)balance->spread + 1)*n*n) |
	       (balance->more && terms_room(balance, rows, n)) |
	       room(&balance->rhs, 2*square) | room(&balance->krylov, (HAWSER__KRYLOV + 1)*square) |
	       room(&balance->flexible, HAWSER__KRYLOV*square) |
	       room(&balance->cause, HAWSER__LEARNED*square) |
	       room(&balance->effect, HAWSER__LEARNED*square) | room(&balance->image, wide) |
	       room(&balance->moved, 2*rows*n) | room(&balance->border, square) |
	       room(&balance->near, square) | room(&balance->rest, 3*square) |
	       room(&balance->free, square) |
	       room(&balance->row_scale, square) | room(&balance->col_scale, square) |
	       (balance->blockwise ? hawser__blocks_arrange(&balance->blocks, balance)
	                           : hawser__balance_matrix_room(balance)) |
	       !balance->pivot;
}

int hawser__balance_matrix_room(struct hawser__balance *balance)
{
	size_t square = (size_t)balance->unknowns + 1;

	return room(&balance->matrix, square*square) | room(&balance->lu, square*square);
}

enum hawser_status hawser__balance_arrange(struct hawser__balance *balance,
                                           struct hawser_report *report)
{
	int unknowns = list_pairs(balance), k = 1, samples;

	for (int p = 0; p < balance->base.rom->harmonics; p++)
		if (balance->base.rom->harmonic[p].k > k)
			k = balance->base.rom->harmonic[p].k;
	balance->unknowns = unknowns;
	balance->factored = balance->direct = balance->learned = 0;
	balance->reach = balance->order + 2*k;
	balance->spread = k > 2*balance->order ? k : 2*balance->order;
	samples = 3*balance->order + balance->reach + 1;
	balance->more = hawser__rom_more(balance->base.rom) || balance->base.rom->drag;
	hawser__balance_reach(balance, &samples, &balance->spread);
	balance->width = balance->reach > balance->spread ? balance->reach : balance->spread;
	balance->base.rows = hawser__planner_rows(samples);
	balance->base.resolution = 2*balance->order + 1;
	balance->blockwise = blocks_pay(balance, unknowns);
	if (make_room(balance, unknowns))
		return hawser__no_memory(report, "orbit");
	fill_basis(balance);
	for (int i = 0; i <= unknowns; i++) /* not orthogonal to any structured vector of M */
		balance->near[i] = (1.0 + 0.5*cos(2.385*i))/sqrt(unknowns + 1.0);
	return HAWSER_OK;
}

/* --- missing pairs --- */

double hawser__balance_missing(const struct hawser__balance *balance, double *answer, int h, int j,
                               double omega)
{
	int n = balance->base.n;
	double c = balance->defect[hawser__cos(n, h, j)];
	double s = h ? balance->defect[hawser__sin(n, h, j)] : 0.0, w2 = h*h*omega*omega;
	double T = balance->stiffness[j], damp = h*omega*balance->damping[j];
	double resists = fmax(hypot(T - w2, damp), LEAST_STIFFNESS*(fabs(T) + w2));

	if (answer && resists > 0.0) {
		answer[0] = -((T - w2)*c - damp*s)/(resists*resists);
		answer[1] = -(damp*c + (T - w2)*s)/(resists*resists);
	}
	if (c == 0.0 && s == 0.0)
		return 0.0;
	return sqrt((c*c + s*s)*(h ? 0.5 : 1.0)*(1.0 + w2))/resists;
}

double hawser__balance_amplitude(const struct hawser__balance *balance, int h, int j)
{
	int n = balance->base.n;
	double omega = hawser__orbit_omega(&balance->base, balance->at);
	double c = balance->at[hawser__cos(n, h, j)];
	double s = h ? balance->at[hawser__sin(n, h, j)] : 0.0;

	return sqrt((c*c + s*s)*(h ? 0.5 : 1.0)*(1.0 + h*h*omega*omega));
}

/* The same, at least of the change of this part a little further along the branch. Beside a branch
 * point parts are small with the new motion, but without them it would begin elsewhere. */
static double importance(const struct hawser__balance *balance, int h, int j)
{
	int n = balance->base.n;
	const double *t = balance->base.tangent;
	double omega = hawser__orbit_omega(&balance->base, balance->at), c, s;

	if (!t)
		return hawser__balance_amplitude(balance, h, j);
	c = t[hawser__cos(n, h, j)];
	s = h ? t[hawser__sin(n, h, j)] : 0.0;
	return fmax(hawser__balance_amplitude(balance, h, j),
	            AHEAD*sqrt((c*c + s*s)*(h ? 0.5 : 1.0)*(1.0 + h*h*omega*omega)));
}

/* The largest level for which the missing pairs below it add up to at most `part`. */
static double adding_level(const struct hawser__balance *balance, double omega, double part)
{
	int n = balance->base.n;
	double level = part, sum = INFINITY;

	while (sum > part*part && level > 0.0) {
		sum = 0.0;
		for (int h = 0; h <= balance->reach && h <= balance->top; h++)
			for (int j = 0; j < n; j++) {
				int on = h <= balance->order && balance->active[h*n + j];
				double d = on ? 0.0 : hawser__balance_missing(balance, NULL, h, j, omega);

				sum += d < level ? d*d : 0.0;
			}
		level *= 0.5;
	}
	return 2.0*level;
}

/* The largest level for which dropping the active pairs below it causes an error of at most `part`;
 * 0: none. */
static double dropping_level(const struct hawser__balance *balance, double part)
{
	int n = balance->base.n, pairs = (balance->order + 1)*n;
	double level = part;

	for (int i = 0; i < 40 && balance->open < part; i++, level *= 0.5) {
		double sum = pow(balance->open, 2);

		for (int e = 0; e < pairs; e++) {
			double d = balance->active[e] ? importance(balance, e/n, e%n) : 0.0;

			sum += d < level ? d*d : 0.0;
		}
		if (sum <= part*part)
			return level;
	}
	return 0.0;
}

static enum hawser_status too_many(const struct hawser__balance *balance, double tolerance,
                                   double omega, struct hawser_report *report)
{
	const struct hawser__orbit *orbit = &balance->base;
	double part = orbit->mesh/orbit->X;

	if (balance->limited)
		return hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, "frf", 0, part,
		                       "at Omega %.9g%s the motion has faster parts than the basis of "
		                       "this full-order model resolves (%.2g of it beyond harmonic %d): "
		                       "the cable nears slackness, or an internal resonance with short "
		                       "waves; lower the load, narrow the range, or take more functions "
		                       "(model.basis)", HAWSER_SHOWN(orbit->rom, omega), part,
		                       balance->top);
	return hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, "frf", 0, part,
	                       "the orbit at Omega %.9g%s needs more than %d harmonics for tolerance "
	                       "%.1g (estimated error %.2g): loosen --tolerance, or use --method "
	                       "shooting", HAWSER_SHOWN(orbit->rom, omega), balance->top, tolerance,
	                       part);
}

void hawser__balance_fill_up(struct hawser__balance *balance, double omega)
{
	int n = balance->base.n, unknowns = list_pairs(balance);

	if (!blocks_pay(balance, unknowns))
		return;
	for (int e = 0; e < (balance->order + 1)*n; e++)
		if (!balance->active[e] && hawser__balance_missing(balance, NULL, e/n, e%n, omega) >
		                           NOTHING*balance->base.X)
			balance->active[e] = 1;
}

/* Activates the missing pairs but for those whose amplitudes add up to at most `part`. */
static void activate(struct hawser__balance *balance, double omega, double part)
{
	int n = balance->base.n;
	double level = adding_level(balance, omega, part);

	for (int h = 0; h <= balance->reach && h <= balance->top; h++)
		for (int j = 0; j < n; j++)
			if (!balance->active[h*n + j] &&
			    hawser__balance_missing(balance, NULL, h, j, omega) >= level)
				balance->active[h*n + j] = 1;
}

enum hawser_status hawser__balance_refine(struct hawser__orbit *orbit, int *again, double tolerance,
                                          double omega, struct hawser_report *report)
{
	struct hawser__balance *balance = (struct hawser__balance *)orbit;

	*again = balance->open > balance->strict*tolerance*orbit->X;
	if (orbit->mesh > (balance->limited ? UNRESOLVED : tolerance)*orbit->X && !*again)
		return too_many(balance, tolerance, omega, report);
	if (!*again)
		return HAWSER_OK;
	activate(balance, omega, LEFT_OUT*balance->strict*tolerance*orbit->X);
	hawser__balance_fill_up(balance, omega);
	return hawser__balance_arrange(balance, report);
}

enum hawser_status hawser__balance_relax(struct hawser__orbit *orbit, double tolerance,
                                         struct hawser_report *report)
{
	struct hawser__balance *balance = (struct hawser__balance *)orbit;
	int n = orbit->n, dropped = 0, from = 0, pairs = (balance->order + 1)*n;
	double level;

	if (balance->doubt < EASY)
		balance->strict = fmin(1.0, 2.0*balance->strict);
	level = dropping_level(balance, CUT_BACK*balance->strict*tolerance*orbit->X);
	/* in blocks only complete harmonics change the cost */
	for (int e = 0; balance->blockwise && e < pairs; e++)
		if (balance->active[e] && importance(balance, e/n, e%n) >= level)
			from = (e/n + 1)*n;
	for (int e = from; e < pairs; e++)
		dropped += balance->active[e] && importance(balance, e/n, e%n) < level;
	if (20*dropped <= balance->unknowns)
		return HAWSER_OK;
	for (int e = from; e < pairs; e++)
		if (balance->active[e] && importance(balance, e/n, e%n) < level)
			balance->active[e] = 0;
	return hawser__balance_arrange(balance, report);
}

enum hawser_status hawser__balance_enrich(struct hawser__orbit *orbit, int most,
                                          struct hawser_report *report)
{
	struct hawser__balance *balance = (struct hawser__balance *)orbit;
	int n = orbit->n, order = balance->order < balance->top ? balance->order + 1 : balance->top;

	if (!most && balance->open > 0.0 && balance->strict > STRICTEST) {
		balance->strict *= SHARPER;
		activate(balance, hawser__orbit_omega(orbit, balance->at), SHARPER*balance->open);
		return hawser__balance_arrange(balance, report);
	}
	memset(balance->active, 1, (size_t)(order + 1)*n);
	return hawser__balance_arrange(balance, report);
}

/* With `on`, activate every pair whose missing amplitude exceeds a part of the total error, and
 * refine the steps of the multipliers. Fails if the missing pairs are above the highest harmonic. */
enum hawser_status hawser__balance_sharpen(struct hawser__orbit *orbit, int on,
                                           struct hawser_report *report)
{
	struct hawser__balance *balance = (struct hawser__balance *)orbit;
	size_t pairs = ((size_t)balance->top + 1)*(size_t)orbit->n;
	double omega = hawser__orbit_omega(orbit, balance->at), level;

	if (!on) {
		balance->monodromy.sharper = 0;
		memcpy(balance->active, balance->coarse, pairs);
		return hawser__balance_arrange(balance, report);
	}
	level = fmax(SHARPER*orbit->mesh, FINEST*orbit->X);
	if (pow(orbit->mesh, 2) - pow(balance->open, 2) > level*level)
		return HAWSER_ERR_CONVERGENCE;
	memcpy(balance->coarse, balance->active, pairs);
	balance->monodromy.sharper = 1;
	activate(balance, omega, fmax(SHARPER*balance->open, FINEST*orbit->X));
	return hawser__balance_arrange(balance, report);
}
