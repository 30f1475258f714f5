/* cli/curves/locus_draw.c - the picture of `locus`: its curves in the plane of both parameters,
 * with the names of their special points. SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>

#include "cli/model/axis.h"
#include "cli/curves/locus_result.h"
#include "cli/frame/view.h"
#include "core/report.h"
#include "output/curves/plot_locus.h"

enum hawser_status cli_locus_draw(const char *path, const void *context,
                                  struct hawser_report *report)
{
	const struct cli_locus_result *result = context;
	const struct hawser_locus *locus = result->locus;
	struct hawser__locus_picture picture = {.locus = locus};

	picture.axis[0] = result->first ? cli_axis(result->first, result->first_unit,
	                                           fmax(fabs(result->from), fabs(result->to)))
	                  : cli_frf_axis(result->model);
	picture.axis[1] = cli_axis(result->key, result->unit, fmax(fabs(result->parameter_from),
	                                                           fabs(result->parameter_to)));
	picture.per_omega = (result->first ? 1.0 : cli_per_omega(result->model))/picture.axis[0].per;
	picture.from[0] = fmin(result->from, result->to)*picture.per_omega;
	picture.to[0] = fmax(result->from, result->to)*picture.per_omega;
	picture.from[1] = fmin(result->parameter_from, result->parameter_to)/picture.axis[1].per;
	picture.to[1] = fmax(result->parameter_from, result->parameter_to)/picture.axis[1].per;
	return hawser__plot_locus(path, &picture, report);
}
