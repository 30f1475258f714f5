/* cli/statics/statics_kinds.h - hawser statics of scenes of other kinds than spans.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_STATICS_KINDS_H
#define HAWSER_CLI_STATICS_KINDS_H

#include "cli/frame/view.h"

/* Options that spans do not have. */
struct cli_statics_kinds {
	const char *method;               /* nets */
	int equilibria;                   /* nets */
	int profile;                      /* nets and ropeways */
	const char *load_case, *sliding;  /* ropeways */
	int spans, worst, phases, tolerate; /* ropeways */
	const char *vtk;                  /* rods and nets */
	int load_steps;                   /* rods */
};
/* Lines of the command's --help. */
extern const char *const cli_statics_notes[];
/* Their rows in the command's table; its `struct settings` has them as the member `kinds`. */
#define CLI_STATICS_KINDS_OPTIONS \
	{"method", 0, "NAME", "nets: how to find the equilibrium (automatic)", \
	 CLI_TEXT_FOR(kinds.method, CLI_NET)}, \
	{"profile", 0, "", "nets and ropeways: table of points along the cables", \
	 CLI_FLAG_FOR(kinds.profile, CLI_NET | CLI_ROPEWAY)}, \
	{"equilibria", 0, "N", "nets: all equilibria of bars instead of cables, from N random starts", \
	 CLI_COUNT_FOR(kinds.equilibria, CLI_NET)}, \
	{"spans", 0, "", "ropeways, obstacles: table of the spans", \
	 CLI_FLAG_FOR(kinds.spans, CLI_ROPEWAY | CLI_OBSTACLES)}, \
	{"worst", 0, "", "ropeways: table of the worst values over the phases", \
	 CLI_FLAG_FOR(kinds.worst, CLI_ROPEWAY)}, \
	{"phases", 0, "N", "ropeways: number of phases of the carriers (200)", \
	 CLI_COUNT_FOR(kinds.phases, CLI_ROPEWAY)}, \
	{"case", 0, "NAME", "ropeways: the load case (full)", CLI_TEXT_FOR(kinds.load_case, CLI_ROPEWAY)}, \
	{"sliding", 0, "HOW", "ropeways: running, rest or reverse (the scene's ropeway.sliding)", \
	 CLI_TEXT_FOR(kinds.sliding, CLI_ROPEWAY)}, \
	{"tolerate", 0, "", "ropeways: report what lifts, slips or is at its stop, and refuse nothing", \
	 CLI_FLAG_FOR(kinds.tolerate, CLI_ROPEWAY)}, \
	{"load-steps", 0, "N", "rods: equal steps in which the load is raised (1)", \
	 CLI_COUNT_FOR(kinds.load_steps, CLI_ROD)}, \
	{"vtk", 0, "FILE", "rods and nets: write the shape to FILE.vtk, for programs such as ParaView", \
	 CLI_TEXT_FOR(kinds.vtk, CLI_MESHES)}

/* *done is 0 if the scene is a span without obstacles. points: of a profile; cases: whether --cases is
 * given. */
enum hawser_status cli_statics_kinds(int *done, const struct cli_common *common,
                                     const struct cli_statics_kinds *kinds, int points, int cases,
                                     struct hawser_report *report) HAWSER_MUST_CHECK;

/* statics_ropeway.c */
enum hawser_status cli_statics_ropeway(const struct cli_common *common,
                                       const struct cli_statics_kinds *kinds, int cases,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;
extern const struct hawser__field cli_ropeway_tower_field[], cli_ropeway_span_field[],
                                  cli_ropeway_worst_field[], cli_ropeway_case_field[],
                                  cli_ropeway_point_field[], cli_ropeway_field[];
/* rod_fields.c */
extern const struct hawser__field cli_rod_point_field[], cli_rod_field[], cli_net_member_field[],
                                  cli_net_point_field[], cli_statics_net_field[],
                                  cli_equilibria_net_field[], cli_equilibria_net_member[];

#endif
