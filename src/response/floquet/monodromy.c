/* response/floquet/monodromy.c - see monodromy.h: components, the product over a period, and the
 * multipliers. SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/grow.h"
#include "core/report.h"
#include "response/floquet/floquet.h"
#include "response/floquet/monodromy.h"
#define S HAWSER__NODES
#define SMALLEST (-1e5)      /* smallest logarithm of a multiplier; chosen, so that all logarithms
                              * are finite */
#define IDLE 2               /* raises in a row of the number of steps that may gain nothing; chosen */
#define TENTATIVE 0.4        /* part of the steps of a strict computation, planned for sums of moduli,
                              * that is tried first; chosen */
#define UNSEEN 1e-13         /* error that is hidden by round-off; chosen */
#define STRETCH 2.0          /* largest logarithm of the norm of a factor; chosen: round-off of a
                              * product grows with it */

enum hawser_status hawser__monodromy_init(struct hawser__monodromy *monodromy, int n,
                                          struct hawser_report *report)
{
	size_t n2 = (size_t)n*n, wide = (size_t)S*n;
	size_t room = (size_t)n + 2*S*n2 + wide*wide + 2*(size_t)n*wide + 8*n2 +
	              8*n2*hawser__monodromy_factors(n) +
	              hawser__floquet_work(hawser__monodromy_factors(n), 2*n) +
	              (HAWSER__EIGEN_WORK + 4)*2*(size_t)n;
	double *next;

	memset(monodromy, 0, sizeof *monodromy);
	monodromy->n = n;
	monodromy->steps = 8;
	monodromy->allowed = INFINITY;
	monodromy->follow = HAWSER__FOLLOW;
	monodromy->expected = HAWSER__EXPECTED;
	hawser__collocation_make(&monodromy->gauss);
	hawser__collocation_indirect(&monodromy->gauss);
	hawser__collocation_make_radau(&monodromy->radau, S);
	hawser__collocation_indirect(&monodromy->radau);
	monodromy->part = calloc(3*(size_t)n, sizeof(int));
	monodromy->pivot = calloc(wide, sizeof(int));
	monodromy->memory = next = calloc(room, sizeof *next);
	monodromy->slow = calloc(2*(size_t)n, sizeof(int));
	monodromy->frequency = calloc(4*(size_t)n, sizeof(double));
	monodromy->block = calloc((size_t)n, sizeof *monodromy->block);
	if (!monodromy->part || !monodromy->pivot || !next || !monodromy->slow ||
	    !monodromy->frequency || !monodromy->block) {
		hawser__monodromy_release(monodromy);
		return hawser__no_memory(report, "orbit");
	}
	monodromy->member = monodromy->part + n;
	monodromy->sign = monodromy->member + n;
	monodromy->fast = monodromy->slow + n;
	monodromy->reach = monodromy->frequency + n;
	monodromy->kind = monodromy->reach + n;
	monodromy->scale = next;
	monodromy->stiff = next += n;
	monodromy->damp = next += S*n2;
	monodromy->matrix = next += S*n2;
	monodromy->rhs = next += wide*wide;
	monodromy->step = next += 2*(size_t)n*wide;
	monodromy->product = next += 4*n2;
	monodromy->factor = next += 4*n2;
	monodromy->floquet_work = next + 8*n2*hawser__monodromy_factors(n);
	monodromy->grouped = monodromy->memory + room - 4*(size_t)n;
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
	free(monodromy->block);
	free(monodromy->room);
	free(monodromy->reduced);
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

void hawser__monodromy_parts(struct hawser__monodromy *monodromy,
                             const struct hawser__variational *system)
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

/* Coordinates of the largest component. */
static int widest(const struct hawser__monodromy *monodromy, int n)
{
	int most = 0;

	for (int p = 0; p < n; p++) {
		int count = 0;

		for (int j = 0; j < n; j++)
			count += monodromy->part[j] == p;
		most = count > most ? count : most;
	}
	return most;
}

/* --- a period --- */

static void set_angle(double *pair, double angle)
{
	pair[0] = cos(angle);
	pair[1] = sin(angle);
}

/* The cosines and sines at a node are those at the start of its step, which are roots of unity, turned
 * by its place in the step. Both are computed once, behind the table. */
static void fill_table(double *table, const struct hawser__collocation *nodes, int steps, int order)
{
	int columns = 2*order + 1;
	double *root = table + (size_t)S*steps*columns, *turn = root + 2*(size_t)steps;

	for (int s = 0; s < steps; s++)
		set_angle(root + 2*(size_t)s, 2.0*M_PI*s/steps);
	for (int i = 0; i < S; i++)
		for (int k = 1; k <= order; k++)
			set_angle(turn + 2*((size_t)i*(order + 1) + k), 2.0*M_PI*k*nodes->node[i]/steps);
	for (int node = 0; node < S*steps; node++) {
		const double *by = turn + 2*(size_t)(node%S)*(order + 1);
		double *row = table + (size_t)node*columns;

		row[0] = 0.5;
		for (int k = 1; k <= order; k++) {
			const double *at = root + 2*((long)(node/S)*k%steps);

			row[2*k - 1] = at[0]*by[2*k] - at[1]*by[2*k + 1];
			row[2*k] = at[1]*by[2*k] + at[0]*by[2*k + 1];
		}
	}
}

static enum hawser_status make_table(struct hawser__monodromy *monodromy,
                                     const struct hawser__collocation *nodes, int order,
                                     struct hawser_report *report)
{
	int columns = 2*order + 1, steps = monodromy->steps;
	size_t room = (size_t)S*steps*columns + 2*((size_t)steps + S*((size_t)order + 1));

	if (monodromy->table_steps == steps && monodromy->order == order && monodromy->table_nodes == nodes)
		return HAWSER_OK;
	if (room > monodromy->table_room) {
		if (hawser__resize(&monodromy->table, 2*room, sizeof(double)))
			return hawser__no_memory(report, "orbit");
		monodromy->table_room = 2*room;
	}
	fill_table(monodromy->table, nodes, steps, order);
	monodromy->table_steps = steps;
	monodromy->table_nodes = nodes;
	monodromy->order = order;
	return HAWSER_OK;
}

/* Whether half a period is enough: of stiff models, where it saves most. */
static int halves(struct hawser__monodromy *monodromy, const struct hawser__variational *system,
                  const struct hawser__component *c)
{
	return monodromy->rest && monodromy->fastest < INFINITY && monodromy->steps%2 == 0 &&
	       hawser__monodromy_repeats(monodromy->sign, system, c);
}

/* The multipliers of one component, 2 w of them from log_modulus[0]; adds to the estimated error. There
 * are none where the error exceeds what is allowed. */
static enum hawser_status solve_component(struct hawser__monodromy *monodromy, double *log_modulus,
                                          double *argument, double *kind,
                                          const struct hawser__variational *system,
                                          struct hawser__component *c, struct hawser_report *report)
{
	int w = c->w, m = 2*w, parts = halves(monodromy, system, c) ? 2 : 1;
	int steps = monodromy->steps/parts;
	int order = system->order > system->order_d ? system->order : system->order_d;
	double period = 2.0*M_PI/system->omega, error = 0.0, loss, round_off, apart;
	struct hawser__factors factors = {.at = monodromy->factor, .m = m, .largest = -1.0,
		.most = hawser__monodromy_factors(monodromy->n)};
	enum hawser_status status;

	c->h = period/monodromy->steps;
	monodromy->stretch = 0.0;
	apart = hawser__component_damping(c, monodromy, system);
	factors.limit = c->overdamped ? STRETCH : fmax(STRETCH, apart*period/factors.most);
	if ((status = make_table(monodromy, c->table, order, report)))
		return status;
	for (int i = 0; i < steps; i++) {
		if ((status = hawser__monodromy_step(monodromy, &error, system, c, i, report)))
			return status;
		hawser__factors_add(monodromy, &factors);
		if (error > monodromy->allowed) {
			monodromy->error = error*steps/(i + 1);
			return HAWSER_OK;
		}
	}
	monodromy->error = fmax(monodromy->error, parts*error);
	if (parts > 1)
		hawser__factors_reverse(&factors, monodromy->sign);
	status = hawser__factors_multipliers(monodromy, log_modulus, argument, kind, c, &factors, report);
	if (parts > 1)
		hawser__factors_square(log_modulus, argument, kind, m);
	loss = parts*hawser__factors_loss(m, steps, monodromy->stretch, error);
	round_off = parts*hawser__factors_loss(m, steps, monodromy->stretch, 0.0);
	monodromy->loss = fmax(monodromy->loss, loss);
	monodromy->round_off = fmax(monodromy->round_off, round_off);
	monodromy->spread = fmax(monodromy->spread,
	                         hawser__factors_error(log_modulus, argument, m, loss, error));
	/* -inf is replaced by a finite number, since the continuation uses differences */
	for (int i = 0; i < m; i++)
		log_modulus[i] = fmax(log_modulus[i] + parts*factors.taken - 0.5*c->damping*period,
		                      SMALLEST);
	return status;
}

static enum hawser_status solve_all(struct hawser__monodromy *monodromy, double *log_modulus,
                                    double *argument, const struct hawser__variational *system,
                                    struct hawser_report *report)
{
	int n = system->n, begin = 0;
	enum hawser_status status = HAWSER_OK;

	if (monodromy->rest && monodromy->fastest < INFINITY) /* see halves */
		monodromy->steps += monodromy->steps%2;
	monodromy->error = monodromy->loss = monodromy->spread = monodromy->round_off = 0.0;
	while (!status && begin < n && !(monodromy->error > monodromy->allowed)) {
		struct hawser__component c = {.member = monodromy->member + begin, .n = n};

		while (begin + c.w < n && monodromy->part[c.member[c.w]] ==
		                          monodromy->part[c.member[0]])
			c.w++;
		status = solve_component(monodromy, log_modulus + 2*begin, argument + 2*begin,
		                         monodromy->kind + 2*begin, system, &c, report);
		begin += c.w;
	}
	return status;
}

/* As many of the planned steps as are enough for an error that round-off hides, if not all. */
static enum hawser_status solve_tentatively(struct hawser__monodromy *monodromy, double *log_modulus,
                                            double *argument,
                                            const struct hawser__variational *system,
                                            struct hawser_report *report)
{
	int planned = monodromy->steps;
	enum hawser_status status;

	monodromy->steps = (int)ceil(TENTATIVE*planned);
	for (;;) {
		monodromy->allowed = monodromy->steps < planned ? UNSEEN : INFINITY;
		if ((status = solve_all(monodromy, log_modulus, argument, system, report)) ||
		    !(monodromy->error > monodromy->allowed))
			break;
		monodromy->steps = (int)fmin(planned, fmax(hawser__monodromy_better(monodromy, UNSEEN),
		                                           monodromy->steps + 1));
	}
	monodromy->allowed = INFINITY;
	return status;
}

static enum hawser_status solve_finely(struct hawser__monodromy *monodromy, double *log_modulus,
                                       double *argument, const struct hawser__variational *system,
                                       struct hawser_report *report)
{
	int stiff = monodromy->fastest < INFINITY && !monodromy->haste, before = monodromy->steps, steps;
	int idle = 0, tentative;
	double lost = INFINITY;
	enum hawser_status status;

	hawser__monodromy_parts(monodromy, system);
	if (monodromy->finer)
		hawser__monodromy_afford(monodromy, widest(monodromy, system->n));
	for (int j = 0; j < system->n; j++)
		monodromy->scale[j] = sqrt(fmax(0.5*system->K[(size_t)j*(system->n + 1)],
		                                system->omega*system->omega));
	if ((status = hawser__monodromy_plan(monodromy, system, report)))
		return status;
	tentative = monodromy->finer == 1 && !monodromy->more && !monodromy->sharper && !stiff &&
	            !monodromy->rough;
	for (;;) {
		status = (tentative ? solve_tentatively : solve_all)(monodromy, log_modulus, argument, system,
		                                                     report);
		tentative = 0;
		if (status)
			return status;
		/* the phases of some of the kept coordinates do matter */
		if (stiff && monodromy->resolved &&
		    (steps = hawser__monodromy_raised(monodromy)) > monodromy->steps && idle < IDLE) {
			idle = monodromy->loss < lost ? 0 : idle + 1;
			lost = monodromy->loss;
			monodromy->steps = steps;
			continue;
		}
		steps = stiff || monodromy->rough
		        ? monodromy->steps
		        : hawser__monodromy_better(monodromy, HAWSER__MONODROMY_GOAL);
		if (stiff || monodromy->error <= HAWSER__MONODROMY_GOAL || steps <= monodromy->steps)
			break;
		monodromy->steps = steps;
	}
	if (stiff) {
		monodromy->error = hawser__monodromy_stiff_error(monodromy);
		monodromy->loss = fmax(monodromy->loss, monodromy->error);
		monodromy->spread = fmax(monodromy->spread, monodromy->loss);
	}
	if (stiff && !monodromy->sharper)
		monodromy->phases = monodromy->resolved && monodromy->loss <= HAWSER__NEGLECTED
		                    ? monodromy->steps : 0;
	if (monodromy->sharper) {
		monodromy->steps = before;
		return HAWSER_OK;
	}
	/* the number of steps decreases slowly, so that the error of the steps is smooth along the
	 * branch */
	if (steps < monodromy->steps - monodromy->steps/8)
		monodromy->steps -= monodromy->steps/8;
	return HAWSER_OK;
}

enum hawser_status hawser__monodromy_damping(struct hawser__monodromy *monodromy,
                                             struct hawser__variational *system,
                                             const struct hawser_rom *rom,
                                             struct hawser_report *report)
{
	size_t n2 = (size_t)rom->n*rom->n, need;

	system->order_d = 0;
	for (int p = 0; p < rom->harmonics; p++)
		if (rom->harmonic[p].D && rom->harmonic[p].k > system->order_d)
			system->order_d = rom->harmonic[p].k;
	if (monodromy->resist && monodromy->resist_order > system->order_d)
		system->order_d = monodromy->resist_order;
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
		double factor = hawser__series_factor(harmonic, system->omega);

		if (harmonic->D)
			cblas_daxpy((int)n2, factor, harmonic->D, 1,
			            monodromy->damping + hawser__series_row(harmonic)*n2, 1);
	}
	for (int row = 0; monodromy->resist && row <= 2*monodromy->resist_order; row++)
		cblas_daxpy((int)n2, 1.0, monodromy->resist + (size_t)row*n2, 1,
		            monodromy->damping + (size_t)row*n2, 1);
	system->D = monodromy->damping;
	return HAWSER_OK;
}

/* The two multipliers of the condensed coordinate f (index of monodromy->fast), whose free motion
 * decays: log_modulus [2], the larger first, and the argument of the first. */
static void monodromy_free_motion(double *log_modulus, double *argument,
                                  const struct hawser__monodromy *monodromy,
                                  const struct hawser_rom *rom, int f, double omega)
{
	int j = monodromy->fast[f];
	double half = 0.25*monodromy->damping[(size_t)j*((size_t)rom->n + 1)], w = monodromy->frequency[j];
	double slower = half > w ? sqrt(half*half - w*w) : 0.0, period = 2.0*M_PI/omega;

	log_modulus[0] = (slower - half)*period;
	log_modulus[1] = -(slower + half)*period;
	*argument = half > w ? 0.0 : fabs(remainder(sqrt(w*w - half*half)*period, 2.0*M_PI));
}

/* The multipliers, still by components, to monodromy->grouped. */
static void group(struct hawser__monodromy *monodromy, const double *log_modulus,
                  const double *argument, int n, int kept)
{
	for (int i = 0; i < n; i++) {
		int own = i < kept ? monodromy->member[i] : i - kept;
		int j = kept == n ? own : i < kept ? monodromy->slow[own] : monodromy->fast[own];

		for (int k = 0; k < 2; k++) {
			monodromy->grouped[2*j + k] = log_modulus[2*i + k];
			monodromy->grouped[2*(n + j) + k] = argument[2*i + k];
		}
	}
}

enum hawser_status hawser__monodromy_multipliers(struct hawser__monodromy *monodromy,
                                                 double *log_modulus, double *argument,
                                                 const struct hawser_rom *rom, const double *T,
                                                 int order, double omega,
                                                 struct hawser_report *report)
{
	struct hawser__variational system = {.n = rom->n, .order = order, .K = T, .omega = omega};
	int n = rom->n, kept;
	enum hawser_status status = hawser__monodromy_damping(monodromy, &system, rom, report);

	if (status)
		return status;
	monodromy->rest = rom->exact && !monodromy->finer ? rom->K : NULL;
	monodromy->kinds = system.order_d == 0 && hawser__fast_symmetric(T, order, n) &&
	                   hawser__fast_symmetric(system.D, 0, n);
	hawser__monodromy_parts(monodromy, &system);
	hawser__monodromy_limits(monodromy, &system, widest(monodromy, n));
	status = hawser__monodromy_condense(monodromy, &system, &kept, report);
	if (!status)
		status = solve_finely(monodromy, log_modulus, argument, &system, report);
	if (status)
		return status;
	monodromy->kept = kept;
	if (kept == n)
		monodromy->neglected = 0.0;
	monodromy->spread = fmax(monodromy->spread, monodromy->neglected);
	/* the condensed coordinates respond statically, and their free motion decays */
	for (int f = 0; f < n - kept; f++) {
		int at = 2*(kept + f);

		monodromy_free_motion(log_modulus + at, argument + at, monodromy, rom, f, omega);
		argument[at + 1] = -argument[at];
		monodromy->kind[at] = monodromy->kind[at + 1] =
			log_modulus[at] == log_modulus[at + 1] ? HAWSER__CONDENSED : 0.0;
	}
	group(monodromy, log_modulus, argument, n, kept);
	hawser__floquet_sort(log_modulus, argument, monodromy->kind, monodromy->rough ? 2*kept : 2*n);
	return HAWSER_OK;
}
