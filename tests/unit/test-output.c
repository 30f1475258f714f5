/* tests/unit/test-output.c - tables, JSON and files: exact text, failure with the name of a value
 * that is not finite, and no file left after a failure.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include "output/drawing/labels.h"
#include "output/output.h"
#include "tests/tap.h"

static char folder[] = "/tmp/hawser-output.XXXXXX";

static const char *in_folder(const char *name)
{
	static char path[96];

	snprintf(path, sizeof path, "%s/%s", folder, name);
	return path;
}

/* Content of a file, "" if there is none; static. */
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
	hawser__json_begin(&json);
	hawser__json_numbers(&json, json.root, "v", (const double[]){1.0, NAN}, 2, 1.0);
	ok(hawser__json_write(&json, in_folder("json"), &report) == HAWSER_ERR_NAN &&
	   strstr(report.message, "v[1] is nan: the result is not written"), "in an array: %s",
	   report.message);
	hawser__json_clear(&json);
	hawser__json_clear(NULL);
}

/* Row i of a table: i and i/4; odd rows are omitted; from row `bad` on 1/0. */
static void some_row(struct hawser__table *row, const void *context, size_t index)
{
	const size_t *bad = context;

	if (index % 2)
		return;
	hawser__table_number(row, (double)index);
	hawser__table_number(row, index >= *bad ? INFINITY : 0.25*(double)index);
}

static void test_rows(void)
{
	size_t bad = SIZE_MAX;
	struct hawser__table table = {0};
	struct hawser_report report = {0};

	hawser__table_column(&table, "i");
	hawser__table_column(&table, "x");
	hawser__table_rows(&table, 5, some_row, &bad);
	hawser__table_number(&table, 7.0);
	hawser__table_word(&table, "last");
	ok(hawser__table_write(&table, in_folder("rows"), &report) == HAWSER_OK, "rows are made");
	ok(!strcmp(content("rows"), "i\tx\n0\t0\n2\t0.5\n4\t1\n7\tlast\n"),
	   "to the letter, before those that are kept: %s", content("rows"));
	hawser__table_rows(&table, 1000000, some_row, &bad);
	ok(hawser__table_check(&table, &report) == HAWSER_OK && table.cells == 2,
	   "a million rows are not kept");
	bad = 4;
	ok(hawser__table_write(&table, in_folder("none"), &report) == HAWSER_ERR_NAN &&
	   strstr(report.message, "x is inf in row 3"), "what is not finite is named: %s",
	   report.message);
	ok(access(in_folder("none"), F_OK) != 0, "before there is a file");
	unlink(in_folder("rows"));
	hawser__table_clear(&table);
}

/* Part 0: numbers, odd ones omitted; part 1: objects, of which number `*context` is not finite. */
static void some_element(struct hawser__json *json, json_t *list, const void *context, int part,
                         size_t index)
{
	const size_t *bad = context;

	if (part == 1)
		hawser__json_number(json, hawser__json_object(json, list, NULL), "x",
		                    index == *bad ? NAN : 0.5*(double)index);
	else if (index % 2 == 0)
		hawser__json_integer(json, list, NULL, (long)index);
}

static void test_lists(void)
{
	size_t bad = SIZE_MAX;
	struct hawser_report report = {0};
	struct hawser__json json;
	json_t *inner;

	hawser__json_begin(&json);
	hawser__json_list(&json, json.root, "numbers", 5, some_element, &bad, 0);
	hawser__json_list(&json, json.root, "points", 2, some_element, &bad, 1);
	hawser__json_list(&json, json.root, "empty", 0, some_element, &bad, 1);
	inner = hawser__json_object(&json, json.root, "more");
	hawser__json_list(&json, inner, "points", 2, some_element, &bad, 1);
	hawser__json_text(&json, inner, "a", "b");
	ok(hawser__json_write(&json, in_folder("lists"), &report) == HAWSER_OK, "lists are made");
	ok(!strcmp(content("lists"), "{\n \"numbers\": [0, 2, 4],\n \"points\": [\n  {\"x\": 0.0},\n"
	                             "  {\"x\": 0.5}\n ],\n \"empty\": [],\n"
	                             " \"more\": {\"points\": [{\"x\": 0.0}, {\"x\": 0.5}], "
	                             "\"a\": \"b\"}\n}\n"),
	   "as those that are kept: %s", content("lists"));
	ok(json_array_size(json_object_get(json.root, "points")) == 0, "and not kept");
	unlink(in_folder("lists"));
	bad = 1;
	hawser__json_list(&json, json.root, "late", 3, some_element, &bad, 1);
	ok(hawser__json_write(&json, in_folder("lists"), &report) == HAWSER_ERR_NAN &&
	   strstr(report.message, "x is nan"), "what is not finite is named: %s", report.message);
	ok(access(in_folder("lists"), F_OK) != 0, "before there is a file");
	hawser__json_clear(&json);
	/* more lists than slots for streams: the others are stored */
	bad = SIZE_MAX;
	hawser__json_begin(&json);
	for (int i = 0; i < HAWSER__JSON_LISTS + 1; i++)
		hawser__json_list(&json, json.root, i < HAWSER__JSON_LISTS ? "a" : "b", 3, some_element,
		                  &bad, 0);
	ok(hawser__json_write(&json, in_folder("lists"), &report) == HAWSER_OK &&
	   !strcmp(content("lists"), "{\n \"a\": [0, 2],\n \"b\": [0, 2]\n}\n"),
	   "any number of lists: %s", content("lists"));
	unlink(in_folder("lists"));
	hawser__json_clear(&json);
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
		ok(hawser__file_begin(&file, "/dev/full", &report) == HAWSER_OK, "opened again");
		setvbuf(file.stream, NULL, _IONBF, 0);
		fputs("too much", file.stream);
		ok(hawser__file_commit(&file, &report) == HAWSER_ERR_IO &&
		   strstr(report.message, "No space left"),
		   "the reason, though nothing is left in the buffer: %s", report.message);
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

/* Labels of points that nearly coincide: no label overlaps another; those without room are omitted. */
static void test_labels(void)
{
	struct hawser__figure figure = {0};
	struct hawser__labels labels;
	int symbols, overlap = 0;

	if (!ok(hawser__figure_begin(&figure, "a.gp", 17.0, 9.8, NULL) == HAWSER_OK, "a figure"))
		return;
	hawser__labels_range(&labels, 0, 0.01, 3.0, 1);
	hawser__labels_range(&labels, 1, 2.385e-5, 0.7, 1);
	hawser__labels_panel(&labels, &figure, &(struct hawser__panel_frame){0.13, 0.5, 0.3, 0.92,
		.x = {.tics = 6}});
	for (int k = 0; k < 12; k++)
		hawser__labels_symbol(&labels, 0.1*(1.0 + 0.002*k), 1e-3);
	hawser__labels_line(&labels, (double[]){0.1, 1e-3}, (double[]){1.0, 1e-1});
	symbols = labels.boxes;
	for (int k = 0; k < 12; k++)
		hawser__labels_put(&labels, &figure.out, 0.1*(1.0 + 0.002*k), 1e-3, 3 + k, 1);
	hawser__labels_put(&labels, &figure.out, NAN, 1e-3, 99, 1);
	for (int k = symbols; k < labels.boxes; k++)
		for (int j = 0; j < k; j++)
			overlap += labels.box[k][0] < labels.box[j][2] && labels.box[j][0] < labels.box[k][2] &&
			           labels.box[k][1] < labels.box[j][3] && labels.box[j][1] < labels.box[k][3];
	ok(overlap == 0 && labels.labels >= 4 && labels.labels <= 8,
	   "%d of 12 numbers about one point, %d overlaps", labels.labels, overlap);
	hawser__figure_abort(&figure);
}

/* How often a text is in a file. */
static int count_in(const char *path, const char *text)
{
	FILE *file = fopen(path, "r");
	char line[400];
	int count = 0;

	while (file && fgets(line, sizeof line, file))
		count += strstr(line, text) != NULL;
	if (file)
		fclose(file);
	return count;
}

/* Ranges of points in the unit of the axis, gaps, one entry for a name, none for nothing. */
static void test_figure(void)
{
	struct hawser__axis x = {"X", "", 2.0}, y = {"Y", "", 10.0};
	struct hawser__figure figure = {0};
	struct hawser_report report = {0};
	const char *path = in_folder("figure.gp");

	if (!ok(hawser__figure_begin(&figure, path, 9.0, 9.0, &report) == HAWSER_OK, "a figure"))
		return;
	hawser__figure_panel(&figure, &(struct hawser__panel_frame){0.1, 0.9, 0.6, 0.9, .x = {&x,
		.bare = 1},
		.y = {&y, .tics = 4, .room = 0.1}});
	x.per = y.per = NAN; /* it has copies */
	hawser__figure_gap(&figure);
	hawser__figure_draw(&figure, "nothing", "with points");
	hawser__figure_put(&figure, 2.0, 10.0);
	hawser__figure_put(&figure, 4.0, NAN);
	hawser__figure_put(&figure, 5.0, INFINITY);
	hawser__figure_put(&figure, 6.0, 30.0);
	hawser__figure_draw(&figure, "a curve", "with lines lt %d", 3);
	hawser__figure_again(&figure, NULL, "using 1:2 with points");
	x.per = y.per = 1.0;
	hawser__figure_panel(&figure, &(struct hawser__panel_frame){0.1, 0.9, 0.2, 0.5, .x = {.axis = &x},
		.y = {&y, .tics = 4, .room = 0.1}});
	hawser__figure_put(&figure, 1.0, 2.385);
	hawser__figure_put(&figure, 2.0, 2.385*(1.0 + 1e-12));
	hawser__figure_draw(&figure, "a curve", "with lines lt 3");
	ok(hawser__figure_finish(&figure, &report) == HAWSER_OK, "is written: %s", report.message);
	ok(count_in(path, "set yrange [0.8:3.2]") == 1, "a range with room");
	ok(count_in(path, "set yrange [2.26575:2.50425]") == 1,
	   "what is round-off is a line in the middle");
	ok(count_in(path, "plot $d0 with lines lt 3 title 'a curve', $d0 using 1:2 with points") == 1 &&
	   count_in(path, "plot $d1 with lines lt 3") == 1, "what is put is drawn");
	ok(count_in(path, "lt 3 title 'a curve'") == 3 && count_in(path, "nothing") == 0,
	   "a name in each panel and once in the legend, or none");
	ok(count_in(path, "set xlabel 'X'") == 1, "numbers of an axis below the lower panel alone");
	remove(path);
}

CASE(unit_output)
{
	if (!mkdtemp(folder))
		return 1;
	test_table();
	test_json();
	test_rows();
	test_lists();
	test_file();
	test_picture();
	test_figure();
	ok(rmdir(folder) == 0, "no file is left");
	test_labels();
	return done_testing();
}
