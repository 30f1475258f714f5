/* cli/statics_kinds.c - hawser statics: which kind a scene is, and options that do not go with it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include "cli/rod_result.h"
#include "cli/statics_kinds.h"
#include "cli/statics_net.h"
#include "cli/statics_obstacles.h"
#include "core/report.h"

const char *const cli_statics_notes[] = {
	"Methods for nets: automatic, interior-point, mixed, forces, catenary; for comparison two-sided,",
	"regularised, descent and relaxation, which may end with compressed elements or not at all.",
	NULL,
};

static const char *net_option(const struct cli_statics_kinds *kinds)
{
	return kinds->method ? "method" : kinds->equilibria ? "equilibria" : NULL;
}

static const char *ropeway_option(const struct cli_statics_kinds *kinds)
{
	return kinds->spans       ? "spans"
	       : kinds->worst     ? "worst"
	       : kinds->phases    ? "phases"
	       : kinds->load_case ? "case"
	       : kinds->sliding   ? "sliding"
	       : kinds->tolerate  ? "tolerate"
	                          : NULL;
}

static const char *rod_option(const struct cli_statics_kinds *kinds)
{
	return kinds->load_steps ? "load-steps" : kinds->vtk ? "vtk" : NULL;
}

const char *cli_statics_kinds_option(const struct cli_statics_kinds *kinds)
{
	struct cli_statics_kinds others = *kinds;
	const char *net = net_option(kinds);

	others.spans = 0;
	return net ? net : kinds->profile ? "profile"
	       : rod_option(kinds) ? rod_option(kinds) : ropeway_option(&others);
}

static enum hawser_status of_net(const struct cli_common *common, const struct cli_statics_kinds *kinds,
                                 const char *other, struct hawser_report *report)
{
	const char *ropeway = ropeway_option(kinds);

	if (other || ropeway)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "statics",
		                    "--%s is for %s, and this scene is a net", other ? other : ropeway,
		                    other ? "spans" : "ropeways");
	return kinds->equilibria ? cli_equilibria_net(common, kinds->equilibria, report)
	                         : cli_statics_net(common, kinds->method, kinds->profile, kinds->vtk,
	                                           report);
}

enum hawser_status cli_statics_kinds(int *done, const struct cli_common *common,
                                     const struct cli_statics_kinds *kinds, const char *span_option,
                                     int points, int cases, struct hawser_report *report)
{
	const char *net = net_option(kinds), *ropeway = ropeway_option(kinds), *rod = rod_option(kinds);
	const char *profile = kinds->profile ? "profile" : NULL;
	enum hawser_kind kind = cli_kind(common);

	*done = 1;
	if (kind == HAWSER_KIND_ROD) {
		const char *other = span_option ? span_option : cases ? "cases" : net ? net : profile;

		if (!other && !ropeway)
			return cli_statics_rod(common, kinds, report);
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "statics",
		                    "--%s does not go with a rod, whose options are --load-steps and --vtk",
		                    other ? other : ropeway);
	}
	if (rod && kind == HAWSER_KIND_NET && !kinds->load_steps)
		rod = NULL; /* --vtk is for nets, too */
	if (rod && (kind == HAWSER_KIND_OBSTACLES || kind == HAWSER_KIND_ROPEWAY ||
	            kind == HAWSER_KIND_NET))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "statics",
		                    "--%s is for rods, and %s is no scene of a rod", rod, common->input);
	if (kind == HAWSER_KIND_OBSTACLES)
		return cli_statics_obstacles(common, kinds, points, cases, span_option, report);
	if (kind == HAWSER_KIND_ROPEWAY) {
		if (!span_option && !net)
			return cli_statics_ropeway(common, kinds, cases, report);
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "statics",
		                    "--%s is for %s, and this scene is a ropeway",
		                    span_option ? span_option : net, span_option ? "spans" : "nets");
	}
	if (kind == HAWSER_KIND_NET)
		return of_net(common, kinds, cases && !span_option ? "cases" : span_option, report);
	*done = 0;
	if (net || kinds->profile)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "statics",
		                    "--%s is for nets%s, and %s is no scene of a net", net ? net : "profile",
		                    net ? "" : " and ropeways", common->input);
	if (rod)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "statics",
		                    "--%s is for rods, and %s is no scene of a rod", rod, common->input);
	if (ropeway)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "statics",
		                    "--%s is for ropeways, and %s is no scene of a ropeway", ropeway,
		                    common->input);
	return HAWSER_OK;
}
