/* net/span/span-statics.c - statics of a span by its mesh, and what the mesh is off from the catenary.
 *
 * The force in the cable at an end is that of the support: with the weight of half an element there it
 * is of order 2, and the tension of the first element of order 1.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "core/vec3.h"
#include "net/span/span.h"

void hawser_net_span_statics_clear(struct hawser_net_span_statics *mesh)
{
	if (!mesh)
		return;
	free(mesh->point);
	memset(mesh, 0, sizeof *mesh);
}

/* Force in the direction of +S at an end, in the axes of the statics. */
static void pull(double f[3], const struct hawser_net_statics *from, int end,
                 const struct hawser_statics *st)
{
	for (int k = 0; k < 3; k++)
		f[k] = (end ? 1.0 : -1.0)*from->reaction[end][k];
	hawser_statics_from_global(st, f, f);
}

static void forces(struct hawser_statics *to, const struct hawser_net_statics *from)
{
	double a[3], b[3];

	pull(a, from, 0, to);
	pull(b, from, 1, to);
	to->T0 = hawser__norm(a);
	to->T1 = hawser__norm(b);
	to->V0 = a[1];
	to->V1 = b[1];
	to->H = hypot(a[0], a[2]);
	to->closure = 0.0;
	to->error = from->floor/to->H;
	to->eta = to->V0/to->H;
	to->epsilon = to->H/to->span.EA;
	to->delta = to->span.rho*to->span.g*to->span.d/to->H;
}

/* Nodes, without those of attachments twice. */
static void points(struct hawser_net_span_statics *mesh, const struct hawser_net *net,
                   const struct hawser_net_statics *from)
{
	const struct hawser_statics *st = &mesh->statics;
	double begin = 0.0;

	for (int i = 0; i < from->points; i++) {
		const struct hawser_net_point *p = &from->point[i];
		struct hawser_profile_point *to = &mesh->point[mesh->points];
		double x[3];

		if (i > 0 && p->cable != from->point[i - 1].cable) {
			begin += net->cable[p->cable - 1].value;
			mesh->point[mesh->points - 1].T = 0.5*(from->point[i - 1].T + p->T);
			continue;
		}
		hawser_statics_from_global(st, x, p->x);
		*to = (struct hawser_profile_point){.S = begin + p->S, .x = x[0], .y = x[1], .z = x[2],
		                                    .T = p->T};
		mesh->points++;
	}
	mesh->point[0].T = st->T0;
	mesh->point[mesh->points - 1].T = st->T1;
	for (int i = 0; i < mesh->points; i++) {
		const struct hawser_profile_point *a = &mesh->point[i > 0 ? i - 1 : 0];
		const struct hawser_profile_point *b = &mesh->point[i < mesh->points - 1 ? i + 1 : i];

		const double chord[3] = {b->x - a->x, b->y - a->y, b->z - a->z};
		double length = hawser__norm(chord);

		mesh->point[i].slope = chord[1]/hypot(chord[0], chord[2]);
		for (int c = 0; c < 3; c++)
			mesh->point[i].tangent[c] = chord[c]/length;
	}
	mesh->point[0].slope = st->V0/st->H;
	if (!st->space)
		mesh->point[mesh->points - 1].slope = st->V1/st->H;
}

/* Length, sag, and the distance from the catenary. */
static void measure(struct hawser_net_span_statics *mesh, const struct hawser_statics *exact)
{
	double length = 0.0, sag = 0.0, far = 0.0, d = exact->span.d, h = exact->span.h;

	for (int i = 0; i < mesh->points; i++) {
		const struct hawser_profile_point *p = &mesh->point[i];
		struct hawser_profile_point at = hawser_statics_at(exact, fmin(p->S, exact->length0));

		sag = fmax(sag, h/d*p->x - p->y);
		far = fmax(far, hawser__norm((double[3]){p->x - at.x, p->y - at.y, p->z - at.z}));
		if (i > 0)
			length += hawser__norm((double[3]){p->x - p[-1].x, p->y - p[-1].y, p->z - p[-1].z});
	}
	mesh->statics.length = length;
	mesh->statics.sag = sag;
	mesh->error.place = far;
}

static double off(double value, double exact)
{
	return exact > 0.0 ? value/exact - 1.0 : 0.0;
}

static void compare(struct hawser_net_span_statics *mesh, const struct hawser_statics *exact)
{
	const struct hawser_statics *st = &mesh->statics;
	struct hawser_net_span_error *error = &mesh->error;

	error->H = off(st->H, exact->H);
	error->T0 = off(st->T0, exact->T0);
	error->T1 = off(st->T1, exact->T1);
	error->length = off(st->length, exact->length);
	error->sag = off(st->sag, exact->sag);
}

enum hawser_status hawser_net_span_solve(struct hawser_net_span_statics *mesh,
                                         const struct hawser_scene *scene,
                                         const struct hawser_statics *statics, int elements,
                                         struct hawser_report *report)
{
	const struct hawser_net_span_options options = {.elements = elements, .still = 1};
	struct hawser_net net;
	struct hawser_net_statics found = {0};
	enum hawser_status status;

	memset(mesh, 0, sizeof *mesh);
	status = hawser_net_span(&net, scene, statics, &options, report);
	if (status)
		return status;
	status = hawser_net_solve(&found, &net, NULL, report);
	if (!status && !(mesh->point = calloc((size_t)found.points + 1, sizeof *mesh->point)))
		status = hawser__no_memory(report, "net");
	if (!status) {
		mesh->statics = *statics;
		mesh->method = found.method;
		mesh->residual = found.residual;
		mesh->floor = found.floor;
		mesh->elements = found.points - net.cables;
		forces(&mesh->statics, &found);
		points(mesh, &net, &found);
		measure(mesh, statics);
		compare(mesh, statics);
	}
	hawser_net_statics_clear(&found);
	hawser_net_clear(&net);
	return status;
}
