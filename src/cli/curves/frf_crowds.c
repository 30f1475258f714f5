/* cli/curves/frf_crowds.c - parts of a frequency response in which events crowd, drawn once more and
 * enlarged below it.
 *
 * A crowd is at least LEAST events, each closer than close_by of the range to the next one, so that
 * their symbols overlap. The largest crowds are enlarged, in each panel; in the response they
 * are on grey ground.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include "cli/curves/frf_picture.h"
#include "core/order.h"

enum { LEAST = 4 };
static const double close_by = 0.015; /* of the range: a symbol is 1 % of it wide */
static const double beside = 0.25, beside_least = 0.01; /* of the crowd, and of the range */
static const double row_cm = 4.0, title_cm = 2.2; /* height of a row; axis title above the rows */

/* Keep the crowds with the most events. */
static void keep(struct cli_frf_picture *of, int *events, struct cli_frf_detail crowd, int size)
{
	int place = of->details;

	if (of->details == CLI_FRF_DETAILS) {
		for (int k = place = 0; k < of->details; k++)
			place = events[k] < events[place] ? k : place;
		if (events[place] >= size)
			return;
		for (; place + 1 < of->details; place++) {
			of->detail[place] = of->detail[place + 1];
			events[place] = events[place + 1];
		}
	} else {
		of->details++;
	}
	of->detail[place] = crowd;
	events[place] = size;
}

void cli_frf_crowds(struct cli_frf_picture *of)
{
	const struct hawser_frf *frf = of->result->frf;
	double *at = malloc(((size_t)frf->events + 1)*sizeof *at), range = of->high - of->low;
	int events[CLI_FRF_DETAILS], last;

	for (int k = 0; at && k < frf->events; k++)
		at[k] = cli_frf_event_x(of, &frf->event[k]);
	if (at)
		qsort(at, (size_t)frf->events, sizeof *at, hawser__ascending);
	for (int k = 0; at && k < frf->events; k = last + 1) {
		double more;

		for (last = k; last + 1 < frf->events && at[last + 1] - at[last] < close_by*range; last++)
			;
		if (last + 1 - k < LEAST)
			continue;
		more = fmax(beside*(at[last] - at[k]), beside_least*range);
		keep(of, events, (struct cli_frf_detail){fmax(at[k] - more, of->low),
		                                         fmin(at[last] + more, of->high)}, last + 1 - k);
	}
	free(at);
}

double cli_frf_details_cm(const struct cli_frf_picture *of)
{
	return of->details ? row_cm*of->panels + title_cm : 0.0;
}

/* The vertical axis of a panel, for the amplitudes within the detail. */
static struct hawser__panel_axis amplitudes(const struct cli_frf_picture *of,
                                            const struct cli_frf_detail *detail, int panel)
{
	struct hawser__panel_axis axis = {&of->y, 0.0, 1.0, .tics = 4};
	double least, most, margin;

	cli_frf_range(&least, &most, of, panel, detail->from, detail->to);
	if (of->logarithmic && least > 0.0 && most > 10.0*least) {
		axis.from = 0.7*least;
		axis.to = 1.5*most;
		axis.logarithmic = 1;
	} else if (least <= most) {
		margin = most > least ? 0.08*(most - least) : fmax(most, 1.0);
		axis.from = least - margin;
		axis.to = most + margin;
	}
	return axis;
}

void cli_frf_draw_details(struct cli_frf_picture *of, double room)
{
	const double right = 0.965, left = 0.13, gap = 0.1, height = of->figure.out.height;
	double wide = (right - left - gap*(of->details - 1))/of->details;

	for (int k = 0; k < of->details; k++) {
		const struct cli_frf_detail *detail = &of->detail[k];
		double x = left + (wide + gap)*k;

		for (int panel = 0; panel < of->panels; panel++) {
			double base = (room + row_cm*(of->panels - 1 - panel))/height;
			struct hawser__panel_axis y = amplitudes(of, detail, panel);

			y.untitled = k > 0;
			hawser__figure_panel(&of->figure, &(struct hawser__panel_frame){x, x + wide, base,
				base + (row_cm - 0.45)/height, .title = of->panel[panel], .y = y,
				.x = {&of->x, detail->from, detail->to, .tics = of->details > 1 ? 4 : 8,
				      .bare = panel + 1 < of->panels, .other = 1}});
			if (panel == 0)
				fputs("set label 'grey part, enlarged' at graph 1, graph 1 right "
				      "offset 0,0.6 tc rgb '#505050'\n", of->figure.out.script);
			cli_frf_curves(of, panel);
		}
	}
}
