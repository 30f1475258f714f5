/* ropeway/read/read.c - read a scene of kind `ropeway`: rope, stations, carriers, load cases, and the
 * rules that involve several of them. Towers are read in towers.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "ropeway/read/read.h"

/* A key of a section. */
static const struct hawser__tree *within(const struct hawser__tree *root, const char *section,
                                         const char *key)
{
	return hawser__tree_find(hawser__tree_find(root, section), key);
}

static int line_of(const struct hawser__tree *tree)
{
	return !tree || tree->at.set ? 0 : (int)tree->at.line;
}

static enum hawser_status tension(struct hawser__reader *reader, struct hawser_ropeway *rw,
                                  const struct hawser__tree *tree)
{
	static const char *const way[] = {"counterweight", "T0", "length0", "T_empty"};
	const struct hawser__tree *travel = hawser__tree_find(tree, "travel");

	rw->tension_line = line_of(tree);
	rw->stops = travel != NULL;
	if (travel && rw->tension > HAWSER_ROPEWAY_T0)
		return hawser__reader_fail(reader, &travel->at, "tension.travel is for a carriage that moves, "
		                           "and %s fixes it", way[rw->tension]);
	return !travel || (rw->travel[0] <= 0.0 && rw->travel[1] >= 0.0) ? HAWSER_OK
		: hawser__reader_fail(reader, &travel->at, "tension.travel: %.9g m to %.9g m does not "
		                      "contain 0, the place of the carriage with the empty rope",
		                      rw->travel[0], rw->travel[1]);
}

static enum hawser_status brake(struct hawser__reader *reader, const struct hawser_ropeway *rw,
                                const struct hawser__tree *tree)
{
	const struct hawser__tree *force = hawser__tree_find(tree, "force");

	if (force && rw->brake > 0.0)
		return hawser__reader_fail(reader, &force->at, "drive.brake has deceleration and force: give "
		                           "the deceleration that a controlled brake keeps, or the force of "
		                           "one that is applied");
	return !tree || force || rw->brake > 0.0 ? HAWSER_OK
		: hawser__reader_fail(reader, &tree->at, "drive.brake needs deceleration (m/s^2) or force "
		                      "(N at the bullwheel's circumference)");
}

static enum hawser_status stations(struct hawser__reader *reader, struct hawser_ropeway *rw,
                                   const struct hawser__tree *tree)
{
	const struct hawser__tree *drive = within(tree, "top", "drive");
	const struct hawser__tree *friction = within(tree, "bottom", "friction");

	if (rw->bottom_friction >= 1.0)
		return hawser__reader_fail(reader, &friction->at, "bottom.friction is %.9g, but must be below "
		                           "1: it is the resistance of the bullwheel as a part of the force on "
		                           "it", rw->bottom_friction);
	rw->drive_line = line_of(drive);
	rw->drive = hawser__tree_find(drive, "friction") != NULL;
	rw->coasts = hawser__tree_find(drive, "inertia") != NULL;
	if (!(rw->top[0] > rw->bottom[0]))
		return hawser__reader_fail(reader, &hawser__tree_find(tree, "top")->at,
		                           "top.at: x = %.9g m is not beyond x = %.9g m of bottom.at",
		                           rw->top[0], rw->bottom[0]);
	return brake(reader, rw, hawser__tree_find(drive, "brake"));
}

/* A wheel without radius does not turn. */
static enum hawser_status wheels(struct hawser__reader *reader, const struct hawser_ropeway *rw,
                                 const struct hawser__tree *tree)
{
	if (rw->bottom_inertia > 0.0 && rw->bottom_radius == 0.0)
		return hawser__reader_fail(reader, &tree->at, "bottom.inertia with bottom.radius = 0: give the "
		                           "bullwheel a radius");
	if (rw->top_inertia > 0.0 && rw->top_radius == 0.0)
		return hawser__reader_fail(reader, &tree->at, "top.drive.inertia with top.radius = 0: give the "
		                           "bullwheel a radius");
	return HAWSER_OK;
}

static double reduced(double phase, double spacing)
{
	double left = fmod(phase, spacing);

	return left < 0.0 ? left + spacing : left;
}

static void carriers(struct hawser_ropeway *rw, const struct hawser__tree *tree)
{
	const struct hawser__tree *phase = hawser__tree_find(tree, "phase");

	rw->sweep = phase && phase->text && !strcmp(phase->text, "sweep");
	rw->phase = reduced(rw->phase, rw->spacing);
	if (!hawser__tree_find(tree, "phase_down"))
		rw->phase_down = rw->spacing - rw->phase;
	rw->phase_down = reduced(rw->phase_down, rw->spacing);
}

/* full, empty, up and down; or, after full, those of the scene. */
static enum hawser_status cases(struct hawser__reader *reader, struct hawser_ropeway *rw,
                                const struct hawser__tree *tree)
{
	const struct hawser_ropeway_case usual[] = {
		{"full", {rw->mass[0], rw->mass[1]}}, {"empty", {rw->empty, rw->empty}},
		{"up", {rw->mass[0], rw->empty}}, {"down", {rw->empty, rw->mass[1]}}};
	int own = tree ? tree->children : 3;
	enum hawser_status status = HAWSER_OK;

	if (tree && tree->kind != HAWSER__SEQUENCE)
		return hawser__reader_fail(reader, &tree->at, "cases must be a list of load cases, such as "
		                           "[{name: half, mass: {up: 200 kg, down: 0 kg}}]");
	rw->load_case = calloc((size_t)own + 1, sizeof *rw->load_case);
	if (!rw->load_case)
		return hawser__no_memory(reader->report, "scene");
	rw->cases = own + 1;
	for (int i = 0; i < rw->cases && (i == 0 || !tree); i++)
		rw->load_case[i] = usual[i];
	for (const struct hawser__tree *one = tree ? tree->child : NULL; one && !status; one = one->next) {
		struct hawser_ropeway_case *to = &rw->load_case[1 + tree->children - own--];
		const struct hawser__tree *name = hawser__tree_find(one, "name");
		const char *text = "";

		status = hawser__tree_fill(reader, to, one, "cases", "ropeway.ropeway.cases[]");
		if (!status && !name)
			status = hawser__reader_fail(reader, &one->at, "a load case needs name and mass, such as "
			                             "{name: half, mass: {up: 200 kg, down: 0 kg}}");
		if (!status)
			status = hawser__tree_text(reader, &text, name, "cases.name");
		if (!status)
			status = hawser__tree_name(reader, to->name, name, text, "cases.name");
		for (int i = 0; i < (int)(to - rw->load_case) && !status; i++)
			if (!strcmp(rw->load_case[i].name, to->name))
				status = hawser__reader_fail(reader, &name->at, "two load cases have the name %s%s",
				                             to->name,
				                             i ? "" : ", which is that of the carriers' masses");
	}
	return status;
}

static enum hawser_status interpret(struct hawser__reader *reader, void *scene,
                                    const struct hawser__tree *root)
{
	struct hawser_ropeway *rw = scene;
	const struct hawser__tree *tree = hawser__tree_find(root, "ropeway"), *towers, *down;
	enum hawser_status status = hawser__tree_fill(reader, rw, root, "", "ropeway");

	if (status)
		return status;
	status = tension(reader, rw, within(tree, "bottom", "tension"));
	if (!status)
		status = stations(reader, rw, tree);
	towers = hawser__tree_find(tree, "towers");
	if (!status && towers)
		status = hawser__ropeway_towers(reader, rw, towers);
	if (hawser__tree_find(tree, "carriers"))
		carriers(rw, hawser__tree_find(tree, "carriers"));
	if (!status)
		status = wheels(reader, rw, tree);
	down = hawser__tree_find(tree, "down");
	rw->lanes++; /* off: 0, on: 1 */
	if (!status && rw->lanes == 1 && rw->tension == HAWSER_ROPEWAY_LENGTH0)
		status = hawser__reader_fail(reader, &down->at, "down is off, and tension.length0 is the "
		                             "length of the loop of both lanes: leave down out, or give "
		                             "T_empty instead");
	return status ? status : cases(reader, rw, hawser__tree_find(tree, "cases"));
}

HAWSER__TREE_SCENES(ropeway, "ropeway",
	"a scene of kind ropeway is a mapping with the section ropeway (see "
	"hawser-scene(5), ROPEWAYS)",
	"ropeway.towers.p3.friction=0.02", 'p')

void hawser_ropeway_clear(struct hawser_ropeway *rw)
{
	if (!rw)
		return;
	free(rw->name);
	free(rw->tower);
	free(rw->load_case);
	memset(rw, 0, sizeof *rw);
}
