/* statics/wind.h - drag and lift of a section in a flow, and the wind of a scene. See wind.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STATICS_WIND_H
#define HAWSER_STATICS_WIND_H

#include <hawser/statics.h>

/* A coefficient over its argument: a sum of powers, or a natural cubic spline. */
struct hawser__coefficient {
	int powers; /* 0: the spline */
	double power[HAWSER_WIND_POWERS];
	int knots;
	double x[HAWSER_WIND_ROWS], y[HAWSER_WIND_ROWS], bend[HAWSER_WIND_ROWS]; /* bend: y'' */
};

/* A section: all zero, it has no force. */
struct hawser__section {
	double half;   /* density times diameter over 2, kg/m^2 */
	double angle;  /* of attack at rest, rad */
	int turns;     /* 1: drag or lift depend on the angle of attack or on the speed */
	struct hawser__coefficient drag, lift, reynolds; /* reynolds.knots 0: none */
	double reference; /* drag at the angle 0, whose place `reynolds` takes */
	double per_speed; /* Reynolds' number over the speed, s/m */
};

void hawser__section_make(struct hawser__section *section, const struct hawser_wind *wind);

/* The force f [2] per length, N/m, along the flow and across it, on a section that moves at v [2] in a
 * flow of this speed, m/s; and its derivative by v, unless NULL. */
void hawser__section_force(double f[2], double (*by_v)[2], const struct hawser__section *section,
                           double speed, const double v[2]);

/* Unit vectors normal to the unit vector t: e[0] along the flow U, e[1] across it, upwards; returns the
 * speed normal to t. Without one e[0] is upwards. */
double hawser__flow_frame(double e[2][3], const double U[3], const double t[3]);
/* The force f per length on a line of this section with the unit tangent t = x' times `inverse`, in the
 * flow U that is r relative to it; and unless they are NULL its derivatives by r, and by x' where U and
 * r stay. As hawser__drag_line (water/line.h). */
void hawser__section_line(double f[3], double (*f_r)[3], double (*f_x)[3],
                          const struct hawser__section *section, const double U[3], const double r[3],
                          const double t[3], double inverse);

/* Its series to the third order in v, for a speed > 0: f[i] is the sum over t of series[i][t]
 * v[0]^hawser__wind_power[t][0] v[1]^hawser__wind_power[t][1]. */
enum { HAWSER__WIND_TERMS = 10 };
extern const int hawser__wind_power[HAWSER__WIND_TERMS][2];
/* The term of this degree with v[1] to the power `across`. */
static inline int hawser__wind_term(int degree, int across)
{
	return degree*(degree + 1)/2 + across;
}
/* Of a product of up to three components of v, whose bit c of `place` is 1 where component c is v[1]:
 * how many are. */
static inline int hawser__wind_across(int place)
{
	return (place & 1) + (place >> 1 & 1) + (place >> 2 & 1);
}
void hawser__section_series(double series[2][HAWSER__WIND_TERMS],
                            const struct hawser__section *section, double speed);

/* The constant load on a span along x, y, z: load.static, and the wind on the straight chord at rest.
 * Returns 0 if the scene has neither. */
int hawser__static_load(double force[3], const struct hawser_scene *scene);

/* Mass per unstretched length of the fluid that moves with the cable, without weight. */
double hawser__added_mass(const struct hawser_scene *scene);

/* Speed at this fraction of the unstretched length over wind.speed. */
double hawser__wind_profile(const struct hawser_wind *wind, double part);

#endif
