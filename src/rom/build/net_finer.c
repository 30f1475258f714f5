/* rom/build/net_finer.c - the model of a net without the error of second order in the length of its
 * elements: 4/3 of the model of the mesh less 1/3 of that of one with half as many elements, entry by
 * entry.
 *
 * Coordinates of both are the same, since each mode of the second mesh is the one most like the mode of
 * the first, with its sign; of modes of equal frequencies, the combinations most like those. Known
 * motions (modes/driven.h) are not paired: they stay those of the first mesh.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "core/vec3.h"
#include "net/water/water.h"
#include "rom/build/net.h"
#include "rom/terms/ends.h"

enum { PARTS = 8, ROW = 101 /* LAPACK_ROW_MAJOR */ }; /* elements of a cable: a multiple, so that the
                                   * points of the model are nodes of both meshes */
static const double same = 1e-6;  /* relative gap of equal frequencies, which round-off leaves */
static const double alike = 0.9;  /* least product of two modes of the mass 1 that are one */

/* --- meshes --- */

enum hawser_status hawser__net_finer(struct hawser_net *to, const struct hawser_net *net, int halvings,
                                     struct hawser_report *report)
{
	enum hawser_status status = hawser__mesh_lawless(net, "a model", report);

	*to = *net;
	to->cable = NULL;
	if (status)
		return status;
	to->cable = calloc((size_t)net->cables + 1, sizeof *to->cable);
	if (!to->cable)
		return hawser__no_memory(report, "net rom");
	for (int c = 0; c < net->cables; c++) {
		struct hawser_net_cable *cable = &to->cable[c];

		*cable = net->cable[c];
		if (cable->elements > 1 || cable->rho > 0.0)
			cable->elements = (cable->elements + PARTS - 1)/PARTS*PARTS/(1 << halvings);
	}
	return HAWSER_OK;
}

/* --- modes --- */

/* x'M y of the added mass that both elements have at node i of a cable of `count` elements. */
static double carried(const struct hawser__mesh *mesh, int first, int i, int count, const double x[3],
                      const double y[3])
{
	double sum = 0.0;

	for (int side = 0; side < 2 && mesh->water; side++)
		for (int k = 0; k < 3 && i - side >= 0 && i - side < count; k++)
			sum += x[k]*hawser__dot(mesh->water->mass[first + i - side][side][k], y);
	return sum;
}

/* Products [coarse n][fine n], of lumped masses, over the nodes that both meshes have. */
static void overlap(double *product, const struct hawser__net_source *coarse, int n,
                    const struct hawser__net_source *fine)
{
	const struct hawser__mesh *mesh = &coarse->modal.mesh, *other = &fine->modal.mesh;
	size_t unknowns = (size_t)mesh->unknowns, others = (size_t)other->unknowns;

	for (int c = 0; c < mesh->cables; c++) {
		int count = mesh->first[c + 1] - mesh->first[c];
		int ratio = (other->first[c + 1] - other->first[c])/count;

		for (int i = 0; i <= count; i++) {
			int last = i == count, e = mesh->first[c] + i - last, at = mesh->end[e][last];
			int from = other->end[other->first[c] + ratio*i - last][last];
			double mass = mesh->rho[e]*mesh->length0[e]*(last || i == 0 ? 0.5 : 1.0);

			mass += i == 0 || last ? mesh->mass[at] : 0.0; /* some count twice, which does not matter */
			for (int k = 0; k < n; k++)
				for (int j = 0; j < fine->n; j++) {
					double x[3], y[3];

					hawser__eigen_place(x, coarse->modal.eigen.x + (size_t)k*unknowns, mesh, at);
					hawser__eigen_place(y, fine->mode + (size_t)j*others, other, from);
					product[k*fine->n + j] += mass*hawser__dot(x, y) +
					                          carried(mesh, mesh->first[c], i, count, x, y);
				}
		}
	}
	for (int i = 0; i < (mesh->water ? mesh->water->buoys : 0)*n*fine->n; i++) {
		const struct hawser__mesh_buoy *buoy = &mesh->water->buoy[i/(n*fine->n)];
		double x[3], y[3];

		hawser__eigen_place(x, coarse->modal.eigen.x + (size_t)(i/fine->n%n)*unknowns, mesh,
		                    buoy->node);
		hawser__eigen_place(y, fine->mode + (size_t)(i%fine->n)*others, other, buoy->node);
		product[i%(n*fine->n)] += buoy->mass[0][0]*hawser__dot(x, y);
	}
	for (int i = 0; i < mesh->absorbers*n*fine->n; i++) {
		const struct hawser__mesh_absorber *of = &mesh->absorber[i/(n*fine->n)];
		const struct hawser__mesh_absorber *too = &other->absorber[i/(n*fine->n)];
		const double *x = coarse->modal.eigen.x + (size_t)(i/fine->n%n)*unknowns;
		const double *y = fine->mode + (size_t)(i%fine->n)*others;
		double u[3], v[3], s[3], r[3];

		hawser__eigen_place(u, x, mesh, of->node);
		hawser__eigen_place(s, x, mesh, of->at);
		hawser__eigen_place(v, y, other, too->node);
		hawser__eigen_place(r, y, other, too->at);
		product[i%(n*fine->n)] += of->mass*(hawser__dot(of->e, u)*r[of->axis] +
		                                    hawser__dot(of->e, v)*s[of->axis] + hawser__dot(s, r));
	}
	for (int k = 0; k < n; k++)
		for (int j = 0; j < fine->n; j++)
			product[k*fine->n + j] /= sqrt(coarse->modal.modes.mass[k]*fine->mass)*fine->length;
}

static int in_group(const struct hawser__net_source *fine, int j)
{
	const double *omega = fine->modal.modes.omega;
	int count = 1;

	while (j + count < fine->n && omega[fine->kept[j + count]] - omega[fine->kept[j]] <
	       same*omega[fine->kept[j]])
		count++;
	return count;
}

/* The modes of the second mesh of a group of the first, from its coordinate `first` on, in `choice`;
 * 0: they are not alike. Those that are taken have no product any more. */
static int choose(int *choice, double *product, int n, int all, int first, int count)
{
	for (int g = 0; g < count; g++) {
		double most = 0.0;

		choice[g] = 0;
		for (int k = 0; k < n; k++) {
			double square = 0.0;
			int taken = 0;

			for (int i = 0; i < g; i++)
				taken |= choice[i] == k;
			for (int i = first; i < first + count; i++)
				square += product[k*all + i]*product[k*all + i];
			if (!taken && square > most) {
				most = square;
				choice[g] = k;
			}
		}
		if (!(most > alike*alike))
			return 0;
	}
	return 1;
}

/* The orthogonal matrix nearest to product [count][count], in its place; 0: there is none. */
static int nearest(double *product, int count)
{
	double u[HAWSER_NET_ROM_MODES*HAWSER_NET_ROM_MODES], v[HAWSER_NET_ROM_MODES*HAWSER_NET_ROM_MODES];
	double s[HAWSER_NET_ROM_MODES], work[HAWSER_NET_ROM_MODES];

	if (LAPACKE_dgesvd(ROW, 'A', 'A', count, count, product, count, s, u, count, v, count, work))
		return 0;
	cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, count, count, count, 1.0, u, count, v, count,
	            0.0, product, count);
	return 1;
}

static int align_group(struct hawser__net_source *coarse, double *product, int n,
                       const struct hawser__net_source *fine, int first, int count)
{
	double turn[HAWSER_NET_ROM_MODES*HAWSER_NET_ROM_MODES];
	int choice[HAWSER_NET_ROM_MODES], unknowns = coarse->modal.mesh.unknowns;

	if (!choose(choice, product, n, fine->n, first, count))
		return 0;
	for (int g = 0; g < count; g++)
		memcpy(turn + g*count, product + choice[g]*fine->n + first, (size_t)count*sizeof *turn);
	if (!nearest(turn, count))
		return 0;
	for (int j = 0; j < count; j++) {
		coarse->kept[first + j] = choice[j];
		for (int g = 0; g < count; g++)
			cblas_daxpy(unknowns, turn[g*count + j]*
			            coarse->length*sqrt(coarse->mass/coarse->modal.modes.mass[choice[g]]),
			            coarse->modal.eigen.x + (size_t)choice[g]*(size_t)unknowns, 1,
			            coarse->mode + (size_t)(first + j)*(size_t)unknowns, 1);
	}
	return 1;
}

enum hawser_status hawser__net_align(int *aligned, struct hawser__net_source *coarse,
                                     const struct hawser__net_source *fine,
                                     struct hawser_report *report)
{
	int n = coarse->modal.modes.n, good = 1;
	double *product = hawser__numbers((size_t)n, (size_t)fine->n);

	if (!product)
		return hawser__no_memory(report, "net rom");
	overlap(product, coarse, n, fine);
	for (int j = 0, count; j < fine->n && good; j += count) {
		count = in_group(fine, j);
		good = align_group(coarse, product, n, fine, j, count);
	}
	free(product);
	*aligned = good;
	return HAWSER_OK;
}

/* --- models --- */

static void mix(double *to, const double *from, size_t count)
{
	for (size_t i = 0; to && from && i < count; i++)
		to[i] = (4.0*to[i] - from[i])/3.0;
}

/* 4/3 of the entries of *to, and -1/3 of the others behind them; 0: no memory. */
#define APPEND(to, count, from, more) append((void **)(to), count, from, more, sizeof **(to), \
	offsetof(__typeof__(**(to)), value))
static int append(void **to, int *count, const void *from, int more, size_t size, size_t value)
{
	char *list = realloc(*to, (size_t)(*count + more)*size + 1);

	if (!list)
		return 0;
	*to = list;
	if (more > 0)
		memcpy(list + (size_t)*count*size, from, (size_t)more*size);
	for (int i = 0; i < *count + more; i++) {
		double own;

		memcpy(&own, list + (size_t)i*size + value, sizeof own);
		own *= i < *count ? 4.0/3.0 : -1.0/3.0;
		memcpy(list + (size_t)i*size + value, &own, sizeof own);
	}
	*count += more;
	return 1;
}

static int mix_harmonic(struct hawser_harmonic *to, const struct hawser_harmonic *from,
                        const struct hawser_rom *rom)
{
	size_t n = (size_t)rom->n;

	mix(to->f, from->f, n);
	mix(to->D, from->D, n*n);
	mix(to->K, from->K, n*n);
	mix(to->answer, from->answer, 8*(size_t)rom->shapes.points);
	mix(to->answer_line, from->answer_line, 2*(size_t)rom->line.points);
	return APPEND(&to->Q, &to->quads, from->Q, from->quads);
}

/* Whether both have the same harmonics, with the same terms. */
static int matches(const struct hawser_rom *to, const struct hawser_rom *from)
{
	int good = to->harmonics == from->harmonics && !to->ends == !from->ends &&
	           to->shapes.points == from->shapes.points && to->line.points == from->line.points;

	for (int h = 0; good && h < to->harmonics; h++) {
		const struct hawser_harmonic *a = &to->harmonic[h], *b = &from->harmonic[h];

		good = a->k == b->k && a->phase == b->phase && a->omega_power == b->omega_power &&
		       a->load_power == b->load_power && !a->f == !b->f && !a->K == !b->K;
	}
	return good && (!to->ends || to->ends->count == from->ends->count);
}

static void mix_places(struct hawser_rom *to, const struct hawser_rom *from)
{
	size_t n = (size_t)to->n, points = (size_t)to->shapes.points, line = (size_t)to->line.points;
	size_t modes = n - (size_t)to->inertia.shapes, pairs = modes*(modes + 1)/2, moved;

	mix(to->shapes.stretch, from->shapes.stretch, points);
	mix(to->shapes.shape, from->shapes.shape, 3*n*points);
	mix(to->shapes.slope, from->shapes.slope, 3*n*points);
	mix(to->shapes.second_shape, from->shapes.second_shape, 3*pairs*points);
	mix(to->shapes.second_slope, from->shapes.second_slope, 3*pairs*points);
	mix(to->line.stretch, from->line.stretch, line);
	mix(to->line.slope, from->line.slope, 3*n*line);
	mix(to->line.second_slope, from->line.second_slope, 3*pairs*line);
	if (!to->ends)
		return;
	moved = hawser__ends_pairs(to->ends);
	mix(to->ends->slope, from->ends->slope, 3*(size_t)to->ends->count*points);
	mix(to->ends->line, from->ends->line, 3*(size_t)to->ends->count*line);
	mix(to->ends->second_shape, from->ends->second_shape, 3*moved*points);
	mix(to->ends->second_slope, from->ends->second_slope, 3*moved*points);
	mix(to->ends->second_line, from->ends->second_line, 3*moved*line);
}

enum hawser_status hawser__net_mix(struct hawser_rom *to, int *mixed, const struct hawser_rom *from,
                                   struct hawser_report *report)
{
	size_t n = (size_t)to->n;
	int good = *mixed = matches(to, from);

	if (!good)
		return HAWSER_OK;
	mix(to->K, from->K, n*n);
	mix(to->D, from->D, n*n);
	mix_places(to, from);
	good = APPEND(&to->Q, &to->quads, from->Q, from->quads) &&
	       APPEND(&to->C, &to->cubics, from->C, from->cubics) &&
	       APPEND(&to->term, &to->terms, from->term, from->terms);
	for (int h = 0; good && h < to->harmonics; h++)
		good = mix_harmonic(&to->harmonic[h], &from->harmonic[h], to);
	return good ? HAWSER_OK : hawser__no_memory(report, "net rom");
}
