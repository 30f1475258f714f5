/* Motions of rods against another route: the chain of lumped masses as an ordinary differential
 * equation in places, quaternions, velocities and spins, by CVODE's BDF with a
 * banded matrix. It shares the elements' forces with the scheme, and neither steps, nor rates, nor
 * rotations as increments.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_band.h>
#include <sunmatrix/sunmatrix_band.h>

#include <hawser/rod_motion.h>

#include "core/sundials.h"
#include "rod/mesh.h"
#include "rod/so3.h"
#include "tests/tap.h"

#define PI 3.14159265358979323846
enum { NODE = 13 }; /* x, q, v, spin */

struct chain {
	struct hawser__rod_mesh mesh;
	double alpha, force[3], moment[3]; /* 1/s; N; N m, of node 0, in a plane */
	int at;                            /* node of the force */
	double speed, rise;                /* of node 0, about z; 0: as held as the mesh says */
	double until;                      /* of the force, which grows from 0 and falls to 0 if `ramp` */
	int ramp;
};

static double factor(const struct chain *chain, double t)
{
	return !chain->ramp ? 1.0 : fmax(0.0, 1.0 - fabs(2.0*t/chain->until - 1.0));
}

/* Node 0 of the rotor. */
static void drive(double y[NODE], const struct chain *chain, double t)
{
	double p = 2.0*PI/chain->rise, angle, spin;

	angle = chain->speed/chain->rise*(0.5*t*t - (1.0 - cos(p*t))/(p*p));
	spin = chain->speed/chain->rise*(t - sin(p*t)/p);
	memset(y, 0, NODE*sizeof *y);
	y[3] = cos(0.5*angle);
	y[6] = sin(0.5*angle);
	y[12] = spin;
}

static int right_hand_side(double t, N_Vector from, N_Vector to, void *data)
{
	struct chain *chain = data;
	struct hawser__rod_mesh *mesh = &chain->mesh;
	const struct hawser_rod_segment *of = mesh->rod->segment;
	double *y = N_VGetArrayPointer(from), *dy = N_VGetArrayPointer(to), f[6*8] = {0.0}, part[12];

	for (int i = 0; i < mesh->nodes; i++) {
		const double *own = y + (long)NODE*i;
		double driven[NODE], length;

		if (i == 0 && chain->speed > 0.0) {
			drive(driven, chain, t);
			own = driven;
		}
		length = sqrt(own[3]*own[3] + own[4]*own[4] + own[5]*own[5] + own[6]*own[6]);
		memcpy(mesh->node[i].x, own, 3*sizeof *own);
		for (int k = 0; k < 4; k++)
			mesh->node[i].q[k] = own[3 + k]/length;
	}
	if (hawser__rod_strains(mesh) >= 0)
		return 1;
	for (int e = 0; e < mesh->elements; e++) {
		hawser__rod_forces(part, NULL, &mesh->element[e], &mesh->strain[e]);
		for (int k = 0; k < 12; k++)
			f[6*e + k] -= part[k];
	}
	for (int k = 0; k < 3; k++)
		f[6*chain->at + k] += factor(chain, t)*chain->force[k];
	f[5] += factor(chain, t)*chain->moment[2]; /* about z, which a motion in the plane leaves */
	for (int i = 0; i < mesh->nodes; i++) {
		const double *own = y + (long)NODE*i, *w = own + 10, zero[4] = {0.0, w[0], w[1], w[2]};
		double *d = dy + (long)NODE*i, L[3], gyro[3];
		double mass = of->length/mesh->elements*(i == 0 || i == mesh->nodes - 1 ? 0.5 : 1.0);

		memset(d, 0, NODE*sizeof *d);
		if (i == 0 && mesh->held[0])
			continue;
		for (int k = 0; k < 3; k++) {
			d[k] = own[7 + k];
			d[7 + k] = f[6*i + k]/(mass*of->rho) - chain->alpha*own[7 + k];
			L[k] = of->inertia[k]*w[k];
		}
		hawser__quaternion_mul(d + 3, own + 3, zero);
		for (int k = 0; k < 4; k++)
			d[3 + k] *= 0.5;
		hawser__cross(gyro, w, L);
		for (int k = 0; k < 3; k++)
			d[10 + k] = (f[6*i + 3 + k]/mass - gyro[k])/of->inertia[k] - chain->alpha*w[k];
	}
	return 0;
}

/* The last node at time `until`; 0: CVODE has failed. */
static int other(double x[3], struct chain *chain, double until)
{
	struct hawser__sundials sundials;
	int n = NODE*chain->mesh.nodes, good = hawser__sundials_open(&sundials);
	N_Vector y = N_VNew_Serial(n, sundials.context);
	SUNMatrix matrix = SUNBandMatrix(n, 2*NODE - 1, 2*NODE - 1, sundials.context);
	SUNLinearSolver solver = SUNLinSol_Band(y, matrix, sundials.context);
	void *cvode = CVodeCreate(CV_BDF, sundials.context);
	double t = 0.0, *value = N_VGetArrayPointer(y);

	memset(value, 0, (size_t)n*sizeof *value);
	for (int i = 0; i < chain->mesh.nodes; i++) {
		memcpy(value + (long)NODE*i, chain->mesh.rest[i].x, 3*sizeof *value);
		memcpy(value + (long)NODE*i + 3, chain->mesh.rest[i].q, 4*sizeof *value);
	}
	good = good && !CVodeInit(cvode, right_hand_side, 0.0, y) &&
	       !CVodeSStolerances(cvode, 1e-8, 1e-9) && !CVodeSetUserData(cvode, chain) &&
	       !CVodeSetMaxNumSteps(cvode, 200000) &&
	       !CVodeSetLinearSolver(cvode, solver, matrix);
	if (good && chain->ramp) /* the kinks of the load */
		for (int half = 1; half <= 2; half++)
			good = good && !CVodeSetStopTime(cvode, 0.5*half*chain->until) &&
			       CVode(cvode, 0.5*half*chain->until, y, &t, CV_NORMAL) >= 0 &&
			       !CVodeReInit(cvode, 0.5*half*chain->until, y);
	good = good && !CVodeSetStopTime(cvode, until) && CVode(cvode, until, y, &t, CV_NORMAL) >= 0;
	memcpy(x, value + (long)NODE*(chain->mesh.nodes - 1), 3*sizeof *x);
	CVodeFree(&cvode);
	SUNLinSolFree(solver);
	SUNMatDestroy(matrix);
	N_VDestroy(y);
	hawser__sundials_clear(&sundials);
	return good;
}

static void compare(const char *name, const struct hawser_rod *rod, struct chain *chain, double until)
{
	double x[3] = {0.0}, probe = rod->length, apart = 0.0;
	struct hawser_rod_motion_options options = {.until = until, .every = 0.5*until, .tolerance = 1e-7,
	                                            .probe = &probe, .probes = 1};
	struct hawser_rod_motion motion;
	struct hawser_report report;
	int good;

	if (hawser__rod_mesh_open(&chain->mesh, rod, 1, &report) ||
	    hawser_rod_integrate(&motion, rod, &options, &report)) {
		ok(0, "%s: %s", name, report.message);
		return;
	}
	good = other(x, chain, until);
	ok(good, "%s: CVODE ends at %.6f, %.6f, %.6f m", name, x[0], x[1], x[2]);
	for (int k = 0; k < 3; k++)
		apart += pow(motion.x[2][k] - x[k], 2.0);
	ok(motion.checked && motion.step_error < 2e-3 && sqrt(apart) < 1.5*motion.step_error + 2e-5,
	   "the scheme is %.1e m from it, and states %.1e m", sqrt(apart), motion.step_error);
	hawser_rod_motion_clear(&motion);
	hawser__rod_mesh_clear(&chain->mesh);
}

static struct hawser_rod_segment segment;
static struct hawser_rod_load load;

static struct hawser_rod rod_of(double EA, double GA, double EI, double rho, double J, int elements)
{
	segment = (struct hawser_rod_segment){.length = 10.0, .rho = rho, .EA = EA, .GA = {GA, GA},
	                                      .EI = {EI, EI}, .GJ = EI, .inertia = {2.0*J, J, J},
	                                      .elements = elements};
	return (struct hawser_rod){
		.segment = &segment, .segments = 1, .length = 10.0, .load = &load, .loads = 1,
		.hold = {HAWSER_ROD_CLAMPED, HAWSER_ROD_FREE}, .tangent = {1.0, 0.0, 0.0},
		.normal = {0.0, 1.0, 0.0}, .rho_inf = 0.8};
}

CASE(property_rod_cvode)
{
	static double ramp[3][2] = {{0.0, 0.0}, {0.25, 1.0}, {0.5, 0.0}};
	struct hawser_rod rod = rod_of(1e6, 1e6, 1e3, 1.0, 10.0, 4);

	rod.alpha = 0.1;
	load = (struct hawser_rod_load){.from = 10.0, .to = 10.0, .force = {0.0, 90.0, 40.0},
	                                .factor = ramp, .factors = 3};
	compare("a damped cantilever in space", &rod, &(struct chain){
		.alpha = 0.1, .force = {0.0, 90.0, 40.0}, .at = 4, .until = 0.5, .ramp = 1}, 1.2);
	rod = rod_of(1e4, 1e4, 500.0, 1.0, 10.0, 4);
	rod.hold[0] = HAWSER_ROD_FREE;
	load = (struct hawser_rod_load){.force = {-4.8, -6.4, 0.0}, .moment = {0.0, 0.0, -80.0}};
	compare("the flying spaghetti", &rod, &(struct chain){
		.force = {-4.8, -6.4, 0.0}, .moment = {0.0, 0.0, -80.0}}, 1.5);
	rod = rod_of(2.8e5, 1e5, 1.4e4, 1.2, 6e-2, 3);
	rod.drive[0] = (struct hawser_rod_drive){.axis = {0.0, 0.0, 1.0}, .speed = PI, .rise = 1.0};
	load = (struct hawser_rod_load){.from = 10.0, .to = 10.0, .force = {0.0, 0.0, 40.0},
	                                .factor = ramp, .factors = 3};
	compare("a rotor in space", &rod, &(struct chain){
		.force = {0.0, 0.0, 40.0}, .at = 3, .until = 0.5, .ramp = 1, .speed = PI, .rise = 1.0}, 0.9);
	return done_testing();
}
