/* scene/units_explain.c - what is wrong with a number that has a unit, in a sentence.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdio.h>
#include <string.h>
#include <ctype.h>
#include <strings.h>

#include "core/spelling.h"
#include "scene/reader.h"

const char *hawser__shown(char shown[HAWSER__SHOWN], const char *text)
{
	size_t length = strlen(text), keep = length;

	if (length > 40) {
		keep = 37;
		while (keep && ((unsigned char)text[keep] & 0xc0) == 0x80)
			keep--;
	}
	for (size_t i = 0; i < keep; i++)
		shown[i] = iscntrl((unsigned char)text[i]) ? '?' : text[i];
	snprintf(shown + keep, HAWSER__SHOWN - keep, "%s", keep < length ? "..." : "");
	return shown;
}

/* Write the advice for a message: how to give a value in this unit. */
static void advice(char *text, size_t size, const char *unit)
{
	if (!strcmp(unit, "1"))
		snprintf(text, size, "give a pure number");
	else if (!strcmp(unit, "rad/s"))
		snprintf(text, size, "give a number in rad/s, or with a unit such as rad/s or Hz");
	else
		snprintf(text, size,
		         "give a number in %s, or with a unit that converts to %s", unit,
		         unit);
}

/* Masses and their weights, of which the other is wanted under standard gravity,
 * 9.80665 m/s^2 by definition. */
static const struct twin {
	const char *wanted, *given, *is, *a;
	double factor;
	const char *other; /* a customary unit of what is wanted, and how much it is in its SI unit */
	double of_other;
} twins[] = {
	{"kg/m", "N/m", "a weight per length (\"%s\"), a force", "a mass per length", 1.0/9.80665, "lb/ft",
	 0.45359237/0.3048},
	{"N", "kg", "a mass (\"%s\")", "a force", 9.80665, "lbf", 0.45359237*9.80665},
	{"N/m", "kg/m", "a mass per length (\"%s\")", "a force per length", 9.80665, "lbf/ft",
	 0.45359237*9.80665/0.3048},
};

/* The row of a mass or weight `text` where the other is wanted, and its value in that unit; NULL: it is
 * neither. */
static const struct twin *twin_of(double *value, const char *text, const char *unit)
{
	const struct twin *found = NULL;
	struct hawser__units units = {NULL};

	for (size_t i = 0; i < sizeof twins/sizeof *twins && !found; i++)
		if (!strcmp(unit, twins[i].wanted) &&
		    hawser__units_read(&units, value, text, twins[i].given) == HAWSER__NUMBER_OK) {
			*value *= twins[i].factor;
			found = &twins[i];
		}
	hawser__units_clear(&units);
	return found;
}

/* A unit without what may stand between its parts, into letters [size]. */
static void letters_of(char *letters, size_t size, const char *text)
{
	size_t n = 0;

	for (; *text && n + 1 < size; text++)
		if (!strchr(" .*^", *text))
			letters[n++] = *text;
	letters[n] = '\0';
}

/* The unit that converts to `to` and is the nearest to `text` in spelling, or differs in small and
 * capital letters and in signs of products and powers alone; or NULL. */
static const char *nearly(const char *text, const char *to)
{
	static const char *const unit[] = {
		"N", "kN", "MN", "Pa", "kPa", "MPa", "GPa", "Hz", "kHz", "rad/s", "m", "mm", "km", "kg",
		"g", "s", "min", "m/s", "km/h", "N/m", "kN/m", "kg/m", "N.m", "kN.m", "N.m^2", "kN.m^2",
		"N.s/m", "kN.s/m", "degree", "rad", "degree/s", "degC", "K", "meter", "newton",
		"kilonewton", "meganewton", "kilogram", "tonne", "hertz",
	};
	const char *meant = NULL;
	int least = hawser__edit_limit(strlen(text)) + 1;
	char letters[HAWSER__SHOWN];
	struct hawser__units units = {NULL};

	letters_of(letters, sizeof letters, text);
	for (size_t i = 0; i < sizeof unit/sizeof *unit; i++) {
		char one[16], own[16];
		double ignored;
		int far;

		snprintf(one, sizeof one, "1 %s", unit[i]);
		letters_of(own, sizeof own, unit[i]);
		far = strcasecmp(letters, own) == 0 ? 0 : hawser__edit_distance(letters, own);
		if (far < least &&
		    hawser__units_read(&units, &ignored, one, to) == HAWSER__NUMBER_OK) {
			meant = unit[i];
			least = far;
		}
	}
	hawser__units_clear(&units);
	return meant;
}

/* What stands behind a number in place of a unit and belongs to the number, or NULL. */
static const char *misplaced(const char *shown)
{
	if ((*shown == 'e' || *shown == 'E') && strspn(shown + 1, "+-0123456789"))
		return "has a blank before its exponent: write 1.5e8";
	if (*shown && strchr(",'_0123456789", *shown) && shown[strspn(shown, "0123456789")] != '/')
		return "has something between its digits: a number has a decimal point, and nothing that "
		       "separates thousands";
	return NULL;
}

/* What is not a unit. */
static void no_unit(char *sentence, size_t size, const char *shown, const char *to, const char *how)
{
	const char *meant = nearly(shown, to);

	snprintf(sentence, size, "has an unknown unit \"%s\": %s%s%s%s", shown,
	         meant ? "did you mean " : "", meant ? meant : "", meant ? "? " : "", how);
}

void hawser__units_explain(char *sentence, size_t size, enum hawser__number failure,
                           const char *text, const char *unit)
{
	char how[128], shown[HAWSER__SHOWN];
	const struct twin *twin;
	double value;

	advice(how, sizeof how, unit);
	hawser__shown(shown, failure == HAWSER__NUMBER_SYNTAX ? text : hawser__units_behind(text));
	if ((failure == HAWSER__NUMBER_UNKNOWN || failure == HAWSER__NUMBER_DIMENSION) &&
	    misplaced(shown)) {
		snprintf(sentence, size, "%s", misplaced(shown));
		return;
	}
	switch (failure) {
	case HAWSER__NUMBER_NAN:
		snprintf(sentence, size, "is not a number (NaN): %s", how);
		break;
	case HAWSER__NUMBER_OVERFLOW:
		snprintf(sentence, size, "is beyond double precision: %s", how);
		break;
	case HAWSER__NUMBER_UNKNOWN:
		no_unit(sentence, size, shown, unit, how);
		break;
	case HAWSER__NUMBER_DIMENSION:
		twin = twin_of(&value, text, unit);
		if (twin) {
			char is[96];

			snprintf(is, sizeof is, twin->is, shown);
			snprintf(sentence, size, "is %s; %s is wanted: under standard gravity it belongs to "
			         "\"%.8g %s\", or \"%.8g %s\"", is, twin->a, value, twin->wanted,
			         value/twin->of_other, twin->other);
			break;
		}
		snprintf(sentence, size,
		         "has a wrong unit \"%s\", not convertible to %s: %s", shown,
		         strcmp(unit, "1") ? unit : "a pure number", how);
		break;
	case HAWSER__NUMBER_DATABASE:
		snprintf(sentence, size,
		         "needs the unit database of udunits2, which can't be read: "
		                         "install it (Debian package libudunits2-data), or write "
		                         "plain numbers in SI units");
		break;
	case HAWSER__NUMBER_SYNTAX:
	case HAWSER__NUMBER_OK:
		snprintf(sentence, size, "is not a number: %s%s", strcasecmp(text + strspn(text, " "), "inf")
		         ? "" : "did you mean .inf? ", how);
		break;
	}
}
