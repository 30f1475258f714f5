/* tow/motion_start.c - the start of a towed body's motion, and where its towing point goes.
 *
 * The start is the steady state at the path's first velocity: of an orbit without ramp that of the
 * orbit, else straight flight, in the wind of that time. Statics and motion have the same stiffnesses:
 * no shear is GA = EA here, which is far above what bending needs. The inertia of sections is that of
 * rho/A times I, I = EI/E and A = EA/E: rho EI/EA, twice that about the tangent.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "tow/motion.h"

enum { FREE = HAWSER__ROD_FREE };
static const char where[] = "tow";

/* Where the towing point is, and where it goes; beyond the path's end it stays. */
static void state_at(double (*state)[3], const struct hawser_path *path, double t)
{
	struct hawser_report ignored;
	double within = fmin(fmax(t, path->from), path->to);

	if (hawser_path_at(state, path, within, &ignored) || within != t)
		memset(state[1], 0, (HAWSER_PATH_ORDERS - 1)*sizeof *state);
}

/* Of an orbit: the angle about its axis, x toward z, and its derivatives. */
static void angle_of(double angle[3], const struct hawser_path *path, double (*state)[3])
{
	double x = state[0][0] - path->origin[0], z = state[0][2] - path->origin[2], square = x*x + z*z;

	angle[0] = atan2(z, x);
	angle[1] = (x*state[1][2] - z*state[1][0])/square;
	angle[2] = (x*state[2][2] - z*state[2][0])/square;
}

/* The towing point; where the cable is clamped, its axes turn with the orbit. */
static void guide(void *data, struct hawser__rod_guide *to, double t)
{
	const struct hawser__tow_run *run = data;
	const struct hawser_path *path = &run->tow->path;
	double state[HAWSER_PATH_ORDERS][3], angle[3] = {0.0}, turn[4], R[9];

	state_at(state, path, t);
	memcpy(to->x, state[0], sizeof to->x);
	memcpy(to->v, state[1], sizeof to->v);
	memcpy(to->a, state[2], sizeof to->a);
	memcpy(to->q, run->clamp, sizeof to->q);
	if (path->kind != HAWSER_PATH_ORBIT)
		return;
	angle_of(angle, path, state);
	hawser__quaternion_exp(turn, (const double [3]){0.0, run->angle - angle[0], 0.0});
	hawser__quaternion_mul(to->q, turn, run->clamp);
	hawser__quaternion_matrix(R, to->q);
	for (int k = 0; k < 3; k++) {
		to->spin[k] = -angle[1]*R[3 + k];
		to->rate[k] = -angle[2]*R[3 + k];
	}
}

/* A current over time has at the start what its file has for that time. */
static enum hawser_status current(struct hawser__tow_run *run, struct hawser_report *report)
{
	const struct hawser_tow *tow = run->tow;
	struct hawser__support_table table = {0};
	double rate[3];
	enum hawser_status status = tow->water.file
		? hawser__support_read(&table, tow->water.file, report) : HAWSER_OK;

	if (!status && table.rows) {
		hawser__support_within(run->level.u, rate, &table, tow->path.from);
		run->own.water.current = &run->level;
	}
	hawser__support_clear(&table);
	return status;
}

/* What motion needs of the cable, and the path of the start. */
static enum hawser_status prepare(struct hawser__tow_run *run, double (*state)[3],
                                  struct hawser_report *report)
{
	const struct hawser_tow *tow = run->tow;
	struct hawser_tow *own = &run->own;

	*own = *tow;
	own->segment = calloc((size_t)tow->segments + 1, sizeof *own->segment);
	if (!own->segment)
		return hawser__no_memory(report, where);
	for (int i = 0; i < tow->segments; i++) {
		struct hawser_tow_segment *to = &own->segment[i];

		*to = tow->segment[i];
		if (!isfinite(to->EA) || !(to->EI > 0.0))
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, where, "cable.segments[%d].%s is missing: "
			                    "a motion needs the axial stiffness EA (N) and the bending stiffness "
			                    "EI (N m^2); of a round cable of modulus E and diameter d they are "
			                    "E pi d^2/4 and E pi d^4/64", i, isfinite(to->EA) ? "EI" : "EA");
		if (!(to->rho > 0.0))
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, where, "cable.segments[%d].rho is 0: a "
			                    "motion needs a mass per length (kg/m)", i);
		if (!(to->GA > 0.0))
			to->GA = to->EA;
		if (!(to->GJ > 0.0))
			to->GJ = to->EI;
	}
	hawser__tow_wind(own->wind, tow, tow->path.from);
	if (tow->path.kind == HAWSER_PATH_ORBIT && tow->path.ramp_time == 0.0 && own->wind[0] == 0.0 &&
	    own->wind[2] == 0.0)
		return HAWSER_OK;
	own->path = (struct hawser_path){.kind = HAWSER_PATH_STRAIGHT, .to = INFINITY};
	memcpy(own->path.origin, state[0], sizeof own->path.origin);
	memcpy(own->path.velocity, state[1], sizeof own->path.velocity);
	return HAWSER_OK;
}

/* The steady state where the towing point begins, with its velocities. */
static void place(struct hawser__tow_run *run, double (*state)[3])
{
	struct hawser__rod_mesh *mesh = &run->rod.mesh;
	double spin = run->frame.spin, turn[4], R[9], by[3], q[4];
	double angle = spin != 0.0 ? atan2(mesh->node[0].x[2], mesh->node[0].x[0]) : 0.0;

	hawser__quaternion_exp(turn, (const double [3]){0.0, angle, 0.0});
	hawser__quaternion_matrix(R, turn);
	hawser__apply(by, R, mesh->node[0].x);
	for (int k = 0; k < 3; k++)
		by[k] = state[0][k] - by[k];
	for (int i = 0; i < mesh->nodes; i++) {
		struct hawser__rod_node *node = &mesh->node[i];
		double x[3], *v = run->motion.velocity[i];

		hawser__apply(x, R, node->x);
		hawser__quaternion_mul(q, turn, node->q);
		memcpy(node->q, q, sizeof q);
		for (int k = 0; k < 3; k++) {
			node->x[k] = x[k] + by[k];
			v[k] = run->frame.velocity[k];
		}
		if (spin == 0.0)
			continue;
		v[0] = spin*x[2];
		v[2] = -spin*x[0];
		hawser__quaternion_matrix(R, node->q);
		for (int k = 0; k < 3; k++)
			v[3 + k] = spin*R[3 + k];
		hawser__quaternion_matrix(R, turn);
	}
}

static void put_body(struct hawser__tow_run *run)
{
	const struct hawser_tow_body *body = &run->own.body;
	double R = body->ring.radius, r = body->ring.drag.radius;
	int ring = body->kind == HAWSER_TOW_RING;

	if (body->kind == HAWSER_TOW_NO_BODY)
		return;
	run->mass = (struct hawser__rod_body){.node = run->rod.end, .mass = body->mass,
	                                      .offset = {ring ? body->offset : 0.0}};
	for (int k = 0; k < 3; k++)
		run->mass.inertia[4*k] = !ring ? body->inertia
		                         : body->mass*(k == 0 ? R*R + 0.75*r*r : 0.5*R*R + 0.625*r*r);
	run->motion.body = &run->mass;
	run->motion.bodies = 1;
}

static enum hawser_status begin(struct hawser__tow_run *run, double (*state)[3],
                                struct hawser_report *report)
{
	struct hawser__tow_rod *b = &run->rod;
	double angle[3] = {0.0};
	enum hawser_status status = hawser__rod_motion_open(&run->motion, &b->mesh, report);

	if (status)
		return status;
	if (b->mesh.water.of)
		status = hawser__water_flow_open(&b->mesh.water.flow, b->mesh.water.of, b->mesh.nodes, report);
	if (status)
		return status;
	run->phase = calloc(2*(size_t)b->mesh.elements, sizeof *run->phase);
	if (!run->phase)
		return hawser__no_memory(report, where);
	run->swing = run->phase + b->mesh.elements;
	place(run, state);
	if (run->tow->path.kind == HAWSER_PATH_ORBIT)
		angle_of(angle, &run->tow->path, state);
	run->angle = angle[0];
	memcpy(run->clamp, b->mesh.node[0].q, sizeof run->clamp);
	for (int k = 3; k < FREE; k++) {
		b->mesh.held[k] = run->tow->clamped != 0;
		b->mesh.held[FREE*b->end + k] = 0;
	}
	for (int k = 0; k < 3 && b->links; k++) /* the joint bears what it does at rest */
		b->mesh.node[b->end].x[k] += b->pull[k]/b->spring[0];
	put_body(run);
	run->motion.t = run->at = run->tow->path.from;
	run->motion.loading = hawser__tow_push;
	run->motion.data = run;
	run->motion.guide[0] = guide;
	run->motion.guide_data[0] = run;
	hawser__tow_shed(run);
	return HAWSER_OK;
}

/* The winch at the towing point. The cable begins in its steady state, at rest but for the path. */
static enum hawser_status winch(struct hawser__tow_run *run, double until,
                                struct hawser_report *report)
{
	double from = run->tow->path.from, l[3] = {0.0};
	enum hawser_status status;

	run->rod.rod.winch = run->tow->winch;
	status = hawser__rod_winch_open(&run->motion.winch, &run->rod.mesh, from, until, report);
	if (!status && run->motion.winch.as)
		hawser__rod_winch_at(l, &run->motion.winch, from);
	return status || fabs(l[1]) < 1e-12 ? status
		: hawser__fail(report, HAWSER_ERR_ARGUMENT, where, "the winch begins with %.6g m/s at %.6g s, "
		               "and the motion with a steady state: give winch.rise, or speeds from 0", l[1],
		               from);
}

enum hawser_status hawser__tow_run_open(struct hawser__tow_run *run, const struct hawser_tow *tow,
                                        int refine, double until, struct hawser_report *report)
{
	double state[HAWSER_PATH_ORDERS][3];
	enum hawser_status status;

	memset(run, 0, sizeof *run);
	run->tow = tow;
	if (!tow->segments)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where, "the scene has no cable: add, for "
		                    "example, cable: {segments: [{length: 14 m, rho: 58 g/m, diameter: 8 mm, "
		                    "EA: 200 kN, EI: 0.8 N m^2, drag: {normal: 1.2}}]}");
	state_at(state, &tow->path, tow->path.from);
	status = prepare(run, state, report);
	if (!status)
		status = current(run, report);
	if (!status)
		status = hawser__tow_rod_start(&run->rod, &run->frame, &run->body, &run->own, refine, report);
	for (int i = 0; i < tow->segments && !status; i++) {
		struct hawser_rod_segment *of = &run->rod.rod.segment[i];

		for (int k = 0; k < 3; k++)
			of->inertia[k] = of->rho*of->EI[0]/of->EA*(k == 0 ? 2.0 : 1.0);
	}
	if (!status)
		status = begin(run, state, report);
	return status ? status : winch(run, until, report);
}

void hawser__tow_run_close(struct hawser__tow_run *run)
{
	hawser__rod_motion_clear(&run->motion);
	hawser__tow_rod_close(&run->rod);
	free(run->own.segment);
	free(run->phase);
}
