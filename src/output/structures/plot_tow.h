/* output/structures/plot_tow.h - the steady state of a towed body: its shape in two views, and
 * the tension. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_OUTPUT_PLOT_TOW_H
#define HAWSER_OUTPUT_PLOT_TOW_H

#include "output/output.h"

enum hawser_status hawser__plot_tow(const char *path, const struct hawser_tow *tow,
                                    const struct hawser_tow_steady *steady,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;

#endif
