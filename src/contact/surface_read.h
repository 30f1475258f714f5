/* contact/surface_read.h - the section `obstacles` of a scene.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CONTACT_SURFACE_READ_H
#define HAWSER_CONTACT_SURFACE_READ_H

#include <hawser/surface.h>
#include "scene/tree.h"

/* *surface [*count] is allocated here; the caller frees it, on failure too. round: m, from a corner
 * of a profile that points upwards to where its circle begins, if there is as much room. */
enum hawser_status hawser__surfaces_read(struct hawser__reader *reader, struct hawser_surface **surface,
                                         int *count, const struct hawser__tree *tree, double round)
	HAWSER_MUST_CHECK;

#endif
