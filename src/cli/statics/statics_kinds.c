/* cli/statics/statics_kinds.c - hawser statics: which kind a scene is.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include "cli/statics/rod_result.h"
#include "cli/statics/statics_kinds.h"
#include "cli/statics/statics_net.h"
#include "cli/statics/statics_obstacles.h"

const char *const cli_statics_notes[] = {
	"Methods for nets: automatic, interior-point, mixed, forces, catenary; for comparison two-sided,",
	"regularised, descent and relaxation, which may end with compressed elements or not at all.",
	NULL,
};

enum hawser_status cli_statics_kinds(int *done, const struct cli_common *common,
                                     const struct cli_statics_kinds *kinds, int points, int cases,
                                     struct hawser_report *report)
{
	*done = 1;
	switch (cli_kind(common)) {
	case HAWSER_KIND_ROD:
		return cli_statics_rod(common, kinds, report);
	case HAWSER_KIND_OBSTACLES:
		return cli_statics_obstacles(common, kinds, points, report);
	case HAWSER_KIND_ROPEWAY:
		return cli_statics_ropeway(common, kinds, cases, report);
	case HAWSER_KIND_NET:
		return kinds->equilibria ? cli_equilibria_net(common, kinds->equilibria, report)
		                         : cli_statics_net(common, kinds->method, kinds->profile, kinds->vtk,
		                                           report);
	default:
		*done = 0;
		return HAWSER_OK;
	}
}
