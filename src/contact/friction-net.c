/* contact/friction-net.c - Newton's step on any graph of links, by SuiteSparse KLU.
 *
 * The rows are those of friction-chain.c. The pattern is analysed once. The matrix M alone is factored
 * with pivots of its diagonal, which are all positive if and only if it is positive definite; Newton's
 * matrix with pivots of KLU's choice.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>

#include <suitesparse/klu.h>

#include "contact/friction.h"
#include "core/columns.h"
#include "core/hold.h"
#include "core/report.h"

/* Matrices: M alone, symmetric or not, and the one with the laws of contacts. */
enum matrix { SYMMETRIC, UNSYMMETRIC, LAW, MATRICES };
/* Least reciprocal growth with the pivots of another matrix: three digits of round-off. */
static const double growth = 1e-3;

struct hawser__contact_net {
	klu_common common;
	klu_symbolic *symbolic;
	klu_numeric *factors[MATRICES]; /* the last of each kind; NULL: none yet */
	int unknowns;
	int *p, *i;         /* [unknowns + 1], [entries] columns */
	double *x;          /* [entries] */
	int (*node)[9];     /* [nodes] place of row r, column c of the block, in 3*r + c */
	int (*link)[2][9];  /* [links] rows of link[0], columns of link[1]; and the other way */
	double *right;      /* [unknowns] */
	struct hawser__touch_rows *rows; /* [nodes] of the contact of a node, in a step */
	struct hawser__hold hold;
};

void hawser__contact_net_clear(struct hawser__contact_net *net)
{
	if (!net)
		return;
	for (int kind = 0; kind < MATRICES; kind++)
		klu_free_numeric(&net->factors[kind], &net->common);
	klu_free_symbolic(&net->symbolic, &net->common);
	hawser__hold_clear(&net->hold);
	free(net);
}

/* The pattern of the blocks of the diagonal and of both sides of each link. Returns 1 if memory is
 * short. */
static int pattern(struct hawser__contact_net *net, int nodes, const int (*link)[2], int links)
{
	size_t most = (size_t)nodes + 2*(size_t)links + 1, blocks = 0;
	int (*list)[2] = malloc(most*sizeof *list), *p = malloc(most*sizeof *p);
	int *i = malloc(most*sizeof *i);
	int failed = !list || !p || !i, n = 0;

	for (int j = 0; j < nodes && !failed; j++, blocks++)
		list[blocks][0] = list[blocks][1] = j;
	for (int e = 0; e < 2*links && !failed; e++, blocks++) {
		list[blocks][0] = link[e/2][e%2];
		list[blocks][1] = link[e/2][1 - e%2];
	}
	failed = failed || hawser__columns(p, i, list, blocks, nodes);
	for (int column = 0; column < net->unknowns && !failed; column++) {
		net->p[column] = n;
		for (int b = p[column/3]; b < p[column/3 + 1]; b++)
			for (int r = 0; r < 3; r++)
				net->i[n++] = 3*i[b] + r;
	}
	net->p[net->unknowns] = n;
	free(list);
	free(p);
	free(i);
	return failed;
}

static void locate(struct hawser__contact_net *net, int nodes, const int (*link)[2], int links)
{
	for (int k = 0; k < 9; k++) {
		for (int j = 0; j < nodes; j++)
			net->node[j][k] = hawser__columns_find(net->p, net->i, 3*j + k/3, 3*j + k%3);
		for (int e = 0; e < links; e++)
			for (int side = 0; side < 2; side++)
				net->link[e][side][k] = hawser__columns_find(
					net->p, net->i, 3*link[e][side] + k/3, 3*link[e][1 - side] + k%3);
	}
}

enum hawser_status hawser__contact_net_open(struct hawser__contact_net **made, int nodes,
                                            const int (*link)[2], int links,
                                            struct hawser_report *report)
{
	struct hawser__contact_net *net = calloc(1, sizeof *net);
	size_t blocks = (size_t)nodes + 2*(size_t)links;
	enum hawser_status status = HAWSER_OK;

	*made = NULL;
	if (net) {
		klu_defaults(&net->common);
		net->common.scale = 0;
		net->common.btf = 0;
		net->unknowns = 3*nodes;
		net->p = hawser__hold(&net->hold, 3*(size_t)nodes + 1, sizeof *net->p);
		net->i = hawser__hold(&net->hold, 9*blocks + 1, sizeof *net->i);
		net->x = hawser__hold(&net->hold, 9*blocks + 1, sizeof *net->x);
		net->node = hawser__hold(&net->hold, (size_t)nodes + 1, sizeof *net->node);
		net->link = hawser__hold(&net->hold, (size_t)links + 1, sizeof *net->link);
		net->right = hawser__hold(&net->hold, 3*(size_t)nodes + 1, sizeof *net->right);
		net->rows = hawser__hold(&net->hold, (size_t)nodes + 1, sizeof *net->rows);
	}
	if (!net || net->hold.short_of_memory || pattern(net, nodes, link, links)) {
		status = hawser__no_memory(report, "friction");
	} else {
		locate(net, nodes, link, links);
		net->symbolic = klu_analyze(net->unknowns, net->p, net->i, &net->common);
		if (!net->symbolic)
			status = hawser__no_memory(report, "friction");
	}
	if (status)
		hawser__contact_net_clear(net);
	else
		*made = net;
	return status;
}

/* Add a block, whose rows are those of a node: with the law times Cr H, none of held directions. */
static void add(struct hawser__contact_net *net, const int at[9], const double B[9], int transposed,
                const struct hawser__touch_rows *rows, unsigned held)
{
	for (int i = 0; i < 3; i++)
		for (int j = 0; j < 3; j++) {
			double sum = 0.0;

			if (!rows && held & 1U << i)
				continue;
			for (int k = 0; k < 3; k++)
				sum += (rows ? rows->CrH[3*i + k] : k == i)*(transposed ? B[3*j + k] : B[3*k + j]);
			net->x[at[3*i + j]] += sum;
		}
}

/* The rows of the law of a node; NULL: it has none. */
static const struct hawser__touch_rows *rows_of(const struct hawser_friction *of, int node,
                                                const struct hawser__step_law *law)
{
	return law && of->first[node] >= 0 ? &of->net->rows[node] : NULL;
}

static void assemble_node(struct hawser_friction *of, int n, const struct hawser__step_law *law)
{
	struct hawser__contact_net *net = of->net;
	const struct hawser__touch_rows *rows = rows_of(of, n, law);
	const unsigned held = of->of->held ? of->of->held[n] : 0U;
	const int contact = of->first[n];

	if (rows)
		hawser__touch_linearise(&net->rows[n], &of->touch[contact], law->sigma,
		                        hawser__step_from(law, of, contact));
	add(net, net->node[n], of->of->diagonal[n], 0, rows, held);
	for (int k = 0; k < 3; k++) {
		if (!rows && held & 1U << k)
			net->x[net->node[n][4*k]] = 1.0;
		net->right[3*n + k] = rows ? -rows->G[k] : of->R[n][k];
	}
	for (int k = 0; k < 9 && rows; k++)
		net->x[net->node[n][k]] += rows->CuH[k];
}

static void assemble(struct hawser_friction *of, const struct hawser__step_law *law)
{
	struct hawser__contact_net *net = of->net;

	memset(net->x, 0, (size_t)net->p[net->unknowns]*sizeof *net->x);
	for (int n = 0; n < of->nodes; n++)
		assemble_node(of, n, law);
	for (int e = 0; e < of->links; e++)
		for (int side = 0; side < 2; side++) {
			const int n = of->link[e][side];

			add(net, net->link[e][side], side && of->of->back ? of->of->back[e] : of->of->off[e],
			    side && !of->of->back, rows_of(of, n, law),
			    of->of->held ? of->of->held[n] : 0U);
		}
}

/* The factors of M have no sign but that of the pivots. */
static int positive(const struct hawser__contact_net *net, const klu_numeric *numeric)
{
	const double *pivot = numeric->Udiag;

	for (int k = 0; k < net->unknowns; k++)
		if (!(pivot[k] > 0.0))
			return 0;
	return 1;
}

/* Factors of the matrix, with the pivots of the last one of its kind where these serve: that allocates
 * nothing. Returns NULL if it is singular. */
static klu_numeric *factors(struct hawser__contact_net *net, enum matrix kind)
{
	klu_numeric **kept = &net->factors[kind];
	klu_common *common = &net->common;

	if (*kept && klu_refactor(net->p, net->i, net->x, net->symbolic, *kept, common) &&
	    common->status == KLU_OK && klu_rgrowth(net->p, net->i, net->x, net->symbolic, *kept, common) &&
	    common->rgrowth > growth)
		return *kept;
	klu_free_numeric(kept, common);
	/* KLU's own tolerance, and none: pivots of the diagonal */
	common->tol = kind == SYMMETRIC ? 0.0 : 0.001;
	*kept = klu_factor(net->p, net->i, net->x, net->symbolic, common);
	return *kept && common->status == KLU_OK ? *kept : NULL;
}

int hawser__contact_net_solve(double (*du)[3], struct hawser_friction *of,
                              const struct hawser__step_law *law)
{
	struct hawser__contact_net *net = of->net;
	const enum matrix kind = law ? LAW : of->of->back ? UNSYMMETRIC : SYMMETRIC;
	klu_numeric *numeric;
	int good;

	assemble(of, law);
	numeric = factors(net, kind);
	good = numeric && (kind != SYMMETRIC || positive(net, numeric)) &&
	       klu_solve(net->symbolic, numeric, net->unknowns, 1, net->right, &net->common);
	for (int n = 0; n < of->nodes && good; n++)
		memcpy(du[n], net->right + 3*n, sizeof du[n]);
	return good;
}

/* Scales of contacts: of the inverse the inverses of the blocks of nodes, as if others stood still. */
void hawser__contact_net_inverse(struct hawser_friction *of)
{
	for (int n = 0; n < of->nodes; n++) {
		const double *D = of->of->diagonal[n];
		const unsigned held = of->of->held ? of->of->held[n] : 0U;
		double A[9], det;

		for (int k = 0; k < 9; k++)
			A[k] = held & 1U << k/3 || held & 1U << k%3 ? k%4 == 0 : D[k];
		det = A[0]*(A[4]*A[8] - A[5]*A[7]) - A[1]*(A[3]*A[8] - A[5]*A[6]) +
		      A[2]*(A[3]*A[7] - A[4]*A[6]);
		for (int i = 0; i < 3; i++)
			for (int j = 0; j < 3; j++)
				of->inverse[n][3*i + j] =
					(A[3*((j + 1)%3) + (i + 1)%3]*A[3*((j + 2)%3) + (i + 2)%3] -
					 A[3*((j + 1)%3) + (i + 2)%3]*A[3*((j + 2)%3) + (i + 1)%3])/det;
	}
}
