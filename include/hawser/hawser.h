/* hawser/hawser.h - everything, in the order in which the data flows.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_HAWSER_H
#define HAWSER_HAWSER_H

#include <hawser/status.h>
#include <hawser/progress.h>
#include <hawser/scene.h>
#include <hawser/scene_family.h>
#include <hawser/statics.h>
#include <hawser/plausible.h>
#include <hawser/modes.h>
#include <hawser/gyroscopic.h>
#include <hawser/damped.h>
#include <hawser/irvine.h>
#include <hawser/beam.h>
#include <hawser/beam_motion.h>
#include <hawser/campbell.h>
#include <hawser/net.h>
#include <hawser/net_equilibria.h>
#include <hawser/net_modes.h>
#include <hawser/net_motion.h>
#include <hawser/net_plan.h>
#include <hawser/net_span.h>
#include <hawser/line.h>
#include <hawser/ropeway.h>
#include <hawser/line_modes.h>
#include <hawser/plugin.h>
#include <hawser/rom.h>
#include <hawser/choose.h>
#include <hawser/integrate.h>
#include <hawser/orbit.h>
#include <hawser/backbone.h>
#include <hawser/nnm.h>
#include <hawser/normal_form.h>
#include <hawser/basin.h>
#include <hawser/branches.h>
#include <hawser/cover.h>
#include <hawser/family.h>
#include <hawser/frf.h>
#include <hawser/scales.h>
#include <hawser/folds.h>
#include <hawser/linear.h>
#include <hawser/locus.h>
#include <hawser/lyapunov.h>
#include <hawser/study.h>
#include <hawser/span_motion.h>
#include <hawser/torus.h>
#include <hawser/primary.h>
#include <hawser/plan.h>
#include <hawser/accuracy.h>
#include <hawser/map.h>
#include <hawser/hill.h>
#include <hawser/identify.h>
#include <hawser/decay.h>
#include <hawser/sizes.h>

#endif
