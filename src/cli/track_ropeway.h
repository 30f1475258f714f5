/* cli/track_ropeway.h - frequencies of a ropeway along a sweep: modes --over, campbell, irvine.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_TRACK_ROPEWAY_H
#define HAWSER_CLI_TRACK_ROPEWAY_H

#include "cli/modes_ropeway.h"

enum cli_swept {
	CLI_SWEPT_SPEED,   /* campbell */
	CLI_SWEPT_TENSION, /* irvine: what the scene gives in bottom.tension */
	CLI_SWEPT_KEY      /* modes --over */
};

struct cli_track {
	const struct cli_common *common;
	const char *command;
	enum cli_swept swept;
	const char *from, *to;      /* NULL: the default */
	int points, n;              /* 0: the default */
	const char *over;           /* KEY=FROM:TO:POINTS */
	int logarithmic;
	const char *unit;           /* "rad/s", "Hz" or NULL: Hz */
	const char *spacing;        /* of campbell: NULL: of the scene */
	int harmonics;
	struct cli_ropeway_choice choice;
	/* set by cli_track_run */
	struct hawser_ropeway ropeway; /* of the scene as it is */
	struct hawser_ropeway_track track;
	int load_case, hertz;
	char key[96], si[32];       /* of what is swept: a name, and its unit in the table */
	double *value;              /* [points] */
	char (*name)[CLI_MODES_SPAN]; /* [lanes*(towers + 1)] of the spans: "p0 to p1" */
	double distance;            /* m, between carriers; 0: none */
};
enum hawser_status cli_track_run(struct cli_track *track,
                                 struct hawser_report *report) HAWSER_MUST_CHECK;

extern const struct hawser__field cli_track_field[], cli_track_member[];

#endif
