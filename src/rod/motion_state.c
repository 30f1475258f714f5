/* rod/motion_state.c - the state of a motion as numbers, and in a file (scene/state_file.h).
 *
 * The numbers are those of `heads`, and of each node place, quaternion and `parts`. The first is a
 * check sum of the lengths and stiffnesses of the elements: another rod with as many nodes is not taken
 * for this one.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "rod/run.h"
#include "scene/state_file.h"

enum { HEAD = 43, PARTS = 5, NODE = 7 + 6*PARTS };
static const char kind[] = "hawser rod state 1";

static double check_sum(const struct hawser__rod_motion *motion)
{
	const struct hawser__rod_mesh *mesh = motion->mesh;
	const struct hawser__rod_winch *winch = &motion->winch;
	unsigned long long sum = 2166136261U;

	for (int e = 0; e < mesh->elements; e++) {
		const struct hawser__rod_element *el = &mesh->element[e];
		double h = winch->as && e < winch->elements ? winch->part[e]*winch->first : el->h;
		const double of[] = {h, el->EA[0], el->EA[1], el->EA[2], el->EI[0], el->EI[1], el->EI[2]};

		for (size_t i = 0; i < sizeof of/sizeof *of; i++) {
			unsigned long long bits;

			memcpy(&bits, &of[i], sizeof bits);
			sum = (sum ^ bits)*1099511628211ULL;
		}
	}
	return (double)(sum >> 12); /* a whole number below 2^52, which a double holds */
}

/* Numbers that are not of a node: their addresses. */
static void heads(double *head[HEAD], struct hawser__rod_motion *motion, double *h, double *turned)
{
	double *const list[] = {&motion->t, h, turned, &motion->past_h, &motion->past2_h,
	                        &motion->start_energy, &motion->most_energy, &motion->most_momentum,
	                        &motion->most_angular, &motion->energy_lost, &motion->momentum_gap,
	                        &motion->angular_gap, &motion->drift, &motion->h, &motion->energy.kinetic,
	                        &motion->energy.strain, &motion->energy.height, &motion->energy.work,
	                        &motion->energy.pushed, &motion->energy.support, &motion->energy.damped,
	                        &motion->energy.winch, &motion->winch.length, &motion->winch.over};
	double *const triple[] = {motion->momentum.linear, motion->momentum.angular, motion->momentum.force,
	                          motion->momentum.moment, motion->start, motion->start + 3};
	int count = 0;

	for (size_t i = 0; i < sizeof list/sizeof *list; i++)
		head[count++] = list[i];
	for (size_t i = 0; i < sizeof triple/sizeof *triple; i++)
		for (int k = 0; k < 3; k++)
			head[count++] = triple[i] + k;
	while (count < HEAD)
		head[count++] = NULL;
}

/* The numbers in their order: out of the motion (to 1), or into it. */
static void copy(double *state, struct hawser__rod_motion *motion, double *h, double *turned, int to)
{
	double *head[HEAD];
	double (*const part[PARTS])[6] = {motion->velocity, motion->rate, motion->mean, motion->past,
	                                  motion->past2};

	heads(head, motion, h, turned);
	for (int i = 0; i < HEAD; i++, state++)
		if (head[i])
			*(to ? state : head[i]) = *(to ? head[i] : state);
	for (int i = 0; i < motion->mesh->nodes; i++) {
		struct hawser__rod_node *node = &motion->mesh->node[i];

		memcpy(to ? state : node->x, to ? node->x : state, 3*sizeof *state);
		memcpy(to ? state + 3 : node->q, to ? node->q : state + 3, 4*sizeof *state);
		state += 7;
		for (int p = 0; p < PARTS; p++, state += 6)
			memcpy(to ? state : part[p][i], to ? part[p][i] : state, 6*sizeof *state);
	}
}

int hawser__rod_state_size(const struct hawser__rod_mesh *mesh)
{
	return 1 + HEAD + NODE*mesh->nodes;
}

void hawser__rod_state_give(double *state, const struct hawser__rod_motion *motion, double h,
                            double turned)
{
	struct hawser__rod_motion same = *motion;

	state[0] = check_sum(motion);
	copy(state + 1, &same, &h, &turned, 1);
}

int hawser__rod_state_take(struct hawser__rod_motion *motion, double *h, double *turned,
                           double *state)
{
	if (state[0] != check_sum(motion))
		return 0;
	copy(state + 1, motion, h, turned, 0);
	return 1;
}

enum hawser_status hawser__rod_state_save(double **state, int *states,
                                          const struct hawser__rod_motion *motion, double h,
                                          double turned, struct hawser_report *report)
{
	*states = hawser__rod_state_size(motion->mesh);
	*state = calloc((size_t)*states, sizeof **state);
	if (!*state)
		return hawser__no_memory(report, "rod");
	hawser__rod_state_give(*state, motion, h, turned);
	return HAWSER_OK;
}

enum hawser_status hawser__rod_state_read(struct hawser__rod_motion *motion, double *h, double *turned,
                                          const char *path, struct hawser_report *report)
{
	double *state;
	enum hawser_status status = hawser__state_read(&state, hawser__rod_state_size(motion->mesh), kind,
	                                               path, "rod", report);
	const int good = state && hawser__rod_state_take(motion, h, turned, state);

	free(state);
	return status || good ? status
		: hawser__fail(report, HAWSER_ERR_ARGUMENT, "rod", "%s is no state of this rod with %d "
		               "elements: give a file that a run of this scene has written with --state", path,
		               motion->mesh->elements);
}

enum hawser_status hawser_rod_state_write(const struct hawser_rod_motion *motion, const char *path,
                                          struct hawser_report *report)
{
	return hawser__state_write(motion->state, motion->states, kind, path, report);
}
