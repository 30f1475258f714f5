/* rom/energy/shapes.c - displacement and tension at the shape points from the coordinates.
 *
 *    P, Q, B   mode shape along e, n, z        a, b, c   its derivative in that frame
 *    e = (ex, ey, 0), n = (-ey, ex, 0)         g         static stretch |x'|
 *
 * Under a static load x and y are the axes of the plane in which the cable hangs, and displacements
 * are turned to the global axes.
 *
 * If modes are condensed, the displacement is known to second order, and so is the strain: |q'| - g
 * = a + (b^2 + c^2)/(2g) with the second-order part of a. In a nearly inextensible cable the two
 * large terms cancel. The exact |q'| of such a displacement has terms of third order that nothing
 * cancels; times EA they would be kilonewtons of spurious tension.
 *
 * Given motions of the ends (ends.h) are coordinates of both like those of the model.
 *
 * The strain of a full-order model is that at its quadrature points, interpolated: see exact.c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "modes/grid.h"
#include "rom/terms/ends.h"
#include "rom/energy/exact.h"
#include "rom/energy/kernel.h"
#include "rom/build/model.h"

static void add(double out[3], const double *field, size_t row, int points, int p, double factor)
{
	const double *at = field + (row*points + p)*3;

	for (int i = 0; i < 3; i++)
		out[i] += factor*at[i];
}

/* Number of coordinates that are modes; those behind them are second-order shapes. */
static int modes_of(const struct hawser_rom *rom)
{
	return rom->n - rom->inertia.shapes;
}

/* sum over coordinates of u_j field_j(p). */
static void combine(double out[3], const double *field, int from, int to, int points, int p,
                    const double *u)
{
	for (int j = from; j < to; j++)
		add(out, field, (size_t)j, points, p, u[j]);
}

/* And the sum of 1/2 u_j u_k second_jk(p), from the condensed modes. */
static void combine_second(double out[3], const double *second, int n, int points, int p,
                           const double *u)
{
	for (int k = 0; second && k < n; k++)
		for (int j = 0; j <= k; j++)
			add(out, second, (size_t)k*(k + 1)/2 + j, points, p,
			    j == k ? 0.5*u[j]*u[k] : u[j]*u[k]);
}

/* The factors s of the ends at an instant, or NULL if they do not move. */
static const double *factors(const struct hawser_rom *rom, double s[HAWSER__SUPPORT_MOST],
                             const struct hawser_rom_moment *moment)
{
	if (!rom->ends || !moment)
		return NULL;
	hawser__ends_at(rom, s, moment);
	return s;
}

void hawser__shapes_global(double *xyz, const struct hawser_rom_shapes *shapes, int p,
                           const double local[3])
{
	double ex = shapes->tangent[2*p], ey = shapes->tangent[2*p + 1];
	double in[3] = {local[0]*ex - local[1]*ey, local[0]*ey + local[1]*ex, local[2]};

	for (int i = 0; i < 3; i++)
		xyz[i] = !shapes->turned ? in[i]
		         : shapes->axes[0][i]*in[0] + shapes->axes[1][i]*in[1] + shapes->axes[2][i]*in[2];
}

void hawser_rom_displacement_at(const struct hawser_rom *rom, double *xyz, int p, const double *u,
                                const struct hawser_rom_moment *moment)
{
	double local[3] = {0.0}, factor[HAWSER__SUPPORT_MOST];
	const double *s = factors(rom, factor, moment);
	int points = rom->shapes.points;

	combine(local, rom->shapes.shape, 0, rom->n, points, p, u);
	combine_second(local, rom->shapes.second_shape, modes_of(rom), points, p, u);
	if (moment)
		hawser__rom_answer_shape(rom, local, p, moment, 0);
	if (s && rom->ends->second_shape)
		hawser__ends_second(rom->ends, local, rom->ends->second_shape, points, p, u, s);
	hawser__shapes_global(xyz, &rom->shapes, p, local);
}

void hawser_rom_displacement(const struct hawser_rom *rom, double *xyz, int p, const double *u)
{
	hawser_rom_displacement_at(rom, xyz, p, u, NULL);
}

void hawser_rom_velocity_at(const struct hawser_rom *rom, double *xyz, int p, const double *u,
                            const double *v, const struct hawser_rom_moment *moment)
{
	const double *second = rom->shapes.second_shape;
	int points = rom->shapes.points, modes = modes_of(rom);
	double local[3] = {0.0}, factor[HAWSER__SUPPORT_MOST], rate[HAWSER__SUPPORT_MOST];
	const double *s = factors(rom, factor, moment);

	combine(local, rom->shapes.shape, 0, rom->n, points, p, v);
	for (int k = 0; second && k < modes; k++)
		for (int j = 0; j <= k; j++)
			add(local, second, (size_t)k*(k + 1)/2 + j, points, p,
			    j == k ? u[j]*v[j] : u[j]*v[k] + v[j]*u[k]);
	hawser__rom_answer_shape(rom, local, p, moment, 1);
	if (s && rom->ends->second_shape) {
		hawser__ends_rate(rom, rate, moment);
		hawser__ends_second_rate(rom->ends, local, rom->ends->second_shape, points, p, u, s, v, rate);
	}
	hawser__shapes_global(xyz, &rom->shapes, p, local);
}

/* The arrays of the shape points or of the line. */
struct table {
	int points;
	const double *stretch, *slope, *second, *ends, *ends_second;
};

static struct table table_of(const struct hawser_rom *rom, int line)
{
	const struct hawser_rom_ends *ends = rom->ends;
	const struct hawser_rom_shapes *s = &rom->shapes;
	const struct hawser_rom_line *l = &rom->line;

	if (line)
		return (struct table){.points = l->points, .stretch = l->stretch, .slope = l->slope,
			.second = l->second_slope, .ends = ends ? ends->line : NULL,
			.ends_second = ends ? ends->second_line : NULL};
	return (struct table){.points = s->points, .stretch = s->stretch, .slope = s->slope,
		.second = s->second_slope, .ends = ends ? ends->slope : NULL,
		.ends_second = ends ? ends->second_slope : NULL};
}

/* along[count] of the points from `first`: the strain of second order from the condensed modes. There
 * are more pairs of modes than points: one pair after another, in the order of memory. */
static void add_pairs(double *along, const struct hawser_rom *rom, const struct table *at, int first,
                      int count, const double *u)
{
	int modes = modes_of(rom);

	for (int k = 0; k < modes; k++)
		for (int j = 0; j <= k; j++) {
			const double *row = at->second + (((size_t)k*(k + 1)/2 + j)*at->points + first)*3;
			double factor = j == k ? 0.5*u[j]*u[k] : u[j]*u[k];

			for (int p = 0; factor != 0.0 && p < count; p++)
				along[p] += factor*row[3*p];
		}
}

/* Points whose strains of second order are computed together. */
enum { AT_ONCE = 64 };

/* along[] of the points from `first`, `left` or AT_ONCE of them: the strain of second order. */
static void bend(double *along, const struct hawser_rom *rom, const struct table *at, int first,
                 int left, const double *u)
{
	int count = left < AT_ONCE ? left : AT_ONCE;

	for (int p = 0; p < count; p++) {
		double local[3] = {0.0};

		if (at->second)
			combine(local, at->slope, modes_of(rom), rom->n, at->points, first + p, u);
		along[p] = local[0];
	}
	if (at->second)
		add_pairs(along, rom, at, first, count, u);
}

/* At point p; `extra` is a strain that is not in u, s are the factors of the ends or NULL; `along`
 * is that of bend(). For a travelling cable, stretch and strains are per length of the apparent one,
 * which is 1/(1 - m) of the actual length: EA (|q'|/(1 - m) - 1). */
static double tension(const struct hawser_rom *rom, const struct table *at, int p, const double *u,
                      double extra, const double *s, double along)
{
	double d[3] = {0.0}, more, g = at->stretch[p];
	int modes = modes_of(rom), points = at->points;
	double m = rom->shapes.mach2;

	combine(d, at->slope, 0, modes, points, p, u);
	if (s)
		combine(d, at->ends, 0, rom->ends->count, points, p, s);
	if (at->second) {
		double second[3] = {along};

		if (s && at->ends_second)
			hawser__ends_second(rom->ends, second, at->ends_second, points, p, u, s);
		more = (d[1]*d[1] + d[2]*d[2])/(2.0*g) + second[0];
		return rom->shapes.EA*((g - 1.0) + d[0] + more + extra + m)/(1.0 - m);
	}
	more = d[0]*(2.0*g + d[0]) + d[1]*d[1] + d[2]*d[2]; /* |q'|^2 - g^2, without cancellation */
	return rom->shapes.EA*((g - 1.0) + more/(g + sqrt(g*g + more)) + extra + m)/(1.0 - m);
}

/* Number of quadrature points of a full-order model, at most HAWSER_ROM_MAX; 0 for other models. */
static int collocated(const struct hawser_rom *rom)
{
	return rom->exact && rom->exact->collocated ? rom->exact->points : 0;
}

/* tension[points] at the quadrature points of a full-order model; s: displacements of the supports, or
 * NULL. */
static void exact_tensions(double *tension, const struct hawser_rom *rom, const double *u,
                           const double *s)
{
	double m = rom->shapes.mach2;

	hawser__exact_strain(rom->exact, tension, u, s);
	for (int p = 0; p < rom->exact->points; p++)
		tension[p] = rom->shapes.EA*(tension[p] + m)/(1.0 - m);
}

double hawser_rom_tension_at(const struct hawser_rom *rom, int p, const double *u,
                             const struct hawser_rom_moment *moment)
{
	struct table table = table_of(rom, 0);
	double all[HAWSER_ROM_MAX], here, s[HAWSER__SUPPORT_MOST], extra;

	if (!collocated(rom)) {
		extra = moment && !rom->exact ? hawser__rom_answer_slope(rom, p, moment) : 0.0;
		bend(&here, rom, &table, p, 1, u);
		return tension(rom, &table, p, u, extra, factors(rom, s, moment), here);
	}
	exact_tensions(all, rom, u, factors(rom, s, moment));
	hawser__grid_at(&here, &rom->exact->grid, all, 1, 1, rom->shapes.s[p]);
	return here;
}

double hawser_rom_tension(const struct hawser_rom *rom, int p, const double *u)
{
	return hawser_rom_tension_at(rom, p, u, NULL);
}

int hawser__rom_tension_places(const struct hawser_rom *rom)
{
	if (!(rom->shapes.EA > 0.0))
		return 0;
	if (collocated(rom))
		return rom->exact->points + rom->line.points;
	return rom->line.points ? rom->line.points : rom->shapes.points;
}

/* At the quadrature points of a full-order model and, for other models, at the points of the line. */
static void exact_all(double *all, const struct hawser_rom *rom, const double *u, const double *s)
{
	exact_tensions(all, rom, u, s);
	for (int p = 0; p < rom->line.points; p++)
		hawser__grid_at(all + rom->exact->points + p, &rom->exact->grid, all, 1, 1,
		                rom->line.s[p]);
}

void hawser__rom_tensions_all(const struct hawser_rom *rom, double *all, const double *u,
                              const double *extra)
{
	int places = hawser__rom_tension_places(rom);
	struct table table = table_of(rom, rom->line.points > 0);
	const double *s = extra && rom->ends ? extra + places : NULL;
	double along[AT_ONCE];

	if (places > 0 && collocated(rom)) {
		exact_all(all, rom, u, s);
		return;
	}
	for (int p = 0; p < places; p++) {
		if (p%AT_ONCE == 0)
			bend(along, rom, &table, p, places - p, u);
		all[p] = tension(rom, &table, p, u, extra ? extra[p] : 0.0, s, along[p%AT_ONCE]);
	}
}

int hawser_rom_tensions_at(const struct hawser_rom *rom, double *least, double *most,
                           const double *u, const struct hawser_rom_moment *moment)
{
	int places = hawser__rom_tension_places(rom);
	double all[2*HAWSER_ROM_MAX], here, extra, factor[HAWSER__SUPPORT_MOST], along[AT_ONCE];
	const double *s = factors(rom, factor, moment);
	struct table table = table_of(rom, rom->line.points > 0);

	if (places == 0)
		return 0;
	*least = HUGE_VAL;
	*most = -HUGE_VAL;
	if (collocated(rom))
		exact_all(all, rom, u, s);
	for (int p = 0; p < places; p++) {
		extra = moment && !rom->exact ? hawser__rom_answer_strain(rom, p, moment) : 0.0;
		if (!collocated(rom) && p%AT_ONCE == 0)
			bend(along, rom, &table, p, places - p, u);
		here = collocated(rom) ? all[p] : tension(rom, &table, p, u, extra, s, along[p%AT_ONCE]);
		*least = fmin(*least, here);
		*most = fmax(*most, here);
	}
	return 1;
}

int hawser_rom_tensions(const struct hawser_rom *rom, double *least, double *most, const double *u)
{
	return hawser_rom_tensions_at(rom, least, most, u, NULL);
}
