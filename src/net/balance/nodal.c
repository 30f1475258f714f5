/* net/balance/nodal.c - LU factors of a sparse matrix of blocks; see balance.h.
 *
 *   D_k        the block of row k when all before it are eliminated; its own LU factors have pivots
 *   A_ik, A_ki the blocks that link it with a later row i
 *
 * Elimination of k: Z_ki = D_k^-1 A_ki, and A_ij -= A_ik Z_kj for all later i, j that k is linked to.
 * A net is mostly chains, whose inner nodes are linked to two others, so that nearly all work is on
 * whole blocks, and an order by the least degree, found node by node, has hardly any fill.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <lapacke.h>
#include <limits.h>
#include <string.h>

#include "core/report.h"
#include "net/balance/balance.h"

void hawser__nodal_clear(struct hawser__nodal *blocks)
{
	hawser__hold_clear(&blocks->hold);
	*blocks = (struct hawser__nodal){.rows = 0};
}

/* --- the order --- */

/* Nodes that are linked, while they are eliminated. */
struct graph {
	struct links {
		int count, room, *item;
	} *node;
	int failed; /* no memory */
};

static void link_to(struct graph *graph, int from, int to)
{
	struct links *links = &graph->node[from];

	for (int i = 0; i < links->count; i++)
		if (links->item[i] == to)
			return;
	if (links->count == links->room) {
		int room = 2*links->room + 4, *more = realloc(links->item, (size_t)room*sizeof *more);

		if (!more) {
			graph->failed = 1;
			return;
		}
		links->item = more;
		links->room = room;
	}
	links->item[links->count++] = to;
}

static void unlink_from(struct graph *graph, int from, int to)
{
	struct links *links = &graph->node[from];

	for (int i = 0; i < links->count; i++)
		if (links->item[i] == to)
			links->item[i--] = links->item[--links->count];
}

/* All that are linked to the node become linked to each other, and no longer to it. */
static void eliminate(struct graph *graph, int node)
{
	const struct links *links = &graph->node[node];

	for (int i = 0; i < links->count; i++) {
		unlink_from(graph, links->item[i], node);
		for (int j = 0; j < links->count; j++)
			if (i != j)
				link_to(graph, links->item[i], links->item[j]);
	}
}

static int is_held(const struct hawser__mesh *mesh, int node)
{
	const int *unknown = mesh->unknown[node];

	return unknown[0] < 0 && unknown[1] < 0 && unknown[2] < 0;
}

static void connect(struct graph *graph, const struct hawser__mesh *mesh)
{
	for (int e = 0; e < mesh->elements + mesh->absorbers; e++) {
		int own = e < mesh->elements, i = e - mesh->elements;
		int a = own ? mesh->end[e][0] : mesh->absorber[i].node;
		int b = own ? mesh->end[e][1] : mesh->absorber[i].at;

		if (is_held(mesh, a) || is_held(mesh, b) || a == b)
			continue;
		link_to(graph, a, b);
		link_to(graph, b, a);
	}
}

/* The node of the least degree that is left: of those, the next one after the last. */
static int least(const struct graph *graph, const int *row, int nodes, int last)
{
	int best = -1;

	for (int i = 0; i < nodes; i++) {
		int node = (last + 1 + i)%nodes;

		if (row[node] == INT_MAX && (best < 0 || graph->node[node].count < graph->node[best].count))
			best = node;
		if (best >= 0 && graph->node[best].count < 2)
			break;
	}
	return best;
}

/* The order, and the number of links; links of each node stay in the graph. */
static size_t order(struct hawser__nodal *blocks, struct graph *graph, const struct hawser__mesh *mesh)
{
	size_t links = 0;
	int node = -1;

	for (int i = 0; i < mesh->nodes; i++)
		blocks->row[i] = is_held(mesh, i) ? -1 : INT_MAX;
	while (!graph->failed && (node = least(graph, blocks->row, mesh->nodes, node)) >= 0) {
		blocks->row[node] = blocks->rows++;
		links += (size_t)graph->node[node].count;
		eliminate(graph, node);
	}
	return links;
}

static void note_links(struct hawser__nodal *blocks, const struct graph *graph, int nodes)
{
	for (int i = 0; i < nodes; i++)
		if (blocks->row[i] >= 0)
			blocks->first[blocks->row[i] + 1] = graph->node[i].count;
	for (int k = 0; k < blocks->rows; k++)
		blocks->first[k + 1] += blocks->first[k];
	for (int i = 0; i < nodes; i++)
		for (int s = 0; blocks->row[i] >= 0 && s < graph->node[i].count; s++)
			blocks->later[blocks->first[blocks->row[i]] + s] = blocks->row[graph->node[i].item[s]];
}

enum hawser_status hawser__nodal_open(struct hawser__nodal *blocks, const struct hawser__mesh *mesh,
                                       struct hawser_report *report)
{
	struct graph graph = {.node = calloc((size_t)mesh->nodes + 1, sizeof *graph.node)};
	size_t links = 0;

	*blocks = (struct hawser__nodal){.rows = 0};
	blocks->row = hawser__hold(&blocks->hold, (size_t)mesh->nodes + 1, sizeof *blocks->row);
	blocks->first = hawser__hold(&blocks->hold, (size_t)mesh->nodes + 1, sizeof *blocks->first);
	if (graph.node && !blocks->hold.short_of_memory) {
		connect(&graph, mesh);
		links = order(blocks, &graph, mesh);
		blocks->later = hawser__hold(&blocks->hold, links + 1, sizeof *blocks->later);
	}
	if (blocks->later && !graph.failed)
		note_links(blocks, &graph, mesh->nodes);
	for (int i = 0; graph.node && i < mesh->nodes; i++)
		free(graph.node[i].item);
	free(graph.node);
	return blocks->later && !graph.failed ? HAWSER_OK : hawser__no_memory(report, "net");
}

/* --- the blocks --- */

double hawser__nodal_work(const struct hawser__nodal *blocks, int width)
{
	double sum = 0.0;

	for (int k = 0; k < blocks->rows; k++) {
		double links = blocks->first[k + 1] - blocks->first[k];

		sum += 2.0/3.0 + 2.0*links + 2.0*links*links;
	}
	return sum*width*width*width;
}

enum hawser_status hawser__nodal_room(struct hawser__nodal *blocks, int width,
                                       struct hawser_report *report)
{
	size_t rows = (size_t)blocks->rows + 1, links = (size_t)blocks->first[blocks->rows] + 1,
	       square = (size_t)width*(size_t)width;

	blocks->width = width;
	blocks->diagonal = hawser__hold(&blocks->hold, rows*square, sizeof *blocks->diagonal);
	blocks->below = hawser__hold(&blocks->hold, links*square, sizeof *blocks->below);
	blocks->beside = hawser__hold(&blocks->hold, links*square, sizeof *blocks->beside);
	blocks->pivot = hawser__hold(&blocks->hold, rows*(size_t)width, sizeof *blocks->pivot);
	return blocks->hold.short_of_memory ? hawser__no_memory(report, "net") : HAWSER_OK;
}

static double *block(double *of, const struct hawser__nodal *blocks, int at)
{
	return of + (size_t)at*(size_t)blocks->width*(size_t)blocks->width;
}

void hawser__nodal_zero(struct hawser__nodal *blocks)
{
	size_t square = (size_t)blocks->width*(size_t)blocks->width*sizeof(double);

	memset(blocks->diagonal, 0, (size_t)blocks->rows*square);
	memset(blocks->below, 0, (size_t)blocks->first[blocks->rows]*square);
	memset(blocks->beside, 0, (size_t)blocks->first[blocks->rows]*square);
}

double *hawser__nodal_at(const struct hawser__nodal *blocks, int row, int column)
{
	int early = row < column ? row : column, late = row < column ? column : row;
	int at = blocks->first[early];

	if (row == column)
		return block(blocks->diagonal, blocks, row);
	while (blocks->later[at] != late)
		at++;
	return block(row < column ? blocks->beside : blocks->below, blocks, at);
}

/* --- factors --- */

int hawser__nodal_factor(struct hawser__nodal *blocks)
{
	int w = blocks->width;

	for (int k = 0; k < blocks->rows; k++) {
		double *own = block(blocks->diagonal, blocks, k);
		int *pivot = blocks->pivot + (size_t)k*(size_t)w, end = blocks->first[k + 1];

		if (LAPACKE_dgetrf_work(LAPACK_COL_MAJOR, w, w, own, w, pivot))
			return 0;
		for (int s = blocks->first[k]; s < end; s++)
			LAPACKE_dgetrs_work(LAPACK_COL_MAJOR, 'N', w, w, own, w, pivot,
			                    block(blocks->beside, blocks, s), w);
		for (int s = blocks->first[k]; s < end; s++)
			for (int t = blocks->first[k]; t < end; t++)
				cblas_dgemm(CblasColMajor, CblasNoTrans, CblasNoTrans, w, w, w, -1.0,
				            block(blocks->below, blocks, s), w, block(blocks->beside, blocks, t), w,
				            1.0, hawser__nodal_at(blocks, blocks->later[s], blocks->later[t]), w);
	}
	return 1;
}

void hawser__nodal_solve(const struct hawser__nodal *blocks, double *x)
{
	int w = blocks->width;

	for (int k = 0; k < blocks->rows; k++) {
		double *own = x + (size_t)k*(size_t)w;

		LAPACKE_dgetrs_work(LAPACK_COL_MAJOR, 'N', w, 1, block(blocks->diagonal, blocks, k), w,
		                    blocks->pivot + (size_t)k*(size_t)w, own, w);
		for (int s = blocks->first[k]; s < blocks->first[k + 1]; s++)
			cblas_dgemv(CblasColMajor, CblasNoTrans, w, w, -1.0, block(blocks->below, blocks, s), w,
			            own, 1, 1.0, x + (size_t)blocks->later[s]*(size_t)w, 1);
	}
	for (int k = blocks->rows - 1; k >= 0; k--)
		for (int s = blocks->first[k]; s < blocks->first[k + 1]; s++)
			cblas_dgemv(CblasColMajor, CblasNoTrans, w, w, -1.0, block(blocks->beside, blocks, s), w,
			            x + (size_t)blocks->later[s]*(size_t)w, 1, 1.0, x + (size_t)k*(size_t)w, 1);
}
