/* rom/build/net_fill.c - the entries of a net's model from its expansion.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "rom/build/model.h"
#include "rom/build/net.h"

double hawser__net_omega(const struct hawser__net_source *source, int j)
{
	return source->modal.modes.omega[source->kept[j]]*source->time;
}

double hawser__net_unit(const struct hawser__net_source *source)
{
	return source->mass*source->length*source->length;
}

const double *hawser__net_row(const struct hawser__net_source *source, int j)
{
	size_t unknowns = (size_t)source->modal.mesh.unknowns;

	return j < source->n ? source->mode + (size_t)j*unknowns
	                     : source->inertia.row + (size_t)(j - source->n)*unknowns;
}

static enum hawser_status set_matrices(struct hawser_rom *rom, const struct hawser__net_source *source,
                                       struct hawser_report *report)
{
	double unit = hawser__net_unit(source)/source->time;
	double (*shape)[3] = calloc((size_t)source->modal.mesh.nodes + 1, sizeof *shape);
	int n = rom->n;

	if (!shape)
		return hawser__no_memory(report, "net rom");
	for (int j = 0; j < n; j++) {
		rom->K[j*(n + 1)] = j < source->n ? hawser__net_omega(source, j)*hawser__net_omega(source, j)
		                                  : source->inertia.kappa2[j - source->n];
		if (!isfinite(rom->K[j*(n + 1)])) {
			free(shape);
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "net rom",
			                    "the mesh has no frequency of mode %d that coarser meshes confirm: "
			                    "give the cables more elements, or keep fewer modes", j + 1);
		}
		hawser__net_spread(shape, source, hawser__net_row(source, j));
		for (int k = 0; k <= j; k++)
			rom->D[j*n + k] = rom->D[k*n + j] =
				hawser__net_damping(source, (const double (*)[3])shape,
				                    hawser__net_row(source, k))/unit;
		rom->D[j*(n + 1)] += 2.0*source->net->ratio*sqrt(rom->K[j*(n + 1)]);
	}
	free(shape);
	return HAWSER_OK;
}

/* Forces on the coordinates, and the stiffness by the static response of the others. */
static enum hawser_status set_harmonics(struct hawser_rom *rom, const struct hawser__net_source *source,
                                        const struct hawser__answers *answers,
                                        struct hawser_report *report)
{
	int unknowns = source->modal.mesh.unknowns, elements = source->modal.mesh.elements, n = rom->n;
	int modes = source->n;
	double (*slope)[3] = calloc((size_t)elements + 1, sizeof *slope);

	rom->harmonic = calloc((size_t)source->waves + 1, sizeof *rom->harmonic);
	for (int i = 0; i < source->waves && rom->harmonic && slope; i++) {
		const struct hawser__net_wave *wave = &source->wave[i];
		struct hawser_harmonic *h = &rom->harmonic[rom->harmonics++];

		*h = (struct hawser_harmonic){.k = wave->k, .phase = wave->sine ? HAWSER_SIN : HAWSER_COS,
			.omega_power = wave->power, .f = hawser__numbers((size_t)n, 1),
			.K = hawser__numbers((size_t)n, (size_t)n)};
		if (!h->f || !h->K)
			break;
		for (int e = 0; e < elements; e++)
			hawser__nexpand_row_slope(slope[e], &source->t, e, answers->driven[i].field);
		for (int j = 0; j < modes; j++) {
			h->f[j] = cblas_ddot(unknowns, source->mode + (size_t)j*(size_t)unknowns, 1, wave->row, 1)/
			          (source->t.energy*pow(source->time, wave->power));
			for (int k = 0; k < modes; k++)
				h->K[j*n + k] = hawser__nexpand_third(&source->t, j, k, (const double (*)[3])slope);
		}
	}
	free(slope);
	return rom->harmonics == source->waves && rom->harmonic &&
	       (!rom->harmonics || rom->harmonic[rom->harmonics - 1].K) ? HAWSER_OK
	       : hawser__no_memory(report, "net rom");
}

static enum hawser_status set_labels(struct hawser_rom *rom, const struct hawser__net_source *source,
                                     struct hawser_report *report)
{
	const struct hawser_net_modes *modes = &source->modal.modes;

	rom->label = calloc((size_t)rom->n, sizeof *rom->label);
	for (int j = 0; rom->label && j < rom->n; j++) {
		int k = j < source->n ? source->kept[j] : -1;
		const char *side = k >= 0 && modes->symmetry.flat
		                   ? hawser_net_plane_side(modes->parity[k][0]) : NULL;
		char text[48];

		snprintf(text, sizeof text, "mode %d%s%s%s", k + 1, side ? " (" : "", side ? side : "",
		         side ? ")" : "");
		rom->label[j] = strdup(k < 0 ? "second-order shape" : text);
		if (!rom->label[j])
			return hawser__no_memory(report, "net rom");
	}
	return rom->label ? HAWSER_OK : hawser__no_memory(report, "net rom");
}

static enum hawser_status set_places(struct hawser_rom *rom, struct hawser__net_source *source,
                                     struct hawser_report *report)
{
	int points, n = rom->n;
	char **name = calloc(hawser__net_points(source->net), sizeof *name);
	enum hawser_status status = name ? hawser__net_places(source, name, report)
	                                 : hawser__no_memory(report, "net rom");

	points = source->shapes;
	if (!status)
		status = hawser__rom_init_shapes(rom, points, report);
	if (!status)
		status = hawser__rom_init_line(rom, source->places - points, report);
	for (int p = 0; name && p < points; p++) {
		if (status)
			free(name[p]);
		else
			rom->shapes.name[p] = name[p];
	}
	free(name);
	rom->shapes.EA = source->EA;
	for (int p = 0; p < source->places && !status; p++) {
		int own = p < points;
		double *s = own ? rom->shapes.s + p : rom->line.s + (p - points);
		double *stretch = own ? rom->shapes.stretch + p : rom->line.stretch + (p - points);

		*s = source->place[p].s/source->length;
		*stretch = hawser__net_place_stretch(source, p);
		if (own)
			rom->shapes.tangent[2*p] = 1.0;
		for (int j = 0; j < n; j++) {
			double unused[3];

			if (own)
				hawser__net_at(rom->shapes.shape + 3*(j*points + p),
				               rom->shapes.slope + 3*(j*points + p), source,
				               hawser__net_row(source, j), p);
			else
				hawser__net_at(unused, rom->line.slope + 3*(j*(source->places - points) + p - points),
				               source, hawser__net_row(source, j), p);
		}
	}
	return status;
}

enum hawser_status hawser__net_fill_first(struct hawser_rom *rom,
                                          const struct hawser__net_source *source, int whole,
                                          struct hawser_report *report)
{
	enum hawser_status status = hawser__rom_init(rom, source->n + source->inertia.found.shapes, report);

	if (status)
		return status;
	rom->length = source->length;
	rom->time = source->time;
	rom->force = source->force;
	rom->scaled = 1;
	rom->inertia = source->inertia.found;
	status = set_matrices(rom, source, report);
	return status ? status : hawser__net_wind_fill(rom, source, whole, report);
}

enum hawser_status hawser__net_fill(struct hawser_rom *rom, struct hawser__net_source *source,
                                    const struct hawser__answers *answers, struct hawser_report *report)
{
	const struct hawser__expanded e = hawser__net_expanded(source);
	enum hawser_status status = hawser__net_fill_first(rom, source, 1, report);

	if (!status)
		status = hawser__expanded_tensors(rom, &e, source->n, 0, report);
	if (!status)
		status = hawser__inertia_quads(rom, &source->inertia, report);
	if (!status)
		status = set_labels(rom, source, report);
	if (!status)
		status = set_places(rom, source, report);
	if (!status)
		status = hawser__expanded_pairs(rom, &e, report);
	if (!status)
		status = set_harmonics(rom, source, answers, report);
	if (!status)
		status = hawser__expanded_answers(rom, &e, answers, report);
	for (int i = 0; i < answers->ends && !status; i++)
		status = hawser__expanded_lift(rom, &e, answers, i, report);
	return status ? status : hawser__expanded_fields(rom, &e, answers, report);
}
