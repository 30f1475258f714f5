/* A map does not depend on the number of threads, nor on interruptions, to the last bit.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <fcntl.h>
#include <inttypes.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/map-fields.h"
#include "tests/tap.h"
#include "tests/unit/scene-text.h"

static const char file[] = "test-map-threads.checkpoint";

/* A model of three coordinates, gyroscopic, with two harmonics. */
static double K[9] = {1.0, 0.0, 0.0, 0.0, 2.1, 0.0, 0.0, 0.0, 4.7};
static double D[9] = {0.02, 0.1, 0.0, -0.1, 0.03, 0.05, 0.0, -0.05, 0.02};
static double K1[9] = {1.0, 0.4, 0.1, 0.4, 1.3, 0.3, 0.1, 0.3, 2.0};
static double D2[9] = {0.0, 0.2, 0.0, -0.2, 0.0, 0.1, 0.0, -0.1, 0.0};
static struct hawser_harmonic harmonic[2] = {
	{.k = 1, .phase = HAWSER_COS, .K = K1}, {.k = 2, .phase = HAWSER_SIN, .omega_power = 1, .D = D2}};
static const struct hawser_rom model = {.n = 3, .D = D, .K = K, .harmonics = 2, .harmonic = harmonic,
	.length = 1.0, .time = 1.0, .force = 1.0};

static const struct hawser_map_source source = {.rom = &model, .key = {"Omega", "factor.load"},
	.quantity = "multiplier"};

static struct hawser_map_options range(int threads)
{
	struct hawser_map_options options = {.coarse = 0};

	options.from[0] = 0.7;
	options.to[0] = 5.0;
	options.from[1] = 0.0;
	options.to[1] = 0.6;
	options.points[0] = 28;
	options.points[1] = 22;
	options.threads = threads;
	return options;
}

static int trace(struct hawser_map *map, const struct hawser_map_options *options,
                 struct hawser_report *report)
{
	struct hawser_map_field field;
	enum hawser_status status = hawser_map_cable_open(&field, &source, report);

	*map = (struct hawser_map){.nx = 0};
	if (!status)
		status = hawser_map_trace(map, &field, options, report);
	hawser_map_cable_close(&field);
	return status;
}

static void threads(const struct hawser_map *one)
{
	const int counts[] = {2, 7};

	for (int k = 0; k < 2; k++) {
		struct hawser_map_options options = range(counts[k]);
		struct hawser_map map;
		int status = trace(&map, &options, NULL);

		ok(!status && same_maps(one, &map), "%d threads give the same map of %ld points",
		   counts[k], map.visited);
		hawser_map_clear(&map);
	}
}

/* Functions that vary along one axis, and along both. */
static void scenes(void)
{
	static const char text[] = "cable: {EA: 100 MN, rho: 5 kg/m}\nspan: {d: 80, h: 5}\n"
		"tension: {H: 80 kN}\ndamping: {alpha: 0.2}\nmodel: {modes: 3}\n";
	static const char *const key[3][2] = {{"tension.H", "damping.alpha"}, {"cable.rho", "span.h"},
		{"damping.alpha", "g"}};
	static const double from[3][2] = {{2e4, 0.0}, {2.0, -20.0}, {0.1, 5.0}};
	static const double to[3][2] = {{1e5, 3.0}, {9.0, 40.0}, {0.9, 20.0}};
	struct hawser_scene scene;

	if (!ok(!read_text(&scene, text, NULL, NULL), "a scene is read"))
		return;
	for (int k = 0; k < 3; k++) {
		const struct hawser_map_source of = {.scene = &scene, .key = {key[k][0], key[k][1]},
			.quantity = "growth"};
		struct hawser_map map[2] = {{.nx = 0}, {.nx = 0}};
		int status = 0;

		for (int t = 0; t < 2; t++) {
			struct hawser_map_options options = {.coarse = 0};
			struct hawser_map_field field;

			memcpy(options.from, from[k], sizeof from[k]);
			memcpy(options.to, to[k], sizeof to[k]);
			options.points[0] = options.points[1] = 9;
			options.coarse = 4;
			options.threads = t + 1;
			status = hawser_map_cable_open(&field, &of, NULL);
			if (!status)
				status = hawser_map_trace(&map[t], &field, &options, NULL);
			hawser_map_cable_close(&field);
			if (status)
				break;
		}
		ok(!status && same_maps(&map[0], &map[1]) && map[0].count[HAWSER_MAP_OK] > 8,
		   "%s and %s: 1 and 2 threads, %ld points", key[k][0], key[k][1], map[0].visited);
		hawser_map_clear(&map[0]);
		hawser_map_clear(&map[1]);
	}
	hawser_scene_clear(&scene);
}

/* --- interruption --- */

static int stop_after(void *data, const struct hawser_progress_state *state)
{
	return state->fresh >= *(const long *)data;
}

static void interrupted(const struct hawser_map *whole)
{
	struct hawser_map_options options = range(2);
	const long limit[] = {1, 300, 1200};
	struct hawser_map map;
	int status;

	unlink(file);
	options.checkpoint = file;
	options.progress.function = stop_after;
	for (int k = 0; k < 3; k++) {
		long left = limit[k];

		options.progress.data = &left;
		status = trace(&map, &options, NULL);
		ok(!status && map.interrupted && map.count[HAWSER_MAP_OK] >= limit[k],
		   "interrupted after %d points", map.count[HAWSER_MAP_OK]);
		hawser_map_clear(&map);
	}
	options.progress.function = NULL;
	status = trace(&map, &options, NULL);
	ok(!status && !map.interrupted && map.restored > 1500 && same_maps(whole, &map),
	   "it goes on from %ld points and ends as if nothing had happened", map.restored);
	hawser_map_clear(&map);
	status = trace(&map, &options, NULL);
	ok(!status && map.restored == map.visited && same_maps(whole, &map),
	   "and all of it is there the next time");
	hawser_map_clear(&map);
}

/* From a file that was cut at any byte the map continues after the last complete line. */
static void cut(const struct hawser_map *whole, long size)
{
	struct hawser_map_options options = range(1);
	struct hawser_map map;
	int status = truncate(file, size);

	options.checkpoint = file;
	if (!status)
		status = trace(&map, &options, NULL);
	ok(!status && same_maps(whole, &map), "a file cut at byte %ld: %ld points restored", size,
	   map.restored);
	hawser_map_clear(&map);
}

static void expect(enum hawser_status want, const char *message,
                   const struct hawser_map_options *options)
{
	struct hawser_report report = {.status = HAWSER_OK};
	struct hawser_map map;
	int status = trace(&map, options, &report);

	ok(status == (int)want && strstr(report.message, message), "%s: %s",
	   hawser_status_name((enum hawser_status)status), report.message);
	hawser_map_clear(&map);
}

static void overwrite(long place, char with)
{
	int fd = open(file, O_WRONLY);

	ok(fd >= 0 && pwrite(fd, &with, 1, place) == 1, "byte %ld is damaged", place);
	close(fd);
}

static int look_at_lock(void *data, const struct hawser_progress_state *state)
{
	struct hawser_map_options second = range(1);
	int *looked = data;

	(void)state;
	second.checkpoint = file;
	if (!*looked)
		expect(HAWSER_ERR_IO, "in use by another map", &second);
	*looked = 1;
	return 0;
}

/* A checkpoint with the correct first line, and a forged line with a correct checksum. */
static void forge(const char *line, const struct hawser_map_options *options)
{
	uint64_t sum = UINT64_C(14695981039346656037);
	char head[256] = "";
	FILE *stream = fopen(file, "r");

	ok(stream && fgets(head, sizeof head, stream), "a head");
	fclose(stream);
	for (const char *at = line; *at; at++)
		sum = (sum ^ (unsigned char)*at)*UINT64_C(1099511628211);
	stream = fopen(file, "w");
	fprintf(stream, "%s%s %08" PRIx32 "\n", head, line, (uint32_t)(sum ^ sum >> 32));
	fclose(stream);
	expect(HAWSER_ERR_IO, "is damaged in line 2", options);
}

static void forgeries(const struct hawser_map_options *options)
{
	static const char *const line[] = {
		"0 0 3ff0000000000000 3ff0000000000000", /* no value, and no marks */
		"7 0 3ff0000000000000 3ff0000000000000 3ff0000000000000",
		"-1 0 3ff0000000000000 3ff0000000000000 3ff0000000000000",
		"0 4294967296 3ff0000000000000 3ff0000000000000 3ff0000000000000",
		"0 0 7ff8000000000000 3ff0000000000000 3ff0000000000000",
		"0 0 8000000000000000 3ff0000000000000 3ff0000000000000",
		"0 0 3ff000000000000 3ff00000000000000 3ff0000000000000",
		"0 0 -ff0000000000000 3ff0000000000000 3ff0000000000000"};

	for (size_t k = 0; k < sizeof line/sizeof *line; k++)
		forge(line[k], options);
}

static void guards(const struct hawser_map *whole)
{
	struct hawser_map_options options = range(1), other;
	struct hawser_map map;
	int status, looked = 0;
	FILE *stream;

	options.checkpoint = file;
	cut(whole, 5000);
	cut(whole, 30);
	cut(whole, 0);
	unlink(file);
	options.progress = (struct hawser_progress){look_at_lock, &looked};
	status = trace(&map, &options, NULL);
	ok(!status && looked && same_maps(whole, &map), "the first one is not disturbed");
	hawser_map_clear(&map);
	options.progress.function = NULL;
	other = options, other.to[1] = 0.7;
	expect(HAWSER_ERR_ARGUMENT, "of other ranges or settings", &other);
	D[0] = 0.021;
	expect(HAWSER_ERR_ARGUMENT, "of another scene, quantity or pair of axes", &options);
	D[0] = 0.02;
	overwrite(700, '#');
	expect(HAWSER_ERR_IO, "is damaged in line", &options);
	forgeries(&options);
	stream = fopen(file, "w");
	fputs("Omega\tvalue\n1\t2\n", stream);
	fclose(stream);
	expect(HAWSER_ERR_ARGUMENT, "is no checkpoint of a map", &options);
	options.checkpoint = "no/such/folder/file";
	expect(HAWSER_ERR_IO, "cannot open the checkpoint no/such/folder/file", &options);
	options.checkpoint = "/dev/null";
	expect(HAWSER_ERR_IO, "the checkpoint /dev/null is no regular file", &options);
	unlink(file);
}

CASE(property_map_threads)
{
	struct hawser_map_options options = range(1);
	struct hawser_map one;
	struct hawser_report report = {.status = HAWSER_OK};
	int status = trace(&one, &options, &report);

	if (!ok(!status && one.boundaries > 50, "one thread: %d boundary points %s", one.boundaries,
	        report.message))
		return done_testing();
	threads(&one);
	scenes();
	interrupted(&one);
	guards(&one);
	hawser_map_clear(&one);
	return done_testing();
}
