/* cli/sweep/sweep_map.c - the picture of a sweep over two keys with many values of both: a map
 * of one column. SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include "cli/sweep/sweep.h"
#include "core/report.h"

static const double equal = 1e-6; /* of a distance: as distances that are equal differ by round-off */

int cli_sweep_is_map(const struct cli_sweep_plan *plan)
{
	if (plan->axes != 2 || plan->keys != 2)
		return 0;
	for (int k = 0; k < 2; k++) {
		const double *at = plan->key[k].number;
		long count = plan->axis[k].values;

		if (!plan->key[k].numbers || count < 3)
			return 0;
		for (long i = 2; i < count; i++)
			if (!(fabs(at[i] - at[i - 1] - (at[1] - at[0])) < equal*fabs(at[1] - at[0])))
				return 0;
	}
	return 1;
}

/* value [ny][nx] of the first row of each variation; ranges that fall are turned round. */
static void fill(struct hawser__map_picture *picture, double *value,
                 const struct cli_sweep_result *result, int column, double per)
{
	const struct cli_sweep_plan *plan = &result->sweep->plan;
	long nx = picture->nx, ny = picture->ny;

	for (long i = 0; i < nx*ny; i++)
		value[i] = NAN;
	for (long i = result->lines - 1; i >= 0; i--) {
		long x = cli_sweep_at(plan, 0, result->line[i].variation);
		long y = cli_sweep_at(plan, 1, result->line[i].variation);

		x = plan->key[0].number[0] < plan->key[0].number[1] ? x : nx - 1 - x;
		y = plan->key[1].number[0] < plan->key[1].number[1] ? y : ny - 1 - y;
		value[y*nx + x] = cli_sweep_number(&result->line[i], column)/per;
	}
	for (long i = 0; i < nx*ny; i++)
		picture->holes |= isnan(value[i]);
}

/* at [count] ascending. */
static void places(double *at, const struct cli_sweep_key *key, long count)
{
	int rises = key->number[0] < key->number[1];

	for (long i = 0; i < count; i++)
		at[i] = key->number[rises ? i : count - 1 - i];
}

enum hawser_status cli_sweep_map(const char *path, const struct cli_sweep_result *result, int column,
                                 double largest, struct hawser_report *report)
{
	const struct cli_sweep_plan *plan = &result->sweep->plan;
	long nx = plan->axis[0].values, ny = plan->axis[1].values;
	double *x = malloc((size_t)(nx + ny + nx*ny)*sizeof *x);
	struct hawser__axis axis = cli_sweep_column_axis(result->column[column], largest);
	struct hawser__map_picture picture = {.nx = (int)nx, .ny = (int)ny, .border = NAN,
		.title = axis.title, .line_title = ""};
	enum hawser_status status;

	if (!x)
		return hawser__no_memory(report, "sweep");
	places(x, &plan->key[0], nx);
	places(x + nx, &plan->key[1], ny);
	fill(&picture, x + nx + ny, result, column, axis.per);
	picture.x = x;
	picture.y = x + nx;
	picture.value = x + nx + ny;
	picture.x_axis = cli_sweep_key_axis(&plan->key[0], x[nx - 1]);
	picture.y_axis = cli_sweep_key_axis(&plan->key[1], x[nx + ny - 1]);
	status = hawser__plot_map(path, &picture, report);
	free(x);
	return status;
}
