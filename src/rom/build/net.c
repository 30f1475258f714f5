/* rom/build/net.c - the reduced model of a net: its modes, the expanded energy of its elements
 * (net/expand/expand.h), damping, loads and places.
 *
 * Units: the mass of the net, the unstretched length of its longest cable, and the largest tension. The
 * coordinates have the mass 1.
 *
 * The error of second order in the length of elements is taken out by net_finer.c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "net/body.h"
#include "rom/build/net.h"

enum { DEFAULT = 6, CLUSTER = 4 }; /* modes; most that join the default ones */
static const double near = 0.01;   /* relative gap of frequencies within a cluster: split, the model
                                    * misses how its modes drive each other */

static const double nothing = 1e-20; /* relative square of what round-off leaves */

static enum hawser_status check(const struct hawser_net *net, const struct hawser_net_rom_options *o,
                                struct hawser_report *report)
{
	if (o->n < 0 || o->n > HAWSER_NET_ROM_MODES)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "net rom", "%d modes asked: a model of a net "
		                    "has 1 to %d", o->n, HAWSER_NET_ROM_MODES);
	for (int i = 0; o->kept && i < o->count; i++)
		if (o->kept[i] < (i ? o->kept[i - 1] + 1 : 0) || o->kept[i] >= o->n)
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "net rom", "the index of a mode that is "
			                    "kept is %d: give ones below the number of modes, ascending",
			                    o->kept[i]);
	for (int i = 0; i < net->nodes; i++)
		if (net->node[i].table)
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "net rom", "%s: node %s moves by a table, "
			                    "and the response is to harmonic motions: give supports.%s.motion",
			                    net->name, net->node[i].name, net->node[i].name);
	if (net->surfaces || !(net->water.density > 0.0))
		return hawser__touch_none(net, "rom", report);
	return hawser__net_water_check(net, report);
}

/* --- the modes --- */

static void set_units(struct hawser__net_source *source)
{
	const struct hawser__mesh *mesh = &source->modal.mesh;

	for (int i = 0; i < mesh->nodes; i++)
		source->mass += mesh->mass[i];
	for (int c = 0; c < mesh->cables; c++) {
		double length = 0.0;

		for (int e = mesh->first[c]; e < mesh->first[c + 1]; e++) {
			length += mesh->length0[e];
			source->mass += mesh->rho[e]*mesh->length0[e];
			source->force = fmax(source->force, source->modal.T[e]);
			source->EA = fmax(source->EA, mesh->EA[e]);
		}
		source->length = fmax(source->length, length);
	}
	source->time = sqrt(source->mass*source->length/source->force);
}

static enum hawser_status check_taut(const struct hawser__net_source *source,
                                     struct hawser_report *report)
{
	const struct hawser__mesh *mesh = &source->modal.mesh;

	for (int i = 0; i < 6*mesh->elements; i++) {
		int e = i/6, node = mesh->end[e][i%2];

		if (!(source->modal.T[e] > 0.0) && mesh->unknown[node][i%3] >= 0)
			return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "net rom", "%s: cable %s is slack at "
			                    "rest, and the model is of cables that stay taut: shorten it, load it, "
			                    "or leave it out", source->net->name,
			                    source->net->cable[mesh->cable[e]].name);
	}
	return HAWSER_OK;
}

/* The default number, and those near the last one. */
static int joined(const struct hawser_net_modes *modes)
{
	int n = modes->n < DEFAULT ? modes->n : DEFAULT;

	while (n < modes->n && modes->omega[n] - modes->omega[n - 1] < near*modes->omega[n])
		n++;
	return n;
}

static enum hawser_status allocate(struct hawser__net_source *source, struct hawser_report *report)
{
	size_t unknowns = (size_t)source->modal.mesh.unknowns;

	source->kept = hawser__hold(&source->hold, (size_t)source->n, sizeof *source->kept);
	source->mode = hawser__hold(&source->hold, (size_t)source->n*unknowns, sizeof *source->mode);
	source->scratch = hawser__hold(&source->hold, unknowns + 1, sizeof *source->scratch);
	source->place = hawser__hold(&source->hold, hawser__net_points(source->net), sizeof *source->place);
	return source->hold.short_of_memory ? hawser__no_memory(report, "net rom") : HAWSER_OK;
}

/* As many modes as `fine` has looked at, if there are, and the coordinates and units of that. */
static enum hawser_status find_like(struct hawser__net_source *source, int *aligned,
                                    const struct hawser__net_source *fine,
                                    struct hawser_report *report)
{
	enum hawser_status status = hawser__net_modal_open(&source->modal, source->net,
	                                                   -fine->modal.modes.n, HAWSER__NET_SPACE, report);

	if (status)
		return status;
	source->length = fine->length;
	source->time = fine->time;
	source->force = fine->force;
	source->mass = fine->mass;
	source->EA = fine->EA;
	source->n = fine->n;
	source->inertia.found = fine->inertia.found;
	source->inertia.by = fine->inertia.by;
	status = allocate(source, report);
	return status ? status : hawser__net_align(aligned, source, fine, report);
}

static enum hawser_status find_modes(struct hawser__net_source *source,
                                     const struct hawser_net_rom_options *o,
                                     struct hawser_report *report)
{
	struct hawser__net_modal *modal = &source->modal;
	int n = o->n == 0 ? -DEFAULT - CLUSTER : o->condensed && !o->kept ? -o->n : o->n;
	size_t unknowns;
	enum hawser_status status = hawser__bodies_none(source->net, "a reduced model", report);

	if (!status)
		status = hawser__net_modal_open(modal, source->net, n, HAWSER__NET_SPACE, report);
	if (status)
		return status;
	status = check_taut(source, report);
	if (status)
		return status;
	set_units(source);
	source->n = o->kept ? o->count : o->n > 0 ? modal->modes.n : joined(&modal->modes);
	status = allocate(source, report);
	if (status)
		return status;
	unknowns = (size_t)modal->mesh.unknowns;
	for (int j = 0; j < source->n; j++) {
		int k = source->kept[j] = o->kept ? o->kept[j] : j;

		cblas_daxpy((int)unknowns, source->length*sqrt(source->mass/modal->modes.mass[k]),
		            modal->eigen.x + (size_t)k*unknowns, 1, source->mode + (size_t)j*unknowns, 1);
	}
	return HAWSER_OK;
}

/* --- the response of the modes that are not kept --- */

static void remove_kept(const struct hawser__net_source *source, double *row)
{
	int unknowns = source->modal.mesh.unknowns;
	double part[HAWSER_NET_ROM_MODES];

	hawser__net_masses(source, part, source->mode, source->n, row);
	cblas_dgemv(CblasRowMajor, CblasTrans, source->n, unknowns, -1.0, source->mode, unknowns, part, 1,
	            1.0, row, 1);
}

static enum hawser_status follow(const void *of, double *to, const double *from,
                                 struct hawser_report *report)
{
	const struct hawser__net_source *source = of;
	int unknowns = source->modal.mesh.unknowns;
	enum hawser_status status;

	hawser__eigen_mass(to, from, &source->modal.mesh, 7U);
	status = hawser__sparse_solve(to, source->modal.eigen.sparse, report);
	cblas_dscal(unknowns, 1.0/(source->time*source->time), to, 1);
	remove_kept(source, to);
	return status;
}

/* The static response; nothing but round-off where all modes that are driven are kept. */
static enum hawser_status hold(double *row, const struct hawser__net_source *source,
                               struct hawser_report *report)
{
	enum hawser_status status = hawser__sparse_solve(row, source->modal.eigen.sparse, report);
	double before, left;

	hawser__net_masses(source, &before, row, 1, row);
	remove_kept(source, row);
	hawser__net_masses(source, &left, row, 1, row);
	if (!(left > nothing*before))
		memset(row, 0, (size_t)source->modal.mesh.unknowns*sizeof *row);
	return status;
}

/* As a field of the energy, while there is room. */
static void add_field(struct hawser__answers *answers, int k, int sine)
{
	answers->field[answers->fields].k = k;
	answers->field[answers->fields].sine = sine;
	answers->field[answers->fields++].factor = 1.0;
}

static enum hawser_status answer(struct hawser__answers *answers, struct hawser__net_source *source,
                                 struct hawser_report *report)
{
	const struct hawser__driven_by by = {.of = source, .products = hawser__net_masses, .follow = follow,
	                                     .width = (size_t)source->modal.mesh.unknowns};
	enum hawser_status status = HAWSER_OK;

	answers->factor = 1.0;
	answers->driven = calloc((size_t)source->waves + 1, sizeof *answers->driven);
	if (!answers->driven)
		return hawser__no_memory(report, "net rom");
	for (int i = 0; i < source->waves && !status; i++) {
		const struct hawser__net_wave *wave = &source->wave[i];
		struct hawser__driven *driven = &answers->driven[answers->count++];

		status = hawser__driven_open(driven, by.width, report);
		if (status)
			break;
		cblas_daxpy((int)by.width, pow(source->time, -wave->power), wave->row, 1, driven->field, 1);
		status = hold(driven->field, source, report);
		if (!status)
			status = hawser__driven_find(driven, &by, report);
	}
	for (int i = 0; i < source->lifts && answers->fields < HAWSER__LOAD_FIELDS; i++)
		add_field(answers, source->lift[i].k, source->lift[i].sine);
	answers->ends = answers->fields;
	for (int i = 0; i < source->waves && answers->fields < HAWSER__LOAD_FIELDS; i++)
		if (source->wave[i].power == 0)
			add_field(answers, source->wave[i].k, source->wave[i].sine);
	return status;
}

/* --- the expansion --- */

/* find: look for second-order shapes. */
static enum hawser_status expand(struct hawser__net_source *source,
                                 const struct hawser__answers *answers, int find,
                                 struct hawser_report *report)
{
	struct hawser__nexpand *t = &source->t;
	double *omega2 = hawser__hold(&source->hold, (size_t)source->n, sizeof *omega2);
	int nodes = source->modal.mesh.nodes, at = source->n;
	enum hawser_status status;

	if (!omega2)
		return hawser__no_memory(report, "net rom");
	t->omega2 = omega2;
	t->mode = source->mode;
	for (int j = 0; j < source->n; j++) {
		omega2[j] = hawser__net_omega(source, j)*hawser__net_omega(source, j);
		hawser__net_spread(t->shape + (size_t)j*(size_t)nodes, source,
		                   source->mode + (size_t)j*(size_t)source->modal.mesh.unknowns);
	}
	for (int i = 0; i < answers->ends; i++, at++)
		memcpy(t->shape + (size_t)at*(size_t)nodes, source->lift[i].shape,
		       (size_t)nodes*sizeof *t->shape);
	for (int i = 0; i < source->waves && at < t->n; i++)
		if (source->wave[i].power == 0)
			hawser__net_spread(t->shape + (size_t)at++*(size_t)nodes, source, answers->driven[i].field);
	status = hawser__nexpand_follow(t, report);
	if (!status && find)
		status = hawser__net_inertia_find(source, report);
	return status ? status : hawser__net_inertia_make(source, report);
}

/* --- the model --- */

void hawser__net_source_clear(struct hawser__net_source *source)
{
	hawser__nexpand_clear(&source->t);
	hawser__net_modal_clear(&source->modal);
	hawser__hold_clear(&source->hold);
}

/* What the model of a mesh whose modes are found is made of. find: with second-order shapes that
 * matter; else with those of `source`. */
static enum hawser_status prepare(struct hawser__net_source *source, struct hawser__answers *answers,
                                  const struct hawser_net_rom_options *o, int find,
                                  struct hawser_report *report)
{
	enum hawser_status status =
		hawser__nexpand_open(&source->t, &source->modal, source->force*source->length, 0, 0,
		                              report);
	if (!status)
		status = hawser__net_loads_of(source, report);
	if (!status)
		status = answer(answers, source, report);
	if (o->bare)
		answers->fields = answers->ends;
	hawser__nexpand_clear(&source->t);
	if (!status)
		status = hawser__nexpand_open(&source->t, &source->modal, source->force*source->length,
		                              source->n + answers->fields, source->n, report);
	return status ? status : expand(source, answers, find, report);
}

static enum hawser_status complete(struct hawser_rom *rom, struct hawser__net_source *source,
                                   const struct hawser__answers *answers,
                                   const struct hawser_net_rom_options *o,
                                   struct hawser_report *report)
{
	enum hawser_status status;

	if (o->linear)
		return hawser__net_fill_first(rom, source, 0, report);
	status = hawser__nexpand_pairs(&source->t, report);

	return status ? status : hawser__net_fill(rom, source, answers, report);
}

/* like: with the modes most like its coordinates, or NULL. */
static enum hawser_status open_source(struct hawser__net_source *source, struct hawser_net *fine,
                                      struct hawser__answers *answers, const struct hawser_net *net,
                                      const struct hawser_net_rom_options *options,
                                      const struct hawser__net_source *like,
                                      struct hawser_report *report)
{
	enum hawser_status status = hawser__net_finer(fine, net, 0, report);
	int aligned = 1;

	*source = (struct hawser__net_source){.net = fine};
	*answers = (struct hawser__answers){.count = 0};
	if (!status)
		status = like ? find_like(source, &aligned, like, report)
		              : find_modes(source, options, report);
	if (!status && !aligned)
		return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "net rom", "%s: the modes have become "
		                    "others than those at the first value: give a smaller range, or another "
		                    "number of modes", net->name);
	return status || options->linear ? status
		: prepare(source, answers, options, !like && !options->bare && !options->condensed, report);
}

enum hawser_status hawser__net_source_open(struct hawser__net_source *source, struct hawser_net *fine,
                                           struct hawser__answers *answers,
                                           const struct hawser_net *net,
                                           const struct hawser_net_rom_options *options,
                                           struct hawser_report *report)
{
	return open_source(source, fine, answers, net, options, NULL, report);
}

void hawser__net_like_clear(struct hawser__net_like *like)
{
	hawser__answers_clear(&like->answers);
	hawser__net_source_clear(&like->source);
	free(like->fine.cable);
}

enum hawser_status hawser__net_like_open(struct hawser__net_like *like, const struct hawser_net *net,
                                         const struct hawser_net_rom_options *options,
                                         struct hawser_report *report)
{
	enum hawser_status status = check(net, options, report);

	return status ? status : hawser__net_source_open(&like->source, &like->fine, &like->answers, net,
	                                                 options, report);
}

/* Without the error of the length of elements. */
static enum hawser_status extrapolate(struct hawser_rom *rom, const struct hawser__net_source *fine,
                                      const struct hawser_net *net,
                                      const struct hawser_net_rom_options *o,
                                      struct hawser_report *report)
{
	struct hawser_net half;
	struct hawser__net_source source = {.net = &half};
	struct hawser__answers answers = {.count = 0};
	struct hawser_rom coarse = {.n = 0};
	enum hawser_status status = hawser__net_finer(&half, net, 1, report);
	int aligned = 0;

	if (!status)
		status = find_like(&source, &aligned, fine, report);
	if (!status && aligned && !o->linear)
		status = prepare(&source, &answers, o, 0, report);
	if (!status && aligned)
		status = complete(&coarse, &source, &answers, o, report);
	if (!status && aligned)
		status = hawser__net_mix(rom, &aligned, &coarse, report);
	if (o->alone)
		*o->alone = !status && !aligned;
	hawser_rom_clear(&coarse);
	hawser__answers_clear(&answers);
	hawser__net_source_clear(&source);
	free(half.cable);
	return status;
}

static enum hawser_status take_modes(struct hawser_modes *modes, const struct hawser_rom *rom,
                                     const struct hawser__net_source *source,
                                     struct hawser_report *report)
{
	int number[2] = {0};

	modes->mode = calloc((size_t)source->n, sizeof *modes->mode);
	if (!modes->mode)
		return hawser__no_memory(report, "net rom");
	modes->n = source->n;
	modes->time_unit = source->time;
	for (int j = 0; j < source->n; j++) {
		int out = source->modal.modes.share[source->kept[j]][2] > 0.5;

		modes->mode[j] = (struct hawser_mode){.omega = sqrt(rom->K[j*(rom->n + 1)]),
			.plane = out ? HAWSER_OUT_OF_PLANE : HAWSER_IN_PLANE, .place = source->kept[j] + 1,
			.number = ++number[out], .symmetry = HAWSER_MIXED};
	}
	return HAWSER_OK;
}

enum hawser_status hawser__net_rom_like(struct hawser_rom *rom, struct hawser_modes *modes,
                                        const struct hawser_net *net,
                                        const struct hawser_net_rom_options *options,
                                        const struct hawser__net_like *like,
                                        struct hawser_report *report)
{
	struct hawser_net fine = {.nodes = 0};
	struct hawser__net_source source = {.net = &fine};
	struct hawser__answers answers = {.count = 0};
	enum hawser_status status = check(net, options, report);

	memset(rom, 0, sizeof *rom);
	memset(modes, 0, sizeof *modes);
	if (!status)
		status = open_source(&source, &fine, &answers, net, options, like ? &like->source : NULL,
		                     report);
	if (!status)
		status = complete(rom, &source, &answers, options, report);
	if (!status && !options->raw)
		status = extrapolate(rom, &source, net, options, report);
	if (!status)
		status = take_modes(modes, rom, &source, report);
	if (!status)
		status = hawser__net_water_fill(rom, &source, options->linear, report);
	if (!status && !options->linear)
		status = hawser_rom_compile(rom, report);
	hawser__answers_clear(&answers);
	hawser__net_source_clear(&source);
	free(fine.cable);
	if (status) {
		hawser_rom_clear(rom);
		hawser_modes_clear(modes);
	}
	return status;
}

enum hawser_status hawser_net_rom_build(struct hawser_rom *rom, struct hawser_modes *modes,
                                        const struct hawser_net *net,
                                        const struct hawser_net_rom_options *options,
                                        struct hawser_report *report)
{
	return hawser__net_rom_like(rom, modes, net, options, NULL, report);
}
