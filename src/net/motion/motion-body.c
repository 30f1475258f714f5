/* net/motion/motion-body.c - rigid bodies in a step.
 *
 * c0, r0  place of a body and arm of a node at the beginning of the step; r1 at its end
 * X, w    displacement, and Cayley vector of the turn: 2 tan(angle/2) along its axis
 * x       increment of a node: X + (w x r0 + w x (w x r0)/2)/(1 + w.w/4) = X + w x (r0 + r1)/2
 * F       what holds a node in the step: the residual there, inertia and water with it
 *
 * Since x = X + w x r with the mean arm r, the sum of F and that of r x F have no work: with both 0 the
 * energy, the momentum and the angular momentum of a body are kept as those of free nodes, and the
 * ledger is that of the nodes. Their velocities follow by the trapezoidal rule.
 *
 * Newton's method: with the body held, all other nodes are those of the matrix A of the step. A column
 * z is their answer to a motion of a body, and the equations of the bodies have the matrix S of what
 * each motion changes in the sums. A small turn d adds d x r1 to x, and to the vector w as turns do.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include <lapacke.h>

#include "core/report.h"
#include "core/vec3.h"
#include "net/body.h"
#include "net/motion/motion.h"

enum { M = HAWSER__BODY_MOTIONS };
/* Of its length: nodes nearer to a line are on it. */
static const double STRAIGHT = 1e-9;

void hawser__bodies_close(struct hawser__motion_bodies *bodies)
{
	if (!bodies)
		return;
	hawser__hold_clear(&bodies->hold);
	free(bodies);
}

/* A support that is no longer there does not hold; what nothing moves stays. */
static int motions_of(struct hawser__motion_body *body, const struct hawser_net *net, int number,
                      const unsigned char *loose, const int still[3])
{
	double about[3], all[M][M];
	int n = hawser__body_motions(all, about, net, &net->body[number], loose);

	body->node = -1;
	for (int i = 0; i < net->body[number].nodes && n > 0 && n < M; i++) {
		int node = net->body[number].node[i];

		if (net->node[node].support && !(loose && loose[node]) && body->node < 0)
			body->node = node;
	}
	for (int j = 0; j < n; j++) {
		int moves = 1;

		for (int k = 0; k < 3; k++)
			moves = moves && !(all[k][j] != 0.0 && still[k]) &&
			        !(all[3 + k][j] != 0.0 && (still[(k + 1)%3] || still[(k + 2)%3]));
		for (int k = 0; k < M && moves; k++)
			body->motion[k][body->motions] = all[k][j];
		body->motions += moves;
	}
	return body->motions;
}

enum hawser_status hawser__bodies_start(struct hawser__motion *motion, const struct hawser_net *net,
                                        const unsigned char *loose, const int still[3],
                                        struct hawser_report *report)
{
	struct hawser__motion_bodies *all;
	size_t nodes = (size_t)motion->nodes, n = 0;

	if (!net->bodies)
		return HAWSER_OK;
	for (int i = 0; i < motion->mesh->touches; i++)
		if (!(motion->mesh->touch[i].give > 0.0))
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "net", "%s: in motions rigid bodies and "
			                    "rigid obstacles contradict each other: give the bed a stiffness, such "
			                    "as obstacles.%s.stiffness=3 MPa/m", net->name,
			                    motion->mesh->touch[i].surface->name);
	all = motion->bodies = calloc(1, sizeof *all);
	if (!all)
		return hawser__no_memory(report, "net");
	all->bodies = net->bodies;
	all->body = hawser__hold(&all->hold, (size_t)net->bodies, sizeof *all->body);
	for (int b = 0; b < net->bodies && all->body; b++)
		n += (size_t)motions_of(&all->body[b], net, b, loose, still);
	all->motions = (int)n;
	all->r0 = hawser__hold(&all->hold, nodes, sizeof *all->r0);
	all->r1 = hawser__hold(&all->hold, nodes, sizeof *all->r1);
	all->F = hawser__hold(&all->hold, nodes, sizeof *all->F);
	all->answer = hawser__hold(&all->hold, nodes, sizeof *all->answer);
	all->column = hawser__hold(&all->hold, n*nodes + 1, sizeof *all->column);
	all->S = hawser__hold(&all->hold, n*n + 1, sizeof *all->S);
	all->sum = hawser__hold(&all->hold, n + 1, sizeof *all->sum);
	all->pivot = hawser__hold(&all->hold, n + 1, sizeof *all->pivot);
	return all->hold.short_of_memory ? hawser__no_memory(report, "net") : HAWSER_OK;
}

/* Places of nodes for X and w, and their velocities. */
static void place_nodes(struct hawser__motion *motion)
{
	struct hawser__motion_bodies *all = motion->bodies;

	for (int i = 0; i < motion->nodes; i++) {
		int number = motion->mesh->rigid[i];
		const struct hawser__motion_body *body = number ? &all->body[number - 1] : NULL;
		double first[3], second[3], part;

		if (!body || !body->motions)
			continue;
		hawser__cross(first, body->w, all->r0[i]);
		hawser__cross(second, body->w, first);
		part = 1.0/(1.0 + 0.25*hawser__dot(body->w, body->w));
		for (int k = 0; k < 3; k++) {
			double turn = part*(first[k] + 0.5*second[k]);

			all->r1[i][k] = all->r0[i][k] + turn;
			motion->x[i][k] = body->X[k] + turn;
			motion->v[i][k] = 2.0*motion->x[i][k]/all->h - motion->v0[i][k];
		}
	}
}

/* The place of a body: its hinge, or the mean of its nodes. */
static void centre_of(double c[3], const struct hawser__motion *motion, int b)
{
	const struct hawser__motion_body *body = &motion->bodies->body[b];
	int count = 0;

	memset(c, 0, 3*sizeof *c);
	for (int i = 0; i < motion->nodes; i++)
		if (motion->mesh->rigid[i] == b + 1 && (body->node < 0 || i == body->node)) {
			for (int k = 0; k < 3; k++)
				c[k] += motion->reference[i][k] + motion->u0[i][k];
			count++;
		}
	for (int k = 0; k < 3; k++)
		c[k] /= count;
}

/* Only what the motions of a body allow. */
static void allow(struct hawser__motion_body *body)
{
	double to[M] = {0.0};

	for (int j = 0; j < body->motions; j++) {
		double along = 0.0;

		for (int k = 0; k < 3; k++)
			along += body->motion[k][j]*body->X[k] + body->motion[3 + k][j]*body->w[k];
		for (int k = 0; k < M; k++)
			to[k] += along*body->motion[k][j];
	}
	memcpy(body->X, to, sizeof body->X);
	memcpy(body->w, to + 3, sizeof body->w);
}

/* X and w that are nearest to the increments that nodes would have. */
static void fit(struct hawser__motion *motion, int b)
{
	struct hawser__motion_bodies *all = motion->bodies;
	struct hawser__motion_body *body = &all->body[b];
	double A[3][3] = {{0.0}}, right[3] = {0.0}, count = 0.0, least = 0.0;

	memset(body->X, 0, sizeof body->X);
	for (int i = 0; i < motion->nodes; i++)
		if (motion->mesh->rigid[i] == b + 1) {
			count += 1.0;
			for (int k = 0; k < 3; k++)
				body->X[k] += motion->x[i][k];
		}
	for (int k = 0; k < 3; k++)
		body->X[k] /= body->node < 0 ? count : INFINITY;
	for (int i = 0; i < motion->nodes; i++) {
		double x[3], turn[3];
		const double *r = all->r0[i];

		if (motion->mesh->rigid[i] != b + 1)
			continue;
		for (int k = 0; k < 3; k++)
			x[k] = motion->x[i][k] - body->X[k];
		hawser__cross(turn, r, x);
		for (int k = 0; k < 9; k++)
			A[k/3][k % 3] += (k % 4 ? 0.0 : hawser__dot(r, r)) - r[k/3]*r[k % 3];
		for (int k = 0; k < 3; k++)
			right[k] += turn[k];
		least += hawser__dot(r, r);
		body->reach = fmax(body->reach, hawser__norm(r));
	}
	memset(body->w, 0, sizeof body->w);
	if (least > 0.0)
		hawser__solve3(body->w, A, right, 1e-6*least);
	allow(body);
}

/* The node that is farthest, if all are on the line to it; else -1. */
static void body_line(struct hawser__motion *motion, int b)
{
	const struct hawser__motion_bodies *all = motion->bodies;
	struct hawser__motion_body *body = &all->body[b];
	double off = 0.0;

	body->along = -1;
	for (int i = 0; i < motion->nodes; i++)
		if (motion->mesh->rigid[i] == b + 1 && hawser__norm(all->r0[i]) >= body->reach)
			body->along = i;
	for (int i = 0; i < motion->nodes && body->along >= 0; i++) {
		double across[3];

		hawser__cross(across, all->r0[body->along], all->r0[i]);
		if (motion->mesh->rigid[i] == b + 1)
			off = fmax(off, hawser__norm(across));
	}
	if (!(body->reach > 0.0) || off > STRAIGHT*body->reach*body->reach)
		body->along = -1;
}

void hawser__bodies_predict(struct hawser__motion *motion, double h)
{
	struct hawser__motion_bodies *all = motion->bodies;

	all->h = h;
	for (int b = 0; b < all->bodies; b++) {
		double c[3];

		all->body[b].reach = 0.0;
		if (!all->body[b].motions)
			continue;
		centre_of(c, motion, b);
		for (int i = 0; i < motion->nodes; i++)
			for (int k = 0; k < 3 && motion->mesh->rigid[i] == b + 1; k++)
				all->r0[i][k] = motion->reference[i][k] + motion->u0[i][k] - c[k];
		fit(motion, b);
		body_line(motion, b);
	}
	place_nodes(motion);
}

/* Sums over the nodes of the bodies of forces F [nodes] and of their moments about the mean arms, along
 * each of the motions. */
static void sums(double *sum, const struct hawser__motion *motion, const double (*F)[3])
{
	const struct hawser__motion_bodies *all = motion->bodies;
	int first = 0;

	memset(sum, 0, (size_t)all->motions*sizeof *sum);
	for (int b = 0; b < all->bodies; first += all->body[b++].motions)
		for (int i = 0; i < motion->nodes; i++) {
			double arm[3], moment[3];

			if (motion->mesh->rigid[i] != b + 1)
				continue;
			for (int k = 0; k < 3; k++)
				arm[k] = 0.5*(all->r0[i][k] + all->r1[i][k]);
			hawser__cross(moment, arm, F[i]);
			for (int j = 0; j < all->body[b].motions; j++)
				for (int k = 0; k < 3; k++)
					sum[first + j] += all->body[b].motion[k][j]*F[i][k] +
					                  all->body[b].motion[3 + k][j]*moment[k];
		}
}

double hawser__bodies_rest(struct hawser__motion *motion, double most)
{
	struct hawser__motion_bodies *all = motion->bodies;
	int i = 0;

	sums(all->sum, motion, (const double (*)[3])motion->r);
	for (int b = 0; b < all->bodies; b++)
		for (int j = 0; j < all->body[b].motions; j++, i++) {
			const double (*of)[M] = (const double (*)[M])all->body[b].motion;
			int turns = of[3][j] != 0.0 || of[4][j] != 0.0 || of[5][j] != 0.0;
			double size = fabs(all->sum[i])/(turns ? fmax(all->body[b].reach, 1e-9) : 1.0);

			most = size <= most ? most : size;
		}
	return most;
}

/* y = A x at the nodes of bodies and of elements that end there. */
static void apply(double (*y)[3], const struct hawser__motion *motion, const double (*x)[3])
{
	const int *rigid = motion->mesh->rigid;

	memset(y, 0, (size_t)motion->nodes*sizeof *y);
	for (int i = 0; i < motion->nodes; i++)
		for (int k = 0; k < 3 && rigid[i]; k++)
			y[i][k] += motion->point[i]*x[i][k] +
			           (motion->block ? hawser__dot(&motion->block[i][3*k], x[i]) : 0.0);
	for (int e = 0; e < motion->elements; e++) {
		int a = motion->element[e].a, b = motion->element[e].b;
		const double *B = motion->B[e], *O = motion->other ? motion->other[e] : B, *m = motion->mass[e];

		if (!rigid[a] && !rigid[b])
			continue;
		for (int k = 0; k < 3; k++) {
			y[a][k] += hawser__dot(&B[3*k], x[a]) - hawser__dot(&B[3*k], x[b]) + m[0]*x[a][k] +
			           m[1]*x[b][k];
			y[b][k] += hawser__dot(&O[3*k], x[b]) - hawser__dot(&O[3*k], x[a]) + m[1]*x[a][k] +
			           m[0]*x[b][k];
		}
	}
}

/* What motion j of a body changes at its node, and in the arm there. */
static void moved_by(double x[3], double arm[3], const struct hawser__motion_bodies *all, int b, int j,
                     int node)
{
	const struct hawser__motion_body *body = &all->body[b];
	const double turn[3] = {body->motion[3][j], body->motion[4][j], body->motion[5][j]};

	hawser__cross(arm, turn, all->r1[node]);
	for (int k = 0; k < 3; k++)
		x[k] = body->motion[k][j] + arm[k];
}

/* Column number c of all, of motion j of body b: the answer of all nodes, and what it changes in the
 * sums. motion->r is used. */
static enum hawser_status column(struct hawser__motion *motion, int *good, int c, int b, int j,
                                 hawser__motion_solver *solve, struct hawser_report *report)
{
	struct hawser__motion_bodies *all = motion->bodies;
	double (*z)[3] = all->column + (size_t)c*(size_t)motion->nodes, *S = all->S + c*all->motions;
	double x[3], arm[3];
	enum hawser_status status;

	memset(z, 0, (size_t)motion->nodes*sizeof *z);
	for (int i = 0; i < motion->nodes; i++)
		if (motion->mesh->rigid[i] == b + 1)
			moved_by(z[i], arm, all, b, j, i);
	apply(motion->r, motion, (const double (*)[3])z);
	status = solve(motion, good, report);
	for (int i = 0; i < motion->nodes && !status && *good; i++)
		for (int k = 0; k < 3 && !motion->mesh->rigid[i]; k++)
			z[i][k] = motion->r[i][k];
	if (status || !*good)
		return status;
	apply(all->answer, motion, (const double (*)[3])z);
	sums(S, motion, (const double (*)[3])all->answer);
	for (int i = 0, first = 0; i < all->bodies; first += all->body[i++].motions)
		for (int n = 0; n < motion->nodes && i == b; n++) {
			double moment[3];

			if (motion->mesh->rigid[n] != b + 1)
				continue;
			moved_by(x, arm, all, b, j, n);
			hawser__cross(moment, arm, all->F[n]);
			for (int row = 0; row < all->body[b].motions; row++)
				for (int k = 0; k < 3; k++)
					S[first + row] += 0.5*all->body[b].motion[3 + k][row]*moment[k];
		}
	return HAWSER_OK;
}

/* The factors of S. A turn of a straight body about itself moves no node: something holds it. */
static int factor(struct hawser__motion_bodies *all)
{
	int n = all->motions, first = 0;

	for (int b = 0; b < all->bodies; first += all->body[b++].motions) {
		const struct hawser__motion_body *body = &all->body[b];
		const double *r = body->along < 0 ? NULL : all->r1[body->along];
		double along[M] = {0.0}, most = 0.0;

		for (int j = 0; j < body->motions && r; j++) {
			for (int k = 0; k < 3; k++)
				along[j] += body->motion[3 + k][j]*r[k]/body->reach;
			most = along[j] == 0.0 ? most : fmax(most, fabs(all->S[(first + j)*(n + 1)]));
		}
		for (int j = 0; j < M*M && r; j++)
			if (j % M < body->motions && j/M < body->motions)
				all->S[(first + j/M)*n + first + j % M] += most*along[j/M]*along[j % M];
	}
	return LAPACKE_dgetrf_work(LAPACK_COL_MAJOR, n, n, all->S, n, all->pivot) == 0;
}

enum hawser_status hawser__bodies_correct(struct hawser__motion *motion, int *good, int fresh,
                                          hawser__motion_solver *solve, struct hawser_report *report)
{
	struct hawser__motion_bodies *all = motion->bodies;
	size_t size = (size_t)motion->nodes*sizeof *motion->r;
	int n = all->motions;
	enum hawser_status status = HAWSER_OK;

	*good = 1;
	memcpy(all->F, motion->r, size);
	for (int b = 0, c = 0; b < all->bodies && fresh; b++)
		for (int j = 0; j < all->body[b].motions && !status && *good; j++)
			status = column(motion, good, c++, b, j, solve, report);
	if (!status && *good && fresh)
		*good = factor(all);
	memcpy(motion->r, all->F, size);
	if (!status && *good)
		status = solve(motion, good, report);
	if (status || !*good || !n)
		return status;
	apply(all->answer, motion, (const double (*)[3])motion->r);
	for (int i = 0; i < motion->nodes; i++)
		for (int k = 0; k < 3; k++)
			all->answer[i][k] = -all->answer[i][k] - all->F[i][k];
	sums(all->sum, motion, (const double (*)[3])all->answer);
	LAPACKE_dgetrs_work(LAPACK_COL_MAJOR, 'N', n, 1, all->S, n, all->pivot, all->sum, n);
	for (int c = 0; c < n; c++)
		for (int i = 0; i < motion->nodes; i++)
			for (int k = 0; k < 3 && !motion->mesh->rigid[i]; k++)
				motion->r[i][k] += all->sum[c]*all->column[(size_t)c*(size_t)motion->nodes +
				                                           (size_t)i][k];
	for (int b = 0, c = 0; b < all->bodies; b++) {
		struct hawser__motion_body *body = &all->body[b];

		memset(body->by, 0, sizeof body->by);
		for (int j = 0; j < body->motions; j++, c++)
			for (int k = 0; k < M; k++)
				body->by[k] += all->sum[c]*body->motion[k][j];
	}
	return HAWSER_OK;
}

/* Two turns after each other, by their Cayley vectors: first w, then d. */
static void compose(double w[3], const double d[3])
{
	double cross[3], under = 1.0 - 0.25*hawser__dot(w, d);

	hawser__cross(cross, d, w);
	for (int k = 0; k < 3; k++)
		w[k] = (w[k] + d[k] + 0.5*cross[k])/under;
}

void hawser__bodies_move(struct hawser__motion *motion, double part)
{
	struct hawser__motion_bodies *all = motion->bodies;

	for (int b = 0; b < all->bodies; b++) {
		struct hawser__motion_body *body = &all->body[b];
		double turn[3];

		for (int k = 0; k < 3; k++) {
			body->X[k] += part*body->by[k];
			turn[k] = part*body->by[3 + k];
		}
		compose(body->w, turn);
	}
	place_nodes(motion);
}

void hawser__bodies_finish(struct hawser__motion *motion)
{
	for (int i = 0; i < motion->nodes; i++)
		for (int k = 0; k < 3; k++)
			if (motion->mesh->rigid[i] && motion->bodies->body[motion->mesh->rigid[i] - 1].motions)
				motion->u[i][k] = motion->u0[i][k] + motion->x[i][k];
}
