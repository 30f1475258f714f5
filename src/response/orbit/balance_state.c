/* response/orbit/balance_state.c - the Fourier series of a motion from its state at phase 0.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "response/orbit/balance.h"
#include "response/orbit/shooting.h"
#include "response/time/flow.h"

#define GUESS_ORDER 30  /* largest number of harmonics of the load taken from a state */
#define FINER 4         /* shorter steps for states of several of the load's periods; chosen */
#define GUESS_PART 1e-4 /* smallest harmonic taken from a state, relative to the orbit */

void hawser__balance_adopt(struct hawser__balance *balance, const double *y, int order,
                           double part)
{
	int n = balance->base.n;
	const double *K = balance->base.rom->K;
	double whole = 0.0;

	order = order < balance->top ? order : balance->top;
	for (int i = 0; i < (2*order + 1)*n; i++)
		whole += fabs(K[(size_t)(i%n)*((size_t)n + 1)])*y[i]*y[i];
	for (int e = 0; e < (order + 1)*n; e++) {
		double c = y[hawser__cos(n, e/n, e%n)], s = e < n ? 0.0 : y[hawser__sin(n, e/n, e%n)];

		if (sqrt(fabs(K[(size_t)(e%n)*((size_t)n + 1)]))*hypot(c, s) > part*sqrt(whole))
			balance->active[e] = 1;
	}
}

enum hawser_status hawser__balance_hold(struct hawser__balance *balance, const double *y,
                                        struct hawser_report *report)
{
	int n = balance->base.n, changed = 0;

	for (int e = 0; e < (balance->top + 1)*n; e++) {
		int on = y[hawser__cos(n, e/n, e%n)] != 0.0 || (e >= n && y[hawser__sin(n, e/n, e%n)] != 0.0);

		changed |= on != balance->active[e];
		balance->active[e] = (unsigned char)on;
	}
	return changed ? hawser__balance_arrange(balance, report) : HAWSER_OK;
}

/* Coefficients y of u at `rows` phases, samples [rows][n], after subtraction of the drift over the
 * period, `gap` [n]. Pairs above GUESS_PART become active. */
static void analyse(struct hawser__balance *balance, double *y, const double *samples,
                    const double *gap, int rows, double omega)
{
	int n = balance->base.n, order = (rows - 1)/2;
	double whole = 0.0;

	order = (int)fmin(fmin(order, balance->top), GUESS_ORDER*hawser__balance_lowest(balance->base.rom));
	memset(y, 0, (size_t)(balance->base.size - 1)*sizeof *y);
	for (int i = 0; i < rows; i++)
		for (int h = 0; h <= order; h++) {
			double c = cos(2.0*M_PI*(double)((long)i*h%rows)/rows)*(h ? 2.0 : 1.0)/rows;
			double s = sin(2.0*M_PI*(double)((long)i*h%rows)/rows)*2.0/rows;

			for (int j = 0; j < n; j++) {
				double u = samples[(size_t)i*n + j] - gap[j]*i/rows;

				y[hawser__cos(n, h, j)] += u*c;
				if (h)
					y[hawser__sin(n, h, j)] += u*s;
			}
		}
	memset(balance->active, 1, (size_t)(order + 1)*n);
	memcpy(balance->at, y, (size_t)(balance->base.size - 1)*sizeof *y);
	balance->at[balance->base.size - 1] = omega;
	for (int e = 0; e < (order + 1)*n; e++)
		whole += pow(hawser__balance_amplitude(balance, e/n, e%n), 2);
	for (int e = 0; e < (order + 1)*n; e++)
		balance->active[e] = hawser__balance_amplitude(balance, e/n, e%n) > GUESS_PART*sqrt(whole);
	if (balance->base.rom->exact)
		hawser__balance_adopt(balance, y, order, HAWSER__PART);
}

enum hawser_status hawser__balance_from_state(struct hawser__orbit *orbit, double *y,
                                              const double *x, double omega,
                                              struct hawser_report *report)
{
	struct hawser__balance *balance = (struct hawser__balance *)orbit;
	int n = orbit->n, k = hawser__balance_lowest(orbit->rom);
	/* many periods add up the errors of the steps of one */
	int rows = hawser__shooting_steps(orbit->rom, omega, 1)*(k > 1 ? FINER : 1);
	struct hawser__stretch period;
	struct hawser__flow flow;
	double *samples, *end;
	enum hawser_status status;

	rows = (int)fmax(rows, 2.0*GUESS_ORDER*k);
	period = (struct hawser__stretch){.h = 2.0*M_PI/rows, .steps = rows, .count = 1};
	samples = malloc((size_t)rows*n*sizeof *samples);
	end = malloc((size_t)orbit->m*sizeof *end);
	status = hawser__flow_init(&flow, orbit->rom, report);
	if (!status && (!samples || !end))
		status = hawser__no_memory(report, "orbit");
	if (!status) {
		memcpy(end, x, (size_t)orbit->m*sizeof *end);
		hawser__flow_map(&flow, end, samples, &period, omega);
		for (int j = 0; j < n; j++)
			end[j] -= x[j];
		analyse(balance, y, samples, end, rows, omega);
		y[orbit->size - 1] = omega;
		hawser__balance_seed(balance);
		status = hawser__balance_arrange(balance, report);
	}
	hawser__flow_clear(&flow);
	free(samples);
	free(end);
	return status;
}
