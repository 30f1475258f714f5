/* study/accuracy/certificate_span.c - folds and peaks of a span's model, corrected in the mesh of the
 * same span. Its elements have the exact law, its modes are its own; of the span's model only the
 * frequency, the motion and the places where peaks are looked at are taken.
 *
 *   X_ij    part of mode i of the mesh in mode j of the span, by the mass of the mesh
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "net/span/span.h"
#include "statics/frame.h"
#include "study/accuracy/certificate.h"
#include "study/accuracy/landmark.h"
#include "study/accuracy/motions.h"

enum { PARTS = 48, /* elements, half of them in the second mesh; chosen: twice a net's cable's */
       UNIT = 8,  /* of them, in each part between attachments; of the second mesh: net_finer.c */
       WIDER = 2 }; /* modes of the mesh beyond as many as the span's, which may have another order */

static const double round_off = 1e-9; /* of places in elements */

/* Mode j of the span at the nodes of the mesh, m per unit of its coordinate. */
static void take_mode(double *row, const struct hawser__mesh *mesh, const struct hawser_modes *modes,
                      int j)
{
	const struct hawser_statics *st = &modes->statics;
	double S = 0.0;

	for (int e = 0; e < mesh->elements - 1; e++) {
		struct hawser_frame_point at;
		double local[3], v[3], u[3];

		S += mesh->length0[e];
		at = hawser_statics_frame(st, S/st->span.d);
		hawser_modes_at(modes, local, NULL, j, S/st->span.d);
		hawser__frame_out(v, &at, local);
		hawser_statics_to_global(st, u, v);
		for (int k = 0; k < 3; k++)
			row[mesh->unknown[mesh->end[e][1]][k]] = st->span.d*u[k];
	}
	for (int i = 0; i < mesh->absorbers; i++) /* the joints follow the ends, in their order */
		row[mesh->unknown[mesh->absorber[i].at][mesh->absorber[i].axis]] =
			st->span.d*modes->stroke[j*st->attachments + mesh->absorber[i].node - 2];
}

/* A scaled arclength by the cubic polynomial through four nodes of a part: a node, where it is one. */
static struct hawser__finite_place place_at(const struct hawser__mesh *mesh,
                                            const struct hawser_statics *st, double s)
{
	struct hawser__finite_place place = {.weight = {0.0}};
	double at = s*st->span.d;
	int c = 0, from = 0, first;

	for (int e = 0; e < mesh->elements - 1 && at > mesh->length0[e]*(1.0 + round_off); e++) {
		at -= mesh->length0[e];
		c = mesh->cable[e + 1];
		from = e + 1 - mesh->first[c];
	}
	at = from + at/mesh->length0[mesh->first[c]];
	first = (int)fmin(fmax(floor(at) - 1.0, 0.0), mesh->first[c + 1] - mesh->first[c] - 3);
	for (int i = 0; i < HAWSER__FINITE_NODES; i++) {
		int e = mesh->first[c] + first + i;

		place.node[i] = e < mesh->first[c + 1] ? mesh->end[e][0] : mesh->end[e - 1][1];
		place.weight[i] = 1.0;
		for (int k = 0; k < HAWSER__FINITE_NODES; k++)
			place.weight[i] *= k == i ? 1.0 : (at - first - k)/(i - k);
	}
	return place;
}

/* Of a point of the model: strokes are behind all others, in the order of their attachments. */
static struct hawser__finite_place point_at(const struct hawser__mesh *mesh,
                                            const struct hawser_statics *st,
                                            const struct hawser_rom *rom, int p)
{
	int stroke = p - rom->shapes.points + mesh->absorbers;

	return stroke < 0 ? place_at(mesh, st, rom->shapes.s[p])
	       : (struct hawser__finite_place){{mesh->absorber[stroke].at}, {1.0}};
}

enum hawser_status hawser__finites_turn(struct hawser__finites *all, const struct hawser_modes *modes,
                                        const struct hawser_rom *rom, struct hawser_report *report)
{
	const struct hawser__mesh *mesh = &all->source.modal.mesh;
	int n = all->source.n;
	double *part = hawser__numbers((size_t)n, 1);
	double *row = hawser__hold(&all->hold, (size_t)mesh->unknowns, sizeof *row);

	all->turn = hawser__hold(&all->hold, (size_t)n*(size_t)modes->n, sizeof *all->turn);
	if (!part || all->hold.short_of_memory) {
		free(part);
		return hawser__no_memory(report, "certificate");
	}
	for (int j = 0; j < modes->n; j++) {
		take_mode(row, mesh, modes, j);
		hawser__net_masses(&all->source, part, all->source.mode, n, row);
		for (int i = 0; i < n; i++)
			all->turn[i*modes->n + j] = part[i];
	}
	all->turned = modes->n;
	for (int p = 0; p < rom->shapes.points; p++) {
		all->mesh[0].place[p] = point_at(mesh, &modes->statics, rom, p);
		all->mesh[1].place[p] = point_at(&all->mesh[1].own, &modes->statics, rom, p);
	}
	free(part);
	return HAWSER_OK;
}

/* Its loads are multiples of the response's frequency, and its modes have the scene's ratios. */
static enum hawser_status mesh_of(struct hawser_net *net, const struct hawser_scene *scene,
                                  const struct hawser_statics *statics, int halved,
                                  struct hawser_report *report)
{
	const struct hawser_net_span_options options = {.elements = PARTS, .Omega = 1.0};
	struct hawser_scene own = *scene; /* its `name` is the caller's */
	enum hawser_status status;

	if (own.damping.kind == HAWSER_DAMPING_RATIO) {
		own.damping.kind = HAWSER_DAMPING_ALPHA;
		own.damping.alpha = 0.0;
	}
	status = hawser__net_span(net, &own, statics, &options, UNIT, halved, report);
	if (status)
		return status;
	net->ratio = scene->damping.kind == HAWSER_DAMPING_RATIO ? scene->damping.ratio : 0.0;
	for (int i = 0; i < net->loads + net->motions; i++) {
		struct hawser_net_load *load = i < net->loads ? &net->load[i] : &net->motion[i - net->loads];

		load->multiple = load->harmonic ? (int)lround(load->Omega) : 0;
	}
	return HAWSER_OK;
}

static enum hawser_status check(const struct hawser_scene *scene, const struct hawser_modes *modes,
                                const struct hawser_statics *statics, struct hawser_report *report)
{
	if (modes->n < 1 || modes->n + WIDER > HAWSER_NET_ROM_MODES)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "certificate",
		                    "%s: the model is one of modes, 1 to %d: give their number (--modes)",
		                    scene->name, HAWSER_NET_ROM_MODES - WIDER);
	for (int i = 0; i < statics->attachments; i++) {
		const struct hawser_attachment *at = &scene->attach[statics->attached[i].index];
		const double *e = at->absorber_direction;

		if (at->absorber_mass > 0.0 && (e[0] != 0.0) + (e[1] != 0.0) + (e[2] != 0.0) > 1)
			return hawser__fail(report, HAWSER_ERR_SCENE, "certificate", "%s: the stroke of an "
			                    "absorber is compared along an axis: its absorber_direction is "
			                    "oblique", scene->name);
	}
	return HAWSER_OK;
}

/* The sizes of all displacements of the model at a landmark, by its neighbours. */
static void take_sizes(struct hawser__certifying *w, double arc, int point)
{
	const struct hawser_frf *frf = w->frf;
	int sizes = 3*frf->probes;

	memset(w->size, 0, (size_t)sizes*sizeof *w->size);
	for (int i = 0; i < 3; i++) {
		const struct hawser_frf_point *own = &frf->point[point + i - 1];
		double weight = 1.0;

		for (int k = 0; k < 3; k++)
			if (k != i)
				weight *= (arc - frf->point[point + k - 1].arc)/
				          (own->arc - frf->point[point + k - 1].arc);
		cblas_daxpy(sizes, weight, frf->probe + (size_t)(point + i - 1)*(size_t)sizes, 1, w->size,
		            1);
	}
}

void hawser__certifying_others(struct hawser__certifying *w, const struct hawser_certified *item,
                               double omega, double size, int point)
{
	int sizes = 3*w->frf->probes;
	double *off = w->size + sizes;

	take_sizes(w, w->arc[item - w->to->item], point);
	hawser__finite_others(off, &w->first, item, item->exact_size/size, w->size, w->frf->probes);
	for (int i = 0; i < sizes; i++)
		w->others = fmax(w->others, off[i]);
	for (int k = 0; k < 2; k++) {
		const struct hawser_landmark *peak = &w->largest[k];

		if (peak->probe == item->probe && peak->axis == item->axis && peak->size == item->size)
			w->off[k] = item->distance;
		else if (peak->probe >= 0 && isnan(w->off[k]) && off[hawser__peak_column(peak)] > 0.0 &&
		         abs(hawser__nearest_point(w->frf, peak->arc) - point) <= HAWSER__CERTIFIED_NEAR)
			w->off[k] = fmax(off[hawser__peak_column(peak)], fabs(item->exact_omega/omega - 1.0)) +
			            hawser__peak_unread(peak);
	}
}

enum hawser_status hawser_span_certify(struct hawser_certificate *certificate,
                                       const struct hawser_scene *scene,
                                       const struct hawser_modes *modes, const struct hawser_rom *rom,
                                       const struct hawser_frf *frf, const struct hawser_landmark *peak,
                                       int peaks, double bearable, struct hawser_report *report)
{
	const struct hawser_net_rom_options options = {.n = modes->n + WIDER, .condensed = 1};
	struct hawser_net net = {.nodes = 0}, half = {.nodes = 0};
	const struct hawser__certified_by by = {.net = &net, .halved = &half, .options = &options,
	                                        .modes = modes};
	enum hawser_status status = check(scene, modes, &modes->statics, report);

	*certificate = (struct hawser_certificate){.distance = NAN};
	if (!status)
		status = mesh_of(&net, scene, &modes->statics, 0, report);
	if (!status)
		status = mesh_of(&half, scene, &modes->statics, 1, report);
	if (!status)
		status = hawser__certified(certificate, &by, rom, frf, peak, peaks, bearable, report);
	hawser_net_clear(&net);
	hawser_net_clear(&half);
	return status;
}
