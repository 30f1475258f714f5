/* hawser/scene.h - the scene: the user's input, converted to SI and checked against the table of
 * keys.
 *
 * A scene is YAML (hawser-scene(5)). Reading is strict: an unknown, duplicate, missing or
 * contradictory key, a wrong unit or a value out of range is HAWSER_ERR_SCENE with a message that
 * names file, line, column, key, value, unit, and what to do.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_SCENE_H
#define HAWSER_SCENE_H

#include <stddef.h>
#include <stdio.h>
#include <hawser/document.h>
#include <hawser/status.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Which quantity fixes the tension of the span. */
enum hawser_given {
	HAWSER_GIVEN_NONE = 0,
	HAWSER_GIVEN_H,       /* horizontal tension, N */
	HAWSER_GIVEN_T0,      /* tension at S = 0, N */
	HAWSER_GIVEN_T1,      /* tension at S = L, N */
	HAWSER_GIVEN_LENGTH0, /* unstretched length, m */
	HAWSER_GIVEN_SAG      /* largest vertical distance from the chord, m */
};

/* Which quantity keeps its value when the cable travels: the given tension, or the unstretched
 * length. */
enum hawser_hold { HAWSER_HOLD_TENSION = 0, HAWSER_HOLD_LENGTH };

enum hawser_branch { HAWSER_BRANCH_TAUT = 0, HAWSER_BRANCH_SLACK };

/* The state to which the given tension belongs: the reference state, in which no static load acts
 * and the temperature has not changed, or the loaded one. Both have the same length of cable. */
enum hawser_state { HAWSER_STATE_REFERENCE = 0, HAWSER_STATE_LOADED };

/* Treatment of the modes that are not kept: static condensation (their coordinates are functions of
 * the kept ones), or truncation (their coordinates are 0). */
enum hawser_condensation { HAWSER_CONDENSE_STATIC = 0, HAWSER_CONDENSE_NONE };

/* Inertia of the condensed modes. AUTO: where it matters, shapes that represent it become further
 * coordinates. NONE: it is neglected. */
enum hawser_inertia { HAWSER_INERTIA_AUTO = 0, HAWSER_INERTIA_NONE };

/* Strain energy: a polynomial of degree 4 in the coordinates of a few modes, or the exact one, with
 * all functions of the basis as coordinates. AUTO: quartic, and exact where a response shows that
 * the polynomial is not good enough; builders of models take it as quartic. */
enum hawser_energy { HAWSER_ENERGY_QUARTIC = 0, HAWSER_ENERGY_EXACT, HAWSER_ENERGY_AUTO };

enum { HAWSER_RATIOS = 32 }; /* most values of damping.ratio */

enum hawser_damping_kind {
	HAWSER_DAMPING_NONE = 0,
	HAWSER_DAMPING_ALPHA,    /* alpha, kg/(m s) */
	HAWSER_DAMPING_RAYLEIGH, /* mass (1/s) * M + stiffness (s) * K */
	HAWSER_DAMPING_RATIO     /* a fraction of critical damping in each mode */
};

/* The parameters by which a scene describes a beam, which replaces cable, span and tension. */
enum hawser_beam_form {
	HAWSER_BEAM_NONE = 0,
	HAWSER_BEAM_MU,    /* scaled by the bending rigidity, D (8.3.1) */
	HAWSER_BEAM_THETA, /* scaled by the tension, D (9.3.1); with theta = 0 a string, D (8.3.4) */
	HAWSER_BEAM_EI     /* in SI */
};
enum hawser_beam_weight {
	HAWSER_WEIGHT_NONE = 0,
	HAWSER_WEIGHT_GRAVITY,    /* enum hawser_beam_gravity: along the travel, across it, none */
	HAWSER_WEIGHT_INCLINATION /* angle of the direction of travel above the horizontal */
};
enum hawser_beam_gravity { HAWSER_GRAVITY_ALONG = 0, HAWSER_GRAVITY_ACROSS, HAWSER_GRAVITY_OFF };

enum hawser_frame { HAWSER_FRAME_LOCAL = 0, HAWSER_FRAME_GLOBAL };

/* An attachment: a point mass on the cable, with springs and dampers from the same point to ground,
 * and a dead force, which is constant and has no inertia. All but local dampers act along the fixed
 * axes x, y, z.
 * Springs are unstressed in the static equilibrium, which they therefore don't change; nor do
 * dampers. */
enum { HAWSER_ATTACH_MAX = 32, HAWSER_NAME_SIZE = 32 };
struct hawser_attachment {
	double at;        /* position on the cable: fraction of the unstretched length from end A if
	                   * `by_length` is 0, else unstretched length in m */
	int by_length;
	double mass;      /* kg */
	double force[3];  /* N along x, y, z */
	double spring[3]; /* N/m along x, y, z */
	double damper[3]; /* N s/m along x, y, z, or along the axes of the cable at rest, */
	int damper_local; /* 1: tangent, normal and binormal; */
	int damper_to;    /* to the ground (0), or to what end A (1) or B (2) is fixed to */
	/* An absorber: a mass that moves along a fixed direction relative to the point, on a spring and a
	 * damper between both. Across this direction it moves with the point. */
	double absorber_mass;         /* kg; 0: none */
	double absorber_stiffness;    /* N/m, > 0 with a mass */
	double absorber_damping;      /* N s/m */
	double absorber_cubic;        /* N/m^3: force of the spring by the cube of the stroke from rest */
	double absorber_direction[3]; /* along x, y, z; of any length but 0 */
	char name[HAWSER_NAME_SIZE]; /* "" if it has none */
};

/* A piece of the varying load: a force per unstretched length on a part of the cable, which may be a
 * wave that runs along it; or a force at a point. It is multiplied by
 *
 *     cos(harmonic*Omega*t + phase - 2*pi*S/wave)
 *
 * with the unstretched length S from end A; without the last term if wave is 0. Pieces add to each
 * other and to the load of the section load. */
enum { HAWSER_LOADS_MAX = 32 };
struct hawser_load_piece {
	enum hawser_frame frame; /* of per_length or force */
	double per_length[3];    /* N per metre of unstretched length; all 0: a force at a point */
	double from;             /* loaded part: fractions of the unstretched length from end A if */
	int from_length;         /* `from_length`, `to_length` are 0, else unstretched lengths in m */
	double to;
	int to_length;
	double wave;             /* m of unstretched length; > 0: runs to end B, < 0: to end A */
	double force[3];         /* N */
	double at;               /* its point, like `from` */
	int at_length;
	int harmonic;            /* multiple of Omega, 1 to 20 */
	double phase;            /* rad */
	char name[HAWSER_NAME_SIZE]; /* "" if it has none */
};

/* A load case: the static load, the change of temperature and the speed of the wind in place of those
 * of the scene. */
enum { HAWSER_CASES_MAX = 32 };
struct hawser_case {
	char name[HAWSER_NAME_SIZE];
	int loaded, heated;   /* 0: no static load; no change of temperature */
	double per_length[3]; /* N/m, along x, y, z */
	double mass;          /* kg/m */
	double change;        /* K */
	double expansion;     /* 1/K, that of the scene if the case gives none */
	double wind;          /* m/s, 0: calm */
};

/* Wind across the cable: f = density diameter/2 |p| (C_D p + C_L R p) per unstretched length, with the
 * air's velocity p relative to the cable and normal to it, and its quarter turn R p, upwards for a wind
 * across the span (doc/theory-rom.md, "Wind"). */
enum { HAWSER_WIND_POWERS = 10, HAWSER_WIND_ROWS = 256 };
enum hawser_wind_form { HAWSER_WIND_CUBIC = 0, HAWSER_WIND_EXACT };
struct hawser_wind {
	int present;
	double speed;        /* m/s */
	double direction[3]; /* along x, y, z; of any length but 0 */
	double density;      /* kg/m^3 */
	double diameter;     /* m */
	double angle;        /* rad: angle of attack of the cable at rest */
	enum hawser_wind_form form;
	/* C_D and C_L as sums of powers 0, 1, ... of the angle of attack in rad; a length 0: a constant */
	double drag[HAWSER_WIND_POWERS], lift[HAWSER_WIND_POWERS];
	int drags, lifts;
	int profiles;        /* 0: the speed is the same along the cable */
	double profile[HAWSER_WIND_ROWS][2];  /* [profiles] fraction of the unstretched length, factor */
	int tables;          /* 0: drag and lift hold */
	double table[HAWSER_WIND_ROWS][3];    /* [tables] angle of attack, C_D, C_L */
	int crises;          /* 0: no dependence on Reynolds' number */
	double reynolds[HAWSER_WIND_ROWS][2]; /* [crises] |p| diameter/viscosity, C_D at the angle 0 */
	double viscosity;    /* m^2/s, kinematic; 0: not given */
	struct {
		int present;
		double strouhal;      /* vortices of a cable at rest: frequency strouhal U/diameter */
		double lift;          /* their lift coefficient */
		double A, epsilon;    /* of q'' + epsilon W (q^2 - 1) q' + W^2 q = A y''/diameter */
		double fluid_damping; /* damping per length fluid_damping W density diameter^2 */
		double added_mass;    /* over that of the displaced fluid */
		int places;           /* 0: an oscillator per mode */
	} wake;
};

/* Value of model.modes if the program chooses the modes (choose.h). */
enum { HAWSER_MODES_AUTO = 0 };

/* Room for the table of keys (hawser_scene_key). */
enum { HAWSER_SCENE_KEYS = 128 };

struct hawser_scene {
	struct {
		double EA;  /* N; INFINITY for an inextensible cable */
		double rho; /* kg per metre of unstretched length */
		double EI;  /* N m^2; 0: none */
	} cable;
	double ends[2]; /* N m per radian at ends A and B: 0 pinned, INFINITY clamped; only with EI */
	struct {
		double d; /* horizontal distance of the ends, m, > 0 */
		double h; /* height of end B above end A, m */
	} span;
	double g; /* m/s^2 */
	struct {
		enum hawser_given given;
		double value; /* N or m, depending on `given` */
		enum hawser_branch branch;
		enum hawser_state state; /* not read without static load and change of temperature */
	} tension;
	struct {
		int present;
		double speed;       /* m/s of unstretched cable, from end A to end B */
		double fluctuation; /* m/s: the speed is speed + fluctuation*sin(Omega t) */
		enum hawser_hold hold;
		double braking;     /* s: the speed changes to `final` during this time from t = 0; 0:
		                     * never */
		double final;       /* m/s */
	} travel;
	struct {
		int present;
		double stiffness[3]; /* N/m, along x, y, z; INFINITY: rigid */
		double mass;      /* kg, of an elastic support */
		/* set by hawser_statics_case: 1 if `force` (N, along x, y, z) is the force of the cable in
		 * the direction of +S at this end where the end is at its place */
		int placed;
		double force[3];
		double motion[3]; /* m, along x, y, z, times cos(harmonic*Omega*t + phase) */
		double phase;     /* rad */
		int harmonic;     /* multiple of Omega, 1 to 20 */
		int given[3];     /* not a key. 1: along x, y, z it moves as hawser_rom_motion_set says, and
		                   * motion of both ends is 0 */
	} support[2];             /* end A, end B */
	struct {
		enum hawser_damping_kind kind;
		double alpha;     /* kg/(m s) */
		double mass;      /* 1/s */
		double stiffness; /* s */
		double drag;      /* kg/m^2: force per length -drag |v| v, besides the kind; 0: none */
		double ratio;     /* fraction of critical damping, of mode 1 */
		double ratio_next[HAWSER_RATIOS - 1]; /* of the modes 2, 3, ... of a list, by their
		                                       * place; its last value holds for all above */
		int ratios;       /* length of the list; 0: no list, `ratio` holds for all modes */
	} damping;
	struct {
		int present;
		enum hawser_frame frame; /* local: along e, n, z; global: along x, y, z */
		double per_length[3];    /* N per metre of unstretched length, times cos(Omega t) */
		double extent[2];        /* loaded part, as fractions of the unstretched length */
	} load;
	struct {
		int present;
		int frame;            /* 0: global, the only one */
		double per_length[3]; /* constant, along x, y, z; N per metre of unstretched length */
		double mass;          /* of what adheres to the cable (ice), kg per metre of unstretched
		                       * length: its weight is added to per_length, its inertia to rho */
	} static_load;            /* the section load.static */
	struct {
		int present;
		double change;    /* K, from the reference state */
		double expansion; /* 1/K, relative change of the unstretched length */
	} temperature;
	struct {
		int modes;        /* number of modes kept in the reduced model, or HAWSER_MODES_AUTO */
		double accuracy;  /* required relative error of folds and peaks; used with MODES_AUTO
		                   * only */
		int basis;        /* functions per component; 0: the method chooses it for `tolerance` */
		double tolerance; /* required relative error of the kept frequencies */
		enum hawser_condensation condense;
		enum hawser_inertia inertia;
		enum hawser_energy energy; /* if exact, modes, tolerance and condense are not used */
	} model;
	struct {
		enum hawser_beam_form form; /* _NONE: the scene describes a cable */
		double mu, theta;           /* form MU, THETA */
		double rho, c, slenderness, v; /* scaled; slenderness L sqrt(A/I) of form MU, its inverse of
		                                * THETA, 0: no rotary inertia */
		double EI;          /* N m^2 */
		double rhoA;        /* kg/m */
		double L;           /* m */
		double tension_end; /* N, at the outlet, x = L */
		double drag;        /* kg/(m s) */
		double gyration;    /* m, radius of gyration sqrt(I/A); 0: no rotary inertia */
		double speed;       /* m/s */
		enum hawser_beam_weight weight;
		enum hawser_beam_gravity gravity;
		double inclination; /* rad */
		int ends, moment;   /* enum hawser_beam_ends, hawser_beam_moment (beam.h) */
	} beam;
	struct hawser_wind wind;
	int attachments;
	struct hawser_attachment attach[HAWSER_ATTACH_MAX]; /* [attachments] in the order of the scene */
	int loads;
	struct hawser_load_piece piece[HAWSER_LOADS_MAX]; /* [loads], the list `loads` */
	int cases;
	struct hawser_case load_case[HAWSER_CASES_MAX]; /* [cases] */
	char *name; /* file name, "<stdin>" for standard input; owned */
	unsigned char written[HAWSER_SCENE_KEYS]; /* [i] is 1 if the user gave the key of row i of the
	                                           * table */
};

/* One row of the table of keys. The table alone defines a key's name, unit, range, default and
 * meaning. Parsing, validation, --set, `hawser plan` and hawser-scene(5) all read it. */
struct hawser_scene_key {
	const char *path;    /* "cable.EA" */
	const char *unit;    /* udunits2 spelling of the SI unit; "1": pure number, "": word */
	const char *type;    /* "number", "integer", "numbers[3]", "numbers[2]", "series" (a number
	                      * or a list), "word", "place" (a fraction or a length), "name" */
	const char *words;   /* of a word: "taut|slack"; of an integer: the word that is accepted in
	                      * place of a number and stored as 0, such as "auto"; of a number: the words
	                      * for 0 and infinity, "pinned|clamped"; else NULL */
	const char *range;   /* as text: "> 0", "finite", "within [0, 1], increasing", "" */
	const char *fallback; /* default as text; NULL: required if its section is present */
	const char *doc;     /* one line */
};

/* Row `index` of the table of keys, from 0; NULL beyond the last. Static storage. */
const struct hawser_scene_key *hawser_scene_key(int index);

/* Read a scene from `stream` (called `name` in messages) and apply `nset` overrides in order. An
 * override has the syntax of --set: "cable.EA=100 MN", "load.per_length=[1, 2, 3]", or a whole
 * section, "load={frame: local, per_length: [1, 2, 3]}", which takes the place of all of it. A key
 * of an item of the lists attach, loads and cases is named by the number of the item, from 0, or by
 * its name: "attach.0.mass=20 kg", "attach.carrier.mass=20 kg". If two keys exclude each other
 * (tension.H and tension.T0, the kinds of damping), the override replaces the one given before.
 * *scene is overwritten; release it with hawser_scene_clear. On failure it is all zero. Returns
 * HAWSER_ERR_SCENE, HAWSER_ERR_IO (the stream, or the unit database), HAWSER_ERR_MEMORY, and
 * HAWSER_ERR_ARGUMENT if `stream` is a directory. */
enum hawser_status hawser_scene_read(struct hawser_scene *scene, FILE *stream, const char *name,
                                     const char *const *set, size_t nset,
                                     struct hawser_report *report) HAWSER_MUST_CHECK;

/* The same from a document that was read before. */
enum hawser_status hawser_scene_of(struct hawser_scene *scene, const struct hawser_document *from,
                                   const char *const *set, size_t nset,
                                   struct hawser_report *report) HAWSER_MUST_CHECK;

/* The same from a file name; "-" is standard input. Returns HAWSER_ERR_ARGUMENT if the file does
 * not exist, HAWSER_ERR_IO if it cannot be read. */
enum hawser_status hawser_scene_open(struct hawser_scene *scene, const char *path,
                                     const char *const *set, size_t nset,
                                     struct hawser_report *report) HAWSER_MUST_CHECK;

/* *to: a copy of the scene with the static load and the temperature of load case `index`, from 0 to
 * scene->cases - 1. It must not be cleared. Its tension is that of the scene: see
 * hawser_statics_case. */
void hawser_scene_case(struct hawser_scene *to, const struct hawser_scene *scene, int index);

/* Value of a key in SI, by its path: "cable.EA", "model.modes", "load.per_length[2]",
 * "attach.0.mass" (or with the name of the attachment). A key that
 * the user did not give has its default. Returns HAWSER_ERR_ARGUMENT if there is no such key, if
 * its value is a word, or if it does not apply to the scene (tension.H if T0 is given, load.extent
 * without a load). */
enum hawser_status hawser_scene_get(const struct hawser_scene *scene, double *value,
                                    const char *path, struct hawser_report *report)
	HAWSER_MUST_CHECK;

/* Set a key that hawser_scene_get finds to a number in SI, as --set does. The scene's name is not
 * changed, so that the function may be applied to a copy made by assignment; such a copy must not
 * be cleared. Returns HAWSER_ERR_ARGUMENT as _get does; HAWSER_ERR_SCENE if the value is outside
 * the key's range. */
enum hawser_status hawser_scene_set(struct hawser_scene *scene, const char *path, double value,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;

/* Value of a word: "taut" for "tension.branch", "auto" for "model.modes" if no number is given,
 * into word [HAWSER_WORD_SIZE]. Returns HAWSER_ERR_ARGUMENT if there is no such key, if it does not
 * apply to the scene, or if its value is a number. */
enum { HAWSER_WORD_SIZE = 32 };
enum hawser_status hawser_scene_word(const struct hawser_scene *scene, char *word,
                                     const char *path, struct hawser_report *report)
	HAWSER_MUST_CHECK;

/* 1 if the user gave this key, 0 if it has its default, is absent or is unknown. */
int hawser_scene_written(const struct hawser_scene *scene, const char *path);

/* Write the scene to `stream` as YAML in SI units, with the defaults in use. Numbers have as many
 * digits as are needed to read the same values again. Returns HAWSER_ERR_IO if the stream fails. */
enum hawser_status hawser_scene_write(const struct hawser_scene *scene, FILE *stream,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;

/* Parse "0.3 Hz", "1.2 rad/s" or a plain number into the SI unit `unit` (udunits2 spelling). 1 Hz
 * is 2 pi rad/s; a unit with an angle does not convert to one without. ".inf" is accepted as a
 * number. On failure *value is not changed. Returns HAWSER_ERR_ARGUMENT for text that is not a
 * number, NaN, an unknown unit or a wrong dimension; HAWSER_ERR_IO if the database of udunits2
 * cannot be read.
 *
 * This function and hawser_scene_read protect their calls of udunits2 by a lock, so that any number
 * of threads may call them. A program that calls udunits2 itself must not do so at the same
 * time. */
enum hawser_status hawser_unit_parse(double *value, const char *text, const char *unit,
                                     struct hawser_report *report) HAWSER_MUST_CHECK;

/* Write a unit in the base units of SI, "kg.m.s-2" for "N". On failure the text is empty, and the
 * statuses are those of hawser_unit_parse. */
enum hawser_status hawser_unit_base(char *text, size_t size, const char *unit,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;

/* Free what the scene owns and set it to zero. NULL is legal. */
void hawser_scene_clear(struct hawser_scene *scene);

#ifdef __cplusplus
}
#endif
#endif
