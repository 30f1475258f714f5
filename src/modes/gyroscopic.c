/* modes/gyroscopic.c - modes of a travelling cable: the table of methods, and the code common to
 * all methods.
 *
 *   Phi        complex shape P, Q, B in the frame of the steady cable; re and im parts are stored
 *   f, g       local waves running downstream and upstream. With the wave speed c (transverse or
 *              longitudinal) and own = sqrt(c^2 + nu^2), f' = ((own - nu) u' - du/dt)/(2 own) runs
 *              downstream at own + nu, and g' = ((own + nu) u' + du/dt)/(2 own) runs upstream at
 *              own - nu. At the eigenvalue i omega, f = ((own + nu) omega u + i c^2 u')/(2 own
 *              omega) and g = u - f
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "modes/grid.h"
#include "modes/gyroscopic.h"
#include "modes/methods.h"

static const struct hawser_complex_modes_method table[] = {
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

const struct hawser_complex_modes_method *hawser_complex_modes_methods(int *count)
{
	*count = METHODS;
	return table;
}

static const struct hawser_complex_modes_method *find(const char *name)
{
	for (int i = 0; i < METHODS; i++)
		if (strcmp(table[i].name, name) == 0)
			return table + i;
	return NULL;
}

/* --- norm, phase and shares --- */

enum hawser_status hawser__complex_allocate(struct hawser_complex_modes *modes, int n, int points,
                                            struct hawser_report *report)
{
	size_t values = (size_t)n*(size_t)points;

	modes->n = n;
	modes->mode = calloc((size_t)n, sizeof *modes->mode);
	modes->shape = calloc(values, 6*sizeof *modes->shape);
	modes->slope = calloc(values, 6*sizeof *modes->slope);
	if (modes->mode && modes->shape && modes->slope)
		return HAWSER_OK;
	return hawser__no_memory(report, "modes");
}

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
                  const double *dy, const double *speed2, const struct hawser_complex_mode *mode,
                  double nu)
{
	for (int c = 0; c < 3; c++) {
		double own = sqrt(speed2[c] + nu*nu), omega = mode->im, growth = mode->re/omega;
		double vx = growth*x[c] - y[c], vy = growth*y[c] + x[c];

		*with += pow((own - nu)/omega*dx[c] - vx, 2.0) + pow((own - nu)/omega*dy[c] - vy, 2.0);
		*against += pow((own + nu)/omega*dx[c] + vx, 2.0) + pow((own + nu)/omega*dy[c] + vy, 2.0);
	}
}

static double downstream_of(const struct hawser_complex_modes *modes,
                            const struct hawser_complex_mode *mode, const double *shape,
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

/* Normalise mode k and compute its shares; returns its norm before. */
static double label(struct hawser_complex_modes *modes, int k)
{
	const struct hawser_grid *grid = &modes->grid;
	struct hawser_complex_mode *mode = modes->mode + k;
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
	mode->downstream = downstream_of(modes, mode, shape, slope);
	return sqrt(all);
}

enum hawser_status hawser__complex_label(struct hawser_complex_modes *modes,
                                         struct hawser_report *report)
{
	int count[2] = {0};

	for (int k = 0; k < modes->n; k++) {
		const struct hawser_complex_mode *mode = modes->mode + k;
		double norm = label(modes, k);

		if (!(norm > 0.0 && isfinite(norm + mode->im + mode->downstream + mode->condition)))
			return hawser__fail(report, HAWSER_ERR_NAN, "modes",
			                    "the shape of mode %d came out as not a number: ask for "
			                    "fewer modes or a smaller basis", k + 1);
		modes->mode[k].place = k + 1;
		modes->mode[k].number = ++count[modes->mode[k].plane];
	}
	return HAWSER_OK;
}

/* --- at rest --- */

enum hawser_status hawser__gyroscopic_at_rest(struct hawser_complex_modes *modes,
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
		status = hawser__complex_allocate(modes, resting.n, resting.grid.points, report);
	if (!status) {
		for (int k = 0; k < resting.n; k++) {
			modes->mode[k].im = resting.mode[k].omega;
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
	return status ? status : hawser__complex_label(modes, report);
}

/* --- the public functions --- */

static enum hawser_status check_errors(const struct hawser_complex_modes *modes,
                                       struct hawser_report *report)
{
	const struct hawser_modes_options solved = {.n = modes->n, .basis = modes->basis,
	                                            .method = modes->method};

	for (int k = 0; k < modes->n; k++)
		if (!(modes->mode[k].residual < 1.0))
			return hawser__modes_unknown(k, modes->mode[k].im/modes->time_unit,
			                             modes->mode[k].plane, modes->mode[k].residual, &solved,
			                             report);
	return HAWSER_OK;
}

enum hawser_status hawser_complex_modes_solve(struct hawser_complex_modes *modes,
                                              const struct hawser_statics *statics,
                                              const struct hawser_modes_options *options,
                                              struct hawser_report *report)
{
	struct hawser_modes_options settled = *options;
	const struct hawser_complex_modes_method *method = find(options->method ? options->method
	                                                                        : table[0].name);
	enum hawser_status status;

	*modes = (struct hawser_complex_modes){0};
	if (!method)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes",
		                    "no method \"%s\" for the modes of a travelling cable: hawser modes "
		                    "--list-methods lists them, the first is \"%s\"", options->method,
		                    table[0].name);
	status = hawser__modes_check_options(options, report);
	if (!status)
		status = hawser__modes_check_statics(statics, report);
	if (!status && !isfinite(statics->motion.nu))
		status = hawser__fail(report, HAWSER_ERR_NAN, "modes",
		                      "the travel speed of the static solution is %g in its own scale: "
		                      "solve the statics first", statics->motion.nu);
	if (status)
		return status;
	if (settled.tolerance == 0.0)
		settled.tolerance = method->tolerance;
	modes->statics = *statics;
	status = method->solve(modes, statics, &settled, report);
	modes->method = method->name;
	modes->time_unit = statics->span.d*sqrt(statics->span.rho/statics->H);
	if (!status && !settled.any_error)
		status = check_errors(modes, report);
	if (status)
		hawser_complex_modes_clear(modes);
	return status;
}

void hawser_complex_modes_at(const struct hawser_complex_modes *modes, double *shape, double *slope,
                             int k, double s)
{
	size_t size = 3*(size_t)modes->grid.points, first = (size_t)k*2*size;

	for (int part = 0; part < 2; part++, first += size) {
		hawser__grid_at(shape + 3*part, &modes->grid, modes->shape + first, 3, 3, s);
		if (slope)
			hawser__grid_at(slope + 3*part, &modes->grid, modes->slope + first, 3, 3, s);
	}
}

void hawser_complex_modes_waves(const struct hawser_complex_modes *modes, double *downstream,
                                double *upstream, int k, double s)
{
	const struct hawser_statics *st = &modes->statics;
	struct hawser_frame_point at = hawser_statics_frame(st, s);
	double omega = modes->mode[k].im, nu = st->motion.nu, shape[6], slope[6];
	double across = hypot(1.0, at.u)/(1.0 + at.strain);

	hawser_complex_modes_at(modes, shape, slope, k, s);
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

void hawser_complex_modes_clear(struct hawser_complex_modes *modes)
{
	if (!modes)
		return;
	hawser__grid_clear(&modes->grid);
	free(modes->mode);
	free(modes->shape);
	free(modes->slope);
	*modes = (struct hawser_complex_modes){0};
}
