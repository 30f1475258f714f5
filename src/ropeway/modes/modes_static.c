/* ropeway/modes/modes_static.c - the displacements of a rope over sheaves under static loads:
 * solutions of the equations of modes_equations.c. SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <lapacke.h>
#include <math.h>
#include <string.h>

#include "core/hold.h"
#include "ropeway/modes/modes.h"

/* Work space of a solution, within t->work. */
struct spaces {
	double *segment;      /* of a segment: [HAWSER__SEGMENT_FIELDS][2][points] */
	double *force;        /* [strains] by the load alone */
	double *unknown;      /* [rows] */
	double *w;            /* [borders] */
	double *right;        /* [rows] */
	double *right_border; /* [borders] */
	double (*end)[2][2];  /* [segments]: displacement and force at the end, by the load */
	double *load;         /* [size] */
};

static struct spaces spaces_of(const struct hawser__lmode_system *t)
{
	struct spaces p;

	p.segment = t->work;
	p.force = p.segment + t->work_size;
	p.unknown = p.force + t->strains;
	p.w = p.unknown + t->rows;
	p.right = p.w + t->borders;
	p.right_border = p.right + t->rows;
	p.end = (double (*)[2][2])(void *)(p.right_border + t->borders);
	p.load = p.right_border + t->borders + 4*t->segments;
	return p;
}

/* Solve for unknown and w with the right sides of p. */
static void solve(const struct hawser__lmode_system *t, const struct spaces *p, const double (*f)[2])
{
	int n = t->borders;

	memcpy(p->unknown, p->right, (size_t)t->rows*sizeof *p->unknown);
	(void)LAPACKE_dgbtrs_work(LAPACK_COL_MAJOR, 'N', t->rows, HAWSER__BAND, HAWSER__BAND, 1, t->band,
	                          HAWSER__FACTOR_ROWS, t->pivot,
	                     p->unknown, t->rows);
	if (n == 0)
		return;
	for (int b = 0; b < n; b++)
		p->w[b] = -p->right_border[b] - hawser__lmode_pull(t, b, p->unknown, NULL, f);
	(void)LAPACKE_dgetrs_work(LAPACK_COL_MAJOR, 'N', n, 1, t->schur, n, t->schur_pivot, p->w, n);
	for (int b = 0; b < n; b++)
		cblas_daxpy(t->rows, p->w[b], t->response + (size_t)b*(size_t)t->rows, 1, p->unknown, 1);
}

/* Displacement of an end by nodes and borders. */
static double end_of(const struct hawser__lmode_system *t, const struct spaces *p,
                     const struct hawser__lmode_segment *s, int end, int c)
{
	double sum = 0.0;

	for (int d = 0; d < hawser__segment_dofs(t, s, end); d++)
		sum += s->map[end][c][d]*p->unknown[t->node[s->node[end]].row + d];
	for (int b = 0; b < t->borders; b++)
		sum += hawser__segment_reach(t, s, end, c, 0, b)*p->w[b];
	return sum;
}

/* G [D][points] += the derivative of the displacement by given strains. */
static void add_source(double *G, const double *source, const struct hawser__lmode_segment *s)
{
	int points = s->grid.points;

	for (int i = 0; i < points; i++) {
		double a, b;

		if (s->D == 1) {
			G[i] -= (s->sb ? s->sb[i] : s->sa)*source[i];
			continue;
		}
		a = s->sa*source[i];
		b = s->sb[i]*source[points + i];
		G[i] -= s->cosine[i]*a - s->sine[i]*b;
		G[points + i] -= s->sine[i]*a + s->cosine[i]*b;
	}
}

static double lift_of(const struct hawser__lmode_given *given, const struct hawser__lmode_system *t,
                      const struct hawser__lmode_segment *s, int end, int c)
{
	return given && given->lift ? given->lift[s - t->segment][end][c] : 0.0;
}

/* Displacement X and strain of segment s from F0, X0 and the force by the load; off[D] is by how much
 * its end misses the node. */
static void expand(double *X, double *strain, double *off, const struct hawser__lmode_system *t,
                   const struct spaces *p, const struct hawser__lmode_segment *s,
                   const struct hawser__lmode_given *given)
{
	int points = s->grid.points;
	double *F = p->segment, *G = F + 2*points, X0[2];

	for (int c = 0; c < s->D; c++) {
		X0[c] = end_of(t, p, s, 0, c) + lift_of(given, t, s, 0, c);
		for (int i = 0; i < points; i++)
			F[c*points + i] = p->force[s->strain + c*points + i] + p->unknown[s->row + c];
	}
	if (s->k) {
		/* the force by the load has its ground's part already */
		for (int i = 0; i < points; i++)
			G[i] = X0[0]*s->unit[0][i] + p->unknown[s->row]*s->unit[1][i];
		(void)hawser__segment_ground(F, G, s, G + points);
	}
	hawser__segment_gradient(G, F, s);
	if (given && given->source)
		add_source(G, given->source + s->strain, s);
	for (int c = 0; c < s->D; c++) {
		double end = X0[c] + hawser__grid_running(X + c*points, &s->grid, &s->table, G + c*points);

		off[c] = end_of(t, p, s, 1, c) + lift_of(given, t, s, 1, c) - end;
		for (int i = 0; i < points; i++)
			X[c*points + i] += X0[c];
	}
	if (strain)
		hawser__segment_strains(strain, F, s);
	for (int i = 0; strain && given && given->source && i < s->D*points; i++)
		strain[i] -= given->source[s->strain + i];
}

/* What the given strains and the lifts of its ends add to the displacement of a segment's end. */
static void add_given(double *end, const struct hawser__lmode_system *t, const struct spaces *p,
                      const struct hawser__lmode_segment *s, const struct hawser__lmode_given *given)
{
	double *G = p->segment;

	if (!given)
		return;
	memset(G, 0, (size_t)(2*s->grid.points)*sizeof *G);
	if (given->source)
		add_source(G, given->source + s->strain, s);
	for (int c = 0; c < s->D; c++)
		end[c] += cblas_ddot(s->grid.points, s->grid.weight, 1, G + c*s->grid.points, 1) +
		          lift_of(given, t, s, 0, c) - lift_of(given, t, s, 1, c);
}

static void solve_loads(double *x, double *strain, struct hawser__lmode_system *t, const double *load,
                        const struct hawser__lmode_given *given)
{
	struct spaces p = spaces_of(t);
	double (*f)[2] = (double (*)[2])(void *)(p.load + t->size); /* [segments] within [size] */
	double *first = p.load;

	memcpy(p.load, load, (size_t)t->size*sizeof *p.load);
	memset(p.right, 0, (size_t)t->rows*sizeof *p.right);
	for (int i = 0; i < t->segments; i++) {
		const struct hawser__lmode_segment *s = &t->segment[i];

		hawser__segment_load(p.end[i][0], p.end[i][1], p.force + s->strain, p.load + s->at, s,
		                     p.segment);
		add_given(p.end[i][0], t, &p, s, given);
		for (int c = 0; c < s->D; c++) {
			f[i][c] = p.end[i][1][c];
			p.right[s->row + c] = p.end[i][0][c];
			for (int d = 0; d < hawser__segment_dofs(t, s, 1); d++)
				p.right[t->node[s->node[1]].row + d] += s->map[1][c][d]*p.end[i][1][c];
		}
	}
	for (int i = 0; i < t->nodes; i++)
		for (int d = 0; d < t->node[i].dofs; d++)
			p.right[t->node[i].row + d] -= p.load[t->node[i].at + d];
	for (int b = 0; b < t->borders; b++)
		p.right_border[b] = p.load[t->border[b].at];
	for (int i = 0; i < t->pendulums; i++) {
		const struct hawser__lmode_pendulum *one = &t->pendulum[i];

		if (one->border >= 0)
			p.right_border[one->border] += one->along[0]*p.load[one->at];
		for (int d = 0; one->node >= 0 && d < t->node[one->node].dofs; d++)
			p.right[t->node[one->node].row + d] -= one->along[d]*p.load[one->at];
	}
	solve(t, &p, (const double (*)[2])f);
	/* Round-off lets the ends miss their nodes. To first order the error of a frequency is the force
	 * times that; solving once more for it leaves the round-off of the strains alone. */
	for (int i = 0; i < t->segments; i++)
		expand(x + t->segment[i].at, NULL, &p.right[t->segment[i].row], t, &p, &t->segment[i],
		       given);
	for (int i = 0; i < t->nodes; i++)
		for (int d = 0; d < t->node[i].dofs; d++)
			p.right[t->node[i].row + d] = 0.0;
	for (int i = 0; i < t->segments; i++)
		for (int c = 0; c < t->segment[i].D; c++)
			p.right[t->segment[i].row + c] *= -1.0;
	memcpy(first, p.unknown, (size_t)t->rows*sizeof *first);
	memcpy(first + t->rows, p.w, (size_t)t->borders*sizeof *first);
	memset(p.right_border, 0, (size_t)t->borders*sizeof *p.right_border);
	solve(t, &p, NULL);
	cblas_daxpy(t->rows, 1.0, first, 1, p.unknown, 1);
	for (int b = 0; b < t->borders; b++)
		p.w[b] += first[t->rows + b];
	for (int i = 0; i < t->segments; i++)
		expand(x + t->segment[i].at, strain ? strain + t->segment[i].strain : NULL,
		       p.end[i][0], t, &p, &t->segment[i], given);
	for (int i = 0; i < t->nodes; i++)
		for (int d = 0; d < t->node[i].dofs; d++)
			x[t->node[i].at + d] = p.unknown[t->node[i].row + d];
	for (int b = 0; b < t->borders; b++)
		x[t->border[b].at] = p.w[b];
	for (int i = 0; i < t->pendulums; i++) {
		const struct hawser__lmode_pendulum *one = &t->pendulum[i];
		double at = one->border >= 0 ? one->along[0]*p.w[one->border] : 0.0;

		for (int d = 0; one->node >= 0 && d < t->node[one->node].dofs; d++)
			at += one->along[d]*p.unknown[t->node[one->node].row + d];
		x[one->at] = at + one->compliance*load[one->at];
		if (given && given->off)
			x[one->at] += given->off[one->at];
	}
}

int hawser__lmode_circulation(struct hawser__lmode_system *t, const double *v)
{
	double norm;

	t->null = hawser__hold(&t->arrays, (size_t)t->size, sizeof *t->null);
	t->null_strain = hawser__hold(&t->arrays, (size_t)t->strains, sizeof *t->null_strain);
	t->null_load = hawser__hold(&t->arrays, (size_t)t->size, sizeof *t->null_load);
	if (t->arrays.short_of_memory)
		return -1;
	for (int b = 0; b < t->borders; b++)
		t->null_load[t->border[b].at] = v[b];
	solve_loads(t->null, t->null_strain, t, t->null_load, NULL);
	hawser__lmode_inertia(t->null_load, t->null, t);
	norm = 1.0/sqrt(hawser__lmode_product(t->null_load, t->null, t));
	cblas_dscal(t->size, norm, t->null, 1);
	cblas_dscal(t->size, norm, t->null_load, 1);
	cblas_dscal(t->strains, norm, t->null_strain, 1);
	return 0;
}

/* With a loop that circulates: of the part of the load that does not drive it, without circulation. The
 * spring that holds the loop has no force then. */
void hawser__lmode_static(double *x, double *strain, struct hawser__lmode_system *t, const double *load)
{
	double part;

	if (!t->circulates) {
		solve_loads(x, strain, t, load, NULL);
		return;
	}
	part = hawser__lmode_product(load, t->null, t);
	if (x != load)
		memcpy(x, load, (size_t)t->size*sizeof *x);
	cblas_daxpy(t->size, -part, t->null_load, 1, x, 1);
	solve_loads(x, strain, t, x, NULL);
	part = hawser__lmode_product(t->null_load, x, t);
	cblas_daxpy(t->size, -part, t->null, 1, x, 1);
	if (strain)
		cblas_daxpy(t->strains, -part, t->null_strain, 1, strain, 1);
}

void hawser__lmode_static_given(double *x, double *strain, struct hawser__lmode_system *t,
                                const double *load, const struct hawser__lmode_given *given)
{
	solve_loads(x, strain, t, load, given);
}

void hawser__lmode_inertia(double *load, const double *x, const struct hawser__lmode_system *t)
{
	memmove(load, x, (size_t)t->size*sizeof *load);
	for (int i = 0; i < t->nodes; i++) {
		const struct hawser__lmode_node *node = &t->node[i];
		double z[2] = {x[node->at], node->dofs > 1 ? x[node->at + 1] : 0.0};

		for (int d = 0; d < node->dofs; d++)
			load[node->at + d] = node->mass[d][0]*z[0] + node->mass[d][1]*z[1];
	}
	for (int i = 0; i < t->pendulums; i++)
		load[t->pendulum[i].at] *= t->pendulum[i].mass;
	for (int i = 0; i < t->borders; i++)
		load[t->border[i].at] *= t->border[i].mass;
}

double hawser__lmode_product(const double *load, const double *x, const struct hawser__lmode_system *t)
{
	double sum = 0.0;

	for (int i = 0; i < t->size; i++)
		sum += t->weight[i]*load[i]*x[i];
	return sum;
}

double hawser__lmode_stroke(const struct hawser__lmode_pendulum *one, const double *x,
                            const struct hawser__lmode_system *t)
{
	double stroke = x[one->at];

	if (one->border >= 0)
		stroke -= one->along[0]*x[t->border[one->border].at];
	for (int d = 0; one->node >= 0 && d < t->node[one->node].dofs; d++)
		stroke -= one->along[d]*x[t->node[one->node].at + d];
	return stroke;
}

double hawser__lmode_stiffness(const double *x, const double *strain, const double *y,
                               const double *other, const struct hawser__lmode_system *t)
{
	double sum = 0.0;

	for (int i = 0; i < t->segments; i++) {
		const struct hawser__lmode_segment *s = &t->segment[i];

		for (int k = 0; k < s->D*s->grid.points; k++) {
			double w = s->grid.weight[k%s->grid.points];

			sum += w*strain[s->strain + k]*other[s->strain + k];
			if (s->k)
				sum += w*s->k[k]*x[s->at + k]*y[s->at + k];
		}
	}
	for (int i = 0; i < t->nodes; i++)
		for (int d = 0; d < t->node[i].dofs; d++)
			for (int k = 0; k < t->node[i].dofs; k++)
				sum += t->node[i].stiffness[d][k]*x[t->node[i].at + d]*y[t->node[i].at + k];
	for (int i = 0; i < t->borders; i++)
		sum += t->border[i].stiffness*x[t->border[i].at]*y[t->border[i].at];
	for (int i = 0; i < t->pendulums; i++)
		sum += hawser__lmode_stroke(&t->pendulum[i], x, t)*
		       hawser__lmode_stroke(&t->pendulum[i], y, t)/t->pendulum[i].compliance;
	return sum;
}
