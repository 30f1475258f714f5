/* net/statics/exact_solution.c - statics by exact catenaries as its user sees it: see hawser/net.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "net/statics/dual.h"
#include "net/statics/solve.h"

static double size_of(const double t[3])
{
	return sqrt(t[0]*t[0] + t[1]*t[1] + t[2]*t[2]);
}

/* Least tension: where t is across p, if that is within the cable. */
static double least(const struct hawser__net_catenary *cable, const double F[3], double T_from,
                    double T_to)
{
	double w2 = 0.0, along = 0.0, x[3], t[3], S;

	for (int k = 0; k < 3; k++) {
		w2 += cable->p[k]*cable->p[k];
		along += F[k]*cable->p[k];
	}
	S = w2 > 0.0 ? cable->length0/2.0 + along/w2 : -1.0;
	if (!(S > 0.0 && S < cable->length0))
		return fmin(T_from, T_to);
	hawser__catenary_point(x, t, cable, F, S);
	return size_of(t);
}

static void member(struct hawser_net_statics *st, int c, const struct hawser__exact *exact,
                   int elements)
{
	const struct hawser__net_catenary *cable = &exact->dual.cable[c];
	const double *from = exact->mesh.q[exact->mesh.end[c][0]];
	struct hawser_net_member *m = &st->member[c];

	for (int i = 0; i <= elements; i++) {
		struct hawser_net_point *point = &st->point[st->points++];
		double t[3], F[3];

		memcpy(F, exact->dual.F[c], sizeof F);
		point->cable = c;
		point->S = cable->length0*i/elements;
		hawser__catenary_point(point->x, t, cable, F, point->S);
		for (int k = 0; k < 3; k++)
			point->x[k] += from[k];
		point->T = size_of(t);
	}
	m->T_from = st->point[st->points - elements - 1].T;
	m->T_to = st->point[st->points - 1].T;
	m->T_max = fmax(m->T_from, m->T_to);
	m->T_min = least(cable, exact->dual.F[c], m->T_from, m->T_to);
	m->length0 = cable->length0;
	m->length = m->length0 + hawser__catenary_stretch(cable, exact->dual.F[c]);
	m->slack = m->T_max < 1e-9*exact->dual.weight ? elements : 0;
}

static void reactions(struct hawser_net_statics *st, const struct hawser__exact *exact)
{
	const struct hawser__mesh *mesh = &exact->mesh;

	for (int c = 0; c < mesh->elements; c++)
		for (int k = 0; k < 3; k++) {
			st->reaction[mesh->end[c][0]][k] -= exact->dual.F[c][k];
			st->reaction[mesh->end[c][1]][k] += exact->dual.F[c][k];
		}
	for (int i = 0; i < mesh->nodes; i++)
		for (int k = 0; k < 3; k++)
			st->reaction[i][k] = mesh->unknown[i][k] < 0 ? st->reaction[i][k] - mesh->force[i][k] : 0.0;
}

enum hawser_status hawser__exact_statics(struct hawser_net_statics *st, const struct hawser_net *net,
                                         const struct hawser_net_options *options,
                                         struct hawser_report *report)
{
	struct hawser__exact exact;
	struct hawser__equilibrium found;
	size_t elements = 0;
	enum hawser_status status = hawser__exact_open(&exact, net, report);

	if (!status)
		status = hawser__net_supported(&exact.mesh, net, report);
	if (!status)
		status = hawser__exact_solve(&exact, &found, options->tolerance, options->iterations, report);
	for (int c = 0; c < net->cables; c++)
		elements += (size_t)net->cable[c].elements;
	if (!status) {
		*st = (struct hawser_net_statics){
			.nodes = net->nodes, .cables = net->cables, .unknowns = exact.mesh.unknowns,
			.energy = found.energy, .gap = found.gap, .residual = found.residual,
			.floor = found.floor, .method = found.method, .iterations = found.iterations};
		status = hawser__net_statics_open(st, elements, report);
	}
	if (!status) {
		memcpy(st->x, exact.mesh.q, (size_t)net->nodes*sizeof *st->x);
		for (int c = 0; c < net->cables; c++)
			member(st, c, &exact, net->cable[c].elements);
		reactions(st, &exact);
	}
	hawser__exact_clear(&exact);
	return status;
}
