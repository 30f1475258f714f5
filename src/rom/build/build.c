/* rom/build/build.c - the model of a scene: tensors, damping, load, units, labels, probes.
 *
 *   f_j = d/H * integral over the loaded part of Phi_j . f ds,   f in N/m, s scaled arclength
 *   alpha -> alpha*d/sqrt(rho*H);  rayleigh (mass, stiffness) -> mass*t + stiffness/t*K, t the time
 *   unit d*sqrt(rho/H);  ratio zeta -> 2*zeta*omega_j, zeta that of mode j in a list
 *
 * Of a travelling cable H, rho and S are the apparent ones, but load and alpha are per actual length:
 * with m of struct hawser_motion, f -> (1 - m) f and alpha -> alpha*t/(actual rho).
 *
 * (Bertrand 2022, 2.75-2.77; doc/theory-rom.md.)
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "modes/label.h"
#include "rom/condense/answer.h"
#include "rom/condense/fields.h"
#include "rom/build/build.h"
#include "rom/terms/drag.h"
#include "rom/file/entries.h"
#include "rom/condense/inertia.h"
#include "rom/build/model.h"
#include "rom/energy/kernel.h"
#include "rom/energy/law.h"
#include "rom/terms/load.h"
#include "rom/energy/project.h"
#include "rom/condense/support.h"
#include "rom/terms/travel.h"
#include "rom/terms/wind.h"
#include "statics/frame.h"

/* Probes, as fractions of the unstretched length. */
static const struct {
	const char *name;
	double part;
} probes[] = {{"quarter", 0.25}, {"mid", 0.5}, {"three_quarter", 0.75}};
enum { PROBES = sizeof probes/sizeof *probes };

/* Points at which the tension is evaluated, including the ends: eight per wave of the 4th mode. */
enum { LINE = 17 };

static void set_stiffness(struct hawser_rom *rom, const struct hawser_modes *modes)
{
	for (int j = 0; j < rom->n; j++)
		rom->K[j*rom->n + j] = modes->mode[j].omega*modes->mode[j].omega;
}

/* --- load --- */

static enum hawser_status set_load(struct hawser_rom *rom, const struct hawser_modes *modes,
                                   const struct hawser__loads *loads, struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	for (int i = 0; i < loads->harmonics && !status; i++) {
		struct hawser_harmonic *h = hawser__rom_harmonic(rom, loads->k[i], loads->sine[i]
		                                                 ? HAWSER_SIN : HAWSER_COS);

		if (h)
			h->f = malloc((size_t)rom->n*sizeof *h->f);
		if (!h || !h->f)
			return hawser__no_memory(report, "rom");
		status = hawser__loads_work(h->f, loads, i, modes, report);
		for (int j = 0; !status && j < rom->n; j++)
			if (!isfinite(h->f[j]))
				status = hawser__fail(report, HAWSER_ERR_NAN, "rom",
				                      "the load on mode %d is %g: its shape or the load is not "
				                      "finite", j + 1, h->f[j]);
	}
	return status;
}

/* --- labels and probes --- */

/* "in-plane 2 (antisymmetric)", "in-plane 9 (longitudinal, symmetric)", "out-of-plane 1": numbered
 * within their plane. */
static char *label_of(const struct hawser_rom *rom, const struct hawser_modes *modes, int j)
{
	const struct hawser_mode *mode = &modes->mode[j];
	const char *symmetry = mode->symmetry == HAWSER_MIXED ? NULL
	                       : hawser_symmetry_name(mode->symmetry);
	int in_plane = mode->plane == HAWSER_IN_PLANE;
	int along = mode->family == HAWSER_LONGITUDINAL;
	char text[96], note[48] = "";

	if (mode->number == 0) {
		snprintf(text, sizeof text, "%s shape, %s",
		         j < modes->n - rom->inertia.shapes ? "damper" : "second-order",
		         hawser_plane_name(mode->plane));
		return strdup(text);
	}
	if (in_plane && (along || symmetry))
		snprintf(note, sizeof note, " (%s%s%s)", along ? hawser_family_name(mode->family) : "",
		         along && symmetry ? ", " : "", symmetry ? symmetry : "");
	snprintf(text, sizeof text, "%s %d%s", hawser_plane_name(mode->plane), mode->number, note);
	return strdup(text);
}

static enum hawser_status set_labels(struct hawser_rom *rom, const struct hawser_modes *modes,
                                     struct hawser_report *report)
{
	rom->label = calloc((size_t)rom->n, sizeof *rom->label);
	if (!rom->label)
		return hawser__no_memory(report, "rom");
	for (int j = 0; j < rom->n; j++)
		if (!(rom->label[j] = label_of(rom, modes, j)))
			return hawser__no_memory(report, "rom");
	return HAWSER_OK;
}

int hawser__rom_stroke_point(const struct hawser_statics *st, int p)
{
	int left = p - PROBES;

	for (int i = 0; left >= 0 && i < st->attachments; i++)
		if (st->attached[i].absorber > 0.0 && left-- == 0)
			return i;
	return -1;
}

/* PROBES, and a point for the stroke of every absorber. */
static int points_of(const struct hawser_statics *st)
{
	int points = PROBES;

	for (int i = 0; i < st->attachments; i++)
		points += st->attached[i].absorber > 0.0;
	return points;
}

/* "mid"; "stroke_tmd" or, without a name, "stroke_2" of attachment 2 of the scene. */
static char *name_of(const struct hawser_modes *modes, const struct hawser_scene *scene, int p)
{
	int own = hawser__rom_stroke_point(&modes->statics, p), index;
	char text[HAWSER_NAME_SIZE + 24];

	if (own < 0)
		return strdup(probes[p].name);
	index = modes->statics.attached[own].index;
	if (scene && index < scene->attachments && *scene->attach[index].name)
		snprintf(text, sizeof text, "stroke_%s", scene->attach[index].name);
	else
		snprintf(text, sizeof text, "stroke_%d", index + 1);
	return strdup(text);
}

static void set_probe(struct hawser_rom_shapes *shapes, const struct hawser_modes *modes, int p)
{
	int own = hawser__rom_stroke_point(&modes->statics, p);
	double s = own < 0 ? probes[p].part*modes->statics.l : modes->statics.attached[own].s;
	struct hawser_frame_point at = hawser_statics_frame(&modes->statics, s);

	shapes->s[p] = s;
	/* in space displacements are along the axes of the cable */
	shapes->tangent[2*p] = modes->statics.space ? 1.0 : at.ex;
	shapes->tangent[2*p + 1] = modes->statics.space ? 0.0 : at.ey;
	shapes->stretch[p] = 1.0 + at.strain;
	for (int j = 0; j < modes->n; j++) {
		size_t place = ((size_t)j*(size_t)shapes->points + (size_t)p)*3;

		hawser_modes_at(modes, shapes->shape + place, shapes->slope + place, j, s);
		if (own >= 0) {
			hawser__frame_in(shapes->shape + place, &at, modes->statics.attached[own].absorber_axis);
			for (int c = 0; c < 3; c++)
				shapes->shape[place + (size_t)c] *= hawser__stroke(modes, j, own);
		}
	}
	for (int j = 0; modes->statics.space && j < modes->n; j++) {
		double *shape = shapes->shape + ((size_t)j*(size_t)shapes->points + (size_t)p)*3;
		double local[3];

		memcpy(local, shape, sizeof local);
		hawser__frame_out(shape, &at, local);
	}
}

/* The contribution of the condensed modes at the probes and along the line. */
static enum hawser_status set_second(struct hawser_rom *rom, const struct hawser_modes *modes,
                                     const struct hawser__condensed *condensed,
                                     struct hawser_report *report)
{
	enum hawser_status status = hawser__rom_init_second(rom, report);

	return status ? status
	       : hawser__condensed_second(rom->shapes.second_shape, rom->shapes.second_slope,
	                                  rom->line.second_slope, rom, condensed, modes, 0,
	                                  condensed->pairs, report);
}

static enum hawser_status set_shapes(struct hawser_rom *rom, const struct hawser_modes *modes,
                                     const struct hawser_scene *scene, struct hawser_report *report)
{
	enum hawser_status status = hawser__rom_init_shapes(rom, points_of(&modes->statics), report);

	if (status)
		return status;
	rom->shapes.EA = modes->statics.span.EA;
	rom->shapes.turned = modes->statics.turned;
	memcpy(rom->shapes.axes, modes->statics.axes, sizeof rom->shapes.axes);
	for (int p = 0; p < rom->shapes.points; p++) {
		rom->shapes.name[p] = name_of(modes, scene, p);
		if (!rom->shapes.name[p])
			return hawser__no_memory(report, "rom");
		set_probe(&rom->shapes, modes, p);
	}
	return HAWSER_OK;
}

static enum hawser_status set_line(struct hawser_rom *rom, const struct hawser_modes *modes,
                                   struct hawser_report *report)
{
	struct hawser_rom_line *line = &rom->line;
	enum hawser_status status = hawser__rom_init_line(rom, LINE, report);

	for (int p = 0; !status && p < LINE; p++) {
		double shape[3], s = modes->statics.l*p/(LINE - 1);

		line->s[p] = s;
		line->stretch[p] = 1.0 + hawser_statics_frame(&modes->statics, s).strain;
		for (int j = 0; j < rom->n; j++)
			hawser_modes_at(modes, shape, line->slope + ((size_t)j*LINE + p)*3, j, s);
	}
	return status;
}

enum hawser_status hawser__rom_begin(struct hawser_rom *rom, const struct hawser_modes *modes,
                                     const struct hawser_scene *scene,
                                     struct hawser_report *report)
{
	enum hawser_status status;

	memset(rom, 0, sizeof *rom);
	status = hawser__rom_real(modes, report);
	if (status)
		return status;
	if (modes->statics.space && hawser__support_moves(scene))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
		                    "moving ends (support.A.motion, support.B.motion, --motion) of a cable "
		                    "that masses or springs in a wind, or attach.force, take out of one plane "
		                    "are not modelled: leave them out, or set load.static.per_length=[0,0,0] "
		                    "and forces downwards");
	if (!(modes->statics.epsilon > 0.0))
		return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "rom",
		                    "an inextensible cable (EA = %g N) has no strain energy: "
		                    "give a finite EA", modes->statics.span.EA);
	status = hawser__rom_init(rom, modes->n, report);
	if (status)
		return status;
	rom->length = modes->statics.span.d;
	rom->time = modes->time_unit;
	rom->force = modes->statics.H;
	rom->scaled = 1;
	set_stiffness(rom, modes);
	return scene ? hawser__rom_damping(rom, modes, scene, report) : HAWSER_OK;
}

enum hawser_status hawser__rom_finish(struct hawser_rom *rom, const struct hawser_modes *modes,
                                      const struct hawser_scene *scene, struct hawser_report *report)
{
	struct hawser__loads loads;
	enum hawser_status status = hawser__loads_make(&loads, &modes->statics, scene, report);

	if (!status)
		status = set_load(rom, modes, &loads, report);
	hawser__loads_clear(&loads);
	if (!status)
		status = hawser__drag_make(rom, modes, scene, report);
	if (!status)
		status = hawser__rom_travel(rom, modes, scene, report);
	if (!status)
		status = set_labels(rom, modes, report);
	if (!status)
		status = set_shapes(rom, modes, scene, report);
	if (!status)
		status = hawser__range_make(rom, modes, report);
	return status ? status : set_line(rom, modes, report);
}

/* --- inertia of the condensed modes --- */

/* The modes followed by the second-order shapes; with->n = 0 if none are needed. */
static enum hawser_status add_shapes(struct hawser_modes *with, struct hawser_rom *rom,
                                     const struct hawser_modes *modes,
                                     const struct hawser__condensed *condensed,
                                     const struct hawser_scene *scene,
                                     struct hawser_report *report)
{
	size_t n = (size_t)modes->n;
	struct hawser__loads loads;
	double *load = malloc(n*sizeof *load), *damping = malloc(n*sizeof *damping);
	enum hawser_status status = hawser__loads_make(&loads, &modes->statics, scene, report);

	if (!status && (!load || !damping))
		status = hawser__no_memory(report, "rom");
	if (!status)
		status = hawser__loads_most(load, &loads, modes, report);
	for (int j = 0; !status && j < modes->n; j++) {
		damping[j] = rom->D[(size_t)j*(n + 1)];
		if (!isfinite(load[j]))
			load[j] = 0.0; /* reported when the load is set */
		damping[j] = hawser__drag_equal(modes, scene, j, load[j], damping[j]);
	}
	if (!status)
		status = hawser__inertia_extend(with, &rom->inertia, modes, condensed, load, damping,
		                                hawser__inertia_allowed(scene), report);
	if (!status && hawser__drag_alone(scene)) { /* shapes move along the cable: no drag */
		hawser_modes_clear(with);
		rom->inertia = (struct hawser_rom_inertia){.shift = rom->inertia.shift,
		                                           .left = rom->inertia.shift};
	}
	hawser__loads_clear(&loads);
	free(load);
	free(damping);
	return status;
}

/* The response of the other modes; if its inertia matters, *with becomes the modes of a larger
 * model. */
static enum hawser_status condense(struct hawser__condensed *condensed, struct hawser_modes *with,
                                   struct hawser_rom *rom, const struct hawser_modes *modes,
                                   const struct hawser_scene *scene, struct hawser_report *report)
{
	enum hawser_status status = hawser__condense(condensed, modes, modes->n, report);
	struct hawser_rom_inertia inertia;

	/* with gyroscopic forces, the response also depends on velocities */
	if (status || !hawser__loaded(scene) || scene->travel.present ||
	    scene->model.inertia == HAWSER_INERTIA_NONE)
		return status;
	status = add_shapes(with, rom, modes, condensed, scene, report);
	if (status || with->n == 0)
		return status;
	inertia = rom->inertia;
	hawser__condensed_clear(condensed);
	hawser_rom_clear(rom);
	status = hawser__rom_begin(rom, with, scene, report);
	rom->inertia = inertia;
	return status ? status : hawser__condense(condensed, with, modes->n, report);
}

/* --- models --- */

/* Complete; the same without the prepared forces; for a linear problem, K, D and the harmonics, without
 * tensors; that without the terms of the energy by what moves; complete, with coordinates that are no
 * motions of the cable. */
enum { WHOLE, ENTRIES, LINEAR, FORCES, WAKES };

static enum hawser_status compile(struct hawser_rom *rom, const struct hawser_modes *modes,
                                  const struct hawser__condensed *condensed, int what,
                                  struct hawser_report *report)
{
	enum hawser_status status;

	if (what == WAKES) {
		status = hawser__entries_merge(rom, report);
		return status ? status : hawser_rom_compile(rom, report);
	}
	if (what != ENTRIES)
		return what == WHOLE ? hawser__rom_compile_cable(rom, modes, condensed, report)
		                     : hawser_rom_compile(rom, report);
	status = hawser__entries_check(rom, report);
	return status ? status : hawser__entries_merge(rom, report);
}

/* In a linear problem the condensed modes respond to the load and to the changes of speed as in the
 * complete model. Second-order shapes (inertia.h), which that may have as coordinates, represent
 * condensed modes and are omitted; hawser_linear_multipliers condenses them in complete models too. */
static enum hawser_status build_with(struct hawser_rom *rom, const struct hawser_modes *kept,
                                     const struct hawser_scene *scene, int what,
                                     struct hawser_report *report)
{
	struct hawser__condensed others = {0}, *pairs = NULL;
	enum hawser_status status = hawser__rom_begin(rom, kept, scene, report);
	const struct hawser_modes *modes = kept;
	struct hawser_modes with = {.n = 0};
	struct hawser__load_fields loads = {.count = 0};
	int condensed = scene && scene->model.condense == HAWSER_CONDENSE_STATIC, whole = what < LINEAR;

	if (status)
		return status;
	if (condensed && whole) {
		status = condense(&others, &with, rom, kept, scene, report);
		pairs = &others;
		modes = with.n > 0 ? &with : kept;
	}
	if (!status && whole)
		status = hawser__rom_tensors(rom, modes, pairs, report);
	if (!status)
		status = hawser__rom_finish(rom, modes, scene, report);
	if (!status)
		status = hawser__wind_add(rom, modes, scene, whole, report);
	if (!status && pairs)
		status = set_second(rom, modes, pairs, report);
	if (!status && condensed)
		status = hawser__rom_vary(rom, &loads, modes, kept->n, scene, report);
	if (!status && pairs)
		status = hawser__rom_answers(rom, modes, modes->n, scene, report);
	if (!status && hawser__support_moves(scene))
		status = hawser__support_forces(rom, modes, kept->n, condensed, scene, report);
	if (!status && what != FORCES)
		status = hawser__support_energy(rom, modes, kept, condensed ? &loads : NULL, scene, report);
	if (!status && whole)
		status = hawser__wake_add(rom, modes, scene, report);
	if (!status)
		status = compile(rom, modes, pairs, rom->n > modes->n && what == WHOLE ? WAKES : what, report);
	hawser__condensed_clear(&others);
	hawser__load_fields_clear(&loads);
	hawser_modes_clear(&with);
	if (status)
		hawser_rom_clear(rom);
	return status;
}

static enum hawser_status build(struct hawser_rom *rom, const struct hawser_modes *modes,
                                const struct hawser_scene *scene, int what,
                                struct hawser_report *report)
{
	struct hawser_modes with, carrying = {.n = 0};
	enum hawser_status status = hawser__rom_attached(&with, modes, scene, report);
	const struct hawser_modes *own = with.n > 0 ? &with : modes;
	double *turned = NULL;

	memset(rom, 0, sizeof *rom);
	if (!status && what != FORCES)
		status = hawser__travel_modes(&carrying, &turned, own, scene, report);
	if (!status)
		status = build_with(rom, carrying.n > 0 ? &carrying : own, scene, what, report);
	if (!status)
		rom->carried = turned;
	else
		free(turned);
	hawser_modes_clear(&carrying);
	hawser_modes_clear(&with);
	return status;
}

enum hawser_status hawser__rom_of_modes(struct hawser_rom *rom, const struct hawser_modes *modes,
                                        const struct hawser_scene *scene,
                                        struct hawser_report *report)
{
	struct hawser_modes with;
	enum hawser_status status = hawser__rom_attached(&with, modes, scene, report);

	hawser_modes_clear(&with);
	memset(rom, 0, sizeof *rom);
	return status ? status : build_with(rom, modes, scene, WHOLE, report);
}

enum hawser_status hawser_rom_build_entries(struct hawser_rom *rom, const struct hawser_modes *kept,
                                            const struct hawser_scene *scene,
                                            struct hawser_report *report)
{
	return build(rom, kept, scene, ENTRIES, report);
}

enum hawser_status hawser_rom_build(struct hawser_rom *rom, const struct hawser_modes *kept,
                                    const struct hawser_scene *scene, struct hawser_report *report)
{
	return build(rom, kept, scene, WHOLE, report);
}

enum hawser_status hawser_rom_build_linear(struct hawser_rom *rom, const struct hawser_modes *modes,
                                           const struct hawser_scene *scene,
                                           struct hawser_report *report)
{
	return build(rom, modes, scene, LINEAR, report);
}

enum hawser_status hawser__rom_build_forces(struct hawser_rom *rom, const struct hawser_modes *modes,
                                            const struct hawser_scene *scene,
                                            struct hawser_report *report)
{
	return build(rom, modes, scene, FORCES, report);
}
