/* cli/frame/scene_kinds.c - see scene_kinds.h. A new kind of scenes is a row of the table.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <string.h>

#include "cli/frame/scene_kinds.h"
#include "core/report.h"

enum { COMMANDS = 400 }; /* characters of a list of commands */

static enum hawser_status net(char *text, int *forced, const struct cli_common *common,
                              struct hawser_report *report)
{
	struct hawser_net net;
	long elements = 0;
	int supports = 0;
	enum hawser_status status = cli_read_net(&net, common, report);

	(void)forced;
	if (status)
		return status;
	for (int i = 0; i < net.cables; i++)
		elements += net.cable[i].elements;
	for (int i = 0; i < net.nodes; i++)
		supports += net.node[i].support != 0;
	snprintf(text, CLI_SCENE_FACTS, "  nodes: %d, of which %d are supports\n"
	         "  cables: %d, with %ld elements\n  loads: %d; motions of supports: %d\n", net.nodes,
	         supports, net.cables, elements, net.loads, net.motions);
	hawser_net_clear(&net);
	return HAWSER_OK;
}

static enum hawser_status ropeway(char *text, int *forced, const struct cli_common *common,
                                  struct hawser_report *report)
{
	struct hawser_ropeway rw;
	enum hawser_status status = cli_read_ropeway(&rw, common, report);

	(void)forced; /* --load says what acts */
	if (status)
		return status;
	snprintf(text, CLI_SCENE_FACTS, "  lanes: %d; towers: %d\n  load cases: %d\n%s", rw.lanes,
	         rw.towers, rw.cases, rw.spacing > 0.0 ? "" : "  no carriers\n");
	hawser_ropeway_clear(&rw);
	return HAWSER_OK;
}

static enum hawser_status obstacles(char *text, int *forced, const struct cli_common *common,
                                    struct hawser_report *report)
{
	struct hawser_obstacles of;
	enum hawser_status status = cli_read_obstacles(&of, common, report);

	(void)forced;
	if (status)
		return status;
	snprintf(text, CLI_SCENE_FACTS, "  obstacles: %d\n", of.line.sheaves);
	hawser_obstacles_clear(&of);
	return HAWSER_OK;
}

static enum hawser_status rod(char *text, int *forced, const struct cli_common *common,
                              struct hawser_report *report)
{
	struct hawser_rod rod;
	long elements = 0;
	enum hawser_status status = cli_read_rod(&rod, common, report);

	(void)forced;
	if (status)
		return status;
	for (int i = 0; i < rod.segments; i++)
		elements += rod.segment[i].elements;
	snprintf(text, CLI_SCENE_FACTS, "  segments: %d, with %ld elements; length: %.6g m\n"
	         "  loads: %d\n", rod.segments, elements, rod.length, rod.loads);
	hawser_rod_clear(&rod);
	return HAWSER_OK;
}

static enum hawser_status tow(char *text, int *forced, const struct cli_common *common,
                              struct hawser_report *report)
{
	static const char *const body[] = {"none", "a point", "a ring"};
	struct hawser_tow tow;
	enum hawser_status status = cli_read_tow(&tow, common, report);

	(void)forced;
	if (status)
		return status;
	snprintf(text, CLI_SCENE_FACTS, "  path: %s\n  parts of the cable: %d\n  body: %s\n",
	        hawser_path_name(tow.path.kind), tow.segments,
	        body[tow.body.kind == HAWSER_TOW_RING ? 2 : tow.body.kind == HAWSER_TOW_MASS]);
	hawser_tow_clear(&tow);
	return HAWSER_OK;
}

static enum hawser_status model(char *text, int *forced, const struct cli_common *common,
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

static const struct cli_scene_kind kinds[] = {
	{"cable", "a span of cable", cli_init_cable, NULL, HAWSER_KIND_SPAN, CLI_TAKES_CABLE},
	{"travelling", "a travelling cable", cli_init_travelling, NULL, HAWSER_KIND_SPAN,
	 CLI_TAKES_TRAVELLING},
	{"beam", "a travelling beam or string", cli_init_beam, NULL, HAWSER_KIND_SPAN, CLI_TAKES_BEAM},
	{"net", "a net of cables", cli_init_net, net, HAWSER_KIND_NET, CLI_TAKES_NET},
	{"obstacles", "a span over obstacles", cli_init_obstacles, obstacles, HAWSER_KIND_OBSTACLES,
	 CLI_TAKES_OBSTACLES},
	{"ropeway", "a ropeway", cli_init_ropeway, ropeway, HAWSER_KIND_ROPEWAY, CLI_TAKES_ROPEWAY},
	{"rod", "a rod", cli_init_rod, rod, HAWSER_KIND_ROD, CLI_TAKES_ROD},
	{"tow", "a towed body", cli_init_tow, tow, HAWSER_KIND_TOW, CLI_TAKES_TOW},
	{"model", "a reduced model", NULL, model, HAWSER_KIND_MODEL, CLI_TAKES_MODEL},
};

/* Names of commands that take the kind. forced: all (-1), or those (1) or all but those (0) that need
 * a force. Commands that take any kind are not named. */
static void list_commands(char *text, size_t size, const struct cli_scene_kind *kind, int forced)
{
	const struct cli_command *command;
	size_t used = 0;

	*text = '\0';
	for (int i = 0; (command = cli_command_row(i)) && used < size; i++) {
		int needs = (command->takes & CLI_TAKES_FORCED) != 0;

		if ((command->takes & CLI_TAKES_ANY) != CLI_TAKES_ANY && command->takes & kind->takes &&
		    (forced < 0 || forced == needs))
			used += (size_t)snprintf(text + used, size - used, "%s%s", used ? ", " : "",
			                         command->name);
	}
}

enum hawser_status cli_scene_kind_check(const struct cli_command *command,
                                        const struct cli_common *common, struct hawser_report *report)
{
	enum hawser_kind kind = cli_kind(common);
	char others[COMMANDS];
	size_t i = 0;

	while (kinds[i].kind != kind)
		i++;
	if (kind == HAWSER_KIND_SPAN || command->takes & kinds[i].takes)
		return HAWSER_OK;
	list_commands(others, sizeof others, &kinds[i], -1);
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, "main",
	                    "%s is %s, which hawser %s does not take; these commands do: %s",
	                    cli_input_name(common), kinds[i].one, command->name, others);
}

int cli_is_forced(const struct hawser_scene *scene)
{
	int moves = 0;

	for (int end = 0; end < 2; end++)
		for (int axis = 0; axis < 3; axis++)
			moves = moves || scene->support[end].motion[axis] != 0.0;
	return scene->load.present || scene->loads > 0 || moves || scene->travel.fluctuation > 0.0;
}

void cli_scene_kind_print(FILE *to, const struct cli_scene_kind *kind, int forced)
{
	char names[COMMANDS];

	list_commands(names, sizeof names, kind, forced ? -1 : 0);
	fprintf(to, "commands that take it: %s\n", names);
	if (forced)
		return;
	list_commands(names, sizeof names, kind, 1);
	fprintf(to, "those for which it lacks %s: %s\n", kind->kind == HAWSER_KIND_MODEL
	        ? "a harmonic force" : "a load, a moving end or a travel.fluctuation", names);
}

const struct cli_scene_kind *cli_scene_kind(int index)
{
	return index >= 0 && index < (int)(sizeof kinds/sizeof *kinds) ? &kinds[index] : NULL;
}
