/* rom/terms/ends.h - displacement and strain by given motions of the ends, to second order. See ends.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_ENDS_H
#define HAWSER_ROM_ENDS_H

#include <hawser/rom.h>

#include "core/hold.h"
#include "rom/condense/support.h"

struct hawser_rom_ends {
	int given;            /* 1: the factors are the signals `number` of the model's history */
	int number[HAWSER__SUPPORT_MOST]; /* [count] of the shapes (support.h) */
	int count;            /* of quasi-static shapes (support.h) that move, 1 to HAWSER__SUPPORT_MOST */
	int terms;            /* harmonics of their factors, 0 if they are given */
	int *k;               /* [terms] */
	double *cosine;       /* [terms][count] */
	double *sine;         /* [terms][count] */
	int base;             /* all k are multiplied by this number (hawser_subharmonic_base) */
	double factor;        /* and all factors by this one (hawser__load_set) */
	double *slope;        /* [count][points][3] strains a, b, c at the shape points */
	double *line;         /* [count][line points][3] on the line */
	/* displacement and strains of condensed modes by products of the first `modes` coordinates and of
	 * the shapes with shapes; NULL if no modes are condensed. The product of shape i with coordinate k
	 * (k < modes) or shape k - modes has the index i*modes + i(i+1)/2 + k, k <= modes + i. */
	int modes;
	double *second_shape; /* [pairs][points][3] P, Q, B */
	double *second_slope; /* [pairs][points][3] a, b, c */
	double *second_line;  /* [pairs][line points][3] */
	struct hawser__hold hold; /* its arrays */
};

/* Number of products of shapes with coordinates or shapes. */
size_t hawser__ends_pairs(const struct hawser_rom_ends *ends);

/* rom->ends, with zeros, for its shape points and line; second: with the arrays second_*. */
enum hawser_status hawser__ends_make(struct hawser_rom *rom, int count, int terms, int second,
                                     struct hawser_report *report);
/* The same, with these signals [count] as factors. */
enum hawser_status hawser__ends_move(struct hawser_rom *rom, const struct hawser__signal *signal,
                                     int count, int second, struct hawser_report *report);
void hawser__ends_free(struct hawser_rom_ends *ends);

/* Give the model the shapes and motions of a scene, without condensed modes. */
enum hawser_status hawser__ends_set(struct hawser_rom *rom, const struct hawser_modes *modes,
                                    const struct hawser__support_shapes *shapes,
                                    const struct hawser_scene *scene, struct hawser_report *report);

struct hawser__condensed;
/* The second-order part, from the pairs `condensed` of modes->n modes of which `modes` and then the
 * shapes are the first. */
enum hawser_status hawser__ends_condensed(struct hawser_rom *rom, const struct hawser_modes *wide,
                                          const struct hawser__condensed *condensed,
                                          struct hawser_report *report);

/* s [count]: the factors at an instant, or their time derivatives. */
void hawser__ends_at(const struct hawser_rom *rom, double *s, const struct hawser_rom_moment *moment);
void hawser__ends_rate(const struct hawser_rom *rom, double *rate,
                       const struct hawser_rom_moment *moment);

/* out[3] += sum of the second-order fields at one point for coordinates u and factors s. field is
 * one of the arrays second_*, at point p of `points`. */
void hawser__ends_second(const struct hawser_rom_ends *ends, double out[3], const double *field,
                         int points, int p, const double *u, const double *s);
/* The same of its time derivative, of the velocities v and the rates of s. */
void hawser__ends_second_rate(const struct hawser_rom_ends *ends, double out[3], const double *field,
                              int points, int p, const double *u, const double *s, const double *v,
                              const double *rate);

#endif
