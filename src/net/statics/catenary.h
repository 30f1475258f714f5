/* net/statics/catenary.h - the exact elastic catenary between two points, as a function of its force.
 *
 * L    length0, EA, p: force per unstretched length (weight and loads), constant
 * F    tension vector at half of the unstretched length, which is the mean of those of both ends:
 *      t(S) = F + p*(L/2 - S)
 *
 * The complementary energy W(F) = integral over 0..L of |t| + |t|^2/(2 EA) is convex for every F. Its
 * gradient is the chord, from S = 0 to S = L; its second derivative is the flexibility.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_NET_CATENARY_H
#define HAWSER_NET_CATENARY_H

struct hawser__net_catenary {
	double p[3];    /* N/m */
	double length0; /* m */
	double EA;      /* N */
	double density; /* N/m; positive: a spring of this stiffness and no length instead, without p */
	double soft;    /* N: |t| is sqrt(|t|^2 + soft^2), so that a cable without weight may be slack */
};

/* W at F, J; chord [3] and flexibility [3][3], m/N, if not NULL. */
double hawser__catenary(double chord[3], double (*flexibility)[3],
                        const struct hawser__net_catenary *cable, const double F[3]);
/* Its inverse, the stiffness, N/m: positive definite whatever round-off does. */
void hawser__catenary_stiffness(double stiffness[3][3], const struct hawser__net_catenary *cable,
                                const double F[3]);
/* Stretched length minus L, m: the integral of |t|/EA. */
double hawser__catenary_stretch(const struct hawser__net_catenary *cable, const double F[3]);
/* Place of the point S, from the end S = 0, and tension vector there. */
void hawser__catenary_point(double x[3], double t[3], const struct hawser__net_catenary *cable,
                            const double F[3], double S);

#endif
