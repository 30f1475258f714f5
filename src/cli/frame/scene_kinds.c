/* cli/frame/scene_kinds.c - see scene_kinds.h. A new kind of scenes is a row of the table.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <string.h>

#include "cli/frame/scene_kinds.h"
#include "core/report.h"

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

#define OF_SPANS "irvine, rom, integrate, frf, orbit, folds, locus, nnm, mms, hill, damping, " \
	"identify, map, compare, plan"
static const struct cli_scene_kind kinds[] = {
	{"cable", "a span of cable", "statics, modes, " OF_SPANS, cli_init_cable, NULL, HAWSER_KIND_SPAN},
	{"travelling", "a travelling cable", "campbell, statics, modes, " OF_SPANS, cli_init_travelling,
	 NULL, HAWSER_KIND_SPAN},
	{"beam", "a travelling beam or string", "beam, map, plan", cli_init_beam, NULL, HAWSER_KIND_SPAN},
	{"net", "a net of cables", "statics, modes, integrate, plan, compare statics", cli_init_net,
	 net, HAWSER_KIND_NET},
	{"obstacles", "a span over obstacles", "statics, modes", cli_init_obstacles, obstacles,
	 HAWSER_KIND_OBSTACLES},
	{"ropeway", "a ropeway", "statics, modes, campbell, irvine, rom, integrate, frf, orbit, folds, "
	 "locus, nnm, mms, compare mms, hill, map, transient, plan", cli_init_ropeway, ropeway,
	 HAWSER_KIND_ROPEWAY},
	{"rod", "a rod", "statics, integrate", cli_init_rod, rod, HAWSER_KIND_ROD},
	{"tow", "a towed body", "tow steady, tow, trajectory", cli_init_tow, tow, HAWSER_KIND_TOW},
	{"model", "a reduced model", "modes, rom, integrate, frf, orbit, folds, locus, nnm, mms, "
	 "compare mms, hill, map", NULL, model, HAWSER_KIND_MODEL},
};

/* Those that show what a force does. */
static const char of_forces[] = "frf, orbit, folds, locus, compare";

/* 1 if `name` is in a list of names, separated by ", ". */
static int is_listed(const char *list, const char *name)
{
	size_t length = strlen(name);

	for (const char *at = list; *at; at += strspn(at, ", ")) {
		if (strcspn(at, ",") == length && !strncmp(at, name, length))
			return 1;
		at += strcspn(at, ",");
	}
	return 0;
}

enum hawser_status cli_scene_kind_check(const char *command, const struct cli_common *common,
                                        struct hawser_report *report)
{
	static const char every[] = "check, report, sweep"; /* take a scene of any kind */
	enum hawser_kind kind = cli_kind(common);
	size_t i = 0;

	while (kinds[i].kind != kind)
		i++;
	if (kind == HAWSER_KIND_SPAN || is_listed(every, command) ||
	    is_listed(kinds[i].commands, command))
		return HAWSER_OK;
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, "main",
	                    "%s is %s, which hawser %s does not take; these commands do: %s",
	                    cli_input_name(common), kinds[i].one, command, kinds[i].commands);
}

int cli_is_forced(const struct hawser_scene *scene)
{
	int moves = 0;

	for (int end = 0; end < 2; end++)
		for (int axis = 0; axis < 3; axis++)
			moves = moves || scene->support[end].motion[axis] != 0.0;
	return scene->load.present || scene->loads > 0 || moves || scene->travel.fluctuation > 0.0;
}

/* The names of the list that need a force, or (needing 0) the others. */
static void print_commands(FILE *to, const char *list, int forced, int needing)
{
	const char *before = "";

	for (const char *at = list; *at; at += strspn(at, ", ")) {
		char name[32];

		snprintf(name, sizeof name, "%.*s", (int)strcspn(at, ","), at);
		at += strcspn(at, ",");
		if ((!forced && is_listed(of_forces, name)) != needing)
			continue;
		fprintf(to, "%s%s", before, name);
		before = ", ";
	}
	putc('\n', to);
}

void cli_scene_kind_print(FILE *to, const struct cli_scene_kind *kind, int forced)
{
	fputs("commands that take it: ", to);
	print_commands(to, kind->commands, forced, 0);
	if (forced)
		return;
	fprintf(to, "those for which it lacks %s: ", kind->kind == HAWSER_KIND_MODEL
	        ? "a harmonic force" : "a load, a moving end or a travel.fluctuation");
	print_commands(to, kind->commands, forced, 1);
}

const struct cli_scene_kind *cli_scene_kind(int index)
{
	return index >= 0 && index < (int)(sizeof kinds/sizeof *kinds) ? &kinds[index] : NULL;
}
