/* bench/estimates.h - stated errors against true ones: random scenes, statistics of the ratios, and
 * for each command a function that draws a scene, computes the result with its stated error, and
 * computes the true result by a much more accurate method.
 *
 *   ratio   true error over stated error of one number
 *
 * A scene depends on (seed, command, index) only, so that it can be repeated alone.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_BENCH_ESTIMATES_H
#define HAWSER_BENCH_ESTIMATES_H

#include <hawser/hawser.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>

/* --- draws --- */

struct chance {
	uint64_t state;
};

struct chance chance_at(uint64_t seed, uint64_t command, uint64_t scene);
double chance_unit(struct chance *chance); /* [0, 1) */
double chance_between(struct chance *chance, double low, double high);
double chance_log(struct chance *chance, double low, double high); /* uniform in the logarithm */
int chance_int(struct chance *chance, int low, int high); /* both included */

/* --- statistics --- */

struct ratios {
	double *ratio; /* [count] */
	int count, capacity;
};

struct tally {
	struct ratios all;    /* of numbers */
	struct ratios worst;  /* largest ratio of each scene */
	int scenes, refused;
	int exceeded, far_exceeded; /* number of scenes with a ratio above 1, above 10 */
	int number_exceeded;
	double here;          /* largest ratio of the present scene; negative: none yet */
	double divide;        /* divisor of the stated errors: 1, or another number to test the test */
	double show;          /* numbers with a larger ratio are printed; 0: none */
	int scene;
	int failed;           /* memory */
};

/* One number of the present scene: its true and its stated error, and a description for the list. */
void tally_note(struct tally *tally, double true_error, double stated, const char *format, ...)
	__attribute__((format(printf, 4, 5)));
void tally_scene(struct tally *tally, int refused); /* end of the present scene */
double tally_quantile(struct ratios *ratios, double part); /* sorts */
void tally_clear(struct tally *tally);

/* --- commands --- */

/* Draw a scene and note its numbers. Returns 1 if the command refused it, so that there is nothing
 * to compare. */
struct estimate {
	const char *name, *stated, *truth;
	int (*scene)(struct tally *tally, struct chance *chance);
};
extern const struct estimate estimates[];
extern const int estimates_count;

/* The scenes first to first + count - 1 of a seed. */
void estimate_run(struct tally *tally, const struct estimate *estimate, int first, int count,
                  uint64_t seed);

int estimate_statics(struct tally *tally, struct chance *chance);
int estimate_modes(struct tally *tally, struct chance *chance);
int estimate_campbell(struct tally *tally, struct chance *chance);
int estimate_irvine(struct tally *tally, struct chance *chance);
int estimate_frf(struct tally *tally, struct chance *chance);
int estimate_events(struct tally *tally, struct chance *chance);
int estimate_landmarks(struct tally *tally, struct chance *chance);
int estimate_accuracy(struct tally *tally, struct chance *chance);
int estimate_fixed(struct tally *tally, struct chance *chance);
int estimate_spans(struct tally *tally, struct chance *chance);
int estimate_masses(struct tally *tally, struct chance *chance);
int estimate_springs(struct tally *tally, struct chance *chance);
int estimate_ends(struct tally *tally, struct chance *chance);
int estimate_integrate(struct tally *tally, struct chance *chance);
int estimate_folds(struct tally *tally, struct chance *chance);
int estimate_hill(struct tally *tally, struct chance *chance);
int estimate_map(struct tally *tally, struct chance *chance);
int estimate_net(struct tally *tally, struct chance *chance);
int estimate_beam(struct tally *tally, struct chance *chance);
int estimate_beam_value(struct tally *tally, struct chance *chance);

/* A response, and its model. */
struct estimate_response {
	const struct hawser_frf *frf;
	const struct hawser_rom *rom;
	const struct hawser_statics *statics;
	const struct hawser_scene *scene;
	double from, to; /* scaled Omega */
};
/* Longest step of the responses, relative to the range: with twice as long ones, interpolation between
 * points is off by more than many of the errors. With these, differences below ESTIMATE_SURE tell
 * nothing. */
#define ESTIMATE_STEP 0.01
#define ESTIMATE_SURE 2e-4
/* Its true error. */
struct estimate_truth {
	double distance; /* from the response of the largest full-order model */
	double move;     /* distance of this one from the previous full-order response */
	int functions;   /* functions per component of that model */
};
/* Refine from the first number of functions above `more`, until the verdict about the stated error
 * does not change (estimates-reference.c). Returns 1 if two full-order responses cannot be
 * computed. */
int estimate_truth(struct estimate_truth *truth, const struct estimate_response *response, int more,
                   double stated);

/* The numbers of the response of one scene: with model.accuracy, and with n modes; what: ", with ..."
 * for the list. Both return 1 if there is nothing to compare. */
int estimate_reached(struct tally *tally, const struct hawser_statics *st,
                     const struct hawser_scene *scene, double from, double to, const char *what);
int estimate_kept(struct tally *tally, const struct hawser_statics *st,
                  const struct hawser_scene *scene, int n, double from, double to, const char *what);

/* A span with random horizontal tension *H. */
struct hawser_span estimate_span(struct chance *chance, double *H);
/* A reduced model of a random cable, or of coupled oscillators; strong: with folds. Returns 1 on
 * failure. */
int estimate_model(struct hawser_rom *rom, struct chance *chance, int strong);

#endif
