/* cli/motion/film_net.c - see integrate_net.h. SPDX-License-Identifier: GPL-3.0-or-later */
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cli/motion/integrate_net.h"
#include "core/report.h"
#include "output/drawing/animate.h"
#include "output/drawing/figure.h"
#include "output/drawing/perspective.h"

static const double large = 0.2;  /* of the size of the net, half of which magnified motions reach */
static const double same = 1e-6;  /* relative: of equal motions the first one has the mark */

/* Make room for all frames. */
static int begin(struct cli_film *film, const struct hawser_net_frame *frame)
{
	film->nodes = frame->nodes;
	film->elements = frame->elements;
	film->x = calloc((size_t)film->room*(size_t)frame->nodes, sizeof *film->x);
	film->row = calloc((size_t)film->room, sizeof *film->row);
	film->time = calloc((size_t)film->room, sizeof *film->time);
	film->mark = calloc((size_t)film->room, sizeof *film->mark);
	film->end = calloc((size_t)frame->elements + 1, sizeof *film->end);
	return film->x && film->row && film->time && film->mark && film->end ? 0 : ENOMEM;
}

int cli_film_add(struct cli_film *film, const struct hawser_net_frame *frame)
{
	double due = film->room > 1 ? film->last*film->rows/(film->room - 1) : 0.0;
	int bad = film->x ? 0 : begin(film, frame);

	if (!bad) /* of the last frame: a loose end is where its cable was before it parted */
		memcpy(film->end, frame->end, (size_t)frame->elements*sizeof *film->end);
	if (bad || film->rows == film->room || frame->row < floor(due))
		return bad;
	memcpy(film->x + (size_t)film->rows*(size_t)film->nodes, frame->x,
	       (size_t)film->nodes*sizeof *film->x);
	film->time[film->rows] = frame->t;
	film->row[film->rows++] = frame->row;
	return 0;
}

/* --- what is too small to be seen --- */

static void mean_of(double mean[3], const struct cli_film *film, int node)
{
	memset(mean, 0, 3*sizeof *mean);
	for (int i = 0; i < 3*film->rows; i++)
		mean[i%3] += film->x[i/3*film->nodes + node][i%3]/film->rows;
}

/* The longest way from there. */
static double reach_of(const struct cli_film *film, const double mean[3], int node)
{
	double most = 0.0;

	for (int i = 0; i < film->rows; i++) {
		const double *x = film->x[i*film->nodes + node];

		most = fmax(most, hypot(hypot(x[0] - mean[0], x[1] - mean[1]), x[2] - mean[2]));
	}
	return most;
}

static void enlarge(struct cli_film *film, int node, double times)
{
	double mean[3];

	mean_of(mean, film, node);
	for (int i = 0; i < 3*film->rows; i++) {
		double *x = &film->x[i/3*film->nodes + node][i%3];

		*x = mean[i%3] + times*(*x - mean[i%3]);
	}
}

void cli_film_magnify(struct cli_film *film)
{
	struct hawser__box box = {.any = 0};
	struct hawser__eye eye;
	double most = 0.0, times;
	int best = 0;

	for (int i = 0; i < film->nodes; i++) {
		double mean[3], reach;

		mean_of(mean, film, i);
		reach = reach_of(film, mean, i);
		hawser__box_add(&box, mean, 3);
		best = reach > most*(1.0 + same) ? i : best;
		most = fmax(most, reach);
	}
	hawser__eye_look(&eye, &box, HAWSER__IN_SPACE, NULL);
	times = hawser__panels_magnify(most, large*eye.size);
	for (int i = 0; i < film->nodes && times > 1.0; i++)
		enlarge(film, i, times);
	for (int i = 0; i < film->rows; i++)
		memcpy(film->mark[i], film->x[i*film->nodes + best], sizeof *film->mark);
	if (times > 1.0)
		snprintf(film->note, sizeof film->note, "motion magnified %.9g times", times);
}

void cli_film_clear(struct cli_film *film)
{
	free(film->x);
	free(film->end);
	free(film->row);
	free(film->time);
	free(film->mark);
}

/* held [net->nodes]: the supports that stay; how many there are. */
static int find_held(int *held, const struct hawser_net *net)
{
	int count = 0;

	for (int i = 0; i < net->nodes; i++) {
		int free_now = 0;

		for (int k = 0; k < net->dynamics.releases; k++)
			free_now |= net->dynamics.release[k] == i;
		if (net->node[i].support && !free_now)
			held[count++] = i;
	}
	return count;
}

enum hawser_status cli_film_write(const char *path, const struct cli_film *film,
                                  const struct hawser_net *net, struct hawser_report *report)
{
	int *held = net ? calloc((size_t)net->nodes + 1, sizeof *held) : film->held;
	enum hawser_status status;

	if (!held)
		return hawser__no_memory(report, "animation");
	status = hawser__animate(path, &(struct hawser__animation){
		.time = film->time, .x = (const double (*)[3])film->x, .rows = film->rows,
		.points = film->nodes, .frames = film->room, .mark = (const double (*)[3])film->mark,
		.end = (const int (*)[2])film->end, .elements = film->elements, .held = held,
		.helds = net ? find_held(held, net) : film->helds, .surface = net ? net->surface : NULL,
		.surfaces = net ? net->surfaces : 0,
		.water = net && net->water.density > 0.0 ? &net->water : NULL,
		.note = *film->note ? film->note : NULL}, report);
	if (net)
		free(held);
	return status;
}
