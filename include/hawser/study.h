/* hawser/study.h - one scene at several fidelities: models of different cost and accuracy, the
 * frequency response of each, and the differences between these responses.
 *
 * Quantities are scaled (statics.h) unless the name or the comment says SI. The scale follows from
 * the statics and is the same for all fidelities of a scene.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STUDY_H
#define HAWSER_STUDY_H

#include <hawser/frf.h>

#ifdef __cplusplus
extern "C" {
#endif

struct hawser_study_curve;
struct hawser_plan_row; /* plan.h */
struct hawser_survey;   /* the library's own */

/* The meaning of the number of a fidelity, such as 9 in "raw 9". */
enum hawser_fidelity_number {
	HAWSER_NUMBER_MODES = 0,
	HAWSER_NUMBER_FUNCTIONS, /* functions per component of a basis */
	HAWSER_NUMBER_PERCENT    /* accuracy in percent, need not be a whole number */
};

/* A fidelity: name, summary of one line, source, meaning of its number, and three functions. */
struct hawser_fidelity {
	const char *name, *summary, *source;
	enum hawser_fidelity_number counts;
	int converges;       /* 1: as the number grows, the response converges to that of the scene */
	double usual;        /* default of the number; 0: the scene's model.accuracy */
	/* Builds the model of a scene whose statics are solved; NULL: `respond` builds the model.
	 * Statuses of hawser_modes_solve and hawser_rom_build. */
	enum hawser_status (*build)(struct hawser_rom *rom, const struct hawser_statics *statics,
	                            const struct hawser_scene *scene, double number,
	                            struct hawser_report *report);
	/* Computes the response: fills curve->landmark and, if the response is traced, curve->frf;
	 * without `build` also *rom. Statuses of hawser_frf_trace. */
	enum hawser_status (*respond)(struct hawser_study_curve *curve, struct hawser_rom *rom,
	                              const struct hawser_statics *statics,
	                              const struct hawser_scene *scene,
	                              const struct hawser_frf_options *options,
	                              struct hawser_report *report);
	/* Estimates cost and error (plan.h). */
	void (*estimate)(struct hawser_plan_row *row, const struct hawser_survey *survey);
};
/* The table of fidelities, [*count], from cheap to accurate. Static storage. */
const struct hawser_fidelity *hawser_fidelities(int *count);

/* A fidelity with its number: "condensed 16". */
enum { HAWSER_FIDELITY_NAME = 40 };
struct hawser_fidelity_choice {
	const struct hawser_fidelity *fidelity;
	double number;
	char name[HAWSER_FIDELITY_NAME];
};
/* Read a list such as "raw 5, raw 9, condensed:16, auto 0.5, full"; a whole number may also be a
 * range, "raw 5-9". choice [most], *count of them. HAWSER_ERR_ARGUMENT names the entry. */
enum hawser_status hawser_fidelities_read(struct hawser_fidelity_choice *choice, int *count,
                                          const char *list, int most,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;

/* --- landmarks: the features by which responses are compared --- */

enum hawser_landmark_kind {
	HAWSER_LANDMARK_FOLD = 0,
	HAWSER_LANDMARK_PEAK,
	HAWSER_LANDMARK_TENSION,      /* hawser_peaks alone: the tension's maximum has a peak, */
	HAWSER_LANDMARK_LEAST_TENSION /* or its minimum has a minimum */
};

/* A fold of the branch, or a peak: a largest amplitude, along the branch, of a probe's displacement
 * component. */
struct hawser_landmark {
	enum hawser_landmark_kind kind;
	int probe, axis; /* of a peak: shape point and axis x, y, z (0, 1, 2). If the model has no shape
	                  * points, probe is -1 and axis a coordinate. -1 of folds and of tensions */
	int turn;        /* of a fold: 1: Omega has a maximum, -1: a minimum; 0 of the others */
	double arc;      /* arclength along the branch */
	double omega;
	double size;     /* amplitude; of a fold the root of the sum of squares over all probes; of a
	                  * tension its change from the value at rest, positive, N */
	double omega_error, size_error; /* estimated relative errors */
	double omega_orbits, size_orbits; /* the parts of these that are due to the stated errors of the
	                                   * orbits; the rest is due to interpolation between points */
	double rest;     /* of a tension: the largest or smallest value at rest, N; 0 of the others */
	double follows;  /* of a tension: its change by the amplitude of each coordinate alone, root of
	                  * the sum of squares, N; 0 of the others */
	int stable;      /* set by hawser_peaks: 1: the orbit at the peak is stable */
};

/* Which peaks count. */
struct hawser_landmark_options {
	double smallest;   /* of a component's peak, relative to the component's largest amplitude on
	                    * the branch; 0: 0.05 */
	double faintest;   /* of a component's largest amplitude, relative to that of all; 0: 0.01 */
	double prominence; /* by how much the amplitude falls on either side before it rises above the
	                    * peak, relative to the peak; 0: 0.02 */
};
void hawser_landmark_settle(struct hawser_landmark_options *options);

/* The folds among the events of a traced response, then the peaks of each probe's components, each
 * kind in the order of the branch, *count in all; the caller frees *landmark. options may be NULL.
 * HAWSER_ERR_MEMORY. */
enum hawser_status hawser_landmarks(struct hawser_landmark **landmark, int *count,
                                    const struct hawser_frf *frf,
                                    const struct hawser_landmark_options *options,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;

/* The peaks of a traced response of `rom`, *count of them, the caller frees *peak: of every component
 * of the probes that hawser_landmarks looks at (of the coordinates of a model without probes), in the
 * order of the branch, then those of the largest tension and the minima of the least one, where the
 * model has tensions. Peaks that reading between the points does not locate to `wanted`, relative,
 * are traced again in shorter steps, with options as of the response; wanted = 0: no.
 * HAWSER_ERR_MEMORY. */
enum hawser_status hawser_peaks(struct hawser_landmark **peak, int *count,
                                const struct hawser_frf *frf, const struct hawser_rom *rom,
                                const struct hawser_frf_options *options, double wanted,
                                struct hawser_report *report) HAWSER_MUST_CHECK;

/* How far apart two landmarks may be and yet be the same one of two models: |ln Omega1/Omega2| over
 * `omega` plus |ln size1/size2| over `size` is at most 1. */
struct hawser_match_options {
	double omega; /* 0: 0.1 */
	double size;  /* 0: 1 */
};
void hawser_match_settle(struct hawser_match_options *options);

/* partner [count]: index of the reference's landmark that is the same one, or -1. Landmarks of one
 * kind (fold turning the same way, peak of the same component) are aligned in the order along the
 * branch: as many as possible of them, and with the smallest sum of distances. options may be NULL.
 * HAWSER_ERR_MEMORY. */
enum hawser_status hawser_landmarks_match(int *partner, const struct hawser_landmark *landmark,
                                          int count, const struct hawser_landmark *reference,
                                          int references,
                                          const struct hawser_match_options *options,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;

/* --- one fidelity's response --- */

struct hawser_study_curve {
	struct hawser_fidelity_choice choice;
	enum hawser_status status;   /* of the model and its response; the rest is void where it failed */
	struct hawser_report report; /* why */
	int n, quads, cubics;        /* the model's coordinates and tensor entries */
	double build_seconds, respond_seconds; /* wall time */
	double processor_seconds;    /* processor time of both: what a busy machine does not lengthen */
	double estimated;            /* relative error of folds and peaks, by the fidelity's own account;
	                              * NAN where it has none */
	int unreached;               /* it was asked for an accuracy that it did not come to */
	int probes;
	char probe[8][24];           /* [probes] names of the shape points */
	struct hawser_frf frf;       /* points is 0 where the response is a closed form */
	struct hawser_landmark *landmark; /* [landmarks] */
	int landmarks;
	double tension, least_tension; /* N (SI): extremes anywhere on the cable, of all the curve's
	                              * orbits; NAN where there are none */
};

/* Model and response of one fidelity over options->from to options->to. What fails is told in
 * curve->status and curve->report; so is it here, but an interrupted run is HAWSER_OK, with
 * curve->frf.end saying so, and peaks only as well known as they were met. Release with
 * hawser_study_clear. */
enum hawser_status hawser_study_run(struct hawser_study_curve *curve,
                                    const struct hawser_statics *statics,
                                    const struct hawser_scene *scene,
                                    const struct hawser_fidelity_choice *choice,
                                    const struct hawser_frf_options *options,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_study_clear(struct hawser_study_curve *curve);

/* What a response is off a reference of the same scene and range. */
struct hawser_study_kind_error {
	int matched, missing, extra;
	double omega, size;  /* largest relative differences of the matched ones, signed; NAN for none */
	int omega_at, size_at; /* the curve's landmark where they are; -1 for none */
};
struct hawser_study_error {
	struct hawser_study_kind_error fold, peak;
	struct hawser_study_kind_error largest; /* each component's largest peak of the reference */
	double tension; /* relative, signed; NAN where one of them has none */
	double floor;   /* the estimated relative error of the landmarks themselves, both curves'
	                 * largest: differences below it say nothing */
	int *partner;   /* [curve->landmarks] index into the reference's landmarks, or -1 */
};
enum hawser_status hawser_study_compare(struct hawser_study_error *error,
                                        const struct hawser_study_curve *curve,
                                        const struct hawser_study_curve *reference,
                                        const struct hawser_match_options *options,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_study_error_clear(struct hawser_study_error *error);

#ifdef __cplusplus
}
#endif
#endif
