/* Loci of autonomous models in two parameters, against closed forms: Hopf points of the Brusselator,
 * B = 1 + A^2, and of Ziegler's column, p = 41/28 + d^2/2; the generalised Hopf point of the Bautin
 * normal form and its folds of cycles, b1 = -b2^2/4; zero-Hopf, double Hopf and Bogdanov-Takens points
 * of oscillators that were made for it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdio.h>
#include <stdlib.h>

#include <hawser/locus.h>

#include "tests/tap.h"

static struct hawser_report report;

static int trace(struct hawser_locus *locus, const char *name, const char *const key[2],
                 struct hawser_locus_options options)
{
	struct hawser_rom_source source;
	struct hawser_rom_plane plane;
	const char *path = source_file("tests/reference/autonomous/%s.json", name);
	enum hawser_status status;

	*locus = (struct hawser_locus){.n = 0};
	if (!ok(!hawser_rom_source_open(&source, path, &report), "%s %s", name, report.message))
		return 0;
	status = hawser_parameter_plane_open(&plane, &source, key, 0.0, &report);
	options.plane = &plane;
	if (!status)
		status = hawser_locus_trace(locus, NULL, &options, &report);
	hawser_plane_close(&plane);
	hawser_rom_source_clear(&source);
	return ok(!status && locus->points > 2 && locus->curves == 1, "a locus of %s: %d points %s", name,
	          locus->points, report.message);
}

static void special(const struct hawser_locus *locus, const char *name, double first, double second)
{
	int found = 0;

	for (int e = 0; e < locus->events; e++)
		found += strcmp(hawser_locus_special_name(locus->kind, locus->event[e].kind), name) == 0 &&
		         fabs(locus->event[e].omega - first) < 1e-6 &&
		         fabs(locus->event[e].parameter - second) < 1e-6;
	ok(found == 1, "%s at %g, %g: %d of %d special points, the first at %g, %g", name, first, second,
	   found, locus->events, locus->events ? locus->event[0].omega : NAN,
	   locus->events ? locus->event[0].parameter : NAN);
}

/* The first ones are quick. near: of two curves; 0: of the only one. */
enum { QUICK = 4, MOST = 3 };
static const struct {
	const char *name, *key[2];
	enum hawser_event_kind kind;
	double first[2], second[2], at, near, step;
	struct {
		const char *name;
		double at[2];
	} special[MOST];
} made[] = {
	{"lorenz84", {"F", "G"}, HAWSER_HOPF, {0.5, 4.0}, {0.05, 3.0}, 0.5, 0.0, 0.05,
	 {{"zero-hopf", {1.68405172414, 1.68296855266}}}},
	{"pleat", {"b1", "b2"}, HAWSER_FOLD, {-0.5, 0.5}, {-0.5, 1.0}, 0.5, 0.0, 0.1,
	 {{"cusp", {0.0, 0.0}}}},
	{"flip", {"a", "b"}, HAWSER_PERIOD_DOUBLING, {-1.0, 0.5}, {-0.2, 0.3}, 0.2, 0.0, 0.4,
	 {{"generalised-period-doubling", {0.0, 0.0}}}},
	{"roots", {"c", "w"}, HAWSER_TORUS, {-0.3, 0.2}, {0.2, 0.35}, 0.22, 0.0, 0.4,
	 {{"1:4", {0.0, 0.25}}, {"chenciner", {0.0, 0.29}}, {"1:3", {0.0, 1.0/3.0}}}},
	{"cusp", {"b1", "b2"}, HAWSER_FOLD, {-0.7, 0.3}, {-0.1, 0.3}, 0.15, 0.0, 0.3,
	 {{"cusp", {0.0, 0.0}}}},
	{"equal", {"c", "a"}, HAWSER_TORUS, {-0.3, 0.2}, {-0.05, 0.1}, -0.04, 0.0, 0.2,
	 {{"1:1", {0.0, 0.0}}}},
	{"half", {"c", "a"}, HAWSER_TORUS, {-0.3, 0.2}, {-0.02, 0.1}, -0.015, 0.0, 0.1,
	 {{"1:2", {0.0, 0.0}}}},
	{"fold-flip", {"b1", "b2"}, HAWSER_FOLD, {-0.2, 1.2}, {-0.4, 0.2}, -0.3, 0.0, 0.5,
	 {{"fold-flip", {0.0, 0.0}}}},
	{"fold-flip", {"b1", "b2"}, HAWSER_PERIOD_DOUBLING, {-0.2, 1.2}, {-0.1, 0.11}, 0.1, 0.0067, 0.1,
	 {{"fold-flip", {0.0, 0.0}}}},
	{"fold-torus", {"b1", "b2"}, HAWSER_FOLD, {-0.2, 1.2}, {-0.4, 0.2}, -0.3, 0.0, 0.5,
	 {{"fold-torus", {0.0, 0.0}}}},
	{"fold-torus", {"b1", "b2"}, HAWSER_TORUS, {-0.2, 1.2}, {-0.1, 0.11}, 0.1, 0.0, 0.1,
	 {{"fold-torus", {0.0, 0.0}}}},
};

static void cycles(void)
{
	size_t count = getenv("HAWSER_LONG") ? sizeof made/sizeof *made : QUICK;
	struct hawser_locus locus;

	for (size_t i = 0; i < count; i++) {
		int traced = trace(&locus, made[i].name, made[i].key, (struct hawser_locus_options){
			.kind = made[i].kind, .from = made[i].first[0], .to = made[i].first[1],
			.parameter_from = made[i].second[0], .parameter_to = made[i].second[1],
			.at = made[i].at, .near = made[i].near, .step_max = made[i].step});

		for (int k = 0; traced && k < MOST && made[i].special[k].name; k++)
			special(&locus, made[i].special[k].name, made[i].special[k].at[0],
			        made[i].special[k].at[1]);
		hawser_locus_clear(&locus);
	}
}

CASE(reference_locus_own)
{
	struct hawser_locus locus;
	double worst = 0.0, rate = 0.0;

	if (trace(&locus, "brusselator", (const char *[]){"A", "B"}, (struct hawser_locus_options){
			.kind = HAWSER_HOPF, .from = 0.5, .to = 2.0, .parameter_from = 1.0,
			.parameter_to = 6.0, .at = 3.0, .step_max = 0.05}))
		for (int i = 0; i < locus.points; i++) {
			double A = locus.point[i].omega;

			worst = fmax(worst, fabs(locus.point[i].parameter - 1.0 - A*A));
			rate = fmax(rate, fabs(locus.point[i].own - A));
		}
	ok(worst < 1e-9 && rate < 1e-9, "Hopf points on B = 1 + A^2 with the frequency A: %.1e, %.1e",
	   worst, rate);
	ok(locus.curve[0].end[0] == HAWSER_LOCUS_OMEGA && locus.curve[0].end[1] == HAWSER_LOCUS_OMEGA,
	   "from one end of the range to the other");
	hawser_locus_clear(&locus);
	worst = rate = 0.0;
	if (trace(&locus, "ziegler", (const char *[]){"p", "d"}, (struct hawser_locus_options){
			.kind = HAWSER_HOPF, .from = 0.5, .to = 3.0, .parameter_from = 0.05,
			.parameter_to = 1.0, .at = 0.3, .step_max = 0.1}))
		for (int i = 0; i < locus.points; i++) {
			double d = locus.point[i].parameter;

			worst = fmax(worst, fabs(locus.point[i].omega - 41.0/28.0 - d*d/2.0));
			rate = fmax(rate, fabs(pow(locus.point[i].own, 2) - 2.0/7.0));
		}
	ok(worst < 1e-9 && rate < 1e-9, "Ziegler's column: %.1e, %.1e", worst, rate);
	hawser_locus_clear(&locus);
	worst = 0.0;
	if (trace(&locus, "bautin", (const char *[]){"b1", "b2"}, (struct hawser_locus_options){
			.kind = HAWSER_HOPF, .from = -0.5, .to = 0.5, .parameter_from = -1.0,
			.parameter_to = 1.0, .at = 0.6, .step_max = 0.1})) {
		for (int i = 0; i < locus.points; i++)
			worst = fmax(worst, fabs(locus.point[i].l1 - 2.0*locus.point[i].parameter));
		ok(worst < 1e-9, "Bautin: l1 = 2 b2 to %.1e", worst);
		special(&locus, "generalised-hopf", 0.0, 0.0);
	}
	hawser_locus_clear(&locus);
	worst = 0.0;
	if (trace(&locus, "bautin", (const char *[]){"b1", "b2"}, (struct hawser_locus_options){
			.kind = HAWSER_FOLD, .from = -0.3, .to = 0.02, .parameter_from = 0.98,
			.parameter_to = 1.02, .at = 1.0, .step_max = 0.5}))
		for (int i = 0; i < locus.points; i++)
			worst = fmax(worst, fabs(locus.point[i].omega + pow(locus.point[i].parameter, 2)/4.0));
	ok(worst < 1e-9, "folds of cycles on b1 = -b2^2/4: %.1e", worst);
	hawser_locus_clear(&locus);
	if (trace(&locus, "corners", (const char *[]){"a", "b"}, (struct hawser_locus_options){
			.kind = HAWSER_HOPF, .from = -0.5, .to = 0.5, .parameter_from = -0.7,
			.parameter_to = 1.2, .at = -0.5, .step_max = 0.1})) {
		special(&locus, "double-hopf", 0.0, 0.0);
		special(&locus, "zero-hopf", 0.0, 1.0);
	}
	hawser_locus_clear(&locus);
	if (trace(&locus, "takens", (const char *[]){"a", "b"}, (struct hawser_locus_options){
			.kind = HAWSER_HOPF, .from = -2.0, .to = 1.0, .parameter_from = -1.0,
			.parameter_to = 2.0, .at = 0.8, .step_max = 0.05}))
		special(&locus, "bogdanov-takens", -1.0, 0.0);
	hawser_locus_clear(&locus);
	cycles();
	return done_testing();
}
