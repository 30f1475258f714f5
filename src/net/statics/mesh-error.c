/* net/statics/mesh-error.c - the error of tensions by the mesh, and the elements that make it
 * small.
 *
 * T  tensions of a cable that are compared: at both ends, and the largest
 *
 * Without obstacles the judge is the exact catenary of each cable, with the same unstretched
 * lengths (net/statics/exact.c): it knows only the joints, and costs little. Elsewhere it is a mesh
 * with half the elements; tensions are of second order, so that with n and m elements the error of
 * the first is the difference over (n/m)^2 - 1. Where a cable leaves an obstacle within an element,
 * the error depends on the place as well, and may be small by chance: there it is over n/m - 1, and
 * the larger one of two meshes, with a half and two thirds of the elements. Three meshes, with four
 * fifths too, are taken in a current by a table and on a bed with heights, whose corners are somewhere
 * within elements; beds are rounded over the elements of each mesh. At a
 * joint of two cables that lies on an obstacle, what of it each half element lays down is not known:
 * both tensions are the same there, and their difference is an error too.
 *
 * Refinement: a cable that is off may be so because of one that ends at the same joint; both get
 * more elements. Where a cable folds, the order is 1, so that it takes several rounds.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "contact/heights.h"
#include "core/report.h"
#include "net/statics/solve.h"

/* Wanted of the tensions, relative; elements are chosen for half of it. */
static const double TARGET = 1e-3, SAFE = 0.5;
/* Tensions below this part of the largest one of the net are compared with that part. */
static const double SMALL = 0.01;
/* A round that leaves more of the error has not helped: after two the cause is elsewhere, as in
 * cables whose elements are given. */
static const double BETTER = 0.7;
/* Rounds of refinement, largest factor of a round, and most elements that are chosen for a cable: a
 * motion with more takes minutes. */
enum { ROUNDS = 6, FASTER = 4, MOST = 400, LIKELY = 100 }; /* LIKELY: of a cable that gives no number */

enum hawser_status hawser__net_exact(struct hawser_net_statics *exact, int *found,
                                     const struct hawser_net *net, const struct hawser_net_statics *st,
                                     struct hawser_report *report)
{
	const struct hawser_net_options options = {.method = "catenary"};
	struct hawser_net by = *net;
	struct hawser_report unused = {0};
	enum hawser_status status;

	*found = 0;
	by.cable = malloc((size_t)by.cables*sizeof *by.cable);
	if (!by.cable)
		return hawser__no_memory(report, "net");
	memcpy(by.cable, net->cable, (size_t)net->cables*sizeof *net->cable);
	for (int c = 0; c < net->cables; c++) {
		by.cable[c].given = HAWSER_NET_LENGTH0;
		by.cable[c].value = st->member[c].length0;
	}
	status = net->surfaces || net->bodies || net->water.density > 0.0
	         ? HAWSER_ERR_ARGUMENT : hawser_net_solve(exact, &by, &options, &unused);
	free(by.cable);
	*found = status == HAWSER_OK;
	return status == HAWSER_ERR_MEMORY ? hawser__no_memory(report, "net") : HAWSER_OK;
}

double hawser__net_rounding(const struct hawser_net *net)
{
	double most = 0.0;

	for (int c = 0; c < net->cables; c++)
		if (net->cable[c].given == HAWSER_NET_LENGTH0)
			most = fmax(most, net->cable[c].value/(net->cable[c].elements > 0 ? net->cable[c].elements
			                                                                 : LIKELY));
	return most;
}

static void clear_beds(struct hawser_net *by)
{
	for (int s = 0; s < by->surfaces && by->surface; s++)
		hawser_heights_free(by->surface[s].heights);
	free(by->surface);
}

/* The obstacles of a net with other elements: beds are rounded over them. */
static enum hawser_status beds(struct hawser_net *by, struct hawser_report *report)
{
	const struct hawser_surface *from = by->surface;
	double round = hawser__net_rounding(by);
	enum hawser_status status = HAWSER_OK;

	by->surface = malloc(((size_t)by->surfaces + 1)*sizeof *by->surface);
	for (int s = 0; s < by->surfaces && by->surface; s++) {
		by->surface[s] = from[s];
		by->surface[s].heights = NULL;
	}
	for (int s = 0; s < by->surfaces && by->surface && !status; s++) {
		const struct hawser_heights *of = from[s].heights;

		if (of)
			status = hawser_heights_make(&by->surface[s].heights, of->nx, of->x, of->nz, of->z, of->y,
			                             from[s].rounding > 0.0 ? from[s].rounding : round, report);
	}
	return by->surface ? status : hawser__no_memory(report, "net");
}

/* The net with this part of the elements or, where cables have one, with two. */
static enum hawser_status coarse(struct hawser_net_statics *other, int *found, double *ratio,
                                 double part, const struct hawser_net *net,
                                 struct hawser_report *report)
{
	struct hawser_net by = *net;
	struct hawser_report unused = {0};
	enum hawser_status status = HAWSER_OK;

	*found = 0;
	if (net->contact.history) /* another mesh may slide at other times */
		return HAWSER_OK;
	for (int i = 0; i < net->loads; i++)
		if (net->load[i].along) /* is of one mesh */
			return HAWSER_OK;
	by.cable = malloc((size_t)by.cables*sizeof *by.cable);
	if (!by.cable)
		return hawser__no_memory(report, "net");
	memcpy(by.cable, net->cable, (size_t)net->cables*sizeof *net->cable);
	for (int c = 0; c < net->cables; c++) {
		by.cable[c].elements = net->cable[c].elements > 1 ? (int)ceil(part*net->cable[c].elements) : 2;
		ratio[c] = (double)net->cable[c].elements/by.cable[c].elements;
	}
	status = beds(&by, &unused);
	if (!status)
		status = hawser_net_solve(other, &by, NULL, &unused);
	clear_beds(&by);
	free(by.cable);
	*found = status == HAWSER_OK;
	return status == HAWSER_ERR_MEMORY ? hawser__no_memory(report, "net") : HAWSER_OK;
}

static void note(struct hawser_net_mesh_error *error, double *each, int c, double off)
{
	each[c] = fmax(each[c], off);
	if (each[c] > error->tension) {
		error->tension = each[c];
		error->cable = c;
	}
}

/* 1 if nothing but cables pulls at a node. */
static int bare(const struct hawser_net *net, int node)
{
	const struct hawser_net_node *of = &net->node[node];
	int pulls = of->support || of->body || of->mass > 0.0 || of->buoy.volume > 0.0 ||
	            of->buoy.CdA > 0.0;

	for (int i = 0; i < net->loads; i++)
		pulls |= net->load[i].node == node;
	return !pulls;
}

/* The tensions of two cables at their joint, which are the same. */
static void joints(struct hawser_net_mesh_error *error, double *each, const struct hawser_net *net,
                   const struct hawser_net_statics *st, double most)
{
	for (int i = 0; i < net->nodes; i++) {
		int end[2], ends = 0;
		double T[2], off;

		for (int j = 0; j < 2*net->cables && ends < 3; j++)
			if ((j % 2 ? net->cable[j/2].to : net->cable[j/2].from) == i) {
				if (ends < 2) {
					end[ends] = j/2;
					T[ends] = j % 2 ? st->member[j/2].T_to : st->member[j/2].T_from;
				}
				ends++;
			}
		if (ends != 2 || !bare(net, i))
			continue;
		off = fabs(T[1] - T[0]);
		for (int j = 0; j < 2; j++)
			note(error, each, end[j], off/fmax(st->member[end[j]].T_max, SMALL*most));
	}
}

/* each [cables]: the errors of the cables, if they are larger than what is there. */
static void compare(struct hawser_net_mesh_error *error, double *each, const struct hawser_net *net,
                    const struct hawser_net_statics *st, const struct hawser_net_statics *other,
                    const double *ratio, int touches)
{
	double most = 0.0;

	error->tension = isnan(error->tension) ? 0.0 : error->tension;
	for (int c = 0; c < st->cables; c++)
		most = fmax(most, st->member[c].T_max);
	for (int c = 0; c < st->cables; c++) {
		const struct hawser_net_member *a = &st->member[c], *b = &other->member[c];
		double off = fmax(fmax(fabs(a->T_max - b->T_max), fabs(a->T_min - b->T_min)),
		                  fmax(fabs(a->T_from - b->T_from), fabs(a->T_to - b->T_to)));

		if (!error->exact)
			off /= fmax(fabs((touches ? ratio[c] : ratio[c]*ratio[c]) - 1.0), 0.1);
		note(error, each, c, off > 0.0 && most > 0.0 ? off/fmax(a->T_max, SMALL*most) : 0.0);
	}
	if (touches && most > 0.0)
		joints(error, each, net, st, most);
}

/* 1 if an obstacle is a bed with heights. */
static int bent(const struct hawser_net *net)
{
	int is = 0;

	for (int s = 0; s < net->surfaces; s++)
		is |= net->surface[s].heights != NULL;
	return is;
}

static enum hawser_status measure(struct hawser_net_mesh_error *error, double *each,
                                  const struct hawser_net *net, const struct hawser_net_statics *st,
                                  struct hawser_report *report)
{
	struct hawser_net_statics other = {0};
	double *ratio = calloc((size_t)net->cables + 1, sizeof *ratio);
	enum hawser_status status = ratio ? HAWSER_OK : hawser__no_memory(report, "net");
	static const double part[] = {0.5, 2.0/3.0, 0.8};
	int found = 0, tries = net->water.levels > 1 || bent(net) ? 3 : net->surfaces ? 2 : 1;

	*error = (struct hawser_net_mesh_error){.tension = NAN, .cable = -1};
	memset(each, 0, (size_t)net->cables*sizeof *each);
	if (!status)
		status = hawser__net_exact(&other, &found, net, st, report);
	error->exact = found;
	for (int i = 0; i < tries && !status; i++) {
		if (!error->exact)
			status = coarse(&other, &found, ratio, part[i], net, report);
		if (!status && found)
			compare(error, each, net, st, &other, ratio, net->surfaces > 0);
		hawser_net_statics_clear(&other);
	}
	free(ratio);
	return status;
}

enum hawser_status hawser_net_mesh_error(struct hawser_net_mesh_error *error,
                                         const struct hawser_net *net,
                                         const struct hawser_net_statics *st,
                                         struct hawser_report *report)
{
	struct hawser_net_statics own = {0};
	struct hawser_report unused = {0};
	double *each = calloc((size_t)net->cables + 1, sizeof *each);
	enum hawser_status status = each ? HAWSER_OK : hawser__no_memory(report, "net");

	*error = (struct hawser_net_mesh_error){.tension = NAN, .cable = -1};
	if (!status && !st && hawser_net_solve(&own, net, NULL, &unused) == HAWSER_OK)
		st = &own;
	if (!status && st && net->cables) /* a body on a hinge may have none */
		status = measure(error, each, net, st, report);
	hawser_net_statics_clear(&own);
	free(each);
	return status;
}

/* The largest error of a cable and of those that end at the same joints. */
static double around(const struct hawser_net *net, const double *each, int c)
{
	const struct hawser_net_cable *a = &net->cable[c];
	double most = each[c];

	for (int i = 0; i < net->cables; i++) {
		const struct hawser_net_cable *b = &net->cable[i];
		int from = !net->node[a->from].support && (b->from == a->from || b->to == a->from);
		int to = !net->node[a->to].support && (b->from == a->to || b->to == a->to);

		most = from || to ? fmax(most, each[i]) : most;
	}
	return most;
}

static void round_beds(struct hawser_net *net)
{
	for (int s = 0; s < net->surfaces; s++)
		if (net->surface[s].heights && !(net->surface[s].rounding > 0.0))
			hawser__heights_round(net->surface[s].heights, hawser__net_rounding(net));
}

/* More elements for the cables whose number is not given; returns 0 if none needs them. */
static int more(struct hawser_net *net, const double *each)
{
	int any = 0;

	for (int c = 0; c < net->cables; c++) {
		struct hawser_net_cable *cable = &net->cable[c];
		double off = around(net, each, c), factor = sqrt(off/(SAFE*TARGET));
		int n = cable->elements;

		if (cable->elements_given || !(off > TARGET) || n >= MOST)
			continue;
		n = (int)fmin(ceil(n*fmin(factor, FASTER)), MOST);
		any |= n > cable->elements;
		cable->elements = n;
	}
	round_beds(net);
	return any;
}

enum hawser_status hawser_net_refine(struct hawser_net *net, struct hawser_report *report)
{
	double *each = calloc((size_t)net->cables + 1, sizeof *each), least = INFINITY;
	int *best = calloc((size_t)net->cables + 1, sizeof *best), open = 0, idle = 0;
	enum hawser_status status = each && best ? HAWSER_OK : hawser__no_memory(report, "net");

	for (int c = 0; c < net->cables && !status; c++) {
		open |= !net->cable[c].elements_given;
		best[c] = net->cable[c].elements;
	}
	for (int round = 0; round < ROUNDS && open && !status; round++) {
		struct hawser_net_mesh_error error = {.tension = NAN};
		struct hawser_net_statics st = {0};
		struct hawser_report unused = {0};

		if (hawser_net_solve(&st, net, NULL, &unused) == HAWSER_OK)
			status = measure(&error, each, net, &st, report);
		hawser_net_statics_clear(&st);
		idle = error.tension < BETTER*least ? 0 : idle + 1;
		for (int c = 0; c < net->cables && error.tension < least; c++)
			best[c] = net->cable[c].elements;
		least = error.tension < least ? error.tension : least;
		open = !status && idle < 2 && more(net, each);
	}
	for (int c = 0; c < net->cables && best; c++)
		net->cable[c].elements = best[c];
	round_beds(net);
	free(each);
	free(best);
	return status;
}
