/* Random ropeways: each has an answer, which closes and balances, or is refused where a battery
 * really is not pressed; carriers at the first and last points of contact; trains of sheaves
 * against circles; phases of a sweep against single states.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include <hawser/ropeway.h>

#include "tests/tap.h"

enum { TOWERS = 12 };

static double uniform(unsigned long *state, double low, double high)
{
	*state = *state*6364136223846793005UL + 1442695040888963407UL;
	return low + (high - low)*(double)(*state >> 11)/9007199254740992.0;
}

/* A line that climbs, with towers whose chords turn a little down: supports press there. Now and then
 * a tower is lower, so that it is a compression battery, or lifts off. */
static void draw(struct hawser_ropeway *rw, struct hawser_ropeway_tower *tower,
                 struct hawser_ropeway_case *load_case, unsigned long *state)
{
	double slope = uniform(state, 0.1, 0.7), x = 0.0, y = 0.0;

	*rw = (struct hawser_ropeway){
		.g = 9.81, .EA = uniform(state, 2e7, 1e8), .rho = uniform(state, 2.0, 8.0),
		.bottom_radius = 2.5, .top_radius = 2.2, .tension = HAWSER_ROPEWAY_COUNTERWEIGHT,
		.value = uniform(state, 1e5, 5e5), .wrap = 3.14159, .lanes = 2, .tower = tower,
		.load_case = load_case, .cases = 1, .spacing = uniform(state, 8.0, 90.0),
		.sliding = (enum hawser_ropeway_sliding)(int)uniform(state, 0.0, 3.0),
		.speed = uniform(state, 0.0, 6.0)};
	rw->towers = (int)uniform(state, 1.0, TOWERS + 1.0);
	memset(tower, 0, TOWERS*sizeof *tower);
	*load_case = (struct hawser_ropeway_case){
		"full", {uniform(state, 0.0, 40.0)*rw->spacing, uniform(state, 0.0, 40.0)*rw->spacing}};
	for (int i = 0; i < rw->towers; i++) {
		double step = uniform(state, 20.0, 250.0);

		x += step;
		y += slope*step;
		slope -= uniform(state, 0.02, 0.12);
		tower[i].at[0] = x;
		tower[i].at[1] = y - (uniform(state, 0.0, 1.0) < 0.1 ? uniform(state, 0.0, 0.1)*step : 0.0);
		tower[i].radius = uniform(state, 2.0, 9.0);
		tower[i].friction = uniform(state, -0.05, 0.08);
		tower[i].friction = tower[i].friction > 0.0 ? tower[i].friction : 0.0;
		snprintf(tower[i].name, sizeof tower[i].name, "p%d", i);
	}
	x += uniform(state, 20.0, 200.0);
	rw->top[0] = x;
	rw->top[1] = y + slope*(x - rw->tower[rw->towers - 1].at[0]);
	rw->phase = uniform(state, 0.0, rw->spacing);
	rw->phase_down = rw->spacing - rw->phase;
}

struct tally {
	int solved, refused, loose, other, unbalanced, unpressed, inconsistent, tangents;
	double balance, closure;
	struct hawser_report report;
};

/* Vertical momentum per time of the rope at a tension T and a slope angle a, N: rho v^2 |x'| sin a. */
static double momentum(const struct hawser_line *line, double T, double a)
{
	return line->rho*line->speed*line->speed*(1.0 + T/line->EA)*sin(a);
}

static void judge(struct tally *tally, const struct hawser_ropeway_statics *st)
{
	for (int i = 0; i < st->lanes; i++) {
		const struct hawser_ropeway_lane *lane = &st->lane[i];
		double up = lane->st.reaction_A[1] + lane->st.reaction_B[1], weight;

		for (int k = 0; k < st->ropeway->towers; k++) {
			up += lane->contact[k].reaction[1];
			tally->unpressed += lane->contact[k].touches && !(lane->contact[k].pressing > 0.0);
		}
		weight = st->ropeway->g*(st->ropeway->rho*lane->st.length0 +
		                         lane->carriers*st->ropeway->load_case[0].mass[i]) +
		         momentum(lane->line, lane->st.T_B, lane->st.angle_B) -
		         momentum(lane->line, lane->st.T_A, lane->st.angle_A);
		tally->balance = fmax(tally->balance, fabs(up - weight)/weight);
		tally->closure = fmax(tally->closure, lane->st.closure/lane->st.length);
	}
}

/* One ropeway and phase: refused exactly where the state that tolerates it has a battery without
 * contact. */
static void one(struct tally *tally, const struct hawser_ropeway *rw, double phase)
{
	const struct hawser_ropeway_options tolerant = {.tolerate = 1};
	struct hawser_ropeway_statics strict, loose;
	struct hawser_report report = {0}, second = {0};
	enum hawser_status a = hawser_ropeway_solve(&strict, rw, NULL, phase, &report);
	enum hawser_status b = hawser_ropeway_solve(&loose, rw, &tolerant, phase, &second);

	if (a && a != HAWSER_ERR_NO_SOLUTION) {
		tally->other++;
		tally->report = report;
	}
	if (b && b != HAWSER_ERR_NO_SOLUTION) {
		tally->other++;
		tally->report = second;
	}
	if (!a) {
		tally->solved++;
		judge(tally, &strict);
	} else {
		tally->refused++;
	}
	if (!b && loose.lifted) {
		tally->loose++;
		judge(tally, &loose);
	}
	if ((!a && (b || loose.lifted)) || (a && !b && !loose.lifted)) {
		tally->inconsistent++;
		tally->report = a ? report : second;
	}
	hawser_ropeway_statics_clear(&strict);
	hawser_ropeway_statics_clear(&loose);
}

/* Phases that put a carrier of lane up at the ends of the contacts, and beside them. */
static void tangents(struct tally *tally, const struct hawser_ropeway *rw)
{
	struct hawser_ropeway_statics st;

	if (hawser_ropeway_solve(&st, rw, NULL, rw->phase, NULL))
		return;
	for (int i = 0; i < 2*rw->towers; i++) {
		const struct hawser_ropeway_span *span = &st.lane[0].span[(i + 1)/2];
		double S = i%2 ? span->S_from : span->S_to;

		for (int k = -1; k <= 1; k++) {
			one(tally, rw, fmod(fmax(S + k*1e-7, 0.0), rw->spacing));
			tally->tangents++;
		}
	}
	hawser_ropeway_statics_clear(&st);
}

static void random_lines(int count)
{
	struct hawser_ropeway_tower tower[TOWERS];
	struct hawser_ropeway_case load_case;
	struct hawser_ropeway rw;
	struct tally tally = {0};
	unsigned long state = 2385;

	for (int i = 0; i < count; i++) {
		draw(&rw, tower, &load_case, &state);
		one(&tally, &rw, rw.phase);
		if (i%8 == 0)
			tangents(&tally, &rw);
	}
	ok(tally.other == 0,
	   "%d ropeways, %d states with a carrier at a point of contact: no failure but refusals%s%s",
	   count, tally.tangents, tally.other ? ": " : "", tally.other ? tally.report.message : "");
	ok(tally.inconsistent == 0,
	   "%d solved, %d refused, %d of them with a battery that is not pressed%s%s", tally.solved,
	   tally.refused, tally.loose, tally.inconsistent ? ": " : "",
	   tally.inconsistent ? tally.report.message : "");
	ok(tally.solved > count/2 && tally.loose > count/50, "both kinds are among them");
	ok(tally.unpressed == 0, "no battery pulls the rope");
	ok(tally.balance <= 1e-11, "weight, vertical forces and momentum differ by at most %.1e",
	   tally.balance);
	ok(tally.closure <= 1e-12, "the rope closes to %.1e of its length", tally.closure);
}

/* A ropeway whose three towers are pressed in all phases. */
static void plain(struct hawser_ropeway *rw, struct hawser_ropeway_tower *tower,
                  struct hawser_ropeway_case *load_case)
{
	static const double at[3][2] = {{70.0, 21.0}, {180.0, 50.0}, {262.0, 66.0}};

	*rw = (struct hawser_ropeway){
		.g = 9.81, .EA = 4.1e7, .rho = 3.85, .top = {350.0, 76.0}, .bottom_radius = 2.5,
		.top_radius = 2.2, .value = 1.613e5, .wrap = 3.14159, .lanes = 2, .tower = tower, .towers = 3,
		.load_case = load_case, .cases = 1, .spacing = 31.7, .phase_down = 11.3};
	memset(tower, 0, 3*sizeof *tower);
	for (int i = 0; i < 3; i++)
		tower[i] = (struct hawser_ropeway_tower){.at = {at[i][0], at[i][1]}, .radius = 9.3,
		                                         .friction = 0.023};
	*load_case = (struct hawser_ropeway_case){"full", {385.0, 162.0}};
}

/* Rows of a sweep are the states of its phases; the number of threads does not matter. */
static void sweeps(void)
{
	struct hawser_ropeway_tower tower[3];
	struct hawser_ropeway_case load_case;
	struct hawser_ropeway rw;
	struct hawser_ropeway_options options = {.phases = 23, .threads = 1};
	struct hawser_ropeway_worst worst, again;
	double T = 0.0, least = INFINITY;
	int good = 1;

	plain(&rw, tower, &load_case);
	good = !hawser_ropeway_sweep(&worst, &rw, &options, NULL);
	options.threads = 3;
	good = good && !hawser_ropeway_sweep(&again, &rw, &options, NULL);
	ok(good, "sweeps with 1 and 3 threads");
	if (!good)
		return;
	ok(!memcmp(worst.range, again.range, (size_t)worst.ranges*sizeof *worst.range),
	   "the same to the last bit");
	for (int i = 0; i < 23; i++) {
		struct hawser_ropeway_statics st;

		good = good && !hawser_ropeway_solve(&st, &rw, NULL, rw.spacing*i/23, NULL);
		if (!good)
			break;
		for (int k = 0; k <= rw.towers; k++)
			T = fmax(T, st.lane[0].span[k].T_max);
		least = fmin(least, st.lane[1].contact[2].pressing);
		hawser_ropeway_statics_clear(&st);
	}
	close_to(worst.lane[0].T.max, T, 1e-15, "largest tension of lane up");
	close_to(worst.lane[1].tower[2].pressing.min, least, 1e-15,
	         "least force on the last battery of lane down");
	hawser_ropeway_worst_clear(&worst);
	hawser_ropeway_worst_clear(&again);
}

/* Sheaves of a train, ever more and closer, approach the circle that they touch. */
static void trains(void)
{
	struct hawser_ropeway_tower tower[3];
	struct hawser_ropeway_case load_case;
	struct hawser_ropeway rw;
	struct hawser_ropeway_statics circle, train;
	double error[2];

	plain(&rw, tower, &load_case);
	ok(!hawser_ropeway_solve(&circle, &rw, NULL, 4.7, NULL), "circles");
	for (int n = 0; n < 2; n++) {
		for (int i = 0; i < 3; i++) {
			tower[i].sheaves = n ? 41 : 21;
			tower[i].spacing = n ? 0.1 : 0.2;
			tower[i].sheave = 0.02;
		}
		ok(!hawser_ropeway_solve(&train, &rw, NULL, 4.7, NULL), "trains of %d sheaves",
		   tower[0].sheaves);
		error[n] = fabs(train.lane[0].st.T_B/circle.lane[0].st.T_B - 1.0);
		hawser_ropeway_statics_clear(&train);
	}
	ok(error[0] < 1e-4 && error[1] < 3e-5, "T at the top differs by %.1e and %.1e", error[0], error[1]);
	hawser_ropeway_statics_clear(&circle);
}

/* Friction 0, no carriers, at rest: the tension follows from the height alone (T + T^2/2EA - w y is
 * constant), also on the sheaves. */
static void heights(void)
{
	struct hawser_ropeway_tower tower[3];
	struct hawser_ropeway_case load_case;
	struct hawser_ropeway rw;
	struct hawser_ropeway_statics st;
	double T;

	plain(&rw, tower, &load_case);
	load_case.mass[0] = load_case.mass[1] = 0.0;
	for (int i = 0; i < 3; i++)
		tower[i].friction = 0.0;
	rw.sliding = HAWSER_ROPEWAY_REST;
	ok(!hawser_ropeway_solve(&st, &rw, NULL, 0.0, NULL), "a bare rope");
	T = st.lane[0].st.T_B;
	close_to(T - st.T0 + (T*T - st.T0*st.T0)/(2.0*rw.EA),
	         rw.rho*rw.g*76.0, 1e-12, "its tension at the top, by the height");
	ok(fabs(st.force) < 1e-9 && fabs(st.travel) < 1e-9, "no force of the drive, no travel");
	hawser_ropeway_statics_clear(&st);
}

/* A counterweight W at rest: W/2 in each lane. The drive slips where its force exceeds
 * (exp(friction wrap) - 1) times the slack side. */
static void stations(void)
{
	struct hawser_ropeway_tower tower[3];
	struct hawser_ropeway_case load_case;
	struct hawser_ropeway rw;
	struct hawser_ropeway_statics st;
	struct hawser_report report = {0};
	double needed = 0.0, least;

	plain(&rw, tower, &load_case);
	rw.sliding = HAWSER_ROPEWAY_REST;
	rw.drive = 1;
	rw.drive_friction = 0.9;
	if (ok(!hawser_ropeway_solve(&st, &rw, NULL, 4.7, &report), "a counterweight")) {
		close_to(st.lane[0].st.T_A, 0.5*rw.value, 1e-15, "half of it on lane up");
		close_to(st.lane[1].st.T_A, 0.5*rw.value, 1e-15, "and on lane down");
		least = fmin(st.lane[0].st.T_B, st.lane[1].st.T_B);
		needed = st.needed_friction;
		close_to(fabs(st.force), expm1(needed*rw.wrap)*least, 1e-12, "force that just does not slip");
		hawser_ropeway_statics_clear(&st);
	}
	rw.drive_friction = needed*(1.0 + 1e-9);
	ok(!hawser_ropeway_solve(&st, &rw, NULL, 4.7, &report), "a friction just above it holds");
	hawser_ropeway_statics_clear(&st);
	rw.drive_friction = needed*(1.0 - 1e-9);
	ok(hawser_ropeway_solve(&st, &rw, NULL, 4.7, &report) == HAWSER_ERR_NO_SOLUTION &&
	   strstr(report.message, "slips"), "one just below it slips: %s", report.message);
}

CASE(property_ropeway)
{
	random_lines(getenv("HAWSER_LONG") ? 10000 : 60);
	sweeps();
	trains();
	heights();
	stations();
	return done_testing();
}
