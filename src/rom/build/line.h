/* rom/build/line.h - the loads of a model of a rope over sheaves.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_LINE_H
#define HAWSER_ROM_LINE_H

#include <hawser/line_rom.h>

#include "rom/build/expanded.h"
#include "ropeway/expand/expand.h"

/* Add the harmonics of options->load. pull: as of hawser__lexpand_drive, the static response to which
 * is in the shapes of t behind the modes then. line_load.c. */
enum hawser_status hawser__line_load(struct hawser_rom *rom, const struct hawser__lexpand *t,
                                     const struct hawser_line_modes *modes,
                                     const struct hawser_line_rom_options *options, const double *pull,
                                     struct hawser_report *report);
/* Largest force of a harmonic of the load on mode j. line_load.c. */
double hawser__line_force(const struct hawser__lexpand *t, const struct hawser_line_modes *modes,
                          const struct hawser_line_rom_options *options, const double *pull, int j);
/* line_inertia.c: the second-order shapes, and what they take out of the second-order displacements of
 * t and add to its energy. Clear, on failure too. */
struct hawser__line_inertia {
	struct hawser__lexpand *t;
	const struct hawser_line_modes *modes;
	const struct hawser_line_rom_options *options;
	const double *pull;
	struct hawser__lexpand_work work;
	struct hawser__driven_by driven;
	struct hawser__inertia of;
	struct hawser__hold hold;
};
enum hawser_status hawser__line_inertia_find(struct hawser__line_inertia *inertia,
                                             const struct hawser__lexpand_modes *own,
                                             struct hawser_report *report) HAWSER_MUST_CHECK;
enum hawser_status hawser__line_inertia_make(struct hawser__line_inertia *inertia,
                                             struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__line_inertia_clear(struct hawser__line_inertia *inertia);
/* The wave k of a passing load as a force along y per length, at the scaled arclength s of a lane;
 * `wave` is a struct hawser__line_wave. line_load.c. */
struct hawser__line_wave {
	double number;    /* scaled */
	int sine;
	double scale[HAWSER_LINE_LANES], first[HAWSER_LINE_LANES]; /* where its phase is 0 */
};
double hawser__line_pull(const void *wave, int lane, double s);
/* Wave i of options->load, of which there are two a harmonic: cosine and sine. */
struct hawser__line_wave hawser__line_wave(const struct hawser_line_modes *modes,
                                           const struct hawser_line_rom_options *options, int i);

/* The expansion of a rope as that of a model; `of` is a struct hawser__line_source. line_answer.c. */
struct hawser__line_source {
	const struct hawser_rom *rom;   /* whose shape points and line are the places */
	const struct hawser__lexpand *t;
	int n;                          /* coordinates */
	double ratio;                   /* damping ratio of each mode */
};
struct hawser__expanded hawser__line_expanded(const struct hawser__line_source *source);
/* What the modes that are not kept do under each wave of the load, or under the drive, with whose pull
 * on the modes. Adds the static parts to the shapes of `own`, which are those of the answers. Clear, on
 * failure too. line_answer.c. */
enum hawser_status hawser__line_answers_make(struct hawser__answers *answers, double *pull,
                                             struct hawser__lexpand_modes *own,
                                             const struct hawser_line_modes *modes,
                                             const struct hawser_line_rom_options *options,
                                             struct hawser_report *report);
/* First scaled arclength and length of a run, over its pieces, and its lane. line.c. */
int hawser__line_run(const struct hawser__lmode *rope, int run, double *s0, double *length);
/* rom->contacts: the arcs on which the rope lies. line_lift.c. */
enum hawser_status hawser__line_contacts(struct hawser_rom *rom, const struct hawser_line_modes *modes,
                                         struct hawser_report *report);

#endif
