/* water/morison.c - loads of the water on a piece of a line and on a sphere, and their derivatives.
 *
 * part   of an element that is wet, at an end (water/water.h)
 * t, P   direction of the element; 1 - t t'
 * z      du - a; the added mass is m*(cn*(a - t t.a) + ct*t t.a) with the mass m of the water
 *
 * Morison's equation: the load of an end is part*(buoyancy + drag + m*du + added mass*(du - a)),
 * with the flow at the end and the direction of the element.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <float.h>
#include <math.h>
#include <string.h>

#include <hawser/drag.h>

#include "core/hot.h"
#include "core/vec3.h"
#include "water/line.h"
#include "water/morison.h"
#include "water/water.h"

/* Per length: added mass, its load and that of the water's own acceleration, and, unless NULL, the
 * derivative by d, whose direction is t. */
HAWSER_PART void inertia(double f[3], double (*f_d)[3], double (*mass)[3], double m,
                         const struct hawser_water_line *line, const double t[3], double inverse,
                         const struct hawser__water_past *past)
{
	const double across = m*line->added_normal, more = m*line->added_tangential - across;
	const double z[3] = {past->du[0] - past->a[0], past->du[1] - past->a[1], past->du[2] - past->a[2]};
	const double along = hawser__dot(t, z);

	HAWSER_UNROLL
	for (int i = 0; i < 3; i++) {
		f[i] += m*past->du[i] + across*z[i] + more*along*t[i];
		HAWSER_UNROLL
		for (int j = 0; j < 3; j++) {
			mass[i][j] = (i == j ? across : 0.0) + more*t[i]*t[j];
			/* dt = P dd/l: t.z changes by (z - along*t).dd/l */
			if (f_d)
				f_d[i][j] += more*inverse*(along*((i == j) - t[i]*t[j]) + t[i]*(z[j] - along*t[j]));
		}
	}
}

/* An end of which this length is wet; direction t of an element of the length 1/inverse. */
HAWSER_PART void end_of(struct hawser__water_end *end, double part, const double by[2], double L,
                        const struct hawser_drag *drag, const struct hawser_water_line *line,
                        const double t[3], double inverse, double g,
                        const struct hawser__water_past *past, int slopes)
{
	const double m = drag->density*M_PI*drag->radius*drag->radius;
	double f[3];

	hawser__drag_line(f, slopes ? end->by_r : NULL, slopes ? end->by_d : NULL, drag, past->r, t,
	                  inverse);
	HAWSER_UNROLL
	for (int k = 0; k < 3; k++)
		end->drag[k] = part*f[k];
	f[1] += m*g;
	inertia(f, slopes ? end->by_d : NULL, end->mass, m, line, t, inverse, past);
	HAWSER_UNROLL
	for (int k = 0; k < 3; k++) {
		end->load[k] = part*f[k];
		HAWSER_UNROLL
		for (int j = 0; j < 3; j++) {
			end->mass[k][j] *= part;
			if (slopes) {
				end->by_r[k][j] *= part;
				end->by_d[k][j] *= part;
			}
		}
	}
	for (int j = 0; j < 2; j++) {
		end->spring[j] = L*by[j]*m*g;
		for (int k = 0; k < 3; k++)
			end->by_y[j][k] = L*by[j]*f[k];
	}
}

HAWSER_HOT
void hawser__morison_ends(struct hawser__water_end end[2], const struct hawser__morison *of,
                          const double d[3], const struct hawser__water_past past[2], int slopes)
{
	const struct hawser_water_line *line = of->line;
	const struct hawser_drag drag = {of->density, 0.5*line->diameter, line->normal, line->tangential};
	const double l = hawser__norm(d), inverse = 1.0/l;
	const double t[3] = {d[0]*inverse, d[1]*inverse, d[2]*inverse};
	struct hawser__wet wet = {.part = {0.0}};

	if (line->diameter > 0.0 && l > 0.0)
		hawser__wet_line(&wet, 0.0, fmax(HAWSER__WATER_BAND*line->diameter, of->band),
		                 (const double[2]){past[0].height, past[1].height});
	for (int i = 0; i < 2; i++) {
		end[i].wet = of->length*wet.part[i];
		if (end[i].wet > 0.0 || wet.by[i][0] != 0.0 || wet.by[i][1] != 0.0)
			end_of(&end[i], end[i].wet, wet.by[i], of->length, &drag, line, t, inverse, of->g,
			       &past[i], slopes);
		else
			memset(&end[i], 0, sizeof end[i]);
	}
}

double hawser__morison_carried(const struct hawser__morison *of, const double d[3],
                               const double height[2], const double *const v[2])
{
	const struct hawser_water_line *line = of->line;
	const double radius = 0.5*line->diameter, square = hawser__dot(d, d);
	struct hawser__wet wet = {.part = {0.0}};
	double sum = 0.0;

	if (!(radius > 0.0 && square > 0.0))
		return 0.0;
	hawser__wet_line(&wet, 0.0, fmax(HAWSER__WATER_BAND*line->diameter, of->band), height);
	for (int i = 0; i < 2; i++) {
		double along = hawser__dot(v[i], d);

		sum += wet.part[i]*(line->added_normal*hawser__dot(v[i], v[i]) +
		                    (line->added_tangential - line->added_normal)*along*along/square);
	}
	return 0.5*of->density*M_PI*radius*radius*of->length*sum;
}

void hawser__morison_buoy(struct hawser__water_end *end, const struct hawser_water_buoy *buoy,
                          double density, double g, double band,
                          const struct hawser__water_past *past)
{
	/* of a larger sphere where the band is wider: as much of it is wet */
	const double larger = fmax(1.0, 0.5*band/fmax(cbrt(0.75*buoy->volume/M_PI), DBL_MIN));
	double by, wet = hawser__wet_sphere(&by, 0.0, buoy->volume, past->height/larger);
	double part = buoy->volume > 0.0 ? wet/buoy->volume : past->height < 0.0;
	double slope = buoy->volume > 0.0 ? (by /= larger)/buoy->volume : 0.0;

	memset(end, 0, sizeof *end);
	end->spring[0] = by*density*g;
	end->wet = wet;
	hawser_drag_body(end->drag, end->by_r, 0.5*density*buoy->CdA, past->r);
	for (int k = 0; k < 3; k++) {
		double inertia = density*((1.0 + buoy->added)*past->du[k] - buoy->added*past->a[k]) +
		                 (k == 1 ? density*g : 0.0);

		end->by_y[0][k] = slope*end->drag[k] + by*inertia;
		end->drag[k] *= part;
		end->load[k] = end->drag[k] + wet*inertia;
		end->mass[k][k] = density*wet*buoy->added;
		for (int j = 0; j < 3; j++)
			end->by_r[k][j] *= part;
	}
}
