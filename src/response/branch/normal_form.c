/* response/branch/normal_form.c - coefficients of normal forms of the period map.
 *
 *   c is the coefficient in the section's map (return_map.h), by differences over the amplitude at
 *   which it differs least from that over half of it.
 *
 * Reference: Kuznetsov, Elements of Applied Bifurcation Theory, 5.4.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <complex.h>
#include <math.h>

#include "core/report.h"
#include "response/branch/return_map.h"

enum { SHRINKS = 14 };
#define LARGEST 0.1    /* first amplitude, relative to the motion; multiples up to 3 of it are
                        * used; chosen */
#define SHRINK 0.5     /* of the amplitude, from one trial to the next */
#define NEAR 1e-3      /* largest distance of a multiplier from its place; chosen */
#define RESONANT 1e-3  /* of mu^3 or mu^4 from 1; chosen: c grows with its inverse */
#define UNSURE 0.05    /* largest relative error of a coefficient that is given; chosen */
#define SAFETY 10.0      /* the smallest of several differences is smaller than the error */

/* How far mu is from its place. */
static double distance_of(double re, double im, enum hawser_event_kind kind)
{
	if (kind == HAWSER_TORUS)
		return im > 0.0 ? fabs(hypot(re, im) - 1.0) : INFINITY;
	return im == 0.0 ? fabs(re - (kind == HAWSER_FOLD ? 1.0 : -1.0)) : INFINITY;
}

/* The amplitude of the differences is halved; where two results are nearest to each other is the best
 * one, between truncation and round-off. */
static enum hawser_status search(struct hawser_normal_form *form, struct hawser__return *section,
                                 int which, struct hawser_report *report)
{
	double before = NAN, least = INFINITY, next = 0.0, a = LARGEST*section->extent;
	enum hawser_status status = HAWSER_OK;
	int worse = 0;

	for (int k = 0; k < SHRINKS && worse < 4 && !status; k++, a *= SHRINK) {
		double c, change;

		status = hawser__return_form(section, &c, which, form->kind, a, report);
		change = fabs(c - before);
		if (isfinite(least) && !(change < least) && ++worse == 1)
			next = change;
		if (change < least) {
			form->c = c;
			least = change;
			next = 0.0;
			worse = 0;
		}
		before = c;
	}
	/* two results may be equal by chance: the one after them tells */
	form->error = fmax(SAFETY*least, isfinite(next) ? next : 0.0);
	return status;
}

static enum hawser_status decide(struct hawser_normal_form *form, double complex mu,
                                 struct hawser_report *report)
{
	double third = cabs(mu*mu*mu - 1.0), fourth = cabs(mu*mu*mu*mu - 1.0);

	if (form->kind == HAWSER_TORUS && fmin(third, fourth) < RESONANT)
		return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "orbit",
		                    "no normal form: the torus point is a 1:%d resonance, which has "
		                    "another one", third < fourth ? 3 : 4);
	if (!isfinite(form->error) || (form->kind != HAWSER_FOLD && !(form->error < UNSURE*fabs(form->c))))
		return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "orbit",
		                    "no normal form: its coefficient %.3g has the error %.1g; the forces may "
		                    "have kinks, or the coefficient is 0", form->c, form->error);
	if (form->kind != HAWSER_FOLD)
		form->decided = (form->kind == HAWSER_TORUS ? -form->c : form->c) > 0.0 ? 1 : -1;
	return HAWSER_OK;
}

enum hawser_status hawser_normal_form(struct hawser_normal_form *form, const struct hawser_rom *rom,
                                      const double *state, double omega, int period,
                                      enum hawser_event_kind kind, struct hawser_report *report)
{
	struct hawser__return section;
	enum hawser_status status;
	int which = 0;

	*form = (struct hawser_normal_form){.kind = kind, .distance = INFINITY};
	if ((kind != HAWSER_FOLD && kind != HAWSER_PERIOD_DOUBLING && kind != HAWSER_TORUS) || period < 1 ||
	    !(omega > 0.0) || rom->ramp || rom->history)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "orbit",
		                    "a normal form is that of a fold, a period doubling or a torus point of a "
		                    "motion with a period");
	status = hawser__return_open(&section, rom, state, omega, period, 0, report);
	for (int i = 0; !status && i < section.size; i++) {
		double away = distance_of(creal(section.mu[i]), cimag(section.mu[i]), kind);

		if (away < form->distance) {
			form->distance = away;
			which = i;
		}
	}
	if (!status && !(form->distance <= NEAR))
		status = hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "orbit",
		                      "no normal form: the multiplier that belongs to the %s is off its "
		                      "place by %.1g", hawser_event_name(kind), form->distance);
	if (!status) {
		form->angle = kind == HAWSER_TORUS ? carg(section.mu[which]) : 0.0;
		status = search(form, &section, which, report);
	}
	if (!status)
		status = decide(form, section.mu[which], report);
	hawser__return_close(&section);
	return status;
}
