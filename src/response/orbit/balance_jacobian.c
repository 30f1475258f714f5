/* response/orbit/balance_jacobian.c - the Jacobian of the balanced equations, in the frequency domain.
 *
 * For the tangent T = T_0/2 + sum of C_k cos(k tau) + S_k sin(k tau), the change of the force by a
 * cos(l tau) + b sin(l tau) has at harmonic h
 *
 *   cos:  a (C_{h+l} + C_{|h-l|})/2 + b (S_{h+l} + sgn(l-h) S_{|h-l|})/2
 *   sin:  a (S_{h+l} + sgn(h-l) S_{|h-l|})/2 + b (C_{|h-l|} - C_{h+l})/2
 *
 * and half of the cosine for the constant. The matrix is stored by rows, which is the transpose for
 * LAPACK, because a row of the tangent is contiguous.
 *
 * Columns are scaled by the sizes of the metric, and rows by these times |T_jj| + (h Omega)^2. The
 * entries of the matrix and of the border are then of order one.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "response/orbit/balance.h"

#define ASSEMBLED 10.0 /* operations for an element of the matrix, at the speed of a factorisation;
                        * chosen */

void hawser__balance_scale(struct hawser__balance *balance)
{
	int n = balance->base.n;
	double omega = balance->derived_at;

	for (int h = 0; h <= balance->order; h++)
		for (int q = balance->first[h]; q < balance->first[h + 1]; q++) {
			int j = balance->list[q], c = balance->place[hawser__cos(n, h, j)];
			double u = 1.0/balance->size_u[j], v = h*omega/balance->size_v[j];
			double col = 1.0/sqrt(0.5*(u*u + v*v));
			double row = 1.0/(col*(fabs(balance->stiffness[j]) + h*h*omega*omega));

			balance->col_scale[c] = col;
			balance->row_scale[c] = row;
			if (h) {
				int s = balance->place[hawser__sin(n, h, j)];

				balance->col_scale[s] = col;
				balance->row_scale[s] = row;
			}
		}
}

/* Rows of T for a block: sums and differences of harmonics. */
struct parts {
	const double *c_sum, *c_dif, *s_sum, *s_dif;
	double cs, sc; /* signs of s_dif */
};

static struct parts choose(const struct hawser__balance *balance, int h, int l, int j)
{
	int n = balance->base.n, n2 = n*n, gap = h > l ? h - l : l - h;
	const double *T = balance->T + j*n;

	/* the sine of harmonic 0 has the weight 0, so that any row may stand for it */
	return (struct parts){T + hawser__cos(n2, h + l, 0), T + hawser__cos(n2, gap, 0),
		T + hawser__sin(n2, h + l, 0), T + hawser__sin(n2, gap, 0),
		l > h ? 0.5 : l < h ? -0.5 : 0.0, h > l ? 0.5 : h < l ? -0.5 : 0.0};
}

/* Row of the equation (h, j), cosine and sine, in the columns of harmonic l; the rows begin with the
 * column `origin`. */
static void fill_block(struct hawser__balance *balance, double *cos_row, double *sin_row, int h,
                       int j, int l, int origin)
{
	struct parts p = choose(balance, h, l, j);
	int count = balance->first[l + 1] - balance->first[l];
	const int *k = balance->list + balance->first[l];
	int at = count ? balance->place[hawser__cos(balance->base.n, l, k[0])] - origin : 0;
	double *ca = cos_row + at, *cb = ca + count, *sa = sin_row + at, *sb = sa + count;

	if (h == 0 && l == 0) {
		for (int q = 0; q < count; q++)
			ca[q] = 0.5*p.c_sum[k[q]];
	} else if (h == 0) {
		for (int q = 0; q < count; q++) {
			ca[q] = 0.5*p.c_sum[k[q]];
			cb[q] = 0.5*p.s_sum[k[q]];
		}
	} else if (l == 0) {
		for (int q = 0; q < count; q++) {
			ca[q] = p.c_sum[k[q]];
			sa[q] = p.s_sum[k[q]];
		}
	} else {
		for (int q = 0; q < count; q++) {
			double c = 0.5*p.c_sum[k[q]], d = 0.5*p.c_dif[k[q]];
			double s = 0.5*p.s_sum[k[q]], e = p.s_dif[k[q]];

			ca[q] = d + c;
			cb[q] = s + p.cs*e;
			sa[q] = s + p.sc*e;
			sb[q] = d - c;
		}
	}
}

/* Inertia and mean damping of the equation (h, j). */
static void add_motion(struct hawser__balance *balance, double *cos_row, double *sin_row, int h,
                       int j, double omega, int origin)
{
	int n = balance->base.n;
	const double *D = balance->base.rom->D + (size_t)j*n;
	const double *more = balance->resist ? balance->resist + (size_t)j*n : NULL;

	cos_row[balance->place[hawser__cos(n, h, j)] - origin] -= h*h*omega*omega;
	sin_row[balance->place[hawser__sin(n, h, j)] - origin] -= h*h*omega*omega;
	for (int q = balance->first[h]; q < balance->first[h + 1]; q++) {
		int k = balance->list[q];
		double d = h*omega*(D[k] + (more ? 0.5*more[k] : 0.0));

		cos_row[balance->place[hawser__sin(n, h, k)] - origin] += d;
		sin_row[balance->place[hawser__cos(n, h, k)] - origin] -= d;
	}
}

/* Add factor * D [n][n] times a column to the equations of one kind (cosine or sine) of a
 * harmonic. */
static void add_damping_block(struct hawser__balance *balance, int to, int from, double factor,
                              const double *D)
{
	int n = balance->base.n, P = balance->unknowns;

	for (int j = 0; j < n; j++)
		for (int k = 0; k < n; k++) {
			int row = balance->place[to + j], col = balance->place[from + k];

			if (row >= 0 && col >= 0)
				balance->matrix[(size_t)row*(P + 1) + col] += factor*D[j*n + k];
		}
}

/* The same for harmonic h (of either sign), cosine or sine. */
static void add_damping_wave(struct hawser__balance *balance, int sine, int h, int from,
                             double factor, const double *D)
{
	int n = balance->base.n, a = h < 0 ? -h : h;

	if (a > balance->order || (sine && h == 0))
		return;
	add_damping_block(balance, sine ? hawser__sin(n, a, 0) : hawser__cos(n, a, 0), from,
	                  sine && h < 0 ? -factor : factor, D);
}

/* s cos|sin(k tau) D v, where v of a cosine is -h Omega sin, of a sine h Omega cos. */
static void add_parametric_damping(struct hawser__balance *balance,
                                   const struct hawser_harmonic *harmonic, double omega)
{
	int n = balance->base.n, k = harmonic->k, cosine = harmonic->phase == HAWSER_COS;
	double s = 0.5*pow(omega, harmonic->omega_power)*omega;

	for (int l = 1; l <= balance->order; l++) {
		int a = hawser__cos(n, l, 0), b = hawser__sin(n, l, 0);

		if (cosine) {
			add_damping_wave(balance, 1, l + k, a, -l*s, harmonic->D);
			add_damping_wave(balance, 1, l - k, a, -l*s, harmonic->D);
			add_damping_wave(balance, 0, l + k, b, l*s, harmonic->D);
			add_damping_wave(balance, 0, l - k, b, l*s, harmonic->D);
		} else {
			add_damping_wave(balance, 0, l - k, a, -l*s, harmonic->D);
			add_damping_wave(balance, 0, l + k, a, l*s, harmonic->D);
			add_damping_wave(balance, 1, k + l, b, l*s, harmonic->D);
			add_damping_wave(balance, 1, k - l, b, l*s, harmonic->D);
		}
	}
}

void hawser__balance_set_border(struct hawser__balance *balance, const double *row)
{
	int P = balance->unknowns, last = balance->base.size - 1;

	for (int c = 0; c < P; c++)
		balance->border[c] = balance->base.weight[balance->slot[c]]*row[balance->slot[c]]*
		                     balance->col_scale[c];
	balance->border[P] = balance->base.weight[last]*row[last]*balance->base.W;
}

static void scale_and_border(struct hawser__balance *balance)
{
	int P = balance->unknowns;
	double W = balance->base.W, *matrix = balance->matrix;

	for (int i = 0; i < P; i++) {
		double *m = matrix + (size_t)i*(P + 1), r = balance->row_scale[i];

		for (int c = 0; c < P; c++)
			m[c] *= r*balance->col_scale[c];
		m[P] = balance->by_omega[balance->slot[i]]*r*W;
	}
	memcpy(matrix + (size_t)P*(P + 1), balance->border, ((size_t)P + 1)*sizeof *matrix);
}

/* J without parametric damping: the rows and columns of the harmonics from `from` on. */
static void fill(struct hawser__balance *balance, double *matrix, int stride, int from)
{
	int n = balance->base.n, origin = balance->unknowns;
	double omega = balance->derived_at;

	hawser__balance_transform(balance);
	for (int i = 0; i < balance->unknowns; i++)
		if ((balance->slot[i]/n + 1)/2 >= from) {
			origin = i;
			break;
		}
	for (int h = from; h <= balance->order; h++)
		for (int q = balance->first[h]; q < balance->first[h + 1]; q++) {
			int j = balance->list[q], c = balance->place[hawser__cos(n, h, j)] - origin;
			int s = h ? balance->place[hawser__sin(n, h, j)] - origin : c;
			double *cos_row = matrix + (size_t)c*stride, *sin_row = matrix + (size_t)s*stride;

			for (int l = from; l <= balance->order; l++)
				fill_block(balance, cos_row, sin_row, h, j, l, origin);
			if (h)
				add_motion(balance, cos_row, sin_row, h, j, omega, origin);
		}
}

int hawser__balance_top(struct hawser__balance *balance, double *matrix, int from)
{
	int n = balance->base.n, P = balance->unknowns, count = 0, origin;

	for (int i = 0; i < P; i++)
		count += (balance->slot[i]/n + 1)/2 >= from;
	origin = P - count;
	if (!matrix)
		return count;
	fill(balance, matrix, count, from);
	for (int i = 0; i < count; i++)
		for (int c = 0; c < count; c++)
			matrix[(size_t)i*count + c] *= balance->row_scale[origin + i]*
			                               balance->col_scale[origin + c];
	return count;
}

void hawser__balance_assemble(struct hawser__balance *balance)
{
	const struct hawser_rom *rom = balance->base.rom;
	double P = balance->unknowns;

	balance->base.cost.dense += ASSEMBLED*P*P;
	fill(balance, balance->matrix, balance->unknowns + 1, 0);
	for (int p = 0; p < rom->harmonics; p++)
		if (rom->harmonic[p].D)
			add_parametric_damping(balance, &rom->harmonic[p], balance->derived_at);
	/* two harmonics up to the order are coupled by their sum and difference */
	for (int row = 1; balance->resist && row <= 2*balance->monodromy.resist_order &&
	                  row <= 4*balance->order; row++)
		if (hawser__balance_resists(balance, row))
			add_parametric_damping(balance,
			                       &(struct hawser_harmonic){.k = (row + 1)/2,
			                       .phase = row%2 ? HAWSER_COS : HAWSER_SIN,
			                       .D = balance->resist + (size_t)row*rom->n*rom->n},
			                       balance->derived_at);
	scale_and_border(balance);
}
