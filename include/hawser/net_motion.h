/* hawser/net_motion.h - motion of a net: time integration through slack and taut.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_NET_MOTION_H
#define HAWSER_NET_MOTION_H

#include <hawser/net.h>
#include <hawser/progress.h>
#include <hawser/status.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A scheme of time integration. */
struct hawser_net_scheme {
	const char *name, *summary, *source;
	int order;
};
const struct hawser_net_scheme *hawser_net_scheme(int index); /* NULL beyond the last */

#ifdef __cplusplus
}
#endif
#endif
