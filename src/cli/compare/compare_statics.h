/* cli/compare/compare_statics.h - the result of hawser compare statics.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_COMPARE_STATICS_H
#define HAWSER_CLI_COMPARE_STATICS_H

#include "cli/frame/view.h"

struct cli_compare_statics {
	const struct cli_common *common;
	double tolerance;                 /* of the methods */
	int nets;                         /* read from scenes; 0: random cables */
	struct hawser_net *net;           /* [nets] */
	double *reading;                  /* [nets] s, processor time of reading the scene */
	struct hawser_net_comparison of;
	double *sorted[2];                /* [of.ways][of.nets] profiles by time and by iterations */
};
/* The tables: of methods, of the performance profiles, and of each method on each net. */
extern const struct hawser__list cli_compare_statics_methods, cli_compare_statics_profile,
                                 cli_compare_statics_each;
extern const struct hawser__field cli_compare_statics_field[];
/* Bit of the view's options: JSON has the list of nets. */
enum { CLI_COMPARE_STATICS_EACH = 1 };

#endif
