/* net/statics/seat.c - the equilibrium of rigid bodies on the lines of a net.
 *
 * z      motions of all bodies, as their supports leave them
 * F, K   force of the outside that holds them, the gradient of the energy, and its derivative: those
 *        of the exact equilibrium of all lines, which follow (net/statics/stiffness.c)
 *
 * Newton's method, with lambda D added to K where it does not lead down, or is longer than it holds:
 * D has the stiffness of the displacements, and of the turns. The energy need not be known, nor be
 * there: down is where (F(z) + F(z + dz)).dz < 0.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <lapacke.h>

#include "core/report.h"
#include "core/vec3.h"
#include "net/body.h"
#include "net/motion/motion.h"
#include "net/statics/solve.h"
#include "net/touch/touch.h"

enum { M = HAWSER__BODY_MOTIONS, ITERATIONS = 200, TRIES = 40, KICKS = 3 };
/* Of the sum of the forces on a body: balanced, and by round-off alone. */
static const double BALANCED = 1e-10, ROUND = 1e-7;
/* Largest turn of an iteration, rad, and displacement, over the size of the net. */
static const double TURN = 0.3, MOVE = 0.1;
/* Least lambda, for turns that nothing resists; the first one that is tried after 0. */
static const double LEAST = 1e-10, FIRST = 1e-3;
/* rad: off a place from which it would fall. */
static const double KICK = 0.02;

struct seat {
	struct hawser_net net, trial; /* with the bodies where they are, and where they may be */
	int bodies, n;            /* n: motions of all */
	double (*basis)[M][M];    /* [bodies] columns: motions of a body */
	double (*about)[3];       /* [bodies] m */
	int *count;               /* [bodies] motions */
	double *scale, *arm;      /* [bodies] N; m, the farthest node */
	double *K, *F, *D;        /* [n][n] column by column, [n], [n] */
	double *all, *forces;     /* [6 bodies][6 bodies], [6 bodies] of all motions */
	double *A, *dz, *F1;      /* [n][n], [n], [n] */
	lapack_int *pivot;        /* [n] */
	double size;              /* m, of the net */
	int moves;                /* 1: of lines on planes that give way as motions have them */
	double rest;              /* of F over the forces on the bodies */
	struct hawser__hold hold;
};

void hawser__bodies_unseat(struct hawser_net *seated, const struct hawser_net *net)
{
	if (!net->bodies)
		return;
	free(seated->node);
	free(seated->body);
	memset(seated, 0, sizeof *seated);
}

/* A net of its own places; the lists of nodes of the bodies are those of `net`. */
static enum hawser_status copy(struct hawser_net *to, const struct hawser_net *net,
                               struct hawser_report *report)
{
	*to = *net;
	to->node = malloc(((size_t)net->nodes + 1)*sizeof *to->node);
	to->body = malloc(((size_t)net->bodies + 1)*sizeof *to->body);
	if (!to->node || !to->body)
		return hawser__no_memory(report, "net");
	memcpy(to->node, net->node, (size_t)net->nodes*sizeof *to->node);
	memcpy(to->body, net->body, (size_t)net->bodies*sizeof *to->body);
	return HAWSER_OK;
}

/* v turned by the vector w. */
static void turned(double v[3], const double w[3])
{
	double angle = hawser__norm(w), a = angle > 0.0 ? sin(angle)/angle : 1.0;
	double b = angle > 0.0 ? 2.0*pow(sin(0.5*angle)/angle, 2.0) : 0.5, first[3], second[3];

	hawser__cross(first, w, v);
	hawser__cross(second, w, first);
	for (int k = 0; k < 3; k++)
		v[k] += a*first[k] + b*second[k];
}

static void carry(double x[3], const double about[3], const double motion[M])
{
	for (int k = 0; k < 3; k++)
		x[k] -= about[k];
	turned(x, motion + 3);
	for (int k = 0; k < 3; k++)
		x[k] += about[k] + motion[k];
}

/* Motions, places and sizes of the bodies of a net. */
static void survey(struct seat *seat, const struct hawser_net *net)
{
	seat->n = 0;
	for (int b = 0; b < seat->bodies; b++) {
		const struct hawser_net_body *body = &net->body[b];

		seat->count[b] = hawser__body_motions(seat->basis[b], seat->about[b], net, body, NULL);
		seat->n += seat->count[b];
		seat->arm[b] = 0.0;
		for (int i = 0; i <= body->nodes; i++) {
			const double *x = i < body->nodes ? net->node[body->node[i]].x : body->centre;
			double d[3];

			for (int k = 0; k < 3; k++)
				d[k] = x[k] - seat->about[b][k];
			if (i < body->nodes || body->mass > 0.0)
				seat->arm[b] = fmax(seat->arm[b], hawser__norm(d));
		}
		seat->arm[b] = seat->arm[b] > 0.0 ? seat->arm[b] : 1.0;
	}
}

/* The trial: the bodies moved by dz. */
static void move_bodies(struct seat *seat)
{
	int first = 0;

	survey(seat, &seat->net); /* those of a trial before it */
	for (int b = 0; b < seat->bodies; first += seat->count[b++]) {
		const struct hawser_net_body *from = &seat->net.body[b];
		struct hawser_net_body *to = &seat->trial.body[b];
		double motion[M] = {0.0};

		for (int i = 0; i < M*seat->count[b]; i++)
			motion[i % M] += seat->basis[b][i % M][i/M]*seat->dz[first + i/M];
		*to = *from;
		carry(to->centre, seat->about[b], motion);
		for (int k = 0; k < 3; k++)
			turned(to->axes[k], motion + 3);
		for (int i = 0; i < from->nodes; i++) {
			struct hawser_net_node *node = &seat->trial.node[from->node[i]];

			memcpy(node->x, seat->net.node[from->node[i]].x, sizeof node->x);
			carry(node->x, seat->about[b], motion);
		}
	}
}

/* F of a net [n] and, unless NULL, K; returns what is not balanced, over the forces on the bodies, in
 * *rest. */
static enum hawser_status forces_of(double *F, double *K, double *rest, struct seat *seat,
                                    const struct hawser_net *net, struct hawser_report *report)
{
	struct hawser__mesh mesh;
	enum hawser_status status = hawser__mesh_build(&mesh, net, report);
	double *T = status ? NULL : calloc((size_t)mesh.elements + 1, sizeof *T);
	int all = M*seat->bodies, row = 0, found;

	if (status)
		return status;
	if (!T)
		status = hawser__no_memory(report, "net");
	if (!status)
		status = hawser__net_supported(&mesh, net, report);
	mesh.surfaces_rest = seat->moves && net->dynamics.surfaces_start;
	if (!status)
		status = hawser__net_equilibrium(&mesh, T, net, report);
	if (!status)
		status = hawser__bodies_land(&mesh, net, report);
	if (!status && seat->moves)
		status = hawser__motion_settle(&mesh, &found, report);
	survey(seat, net);
	if (!status)
		status = hawser__bodies_tangent(seat->all, seat->forces, seat->scale, &mesh, T, net,
		                                (const double (*)[3])seat->about, report);
	free(T);
	hawser__mesh_clear(&mesh);
	*rest = 0.0;
	for (int b = 0; b < seat->bodies && !status; b++)
		for (int i = 0; i < seat->count[b]; i++, row++) {
			int column = 0;
			double unit = hawser__larger(fabs(seat->basis[b][0][i]), hawser__larger(
				fabs(seat->basis[b][1][i]), fabs(seat->basis[b][2][i]))) > 0.0 ? 1.0 : seat->arm[b];

			F[row] = 0.0;
			for (int k = 0; k < M; k++)
				F[row] += seat->basis[b][k][i]*seat->forces[M*b + k];
			*rest = fmax(*rest, fabs(F[row])/unit/fmax(seat->scale[b], DBL_MIN));
			for (int c = 0; c < seat->bodies && K; c++)
				for (int j = 0; j < seat->count[c]; j++, column++) {
					double sum = 0.0;

					for (int k = 0; k < M*M; k++)
						sum += seat->basis[b][k/M][i]*seat->basis[c][k % M][j]*
						       seat->all[(M*c + k % M)*all + M*b + k/M];
					K[(size_t)column*(size_t)seat->n + (size_t)row] = sum;
				}
		}
	return status;
}

/* D: the largest stiffness of displacements, and of turns, of a body; at least its forces over its
 * size. */
static void measures(struct seat *seat)
{
	int first = 0;

	for (int b = 0; b < seat->bodies; first += seat->count[b++]) {
		double stiff = seat->scale[b]/seat->size;
		int places = seat->count[b] == M ? 3 : 0;

		for (int i = 0; i < seat->count[b]; i++) {
			double k = fabs(seat->K[(size_t)(first + i)*(size_t)(seat->n + 1)]);

			stiff = fmax(stiff, i < places ? k : k/(seat->arm[b]*seat->arm[b]));
		}
		for (int i = 0; i < seat->count[b]; i++)
			seat->D[first + i] = i < places ? stiff : stiff*seat->arm[b]*seat->arm[b];
	}
}

static double product(const double *a, const double *b, int n)
{
	double sum = 0.0;

	for (int i = 0; i < n; i++)
		sum += a[i]*b[i];
	return sum;
}

/* Within what a correction may be. */
static int modest(const struct seat *seat)
{
	int first = 0, good = 1;

	for (int b = 0; b < seat->bodies; first += seat->count[b++])
		for (int i = 0; i < seat->count[b]; i++)
			good = good && fabs(seat->dz[first + i]) <=
			               (seat->count[b] == M && i < 3 ? MOVE*seat->size : TURN);
	return good;
}

/* dz = - (K + lambda D)^-1 F; 0 if it does not lead down. */
static int direction_of(struct seat *seat, double lambda)
{
	int n = seat->n;

	memcpy(seat->A, seat->K, (size_t)n*(size_t)n*sizeof *seat->A);
	for (int i = 0; i < n; i++) {
		seat->A[(size_t)i*(size_t)(n + 1)] += lambda*seat->D[i];
		seat->dz[i] = -seat->F[i];
	}
	return LAPACKE_dgesv_work(LAPACK_COL_MAJOR, n, 1, seat->A, n, seat->pivot, seat->dz, n) == 0 &&
	       product(seat->dz, seat->F, n) < 0.0 && modest(seat);
}

/* 1 if a small motion would go on by itself. */
static int unstable(struct seat *seat)
{
	int n = seat->n;

	for (int i = 0; i < n*n; i++)
		seat->A[i] = 0.5*(seat->K[i] + seat->K[(i % n)*n + i/n]) +
		             (i % n == i/n ? ROUND*seat->D[i/n] : 0.0);
	return LAPACKE_dpotrf_work(LAPACK_COL_MAJOR, 'L', n, seat->A, n) > 0;
}

static void accept(struct seat *seat)
{
	struct hawser_net other = seat->net;

	seat->net = seat->trial;
	seat->trial = other;
}

/* One iteration; *done: 1 where no correction helps. */
static enum hawser_status improve(struct seat *seat, int *done, double *lambda,
                                  struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	*done = 0;
	for (int i = 0; i < TRIES && !status; i++) {
		double rest, down;

		if (!direction_of(seat, *lambda)) {
			*lambda = fmax(4.0*(*lambda), FIRST);
			continue;
		}
		move_bodies(seat);
		status = forces_of(seat->F1, NULL, &rest, seat, &seat->trial, report);
		down = product(seat->F, seat->dz, seat->n) + product(seat->F1, seat->dz, seat->n);
		if (status || down < 0.0 || rest < 0.5*seat->rest) {
			accept(seat);
			*lambda = *lambda > FIRST ? 0.1*(*lambda) : LEAST;
			return status;
		}
		*lambda = fmax(4.0*(*lambda), FIRST);
	}
	*done = 1;
	return status;
}

static enum hawser_status settle(struct seat *seat, struct hawser_report *report)
{
	double lambda = LEAST, last = INFINITY;
	int done = 0, kicks = 0;
	enum hawser_status status = forces_of(seat->F, seat->K, &seat->rest, seat, &seat->net, report);

	for (int i = 0; i < ITERATIONS && !status && seat->n > 0; i++) {
		measures(seat);
		if (seat->rest <= BALANCED || done || (seat->rest <= ROUND && seat->rest > 0.25*last)) {
			if (seat->rest <= ROUND && kicks < KICKS && unstable(seat)) {
				for (int j = 0; j < seat->n; j++)
					seat->dz[j] = KICK/(kicks + 1.0 + j);
				move_bodies(seat);
				accept(seat);
				kicks++;
			} else {
				break;
			}
		} else {
			status = improve(seat, &done, &lambda, report);
		}
		last = seat->rest;
		if (!status)
			status = forces_of(seat->F, seat->K, &seat->rest, seat, &seat->net, report);
	}
	if (!status && seat->n > 0 && !(seat->rest <= ROUND))
		return hawser__fail(report, HAWSER_ERR_CONVERGENCE, "net", "%s: no equilibrium of the rigid "
		                    "bodies was found: %.3g of the forces on them is not balanced; give them "
		                    "places nearer to it, or buoyancy and lines that hold them%s",
		                    seat->net.name ? seat->net.name : "the net", seat->rest,
		                    seat->net.surfaces ? ": at rest a bed holds them by no friction" : "");
	return status;
}

static enum hawser_status open_seat(struct seat *seat, struct hawser_report *report)
{
	size_t bodies = (size_t)seat->bodies, n = M*bodies;

	seat->basis = hawser__hold(&seat->hold, bodies, sizeof *seat->basis);
	seat->about = hawser__hold(&seat->hold, bodies, sizeof *seat->about);
	seat->count = hawser__hold(&seat->hold, bodies, sizeof *seat->count);
	seat->scale = hawser__hold(&seat->hold, bodies, sizeof *seat->scale);
	seat->arm = hawser__hold(&seat->hold, bodies, sizeof *seat->arm);
	seat->K = hawser__hold(&seat->hold, n*n, sizeof *seat->K);
	seat->A = hawser__hold(&seat->hold, n*n, sizeof *seat->A);
	seat->all = hawser__hold(&seat->hold, n*n, sizeof *seat->all);
	seat->F = hawser__hold(&seat->hold, n, sizeof *seat->F);
	seat->F1 = hawser__hold(&seat->hold, n, sizeof *seat->F1);
	seat->D = hawser__hold(&seat->hold, n, sizeof *seat->D);
	seat->dz = hawser__hold(&seat->hold, n, sizeof *seat->dz);
	seat->forces = hawser__hold(&seat->hold, n, sizeof *seat->forces);
	seat->pivot = hawser__hold(&seat->hold, n, sizeof *seat->pivot);
	return seat->hold.short_of_memory ? hawser__no_memory(report, "net") : HAWSER_OK;
}

double hawser__net_extent(const struct hawser_net *net)
{
	double most = 0.0;

	for (int i = 0; i < net->nodes; i++)
		for (int k = 0; k < 3; k++)
			most = fmax(most, fabs(net->node[i].x[k] - net->node[0].x[k]));
	return most > 0.0 ? most : 1.0;
}

enum hawser_status hawser__bodies_seat(struct hawser_net *seated, double *rest,
                                       const struct hawser_net *net, int moves,
                                       struct hawser_report *report)
{
	struct seat seat = {.bodies = net->bodies, .size = hawser__net_extent(net), .moves = moves};
	enum hawser_status status;

	*seated = *net;
	*rest = 0.0;
	if (!net->bodies)
		return HAWSER_OK;
	status = copy(&seat.net, net, report);
	if (!status)
		status = copy(&seat.trial, net, report);
	if (!status)
		status = open_seat(&seat, report);
	if (!status)
		status = settle(&seat, report);
	for (int b = 0; b < net->bodies && !status; b++)
		*rest = fmax(*rest, seat.n > 0 ? seat.rest*seat.scale[b] : 0.0);
	*seated = seat.net;
	if (!status)
		status = hawser__bodies_outside(seated, NULL, NAN, report);
	hawser__bodies_unseat(&seat.trial, net);
	hawser__hold_clear(&seat.hold);
	return status;
}
