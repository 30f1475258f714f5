/* rom/terms/ties.c - springs of attachments in the static response of the condensed modes.
 *
 *   F(s)      force in the cable that answers a load: lambda + the sum of z_m h_m over springs beyond s
 *   phi_a     unit forces of which F is made: along, across the chord and along z; h_m up to spring m
 *   x0        strains without F; C the compliance of a point: eps along e, 1/k along n and z
 *   r_a       integral of x0.phi_a
 *   X_m       displacement of spring m along its axis: the integral of the strains times phi_m
 *
 * The displacement minimises the energy of the cable and of the springs with both ends fixed. Its
 * strains are x0 - C F, and z_m = k_m X_m, so that
 *
 *   A z = r,   A_ab = integral of phi_a C phi_b, plus 1/k_m on the diagonal for springs,
 *
 * (elastic supports have a strain at each end: phi_a(0) phi_b(0)/k of end A and phi_a(l) phi_b(l)/k
 * of end B are further parts of A, and the whole load, P, moves end B by P/k without F:
 * r_a -= phi_a(l) P/k,)
 * With bending stiffness C is not pointwise (bend.c), and nothing else changes. A is
 * symmetric and positive definite: the closed form of condense.c with a row a spring. A spring of any
 * stiffness is a small number here, so that a support is the limit without loss.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "core/vec3.h"
#include "modes/label.h"
#include "rom/terms/dampers.h"
#include "rom/terms/ties.h"

enum { ENDS = 3 };

/* Spring of stiffness k, N/m, from point i along axis c of the scene. */
static void set_spring(struct hawser__tie_spring *spring, const struct hawser_statics *st, int i, int c,
                       double k)
{
	double chord = hypot(1.0, st->hs), cosine = 1.0/chord, sine = st->hs/chord;

	const double axis[3] = {c == 0, c == 1, c == 2};

	*spring = (struct hawser__tie_spring){.s = hawser__point(st, i).s, .attachment = i,
	                                      .k = k*st->span.d/st->H};
	hawser_statics_from_global(st, spring->way, axis);
	spring->h[0] = cosine*spring->way[0] + sine*spring->way[1];
	spring->h[1] = cosine*spring->way[1] - sine*spring->way[0];
	spring->h[2] = spring->way[2];
}

void hawser__springs_free(struct hawser__springs *springs)
{
	if (springs)
		free(springs->field);
	free(springs);
}

enum hawser_status hawser__springs_make(struct hawser__springs **made, const struct hawser_modes *modes,
                                        struct hawser_report *report)
{
	const struct hawser_statics *st = &modes->statics;
	struct hawser__springs *to;

	*made = NULL;
	if (!hawser__has_springs(st) && !st->elastic && !(st->bending.EI > 0.0))
		return HAWSER_OK;
	to = calloc(1, sizeof *to);
	if (!to)
		return hawser__no_memory(report, "rom");
	to->size = ENDS;
	for (int i = 0; i < st->attachments; i++)
		for (int c = 0; c < 3; c++) {
			struct hawser__tie_spring *spring = &to->spring[to->size - ENDS];

			if (!(st->attached[i].spring[c] > 0.0))
				continue;
			set_spring(spring, st, i, c, st->attached[i].spring[c]);
			to->size++;
		}
	to->ends = st->attachments;
	for (int i = 0; st->elastic && i < 6; i++)
		if (isfinite(st->held[i/3].stiffness[i%3]))
			set_spring(&to->spring[to->size - ENDS + to->joints++], st, to->ends + i/3, i%3,
			           st->held[i/3].stiffness[i%3]);
	*made = to;
	return HAWSER_OK;
}

/* phi_a at s, in axes along and across the chord and along z. */
static void phi(double f[3], const struct hawser__springs *springs, int a, double s)
{
	const struct hawser__tie_spring *spring;

	memset(f, 0, 3*sizeof *f);
	if (a < ENDS) {
		f[a] = 1.0;
		return;
	}
	spring = &springs->spring[a - ENDS];
	if (s < spring->s)
		memcpy(f, spring->h, sizeof spring->h);
}

/* Components along e, n, z at the place, in space along its three axes. */
static void to_local(double f[3], const struct hawser__place *at)
{
	double along = f[0], across = f[1], z = f[2];

	for (int c = 0; c < 3 && at->space; c++)
		f[c] = along*at->axis[c][0] + across*at->axis[c][1] + z*at->axis[c][2];
	if (at->space)
		return;
	f[0] = along*at->ex + across*at->ey;
	f[1] = across*at->ex - along*at->ey;
}

/* A of the cable: fields that answer phi_a, against phi_b. */
static void add_cable(struct hawser__springs *springs, const struct hawser__bend *bend,
                      const struct hawser__place *place, const double *s, int count)
{
	double *x = springs->field;

	for (int a = 0; a < springs->size; a++) {
		for (int i = 0; i < count; i++) {
			phi(x + 3*i, springs, a, s[i]);
			to_local(x + 3*i, &place[i]);
		}
		hawser__comply(bend, x, place, count);
		for (int i = 0; i < count; i++)
			for (int b = 0; b <= a; b++) {
				double g[3];

				phi(g, springs, b, s[i]);
				to_local(g, &place[i]);
				springs->A[a*HAWSER__TIES + b] +=
					place[i].weight*(x[3*i]*g[0] + x[3*i + 1]*g[1] + x[3*i + 2]*g[2]);
			}
	}
}

/* phi_a at joint j along its axis. */
static double at_joint(const struct hawser__springs *springs, int a, int j)
{
	const struct hawser__tie_spring *joint = &springs->spring[springs->size - ENDS + j];
	double f[3];

	phi(f, springs, a, joint->s);
	return f[0]*joint->h[0] + f[1]*joint->h[1] + f[2]*joint->h[2];
}

enum hawser_status hawser__springs_assemble(struct hawser__springs *springs,
                                            const struct hawser__bend *bend,
                                            const struct hawser__place *place, const double *s,
                                            int count, struct hawser_report *report)
{
	springs->field = malloc(3*(size_t)count*sizeof *springs->field);
	if (!springs->field)
		return hawser__no_memory(report, "rom");
	add_cable(springs, bend, place, s, count);
	for (int j = 0; j < springs->joints; j++)
		for (int a = 0; a < springs->size; a++)
			for (int b = 0; b <= a; b++)
				springs->A[a*HAWSER__TIES + b] +=
					at_joint(springs, a, j)*at_joint(springs, b, j)/
					springs->spring[springs->size - ENDS + j].k;
	for (int a = ENDS; a < springs->size; a++)
		springs->A[a*HAWSER__TIES + a] += 1.0/springs->spring[a - ENDS].k;
	/* rows of the lower triangle are columns of the upper one */
	springs->failed = LAPACKE_dpotrf(LAPACK_COL_MAJOR, 'U', springs->size, springs->A,
	                                 HAWSER__TIES) != 0;
	return HAWSER_OK;
}

void hawser__springs_load(struct hawser__springs *springs, const struct hawser__place *at, double s,
                          const double x[3])
{
	for (int a = 0; a < springs->size; a++) {
		double f[3];

		phi(f, springs, a, s);
		to_local(f, at);
		springs->z[a] += at->weight*(f[0]*x[0] + f[1]*x[1] + f[2]*x[2]);
	}
}

void hawser__springs_solve(struct hawser__springs *springs)
{
	for (int j = 0; j < springs->joints; j++) {
		const struct hawser__tie_spring *joint = &springs->spring[springs->size - ENDS + j];

		for (int a = 0; a < springs->size && joint->attachment > springs->ends; a++)
			springs->z[a] -= at_joint(springs, a, j)*hawser__dot(springs->beyond, joint->way)/joint->k;
	}
	if (springs->failed || LAPACKE_dpotrs(LAPACK_COL_MAJOR, 'U', springs->size, 1, springs->A,
	                                      HAWSER__TIES, springs->z, springs->size) != 0)
		for (int a = 0; a < springs->size; a++)
			springs->z[a] = NAN; /* reported as the entries of the model */
}

void hawser__springs_release(double *x, struct hawser__springs *springs,
                             const struct hawser__bend *bend, const struct hawser__place *place,
                             const double *s, int count)
{
	double *F = springs->field;

	memset(F, 0, 3*(size_t)count*sizeof *F);
	for (int i = 0; i < count; i++) {
		for (int a = 0; a < springs->size; a++) {
			double g[3];

			phi(g, springs, a, s[i]);
			for (int c = 0; c < 3; c++)
				F[3*i + c] += springs->z[a]*g[c];
		}
		to_local(F + 3*i, &place[i]);
	}
	hawser__comply(bend, F, place, count);
	for (int i = 0; i < 3*count; i++)
		x[i] -= F[i];
}

double hawser__springs_stretch(const struct hawser__springs *springs, int m)
{
	const struct hawser__tie_spring *joint = &springs->spring[m];
	double pull = 0.0;

	if (m < springs->size - ENDS)
		return springs->z[ENDS + m]/joint->k;
	for (int a = 0; a < springs->size; a++)
		pull += springs->z[a]*at_joint(springs, a, m - (springs->size - ENDS));
	return joint->attachment > springs->ends
		? (hawser__dot(springs->beyond, joint->way) + pull)/joint->k : -pull/joint->k;
}

void hawser__springs_start(double u[3], const struct hawser__springs *springs, const double *stretch)
{
	memset(u, 0, 3*sizeof *u);
	for (int m = springs->size - ENDS; m < springs->size - ENDS + springs->joints; m++)
		for (int c = 0; c < 3 && springs->spring[m].attachment == springs->ends; c++)
			u[c] += stretch[m]*springs->spring[m].way[c];
}
