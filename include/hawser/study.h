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
struct hawser_survey;   /* internal to the library */

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
/* Row `index` of the table of fidelities, from 0, from cheap to accurate; NULL beyond the last. Static
 * storage. */
const struct hawser_fidelity *hawser_fidelity(int index);

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
	HAWSER_LANDMARK_TENSION,      /* of hawser_peaks only: a maximum of the largest tension, */
	HAWSER_LANDMARK_LEAST_TENSION /* or a minimum of the smallest tension */
};

/* A fold of the branch; or a peak, that is a local maximum, along the branch, of the amplitude of
 * one displacement component of a probe. */
struct hawser_landmark {
	enum hawser_landmark_kind kind;
	int probe, axis; /* of a peak: shape point and axis x, y, z (0, 1, 2); if the model has no shape
	                  * points, probe is -1 and axis is a coordinate. -1 for folds and tensions */
	int turn;        /* of a fold: 1: Omega has a maximum, -1: a minimum; otherwise 0 */
	double arc;      /* arclength along the branch */
	double omega;
	double size;     /* amplitude; of a fold the root of the sum of squares over all probes; of a
	                  * tension the magnitude of its change from the value at rest, N */
	double omega_error, size_error; /* estimated relative errors */
	double omega_orbits, size_orbits; /* the parts of these errors that are due to the errors of the
	                                   * orbits; the rest is due to interpolation between points */
	double rest;     /* of a tension: the largest or smallest value at rest, N; otherwise 0 */
	double follows;  /* of a tension: root of the sum of squares of the changes that the amplitudes
	                  * of the single coordinates cause, N; otherwise 0 */
	int stable;      /* of hawser_peaks only: 1: the orbit at the peak is stable */
};

/* Thresholds for peaks. */
struct hawser_landmark_options {
	double smallest;   /* least height of a peak of a component, relative to the largest amplitude
	                    * of that component on the branch; 0: 0.05 */
	double faintest;   /* least value of the largest amplitude of a component, relative to that of
	                    * all components; 0: 0.01 */
	double prominence; /* least prominence: the drop of the amplitude on either side before it rises
	                    * above the peak, relative to the peak; 0: 0.02 */
};
void hawser_landmark_settle(struct hawser_landmark_options *options);

/* The folds among the events of a traced response, followed by the peaks of each component of the
 * probes, each kind in the order of the branch, *count in all. The caller frees *landmark. options
 * may be NULL. HAWSER_ERR_MEMORY. */
enum hawser_status hawser_landmarks(struct hawser_landmark **landmark, int *count,
                                    const struct hawser_frf *frf,
                                    const struct hawser_landmark_options *options,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;

/* The peaks of a traced response of `rom`, *count of them; the caller frees *peak. They are the
 * peaks of every component of the probes that hawser_landmarks examines (of the coordinates if the
 * model has no probes), in the order of the branch, followed by the maxima of the largest tension
 * and the minima of the smallest tension if the model has tensions. If interpolation between the
 * points does not locate a peak to the relative error `wanted`, the branch near it is traced again
 * in shorter steps, with `options`, the options of the response. wanted = 0: nothing is traced
 * again. HAWSER_ERR_MEMORY. */
enum hawser_status hawser_peaks(struct hawser_landmark **peak, int *count,
                                const struct hawser_frf *frf, const struct hawser_rom *rom,
                                const struct hawser_frf_options *options, double wanted,
                                struct hawser_report *report) HAWSER_MUST_CHECK;

/* Limits within which landmarks of two models are considered the same: |ln(Omega1/Omega2)|/omega +
 * |ln(size1/size2)|/size is at most 1. */
struct hawser_match_options {
	double omega; /* 0: 0.1 */
	double size;  /* 0: 1 */
};
void hawser_match_settle(struct hawser_match_options *options);

/* partner [count]: index of the same landmark of the reference, or -1. Landmarks of one kind (folds
 * that turn the same way, peaks of the same component) are aligned in the order along the branch:
 * as many as possible, with the smallest sum of distances. options may be NULL. HAWSER_ERR_MEMORY. */
enum hawser_status hawser_landmarks_match(int *partner, const struct hawser_landmark *landmark,
                                          int count, const struct hawser_landmark *reference,
                                          int references,
                                          const struct hawser_match_options *options,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;

/* --- one fidelity's response --- */

struct hawser_study_curve {
	struct hawser_fidelity_choice choice;
	enum hawser_status status;   /* of the model and its response; if it failed, the other members
	                              * are undefined */
	struct hawser_report report; /* reason of the failure */
	int n, quads, cubics;        /* numbers of coordinates and of tensor entries of the model */
	double build_seconds, respond_seconds; /* wall time */
	double processor_seconds;    /* processor time of both, which other processes affect little */
	double estimated;            /* estimated relative error of folds and peaks, from the fidelity
	                              * itself; NAN: it has no estimate */
	int unreached;               /* 1: the requested accuracy was not reached */
	int probes;
	char probe[8][24];           /* [probes] names of the shape points */
	struct hawser_frf frf;       /* 0 points if the response is a closed form */
	struct hawser_landmark *landmark; /* [landmarks] */
	int landmarks;
	double tension, least_tension; /* N (SI): largest and smallest tension anywhere on the cable
	                                * over all orbits of the curve; NAN if there are none */
};

/* Compute the model and the response of one fidelity from options->from to options->to. If this
 * fails, curve->status and the returned status are the same, and curve->report has the reason. An
 * interrupted run returns HAWSER_OK with curve->frf.end HAWSER_END_INTERRUPTED; its peaks are not
 * traced again. Release with hawser_study_clear. */
enum hawser_status hawser_study_run(struct hawser_study_curve *curve,
                                    const struct hawser_statics *statics,
                                    const struct hawser_scene *scene,
                                    const struct hawser_fidelity_choice *choice,
                                    const struct hawser_frf_options *options,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;
/* The same for a model that is there, of a fidelity that builds one; build_seconds is 0. */
enum hawser_status hawser_study_model(struct hawser_study_curve *curve, struct hawser_rom *rom,
                                      const struct hawser_fidelity_choice *choice,
                                      const struct hawser_frf_options *options,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_study_clear(struct hawser_study_curve *curve);

/* Differences of a response from a reference response of the same scene and range. */
struct hawser_study_kind_error {
	int matched, missing, extra;
	double omega, size;  /* signed relative differences of largest magnitude among matched
	                      * landmarks; NAN if none is matched */
	int omega_at, size_at; /* index of the curve's landmark that has them; -1: none */
};
struct hawser_study_error {
	struct hawser_study_kind_error fold, peak;
	struct hawser_study_kind_error largest; /* over the largest peak of each component of the
	                                         * reference */
	double tension; /* signed relative difference; NAN if a curve has no tension */
	double floor;   /* largest estimated relative error of the landmarks of both curves; smaller
	                 * differences are not significant */
	int *partner;   /* [curve->landmarks] index of the reference's landmark, or -1 */
	double distance; /* of the two responses, as by hawser_accuracy_distance (accuracy.h): parts that
	                  * only one response has count too; NAN if one is a closed form */
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
