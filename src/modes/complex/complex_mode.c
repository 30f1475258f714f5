/* modes/complex/complex_mode.c - refinement and error bound of one mode of a travelling cable, by
 * the exact operator.
 *
 *   q0, q1     the last two of the iterates q1 = K^-1(omega^2 q0 - i omega B q0)
 *   A          matrix of the first-order system x' = A x of the state x = (q, p), p = q'
 *   T          i A^-1, Hermitian in the inner product of the energy
 *   mu         1/omega
 *
 * The iteration q1 = -i omega K^-1(p + B q), p = i omega q0, is x -> i omega A^-1 x. One step
 * reduces the component in mode k by the factor omega/omega_k. For any unit x and any real mu, an
 * eigenvalue 1/omega_k of T lies within |T x - mu x| of mu (Weinstein).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <math.h>
#include <string.h>

#include "modes/spectral.h"
#include "modes/complex/gyroscopic.h"

void hawser__complex_init(struct hawser__complex *t, const struct hawser__cable *cable, int plane,
                          double nu, double *work)
{
	int D = cable->plane[plane].D, rows = D*cable->grid.points;

	*t = (struct hawser__complex){.cable = cable, .plane = plane, .D = D, .rows = rows, .nu = nu};
	t->x = work;
	t->gradient = work + 2*rows;
	t->strain = work + 4*rows;
	t->before = work + 6*rows;
	t->x0 = work + 8*rows;
	t->strain0 = work + 10*rows;
	t->scratch = work + 12*rows;
}

/* Rotate one part of a field, [points][3], into the fixed frame: out [D][points]. */
static void rotate(double *out, const double *in, const struct hawser__complex *t)
{
	int points = t->cable->grid.points;
	const double *cosine = t->cable->field, *sine = cosine + points;

	for (int i = 0; i < points; i++) {
		if (t->D == 1) {
			out[i] = in[3*i + 2];
			continue;
		}
		out[i] = cosine[i]*in[3*i] - sine[i]*in[3*i + 1];
		out[points + i] = sine[i]*in[3*i] + cosine[i]*in[3*i + 1];
	}
}

void hawser__complex_load(struct hawser__complex *t, const double *shape, const double *slope)
{
	int size = 3*t->cable->grid.points;

	for (int part = 0; part < 2; part++) {
		rotate(t->x + part*t->rows, shape + part*size, t);
		rotate(t->gradient + part*t->rows, slope + part*size, t);
	}
}

void hawser__complex_store(const struct hawser__complex *t, double *shape, double *slope)
{
	int size = 3*t->cable->grid.points;

	for (int part = 0; part < 2; part++)
		hawser__cable_fields(shape + part*size, slope + part*size, t->cable, t->plane,
		                     t->strain + part*t->rows, t->x + part*t->rows);
}

/* Compute `gradient` from `strain`. */
static void differentiate(struct hawser__complex *t)
{
	const double *direction = t->cable->plane[t->plane].direction;
	int D = t->D, points = t->cable->grid.points;

	memset(t->gradient, 0, 2*(size_t)t->rows*sizeof *t->gradient);
	for (int part = 0; part < 2; part++)
		for (int k = 0; k < D; k++)
			for (int c = 0; c < D; c++)
				for (int i = 0; i < points; i++)
					t->gradient[part*t->rows + c*points + i] +=
						direction[(k*D + c)*points + i]
						*t->strain[part*t->rows + k*points + i];
}

/* Real part of the integral of conj(a) b; *imaginary receives the imaginary part unless it is
 * NULL. */
static double product(double *imaginary, const struct hawser__complex *t, const double *a,
                      const double *b)
{
	const struct hawser_grid *grid = &t->cable->grid;
	int rows = t->rows, D = t->D;

	if (imaginary)
		*imaginary = hawser__compliance_product(a, b + rows, D, grid)
		             - hawser__compliance_product(a + rows, b, D, grid);
	return hawser__compliance_product(a, b, D, grid)
	       + hawser__compliance_product(a + rows, b + rows, D, grid);
}

/* x := K^-1(omega^2 before - 2 i nu omega x') with x' in gradient; `before` may be x. */
static void respond(struct hawser__complex *t, const double *before)
{
	const struct hawser__cable *cable = t->cable;
	double square = t->omega*t->omega, c = 2.0*t->nu*t->omega;
	int rows = t->rows;

	for (int i = 0; i < rows; i++) {
		t->x[i] = square*before[i] + c*t->gradient[rows + i];
		t->x[rows + i] = square*before[rows + i] - c*t->gradient[i];
	}
	for (int part = 0; part < 2; part++)
		hawser__compliance_apply(t->x + part*rows, t->strain + part*rows, 1.0,
		                         &cable->plane[t->plane], &cable->grid, &cable->reference,
		                         t->scratch);
	differentiate(t);
}

static void rayleigh(struct hawser__complex *t)
{
	double m = product(NULL, t, t->x, t->x), k = product(NULL, t, t->strain, t->strain);
	double d = product(NULL, t, t->gradient, t->gradient), g, root, omega;

	product(&g, t, t->x, t->gradient);
	g *= 2.0*t->nu;
	root = sqrt(g*g + 4.0*m*k);
	omega = g > 0.0 ? 2.0*k/(g + root) : (root - g)/(2.0*m);
	t->condition = (k + 2.0*fabs(t->nu)*omega*sqrt(m*d) + omega*omega*m)/(k + omega*omega*m);
	t->omega = omega;
}

void hawser__complex_step(struct hawser__complex *t)
{
	respond(t, t->x);
	rayleigh(t);
}

/* Squared norm of a - factor*b. */
static double apart(const struct hawser__complex *t, const double *a, const double *b,
                    double factor)
{
	const struct hawser_grid *grid = &t->cable->grid;
	double sum = 0.0;

	for (int i = 0; i < 2*t->rows; i++) {
		double difference = a[i] - factor*b[i];

		sum += grid->weight[i%grid->points]*difference*difference;
	}
	return sum;
}

/* Weinstein's bound of the relative error of omega, from the state (x0, i omega before) and its
 * image under omega T, (x, i omega x0). */
static double bound(const struct hawser__complex *t)
{
	double o2 = t->omega*t->omega;
	double norm = product(NULL, t, t->strain0, t->strain0)
	              + o2*product(NULL, t, t->before, t->before);
	double mu = (product(NULL, t, t->strain0, t->strain)
	             + o2*product(NULL, t, t->before, t->x0))/norm;
	double lost = sqrt((apart(t, t->strain, t->strain0, mu)
	                    + o2*apart(t, t->x0, t->before, mu))/norm);

	return fmax(fabs(mu - lost - 1.0), fabs(mu + lost - 1.0)); /* omega/omega_k is between */
}

double hawser__complex_bound(struct hawser__complex *t, int steps)
{
	int rows = 2*t->rows;
	double best = HUGE_VAL;

	cblas_dcopy(rows, t->x, 1, t->x0, 1);
	respond(t, t->x);
	for (int step = 0; step < steps; step++) {
		cblas_dcopy(rows, t->x0, 1, t->before, 1);
		cblas_dcopy(rows, t->x, 1, t->x0, 1);
		cblas_dcopy(rows, t->strain, 1, t->strain0, 1);
		respond(t, t->before);
		best = fmin(best, bound(t));
	}
	return best + hawser__spectral_round_off(t->cable->grid.elements + 1);
}
