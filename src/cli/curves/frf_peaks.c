/* cli/curves/frf_peaks.c - the peaks of a frequency response: location and report.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/frame/view.h"

enum { name_size = 80 };

static int tells_tension(const struct hawser_landmark *peak)
{
	return peak->kind == HAWSER_LANDMARK_TENSION || peak->kind == HAWSER_LANDMARK_LEAST_TENSION;
}

/* "z", "T_max", "u_3" */
static void component(char *text, size_t size, const struct hawser_landmark *peak)
{
	if (tells_tension(peak))
		snprintf(text, size, "%s",
		         peak->kind == HAWSER_LANDMARK_TENSION ? "T_max" : "T_min");
	else if (peak->probe < 0)
		snprintf(text, size, "u_%d", peak->axis + 1);
	else
		snprintf(text, size, "%c", "xyz"[peak->axis]);
}

static double tension_of(const struct hawser_landmark *peak)
{
	return peak->kind == HAWSER_LANDMARK_TENSION ? peak->rest + peak->size
	                                             : peak->rest - peak->size;
}

/* In SI if the model has units. */
static double size_of(const struct cli_frf_result *result, const struct hawser_landmark *peak)
{
	return tells_tension(peak) ? tension_of(peak) : peak->size*cli_per_length(result->model);
}

static const char *unit_of(const struct cli_frf_result *result, const struct hawser_landmark *peak)
{
	return tells_tension(peak) ? " N" : cli_unit(result->model, " m");
}

void cli_frf_peak_comments(struct hawser__table *table, const struct cli_frf_result *result)
{
	for (int k = 0; k < result->peaks; k++) {
		const struct hawser_landmark *peak = &result->peak[k];
		char name[name_size], of[24] = "";

		component(name, sizeof name, peak);
		if (result->frf->branch > 1)
			snprintf(of, sizeof of, "branch %d ", result->frf->branch);
		hawser__table_comment(table, "%speak: %s%s%s = %.9g%s at Omega = %.12g%s%s (relative errors "
		                      "%.1e, %.1e)", of, name, peak->probe < 0 ? "" : "_",
		                      peak->probe < 0 ? "" : result->model->rom.shapes.name[peak->probe],
		                      size_of(result, peak), unit_of(result, peak),
		                      peak->omega*cli_per_omega(result->model),
		                      cli_unit(result->model, " rad/s"),
		                      peak->stable ? "" : ", unstable", peak->size_error,
		                      peak->omega_error);
	}
}

/* --- fields --- */

struct peak {
	const char *probe;
	char component[name_size];
	const char *kind; /* of the component, without a number */
	double coordinate, at_rest;
	struct hawser_landmark of;
	double tension, amplitude; /* one of them is NAN */
};

static const char *kind_of(const struct hawser_landmark *peak)
{
	static const char *const axes[] = {"x", "y", "z"};

	if (tells_tension(peak))
		return peak->kind == HAWSER_LANDMARK_TENSION ? "T_max" : "T_min";
	return peak->probe < 0 ? "u" : axes[peak->axis];
}

static const void *peak_row(void *to, const void *parent, size_t k)
{
	const struct cli_frf_result *result = parent;
	const struct hawser_landmark *of = &result->peak[k];
	struct peak *peak = to;
	int tension = tells_tension(of);

	*peak = (struct peak){
		.probe = of->probe < 0 ? NULL : result->model->rom.shapes.name[of->probe], .of = *of,
		.at_rest = tension ? of->rest : NAN, .tension = tension ? tension_of(of) : NAN,
		.amplitude = tension ? NAN : of->size, .kind = kind_of(of),
		.coordinate = of->probe < 0 && !tension ? of->axis + 1 : (double)NAN};
	component(peak->component, sizeof peak->component, of);
	return to;
}

#define OF(member) HAWSER__AT(struct peak, member)
static const struct hawser__field peak_field[] = {
	{"probe", NULL, "where; null for tensions, and where a model has no probes", OF(probe),
	 .flags = HAWSER__NULL},
	{"component", NULL, "x, y or z; T_max, the largest tension; T_min, of which minima are listed; "
	 "u_1 and so on of a model without probes", OF(component)},
	{"Omega", NULL, "where it is", OF(of.omega), .unit = HAWSER__RAD_S},
	{"size", NULL, "amplitude", OF(amplitude), .unit = HAWSER__M, .flags = HAWSER__OMIT},
	{"size", NULL, "of a tension: the tension", OF(tension), .unit = HAWSER__NEWTON,
	 .flags = HAWSER__OMIT},
	{"Omega_error", NULL, "estimated error of Omega, relative", OF(of.omega_error)},
	{"size_error", NULL, "estimated error of size, relative; of a tension relative to its change "
	 "from that at rest", OF(of.size_error)},
	{"at_rest", NULL, "tension at rest", OF(at_rest), .unit = HAWSER__NEWTON,
	 .flags = HAWSER__OMIT},
	{"stable", NULL, "whether the motion is stable", HAWSER__FLAG_AT(struct peak, of.stable)},
	{"arc", NULL, "place along the curve", OF(of.arc)},
	HAWSER__END,
};
const struct hawser__field cli_frf_peak_column[] = {
	{NULL, "probe", "where; none of tensions and of a model without probes", OF(probe),
	 .flags = HAWSER__NULL | HAWSER__MISSING},
	{NULL, "component", "x, y or z; T_max, T_min; u of a model without probes", OF(kind)},
	{NULL, "coordinate", "whose peak it is, of such a model", OF(coordinate),
	 .flags = HAWSER__NULL | HAWSER__MISSING},
	{NULL, "Omega", "where it is", OF(of.omega), .unit = HAWSER__RAD_S},
	{NULL, "amplitude", "of a displacement", OF(amplitude), .unit = HAWSER__M,
	 .flags = HAWSER__NULL | HAWSER__MISSING},
	{NULL, "T", "of a tension: the tension", OF(tension), .unit = HAWSER__NEWTON,
	 .flags = HAWSER__NULL | HAWSER__MISSING},
	{NULL, "stable", "whether the motion is stable", HAWSER__FLAG_AT(struct peak, of.stable)},
	{NULL, "Omega_error", "estimated error of Omega, relative", OF(of.omega_error)},
	{NULL, "size_error", "estimated error of amplitude or change of tension, relative",
	 OF(of.size_error)},
	HAWSER__END,
};
#undef OF

static const struct cli_frf_result *branch_of(const struct cli_frf_result *result, int k)
{
	return k ? &result->other[k - 1] : result;
}

/* Number of displacements of all branches with a higher peak; of equal ones the first is higher. */
static int higher(const struct cli_frf_result *result, int branch, int peak)
{
	const struct hawser_landmark *of = &branch_of(result, branch)->peak[peak];
	int count = 0;

	for (int k = 0; k <= result->others; k++)
		for (int i = 0; i < branch_of(result, k)->peaks; i++) {
			const struct hawser_landmark *other = &branch_of(result, k)->peak[i];
			int before = k < branch || (k == branch && i < peak);

			count += !tells_tension(other) &&
			         (other->size > of->size || (before && !(other->size < of->size)));
		}
	return count;
}

int cli_frf_displacements(const struct cli_frf_result *result)
{
	int count = 0;

	for (int k = 0; k <= result->others; k++)
		for (int i = 0; i < branch_of(result, k)->peaks; i++)
			count += !tells_tension(&branch_of(result, k)->peak[i]);
	return count;
}

/* The displacement of all branches above which there are `rank`. */
static const void *highest_row(void *to, const void *parent, size_t rank)
{
	const struct cli_frf_result *result = parent;

	for (int k = 0; k <= result->others; k++)
		for (int i = 0; i < branch_of(result, k)->peaks; i++)
			if (!tells_tension(&branch_of(result, k)->peak[i]) &&
			    higher(result, k, i) == (int)rank)
				return peak_row(to, branch_of(result, k), (size_t)i);
	return NULL;
}

const struct hawser__list cli_frf_highest_rows = HAWSER__MADE_ROWS(
	struct peak, cli_frf_peak_column, struct cli_frf_result, highest, highest_row);
const struct hawser__list cli_frf_peak_rows = HAWSER__MADE_ROWS(
	struct peak, cli_frf_peak_column, struct cli_frf_result, peaks, peak_row);
const struct hawser__list cli_frf_peak_list = HAWSER__MADE_ROWS(
	struct peak, peak_field, struct cli_frf_result, peaks, peak_row);
