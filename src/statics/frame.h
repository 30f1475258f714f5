/* statics/frame.h - vectors in the local frame of a point and in the axes of the cable.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STATICS_FRAME_H
#define HAWSER_STATICS_FRAME_H

#include <hawser/statics.h>

/* v [3] along the axes of the cable, of local [3] along e, n and the normal of the plane. */
static inline void hawser__frame_out(double v[3], const struct hawser_frame_point *at,
                                     const double local[3])
{
	for (int c = 0; c < 3; c++)
		v[c] = local[0]*at->axis[0][c] + local[1]*at->axis[1][c] + local[2]*at->axis[2][c];
}

/* And back. */
static inline void hawser__frame_in(double local[3], const struct hawser_frame_point *at,
                                    const double v[3])
{
	for (int k = 0; k < 3; k++)
		local[k] = v[0]*at->axis[k][0] + v[1]*at->axis[k][1] + v[2]*at->axis[k][2];
}

#endif
