/* hawser/line_rom.h - the nonlinear response of a rope over sheaves: its modes as the coordinates
 * of a reduced model (rom.h), with the loads of carriers that pass and of a drive that does not
 * run evenly.
 *
 * The strain energy of spans and arcs, the motion of the points at which the rope leaves the
 * sheaves, and the static response of the modes that are not kept are in the tensors Q and C
 * (doc/theory-ropeway-response.md); what the load makes of these modes is in `answer` and `known`
 * of its harmonics, and changes displacements and tensions only. Masses on hangers swing, but for those
 * on sheaves. A model is that of contacts that stay:
 * hawser_line_rom_lift says up to which amplitude they do.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_LINE_ROM_H
#define HAWSER_LINE_ROM_H

#include <hawser/line_modes.h>
#include <hawser/rom.h>

#ifdef __cplusplus
extern "C" {
#endif

enum hawser_line_load {
	HAWSER_LINE_LOAD_NONE = 0,
	HAWSER_LINE_LOAD_PASSING, /* equal weights that pass along the rope at equal distances */
	HAWSER_LINE_LOAD_DRIVE    /* an end that moves along the rope harmonically */
};

enum { HAWSER_LINE_ROM_MODES = 40 }; /* most coordinates of a model */

struct hawser_line_rom_options {
	struct hawser_line_modes_options modes; /* which modes are coordinates, and the contact: slip or
	                                         * stick. With n of at most HAWSER_LINE_ROM_MODES */
	const int *kept;       /* [count] indices of the modes that are coordinates, ascending; NULL: all.
	                        * The others follow */
	int count;
	int held;              /* 1: the rope leaves each sheave at a material point, as in linear
	                        * theory: for comparison */
	int condensed;         /* 1: no coordinates for the inertia of what follows, which models of
	                        * at most 12 modes have */
	double ratio;          /* damping ratio of each mode; 0: none */
	enum hawser_line_load load;
	double running[HAWSER_LINE_LANES]; /* kg/m: rho, and carriers that run with the rope over their
	                        * spacing; 0: it does not run. From A to B, or modes.backward. Tensions
	                        * are then apparent ones: less running times the speed squared */
	/* Passing: the frequency of the model is 2 pi times speed over spacing. The weights of the
	 * carriers are smeared over the rope in the statics: in rho, with no masses on it; or in g, with
	 * masses that have a body where the carriers are at one phase. */
	double weight[HAWSER_LINE_LANES]; /* N; 0: none pass along this lane */
	double first[HAWSER_LINE_LANES];  /* m, S of one of them at the time 0 */
	double spacing;         /* m (unstretched) */
	int harmonics;          /* multiples of the frequency; 0: 3 */
	/* Drive */
	int end;                /* 0: end A moves, 1: end B */
	double amplitude[HAWSER_LINE_LANES]; /* m, along the rope from A to B; negative: back */
	double speed;           /* m/s, of the rope that runs */
};
void hawser_line_rom_settle(struct hawser_line_rom_options *options);

/* A model whose coordinates are the lowest modes of the rope, and those modes; behind them, as
 * coordinates, second-order shapes where the inertia of what follows matters at the amplitudes that the
 * load causes (rom->inertia). Shape points are the
 * middles of the spans, "span_1" and so on over all lanes, and the line has the ends and the
 * middle of every piece. *rom and *modes are overwritten; release them with hawser_rom_clear and
 * hawser_line_modes_clear. Statuses of hawser_line_modes_solve; HAWSER_ERR_ARGUMENT also for what
 * the model does not cover: a rope that runs, sheaves of radius 0, contact roll, a loop
 * that circulates freely. */
enum hawser_status hawser_line_rom_build(struct hawser_rom *rom, struct hawser_line_modes *modes,
                                         const struct hawser_line_statics *const *lane, int lanes,
                                         const struct hawser_line_rom_options *options,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;

/* Where, and at which amplitude, a motion in one mode alone takes the rope off a sheave: its
 * slopes before and behind it change, by the linear motion, by as much as the angle of contact. */
struct hawser_line_lift {
	int lane, sheave;   /* -1: no sheave is relieved by this mode */
	double amplitude;   /* of the coordinate, scaled; INFINITY if none */
	double motion;      /* m, largest displacement of the rope in this mode at that amplitude */
	double force;       /* N, of the sheave on the rope at rest */
};
/* Of mode k of real modes. */
void hawser_line_rom_lift(struct hawser_line_lift *lift, const struct hawser_line_modes *modes,
                          int k);

#ifdef __cplusplus
}
#endif
#endif
