/* contact/surface_read.h - the section `obstacles` of a scene.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CONTACT_SURFACE_READ_H
#define HAWSER_CONTACT_SURFACE_READ_H

#include <hawser/surface.h>
#include "scene/tree.h"

/* *surface [*count] is allocated here; the caller frees it and their heights, on failure too. round: m,
 * from a line of a bed to where its rounding begins, if there is as much room. */
enum hawser_status hawser__surfaces_read(struct hawser__reader *reader, struct hawser_surface **surface,
                                         int *count, const struct hawser__tree *tree, double round)
	HAWSER_MUST_CHECK;

#endif
