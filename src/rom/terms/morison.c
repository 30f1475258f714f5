/* rom/terms/morison.c - the force of the water on the coordinates of a net's model.
 *
 *   q         places of the mesh: at the equilibrium, and S u of coordinates and of moving supports
 *   F(q, q')  loads of the water on ends of elements and buoys, by the routine that motions of the mesh
 *             have (net/water/ends.c): the flow, the direction and what is wet are those at q
 *   a         (S'F - S'F at rest + S'K_b S u)/unit, K_b the buoyancy's spring, which K of the model has
 *
 * The added mass is in the mass of the modes, with the directions at the equilibrium; so the loads are
 * those on a line without acceleration. What follows the coordinates to second order does not move
 * points here.
 *
 * The wave is that of the frequency of the model, whatever it is: k and the flow follow it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <math.h>
#include <string.h>

#include "core/hot.h"
#include "core/vec3.h"
#include "rom/terms/morison.h"
#include "water/near.h"
#include "water/water.h"

enum { ELEMENTS = 8, ROWS = 6*ELEMENTS, MOST = HAWSER__MORISON_MOST };

/* Amplitudes of all columns, their rates and the derivatives of those by the model's frequency. */
struct columns {
	double u[MOST], v[MOST], v_omega[MOST];
};

/* The water at a point: derivatives by its place, and by the frequency of the wave. */
struct point {
	struct hawser__water_past past;
	double x[3], u_by[3][4], du_by[3][4], height_by[4], rate[3];
};

/* What a part of the points gives: forces along x, y, z and their derivatives, in rows of the width of
 * shapes. */
struct rows {
	int count, derive;
	double force[ROWS], by_omega[ROWS], by_u[ROWS*MOST], by_v[ROWS*MOST];
};

static void set_columns(struct columns *to, const struct hawser__rom_morison *of, const double *u,
                        const double *v, double tau, double omega, int still)
{
	memset(to, 0, sizeof *to);
	memcpy(to->u, u, (size_t)of->n*sizeof *u);
	for (int j = 0; j < of->n; j++)
		to->v[j] = v[j]/of->time;
	for (int i = 0; i < of->columns - of->n; i++) {
		double angle = of->k[i]*tau, *rate = &to->v_omega[of->n + i];

		to->u[of->n + i] = still ? 0.0 : of->sine[i] ? sin(angle) : cos(angle);
		*rate = still ? 0.0 : of->k[i]*(of->sine[i] ? cos(angle) : -sin(angle))/of->time;
		to->v[of->n + i] = omega**rate;
	}
}

/* x [3] += shape [3][width] times c. */
HAWSER_PART void add_columns(double x[3], const double *shape, const double *c, int width)
{
	for (int k = 0; k < 3; k++) {
		hawser__vec sum = {0.0};

		for (int j = 0; j < width; j += HAWSER_BLOCK)
			sum += *(const hawser__vec *)(shape + k*width + j)**(const hawser__vec *)(c + j);
		x[k] += sum[0] + sum[1] + sum[2] + sum[3];
	}
}

HAWSER_PART void add_wave(struct point *to, const struct hawser__rom_morison *of,
                     const struct hawser__regular *wave, double tau)
{
	struct hawser__regular_flow flow;
	int rises = of->water.waves.stretching != HAWSER_STRETCH_NONE;

	hawser__regular_at(&flow, wave, to->x, tau);
	to->past.height -= rises ? flow.elevation : 0.0;
	for (int k = 0; k < 3; k++) {
		to->past.u[k] += flow.u[k];
		to->past.du[k] = flow.du[k];
		for (int i = 0; i < 4; i++) {
			to->u_by[k][i] += flow.u_by[k][i];
			to->du_by[k][i] = flow.du_by[k][i];
		}
	}
	for (int i = 0; i < 4 && rises; i++)
		to->height_by[i] -= flow.elevation_by[i];
}

HAWSER_PART void look(struct point *to, const struct hawser__rom_morison *of, int p,
                      const struct columns *c, const struct hawser__regular *wave, double tau)
{
	const double *shape = of->shape + (size_t)p*3*(size_t)of->width;
	double u_y[3], v[3] = {0.0};

	memset(to, 0, sizeof *to);
	memcpy(to->x, of->place[p], sizeof to->x);
	add_columns(to->x, shape, c->u, of->width);
	add_columns(v, shape, c->v, of->width);
	if (of->columns > of->n)
		add_columns(to->rate, shape, c->v_omega, of->width);
	hawser__water_current(to->past.u, u_y, &of->water, to->x[1]);
	to->past.height = to->x[1] - of->water.surface;
	to->height_by[1] = 1.0;
	for (int k = 0; k < 3; k++)
		to->u_by[k][1] = u_y[k];
	if (wave)
		add_wave(to, of, wave, tau);
	for (int k = 0; k < 3; k++)
		to->past.r[k] = to->past.u[k] - v[k];
}

/* y [width] = sum of block [k] times row k of a shape */
HAWSER_PART void set_row(double *y, const double *block, int blocks, const double *shape, int width)
{
	for (int j = 0; j < width; j += HAWSER_BLOCK) {
		hawser__vec sum = {0.0};

		HAWSER_UNROLL
		for (int k = 0; k < blocks; k++)
			sum += block[k]**(const hawser__vec *)(shape + k*width + j);
		*(hawser__vec *)(y + j) = sum;
	}
}

/* The force on point `own` of `points` that begin with `first`, an element (two) or a buoy, and its
 * derivatives. inertia: of the load, by the acceleration of the water. */
HAWSER_PART void put(struct rows *to, const struct hawser__rom_morison *of,
                     const struct hawser__water_end *end, double inertia, const struct point *point,
                     int points, int own, int first)
{
	const struct point *at = &point[own];
	const size_t width = (size_t)of->width, size = 3*width;
	const double *shape = of->shape + (size_t)first*size;

	memcpy(to->force + to->count, end->load, sizeof end->load);
	for (int k = 0; k < 3 && to->derive; k++) {
		double by[4] = {0.0}, back[3], block[6];

		for (int l = 0; l < 3; l++) {
			double J = end->mass[k][l] + (k == l ? inertia : 0.0);

			for (int i = 0; i < 4; i++)
				by[i] += end->by_r[k][l]*at->u_by[l][i] + J*at->du_by[l][i];
			back[l] = -end->by_r[k][l]/of->time;
		}
		for (int j = 0; j < points; j++) {
			by[3] += end->by_y[j][k]*point[j].height_by[3];
			for (int i = 0; i < 3; i++)
				block[3*j + i] = end->by_y[j][k]*point[j].height_by[i] + (j == own ? by[i] : 0.0) +
				                 (points > 1 ? (j ? 1.0 : -1.0)*end->by_d[k][i] : 0.0);
		}
		to->by_omega[to->count + k] = by[3]/of->time -
		                              hawser__dot(end->by_r[k], at->rate);
		set_row(to->by_u + (size_t)(to->count + k)*width, block, 3*points, shape, of->width);
		set_row(to->by_v + (size_t)(to->count + k)*width, back, 3, shape + (size_t)own*size, of->width);
	}
	to->count += 3;
}

/* point [1]: that of the element before, whose second end may be the first one here. */
HAWSER_PART void add_element(struct rows *to, struct point point[2],
                             const struct hawser__rom_morison *of, int e, const struct columns *c,
                             const struct hawser__regular *wave, double tau)
{
	const struct hawser_water_line *line = of->wet.line[e];
	const double m = of->water.density*M_PI*line->diameter*line->diameter/4.0;
	struct hawser__water_end end[2];
	struct hawser__water_past past[2];
	double d[3];

	if (e > 0 && of->node[2*e] == of->node[2*e - 1])
		point[0] = point[1];
	else
		look(&point[0], of, 2*e, c, wave, tau);
	look(&point[1], of, 2*e + 1, c, wave, tau);
	past[0] = point[0].past;
	past[1] = point[1].past;
	for (int k = 0; k < 3; k++)
		d[k] = point[1].x[k] - point[0].x[k];
	hawser__water_ends(end, &of->mesh, e, d, past, to->derive);
	put(to, of, &end[0], m*end[0].wet, point, 2, 0, 2*e);
	put(to, of, &end[1], m*end[1].wet, point, 2, 1, 2*e);
}

HAWSER_PART void add_buoy(struct rows *to, const struct hawser__rom_morison *of, int i,
                          const struct columns *c, const struct hawser__regular *wave, double tau)
{
	struct hawser__water_end end;
	struct point point;
	int p = 2*of->elements + i;

	look(&point, of, p, c, wave, tau);
	hawser__water_buoy(&end, &of->mesh, &of->buoy[i], &point.past);
	put(to, of, &end, of->water.density*end.wet, &point, 1, 0, p);
}

/* The rows of the points from `first` on, to the coordinates. */
static void gather(double *a, double *by_u, double *by_v, double *by_omega,
                   const struct hawser__rom_morison *of, const struct rows *rows, int first)
{
	const double *shape = of->shape + (size_t)first*3*(size_t)of->width, scale = 1.0/of->unit;
	int n = of->n;

	cblas_dgemv(CblasRowMajor, CblasTrans, rows->count, n, scale, shape, of->width, rows->force, 1,
	            1.0, a, 1);
	if (!rows->derive)
		return;
	cblas_dgemv(CblasRowMajor, CblasTrans, rows->count, n, scale, shape, of->width, rows->by_omega, 1,
	            1.0, by_omega, 1);
	cblas_dgemm(CblasRowMajor, CblasTrans, CblasNoTrans, n, n, rows->count, scale, shape, of->width,
	            rows->by_u, of->width, 1.0, by_u, n);
	cblas_dgemm(CblasRowMajor, CblasTrans, CblasNoTrans, n, n, rows->count, scale, shape, of->width,
	            rows->by_v, of->width, 1.0, by_v, n);
}

HAWSER_HOT
void hawser__rom_morison_at(const struct hawser__rom_morison *of, double *a, double *by_u, double *by_v,
                        double *by_omega, const double *u, const double *v, double tau, double omega,
                        int still)
{
	const int n = of->n, units = of->elements + of->buoys;
	const size_t square = (size_t)n*(size_t)n*sizeof *a;
	/* cppcheck-suppress uninitvar ; it is filled before it is read */
	struct hawser__regular own, *wave = still || !of->waves ? NULL : &own;
	struct columns c;
	struct rows rows; /* is large, and filled as far as it is read */
	struct point point[2];

	rows.count = 0;
	rows.derive = by_u != NULL;
	if (wave)
		own = hawser__regular_wave(&of->water.waves, omega/of->time,
		                           of->mesh.g > 0.0 ? of->mesh.g : 9.81);
	set_columns(&c, of, u, v, tau, omega, still);
	for (int j = 0; j < n; j++)
		a[j] = (cblas_ddot(of->columns, of->spring + j*of->columns, 1, c.u, 1) - of->still[j])/of->unit;
	if (by_u) {
		for (int i = 0; i < n*n; i++)
			by_u[i] = of->spring[i/n*of->columns + i%n]/of->unit;
		memset(by_v, 0, square);
		memset(by_omega, 0, (size_t)n*sizeof *by_omega);
	}
	for (int i = 0, first = 0; i < units; i++) {
		if (i < of->elements)
			add_element(&rows, point, of, i, &c, wave, tau);
		else
			add_buoy(&rows, of, i - of->elements, &c, wave, tau);
		if (rows.count + 6 <= ROWS && i + 1 < units)
			continue;
		gather(a, by_u, by_v, by_omega, of, &rows, first);
		first += rows.count/3;
		rows.count = 0;
	}
}

void hawser__rom_morison_free(struct hawser__rom_morison *of)
{
	if (!of)
		return;
	hawser__hold_clear(&of->hold);
	free(of);
}
