/* rom/terms/ties.c - the static response of a cable whose ends are held, with springs: of its condensed
 * modes (condense.c, follow.c), and to displacements of its ends (support_shape.c).
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
 * With bending stiffness C is not pointwise (bend.c), and nothing else changes. A is symmetric and
 * positive definite. In axes along and across the chord that of a straight cable is graded, so that a
 * tiny eps is not lost in round-off. A spring of any stiffness is a small number here, so that a
 * support is the limit without loss.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "core/vec3.h"
#include "modes/label.h"
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

void hawser__ties_free(struct hawser__ties *ties)
{
	if (ties)
		free(ties->field);
	free(ties);
}

static void set_springs(struct hawser__ties *to, const struct hawser_statics *st)
{
	to->size = ENDS;
	for (int i = 0; i < 3*st->attachments; i++)
		if (st->attached[i/3].spring[i%3] > 0.0)
			set_spring(&to->spring[to->size++ - ENDS], st, i/3, i%3, st->attached[i/3].spring[i%3]);
	to->ends = st->attachments;
	for (int i = 0; st->elastic && i < 6; i++)
		if (isfinite(st->held[i/3].stiffness[i%3]))
			set_spring(&to->spring[to->size - ENDS + to->joints++], st, to->ends + i/3, i%3,
			           st->held[i/3].stiffness[i%3]);
}

/* phi_a at s, in axes along and across the chord and along z. */
static void phi(double f[3], const struct hawser__ties *ties, int a, double s)
{
	const struct hawser__tie_spring *spring;

	memset(f, 0, 3*sizeof *f);
	if (a < ENDS) {
		f[a] = 1.0;
		return;
	}
	spring = &ties->spring[a - ENDS];
	if (s < spring->s)
		memcpy(f, spring->h, sizeof spring->h);
}

/* Components along e, n and the third axis of the place. */
static void to_local(double f[3], const struct hawser__place *at)
{
	const double v[3] = {f[0], f[1], f[2]};

	for (int c = 0; c < 3; c++)
		f[c] = hawser__dot(v, at->axis[c]);
}

/* to[a] += the integral of x.phi_a at a node. */
static void add_node(double *to, const struct hawser__ties *ties, int i, const double x[3])
{
	const struct hawser__place *at = &ties->place[i];
	double v[3];

	for (int c = 0; c < 3; c++) {
		v[c] = at->weight*(x[0]*at->axis[0][c] + x[1]*at->axis[1][c] + x[2]*at->axis[2][c]);
		to[c] += v[c];
	}
	for (int a = ENDS; a < ties->size; a++)
		if (ties->s[i] < ties->spring[a - ENDS].s)
			to[a] += hawser__dot(v, ties->spring[a - ENDS].h);
}

/* phi_a at joint j along its axis. */
static double at_joint(const struct hawser__ties *ties, int a, int j)
{
	const struct hawser__tie_spring *joint = &ties->spring[ties->size - ENDS + j];
	double f[3];

	phi(f, ties, a, joint->s);
	return hawser__dot(f, joint->h);
}

/* Row a: the fields that answer phi_a, against all. */
static void fill_row(struct hawser__ties *ties, int a)
{
	double *x = ties->field, *row = ties->A + a*HAWSER__TIES;

	for (int i = 0; i < ties->count; i++) {
		phi(x + 3*i, ties, a, ties->s[i]);
		to_local(x + 3*i, &ties->place[i]);
	}
	hawser__comply(ties->bend, x, ties->place, ties->count);
	for (int i = 0; i < ties->count; i++)
		add_node(row, ties, i, x + 3*i);
	for (int j = 0; j < ties->joints; j++)
		for (int b = 0; b < ties->size; b++)
			row[b] += at_joint(ties, a, j)*at_joint(ties, b, j)/ties->spring[ties->size - ENDS + j].k;
	if (a >= ENDS)
		row[a] += 1.0/ties->spring[a - ENDS].k;
}

enum hawser_status hawser__ties_make(struct hawser__ties **made, const struct hawser_modes *modes,
                                     const struct hawser__bend *bend,
                                     const struct hawser__place *place, const double *s, int count,
                                     struct hawser_report *report)
{
	struct hawser__ties *to = *made = calloc(1, sizeof *to);

	if (to)
		to->field = malloc(3*(size_t)count*sizeof *to->field);
	if (!to || !to->field)
		return hawser__no_memory(report, "rom");
	to->count = count;
	to->s = s;
	to->place = place;
	to->bend = bend;
	set_springs(to, &modes->statics);
	for (int a = 0; a < to->size; a++)
		fill_row(to, a);
	/* rows of the lower triangle are columns of the upper one */
	to->failed = LAPACKE_dpotrf(LAPACK_COL_MAJOR, 'U', to->size, to->A, HAWSER__TIES) != 0;
	return HAWSER_OK;
}

void hawser__ties_solve(struct hawser__ties *ties)
{
	if (ties->failed || LAPACKE_dpotrs(LAPACK_COL_MAJOR, 'U', ties->size, 1, ties->A, HAWSER__TIES,
	                                   ties->z, ties->size) != 0)
		for (int a = 0; a < ties->size; a++)
			ties->z[a] = NAN; /* reported as the entries of the model */
}

void hawser__ties_settle(struct hawser__ties *ties, double *x)
{
	double *F = ties->field;

	hawser__ties_solve(ties);
	for (int i = 0; i < ties->count; i++) {
		memcpy(F + 3*i, ties->z, 3*sizeof *F);
		for (int a = ENDS; a < ties->size; a++)
			for (int c = 0; c < 3 && ties->s[i] < ties->spring[a - ENDS].s; c++)
				F[3*i + c] += ties->z[a]*ties->spring[a - ENDS].h[c];
		to_local(F + 3*i, &ties->place[i]);
	}
	hawser__comply(ties->bend, F, ties->place, ties->count);
	cblas_daxpy(3*ties->count, -1.0, F, 1, x, 1);
}

void hawser__ties_answer(struct hawser__ties *ties, double *x)
{
	memset(ties->z, 0, sizeof ties->z);
	hawser__comply(ties->bend, x, ties->place, ties->count);
	for (int i = 0; i < ties->count; i++)
		add_node(ties->z, ties, i, x + 3*i);
	for (int j = 0; j < ties->joints; j++) {
		const struct hawser__tie_spring *joint = &ties->spring[ties->size - ENDS + j];

		for (int a = 0; a < ties->size && joint->attachment > ties->ends; a++)
			ties->z[a] -= at_joint(ties, a, j)*hawser__dot(ties->beyond, joint->way)/joint->k;
	}
	hawser__ties_settle(ties, x);
}

double hawser__ties_stretch(const struct hawser__ties *ties, int m)
{
	const struct hawser__tie_spring *joint = &ties->spring[m];
	double pull = 0.0;

	if (m < ties->size - ENDS)
		return ties->z[ENDS + m]/joint->k;
	for (int a = 0; a < ties->size; a++)
		pull += ties->z[a]*at_joint(ties, a, m - (ties->size - ENDS));
	return joint->attachment > ties->ends
		? (hawser__dot(ties->beyond, joint->way) + pull)/joint->k : -pull/joint->k;
}

void hawser__ties_start(double u[3], const struct hawser__ties *ties, const double *stretch)
{
	memset(u, 0, 3*sizeof *u);
	for (int m = ties->size - ENDS; m < hawser__ties_springs(ties); m++)
		for (int c = 0; c < 3 && ties->spring[m].attachment == ties->ends; c++)
			u[c] += stretch[m]*ties->spring[m].way[c];
}
