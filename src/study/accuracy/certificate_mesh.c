/* study/accuracy/certificate_mesh.c - the meshes in which a model is corrected, and their motions: see
 * certificate.h. SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "study/accuracy/certificate.h"

enum { SERIES = 2*(HAWSER__CERTIFIED_ORDER + HAWSER__CERTIFIED_MORE) + 1 }; /* coefficients, at most */
static const double large_part = 0.5; /* of the size at a peak: others that count; chosen */

/* --- the corrector of a mesh --- */

static void metric(void *of, const double *y)
{
	hawser__mesh_balance_metric(&((struct hawser__finite *)of)->balance, y);
}

static double dot(void *of, const double *a, const double *b)
{
	return hawser__mesh_balance_dot(&((struct hawser__finite *)of)->balance, a, b);
}

static void correct(void *of, double *y, double *along, int *lost, double far)
{
	hawser__mesh_balance_correct(&((struct hawser__finite *)of)->balance, y, along, lost, far);
}

/* x and its derivatives by the phase, of coefficients. */
static void at_phase(double x[3], const double *c, int order, double phase)
{
	x[0] = c[0];
	x[1] = x[2] = 0.0;
	for (int k = 1; k <= order; k++) {
		double a = c[2*k - 1], b = c[2*k], cosine = cos(k*phase), sine = sin(k*phase);

		x[0] += a*cosine + b*sine;
		x[1] += k*(b*cosine - a*sine);
		x[2] -= k*k*(a*cosine + b*sine);
	}
}

/* The phase at which |x| is largest: the best of some, then Newton's method for x' = 0. */
static double largest_at(const double *c, int order)
{
	int many = 16*(order + 1);
	double best = 0.0, most = -1.0, x[3];

	for (int t = 0; t < many; t++) {
		at_phase(x, c, order, 2.0*M_PI*t/many);
		if (fabs(x[0]) > most) {
			most = fabs(x[0]);
			best = 2.0*M_PI*t/many;
		}
	}
	for (int i = 0; i < 4; i++) {
		at_phase(x, c, order, best);
		best -= fabs(x[1]) < 0.1*fabs(x[2]) ? x[1]/x[2] : 0.0;
	}
	return best;
}

/* The coefficients of what is extreme at a peak; 0: it does not move. */
static int series_of(double *c, const struct hawser__finite *finite,
                     const struct hawser_certified *peak, const double *y)
{
	const struct hawser__finite_place *place = &finite->place[peak->probe];
	int moves = 0;

	memset(c, 0, (size_t)finite->balance.width*sizeof *c);
	for (int i = 0; i < HAWSER__FINITE_NODES; i++) {
		const double *own = place->weight[i] == 0.0 ? NULL
			: hawser__mesh_balance_at(&finite->balance, y, place->node[i], peak->axis);

		moves |= own != NULL;
		if (own)
			cblas_daxpy(finite->balance.width, place->weight[i], own, 1, c, 1);
	}
	return moves;
}

static double size_of(void *of, double *slope, const struct hawser_certified *peak, const double *y,
                      const double *along)
{
	const struct hawser__finite *finite = of;
	int order = finite->balance.order;
	double x[3], rate[3], phase, c[SERIES], t[SERIES];

	*slope = 0.0;
	if (!series_of(c, finite, peak, y) || !series_of(t, finite, peak, along))
		return NAN;
	phase = largest_at(c, order);
	at_phase(x, c, order, phase);
	at_phase(rate, t, order, phase);
	*slope = x[0] < 0.0 ? -rate[0] : rate[0];
	return fabs(x[0]);
}

void hawser__finite_others(double *off, struct hawser__finite *finite,
                           const struct hawser_certified *peak, double grown, const double *size,
                           int points)
{
	double unused, of = size[3*peak->probe + peak->axis];
	double larger = size_of(finite, &unused, peak, finite->y, finite->along)/(of*grown);

	for (int i = 0; i < 3*points; i++) {
		const struct hawser_certified one = {.probe = i/3, .axis = i % 3};

		off[i] = size[i] > large_part*of
		         ? fabs(size_of(finite, &unused, &one, finite->y, finite->along)/(size[i]*larger) - 1.0)
		         : 0.0;
	}
}

struct hawser__corrector hawser__finite_corrector(struct hawser__finite *finite)
{
	return (struct hawser__corrector){.of = finite, .size = finite->balance.size, .metric = metric,
		.dot = dot, .correct = correct, .size_of = size_of};
}

/* --- meshes --- */

/* The same damping ratio for n modes phi [n][unknowns] of a mesh. */
static enum hawser_status set_ratio(struct hawser__finites *w, int number,
                                    const struct hawser__mesh *mesh, const double *phi,
                                    const double *omega, int n, struct hawser_report *report)
{
	struct hawser__finite_mesh *to = &w->mesh[number];
	size_t unknowns = (size_t)mesh->unknowns, all = 3*(size_t)mesh->nodes;
	double *own = hawser__numbers(unknowns, 1);

	to->modes = n;
	to->mode = hawser__hold(&w->hold, (size_t)n*all, sizeof *to->mode);
	to->rated = hawser__hold(&w->hold, (size_t)n, sizeof *to->rated);
	for (int j = 0; own && !w->hold.short_of_memory && j < n; j++) {
		const double *from = phi + (size_t)j*unknowns;

		hawser__eigen_mass(own, from, mesh, 7U);
		to->rated[j] = 2.0*w->source.net->ratio*omega[j];
		cblas_dscal((int)unknowns, 1.0/sqrt(cblas_ddot((int)unknowns, own, 1, from, 1)), own, 1);
		for (size_t i = 0; i < all; i++)
			if (mesh->unknown[i/3][i%3] >= 0)
				to->mode[(size_t)j*all + i] = own[mesh->unknown[i/3][i%3]];
	}
	free(own);
	return own && !w->hold.short_of_memory ? HAWSER_OK : hawser__no_memory(report, "certificate");
}

/* Of all modes of the mesh, the ones along the cable too, as models with the exact energy have it; with
 * the absorbers held, as of spans (rom/terms/absorbers.c). */
static enum hawser_status rate_all(struct hawser__finites *w, int number, struct hawser_report *report)
{
	struct hawser__mesh mesh = number ? w->mesh[number].own : w->source.modal.mesh;
	const struct hawser_net *net = number ? &w->mesh[number].net : &w->fine;
	int (*unknown)[3] = hawser__hold(&w->hold, (size_t)mesh.nodes, sizeof *unknown);
	struct hawser__eigen eigen;
	enum hawser_status status;

	if (!unknown)
		return hawser__no_memory(report, "certificate");
	memcpy(unknown, mesh.unknown, (size_t)mesh.nodes*sizeof *unknown);
	for (int i = 0; i < mesh.absorbers; i++)
		unknown[mesh.absorber[i].at][mesh.absorber[i].axis] = -1;
	mesh.unknown = unknown;
	hawser__mesh_number(&mesh);
	status = hawser__eigen_open(&eigen, &mesh, w->mesh[number].T, net, -mesh.unknowns, report);
	if (!status)
		status = hawser__eigen_dense(&eigen, report);
	for (int j = 0; j < eigen.found && !status; j++)
		eigen.value[j] = sqrt(eigen.value[j]);
	if (!status)
		status = set_ratio(w, number, &mesh, eigen.x, eigen.value, eigen.found, report);
	hawser__eigen_clear(&eigen);
	return status;
}

/* Of the modes of the model. */
static enum hawser_status rate_kept(struct hawser__finites *w, int number, struct hawser_report *report)
{
	const struct hawser__net_source *source = &w->source;
	const struct hawser__mesh *fine = &source->modal.mesh, *own = number ? &w->mesh[number].own : fine;
	size_t n = (size_t)source->n;
	double *phi = hawser__numbers(n*(size_t)own->unknowns, 1), *omega = hawser__numbers(n, 1);
	enum hawser_status status = phi && omega ? HAWSER_OK : hawser__no_memory(report, "certificate");

	for (int i = 0; i < 3*source->n*own->nodes && !status; i++) {
		int j = i/(3*own->nodes), node = i/3%own->nodes, k = i%3, at = own->unknown[node][k];

		omega[j] = source->modal.modes.omega[source->kept[j]];
		if (at >= 0)
			phi[j*own->unknowns + at] = source->mode[(size_t)j*(size_t)fine->unknowns +
				(size_t)fine->unknown[number ? w->mesh[number].from[node] : node][k]];
	}
	if (!status)
		status = set_ratio(w, number, own, phi, omega, source->n, report);
	free(phi);
	free(omega);
	return status;
}

enum hawser_status hawser__finite_open(struct hawser__finite *finite, struct hawser__finites *w,
                                       int number, int order, struct hawser_report *report)
{
	const struct hawser__finite_mesh *of = &w->mesh[number];
	const struct hawser_net *net = w->source.net;
	struct hawser__mesh_balance *balance = &finite->balance;
	enum hawser_status status = HAWSER_OK;

	finite->mesh = number ? &w->mesh[number].own : &w->source.modal.mesh;
	finite->place = of->place;
	if (net->ratio > 0.0 && !of->mode)
		status = w->turn ? rate_all(w, number, report) : rate_kept(w, number, report);
	if (!status)
		status = hawser__mesh_balance_open(balance, finite->mesh, net->mass_rate, order, report);
	if (status)
		return status;
	balance->mode = of->mode;
	balance->rated = of->rated;
	balance->modes = of->modes;
	balance->ratio = net->ratio;
	balance->stroke_ratio = w->turn ? 0.0 : net->ratio;
	balance->modal = hawser__hold(&finite->hold, 2*(size_t)of->modes*(size_t)balance->width + 1,
	                              sizeof(double));
	finite->y = hawser__hold(&finite->hold, balance->size, sizeof *finite->y);
	finite->along = hawser__hold(&finite->hold, balance->size, sizeof *finite->along);
	return finite->hold.short_of_memory ? hawser__no_memory(report, "certificate") : HAWSER_OK;
}

void hawser__finite_clear(struct hawser__finite *finite)
{
	hawser__mesh_balance_clear(&finite->balance);
	hawser__hold_clear(&finite->hold);
	*finite = (struct hawser__finite){.mesh = NULL};
}

/* Nodes of a mesh among those of the first, and the points of the model there. */
static void pair_nodes(struct hawser__finites *w, struct hawser__finite_mesh *to)
{
	const struct hawser__mesh *fine = &w->source.modal.mesh, *own = &to->own;

	for (int i = 0; i < w->fine.nodes; i++)
		to->from[i] = i;
	for (int i = 0; i < own->absorbers; i++)
		to->from[own->absorber[i].at] = fine->absorber[i].at;
	for (int c = 0; c < own->cables; c++) {
		int count = own->first[c + 1] - own->first[c];
		int ratio = (fine->first[c + 1] - fine->first[c])/count;

		for (int i = 1; i < count; i++)
			to->from[own->inner[c] + i - 1] = fine->inner[c] + ratio*i - 1;
	}
	for (int i = 0; i < own->nodes*w->source.shapes; i++)
		if (to->from[i%own->nodes] == w->mesh[0].place[i/own->nodes].node[0])
			to->place[i/own->nodes] = (struct hawser__finite_place){{i%own->nodes}, {1.0}};
}

/* A further mesh, in equilibrium. */
static enum hawser_status open_mesh(struct hawser__finites *w, int number, const struct hawser_net *net,
                                    int halvings, struct hawser_report *report)
{
	const struct hawser__mesh_options choice = {.method = NULL};
	struct hawser__finite_mesh *to = &w->mesh[number];
	struct hawser__equilibrium found;
	enum hawser_status status = hawser__net_finer(&to->net, net, halvings, report);

	if (!status)
		status = hawser__mesh_build(&to->own, &to->net, report);
	if (status)
		return status;
	to->T = hawser__hold(&w->hold, (size_t)to->own.elements, sizeof *to->T);
	to->from = hawser__hold(&w->hold, (size_t)to->own.nodes, sizeof *to->from);
	to->place = hawser__hold(&w->hold, hawser__net_points(&w->fine), sizeof *to->place);
	if (w->hold.short_of_memory)
		return hawser__no_memory(report, "certificate");
	status = hawser__mesh_form(&to->own, to->T, &found, &to->net, &choice, report);
	hawser__absorbers_release(&to->own, HAWSER__NET_SPACE);
	if (!status)
		status = hawser__net_multiples(&to->own, net->name, report);
	pair_nodes(w, to);
	return status;
}

enum hawser_status hawser__finites_third(struct hawser__finites *w,
                                         const struct hawser__certified_by *by,
                                         struct hawser_report *report)
{
	if (w->mesh[2].opened)
		return HAWSER_OK;
	w->mesh[2].opened = 1;
	return open_mesh(w, 2, by->net, 2, report);
}

/* The nodes of the model's points: all are nodes of all meshes. */
static enum hawser_status find_nodes(struct hawser__finites *w, struct hawser_report *report)
{
	struct hawser__net_source *source = &w->source;
	size_t most = hawser__net_points(&w->fine);
	char **name = calloc(most, sizeof *name);
	enum hawser_status status = name ? hawser__net_places(source, name, report)
	                                 : hawser__no_memory(report, "certificate");

	for (size_t i = 0; name && i < most; i++)
		free(name[i]);
	free(name);
	w->mesh[0].place = hawser__hold(&w->hold, most, sizeof *w->mesh[0].place);
	if (!status && w->hold.short_of_memory)
		status = hawser__no_memory(report, "certificate");
	for (int p = 0; !status && p < source->shapes; p++)
		w->mesh[0].place[p] = (struct hawser__finite_place){
			{source->place[p].node[source->place[p].share > 0.5]}, {1.0}};
	return status;
}

enum hawser_status hawser__finites_open(struct hawser__finites *w,
                                        const struct hawser__certified_by *by,
                                        struct hawser_report *report)
{
	enum hawser_status status = hawser__net_source_open(&w->source, &w->fine, &w->answers, by->net,
	                                                    by->options, report);

	w->mesh[0].T = w->source.modal.T;
	if (!status)
		status = find_nodes(w, report);
	return status ? status : open_mesh(w, 1, by->halved ? by->halved : by->net, !by->halved, report);
}

void hawser__finites_clear(struct hawser__finites *w)
{
	hawser__answers_clear(&w->answers);
	hawser__net_source_clear(&w->source);
	for (int i = 0; i < HAWSER__FINITE_MESHES; i++) {
		hawser__mesh_clear(&w->mesh[i].own);
		free(w->mesh[i].net.cable);
	}
	free(w->fine.cable);
	hawser__hold_clear(&w->hold);
}

/* --- motions --- */

/* The motion of one mesh or order, on another. from: the nodes there; NULL: the same. */
void hawser__finite_copy(double *to, const struct hawser__finite *of, const double *y,
                        const struct hawser__finite *other, const int *from)
{
	int width = of->balance.width < other->balance.width ? of->balance.width : other->balance.width;

	memset(to, 0, of->balance.size*sizeof *to);
	for (int i = 0; i < 3*of->mesh->nodes; i++) {
		const double *own = hawser__mesh_balance_at(&other->balance, y, from ? from[i/3] : i/3, i%3);
		int row = of->balance.blocks.row[i/3];

		if (own && row >= 0)
			memcpy(to + (3*row + i%3)*of->balance.width, own, (size_t)width*sizeof *to);
	}
	to[of->balance.size - 1] = y[other->balance.size - 1];
}

/* Part of a motion by its two last harmonics. */
double hawser__finite_last(const struct hawser__finite *finite)
{
	int width = finite->balance.width;
	double all = 0.0, last = 0.0;

	for (size_t i = 0; i < finite->balance.size - 1; i++) {
		double own = finite->y[i]*finite->y[i];

		all += own;
		last += (int)(i%(size_t)width) >= width - 4 ? own : 0.0;
	}
	return sqrt(last/all);
}

