/* bench/estimates.h - errors that are stated against true ones: random scenes, the tally of their
 * ratios, and a command's way to draw a scene, to get the answer with its stated error, and to get the
 * true one by a much more accurate route.
 *
 *   ratio   true error over stated error of one number
 *
 * A scene depends on (seed, command, index) alone, so that a single one can be looked at again.
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

/* --- the tally --- */

struct ratios {
	double *ratio; /* [count] */
	int count, capacity;
};

struct tally {
	struct ratios all;    /* of numbers */
	struct ratios worst;  /* of scenes: the largest of each */
	int scenes, refused;
	int exceeded, far_exceeded; /* scenes with a ratio above 1, above 10 */
	int number_exceeded;
	double here;          /* largest ratio of the present scene; negative: none yet */
	double divide;        /* stated errors are divided by it: 1, or what a test of the test takes */
	double show;          /* numbers with a ratio beyond are printed; 0: none */
	int scene;
	int failed;           /* memory */
};

/* One number of the present scene: its true and its stated error, with what it is for the listing. */
void tally_note(struct tally *tally, double true_error, double stated, const char *format, ...)
	__attribute__((format(printf, 4, 5)));
void tally_scene(struct tally *tally, int refused); /* the present scene is done */
double tally_quantile(struct ratios *ratios, double part); /* sorts */
void tally_clear(struct tally *tally);

/* --- commands --- */

/* Draws a scene and notes its numbers; 1: refused, with no answer to compare. */
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
int estimate_integrate(struct tally *tally, struct chance *chance);
int estimate_folds(struct tally *tally, struct chance *chance);
int estimate_hill(struct tally *tally, struct chance *chance);
int estimate_map(struct tally *tally, struct chance *chance);
int estimate_beam(struct tally *tally, struct chance *chance);
int estimate_beam_value(struct tally *tally, struct chance *chance);

/* A response, and what it is of. */
struct estimate_response {
	const struct hawser_frf *frf;
	const struct hawser_rom *rom;
	const struct hawser_statics *statics;
	const struct hawser_scene *scene;
	double from, to; /* scaled Omega */
};
/* Its true error. */
struct estimate_truth {
	double distance; /* from the response of the largest full-order model that was traced */
	double move;     /* distance of that one from the full-order response before */
	int functions;   /* a component, of that model */
};
/* From the first number of functions beyond `more` on, as many as the verdict about the stated error
 * asks for (estimates-reference.c). 1: no two full-order responses can be had. */
int estimate_truth(struct estimate_truth *truth, const struct estimate_response *response, int more,
                   double stated);

/* A span whose H is drawn: *H. */
struct hawser_span estimate_span(struct chance *chance, double *H);
/* A reduced model: of a drawn cable, or of coupled oscillators; strong: one that folds. 1: there is
 * none. */
int estimate_model(struct hawser_rom *rom, struct chance *chance, int strong);

#endif
