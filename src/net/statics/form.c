/* net/statics/form.c - form finding: cables with a given tension, force density or sag in place of
 * a length.
 *
 * density  tension over length, the same in all elements of such a cable
 *
 * With given force densities the shape is the solution of a linear problem; beside cables of a given
 * length, of a convex one, since density*l^2/2 is convex. With given tensions the densities are those
 * of a convex problem too (net/statics/form-tension.c). What changes from one solution to the next
 * is the weight, by the unstretched length l/(1 + T/EA) of each element, and the force density of a
 * cable whose sag is given: it is scaled by the ratio of what is given to what was found. The
 * equilibrium is then solved again with the unstretched lengths as given.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "core/report.h"
#include "net/statics/dual.h"

enum { MOST = 500 };
/* Relative changes of tensions, sags and lengths: at which the iteration ends, and that will do. Where
 * cables have no length, positions give their forces to 1e-7 only. */
static const double WELL = 1e-12, ENOUGH = 1e-9, NEARLY = 1e-6;

/* Largest vertical distance of the nodes of a cable from its chord. */
static double sag_of(const struct hawser__mesh *mesh, int cable)
{
	int first = mesh->first[cable], last = mesh->first[cable + 1] - 1;
	const double *a = mesh->q[mesh->end[first][0]], *b = mesh->q[mesh->end[last][1]];
	double dx = b[0] - a[0], dz = b[2] - a[2], d2 = dx*dx + dz*dz, most = 0.0;

	for (int i = first; i < last && d2 > 0.0; i++) {
		const double *p = mesh->q[mesh->end[i][1]];
		double part = ((p[0] - a[0])*dx + (p[2] - a[2])*dz)/d2;

		most = fmax(most, fabs(a[1] + part*(b[1] - a[1]) - p[1]));
	}
	return most;
}

/* What a cable has of the quantity that is given for it. */
static double found_of(const struct hawser__mesh *mesh, const struct hawser_net_cable *cable,
                       int number)
{
	int first = mesh->first[number], n = mesh->first[number + 1] - first;
	double sum = 0.0, e[3];

	if (cable->given == HAWSER_NET_SAG)
		return sag_of(mesh, number);
	if (cable->given != HAWSER_NET_TENSION)
		return cable->value;
	for (int i = first; i < first + n; i++)
		sum += mesh->density[i]*hawser__mesh_direction(e, mesh, i);
	return sum/n;
}

/* The first force densities and lengths: those of the chord or, where an end is free, of lengths of 1 m
 * a cable. */
static void begin(struct hawser__mesh *mesh, const struct hawser_net *net)
{
	for (int c = 0; c < net->cables; c++) {
		const struct hawser_net_cable *cable = &net->cable[c];
		const double *a = mesh->q[cable->from], *b = mesh->q[cable->to];
		double chord = sqrt((a[0] - b[0])*(a[0] - b[0]) + (a[1] - b[1])*(a[1] - b[1]) +
		                    (a[2] - b[2])*(a[2] - b[2]));
		double l = (chord > 0.0 ? chord : 1.0)/cable->elements, density = cable->value;

		if (cable->given == HAWSER_NET_LENGTH0)
			continue;
		density *= cable->elements; /* of an element, whose length is that part of the cable's */
		if (cable->given == HAWSER_NET_TENSION)
			density = cable->value/l;
		/* Of the parabola; 1e-4 of EA for a cable of no weight. */
		if (cable->given == HAWSER_NET_SAG)
			density = fmax(cable->rho*mesh->g*chord*chord/(8.0*cable->value), 1e-4*cable->EA)/l;
		for (int i = mesh->first[c]; i < mesh->first[c + 1]; i++) {
			mesh->density[i] = density;
			mesh->length0[i] = l/(1.0 + density*l/cable->EA);
		}
	}
}

/* New force densities and unstretched lengths; returns the largest relative change. */
static double revise(struct hawser__form *form)
{
	struct hawser__mesh *mesh = form->mesh;
	const struct hawser_net *net = form->net;
	double most = 0.0, e[3];

	for (int c = 0; c < net->cables; c++) {
		const struct hawser_net_cable *cable = &net->cable[c];
		double has, ratio;

		if (cable->given == HAWSER_NET_LENGTH0)
			continue;
		has = found_of(mesh, cable, c);
		ratio = cable->given == HAWSER_NET_SAG ? has/cable->value : cable->value/has;
		ratio = isfinite(ratio) && ratio > 0.0 ? fmin(fmax(ratio, 0.1), 10.0) : 10.0;
		most = form->gone[c] ? most : fmax(most, fabs(ratio - 1.0));
		for (int i = mesh->first[c]; i < mesh->first[c + 1]; i++) {
			double l = hawser__mesh_direction(e, mesh, i);
			double length0 = l/(1.0 + mesh->density[i]*l/mesh->EA[i]);

			if (length0 > 0.0) {
				most = form->gone[c] ? most : fmax(most, fabs(length0/mesh->length0[i] - 1.0));
				mesh->length0[i] = length0;
			}
			if (cable->given == HAWSER_NET_SAG) /* at most a strain of 1: no sag that can be had */
				mesh->density[i] = fmin(mesh->density[i]*ratio, mesh->EA[i]/fmax(l, 1e-300));
		}
	}
	return most;
}

static enum hawser_status no_form(const struct hawser__mesh *mesh, const struct hawser_net *net,
                                  struct hawser_report *report)
{
	const struct hawser_net_cable *worst = NULL;
	double most = -1.0, has = 0.0;
	static const char *const word[] = {"length0", "tension", "force_density", "sag"};

	for (int c = 0; c < net->cables; c++) {
		const struct hawser_net_cable *cable = &net->cable[c];
		double now = cable->given ? found_of(mesh, cable, c) : 0.0;

		if (cable->given && fabs(now/cable->value - 1.0) > most) {
			most = fabs(now/cable->value - 1.0);
			has = now;
			worst = cable;
		}
	}
	if (most < 1e-6)
		return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "net",
		                    "the lengths that go with the given force densities, tensions and sags did "
		                    "not settle, since the weights change with them: give length0 for cables "
		                    "with a free end");
	return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "net",
	                    "no shape was found in which the cables have what is given: the %s of %s "
	                    "came to %.6g, and %.6g is given. Give what loads and supports allow, or "
	                    "force_density, which is always possible",
	                    worst ? word[worst->given] : "length",
	                    worst ? worst->name : "a cable", has, worst ? worst->value : 0.0);
}

/* Whether a cable of given tension has no length in the shape. */
static int gone(const struct hawser__form *form)
{
	for (int i = 0; i < form->count; i++)
		if (form->gone[form->cable[i]])
			return 1;
	return 0;
}

enum hawser_status hawser__mesh_form(struct hawser__mesh *mesh, double *T,
                                     struct hawser__equilibrium *found, const struct hawser_net *net,
                                     const struct hawser__mesh_options *options,
                                     struct hawser_report *report)
{
	struct hawser__mesh_options again = options ? *options : (struct hawser__mesh_options){0};
	struct hawser__form form = {0};
	enum hawser_status status = HAWSER_OK;
	double change = INFINITY;
	int any = 0, known;

	for (int c = 0; c < net->cables; c++)
		any |= net->cable[c].given != HAWSER_NET_LENGTH0;
	if (!any)
		return hawser__mesh_statics(mesh, T, found, options, report);
	begin(mesh, net);
	status = hawser__form_open(&form, mesh, net, &again, report);
	for (int i = 0; i < MOST && change > (gone(&form) ? NEARLY : WELL) && !status; i++) {
		hawser__mesh_load(mesh, net);
		status = hawser__form_balance(&form, report);
		if (!status)
			status = hawser__form_step(&form, report);
		change = status ? 1.0 : revise(&form);
		if (i > 0 && (status == HAWSER_ERR_CONVERGENCE || status == HAWSER_ERR_NAN))
			status = hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "net",
			                      "no shape was found in which the cables have what is given: it "
			                      "grows beyond all bounds. Give tensions and sags that loads and "
			                      "supports allow, or force_density");
	}
	known = change <= (gone(&form) ? NEARLY : ENOUGH);
	hawser__form_clear(&form);
	if (!status && !known)
		status = no_form(mesh, net, report);
	for (int i = 0; i < mesh->elements; i++)
		mesh->density[i] = 0.0;
	if (status)
		return status;
	hawser__mesh_load(mesh, net);
	again.keep_start = 1;
	return hawser__mesh_statics(mesh, T, found, &again, report);
}
