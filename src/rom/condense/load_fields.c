/* rom/condense/load_fields.c - the static response of the condensed modes to the load, as fields of
 * the energy.
 *
 * Each harmonic of the load has one in each plane. Those whose slopes change the tension by less
 * than HAWSER__FAINT_FIELD are left out. Their effect on the motion is much larger than that
 * (doc/theory-rom.md).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>

#include "core/report.h"
#include "rom/condense/condense.h"
#include "rom/condense/load_fields.h"
#include "rom/condense/support.h"

/* Change of the tension, relative, by the slopes of a field whose ends are fixed. */
static double tightens(const double *strain, const struct hawser_modes *modes)
{
	double sum = 0.0;

	for (int p = 0; p < modes->grid.points; p++)
		sum += 0.5*modes->grid.weight[p]*(pow(strain[3*p + 1], 2) + pow(strain[3*p + 2], 2));
	return sum/(modes->statics.l*modes->statics.epsilon);
}

/* The response to harmonic h, whose strains are `both` planes'. */
static void add(struct hawser__load_fields *fields, const struct hawser_modes *modes,
                const struct hawser__loads *loads, int h, const double *both)
{
	int space = modes->statics.space;
	size_t numbers = 3*(size_t)modes->grid.points;

	for (int plane = 0; plane < (space ? 1 : 2) && fields->count < HAWSER__LOAD_FIELDS; plane++) {
		double *own = fields->strain + numbers*(size_t)fields->count;

		for (size_t i = 0; i < numbers; i++)
			own[i] = space || (i%3 == 2) == (plane == 1) ? both[i] : 0.0;
		if (tightens(own, modes) < HAWSER__FAINT_FIELD)
			continue;
		fields->plane[fields->count] = plane ? HAWSER_OUT_OF_PLANE : HAWSER_IN_PLANE;
		fields->k[fields->count] = loads->k[h];
		fields->sine[fields->count++] = loads->sine[h];
	}
}

enum hawser_status hawser__load_fields_make(struct hawser__load_fields *fields,
                                            const struct hawser_modes *modes, int moving,
                                            const struct hawser_scene *scene,
                                            struct hawser_report *report)
{
	size_t numbers = 3*(size_t)modes->grid.points;
	double *both = malloc(numbers*sizeof *both);
	struct hawser__loads loads;
	enum hawser_status status = hawser__loads_make(&loads, &modes->statics, scene, report);

	*fields = (struct hawser__load_fields){.strain = malloc(HAWSER__LOAD_FIELDS*numbers*sizeof *both)};
	if (!status && (!both || !fields->strain))
		status = hawser__no_memory(report, "rom");
	for (int h = 0; !status && h < loads.harmonics; h++) {
		if (loads.k[h] > HAWSER__SUPPORT_TOP)
			continue;
		status = hawser__follow_strains(both, modes, moving, &loads, h, report);
		if (!status)
			add(fields, modes, &loads, h, both);
	}
	free(both);
	hawser__loads_clear(&loads);
	return status;
}

void hawser__load_fields_clear(struct hawser__load_fields *fields)
{
	free(fields->strain);
	*fields = (struct hawser__load_fields){.count = 0};
}
