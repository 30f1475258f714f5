/* statics/plausible.c - compare quantities of a scene with the bounds of scene/plausible.c.
 *
 *   T   largest static tension, at rest     L   distance of the ends
 *   q   load per length                     w1  pi/L sqrt(T/rho), about the first frequency
 *
 * One mistake affects several quantities: H = 30 N in place of 30 kN causes an excessive sag and an
 * excessive strain. It is therefore tested whether scaling a single value by a power of 1000 brings
 * all quantities within their bounds. If so, only that key is reported.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include <hawser/plausible.h>
#include <hawser/statics.h>

#include "core/append.h"
#include "scene/keys.h"

/* --- quantities; NAN if the scene does not have the quantity or has no static shape --- */

static double damping_ratio(const struct hawser_scene *scene, double w1)
{
	switch (scene->damping.kind) {
	case HAWSER_DAMPING_ALPHA:
		return scene->damping.alpha/(2.0*(scene->cable.rho + scene->static_load.mass)*w1);
	case HAWSER_DAMPING_RAYLEIGH:
		return 0.5*(scene->damping.mass/w1 + scene->damping.stiffness*w1);
	case HAWSER_DAMPING_RATIO: return scene->damping.ratio;
	default: return NAN;
	}
}

static double size_of(const double p[3])
{
	return sqrt(p[0]*p[0] + p[1]*p[1] + p[2]*p[2]);
}

/* The number in the list `loads` of the largest load per length; -1: that is the section load. */
static int heaviest(const struct hawser_scene *scene)
{
	double most = scene->load.present ? size_of(scene->load.per_length) : 0.0;
	int found = -1;

	for (int i = 0; i < scene->loads; i++)
		if (size_of(scene->piece[i].per_length) > most) {
			most = size_of(scene->piece[i].per_length);
			found = i;
		}
	return found;
}

static double load_per_tension(const struct hawser_scene *scene, double L, double T)
{
	int i = heaviest(scene);
	double q = i >= 0 ? size_of(scene->piece[i].per_length)
	                  : scene->load.present ? size_of(scene->load.per_length) : 0.0;

	return q > 10.0*scene->cable.rho*scene->g ? q*L/T : 0.0;
}

/* Returns 0 if there is no static shape. */
static int of_span(double value[HAWSER__RULES], const struct hawser_scene *scene)
{
	const struct hawser_span span = {scene->cable.EA, scene->cable.rho, scene->g, scene->span.d,
	                                 scene->span.h};
	double L = hypot(span.d, span.h), T;
	struct hawser_statics at_rest;
	struct hawser_equivalent equal;
	enum hawser_status status = hawser_statics_equivalent(&equal, scene, NULL);

	if (!status)
		status = hawser_statics_solve(&at_rest, &equal.span, equal.given, equal.value,
		                              equal.branch, NULL);

	value[HAWSER__RULE_LENGTH] = L;
	value[HAWSER__RULE_GRAVITY] = span.g;
	value[HAWSER__RULE_MASS] = span.rho;
	if (isfinite(span.EA))
		value[HAWSER__RULE_SOUND] = sqrt(span.EA/span.rho);
	value[HAWSER__RULE_SPEED] = fmax(scene->travel.speed, fmax(scene->travel.fluctuation,
	                                                           scene->travel.final));
	if (status)
		return 0;
	T = fmax(at_rest.T0, at_rest.T1);
	value[HAWSER__RULE_STRAIN] = T/span.EA;
	value[HAWSER__RULE_STRENGTH] = T/span.rho;
	value[HAWSER__RULE_SAG] = at_rest.sag/L;
	value[HAWSER__RULE_LOAD] = load_per_tension(scene, L, T);
	value[HAWSER__RULE_DAMPING] = damping_ratio(scene, M_PI/L*sqrt(T/span.rho));
	return 1;
}

static int of_beam(double value[HAWSER__RULES], const struct hawser_scene *scene)
{
	double rhoA = scene->beam.rhoA, L = scene->beam.L;

	if (scene->beam.form != HAWSER_BEAM_EI)
		return 1;
	value[HAWSER__RULE_BEAM_LENGTH] = L;
	value[HAWSER__RULE_BEAM_MASS] = rhoA;
	value[HAWSER__RULE_BEAM_STIFFNESS] = sqrt(scene->beam.EI/rhoA)/L;
	value[HAWSER__RULE_BEAM_STRENGTH] = scene->beam.tension_end/rhoA;
	value[HAWSER__RULE_BEAM_SPEED] = scene->beam.speed;
	return 1;
}

static int quantities(double value[HAWSER__RULES], const struct hawser_scene *scene)
{
	for (int r = 0; r < HAWSER__RULES; r++)
		value[r] = NAN;
	return scene->beam.form ? of_beam(value, scene) : of_span(value, scene);
}

static int breaks(int r, double value)
{
	const struct hawser_plausible_rule *rule = hawser_plausible_rule(r);

	return value < rule->low || value > rule->high;
}

/* --- keys --- */

enum { KEY = 32 };

/* The k-th key of a rule that applies to this scene; returns 0 if there is none. */
static int key_of(char key[KEY], const struct hawser_plausible_rule *rule, int k,
                  const struct hawser_scene *scene)
{
	static const char *const tension[] = {"", "H", "T0", "T1", "length0", "sag"};
	static const char *const damping[] = {"", "alpha", "rayleigh.mass", "ratio"};
	const char *at = rule->keys, *member = "";

	for (; k > 0 && *at; k--) {
		at += strcspn(at, " ");
		at += strspn(at, " ");
	}
	if (!*at)
		return 0;
	snprintf(key, KEY, "%.*s", (int)strcspn(at, " "), at);
	if (strcmp(key, "tension") == 0)
		member = tension[scene->tension.given];
	else if (strcmp(key, "damping") == 0)
		member = damping[scene->damping.kind];
	else if (strcmp(key, "load.per_length") == 0 && heaviest(scene) >= 0)
		snprintf(key, KEY, "loads.%d.per_length", heaviest(scene));
	if (*member)
		snprintf(key + strlen(key), KEY - strlen(key), ".%s", member);
	return 1;
}

/* Whether the key is load.per_length or loads.N.per_length; then *load is the number N, or -1. */
static int is_load(const char *key, int *load)
{
	*load = -1;
	/* NOLINTNEXTLINE(cert-err34-c): a key that was read */
	return strcmp(key, "load.per_length") == 0 || sscanf(key, "loads.%d.per_length", load) == 1;
}

/* The value of a key, or the largest element of a list; NAN if the scene does not have the key. */
static double get(const struct hawser_scene *scene, const char *key)
{
	double value = NAN;
	int load;

	if (is_load(key, &load)) {
		const double *p = load >= 0 ? scene->piece[load].per_length : scene->load.per_length;

		return fmax(fabs(p[0]), fmax(fabs(p[1]), fabs(p[2])));
	}
	return hawser_scene_get(scene, &value, key, NULL) ? NAN : value;
}

/* Copy the scene with this key multiplied by `factor`; returns 0 if the value is out of range. */
static int scaled(struct hawser_scene *other, const struct hawser_scene *scene, const char *key,
                  double factor)
{
	int load;

	*other = *scene;
	if (!is_load(key, &load))
		return !hawser_scene_set(other, key, factor*get(scene, key), NULL);
	for (int k = 0; k < 3; k++)
		*(load >= 0 ? &other->piece[load].per_length[k] : &other->load.per_length[k]) *= factor;
	return 1;
}

static int settles(const struct hawser_scene *scene, const char *key, double factor)
{
	struct hawser_scene other;
	double value[HAWSER__RULES];

	if (!isfinite(get(scene, key)) || !scaled(&other, scene, key, factor) ||
	    !quantities(value, &other))
		return 0;
	for (int r = 0; r < HAWSER__RULES; r++)
		if (breaks(r, value[r]))
			return 0;
	return 1;
}

/* The smallest factor of a key of the rule that brings all quantities within their bounds, or 0.
 * Factors of 100 are for percentages and for g in cm/s^2. */
static double find_factor(char key[KEY], const struct hawser_plausible_rule *rule,
                          const struct hawser_scene *scene)
{
	static const double factor[] = {1e-2, 1e3, 1e-3, 1e6, 1e-6, 1e9, 1e-9};

	for (size_t f = 0; f < sizeof factor/sizeof *factor; f++)
		for (int k = 0; key_of(key, rule, k, scene); k++)
			if ((f > 0 || strcmp(key, "g") == 0 || strcmp(key, "damping.ratio") == 0) &&
			    settles(scene, key, factor[f]))
				return factor[f];
	return 0.0;
}

/* --- text --- */

/* A value with its unit, newtons with a prefix: "400 MN", "8.16 m/s". */
static void show(char *text, size_t size, double value, const char *unit)
{
	static const char *const prefix[] = {"m", "", "k", "M", "G"};
	int p = 1;

	if (strcmp(unit, "N") == 0 && value > 0.0 && isfinite(value))
		p = (int)fmin(4.0, fmax(0.0, 1.0 + floor(log10(value*(1.0 + 1e-9))/3.0)));
	value *= pow(10.0, -3.0*(p - 1));
	snprintf(text, size, "%.6g%s%s%s", value, *unit && strcmp(unit, "1") != 0 ? " " : "", prefix[p],
	         strcmp(unit, "1") != 0 ? unit : "");
}

static const char *unit_of(const char *key)
{
	const struct hawser_scene_key *row;
	int load;

	if (is_load(key, &load))
		key = "load.per_length";
	for (int i = 0; (row = hawser_scene_key(i)); i++)
		if (strcmp(row->path, key) == 0)
			return row->unit;
	return "";
}

/* "100 to 15000 m/s" */
static void bounds(char *text, size_t size, const struct hawser_plausible_rule *rule)
{
	char low[24] = "up";

	if (rule->low > 0.0)
		snprintf(low, sizeof low, "%g", rule->low);
	snprintf(text, size, "%s to %g%s%s", low, rule->high, *rule->unit ? " " : "", rule->unit);
}

/* "cable.EA = 400 N" */
static void append_key(struct hawser_doubt *doubt, const struct hawser_scene *scene,
                       const char *key)
{
	const char *unit = unit_of(key);
	int pure = strcmp(unit, "1") == 0;

	hawser__append(doubt->text, sizeof doubt->text, ", ", "%s = %.6g%s%s", key, get(scene, key),
	               pure ? "" : " ", pure ? "" : unit);
}

/* Write the text of a doubt: the key that a factor would correct or, for factor 0, all keys of the
 * rule. */
static void describe(struct hawser_doubt *doubt, const struct hawser_scene *scene, double factor)
{
	const struct hawser_plausible_rule *rule = doubt->rule;
	char key[KEY], range[64], text[192];
	int many = 0;

	*doubt->text = '\0';
	if (factor > 0.0)
		append_key(doubt, scene, doubt->key);
	for (int k = 0; !(factor > 0.0) && key_of(key, rule, k, scene); k++)
		if (isfinite(get(scene, key)) && get(scene, key) != 0.0) {
			append_key(doubt, scene, key);
			many++;
		}
	bounds(range, sizeof range, rule);
	if (isnan(doubt->value))
		snprintf(text, sizeof text, "the span is far from having a static shape");
	else
		snprintf(text, sizeof text, "%s%s%s%s is %.3g%s%s (plausible: %s)", rule->name,
		         *rule->formula ? ", " : "", rule->formula, *rule->formula ? "," : "",
		         doubt->value, *rule->unit ? " " : "", rule->unit, range);
	hawser__append(doubt->text, sizeof doubt->text, "", " look%s wrong: %s", many > 1 ? "" : "s", text);
	if (!(factor > 0.0))
		return;
	show(text, sizeof text, factor*get(scene, doubt->key), unit_of(doubt->key));
	hawser__append(doubt->text, sizeof doubt->text, "; ", "it would be plausible with %s", text);
	if (factor > 1e5 && get(scene, doubt->key) < 1.0)
		hawser__append(doubt->text, sizeof doubt->text, " ", "(m is milli, M is mega)");
}

/* --- */

/* 1 if a tension is given that is less than a tenth of the least one. The solver reports that the
 * tension is too small; a wrong unit is a likely reason. */
static int far_below_least(const struct hawser_scene *scene)
{
	double weight = scene->cable.rho*scene->g*hypot(scene->span.d, scene->span.h);

	return !scene->beam.form && (scene->tension.given == HAWSER_GIVEN_T0 ||
	                             scene->tension.given == HAWSER_GIVEN_T1) &&
	       10.0*scene->tension.value < 0.5*weight;
}

/* 1 if a quantity is so far outside its bounds that a factor of 1000 is a likely reason. */
static int far(const struct hawser_doubt *doubt)
{
	return !(doubt->value < 2.0*doubt->rule->high && 2.0*doubt->value > doubt->rule->low);
}

static int collect(struct hawser_doubt *doubt, const struct hawser_scene *scene)
{
	double value[HAWSER__RULES];
	int count = 0, solved = quantities(value, scene);

	for (int r = 0; r < HAWSER__RULES; r++)
		if (breaks(r, value[r]) || (r == HAWSER__RULE_SAG && !solved && far_below_least(scene)))
			doubt[count++] = (struct hawser_doubt){.rule = hawser_plausible_rule(r),
			                                       .value = value[r]};
	return count;
}

int hawser_scene_doubts(struct hawser_doubt *doubt, const struct hawser_scene *scene)
{
	int count = collect(doubt, scene);

	for (int i = 0; i < count; i++) {
		double factor = far(&doubt[i]) ? find_factor(doubt[i].key, doubt[i].rule, scene) : 0.0;

		if (factor > 0.0) {
			doubt[0] = doubt[i];
			describe(&doubt[0], scene, factor);
			return 1;
		}
	}
	for (int i = 0; i < count; i++) {
		(void)key_of(doubt[i].key, doubt[i].rule, 0, scene);
		describe(&doubt[i], scene, 0.0);
	}
	return count;
}
