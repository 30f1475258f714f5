/* Comparison of modes with a reference: signs, groups, exchanged and missing modes, known
 * distances, and the order of the errors of a coarse basis.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include "tests/modes-span.h"
#include "tests/tap.h"

enum { N = 8, MORE = 12 };
static struct hawser_modes reference, modes;
static struct hawser_modes_error error[MORE];
static int first, second; /* index of the first of two neighbouring in-plane modes of `modes` */

static int solve(struct hawser_modes *out, const struct hawser_statics *st, int n, int basis)
{
	const struct hawser_modes_options options = {.n = n, .basis = basis};
	struct hawser_report report = {.message = ""};

	return ok(hawser_modes_solve(out, st, &options, &report) == HAWSER_OK, "solved %s",
	          report.message);
}

static double *shape(int k, int p)
{
	return modes.shape + ((size_t)k*(size_t)modes.grid.points + (size_t)p)*3;
}

static double most(int shapes)
{
	double worst = 0.0;

	for (int k = 0; k < modes.n; k++)
		worst = fmax(worst, shapes ? error[k].shape : error[k].frequency);
	return worst;
}

static int compared(void)
{
	struct hawser_report report = {.message = ""};
	enum hawser_status status = hawser_modes_compare(error, &modes, &reference, &report);

	if (status)
		ok(0, "compared: %s", report.message);
	return !status;
}

/* Rotate both modes by an angle in the space that they span. */
static void turn(double angle)
{
	for (int p = 0; p < modes.grid.points; p++)
		for (int c = 0; c < 3; c++) {
			double x = shape(first, p)[c], y = shape(second, p)[c];

			shape(first, p)[c] = cos(angle)*x + sin(angle)*y;
			shape(second, p)[c] = cos(angle)*y - sin(angle)*x;
		}
}

static void exchange(void)
{
	double omega = modes.mode[first].omega;

	turn(0.5*M_PI);
	modes.mode[first].omega = modes.mode[second].omega;
	modes.mode[second].omega = omega;
}

static int partner_of(int k)
{
	return error[k].partner;
}

static void alike(void)
{
	int in_order = 1;

	compared();
	for (int k = 0; k < modes.n; k++)
		in_order &= error[k].partner == k;
	ok(in_order && most(0) < 1e-13 && most(1) < 1e-12, "the same modes: %.1e, %.1e", most(0),
	   most(1));
	for (int p = 0; p < modes.grid.points; p++)
		for (int c = 0; c < 3; c++)
			shape(2, p)[c] *= -1.0;
	compared();
	ok(most(1) < 1e-12, "a sign doesn't matter: %.1e", most(1));
	modes.mode[3].omega *= 1.0 + 1e-5;
	compared();
	close_to(error[3].frequency, 1e-5, 1e-6, "a frequency's error");
	modes.mode[3].omega /= 1.0 + 1e-5;
}

static void turned(void)
{
	double apart = reference.mode[partner_of(second)].omega;

	turn(0.31);
	compared();
	close_to(error[first].shape, 2.0*sin(0.155), 1e-10, "turned by 0.31 apart: the chord");
	close_to(error[second].shape, 2.0*sin(0.155), 1e-10, "and the other one's");
	reference.mode[error[second].partner].omega = reference.mode[error[first].partner].omega*1.0005;
	compared();
	ok(error[first].shape < 1e-12 && error[second].shape < 1e-12,
	   "turned within a group: %.1e, %.1e", error[first].shape, error[second].shape);
	reference.mode[error[second].partner].omega = apart;
	turn(-0.31);
}

static void exchanged(void)
{
	int a = partner_of(first), b = partner_of(second);

	exchange();
	compared();
	ok(error[first].partner == b && error[second].partner == a && most(1) < 1e-12,
	   "two neighbours exchanged: partners %d and %d, %.1e", error[first].partner,
	   error[second].partner, most(1));
	turn(-0.5*M_PI); /* the frequencies alone */
	compared();
	ok(error[first].partner == a && error[first].frequency > 1e-3, "frequencies exchanged: %.1e",
	   error[first].frequency);
	turn(0.5*M_PI);
	exchange();
}

/* Without its first in-plane mode, all other in-plane modes are wrong, and no others. */
static void missing(void)
{
	struct hawser_modes less = modes;
	struct hawser_report report;
	double worst = 0.0, least = HUGE_VAL;
	int skipped = 0;

	while (less.mode[skipped].plane != HAWSER_IN_PLANE)
		skipped++;
	less.n = modes.n - 1 - skipped;
	less.mode = modes.mode + skipped + 1;
	less.shape = modes.shape + (size_t)(skipped + 1)*3*(size_t)modes.grid.points;
	less.slope = modes.slope + (size_t)(skipped + 1)*3*(size_t)modes.grid.points;
	if (!ok(hawser_modes_compare(error, &less, &reference, &report) == HAWSER_OK, "one less"))
		return;
	for (int k = 0; k < less.n; k++)
		if (less.mode[k].plane == HAWSER_IN_PLANE)
			least = fmin(least, error[k].shape);
		else
			worst = fmax(worst, skipped ? 0.0 : error[k].shape);
	ok(least > 1.0 && worst < 1e-12, "a missing mode is seen: %.2g, other plane %.1e", least, worst);
}

static void refused(enum hawser_status want, const char *words)
{
	struct hawser_report report = {.message = ""};
	enum hawser_status got = hawser_modes_compare(error, &modes, &reference, &report);

	ok(got == want && strstr(report.message, words), "%s, saying \"%s\": %s",
	   hawser_status_name(got), words, report.message);
}

static void refusals(void)
{
	int n = reference.n;
	double kept;

	reference.n = 3;
	refused(HAWSER_ERR_ARGUMENT, "ask for more modes of it");
	reference.n = n;
	kept = modes.statics.l;
	modes.statics.l *= 1.01;
	refused(HAWSER_ERR_ARGUMENT, "different spans");
	modes.statics.l = kept;
	kept = shape(1, 4)[1];
	shape(1, 4)[1] = NAN;
	shape(1, 4)[2] = NAN;
	refused(HAWSER_ERR_NAN, "mode 2");
	shape(1, 4)[1] = shape(1, 4)[2] = kept;
	kept = modes.mode[0].omega;
	modes.mode[0].omega = NAN;
	refused(HAWSER_ERR_NAN, "mode 1");
	modes.mode[0].omega = kept;
}

/* Galerkin's method: the error of a frequency is of the order of the square of that of its shape. */
static void coarse(const struct hawser_statics *st)
{
	static const int basis[] = {9, 11};
	double frequency[2], shapes[2];

	for (int i = 0; i < 2; i++) {
		hawser_modes_clear(&modes);
		if (!solve(&modes, st, N, basis[i]) || !compared())
			return;
		frequency[i] = most(0);
		shapes[i] = most(1);
		ok(frequency[i] > 0.01*shapes[i]*shapes[i] && frequency[i] < 10.0*shapes[i]*shapes[i],
		   "%d functions: frequency %.1e, shape %.1e", basis[i], frequency[i], shapes[i]);
	}
	ok(shapes[0] > 1e-4 && shapes[0] < 0.1 && shapes[1] < 0.05*shapes[0], "and it converges");
}

CASE(property_modes_compare)
{
	struct hawser_statics st = scaled_span(2.385e-4, 0.21, 0.3);

	if (!solve(&reference, &st, MORE, 0) || !solve(&modes, &st, N, 37))
		return done_testing();
	while (modes.mode[first].plane != HAWSER_IN_PLANE)
		first++;
	second = first + 1;
	while (modes.mode[second].plane != HAWSER_IN_PLANE)
		second++;
	alike();
	turned();
	exchanged();
	missing();
	refusals();
	coarse(&st);
	hawser_modes_clear(&modes);
	hawser_modes_clear(&reference);
	return done_testing();
}
