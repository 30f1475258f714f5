/* net/mesh.c - the mesh of a net: nodes, elements, weight and loads; see net/net.h.
 *
 * q        positions, [nodes][3]
 * length0  unstretched length of an element
 *
 * Weight and loads of an element go half to each of its ends. The inner nodes start on the chord, which
 * no method of statics needs.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "core/report.h"
#include "net/body.h"
#include "net/water/water.h"

/* Bytes that the statics of an element take, with the factors: measured on nets of Table 3.1. */
enum { BYTES = 2500 };

void hawser__mesh_clear(struct hawser__mesh *mesh)
{
	if (!mesh)
		return;
	hawser__hold_clear(&mesh->hold);
	free(mesh->frame);
	free(mesh->touch);
	free(mesh->edge);
	free(mesh->rotor);
	memset(mesh, 0, sizeof *mesh);
}

/* Number of elements and nodes; fails where the machine has not the memory for them. */
static enum hawser_status count(struct hawser__mesh *mesh, const struct hawser_net *net,
                                struct hawser_report *report)
{
	double elements = 0.0, need;
	double have = (double)sysconf(_SC_PHYS_PAGES)*(double)sysconf(_SC_PAGESIZE);

	for (int i = 0; i < net->cables; i++)
		elements += net->cable[i].elements;
	need = elements*BYTES;
	if (elements > 1e8 || (have > 0.0 && need > have))
		return hawser__fail(report, HAWSER_ERR_SCENE, "net",
		                    "%s: %.0f elements need about %.1f GiB of memory, and this machine has "
		                    "%.1f GiB: give `elements` smaller numbers", net->name, elements,
		                    need/1073741824.0, have/1073741824.0);
	mesh->cables = net->cables;
	mesh->elements = (int)elements;
	mesh->nodes = net->nodes + mesh->elements - net->cables + net->absorbers +
	              HAWSER__BODY_POINTS*net->bodies;
	return HAWSER_OK;
}

static size_t waves_of(const struct hawser_net *net, const struct hawser_net_load *load)
{
	return !load->harmonic ? 0 : load->cable < 0 ? 1 : (size_t)net->cable[load->cable].elements + 1;
}

static enum hawser_status allocate(struct hawser__mesh *mesh, const struct hawser_net *net,
                                   struct hawser_report *report)
{
	size_t elements = (size_t)mesh->elements + 1, waves = 1;
	size_t nodes = (size_t)mesh->nodes + (size_t)net->failures + 1; /* see net/motion/motion-events.h */

	for (int i = 0; i < net->loads; i++)
		waves += waves_of(net, &net->load[i]);
	mesh->first = hawser__hold(&mesh->hold, (size_t)mesh->cables + 1, sizeof *mesh->first);
	mesh->inner = hawser__hold(&mesh->hold, (size_t)mesh->cables + 1, sizeof *mesh->inner);
	mesh->end = hawser__hold(&mesh->hold, elements, sizeof *mesh->end);
	mesh->cable = hawser__hold(&mesh->hold, elements, sizeof *mesh->cable);
	mesh->length0 = hawser__hold(&mesh->hold, elements, sizeof *mesh->length0);
	mesh->EA = hawser__hold(&mesh->hold, elements, sizeof *mesh->EA);
	mesh->offset = hawser__hold(&mesh->hold, elements, sizeof *mesh->offset);
	mesh->stored = hawser__hold(&mesh->hold, elements, sizeof *mesh->stored);
	mesh->density = hawser__hold(&mesh->hold, elements, sizeof *mesh->density);
	mesh->rho = hawser__hold(&mesh->hold, elements, sizeof *mesh->rho);
	mesh->axial = hawser__hold(&mesh->hold, elements, sizeof *mesh->axial);
	mesh->q = hawser__hold(&mesh->hold, nodes, sizeof *mesh->q);
	mesh->unknown = hawser__hold(&mesh->hold, nodes, sizeof *mesh->unknown);
	mesh->rigid = hawser__hold(&mesh->hold, nodes, sizeof *mesh->rigid);
	mesh->mass = hawser__hold(&mesh->hold, nodes, sizeof *mesh->mass);
	mesh->damper = hawser__hold(&mesh->hold, nodes, sizeof *mesh->damper);
	mesh->spring = hawser__hold(&mesh->hold, nodes, sizeof *mesh->spring);
	mesh->absorber = hawser__hold(&mesh->hold, (size_t)net->absorbers + 1, sizeof *mesh->absorber);
	mesh->force = hawser__hold(&mesh->hold, nodes, sizeof *mesh->force);
	mesh->wave = hawser__hold(&mesh->hold, waves, sizeof *mesh->wave);
	mesh->motion = hawser__hold(&mesh->hold, (size_t)net->motions + 1, sizeof *mesh->motion);
	return mesh->hold.short_of_memory ? hawser__no_memory(report, "net") : HAWSER_OK;
}

/* Elements of one cable, and its inner nodes from number `node`. */
static void chain(struct hawser__mesh *mesh, const struct hawser_net_cable *cable, int number, int node,
                  double axial)
{
	int first = mesh->first[number], n = cable->elements;
	const double *a = mesh->q[cable->from], *b = mesh->q[cable->to];

	mesh->inner[number] = n > 1 ? node : -1;
	for (int i = 0; i < n; i++) {
		int e = first + i;

		mesh->end[e][0] = i ? node + i - 1 : cable->from;
		mesh->end[e][1] = i < n - 1 ? node + i : cable->to;
		mesh->cable[e] = number;
		mesh->EA[e] = cable->EA;
		mesh->rho[e] = cable->rho;
		mesh->axial[e] = axial + cable->axial;
		mesh->length0[e] = cable->given == HAWSER_NET_LENGTH0 ? cable->value/n : 0.0;
		for (int k = 0; i < n - 1 && k < 3; k++) {
			mesh->q[node + i][k] = a[k] + (b[k] - a[k])*(i + 1)/n;
			mesh->unknown[node + i][k] = cable->rod ? -1 : 0;
		}
		if (i < n - 1)
			mesh->rigid[node + i] = cable->rod;
	}
}

void hawser__mesh_number(struct hawser__mesh *mesh)
{
	int next = 0;

	for (int i = 0; i < mesh->nodes; i++)
		for (int k = 0; k < 3; k++)
			mesh->unknown[i][k] = mesh->unknown[i][k] < 0 ? -1 : next++;
	mesh->unknowns = next;
}

void hawser__mesh_hold(struct hawser__mesh *mesh, int node, const unsigned char held[3])
{
	for (int k = 0; k < 3; k++)
		mesh->unknown[node][k] = held[k] ? -1 : 0;
	hawser__mesh_number(mesh);
}

void hawser__mesh_axis(double axis[3], const struct hawser__mesh *mesh, int node, int k)
{
	for (int i = 0; i < 3; i++)
		axis[i] = mesh->frame ? mesh->frame[node][k][i] : i == k;
}

void hawser__mesh_along(struct hawser__mesh *mesh, unsigned along)
{
	for (int i = 0; i < mesh->nodes; i++)
		for (int k = 0; k < 3; k++)
			if (!(along & (1U << k)))
				mesh->unknown[i][k] = -1;
	hawser__mesh_number(mesh);
}

void hawser__mesh_flatten(struct hawser__mesh *mesh, int k, double place)
{
	for (int i = 0; i < mesh->nodes; i++)
		mesh->q[i][k] = place;
	hawser__mesh_along(mesh, 7U & ~(1U << k));
}

/* Loads and motions of supports are numbers: later steps would spread what is none. */
static enum hawser_status numbers(const struct hawser_net *net, struct hawser_report *report)
{
	for (int i = 0; i < net->loads + net->motions; i++) {
		const struct hawser_net_load *load = i < net->loads ? &net->load[i]
		                                                    : &net->motion[i - net->loads];
		double sum = load->value[0] + load->value[1] + load->value[2];

		if (!isfinite(sum) || (load->harmonic && !isfinite(load->Omega + load->phase)))
			return hawser__fail(report, HAWSER_ERR_NAN, "net", "%s: the %s of %s %s is not finite: "
			                    "(%g, %g, %g), Omega %g rad/s, phase %g", net->name,
			                    i < net->loads ? "load" : "motion", load->cable < 0 ? "node" : "cable",
			                    load->cable < 0 ? net->node[load->node].name
			                                    : net->cable[load->cable].name,
			                    load->value[0], load->value[1], load->value[2], load->Omega,
			                    load->phase);
	}
	return HAWSER_OK;
}

enum hawser_status hawser__mesh_build(struct hawser__mesh *mesh, const struct hawser_net *net,
                                      struct hawser_report *report)
{
	enum hawser_status status;
	int node = net->nodes;

	memset(mesh, 0, sizeof *mesh);
	status = numbers(net, report);
	if (!status)
		status = count(mesh, net, report);
	if (!status)
		status = allocate(mesh, net, report);
	if (status) {
		hawser__mesh_clear(mesh);
		return status;
	}
	mesh->net = net;
	mesh->g = net->g;
	mesh->alpha = net->alpha;
	for (int i = 0; i < net->nodes; i++) {
		memcpy(mesh->q[i], net->node[i].x, sizeof mesh->q[i]);
		mesh->mass[i] = net->node[i].mass;
		mesh->rigid[i] = net->node[i].body;
		memcpy(mesh->damper[i], net->node[i].damper, sizeof mesh->damper[i]);
		memcpy(mesh->spring[i], net->node[i].spring, sizeof mesh->spring[i]);
		for (int k = 0; k < 3; k++)
			mesh->unknown[i][k] = net->node[i].held[k] ? -1 : 0;
	}
	for (int i = 0; i < net->cables; i++) {
		chain(mesh, &net->cable[i], i, node, net->axial);
		node += net->cable[i].elements - 1;
		mesh->first[i + 1] = mesh->first[i] + net->cable[i].elements;
	}
	hawser__absorbers_open(mesh, net, node);
	hawser__bodies_open(mesh, net, node + net->absorbers);
	hawser__mesh_number(mesh);
	status = hawser__water_open(mesh, net, report);
	if (status) {
		hawser__mesh_clear(mesh);
		return status;
	}
	hawser__mesh_load(mesh, net);
	mesh->motions = net->motions;
	for (int i = 0; i < net->motions; i++) {
		const struct hawser_net_load *from = &net->motion[i];

		mesh->motion[i] = (struct hawser__mesh_wave){
			.node = from->node, .value = {from->value[0], from->value[1], from->value[2]},
			.Omega = from->Omega, .phase = from->phase, .multiple = from->multiple};
	}
	status = hawser__touch_open(mesh, net, report);
	if (status)
		hawser__mesh_clear(mesh);
	return status;
}

double hawser__mesh_carried(const struct hawser__mesh *mesh, const struct hawser_net_load *load,
                            int element, int side)
{
	int first = mesh->first[mesh->cable[element]], last = mesh->first[mesh->cable[element] + 1];
	double L = hawser__mesh_length(mesh, element), S = 0.0, all = 0.0, a, b, middle;

	if (!(load->extent[1] > 0.0))
		return 0.5*L;
	for (int e = first; e < last; e++) {
		S += e < element ? hawser__mesh_length(mesh, e) : 0.0;
		all += hawser__mesh_length(mesh, e);
	}
	a = fmax(S, load->extent[0]*all);
	b = fmin(S + L, load->extent[1]*all);
	middle = (0.5*(a + b) - S)/L;
	return b > a ? (b - a)*(side ? middle : 1.0 - middle) : 0.0;
}

/* Add a load to the constant forces or, if it is harmonic, to the waves. */
static void load(struct hawser__mesh *mesh, const struct hawser_net_load *from)
{
	int first = from->cable < 0 ? 0 : mesh->first[from->cable];
	int n = from->cable < 0 ? 0 : mesh->first[from->cable + 1] - first;
	double number = n > 0 && from->wavelength != 0.0 ? 2.0*M_PI/from->wavelength : 0.0, S = 0.0;

	for (int i = 0; i <= n; i++) {
		int at = n == 0 ? from->node : i < n ? mesh->end[first + i][0] : mesh->end[first + n - 1][1];
		double half = n == 0 ? 1.0
			: (i < n ? hawser__mesh_carried(mesh, from, first + i, 0) : 0.0) +
			  (i > 0 ? hawser__mesh_carried(mesh, from, first + i - 1, 1) : 0.0);
		struct hawser__mesh_wave *wave = &mesh->wave[mesh->waves];

		if (from->harmonic)
			*wave = (struct hawser__mesh_wave){.node = at, .Omega = from->Omega,
			                                   .phase = from->phase - number*S,
			                                   .multiple = from->multiple};
		for (int k = 0; k < 3; k++)
			*(from->harmonic ? &wave->value[k] : &mesh->force[at][k]) +=
				from->along ? from->along[i][k] : half*from->value[k];
		mesh->waves += from->harmonic;
		S += i < n ? hawser__mesh_length(mesh, first + i) : 0.0;
	}
}

void hawser__mesh_load(struct hawser__mesh *mesh, const struct hawser_net *net)
{
	mesh->waves = 0;
	for (int i = 0; i < mesh->nodes; i++) {
		mesh->force[i][0] = mesh->force[i][2] = 0.0;
		mesh->force[i][1] = -mesh->mass[i]*mesh->g;
	}
	for (int e = 0; e < mesh->elements; e++)
		for (int end = 0; end < 2; end++)
			mesh->force[mesh->end[e][end]][1] -= mesh->rho[e]*mesh->length0[e]*mesh->g/2.0;
	for (int i = 0; i < net->loads; i++)
		load(mesh, &net->load[i]);
	if (mesh->water) {
		memcpy(mesh->water->dead, mesh->force, (size_t)mesh->nodes*sizeof *mesh->force);
		hawser__water_load(mesh);
	}
}

double hawser__mesh_direction(double e[3], const struct hawser__mesh *mesh, int element)
{
	const double *a = mesh->q[mesh->end[element][0]], *b = mesh->q[mesh->end[element][1]];
	double l;

	for (int k = 0; k < 3; k++)
		e[k] = b[k] - a[k];
	l = sqrt(e[0]*e[0] + e[1]*e[1] + e[2]*e[2]);
	for (int k = 0; l > 0.0 && k < 3; k++)
		e[k] /= l;
	return l;
}

void hawser__mesh_gradient(double (*residual)[3], double *T, const struct hawser__mesh *mesh)
{
	for (int i = 0; i < mesh->nodes; i++)
		for (int k = 0; k < 3; k++)
			residual[i][k] = -mesh->force[i][k];
	for (int i = 0; i < mesh->elements; i++) {
		double e[3], l = hawser__mesh_direction(e, mesh, i), p = l - mesh->length0[i];
		double tension = mesh->density[i] > 0.0 ? mesh->density[i]*l
			: p > 0.0 ? mesh->EA[i]/mesh->length0[i]*p : 0.0;

		for (int k = 0; k < 3; k++) {
			residual[mesh->end[i][0]][k] -= tension*e[k];
			residual[mesh->end[i][1]][k] += tension*e[k];
		}
		if (T)
			T[i] = tension;
	}
}

double hawser__mesh_floor(const struct hawser__mesh *mesh)
{
	double most = 0.0;

	for (int i = 0; i < mesh->elements; i++) {
		const double *a = mesh->q[mesh->end[i][0]], *b = mesh->q[mesh->end[i][1]];
		double reach = mesh->length0[i];

		if (mesh->density[i] > 0.0)
			continue;
		for (int k = 0; k < 3; k++)
			reach = fmax(reach, fmax(fabs(a[k]), fabs(b[k])));
		most = fmax(most, mesh->EA[i]/mesh->length0[i]*reach*DBL_EPSILON);
	}
	return 2.0*most;
}
