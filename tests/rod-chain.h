/* tests/rod-chain.h - a rod with a winch that tests move step by step.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_TESTS_ROD_CHAIN_H
#define HAWSER_TESTS_ROD_CHAIN_H

#include "rod/motion.h"
#include "tests/tap.h"

/* A mesh that moves; the winch, too. */
struct chain {
	struct hawser_rod_segment segment[2];
	struct hawser_rod rod;
	struct hawser__rod_mesh mesh;
	struct hawser__rod_motion motion;
	struct hawser__rod_body body;
};

static inline void chain_open(struct chain *c, double until, int refine)
{
	struct hawser_report report;
	enum hawser_status status;

	c->rod.segment = c->segment;
	c->rod.length = 0.0;
	for (int i = 0; i < c->rod.segments; i++)
		c->rod.length += c->segment[i].length;
	status = hawser__rod_mesh_open(&c->mesh, &c->rod, refine, &report);
	if (!status)
		status = hawser__rod_motion_open(&c->motion, &c->mesh, &report);
	if (!status)
		status = hawser__rod_winch_open(&c->motion.winch, &c->mesh, 0.0, until, &report);
	if (status)
		ok(0, "%s", report.message);
	hawser__rod_motion_factors(&c->motion, 0.0, 0);
}

static inline void chain_close(struct chain *c)
{
	hawser__rod_motion_clear(&c->motion);
	hawser__rod_mesh_clear(&c->mesh);
}

static inline void chain_go(struct chain *c, double until, int steps)
{
	struct hawser_report report;
	enum hawser_status status = HAWSER_OK;
	double h = (until - c->motion.t)/steps;

	for (int i = 0; i < steps && !status; i++)
		status = hawser__rod_motion_step(&c->motion, h, &report);
	if (status)
		ok(0, "%s", report.message);
}

static inline void chain_begin(struct chain *c)
{
	struct hawser_report report;

	if (hawser__rod_motion_begin(&c->motion, 1, &report))
		ok(0, "%s", report.message);
}

/* A cable along `tangent`, with a winch of constant speed. */
static inline struct chain cable(double length, double rho, double EA, double EI, double speed,
                                 int elements)
{
	struct chain c = {.segment = {{
		.length = length, .rho = rho, .EA = EA, .GA = {EA, EA}, .EI = {EI, EI}, .GJ = EI,
		.inertia = {2e-6*rho, 1e-6*rho, 1e-6*rho}, .elements = elements}}};

	c.rod = (struct hawser_rod){.segments = 1, .hold = {HAWSER_ROD_HINGED, HAWSER_ROD_FREE},
	                            .tangent = {0.0, -1.0, 0.0}, .normal = {1.0, 0.0, 0.0}, .g = 9.81,
	                            .rho_inf = 0.8, .winch = {.on = 1, .speed = speed}};
	return c;
}

#endif
