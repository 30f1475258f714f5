/* scene/units.c - numbers with units, through udunits2 but for the common ones (units_common.c).
 *
 * udunits2 stores its parser's state, its status and its message handler in global variables. All
 * calls of it here are protected by one lock, and its handler is restored afterwards; the unit
 * system belongs to the caller. A program that calls udunits2 itself must not do so while a scene
 * is read.
 *
 * Two conventions of udunits2 are changed. It defines the hertz as 1/s, so that 1 Hz would be 1
 * rad/s: here 1 Hz is 2 pi rad/s. It converts between units with and without an angle: here rad/s
 * does not convert to 1/s. Offsets ("m @ 3"), logarithms and factors in a unit ("N 5") are
 * rejected.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <ctype.h>
#include <math.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <udunits2.h>

#include <hawser/scene.h>
#include "core/locale.h"
#include "core/report.h"
#include "scene/units.h"

static pthread_mutex_t gate = PTHREAD_MUTEX_INITIALIZER;

static const double two_pi = 6.283185307179586476925;

/* Between enter() and leave() no other thread of this library calls udunits2, udunits2 prints no
 * message, and the locale has a decimal point. */
struct entry {
	ut_error_message_handler handler;
	struct hawser__locale locale;
};

static void enter(struct entry *entry)
{
	pthread_mutex_lock(&gate);
	entry->handler = ut_set_error_message_handler(ut_ignore);
	hawser__locale_begin(&entry->locale);
}

static void leave(struct entry *entry)
{
	hawser__locale_end(&entry->locale);
	ut_set_error_message_handler(entry->handler);
	pthread_mutex_unlock(&gate);
}

/* Define "Hz" and "hertz" as 2 pi rad/s. */
static int turn_hertz(ut_system *system)
{
	ut_unit *angular = ut_parse(system, "rad/s", UT_ASCII);
	ut_unit *hertz = angular ? ut_scale(two_pi, angular) : NULL;
	int done = 0;

	if (hertz && ut_unmap_symbol_to_unit(system, "Hz", UT_ASCII) == UT_SUCCESS &&
	    ut_unmap_name_to_unit(system, "hertz", UT_ASCII) == UT_SUCCESS)
		done = ut_map_symbol_to_unit("Hz", UT_ASCII, hertz) == UT_SUCCESS &&
		       ut_map_name_to_unit("hertz", UT_ASCII, hertz) == UT_SUCCESS;
	ut_free(hertz);
	ut_free(angular);
	return done;
}

static int load(struct hawser__units *units)
{
	if (units->system)
		return 1;
	units->system = ut_read_xml(NULL);
	if (units->system && turn_hertz(units->system))
		return 1;
	if (units->system)
		ut_free_system(units->system);
	units->system = NULL;
	return 0;
}

static int has_angle(const ut_unit *unit)
{
	char text[256];

	return ut_format(unit, text, sizeof text, UT_ASCII | UT_DEFINITION) > 0 &&
	       strstr(text, "rad");
}

/* 1 if a unit consists of letters and exponents. A digit anywhere else is a second number ("N 5",
 * "000 N"), which udunits2 would accept as a factor; "1/s" is the exception. udunits2 also accepts
 * an unmatched closing bracket, which is rejected here. */
static int is_plain(const char *text)
{
	const char *p = text;
	int open = 0;

	if (p[0] == '1' && p[1] == '/')
		p++;
	for (char before = ' ', last = ' '; *p; last = before, before = *p++) {
		int sign = (*p == '-' || *p == '+') && isdigit((unsigned char)p[1]);
		int power = before == '^' || (before == '*' && last == '*');

		open += (*p == '(') - (*p == ')');
		if (open < 0)
			return 0;
		if ((isdigit((unsigned char)*p) || sign) && !power &&
		    !isalnum((unsigned char)before) && !(strchr("-+", before) && p > text + 1))
			return 0;
	}
	return open == 0;
}

/* Factor of a unit that is a multiple of another one; NaN if it is not. */
static double factor_of(ut_unit *from, ut_unit *to)
{
	cv_converter *converter = ut_get_converter(from, to);
	double factor = NAN;

	if (!converter)
		return NAN;
	if (cv_convert_double(converter, 0.0) == 0.0 &&
	    cv_convert_double(converter, 2.0) == 2.0*cv_convert_double(converter, 1.0))
		factor = cv_convert_double(converter, 1.0);
	cv_free(converter);
	return factor;
}

static enum hawser__number convert(struct hawser__units *units, double *value, const char *from,
                                   const char *to)
{
	enum hawser__number answer = HAWSER__NUMBER_DATABASE;
	const double common = hawser__units_common(from, to);
	ut_unit *written = NULL, *wanted = NULL;
	cv_converter *converter = NULL;

	if (common > 0.0) {
		*value *= common;
		return HAWSER__NUMBER_OK;
	}
	if (!load(units))
		return answer;
	answer = HAWSER__NUMBER_UNKNOWN;
	wanted = ut_parse(units->system, to, UT_ASCII);
	written = is_plain(from) ? ut_parse(units->system, from, UT_UTF8) : NULL;
	if (!wanted || !written)
		goto done;
	answer = HAWSER__NUMBER_DIMENSION;
	if (!ut_are_convertible(written, wanted) || has_angle(written) != has_angle(wanted) ||
	    isnan(factor_of(written, wanted)))
		goto done;
	converter = ut_get_converter(written, wanted);
	if (!converter)
		goto done;
	*value = cv_convert_double(converter, *value);
	answer = HAWSER__NUMBER_OK;
done:
	if (converter)
		cv_free(converter);
	ut_free(written);
	ut_free(wanted);
	return answer;
}

/* Length of a decimal number at the start of text, 0 if there is none. strtod also accepts
 * hexadecimal numbers and "nan(...)". */
static size_t decimal(const char *text)
{
	const char *p = text + (*text == '+' || *text == '-');
	size_t whole = strspn(p, "0123456789"), part = 0;

	p += whole;
	if (*p == '.') {
		part = strspn(p + 1, "0123456789");
		p += 1 + part;
	}
	if (whole + part == 0)
		return 0;
	if (*p == 'e' || *p == 'E') {
		const char *q = p + 1 + (p[1] == '+' || p[1] == '-');
		size_t digits = strspn(q, "0123456789");

		if (digits)
			p = q + digits;
	}
	return (size_t)(p - text);
}

static const char *begins(const char *text, const char *const *words)
{
	for (; *words; words++)
		if (!strncmp(text, *words, strlen(*words)))
			return text + strlen(*words);
	return NULL;
}

/* Read the number before the unit; *rest is the text after it. */
static enum hawser__number number(double *value, const char **rest, const char *text)
{
	static const char *const nan_words[] = {".nan", ".NaN", ".NAN", "nan", "NaN", "NAN", NULL};
	static const char *const inf_words[] = {".inf", ".Inf", ".INF", NULL};
	size_t length = decimal(text);
	const char *sign = text + (*text == '+' || *text == '-');
	const char *after;
	char *end;

	if (length) {
		*rest = text + length;
		*value = strtod(text, &end);
		if (end != *rest)
			return HAWSER__NUMBER_SYNTAX;
		return isfinite(*value) ? HAWSER__NUMBER_OK : HAWSER__NUMBER_OVERFLOW;
	}
	after = begins(sign, nan_words);
	if (after && !isalnum((unsigned char)*after))
		return HAWSER__NUMBER_NAN;
	after = begins(sign, inf_words);
	if (!after || isalnum((unsigned char)*after))
		return HAWSER__NUMBER_SYNTAX;
	*value = *text == '-' ? -INFINITY : INFINITY;
	*rest = after;
	return HAWSER__NUMBER_OK;
}

static const char *skip(const char *text)
{
	while (isspace((unsigned char)*text))
		text++;
	return text;
}

enum { LONGEST = 127 };

/* Copy text without trailing blanks, "/K" as "1/K"; returns 0 if it is too long for a unit. */
static int trim(char own[LONGEST + 1], const char *text)
{
	size_t length = strlen(text), one = *text == '/';

	while (length && isspace((unsigned char)text[length - 1]))
		length--;
	if (one + length > LONGEST)
		return 0;
	own[0] = '1';
	memcpy(own + one, text, length);
	own[one + length] = '\0';
	return 1;
}

enum hawser__number hawser__units_read(struct hawser__units *units, double *value,
                                       const char *text, const char *unit)
{
	enum hawser__number answer;
	const char *rest = "";
	char own[LONGEST + 1];
	double result = 0.0;
	struct entry entry;
	int finite;

	text = skip(text);
	enter(&entry);
	answer = number(&result, &rest, text);
	finite = isfinite(result);
	if (answer == HAWSER__NUMBER_OK && *skip(rest))
		answer = trim(own, skip(rest)) ? convert(units, &result, own, unit)
		                               : HAWSER__NUMBER_UNKNOWN;
	if (answer == HAWSER__NUMBER_OK && finite && isinf(result))
		answer = HAWSER__NUMBER_OVERFLOW;
	leave(&entry);
	if (answer == HAWSER__NUMBER_OK && isnan(result))
		answer = HAWSER__NUMBER_NAN;
	if (answer == HAWSER__NUMBER_OK)
		*value = result;
	return answer;
}

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

/* A unit that converts to `to` and differs from `text` in small and capital letters, and in signs of
 * products and powers, alone, or NULL. */
static const char *nearly(const char *text, const char *to)
{
	static const char *const unit[] = {
		"N", "kN", "MN", "Pa", "kPa", "MPa", "GPa", "Hz", "kHz", "rad/s", "m", "mm", "km", "kg", "g",
		"s", "min", "m/s", "km/h", "N/m", "kN/m", "kg/m", "N.m", "kN.m", "N.m^2", "kN.m^2", "N.s/m",
		"kN.s/m", "deg", "rad", "degC", "K",
	};

	const char *meant = NULL;
	char letters[HAWSER__SHOWN];
	struct hawser__units units = {NULL};

	letters_of(letters, sizeof letters, text);
	for (size_t i = 0; i < sizeof unit/sizeof *unit; i++) {
		char one[16], own[16];
		double ignored;

		snprintf(one, sizeof one, "1 %s", unit[i]);
		letters_of(own, sizeof own, unit[i]);
		if (strcasecmp(letters, own) == 0 &&
		    hawser__units_read(&units, &ignored, one, to) == HAWSER__NUMBER_OK)
			meant = unit[i];
	}
	hawser__units_clear(&units);
	return meant;
}

/* What is not a unit. */
static void no_unit(char *sentence, size_t size, const char *shown, const char *to, const char *how)
{
	const char *meant = nearly(shown, to);

	if (*shown == ',')
		snprintf(sentence, size, "has a comma: a number has a decimal point");
	else
		snprintf(sentence, size, "has an unknown unit \"%s\": %s%s%s%s", shown,
		         meant ? "did you mean " : "", meant ? meant : "", meant ? "? " : "", how);
}

void hawser__units_explain(char *sentence, size_t size, enum hawser__number failure,
                           const char *text, const char *unit)
{
	char how[128], shown[HAWSER__SHOWN];
	const char *rest = text;
	const struct twin *twin;
	double ignored, value;

	if (failure != HAWSER__NUMBER_SYNTAX)
		(void)number(&ignored, &rest, skip(text));
	advice(how, sizeof how, unit);
	hawser__shown(shown, skip(rest));
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
		snprintf(sentence, size, "is not a number: %s%s", strcasecmp(skip(text), "inf")
		         ? "" : "did you mean .inf? ", how);
		break;
	}
}

enum hawser_status hawser_unit_parse(double *value, const char *text, const char *unit,
                                     struct hawser_report *report)
{
	struct hawser__units units = {NULL};
	enum hawser__number answer = hawser__units_read(&units, value, text, unit);
	char sentence[320], shown[HAWSER__SHOWN];

	hawser__units_clear(&units);
	if (answer == HAWSER__NUMBER_OK)
		return HAWSER_OK;
	hawser__units_explain(sentence, sizeof sentence, answer, text, unit);
	return hawser__fail(report, answer == HAWSER__NUMBER_DATABASE ? HAWSER_ERR_IO
	                                                              : HAWSER_ERR_ARGUMENT,
	                    "hawser_unit_parse", "\"%s\" %s", hawser__shown(shown, text), sentence);
}

/* 1: formatted, 0: no such unit, -1: no database. */
static int base_of(char *text, size_t size, struct hawser__units *units, const char *unit)
{
	char own[LONGEST + 1];
	ut_unit *parsed = NULL;
	int used = -1;

	if (!load(units))
		return -1;
	if (trim(own, unit) && is_plain(own))
		parsed = ut_parse(units->system, own, UT_UTF8);
	if (parsed)
		used = ut_format(parsed, text, size, UT_ASCII | UT_DEFINITION);
	ut_free(parsed);
	return used > 0 && (size_t)used < size;
}

enum hawser_status hawser_unit_base(char *text, size_t size, const char *unit,
                                    struct hawser_report *report)
{
	struct hawser__units units = {NULL};
	char shown[HAWSER__SHOWN];
	struct entry entry;
	int found;

	enter(&entry);
	found = base_of(text, size, &units, skip(unit));
	leave(&entry);
	hawser__units_clear(&units);
	if (found > 0)
		return HAWSER_OK;
	if (size > 0)
		*text = '\0';
	return hawser__fail(report, found < 0 ? HAWSER_ERR_IO : HAWSER_ERR_ARGUMENT, "hawser_unit_base",
	                    found < 0 ? "\"%s\" needs the unit database of udunits2, which can't be read"
	                              : "\"%s\" is no unit", hawser__shown(shown, unit));
}

void hawser__units_clear(struct hawser__units *units)
{
	struct entry entry;

	if (!units->system)
		return;
	enter(&entry);
	ut_free_system(units->system);
	leave(&entry);
	units->system = NULL;
}
