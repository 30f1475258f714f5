/* output/drawing/axis.c - axes of pictures in the units that the user has chosen. See units.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "output/fields/units.h"

static const struct {
	const char *si, *shown;
	int prefixed; /* may be kilo or mega */
} units[] = {
	{"N", "N", 1}, {"N.m^2", "N m²", 1}, {"kg/m/s", "kg/(m s)", 0}, {"N.s/m", "N s/m", 1},
	{"N/m", "N/m", 1}, {"N.m", "N m", 1}, {"1", "–", 0}, {"rad/s/m^2", "rad/s/m²", 0},
};
enum { UNITS = sizeof units/sizeof *units };

static size_t append(char *text, size_t size, size_t used, const char *what)
{
	size_t length = strlen(what);

	if (used + length >= size)
		return used;
	memcpy(text + used, what, length + 1);
	return used + length;
}

/* A unit as the user wrote it: squares and cubes are raised, and what has a meaning in the markup or in
 * single quotes stands for itself. */
static void markup(char *text, size_t size, const char *unit)
{
	size_t used = 0;

	*text = '\0';
	for (const char *c = unit; *c; c++)
		if (*c == '^' && (c[1] == '2' || c[1] == '3') && !strchr("0123456789", c[2] ? c[2] : 'x'))
			used = append(text, size, used, *++c == '2' ? "²" : "³");
		else if (*c == '\'')
			used = append(text, size, used, "''");
		else if (*c == '.' && isalpha((unsigned char)c[1]))
			used = append(text, size, used, " ");
		else if (strchr("_^{}@&~\\", *c))
			used = append(text, size, used, (const char[]){'\\', *c, '\0'});
		else
			used = append(text, size, used, (const char[]){*c, '\0'});
}

/* Length of the quantity without its symbol. */
static int words_of(const char *quantity)
{
	const char *symbol = strstr(quantity, " {/:Italic ");

	return (int)(symbol ? (size_t)(symbol - quantity) : strlen(quantity));
}

struct hawser__axis hawser__axis_of(const char *quantity, const char *si, double largest)
{
	const struct hawser__shown_unit shown = hawser__shown_unit(si);
	struct hawser__axis axis = {.per = shown.per};
	int words = (int)strlen(quantity), known = 0;

	for (int k = 0; k < UNITS && !shown.changed; k++)
		if (strcmp(units[k].si, si) == 0) {
			int prefixed = units[k].prefixed && !shown.chosen && fabs(largest) >= 1e3;

			axis.per = !prefixed ? 1.0 : fabs(largest) >= 1e6 ? 1e6 : 1e3;
			snprintf(axis.unit, sizeof axis.unit, "%s%s", !prefixed ? "" : axis.per == 1e6 ? "M" : "k",
			         units[k].shown);
			known = 1;
		}
	if (!known)
		markup(axis.unit, sizeof axis.unit, shown.name);
	if (shown.changed && strcmp(si, "rad/s") == 0 && strstr(shown.name, "Hz"))
		words = words_of(quantity);
	snprintf(axis.title, sizeof axis.title, "%.*s%s%s%s", words, quantity, *axis.unit ? " (" : "",
	         axis.unit, *axis.unit ? ")" : "");
	return axis;
}
