/* rom/support_exact.c - moving supports of a model with the exact energy: the strains of the
 * quasi-static displacement (support_shape.c) at the quadrature points are added to those of the
 * coordinates, so that the energy is exact in both.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "modes/grid.h"
#include "rom/exact.h"
#include "rom/kernel.h"
#include "rom/support.h"

enum hawser_status hawser__exact_support(struct hawser_rom_exact *exact,
                                         const struct hawser_modes *modes,
                                         const struct hawser_scene *scene,
                                         struct hawser_report *report)
{
	size_t points = (size_t)exact->points, each = 3*(size_t)modes->grid.points;
	struct hawser__support_shapes shapes;
	enum hawser_status status = hawser__support_shapes_make(&shapes, modes, report);

	exact->support = calloc(HAWSER__AXES*3*points + 1, sizeof *exact->support);
	exact->signal = calloc(HAWSER__AXES, sizeof *exact->signal);
	if (!status && (!exact->support || !exact->signal))
		status = hawser__no_memory(report, "rom");
	for (int axis = 0; !status && axis < HAWSER__AXES; axis++) {
		struct hawser__signal *signal = &exact->signal[exact->supports];
		double *strain = exact->support + 3*points*(size_t)exact->supports;
		int any = 0;

		hawser__support_signal(signal, scene, 2, axis, modes->statics.span.d);
		for (int k = 0; k <= HAWSER__SUPPORT_TOP; k++)
			any |= signal->c[k] != 0.0 || signal->s[k] != 0.0;
		for (size_t p = 0; any && p < points; p++)
			hawser__grid_at(strain + 3*p, &modes->grid, shapes.strain + (size_t)axis*each, 3,
			                3, exact->grid.s[p]);
		exact->supports += any;
	}
	hawser__support_shapes_clear(&shapes);
	return status;
}

void hawser__exact_supports(const struct hawser_rom_exact *exact, double *s, double tau)
{
	for (int i = 0; i < exact->supports; i++) {
		s[i] = 0.0;
		for (int k = 0; k <= HAWSER__SUPPORT_TOP; k++)
			s[i] += exact->signal[i].c[k]*cos(k*tau) + exact->signal[i].s[k]*sin(k*tau);
	}
}

void hawser__exact_vary(const struct hawser_rom_exact *exact, double *restoring, double *tangent,
                        const double *u, double tau)
{
	double s[HAWSER__AXES] = {0.0}, force[HAWSER_ROM_MAX], T[HAWSER_ROM_MAX*HAWSER_ROM_MAX];
	int n = exact->n;

	hawser__exact_supports(exact, s, tau);
	for (int moved = 0; moved < 2; moved++) {
		double sign = moved ? 1.0 : -1.0;

		hawser__exact_moved(exact, force, tangent ? T : NULL, u, moved ? s : NULL);
		for (int j = 0; j < n; j++)
			restoring[j] += sign*force[j];
		for (int i = 0; tangent && i < n*n; i++)
			tangent[i] += sign*T[i];
	}
}
