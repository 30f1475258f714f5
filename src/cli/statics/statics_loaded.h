/* cli/statics/statics_loaded.h - what hawser statics shows of a loaded span, and the points of
 * its profile. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_STATICS_LOADED_H
#define HAWSER_CLI_STATICS_LOADED_H

#include "cli/frame/view.h"

struct cli_loaded {
	int present; /* 0: the scene has neither static load nor change of temperature */
	enum hawser_state state;
	struct hawser_statics reference;
	double swing, sag_vertical, blowout; /* rad, m, m */
	double force[3];                     /* N/m, along x, y, z */
	double pull[2][3];                   /* N, on supports A and B, along x, y, z */
	int elastic;                         /* 1: the supports are */
	double moved[2][3], imbalance;       /* m, N: of struct hawser_statics */
};
extern const struct hawser__field cli_loaded_field[];
extern const struct hawser__field cli_statics_field[]; /* of a struct hawser_statics */
void cli_loaded_comments(struct hawser__table *table, const struct cli_loaded *loaded);
/* Where the ends on springs are, in the state or case `name`. */
void cli_moved_comment(struct hawser__table *table, const char *name, const struct cli_loaded *loaded);

/* From the state of the scene, at rest or travelling (with the apparent quantities). */
enum hawser_status cli_loaded_fill(struct cli_loaded *loaded, const struct hawser_statics *statics,
                                   const struct hawser_scene *scene, struct hawser_report *report)
	HAWSER_MUST_CHECK;

/* A point of the profile along the axes of the scene. */
struct hawser__spot cli_place(const struct hawser_statics *st,
                              const struct hawser_profile_point *in);

/* An attachment: at a mass the tension has two values. */
struct cli_mark {
	const char *name;
	double mass, kink; /* kg; rad, angle between the tangents on both sides */
	struct hawser__spot before, after;
};
extern const struct hawser__field cli_mark_field[];
/* Fills mark[attachments] and returns their number. */
int cli_marks_fill(struct cli_mark *mark, const struct hawser_statics *st,
                   const struct hawser_scene *scene);
void cli_marks_comments(struct hawser__table *table, const struct cli_mark *mark, int marks);

/* A row of --cases: the reference state, and each case. */
struct cli_case {
	const char *name, *why;
	int status; /* 0, or why it has no solution */
	struct hawser_report report;
	double H, T0, T1, sag, length0, length;
	struct cli_loaded loaded;
};
struct cli_cases {
	struct cli_case *row; /* [rows], the caller frees it */
	int rows;
};
extern const struct hawser__field cli_case_field[], cli_cases_member[];
/* HAWSER_ERR_ARGUMENT if the scene has no cases; the status of the first one if none has a solution. */
enum hawser_status cli_cases_fill(struct cli_cases *cases, const struct hawser_scene *scene,
                                  struct hawser_report *report) HAWSER_MUST_CHECK;
/* axis: of tensions. */
enum hawser_status cli_cases_draw(const char *path, const struct cli_cases *cases,
                                  const struct hawser__axis *axis, struct hawser_report *report)
	HAWSER_MUST_CHECK;
void cli_cases_rows(struct hawser__table *table, const struct cli_cases *cases);

#endif
