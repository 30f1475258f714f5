/* modes/complex/gyroscopic.c - modes of a travelling cable: the table of methods, and the code
 * common to all methods for complex modes.
 *
 *   Phi        complex shape P, Q, B in the frame of the steady cable; re and im parts are stored
 *   f, g       local waves running downstream and upstream. With the wave speed c (transverse or
 *              longitudinal) and own = sqrt(c^2 + nu^2), f' = ((own - nu) u' - du/dt)/(2 own) runs
 *              downstream at own + nu, and g' = ((own + nu) u' + du/dt)/(2 own) runs upstream at
 *              own - nu. At the eigenvalue i omega, f = ((own + nu) omega u + i c^2 u')/(2 own
 *              omega) and g = u - f
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "modes/complex/gyroscopic.h"
#include "modes/label.h"

static const struct hawser_modes_method table[] = {
	{"spectral", "converged hp Legendre-Galerkin method, a Hermitian problem",
	 "doc/theory-gyroscopic.md", 1e-10, hawser__gyroscopic_solve},
	{"analytic", "closed forms for constant tension and curvature, with their error",
	 "Bertrand (2022), sections 5.3.3 and 5.3.4, with errata", HUGE_VAL, hawser__gyroscopic_analytic},
	{"fdm-source", "the source's finite differences: unsymmetric, with growth that is not there",
	 "Bertrand (2022), section 5.3.2, with errata", HUGE_VAL, hawser__gyroscopic_fdm},
};
enum { METHODS = sizeof table/sizeof table[0] };

/* The phase is set at the first point whose modulus exceeds this fraction of the largest one. The
 * two halves of a symmetric shape have equal maxima; without the fraction round-off would choose
 * between them. */
static const double nearly = 1.0 - 1e-6;

const struct hawser_modes_method *hawser_complex_modes_method(int index)
{
	return index >= 0 && index < METHODS ? &table[index] : NULL;
}

/* --- norm, phase and shares --- */

/* *cosine and *sine of the phase of component f at the point where its modulus is largest. */
static void phase_of(double *cosine, double *sine, const double *re, const double *im, int points,
                     int f)
{
	double largest = 0.0, size = 0.0;
	int i;

	for (i = 0; i < points; i++)
		largest = fmax(largest, hypot(re[3*i + f], im[3*i + f]));
	for (i = 0; i < points - 1; i++) {
		size = hypot(re[3*i + f], im[3*i + f]);
		if (size >= nearly*largest)
			break;
	}
	size = hypot(re[3*i + f], im[3*i + f]);
	*cosine = re[3*i + f]/size;
	*sine = im[3*i + f]/size;
}

/* Multiplies re + i im by (cosine - i sine)*scale. */
static void turn(double *re, double *im, int values, double cosine, double sine, double scale)
{
	for (int i = 0; i < values; i++) {
		double x = re[i], y = im[i];

		re[i] = scale*(x*cosine + y*sine);
		im[i] = scale*(y*cosine - x*sine);
	}
}

/* Kinetic energy density at one point of the downstream (*with) and the upstream wave (*against),
 * from the real and imaginary displacement and slope [3]. A wave of speed c in the frame of the
 * cable passes the supports of the apparent cable at sqrt(c^2 + nu^2) +- nu. */
static void split(double *with, double *against, const double *x, const double *y, const double *dx,
                  const double *dy, const double *speed2, const struct hawser_mode *mode,
                  double nu)
{
	for (int c = 0; c < 3; c++) {
		double own = sqrt(speed2[c] + nu*nu), omega = mode->omega, growth = mode->re/omega;
		double vx = growth*x[c] - y[c], vy = growth*y[c] + x[c];

		*with += pow((own - nu)/omega*dx[c] - vx, 2.0) + pow((own - nu)/omega*dy[c] - vy, 2.0);
		*against += pow((own + nu)/omega*dx[c] + vx, 2.0) + pow((own + nu)/omega*dy[c] + vy, 2.0);
	}
}

static double downstream_of(const struct hawser_modes *modes,
                            const struct hawser_mode *mode, const double *shape,
                            const double *slope)
{
	const struct hawser_grid *grid = &modes->grid;
	const struct hawser_statics *st = &modes->statics;
	int size = 3*grid->points;
	double with = 0.0, against = 0.0;

	/* divided by omega: the squares of displacements do not overflow, those of velocities may */
	for (int i = 0; i < grid->points; i++) {
		struct hawser_frame_point at = hawser_statics_frame(st, grid->s[i]);
		double across = hypot(1.0, at.u)/(1.0 + at.strain), f = 0.0, g = 0.0;
		const double speed2[3] = {1.0/st->epsilon, across, across};

		split(&f, &g, shape + 3*i, shape + size + 3*i, slope + 3*i, slope + size + 3*i, speed2,
		      mode, st->motion.nu);
		with += grid->weight[i]*f;
		against += grid->weight[i]*g;
	}
	return with/(with + against);
}

double hawser__complex_label(struct hawser_modes *modes, int k)
{
	const struct hawser_grid *grid = &modes->grid;
	struct hawser_mode *mode = modes->mode + k;
	int size = 3*grid->points, f = 0;
	double *shape = modes->shape + (size_t)k*2*(size_t)size;
	double *slope = modes->slope + (size_t)k*2*(size_t)size;
	double share[3] = {0.0}, all, cosine, sine;

	for (int i = 0; i < 2*size; i++)
		share[i%3] += grid->weight[i%size/3]*shape[i]*shape[i];
	all = share[0] + share[1] + share[2];
	for (int c = 1; c < 3; c++)
		if (share[c] > share[f])
			f = c;
	mode->axial_share = share[0]/all;
	mode->normal_share = share[1]/all;
	mode->out_of_plane_share = share[2]/all;
	phase_of(&cosine, &sine, shape, shape + size, grid->points, f);
	turn(shape, shape + size, size, cosine, sine, 1.0/sqrt(all));
	turn(slope, slope + size, size, cosine, sine, 1.0/sqrt(all));
	mode->family = mode->axial_share > 0.5 ? HAWSER_LONGITUDINAL : HAWSER_TRANSVERSE;
	mode->symmetry = HAWSER_MIXED;
	mode->downstream = downstream_of(modes, mode, shape, slope);
	return sqrt(all);
}

/* --- at rest --- */

enum hawser_status hawser__gyroscopic_at_rest(struct hawser_modes *modes,
                                              const struct hawser_statics *st,
                                              const struct hawser_modes_options *options,
                                              const char *method, struct hawser_report *report)
{
	struct hawser_modes_options settled = *options;
	struct hawser_modes resting;
	enum hawser_status status;
	size_t size;

	settled.method = method;
	if (isinf(settled.tolerance))
		settled.tolerance = 0.0; /* the default of the method */
	status = hawser_modes_solve(&resting, st, &settled, report);
	size = 3*(size_t)resting.grid.points;
	if (!status)
		status = hawser__modes_allocate(modes, resting.n, resting.grid.points, report);
	if (!status) {
		for (int k = 0; k < resting.n; k++) {
			modes->mode[k].omega = resting.mode[k].omega;
			modes->mode[k].residual = resting.mode[k].residual;
			modes->mode[k].condition = 1.0;
			modes->mode[k].plane = resting.mode[k].plane;
			memcpy(modes->shape + 2*(size_t)k*size, resting.shape + (size_t)k*size,
			       size*sizeof *modes->shape);
			memcpy(modes->slope + 2*(size_t)k*size, resting.slope + (size_t)k*size,
			       size*sizeof *modes->slope);
		}
		modes->grid = resting.grid;
		resting.grid = (struct hawser_grid){0};
		modes->basis = resting.basis;
	}
	hawser_modes_clear(&resting);
	modes->statics = *st;
	return status ? status : hawser__modes_label(modes, report);
}

/* --- waves --- */

void hawser_complex_modes_waves(const struct hawser_modes *modes, double *downstream,
                                double *upstream, int k, double s)
{
	const struct hawser_statics *st = &modes->statics;
	struct hawser_frame_point at = hawser_statics_frame(st, s);
	double omega = modes->mode[k].omega, nu = st->motion.nu, shape[6], slope[6];
	double across = hypot(1.0, at.u)/(1.0 + at.strain);

	hawser_modes_at(modes, shape, slope, k, s);
	for (int c = 0; c < 3; c++) {
		double c2 = c == 0 ? 1.0/st->epsilon : across, own = sqrt(c2 + nu*nu);

		/* i c^2 u': real and imaginary part */
		double re = -c2*slope[3 + c], im = c2*slope[c];

		downstream[c] = ((own + nu)*omega*shape[c] + re)/(2.0*own*omega);
		downstream[3 + c] = ((own + nu)*omega*shape[3 + c] + im)/(2.0*own*omega);
		upstream[c] = ((own - nu)*omega*shape[c] - re)/(2.0*own*omega);
		upstream[3 + c] = ((own - nu)*omega*shape[3 + c] - im)/(2.0*own*omega);
	}
}
