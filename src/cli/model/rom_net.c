/* cli/model/rom_net.c - the model of a scene of kind `net` (hawser/net_rom.h). Every command that takes
 * model files takes it. SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/scene_family.h>

#include "cli/model/key_sweep.h"
#include "cli/model/made.h"
#include "cli/motion/integrate_net.h"
#include "core/report.h"

struct cli_rom_net {
	struct cli_made made;
	struct hawser_net net;
	int kept[HAWSER_NET_ROM_MODES]; /* --keep */
	int n, count;                   /* --modes, or the last one that is kept; entries of kept */
	struct cli_common common;       /* it was read with */
	const char *key;                /* of a family */
};

/* candidates: of a choice, whose coordinates are modes alone. */
static enum hawser_status build(struct hawser_rom *rom, struct cli_made_modes *modes,
                                const struct cli_made *made, int n, const int *kept, int count,
                                int candidates, struct hawser_report *report)
{
	const struct cli_rom_net *of = (const struct cli_rom_net *)made;
	const struct hawser_net_rom_options options = {.n = n, .kept = kept, .count = count,
	                                               .condensed = candidates, .alone = &modes->alone};

	return hawser_net_rom_build(rom, &modes->modes, &of->net, &options, report);
}

static enum hawser_status again(struct hawser_rom *rom, struct cli_made_modes *modes,
                                const struct cli_made *made, int n, const int *kept, int count,
                                struct hawser_report *report)
{
	return build(rom, modes, made, n, kept, count, !kept, report);
}

/* Shape points of joints come first, in the order of the nodes. */
static int count_joints(const struct hawser_rom_shapes *shapes, const struct hawser_net *net)
{
	int count = 0;

	for (int i = 0; i < net->nodes && count < shapes->points; i++)
		count += strcmp(shapes->name[count], net->node[i].name) == 0;
	return count;
}

/* The first harmonic of loads that run along a rope; NULL: there are none. */
static const struct hawser_net_load *running(const struct hawser_net *net)
{
	const struct hawser_net_load *first = NULL;

	for (int i = 0; i < net->loads; i++) {
		const struct hawser_net_load *load = &net->load[i];

		if (load->harmonic && load->wavelength != 0.0 &&
		    (!first || fabs(load->wavelength) > fabs(first->wavelength)))
			first = load;
	}
	return first;
}

static enum hawser_status load(struct cli_model *model, const struct cli_common *common, int n,
                               struct hawser_report *report)
{
	struct cli_rom_net *of = calloc(1, sizeof *of);
	enum hawser_status status;

	if (!of)
		return hawser__no_memory(report, "rom");
	model->made = &of->made;
	of->made.by = &cli_maker_net;
	of->common = *common;
	status = cli_read_net(&of->net, common, report);
	if (!status)
		status = hawser_net_refine(&of->net, report);
	if (!status && common->lane.keep)
		status = cli_made_keep(of->kept, &of->count, &n, common->lane.keep, &cli_maker_net, report);
	of->n = n;
	if (!status)
		status = build(&model->rom, &of->made.modes, &of->made, n, of->count ? of->kept : NULL,
		               of->count, 0, report);
	if (!status && running(&of->net))
		of->made.passing = running(&of->net)->Omega;
	if (!status && of->net.water.waves.count)
		of->made.breaking = hawser_wave_breaking(of->net.water.given.height, of->net.water.depth,
		                                         of->net.g > 0.0 ? of->net.g : 9.81);
	if (!status)
		of->made.joints = count_joints(&model->rom.shapes, &of->net);
	return status;
}

/* The options of the model: those it was loaded with, or of a choice, with room for the modes. */
static struct hawser_net_rom_options options_of(int kept[HAWSER_NET_ROM_MODES],
                                                const struct cli_rom_net *of)
{
	const struct hawser_modes *modes = &of->made.modes.modes;

	for (int k = 0; k < modes->n; k++)
		kept[k] = modes->mode[k].place - 1;
	if (of->made.chosen > 0)
		return (struct hawser_net_rom_options){.n = of->made.chosen, .kept = kept, .count = modes->n};
	return (struct hawser_net_rom_options){.n = of->n, .count = of->count,
	                                       .kept = of->count ? of->kept : NULL};
}

static enum hawser_status certify(struct cli_certificate *certificate,
                                  const struct cli_frf_result *result, double bearable,
                                  struct hawser_report *report)
{
	const struct cli_rom_net *of = (const struct cli_rom_net *)result->model->made;
	struct hawser_certificate *own = &certificate->own;
	int kept[HAWSER_NET_ROM_MODES];
	const struct hawser_net_rom_options options = options_of(kept, of);
	enum hawser_status status = hawser_net_certify(own, &of->net, &options, &result->model->rom,
	                                               result->frf, result->peak, result->peaks, bearable,
	                                               report);

	for (int k = 0; k < own->count && !status; k++)
		certificate->cable[k] = isfinite(own->item[k].tension) ? of->net.cable[own->item[k].cable].name
		                                                       : NULL;
	return status;
}

static int add_frame(void *film, const struct hawser_net_frame *frame)
{
	return cli_film_add(film, frame);
}

static enum hawser_status animate(const char *path, const struct cli_model *model,
                                  const struct hawser_net_rom_motion *motion,
                                  struct hawser_report *report)
{
	const struct cli_rom_net *of = (const struct cli_rom_net *)model->made;
	struct cli_film film = {.room = motion->rows, .last = motion->rows - 1.0};
	struct hawser_net_rom_motion own = *motion;
	int kept[HAWSER_NET_ROM_MODES];
	const struct hawser_net_rom_options options = options_of(kept, of);
	enum hawser_status status;

	own.frame = add_frame;
	own.data = &film;
	status = hawser_net_rom_show(&of->net, &options, &own, report);
	if (!status && film.rows < motion->rows)
		status = hawser__no_memory(report, "animation");
	if (!status) {
		cli_film_magnify(&film);
		status = cli_film_write(path, &film, &of->net, report);
	}
	cli_film_clear(&film);
	return status;
}

static void comments(struct hawser__table *table, const struct cli_model *model)
{
	const struct cli_rom_net *of = (const struct cli_rom_net *)model->made;
	const struct hawser_modes *modes = &of->made.modes.modes;
	const struct hawser_net_load *wave = running(&of->net);
	double distance = wave ? fabs(wave->wavelength) : NAN;
	long elements = 0;

	for (int c = 0; c < of->net.cables; c++)
		elements += of->net.cable[c].elements;
	hawser__table_comment(table, "a net of %d cables with %ld elements", of->net.cables, elements);
	cli_made_chosen(table, model);
	if (wave)
		hawser__table_comment(table, "loads run along the rope at the speed Omega*%.9g m/(2 pi): 1 "
		                      "rad/s is %.6g m/s", distance, distance/(2.0*M_PI));
	if (wave && wave->Omega > 0.0)
		hawser__table_comment(table, "the scene's own speed, %.9g m/s, is Omega = %.9g rad/s; "
		                      "responses are over Omega, whatever it is",
		                      wave->Omega*distance/(2.0*M_PI), wave->Omega);
	if (of->made.breaking > 0.0)
		hawser__table_comment(table, "waves of the height %.9g m and the frequency Omega, which break "
		                      "above %.6g rad/s", of->net.water.given.height, of->made.breaking);
	cli_made_inertia(table, &model->rom);
	for (int k = 0; k < modes->n; k++)
		hawser__table_comment(table, "u_%d: mode %d: %.9g rad/s%s", k + 1, modes->mode[k].place,
		                      modes->mode[k].omega/modes->time_unit,
		                      cli_made_loaded(&model->rom, k) ? "" : "; no load acts on it");
}

/* The net at a value of the key, with the elements that it has. */
static enum hawser_status net_at(void *context, struct hawser_net *net, double p,
                                 struct hawser_report *report)
{
	const struct cli_rom_net *of = context;
	struct cli_key_sweep key = {.points = 1};
	char set[CLI_KEY_SWEEP_SET];
	struct cli_common common;
	enum hawser_status status;

	snprintf(key.key, sizeof key.key, "%s", of->key);
	cli_key_sweep_at(&common, set, &key, &of->common, p);
	status = cli_read_net(net, &common, report);
	for (int c = 0; !status && c < net->cables; c++)
		net->cable[c].elements = of->net.cable[c].elements;
	return status;
}

static enum hawser_status family(struct hawser_rom_family *to,
                                 void (**close)(struct hawser_rom_family *), struct cli_made *made,
                                 const char *key, const double range[2], double at, double omega,
                                 struct hawser_report *report)
{
	struct cli_rom_net *of = (struct cli_rom_net *)made;
	const struct hawser_net_at nets = {net_at, of};
	int kept[HAWSER_NET_ROM_MODES];
	const struct hawser_net_rom_options options = options_of(kept, of);

	of->key = key;
	if (strcmp(key, "water.waves.period") == 0 || strcmp(key, "water.ramp") == 0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
		                    "%s changes no response: waves have the frequency Omega and all their "
		                    "height; give the frequency by --Omega, or follow water.waves.height", key);
	*close = hawser_net_family_close;
	return hawser_net_family_open(to, &nets, &options, range[0], range[1], at, omega, report);
}

static void clear(struct cli_made *made)
{
	hawser_net_clear(&((struct cli_rom_net *)made)->net);
}

const struct cli_maker cli_maker_net = {
	.called = "a net", .many = "nets", .most = HAWSER_NET_ROM_MODES, .clusters = 1,
	.still = "a net, whose mesh moves by tables: hawser integrate, with supports.NAME.table",
	.load = load, .again = again, .comments = comments, .certify = certify, .animate = animate,
	.family = family, .clear = clear};
