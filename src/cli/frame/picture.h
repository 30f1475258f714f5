/* cli/frame/picture.h - options about the picture of a command.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_PICTURE_H
#define HAWSER_CLI_PICTURE_H

#include "cli/frame/cli.h"

/* A title and "WxH" into a struct hawser__picture_choice, "A:B" into one of its ranges. */
enum hawser_status cli_store_title(void *field, const struct cli_option *option,
                                   const char *const *values, struct hawser_report *report);
enum hawser_status cli_store_size(void *field, const struct cli_option *option,
                                  const char *const *values, struct hawser_report *report);
enum hawser_status cli_store_range(void *field, const struct cli_option *option,
                                   const char *const *values, struct hawser_report *report);

/* Hand the choice to the pictures. Fails if there is a choice and no picture. --gp alone is --plot of
 * this file. */
enum hawser_status cli_picture_choose(struct cli_common *common,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;

#endif
