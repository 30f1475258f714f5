/* ropeway/expand/expand.h - the energy of a rope over sheaves to fourth order in given shapes, the rest
 * of the rope following statically (doc/theory-ropeway-response.md).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROPEWAY_EXPAND_H
#define HAWSER_ROPEWAY_EXPAND_H

#include "core/hold.h"
#include "modes/driven.h"
#include "modes/pairing.h"
#include "ropeway/modes/modes.h"

/* A shape: a state of one system of the rope, with its strains. */
struct hawser__lexpand_shape {
	int system;
	const double *x, *strain; /* [size], [strains] of the system */
	double omega;             /* > 0: a mode, along which nothing follows; 0: the energy is that of the
	                           * rope all of which follows */
};

/* Forms of an end: what a shape does at the end of a free piece on a circle, in the frame of the
 * circle's tangent and normal there. */
enum hawser__lexpand_form {
	HAWSER__FORM_U = 0,   /* displacement along the circle */
	HAWSER__FORM_ALONG,   /* change of the force along the tangent */
	HAWSER__FORM_ACROSS,  /* and along the normal */
	HAWSER__FORM_OPENING, /* change of slope minus that of the circle: across/T - kappa U */
	HAWSER__FORM_ASIDE,   /* slope out of the plane */
	HAWSER__FORMS
};

/* The end of a free piece at a sheave. */
struct hawser__lexpand_end {
	int piece, end;       /* of the rope; 0: the piece begins there, 1: it ends there */
	int lane, sheave;
	int smooth;           /* 1: no mass is there, so that the rope leaves the circle tangentially, and
	                       * the point at which it does moves */
	int segment[2], system[2]; /* in the plane and out of it; -1: none */
	int node;             /* of the system in the plane; -1: it does not move */
	double T, along, across;   /* force of the statics, and in the frame of the circle */
	double kappa, gap;    /* curvature of the circle, and how much larger than that of the rope it is
	                       * (signed as kappa) */
	double turn;          /* angle from the rope to the circle's tangent */
	double tangent[2];    /* in the frame of the run */
	double *form[HAWSER__FORMS]; /* [n] each */
};

/* A mass on a circle, or nothing but its weight. */
struct hawser__lexpand_weight {
	int system, node;
	double third, fourth; /* derivatives of its potential along the circle */
	double *u;            /* [n] */
};

/* A hanger: a point of the energy behind those of the free rope, whose tangent is its own. */
struct hawser__lexpand_hanger {
	int system[3], pendulum[3]; /* along it, along x, along z */
};

struct hawser__lexpand {
	struct hawser__lmode *rope;
	const struct hawser__lexpand_shape *shape; /* [n] the caller's */
	int n, pairs;
	int held;             /* 1: the rope leaves the circles at material points */
	int *first;           /* [pieces] first point of a free piece; -1: an arc */
	int points;           /* of free pieces, and hangers */
	double *weight, *stretch, *tau; /* [points]: of the quadrature; |x'|; scaled tension */
	double *epsilon;      /* [points] force over EA */
	int hangers;          /* the last points */
	struct hawser__lexpand_hanger *hanger; /* [hangers] */
	double *slope;        /* [n][points][3] a, b, c */
	int ends, weights;
	struct hawser__lexpand_end *end;       /* [ends] */
	struct hawser__lexpand_weight *mass;   /* [weights] */
	double *third;        /* [n][n][n] third derivatives of the energy */
	double *pairing;      /* [pairs][pairs]: the part of fourth derivatives that one way to pair four
	                       * indices gives */
	size_t width;         /* of a displacement of the whole rope as a row, see below */
	double *second;       /* [pairs][width] second-order displacement 1/2 sum u_j u_k w_jk: follows */
	struct hawser__hold hold; /* its arrays */
};

/* A displacement of the whole rope is a row: the states of all systems, then their strains. The part of
 * one system of it, and its width. expand_at.c. */
struct hawser__lexpand_part {
	double *x, *strain;   /* [size], [strains] of the system */
};
struct hawser__lexpand_part hawser__lexpand_part(const struct hawser__lmode *rope, double *row,
                                                 int system);
size_t hawser__lexpand_width(const struct hawser__lmode *rope);

/* The systems of the rope must have their grids and factors, and none may circulate. `rope` is
 * kept, and used for static solutions. HAWSER_ERR_ARGUMENT (what the expansion does not cover),
 * HAWSER_ERR_MEMORY. */
enum hawser_status hawser__lexpand_open(struct hawser__lexpand *t, struct hawser__lmode *rope,
                                        const struct hawser__lexpand_shape *shape, int n, int held,
                                        struct hawser_report *report);
void hawser__lexpand_clear(struct hawser__lexpand *t);
/* Fourth derivative of the energy by four coordinates. */
double hawser__lexpand_fourth(const struct hawser__lexpand *t, const int index[4]);

/* expand_points.c: points, ends and weights, and what the shapes do there. */
enum hawser_status hawser__lexpand_points(struct hawser__lexpand *t, struct hawser_report *report);
/* Derivatives of the potential of an arc's weight along the circle, at point i of its segment:
 * third and fourth. */
void hawser__lexpand_arc(double derivative[2], const struct hawser__lexpand *t,
                         const struct hawser__lmode_segment *s, int i);
/* expand_ends.c: derivatives of the energy of the ends and of the weights on circles. */
double hawser__lexpand_ends_third(const struct hawser__lexpand *t, int j, int k, int l);
double hawser__lexpand_ends_fourth(const struct hawser__lexpand *t, const int index[4]);
/* Lift along the normal and out of the plane, and force along the circle on what follows, by the
 * pair j, k. */
void hawser__lexpand_lift(double lift[2], const struct hawser__lexpand *t,
                          const struct hawser__lexpand_end *end, int j, int k);
double hawser__lexpand_push(const struct hawser__lexpand *t, const struct hawser__lexpand_end *end,
                            int j, int k);
/* expand_follow.c: second, pairing. */
enum hawser_status hawser__lexpand_follow(struct hawser__lexpand *t, struct hawser_report *report);

/* --- expand_modes.c: modes as the shapes of an expansion --- */

enum { HAWSER__LEXPAND_MORE = 6 };

/* A force that oscillates: along y per length, at the scaled arclength s of a lane; or, with pull NULL,
 * the motion of end B (or A: end 0) of each lane along the rope. */
struct hawser__lexpand_force {
	double (*pull)(const void *wave, int lane, double s);
	const void *wave;
	int end;
	double motion[HAWSER_LINE_LANES]; /* scaled */
};

struct hawser__lexpand_modes {
	struct hawser__lmode rope;
	struct hawser__lmode_search search;    /* which refers to rope: the structure must not be moved */
	struct hawser__lexpand_shape *shape;   /* [search.n + HAWSER__LEXPAND_MORE]: the modes, and room for
	                                        * more */
};

/* The lowest modes, and the same in the public structure, on grids that also resolve a wave of the
 * number `wave` (1/m) along the rope. Both are to be cleared after a failure too. */
enum hawser_status hawser__lexpand_modes_open(struct hawser__lexpand_modes *t,
                                              struct hawser_line_modes *modes,
                                              const struct hawser_line_statics *const *lane, int lanes,
                                              const struct hawser_line_modes_options *options,
                                              double wave,
                                              struct hawser_report *report);
/* Drop all but the modes kept[count], ascending indices, of both. */
void hawser__lexpand_modes_keep(struct hawser__lexpand_modes *t, struct hawser_line_modes *modes,
                                const int *kept, int count);
void hawser__lexpand_modes_clear(struct hawser__lexpand_modes *t);

/* expand_drive.c: the static response of the modes that are not kept to a motion of ends of the rope,
 * added to a row; pull[n] is minus the force of this motion on the modes. */
enum hawser_status hawser__lexpand_drive(double *row, double *pull,
                                         const struct hawser__lexpand_modes *t,
                                         const struct hawser__lexpand_force *force,
                                         struct hawser_report *report);
/* expand_at.c: displacement P, Q, B and slopes a, b, c of shape i at s from the beginning of a piece
 * where the rope has the slope `angle`; slope may be NULL. */
void hawser__lexpand_shape_at(double shape[3], double slope[3], const struct hawser__lexpand *t, int i,
                              int piece, double s, double angle);
/* The same of a displacement of the whole rope. */
void hawser__lexpand_field_at(double shape[3], double slope[3], const struct hawser__lmode *rope,
                              const double *row, int piece, double s, double angle);

/* expand_answer.c: products in mass and in stiffness, and P K^-1 M, of displacements of the whole rope,
 * beside the modes of t. Release `load`. */
struct hawser__lexpand_work {
	const struct hawser__lmode *rope;
	const struct hawser__lexpand_modes *modes;
	double *load;          /* [size of a system] */
};
double hawser__lexpand_stiffness(const void *work, const double *x, const double *y);
enum hawser_status hawser__lexpand_by(struct hawser__driven_by *by, struct hawser__lexpand_work *w,
                                      const struct hawser__lexpand_modes *t,
                                      struct hawser_report *report);
/* What the modes that are not kept do under a force; pull: as above, of a motion. */
enum hawser_status hawser__lexpand_answer(struct hawser__driven *answer, double *pull,
                                          const struct hawser__lexpand_modes *t,
                                          const struct hawser__lexpand_force *force,
                                          struct hawser_report *report);

#endif
