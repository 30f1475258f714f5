/* ropeway/expand/expand_follow.c - what the rest of the rope does while some shapes move: its static
 * response to the quadratic forces of pairs of them.
 *
 *   W_jk       minimises V2(W) + D^3V3[Phi_j, Phi_k, W] with the ends of the free rope lifted as in
 *              expand_ends.c
 *   w_jk       W_jk without its part along the shapes: since K w = - D^3V3, W_jk has the coordinate
 *              -T_jks/omega_s^2 along the mode s, T the third derivatives
 *   src        strains of the forces D^3V3, and e the strains of W_jk: e + src is that of the force
 *
 * The part of one way (jk)(lm) to pair four indices in the fourth derivative is
 *
 *   D^4V4 + K[W, W'] + D^3V3[.., W'] + D^3V3'[.., W] + sum_s T_jks T_lms/omega_s^2
 *     = D^4V4 + (e + src).(e' + src') - src.src' + ...
 *
 * in which the terms sigma sigma'/eps of a nearly inextensible rope cancel: the integral of V4 has
 * sigma sigma'/(g^3 eps), src.src' has sigma sigma'/(g^4 eps), and the difference is sigma sigma'
 * tau/g^4 with the tension tau = (g - 1)/eps. All pairs are the product of two matrices.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/hold.h"
#include "core/report.h"
#include "ropeway/expand/expand.h"

/* Columns of the matrices by point of the free rope: of V4, and of src along b and c. */
enum { FIELDS = 5 };

struct work {
	struct hawser__lexpand *t;
	double *left, *right;  /* [pairs][width]; the product left right' is the pairing */
	size_t width;
	double *source, *load; /* of a system */
	double (*lift)[HAWSER__ENDS][2];
	double *off;
	struct hawser__hold hold;
};

/* Entries of a system in a row: a strain each, and two of each value of the state. */
static size_t width_of(const struct hawser__lmode_system *system)
{
	return (size_t)system->strains + 2*(size_t)system->size;
}

/* --- forces of a pair --- */

/* alpha, beta, gamma times eps at a point. */
static void force(double f[3], const struct hawser__lexpand *t, int p, int j, int k)
{
	const double *x = t->slope + 3*((size_t)t->points*(size_t)j + (size_t)p);
	const double *y = t->slope + 3*((size_t)t->points*(size_t)k + (size_t)p);

	hawser__pair_force(f, x, y);
	for (int c = 0; c < 3; c++)
		f[c] /= t->stretch[p]*t->stretch[p];
}

/* Where the masses on hangers are without the rope's motion: as high as a swing lifts them. */
static void add_hangers(const struct work *w, int system, int j, int k)
{
	const struct hawser__lexpand *t = w->t;

	for (int i = 0; i < 3*t->hangers; i++) {
		const struct hawser__lexpand_hanger *hanger = &t->hanger[i/3];
		const struct hawser__lmode_pendulum *one;
		int p = t->points - t->hangers + i/3;
		double f[3];

		if (hanger->system[i%3] != system)
			continue;
		one = &t->rope->system[system].pendulum[hanger->pendulum[i%3]];
		force(f, t, p, j, k);
		w->off[one->at] = (i%3 ? -1.0 : 1.0)*one->compliance*f[i%3]/t->epsilon[p];
	}
}

static void add_segment(const struct work *w, const struct hawser__lmode_segment *s, int system, int j,
                        int k)
{
	const struct hawser__lexpand *t = w->t;
	double eps = t->rope->epsilon, *source = w->source + s->strain, *load = w->load + s->at;
	int points = s->grid.points, first = t->first[s->index];
	int own = t->shape[j].system == system && t->shape[k].system == system;

	for (int p = 0; p < points; p++) {
		double f[3], derivative[2];

		if (first < 0) { /* an arc: the weight alone */
			if (!own || t->rope->system[system].plane != HAWSER_IN_PLANE)
				continue;
			hawser__lexpand_arc(derivative, t, s, p);
			load[p] = -derivative[0]*t->shape[j].x[s->at + p]*t->shape[k].x[s->at + p];
			continue;
		}
		force(f, t, first + p, j, k);
		if (s->D == 2) {
			source[p] = s->sa*f[0]/eps;
			source[points + p] = s->sb[p]*f[1]/eps;
		} else {
			source[p] = s->sb[p]*f[2]/eps;
		}
	}
}

static void add_ends(const struct work *w, int system, int j, int k)
{
	const struct hawser__lexpand *t = w->t;

	for (int i = 0; i < t->ends; i++) {
		const struct hawser__lexpand_end *end = &t->end[i];
		double lift[2];

		hawser__lexpand_lift(lift, t, end, j, k);
		if (end->system[1] == system)
			w->lift[end->segment[1]][end->end][0] = lift[1];
		if (end->system[0] != system)
			continue;
		w->lift[end->segment[0]][end->end][0] = -lift[0]*end->tangent[1];
		w->lift[end->segment[0]][end->end][1] = lift[0]*end->tangent[0];
		if (end->node >= 0)
			w->load[t->rope->system[system].node[end->node].at] += hawser__lexpand_push(t, end, j, k);
	}
	for (int i = 0; i < t->weights; i++) {
		const struct hawser__lexpand_weight *mass = &t->mass[i];

		if (mass->system == system)
			w->load[t->rope->system[system].node[mass->node].at] -= mass->third*mass->u[j]*mass->u[k];
	}
}

/* --- rows --- */

/* The pair's entries for a system, of its response x with its strains. */
static void fill_row(double *left, double *right, const struct work *w,
                     const struct hawser__lmode_system *system, const double *x, const double *strain)
{
	double *state[2] = {left + system->strains, right + system->strains};

	for (int i = 0; i < system->segments; i++) {
		const struct hawser__lmode_segment *s = &system->segment[i];
		int points = s->grid.points;

		for (int p = 0; p < s->D*points; p++)
			left[s->strain + p] = right[s->strain + p] =
				sqrt(s->grid.weight[p%points])*(strain[s->strain + p] + w->source[s->strain + p]);
		for (int p = 0; s->k && p < points; p++) {
			double weight = s->grid.weight[p];

			state[0][2*(s->at + p)] = weight*(s->k[p]*x[s->at + p] - w->load[s->at + p]);
			state[1][2*(s->at + p)] = x[s->at + p];
			state[0][2*(s->at + p) + 1] = x[s->at + p];
			state[1][2*(s->at + p) + 1] = -weight*w->load[s->at + p];
		}
	}
	for (int i = 0; i < system->nodes; i++)
		for (int d = 0; d < system->node[i].dofs; d++) {
			const struct hawser__lmode_node *node = &system->node[i];
			int at = node->at + d;
			double pull = -w->load[at];

			for (int e = 0; e < node->dofs; e++)
				pull += node->stiffness[d][e]*x[node->at + e];
			state[0][2*at] = pull;
			state[1][2*at] = x[at];
			state[0][2*at + 1] = x[at];
			state[1][2*at + 1] = -w->load[at];
		}
	for (int i = 0; i < system->borders; i++) {
		int at = system->border[i].at;

		state[0][2*at] = system->border[i].stiffness*x[at];
		state[1][2*at] = x[at];
	}
}

/* What does not depend on the response: V4, and src.src'. */
static void fill_points(double *left, double *right, const struct hawser__lexpand *t, int j, int k)
{
	for (int p = 0; p < t->points; p++) {
		const double *x = t->slope + 3*((size_t)t->points*(size_t)j + (size_t)p);
		const double *y = t->slope + 3*((size_t)t->points*(size_t)k + (size_t)p);
		double g = t->stretch[p], weight = t->weight[p], f[3], sb2 = g/t->tau[p];
		double eps = t->epsilon[p], sigma = x[1]*y[1] + x[2]*y[2];
		double aa = -2.0*weight/(g*g*g*eps)*x[0]*y[0];

		force(f, t, p, j, k);
		left[FIELDS*p] = weight*t->tau[p]/(g*g*g*g)*sigma + aa;
		right[FIELDS*p] = sigma;
		left[FIELDS*p + 1] = sigma;
		right[FIELDS*p + 1] = aa;
		for (int c = 1; c < 3; c++) {
			left[FIELDS*p + 1 + c] = -weight*sb2/(eps*eps)*f[c];
			right[FIELDS*p + 1 + c] = f[c];
		}
	}
}

/* The response of one system to a pair. */
static void answer(const struct work *w, size_t column, int i, int j, int k)
{
	struct hawser__lexpand *t = w->t;
	struct hawser__lmode_system *system = &t->rope->system[i];
	size_t pair = (size_t)hawser__pair(j, k);
	struct hawser__lexpand_part part = hawser__lexpand_part(t->rope, t->second + pair*t->width, i);
	const struct hawser__lmode_given given = {w->source, (const double (*)[HAWSER__ENDS][2])w->lift,
	                                          w->off};

	memset(w->source, 0, (size_t)system->strains*sizeof *w->source);
	memset(w->load, 0, (size_t)system->size*sizeof *w->load);
	memset(w->lift, 0, (size_t)system->segments*sizeof *w->lift);
	memset(w->off, 0, (size_t)system->size*sizeof *w->off);
	for (int s = 0; s < system->segments; s++)
		add_segment(w, &system->segment[s], i, j, k);
	add_ends(w, i, j, k);
	add_hangers(w, i, j, k);
	hawser__lmode_static_given(part.x, part.strain, system, w->load, &given);
	fill_row(w->left + pair*w->width + column, w->right + pair*w->width + column, w, system, part.x,
	         part.strain);
}

/* Remove the part along the modes, and add that of the energy: one column for each. */
static void remove_modes(const struct work *w, size_t column, int j, int k)
{
	struct hawser__lexpand *t = w->t;
	size_t pair = (size_t)hawser__pair(j, k);

	for (int s = 0; s < t->n; s++) {
		const struct hawser__lexpand_shape *mode = &t->shape[s];
		const struct hawser__lmode_system *system = &t->rope->system[mode->system];
		struct hawser__lexpand_part to = hawser__lexpand_part(t->rope, t->second + pair*t->width,
		                                                      mode->system);
		double third = t->third[((size_t)j*(size_t)t->n + (size_t)k)*(size_t)t->n + (size_t)s], part;

		if (!(mode->omega > 0.0))
			continue;
		part = third/(mode->omega*mode->omega);
		w->left[pair*w->width + column + (size_t)s] = third/mode->omega;
		w->right[pair*w->width + column + (size_t)s] = third/mode->omega;
		cblas_daxpy(system->size, part, mode->x, 1, to.x, 1);
		cblas_daxpy(system->strains, part, mode->strain, 1, to.strain, 1);
	}
}

static enum hawser_status allocate(struct work *w, struct hawser_report *report)
{
	struct hawser__lexpand *t = w->t;
	size_t most = 0, segments = 0, pairs = (size_t)t->pairs;

	t->width = hawser__lexpand_width(t->rope);
	t->second = hawser__numbers(pairs, t->width);
	w->width = FIELDS*(size_t)t->points + (size_t)t->n;
	for (int i = 0; i < t->rope->systems; i++) {
		const struct hawser__lmode_system *system = &t->rope->system[i];

		w->width += width_of(system);
		most = most > width_of(system) ? most : width_of(system);
		segments = segments > (size_t)system->segments ? segments : (size_t)system->segments;
	}
	w->left = hawser__hold(&w->hold, pairs*w->width, sizeof *w->left);
	w->right = hawser__hold(&w->hold, pairs*w->width, sizeof *w->right);
	w->source = hawser__hold(&w->hold, most, sizeof *w->source);
	w->load = hawser__hold(&w->hold, most, sizeof *w->load);
	w->off = hawser__hold(&w->hold, most, sizeof *w->off);
	w->lift = hawser__hold(&w->hold, segments, sizeof *w->lift);
	return t->second && !w->hold.short_of_memory ? HAWSER_OK : hawser__no_memory(report, "line rom");
}

enum hawser_status hawser__lexpand_follow(struct hawser__lexpand *t, struct hawser_report *report)
{
	struct work w = {.t = t};
	enum hawser_status status = allocate(&w, report);

	for (int k = 0; k < t->n && !status; k++)
		for (int j = 0; j <= k; j++) {
			size_t pair = (size_t)hawser__pair(j, k), column = FIELDS*(size_t)t->points;

			fill_points(w.left + pair*w.width, w.right + pair*w.width, t, j, k);
			for (int i = 0; i < t->rope->systems; i++) {
				answer(&w, column, i, j, k);
				column += width_of(&t->rope->system[i]);
			}
			remove_modes(&w, column, j, k);
		}
	if (!status)
		cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasTrans, t->pairs, t->pairs, (int)w.width, 1.0,
		            w.left, (int)w.width, w.right, (int)w.width, 0.0, t->pairing, t->pairs);
	hawser__hold_clear(&w.hold);
	return status;
}
