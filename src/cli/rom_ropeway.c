/* cli/rom_ropeway.c - hawser rom of a scene of kind `ropeway`: the model of one of its lanes.
 *
 * The lane is that of the statics without speed and without friction. Carriers that pass are smeared
 * over the rope, and their weights are the load; for a drive that does not run evenly they hang where
 * they are. In both cases they are fixed to the rope. A carriage moves with half its mass, since it
 * carries both lanes, and the bullwheels do not turn.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/rom_ropeway.h"
#include "core/report.h"

static const char *const lane_name[] = {"up", "down"};
static const char *const load_name[] = {"passing", "drive"};
enum { PASSING, DRIVE };

/* The lane of the state as a line of its own. */
static enum hawser_status take_lane(struct cli_rom_ropeway *of, int load, struct hawser_report *report)
{
	const struct hawser_ropeway_lane *lane = &of->st.lane[of->lane];
	const struct hawser_ropeway *rw = &of->ropeway;
	double mass = rw->load_case[of->st.load_case].mass[of->lane];

	of->line = *lane->line;
	of->line.speed = 0.0;
	of->line.sliding = HAWSER_LINE_NONE;
	of->line.given = HAWSER_LINE_T_A;
	of->line.value = lane->st.T_A;
	of->mass = calloc((size_t)of->line.masses + 1, sizeof *of->mass);
	if (!of->mass)
		return hawser__no_memory(report, "rom");
	for (int i = 0; i < of->line.masses; i++) {
		of->mass[i] = lane->line->mass[i];
		of->mass[i].hanger = 0.0;
	}
	of->line.mass = of->mass;
	if (load == PASSING) {
		if (!(mass > 0.0 && rw->spacing > 0.0))
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom", "lane %s has no carriers that "
			                    "pass: choose another --lane or --case, or --load drive",
			                    lane_name[of->lane]);
		of->line.masses = 0;
		of->line.rho += mass/rw->spacing;
		of->options.weight = mass*rw->g;
		of->options.spacing = rw->spacing;
	}
	return hawser_line_solve(&of->line_st, &of->line, report);
}

static enum hawser_status choose(struct cli_rom_ropeway *of, int *load, int *load_case,
                                 const struct cli_common *common,
                                 const struct cli_rom_ropeway_choice *choice,
                                 struct hawser_report *report)
{
	enum hawser_status status = cli_ropeway_open(&of->ropeway, load_case, common, "rom",
	                                             &choice->state, report);

	*load = choice->ripple > 0.0 ? DRIVE : PASSING;
	if (!status && choice->load)
		status = cli_choose(load, "rom", "load", choice->load, load_name, 2, report);
	if (!status && choice->lane)
		status = cli_choose(&of->lane, "rom", "lane", choice->lane, lane_name, 2, report);
	if (!status && of->lane >= of->ropeway.lanes)
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom", "--lane down: this ropeway has lane "
		                      "up only");
	if (!status && *load == DRIVE && !(choice->ripple > 0.0))
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom", "--load drive: give the amplitude of "
		                      "the rope's motion at the drive, such as --ripple 0.005 (m)");
	if (!status && *load == PASSING && choice->ripple > 0.0)
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom", "--ripple is the amplitude of --load "
		                      "drive: leave out one of --ripple and --load passing");
	return status;
}

enum hawser_status cli_rom_ropeway_load(struct cli_rom_ropeway *of, struct cli_model *model,
                                        const struct cli_common *common,
                                        const struct cli_rom_ropeway_choice *choice, int n,
                                        struct hawser_report *report)
{
	struct hawser_ropeway_options state = {.load_case = 0};
	const struct hawser_line_statics *lane[1] = {&of->line_st};
	int load;
	enum hawser_status status;

	memset(of, 0, sizeof *of);
	memset(model, 0, sizeof *model);
	model->reproducible = common->reproducible;
	status = choose(of, &load, &state.load_case, common, choice, report);
	if (status)
		return status;
	of->ropeway.sliding = HAWSER_ROPEWAY_REST;
	status = hawser_ropeway_solve(&of->st, &of->ropeway, &state, of->ropeway.phase, report);
	of->options.modes.n = n;
	of->options.modes.contact = of->ropeway.hold == HAWSER_ROPEWAY_HOLD_AUTO
		? HAWSER_LINE_SLIP : (enum hawser_line_contact_kind)(of->ropeway.hold - 1);
	of->options.ratio = choice->damping;
	of->options.load = load == DRIVE ? HAWSER_LINE_LOAD_DRIVE : HAWSER_LINE_LOAD_PASSING;
	of->options.end = 1;
	of->options.amplitude = choice->ripple;
	if (of->ropeway.carriage > 0.0 && of->ropeway.tension <= HAWSER_ROPEWAY_T0) {
		of->freedom = (struct hawser_line_freedom){.name = "carriage",
			.mass = 0.5*of->ropeway.carriage, .end = {{{1.0, 0.0, 0.0}, {0.0}}}};
		of->options.modes.freedom = &of->freedom;
		of->options.modes.freedoms = 1;
	}
	if (!status)
		status = take_lane(of, load, report);
	if (!status)
		status = hawser_line_rom_build(&model->rom, &of->modes, lane, 1, &of->options, report);
	if (!status) {
		model->natural = calloc((size_t)model->rom.n, sizeof *model->natural);
		status = model->natural
		         ? cli_natural(model->natural, &model->naturals, &model->rom, report)
		         : hawser__no_memory(report, "rom");
	}
	return status;
}

void cli_rom_ropeway_comments(struct hawser__table *table, const struct cli_rom_ropeway *of)
{
	const struct hawser_ropeway *rw = &of->ropeway;
	const struct hawser_line_rom_options *o = &of->options;

	hawser__table_comment(table, "lane %s at rest without friction, case %s; T = %.9g N at the bottom "
	                      "station; contact: %s", lane_name[of->lane],
	                      rw->load_case[of->st.load_case].name, of->line_st.T_A,
	                      hawser_line_contact_name(o->modes.contact));
	if (o->load == HAWSER_LINE_LOAD_PASSING) {
		hawser__table_comment(table, "load: weights of %.9g N that pass at %.9g m, whose mass is "
		                      "smeared over the rope; Omega = 2 pi speed/spacing", o->weight,
		                      o->spacing);
		if (rw->speed > 0.0)
			hawser__table_comment(table, "at the drive's %.9g m/s: Omega = %.9g rad/s",
			                      rw->speed, 2.0*M_PI*rw->speed/o->spacing);
	} else {
		hawser__table_comment(table, "load: the rope moves by %.9g m cos(Omega t) at the drive; "
		                      "phase = %.9g m of the carriers", o->amplitude, of->st.phase);
	}
	hawser__table_comment(table, "carriers do not swing; the carriage %s; the bullwheels do not turn",
	                      o->modes.freedoms ? "moves, with half its mass" : "does not move");
	hawser__table_comment(table, "damping ratio %.9g of each mode", o->ratio);
	for (int k = 0; k < of->modes.n; k++) {
		struct hawser_line_lift lift;

		hawser_line_rom_lift(&lift, &of->modes, k);
		if (lift.sheave < 0)
			hawser__table_comment(table, "mode %d: %.9g rad/s, %s", k + 1,
			                      of->modes.mode[k].omega/of->modes.time_unit,
			                      hawser_plane_name(of->modes.mode[k].plane));
		else
			hawser__table_comment(table, "mode %d: %.9g rad/s, %s; the rope leaves %s at u = %.4g, "
			                      "a motion of %.4g m", k + 1,
			                      of->modes.mode[k].omega/of->modes.time_unit,
			                      hawser_plane_name(of->modes.mode[k].plane),
			                      of->line.sheave[lift.sheave].name, lift.amplitude, lift.motion);
	}
}

void cli_rom_ropeway_clear(struct cli_rom_ropeway *of)
{
	hawser_line_modes_clear(&of->modes);
	hawser_line_statics_clear(&of->line_st);
	free(of->mass);
	hawser_ropeway_statics_clear(&of->st);
	hawser_ropeway_clear(&of->ropeway);
	memset(of, 0, sizeof *of);
}
