/* output/fields/units.c - units chosen by the user for tables and pictures. See units.h.
 *
 * Comments are sentences whose numbers are followed by their unit, so that they are converted as
 * text, in one place, and no comment can be forgotten. A number is converted with the unit that
 * follows it or, in a list or a range, that follows the last number of it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include <hawser/scene.h>
#include "output/output.h"

/* A dimension: other spellings of its SI unit, and how it follows from a length and a frequency. */
enum { LENGTH, FREQUENCY, SPELLINGS = 4 };
static const struct {
	const char *name, *si, *also[SPELLINGS];
	int length, frequency; /* powers of chosen units */
	const char *rest;      /* what remains of the unit behind these: "/s" */
} dimensions[] = {
	[LENGTH] = {.name = "length", .si = "m"},
	[FREQUENCY] = {.name = "frequency", .si = "rad/s", .also = {"Hz"}},
	{.name = "force", .si = "N"},
	{.name = "time", .si = "s"},
	{.name = "speed", .si = "m/s", .length = 1, .rest = "/s"},
	{.name = "acceleration", .si = "m/s^2", .also = {"m/s²"}, .length = 1, .rest = "/s^2"},
	{.name = "rate", .si = "1/s", .also = {"per_s"}},
	{.name = "angle", .si = "rad"},
	{.name = "mass", .si = "kg"},
	{.name = "mass per length", .si = "kg/m"},
	{.name = "force per length or stiffness", .si = "N/m"},
	{.name = "moment or energy", .si = "J", .also = {"N.m", "N m"}},
	{.name = "bending stiffness", .si = "N.m^2", .also = {"N m²", "N m^2"}},
	{.name = "damper", .si = "N.s/m", .also = {"N s/m"}},
	{.name = "damping per length", .si = "kg/m/s", .also = {"kg/(m s)"}},
	{.name = "temperature", .si = "K"},
	{.name = "thermal expansion", .si = "1/K"},
	{.name = "curvature", .si = "1/m", .length = -1},
	{.name = "frequency per amplitude squared", .si = "rad/s/m^2", .length = -2, .frequency = 1},
};
enum { DIMENSIONS = sizeof dimensions/sizeof *dimensions };

static struct {
	char unit[DIMENSIONS][HAWSER__UNIT_SIZE]; /* "": not chosen */
	double size[DIMENSIONS];                  /* in the SI unit */
	int used[DIMENSIONS], any;
} chosen;

/* --- the choice --- */

static enum hawser_status not_shown(const char *unit, struct hawser_report *report)
{
	char base[128], possible[640] = "";
	size_t used = 0;
	enum hawser_status status = hawser_unit_base(base, sizeof base, unit, report);

	if (status)
		return hawser__fail(report, status, "units", "--units: \"%s\" is no unit; write a list such as "
		                    "\"kN, ft, Hz\"", unit);
	for (int d = 0; d < DIMENSIONS; d++)
		used += (size_t)snprintf(possible + used, sizeof possible - used, "%s%s (%s)", d ? ", " : "",
		                         dimensions[d].name, dimensions[d].si);
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, "units",
	                    "--units: \"%s\" has the dimension of %s, and no result has that; possible "
	                    "are units of %s", unit, base, possible);
}

static enum hawser_status choose(const char *unit, struct hawser_report *report)
{
	char one[HAWSER__UNIT_SIZE + 4];
	int d = 0;

	snprintf(one, sizeof one, "1 %s", unit);
	while (d < DIMENSIONS &&
	       hawser_unit_parse(&chosen.size[d], one, dimensions[d].si, NULL) != HAWSER_OK)
		d++;
	if (d == DIMENSIONS)
		return not_shown(unit, report);
	if (*chosen.unit[d])
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "units",
		                    "--units: \"%s\" and \"%s\" are both units of %s; write one of them",
		                    chosen.unit[d], unit, dimensions[d].name);
	snprintf(chosen.unit[d], sizeof chosen.unit[d], "%s", unit);
	chosen.any = 1;
	return HAWSER_OK;
}

enum hawser_status hawser__units_choose(const char *list, struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	memset(&chosen, 0, sizeof chosen);
	while (list && !status) {
		char unit[HAWSER__UNIT_SIZE];
		size_t length = strcspn(list, ","), blank = strspn(list, " \t"), end = length;

		while (end > blank && isspace((unsigned char)list[end - 1]))
			end--;
		if (end <= blank || end - blank >= sizeof unit)
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "units", end <= blank
			                    ? "--units: a unit is empty; write a list such as \"kN, ft, Hz\""
			                    : "--units: a unit is too long; write a list such as \"kN, ft, Hz\"");
		snprintf(unit, sizeof unit, "%.*s", (int)(end - blank), list + blank);
		status = choose(unit, report);
		list = list[length] ? list + length + 1 : NULL;
	}
	return status;
}

/* --- what is shown instead of a unit --- */

static int is_spelling(int d, const char *si)
{
	for (int k = 0; k < SPELLINGS && dimensions[d].also[k]; k++)
		if (strcmp(dimensions[d].also[k], si) == 0)
			return 1;
	return strcmp(dimensions[d].si, si) == 0;
}

/* "/ft^2", "ft": a chosen unit to a power; "" for the power 0. */
static void factor_name(char *text, size_t size, const char *unit, int power)
{
	int compound = strpbrk(unit, "/. ") != NULL;
	const char *open = compound ? "(" : "", *close = compound ? ")" : "";

	if (power == 0)
		*text = '\0';
	else if (abs(power) == 1)
		snprintf(text, size, "%s%s%s%s", power < 0 ? "/" : "", open, unit, close);
	else
		snprintf(text, size, "%s%s%s%s^%d", power < 0 ? "/" : "", open, unit, close, abs(power));
}

/* A unit that follows from a chosen length or frequency. */
static void combine(struct hawser__shown_unit *shown, int d)
{
	int length = *chosen.unit[LENGTH] ? dimensions[d].length : 0;
	int frequency = *chosen.unit[FREQUENCY] ? dimensions[d].frequency : 0;
	const char *rest = dimensions[d].rest;
	char of_length[HAWSER__UNIT_SIZE + 8], first[HAWSER__UNIT_SIZE + 8];
	char name[3*HAWSER__UNIT_SIZE];

	if (length == 0 && frequency == 0)
		return;
	factor_name(of_length, sizeof of_length, *chosen.unit[LENGTH] ? chosen.unit[LENGTH] : "m",
	            dimensions[d].length);
	factor_name(first, sizeof first, frequency ? chosen.unit[FREQUENCY] : "rad/s",
	            dimensions[d].frequency ? 1 : 0);
	if (strchr(first, '(')) /* "rad/s" needs none in front of a quotient */
		snprintf(first, sizeof first, "%s", frequency ? chosen.unit[FREQUENCY] : "rad/s");
	snprintf(name, sizeof name, "%s%s%s", *first || *of_length != '/' ? first : "1", of_length,
	         rest ? rest : "");
	if (strlen(name) >= sizeof shown->name) /* too long a name to be of use */
		return;
	memcpy(shown->name, name, strlen(name) + 1);
	shown->per = (length ? pow(chosen.size[LENGTH], length) : 1.0)*
	             (frequency ? pow(chosen.size[FREQUENCY], frequency) : 1.0);
	shown->changed = 1;
	chosen.used[LENGTH] |= length != 0;
	chosen.used[FREQUENCY] |= frequency != 0;
}

struct hawser__shown_unit hawser__shown_unit(const char *si)
{
	static const double two_pi = 6.283185307179586476925;
	struct hawser__shown_unit shown = {.per = 1.0};
	int d = 0;

	snprintf(shown.name, sizeof shown.name, "%s", si);
	if (!chosen.any || !*si)
		return shown;
	while (d < DIMENSIONS && !is_spelling(d, si))
		d++;
	if (d == DIMENSIONS)
		return shown;
	if (!*chosen.unit[d]) {
		combine(&shown, d);
		return shown;
	}
	chosen.used[d] = 1;
	snprintf(shown.name, sizeof shown.name, "%s", chosen.unit[d]);
	shown.per = chosen.size[d]/(strcmp(si, "Hz") == 0 ? two_pi : 1.0);
	shown.changed = strcmp(shown.name, si) != 0;
	shown.chosen = 1;
	if (!shown.changed)
		shown.per = 1.0;
	return shown;
}

/* --- names of columns --- */

void hawser__unit_end(char *text, size_t size, const char *unit)
{
	size_t used = 0;

	if (*unit && size > 1)
		text[used++] = '_';
	for (; *unit && used + 1 < size; unit++)
		if (*unit == '/' || *unit == ' ')
			text[used++] = '_';
		else if (!strchr("^.*()", *unit))
			text[used++] = *unit;
	text[used] = '\0';
}

static int cut(char *column, const char *end)
{
	size_t length = strlen(column), tail = strlen(end);

	if (length <= tail || strcmp(column + length - tail, end) != 0)
		return 0;
	column[length - tail] = '\0';
	return 1;
}

void hawser__unit_cut(char *column, const char *si)
{
	char end[HAWSER__UNIT_SIZE];
	size_t k;

	snprintf(end, sizeof end, "_%s", si);
	if (cut(column, end))
		return;
	for (k = 1; end[k]; k++)
		if (!isalnum((unsigned char)end[k]))
			end[k] = '_';
	if (cut(column, end))
		return;
	hawser__unit_end(end, sizeof end, si);
	if (!cut(column, end) && strncmp(si, "1/", 2) == 0) {
		snprintf(end, sizeof end, "_per_%s", si + 2);
		(void)cut(column, end);
	}
}

void hawser__units_elsewhere(void)
{
	for (int d = 0; d < DIMENSIONS; d++)
		chosen.used[d] = 1;
}

/* --- comments --- */

/* Length of a number at the beginning of the text, and the digits that it has; 0 if there is none. */
static size_t number_at(const char *text, int *digits)
{
	const char *p = text + (*text == '-' || *text == '+');
	int leading = 1;

	*digits = 0;
	if (!isdigit((unsigned char)*p))
		return 0;
	for (; isdigit((unsigned char)*p) || (*p == '.' && isdigit((unsigned char)p[1])); p++) {
		leading = leading && (*p == '0' || *p == '.');
		*digits += !leading && *p != '.';
	}
	if (*p == 'e' && (isdigit((unsigned char)p[1]) ||
	                  (strchr("+-", p[1]) && isdigit((unsigned char)p[2])))) {
		p += 2;
		p += strspn(p, "0123456789");
	}
	return isalnum((unsigned char)*p) || *p == '_' ? 0 : (size_t)(p - text);
}

/* The longest SI unit at the beginning of the text, as one of its spellings, or NULL. */
static const char *unit_at(const char *text)
{
	const char *best = NULL;

	for (int d = 0; d < DIMENSIONS; d++)
		for (int k = -1; k < SPELLINGS; k++) {
			const char *si = k < 0 ? dimensions[d].si : dimensions[d].also[k];
			size_t length = si ? strlen(si) : 0;
			unsigned char after = length && strncmp(text, si, length) == 0
			                      ? (unsigned char)text[length] : 'x';

			if (!isalnum(after) && !strchr("_/^*=", after ? after : ' ') && after < 0x80 &&
			    !(after == '.' && isalnum((unsigned char)text[length + 1])) &&
			    (!best || length > strlen(best)))
				best = si;
		}
	return best;
}

/* The words between numbers that share the unit behind the last of them. */
static const char *joined(const char *text)
{
	static const char *const words[] = {" to ", " and ", ", ", " or "};

	for (size_t k = 0; k < sizeof words/sizeof *words; k++)
		if (strncmp(text, words[k], strlen(words[k])) == 0)
			return text + strlen(words[k]);
	return NULL;
}

/* The unit of the number before this text, or NULL. */
static const char *unit_of(const char *text)
{
	for (;;) {
		const char *unit = *text == ' ' ? unit_at(text + 1) : NULL, *next = joined(text);
		size_t length;
		int digits;

		if (unit || !next)
			return unit;
		length = number_at(next, &digits);
		if (length == 0)
			return NULL;
		text = next + length;
	}
}

static void convert(FILE *stream, const char *text)
{
	char before = ' ';

	while (*text) {
		int digits;
		size_t length = isalnum((unsigned char)before) || strchr("._^", before)
		                ? 0 : number_at(text, &digits);
		const char *si = length ? unit_of(text + length) : NULL;
		struct hawser__shown_unit shown = hawser__shown_unit(si ? si : "");

		if (shown.changed) {
			fprintf(stream, "%.*g", (int)fmin(fmax(digits + 1, 6), 17),
			        strtod(text, NULL)/shown.per);
			text += length;
			if (*text == ' ' && unit_at(text + 1) == si) {
				fprintf(stream, " %s", shown.name);
				text += 1 + strlen(si);
			}
			before = '0';
			continue;
		}
		length = length ? length : 1;
		fprintf(stream, "%.*s", (int)length, text);
		text += length;
		before = text[-1];
	}
}

char *hawser__units_text(const char *text)
{
	char *made = NULL;
	size_t size = 0;
	FILE *stream;

	if (!chosen.any)
		return strdup(text);
	stream = open_memstream(&made, &size);
	if (!stream)
		return NULL;
	convert(stream, text);
	if (fclose(stream) == 0)
		return made;
	free(made);
	return NULL;
}

void hawser__units_comments(struct hawser__table *table)
{
	char list[DIMENSIONS*(HAWSER__UNIT_SIZE + 2)] = "";
	size_t used = 0;

	if (!chosen.any)
		return;
	for (int d = 0; d < DIMENSIONS; d++)
		if (*chosen.unit[d])
			used += (size_t)snprintf(list + used, sizeof list - used, "%s%s", used ? ", " : "",
			                         chosen.unit[d]);
	hawser__table_remark(table, "units: %s, where something has their dimension; SI elsewhere", list);
	for (int d = 0; d < DIMENSIONS; d++)
		if (*chosen.unit[d] && !chosen.used[d])
			hawser__table_remark(table, "note: --units %s: nothing in this table is a %s",
			                     chosen.unit[d], dimensions[d].name);
}
