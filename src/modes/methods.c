/* modes/methods.c - the table of methods for real modes, and what is common to all methods, also
 * to those for complex modes (gyroscopic.c): checks, names, access. A new method is a new file and a
 * row in its table.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/damped.h>

#include "core/report.h"
#include "modes/analytic.h"
#include "modes/bending/bending.h"
#include "modes/grid.h"
#include "modes/complex/gyroscopic.h"
#include "modes/label.h"
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

const struct hawser_modes_method *hawser_modes_method(int index)
{
	return index >= 0 && index < METHODS ? &table[index] : NULL;
}

static const struct hawser_modes_method *row_of(int gyroscopic, int index)
{
	return gyroscopic ? hawser_complex_modes_method(index) : hawser_modes_method(index);
}

const struct hawser_modes_method *hawser_steady_modes_method(const struct hawser_statics *statics,
                                                             int index)
{
	return row_of(statics->motion.nu != 0.0, index);
}

static const struct hawser_modes_method *find(const char *name, int gyroscopic,
                                              struct hawser_report *report)
{
	const char *first = row_of(gyroscopic, 0)->name;

	for (int i = 0; row_of(gyroscopic, i); i++)
		if (!name || strcmp(row_of(gyroscopic, i)->name, name) == 0)
			return row_of(gyroscopic, i);
	if (gyroscopic)
		(void)hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes",
		                   "no method \"%s\" for the modes of a travelling cable: hawser modes "
		                   "--list-methods lists them, the first is \"%s\"", name, first);
	else
		(void)hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes",
		                   "no method \"%s\" for modes: hawser modes --list-methods lists them, "
		                   "the first is \"%s\"", name, first);
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

	if (st->space && st->bending.EI > 0.0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes",
		                    "cable.EI with masses in a wind, or with attach.force: bending stiffness "
		                    "of a cable that hangs in space is not modelled; set cable.EI=0, or "
		                    "load.static.per_length=[0,0,0] and forces downwards");
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

int hawser__has_absorbers(const struct hawser_statics *st)
{
	int any = 0;

	for (int i = 0; i < st->attachments; i++)
		any |= st->attached[i].absorber > 0.0;
	return any;
}

enum hawser_status hawser__check_absorbers(const struct hawser_statics *st,
                                           struct hawser_report *report)
{
	if (st->space && hawser__has_absorbers(st))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes",
		                    "attach.absorber_mass with load.static.per_length: absorbers of a "
		                    "cable that hangs in space are not modelled; set "
		                    "load.static.per_length=[0,0,0], or give their mass as mass, which "
		                    "holds it to the cable");
	for (int i = 0; i < st->attachments; i++) {
		const double *a = st->attached[i].absorber_axis;

		if (st->attached[i].absorber > 0.0 && a[2] != 0.0 && (a[0] != 0.0 || a[1] != 0.0))
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes",
			                    "attach[%d].absorber_direction is oblique to the plane of the "
			                    "cable, which only hawser modes --damped allows: give "
			                    "a direction in the plane (z = 0) or along z",
			                    st->attached[i].index);
	}
	if (st->bending.EI > 0.0 && hawser__has_absorbers(st))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes",
		                    "absorbers of attachments are for a cable without bending stiffness: "
		                    "leave cable.EI out, or give their mass as mass, which holds it to the "
		                    "cable");
	return HAWSER_OK;
}

static enum hawser_status check_options(const struct hawser_modes_options *options,
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
static enum hawser_status unknown(const struct hawser_modes *modes, int k,
                                  struct hawser_report *report)
{
	const struct hawser_mode *mode = modes->mode + k;
	const char *try = strcmp(modes->method, "spectral") ? "take the method spectral"
	                  : "raise model.basis, or leave it out";
	char fewer[80] = "";

	if (k > 0)
		snprintf(fewer, sizeof fewer, ", or ask for the lowest %d, which are known", k);
	return hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, "modes", k + 1, mode->residual,
	                       "the estimated relative error of mode %d of %d (%s, %.6g rad/s) is %.1e, "
	                       "so that its frequency is unknown (method %s, a basis of "
	                       "%d): %s%s", k + 1, modes->n, hawser_plane_name(mode->plane),
	                       mode->omega/modes->time_unit, mode->residual, modes->method,
	                       modes->basis, try, fewer);
}

static enum hawser_status check_errors(const struct hawser_modes *modes,
                                       struct hawser_report *report)
{
	for (int k = 0; k < modes->n; k++)
		if (!(modes->mode[k].residual < 1.0))
			return unknown(modes, k, report);
	return HAWSER_OK;
}

/* Complex modes if `gyroscopic`, else real ones. */
static enum hawser_status solve(struct hawser_modes *modes, const struct hawser_statics *statics,
                                const struct hawser_modes_options *options, int gyroscopic,
                                struct hawser_report *report)
{
	struct hawser_modes_options settled = *options;
	const struct hawser_modes_method *method = find(options->method, gyroscopic, report);
	enum hawser_status status;

	*modes = (struct hawser_modes){.gyroscopic = gyroscopic};
	if (!method)
		return HAWSER_ERR_ARGUMENT;
	status = check_options(options, report);
	if (!status)
		status = hawser__modes_check_statics(statics, report);
	if (!status && gyroscopic && !isfinite(statics->motion.nu))
		status = hawser__fail(report, HAWSER_ERR_NAN, "modes",
		                      "the travel speed of the static solution is %g in its own scale: "
		                      "solve the statics first", statics->motion.nu);
	if (status)
		return status;
	if (statics->attachments > 0 && method->solve != hawser__spectral_solve)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes",
		                    "the method %s is for a cable without attachments: take spectral",
		                    method->name);
	if (statics->elastic && method->solve != hawser__spectral_solve)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes",
		                    "the method %s is for rigid supports: take spectral, or leave "
		                    "support.A.stiffness and support.B.stiffness out", method->name);
	if (statics->bending.EI > 0.0 && (gyroscopic || method->solve != hawser__spectral_solve))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes",
		                    "the method %s is for a cable without bending stiffness: take "
		                    "spectral for a cable at rest, or leave cable.EI out", method->name);
	status = hawser__check_absorbers(statics, report);
	if (status)
		return status;
	if (settled.tolerance == 0.0)
		settled.tolerance = method->tolerance;
	modes->statics = *statics;
	status = (statics->bending.EI > 0.0 ? hawser__flexure_solve
	                                    : method->solve)(modes, statics, &settled, report);
	modes->method = method->name;
	modes->time_unit = statics->span.d*sqrt(statics->span.rho/statics->H);
	if (!status && !settled.any_error)
		status = check_errors(modes, report);
	if (status)
		hawser_modes_clear(modes);
	return status;
}

enum hawser_status hawser_modes_solve(struct hawser_modes *modes,
                                      const struct hawser_statics *statics,
                                      const struct hawser_modes_options *options,
                                      struct hawser_report *report)
{
	return solve(modes, statics, options, 0, report);
}

enum hawser_status hawser_complex_modes_solve(struct hawser_modes *modes,
                                              const struct hawser_statics *statics,
                                              const struct hawser_modes_options *options,
                                              struct hawser_report *report)
{
	return solve(modes, statics, options, 1, report);
}

enum hawser_status hawser_steady_modes_solve(struct hawser_modes *modes,
                                             const struct hawser_statics *statics,
                                             const struct hawser_modes_options *options,
                                             struct hawser_report *report)
{
	return solve(modes, statics, options, statics->motion.nu != 0.0, report);
}

int hawser_modes_near(const struct hawser_modes *modes, int j)
{
	const struct hawser_mode *mode = modes->mode + j;

	return mode[0].omega - mode[-1].omega <= HAWSER_CLUSTER*mode[0].omega;
}

/* Modes beyond those of the scene among which a cluster ends; those that may grow in a wind, the fewest
 * that are kept then, and speeds; chosen. */
enum { AFTER = 3, LOOKED = 20, USUAL = 4, SPEEDS = 4 };

/* The least number of lowest modes with all of the first LOOKED that grow in the wind, at parts of its
 * speed up to twice as much, as plan looks; 0: it is not the wind that decides. */
static int galloping(const struct hawser_scene *scene, const struct hawser_statics *statics)
{
	const struct hawser_damped_options options = {.n = LOOKED};
	struct hawser_scene at = *scene; /* a copy that is not cleared */
	int count = USUAL;

	if (scene->load.present || scene->loads > 0 || !scene->wind.present)
		return 0;
	for (int i = 1; i <= SPEEDS; i++) {
		struct hawser_damped damped;

		at.wind.speed = 2.0*i/SPEEDS*scene->wind.speed;
		if (hawser_damped_solve(&damped, statics, &at, &options, NULL))
			return 0;
		for (int k = count; k < damped.n; k++)
			count = damped.mode[k].re > 0.0 ? k + 1 : count;
		hawser_damped_clear(&damped);
	}
	return count;
}

void hawser_modes_settle(struct hawser_scene *scene, const struct hawser_statics *statics)
{
	struct hawser_modes_options options = {.basis = scene->model.basis};
	struct hawser_modes modes;

	if (scene->beam.form)
		return;
	if (scene->model.modes == HAWSER_MODES_AUTO)
		scene->model.modes = galloping(scene, statics);
	else if (hawser_scene_written(scene, "model.modes"))
		return;
	options.n = scene->model.modes + AFTER;
	if (scene->model.modes == HAWSER_MODES_AUTO || hawser_modes_solve(&modes, statics, &options, NULL))
		return;
	for (int j = scene->model.modes; j < modes.n && hawser_modes_near(&modes, j); j++)
		scene->model.modes = j + 1;
	hawser_modes_clear(&modes);
}

void hawser_modes_at(const struct hawser_modes *modes, double *shape, double *slope, int k, double s)
{
	size_t size = 3*(size_t)modes->grid.points, first = (size_t)k*hawser__modes_row(modes);

	for (int part = 0; part <= modes->gyroscopic; part++, first += size) {
		hawser__grid_at(shape + 3*part, &modes->grid, modes->shape + first, 3, 3, s);
		if (slope)
			hawser__grid_at(slope + 3*part, &modes->grid, modes->slope + first, 3, 3, s);
	}
}

void hawser_modes_clear(struct hawser_modes *modes)
{
	if (!modes)
		return;
	hawser__grid_clear(&modes->grid);
	free(modes->mode);
	free(modes->shape);
	free(modes->slope);
	free(modes->stroke);
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
