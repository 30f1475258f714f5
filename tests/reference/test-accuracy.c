/* Responses to a required accuracy against numbers of a program that shares no code with this one:
 * Ritz's method on Legendre polynomials in Cartesian displacements, exact strain energy, harmonic
 * balance. Deep sags, whose condensed models are difficult to confirm, a peak near the end of a
 * range, and a basis that is too small.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include <hawser/accuracy.h>

#include "tests/tap.h"
#include "tests/unit/scene-text.h"

enum { PROBES = 3, MID = 1, Z = 2 };

static struct hawser_report report;
static struct hawser_scene scene;
static struct hawser_statics statics;
static struct hawser_accuracy accuracy;

static const char deep[] =
	"cable: {EA: 2557280.356015664, rho: 0.5022105061769911}\n"
	"span: {d: 40.61083920885309, h: 9.64374445921895}\n"
	"tension: {sag: 8.968515933030782}\n"
	"damping: {ratio: 0.012021496670554679}\n"
	"load: {frame: global, per_length: [0.0067962048, 0.0226540159, 0.0067962048]}\n"
	"model: {modes: auto, accuracy: 1 %}\n";
static const char deeper[] =
	"cable: {EA: 12 MN, rho: 1.2}\n"
	"span: {d: 50 m, h: 3 m}\n"
	"tension: {sag: 15 m}\n"
	"damping: {ratio: 1 %}\n"
	"load: {frame: global, per_length: [0, 0.1, 0.12]}\n"
	"model: {modes: auto, accuracy: 1 %}\n";
/* Found by bench/estimates accuracy: an out-of-plane resonance just beyond the range. At the end of
 * the range z reaches 0.6 of the largest y, although no mode kept at first moves out of the plane. */
static const char beyond[] =
	"cable: {EA: 172599598.66, rho: 0.51587161835441031}\n"
	"span: {d: 273.72895179093689, h: 0}\n"
	"tension: {sag: 5.4463999569652186}\n"
	"damping: {ratio: 0.016585414230209955}\n"
	"load: {frame: global, per_length: [0.039225024, 0.090972994, 0.022720884]}\n"
	"model: {modes: auto, accuracy: 1 %}\n";
static const char conductor[] =
	"cable: {EA: 30 MN, rho: 1.6}\n"
	"span: {d: 400 m, h: 12 m}\n"
	"tension: {T0: 24 kN}\n"
	"damping: {ratio: 0.5 %}\n"
	"load: {frame: global, per_length: [0, 0.15, 0.25]}\n"
	"model: {modes: auto, accuracy: 1 %}\n";

/* The range in rad/s. */
static enum hawser_status trace(const char *text, const char *set, double from, double to)
{
	struct hawser_accuracy_options options = {.most = 0};
	double unit;
	enum hawser_status status = read_text(&scene, text, set, &report);

	if (!status)
		status = hawser_statics_scene(&statics, &scene, &report);
	unit = statics.span.d*sqrt(statics.span.rho/statics.H);
	options.frf.from = from*unit;
	options.frf.to = to*unit;
	if (!status)
		status = hawser_accuracy_trace(&accuracy, &statics, &scene, &options, &report);
	return status;
}

static void clear(void)
{
	hawser_accuracy_clear(&accuracy);
	hawser_scene_clear(&scene);
}

/* The largest z at mid-span, and the smallest tension. */
static void check_peak(const char *name, const char *text, const char *set, const double range[2],
                       double omega, double size, double tension)
{
	double unit, best = 0.0, at = 0.0, least = HUGE_VAL;
	enum hawser_status status = trace(text, set, range[0], range[1]);

	ok(!status && accuracy.reached, "%s: estimated %.1e with %d coordinates %s", name,
	   accuracy.estimated, accuracy.rom.n, report.message);
	unit = statics.span.d*sqrt(statics.span.rho/statics.H);
	for (int i = 0; !status && i < accuracy.frf.points; i++) {
		double z = accuracy.frf.probe[((size_t)i*PROBES + MID)*3 + Z]*statics.span.d;

		least = fmin(least, accuracy.frf.tension[2*i]);
		if (z > best)
			at = accuracy.frf.point[i].omega/unit;
		best = fmax(best, z);
	}
	ok(fabs(at/omega - 1.0) < accuracy.estimated, "%s: peak at %.5f, %.5f", name, at, omega);
	ok(fabs(best/size - 1.0) < accuracy.estimated, "%s: of %.5f m, %.5f", name, best, size);
	if (tension > 0.0)
		ok(fabs(least/tension - 1.0) < 0.01, "%s: least tension %.1f N, %.0f", name, least,
		   tension);
	clear();
}

/* Against the full-order model of 12 functions: z at mid-span, at the upper end. */
static void check_end(void)
{
	enum hawser_status status = trace(beyond, NULL, 3.53209443722, 4.37049210332);
	double z = 0.0;
	int last = accuracy.frf.points - 1;

	if (!status && last >= 0)
		z = accuracy.frf.probe[((size_t)last*PROBES + MID)*3 + Z]*statics.span.d;
	ok(!status && accuracy.reached, "a resonance beyond the end: estimated %.1e with %d "
	   "coordinates %s", accuracy.estimated, accuracy.rom.n, report.message);
	close_to(z, 0.01991, 0.01, "a resonance beyond the end: z at mid-span");
	clear();
}

static void check_folds(void)
{
	static const double want[] = {2.37892, 2.35048};
	int folds = 0;
	enum hawser_status status = trace(conductor, NULL, 2.2515, 2.4174);

	ok(!status && accuracy.reached, "conductor: estimated %.1e with %d coordinates %s",
	   accuracy.estimated, accuracy.rom.n, report.message);
	for (int i = 0; !status && i < accuracy.frf.events; i++) {
		double unit = statics.span.d*sqrt(statics.span.rho/statics.H);
		double omega = accuracy.frf.event[i].omega/unit;

		if (accuracy.frf.event[i].kind != HAWSER_FOLD || folds == 2)
			continue;
		ok(fabs(omega/want[folds] - 1.0) < accuracy.estimated, "conductor: fold at %.5f, %.5f",
		   omega, want[folds]);
		folds++;
	}
	ok(folds == 2, "conductor: %d folds", folds);
	clear();
	status = trace(conductor, "model.basis=12", 2.2515, 2.4174);
	ok(status == HAWSER_ERR_CONVERGENCE && strstr(report.message, "model.basis"),
	   "a basis of 12: %s", report.message);
	clear();
}

CASE(reference_accuracy)
{
	static const double near_end[] = {2.95773, 3.43475}, first[] = {0.771126, 1.088649};

	if (getenv("HAWSER_LONG")) { /* property/accuracy has a deep sag of its own */
		check_peak("deep sag", deep, NULL, near_end, 3.4075, 0.02149, 0.0);
		check_peak("deep sag, exact energy", deep, "model.energy=exact", near_end, 3.4075, 0.02149,
		           0.0);
		check_peak("deeper sag", deeper, NULL, first, 0.9032, 3.435, 258.0);
		check_end();
	}
	check_folds();
	return done_testing();
}
