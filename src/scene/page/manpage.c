/* scene/page/manpage.c - a program of the build that writes hawser-scene(5), in man(7), from the table
 * of keys.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

#include <hawser/plausible.h>
#include <hawser/scene.h>

#include "scene/page/example.h"
#include "scene/page/manpage.h"
#include "scene/tree_keys.h"

/* Backslashes, and hyphens as minus. */
void manpage_text(const char *from)
{
	if (*from == '.' || *from == '\'')
		fputs("\\&", stdout);
	for (; *from; from++)
		if (*from == '\\')
			fputs("\\e", stdout);
		else if (*from == '-')
			fputs("\\-", stdout);
		else if (*from == '^')
			fputs("\\(ha", stdout);
		else
			putchar(*from);
}

void manpage_sentence(const char *from)
{
	int column = 0;

	while (*from) {
		int length = (int)strcspn(from, " ");

		if (column && column + length > 72) {
			putchar('\n');
			column = 0;
		}
		if (column)
			column += printf(" ");
		for (column += length; length > 0; length--, from++)
			if (*from == '^')
				fputs("\\(ha", stdout);
			else
				putchar(*from);
		from += *from == ' ';
	}
}

static void example(void)
{
	fputs(".SH EXAMPLE\n.nf\n", stdout);
	for (const char *line = hawser__scene_example; *line;) {
		char copy[128];
		size_t length = strcspn(line, "\n");

		snprintf(copy, sizeof copy, "%.*s", (int)length, line);
		manpage_text(copy);
		putchar('\n');
		line += length + (line[length] == '\n');
	}
	fputs(".fi\n", stdout);
}

/* The keys directly in a mapping, "span.cable". */
static void keys_of(const char *of)
{
	const struct hawser__tree_table *table = &hawser__tree_of_span;

	for (int i = 0; i < table->rows; i++)
		if (hawser__tree_key_of(table->row[i].path, of) && table->row[i].type < HAWSER__TREE_MAPPING)
			manpage_key(&table->row[i]);
}

static void table(void)
{
	const struct hawser__tree_table *table = &hawser__tree_of_span;

	fputs(".SH KEYS\n.SS Top level\n", stdout);
	keys_of("span");
	for (int i = 0; i < table->rows; i++) {
		const struct hawser__tree_key *row = &table->row[i];

		if (row->type != HAWSER__TREE_MAPPING || strchr(row->path, '['))
			continue;
		fputs(".SS ", stdout);
		manpage_text(strchr(row->path, '.') + 1);
		printf(" (%s)\n", row->need == HAWSER__TREE_REQUIRED ? "required" : "optional");
		putchar(toupper((unsigned char)*row->doc));
		manpage_sentence(row->doc + 1);
		fputs(".\n", stdout);
		keys_of(row->path);
	}
	fputs(".SS attach (optional)\n"
	      "A list of point masses on the cable, each with springs and dampers from the same\n"
	      "point to ground, with a dead force, and with an absorber, a mass on a spring of its own:\n"
	      ".PP\n.RS\n.nf\n"
	      "attach:\n"
	      "  \\- {at: 25 %, mass: 20 kg, name: carrier}\n"
	      "  \\- {at: 12 m, mass: 3 kg, damper: [0, 3 kN.s/m, 0]}\n"
	      "  \\- {at: 60 %, force: [0, \\-500 N, 200 N]}\n"
	      "  \\- {at: 50 %, absorber_mass: 8 kg, absorber_stiffness: 2 kN/m, name: tmd}\n"
	      ".fi\n.RE\n.PP\n", stdout);
	printf("At most %d attachments are possible.\n"
	       ".B \"\\-\\-set attach.0.mass=25kg\"\n"
	       "sets a key of the first one,\n"
	       ".B \"\\-\\-set attach.carrier.mass=25kg\"\n"
	       "of the one with this name,\n"
	       "and \\-\\-set \\(aqattach=[{...}]\\(aq replaces the list.\n", HAWSER_ATTACH_MAX);
	fputs("A force is constant, and belongs to the reference state and the loaded state as masses do.\n"
	      "If it is not downwards, the cable hangs in space, as with masses in a wind: give T0, T1 or\n"
	      "length0.\n"
	      "Modes list the stroke of each absorber; responses have a point\n"
	      ".B stroke_NAME\n"
	      "with its displacement relative to the cable. The damping of the scene does not act\n"
	      "on absorbers.\n",
	      stdout);
	keys_of("span.attach[]");
	fputs(".SS loads (optional)\n"
	      "A list of varying loads, which add to each other and to the section load: each is a\n"
	      "force per unstretched length on a part of the cable, which may be a wave that runs along\n"
	      "it, or a force at a point. Its time function is\n"
	      ".PP\n.RS\n.nf\n"
	      "cos(harmonic Omega t + phase \\- 2 pi S/wave)\n"
	      ".fi\n.RE\n.PP\n"
	      "with the unstretched length S from end A, without the last term if there is no wave:\n"
	      ".PP\n.RS\n.nf\n"
	      "loads:\n"
	      "  \\- {per_length: [0, 1 N/m, 0], from: 20 %, to: 40 %, harmonic: 2, phase: 90 degree}\n"
	      "  \\- {force: [0, 0, 2 kN], at: 30 %, name: hand}\n"
	      "  \\- {per_length: [0, 0.5 N/m, 0], wave: 40 m}\n"
	      ".fi\n.RE\n.PP\n", stdout);
	printf("A wave runs with the speed Omega*harmonic*wave/(2 pi).\n"
	       "Waves shorter than 1/200 of the cable are refused.\n"
	       "At most %d loads are possible; their keys are set as those of attachments,\n"
	       ".BR \"\\-\\-set loads.0.phase=1\" .\n", HAWSER_LOADS_MAX);
	keys_of("span.loads[]");
	fputs(".SS cases (optional)\n"
	      "A list of load cases for the tension table of\n"
	      ".BR \"hawser statics \\-\\-cases\" ;\n"
	      "no other command reads it:\n"
	      ".PP\n.RS\n.nf\n"
	      "cases:\n"
	      "  \\- {name: hot, temperature: {change: 50 K, expansion: 1.9e\\-5 /K}}\n"
	      "  \\- {name: ice, load: {static: {mass: 0.9 kg/m}},\n"
	      "     temperature: {change: \\-20 K, expansion: 1.9e\\-5 /K}}\n"
	      ".fi\n.RE\n.PP\n", stdout);
	printf("A case takes the place of load.static and of the change of temperature of the\n"
	       "scene: what it does not give is no static load, or no change.\n"
	       "temperature.expansion is that of the scene\n"
	       "if the case has none. All cases have the length of cable of the scene's reference state.\n"
	       "A case's key is set by its name,\n"
	       ".BR \"\\-\\-set cases.ice.load.static.mass=1.1\" .\n"
	       "At most %d cases are possible.\n", HAWSER_CASES_MAX);
}

static const char before[] =
	".SH NAME\n"
	"hawser\\-scene \\- the scene file of hawser\n"
	".SH DESCRIPTION\n"
	"A scene describes a cable, its ends and the loads on it.\n"
	"It is one YAML document: a mapping of sections,\n"
	"each a mapping of keys to values.\n"
	".PP\n"
	"The file is checked strictly.\n"
	"An unknown, duplicate, missing or contradictory key,\n"
	"a unit of the wrong dimension and a value out of range are errors\n"
	"that name the file, the line and the column.\n"
	"No physical quantity except\n"
	".B g\n"
	"has a default.\n"
	"Anchors, aliases and tags of YAML are not allowed; a scene has at most 1 MiB.\n"
	".SS Values\n"
	"A plain number is in the SI unit given below for its key.\n"
	"A number followed by a unit, such as\n"
	".BR \"400 MN\" ,\n"
	".B \"6 kg/m\"\n"
	"or\n"
	".BR \"18 km/h\" ,\n"
	"is converted by\n"
	".BR udunits2 (3);\n"
	"a list may contain both.\n"
	"One hertz is 2 pi radians per second.\n"
	"A unit with an angle does not convert to one without: rad/s is not 1/s.\n"
	".SS Overrides\n"
	"The option\n"
	".BI \\-\\-set \" KEY\" = VALUE\n"
	"of the commands replaces a value of the file\n"
	"before the scene as a whole is checked:\n"
	".PP\n"
	".RS\n"
	".nf\n"
	"\\-\\-set cable.EA=1e8\n"
	"\\-\\-set \\(aqload.per_length=[0.8 N/m, 0, 0]\\(aq\n"
	"\\-\\-set \\(aqload={frame: global, per_length: [0, 1, 0]}\\(aq\n"
	".fi\n"
	".RE\n"
	".PP\n"
	"A section or a list that is given as a whole takes the place of all of it.\n"
	"If several keys exclude each other,\n"
	"such as tension.H and tension.T0 or the kinds of damping,\n"
	"an override replaces the key given by the file or by an earlier override.\n"
	"For a scene that gives tension.T0,\n"
	".B \"\\-\\-set tension.H=90kN\"\n"
	"therefore gives the horizontal tension instead.\n"
	".PP\n"
	"Items of lists and elements of vectors have numbers from 0 on, attach.0.mass or attach[0].mass,\n"
	"and load.per_length[1]; items may be called by their names, attach.carrier.mass.\n"
	"Nothing after = takes out what is there, so that it has its default:\n"
	".BR \"\\-\\-set load=\" ,\n"
	".BR \"\\-\\-set attach.0=\" .\n"
	".SS Axes\n"
	"x runs along the span from end A to end B, y upwards, z out of their plane.\n"
	"Arclength is unstretched and measured from A; tension is positive.\n";

static const char elastic[] =
	".SH ELASTIC SUPPORTS\n"
	"support.A.stiffness and support.B.stiffness put an end of the cable on springs along x, y and z,\n"
	"between the end and a foundation: a tower, a beam, a yielding anchorage.\n"
	"A direction with .inf is rigid. A mass that moves with the end is support.A.mass or\n"
	"support.B.mass; it needs a stiffness.\n"
	"The ends are at the given positions in the state whose tension is given (tension.state):\n"
	"the springs are in equilibrium there, and their preload balances the static force of the cable\n"
	"and the weight of the mass. In the other state, and in the cases of hawser statics --cases, each\n"
	"end has moved by the change of the force of the cable over the stiffness; modes and motions are\n"
	"those about the ends where they are then.\n"
	"Springs are linear along fixed axes. An end that moves by more than a tenth of the distance of\n"
	"the ends in this way is refused.\n"
	"damping.alpha is the drag of still air on the cable, not on the mass of a support.\n"
	".PP\n"
	"Condensed modes respond to loads, but not to the damping by still air of the kept modes.\n"
	"They cannot be combined with travel and cable.EI. Under a static load per_length that turns the\n"
	"cable out of its plane the springs join its planes, and the cable is treated as one in space:\n"
	"without motion of its supports, damped modes and hawser irvine, which keeps the ends of all\n"
	"tensions where they are at that of the scene. With support.A.motion or support.B.motion the\n"
	"given motion is that of the foundation, behind the springs.\n"
	".PP\n"
	"A stay whose upper end is held by a mast of 2 t that yields:\n"
	".PP\n"
	".RS\n"
	".nf\n"
	"cable: {EA: 450 MN, rho: 18 kg/m}\n"
	"span: {d: 85 m, h: 85 m}\n"
	"tension: {T0: 2.5 MN}\n"
	"support: {B: {stiffness: [3 MN/m, .inf, 0.9 MN/m], mass: 2000 kg}}\n"
	".fi\n"
	".RE\n";

static const char loaded[] =
	".SH STATIC LOADS AND TEMPERATURE\n"
	"load.static adds a constant force per unstretched length to the weight:\n"
	"per_length along x, y, z, such as a steady wind, and the weight of the mass that adheres to the\n"
	"cable, such as ice.\n"
	"The cable then hangs in the plane of its chord and the sum of these forces.\n"
	"In this plane it is a catenary as under its weight alone, which is computed exactly.\n"
	"In\\-plane and out\\-of\\-plane refer to the plane of the cable, and so do tangent, normal and\n"
	"binormal (load.frame: local), the horizontal tension H (the component across the static force),\n"
	"V0, V1, eta and the sag (the largest distance from the chord along the static force).\n"
	"The axes x, y, z of loads in load.frame: global, of profiles and of displacements such as y_mid\n"
	"remain those of the ends and the vertical.\n"
	"The mass counts as inertia in all motions; the force per_length does not.\n"
	"Wind is a dead force: it does not depend on the motion of the cable.\n"
	"It acts on the cable, not on attachments: with masses the cable hangs in space, each part\n"
	"between them in a plane of its own, which is computed exactly too.\n"
	"The sag is then still that along the static force per length; H, V0 and eta are those of end A.\n"
	"With tension.state loaded give T0, T1 or length0 of such a cable.\n"
	".PP\n"
	"temperature changes the unstretched length by the factor 1 + expansion * change.\n"
	".PP\n"
	"With either section, a scene has two states of the same cable: the reference state, at rest,\n"
	"without static load and change of temperature, and the loaded state, with both.\n"
	"The quantity under tension is that of the reference state, unless tension.state is loaded:\n"
	"give reference for a cable that is strung with a known tension and loaded afterwards, and loaded\n"
	"where the tension under the load is known.\n"
	"The unstretched length of the other state follows.\n"
	"All results are of the loaded state;\n"
	".BR hawser\\-statics (1)\n"
	"states the reference state too.\n"
	"If the cable travels, travel.hold refers to the loaded state at rest.\n"
	"Sweeps over the tension\n"
	".RB ( hawser\\-irvine (1))\n"
	"vary the tension of the loaded state.\n"
	".PP\n"
	"A conductor strung with 28 kN, 20 K colder, with ice and wind:\n"
	".PP\n"
	".RS\n"
	".nf\n"
	"cable: {EA: 25 MN, rho: 1.6 kg/m}\n"
	"span: {d: 400 m, h: 12 m}\n"
	"tension: {H: 28 kN}\n"
	"temperature: {change: \\-20 K, expansion: 1.9e\\-5 /K}\n"
	"load: {static: {per_length: [0, 0, 12 N/m], mass: 0.9 kg/m}}\n"
	".fi\n"
	".RE\n";

static const char after[] =
	".SH SEE ALSO\n"
	".BR hawser (1),\n"
	".BR udunits2 (3)\n";

/* Write the rules of plausibility. */
static void plausible(void)
{
	const struct hawser_plausible_rule *rule;

	fputs(".SH PLAUSIBILITY\n"
	      "A scene may be valid and still describe no real cable: EA: 400 in place of 400 MN.\n"
	      "Some quantities that follow from the scene lie within known bounds for all real\n"
	      "materials.\n"
	      "A quantity outside its bounds causes a warning on standard error, also with\n"
	      ".BR \\-\\-quiet .\n"
	      "The warning names the key, its value and the quantity. If a value that differs by a\n"
	      "power of 1000 is plausible, the warning states that value.\n"
	      "The result does not change.\n"
	      "A scaled beam has no such bounds.\n", stdout);
	for (int i = 0; (rule = hawser_plausible_rule(i)); i++) {
		char line[400], low[32] = "up";

		if (rule->low > 0.0)
			snprintf(low, sizeof low, "from %g", rule->low);
		snprintf(line, sizeof line, "%s%s%s", rule->name, *rule->formula ? ", " : "",
		         rule->formula);
		fputs(".TP\n", stdout);
		manpage_sentence(line);
		fputs("\n", stdout);
		snprintf(line, sizeof line, "%s to %g%s%s (%s).", low, rule->high,
		         *rule->unit ? " " : "", rule->unit, rule->keys);
		manpage_sentence(line);
		fputs("\n", stdout);
		manpage_sentence(rule->why);
		if (*rule->why)
			fputs("\n", stdout);
	}
}

static const char bending[] =
	".SH BENDING\n"
	"cable.EI gives the cable a bending stiffness.\n"
	"It acts against changes of the curvature from the static shape, which remains the catenary:\n"
	"the cable is taken to be free of bending moments there, as after creep of the strands,\n"
	"and clamps to be aligned with its tangents.\n"
	"ends says how each end is held against rotation, in the plane of the cable and out of it:\n"
	"pinned, clamped, or by a rotational stiffness (moment per radian).\n"
	".BR hawser\\-modes (1)\n"
	"then has the frequencies of the full problem, with the boundary layers of the width sqrt(EI/T)\n"
	"at the ends, and the bending moments there. Reduced models have it, condensed or not.\n"
	"Not with travel, elastic supports, model.energy: exact and model.modes: auto.\n"
	"See doc/theory\\-bending.md.\n"
	".PP\n"
	".RS\n"
	".nf\n"
	"cable: {EA: 1560 MN, rho: 65 kg/m, EI: 1.2 MN.m^2}\n"
	"ends: {A: clamped, B: 8 MN.m}\n"
	".fi\n"
	".RE\n";

int main(void)
{
	printf(".\\\" Written by src/scene/page/manpage.c from the table of keys: change that.\n"
	       ".TH HAWSER\\-SCENE 5 2026-11-21 \"hawser %s\" \"File formats\"\n",
	       PACKAGE_VERSION);
	fputs(before, stdout);
	table();
	fputs(elastic, stdout);
	fputs(loaded, stdout);
	fputs(bending, stdout);
	manpage_kinds();
	example();
	plausible();
	fputs(after, stdout);
	return fflush(stdout) || ferror(stdout);
}
