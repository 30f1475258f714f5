/* The reduced-model file: bit-exact round trip, defaults, every message of the strict reader,
 * complete files or none.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <dirent.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include <hawser/rom.h>
#include "tests/tap.h"

static char folder[] = "rom-file-XXXXXX";
static char path[64];

static void put(const char *text)
{
	FILE *stream = fopen(path, "w");

	if (stream) {
		fputs(text, stream);
		fclose(stream);
	}
}

/* Reading fails with HAWSER_ERR_SCENE, naming the file and all of `words` ('|' between). */
static void refused(const char *text, const char *words)
{
	struct hawser_report report = {0};
	struct hawser_rom rom;
	char copy[200], *rest = copy, *word;
	int fine;

	put(text);
	fine = hawser_rom_open(&rom, path, &report) == HAWSER_ERR_SCENE && !rom.K;
	fine = fine && !strncmp(report.message, path, strlen(path));
	snprintf(copy, sizeof copy, "%s", words);
	while (fine && rest && (word = strsep(&rest, "|")))
		fine = strstr(report.message, word) != NULL;
	ok(fine, "%s  [%s]", report.message, words);
	hawser_rom_clear(&rom);
}

#define MODEL(rest) "{\"n\": 2, \"K\": [[1, 0], [0, 4]]" rest "}"

static void check_messages(void)
{
	refused("", "line|JSON");
	refused("[]", "a list of 0|an object");
	refused("{\"n\": 1, \"K\": [[1]]", "line 1|JSON");
	refused("{\"n\": 1, \"n\": 1, \"K\": [[1]]}", "duplicate");
	refused("{\"n\": 1, \"K\": [[1e999]]}", "JSON");
	refused("{\"n\": 1, \"K\": [[NaN]]}", "JSON");
	refused("{\"K\": [[1]]}", "n is missing|from 1 to 400");
	refused("{\"n\": 0, \"K\": []}", "n is 0");
	refused("{\"n\": 401, \"K\": []}", "n is 401");
	refused("{\"n\": 1.5, \"K\": [[1]]}", "n is 1.5|integer");
	refused("{\"n\": \"2\", \"K\": [[1]]}", "n is \"2\"|integer");
	refused("{\"n\": 1}", "K is missing|1 list");
	refused("{\"hawser_rom\": 2, \"n\": 1, \"K\": [[1]]}", "hawser_rom|is 2; 1 is wanted");
	refused("{\"n\": 2, \"K\": [[1, 0]]}", "K is a list of 1|2 lists");
	refused("{\"n\": 2, \"K\": [[1, 0], [0]]}", "K[1] is a list of 1|2 numbers");
	refused("{\"n\": 2, \"K\": [[1, 0], [0, true]]}", "K[1][1] is true or false|number");
	refused(MODEL(", \"D\": 3"), "D is 3|2 lists");
	refused(MODEL(", \"harmonic\": []"), "\"harmonic\"|did you mean harmonics");
	refused(MODEL(", \"zzzzzzzz\": []"), "\"zzzzzzzz\"|takes hawser_rom, n, D, K");
	refused(MODEL(", \"Q\": {}"), "Q is an object|list of entries");
	refused(MODEL(", \"Q\": [[0, 0, 0, 1], [0, 1, 2]]"), "Q[1] is a list of 3|[j, k, l, value]");
	refused(MODEL(", \"Q\": [[0, 0, 2, 1]]"), "Q[0]: index l is 2|from 0 to 1");
	refused(MODEL(", \"Q\": [[0, 0.5, 0, 1]]"), "Q[0]: index k is 0.5|from 0 to 1");
	refused(MODEL(", \"Q\": [[0, 0, 0, \"1\"]]"), "Q[0]: the value is \"1\"|number");
	refused(MODEL(", \"C\": [[0, 0, 0, 1]]"), "C[0] is a list of 4|[j, k, l, m, value]");
	refused(MODEL(", \"C\": [[0, 0, 0, -1, 1]]"), "C[0]: index m is -1");
	refused(MODEL(", \"C\": [[0, 0, 0, 0, null]]"), "C[0]: the value is null");
	refused(MODEL(", \"harmonics\": {}"), "harmonics is an object");
	refused(MODEL(", \"harmonics\": [1]"), "harmonics[0] is 1|object");
	refused(MODEL(", \"harmonics\": [{\"f\": [1, 0]}]"), "harmonics[0].k is missing|0 or more");
	refused(MODEL(", \"harmonics\": [{\"k\": -1, \"f\": [1, 0]}]"), "harmonics[0].k is -1");
	refused(MODEL(", \"harmonics\": [{\"k\": 0, \"f\": [1, 0], \"phase\": \"sin\"}]"),
	        "harmonic 0|a constant term (k = 0) has the phase cos, and no D without");
	refused(MODEL(", \"harmonics\": [{\"k\": 0, \"D\": [[1, 0], [0, 1]]}]"), "and no D");
	refused(MODEL(", \"harmonics\": [{\"k\": 1, \"Q\": [[0, 0, 2, 1]]}]"),
	        "harmonics[0].Q[0]: index l is 2");
	refused(MODEL(", \"harmonics\": [{\"k\": 1, \"f\": [1, 0], \"load_power\": 0}]"),
	        "harmonics[0].load_power is 0|from 1 to 9");
	refused(MODEL(", \"harmonics\": [{\"k\": 1, \"Q\": [[0, 0, 1, 1e308], [0, 1, 0, 1e308]]}]"),
	        "add up to inf");
	refused(MODEL(", \"harmonics\": [{\"k\": 1, \"f\": [1]}]"), "harmonics[0].f|list of 2");
	refused(MODEL(", \"harmonics\": [{\"k\": 1}]"), "harmonics[0] has none of f, D, K, Q, C and terms");
	refused(MODEL(", \"harmonics\": [{\"k\": 1, \"f\": [1, 0], \"phase\": \"tan\"}]"),
	        "harmonics[0].phase is \"tan\"|\"cos\" or \"sin\"");
	refused(MODEL(", \"harmonics\": [{\"k\": 1, \"f\": [1, 0], \"omega_power\": 4}]"),
	        "harmonics[0].omega_power is 4|from 0 to 3");
	refused(MODEL(", \"harmonics\": [{\"k\": 1, \"F\": [1, 0]}]"), "unknown key \"F\"|mean f?");
	refused(MODEL(", \"harmonics\": [{\"k\": 1, \"D\": [1, 0]}]"), "harmonics[0].D[0] is 1");
	refused(MODEL(", \"harmonics\": [{\"k\": 1, \"K\": [1]}]"), "harmonics[0].K is a list of 1");
	refused(MODEL(", \"harmonics\": [{\"k\": 2000, \"f\": [1, 0]}]"), "k is 2000|0 to 1000");
	refused(MODEL(", \"Q\": [[0, 0, 1, 1e308], [0, 1, 0, 1e308]]"), "Q: the entries [0, 0, 1] add up");
	refused(MODEL(", \"C\": [[0, 0, 0, 1, 1e308], [0, 1, 0, 0, 1e308]]"),
	        "C: the entries [0, 0, 0, 1] add up to inf");
	refused(MODEL(", \"labels\": [\"a\"]"), "labels is a list of 1|2 texts");
	refused(MODEL(", \"labels\": [\"a\", 2]"), "labels[1] is 2|text");
	refused(MODEL(", \"scale\": 1"), "scale is 1");
	refused(MODEL(", \"scale\": {\"lenght\": 1}"), "\"lenght\" in scale|length");
	refused(MODEL(", \"scale\": {\"length\": 1, \"time\": 1}"), "scale.force is missing");
	refused(MODEL(", \"scale\": {\"length\": 1, \"time\": 0, \"force\": 1}"), "scale.time|positive");
	refused(MODEL(", \"shapes\": {}"), "shapes.names");
	refused(MODEL(", \"shapes\": {\"names\": [1]}"), "shapes.names[0] is 1|text");
	refused(MODEL(", \"shapes\": {\"names\": [\"a\"], \"s\": [0.5], \"tangent\": [[1]]}"),
	        "shapes.tangent[0]|2 numbers");
	refused(MODEL(", \"shapes\": {\"names\": [\"a\"], \"s\": [0.5], \"tangent\": [[1, 0]], "
	              "\"stretch\": [1], \"shape\": [[[1, 2, 3]]]}"), "shapes.shape is a list of 1");
	refused(MODEL(", \"shapes\": {\"names\": [\"a\"], \"s\": [0.5], \"tangent\": [[1, 0]], "
	              "\"stretch\": [1], \"shape\": [[[1, 2, 3]], [[1, 2, 3]]], "
	              "\"slope\": [[[1, 2, 3]], [[1, 2, 3]]], \"EA\": -1}"), "shapes.EA is -1");
}

/* --- layout --- */

/* Every character of a file, and of its members in another JSON file. */
static void check_layout(void)
{
	static const char model[] = MODEL(", \"Q\": [[0, 0, 1, -0.1]], \"harmonics\": [{\"k\": 1, "
		"\"f\": [1e-7, 2]}, {\"k\": 2, \"K\": [[1, 2], [3, 4]]}], "
		"\"scale\": {\"length\": 250, \"time\": 1e22, \"force\": 0.3}");
	static const char file[] = "{\n  \"hawser_rom\": 1,\n  \"n\": 2,\n"
		"  \"D\": [\n    [0.0, 0.0],\n    [0.0, 0.0]\n  ],\n"
		"  \"K\": [\n    [1.0, 0.0],\n    [0.0, 4.0]\n  ],\n"
		"  \"Q\": [\n    [0, 0, 1, -0.10000000000000001]\n  ],\n  \"C\": [],\n"
		"  \"harmonics\": [\n    {\"k\": 1, \"phase\": \"cos\", \"omega_power\": 0, "
		"\"f\": [9.9999999999999995e-8, 2.0]},\n    {\n      \"k\": 2,\n"
		"      \"phase\": \"cos\",\n      \"omega_power\": 0,\n      \"K\": [\n"
		"        [1.0, 2.0],\n        [3.0, 4.0]\n      ]\n    }\n  ],\n"
		"  \"scale\": {\"length\": 250.0, \"time\": 1e22, \"force\": 0.29999999999999999}\n}\n";
	static const char members[] = "\"hawser_rom\": 1,\n \"n\": 2,\n"
		" \"D\": [\n  [0.0, 0.0],\n  [0.0, 0.0]\n ],\n"
		" \"K\": [\n  [1.0, 0.0],\n  [0.0, 4.0]\n ],\n"
		" \"Q\": [\n  [0, 0, 1, -0.10000000000000001]\n ],\n \"C\": [],\n"
		" \"harmonics\": [\n  {\"k\": 1, \"phase\": \"cos\", \"omega_power\": 0, "
		"\"f\": [9.9999999999999995e-8, 2.0]},\n  {\"k\": 2, \"phase\": \"cos\", "
		"\"omega_power\": 0, \"K\": [[1.0, 2.0], [3.0, 4.0]]}\n ],\n"
		" \"scale\": {\"length\": 250.0, \"time\": 1e22, \"force\": 0.29999999999999999}";
	struct hawser_rom rom;
	char *text = NULL;
	FILE *stream;
	size_t size;

	put(model);
	if (!ok(!hawser_rom_open(&rom, path, NULL), "a small model is read"))
		return;
	ok(!hawser_rom_text(&rom, &text, NULL) && !strcmp(text, file), "the layout of a file");
	free(text);
	text = NULL;
	stream = open_memstream(&text, &size);
	ok(stream && !hawser_rom_write_members(&rom, stream, NULL) && !fclose(stream) &&
	   !strcmp(text, members), "the layout of the members in another file");
	free(text);
	rom.K[1] = NAN;
	ok(hawser_rom_write_members(&rom, NULL, NULL) == HAWSER_ERR_NAN,
	   "members with a number that is not finite are refused before anything is written");
	hawser_rom_clear(&rom);
}

/* --- round trip --- */

static double odd(void)
{
	return (rand() - 0.37*RAND_MAX)*exp(rand()%60 - 30)/3.0;
}

static double *many(size_t count)
{
	double *value = malloc(count*sizeof *value);

	for (size_t i = 0; value && i < count; i++)
		value[i] = odd();
	return value;
}

static void fill_shapes(struct hawser_rom *rom)
{
	struct hawser_rom_shapes *s = &rom->shapes;

	s->points = 2;
	s->name = calloc(2, sizeof *s->name);
	s->name[0] = strdup("mid");
	s->name[1] = strdup("d\"\xc3\xa9j\xc3\xa0\\");
	s->s = many(2);
	s->tangent = many(4);
	s->stretch = many(2);
	s->shape = many((size_t)rom->n*6);
	s->slope = many((size_t)rom->n*6);
	s->EA = 4e8/3.0;
}

static int fill(struct hawser_rom *rom, int n)
{
	*rom = (struct hawser_rom){.n = n, .D = many((size_t)n*n), .K = many((size_t)n*n),
		.Q = calloc(40, sizeof *rom->Q), .C = calloc(60, sizeof *rom->C), .quads = 40,
		.cubics = 60, .harmonic = calloc(3, sizeof *rom->harmonic), .harmonics = 3,
		.label = calloc((size_t)n, sizeof *rom->label), .length = 250.0/7.0,
		.time = 1.0/3.0, .force = 8e4/11.0, .scaled = 1};
	for (int i = 0; i < 40; i++)
		rom->Q[i] = (struct hawser_quad){rand()%n, rand()%n, rand()%n, odd()};
	for (int i = 0; i < 60; i++)
		rom->C[i] = (struct hawser_cubic){rand()%n, rand()%n, rand()%n, rand()%n, odd()};
	rom->harmonic[0] = (struct hawser_harmonic){.k = 1, .f = many((size_t)n)};
	rom->harmonic[1] = (struct hawser_harmonic){.k = 3, .phase = HAWSER_SIN, .omega_power = 2,
		.D = many((size_t)n*n), .K = many((size_t)n*n)};
	rom->harmonic[2] = (struct hawser_harmonic){.k = 0, .load_power = 2, .quads = 5,
		.Q = calloc(5, sizeof *rom->Q)};
	for (int i = 0; i < 5; i++)
		rom->harmonic[2].Q[i] = (struct hawser_quad){rand()%n, rand()%n, rand()%n, odd()};
	rom->K[0] = 5e-324;
	rom->D[0] = -0.0;
	for (int j = 0; j < n; j++)
		rom->label[j] = strdup(j ? "in-plane 1" : "out-of-plane 1");
	fill_shapes(rom);
	return ok(!hawser_rom_compile(rom, NULL), "a model to write");
}

static int same(const double *a, const double *b, size_t count)
{
	return a && b ? !memcmp(a, b, count*sizeof *a) : a == b;
}

static int same_quads(const struct hawser_quad *a, const struct hawser_quad *b, int count)
{
	int same = 1;

	for (int i = 0; i < count; i++)
		same = same && a[i].j == b[i].j && a[i].k == b[i].k && a[i].l == b[i].l &&
		       a[i].value == b[i].value;
	return same;
}

static void check_round_trip(void)
{
	struct hawser_rom a, b;
	struct hawser_report report = {0};
	const int n = 4;
	char *first = NULL, *second = NULL;
	int q = 1;

	if (!fill(&a, n) || !ok(!hawser_rom_save(&a, path, &report), "saved %s", report.message) ||
	    !ok(!hawser_rom_open(&b, path, &report), "read %s", report.message))
		return;
	ok(b.n == n && same(a.D, b.D, 16) && same(a.K, b.K, 16) && signbit(b.D[0]), "n, D, K");
	for (int i = 0; i < a.quads; i++)
		q = q && b.Q[i].j == a.Q[i].j && b.Q[i].k == a.Q[i].k && b.Q[i].l == a.Q[i].l &&
		    b.Q[i].value == a.Q[i].value;
	ok(q && a.quads == b.quads, "Q");
	for (int i = 0; i < a.cubics; i++)
		q = q && b.C[i].j == a.C[i].j && b.C[i].k == a.C[i].k && b.C[i].l == a.C[i].l &&
		    b.C[i].m == a.C[i].m && b.C[i].value == a.C[i].value;
	ok(q && a.cubics == b.cubics, "C");
	for (int h = 0; h < 3; h++) {
		const struct hawser_harmonic *x = &a.harmonic[h], *y = &b.harmonic[h];

		ok(x->k == y->k && x->phase == y->phase && x->omega_power == y->omega_power &&
		   same(x->f, y->f, 4) && same(x->D, y->D, 16) && same(x->K, y->K, 16) &&
		   x->load_power == y->load_power && x->quads == y->quads &&
		   same_quads(x->Q, y->Q, x->quads), "harmonic %d", h);
	}
	ok(b.scaled && a.length == b.length && a.time == b.time && a.force == b.force, "scale");
	ok(!strcmp(b.label[0], a.label[0]) && !strcmp(b.label[3], a.label[3]), "labels");
	ok(b.shapes.points == 2 && !strcmp(a.shapes.name[1], b.shapes.name[1]) &&
	   same(a.shapes.s, b.shapes.s, 2) && same(a.shapes.tangent, b.shapes.tangent, 4) &&
	   same(a.shapes.stretch, b.shapes.stretch, 2) && same(a.shapes.shape, b.shapes.shape, 24) &&
	   same(a.shapes.slope, b.shapes.slope, 24) && a.shapes.EA == b.shapes.EA, "shapes");
	ok(!hawser_rom_text(&a, &first, NULL) && !hawser_rom_text(&b, &second, NULL) &&
	   !strcmp(first, second), "the same text from both");
	free(first);
	free(second);
	hawser_rom_clear(&b);
	a.K[1] = NAN;
	ok(hawser_rom_save(&a, path, &report) == HAWSER_ERR_NAN, "%s", report.message);
	ok(!hawser_rom_open(&b, path, NULL), "the file from before is whole");
	hawser_rom_clear(&b);
	hawser_rom_clear(&a);
}

static void check_least(void)
{
	struct hawser_rom rom;
	double f[2], u[2] = {0.5, -0.25};

	put(MODEL(""));
	ok(!hawser_rom_open(&rom, path, NULL) && rom.n == 2 && !rom.quads && !rom.cubics &&
	   !rom.harmonics && !rom.label && !rom.scaled && !rom.shapes.points && rom.length == 1.0 &&
	   rom.D[0] == 0.0, "n and K alone make a model");
	hawser_rom_restoring(&rom, f, u);
	ok(f[0] == 0.5 && f[1] == -1.0, "ready for use");
	hawser_rom_clear(&rom);
	put(MODEL(", \"command\": \"rom\", \"version\": \"0.1.0\", \"scene\": {}, \"stats\": {}, "
	          "\"harmonics\": [{\"k\": 2, \"f\": [1, 0]}], \"hawser_rom\": 1.0"));
	ok(!hawser_rom_open(&rom, path, NULL) && rom.harmonic[0].phase == HAWSER_COS &&
	   rom.harmonic[0].omega_power == 0, "the record of a run may stand in the file");
	hawser_rom_clear(&rom);
}

/* --- files --- */

static int entries_of(const char *name)
{
	DIR *dir = opendir(name);
	int count = 0;

	while (dir && readdir(dir))
		count++;
	if (dir)
		closedir(dir);
	return count - 2;
}

static void cannot(enum hawser_status status, const char *name, const struct hawser_report *report)
{
	enum hawser_status want = strstr(report->message, "cannot read") ? HAWSER_ERR_ARGUMENT
	                                                                  : HAWSER_ERR_IO;

	ok(status == want && strstr(report->message, name), "%s", report->message);
}

static void check_files(void)
{
	struct hawser_report report = {0};
	struct hawser_rom rom, other;
	struct stat info;
	char link[96], target[64];

	put(MODEL(""));
	if (!ok(!hawser_rom_open(&rom, path, NULL), "a small model"))
		return;
	cannot(hawser_rom_open(&other, "no/such/model.json", &report), "no/such/model.json", &report);
	cannot(hawser_rom_open(&other, folder, &report), folder, &report);
	cannot(hawser_rom_save(&rom, "no/such/model.json", &report), "no/such/model.json", &report);
	cannot(hawser_rom_save(&rom, folder, &report), folder, &report);
	cannot(hawser_rom_save(&rom, "/dev/full", &report), "/dev/full", &report);
	ok(!hawser_rom_save(&rom, "/dev/null", NULL) && !stat("/dev/null", &info) &&
	   S_ISCHR(info.st_mode), "a device is written, not replaced");
	if (geteuid() != 0) {
		chmod(path, 0444);
		cannot(hawser_rom_save(&rom, path, &report), path, &report);
	}
	chmod(path, 0640);
	snprintf(link, sizeof link, "%s/link", folder);
	snprintf(target, sizeof target, "%s", strrchr(path, '/') + 1);
	ok(!symlink(target, link) && !hawser_rom_save(&rom, link, NULL) && !lstat(link, &info) &&
	   S_ISLNK(info.st_mode) && !stat(path, &info) && (info.st_mode & 0777) == 0640,
	   "a link is followed, and the file keeps its mode");
	unlink(link);
	ok(entries_of(folder) == 1, "nothing is left behind");
	hawser_rom_clear(&rom);
}

CASE(unit_rom_file)
{
	srand(2385);
	ok(mkdtemp(folder) != NULL, "a folder %s", folder);
	snprintf(path, sizeof path, "%s/model.json", folder);
	check_messages();
	check_layout();
	check_round_trip();
	check_least();
	check_files();
	unlink(path);
	rmdir(folder);
	return done_testing();
}
