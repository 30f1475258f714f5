/* bench/integrate.c - work and precision of the integration methods, and energy over 1000 periods.
 *
 * Every result is checked before it is timed: a run whose error exceeds ten thousand times rtol
 * ends the bench with status 1 (the largest, that of BDF, is 4000). The error is the largest in any
 * coordinate at any output, relative to the largest coordinate, against gauss at 3e-14.
 *
 * Other work of the machine only lengthens a run; the time is therefore the shortest of REPEATS.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "tests/integrate-models.h"
#include "bench/clock.h"

#define REPEATS 5

struct bench_case {
	const char *name;
	struct hawser_rom rom;
	double omega;
};

static double error_of(const struct hawser_trajectory *run, const struct hawser_trajectory *exact)
{
	double worst = 0.0, size = 0.0;

	for (int i = 0; i < run->rows; i++)
		for (int j = 0; j < run->n; j++) {
			int at = i*2*run->n + j;

			worst = fmax(worst, fabs(run->state[at] - exact->state[at]));
			size = fmax(size, fabs(exact->state[at]));
		}
	return worst/size;
}

static int time_case(const struct bench_case *bench, const char *method, double rtol,
                     const struct hawser_trajectory *exact)
{
	double best = HUGE_VAL, error = 0.0;
	struct hawser_trajectory run;

	for (int i = 0; i < REPEATS; i++) {
		double start = clock_secs();

		run = model_run(&bench->rom, method, bench->omega, 60.0, 0.1, rtol, NULL);
		best = fmin(best, clock_secs() - start);
		error = error_of(&run, exact);
		if (i < REPEATS - 1)
			hawser_trajectory_clear(&run);
	}
	printf("%s\t%s\t%.0e\t%.1e\t%ld\t%ld\t%ld\t%.2f\n", bench->name, method, rtol, error,
	       run.steps, run.evaluations, run.jacobians, 1e3*best);
	hawser_trajectory_clear(&run);
	return error <= 1e4*rtol + 1e-12;
}

static void energy(const char *method, double rtol)
{
	const double initial[10] = {0.004, 0.002, 0.0015, -0.001, 0.0005};
	struct hawser_rom rom = model_cable(0.0, 0.0);
	double start = clock_secs(), worst = 0.0, spent;
	struct hawser_trajectory run = model_run(&rom, method, 0.0, 2000.0, 0.4, rtol, initial);

	spent = clock_secs() - start;
	for (int i = 0; i < run.rows; i++)
		worst = fmax(worst, fabs(run.energy[i]/run.energy[0] - 1.0));
	printf("energy\t%s\t%.0e\t%.1e\t%ld\t%ld\t%ld\t%.0f\n", method, rtol, worst, run.steps,
	       run.evaluations, run.jacobians, 1e3*spent);
	hawser_trajectory_clear(&run);
	hawser_rom_clear(&rom);
}

int main(void)
{
	struct bench_case cases[4] = {
		{"chairlift", model_cable(0.029, 0.0012), 3.2},
		{"high-mode", model_cable(0.029, 0.0012), 3.2},
		{"damped", model_cable(0.029, 0.0012), 3.2},
		{"damped-high", model_cable(0.029, 0.0012), 3.2},
	};
	int good = 1;

	/* A mode with a frequency a hundred times that of the motion; damping as large as stiffness;
	 * both, with 1 %. */
	cases[1].rom.K[24] += 9e4;
	cases[3].rom.K[24] += 9e4;
	for (int j = 0; j < 25; j += 6) {
		cases[2].rom.D[j] += j ? cases[2].rom.K[j] : 0.0;
		cases[3].rom.D[j] += 0.01*cases[3].rom.K[j];
	}
	printf("case\tmethod\trtol\terror\tsteps\tevaluations\tjacobians\ttime_ms\n");
	for (int c = 0; c < 4; c++) {
		struct hawser_trajectory exact;

		model_compile(&cases[c].rom);
		exact = model_run(&cases[c].rom, "gauss", cases[c].omega, 60.0, 0.1, 3e-14, NULL);
		for (int digits = 4; digits <= 12; digits += 2)
			for (int m = 0; m <= METHODS; m++)
				good &= time_case(&cases[c], m < METHODS ? all_methods[m] : "auto",
				                  pow(10.0, -digits), &exact);
		hawser_trajectory_clear(&exact);
		hawser_rom_clear(&cases[c].rom);
	}
	for (int m = 0; m < METHODS; m++)
		for (int digits = 12; digits <= 14; digits++)
			energy(all_methods[m], pow(10.0, -digits));
	return !good;
}
