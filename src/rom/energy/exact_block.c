/* rom/energy/exact_block.c - forces and tangents of the exact energy at many states at once.
 *
 * A tangent is linear in the stiffness of the points of the grid (exact.c). With the products of
 * slopes tabulated, the tangents of all states of a batch are one matrix product per block, which
 * runs at the peak speed of the processor,
 *
 *    [states][3 points] [3 points][in(in+1)/2],   [states][2 points] [2 points][in out],   ...
 *
 * while state by state it would be a product of a matrix and a vector. The block between the planes
 * is zero if all states of a batch are in the plane, and is then skipped.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <string.h>

#include "rom/energy/exact.h"

/* States per batch: the tables are read once for so many; chosen. */
enum { BATCH = 32 };

/* Parts of the caller's workspace, for up to BATCH states. */
struct batch {
	double *in, *out;       /* coordinates, then forces: [count][in], [count][out] */
	double *ab, *c;         /* strains, then stresses: [count][points][2], [count][points] */
	double *ii, *io, *oo;   /* stiffness of the points: [count][points][3], [2], [1] */
	double *tii, *tio, *too; /* tangents: [count][in(in+1)/2], [in*out], [out(out+1)/2] */
};

static size_t pairs(int n)
{
	return (size_t)n*((size_t)n + 1)/2;
}

/* Divides `work` for `count` states; returns the size. */
static size_t lay_out(struct batch *b, const struct hawser_rom_exact *exact, size_t count,
                      double *work)
{
	size_t in = (size_t)exact->in, out = (size_t)exact->out, points = (size_t)exact->points;
	const size_t size[] = {in, out, 2*points, points, 3*points, 2*points, points, pairs(exact->in),
	                       in*out, pairs(exact->out)};
	double **part[] = {&b->in, &b->out, &b->ab, &b->c, &b->ii, &b->io, &b->oo, &b->tii, &b->tio,
	                   &b->too};
	size_t at = 0;

	for (size_t i = 0; i < sizeof size/sizeof *size; i++) {
		if (work)
			*part[i] = work + at;
		at += count*size[i];
	}
	return at;
}

size_t hawser__exact_work(const struct hawser_rom_exact *exact, int count)
{
	struct batch none;

	return lay_out(&none, exact, (size_t)(count < BATCH ? count : BATCH), NULL);
}

/* C [m][n] = A [m][k] times B [k][n], or B [n][k] transposed. */
static void product(double *C, const double *A, const double *B, int m, int n, int k, int transposed)
{
	if (m && n && k)
		cblas_dgemm(CblasRowMajor, CblasNoTrans, transposed ? CblasTrans : CblasNoTrans, m, n,
		            k, 1.0, A, k, B, transposed ? k : n, 0.0, C, n);
}

/* Strains become stresses times the quadrature weight. Returns whether any state is out of the
 * plane. */
static int stresses(struct batch *b, const struct hawser_rom_exact *exact, int count)
{
	int out_of_plane = 0, points = exact->points;

	for (int i = 0; i < count; i++)
		for (int p = 0; p < points; p++) {
			size_t at = (size_t)i*points + p;
			double weight = exact->weight[p], c = exact->out ? b->c[at] : 0.0;
			struct hawser__stress s = hawser__exact_stress(exact, p, b->ab[2*at],
			                                               b->ab[2*at + 1], c);

			out_of_plane |= c != 0.0;
			b->ab[2*at] = weight*s.a;
			b->ab[2*at + 1] = weight*s.b;
			b->c[at] = weight*s.c;
			b->ii[3*at] = weight*s.aa;
			b->ii[3*at + 1] = weight*s.ab;
			b->ii[3*at + 2] = weight*s.bb;
			b->io[2*at] = weight*s.ac;
			b->io[2*at + 1] = weight*s.bc;
			b->oo[at] = weight*s.cc;
		}
	return out_of_plane;
}

/* Copy row i of the packed tangents in the order of the model. */
static void unpack(double *tangent, const struct hawser_rom_exact *exact, const struct batch *b, int i,
                   int out_of_plane)
{
	int n = exact->n, in = exact->in, out = exact->out;
	const int *index = exact->index, *z = index + in;
	const double *ii = b->tii + (size_t)i*pairs(in), *oo = b->too + (size_t)i*pairs(out);
	const double *io = b->tio + (size_t)i*in*out;

	if (in + out > n) { /* in space */
		for (int k = 0; k < n; k++)
			for (int j = 0; j <= k; j++)
				tangent[index[j]*n + index[k]] = tangent[index[k]*n + index[j]] = *ii++ + *oo++ +
					(out_of_plane ? io[j*n + k] + io[k*n + j] : 0.0);
		return;
	}
	for (int k = 0; k < in; k++)
		for (int j = 0; j <= k; j++)
			tangent[index[j]*n + index[k]] = tangent[index[k]*n + index[j]] = *ii++;
	for (int k = 0; k < out; k++)
		for (int j = 0; j <= k; j++)
			tangent[z[j]*n + z[k]] = tangent[z[k]*n + z[j]] = *oo++;
	for (int j = 0; j < in; j++)
		for (int k = 0; k < out; k++)
			tangent[index[j]*n + z[k]] = tangent[z[k]*n + index[j]] =
				out_of_plane ? io[j*out + k] : 0.0;
}

static void batch(struct batch *b, const struct hawser_rom_exact *exact, double *restoring,
                  double *tangent, const double *u, int count)
{
	int n = exact->n, in = exact->in, out = exact->out, points = exact->points, out_of_plane;

	for (int i = 0; i < count; i++)
		for (int j = 0; j < n; j++)
			*(j < in ? b->in + i*in + j : b->out + i*out + j - in) =
				u[i*n + exact->index[j]];
	if (in + out > n) /* in space */
		memcpy(b->out, b->in, (size_t)count*(size_t)n*sizeof *b->out);
	if (!in)
		memset(b->ab, 0, (size_t)count*2*points*sizeof *b->ab);
	product(b->ab, b->in, exact->slope, count, 2*points, in, 1);
	product(b->c, b->out, exact->slope_z, count, points, out, 1);
	out_of_plane = stresses(b, exact, count);
	product(b->in, b->ab, exact->slope, count, in, 2*points, 0);
	product(b->out, b->c, exact->slope_z, count, out, points, 0);
	for (int i = 0; i < count; i++)
		for (int j = 0; j < n; j++)
			restoring[i*n + exact->index[j]] = (j < in ? b->in[i*in + j] : 0.0) +
			                                   (j < exact->other ? 0.0
			                                    : b->out[i*out + j - exact->other]);
	if (!tangent)
		return;
	product(b->tii, b->ii, exact->pairs_in, count, (int)pairs(in), 3*points, 0);
	product(b->too, b->oo, exact->pairs_out, count, (int)pairs(out), points, 0);
	if (out_of_plane)
		product(b->tio, b->io, exact->mixed, count, in*out, 2*points, 0);
	for (int i = 0; i < count; i++)
		unpack(tangent + (size_t)i*n*n, exact, b, i, out_of_plane);
}

void hawser__exact_tangents(const struct hawser_rom_exact *exact, double *restoring, double *tangent,
                            const double *u, int count, double *work)
{
	size_t n = (size_t)exact->n;

	for (int first = 0; first < count; first += BATCH) {
		int size = count - first < BATCH ? count - first : BATCH;
		struct batch b;

		lay_out(&b, exact, (size_t)size, work);
		batch(&b, exact, restoring + (size_t)first*n,
		      tangent ? tangent + (size_t)first*n*n : NULL, u + (size_t)first*n, size);
		for (size_t i = (size_t)first; exact->springs && i < (size_t)(first + size); i++)
			hawser__exact_springs(exact, restoring + i*n, tangent ? tangent + i*n*n : NULL,
			                      u + i*n);
	}
}
