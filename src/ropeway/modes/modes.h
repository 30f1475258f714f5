/* ropeway/modes/modes.h - modes of a rope over sheaves: what the files of the method share.
 *
 * All is scaled: lengths by `length`, forces by `force`, times by length*sqrt(rho/force).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROPEWAY_SPAN_MODES_H
#define HAWSER_ROPEWAY_SPAN_MODES_H

#include <hawser/line_modes.h>

#include "core/hold.h"
#include "modes/grid.h"

enum { HAWSER__ENDS = 2, HAWSER__ORDER_MOST = 200 };

/* The statics of one piece of the rope, scaled. Tensions are those of the apparent rope: T - nu^2 g. */
struct hawser__lmode_piece {
	int lane, piece, sheave, mass; /* indices in the lane; mass: at its beginning, or -1 */
	int run;              /* number of the free rope between two sheaves or ends; -1: an arc */
	double s0, length;
	double delta;         /* weight per length */
	double H, V;          /* free: horizontal and vertical tension at its beginning */
	double bent;          /* free: V minus that of the reference, without cancellation */
	double reference[2];  /* free: H and V at the middle of the run. Its direction is the frame in
	                       * which the displacements of the run are given */
	double angle[2];      /* at its ends */
};

/* A point at which pieces meet, and which can move. */
struct hawser__lmode_node {
	int dofs;             /* 1: along the circle, or out of the plane; 2: in the frame of its run */
	double mass[2][2], stiffness[2][2];
	int at, row;          /* of its first value in states, and in the equations */
};

/* A piece that moves, in one plane of motion. */
struct hawser__lmode_segment {
	const struct hawser__lmode_piece *piece;
	int index;            /* of the piece */
	int arc, D, chain;
	int node[HAWSER__ENDS];  /* at its ends; -1: none */
	double map[HAWSER__ENDS][2][2]; /* [end][component][value of the node] */
	double *border;       /* [ends][2][borders] displacement of its ends by the borders; or NULL */
	struct hawser_grid grid;
	struct hawser__reference table;
	double sa;            /* sqrt(compliance) of stretch */
	double *cosine, *sine; /* [points] of the tangent from the reference (D = 2);
	                       * on an arc in the plane: sine of its slope */
	double *sb;           /* [points] sqrt(compliance) of rotation; NULL on an arc in the plane */
	double *k;            /* [points] stiffness of the ground, on an arc in the plane; else NULL */
	double *inverse;      /* [points][points] of I - c J J k (modes_equations.c); else NULL */
	double *unit[2];      /* [points] displacement of an arc by a unit displacement, force at its end */
	double P[2][2][2][2]; /* displacement (0) and force (1) at its end by those at its beginning */
	int at, strain, row;  /* of its first value in states, of strains, in the equations */
};

/* A mass that hangs from a node or a border on a rod: one horizontal coordinate; on a rod that
 * stretches (rope->soft), a vertical one too. */
struct hawser__lmode_pendulum {
	int node, border;     /* the other is -1 */
	double along[2];      /* displacement of the point along it per value of the node */
	double mass, compliance; /* compliance: length over weight; vertical: its part `soft` */
	int vertical;
	double length, weight; /* of the rod, under the weight */
	int at;               /* in states */
	int carrier;          /* index of the mass over all lanes */
};

/* A coordinate that several ends share. */
struct hawser__lmode_border {
	double mass, stiffness;
	int freedom, sheave;  /* which: a freedom, or a sheave that turns; else -1 */
	int lane;             /* of the sheave */
	int at;
};

/* All that moves in one plane, or a part of it that moves independently of the rest. States are
 * displacements [segments][D][points], then nodes, pendulums, borders. */
struct hawser__lmode_system {
	enum hawser_plane plane;
	int segments, nodes, pendulums, borders;
	struct hawser__lmode_segment *segment; /* [segments] along the rope */
	struct hawser__lmode_node *node;
	struct hawser__lmode_pendulum *pendulum;
	struct hawser__lmode_border *border;
	int size, strains, rows;
	double *weight;       /* [size] of the inner product, but for nodes */
	double *band;         /* factors of the equations (modes_equations.c) */
	int *pivot;
	double *response;     /* [borders] columns of rows: of the equations to the borders */
	double *schur;        /* [borders][borders], factors */
	int *schur_pivot;
	int circulates;       /* 1: the rope can circulate: a motion without stiffness */
	double *null, *null_strain, *null_load; /* [size], [strains], [size]: that motion, of unit norm, its
	                       * strains, and its inertia; or NULL */
	double *work;
	int work_size;
	struct hawser__hold parts, arrays; /* parts: segment to border, and those of the segments */
};

struct hawser__lmode {
	const struct hawser_line_statics *const *lane;
	int lanes, pieces, runs, masses;
	struct hawser_line_modes_options options;
	double length, force, epsilon, nu;
	double soft;          /* strain of the hangers under the weight; 0: they are rigid. Those on sheaves
	                       * do not swing then */
	struct hawser__lmode_piece *piece; /* [pieces] */
	struct hawser__lmode_system *system; /* [systems] */
	int systems;
};

/* modes_plan.c: units and pieces, then systems without grids. */
enum hawser_status hawser__lmode_open(struct hawser__lmode *rope,
                                     const struct hawser_line_statics *const *lane, int lanes,
                                     const struct hawser_line_modes_options *options, double soft,
                                     struct hawser_report *report);
void hawser__lmode_clear(struct hawser__lmode *rope);
void hawser__lmode_system_clear(struct hawser__lmode_system *system);
/* A point at which pieces meet. */
struct hawser__lmode_joint {
	int sheave;           /* -1: free */
	int mass;             /* -1: none */
	double tangent[2];    /* angle of the circle's tangent, seen from the piece before and behind */
};

/* modes_pieces.c: rope->piece and runs; the joint between piece i - 1 and i of a lane. */
void hawser__lmode_pieces(struct hawser__lmode *rope);
struct hawser__lmode_joint hawser__lmode_joint(const struct hawser__lmode *rope, int lane, int i);
/* Index over all lanes of a mass of a lane. */
int hawser__lmode_carrier(const struct hawser__lmode *rope, int lane, int mass);
/* Scaled weight per length of a lane. */
double hawser__lmode_delta(const struct hawser__lmode *rope, int lane);
/* Scaled speed of the rope in a lane, positive from A to B. */
double hawser__lmode_nu(const struct hawser__lmode *rope, int lane);

/* modes_grid.c: grids that resolve the frequency `omega`, with `extra` more nodes an element; and the
 * fields of a segment on them. */
enum hawser_status hawser__lmode_grids(struct hawser__lmode_system *system,
                                       const struct hawser__lmode *rope,
                                      double omega, int extra, struct hawser_report *report);
/* The grid alone, of any piece. */
enum hawser_status hawser__lmode_piece_grid(struct hawser_grid *grid,
                                           const struct hawser__lmode_piece *piece,
                                           const struct hawser__lmode *rope, double omega, int extra,
                                           struct hawser_report *report);
void hawser__lmode_grid_clear(struct hawser__lmode_segment *segment);
/* Phase of a wave of unit frequency along a segment: its time of travel. */
double hawser__lmode_phase(const struct hawser__lmode_segment *segment,
                           const struct hawser__lmode *rope);

/* modes_equations.c: factor the equations; modes_static.c: solve them for loads. */
enum hawser_status hawser__lmode_factor(struct hawser__lmode_system *system,
                                        struct hawser_report *report);
/* x [size] and strain [strains] of the load [size]: per length at the points of segments, else a force.
 * strain may be NULL; x and load may be the same. */
void hawser__lmode_static(double *x, double *strain, struct hawser__lmode_system *system,
                         const double *load);
/* Strains that the rope would have without force, and displacements of the ends of segments besides
 * those of their nodes, in the frame of the run (not of arcs). */
struct hawser__lmode_given {
	const double *source;       /* [strains], in the scale of strains; strain is then that of the force
	                             * minus the source; or NULL */
	const double (*lift)[HAWSER__ENDS][2]; /* [segments][ends][component], or NULL */
	const double *off;          /* [size] of pendulums, from where they hang; or NULL */
};
/* The same with these; of a system that does not circulate. */
void hawser__lmode_static_given(double *x, double *strain, struct hawser__lmode_system *system,
                                const double *load, const struct hawser__lmode_given *given);
/* load = mass times x, both [size]. */
void hawser__lmode_inertia(double *load, const double *x, const struct hawser__lmode_system *system);
/* Inner product of a load and a displacement. */
double hawser__lmode_product(const double *load, const double *x,
                            const struct hawser__lmode_system *system);
/* x'K y, of displacements with their strains: of one with itself, twice the potential energy. */
double hawser__lmode_stiffness(const double *x, const double *strain, const double *y,
                               const double *other, const struct hawser__lmode_system *system);

/* Displacement of a pendulum from where it hangs. */
double hawser__lmode_stroke(const struct hawser__lmode_pendulum *one, const double *x,
                            const struct hawser__lmode_system *system);

/* Modes of a system. */
struct hawser__lmode_pairs {
	int n, iterations;
	int parts;              /* 1; of a rope that runs 2: real and imaginary part */
	double grid_for;        /* frequency that the grids resolve */
	double *omega, *error;  /* [n] ascending; estimated relative error */
	double *condition;      /* [n] of a rope that runs, else NULL */
	double *x, *strain;     /* [n][parts][size], [n][parts][strains] */
};
/* modes_iterate.c: the n lowest modes, on grids that resolve them; without strains and errors. */
enum hawser_status hawser__lmode_pairs(struct hawser__lmode_pairs *pairs,
                                      struct hawser__lmode_system *system,
                                      const struct hawser__lmode *rope, int n,
                                      struct hawser_report *report);
/* Carry them over to grids that are finer and resolve `omega`; sets strains and errors. */
enum hawser_status hawser__lmode_refine(struct hawser__lmode_pairs *pairs,
                                       struct hawser__lmode_system *system,
                                       const struct hawser__lmode *rope, double omega,
                                       struct hawser_report *report);
void hawser__lmode_pairs_clear(struct hawser__lmode_pairs *pairs);
/* New grids for `omega`; *x [vectors][size] and, unless NULL, *strain [vectors][strains] are
 * reallocated and interpolated. */
enum hawser_status hawser__lmode_regrid(double **x, double **strain, int vectors,
                                        struct hawser__lmode_system *system,
                                        const struct hawser__lmode *rope, double omega, int extra,
                                        struct hawser_report *report);
/* Number of modes of a system below `omega`, estimated; and the most that its grids can have. */
int hawser__lmode_count(const struct hawser__lmode_system *system, const struct hawser__lmode *rope,
                       double omega);
enum { HAWSER__LMODE_FINER = 3 }; /* more nodes of an element of a refined grid */

/* Which pair of which system a mode is. */
struct hawser__lmode_choice {
	int system, pair;
};
/* modes.c: the lowest modes of all systems together. */
struct hawser__lmode_search {
	struct hawser__lmode *rope;
	struct hawser__lmode_pairs *pairs;   /* [systems] */
	struct hawser__lmode_choice *choice; /* [n] ascending frequency */
	int n;
};
enum hawser_status hawser__lmode_search_open(struct hawser__lmode_search *search,
                                             struct hawser__lmode *rope, int n,
                                             struct hawser_report *report);
void hawser__lmode_search_clear(struct hawser__lmode_search *search);
/* Pairs of each system such that the n lowest are among them, and choice. */
enum hawser_status hawser__lmode_find(struct hawser__lmode_search *search,
                                      struct hawser_report *report);
/* Refine the n lowest modes on grids for `wider` times the highest frequency, and for `least`,
 * and choose again; *omega is what the grids resolve. Short spans may have modes far above, which those
 * grids would not resolve. */
enum hawser_status hawser__lmode_refine_all(double *omega, struct hawser__lmode_search *search,
                                            double wider, double least,
                                            struct hawser_report *report);
/* Largest estimated error of the n modes. */
double hawser__lmode_worst(const struct hawser__lmode_search *search);
/* Check lanes and options, whose zeros are replaced by defaults. */
enum hawser_status hawser__lmode_settle(struct hawser_line_modes_options *options,
                                        const struct hawser_line_statics *const *lane, int lanes,
                                        struct hawser_report *report);

/* modes_label.c: shares, family and sign of mode k from its shape. */
void hawser__lmode_label(struct hawser_line_modes *modes, const struct hawser__lmode *rope, int k);
static inline int hawser__lmode_parts(const struct hawser_line_modes *modes)
{
	return modes->gyroscopic ? 2 : 1;
}
/* Part `part` of mode k in an array [n][parts][points][3]. */
static inline double *hawser__lmode_row(double *of, const struct hawser_line_modes *modes, int k,
                                        int part)
{
	return of + (size_t)(k*hawser__lmode_parts(modes) + part)*3*(size_t)modes->points;
}
/* modes_fill.c: imaginary parts that are 0. */
enum hawser_status hawser__lmode_add_parts(struct hawser_line_modes *modes,
                                           struct hawser_report *report);
/* The public structure from the chosen modes, on the grids for `omega`. */
enum hawser_status hawser__lmode_fill(struct hawser_line_modes *modes,
                                      const struct hawser__lmode_search *search, double omega,
                                      struct hawser_report *report);

/* --- what moves in a rope over sheaves, before it is divided into systems --- */

/* Everything that moves in one plane, before it is divided into systems. */
struct hawser__lmode_draft {
	struct hawser__lmode *rope;
	enum hawser_plane plane;
	struct hawser__lmode_segment *segment;
	double *border_map;   /* [segments][ends][2][borders] */
	struct hawser__lmode_node *node;
	struct hawser__lmode_pendulum *pendulum;
	struct hawser__lmode_border *border;
	int *node_chain, *root; /* [nodes], [chains] */
	int segments, nodes, pendulums, borders, chains;
	int borders_most;
};

/* modes_systems.c: add the systems of the draft to its rope. */
enum hawser_status hawser__lmode_divide(struct hawser__lmode_draft *draft,
                                        struct hawser_report *report);

/* --- complex modes of a rope that runs over its sheaves --- */

/* As many modes as `resting`, on the same grids; the last of them may not have converged. */
enum hawser_status hawser__lmode_running(struct hawser__lmode_pairs *pairs,
                                         struct hawser__lmode_system *system,
                                         const struct hawser__lmode *rope,
                                         const struct hawser__lmode_pairs *resting,
                                         struct hawser_report *report);
/* Carry them over to finer grids that resolve `omega`; sets errors. */
enum hawser_status hawser__lmode_running_refine(struct hawser__lmode_pairs *pairs,
                                                struct hawser__lmode_system *system,
                                                const struct hawser__lmode *rope, double omega,
                                                struct hawser_report *report);

/* --- force, strain and displacement along one piece of rope --- */

/* out [D][points]: the derivative of the displacement, C F, and the strains, of the force F. */
void hawser__segment_gradient(double *out, const double *F, const struct hawser__lmode_segment *s);
void hawser__segment_strains(double *out, const double *F, const struct hawser__lmode_segment *s);
/* The force F with the ground's part: F += the integral of k X. Returns that over the whole length.
 * work [2][points] */
double hawser__segment_ground(double *F, const double *X, const struct hawser__lmode_segment *s,
                              double *work);
/* The part of the load in the end's displacement x[D] and force f[D], without displacement and force at
 * the beginning; F [D][points] keeps the force. work [6][points] */
void hawser__segment_load(double *x, double *f, double *F, const double *load,
                          const struct hawser__lmode_segment *s, double *work);
/* P of a segment without ground, and with. work [6][points] */
void hawser__segment_free(struct hawser__lmode_segment *s, double *work);
enum hawser_status hawser__segment_on_ground(struct hawser__lmode_segment *s, double *work,
                                             struct hawser_report *report);

/* Displacement of an end by value `dof` of its node, component c; -1: by a unit of border `border`. */
static inline double hawser__segment_reach(const struct hawser__lmode_system *t,
                                           const struct hawser__lmode_segment *s,
                    int end,
                    int c, int dof, int border)
{
	return border >= 0 ? s->border[(end*2 + c)*t->borders + border] : s->map[end][c][dof];
}

static inline int hawser__segment_dofs(const struct hawser__lmode_system *t,
                                       const struct hawser__lmode_segment *s, int end)
{
	return s->node[end] >= 0 ? t->node[s->node[end]].dofs : 0;
}

/* modes_equations.c: the band of the factors, for LAPACK. */
enum { HAWSER__BAND = 3, HAWSER__FACTOR_ROWS = 3*HAWSER__BAND + 1, HAWSER__SEGMENT_FIELDS = 6 };
/* What the rope pulls at border b: E0' F0 - E1' F(end), where F(end) = P10 X0 + P11 F0 + f. X0 is by
 * the unknowns and by the border values w, f [segments][2] by the load; each may be NULL. */
double hawser__lmode_pull(const struct hawser__lmode_system *t, int b, const double *unknown,
                          const double *w,
                   const double (*f)[2]);
/* modes_static.c: the motion of the held loop by a force along v, and its inertia; -1 without
 * memory. */
int hawser__lmode_circulation(struct hawser__lmode_system *t, const double *v);

#endif
