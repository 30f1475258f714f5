/* rom/energy/quartic_tangent.c - tangent of the expanded strain energy, from strains. Glossary:
 * quartic.c.
 *
 *    Phi       strains of the modes; H stiffness of the points, a symmetric 3 by 3 matrix each
 *    Y         dy/du [rows][modes], linear in u: the matrices `pull` are its derivatives
 *
 * The second derivatives of the energy by the modes are, besides K,
 *
 *    Phi'H Phi + Y'B Y
 *
 * where H has the second derivatives of the sum over points, and of the third order along the strains
 * of the modes and U d; the derivative by a shape and a mode is an entry of Y. Rows of Y that belong
 * to modes are the tangent of third order. It comes from tables of size n^3, and Phi'H Phi from matrix
 * products of size points n^2: with tables of products of slopes, as in exact_block.c, there would be
 * as many operations and more memory to read.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <stdlib.h>
#include <string.h>

#include "core/hot.h"
#include "rom/energy/kernel.h"
#include "rom/energy/quartic.h"

enum { BLOCK = HAWSER_BLOCK, ROOM = 8192 /* doubles of a table of scaled slopes on the stack */ };

/* The stiffness of the points, [width] each. */
struct stiffness {
	double aa[HAWSER__QUARTIC_POINTS], ab[HAWSER__QUARTIC_POINTS], bb[HAWSER__QUARTIC_POINTS];
	double ac[HAWSER__QUARTIC_POINTS], bc[HAWSER__QUARTIC_POINTS], cc[HAWSER__QUARTIC_POINTS];
};

#define vec(at) (*(const hawser__vec *)(at))

/* Third order along the strains at + along (along may be NULL), and the fourth order if `both`. */
HAWSER_PART void stiffen(struct stiffness *h, const struct hawser__quartic *q,
                         const struct hawser__quartic_field *at,
                         const struct hawser__quartic_field *along, int both)
{
	int width = q->width;

	for (int p = 0; p < width; p += BLOCK) {
		int ia = HAWSER__QUARTIC_A(p, width), ib = HAWSER__QUARTIC_B(p, width);
		hawser__vec a = vec(at->ab + ia), b = vec(at->ab + ib), c = vec(at->c + p);
		hawser__vec third = vec(q->third + p), fa = a, fb = b, fc = c;
		hawser__vec square = vec(q->square + p), mixed = vec(q->mixed + p);
		hawser__vec sigma = b*b + c*c, turn = 4.0*square*sigma - 2.0*mixed*a*a;

		if (along) {
			fa += vec(along->ab + ia);
			fb += vec(along->ab + ib);
			fc += vec(along->c + p);
		}
		if (!both)
			turn = sigma = square = mixed = 0.0*third;
		*(hawser__vec *)(h->aa + p) = -2.0*mixed*sigma;
		*(hawser__vec *)(h->ab + p) = third*fb - 4.0*mixed*a*b;
		*(hawser__vec *)(h->ac + p) = third*fc - 4.0*mixed*a*c;
		*(hawser__vec *)(h->bb + p) = third*fa + turn + 8.0*square*b*b;
		*(hawser__vec *)(h->bc + p) = 8.0*square*b*c;
		*(hawser__vec *)(h->cc + p) = third*fa + turn + 8.0*square*c*c;
	}
}

/* scaled [2][width] = H in the plane times the strains a, b of a row; out [width] the stress c. */
HAWSER_PART void scale_in(double *scaled, double *out, const double *row, const struct stiffness *h,
                          int width)
{
	for (int p = 0; p < width; p += BLOCK) {
		int ia = HAWSER__QUARTIC_A(p, width), ib = HAWSER__QUARTIC_B(p, width);
		hawser__vec a = vec(row + ia), b = vec(row + ib);

		*(hawser__vec *)(scaled + ia) = vec(h->aa + p)*a + vec(h->ab + p)*b;
		*(hawser__vec *)(scaled + ib) = vec(h->ab + p)*a + vec(h->bb + p)*b;
		*(hawser__vec *)(out + p) = vec(h->ac + p)*a + vec(h->bc + p)*b;
	}
}

HAWSER_PART void scale_out(double *scaled, const double *row, const struct stiffness *h, int width)
{
	for (int p = 0; p < width; p += BLOCK)
		*(hawser__vec *)(scaled + p) = vec(h->cc + p)*vec(row + p);
}

/* A function that is compiled for several processors calls no other library. */
HAWSER_HOT
static void stiffen_hot(struct stiffness *h, const struct hawser__quartic *q,
                        const struct hawser__quartic_field *at,
                        const struct hawser__quartic_field *along, int both)
{
	stiffen(h, q, at, along, both);
}

HAWSER_HOT
static void scale_rows(double *scaled, double *out, const double *table, int rows,
                       const struct stiffness *h, int width)
{
	for (int r = 0; r < rows; r++)
		scale_in(scaled + (size_t)r*2*(size_t)width, out + (size_t)r*(size_t)width,
		         table + (size_t)r*2*(size_t)width, h, width);
}

HAWSER_HOT
static void scale_rows_out(double *scaled, const double *table, int rows, const struct stiffness *h,
                           int width)
{
	for (int r = 0; r < rows; r++)
		scale_out(scaled + (size_t)r*(size_t)width, table + (size_t)r*(size_t)width, h, width);
}

/* C [m][n], rows `stride` apart, = A [m][k] times B' [k][n] */
static void product(double *C, int stride, const double *A, const double *B, int m, int n, int k)
{
	if (m && n && k)
		cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasTrans, m, n, k, 1.0, A, k, B, k, 0.0, C,
		            stride);
}

static int some(const double *v, int n)
{
	for (int j = 0; j < n; j++)
		if (v[j] != 0.0)
			return 1;
	return 0;
}

/* T [rows_in and rows_out with columns][stride]: Phi'H times the rows of the tables: blocks of rows of
 * both planes against the modes of both. `mixed`: the state is not in the plane. */
static void contract(double *T, int stride, const struct hawser__quartic *q,
                     const struct stiffness *h, int mixed)
{
	int width = q->width, most = ROOM/(3*width), in = q->moving_in, out = q->moving_out;
	double scaled[ROOM], *stress = scaled + (size_t)most*2*(size_t)width;

	for (int first = 0; first < in; first += most) {
		int rows = in - first < most ? in - first : most;

		scale_rows(scaled, stress, q->ab + (size_t)first*2*(size_t)width, rows, h, width);
		product(T + (size_t)first*(size_t)stride, stride, scaled, q->ab, rows, in, 2*width);
		if (mixed)
			product(T + (size_t)first*(size_t)stride + in, stride, stress, q->c, rows, out,
			        width);
	}
	for (int first = 0; first < out; first += most) {
		int rows = out - first < most ? out - first : most;

		scale_rows_out(scaled, q->c + (size_t)first*(size_t)width, rows, h, width);
		product(T + (size_t)(in + first)*(size_t)stride + in, stride, scaled, q->c, rows, out,
		        width);
	}
}

/* --- condensed modes --- */

/* C [m][n], rows `stride` apart, += x [size] times table [size][m][n]. */
static void add_pull(double *C, int stride, const double *table, int step, const double *x, int size,
                     int m, int n)
{
	double sum[HAWSER__QUARTIC_ROWS*HAWSER_ROM_MAX];

	if (!m || !n || !size)
		return;
	cblas_dgemv(CblasRowMajor, CblasTrans, size, m*n, 1.0, table, step, x, 1, 0.0, sum, 1);
	for (int i = 0; i < m; i++)
		memcpy(C + (size_t)i*(size_t)stride, sum + (size_t)i*(size_t)n,
		       (size_t)n*sizeof *sum);
}

/* Y [rows_in + rows_out][modes] at the coordinates v. */
static void set_Y(double *Y, const struct hawser__quartic *q, const double *v, int mixed)
{
	int in = q->moving_in, out = q->moving_out, modes = in + out;
	int step = q->rows_in*in + q->rows_out*out, step_out = q->rows_in*out + q->rows_out*in;
	double *Y_out = Y + (size_t)q->rows_in*(size_t)modes;

	memset(Y, 0, (size_t)(q->rows_in + q->rows_out)*(size_t)modes*sizeof *Y);
	add_pull(Y, modes, q->pull_in, step, v, in, q->rows_in, in);
	add_pull(Y_out + in, modes, q->pull_in + q->rows_in*in, step, v, in, q->rows_out, out);
	if (!mixed)
		return;
	add_pull(Y + in, modes, q->pull_out, step_out, v + q->in, out, q->rows_in, out);
	add_pull(Y_out, modes, q->pull_out + q->rows_in*out, step_out, v + q->in, out, q->rows_out, in);
}

/* T [modes][modes] += Y'B Y. */
static void add_response(double *T, const struct hawser__quartic *q, const double *Y)
{
	double Z[HAWSER__QUARTIC_ROWS*HAWSER_ROM_MAX];
	int modes = q->moving_in + q->moving_out, rows = q->rows_in + q->rows_out;
	size_t split = (size_t)q->rows_in*(size_t)modes;

	cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, q->rows_in, modes, q->rows_in, 1.0,
	            q->bend_in, q->padded_in, Y, modes, 0.0, Z, modes);
	cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, q->rows_out, modes, q->rows_out, 1.0,
	            q->bend_out, q->padded_out, Y + split, modes, 0.0, Z + split, modes);
	cblas_dgemm(CblasRowMajor, CblasTrans, CblasNoTrans, modes, modes, rows, 1.0, Y, modes, Z,
	            modes, 1.0, T, modes);
}

/* Sets of kinds (quartic.h), bit 1 << k for kind k: the kinds of the products of coordinates that are
 * not 0. The second derivative by two coordinates is 0 unless their kinds differ by one of these. */
static unsigned kinds_of(const struct hawser__quartic *q, const double *v)
{
	unsigned kinds = 1;

	for (int j = 0; j < q->n; j++) {
		unsigned more = kinds;

		if (v[j] == 0.0)
			continue;
		for (int k = 0; k < 4; k++)
			if (kinds >> k & 1u)
				more |= 1u << (k ^ q->kind[j]);
		kinds = more;
	}
	return kinds;
}

/* Mode i of the tangent, by plane. */
static int by_plane(const struct hawser__quartic *q, int i)
{
	return i < q->moving_in ? i : q->in + i - q->moving_in;
}

/* Index in the model of mode i of the tangent. */
static int place(const struct hawser__quartic *q, int i)
{
	return q->index[by_plane(q, i)];
}

/* tangent += the second derivatives T by the modes, made symmetric; those that are 0 by symmetry are
 * 0 up to round-off in T. */
static void scatter(double *tangent, const struct hawser__quartic *q, const double *T, unsigned kinds)
{
	int modes = q->moving_in + q->moving_out, n = q->n;

	for (int i = 0; i < modes; i++)
		for (int k = 0; k <= i; k++) {
			double value = 0.5*(T[i*modes + k] + T[k*modes + i]);
			int a = place(q, i), b = place(q, k);

			if (!(kinds >> (q->kind[by_plane(q, i)] ^ q->kind[by_plane(q, k)]) & 1u))
				continue;
			tangent[a*n + b] += value;
			if (a != b)
				tangent[b*n + a] += value;
		}
}

/* Entries of a shape, row r of Y, and the modes. */
static void add_shape(double *tangent, const struct hawser__quartic *q, const double *Y, int shape,
                      int r)
{
	int modes = q->moving_in + q->moving_out, n = q->n;

	for (int i = 0; i < modes; i++) {
		tangent[shape*n + place(q, i)] += Y[r*modes + i];
		tangent[place(q, i)*n + shape] += Y[r*modes + i];
	}
}

static void set_K(double *tangent, const struct hawser__quartic *q)
{
	size_t n = (size_t)q->n;

	if (!q->diagonal) {
		memcpy(tangent, q->K, n*n*sizeof *tangent);
		return;
	}
	memset(tangent, 0, n*n*sizeof *tangent);
	for (size_t j = 0; j < n; j++)
		tangent[j*(n + 1)] = q->K[j];
}

void hawser__quartic_tangent(const struct hawser__quartic *q, double *restoring, double *tangent,
                             const double *u)
{
	double T[HAWSER_ROM_MAX*HAWSER_ROM_MAX], Y[HAWSER__QUARTIC_ROWS*HAWSER_ROM_MAX];
	int in = q->moving_in, modes = in + q->moving_out, mixed;
	struct hawser__quartic_state state;
	struct stiffness h;

	hawser__quartic_strain(q, restoring, &state, u);
	mixed = some(state.v + q->in, q->moving_out);
	stiffen_hot(&h, q, &state.at, q->condensed ? &state.along : NULL, 1);
	memset(T, 0, (size_t)modes*(size_t)modes*sizeof *T);
	contract(T, modes, q, &h, mixed);
	for (int i = 0; mixed && i < in; i++)
		for (int k = in; k < modes; k++)
			T[k*modes + i] = T[i*modes + k];
	if (q->condensed) {
		set_Y(Y, q, state.v, mixed);
		add_response(T, q, Y);
	}
	set_K(tangent, q);
	scatter(tangent, q, T, kinds_of(q, state.v));
	for (int s = in; s < q->in; s++)
		add_shape(tangent, q, Y, q->index[s], s);
	for (int s = q->moving_out; s < q->out; s++)
		add_shape(tangent, q, Y, q->index[q->in + s], q->rows_in + s);
}

/* --- tables --- */

/* Derivatives of third order along row r of a table (in plane or out of it): the block in the plane
 * and the block out of it for a row in the plane, the block between them otherwise. `kind`: of the
 * row. */
static void pull_row(struct hawser__quartic *q, double *T, int r, int out_of_plane, int kind)
{
	int in = q->moving_in, out = q->moving_out, modes = in + out;
	int step = q->rows_in*in + q->rows_out*out, step_out = q->rows_in*out + q->rows_out*in;
	size_t width = (size_t)q->width;
	struct hawser__quartic_field at;
	struct stiffness h;

	memset(&at, 0, sizeof at);
	if (out_of_plane)
		memcpy(at.c, q->c + (size_t)r*width, width*sizeof *at.c);
	else
		memcpy(at.ab, q->ab + (size_t)r*2*width, 2*width*sizeof *at.ab);
	stiffen_hot(&h, q, &at, NULL, 0);
	memset(T, 0, (size_t)modes*(size_t)modes*sizeof *T);
	contract(T, modes, q, &h, out_of_plane);
	for (int i = 0; i < modes*modes; i++) /* 0 by symmetry */
		if ((q->kind[by_plane(q, i/modes)] ^ q->kind[by_plane(q, i%modes)]) != kind)
			T[i] = 0.0;
	for (int s = 0; s < in && !out_of_plane; s++)
		memcpy(q->pull_in + (size_t)s*(size_t)step + (size_t)r*(size_t)in, T + s*modes,
		       (size_t)in*sizeof *T);
	for (int s = 0; s < out && !out_of_plane; s++)
		memcpy(q->pull_out + (size_t)s*(size_t)step_out + (size_t)r*(size_t)out,
		       T + (in + s)*modes + in, (size_t)out*sizeof *T);
	for (int s = 0; s < in && out_of_plane; s++)
		for (int k = 0; k < out; k++) {
			double value = T[s*modes + in + k];

			q->pull_in[s*step + q->rows_in*in + r*out + k] = value;
			q->pull_out[k*step_out + q->rows_in*out + r*in + s] = value;
		}
}

int hawser__quartic_pull(struct hawser__quartic *q)
{
	size_t modes = (size_t)q->moving_in + (size_t)q->moving_out;
	double *T = malloc(modes*modes*sizeof *T);

	if (!T)
		return 1;
	for (int r = 0; r < q->rows_in; r++)
		pull_row(q, T, r, 0, hawser__quartic_kind(q, r, 0));
	for (int r = 0; r < q->rows_out; r++)
		pull_row(q, T, r, 1, hawser__quartic_kind(q, r, 1));
	free(T);
	return 0;
}
