/* A ropeway in motion against routes that share no code with its steps: modes of the loop, closed forms
 * of a rigid rope, of a wave, of a rope that slips and of a brake, the statics of the running rope, and
 * the balance of energy.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include <lapacke.h>

#include <hawser/ropeway_modes.h>

#include "ropeway/transient/transient.h"
#include "tests/tap.h"

#define PI 3.14159265358979323846

static struct hawser_ropeway_case load_case = {"full", {400.0, 250.0}};
static struct hawser_ropeway_tower tower[2] = {
	{.name = "p0", .at = {80.0, 17.0}, .battery = HAWSER_ROPEWAY_SUPPORT, .radius = 12.0,
	 .friction = 0.03},
	{.name = "p1", .at = {190.0, 40.0}, .battery = HAWSER_ROPEWAY_SUPPORT, .radius = 12.0,
	 .friction = 0.03}};

static struct hawser_ropeway small(void)
{
	load_case = (struct hawser_ropeway_case){"full", {400.0, 250.0}};
	return (struct hawser_ropeway){.g = 9.81, .EA = 40e6, .rho = 4.0, .top = {300.0, 58.0},
		.bottom_radius = 2.5, .top_radius = 2.5, .value = 168e3, .carriage = 20e3, .speed = 4.0,
		.ramp = 10.0, .brake = 1.25, .drive_friction = 0.2, .drive = 1, .wrap = PI, .tower = tower,
		.towers = 2, .lanes = 2, .spacing = 36.6, .phase = 18.3, .phase_down = 18.3,
		.load_case = &load_case, .cases = 1};
}

/* A level rope without carriers, batteries and friction, and nearly without weight: a bar. */
static struct hawser_ropeway bar(void)
{
	struct hawser_ropeway rw = small();

	rw.towers = 0;
	rw.g = 1e-6;
	rw.spacing = 0.0;
	rw.top[0] = 500.0;
	rw.top[1] = 0.0;
	return rw;
}

/* --- frequencies --- */

enum { MOST = 200 };

/* Energies are quadratic: their matrices follow from values at unit vectors and sums of two. */
static double *coordinate(struct hawser__chain *chain, int i, int speed)
{
	int n = chain->N - 1; /* the drive, which is last, keeps its place */

	return i < n ? (speed ? chain->q : chain->u) + i : (speed ? chain->sag_q : chain->sag) + i - n;
}

static int frequencies(double *omega, struct hawser__chain *chain)
{
	static double K[MOST*MOST], M[MOST*MOST], single[MOST];
	int n = chain->N - 1 + 2*chain->slow->spans;

	for (int i = 0; i < n; i++) {
		*coordinate(chain, i, 0) = *coordinate(chain, i, 1) = 1.0;
		single[i] = hawser__chain_stored(chain);
		M[i*n + i] = 2.0*hawser__chain_kinetic(chain, chain->mass);
		*coordinate(chain, i, 0) = *coordinate(chain, i, 1) = 0.0;
		K[i*n + i] = 2.0*single[i];
	}
	for (int i = 0; i < n; i++)
		for (int j = 0; j < i; j++) {
			*coordinate(chain, i, 0) = *coordinate(chain, j, 0) = 1.0;
			K[i*n + j] = K[j*n + i] = hawser__chain_stored(chain) - single[i] - single[j];
			*coordinate(chain, i, 0) = *coordinate(chain, j, 0) = 0.0;
			M[i*n + j] = M[j*n + i] = 0.0;
		}
	if (LAPACKE_dsygv(LAPACK_ROW_MAJOR, 1, 'N', 'L', n, K, n, M, n, omega))
		return 0;
	for (int i = 0; i < n; i++)
		omega[i] = sqrt(omega[i]);
	return n;
}

static void modes(void)
{
	struct hawser_ropeway rw = small();
	struct hawser_transient_options o = {.elements = 7, .phases = 1, .step = 1e-3};
	struct hawser_ropeway_modes_options mo = {.n = 14};
	struct hawser__slow slow;
	struct hawser__chain chain;
	struct hawser_ropeway_statics st;
	struct hawser_line_modes exact;
	struct hawser_report report = {0};
	double omega[MOST];
	int n = 0, k = 0;

	tower[0].friction = tower[1].friction = 0.0;
	rw.phase = 0.0;
	rw.phase_down = 0.0;
	rw.sliding = HAWSER_ROPEWAY_REST;
	rw.hold = HAWSER_ROPEWAY_HOLD_SLIP;
	if (!ok(!hawser__slow_open(&slow, &rw, &o, &report) &&
	        !hawser__chain_open(&chain, &rw, &slow, &o, &report) &&
	        !hawser__chain_begin(&chain, 0.0, &report) &&
	        !hawser_ropeway_solve(&st, &rw, NULL, 0.0, &report) &&
	        !hawser_ropeway_modes_solve(&exact, &st, &mo, &report), "modes: %s", report.message))
		return;
	n = frequencies(omega, &chain);
	ok(n > 0, "%d frequencies of the chain", n);
	/* The chain has one mode of each span, of smeared masses: the spans of two carriers, modes 5 and 6,
	 * are worst. */
	for (int i = 0; i < exact.n && k < 6; i++)
		if (exact.mode[i].plane == HAWSER_IN_PLANE) {
			close_to(omega[k], exact.mode[i].omega/exact.time_unit, k < 4 ? 0.03 : 0.06,
			         "frequency of the loop");
			k++;
		}
	tower[0].friction = tower[1].friction = 0.03;
	hawser_line_modes_clear(&exact);
	hawser_ropeway_statics_clear(&st);
	hawser__chain_clear(&chain);
	hawser__slow_clear(&slow);
}

/* --- runs --- */

static int run_of(struct hawser_transient *run, const struct hawser_ropeway *rw,
                  struct hawser_transient_options o)
{
	struct hawser_report report = {0};

	o.phases = o.phases ? o.phases : 100;
	if (ok(!hawser_transient_solve(run, rw, &o, &report), "a run %s", report.message))
		return ok(run->energy.closure < 1e-10, "  its energy is closed to %.1e", run->energy.closure);
	return 0;
}

/* T - rho v^2 of two lanes, with the inertia of half of the rope on the bullwheel at each. */
static double ratio(const struct hawser_transient_row *row, double rho, double acceleration)
{
	double thrust = rho*row->speed*row->speed, half = 0.5*rho*PI*2.5*acceleration;

	return (row->T_up - thrust + half)/(row->T_down - thrust - half);
}

/* All masses have the acceleration of the drive; a wave needs the length over its speed. */
static void rigid(void)
{
	struct hawser_ropeway rw = bar();
	struct hawser_transient run;
	struct hawser_transient_options o = {.until = 5.0, .every = 0.01, .elements = 101, .damping = 0.7,
	                                     .skip_error = 1};
	double mass = 2.0*500.0*4.0/(1.0 + 84e3/40e6) + 2.0*PI*2.5*4.0, around, wave;
	const struct hawser_transient_row *last;

	if (!run_of(&run, &rw, o))
		return;
	last = &run.row[run.rows - 1];
	close_to(run.mass, mass, 1e-4, "  mass of the rope");
	close_to(last->force, run.mass*0.4, 1e-3, "  force of a rigid rope");
	/* the tension at the bottom station is that of the middle of the last element */
	close_to(last->T_up - last->T_bottom_up, 0.4*2000.0/(1.0 + 84e3/40e6)*(1.0 - 0.5/101.0), 1e-4,
	         "  tension of a lane");
	hawser_transient_clear(&run);
	o.damping = 0.0;
	o.until = 0.5;
	o.every = 0.001;
	if (!run_of(&run, &rw, o))
		return;
	/* The force of two waves, rho c a t on each side of the drive, until each has gone around the
	 * loop to the other side and is reflected there, which doubles it: the force then falls as fast. */
	around = (run.mass/4.0)*sqrt(4.0/40e6);
	wave = 2.0*sqrt(4.0*40e6)*0.4;
	close_to(run.row[(int)(900.0*around)].force, wave*floor(900.0*around)/1000.0, 0.01,
	         "  force of two waves");
	close_to(run.row[(int)(1100.0*around)].force,
	         wave*(2.0*around - floor(1100.0*around)/1000.0), 0.02, "  and after they arrived");
	hawser_transient_clear(&run);
}

/* A brake of constant deceleration, and one of constant force on a rope that nothing else brakes. */
static void brakes(void)
{
	struct hawser_ropeway rw = bar();
	struct hawser_transient run;
	struct hawser_transient_options o = {.event = HAWSER_TRANSIENT_STOP, .until = 8.0, .every = 0.02,
	                                     .damping = 0.7, .elements = 3, .skip_error = 1};
	double friction;

	if (!run_of(&run, &rw, o))
		return;
	close_to(run.stopped_at, 3.2, 0.02, "  time to stop");
	close_to(run.row[run.rows - 1].travelled, 4.0*4.0/2.5, 1e-3, "  distance");
	hawser_transient_clear(&run);
	rw.brake = 0.0;
	rw.brake_force = 4000.0;
	rw.top_inertia = 6.25*1500.0;
	if (!run_of(&run, &rw, o))
		return;
	close_to(run.energy.work, -0.5*run.mass*16.0, 2e-3, "  work of the brake");
	close_to(run.row[run.rows - 1].travelled, 0.5*run.mass*16.0/4000.0, 0.02, "  distance by force");
	hawser_transient_clear(&run);

	/* The same brake with a bullwheel that is too smooth: the rope slips at the ratio e^(mu wrap). */
	o.tolerate = 1;
	rw.drive_friction = friction = 0.004;
	if (!run_of(&run, &rw, o))
		return;
	ok(run.slips > 100 && run.slipped > 0.1, "  %ld steps of slip, %g m", run.slips, run.slipped);
	close_to(ratio(&run.row[40], rw.rho, (run.row[41].speed - run.row[39].speed)/0.04),
	         exp(-friction*PI), 1e-6, "  ratio of the tensions");
	ok(run.row[40].wheel < run.row[40].speed, "  the bullwheel is slower than the rope");
	hawser_transient_clear(&run);
}

/* The running rope in equilibrium: exact statics with friction, solved from the bottom station on. */
static void steady(void)
{
	struct hawser_ropeway rw = small();
	struct hawser_ropeway_statics st;
	struct hawser_transient run;
	struct hawser_transient_options o = {.event = HAWSER_TRANSIENT_RUN, .until = 9.15, .skip_error = 1};

	if (!ok(!hawser_ropeway_solve(&st, &rw, NULL, rw.phase, NULL), "statics of the running rope") ||
	    !run_of(&run, &rw, o))
		return;
	close_to(run.row[0].force, st.force, 2e-3, "  force of the drive");
	close_to(run.row[0].T_up, st.lane[0].st.T_B, 1e-4, "  tension at the drive");
	close_to(run.row[0].travel, st.travel, 5e-3, "  travel of the carriage");
	ok(run.force.max < 5600.0 && run.force.min > 3000.0, "  force from %g to %g N, in statics "
	                                                     "from 3453 "
	   "to 5320 N", run.force.min, run.force.max);
	hawser_transient_clear(&run);
	rw.tension = HAWSER_ROPEWAY_EMPTY; /* a fixed carriage */
	rw.value = 84e3;
	hawser_ropeway_statics_clear(&st);
	if (ok(!hawser_ropeway_solve(&st, &rw, NULL, rw.phase, NULL), "statics with a fixed carriage") &&
	    run_of(&run, &rw, o)) {
		close_to(run.row[0].T_bottom_up, st.T0, 1e-3, "  tension at the bottom station");
		close_to(run.row[0].force, st.force, 3e-3, "  force of the drive");
		hawser_transient_clear(&run);
	}
	hawser_ropeway_statics_clear(&st);
}

static enum hawser_status refusal(const struct hawser_ropeway *rw, enum hawser_transient_event event,
                                  const char *text)
{
	struct hawser_transient run;
	struct hawser_report report = {0};
	const struct hawser_transient_options o = {.event = event, .phases = 10, .skip_error = 1,
	                                           .elements = 1};
	enum hawser_status status = hawser_transient_solve(&run, rw, &o, &report);

	ok(status && strstr(report.message, text), "refused: %s", report.message);
	if (!status)
		hawser_transient_clear(&run);
	return status;
}

static void refusals(void)
{
	struct hawser_ropeway rw = small();

	rw.ramp = 0.0;
	refusal(&rw, HAWSER_TRANSIENT_START, "ramp is missing or 0");
	rw.brake = 0.0;
	refusal(&rw, HAWSER_TRANSIENT_STOP, "brake is missing");
	rw.speed = 0.0;
	refusal(&rw, HAWSER_TRANSIENT_RUN, "speed is missing or 0");
	rw = small();
	rw.carriage = 0.0;
	refusal(&rw, HAWSER_TRANSIENT_START, "bottom.mass is missing or 0");
	rw = small();
	rw.lanes = 1;
	refusal(&rw, HAWSER_TRANSIENT_START, "down: off");
	rw = small();
	rw.sliding = HAWSER_ROPEWAY_REVERSE;
	refusal(&rw, HAWSER_TRANSIENT_START, "sliding: reverse");
	rw = small();
	rw.drive_friction = 0.02;
	refusal(&rw, HAWSER_TRANSIENT_START, "slips on the whole drive bullwheel");
	rw = small();
	rw.stops = 1;
	rw.travel[1] = 0.26;
	refusal(&rw, HAWSER_TRANSIENT_STOP, "the carriage is at its stop");
	rw = small();
	rw.drive_friction = 9.0;
	rw.brake = 60.0;
	refusal(&rw, HAWSER_TRANSIENT_STOP, "becomes slack");
	rw = small();
	rw.drive = 0;
	tower[1].at[1] = 29.5;
	refusal(&rw, HAWSER_TRANSIENT_STOP, "leaves the battery of tower");
	tower[1].at[1] = 40.0;
}

/* The carrier is in the span, at its first point of contact, on the arc, at the last, in the span. */
static void passing(void)
{
	struct hawser_ropeway rw = small();
	struct hawser_passing pass;
	struct hawser_report report = {0};
	int seen = 0, last = 0, wrong = 0;

	for (int lane = 0; lane < 2; lane++) {
		if (!ok(!hawser_passing_solve(&pass, &rw, 0, lane, 1, 0.0, 101, &report), "passing: %s",
		        report.message))
			return;
		last = pass.row[0].state;
		seen = 0;
		wrong = last != 0;
		for (int i = 1; i < pass.rows; i++) {
			const struct hawser_passing_row *row = &pass.row[i];
			int step = lane ? (last + 3)%4 : (last + 1)%4;

			wrong += row->state != last && row->state != step;
			seen += row->state != last;
			wrong += !(row->carried >= 0.0 && row->carried <= 9.81*load_case.mass[lane]);
			last = row->state;
		}
		ok(!wrong && seen == 4 && last == 0, "  four changes of state in order (%d, %d wrong)", seen,
		   wrong);
		hawser_passing_clear(&pass);
	}
}

CASE(property_transient)
{
	modes();
	rigid();
	brakes();
	steady();
	passing();
	refusals();
	return done_testing();
}
