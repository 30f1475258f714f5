/* cli/statics_kinds.h - hawser statics of scenes of other kinds than spans.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_STATICS_KINDS_H
#define HAWSER_CLI_STATICS_KINDS_H

#include "cli/view.h"

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
	 CLI_TEXT(kinds.method)}, \
	{"profile", 0, "", "nets and ropeways: table of points along the cables", \
	 CLI_FLAG(kinds.profile)}, \
	{"equilibria", 0, "N", "nets: all equilibria of bars instead of cables, from N random starts", \
	 CLI_COUNT(kinds.equilibria)}, \
	{"spans", 0, "", "ropeways, obstacles: table of the spans", CLI_FLAG(kinds.spans)}, \
	{"worst", 0, "", "ropeways: table of the worst values over the phases", \
	 CLI_FLAG(kinds.worst)}, \
	{"phases", 0, "N", "ropeways: number of phases of the carriers (200)", \
	 CLI_COUNT(kinds.phases)}, \
	{"case", 0, "NAME", "ropeways: the load case (full)", CLI_TEXT(kinds.load_case)}, \
	{"sliding", 0, "HOW", "ropeways: running, rest or reverse (the scene's ropeway.sliding)", \
	 CLI_TEXT(kinds.sliding)}, \
	{"tolerate", 0, "", "ropeways: report what lifts, slips or is at its stop, and refuse nothing", \
	 CLI_FLAG(kinds.tolerate)}, \
	{"load-steps", 0, "N", "rods: equal steps in which the load is raised (1)", \
	 CLI_COUNT(kinds.load_steps)}, \
	{"vtk", 0, "FILE", "rods and nets: write the shape to FILE.vtk, for programs such as ParaView", \
	 CLI_TEXT(kinds.vtk)}

/* *done is 0 if the scene is a span without obstacles. span_option: the name of an option for spans
 * that is given, or NULL; points: of a profile; cases: whether --cases is given. */
enum hawser_status cli_statics_kinds(int *done, const struct cli_common *common,
                                     const struct cli_statics_kinds *kinds, const char *span_option,
                                     int points, int cases,
                                     struct hawser_report *report) HAWSER_MUST_CHECK;

/* The first option that is given but not one of spans over obstacles, or NULL. */
const char *cli_statics_kinds_option(const struct cli_statics_kinds *kinds);

/* statics_ropeway.c */
enum hawser_status cli_statics_ropeway(const struct cli_common *common,
                                       const struct cli_statics_kinds *kinds, int cases,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;
extern const struct hawser__field cli_ropeway_tower_field[], cli_ropeway_span_field[],
                                  cli_ropeway_worst_field[], cli_ropeway_case_field[],
                                  cli_ropeway_point_field[], cli_ropeway_field[];
/* rod_fields.c */
extern const struct hawser__field cli_rod_point_field[], cli_rod_field[];

#endif
