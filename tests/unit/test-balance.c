/* Harmonic balance: the Jacobian against differences, absence of aliasing, spectral convergence,
 * the truncation by the active set, multipliers and orbits against shooting, an orbit at rest.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include "response/orbit/balance.h"
#include "response/time/flow.h"
#include "response/orbit/start.h"
#include "rom/build/model.h"
#include "tests/balance-model.h"
#include "tests/tap.h"

static int make_duffing(struct hawser_rom *rom, double damping, double cubic, double load)
{
	if (hawser__rom_init(rom, 1, NULL))
		return 1;
	rom->K[0] = 1.0;
	rom->D[0] = damping;
	rom->cubics = 1;
	rom->C = calloc(1, sizeof *rom->C);
	rom->C[0] = (struct hawser_cubic){0, 0, 0, 0, cubic};
	if (load != 0.0)
		add_harmonic(rom, (struct hawser_harmonic){.k = 1}, &load, NULL, NULL);
	return hawser_rom_compile(rom, NULL) != HAWSER_OK;
}

/* --- derivatives --- */

/* Fourth-order difference of the defects along unknown `slot`. */
static void difference(double *d, struct hawser__balance *balance, const double *y, int slot)
{
	int count = (2*balance->order + 1)*balance->base.n;
	const double h = 1e-3, weight[4] = {1.0/12.0, -2.0/3.0, 2.0/3.0, -1.0/12.0};
	double *moved = malloc((size_t)balance->base.size*sizeof *moved);

	memset(d, 0, (size_t)count*sizeof *d);
	memcpy(moved, y, (size_t)balance->base.size*sizeof *moved);
	for (int s = 0; s < 4; s++) {
		moved[slot] = y[slot] + (s < 2 ? s - 2 : s - 1)*h;
		hawser__balance_evaluate(balance, moved, 0);
		for (int i = 0; i < count; i++)
			d[i] += weight[s]*balance->defect[i]/h;
	}
	free(moved);
}

static void check_jacobian(void)
{
	struct hawser_rom rom;
	struct hawser__balance balance;
	double *y, *d, *row, worst = 0.0, largest = 0.0;
	int P;

	if (make_general(&rom) || hawser__balance_init(&balance, &rom, NULL))
		return;
	activate(&balance, 5);
	balance.active[2*2 + 1] = balance.active[4*2] = 0; /* gaps */
	if (hawser__balance_arrange(&balance, NULL))
		return;
	P = balance.unknowns;
	y = some_orbit(&balance, 5, 1.17);
	d = calloc((size_t)balance.base.size, sizeof *d);
	row = calloc((size_t)balance.base.size, sizeof *row);
	for (int i = 0; i < balance.base.size; i++)
		row[i] = sin(i + 0.4);
	balance.base.ops->metric(&balance.base, y);
	hawser__balance_evaluate(&balance, y, 1);
	hawser__balance_scale(&balance);
	hawser__balance_set_border(&balance, row);
	hawser__balance_assemble(&balance);
	for (int c = 0; c <= P; c++) {
		double scale = c < P ? balance.col_scale[c] : balance.base.W;

		difference(d, &balance, y, c < P ? balance.slot[c] : balance.base.size - 1);
		for (int i = 0; i < P; i++) {
			double m = balance.matrix[i*(P + 1) + c]/(balance.row_scale[i]*scale);

			worst = fmax(worst, fabs(m - d[balance.slot[i]]));
			largest = fmax(largest, fabs(m));
		}
	}
	ok(P == 20 - 1 + 2*1 - 3, "%d unknowns", P);
	ok(worst < 1e-9*largest, "Jacobian and Omega's column against differences: %.1e of %.1e",
	   worst, largest);
	free(y);
	free(d);
	free(row);
	hawser__balance_release(&balance);
	hawser_rom_clear(&rom);
}

/* More samples change nothing, also for pairs that are 0: the products are exact. */
static void check_aliasing(void)
{
	struct hawser_rom rom;
	struct hawser__balance balance;
	double *y, *few, worst = 0.0;
	int count, rows;

	if (make_general(&rom) || hawser__balance_init(&balance, &rom, NULL))
		return;
	y = some_orbit(&balance, 4, 0.83);
	activate(&balance, 4);
	rows = balance.base.rows;
	count = (2*balance.reach + 1)*rom.n;
	few = malloc((size_t)count*sizeof *few);
	hawser__balance_evaluate(&balance, y, 0);
	memcpy(few, balance.defect, (size_t)count*sizeof *few);
	activate(&balance, 11);
	hawser__balance_evaluate(&balance, y, 0);
	for (int i = 0; i < count; i++)
		worst = fmax(worst, fabs(balance.defect[i] - few[i]));
	ok(worst < 1e-14, "%d samples give what %d do: %.1e", rows, balance.base.rows, worst);
	free(y);
	free(few);
	hawser__balance_release(&balance);
	hawser_rom_clear(&rom);
}

/* --- orbits --- */

/* Newton's method at Omega from y; returns 1 if it fails. */
static int correct(struct hawser__balance *balance, double *y, double omega)
{
	struct hawser__correction correction;
	double *row = calloc((size_t)balance->base.size, sizeof *row);
	int failed;

	y[balance->base.size - 1] = omega;
	balance->base.ops->metric(&balance->base, y);
	row[balance->base.size - 1] = balance->base.W;
	failed = hawser__orbit_correct(&balance->base, y, &correction, row, 1e-12);
	free(row);
	return failed;
}

/* Newton's method and refinement from the linear response; returns 1 on failure. */
static int solve(struct hawser__balance *balance, double *y, double omega, double tolerance)
{
	struct hawser__correction correction;
	double x[8];
	struct hawser__raised raised = {.x = x};

	return hawser__start(y, &balance->base, &correction, NULL, omega, tolerance, &raised, NULL) !=
	       HAWSER_OK;
}

/* The error of a truncated series decreases by a factor for every harmonic, and so does the
 * estimate. */
static void check_convergence(void)
{
	struct hawser_rom rom;
	struct hawser__balance balance;
	double *exact, *y, previous = INFINITY;

	if (make_duffing(&rom, 0.3, 0.6, 1.2) || hawser__balance_init(&balance, &rom, NULL))
		return;
	exact = calloc((size_t)balance.base.size, sizeof *exact);
	y = calloc((size_t)balance.base.size, sizeof *y);
	ok(!solve(&balance, exact, 0.7, 1e-12), "%d harmonics", balance.order);
	for (int order = 3; order <= 15; order += 4) {
		struct hawser__metric metric;
		double error, estimate;

		memcpy(y, exact, (size_t)balance.base.size*sizeof *y);
		activate(&balance, order);
		if (!ok(!correct(&balance, y, 0.7), "%d harmonics", order))
			break;
		metric = hawser__orbit_metric(&balance.base);
		error = sqrt(hawser__metric_distance2(&metric, y, exact));
		estimate = balance.base.mesh/balance.base.X;
		ok(error < 0.12*previous, "error %.1e", error);
		ok(estimate > 0.1*error && estimate < 10.0*error, "estimate %.1e", estimate);
		previous = error;
	}
	free(exact);
	free(y);
	hawser__balance_release(&balance);
	hawser_rom_clear(&rom);
}

/* A symmetric Duffing orbit has odd harmonics only, and a coordinate without excitation has none. */
static void check_active(void)
{
	struct hawser_rom rom;
	struct hawser__balance balance;
	double *y;
	int even = 0, idle = 0, active = 0;

	if (hawser__rom_init(&rom, 2, NULL))
		return;
	rom.K[0] = 1.0;
	rom.K[3] = 0.9;
	rom.D[0] = rom.D[3] = 0.1;
	rom.cubics = 2;
	rom.C = calloc(2, sizeof *rom.C);
	rom.C[0] = (struct hawser_cubic){0, 0, 0, 0, 0.5};
	rom.C[1] = (struct hawser_cubic){1, 0, 0, 1, 0.8};
	add_harmonic(&rom, (struct hawser_harmonic){.k = 1}, (double[]){0.7, 0.0}, NULL, NULL);
	if (hawser_rom_compile(&rom, NULL) || hawser__balance_init(&balance, &rom, NULL))
		return;
	ok(balance.unknowns == 2, "begins with the load's harmonic alone");
	y = calloc((size_t)balance.base.size, sizeof *y);
	ok(!solve(&balance, y, 0.6, 1e-9), "%d unknowns", balance.unknowns);
	for (int h = 0; h <= balance.order; h++) {
		even += h%2 == 0 && balance.active[2*h];
		idle += balance.active[2*h + 1];
		active += balance.active[2*h];
	}
	ok(even == 0 && idle == 0 && active > 4, "%d odd harmonics, no even one, none of the idle "
	   "coordinate", active);
	activate(&balance, balance.order + 6);
	ok(!correct(&balance, y, 0.6), "orbit with %d unknowns", balance.unknowns);
	ok(!hawser__balance_relax(&balance.base, 1e-9, NULL), "cut back");
	ok(balance.unknowns <= 2*(active + 2), "to %d unknowns", balance.unknowns);
	free(y);
	hawser__balance_release(&balance);
	hawser_rom_clear(&rom);
}

/* From the linear response, which is far from the orbit: with one harmonic Newton's method
 * converges, and the result leads on to seventeen harmonics; with seventeen at once it fails. */
static void check_start(void)
{
	struct hawser_rom rom;
	struct hawser__balance balance;
	double *y, omega = 0.64, linear = 0.867/(1.0 - omega*omega);
	int again = 1, failed = 0, order;

	if (make_duffing(&rom, 0.2, 0.9, 0.867) || hawser__balance_init(&balance, &rom, NULL))
		return;
	y = calloc((size_t)balance.base.size, sizeof *y);
	y[hawser__cos(1, 1, 0)] = linear;
	while (again && !failed)
		failed = correct(&balance, y, omega) ||
		         hawser__balance_refine(&balance.base, &again, 1e-9, omega, NULL);
	order = balance.order;
	ok(!failed && order > 9, "from one harmonic to %d", order);
	memset(y, 0, (size_t)balance.base.size*sizeof *y);
	y[hawser__cos(1, 1, 0)] = linear;
	activate(&balance, order);
	ok(correct(&balance, y, omega), "%d at once fail", order);
	free(y);
	hawser__balance_release(&balance);
	hawser_rom_clear(&rom);
}

static void check_failures(void)
{
	struct hawser_rom rom;
	struct hawser__balance balance;
	struct hawser_report report = {.message = ""};
	double *y;
	int again;

	if (make_duffing(&rom, 0.1, 1.0, 1.0) || hawser__balance_init(&balance, &rom, NULL))
		return;
	y = calloc((size_t)balance.base.size, sizeof *y);
	y[hawser__cos(1, 1, 0)] = NAN;
	ok(correct(&balance, y, 0.9), "not a number: no orbit");
	y[hawser__cos(1, 1, 0)] = 1e200;
	ok(correct(&balance, y, 0.9), "infinite defects: no orbit");
	/* an amplitude that decreases slowly with the harmonic, as for a motion with corners */
	activate(&balance, balance.top);
	memset(y, 0, (size_t)balance.base.size*sizeof *y);
	for (int h = 1; h <= balance.top; h += 2)
		y[hawser__cos(1, h, 0)] = 1.0/h;
	y[balance.base.size - 1] = 0.9;
	balance.base.ops->metric(&balance.base, y);
	balance.base.ops->defects(&balance.base, y, 1);
	ok(hawser__balance_refine(&balance.base, &again, 1e-9, 0.9, &report) ==
	   HAWSER_ERR_CONVERGENCE, "%s", report.message);
	free(y);
	hawser__balance_release(&balance);
	hawser_rom_clear(&rom);
}

/* --- against shooting --- */

static int trace(struct hawser_frf *frf, const struct hawser_rom *rom, const char *method,
                 double from, double to)
{
	struct hawser_frf_options options = {.method = NULL};
	struct hawser_report report = {.message = ""};

	options.method = method;
	options.from = from;
	options.to = to;
	options.tolerance = 1e-11;
	return !ok(!hawser_frf_trace(frf, rom, &options, &report), "%s traced %s", method,
	           report.message);
}

/* Distance of the multipliers of two points; both are sorted. */
static double multiplier_gap(const struct hawser_frf *a, int p, const struct hawser_frf *b, int q)
{
	double worst = 0.0;

	for (int i = 0; i < 2*a->n; i++) {
		const double *x = a->multiplier + ((size_t)p*2*a->n + i)*2;
		const double *z = b->multiplier + ((size_t)q*2*a->n + i)*2;

		worst = fmax(worst, hypot(exp(x[0])*cos(x[1]) - exp(z[0])*cos(z[1]),
		                          exp(x[0])*sin(x[1]) - exp(z[0])*sin(z[1])));
	}
	return worst;
}

/* The first and the last point, which both methods have at the same Omega. */
static void compare(const struct hawser_rom *rom, double from, double to, const char *what)
{
	struct hawser_frf a, b;
	double state = 0.0, multipliers;

	if (trace(&a, rom, "shooting", from, to) || trace(&b, rom, "balance", from, to))
		return;
	for (int i = 0; i < 2*rom->n; i++) {
		state = fmax(state, fabs(a.state[i] - b.state[i]));
		state = fmax(state, fabs(a.state[(size_t)(a.points - 1)*2*rom->n + i] -
		                         b.state[(size_t)(b.points - 1)*2*rom->n + i]));
	}
	multipliers = fmax(multiplier_gap(&a, 0, &b, 0),
	                   multiplier_gap(&a, a.points - 1, &b, b.points - 1));
	ok(state < 1e-9, "%s: the same orbits: %.1e", what, state);
	ok(multipliers < 1e-8, "%s: the same multipliers: %.1e", what, multipliers);
	ok(a.events == b.events, "%s: %d events each", what, a.events);
	for (int i = 0; i < a.events && i < b.events; i++)
		ok(a.event[i].kind == b.event[i].kind &&
		   fabs(a.event[i].omega/b.event[i].omega - 1.0) < 1e-9, "%s: %s at %.12g", what,
		   hawser_event_name(a.event[i].kind), a.event[i].omega);
	hawser_frf_clear(&a);
	hawser_frf_clear(&b);
}

static void check_against_shooting(void)
{
	struct hawser_rom rom;

	if (make_general(&rom))
		return;
	compare(&rom, 0.55, 0.9, "general model");
	hawser_rom_clear(&rom);
	if (make_duffing(&rom, 0.0, 0.3, 0.05))
		return;
	compare(&rom, 0.55, 0.8, "undamped");
	hawser_rom_clear(&rom);
}

/* Multipliers of the orbit at rest, by the flow on a fine mesh. */
static void rest_multipliers(double *log_modulus, double *argument, const struct hawser_rom *rom,
                             double omega)
{
	struct hawser__flow flow;
	struct hawser__stretch period = {.h = 2.0*M_PI/400, .steps = 400, .count = 1};
	double x[2] = {0.0}, A[4], b[2];

	if (hawser__flow_init(&flow, rom, NULL))
		return;
	hawser__flow_derive(&flow, x, A, b, NULL, &period, omega);
	ok(!hawser_floquet_product(log_modulus, argument, A, 1, 2, NULL), "multipliers");
	hawser__flow_clear(&flow);
}

/* Mathieu's equation: the orbit is at rest and no pair is active. It loses its stability through
 * +1, which no Jacobian of active pairs shows. */
static void check_rest(void)
{
	struct hawser_rom rom;
	struct hawser_frf frf;
	double log_modulus[2], argument[2];

	if (hawser__rom_init(&rom, 1, NULL))
		return;
	rom.K[0] = 1.0;
	rom.D[0] = 0.02;
	add_harmonic(&rom, (struct hawser_harmonic){.k = 1}, NULL, NULL, (double[]){0.6});
	if (hawser_rom_compile(&rom, NULL) || trace(&frf, &rom, "balance", 0.8, 1.3))
		return;
	rest_multipliers(log_modulus, argument, &rom, 0.8);
	for (int i = 0; i < 2; i++)
		ok(fabs(frf.multiplier[2*i] - log_modulus[i]) < 1e-10 &&
		   fabs(frf.multiplier[2*i + 1] - argument[i]) < 1e-10, "multiplier %d at rest", i);
	ok(frf.events == 2, "%d events", frf.events);
	for (int i = 0; i < frf.events; i++) {
		rest_multipliers(log_modulus, argument, &rom, frf.event[i].omega);
		ok(frf.event[i].kind == HAWSER_BRANCH_POINT && fabs(log_modulus[0]) < 1e-8 &&
		   argument[0] == 0.0, "branch point at %.12g, where a multiplier is 1%+.1e",
		   frf.event[i].omega, log_modulus[0]);
	}
	hawser_frf_clear(&frf);
	hawser_rom_clear(&rom);
}

CASE(unit_balance)
{
	check_jacobian();
	check_aliasing();
	check_convergence();
	check_active();
	check_start();
	check_failures();
	check_against_shooting();
	check_rest();
	return done_testing();
}
