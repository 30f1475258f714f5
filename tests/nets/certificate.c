/* tests/nets/certificate.c - whether positions are the equilibrium of a net, from the positions
 * and the scene.
 *
 * d, l  of an element: vector between its ends, length
 * T     EA*max(l/length0 - 1, 0)
 * n     force vector of an element; those used here balance the loads at every node
 * c     length0/EA
 *
 * The least energy of all shapes is at least the dual energy of any forces in balance, so that
 *
 *   gap = sum of  T*T*c/2 + |n|*length0 + |n|^2*c/2 - n.d
 *
 * bounds the energy that the shape has too much. Forces in balance are T*d/l, corrected along trees:
 * for each direction a tree of elements from the supports, in which every node hands its unbalanced
 * force on to the next one. No system of equations is solved, and no function of the solvers is called:
 * loads and law are written again, in long double. Each term is a sum of squares: no cancellation.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "core/hold.h"
#include "core/report.h"
#include "tests/nets/comparison.h"

struct part {
	int end[2];
	long double length0, EA, n[3];
};

struct judged {
	int nodes, parts;
	long double (*q)[3], (*r)[3]; /* [nodes] positions; loads, then what is not balanced */
	unsigned char (*held)[3];     /* [nodes] */
	struct part *part;            /* [parts] */
	int *first, *next;            /* [nodes], [2*parts] the parts at a node, as lists; -1: the end */
	int *order, *by;              /* [nodes] nodes from the supports outwards, the part behind each */
	unsigned char *seen;          /* [nodes] */
	struct hawser__hold hold;
};

static void clear(struct judged *of)
{
	hawser__hold_clear(&of->hold);
}

static enum hawser_status open(struct judged *of, const struct hawser_net *net,
                               struct hawser_report *report)
{
	size_t nodes, parts;

	of->nodes = net->nodes;
	for (int c = 0; c < net->cables; c++) {
		of->parts += net->cable[c].elements;
		of->nodes += net->cable[c].elements - 1;
		if (net->cable[c].given != HAWSER_NET_LENGTH0)
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "net",
			                    "%s: cable %s has no length0, so that its equilibrium is found with "
			                    "its length and cannot be judged: give length0", net->name,
			                    net->cable[c].name);
	}
	nodes = (size_t)of->nodes;
	parts = (size_t)of->parts;
	of->q = hawser__hold(&of->hold, nodes, sizeof *of->q);
	of->r = hawser__hold(&of->hold, nodes, sizeof *of->r);
	of->held = hawser__hold(&of->hold, nodes, sizeof *of->held);
	of->part = hawser__hold(&of->hold, parts, sizeof *of->part);
	of->first = hawser__hold(&of->hold, nodes, sizeof *of->first);
	of->next = hawser__hold(&of->hold, 2*parts, sizeof *of->next);
	of->order = hawser__hold(&of->hold, nodes, sizeof *of->order);
	of->by = hawser__hold(&of->hold, nodes, sizeof *of->by);
	of->seen = hawser__hold(&of->hold, nodes, 1);
	return of->hold.short_of_memory ? hawser__no_memory(report, "net") : HAWSER_OK;
}

/* --- the scene --- */

static void cable(struct judged *of, const struct hawser_net *net,
                  const struct hawser_net_statics *st, int c, int node, int part, int point)
{
	const struct hawser_net_cable *cable = &net->cable[c];
	long double share = (long double)cable->value/cable->elements/2.0L, load[3] = {0};

	load[1] = -(long double)cable->rho*net->g*share;
	for (int i = 0; i < net->loads; i++)
		for (int k = 0; k < 3 && net->load[i].cable == c && !net->load[i].harmonic; k++)
			load[k] += net->load[i].value[k]*share;
	for (int i = 0; i < cable->elements; i++) {
		struct part *to = &of->part[part + i];

		to->end[0] = i ? node + i - 1 : cable->from;
		to->end[1] = i < cable->elements - 1 ? node + i : cable->to;
		to->length0 = (long double)cable->value/cable->elements;
		to->EA = cable->EA;
		for (int k = 0; k < 3; k++) {
			of->r[to->end[0]][k] += load[k];
			of->r[to->end[1]][k] += load[k];
			if (i)
				of->q[to->end[0]][k] = st->point[point + i].x[k];
		}
	}
}

static void fill(struct judged *of, const struct hawser_net *net, const struct hawser_net_statics *st)
{
	int node = net->nodes, part = 0, point = 0;

	for (int i = 0; i < net->nodes; i++) {
		memcpy(of->held[i], net->node[i].held, sizeof of->held[i]);
		of->r[i][1] = -(long double)net->node[i].mass*net->g;
		for (int k = 0; k < 3; k++)
			of->q[i][k] = st->x[i][k];
	}
	for (int i = 0; i < net->loads; i++)
		for (int k = 0; k < 3 && net->load[i].cable < 0 && !net->load[i].harmonic; k++)
			of->r[net->load[i].node][k] += net->load[i].value[k];
	for (int c = 0; c < net->cables; c++) {
		cable(of, net, st, c, node, part, point);
		node += net->cable[c].elements - 1;
		part += net->cable[c].elements;
		point += net->cable[c].elements + 1;
	}
	for (int i = 0; i < of->nodes; i++)
		of->first[i] = -1;
	for (int i = 0; i < 2*of->parts; i++) {
		int *head = &of->first[of->part[i/2].end[i % 2]];

		of->next[i] = *head;
		*head = i;
	}
}

/* --- forces --- */

static long double norm(const long double v[3])
{
	return sqrtl(v[0]*v[0] + v[1]*v[1] + v[2]*v[2]);
}

static long double difference(long double d[3], const struct judged *of, const struct part *part)
{
	for (int k = 0; k < 3; k++)
		d[k] = of->q[part->end[1]][k] - of->q[part->end[0]][k];
	return norm(d);
}

/* Forces of the law, and what they leave of the loads; the number of parts that bars compress. */
static int law(struct judged *of)
{
	int compressed = 0;

	for (int i = 0; i < of->parts; i++) {
		struct part *part = &of->part[i];
		long double d[3], l = difference(d, of, part), T;

		T = part->EA*(l - part->length0)/part->length0;
		compressed += T < 0.0L;
		for (int k = 0; k < 3; k++) {
			part->n[k] = T > 0.0L ? T*d[k]/l : 0.0L;
			of->r[part->end[0]][k] += part->n[k];
			of->r[part->end[1]][k] -= part->n[k];
		}
	}
	return compressed;
}

/* Nodes from the supports of direction k outwards; returns how many there are. */
static int grow(struct judged *of, int k)
{
	int count = 0;

	memset(of->seen, 0, (size_t)of->nodes);
	for (int i = 0; i < of->nodes; i++)
		if (of->held[i][k]) {
			of->seen[i] = 1;
			of->order[count++] = i;
		}
	for (int at = 0; at < count; at++)
		for (int i = of->first[of->order[at]]; i >= 0; i = of->next[i]) {
			int other = of->part[i/2].end[1 - i % 2];

			if (of->seen[other])
				continue;
			of->seen[other] = 1;
			of->by[other] = i/2;
			of->order[count++] = other;
		}
	return count;
}

/* Correct n so that every node is in balance in direction k. */
static void balance(struct judged *of, int k)
{
	for (int at = grow(of, k) - 1; at >= 0; at--) {
		int node = of->order[at], side;
		struct part *part;

		if (of->held[node][k])
			continue;
		part = &of->part[of->by[node]];
		side = part->end[1] == node;
		part->n[k] += side ? of->r[node][k] : -of->r[node][k];
		of->r[part->end[1 - side]][k] += of->r[node][k];
		of->r[node][k] = 0.0L;
	}
}

/* The term of a part: taut c*(|n| - T)^2/2, slack c*|n|^2/2 + |n|*(length0 - l), and |n|*l - n.d. */
static long double term(const struct judged *of, const struct part *part, long double *scale)
{
	long double d[3], x[3], l = difference(d, of, part), N = norm(part->n), along, T, sum;
	long double c = part->length0/part->EA;

	for (int k = 0; k < 3; k++)
		x[k] = part->n[(k + 1) % 3]*d[(k + 2) % 3] - part->n[(k + 2) % 3]*d[(k + 1) % 3];
	along = part->n[0]*d[0] + part->n[1]*d[1] + part->n[2]*d[2];
	T = (l - part->length0)/c;
	sum = along > 0.0L ? (x[0]*x[0] + x[1]*x[1] + x[2]*x[2])/(N*l + along) : N*l - along;
	*scale += N*l;
	return sum + (T > 0.0L ? c*(N - T)*(N - T)/2.0L : c*N*N/2.0L + N*(part->length0 - l));
}

/* Largest component of the forces that are not balanced. */
static double largest(const struct judged *of)
{
	double most = 0.0;

	for (int i = 0; i < of->nodes; i++)
		for (int k = 0; k < 3; k++)
			if (!of->held[i][k] && !(fabsl(of->r[i][k]) <= most))
				most = (double)fabsl(of->r[i][k]);
	return most;
}

enum hawser_status net_certify(struct net_certificate *certificate, const struct hawser_net *net,
                               const struct hawser_net_statics *st,
                               struct hawser_report *report)
{
	struct judged of = {0};
	long double gap = 0.0L, scale = 0.0L, weight = 0.0L;
	enum hawser_status status = open(&of, net, report);

	memset(certificate, 0, sizeof *certificate);
	if (!status && st->points != of.parts + net->cables)
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "net", "%s: the result has %d points, and "
		                      "the net %d elements of %d cables", net->name, st->points, of.parts,
		                      net->cables);
	if (!status) {
		fill(&of, net, st);
		for (int i = 0; i < of.nodes; i++)
			weight += norm(of.r[i]);
		certificate->compressed = law(&of);
		certificate->residual = largest(&of);
		for (int k = 0; k < 3; k++)
			balance(&of, k);
		for (int i = 0; i < of.parts; i++)
			gap += term(&of, &of.part[i], &scale);
		certificate->weight = (double)weight;
		certificate->gap = (double)gap;
		certificate->scale = (double)scale;
		certificate->angle = scale > 0.0L ? (double)sqrtl(2.0L*gap/scale) : gap > 0.0L ? INFINITY : 0.0;
		certificate->right = certificate->angle <= NET_RIGHT &&
		                     certificate->residual <= NET_RIGHT*certificate->weight;
	}
	clear(&of);
	return status;
}
