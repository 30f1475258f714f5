/* rod/begin.c - the beginning of a motion: mass, moving ends, the state at t = 0.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdio.h>

#include "core/report.h"
#include "rod/run.h"
#include "rod/so3.h"
#include "rod/mesh.h"

#define TOLERANCE 1e-11 /* of the equilibrium, in lengths of the rod and rad: that of the steps */

static enum hawser_status massive(const struct hawser_rod *rod, struct hawser_report *report)
{
	for (int i = 0; i < rod->segments; i++) {
		const struct hawser_rod_segment *of = &rod->segment[i];
		char name[32];

		snprintf(name, sizeof name, rod->segments > 1 ? "rod.i%d" : "rod", i);
		if (!(of->rho > 0.0))
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rod", "%s: %s.rho is 0: what moves "
			                    "needs a mass per length, in kg/m", rod->name, name);
		if (!(of->inertia[0] > 0.0))
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rod", "%s: %s.inertia is missing: give "
			                    "the inertia of rotation per length about e1, e2 and e3, in kg.m: of a "
			                    "section of one material rho/EA times (the sum of both EI, EI, EI), "
			                    "[%.3g kg.m, %.3g kg.m, %.3g kg.m]", rod->name, name,
			                    of->rho*(of->EI[0] + of->EI[1])/of->EA, of->rho*of->EI[0]/of->EA,
			                    of->rho*of->EI[1]/of->EA);
	}
	return HAWSER_OK;
}

/* The rod moves with an end that moves at once, as a rigid body. */
static void sweep(struct hawser__rod_twin *twin)
{
	struct hawser__rod_mesh *mesh = &twin->mesh;
	int end = twin->motion.guide[0] ? 0 : 1, at = end ? mesh->nodes - 1 : 0;
	const struct hawser_rod_drive *as = &mesh->rod->drive[end];
	double speed = as->rise > 0.0 ? 0.0 : as->speed;
	struct hawser__rod_guide to;

	if (!twin->motion.guide[end] || mesh->rod->hold[!end] != HAWSER_ROD_FREE)
		return;
	hawser__rod_drive_at(twin->motion.guide_data[end], &to, 0.0);
	for (int i = 0; i < mesh->nodes; i++) {
		double w[3], arm[3], v[3], R[9];

		for (int k = 0; k < 3; k++) {
			w[k] = speed*as->axis[k];
			arm[k] = mesh->node[i].x[k] - mesh->node[at].x[k];
		}
		hawser__cross(v, w, arm);
		hawser__quaternion_matrix(R, mesh->node[i].q);
		hawser__apply_left(twin->motion.velocity[i] + 3, R, w);
		for (int k = 0; k < 3; k++)
			twin->motion.velocity[i][k] = to.v[k] + v[k];
	}
}

enum hawser_status hawser__rod_twin_open(struct hawser__rod_twin *twin, const struct hawser_rod *rod,
                                         int refine, double until, int rest,
                                         struct hawser_report *report)
{
	struct hawser__rod_effort effort;
	int free = rod->hold[0] == HAWSER_ROD_FREE && rod->hold[1] == HAWSER_ROD_FREE, open;
	enum hawser_status status = massive(rod, report);

	if (!status && rod->from_rest && (rod->placed || rod->turned))
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "rod", "dynamics.from is rest, and the end "
		                      "is held elsewhere than at rest, by end.at or end.tangent: leave out one "
		                      "of them");
	if (!status)
		status = hawser__rod_mesh_open(&twin->mesh, rod, refine, report);
	if (!status)
		status = hawser__rod_motion_open(&twin->motion, &twin->mesh, report);
	for (int end = 0; end < 2 && !status; end++) {
		status = hawser__rod_drive_open(&twin->drive[end], &open, &twin->mesh, end, until, report);
		if (!status && open) {
			twin->motion.guide[end] = hawser__rod_drive_at;
			twin->motion.guide_data[end] = &twin->drive[end];
		}
	}
	if (!status)
		status = hawser__rod_winch_open(&twin->motion.winch, &twin->mesh, 0.0, until, report);
	if (status)
		return status;
	if (twin->mesh.water.of) {
		status = hawser__water_flow_open(&twin->mesh.water.flow, twin->mesh.water.of,
		                                 twin->mesh.nodes, report);
		twin->motion.loading = hawser__rod_water_push;
	}
	if (status)
		return status;
	hawser__rod_motion_factors(&twin->motion, 0.0, 0);
	if (!free && !rest && !rod->from_rest)
		status = hawser__rod_equilibrium(&twin->mesh, &effort, 0, 1, twin->motion.factor, TOLERANCE,
		                                 report);
	if (!status)
		sweep(twin);
	if (!status && !rest && hawser__rod_winch_begin(&twin->motion, rod->from_rest))
		status = hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "rod", "the equilibrium at the start "
		                      "does not determine how it lengthens at %.3g m/s: give a speed that "
		                      "begins with 0, as with winch.rise", twin->motion.winch.speed);
	twin->live = !status;
	return status;
}

void hawser__rod_twin_clear(struct hawser__rod_twin *twin)
{
	hawser__rod_motion_clear(&twin->motion);
	hawser__rod_mesh_clear(&twin->mesh);
	for (int end = 0; end < 2; end++)
		hawser__rod_drive_clear(&twin->drive[end]);
	twin->live = 0;
}
