/* cli/model/axis.c - titles of axes that show a key of the scene: quantity, symbol and
 * unit, with a prefix that leaves short numbers.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <string.h>

#include "cli/model/axis.h"

/* Quantity and symbol ("": none) in gnuplot's markup. */
static const struct {
	const char *key, *quantity, *symbol;
} rows[] = {
	{"Omega", "Forcing frequency", "{/:Italic Ω}"},
	{"factor.load", "Load, as a factor of the given one", ""},
	{"factor.damping", "Damping, as a factor of the given one", ""},
	{"g", "Acceleration of gravity", "{/:Italic g}"},
	{"cable.EA", "Axial stiffness", "{/:Italic EA}"},
	{"cable.rho", "Mass per length", "{/:Italic ρ}"},
	{"cable.EI", "Bending stiffness", "{/:Italic EI}"},
	{"ends.A", "Rotational stiffness of end A", ""},
	{"ends.B", "Rotational stiffness of end B", ""},
	{"span.d", "Horizontal span", "{/:Italic d}"},
	{"span.h", "Height of end B", "{/:Italic h}"},
	{"tension.H", "Horizontal tension", "{/:Italic H}"},
	{"tension.T0", "Tension at end A", "{/:Italic T}_0"},
	{"tension.T1", "Tension at end B", "{/:Italic T}_1"},
	{"tension.length0", "Unstretched length", ""},
	{"tension.sag", "Sag", ""},
	{"travel.speed", "Travel speed", ""},
	{"travel.fluctuation", "Amplitude of speed fluctuation", "{/:Italic V}"},
	{"travel.braking", "Braking time", ""},
	{"travel.final", "Speed after braking", ""},
	{"support.A.stiffness[0]", "Stiffness of support A along x", ""},
	{"support.A.stiffness[1]", "Stiffness of support A along y", ""},
	{"support.A.stiffness[2]", "Stiffness of support A along z", ""},
	{"support.A.mass", "Mass of support A", ""},
	{"support.A.motion[0]", "Motion of end A along x", ""},
	{"support.A.motion[1]", "Motion of end A along y", ""},
	{"support.A.motion[2]", "Motion of end A along z", ""},
	{"support.A.phase", "Phase of end A", ""},
	{"support.A.harmonic", "Harmonic of end A", ""},
	{"support.B.stiffness[0]", "Stiffness of support B along x", ""},
	{"support.B.stiffness[1]", "Stiffness of support B along y", ""},
	{"support.B.stiffness[2]", "Stiffness of support B along z", ""},
	{"support.B.mass", "Mass of support B", ""},
	{"support.B.motion[0]", "Motion of end B along x", ""},
	{"support.B.motion[1]", "Motion of end B along y", ""},
	{"support.B.motion[2]", "Motion of end B along z", ""},
	{"support.B.phase", "Phase of end B", ""},
	{"support.B.harmonic", "Harmonic of end B", ""},
	{"damping.alpha", "Viscous damping", "{/:Italic α}"},
	{"damping.rayleigh.mass", "Rayleigh damping, mass factor", ""},
	{"damping.rayleigh.stiffness", "Rayleigh damping, stiffness factor", ""},
	{"damping.ratio", "Damping ratio", ""},
	{"damping.drag", "Quadratic drag", "{/:Italic c}"},
	{"load.per_length[0]", "Load per length, first axis", ""},
	{"load.per_length[1]", "Load per length, second axis", ""},
	{"load.per_length[2]", "Load per length, third axis", ""},
	{"load.static.mass", "Mass of ice per length", ""},
	{"wind.speed", "Wind speed", "{/:Italic U}"},
	{"wind.density", "Density of the air", ""},
	{"wind.diameter", "Diameter in the wind", "{/:Italic D}"},
	{"wind.angle", "Angle of attack at rest", ""},
	{"wind.viscosity", "Viscosity of the air", ""},
	{"wind.wake.strouhal", "Strouhal number", "{/:Italic St}"},
	{"wind.wake.lift", "Lift coefficient of the vortices", ""},
	{"wind.wake.A", "Coupling of the wake", "{/:Italic A}"},
	{"wind.wake.epsilon", "Growth of the wake", "{/:Italic ε}"},
	{"wind.wake.fluid_damping", "Damping by the fluid", ""},
	{"wind.wake.added_mass", "Added mass coefficient", ""},
	{"wind.wake.at", "Number of wakes", ""},
	{"temperature.change", "Change of temperature", ""},
	{"temperature.expansion", "Thermal expansion", ""},
	{"attach[].mass", "Attached mass", ""},
	{"attach[].absorber_mass", "Mass of the absorber", ""},
	{"attach[].absorber_stiffness", "Stiffness of the absorber", ""},
	{"attach[].absorber_damping", "Damper of the absorber", ""},
	{"attach[].absorber_cubic", "Cubic spring of the absorber", ""},
	{"attach[].at", "Place of the attachment", ""},
	{"attach[].force[0]", "Force along x", ""},
	{"attach[].force[1]", "Force along y", ""},
	{"attach[].force[2]", "Force along z", ""},
	{"attach[].spring[0]", "Spring along x", ""},
	{"attach[].spring[1]", "Spring along y", ""},
	{"attach[].spring[2]", "Spring along z", ""},
	{"attach[].damper[0]", "Damper along x", ""},
	{"attach[].damper[1]", "Damper along y", ""},
	{"attach[].damper[2]", "Damper along z", ""},
	{"loads[].from", "Begin of the loaded part", ""},
	{"loads[].to", "End of the loaded part", ""},
	{"loads[].wave", "Wavelength of the load", ""},
	{"loads[].at", "Position of the force", ""},
	{"loads[].harmonic", "Harmonic of the load", ""},
	{"loads[].phase", "Phase of the load", ""},
	{"model.modes", "Number of modes", ""},
	{"model.accuracy", "Accuracy asked for", ""},
	{"model.basis", "Functions a component", ""},
	{"model.tolerance", "Tolerance of frequencies", ""},
	{"beam.mu", "Tension", "{/:Italic μ}"},
	{"beam.theta", "Bending rigidity", "{/:Italic θ}"},
	{"beam.rho", "Weight", "{/:Italic ρ}"},
	{"beam.c", "Drag", "{/:Italic c}"},
	{"beam.slenderness", "Slenderness ratio", "{/:Italic S}_{/:Italic R}"},
	{"beam.v", "Speed", "{/:Italic v}"},
	{"beam.EI", "Bending rigidity", "{/:Italic EI}"},
	{"beam.rhoA", "Mass per length", "{/:Italic ρA}"},
	{"beam.L", "Length", "{/:Italic L}"},
	{"beam.tension_end", "Tension at the end", ""},
	{"beam.drag", "Drag", ""},
	{"beam.gyration", "Radius of gyration", ""},
	{"beam.inclination", "Inclination", ""},
	{"beam.speed", "Speed", ""},
};

/* The next character of a key in which every index is written as ".0"; NUL at its end. */
static char next(const char **key)
{
	char c;

	if (**key == ']')
		++*key;
	c = **key;
	if (c)
		++*key;
	return (char)(c == '[' ? '.' : c);
}

/* What follows in a key the part that a row names, in which "[]" stands for every index and name:
 * attach[2].mass, attach.2.mass and attach.NAME.mass are attach[].mass. NULL if the key is another. */
static const char *behind(const char *row, const char *key)
{
	for (char c; (c = next(&row)) != '\0';) {
		if (next(&key) != c)
			return NULL;
		if (c == '.' && *row == ']')
			key += strcspn(key, ".]");
	}
	return key + (*key == ']');
}

int cli_axis_quantity(const char **quantity, const char **symbol, const char *key)
{
	const char *rest;

	for (size_t i = 0; i < sizeof rows/sizeof *rows; i++)
		if ((rest = behind(rows[i].key, key)) && !*rest) {
			*quantity = rows[i].quantity;
			*symbol = rows[i].symbol;
			return 1;
		}
	*quantity = key;
	*symbol = "";
	return 0;
}

const char *cli_key_unit(const char *key)
{
	const struct hawser_scene_key *row;
	const char *rest;

	for (int k = 0; (row = hawser_scene_key(k)); k++)
		if ((rest = behind(row->path, key)) &&
		    strspn(rest, "[.0123456789]") == strlen(rest)) /* or an element of a vector */
			return row->unit;
	return "1";
}

void cli_axis_value(char *text, size_t size, const char *key, double value)
{
	const char *quantity, *symbol, *unit = cli_key_unit(key);
	struct hawser__axis axis = hawser__axis_of("", strcmp(unit, "1") == 0 ? "" : unit, 0.0);

	cli_axis_quantity(&quantity, &symbol, key);
	snprintf(text, size, "%s = %g%s%s", *symbol ? symbol : quantity, value/axis.per,
	         *axis.unit ? " " : "", axis.unit);
}

void cli_key_title(char *text, size_t size, const char *key)
{
	size_t k = 0;

	for (const char *c = key; *c && k + 2 < size; c++) {
		if (*c == '_')
			text[k++] = '\\';
		text[k++] = (char)(*c == '\'' ? ' ' : *c);
	}
	text[k] = '\0';
}

struct hawser__axis cli_axis(const char *key, const char *unit, double largest)
{
	const char *quantity, *symbol;
	char label[80];

	if (cli_axis_quantity(&quantity, &symbol, key))
		snprintf(label, sizeof label, "%s%s%s", quantity, *symbol ? " " : "", symbol);
	else
		cli_key_title(label, sizeof label, key);
	return hawser__axis_of(label, *unit || strcmp(key, "Omega") == 0 ? unit : "1", largest);
}
