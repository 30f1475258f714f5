/* The loads of the water on rods: their derivatives against differences, at rest in axes that move, and
 * in motion. SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "rod/motion.h"
#include "tests/tap.h"

enum { FREE = HAWSER__ROD_FREE, ELEMENTS = 4, UNKNOWNS = FREE*(ELEMENTS + 1) };
#define STEP 1e-6

static unsigned long seed = 2385;

static double number(void) /* -1 to 1 */
{
	seed = (seed*1103515245UL + 12345UL) & 0x7fffffffUL;
	return 2.0*(double)seed/0x7fffffff - 1.0;
}

static struct hawser_water_level level[2] = {{-9.0, {0.4, 0.0, -0.7}}, {7.0, {1.3, 0.2, 0.9}}};
static struct hawser_rod_segment segment = {
	.length = 2.385, .rho = 1.3, .EA = 900.0, .GA = {700.0, 500.0}, .EI = {31.0, 17.0}, .GJ = 23.0,
	.inertia = {0.07, 0.05, 0.02}, .line = {0.4, 1.2, 0.1, 0.9, 0.3}, .elements = ELEMENTS};

/* Bent at random below, or through, the surface. */
static void open(struct hawser__rod_mesh *mesh, struct hawser_rod *rod, double surface)
{
	struct hawser_report report;
	double by[UNKNOWNS];

	*rod = (struct hawser_rod){
		.segment = &segment, .segments = 1, .length = segment.length, .g = 9.81,
		.hold = {HAWSER_ROD_CLAMPED, HAWSER_ROD_FREE}, .tangent = {0.3, 1.0, 0.2},
		.normal = {1.0, 0.0, 0.0}, .rho_inf = 0.8,
		.water = {.density = 102.5, .surface = surface, .current = level, .levels = 2}};
	if (!ok(hawser__rod_mesh_open(mesh, rod, 1, &report) == HAWSER_OK, "a mesh"))
		return;
	mesh->water.buoy.node = ELEMENTS;
	mesh->water.buoy.of = (struct hawser_water_buoy){0.0, 0.3, 0.5, 0.7};
	for (int i = 0; i < mesh->n; i++)
		by[i] = mesh->held[i] ? 0.0 : number();
	hawser__rod_move(mesh, by, 0.15);
}

/* The matrix times `by`. */
static void product(double to[UNKNOWNS], struct hawser__rod_mesh *mesh, const double *by)
{
	memset(to, 0, UNKNOWNS*sizeof *to);
	for (int i = 0; i < mesh->n; i++)
		for (int j = i > 11 ? i - 11 : 0; j <= i + 11 && j < mesh->n && !mesh->held[i]; j++)
			to[i] += *hawser__band_at(&mesh->band, i, j)*by[j];
}

static void compare(const double *matrix, const double *plus, const double *minus, double within,
                    const char *what)
{
	double worst = 0.0, size = 0.0;

	for (int i = 0; i < UNKNOWNS; i++) {
		worst = fmax(worst, fabs(matrix[i] + (plus[i] - minus[i])/(2.0*STEP)));
		size = fmax(size, fabs(matrix[i]));
	}
	ok(worst < within*size, "%s against differences: %.1e", what, worst/size);
}

static void rest(double surface, double within, const char *what)
{
	struct hawser__rod_mesh mesh;
	struct hawser_rod rod;
	double by[UNKNOWNS], matrix[UNKNOWNS], side[2][UNKNOWNS];

	open(&mesh, &rod, surface);
	mesh.water.spin = 0.7;
	mesh.water.lift = -0.8;
	memcpy(mesh.water.velocity, (const double[3]){0.5, -0.2, 0.3}, sizeof mesh.water.velocity);
	for (int i = 0; i < mesh.n; i++)
		by[i] = mesh.held[i] ? 0.0 : number();
	hawser__rod_loads(&mesh, NULL, 0.6);
	(void)hawser__rod_strains(&mesh);
	hawser__rod_tangent(&mesh);
	product(matrix, &mesh, by);
	for (int k = 0; k < 2; k++) {
		hawser__rod_move(&mesh, by, k ? -2.0*STEP : STEP);
		(void)hawser__rod_strains(&mesh);
		hawser__rod_residual(&mesh);
		memcpy(side[k], mesh.r, sizeof side[k]);
	}
	compare(matrix, side[0], side[1], within, what);
	hawser__rod_mesh_clear(&mesh);
}

/* In a uniform current: derivatives by what the flow changes with the place are left out. */
static void motion(double surface, double within, const char *what)
{
	struct hawser__rod_mesh mesh;
	struct hawser__rod_motion motion;
	struct hawser_rod rod;
	struct hawser_report report;
	double by[UNKNOWNS], matrix[UNKNOWNS], side[2][UNKNOWNS];

	open(&mesh, &rod, surface);
	rod.water.levels = 1;
	ok(hawser__rod_motion_open(&motion, &mesh, &report) == HAWSER_OK &&
	   hawser__water_flow_open(&mesh.water.flow, &rod.water, mesh.nodes, &report) == HAWSER_OK,
	   "it moves");
	motion.loading = hawser__rod_water_push;
	for (int i = 0; i < mesh.n; i++) {
		motion.velocity[i/FREE][i%FREE] = mesh.held[i] ? 0.0 : number();
		motion.rate[i/FREE][i%FREE] = mesh.held[i] ? 0.0 : 5.0*number();
		by[i] = mesh.held[i] || i%FREE > 2 ? 0.0 : number();
	}
	for (int i = 0; i < mesh.nodes; i++)
		for (int k = 0; k < 9; k++)
			motion.Ji[i][k] = k%4 == 0;
	motion.by_place = 1.0;
	motion.to_velocity = 3.0;
	motion.to_rate = 11.0;
	hawser__rod_motion_factors(&motion, 0.0, 0);
	(void)hawser__rod_motion_form(&motion, 0.0, 1);
	product(matrix, &mesh, by);
	for (int k = 0; k < 2; k++) {
		double part = k ? -2.0*STEP : STEP;

		hawser__rod_move(&mesh, by, part);
		for (int i = 0; i < mesh.n; i++) {
			motion.velocity[i/FREE][i%FREE] += part*motion.to_velocity*by[i];
			motion.rate[i/FREE][i%FREE] += part*motion.to_rate*by[i];
		}
		(void)hawser__rod_motion_form(&motion, 0.0, 0);
		memcpy(side[k], mesh.r, sizeof side[k]);
	}
	compare(matrix, side[0], side[1], within, what);
	hawser__rod_motion_clear(&motion);
	hawser__rod_mesh_clear(&mesh);
}

CASE(unit_rod_water)
{
	rest(20.0, 1e-8, "at rest, below the surface,");
	rest(-0.1, 1e-6, "at rest, through the surface,");
	motion(20.0, 1e-8, "in motion, below the surface,");
	motion(1.1, 1e-6, "in motion, through the surface,");
	return done_testing();
}
