/* output/fields/units.c - units chosen by the user for tables and pictures. See units.h.
 *
 * Comments are sentences whose numbers are followed by their unit, so that they are converted as
 * text, in one place, and no comment can be forgotten. A number is converted with the unit that
 * follows it or, in a list or a range, that follows the last number of it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/append.h"
#include "core/report.h"
#include <hawser/scene.h>
#include "output/output.h"

/* A dimension: its SI unit, other spellings of that, and a name of its own that the unit has. Units of
 * compounds follow from chosen ones of their parts, the first four. */
enum { LENGTH, FREQUENCY, FORCE, MASS, PARTS, SPELLINGS = 2 };
static const struct {
	const char *name, *si, *also[SPELLINGS], *own;
} dimensions[] = {
	[LENGTH] = {.name = "length", .si = "m"},
	[FREQUENCY] = {.name = "frequency", .si = "rad/s", .also = {"Hz"}},
	[FORCE] = {.name = "force", .si = "N"},
	[MASS] = {.name = "mass", .si = "kg"},
	{.name = "time", .si = "s"},
	{.name = "speed", .si = "m/s"},
	{.name = "acceleration", .si = "m/s^2", .also = {"m/s²"}},
	{.name = "jerk", .si = "m/s^3"},
	{.name = "snap", .si = "m/s^4"},
	{.name = "rate", .si = "1/s", .also = {"per_s"}},
	{.name = "angle", .si = "rad"},
	{.name = "mass per length", .si = "kg/m"},
	{.name = "force per length or stiffness", .si = "N/m"},
	{.name = "moment or energy", .si = "N.m", .also = {"N m"}, .own = "J"},
	{.name = "moment per displacement", .si = "N.m/m"},
	{.name = "power", .si = "N.m/s", .own = "W"},
	{.name = "density", .si = "kg/m^3"},
	{.name = "drag", .si = "kg/m^2"},
	{.name = "impulse", .si = "N.s", .also = {"N s"}},
	{.name = "angular momentum", .si = "N.m.s", .also = {"N m s"}},
	{.name = "bending stiffness", .si = "N.m^2", .also = {"N m²", "N m^2"}},
	{.name = "damper", .si = "N.s/m", .also = {"N s/m"}},
	{.name = "damping per length", .si = "kg/m/s", .also = {"kg/(m s)"}},
	{.name = "temperature", .si = "K"},
	{.name = "thermal expansion", .si = "1/K"},
	{.name = "curvature", .si = "1/m"},
	{.name = "frequency per amplitude squared", .si = "rad/s/m^2"},
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
	char base[128], possible[320] = "";
	enum hawser_status status = hawser_unit_base(base, sizeof base, unit, report);

	if (status)
		return hawser__fail(report, status, "units", "--units: \"%s\" is no unit; write a list such as "
		                    "\"kN, ft, Hz\"", unit);
	for (int d = 0; d < DIMENSIONS; d++)
		hawser__append(possible, sizeof possible, ", ", "%s", dimensions[d].si);
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, "units",
	                    "--units: \"%s\" has the dimension of %s, and no result has that; possible "
	                    "are those of %s", unit, base, possible);
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

/* Spelling k of the SI unit, from 0; NULL: no such one. */
static const char *spelling(int d, int k)
{
	return k == 0 ? dimensions[d].si : k == 1 ? dimensions[d].own : dimensions[d].also[k - 2];
}

static int is_spelling(int d, const char *si)
{
	for (int k = 0; k < SPELLINGS + 2; k++)
		if (spelling(d, k) && strcmp(spelling(d, k), si) == 0)
			return 1;
	return 0;
}

/* The dimension of the part of a unit with which the text begins, or -1; its `length`. */
static int part_at(const char *text, size_t *length)
{
	for (int d = FREQUENCY; d < PARTS; d = d == FREQUENCY ? LENGTH : d == LENGTH ? FORCE : d + 1) {
		*length = strlen(dimensions[d].si);
		if (strncmp(text, dimensions[d].si, *length) == 0 && strchr("./^", text[*length]))
			return d;
	}
	*length = strcspn(text, "./^");
	return -1;
}

/* The unit with chosen units in place of its parts: "kN.ft" for N.m. A unit with a name of its own
 * is left if one of its parts is. */
static void combine(struct hawser__shown_unit *shown, const char *si, int own)
{
	char name[4*HAWSER__UNIT_SIZE];
	int taken[PARTS] = {0}, left = 0, any = 0, sign = 1;
	size_t used = 0, length;
	double per = 1.0;

	for (; *si && used + HAWSER__UNIT_SIZE + 8 < sizeof name; si += length) {
		int part = part_at(si, &length), swap = part >= 0 && *chosen.unit[part];
		const char *text = swap ? chosen.unit[part] : si, *after = si + length;
		int open = swap && strpbrk(text, "/. ") && (used > 0 || (*after && *after != '/'));
		int power = *after == '^' ? (int)strtol(after + 1, NULL, 10) : 1;

		used += (size_t)snprintf(name + used, sizeof name - used, open ? "(%.*s)" : "%.*s",
		                         swap ? HAWSER__UNIT_SIZE : (int)length, text);
		length += strcspn(after, "./");
		length += si[length] != '\0';
		used += (size_t)snprintf(name + used, sizeof name - used, "%.*s",
		                         (int)(si + length - after), after);
		left |= part >= 0 && !swap;
		any |= swap;
		if (swap) {
			taken[part] = 1;
			per *= pow(chosen.size[part], sign*power);
		}
		sign = si[length - 1] == '/' ? -1 : 1;
	}
	if (!any || (own && left) || used >= sizeof shown->name) /* too long a name is of no use */
		return;
	memcpy(shown->name, name, used + 1);
	shown->per = per;
	shown->changed = 1;
	for (int part = 0; part < PARTS; part++)
		chosen.used[part] |= taken[part];
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
	if (d == DIMENSIONS || !*chosen.unit[d]) {
		combine(&shown, d < DIMENSIONS ? dimensions[d].si : si,
		        d < DIMENSIONS && dimensions[d].own && strcmp(dimensions[d].own, si) == 0);
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
		for (int k = 0; k < SPELLINGS + 2; k++) {
			const char *si = spelling(d, k);
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

/* The unit of the number, or of the list in brackets, that ends before this text, or NULL; `blank`:
 * the place of the blank before it. */
static const char *unit_behind(const char *text, size_t *blank)
{
	*blank = strspn(text, ")]");
	return text[*blank] == ' ' ? unit_at(text + *blank + 1) : NULL;
}

/* The unit of the number before this text, or NULL. */
static const char *unit_of(const char *text)
{
	size_t blank;

	for (;;) {
		const char *unit = unit_behind(text, &blank), *next = joined(text);
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
		size_t blank, length = isalnum((unsigned char)before) || strchr("._^", before)
		                ? 0 : number_at(text, &digits);
		const char *si = length ? unit_of(text + length) : NULL;
		struct hawser__shown_unit shown = hawser__shown_unit(si ? si : "");

		if (shown.changed) {
			fprintf(stream, "%.*g", (int)fmin(fmax(digits + 1, 6), 17),
			        strtod(text, NULL)/shown.per);
			text += length;
			if (unit_behind(text, &blank) == si) {
				fprintf(stream, "%.*s %s", (int)blank, text, shown.name);
				text += blank + 1 + strlen(si);
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

	if (!chosen.any)
		return;
	for (int d = 0; d < DIMENSIONS; d++)
		if (*chosen.unit[d])
			hawser__append(list, sizeof list, ", ", "%s", chosen.unit[d]);
	hawser__table_remark(table, "units: %s, where something has their dimension; SI elsewhere", list);
	for (int d = 0; d < DIMENSIONS; d++)
		if (*chosen.unit[d] && !chosen.used[d])
			hawser__table_remark(table, "note: --units %s: nothing in this table is a %s",
			                     chosen.unit[d], dimensions[d].name);
}
