/* net/plan/plan-mesh.c - the error of a mesh: its equilibrium against that of exact catenaries with
 * the same unstretched lengths, at the same places of the cables.
 *
 * The error of a mesh is of second order in the length of its elements, so that the number of elements
 * for another error follows.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "net/plan/plan.h"
#include "net/statics/solve.h"

/* Error of positions over the sag, which a drawing does not show; the sag counts as a tenth of the
 * largest one of all cables at least, since a taut cable is displaced by the errors of the others.
 * */
static const double WANTED = 1e-3, TENTH = 0.1;

/* Largest vertical distance from the chord: points [count] from one end to the other. */
static double sag(const struct hawser_net_point *point, int count)
{
	const double *a = point[0].x, *b = point[count - 1].x;
	double dx = b[0] - a[0], dz = b[2] - a[2], d2 = dx*dx + dz*dz, most = 0.0;

	for (int i = 1; i < count - 1 && d2 > 0.0; i++) {
		const double *p = point[i].x;
		double part = ((p[0] - a[0])*dx + (p[2] - a[2])*dz)/d2;

		most = fmax(most, fabs(a[1] + part*(b[1] - a[1]) - p[1]));
	}
	return most;
}

static double strain(const struct hawser_net_plan_cable *cable, double EA)
{
	return cable->T_max/EA;
}

static void compare(struct hawser_net_plan_cable *cable, const struct hawser_net_point *mesh,
                    const struct hawser_net_point *exact)
{
	int n = cable->elements;
	double off = 0.0, other = 0.0;

	for (int i = 0; i <= n; i++) {
		double square = 0.0;

		for (int k = 0; k < 3; k++)
			square += (mesh[i].x[k] - exact[i].x[k])*(mesh[i].x[k] - exact[i].x[k]);
		off = fmax(off, sqrt(square));
		other = fmax(other, fabs(mesh[i].T - exact[i].T));
	}
	cable->error = off;
	cable->tension_error = cable->T_max > 0.0 ? other/cable->T_max : NAN;
}

static void want(struct hawser_net_plan *plan)
{
	double largest = 0.0;

	for (int c = 0; c < plan->cables; c++)
		largest = fmax(largest, plan->cable[c].sag);
	for (int c = 0; c < plan->cables; c++) {
		struct hawser_net_plan_cable *cable = &plan->cable[c];

		cable->reach = fmax(cable->sag, TENTH*largest);
		if (cable->reach > 0.0 && !isnan(cable->error))
			cable->wanted = (int)fmin(fmax(ceil(cable->elements*sqrt(cable->error/
			                                                         (WANTED*cable->reach))),
			                               1.0), 1e9);
	}
}

enum hawser_status hawser__plan_mesh(struct hawser__net_planner *planner, struct hawser_report *report)
{
	struct hawser_net_plan *plan = planner->plan;
	const struct hawser_net_statics *st = &planner->st;
	struct hawser_net_statics by = {0};
	int found = 0, at = 0;
	enum hawser_status status = st->x ? hawser__net_exact(&by, &found, planner->net, st, report)
	                                  : HAWSER_OK;

	for (int c = 0; c < plan->cables; c++) {
		struct hawser_net_plan_cable *cable = &plan->cable[c];
		int n = planner->net->cable[c].elements;

		*cable = (struct hawser_net_plan_cable){.elements = n, .error = NAN, .tension_error = NAN,
		                                        .length0 = NAN, .sag = NAN, .reach = NAN, .T_min = NAN,
		                                        .T_max = NAN, .strain = NAN};
		if (!st->x)
			continue;
		cable->slack = st->member[c].slack;
		cable->length0 = st->member[c].length0;
		cable->T_min = st->member[c].T_min;
		cable->T_max = st->member[c].T_max;
		cable->strain = strain(cable, planner->net->cable[c].EA);
		cable->sag = sag(&(found ? &by : st)->point[at], n + 1);
		planner->slack += cable->slack > 0;
		/* the place of a slack cable without weight is not determined */
		if (found && !(cable->slack && planner->net->cable[c].rho == 0.0))
			compare(cable, &st->point[at], &by.point[at]);
		at += n + 1;
	}
	want(plan);
	hawser_net_statics_clear(&by);
	return status;
}
