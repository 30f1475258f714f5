/* statics/profile.h - inside the statics stage: the check of a solved span.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STATICS_PROFILE_H
#define HAWSER_STATICS_PROFILE_H

#include <hawser/statics.h>

/* Distance, m, by which B (2.87) misses end B with the eta, l, epsilon and delta in *st. */
double hawser__statics_closure(const struct hawser_statics *st);

#endif
