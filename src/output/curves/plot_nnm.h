/* output/curves/plot_nnm.h - the picture of nonlinear normal modes: frequency over energy.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_OUTPUT_PLOT_NNM_H
#define HAWSER_OUTPUT_PLOT_NNM_H

#include <hawser/nnm.h>

#include "output/output.h"

struct hawser__nnm_picture {
	const struct hawser_nnm *nnm;
	struct hawser__axis axis[2]; /* energy, frequency */
	double per[2];               /* shown unit per unit of the model */
};
enum hawser_status hawser__plot_nnm(const char *path, const struct hawser__nnm_picture *of,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;

#endif
