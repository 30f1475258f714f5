/* cli/motion/integrate_span.h - hawser integrate --model fe: the motion of a span by its mesh.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_INTEGRATE_SPAN_H
#define HAWSER_CLI_INTEGRATE_SPAN_H

#include "cli/frame/cli.h"
#include "cli/frame/view.h"

/* --- span_run.c: frequency and times of a motion of a span's mesh, from options --- */

/* Texts of options; NULL if not given. */
struct cli_span_texts {
	const char *omega, *until, *every, *after, *step;
};
/* In SI. Without load and moving ends Omega is 0, and the period is that of the first mode. */
struct cli_span_run {
	struct cli_model model; /* scene, statics and natural frequencies */
	double Omega, period, until, every, after, step;
	char warning[CLI_WARNING_SIZE]; /* the ends already move when it begins; "": they do not */
};
/* Reads the scene; `command` is for messages. Release by cli_model_clear(&run->model). */
enum hawser_status cli_span_run(struct cli_span_run *run, const struct cli_common *common,
                                const struct cli_span_texts *texts, const char *command,
                                struct hawser_report *report) HAWSER_MUST_CHECK;
/* 1 if the scene has a varying load or a moving end. */
int cli_driven(const struct hawser_scene *scene);

struct cli_integrate_span {
	struct cli_span_texts texts;
	const char *scheme; /* NULL: the first */
	double tolerance;   /* of --step auto; 0: the library's */
	int elements;       /* 0: the library's */
};
enum hawser_status cli_integrate_span(const struct cli_common *common,
                                      const struct cli_integrate_span *settings,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
extern const struct hawser__field cli_span_history_field[], cli_span_field[];

#endif
