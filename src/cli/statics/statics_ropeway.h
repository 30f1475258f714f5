/* cli/statics/statics_ropeway.h - what hawser statics shows of a ropeway.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_STATICS_ROPEWAY_H
#define HAWSER_CLI_STATICS_ROPEWAY_H

#include "cli/statics/statics_kinds.h"

enum { CLI_ROPEWAY_SPAN = 2*HAWSER_ROPEWAY_NAME + 4 };

/* A tower on one lane. */
struct cli_ropeway_tower {
	const char *lane, *name, *battery;
	struct hawser_ropeway_contact c;
	const struct hawser_ropeway_tower_range *range; /* or NULL */
};
struct cli_ropeway_span {
	const char *lane;
	char name[CLI_ROPEWAY_SPAN]; /* "p0 to p1" */
	const char *label;           /* the same */
	struct hawser_ropeway_span s;
	const struct hawser_ropeway_span_range *range; /* or NULL */
};
struct cli_ropeway_point {
	const char *lane;
	double S, x, y, angle, T;
};
/* The ranges of a tower, for the table. */
struct cli_ropeway_worst {
	const char *lane, *name;
	struct hawser_ropeway_tower_range r;
};
struct cli_ropeway_case {
	const char *name, *why;
	int status;
	struct hawser_report report;
	int phases, lifts, slips, stops, failed;
	struct hawser_ropeway_range T, travel, force, needed_friction;
	const char *T_lane, *press_lane, *press_tower;
	char T_span[CLI_ROPEWAY_SPAN], sag_span[CLI_ROPEWAY_SPAN];
	const char *T_where, *sag_where;
	double pressing, pressing_at, sag, sag_at;
};

struct cli_ropeway_lane {
	const struct hawser_ropeway_lane *lane; /* NULL: down is off */
	const struct hawser_ropeway_lane_range *range; /* or NULL */
	struct cli_ropeway_tower *tower; /* [towers] */
	struct cli_ropeway_span *span;   /* [spans] */
	int towers, spans;
};

struct cli_ropeway {
	const struct cli_common *common;
	const struct cli_statics_kinds *kinds;
	struct hawser_ropeway ropeway;
	struct hawser_ropeway_options options;
	struct hawser_ropeway_statics st;
	struct hawser_ropeway_worst worst;
	int swept;                       /* 1: `worst` is filled in */
	struct cli_ropeway_lane lane[HAWSER_ROPEWAY_LANES];
	struct cli_ropeway_tower *tower; /* [towers] of both lanes */
	struct cli_ropeway_span *span;   /* [spans] */
	struct cli_ropeway_point *point; /* [points] */
	struct cli_ropeway_worst *range; /* [towers], if swept */
	struct cli_ropeway_case *load_case; /* [cases] */
	int towers, spans, points, cases;
};

/* ropeway_fill.c: rows from the state and from the worst values. */
enum hawser_status cli_ropeway_fill(struct cli_ropeway *of,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;
enum hawser_status cli_ropeway_points(struct cli_ropeway *of,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
enum hawser_status cli_ropeway_cases(struct cli_ropeway *of,
                                     struct hawser_report *report) HAWSER_MUST_CHECK;
void cli_ropeway_clear(struct cli_ropeway *of);
/* ropeway_fields.c */
extern const struct hawser__field cli_ropeway_field[], cli_ropeway_case_field[];
extern const struct hawser__list cli_ropeway_tower_list, cli_ropeway_span_list, cli_ropeway_worst_list,
                                 cli_ropeway_case_list, cli_ropeway_point_list;
enum { CLI_ROPEWAY_SWEPT = 1, CLI_ROPEWAY_PROFILE = 2, CLI_ROPEWAY_CASES = 4 }; /* bits of the view */

#endif
