/* Symmetry of nets and of their modes: webs of n spokes, nets over a rectangle, spans. Turning a
 * scene about the vertical changes no frequency and no label; the planes turn with it; a net whose
 * symmetry is broken has none.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/net_modes.h>

#include "tests/net-random.h"
#include "tests/tap.h"

enum { NODES = 64, CABLES = 128, MODES = 12 };

struct scene {
	struct hawser_net net;
	struct hawser_net_node node[NODES];
	struct hawser_net_cable cable[CABLES];
	struct hawser_net_load load[1];
};

static struct hawser_report report;

static int node(struct scene *s, double x, double y, double z, int held)
{
	int i = s->net.nodes++;

	s->node[i] = (struct hawser_net_node){.placed = 1, .x = {x, y, z}, .support = held};
	snprintf(s->node[i].name, sizeof s->node[i].name, "n%d", i);
	memset(s->node[i].held, held, sizeof s->node[i].held);
	return i;
}

/* A cable shorter than the distance of the given places by `strain`. */
static void cable(struct scene *s, int from, int to, double strain, int elements)
{
	struct hawser_net_cable *c = &s->cable[s->net.cables];
	double d = 0.0;

	for (int k = 0; k < 3; k++)
		d += pow(s->node[from].x[k] - s->node[to].x[k], 2.0);
	*c = (struct hawser_net_cable){.from = from, .to = to, .EA = 1e6, .rho = 0.8,
	                               .value = sqrt(d)*(1.0 - strain), .elements = elements};
	snprintf(c->name, sizeof c->name, "c%d", s->net.cables++);
}

static void begin(struct scene *s)
{
	static char name[] = "scene";

	memset(s, 0, sizeof *s);
	s->net = (struct hawser_net){.name = name, .g = 9.81, .node = s->node, .cable = s->cable,
	                             .load = s->load};
}

/* n spokes to a hub, and a ring; the supports are 1.3 m above it. */
static void web(struct scene *s, int n, double azimuth)
{
	int hub, ring[NODES];

	begin(s);
	hub = node(s, 3.0, 0.0, -2.0, 0);
	for (int i = 0; i < n; i++) {
		double a = azimuth + 2.0*M_PI*i/n, x = cos(a), z = -sin(a);
		int support = node(s, 3.0 + 10.0*x, 1.3, -2.0 + 10.0*z, 1);

		ring[i] = node(s, 3.0 + 5.0*x, 0.3, -2.0 + 5.0*z, 0);
		cable(s, support, ring[i], 1e-3, 3);
		cable(s, hub, ring[i], 1e-3, 3);
	}
	for (int i = 0; i < n; i++)
		cable(s, ring[i], ring[(i + 1) % n], -0.01, 4);
}

/* Two by three meshes over a rectangle. */
static void grid(struct scene *s, double azimuth)
{
	int at[4][3];

	begin(s);
	for (int i = 0; i < 4; i++)
		for (int j = 0; j < 3; j++) {
			double x = 4.0*(i - 1.5), z = 3.0*(j - 1.0);
			int held = i == 0 || i == 3 || j != 1;

			at[i][j] = node(s, x*cos(azimuth) + z*sin(azimuth), 0.0,
			                z*cos(azimuth) - x*sin(azimuth), held);
		}
	for (int i = 0; i < 4; i++)
		for (int j = 0; j < 3; j++) {
			if (i < 3 && j == 1)
				cable(s, at[i][j], at[i + 1][j], 2e-3, 3);
			if (j < 2 && i > 0 && i < 3)
				cable(s, at[i][j], at[i][j + 1], 2e-3, 3);
		}
}

/* A span of three cables; `rise`: of its end. */
static void span(struct scene *s, double azimuth, double rise)
{
	int at[4];

	begin(s);
	for (int i = 0; i < 4; i++)
		at[i] = node(s, 20.0*i*cos(azimuth), rise*i, -20.0*i*sin(azimuth), i % 3 == 0);
	for (int i = 0; i < 3; i++)
		cable(s, at[i], at[i + 1], -0.01, 5);
}

/* Labels of all modes: to the plane of the net, each mirror plane, waves, distance to the pair. */
static int labels(char *text, size_t size, struct hawser_net_modes *modes, const struct scene *s)
{
	size_t used = 0;

	if (hawser_net_modes_solve(modes, &s->net, MODES, &report))
		return ok(0, "%s", report.message);
	for (int j = 0; j < modes->n; j++) {
		const char *plane = hawser_net_plane_side(modes->parity[j][0]);

		used += (size_t)snprintf(text + used, size - used, "%c", plane ? plane[0] : '-');
		for (int k = 0; k < modes->symmetry.mirrors; k++)
			used += (size_t)snprintf(text + used, size - used, "%c",
			                         hawser_net_side(modes->parity[j][1 + k])[0]);
		used += (size_t)snprintf(text + used, size - used, "%d%+d ", modes->waves[j],
		                         modes->pair[j] < 0 ? 0 : modes->pair[j] - j);
	}
	return 1;
}

/* The same scene at other azimuths; a plane's normal turns as the scene does. */
static void turned(const char *what, void (*make)(struct scene *, int, double), int n, int mirrors,
                   int turns)
{
	static const double azimuth[] = {0.0, 0.61, 2.385, 4.9};
	char text[2][MODES*16];
	struct hawser_net_modes modes[2];
	struct scene s;
	int same = 1, found = 1;
	double worst = 0.0, off = 0.0;

	for (int i = 0; i < 4; i++) {
		struct hawser_net_modes *one = &modes[i > 0];

		make(&s, n, azimuth[i]);
		if (!labels(text[i > 0], sizeof text[0], one, &s))
			return;
		found &= one->symmetry.mirrors == mirrors && one->symmetry.turns == turns;
		same &= strcmp(text[0], text[i > 0]) == 0;
		if (strcmp(text[0], text[i > 0]) != 0)
			printf("# %s\n# %s\n", text[0], text[1]);
		for (int j = 0; j < MODES; j++)
			worst = fmax(worst, fabs(one->omega[j]/modes[0].omega[j] - 1.0));
		for (int k = 0; k < one->symmetry.mirrors; k++) {
			double angle = atan2(-one->symmetry.mirror[k].normal[2], one->symmetry.mirror[k].normal[0]);
			double first = atan2(-modes[0].symmetry.mirror[k].normal[2],
			                     modes[0].symmetry.mirror[k].normal[0]);

			off = fmax(off, fabs(sin((turns > 2 ? turns : 1)*(angle - first - azimuth[i]))));
		}
		if (i > 0)
			hawser_net_modes_clear(one);
	}
	ok(found, "%s: %d mirror planes at right angles, turns by 1/%d", what, mirrors, turns);
	ok(same, "the labels do not depend on the azimuth: %s", text[0]);
	ok(worst < 1e-9, "nor the frequencies: %.1e", worst);
	ok(off < 1e-6, "the planes turn with the net: %.1e", off);
	hawser_net_modes_clear(&modes[0]);
}

static void make_grid(struct scene *s, int n, double azimuth)
{
	(void)n;
	grid(s, azimuth);
}

static void make_span(struct scene *s, int n, double azimuth)
{
	span(s, azimuth, n);
}

/* Pairs have the same frequency, one symmetric and one antisymmetric, in a web. */
static void pairs(int n)
{
	struct hawser_net_modes modes;
	struct scene s;
	int good = 1, single = 1;
	double worst = 0.0, mixed = 0.0;

	web(&s, n, 0.3);
	if (hawser_net_modes_solve(&modes, &s.net, MODES, &report)) {
		ok(0, "%s", report.message);
		return;
	}
	for (int j = 0; j < modes.n; j++) {
		int pair = modes.pair[j], paired = modes.waves[j] > 0 && 2*modes.waves[j] < n;

		mixed = fmax(mixed, 1.0 - fabs(modes.parity[j][1]));
		good &= modes.waves[j] >= 0 && (pair >= 0) == paired;
		if (pair < 0 || pair >= modes.n)
			continue;
		worst = fmax(worst, fabs(modes.omega[pair]/modes.omega[j] - 1.0));
		single &= modes.parity[j][1]*modes.parity[pair][1] < -0.999;
	}
	ok(good, "%d spokes: pairs are those of 1 to n/2 waves", n);
	ok(single && mixed < 1e-9, "one is symmetric, one antisymmetric: %.1e", mixed);
	ok(worst < 1e-9, "their frequencies agree to %.1e", worst);
	hawser_net_modes_clear(&modes);
}

static void none(const char *what, const struct scene *s, int mirrors, int turns)
{
	struct hawser_net_modes modes;

	if (hawser_net_modes_solve(&modes, &s->net, 4, &report)) {
		ok(0, "%s: %s", what, report.message);
		return;
	}
	ok(modes.symmetry.mirrors == mirrors && modes.symmetry.turns == turns && modes.waves[0] == -1 &&
	   (mirrors > 0 || isnan(modes.parity[0][1])), "%s: %d planes, turn %d", what,
	   modes.symmetry.mirrors, modes.symmetry.turns);
	hawser_net_modes_clear(&modes);
}

static void broken(void)
{
	struct scene s;

	web(&s, 6, 0.3);
	s.node[2].mass = 0.5;
	none("a mass on one spoke leaves its plane", &s, 1, 1);
	s.node[4].mass = 0.7;
	none("two different masses leave none", &s, 0, 1);
	web(&s, 6, 0.3);
	s.cable[2].EA *= 1.01;
	s.cable[5].rho *= 1.02;
	none("a stiffer cable, a heavier cable", &s, 0, 1);
	web(&s, 5, 0.3);
	s.node[1].x[1] += 0.1;
	s.node[3].x[0] += 0.2;
	none("two supports elsewhere", &s, 0, 1);
	web(&s, 4, 0.3);
	s.net.loads = 1;
	s.load[0] = (struct hawser_net_load){.node = 2, .cable = -1, .value = {30.0, 10.0, -20.0}};
	none("an oblique force", &s, 0, 1);
	grid(&s, 0.3);
	s.cable[0].elements++;
	none("a mesh of its own", &s, 1, 1);
	span(&s, 0.3, 2.0);
	none("an inclined span", &s, 0, 1);
}

/* Half-turn without mirror planes: an S of three cables over four supports. */
static void chiral(void)
{
	struct scene s;
	struct hawser_net_modes modes;
	int a, b;

	begin(&s);
	a = node(&s, -2.0, 0.0, 0.5, 0);
	b = node(&s, 2.0, 0.0, -0.5, 0);
	cable(&s, a, b, 1e-3, 4);
	cable(&s, a, node(&s, -6.0, 0.5, 3.0, 1), 1e-3, 3);
	cable(&s, a, node(&s, -5.0, 0.5, -4.0, 1), 1e-3, 3);
	cable(&s, b, node(&s, 6.0, 0.5, -3.0, 1), 1e-3, 3);
	cable(&s, b, node(&s, 5.0, 0.5, 4.0, 1), 1e-3, 3);
	if (hawser_net_modes_solve(&modes, &s.net, MODES, &report)) {
		ok(0, "%s", report.message);
		return;
	}
	ok(modes.symmetry.mirrors == 0 && modes.symmetry.turns == 2, "a half-turn without mirror planes");
	ok(modes.waves[0] >= 0 && modes.waves[0] <= 1, "waves are 0 or 1");
	hawser_net_modes_clear(&modes);
}

static uint64_t state = 2385;

/* A node (across, up, along) of a vertical plane at that azimuth, whose normal is `across`. */
static int at_plane(struct scene *s, double azimuth, double across, double up, double along, int held)
{
	return node(s, 7.0 + across*cos(azimuth) - along*sin(azimuth), up,
	            3.0 - across*sin(azimuth) - along*cos(azimuth), held);
}

/* A random net and its image, tied together; `flat` 1: a random net within the plane instead. */
static void random_scene(struct scene *s, double azimuth, int flat)
{
	enum { SUPPORTS = 3, HALF = 7 };
	int at[2][HALF];

	begin(s);
	for (int i = 0; i < HALF; i++) {
		double across = flat ? 0.0 : 2.0 + 8.0*uniform(&state), up = 10.0*uniform(&state);
		double along = 20.0*uniform(&state) - 10.0;

		for (int side = 0; side < 2 - flat; side++)
			at[side][i] = at_plane(s, azimuth, side ? -across : across, up, along, i < SUPPORTS);
	}
	for (int i = SUPPORTS; i < HALF; i++) {
		/* all supports take part: under one alone a net hangs in a line */
		int a = i % SUPPORTS, b = (int)(i*uniform(&state));

		for (int side = 0; side < 2 - flat; side++) {
			cable(s, at[side][i], at[side][a], -0.03, 4);
			if (b != a)
				cable(s, side ? at[side][b] : at[side][i], side ? at[side][i] : at[side][b], -0.05, 3);
		}
		if (!flat)
			cable(s, at[0][i], at[1][i], -0.04, 3 + i % 2);
	}
}

/* 1 if all labels are as they should be: the plane of a flat net, or one mirror plane. */
static int planes(const struct hawser_net_modes *modes, double azimuth, int flat)
{
	const struct hawser_net_symmetry *found = &modes->symmetry;
	const double *normal = flat ? found->plane.normal : found->mirror[0].normal;
	int good = found->flat == flat && found->mirrors == !flat && found->turns == 1 &&
	           fabs(fabs(normal[0]*cos(azimuth) - normal[2]*sin(azimuth)) - 1.0) < 1e-9;

	for (int j = 0; j < modes->n; j++)
		good &= fabs(fabs(modes->parity[j][!flat]) - 1.0) < 1e-6;
	return good;
}

static void random_planes(int count)
{
	int good = 0, none = 0, solved = 0;

	for (int i = 0; i < count; i++) {
		double azimuth = 2.0*M_PI*uniform(&state);
		struct hawser_net_modes modes;
		struct scene s;

		random_scene(&s, azimuth, i % 2);
		if (!hawser_net_modes_solve(&modes, &s.net, 8, &report)) {
			solved++;
			good += planes(&modes, azimuth, i % 2);
			hawser_net_modes_clear(&modes);
		}
		s.net.loads = 1;
		s.load[0] = (struct hawser_net_load){.node = s.net.nodes - 1, .cable = -1,
		                                     .value = {30.0*cos(azimuth), 0.0, -30.0*sin(azimuth)}};
		if (!hawser_net_modes_solve(&modes, &s.net, 8, &report)) {
			none += modes.symmetry.mirrors == 0 && !modes.symmetry.flat;
			hawser_net_modes_clear(&modes);
		}
	}
	ok(good == count && solved == count, "random nets, plane or mirrored in a random vertical plane: "
	   "found in %d of %d", good, count);
	ok(none == count, "with a force across it: none in %d", none);
}

/* A joint that may slide horizontally only; and one that may slide along x, which breaks the symmetry
 * of a net that is turned. */
static void held(void)
{
	struct hawser_net_modes modes;
	struct scene s;

	span(&s, 0.61, 0.0);
	memcpy(s.node[1].held, (unsigned char[3]){0, 1, 0}, 3);
	memcpy(s.node[2].held, (unsigned char[3]){0, 1, 0}, 3);
	if (ok(!hawser_net_modes_solve(&modes, &s.net, 6, &report), "held along y %s", report.message)) {
		int good = 1;

		for (int j = 0; j < 6; j++)
			good &= modes.shape[j*4 + 1][1] == 0.0 && modes.shape[j*4 + 2][1] == 0.0 &&
			        hawser_net_plane_side(modes.parity[j][0]) != NULL;
		ok(good && modes.symmetry.mirrors == 1, "stays there, and the modes have planes");
		hawser_net_modes_clear(&modes);
	}
	memcpy(s.node[1].held, (unsigned char[3]){1, 0, 0}, 3);
	memcpy(s.node[2].held, (unsigned char[3]){1, 0, 0}, 3);
	if (ok(!hawser_net_modes_solve(&modes, &s.net, 6, &report), "held along x %s", report.message)) {
		ok(!modes.symmetry.flat && modes.symmetry.mirrors == 0, "a net turned against it has none");
		hawser_net_modes_clear(&modes);
	}
}

CASE(property_net_symmetry)
{
	turned("a web of 5 spokes", web, 5, 1, 5);
	turned("a web of 6 spokes", web, 6, 2, 6);
	turned("a net over a rectangle", make_grid, 0, 2, 2);
	turned("a level span", make_span, 0, 1, 1);
	turned("an inclined span", make_span, 3, 0, 1);
	for (int n = 3; n <= 8; n++)
		pairs(n);
	broken();
	chiral();
	held();
	random_planes(getenv("HAWSER_LONG") ? 2000 : 12);
	return done_testing();
}
