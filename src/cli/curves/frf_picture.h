/* cli/curves/frf_picture.h - the picture of a frequency response: what its panels and its enlarged
 * parts share. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_FRF_PICTURE_H
#define HAWSER_CLI_FRF_PICTURE_H

#include "cli/frame/cli.h"
#include "output/drawing/figure.h"

enum { CLI_FRF_PANELS = 3, CLI_FRF_CURVES = 6, CLI_FRF_LABEL = HAWSER__AXIS_SIZE, CLI_FRF_DETAILS = 2 };

struct cli_frf_picture {
	struct hawser__figure figure;
	const struct cli_frf_result *result;
	const int *branch; /* [points] number of the branch, or NULL: no line joins two of them */
	struct hawser__axis x, y;
	double per_omega, per_length; /* what is put, per unit of the model */
	struct cli_frf_curve {
		char label[CLI_FRF_LABEL]; /* "mid-span"; "" if the title of the panel suffices */
		int panel, source;         /* source: index into a row of probes (3*p + c), or of coordinates */
	} curve[CLI_FRF_CURVES];
	char panel[CLI_FRF_PANELS][CLI_FRF_LABEL]; /* titles of the vertical axes */
	int curves, panels;
	int probed;      /* 1: the curves are of probes */
	int logarithmic;
	double low, high; /* of the abscissa, as put */
	struct cli_frf_detail {
		double from, to;
	} detail[CLI_FRF_DETAILS]; /* [details] parts in which events crowd, ascending */
	int details;
};

/* Of point i: the abscissa, and the amplitude of curve c. */
double cli_frf_x(const struct cli_frf_picture *of, int i);
double cli_frf_amplitude(const struct cli_frf_picture *of, int c, int i);
/* Abscissa of an event. */
double cli_frf_event_x(const struct cli_frf_picture *of, const struct hawser_frf_event *event);

/* Range of the curves of a panel between two abscissas; nothing there: INFINITY, 0. */
void cli_frf_range(double *least, double *most, const struct cli_frf_picture *of, int panel, double low,
                   double high);
/* frf_curves.c: what is drawn in a panel that is open. */
void cli_frf_curves(struct cli_frf_picture *of, int panel);
/* frf_tori.c: bands of quasi-periodic motions, behind the curves. */
void cli_tori_bands(struct cli_frf_picture *of, int panel);

/* frf_crowds.c: find them; draw them below the response, above `room` cm. */
void cli_frf_crowds(struct cli_frf_picture *of);
double cli_frf_details_cm(const struct cli_frf_picture *of);
void cli_frf_draw_details(struct cli_frf_picture *of, double room);

#endif
