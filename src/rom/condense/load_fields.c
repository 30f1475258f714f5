/* rom/condense/load_fields.c - the static response of the condensed modes to the load, and fields of
 * the energy from it.
 *
 * The response adds cos(Omega t) T_jk to the stiffness of the kept modes (follow.h): the load varies
 * the tension. The largest effect is due to its component along the cable, acting on longitudinal
 * modes, which are hardly ever kept. Terms of higher degree in the response are those of its fields
 * (support_energy.c).
 *
 * Each harmonic of the load has one in each plane. Those whose slopes change the tension by less
 * than HAWSER__FAINT_FIELD are left out. Their effect on the motion is much larger than that
 * (doc/theory-rom.md).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include "core/hold.h"
#include "core/report.h"
#include "modes/grid.h"
#include "rom/build/build.h"
#include "rom/condense/follow.h"
#include "rom/condense/fields.h"
#include "rom/condense/support.h"
#include "rom/terms/travel.h"

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

void hawser__rom_held(double *K, const struct hawser_rom *rom, const double *f, double factor)
{
	int n = rom->n, modes = n - rom->inertia.shapes;

	for (int i = 0; modes < n && i < rom->quads; i++) {
		const struct hawser_quad *q = &rom->Q[i];
		int s = q->l;

		if (q->j < modes && q->k < modes && s >= modes && rom->K[s*n + s] != 0.0)
			K[q->j*n + q->k] += factor*q->value*f[s]/rom->K[s*n + s];
	}
}

/* K of harmonic h by the response. */
static enum hawser_status stiffen(struct hawser_rom *rom, int h,
                                  const struct hawser__stations *stations,
                                  struct hawser_report *report)
{
	double *K = hawser__numbers((size_t)rom->n, (size_t)rom->n);

	if (!K)
		return hawser__no_memory(report, "rom");
	if (!hawser__follow_stiffness(K, stations)) {
		free(K);
		return HAWSER_OK;
	}
	/* second-order shapes respond to the load as coordinates */
	hawser__rom_held(K, rom, rom->harmonic[h].f, -1.0);
	rom->harmonic[h].K = K;
	return HAWSER_OK;
}

/* both [points of the grid][3] is work space. */
static enum hawser_status follow_loads(struct hawser_rom *rom, struct hawser__load_fields *fields,
                                  double *both, struct hawser__stations *stations,
                                  const struct hawser_grid *grid, const struct hawser__loads *loads,
                                  struct hawser_report *report)
{
	const struct hawser_modes *modes = stations->modes;
	enum hawser_status status = HAWSER_OK;

	for (int h = 0; !status && h < loads->harmonics; h++) {
		hawser__load_pull(stations, loads, h);
		hawser__follow(stations);
		status = stiffen(rom, h, stations, report);
		for (int p = 0; p < modes->grid.points; p++)
			hawser__grid_at(both + 3*(size_t)p, grid, stations->z, 3, 3, modes->grid.s[p]);
		if (loads->k[h] <= HAWSER__SUPPORT_TOP)
			add(fields, modes, loads, h, both);
	}
	return status;
}

static enum hawser_status vary(struct hawser_rom *rom, struct hawser__load_fields *fields,
                               const struct hawser_modes *modes, int moving,
                               const struct hawser_scene *scene, struct hawser_report *report)
{
	size_t numbers = 3*(size_t)modes->grid.points;
	double *both = hawser__numbers(numbers, 1);
	struct hawser__stations stations = {.count = 0};
	struct hawser_grid grid = {.points = 0}; /* its points are the stations */
	struct hawser__loads loads;
	enum hawser_status status = hawser__loads_make(&loads, &modes->statics, scene, report);

	fields->strain = hawser__numbers(HAWSER__LOAD_FIELDS, numbers);
	if (!status && (!both || !fields->strain))
		status = hawser__no_memory(report, "rom");
	if (!status)
		status = hawser__stations_make(&stations, modes, moving, loads.cut, loads.cuts, report);
	if (!status)
		status = hawser__grid_init(&grid, stations.parts, modes->grid.order, stations.edge, NULL,
		                           report);
	if (!status)
		status = follow_loads(rom, fields, both, &stations, &grid, &loads, report);
	hawser__grid_clear(&grid);
	hawser__stations_clear(&stations);
	hawser__loads_clear(&loads);
	free(both);
	return status;
}

enum hawser_status hawser__rom_vary(struct hawser_rom *rom, struct hawser__load_fields *fields,
                                    const struct hawser_modes *modes, int moving,
                                    const struct hawser_scene *scene, struct hawser_report *report)
{
	enum hawser_status status = hawser__loaded(scene)
	                            ? vary(rom, fields, modes, moving, scene, report) : HAWSER_OK;

	return status ? status : hawser__rom_travel_condensed(rom, modes, moving, scene, report);
}

void hawser__load_fields_clear(struct hawser__load_fields *fields)
{
	free(fields->strain);
	*fields = (struct hawser__load_fields){.count = 0};
}
