/* Time integration at the limits of its parameters, by every method: forced Duffing oscillators and a
 * small cable against the reference of taylor.h, free oscillators against Jacobi's elliptic functions.
 *
 * The stated error is hawser_integrate_error of each row, from a second run with tighter tolerances.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <gsl/gsl_sf_elljac.h>

#include "tests/extremes/sweep.h"
#include "tests/extremes/taylor.h"
#include "tests/integrate-models.h"

static const double dampings[] = {0.0, 1e-9, 1.0, 20.0};
static const double dampings_long[] = {0.0, 1e-9, 1e-4, 1e-2, 0.3, 1.0, 10.0, 100.0};
static const double loads[] = {1e-12, 1e-2, 3.0, 1e4};
static const double omegas[] = {1e-3, 1.0, 1e3};
static const double tolerances[] = {1e-14, 1e-10, 1e-4};

#define ATOL 1e-18
enum { ROWS = 16 };
#define VALUES(a) (a), (int)(sizeof(a)/sizeof *(a))
enum { DAMPING, LOAD, OMEGA, RTOL, AXES };
static struct sweep_axis axis[AXES] = {
	{"damping", 0.02, VALUES(dampings), 1},
	{"load", 0.3, VALUES(loads), 2},
	{"Omega", 1.1, VALUES(omegas), 3},
	{"rtol", 1e-10, VALUES(tolerances), 3},
};

struct task {
	const char *method;
	struct hawser_rom (*make)(double damping, double load);
	double periods, longest; /* of the load, but no longer than this */
};

/* A run, with the stated errors of its rows: error [ROWS]. */
static enum hawser_status run(struct hawser_trajectory *trajectory, double *error,
                              const struct hawser_rom *rom, const char *method, double omega,
                              double until, double rtol, const double *initial,
                              struct hawser_report *report)
{
	struct hawser_integrate_options options = {.omega = omega, .until = until, .every = until/ROWS,
		.rtol = rtol, .atol = ATOL, .method = method, .initial = initial,
		.max_steps = sweep_long() ? 100000 : 10000};
	enum hawser_status status = hawser_integrate(trajectory, rom, &options, report);

	return status ? status : hawser_integrate_error(error, trajectory, rom, &options, report);
}

/* The row with the largest ratio of true to stated error. */
static void note(struct sweep_point *point, double error, double stated)
{
	if (!(error/stated <= point->error/point->stated)) {
		point->error = error;
		point->stated = stated;
	}
}

static void forced(struct sweep_point *point, const double *x, void *context)
{
	enum { MOST = 12 };
	const struct task *task = context;
	struct hawser_rom rom = task->make(x[DAMPING], x[LOAD]);
	struct taylor *taylor = taylor_new(&rom);
	struct hawser_trajectory trajectory;
	double until = fmin(task->periods*2.0*M_PI/x[OMEGA], task->longest), size = 0.0, stated[ROWS + 2];
	double initial[MOST] = {0.0};
	long double state[MOST] = {0.0L};
	int n = rom.n, m = 2*n;

	taylor_limit(taylor, sweep_long() ? 20000 : 2000);
	for (int j = 0; j < n; j++)
		state[j] = initial[j] = x[LOAD]*(1.0 - 0.3*j)/(1.0 + x[OMEGA]);
	point->stated = 1.0;
	point->status = run(&trajectory, stated, &rom, task->method, x[OMEGA], until, x[RTOL], initial,
	                    &point->report);
	for (int i = 0; !point->status && i < trajectory.rows*m; i++)
		size = fmax(size, fabs(trajectory.state[i]));
	for (int i = 1; !point->status && !point->skip && i < trajectory.rows; i++) {
		double gap = 0.0;

		point->skip |= taylor_move(taylor, state, NULL, x[OMEGA], trajectory.time[i - 1],
		                           trajectory.time[i]);
		for (int j = 0; j < m; j++)
			gap = fmax(gap, fabs(trajectory.state[i*m + j] - (double)state[j]));
		note(point, gap/size, stated[i]);
	}
	taylor_free(taylor);
	hawser_trajectory_clear(&trajectory);
	hawser_rom_clear(&rom);
}

/* --- free and undamped --- */

enum { AMPLITUDE, CUBIC, FREE_RTOL, FREE_AXES };
static const double amplitudes[] = {1e-12, 1e-2, 0.5, 0.999, 0.999999, 1.0, 30.0, 1e4};
static const double cubics[] = {-1.0, 0.0, 1e-6, 1e3};
static const struct sweep_axis free_axis[FREE_AXES] = {
	{"amplitude", 0.5, VALUES(amplitudes), 2},
	{"cubic", 1.0, VALUES(cubics), 2},
	{"rtol", 1e-10, VALUES(tolerances), 3},
};

/* u(0) = A at rest: A cn(w t, k) with w^2 = 1 + c A^2, k^2 = c A^2/(2 w^2); where c < 0 that is A
 * cd(W t, K) = A cn/dn with W^2 = 1 + c A^2/2, K^2 = -c A^2/(2 W^2). Beyond A^2 = -1/c the motion
 * escapes. */
static double jacobi(double A, double c, double t)
{
	double w2 = c < 0.0 ? 1.0 + 0.5*c*A*A : 1.0 + c*A*A, m = fabs(c)*A*A/(2.0*w2), sn, cn, dn;

	gsl_sf_elljac_e(sqrt(w2)*t, fmin(m, 1.0), &sn, &cn, &dn);
	return c < 0.0 ? A*cn/dn : A*cn;
}

static void unforced(struct sweep_point *point, const double *x, void *context)
{
	double A = x[AMPLITUDE], c = x[CUBIC], edge = 1.0 + c*A*A, initial[2] = {A, 0.0}, until;
	struct hawser_rom rom = model_oscillator(0.0, 1.0, c, 0.0);
	struct hawser_trajectory trajectory;
	double stated[ROWS + 2], size = A*sqrt(fmax(1.0, edge));

	until = 20.0/sqrt(fmax(1.0, edge));
	point->stated = 1.0;
	point->status = run(&trajectory, stated, &rom, context, 1.0, until, x[FREE_RTOL], initial,
	                    &point->report);
	if (edge > 0.0) {
		for (int i = 1; !point->status && i < trajectory.rows; i++) {
			double want = jacobi(A, c, trajectory.time[i]), *at = trajectory.state + 2*i;
			double energy = 0.5*(at[1]*at[1] + at[0]*at[0]) + 0.25*c*pow(at[0], 4);
			double all = 0.5*A*A + 0.25*c*pow(A, 4);

			/* Jacobi's functions by GSL lose some digits themselves */
			note(point, fabs(at[0] - want)/size, stated[i] + 1e-13);
			note(point, fabs(energy - trajectory.energy[i])/all, 1e-13);
		}
	} else {
		/* at rest on the separatrix; beyond it the motion must escape */
		if (!point->status && edge < 0.0)
			point->error = INFINITY;
	}
	hawser_trajectory_clear(&trajectory);
	hawser_rom_clear(&rom);
}

static struct hawser_rom duffing(double damping, double load)
{
	return model_oscillator(2.0*damping, 1.0, 1.0, load);
}

CASE(extremes_sweep_integrate)
{
	if (sweep_long()) {
		axis[DAMPING].value = dampings_long;
		axis[DAMPING].count = sizeof dampings_long/sizeof *dampings_long;
	}
	for (int i = 0; hawser_integrate_method(i); i++) {
		const char *method = hawser_integrate_method(i)->name;
		struct task task = {method, duffing, 3.0, sweep_long() ? 40.0 : 15.0};
		struct task cable = {method, model_cable, 3.0, 10.0};
		struct sweep_tally tally;
		char name[80];

		snprintf(name, sizeof name, "integrate %s", method);
		tally = sweep_pairs(name, axis, AXES, forced, &task);
		ok(tally.right > tally.points/2, "more than half of the points are right: %d of %d",
		   tally.right, tally.points);
		snprintf(name, sizeof name, "integrate %s, free", method);
		sweep_pairs(name, free_axis, FREE_AXES, unforced, (void *)(uintptr_t)method);
		snprintf(name, sizeof name, "integrate %s, cable", method);
		if (sweep_long())
			sweep_pairs(name, axis, AXES, forced, &cable);
	}
	return done_testing();
}
