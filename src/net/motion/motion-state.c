/* net/motion/motion-state.c - the state of a motion as numbers, and in a file (scene/state_file.h).
 *
 * The numbers are those of `head`, and for each node those of `part`. The first of `head` is a check
 * sum of which nodes the elements join: another net with as many nodes is not taken for this one.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "net/motion/motion-contact.h"
#include "scene/state_file.h"

enum { HEAD = 14, PARTS = 6 };
static const char kind[] = "hawser net state 2";

/* Numbers that are not of a node. */
static void heads(double *head[HEAD], struct hawser__motion *motion, double *h, double *sum,
                  double *nodes)
{
	double *list[HEAD] = {sum, nodes, &motion->t, h, &motion->past_h, &motion->past2_h,
	                      &motion->energy.kinetic, &motion->energy.potential, &motion->energy.work,
	                      &motion->energy.dissipated, &motion->start_energy, &motion->most_energy,
	                      &motion->closure, &motion->drift};

	memcpy(head, list, sizeof list);
}

static void parts(double (*part[PARTS])[3], const struct hawser__motion *motion)
{
	double (*list[PARTS])[3] = {motion->reference, motion->u, motion->v, motion->a, motion->past,
	                            motion->past2};

	memcpy(part, list, sizeof list);
}

/* Of the ends of the elements: a whole number below 2^52, which a double holds. */
static double check_sum(const struct hawser__mesh *mesh)
{
	unsigned long long sum = 2166136261U;

	for (int e = 0; e < mesh->elements; e++)
		for (int end = 0; end < 2; end++)
			sum = (sum ^ (unsigned)mesh->end[e][end])*1099511628211ULL;
	return (double)(sum >> 12);
}

/* Numbers of a state; contacts are behind the nodes. */
static int numbers(const struct hawser__mesh *mesh)
{
	return HEAD + 3*PARTS*mesh->nodes +
	       (mesh->touches ? HAWSER__CONTACT_NUMBERS + HAWSER__TOUCH_NUMBERS*mesh->touches : 0) +
	       (hawser__mesh_creeps(mesh->net) ? mesh->elements : 0);
}

int hawser__motion_states(const struct hawser__motion *motion)
{
	return numbers(motion->mesh);
}

void hawser__motion_save(double *state, const struct hawser__motion *motion, double h)
{
	struct hawser__motion copy = *motion;
	double *head[HEAD], nodes = motion->nodes, sum = check_sum(motion->mesh);
	double (*part[PARTS])[3], *begin = state;

	heads(head, &copy, &h, &sum, &nodes);
	parts(part, motion);
	for (int i = 0; i < HEAD; i++)
		*state++ = *head[i];
	for (int i = 0; i < motion->nodes; i++)
		for (int p = 0; p < PARTS; p++, state += 3)
			memcpy(state, part[p][i], sizeof *part[p]);
	if (motion->contact)
		hawser__contact_save(state, motion->contact);
	for (int e = 0, first = numbers(motion->mesh) - motion->elements; e < motion->elements; e++)
		if (hawser__mesh_creeps(motion->mesh->net))
			begin[first + e] = motion->element[e].lag;
}

void hawser__motion_restore(struct hawser__motion *motion, double *h, const double *state)
{
	double *head[HEAD], nodes = 0.0, sum = 0.0; /* read over */
	double (*part[PARTS])[3];
	const double *begin = state;

	heads(head, motion, h, &sum, &nodes);
	parts(part, motion);
	for (int i = 0; i < HEAD; i++)
		*head[i] = *state++;
	for (int i = 0; i < motion->nodes; i++)
		for (int p = 0; p < PARTS; p++, state += 3)
			memcpy(part[p][i], state, sizeof *part[p]);
	if (motion->contact)
		hawser__contact_restore(motion, state);
	for (int e = 0, first = numbers(motion->mesh) - motion->elements; e < motion->elements; e++)
		if (hawser__mesh_creeps(motion->mesh->net))
			motion->element[e].lag = begin[first + e];
	if (motion->water) { /* with the surface as it is now */
		hawser__water_row(motion, (const double (*)[3])motion->a);
		motion->added = hawser__water_kinetic(motion);
	}
	motion->least = INFINITY; /* of what follows */
	motion->slack_at = NAN;
}

int hawser__motion_moves(const double *state, int nodes, int k)
{
	for (int i = 0; i < nodes; i++)
		for (int p = 1; p < 4; p++) /* u, v and a */
			if (state[HEAD + 3*(PARTS*i + p) + k] != 0.0)
				return 1;
	return 0;
}

/* Place of the reference of a node in a state. */
const double *hawser__motion_place(const double *state, int node)
{
	return state + HEAD + (size_t)3*PARTS*(size_t)node;
}

enum hawser_status hawser_net_state_write(const struct hawser_net_motion *motion, const char *path,
                                          struct hawser_report *report)
{
	return hawser__state_write(motion->state, motion->states, kind, path, report);
}

enum hawser_status hawser__motion_read(double **state, const char *path,
                                       const struct hawser__mesh *mesh, struct hawser_report *report)
{
	enum hawser_status status = hawser__state_read(state, numbers(mesh), kind, path, "net", report);
	const int read = *state != NULL;

	if (status || (read && (*state)[0] == check_sum(mesh) && (*state)[1] == mesh->nodes))
		return status;
	free(*state);
	*state = NULL;
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, "net",
	                    "%s is no state of this net, which has %d nodes in its mesh%s: give a file "
	                    "that a run of this scene has written with --state, or one with the same "
	                    "cables[].elements in both", path, mesh->nodes,
	                    read ? ", and joins them in another way" : "");
}
