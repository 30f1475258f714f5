/* ropeway/modes/modes_systems.c - divide what moves into systems that do not interact.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include "core/grow.h"
#include "core/report.h"
#include "ropeway/modes/modes.h"

static int root_of(const struct hawser__lmode_draft *t, int chain)
{
	while (t->root[chain] != chain)
		chain = t->root[chain];
	return chain;
}

static int touches(const struct hawser__lmode_draft *t, int segment, int border)
{
	const double *map = t->border_map + segment*HAWSER__ENDS*2*t->borders_most;

	for (int i = 0; i < HAWSER__ENDS*2; i++)
		if (map[i*t->borders_most + border] != 0.0)
			return 1;
	return 0;
}

static void unite(struct hawser__lmode_draft *t)
{
	for (int i = 0; i < t->chains; i++)
		t->root[i] = i;
	for (int b = 0; b < t->borders; b++) {
		int first = -1;

		for (int i = 0; i < t->segments; i++) {
			if (!touches(t, i, b))
				continue;
			if (first < 0)
				first = root_of(t, t->segment[i].chain);
			t->root[root_of(t, t->segment[i].chain)] = first;
		}
	}
}

/* Copy what belongs to the chains of `root` into a system; number[nodes] and border_number[borders] are
 * work space. */
static enum hawser_status divide(struct hawser__lmode_system *to, struct hawser__lmode_draft *t,
                                 int root,
                                 int *number,
                                 int *border_number, struct hawser_report *report)
{
	*to = (struct hawser__lmode_system){.plane = t->plane};
	to->segment = hawser__hold(&to->parts, (size_t)t->segments, sizeof *to->segment);
	to->node = hawser__hold(&to->parts, (size_t)t->nodes, sizeof *to->node);
	to->pendulum = hawser__hold(&to->parts, (size_t)t->pendulums, sizeof *to->pendulum);
	to->border = hawser__hold(&to->parts, (size_t)t->borders, sizeof *to->border);
	if (to->parts.short_of_memory)
		return hawser__no_memory(report, "line modes");
	for (int i = 0; i < t->nodes; i++)
		if (root_of(t, t->node_chain[i]) == root) {
			number[i] = to->nodes;
			to->node[to->nodes++] = t->node[i];
		}
	for (int b = 0; b < t->borders; b++) {
		border_number[b] = -1;
		for (int i = 0; i < t->segments && border_number[b] < 0; i++)
			if (root_of(t, t->segment[i].chain) == root && touches(t, i, b)) {
				border_number[b] = to->borders;
				to->border[to->borders++] = t->border[b];
			}
	}
	for (int i = 0; i < t->segments; i++) {
		struct hawser__lmode_segment *s = &to->segment[to->segments];

		if (root_of(t, t->segment[i].chain) != root)
			continue;
		*s = t->segment[i];
		for (int end = 0; end < HAWSER__ENDS; end++)
			if (s->node[end] >= 0)
				s->node[end] = number[s->node[end]];
		s->border = hawser__hold(&to->parts, 4*(size_t)to->borders, sizeof *s->border);
		if (!s->border)
			return hawser__no_memory(report, "line modes");
		for (int k = 0; k < 4; k++)
			for (int b = 0; b < t->borders; b++)
				if (border_number[b] >= 0)
					s->border[k*to->borders + border_number[b]] =
						t->border_map[(i*4 + k)*t->borders_most + b];
		to->segments++;
	}
	for (int i = 0; i < t->pendulums; i++) {
		struct hawser__lmode_pendulum p = t->pendulum[i];

		if (p.node >= 0 ? root_of(t, t->node_chain[p.node]) != root : border_number[p.border] < 0)
			continue;
		p.node = p.node >= 0 ? number[p.node] : -1;
		p.border = p.border >= 0 ? border_number[p.border] : -1;
		to->pendulum[to->pendulums++] = p;
	}
	return HAWSER_OK;
}

enum hawser_status hawser__lmode_divide(struct hawser__lmode_draft *t, struct hawser_report *report)
{
	struct hawser__lmode *rope = t->rope;
	int *number = calloc((size_t)t->nodes + (size_t)t->borders + 2, sizeof *number);
	enum hawser_status status = HAWSER_OK;

	if (!number)
		return hawser__no_memory(report, "line modes");
	unite(t);
	for (int chain = 0; chain < t->chains && !status; chain++) {
		if (root_of(t, chain) != chain)
			continue;
		if (hawser__more(&rope->system, rope->systems, sizeof *rope->system)) {
			status = hawser__no_memory(report, "line modes");
			break;
		}
		status = divide(&rope->system[rope->systems++], t, chain, number, number + t->nodes + 1,
		                report);
		if (!status && rope->system[rope->systems - 1].segments == 0)
			hawser__lmode_system_clear(&rope->system[--rope->systems]);
	}
	free(number);
	return status;
}

void hawser__lmode_system_clear(struct hawser__lmode_system *system)
{
	for (int i = 0; i < system->segments; i++)
		hawser__lmode_grid_clear(&system->segment[i]);
	hawser__hold_clear(&system->parts);
	hawser__hold_clear(&system->arrays);
	*system = (struct hawser__lmode_system){0};
}
