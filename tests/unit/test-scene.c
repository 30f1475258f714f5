/* Valid scenes: values, units, defaults, overrides, access by key, and writing.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "scene/page/schema.h"
#include "tests/tap.h"
#include "tests/unit/scene-text.h"

#define ADD_IT ": add it to the scene, or with --set"

static const char chairlift[] =
	"cable:   {EA: 400 MN, rho: 6 kg/m}\n"
	"span:    {d: 250 m, h: -10}\n"
	"tension: {T0: 80 kN}\n"
	"damping: {alpha: 0.08 kg/m/s}\n"
	"load:    {frame: local, per_length: [0.8 N/m, 0.9, 1 kN/km]}\n";

static const char bare[] = "cable: {EA: 1e8, rho: 3}\nspan: {d: 100, h: 0}\ntension: {H: 5e4}\n";

/* Equal values, whatever the names and whether written or default. */
static int same(const struct hawser_scene *a, const struct hawser_scene *b)
{
	return !memcmp(&a->cable, &b->cable, sizeof a->cable) &&
	       !memcmp(&a->span, &b->span, sizeof a->span) && a->g == b->g &&
	       a->tension.given == b->tension.given && a->tension.value == b->tension.value &&
	       a->tension.branch == b->tension.branch && a->damping.kind == b->damping.kind &&
	       a->damping.alpha == b->damping.alpha && a->damping.mass == b->damping.mass &&
	       a->damping.stiffness == b->damping.stiffness &&
	       a->damping.ratio == b->damping.ratio && a->damping.ratios == b->damping.ratios &&
	       !memcmp(a->damping.ratio_next, b->damping.ratio_next,
	               sizeof a->damping.ratio_next) &&
	       a->load.present == b->load.present &&
	       a->load.frame == b->load.frame &&
	       !memcmp(a->load.per_length, b->load.per_length, sizeof a->load.per_length) &&
	       !memcmp(a->load.extent, b->load.extent, sizeof a->load.extent) &&
	       a->model.modes == b->model.modes && a->model.basis == b->model.basis &&
	       a->model.accuracy == b->model.accuracy &&
	       a->model.tolerance == b->model.tolerance && a->model.condense == b->model.condense &&
	       a->model.inertia == b->model.inertia && a->model.energy == b->model.energy;
}

static struct hawser_scene must_read(const char *text, const char *set)
{
	struct hawser_scene scene;
	struct hawser_report report = {.message = ""};

	if (read_text(&scene, text, set, &report) != HAWSER_OK) {
		ok(0, "reads%s%s: %s", set ? " with " : "", set ? set : "", report.message);
		exit(done_testing());
	}
	return scene;
}

static void values(void)
{
	struct hawser_scene scene = must_read(chairlift, NULL);

	ok(scene.cable.EA == 4e8 && scene.cable.rho == 6.0, "MN and kg/m");
	ok(scene.span.d == 250.0 && scene.span.h == -10.0, "m, and a negative plain number");
	ok(scene.tension.given == HAWSER_GIVEN_T0 && scene.tension.value == 8e4, "kN");
	ok(scene.damping.kind == HAWSER_DAMPING_ALPHA && scene.damping.alpha == 0.08, "kg/m/s");
	ok(scene.load.present && scene.load.frame == HAWSER_FRAME_LOCAL, "a load, local");
	ok(scene.load.per_length[0] == 0.8 && scene.load.per_length[1] == 0.9, "a mixed list");
	close_to(scene.load.per_length[2], 1.0, 4e-16, "kN/km");
	ok(!strcmp(scene.name, "s.yaml"), "the name is kept");
	hawser_scene_clear(&scene);
	ok(!scene.name && scene.cable.EA == 0.0, "cleared");
	hawser_scene_clear(&scene);
	hawser_scene_clear(NULL);
}

static void defaults(void)
{
	struct hawser_scene scene = must_read(bare, NULL);

	ok(scene.g == 9.81, "g");
	ok(scene.model.modes == 5 && scene.model.basis == 0 && scene.model.tolerance == 1e-10,
	   "model");
	ok(scene.damping.kind == HAWSER_DAMPING_NONE && !scene.load.present, "no damping, no load");
	ok(scene.load.extent[0] == 0.0 && scene.load.extent[1] == 1.0, "extent");
	ok(!hawser_scene_written(&scene, "g") && hawser_scene_written(&scene, "cable.EA") &&
	   !hawser_scene_written(&scene, "no.key"), "knows what the user wrote");
	hawser_scene_clear(&scene);
	scene = must_read("g: 1.62\n" "cable: {EA: .inf, rho: 3}\nspan: {d: 100, h: 0}\n"
	                  "tension: {sag: 2 m}\ndamping: {rayleigh: {mass: 0.1 1/s, stiffness: 1 ms}}\n"
	                  "model: {modes: 7, basis: 40, tolerance: 1e-8}\n", NULL);
	ok(isinf(scene.cable.EA) && scene.g == 1.62, "inextensible, on the moon");
	ok(scene.tension.given == HAWSER_GIVEN_SAG && scene.tension.value == 2.0, "sag");
	ok(scene.damping.kind == HAWSER_DAMPING_RAYLEIGH && scene.damping.mass == 0.1 &&
	   scene.damping.stiffness == 1e-3, "Rayleigh");
	ok(scene.model.modes == 7 && scene.model.basis == 40 && scene.model.tolerance == 1e-8,
	   "model as written");
	hawser_scene_clear(&scene);
}

static void spellings(void)
{
	static const char *const texts[] = {
		"%YAML 1.1\n---\ncable: {EA: 1e8, rho: 3}\nspan: {d: 100, h: 0}\ntension: {H: 5e4}\n...\n",
		"{\"cable\": {\"EA\": 1e8, \"rho\": 3}, \"span\": {\"d\": 100, \"h\": 0}, "
		"\"tension\": {\"H\": 5e4}}",
		"\xef\xbb\xbf" "cable:\n  EA: '100 MN'\n  rho: +3.0e0 # kg\nspan:\n  d: 0.1 km\n  h: -0\n"
		"tension:\n  H: 50000.\n",
		"tension: {H: .5e+5}\r\nspan: {h: 0 mm, d: 1e2m}\r\n"
		"cable: {rho: 3 g/mm, EA: 100MN}\r\n",
	};
	struct hawser_scene want = must_read(bare, NULL);

	for (size_t i = 0; i < sizeof texts/sizeof *texts; i++) {
		struct hawser_scene got = must_read(texts[i], NULL);

		ok(got.cable.EA == want.cable.EA && got.cable.rho == want.cable.rho &&
		   got.span.d == want.span.d && got.span.h == want.span.h &&
		   got.tension.value == want.tension.value, "spelling %zu means the same", i);
		hawser_scene_clear(&got);
	}
	hawser_scene_clear(&want);
}

/* An override gives the same as a change of the file; the edited scene is the text on the right. */
static void overrides(void)
{
	static const struct {
		const char *set, *edited;
	} table[] = {
		{"cable.EA=1e8", "cable: {EA: 1e8, rho: 6}\nspan: {d: 250, h: -10}\ntension: {T0: 8e4}\n"},
		{" cable.rho = 7.385 kg/m", "cable: {EA: 4e8, rho: 7.385}\nspan: {d: 250, h: -10}\n"
		                            "tension: {T0: 8e4}\n"},
		{"g=3.7", "g: 3.7\ncable: {EA: 4e8, rho: 6}\nspan: {d: 250, h: -10}\ntension: {T0: 8e4}\n"},
		{"tension.H=90kN", "cable: {EA: 4e8, rho: 6}\nspan: {d: 250, h: -10}\n"
		                   "tension: {H: 9e4}\n"},
		{"tension.branch=slack", "cable: {EA: 4e8, rho: 6}\nspan: {d: 250, h: -10}\n"
		                         "tension: {T0: 8e4, branch: slack}\n"},
		{"span={d: 33.5 m, h: 2.385}", "cable: {EA: 4e8, rho: 6}\nspan: {d: 33.5, h: 2.385}\n"
		                               "tension: {T0: 8e4}\n"},
		{"damping.ratio=1 %", "cable: {EA: 4e8, rho: 6}\nspan: {d: 250, h: -10}\n"
		                      "tension: {T0: 8e4}\ndamping: {ratio: 0.01}\n"},
		{"load={frame: global, per_length: [1, 2 N/m, 3]}",
		 "cable: {EA: 4e8, rho: 6}\nspan: {d: 250, h: -10}\ntension: {T0: 8e4}\n"
		 "load: {frame: global, per_length: [1, 2, 3]}\n"},
		{"model.modes=3", "cable: {EA: 4e8, rho: 6}\nspan: {d: 250, h: -10}\n"
		                  "tension: {T0: 8e4}\nmodel: {modes: 3}\n"},
	};
	static const char base[] =
		"cable: {EA: 4e8, rho: 6}\nspan: {d: 250, h: -10}\ntension: {T0: 8e4}\n";

	for (size_t i = 0; i < sizeof table/sizeof *table; i++) {
		struct hawser_scene set = must_read(base, table[i].set);
		struct hawser_scene edited = must_read(table[i].edited, NULL);

		ok(same(&set, &edited) &&
		   !memcmp(set.written, edited.written, sizeof set.written), "--set %s is an edit",
		   table[i].set);
		hawser_scene_clear(&set);
		hawser_scene_clear(&edited);
	}
}

static void displaced(void)
{
	static const char *const both[] = {"damping.rayleigh.mass=2", "damping.rayleigh.stiffness=3",
	                                   "tension.branch=slack", "tension.T1=7e4",
	                                   "load.per_length=[1, 2, 3]", "load.per_length=[4, 5, 6]"};
	struct hawser_report report = {0};
	struct hawser_scene scene;

	ok(read_bytes(&scene, chairlift, strlen(chairlift), both, 6, &report) == HAWSER_OK,
	   "several overrides: %s", report.message);
	ok(scene.damping.kind == HAWSER_DAMPING_RAYLEIGH && scene.damping.mass == 2.0 &&
	   scene.damping.stiffness == 3.0 && scene.damping.alpha == 0.0,
	   "one kind of damping displaces another, without a trace");
	ok(scene.tension.given == HAWSER_GIVEN_T1 && scene.tension.value == 7e4 &&
	   scene.tension.branch == HAWSER_BRANCH_SLACK, "T1 for T0, the branch stays");
	ok(scene.load.per_length[0] == 4.0, "the last override counts");
	hawser_scene_clear(&scene);
	scene = must_read("cable: {EA: 1e8, rho: 3}\nspan: {d: 100, h: 0}\n"
	                  "tension: {T0: 5e4, branch: slack}\n", "tension.H=4e4");
	ok(scene.tension.given == HAWSER_GIVEN_H && scene.tension.branch == HAWSER_BRANCH_TAUT,
	   "H for T0 takes the branch with it");
	ok(!hawser_scene_written(&scene, "tension.branch") &&
	   !hawser_scene_written(&scene, "tension.T0"), "and both are no longer written");
	hawser_scene_clear(&scene);
}

static void refuse_get(const struct hawser_scene *scene, const char *path, const char *message)
{
	struct hawser_report report = {.message = ""};
	double value = 2.385;

	ok(hawser_scene_get(scene, &value, path, &report) == HAWSER_ERR_ARGUMENT && value == 2.385,
	   "get %s is an argument error", path);
	if (!ok(!strcmp(report.message, message), "and says so"))
		printf("# got  %s\n# want %s\n", report.message, message);
}

static void questions(void)
{
	struct hawser_scene scene = must_read(chairlift, NULL);
	struct hawser_report report;
	static const struct {
		const char *path;
		double value;
	} table[] = {{"g", 9.81}, {"cable.EA", 4e8}, {"span.h", -10.0}, {"tension.T0", 8e4},
	             {"damping.alpha", 0.08}, {"model.modes", 5.0}, {"load.per_length[1]", 0.9},
	             {"load.extent[1]", 1.0}};
	char word[HAWSER_WORD_SIZE];

	for (size_t i = 0; i < sizeof table/sizeof *table; i++) {
		double value = 0.0;

		ok(hawser_scene_get(&scene, &value, table[i].path, &report) == HAWSER_OK &&
		   value == table[i].value, "get %s", table[i].path);
	}
	ok(hawser_scene_word(&scene, word, "load.frame", &report) == HAWSER_OK &&
	   !strcmp(word, "local"), "the word of load.frame");
	ok(hawser_scene_word(&scene, word, "tension.branch", &report) == HAWSER_OK &&
	   !strcmp(word, "taut"), "the word of tension.branch, a default");
	ok(hawser_scene_word(&scene, word, "cable.EA", &report) == HAWSER_ERR_ARGUMENT,
	   "no word for a number");
	refuse_get(&scene, "cable.ea",
	           "there is no key cable.ea: did you mean EA? cable takes EA, rho, EI");
	refuse_get(&scene, "tension.H", "this scene does not give tension.H" ADD_IT);
	refuse_get(&scene, "damping.ratio", "this scene does not give damping.ratio" ADD_IT);
	refuse_get(&scene, "load.frame", "load.frame is a word, not a number");
	refuse_get(&scene, "load.extent",
	           "load.extent has 2 values: give one of them, load.extent[0] to load.extent[1]");
	refuse_get(&scene, "load.extent[2]", "load.extent[2]: load.extent has 2 values, counted from 0");
	refuse_get(&scene, "cable.EA[0]", "cable.EA[0]: cable.EA has 1 value, counted from 0");
	hawser_scene_clear(&scene);
	scene = must_read(bare, NULL);
	refuse_get(&scene, "load.extent[0]", "this scene does not give load.extent[0]" ADD_IT);
	ok(hawser_scene_word(&scene, word, "tension.branch", &report) == HAWSER_ERR_ARGUMENT,
	   "no branch where H is given");
	ok(hawser_scene_word(&scene, word, "model.modes", &report) == HAWSER_ERR_ARGUMENT,
	   "no word where modes are counted");
	hawser_scene_clear(&scene);
	scene = must_read(bare, "model={modes: auto, accuracy: 0.5 %}");
	ok(scene.model.modes == HAWSER_MODES_AUTO && scene.model.accuracy == 0.005 &&
	   !hawser_scene_word(&scene, word, "model.modes", &report) && !strcmp(word, "auto"),
	   "modes: auto, and a percentage");
	refuse_get(&scene, "model.modes", "model.modes is a word, not a number");
	hawser_scene_clear(&scene);
}

/* Writing and reading again gives the same scene to the last bit. */
static void round_trip(const char *text, const char *set)
{
	struct hawser_scene scene = must_read(text, set), again;
	struct hawser_report report = {.message = ""};
	char *written = NULL;
	size_t length = 0;
	FILE *stream = open_memstream(&written, &length);

	ok(hawser_scene_write(&scene, stream, &report) == HAWSER_OK, "writes");
	fclose(stream);
	ok(read_text(&again, written, NULL, &report) == HAWSER_OK, "reads again: %s", report.message);
	if (!ok(same(&scene, &again), "and is the same, %s", set ? set : "as it is"))
		printf("# %s\n", written);
	hawser_scene_clear(&again);
	hawser_scene_clear(&scene);
	free(written);
}

/* Regression: an infinite cable.EA was converted to an integer. */
static void infinite(void)
{
	struct hawser_report report = {.message = ""};
	struct hawser_scene scene;
	enum hawser_status status = read_text(&scene, chairlift, NULL, &report);

	if (!status)
		status = hawser_scene_set(&scene, "cable.EA", INFINITY, &report);
	ok(!status && isinf(scene.cable.EA), "an infinite stiffness can be set: %s", report.message);
	status = hawser_scene_set(&scene, "model.modes", INFINITY, &report);
	ok(status == HAWSER_ERR_SCENE, "an infinite number of modes is refused: %s", report.message);
	hawser_scene_clear(&scene);
}

static void full_disk(void)
{
	struct hawser_scene scene = must_read(bare, NULL);
	struct hawser_report report = {.message = ""};
	FILE *full = fopen("/dev/full", "w");

	if (!full) {
		ok(1, "no full disk here # SKIP");
	} else {
		ok(hawser_scene_write(&scene, full, &report) == HAWSER_ERR_IO &&
		   !strncmp(report.message, "cannot write the scene: ", 24), "a full disk: %s",
		   report.message);
		fclose(full);
	}
	hawser_scene_clear(&scene);
}

static void files(void)
{
	struct hawser_report report = {.message = ""};
	struct hawser_scene scene;
	char text[64];

	ok(hawser_scene_open(&scene, "/nowhere/at/all.yaml", NULL, 0, &report) == HAWSER_ERR_ARGUMENT &&
	   !strcmp(report.message, "cannot read /nowhere/at/all.yaml: No such file or directory"),
	   "no such file: %s", report.message);
	ok(hawser_scene_open(&scene, "/", NULL, 0, &report) == HAWSER_ERR_ARGUMENT &&
	   !strcmp(report.message, "cannot read /: Is a directory"), "a directory: %s",
	   report.message);
	ok(!scene.name && scene.cable.EA == 0.0, "nothing is left in the scene");

	FILE *big = tmpfile();
	for (int i = 0; big && i < 20000; i++)
		fputs("# nothing but comments, but one and a quarter megabytes of them\n", big);
	rewind(big);
	ok(hawser_scene_read(&scene, big, "big.yaml", NULL, 0, &report) == HAWSER_ERR_SCENE &&
	   !strcmp(report.message, "big.yaml: larger than 1 MiB, so this is not a scene"),
	   "a huge file: %s", report.message);
	fclose(big);

	FILE *in = tmpfile();
	fputs("cable: 3\n", in);
	fflush(in);
	rewind(in);
	snprintf(text, sizeof text, "/dev/fd/%d", fileno(in));
	ok(freopen(text, "r", stdin) != NULL, "standard input is redirected");
	ok(hawser_scene_open(&scene, "-", NULL, 0, &report) == HAWSER_ERR_SCENE &&
	   !strcmp(report.message, "<stdin>:1:8: cable: \"3\" must be a mapping with the keys EA, rho, EI"),
	   "standard input: %s", report.message);
	fclose(in);
}

/* load.static beside the varying load, alone, and by override; temperature. */
static void static_loads(void)
{
	static const char text[] = "cable: {EA: 25 MN, rho: 1.6}\nspan: {d: 400, h: 12}\n"
	                           "tension: {H: 28 kN}\n";
	static const char both[] = "cable: {EA: 25 MN, rho: 1.6}\nspan: {d: 400, h: 12}\n"
	                           "tension: {H: 28 kN, state: loaded}\n"
	                           "temperature: {change: -20 K, expansion: 1.9e-5 /K}\n"
	                           "load: {static: {mass: 0.9}, frame: local, per_length: [0, 1, 0]}\n";
	struct hawser_report report = {.message = ""};
	struct hawser_scene scene;
	double value;

	if (!ok(!read_text(&scene, text, "load={static: {per_length: [0, 0, 12]}}", &report),
	        "static load by override %s", report.message))
		return;
	ok(!scene.load.present && scene.static_load.present && !scene.temperature.present,
	   "a static load is no varying load");
	ok(scene.static_load.per_length[2] == 12.0 && scene.static_load.mass == 0.0 &&
	   scene.tension.state == HAWSER_STATE_REFERENCE, "its values and defaults");
	ok(hawser_scene_get(&scene, &value, "load.extent[0]", NULL) == HAWSER_ERR_ARGUMENT &&
	   !hawser_scene_get(&scene, &value, "load.static.per_length[2]", NULL) && value == 12.0,
	   "keys of the static load apply, those of the varying one do not");
	hawser_scene_clear(&scene);
	if (!ok(!read_text(&scene, text, NULL, &report), "neither %s", report.message))
		return;
	ok(!scene.static_load.present &&
	   hawser_scene_get(&scene, &value, "load.static.mass", NULL) == HAWSER_ERR_ARGUMENT,
	   "no static load");
	hawser_scene_clear(&scene);
	if (!ok(!read_text(&scene, both, NULL, &report), "both %s", report.message))
		return;
	ok(scene.load.present && scene.static_load.present && scene.temperature.present &&
	   scene.tension.state == HAWSER_STATE_LOADED, "both loads, temperature and state");
	close_to(scene.temperature.expansion, 1.9e-5, 1e-15, "a unit that begins with a slash");
	hawser_scene_clear(&scene);
}

static void table_of_keys(void)
{
	int count = 0;

	for (; hawser_scene_key(count); count++)
		for (int j = 0; j < count; j++)
			if (!strcmp(hawser_scene_key(count)->path, hawser_scene_key(j)->path))
				ok(0, "%s stands twice in the table", hawser_scene_key(j)->path);
	ok(count > 0 && !hawser_scene_key(-1) && !hawser_scene_key(count + 1), "%d keys", count);
}

CASE(unit_scene)
{
	table_of_keys();
	static_loads();
	values();
	defaults();
	spellings();
	overrides();
	displaced();
	questions();
	round_trip(chairlift, NULL);
	round_trip(bare, NULL);
	round_trip(hawser__scene_example, NULL);
	round_trip(chairlift, "cable.EA=.inf");
	round_trip(chairlift, "span.h=0.1");
	round_trip(chairlift, "damping={rayleigh: {mass: 0.123456789012345678, stiffness: 1e-300}}");
	round_trip(chairlift, "damping.ratio=0.02");
	round_trip(chairlift, "damping.ratio=[0.5 %, 0.013, 2e-3]");
	round_trip(chairlift, "model={modes: auto, accuracy: 0.123456789012345678 %}");
	round_trip(chairlift, "tension={T1: 1234.5678901234567, branch: slack}");
	round_trip(chairlift, "tension.length0=251.30000000000001");
	round_trip(chairlift, "load.extent=[0.3, 0.7000000000000001]");
	round_trip(chairlift, "travel={speed: 5, hold: length}");
	round_trip(chairlift, "travel={speed: 5, hold: tension, braking: 20, final: 2.385}");
	infinite();
	full_disk();
	files();
	return done_testing();
}
