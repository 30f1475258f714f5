/* net/water/flow.c - see motion.h. SPDX-License-Identifier: GPL-3.0-or-later */
#include <string.h>

#include "net/motion/motion.h"
#include "water/near.h"
#include "water/water.h"

enum hawser_status hawser__water_flow_open(struct hawser__water_flow *flow,
                                           const struct hawser_water *of, int places,
                                           struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	*flow = (struct hawser__water_flow){.of = of};
	if (of->file)
		status = hawser__support_read(&flow->series, of->file, report);
	if (!status && of->waves.count > 1)
		status = hawser__near_open(&flow->near, &of->waves, places, report);
	return status;
}

void hawser__water_flow_clear(struct hawser__water_flow *flow)
{
	hawser__near_free(flow->near);
	hawser__support_clear(&flow->series);
	memset(flow, 0, sizeof *flow);
}

void hawser__water_flow_time(struct hawser__water_flow *flow, double t)
{
	flow->t = t;
	if (!flow->series.rows)
		return;
	hawser__support_within(flow->later, flow->rate, &flow->series, t);
	for (int k = 0; k < 3; k++)
		flow->later[k] -= flow->of->current->u[k];
}

void hawser__water_flow_at(struct hawser__water_there *at, const struct hawser__water_flow *flow,
                           int place, const double x[3])
{
	const struct hawser_water *of = flow->of;
	struct hawser_wave_flow wave = {.elevation = 0.0};
	double u_y[3];

	hawser__water_current(at->u, u_y, of, x[1]);
	if (place >= 0 && flow->near)
		hawser__near_at(&wave, flow->near, place, x, flow->t);
	else if (of->waves.count)
		hawser_waves_at(&wave, &of->waves, x, flow->t);
	for (int k = 0; k < 3; k++) {
		at->u[k] += wave.u[k] + flow->later[k];
		at->du[k] = wave.du[k] + flow->rate[k];
	}
	at->surface = of->surface + (of->waves.stretching != HAWSER_STRETCH_NONE ? wave.elevation : 0.0);
}
