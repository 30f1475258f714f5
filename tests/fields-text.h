/* tests/fields-text.h - tables and JSON as text, for the tests of fields.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_TESTS_FIELDS_TEXT_H
#define HAWSER_TESTS_FIELDS_TEXT_H

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "output/fields/fields.h"
#include "tests/tap.h"

/* Content of a stream; static. */
static const char *read_back(const char *path)
{
	static char text[4096];
	FILE *stream = fopen(path, "r");
	size_t got = stream ? fread(text, 1, sizeof text - 1, stream) : 0;

	text[got] = '\0';
	if (stream)
		fclose(stream);
	unlink(path);
	return text;
}

static char path[] = "/tmp/hawser-fields.XXXXXX";

static const char *table_text(struct hawser__table *table)
{
	struct hawser_report report = {0};

	ok(hawser__table_write(table, path, &report) == HAWSER_OK, "table is written %s",
	   report.message);
	hawser__table_clear(table);
	return read_back(path);
}

static const char *json_text(struct hawser__json *json)
{
	struct hawser_report report = {0};

	ok(hawser__json_write(json, path, &report) == HAWSER_OK, "JSON is written %s", report.message);
	hawser__json_clear(json);
	return read_back(path);
}

static void same(const char *got, const char *want, const char *what)
{
	ok(!strcmp(got, want), "%s: %s", what, got);
}

#endif
