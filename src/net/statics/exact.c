/* net/statics/exact.c - statics with exact elements: every cable is one elastic catenary, only
 * the joints are unknown. The method is that of net/statics/dual.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "core/vec3.h"
#include "net/statics/dual.h"

/* Exact catenaries start a mesh if they are found in so many iterations: another start costs less
 * than more of them. */
enum { FEW = 40 };
/* Unknowns of the mesh over those of the joints from which catenaries start it. Below, an iteration of
 * theirs costs as much as one of the mesh, of which they save fewer than they take. */
enum { PART = 4 };

enum hawser_status hawser__exact_open(struct hawser__exact *exact, const struct hawser_net *net,
                                      struct hawser_report *report)
{
	static const char *const word[] = {"length0", "tension", "force_density", "sag"};
	size_t cables = (size_t)net->cables;
	struct hawser_net joints = *net;
	enum hawser_status status;

	memset(exact, 0, sizeof *exact);
	status = hawser__mesh_lawless(net, "the method catenary", report);
	if (status)
		return status;
	for (int c = 0; c < net->cables; c++)
		if (net->cable[c].given != HAWSER_NET_LENGTH0)
			return hawser__fail(report, HAWSER_ERR_SCENE, "net",
			                    "%s: the method catenary takes cables with length0 only, and cable %s "
			                    "has %s: find its length with another method first", net->name,
			                    net->cable[c].name, word[net->cable[c].given]);
	for (int i = 0; i < net->loads; i++)
		if (net->load[i].extent[1] > 0.0 && !net->load[i].harmonic)
			return hawser__fail(report, HAWSER_ERR_SCENE, "net", "%s: the method catenary takes loads "
			                    "of whole cables, and that of cable %s has an extent: choose another "
			                    "method", net->name, net->cable[net->load[i].cable].name);
	joints.absorbers = 0; /* their masses are in those of their nodes */
	joints.cable = malloc(cables*sizeof *joints.cable);
	if (!joints.cable)
		return hawser__no_memory(report, "net");
	for (int c = 0; c < net->cables; c++) {
		joints.cable[c] = net->cable[c];
		joints.cable[c].elements = 1;
	}
	status = hawser__mesh_build(&exact->mesh, &joints, report);
	free(joints.cable);
	if (!status)
		status = hawser__dual_open(&exact->dual, &exact->mesh, report);
	if (!status && exact->mesh.unknowns)
		status = hawser__sparse_open(&exact->dual.sparse, &exact->mesh, report);
	for (int c = 0; !status && c < net->cables; c++)
		exact->dual.cable[c].p[1] = -net->cable[c].rho*net->g;
	for (int i = 0; !status && i < net->loads; i++)
		for (int k = 0; net->load[i].cable >= 0 && !net->load[i].harmonic && k < 3; k++)
			exact->dual.cable[net->load[i].cable].p[k] += net->load[i].value[k];
	return status;
}

void hawser__exact_clear(struct hawser__exact *exact)
{
	hawser__sparse_clear(exact->dual.sparse);
	hawser__dual_clear(&exact->dual);
	hawser__mesh_clear(&exact->mesh);
}

/* Energy, and how far it may be above the least one; step = force that belongs to the chord minus
 * F. */
static double energy_of(double *gap, struct hawser__dual *dual)
{
	const struct hawser__mesh *mesh = dual->mesh;
	double sum = 0.0;

	*gap = 0.0;
	for (int c = 0; c < mesh->elements; c++) {
		double K[3][3], r[3], d[3], Kr[3];

		hawser__dual_linear(K, r, dual, c);
		for (int k = 0; k < 3; k++) {
			d[k] = mesh->q[mesh->end[c][1]][k] - mesh->q[mesh->end[c][0]][k];
			Kr[k] = hawser__dot(K[k], r);
		}
		sum += hawser__dot(dual->F[c], d) - hawser__catenary(NULL, NULL, &dual->cable[c], dual->F[c]);
		*gap += hawser__dot(r, Kr) + dual->cable[c].soft*dual->cable[c].length0;
		memcpy(dual->step[c], Kr, sizeof Kr);
	}
	for (int i = 0; i < mesh->nodes; i++)
		sum -= hawser__dot(mesh->force[i], mesh->q[i]);
	return sum + *gap/2.0;
}

enum hawser_status hawser__exact_solve(struct hawser__exact *exact, struct hawser__equilibrium *found,
                                       double tolerance, int most, struct hawser_report *report)
{
	struct hawser__dual *dual = &exact->dual;
	int done;
	enum hawser_status status;

	*found = (struct hawser__equilibrium){.method = "catenary"};
	status = hawser__dual_solve(dual, &done, &found->residual, tolerance > 0.0 ? tolerance : 1e-10,
	                            most, report);
	found->iterations = dual->iterations;
	found->floor = hawser__mesh_floor(&exact->mesh);
	if (status)
		return status;
	found->energy = energy_of(&found->gap, dual);
	if (!done)
		return hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, "net", found->iterations,
		                       found->residual,
		                       "the equilibrium was not found by the method catenary: after %d "
		                       "iterations the largest force that is not balanced is %.3g N, and "
		                       "round-off allows %.3g N", found->iterations, found->residual,
		                       found->floor);
	for (int c = 0; c < exact->mesh.elements; c++)
		for (int k = 0; k < 3; k++)
			dual->F[c][k] += dual->step[c][k];
	return HAWSER_OK;
}

/* 1 if every cable has a length, and if joints have few of the unknowns of the mesh. */
static int worth(const struct hawser__mesh *mesh, const struct hawser_net *net)
{
	int joints = 0;

	for (int c = 0; c < net->cables; c++)
		if (net->cable[c].given != HAWSER_NET_LENGTH0)
			return 0;
	for (int i = 0; i < net->nodes; i++)
		for (int k = 0; k < 3; k++)
			joints += mesh->unknown[i][k] >= 0;
	return PART*joints <= mesh->unknowns;
}

int hawser__exact_start(struct hawser__mesh *mesh, double *N, const struct hawser_net *net)
{
	struct hawser__exact exact = {0};
	struct hawser__equilibrium found;
	struct hawser_report report = {0};
	int fine = worth(mesh, net) && !hawser__exact_open(&exact, net, &report) &&
	           !hawser__exact_solve(&exact, &found, 1e-6, FEW, &report);

	for (int i = 0; fine && i < net->nodes; i++)
		memcpy(mesh->q[i], exact.mesh.q[i], sizeof mesh->q[i]);
	for (int c = 0; fine && c < net->cables; c++) {
		const double *from = exact.mesh.q[exact.mesh.end[c][0]];
		int first = mesh->first[c], n = mesh->first[c + 1] - first;

		for (int i = 0; i < n; i++) {
			double x[3], t[3], step = exact.dual.cable[c].length0/n;

			hawser__catenary_point(x, t, &exact.dual.cable[c], exact.dual.F[c], step*(i + 0.5));
			N[first + i] = sqrt(hawser__dot(t, t));
			hawser__catenary_point(x, t, &exact.dual.cable[c], exact.dual.F[c], step*(i + 1));
			for (int k = 0; i < n - 1 && k < 3; k++)
				mesh->q[mesh->end[first + i][1]][k] = from[k] + x[k];
		}
	}
	hawser__exact_clear(&exact);
	return fine;
}
