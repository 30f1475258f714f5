/* Harmonic balance of a mesh: its derivative along a random direction against central differences, and
 * the solution with its factors, for a net with a tie that damps, masses, all kinds of damping, a
 * support that is held along one axis, and a support that moves.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "net/balance/balance.h"
#include "tests/tap.h"

static struct hawser_report report;

enum { ORDER = 3 };

static double random_number(void)
{
	static unsigned state = 2385;

	state = state*1664525U + 1013904223U;
	return (double)(state >> 8)/(1 << 24) - 0.5;
}

static struct hawser_net_node node[] = {
	{.name = "A", .held = {1, 1, 1}, .support = 1}, {.name = "J", .x = {30, -2, 0}, .mass = 23.85},
	{.name = "B", .x = {60, 0, 0}, .held = {1, 1, 1}, .support = 1},
	{.name = "K", .x = {30, -6, 1}, .held = {0, 0, 1}, .support = 1},
	{.name = "P", .x = {30, -30, 0}, .held = {1, 1, 1}, .support = 1}};
static struct hawser_net_cable cable[] = {
	{.name = "a", .from = 0, .to = 1, .EA = 2e7, .rho = 3.0, .value = 29.9, .elements = 4},
	{.name = "b", .from = 1, .to = 2, .EA = 2e7, .rho = 3.0, .value = 29.8, .elements = 3},
	{.name = "t", .from = 1, .to = 3, .EA = 3e6, .rho = 0.5, .value = 3.9, .elements = 1,
	 .axial = 2.385e-3},
	{.name = "p", .from = 3, .to = 4, .EA = 3e6, .rho = 1.0, .value = 23.8, .elements = 2}};
static struct hawser_net_load load[] = {
	{.node = 1, .cable = -1, .value = {10.0, 20.0, 30.0}, .harmonic = 1, .multiple = 1, .phase = 0.3}};
static struct hawser_net_load motion[] = {
	{.node = 2, .cable = -1, .value = {0.0, 0.01, 0.0}, .harmonic = 1, .multiple = 2}};
static char name[] = "tied";
static const struct hawser_net net = {.name = name, .g = 9.81, .node = node, .cable = cable,
	.load = load, .motion = motion, .nodes = 5, .cables = 4, .loads = 1, .motions = 1, .alpha = 0.2,
	.mass_rate = 0.05};

static int open_mesh(struct hawser__mesh *mesh, double **T)
{
	struct hawser__mesh_options choice = {.method = NULL};
	struct hawser__equilibrium found;

	if (!ok(!hawser__mesh_build(mesh, &net, &report), "mesh %s", report.message))
		return 0;
	*T = calloc((size_t)mesh->elements, sizeof **T);
	return ok(!hawser__mesh_form(mesh, *T, &found, &net, &choice, &report), "equilibrium %s",
	          report.message);
}

static double norm(const double *x, size_t n)
{
	double sum = 0.0;

	for (size_t i = 0; i < n; i++)
		sum += x[i]*x[i];
	return sqrt(sum);
}

/* The product against differences, then F^-1 of it. */
static void derivative(struct hawser__mesh_balance *b)
{
	size_t n = b->size - 1;
	double *y = calloc(6*b->size, sizeof *y), *v = y + b->size, *left = v + b->size,
	       *right = left + b->size, *product = right + b->size, *there = product + b->size;
	double h = 1e-4, off = 0.0;

	for (int i = 0; i < 3*b->mesh->nodes; i++)
		for (int c = 0; b->mesh->unknown[i/3][i%3] >= 0 && c < b->width; c++) {
			y[(3*b->blocks.row[i/3] + i%3)*b->width + c] = 0.1*random_number();
			v[(3*b->blocks.row[i/3] + i%3)*b->width + c] = random_number();
		}
	y[n] = 2.385;
	v[n] = 0.7;
	for (int side = -1; side <= 1; side += 2) {
		for (size_t i = 0; i <= n; i++)
			there[i] = y[i] + side*h*v[i];
		hawser__mesh_balance_residual(b, side < 0 ? left : right, there);
	}
	hawser__mesh_balance_residual(b, there, y);
	hawser__mesh_balance_product(b, product, v);
	for (size_t i = 0; i < n; i++)
		off = fmax(off, fabs((right[i] - left[i])/(2.0*h) - product[i]));
	ok(off < 1e-5*norm(product, n), "derivative along a direction: off by %g of %g", off,
	   norm(product, n));
	v[n] = 0.0;
	hawser__mesh_balance_residual(b, there, y);
	hawser__mesh_balance_product(b, product, v);
	ok(hawser__mesh_balance_factor(b, y), "factors");
	hawser__nodal_solve(&b->blocks, product);
	for (size_t i = 0; i < n; i++)
		product[i] -= v[i];
	ok(norm(product, n) < 1e-9*norm(v, n), "solution: off by %g", norm(product, n)/norm(v, n));
	free(y);
}

CASE(property_net_balance)
{
	struct hawser__mesh_balance balance = {.order = 0};
	struct hawser__mesh mesh;
	double *T = NULL;

	if (open_mesh(&mesh, &T)) {
		if (ok(!hawser__mesh_balance_open(&balance, &mesh, net.mass_rate, ORDER, &report), "opened"))
			derivative(&balance);
		hawser__mesh_balance_clear(&balance);
	}
	hawser__mesh_clear(&mesh);
	free(T);
	return done_testing();
}
