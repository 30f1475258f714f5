/* hawser/scene.h - the scene: what the user wrote, in SI, checked against the table of keys.
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

/* What stays when the cable starts to travel: the tension that was given, or the unstretched length. */
enum hawser_hold { HAWSER_HOLD_TENSION = 0, HAWSER_HOLD_LENGTH };

enum hawser_branch { HAWSER_BRANCH_TAUT = 0, HAWSER_BRANCH_SLACK };

/* What becomes of the modes that are not kept: they follow the kept ones statically, or stand still. */
enum hawser_condensation { HAWSER_CONDENSE_STATIC = 0, HAWSER_CONDENSE_NONE };

/* Whether modes that follow have inertia: where it counts, shapes of it become coordinates. */
enum hawser_inertia { HAWSER_INERTIA_AUTO = 0, HAWSER_INERTIA_NONE };

/* The strain energy as a polynomial in a few modes' coordinates, or as it is on a whole basis. */
enum hawser_energy { HAWSER_ENERGY_QUARTIC = 0, HAWSER_ENERGY_EXACT };

enum hawser_damping_kind {
	HAWSER_DAMPING_NONE = 0,
	HAWSER_DAMPING_ALPHA,    /* alpha, kg/(m s) */
	HAWSER_DAMPING_RAYLEIGH, /* mass (1/s) * M + stiffness (s) * K */
	HAWSER_DAMPING_RATIO     /* the same fraction of critical in every mode */
};

/* How a scene gives a beam, which stands in the place of cable, span and tension. */
enum hawser_beam_form {
	HAWSER_BEAM_NONE = 0,
	HAWSER_BEAM_MU,    /* scaled by the bending rigidity, D (8.3.1) */
	HAWSER_BEAM_THETA, /* scaled by the tension, D (9.3.1); with theta = 0 a string, D (8.3.4) */
	HAWSER_BEAM_EI     /* in SI */
};
enum hawser_beam_weight {
	HAWSER_WEIGHT_NONE = 0,
	HAWSER_WEIGHT_GRAVITY,    /* by a word: along the travel, across it, none */
	HAWSER_WEIGHT_INCLINATION /* by the angle of the travel above the horizontal */
};
enum hawser_beam_gravity { HAWSER_GRAVITY_ALONG = 0, HAWSER_GRAVITY_ACROSS, HAWSER_GRAVITY_OFF };

enum hawser_frame { HAWSER_FRAME_LOCAL = 0, HAWSER_FRAME_GLOBAL };

/* model.modes of a scene that leaves the choice to the program (choose.h). */
enum { HAWSER_MODES_AUTO = 0 };

struct hawser_scene {
	struct {
		double EA;  /* N; INFINITY for an inextensible cable */
		double rho; /* kg per metre of unstretched length */
	} cable;
	struct {
		double d; /* horizontal distance of the ends, m, > 0 */
		double h; /* height of end B above end A, m */
	} span;
	double g; /* m/s^2 */
	struct {
		enum hawser_given given;
		double value; /* N or m, as given says */
		enum hawser_branch branch;
	} tension;
	struct {
		int present;
		double speed;       /* m/s of unstretched cable, from end A to end B */
		double fluctuation; /* m/s: the speed is speed + fluctuation*sin(Omega t) */
		enum hawser_hold hold;
		double braking;     /* s: the time from t = 0 in which the speed goes to `final`; 0: never */
		double final;       /* m/s */
	} travel;
	struct {
		enum hawser_damping_kind kind;
		double alpha;     /* kg/(m s) */
		double mass;      /* 1/s */
		double stiffness; /* s */
		double ratio;     /* fraction of critical */
	} damping;
	struct {
		int present;
		enum hawser_frame frame; /* local: along e, n, z; global: along x, y, z */
		double per_length[3];    /* N per metre of unstretched length, times cos(Omega t) */
		double extent[2];        /* loaded part, as fractions of the unstretched length */
	} load;
	struct {
		int modes;        /* number of modes kept in the reduced model, or HAWSER_MODES_AUTO */
		double accuracy;  /* relative error asked of folds and peaks; where modes are chosen */
		int basis;        /* functions a component; 0: chosen by the method for `tolerance` */
		double tolerance; /* relative error asked of the kept frequencies */
		enum hawser_condensation condense;
		enum hawser_inertia inertia;
		enum hawser_energy energy; /* exact: modes, tolerance and condense do not matter */
	} model;
	struct {
		enum hawser_beam_form form; /* _NONE: this is a scene of a cable */
		double mu, theta;           /* form MU, THETA */
		double rho, c, slenderness, v; /* scaled; slenderness L sqrt(A/I) of form MU, its inverse of
		                                * THETA, 0: no rotary inertia */
		double EI;          /* N m^2 */
		double rhoA;        /* kg/m */
		double L;           /* m */
		double tension_end; /* N, at the end where it leaves, x = L */
		double drag;        /* kg/(m s) */
		double gyration;    /* m, radius of gyration sqrt(I/A); 0: no rotary inertia */
		double speed;       /* m/s */
		enum hawser_beam_weight weight;
		enum hawser_beam_gravity gravity;
		double inclination; /* rad */
		int ends, moment;   /* enum hawser_beam_ends, hawser_beam_moment (beam.h) */
	} beam;
	char *name; /* file name, "<stdin>" for standard input; owned */
	unsigned long long written; /* bit i: the user gave row i of the table, no default */
};

/* One row of the table of keys: the only place that knows a key's name, unit, range, default and
 * meaning. Parsing, validation, --set, `hawser plan` and hawser-scene(5) all read it. */
struct hawser_scene_key {
	const char *path;    /* "cable.EA" */
	const char *unit;    /* udunits2 spelling of the SI unit; "1": pure number, "": word */
	const char *type;    /* "number", "integer", "numbers[3]", "numbers[2]", "word" */
	const char *words;   /* for a word: "taut|slack"; for an integer: the word that may stand for a
	                      * number and is kept as 0, "auto"; else NULL */
	const char *range;   /* for people: "> 0", "finite", "within [0, 1], increasing", "" */
	const char *fallback; /* default as text; NULL: required where its section is present */
	const char *doc;     /* one line */
};

/* Rows of the table, and their number in *count. Static storage. */
const struct hawser_scene_key *hawser_scene_keys(size_t *count);

/* Read a scene from `stream` (named `name` in messages) and apply `nset` overrides in order. An
 * override is what --set takes: "cable.EA=100 MN", "load.per_length=[1, 2, 3]", or a whole
 * section, "load={frame: local, per_length: [1, 2, 3]}". Of keys that exclude each other
 * (tension.H and tension.T0, the kinds of damping) an override displaces the one given before
 * it. *scene is overwritten; release it with hawser_scene_clear. On failure it is all zero.
 * Returns HAWSER_ERR_SCENE, HAWSER_ERR_IO (the stream, or the unit database), HAWSER_ERR_MEMORY,
 * and HAWSER_ERR_ARGUMENT where `stream` is a directory. */
enum hawser_status hawser_scene_read(struct hawser_scene *scene, FILE *stream, const char *name,
                                     const char *const *set, size_t nset,
                                     struct hawser_report *report) HAWSER_MUST_CHECK;

/* The same from a file name; "-" is standard input. HAWSER_ERR_ARGUMENT where there is no such
 * file, HAWSER_ERR_IO where it may not be read. */
enum hawser_status hawser_scene_open(struct hawser_scene *scene, const char *path,
                                     const char *const *set, size_t nset,
                                     struct hawser_report *report) HAWSER_MUST_CHECK;

/* Value of a key in SI, by its path: "cable.EA", "model.modes", "load.per_length[2]". A default in
 * use counts as a value. HAWSER_ERR_ARGUMENT when there is no such key, when its value is a word, or
 * when the scene does not have it (tension.H where T0 is given, load.extent without a load). */
enum hawser_status hawser_scene_get(const struct hawser_scene *scene, double *value,
                                    const char *path, struct hawser_report *report)
	HAWSER_MUST_CHECK;

/* Set a key that the scene has (as hawser_scene_get finds it) to a number in SI, as --set would. The
 * scene's name is not touched: a plain copy of a scene may be changed so, and is not to be cleared.
 * HAWSER_ERR_ARGUMENT as for _get; HAWSER_ERR_SCENE where the value is out of the key's range. */
enum hawser_status hawser_scene_set(struct hawser_scene *scene, const char *path, double value,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;

/* Value of a word: "taut" for "tension.branch", "auto" for "model.modes" where no number is given,
 * into word [HAWSER_WORD_SIZE]. HAWSER_ERR_ARGUMENT when it is no such key, when the scene does not
 * have it, or when it has a number there. */
enum { HAWSER_WORD_SIZE = 32 };
enum hawser_status hawser_scene_word(const struct hawser_scene *scene, char *word,
                                     const char *path, struct hawser_report *report)
	HAWSER_MUST_CHECK;

/* 1 where the user gave this key, 0 where it has its default or is absent or unknown. */
int hawser_scene_written(const struct hawser_scene *scene, const char *path);

/* Write the scene to `stream` as YAML in SI units, every number to its last digit, with the
 * defaults in use: reading it again gives the same values. HAWSER_ERR_IO where the stream fails. */
enum hawser_status hawser_scene_write(const struct hawser_scene *scene, FILE *stream,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;

/* Parse "0.3 Hz", "1.2 rad/s" or a plain number into the SI unit `unit` (udunits2 spelling). 1 Hz
 * is 2 pi rad/s, and units with and without an angle do not mix. ".inf" is a number here.
 * *value is left alone on failure: HAWSER_ERR_ARGUMENT for no number, NaN, an unknown unit or
 * a wrong dimension; HAWSER_ERR_IO where udunits2's database can't be read.
 *
 * This and hawser_scene_read use udunits2 behind a lock of their own, so any number of threads may
 * call them; a program that itself calls udunits2 meanwhile must keep apart from them. */
enum hawser_status hawser_unit_parse(double *value, const char *text, const char *unit,
                                     struct hawser_report *report) HAWSER_MUST_CHECK;

/* Free what the scene owns; leaves it all zero. NULL is legal. */
void hawser_scene_clear(struct hawser_scene *scene);

#ifdef __cplusplus
}
#endif
#endif
