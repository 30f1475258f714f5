/* Rotations and the element of rods: series and closed forms, forces as the gradient of the energy,
 * tangent as that of the forces, rigid turns. SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "rod/mesh.h"
#include "rod/so3.h"
#include "tests/tap.h"

static unsigned long seed = 2385;

static double number(void) /* -1 to 1 */
{
	seed = (seed*1103515245UL + 12345UL) & 0x7fffffffUL;
	return 2.0*(double)seed/0x7fffffff - 1.0;
}

static void vector(double v[3], double size)
{
	double length;

	for (int i = 0; i < 3; i++)
		v[i] = number();
	length = sqrt(hawser__dot(v, v));
	for (int i = 0; i < 3; i++)
		v[i] *= size/length;
}

static double difference(const double *a, const double *b, int count)
{
	double most = 0.0;

	for (int i = 0; i < count; i++)
		most = fmax(most, fabs(a[i] - b[i]));
	return most;
}

/* --- rotations --- */

static void logarithms(void)
{
	static const double size[] = {0.0, 1e-300, 1e-9, 1e-4, 0.3, 1.0, 3.14, 3.15, 5.0, 6.28};
	double worst = 0.0, matrix = 0.0;

	for (size_t k = 0; k < sizeof size/sizeof *size; k++)
		for (int c = 0; c < 20; c++) {
			double v[3], back[3], q[4], R[9], p[4], S[9];

			vector(v, size[k]);
			hawser__quaternion_exp(q, v);
			hawser__quaternion_log(back, q);
			worst = fmax(worst, difference(v, back, 3)/fmax(size[k], 1e-290));
			hawser__quaternion_matrix(R, q);
			hawser__quaternion_of(p, R);
			hawser__quaternion_matrix(S, p);
			matrix = fmax(matrix, difference(R, S, 9));
		}
	ok(worst < 2e-13, "log exp v = v up to |v| = 2 pi: relative error %.1e", worst);
	ok(matrix < 2e-15, "quaternion of a matrix: %.1e", matrix);
}

/* Jr by differences of fourth order of exp; Ji as its inverse; both sides of the change from series to
 * closed forms. */
static void jacobians(void)
{
	static const double size[] = {1e-8, 0.01, 0.999999, 1.000001, 2.385, 3.1};
	static const double weight[4] = {1.0/12.0, -2.0/3.0, 2.0/3.0, -1.0/12.0};
	static const int place[4] = {-2, -1, 1, 2};
	double worst = 0.0, inverse = 0.0, change = 0.0;

	for (size_t k = 0; k < sizeof size/sizeof *size; k++) {
		struct hawser__so3 at;
		double v[3], q[4], J[9], Ji[9], product[9];

		vector(v, size[k]);
		hawser__quaternion_exp(q, v);
		hawser__so3_at(&at, v);
		hawser__so3_jr(J, &at);
		hawser__so3_ji(Ji, &at);
		hawser__mul(product, J, Ji);
		for (int i = 0; i < 9; i++)
			inverse = fmax(inverse, fabs(product[i] - (i % 4 == 0)));
		for (int j = 0; j < 3; j++) {
			double column[3] = {0.0};

			for (int m = 0; m < 4; m++) {
				double moved[3] = {v[0], v[1], v[2]}, to[4], between[4], turn[3];

				moved[j] += 1e-3*place[m];
				hawser__quaternion_exp(to, moved);
				hawser__quaternion_between(between, q, to);
				hawser__quaternion_log(turn, between);
				for (int i = 0; i < 3; i++)
					column[i] += weight[m]*turn[i]/1e-3;
			}
			for (int i = 0; i < 3; i++)
				worst = fmax(worst, fabs(column[i] - J[3*i + j]));
		}
	}
	ok(worst < 1e-11, "Jr against differences of exp: %.1e", worst);
	ok(inverse < 5e-15, "Jr Ji = 1: %.1e", inverse);
	for (int c = 0; c < 100; c++) {
		struct hawser__so3 below, above;
		double v[3], w[3];

		vector(v, 1.0);
		for (int i = 0; i < 3; i++)
			w[i] = v[i]*(1.0 + 4e-15);
		for (int i = 0; i < 3; i++)
			v[i] *= 1.0 - 4e-15;
		hawser__so3_at(&below, v);
		hawser__so3_at(&above, w);
		change = fmax(change, fmax(difference(&below.a, &above.a, 3)/below.c,
		                           difference(&below.da, &above.da, 3)/below.dc));
	}
	ok(change < 2e-12, "series and closed forms at |v| = 1 differ by %.1e of the least one", change);
}

/* --- the element --- */

static void make(struct hawser__rod_element *el, struct hawser__rod_node node[2], double turn)
{
	static const double frame[3] = {2.0, 1.0, -0.3};

	el->h = 0.3 + 0.2*number();
	for (int i = 0; i < 3; i++) {
		el->EA[i] = 2.0 + number();
		el->EI[i] = 2.0 + number();
		el->w0[i] = (i == 0) + 0.1*number();
		el->k0[i] = number();
	}
	for (int n = 0; n < 2; n++) {
		double v[3];

		node[n] = (struct hawser__rod_node){.q = {1.0}};
		for (int i = 0; i < 3; i++)
			node[n].x[i] = 0.4*number();
		vector(v, n ? 0.7*turn : -0.3*turn);
		hawser__quaternion_turn(node[n].q, frame);
		hawser__quaternion_turn(node[n].q, v);
	}
}

static void move(struct hawser__rod_node node[2], int i, double by)
{
	double v[3] = {0.0};

	if (i % 6 < 3) {
		node[i/6].x[i % 6] += by;
	} else {
		v[i % 6 - 3] = by;
		hawser__quaternion_turn(node[i/6].q, v);
	}
}

static void gradients(void)
{
	static const double turn[] = {1e-7, 0.01, 0.5, 1.4, 2.9};
	static const double weight[4] = {1.0/12.0, -2.0/3.0, 2.0/3.0, -1.0/12.0};
	static const int place[4] = {-2, -1, 1, 2};
	double forces = 0.0, tangent = 0.0;

	for (int c = 0; c < 100; c++) {
		struct hawser__rod_element el;
		struct hawser__rod_node node[2];
		struct hawser__rod_strain at;
		double f[12], K[144];

		make(&el, node, turn[c % 5]);
		if (hawser__rod_strain(&at, &el, node))
			continue;
		hawser__rod_forces(f, K, &el, &at);
		for (int j = 0; j < 12; j++) {
			double energy = 0.0, column[12] = {0.0};

			for (int m = 0; m < 4; m++) {
				struct hawser__rod_node moved[2] = {node[0], node[1]};
				struct hawser__rod_strain other;
				double g[12];

				move(moved, j, 1e-3*place[m]);
				(void)hawser__rod_strain(&other, &el, moved);
				hawser__rod_forces(g, NULL, &el, &other);
				energy += weight[m]*hawser__rod_energy(&el, &other)/1e-3;
				for (int i = 0; i < 12; i++)
					column[i] += weight[m]*g[i]/1e-3;
			}
			forces = fmax(forces, fabs(energy - f[j]));
			for (int i = 0; i < 12; i++)
				tangent = fmax(tangent, fabs(column[i] - K[12*i + j]));
		}
	}
	ok(forces < 1e-9, "forces against differences of the energy: %.1e", forces);
	ok(tangent < 1e-9, "tangent against differences of the forces: %.1e", tangent);
}

/* A rigid turn by any angle, in one step or in many, leaves strains and the section's moments. */
static void rigid(void)
{
	double worst = 0.0;
	int far = 0;

	for (int c = 0; c < 50; c++) {
		struct hawser__rod_element el;
		struct hawser__rod_node node[2];
		struct hawser__rod_strain at, other;
		double v[3], q[4], R[9];
		int times = c % 2 ? 1 : 90; /* 22.5 pi by quarters of pi */

		make(&el, node, 0.05 + 0.05*c);
		(void)hawser__rod_strain(&at, &el, node);
		vector(v, c % 2 ? 0.8*c : 0.25*acos(-1.0));
		hawser__quaternion_exp(q, v);
		hawser__quaternion_matrix(R, q);
		for (int i = 0; i < times; i++)
			for (int n = 0; n < 2; n++) {
				double x[3], p[4];

				hawser__apply(x, R, node[n].x);
				hawser__quaternion_mul(p, q, node[n].q);
				memcpy(node[n].x, x, sizeof x);
				memcpy(node[n].q, p, sizeof p);
			}
		far += hawser__rod_strain(&other, &el, node);
		worst = fmax(worst, fmax(difference(at.w, other.w, 3), difference(at.k, other.k, 3)));
	}
	ok(far == 0, "no element turns by pi because the whole does");
	ok(worst < 3e-13, "rigid turns change w and k by %.1e", worst);
}

/* Curvature in the middle of two rotation vectors that are interpolated, D 2 to 4. */
static double curvature(const double q[4], const double p[4])
{
	double a[3], b[3], middle[3], J[9], K[3];
	struct hawser__so3 at;

	hawser__quaternion_log(a, q);
	hawser__quaternion_log(b, p);
	for (int i = 0; i < 3; i++) {
		middle[i] = 0.5*(a[i] + b[i]);
		b[i] -= a[i];
	}
	hawser__so3_at(&at, middle);
	hawser__so3_jr(J, &at);
	hawser__apply(K, J, b);
	return sqrt(hawser__dot(K, K));
}

/* What the errata say of D's interpolation: a rigid turn of 1.5 rad changes its curvature. That of
 * the element, log(q^-1 p), stays. */
static void interpolated(void)
{
	static const double apart[] = {1.8, 0.054}, least[] = {0.05, 1e-5}, most[] = {0.07, 1e-4};

	for (int k = 0; k < 2; k++) {
		double worst = 0.0, own = 0.0;

		for (int c = 0; c < 200; c++) {
			double v[3], w[3], start[3], back[3], turn[4], q[4], p[4], a[4], b[4];

			vector(start, 1.6);
			vector(v, apart[k]);
			vector(w, 1.5);
			hawser__quaternion_exp(q, start);
			hawser__quaternion_exp(a, v);
			hawser__quaternion_mul(p, q, a);
			hawser__quaternion_exp(turn, w);
			hawser__quaternion_mul(a, turn, q);
			hawser__quaternion_mul(b, turn, p);
			worst = fmax(worst, fabs(curvature(a, b)/curvature(q, p) - 1.0));
			hawser__quaternion_between(turn, a, b);
			hawser__quaternion_log(back, turn);
			own = fmax(own, difference(back, v, 3));
		}
		ok(worst > least[k] && worst < most[k] && own < 1e-14, "nodes %g rad apart: a rigid turn "
		   "changes an interpolated rotation's curvature by up to %.2g, the element's by %.1e",
		   apart[k], worst, own);
	}
}

/* Beyond pi the element says so. */
static void too_far(void)
{
	struct hawser__rod_element el = {.h = 1.0, .EA = {1.0, 1.0, 1.0}, .EI = {1.0, 1.0, 1.0}};
	struct hawser__rod_node node[2] = {{.q = {1.0}}, {.x = {1.0}, .q = {1.0}}};
	struct hawser__rod_strain at;
	double quarter[3] = {0.0, 0.0, 0.25*3.13};

	for (int i = 0; i < 4; i++)
		hawser__quaternion_turn(node[1].q, quarter);
	ok(!hawser__rod_strain(&at, &el, node), "3.13 rad are within pi");
	close_to(at.k[2], 3.13, 1e-14, "curvature");
	quarter[2] = 0.02;
	hawser__quaternion_turn(node[1].q, quarter);
	ok(hawser__rod_strain(&at, &el, node), "3.15 rad are not");
	close_to(at.k[2], 3.15, 1e-14, "but are measured");
}

CASE(unit_rod_element)
{
	logarithms();
	jacobians();
	gradients();
	rigid();
	interpolated();
	too_far();
	return done_testing();
}
