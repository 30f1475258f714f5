/* cli/statics/statics_kinds.h - what hawser statics does with each kind of scenes.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_STATICS_KINDS_H
#define HAWSER_CLI_STATICS_KINDS_H

#include "cli/frame/kinds.h"
#include "cli/frame/view.h"

/* The first member of the command's settings: what other kinds than spans have of them. */
struct cli_statics_kinds {
	struct cli_common common;
	int points;                       /* of a profile: spans and obstacles */
	int cases;                        /* spans and ropeways */
	const char *method;               /* nets */
	int equilibria;                   /* nets */
	int profile;                      /* nets and ropeways */
	const char *load_case, *sliding;  /* ropeways */
	int spans, worst, phases, tolerate; /* ropeways */
	const char *vtk;                  /* rods and nets */
	const char *stiffness, *about;    /* nets */
	int load_steps;                   /* rods */
};
/* Their rows in the command's table; its `struct settings` has them as the member `kinds`. */
#define CLI_STATICS_KINDS_OPTIONS \
	{"method", 0, "NAME", "nets: how to find the equilibrium (automatic)", \
	 CLI_TEXT_FOR(kinds.method, CLI_NET)}, \
	{"profile", 0, "", "nets and ropeways: table of points along the cables", \
	 CLI_FLAG_FOR(kinds.profile, CLI_NET | CLI_ROPEWAY), .excludes = "cases"}, \
	{"equilibria", 0, "N", "nets: all equilibria of bars instead of cables, from N random starts", \
	 CLI_COUNT_FOR(kinds.equilibria, CLI_NET)}, \
	{"stiffness", 0, "NODES", "nets: table of the stiffness at nodes that move together, as one body", \
	 CLI_TEXT_FOR(kinds.stiffness, CLI_NET), .excludes = "profile, equilibria"}, \
	{"about", 0, "X,Y,Z", "nets: with turns about axes through this place", \
	 CLI_TEXT_FOR(kinds.about, CLI_NET), .needs = "stiffness"}, \
	{"spans", 0, "", "ropeways, obstacles: table of the spans", \
	 CLI_FLAG_FOR(kinds.spans, CLI_ROPEWAY | CLI_OBSTACLES), .excludes = "worst, profile, cases"}, \
	{"worst", 0, "", "ropeways: table of the worst values over the phases", \
	 CLI_FLAG_FOR(kinds.worst, CLI_ROPEWAY), .excludes = "profile, cases"}, \
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

/* Tables of the kinds, for their records (cli/frame/kinds.h). */
extern const struct cli_listing cli_statics_net_listing[], cli_obstacles_listing[],
                                cli_ropeway_listing[], cli_rod_listing[];

#endif
