/* study/hill.h - the parts of boundaries by continuation: test functions (hill_test.c), steps
 * (hill.c), where boundaries begin (hill_seed.c). SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STUDY_HILL_H
#define HAWSER_STUDY_HILL_H

#include <hawser/hill.h>

struct hawser__hill {
	const struct hawser_hill_field *field;
	const struct hawser_hill_options *options;
	struct hawser_hill_chart *chart;
	double *log_modulus, *argument; /* [m] of the last point */
	double *work;                   /* [3 m] */
	int *used;                      /* [m] */
	int backwards;                  /* the boundary is followed against its sense */
	double began;                   /* s, hawser__wall_seconds */
	enum hawser_status status;      /* the first that is not HAWSER_OK */
	struct hawser_report *report;
};

/* Of the multipliers at hand. */
double hawser__hill_test(struct hawser__hill *hill, int kind);
/* At a point of the rectangle, 0 to 1. */
double hawser__hill_at(struct hawser__hill *hill, int kind, const double at[2]);
double hawser__hill_root(struct hawser__hill *hill, int kind, const double from[2],
                         const double along[2],
                         double lo, double hi, double g_lo, double g_hi);
void hawser__hill_follow(struct hawser__hill *hill, struct hawser_hill_boundary *boundary,
                         double way[2]);
int hawser__hill_known(const struct hawser__hill *hill, int kind, const double at[2],
                       const double way[2]);

/* The caller's answer, told that so many boundaries are complete and the next has so many points. */
int hawser__hill_told_to_stop(const struct hawser_hill_options *options, int boundaries, int points,
                              double began);

/* Of the options of a trace: HAWSER_ERR_ARGUMENT. */
enum hawser_status hawser__hill_check(const struct hawser_hill_options *options,
                                      struct hawser_report *report);
enum hawser_status hawser__hill_append(struct hawser_hill_boundary *boundary, const double at[2],
                                       struct hawser_report *report);

#endif
