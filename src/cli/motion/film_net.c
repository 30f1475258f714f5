/* cli/motion/film_net.c - see film_net.h. SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/motion/film_net.h"
#include "core/report.h"
#include "output/drawing/animate.h"

/* Make room for all frames. */
static int begin(struct cli_film *film, const struct hawser_net_frame *frame)
{
	film->nodes = frame->nodes;
	film->elements = frame->elements;
	film->x = calloc((size_t)film->room*(size_t)frame->nodes, sizeof *film->x);
	film->row = calloc((size_t)film->room, sizeof *film->row);
	film->end = calloc((size_t)frame->elements + 1, sizeof *film->end);
	if (!film->x || !film->row || !film->end)
		return ENOMEM;
	memcpy(film->end, frame->end, (size_t)frame->elements*sizeof *film->end);
	return 0;
}

int cli_film_add(struct cli_film *film, const struct hawser_net_frame *frame)
{
	double due = film->room > 1 ? film->last*film->rows/(film->room - 1) : 0.0;
	int bad = film->x ? 0 : begin(film, frame);

	if (bad || film->rows == film->room || frame->row < floor(due))
		return bad;
	memcpy(film->x + (size_t)film->rows*(size_t)film->nodes, frame->x,
	       (size_t)film->nodes*sizeof *film->x);
	film->row[film->rows++] = frame->row;
	return 0;
}

void cli_film_clear(struct cli_film *film)
{
	free(film->x);
	free(film->end);
	free(film->row);
}

enum hawser_status cli_film_write(const char *path, const struct cli_film *film,
                                  const struct hawser_net *net, const struct hawser_net_motion *motion,
                                  struct hawser_report *report)
{
	double *time = calloc((size_t)film->room, sizeof *time);
	double (*mark)[3] = calloc((size_t)film->room, sizeof *mark);
	int *held = calloc((size_t)net->nodes + 1, sizeof *held), helds = 0;
	enum hawser_status status = time && mark && held ? HAWSER_OK
	                                                 : hawser__no_memory(report, "integrate");

	for (int i = 0; i < film->rows && !status; i++) {
		time[i] = motion->time[film->row[i]];
		memcpy(mark[i], motion->x[(long)film->row[i]*motion->probes], sizeof mark[i]);
	}
	for (int i = 0; i < net->nodes && !status; i++) {
		int free_now = 0;

		for (int k = 0; k < net->dynamics.releases; k++)
			free_now |= net->dynamics.release[k] == i;
		if (net->node[i].support && !free_now)
			held[helds++] = i;
	}
	if (!status)
		status = hawser__animate(path, &(struct hawser__animation){
			.time = time, .x = (const double (*)[3])film->x, .rows = film->rows,
			.points = film->nodes, .frames = film->room, .mark = (const double (*)[3])mark,
			.end = (const int (*)[2])film->end, .elements = film->elements, .held = held,
			.helds = helds, .surface = net->surface, .surfaces = net->surfaces}, report);
	free(time);
	free(mark);
	free(held);
	return status;
}
