/* cli/modes/track_ropeway.h - frequencies of a ropeway, or of a span over obstacles, along a sweep:
 * modes
 * --over, campbell, irvine.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_TRACK_ROPEWAY_H
#define HAWSER_CLI_TRACK_ROPEWAY_H

#include <hawser/campbell.h>

#include "cli/model/key_sweep.h"
#include "cli/modes/modes_ropeway.h"

enum cli_swept {
	CLI_SWEPT_SPEED,   /* campbell */
	CLI_SWEPT_TENSION, /* irvine: what the scene gives in bottom.tension */
	CLI_SWEPT_KEY      /* modes --over */
};

struct cli_track {
	const struct cli_common *common;
	const char *command;
	enum cli_swept swept;
	int obstacles;              /* 1: the scene is a span over obstacles; swept is CLI_SWEPT_KEY */
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
	struct hawser_obstacles span;  /* or this one */
	struct hawser_ropeway_track track;
	int load_case, hertz;
	struct cli_key_sweep sweep; /* of what is swept: a name, its unit in the table, the values */
	char (*name)[CLI_MODES_SPAN]; /* [lanes*(towers + 1)] of the spans: "p0 to p1" */
	struct hawser_campbell_resonance *resonance; /* [resonances] with the passing of carriers */
	int resonances;
	double distance;            /* m, between carriers; 0: none */
};
enum hawser_status cli_track_run(struct cli_track *track,
                                 struct hawser_report *report) HAWSER_MUST_CHECK;

/* track_fields.c */
unsigned cli_track_view(const struct cli_track *track);
extern const struct hawser__field cli_track_field[], cli_track_member[];
extern const struct hawser__list cli_track_rows;
enum hawser_status cli_track_name_spans(struct cli_track *track,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;

#endif
