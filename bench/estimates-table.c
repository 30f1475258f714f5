/* bench/estimates-table.c - the stated errors of each command, and the functions that compute the
 * true ones (estimates.h).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "bench/estimates.h"

const struct estimate estimates[] = {
	{"statics", "error", "catenary in quadruple precision", estimate_statics},
	{"modes", "residual", "shooting in quadruple precision", estimate_modes},
	{"campbell", "residual", "shooting in extended precision, complex frequency",
	 estimate_campbell},
	{"irvine", "residual", "shooting in quadruple precision, at the stations of a sweep",
	 estimate_irvine},
	{"frf", "error", "shooting to 1e-13, the nearest orbit of the branch", estimate_frf},
	{"events", "error", "the same event by shooting to 1e-12", estimate_events},
	{"landmarks", "uncertainty", "shooting to 1e-12, shorter steps", estimate_landmarks},
	{"accuracy", "estimated error", "full-order models, until they agree", estimate_accuracy},
	{"fixed", "error of the model", "full-order models, until they agree", estimate_fixed},
	{"spans", "both of these, with attachments, static loads, moving ends",
	 "full-order models, until they agree", estimate_spans},
	{"masses", "error of the model", "full-order models, until they agree", estimate_masses},
	{"springs", "error of the model", "full-order models, until they agree", estimate_springs},
	{"ends", "error of the model, ends that move", "full-order models, until they agree",
	 estimate_ends},
	{"integrate", "error", "extrapolation in extended precision", estimate_integrate},
	{"hill", "error", "monodromy matrix in extended precision; eight times the steps",
	 estimate_hill},
	{"map", "width", "the same, bisected to 1e-13", estimate_map},
	{"net", "error of tensions", "meshes of sixteen times as many elements", estimate_net},
	{"beam", "discretisation_error", "twice as many Legendre functions", estimate_beam},
};
const int estimates_count = (int)(sizeof estimates/sizeof *estimates);
