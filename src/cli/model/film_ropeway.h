/* cli/model/film_ropeway.h - the ropes of a ropeway in a motion of its model, for orbit --animate.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_FILM_ROPEWAY_H
#define HAWSER_CLI_FILM_ROPEWAY_H

#include <hawser/line_modes.h>
#include <hawser/net_rom.h>

/* As `animate` of struct cli_maker. stride: coordinates of the model, of which the modes come first;
 * apart: distance in m at which the second lane is drawn beside the first one. */
enum hawser_status cli_film_ropeway(const char *path, const struct hawser_line_modes *modes,
                                    const struct hawser_net_rom_motion *motion, int stride,
                                    double apart, struct hawser_report *report) HAWSER_MUST_CHECK;

#endif
