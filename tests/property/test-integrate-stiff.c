/* A coordinate much faster than the motion: it is integrated with the steps of the motion if it
 * hardly vibrates, and resolved if it does. Coordinates that are not modes begin in their steady
 * state.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "response/orbit/rest.h"
#include "tests/integrate-models.h"

#define OMEGA 1.385
#define UNTIL 60.0
#define FAST 451.0

/* V = (u0^2 + 5.3 u1^2)/2 + u0^4/4 + (FAST f + (c/FAST)(u0^2 - u0 u1))^2/2, written as monomials.
 * As in a condensed model, the stiffness between f and the others, about 2 c u0, changes sign
 * within a period of the motion. */
static struct hawser_rom follower(double damping, double load)
{
	const double c = 6.1e4, r = c*c/(2.0*FAST*FAST), f[3] = {0.05, 0.02, load};
	struct hawser_rom rom = model_new(3);

	rom.K[0] = 1.0;
	rom.K[4] = 5.3;
	rom.K[8] = FAST*FAST;
	for (int j = 0; j < 9; j += 4)
		rom.D[j] = damping;
	model_quad(&rom, 2, 0, 0, c);
	model_quad(&rom, 2, 0, 1, -c);
	model_quad(&rom, 0, 0, 2, 2.0*c);
	model_quad(&rom, 0, 1, 2, -c);
	model_quad(&rom, 1, 0, 2, -c);
	model_cubic(&rom, 0, 0, 0, 0, 1.0 + 4.0*r);
	model_cubic(&rom, 0, 0, 0, 1, -6.0*r);
	model_cubic(&rom, 0, 0, 1, 1, 2.0*r);
	model_cubic(&rom, 1, 0, 0, 0, -2.0*r);
	model_cubic(&rom, 1, 0, 0, 1, 2.0*r);
	model_force(&rom, HAWSER_COS, 0, f);
	rom.inertia.shapes = 1;
	model_compile(&rom);
	return rom;
}

static double distance(const struct hawser_trajectory *a, const struct hawser_trajectory *b)
{
	double worst = 0.0, size = 0.0;

	for (int i = 0; i < a->rows*2*a->n; i++) {
		worst = fmax(worst, fabs(a->state[i] - b->state[i]));
		size = fmax(size, fabs(b->state[i]));
	}
	return worst/size;
}

static void check_followed(void)
{
	struct hawser_rom rom = follower(0.03, 0.3);
	struct hawser_trajectory exact = model_run(&rom, "gauss", OMEGA, UNTIL, 0.173, 1e-13, NULL);

	for (int digits = 5; digits <= 10; digits += 5) {
		struct hawser_trajectory run = model_run(&rom, NULL, OMEGA, UNTIL, 0.173,
		                                         pow(10.0, -digits), NULL);
		double error = distance(&run, &exact);

		ok(!strcmp(run.method, "radau") && 8*run.steps < exact.steps,
		   "auto follows the motion: %s, %ld steps against %ld that follow the fast coordinate",
		   run.method, run.steps, exact.steps);
		ok(error < 30.0*pow(10.0, -digits), "with an error of %.1e at 1e-%d", error, digits);
		hawser_trajectory_clear(&run);
	}
	hawser_trajectory_clear(&exact);
	hawser_rom_clear(&rom);
}

/* Vibrations above the tolerance must be resolved, whatever the cost. */
static void check_resolved(void)
{
	const double plucked[6] = {0.2, -0.1, 1e-3, 0.0, 0.3, 0.0};
	struct hawser_rom rom = follower(0.0, 0.0);
	struct hawser_trajectory exact = model_run(&rom, "gauss", OMEGA, 20.0, 0.173, 1e-13, plucked);
	struct hawser_trajectory gauss = model_run(&rom, "gauss", OMEGA, 20.0, 0.173, 1e-9, plucked);
	struct hawser_trajectory run = model_run(&rom, NULL, OMEGA, 20.0, 0.173, 1e-9, plucked);
	struct hawser_trajectory stiff = model_run(&rom, "radau", OMEGA, 20.0, 0.173, 1e-9, plucked);

	/* 1400 periods of the fast coordinate, with an error of 1e-10 each */
	ok(distance(&run, &exact) < 1e-6 && distance(&gauss, &exact) < 1e-6,
	   "a plucked fast coordinate at 1e-9: error %.1e with auto, %.1e with gauss",
	   distance(&run, &exact), distance(&gauss, &exact));
	ok(distance(&stiff, &exact) < 1e-8, "and %.1e with radau", distance(&stiff, &exact));
	ok(!strcmp(run.method, "gauss") && run.evaluations < 1.1*gauss.evaluations,
	   "at the cost of gauss: %ld evaluations against %ld", run.evaluations, gauss.evaluations);
	hawser_trajectory_clear(&exact);
	hawser_trajectory_clear(&gauss);
	hawser_trajectory_clear(&run);
	hawser_trajectory_clear(&stiff);
	hawser_rom_clear(&rom);
}

/* The choice of the method does not depend on the output times. */
static void check_rows(void)
{
	struct hawser_rom rom = follower(0.03, 0.3);
	struct hawser_trajectory few = model_run(&rom, NULL, OMEGA, 30.0, 0.375, 1e-7, NULL);
	struct hawser_trajectory many = model_run(&rom, NULL, OMEGA, 30.0, 0.375/64.0, 1e-7, NULL);
	int differ = 0;

	for (int row = 0; row < few.rows; row++)
		for (int i = 0; i < 6; i++)
			differ += few.state[row*6 + i] != many.state[64*row*6 + i];
	ok(!differ && few.steps == many.steps, "64 times the rows change no bit: %d", differ);
	hawser_trajectory_clear(&few);
	hawser_trajectory_clear(&many);
	hawser_rom_clear(&rom);
}

/* Two coupled coordinates that are not modes, without others: rest is their steady state and
 * remains so. */
static void check_rest(void)
{
	const double load[3] = {0.0, 21.0, -34.0}, d = 2.3;
	struct hawser_rom rom = model_new(3);
	struct hawser_trajectory run;
	double start[6], worst = 0.0;

	rom.K[0] = 1.0;
	rom.K[4] = 830.0;
	rom.K[8] = 1210.0;
	rom.K[5] = rom.K[7] = 95.0;
	for (int j = 0; j < 9; j += 4)
		rom.D[j] = d;
	model_force(&rom, HAWSER_SIN, 1, load);
	rom.inertia.shapes = 2;
	model_compile(&rom);
	run = model_run(&rom, "gauss", OMEGA, 12.0, 0.375, 1e-12, NULL);
	for (int row = 0; row < run.rows; row++) {
		ok(!hawser__rest(start, &rom, OMEGA*run.time[row], OMEGA), "memory");
		for (int i = 0; i < 6; i++)
			worst = fmax(worst, fabs(run.state[row*6 + i] - start[i]));
	}
	ok(worst < 1e-12 && start[0] == 0.0 && fabs(start[1]) > 1e-3,
	   "from rest, what is no mode swings in steady state from the beginning: %.1e", worst);
	hawser_trajectory_clear(&run);
	rom.inertia.shapes = 0;
	run = model_run(&rom, "gauss", OMEGA, 1.0, 0.5, 1e-12, NULL);
	ok(run.state[1] == 0.0 && run.state[5] == 0.0, "modes begin at 0");
	hawser_trajectory_clear(&run);
	hawser_rom_clear(&rom);
}

CASE(property_integrate_stiff)
{
	check_followed();
	check_resolved();
	check_rows();
	check_rest();
	return done_testing();
}
