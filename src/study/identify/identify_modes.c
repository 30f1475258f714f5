/* study/identify/identify_modes.c - frequencies of a scene as functions of its free parameters.
 *
 *    x    variable of a parameter p: log(p/p0) if p must be positive, else (p - p0)/|p0|; p0 is the
 *         value in the scene
 *    r    weight log(computed/measured)
 *
 * Derivatives are central differences, since the parameters of a scene enter statics and modes by many
 * paths. All modes of a fit are computed with the same basis, so that frequencies are smooth in x:
 * their error is round-off, and with the step below a derivative has about eight digits.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include <hawser/gyroscopic.h>

#include "core/report.h"
#include "study/identify/identify.h"

#define STEP 1e-4       /* of x: the error is about its square, and round-off of 1e-12 over it */
#define TOLERANCE 1e-10 /* of frequencies, relative; well below the noise of any measurement */

double hawser__fit_value(const struct hawser__fit *fit, int k, double x)
{
	return fit->logarithmic[k] ? fit->start[k]*exp(x) : fit->start[k] + fabs(fit->start[k])*x;
}

enum hawser_status hawser__fit_scene(struct hawser_scene *scene, const struct hawser__fit *fit,
                                     const double *x, struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	*scene = *fit->scene;
	for (int k = 0; k < fit->keys && !status; k++)
		status = hawser_scene_set(scene, fit->key[k], hawser__fit_value(fit, k, x[k]), report);
	return status;
}

enum hawser_status hawser__fit_modes(struct hawser_modes *modes, struct hawser__fit *fit,
                                     const double *x, struct hawser_report *report)
{
	/* with cable.EI there is no choice of a basis: its elements follow the boundary layers */
	int basis = fit->scene->cable.EI > 0.0 ? 0 : fit->basis;
	struct hawser_modes_options options = {.n = fit->modes, .basis = basis,
	                                       .tolerance = basis ? 0.0 : TOLERANCE};
	struct hawser_statics statics;
	struct hawser_scene scene;
	enum hawser_status status = hawser__fit_scene(&scene, fit, x, report);

	*modes = (struct hawser_modes){0};
	if (!status)
		status = hawser_statics_scene(&statics, &scene, report);
	if (!status)
		status = hawser_steady_modes_solve(modes, &statics, &options, report);
	if (!status)
		fit->basis = modes->basis;
	fit->evaluations++;
	return status;
}

const struct hawser_mode *hawser__fit_find(const struct hawser_modes *modes,
                                           struct hawser__mate mate)
{
	for (int k = 0; k < modes->n; k++)
		if ((int)modes->mode[k].plane == mate.plane && modes->mode[k].number == mate.number)
			return &modes->mode[k];
	return NULL;
}

enum hawser_status hawser__fit_residuals(double *r, struct hawser__fit *fit, const double *x,
                                         struct hawser_report *report)
{
	struct hawser_modes modes;
	enum hawser_status status = hawser__fit_modes(&modes, fit, x, report);

	for (int i = 0; i < fit->count && !status; i++) {
		const struct hawser_mode *mode = hawser__fit_find(&modes, fit->mate[i]);

		if (mode)
			r[i] = fit->weight[i]*
			       log(mode->omega/modes.time_unit/fit->measured[i].omega);
		else
			status = hawser__fail(report, HAWSER_ERR_CONVERGENCE, "identify",
			                      "%s mode %d is not among the lowest %d",
			                      hawser_plane_name((enum hawser_plane)fit->mate[i].plane),
			                      fit->mate[i].number, modes.n);
	}
	hawser_modes_clear(&modes);
	return status;
}

enum hawser_status hawser__fit_jacobian(double *J, struct hawser__fit *fit, const double *x,
                                        struct hawser_report *report)
{
	double at[HAWSER_IDENTIFY_KEYS];
	enum hawser_status status = HAWSER_OK;

	memcpy(at, x, (size_t)fit->keys*sizeof *at);
	for (int k = 0; k < fit->keys && !status; k++) {
		double *column = J + (size_t)k*(size_t)fit->count;

		for (int side = -1; side <= 1 && !status; side += 2) {
			double *r = side < 0 ? column : J + (size_t)fit->keys*(size_t)fit->count;

			at[k] = x[k] + side*STEP;
			status = hawser__fit_residuals(r, fit, at, report);
		}
		at[k] = x[k];
		for (int i = 0; i < fit->count; i++)
			column[i] = (J[(size_t)fit->keys*(size_t)fit->count + (size_t)i] - column[i])/(2.0*STEP);
	}
	return status;
}
