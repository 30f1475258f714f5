/* response/orbit/about.h - the linear model of small motions about the periodic response of a model.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_ABOUT_H
#define HAWSER_RESPONSE_ABOUT_H

#include <hawser/linear.h>

#include "response/floquet/hill_matrix.h"
#include "response/orbit/start.h"

/* All zero at the beginning. */
struct hawser__about {
	struct hawser_rom rom; /* K: mean of the tangent; its other harmonics are harmonics of K */
	struct hawser_harmonic *harmonic;
	double *K;             /* [2 spread + 1][n][n] */
	size_t room, room_h;   /* numbers allocated */
	double tolerance;      /* of the orbit; 0: 1e-8 */
	struct hawser_linear *linear; /* workspace of linear_n coordinates, or NULL */
	int linear_n;
	struct hawser__hill_matrix matrix;
	int unsure; /* 1: the response may lie behind a fold: where it has an odd number of real multipliers
	             * above 1, it is to be found again with */
	int slow;   /* 1: from rest, along fine orbits */
	int counts; /* 1: the caller has the multipliers: each response that is not slow is unsure */
	const struct hawser__way *guide; /* of the next response: the way of a model like it; or NULL */
};

/* The orbits that the response at the scaled frequency omega passes as all excitation is raised from 0
 * (start.h): none where it cannot be computed. HAWSER_ERR_MEMORY. */
enum hawser_status hawser__about_way(struct hawser__way *way, const struct hawser__way *guide,
                                     const struct hawser_rom *rom, double omega,
                                     struct hawser_report *report);

/* Set about->rom from the response at the scaled frequency omega that grows out of rest as all
 * excitation is raised from 0. It points to the D of `rom` and is valid as long as that, until the next
 * call. The response is computed anew, so that the result does not depend on other calls.
 * HAWSER_ERR_NO_SOLUTION: it has a fold, or is lost, before the whole excitation is reached, or the
 * linear response is infinite; HAWSER_ERR_ARGUMENT (drag, terms), HAWSER_ERR_CONVERGENCE,
 * HAWSER_ERR_MEMORY. */
enum hawser_status hawser__about_response(struct hawser__about *about, const struct hawser_rom *rom,
                                          double omega, struct hawser_report *report);
void hawser__about_clear(struct hawser__about *about);

#endif
