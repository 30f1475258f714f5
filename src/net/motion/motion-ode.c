/* net/motion/motion-ode.c - see net/motion/motion-ode.h.
 *
 * d, l, e  vector along an element, its length, d/l
 * w        difference of the velocities of its ends
 * T        max(k*p + c*p', 0) where p > 0, else 0; p' = e.w
 * D, K     minus the derivatives of f by v and u: with damping K is unsymmetric
 *
 * Newton's matrix: (I - gamma*J)*(x, y) = (bx, by), with J = [0, I; -M^-1*K, -M^-1*D], is
 * (M + gamma*D + gamma^2*K)*y = M*by - gamma*K*bx and x = bx + gamma*y.
 *
 * The forces are written here once more, and M is solved by CHOLMOD: this shares with the schemes
 * of net/motion/motion.c only the vectors of the elements, so that one checks the other.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "core/vec3.h"
#include "net/motion/motion-ode.h"

void hawser__ode_clear(struct hawser__ode *ode)
{
	hawser__sparse_clear(ode->mass);
	free(ode->u); /* with v, a, f */
	free(ode->right);
	memset(ode, 0, sizeof *ode);
}

/* M has no inverse where a node that moves has no mass. Its place would be one of balance, about which
 * the schemes that keep energy would vibrate from step to step for ever. */
enum hawser_status hawser__ode_massive(const struct hawser__mesh *mesh, const struct hawser_net *net,
                                       struct hawser_report *report)
{
	unsigned char *heavy = calloc((size_t)mesh->nodes, 1);
	enum hawser_status status = heavy ? HAWSER_OK : hawser__no_memory(report, "net");

	for (int e = 0; e < mesh->elements && !status; e++)
		for (int end = 0; end < 2; end++)
			heavy[mesh->end[e][end]] |= mesh->rho[e] > 0.0;
	for (int c = 0; c < mesh->cables && !status; c++)
		if (net->cable[c].elements > 1 && net->cable[c].rho == 0.0 && !net->cable[c].rod)
			status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "net", "a motion needs mass at each "
			                      "node, and cable %s has inner nodes without: give it rho, or 1 "
			                      "element",
			                      net->cable[c].name);
	for (int i = 0; i < net->nodes && !status; i++)
		for (int k = 0; k < 3 && !status; k++)
			if (mesh->unknown[i][k] >= 0 && !heavy[i] && mesh->mass[i] == 0.0)
				status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "net", "a motion needs mass at each "
				                      "node that moves, and node %s has none: give it one in `masses`, "
				                      "or rho to a cable there", net->node[i].name);
	free(heavy);
	return status;
}

static enum hawser_status factor(struct hawser__ode *ode, struct hawser_report *report)
{
	const struct hawser__motion *motion = ode->motion;
	const struct hawser__mesh *mesh = motion->mesh;
	static const double none[3];
	int definite = 0;
	enum hawser_status status = hawser__sparse_open(&ode->mass, mesh, report);

	memset(ode->f, 0, (size_t)mesh->nodes*sizeof *ode->f);
	for (int e = 0; e < mesh->elements; e++)
		for (int end = 0; end < 2; end++)
			ode->f[mesh->end[e][end]][0] += motion->element[e].m;
	for (int e = 0; e < motion->elements && !status; e++)
		hawser__sparse_add(ode->mass, e, -motion->far*motion->element[e].m, 0.0, none);
	for (int i = 0; i < motion->nodes && !status; i++)
		for (int k = 0; k < 3; k++)
			if (mesh->unknown[i][k] >= 0)
				hawser__sparse_diagonal(ode->mass, mesh->unknown[i][k],
				                        mesh->mass[i] + 0.5*ode->f[i][0]);
	if (!status)
		status = hawser__sparse_factor(ode->mass, &definite, report);
	return status || definite ? status
		: hawser__fail(report, HAWSER_ERR_ARGUMENT, "net", "the mass matrix is not positive definite "
		               "to double precision: some nodes have next to no mass; take the scheme energy");
}

enum hawser_status hawser__ode_open(struct hawser__ode *ode, struct hawser__motion *motion,
                                    struct hawser_report *report)
{
	size_t nodes = (size_t)motion->nodes;

	*ode = (struct hawser__ode){.motion = motion};
	ode->u = calloc(4*nodes, sizeof *ode->u);
	ode->right = calloc((size_t)motion->mesh->unknowns + 1, sizeof *ode->right);
	if (!ode->u || !ode->right)
		return hawser__no_memory(report, "net");
	ode->v = ode->u + nodes;
	ode->a = ode->v + nodes;
	ode->f = ode->a + nodes;
	memcpy(ode->u, motion->u, nodes*sizeof *ode->u);
	memcpy(ode->v, motion->v, nodes*sizeof *ode->v);
	return factor(ode, report);
}

void hawser__ode_spread(double (*to_u)[3], double (*to_v)[3], const struct hawser__ode *ode, double t,
                        const double *u, const double *v)
{
	const struct hawser__mesh *mesh = ode->motion->mesh;

	for (int i = 0; i < mesh->nodes; i++)
		for (int k = 0; k < 3; k++) {
			int j = mesh->unknown[i][k];

			if (j >= 0) {
				to_u[i][k] = u[j];
				to_v[i][k] = v[j];
			}
		}
	hawser__motion_supports(to_u, to_v, ode->motion, t);
}

/* An element now. */
struct state {
	double d[3], e[3], w[3], l, p, rate, T;
	int pulls; /* 1 if T follows the stretch: neither slack nor cut off */
};

static void look(struct state *s, const struct hawser__ode *ode, int number)
{
	const struct hawser__motion_element *el = &ode->motion->element[number];
	const double *ua = ode->u[el->a], *ub = ode->u[el->b];
	double more = 0.0;

	for (int k = 0; k < 3; k++) {
		double delta = ub[k] - ua[k];

		s->d[k] = el->D[k] + delta;
		s->w[k] = ode->v[el->b][k] - ode->v[el->a][k];
		more += (el->D[k] + s->d[k])*delta;
	}
	s->l = sqrt(hawser__dot(s->d, s->d));
	s->p = el->p_ref + (s->l + el->l_ref > 0.0 ? more/(s->l + el->l_ref) : 0.0);
	for (int k = 0; k < 3; k++)
		s->e[k] = s->l > 0.0 ? s->d[k]/s->l : 0.0;
	s->rate = hawser__dot(s->e, s->w);
	s->T = s->p > 0.0 ? el->k*s->p + el->c*s->rate : 0.0;
	s->pulls = s->T > 0.0;
	s->T = s->pulls ? s->T : 0.0;
}

/* f of all nodes, without inertia: constant and harmonic loads, damping and internal forces. */
static void forces(struct hawser__ode *ode, double t)
{
	const struct hawser__motion *motion = ode->motion;
	const double far = motion->far, near = 0.5 - far;

	memcpy(ode->f, motion->base, (size_t)motion->nodes*sizeof *ode->f);
	hawser__motion_waves(ode->f, motion->mesh, t, 1.0);
	for (int e = 0; e < motion->elements; e++) {
		const struct hawser__motion_element *el = &motion->element[e];
		const double *va = ode->v[el->a], *vb = ode->v[el->b];
		struct state s;

		look(&s, ode, e);
		for (int k = 0; k < 3; k++) {
			double F = s.T*s.e[k] - el->F_ref[k];

			ode->f[el->a][k] += F - el->drag*(near*va[k] + far*vb[k]);
			ode->f[el->b][k] -= F + el->drag*(near*vb[k] + far*va[k]);
		}
	}
}

enum hawser_status hawser__ode_accelerate(double *a, struct hawser__ode *ode, double t, const double *u,
                                          const double *v, struct hawser_report *report)
{
	const struct hawser__motion *motion = ode->motion;
	const struct hawser__mesh *mesh = motion->mesh;

	hawser__ode_spread(ode->u, ode->v, ode, t, u, v);
	forces(ode, t);
	hawser__motion_support_accelerations(ode->a, motion, t);
	for (int i = 0; i < mesh->nodes; i++)
		for (int k = 0; k < 3; k++)
			if (mesh->unknown[i][k] >= 0)
				a[mesh->unknown[i][k]] = ode->f[i][k];
	for (int e = 0; e < motion->elements; e++) { /* the inertia of supports that move */
		const struct hawser__motion_element *el = &motion->element[e];
		const int *ua = mesh->unknown[el->a], *ub = mesh->unknown[el->b];

		for (int k = 0; k < 3; k++) {
			if (ua[k] >= 0 && ub[k] < 0)
				a[ua[k]] -= el->m*motion->far*ode->a[el->b][k];
			if (ub[k] >= 0 && ua[k] < 0)
				a[ub[k]] -= el->m*motion->far*ode->a[el->a][k];
		}
	}
	return hawser__sparse_solve(a, ode->mass, report);
}

/* Block of Newton's matrix and right side of an element: r = M*by - gamma*K*bx. */
static void block(struct hawser__ode *ode, int number, double gamma, const double (*bx)[3],
                  const double (*by)[3])
{
	struct hawser__motion *motion = ode->motion;
	const struct hawser__motion_element *el = &motion->element[number];
	const double far = motion->far, near = 0.5 - far;
	double *B = motion->B[number], K[9], kx[3];
	struct state s;

	look(&s, ode, number);
	memset(B, 0, 9*sizeof *B);
	memset(K, 0, sizeof K);
	for (int i = 0; i < 3 && s.pulls; i++)
		for (int j = 0; j < 3; j++) {
			double ee = s.e[i]*s.e[j], round = s.T/s.l*((i == j) - ee);
			double turn = el->c*s.e[i]*(s.w[j] - s.rate*s.e[j])/s.l;

			K[3*i + j] = round + el->k*ee + turn;
			B[3*i + j] = gamma*(el->c*ee + gamma*K[3*i + j]);
		}
	motion->mass[number][0] = (el->m + gamma*el->drag)*near;
	motion->mass[number][1] = (el->m + gamma*el->drag)*far;
	for (int i = 0; i < 3; i++) {
		kx[i] = 0.0;
		for (int j = 0; j < 3; j++)
			kx[i] += gamma*K[3*i + j]*(bx[el->b][j] - bx[el->a][j]);
	}
	for (int i = 0; i < 3; i++) {
		motion->r[el->a][i] += el->m*(near*by[el->a][i] + far*by[el->b][i]) + kx[i];
		motion->r[el->b][i] += el->m*(near*by[el->b][i] + far*by[el->a][i]) - kx[i];
	}
}

enum hawser_status hawser__ode_newton(double *x, double *y, int *good, struct hawser__ode *ode,
                                      double gamma, double t, const double *u, const double *v,
                                      struct hawser_report *report)
{
	struct hawser__motion *motion = ode->motion;
	const struct hawser__mesh *mesh = motion->mesh;
	const struct hawser__blocks_matrix matrix = {(const double (*)[9])motion->B, NULL,
	                                             (const double (*)[2])motion->mass, motion->point,
	                                             NULL};
	double (*bx)[3] = ode->a, (*by)[3] = ode->f;
	enum hawser_status status;

	hawser__ode_spread(ode->u, ode->v, ode, t, u, v);
	for (int i = 0; i < mesh->nodes; i++)
		for (int k = 0; k < 3; k++) {
			int j = mesh->unknown[i][k];

			bx[i][k] = j >= 0 ? x[j] : 0.0;
			by[i][k] = j >= 0 ? y[j] : 0.0;
			motion->r[i][k] = mesh->mass[i]*by[i][k];
			motion->point[i] = mesh->mass[i];
		}
	for (int e = 0; e < mesh->elements; e++)
		block(ode, e, gamma, (const double (*)[3])bx, (const double (*)[3])by);
	for (int i = 0; i < mesh->nodes; i++)
		for (int k = 0; k < 3; k++)
			if (mesh->unknown[i][k] < 0)
				motion->r[i][k] = 0.0;
	status = hawser__blocks_solve(motion->r, good, motion->blocks, &matrix, report);
	for (int i = 0; i < mesh->nodes && !status && *good; i++)
		for (int k = 0; k < 3; k++) {
			int j = mesh->unknown[i][k];

			if (j >= 0) {
				y[j] = motion->r[i][k];
				x[j] += gamma*y[j];
			}
		}
	return status;
}

/* Power of the forces that move a support: (M*a - f).v. */
static double reactions(const struct hawser__ode *ode)
{
	const struct hawser__motion *motion = ode->motion;
	const struct hawser__mesh *mesh = motion->mesh;
	const double far = motion->far, near = 0.5 - far;
	double power = 0.0;

	for (int i = 0; i < mesh->nodes; i++)
		for (int k = 0; k < 3; k++)
			if (mesh->unknown[i][k] < 0)
				power += (mesh->mass[i]*ode->a[i][k] - ode->f[i][k])*ode->v[i][k];
	for (int e = 0; e < mesh->elements; e++) {
		const struct hawser__motion_element *el = &motion->element[e];
		const int *ua = mesh->unknown[el->a], *ub = mesh->unknown[el->b];
		const double *aa = ode->a[el->a], *ab = ode->a[el->b];

		for (int k = 0; k < 3; k++) {
			power += ua[k] < 0 ? el->m*(near*aa[k] + far*ab[k])*ode->v[el->a][k] : 0.0;
			power += ub[k] < 0 ? el->m*(near*ab[k] + far*aa[k])*ode->v[el->b][k] : 0.0;
		}
	}
	return power;
}

enum hawser_status hawser__ode_power(double *work, double *lost, struct hawser__ode *ode, double t,
                                     const double *u, const double *v, struct hawser_report *report)
{
	const struct hawser__motion *motion = ode->motion;
	const struct hawser__mesh *mesh = motion->mesh;
	const double far = motion->far, near = 0.5 - far;
	enum hawser_status status = hawser__ode_accelerate(ode->right, ode, t, u, v, report);

	*work = *lost = 0.0;
	for (int i = 0; i < mesh->waves; i++) {
		const struct hawser__mesh_wave *wave = &mesh->wave[i];

		*work += cos(wave->Omega*t + wave->phase)*hawser__dot(wave->value, ode->v[wave->node]);
	}
	for (int i = 0; i < mesh->nodes; i++)
		for (int k = 0; k < 3; k++)
			if (mesh->unknown[i][k] >= 0)
				ode->a[i][k] = ode->right[mesh->unknown[i][k]];
	if (motion->tables || mesh->motions)
		*work += reactions(ode);
	for (int e = 0; e < mesh->elements; e++) {
		const struct hawser__motion_element *el = &motion->element[e];
		const double *va = ode->v[el->a], *vb = ode->v[el->b];
		struct state s;

		look(&s, ode, e);
		*lost += el->drag*(near*(hawser__dot(va, va) + hawser__dot(vb, vb)) +
		                   2.0*far*hawser__dot(va, vb));
		*lost += s.p > 0.0 ? (s.T - el->k*s.p)*s.rate : 0.0;
	}
	return status;
}
