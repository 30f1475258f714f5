/* net/modes/modes.c - modes of a mesh: see hawser/net_modes.h and net/modes/eigen.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <cblas.h>

#include <hawser/net_modes.h>

#include "core/hold.h"
#include "core/report.h"
#include "net/body.h"
#include "net/statics/solve.h"
#include "net/modes/symmetry.h"
#include "net/touch/touch.h"

/* omega^2 over lift that counts as 0: round-off. */
static const double STILL = 1e-9;

void hawser_net_modes_clear(struct hawser_net_modes *modes)
{
	if (!modes)
		return;
	hawser__hold_clear(&(struct hawser__hold){.last = modes->held});
	free(modes->contact);
	free(modes->state);
	memset(modes, 0, sizeof *modes);
}

static enum hawser_status allocate(struct hawser_net_modes *modes, struct hawser_report *report)
{
	size_t n = (size_t)modes->n, points = (size_t)modes->points;
	struct hawser__hold hold = {0};

	modes->omega = hawser__hold(&hold, n, sizeof *modes->omega);
	modes->mass = hawser__hold(&hold, n, sizeof *modes->mass);
	modes->share = hawser__hold(&hold, n, sizeof *modes->share);
	modes->along = hawser__hold(&hold, n, sizeof *modes->along);
	modes->residual = hawser__hold(&hold, n, sizeof *modes->residual);
	modes->corners = hawser__hold(&hold, n, sizeof *modes->corners);
	modes->parity = hawser__hold(&hold, n, sizeof *modes->parity);
	modes->waves = hawser__hold(&hold, n, sizeof *modes->waves);
	modes->pair = hawser__hold(&hold, n, sizeof *modes->pair);
	modes->shape = hawser__hold(&hold, n*(size_t)modes->nodes + 1, sizeof *modes->shape);
	modes->point = hawser__hold(&hold, n*points + 1, sizeof *modes->point);
	modes->place = hawser__hold(&hold, points + 1, sizeof *modes->place);
	modes->cable = hawser__hold(&hold, points + 1, sizeof *modes->cable);
	modes->S = hawser__hold(&hold, points + 1, sizeof *modes->S);
	modes->held = hold.last;
	return hold.short_of_memory ? hawser__no_memory(report, "net") : HAWSER_OK;
}

/* Scale a vector so that the largest displacement of a node is 1, its largest component positive. */
static void scale(double *phi, const struct hawser__mesh *mesh)
{
	double most = 0.0, sign = 1.0, x[3];

	for (int i = 0; i < mesh->nodes; i++) {
		double length;

		hawser__eigen_place(x, phi, mesh, i);
		length = sqrt(x[0]*x[0] + x[1]*x[1] + x[2]*x[2]);
		if (length > most*(1.0 + 1e-6)) {
			int k = fabs(x[1]) > fabs(x[0]) ? 1 : 0;

			most = length;
			k = fabs(x[2]) > fabs(x[k]) ? 2 : k;
			sign = x[k] < 0.0 ? -1.0 : 1.0;
		}
	}
	for (int i = 0; i < mesh->unknowns; i++)
		phi[i] *= sign/most;
}

/* Part of the kinetic energy that is motion along cables; of cables without mass by their length. */
static double along(const double *phi, const struct hawser__mesh *mesh)
{
	double part[2] = {0.0}, all[2] = {0.0}; /* by mass, by length */

	for (int e = 0; e < mesh->elements; e++) {
		double d[3], u[3];

		hawser__mesh_direction(d, mesh, e);
		for (int i = 0; i < 4; i++) {
			double weight = i/2 ? mesh->length0[e] : mesh->rho[e]*mesh->length0[e], a;

			hawser__eigen_place(u, phi, mesh, mesh->end[e][i%2]);
			a = u[0]*d[0] + u[1]*d[1] + u[2]*d[2];
			part[i/2] += weight*a*a;
			all[i/2] += weight*(u[0]*u[0] + u[1]*u[1] + u[2]*u[2]);
		}
	}
	return all[0] > 0.0 ? part[0]/all[0] : all[1] > 0.0 ? part[1]/all[1] : 0.0;
}

/* What corners may add to omega^2, or take off, of a vector with x'*M*x = 1. Where a node of an
 * element of length h and tension T slides along a circle by u, and the other one is on the
 * straight part, the length of the polygon has a second derivative between -h/(2*R^2) and
 * h/(6*R^2), which depends on where the point of contact is within the element. */
static double corners(const double *x, const struct hawser__eigen *eigen)
{
	const struct hawser__mesh *mesh = eigen->mesh;
	double sum = 0.0;

	for (int i = 0; i < mesh->edges; i++) {
		const struct hawser__touch *touch = &mesh->touch[mesh->edge[i].touch];
		double u[3], along = 0.0, curved = touch->H[0][0] + touch->H[1][1];
		int e = mesh->edge[i].element;

		hawser__eigen_place(u, x, mesh, touch->node);
		for (int k = 0; k < 9; k++)
			along += u[k/3]*touch->H[k/3][k%3]*u[k%3];
		sum += 0.5*fmax(eigen->T[e], 0.0)*mesh->length0[e]*fabs(curved*along);
	}
	return sum;
}

/* Of the eigenvalue of K + lift*M. 0 where it may be so; the error is then that of omega^2 + lift. */
static void frequency(struct hawser_net_modes *modes, const struct hawser__eigen *eigen, int j)
{
	double value = eigen->value[j] - eigen->lift;

	modes->corners[j] = sqrt(corners(eigen->x + (size_t)j*(size_t)eigen->mesh->unknowns, eigen));
	modes->residual[j] = eigen->error[j];
	if (eigen->lift > 0.0 && value <= STILL*eigen->lift) {
		modes->omega[j] = 0.0;
		return;
	}
	modes->omega[j] = sqrt(value);
	modes->residual[j] *= eigen->value[j]/value;
}

/* Fail where an eigenvalue is below 0, by more than what corners do. */
static enum hawser_status stable(const struct hawser__eigen *eigen, struct hawser_report *report)
{
	for (int j = 0; j < eigen->found && eigen->lift > 0.0; j++) {
		double value = eigen->value[j] - eigen->lift;

		if (value >= -STILL*eigen->lift - corners(eigen->x + (size_t)j*(size_t)eigen->mesh->unknowns,
		                                          eigen))
			continue;
		if (eigen->mesh->body)
			return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "net", "%s: the equilibrium is not "
			                    "stable: a mode has omega^2 = %.6g rad^2/s^2; give bodies more "
			                    "buoyancy above their weight, or lines that hold them", eigen->name,
			                    value);
		return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "net", "%s: the equilibrium is not "
		                    "stable: along the obstacles it has a mode with omega^2 = %.6g "
		                    "rad^2/s^2, the net would slide off: look at the sides of obstacles, "
		                    "or give them friction and contact.modes: stick", eigen->name, value);
	}
	return HAWSER_OK;
}

static void fill(struct hawser_net_modes *modes, struct hawser__eigen *eigen, int j, double *y)
{
	const struct hawser__mesh *mesh = eigen->mesh;
	double *phi = eigen->x + (size_t)j*(size_t)mesh->unknowns;
	int p = 0;

	frequency(modes, eigen, j);
	scale(phi, mesh);
	modes->along[j] = along(phi, mesh);
	hawser__eigen_mass(y, phi, mesh, 7U);
	modes->mass[j] = cblas_ddot(mesh->unknowns, phi, 1, y, 1);
	for (int k = 0; k < 3; k++) {
		hawser__eigen_mass(y, phi, mesh, 1U << k);
		modes->share[j][k] = cblas_ddot(mesh->unknowns, phi, 1, y, 1)/modes->mass[j];
	}
	for (int i = 0; i < modes->nodes; i++)
		hawser__eigen_place(modes->shape[j*modes->nodes + i], phi, mesh, i);
	for (int c = 0; c < mesh->cables; c++) {
		double S = 0.0;

		for (int e = mesh->first[c]; e <= mesh->first[c + 1]; e++, p++) {
			int last = e == mesh->first[c + 1];

			hawser__eigen_place(modes->point[(size_t)j*(size_t)modes->points + (size_t)p], phi, mesh,
			                    mesh->end[last ? e - 1 : e][last]);
			memcpy(modes->place[p], mesh->q[mesh->end[last ? e - 1 : e][last]],
			       sizeof modes->place[p]);
			modes->cable[p] = c;
			modes->S[p] = S;
			S += last ? 0.0 : mesh->length0[e];
		}
	}
}

static enum hawser_status solve(struct hawser_net_modes *modes, struct hawser__eigen *eigen,
                                struct hawser_report *report)
{
	const struct hawser__mesh *mesh = eigen->mesh;
	double *y = malloc(((size_t)mesh->unknowns + 1)*sizeof *y);
	struct hawser__net_maps maps = {.found.turns = 1};
	enum hawser_status status = y ? HAWSER_OK : hawser__no_memory(report, "net");

	modes->n = eigen->n;
	modes->points = mesh->elements + mesh->cables;
	modes->slack = eigen->slack;
	if (!status)
		status = allocate(modes, report);
	if (!status)
		status = hawser__eigen_solve(eigen, report);
	if (!status)
		status = stable(eigen, report);
	if (!status && !mesh->body) /* bodies have no partners */
		status = hawser__net_maps_open(&maps, mesh, eigen->T, modes->nodes, report);
	modes->symmetry = maps.found;
	if (!status)
		status = hawser__net_modes_label(modes, eigen, &maps, report);
	for (int j = 0; j < modes->n && !status; j++)
		fill(modes, eigen, j, y);
	modes->below = eigen->shift > 0.0 ? sqrt(fmax(eigen->shift - eigen->lift, 0.0)) : eigen->shift;
	modes->counted = eigen->found;
	modes->iterations = eigen->iterations;
	modes->method = eigen->dense ? "dense" : "block Lanczos";
	hawser__net_maps_clear(&maps);
	free(y);
	return status;
}

/* The state of contact: what nodes do, the contacts of the result, and the directions left in the
 * mesh. */
static enum hawser_status contacts(struct hawser_net_modes *modes, struct hawser__mesh *mesh,
                                   const double *T, const struct hawser_net *net,
                                   struct hawser_report *report)
{
	unsigned char *state = malloc((size_t)mesh->nodes + 1);
	int node = 0, p = 0;
	enum hawser_status status;

	modes->state = calloc((size_t)(mesh->elements + mesh->cables) + 1, 1);
	modes->how = net->contact.modes;
	modes->doubtful = hawser__touch_doubtful(&node, mesh, T);
	status = state && modes->state ? hawser__touch_hold(state, mesh, net, modes->how, report)
		: hawser__no_memory(report, "net");
	if (!status)
		status = hawser__touch_list(&modes->contact, &modes->contacts, mesh, net->nodes, report);
	for (int i = 0, j = 0; i < mesh->touches && !status; i++)
		if (mesh->touch[i].r > 0.0)
			modes->contact[j++].sticks = state[mesh->touch[i].node] == HAWSER_NET_STICK;
	for (int c = 0; c < mesh->cables && !status; c++)
		for (int e = mesh->first[c]; e <= mesh->first[c + 1]; e++, p++) {
			int last = e == mesh->first[c + 1], at = mesh->end[last ? e - 1 : e][last];

			modes->state[p] = state[at];
			modes->barely = modes->doubtful && at == node ? p : modes->barely;
		}
	free(state);
	return status;
}

void hawser__net_modal_clear(struct hawser__net_modal *modal)
{
	hawser__eigen_clear(&modal->eigen);
	hawser__mesh_clear(&modal->mesh);
	hawser__bodies_unseat(&modal->seated, &modal->seated);
	free(modal->T);
	hawser_net_modes_clear(&modal->modes);
}

enum hawser_status hawser__net_modal_open(struct hawser__net_modal *modal,
                                          const struct hawser_net *given, int n, unsigned axes,
                                          struct hawser_report *report)
{
	struct hawser__mesh *mesh = &modal->mesh;
	struct hawser_net_modes *modes = &modal->modes;
	const struct hawser_net *net = &modal->seated;
	double rest;
	enum hawser_status status = hawser__bodies_seat(&modal->seated, &rest, given, 0, report);

	*modes = (struct hawser_net_modes){.nodes = given->nodes};
	modal->eigen = (struct hawser__eigen){.n = 0};
	modal->T = NULL;
	if (!status)
		status = hawser__mesh_build(mesh, net, report);
	if (!status)
		status = hawser__net_supported(mesh, net, report);
	if (!status && !(modal->T = calloc((size_t)mesh->elements + 1, sizeof *modal->T)))
		status = hawser__no_memory(report, "net");
	if (!status)
		status = hawser__net_equilibrium(mesh, modal->T, net, report);
	if (!status)
		status = hawser__bodies_land(mesh, net, report);
	if (!status && axes != HAWSER__NET_SPACE)
		hawser__mesh_along(mesh, axes);
	hawser__absorbers_release(mesh, status ? 0 : axes);
	if (!status && mesh->touches)
		status = contacts(modes, mesh, modal->T, net, report);
	if (!status)
		status = hawser__bodies_release(mesh, net, report);
	modes->unknowns = mesh->unknowns;
	if (!status)
		status = hawser__eigen_open(&modal->eigen, mesh, modal->T, net, n, report);
	if (!status)
		status = solve(modes, &modal->eigen, report);
	return status;
}

enum hawser_status hawser__net_modes(struct hawser_net_modes *modes, const struct hawser_net *net,
                                     int n, unsigned axes, struct hawser_report *report)
{
	struct hawser__net_modal modal = {.T = NULL};
	enum hawser_status status = hawser__net_modal_open(&modal, net, n, axes, report);

	*modes = modal.modes;
	modal.modes = (struct hawser_net_modes){.n = 0};
	hawser__net_modal_clear(&modal);
	if (status)
		hawser_net_modes_clear(modes);
	return status;
}

enum hawser_status hawser_net_modes_solve(struct hawser_net_modes *modes, const struct hawser_net *net,
                                          int n, struct hawser_report *report)
{
	return hawser__net_modes(modes, net, n, HAWSER__NET_SPACE, report);
}
