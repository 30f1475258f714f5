/* net/waves/linear.c - matrices of the linear mesh in waves, see linear.h.
 *
 * K     stiffness of the eigenproblem of modes, less the derivatives of the water's loads by places
 * M     mean of the consistent and the lumped mass, with the added mass lumped to the ends
 * C     damping of the scene
 *
 * Nodes that touch obstacles move along them only (hawser__touch_hold).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "core/vec3.h"
#include "net/body.h"
#include "net/motion/motion.h"
#include "net/touch/touch.h"
#include "net/water/water.h"
#include "net/waves/linear.h"
#include "water/near.h"
#include "water/water.h"

/* Height over which a line comes out of the water, over its diameter. */
static const double BAND = 0.01;

void hawser__linear_mesh_clear(struct hawser__linear_mesh *linear)
{
	hawser__klu_clear(linear->re);
	hawser__klu_clear(linear->im);
	hawser__mesh_clear(&linear->mesh);
	hawser__hold_clear(&linear->hold);
	hawser__bodies_unseat(&linear->seated, &linear->seated);
}

/* A block over both ends of an element, from the axes x, y, z to the directions of the unknowns. */
static void turn(double B[6][6], const struct hawser__mesh *mesh, int e)
{
	double axis[6][3], part[6][6];

	if (!mesh->frame)
		return;
	for (int k = 0; k < 6; k++)
		hawser__mesh_axis(axis[k], mesh, mesh->end[e][k/3], k%3);
	for (int i = 0; i < 6; i++)
		for (int j = 0; j < 6; j++)
			part[i][j] = hawser__dot(axis[i], (const double [3]){
				B[3*(i/3)][j], B[3*(i/3) + 1][j], B[3*(i/3) + 2][j]});
	for (int i = 0; i < 6; i++)
		for (int j = 0; j < 6; j++)
			B[i][j] = hawser__dot(axis[j], &part[i][3*(j/3)]);
}

/* B += [P, -P; -P, P], P = a*I + b*d*d' */
static void add_pair(double B[6][6], double a, double b, const double d[3])
{
	for (int i = 0; i < 6; i++)
		for (int j = 0; j < 6; j++) {
			double value = b*d[i%3]*d[j%3] + (i%3 == j%3 ? a : 0.0);

			B[i][j] += i/3 == j/3 ? value : -value;
		}
}

/* B += a*I + b*d*d' at one end. */
static void add_end(double B[6][6], int end, double a, double b, const double d[3])
{
	for (int i = 0; i < 3; i++)
		for (int j = 0; j < 3; j++)
			B[3*end + i][3*end + j] += b*d[i]*d[j] + (i == j ? a : 0.0);
}

static void element(struct hawser__linear_mesh *linear, int e)
{
	const struct hawser__mesh *mesh = &linear->mesh;
	double d[3], l = hawser__mesh_direction(d, mesh, e), T = fmax(linear->T[e], 0.0);
	double L = mesh->length0[e], m = mesh->rho[e]*L, k = T > 0.0 ? mesh->EA[e]/L : 0.0;

	add_pair(linear->K[e], T/l, k - T/l, d);
	add_pair(linear->C[e], 0.0, k*mesh->axial[e], d);
	add_pair(linear->M[e], -m/12.0, 0.0, d);
	for (int end = 0; end < 2; end++) {
		add_end(linear->M[e], end, m/2.0, 0.0, d);
		add_end(linear->C[e], end, mesh->alpha*L/2.0 + linear->net->mass_rate*m/2.0, 0.0, d);
	}
	for (int i = 0; i < 36; i++)
		linear->K[e][i/6][i%6] -= mesh->water->slope[e][i/6][i%6];
}

/* An end of an element. */
static void wet_end(struct hawser__linear_mesh *linear, int e, int end)
{
	const struct hawser__mesh *mesh = &linear->mesh;
	const struct hawser_water *water = &linear->net->water;
	const struct hawser_water_line *line = mesh->water->line[e];
	const double radius = 0.5*line->diameter, y[2] = {mesh->q[mesh->end[e][0]][1],
	                                                  mesh->q[mesh->end[e][1]][1]};
	struct hawser__wetted *wet = &linear->wet[linear->wets];
	struct hawser__wet part;
	double length, u_y[3];

	if (!(radius > 0.0))
		return;
	hawser__wet_line(&part, water->surface, BAND*line->diameter, y);
	length = mesh->length0[e]*part.part[end];
	if (!(length > 0.0))
		return;
	*wet = (struct hawser__wetted){.node = mesh->end[e][end], .element = e, .end = end};
	hawser__mesh_direction(wet->along, mesh, e);
	wet->displaced = water->density*M_PI*radius*radius*length;
	wet->spring = -water->density*M_PI*radius*radius*mesh->g*mesh->length0[e]*
	              (part.by[end][0] + part.by[end][1]);
	wet->added[0] = line->added_normal;
	wet->added[1] = line->added_tangential;
	wet->drag[0] = water->density*radius*line->normal*length;
	wet->drag[1] = water->density*M_PI*radius*line->tangential*length;
	hawser__water_current(wet->current, u_y, water, y[end]);
	linear->wets++;
}

static void wet_buoy(struct hawser__linear_mesh *linear, const struct hawser__mesh_buoy *buoy)
{
	const struct hawser_water *water = &linear->net->water;
	struct hawser__wetted *wet = &linear->wet[linear->wets++];
	double y = linear->mesh.q[buoy->node][1], by, volume, part, u_y[3];

	volume = hawser__wet_sphere(&by, water->surface, buoy->of->volume, y);
	part = buoy->of->volume > 0.0 ? volume/buoy->of->volume : y < water->surface;
	*wet = (struct hawser__wetted){.node = buoy->node, .element = buoy->element, .end = buoy->end,
	                               .buoy = buoy};
	wet->displaced = water->density*volume;
	wet->spring = -water->density*linear->mesh.g*by;
	wet->added[0] = wet->added[1] = buoy->of->added;
	wet->drag[0] = wet->drag[1] = 0.5*water->density*buoy->of->CdA*part;
	hawser__water_current(wet->current, u_y, water, y);
	for (int i = 0; i < 9 && !linear->mesh.rigid[buoy->node]; i++)
		linear->K[buoy->element][3*buoy->end + i/3][3*buoy->end + i%3] -= buoy->slope[i/3][i%3];
}

/* Masses, dampers and curved contacts of nodes, in the block of an element there. */
static void nodes(struct hawser__linear_mesh *linear)
{
	static const double none[3] = {0.0};
	const struct hawser__mesh *mesh = &linear->mesh;

	for (int k = 2*mesh->elements - 1; k >= 0; k--) {
		int e = k/2, end = k%2, node = mesh->end[e][end], first = 1;

		for (int j = 2*mesh->elements - 1; node < linear->net->nodes && j > k; j--)
			first = first && mesh->end[j/2][j%2] != node;
		if (node >= linear->net->nodes || !first || mesh->rigid[node])
			continue;
		add_end(linear->M[e], end, mesh->mass[node], 0.0, none);
		for (int i = 0; i < 3; i++)
			linear->C[e][3*end + i][3*end + i] += mesh->damper[node][i] +
			                                      linear->net->mass_rate*mesh->mass[node];
		for (int i = 0; i < 3; i++)
			linear->K[e][3*end + i][3*end + i] += mesh->spring[node][i];
	}
	for (int i = 0; i < mesh->touches; i++) {
		const struct hawser__touch *touch = &mesh->touch[i];

		for (int j = 0; j < 9 && touch->r > 0.0 && !mesh->rigid[touch->node]; j++)
			linear->K[touch->element][3*touch->end + j/3][3*touch->end + j%3] -=
				touch->r*touch->H[j/3][j%3];
	}
}

static void fill(struct hawser__linear_mesh *linear)
{
	const struct hawser__mesh *mesh = &linear->mesh;

	hawser__water_load(&linear->mesh);
	for (int e = 0; e < mesh->elements; e++) {
		element(linear, e);
		wet_end(linear, e, 0);
		wet_end(linear, e, 1);
	}
	for (int i = 0; i < mesh->water->buoys; i++)
		wet_buoy(linear, &mesh->water->buoy[i]);
	nodes(linear);
	for (int i = 0; i < linear->wets; i++) {
		const struct hawser__wetted *wet = &linear->wet[i];
		double a = wet->displaced*wet->added[0], b = wet->displaced*wet->added[1] - a;

		if (!wet->buoy || !mesh->rigid[wet->node])
			add_end(linear->M[wet->element], wet->end, a, b, wet->along);
	}
	for (int e = 0; e < mesh->elements; e++) {
		turn(linear->K[e], mesh, e);
		turn(linear->M[e], mesh, e);
		turn(linear->C[e], mesh, e);
	}
}

static enum hawser_status hold(struct hawser__linear_mesh *linear, struct hawser_report *report)
{
	struct hawser__mesh *mesh = &linear->mesh;
	unsigned char *state = malloc((size_t)mesh->nodes + 1);
	enum hawser_status status = !state ? hawser__no_memory(report, "net")
		: hawser__touch_hold(state, mesh, linear->net, linear->net->contact.modes, report);

	free(state);
	return status;
}

enum hawser_status hawser__linear_mesh_open(struct hawser__linear_mesh *linear,
                                            const struct hawser_net *given,
                                            struct hawser_report *report)
{
	struct hawser__mesh *mesh = &linear->mesh, nodes; /* without bodies */
	const struct hawser_net *net = &linear->seated;
	size_t elements;
	double rest;
	enum hawser_status status;

	*linear = (struct hawser__linear_mesh){.net = net};
	status = hawser__mesh_lawless(given, "the linear response", report);
	if (!status)
		status = hawser__bodies_seat(&linear->seated, &rest, given, 0, report);
	if (!status && net->absorbers)
		return hawser__fail(report, HAWSER_ERR_SCENE, "net", "%s: absorbers: the response to waves has "
		                    "none: leave them out, or give a mass on a soft cable", net->name);
	if (!status)
		status = hawser__mesh_build(mesh, net, report);
	elements = (size_t)mesh->elements + 1;
	if (!status && !(linear->T = hawser__hold(&linear->hold, elements, sizeof *linear->T)))
		status = hawser__no_memory(report, "net");
	if (!status)
		status = hawser__net_equilibrium(mesh, linear->T, net, report);
	if (!status)
		status = hawser__bodies_land(mesh, net, report);
	if (!status && mesh->touches)
		status = hold(linear, report);
	nodes = *mesh;
	if (!status)
		status = hawser__bodies_release(mesh, net, report);
	if (!status)
		status = hawser__linear_bodies_open(linear, report);
	linear->K = hawser__hold(&linear->hold, elements, sizeof *linear->K);
	linear->M = hawser__hold(&linear->hold, elements, sizeof *linear->M);
	linear->C = hawser__hold(&linear->hold, elements, sizeof *linear->C);
	linear->wet = hawser__hold(&linear->hold, 2*elements + (size_t)net->nodes, sizeof *linear->wet);
	linear->right = hawser__hold(&linear->hold, 2*(size_t)mesh->unknowns + 1, sizeof *linear->right);
	linear->x = hawser__hold(&linear->hold, (size_t)mesh->nodes + 1, sizeof *linear->x);
	if (!status && linear->hold.short_of_memory)
		status = hawser__no_memory(report, "net");
	if (!status)
		status = hawser__klu_open(&linear->re, &nodes, report);
	if (!status)
		status = hawser__klu_open(&linear->im, &nodes, report);
	if (!status)
		fill(linear);
	return status;
}

void hawser__linear_mesh_wave(struct hawser__linear_mesh *linear, double omega)
{
	const struct hawser_net *net = linear->net;
	const struct hawser_waves *waves = &net->water.waves;
	double k = hawser_wave_number(omega, waves->depth, net->g > 0.0 ? net->g : 9.81);

	for (int i = 0; i < linear->wets; i++) {
		struct hawser__wetted *wet = &linear->wet[i];
		const double *x = linear->mesh.q[wet->node];
		double y = fmax(fmin(x[1] - waves->surface, 0.0), -waves->depth);
		struct hawser__profile at = hawser__wave_profile(k, y, waves->depth);
		double complex crest = omega*cexp(I*k*(waves->along[0]*x[0] + waves->along[1]*x[2]));

		wet->elevation = waves->stretching == HAWSER_STRETCH_NONE ? 0.0 : crest/omega;
		wet->u[0] = waves->along[0]*at.C*crest;
		wet->u[1] = -I*at.S*crest;
		wet->u[2] = waves->along[1]*at.C*crest;
	}
}

void hawser__linear_mesh_relative(double complex r[3], const struct hawser__linear_mesh *linear,
                                  const struct hawser__wetted *wet, double omega)
{
	for (int k = 0; k < 3; k++)
		r[k] = wet->u[k] + I*omega*linear->x[wet->node][k];
}

/* The force of the water on a line at rest: inertia, drag and the buoyancy under the crest. */
static void force(struct hawser__linear_mesh *linear, const struct hawser__wetted *wet, double omega)
{
	const struct hawser__mesh *mesh = &linear->mesh;
	double complex f[3], along = 0.0;

	for (int k = 0; k < 3; k++)
		along += wet->along[k]*wet->u[k];
	for (int k = 0; k < 3; k++) {
		f[k] = -I*omega*wet->displaced*((1.0 + wet->added[0])*wet->u[k] +
		                                (wet->added[1] - wet->added[0])*along*wet->along[k]);
		for (int j = 0; j < 3; j++)
			f[k] += wet->C[k][j]*wet->u[j];
	}
	f[1] += wet->spring*wet->elevation;
	if (mesh->rigid[wet->node])
		hawser__linear_push(linear, wet->node, f);
	for (int k = 0; k < 3; k++) {
		int unknown = mesh->unknown[wet->node][k];
		double axis[3];

		if (unknown < 0)
			continue;
		hawser__mesh_axis(axis, mesh, wet->node, k);
		for (int j = 0; j < 3; j++) {
			linear->right[2*unknown] += axis[j]*creal(f[j]);
			linear->right[2*unknown + 1] += axis[j]*cimag(f[j]);
		}
	}
}

void hawser__linear_mesh_places(double complex (*x)[3], const struct hawser__linear_mesh *linear)
{
	const struct hawser__mesh *mesh = &linear->mesh;

	for (int i = 0; i < mesh->nodes; i++)
		for (int j = 0; j < 3 && !mesh->rigid[i]; j++) {
			x[i][j] = 0.0;
			for (int k = 0; k < 3; k++) {
				int unknown = mesh->unknown[i][k];
				double axis[3];

				hawser__mesh_axis(axis, mesh, i, k);
				if (unknown >= 0)
					x[i][j] += axis[j]*(linear->right[2*unknown] + I*linear->right[2*unknown + 1]);
			}
		}
}

enum hawser_status hawser__linear_mesh_solve(struct hawser__linear_mesh *linear, double omega,
                                             struct hawser_report *report)
{
	const struct hawser__mesh *mesh = &linear->mesh;
	enum hawser_status status;
	int good = 0;

	hawser__klu_zero(linear->re);
	hawser__klu_zero(linear->im);
	for (int e = 0; e < mesh->elements; e++) {
		hawser__klu_ends(linear->re, e, (const double (*)[6])linear->K[e], 1.0);
		hawser__klu_ends(linear->re, e, (const double (*)[6])linear->M[e], -omega*omega);
		hawser__klu_ends(linear->im, e, (const double (*)[6])linear->C[e], -omega);
	}
	memset(linear->right, 0, 2*(size_t)mesh->unknowns*sizeof *linear->right);
	memset(linear->load, 0, 2*(size_t)mesh->body_unknowns*sizeof *linear->load);
	for (int i = 0; i < linear->wets; i++) {
		const struct hawser__wetted *wet = &linear->wet[i];
		double block[6][6] = {{0.0}};

		for (int k = 0; k < 9; k++)
			block[3*wet->end + k/3][3*wet->end + k%3] = wet->C[k/3][k%3];
		turn(block, mesh, wet->element);
		if (!mesh->rigid[wet->node])
			hawser__klu_ends(linear->im, wet->element, (const double (*)[6])block, -omega);
		force(linear, wet, omega);
	}
	status = hawser__klu_divide_complex(linear->right, &good, linear->re, linear->im, report);
	if (!status && !good)
		return hawser__fail(report, HAWSER_ERR_CONVERGENCE, "net", "%s: the linear equations at %g "
		                    "rad/s are singular", linear->net->name, omega);
	if (status)
		return status;
	memset(linear->x, 0, (size_t)mesh->nodes*sizeof *linear->x);
	hawser__linear_mesh_places(linear->x, linear);
	return mesh->body_unknowns ? hawser__linear_bodies(linear, omega, report) : HAWSER_OK;
}
