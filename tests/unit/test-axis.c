/* tests/unit/test-axis.c - titles of axes: each numeric key of the scene has its own title, so that
 * no picture shows the name of a key.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "cli/model/axis.h"
#include "tests/tap.h"

/* Axes of maps and boundaries (hawser-map(1)): keys with one number, and these. */
static const char *const others[] = {"Omega", "factor.load", "factor.damping"};

static void has_words(const char *key)
{
	const char *quantity, *symbol;
	int known = cli_axis_quantity(&quantity, &symbol, key);

	ok(known && *quantity && !strchr(quantity, '.') && !strchr(quantity, '_'), "%s: %s %s", key,
	   quantity, symbol);
}

static void title_is(const char *key, const char *unit, double largest, const char *title,
                     double per)
{
	struct hawser__axis axis = cli_axis(key, unit, largest);

	ok(!strcmp(axis.title, title) && fabs(axis.per - per) <= 1e-14*per,
	   "%s (%s) up to %g: %s, %g", key, unit, largest, axis.title, axis.per);
}

static void value_is(const char *key, double value, const char *shown)
{
	char text[96];

	cli_axis_value(text, sizeof text, key, value);
	ok(!strcmp(text, shown), "%s: %s", key, text);
}

CASE(unit_axis)
{
	const struct hawser_scene_key *key;
	size_t numeric = 0;

	for (int k = 0; (key = hawser_scene_key(k)); k++)
		if (!strcmp(key->type, "number") || !strcmp(key->type, "integer")) {
			has_words(key->path);
			numeric++;
		}
	ok(numeric > 30, "%zu keys of numbers", numeric);
	for (size_t k = 0; k < sizeof others/sizeof *others; k++)
		has_words(others[k]);
	title_is("tension.T0", "N", 80e3, "Tension at end A {/:Italic T}_0 (kN)", 1e3);
	title_is("cable.EA", "N", 4e8, "Axial stiffness {/:Italic EA} (MN)", 1e6);
	title_is("span.h", "m", 2.385, "Height of end B {/:Italic h} (m)", 1.0);
	title_is("damping.ratio", "1", 0.02, "Damping ratio (–)", 1.0);
	title_is("Omega", "", 3.0, "Forcing frequency {/:Italic Ω}", 1.0);
	title_is("attach.2.mass", "kg", 3.0, "Attached mass (kg)", 1.0);
	title_is("attach.stockbridge.damper[1]", "N.s/m", 3e3, "Damper along y (kN s/m)", 1e3);
	title_is("no.such", "1", 3.0, "no.such (–)", 1.0);
	value_is("beam.rho", 10.0, "{/:Italic ρ} = 10");
	value_is("beam.tension_end", 2385.0, "Tension at the end = 2385 N");
	value_is("beam.EI", 7.0, "{/:Italic EI} = 7 N m²");
	ok(!hawser__units_choose("ft, lbf.ft^2, Hz, N", NULL), "units are chosen");
	title_is("span.h", "m", 2.385, "Height of end B {/:Italic h} (ft)", 0.3048);
	title_is("travel.speed", "m/s", 20.0, "Travel speed (ft/s)", 0.3048);
	title_is("g", "m/s^2", 9.81, "Acceleration of gravity {/:Italic g} (ft/s²)", 0.3048);
	title_is("cable.EI", "N.m^2", 1e6, "Bending stiffness {/:Italic EI} (lbf ft²)",
	         4.4482216152605*0.3048*0.3048);
	title_is("Omega", "rad/s", 3.0, "Forcing frequency (Hz)", 6.283185307179586476925);
	title_is("tension.T0", "N", 80e3, "Tension at end A {/:Italic T}_0 (N)", 1.0); /* not kN */
	title_is("damping.ratio", "1", 0.02, "Damping ratio (–)", 1.0);
	value_is("beam.L", 3.048, "{/:Italic L} = 10 ft");
	return done_testing();
}
