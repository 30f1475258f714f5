/* cli/plan/plan_model.c - hawser plan of a reduced model: its size, what is in it, and the time of its
 * response. What its author left out is not in the file.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include <hawser/plan.h>

#include "cli/plan/plan_result.h"

struct result {
	const struct cli_common *common;
	struct cli_model model;
	double from, to; /* of the response, scaled */
	struct hawser_plan_row row[1];
	int rows;
};

#define OF(member) HAWSER__AT(struct hawser_plan_row, member)
const struct hawser__field cli_plan_model_field[] = {
	{"unknowns", "unknowns", "coordinates of the model", OF(n)},
	{"Q_entries", "Q_entries", "entries of the quadratic tensor", OF(quads)},
	{"C_entries", "C_entries", "entries of the cubic tensor", OF(cubics)},
	{"points", "points", "of the response over the range", OF(points), .flags = HAWSER__NULL},
	{"time_secs", "time_s", "processor time of the response (s)", OF(seconds), .flags = HAWSER__NULL},
	{"least_time_secs", "least_time_s", "lower bound of the time (s)", OF(least),
	 .flags = HAWSER__NULL},
	{"most_time_secs", "most_time_s", "upper bound of the time (s)", OF(most), .flags = HAWSER__NULL},
	HAWSER__END,
};
#undef OF
static const struct hawser__list row_list =
	HAWSER__ROWS_WITHIN(struct result, row, rows, cli_plan_model_field);
const struct hawser__field cli_plan_model_member[] = {
	{"", NULL, "", HAWSER__PART_OF(struct result, model, cli_si_field)},
	{"", NULL, "", HAWSER__PART_OF(struct result, model, cli_naturals_field)},
	{"response.from", NULL, "one end of its range of Omega", HAWSER__AT(struct result, from),
	 .unit = HAWSER__RAD_S},
	{"response.to", NULL, "the other end", HAWSER__AT(struct result, to), .unit = HAWSER__RAD_S},
	{"fidelities", NULL, "the response of the model", HAWSER__OBJECTS_OF(row_list)},
	HAWSER__END,
};

static struct cli_head head(const void *of)
{
	const struct result *result = of;

	return cli_model_head(result->common, "plan", "times are estimates", &result->model, 0);
}

static int forces_of(const struct hawser_rom *rom)
{
	int count = 0;

	for (int h = 0; h < rom->harmonics; h++)
		count += rom->harmonic[h].f != NULL;
	return count;
}

static void comments(struct hawser__table *table, const void *of)
{
	const struct result *result = of;
	const struct cli_model *model = &result->model;
	const struct hawser_rom *rom = &model->rom;
	const char *unit = cli_unit(model, " rad/s");

	hawser__table_comment(table, "range: Omega from %.12g to %.12g%s",
	                      result->from*cli_per_omega(model), result->to*cli_per_omega(model), unit);
	hawser__table_comment(table, "modelled: %s, %d harmonics with %d forces, %d terms that are no "
	                      "tensor entries", rom->first ? "equations of first order" : "oscillators",
	                      rom->harmonics, forces_of(rom), rom->terms);
	for (int k = 0; k < model->naturals; k++)
		hawser__table_comment(table, "natural frequency %d: %.9g%s", k + 1,
		                      model->natural[k]*cli_per_omega(model), unit);
	hawser__table_comment(table, "not known: what the model leaves out, which its file does not say");
}

static const struct cli_showing showing = {.head = head, .comments = comments, .rows = &row_list,
                                           .fields = cli_plan_model_member};

enum hawser_status cli_plan_model(const struct cli_common *common, const char *from, const char *to,
                                  struct hawser_report *report)
{
	struct result result = {.common = common, .rows = 1};
	enum hawser_status status = cli_model_load(&result.model, common, 0, report);

	if (!status)
		status = cli_range(&result.from, &result.to, from, to, "plan", &result.model, report);
	if (!status) {
		hawser_plan_model(result.row, &result.model.rom, result.from, result.to,
		                  result.model.natural, result.model.naturals);
		if (common->reproducible)
			result.row->seconds = result.row->least = result.row->most = NAN;
		status = cli_show(common, &showing, &result, report);
	}
	cli_model_clear(&result.model);
	return status;
}
