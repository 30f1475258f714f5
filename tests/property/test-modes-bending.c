/* test-modes-bending.c - modes of cables with bending stiffness against closed forms of a straight
 * tensioned beam, and against finite elements of this file for a sagging, inclined, clamped stay.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <hawser/irvine.h>
#include <hawser/modes.h>
#include <lapacke.h>
#include <stdlib.h>

#include "tests/tap.h"

/* --- closed forms --- */

/* A straight cable: 1/g w'' is the tension's term and B = beta/g^2 the bending term of
 * omega^2 w = B w'''' - w''/g; w of the form sin qx, cos qx, sinh px, cosh px with p^2 = q^2 + 1/(g B)
 * and omega^2 = B q^2 p^2. */
struct beam {
	double g, B, l, kappa; /* kappa: scaled rotational stiffness of both ends */
};

static double other(const struct beam *t, double q)
{
	return sqrt(q*q + 1.0/(t->g*t->B));
}

/* Zero where q belongs to a clamped beam; all terms divided by cosh pl. */
static double clamped(const struct beam *t, double q)
{
	double p = other(t, q);

	return 2.0*p*q*(1.0/cosh(fmin(p*t->l, 700.0)) - cos(q*t->l)) +
	       (p*p - q*q)*sin(q*t->l)*tanh(p*t->l);
}

/* Zero where q belongs to a symmetric mode of a beam with rotational springs at both ends. */
static double sprung(const struct beam *t, double q)
{
	double p = other(t, q), c = cos(0.5*q*t->l);

	return (p*p + q*q)*t->B*t->g*t->g*c +
	       t->kappa*(q*sin(0.5*q*t->l) + p*tanh(0.5*p*t->l)*c);
}

static double root(const struct beam *t, double (*f)(const struct beam *, double), double a, double b)
{
	int up = f(t, b) > 0.0;

	for (int i = 0; i < 200; i++) {
		double c = 0.5*(a + b);

		if ((f(t, c) > 0.0) == up)
			b = c;
		else
			a = c;
	}
	return 0.5*(a + b);
}

/* A span at H = 1 MN whose ends are so far apart that xi = L sqrt(T/EI). */
static int straight(struct hawser_statics *st, struct beam *beam, double xi, double rotation)
{
	const struct hawser_span span = {.EA = 2.385e9, .rho = 61.7, .g = 1e-9, .d = 137.0, .h = 0.0};
	struct hawser_report report;

	if (hawser_statics_solve(st, &span, HAWSER_GIVEN_H, 1e6, HAWSER_BRANCH_TAUT, &report))
		return ok(0, "%s", report.message);
	st->bending.EI = 1e6*st->length0*st->length0/(xi*xi);
	st->bending.rotation[0] = st->bending.rotation[1] = rotation*st->bending.EI/st->span.d;
	*beam = (struct beam){.g = 1.0 + st->epsilon, .l = st->l};
	beam->B = st->bending.EI/(st->H*span.d*span.d)/(beam->g*beam->g);
	beam->kappa = rotation*st->bending.EI/span.d/(st->H*span.d);
	return 1;
}

static int solve(struct hawser_modes *modes, const struct hawser_statics *st, int n)
{
	struct hawser_report report;

	if (hawser_modes_solve(modes, st, &(struct hawser_modes_options){.n = n}, &report))
		return ok(0, "%s", report.message);
	return 1;
}

/* Frequencies and, for symmetric modes of a clamped beam, end moments, within the stated errors. */
static void check_straight(double xi, double rotation)
{
	struct hawser_statics st;
	struct hawser_modes modes;
	struct beam beam;

	if (!straight(&st, &beam, xi, rotation) || !solve(&modes, &st, 10))
		return;
	for (int k = 0; k < modes.n; k++) {
		const struct hawser_mode *mode = &modes.mode[k];
		int n = mode->number;
		double q = n*M_PI/beam.l, p, error, moment;

		if (mode->family == HAWSER_LONGITUDINAL || (isfinite(rotation) && rotation > 0.0 && n%2 == 0))
			continue;
		if (isinf(rotation))
			q = root(&beam, clamped, n*M_PI/beam.l, (n + 0.5)*M_PI/beam.l);
		else if (rotation > 0.0)
			q = root(&beam, sprung, n*M_PI/beam.l, (n + 0.999)*M_PI/beam.l);
		p = other(&beam, q);
		error = fabs(mode->omega/(sqrt(beam.B)*q*p) - 1.0);
		ok(error <= mode->residual + 1e-14 && mode->residual < 1e-10,
		   "xi %g, ends %g, mode %d: error %.1e <= estimate %.1e", xi, rotation, k, error,
		   mode->residual);
		if (rotation == 0.0 || n%2 == 0)
			continue;
		moment = st.bending.EI/(st.span.d*st.span.d)*(p*p + q*q)/beam.g/
		         fabs(1.0/cos(0.5*q*beam.l) - 1.0/cosh(fmin(0.5*p*beam.l, 700.0)));
		if (n > 1) /* the largest displacement is not at mid-span */
			continue;
		for (int end = 0; end < 2; end++) {
			error = fabs(fabs(mode->moment[end])/moment - 1.0);
			ok(error <= mode->moment_error && mode->moment_error < 1e-6,
			   "xi %g, ends %g, mode %d: moment %.10g N m/m, error %.1e <= %.1e", xi, rotation, k,
			   moment, error, mode->moment_error);
		}
	}
	hawser_modes_clear(&modes);
}

/* A sweep of the tension of a straight clamped cable, xi about 40 to 80. */
static void check_sweep(void)
{
	const struct hawser_span span = {.EA = 2.385e9, .rho = 61.7, .g = 1e-9, .d = 137.0, .h = 0.0};
	struct hawser_irvine_options options = {.sweep = HAWSER_GIVEN_H, .from = 8e5, .to = 2e5,
	                                        .points = 5, .n = 6,
	                                        .bending = {2.3e6, {INFINITY, INFINITY}}};
	struct hawser_irvine irvine;
	struct hawser_report report = {.message = ""};
	double worst = 0.0;

	if (!ok(!hawser_irvine_trace(&irvine, &span, &options, &report), "sweep of the tension %s",
	        report.message))
		return;
	for (int i = 0; i < irvine.stations; i++) {
		const struct hawser_statics *st = &irvine.station[i].statics;
		double g = 1.0 + st->epsilon, B = 2.3e6/(st->H*span.d*span.d)/(g*g);
		struct beam beam = {.g = g, .B = B, .l = st->l};

		for (int b = 0; b < irvine.branches; b++) {
			int n = irvine.branch[b].number;
			double q = root(&beam, clamped, n*M_PI/beam.l, (n + 0.5)*M_PI/beam.l);
			double got = irvine.omega[(size_t)i*(size_t)irvine.branches + (size_t)b]*
			             span.d*sqrt(span.rho/st->H);

			worst = fmax(worst, fabs(got/(sqrt(B)*q*other(&beam, q)) - 1.0));
		}
	}
	ok(irvine.stations >= 5 && worst < 1e-12, "%d stations, error %.1e", irvine.stations, worst);
	hawser_irvine_clear(&irvine);
}

/* All modes of a basis: the lowest ones are those of the solution, shapes orthonormal, and the first
 * longitudinal one of a nearly straight cable is that of a rod. */
static void check_basis(double EI, double A, double B)
{
	const struct hawser_span span = {.EA = 2.385e9, .rho = 61.7, .g = 0.17, .d = 137.0, .h = 43.0};
	double off = 0.0, stated = 0.0, gram = 0.0, rod = INFINITY;
	struct hawser_statics st;
	struct hawser_modes few, all;
	struct hawser_report report = {.message = ""};
	int row;

	if (hawser_statics_solve(&st, &span, HAWSER_GIVEN_H, 2.3e6, HAWSER_BRANCH_TAUT, &report)) {
		ok(0, "%s", report.message);
		return;
	}
	st.bending = (struct hawser_bending){EI, {A, B}};
	if (!ok(!hawser_modes_solve(&few, &st, &(struct hawser_modes_options){.n = 8}, &report) &&
	        !hawser_modes_basis(&all, &st, 50, 46, &report), "EI %g: basis %s", EI, report.message))
		return;
	for (int k = 0; k < few.n; k++) {
		off = fmax(off, fabs(all.mode[k].omega/few.mode[k].omega - 1.0) - all.mode[k].residual);
		stated = fmax(stated, all.mode[k].residual);
	}
	row = 3*all.grid.points;
	for (int j = 0; j < all.n; j += 7)
		for (int k = 0; k <= j; k += 5) {
			double sum = j == k ? -1.0 : 0.0;

			for (int p = 0; p < row; p++)
				sum += all.grid.weight[p/3]*all.shape[j*row + p]*all.shape[k*row + p];
			gram = fmax(gram, fabs(sum));
		}
	for (int k = 0; k < all.n; k++)
		if (all.mode[k].family == HAWSER_LONGITUDINAL)
			rod = fmin(rod, fabs(all.mode[k].omega*st.l*sqrt(st.epsilon)/M_PI - 1.0));
	ok(off <= 0.0 && stated < 1e-5, "EI %g: eight modes of a basis of %d, within the stated %.1e", EI,
	   all.n, stated);
	ok(gram < 1e-11 && rod < 1e-4, "shapes orthonormal to %.1e, longitudinal as of a rod to %.1e",
	   gram, rod);
	hawser_modes_clear(&few);
	hawser_modes_clear(&all);
}

/* --- finite elements --- */

/* Hermite cubics in each element for the displacement along two fixed axes (in the plane) or z.
 * Unknowns of a node: displacements, then their derivatives along e and n, or of z. Energy, from
 * doc/theory-modes.md and doc/theory-bending.md: a^2/eps + T/g (b^2 + c^2) + beta ((b/g)'^2 +
 * (c/g)'^2). */
enum { ELEMENTS = 72, GAUSS = 5 };

static const double gauss_x[GAUSS] = {-0.9061798459386640, -0.5384693101056831, 0.0,
	0.5384693101056831,
                                      0.9061798459386640};
static const double gauss_w[GAUSS] = {0.2369268850561891, 0.4786286704993665, 0.5688888888888889,
                                      0.4786286704993665, 0.2369268850561891};

/* Strains a, b (or c) and b' of one unknown at a point, and its displacements. */
struct effect {
	double a, b, turn, x[2];
};

/* H: value, first and second derivative of the four cubics, on an element of length h. */
static void hermite(double H[4][3], double t, double h)
{
	const double value[4] = {1 - 3*t*t + 2*t*t*t, h*t*(1 - t)*(1 - t), t*t*(3 - 2*t), h*t*t*(t - 1)};
	const double first[4] = {6*t*(t - 1)/h, 1 - 4*t + 3*t*t, 6*t*(1 - t)/h, t*(3*t - 2)};
	const double second[4] = {(12*t - 6)/(h*h), (6*t - 4)/h, (6 - 12*t)/(h*h), (6*t - 2)/h};

	for (int i = 0; i < 4; i++) {
		H[i][0] = value[i];
		H[i][1] = first[i];
		H[i][2] = second[i];
	}
}

static void effect_of(struct effect *to, const struct hawser_statics *st, const double H[3],
                      const double axis[2], double s, int D)
{
	struct hawser_frame_point at = hawser_statics_frame(st, s);
	double g = 1.0 + at.strain, T = hypot(1.0, at.u), rate = st->epsilon*at.u*st->delta/T;
	double e = at.ex*axis[0] + at.ey*axis[1], n = at.ex*axis[1] - at.ey*axis[0], b, slope;

	if (D == 1) {
		e = at.curvature = 0.0;
		n = 1.0;
	}
	b = H[1]*n;
	slope = H[2]*n - at.curvature*H[1]*e;
	*to = (struct effect){.a = H[1]*e, .b = b, .turn = slope/g - b*rate/(g*g),
	                      .x = {H[0]*axis[0], H[0]*axis[1]}};
}

/* Frequencies of one plane with `elements` elements; omega[count]. */
static int elements_solve(double *omega, int count, const struct hawser_statics *st, int D,
                          int elements)
{
	int size = 2*D*(elements + 1), free_size = 0, *at = malloc((size_t)size*sizeof *at);
	double *K = calloc((size_t)size*(size_t)size, sizeof *K), *M = calloc((size_t)size*(size_t)size,
	                                                                      sizeof *M);
	double *w = malloc((size_t)size*sizeof *w), beta = st->bending.EI/(st->H*st->span.d*st->span.d);
	int info;

	if (!at || !K || !M || !w)
		return 0;
	for (int i = 0; i < size; i++) {
		int node = i/(2*D), end = node == 0 || node == elements;
		int held = end && (i%(2*D) < D || (i%(2*D) == 2*D - 1 &&
		                                   isinf(st->bending.rotation[node > 0])));

		at[i] = held ? -1 : free_size++;
	}
	for (int e = 0; e < elements; e++) {
		/* graded towards both ends */
		double from = 0.5*st->l*(1.0 - cos(M_PI*e/elements));
		double to = 0.5*st->l*(1.0 - cos(M_PI*(e + 1)/elements));
		double h = to - from, H[4][3];

		for (int p = 0; p < GAUSS; p++) {
			double t = 0.5*(1.0 + gauss_x[p]), s = from + h*t, weight = 0.5*h*gauss_w[p];
			struct hawser_frame_point here = hawser_statics_frame(st, s);
			double k = hypot(1.0, here.u)/(1.0 + here.strain);
			struct effect f[8];

			hermite(H, t, h);
			for (int i = 0; i < 4*D; i++) {
				int node = i/(2*D), c = i%(2*D), slope = c >= D;
				struct hawser_frame_point end = hawser_statics_frame(st, node ? to : from);
				const double fixed[2][2] = {{1, 0}, {0, 1}}, local[2][2] = {{end.ex, end.ey},
					{-end.ey, end.ex}};

				effect_of(&f[i], st, H[2*node + slope], slope ? local[c - D] : fixed[c], s, D);
				if (D == 1)
					f[i].x[0] = H[2*node + slope][0], f[i].x[1] = 0.0;
			}
			for (int i = 0; i < 4*D; i++)
				for (int j = 0; j < 4*D; j++) {
					int row = at[2*D*e + i], column = at[2*D*e + j];

					if (row < 0 || column < 0)
						continue;
					K[row*free_size + column] += weight*(f[i].a*f[j].a/st->epsilon + k*f[i].b*f[j].b +
					                                     beta*f[i].turn*f[j].turn);
					M[row*free_size + column] += weight*(f[i].x[0]*f[j].x[0] + f[i].x[1]*f[j].x[1]);
				}
		}
	}
	for (int end = 0; end < 2; end++) {
		int last = at[end ? size - 1 : 2*D - 1];
		double g = 1.0 + hawser_statics_frame(st, end ? st->l : 0.0).strain;

		if (last >= 0)
			K[last*(free_size + 1)] += st->bending.rotation[end]/(st->H*st->span.d)/(g*g);
	}
	/* M x = omega^-2 K x: the lowest frequencies are the largest eigenvalues, which round-off spares
	 * */
	info = LAPACKE_dsygv(LAPACK_ROW_MAJOR, 1, 'N', 'U', free_size, M, free_size, K, free_size, w);
	for (int k = 0; k < count; k++)
		omega[k] = 1.0/sqrt(w[free_size - 1 - k]);
	free(at);
	free(K);
	free(M);
	free(w);
	return info == 0;
}

static void check_stay(double h, double weight, double T, double EI, double A, double B)
{
	const struct hawser_span span = {.EA = 1.57e9, .rho = 61.7, .g = weight/61.7, .d = 137.0, .h = h};
	struct hawser_report report;
	struct hawser_statics st;
	struct hawser_modes modes;
	double coarse[2][8], fine[2][8];

	if (hawser_statics_solve(&st, &span, HAWSER_GIVEN_T0, T, HAWSER_BRANCH_TAUT, &report)) {
		ok(0, "%s", report.message);
		return;
	}
	st.bending = (struct hawser_bending){EI, {A, B}};
	if (!solve(&modes, &st, 8))
		return;
	for (int q = 0; q < 2; q++)
		if (!elements_solve(coarse[q], 8, &st, q == 0 ? 2 : 1, ELEMENTS/2) ||
		    !elements_solve(fine[q], 8, &st, q == 0 ? 2 : 1, ELEMENTS))
			ok(0, "finite elements");
	for (int k = 0; k < modes.n; k++) {
		const struct hawser_mode *mode = &modes.mode[k];
		double fe = fine[mode->plane][mode->number - 1], rough = coarse[mode->plane][mode->number - 1];
		double error = fe/mode->omega - 1.0, before = rough/mode->omega - 1.0;

		ok(error > -1e-9 && error < 1e-5 && (error < 1e-8 || before > 8.0*error),
		   "stay h %g, EI %g: mode %d, %s: finite elements are %.1e above it, with half of them %.1e, "
		   "estimate %.1e", h, EI, k, hawser_plane_name(mode->plane), error, before, mode->residual);
	}
	hawser_modes_clear(&modes);
}

/* --- refusals --- */

static void check_refusals(void)
{
	struct hawser_modes_options options = {.n = 3, .method = "fdm"};
	struct hawser_report report;
	struct hawser_statics st;
	struct hawser_modes modes;
	struct beam beam;

	if (!straight(&st, &beam, 40.0, INFINITY))
		return;
	ok(hawser_modes_solve(&modes, &st, &options, &report) == HAWSER_ERR_ARGUMENT &&
	           strstr(report.message, "without bending stiffness"), "fdm refuses: %s", report.message);
	options = (struct hawser_modes_options){.n = 3, .basis = 20};
	ok(hawser_modes_solve(&modes, &st, &options, &report) == HAWSER_ERR_ARGUMENT &&
	           strstr(report.message, "leave model.basis out"), "a basis is refused: %s",
	           	report.message);
	st.elastic = 1;
	ok(hawser_modes_solve(&modes, &st, &options, &report) == HAWSER_ERR_ARGUMENT &&
	           strstr(report.message, "elastic supports of a cable with cable.EI"),
	   "elastic supports are refused: %s", report.message);
	st.elastic = 0;
}

CASE(property_modes_bending)
{
	const double xi[] = {5.0, 17.3, 61.0, 238.5, 1000.0};

	for (size_t i = 0; i < sizeof xi/sizeof *xi; i++) {
		check_straight(xi[i], 0.0);
		check_straight(xi[i], INFINITY);
		check_straight(xi[i], 7.3);
	}
	check_stay(61.7, 605.0, 4e6, 2.385e6, INFINITY, INFINITY);
	check_stay(-43.0, 2605.0, 9e5, 3.1e7, INFINITY, 0.0);
	check_stay(0.0, 1605.0, 9e5, 3.1e6, 4e6, INFINITY);
	check_sweep();
	check_basis(2.3e6, INFINITY, 0.0);
	check_basis(4.1e4, 6e5, INFINITY);
	check_refusals();
	return done_testing();
}
