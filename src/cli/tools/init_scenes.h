/* cli/tools/init_scenes.h - the scenes that hawser init writes.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_INIT_SCENES_H
#define HAWSER_CLI_INIT_SCENES_H

extern const char cli_init_cable[], cli_init_travelling[], cli_init_beam[], cli_init_net[],
                  cli_init_obstacles[], cli_init_ropeway[], cli_init_rod[], cli_init_tow[];

/* Structures by the names of their field. */
#define CLI_INIT_STRUCTURES(X) X(stay) X(conductor) X(chairlift) X(footbridge) X(mooring) X(model)
#define CLI_INIT_DECLARE(name) extern const char cli_init_##name[];
CLI_INIT_STRUCTURES(CLI_INIT_DECLARE)
#undef CLI_INIT_DECLARE

#endif
