/* rom/energy/law.h - a coordinate held in a model and in the cable, all others in equilibrium. law.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_LAW_H
#define HAWSER_ROM_LAW_H

#include <hawser/law.h>
#include <hawser/rom.h>

#include "core/hold.h"

/* --- relax.c: some coordinates of a model held, all others at the minimum of its energy.
 * relax.c --- */

struct hawser__relax {
	const struct hawser_rom *rom; /* any kind of energy; owned by the caller */
	int N, frees;         /* coordinates; the relaxed ones */
	int *freed;           /* [frees] their indices, set by the caller; room for N */
	double *y;            /* [N] */
	double *R, *T;        /* [N], [N][N] restoring force and tangent of the last Newton step */
	double *step;         /* [frees] the last step */
	double *trial, *rest; /* [N] workspace; zeros */
	double *matrix;       /* [frees][frees] Cholesky factor, by columns */
	struct hawser__hold hold; /* its arrays */
};

/* Nothing is freed. Returns 1 if out of memory; _clear in any case. */
int hawser__relax_new(struct hawser__relax *relax, const struct hawser_rom *rom);
void hawser__relax_clear(struct hawser__relax *relax);

/* Minimise the energy over the relaxed coordinates, from relax->y on, which has the held ones. size > 0
 * is that of the motion; the last Newton step, which is not made, is 1e-9 of it or less. 0: no minimum
 * found. */
int hawser__relax(struct hawser__relax *relax, double size);

/* From a minimum that hawser__relax has found on: move coordinate `held` by du, and the relaxed ones
 * along the tangent of the minima. */
void hawser__relax_along(struct hawser__relax *relax, int held, double du);

/* The relaxed coordinates to second order in the held ones, which relax->y has: those that balance the
 * quadratic part of the force, each with its own stiffness (K is diagonal). */
void hawser__relax_place(struct hawser__relax *relax);

enum { HAWSER__LAW_BASES = 3 };

/* Full-order models of one scene, made as they are needed. */
struct hawser__law {
	const struct hawser_rom *rom;
	const struct hawser_statics *statics;
	int j, twin;                 /* coordinate of `rom`; that of the present basis, from 0 */
	double sign;                 /* of the twin */
	double power;                /* of the frequency, which the damping of modes follows */
	int basis;                   /* index of the present one */
	struct hawser__relax model;  /* of `rom` */
	struct hawser_rom full[HAWSER__LAW_BASES];
	struct hawser__relax exact[HAWSER__LAW_BASES];
	double *strain[HAWSER__LAW_BASES]; /* at the quadrature points of the full-order model */
};

enum hawser_status hawser__law_open(struct hawser__law *law, const struct hawser_rom *rom,
                                    const struct hawser_statics *statics,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__law_close(struct hawser__law *law);

/* Hold coordinate j from now on, with the first basis from number `first` on that resolves it;
 * *found = 0: none does. */
enum hawser_status hawser__law_hold(struct hawser__law *law, int *found, int j, int first,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;

/* Everything of the point but its error, at its amplitude, with the present basis. */
void hawser__law_at(struct hawser__law *law, struct hawser_law_point *point);
/* The part that is exact alone. */
void hawser__law_exact(struct hawser__law *law, struct hawser_law_point *point);

/* The law of coordinate `held` at u, relax->freed being relaxed, and the tensions; NAN and 0 if there
 * is no minimum: then the tensions are those where it was sought last. */
int hawser__law_force(double *law, double tension[2], struct hawser__relax *relax, int held,
                      double u);

/* 1: the law in the other direction is the same by symmetry: coordinates out of a plane. */
int hawser__law_even(const struct hawser__law *law);

/* A coordinate that is a mode of the cable, not a shape of a damper or of second order. */
int hawser__law_is_mode(const struct hawser_rom *rom, int j);

/* The words of the reduced-model file for enum hawser_range_end, NULL at the end.
 * read_range.c. */
extern const char *const hawser__range_ends[];

/* rom->range of a model of `modes`, without amplitudes. HAWSER_ERR_MEMORY. */
enum hawser_status hawser__range_make(struct hawser_rom *rom, const struct hawser_modes *modes,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;

#endif
