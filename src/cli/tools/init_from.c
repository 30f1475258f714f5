/* cli/tools/init_from.c - read the file of a mooring: sections with a line of dashes and a name, tables
 * of points, lines and their types, and options as value and key.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "cli/frame/cli.h"
#include "cli/tools/init_from.h"
#include "core/file.h"
#include "core/grow.h"
#include "core/locale.h"
#include "core/report.h"

enum { WORDS = 24, LINE = 4096 };
static const char blank[] = " \t\r\n";

struct words {
	char *word[WORDS];
	int count;
};
struct section {
	const char *name, *other; /* in its heading, in capital letters; other: or this */
	int least;                /* columns; 0: it is left out, and named once */
	enum hawser_status (*row)(struct cli_mooring *mooring, const struct words *words,
	                          struct hawser_report *report);
};

static enum hawser_status wrong(struct hawser_report *report, const struct cli_mooring *mooring,
                                const char *format, ...) HAWSER_PRINTF(3, 4);
static enum hawser_status wrong(struct hawser_report *report, const struct cli_mooring *mooring,
                                const char *format, ...)
{
	char text[400];
	va_list args;

	va_start(args, format);
	vsnprintf(text, sizeof text, format, args);
	va_end(args);
	return hawser__fail(report, HAWSER_ERR_SCENE, "init", "%s:%d: %s",
	                    hawser__file_name(mooring->path), mooring->number, text);
}

static void left_out(const struct cli_mooring *mooring, const char *format, ...) HAWSER_PRINTF(2, 3);
static void left_out(const struct cli_mooring *mooring, const char *format, ...)
{
	char text[400], all[500];
	va_list args;

	va_start(args, format);
	vsnprintf(text, sizeof text, format, args);
	va_end(args);
	snprintf(all, sizeof all, "%s:%d: left out: %s", hawser__file_name(mooring->path),
	         mooring->number, text);
	cli_warn(all);
}

/* A finite number that is all of the word. */
static int number(double *value, const char *word)
{
	char *end;

	*value = strtod(word, &end);
	return *word && !*end && isfinite(*value);
}

/* Numbers from words `first` on; the message names the column. */
static enum hawser_status numbers(double *value, int count, const struct cli_mooring *mooring,
                                  const struct words *words, int first, struct hawser_report *report)
{
	for (int i = 0; i < count; i++)
		if (!number(&value[i], words->word[first + i]))
			return wrong(report, mooring, "column %d is '%s': a number is needed", first + i + 1,
			             words->word[first + i]);
	return HAWSER_OK;
}

static enum hawser_status identity(int *id, const struct cli_mooring *mooring,
                                   const struct words *words, struct hawser_report *report)
{
	char *end;
	long value = strtol(words->word[0], &end, 10);

	if (*end || value < 1 || value > 1000000)
		return wrong(report, mooring, "'%s': the number of a row is needed, 1 or more",
		             words->word[0]);
	*id = (int)value;
	return HAWSER_OK;
}

static enum hawser_status read_type(struct cli_mooring *mooring, const struct words *words,
                                    struct hawser_report *report)
{
	struct cli_mooring_type type = {.name = ""};
	double bending, value[4], lift;
	char *bar = strchr(words->word[3], '|'), *second = strchr(words->word[4], '|');
	enum hawser_status status;

	if (strlen(words->word[0]) >= sizeof type.name)
		return wrong(report, mooring, "the name '%s' has more than %d letters", words->word[0],
		             CLI_MOORING_NAME - 1);
	strcpy(type.name, words->word[0]);
	if (bar)
		*bar = '\0';
	if (second)
		*second = '\0';
	if (second && strcmp(second + 1, "0") != 0)
		left_out(mooring, "of the type %s, the damping after '|'", type.name);
	status = numbers(&type.diameter, 1, mooring, words, 1, report);
	if (!status)
		status = numbers(&type.mass, 1, mooring, words, 2, report);
	if (!status && !number(&type.EA, words->word[3]))
		return wrong(report, mooring, "EA is '%s': a table of another file is not read, a number is "
		             "needed", words->word[3]);
	if (!status)
		status = numbers(&type.BA, 1, mooring, words, 4, report);
	if (!status && bar &&
	    !(number(&type.dynamic, bar + 1) && type.dynamic > type.EA && type.BA > 0.0)) {
		left_out(mooring, "of the type %s, EA after '|', which needs a number above EA, and BA above 0",
		         type.name);
		type.dynamic = 0.0;
	}
	if (!status)
		status = numbers(&bending, 1, mooring, words, 5, report);
	if (!status)
		status = numbers(value, 4, mooring, words, 6, report);
	if (status)
		return status;
	if (!(type.diameter > 0.0 && type.mass > 0.0 && type.EA > 0.0))
		return wrong(report, mooring, "diameter, mass and EA of the type %s must be above 0",
		             type.name);
	if (bending != 0.0)
		left_out(mooring, "EI of the type %s: cables of nets carry tension alone", type.name);
	if (words->count > 10 && number(&lift, words->word[10]) && lift != 0.0)
		left_out(mooring, "Cl of the type %s, vibrations by vortices", type.name);
	type.normal = value[0];
	type.added_normal = value[1];
	type.tangential = value[2];
	type.added_tangential = value[3];
	if (hawser__more(&mooring->type, mooring->types, sizeof *mooring->type))
		return hawser__no_memory(report, "init");
	mooring->type[mooring->types++] = type;
	return HAWSER_OK;
}

/* One number, or three with | between them; `one`: what one number is of. */
static enum hawser_status three(double value[3], int one, const struct cli_mooring *mooring,
                                const char *word, struct hawser_report *report)
{
	char part[3][40];
	int count = sscanf(word, "%39[^|]|%39[^|]|%39[^|]", part[0], part[1], part[2]);

	for (int k = 0; k < 3; k++)
		if ((count != 1 && count != 3) || !number(&value[k], part[count == 3 ? k : 0]))
			return wrong(report, mooring, "'%s': a number is needed, or three with | between them",
			             word);
	for (int k = 0; k < 3 && count == 1; k++)
		value[k] = one < 0 || one == k ? value[k] : 0.0;
	return HAWSER_OK;
}

/* What a body that moves has besides its place. */
static enum hawser_status read_mass(struct cli_mooring_body *body, struct cli_mooring *mooring,
                                    const struct words *words, struct hawser_report *report)
{
	double area[3], added[3];
	enum hawser_status status = numbers(&body->mass, 1, mooring, words, 8, report);

	if (!status)
		status = three(body->centre, 2, mooring, words->word[9], report);
	if (!status)
		status = three(body->inertia, -1, mooring, words->word[10], report);
	if (!status)
		status = numbers(&body->volume, 1, mooring, words, 11, report);
	if (!status)
		status = three(area, -1, mooring, words->word[12], report);
	if (!status)
		status = three(added, -1, mooring, words->word[13], report);
	if (status)
		return status;
	body->moves = body->mass > 0.0;
	body->CdA = area[0];
	body->added = added[0];
	if (!body->moves) {
		left_out(mooring, "the motion of body %d, which has no mass: its points are supports where "
		         "they are; give it a mass, or write it, with its rods, as one of bodies", body->id);
		return HAWSER_OK;
	}
	left_out(mooring, "of body %d, the form of what displaces water: it is a sphere at its place, with "
	         "the drag and the added mass along the first axis", body->id);
	return HAWSER_OK;
}

static enum hawser_status read_body(struct cli_mooring *mooring, const struct words *words,
                                    struct hawser_report *report)
{
	struct cli_mooring_body body = {.id = 0};
	int free = !strcasecmp(words->word[1], "free") && words->count > 13;
	double angle[3];
	enum hawser_status status = identity(&body.id, mooring, words, report);

	if (!status)
		status = numbers(body.x, 3, mooring, words, 2, report);
	if (!status)
		status = numbers(angle, 3, mooring, words, 5, report);
	if (status)
		return status;
	if (angle[0] != 0.0 || angle[1] != 0.0 || angle[2] != 0.0)
		return wrong(report, mooring, "body %d is turned: give the places of its points as they are, "
		             "and angles of 0", body.id);
	if (free)
		status = read_mass(&body, mooring, words, report);
	if (status)
		return status;
	if (!free && strcasecmp(words->word[1], "fixed") != 0)
		left_out(mooring, "the motion of body %d: its points are supports where they are, to which "
		         "supports.*.motion can be given", body.id);
	if (hawser__more(&mooring->body, mooring->bodies, sizeof *mooring->body))
		return hawser__no_memory(report, "init");
	mooring->body[mooring->bodies++] = body;
	return HAWSER_OK;
}

/* What a point is attached to. */
static enum hawser_status attach(struct cli_mooring_point *point, const struct cli_mooring *mooring,
                                 const char *word, struct hawser_report *report)
{
	static const char *const held[] = {"fixed", "fix", "anchor", "coupled", "vessel", "ves", "cpld"};
	static const char *const loose[] = {"free", "connect", "con", "point"};

	for (size_t i = 0; i < sizeof held/sizeof *held; i++)
		if (!strcasecmp(word, held[i]))
			point->held = 1;
	for (size_t i = 0; i < sizeof loose/sizeof *loose && !point->held; i++)
		if (!strcasecmp(word, loose[i]))
			return HAWSER_OK;
	if (point->held)
		return HAWSER_OK;
	for (int i = 0; i < mooring->bodies && !strncasecmp(word, "body", 4); i++)
		if (mooring->body[i].id == strtol(word + 4, NULL, 10)) {
			for (int k = 0; k < 3; k++)
				point->x[k] += mooring->body[i].x[k];
			point->held = !mooring->body[i].moves;
			point->body = mooring->body[i].moves ? i + 1 : 0;
			return HAWSER_OK;
		}
	return wrong(report, mooring, "point %d is attached to '%s', which is not one of fixed, coupled, "
	             "free and a body that the file has", point->id, word);
}

static int point_of(const struct cli_mooring *mooring, int id)
{
	for (int i = 0; i < mooring->points; i++)
		if (mooring->point[i].id == id)
			return i;
	return -1;
}

static enum hawser_status read_point(struct cli_mooring *mooring, const struct words *words,
                                     struct hawser_report *report)
{
	struct cli_mooring_point point = {.id = 0};
	double value[4] = {0.0};
	enum hawser_status status = identity(&point.id, mooring, words, report);

	if (!status)
		status = numbers(point.x, 3, mooring, words, 2, report);
	if (!status)
		status = numbers(value, 4, mooring, words, 5, report);
	if (!status)
		status = attach(&point, mooring, words->word[1], report);
	if (status)
		return status;
	if (point_of(mooring, point.id) >= 0)
		return wrong(report, mooring, "point %d is there twice", point.id);
	point.mass = value[0];
	point.volume = value[1];
	point.CdA = value[2];
	point.added = value[3];
	if (hawser__more(&mooring->point, mooring->points, sizeof *mooring->point))
		return hawser__no_memory(report, "init");
	mooring->point[mooring->points++] = point;
	return HAWSER_OK;
}

static enum hawser_status read_line(struct cli_mooring *mooring, const struct words *words,
                                    struct hawser_report *report)
{
	struct cli_mooring_line line = {.type = -1};
	double value[4] = {0.0};
	enum hawser_status status = identity(&line.id, mooring, words, report);

	for (int i = 0; i < mooring->types; i++)
		if (!strcmp(mooring->type[i].name, words->word[1]))
			line.type = i;
	if (!status && line.type < 0)
		return wrong(report, mooring, "line %d is of the type '%s', which the file does not have",
		             line.id, words->word[1]);
	if (!status)
		status = numbers(value, 4, mooring, words, 2, report);
	if (status)
		return status;
	for (int k = 0; k < 2; k++) {
		line.end[k] = value[k] >= 1.0 && value[k] <= 1e6 ? point_of(mooring, (int)value[k]) : -1;
		if (line.end[k] < 0)
			return wrong(report, mooring, "line %d ends at the point %g, which the file does not have",
			             line.id, value[k]);
	}
	if (!(value[2] > 0.0 && value[3] >= 1.0 && value[3] <= 1e6))
		return wrong(report, mooring, "line %d has the length %g m and %g segments: the columns are "
		             "ID, LineType, AttachA, AttachB, UnstrLen, NumSegs", line.id, value[2], value[3]);
	line.length = value[2];
	line.elements = (int)value[3];
	if (hawser__more(&mooring->line, mooring->lines, sizeof *mooring->line))
		return hawser__no_memory(report, "init");
	mooring->line[mooring->lines++] = line;
	return HAWSER_OK;
}

/* Lines that part at a point, each by itself. */
static enum hawser_status read_failure(struct cli_mooring *mooring, const struct words *words,
                                       struct hawser_report *report)
{
	const char *point = words->word[1] + strspn(words->word[1], "PpOoIiNnTt");
	struct cli_mooring_failure failure = {.point = point_of(mooring, (int)strtol(point, NULL, 10))};
	double value[2] = {0.0};
	char *rest = NULL;
	enum hawser_status status = numbers(value, 2, mooring, words, 3, report);

	if (!status && value[0] > 0.0 && value[1] > 0.0)
		left_out(mooring, "FailTen of a failure that has a FailTime");
	failure.time = value[0];
	failure.tension = value[0] > 0.0 ? 0.0 : value[1];
	for (char *word = strtok_r(words->word[2], ",", &rest); word && !status;
	     word = strtok_r(NULL, ",", &rest)) {
		for (failure.line = mooring->lines - 1; failure.line >= 0; failure.line--)
			if (mooring->line[failure.line].id == strtol(word, NULL, 10) && failure.point >= 0 &&
			    (mooring->line[failure.line].end[0] == failure.point ||
			     mooring->line[failure.line].end[1] == failure.point))
				break;
		if (failure.line < 0)
			return wrong(report, mooring, "line '%s' does not end at the point %s", word,
			             words->word[1]);
		if (hawser__more(&mooring->failure, mooring->failures, sizeof *mooring->failure))
			return hawser__no_memory(report, "init");
		mooring->failure[mooring->failures++] = failure;
	}
	return status;
}

static enum hawser_status read_option(struct cli_mooring *mooring, const struct words *words,
                                      struct hawser_report *report)
{
	static const char *const other[] = {"WaveKin", "Currents", "Current"};
	static const char *const bed[] = {"SeafloorFile", "SeafloorPath", "bathymetry",
	                                  "bathymetryFile", "depth", "WtrDpth", "WtrDepth"};
	double value;
	int defaults = !strcasecmp(words->word[0], "default"); /* that of another program */
	const struct {
		const char *key;
		double *value;
	} known[] = {
		{"g", &mooring->g}, {"gravity", &mooring->g}, {"rho", &mooring->density},
		{"rhoW", &mooring->density}, {"WtrDnsty", &mooring->density}, {"depth", &mooring->depth},
		{"WtrDpth", &mooring->depth}, {"WtrDepth", &mooring->depth}, {"kBot", &mooring->stiffness},
		{"kb", &mooring->stiffness}, {"cBot", &mooring->damping}, {"cb", &mooring->damping},
		{"FrictionCoefficient", &mooring->friction}};

	for (size_t i = 0; i < sizeof bed/sizeof *bed; i++)
		if (!strcasecmp(words->word[1], bed[i]) && !defaults && !number(&value, words->word[0]))
			return cli_mooring_bed(mooring, words->word[0]) ? HAWSER_OK
				: wrong(report, mooring, "the bathymetry '%s' cannot be read: its path is that of the "
				        "folder where hawser runs, or of this file", words->word[0]);
	for (size_t i = 0; i < sizeof known/sizeof *known; i++)
		if (!strcasecmp(words->word[1], known[i].key) && defaults)
			left_out(mooring, "%s: DEFAULT, the number of the program that calls MoorDyn",
			         words->word[1]);
		else if (!strcasecmp(words->word[1], known[i].key))
			return numbers(known[i].value, 1, mooring, words, 0, report);
	for (size_t i = 0; i < sizeof other/sizeof *other; i++)
		if (!strcasecmp(words->word[1], other[i]) && strcmp(words->word[0], "0") != 0)
			left_out(mooring, "%s: waves and currents of other files; see water in "
			         "hawser-scene(5)", words->word[1]);
	return HAWSER_OK;
}

static const struct section section[] = {
	{"LINE TYPES", "LINE DICTIONARY", 10, read_type}, {"ROD TYPES", "ROD DICTIONARY", 0, NULL},
	{"BODIES", "BODY", 8, read_body}, {"RODS", "ROD LIST", 0, NULL}, {"POINT", "NODE", 9, read_point},
	{"CONNECTION", "CONNECTS", 9, read_point}, {"LINES", "LINE PROPERTIES", 6, read_line},
	{"FAILURE", "FAILURE", 5, read_failure}, {"CONTROL", "CONTROL", 0, NULL},
	{"EXTERNAL", "EXTERNAL", 0, NULL}, {"OPTIONS", "OPTIONS", 2, read_option}};

/* The section of a heading, a line that begins with dashes; NULL: of one that is not read. */
static const struct section *heading(const char *line)
{
	char text[LINE];
	size_t length = 0;

	for (; line[length] && length + 1 < sizeof text; length++)
		text[length] = (char)(line[length] - (line[length] >= 'a' && line[length] <= 'z' ? 32 : 0));
	text[length] = '\0';
	for (size_t i = 0; i < sizeof section/sizeof *section; i++)
		if (strstr(text, section[i].name) || strstr(text, section[i].other))
			return &section[i];
	return NULL;
}

static void split(struct words *words, char *line)
{
	char *rest = NULL;

	line[strcspn(line, "#")] = '\0';
	words->count = 0;
	for (char *word = strtok_r(line, blank, &rest); word && words->count < WORDS;
	     word = strtok_r(NULL, blank, &rest))
		words->word[words->count++] = word;
}

static enum hawser_status read_all(struct cli_mooring *mooring, FILE *stream,
                                   struct hawser_report *report)
{
	const struct section *now = NULL;
	enum hawser_status status = HAWSER_OK;
	char line[LINE];
	int within = 0; /* lines of the section: two have the titles of its columns */

	for (mooring->number = 1; !status && fgets(line, sizeof line, stream); mooring->number++) {
		struct words words;

		if (!strncmp(line + strspn(line, blank), "---", 3)) {
			now = heading(line);
			within = now && now->row == read_option ? 2 : 0;
			continue;
		}
		if (!now)
			continue;
		/* The titles tell the columns of version 1 apart. */
		if (within == 0 && now->row == read_type && strstr(line, "Cdn"))
			return wrong(report, mooring, "the columns are those of MoorDyn's version 1, which has "
			             "its coefficients in another order: write the file as version 2 has it");
		split(&words, line);
		if (within++ < 2 || words.count == 0)
			continue;
		if (!now->row) {
			left_out(mooring, "the section %s", now->name);
			now = NULL;
		} else if (words.count < now->least) {
			status = wrong(report, mooring, "%d words, a row of %s has %d or more", words.count,
			               now->name, now->least);
		} else {
			status = now->row(mooring, &words, report);
		}
	}
	if (!status && ferror(stream))
		return hawser__fail(report, hawser__unreadable(errno), "init", "%s: %s", mooring->path,
		                    strerror(errno));
	if (!status && mooring->lines == 0)
		status = wrong(report, mooring, "no lines: a file of MoorDyn or MoorPy has sections LINE "
		               "TYPES, POINTS, LINES and OPTIONS");
	return status;
}

enum hawser_status cli_init_from(const char *path, struct hawser_report *report)
{
	struct cli_mooring mooring = {.path = path, .g = 9.81, .density = 1025.0, .depth = NAN};
	FILE *stream = fopen(path, "r");
	struct hawser__locale locale;
	enum hawser_status status;
	char *text = NULL;
	size_t size = 0;

	if (!stream)
		return hawser__fail(report, hawser__unreadable(errno), "init", "%s: %s", path,
		                    strerror(errno));
	hawser__locale_begin(&locale);
	status = read_all(&mooring, stream, report);
	fclose(stream);
	if (!status)
		status = cli_mooring_scene(&text, &size, &mooring, report);
	if (!status)
		status = hawser__file_put("-", text, size, report);
	free(text);
	hawser__locale_end(&locale);
	free(mooring.type);
	free(mooring.body);
	free(mooring.point);
	free(mooring.line);
	free(mooring.failure);
	return status;
}
