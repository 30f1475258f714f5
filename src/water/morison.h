/* water/morison.h - Morison's equation for the ends of an element and for a sphere: buoyancy, drag,
 * added mass. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_WATER_MORISON_H
#define HAWSER_WATER_MORISON_H

#include <hawser/water.h>

/* Of the diameter: the height over which a line comes out of the water. With all of it a line that
 * ends at the surface would lack the drag of the last half. */
#define HAWSER__WATER_BAND 0.01
/* What flows past an end of an element. */
struct hawser__water_past {
	double height;     /* m, above the surface */
	double u[3], r[3]; /* m/s, of the water; relative to the line */
	double du[3], a[3]; /* m/s^2, of the water and of the line */
};
/* What the water does to an end of an element, and the derivatives of the load. */
struct hawser__water_end {
	double load[3], drag[3]; /* N: all, and of it the drag */
	double mass[3][3];       /* kg: added mass */
	double by_r[3][3];       /* by the relative velocity */
	double by_d[3][3];       /* by the vector along the element */
	double by_y[2][3];       /* by the heights of both ends */
	double wet;              /* m, unstretched length in the water; m^3 of a buoy */
	double spring[2];        /* N/m: of that what is buoyancy, of the force upwards */
};
/* An element of a line in water. */
struct hawser__morison {
	const struct hawser_water_line *line;
	double density, g;       /* kg/m^3, m/s^2 */
	double length;           /* m, unstretched */
	double band;             /* m: least height over which it comes out of the water */
};
/* d: vector along the element. With slopes = 0, by_r and by_d of what is wet are left as they were. */
void hawser__morison_ends(struct hawser__water_end end[2], const struct hawser__morison *of,
                          const double d[3], const struct hawser__water_past past[2], int slopes);
/* Kinetic energy of the water that moves with it, J, for the heights and velocities of its ends. */
double hawser__morison_carried(const struct hawser__morison *of, const double d[3],
                               const double height[2], const double *const v[2]);
/* The same as of ends, of a sphere, without by_d; of by_y and spring the first. */
void hawser__morison_buoy(struct hawser__water_end *end, const struct hawser_water_buoy *buoy,
                          double density, double g, double band,
                          const struct hawser__water_past *past);

#endif
