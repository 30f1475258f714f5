/* Maps of amplitudes by rows: an asymmetric Duffing oscillator, whose responses are those of a harmonic
 * balance that shares no code; the folds of a row are those of the response at that load; the same map
 * along the other axis; and the same bytes with other threads, or after an interruption.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <time.h>
#include <unistd.h>

#include <hawser/hawser.h>

#include "rom/build/model.h"
#include "tests/map-responses.h"
#include "tests/tap.h"

enum { NX = 15, NY = 8 };
static const char file[] = "test-map-rows.checkpoint";
static const struct oscillator asymmetric = {0.047, 0.21, 0.23, 0.083};

static int model(struct hawser_rom *rom, const struct oscillator *of)
{
	if (hawser__rom_init(rom, 1, NULL))
		return 1;
	rom->K[0] = 1.0;
	rom->D[0] = of->d;
	rom->Q = calloc(1, sizeof *rom->Q);
	rom->Q[0] = (struct hawser_quad){0, 0, 0, of->q};
	rom->quads = 1;
	rom->C = calloc(1, sizeof *rom->C);
	rom->C[0] = (struct hawser_cubic){0, 0, 0, 0, of->c};
	rom->cubics = 1;
	rom->harmonics = 1;
	rom->harmonic = calloc(1, sizeof *rom->harmonic);
	rom->harmonic[0] = (struct hawser_harmonic){.k = 1, .f = calloc(1, sizeof(double))};
	rom->harmonic[0].f[0] = of->f;
	return hawser_rom_compile(rom, NULL) != HAWSER_OK;
}

static struct hawser_map_options range(int swapped)
{
	struct hawser_map_options options = {.threads = 1};

	options.from[swapped] = 0.62;
	options.to[swapped] = 1.53;
	options.from[1 - swapped] = 0.4;
	options.to[1 - swapped] = 2.6;
	options.points[swapped] = NX;
	options.points[1 - swapped] = NY;
	return options;
}

static enum hawser_status (*own_row)(void *, struct hawser__map_row *, struct hawser_report *);

/* A row that takes long enough to be interrupted. */
static enum hawser_status slow_row(void *worker, struct hawser__map_row *row,
                                   struct hawser_report *report)
{
	const struct timespec pause = {.tv_nsec = 40000000};

	nanosleep(&pause, NULL);
	return own_row(worker, row, report);
}

static enum hawser_status trace(struct hawser_map *map, const struct hawser_rom *rom, int swapped,
                                const struct hawser_map_options *options,
                                struct hawser_report *report)
{
	struct hawser_map_source source = {.rom = rom, .quantity = "amplitude"};
	struct hawser_map_field field;
	enum hawser_status status;

	source.key[swapped] = "Omega";
	source.key[1 - swapped] = "factor.load";
	status = hawser_map_cable_open(&field, &source, report);
	*map = (struct hawser_map){.nx = 0};
	own_row = field.row;
	if (options->progress.function)
		field.row = slow_row;
	if (!status)
		status = hawser_map_trace(map, &field, options, report);
	hawser_map_cable_close(&field);
	return status;
}

/* Cells within this distance of a fold have two responses that nearly coincide. */
static void every_cell(const struct hawser_map *map)
{
	double worst = 0.0;
	int compared = 0, several = 0, wrong = 0, cells = 0, step = getenv("HAWSER_LONG") ? 1 : 2;

	/* without HAWSER_LONG as on a chessboard */
	for (int j = 0; j < NY; j++)
		for (int i = j%step; i < NX; i += step) {
			struct oscillator of = asymmetric;
			double least, most, apart;
			int count, place = j*NX + i;

			cells++;
			of.f *= map->y[j];
			count = responses(&least, &most, &apart, &of, map->x[i]);
			if (apart < 0.03)
				continue;
			compared++;
			several += count == 3;
			wrong += map->branches[place] != count || map->stable[place] != (count + 1)/2 ||
			         map->point[place].sample.code != HAWSER_MAP_OK ||
			         map->point[place].sample.value != map->most[place];
			worst = fmax(worst, fmax(fabs(map->least[place]/least - 1.0),
			                         fabs(map->most[place]/most - 1.0)));
		}
	ok(compared >= cells - 4, "%d of %d cells are away from folds", compared, cells);
	ok(several > 10, "%d cells have three responses", several);
	ok(wrong == 0, "the numbers of responses and of stable ones are those of harmonic balance (%d "
	   "are not)", wrong);
	ok(worst < 2e-6, "and so are the smallest and the largest amplitude, to %.1e", worst);
}

/* From the last point of a response, at the end of the range, the same events are found from behind. */
static void back_again(const struct hawser_frf *there, const struct hawser_rom *rom,
                       struct hawser_frf_options options)
{
	const struct hawser_frf_point *last = &there->point[there->points - 1];
	struct hawser_report report = {.status = HAWSER_OK};
	struct hawser_frf back;
	double worst = 0.0;

	options.begin = last->omega;
	options.direction = -last->direction;
	options.start = there->state + 2*(size_t)(there->points - 1);
	if (hawser_frf_trace(&back, rom, &options, &report)) {
		ok(0, "a response is traced back: %s", report.message);
		hawser_frf_clear(&back);
		return;
	}
	for (int e = 0; e < there->events && back.events == there->events; e++)
		worst = fmax(worst, fabs(back.event[back.events - 1 - e].omega - there->event[e].omega));
	ok(back.events == there->events && worst < 1e-8 && last->omega == options.to,
	   "traced back from its last point it has the same %d events, to %.1e", back.events, worst);
	hawser_frf_clear(&back);
}

/* The folds of the row are those of the response that is traced at this load. */
static void row_is_response(const struct hawser_map *map, struct hawser_rom *rom)
{
	struct hawser_frf_options options = {.from = 0.62, .to = 1.53, .samples = HAWSER_NONE};
	const int j = 5;
	struct hawser_frf frf;
	double worst = 0.0, was = rom->harmonic[0].f[0];
	int folds = 0, matched = 0;

	rom->harmonic[0].f[0] *= map->y[j];
	if (hawser_frf_trace(&frf, rom, &options, NULL)) {
		ok(0, "the response is traced");
		return;
	}
	for (int e = 0; e < frf.events; e++) {
		double nearest = INFINITY;

		folds += frf.event[e].kind == HAWSER_FOLD;
		for (int b = 0; b < map->boundaries; b++)
			if (map->boundary[b].y == map->y[j])
				nearest = fmin(nearest, fabs(map->boundary[b].x - frf.event[e].omega));
		worst = fmax(worst, nearest);
	}
	for (int b = 0; b < map->boundaries; b++)
		matched += map->boundary[b].y == map->y[j];
	ok(folds == 2 && matched == frf.events && worst < 1e-8,
	   "the boundaries of a row are the %d events of its response, to %.1e", frf.events, worst);
	back_again(&frf, rom, options);
	hawser_frf_clear(&frf);
	rom->harmonic[0].f[0] = was;
}

static int equal(const struct hawser_map *a, const struct hawser_map *b)
{
	size_t points = (size_t)a->nx*(size_t)a->ny;

	return a->nx == b->nx && a->ny == b->ny && a->boundaries == b->boundaries &&
	       memcmp(a->least, b->least, points*sizeof(double)) == 0 &&
	       memcmp(a->most, b->most, points*sizeof(double)) == 0 &&
	       memcmp(a->branches, b->branches, points*sizeof(int)) == 0;
}

static int stop_after(void *data, const struct hawser_progress_state *state)
{
	(void)data;
	return state->done > 0;
}

static void interrupted(const struct hawser_map *whole, const struct hawser_rom *rom)
{
	struct hawser_map_options options = range(0);
	struct hawser_map map;

	unlink(file);
	options.checkpoint = file;
	options.progress = (struct hawser_progress){stop_after, NULL};
	if (trace(&map, rom, 0, &options, NULL))
		ok(0, "the first part is computed");
	else
		ok(map.interrupted && map.visited > 0 && map.visited < NX*NY,
		   "a map is interrupted after %ld points", map.visited);
	hawser_map_clear(&map);
	options.progress.function = NULL;
	options.threads = 3;
	if (trace(&map, rom, 0, &options, NULL))
		ok(0, "the rest is computed");
	else
		ok(equal(&map, whole) && !map.interrupted, "and continued by three threads to the same "
		   "result");
	hawser_map_clear(&map);
	if (trace(&map, rom, 0, &options, NULL))
		ok(0, "the map is read");
	else
		ok(equal(&map, whole) && map.restored == NX*NY, "the file has all of it");
	hawser_map_clear(&map);
	unlink(file);
}

static void transposed(const struct hawser_map *whole, const struct hawser_rom *rom)
{
	struct hawser_map_options options = range(1);
	struct hawser_map map;
	int differ = 0;

	if (trace(&map, rom, 1, &options, NULL)) {
		ok(0, "the transposed map is computed");
		return;
	}
	for (int j = 0; j < NY; j++)
		for (int i = 0; i < NX; i++)
			differ += map.most[i*NY + j] != whole->most[j*NX + i] ||
			          map.branches[i*NY + j] != whole->branches[j*NX + i];
	ok(differ == 0 && map.boundaries == whole->boundaries && map.boundary[0].along == 1,
	   "with exchanged axes the map is transposed");
	hawser_map_clear(&map);
}

/* Over the load instead of Omega the responses at the same points are the same. */
static void over_load(const struct hawser_map *whole, const struct hawser_rom *rom)
{
	struct hawser_map_options options = range(0);
	struct hawser_rom_family family;
	struct hawser_frf_options choice = {.samples = HAWSER_NONE, .from = options.from[1],
	                                    .to = options.to[1]};
	struct hawser_frf frf;
	const int i = 10;

	choice.family = &family;
	if (hawser_factor_open(&family, rom, HAWSER_FACTOR_LOAD, whole->x[i], NULL)) {
		ok(0, "the family is opened");
		return;
	}
	if (hawser_frf_trace(&frf, rom, &choice, NULL))
		ok(0, "the response over the load is traced");
	else
		close_to(frf.coordinate[frf.points - 1], whole->least[(NY - 1)*NX + i], 1e-8,
		         "the response over the load ends at the motion of the map");
	hawser_frf_clear(&frf);
	hawser_factor_close(&family);
}

static void only_stable(const struct hawser_map *whole, const struct hawser_rom *rom)
{
	struct hawser_map_options options = range(0);
	struct hawser_map map;
	int differ = 0;

	options.only_stable = 1;
	if (trace(&map, rom, 0, &options, NULL)) {
		ok(0, "the map of stable responses is computed");
		return;
	}
	for (int p = 0; p < NX*NY; p++)
		differ += map.branches[p] != whole->stable[p] || map.most[p] != whole->most[p];
	ok(differ == 0, "of stable responses there are as many as are stable");
	hawser_map_clear(&map);
}

/* Omega is not positive in the first cells. */
static void refused(const struct hawser_rom *rom)
{
	struct hawser_map_options options = range(0);
	struct hawser_report report = {.status = HAWSER_OK};
	struct hawser_map map;

	options.from[0] = -0.25;
	options.to[0] = 0.5;
	options.points[0] = 4;
	options.points[1] = 2;
	if (trace(&map, rom, 0, &options, &report))
		ok(0, "a map from a negative Omega: %s", report.message);
	else
		ok(map.count[HAWSER_MAP_REFUSED] == 4 && map.count[HAWSER_MAP_OK] == 4 &&
		   strstr(map.reason[HAWSER_MAP_REFUSED], "it must be greater than zero"),
		   "points without a positive Omega are refused: %s", map.reason[HAWSER_MAP_REFUSED]);
	hawser_map_clear(&map);
	options.strict = 1;
	ok(trace(&map, rom, 0, &options, &report) == HAWSER_ERR_CONVERGENCE &&
	   strstr(report.message, "x = -0.25, y = 0.4 could not be computed (refused: "),
	   "and end a strict map: %s", report.message);
	hawser_map_clear(&map);
}

CASE(property_map_rows)
{
	struct hawser_map_options options = range(0);
	struct hawser_report report = {.status = HAWSER_OK};
	struct hawser_map map;
	struct hawser_rom rom;

	if (model(&rom, &asymmetric) || trace(&map, &rom, 0, &options, &report)) {
		ok(0, "the map is computed: %s", report.message);
		return done_testing();
	}
	ok(map.count[HAWSER_MAP_OK] == NX*NY && map.incomplete == 0, "every point has a value");
	every_cell(&map);
	row_is_response(&map, &rom);
	transposed(&map, &rom);
	interrupted(&map, &rom);
	over_load(&map, &rom);
	only_stable(&map, &rom);
	refused(&rom);
	hawser_map_clear(&map);
	hawser_rom_clear(&rom);
	return done_testing();
}
