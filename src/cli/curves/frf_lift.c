/* cli/curves/frf_lift.c - see frf_lift.h.
 *
 *   c    smallest angle of contact over the period, relative to that at rest; the rope leaves the
 *        sheave where it is 0, which is interpolated linearly between two points of the curve
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */

#include "cli/curves/frf_lift.h"
#include "cli/frame/view.h"

/* Where c is 0 first along a curve, of the branch `of`. */
struct lift {
	const struct cli_frf_result *of;
	int after, sheave, probe, count; /* count: points with c < 0 on all branches */
	double share; /* of the way from the point before `after` */
};

static double at(const struct lift *lift, double before, double here)
{
	return here + (1.0 - lift->share)*(before - here);
}

/* The largest displacement of all at a point. */
static int largest(const struct hawser_frf *frf, int point)
{
	const double *probe = frf->probe + 3*(size_t)point*(size_t)frf->probes;
	int most = 0;

	for (int k = 1; k < 3*frf->probes; k++)
		most = probe[k] > probe[most] ? k : most;
	return most;
}

static void look(struct lift *lift, const struct cli_frf_result *result)
{
	const struct hawser_frf *frf = result->frf;

	for (int i = 0; i < frf->points; i++) {
		double c = frf->point[i].contact;

		if (!(c < 0.0))
			continue;
		if (lift->count++ > 0)
			continue;
		lift->of = result;
		lift->after = i;
		lift->sheave = frf->point[i].sheave;
		lift->probe = frf->probes > 0 ? largest(frf, i) : -1;
		lift->share = i > 0 ? frf->point[i - 1].contact/(frf->point[i - 1].contact - c) : 1.0;
	}
}

static struct lift find(const struct cli_frf_result *result)
{
	struct lift lift = {.of = NULL};

	look(&lift, result);
	for (int k = 0; k < result->others; k++)
		look(&lift, &result->other[k]);
	return lift;
}

static struct cli_place place(const struct lift *lift)
{
	const struct hawser_frf_point *here = &lift->of->frf->point[lift->after];
	const struct hawser_frf_point *before = lift->after > 0 ? here - 1 : here;

	return cli_frf_place(lift->of, at(lift, before->omega, here->omega),
	                     at(lift, before->parameter, here->parameter));
}

/* m: the largest displacement there. */
static double motion(const struct lift *lift)
{
	const struct hawser_frf *frf = lift->of->frf;
	const double *here = frf->probe + 3*(size_t)lift->after*(size_t)frf->probes + lift->probe;

	return at(lift, lift->after > 0 ? here[-3*frf->probes] : *here, *here)*
	       cli_per_length(lift->of->model);
}

static const char *sheave(const struct cli_frf_result *result, int index)
{
	return result->model->rom.contacts.name[index];
}

int cli_frf_lift(char *text, size_t size, const struct cli_frf_result *result)
{
	struct lift lift = find(result);
	char where[64] = "";

	if (!lift.of)
		return 0;
	if (lift.probe >= 0)
		snprintf(where, sizeof where, ", where %c_%.32s is %.4g%s", "xyz"[lift.probe%3],
		         result->model->rom.shapes.name[lift.probe/3], motion(&lift),
		         cli_unit(result->model, " m"));
	snprintf(text, size, "lift: at %s the rope leaves sheave %s%s; the model keeps it there, so that "
	         "the response is not that of the rope at this and larger motions (%d points)",
	         place(&lift).text, sheave(result, lift.sheave), where, lift.count);
	return 1;
}

void cli_frf_lift_comment(struct hawser__table *table, const struct cli_frf_result *result)
{
	const struct hawser_frf *frf = result->frf;
	int least = 0;

	for (int i = 1; i < frf->points; i++)
		least = frf->point[i].contact < frf->point[least].contact ? i : least;
	if (frf->points > 0 && frf->point[least].sheave >= 0)
		hawser__table_comment(table, "smallest angle of contact over a period: %.4g of that at rest, "
		                      "on sheave %s, at %s", frf->point[least].contact,
		                      sheave(result, frf->point[least].sheave),
		                      cli_frf_place(result, frf->point[least].omega,
		                                    frf->point[least].parameter).text);
}

void cli_frf_sheaves_json(struct hawser__json *json, json_t *into, const void *of)
{
	const struct hawser_rom_contacts *contacts =
		&((const struct cli_frf_result *)of)->model->rom.contacts;
	json_t *list = hawser__json_array(json, into, "sheaves");

	for (int i = 0; list && i < contacts->count; i++)
		hawser__json_text(json, list, NULL, contacts->name[i]);
}

void cli_frf_lift_json(struct hawser__json *json, json_t *into, const void *of)
{
	const struct cli_frf_result *result = of;
	struct lift lift = find(result);
	const struct hawser_frf_point *here;
	json_t *object = lift.of ? hawser__json_object(json, into, "lift") : NULL;

	if (!object)
		return;
	here = &lift.of->frf->point[lift.after];
	hawser__json_number(json, object, "Omega", at(&lift, lift.after > 0 ? here[-1].omega : here->omega,
	                                              here->omega)*cli_per_omega(result->model));
	hawser__json_text(json, object, "sheave", sheave(result, lift.sheave));
	if (lift.probe >= 0)
		hawser__json_number(json, object, "motion", motion(&lift));
}
