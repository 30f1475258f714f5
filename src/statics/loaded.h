/* statics/loaded.h - internal to the statics stage: a cable with point masses.
 *
 *   H, V0, L   horizontal force, vertical force at end A, unstretched length: the unknowns
 *   V          vertical force: V0 + w*S + the weights W_i with S_i <= S
 *   x, y       position of end B that they give; the equilibrium has x = d, y = h
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STATICS_LOADED_H
#define HAWSER_STATICS_LOADED_H

#include <hawser/statics.h>

struct hawser__load_point {
	double at; /* fraction of the length, or length in m if `fixed` */
	int fixed;
	double W;  /* N, downwards */
	double force[3]; /* N, along x, y, z: (0, -W, 0) in one plane */
};

/* Ends on springs (yield.c), along the axes of the cable: with the force rest + F at end A, the chord
 * is `chord` - C F. */
struct hawser__soft {
	double C[3][3], chord[3], rest[3];
};

struct hawser__loaded {
	double EA, w, d, h; /* N, N/m, m, m */
	int count;
	struct hawser__load_point load[HAWSER_ATTACH_MAX]; /* [count], ascending S for the length that
	                                                    * `sort` has seen */
	double weight;   /* N, of all loads */
	const struct hawser__soft *soft; /* NULL: both ends stay where they are */
	double H, V0, L; /* the state */
	int iterations;
};

/* The end of the profile and its derivatives at a state; also those of a point before the end. */
struct hawser__reach {
	double x, y;
	double xH, xV, xL, yH, yV, yL; /* xV = yH */
	double length;                 /* stretched */
};

/* The span of which *cable is made, and what is given. */
struct hawser__load_case {
	const struct hawser_span *span;
	enum hawser_given given;
	double value;
	enum hawser_branch branch;
	const struct hawser_attachment *attach;
};

/* Ascending S at the length L; order[count] are the indices in the list of the scene. */
void hawser__loaded_sort(struct hawser__loaded *cable, int *order);

/* *cable without its length, and order[count], in the order of the length L. */
void hawser__loaded_begin(struct hawser__loaded *cable, int *order, const struct hawser_span *span,
                          const struct hawser_attachment *attach, int count, const double gravity[3],
                          double L);

/* F: force at end A of the equilibrium of *cable, whose length is given, along its axes; if it is soft,
 * without soft->rest. */
enum hawser_status hawser__space_force(double F[3], struct hawser__loaded *cable, int *order,
                                       const struct hawser_span *span, struct hawser_report *report);

/* The equilibrium in space (space.c) of a cable whose loads are not along y. Sets all of *st but the
 * attachments, and L and the order of *cable. */
enum hawser_status hawser__space_solve(struct hawser_statics *st, struct hawser__loaded *cable,
                                       int *order, const struct hawser__load_case *of,
                                       struct hawser_report *report);

/* The attachments of the scene with their forces along the axes of the span of *equal. */
void hawser__attached_along(struct hawser_attachment attach[HAWSER_ATTACH_MAX],
                            const struct hawser_equivalent *equal, const struct hawser_scene *scene);

/* The span of *equal at rest with the attachments of the scene, which may be none. */
enum hawser_status hawser__statics_attached(struct hawser_statics *st,
                                            const struct hawser_equivalent *equal,
                                            const struct hawser_scene *scene,
                                            struct hawser_report *report) HAWSER_MUST_CHECK;

/* The forces of the attachments of a solved cable and its weight, together, along its axes. */
void hawser__space_total(double total[3], const struct hawser_statics *st);

/* S of load i, at most L, and its derivative by L. */
double hawser__load_place(const struct hawser__loaded *cable, int i, double *by_L);

/* Position of the point S, of which S_L is the derivative by L, at the state of *cable. */
void hawser__loaded_reach(struct hawser__reach *reach, const struct hawser__loaded *cable, double S,
                          double S_L);

/* Largest vertical distance from the chord, and its derivative by H along the equilibria with
 * derivatives V' and L' by H. */
double hawser__loaded_sag(const struct hawser__loaded *cable, double V_H, double L_H,
                          double *derivative);

#endif
