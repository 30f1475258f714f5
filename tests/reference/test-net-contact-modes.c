/* Modes of nets on obstacles: K*phi = omega^2*M*phi against differences of the exact gradient along
 * paths on the obstacles, which needs no second derivative of a gap; own numbers for B Table 3.6; a
 * string on a floor; the belt of B Table 3.3, whose circulation has the frequency 0.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "net/net.h"
#include "tests/tap.h"

static struct hawser_report report;

static int solved(struct hawser_net *net, struct hawser_net_modes *modes, int n, const char *scene,
                  const char *const *set, size_t sets)
{
	const char *path = source_file("notebooks-data/scenes/%s.yaml", scene);
	enum hawser_status status;

	report.message[0] = '\0';
	memset(modes, 0, sizeof *modes);
	status = hawser_net_open(net, path, set, sets, &report);
	if (!status)
		status = hawser_net_modes_solve(modes, net, n, &report);
	return ok(!status, "%s: %s", scene, status ? report.message : "solved");
}

static void done(struct hawser_net *net, struct hawser_net_modes *modes)
{
	hawser_net_modes_clear(modes);
	hawser_net_clear(net);
}

/* Place and velocity of a point on the path: along the shape, and back to the first circle that it
 * touches. */
static void path(double q[3], double v[3], const struct hawser_net *net,
                 const struct hawser_net_modes *modes, int j, int p, double e)
{
	const double *phi = modes->point[(size_t)j*(size_t)modes->points + (size_t)p];

	for (int k = 0; k < 3; k++) {
		q[k] = modes->place[p][k] + e*phi[k];
		v[k] = phi[k];
	}
	for (int s = 0; s < net->surfaces && modes->state[p] == HAWSER_NET_SLIP; s++) {
		const struct hawser_surface *circle = &net->surface[s];
		double d[2] = {q[0] - circle->at[0], q[1] - circle->at[1]}, l = hypot(d[0], d[1]), along;

		if (circle->kind != HAWSER_SURFACE_CIRCLE || fabs(l - circle->radius) > 1e-4*circle->radius)
			continue;
		along = (d[0]*phi[0] + d[1]*phi[1])/l;
		for (int k = 0; k < 2; k++) {
			q[k] = circle->at[k] + circle->radius*d[k]/l;
			v[k] = circle->radius/l*(phi[k] - along*d[k]/l);
		}
	}
}

/* d(energy)/de at e on the path of mode j. */
static double slope(struct hawser__mesh *mesh, const struct hawser_net *net,
                    const struct hawser_net_modes *modes, int j, double e)
{
	double (*f)[3] = calloc((size_t)mesh->nodes, sizeof *f), (*v)[3], sum = 0.0;
	int p = 0;

	v = calloc((size_t)mesh->nodes, sizeof *v);
	for (int c = 0; c < mesh->cables; c++)
		for (int i = mesh->first[c]; i <= mesh->first[c + 1]; i++, p++) {
			int last = i == mesh->first[c + 1], node = mesh->end[last ? i - 1 : i][last];

			path(mesh->q[node], v[node], net, modes, j, p, e);
		}
	hawser__mesh_gradient(f, NULL, mesh);
	for (int i = 0; i < 3*mesh->nodes; i++)
		sum += f[i/3][i%3]*v[i/3][i%3];
	free(f);
	free(v);
	return sum;
}

static void differences(const struct hawser_net *net, const struct hawser_net_modes *modes, double step,
                        double tolerance)
{
	struct hawser__mesh mesh;
	double worst = 0.0;

	if (!ok(!hawser__mesh_build(&mesh, net, &report), "mesh"))
		return;
	for (int j = 0; j < modes->n; j++) {
		double e = step, second = (slope(&mesh, net, modes, j, e) - slope(&mesh, net, modes, j, -e))/
		                          (2.0*e);
		double far = (slope(&mesh, net, modes, j, 2.0*e) - slope(&mesh, net, modes, j, -2.0*e))/
		             (4.0*e);
		double want = modes->mass[j]*modes->omega[j]*modes->omega[j];

		worst = fmax(worst, fabs(((4.0*second - far)/3.0)/want - 1.0));
	}
	ok(worst <= tolerance, "%d modes: second derivative of the energy by differences, to %.1e",
	   modes->n, worst);
	hawser__mesh_clear(&mesh);
}

static void expect(const char *elements, const char *set, const double *omega, const char *plane,
                   double tolerance)
{
	const char *const sets[] = {elements, set};
	struct hawser_net net;
	struct hawser_net_modes modes;
	double worst = 0.0;
	int planes = 1;

	if (solved(&net, &modes, 4, "net-table-3-6", sets, 2)) {
		for (int j = 0; j < 4; j++) {
			worst = fmax(worst, fabs(modes.omega[j]/omega[j] - 1.0));
			planes = planes && (modes.share[j][2] > 0.5) == (plane[j] == 'z');
		}
		ok(worst <= tolerance && planes, "B Table 3.6, %s: own numbers to %.1e", set, worst);
	}
	done(&net, &modes);
}

/* A sheave that turns with the rope; numbers of `hawser modes` of the span with exact catenaries. */
static void rolling(void)
{
	const char *sets[] = {"contact.modes=stick", "obstacles.sheave.rotation=free",
	                      "obstacles.sheave.inertia=1e6 kg.m^2", "cables.rope.elements=1000"};
	static const double heavy[] = {1.27468290, 1.52529388, 1.52529388, 3.03335633, 3.03341049};
	struct hawser_net net;
	struct hawser_net_modes modes;
	double worst = 0.0;

	if (solved(&net, &modes, 5, "net-table-3-6", sets, 4)) {
		for (int j = 0; j < 5; j++)
			worst = fmax(worst, fabs(modes.omega[j]/heavy[j] - 1.0));
		ok(worst <= 2e-4 && modes.share[0][0] + modes.share[0][1] < 0.8,
		   "a sheave that turns, 1e6 kg*m^2: modes of exact catenaries to %.1e", worst);
	}
	done(&net, &modes);
}

static void table_3_6(void)
{
	static const double slip[] = {1.49496, 1.52514, 1.52514, 3.03304};
	static const double aside[] = {1.22338, 2.43481, 2.44519, 3.47141};
	static const double stick[] = {1.52514, 1.52514, 3.03304, 3.03304};
	static const char *const few[] = {"cables.rope.elements=300",
	                                  "obstacles.sheave.circle.centre=[50 m, -5 m]"};
	struct hawser_net net;
	struct hawser_net_modes modes;

	expect("cables.rope.elements=3000", "contact.modes=slip", slip, "pzzp", 4e-6);
	expect("cables.rope.elements=3000", "obstacles.sheave.circle.centre=[50 m, -5 m]", aside,
	       "zpzp", 4e-6);
	expect("cables.rope.elements=3000", "contact.modes=stick", stick, "zzpp", 4e-6);
	if (solved(&net, &modes, 8, "net-table-3-6", few, 2)) {
		int touch = 0;

		for (int p = 0; p < modes.points; p++)
			touch += modes.state[p] == HAWSER_NET_SLIP;
		ok(touch == modes.contacts && touch > 3 && modes.below > 0.0, "%d nodes touch", touch);
		differences(&net, &modes, 1e-3, 1e-8);
	}
	done(&net, &modes);
}

/* Mean tension of the belt with n elements along each quarter of a circle; its modes are left. */
static double belt(struct hawser_net *net, struct hawser_net_modes *modes, int n)
{
	const double polygon = 4.0*n*0.05*sin(M_PI/(4*n)), s = 1.2/(2.0*(0.45 + polygon));
	static const char *const name[] = {"upper", "r1", "r2", "lower", "l1", "l2"};
	char text[12][80];
	const char *set[12];
	double r = 0.0;

	for (int i = 0; i < 6; i++) {
		snprintf(text[2*i], sizeof text[0], "cables.%s.length0=%.17g m", name[i],
		         i % 3 ? polygon*s/2.0 : 0.45*s);
		snprintf(text[2*i + 1], sizeof text[0], "cables.%s.elements=%d", name[i], i % 3 ? n : 6*n);
		set[2*i] = text[2*i];
		set[2*i + 1] = text[2*i + 1];
	}
	if (!solved(net, modes, 1, "net-belt", set, 12))
		return NAN;
	for (int i = 0; i < modes->contacts; i++)
		r += fabs(modes->contact[i].r*(modes->contact[i].x[0] < 0.2 ? modes->contact[i].x[0]
		                               : modes->contact[i].x[0] - 0.45))/0.05/4.0;
	return r; /* on each circle two tensions, balanced by the components along x */
}

/* B Table 3.3: along the path 2*0.45 + 2*pi*0.05 = 1.214159 m the strain of the rope of 1.2 m is
 * 1.17994 %. */
static void belts(void)
{
	struct hawser_net net;
	struct hawser_net_modes modes;
	double T[2], k = 0.0, without, exact;

	for (int i = 0; i < 2; i++) {
		T[i] = belt(&net, &modes, i ? 16 : 8);
		for (int j = 0; j < modes.contacts && i; j++)
			k += modes.contact[j].r/0.05;
		if (i == 0 || !modes.omega)
			done(&net, &modes);
	}
	close_to((4.0*T[1] - T[0])/3.0, 358.701, 2e-5, "belt: tension, N, from two meshes");
	close_to((4.0*T[1] - T[0])/3.0/0.05, 7174.0, 2e-5, "  force per length on the circles, N/m");
	if (!modes.omega)
		return;
	without = sqrt(modes.omega[0]*modes.omega[0] + k/modes.mass[0]);
	exact = sqrt(2.0*M_PI*T[1]/(0.05*0.096*1.2));
	ok(modes.along[0] > 0.99 && modes.omega[0] <= 0.01*exact && modes.omega[0] <= modes.corners[0],
	   "  it circulates with %.3g rad/s; corners explain up to %.3g", modes.omega[0], modes.corners[0]);
	close_to(without, exact, 0.02, "  without the curvature of the circles, rad/s");
	done(&net, &modes);
}

/* A belt whose nodes begin near a position that is not stable. */
static void off_centre(void)
{
	static const char *const set[] = {
		"cables.upper.elements=100", "cables.lower.elements=100", "cables.r1.elements=20",
		"cables.r2.elements=20", "cables.l1.elements=20", "cables.l2.elements=20"};
	struct hawser_net net;
	struct hawser_net_statics st = {0};
	const char *path = source_file("notebooks-data/scenes/net-belt.yaml");
	enum hawser_status status;

	status = hawser_net_open(&net, path, set, 6, &report);
	if (!status)
		status = hawser_net_solve(&st, &net, NULL, &report);
	if (ok(!status, "belt off centre: %s", status ? report.message : "solved"))
		close_to(st.member[0].T_max, 358.701, 6e-3, "  its tension, N, of a coarse polygon");
	hawser_net_statics_clear(&st);
	hawser_net_clear(&net);
}

/* A string along a floor: with weight it touches everywhere, without it nowhere for certain. */
static void floors(void)
{
	static char name[] = "floor";
	struct hawser_net_node node[2] = {
		{.name = "A", .placed = 1, .held = {1, 1, 1}, .support = 1},
		{.name = "B", .placed = 1, .x = {10.0}, .held = {1, 1, 1}, .support = 1}};
	struct hawser_net_cable cable = {.name = "c", .from = 0, .to = 1, .EA = 1e6, .rho = 2.0,
	                                 .value = 9.99, .elements = 50};
	struct hawser_surface plane = {.name = "plane", .friction = 0.4, .normal = {0.0, 1.0, 0.0}};
	struct hawser_net net = {.name = name, .g = 9.81, .node = node, .cable = &cable, .nodes = 2,
	                         .cables = 1, .surface = &plane, .surfaces = 1};
	struct hawser_net_modes modes;
	double c = sqrt(1e6*(10.0/9.99 - 1.0)*10.0/(2.0*9.99)), worst = 0.0;

	net.contact.modes = HAWSER_NET_MODES_SLIP;
	if (ok(!hawser_net_modes_solve(&modes, &net, 6, &report), "string on a floor: %s",
	       report.message)) {
		for (int j = 0; j < 6; j++)
			worst = fmax(worst, fabs(modes.omega[j]/((j + 1)*M_PI/10.0*c) - 1.0));
		ok(worst < 1e-4 && modes.contacts == 49 && modes.share[5][2] > 1.0 - 1e-12,
		   "it slides across: transverse modes within the plane, to %.1e", worst);
	}
	hawser_net_modes_clear(&modes);
	net.contact.modes = HAWSER_NET_MODES_STATICS;
	ok(hawser_net_modes_solve(&modes, &net, 6, &report) == HAWSER_ERR_NO_SOLUTION,
	   "all sticks: %s", report.message);
	plane.friction = 0.0;
	net.contact.modes = HAWSER_NET_MODES_STICK;
	ok(hawser_net_modes_solve(&modes, &net, 6, &report) == HAWSER_ERR_ARGUMENT, "%s", report.message);
	net.g = 0.0;
	net.contact.modes = HAWSER_NET_MODES_SLIP;
	if (ok(!hawser_net_modes_solve(&modes, &net, 6, &report), "no weight: %s", report.message))
		ok(modes.doubtful == 49 && modes.contacts == 0, "%d nodes touch without force", modes.doubtful);
	hawser_net_modes_clear(&modes);
}

CASE(reference_net_contact_modes)
{
	floors();
	belts();
	off_centre();
	table_3_6();
	rolling();
	return done_testing();
}
