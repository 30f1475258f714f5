/* modes/complex/damped.c - complex modes of a cable at rest with dampers (doc/theory-modes.md).
 *
 *   q, omega  coordinates of the Galerkin modes of a polynomial basis (basis.c): mass 1, stiffness
 *             omega^2. Attachments are edges of elements, so that the shapes have their kinks
 *   D         diag(d) + sum of w_i b_i b_i' + W: d the damping of the scene, b_i = h.Phi at a damper,
 *             W that by a wind (wind.c)
 *   sigma     1/lambda; y = omega q
 *   sigma^2 y + sigma (D/omega omega') y + y/omega^2 = 0
 *   S         sqrt(m_a) times the stroke of an absorber, its displacement along a relative to the
 *             point: a further coordinate with mass 1, stiffness k_a/m_a and damping c_a/m_a. Its
 *             velocity is X' + s' a, and its mass is part of that of the point, so that
 *             M = [1 C; C' 1] with C = sqrt(m_a) a.Phi. M = R R' by Cholesky, and R/omega takes the
 *             place of 1/omega
 *
 * In this form, the standard problem of a matrix with blocks, the wanted eigenvalues are those of
 * largest modulus, and the stiff longitudinal modes are small numbers. With lambda in place of sigma
 * the round-off would be relative to the highest longitudinal frequency. Static shapes of the dampers'
 * forces beside a few modes (rom/terms/dampers.c) converge as 1/n^3 only.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <float.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/hold.h"
#include "core/report.h"
#include "core/vec3.h"
#include "modes/cable.h"
#include "modes/complex/damped.h"
#include "modes/complex/wind.h"
#include "modes/label.h"

/* Functions per component at most: the eigenvalues of more would take minutes. */
enum { MOST = 360 };
/* Part of the modulus below which an imaginary part is the round-off of a double real eigenvalue. */
static const double real_part = 1e-7;

/* An eigenvalue with im >= 0; im is 0 exactly if it is real. */
struct value {
	double re, im, residual; /* round-off, relative */
	int out;                 /* 1: out of plane */
};
struct list {
	int count, planes;   /* planes 1: `out` is wanted, for which the vectors are computed */
	struct value *value; /* [count] by ascending im */
};

/* --- the matrix --- */

/* The Galerkin modes of one block: of one plane, or all. */
struct block {
	int n;
	int *mode;      /* [n] indices of modes */
	int absorbers;      /* rows behind those of the modes */
	int own[HAWSER_ATTACH_MAX]; /* [absorbers] their attachments */
	double tuned[HAWSER_ATTACH_MAX]; /* [absorbers] sqrt(k_a/m_a), scaled */
	double R[HAWSER_ATTACH_MAX*HAWSER_ATTACH_MAX]; /* [absorbers][absorbers] of 1 - C'C, column-major */
	int vectors;
	double *b;      /* [vectors][n] over omega */
	double *weight; /* [vectors] */
	double *A;      /* [2n][2n] column-major */
	double *re, *im; /* [2n] */
	double *V;      /* [2n][2n] column-major, eigenvectors */
	struct hawser__hold hold;
};

static void block_clear(struct block *t)
{
	free(t->mode);
	hawser__hold_clear(&t->hold);
}

/* Damping of the scene in mode k, scaled; *alpha: that along the cable, which masses do not have. */
static double own_damping(double *alpha, const struct hawser_scene *scene,
                          const struct hawser_modes *modes, int k)
{
	const double t = modes->time_unit, omega = modes->mode[k].omega;

	*alpha = 0.0;
	if (!scene)
		return 0.0;
	switch (scene->damping.kind) {
	case HAWSER_DAMPING_ALPHA:
		*alpha = scene->damping.alpha*t/modes->statics.span.rho;
		return *alpha;
	case HAWSER_DAMPING_RAYLEIGH:
		return scene->damping.mass*t + scene->damping.stiffness/t*omega*omega;
	case HAWSER_DAMPING_RATIO:
		return 2.0*hawser__damping_ratio(scene, &modes->mode[k])*omega;
	case HAWSER_DAMPING_NONE:
		break;
	}
	return 0.0;
}

/* Displacement of each mode at each point of label.h, [modes][points][3]. */
static double *displacements(const struct hawser_modes *modes)
{
	int count = hawser__points(&modes->statics);
	double *u = malloc(((size_t)modes->n*(size_t)count*3 + 1)*sizeof *u);

	for (int k = 0; u && k < modes->n; k++)
		for (int i = 0; i < count; i++)
			hawser__modes_attached(u + 3*((size_t)k*(size_t)count + (size_t)i), modes, k, i);
	return u;
}

/* Whether a damper joins motions in the plane and out of it. */
static int joins(const struct hawser_modes *modes, const struct hawser_statics *st, const double *u)
{
	for (int i = 0; i < st->attachments; i++)
		for (int c = 0; c < 3; c++) {
			double most[2] = {0.0}, axis[3][3];

			hawser_statics_damper(axis, st, i);
			for (int k = 0; k < modes->n; k++) {
				double *of = &most[modes->mode[k].plane == HAWSER_OUT_OF_PLANE];

				*of = fmax(*of, fabs(hawser__dot(axis[c], u + 3*(k*hawser__points(st) + i))));
			}
			if (st->attached[i].damper[c] > 0.0 && most[0] > 0.0 && most[1] > 0.0)
				return 1;
		}
	for (int i = 0; i < st->attachments; i++) {
		const double *way = st->attached[i].absorber_axis;

		if (st->attached[i].absorber > 0.0 && way[2] != 0.0 && (way[0] != 0.0 || way[1] != 0.0))
			return 1;
	}
	return 0;
}

/* The absorbers that act in this plane, or all. */
static void take_absorbers(struct block *t, const struct hawser_statics *st, int plane)
{
	for (int i = 0; i < st->attachments; i++) {
		const struct hawser_attached *at = &st->attached[i];
		int out = at->absorber_axis[2] != 0.0;

		if (!(at->absorber > 0.0) || (plane >= 0 && out != (plane == HAWSER_OUT_OF_PLANE)))
			continue;
		t->tuned[t->absorbers] = sqrt(at->absorber_stiffness*st->span.d/(st->H*at->absorber));
		t->own[t->absorbers++] = i;
	}
}

static int block_make(struct block *t, const struct hawser_modes *modes,
                      const struct hawser_statics *st, int plane, int vectors)
{
	size_t points = (size_t)hawser__points(&modes->statics), N;

	*t = (struct block){.n = 0};
	t->mode = malloc((size_t)modes->n*sizeof *t->mode);
	for (int k = 0; t->mode && k < modes->n; k++)
		if (plane < 0 || (int)modes->mode[k].plane == plane)
			t->mode[t->n++] = k;
	take_absorbers(t, st, plane);
	N = 2*(size_t)(t->n + t->absorbers);
	t->b = hawser__hold(&t->hold, 3*points*N + 1, sizeof *t->b);
	t->weight = hawser__hold(&t->hold, 6*points + 1, sizeof *t->weight);
	t->A = hawser__hold(&t->hold, N*N + 1, sizeof *t->A);
	t->V = hawser__hold(&t->hold, vectors ? N*N + 1 : 1, sizeof *t->V);
	t->re = hawser__hold(&t->hold, N + 1, sizeof *t->re);
	t->im = hawser__hold(&t->hold, N + 1, sizeof *t->im);
	return !t->hold.short_of_memory && t->mode;
}

/* The vectors of dampers, and those of masses, on which `alpha` does not act; Rayleigh's factor `mass`
 * does not act on absorbers. */
static void point_damping(struct block *t, const struct hawser_modes *modes,
                          const struct hawser_statics *st, const double *u, double alpha,
                          double mass)
{
	int points = hawser__points(st);
	double axis[3][3];

	for (int i = 0; i < points; i++)
		for (int c = 0; c < 3; c++) {
			double damper = i < st->attachments ? st->attached[i].damper[c] : 0.0;
			double *b = t->b + (size_t)t->vectors*(size_t)t->n;
			double held = i < st->attachments ? mass*st->attached[i].absorber : 0.0;
			double weight = damper/sqrt(st->span.rho*st->H) - alpha*hawser__point(st, i).m - held;

			hawser_statics_damper(axis, st, i);
			for (int k = 0; k < t->n; k++)
				b[k] = hawser__dot(axis[c], u + 3*(t->mode[k]*points + i))/
				       modes->mode[t->mode[k]].omega;
			t->weight[t->vectors] = weight;
			t->vectors += weight != 0.0;
		}
}

/* C of absorber i and mode k of the block. */
static double coupling(const struct block *t, const struct hawser_statics *st, const double *u, int i,
                       int k)
{
	const struct hawser_attached *at = &st->attached[t->own[i]];
	const double *v = u + 3*(t->mode[k]*hawser__points(st) + t->own[i]), *axis = at->absorber_axis;

	return sqrt(at->absorber)*(axis[0]*v[0] + axis[1]*v[1] + axis[2]*v[2]);
}

/* The rows of absorbers. Returns LAPACK's info. */
static int add_absorbers(struct block *t, const struct hawser_statics *st, const double *u)
{
	int a = t->absorbers, m = t->n + a, info;
	size_t N = 2*(size_t)m;

	for (int i = 0; i < a; i++) {
		const struct hawser_attached *at = &st->attached[t->own[i]];
		size_t row = (size_t)(t->n + i);
		double damping = at->absorber_damping/sqrt(st->span.rho*st->H)/at->absorber;

		t->A[row*N + row] = -damping/(t->tuned[i]*t->tuned[i]);
		for (int j = 0; j <= i; j++) {
			double sum = i == j;

			for (int k = 0; k < t->n; k++)
				sum -= coupling(t, st, u, i, k)*coupling(t, st, u, j, k);
			t->R[j*a + i] = sum;
		}
		for (int k = 0; k < t->n; k++) {
			double part = coupling(t, st, u, i, k)/t->tuned[i];

			t->A[(size_t)(m + k)*N + row] = -part;
			t->A[row*N + (size_t)(m + k)] = part;
		}
	}
	info = a > 0 ? LAPACKE_dpotrf(LAPACK_COL_MAJOR, 'L', a, t->R, a) : 0;
	for (int i = 0; i < a && !info; i++)
		for (int j = 0; j <= i; j++) {
			size_t row = (size_t)(t->n + i), column = (size_t)(m + t->n + j);

			t->A[column*N + row] = -t->R[j*a + i]/t->tuned[i];
			t->A[row*N + column] = t->R[j*a + i]/t->tuned[i];
		}
	return info;
}

/* sigma (y, w) = A (y, w), with sigma w = L'y, L = R/omega. flow: damping of all modes by the wind, or
 * NULL. Returns LAPACK's info. */
static int assemble(struct block *t, const struct hawser_modes *modes, const struct hawser_statics *st,
                     const struct hawser_scene *scene, const double *u, const double *flow)
{
	size_t n = (size_t)t->n, m = n + (size_t)t->absorbers, N = 2*m;
	double alpha = 0.0, mass = scene && scene->damping.kind == HAWSER_DAMPING_RAYLEIGH
	                           ? scene->damping.mass*modes->time_unit : 0.0;

	for (size_t k = 0; k < n; k++) {
		double omega = modes->mode[t->mode[k]].omega;

		t->A[k*N + k] = -own_damping(&alpha, scene, modes, t->mode[k])/(omega*omega);
		t->A[(m + k)*N + k] = -1.0/omega;
		t->A[k*N + m + k] = 1.0/omega;
	}
	point_damping(t, modes, st, u, alpha, mass);
	for (size_t j = 0; flow && j < n; j++)
		for (size_t k = 0; k < n; k++)
			t->A[k*N + j] -= flow[(size_t)t->mode[j]*(size_t)modes->n + (size_t)t->mode[k]]/
			                 (modes->mode[t->mode[j]].omega*modes->mode[t->mode[k]].omega);
	for (int v = 0; v < t->vectors; v++)
		for (size_t j = 0; j < n; j++)
			for (size_t k = 0; k < n; k++)
				t->A[k*N + j] -= t->weight[v]*t->b[(size_t)v*n + j]*t->b[(size_t)v*n + k];
	return add_absorbers(t, st, u);
}

/* --- eigenvalues of a basis --- */

/* By ascending damped frequency, then by modulus: real eigenvalues first. */
static int compare(const void *a, const void *b)
{
	const struct value *x = a, *y = b;

	if (x->im != y->im)
		return (x->im > y->im) - (x->im < y->im);
	return (x->re < y->re) - (x->re > y->re);
}

/* The share of the kinetic energy, |q|^2 = |y/omega|^2, out of plane, of the eigenvector in columns
 * j and j + 1. */
static double share_out(const struct block *t, const struct hawser_modes *modes, int j)
{
	size_t N = 2*(size_t)(t->n + t->absorbers);
	const double *re = t->V + (size_t)j*N, *im = re + N;
	double sum[2] = {0.0};

	for (int k = 0; k < t->n; k++) {
		const struct hawser_mode *mode = &modes->mode[t->mode[k]];

		sum[mode->plane == HAWSER_OUT_OF_PLANE] +=
			(re[k]*re[k] + im[k]*im[k])/(mode->omega*mode->omega);
	}
	return sum[1]/(sum[0] + sum[1]);
}

/* Append the eigenvalues lambda = 1/sigma. `floor`: their round-off, relative, is floor*|lambda|. */
static void collect(struct list *list, const struct block *t,
                    const struct hawser_modes *modes, double floor)
{
	for (int j = 0; j < 2*(t->n + t->absorbers); j++) {
		double re = t->re[j], im = t->im[j], square = re*re + im*im;
		struct value *to = &list->value[list->count];

		if (im < 0.0 || !(square > 0.0)) /* of a pair the first has im > 0 */
			continue;
		*to = (struct value){.re = re/square, .im = im/square,
		                                    .residual = floor/sqrt(square)};
		if (im <= real_part*sqrt(square))
			to->im = 0.0;
		else if (list->planes)
			to->out = share_out(t, modes, j) > 0.5;
		list->count++;
	}
}

static enum hawser_status solve_block(struct list *list, const struct hawser_modes *modes,
                                      const struct hawser_statics *st,
                                      const struct hawser_scene *scene, const double *u,
                                      const double *flow, int plane,
                                      struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;
	double norm = 0.0;
	struct block t;
	int info, N;

	if (!block_make(&t, modes, st, plane, list->planes)) {
		block_clear(&t);
		return hawser__no_memory(report, "modes");
	}
	info = assemble(&t, modes, st, scene, u, flow);
	N = 2*(t.n + t.absorbers);
	for (size_t i = 0; i < (size_t)N*(size_t)N; i++)
		norm += t.A[i]*t.A[i];
	if (!info)
		info = LAPACKE_dgeev(LAPACK_COL_MAJOR, 'N', list->planes ? 'V' : 'N', N, t.A, N, t.re, t.im,
		                     NULL, 1, t.V, N);
	if (hawser__lapack_starved(info))
		status = hawser__no_memory(report, "modes");
	else if (info)
		status = hawser__fail(report, HAWSER_ERR_NAN, "modes",
		                      "the damped modes of %d functions met a not-a-number: check the "
		                      "dampers of attach and the damping", t.n);
	else
		collect(list, &t, modes, 4.0*DBL_EPSILON*sqrt(norm));
	block_clear(&t);
	return status;
}

/* All eigenvalues in the space of these modes; the caller frees list->value. */
static enum hawser_status values_of(struct list *list, int planes, const struct hawser_modes *modes,
                                    const struct hawser_statics *st,
                                    const struct hawser_scene *scene, struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;
	int failed;
	double *u = displacements(modes), *flow = hawser__wind_damping(&failed, modes, scene);

	*list = (struct list){.planes = planes};
	list->value = malloc(2*((size_t)modes->n + HAWSER_ATTACH_MAX + 1)*sizeof *list->value);
	if (!u || !list->value || failed)
		status = hawser__no_memory(report, "modes");
	else if (flow || joins(modes, st, u))
		status = solve_block(list, modes, st, scene, u, flow, -1, report);
	else
		for (int plane = 0; plane < HAWSER__PLANES && !status; plane++)
			status = solve_block(list, modes, st, scene, u, NULL, plane, report);
	free(u);
	free(flow);
	if (!status)
		qsort(list->value, (size_t)list->count, sizeof *list->value, compare);
	return status;
}

/* --- two bases --- */

void hawser__damped_pair_clear(struct hawser__damped_pair *pair)
{
	hawser_modes_clear(&pair->coarse);
	hawser_modes_clear(&pair->fine);
}

enum hawser_status hawser__damped_pair(struct hawser__damped_pair *pair,
                                       const struct hawser_statics *st, int n, int tries,
                                       struct hawser_report *report)
{
	int elements = hawser__cable_elements(st), degree, next, functions;
	struct hawser_statics held = *st; /* absorbers are masses of the basis */
	enum hawser_status status;

	*pair = (struct hawser__damped_pair){.functions = 0};
	if (st->space)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes",
		                    "damped modes of a cable that masses or springs in a wind, or "
		                    "attach.force, take out of one plane are not available: leave --damped "
		                    "out, or set load.static.per_length=[0,0,0] and forces downwards");
	if (st->bending.EI > 0.0)
		return hawser__damped_bending(pair, st, n, tries > 0 ? tries : 0, report);
	for (int i = 0; i < held.attachments; i++)
		held.attached[i].absorber = 0.0;
	degree = st->attachments > 0 ? hawser__cable_degree_attached(st, n + 2)
	                             : hawser__cable_degree(elements, n + 2);
	for (int i = 0; i < tries; i++)
		degree += degree/3 + 3;
	degree -= tries < 0 ? degree/3 : 0;
	next = degree + (degree/4 > 3 ? degree/4 : 3);
	functions = next*elements - 1;
	if (functions > MOST)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes",
		                    "%d damped modes asked, which need some %d functions a component where "
		                    "%d are the most: ask for fewer modes", n, functions, MOST);
	pair->functions = functions;
	status = hawser_modes_basis(&pair->coarse, &held, degree*elements - 1, degree*elements - 1, report);
	if (!status)
		status = hawser_modes_basis(&pair->fine, &held, functions, functions, report);
	if (status)
		hawser__damped_pair_clear(pair);
	return status;
}

/* Distance of the nearest eigenvalue of the smaller basis, relative. */
static double nearest(const struct list *list, const struct value *of)
{
	double least = INFINITY;

	for (int i = 0; i < list->count; i++)
		least = fmin(least, hypot(list->value[i].re - of->re, list->value[i].im - of->im));
	return least/hypot(of->re, of->im);
}

/* The n modes of lowest damped frequency; *worst: the largest estimated error. grows: they may have
 * negative damping. */
static enum hawser_status lowest(struct hawser_damped *damped, double *worst,
                                 const struct list *fine, const struct list *coarse, int n,
                                 int grows, struct hawser_report *report)
{
	int number[HAWSER__PLANES] = {0}, first = 0;
	double largest = 0.0;

	*worst = 0.0;
	damped->n = 0;
	damped->mode = calloc((size_t)n, sizeof *damped->mode);
	if (!damped->mode)
		return hawser__no_memory(report, "modes");
	while (first < fine->count && fine->value[first].im == 0.0)
		first++;
	for (int i = first; i < fine->count && damped->n < n; i++) {
		const struct value *from = &fine->value[i];
		double modulus = hypot(from->re, from->im);
		double re = grows ? from->re : fmin(from->re, 0.0); /* but for round-off */

		damped->mode[damped->n++] = (struct hawser_damped_mode){
			.omega = from->im, .re = re, .ratio = -re/modulus,
			.residual = from->residual + nearest(coarse, from),
			.plane = from->out ? HAWSER_OUT_OF_PLANE : HAWSER_IN_PLANE,
			.number = ++number[from->out]};
		*worst = fmax(*worst, damped->mode[damped->n - 1].residual);
		largest = fmax(largest, modulus);
	}
	damped->overdamped = 0;
	damped->slowest = 0.0;
	for (int i = 0; i < first; i++)
		if (fabs(fine->value[i].re) <= largest) {
			damped->slowest = damped->overdamped++ ? fmax(damped->slowest, fine->value[i].re)
			                                       : fine->value[i].re;
			*worst = fmax(*worst, fine->value[i].residual + nearest(coarse, &fine->value[i]));
		}
	return HAWSER_OK;
}

enum hawser_status hawser__damped_of(struct hawser_damped *damped, double *worst,
                                     const struct hawser__damped_pair *pair,
                                     const struct hawser_statics *st,
                                     const struct hawser_scene *scene, int n, int planes,
                                     struct hawser_report *report)
{
	struct list fine = {.count = 0}, coarse = {.count = 0};
	enum hawser_status status = values_of(&coarse, 0, &pair->coarse, st, scene, report);

	*damped = (struct hawser_damped){.basis = pair->functions, .time_unit = pair->fine.time_unit};
	if (!status)
		status = values_of(&fine, planes, &pair->fine, st, scene, report);
	if (!status)
		status = lowest(damped, worst, &fine, &coarse, n, scene && scene->wind.present, report);
	free(fine.value);
	free(coarse.value);
	return status;
}
