/* Branches that begin at bifurcations: motions of two and four periods of a softening oscillator, and
 * the whirling of two equal oscillators. Their orbits are checked by integration in time.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <hawser/branches.h>
#include <hawser/integrate.h>

#include "tests/tap.h"

/* Distance of the state after `periods` periods of the load from the one at their start, relative. */
static double closes(const struct hawser_rom *rom, const double *state, double omega, int periods)
{
	double until = periods*2.0*M_PI/omega, gap = 0.0, whole = 0.0;
	struct hawser_integrate_options options = {.omega = omega, .until = until, .every = until,
		.rtol = 1e-11, .initial = state};
	struct hawser_trajectory run;

	if (hawser_integrate(&run, rom, &options, NULL))
		return NAN;
	for (int i = 0; i < 2*rom->n; i++) {
		double end = run.state[(size_t)(run.rows - 1)*2*rom->n + i];

		gap += (end - state[i])*(end - state[i]);
		whole += state[i]*state[i];
	}
	hawser_trajectory_clear(&run);
	return sqrt(gap/whole);
}

/* u" + 0.4 u' + u - u^2 = 0.25 cos(tau): a cascade of period doublings. */
static const char cascade[] = "{\"n\": 1, \"K\": [[1]], \"D\": [[0.4]], \"Q\": [[0, 0, 0, -1]],"
	" \"harmonics\": [{\"k\": 1, \"phase\": \"cos\", \"f\": [0.25]}]}";
/* A taut string's first modes in two planes, one of them loaded. */
static const char string[] = "{\"n\": 2, \"K\": [[1, 0], [0, 1.02]], \"D\": [[0.02, 0], [0, 0.02]],"
	" \"C\": [[0, 0, 0, 0, 0.5], [0, 0, 1, 1, 0.5], [1, 1, 1, 1, 0.5], [1, 0, 0, 1, 0.5]],"
	" \"harmonics\": [{\"k\": 1, \"phase\": \"cos\", \"f\": [0.03, 0]}]}";

/* Two oscillators in 2:1 resonance, of which the fast one is loaded. */
static const char two_to_one[] = "{\"n\": 2, \"D\": [[0.02, 0], [0, 0.04]], \"K\": [[1, 0], [0, 4]],"
	" \"Q\": [[0, 0, 1, 0.8], [1, 0, 0, 0.4]], \"C\": [[0, 0, 0, 0, 0.15], [1, 1, 1, 1, 0.3]],"
	" \"harmonics\": [{\"k\": 1, \"f\": [0, 0.12]}]}";

static int read_model(struct hawser_rom *rom, const char *text)
{
	char name[] = "/tmp/hawser-branches-XXXXXX";
	int file = mkstemp(name), fine = file >= 0 && write(file, text, strlen(text)) > 0;

	fine = fine && !hawser_rom_open(rom, name, NULL);
	close(file);
	remove(name);
	return ok(fine, "a model");
}

static int find(const struct hawser_frf *frf, enum hawser_event_kind kind)
{
	for (int e = 0; e < frf->events; e++)
		if (frf->event[e].kind == kind)
			return e;
	return -1;
}

/* Motions of 2, 4, ... periods to the given depth. The ratio of the distances of the period doublings
 * tends to Feigenbaum's 4.669; the first ones are 5.55, 4.83 and 4.69. Later methods find the period
 * doublings of the first. */
static void check_cascade(const char *method, int deep, double wanted)
{
	static double first[9];
	struct hawser_frf_options options = {.from = 1.6, .to = 0.7, .step_max = 0.01, .method = method,
		.samples = HAWSER_NONE};
	struct hawser_report report = {.message = ""};
	struct hawser_rom rom;
	struct hawser_frf frf, branch;
	double at[9] = {0.0};

	if (!read_model(&rom, cascade) || !ok(!hawser_frf_trace(&frf, &rom, &options, &report), "response"))
		return;
	for (int k = 0; k <= deep; k++) {
		int e = find(&frf, HAWSER_PERIOD_DOUBLING), near;

		if (!ok(e >= 0, "%s: a period doubling of period %d", method, frf.period))
			break;
		at[k] = frf.event[e].omega;
		if (k == deep || !ok(!hawser_branch_switch(&branch, &rom, &frf, e, &options, &report),
		                     "the branch at Omega %.9g %s", at[k], report.message))
			break;
		near = branch.points > 2 && branch.point[2].unstable == 0 ? 2 : 0;
		/* stable: integration does not leave it */
		ok(branch.period == 2 << k && branch.point[near].unstable == 0 &&
		   closes(&rom, branch.state + 2*near, branch.point[near].omega, branch.period) < 1e-6 &&
		   closes(&rom, branch.state + 2*near, branch.point[near].omega, branch.period/2) > 1e-5,
		   "a motion of %d periods of the load, not fewer: %.1e, %.1e", branch.period,
		   closes(&rom, branch.state + 2*near, branch.point[near].omega, branch.period),
		   closes(&rom, branch.state + 2*near, branch.point[near].omega, branch.period/2));
		hawser_frf_clear(&frf);
		frf = branch;
	}
	close_to((at[0] - at[1])/(at[1] - at[2]), 5.549, 3e-3, "first ratio");
	for (int k = 0; k <= deep; k++) {
		if (first[k] > 0.0)
			close_to(at[k], first[k], 1e-8, "by another method");
		first[k] = at[k];
	}
	if (wanted > 0.0)
		close_to((at[deep - 2] - at[deep - 1])/(at[deep - 1] - at[deep]), 4.669201, wanted,
		         "last ratio");
	hawser_frf_clear(&frf);
	hawser_rom_clear(&rom);
}

/* A distance at which there is no orbit. */
static void check_beyond(void)
{
	double state[2] = {0.1, 0.0}, along[2] = {40.0, -90.0};
	struct hawser_frf_options options = {.from = 1.6, .to = 0.7, .start = state, .along = along};
	struct hawser_report report = {.message = ""};
	struct hawser_rom rom;
	struct hawser_frf frf;

	if (!read_model(&rom, cascade))
		return;
	ok(hawser_frf_trace(&frf, &rom, &options, &report) == HAWSER_ERR_CONVERGENCE,
	   "far away: %s", report.message);
	hawser_frf_clear(&frf);
	hawser_rom_clear(&rom);
}

/* The motion in the loaded plane becomes unstable at a branch point, and one in both planes is born
 * there. It ends where the other branch point of the plane motion is. */
static void check_whirling(const char *method)
{
	struct hawser_frf_options options = {.from = 0.9, .to = 1.4, .method = method};
	struct hawser_report report = {.message = ""};
	struct hawser_rom rom;
	struct hawser_frf frf, branch;
	int e, near = 2;
	double back = INFINITY, apart = INFINITY;

	if (!read_model(&rom, string) || !ok(!hawser_frf_trace(&frf, &rom, &options, &report), "response"))
		return;
	e = find(&frf, HAWSER_BRANCH_POINT);
	if (ok(e >= 0 && !hawser_branch_switch(&branch, &rom, &frf, e, &options, &report),
	       "a branch at a branch point %s", report.message)) {
		ok(branch.period == 1 && branch.points > 20 && branch.coordinate[2*near + 1] > 0.0 &&
		   closes(&rom, branch.state + 4*near, branch.point[near].omega, 1) < 1e-8,
		   "moves out of the loaded plane");
		for (int k = 0; k < branch.events; k++)
			for (int j = e + 1; j < frf.events; j++)
				if (frf.event[j].kind == HAWSER_BRANCH_POINT)
					back = fmin(back, fabs(branch.event[k].omega/frf.event[j].omega
					                       - 1.0));
		for (int p = 0; p < branch.points; p++)
			apart = fmin(apart, branch.point[p].unstable);
		ok(branch.end == HAWSER_END_MEETS && branch.events == 4 &&
		   branch.event[3].kind == HAWSER_BRANCH_POINT && branch.event[3].after == branch.points - 1 &&
		   fabs(branch.event[3].omega/branch.born - 1.0) > 1e-3, "%s: it ends at the other branch "
		   "point, and is not followed back on its mirror image (%d events)", method, branch.events);
		ok(back < 1e-8 && apart == 0.0, "stable at first; back to the plane at its other branch "
		   "point: %.1e", back);
		hawser_frf_clear(&branch);
	}
	ok(hawser_branch_switch(&branch, &rom, &frf, find(&frf, HAWSER_FOLD), &options, &report) ==
	   HAWSER_ERR_ARGUMENT, "a fold begins none: %s", report.message);
	ok(hawser_branch_trace(&branch, &rom, 0, &options, &report) == HAWSER_ERR_ARGUMENT,
	   "a motion of no period: %s", report.message);
	hawser_frf_clear(&branch);
	for (int k = 0, past = hawser_frf_label(&frf, 5, 7); k < frf.events; k++)
		ok(frf.event[k].label > 5 && frf.event[k].label < past &&
		   (frf.event[k].kind == HAWSER_BRANCH_POINT ||
		    closes(&rom, frf.event_state + 4*k, frf.event[k].omega, 1) < 1e-7),
		   "event %d has a label and its motion", k);
	hawser_frf_clear(&frf);
	hawser_rom_clear(&rom);
}

/* Motions of two periods between two period doublings of the response: each orbit is met again
 * shifted by one period of the load, which is no other motion. And one that leaves the range at
 * the end from which it was followed, though it did not begin there. */
static void check_loop(const char *method, double load, enum hawser_frf_end end, int events)
{
	struct hawser_frf_options options = {.from = 0.8, .to = 2.4, .method = method,
		.samples = HAWSER_NONE};
	struct hawser_report report = {.message = ""};
	struct hawser_rom rom;
	struct hawser_frf frf, branch;
	int e;

	if (!read_model(&rom, two_to_one))
		return;
	rom.harmonic[0].f[1] = load;
	if (!ok(!hawser_frf_trace(&frf, &rom, &options, &report), "response %s", report.message))
		return;
	e = find(&frf, HAWSER_PERIOD_DOUBLING);
	if (ok(e >= 0 && !hawser_branch_switch(&branch, &rom, &frf, e, &options, &report),
	       "a branch at a period doubling %s", report.message)) {
		const struct hawser_frf_event *last = &branch.event[branch.events - 1];
		int other = 0;

		for (int k = e + 1; k < frf.events; k++)
			other += frf.event[k].kind == HAWSER_PERIOD_DOUBLING &&
			         fabs(frf.event[k].omega/last->omega - 1.0) < 1e-7;
		ok(branch.end == end && branch.events == events && branch.period == 2 &&
		   other == (end == HAWSER_END_MEETS),
		   "%s, load %g: %s after %d events, the last one at %.9g", method, load,
		   hawser_frf_end_name(branch.end), branch.events, last->omega);
		hawser_frf_clear(&branch);
	}
	hawser_frf_clear(&frf);
	hawser_rom_clear(&rom);
}

CASE(property_branches)
{
	int more = getenv("HAWSER_LONG") ? 2 : 0;

	check_cascade("shooting", 5 + more, more ? 1e-4 : 2e-3);
	check_cascade("balance", 3 + more, more ? 2e-3 : 0.0);
	check_beyond();
	check_whirling("shooting");
	check_whirling("balance");
	check_loop("shooting", 0.12, HAWSER_END_MEETS, 5);
	check_loop("balance", 0.05, HAWSER_END_MEETS, 3);
	check_loop("balance", 0.05025, HAWSER_END_MEETS, 3); /* both tests change there, in two steps */
	check_loop("balance", 0.05675, HAWSER_END_MEETS, 3);
	check_loop("balance", 0.2, HAWSER_END_RANGE, 3);
	return done_testing();
}
