/* ropeway/statics/rope.h - internal to the statics of a line: free rope, arcs, and the paths on which
 * the rope may leave a sheave. Derivations: doc/theory-ropeway.md.
 *
 * A rope that runs at the speed v has the shape of one at rest (src/statics/travel.c). All of
 * this is written for the rope at rest, with
 *   P      vector along the rope of size T - rho v^2 |x'|; at rest the tension
 *   S      unstretched arclength times `stretch`
 *   w      rho*g/stretch, N/m
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROPEWAY_ROPE_H
#define HAWSER_ROPEWAY_ROPE_H

#include <hawser/line.h>

struct hawser__rope {
	double EA, w;          /* N, N/m */
	double stretch;        /* 1/(1 - rho v^2/EA) */
	double thrust;         /* rho v^2, N */
	int masses;
	double *S, *weight;    /* [masses] m, N */
};

/* A point of the rope. */
struct hawser__rope_point {
	double x[2], P[2];     /* m, N: P behind the point */
	double S;
	int mass;              /* the first mass that is not yet passed */
};

/* Move along the free rope to S, between two masses. Adds the flexibility of this part, that is
 * the change of its chord with P: xx, xy, yy, m/N. */
void hawser__fly(struct hawser__rope_point *at, double flexibility[3], const struct hawser__rope *rope,
                 double S);
/* Stretch of the free rope of unstretched length L that begins with P, m. */
double hawser__fly_stretch(const struct hawser__rope *rope, const double P[2], double L);
/* Pass the mass at which the station is. */
void hawser__pass(struct hawser__rope_point *at, const struct hawser__rope *rope);

/* Where the free rope comes nearest to a point c. The rope is the lower boundary of a convex set. */
struct hawser__meet {
	double distance;       /* m, of c from this set: negative if c is in it, above the rope */
	double normal[2];      /* of the set's boundary, into the set */
	double flexibility[3]; /* from the start to the nearest point, m/N */
	struct hawser__rope_point at; /* the nearest point, before its mass */
	int vertex;            /* 1: the nearest point is the mass at.mass */
	int found;             /* 0: the start is nearest; only `distance` is set */
};

/* `turn`: largest turning of the rope between two places that are compared, rad: what a rope
 * needs that is curved more than a circle about c. `reach`: places beyond c[0] + reach do not
 * matter. `leaving`: the start is the place at which the rope leaves a circle about c. */
void hawser__meet(struct hawser__meet *meet, const struct hawser__rope *rope,
                  const struct hawser__rope_point *from, const double c[2], double turn, double reach,
                  int leaving);

/* Rope in contact with a circle, from a slope angle0 and a tension T0 on. */
struct hawser__arc {
	double R, angle0, T0;
	double friction;       /* coefficient; > 0: the tension grows towards B */
	int side;
};
/* Tension and unstretched length after the angle q. The tension is NAN if it would be negative. */
void hawser__arc_at(double *T, double *S, const struct hawser__arc *arc,
                    const struct hawser__rope *rope,
                    double q);
/* Normal force per angle at the tension T and the slope angle a, N: that per length times R. */
double hawser__arc_force(const struct hawser__arc *arc, const struct hawser__rope *rope, double T,
                         double a);
/* Force of the circle on the rope from 0 to q: normal and friction by quadrature, N. */
void hawser__arc_total(double force[2], const struct hawser__arc *arc, const struct hawser__rope *rope,
                       double q);

/* What a rope has to meet: a sheave, or the end B as a point. */
struct hawser__target {
	double c[2], R, friction;
	int side;
	int index;             /* of the sheave; their number: end B */
};

/* The states in which the rope may leave a sheave, or the end A, as one continuous path. Along
 * it the force of the sheave grows, which lowers the rope behind a support sheave and raises it
 * behind a compression sheave. The path is a sequence of segments. */
enum hawser__segment {
	HAWSER__LAUNCH, /* end A: q = -asinh(slope), from -infinity to infinity */
	HAWSER__ARC,    /* on the circle: q = angle of contact */
	HAWSER__MASS    /* a mass at the point where the rope leaves: q = normal force that carries it, N */
};

struct hawser__path {
	const struct hawser__rope *rope;
	struct hawser__target from; /* its sheave; index -1: end A */
	struct hawser__arc arc;
	enum hawser__segment kind;
	int count;             /* segments before this one */
	struct hawser__rope_point at; /* where the segment begins; P before the mass's normal force */
	double angle;          /* slope of the tangent of the circle there */
	double end;            /* q at its end */
	int last;              /* 1: nothing follows, and `end` itself is not reached */
	double T;              /* of LAUNCH, N */
	int lowers;            /* 1: of end A and of a support sheave; -1 */
};

void hawser__path_open(struct hawser__path *path, const struct hawser__rope *rope, const double A[2],
                       double T);
/* The path of the sheave that the rope meets. */
void hawser__path_arrive(struct hawser__path *path, const struct hawser__rope *rope,
                         const struct hawser__target *sheave, const struct hawser__meet *meet);
/* Where the rope leaves at q, and the change of P with q. */
void hawser__path_at(struct hawser__rope_point *at, double slope[2], const struct hawser__path *path,
                     double q);

/* Receives the rope as it is laid; NULL: nothing is recorded. */
struct hawser__rope_trace {
	struct hawser_line_statics *st;
	int room;              /* pieces that fit */
	int pending;           /* mass at the beginning of the next piece, or -1 */
	struct hawser__rope_point *arrive, *leave; /* [sheaves] before and behind the contact */
	double *tangent;       /* [masses] slope of the circle at a mass in contact */
};
void hawser__trace_free(struct hawser__rope_trace *trace, const struct hawser__rope *rope,
                        const struct hawser__rope_point *from, const struct hawser__rope_point *to);
void hawser__trace_arc(struct hawser__rope_trace *trace, const struct hawser__path *path, double q);
void hawser__trace_mass(struct hawser__rope_trace *trace, const struct hawser__path *path,
                        double carried);
void hawser__trace_arrive(struct hawser__rope_trace *trace, int sheave,
                          const struct hawser__meet *meet);
void hawser__trace_leave(struct hawser__rope_trace *trace, int sheave,
                         const struct hawser__rope_point *at);

/* Go to the next segment. */
void hawser__path_next(struct hawser__path *path, struct hawser__rope_trace *trace);
/* From q of an arc below a circle, over the free rope, to the next contact with the same circle. */
void hawser__path_again(struct hawser__path *path, struct hawser__rope_trace *trace, double q,
                        const struct hawser__meet *meet);

enum hawser__search {
	HAWSER__MET = 0,
	HAWSER__NOT_PRESSED, /* the rope would have to be pulled from the sheave */
	HAWSER__TOO_LOW      /* the tension is too low to come down to the target */
};
/* The first place on the path from which the rope meets the target; moves the path to its
 * segment. `slack`: the second place, from which the rope comes up to the target. */
enum hawser__search hawser__path_find(struct hawser__path *path, double *q, struct hawser__meet *meet,
                                      struct hawser__rope_trace *trace,
                                      const struct hawser__target *target,
                                      int slack);

#endif
