/* modes/methods.c - the table of methods, and the checks and names common to all of them. A new
 * method is a new file and a row here.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "modes/analytic.h"
#include "modes/chain.h"
#include "modes/fdm.h"
#include "modes/grid.h"
#include "modes/methods.h"
#include "modes/spectral.h"

static const struct hawser_modes_method table[] = {
	{"spectral", "converged hp Legendre-Galerkin method with strains as unknowns",
	 "doc/theory-modes.md", 1e-10, hawser__spectral_solve},
	{"analytic", "closed forms for constant tension and curvature, with their error",
	 "Bertrand (2022), sections 4.1.3 and 4.1.4, with errata", HUGE_VAL, hawser__analytic_solve},
	{"fdm", "second-order finite differences of the equations of motion, banded",
	 "Bertrand (2022), section 4.1.5", 1e-5, hawser__fdm_solve},
	{"chain", "point masses and springs, forces as unknowns: second order, symmetric",
	 "doc/theory-modes.md", 1e-5, hawser__chain_solve},
};
enum { METHODS = sizeof table/sizeof table[0] };

const struct hawser_modes_method *hawser_modes_methods(int *count)
{
	*count = METHODS;
	return table;
}

static const struct hawser_modes_method *find(const char *name)
{
	for (int i = 0; i < METHODS; i++)
		if (strcmp(table[i].name, name) == 0)
			return table + i;
	return NULL;
}

enum hawser_status hawser__modes_check_statics(const struct hawser_statics *st,
                                               struct hawser_report *report)
{
	const struct {
		const char *name;
		double value;
	} given[] = {{"epsilon = H/EA", st->epsilon}, {"delta = rho*g*d/H", st->delta},
	             {"l = L/d", st->l}, {"eta", st->eta}, {"H", st->H}, {"d", st->span.d},
	             {"rho", st->span.rho}};

	if (isinf(st->span.EA) || st->epsilon == 0.0)
		return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "modes",
		                    "an inextensible cable (EA infinite) has infinite longitudinal "
		                    "frequencies and no finite tension-strain law: give a finite EA, "
		                    "such as 1e14 N, for its limit");
	for (size_t i = 0; i < sizeof given/sizeof given[0]; i++)
		if (isnan(given[i].value))
			return hawser__fail(report, HAWSER_ERR_NAN, "modes",
			                    "%s of the static solution is not a number: solve the "
			                    "statics first", given[i].name);
	for (size_t i = 0; i < sizeof given/sizeof given[0]; i++)
		if (isinf(given[i].value) || (i != 3 && given[i].value <= 0.0))
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes",
			                    "%s of the static solution is %g, where a finite %snumber "
			                    "is needed: solve the statics first", given[i].name,
			                    given[i].value, i != 3 ? "positive " : "");
	return HAWSER_OK;
}

enum hawser_status hawser__modes_check_options(const struct hawser_modes_options *options,
                                               struct hawser_report *report)
{
	if (options->n < 1)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes",
		                    "%d modes asked: ask for at least one", options->n);
	if (options->basis < 0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes",
		                    "a basis of %d functions: give a positive number, or 0 for as "
		                    "many as the tolerance needs", options->basis);
	if (!(options->tolerance >= 0.0 && options->tolerance < 1.0))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes",
		                    "a tolerance of %g: give a relative error in (0, 1), or 0 for "
		                    "the method's own", options->tolerance);
	return HAWSER_OK;
}

/* If the estimated relative error is 1 or more, no digit of the frequency is known, nor which mode
 * it belongs to; the numbers of the modes above it are not known either. */
enum hawser_status hawser__modes_unknown(int k, double omega, enum hawser_plane plane, double error,
                                         const struct hawser_modes_options *solved,
                                         struct hawser_report *report)
{
	const char *try = strcmp(solved->method, "spectral") ? "take the method spectral"
	                  : "raise model.basis, or leave it out";
	char fewer[80] = "";

	if (k > 0)
		snprintf(fewer, sizeof fewer, ", or ask for the lowest %d, which are known", k);
	return hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, "modes", k + 1, error,
	                       "the estimated relative error of mode %d of %d (%s, %.6g rad/s) is %.1e, "
	                       "so that its frequency is unknown (method %s, a basis of "
	                       "%d): %s%s", k + 1, solved->n, hawser_plane_name(plane), omega, error,
	                       solved->method, solved->basis, try, fewer);
}

static enum hawser_status check_errors(const struct hawser_modes *modes,
                                       struct hawser_report *report)
{
	const struct hawser_modes_options solved = {.n = modes->n, .basis = modes->basis,
	                                            .method = modes->method};

	for (int k = 0; k < modes->n; k++)
		if (!(modes->mode[k].residual < 1.0))
			return hawser__modes_unknown(k, modes->mode[k].omega/modes->time_unit,
			                             modes->mode[k].plane, modes->mode[k].residual, &solved,
			                             report);
	return HAWSER_OK;
}

enum hawser_status hawser_modes_solve(struct hawser_modes *modes,
                                      const struct hawser_statics *statics,
                                      const struct hawser_modes_options *options,
                                      struct hawser_report *report)
{
	struct hawser_modes_options settled = *options;
	const struct hawser_modes_method *method = find(options->method ? options->method : "spectral");
	enum hawser_status status;

	*modes = (struct hawser_modes){0};
	if (!method)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes",
		                    "no method \"%s\" for modes: hawser modes --list-methods lists them, the "
		                    "first is \"%s\"",
		                    options->method, table[0].name);
	status = hawser__modes_check_options(options, report);
	if (!status)
		status = hawser__modes_check_statics(statics, report);
	if (status)
		return status;
	if (settled.tolerance == 0.0)
		settled.tolerance = method->tolerance;
	modes->statics = *statics;
	status = method->solve(modes, statics, &settled, report);
	modes->method = method->name;
	modes->time_unit = statics->span.d*sqrt(statics->span.rho/statics->H);
	if (!status && !settled.any_error)
		status = check_errors(modes, report);
	if (status)
		hawser_modes_clear(modes);
	return status;
}

void hawser_modes_at(const struct hawser_modes *modes, double *shape, double *slope, int k, double s)
{
	size_t first = (size_t)k*3*(size_t)modes->grid.points;

	hawser__grid_at(shape, &modes->grid, modes->shape + first, 3, 3, s);
	if (slope)
		hawser__grid_at(slope, &modes->grid, modes->slope + first, 3, 3, s);
}

void hawser_modes_clear(struct hawser_modes *modes)
{
	if (!modes)
		return;
	hawser__grid_clear(&modes->grid);
	free(modes->mode);
	free(modes->shape);
	free(modes->slope);
	*modes = (struct hawser_modes){0};
}

const char *hawser_plane_name(enum hawser_plane plane)
{
	return plane == HAWSER_IN_PLANE ? "in-plane" : "out-of-plane";
}

const char *hawser_family_name(enum hawser_family family)
{
	return family == HAWSER_TRANSVERSE ? "transverse" : "longitudinal";
}

const char *hawser_symmetry_name(enum hawser_symmetry symmetry)
{
	return symmetry == HAWSER_SYMMETRIC ? "symmetric"
	       : symmetry == HAWSER_ANTISYMMETRIC ? "antisymmetric" : "mixed";
}
