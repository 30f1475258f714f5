/* cli/tools/records.c - the records of the kinds of inputs (cli/frame/kinds.h).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/frame/kinds.h"
#include "cli/model/made.h"
#include "cli/statics/statics_kinds.h"
#include "cli/tools/init_scenes.h"
#include "core/append.h"

/* The entry `look` of a kind whose scene is a struct hawser_NAME; `facts` writes the lines, and may say
 * that nothing forces it. */
#define LOOK(name, facts) \
	static enum hawser_status look_##name(char *text, int *forced, const struct cli_common *common, \
	                                      struct hawser_report *report) \
	{ \
		struct hawser_##name of; \
		enum hawser_status status = cli_read_##name(&of, common, report); \
	\
		if (status) \
			return status; \
		facts(text, forced, &of); \
		hawser_##name##_clear(&of); \
		return HAWSER_OK; \
	}

static void water_facts(char *text, const struct hawser_water *water)
{
	if (water->density > 0.0 && !water->air)
		hawser__append(text, CLI_SCENE_FACTS, "", "  water: below y = %.6g m%s%s\n", water->surface,
		               water->levels ? ", with a current" : "",
		               water->waves.count ? ", with waves" : "");
}

static void net_facts(char *text, int *forced, const struct hawser_net *net)
{
	const char *unknown = net->bodies ? "rigid bodies" : net->surfaces ? "obstacles"
	                      : net->water.waves.count > 1 ? "seas" : net->water.file
	                      ? "currents over time" : NULL;
	long elements = 0;
	int supports = 0;

	*forced = net->motions > 0 || net->water.waves.count > 0;
	for (int i = 0; i < net->loads; i++)
		*forced = *forced || net->load[i].harmonic;
	for (int i = 0; i < net->cables; i++)
		elements += net->cable[i].elements;
	for (int i = 0; i < net->nodes; i++)
		supports += net->node[i].support != 0;
	snprintf(text, CLI_SCENE_FACTS, "  nodes: %d, of which %d are supports\n"
	         "  cables: %d, with %ld elements\n  loads: %d; motions of supports: %d\n",
	         net->nodes, supports, net->cables, elements, net->loads, net->motions);
	if (net->winds)
		hawser__append(text, CLI_SCENE_FACTS, "", "  wind: %.6g m/s\n", net->wind->speed);
	water_facts(text, &net->water);
	if (net->bodies)
		hawser__append(text, CLI_SCENE_FACTS, "", "  rigid bodies: %d\n", net->bodies);
	if (unknown)
		hawser__append(text, CLI_SCENE_FACTS, "", "  models: none, since rom does not know %s\n",
		               unknown);
}
LOOK(net, net_facts)

static void obstacles_facts(char *text, int *forced, const struct hawser_obstacles *of)
{
	(void)forced;
	snprintf(text, CLI_SCENE_FACTS, "  obstacles: %d\n", of->line.sheaves);
}
LOOK(obstacles, obstacles_facts)

static void ropeway_facts(char *text, int *forced, const struct hawser_ropeway *rw)
{
	(void)forced;
	snprintf(text, CLI_SCENE_FACTS, "  lanes: %d; towers: %d\n  load cases: %d\n%s", rw->lanes,
	         rw->towers, rw->cases, rw->spacing > 0.0 ? "" : "  no carriers\n");
}
LOOK(ropeway, ropeway_facts)

static void rod_facts(char *text, int *forced, const struct hawser_rod *rod)
{
	long elements = 0;

	(void)forced;
	for (int i = 0; i < rod->segments; i++)
		elements += rod->segment[i].elements;
	snprintf(text, CLI_SCENE_FACTS, "  segments: %d, with %ld elements; length: %.6g m\n"
	         "  loads: %d\n", rod->segments, elements, rod->length, rod->loads);
	water_facts(text, &rod->water);
}
LOOK(rod, rod_facts)

static void tow_facts(char *text, int *forced, const struct hawser_tow *tow)
{
	static const char *const body[] = {"none", "a point", "a ring"};

	(void)forced;
	snprintf(text, CLI_SCENE_FACTS, "  path: %s\n  parts of the cable: %d\n  body: %s\n",
	         hawser_path_name(tow->path.kind), tow->segments,
	         body[tow->body.kind == HAWSER_TOW_RING ? 2 : tow->body.kind == HAWSER_TOW_MASS]);
	water_facts(text, &tow->water);
}
LOOK(tow, tow_facts)

static enum hawser_status look_model(char *text, int *forced, const struct cli_common *common,
                                     struct hawser_report *report)
{
	struct cli_model made;
	enum hawser_status status = cli_model_load(&made, common, 0, report);

	if (status)
		return status;
	*forced = made.rom.harmonics > 0;
	snprintf(text, CLI_SCENE_FACTS, "  coordinates: %d\n  parameters: %d\n  lowest natural frequency: "
	         "%.6g%s\n", made.rom.n, made.source.parameters,
	         made.naturals > 0 ? made.natural[0]*cli_per_omega(&made) : 0.0,
	         made.rom.scaled ? " rad/s" : "");
	cli_model_clear(&made);
	return HAWSER_OK;
}

/* What spans have in common. */
#define SPAN .called = "a span", .many = "spans", .kind = HAWSER_KIND_SPAN

const struct cli_kind_record
	cli_kind_cable = {"cable", "a span of cable", SPAN, .text = cli_init_cable, .models = 1,
		.statics = {cli_statics_span, NULL}, .modes = {cli_modes_of_span, NULL},
		.plan = {cli_plan_of_span, NULL}},
	cli_kind_travelling = {"travelling", "a travelling cable", SPAN, .text = cli_init_travelling,
		.models = 1, .statics = {cli_statics_span, NULL}, .modes = {cli_modes_of_span, NULL},
		.plan = {cli_plan_of_span, NULL}},
	cli_kind_beam = {"beam", "a travelling beam or string", SPAN, .text = cli_init_beam,
		.plan = {cli_plan_of_span, NULL}},
	cli_kind_net = {"net", "a net of cables", "a net", "nets", cli_init_net, look_net, HAWSER_KIND_NET,
		1, NULL, &cli_maker_net,
		.statics = {cli_statics_net, cli_statics_net_listing}, .modes = {cli_modes_of_net, NULL},
		.integrate = {cli_integrate_net, NULL}, .plan = {cli_plan_of_net, NULL}},
	cli_kind_obstacles = {"obstacles", "a span over obstacles", "a span over obstacles",
		"spans over obstacles", cli_init_obstacles, look_obstacles, HAWSER_KIND_OBSTACLES,
		.unmade = "The contacts of reduced models do not change: hawser modes has small motions",
		.statics = {cli_statics_obstacles, cli_obstacles_listing},
		.modes = {cli_modes_of_obstacles, NULL}},
	cli_kind_ropeway = {"ropeway", "a ropeway", "a ropeway", "ropeways", cli_init_ropeway,
		look_ropeway, HAWSER_KIND_ROPEWAY, 1, NULL, &cli_maker_ropeway,
		{cli_statics_ropeway, cli_ropeway_listing},
		.modes = {cli_modes_of_ropeway, NULL}, .plan = {cli_plan_ropeway, NULL}},
	cli_kind_rod = {"rod", "a rod", "a rod", "rods", cli_init_rod, look_rod, HAWSER_KIND_ROD,
		.unmade = "Reduced models are of cables: of a rod, hawser integrate has the motion in time",
		.statics = {cli_statics_rod, cli_rod_listing}, .integrate = {cli_integrate_rod, NULL}},
	cli_kind_tow = {"tow", "a towed body", "a towed body", "towed bodies", cli_init_tow,
		look_tow, .kind = HAWSER_KIND_TOW,
		.unmade = "Reduced models are about a state at rest: hawser tow has motions in time"},
	cli_kind_model = {"model", "a reduced model", "a reduced model", "reduced models", NULL,
		look_model, HAWSER_KIND_MODEL, 1, .modes = {cli_modes_of_model, NULL},
		.plan = {cli_plan_of_model, NULL}};
