/* bench/rod-motion - motion of rods: processor time over the number of elements, with steps of 0.01 s
 * and by their error, of D 5.1.2 (damped cantilever), 5.1.3 (free) and 5.1.4 (rotor); beside it the
 * energy that the scheme takes. The momentum of the free one and the turns of the rotor are known.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include <hawser/rod_motion.h>

#include "bench/clock.h"

#define PI 3.14159265358979323846

static struct hawser_rod_segment segment;
static struct hawser_rod_load load;
static double table[3][2];

static struct hawser_rod rod_of(double EA, double GA, double EI, double rho, double J, int elements)
{
	segment = (struct hawser_rod_segment){.length = 10.0, .rho = rho, .EA = EA, .GA = {GA, GA},
	                                      .EI = {EI, EI}, .GJ = EI, .inertia = {2.0*J, J, J},
	                                      .elements = elements};
	return (struct hawser_rod){
		.segment = &segment, .segments = 1, .length = 10.0, .load = &load, .loads = 1,
		.hold = {HAWSER_ROD_CLAMPED, HAWSER_ROD_FREE}, .tangent = {1.0, 0.0, 0.0},
		.normal = {0.0, 1.0, 0.0}, .rho_inf = 0.8};
}

static void history(double a, double b, double c, double at, double end)
{
	const double rows[3][2] = {{0.0, a}, {at, b}, {end, c}};

	memcpy(table, rows, sizeof table);
	load.factor = table;
	load.factors = 3;
}

static struct hawser_rod rod(int which, int elements)
{
	struct hawser_rod to;

	if (which == 0) {
		to = rod_of(1e6, 1e6, 1e3, 1.0, 10.0, elements);
		to.alpha = 0.1;
		load = (struct hawser_rod_load){.from = 10.0, .to = 10.0, .force = {0.0, 37.5, 0.0}};
		history(0.0, 1.0, 0.0, 0.75, 1.5);
	} else if (which == 1) {
		to = rod_of(1e4, 1e4, 500.0, 1.0, 10.0, elements);
		to.hold[0] = HAWSER_ROD_FREE;
		load = (struct hawser_rod_load){.force = {-4.8, -6.4, 0.0}, .moment = {0.0, 0.0, -80.0}};
		history(1.0, 1.0, 0.0, 2.5, 2.5);
	} else {
		to = rod_of(2.8e7, 1e7, 1.4e4, 1.2, 6e-4, elements);
		to.drive[0] = (struct hawser_rod_drive){.axis = {0.0, 0.0, 1.0}, .speed = PI, .rise = 15.0};
		load = (struct hawser_rod_load){.from = 10.0, .to = 10.0, .force = {0.0, 0.0, 40.0}};
		history(0.0, 1.0, 0.0, 0.5, 1.0);
	}
	return to;
}

/* Wrong by more than this, a result is none: N s, revolutions. The scheme may take more energy: that of
 * waves that are faster than the step, which a jump of the load has excited. */
static int wrong(int which, const struct hawser_rod_motion *motion)
{
	const double *P = motion->momentum[motion->rows - 1];
	double known = which == 1 ? hypot(P[0] + 12.0, P[1] + 16.0)
	               : which == 2 ? fabs(motion->turned[motion->rows - 1] - 11.25) : 0.0;

	return !(known < 2e-3 && motion->closure < 0.02);
}

int main(void)
{
	static const char *const name[] = {"5.1.2", "5.1.3", "5.1.4"};
	static const double until[] = {25.0, 15.0, 30.0};
	static const int elements[] = {20, 100};
	int bad = 0;

	printf("scene\telements\tstep_s\tsteps\titerations\tfactorizations\tcpu_s\treal_times\t"
	       "energy_lost\n");
	for (int which = 0; which < 3; which++)
		for (int k = 0; k < 4; k++) {
			struct hawser_rod of = rod(which, elements[k % 2]);
			struct hawser_rod_motion_options options = {.until = until[which], .every = 0.5,
			                                            .step = k < 2 ? 0.01 : -1.0, .skip_error = 1};
			struct hawser_rod_motion motion;
			struct hawser_report report;
			double began = cpu_secs(), seconds;

			if (hawser_rod_integrate(&motion, &of, &options, &report)) {
				fprintf(stderr, "%s\n", report.message);
				return 1;
			}
			seconds = cpu_secs() - began;
			bad |= wrong(which, &motion);
			printf("%s\t%d\t%s\t%ld\t%ld\t%ld\t%.3f\t%.0f\t%.1e\n", name[which], elements[k % 2],
			       k < 2 ? "0.01" : "auto", motion.steps, motion.iterations, motion.factored, seconds,
			       until[which]/seconds, motion.closure);
			hawser_rod_motion_clear(&motion);
		}
	return bad;
}
