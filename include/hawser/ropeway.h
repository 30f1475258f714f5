/* hawser/ropeway.h - a ropeway: a scene of kind `ropeway`, and its statics.
 *
 * The hauling rope is a loop over a bullwheel in each station. Its two lanes lie in parallel
 * vertical planes: on lane `up` the running rope goes from the bottom station (end A) to the top
 * station (end B), on lane `down` back. Each lane passes the same towers, and each battery is one
 * sheave or a train of sheaves of a struct hawser_line (hawser/line.h). x is horizontal, from the
 * bottom to the top station; y upwards; S is the unstretched length of rope from the bottom
 * station, on both lanes.
 *
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROPEWAY_H
#define HAWSER_ROPEWAY_H

#include <stddef.h>
#include <hawser/document.h>
#include <hawser/line.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { HAWSER_ROPEWAY_NAME = 32 }; /* size of a name, with the NUL at its end */
enum { HAWSER_ROPEWAY_UP = 0, HAWSER_ROPEWAY_DOWN, HAWSER_ROPEWAY_LANES };

enum hawser_ropeway_battery {
	HAWSER_ROPEWAY_AUTO = 0,    /* chosen by the reaction of the joined catenaries, B (6.8) */
	HAWSER_ROPEWAY_SUPPORT,     /* the rope passes above */
	HAWSER_ROPEWAY_COMPRESSION  /* below */
};

/* What sets the tension at the bottom station. */
enum hawser_ropeway_tension {
	HAWSER_ROPEWAY_COUNTERWEIGHT = 0, /* N: the force on the carriage, of both lanes together */
	HAWSER_ROPEWAY_T0,      /* N: tension of each lane at the bottom station */
	HAWSER_ROPEWAY_LENGTH0, /* m: fixed carriage; unstretched length of the whole loop */
	HAWSER_ROPEWAY_EMPTY /* N: fixed carriage; the tension of the rope without carriers, at rest */
};

/* What the rope does on the sheaves as it vibrates: enum hawser_line_contact_kind (line_modes.h),
 * plus 1. */
enum hawser_ropeway_hold {
	HAWSER_ROPEWAY_HOLD_AUTO = 0, /* slip if the rope runs, stick if it is at rest */
	HAWSER_ROPEWAY_HOLD_SLIP,
	HAWSER_ROPEWAY_HOLD_STICK,
	HAWSER_ROPEWAY_HOLD_ROLL
};

/* How the rope moves over the batteries. */
enum hawser_ropeway_sliding {
	HAWSER_ROPEWAY_RUNNING = 0, /* as the drive pulls it: friction lets the tension grow towards B on
	                             * lane `up`, towards A on lane `down` */
	HAWSER_ROPEWAY_REST,        /* speed 0, without friction; what friction could hold is reported */
	HAWSER_ROPEWAY_REVERSE      /* the other way */
};

struct hawser_ropeway_tower {
	char name[HAWSER_ROPEWAY_NAME];
	double at[2];      /* m: where the rope touches a level battery: its highest point, of a compression
	                    * battery its lowest */
	enum hawser_ropeway_battery battery;
	double radius;     /* m, of the battery; 0: a point */
	double friction;
	int sheaves;       /* number of sheaves of a train; 0: one circle of the battery's radius */
	double spacing;    /* m, between their middles along the battery's circle */
	double sheave;     /* m, their radius */
	double inertia;    /* kg m^2, of each sheave about its axis, or of the circle: for modes */
	int file_line;     /* of the file, for messages; 0: not known */
};

struct hawser_ropeway_case {
	char name[HAWSER_ROPEWAY_NAME];
	double mass[HAWSER_ROPEWAY_LANES]; /* kg of each carrier; 0: none on this lane */
};

struct hawser_ropeway {
	char *name;        /* of the file */
	double g;
	double EA, rho;    /* N, kg/m per unstretched length */
	double bottom[2], top[2];         /* m: where the rope leaves the bullwheels */
	double bottom_radius, top_radius; /* m, of the bullwheels */
	enum hawser_ropeway_tension tension;
	double value;      /* of the tension, see there */
	double carriage;   /* kg, mass of the carriage of the bottom station, and of what moves with it; 0:
	                    * it does not vibrate */
	double bottom_inertia, top_inertia; /* kg m^2, of the bullwheels about their axes */
	double bottom_friction;           /* resistance of its bullwheel, as a part of the force on it */
	double travel[2];  /* m, stops of the carriage, from its place with the empty rope; > 0:
	                    * towards the line */
	int stops;         /* 1 if `travel` is given */
	double speed, ramp; /* m/s, s: of the drive */
	double drive_most;                /* N, largest force of the drive at the bullwheel; 0: no limit */
	double brake, brake_force;        /* m/s^2, or N at the bullwheel; 0: not given */
	double drive_friction, wrap;      /* of the rope on the drive bullwheel; rad */
	int drive;         /* 1 if drive.friction is given */
	int tension_line, drive_line; /* of the file: bottom.tension and drive; 0: not known */
	int coasts;        /* 1: drive.inertia is given, so that the drive bullwheel turns as the rope
	                    * vibrates; 0: it keeps its speed */
	enum hawser_ropeway_hold hold;
	enum hawser_ropeway_sliding sliding;
	struct hawser_ropeway_tower *tower; /* [towers] by x */
	int towers;
	int lanes;         /* 2; 1: lane `up` only */
	double spacing;    /* m, unstretched, between carriers; 0: no carriers */
	double mass[HAWSER_ROPEWAY_LANES], empty; /* kg, of a carrier; `empty`: without load */
	double hanger;     /* m */
	double phase;      /* m, S of the first carrier of lane `up` */
	double phase_down; /* m, of lane `down` when that of lane `up` is at `phase` */
	int sweep;         /* 1: phase: sweep; `phase` is then 0 */
	struct hawser_ropeway_case *load_case; /* [cases]; the first is that of the scene, "full" */
	int cases;
};

/* Read a scene of kind `ropeway`; `set` has overrides, such as "ropeway.towers.p3.friction=0.02". */
enum hawser_status hawser_ropeway_open(struct hawser_ropeway *ropeway, const char *path,
                                       const char *const *set /* [nset] */, size_t nset,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;
/* The same from a document that was read before. */
enum hawser_status hawser_ropeway_of(struct hawser_ropeway *ropeway,
                                     const struct hawser_document *from,
                                     const char *const *set, size_t nset,
                                     struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_ropeway_clear(struct hawser_ropeway *ropeway);

/* --- statics --- */

struct hawser_ropeway_options {
	int load_case;     /* index of a case */
	int tolerate; /* 1: batteries that the rope does not press, a drive that slips and a carriage
	               * beyond its stops are reported and not refused */
	int phases;        /* of a sweep, equidistant over the spacing; 0: 200 */
	int threads;       /* of a sweep; 0: hawser's default */
};
void hawser_ropeway_settle(struct hawser_ropeway_options *options);

/* The rope at a tower. */
struct hawser_ropeway_contact {
	int touches;       /* number of sheaves that the rope presses */
	double T_in, T_out; /* N, on the sides of A and B */
	double angle_in, angle_out; /* rad, slopes of the free rope on these sides */
	double wrap;       /* rad, angle of contact, of a train the deflection of the rope */
	double reaction[2]; /* N, of the battery on the rope */
	double pressing;   /* N, part of the reaction along the battery's side: > 0: the rope is
	                    * pressed on */
	double pressure;   /* N/m, least normal force per length of contact */
	double margin;     /* friction*wrap - |ln(T_out/T_in)|, of T - rho v^2 */
	double T_out_min, T_out_max; /* N, behind which friction would hold the rope at this T_in */
	double sheave_force; /* N, largest force of one sheave */
	double sheave_wrap;  /* rad, largest deflection at one sheave */
	double clearance;  /* m, from the rope, if it is not touched */
};

/* The free rope between two contacts. */
struct hawser_ropeway_span {
	double T_from, T_to;         /* N */
	double angle_from, angle_to; /* rad */
	double from[2], to[2];       /* m, its ends */
	double S_from, S_to;         /* m */
	double sag;                  /* m, largest vertical distance from the chord */
	double length0, length;      /* m, unstretched and stretched */
	double T_min, T_max;         /* N */
};

struct hawser_ropeway_lane {
	struct hawser_line *line;    /* *line, its sheaves and masses */
	struct hawser_line_statics st;
	int *first;                  /* [towers + 1] first sheave of each tower */
	struct hawser_ropeway_contact *contact; /* [towers] */
	struct hawser_ropeway_span *span;       /* [towers + 1] */
	int carriers;                /* on the rope: masses 0 to carriers - 1 of the line */
};

struct hawser_ropeway_statics {
	const struct hawser_ropeway *ropeway; /* the caller's; not released */
	double phase;                /* m */
	int load_case, lanes;
	struct hawser_ropeway_lane lane[HAWSER_ROPEWAY_LANES];
	double T0;                   /* N, tension at the bottom, without the resistance of its bullwheel */
	double weight;               /* N, force on the carriage */
	double loop0;                /* m, unstretched length of the loop */
	double travel; /* m, of the carriage from its place with the empty rope, towards the line;
	                * 0 of a fixed carriage */
	double force, power;         /* N, W: of the drive on the rope, in the direction of lane `up` */
	double needed_friction;      /* of the drive bullwheel */
	double drive_margin;         /* drive friction - needed_friction; NAN if the scene gives none */
	int lifted;                  /* number of towers that are not pressed */
	int slips, stopped;          /* 1: the drive slips; the carriage is beyond a stop */
};

/* The state for one phase (m). HAWSER_ERR_NO_SOLUTION: a battery is not pressed, the drive slips, the
 * carriage is beyond a stop, the tension is too small; the report says which, where and by how much.
 * HAWSER_ERR_ARGUMENT, _CONVERGENCE, _NAN, _MEMORY. */
enum hawser_status hawser_ropeway_solve(struct hawser_ropeway_statics *st,
                                        const struct hawser_ropeway *ropeway,
                                        const struct hawser_ropeway_options *options /* or NULL */,
                                        double phase, struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_ropeway_statics_clear(struct hawser_ropeway_statics *st);

/* --- worst values over the phases --- */

/* The range of a quantity, and the phases at its ends. */
struct hawser_ropeway_range {
	double min, max, at_min, at_max; /* at: m */
};

struct hawser_ropeway_tower_range {
	struct hawser_ropeway_range T, reaction_x, reaction_y, pressing, pressure, angle_in, angle_out,
		wrap, margin, sheave_force, sheave_wrap;
};
struct hawser_ropeway_span_range {
	struct hawser_ropeway_range T, sag, length0;
};
enum { HAWSER_ROPEWAY_ENVELOPE = 24 }; /* points of the envelope of a span */

struct hawser_ropeway_lane_range {
	struct hawser_ropeway_tower_range *tower; /* [towers] */
	struct hawser_ropeway_span_range *span;   /* [towers + 1] */
	/* Tension at points that divide each span evenly: places in the first phase, and ranges. */
	double (*place)[2];                     /* [towers + 1][HAWSER_ROPEWAY_ENVELOPE] m */
	struct hawser_ropeway_range *envelope;  /* [towers + 1][HAWSER_ROPEWAY_ENVELOPE] N */
	struct hawser_ropeway_range T;          /* anywhere */
	struct hawser_ropeway_range T_top;      /* at the top station */
	int span_min, span_max;                 /* spans in which T has its ends */
};

struct hawser_ropeway_worst {
	int towers, lanes, load_case;
	int phases, solved;  /* solved: less than phases only with options.tolerate */
	int ranges;
	struct hawser_ropeway_range *range;  /* [ranges] of the lanes, which point into it */
	struct hawser_ropeway_lane_range lane[HAWSER_ROPEWAY_LANES];
	struct hawser_ropeway_range T0, travel, force, power, needed_friction;
	double lifts_at, slips_at, stops_at; /* m: first phase at which a battery lifts, ..; NAN: none */
	int lifts, slips, stops, failed;     /* numbers of phases */
	struct hawser_report why;            /* of the first phase that failed */
};

/* Over options->phases phases. Without options->tolerate the first phase without an equilibrium is
 * refused, as hawser_ropeway_solve refuses it. */
enum hawser_status hawser_ropeway_sweep(struct hawser_ropeway_worst *worst,
                                        const struct hawser_ropeway *ropeway,
                                        const struct hawser_ropeway_options *options /* or NULL */,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_ropeway_worst_clear(struct hawser_ropeway_worst *worst);

#ifdef __cplusplus
}
#endif
#endif
