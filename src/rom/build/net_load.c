/* rom/build/net_load.c - loads and moving supports of a net, as harmonics of its model.
 *
 *   F, s      loads of the nodes of the mesh, and displacements of supports, times cos(k Omega t)
 *   psi       static displacement by s: K_ff psi_f = - K_fs s
 *
 * Displacements are psi cos(k Omega t) + u, and u is driven by F and by the inertia and the damping of
 * psi, - M psi'' - D psi'.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <math.h>
#include <string.h>

#include "core/report.h"
#include "core/vec3.h"
#include "net/water/water.h"
#include "rom/build/net.h"

enum { SAME = HAWSER__SUPPORT_TOP }; /* highest multiple */
static const double equal = 1e-9;    /* of a frequency and a multiple; round-off of decimal numbers */

/* --- mass and damping --- */

void hawser__net_spread(double (*shape)[3], const struct hawser__net_source *source, const double *row)
{
	for (int i = 0; i < source->modal.mesh.nodes; i++)
		hawser__eigen_place(shape[i], row, &source->modal.mesh, i);
}

void hawser__net_masses(const void *of, double *part, const double *x, int count, const double *y)
{
	const struct hawser__net_source *source = of;
	int unknowns = source->modal.mesh.unknowns;

	hawser__eigen_mass(source->scratch, y, &source->modal.mesh, 7U);
	cblas_dgemv(CblasRowMajor, CblasNoTrans, count, unknowns, 1.0/hawser__net_unit(source), x, unknowns,
	            source->scratch, 1, 0.0, part, 1);
}

/* row += factor times m x at the two nodes of an element, m the mean of the consistent and the lumped
 * matrix of a mass (or of drag). */
static void add_element(double *row, const struct hawser__mesh *mesh, int e, double m,
                        const double (*x)[3])
{
	for (int i = 0; i < 6; i++) {
		int node = mesh->end[e][i/3], other = mesh->end[e][1 - i/3], k = i%3;

		if (mesh->unknown[node][k] >= 0)
			row[mesh->unknown[node][k]] += m/12.0*(5.0*x[node][k] + x[other][k]);
	}
}

/* row += factor*M x of displacements that the supports have too. */
static void add_mass(double *row, const struct hawser__mesh *mesh, double factor, const double (*x)[3])
{
	struct hawser__mesh_pair pair;

	for (int i = 0; i < 3*mesh->nodes; i++)
		if (mesh->unknown[i/3][i%3] >= 0)
			row[mesh->unknown[i/3][i%3]] += factor*mesh->mass[i/3]*x[i/3][i%3];
	for (int e = 0; e < mesh->elements; e++)
		add_element(row, mesh, e, factor*mesh->rho[e]*mesh->length0[e], x);
	for (int j = 0; hawser__absorbers_mass(&pair, mesh, j); j++)
		if (mesh->unknown[pair.node][pair.axis] >= 0)
			row[mesh->unknown[pair.node][pair.axis]] +=
				factor*pair.mass*x[pair.other][pair.other_axis];
}

/* The same of the added mass. */
static void add_carried(double *row, const struct hawser__mesh *mesh, double factor,
                        const double (*x)[3])
{
	struct hawser__water_mass at;

	for (int j = 0; hawser__water_mass(&at, mesh, j); j++)
		for (int i = 0; i < 3; i++)
			if (mesh->unknown[at.node][i] >= 0)
				row[mesh->unknown[at.node][i]] += factor*hawser__dot(at.mass[i], x[at.node]);
}

/* The force of an element by its strains, EA a and T/g (b, c), N. */
static void add_strains(double *row, const struct hawser__net_source *source, int e, double along,
                        double aside, const double slope[3])
{
	const struct hawser__mesh *mesh = source->t.mesh;
	const double (*axes)[3] = (const double (*)[3])source->t.axes[e];

	for (int i = 0; i < 6; i++) {
		int at = mesh->unknown[mesh->end[e][i/3]][i%3], k = i%3;

		if (at >= 0)
			row[at] += (i < 3 ? -1.0 : 1.0)*(along*slope[0]*axes[0][k] +
			                                 aside*(slope[1]*axes[1][k] + slope[2]*axes[2][k]));
	}
}

/* row += factor*D x. */
static void add_damping(double *row, const struct hawser__net_source *source, double factor,
                        const double (*x)[3])
{
	const struct hawser__mesh *mesh = &source->modal.mesh;

	add_mass(row, mesh, factor*source->net->mass_rate, x);
	for (int i = 0; i < 3*mesh->nodes; i++)
		if (mesh->unknown[i/3][i%3] >= 0)
			row[mesh->unknown[i/3][i%3]] += factor*mesh->damper[i/3][i%3]*x[i/3][i%3];
	for (int e = 0; e < mesh->elements; e++) {
		double slope[3];

		add_element(row, mesh, e, factor*mesh->alpha*mesh->length0[e], x);
		if (!(mesh->axial[e] > 0.0))
			continue;
		hawser__nexpand_slope(slope, &source->t, e, x);
		add_strains(row, source, e, factor*mesh->axial[e]*mesh->EA[e], 0.0, slope);
	}
}

double hawser__net_damping(const struct hawser__net_source *source, const double (*x)[3],
                           const double *y)
{
	int unknowns = source->modal.mesh.unknowns;

	memset(source->scratch, 0, (size_t)unknowns*sizeof *source->scratch);
	add_damping(source->scratch, source, 1.0, x);
	return cblas_ddot(unknowns, source->scratch, 1, y, 1);
}

/* --- multiples --- */

/* Those of loads and motions whose frequencies are given. */
enum hawser_status hawser__net_multiples(struct hawser__mesh *mesh, const char *name,
                                         struct hawser_report *report)
{
	int all = mesh->waves + mesh->motions;
	const struct hawser_water *water = mesh->water ? mesh->water->of : NULL;
	double swell = water && water->waves.count ? water->waves.wave->omega : INFINITY, base = swell;

	for (int i = 0; i < all; i++) {
		struct hawser__mesh_wave *wave = i < mesh->waves ? &mesh->wave[i]
		                                                 : &mesh->motion[i - mesh->waves];

		base = wave->multiple > 0 ? base : fmin(base, wave->Omega);
	}
	for (int i = 0; i < all; i++) {
		struct hawser__mesh_wave *wave = i < mesh->waves ? &mesh->wave[i]
		                                                 : &mesh->motion[i - mesh->waves];
		double times = wave->Omega/base;

		if (wave->multiple == 0 && fabs(times - round(times)) <= equal*times && times <= SAME)
			wave->multiple = (int)round(times);
		if (wave->multiple < 1 || wave->multiple > SAME)
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "net rom", "%s: a harmonic of %.9g rad/s "
			                    "is no multiple up to %d of the lowest one, %.9g rad/s, and the "
			                    "response is periodic in that alone: give other frequencies, or "
			                    "harmonic.multiple", name, wave->Omega, (int)SAME, base);
	}
	if (base < (1.0 - equal)*swell && !isinf(swell))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "net rom", "%s: water.waves: their "
		                    "frequency of %.9g rad/s is above that of a harmonic, %.9g rad/s, and the "
		                    "response is periodic in the waves: give other frequencies, or "
		                    "harmonic.multiple", name, swell, base);
	return HAWSER_OK;
}

static double part_of(const struct hawser__mesh_wave *wave, int axis, int sine)
{
	if (sine) /* exactly zero in phase */
		return wave->phase == 0.0 ? 0.0 : -wave->value[axis]*sin(wave->phase);
	return wave->value[axis]*cos(wave->phase);
}

/* --- the harmonics --- */

/* A new wave, and its row; NULL: no memory. */
static double *add_wave(struct hawser__net_source *source, int k, int sine, int power)
{
	double *row = hawser__hold(&source->hold, (size_t)source->modal.mesh.unknowns + 1, sizeof *row);

	source->wave[source->waves] = (struct hawser__net_wave){k, sine, power, row};
	source->waves += row != NULL;
	return row;
}

static enum hawser_status take_load(struct hawser__net_source *source, int k, int sine,
                                    struct hawser_report *report)
{
	const struct hawser__mesh *mesh = &source->modal.mesh;
	double *row = NULL;

	for (int i = 0; i < 3*mesh->waves; i++) {
		const struct hawser__mesh_wave *wave = &mesh->wave[i/3];
		int at = mesh->unknown[wave->node][i%3];
		double value = part_of(wave, i%3, sine);

		if (wave->multiple != k || at < 0 || value == 0.0)
			continue;
		if (!row)
			row = add_wave(source, k, sine, 0);
		if (!row)
			return hawser__no_memory(report, "net rom");
		row[at] += value;
	}
	return HAWSER_OK;
}

/* The rest of the net follows the supports of the shape. */
static enum hawser_status lift_rest(struct hawser__net_source *source, double (*shape)[3],
                                    struct hawser_report *report)
{
	const struct hawser__mesh *mesh = &source->modal.mesh;
	double *row = source->scratch;
	enum hawser_status status;

	memset(row, 0, (size_t)mesh->unknowns*sizeof *row);
	for (int e = 0; e < mesh->elements; e++) {
		double slope[3], g = 1.0 + source->t.strain[e];

		hawser__nexpand_slope(slope, &source->t, e, (const double (*)[3])shape);
		add_strains(row, source, e, -mesh->EA[e], -source->modal.T[e]/g, slope);
	}
	status = hawser__sparse_solve(row, source->t.sparse, report);
	for (int i = 0; i < 3*mesh->nodes; i++)
		if (mesh->unknown[i/3][i%3] >= 0)
			shape[i/3][i%3] = row[mesh->unknown[i/3][i%3]];
	return status;
}

static enum hawser_status take_motion(struct hawser__net_source *source, int k, int sine,
                                      struct hawser_report *report)
{
	const struct hawser__mesh *mesh = &source->modal.mesh;
	struct hawser__net_lift *lift = &source->lift[source->lifts];
	const double (*shape)[3];
	double *inertia, *damping, size = 0.0;
	enum hawser_status status;

	for (int i = 0; i < 3*mesh->motions; i++)
		size += mesh->motion[i/3].multiple == k ? fabs(part_of(&mesh->motion[i/3], i%3, sine)) : 0.0;
	if (size == 0.0)
		return HAWSER_OK;
	*lift = (struct hawser__net_lift){k, sine,
		hawser__hold(&source->hold, (size_t)mesh->nodes, sizeof *lift->shape)};
	inertia = add_wave(source, k, sine, 2);
	damping = add_wave(source, k, !sine, 1);
	if (!lift->shape || !inertia || !damping)
		return hawser__no_memory(report, "net rom");
	source->lifts++;
	for (int i = 0; i < 3*mesh->motions; i++)
		if (mesh->motion[i/3].multiple == k)
			lift->shape[mesh->motion[i/3].node][i%3] += part_of(&mesh->motion[i/3], i%3, sine);
	status = lift_rest(source, lift->shape, report);
	shape = (const double (*)[3])lift->shape;
	add_mass(inertia, mesh, (double)k*k, shape);
	add_carried(inertia, mesh, (double)k*k, shape);
	add_damping(damping, source, sine ? -k : k, shape);
	return status;
}

enum hawser_status hawser__net_loads_of(struct hawser__net_source *source,
                                        struct hawser_report *report)
{
	enum hawser_status status = hawser__net_multiples(&source->modal.mesh, source->net->name,
	                                                  report);

	source->wave = hawser__hold(&source->hold, 6*((size_t)SAME + 1), sizeof *source->wave);
	source->lift = hawser__hold(&source->hold, 2*((size_t)SAME + 1), sizeof *source->lift);
	if (!status && source->hold.short_of_memory)
		status = hawser__no_memory(report, "net rom");
	for (int i = 0; i < 2*SAME && !status; i++) {
		status = take_load(source, i/2 + 1, i%2, report);
		if (!status)
			status = take_motion(source, i/2 + 1, i%2, report);
	}
	return status;
}
