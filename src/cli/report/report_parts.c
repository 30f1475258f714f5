/* cli/report/report_parts.c - see report.h. A new part is a row of the table.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <string.h>

#include "cli/frame/kinds.h"
#include "cli/report/report.h"
#include "core/append.h"
#include "core/report.h"

/* Besides the kinds (enum cli_kind): of spans, and of paths of a towing point alone. Results come
 * first, and what was modelled last. */
enum { LOADED = 2*CLI_FORCED, CASES = 2*LOADED, WAYPOINTS = 2*CASES, DAMPED = 2*WAYPOINTS };

static const struct cli_report_part table[] = {
	{"statics", "Static shape", "The static equilibrium, about which modes and motions are computed.",
	 {"statics"}, .essential = 1},
	{"worst", "Worst values", "The largest and smallest values over all places of the carriers.",
	 {"statics", "--worst"}, .kinds = CLI_ROPEWAY},
	{"cases", "Load cases", "The static shape in each load case.",
	 {"statics", "--cases"}, .kinds = CASES},
	{"modes", "Natural modes",
	 "Small free vibrations about the static shape, each frequency with its estimated relative error.",
	 {"modes"}, .kinds = CLI_CABLE | CLI_TRAVELLING | CLI_OBSTACLES | CLI_NET | CLI_ROPEWAY,
	 .modes = 1},
	{"modes", "Natural modes", "Small motions of the model about u = 0, and how they decay.",
	 {"modes"}, .kinds = CLI_MODEL, .no_picture = 1},
	{"damped", "Damped modes", "How the dampers of the scene damp each mode.",
	 {"modes", "--damped"}, .kinds = DAMPED, .no_picture = 1, .modes = 1},
	{"irvine", "Frequencies over the tension",
	 "Where frequencies cross or veer as the horizontal tension changes.",
	 {"irvine"}, .kinds = CLI_CABLE, .modes = 1},
	{"campbell", "Frequencies over the speed",
	 "The natural frequencies as the travel speed increases.",
	 {"campbell"}, .kinds = CLI_TRAVELLING},
	{"frf", "Frequency response",
	 "Steady motions under the load of the scene: stable ones, and unstable ones, which are not "
	 "observed. The table has the peaks.",
	 {"frf", "--peaks"}, .kinds = LOADED | CLI_MODEL, .modes = 1, .range = 1},
	{"tow", "Steady tow", "The state that does not change in the frame of the towing point.",
	 {"tow", "steady"}, .kinds = CLI_TOW, .essential = 1},
	{"trajectory", "Path of the towing point", "Place, speed and acceleration of the towing point.",
	 {"trajectory"}, .kinds = WAYPOINTS, .essential = 1},
	{"beam", "Eigenvalues and limit speed",
	 "Growth and frequency of small motions, and the speed up to which they decay.",
	 {"beam"}, .kinds = CLI_BEAM, .essential = 1, .no_picture = 1},
	{"speeds", "Eigenvalues over the speed",
	 "How they change up to the limit speed and beyond; the table has each change of stability.",
	 {"beam"}, .kinds = CLI_BEAM, .drawn = "speeds.svg"},
	{"plan", "What is modelled",
	 "What a model of this scene contains, what it leaves out and why, and which settings are "
	 "defaults.",
	 {"plan", "--limit", "0.2", "--fidelities", "condensed 5, condensed 9"},
	 .kinds = CLI_CABLE | CLI_TRAVELLING, .no_picture = 1, .range = 1},
	{"plan", "What is modelled",
	 "What the model of this net contains, what it leaves out and why, and which settings are "
	 "defaults.",
	 {"plan", "--limit", "0.2"}, .kinds = CLI_NET, .no_picture = 1},
	{"plan", "What is modelled",
	 "What the model of this line contains, what it leaves out and why, and which settings are "
	 "defaults.",
	 {"plan"}, .kinds = CLI_ROPEWAY, .no_picture = 1},
};
enum { ROWS = sizeof table/sizeof *table };

static int has_damper(const struct hawser_scene *scene)
{
	for (int i = 0; i < scene->attachments; i++)
		for (int axis = 0; axis < 3; axis++)
			if (scene->attach[i].damper[axis] > 0.0)
				return 1;
	return 0;
}

static unsigned kind_of_span(const struct hawser_scene *scene)
{
	unsigned kind = scene->travel.present ? CLI_TRAVELLING : CLI_CABLE;

	if (scene->beam.form)
		return CLI_BEAM;
	if (cli_is_forced(scene))
		kind |= LOADED;
	if (has_damper(scene))
		kind |= DAMPED;
	return kind | (scene->cases > 0 ? CASES : 0);
}

static enum hawser_status kind_of_tow(unsigned *kind, const struct cli_common *common,
                                      struct hawser_report *report)
{
	struct hawser_tow tow;
	enum hawser_status status = cli_read_tow(&tow, common, report);

	if (status)
		return status;
	*kind = tow.segments > 0 && tow.path.kind != HAWSER_PATH_WAYPOINTS ? CLI_TOW : WAYPOINTS;
	hawser_tow_clear(&tow);
	return HAWSER_OK;
}

static enum hawser_status find_kind(unsigned *kind, struct hawser_scene *span, int *scene,
                                    const struct cli_common *common, struct hawser_report *report)
{
	enum hawser_kind of = cli_kind(common);
	enum hawser_status status;

	*scene = 0;
	*kind = 1u << cli_kind_number(of, CLI_EVERY);
	if (of != HAWSER_KIND_TOW && of != HAWSER_KIND_SPAN)
		return HAWSER_OK;
	if (of == HAWSER_KIND_TOW)
		return kind_of_tow(kind, common, report);
	status = cli_read_scene(span, common, report);
	*scene = !status;
	if (!status)
		*kind = kind_of_span(span);
	return status;
}

/* A row without kinds is for those that have statics. */
static int is_for(const struct cli_report_part *part, unsigned kind)
{
	int has = 0;

	for (int i = 0; i < CLI_KINDS_ALL; i++)
		has = has || (kind & 1u << i && cli_part_of(&cli_statics, i)->run);
	return part->kinds ? (part->kinds & kind) != 0 : has;
}

/* 1 if the name is in the list, or there is no list. */
static int is_wanted(const char *list, const char *name)
{
	size_t length = strlen(name);

	if (!list)
		return 1;
	for (const char *word = list; *word; word += strcspn(word, ",")) {
		word += strspn(word, ", ");
		if (strncmp(word, name, length) == 0 && (!word[length] || strchr(", ", word[length])))
			return 1;
	}
	return 0;
}

/* Refuse a name of the list that is none of a part of this scene. */
static enum hawser_status check_list(const char *list, const struct cli_report_part *const part[],
                                     int count, struct hawser_report *report)
{
	char known[200] = "", name[40];

	for (int i = 0; i < count; i++)
		hawser__append(known, sizeof known, ", ", "%s", part[i]->name);
	for (const char *word = list; word && *word; word += strcspn(word, ",")) {
		int found = 0;

		word += strspn(word, ", ");
		snprintf(name, sizeof name, "%.*s", (int)strcspn(word, ", "), word);
		for (int i = 0; i < count; i++)
			found = found || strcmp(part[i]->name, name) == 0;
		if (!found)
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "report",
			                    "--parts %s: a report of this scene has no part %s; it has %s", list,
			                    *name ? name : "without a name", known);
	}
	return HAWSER_OK;
}

enum hawser_status cli_report_choose(const struct cli_report_part *part[], int *count,
                                     struct hawser_scene *span, int *scene,
                                     const struct cli_common *common, const char *list,
                                     struct hawser_report *report)
{
	unsigned kind = 0;
	enum hawser_status status = find_kind(&kind, span, scene, common, report);
	int all = 0;

	if (status)
		return status;
	for (int i = 0; i < ROWS; i++)
		if (is_for(&table[i], kind))
			part[all++] = &table[i];
	status = check_list(list, part, all, report);
	*count = 0;
	for (int i = 0; i < all; i++)
		if (is_wanted(list, part[i]->name))
			part[(*count)++] = part[i];
	if (status && *scene) {
		hawser_scene_clear(span);
		*scene = 0;
	}
	return status;
}
