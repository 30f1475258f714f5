/* output/structures/plot_transient.h - a ropeway in motion over time, and a carrier that passes
 * a battery. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_OUTPUT_PLOT_TRANSIENT_H
#define HAWSER_OUTPUT_PLOT_TRANSIENT_H

#include <hawser/transient.h>

#include "output/output.h"

enum hawser_status hawser__plot_transient(const char *path, const struct hawser_ropeway *ropeway,
                                          const struct hawser_transient *run,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;
enum hawser_status hawser__plot_carrier_passing(const char *path, const struct hawser_passing *passing,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;

#endif
