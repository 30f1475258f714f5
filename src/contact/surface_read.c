/* contact/surface_read.c - read the section `obstacles`: planes, segments, circles and
 * profiles, which become segments and, at corners that point upwards, circles between them: on a sharp
 * corner the tensions of a mesh depend on where its nodes are, whatever their number.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "contact/surface_read.h"
#include "core/report.h"

/* Of a corner, rad: less is none. */
static const double FLAT = 1e-6;
enum { CALLED = HAWSER__TEXT_ROOM + 64, MOST = 100 }; /* obstacles: each node may touch each of them */

/* What a shape does not have. */
static enum hawser_status fits(struct hawser__reader *reader, const struct hawser_surface *surface,
                               const struct hawser__tree *tree, const char *section)
{
	const struct hawser__tree *side = hawser__tree_find(tree, "side");
	const struct hawser__tree *groove = hawser__tree_find(tree, "groove");
	const struct hawser__tree *velocity = hawser__tree_find(tree, "velocity");
	int plane = surface->kind == HAWSER_SURFACE_PLANE;

	if (side && plane)
		return hawser__reader_fail(reader, &side->at, "%s.side: the free side of a plane is that of "
		                           "its normal: leave side out", section);
	if (groove && (surface->kind != HAWSER_SURFACE_CIRCLE || surface->side == HAWSER_SIDE_INSIDE))
		return hawser__reader_fail(reader, &groove->at, "%s.groove: a groove is of circles that cables "
		                           "pass outside: leave it out", section);
	return !velocity || plane == (velocity->kind == HAWSER__SEQUENCE) ? HAWSER_OK
		: hawser__reader_fail(reader, &velocity->at, "%s.velocity must be %s in m/s", section,
		                      plane ? "a list [x, y, z]" : "a single number");
}

static enum hawser_status obstacle(struct hawser__reader *reader, struct hawser_surface *all,
                                   int number, const struct hawser__tree *tree)
{
	struct hawser_surface *surface = &all[number];
	struct hawser_report report = {0};
	char section[CALLED];
	enum hawser_status status = hawser__tree_name_item(reader, surface->name, sizeof *surface, number,
	                                                   tree, "obstacles", 's');

	snprintf(section, sizeof section, "obstacles.%s", surface->name);
	if (!status)
		status = hawser__tree_fill(reader, surface, tree, section, "net.obstacles[]");
	if (!status)
		status = fits(reader, surface, tree, section);
	if (!status && surface->kind != HAWSER_SURFACE_PROFILE && hawser_surface_settle(surface, &report))
		status = hawser__reader_fail(reader, &tree->at, "%s.%s", section, report.message);
	return status;
}

struct profile {
	struct hawser__reader *reader;
	const struct hawser__tree *tree; /* of its points */
	struct hawser_surface of;        /* name, friction, speed */
	struct hawser_surface *all;
	int *count;
	int piece;
};

static enum hawser_status add(struct profile *to, enum hawser_surface_kind kind, const double at[2],
                              const double end[2], double radius)
{
	struct hawser_surface *surface = &to->all[(*to->count)++];
	struct hawser_report report = {0};

	*surface = to->of;
	surface->kind = kind;
	snprintf(surface->name, sizeof surface->name, "%.24s.%d", to->of.name, to->piece++);
	memcpy(surface->at, at, 2*sizeof *at);
	memcpy(surface->to, end, 2*sizeof *end);
	surface->radius = radius;
	if (kind == HAWSER_SURFACE_CIRCLE) /* counterclockwise is to the left on its top */
		surface->speed = -surface->speed;
	return !hawser_surface_settle(surface, &report) ? HAWSER_OK
		: hawser__reader_fail(to->reader, &to->tree->at, "obstacles.%s.%s", to->of.name,
		                      report.message);
}

/* From the point p on to q, where the one after is r (or NULL): the segment, and the circle at q.
 * from: where the segment begins, then the next one. */
static enum hawser_status edge(struct profile *to, double from[2], const double p[2], const double q[2],
                               const double *r, double round)
{
	double e[2] = {q[0] - p[0], q[1] - p[1]}, f[2] = {0.0}, l = hypot(e[0], e[1]), m = 0.0, end[2];
	double turn = 0.0, b = 0.0, radius, centre[2];
	enum hawser_status status;

	if (r) {
		f[0] = r[0] - q[0];
		f[1] = r[1] - q[1];
		m = hypot(f[0], f[1]);
		turn = atan2(e[1]*f[0] - e[0]*f[1], e[0]*f[0] + e[1]*f[1]);
	}
	if (turn > FLAT)
		b = fmin(round, 0.5*fmin(l, m));
	for (int k = 0; k < 2; k++)
		end[k] = q[k] - b*e[k]/l;
	status = add(to, HAWSER_SURFACE_SEGMENT, from, end, 0.0);
	if (!status && b > 0.0) {
		radius = b/tan(0.5*turn);
		centre[0] = end[0] + radius*e[1]/l;
		centre[1] = end[1] - radius*e[0]/l;
		status = add(to, HAWSER_SURFACE_CIRCLE, centre, end, radius);
	}
	for (int k = 0; k < 2; k++)
		from[k] = q[k] + (b > 0.0 ? b*f[k]/m : 0.0);
	return status;
}

static enum hawser_status profile(struct profile *to, double round)
{
	int points = to->tree->children;
	double (*x)[2] = calloc((size_t)points + 1, sizeof *x), from[2];
	char what[CALLED];
	enum hawser_status status = x ? HAWSER_OK : hawser__no_memory(to->reader->report, "scene");
	int i = 0;

	snprintf(what, sizeof what, "obstacles.%s.profile", to->of.name);
	if (!status && (to->tree->kind != HAWSER__SEQUENCE || points < 2))
		status = hawser__reader_fail(to->reader, &to->tree->at, "%s must be a list of two or more "
		                             "places, such as [[0 m, -200 m], [800 m, -210 m]]", what);
	for (const struct hawser__tree *one = status ? NULL : to->tree->child; one && !status;
	     one = one->next, i++) {
		status = hawser__tree_vector(to->reader, x[i], 2, one, what, "m");
		if (!status && i > 0 && !(x[i][0] > x[i - 1][0]))
			status = hawser__reader_fail(to->reader, &one->at, "%s: x must rise from place to place",
			                             what);
	}
	if (!status)
		memcpy(from, x[0], sizeof from);
	for (i = 1; i < points && !status; i++)
		status = edge(to, from, x[i - 1], x[i], i + 1 < points ? x[i + 1] : NULL, round);
	free(x);
	return status;
}

/* Room for the pieces of profiles too. */
static int enlarge(struct hawser_surface **surface, const struct hawser__tree *tree)
{
	size_t room = (size_t)tree->children + 1;
	void *more;

	for (const struct hawser__tree *one = tree->child; one; one = one->next) {
		const struct hawser__tree *points = hawser__tree_find(one, "profile");

		room += points ? 2*(size_t)points->children : 0;
	}
	more = realloc(*surface, room*sizeof **surface);
	if (!more)
		return 0;
	*surface = more;
	memset(more, 0, room*sizeof **surface);
	return 1;
}

enum hawser_status hawser__surfaces_read(struct hawser__reader *reader, struct hawser_surface **surface,
                                         int *count, const struct hawser__tree *tree, double round)
{
	enum hawser_status status;

	*surface = hawser__tree_items(reader, &status, tree, "obstacles", sizeof **surface, 1, MOST,
	                              "{plane: {point: [0, 0], normal: [0, 1]}, friction: 0.5}");
	if (!status && !enlarge(surface, tree))
		status = hawser__no_memory(reader->report, "scene");
	for (const struct hawser__tree *one = status ? NULL : tree->child; one && !status;
	     one = one->next) {
		const struct hawser__tree *points = hawser__tree_find(one, "profile");

		status = obstacle(reader, *surface, *count, one);
		if (!status && points) {
			struct profile to = {.reader = reader, .tree = points, .of = (*surface)[*count],
			                     .all = *surface, .count = count, .piece = 1};

			status = profile(&to, round);
		} else {
			*count += !status;
		}
	}
	if (!status && *count > MOST)
		status = hawser__reader_fail(reader, &tree->at, "obstacles: %d planes, segments and circles "
		                             "are more than %d: give fewer places of profiles", *count, MOST);
	return status;
}
