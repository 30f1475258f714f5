/* cli/model/rom_ropeway.c - the model of a scene of kind `ropeway`: of one of its lanes. Every
 * command that takes model files takes it.
 *
 * The lane is that of the statics without speed and without friction; that the rope runs is in the
 * Coriolis forces alone, since the counterweight holds the tension less the momentum. For a drive that
 * does not run evenly the carriers hang where the phase has them. Of carriers that pass the weight is
 * smeared over the rope and, as it varies, the load; their inertia is where the phase has them.
 * --carriers smeared smears all. In all cases they are fixed to the rope. A carriage moves with half
 * its mass, since it carries both lanes, and the bullwheels do not turn.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/model/made.h"
#include "cli/modes/modes_ropeway.h"
#include "core/report.h"

static const char *const lane_name[] = {"up", "down"};
static const char *const load_name[] = {"passing", "drive"};
static const char *const carriers_name[] = {"fixed", "smeared"};
enum { PASSING, DRIVE };

/* One lane of a ropeway as a model. */
struct cli_rom_ropeway {
	struct cli_made made;
	struct hawser_ropeway ropeway;
	struct hawser_ropeway_statics st;
	int lane, smeared;
	struct hawser_line line;               /* at rest */
	struct hawser_line_mass *mass;
	struct hawser_line_statics line_st;
	struct hawser_line_rom_options options;
	struct hawser_line_freedom freedom;    /* the carriage */
	int kept[HAWSER_LINE_ROM_MODES];       /* --keep: what options.kept points to */
};

/* Smear the weights of carriers of this mass over the rope, and their inertia too or leave it where
 * they are. The weight of the rope is rho g, and rho alone is its inertia. */
static void smear(struct cli_rom_ropeway *of, double mass)
{
	double all = of->line.rho + mass/of->ropeway.spacing;

	if (of->smeared) {
		of->line.masses = 0;
		of->line.rho = all;
		return;
	}
	of->line.g *= all/of->line.rho;
	for (int i = 0; i < of->line.masses; i++) {
		of->mass[i].body = of->mass[i].mass;
		of->mass[i].mass = 0.0;
	}
}

/* The lane of the state as a line of its own. */
static enum hawser_status take_lane(struct cli_rom_ropeway *of, int load, struct hawser_report *report)
{
	const struct hawser_ropeway_lane *lane = &of->st.lane[of->lane];
	const struct hawser_ropeway *rw = &of->ropeway;
	double mass = rw->load_case[of->st.load_case].mass[of->lane];
	int carries = mass > 0.0 && rw->spacing > 0.0;

	of->line = *lane->line;
	of->line.speed = 0.0;
	of->line.sliding = HAWSER_LINE_NONE;
	of->line.given = HAWSER_LINE_T_A;
	of->line.value = lane->st.T_A;
	of->options.modes.backward[0] = of->lane; /* the lane down runs towards its end A */
	of->options.speed = rw->speed;
	if (of->options.modes.contact == HAWSER_LINE_SLIP && (load == PASSING || rw->speed > 0.0))
		of->options.running = rw->rho + (carries ? mass/rw->spacing : 0.0);
	of->mass = calloc((size_t)of->line.masses + 1, sizeof *of->mass);
	if (!of->mass)
		return hawser__no_memory(report, "rom");
	for (int i = 0; i < of->line.masses; i++) {
		of->mass[i] = lane->line->mass[i];
		of->mass[i].hanger = 0.0;
	}
	of->line.mass = of->mass;
	if (load == PASSING && !carries)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom", "lane %s has no carriers that "
		                    "pass: choose another --lane or --case, or --load drive",
		                    lane_name[of->lane]);
	if (load == PASSING) {
		of->options.weight = mass*rw->g;
		of->options.spacing = rw->spacing;
	}
	if (carries && (load == PASSING || of->smeared))
		smear(of, mass);
	return hawser_line_solve(&of->line_st, &of->line, report);
}

static enum hawser_status choose(struct cli_rom_ropeway *of, int *load, int *load_case,
                                 const struct cli_common *common, struct hawser_report *report)
{
	const struct cli_lane_choice *choice = &common->lane;
	const struct cli_ropeway_choice state = {.contact = choice->contact,
	                                         .load_case = choice->load_case};
	enum hawser_status status = cli_ropeway_open(&of->ropeway, load_case, common, "rom", &state,
	                                             report);

	*load = choice->ripple > 0.0 ? DRIVE : PASSING;
	if (!status && choice->load)
		status = cli_choose(load, "rom", "load", choice->load, load_name, 2, report);
	if (!status && choice->carriers)
		status = cli_choose(&of->smeared, "rom", "carriers", choice->carriers, carriers_name, 2,
		                    report);
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

static void borrow(struct cli_made_modes *modes)
{
	modes->modes = (struct hawser_modes){.n = modes->lines.n, .mode = modes->lines.mode,
	                                     .time_unit = modes->lines.time_unit};
}

static enum hawser_status make(struct cli_rom_ropeway *of, struct hawser_rom *rom,
                               const struct cli_common *common, int n, struct hawser_report *report)
{
	struct hawser_ropeway_options state = {.load_case = 0};
	const struct hawser_line_statics *lane[1] = {&of->line_st};
	int load;
	enum hawser_status status = choose(of, &load, &state.load_case, common, report);

	if (status)
		return status;
	of->ropeway.sliding = HAWSER_ROPEWAY_REST;
	status = hawser_ropeway_solve(&of->st, &of->ropeway, &state, of->ropeway.phase, report);
	of->options.modes.n = n;
	if (common->lane.keep) {
		if (!status)
			status = cli_made_keep(of->kept, &of->options.count, &of->options.modes.n,
			                       common->lane.keep, &cli_maker_ropeway, report);
		if (status)
			return status;
		of->options.kept = of->kept;
	}
	of->options.modes.contact = of->ropeway.hold == HAWSER_ROPEWAY_HOLD_AUTO
		? HAWSER_LINE_SLIP : (enum hawser_line_contact_kind)(of->ropeway.hold - 1);
	of->options.ratio = common->lane.damping;
	of->options.load = load == DRIVE ? HAWSER_LINE_LOAD_DRIVE : HAWSER_LINE_LOAD_PASSING;
	of->options.end = 1;
	of->options.amplitude = common->lane.ripple;
	if (of->ropeway.carriage > 0.0 && of->ropeway.tension <= HAWSER_ROPEWAY_T0) {
		of->freedom = (struct hawser_line_freedom){.name = "carriage",
			.mass = 0.5*of->ropeway.carriage, .end = {{{1.0, 0.0, 0.0}, {0.0}}}};
		of->options.modes.freedom = &of->freedom;
		of->options.modes.freedoms = 1;
	}
	if (!status)
		status = take_lane(of, load, report);
	if (!status)
		status = hawser_line_rom_build(rom, &of->made.modes.lines, lane, 1, &of->options, report);
	borrow(&of->made.modes);
	return status;
}

static enum hawser_status load(struct cli_model *model, const struct cli_common *common, int n,
                               struct hawser_report *report)
{
	struct cli_rom_ropeway *of = calloc(1, sizeof *of);

	if (!of)
		return hawser__no_memory(report, "rom");
	model->made = &of->made;
	of->made.by = &cli_maker_ropeway;
	return make(of, &model->rom, common, n, report);
}

static enum hawser_status again(struct hawser_rom *rom, struct cli_made_modes *modes,
                                const struct cli_made *made, int n, const int *kept, int count,
                                struct hawser_report *report)
{
	const struct cli_rom_ropeway *of = (const struct cli_rom_ropeway *)made;
	const struct hawser_line_statics *lane[1] = {&of->line_st};
	struct hawser_line_rom_options options = of->options;
	enum hawser_status status;

	options.modes.n = n;
	options.kept = kept;
	options.count = count;
	status = hawser_line_rom_build(rom, &modes->lines, lane, 1, &options, report);
	borrow(modes);
	return status;
}

static void comments(struct hawser__table *table, const struct cli_model *model)
{
	const struct cli_rom_ropeway *of = (const struct cli_rom_ropeway *)model->made;
	const struct hawser_line_modes *modes = &of->made.modes.lines;
	const struct hawser_ropeway *rw = &of->ropeway;
	const struct hawser_line_rom_options *o = &of->options;

	hawser__table_comment(table, "lane %s without friction, case %s; T = %.9g N at the bottom station, "
	                      "less the momentum that runs; contact: %s", lane_name[of->lane],
	                      rw->load_case[of->st.load_case].name, of->line_st.T_A,
	                      hawser_line_contact_name(o->modes.contact));
	if (o->load == HAWSER_LINE_LOAD_PASSING) {
		hawser__table_comment(table, "load: weights of %.9g N that pass at %.9g m, whose mean is "
		                      "smeared over the rope; Omega = 2 pi speed/spacing", o->weight,
		                      o->spacing);
		if (rw->speed > 0.0)
			hawser__table_comment(table, "at the drive's %.9g m/s: Omega = %.9g rad/s",
			                      rw->speed, 2.0*M_PI*rw->speed/o->spacing);
	} else {
		hawser__table_comment(table, "load: the rope moves by %.9g m cos(Omega t) at the drive",
		                      o->amplitude);
	}
	if (o->running > 0.0 && o->load == HAWSER_LINE_LOAD_PASSING)
		hawser__table_comment(table, "the rope runs with its carriers: Coriolis forces of %.9g kg/m",
		                      o->running);
	else if (o->running > 0.0)
		hawser__table_comment(table, "the rope runs with its carriers at %.9g m/s: Coriolis forces of "
		                      "%.9g kg/m", o->speed, o->running);
	else
		hawser__table_comment(table, "the rope does not run: no Coriolis forces");
	if (of->smeared)
		hawser__table_comment(table, "the mass of the carriers is smeared over the rope");
	else if (of->line.masses > 0)
		hawser__table_comment(table, "the mass of the carriers is at their phase = %.9g m",
		                      of->st.phase);
	hawser__table_comment(table, "carriers do not swing; the carriage %s; the bullwheels do not turn",
	                      o->modes.freedoms ? "moves, with half its mass" : "does not move");
	hawser__table_comment(table, "damping ratio %.9g of each mode", o->ratio);
	cli_made_chosen(table, model);
	for (int k = 0; k < modes->n; k++) {
		const char *load = cli_made_loaded(&model->rom, k) ? "" : "; no load acts on it";
		int place = modes->mode[k].place;
		struct hawser_line_lift lift;

		hawser_line_rom_lift(&lift, modes, k);
		if (lift.sheave < 0)
			hawser__table_comment(table, "mode %d: %.9g rad/s, %s%s", place,
			                      modes->mode[k].omega/modes->time_unit,
			                      hawser_plane_name(modes->mode[k].plane), load);
		else
			hawser__table_comment(table, "mode %d: %.9g rad/s, %s%s; the rope leaves %s at u = %.4g, "
			                      "a motion of %.4g m", place,
			                      modes->mode[k].omega/modes->time_unit,
			                      hawser_plane_name(modes->mode[k].plane), load,
			                      of->line.sheave[lift.sheave].name, lift.amplitude, lift.motion);
	}
}

static void clear(struct cli_made *made)
{
	struct cli_rom_ropeway *of = (struct cli_rom_ropeway *)made;

	hawser_line_statics_clear(&of->line_st);
	free(of->mass);
	hawser_ropeway_statics_clear(&of->st);
	hawser_ropeway_clear(&of->ropeway);
}

const struct cli_maker cli_maker_ropeway = {
	.called = "a ropeway", .many = "ropeways", .most = HAWSER_LINE_ROM_MODES,
	.still = "a ropeway, whose ends do not move by a table: its drive does, as --load drive",
	.load = load, .again = again, .comments = comments, .clear = clear};
