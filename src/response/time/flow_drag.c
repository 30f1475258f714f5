/* response/time/flow_drag.c - quadratic drag, and the terms of own models, at a stage of the
 * flow. Since the volume of states contracts by the trace of their derivative, that trace is
 * summed with the weights of the formula. SPDX-License-Identifier: GPL-3.0-or-later */
#include <string.h>

#include "response/time/flow.h"
#include "response/time/nystrom.h"
#include "rom/terms/drag.h"
#include "rom/energy/kernel.h"
#include "rom/terms/terms.h"

static double trace_of(const double *matrix, int n)
{
	double trace = 0.0;

	for (int j = 0; j < n; j++)
		trace += matrix[(size_t)j*(n + 1)*HAWSER_LANES];
	return trace;
}

void hawser__flow_drag(struct hawser__flow *flow, int s, int derive, int live, double omega)
{
	const int n = flow->n, lanes = HAWSER_LANES;
	double *f = flow->f + (size_t)s*n*lanes, *by_v = flow->by_v + (size_t)s*n*n*lanes;
	double *v = flow->work, *force = v + n, *matrix = force + n;

	for (int lane = 0; lane < lanes; lane++) {
		for (int j = 0; j < n; j++)
			v[j] = flow->stage_v[j*lanes + lane];
		memset(force, 0, ((size_t)n + (derive ? (size_t)n*n : 0))*sizeof *force);
		hawser__drag_add(flow->rom->drag, force, derive ? matrix : NULL, 1.0, v, 1);
		for (int j = 0; j < n; j++)
			f[j*lanes + lane] += force[j];
		for (int i = 0; derive && i < n*n; i++) {
			by_v[i*lanes + lane] += matrix[i];
			if (i%(n + 1) == 0 && lane < live)
				flow->drained += hawser__dop853.b[s]*flow->h/omega*matrix[i];
		}
	}
}

void hawser__flow_more(struct hawser__flow *flow, int s, int derive, int live, double omega)
{
	const int n = flow->n, lanes = HAWSER_LANES;
	double *f = flow->f + (size_t)s*n*lanes, *by_omega = flow->f_omega + (size_t)s*n*lanes;
	double *by_u = flow->by_u + (size_t)s*n*n*lanes, *by_v = flow->by_v + (size_t)s*n*n*lanes;

	double before[HAWSER_LANES] = {0.0}, at[HAWSER_LANES];
	const struct hawser__more to = {.force = f, .by_u = derive ? by_u : NULL,
		.by_v = derive ? by_v : NULL, .by_omega = derive ? by_omega : NULL,
		.sign = -1.0, .stride = lanes};

	for (int lane = 0; lane < lanes; lane++) {
		at[lane] = flow->at[lane] + hawser__dop853.c[s]*flow->h;
		before[lane] = derive ? trace_of(by_v + lane, n) : 0.0;
	}
	hawser__rom_more_add(flow->rom, &to, flow->stage_u, flow->stage_v, at, omega);
	for (int lane = 0; derive && lane < live; lane++)
		flow->drained += hawser__dop853.b[s]*flow->h/omega*
		                 (trace_of(by_v + lane, n) - before[lane]);
}
