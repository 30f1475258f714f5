/* scene/page/manpage_kinds.c - the part of hawser-scene(5) about scenes whose names are the user's: for
 * each kind an example, what its keys do not say, and its keys from their table.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <stdio.h>
#include <string.h>

#include "scene/page/manpage.h"
#include "scene/tree_keys.h"

static const char net[] =
	".SH NETS\n"
	"A scene with kind: net describes cables between nodes. No initial shape is asked for.\n"
	"x and z are horizontal, y is upwards; cables carry tension only, and may be slack.\n"
	".PP\n.RS\n.nf\n"
	"kind: net\n"
	"nodes: {A: [0 m, 0 m, 0 m], J: {}, B: [300 m, 15 m, 0 m]}\n"
	"cables:\n"
	"  \\- {name: c1, from: A, to: J, EA: 100 MN, rho: 5.56 kg/m, length0: 150.2 m, elements: 60}\n"
	"  \\- {name: c2, from: J, to: B, EA: 100 MN, rho: 5.56 kg/m, length0: 150.9 m}\n"
	"supports: {A: fixed, B: {fixed: [x, y], motion: {x: {amplitude: 0.1 m, Omega: 2 rad/s}}}}\n"
	"masses: {J: 12 kg}\n"
	"loads: {J: [0 N, \\-8 kN, 0 N]}\n"
	".fi\n.RE\n.PP\n"
	"With obstacles cables must have length0. Statics does not use contact.restitution.\n"
	"In a motion\n"
	"all obstacles have their friction; the sliding is that of the equilibrium at which\n"
	"it begins.\n"
	".PP\n"
	"A span (cable with EA, rho and elements (200), span with d and h, tension with\n"
	"length0) whose\n"
	"obstacles are not all circles is such a mesh, a net of one cable between the\n"
	"supports A and B,\n"
	"with the same obstacles, contact, damping and dynamics.\n";

static const char obstacles[] =
	".SH OBSTACLES\n"
	"A span may pass over or under circles, such as the sheaves of a tower:\n"
	".PP\n.RS\n.nf\n"
	"cable: {EA: 1.5 GN, rho: 5.56 kg/m}\n"
	"span: {d: 300 m, h: 0 m}\n"
	"tension: {length0: 301 m}\n"
	"obstacles:\n"
	"  \\- {circle: {centre: [50 m, \\-5 m], radius: 10 m}, side: above, friction: 0.1}\n"
	"contact: {sliding: none}\n"
	".fi\n.RE\n.PP\n"
	"Other keys of spans are refused by name. An obstacle that the rope does not reach\n"
	"is no error:\n"
	"the rope passes it at a distance that is reported. A rope that is too short for\n"
	"its way past the\n"
	"obstacles is refused. Surfaces do not move. With planes or segments among the\n"
	"obstacles the span\n"
	"is a mesh, see NETS.\n"
	".PP\n"
	"Friction acts against the sliding, so that the tension grows in its direction.\n"
	"With sliding: none\n"
	"there is no tangential force in the state that is shown, and the limits at which\n"
	"the rope begins\n"
	"to slide are computed besides. With one obstacle each tension between them is\n"
	"possible at rest;\n"
	"with several the limits are those at which the whole rope begins to slide.\n"
	"With history the friction follows from what the rope has been through: at the first value of\n"
	"contact.path there are no tangential forces, and in each step of the way no rope passes an\n"
	"obstacle as long as its friction holds it; otherwise it slips with all its\n"
	"friction. An example\n"
	"is contact: {sliding: history, path: [305 m, 300.9 m]}.\n";

static const char ropeway[] =
	".SH ROPEWAYS\n"
	"A scene with the section ropeway describes the hauling rope of a ropeway: a loop\n"
	"over a bullwheel\n"
	"in each station, whose two lanes pass the same towers. x is horizontal, from the\n"
	"bottom to the top\n"
	"station, y upwards. Lane up goes to the top station, lane down back.\n"
	".PP\n.RS\n.nf\n"
	"ropeway:\n"
	"  rope: {EA: 40 MN, rho: 4 kg/m}\n"
	"  bottom: {at: [0 m, 0 m], radius: 2.5 m,\n"
	"           tension: {counterweight: 168 kN, travel: [\\-1 m, 2 m]}}\n"
	"  top: {at: [300 m, 58 m], radius: 2.5 m, drive: {speed: 4 m/s, friction: 0.2}}\n"
	"  towers:\n"
	"    \\- {at: [80 m, 17 m], battery: support, radius: 12 m, friction: 0.03}\n"
	"    \\- {at: [190 m, 40 m], battery: auto, radius: 12 m, friction: 0.03,\n"
	"       sheaves: {count: 8, spacing: 0.5 m, radius: 0.2 m}}\n"
	"  carriers: {spacing: 36.6 m, mass: {up: 400 kg, down: 250 kg}, phase: sweep}\n"
	".fi\n.RE\n";

static const char rod[] =
	".SH RODS\n"
	"A geometrically exact rod bends, twists, shears and stretches by any amount, in space:\n"
	".PP\n.RS\n.nf\n"
	"kind: rod\n"
	"rod: {length: 10 m, EA: 2 MN, GA: 0.7 MN, EI: 40 N.m^2, GJ: 30 N.m^2, rho: 2 kg/m}\n"
	"start: {at: [0 m, 0 m, 0 m], tangent: [1, 0.2, 0], hold: clamped}\n"
	"loads:\n"
	"  \\- {at: end, force: [0 N, \\-20 N, 5 N]}\n"
	"  \\- {from: 2 m, to: 8 m, force: [0 N/m, 0 N/m, 3 N/m]}\n"
	".fi\n.RE\n.PP\n"
	"e1 is the tangent, e2 and e3 are the axes of the section. The unloaded rod begins\n"
	"at start.at with\n"
	"the direction tangent; what the end gives is where it is brought from there.\n"
	"Statics ignore the\n"
	"factor of loads.\n"
	".PP\n"
	"The speed of a spin grows from 0 with the acceleration speed/rise (1 \\- cos(2 pi\n"
	"t/rise)); without\n"
	"rise it is constant from t = 0. A path has displacements from the given position,\n"
	"joined by a\n"
	"natural cubic spline. A winch makes the first segment longer or shorter, all its elements in\n"
	"proportion; loads must not begin or end within this segment. Its speeds are joined\n"
	"with continuous\n"
	"acceleration, its lengths (the first time is 0 s) by a cubic spline with speed 0\n"
	"at both ends:\n"
	"winch: {times: [0 s, 5 s, 45 s, 50 s], speeds: [0 m/s, 3 m/s, 3 m/s, 0 m/s]}.\n";

static const char tow[] =
	".SH TOW\n"
	"The path of a towing point, such as a helicopter, and what it tows. x and z are\n"
	"horizontal, y is\n"
	"upwards. For\n"
	".BR hawser\\-trajectory (1)\n"
	"the path is enough:\n"
	".PP\n.RS\n.nf\n"
	"tow:\n"
	"  waypoints: [[0 s, 0, 0, 0], [30 s, 100 m, 0, 0], [70 s, 100 m, 0, 100 m],\n"
	"              [100 s, 0, 0, 100 m]]\n"
	"  minimise: snap\n"
	"  ends: [velocity, acceleration]\n"
	".fi\n.RE\n.PP\n"
	".BR hawser\\-tow (1)\n"
	"also needs the cable, the air and the body:\n"
	".PP\n.RS\n.nf\n"
	"tow: {speed: 27.8 m/s}\n"
	"cable: {segments: [{length: 14 m, rho: 58 g/m, diameter: 8 mm, drag: {normal: 1.2}}]}\n"
	"air: {density: 1.2 kg/m^3, wind: [\\-5 m/s, 0, 0]}\n"
	"body:\n"
	"  ring: {radius: 11 m, tube: 7 cm, mass: 435 kg, offset: 16 m, drag: {normal: 1.2}}\n"
	".fi\n.RE\n.PP\n"
	"A path of least snap, jerk or acceleration has pieces of degree 7, 5 or 3 with continuous\n"
	"derivatives up to order 6, 4 or 2; with none each piece is the polynomial of least\n"
	"degree with the\n"
	"derivatives that are given at its two waypoints. If a derivative is given at an\n"
	"inner waypoint,\n"
	"one of a higher order may jump there. Waypoints and given derivatives together\n"
	"must be at least 4\n"
	"for snap, 3 for jerk, 2 for acceleration. Relative names of files are relative to\n"
	"the scene's\n"
	"folder.\n"
	".PP\n"
	"The lift of shed vortices per length is density r lift |p| (t x u) sin(phase),\n"
	"where p is the\n"
	"component of the flow u across the cable, t its tangent and r half the diameter;\n"
	"the phase grows\n"
	"at the rate 2 pi strouhal |p|/diameter. A winch starts at the first time of the\n"
	"path, with speed\n"
	"0, and is that of RODS.\n";

/* "cables[].EA", "nodes.NAME" */
static void path_of(const char *path)
{
	for (path = strchr(path, '.') + 1; *path; path++)
		if (*path == '*') {
			fputs("NAME", stdout);
			path += path[1] == '*';
		} else {
			putchar(*path);
		}
	putchar('\n');
}

static void form(const struct hawser__tree_key *row)
{
	int number = row->type == HAWSER__TREE_NUMBER;
	const char *unit = number && row->unit && strcmp(row->unit, "1") ? row->unit : "";
	char what[400];

	if (row->type == HAWSER__TREE_INTEGER)
		snprintf(what, sizeof what, "Whole number from %.0f to %.0f", row->least, row->most);
	else if (row->type == HAWSER__TREE_POSITION)
		snprintf(what, sizeof what, "Fraction of the length, or length in m");
	else if (row->type == HAWSER__TREE_WORD || row->type == HAWSER__TREE_LIMIT)
		snprintf(what, sizeof what, "%s%s", strchr(row->unit, '|') ? "One of " : "The word ",
		         row->unit);
	else if (row->count)
		snprintf(what, sizeof what, "List of %d numbers", row->count);
	else
		snprintf(what, sizeof what, "%s", number ? "Number"
		         : row->type == HAWSER__TREE_TEXT ? "Name"
		         : row->type == HAWSER__TREE_LIST ? "List" : "Mapping");
	manpage_sentence(row->doc);
	fputs(".\n", stdout);
	manpage_text(what);
	fputs(*unit ? " in " : "", stdout);
	manpage_text(unit);
	if (row->range) {
		fputs(", ", stdout);
		manpage_text(hawser__tree_limits(row->range)->text);
	}
	if (number && row->most > 0.0)
		printf(", at most %g", row->most);
	if (row->need == HAWSER__TREE_REQUIRED || row->need == HAWSER__TREE_ONE_OF)
		fputs(row->need == HAWSER__TREE_REQUIRED ? "; required" : "; one of these", stdout);
	if (row->given && *row->given) {
		fputs("; default ", stdout);
		manpage_text(row->given);
	}
	fputs(".\n", stdout);
}

void manpage_key(const struct hawser__tree_key *row)
{
	const char *path = row->path;

	if (hawser__tree_next(NULL, path) != row)
		return;
	fputs(".TP\n.B ", stdout);
	path_of(path);
	for (; row; row = hawser__tree_next(row, path)) {
		form(row);
		if (hawser__tree_next(row, path))
			fputs("Or\n", stdout);
	}
}

/* The rows of list items that are those of a single value, too, such as "rod.rod[].EA". */
static int twin(const struct hawser__tree_table *table, const char *path)
{
	const char *item = strstr(path, "[]");

	for (int i = 0; item && i < table->rows; i++) {
		const char *other = table->row[i].path;
		size_t length = (size_t)(item - path);

		if (!strncmp(other, path, length) && !strcmp(other + length, item + 2) &&
		    (item[2] || table->row[i].type == HAWSER__TREE_MAPPING))
			return 1;
	}
	return 0;
}

#define KIND(name, NAME) {&hawser__tree_of_##name, name},

void manpage_kinds(void)
{
	static const struct {
		const struct hawser__tree_table *table;
		const char *text;
	} kind[] = {HAWSER_SCENE_KINDS(KIND)};

	for (size_t k = 0; k < sizeof kind/sizeof *kind; k++) {
		fputs(kind[k].text, stdout);
		fputs(".PP\nThe keys are\n", stdout);
		for (int i = 0; i < kind[k].table->rows; i++) {
			const struct hawser__tree_key *row = &kind[k].table->row[i];

			if (!twin(kind[k].table, row->path) && row->need != HAWSER__TREE_MESH)
				manpage_key(row);
		}
	}
}
