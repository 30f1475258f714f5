/* rom/energy/exact.c - restoring force, tangent and energy from the strain energy without expansion.
 *
 *    g, eps       static stretch, H/EA;  a, b, c  derivative of the displacement in the local frame
 *    r            |q'|, r^2 = (g + a)^2 + b^2 + c^2
 *    e            r - g, the strain that the motion adds;  t = e - a, the part of it due to rotation
 *    (x, y, z)    direction of q', (g + a, b, c)/r
 *
 * The energy per unstretched length is (r - 1)^2/(2 eps), minus its value at rest, minus the part
 * that is linear in a and balances the weight:
 *
 *    V  = [e^2/2 + (g - 1) t]/eps
 *    dV = ([e (g + a) - (g - 1) t], [(g - 1) + e] b, [(g - 1) + e] c)/(r eps)
 *    ddV = [(r - 1)/r I + (x, y, z)(x, y, z)'/r]/eps
 *
 * with t = (b^2 + c^2)/(r + g + a), e = a + t and g - 1 = eps sqrt(1 + u^2) from the statics. In
 * this form no large numbers are subtracted, the energy at rest is exactly zero, and it is valid
 * for arbitrary displacements, also in compression (r < 1).
 *
 * Integrals are sums over Gauss points. A full-order model (full.c) uses as many points in an
 * element as its strains have polynomials, p. Its quadratic energy is then still integrated exactly
 * (degree 2p - 2 of at most 2p - 1). More points would be wrong: t has twice the degree of the
 * strains, and a can cancel only the part of it below degree p. The rest would be a stretch with
 * the stiffness 1/eps in any motion (membrane locking). With p points, the basis can make the
 * strain e zero at every point: selective integration by collocation of the strain (D. Malkus, T.
 * Hughes, Comput. Methods Appl. Mech. Eng. 15 (1978) 63).
 *
 * Points are processed CHUNK at a time, so that the workspace fits on the stack and several threads
 * may use one model.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <math.h>
#include <string.h>

#include "rom/terms/absorbers.h"
#include "rom/energy/exact.h"
#include "rom/energy/kernel.h"

enum { CHUNK = 48 };

/* If q' has turned back (g + a < 0), r - (g + a) is a sum without cancellation. */
static inline double turning(double along, double r, double sigma)
{
	return along > 0.0 ? sigma/(r + along) : r - along;
}

struct hawser__stress hawser__exact_stress(const struct hawser_rom_exact *exact, int p, double a,
                                           double b, double c)
{
	double strain = exact->strain[p], along = 1.0 + strain + a, sigma = b*b + c*c;
	double r = sqrt(along*along + sigma), t = turning(along, r, sigma), e = a + t;
	double inverse = 1.0/r, k = (strain + e)*inverse, x = along*inverse, y = b*inverse;
	double z = c*inverse;

	return (struct hawser__stress){
		.a = e*x - strain*t*inverse, .b = k*b, .c = k*c,
		.aa = k + x*x*inverse, .ab = x*y*inverse, .bb = k + y*y*inverse,
		.ac = x*z*inverse, .bc = y*z*inverse, .cc = k + z*z*inverse,
	};
}

/* The coordinates of the two planes behind one another. */
static void gather(double *v, const struct hawser_rom_exact *exact, const double *u)
{
	for (int i = 0; i < exact->n; i++)
		v[i] = u[exact->index[i]];
}

/* a, b [count][2] and c [count] at the points from `first` on. */
static void strains(double *ab, double *c, const struct hawser_rom_exact *exact, const double *v,
                    int first, int count)
{
	int in = exact->in, out = exact->out;

	memset(ab, 0, 2*(size_t)count*sizeof *ab);
	memset(c, 0, (size_t)count*sizeof *c);
	if (in)
		cblas_dgemv(CblasRowMajor, CblasNoTrans, 2*count, in, 1.0,
		            exact->slope + (size_t)first*2*in, in, v, 1, 0.0, ab, 1);
	if (out)
		cblas_dgemv(CblasRowMajor, CblasNoTrans, count, out, 1.0,
		            exact->slope_z + (size_t)first*out, out, v + exact->other, 1, 0.0, c, 1);
}

/* Add the forces of the stresses ab [count][2] and c [count] on the coordinates. */
static void add_force(double *f, const struct hawser_rom_exact *exact, const double *ab,
                      const double *c, int first, int count)
{
	int in = exact->in, out = exact->out;

	if (in)
		cblas_dgemv(CblasRowMajor, CblasTrans, 2*count, in, 1.0,
		            exact->slope + (size_t)first*2*in, in, ab, 1, 1.0, f, 1);
	if (out)
		cblas_dgemv(CblasRowMajor, CblasTrans, count, out, 1.0,
		            exact->slope_z + (size_t)first*out, out, c, 1, 1.0, f + exact->other, 1);
}

/* Workspace for one chunk of points. */
struct chunk {
	double ab[2*CHUNK], c[CHUNK];
	struct hawser__stress stress[CHUNK]; /* times the weight */
	double W[2*CHUNK*HAWSER_ROM_MAX];    /* stiffness times slopes */
};

/* Tangents of the planes and between them: [in][in], [in][out], [out][out], in the exact order. */
struct blocks {
	double ii[HAWSER_ROM_MAX*HAWSER_ROM_MAX];
	double io[HAWSER_ROM_MAX*HAWSER_ROM_MAX]; /* a quarter of it but in space */
	double oo[HAWSER_ROM_MAX*HAWSER_ROM_MAX];
};

static void weigh(struct chunk *w, const struct hawser_rom_exact *exact, int first, int count)
{
	for (int p = 0; p < count; p++) {
		struct hawser__stress s = hawser__exact_stress(exact, first + p, w->ab[2*p],
		                                               w->ab[2*p + 1], w->c[p]);
		double weight = exact->weight[first + p];

		w->stress[p] = (struct hawser__stress){
			weight*s.a, weight*s.b, weight*s.c, weight*s.aa, weight*s.ab, weight*s.bb,
			weight*s.ac, weight*s.bc, weight*s.cc,
		};
	}
	for (int p = 0; p < count; p++) {
		w->ab[2*p] = w->stress[p].a;
		w->ab[2*p + 1] = w->stress[p].b;
		w->c[p] = w->stress[p].c;
	}
}

static void add_in_plane(struct blocks *t, struct chunk *w, const struct hawser_rom_exact *exact,
                         int first, int count)
{
	int in = exact->in;
	const double *slope = exact->slope + (size_t)first*2*in;

	for (int p = 0; p < count; p++) {
		const double *a = slope + (size_t)p*2*in, *b = a + in;
		double *wa = w->W + (size_t)p*2*in, *wb = wa + in;
		double aa = w->stress[p].aa, ab = w->stress[p].ab, bb = w->stress[p].bb;

		for (int j = 0; j < in; j++) {
			wa[j] = aa*a[j] + ab*b[j];
			wb[j] = ab*a[j] + bb*b[j];
		}
	}
	cblas_dgemm(CblasRowMajor, CblasTrans, CblasNoTrans, in, in, 2*count, 1.0, slope, in, w->W, in,
	            1.0, t->ii, in);
}

/* c is coupled to a and b only if the state is not in the plane. */
static void add_out_of_plane(struct blocks *t, struct chunk *w,
                             const struct hawser_rom_exact *exact, int first, int count)
{
	int in = exact->in, out = exact->out, moved = 0;
	const double *slope_z = exact->slope_z + (size_t)first*out;

	for (int p = 0; p < count; p++) {
		const double *c = slope_z + (size_t)p*out;
		double cc = w->stress[p].cc;

		moved |= w->stress[p].ac != 0.0 || w->stress[p].bc != 0.0;
		for (int j = 0; j < out; j++)
			w->W[(size_t)p*out + j] = cc*c[j];
	}
	cblas_dgemm(CblasRowMajor, CblasTrans, CblasNoTrans, out, out, count, 1.0, slope_z, out, w->W,
	            out, 1.0, t->oo, out);
	if (!moved || !in)
		return;
	for (int p = 0; p < count; p++) {
		const double *c = slope_z + (size_t)p*out;
		double *wa = w->W + (size_t)p*2*out, *wb = wa + out;

		for (int j = 0; j < out; j++) {
			wa[j] = w->stress[p].ac*c[j];
			wb[j] = w->stress[p].bc*c[j];
		}
	}
	cblas_dgemm(CblasRowMajor, CblasTrans, CblasNoTrans, in, out, 2*count, 1.0,
	            exact->slope + (size_t)first*2*in, in, w->W, out, 1.0, t->io, out);
}

/* Copy the blocks in the order of the model. The mean of a product and its transpose is taken,
 * which differ by round-off, so that the tangent is exactly symmetric. */
static void scatter(double *tangent, const struct hawser_rom_exact *exact, const struct blocks *t)
{
	int n = exact->n, in = exact->in, out = exact->out;
	const int *index = exact->index, *z = index + in;

	for (int j = 0; in + out > n && j < n; j++)
		for (int k = 0; k < n; k++)
			tangent[index[j]*n + index[k]] = 0.5*(t->ii[j*n + k] + t->ii[k*n + j] + t->oo[j*n + k] +
			                                      t->oo[k*n + j]) + t->io[j*n + k] + t->io[k*n + j];
	if (in + out > n)
		return;
	for (int j = 0; j < in; j++)
		for (int k = 0; k < in; k++)
			tangent[index[j]*n + index[k]] = 0.5*(t->ii[j*in + k] + t->ii[k*in + j]);
	for (int j = 0; j < out; j++)
		for (int k = 0; k < out; k++)
			tangent[z[j]*n + z[k]] = 0.5*(t->oo[j*out + k] + t->oo[k*out + j]);
	for (int j = 0; j < in; j++)
		for (int k = 0; k < out; k++)
			tangent[index[j]*n + z[k]] = tangent[z[k]*n + index[j]] = t->io[j*out + k];
}

/* Add the strains of the displaced supports. */
static void displace(double *ab, double *c, const struct hawser_rom_exact *exact, const double *s,
                     int first, int count)
{
	for (int i = 0; s && i < exact->supports; i++)
		for (int p = 0; p < count; p++) {
			const double *x = exact->support +
			                  3*((size_t)i*(size_t)exact->points + (size_t)(first + p));

			ab[2*p] += s[i]*x[0];
			ab[2*p + 1] += s[i]*x[1];
			c[p] += s[i]*x[2];
		}
}

static void force(const struct hawser_rom_exact *exact, double *restoring, const double *u,
                  const double *s, struct blocks *t)
{
	double v[HAWSER_ROM_MAX], f[HAWSER_ROM_MAX] = {0.0};
	struct chunk w;

	gather(v, exact, u);
	for (int first = 0; first < exact->points; first += CHUNK) {
		int left = exact->points - first, count = left < CHUNK ? left : CHUNK;

		strains(w.ab, w.c, exact, v, first, count);
		displace(w.ab, w.c, exact, s, first, count);
		weigh(&w, exact, first, count);
		add_force(f, exact, w.ab, w.c, first, count);
		if (t && exact->in)
			add_in_plane(t, &w, exact, first, count);
		if (t && exact->out)
			add_out_of_plane(t, &w, exact, first, count);
	}
	for (int i = 0; i < exact->n; i++)
		restoring[exact->index[i]] = f[i];
}

void hawser__exact_springs(const struct hawser_rom_exact *exact, double *restoring, double *tangent,
                           const double *u)
{
	int n = exact->n;

	if (exact->springs)
		cblas_dgemv(CblasRowMajor, CblasNoTrans, n, n, 1.0, exact->springs, n, u, 1, 1.0, restoring,
		            1);
	if (exact->springs && tangent)
		cblas_daxpy(n*n, 1.0, exact->springs, 1, tangent, 1);
	hawser__cubics_add(restoring, tangent, u, n, exact->cubic, exact->stroke, exact->cubics);
}

void hawser__exact_tangent(const struct hawser_rom_exact *exact, double *restoring, double *tangent,
                           const double *u)
{
	hawser__exact_moved(exact, restoring, tangent, u, NULL);
}

void hawser__exact_moved(const struct hawser_rom_exact *exact, double *restoring, double *tangent,
                         const double *u, const double *s)
{
	struct blocks t;

	if (!tangent) {
		force(exact, restoring, u, s, NULL);
		hawser__exact_springs(exact, restoring, NULL, u);
		return;
	}
	memset(t.ii, 0, (size_t)exact->in*exact->in*sizeof *t.ii);
	memset(t.io, 0, (size_t)exact->in*exact->out*sizeof *t.io);
	memset(t.oo, 0, (size_t)exact->out*exact->out*sizeof *t.oo);
	force(exact, restoring, u, s, &t);
	scatter(tangent, exact, &t);
	hawser__exact_springs(exact, restoring, tangent, u);
}

void hawser__exact_strain(const struct hawser_rom_exact *exact, double *strain, const double *u,
                          const double *s)
{
	double v[HAWSER_ROM_MAX], ab[2*CHUNK], c[CHUNK];

	gather(v, exact, u);
	for (int first = 0; first < exact->points; first += CHUNK) {
		int left = exact->points - first, count = left < CHUNK ? left : CHUNK;

		strains(ab, c, exact, v, first, count);
		displace(ab, c, exact, s, first, count);
		for (int p = 0; p < count; p++) {
			double along = 1.0 + exact->strain[first + p] + ab[2*p];
			double sigma = ab[2*p + 1]*ab[2*p + 1] + c[p]*c[p];
			double r = sqrt(along*along + sigma);

			strain[first + p] = exact->strain[first + p] + ab[2*p] +
			                    turning(along, r, sigma);
		}
	}
}

double hawser__exact_potential(const struct hawser_rom_exact *exact, const double *u)
{
	double v[HAWSER_ROM_MAX], ab[2*CHUNK], c[CHUNK], sum = 0.0;

	gather(v, exact, u);
	for (int first = 0; first < exact->points; first += CHUNK) {
		int left = exact->points - first, count = left < CHUNK ? left : CHUNK;

		strains(ab, c, exact, v, first, count);
		for (int p = 0; p < count; p++) {
			double strain = exact->strain[first + p], along = 1.0 + strain + ab[2*p];
			double sigma = ab[2*p + 1]*ab[2*p + 1] + c[p]*c[p];
			double r = sqrt(along*along + sigma), t = turning(along, r, sigma);
			double e = ab[2*p] + t;

			sum += exact->weight[first + p]*(0.5*e*e + strain*t);
		}
	}
	for (int j = 0; exact->springs && j < exact->n; j++)
		for (int k = 0; k < exact->n; k++)
			sum += 0.5*exact->springs[j*exact->n + k]*u[j]*u[k];
	return sum + hawser__cubics_energy(u, exact->n, exact->cubic, exact->stroke, exact->cubics);
}
