/* study/accuracy/certificate_span.c - folds and peaks of a span's model, corrected in the mesh of the
 * same span. Its elements have the exact law, its modes are its own; of the span's model only the
 * frequency, the motion and the places where peaks are looked at are taken.
 *
 *   X_ij    part of mode i of the mesh in mode j of the span, by the mass of the mesh
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "net/span/span.h"
#include "statics/frame.h"
#include "study/accuracy/certificate.h"

enum { PARTS = 48, /* elements, half of them in the second mesh; chosen: twice a net's cable's */
       WIDER = 2 }; /* modes of the mesh beyond as many as the span's, which may have another order */

/* Mode j of the span at the nodes of the mesh, m per unit of its coordinate. */
static void take_mode(double *row, const struct hawser__mesh *mesh, const struct hawser_modes *modes,
                      int j)
{
	const struct hawser_statics *st = &modes->statics;
	int elements = mesh->first[1];

	for (int i = 1; i < elements; i++) {
		double s = st->length0/st->span.d*i/elements, local[3], v[3], u[3];
		struct hawser_frame_point at = hawser_statics_frame(st, s);

		hawser_modes_at(modes, local, NULL, j, s);
		hawser__frame_out(v, &at, local);
		hawser_statics_to_global(st, u, v);
		for (int k = 0; k < 3; k++)
			row[mesh->unknown[mesh->inner[0] + i - 1][k]] = st->span.d*u[k];
	}
}

/* The node at a scaled arclength. */
static int node_at(const struct hawser__mesh *mesh, const struct hawser_statics *st, double s)
{
	int elements = mesh->first[1], i = (int)lround(s*st->span.d/st->length0*elements);

	return i <= 0 ? 0 : i >= elements ? 1 : mesh->inner[0] + i - 1;
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
		all->node[0][p] = node_at(mesh, &modes->statics, rom->shapes.s[p]);
		all->node[1][p] = node_at(&all->coarse, &modes->statics, rom->shapes.s[p]);
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
	status = hawser__net_span(net, &own, statics, &options, halved, report);
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
	if (statics->attachments > 0)
		return hawser__fail(report, HAWSER_ERR_SCENE, "certificate",
		                    "%s: a span with attachments is corrected as a net: give the parts "
		                    "between them as its cables", scene->name);
	return HAWSER_OK;
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
