/* tests/map-fields.h - fields with closed forms, and a limit on the memory of a map.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_TESTS_MAP_FIELDS_H
#define HAWSER_TESTS_MAP_FIELDS_H

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/map.h>

static inline enum hawser_status field_open(void **worker, void *context,
                                            struct hawser_report *report)
{
	(void)report;
	*worker = context;
	return HAWSER_OK;
}

static inline void field_close(void *worker)
{
	(void)worker;
}

/* A circle of radius 0.61 about (0.13, -0.07), with one instability inside. To the right of x = 0.8
 * there is no value. */
static inline enum hawser_status circle_point(void *worker, struct hawser_map_sample *sample,
                                              double *marks, double x, double y,
                                              struct hawser_report *report)
{
	double r = hypot(x - 0.13, y + 0.07);

	(void)worker;
	(void)marks;
	(void)report;
	*sample = (struct hawser_map_sample){0.61 - r, r < 0.61, HAWSER_MAP_OK};
	if (x > 0.8)
		*sample = (struct hawser_map_sample){0.0, 0, HAWSER_MAP_NO_STATE};
	if (report && x > 0.8)
		snprintf(report->message, sizeof report->message, "x = %g is beyond 0.8", x);
	return HAWSER_OK;
}

static inline struct hawser_map_field circle(void)
{
	return (struct hawser_map_field){.name = "circle", .identity = "circle", .open = field_open,
		.close = field_close, .point = circle_point};
}

/* A wedge |x - 0.311| < 0.002 y^2, which is nowhere as wide as a cell of the tests: the damped
 * tongue of one coordinate at 2 w = Omega = 1, w = 1/2 + r/2 with the detuning r = 0.1 (x - 0.311).
 * Its multipliers have equal arguments up to 0.03 from the middle, where growth is less than the
 * decay d. */
static inline enum hawser_status wedge_point(void *worker, struct hawser_map_sample *sample,
                                             double *marks, double x, double y,
                                             struct hawser_report *report)
{
	double half = 0.002*y*y, r = 0.1*(x - 0.311), c2 = 0.003*0.003 - r*r;
	double d = 0.5*sqrt(0.003*0.003 - 0.01*half*half), apart = 0.5*sqrt(fabs(c2));
	double inside = half - fabs(x - 0.311), more = c2 > 0.0 ? apart : 0.0;
	const double exponents[7] = {1.0, 0.5 + 0.5*r, 0.0, 2.0*M_PI*(more - d), -2.0*M_PI*(more + d),
		M_PI + (c2 > 0.0 ? 0.0 : copysign(2.0*M_PI*apart, r)),
		-M_PI - (c2 > 0.0 ? 0.0 : copysign(2.0*M_PI*apart, r))};

	(void)worker;
	(void)report;
	*sample = (struct hawser_map_sample){inside, inside > 0.0, HAWSER_MAP_OK};
	if (marks) {
		marks[0] = inside > 0.0 ? inside : INFINITY;
		marks[1] = inside > 0.0 ? -INFINITY : inside;
		memcpy(marks + 2, exponents, sizeof exponents);
	}
	return HAWSER_OK;
}

static inline struct hawser_map_field wedge(void)
{
	return (struct hawser_map_field){.name = "wedge", .identity = "wedge", .marks = 9, .margins = 1,
		.exponents = 1, .open = field_open, .close = field_close, .point = wedge_point};
}

/* Options over [-1, 1]^2. */
static inline struct hawser_map_options square(int nx, int ny)
{
	struct hawser_map_options options = {.coarse = 0};

	for (int k = 0; k < 2; k++) {
		options.from[k] = -1.0;
		options.to[k] = 1.0;
	}
	options.points[0] = nx;
	options.points[1] = ny;
	return options;
}

/* All results of two maps are equal to the last bit, except `restored`. */
static inline int same_maps(const struct hawser_map *a, const struct hawser_map *b)
{
	size_t nodes = (size_t)a->nx*(size_t)a->ny;

	if (a->nx != b->nx || a->ny != b->ny || a->boundaries != b->boundaries ||
	    a->segments != b->segments || a->visited != b->visited ||
	    memcmp(a->count, b->count, sizeof a->count) != 0 ||
	    memcmp(a->reason, b->reason, sizeof a->reason) != 0)
		return 0;
	for (size_t p = 0; p < nodes; p++) {
		const struct hawser_map_point *x = &a->point[p], *y = &b->point[p];

		if (memcmp(&x->sample.value, &y->sample.value, sizeof(double)) != 0 ||
		    x->sample.number != y->sample.number || x->sample.code != y->sample.code ||
		    x->computed != y->computed)
			return 0;
	}
	for (int k = 0; k < a->boundaries; k++)
		if (a->boundary[k].x != b->boundary[k].x || a->boundary[k].y != b->boundary[k].y ||
		    a->boundary[k].width != b->boundary[k].width)
			return 0;
	return a->segments == 0 ||
	       memcmp(a->segment, b->segment, (size_t)a->segments*4*sizeof(double)) == 0;
}

#endif
