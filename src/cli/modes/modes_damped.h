/* cli/modes/modes_damped.h - damped modes of one span, or over a key of its scene.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_MODES_DAMPED_H
#define HAWSER_CLI_MODES_DAMPED_H

#include <hawser/net.h>

#include "cli/frame/view.h"
#include "cli/model/key_sweep.h"

/* Where the least damped of modes 1 to `modes` of a plane is damped most. */
struct cli_damped_best {
	double value, ratio; /* of the key, in SI; of critical */
	int plane, modes;
	int number;          /* the least damped mode */
	int end;             /* 1: the value is an end of the range */
};

struct cli_damped_result {
	const struct cli_common *common;
	struct hawser_scene scene; /* or, of a net: */
	struct hawser_net net;     /* as it was read; cables 0: none */
	struct hawser_damped_sweep sweep; /* without key: one point */
	const char *key; /* NULL: none */
	struct cli_damped_best best[2]; /* [bests] */
	int bests, n;
	int wind;                  /* 1: the scene has one */
	struct cli_key_sweep range; /* its values, in SI; .logarithmic: of --log */
};
/* `over`: as key_sweep.h says, or NULL. The scene, or the net, is loaded. */
enum hawser_status cli_damped_solve(struct cli_damped_result *result, const char *over, int n,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;
void cli_damped_free(struct cli_damped_result *result);
extern const struct cli_showing cli_damped_showing;
extern const struct hawser__field cli_damped_field[], cli_damped_member[];

#endif
