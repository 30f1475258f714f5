/* hawser/normal_form.h - the normal form of a bifurcation of a periodic motion: on which side of a
 * period doubling or torus point the new motions are, and whether they are stable.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_NORMAL_FORM_H
#define HAWSER_NORMAL_FORM_H

#include <hawser/frf.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The period map on the center manifold, to the order that decides, at the bifurcation:
 *
 *   fold              e -> e + c e^2
 *   period doubling   e -> -e + c e^3      c > 0: supercritical, the doubled motion is stable
 *   torus point       e -> mu e (1 + d e conj(e)), c = Re d;  c < 0: supercritical, the torus is stable
 *
 * (stable: if all other multipliers are inside the unit circle). The state is x + e q, or
 * x + e q + conj(e q), with the eigenvector q of the multiplier mu of unit length, velocities divided
 * by Omega, at phase 0 of the load. */
struct hawser_normal_form {
	enum hawser_event_kind kind;
	double c;        /* scaled: 1/length of a fold (its sign is that of q, and it is >= 0), else
	                  * 1/length^2 */
	double error;    /* estimated absolute error of c, by differences of the map over other distances */
	double angle;    /* of a torus point: argument of mu, 0 to pi */
	double distance; /* | |mu| - 1 |, or |mu - 1|, |mu + 1|: how far the motion is from the event */
	int decided;     /* 1 supercritical, -1 subcritical, 0: c is within its error of 0, or a fold */
};

/* Of the motion with the state [2n] at phase 0, of `period` periods of the load of frequency omega
 * (scaled). The derivatives of the period map, of second and third order, are differences of eighth
 * and sixth order, over the distance from the motion at which they change least with it (error).
 * HAWSER_ERR_ARGUMENT (kind, period, state; ramps and histories), HAWSER_ERR_NO_SOLUTION (the
 * multiplier is further than 0.001 from its place; a resonance mu^3 = 1 or mu^4 = 1; no derivatives,
 * as at kinks of the forces), HAWSER_ERR_MEMORY. */
enum hawser_status hawser_normal_form(struct hawser_normal_form *form, const struct hawser_rom *rom,
                                      const double *state, double omega, int period,
                                      enum hawser_event_kind kind,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;

#ifdef __cplusplus
}
#endif

#endif
