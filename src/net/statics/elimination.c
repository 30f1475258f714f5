/* net/statics/elimination.c - the order in which the unknowns of a mesh are eliminated: see
 * net/statics/solve.h.
 *
 * The unknowns of a node have the same neighbours. So the order is found for the graph of the nodes,
 * which has a third of the vertices and a ninth of the entries of the matrix.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include "net/statics/solve.h"

static int is_free(const struct hawser__mesh *mesh, int node)
{
	const int *u = mesh->unknown[node];

	return u[0] >= 0 || u[1] >= 0 || u[2] >= 0;
}

/* vertex [nodes] = the number of each node that has an unknown; returns how many there are. */
static int number(int *vertex, const struct hawser__mesh *mesh)
{
	int vertices = 0;

	for (int i = 0; i < mesh->nodes; i++)
		vertex[i] = is_free(mesh, i) ? vertices++ : -1;
	return vertices;
}

static cholmod_sparse *graph_of(const struct hawser__mesh *mesh, const int *vertex, int vertices,
                                cholmod_common *common)
{
	cholmod_triplet *list = cholmod_allocate_triplet((size_t)vertices, (size_t)vertices,
	                                                 (size_t)(vertices + mesh->elements +
	                                                          mesh->absorbers), -1,
	                                                 CHOLMOD_PATTERN, common);
	cholmod_sparse *graph = NULL;

	if (list) {
		int *row = list->i, *column = list->j, count = 0;

		for (int i = 0; i < vertices; i++, count++)
			row[count] = column[count] = i;
		for (int e = 0; e < mesh->elements + mesh->absorbers; e++) {
			int own = e < mesh->elements, k = e - mesh->elements;
			int a = vertex[own ? mesh->end[e][0] : mesh->absorber[k].node];
			int b = vertex[own ? mesh->end[e][1] : mesh->absorber[k].at];

			if (a < 0 || b < 0)
				continue;
			row[count] = a > b ? a : b;
			column[count++] = a > b ? b : a;
		}
		list->nnz = (size_t)count;
		graph = cholmod_triplet_to_sparse(list, 0, common);
	}
	cholmod_free_triplet(&list, common);
	return graph;
}

static int is_rotor(const struct hawser__mesh *mesh, int unknown)
{
	for (int i = 0; i < mesh->rotors; i++)
		if (mesh->rotor[i].unknown == unknown)
			return 1;
	return 0;
}

/* permutation [unknowns] = the unknowns of the nodes in the order of the vertices, then those that many
 * nodes share. */
static void expand(int *permutation, const int *order, const struct hawser__mesh *mesh,
                   const int *vertex, int *node)
{
	int count = 0;

	for (int i = 0; i < mesh->nodes; i++)
		if (vertex[i] >= 0)
			node[vertex[i]] = i;
	for (int i = 0; count < mesh->unknowns - mesh->rotors; i++)
		for (int k = 0; k < 3; k++) {
			int u = mesh->unknown[node[order[i]]][k];

			if (u >= 0 && !is_rotor(mesh, u))
				permutation[count++] = u;
		}
	for (int i = 0; i < mesh->rotors; i++)
		permutation[count++] = mesh->rotor[i].unknown;
}

int hawser__elimination(int *permutation, const struct hawser__mesh *mesh, cholmod_common *common)
{
	int *vertex = malloc(2*(size_t)mesh->nodes*sizeof *vertex), supernodal = common->supernodal, done;
	cholmod_sparse *graph = NULL;
	cholmod_factor *factor = NULL;

	if (vertex)
		graph = graph_of(mesh, vertex, number(vertex, mesh), common);
	common->nmethods = 1;
	common->method[0].ordering = CHOLMOD_AMD;
	common->supernodal = CHOLMOD_SIMPLICIAL;
	if (graph)
		factor = cholmod_analyze(graph, common);
	common->supernodal = supernodal;
	done = factor != NULL;
	if (done)
		expand(permutation, factor->Perm, mesh, vertex, vertex + mesh->nodes);
	cholmod_free_factor(&factor, common);
	cholmod_free_sparse(&graph, common);
	free(vertex);
	return done;
}
