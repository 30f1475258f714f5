/* What the schemes of time integration do to a vibration of small amplitude: the damping ratio and the
 * change of the frequency that a step causes, against closed forms; the table of
 * doc/theory-net-motion.md.
 *
 * And what damping of the scene does: viscous, alpha/(2 rho omega) of any mode; Kelvin-Voigt,
 * axial*omega/2 of axial ones.
 *
 * The vibration is the first transverse mode of a taut string without weight, mean mass matrix: omega
 * is exact. With z the factor of a step, the damping ratio is -ln|z|/|ln z| and the frequency
 * |arg z|/h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <complex.h>
#include <stdlib.h>

#include "net/motion/motion.h"
#include "tests/tap.h"

enum { N = 8 };
static struct hawser_report report;

struct motion {
	struct hawser__mesh mesh;
	struct hawser__motion run;
	double omega;
};

/* A string of 3 m between supports, with a strain of 1 %. */
static int open(struct motion *motion, const char *scheme, double rho_inf)
{
	static char name[] = "string";
	struct hawser_net_node node[2] = {
		{.name = "A", .placed = 1, .held = {1, 1, 1}, .support = 1},
		{.name = "B", .placed = 1, .x = {3.03, 0.0, 0.0}, .held = {1, 1, 1}, .support = 1}};
	struct hawser_net_cable cable = {.name = "c", .from = 0, .to = 1, .EA = 2385.0, .rho = 0.37,
	                                 .value = 3.0, .elements = N};
	struct hawser_net net = {.name = name, .node = node, .cable = &cable, .nodes = 2, .cables = 1};
	struct hawser__equilibrium found;
	double T = 0.01*cable.EA, m = cable.rho*3.0/N, l = 3.03/N, s = sin(0.5*M_PI/N);

	/* stiffness 4 T/l s^2 over mass m (10 + 2 cos)/12 = m (1 - s^2/3) */
	motion->omega = 2.0*s*sqrt(T/(l*m*(1.0 - s*s/3.0)));
	return ok(!hawser__mesh_build(&motion->mesh, &net, &report) &&
	          !hawser__mesh_statics(&motion->mesh, NULL, &found, NULL, &report) &&
	          !hawser__motion_open(&motion->run, &motion->mesh, scheme, rho_inf, 1, NULL, &report),
	          "%s %s", scheme, report.message);
}

/* Displacement of the mode, and 0 of the others, after each of `steps` steps: q [steps + 1]. */
static int vibrate(double *q, struct motion *motion, int steps, double h)
{
	struct hawser__motion *run = &motion->run;
	const double small = 1e-6;

	for (int i = 2; i < run->nodes; i++)
		run->u[i][2] = small*sin(M_PI*(i - 1)/N);
	if (hawser__motion_begin(run, &report))
		return 0;
	for (int i = 0; i <= steps; i++) {
		q[i] = 0.0;
		for (int n = 2; n < run->nodes; n++)
			q[i] += 2.0/N*run->u[n][2]*sin(M_PI*(n - 1)/N)/small;
		if (i < steps && hawser__motion_step(run, h, &report))
			return 0;
	}
	return 1;
}

/* z of q[i] = Re(c z^i): q[i + 1] = 2 Re(z) q[i] - |z|^2 q[i - 1], by least squares from `from` on. */
static double complex factor(const double *q, int from, int steps)
{
	double aa = 0.0, ab = 0.0, bb = 0.0, ra = 0.0, rb = 0.0, det, sum, product;

	for (int i = from; i < steps; i++) {
		aa += q[i]*q[i];
		ab -= q[i]*q[i - 1];
		bb += q[i - 1]*q[i - 1];
		ra += q[i + 1]*q[i];
		rb -= q[i + 1]*q[i - 1];
	}
	det = aa*bb - ab*ab;
	sum = (ra*bb - rb*ab)/det;
	product = (aa*rb - ab*ra)/det;
	return 0.5*sum + I*sqrt(product - 0.25*sum*sum);
}

/* The same in closed form, w = omega*h. Implicit Euler: 1/(1 - i w). Trapezoidal rule, and the discrete
 * gradient of small vibrations: (2 + i w)/(2 - i w). Generalised-alpha: the root next to the circle of
 * its characteristic polynomial. */
static double complex closed(const char *scheme, double rho, double w)
{
	double am = (2.0*rho - 1.0)/(rho + 1.0), af = rho/(rho + 1.0), g = 0.5 - am + af,
	       b = 0.25*(1.0 - am + af)*(1.0 - am + af);
	double complex z = cexp(I*w);

	if (strcmp(scheme, "euler") == 0)
		return 1.0/(1.0 - I*w);
	if (strcmp(scheme, "alpha") != 0)
		return (2.0 + I*w)/(2.0 - I*w);
	for (int i = 0; i < 50; i++) {
		/* u, v, a in units of h: (1-am) a1 + am a0 + w^2 ((1-af) u1 + af u0) = 0 with a1 = z a0;
		 * v = a (1-g+g z)/(z-1), u = (v + a (1/2-b + b z))/(z-1) */
		double complex e[2];

		for (int k = 0; k < 2; k++) {
			double complex y = z + k*1e-7, v = (1.0 - g + g*y)/(y - 1.0),
			               u = (v + 0.5 - b + b*y)/(y - 1.0);

			e[k] = (1.0 - am)*y + am + w*w*u*((1.0 - af)*y + af);
		}
		z -= e[0]*1e-7/(e[1] - e[0]);
	}
	return z;
}

/* Damping ratio of the first transverse (direction 2) or axial mode (0) of the string, damped. */
static double damped(double *omega, int direction, double alpha, double axial)
{
	enum { STEPS = 400, PERIODS = 4 };
	static double q[PERIODS*STEPS + 1];
	struct motion motion;
	const double small = 1e-4;
	double h, s = sin(0.5*M_PI/N), k, m;
	double complex z;

	if (!open(&motion, "energy", -1.0))
		return NAN;
	k = motion.run.element[0].k;
	m = motion.run.element[0].m;
	*omega = direction == 2 ? motion.omega : 2.0*s*sqrt(k/(m*(1.0 - s*s/3.0)));
	h = 2.0*M_PI/(*omega*STEPS);
	for (int e = 0; e < motion.run.elements; e++) {
		motion.run.element[e].drag = alpha*motion.mesh.length0[e];
		motion.run.element[e].c = k*axial;
	}
	for (int i = 2; i < motion.run.nodes; i++)
		motion.run.u[i][direction] = small*sin(M_PI*(i - 1)/N);
	if (hawser__motion_begin(&motion.run, &report))
		return NAN;
	for (int i = 0; i <= PERIODS*STEPS; i++) {
		q[i] = motion.run.u[5][direction]/small;
		if (i < PERIODS*STEPS && hawser__motion_step(&motion.run, h, &report))
			return NAN;
	}
	ok(motion.run.closure <= 1e-10*motion.run.most_energy && motion.run.energy.dissipated > 0.0,
	   "%.2e J dissipated, ledger to %.1e", motion.run.energy.dissipated,
	   motion.run.closure/motion.run.most_energy);
	z = factor(q, 1, PERIODS*STEPS);
	hawser__motion_clear(&motion.run);
	hawser__mesh_clear(&motion.mesh);
	return -log(cabs(z))/cabs(clog(z));
}

static void scene_damping(void)
{
	double omega, got;

	for (int direction = 0; direction < 3; direction += 2) {
		got = damped(&omega, direction, 0.07*2.0*0.37*1.0, 0.0);
		close_to(got*omega, 0.07, 1e-4, "viscous damping alpha/(2 rho)");
	}
	got = damped(&omega, 0, 0.0, 1e-4);
	close_to(got, 0.5*1e-4*omega, 1e-4, "Kelvin-Voigt damping axial*omega/2");
	got = damped(&omega, 2, 0.0, 1e-4);
	ok(got < 1e-2*0.5*1e-4*omega, "transverse vibrations of small amplitude: %.1e of that",
	   got/(0.5*1e-4*omega));
}

static double ratio(double complex z)
{
	return -log(cabs(z))/cabs(clog(z));
}

CASE(property_net_damping)
{
	static const struct {
		const char *scheme;
		double rho;
	} row[] = {{"energy", -1.0}, {"theta", -1.0}, {"alpha", 0.9}, {"alpha", 0.5}, {"alpha", 0.0},
	           {"euler", -1.0}};
	static const int steps_of[] = {20, 40, 80, 160};
	double q[801];

	scene_damping();
	for (size_t s = 0; s < sizeof row/sizeof *row; s++) {
		double damping[4], period[4];

		for (int i = 0; i < 4; i++) { /* steps a period */
			struct motion motion;
			double h, w = 2.0*M_PI/steps_of[i];
			double complex z, want = closed(row[s].scheme, row[s].rho, w);

			if (!open(&motion, row[s].scheme, row[s].rho))
				return done_testing();
			h = w/motion.omega;
			ok(vibrate(q, &motion, 5*steps_of[i], h), "%d steps a period", steps_of[i]);
			z = factor(q, 2*steps_of[i], 5*steps_of[i]);
			damping[i] = ratio(z);
			period[i] = 1.0 - carg(z)/w;
			printf("# %-6s rho_inf %4.1f, %3d steps a period: damping ratio %8.1e (closed form %8.1e), "
			       "frequency lower by %.2e (%.2e)\n", row[s].scheme, row[s].rho, steps_of[i],
			       damping[i], ratio(want), period[i], 1.0 - carg(want)/w);
			ok(cabs(z - want) <= 1e-7, "z is that of the closed form to %.1e", cabs(z - want));
			hawser__motion_clear(&motion.run);
			hawser__mesh_clear(&motion.mesh);
		}
		if (strcmp(row[s].scheme, "euler") == 0)
			ok(fabs(damping[3]/(M_PI/160.0) - 1.0) <= 0.001 &&
			   fabs(log2(damping[2]/damping[3]) - 1.0) <= 0.01,
			   "euler damps by omega h/2: %.4f of it, order %.3f", damping[3]/(M_PI/160.0),
			   log2(damping[2]/damping[3]));
		else
			ok(fabs(log2(period[2]/period[3]) - 2.0) <= 0.03, "%s: frequency of order %.3f",
			   row[s].scheme, log2(period[2]/period[3]));
		if (row[s].rho >= 0.0)
			ok(fabs(log2(damping[2]/damping[3]) - 3.0) <= 0.05, "alpha: damping of order %.3f",
			   log2(damping[2]/damping[3]));
		if (strcmp(row[s].scheme, "alpha") != 0 && strcmp(row[s].scheme, "euler") != 0)
			ok(fabs(damping[0]) <= 1e-8, "%s does not damp: %.1e", row[s].scheme, damping[0]);
	}
	return done_testing();
}
