/* The cells of a map: computed points, interpolated points, and the location of boundaries.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "tests/map-fields.h"
#include "tests/tap.h"

static const struct hawser_map_point *at(const struct hawser_map *map, int i, int j)
{
	return &map->point[(long)j*map->nx + i];
}

/* Every point has the value of the field, interpolated ones within `error`. */
static void check_nodes(const struct hawser_map *map, const struct hawser_map_field *field,
                        double error, const char *what)
{
	int wrong = 0, inexact = 0, computed = 0;
	double worst = 0.0;

	for (int j = 0; j < map->ny; j++)
		for (int i = 0; i < map->nx; i++) {
			const struct hawser_map_point *got = at(map, i, j);
			struct hawser_map_sample want;

			if (field->point(NULL, &want, NULL, map->x[i], map->y[j], NULL))
				wrong++;
			wrong += want.code != got->sample.code || want.number != got->sample.number;
			inexact += got->computed && want.value != got->sample.value;
			computed += got->computed;
			worst = fmax(worst, fabs(want.value - got->sample.value));
		}
	ok(wrong == 0, "%s: number and code are right at all %d nodes", what, map->nx*map->ny);
	ok(inexact == 0, "%s: %d computed nodes are exact", what, computed);
	ok(worst <= error, "%s: interpolated ones within %g: %g", what, error, worst);
}

static void circles(int nx, int ny, int coarse)
{
	struct hawser_map_field field = circle();
	struct hawser_map_options options = square(nx, ny);
	struct hawser_map map;
	char what[80];
	double worst = 0.0, wide = 0.0;
	int right = 0;

	options.coarse = coarse;
	options.tolerance = 1e-9;
	snprintf(what, sizeof what, "%dx%d, cells of %d", nx, ny, coarse);
	if (!ok(hawser_map_trace(&map, &field, &options, NULL) == HAWSER_OK, "%s is traced", what))
		return;
	/* the cone's tip may lie in the middle of a first cell: half of its diagonal */
	check_nodes(&map, &field, coarse == 1 ? 0.0 : coarse*hypot(1.0/(nx - 1), 1.0/(ny - 1)), what);
	for (int k = 0; k < map.boundaries; k++) {
		const struct hawser_map_boundary *b = &map.boundary[k];
		int gone = b->code[0] != b->code[1];
		double off = gone ? b->x - 0.8 : hypot(b->x - 0.13, b->y + 0.07) - 0.61;

		/* where a line touches the circle, the position of the crossing is ill-conditioned */
		if (gone || fabs(b->along == 0 ? b->x - 0.13 : b->y + 0.07) > 0.05)
			worst = fmax(worst, fabs(off));
		wide = fmax(wide, b->width);
		right += gone ? b->code[0] == HAWSER_MAP_OK : b->number[0] != b->number[1];
	}
	ok(map.boundaries > 0 && worst <= 2.1e-9 && wide <= 2.1e-9,
	   "%s: %d boundary points within the tolerance: %g, brackets %g", what, map.boundaries, worst,
	   wide);
	ok(right == map.boundaries, "%s: both sides are told", what);
	ok(map.segments > 20, "%s: %d pieces of line", what, map.segments);
	ok(strcmp(map.reason[HAWSER_MAP_NO_STATE], "") != 0 && map.count[HAWSER_MAP_NO_STATE] > 0,
	   "%s: why points have no value: %s", what, map.reason[HAWSER_MAP_NO_STATE]);
	hawser_map_clear(&map);
}

static void thrift(void)
{
	struct hawser_map_field field = circle();
	struct hawser_map_options options = square(257, 257);
	struct hawser_map map;
	enum hawser_status status;
	int computed = 0;

	options.tolerance = 0.1;
	options.jump = HAWSER_NONE;
	status = hawser_map_trace(&map, &field, &options, NULL);
	for (int p = 0; !status && p < 257*257; p++)
		computed += map.point[p].computed;
	/* 33x33 at first; about 257 columns of the line and 500 fine cells of the circle, 3 levels down */
	ok(!status && computed < 6000, "a map of 66049 nodes computes %d of them", computed);
	hawser_map_clear(&map);
}

/* If a boundary crosses a coarse cell only near its edge, it is followed through the neighbours. */
static enum hawser_status thread_point(void *worker, struct hawser_map_sample *sample, double *marks,
                                       double x, double y, struct hawser_report *report)
{
	int in = fabs(y - 0.4*sin(4.0*x)) < 0.04;

	(void)worker;
	(void)marks;
	(void)report;
	*sample = (struct hawser_map_sample){in, in, HAWSER_MAP_OK};
	return HAWSER_OK;
}

static void winding(void)
{
	struct hawser_map_field field = {.name = "thread", .identity = "thread", .open = field_open,
		.close = field_close, .point = thread_point};
	struct hawser_map_options options = square(129, 129);
	struct hawser_map map;
	enum hawser_status status;

	options.coarse = 16; /* cells of 0.25: the band of width 0.08 lies between corners in some
	                      * places */
	status = hawser_map_trace(&map, &field, &options, NULL);
	ok(!status, "a winding band is traced");
	if (!status)
		check_nodes(&map, &field, 0.0, "a winding band");
	hawser_map_clear(&map);
}

static void narrow(void)
{
	struct hawser_map_field field = wedge();
	struct hawser_map_options options = square(65, 65);
	struct hawser_map map;
	enum hawser_status status;
	double worst = 0.0;
	int across = 0;

	options.tolerance = 1e-10;
	status = hawser_map_trace(&map, &field, &options, NULL);
	for (int k = 0; !status && k < map.boundaries; k++) {
		const struct hawser_map_boundary *b = &map.boundary[k];

		across += b->along == 0;
		worst = fmax(worst, fabs(fabs(b->x - 0.311) - 0.002*b->y*b->y));
	}
	ok(!status && across == 2*64, "a wedge narrower than any cell is met on every row but that of "
	   "its tip: %d points", across);
	ok(worst < 1e-9, "and its sides are placed: %g", worst);
	hawser_map_clear(&map);
	field.exponents = 0;
	status = hawser_map_trace(&map, &field, &options, NULL);
	ok(!status && map.boundaries == 0, "without its exponents it would have been missed");
	hawser_map_clear(&map);
}

/* Growth counts beyond 1e-3, and has the error error[1], of which error[0] is round-off that varies
 * between points. The growth crosses 0 on x = 0.137 + 0.3 y, with a varying slope. */
static enum hawser_status slow_point(void *worker, struct hawser_map_sample *sample, double *marks,
                                     double x, double y, struct hawser_report *report)
{
	const double *error = worker;
	double off = x - 0.137 - 0.3*y, g = off*(0.9 - 0.4*off) + error[0]*sin(1e9*x);

	(void)report;
	*sample = (struct hawser_map_sample){g, g > 1e-3, HAWSER_MAP_OK};
	if (marks) {
		marks[0] = g - error[1];
		marks[1] = g + error[1];
	}
	return HAWSER_OK;
}

/* Distances of boundary points from the line of no growth, in units of the brackets. */
static void slow_boundaries(double tolerance, double *error, double widest, const char *what)
{
	struct hawser_map_field field = {.name = "slow", .identity = "slow", .marks = 2, .margins = 1,
		.open = field_open, .close = field_close, .point = slow_point, .context = error};
	struct hawser_map_options options = square(33, 33);
	struct hawser_map map;
	enum hawser_status status;
	double worst = 0.0, wide = 0.0;
	int across = 0;

	options.tolerance = tolerance;
	status = hawser_map_trace(&map, &field, &options, NULL);
	for (int k = 0; !status && k < map.boundaries; k++) {
		const struct hawser_map_boundary *b = &map.boundary[k];
		double off = b->along == 0 ? fabs(b->x - 0.137 - 0.3*b->y)
		                           : fabs(b->y - (b->x - 0.137)/0.3);

		across++;
		worst = fmax(worst, off/b->width);
		wide = fmax(wide, b->width);
	}
	hawser_map_clear(&map);
	ok(!status && across > 30 && worst <= 0.5 + 1e-9, "%s, tolerance %g: %d boundaries of growth "
	   "lie within their brackets: %g of them", what, tolerance, across, worst);
	ok(wide <= widest, "%s: which are at most %g wide", what, wide);
}

static void doubtful(void)
{
	double exact[2] = {0.0, 0.0}, known[2] = {0.0, 1e-5}, rough[2] = {1e-4, 1.1e-4};

	for (double tolerance = 1e-2; tolerance > 1e-12; tolerance *= 1e-3) {
		/* the width of the growth that does not count, along the flatter axis, or the tolerance */
		slow_boundaries(tolerance, exact, 2.1*tolerance + 6e-3, "growth not counted");
		slow_boundaries(tolerance, known, 2.1*tolerance + 7e-3, "with a known error");
		slow_boundaries(tolerance, rough, 2.1*tolerance + 0.02, "with round-off");
	}
}

static enum hawser_status broken_point(void *worker, struct hawser_map_sample *sample, double *marks,
                                       double x, double y, struct hawser_report *report)
{
	(void)worker;
	(void)marks;
	*sample = (struct hawser_map_sample){0.0, 0, HAWSER_MAP_OK};
	if (x < 0.5)
		return HAWSER_OK;
	report->status = HAWSER_ERR_MEMORY;
	snprintf(report->message, sizeof report->message, "no memory at %g, %g", x, y);
	return HAWSER_ERR_MEMORY;
}

static void refuse(const struct hawser_map_options *options, const char *message)
{
	struct hawser_map_field field = circle();
	struct hawser_report report = {.status = HAWSER_OK};
	struct hawser_map map;
	enum hawser_status status = hawser_map_trace(&map, &field, options, &report);

	ok(status == HAWSER_ERR_ARGUMENT && strstr(report.message, message), "refused: %s",
	   report.message);
	hawser_map_clear(&map);
}

static void refusals(void)
{
	struct hawser_map_field field = circle();
	struct hawser_map_options options = square(9, 9), wrong;
	struct hawser_report report = {.status = HAWSER_OK};
	struct hawser_map map;
	enum hawser_status status;

	wrong = options, wrong.from[1] = 1.0;
	refuse(&wrong, "range of y from 1 to 1");
	wrong = options, wrong.to[0] = NAN;
	refuse(&wrong, "range of x");
	wrong = options, wrong.points[0] = 1;
	refuse(&wrong, "1 points along x");
	wrong = options, wrong.points[1] = 20001;
	refuse(&wrong, "20001 points along y");
	wrong = options, wrong.coarse = -1;
	refuse(&wrong, "coarse -1");
	wrong = options, wrong.tolerance = -1e-4;
	refuse(&wrong, "tolerance -0.0001");
	field.point = broken_point;
	options.threads = 2;
	status = hawser_map_trace(&map, &field, &options, &report);
	ok(status == HAWSER_ERR_MEMORY && strcmp(report.message, "no memory at 1, -1") == 0,
	   "a point's failure ends the map: %s", report.message);
	hawser_map_clear(&map);
	hawser_map_clear(&map);
	hawser_map_clear(NULL);
	ok(strcmp(hawser_map_code_name(HAWSER_MAP_NO_STATE), "no-state") == 0 &&
	   strcmp(hawser_map_code_name((enum hawser_map_code)99), "unknown") == 0, "codes have names");
}

CASE(unit_map)
{
	circles(65, 65, 8);
	circles(65, 65, 1);
	circles(50, 37, 8);
	circles(38, 70, 3);
	thrift();
	winding();
	narrow();
	doubtful();
	refusals();
	return done_testing();
}
