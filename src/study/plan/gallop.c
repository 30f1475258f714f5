/* study/plan/gallop.c - which modes a wind makes grow, and from which speed on.
 *
 *   U      speed at which a mode begins to grow, all modes together (modes/complex/damped_trace.c)
 *   U_1    the same of the mode alone (Den Hartog): its own damping over the growth that the wind of
 *          the scene gives it, times the speed of the scene, with the statics of that speed
 *
 * Two modes in 1:1, one in the plane and one out of it with equal shapes, exchange energy through the
 * wind, and U may be far from U_1. On flat spans every pair above the first is one.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include <hawser/damped.h>

#include "core/append.h"
#include "core/report.h"
#include "modes/complex/wind.h"
#include "study/accuracy/survey.h"

enum { POINTS = 13, FEW = 4 }; /* modes where the scene does not say how many */
#define LEAST 1e-3 /* speeds are sought from this multiple of the scene's */
#define REACH 2.0  /* to this one */
#define PAIR 0.02  /* relative distance of two frequencies in 1:1; chosen */
#define APART 0.05 /* |U/U_1 - 1| from which a pair is named as the reason; chosen */

static const struct hawser_mode *mode_of(const struct hawser_modes *modes, int plane, int number)
{
	for (int j = 0; j < modes->n; j++)
		if ((int)modes->mode[j].plane == plane && modes->mode[j].number == number)
			return &modes->mode[j];
	return NULL;
}

/* The mode of the other plane nearest in frequency, NULL if none is in 1:1. */
static const struct hawser_mode *partner(const struct hawser_modes *modes, const struct hawser_mode *of)
{
	const struct hawser_mode *best = NULL;

	for (int j = 0; j < modes->n; j++) {
		const struct hawser_mode *one = &modes->mode[j];
		double gap = fabs(one->omega/of->omega - 1.0);

		if (one->plane != of->plane && gap < PAIR &&
		    (!best || gap < fabs(best->omega/of->omega - 1.0)))
			best = one;
	}
	return best;
}

/* U_1 of mode j; infinite if the wind damps it. */
static double lone_speed(const struct hawser_survey *survey, const double *damping, int j)
{
	size_t at = (size_t)j*((size_t)survey->plan->modes.n + 1);

	return damping[at] < 0.0 ? -survey->scene->wind.speed*survey->raw.D[at]/damping[at] : INFINITY;
}

static void tell(char *text, size_t size, const struct hawser_survey *survey,
                 const struct hawser_damped_event *event, const double *damping)
{
	const struct hawser_modes *modes = &survey->plan->modes;
	const struct hawser_mode *mode = mode_of(modes, event->plane, event->number), *other;
	double lone = mode ? lone_speed(survey, damping, (int)(mode - modes->mode)) : NAN;

	hawser__append(text, size, "", "%s %d, %.4g Hz, %s from %.4g m/s on",
	               hawser_plane_name(event->plane), event->number, event->frequency,
	               event->onset ? "grows" : "no longer grows", event->value);
	if (!mode || !event->onset)
		return;
	if (isfinite(lone))
		hawser__append(text, size, "", "; alone (Den Hartog) it would from %.4g m/s on", lone);
	else
		hawser__append(text, size, "", "; alone it would not");
	other = fabs(event->value/lone - 1.0) > APART ? partner(modes, mode) : NULL;
	if (other)
		hawser__append(text, size, "", ": its 1:1 pair with %s %d, at %.4g of its frequency, decides",
		               hawser_plane_name(other->plane), other->number, other->omega/mode->omega);
}

enum hawser_status hawser__plan_gallop(char text[HAWSER__GALLOPS][HAWSER__GALLOP_TEXT], int *count,
                                       const struct hawser_survey *survey,
                                       struct hawser_report *report)
{
	const struct hawser_scene *scene = survey->scene;
	double speed[POINTS];
	const struct hawser_damped_sweep_options options = {
		.key = "wind.speed", .value = speed, .points = POINTS, .threads = 1,
		.modes = {.n = scene->model.modes > 0 ? scene->model.modes : FEW}};
	struct hawser_damped_sweep sweep = {.points = 0};
	int failed;
	double *damping = hawser__wind_damping(&failed, &survey->plan->modes, scene);
	enum hawser_status status = failed ? hawser__no_memory(report, "plan") : HAWSER_OK;

	for (int i = 0; i < POINTS; i++)
		speed[i] = (LEAST + (REACH - LEAST)*i/(POINTS - 1))*scene->wind.speed;
	if (!status)
		status = hawser_damped_trace(&sweep, scene, &options, report);
	*count = 0;
	for (int i = 0; !status && i < sweep.events && *count < HAWSER__GALLOPS; i++, ++*count) {
		*text[*count] = '\0';
		tell(text[*count], HAWSER__GALLOP_TEXT, survey, &sweep.event[i], damping);
	}
	if (!status && *count == 0)
		snprintf(text[(*count)++], HAWSER__GALLOP_TEXT, "none of the %d lowest modes begins or "
		         "ceases to grow up to %.4g m/s, %g times wind.speed", options.modes.n,
		         speed[POINTS - 1], REACH);
	hawser_damped_sweep_clear(&sweep);
	free(damping);
	return status;
}
