/* Normal forms of bifurcations of periodic motions. In closed form: equations u' = g(u) whose flow over
 * a period is known, beside a coordinate that the load drives. Against the branch itself: the amplitude
 * of motions of two periods beside a doubling, sub- and supercritical, is the root of c over the growth
 * of the multiplier.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <unistd.h>

#include <hawser/branches.h>
#include <hawser/normal_form.h>

#include "tests/tap.h"

static struct hawser_report report;

static int open_text(struct hawser_rom *rom, const char *text)
{
	char path[] = "/tmp/hawser-form-XXXXXX";
	int file = mkstemp(path), fine;

	fine = file >= 0 && write(file, text, strlen(text)) == (ssize_t)strlen(text);
	if (file >= 0)
		close(file);
	report.message[0] = '\0';
	fine = fine && !hawser_rom_open(rom, path, &report);
	unlink(path);
	return fine || ok(0, "%s", report.message);
}

/* x' = -w y - b x r^2, y' = w x - b y r^2, and z' = -z + cos(Omega t): r' = -b r^3, so that r at the
 * end of a period T is r/sqrt(1 + 2 b T r^2) = r - b T r^3 + ... The eigenvector is (1, -i)/sqrt(2) in
 * (x, y), divided by sqrt(1 + w^2/Omega^2) for its velocities; r is sqrt(2) times its amplitude. */
static void check_torus(double b, double w, double omega)
{
	char text[1000];
	double T = 2.0*M_PI/omega, s = 1.0/(1.0 + omega*omega);
	double state[6] = {0.0, 0.0, s, 0.0, 0.0, omega*omega*s}, want = -2.0*b*T/(1.0 + w*w/(omega*omega));
	struct hawser_normal_form form;
	struct hawser_rom rom = {0};

	snprintf(text, sizeof text, "{\"n\": 3, \"first_order\": true, \"K\": [[0, %.17g, 0], "
	         "[%.17g, 0, 0], [0, 0, 1]], \"C\": [[0, 0, 0, 0, %.17g], "
	         "[0, 0, 1, 1, %.17g], [1, 0, 0, 1, %.17g], "
	         "[1, 1, 1, 1, %.17g]], \"harmonics\": [{\"k\": 1, \"f\": [0, 0, 1]}]}", w, -w, b, b, b, b);
	if (!open_text(&rom, text))
		return;
	if (ok(!hawser_normal_form(&form, &rom, state, omega, 1, HAWSER_TORUS, &report),
	       "a circle of w %g %s", w, report.message)) {
		ok(fabs(form.c - want) < 1e-8*fabs(want) && form.error < 1e-6*fabs(want) &&
		   fabs(form.c - want) < 10.0*form.error + 1e-12*fabs(want),
		   "%.12g against %.12g: %.1e, stated %.1e", form.c, want, form.c/want - 1.0,
		   form.error/fabs(want));
		ok(form.decided == (b > 0.0 ? 1 : -1), "%s", b > 0.0 ? "supercritical" : "subcritical");
		close_to(form.angle, fabs(remainder(w*T, 2.0*M_PI)), 1e-9, "its angle");
	}
	hawser_rom_clear(&rom);
}

/* x' = a x^2: x at the end of a period is x/(1 - a T x) = x + a T x^2 + ... */
static void check_fold(double a, double omega)
{
	char text[400];
	double T = 2.0*M_PI/omega, s = 1.0/(1.0 + omega*omega), state[4] = {0.0, s, 0.0, omega*omega*s};
	struct hawser_normal_form form;
	struct hawser_rom rom = {0};

	snprintf(text, sizeof text, "{\"n\": 2, \"first_order\": true, \"relaxation\": 2, "
	         "\"K\": [[0, 0], [0, 1]], \"Q\": [[0, 0, 0, %.17g]], "
	         "\"harmonics\": [{\"k\": 1, \"f\": [0, 1]}]}", -a);
	if (!open_text(&rom, text))
		return;
	if (ok(!hawser_normal_form(&form, &rom, state, omega, 1, HAWSER_FOLD, &report), "a fold %s",
	       report.message))
		ok(fabs(form.c - a*T) < 1e-9*a*T && form.decided == 0, "%.12g against %.12g: %.1e", form.c, a*T,
		   form.c/(a*T) - 1.0);
	hawser_rom_clear(&rom);
}

/* With the growth beta of rest, whose multiplier is -(1 + beta), and the state x of a motion of two
 * periods at omega: c x^2/beta, which is 1 at the doubling. */
static double ratio_at(const struct hawser_rom *rom, const struct hawser_normal_form *form,
                       double omega, const double *x)
{
	struct hawser_frf_options one = {.from = omega, .to = 1.1*omega, .max_points = 1,
		.tolerance = 1e-12, .samples = HAWSER_NONE};
	struct hawser_frf rest = {0};
	double ratio = NAN;

	if (!ok(!hawser_frf_trace(&rest, rom, &one, &report), "rest at %g %s", omega, report.message))
		return NAN;
	ratio = form->c*(x[0]*x[0] + x[1]*x[1]/(omega*omega))/expm1(rest.multiplier[0]);
	hawser_frf_clear(&rest);
	return ratio;
}

/* u'' + 0.05 u' + (1 + 0.3 cos(Omega t)) u + 0.4 u^3 = 0: the doubling of rest below 2 is supercritical
 * and the one above it subcritical (the branch of a hardening spring leans to higher frequencies). */
static void check_doublings(void)
{
	struct hawser_frf_options options = {.from = 1.6, .to = 2.5, .event_tolerance = 1e-12};
	struct hawser_frf frf = {0};
	struct hawser_rom rom = {0};

	if (!open_text(&rom, "{\"n\": 1, \"K\": [[1]], \"D\": [[0.05]], \"C\": [[0, 0, 0, 0, 0.4]], "
	               "\"harmonics\": [{\"k\": 1, \"K\": [[-0.3]]}]}"))
		return;
	if (!ok(!hawser_frf_trace(&frf, &rom, &options, &report) && frf.events == 2, "two doublings %s",
	        report.message))
		return;
	for (int e = 0; e < 2; e++) {
		double rest[2] = {0.0, 0.0}, off[2] = {NAN, NAN}, at = 0.0;
		struct hawser_normal_form form;
		struct hawser_frf branch = {0};

		if (!ok(!hawser_normal_form(&form, &rom, rest, frf.event[e].omega, 1, HAWSER_PERIOD_DOUBLING,
		                            &report), "its form %s", report.message))
			continue;
		ok(form.decided == (e ? -1 : 1) && form.error < 1e-5*fabs(form.c), "%s: c %.9g, error %.1e",
		   form.decided > 0 ? "supercritical" : "subcritical", form.c, form.error);
		options.event_tolerance = 0.0;
		if (hawser_branch_switch(&branch, &rom, &frf, e, &options, &report)) {
			ok(0, "%s", report.message);
			continue;
		}
		for (int p = 1, k = 0; p < branch.points && k < 2; p++) {
			double far = branch.point[p].omega - frf.event[e].omega;

			if (far < (k ? 2.0*at : 1e-4))
				continue;
			at = far;
			off[k++] = (ratio_at(&rom, &form, branch.point[p].omega, branch.state + 2*(size_t)p) -
			            1.0)/far;
		}
		ok(fabs(off[0]) < 50.0 && fabs(off[1]/off[0] - 1.0) < 0.1,
		   "the branch has its amplitude, up to %.3g and %.3g times the distance from the doubling",
		   off[0], off[1]);
		hawser_frf_clear(&branch);
	}
	hawser_frf_clear(&frf);
	hawser_rom_clear(&rom);
}

/* Of a rotation by the angle w T, or of a coordinate of frequency w beside the load's. */
static void refuse(const char *text, enum hawser_event_kind kind, double omega, const char *why)
{
	double s = 1.0/(1.0 + omega*omega), state[6] = {0.0, 0.0, s, 0.0, 0.0, omega*omega*s};
	struct hawser_normal_form form;
	struct hawser_rom rom = {0};

	if (!open_text(&rom, text))
		return;
	ok(hawser_normal_form(&form, &rom, state, omega, 1, kind, &report) && strstr(report.message, why),
	   "%s", report.message);
	hawser_rom_clear(&rom);
}

static void check_refusals(void)
{
	const char *rotation = "{\"n\": 3, \"first_order\": true, "
		"\"K\": [[0, 1, 0], [-1, 0, 0], [0, 0, 1]], "
		"\"harmonics\": [{\"k\": 1, \"f\": [0, 0, 1]}]}";

	refuse(rotation, HAWSER_FOLD, 2.1, "off its place");
	refuse(rotation, HAWSER_BRANCH_POINT, 2.1, "is that of a fold");
	refuse(rotation, HAWSER_TORUS, 2.1, "or the coefficient is 0");
	refuse(rotation, HAWSER_TORUS, 3.0, "is a 1:3 resonance");
	refuse(rotation, HAWSER_TORUS, 4.0, "is a 1:4 resonance");
	refuse("{\"n\": 1, \"K\": [[1e10]], \"D\": [[1]], \"harmonics\": [{\"k\": 1, \"f\": [1]}]}",
	       HAWSER_FOLD, 1.0, "takes more than 4000 steps");
}

CASE(property_normal_form)
{
	check_refusals();
	check_torus(0.3, 1.385, 2.1);
	check_torus(-0.7, 0.62, 1.3);
	check_fold(0.45, 1.7);
	check_doublings();
	return done_testing();
}
