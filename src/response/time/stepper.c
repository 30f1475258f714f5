/* response/time/stepper.c - common parts of all time integrators: counted, checked evaluations, and the
 * reasons for ending a run early.
 *
 * The motion of a softening model (negative cubic terms) is not bounded: beyond the barrier of the
 * potential it becomes infinite in finite time, and every adaptive integrator then reduces its
 * steps without limit. This is a property of the truncated model; the message therefore refers to
 * the model, not to the integrator.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "core/report.h"
#include "response/time/stepper.h"
#include "rom/terms/history.h"
#include "rom/build/model.h"

double hawser__stepper_omega(const struct hawser__stepper *stepper, double t)
{
	return stepper->omega + stepper->rate*(t - stepper->since);
}

/* The plain product has an error of half a unit in its last place, which after a million periods is
 * 1e-9: as noise between evaluations, that is too much for a small tolerance. A fused
 * multiplication recovers the rounding error, and 2 pi has a second part. */
double hawser__stepper_turned(double omega, double t, double low)
{
	const double turn = 6.283185307179586, rest = 2.4492935982947064e-16;
	double product = omega*t, part = fmod(product, turn);

	if (!isfinite(part))
		return product;
	return part + (fma(omega, t, -product) + omega*low - (product - part)/turn*rest);
}

double hawser__stepper_phase(const struct hawser__stepper *stepper, double t, double low)
{
	double swept = t - stepper->since + low;

	return hawser__stepper_turned(stepper->omega, t, low) + 0.5*stepper->rate*swept*swept;
}

int hawser__stepper_acceleration(struct hawser__stepper *stepper, double *acceleration, double t,
                                 double phase, const double *u, const double *v)
{
	const struct hawser_rom *rom = stepper->rom;

	hawser_rom_acceleration(rom, acceleration, u, v, phase, hawser__stepper_omega(stepper, t));
	if (rom->ramp)
		hawser__rom_ramp(rom, acceleration, NULL, NULL, u, v, t, stepper->over);
	if (rom->history)
		hawser__rom_history(rom, acceleration, NULL, NULL, u, v, t);
	stepper->evaluations++;
	for (int j = 0; j < rom->n; j++) {
		if (isfinite(acceleration[j]))
			continue;
		stepper->bad_coordinate = j;
		return -1;
	}
	return 0;
}

double hawser__stepper_first(const struct hawser__stepper *stepper)
{
	const struct hawser_rom *rom = stepper->rom;
	int n = rom->n, highest = 0;
	double rate = 0.0;

	if (stepper->first > 0.0)
		return fmin(stepper->first, stepper->until - stepper->begin);
	for (int h = 0; h < rom->harmonics; h++)
		highest = rom->harmonic[h].k > highest ? rom->harmonic[h].k : highest;
	for (int j = 0; j < n; j++) {
		double stiffness = 0.0, damping = 0.0;

		for (int k = 0; k < n; k++) {
			stiffness += fabs(rom->K[j*n + k]);
			damping += fabs(rom->D[j*n + k]);
		}
		rate = fmax(rate, sqrt(stiffness) + damping);
	}
	rate = fmax(rate, highest*fmax(stepper->omega, hawser__stepper_omega(stepper, stepper->until)));
	return rate > 0.0 ? fmin(0.5/rate, stepper->until - stepper->begin)
	                  : (stepper->until - stepper->begin)/16.0;
}

static int largest(const double *u, int n)
{
	int best = 0;

	for (int j = 1; j < n; j++)
		if (fabs(u[j]) > fabs(u[best]))
			best = j;
	return best;
}

enum hawser_status hawser__stepper_escaped(const struct hawser__stepper *stepper, const double *y,
                                           double t, double step, struct hawser_report *report)
{
	int j = largest(y, stepper->rom->n);

	return hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, "integrate", (int)stepper->steps, step,
	                       "the step fell to %.3g%s at t = %.6g%s without meeting the "
	                       "tolerance, where coordinate %d is %.3g and moves at %.3g: either the "
	                       "motion has left the range of the cubic model and escapes, so lower the "
	                       "load or the initial state, or raise rtol (now %.1e)",
	                       HAWSER_SHOWN_TIME(stepper->rom, step), HAWSER_SHOWN_TIME(stepper->rom, t),
	                       j, y[j], y[stepper->rom->n + j], stepper->rtol);
}

enum hawser_status hawser__stepper_too_long(const struct hawser__stepper *stepper, double t,
                                            struct hawser_report *report)
{
	return hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, "integrate", (int)stepper->steps, 0.0,
	                       "%ld steps were spent by t = %.6g%s of %.6g%s: shorten the run, "
	                       "raise rtol (now %.1e), try another method, or allow more steps",
	                       stepper->steps, HAWSER_SHOWN_TIME(stepper->rom, t),
	                       HAWSER_SHOWN_TIME(stepper->rom, stepper->until), stepper->rtol);
}
