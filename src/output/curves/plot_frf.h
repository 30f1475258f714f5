/* output/curves/plot_frf.h - a frequency response and its enlarged parts: what both need.
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

/* A curve of quasi-periodic motions: a band from the least to the greatest amplitude; of those with 0
 * points nothing is drawn. */
struct hawser__response_torus {
	int points;
	double *omega;        /* [points], and the memory of the others */
	double *unstable;     /* [points] 0 or 1 */
	double *least, *most; /* [curves][points] */
};
/* plot_frf_tori.c: data of curve c; the bands of a panel, each after *comma, which becomes ", "; the
 * largest amplitude of curve c. */
void hawser__tori_data(FILE *script, const struct hawser__response *response, int c);
void hawser__tori_bands(FILE *script, const char **comma, const struct hawser__response *response,
                        int panel);
double hawser__tori_largest(const struct hawser__response *response, int c);
struct hawser__legend;
void hawser__tori_legend(struct hawser__legend *entries, const struct hawser__response *response);

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
