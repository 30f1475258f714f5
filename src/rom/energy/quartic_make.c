/* rom/energy/quartic_make.c - the tables of quartic.h from modes on their grid. Glossary: quartic.c.
 *
 * A level span is its own mirror image, and a symmetric motion excites no antisymmetric mode: entries
 * of the tensors are exactly 0. So that forces are too, the second half of each row has the mirror
 * images of the points of the first half (the point at mid-span is in both, with half its weight), and
 * values at them that are equal but for sign are made so to the last bit. Sums over the two halves then
 * cancel exactly. Under reflection a symmetric mode keeps a and reverses b and c; an antisymmetric mode
 * reverses a and keeps b and c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "rom/terms/absorbers.h"
#include "rom/terms/dampers.h"
#include "rom/condense/follow.h"
#include "rom/energy/project.h"
#include "rom/energy/quartic.h"

void hawser__quartic_free(struct hawser__quartic *quartic)
{
	if (!quartic)
		return;
	hawser__hold_clear(&quartic->hold);
	free(quartic);
}

static double *array(int a, int b)
{
	return calloc((size_t)a*(size_t)b + 1, sizeof(double));
}

static double *keep(struct hawser__quartic *q, int a, int b)
{
	return hawser__hold(&q->hold, (size_t)a*(size_t)b, sizeof(double));
}

static int padded(int size)
{
	const int step = HAWSER__QUARTIC_WIDTH;

	return (size + step - 1)/step*step;
}

/* Numbers of coordinates and rows; `moving` coordinates are modes, the others shapes. */
static void count(struct hawser__quartic *q, const struct hawser_modes *modes, int moving)
{
	q->n = modes->n;
	q->points = modes->grid.points;
	q->width = q->mirror ? 2*((q->points + 7)/8*4) : padded(q->points);
	for (int j = 0; j < modes->n; j++) {
		int in = modes->mode[j].plane == HAWSER_IN_PLANE;

		*(in ? &q->in : &q->out) += 1;
		*(in ? &q->moving_in : &q->moving_out) += j < moving;
	}
	q->rows_in = q->in + (q->condensed ? 2 : 0);
	q->rows_out = q->out + (q->condensed ? 1 : 0);
	q->padded_in = padded(q->rows_in);
	q->padded_out = padded(q->rows_out);
}

/* Size of a matrix of pull_in or pull_out. */
static int pull_size(const struct hawser__quartic *q, int out)
{
	if (!q->condensed)
		return 0;
	return out ? q->rows_in*q->moving_out + q->rows_out*q->moving_in
	           : q->rows_in*q->moving_in + q->rows_out*q->moving_out;
}

static struct hawser__quartic *allocate(const struct hawser_modes *modes,
                                        const struct hawser__condensed *condensed)
{
	struct hawser__quartic *q = calloc(1, sizeof *q);

	if (!q)
		return NULL;
	q->condensed = condensed != NULL;
	q->kind = hawser__hold(&q->hold, (size_t)modes->n, sizeof *q->kind);
	if (q->kind)
		q->mirror = hawser__rom_mirror(q->kind, modes);
	count(q, modes, condensed ? condensed->n : modes->n);
	q->index = hawser__hold(&q->hold, (size_t)q->n, sizeof *q->index);
	q->K = keep(q, q->n, q->n);
	q->ab = keep(q, q->rows_in, 2*q->width);
	q->c = keep(q, q->rows_out, q->width);
	q->third = keep(q, q->width, 1);
	q->square = keep(q, q->width, 1);
	q->mixed = keep(q, q->width, 1);
	q->bend_in = keep(q, q->rows_in, q->padded_in);
	q->bend_out = keep(q, q->rows_out, q->padded_out);
	q->pull_in = keep(q, q->moving_in, pull_size(q, 0));
	q->pull_out = keep(q, q->moving_out, pull_size(q, 1));
	if (!q->hold.short_of_memory)
		return q;
	hawser__quartic_free(q);
	return NULL;
}

/* Point of the grid in column p of the tables, or -1; *share of its weight belongs to the column. */
static int point_of(double *share, const struct hawser__quartic *q, int p)
{
	int half = q->width/2, right = p >= half, i = right ? p - half : p;

	*share = 1.0;
	if (!q->mirror)
		return p < q->points ? p : -1;
	if (i >= (q->points + 1)/2)
		return -1;
	if (2*i + 1 == q->points)
		*share = 0.5;
	return right ? q->points - 1 - i : i;
}

/* Make the halves of a row, `apart` numbers apart, equal but for the sign. */
static void reflect(const struct hawser__quartic *q, double *row, int apart, double sign)
{
	for (int i = 0; q->mirror && i < q->width/2; i++) {
		double mean = 0.5*(row[i] + sign*row[apart + i]);

		row[i] = mean;
		row[apart + i] = sign*mean;
	}
}

/* The same for row r of a plane: `antisymmetric` if it has this kind. */
static void reflect_row(struct hawser__quartic *q, int r, int out_of_plane)
{
	int width = q->width, anti = hawser__quartic_kind(q, r, out_of_plane)%2;
	double *ab = q->ab + (size_t)r*2*(size_t)width;

	if (out_of_plane) {
		reflect(q, q->c + (size_t)r*(size_t)width, width/2, anti ? 1.0 : -1.0);
		return;
	}
	reflect(q, ab, width, anti ? -1.0 : 1.0);
	reflect(q, ab + width/2, width, anti ? 1.0 : -1.0);
}

int hawser__quartic_kind(const struct hawser__quartic *q, int r, int out_of_plane)
{
	if (out_of_plane)
		return r < q->out ? q->kind[q->in + r] : 2 + q->mirror;
	/* the end force along the chord is symmetric, the one across it antisymmetric */
	return r < q->in ? q->kind[r] : (r == q->in + 1 && q->mirror);
}

/* Coefficients of the energy in column p. */
static void set_point(struct hawser__quartic *q, double strain, int p,
                      const struct hawser__place *place, double share)
{
	double g = 1.0 + strain, eps = place->eps, w = share*place->weight;

	q->third[p] = w/(g*g*eps);
	q->square[p] = w/(8.0*g*g*g*eps);
	q->mixed[p] = w/(2.0*g*g*g*eps);
	if (q->condensed) {
		q->square[p] *= strain/g;
		q->mixed[p] *= 1.0 + 1.0/(g*place->k*eps);
	}
}

/* The columns M^-1 C in column p. */
static void set_ends(struct hawser__quartic *q, int p, const struct hawser__place *place)
{
	size_t width = (size_t)q->width;
	int a = HAWSER__QUARTIC_A(p, q->width), b = HAWSER__QUARTIC_B(p, q->width);
	double *along = q->ab + (size_t)q->in*2*width, *across = along + 2*width;

	along[a] = place->eps*place->axis[0][0];
	along[b] = place->axis[1][0]/place->k;
	across[a] = place->eps*place->axis[0][1];
	across[b] = place->axis[1][1]/place->k;
	q->c[(size_t)q->out*width + (size_t)p] = 1.0/place->k;
}

/* Strains of all coordinates in column p, which is `point` of the grid. */
static void set_strains(struct hawser__quartic *q, const struct hawser_modes *modes, int p, int point)
{
	size_t width = (size_t)q->width, points = (size_t)q->points;

	for (int i = 0; i < q->n; i++) {
		const double *slope = modes->slope + ((size_t)q->index[i]*points + (size_t)point)*3;
		double *row = q->ab + (size_t)i*2*width;

		if (i < q->in) {
			row[HAWSER__QUARTIC_A(p, q->width)] = slope[0];
			row[HAWSER__QUARTIC_B(p, q->width)] = slope[1];
		} else {
			q->c[(size_t)(i - q->in)*width + (size_t)p] = slope[2];
		}
	}
}

/* `index`, and `kind` by plane: on entry the symmetry of the coordinates of the model. */
static int set_order(struct hawser__quartic *q, const struct hawser_modes *modes)
{
	int *anti = malloc((size_t)q->n*sizeof *anti), next = 0, next_z = q->in;

	if (!anti)
		return 1;
	memcpy(anti, q->kind, (size_t)q->n*sizeof *anti);
	for (int j = 0; j < q->n; j++)
		q->index[modes->mode[j].plane == HAWSER_IN_PLANE ? next++ : next_z++] = j;
	for (int i = 0; i < q->n; i++)
		q->kind[i] = (i >= q->in ? 2 : 0) + anti[q->index[i]];
	free(anti);
	return 0;
}

/* G = U'M U [rows][rows] of a plane: table [rows][width], stiffness [width] of its columns. */
static int multiply(double *G, const double *table, const double *stiffness, int rows, int width)
{
	double *scaled = array(rows, width);

	if (!scaled)
		return 1;
	for (int r = 0; r < rows; r++)
		for (int p = 0; p < width; p++)
			scaled[(size_t)r*width + p] = sqrt(stiffness[p])*table[(size_t)r*width + p];
	cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasTrans, rows, rows, width, 1.0, scaled, width,
	            scaled, width, 0.0, G, rows);
	free(scaled);
	return 0;
}

/* B [rows][stride] = 2 E - E G E; G is overwritten. */
static int combine(double *B, double *G, const double *E, int rows, int stride)
{
	double *product = array(rows, rows);

	if (!product)
		return 1;
	cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, rows, rows, rows, 1.0, E, rows, G, rows,
	            0.0, product, rows);
	cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, rows, rows, rows, 1.0, product, rows, E,
	            rows, 0.0, G, rows);
	for (int r = 0; r < rows; r++)
		for (int s = 0; s < rows; s++)
			B[r*stride + s] = E[r*rows + s] + E[s*rows + r] -
			                0.5*(G[r*rows + s] + G[s*rows + r]);
	free(product);
	return 0;
}

/* E of a plane: 1/omega^2 of its coordinates; `ties` [ends][ends], ends = 1 or 2, is T. */
static void set_inverse(double *E, const struct hawser__quartic *q, const struct hawser_modes *modes,
                        int plane, struct hawser__ties *ties)
{
	int first = plane ? q->in : 0, size = plane ? q->out : q->in;
	int rows = plane ? q->rows_out : q->rows_in;

	for (int i = 0; i < size; i++) {
		double omega = modes->mode[q->index[first + i]].omega;

		E[i*rows + i] = 1.0/(omega*omega);
	}
	for (int e = 0; e < (plane ? 1 : 2); e++) {
		memset(ties->z, 0, sizeof ties->z);
		ties->z[plane ? 2 : e] = 1.0;
		hawser__ties_solve(ties);
		if (plane)
			E[size*rows + size] = ties->z[2];
		for (int f = 0; !plane && f < 2; f++)
			E[(size + e)*rows + size + f] = ties->z[f];
	}
}

/* Zeros in place of the round-off in entries of rows of different kinds. */
static void separate(double *matrix, const struct hawser__quartic *q, int plane, int rows)
{
	for (int r = 0; r < rows; r++)
		for (int s = 0; s < rows; s++)
			if (hawser__quartic_kind(q, r, plane) != hawser__quartic_kind(q, s, plane))
				matrix[r*rows + s] = 0.0;
}

/* M by columns: in_plane [2 width] as in a row of q->ab, out_of_plane [width]. */
static void set_M(double *in_plane, double *out_of_plane, const struct hawser__quartic *q,
                  const struct hawser__place *place)
{
	for (int p = 0; p < q->width; p++) {
		double share;
		int point = point_of(&share, q, p);

		if (point < 0)
			continue;
		in_plane[HAWSER__QUARTIC_A(p, q->width)] = share*place[point].weight/place[point].eps;
		out_of_plane[p] = share*place[point].weight*place[point].k;
		in_plane[HAWSER__QUARTIC_B(p, q->width)] = out_of_plane[p];
	}
}

/* B of both planes. */
static int set_bend(struct hawser__quartic *q, const struct hawser_modes *modes,
                    const struct hawser__place *place, struct hawser__ties *ties)
{
	int width = q->width, most = q->rows_in > q->rows_out ? q->rows_in : q->rows_out;
	double *M = array(3, width), *E = array(most, most), *G = array(most, most);
	int failed = !M || !E || !G;

	if (!failed)
		set_M(M, M + 2*width, q, place);
	for (int plane = 0; !failed && plane < 2; plane++) {
		int rows = plane ? q->rows_out : q->rows_in;

		memset(E, 0, (size_t)most*(size_t)most*sizeof *E);
		set_inverse(E, q, modes, plane, ties);
		separate(E, q, plane, rows);
		failed = multiply(G, plane ? q->c : q->ab, plane ? M + 2*width : M, rows,
		                  plane ? width : 2*width);
		separate(G, q, plane, rows);
		if (!failed)
			failed = combine(plane ? q->bend_out : q->bend_in, G, E, rows,
			                 plane ? q->padded_out : q->padded_in);
	}
	free(M);
	free(E);
	free(G);
	return failed;
}

static void set_stiffness(struct hawser__quartic *q, const struct hawser_rom *rom)
{
	int n = q->n;

	q->diagonal = 1;
	for (int i = 0; i < n*n; i++)
		q->diagonal = q->diagonal && (i%(n + 1) == 0 || rom->K[i] == 0.0);
	if (!q->diagonal)
		memcpy(q->K, rom->K, (size_t)n*(size_t)n*sizeof *q->K);
	for (int j = 0; q->diagonal && j < n; j++)
		q->K[j] = rom->K[j*n + j];
}

static void fill_columns(struct hawser__quartic *q, const struct hawser_modes *modes,
                         const struct hawser__place *place)
{
	for (int p = 0; p < q->width; p++) {
		double share;
		int point = point_of(&share, q, p);

		if (point < 0)
			continue;
		set_point(q, hawser_statics_frame(&modes->statics, modes->grid.s[point]).strain, p,
		          &place[point], share);
		set_strains(q, modes, p, point);
		if (q->condensed)
			set_ends(q, p, &place[point]);
	}
	reflect(q, q->third, q->width/2, 1.0);
	reflect(q, q->square, q->width/2, 1.0);
	reflect(q, q->mixed, q->width/2, 1.0);
	for (int r = 0; r < q->rows_in; r++)
		reflect_row(q, r, 0);
	for (int r = 0; r < q->rows_out; r++)
		reflect_row(q, r, 1);
}

static int fill(struct hawser__quartic *q, const struct hawser_rom *rom,
                const struct hawser_modes *modes)
{
	struct hawser__stations stations;
	int failed = hawser__stations_make(&stations, modes, 0, NULL, 0, NULL) || set_order(q, modes);

	if (!failed)
		fill_columns(q, modes, stations.place);
	set_stiffness(q, rom);
	if (!failed && q->condensed)
		failed = set_bend(q, modes, stations.place, stations.ties) || hawser__quartic_pull(q);
	hawser__stations_clear(&stations);
	return failed;
}

enum hawser_status hawser__quartic_new(struct hawser__quartic **made, const struct hawser_rom *rom,
                                       const struct hawser_modes *modes,
                                       const struct hawser__condensed *condensed,
                                       struct hawser_report *report)
{
	struct hawser__quartic *q;

	*made = NULL;
	/* with springs the force of the condensed modes varies along the cable (ties.c); their strokes of
	 * absorbers, and cubic springs, are in the tensors only; with bending stiffness their answer is not
	 * that of points (bend.c) */
	if (modes->grid.points > HAWSER__QUARTIC_POINTS ||
	    hawser__has_cubic(&modes->statics) ||
	    (condensed && (hawser__has_springs(&modes->statics) || modes->statics.elastic ||
	                   modes->stroke || modes->statics.bending.EI > 0.0)))
		return HAWSER_OK;
	q = allocate(modes, condensed);
	if (!q || fill(q, rom, modes)) {
		hawser__quartic_free(q);
		return hawser__no_memory(report, "rom");
	}
	*made = q;
	return HAWSER_OK;
}
