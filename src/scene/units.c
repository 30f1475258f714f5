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
#include <ctype.h>
#include <math.h>
#include <pthread.h>
#include <stdlib.h>
#include <string.h>
#include <udunits2.h>

#include <hawser/scene.h>
#include "core/locale.h"
#include "core/report.h"
#include "scene/reader.h"

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

/* Define "deg", which udunits2 has as "degree" and with its sign alone. */
static int add_deg(ut_system *system)
{
	ut_unit *degree = ut_parse(system, "degree", UT_ASCII);
	int done = degree && ut_map_symbol_to_unit("deg", UT_ASCII, degree) == UT_SUCCESS;

	ut_free(degree);
	return done;
}

static int load(struct hawser__units *units)
{
	if (units->system)
		return 1;
	units->system = ut_read_xml(NULL);
	if (units->system && turn_hertz(units->system) && add_deg(units->system))
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

const char *hawser__units_behind(const char *text)
{
	const char *rest = text;
	double ignored;

	(void)number(&ignored, &rest, skip(text));
	return skip(rest);
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
