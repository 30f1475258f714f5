/* rom/terms/absorbers.c - absorbers of attachments in a reduced model.
 *
 *   s_ij   stroke of the absorber at attachment i in mode j; s_i = sum of s_ij u_j
 *   w_ij   displacement of its mass, X_j + s_ij a
 *   k, c, k3, m   its spring, damper, cubic spring and mass (scaled)
 *
 * The stroke is a further displacement of the modes, whose masses and stiffness have it (modes.h): the
 * equations of the linear spring are K = diag(omega^2). What is left are forces on the strokes,
 *
 *   D_jk += c s_ij s_ik,      V += k3 s_i^4/4
 *
 * The cubic spring is counted from the position at rest. The damping of the scene does not act on
 * absorbers, neither on their masses nor on their springs:
 *
 *   mass M + stiffness K   takes  mass m w_ij.w_ik + stiffness k s_ij s_ik  from D
 *   ratios                 are those of the modes of the cable whose absorbers are held (s = 0), which
 *                          dampers of theirs would damp: D = sum of 2 zeta_h omega_h p_hj p_hk with
 *                          p_hj the product of mass of held mode h and X_j. What is not in the space of
 *                          the computed modes has the last ratio
 *
 * (as in modes --damped, damped.c.)
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "modes/label.h"
#include "rom/terms/absorbers.h"

/* Held modes beyond those of the model: the products fall off as 1/omega^2 of the mode. Chosen. */
enum { BEYOND = 16 };

double hawser__absorber_stiffness(const struct hawser_statics *st, int i)
{
	return i < st->attachments && st->attached[i].absorber > 0.0
	       ? st->attached[i].absorber_stiffness*st->span.d/st->H : 0.0;
}

double hawser__absorber_cubic(const struct hawser_statics *st, int i)
{
	double d = st->span.d;

	return i < st->attachments && st->attached[i].absorber > 0.0
	       ? st->attached[i].absorber_cubic*d*d*d/st->H : 0.0;
}

int hawser__absorber_forced(const struct hawser_statics *st, int i)
{
	return st->attached[i].absorber > 0.0 &&
	       (st->attached[i].absorber_damping > 0.0 || st->attached[i].absorber_cubic > 0.0);
}

int hawser__has_cubic(const struct hawser_statics *st)
{
	int any = 0;

	for (int i = 0; i < st->attachments; i++)
		any |= hawser__absorber_cubic(st, i) > 0.0;
	return any;
}

/* to [n][n] += factor s_ij s_ik */
static void add_strokes(double *to, const struct hawser_modes *modes, int i, double factor)
{
	int n = modes->n;

	for (int j = 0; factor != 0.0 && j < n; j++)
		for (int k = 0; k < n; k++)
			to[j*n + k] += factor*hawser__stroke(modes, j, i)*hawser__stroke(modes, k, i);
}

void hawser__absorbers_stiffen(double *K, const struct hawser_modes *modes)
{
	for (int i = 0; i < modes->statics.attachments; i++)
		add_strokes(K, modes, i, hawser__absorber_stiffness(&modes->statics, i));
}

/* to [n][n] += factor w_ij.w_ik, or X_j.X_k */
static void add_moved(double *to, const struct hawser_modes *modes, int i, double factor, int held)
{
	int n = modes->n;

	for (int j = 0; factor != 0.0 && j < n; j++) {
		double u[3], v[3];

		hawser__modes_attached(u, modes, j, i);
		if (!held)
			hawser__modes_absorber(u, modes, j, i, u);
		for (int k = 0; k < n; k++) {
			hawser__modes_attached(v, modes, k, i);
			if (!held)
				hawser__modes_absorber(v, modes, k, i, v);
			to[j*n + k] += factor*(u[0]*v[0] + u[1]*v[1] + u[2]*v[2]);
		}
	}
}

void hawser__absorbers_damp(double *D, const struct hawser_modes *modes, double mass,
                            double stiffness)
{
	const struct hawser_statics *st = &modes->statics;

	for (int i = 0; i < st->attachments; i++) {
		add_strokes(D, modes, i, st->attached[i].absorber_damping/sqrt(st->span.rho*st->H) -
		                         stiffness*hawser__absorber_stiffness(st, i));
		add_moved(D, modes, i, -mass*hawser__point_absorber(st, i), 0);
	}
}

/* --- damping ratios --- */

/* p_j of held mode h, with the displacements of modes: the masses of absorbers are held. */
static void products(double *p, const struct hawser_modes *held, int h,
                     const struct hawser_modes *modes)
{
	const struct hawser_grid *grid = &modes->grid;
	const struct hawser_statics *st = &modes->statics;

	memset(p, 0, (size_t)modes->n*sizeof *p);
	for (int i = 0; i < grid->points; i++) {
		double x[3];

		hawser_modes_at(held, x, NULL, h, grid->s[i]);
		for (int j = 0; j < modes->n; j++) {
			const double *y = modes->shape + 3*((size_t)j*(size_t)grid->points + (size_t)i);

			p[j] += grid->weight[i]*(x[0]*y[0] + x[1]*y[1] + x[2]*y[2]);
		}
	}
	for (int i = 0; i < hawser__points(st); i++) {
		double u[3], v[3];

		hawser__modes_attached(u, held, h, i);
		for (int j = 0; j < modes->n; j++) {
			hawser__modes_attached(v, modes, j, i);
			p[j] += hawser__point(st, i).m*(u[0]*v[0] + u[1]*v[1] + u[2]*v[2]);
		}
	}
}

enum hawser_status hawser__absorbers_ratio(double *D, const struct hawser_modes *modes,
                                           const struct hawser_scene *scene,
                                           struct hawser_report *report)
{
	size_t n = (size_t)modes->n;
	const struct hawser_modes_options options = {.n = modes->n + BEYOND};
	const struct hawser_mode last = {.number = 0};
	struct hawser_statics st = modes->statics;
	double *p = malloc(n*sizeof *p), *rest = calloc(n*n, sizeof *rest);
	struct hawser_modes held = {.n = 0};
	enum hawser_status status;

	for (int i = 0; i < st.attachments; i++)
		st.attached[i].absorber = 0.0;
	if (!p || !rest)
		status = hawser__no_memory(report, "rom");
	else if (strcmp(modes->method, "basis") == 0) /* the same space, so that nothing is left */
		status = hawser_modes_basis(&held, &st, modes->basis, modes->basis, report);
	else
		status = hawser_modes_solve(&held, &st, &options, report);
	for (size_t j = 0; !status && j < n; j++)
		rest[j*n + j] = 1.0;
	for (int i = 0; !status && i < st.attachments; i++) {
		double own = hawser__point_absorber(&modes->statics, i);

		add_moved(rest, modes, i, -own, 0);
		add_moved(rest, modes, i, own, 1);
	}
	for (int h = 0; !status && h < held.n; h++) {
		double d = 2.0*hawser__damping_ratio(scene, &held.mode[h])*held.mode[h].omega;

		products(p, &held, h, modes);
		for (size_t j = 0; j < n; j++)
			for (size_t k = 0; k < n; k++) {
				D[j*n + k] += d*p[j]*p[k];
				rest[j*n + k] -= p[j]*p[k];
			}
	}
	for (size_t j = 0; !status && j < n; j++)
		for (size_t k = 0; k < n; k++)
			D[j*n + k] += 2.0*hawser__damping_ratio(scene, &last)*rest[j*n + k]*
			              sqrt(modes->mode[j].omega*modes->mode[k].omega);
	hawser_modes_clear(&held);
	free(p);
	free(rest);
	return status;
}

/* --- cubic springs --- */

double hawser__absorbers_fourth(const struct hawser_modes *modes, const int index[4])
{
	double sum = 0.0;

	for (int i = 0; modes->stroke && i < modes->statics.attachments; i++) {
		double product = 6.0*hawser__absorber_cubic(&modes->statics, i);

		for (int a = 0; a < 4 && product != 0.0; a++)
			product *= hawser__stroke(modes, index[a], i);
		sum += product;
	}
	return sum;
}

void hawser__cubics_add(double *restoring, double *tangent, const double *u, int n,
                        const double *cubic, const double *stroke, int absorbers)
{
	for (int i = 0; i < absorbers; i++, stroke += n) {
		double s = 0.0;

		for (int j = 0; j < n; j++)
			s += stroke[j]*u[j];
		for (int j = 0; j < n; j++) {
			restoring[j] += cubic[i]*s*s*s*stroke[j];
			for (int k = 0; tangent && k < n; k++)
				tangent[j*n + k] += 3.0*cubic[i]*s*s*stroke[j]*stroke[k];
		}
	}
}

double hawser__cubics_energy(const double *u, int n, const double *cubic, const double *stroke,
                             int absorbers)
{
	double sum = 0.0;

	for (int i = 0; i < absorbers; i++, stroke += n) {
		double s = 0.0;

		for (int j = 0; j < n; j++)
			s += stroke[j]*u[j];
		sum += 0.25*cubic[i]*s*s*s*s;
	}
	return sum;
}
