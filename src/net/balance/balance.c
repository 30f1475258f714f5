/* net/balance/balance.c - periodic motions of a mesh by harmonic balance of all its nodes.
 *
 *   x(tau) = x_0 + sum of x_2k-1 cos k tau + x_2k sin k tau,  tau = Omega t,  k to `order`
 *
 *   R = F(x, x') + Omega^2 M x'' + Omega D x' - loads, projected on the same functions
 *
 * With a damping ratio zeta, D is 2 zeta omega_j of the modes that are given, and 2 zeta k Omega M of
 * what else moves with k Omega, that of a mode there.
 *
 * with the forces F of the elements, whose law is exact and two-sided, at equidistant samples; four
 * times as many as harmonics, so that the third harmonics of what is kept fall on none of it. The
 * derivative is that of these sums, so that Newton's method converges as it should with any number of
 * samples.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <math.h>
#include <string.h>

#include "core/report.h"
#include "net/balance/balance.h"

void hawser__mesh_balance_clear(struct hawser__mesh_balance *balance)
{
	hawser__nodal_clear(&balance->blocks);
	hawser__hold_clear(&balance->hold);
	*balance = (struct hawser__mesh_balance){.order = 0};
}

/* --- to open --- */

static void set_functions(struct hawser__mesh_balance *balance)
{
	int width = balance->width, rows = balance->rows;

	for (int c = 0; c < width; c++)
		for (int t = 0; t < rows; t++) {
			int k = (c + 1)/2, sine = c > 0 && c%2 == 0;
			double angle = 2.0*M_PI*(double)(k*t%rows)/rows, own = sine ? sin(angle) : cos(angle);

			balance->basis[c*rows + t] = own;
			balance->rate[c*rows + t] = sine ? k*cos(angle) : -k*sin(angle);
			balance->project[t*width + c] = (c ? 2.0 : 1.0)/rows*own;
		}
}

/* value*cos(k tau + phase) of each wave. */
static void add_waves(double *to, const struct hawser__mesh_balance *balance,
                      const struct hawser__mesh_wave *wave, int waves)
{
	for (int i = 0; i < 3*waves; i++) {
		const struct hawser__mesh_wave *own = &wave[i/3];
		double *row = to + (3*own->node + i%3)*balance->width;

		if (own->multiple > balance->order || own->value[i%3] == 0.0)
			continue;
		row[2*own->multiple - 1] += own->value[i%3]*cos(own->phase);
		row[2*own->multiple] -= own->value[i%3]*sin(own->phase);
	}
}

static void set_loads(struct hawser__mesh_balance *balance)
{
	const struct hawser__mesh *mesh = balance->mesh;

	for (int i = 0; i < 3*mesh->nodes; i++)
		balance->load[i*balance->width] = mesh->force[i/3][i%3];
	add_waves(balance->load, balance, mesh->wave, mesh->waves);
	add_waves(balance->motion, balance, mesh->motion, mesh->motions);
}

static enum hawser_status make_room(struct hawser__mesh_balance *balance, struct hawser_report *report)
{
	struct hawser__hold *hold = &balance->hold;
	size_t nodes = 3*(size_t)balance->mesh->nodes, elements = 3*(size_t)balance->mesh->elements;
	size_t width = (size_t)balance->width, rows = (size_t)balance->rows, one = sizeof(double);

	balance->basis = hawser__hold(hold, width*rows, one);
	balance->rate = hawser__hold(hold, width*rows, one);
	balance->project = hawser__hold(hold, width*rows, one);
	balance->load = hawser__hold(hold, nodes*width, one);
	balance->motion = hawser__hold(hold, nodes*width, one);
	balance->x = hawser__hold(hold, nodes*width, one);
	balance->other = hawser__hold(hold, nodes*width, one);
	balance->out = hawser__hold(hold, nodes*width, one);
	balance->place = hawser__hold(hold, nodes*rows, one);
	balance->speed = hawser__hold(hold, nodes*rows, one);
	balance->moved = hawser__hold(hold, nodes*rows, one);
	balance->faster = hawser__hold(hold, nodes*rows, one);
	balance->force = hawser__hold(hold, elements*rows, one);
	balance->series = hawser__hold(hold, elements*width, one);
	balance->weighted = hawser__hold(hold, HAWSER__MESH_PARTS*width*rows, one);
	balance->G = hawser__hold(hold, HAWSER__MESH_PARTS*width*width, one);
	balance->sweep = hawser__hold(hold, balance->size, one);
	balance->spare = hawser__hold(hold, balance->size, one);
	balance->work = hawser__hold(hold, balance->size, one);
	return hold->short_of_memory ? hawser__no_memory(report, "net")
	       : hawser__nodal_room(&balance->blocks, 3*balance->width, report);
}

enum hawser_status hawser__mesh_balance_open(struct hawser__mesh_balance *balance,
                                             const struct hawser__mesh *mesh, double mass_rate,
                                             int order, struct hawser_report *report)
{
	enum hawser_status status;

	*balance = (struct hawser__mesh_balance){.mesh = mesh, .mass_rate = mass_rate, .order = order,
		.width = 2*order + 1, .rows = 4*order + 4};
	status = hawser__nodal_open(&balance->blocks, mesh, report);
	balance->size = (size_t)balance->blocks.rows*3*(size_t)balance->width + 1;
	if (!status)
		status = make_room(balance, report);
	if (status)
		return status;
	set_functions(balance);
	set_loads(balance);
	return HAWSER_OK;
}

/* --- motions of all nodes --- */

/* Of the rows; held directions stay as they are. */
static void spread(double *x, const struct hawser__mesh_balance *balance, const double *y)
{
	size_t width = (size_t)balance->width;

	for (int i = 0; i < 3*balance->mesh->nodes; i++)
		if (balance->mesh->unknown[i/3][i%3] >= 0)
			memcpy(x + (size_t)i*width,
			       y + (3*(size_t)balance->blocks.row[i/3] + (size_t)(i%3))*width, width*sizeof *x);
}

static void gather(double *y, const struct hawser__mesh_balance *balance, const double *x)
{
	size_t width = (size_t)balance->width;

	memset(y, 0, (balance->size - 1)*sizeof *y);
	for (int i = 0; i < 3*balance->mesh->nodes; i++)
		if (balance->mesh->unknown[i/3][i%3] >= 0)
			memcpy(y + (3*(size_t)balance->blocks.row[i/3] + (size_t)(i%3))*width,
			       x + (size_t)i*width, width*sizeof *x);
}

static void sample(double *to, const struct hawser__mesh_balance *balance, const double *x,
                   const double *functions)
{
	cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, 3*balance->mesh->nodes, balance->rows,
	            balance->width, 1.0, x, balance->width, functions, balance->rows, 0.0, to,
	            balance->rows);
}

/* Difference of the ends of an element, of samples of nodes. */
static void difference(double d[3], const struct hawser__mesh_balance *balance, const double *of, int e,
                       int row)
{
	const int *end = balance->mesh->end[e];

	for (int k = 0; k < 3; k++)
		d[k] = of[(3*end[1] + k)*balance->rows + row] - of[(3*end[0] + k)*balance->rows + row];
}

/* --- the elements --- */

void hawser__mesh_balance_stretch(struct hawser__mesh_stretch *s,
                                  const struct hawser__mesh_balance *balance, int e, int row,
                                  double Omega)
{
	const struct hawser__mesh *mesh = balance->mesh;
	double d[3], v[3], e0[3], l0 = hawser__mesh_direction(e0, mesh, e), longer = 0.0, along = 0.0;

	difference(d, balance, balance->place, e, row);
	difference(v, balance, balance->speed, e, row);
	s->l = 0.0;
	for (int k = 0; k < 3; k++) { /* l - l0 from the displacements: l^2 - l0^2 = d.(2 l0 e0 + d) */
		longer += d[k]*(2.0*l0*e0[k] + d[k]);
		s->e[k] = l0*e0[k] + d[k];
		s->l += s->e[k]*s->e[k];
	}
	s->l = sqrt(s->l);
	for (int k = 0; k < 3; k++) {
		s->e[k] /= s->l;
		along += s->e[k]*Omega*v[k];
	}
	for (int k = 0; k < 3; k++)
		s->aside[k] = (Omega*v[k] - along*s->e[k])/s->l;
	s->stiff = mesh->EA[e]/mesh->length0[e];
	s->viscous = s->stiff*mesh->axial[e];
	s->T = s->stiff*(l0 - mesh->length0[e] + longer/(s->l + l0)) + s->viscous*along;
}

/* Coefficients of the forces of the elements, from samples, into `out`. */
static void put_forces(struct hawser__mesh_balance *balance)
{
	const struct hawser__mesh *mesh = balance->mesh;
	int width = balance->width;

	cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, 3*mesh->elements, width, balance->rows, 1.0,
	            balance->force, balance->rows, balance->project, width, 0.0, balance->series, width);
	memset(balance->out, 0, 3*(size_t)mesh->nodes*(size_t)width*sizeof *balance->out);
	for (int i = 0; i < 6*mesh->elements; i++) {
		int e = i/6, end = i%6/3, k = i%3;

		cblas_daxpy(width, end ? 1.0 : -1.0, balance->series + (3*e + k)*width, 1,
		            balance->out + (3*mesh->end[e][end] + k)*width, 1);
	}
}

/* --- inertia and damping --- */

/* to += -mass*k^2*x, and the rate of x times damping + k*turned. */
static void add_linear(double *to, const double *x, int width, double mass, double damping,
                       double turned)
{
	for (int c = 1; c < width; c++) {
		int k = (c + 1)/2, sine = c%2 == 0;

		to[c] += -mass*k*k*x[c] + (damping + k*turned)*k*(sine ? -x[c - 1] : x[c + 1]);
	}
}

/* What the damping of modes with ratios is more than that of all motions. */
static void add_modal(struct hawser__mesh_balance *balance, const double *x, double inertia,
                      double damping)
{
	int width = balance->width, modes = balance->modes, all = 3*balance->mesh->nodes;
	size_t size = (size_t)modes*(size_t)width;
	double *part = balance->modal, *force = part + size;

	if (modes == 0)
		return;
	cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, modes, width, all, 1.0, balance->mode, all,
	            x, width, 0.0, part, width);
	memset(force, 0, size*sizeof *force);
	for (int j = 0; j < modes; j++)
		add_linear(force + j*width, part + j*width, width, 0.0, damping*balance->rated[j],
		           -2.0*balance->ratio*inertia);
	cblas_dgemm(CblasRowMajor, CblasTrans, CblasNoTrans, all, width, modes, 1.0, balance->mode, all,
	            force, width, 1.0, balance->out, width);
}

/* out += inertia*M x'' + damping*D x'. */
static void add_motion(struct hawser__mesh_balance *balance, const double *x, double inertia,
                       double damping)
{
	const struct hawser__mesh *mesh = balance->mesh;
	int width = balance->width;
	double ratio = 2.0*balance->ratio*inertia;
	struct hawser__mesh_pair pair;

	for (int i = 0; i < 3*mesh->nodes; i++)
		add_linear(balance->out + i*width, x + i*width, width, inertia*mesh->mass[i/3],
		           damping*(balance->mass_rate*mesh->mass[i/3] + mesh->damper[i/3][i%3]),
		           ratio*mesh->mass[i/3]);
	for (int i = 0; i < 12*mesh->elements; i++) {
		int e = i/12, to = mesh->end[e][i%2], from = mesh->end[e][i/2%2], k = i%12/4;
		double share = to == from ? 5.0/12.0 : 1.0/12.0, mass = mesh->rho[e]*mesh->length0[e];

		add_linear(balance->out + (3*to + k)*width, x + (3*from + k)*width, width, inertia*share*mass,
		           damping*share*(balance->mass_rate*mass + mesh->alpha*mesh->length0[e]),
		           ratio*share*mass);
	}
	for (int j = 0; hawser__absorbers_mass(&pair, mesh, j); j++)
		add_linear(balance->out + (3*pair.node + pair.axis)*width,
		           x + (3*pair.other + pair.other_axis)*width, width, inertia*pair.mass,
		           damping*balance->mass_rate*pair.mass,
		           2.0*balance->stroke_ratio*inertia*pair.mass);
	add_modal(balance, x, inertia, damping);
}

/* out += what the springs to the ground do. */
static void add_springs(struct hawser__mesh_balance *balance, const double *x)
{
	const struct hawser__mesh *mesh = balance->mesh;

	for (int i = 0; i < 3*mesh->nodes; i++)
		if (mesh->spring[i/3][i%3] > 0.0)
			cblas_daxpy(balance->width, mesh->spring[i/3][i%3], x + i*balance->width, 1,
			            balance->out + i*balance->width, 1);
}

/* --- residual and derivative --- */

void hawser__mesh_balance_residual(struct hawser__mesh_balance *balance, double *residual,
                                   const double *y)
{
	const struct hawser__mesh *mesh = balance->mesh;
	int rows = balance->rows;
	size_t all = 3*(size_t)mesh->nodes*(size_t)balance->width;
	double Omega = balance->Omega = y[balance->size - 1];

	memcpy(balance->x, balance->motion, all*sizeof *balance->x);
	spread(balance->x, balance, y);
	sample(balance->place, balance, balance->x, balance->basis);
	sample(balance->speed, balance, balance->x, balance->rate);
	for (int e = 0; e < mesh->elements; e++)
		for (int t = 0; t < rows; t++) {
			struct hawser__mesh_stretch s;

			hawser__mesh_balance_stretch(&s, balance, e, t, Omega);
			for (int k = 0; k < 3; k++)
				balance->force[(3*e + k)*rows + t] = s.T*s.e[k];
		}
	put_forces(balance);
	add_springs(balance, balance->x);
	add_motion(balance, balance->x, Omega*Omega, Omega);
	cblas_daxpy((int)all, -1.0, balance->load, 1, balance->out, 1);
	gather(residual, balance, balance->out);
}

/* Change of the force by the change d of the difference of the ends, and v of its rate. */
static void change(double force[3], const struct hawser__mesh_stretch *s, const double d[3],
                   const double v[3])
{
	double along = 0.0, turn = 0.0, faster = 0.0, own;

	for (int k = 0; k < 3; k++) {
		along += s->e[k]*d[k];
		turn += s->aside[k]*d[k];
		faster += s->e[k]*v[k];
	}
	own = (s->stiff - s->T/s->l)*along + s->viscous*(turn + faster);
	for (int k = 0; k < 3; k++)
		force[k] = s->T/s->l*d[k] + own*s->e[k];
}

void hawser__mesh_balance_product(struct hawser__mesh_balance *balance, double *product,
                                  const double *v)
{
	const struct hawser__mesh *mesh = balance->mesh;
	int rows = balance->rows;
	double Omega = balance->Omega, more = v[balance->size - 1];

	memset(balance->other, 0, 3*(size_t)mesh->nodes*(size_t)balance->width*sizeof(double));
	spread(balance->other, balance, v);
	sample(balance->moved, balance, balance->other, balance->basis);
	sample(balance->faster, balance, balance->other, balance->rate);
	for (int e = 0; e < mesh->elements; e++)
		for (int t = 0; t < rows; t++) {
			struct hawser__mesh_stretch s;
			double d[3], rate[3], speed[3], force[3];

			hawser__mesh_balance_stretch(&s, balance, e, t, Omega);
			difference(d, balance, balance->moved, e, t);
			difference(rate, balance, balance->faster, e, t);
			difference(speed, balance, balance->speed, e, t);
			for (int k = 0; k < 3; k++)
				rate[k] = Omega*rate[k] + more*speed[k];
			change(force, &s, d, rate);
			for (int k = 0; k < 3; k++)
				balance->force[(3*e + k)*rows + t] = force[k];
		}
	put_forces(balance);
	add_springs(balance, balance->other);
	add_motion(balance, balance->other, Omega*Omega, Omega);
	add_motion(balance, balance->x, 2.0*Omega*more, more);
	gather(product, balance, balance->out);
}

/* --- measures --- */

void hawser__mesh_balance_metric(struct hawser__mesh_balance *balance, const double *y)
{
	balance->scale = cblas_dnrm2((int)balance->size - 1, y, 1);
	balance->unit = y[balance->size - 1];
}

double hawser__mesh_balance_dot(const struct hawser__mesh_balance *balance, const double *a,
                                const double *b)
{
	size_t last = balance->size - 1;

	return cblas_ddot((int)last, a, 1, b, 1)/(balance->scale*balance->scale) +
	       a[last]*b[last]/(balance->unit*balance->unit);
}

const double *hawser__mesh_balance_at(const struct hawser__mesh_balance *balance, const double *y,
                                      int node, int k)
{
	int row = balance->blocks.row[node];

	return row < 0 || balance->mesh->unknown[node][k] < 0 ? NULL : y + (3*row + k)*balance->width;
}

double hawser__mesh_balance_tension(struct hawser__mesh_balance *balance, const double *y, int *element)
{
	double least = INFINITY;

	hawser__mesh_balance_residual(balance, balance->spare, y);
	for (int e = 0; e < balance->mesh->elements; e++)
		for (int t = 0; t < balance->rows; t++) {
			struct hawser__mesh_stretch s;

			hawser__mesh_balance_stretch(&s, balance, e, t, y[balance->size - 1]);
			if (s.T < least) {
				least = s.T;
				*element = e;
			}
		}
	return least;
}
