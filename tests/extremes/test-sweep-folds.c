/* Folds near a cusp: u'' + 2 z u' + u + c u^3 = f cos(Omega t) about the load at which its two folds
 * coalesce. With one harmonic the cusp has a closed form: with B = 3/4 c a^2
 *
 *     B^2 = 16/3 z^2 (1 + 3/2 B),    f^2 = 4 B^3/(3 c),    Omega^2 = 1 + 3/2 B
 *
 * The relative error of this form is about B/32, so it is as small as desired for light damping. Folds
 * near the cusp follow from the same cubic. The next harmonic shifts the cusp and the folds equally, so
 * that the positions of the folds are compared relative to the cusp.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdint.h>

#include <hawser/folds.h>

#include "tests/extremes/sweep.h"
#include "tests/folds-duffing.h"

#define VALUES(a) (a), (int)(sizeof(a)/sizeof *(a))
enum { DAMPING, CUBIC, CUSP_AXES };
static const double dampings[] = {1e-9, 1e-6, 1e-3, 0.02, 0.1};
static const double cubics[] = {-1e2, -1e-6, 1e-12, 1e-3, 1.0, 1e6};
static const struct sweep_axis cusp_axis[CUSP_AXES] = {
	{"damping", 0.02, VALUES(dampings), 4},
	{"cubic", 1.0, VALUES(cubics), 3},
};

struct cusp {
	double B, load, omega;
};

/* B has the sign of c. */
static struct cusp closed_form(double z, double c)
{
	double b = 8.0*z*z, s = c > 0.0 ? 1.0 : -1.0;
	double B = s*(4.0*z/sqrt(3.0)*sqrt(1.0 + 3.0*z*z) + s*0.5*b);

	return (struct cusp){B, sqrt(4.0*B*B*B/(3.0*c)), sqrt(1.0 + 1.5*B)};
}

/* The library's cusp, from a trace of its folds. */
static enum hawser_status find(struct cusp *cusp, double z, double c, double *stated,
                               struct hawser_report *report)
{
	struct hawser_folds_options options = {.method = NULL};
	struct cusp guess = closed_form(z, c);
	struct hawser_folds folds;
	struct hawser_rom rom;
	enum hawser_status status;

	if (duffing(&rom, 2.0*z, c, 1.6*guess.load))
		return HAWSER_ERR_MEMORY;
	options.from = guess.omega - 6.0*z;
	options.to = guess.omega + 6.0*z;
	options.load_from = 0.5;
	options.load_to = 1.2;
	status = hawser_folds_trace(&folds, &rom, &options, report);
	*cusp = (struct cusp){NAN, NAN, NAN};
	for (int e = 0; !status && e < folds.events; e++)
		if (folds.event[e].kind == HAWSER_FOLDS_CUSP) {
			cusp->load = 1.6*guess.load*folds.event[e].load;
			cusp->omega = folds.event[e].omega;
			*stated = folds.point[folds.event[e].after].mesh + options.event_tolerance;
		}
	/* a failed curve has its own status */
	for (int k = 0; !status && isnan(cusp->load) && k < folds.curves; k++)
		if (folds.curve[k].end[0] == HAWSER_FOLDS_FAILED ||
		    folds.curve[k].end[1] == HAWSER_FOLDS_FAILED) {
			status = report->status = HAWSER_ERR_CONVERGENCE;
			snprintf(report->message, sizeof report->message, "%s", folds.curve[k].message);
		}
	hawser_folds_clear(&folds);
	hawser_rom_clear(&rom);
	return status;
}

static void meet(struct sweep_point *point, const double *x, void *context)
{
	struct cusp want = closed_form(x[DAMPING], x[CUBIC]), found;

	(void)context;
	point->skip = sweep_left_out(7, 1);
	if (point->skip)
		return;
	point->status = find(&found, x[DAMPING], x[CUBIC], &point->stated, &point->report);
	if (point->status)
		return;
	/* Omega - 1 is of the order of the damping, and no better known than Omega itself */
	point->error = fmax(fabs(found.load/want.load - 1.0), fabs(found.omega - want.omega));
	point->stated += 0.05*fabs(want.B) + 4e-15/x[DAMPING];
}

/* --- beside the cusp --- */

enum { BESIDE, SIDE_DAMPING, SIDE_AXES };
static const double besides[] = {-0.1, -1e-3, -1e-6, 1e-6, 1e-3, 0.1, 1.0};
static const double side_dampings[] = {1e-6, 1e-3, 0.02};
static const struct sweep_axis side_axis[SIDE_AXES] = {
	{"beside", 0.1, VALUES(besides), 0},
	{"damping", 0.02, VALUES(side_dampings), 3},
};

/* Positions (Omega - Omega of the cusp)/z of both folds at the load f with one harmonic, by
 * bisection of f^2 = B/(0.75 c) (d^2 + 4 z^2 W) with d^2 + 2 B d + 4 z^2 W = 0, W = 1 + B - d. */
static int one_harmonic(double at[2], double z, double f)
{
	struct cusp cusp = closed_form(z, 1.0);
	int found = 0;

	/* along the fold curve: B beyond the cusp's to both sides, d the root that goes with it */
	for (int side = 0; side < 2; side++) {
		double lo = 0.0, hi = 1.0;

		for (int i = 0; i < 200; i++) {
			double s = 0.5*(lo + hi), q = 0.0, B, d, W, load;

			/* d = -B (1/2 + t/2), t in (-1, 1): B^2 (1 - t^2)/4 ... solve for B */
			double t = side ? 3.0*s : -s, e = 0.25*(1.0 + t)*(3.0 - t);

			/* d^2 + 2 B d = -B^2 e: e B^2 = 4 z^2 (1 + B (1 + (1 + t)/2)) */
			q = 4.0*z*z*(1.0 + 0.5*(1.0 + t));
			B = (q + sqrt(q*q + 16.0*e*z*z))/(2.0*e);
			d = -0.5*B*(1.0 + t);
			W = 1.0 + B - d;
			load = sqrt(B/0.75*(d*d + 4.0*z*z*W));
			if (load < f)
				lo = s;
			else
				hi = s;
			at[side] = (sqrt(W) - cusp.omega)/z;
		}
		found += lo > 0.0;
	}
	return found;
}

static void beside(struct sweep_point *point, const double *x, void *context)
{
	const char *method = context;
	double z = x[SIDE_DAMPING], delta = x[BESIDE], want[2], got[2] = {0.0}, stated;
	struct hawser_frf_options options = {.method = NULL};
	struct cusp mine = closed_form(z, 1.0), cusp;
	struct hawser_frf frf;
	struct hawser_rom rom;
	int folds = 0;

	point->skip = sweep_left_out(10, 1);
	if (point->skip)
		return;
	point->status = find(&cusp, z, 1.0, &stated, &point->report);
	if (point->status || duffing(&rom, 2.0*z, 1.0, cusp.load*(1.0 + delta)))
		return;
	options.method = method;
	options.from = cusp.omega - 6.0*z;
	options.to = cusp.omega + 6.0*z;
	options.samples = HAWSER_NONE;
	point->status = hawser_frf_trace(&frf, &rom, &options, &point->report);
	for (int e = 0; !point->status && e < frf.events; e++)
		/* a fold that the multipliers do not confirm is marked as suspected, without a stated error */
		if (frf.event[e].kind == HAWSER_FOLD && !frf.event[e].suspected && folds < 2)
			got[folds++] = (frf.event[e].omega - cusp.omega)/z;
	point->stated = 4.0*z + 1e-8/z;
	if (delta < 0.0) {
		point->error = folds ? INFINITY : 0.0;
	} else if (folds == 0 && pow(delta, 1.5) < 10.0*point->stated) {
		point->error = 0.0; /* the two folds are closer than their stated errors */
	} else if (folds != 2) {
		point->error = INFINITY;
	} else {
		one_harmonic(want, z, mine.load*(1.0 + delta));
		point->error = fmin(fmax(fabs(got[0] - want[0]), fabs(got[1] - want[1])),
		                    fmax(fabs(got[0] - want[1]), fabs(got[1] - want[0])));
	}
	hawser_frf_clear(&frf);
	hawser_rom_clear(&rom);
}

CASE(extremes_sweep_folds)
{
	sweep_pairs("folds, cusp", cusp_axis, CUSP_AXES, meet, NULL);
	for (int i = 0; hawser_frf_method(i); i++) {
		const char *method = hawser_frf_method(i)->name;
		char name[80];

		if (hawser_frf_method(i)->approximate)
			continue;
		snprintf(name, sizeof name, "folds, beside the cusp, %s", method);
		sweep_pairs(name, side_axis, SIDE_AXES, beside, (void *)(uintptr_t)method);
	}
	return done_testing();
}
