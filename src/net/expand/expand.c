/* net/expand/expand.c - the energy of a net to fourth order in given shapes.
 *
 *   L0, EA, T, g   of an element: unstretched length, stiffness, tension, stretch
 *   a, b, c        components along its tangent and two normals of (difference of its ends)/L0
 *   sigma_jk       b_j b_k + c_j c_k
 *
 * An element is a point of the energy with the weight w = L0: with the strain a to first order,
 *
 *   T_jkl = sum w EA/g^2 [a_j sigma_kl + a_k sigma_jl + a_l sigma_jk]
 *   F_jk  = w EA/g^2 (sigma_jk, a_j b_k + a_k b_j, a_j c_k + a_k c_j): forces on what follows
 *   w_jk  = - K^-1 F_jk + sum_s Phi_s (Phi_s.F_jk)/omega_s^2 over the modes s that are shapes
 *
 * and the part of one way (jk)(lm) to pair four indices in the fourth derivative is
 *
 *   sum w {EA A A' + T/g (b b' + c c')(w) + F (b, c)(w') + F' (b, c)(w)
 *          + EA (g - 1)/g^4 sigma sigma' - 2 EA/g^3 (a_j a_k sigma' + a_l a_m sigma)},
 *   A = a(w) + sigma/g^2
 *
 * with F along the normals alone, per weight. The terms EA sigma sigma' and K of w, which cancel in a
 * nearly inextensible net, are one here. All pairs are the product of two matrices, by blocks of
 * elements.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "core/vec3.h"
#include "net/expand/expand.h"

enum { COLUMNS = 7, BLOCK = 128 }; /* of the matrices by element; elements at once */

void hawser__nexpand_clear(struct hawser__nexpand *t)
{
	hawser__hold_clear(&t->hold);
	*t = (struct hawser__nexpand){.mesh = NULL};
}

/* Tangent, and the normals: the first one in the vertical plane, or along x. */
static double set_axes(double axes[3][3], const struct hawser__mesh *mesh, int e)
{
	double length = hawser__mesh_direction(axes[0], mesh, e), flat = hypot(axes[0][0], axes[0][2]);

	for (int k = 0; k < 3; k++)
		axes[1][k] = flat > 1e-8 ? (k == 1 ? flat : -axes[0][1]*axes[0][k]/flat) : k == 0;
	hawser__cross(axes[2], axes[0], axes[1]);
	return length;
}

static void place(struct hawser__nexpand *t)
{
	const struct hawser__mesh *mesh = t->mesh;

	for (int e = 0; e < mesh->elements; e++) {
		double length = set_axes(t->axes[e], mesh, e);

		t->weight[e] = mesh->EA[e]*mesh->length0[e]/t->energy;
		t->strain[e] = (length - mesh->length0[e])/mesh->length0[e];
	}
}

enum hawser_status hawser__nexpand_open(struct hawser__nexpand *t,
                                        const struct hawser__net_modal *modal, double energy, int n,
                                        int modes, struct hawser_report *report)
{
	const struct hawser__mesh *mesh = &modal->mesh;
	size_t elements = (size_t)mesh->elements, count = (size_t)n, pairs = count*(count + 1)/2;

	*t = (struct hawser__nexpand){.mesh = mesh, .sparse = modal->eigen.sparse, .energy = energy,
		.n = n, .modes = modes, .pairs = (int)pairs};
	t->shape = hawser__hold(&t->hold, count*(size_t)mesh->nodes, sizeof *t->shape);
	t->weight = hawser__hold(&t->hold, elements, sizeof *t->weight);
	t->strain = hawser__hold(&t->hold, elements, sizeof *t->strain);
	t->axes = hawser__hold(&t->hold, elements, sizeof *t->axes);
	t->slope = hawser__hold(&t->hold, count*elements, sizeof *t->slope);
	t->third = hawser__hold(&t->hold, count*count*count, sizeof *t->third);
	t->pairing = hawser__hold(&t->hold, pairs*pairs, sizeof *t->pairing);
	t->second = hawser__hold(&t->hold, pairs*(size_t)mesh->unknowns, sizeof *t->second);
	if (t->hold.short_of_memory)
		return hawser__no_memory(report, "net rom");
	place(t);
	return HAWSER_OK;
}

/* --- slopes --- */

static void turn(double slope[3], const struct hawser__nexpand *t, int element, const double from[3],
                 const double to[3])
{
	for (int k = 0; k < 3; k++) {
		const double *axis = t->axes[element][k];

		slope[k] = (axis[0]*(to[0] - from[0]) + axis[1]*(to[1] - from[1]) +
		            axis[2]*(to[2] - from[2]))/t->mesh->length0[element];
	}
}

void hawser__nexpand_slope(double slope[3], const struct hawser__nexpand *t, int element,
                           const double (*shape)[3])
{
	turn(slope, t, element, shape[t->mesh->end[element][0]], shape[t->mesh->end[element][1]]);
}

void hawser__nexpand_row_slope(double slope[3], const struct hawser__nexpand *t, int element,
                               const double *row)
{
	double from[3], to[3];

	hawser__eigen_place(from, row, t->mesh, t->mesh->end[element][0]);
	hawser__eigen_place(to, row, t->mesh, t->mesh->end[element][1]);
	turn(slope, t, element, from, to);
}

static const double (*slopes_of(const struct hawser__nexpand *t, int shape))[3]
{
	return (const double (*)[3])t->slope + (size_t)shape*(size_t)t->mesh->elements;
}

static double across(const double x[3], const double y[3])
{
	return x[1]*y[1] + x[2]*y[2];
}

/* --- third derivatives --- */

double hawser__nexpand_third(const struct hawser__nexpand *t, int j, int k, const double (*field)[3])
{
	const double (*x)[3] = slopes_of(t, j), (*y)[3] = slopes_of(t, k);
	double sum = 0.0;

	for (int e = 0; e < t->mesh->elements; e++) {
		double g = 1.0 + t->strain[e];

		sum += t->weight[e]/(g*g)*hawser__third_at(x[e], y[e], field[e]);
	}
	return sum;
}

static double third(const void *of, int j, int k, int l)
{
	return hawser__nexpand_third(of, j, k, slopes_of(of, l));
}

/* --- what follows --- */

/* w/g^2 (sigma, a b + b a, a c + c a) of a pair at an element. */
static void force_of(double f[3], const struct hawser__nexpand *t, int e, int j, int k)
{
	double g = 1.0 + t->strain[e];

	hawser__pair_force(f, slopes_of(t, j)[e], slopes_of(t, k)[e]);
	for (int c = 0; c < 3; c++)
		f[c] *= t->weight[e]/(g*g);
}

/* row -= F_jk, N. */
static void push(double *row, const struct hawser__nexpand *t, int j, int k)
{
	const struct hawser__mesh *mesh = t->mesh;

	for (int e = 0; e < mesh->elements; e++) {
		double f[3], scale = t->energy/mesh->length0[e];

		force_of(f, t, e, j, k);
		for (int i = 0; i < 3; i++) {
			const double (*axes)[3] = (const double (*)[3])t->axes[e];
			double force = scale*(f[0]*axes[0][i] + f[1]*axes[1][i] + f[2]*axes[2][i]);
			int from = mesh->unknown[mesh->end[e][0]][i], to = mesh->unknown[mesh->end[e][1]][i];

			if (from >= 0)
				row[from] += force;
			if (to >= 0)
				row[to] -= force;
		}
	}
}

/* Take out the components that the modes have in all w_jk, of which they have none then. */
static enum hawser_status remove_modes(struct hawser__nexpand *t, struct hawser_report *report)
{
	double *part = hawser__numbers((size_t)t->pairs, (size_t)t->modes);
	int unknowns = t->mesh->unknowns;

	if (!part)
		return hawser__no_memory(report, "net rom");
	for (int k = 0; k < t->n; k++)
		for (int i = 0; i < (k + 1)*t->modes; i++) {
			int j = i/t->modes, s = i%t->modes;

			part[hawser__pair(j, k)*t->modes + s] = t->third[(j*t->n + k)*t->n + s]/t->omega2[s];
		}
	if (t->modes > 0)
		cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, t->pairs, unknowns, t->modes, 1.0, part,
		            t->modes, t->mode, unknowns, 1.0, t->second, unknowns);
	free(part);
	return HAWSER_OK;
}

static enum hawser_status follow(struct hawser__nexpand *t, struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	for (int k = 0; k < t->n && !status; k++)
		for (int j = 0; j <= k && !status; j++) {
			double *row = t->second + (size_t)hawser__pair(j, k)*(size_t)t->mesh->unknowns;

			push(row, t, j, k);
			status = hawser__sparse_solve(row, t->sparse, report);
		}
	return status ? status : remove_modes(t, report);
}

/* --- fourth derivatives --- */

/* The columns of an element in the row of a pair. */
static void fill_columns(double left[COLUMNS], double right[COLUMNS], const struct hawser__nexpand *t,
                         int e, int j, int k)
{
	const double *x = slopes_of(t, j)[e], *y = slopes_of(t, k)[e];
	const double *row = t->second + (size_t)hawser__pair(j, k)*(size_t)t->mesh->unknowns;
	double strain = t->strain[e], g = 1.0 + strain, weight = t->weight[e], f[3], w[3];
	double sigma = across(x, y), aa = -2.0*weight/(g*g*g)*x[0]*y[0], A;

	force_of(f, t, e, j, k);
	hawser__nexpand_row_slope(w, t, e, row);
	A = w[0] + sigma/(g*g);
	left[0] = weight*A;
	right[0] = A;
	for (int c = 1; c < 3; c++) {
		left[c] = weight*strain/g*w[c] + f[c];
		right[c] = w[c];
		left[2 + c] = w[c];
		right[2 + c] = f[c];
	}
	left[5] = weight*strain/(g*g*g*g)*sigma + aa;
	right[5] = sigma;
	left[6] = sigma;
	right[6] = aa;
}

/* The stiffness of spring i of the mesh, and its unknown; 0: there is none. What follows does work on
 * springs too, a part of K that no element has. */
static double spring_of(int *unknown, const struct hawser__nexpand *t, int i)
{
	*unknown = t->mesh->unknown[i/3][i%3];
	return *unknown < 0 ? 0.0 : t->mesh->spring[i/3][i%3]/t->energy;
}

double hawser__nexpand_own(const struct hawser__nexpand *t, int j)
{
	const double *row = t->second + (size_t)hawser__pair(j, j)*(size_t)t->mesh->unknowns;
	double left[COLUMNS], right[COLUMNS], sum = 0.0;

	for (int i = 0, unknown; i < 3*t->mesh->nodes; i++) {
		double stiffness = spring_of(&unknown, t, i);

		sum += stiffness > 0.0 ? 3.0*stiffness*row[unknown]*row[unknown] : 0.0;
	}
	for (int e = 0; e < t->mesh->elements; e++) {
		fill_columns(left, right, t, e, j, j);
		for (int c = 0; c < COLUMNS; c++)
			sum += 3.0*left[c]*right[c];
	}
	return sum;
}

enum hawser_status hawser__nexpand_pairs(struct hawser__nexpand *t, struct hawser_report *report)
{
	size_t pairs = (size_t)t->pairs, width = COLUMNS*BLOCK;
	double *left = hawser__numbers(pairs, width), *right = hawser__numbers(pairs, width);
	int elements = t->mesh->elements, good = left && right;

	for (int first = 0; good && first < elements; first += BLOCK) {
		int count = elements - first < BLOCK ? elements - first : BLOCK;

		for (int k = 0; k < t->n; k++)
			for (int j = 0; j <= k; j++) {
				size_t row = (size_t)hawser__pair(j, k)*width;

				for (int e = 0; e < count; e++)
					fill_columns(left + row + (size_t)(COLUMNS*e), right + row + (size_t)(COLUMNS*e),
					             t, first + e, j, k);
			}
		cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasTrans, t->pairs, t->pairs, COLUMNS*count, 1.0,
		            left, (int)width, right, (int)width, 1.0, t->pairing, t->pairs);
	}
	for (int i = 0, unknown; good && i < 3*t->mesh->nodes; i++) {
		double stiffness = spring_of(&unknown, t, i);

		if (stiffness > 0.0)
			cblas_dger(CblasRowMajor, t->pairs, t->pairs, stiffness, t->second + unknown,
			           t->mesh->unknowns, t->second + unknown, t->mesh->unknowns, t->pairing, t->pairs);
	}
	free(left);
	free(right);
	return good ? HAWSER_OK : hawser__no_memory(report, "net rom");
}

enum hawser_status hawser__nexpand_follow(struct hawser__nexpand *t, struct hawser_report *report)
{
	enum hawser_status status;

	for (int j = 0; j < t->n; j++)
		for (int e = 0; e < t->mesh->elements; e++)
			hawser__nexpand_slope(t->slope[(size_t)j*(size_t)t->mesh->elements + (size_t)e], t, e,
			                      (const double (*)[3])t->shape + (size_t)j*(size_t)t->mesh->nodes);
	status = hawser__third_fill(t->third, t->n, third, t, "net rom", report);
	return status ? status : follow(t, report);
}
