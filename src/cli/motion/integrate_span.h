/* cli/motion/integrate_span.h - hawser integrate --model fe: the motion of a span by its mesh.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_INTEGRATE_SPAN_H
#define HAWSER_CLI_INTEGRATE_SPAN_H

#include "cli/motion/span_run.h"
#include "cli/frame/view.h"

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
