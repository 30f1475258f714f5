/* tow/read_path.c - read the section `tow`: waypoints, file, speed or orbit, and what goes with
 * each. SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdio.h>
#include <string.h>

#include "tow/read.h"
#include "tow/trajectory.h"

enum { WAYPOINTS, FILE_OF, SPEED, ORBIT, WAYS };
static const char *const way_name[WAYS] = {"waypoints", "file", "speed", "orbit"};

/* A key of the section, and the ways to give a path for which it is (bits). */
static const struct {
	const char *key, *of;
	unsigned ways;
} rule[] = {
	{"minimise", "waypoints and files", 1u << WAYPOINTS | 1u << FILE_OF},
	{"ends", "waypoints and files", 1u << WAYPOINTS | 1u << FILE_OF},
	{"start", "straight flight (speed)", 1u << SPEED},
	{"ramp", "straight flight (speed) and orbits", 1u << SPEED | 1u << ORBIT},
	{"law", "straight flight (speed) and orbits", 1u << SPEED | 1u << ORBIT},
};

/* The one way in which the path is given. */
static enum hawser_status choose(struct hawser__reader *reader, int *way,
                                 const struct hawser__tree *tree)
{
	enum hawser_status status = HAWSER_OK;
	int found = -1;

	for (int k = 0; k < WAYS && !status; k++) {
		const struct hawser__tree *one = hawser__tree_find(tree, way_name[k]);

		if (one && found >= 0)
			status = hawser__reader_fail(reader, &one->at, "tow has %s and %s: give one of "
			                             "waypoints, file, speed and orbit", way_name[found],
			                             way_name[k]);
		if (one)
			found = k;
	}
	if (!status && found < 0)
		status = hawser__reader_fail(reader, &tree->at, "tow has no path: give waypoints, file, "
		                             "speed or orbit, for example orbit: {radius: 100 m, "
		                             "speed: 20 m/s}");
	for (size_t k = 0; k < sizeof rule/sizeof *rule && !status; k++) {
		const struct hawser__tree *one = hawser__tree_find(tree, rule[k].key);

		if (one && !(rule[k].ways & 1u << found))
			status = hawser__reader_fail(reader, &one->at, "tow.%s is of %s, and the path is given "
			                             "by %s: remove one of them", rule[k].key, rule[k].of,
			                             way_name[found]);
	}
	*way = found;
	return status;
}

/* The places of waypoints, for what the path says of one of them. */
static const struct hawser__mark *place_of(const struct hawser__tree *tree, int index)
{
	const struct hawser__tree *list = hawser__tree_find(tree, "waypoints");
	const struct hawser__tree *one = list ? list->child : NULL;

	for (; one && index > 0; index--)
		one = one->next;
	return one && index == 0 ? &one->at : list ? &list->at : &tree->at;
}

static enum hawser_status through(struct hawser__reader *reader, struct hawser_tow *tow,
                                  const struct hawser__tree *tree, enum hawser_minimise minimise)
{
	const struct hawser__tree *ends = hawser__tree_find(tree, "ends");
	struct hawser_report report = {.iteration = -1};
	enum hawser_status status = ends ? hawser__tow_ends(reader, tow, ends) : HAWSER_OK;

	if (status)
		return status;
	status = hawser_path_waypoints(&tow->path, tow->waypoint, tow->waypoints,
	                                     minimise, &report);
	if (status == HAWSER_ERR_ARGUMENT || status == HAWSER_ERR_CONVERGENCE) {
		(void)hawser__reader_fail(reader, place_of(tree, report.iteration), "tow: %s", report.message);
		return status == HAWSER_ERR_ARGUMENT ? HAWSER_ERR_SCENE : status;
	}
	if (status)
		*reader->report = report;
	return status;
}

enum hawser_status hawser__tow_file(struct hawser__reader *reader, struct hawser_waypoint **point,
                                    int *count, const struct hawser__tree *one, const char *key)
{
	const char *text, *slash = one->at.set ? NULL : strrchr(reader->name, '/');
	char path[4096]; /* the longest path that Linux opens */
	enum hawser_status status = hawser__tree_text(reader, &text, one, key);

	if (status)
		return status;
	snprintf(path, sizeof path, "%.*s%s", slash && *text != '/' ? (int)(slash + 1 - reader->name) : 0,
	         reader->name, text);
	return hawser__path_read(point, count, path, reader->report);
}

enum hawser_status hawser__tow_path(struct hawser__reader *reader, struct hawser_tow *tow,
                                    const struct hawser__tree *tree)
{
	const struct hawser__tree *law = hawser__tree_find(tree, "law");
	struct hawser__tow_flight flight = {.ramp = 0.0};
	enum hawser_path_ramp ramp;
	int way = 0;
	enum hawser_status status = hawser__tree_fill(reader, &flight, tree, "tow", "tow.tow");

	if (!status)
		status = choose(reader, &way, tree);
	if (!status && law && flight.ramp == 0.0)
		status = hawser__reader_fail(reader, &law->at, "tow.law is how the speed grows in a ramp: "
		                             "give tow.ramp, the time in which it does, such as ramp: 32 s");
	if (status)
		return status;
	tow->clamped = flight.clamped;
	ramp = (enum hawser_path_ramp)flight.law;
	if (way == SPEED)
		return hawser_path_straight(&tow->path, flight.start, flight.velocity, flight.ramp, ramp,
		                            reader->report);
	if (way == ORBIT)
		return hawser_path_orbit(&tow->path, flight.centre, flight.radius, flight.speed, flight.ramp,
		                         ramp, reader->report);
	status = way == WAYPOINTS
	         ? hawser__tow_waypoints(reader, tow, hawser__tree_find(tree, "waypoints"))
	         : hawser__tow_file(reader, &tow->waypoint, &tow->waypoints,
	                            hawser__tree_find(tree, "file"), "tow.file");
	return status ? status : through(reader, tow, tree, (enum hawser_minimise)flight.minimise);
}
