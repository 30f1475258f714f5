/* output/curves/plot_frf_detail.c - parts of a frequency response in which events crowd, drawn once
 * more and enlarged below it.
 *
 * A crowd is at least LEAST events, each closer than close_by of the range to the next one, so that
 * their symbols overlap. The two largest crowds are enlarged, in each panel; in the response they
 * are on grey ground.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>

#include "output/output.h"
#include "output/curves/plot_frf.h"

enum { LEAST = 4 };
static const double close_by = 0.015; /* of the range: a symbol is 1 % of it wide */
static const double beside = 0.25, beside_least = 0.01; /* of the crowd, and of the range */
static const double row_cm = 4.0, title_cm = 2.2; /* height of a row; axis title above the rows */

static int ascending(const void *a, const void *b)
{
	const double *x = a, *y = b;

	return (*x > *y) - (*x < *y);
}

/* Keep the crowds with the most events. */
static void keep(struct hawser__frf_detail *detail, int *events, int *count,
                 struct hawser__frf_detail crowd, int size)
{
	int place = *count;

	if (*count == HAWSER__FRF_DETAILS) {
		for (int k = place = 0; k < *count; k++)
			place = events[k] < events[place] ? k : place;
		if (events[place] >= size)
			return;
		for (; place + 1 < *count; place++) {
			detail[place] = detail[place + 1];
			events[place] = events[place + 1];
		}
	} else {
		++*count;
	}
	detail[place] = crowd;
	events[place] = size;
}

int hawser__frf_crowds(struct hawser__frf_detail *detail, const struct hawser__response *response)
{
	double low = fmin(response->from, response->to), high = fmax(response->from, response->to);
	double *at = malloc(((size_t)response->events + 1)*sizeof *at);
	int events[HAWSER__FRF_DETAILS], count = 0, last;

	for (int k = 0; at && k < response->events; k++)
		at[k] = response->event[k].omega;
	if (at)
		qsort(at, (size_t)response->events, sizeof *at, ascending);
	for (int k = 0; at && k < response->events; k = last + 1) {
		double more;

		for (last = k; last + 1 < response->events &&
		               at[last + 1] - at[last] < close_by*(high - low); last++)
			;
		if (last + 1 - k < LEAST)
			continue;
		more = fmax(beside*(at[last] - at[k]), beside_least*(high - low));
		keep(detail, events, &count, (struct hawser__frf_detail){fmax(at[k] - more, low),
		     fmin(at[last] + more, high)}, last + 1 - k);
	}
	free(at);
	return count;
}

double hawser__frf_details_cm(const struct hawser__response *response)
{
	return row_cm*response->panels + title_cm;
}

/* Range of the amplitudes of a panel within the detail. */
static void range(struct hawser__picture *picture, const struct hawser__response *response,
                  const struct hawser__frf_detail *detail, int panel)
{
	FILE *script = picture->script;
	double least = INFINITY, most = 0.0, margin;

	for (int c = 0; c < response->curves; c++)
		for (int i = 0; response->curve[c].panel == panel && i < response->points; i++)
			if (response->omega[i] >= detail->from && response->omega[i] <= detail->to) {
				least = fmin(least, response->curve[c].amplitude[i]);
				most = fmax(most, response->curve[c].amplitude[i]);
			}
	if (response->logarithmic && least > 0.0 && most > 10.0*least) {
		fprintf(script, "set yrange [%.4g:%.4g]\n", 0.7*least, 1.5*most);
		hawser__picture_log_tics(picture, "y", 0.7*least, 1.5*most, 30.0);
		return;
	}
	margin = most > least ? 0.08*(most - least) : fmax(most, 1.0);
	fprintf(script, "unset logscale y\nset format y '%%g'\nset yrange [%.9g:%.9g]\n",
	        least <= most ? least - margin : 0.0, least <= most ? most + margin : 1.0);
	hawser__picture_tics(picture, 'y', fmin(least, most), most, 4);
}

void hawser__frf_details(struct hawser__picture *picture, const struct hawser__response *response,
                         double room, const struct hawser__frf_detail *detail, int details)
{
	const double right = 0.965, left = 0.13, gap = 0.1;
	double wide = (right - left - gap*(details - 1))/details;
	FILE *script = picture->script;

	fputs("unset object\nunset label\n", script);
	for (int k = 0; k < details; k++) {
		double x = left + (wide + gap)*k;

		fprintf(script, "set xrange [%.12g:%.12g]\n", detail[k].from, detail[k].to);
		hawser__picture_tics(picture, 'x', detail[k].from, detail[k].to, details > 1 ? 4 : 8);
		for (int panel = 0; panel < response->panels; panel++) {
			double base = (room + row_cm*(response->panels - 1 - panel))/picture->height;
			int last = panel + 1 == response->panels;

			fprintf(script, "set format x '%s'\n%s\nunset label\n", last ? "%g" : "",
			        last ? "" : "unset xlabel");
			if (last)
				fprintf(script, "set xlabel '%s'\n", response->x_title);
			hawser__picture_panel(picture, x, x + wide, base,
			                      base + (row_cm - 0.45)/picture->height);
			if (panel == 0)
				fputs("set label 1 'grey part, enlarged' at graph 1, graph 1 right "
				      "offset 0,0.6 tc rgb '#505050'\n", script);
			if (k == 0)
				hawser__picture_ylabel(picture, "%s", response->panel_label[panel]);
			hawser__frf_naturals(script, response, detail[k].from, detail[k].to);
			range(picture, response, &detail[k], panel);
			hawser__frf_curves(script, response, panel);
		}
	}
}
