/* net/statics/elimination.h - the order in which the unknowns of a mesh are eliminated.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_NET_ELIMINATION_H
#define HAWSER_NET_ELIMINATION_H

#include <suitesparse/cholmod.h>

#include "net/net.h"

/* permutation [unknowns]: few entries in the factors. 0 if there is not enough memory. */
int hawser__elimination(int *permutation, const struct hawser__mesh *mesh, cholmod_common *common);

#endif
