/* hawser/law.h - the static law of a coordinate of a reduced model, and the amplitude up to which it
 * is that of the cable.
 *
 * One coordinate is held at a displacement and all others go where the strain energy is least: in the
 * model, with its own K, Q and C; and in the cable, with the exact energy on a full-order basis. The
 * force that holds the coordinate is the static law. Inertia, damping and loads have no part in it.
 * doc/theory-rom.md, "The range of a reduced model".
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_LAW_H
#define HAWSER_LAW_H

#include <hawser/rom.h>

#ifdef __cplusplus
extern "C" {
#endif

enum hawser_law_end {
	HAWSER_LAW_FOUND = 0,
	HAWSER_LAW_SLACK,        /* the cable is slack somewhere: there is no exact law */
	HAWSER_LAW_NO_MODEL,     /* the model's energy has no minimum there */
	HAWSER_LAW_NO_EXACT      /* the exact energy's minimum was not found */
};

struct hawser_law_point {
	double amplitude; /* given, m: the coordinate times the largest displacement of its shape (`largest`
	                   * below); its sign is that of the coordinate */
	double u;         /* the coordinate, scaled */
	double model, exact; /* force over (stiffness times coordinate), minus 1; NAN if not found */
	double error;     /* estimated absolute error of `exact`: how far it moved with the last larger
	                   * basis */
	double inertia;   /* the part of its inertia in a motion of this amplitude that the model lacks:
	                   * what follows as at rest, s = s2 u^2, has the kinetic energy 2 s2^2 u^2 u'^2,
	                   * and the inertia of u cos(Omega t) is greater by 2 s2^2 u^2 */
	double damping;   /* the same of its damping: s has the power 4 D_s s2^2 u^2 u'^2, of which a
	                   * model has that of its own coordinates */
	double tension[2], model_tension[2]; /* smallest and largest on the cable, N; without a
	                                     * minimum, where it was sought last */
	int functions;    /* per component, of the basis of `exact` */
	enum hawser_law_end end;
};

/* Fill point[count], whose amplitudes are given, for coordinate j of a model of these statics. Bases
 * grow until `exact` moves by less than a thousandth of the force, or have 32 functions a component.
 * Statuses: HAWSER_ERR_ARGUMENT (a coordinate that is no mode of the cable, a model with exact energy
 * or without modes, an amplitude that is 0 or not finite), HAWSER_ERR_CONVERGENCE (no basis resolves
 * the mode), those of hawser_rom_build_full. */
enum hawser_status hawser_law_trace(struct hawser_law_point *point, int count,
                                    const struct hawser_rom *rom,
                                    const struct hawser_statics *statics, int j,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;

#define HAWSER_LAW_LIMIT 0.01 /* relative error of force, inertia or damping that ends a range */

/* What ends the range of a coordinate. */
enum hawser_range_end {
	HAWSER_RANGE_UNKNOWN = 0,
	HAWSER_RANGE_FORCE,     /* the static force, inertia or damping of the model has this error */
	HAWSER_RANGE_AT_LEAST,  /* no end was found up to `amplitude`, where the search stops */
	HAWSER_RANGE_SLACK      /* the cable goes slack */
};

struct hawser_rom_range {
	double largest;   /* largest displacement of the coordinate's shape along the cable, or stroke of
	                   * an absorber, m for a coordinate of 1 (scaled) */
	double amplitude; /* m: up to this displacement all three are within HAWSER_LAW_LIMIT; 0 if
	                   * not known. Divided by `largest` it is |u_j| */
	enum hawser_range_end end;
};

/* Find rom->range[n] of such a model: for each mode the smallest amplitude, in either direction,
 * at which the force of the model differs from the exact one by more than HAWSER_LAW_LIMIT of it,
 * or the inertia of what follows and is not in the model is that part of the coordinate's own, so
 * that the frequency of a motion is off by half of it, or the height of a peak by its damping and
 * half its inertia. It is sought up to reached[n], the largest |u_j| of a motion (scaled; 0: not
 * sought), or, with NULL, up to half the sag or a twentieth of the span, whichever is larger.
 * Statuses: those above, without _CONVERGENCE: the range of such a mode is not known. */
enum hawser_status hawser_law_range(struct hawser_rom *rom, const struct hawser_statics *statics,
                                    const double *reached,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;

/* The coordinate of a motion that exceeds its range by the largest factor, -1 if none does; for
 * reached[n] as above. Ranges that are not known, that are at least what was sought, or that end where
 * the cable is slack, are not exceeded. */
int hawser_law_exceeded(const struct hawser_rom *rom, const double *reached);

#ifdef __cplusplus
}
#endif
#endif
