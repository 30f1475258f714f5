/* rom/build/line.c - the reduced model of a rope over sheaves: tensors of the expanded energy
 * (ropeway/expand/expand.h), damping, labels and shape points.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "core/settle.h"
#include "rom/build/line.h"
#include "rom/build/model.h"

enum { HARMONICS = 3, HARMONICS_MOST = 30 };

void hawser_line_rom_settle(struct hawser_line_rom_options *options)
{
	hawser__settle_count(&options->modes.n, 6);
	hawser__settle_count(&options->harmonics, HARMONICS);
}

static enum hawser_status refuse(struct hawser_report *report, const char *what, double value,
                                 const char *want)
{
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, "line rom", "%s is %g: give %s", what, value,
	                    want);
}

static int any(const double *value, int lanes)
{
	return value[0] != 0.0 || (lanes > 1 && value[1] != 0.0);
}

static enum hawser_status check(const struct hawser_line_rom_options *o, int lanes,
                                struct hawser_report *report)
{
	if (o->modes.n > HAWSER_LINE_ROM_MODES)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "line rom", "%d modes asked: a model of a "
		                    "rope over sheaves has 1 to %d", o->modes.n, HAWSER_LINE_ROM_MODES);
	for (int i = 0; o->kept && i < o->count; i++)
		if (o->kept[i] < (i ? o->kept[i - 1] + 1 : 0) || o->kept[i] >= o->modes.n)
			return refuse(report, "the index of a mode that is kept", o->kept[i],
			              "one below the number of modes, and them in ascending order");
	if (o->kept && o->count < 1)
		return refuse(report, "the number of modes that are kept", o->count, "1 at least");
	if (!(o->ratio >= 0.0 && o->ratio < 1.0))
		return refuse(report, "the damping ratio", o->ratio, "0 to 1");
	if ((unsigned)o->load > HAWSER_LINE_LOAD_DRIVE || (unsigned)o->end > 1)
		return refuse(report, "an option (load or end)", o->load, "one of its values");
	if (!(o->speed >= 0.0 && isfinite(o->speed)))
		return refuse(report, "the speed (m/s)", o->speed, "0 or a positive one, and modes.backward");
	for (int i = 0; i < lanes; i++) {
		if (!(o->running[i] >= 0.0 && isfinite(o->running[i])))
			return refuse(report, "the mass per length that runs (kg/m)", o->running[i],
			              "0 or a positive one");
		if (o->running[i] > 0.0 && o->modes.contact == HAWSER_LINE_STICK)
			return refuse(report, "the mass per length that runs (kg/m)", o->running[i],
			              "0: the contact is stick, and a rope that sticks does not run");
		if (!(o->weight[i] >= 0.0 && isfinite(o->weight[i])))
			return refuse(report, "the weight that passes (N)", o->weight[i], "0 or a positive one");
		if (!isfinite(o->first[i]))
			return refuse(report, "the place of the first weight (m)", o->first[i], "a finite one");
		if (!isfinite(o->amplitude[i]))
			return refuse(report, "the amplitude of the drive (m)", o->amplitude[i], "a finite one");
	}
	if (o->load == HAWSER_LINE_LOAD_PASSING) {
		if (!any(o->weight, lanes))
			return refuse(report, "the weight that passes (N)", 0.0, "a lane a positive one");
		if (!(o->spacing > 0.0 && isfinite(o->spacing)))
			return refuse(report, "the spacing (m)", o->spacing, "a positive one");
		if (o->harmonics < 1 || o->harmonics > HARMONICS_MOST)
			return refuse(report, "the number of harmonics", o->harmonics, "1 to 30");
	}
	if (o->load == HAWSER_LINE_LOAD_DRIVE && !any(o->amplitude, lanes))
		return refuse(report, "the amplitude of the drive (m)", 0.0, "a lane that moves one");
	return HAWSER_OK;
}

/* --- labels and shape points --- */

/* "in-plane 2 (span 1)": the span with more than half of the energy, if there is one. Behind the modes
 * are second-order shapes. */
static enum hawser_status set_labels(struct hawser_rom *rom, const struct hawser_line_modes *modes,
                                     struct hawser_report *report)
{
	rom->label = calloc((size_t)rom->n, sizeof *rom->label);
	if (!rom->label)
		return hawser__no_memory(report, "line rom");
	for (int j = 0; j < rom->n; j++) {
		char text[96] = "second-order shape", where[40] = "";

		for (int i = 0; j < modes->n && i < modes->spans && modes->spans > 1; i++)
			if (modes->share[j*modes->spans + i] > 0.5)
				snprintf(where, sizeof where, " (span %d)", i + 1);
		if (j < modes->n)
			snprintf(text, sizeof text, "%s %d%s", hawser_plane_name(modes->mode[j].plane),
			         modes->mode[j].number, where);
		rom->label[j] = strdup(text);
		if (!rom->label[j])
			return hawser__no_memory(report, "line rom");
	}
	return HAWSER_OK;
}

int hawser__line_run(const struct hawser__lmode *rope, int run, double *s0, double *length)
{
	int lane = -1;

	*s0 = *length = 0.0;
	for (int i = 0; i < rope->pieces; i++) {
		if (rope->piece[i].run != run)
			continue;
		if (lane < 0)
			*s0 = rope->piece[i].s0;
		lane = rope->piece[i].lane;
		*length += rope->piece[i].length;
	}
	return lane;
}

static enum hawser_status set_shapes(struct hawser_rom *rom, const struct hawser__lexpand *t,
                                     const struct hawser_line_modes *modes,
                                     struct hawser_report *report)
{
	struct hawser_rom_shapes *shapes = &rom->shapes;
	enum hawser_status status = hawser__rom_init_shapes(rom, modes->spans, report);

	shapes->EA = status ? 0.0 : modes->lane[0]->line->EA;
	for (int p = 0; p < modes->spans && !status; p++) {
		double s0, length, angle, stretch;
		char text[32];
		int lane = hawser__line_run(t->rope, p, &s0, &length);
		double s = s0 + 0.5*length;

		snprintf(text, sizeof text, "span_%d", p + 1);
		shapes->name[p] = strdup(text);
		if (!shapes->name[p])
			return hawser__no_memory(report, "line rom");
		hawser_line_at(modes->lane[lane], NULL, &angle, NULL, &stretch, NULL, s*modes->length_unit);
		shapes->s[p] = s;
		shapes->tangent[2*p] = cos(angle);
		shapes->tangent[2*p + 1] = sin(angle);
		shapes->stretch[p] = stretch;
		for (int j = 0; j < modes->n; j++) {
			size_t place = 3*((size_t)j*(size_t)shapes->points + (size_t)p);

			hawser_line_modes_at(shapes->shape + place, shapes->slope + place, modes, j, lane, s);
		}
	}
	return status;
}

/* Ends and middle of every piece of the free rope. */
static enum hawser_status set_line(struct hawser_rom *rom, const struct hawser__lexpand *t,
                                   const struct hawser_line_modes *modes, struct hawser_report *report)
{
	struct hawser_rom_line *line = &rom->line;
	int points = 0, p = 0;
	enum hawser_status status;

	for (int i = 0; i < t->rope->pieces; i++)
		points += t->first[i] >= 0 ? 3 : 0;
	status = hawser__rom_init_line(rom, points, report);
	for (int i = 0; i < t->rope->pieces && !status; i++)
		for (int k = 0; k < 3 && t->first[i] >= 0; k++, p++) {
			const struct hawser__lmode_piece *piece = &t->rope->piece[i];
			const struct hawser_line_modes_piece *on = &modes->piece[i];
			double V = piece->V + piece->delta*piece->length*k/2.0;

			line->s[p] = piece->s0 + piece->length*k/2.0;
			line->stretch[p] = 1.0 + t->rope->epsilon*hypot(piece->H, V);
			for (int j = 0; j < modes->n; j++)
				hawser__grid_at(line->slope + 3*((size_t)j*(size_t)points + (size_t)p), &on->grid,
				                modes->slope + 3*((size_t)j*(size_t)modes->points + (size_t)on->first),
				                3, 3, piece->length*k/2.0);
		}
	return status;
}

/* Second-order shapes at the shape points and on the line. */
static void place_inertia(struct hawser_rom *rom, const struct hawser__expanded *e,
                          const struct hawser__line_inertia *inertia)
{
	int points = rom->shapes.points, along = rom->line.points;

	for (int i = 0; i < rom->inertia.shapes; i++) {
		const double *row = inertia->of.row + (size_t)i*inertia->t->width;
		int j = inertia->modes->n + i;
		double u[3];

		for (int p = 0; p < points; p++)
			e->field_at(rom->shapes.shape + 3*(j*points + p), rom->shapes.slope + 3*(j*points + p),
			            e->of, row, p);
		for (int p = 0; p < along; p++)
			e->field_at(u, rom->line.slope + 3*(j*along + p), e->of, row, points + p);
	}
}

/* --- build --- */

static void set_matrices(struct hawser_rom *rom, const struct hawser__line_inertia *inertia)
{
	int n = rom->n, modes = inertia->modes->n;

	for (int j = 0; j < n; j++) {
		double omega = j < modes ? inertia->modes->mode[j].omega : sqrt(inertia->of.kappa2[j - modes]);

		rom->K[j*(n + 1)] = omega*omega;
		rom->D[j*(n + 1)] = 2.0*inertia->options->ratio*omega;
	}
}

static enum hawser_status fill(struct hawser_rom *rom, struct hawser__line_inertia *inertia,
                               const struct hawser__answers *answers, struct hawser_report *report)
{
	const struct hawser__lexpand *t = inertia->t;
	const struct hawser_line_modes *modes = inertia->modes;
	const struct hawser_line_rom_options *o = inertia->options;
	const struct hawser__line_source source = {rom, t, modes->n, o->ratio};
	const struct hawser__expanded e = hawser__line_expanded(&source);
	enum hawser_status status = hawser__rom_init(rom, modes->n + inertia->of.found.shapes, report);

	if (status)
		return status;
	rom->length = modes->length_unit;
	rom->time = modes->time_unit;
	rom->force = modes->force_unit;
	rom->scaled = 1;
	rom->inertia = inertia->of.found;
	status = hawser__line_load(rom, t, modes, o, inertia->pull, report); /* on all that follows */
	if (!status)
		status = hawser__line_inertia_make(inertia, report);
	if (status)
		return status;
	set_matrices(rom, inertia);
	status = hawser__expanded_tensors(rom, &e, modes->n, 0, report);
	if (!status)
		status = hawser__inertia_quads(rom, &inertia->of, report);
	if (!status)
		status = set_labels(rom, modes, report);
	if (!status)
		status = set_shapes(rom, t, modes, report);
	if (!status)
		status = set_line(rom, t, modes, report);
	if (!status)
		place_inertia(rom, &e, inertia);
	if (!status)
		status = hawser__expanded_pairs(rom, &e, report);
	if (!status)
		status = hawser__line_contacts(rom, modes, report);
	if (!status)
		status = hawser__expanded_answers(rom, &e, answers, report);
	if (!status)
		status = hawser__expanded_fields(rom, &e, answers, report);
	return status ? status : hawser_rom_compile(rom, report);
}

enum hawser_status hawser_line_rom_build(struct hawser_rom *rom, struct hawser_line_modes *modes,
                                         const struct hawser_line_statics *const *lane, int lanes,
                                         const struct hawser_line_rom_options *options,
                                         struct hawser_report *report)
{
	struct hawser_line_rom_options o = *options;
	struct hawser__lexpand_modes own = {.shape = NULL};
	struct hawser__lexpand t = {.rope = NULL};
	struct hawser__answers answers = {.count = 0};
	double pull[HAWSER_LINE_ROM_MODES] = {0.0}, wave;
	struct hawser__line_inertia inertia = {.t = &t, .modes = modes, .options = &o, .pull = pull};
	enum hawser_status status;

	memset(rom, 0, sizeof *rom);
	memset(modes, 0, sizeof *modes);
	hawser_line_rom_settle(&o);
	status = check(&o, lanes, report);
	if (status)
		return status;
	wave = o.load == HAWSER_LINE_LOAD_PASSING ? 2.0*M_PI*o.harmonics/o.spacing : 0.0;
	status = hawser__lexpand_modes_open(&own, modes, lane, lanes, &o.modes, wave, report);
	if (!status && o.kept)
		hawser__lexpand_modes_keep(&own, modes, o.kept, o.count);
	if (!status)
		status = hawser__line_answers_make(&answers, pull, &own, modes, &o, report);
	if (!status)
		status = hawser__lexpand_open(&t, &own.rope, own.shape, modes->n + answers.fields, o.held,
		                              report);
	if (!status)
		status = hawser__line_inertia_find(&inertia, &own, report);
	if (!status)
		status = fill(rom, &inertia, &answers, report);
	hawser__line_inertia_clear(&inertia);
	hawser__lexpand_clear(&t);
	hawser__answers_clear(&answers);
	hawser__lexpand_modes_clear(&own);
	if (status) {
		hawser_rom_clear(rom);
		hawser_line_modes_clear(modes);
	}
	return status;
}
