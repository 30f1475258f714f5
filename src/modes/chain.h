/* modes/chain.h - point masses joined by springs.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_MODES_CHAIN_H
#define HAWSER_MODES_CHAIN_H

#include <hawser/modes.h>

enum hawser_status hawser__chain_solve(struct hawser_modes *modes,
                                       const struct hawser_statics *statics,
                                       const struct hawser_modes_options *options,
                                       struct hawser_report *report);

#endif
