/* rom/energy/kernel.h - the compiled form of a model.
 *
 * With symmetric splitting of every monomial over its indices, the restoring force is G(u) u, where
 *
 *     G_jk(u) = K_jk + sum_l A_jkl u_l + sum_{l<=m} B_jk,lm u_l u_m
 *
 * and its Jacobian is K + 2 A(u) + 3 B(u): force and tangent come out of the same two sparse
 * matrix-vector products, whose columns are u and the products u_l u_m. When the tensors come from
 * a potential, G is symmetric and only its lower half is stored.
 *
 * A row is stored as runs of neighbouring columns, multiplied four at a time. Columns are ordered by
 * the set of rows in which they appear, so that parity (in-plane and out-of-plane) makes long runs
 * and not a comb; gaps shorter than a vector are filled with zeros.
 *
 * For many states at once the vectors run over the states instead, HAWSER_LANES of them: no sum
 * across a vector, no zeros, and rows with the same columns are taken up to four together (a panel),
 * so that a product u_l u_m is loaded once for them all.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_KERNEL_H
#define HAWSER_ROM_KERNEL_H

#include <stddef.h>

#include <hawser/rom.h>

#include "core/hold.h"

/* --- effort.c: which of the two forms of the energy is evaluated: tensors or functions --- */

/* What is evaluated: a force, or a force with its tangent; at one state, or at each of several in
 * one call. */
enum hawser__effort_task {
	HAWSER__FORCE,
	HAWSER__TANGENT,
	HAWSER__FORCES,
	HAWSER__TANGENTS,
	HAWSER__TASKS
};

/* Estimated times in nanoseconds for each task. */
struct hawser__effort {
	double tensors[HAWSER__TASKS];
	double functions[HAWSER__TASKS];
};

/* The size of a model. */
struct hawser__size {
	int n, in, out;        /* coordinates; modes in the plane and out of it */
	int points;            /* of the grid */
	int condensed;
	double cubics;         /* entries of C */
};

void hawser__effort(struct hawser__effort *effort, const struct hawser__size *size);

/* Additions and multiplications of a force, or of force and tangent, by functions. */
double hawser__function_flops(const struct hawser__size *size, int tangent);

/* Largest number of coordinates of a model of a cable, and of one from a file: the hot loops store u_l
 * u_m on the stack. */
#define HAWSER_ROM_MAX 100
#define HAWSER_ROM_MOST 400
#define HAWSER_ROM_MOST_PAIRS (HAWSER_ROM_MOST*(HAWSER_ROM_MOST + 1)/2)

/* `blocks` vectors of four values from value[at], against the columns from `col`. */
struct hawser__run {
	int col, blocks;
	int at;
};

/* Row r of G: the entry (j, k), its constant part, and its runs in A and in B. */
struct hawser__kernel_row {
	int j, k;
	int a, a_end, b, b_end; /* ranges in run */
	double constant;        /* K_jk */
};

/* Up to four rows with the same columns: entry i of A or B is value[4 i + r] for row r. The columns of
 * A are coordinates, those of B pairs l <= m at m(m+1)/2 + l. */
struct hawser__panel {
	int rows;
	int j[4], k[4], row[4];
	double constant[4];
	int a, a_end, b, b_end; /* ranges in column */
};

struct hawser__condensed;
struct hawser__quartic;
struct hawser__rates;

struct hawser__kernel_panels {
	int count;
	struct hawser__panel *panel;
	int *column;
	double *value;
	int *from;     /* of each value, the index of that of the kernel which it is a multiple of, or -1 */
	double *share; /* NULL: equal to it */
	int values;
};

struct hawser_rom_kernel {
	int symmetric;        /* rows have k <= j and stand for (k, j) too */
	int rows, runs, values;
	struct hawser__kernel_row *row;
	struct hawser__run *run;
	double *value;        /* [values], and behind them [rows] the constants of rows */
	int *from;            /* [values] the entries of Q or C, or -1 */
	int quads, cubics;    /* their numbers */
	int *single;          /* [n] coordinate of column c of A */
	int *pair_l, *pair_m; /* [n(n+1)/2] coordinates of the product in column c of B */
	struct hawser__kernel_panels *panels;
	struct hawser__kernel_panels *gradient; /* for forces without tangents (gradient.c); NULL if not
	                                  * symmetric, or if the panels are as fast */
	int d_entries;        /* nonzeros of D */
	int *d_j, *d_k;
	double *d_val;
	int harmonics;
	int *alike;           /* [harmonics] the first one whose Q has the same indices in the same order */
	struct hawser__quartic *quartic; /* the same energy as a function (quartic.h); NULL if the model is
	                       * not of a cable's modes */
	struct hawser__size size;       /* of the model, if quartic is not NULL */
	struct hawser__rates *rates;    /* terms in velocities alone (terms.h), or NULL */
	int others;                     /* number of terms that are not among them */
	int *other;                     /* [others] their indices */
	int by_function[HAWSER__TASKS]; /* 1: quartic is evaluated for this task, else the tensors. If
	                       * it is 1 for all, there are no rows, runs and panels */
	double asymmetry;     /* largest |T - transposed T| over largest |T|, of K, Q and C */
	struct hawser__hold hold; /* its arrays */
};

/* Restoring forces [count][n] and, unless NULL, tangents [count][n][n] at the states u [count][n] at
 * equal distances over a period, the first at the phase 0, with the terms that vary with it (vary.h).
 * `work` is a workspace of the caller with the size that _work returns for this count or a larger
 * one; NULL if that is 0. No allocation. Threads may call it with their own workspaces. */
size_t hawser__rom_tangents_work(const struct hawser_rom *rom, int count);
void hawser__rom_tangents(const struct hawser_rom *rom, double *restoring, double *tangent,
                          const double *u, int count, double *work);

/* The same at HAWSER_LANES states, of which `live` are used: the values of one quantity are stored
 * next to each other. restoring and u are [n][HAWSER_LANES], tangent is [n][n][HAWSER_LANES] or
 * NULL; work is [HAWSER_LANES_WORK(n)]. */
#define HAWSER_LANES 4
#define HAWSER_LANES_WORK(n) (2*HAWSER_LANES*(n)*((n) + 1)/2 + 2*HAWSER_LANES*(n))
void hawser__rom_lanes(const struct hawser_rom *rom, double *restoring, double *tangent,
                       const double *u, int live, double *work);

/* Additions and multiplications of a force, or of force and tangent, at one of several states. */
double hawser__rom_flops(const struct hawser_rom *rom, int tangent);

/* panel.c: the panels of a finished kernel; NULL when out of memory. */
struct hawser__kernel_panels *hawser__panels_new(const struct hawser_rom_kernel *kernel);
/* gradient.c: the same of a symmetric kernel's potential as a quadratic form of coordinates and their
 * products: row j[r] of it, columns from a to b_end. */
struct hawser__kernel_panels *hawser__gradient_new(const struct hawser_rom_kernel *kernel, int n);
/* Memory for so many panels and columns in all, without values; returns 0 if it is short. */
int hawser__panels_room(struct hawser__kernel_panels *panels, int rows, int columns);
/* Their values, from those of the kernel. */
void hawser__panels_fill(struct hawser__kernel_panels *panels, const struct hawser_rom_kernel *kernel);
void hawser__panels_free(struct hawser__kernel_panels *panels);

/* _places: number of points of the cable at which the tension is evaluated, 0 if the model has
 * none. The tensions there, all [places], N (SI), with `extra` [HAWSER__EXTRA(places)] (NULL: none):
 * further strains [places], and, of a model whose ends move, their factors (ends.h). shapes.c. */
#define HAWSER__EXTRA(places) ((size_t)(places) + 6) /* HAWSER__SUPPORT_MOST, support.h */
int hawser__rom_tension_places(const struct hawser_rom *rom);
void hawser__rom_tensions_all(const struct hawser_rom *rom, double *all, const double *u,
                              const double *extra);

/* extra at an instant: the strain a of the modes that are not kept, which is 0 in models with the exact
 * energy, and the factors of the ends. Returns 0 if the model has neither. answer.c. */
int hawser__rom_answer_strains(const struct hawser_rom *rom, double *extra,
                               const struct hawser_rom_moment *moment);

/* The same at one point, and at shape point p; zero if the model has none. */
double hawser__rom_answer_strain(const struct hawser_rom *rom, int place,
                                 const struct hawser_rom_moment *moment);
double hawser__rom_answer_slope(const struct hawser_rom *rom, int p,
                                const struct hawser_rom_moment *moment);

/* local [3] += P, Q, B of these modes at shape point p; rate: their time derivatives. */
void hawser__rom_answer_shape(const struct hawser_rom *rom, double local[3], int p,
                              const struct hawser_rom_moment *moment, int rate);

/* Numbers in `answer` and `answer_line` of a harmonic (rom.h). */
#define HAWSER__ANSWER(rom) (2*4*(size_t)(rom)->shapes.points)
#define HAWSER__ANSWER_LINE(rom) (2*(size_t)(rom)->line.points)

/* s, s^2 and ds/dt of a ramp at time t; `over`: after its end. forced.c. */
void hawser__ramp_factors(double s[HAWSER_RAMP_TERMS], const struct hawser_ramp *ramp, double t,
                          int over);

/* hawser_rom_compile (rom.h), or with `bare` a kernel without tensors. */
enum hawser_status hawser__rom_compile(struct hawser_rom *rom, int bare,
                                       struct hawser_report *report);

/* The same of a model with other values of the same entries, in the order of the last compilation. */
enum hawser_status hawser__rom_refill(struct hawser_rom *rom, struct hawser_report *report);

/* hawser_rom_compile, with the energy of `modes` as a function in the kernel, which evaluates it in
 * the tasks in which it is faster. `condensed` as in project.h. HAWSER_ERR_MEMORY. */
enum hawser_status hawser__rom_compile_cable(struct hawser_rom *rom,
                                             const struct hawser_modes *modes,
                                             const struct hawser__condensed *condensed,
                                             struct hawser_report *report);

void hawser__kernel_free(struct hawser_rom_kernel *kernel);

#endif
