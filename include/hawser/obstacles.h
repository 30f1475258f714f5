/* hawser/obstacles.h - a span that passes over or under circles: its scene, and its statics with the
 * limits within which friction holds the rope.
 *
 * A scene of a span with the sections `obstacles` and `contact` (hawser-scene(5), OBSTACLES). The rope
 * is the one of line.h: exact catenaries and arcs, end A at the origin.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_OBSTACLES_H
#define HAWSER_OBSTACLES_H

#include <hawser/document.h>
#include <hawser/line_modes.h>

#ifdef __cplusplus
extern "C" {
#endif

/* What the circle itself does. FREE: it turns without resistance, so that friction does not change
 * the tension. DRIVE: it turns, or is held, as its motor wants; statics and modes are those of
 * LOCKED. */
enum hawser_rotation { HAWSER_ROTATION_LOCKED = 0, HAWSER_ROTATION_FREE, HAWSER_ROTATION_DRIVE };

struct hawser_obstacle {
	enum hawser_rotation rotation;
	double friction; /* coefficient of the scene; line.sheave has 0 if the circle turns freely */
	int groove;      /* 1: holds the rope in the vertical plane */
};

struct hawser_obstacles {
	char *name;                  /* file name; owned */
	struct hawser_line line;     /* without masses, at rest; line.sheave [line.sheaves] is owned. With
	                              * `lift`: a circle that the rope passes clear of is no error */
	struct hawser_obstacle *obstacle; /* [line.sheaves]; owned */
	int history;                 /* 1: contact.sliding: history, with the path: */
	double *path;                /* [stops] N or m: values of what `tension` gives before its own one,
	                              * the first without tangential forces; owned */
	int stops, winch;            /* winch: the end at which rope is paid in and out: 0: A, 1: B */
	int modes;                   /* enum hawser_line_contact_kind of contact.modes; -1: not given */
};

/* What an equilibrium at the limit of friction has, or why there is none. */
struct hawser_obstacles_limit {
	enum hawser_status status;   /* HAWSER_OK: `st` is filled in */
	struct hawser_report report;
	struct hawser_line_statics st;
};

/* States along the path of contact.sliding: history, from its first one to that of the scene. */
struct hawser_obstacles_path {
	int points;
	double *value;               /* [points] N or m, of what `tension` gives */
	double *T;                   /* [points][2] N, at ends A and B */
	double *grip;                /* [points][sheaves] part of the friction that acts, struct
	                              * hawser_line_sheave */
	double *slid;                /* [points][sheaves] m, unstretched rope that has passed the sheave
	                              * toward B since the first state, less what has passed toward A */
};

struct hawser_obstacles_statics {
	struct hawser_line line[4];      /* of the four equilibria below; they share the scene's sheaves,
	                                  * or `held` */
	struct hawser_line_sheave *held; /* [sheaves] with history: with what friction acts; else NULL */
	struct hawser_obstacles_path path; /* with history */
	struct hawser_line_statics st;   /* as the scene says */
	double error;                    /* estimated relative error of the tensions by round-off: a given
	                                  * length that is nearly the shortest way leaves few digits */
	/* The same unstretched rope between the ends without obstacles, B Figure 2.9. */
	struct hawser_obstacles_limit clear;
	int friction;                    /* 1: `slide` is filled in: contact.sliding is none or history, and
	                                  * a touched circle has friction */
	/* The rope about to slide toward end A [0], toward end B [1]; at rest it is between the two. */
	struct hawser_obstacles_limit slide[2];
};


/* Read the scene and apply `nset` overrides "path=value"; names of obstacles, or s0, s1 and so on, are
 * in a path such as "obstacles.s0.friction=0.2". *obstacles is overwritten; release it with
 * hawser_obstacles_clear. On failure it is all zero. Statuses: as hawser_scene_open. */
enum hawser_status hawser_obstacles_open(struct hawser_obstacles *obstacles, const char *path,
                                         const char *const *set, size_t nset,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;
/* The same from a document that was read before. */
enum hawser_status hawser_obstacles_of(struct hawser_obstacles *obstacles,
                                       const struct hawser_document *from,
                                       const char *const *set, size_t nset,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_obstacles_clear(struct hawser_obstacles *obstacles);

/* Solve. *st is overwritten; release it with hawser_obstacles_statics_clear. It has pointers to itself
 * and to the scene: it must not be moved, and the scene must exist. Statuses: those of
 * hawser_line_solve for the state that the scene describes; limits without an equilibrium, and a rope
 * that has none without obstacles, are no failure. */
enum hawser_status hawser_obstacles_solve(struct hawser_obstacles_statics *st,
                                          const struct hawser_obstacles *obstacles,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_obstacles_statics_clear(struct hawser_obstacles_statics *st);

/* The contact of the modes: *contact, and *loose is 1 without grooves. That of contact.modes or, if it
 * is not given, slip where no touched circle has friction or contact.sliding says that the rope
 * slides, else stick; stick is ROLL where the circles turn freely. HAWSER_ERR_ARGUMENT where there
 * are no modes for the scene: circles that turn freely beside others with stick, stick on a circle
 * without friction, grooves beside none. */
enum hawser_status hawser_obstacles_contact(enum hawser_line_contact_kind *contact, int *loose,
                                            const struct hawser_obstacles *obstacles,
                                            const struct hawser_line_statics *st,
                                            struct hawser_report *report) HAWSER_MUST_CHECK;

#ifdef __cplusplus
}
#endif
#endif
