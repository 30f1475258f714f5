/* response/monodromy.c - see monodromy.h.
 *
 *   s      nodes a step, 8          w     coordinates of the component at work
 *   h      step in time             a     mean damping of the component
 *
 * Displacements are scaled by their frequencies: the transition matrix of an undamped coordinate is
 * then a rotation, whatever its frequency, and the QR iteration is as accurate as it can be.
 *
 * The estimate. In a step of z = h w rad of an oscillator w, the last of the Legendre coefficients of
 * h x'' is 15 z j_7(z/2), about 5.8e-8 z^8; the error of the step is 2.2e-19 z^17 (from the Pade
 * approximation of exp). The first is seen, the second follows; for K that varies both are governed by
 * the same decay of the coefficients.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <cblas.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "response/floquet.h"
#include "response/monodromy.h"
#define S HAWSER__NODES
#define GOAL 1e-10           /* error of the multipliers' logarithms */
#define MOST_STEPS 400
#define LAST_COEFFICIENT 5.8e-8
#define STEP_ERROR 2.2e-19
#define SMALLEST (-1e5)      /* logarithm of a multiplier */
#define TURN 2.6             /* z for which the estimated error is within its goal */
#define AFFORDABLE 2e8       /* operations of a strict computation */
#define STRETCH 2.0          /* factors end where the logarithm of their norm exceeds this */
/* Of a stiff model not every coordinate is followed. Those that matter turn so far in a step that the
 * error of their logarithms is about 1e-6; what steps do to the others' phases does not matter. */
#define STIFF_TURN 4.8
#define STIFF_LEAST 12.0     /* times Omega: the least frequency taken to matter */

enum hawser_status hawser__monodromy_init(struct hawser__monodromy *monodromy, int n,
                                          struct hawser_report *report)
{
	size_t n2 = (size_t)n*n, wide = (size_t)S*n;
	double *next;

	memset(monodromy, 0, sizeof *monodromy);
	monodromy->n = n;
	monodromy->steps = 8;
	monodromy->follow = HAWSER__FOLLOW;
	hawser__collocation_make(&monodromy->gauss);
	hawser__collocation_indirect(&monodromy->gauss);
	monodromy->part = calloc(2*(size_t)n, sizeof(int));
	monodromy->pivot = calloc(wide, sizeof(int));
	monodromy->memory = next = calloc((size_t)n + 2*S*n2 + wide*wide + 2*(size_t)n*wide + 8*n2 +
	                                  8*n2*hawser__monodromy_factors(n) +
	                                  hawser__floquet_work(hawser__monodromy_factors(n), 2*n) +
	                                  (HAWSER__EIGEN_WORK + 2)*2*(size_t)n,
	                                  sizeof *next);
	monodromy->slow = calloc(2*(size_t)n, sizeof(int));
	monodromy->frequency = calloc(2*(size_t)n, sizeof(double));
	if (!monodromy->part || !monodromy->pivot || !next || !monodromy->slow ||
	    !monodromy->frequency) {
		hawser__monodromy_release(monodromy);
		return hawser__no_memory(report, "orbit");
	}
	monodromy->member = monodromy->part + n;
	monodromy->fast = monodromy->slow + n;
	monodromy->reach = monodromy->frequency + n;
	monodromy->scale = next;
	monodromy->stiff = next += n;
	monodromy->damp = next += S*n2;
	monodromy->matrix = next += S*n2;
	monodromy->rhs = next += wide*wide;
	monodromy->step = next += 2*(size_t)n*wide;
	monodromy->product = next += 4*n2;
	monodromy->factor = next += 4*n2;
	monodromy->floquet_work = next + 8*n2*hawser__monodromy_factors(n);
	return HAWSER_OK;
}

void hawser__monodromy_release(struct hawser__monodromy *monodromy)
{
	free(monodromy->part);
	free(monodromy->pivot);
	free(monodromy->table);
	free(monodromy->memory);
	free(monodromy->damping);
	free(monodromy->slow);
	free(monodromy->frequency);
	free(monodromy->room);
	memset(monodromy, 0, sizeof *monodromy);
}

/* --- coordinates that are coupled --- */

static int coupled(const struct hawser__variational *system, int e)
{
	size_t n2 = (size_t)system->n*system->n;

	for (int r = 0; r <= 2*system->order_d; r++)
		if (system->D[r*n2 + e] != 0.0)
			return 1;
	for (int r = 0; r <= 2*system->order; r++)
		if (system->K[r*n2 + e] != 0.0)
			return 1;
	return 0;
}

static void join(int *part, int n, int a, int b)
{
	int from = part[a] > part[b] ? part[a] : part[b], to = part[a] > part[b] ? part[b] : part[a];

	for (int j = 0; j < n; j++)
		if (part[j] == from)
			part[j] = to;
}

static void find_parts(struct hawser__monodromy *monodromy, const struct hawser__variational *system)
{
	int n = system->n, *part = monodromy->part, count = 0;

	for (int j = 0; j < n; j++)
		part[j] = j;
	for (int j = 0; j < n; j++)
		for (int k = 0; k < n; k++)
			if (part[j] != part[k] && coupled(system, j*n + k))
				join(part, n, j, k);
	for (int p = 0; p < n; p++)
		for (int j = 0; j < n; j++)
			if (part[j] == p)
				monodromy->member[count++] = j;
}

/* --- one step of one component --- */

struct component {
	const int *member;
	int n;          /* of all */
	int w;
	double damping; /* a */
	double h;       /* time */
};

/* K - a D/2 + a^2/4 and D - a of z at node i. */
static double stiff_at(const struct hawser__monodromy *monodromy, const struct component *c, int i,
                       int p, int q)
{
	size_t e = (size_t)i*c->n*c->n + (size_t)c->member[p]*c->n + c->member[q];

	return monodromy->stiff[e] - 0.5*c->damping*monodromy->damp[e] +
	       (p == q ? 0.25*c->damping*c->damping : 0.0);
}

static double damp_at(const struct hawser__monodromy *monodromy, const struct component *c, int i,
                      int p, int q)
{
	return monodromy->damp[(size_t)i*c->n*c->n + (size_t)c->member[p]*c->n + c->member[q]] -
	       (p == q ? c->damping : 0.0);
}

static void fill_system(struct hawser__monodromy *monodromy, const struct component *c)
{
	int w = c->w, wide = S*w;
	double h = c->h;

	memset(monodromy->matrix, 0, (size_t)wide*wide*sizeof(double));
	for (int i = 0; i < S; i++)
		for (int q = 0; q < w; q++)
			for (int p = 0; p < w; p++) {
				double k = stiff_at(monodromy, c, i, p, q);
				double d = damp_at(monodromy, c, i, p, q);
				double *at = monodromy->matrix + (size_t)q*wide + (size_t)i*w + p;
				double *rhs = monodromy->rhs + (size_t)q*wide + (size_t)i*w + p;

				for (int j = 0; j < S; j++)
					at[(size_t)j*w*wide] = h*h*monodromy->gauss.twice[i][j]*k +
					                       h*monodromy->gauss.once[i][j]*d;
				at[(size_t)i*w*wide] += p == q;
				rhs[0] = -k/monodromy->scale[c->member[q]];
				rhs[(size_t)w*wide] = -monodromy->gauss.node[i]*h*k - d;
			}
}

/* The step's transition matrix [2w][2w] from the accelerations in rhs; returns the estimated error. */
static double read_step(struct hawser__monodromy *monodromy, const struct component *c)
{
	int w = c->w, wide = S*w;
	double h = c->h, worst = 0.0;
	const struct hawser__collocation *gauss = &monodromy->gauss;

	for (int q = 0; q < 2*w; q++) {
		const double *a = monodromy->rhs + (size_t)q*wide;
		double last2 = 0.0;

		for (int p = 0; p < w; p++) {
			double once = 0.0, twice = 0.0, last = 0.0;
			double scale = monodromy->scale[c->member[p]];

			for (int i = 0; i < S; i++) {
				once += gauss->end_once[i]*a[i*w + p];
				twice += gauss->end_twice[i]*a[i*w + p];
				last += gauss->transform[S - 1][i]*a[i*w + p];
			}
			last2 += last*last;
			twice = h*h*twice + (q == p + w ? h : 0.0);
			monodromy->step[(size_t)p*2*w + q] = scale*twice + (q == p);
			monodromy->step[(size_t)(w + p)*2*w + q] = h*once + (q == p + w);
		}
		worst = fmax(worst, last2);
	}
	return STEP_ERROR*pow(h*sqrt(worst)/LAST_COEFFICIENT, 17.0/8.0);
}

/* K and D at the nodes of a step. */
static void evaluate(struct hawser__monodromy *monodromy, const struct hawser__variational *system,
                     int step)
{
	int n2 = system->n*system->n, columns = 2*monodromy->order + 1;
	const double *table = monodromy->table + (size_t)step*S*columns;

	cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, S, n2, 2*system->order + 1, 1.0,
	            table, columns, system->K, n2, 0.0, monodromy->stiff, n2);
	cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, S, n2, 2*system->order_d + 1, 1.0,
	            table, columns, system->D, n2, 0.0, monodromy->damp, n2);
}

/* --- a period --- */

static enum hawser_status make_table(struct hawser__monodromy *monodromy, int order,
                                     struct hawser_report *report)
{
	int columns = 2*order + 1, nodes = S*monodromy->steps;
	size_t room = (size_t)nodes*columns;

	if (monodromy->table_steps == monodromy->steps && monodromy->order == order)
		return HAWSER_OK;
	if (room > monodromy->table_room) {
		double *larger = realloc(monodromy->table, 2*room*sizeof *larger);

		if (!larger)
			return hawser__no_memory(report, "orbit");
		monodromy->table = larger;
		monodromy->table_room = 2*room;
	}
	for (int i = 0; i < nodes; i++) {
		/* NOLINTNEXTLINE(bugprone-integer-division): the whole part is meant */
		double tau = (i/S + monodromy->gauss.node[i%S])*2.0*M_PI/monodromy->steps;
		double *row = monodromy->table + (size_t)i*columns;

		row[0] = 0.5;
		for (int k = 1; k <= order; k++) {
			row[2*k - 1] = cos(k*tau);
			row[2*k] = sin(k*tau);
		}
	}
	monodromy->table_steps = monodromy->steps;
	monodromy->order = order;
	return HAWSER_OK;
}

/* The rate at which what is left of the damping makes motions grow apart: it may differ from coordinate
 * to coordinate, and of one that is overdamped z grows and decays. */
static double spread(const struct component *c, const struct hawser__variational *system)
{
	double most = 0.0;

	for (int p = 0; p < c->w; p++) {
		int at = c->member[p]*(c->n + 1);
		double over = 0.25*c->damping*c->damping - 0.5*system->K[at];

		most = fmax(most, fabs(0.5*system->D[at] - c->damping) + 2.0*sqrt(fmax(over, 0.0)));
	}
	return most;
}

/* Multipliers of one component, 2 w of them from log_modulus[0]; adds to the estimated error. */
static enum hawser_status solve_component(struct hawser__monodromy *monodromy, double *log_modulus,
                                          double *argument,
                                          const struct hawser__variational *system,
                                          struct component *c, struct hawser_report *report)
{
	int w = c->w, m = 2*w, steps = monodromy->steps;
	double period = 2.0*M_PI/system->omega, error = 0.0, loss;
	struct hawser__factors factors = {.at = monodromy->factor, .m = m, .largest = -1.0,
		.most = hawser__monodromy_factors(monodromy->n)};
	enum hawser_status status;

	for (int p = 0; p < w; p++)
		c->damping += 0.5*system->D[c->member[p]*(c->n + 1)]/w;
	c->h = period/steps;
	factors.limit = fmax(STRETCH, spread(c, system)*period/factors.most);
	monodromy->stretch = 0.0;
	for (int i = 0; i < steps; i++) {
		evaluate(monodromy, system, i);
		fill_system(monodromy, c);
		if (LAPACKE_dgesv_work(LAPACK_COL_MAJOR, S*w, m, monodromy->matrix, S*w,
		                       monodromy->pivot, monodromy->rhs, S*w))
			return hawser__fail(report, HAWSER_ERR_CONVERGENCE, "floquet",
			                    "a step of the variational equations at Omega %.9g is "
			                    "singular: its numbers lie too far apart", system->omega);
		error += read_step(monodromy, c);
		hawser__factors_add(monodromy, &factors);
	}
	monodromy->error = fmax(monodromy->error, error);
	status = hawser__factors_multipliers(monodromy, log_modulus, argument, &factors, report);
	loss = hawser__factors_loss(m, steps, monodromy->stretch, error);
	monodromy->loss = fmax(monodromy->loss, loss);
	monodromy->spread = fmax(monodromy->spread,
	                         hawser__factors_error(log_modulus, argument, m, loss, error));
	/* one that underflows is given as a number: the continuation looks at its changes */
	for (int i = 0; i < m; i++)
		log_modulus[i] = fmax(log_modulus[i] + factors.taken - 0.5*c->damping*period,
		                      SMALLEST);
	return status;
}

static enum hawser_status solve_all(struct hawser__monodromy *monodromy, double *log_modulus,
                                    double *argument, const struct hawser__variational *system,
                                    struct hawser_report *report)
{
	int n = system->n, begin = 0;
	int order = system->order > system->order_d ? system->order : system->order_d;
	enum hawser_status status = make_table(monodromy, order, report);

	monodromy->error = monodromy->loss = monodromy->spread = 0.0;
	while (!status && begin < n) {
		struct component c = {.member = monodromy->member + begin, .n = n};

		while (begin + c.w < n && monodromy->part[c.member[c.w]] ==
		                          monodromy->part[c.member[0]])
			c.w++;
		status = solve_component(monodromy, log_modulus + 2*begin, argument + 2*begin, system,
		                         &c, report);
		begin += c.w;
	}
	return status;
}

/* Steps that bring the error to a third of the goal; it falls with h^16. */
static int better_steps(const struct hawser__monodromy *monodromy)
{
	double ratio = pow(fmax(monodromy->error, 1e-300)/(GOAL/3.0), 1.0/16.0);

	return (int)fmin(monodromy->most, fmax(2, ceil(monodromy->steps*fmin(4.0, ratio))));
}

/* Radians, or e-folds, of the fastest coordinate in a period, from the rows' sums. */
static double turn(const struct hawser__variational *system)
{
	int n = system->n;
	size_t n2 = (size_t)n*n;
	double stiff = 0.0, damp = 0.0;
	int order = system->order > system->order_d ? system->order : system->order_d;

	for (int j = 0; j < n; j++) {
		double row = 0.0, row_d = 0.0;

		for (int k = j*n; k < (j + 1)*n; k++) {
			for (int r = 0; r <= 2*system->order; r++)
				row += (r ? 1.0 : 0.5)*fabs(system->K[r*n2 + k]);
			for (int r = 0; r <= 2*system->order_d; r++)
				row_d += (r ? 1.0 : 0.5)*fabs(system->D[r*n2 + k]);
		}
		stiff = fmax(stiff, row);
		damp = fmax(damp, row_d);
	}
	return 2.0*M_PI*fmax((sqrt(stiff) + damp)/system->omega, order);
}

/* Most steps of a strict computation of n coordinates. */
static int affordable(int n)
{
	double cost = 0.7*pow(S*n, 3.0) + 2000.0;

	return (int)fmax(MOST_STEPS, AFFORDABLE/cost);
}

/* So many steps that no phase is lost; nothing without that many. */
static enum hawser_status plan_steps(struct hawser__monodromy *monodromy,
                                     const struct hawser__variational *system, int stiff,
                                     struct hawser_report *report)
{
	double needed = turn(system)/(stiff ? STIFF_TURN : TURN);

	if (needed > monodromy->most)
		return hawser__fail(report, HAWSER_ERR_CONVERGENCE, "floquet",
		                    "multipliers at Omega %.9g need about %.0f steps a period for %d "
		                    "coordinates, and %d are the most: the fastest coordinate, or the "
		                    "strongest damping, is too far above Omega; keep fewer modes",
		                    system->omega, needed, system->n, monodromy->most);
	monodromy->steps = monodromy->finer*(int)fmax(fmax(ceil(needed), 2),
	                                              stiff ? monodromy->steps : 0);
	monodromy->steps += monodromy->more*(monodromy->steps/4 + 1);
	return HAWSER_OK;
}

static enum hawser_status solve_finely(struct hawser__monodromy *monodromy, double *log_modulus,
                                       double *argument, const struct hawser__variational *system,
                                       struct hawser_report *report)
{
	int stiff = monodromy->fastest < INFINITY, steps;
	enum hawser_status status;

	find_parts(monodromy, system);
	for (int j = 0; j < system->n; j++)
		monodromy->scale[j] = sqrt(fmax(0.5*system->K[(size_t)j*(system->n + 1)],
		                                system->omega*system->omega));
	if (stiff)
		monodromy->steps = (int)fmin(monodromy->most, ceil(2.0*M_PI/STIFF_TURN*
			fmax(STIFF_LEAST, hawser__monodromy_pace(monodromy, system)/system->omega)));
	if (monodromy->finer && (status = plan_steps(monodromy, system, stiff, report)))
		return status;
	for (;;) {
		if ((status = solve_all(monodromy, log_modulus, argument, system, report)))
			return status;
		steps = stiff ? monodromy->steps : better_steps(monodromy);
		if (stiff || monodromy->error <= GOAL || steps <= monodromy->steps)
			break;
		monodromy->steps = steps;
	}
	if (stiff) {
		monodromy->error = steps*STEP_ERROR*pow(STIFF_TURN, 17.0);
		monodromy->loss = fmax(monodromy->loss, monodromy->error);
		monodromy->spread = fmax(monodromy->spread, monodromy->loss);
	}
	/* fewer only by and by: the steps' error is a smooth function along the branch */
	if (steps < monodromy->steps - monodromy->steps/8)
		monodromy->steps -= monodromy->steps/8;
	return HAWSER_OK;
}

/* D and its harmonics as a series. */
static enum hawser_status collect_damping(struct hawser__monodromy *monodromy,
                                          struct hawser__variational *system,
                                          const struct hawser_rom *rom, struct hawser_report *report)
{
	size_t n2 = (size_t)rom->n*rom->n, need;

	system->order_d = 0;
	for (int p = 0; p < rom->harmonics; p++)
		if (rom->harmonic[p].D && rom->harmonic[p].k > system->order_d)
			system->order_d = rom->harmonic[p].k;
	need = (2*(size_t)system->order_d + 1)*n2;
	if (need > monodromy->damping_room) {
		free(monodromy->damping);
		monodromy->damping = malloc(need*sizeof(double));
		monodromy->damping_room = monodromy->damping ? need : 0;
		if (!monodromy->damping)
			return hawser__no_memory(report, "orbit");
	}
	memset(monodromy->damping, 0, need*sizeof(double));
	cblas_daxpy((int)n2, 2.0, rom->D, 1, monodromy->damping, 1);
	for (int p = 0; p < rom->harmonics; p++) {
		const struct hawser_harmonic *harmonic = &rom->harmonic[p];
		int row = 2*harmonic->k - (harmonic->phase == HAWSER_COS);

		if (harmonic->D)
			cblas_daxpy((int)n2, pow(system->omega, harmonic->omega_power), harmonic->D, 1,
			            monodromy->damping + (size_t)row*n2, 1);
	}
	system->D = monodromy->damping;
	return HAWSER_OK;
}

enum hawser_status hawser__monodromy_multipliers(struct hawser__monodromy *monodromy,
                                                 double *log_modulus, double *argument,
                                                 const struct hawser_rom *rom, const double *T,
                                                 int order, double omega,
                                                 struct hawser_report *report)
{
	struct hawser__variational system = {.n = rom->n, .order = order, .K = T, .omega = omega};
	double period = 2.0*M_PI/omega;
	int n = rom->n, kept;
	enum hawser_status status = collect_damping(monodromy, &system, rom, report);

	monodromy->most = monodromy->finer ? affordable(n) : MOST_STEPS;
	if (!status && monodromy->finer)
		monodromy->follow = turn(&system)/TURN <= monodromy->most ? INFINITY : HAWSER__FOLLOW;
	if (!status)
		status = hawser__monodromy_condense(monodromy, &system, &kept, report);
	if (!status)
		status = solve_finely(monodromy, log_modulus, argument, &system, report);
	if (status)
		return status;
	if ((monodromy->neglected = kept < n ? HAWSER__NEGLECTED : 0.0) > 0.0)
		monodromy->spread = fmax(monodromy->spread, HAWSER__NEGLECTED);
	/* the others follow, and their own motion dies away */
	for (int f = 0; f < n - kept; f++) {
		int j = monodromy->fast[f], at = 2*(kept + f);
		double half = 0.5*rom->D[(size_t)j*(n + 1)], w = monodromy->frequency[j];
		double slower = half > w ? sqrt(half*half - w*w) : 0.0;

		log_modulus[at] = (slower - half)*period;
		log_modulus[at + 1] = -(slower + half)*period;
		argument[at] = half > w ? 0.0 : fabs(remainder(sqrt(w*w - half*half)*period, 2.0*M_PI));
		argument[at + 1] = -argument[at];
	}
	hawser__floquet_sort(log_modulus, argument, 2*n);
	return HAWSER_OK;
}
