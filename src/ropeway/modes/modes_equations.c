/* ropeway/modes/modes_equations.c - the equations of a rope over sheaves under static loads.
 *
 *   F        force along the rope, in the frame of its run; F' = -f + k X
 *   X        displacement; X' = C F, with C = sa^2 e e' + sb^2 n n' in the plane
 *   F0, z    unknowns: the force at the beginning of each segment, the values of the nodes
 *
 * X and F are integrated from F0 and from the node at the beginning; what follows for the end is
 * linear in both, with P by units of them and a part by the load. The equations say that the end meets
 * its node and that the forces on each node are balanced. They are banded, and have no large
 * coefficient for a nearly inextensible rope, whose compliance just becomes small; a stiffness matrix
 * of the nodes would hold EA/length of an arc against the stiffness of the sag, a factor of 1e7 in a
 * common ropeway.
 *
 * The running integral of Gauss collocation satisfies integration by parts exactly, so that the
 * operator from loads to displacements is symmetric to round-off, and its eigenvalues are real.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/hold.h"
#include "core/report.h"
#include "ropeway/modes/modes.h"

/* A motion of borders whose stiffness is less than this part of what the rope pulls at them has none:
 * the round-off of the statics leaves some 1e-13, and the softest carriage has some 1e-6. */
static const double loose = 1e-10;

/* --- the equations --- */

static void add(struct hawser__lmode_system *t, int row, int column, double value)
{
	t->band[(size_t)column*HAWSER__FACTOR_ROWS + (size_t)(2*HAWSER__BAND + row - column)] += value;
}

/* The equations of segment s: E1 z1 - P00 E0 z0 - P01 F0 = x; and its part in those of its nodes:
 * E0' F0 at the first, -E1' (P10 E0 z0 + P11 F0) at the last. */
static void assemble_segment(struct hawser__lmode_system *t, const struct hawser__lmode_segment *s)
{
	const struct hawser__lmode_node *from = s->node[0] >= 0 ? &t->node[s->node[0]] : NULL;
	const struct hawser__lmode_node *to = s->node[1] >= 0 ? &t->node[s->node[1]] : NULL;

	for (int c = 0; c < s->D; c++)
		for (int k = 0; k < s->D; k++)
			add(t, s->row + c, s->row + k, -s->P[0][1][c][k]);
	for (int c = 0; c < s->D; c++)
		for (int d = 0; d < hawser__segment_dofs(t, s, 1); d++) {
			add(t, s->row + c, to->row + d, s->map[1][c][d]);
			for (int k = 0; k < s->D; k++)
				add(t, to->row + d, s->row + k, -s->map[1][c][d]*s->P[1][1][c][k]);
		}
	for (int d = 0; d < hawser__segment_dofs(t, s, 0); d++)
		for (int k = 0; k < s->D; k++) {
			add(t, from->row + d, s->row + k, s->map[0][k][d]);
			for (int c = 0; c < s->D; c++) {
				add(t, s->row + c, from->row + d, -s->P[0][0][c][k]*s->map[0][k][d]);
				for (int r = 0; r < hawser__segment_dofs(t, s, 1) && s->P[1][0][c][k] != 0.0; r++)
					add(t, to->row + r, from->row + d,
					    -s->map[1][c][r]*s->P[1][0][c][k]*s->map[0][k][d]);
			}
		}
}

static void assemble(struct hawser__lmode_system *t)
{
	for (int i = 0; i < t->segments; i++)
		assemble_segment(t, &t->segment[i]);
	for (int i = 0; i < t->nodes; i++)
		for (int d = 0; d < t->node[i].dofs; d++)
			for (int k = 0; k < t->node[i].dofs; k++)
				add(t, t->node[i].row + d, t->node[i].row + k, -t->node[i].stiffness[d][k]);
}

/* Minus the residual of all equations by a unit of border b: right[rows]. */
static void border_column(double *right, const struct hawser__lmode_system *t, int b)
{
	memset(right, 0, (size_t)t->rows*sizeof *right);
	for (int i = 0; i < t->segments; i++) {
		const struct hawser__lmode_segment *s = &t->segment[i];

		for (int c = 0; c < s->D; c++) {
			right[s->row + c] -= hawser__segment_reach(t, s, 1, c, 0, b);
			for (int k = 0; k < s->D; k++) {
				right[s->row + c] += s->P[0][0][c][k]*hawser__segment_reach(t, s, 0, k, 0, b);
				for (int d = 0; d < hawser__segment_dofs(t, s, 1); d++)
					right[t->node[s->node[1]].row + d] +=
						s->map[1][c][d]*s->P[1][0][c][k]*hawser__segment_reach(t, s, 0, k, 0, b);
			}
		}
	}
}

double hawser__lmode_pull(const struct hawser__lmode_system *t, int b, const double *unknown,
                          const double *w,
                   const double (*f)[2])
{
	double sum = 0.0;

	for (int i = 0; i < t->segments; i++) {
		const struct hawser__lmode_segment *s = &t->segment[i];

		for (int c = 0; c < s->D; c++) {
			double at[2] = {hawser__segment_reach(t, s, 0, c, 0, b),
			                hawser__segment_reach(t, s, 1, c, 0, b)}, end = f ? f[i][c] : 0.0;

			if (at[0] == 0.0 && at[1] == 0.0)
				continue;
			for (int k = 0; k < s->D; k++) {
				double X0 = 0.0;

				for (int d = 0; d < hawser__segment_dofs(t, s, 0); d++)
					X0 += s->map[0][k][d]*unknown[t->node[s->node[0]].row + d];
				for (int r = 0; w && r < t->borders; r++)
					X0 += hawser__segment_reach(t, s, 0, k, 0, r)*w[r];
				end += s->P[1][0][c][k]*X0 + s->P[1][1][c][k]*unknown[s->row + k];
			}
			sum += at[0]*unknown[s->row + c] - at[1]*end;
		}
	}
	return sum;
}

/* Places in states and equations; allocates what depends on them. */
static enum hawser_status arrange(struct hawser__lmode_system *t, struct hawser_report *report)
{
	int largest = 0, nodes = 0;
	size_t borders = (size_t)t->borders;

	t->size = t->strains = t->rows = 0;
	for (int i = 0; i < t->segments; i++) {
		struct hawser__lmode_segment *s = &t->segment[i];

		s->at = t->size;
		s->strain = t->strains;
		t->size += s->D*s->grid.points;
		t->strains += s->D*s->grid.points;
		largest = s->grid.points > largest ? s->grid.points : largest;
		s->row = t->rows;
		t->rows += s->D;
		if (s->node[1] >= 0) {
			t->node[s->node[1]].row = t->rows;
			t->rows += t->node[s->node[1]].dofs;
		}
	}
	for (int i = 0; i < t->nodes; i++, nodes++) {
		t->node[i].at = t->size;
		t->size += t->node[i].dofs;
	}
	for (int i = 0; i < t->pendulums; i++)
		t->pendulum[i].at = t->size++;
	for (int i = 0; i < t->borders; i++)
		t->border[i].at = t->size++;
	hawser__hold_clear(&t->arrays);
	t->null = t->null_strain = t->null_load = NULL;
	t->circulates = 0;
	t->work_size = HAWSER__SEGMENT_FIELDS*2*largest;
	t->weight = hawser__hold(&t->arrays, (size_t)t->size, sizeof *t->weight);
	t->band = hawser__hold(&t->arrays, (size_t)t->rows*HAWSER__FACTOR_ROWS, sizeof *t->band);
	t->pivot = hawser__hold(&t->arrays, (size_t)t->rows, sizeof *t->pivot);
	t->response = hawser__hold(&t->arrays, borders*(size_t)t->rows, sizeof *t->response);
	t->schur = hawser__hold(&t->arrays, borders*borders, sizeof *t->schur);
	t->schur_pivot = hawser__hold(&t->arrays, borders, sizeof *t->schur_pivot);
	t->work = hawser__hold(&t->arrays, (size_t)t->work_size + (size_t)t->strains +
	                       2*((size_t)t->rows + borders) + 4*(size_t)t->segments +
	                       2*(size_t)t->size, sizeof *t->work);
	if (t->arrays.short_of_memory)
		return hawser__no_memory(report, "line modes");
	for (int i = 0; i < t->segments; i++)
		for (int k = 0; k < t->segment[i].D*t->segment[i].grid.points; k++)
			t->weight[t->segment[i].at + k] = t->segment[i].grid.weight[k%t->segment[i].grid.points];
	for (int i = t->size - t->pendulums - t->borders; i < t->size; i++)
		t->weight[i] = 1.0;
	for (int i = 0; i < t->nodes; i++)
		for (int d = 0; d < t->node[i].dofs; d++)
			t->weight[t->node[i].at + d] = 1.0;
	return HAWSER_OK;
}

static enum hawser_status singular(const struct hawser__lmode_system *t, struct hawser_report *report)
{
	return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "line modes", "the rope has no stiffness "
	                    "against a motion %s: a part of it is slack or can circulate freely",
	                    t->plane == HAWSER_IN_PLANE ? "in the plane" : "out of the plane");
}

/* A loop of rope, closed over borders, may circulate without any resistance. Hold it then by a spring
 * on the motion v of the borders that has no stiffness: v [borders]. Returns 1 if there is one. */
static int hold_circulation(double *v, struct hawser__lmode_system *t, double scale)
{
	int n = t->borders, found = -1;
	double *S = hawser__numbers((size_t)n*(size_t)n, 1), *value = hawser__numbers((size_t)n, 1);

	for (int i = 0; S && value && i < n; i++)
		for (int j = 0; j < n; j++)
			S[i*n + j] = 0.5*(t->schur[i*n + j] + t->schur[j*n + i]);
	if (S && value && LAPACKE_dsyev(LAPACK_COL_MAJOR, 'V', 'L', n, S, n, value) == 0)
		for (int i = 0; i < n; i++)
			if (fabs(value[i]) < loose*scale)
				found = i;
	for (int i = 0; found >= 0 && i < n; i++)
		v[i] = S[found*n + i];
	for (int i = 0; found >= 0 && i < n; i++)
		for (int j = 0; j < n; j++)
			t->schur[i*n + j] -= scale*v[i]*v[j];
	free(S);
	free(value);
	return found >= 0;
}

static enum hawser_status factor_borders(struct hawser__lmode_system *t, struct hawser_report *report)
{
	int n = t->borders, info = 0;
	double scale = 0.0, *w = hawser__numbers((size_t)n, 1), *v = hawser__numbers((size_t)n, 1);

	if (!w || !v) {
		free(w);
		free(v);
		return hawser__no_memory(report, "line modes");
	}
	for (int b = 0; b < n; b++) {
		border_column(t->response + (size_t)b*(size_t)t->rows, t, b);
		(void)LAPACKE_dgbtrs_work(LAPACK_COL_MAJOR, 'N', t->rows, HAWSER__BAND, HAWSER__BAND, 1,
		                          t->band, HAWSER__FACTOR_ROWS,
		                          t->pivot,
		                          t->response + (size_t)b*(size_t)t->rows, t->rows);
	}
	for (int b = 0; b < n; b++) {
		const double *column = t->response + (size_t)b*(size_t)t->rows;

		for (int r = 0; r < n; r++)
			w[r] = r == b;
		for (int r = 0; r < n; r++)
			t->schur[b*n + r] = hawser__lmode_pull(t, r, column, w, NULL) -
				(r == b ? t->border[b].stiffness : 0.0);
		for (int i = 0; i < t->segments; i++)
			for (int c = 0; c < t->segment[i].D; c++)
				for (int end = 0; end < HAWSER__ENDS; end++)
					scale = fmax(scale, fabs(hawser__segment_reach(t, &t->segment[i], end, c, 0, b)*
					                         column[t->segment[i].row + c]));
	}
	t->circulates = n > 0 && hold_circulation(v, t, scale);
	if (n > 0)
		info = (int)LAPACKE_dgetrf(LAPACK_COL_MAJOR, n, n, t->schur, n, t->schur_pivot);
	if (info == 0 && t->circulates)
		info = hawser__lmode_circulation(t, v);
	free(w);
	free(v);
	return info == 0 ? HAWSER_OK : info < 0 ? hawser__no_memory(report, "line modes")
	                                        : singular(t, report);
}

enum hawser_status hawser__lmode_factor(struct hawser__lmode_system *t, struct hawser_report *report)
{
	enum hawser_status status = arrange(t, report);

	for (int i = 0; i < t->segments && !status; i++) {
		if (t->segment[i].k)
			status = hawser__segment_on_ground(&t->segment[i], t->work, report);
		else
			hawser__segment_free(&t->segment[i], t->work);
	}
	if (status)
		return status;
	assemble(t);
	for (int i = 0; i < t->rows*HAWSER__FACTOR_ROWS; i++)
		if (!isfinite(t->band[i]))
			return hawser__fail(report, HAWSER_ERR_NAN, "line modes", "the stiffness of the rope came "
			                    "out as not a number: check EA, rho and the tension of the line");
	if (LAPACKE_dgbtrf(LAPACK_COL_MAJOR, t->rows, t->rows, HAWSER__BAND, HAWSER__BAND, t->band,
	                   HAWSER__FACTOR_ROWS, t->pivot) != 0)
		return singular(t, report);
	return factor_borders(t, report);
}

