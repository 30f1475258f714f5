/* ropeway/expand/expand_answer.c - what the modes that are not kept do under a force that oscillates.
 *
 *   b, W       the force, times cos(W t); M, K mass and stiffness; A = K^-1 M
 *   P          takes the kept modes out of a displacement
 *   z_0        P K^-1 b: the static response; z_1 = P A z_0 the first correction for inertia
 *   v_i, T     Lanczos' vectors of A that begin with z_0/|z_0|, orthonormal in M, and v_i' M A v_j
 *   y, theta   eigenvectors of T and eigenvalues 1/omega_s^2; Phi_s = sum y_i v_i, force omega_s^2
 *              |z_0| y_1
 *
 * The response is (1 - W^2 A)^-1 z_0. In the space of the vectors it is the sum of |z_0| y_1 Phi_s/(1 -
 * W^2/omega_s^2), the first two terms of whose series in W^2 are those of z_0 and z_1. What the sum has
 * beyond these is force*H_s Phi_s (rom/condense/known.c). Up to a frequency, `reach`, the Phi_s are
 * the modes that the force drives; above it they stand for many.
 *
 * The lowest modes would do the same. But most of those that a model does not keep hardly move under
 * its force, and a loaded span has tens of them below a harmonic of a load; Lanczos' vectors are those
 * that do, and each takes one static solution. All are made orthogonal to all others, twice.
 *
 * Reference: E. L. Wilson, M.-W. Yuan and J. M. Dickens, Earthq. Eng. Struct. Dyn. 10 (1982) 813.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <cblas.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "ropeway/expand/expand_modes.h"

enum { STEPS = 40 }; /* vectors; chosen: they find what a span does up to ten times its lowest
                       * frequency, and thirteen spans up to five times theirs */
/* Residual of an eigenvector relative to its eigenvalue, which then has an error of 1e-4; chosen. */
static const double found = 1e-2;
static const double nothing = 1e-10; /* what is left of a vector when there is no further one */

struct work {
	const struct hawser__lmode *rope;
	const struct hawser__lexpand_modes *modes;
	size_t size, strains;  /* of all systems */
	double *load;          /* [size] */
	double *vector;        /* [STEPS + 1][size + strains] */
	double T[STEPS*STEPS], y[STEPS*STEPS], theta[STEPS];
	double left;           /* what of A v_m the vectors don't contain */
};

static struct hawser__lexpand_field vector_of(const struct work *w, int i)
{
	double *at = w->vector + (size_t)i*(w->size + w->strains);

	return (struct hawser__lexpand_field){at, at + w->size};
}

/* --- products --- */

/* x'y in the inner product of M. */
static double product(const struct work *w, const double *x, const double *y)
{
	double sum = 0.0;

	for (int i = 0; i < w->rope->systems; i++) {
		const struct hawser__lmode_system *system = &w->rope->system[i];

		hawser__lmode_inertia(w->load, x, system);
		sum += hawser__lmode_product(w->load, y, system);
		x += system->size;
		y += system->size;
	}
	return sum;
}

/* to += factor*from. */
static void add(const struct work *w, const struct hawser__lexpand_field *to, double factor,
                const struct hawser__lexpand_field *from)
{
	cblas_daxpy((int)w->size, factor, from->x, 1, to->x, 1);
	cblas_daxpy((int)w->strains, factor, from->strain, 1, to->strain, 1);
}

static void scale(const struct work *w, const struct hawser__lexpand_field *field, double factor)
{
	cblas_dscal((int)w->size, factor, field->x, 1);
	cblas_dscal((int)w->strains, factor, field->strain, 1);
}

/* Where system `own` begins. */
static struct hawser__lexpand_field part_of(const struct work *w,
                                            const struct hawser__lexpand_field *field, int own)
{
	struct hawser__lexpand_field part = *field;

	for (int i = 0; i < own; i++) {
		part.x += w->rope->system[i].size;
		part.strain += w->rope->system[i].strains;
	}
	return part;
}

/* field = P field. */
static void remove_kept(const struct work *w, const struct hawser__lexpand_field *field)
{
	for (int k = 0; k < w->modes->search.n; k++) {
		const struct hawser__lexpand_shape *mode = &w->modes->shape[k];
		const struct hawser__lmode_system *system = &w->rope->system[mode->system];
		struct hawser__lexpand_field part = part_of(w, field, mode->system);
		double sum;

		hawser__lmode_inertia(w->load, mode->x, system);
		sum = hawser__lmode_product(w->load, part.x, system);
		cblas_daxpy(system->size, -sum, mode->x, 1, part.x, 1);
		cblas_daxpy(system->strains, -sum, mode->strain, 1, part.strain, 1);
	}
}

/* to = P A from. */
static void follow(const struct work *w, const struct hawser__lexpand_field *to, const double *from)
{
	double *x = to->x, *strain = to->strain;

	for (int i = 0; i < w->rope->systems; i++) {
		struct hawser__lmode_system *system = &w->rope->system[i];

		hawser__lmode_inertia(w->load, from, system);
		if (system->plane == HAWSER_IN_PLANE)
			hawser__lmode_static(x, strain, system, w->load);
		from += system->size;
		x += system->size;
		strain += system->strains;
	}
	remove_kept(w, to);
}

/* --- the static response --- */

/* A force along y per length on one segment, in the frame of its displacements. */
static void pull_segment(double *load, const struct hawser__lmode *rope,
                         const struct hawser__lmode_segment *s,
                         double (*pull)(const void *wave, double s), const void *wave)
{
	const struct hawser__lmode_piece *piece = s->piece;
	double angle = atan2(piece->reference[1], piece->reference[0]);

	for (int p = 0; p < s->grid.points; p++) {
		double at = piece->s0 + s->grid.s[p], value = pull(wave, at);

		if (s->D == 1)
			hawser_line_at(rope->lane[piece->lane], NULL, &angle, NULL, NULL, NULL, at*rope->length);
		load[p] = value*sin(angle);
		if (s->D == 2)
			load[s->grid.points + p] = value*cos(angle);
	}
}

static void hold(const struct work *w, const struct hawser__lexpand_field *z,
                 double (*pull)(const void *wave, double s), const void *wave, int lane)
{
	double *x = z->x, *strain = z->strain;

	for (int i = 0; i < w->rope->systems; i++) {
		struct hawser__lmode_system *system = &w->rope->system[i];

		memset(w->load, 0, (size_t)system->size*sizeof *w->load);
		for (int k = 0; system->plane == HAWSER_IN_PLANE && k < system->segments; k++)
			if (system->segment[k].piece->lane == lane)
				pull_segment(w->load + system->segment[k].at, w->rope, &system->segment[k], pull,
				             wave);
		if (system->plane == HAWSER_IN_PLANE)
			hawser__lmode_static(x, strain, system, w->load);
		x += system->size;
		strain += system->strains;
	}
	remove_kept(w, z);
}

/* The shape that expand_drive.c made, which has no part of kept modes. */
static void drive(const struct work *w, const struct hawser__lexpand_field *z)
{
	const struct hawser__lexpand_shape *shape = &w->modes->shape[w->modes->search.n];
	const struct hawser__lmode_system *system = &w->rope->system[shape->system];
	struct hawser__lexpand_field part = part_of(w, z, shape->system);

	memcpy(part.x, shape->x, (size_t)system->size*sizeof *part.x);
	memcpy(part.strain, shape->strain, (size_t)system->strains*sizeof *part.strain);
}

/* --- Lanczos --- */

/* Vectors and T, of which the first vector is set; returns their number. */
static int iterate(struct work *w)
{
	for (int i = 0; i < STEPS; i++) {
		struct hawser__lexpand_field next = vector_of(w, i + 1), v = vector_of(w, i);

		follow(w, &next, v.x);
		for (int pass = 0; pass < 2; pass++)
			for (int j = 0; j <= i; j++) {
				double part;

				v = vector_of(w, j);
				part = product(w, v.x, next.x);
				add(w, &next, -part, &v);
				w->T[j*STEPS + i] += part;
			}
		w->left = sqrt(fmax(product(w, next.x, next.x), 0.0));
		if (w->left <= nothing*w->T[0] || i + 1 == STEPS)
			return i + 1;
		scale(w, &next, 1.0/w->left);
	}
	return STEPS;
}

/* The eigenvectors of T [steps] by falling theta in the rows of y; returns 0, or 1 if LAPACK fails. */
static int decompose(struct work *w, int steps)
{
	for (int i = 0; i < steps; i++)
		for (int j = 0; j <= i; j++)
			w->y[(size_t)i*STEPS + j] = w->y[(size_t)j*STEPS + i] =
				i - j <= 1 ? -w->T[j*STEPS + i] : 0.0;
	/* column-major: the eigenvectors become rows */
	return LAPACKE_dsyev(LAPACK_COL_MAJOR, 'V', 'U', steps, w->y, STEPS, w->theta) != 0;
}

/* The motions that are found, and reach. `size`: |z_0|. */
static void choose(struct hawser__lexpand_answer *answer, const struct work *w, int steps, double size)
{
	int reached = 0;

	for (int s = 0; s < steps && -w->theta[s] > 0.0; s++) {
		const double *y = w->y + (size_t)s*STEPS;
		double theta = -w->theta[s];

		reached |= fabs(w->left*y[steps - 1]) > found*theta;
		answer->reach = reached ? answer->reach : 1.0/sqrt(theta);
		answer->omega2[s] = 1.0/theta;
		answer->force[s] = size*y[0]/theta;
		for (int i = 0; i < steps; i++) {
			struct hawser__lexpand_field v = vector_of(w, i);

			add(w, &answer->field[2 + s], y[i], &v);
		}
		answer->known = s + 1;
	}
}

static enum hawser_status allocate(struct hawser__lexpand_answer *answer, struct work *w,
                                   struct hawser_report *report)
{
	size_t most = 1, wide;

	for (int i = 0; i < w->rope->systems; i++) {
		size_t own = (size_t)w->rope->system[i].size;

		most = own > most ? own : most;
		w->size += own;
		w->strains += (size_t)w->rope->system[i].strains;
	}
	wide = w->size + w->strains;
	answer->omega2 = calloc(STEPS, sizeof(double));
	answer->force = calloc(STEPS, sizeof(double));
	answer->field = calloc(2 + STEPS, sizeof *answer->field);
	answer->memory = calloc((2 + STEPS)*wide, sizeof(double));
	w->load = calloc(most, sizeof(double));
	w->vector = calloc((STEPS + 1)*wide, sizeof(double));
	if (!answer->omega2 || !answer->force || !answer->field || !answer->memory || !w->load ||
	    !w->vector)
		return hawser__no_memory(report, "line rom");
	for (size_t i = 0; i < 2 + STEPS; i++)
		answer->field[i] = (struct hawser__lexpand_field){answer->memory + i*wide,
			answer->memory + i*wide + w->size};
	return HAWSER_OK;
}

enum hawser_status hawser__lexpand_answer(struct hawser__lexpand_answer *answer,
                                          const struct hawser__lexpand_modes *t,
                                          double (*pull)(const void *wave, double s),
                                          const void *wave, int lane, struct hawser_report *report)
{
	struct work *w = calloc(1, sizeof *w);
	enum hawser_status status;
	double size;

	*answer = (struct hawser__lexpand_answer){.known = 0};
	if (!w)
		return hawser__no_memory(report, "line rom");
	w->rope = &t->rope;
	w->modes = t;
	status = allocate(answer, w, report);
	if (!status) {
		struct hawser__lexpand_field first = vector_of(w, 0);

		if (pull)
			hold(w, &answer->field[0], pull, wave, lane);
		else
			drive(w, &answer->field[0]);
		size = sqrt(fmax(product(w, answer->field[0].x, answer->field[0].x), 0.0));
		follow(w, &answer->field[1], answer->field[0].x);
		add(w, &first, size > 0.0 ? 1.0/size : 0.0, &answer->field[0]);
		if (size > 0.0) {
			int steps = iterate(w);

			if (decompose(w, steps))
				status = hawser__no_memory(report, "line rom");
			else
				choose(answer, w, steps, size);
		}
	}
	free(w->load);
	free(w->vector);
	free(w);
	return status;
}

void hawser__lexpand_answer_clear(struct hawser__lexpand_answer *answer)
{
	free(answer->omega2);
	free(answer->force);
	free(answer->field);
	free(answer->memory);
	*answer = (struct hawser__lexpand_answer){.known = 0};
}
