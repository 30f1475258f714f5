/* response/time/collocated.h - one step of a collocation method after another: clock, polynomial of the
 * acceleration, error inside a step, length of the next one. gauss.c and radau.c solve the equations
 * of a step.
 *
 *    a(x)     acceleration over a step as a polynomial of degree s - 1, x in [0, 1]
 *    alpha_m  its Legendre coefficients: a(x) = sum_m alpha_m P_m(2x - 1)
 *
 * Step control: the first omitted coefficient, alpha_s, is extrapolated from the decay of the
 * computed ones over two indices (the decay over one would be misled by parity). The tolerance
 * limits its contribution to u and v inside the step. The end of the step has twice the order and
 * is far more accurate, so that the output has the stated accuracy everywhere.
 *
 * u, v and t are summed with compensation: at 1e5 steps plain sums would lose three digits. The
 * round-off of t also enters the phase of the forcing, the output between steps and the last step;
 * after 1e8 periods it would be 1e-7 of a period.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_COLLOCATED_H
#define HAWSER_RESPONSE_COLLOCATED_H

#include "core/hold.h"
#include "response/orbit/collocation.h"
#include "response/time/stepper.h"

struct hawser__collocated;
struct hawser__collocated_rule {
	/* Solve the equations of a step of length h: slope and stage. Returns -1 if h is too long. */
	int (*solve)(struct hawser__collocated *of, double h);
	/* The allowed error [2n] in this step. */
	const double *(*weight)(const struct hawser__collocated *of);
	/* The step is accepted, `from` and `alpha` are its own: add the increments to `to`. */
	void (*accept)(struct hawser__collocated *of, double h);
	/* How much longer the next step should be after this error. */
	double (*factor)(const struct hawser__collocated *of, double error);
	/* y [2n] at fraction x of the last step. */
	void (*interpolate)(const struct hawser__collocated *of, double *y, double x);
};

/* The first member of a method's own structure. */
struct hawser__collocated {
	struct hawser__stepper base;
	const struct hawser__collocated_rule *rule;
	struct hawser__collocation table;
	double begin, begin_low;  /* time at the start of the last step, and its rounding error */
	double end, end_low;      /* time reached, and its rounding error */
	double step;              /* of the last step; 0 before the first */
	double next;              /* length of the next step */
	double *from;             /* [2n] state at begin */
	double *to, *low;         /* [2n] state at end, and its rounding error */
	double *alpha, *trial;    /* [S][n] coefficients of the last step and of the present one */
	double *slope;            /* [S][n] accelerations at the nodes */
	double *stage;            /* [S][2n] states at the nodes */
	struct hawser__hold hold; /* of all arrays, those of the method too */
};

/* Begins at y0 [2n]; the caller makes the table. Returns -1 if memory is short, also of what the method
 * holds. */
int hawser__collocated_open(struct hawser__collocated *of, const struct hawser__stepper *problem,
                            const struct hawser__collocated_rule *rule, const double *y0);

/* Initial slopes: the extrapolated polynomial of the last step, or a constant at the start. Returns -1
 * where the acceleration is not finite. */
int hawser__collocated_predict(struct hawser__collocated *of, double h);
/* Coefficients out [S][n] of x [S][stride]: sum_i transform[m][i] x_i. */
void hawser__collocated_transform(const struct hawser__collocated *of, double *out, const double *x,
                                  int stride);
/* The error inside a step with the coefficients alpha [S][n], in units of weight [2n]. */
double hawser__collocated_error(const struct hawser__collocated *of, const double *alpha, double h,
                                const double *weight);
/* How much longer the step could be for its error. */
double hawser__collocated_longer(double error);
/* sum + low += term; low is the rounding error of the sum. */
void hawser__collocated_add(double *sum, double *low, double term);

/* The members `step` and `advance` of the method. */
enum hawser_status hawser__collocated_step(struct hawser__stepper *stepper,
                                           struct hawser_report *report);
enum hawser_status hawser__collocated_advance(struct hawser__stepper *stepper, double *y, double t,
                                              struct hawser_report *report);

#endif
