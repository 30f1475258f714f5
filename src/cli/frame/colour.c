/* cli/frame/colour.c - see progress.h.
 *
 * The conventions are those of other programs: NO_COLOR (no-color.org), CLICOLOR and CLICOLOR_FORCE
 * (bixense.com/clicolors). A file or a pipe gets no codes, unless CLICOLOR_FORCE asks for them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <ctype.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "cli/frame/progress.h"
#include "cli/frame/ranks.h"

/* 1 if the variable has a value that is not "0". */
static int is_set(const char *variable)
{
	const char *value = getenv(variable);

	return value && *value && strcmp(value, "0") != 0;
}

static int is_zero(const char *variable)
{
	const char *value = getenv(variable);

	return value && strcmp(value, "0") == 0;
}

static int wanted(FILE *stream)
{
	const char *none = getenv("NO_COLOR"), *terminal = getenv("TERM");

	if (none && *none) /* any value, "0" too */
		return 0;
	if (is_set("CLICOLOR_FORCE"))
		return 1;
	return !is_zero("CLICOLOR") && terminal && *terminal && strcmp(terminal, "dumb") != 0 &&
	       isatty(fileno(stream));
}

const char *cli_colour(FILE *stream, enum cli_colour colour)
{
	/* select graphic rendition, ECMA-48: bold and red, magenta, green, bold alone, none */
	static const char *const code[] = {"\033[1;31m", "\033[1;35m", "\033[32m", "\033[1m", "\033[0m"};

	return wanted(stream) ? code[colour] : "";
}

/* Length of "FILE:LINE:COLUMN:" at the begin of a message, or 0. A name of a file may have colons. */
static int place_of(const char *message)
{
	const char *end = message;

	for (int numbers = 0; (end = strchr(end, ':')) != NULL; end++) {
		size_t digits = strspn(end + 1, "0123456789");

		numbers = digits > 0 ? numbers + 1 : 0;
		if (numbers == 2 && end[digits + 1] == ':')
			return (int)(end + digits + 2 - message);
		if (isspace((unsigned char)end[1]))
			return 0;
	}
	return 0;
}

void cli_say(enum cli_colour rank, const char *message)
{
	int place = place_of(message);
	const char *bold = cli_colour(stderr, CLI_PLACE), *plain = cli_colour(stderr, CLI_PLAIN);

	if (cli_ranks_silent())
		return;
	fprintf(stderr, "%shawser:%s%s ", cli_colour(stderr, rank), rank == CLI_WARNING ? " warning:" : "",
	        plain);
	if (place)
		fprintf(stderr, "%s%.*s%s", bold, place, message, plain);
	fprintf(stderr, "%s\n", message + place);
}
