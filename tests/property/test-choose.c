/* Models of a subset of the modes against the model of all modes; effective cubic coefficients of
 * single modes, static and dynamic, against independently computed ones; choices for spans with a
 * known answer.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include <hawser/choose.h>

#include "tests/modes-third.h"
#include "tests/rom-entries.h"
#include "tests/tap.h"

static struct hawser_report report;

static int solve(struct hawser_statics *st, struct hawser_modes *modes,
                 const struct hawser_span *span, enum hawser_given given, double value, int n)
{
	struct hawser_modes_options options = {.n = n};

	return ok(!hawser_statics_solve(st, span, given, value, HAWSER_BRANCH_TAUT, &report) &&
	          !hawser_modes_solve(modes, st, &options, &report), "EA %g, d %g: %d modes",
	          span->EA, span->d, n);
}

/* --- subsets --- */

/* The subset's C is that of all modes, less the effect of the omitted modes. */
static double off(const struct hawser_rom *sub, const struct hawser_rom *all,
                  const struct hawser_modes *modes, const int *kept, int count)
{
	double worst = 0.0, largest = 0.0;

	for (int i = 0; i < sub->cubics; i++) {
		const struct hawser_cubic *c = &sub->C[i];
		const int x[4] = {kept[c->j], kept[c->k], kept[c->l], kept[c->m]};
		double back = 0.0;

		for (int s = 0; s < modes->n; s++) {
			int is_kept = 0;

			for (int k = 0; k < count; k++)
				is_kept |= kept[k] == s;
			if (is_kept)
				continue;
			for (int w = 1; w < 4; w++) {
				int a = w == 1 ? 2 : 1, b = w == 3 ? 2 : 3;

				back += third(modes, x[0], x[w], s)*third(modes, x[a], x[b], s)/
				        pow(modes->mode[s].omega, 2);
			}
		}
		back /= c->k == c->m ? 6.0 : c->k == c->l || c->l == c->m ? 2.0 : 1.0;
		largest = fmax(largest, fabs(c->value));
		worst = fmax(worst, fabs(cubic_of(all, x[0], x[1], x[2], x[3]) - back - c->value));
	}
	return worst/largest;
}

static void check_subset(const struct hawser_modes *modes, const struct hawser_scene *scene,
                         const struct hawser_rom *all, const char *name, const int *kept, int count)
{
	struct hawser_modes subset;
	struct hawser_rom rom;
	double error;

	if (!ok(!hawser_modes_select(&subset, modes, kept, count, &report) &&
	        !hawser_rom_build(&rom, &subset, scene, &report), "%s: a model", name))
		return;
	error = off(&rom, all, modes, kept, count);
	ok(error < 1e-9, "%s: C of the subset and of all agree to %.1e", name, error);
	ok(subset.mode[count - 1].place == kept[count - 1] + 1 &&
	   subset.mode[count - 1].omega == modes->mode[kept[count - 1]].omega,
	   "%s: a mode keeps its place and frequency", name);
	ok(hawser_rom_asymmetry(&rom) < 1e-12, "%s: a potential", name);
	hawser_rom_clear(&rom);
	hawser_modes_clear(&subset);
}

static void check_subsets(void)
{
	const struct hawser_span span = {.EA = 1.2e8, .rho = 6.0, .g = 9.81, .d = 200.0, .h = 120.0};
	struct hawser_scene scene = {.model = {.condense = HAWSER_CONDENSE_STATIC}};
	struct hawser_statics st;
	struct hawser_modes modes, subset;
	struct hawser_rom all;
	int in[9], out[9], ins = 0, outs = 0;
	const int mixed[] = {0, 3, 4, 8}, wrong[] = {2, 2}, far[] = {9};

	if (!solve(&st, &modes, &span, HAWSER_GIVEN_T0, 6e4, 9) ||
	    !ok(!hawser_rom_build(&all, &modes, &scene, &report), "model of all"))
		return;
	for (int k = 0; k < modes.n; k++)
		if (modes.mode[k].plane == HAWSER_IN_PLANE)
			in[ins++] = k;
		else
			out[outs++] = k;
	check_subset(&modes, &scene, &all, "in the plane", in, ins);
	check_subset(&modes, &scene, &all, "out of the plane", out, outs);
	check_subset(&modes, &scene, &all, "some", mixed, 4);
	ok(hawser_modes_select(&subset, &modes, wrong, 2, &report) == HAWSER_ERR_ARGUMENT,
	   "not ascending: %s", report.message);
	ok(hawser_modes_select(&subset, &modes, far, 1, &report) == HAWSER_ERR_ARGUMENT,
	   "out of range: %s", report.message);
	ok(hawser_modes_select(&subset, &modes, far, 0, &report) == HAWSER_ERR_ARGUMENT,
	   "none: %s", report.message);
	hawser_rom_clear(&all);
	hawser_modes_clear(&modes);
}

/* --- effective cubic coefficients --- */

/* Ratio of the effective to the raw coefficient of the first out-of-plane mode: all other modes
 * condensed statically, and with their dynamic response at twice its frequency. beta = T_11s/2
 * drives mode s; -(4/3) beta^2 (1/w_s^2 + 1/(2 (w_s^2 - 4 w^2))) replaces the static -2
 * beta^2/w_s^2. The numbers were computed independently. */
static void check_ratio(const char *name, const struct hawser_span *span, enum hawser_given given,
                        double value, double wanted_static, double wanted_dynamic)
{
	struct hawser_scene scene = {.model = {.condense = HAWSER_CONDENSE_STATIC}};
	struct hawser_statics st;
	struct hawser_modes modes, first;
	struct hawser_rom condensed, raw;
	const int one[] = {0};
	double still, moving, w2;

	if (!solve(&st, &modes, span, given, value, 40) ||
	    !ok(!hawser_modes_select(&first, &modes, one, 1, &report) &&
	        !hawser_rom_build(&condensed, &first, &scene, &report) &&
	        !hawser_rom_build(&raw, &first, NULL, &report), "%s: models", name))
		return;
	w2 = pow(modes.mode[0].omega, 2);
	still = moving = condensed.C[0].value;
	for (int s = 1; s < modes.n; s++) {
		double beta = 0.5*third(&modes, 0, 0, s), ws2 = pow(modes.mode[s].omega, 2);

		moving -= 2.0/3.0*beta*beta*(1.0/(ws2 - 4.0*w2) - 1.0/ws2);
	}
	still /= raw.C[0].value;
	moving /= raw.C[0].value;
	ok(fabs(still - wanted_static) < 0.005*fmax(1.0, fabs(wanted_static)),
	   "%s: static %.4f, wanted %.3f", name, still, wanted_static);
	ok(fabs(moving - wanted_dynamic) < 0.006, "%s: dynamic %.4f, wanted %.3f", name, moving,
	   wanted_dynamic);
	hawser_rom_clear(&condensed);
	hawser_rom_clear(&raw);
	hawser_modes_clear(&first);
	hawser_modes_clear(&modes);
}

static void check_ratios(void)
{
	const struct hawser_span b42 = {.EA = 4e8, .rho = 6.0, .g = 9.81, .d = 250.0, .h = 10.0};
	const struct hawser_span b442 = {.EA = 1e8, .rho = 5.56, .g = 9.81, .d = 300.0, .h = 15.0};
	const struct hawser_span b45 = {.EA = 4e8, .rho = 5.0, .g = 9.81, .d = 300.0, .h = 10.0};
	const struct hawser_span b54 = {.EA = 1e8, .rho = 5.0, .g = 9.81, .d = 80.0, .h = 5.0};

	check_ratio("B 4.2", &b42, HAWSER_GIVEN_T0, 8e4, 0.044, -0.038);
	check_ratio("B 4.4, line 2", &b442, HAWSER_GIVEN_T0, 8e4, 0.125, -0.61);
	check_ratio("B 4.5", &b45, HAWSER_GIVEN_H, 1e5, 0.082, -0.133);
	check_ratio("B 5.4", &b54, HAWSER_GIVEN_H, 8e4, 0.53, 0.60);
}

/* --- the choice --- */

static struct hawser_scene loaded(double e, double n, double z)
{
	return (struct hawser_scene){
		.damping = {.kind = HAWSER_DAMPING_RATIO, .ratio = 0.005},
		.load = {.present = 1, .per_length = {e, n, z}, .extent = {0.0, 1.0}},
		.model = {.condense = HAWSER_CONDENSE_STATIC, .accuracy = 0.01},
	};
}

static int same_choice(const struct hawser_choice *a, const struct hawser_choice *b)
{
	for (int j = 0; j < a->n; j++)
		if (a->mode[j].kept != b->mode[j].kept || a->mode[j].reason != b->mode[j].reason)
			return 0;
	return 1;
}

static int count(const struct hawser_choice *choice, enum hawser_plane plane)
{
	int sum = 0;

	for (int j = 0; j < choice->n; j++)
		sum += choice->mode[j].kept && choice->modes->mode[j].plane == plane;
	return sum;
}

/* Index of the first in-plane mode with that symmetry. */
static int in_plane(const struct hawser_modes *modes, enum hawser_symmetry symmetry)
{
	int j = 0;

	while (modes->mode[j].plane != HAWSER_IN_PLANE || modes->mode[j].symmetry != symmetry)
		j++;
	return j;
}

/* A level span with an in-plane load: antisymmetric and out-of-plane modes remain at rest until the
 * motion is large enough to make an out-of-plane mode unstable; the first in-plane mode has twice
 * its frequency. */
static void check_level(void)
{
	const struct hawser_span span = {.EA = 1e8, .rho = 5.0, .g = 9.81, .d = 200.0, .h = 0.0};
	struct hawser_scene weak = loaded(0.0, 0.002, 0.0), strong = loaded(0.0, 1.0, 0.0);
	struct hawser_scene across = loaded(0.0, 0.0, 0.3);
	struct hawser_statics st;
	struct hawser_modes modes;
	struct hawser_choice choice, again;
	double w, before;
	int kept[14], n, j;

	if (!solve(&st, &modes, &span, HAWSER_GIVEN_H, 6.2e4, 14))
		return;
	w = modes.mode[0].omega; /* out-of-plane frequency; the in-plane one is 1.98 times as high */
	if (!ok(!hawser_choose(&choice, &modes, &weak, 1.7*w, 2.3*w, 0.01, &report), "a weak load"))
		return;
	ok(choice.planar && count(&choice, HAWSER_OUT_OF_PLANE) == 0, "is answered in the plane");
	j = in_plane(&modes, HAWSER_ANTISYMMETRIC);
	ok(hawser_choice_reason(&choice, j) == HAWSER_NOT_EXCITED,
	   "the antisymmetric mode in the plane is %s",
	   hawser_reason_name(hawser_choice_reason(&choice, j)));
	n = hawser_choice_kept(kept, &choice);
	before = hawser_choice_rest(&choice);
	ok(n >= 1 && before <= 0.01, "%d modes, the rest %.1e", n, before);
	ok(hawser_choice_raise(&choice, 0.01) == 0, "nothing to add for the same accuracy");
	ok(hawser_choice_raise(&choice, 1e-5) > 0 && hawser_choice_rest(&choice) <= 1e-5,
	   "more for a better one, the rest %.1e", hawser_choice_rest(&choice));
	hawser_choice_clear(&choice);
	if (!ok(!hawser_choose(&choice, &modes, &strong, 1.7*w, 2.3*w, 0.01, &report), "a strong load"))
		return;
	ok(choice.planar && choice.mode[0].kept && choice.mode[0].reason == HAWSER_PARAMETRIC &&
	   choice.mode[0].harmonic == 1 && choice.mode[0].partner == 0,
	   "the first mode across is at risk: %s, measure %.2g", hawser_reason_name(
	   hawser_choice_reason(&choice, 0)), choice.mode[0].measure);
	ok(!hawser_choose(&again, &modes, &strong, 2.3*w, 1.7*w, 0.01, &report) &&
	   same_choice(&again, &choice), "the same from the other end of the range");
	hawser_choice_clear(&again);
	hawser_choice_clear(&choice);
	if (!ok(!hawser_choose(&choice, &modes, &across, 0.8*w, 1.3*w, 0.01, &report),
	        "a load across: %s", report.message))
		return;
	j = in_plane(&modes, HAWSER_SYMMETRIC);
	ok(!choice.planar && choice.mode[0].kept && choice.mode[j].kept &&
	   choice.mode[j].reason == HAWSER_INTERNAL && choice.mode[j].partner == 0 &&
	   choice.mode[j].harmonic == 2,
	   "a load across keeps the mode in the plane at twice the frequency: %s",
	   hawser_reason_name(hawser_choice_reason(&choice, j)));
	hawser_choice_clear(&choice);
	hawser_modes_clear(&modes);
}

static void check_errors(void)
{
	const struct hawser_span span = {.EA = 1e8, .rho = 5.0, .g = 9.81, .d = 200.0, .h = 0.0};
	struct hawser_scene scene = loaded(0.0, 0.0, 1.0), none = scene, zero = loaded(0.0, 0.0, 0.0);
	struct hawser_statics st;
	struct hawser_modes modes;
	struct hawser_choice choice;
	double u[8] = {0.0};

	none.load.present = 0;
	if (!solve(&st, &modes, &span, HAWSER_GIVEN_H, 6e4, 4))
		return;
	ok(hawser_choose(&choice, &modes, &scene, 2.0, 2.0, 0.01, &report) == HAWSER_ERR_ARGUMENT,
	   "an empty range: %s", report.message);
	ok(hawser_choose(&choice, &modes, &scene, -2.0, 2.0, 0.01, &report) == HAWSER_ERR_ARGUMENT,
	   "a negative frequency");
	ok(hawser_choose(&choice, &modes, &scene, 1.0, 2.0, 1.0, &report) == HAWSER_ERR_ARGUMENT,
	   "accuracy: %s", report.message);
	ok(hawser_choose(&choice, &modes, &none, 1.0, 2.0, 0.01, &report) == HAWSER_ERR_ARGUMENT,
	   "no load: %s", report.message);
	ok(hawser_choose(&choice, &modes, &zero, 1.0, 2.0, 0.01, &report) == HAWSER_ERR_ARGUMENT,
	   "a load of nothing: %s", report.message);
	ok(!hawser_choose(&choice, &modes, &scene, 1.0, 5.0, 0.1, &report), "a choice");
	ok(hawser_choice_weigh(&choice, u, 4, 2.0, 1, &report) == HAWSER_ERR_ARGUMENT,
	   "few samples: %s", report.message);
	hawser_choice_forget(&choice);
	ok(hawser_choice_rest(&choice) == 0.0, "forgotten");
	ok(hawser_choice_add(&choice, 3) == 0, "nothing known to add");
	hawser_choice_clear(&choice);
	hawser_choice_clear(&choice);
	hawser_choice_clear(NULL);
	for (int r = -1; r <= HAWSER_REASONS; r++)
		ok(*hawser_reason_name((enum hawser_reason)r) != '\0', "reason %d is \"%s\"", r,
		   hawser_reason_name((enum hawser_reason)r));
	hawser_modes_clear(&modes);
}

CASE(property_choose)
{
	check_subsets();
	check_ratios();
	check_level();
	check_errors();
	return done_testing();
}
