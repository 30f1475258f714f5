/* bench/ropeway - statics of ropeways: what a sweep over the phases costs, and random lines.
 *
 *     bench/ropeway [-n LINES]
 *
 * (a) Worst values of a line of 12 towers with 40 carriers on each of its two lanes over 200
 * phases, with circles and with trains of sheaves as batteries: processor time. Each fifth phase is
 * verified: the lane is integrated step by step from A to B (tests/line-judge.h).
 * (b) LINES (2000) random lines (tests/line-random.h): how many have a solution, how many are
 * refused because of too low a tension, and how many fail or are wrong by the same integration. The
 * status is 1 if one is.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include <hawser/ropeway.h>

#include "bench/clock.h"
#include "tests/line-judge.h"

enum { TOWERS = 12, PHASES = 200, EACH = 5 };

/* Steps of the integration on each piece: an error of 1e-7 at most, and tried again with more. */
enum { STEPS = 60, MORE = 2000 };
static const double allowed = 1e-6;

static double miss(const struct hawser_line_statics *st)
{
	double off = integrated(st, STEPS);

	if (off > allowed)
		off = integrated(st, MORE);
	return isnan(off) ? INFINITY : off;
}

/* --- (a) --- */

static void draw_line(struct hawser_ropeway *rw, struct hawser_ropeway_tower *tower,
                      struct hawser_ropeway_case *load_case, int sheaves)
{
	double x = 0.0, y = 0.0, slope = 0.36;

	*rw = (struct hawser_ropeway){
		.g = 9.81, .EA = 9.5e7, .rho = 7.2, .bottom_radius = 2.5, .top_radius = 2.5, .value = 4.2e5,
		.wrap = 3.14159, .lanes = 2, .tower = tower, .towers = TOWERS, .load_case = load_case,
		.cases = 1, .spacing = 35.0, .phase_down = 35.0, .speed = 5.0};
	memset(tower, 0, TOWERS*sizeof *tower);
	for (int i = 0; i < TOWERS; i++, slope -= 0.023) {
		x += 110.0;
		y += 110.0*slope;
		tower[i] = (struct hawser_ropeway_tower){.at = {x, y}, .radius = 20.0, .friction = 0.025};
		if (sheaves) {
			tower[i].sheaves = sheaves;
			tower[i].spacing = 0.6;
			tower[i].sheave = 0.24;
		}
		snprintf(tower[i].name, sizeof tower[i].name, "t%d", i + 1);
	}
	rw->top[0] = x + 60.0;
	rw->top[1] = y + 60.0*slope;
	*load_case = (struct hawser_ropeway_case){"full", {750.0, 350.0}};
}

/* Largest defect of each fifth phase. */
static double verify(int *carriers, const struct hawser_ropeway *rw)
{
	struct hawser_ropeway_statics st;
	double worst = 0.0;

	for (int i = 0; i < PHASES; i += EACH) {
		if (hawser_ropeway_solve(&st, rw, NULL, rw->spacing*i/PHASES, NULL))
			return INFINITY;
		for (int lane = 0; lane < 2; lane++)
			worst = fmax(worst, miss(&st.lane[lane].st));
		*carriers = st.lane[0].carriers;
		hawser_ropeway_statics_clear(&st);
	}
	return worst;
}

static int sweep(int sheaves)
{
	struct hawser_ropeway_tower tower[TOWERS];
	struct hawser_ropeway_case load_case;
	struct hawser_ropeway rw;
	struct hawser_ropeway_worst worst;
	struct hawser_report report = {0};
	const struct hawser_ropeway_options options = {.phases = PHASES, .threads = 1};
	double before, seconds, off;
	int carriers = 0;

	draw_line(&rw, tower, &load_case, sheaves);
	off = verify(&carriers, &rw);
	before = cpu_secs();
	if (hawser_ropeway_sweep(&worst, &rw, &options, &report)) {
		printf("%s\n", report.message);
		return 1;
	}
	seconds = cpu_secs() - before;
	printf("%-19s %d carriers a lane   T = %.0f to %.0f N   %.2f s   largest defect %.1e\n",
	       sheaves ? "trains of 8 sheaves" : "circles", carriers, worst.lane[0].T.min,
	       worst.lane[0].T.max, seconds, off);
	hawser_ropeway_worst_clear(&worst);
	return !(off <= allowed);
}

/* --- (b) --- */

struct tally {
	int solved, refused, failed, wrong;
	double off, seconds;
};

static void judge(struct tally *tally, int number)
{
	struct line_random r;
	struct hawser_line_statics st;
	struct hawser_report report;
	enum hawser_status status;
	double before, off;

	line_random(&r, number);
	before = cpu_secs();
	status = hawser_line_solve(&st, &r.line, &report);
	tally->seconds += cpu_secs() - before;
	if (status == HAWSER_ERR_NO_SOLUTION && strstr(report.message, "has to be at least ")) {
		tally->refused++;
		return;
	}
	if (status) {
		printf("line %d: %s\n", number, report.message);
		tally->failed++;
		return;
	}
	tally->solved++;
	off = miss(&st);
	if (wrong(&st) || !(off <= allowed)) {
		printf("line %d: %s, defect %.1e\n", number, wrong(&st) ? wrong(&st) : "not closed", off);
		tally->wrong++;
	}
	tally->off = fmax(tally->off, off);
	hawser_line_statics_clear(&st);
}

int main(int argc, char **argv)
{
	struct tally tally = {0};
	int lines = 2000, bad, option;

	while ((option = getopt(argc, argv, "n:")) != -1) {
		if (option != 'n') {
			fprintf(stderr, "usage: %s [-n LINES]\n", argv[0]);
			return 2;
		}
		lines = atoi(optarg);
	}
	printf("worst values of 12 towers, 2 lanes, %d phases, one thread (processor time):\n", PHASES);
	bad = sweep(0) + sweep(8);
	for (int i = 0; i < lines; i++)
		judge(&tally, i);
	printf("%d random lines: %d solved, largest defect %.1e; %d with too low a tension; %d failed, %d "
	       "wrong; %.2g ms a line\n", lines, tally.solved, tally.off, tally.refused, tally.failed,
	       tally.wrong, 1e3*tally.seconds/lines);
	return bad || tally.failed || tally.wrong;
}
