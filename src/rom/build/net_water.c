/* rom/build/net_water.c - the water of a net, as a force of its model (rom/terms/morison.h).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <string.h>

#include "core/hold.h"
#include "core/hot.h"
#include "core/report.h"
#include "rom/build/net.h"
#include "rom/condense/support.h"
#include "rom/file/plug.h"
#include "rom/terms/morison.h"

enum hawser_status hawser__net_water_check(const struct hawser_net *net, struct hawser_report *report)
{
	const struct hawser_water *water = &net->water;

	if (water->waves.count > 1)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "net rom", "%s: water.waves: a model takes "
		                    "regular waves, and these are a sea of %d components: give height and "
		                    "period, or use hawser integrate, or hawser frf, whose response to a sea "
		                    "is linear", net->name, water->waves.count);
	if (water->file)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "net rom", "%s: water.current.file: the "
		                    "response is to harmonic loads, and this current has a course of its own: "
		                    "give a constant current, or use hawser integrate", net->name);
	return HAWSER_OK;
}

/* What the motion of the mesh does to the water: its lines and buoys. */
static int open_water(struct hawser__rom_morison *of, const struct hawser__net_source *source)
{
	const struct hawser__mesh *mesh = &source->modal.mesh;
	const struct hawser_water *water = &source->net->water;
	struct hawser__hold *hold = &of->hold;
	size_t elements = (size_t)mesh->elements, points = 2*elements + (size_t)mesh->water->buoys;
	size_t n = (size_t)of->n, columns = (size_t)of->columns;
	struct hawser_water_line *line = hawser__hold(hold, elements, sizeof *line);
	void *current = hawser__hold(hold, (size_t)water->levels, sizeof *water->current);
	void *wave = hawser__hold(hold, (size_t)water->waves.count, sizeof *water->waves.wave);

	of->mesh = (struct hawser__mesh){.g = mesh->g, .water = &of->wet,
		.length0 = hawser__hold(hold, elements, sizeof *mesh->length0),
		.offset = hawser__hold(hold, elements, sizeof *mesh->offset)};
	of->wet = (struct hawser__mesh_water){.of = &of->water, .band = mesh->water->band,
		.line = hawser__hold(hold, elements, sizeof *mesh->water->line)};
	of->water = *water;
	of->buoy = hawser__hold(hold, (size_t)mesh->water->buoys, sizeof *of->buoy);
	of->node = hawser__hold(hold, points, sizeof *of->node);
	of->place = hawser__hold(hold, points, sizeof *of->place);
	of->shape = hawser__hold(hold, points*3*(size_t)of->width, sizeof *of->shape);
	of->spring = hawser__hold(hold, n*columns, sizeof *of->spring);
	of->still = hawser__hold(hold, n, sizeof *of->still);
	of->k = hawser__hold(hold, columns, sizeof *of->k);
	of->sine = hawser__hold(hold, columns, sizeof *of->sine);
	if (hold->short_of_memory)
		return 0;
	if (water->levels > 0)
		of->water.current = memcpy(current, water->current,
		                           (size_t)water->levels*sizeof *water->current);
	if (water->waves.count > 0)
		of->water.waves.wave = memcpy(wave, water->waves.wave, sizeof *water->waves.wave);
	for (int e = 0; e < mesh->elements; e++) {
		if (!(mesh->water->line[e]->diameter > 0.0))
			continue;
		line[of->elements] = *mesh->water->line[e];
		of->wet.line[of->elements] = &line[of->elements];
		of->mesh.length0[of->elements++] = hawser__mesh_length(mesh, e);
	}
	for (int i = 0; i < mesh->water->buoys; i++)
		of->buoy[of->buoys++] = *mesh->water->buoy[i].of;
	return 1;
}

/* The node of the mesh of each point. */
static void list_points(int *node, const struct hawser__mesh *mesh)
{
	int points = 0;

	for (int e = 0; e < 2*mesh->elements; e++)
		if (mesh->water->line[e/2]->diameter > 0.0)
			node[points++] = mesh->end[e/2][e%2];
	for (int i = 0; i < mesh->water->buoys; i++)
		node[points++] = mesh->water->buoy[i].node;
}

/* What the springs of the buoyancy do to the coordinates where unknowns move as in column j. */
static void add_springs(struct hawser__rom_morison *of, const struct hawser__net_source *source, int j,
                        const double (*x)[3], double (*work)[3])
{
	const struct hawser__mesh *mesh = &source->modal.mesh;
	struct hawser__water_spring at;

	for (int i = 0; i < of->n; i++) {
		hawser__net_spread(work, source, hawser__net_row(source, i));
		for (int k = 0; hawser__water_spring(&at, mesh, k); k++)
			for (int l = 0; l < 4; l++)
				if (mesh->unknown[at.node[l%2]][1] >= 0)
					of->spring[i*of->columns + j] += work[at.node[l/2]][1]*at.k[l/2][l%2]*
					                                 x[at.node[l%2]][1];
	}
}

static int set_shapes(struct hawser__rom_morison *of, const struct hawser__net_source *source)
{
	const struct hawser__mesh *mesh = &source->modal.mesh;
	int points = 2*of->elements + of->buoys, *node = of->node;
	double (*x)[3] = calloc((size_t)mesh->nodes, sizeof *x);
	double (*work)[3] = calloc((size_t)mesh->nodes, sizeof *work);
	int good = x && work;

	if (good)
		list_points(node, mesh);
	for (int p = 0; good && p < points; p++)
		memcpy(of->place[p], mesh->q[node[p]], sizeof *of->place);
	for (int j = 0; good && j < of->columns; j++) {
		const struct hawser__net_lift *lift = &source->lift[j - of->n];

		if (j < of->n) {
			hawser__net_spread(x, source, hawser__net_row(source, j));
		} else {
			memcpy(x, lift->shape, (size_t)mesh->nodes*sizeof *x);
			of->k[j - of->n] = lift->k;
			of->sine[j - of->n] = lift->sine;
		}
		for (int p = 0; p < 3*points; p++)
			of->shape[(size_t)p*(size_t)of->width + (size_t)j] = x[node[p/3]][p%3];
		add_springs(of, source, j, (const double (*)[3])x, work);
	}
	free(work);
	free(x);
	return good;
}

/* At rest in the current: what statics has; and K and D beyond those of the model, unless NULL. */
static int set_still(struct hawser__rom_morison *of, double *K, double *D)
{
	int n = of->n;
	double *rest = hawser__numbers((size_t)n, 2*(size_t)n + 3), *a = hawser__behind(rest, (size_t)n);
	double *omega = hawser__behind(a, (size_t)n), *by_u = hawser__behind(omega, (size_t)n);
	double *by_v = hawser__behind(by_u, (size_t)n*(size_t)n);

	if (!rest)
		return 0;
	hawser__rom_morison_at(of, a, by_u, by_v, omega, rest, rest, 0.0, 1.0, 1);
	for (int j = 0; j < n; j++)
		of->still[j] = of->unit*a[j];
	for (int i = 0; i < n*n && K; i++) {
		K[i] -= by_u[i];
		D[i] -= by_v[i];
	}
	free(rest);
	return 1;
}

enum hawser_status hawser__net_water_fill(struct hawser_rom *rom,
                                          const struct hawser__net_source *source, int linear,
                                          struct hawser_report *report)
{
	const struct hawser__mesh_water *water = source->modal.mesh.water;
	struct hawser__rom_morison *of;

	_Static_assert(HAWSER_NET_ROM_MODES + HAWSER__INERTIA_MOST + 2*HAWSER__SUPPORT_TOP <=
	               HAWSER__MORISON_MOST, "all columns have room");
	if (!water || source->net->winds)
		return HAWSER_OK;
	of = calloc(1, sizeof *of);
	if (!of)
		return hawser__no_memory(report, "net rom");
	of->n = rom->n;
	of->columns = rom->n + source->lifts;
	of->width = HAWSER_PADDED(of->columns);
	of->time = source->time;
	of->unit = hawser__net_unit(source)/(source->time*source->time);
	of->waves = !linear && water->of->waves.count > 0;
	if (!open_water(of, source) || !set_shapes(of, source) ||
	    !set_still(of, linear ? rom->K : NULL, rom->D)) {
		hawser__rom_morison_free(of);
		return hawser__no_memory(report, "net rom");
	}
	if (linear) {
		hawser__rom_morison_free(of);
		return HAWSER_OK;
	}
	return hawser__plug_join(rom, of, of->waves ? water->of->waves.wave->omega*of->time : 1.0, report);
}
