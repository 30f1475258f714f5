/* ropeway/expand/expand_points.c - the statics and the shapes at the points of the free rope and
 * where it meets circles. SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include "core/hold.h"
#include "core/report.h"
#include "ropeway/expand/expand.h"

static const struct hawser_line_sheave *sheave_of(const struct hawser__lexpand *t, int lane, int sheave)
{
	return &t->rope->lane[lane]->line->sheave[sheave];
}

/* Curvature of a circle, scaled, signed as that of the rope on it. */
static double curvature(const struct hawser__lexpand *t, const struct hawser_line_sheave *sheave)
{
	return -sheave->side*t->rope->length/sheave->radius;
}

void hawser__lexpand_arc(double derivative[2], const struct hawser__lexpand *t,
                         const struct hawser__lmode_segment *s, int i)
{
	double kappa = curvature(t, sheave_of(t, s->piece->lane, s->piece->sheave));

	derivative[0] = -s->piece->delta*s->sine[i]*kappa*kappa;
	derivative[1] = -s->k[i]*kappa*kappa;
}

/* --- points of the free rope --- */

/* A segment of the piece: in the plane if there is one. */
static const struct hawser__lmode_segment *segment_of(const struct hawser__lmode *rope, int piece,
                                                      int *system)
{
	for (int i = 0; i < rope->systems; i++)
		for (int k = 0; k < rope->system[i].segments; k++)
			if (rope->system[i].segment[k].index == piece) {
				*system = i;
				return &rope->system[i].segment[k];
			}
	return NULL;
}

static const struct hawser__lmode_pendulum *pendulum_of(const struct hawser__lexpand *t, int hanger,
                                                        int axis)
{
	const struct hawser__lexpand_hanger *own = &t->hanger[hanger];

	return &t->rope->system[own->system[axis]].pendulum[own->pendulum[axis]];
}

static void find_hangers(struct hawser__lexpand *t)
{
	int *of = hawser__hold(&t->hold, (size_t)t->rope->masses + 1, sizeof *of);

	for (int pass = 0; of && pass < 2; pass++)
		for (int i = 0; i < t->rope->systems; i++)
			for (int k = 0; k < t->rope->system[i].pendulums; k++) {
				const struct hawser__lmode_pendulum *one = &t->rope->system[i].pendulum[k];
				int axis = t->rope->system[i].plane == HAWSER_OUT_OF_PLANE ? 2 : !one->vertical;

				if (pass == 0 && one->vertical)
					of[one->carrier] = t->hangers++;
				if (pass == 0)
					continue;
				t->hanger[of[one->carrier]].system[axis] = i;
				t->hanger[of[one->carrier]].pendulum[axis] = k;
			}
}

static void place_hanger(struct hawser__lexpand *t, int hanger)
{
	const struct hawser__lmode_pendulum *one = pendulum_of(t, hanger, 0);
	int p = t->points - t->hangers + hanger;

	t->stretch[p] = 1.0 + t->rope->soft;
	t->weight[p] = one->length/t->stretch[p];
	t->tau[p] = one->weight;
	t->epsilon[p] = t->rope->soft/one->weight;
}

static enum hawser_status place_points(struct hawser__lexpand *t, struct hawser_report *report)
{
	const struct hawser__lmode *rope = t->rope;

	t->first = hawser__hold(&t->hold, (size_t)rope->pieces + 1, sizeof *t->first);
	if (t->hold.short_of_memory)
		return hawser__no_memory(report, "line rom");
	for (int i = 0; i < rope->pieces; i++) {
		int system;
		const struct hawser__lmode_segment *s = segment_of(rope, i, &system);

		t->first[i] = s && !s->arc ? t->points : -1;
		t->points += s && !s->arc ? s->grid.points : 0;
	}
	t->hanger = hawser__hold(&t->hold, (size_t)rope->masses + 1, sizeof *t->hanger);
	if (t->hanger)
		find_hangers(t);
	t->points += t->hangers;
	t->weight = hawser__hold(&t->hold, (size_t)t->points, sizeof(double));
	t->stretch = hawser__hold(&t->hold, (size_t)t->points, sizeof(double));
	t->tau = hawser__hold(&t->hold, (size_t)t->points, sizeof(double));
	t->epsilon = hawser__hold(&t->hold, (size_t)t->points, sizeof(double));
	t->slope = hawser__hold(&t->hold, 3*(size_t)t->points*(size_t)t->n, sizeof(double));
	if (t->hold.short_of_memory)
		return hawser__no_memory(report, "line rom");
	for (int i = 0; i < rope->pieces; i++) {
		const struct hawser__lmode_piece *piece = &rope->piece[i];
		int system;
		const struct hawser__lmode_segment *s = segment_of(rope, i, &system);

		for (int k = 0; t->first[i] >= 0 && k < s->grid.points; k++) {
			double T, g;

			hawser_line_at(rope->lane[piece->lane], NULL, NULL, &T, &g, NULL,
			               (piece->s0 + s->grid.s[k])*rope->length);
			t->weight[t->first[i] + k] = s->grid.weight[k];
			t->stretch[t->first[i] + k] = g;
			t->tau[t->first[i] + k] = T/rope->force;
			t->epsilon[t->first[i] + k] = rope->epsilon;
		}
	}
	for (int i = 0; i < t->hangers; i++)
		place_hanger(t, i);
	return HAWSER_OK;
}

static void fill_slopes(struct hawser__lexpand *t, int j)
{
	const struct hawser__lmode_system *system = &t->rope->system[t->shape[j].system];
	double *slope = t->slope + 3*(size_t)t->points*(size_t)j;

	for (int i = 0; i < system->segments; i++) {
		const struct hawser__lmode_segment *s = &system->segment[i];
		const double *strain = t->shape[j].strain + s->strain;
		int first = t->first[s->index], points = s->grid.points;

		for (int k = 0; first >= 0 && k < points; k++) {
			double *a = slope + 3*(first + k);

			if (s->D == 2) {
				a[0] = s->sa*strain[k];
				a[1] = s->sb[k]*strain[points + k];
			} else {
				a[2] = s->sb[k]*strain[k];
			}
		}
	}
	for (int i = 0; i < 3*t->hangers; i++) {
		const struct hawser__lmode_pendulum *one = pendulum_of(t, i/3, i%3);
		int p = t->points - t->hangers + i/3;

		if (t->hanger[i/3].system[i%3] == t->shape[j].system)
			slope[3*p + i%3] = (i%3 ? 1.0 : -1.0)/t->weight[p]*
			                   hawser__lmode_stroke(one, t->shape[j].x, system);
	}
}

/* --- ends at sheaves --- */

/* The segment of a piece in the system of one plane; -1: none. */
static void find_segment(struct hawser__lexpand_end *end, const struct hawser__lmode *rope,
                         enum hawser_plane plane)
{
	int which = plane == HAWSER_OUT_OF_PLANE;

	end->segment[which] = end->system[which] = -1;
	for (int i = 0; i < rope->systems; i++)
		for (int k = 0; rope->system[i].plane == plane && k < rope->system[i].segments; k++)
			if (rope->system[i].segment[k].index == end->piece) {
				end->system[which] = i;
				end->segment[which] = k;
			}
}

static enum hawser_status place_end(struct hawser__lexpand_end *to, const struct hawser__lexpand *t,
                                    const struct hawser__lmode_joint *joint,
                                    struct hawser_report *report)
{
	const struct hawser__lmode *rope = t->rope;
	const struct hawser__lmode_piece *piece = &rope->piece[to->piece];
	const struct hawser_line_sheave *sheave = sheave_of(t, to->lane, joint->sheave);
	int beyond = to->end ? to->piece + 1 : to->piece - 1;
	double circle = joint->tangent[!to->end], T, g, V = piece->V, across;

	to->sheave = joint->sheave;
	to->smooth = joint->mass < 0;
	if (!(sheave->radius > 0.0))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "line rom", "sheave %s has the radius 0: the "
		                    "rope that leaves a point is no nonlinear model of a battery, give it a "
		                    "radius", sheave->name);
	if (to->smooth && rope->piece[beyond].sheave < 0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "line rom", "the rope touches sheave %s at "
		                    "one point, which it leaves by any motion: there is no model of small "
		                    "motions", sheave->name);
	find_segment(to, rope, HAWSER_IN_PLANE);
	find_segment(to, rope, HAWSER_OUT_OF_PLANE);
	to->node = to->system[0] < 0 ? -1
	           : rope->system[to->system[0]].segment[to->segment[0]].node[to->end];
	V += to->end ? piece->delta*piece->length : 0.0;
	T = hypot(piece->H, V);
	g = 1.0 + rope->epsilon*T;
	to->T = T;
	to->kappa = curvature(t, sheave);
	across = piece->delta*piece->H/T; /* weight along the normal */
	to->gap = to->kappa - across/(T*g);
	to->turn = to->smooth ? 0.0 : circle - piece->angle[to->end];
	to->along = T*cos(to->turn);
	to->across = -T*sin(to->turn);
	circle -= atan2(piece->reference[1], piece->reference[0]);
	to->tangent[0] = cos(circle);
	to->tangent[1] = sin(circle);
	if (to->gap*to->kappa <= 0.0)
		return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "line rom", "at sheave %s the free rope is "
		                    "curved more than the circle: it does not press on it", sheave->name);
	for (int f = 0; f < HAWSER__FORMS; f++)
		if (!(to->form[f] = hawser__numbers((size_t)t->n, 1)))
			return hawser__no_memory(report, "line rom");
	return HAWSER_OK;
}

static enum hawser_status place_weight(struct hawser__lexpand *t, int lane,
                                       const struct hawser__lmode_joint *joint, int system, int node,
                                       struct hawser_report *report)
{
	const struct hawser_line *line = t->rope->lane[lane]->line;
	struct hawser__lexpand_weight *to = &t->mass[t->weights++];
	double W = line->mass[joint->mass].mass*line->g/t->rope->force;
	double kappa = curvature(t, &line->sheave[joint->sheave]), angle = joint->tangent[0];

	*to = (struct hawser__lexpand_weight){.system = system, .node = node,
		.third = -W*sin(angle)*kappa*kappa, .fourth = -W*cos(angle)*kappa*kappa*kappa};
	to->u = hawser__numbers((size_t)t->n, 1);
	return to->u ? HAWSER_OK : hawser__no_memory(report, "line rom");
}

/* Node of the system in the plane at the beginning of a piece. */
static int node_before(const struct hawser__lexpand *t, int piece, int *system)
{
	for (int i = 0; i < t->rope->systems; i++)
		for (int k = 0; t->rope->system[i].plane == HAWSER_IN_PLANE && k < t->rope->system[i].segments;
		     k++) {
			const struct hawser__lmode_segment *s = &t->rope->system[i].segment[k];

			if (s->index != piece && s->index != piece - 1)
				continue;
			*system = i;
			return s->node[s->index == piece ? 0 : 1];
		}
	return -1;
}

static enum hawser_status place_joint(struct hawser__lexpand *t, int lane, int piece, int i,
                                      struct hawser_report *report)
{
	const struct hawser__lmode *rope = t->rope;
	struct hawser__lmode_joint joint = hawser__lmode_joint(rope, lane, i);
	enum hawser_status status = HAWSER_OK;
	int system = -1, node;

	if (joint.sheave < 0)
		return HAWSER_OK;
	for (int end = 0; end < HAWSER__ENDS && !status; end++) {
		struct hawser__lexpand_end *to = &t->end[t->ends];

		if (rope->piece[piece - end].sheave >= 0)
			continue;
		*to = (struct hawser__lexpand_end){.piece = piece - end, .end = end, .lane = lane};
		t->ends++;
		status = place_end(to, t, &joint, report);
	}
	node = node_before(t, piece, &system);
	if (!status && joint.mass >= 0 && node >= 0)
		status = place_weight(t, lane, &joint, system, node, report);
	return status;
}

/* --- forms --- */

static void fill_end(struct hawser__lexpand *t, struct hawser__lexpand_end *end, int j)
{
	const struct hawser__lmode *rope = t->rope;
	const struct hawser__lexpand_shape *shape = &t->shape[j];
	const struct hawser__lmode_system *system = &rope->system[shape->system];
	int which = system->plane == HAWSER_OUT_OF_PLANE;
	const struct hawser__lmode_segment *s;
	double slope[3], s_end, along, across, g = 1.0 + rope->epsilon*end->T;

	if (end->system[which] != shape->system)
		return;
	s = &system->segment[end->segment[which]];
	s_end = end->end ? s->grid.edge[s->grid.elements] : 0.0;
	hawser__grid_at(slope, &s->grid, t->slope + 3*((size_t)t->points*(size_t)j +
	                (size_t)t->first[end->piece]), 3, 3, s_end);
	if (which) {
		end->form[HAWSER__FORM_ASIDE][j] = slope[2]/g;
		return;
	}
	along = slope[0]/rope->epsilon;
	across = slope[1]*end->T/g;
	if (end->node >= 0)
		end->form[HAWSER__FORM_U][j] = shape->x[system->node[end->node].at];
	end->form[HAWSER__FORM_ALONG][j] = along*cos(end->turn) + across*sin(end->turn);
	end->form[HAWSER__FORM_ACROSS][j] = across*cos(end->turn) - along*sin(end->turn);
	end->form[HAWSER__FORM_OPENING][j] = end->form[HAWSER__FORM_ACROSS][j]/end->T -
		end->kappa*end->form[HAWSER__FORM_U][j];
}

enum hawser_status hawser__lexpand_points(struct hawser__lexpand *t, struct hawser_report *report)
{
	const struct hawser__lmode *rope = t->rope;
	enum hawser_status status = place_points(t, report);

	t->end = hawser__hold(&t->hold, 2*(size_t)rope->pieces + 1, sizeof *t->end);
	t->mass = hawser__hold(&t->hold, (size_t)rope->pieces + 1, sizeof *t->mass);
	if (!status && (!t->end || !t->mass))
		status = hawser__no_memory(report, "line rom");
	for (int lane = 0, at = 0; lane < rope->lanes && !status; at += rope->lane[lane++]->pieces)
		for (int i = 1; i < rope->lane[lane]->pieces && !status; i++)
			status = place_joint(t, lane, at + i, i, report);
	for (int j = 0; j < t->n && !status; j++) {
		fill_slopes(t, j);
		for (int i = 0; i < t->ends; i++)
			fill_end(t, &t->end[i], j);
		for (int i = 0; i < t->weights; i++)
			if (t->mass[i].system == t->shape[j].system)
				t->mass[i].u[j] =
					t->shape[j].x[rope->system[t->mass[i].system].node[t->mass[i].node].at];
	}
	return status;
}
