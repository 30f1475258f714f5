/* output/plot_frf.h - a frequency response and its enlarged parts: what both need.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_OUTPUT_PLOT_FRF_H
#define HAWSER_OUTPUT_PLOT_FRF_H

#include <stdio.h>

struct hawser__picture;
struct hawser__response;

/* Natural frequencies from low to high as vertical lines, and no other arrow. */
void hawser__frf_naturals(FILE *script, const struct hawser__response *response, double low,
                          double high);
/* gnuplot's command for the curves, events and peaks of a panel. */
void hawser__frf_curves(FILE *script, const struct hawser__response *response, int panel);

/* A range of Omega in which events crowd. */
enum { HAWSER__FRF_DETAILS = 2 };
struct hawser__frf_detail {
	double from, to;
};
/* Into detail[HAWSER__FRF_DETAILS], in ascending order; how many. */
int hawser__frf_crowds(struct hawser__frf_detail *detail, const struct hawser__response *response);
/* Room for the enlarged parts, above the legend. */
double hawser__frf_details_cm(const struct hawser__response *response);
/* `room` below them (cm). */
void hawser__frf_details(struct hawser__picture *picture, const struct hawser__response *response,
                         double room, const struct hawser__frf_detail *detail, int details);

#endif
