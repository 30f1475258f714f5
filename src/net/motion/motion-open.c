/* net/motion/motion-open.c - memory of a motion, and the reference from which it counts.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "net/motion/motion-contact.h"
#include "net/motion/motion-events.h"

/* Of the tensions and weights times lengths: less energy than this is round-off. */
static const double LEAST = 1e-12;

void hawser__motion_clear(struct hawser__motion *motion)
{
	if (!motion)
		return;
	free(motion->element);
	free(motion->reference); /* with all that has a vector at each node */
	free(motion->B);
	free(motion->springs);
	free(motion->stroke);
	free(motion->mass);
	free(motion->point);
	for (int i = 0; i < motion->tables; i++)
		hawser__support_clear(&motion->table[i]);
	free(motion->table);
	hawser__blocks_clear(motion->blocks);
	hawser__cvode_clear(motion->cvode);
	hawser__bodies_close(motion->bodies);
	hawser__water_motion_clear(motion->water);
	hawser__bed_clear(motion->bed);
	hawser__contact_clear(motion->contact);
	hawser__events_clear(motion->events);
	memset(motion, 0, sizeof *motion);
}

static enum hawser_status allocate(struct hawser__motion *motion, struct hawser_report *report)
{
	/* cppcheck-suppress uninitvar ; sizeof of its elements alone */
	double (**part[])[3] = {&motion->reference, &motion->base, &motion->u, &motion->v, &motion->a,
	                        &motion->u0, &motion->v0, &motion->a0, &motion->x, &motion->acc,
	                        &motion->vel, &motion->load, &motion->wave, &motion->r, &motion->past,
	                        &motion->past2, &motion->move};
	size_t parts = sizeof part/sizeof *part, nodes = (size_t)motion->nodes,
	       elements = (size_t)motion->elements + 1;
	double (*all)[3] = calloc(parts*nodes + 1, sizeof *all);

	for (size_t i = 0; i < parts; i++)
		*part[i] = all ? all + i*nodes : NULL;
	motion->element = calloc(elements, sizeof *motion->element);
	motion->B = calloc(elements, sizeof *motion->B);
	motion->mass = calloc(elements, sizeof *motion->mass);
	motion->point = calloc(nodes + 1, sizeof *motion->point);
	return all && motion->element && motion->B && motion->mass && motion->point
		? HAWSER_OK : hawser__no_memory(report, "net");
}

/* The reference: the mesh as it is. */
static void refer(struct hawser__motion *motion, int balanced, const unsigned char *loose)
{
	const struct hawser__mesh *mesh = motion->mesh;

	memcpy(motion->reference, mesh->q, (size_t)mesh->nodes*sizeof *mesh->q);
	memcpy(motion->base, mesh->force, (size_t)mesh->nodes*sizeof *mesh->force);
	for (int e = 0; e < mesh->elements; e++) {
		struct hawser__motion_element *el = &motion->element[e];
		double L0 = mesh->length0[e], T;

		el->a = mesh->end[e][0];
		el->b = mesh->end[e][1];
		el->rod = mesh->net && mesh->net->cable[mesh->cable[e]].rod;
		for (int k = 0; k < 3; k++)
			el->D[k] = mesh->q[el->b][k] - mesh->q[el->a][k];
		el->l_ref = sqrt(el->D[0]*el->D[0] + el->D[1]*el->D[1] + el->D[2]*el->D[2]);
		el->p_ref = el->l_ref - L0;
		el->k = mesh->EA[e]/L0;
		el->c = el->k*mesh->axial[e];
		motion->damps = fmax(motion->damps, el->c);
		el->m = mesh->rho[e]*L0;
		el->drag = mesh->alpha*L0;
		el->law = mesh->net && mesh->net->cable[mesh->cable[e]].rows
			? &mesh->net->cable[mesh->cable[e]] : NULL;
		el->length = hawser__mesh_length(mesh, e);
		el->offset = mesh->offset[e];
		el->zero = el->length - L0;
		T = hawser__elastic_tension(el, el->p_ref);
		hawser__motion_in_line(el, mesh->net ? &mesh->net->cable[mesh->cable[e]] : NULL, L0, T);
		motion->least_energy += LEAST*(T + el->m*mesh->g)*el->l_ref;
		for (int k = 0; k < 3 && T > 0.0; k++) {
			el->F_ref[k] = T*el->D[k]/el->l_ref;
			motion->base[el->a][k] += el->F_ref[k];
			motion->base[el->b][k] -= el->F_ref[k];
		}
	}
	for (int i = 0; i < mesh->nodes && balanced; i++)
		for (int k = 0; k < 3 && !(loose && loose[i]); k++)
			if (mesh->unknown[i][k] >= 0)
				motion->base[i][k] = 0.0;
	for (int i = 0; i < mesh->touches && balanced; i++) {
		const struct hawser__touch *touch = &mesh->touch[i];

		for (int k = 0; k < 3 && !(loose && loose[touch->node]); k++)
			if (mesh->unknown[touch->node][k] >= 0 && touch->r > 0.0)
				motion->base[touch->node][k] -= touch->r*touch->n[k] + touch->friction[k];
	}
}

enum hawser_status hawser__motion_open(struct hawser__motion *motion, struct hawser__mesh *mesh,
                                       const char *scheme, double rho_inf, int balanced,
                                       const unsigned char *loose, struct hawser_report *report)
{
	enum hawser_status status;
	int i = 0;

	memset(motion, 0, sizeof *motion);
	while ((motion->scheme = hawser__motion_scheme(i)) && scheme && *scheme &&
	       strcmp(motion->scheme->shown.name, scheme) != 0)
		i++;
	if (!motion->scheme)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "net", "there is no scheme %.40s", scheme);
	motion->mesh = mesh;
	motion->nodes = mesh->nodes;
	motion->elements = mesh->elements;
	motion->rho_inf = rho_inf;
	motion->far = 1.0/12.0;
	status = allocate(motion, report);
	if (!status)
		status = hawser__water_motion_open(motion, report);
	if (!status)
		status = hawser__attached_open(motion, report);
	if (!status)
		refer(motion, balanced, loose);
	if (!status)
		status = hawser__bed_open(motion, report);
	if (!status)
		status = hawser__blocks_open(&motion->blocks, mesh, report);
	if (!status)
		status = hawser__motion_begin(motion, report);
	if (status)
		hawser__motion_clear(motion);
	return status;
}
