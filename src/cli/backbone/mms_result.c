/* cli/backbone/mms_result.c - comments and fields of multiple scales, see mms_result.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "cli/backbone/mms_result.h"
#include "cli/model/exact.h"

static const char axis[] = "xyz";
static const char *const part_name[] = {"mean", "first", "second"};

/* --- modulation equations --- */

/* "A3" of mode 3, "A3*" its conjugate. */
static void variable(char name[16], const struct hawser_resonance *resonance, int v)
{
	snprintf(name, 16, "A%d%s", resonance->mode[v%resonance->count] + 1,
	         v < resonance->count ? "" : "*");
}

static void monomial_comment(struct hawser__table *table, const struct hawser_modulation *m,
                             const struct hawser_monomial *e)
{
	char name[3][16] = {"", "", ""};

	for (int f = 0; f < 3 && e->factor[f] >= 0; f++)
		variable(name[f], &m->resonance, e->factor[f]);
	if (fabs(e->im) > 1e-12*fabs(e->re))
		hawser__table_comment(table, "    + (%.9g %+.9gi) %s %s %s", e->re, e->im, name[0], name[1],
		                      name[2]);
	else
		hawser__table_comment(table, "    %+.9g %s %s %s", e->re, name[0], name[1], name[2]);
}

static double own_frequency(const struct hawser_modulation *m, int r)
{
	int s = m->resonance.mode[r];

	return sqrt(m->rom->K[(size_t)s*((size_t)m->rom->n + 1)]);
}

void cli_mms_equations(struct hawser__table *table, const struct cli_mms_result *result)
{
	const struct hawser_modulation *m = result->modulation;
	const struct hawser_resonance *resonance = &m->resonance;
	double per_omega = cli_per_omega(result->model);

	hawser__table_comment(table,
	                      "modulation equations (scaled, W = Omega%s): u_j = A_j exp(i p W t) + "
	                      "conjugate", result->base == 1 ? "" : result->base == 2 ? "/2" : "/3");
	for (int r = 0; r < resonance->count; r++) {
		int j = resonance->mode[r], p = resonance->order[r];
		double w = own_frequency(m, r);

		hawser__table_comment(table,
		                      "  mode %d, p = %d, w = %.9g (%.9g%s), detuned by %+.3e: -2 i p W "
		                      "dA%d/dt = (w^2 - p^2 W^2 + i p W %.6g) A%d - load", j + 1, p, w,
		                      w*per_omega, cli_unit(result->model, " rad/s"),
		                      w/(p*resonance->omega0) - 1.0, j + 1,
		                      m->rom->D[(size_t)j*((size_t)m->rom->n + 1)], j + 1);
		for (int i = 0; i < m->monomials; i++)
			if (m->monomial[i].equation == r)
				monomial_comment(table, m, &m->monomial[i]);
	}
	if (isfinite(m->nearest))
		hawser__table_comment(table,
		                      "nearest resonance left out: mode %d at %d times the reference "
		                      "frequency, off by %.2g in the square", m->nearest_mode + 1,
		                      m->nearest_harmonic, m->nearest);
}

struct resonant {
	int mode, order;
	double omega, detuning;
};

HAWSER__OF(resonant_modes, size_t, struct hawser_modulation, (size_t)of->resonance.count)

static const void *resonant_row(void *to, const void *parent, size_t r)
{
	const struct hawser_modulation *m = parent;
	double w = own_frequency(m, (int)r);
	int order = m->resonance.order[r];

	*(struct resonant *)to = (struct resonant){m->resonance.mode[r], order, w,
	                                           w/(order*m->resonance.omega0) - 1.0};
	return to;
}

#define OF(member) HAWSER__AT(struct resonant, member)
static const struct hawser__field resonant_field[] = {
	{"mode", NULL, "from 1", OF(mode), .flags = HAWSER__FROM_1},
	{"order", NULL, "p: it moves at p times the frequency of the motion", OF(order)},
	{"omega", NULL, "its natural frequency", OF(omega), .unit = HAWSER__RAD_S},
	{"detuning", NULL, "of omega from p times the reference frequency, relative", OF(detuning)},
	HAWSER__END,
};
#undef OF
static const struct hawser__list resonant_list = {
	.field = resonant_field, .size = HAWSER__MADE_SIZE(struct resonant), .count = resonant_modes,
	.row = resonant_row};

struct monomial {
	const struct hawser_monomial *of;
	const struct hawser_resonance *resonance;
	int mode, monomials;
	double re, im;
};

static const void *monomial_row(void *to, const void *parent, size_t i)
{
	const struct hawser_modulation *m = parent;
	const struct hawser_monomial *e = &m->monomial[i];

	*(struct monomial *)to = (struct monomial){
		e, &m->resonance, m->resonance.mode[e->equation], m->monomials, e->re, e->im};
	return to;
}

static size_t factors(const void *parent)
{
	const struct hawser_monomial *e = ((const struct monomial *)parent)->of;
	size_t count = 0;

	while (count < 3 && e->factor[count] >= 0)
		count++;
	return count;
}

struct factor {
	char name[16];
};

static const void *factor_row(void *to, const void *parent, size_t f)
{
	const struct monomial *of = parent;

	variable(((struct factor *)to)->name, of->resonance, of->of->factor[f]);
	return to;
}
static const struct hawser__field factor_field[] = {
	{"factors", NULL, "amplitudes A of modes; * marks a conjugate",
	 HAWSER__AT(struct factor, name)},
	HAWSER__END,
};
static const struct hawser__list factor_list = {
	.field = factor_field, .size = HAWSER__MADE_SIZE(struct factor), .count = factors,
	.row = factor_row};
#define OF(member) HAWSER__AT(struct monomial, member)
static const struct hawser__field monomial_field[] = {
	{"mode", NULL, "whose equation has it", OF(mode), .flags = HAWSER__FROM_1},
	{"", NULL, "", HAWSER__ARRAYS_OF(factor_list)},
	{"re", NULL, "coefficient, real part", OF(re)},
	{"im", NULL, "imaginary part", OF(im)},
	HAWSER__END,
};
#undef OF
static const struct hawser__list monomial_list = HAWSER__MADE_ROWS(
	struct monomial, monomial_field, struct hawser_modulation, monomials, monomial_row);

HAWSER__OF(nearest_mode, double, struct hawser_modulation,
	isfinite(of->nearest) ? of->nearest_mode + 1 : HAWSER__NO_INTEGER)

HAWSER__OF(nearest_harmonic, double, struct hawser_modulation,
	isfinite(of->nearest) ? of->nearest_harmonic : HAWSER__NO_INTEGER)

static const struct hawser__field equations_field[] = {
	{"modulation.reference_scaled", NULL, "reference frequency",
	 HAWSER__AT(struct hawser_modulation, resonance.omega0)},
	{"modulation.modes", NULL, "resonant modes", HAWSER__OBJECTS_OF(resonant_list)},
	{"modulation.monomials_scaled", NULL, "terms of the equations",
	 HAWSER__OBJECTS_OF(monomial_list)},
	{"modulation.nearest_left_out.mode", NULL, "nearest resonance left out, if any",
	 HAWSER__COUNT_BY(nearest_mode), .flags = HAWSER__OMIT},
	{"modulation.nearest_left_out.harmonic", NULL, "of the reference frequency",
	 HAWSER__COUNT_BY(nearest_harmonic), .flags = HAWSER__OMIT},
	{"modulation.nearest_left_out.gap", NULL, "relative, of the squares of the frequencies",
	 HAWSER__AT(struct hawser_modulation, nearest), .flags = HAWSER__OMIT | HAWSER__INFINITE},
	HAWSER__END,
};
const struct hawser__field cli_modulation_field[] = {
	{"modulation.base", NULL, "b: the motion has 1/b of the frequency of the load",
	 HAWSER__AT(struct cli_mms_result, base)},
	{"", NULL, "", HAWSER__THROUGH(struct cli_mms_result, modulation, equations_field)},
	HAWSER__END,
};

/* --- one mode in closed form --- */

/* Amplitude of the load on the mode, scaled. */
static double load_of(const struct hawser_primary *primary)
{
	return hypot(primary->load[0], primary->load[1]);
}

static void comments(struct hawser__table *table, const void *of)
{
	const struct cli_mms_result *result = of;
	const struct hawser_primary *primary = result->primary;
	double length = cli_per_length(result->model), per_omega = cli_per_omega(result->model);
	const char *rad_s = cli_unit(result->model, " rad/s"), *m = cli_unit(result->model, " m");

	cli_choice_comments(table, result->model);
	cli_exact_range_comments(table, result->model);
	hawser__table_comment(table, "mode %d: omega = %.12g%s, damping = %.9g%s, load = %.9g%s",
	                      primary->mode + 1, primary->omega*per_omega, rad_s,
	                      primary->damping*per_omega, cli_unit(result->model, " 1/s"),
	                      load_of(primary)*length*per_omega*per_omega,
	                      cli_unit(result->model, " m/s^2"));
	hawser__table_comment(table, "cubic coefficient (scaled): own %.9g, effective %.9g",
	                      primary->own,
	                      primary->cubic);
	hawser__table_comment(table, "backbone: Omega = omega %+.9g a^2%s: %s",
	                      primary->gamma*per_omega/(length*length),
	                      cli_unit(result->model, " (rad/s, m)"),
	                      primary->gamma > 0.0 ? "hardening" : "softening");
	hawser__table_comment(table, "peak: a = %.9g%s at Omega = %.12g%s", primary->peak*length, m,
	                      primary->peak_omega*per_omega, rad_s);
	for (int k = 0; k < primary->folds; k++)
		hawser__table_comment(table, "fold: a = %.9g%s at Omega = %.12g%s",
		                      primary->fold[k]*length, m,
		                      primary->fold_omega[k]*per_omega, rad_s);
	if (!primary->folds)
		hawser__table_comment(table,
		                      "no fold: the load is below the one at which the curve leans over");
	cli_mms_equations(table, result);
}

HAWSER__NUMBERS_BY(load, load_of)

HAWSER__OF(hardening, double, struct hawser_primary, of->gamma > 0.0)

struct fold {
	double omega, a;
};

static const void *fold_row(void *to, const void *parent, size_t k)
{
	const struct hawser_primary *primary = parent;

	*(struct fold *)to = (struct fold){primary->fold_omega[k], primary->fold[k]};
	return to;
}
static const struct hawser__field fold_field[] = {
	{"Omega", NULL, "where it is", HAWSER__AT(struct fold, omega), .unit = HAWSER__RAD_S},
	{"a", NULL, "amplitude", HAWSER__AT(struct fold, a), .unit = HAWSER__M},
	HAWSER__END,
};
static const struct hawser__list fold_list =
	HAWSER__MADE_ROWS(struct fold, fold_field, struct hawser_primary, folds, fold_row);

#define OF(member) HAWSER__AT(struct hawser_primary, member)
static const struct hawser__field primary_field[] = {
	{"primary.mode", NULL, "resonant mode", OF(mode), .flags = HAWSER__FROM_1},
	{"primary.omega", NULL, "its natural frequency", OF(omega), .unit = HAWSER__RAD_S},
	{"primary.damping", NULL, "its damping c", OF(damping), .unit = HAWSER__PER_S},
	{"primary.load", NULL, "amplitude of the load on it", HAWSER__BY(load), .unit = HAWSER__M_S2},
	{"primary.own_cubic_scaled", NULL, "its own cubic coefficient", OF(own)},
	{"primary.effective_cubic_scaled", NULL, "the effective one, with the answer of all modes",
	 OF(cubic)},
	{"primary.backbone", NULL, "Gamma: Omega is omega + Gamma a^2", OF(gamma),
	 .unit = HAWSER__RAD_S_M2},
	{"primary.hardening", NULL, "whether Gamma is positive", HAWSER__FLAG_BY(hardening)},
	{"primary.peak.Omega", NULL, "of the largest amplitude", OF(peak_omega),
	 .unit = HAWSER__RAD_S},
	{"primary.peak.a", NULL, "largest amplitude", OF(peak), .unit = HAWSER__M},
	{"primary.folds", NULL, "none or two", HAWSER__OBJECTS_OF(fold_list)},
	HAWSER__END,
};
#undef OF

/* For each displacement: amplitude, mean, first and second harmonic. */
HAWSER__OF(parts, int, struct cli_model, 12*of->rom.shapes.points)

static void part_column(char *text, size_t size, const void *context, int k)
{
	const struct cli_model *model = context;

	snprintf(text, size, "%c_%s%s%s", axis[k/4 % 3], model->rom.shapes.name[k/12], k % 4 ? "_" : "",
	         k % 4 ? part_name[k % 4 - 1] : "");
}

static double part_at(const void *context, const void *parent, size_t i, int k)
{
	const struct hawser_primary_curve *curve = parent;
	size_t at = i*(size_t)parts(context)/4 + (size_t)k/4;

	return k % 4 ? curve->part[3*at + (size_t)(k % 4) - 1] : curve->frf.probe[at];
}

/* The harmonics alone, by probe and component. */
HAWSER__OF(harmonics, int, struct cli_model, 9*of->rom.shapes.points)

static void part_path(char *text, size_t size, const void *context, int k)
{
	const struct cli_model *model = context;

	snprintf(text, size, "%s%c%c%c%s", model->rom.shapes.name[k/9], HAWSER__NESTED, axis[k/3 % 3],
	         HAWSER__NESTED, part_name[k % 3]);
}
static const struct hawser__vector
	parts_vector = {.shown = "x_PROBE", .count = parts, .name = part_column, .number = part_at},
	harmonics_vector = {.count = harmonics, .name = part_path, .object = 1};

static const struct hawser__field point_field[] = {
	{"Omega", "Omega", "forcing frequency", HAWSER__AT(struct hawser_frf_point, omega),
	 .unit = HAWSER__RAD_S},
	{"stable", "stable", "whether the motion is stable",
	 HAWSER__NOT_AT(struct hawser_frf_point, unstable)},
	{"a", "a", "amplitude of the mode", HAWSER__ALONG(struct hawser_primary_curve, amplitude),
	 .unit = HAWSER__M},
	{NULL, "", "largest displacement over a period; with _mean, _first and _second before the "
	 "unit its harmonics", HAWSER__VECTOR_OF(parts_vector), .unit = HAWSER__M},
	{"amplitude", NULL, "largest displacement over a period",
	 HAWSER__VECTOR_ALONG(struct hawser_primary_curve, frf.probe, cli_probes), .unit = HAWSER__M},
	{"parts", NULL, "by probe and component: mean, first and second harmonic",
	 HAWSER__VECTOR_ALONG(struct hawser_primary_curve, part, harmonics_vector), .unit = HAWSER__M},
	HAWSER__END,
};
static const struct hawser__list point_list = HAWSER__STORED_ROWS(
	struct hawser_primary_curve, frf.point, frf.points, point_field);
static const struct hawser__field curve_field[] = {
	{"points", NULL, "of the curve", HAWSER__OBJECTS_OF(point_list)},
	HAWSER__END,
};

#define THROUGH(member, fields) {"", NULL, "", HAWSER__THROUGH(struct cli_mms_result, member, fields)}
static const struct hawser__field mms_field[] = {
	THROUGH(model, cli_si_field),
	{"range", NULL, "of Omega", HAWSER__PAIR_AT(struct cli_mms_result, from, to),
	 .unit = HAWSER__RAD_S},
	THROUGH(model, cli_choice_field),
	THROUGH(primary, primary_field),
	{"", NULL, "", HAWSER__OBJECT_OF(cli_modulation_field)},
	THROUGH(curve, curve_field),
	HAWSER__END,
};
const struct cli_listing cli_mms_listing[] = {
	{"Columns of the closed form of one mode (of other curves those of hawser-frf(1)):",
	 point_field, 0},
	{"Keys of JSON:", mms_field, 1},
	{NULL, NULL, 0},
};

static struct cli_head head(const void *of)
{
	const struct cli_mms_result *result = of;
	struct cli_head head = cli_model_head(
		result->common, "mms", "multiple scales, closed form of one mode at primary resonance",
		result->model, 0);

	head.rows = result->curve;
	return head;
}

const struct cli_showing cli_mms_showing = {
	.head = head, .comments = comments, .rows = &point_list, .fields = mms_field,
	.draw = cli_mms_draw};

enum hawser_status cli_mms_draw(const char *path, const void *context, struct hawser_report *report)
{
	const struct cli_mms_result *result = context;
	const struct cli_frf_result drawn = {.common = result->common, .model = result->model,
	                                     .frf = &result->curve->frf, .from = result->from,
	                                     .to = result->to, .scale = "linear"};

	return cli_frf_draw(path, &drawn, report);
}
