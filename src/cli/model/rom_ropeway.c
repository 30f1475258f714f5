/* cli/model/rom_ropeway.c - the model of a scene of kind `ropeway`: of its lanes with what joins them,
 * or of one of them. Every command that takes model files takes it.
 *
 * The lanes are those of the statics without speed and without friction; that the rope runs is in the
 * Coriolis forces alone, since the counterweight holds the tension less the momentum. For a drive that
 * does not run evenly the carriers hang where the phase has them. Of carriers that pass the weight is
 * smeared over the rope and, as it varies, the load; their inertia is where the phase has them.
 * --carriers smeared smears all. They are fixed to the rope, or with --carriers swinging, but for those
 * on sheaves, hang from it as pendulums. The drive's bullwheel holds the rope. Of one lane alone the
 * carriage moves with half its mass, since it carries both, and no bullwheel turns.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "cli/model/made.h"
#include "cli/modes/modes_result.h"
#include "core/report.h"

static const char *const lane_name[] = {"up", "down", "both"};
static const char *const load_name[] = {"passing", "drive"};
static const char *const carriers_name[] = {"fixed", "smeared", "swinging"};
enum { PASSING, DRIVE };
enum { SMEARED = 1, SWINGING };
enum { BOTH = HAWSER_ROPEWAY_LANES };

/* A lane as a line of its own, at rest. */
struct lane {
	struct hawser_line line;
	struct hawser_line_mass *mass;
	struct hawser_line_sheave *sheave;
	struct hawser_line_statics st;
};

struct cli_rom_ropeway {
	struct cli_made made;
	struct hawser_ropeway ropeway;
	struct hawser_ropeway_statics st;
	int which, carriers;                   /* up, down, BOTH; 0, SMEARED, SWINGING */
	int lanes;
	struct lane lane[HAWSER_ROPEWAY_LANES];
	struct hawser_line_rom_options options;
	struct hawser_line_freedom freedom[HAWSER_ROPEWAY_FREEDOMS];
	int kept[HAWSER_LINE_ROM_MODES];       /* --keep: what options.kept points to */
};

/* Smear the weights of carriers of this mass over the rope, and their inertia too or leave it where
 * they are. The weight of the rope is rho g, and rho alone is its inertia. */
static void smear(struct lane *lane, double mass, const struct cli_rom_ropeway *of)
{
	double all = lane->line.rho + mass/of->ropeway.spacing;

	if (of->carriers == SMEARED) {
		lane->line.masses = 0;
		lane->line.rho = all;
		return;
	}
	lane->line.g *= all/lane->line.rho;
	for (int i = 0; i < lane->line.masses; i++) {
		lane->mass[i].body = lane->mass[i].mass;
		lane->mass[i].hung = lane->mass[i].mass*of->ropeway.g;
		lane->mass[i].mass = 0.0;
	}
}

/* Carriers of a lane, kg; 0: it has none. */
static double carried(const struct cli_rom_ropeway *of, int which)
{
	const struct hawser_ropeway *rw = &of->ropeway;

	return rw->spacing > 0.0 ? rw->load_case[of->st.load_case].mass[which] : 0.0;
}

/* The lane `which` of the state as lane `at` of the model, with its load. */
static enum hawser_status take_lane(struct cli_rom_ropeway *of, int which, int at,
                                    struct hawser_report *report)
{
	const struct hawser_line_statics *from = &of->st.lane[which].st;
	const struct hawser_ropeway *rw = &of->ropeway;
	struct hawser_line_rom_options *o = &of->options;
	struct lane *lane = &of->lane[at];
	double mass = carried(of, which);
	int passing = o->load == HAWSER_LINE_LOAD_PASSING;

	lane->line = *from->line;
	lane->line.speed = 0.0;
	lane->line.sliding = HAWSER_LINE_NONE;
	lane->line.given = HAWSER_LINE_T_A;
	lane->line.value = from->T_A;
	o->modes.backward[at] = which; /* the lane down runs towards its end A */
	if (o->modes.contact == HAWSER_LINE_SLIP && (passing || rw->speed > 0.0))
		o->running[at] = rw->rho + (mass > 0.0 ? mass/rw->spacing : 0.0);
	lane->mass = calloc((size_t)lane->line.masses + 1, sizeof *lane->mass);
	lane->sheave = calloc((size_t)lane->line.sheaves + 1, sizeof *lane->sheave);
	if (!lane->mass || !lane->sheave)
		return hawser__no_memory(report, "rom");
	for (int i = 0; i < lane->line.sheaves; i++) {
		lane->sheave[i] = from->line->sheave[i];
		if (of->lanes > 1)
			snprintf(lane->sheave[i].name, sizeof lane->sheave[i].name, "%.25s %s",
			         from->line->sheave[i].name, lane_name[which]);
	}
	for (int i = 0; i < lane->line.masses; i++) {
		lane->mass[i] = from->line->mass[i];
		lane->mass[i].hanger = of->carriers == SWINGING ? rw->hanger : 0.0;
	}
	lane->line.mass = lane->mass;
	lane->line.sheave = lane->sheave;
	if (passing) {
		o->weight[at] = mass*rw->g;
		o->first[at] = which ? rw->phase_down : rw->phase;
	} else {
		o->amplitude[at] *= which ? -1.0 : 1.0;
	}
	if (mass > 0.0 && (passing || of->carriers == SMEARED))
		smear(lane, mass, of);
	return hawser_line_solve(&lane->st, &lane->line, report);
}

/* The lanes, and what moves their ends. */
static enum hawser_status take_lanes(struct cli_rom_ropeway *of, struct hawser_report *report)
{
	int both = of->which == BOTH, first = both ? HAWSER_ROPEWAY_UP : of->which;
	struct hawser_ropeway_statics alike = of->st;
	enum hawser_status status = HAWSER_OK;
	double most = 0.0;

	of->lanes = both ? HAWSER_ROPEWAY_LANES : 1;
	for (int i = 0; i < of->lanes; i++)
		most = fmax(most, carried(of, first + i));
	if (of->options.load == HAWSER_LINE_LOAD_PASSING && !(most > 0.0))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom", "no carriers pass on %s: choose "
		                    "another --lane or --case, or --load drive", both ? "the lanes"
		                    : of->which ? "lane down" : "lane up");
	if (of->carriers == SWINGING && !(of->ropeway.hanger > 0.0))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom", "--carriers swinging: give the length "
		                    "by which they hang, such as ropeway.carriers.hanger: 4 m");
	if (both && of->carriers == SMEARED && carried(of, 0) != carried(of, 1))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom", "--carriers smeared: the lanes have "
		                    "carriers of %.9g kg and %.9g kg, and the mass of the rope is the same on "
		                    "both: give --lane up or down", carried(of, 0), carried(of, 1));
	of->options.spacing = of->ropeway.spacing;
	of->options.speed = of->ropeway.speed;
	for (int i = 0; i < of->lanes && !status; i++) {
		status = take_lane(of, first + i, i, report);
		alike.lane[i].st = of->lane[i].st;
	}
	alike.lanes = of->lanes;
	of->options.modes.freedom = of->freedom;
	of->options.modes.freedoms = hawser_ropeway_freedoms(of->freedom, &alike);
	return status;
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
		status = cli_choose(&of->carriers, "rom", "carriers", choice->carriers, carriers_name, 3,
		                    report);
	of->which = status || of->ropeway.lanes < HAWSER_ROPEWAY_LANES ? HAWSER_ROPEWAY_UP : BOTH;
	if (!status && choice->lane)
		status = cli_choose(&of->which, "rom", "lane", choice->lane, lane_name, 3, report);
	if (!status && of->which > 0 && of->ropeway.lanes < HAWSER_ROPEWAY_LANES)
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom", "--lane %s: this ropeway has lane "
		                      "up only", choice->lane);
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
	const struct hawser_line_statics *lane[] = {&of->lane[0].st, &of->lane[1].st};
	int load;
	enum hawser_status status = choose(of, &load, &state.load_case, common, report);

	if (status)
		return status;
	of->ropeway.sliding = HAWSER_ROPEWAY_REST;
	of->ropeway.coasts = 0; /* a loop that circulates freely has no response */
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
	of->options.amplitude[0] = of->options.amplitude[1] = common->lane.ripple;
	if (!status)
		status = take_lanes(of, report);
	if (!status)
		status = hawser_line_rom_build(rom, &of->made.modes.lines, lane, of->lanes, &of->options,
		                               report);
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
	const struct hawser_line_statics *lane[] = {&of->lane[0].st, &of->lane[1].st};
	struct hawser_line_rom_options options = of->options;
	enum hawser_status status;

	options.modes.n = n;
	options.condensed = !kept; /* candidates of a choice: modes alone */
	options.kept = kept;
	options.count = count;
	status = hawser_line_rom_build(rom, &modes->lines, lane, of->lanes, &options, report);
	borrow(modes);
	return status;
}

/* Which lanes there are, and in what order. */
static void lane_comments(struct hawser__table *table, const struct cli_rom_ropeway *of)
{
	const struct hawser_line_modes *modes = &of->made.modes.lines;
	int first = of->which == BOTH ? HAWSER_ROPEWAY_UP : of->which, last = -1;

	for (int i = 0; i < of->lanes; i++)
		hawser__table_comment(table, "lane %s without friction, case %s; T = %.9g N at the bottom "
		                      "station, less the momentum that runs; contact: %s",
		                      lane_name[first + i], of->ropeway.load_case[of->st.load_case].name,
		                      of->lane[i].st.T_A, hawser_line_contact_name(of->options.modes.contact));
	for (int p = 0; p < modes->pieces && of->lanes > 1; p++)
		if (modes->piece[p].lane == 0 && modes->piece[p].span > last)
			last = modes->piece[p].span;
	if (of->lanes > 1)
		hawser__table_comment(table, "spans 1 to %d are of lane up, %d to %d of lane down, from the "
		                      "bottom station", last + 1, last + 2, modes->spans);
}

static void load_comments(struct hawser__table *table, const struct cli_rom_ropeway *of)
{
	const struct hawser_line_rom_options *o = &of->options;
	double speed = of->ropeway.speed;

	if (o->load == HAWSER_LINE_LOAD_DRIVE)
		hawser__table_comment(table, "load: the rope moves by %.9g m cos(Omega t) at the drive",
		                      fabs(o->amplitude[0]));
	for (int i = 0; i < of->lanes && o->load == HAWSER_LINE_LOAD_PASSING; i++)
		if (o->weight[i] > 0.0)
			hawser__table_comment(table, "load%s: weights of %.9g N that pass at %.9g m, whose mean is "
			                      "smeared over the rope; Omega = 2 pi speed/spacing",
			                      of->lanes == 1 ? "" : i ? " of lane down" : " of lane up",
			                      o->weight[i], o->spacing);
	if (o->load == HAWSER_LINE_LOAD_PASSING && speed > 0.0)
		hawser__table_comment(table, "at the drive's %.9g m/s: Omega = %.9g rad/s", speed,
		                      2.0*M_PI*speed/o->spacing);
	for (int i = 0; i < of->lanes; i++) {
		const char *lane = of->lanes == 1 ? "" : i ? " of lane down" : " of lane up";

		if (o->running[i] > 0.0 && o->load == HAWSER_LINE_LOAD_PASSING)
			hawser__table_comment(table, "the rope%s runs with its carriers: Coriolis forces of %.9g "
			                      "kg/m", lane, o->running[i]);
		else if (o->running[i] > 0.0)
			hawser__table_comment(table, "the rope%s runs with its carriers at %.9g m/s: Coriolis "
			                      "forces of %.9g kg/m", lane, o->speed, o->running[i]);
	}
	if (!(o->running[0] > 0.0))
		hawser__table_comment(table, "the rope does not run: no Coriolis forces");
}

/* Whether and how many carriers swing. */
static void carrier_comments(struct hawser__table *table, const struct cli_rom_ropeway *of)
{
	int all = 0, on = 0;

	for (int i = 0; i < of->lanes; i++)
		for (int k = 0; k < of->lane[i].line.masses; k++) {
			all += of->lane[i].st.carrier[k].present;
			on += of->lane[i].st.carrier[k].state > 0;
		}
	if (of->carriers == SMEARED)
		hawser__table_comment(table, "the mass of the carriers is smeared over the rope");
	else if (all > 0)
		hawser__table_comment(table, "the mass of the carriers is at their phase = %.9g m",
		                      of->st.phase);
	if (of->carriers == SWINGING)
		hawser__table_comment(table, "%d carriers swing on hangers of %.9g m", all - on,
		                      of->ropeway.hanger);
	if (of->carriers == SWINGING && on > 0)
		hawser__table_comment(table, "carriers on sheaves do not swing: %d", on);
	if (of->carriers != SWINGING)
		hawser__table_comment(table, "carriers do not swing%s", of->ropeway.hanger > 0.0
		                      ? ": --carriers swinging lets them" : "");
}

/* What does not move, or with what mass. */
static void body_comments(struct hawser__table *table, const struct cli_rom_ropeway *of)
{
	const struct hawser_line_modes_options *o = &of->options.modes;
	int carriage = o->freedoms > (of->lanes > 1);

	if (of->lanes > 1)
		hawser__table_comment(table, "the carriage %s; the bottom bullwheel turns, that of the drive "
		                      "does not", carriage ? "moves" : "does not move");
	else
		hawser__table_comment(table, "the carriage %s; the bullwheels do not turn", carriage
		                      ? "moves, with half its mass" : "does not move");
}

static void comments(struct hawser__table *table, const struct cli_model *model)
{
	const struct cli_rom_ropeway *of = (const struct cli_rom_ropeway *)model->made;
	const struct hawser_line_modes *modes = &of->made.modes.lines;

	lane_comments(table, of);
	load_comments(table, of);
	carrier_comments(table, of);
	body_comments(table, of);
	hawser__table_comment(table, "damping ratio %.9g of each mode", of->options.ratio);
	cli_made_chosen(table, model);
	cli_made_inertia(table, &model->rom);
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
			                      of->lane[lift.lane].line.sheave[lift.sheave].name,
			                      lift.amplitude, lift.motion);
	}
}

static enum hawser_status animate(const char *path, const struct cli_model *model,
                                  const struct hawser_net_rom_motion *motion,
                                  struct hawser_report *report)
{
	const struct cli_rom_ropeway *of = (const struct cli_rom_ropeway *)model->made;

	return cli_film_ropeway(path, &of->made.modes.lines, motion, model->rom.n,
	                        2.0*of->ropeway.bottom_radius, report);
}

static void clear(struct cli_made *made)
{
	struct cli_rom_ropeway *of = (struct cli_rom_ropeway *)made;

	for (int i = 0; i < HAWSER_ROPEWAY_LANES; i++) {
		hawser_line_statics_clear(&of->lane[i].st);
		free(of->lane[i].mass);
		free(of->lane[i].sheave);
	}
	hawser_ropeway_statics_clear(&of->st);
	hawser_ropeway_clear(&of->ropeway);
}

const struct cli_maker cli_maker_ropeway = {
	.called = "a ropeway", .many = "ropeways", .most = HAWSER_LINE_ROM_MODES,
	.still = "a ropeway, whose ends do not move by a table: its drive does, as --load drive",
	.load = load, .again = again, .comments = comments, .animate = animate, .clear = clear};
