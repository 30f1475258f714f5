/* core/paths.h - the order of nodes along the paths of a graph whose parts are paths.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CORE_PATHS_H
#define HAWSER_CORE_PATHS_H

/* node [nodes]: the nodes in their order along the paths; link [nodes]: the link from this place to the
 * next, -1 where a path ends. touch [nodes][2] is work space. Returns 0 if a node has more than two
 * links, or a part is a ring. */
int hawser__paths(int *node, int *link, int (*touch)[2], int nodes, const int (*end)[2] /* [links] */,
                  int links);

#endif
