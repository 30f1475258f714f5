/* tests/unit/test-output.c - tables, JSON and files, apart from the program: text to the letter, what
 * is not finite refused by name, and no failure that leaves a file.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include "output/output.h"
#include "tests/tap.h"

static char folder[] = "/tmp/hawser-output.XXXXXX";

static const char *in_folder(const char *name)
{
	static char path[96];

	snprintf(path, sizeof path, "%s/%s", folder, name);
	return path;
}

/* Content of a file, "" where there is none; static. */
static const char *content(const char *name)
{
	static char text[4096];
	FILE *stream = fopen(in_folder(name), "r");
	size_t got = stream ? fread(text, 1, sizeof text - 1, stream) : 0;

	text[got] = '\0';
	if (stream)
		fclose(stream);
	return text;
}

static void test_table(void)
{
	struct hawser__table table = {0};
	struct hawser_report report = {0};

	hawser__table_comment(&table, "method: %s", "two\nlines");
	hawser__table_column(&table, "Omega%s", "_rad_s");
	hawser__table_column(&table, "y_%s_m", "a b#c\t");
	hawser__table_number(&table, 0.1);
	hawser__table_word(&table, "in-plane");
	hawser__table_number(&table, -0.0);
	hawser__table_word(&table, "");
	ok(hawser__table_write(&table, in_folder("table"), &report) == HAWSER_OK, "a table is written");
	ok(!strcmp(content("table"), "# method: two lines\nOmega_rad_s\ty_a_b_c__m\n"
	                             "0.10000000000000001\tin-plane\n0\t\n"),
	   "to the letter, names tamed: %s", content("table"));
	unlink(in_folder("table"));
	hawser__table_number(&table, 1.0);
	hawser__table_number(&table, NAN);
	ok(hawser__table_write(&table, in_folder("table"), &report) == HAWSER_ERR_NAN,
	   "NaN is refused");
	ok(strstr(report.message, "y_a_b_c__m") && strstr(report.message, "row 3"),
	   "and named: %s", report.message);
	ok(access(in_folder("table"), F_OK) != 0, "before there is a file");
	hawser__table_clear(&table);
	hawser__table_clear(NULL);
}

static void test_json(void)
{
	static const double numbers[] = {1.0/3.0, 2.0};
	struct hawser_report report = {0};
	struct hawser__json json;
	json_t *list, *row;
	int i;

	hawser__json_begin(&json);
	hawser__json_text(&json, json.root, "command", "frf");
	list = hawser__json_array(&json, json.root, "points");
	for (i = 0; i < 2; i++) {
		row = hawser__json_object(&json, list, NULL);
		hawser__json_numbers(&json, row, "u", numbers, 2, 3.0);
		hawser__json_flag(&json, row, "stable", i);
	}
	hawser__json_null(&json, json.root, "irvine");
	ok(hawser__json_write(&json, in_folder("json"), &report) == HAWSER_OK, "JSON is written");
	ok(!strcmp(content("json"), "{\n \"command\": \"frf\",\n \"points\": [\n"
	                            "  {\"u\": [1.0, 6.0], \"stable\": false},\n"
	                            "  {\"u\": [1.0, 6.0], \"stable\": true}\n ],\n"
	                            " \"irvine\": null\n}\n"),
	   "one point a line: %s", content("json"));
	unlink(in_folder("json"));
	hawser__json_number(&json, json.root, "Omega", INFINITY);
	hawser__json_number(&json, json.root, "later", 1.0);
	ok(hawser__json_object(&json, json.root, "more") == NULL, "after a failure nothing is added");
	ok(hawser__json_write(&json, in_folder("json"), &report) == HAWSER_ERR_NAN,
	   "infinity is refused");
	ok(strstr(report.message, "Omega is inf") != NULL, "and named: %s", report.message);
	ok(access(in_folder("json"), F_OK) != 0, "before there is a file");
	hawser__json_clear(&json);
	hawser__json_clear(NULL);
}

static int mask_is_empty(void)
{
	sigset_t now;

	sigprocmask(SIG_SETMASK, NULL, &now);
	return !sigismember(&now, SIGINT) && !sigismember(&now, SIGTERM);
}

static void test_file(void)
{
	struct hawser_report report = {0};
	struct hawser__file file;
	sigset_t now;

	ok(hawser__file_begin(&file, in_folder("file"), &report) == HAWSER_OK, "begin");
	fputs("first", file.stream);
	sigprocmask(SIG_SETMASK, NULL, &now);
	ok(sigismember(&now, SIGINT), "an interrupt waits");
	ok(access(in_folder("file"), F_OK) != 0, "no file before the commit");
	ok(hawser__file_commit(&file, &report) == HAWSER_OK && !strcmp(content("file"), "first"),
	   "there it is");
	ok(mask_is_empty(), "signals are as they were");
	ok(hawser__file_begin(&file, in_folder("file"), &report) == HAWSER_OK, "begin again");
	fputs("second", file.stream);
	hawser__file_abort(&file);
	ok(!strcmp(content("file"), "first") && mask_is_empty(), "an abort keeps the old content");
	hawser__file_abort(&file);
	ok(hawser__file_begin(&file, in_folder("none/file"), &report) == HAWSER_ERR_IO &&
	   strstr(report.message, "none/file: No such file or directory") && mask_is_empty(),
	   "a missing folder: %s", report.message);
	ok(hawser__file_check(in_folder("none/file"), &report) == HAWSER_ERR_IO, "asked beforehand");
	ok(hawser__file_check(in_folder("file"), &report) == HAWSER_OK &&
	   hawser__file_check("-", &report) == HAWSER_OK &&
	   hawser__file_check(NULL, &report) == HAWSER_OK &&
	   hawser__file_check("/dev/null", &report) == HAWSER_OK, "what can be written");
	ok(!strcmp(content("file"), "first"), "asking changes nothing");
	unlink(in_folder("file"));
	if (access("/dev/full", W_OK) == 0) {
		ok(hawser__file_begin(&file, "/dev/full", &report) == HAWSER_OK, "a device is opened");
		fputs("too much", file.stream);
		ok(hawser__file_commit(&file, &report) == HAWSER_ERR_IO &&
		   strstr(report.message, "No space left"), "and is full: %s", report.message);
	}
}

static void test_picture(void)
{
	struct hawser__picture picture;
	struct hawser_report report = {0};

	ok(hawser__picture_check("a.jpg", &report) == HAWSER_ERR_ARGUMENT, "no JPEG");
	ok(hawser__picture_begin(&picture, "a.jpg", 9.0, 9.0, &report) == HAWSER_ERR_ARGUMENT,
	   "not even when not asked beforehand");
	hawser__picture_abort(&picture);
	setenv("HAWSER_GNUPLOT", "/nonexistent/gnuplot", 1);
	ok(hawser__picture_check("a.svg", &report) == HAWSER_ERR_PROGRAM &&
	   strstr(report.message, "gnuplot-nox") && strstr(report.message, "--tsv"),
	   "no gnuplot: %s", report.message);
	ok(hawser__picture_begin(&picture, in_folder("a.SVG"), 9.0, 9.0, &report) == HAWSER_OK,
	   "the extension may be in capitals");
	ok(hawser__picture_finish(&picture, &report) == HAWSER_ERR_PROGRAM, "the run notices too");
	ok(access(in_folder("a.SVG"), F_OK) != 0, "and leaves no picture");
	ok(mask_is_empty(), "signals are as they were");
	unsetenv("HAWSER_GNUPLOT");
}

int main(void)
{
	if (!mkdtemp(folder))
		return 1;
	test_table();
	test_json();
	test_file();
	test_picture();
	ok(rmdir(folder) == 0, "no file is left");
	return done_testing();
}
