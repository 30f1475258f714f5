/* rom/condense/condense_load.c - effect of the load on the modes that are not kept.
 *
 *    f      load per length
 *    P      integral of f along the cable from end A to s
 *
 * Since a displacement vanishes at both ends, the work of f on it is that of -P on its derivative.
 * P jumps at a force at a point.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <string.h>

#include "rom/condense/follow.h"
#include "statics/frame.h"

/* global [3] += the force of harmonic h per length at s, in the axes of the cable's plane, times
 * factor. */
static void add_force(double global[3], const struct hawser__piece *piece,
                      const struct hawser__loads *loads, int h, const struct hawser_statics *st,
                      double s, double factor)
{
	double local[3], f[3];

	if (piece->frame == HAWSER_FRAME_GLOBAL) {
		hawser__piece_part(local, piece, loads, h, s);
		hawser_statics_from_global(st, f, local);
	} else {
		struct hawser_frame_point at = hawser_statics_frame(st, s);

		hawser__piece_at(local, piece, loads, h, st, s);
		hawser__frame_out(f, &at, local);
	}
	for (int c = 0; c < 3; c++)
		global[c] += factor*f[c];
}

/* sum [3] += the integral of the piece's force over [from, to], by a Gauss rule. */
static void add_run(double sum[3], const struct hawser__piece *piece,
                    const struct hawser__loads *loads, int h, const struct hawser__stations *stations,
                    double from, double to)
{
	const struct hawser_grid *grid = &stations->modes->grid;
	double half = 0.5*(grid->edge[1] - grid->edge[0]);

	for (int i = 0; i < grid->order; i++)
		add_force(sum, piece, loads, h, &stations->modes->statics,
		          from + 0.5*(to - from)*(1.0 + grid->node[i]),
		          0.5*(to - from)*grid->weight[i]/half);
}

/* Subtract the running integral of one piece from p. */
static void pull_one(struct hawser__stations *stations, const struct hawser__piece *piece,
                     const struct hawser__loads *loads, int h)
{
	const struct hawser_statics *st = &stations->modes->statics;
	int order = stations->modes->grid.order;
	double sum[3] = {0.0};

	for (int e = 0; e < stations->parts; e++) {
		double from = stations->edge[e], to = stations->edge[e + 1];
		int inside = from >= piece->from && to <= piece->to;

		if (piece->from == piece->to && from == piece->from)
			add_force(sum, piece, loads, h, st, from, 1.0);
		for (int i = e*order; i < (e + 1)*order; i++) {
			struct hawser_frame_point at = hawser_statics_frame(st, stations->s[i]);
			double P[3] = {sum[0], sum[1], sum[2]}, *p = stations->p + 3*(size_t)i, local[3];

			if (inside)
				add_run(P, piece, loads, h, stations, from, stations->s[i]);
			hawser__frame_in(local, &at, P);
			for (int c = 0; c < 3; c++)
				p[c] -= loads->scale*local[c];
		}
		if (inside)
			add_run(sum, piece, loads, h, stations, from, to);
	}
	for (int axis = 0; axis < 3; axis++)
		stations->beyond[axis] += loads->scale*sum[axis];
}

void hawser__load_pull(struct hawser__stations *stations, const struct hawser__loads *loads, int h)
{
	memset(stations->p, 0, 3*(size_t)stations->count*sizeof *stations->p);
	memset(stations->beyond, 0, sizeof stations->beyond);
	for (int i = 0; i < loads->count; i++)
		if (loads->piece[i].harmonic[loads->sine[h]] == h)
			pull_one(stations, &loads->piece[i], loads, h);
}
