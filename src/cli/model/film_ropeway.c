/* cli/model/film_ropeway.c - see made.h. The rope moves with the modes that are coordinates, to
 * first order; what follows them is not drawn.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/model/made.h"
#include "cli/motion/integrate_net.h"
#include "core/report.h"

enum { PER_PIECE = 12 }; /* elements of a free part or an arc; chosen */

/* A chain of nodes a lane, from the bottom station, and the two wheels between them. */
struct chain {
	const struct hawser_line_modes *modes;
	double apart;
	double (*rest)[3], (*x)[3];  /* [nodes] m */
	double (*shape)[3];          /* [modes->n][room] m for a unit of the coordinate */
	int (*end)[2], *held;        /* [elements], [helds] */
	int room, nodes, elements, helds; /* room: nodes of all lanes */
};

static void add_node(struct chain *c, int lane, double S)
{
	const struct hawser_line_modes *modes = c->modes;
	double *rest = c->rest[c->nodes], angle, own[6];

	hawser_line_at(modes->lane[lane], rest, &angle, NULL, NULL, NULL, S);
	rest[2] = lane*c->apart;
	for (int k = 0; k < modes->n; k++) {
		double *to = c->shape[k*c->room + c->nodes];

		hawser_line_modes_at(own, NULL, modes, k, lane, S/modes->length_unit);
		to[0] = modes->length_unit*(own[0]*cos(angle) - own[1]*sin(angle));
		to[1] = modes->length_unit*(own[0]*sin(angle) + own[1]*cos(angle));
		to[2] = modes->length_unit*own[2];
	}
	c->nodes++;
}

static void add_lane(struct chain *c, int lane)
{
	const struct hawser_line_statics *st = c->modes->lane[lane];

	for (int p = 0; p < st->pieces; p++) {
		const struct hawser_line_piece *piece = &st->piece[p];

		if (p == 0 || piece->sheave >= 0)
			c->held[c->helds++] = c->nodes;
		for (int i = 0; i < PER_PIECE + (p + 1 == st->pieces); i++)
			add_node(c, lane, piece->S0 + (piece->S1 - piece->S0)*i/PER_PIECE);
	}
	c->held[c->helds++] = c->nodes - 1;
}

static void join(struct chain *c, int a, int b)
{
	c->end[c->elements][0] = a;
	c->end[c->elements++][1] = b;
}

static void lay(struct chain *c)
{
	int first = 0;

	for (int lane = 0; lane < c->modes->lanes; lane++) {
		first = c->nodes;
		add_lane(c, lane);
		for (int i = first; i + 1 < c->nodes; i++)
			join(c, i, i + 1);
	}
	if (c->modes->lanes > 1) {
		join(c, 0, first);
		join(c, first - 1, c->nodes - 1);
	}
}

static void move(struct chain *c, const double *u)
{
	memcpy(c->x, c->rest, (size_t)c->nodes*sizeof *c->x);
	for (int k = 0; k < c->modes->n; k++)
		for (int i = 0; i < 3*c->nodes; i++)
			c->x[i/3][i%3] += u[k]*c->shape[k*c->room + i/3][i%3];
}

static enum hawser_status show(struct chain *c, const char *path,
                               const struct hawser_net_rom_motion *motion, int stride,
                               struct hawser_report *report)
{
	struct cli_film film = {.room = motion->rows, .last = motion->rows - 1.0, .held = c->held,
	                        .helds = c->helds};
	struct hawser_net_frame frame = {.nodes = c->nodes, .elements = c->elements,
		.x = (const double (*)[3])c->x, .end = (const int (*)[2])c->end};
	enum hawser_status status;
	int bad = 0;

	for (; frame.row < motion->rows && !bad; frame.row++) {
		frame.t = motion->duration*frame.row/motion->rows;
		move(c, motion->u + frame.row*stride);
		bad = cli_film_add(&film, &frame);
	}
	if (!bad)
		cli_film_magnify(&film);
	status = bad ? hawser__no_memory(report, "animation") : cli_film_write(path, &film, NULL, report);
	cli_film_clear(&film);
	return status;
}

enum hawser_status cli_film_ropeway(const char *path, const struct hawser_line_modes *modes,
                                    const struct hawser_net_rom_motion *motion, int stride,
                                    double apart, struct hawser_report *report)
{
	struct chain c = {.modes = modes, .apart = apart};
	size_t room;
	enum hawser_status status;

	for (int lane = 0; lane < modes->lanes; lane++)
		c.room += PER_PIECE*modes->lane[lane]->pieces + 1;
	room = (size_t)c.room + 2;
	c.rest = calloc(room, sizeof *c.rest);
	c.x = calloc(room, sizeof *c.x);
	c.shape = calloc(room*(size_t)modes->n, sizeof *c.shape);
	c.end = calloc(room, sizeof *c.end);
	c.held = calloc(room, sizeof *c.held);
	if (c.rest && c.x && c.shape && c.end && c.held) {
		lay(&c);
		status = show(&c, path, motion, stride, report);
	} else {
		status = hawser__no_memory(report, "animation");
	}
	free(c.rest);
	free(c.x);
	free(c.shape);
	free(c.end);
	free(c.held);
	return status;
}
