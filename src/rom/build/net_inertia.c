/* rom/build/net_inertia.c - second-order shapes of a net's model (expanded_inertia.c). The load is on
 * what remains static, so that a shape has the force - 1/2 T_jkpsi u_j u_k alone.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <math.h>

#include "rom/build/net.h"

/* --- amplitudes --- */

/* Largest mean square of the slopes of mode j on a cable. */
static double turning(const struct hawser__net_source *source, int j)
{
	const struct hawser__mesh *mesh = &source->modal.mesh;
	double (*slope)[3] = source->t.slope + (size_t)j*(size_t)mesh->elements, most = 0.0;

	for (int c = 0; c < mesh->cables; c++) {
		double sum = 0.0;

		for (int e = mesh->first[c]; e < mesh->first[c + 1]; e++)
			sum += slope[e][1]*slope[e][1] + slope[e][2]*slope[e][2];
		most = fmax(most, sum/(mesh->first[c + 1] - mesh->first[c]));
	}
	return most;
}

static double amplitude(const void *of, int j)
{
	const struct hawser__net_source *source = of;
	const struct hawser__nexpand *t = &source->t;
	int unknowns = source->modal.mesh.unknowns;
	const double *mode = source->mode + (size_t)j*(size_t)unknowns;
	double omega = sqrt(t->omega2[j]), force = 0.0, damping;

	for (int i = 0; i < source->waves; i++) {
		const struct hawser__net_wave *wave = &source->wave[i];
		double own = cblas_ddot(unknowns, mode, 1, wave->row, 1)*pow(omega/source->time, wave->power);

		force = fmax(force, fabs(own)/t->energy);
	}
	damping = hawser__net_damping(source, (const double (*)[3])t->shape +
	                              (size_t)j*(size_t)source->modal.mesh.nodes, mode)/
	          hawser__net_unit(source)*source->time + 2.0*source->net->ratio*omega;
	return force > 0.0 ? hawser__inertia_expected(t->omega2[j], 0.5*t->third[(j*t->n + j)*t->n + j],
	                                              hawser__nexpand_own(t, j), force/damping,
	                                              turning(source, j)) : 0.0;
}

static double mass(const void *of, const double *x, const double *y)
{
	double product;

	hawser__net_masses(of, &product, x, 1, y);
	return product;
}

static double stiffness(const void *of, const double *x, const double *y)
{
	const struct hawser__net_source *source = of;

	hawser__eigen_stiffness(source->scratch, x, &source->modal.eigen);
	return cblas_ddot(source->modal.mesh.unknowns, source->scratch, 1, y, 1)/source->t.energy;
}

/* In stiffness, so that `pairing` of what is left is right (net/expand/expand.h). */
static double part(const void *of, int j, int k, const double *row, double kappa2)
{
	const struct hawser__net_source *source = of;

	return stiffness(source, source->t.second + (size_t)hawser__pair(j, k)*
	                 (size_t)source->modal.mesh.unknowns, row)/kappa2;
}

static struct hawser__inertia_by made_by(const struct hawser__net_source *source)
{
	return (struct hawser__inertia_by){.of = source, .n = source->n,
		.width = (size_t)source->modal.mesh.unknowns, .second = source->t.second,
		.amplitude = amplitude, .mass = mass, .stiffness = stiffness, .part = part};
}

enum hawser_status hawser__net_inertia_find(struct hawser__net_source *source,
                                            struct hawser_report *report)
{
	const struct hawser__inertia_by by = made_by(source);

	return hawser__inertia_find(&source->inertia, &source->hold, &by, report);
}

enum hawser_status hawser__net_inertia_make(struct hawser__net_source *source,
                                            struct hawser_report *report)
{
	const struct hawser__inertia_by by = made_by(source);

	return hawser__inertia_make(&source->inertia, &source->hold, &by, report);
}
