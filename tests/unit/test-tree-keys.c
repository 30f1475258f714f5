/* The table of keys of nets, ropeways, spans over obstacles, rods and towed bodies
 * (scene/tree_rows.h) against the readers: each number is given as "1 kg" (or "1 m"), and the reader
 * must refuse it in the unit that the table has for it. SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <hawser/net.h>
#include <hawser/obstacles.h>
#include <hawser/rod.h>
#include <hawser/ropeway.h>
#include <hawser/tow.h>

#include "scene/tree_keys.h"
#include "tests/tap.h"

enum { PATH = 200 };
static char file[] = "/tmp/hawser-tree-XXXXXX";

/* Scenes in which every mapping is present whose keys are compared. */
static const struct scene {
	const char *kind, *text;
	char item;        /* names of items in overrides: c0, p0 ... */
} scenes[] = {
	{"net", "kind: net\nnodes: {A: [0, 9, 0], B: [100, 9, 0], C: [200, 9, 0], J: {}}\n"
	        "cables:\n  - {from: A, to: J, EA: 1e6, rho: 1, length0: 60, diameter: 0}\n"
	        "  - {from: J, to: B, EA: 1e6, rho: 1, length0: 60, diameter: 0}\n"
	        "  - {from: B, to: C, EA: 1e6, rho: 1, length0: 120, diameter: 0}\n"
	        "supports: {A: fixed, C: fixed, B: {motion: {x: {amplitude: 1, Omega: 1}, "
	        "y: {amplitude: 1, Omega: 1}, z: {amplitude: 1, Omega: 1}}}}\nmasses: {J: 1}\n"
	        "loads: {J: {force: [0, 1, 0], harmonic: {Omega: 1}}, "
	        "c0: {per_length: [0, 1, 0], harmonic: {Omega: 1}}}\n"
	        "damping: {alpha: 1}\ndynamics: {step: 1}\n"
	        "water: {density: 1000}\nbuoys: {J: {volume: 0}}\n"
	        "obstacles:\n  - {circle: {centre: [30, -200], radius: 1}}\n"
	        "contact: {restitution: 0}\n", 'c'},
	{"ropeway", "ropeway:\n  rope: {EA: 4e7, rho: 4}\n"
	            "  bottom: {at: [0, 0], radius: 2, tension: {counterweight: 168e3, travel: [-1, 1]}}\n"
	            "  top: {at: [300, 58], radius: 2, drive: {speed: 4, friction: 0.2}}\n"
	            "  towers:\n    - {at: [80, 17], radius: 12, "
	            "sheaves: {count: 2, spacing: 1, radius: 0.2}}\n"
	            "  carriers: {spacing: 36, mass: {up: 400, down: 250}}\n"
	            "  cases: [{name: half, mass: {up: 1, down: 1}}]\n", 'p'},
	{"obstacles", "cable: {EA: 4e7, rho: 4}\nspan: {d: 300, h: 20}\ntension: {T0: 6e4}\n"
	              "obstacles:\n  - {circle: {centre: [150, 8], radius: 6}, rotation: free}\n"
	              "contact: {sliding: none}\n", 's'},
	{"rod", "kind: rod\nrod: {length: 10, EA: 1e6, GA: 1e6, EI: 40, GJ: 30, rho: 2}\n"
	        "start: {hold: clamped, winch: {speed: 1}}\n"
	        "end: {hold: clamped, tangent: [1, 0, 0]}\n"
	        "loads:\n  - {at: end, force: [0, -20, 5]}\n"
	        "damping: {alpha: 1}\ndynamics: {step: 1}\n", 'i'},
	{"tow", "tow: {orbit: {radius: 100, speed: 20}}\n"
	        "cable:\n  segments:\n    - {length: 14, rho: 1, diameter: 0.1, drag: {normal: 1}}\n"
	        "air: {density: 1.2}\nbody:\n  ring: {radius: 11, tube: 0.1, mass: 400, offset: 16, "
	        "drag: {normal: 1}}\n  joint: {torsion: 1}\nwinch: {speed: 1}\n", 'p'},
};

static enum hawser_status read_it(const char *kind, const char *set, struct hawser_report *report)
{
	union {
		struct hawser_net net;
		struct hawser_ropeway ropeway;
		struct hawser_obstacles obstacles;
		struct hawser_rod rod;
		struct hawser_tow tow;
	} u;
	const char *const *list = set ? &set : NULL;
	size_t n = set != NULL;
	enum hawser_status status;

#define READ(one) \
	if (!strcmp(kind, #one)) { \
		status = hawser_##one##_open(&u.one, file, list, n, report); \
		hawser_##one##_clear(&u.one); \
		return status; \
	}
	READ(net) READ(ropeway) READ(obstacles) READ(rod)
	status = hawser_tow_open(&u.tow, file, list, n, report);
	hawser_tow_clear(&u.tow);
	return status;
}

/* "net.cables[].EA" as "cables.c0.EA", with a name of the scene for * and **. */
static void path_of(char *to, const struct scene *scene, const char *path)
{
	const char *name = strstr(path, "supports.*") ? "B" : "J";
	size_t used = 0;

	for (path += strlen(scene->kind) + 1; *path && used < PATH - 8; path++)
		if (!strncmp(path, "[]", 2)) {
			used += (size_t)sprintf(to + used, ".%c0", scene->item);
			path++;
		} else if (!strncmp(path, "**", 2)) {
			used += (size_t)sprintf(to + used, "c0");
			path++;
		} else if (*path == '*') {
			used += (size_t)sprintf(to + used, "%s", name);
		} else {
			to[used++] = *path;
		}
	to[used] = '\0';
}

/* Forms that these scenes do not have beside those that they have. */
static int is_left_out(const struct hawser__tree_key *row)
{
	static const char *const part[] = {
		"net.nodes.*", "net.cables[].EA.", ".plane.", ".segment.", "tow.tow.waypoints", "tow.tow.ends",
		"tow.tow.speed",
		"tow.tow.start", "contact.path", "rod.rod[]", "loads.*[]", "loads.**[]", "factor",
		"net.obstacles[].velocity", "net.failures", "net.winches", "tow.body.mass", "tow.body.CdA",
		"tow.body.inertia", "rod.loads[].from",
		"spin", "obstacles.cable.elements", "drive.brake.", ".shedding.", "net.obstacles[].inertia",
		"rod.loads[].to", "rod.loads[].moment", "ropeway.ropeway.bottom.tension.", "net.cables[].t",
		"net.cables[].f", "net.cables[].s",
		"ropeway.ropeway.cases[]", "obstacles.tension.", "net.loads.*", "winch.times", "winch.speeds",
		"winch.lengths", "net.passing[]", "net.absorbers[]", "net.masses.*.", "net.bodies.*.",
		"net.wind", "net.cables[].wind", /* the scene is in water */
		"rod.water.", "tow.water."};     /* those of nets, by the same rows */
	size_t i = 0;

	while (i < sizeof part/sizeof *part && !strstr(row->path, part[i]))
		i++;
	return i < sizeof part/sizeof *part && strcmp(row->path, "net.loads.*.harmonic.Omega") != 0;
}

static int compare(const struct scene *scene, const struct hawser__tree_key *row)
{
	struct hawser_report report = {0};
	char path[PATH], set[2*PATH] = "", unit[64];
	const char *wrong;

	path_of(path, scene, row->path);
	wrong = strcmp(row->unit, "kg") ? "1 kg" : "1 m";
	snprintf(set, sizeof set, "%s=%s", path, row->count ? "[" : wrong);
	for (int k = 0; k < row->count; k++) {
		strcat(set, wrong);
		strcat(set, k < row->count - 1 ? ", " : "]");
	}
	snprintf(unit, sizeof unit, "%s", strcmp(row->unit, "1") ? row->unit : "pure number");
	if (read_it(scene->kind, set, &report) == HAWSER_ERR_SCENE && strstr(report.message, unit))
		return 1;
	printf("# %s: no \"%s\" in: %s\n", set, unit, report.message);
	return 0;
}

CASE(unit_tree_keys)
{
	int handle = mkstemp(file);
	const struct hawser__tree_key *row;

	if (handle < 0)
		return 99;
	for (size_t k = 0; k < sizeof scenes/sizeof *scenes; k++) {
		const struct scene *scene = &scenes[k];
		struct hawser_report report = {0};
		size_t length = strlen(scene->kind);
		int good = 0, all = 0;

		if (ftruncate(handle, 0) || pwrite(handle, scene->text, strlen(scene->text), 0) < 0)
			return 99;
		ok(read_it(scene->kind, NULL, &report) == HAWSER_OK, "%s: the scene is read %s", scene->kind,
		   report.message);
		for (int i = 0; (row = hawser__tree_row(i)); i++) {
			if (strncmp(row->path, scene->kind, length) != 0 || row->path[length] != '.' ||
			    (row->type != HAWSER__TREE_NUMBER && row->type != HAWSER__TREE_INTEGER) ||
			    !row->unit || strchr(row->unit, ',') || is_left_out(row))
				continue;
			all++;
			good += compare(scene, row);
		}
		ok(all >= 10 && good == all, "%s: %d of %d numbers have the reader's unit", scene->kind, good,
		   all);
	}
	close(handle);
	unlink(file);
	return done_testing();
}
