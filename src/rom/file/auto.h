/* rom/file/auto.h - models as AUTO-07p equations and constants. See auto.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_AUTO_H
#define HAWSER_ROM_AUTO_H

#include <hawser/rom.h>

#include "rom/choose/drive.h"

/* --- rows.c: the forces of a model as one list of products, for exports --- */

/* value times wave h (0: 1; from 1: that of harmonic h - 1) times the product of states, on the right
 * side of equation j. States are u, then v; `damping`: of the D of the model. */
struct hawser__row {
	int j, h, damping, factors;
	int factor[HAWSER_TERM_FACTORS];
	double value;
};

/* *row [*rows] of a model, to be freed; NULL: memory is short. */
void hawser__rows(struct hawser__row **row, int *rows, const struct hawser_rom *rom);

/* What is written. */
struct hawser__auto {
	const struct hawser_rom *rom;   /* of its harmonics */
	const struct hawser__row *row;  /* [rows] */
	int rows;
	const double *coefficient;      /* [rows][degree + 1] Chebyshev sums over the parameter, in place of
	                                 * the values of the rows; NULL: these, degree 0 */
	int degree;
	const struct hawser__cycle *cycle; /* the first orbit of a forced response; or */
	const char *name;               /* the parameter of equilibria and limit cycles, and */
	double begin;                   /* its value at */
	const double *rest;             /* [n] the first equilibrium */
	const struct hawser_auto_options *options;
};

/* Write the files; on failure remove those that did not exist before. Steps of 0 in the options are not
 * allowed. HAWSER_ERR_ARGUMENT (the model, a name), HAWSER_ERR_IO, HAWSER_ERR_MEMORY. */
enum hawser_status hawser__auto_write(const struct hawser__auto *of, const char *stem,
                                      struct hawser_report *report);
/* Options of 0 get their defaults. HAWSER_ERR_ARGUMENT: what can't be exported. */
enum hawser_status hawser__auto_check(const struct hawser_rom *rom, const char *stem,
                                      struct hawser_auto_options *options,
                                      struct hawser_report *report);

#endif
