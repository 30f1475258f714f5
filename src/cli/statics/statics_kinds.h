/* cli/statics/statics_kinds.h - what hawser statics does with each kind of scenes.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_STATICS_KINDS_H
#define HAWSER_CLI_STATICS_KINDS_H

#include <hawser/net.h>
#include <hawser/rod.h>

#include "cli/frame/kinds.h"
#include "cli/frame/view.h"

/* The first member of the command's settings: what other kinds than spans have of them. */
struct cli_statics_kinds {
	struct cli_common common;
	int points;                       /* of a profile: spans and obstacles */
	int cases;                        /* spans and ropeways */
	const char *method;               /* nets */
	int equilibria;                   /* nets */
	int profile;                      /* nets and ropeways */
	const char *load_case, *sliding;  /* ropeways */
	int spans, worst, phases, tolerate; /* ropeways */
	const char *vtk;                  /* rods and nets */
	const char *stiffness, *about;    /* nets */
	int load_steps;                   /* rods */
};
/* Their rows in the command's table; its `struct settings` has them as the member `kinds`. */
#define CLI_STATICS_KINDS_OPTIONS \
	{"method", 0, "NAME", "nets: how to find the equilibrium (automatic)", \
	 CLI_TEXT_FOR(kinds.method, CLI_NET)}, \
	{"profile", 0, "", "nets and ropeways: table of points along the cables", \
	 CLI_FLAG_FOR(kinds.profile, CLI_NET | CLI_ROPEWAY), .excludes = "cases"}, \
	{"equilibria", 0, "N", "nets: all equilibria of bars instead of cables, from N random starts", \
	 CLI_COUNT_FOR(kinds.equilibria, CLI_NET)}, \
	{"stiffness", 0, "NODES", "nets: table of the stiffness at nodes that move together, as one body", \
	 CLI_TEXT_FOR(kinds.stiffness, CLI_NET), .excludes = "profile, equilibria"}, \
	{"about", 0, "X,Y,Z", "nets: with turns about axes through this place", \
	 CLI_TEXT_FOR(kinds.about, CLI_NET), .needs = "stiffness"}, \
	{"spans", 0, "", "ropeways, obstacles: table of the spans", \
	 CLI_FLAG_FOR(kinds.spans, CLI_ROPEWAY | CLI_OBSTACLES), .excludes = "worst, profile, cases"}, \
	{"worst", 0, "", "ropeways: table of the worst values over the phases", \
	 CLI_FLAG_FOR(kinds.worst, CLI_ROPEWAY), .excludes = "profile, cases"}, \
	{"phases", 0, "N", "ropeways: number of phases of the carriers (200)", \
	 CLI_COUNT_FOR(kinds.phases, CLI_ROPEWAY)}, \
	{"case", 0, "NAME", "ropeways: the load case (full)", CLI_TEXT_FOR(kinds.load_case, CLI_ROPEWAY)}, \
	{"sliding", 0, "HOW", "ropeways: running, rest or reverse (the scene's ropeway.sliding)", \
	 CLI_TEXT_FOR(kinds.sliding, CLI_ROPEWAY)}, \
	{"tolerate", 0, "", "ropeways: report what lifts, slips or is at its stop, and refuse nothing", \
	 CLI_FLAG_FOR(kinds.tolerate, CLI_ROPEWAY)}, \
	{"load-steps", 0, "N", "rods: equal steps in which the load is raised (1)", \
	 CLI_COUNT_FOR(kinds.load_steps, CLI_ROD)}, \
	{"vtk", 0, "FILE", "rods and nets: write the shape to FILE.vtk, for programs such as ParaView", \
	 CLI_TEXT_FOR(kinds.vtk, CLI_MESHES)}

/* Tables of the kinds, for their records (cli/frame/kinds.h). */
extern const struct cli_listing cli_statics_net_listing[], cli_obstacles_listing[],
                                cli_ropeway_listing[], cli_rod_listing[];

/* --- what hawser statics shows of a scene of kind `rod` --- */

struct cli_rod {
	const struct cli_common *common;
	struct hawser_rod scene;
	struct hawser_rod_statics st;
	int stable;     /* 1, 0; HAWSER__NO_INTEGER: not judged */
	double error_x, error_N, error_M; /* NAN: not known */
	char warning[CLI_WARNING_SIZE]; /* "": none */
};

/* rod_fields.c; CLI_ROD_WATER: what a rod in water has besides */
enum { CLI_ROD_WATER = 1 };
extern const struct hawser__field cli_rod_number_field[], cli_rod_field[];
extern const struct hawser__list cli_rod_point_list;

/* --- statics_net.c: equilibria of bars in place of the cables of a net --- */

/* All equilibria of bars in place of the cables, from so many random starts. */
enum hawser_status cli_equilibria_net(const struct cli_common *common, int starts,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
extern const struct hawser__field cli_equilibria_net_field[], cli_equilibria_net_member[];

/* --- statics_mesh.c: hawser statics --model fe: a mesh in place of the catenary --- */

extern const struct hawser__field cli_statics_mesh_field[]; /* of a struct hawser_net_span_statics */
void cli_statics_mesh_comments(struct hawser__table *table,
                               const struct hawser_net_span_statics *mesh);
/* Whether the options --model, --elements and --points go together. */
enum hawser_status cli_statics_mesh_check(const char *model, int points, int usual,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;
/* The mesh; its nodes are the *profile [mesh->points], which the caller frees. */
enum hawser_status cli_statics_mesh(struct hawser__spot **profile,
                                    struct hawser_net_span_statics *mesh,
                                    const struct hawser_scene *scene,
                                    const struct hawser_statics *statics, int elements,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;

/* --- stiffness_net.c: hawser statics --stiffness: the stiffness of a net at its nodes --- */

struct cli_stiffness {
	int rows; /* 0: not asked for */
	struct hawser_net_stiffness of;
};
/* nodes: names between commas, or NULL; about: "x,y,z", each a number in m or with a unit, or NULL. */
enum hawser_status cli_stiffness_fill(struct cli_stiffness *stiffness, const struct hawser_net *net,
                                      const char *nodes, const char *about,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
void cli_stiffness_comments(struct hawser__table *table, const struct cli_stiffness *stiffness);

/* Options of the view: stiffness is asked for; and of turns. */
enum { CLI_STIFFNESS = 4, CLI_STIFFNESS_TURNS = 8 };
/* Columns; rows of the parent's member `stiffness`; members of JSON. */
extern const struct hawser__field cli_stiffness_field[], cli_stiffness_member[];
extern const struct hawser__list cli_stiffness_list;

/* --- contacts_net.c: what a net touches, in the output of hawser statics and modes --- */

/* A comment for each obstacle, and how well the contacts are solved. */
void cli_contacts_comments(struct hawser__table *table, const struct hawser_net *net,
                           const struct hawser_net_statics *st);
/* `contacts`, a list of objects. */
struct cli_contacts {
	const struct hawser_net *net;
	const struct hawser_net_contact *contact; /* [contacts] */
	int contacts;
	double apart;
};
extern const struct hawser__field cli_contacts_field[], cli_apart_field[];
/* The points along the cables, with their tensions and what they touch: contact is an enum
 * hawser_net_contact_state. */
enum hawser_status cli_contacts_vtk(const char *path, const struct hawser_net *net,
                                    const struct hawser_net_statics *st,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;
/* Of a point of the profile: the obstacle, the forces of the contact, and its state. */
struct cli_touch {
	const char *obstacle, *state; /* "-", "open" */
	double r_N, r_T;
};
struct cli_touch cli_contacts_at(const struct hawser_net *net, const struct hawser_net_statics *st,
                                 const struct hawser_net_point *point);

/* --- statics_loaded.c: what hawser statics shows of a loaded span, and the points of its
 * profile --- */

struct cli_loaded {
	int present; /* 0: the scene has neither static load nor change of temperature */
	enum hawser_state state;
	struct hawser_statics reference;
	double swing, sag_vertical, blowout; /* rad, m, m */
	double force[3];                     /* N/m, along x, y, z */
	double pull[2][3];                   /* N, on supports A and B, along x, y, z */
	int elastic;                         /* 1: the supports are */
	double moved[2][3], imbalance;       /* m, N: of struct hawser_statics */
};
extern const struct hawser__field cli_loaded_field[];
extern const struct hawser__field cli_statics_field[]; /* of a struct hawser_statics */
void cli_loaded_comments(struct hawser__table *table, const struct cli_loaded *loaded);
/* Where the ends on springs are, in the state or case `name`. */
void cli_moved_comment(struct hawser__table *table, const char *name, const struct cli_loaded *loaded);

/* From the state of the scene, at rest or travelling (with the apparent quantities). */
enum hawser_status cli_loaded_fill(struct cli_loaded *loaded, const struct hawser_statics *statics,
                                   const struct hawser_scene *scene, struct hawser_report *report)
	HAWSER_MUST_CHECK;

/* A point of the profile along the axes of the scene. */
struct hawser__spot cli_place(const struct hawser_statics *st,
                              const struct hawser_profile_point *in);

/* An attachment: at a mass the tension has two values. */
struct cli_mark {
	const char *name;
	double mass, kink; /* kg; rad, angle between the tangents on both sides */
	struct hawser__spot before, after;
};
extern const struct hawser__field cli_mark_field[];
/* Fills mark[attachments] and returns their number. */
int cli_marks_fill(struct cli_mark *mark, const struct hawser_statics *st,
                   const struct hawser_scene *scene);
void cli_marks_comments(struct hawser__table *table, const struct cli_mark *mark, int marks);

/* A row of --cases: the reference state, and each case. */
struct cli_case {
	const char *name, *why;
	int status; /* 0, or why it has no solution */
	struct hawser_report report;
	double H, T0, T1, sag, length0, length;
	struct cli_loaded loaded;
};
struct cli_cases {
	struct cli_case *row; /* [rows], the caller frees it */
	int rows;
};
extern const struct hawser__field cli_case_field[], cli_cases_member[];
/* HAWSER_ERR_ARGUMENT if the scene has no cases; the status of the first one if none has a solution. */
enum hawser_status cli_cases_fill(struct cli_cases *cases, const struct hawser_scene *scene,
                                  struct hawser_report *report) HAWSER_MUST_CHECK;
/* axis: of tensions. */
enum hawser_status cli_cases_draw(const char *path, const struct cli_cases *cases,
                                  const struct hawser__axis *axis, struct hawser_report *report)
	HAWSER_MUST_CHECK;
void cli_cases_rows(struct hawser__table *table, const struct cli_cases *cases);

/* --- statics_obstacles.c: what hawser statics and modes show of a span over obstacles --- */

enum { CLI_OBSTACLES_SPAN = 2*HAWSER_LINE_NAME + 4 };

/* An obstacle, and what the rope does there. */
struct cli_obstacle {
	const char *name, *side, *rotation;
	int touches;
	struct hawser_line_contact c;
	double H_in, H_out;     /* N, horizontal tensions before and behind */
	double pressing;        /* N, force by which the rope is pressed on the circle */
	double from[2], to[2];  /* m, first and last point of contact */
};

/* A free part of the rope. */
struct cli_obstacle_span {
	char name[CLI_OBSTACLES_SPAN]; /* "A to s0" */
	const char *label;             /* the same */
	double H, T_from, T_to, angle_from, angle_to, length0, sag;
	double from[2], to[2];         /* m */
	double H_toward[2];            /* N, about to slide toward A, toward B; NAN: not known */
};

/* A point of the rope, and the height of the same rope without obstacles. */
struct cli_obstacle_point {
	double S, x, y, angle, T, y_clear;
};

struct cli_obstacles {
	const struct cli_common *common;
	int spans_wanted;               /* 1: table of the spans */
	struct hawser_obstacles scene;
	struct hawser_obstacles_statics st;
	struct cli_obstacle *obstacle;  /* [obstacles] */
	struct cli_obstacle_span *span; /* [spans] */
	struct cli_obstacle_point *point; /* [points] */
	int obstacles, spans, points;
};

enum { CLI_OBSTACLES_FRICTION = 1, CLI_OBSTACLES_CLEAR = 2 }; /* bits of the view */

/* obstacles_fill.c: read the scene and solve it; rows from the state, with this number of points. */
enum hawser_status cli_obstacles_fill(struct cli_obstacles *of, int points,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
/* Warnings of obstacles that the rope passes without contact. */
void cli_obstacles_warn(const struct cli_obstacles *of);
void cli_obstacles_clear(struct cli_obstacles *of);

/* obstacles_fields.c */
extern const struct hawser__list cli_obstacle_span_list, cli_obstacle_point_list;
extern const struct hawser__field cli_obstacle_field[], cli_obstacles_field[];
unsigned cli_obstacles_view(const struct cli_obstacles *of);

/* --- statics_ropeway.c: what hawser statics shows of a ropeway --- */

enum { CLI_ROPEWAY_SPAN = 2*HAWSER_ROPEWAY_NAME + 4 };

/* A tower on one lane. */
struct cli_ropeway_tower {
	const char *lane, *name, *battery;
	struct hawser_ropeway_contact c;
	const struct hawser_ropeway_tower_range *range; /* or NULL */
};
struct cli_ropeway_span {
	const char *lane;
	char name[CLI_ROPEWAY_SPAN]; /* "p0 to p1" */
	const char *label;           /* the same */
	struct hawser_ropeway_span s;
	const struct hawser_ropeway_span_range *range; /* or NULL */
};
struct cli_ropeway_point {
	const char *lane;
	double S, x, y, angle, T;
};
/* The ranges of a tower, for the table. */
struct cli_ropeway_worst {
	const char *lane, *name;
	struct hawser_ropeway_tower_range r;
};
struct cli_ropeway_case {
	const char *name, *why;
	int status;
	struct hawser_report report;
	int phases, lifts, slips, stops, failed;
	struct hawser_ropeway_range T, travel, force, needed_friction;
	const char *T_lane, *press_lane, *press_tower;
	char T_span[CLI_ROPEWAY_SPAN], sag_span[CLI_ROPEWAY_SPAN];
	const char *T_where, *sag_where;
	double pressing, pressing_at, sag, sag_at;
};

struct cli_ropeway_lane {
	const struct hawser_ropeway_lane *lane; /* NULL: down is off */
	const struct hawser_ropeway_lane_range *range; /* or NULL */
	struct cli_ropeway_tower *tower; /* [towers] */
	struct cli_ropeway_span *span;   /* [spans] */
	int towers, spans;
};

struct cli_ropeway {
	const struct cli_common *common;
	const struct cli_statics_kinds *kinds;
	struct hawser_ropeway ropeway;
	struct hawser_ropeway_options options;
	struct hawser_ropeway_statics st;
	struct hawser_ropeway_worst worst;
	int swept;                       /* 1: `worst` is filled in */
	struct cli_ropeway_lane lane[HAWSER_ROPEWAY_LANES];
	struct cli_ropeway_tower *tower; /* [towers] of both lanes */
	struct cli_ropeway_span *span;   /* [spans] */
	struct cli_ropeway_point *point; /* [points] */
	struct cli_ropeway_worst *range; /* [towers], if swept */
	struct cli_ropeway_case *load_case; /* [cases] */
	int towers, spans, points, cases;
};

/* ropeway_fill.c: rows from the state and from the worst values. */
enum hawser_status cli_ropeway_fill(struct cli_ropeway *of,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;
enum hawser_status cli_ropeway_points(struct cli_ropeway *of,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
enum hawser_status cli_ropeway_cases(struct cli_ropeway *of,
                                     struct hawser_report *report) HAWSER_MUST_CHECK;
void cli_ropeway_clear(struct cli_ropeway *of);
/* ropeway_fields.c */
extern const struct hawser__field cli_ropeway_field[], cli_ropeway_case_field[];
extern const struct hawser__list cli_ropeway_tower_list, cli_ropeway_span_list, cli_ropeway_worst_list,
                                 cli_ropeway_case_list, cli_ropeway_point_list;
enum { CLI_ROPEWAY_SWEPT = 1, CLI_ROPEWAY_PROFILE = 2, CLI_ROPEWAY_CASES = 4 }; /* bits of the view */

#endif
