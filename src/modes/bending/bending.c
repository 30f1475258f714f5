/* modes/bending/bending.c - what bending stiffness makes of modes: changes of curvature and end
 * moments.
 *
 *   phi      rotation of the tangent, b/(1 + strain) in the plane and c/(1 + strain) out of it
 *   phi'     change of curvature, by the unstretched arclength; the moment is EI phi'
 *
 * phi is a polynomial in each element. It is differentiated by its Legendre expansion,
 * phi = sum c_j P_j, c_j = (2j+1)/2 sum_i w_i phi_i P_j(x_i), with P_j' = (2j-1) P_(j-1) + P_(j-2)'.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include "core/report.h"
#include "modes/bending/bending.h"

/* c[m] of the derivative of phi at the nodes, value[m]. Sums from above: c'_(j-1) = c'_(j+1) +
 * (2j - 1) c_j with c' over 2j - 1. */
static void differentiate(double *c, const double *value, const struct hawser__reference *reference)
{
	int m = reference->order, top = m/2 + 1;

	for (int j = 0; j < m; j++) {
		c[j] = 0.0;
		for (int i = 0; j <= top && i < m; i++)
			c[j] += (j + 0.5)*reference->weight[i]*value[i]*reference->legendre[j*m + i];
	}
	for (int j = 0; j < m; j++) {
		double sum = 0.0;

		for (int k = j + 1; k <= top && k < m; k += 2)
			sum += c[k];
		c[j] = (2*j + 1)*sum;
	}
}

/* Both rotations in element e. */
static void of_element(double *curvature, double *ends, double *work, const struct hawser_statics *st,
                       const struct hawser_grid *grid, const struct hawser__reference *reference,
                       const double *strain, int e)
{
	int m = grid->order;
	double *phi = work, *c = work + m, h = reference->half[e];

	for (int f = 0; f < 2; f++) {
		double left = 0.0, right = 0.0;

		for (int i = 0; i < m; i++)
			phi[i] = strain[3*(e*m + i) + 1 + f]/
			         (1.0 + hawser_statics_frame(st, grid->s[e*m + i]).strain);
		differentiate(c, phi, reference);
		for (int i = 0; i < m; i++) {
			double sum = 0.0;

			for (int j = 0; j < m; j++)
				sum += c[j]*reference->legendre[j*m + i];
			curvature[2*(e*m + i) + f] = sum/h;
		}
		for (int j = 0; j < m; j++) {
			left += j%2 ? -c[j] : c[j];
			right += c[j];
		}
		if (ends && e == 0)
			ends[f] = left/h;
		if (ends && e == grid->elements - 1)
			ends[2 + f] = right/h;
	}
}

enum hawser_status hawser__curvature(double *curvature, double *ends, const struct hawser_statics *st,
                                     const struct hawser_grid *grid, const double *strain,
                                     struct hawser_report *report)
{
	struct hawser__reference reference;
	enum hawser_status status = hawser__reference_init(&reference, grid, grid->order - 1, report);
	double *work;

	if (status)
		return status;
	work = malloc(2*(size_t)grid->order*sizeof *work);
	for (int e = 0; work && e < grid->elements; e++)
		of_element(curvature, ends, work, st, grid, &reference, strain, e);
	if (!work)
		status = hawser__no_memory(report, "modes");
	free(work);
	hawser__reference_clear(&reference);
	return status;
}

static double size_at(const struct hawser_modes *modes, int k, double s)
{
	double u[3];

	hawser_modes_at(modes, u, NULL, k, s);
	return hypot(hypot(u[0], u[1]), u[2]);
}

/* The largest displacement: by golden section between the neighbours of the largest node. */
static double largest(const struct hawser_modes *modes, int k)
{
	const struct hawser_grid *grid = &modes->grid;
	const double *shape = modes->shape + (size_t)k*3*(size_t)grid->points, golden = 0.6180339887498949;
	double best = 0.0, low, high, a, b, fa, fb;
	int at = 0;

	for (int i = 0; i < grid->points; i++) {
		double size = hypot(hypot(shape[3*i], shape[3*i + 1]), shape[3*i + 2]);

		if (size > best) {
			best = size;
			at = i;
		}
	}
	low = at > 0 ? grid->s[at - 1] : 0.0;
	high = at + 1 < grid->points ? grid->s[at + 1] : modes->statics.l;
	a = high - golden*(high - low);
	b = low + golden*(high - low);
	fa = size_at(modes, k, a);
	fb = size_at(modes, k, b);
	for (int i = 0; i < 40; i++) {
		best = fmax(best, fmax(fa, fb));
		if (fa > fb) {
			high = b;
			b = a;
			fb = fa;
			a = high - golden*(high - low);
			fa = size_at(modes, k, a);
		} else {
			low = a;
			a = b;
			fa = fb;
			b = low + golden*(high - low);
			fb = size_at(modes, k, b);
		}
	}
	return best;
}

/* N m per m of the largest displacement: EI/d^2 phi'/displacement, both scaled by the same factor. */
enum hawser_status hawser__modes_moments(struct hawser_modes *modes, struct hawser_report *report)
{
	const struct hawser_statics *st = &modes->statics;
	size_t points = (size_t)modes->grid.points;
	double *curvature = malloc(2*points*sizeof *curvature), ends[4] = {0.0};
	enum hawser_status status = curvature ? HAWSER_OK : hawser__no_memory(report, "modes");

	for (int k = 0; !status && k < modes->n; k++) {
		struct hawser_mode *mode = &modes->mode[k];
		int f = mode->plane == HAWSER_OUT_OF_PLANE;
		double factor = st->bending.EI/(st->span.d*st->span.d*largest(modes, k));

		status = hawser__curvature(curvature, ends, st, &modes->grid,
		                           modes->slope + (size_t)k*3*points, report);
		for (int end = 0; end < 2; end++)
			mode->moment[end] = st->bending.rotation[end] > 0.0 ? factor*ends[2*end + f] : 0.0;
	}
	free(curvature);
	return status;
}
