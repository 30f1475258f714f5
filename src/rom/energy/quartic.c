/* rom/energy/quartic.c - restoring force and energy of the expanded strain energy, from strains.
 *
 *    a, b, c     strains of the modes that are kept, sums of u_j a_j, ...; sigma = b^2 + c^2
 *    g, eps, k   static stretch, H/EA, geometric stiffness (condense.c)
 *    phi         density of D V3(u)[.]: (sigma/2, a b, a c) w/(g^2 eps), w the weight of the point
 *    M           stiffness of the points: w (1/eps, k, k)
 *    C           unit end forces as forces on the strains (condense.c); T = C'M^-1 C
 *    U           strains of all coordinates, and M^-1 C: one column for each row of quartic.h
 *    y           U'phi: the quadratic force on each coordinate, and the motion of the ends that the
 *                constraint prevents
 *
 * The tensors of project.c are the derivatives of
 *
 *    V = u'K u/2 + sum over points [phi.(a,b,c)/3 + (sigma^2/8 - a^2 sigma/2) w/(g^3 eps)]
 *        + sum over shapes s of u_s y_s - (displacement of condensed modes)'M(...)/2
 *
 * The strains of the condensed modes are -P phi with P = M^-1 - U E U', E = diag(1/omega^2, T^-1).
 * Their energy phi'P M P phi/2 is, with G = U'M U, a sum over points and a quadratic form of y:
 *
 *    phi'M^-1 phi/2 - y'B y/2,    B = 2 E - E G E
 *
 * (G is the inverse of E up to quadrature and the error of the modes; the tensors have it too.) In
 * the sum over points, phi'M^-1 phi/2 cancels nearly all of sigma^2/(8 eps). The difference is
 *
 *    sum over points of  sigma^2 w (g - 1)/(8 g^4 eps) - a^2 sigma w/(2 g^3 eps) (1 + 1/(g k eps))
 *
 * The force on a mode is y_j + U_j'(stress), where the stress is the derivative of that sum, and of
 * phi along the strains U d, d = B y + u (shapes only). Each evaluation is two passes over the table of
 * strains, or four if modes are condensed, so its cost grows as points times n; that of the tensors
 * grows as n^4.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <string.h>

#include "core/hot.h"
#include "rom/energy/quartic.h"

enum { BLOCK = HAWSER_BLOCK };

/* sum [vecs] = values of the columns `x` of table [count][width], from a column on. */
HAWSER_PART void mix_block(double *field, const double *table, const double *x, int count, int width,
                           const int vecs)
{
	hawser__vec sum[8], zero = {0.0};

	HAWSER_UNROLL
	for (int v = 0; v < vecs; v++)
		sum[v] = zero;
	for (int j = 0; j < count; j++) {
		const hawser__vec *row = (const hawser__vec *)(table + (size_t)j*(size_t)width);

		HAWSER_UNROLL
		for (int v = 0; v < vecs; v++)
			sum[v] += x[j]*row[v];
	}
	HAWSER_UNROLL
	for (int v = 0; v < vecs; v++)
		((hawser__vec *)field)[v] = sum[v];
}

/* field [width] = sum of x[j] times row j of table [count][width]. */
HAWSER_PART void mix(double *field, const double *table, const double *x, int count, int width)
{
	int p = 0;

	for (; p + 8*BLOCK <= width; p += 8*BLOCK)
		mix_block(field + p, table + p, x, count, width, 8);
	for (; p + 4*BLOCK <= width; p += 4*BLOCK)
		mix_block(field + p, table + p, x, count, width, 4);
	for (; p < width; p += 2*BLOCK)
		mix_block(field + p, table + p, x, count, width, 2);
}

HAWSER_PART double total(hawser__vec sum)
{
	return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

/* x[j] = row j of table [count][width] times field [width]. The halves of a row are summed separately
 * and in the same order: if they cancel by symmetry, the result is exactly 0 (quartic_make.c). */
HAWSER_PART void project(double *x, const double *table, const double *field, int count, int width)
{
	const hawser__vec *f = (const hawser__vec *)field, zero = {0.0};
	int vecs = width/BLOCK, half = vecs/2, j = 0;

	for (; j + 2 <= count; j += 2) {
		const hawser__vec *one = (const hawser__vec *)(table + (size_t)j*(size_t)width);
		const hawser__vec *two = one + vecs;
		hawser__vec left = zero, right = zero, left_two = zero, right_two = zero;

		for (int v = 0; v < half; v++) {
			left += one[v]*f[v];
			right += one[half + v]*f[half + v];
			left_two += two[v]*f[v];
			right_two += two[half + v]*f[half + v];
		}
		x[j] = total(left + right);
		x[j + 1] = total(left_two + right_two);
	}
	if (j < count) {
		const hawser__vec *one = (const hawser__vec *)(table + (size_t)j*(size_t)width);
		hawser__vec left = zero, right = zero;

		for (int v = 0; v < half; v++) {
			left += one[v]*f[v];
			right += one[half + v]*f[half + v];
		}
		x[j] = total(left + right);
	}
}

/* phi (`force`) at all points for strains `at`. */
HAWSER_PART void third_order(struct hawser__quartic_field *force, const struct hawser__quartic *q,
                             const struct hawser__quartic_field *at)
{
	int width = q->width;

	for (int p = 0; p < width; p += BLOCK) {
		int ia = HAWSER__QUARTIC_A(p, width), ib = HAWSER__QUARTIC_B(p, width);
		hawser__vec a = *(const hawser__vec *)(at->ab + ia);
		hawser__vec b = *(const hawser__vec *)(at->ab + ib);
		hawser__vec c = *(const hawser__vec *)(at->c + p);
		hawser__vec third = *(const hawser__vec *)(q->third + p);

		*(hawser__vec *)(force->ab + ia) = third*(b*b + c*c)*0.5;
		*(hawser__vec *)(force->ab + ib) = third*a*b;
		*(hawser__vec *)(force->c + p) = third*a*c;
	}
}

/* Adds the stress of fourth order, and of third order along the strains `along`, to `force`. */
HAWSER_PART void fourth_order(struct hawser__quartic_field *force, const struct hawser__quartic *q,
                              const struct hawser__quartic_field *at,
                              const struct hawser__quartic_field *along)
{
	int width = q->width;

	for (int p = 0; p < width; p += BLOCK) {
		int ia = HAWSER__QUARTIC_A(p, width), ib = HAWSER__QUARTIC_B(p, width);
		hawser__vec a = *(const hawser__vec *)(at->ab + ia);
		hawser__vec b = *(const hawser__vec *)(at->ab + ib);
		hawser__vec c = *(const hawser__vec *)(at->c + p);
		hawser__vec square = *(const hawser__vec *)(q->square + p);
		hawser__vec mixed = *(const hawser__vec *)(q->mixed + p), sigma = b*b + c*c;
		hawser__vec turn = 4.0*square*sigma - 2.0*mixed*a*a;
		hawser__vec fa = -2.0*mixed*a*sigma, fb = turn*b, fc = turn*c;

		if (along) {
			hawser__vec third = *(const hawser__vec *)(q->third + p);
			hawser__vec da = *(const hawser__vec *)(along->ab + ia);
			hawser__vec db = *(const hawser__vec *)(along->ab + ib);
			hawser__vec dc = *(const hawser__vec *)(along->c + p);

			*(hawser__vec *)(force->ab + ia) = fa + third*(b*db + c*dc);
			*(hawser__vec *)(force->ab + ib) = fb + third*(b*da + a*db);
			*(hawser__vec *)(force->c + p) = fc + third*(c*da + a*dc);
		} else {
			*(hawser__vec *)(force->ab + ia) += fa;
			*(hawser__vec *)(force->ab + ib) += fb;
			*(hawser__vec *)(force->c + p) += fc;
		}
	}
}

/* d [rows] = B y, B [rows][padded] symmetric, plus the coordinates v of the shapes. */
HAWSER_PART void deflect(double *d, const double *B, const double *y, int rows, int padded,
                         const double *v, int moving, int coordinates)
{
	mix(d, B, y, rows, padded);
	for (int r = moving; r < coordinates; r++)
		d[r] += v[r];
}

/* Coordinates v by plane, their strains, and phi at the points. */
HAWSER_PART void begin(double *v, struct hawser__quartic_field *at, struct hawser__quartic_field *force,
                       const struct hawser__quartic *q, const double *u)
{
	for (int j = 0; j < q->n; j++)
		v[j] = u[q->index[j]];
	mix(at->ab, q->ab, v, q->moving_in, 2*q->width);
	mix(at->c, q->c, v + q->in, q->moving_out, q->width);
	third_order(force, q, at);
}

/* restoring = K u */
HAWSER_PART void stiffness(double *restoring, const struct hawser__quartic *q, const double *u)
{
	int n = q->n;

	for (int j = 0; j < n; j++) {
		double sum = 0.0;

		if (q->diagonal) {
			restoring[j] = q->K[j]*u[j];
			continue;
		}
		for (int k = 0; k < n; k++)
			sum += q->K[j*n + k]*u[k];
		restoring[j] = sum;
	}
}

/* y [rows] and d [rows] of both planes; the quadratic force y is added to `restoring`. */
HAWSER_PART void respond(double *d, double *d_out, double *restoring,
                         const struct hawser__quartic *q,
                         const struct hawser__quartic_field *force, const double *v)
{
	double y[HAWSER__QUARTIC_ROWS], y_out[HAWSER__QUARTIC_ROWS];

	project(y, q->ab, force->ab, q->rows_in, 2*q->width);
	project(y_out, q->c, force->c, q->rows_out, q->width);
	for (int j = 0; j < q->in; j++)
		restoring[q->index[j]] += y[j];
	for (int j = 0; j < q->out; j++)
		restoring[q->index[q->in + j]] += y_out[j];
	deflect(d, q->bend_in, y, q->rows_in, q->padded_in, v, q->moving_in, q->in);
	deflect(d_out, q->bend_out, y_out, q->rows_out, q->padded_out, v + q->in, q->moving_out,
	        q->out);
}

HAWSER_PART void evaluate(const struct hawser__quartic *q, double *restoring,
                          struct hawser__quartic_state *state, const double *u)
{
	struct hawser__quartic_field force;
	double d[HAWSER__QUARTIC_ROWS], d_out[HAWSER__QUARTIC_ROWS];

	begin(state->v, &state->at, &force, q, u);
	stiffness(restoring, q, u);
	if (q->condensed) {
		respond(d, d_out, restoring, q, &force, state->v);
		mix(state->along.ab, q->ab, d, q->rows_in, 2*q->width);
		mix(state->along.c, q->c, d_out, q->rows_out, q->width);
		fourth_order(&force, q, &state->at, &state->along);
	} else {
		fourth_order(&force, q, &state->at, NULL);
	}
	project(d, q->ab, force.ab, q->moving_in, 2*q->width);
	project(d_out, q->c, force.c, q->moving_out, q->width);
	for (int j = 0; j < q->moving_in; j++)
		restoring[q->index[j]] += d[j];
	for (int j = 0; j < q->moving_out; j++)
		restoring[q->index[q->in + j]] += d_out[j];
}

HAWSER_HOT
static void evaluate_hot(const struct hawser__quartic *q, double *restoring,
                         struct hawser__quartic_state *state, const double *u)
{
	evaluate(q, restoring, state, u);
}

/* A function that is compiled for several processors cannot be called from other files (kernel.c). */
void hawser__quartic_strain(const struct hawser__quartic *q, double *restoring,
                            struct hawser__quartic_state *state, const double *u)
{
	evaluate_hot(q, restoring, state, u);
}

void hawser__quartic_force(const struct hawser__quartic *q, double *restoring, const double *u)
{
	struct hawser__quartic_state state;

	evaluate_hot(q, restoring, &state, u);
}

/* Half of y'B y of a plane, and u y of its shapes. */
HAWSER_PART double response_energy(const double *y, const double *B, int rows, int padded,
                                   const double *v, int moving, int coordinates)
{
	double d[HAWSER__QUARTIC_ROWS], sum = 0.0;

	mix(d, B, y, rows, padded);
	for (int r = 0; r < rows; r++)
		sum += 0.5*y[r]*d[r];
	for (int r = moving; r < coordinates; r++)
		sum += v[r]*y[r];
	return sum;
}

HAWSER_HOT
static double potential(const struct hawser__quartic *q, const double *u)
{
	struct hawser__quartic_field at, force;
	double v[HAWSER__QUARTIC_ROWS], y[HAWSER__QUARTIC_ROWS], sum = 0.0;

	begin(v, &at, &force, q, u);
	stiffness(y, q, u);
	for (int j = 0; j < q->n; j++)
		sum += 0.5*y[j]*u[j];
	for (int p = 0; p < q->width; p++) {
		int ia = HAWSER__QUARTIC_A(p, q->width), ib = HAWSER__QUARTIC_B(p, q->width);
		double a = at.ab[ia], b = at.ab[ib], c = at.c[p], sigma = b*b + c*c;

		sum += force.ab[ia]*a + (q->square[p]*sigma - q->mixed[p]*a*a)*sigma;
	}
	if (!q->condensed)
		return sum;
	project(y, q->ab, force.ab, q->rows_in, 2*q->width);
	sum += response_energy(y, q->bend_in, q->rows_in, q->padded_in, v, q->moving_in, q->in);
	project(y, q->c, force.c, q->rows_out, q->width);
	return sum + response_energy(y, q->bend_out, q->rows_out, q->padded_out, v + q->in,
	                             q->moving_out, q->out);
}

double hawser__quartic_potential(const struct hawser__quartic *q, const double *u)
{
	return potential(q, u);
}
