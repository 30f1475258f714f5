/* rom/energy/support_exact.c - moving supports of a model with the exact energy: the strains of the
 * quasi-static displacement (support_shape.c) at the quadrature points are added to those of the
 * coordinates, so that the energy is exact in both. The springs of attachments pull at the coordinates
 * with that displacement, too, and those of elastic supports with that relative to their foundations.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "core/report.h"
#include "modes/grid.h"
#include "modes/label.h"
#include "rom/energy/exact.h"
#include "rom/energy/kernel.h"
#include "rom/condense/support.h"

/* Force [n] of the springs at the coordinates by shape `number`. */
static void pull(double *force, const struct hawser_modes *modes,
                 const struct hawser__support_shapes *shapes, int number)
{
	const struct hawser_statics *st = &modes->statics;
	double u[3];

	for (int i = 0; i < hawser__points(st); i++)
		for (int j = 0; j < modes->n; j++) {
			const double *at = shapes->at + 3*((size_t)number*(size_t)hawser__points(st) + (size_t)i);
			int end = i - st->attachments;
			const double *k = end < 0 ? st->attached[i].spring : st->held[end].stiffness;

			hawser__modes_attached(u, modes, j, i);
			for (int c = 0; c < 3; c++) {
				/* the translation of both ends moves attachments; end B moves its foundation */
				double foot = end < 0 ? -(number == HAWSER__AXES + c) : end == 1 && number == c;

				if (isfinite(k[c]))
					force[j] += k[c]*st->span.d/st->H*u[c]*(at[c] - foot);
			}
		}
}

enum hawser_status hawser__exact_support(struct hawser_rom_exact *exact,
                                         const struct hawser_modes *modes,
                                         const struct hawser_scene *scene,
                                         struct hawser_report *report)
{
	size_t points = (size_t)exact->points, each = 3*(size_t)modes->grid.points;
	size_t n = (size_t)exact->n;
	struct hawser__support_shapes shapes;
	struct hawser__signal signal;
	enum hawser_status status = hawser__support_shapes_make(&shapes, modes, report);

	exact->support = hawser__hold(&exact->hold, HAWSER__SUPPORT_MOST*3*points, sizeof *exact->support);
	if (exact->springs)
		exact->pull = hawser__hold(&exact->hold, HAWSER__SUPPORT_MOST*n, sizeof *exact->pull);
	if (!status && (!exact->support || (exact->springs && !exact->pull)))
		status = hawser__no_memory(report, "rom");
	for (int i = 0; !status && i < shapes.count; i++) {
		double *strain = exact->support + 3*points*(size_t)exact->supports;

		if (!hawser__support_factor(&signal, scene, i, &modes->statics))
			continue;
		for (size_t p = 0; p < points; p++)
			hawser__grid_at(strain + 3*p, &modes->grid, shapes.strain + (size_t)i*each, 3, 3,
			                exact->grid.s[p]);
		if (exact->pull) {
			pull(exact->pull + (size_t)exact->supports*n, modes, &shapes, i);
			status = hawser__exact_bend_pull(exact->pull + (size_t)exact->supports*n, exact, modes,
			                                 shapes.strain + (size_t)i*each, strain, report);
		}
		exact->supports++;
	}
	hawser__support_shapes_clear(&shapes);
	return status;
}

void hawser__exact_vary(const struct hawser_rom_exact *exact, double *restoring, double *tangent,
                        const double *u, const double *s)
{
	double force[HAWSER_ROM_MAX], T[HAWSER_ROM_MAX*HAWSER_ROM_MAX];
	int n = exact->n;

	for (int moved = 0; moved < 2; moved++) {
		double sign = moved ? 1.0 : -1.0;

		/* cppcheck-suppress legacyUninitvar ; it is filled there */
		hawser__exact_moved(exact, force, tangent ? T : NULL, u, moved ? s : NULL);
		for (int j = 0; j < n; j++)
			restoring[j] += sign*force[j];
		for (int i = 0; tangent && i < n*n; i++)
			tangent[i] += sign*T[i];
	}
	for (int i = 0; exact->pull && i < exact->supports; i++)
		for (int j = 0; j < n; j++)
			restoring[j] += s[i]*exact->pull[i*n + j];
}
