/* net/motion/motion-error.c - hawser_net_integrate: a motion and, if asked for, its error by
 * another run. SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "core/report.h"
#include "net/motion/motion.h"

/* Largest distance of the probes of two motions, over the rows of both. */
static double distance(const struct hawser_net_motion *a, const struct hawser_net_motion *b)
{
	int rows = a->rows < b->rows ? a->rows : b->rows;
	double most = 0.0;

	for (int i = 0; i < rows*a->probes; i++)
		for (int k = 0; k < 3; k++)
			most = fmax(most, fabs(a->x[i][k] - b->x[i][k]));
	return most;
}

/* The motion again with steps twice as long: the error of order p is the difference over 2^p - 1. CVODE
 * has no steps that could be doubled: with a hundred times its tolerance, the difference is a bound. */
static enum hawser_status check(struct hawser_net_motion *motion, const struct hawser_net *net,
                                const struct hawser_net_motion_options *options,
                                struct hawser_report *report)
{
	struct hawser_net_motion_options again = *options;
	struct hawser_net_motion other;
	const struct hawser__motion_scheme *scheme = NULL;
	double factor, step = options->step != 0.0 ? options->step : net->dynamics.step;
	int order;
	enum hawser_status status;

	for (int i = 0; !scheme || strcmp(scheme->shown.name, motion->scheme) != 0; i++)
		scheme = hawser__motion_scheme(i);
	order = scheme->shown.order;
	factor = scheme->advance ? 100.0 : pow(2.0, order + 1);
	again.tolerance = factor*(options->tolerance > 0.0 ? options->tolerance : hawser__motion_tolerance);
	again.step = step > 0.0 ? 2.0*step : -1.0;
	again.frame = NULL;
	status = hawser__net_integrate(&other, net, &again, report);
	if (status)
		return status;
	motion->error = distance(motion, &other)/(scheme->advance ? 1.0 : pow(2.0, order) - 1.0);
	motion->checked = 1;
	motion->interrupted |= other.interrupted;
	hawser_net_motion_clear(&other);
	return HAWSER_OK;
}

/* The time in which an axial wave passes the longest element, s. */
static double transit(const struct hawser_net *net)
{
	double most = 0.0;

	for (int c = 0; c < net->cables; c++) {
		const struct hawser_net_cable *cable = &net->cable[c];

		if (cable->given == HAWSER_NET_LENGTH0 && !cable->rod)
			most = fmax(most, cable->value/cable->elements*sqrt(cable->rho/cable->EA));
	}
	return most;
}

/* The motion again with the axial damping with which a front is as long as an element or two. */
static enum hawser_status shocks(struct hawser_net_motion *motion, const struct hawser_net *net,
                                 const struct hawser_net_motion_options *options,
                                 struct hawser_report *report)
{
	struct hawser_net_motion_options again = *options;
	struct hawser_net damped = *net;
	struct hawser_net_motion other;
	enum hawser_status status;

	damped.axial = motion->shock_axial = transit(net);
	again.frame = NULL;
	status = hawser__net_integrate(&other, &damped, &again, report);
	if (status)
		return status;
	motion->shock = distance(motion, &other);
	motion->interrupted |= other.interrupted;
	hawser_net_motion_clear(&other);
	return HAWSER_OK;
}

/* The motion without damping, from which is seen whether anything becomes slack; where it does, with
 * half the damping of shocks: *net has it then. */
static enum hawser_status released(struct hawser_net_motion *to, struct hawser_net *net,
                                   const struct hawser_net_motion_options *options,
                                   struct hawser_report *report)
{
	struct hawser_net_motion_options trial = *options;
	enum hawser_status status;
	int ends;

	trial.frame = NULL;
	status = hawser__net_integrate(to, net, &trial, report);
	if (status)
		return status;
	ends = to->interrupted || (to->switches == 0 && !options->frame);
	if (ends)
		return HAWSER_OK;
	if (to->switches > 0)
		net->axial = 0.5*transit(net);
	hawser_net_motion_clear(to);
	status = hawser__net_integrate(to, net, options, report);
	to->front_axial = status ? 0.0 : net->axial;
	return status;
}

/* Fail for circles that turn freely, and for grooves where something may move the net along z. */
static enum hawser_status not_in_time(const struct hawser_net *net,
                                      const struct hawser_net_motion_options *options,
                                      struct hawser_report *report)
{
	double place;
	int flat = !net->dynamics.from && !options->initial && hawser__net_still(&place, net, 2, NULL, 0);

	for (int i = 0; i < net->nodes; i++)
		flat = flat && !net->node[i].table;
	for (int i = 0; i < net->surfaces; i++) {
		const struct hawser_surface *surface = &net->surface[i];

		if (surface->rotation == HAWSER_SURFACE_FREE && surface->friction > 0.0)
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "net", "%s: obstacles.%s.rotation: free "
			                    "is not yet known in motions: give locked, a velocity, or "
			                    "friction: 0", net->name, surface->name);
		if (surface->axial > 0.0 && !(surface->stiffness > 0.0))
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "net", "%s: obstacles.%s.friction: in "
			                    "motions, axial and transverse need a plane that gives way: give it "
			                    "a stiffness, such as 3 MPa/m, or one number", net->name,
			                    surface->name);
		if (surface->groove && !flat)
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "net", "%s: obstacles.%s.groove is not "
			                    "yet known in motions along z: leave it out, or what moves the net "
			                    "along z", net->name, surface->name);
	}
	return HAWSER_OK;
}

enum hawser_status hawser_net_integrate(struct hawser_net_motion *to, const struct hawser_net *net,
                                        const struct hawser_net_motion_options *options,
                                        struct hawser_report *report)
{
	struct hawser_net own = *net;
	int fronts = (net->dynamics.releases || net->failures) && net->axial == 0.0 && transit(net) > 0.0;
	enum hawser_status status = not_in_time(net, options, report);

	memset(to, 0, sizeof *to);
	if (!status)
		status = fronts && !net->axial_given ? released(to, &own, options, report)
		                                     : hawser__net_integrate(to, net, options, report);
	to->shock = NAN;
	if (!status && fronts && to->switches > 0 && to->probes > 0 && !to->interrupted)
		status = shocks(to, net, options, report);
	if (!status && options->check && !to->interrupted)
		status = check(to, &own, options, report);
	if (status)
		hawser_net_motion_clear(to);
	return status;
}
