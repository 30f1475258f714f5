/* cli/model/lane.h - which model is made of which lane of a ropeway: options of commands that
 * take models. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_LANE_H
#define HAWSER_CLI_LANE_H

/* How a model is made of a ropeway; NULL or 0: not given. */
struct cli_lane_choice {
	const char *load, *carriers, *lane, *contact, *load_case, *keep;
	double ripple, damping; /* m, ratio */
};

/* The options. Those that have a --load of their own take the second list alone. */
#define CLI_LANE_LOAD_OPTION \
	CLI_HEADING("Ropeways"), \
	{"load", 0, "NAME", "ropeways: passing (carriers), or drive (passing)", \
	 CLI_TEXT_FOR(common.lane.load, CLI_ROPEWAY)}
#define CLI_LANE_KEEP_OPTION \
	{"keep", 0, "LIST", "ropeways, nets: modes that are kept, such as 1,4,6 (the lowest)", \
	 CLI_TEXT_FOR(common.lane.keep, CLI_ROPEWAY | CLI_NET)}
#define CLI_LANE_OPTIONS \
	CLI_LANE_KEEP_OPTION, \
	CLI_LANE_FORM_OPTIONS
/* Without the modes that are kept; and without damping too, for commands with another --damping. */
#define CLI_LANE_FORM_OPTIONS \
	{"damping", 0, "RATIO", "ropeways: damping ratio of each mode (0)", \
	 CLI_POSITIVE_FOR(common.lane.damping, CLI_ROPEWAY)}, \
	CLI_LANE_UNDAMPED_OPTIONS
#define CLI_LANE_UNDAMPED_OPTIONS \
	{"ripple", 0, "LENGTH", "ropeways: amplitude of the rope at the drive, m", \
	 CLI_POSITIVE_FOR(common.lane.ripple, CLI_ROPEWAY)}, \
	{"carriers", 0, "HOW", "ropeways: fixed at the phase, smeared over the rope, or swinging (fixed)", \
	 CLI_TEXT_FOR(common.lane.carriers, CLI_ROPEWAY)}, \
	{"lane", 0, "NAME", "ropeways: up, down or both (both)", \
	 CLI_TEXT_FOR(common.lane.lane, CLI_ROPEWAY)}, \
	{"contact", 0, "HOW", "ropeways: slip or stick (the scene's contact.modes, or slip)", \
	 CLI_TEXT_FOR(common.lane.contact, CLI_ROPEWAY)}, \
	{"case", 0, "NAME", "ropeways: the load case (full)", \
	 CLI_TEXT_FOR(common.lane.load_case, CLI_ROPEWAY)}

#endif
