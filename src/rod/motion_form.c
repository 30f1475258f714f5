/* rod/motion_form.c - loads, inertia and internal forces of a rod in motion, and their derivatives.
 *
 * Half the mass of an element is at each of its nodes, and so is its inertia of rotation J. With a
 * body of mass M, centre l and inertia Jb in the node, and f' the rate of f (velocity v, spin w):
 *   force   (m + M) v' + M R c,  c = w' x l + w x (w x l)
 *   moment  (J + Jb) w' + w x (J + Jb) w + M l x (R'v' + c)
 * The lumped chain is an ordinary differential equation in (x, q, v, w), and its error is of order
 * h^2, as that of the element. SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "rod/motion.h"
#include "rod/so3.h"

static const struct hawser__rod_body *body_of(const struct hawser__rod_motion *motion, int node)
{
	for (int i = 0; i < motion->bodies; i++)
		if (motion->body[i].node == node)
			return &motion->body[i];
	return NULL;
}

void hawser__rod_motion_masses(struct hawser__rod_motion *motion)
{
	const struct hawser__rod_mesh *mesh = motion->mesh;

	memset(motion->mass, 0, (size_t)mesh->nodes*sizeof *motion->mass);
	for (int e = 0; e < mesh->elements; e++) {
		const struct hawser_rod_segment *of = &mesh->rod->segment[mesh->segment[e]];

		for (int k = 0; k < 2; k++)
			for (int j = 0; j < 4; j++)
				motion->mass[e + k][j] += 0.5*mesh->element[e].h*(j ? of->inertia[j - 1] : of->rho);
	}
}

void hawser__rod_motion_factors(struct hawser__rod_motion *motion, double t, int after)
{
	const struct hawser_rod *rod = motion->mesh->rod;

	hawser__rod_winch_set(motion, t);
	for (int l = 0; l < rod->loads; l++) {
		const struct hawser_rod_load *load = &rod->load[l];
		int i = 0, n = load->factors;

		motion->factor[l] = 1.0;
		if (!n)
			continue;
		/* the last row that is before t, or, after a jump, at it */
		while (i < n && (after ? load->factor[i][0] <= t : load->factor[i][0] < t))
			i++;
		if (i == 0 || i == n) {
			motion->factor[l] = load->factor[i ? n - 1 : 0][1];
		} else {
			const double *a = load->factor[i - 1], *b = load->factor[i];

			motion->factor[l] = a[1] + (b[1] - a[1])*(t - a[0])/(b[0] - a[0]);
		}
	}
	hawser__rod_loads(motion->mesh, motion->factor, 1.0);
}

void hawser__rod_motion_hold(struct hawser__rod_motion *motion, double t)
{
	struct hawser__rod_mesh *mesh = motion->mesh;

	for (int end = 0; end < 2; end++) {
		int node = end ? mesh->nodes - 1 : 0;
		const unsigned char *held = mesh->held + (long)HAWSER__ROD_FREE*node;
		double *velocity = motion->velocity[node], *rate = motion->rate[node];
		struct hawser__rod_guide to = {.x = {0}};

		if (motion->guide[end])
			motion->guide[end](motion->guide_data[end], &to, t);
		for (int k = 0; k < 3 && held[0]; k++) {
			velocity[k] = to.v[k];
			rate[k] = to.a[k];
		}
		for (int k = 0; k < 3 && held[3]; k++) {
			velocity[3 + k] = to.spin[k];
			rate[3 + k] = to.rate[k];
		}
		if (held[0] && motion->guide[end])
			memcpy(mesh->node[node].x, to.x, sizeof to.x);
		if (held[3] && motion->guide[end]) {
			double between[4];

			/* of q and -q the one that continues the motion, see so3.h */
			hawser__quaternion_between(between, mesh->node[node].q, to.q);
			for (int k = 0; k < 4; k++)
				mesh->node[node].q[k] = between[0] < 0.0 ? -to.q[k] : to.q[k];
		}
	}
}

/* --- the function's loads --- */

void hawser__rod_push(struct hawser__rod_motion *motion, int node, const double f[6])
{
	for (int k = 0; k < HAWSER__ROD_FREE; k++)
		motion->pushed[node][k] += f[k];
}

void hawser__rod_push_mass(struct hawser__rod_motion *motion, int node, const double (*M)[3])
{
	for (int k = 0; k < 9; k++)
		motion->added[node][k] += M[k/3][k%3];
}

/* Columns of the spin are multiplied by Ji: the increments are turns of the state, and those of the
 * step's turn, of which the spin is a linear function, are Ji times these. */
static void turn_columns(double to[36], const double by[36], const double Ji[9])
{
	for (int i = 0; i < 6; i++)
		for (int k = 0; k < 3; k++) {
			to[6*i + k] = by[6*i + k];
			to[6*i + 3 + k] = by[6*i + 3]*Ji[k] + by[6*i + 4]*Ji[3 + k] + by[6*i + 5]*Ji[6 + k];
		}
}

static void add(struct hawser__rod_motion *motion, int i, int j, const double block[36],
                double factor)
{
	for (int c = 0; c < 6; c++)
		for (int r = 0; r < 6; r++)
			*hawser__band_at(&motion->mesh->band, 6*i + r, 6*j + c) += factor*block[6*r + c];
}

void hawser__rod_push_tangent(struct hawser__rod_motion *motion, int i, int j, const double at[36],
                              const double by[36])
{
	double turned[36];

	add(motion, i, j, at, -motion->by_place);
	if (!by || motion->to_velocity == 0.0)
		return;
	turn_columns(turned, by, motion->Ji[j]);
	add(motion, i, j, turned, -motion->to_velocity);
}

/* --- inertia --- */

/* What a body needs: R, c, and the derivative G of w x (w x l) by w. */
struct swing {
	double R[9], l[9], c[3], G[9], vl[3]; /* l: l~; vl: R'v' */
};

static void swing_of(struct swing *s, const struct hawser__rod_motion *motion,
                     const struct hawser__rod_body *body, int i)
{
	const double *w = motion->velocity[i] + 3, *rate = motion->rate[i];
	double once[3], twice[3], part[9], W[9];

	hawser__quaternion_matrix(s->R, motion->mesh->node[i].q);
	hawser__skew(s->l, body->offset);
	hawser__cross(once, w, body->offset);
	hawser__cross(twice, w, once);
	hawser__cross(s->c, rate + 3, body->offset);
	for (int k = 0; k < 3; k++)
		s->c[k] += twice[k];
	hawser__skew(W, w);
	hawser__mul(part, W, s->l);
	hawser__skew(s->G, once);
	for (int k = 0; k < 9; k++)
		s->G[k] = -s->G[k] - part[k];
	hawser__apply_left(s->vl, s->R, rate);
}

/* J of rod and body, about the body's centre. */
static void inertia_of(double J[9], const double mass[4], const struct hawser__rod_body *body)
{
	for (int k = 0; k < 9; k++)
		J[k] = (k % 4 == 0 ? mass[1 + k/4] : 0.0) + (body ? body->inertia[k] : 0.0);
}

/* Forces of inertia and damping less weight of a body. */
static void inertia(double f[6], const struct hawser__rod_motion *motion,
                    const struct hawser__rod_body *body, int i)
{
	const double *mass = motion->mass[i], *v = motion->velocity[i], *rate = motion->rate[i];
	double J[9], L[3], A[3], gyro[3];

	inertia_of(J, mass, body);
	hawser__apply(L, J, v + 3);
	hawser__apply(A, J, rate + 3);
	hawser__cross(gyro, v + 3, L);
	for (int k = 0; k < 3; k++) {
		f[k] = mass[0]*(rate[k] + motion->alpha*v[k]);
		f[3 + k] = A[k] + gyro[k] + motion->alpha*mass[1 + k]*v[3 + k];
	}
	if (body) {
		struct swing s;
		double turned[3], arm[3], moment[3];

		swing_of(&s, motion, body, i);
		hawser__apply(turned, s.R, s.c);
		for (int k = 0; k < 3; k++) {
			f[k] += body->mass*(rate[k] + turned[k] + (k == 1 ? motion->mesh->rod->g : 0.0));
			arm[k] = s.vl[k] + s.c[k] + motion->mesh->rod->g*s.R[3 + k];
		}
		hawser__cross(moment, body->offset, arm);
		for (int k = 0; k < 3; k++)
			f[3 + k] += body->mass*moment[k];
	}
}

static void set(double to[36], int row, int column, const double block[9], double factor)
{
	for (int i = 0; i < 3; i++)
		for (int j = 0; j < 3; j++)
			to[6*(3*row + i) + 3*column + j] += factor*block[3*i + j];
}

/* Of the force of inertia and damping by rates, velocities, and turns. */
static void inertia_tangent(double rates[36], double velocities[36], double turns[36],
                            const struct hawser__rod_motion *motion,
                            const struct hawser__rod_body *body, int i)
{
	const double *mass = motion->mass[i], *w = motion->velocity[i] + 3;
	double J[9], L[3], W[9], part[9], skew[9];

	memset(rates, 0, 36*sizeof *rates);
	memset(velocities, 0, 36*sizeof *velocities);
	memset(turns, 0, 36*sizeof *turns);
	inertia_of(J, mass, body);
	set(rates, 0, 0, motion->added[i], 1.0);
	set(rates, 1, 1, J, 1.0);
	hawser__skew(W, w);
	hawser__mul(part, W, J);
	hawser__apply(L, J, w);
	hawser__skew(skew, L);
	for (int k = 0; k < 9; k++)
		part[k] -= skew[k];
	set(velocities, 1, 1, part, 1.0);
	for (int k = 0; k < 3; k++) {
		rates[7*k] += mass[0] + (body ? body->mass : 0.0);
		velocities[7*k] += motion->alpha*mass[0];
		velocities[7*(3 + k)] += motion->alpha*mass[1 + k];
	}
	if (body) {
		struct swing s;
		double arm[3];

		swing_of(&s, motion, body, i);
		hawser__mul_right(part, s.l, s.R);
		set(rates, 1, 0, part, body->mass);
		hawser__mul(part, s.R, s.l);
		set(rates, 0, 1, part, -body->mass);
		hawser__mul(part, s.l, s.l);
		set(rates, 1, 1, part, -body->mass);
		hawser__mul(part, s.R, s.G);
		set(velocities, 0, 1, part, body->mass);
		hawser__mul(part, s.l, s.G);
		set(velocities, 1, 1, part, body->mass);
		hawser__skew(skew, s.c);
		hawser__mul(part, s.R, skew);
		set(turns, 0, 1, part, -body->mass);
		for (int k = 0; k < 3; k++)
			arm[k] = s.vl[k] + motion->mesh->rod->g*s.R[3 + k];
		hawser__skew(skew, arm);
		hawser__mul(part, s.l, skew);
		set(turns, 1, 1, part, body->mass);
	}
}

/* --- the equations --- */

/* Loads and internal forces, mesh->r; the matrix of the internal forces, too, and the loads apart. */
static int forces(struct hawser__rod_motion *motion, double t, int tangent)
{
	struct hawser__rod_mesh *mesh = motion->mesh;
	double f[HAWSER__ROD_PAIR], K[HAWSER__ROD_PAIR*HAWSER__ROD_PAIR];

	motion->bent = hawser__rod_strains(mesh);
	if (motion->bent >= 0)
		return 1;
	if (motion->winch.as)
		hawser__rod_winch_slip(motion);
	memset(motion->pushed, 0, (size_t)mesh->nodes*sizeof *motion->pushed);
	memset(motion->added, 0, (size_t)mesh->nodes*sizeof *motion->added);
	if (motion->loading)
		motion->refused = motion->loading(motion->data, motion, t, tangent);
	if (motion->loading && motion->refused)
		return 1;
	for (int i = 0; i < mesh->nodes; i++) {
		double *r = mesh->r + (long)HAWSER__ROD_FREE*i;

		hawser__rod_load(motion->applied[i], mesh, i);
		for (int k = 0; k < HAWSER__ROD_FREE; k++)
			r[k] = motion->applied[i][k] + motion->pushed[i][k];
		motion->applied[i][1] += mesh->rod->g*motion->mass[i][0]; /* without weight */
		if (tangent && motion->by_place != 0.0)
			hawser__rod_load_tangent(mesh, i);
	}
	for (int e = 0; e < mesh->elements; e++) {
		int at = HAWSER__ROD_FREE*e, matrix = tangent && motion->by_place != 0.0;

		/* cppcheck-suppress legacyUninitvar ; it is filled there */
		hawser__rod_forces(f, matrix ? K : NULL, &mesh->element[e], &mesh->strain[e]);
		for (int i = 0; i < HAWSER__ROD_PAIR; i++)
			mesh->r[at + i] -= f[i];
		for (int j = 0; matrix && j < HAWSER__ROD_PAIR; j++) {
			double *column = hawser__band_at(&mesh->band, at, at + j);

			for (int i = 0; i < HAWSER__ROD_PAIR; i++)
				column[i] += K[HAWSER__ROD_PAIR*i + j];
		}
	}
	return 0;
}

int hawser__rod_motion_form(struct hawser__rod_motion *motion, double t, int tangent)
{
	struct hawser__rod_mesh *mesh = motion->mesh;

	if (tangent)
		hawser__band_zero(&mesh->band);
	if (forces(motion, t, tangent))
		return 1;
	for (int i = 0; i < mesh->nodes; i++) {
		const struct hawser__rod_body *body = body_of(motion, i);
		double *r = mesh->r + (long)HAWSER__ROD_FREE*i, f[6];
		double rates[36], velocities[36], turns[36], turned[36];

		inertia(f, motion, body, i);
		for (int k = 0; k < HAWSER__ROD_FREE; k++)
			r[k] -= f[k];
		if (!tangent)
			continue;
		inertia_tangent(rates, velocities, turns, motion, body, i);
		for (int k = 0; k < 36; k++)
			rates[k] = motion->to_rate*rates[k] + motion->to_velocity*velocities[k];
		turn_columns(turned, rates, motion->Ji[i]);
		add(motion, i, i, turned, 1.0);
		add(motion, i, i, turns, motion->by_place);
	}
	hawser__rod_winch_form(motion, tangent);
	/* what holds an end bears what is not balanced there */
	memset(motion->reaction[0], 0, sizeof *motion->reaction);
	memset(motion->reaction[mesh->nodes - 1], 0, sizeof *motion->reaction);
	for (int i = 0; i < mesh->n; i += i == 5 && mesh->n > 12 ? mesh->n - 11 : 1)
		if (mesh->held[i]) {
			motion->reaction[i/6][i % 6] = -mesh->r[i];
			mesh->r[i] = 0.0;
		}
	return 0;
}

/* x of A x = b, six equations, by elimination with row exchanges; 1: singular. */
static int solve6(double x[6], double A[36], const double b[6])
{
	memcpy(x, b, 6*sizeof *x);
	for (int c = 0; c < 6; c++) {
		int p = c;
		double swap;

		for (int r = c + 1; r < 6; r++)
			if (fabs(A[6*r + c]) > fabs(A[6*p + c]))
				p = r;
		if (!(fabs(A[6*p + c]) > 0.0))
			return 1;
		for (int k = 0; k < 6 && p != c; k++) {
			swap = A[6*p + k];
			A[6*p + k] = A[6*c + k];
			A[6*c + k] = swap;
		}
		swap = x[p];
		x[p] = x[c];
		x[c] = swap;
		for (int r = c + 1; r < 6; r++) {
			double part = A[6*r + c]/A[6*c + c];

			for (int k = c; k < 6; k++)
				A[6*r + k] -= part*A[6*c + k];
			x[r] -= part*x[c];
		}
	}
	for (int r = 5; r >= 0; r--) {
		for (int k = r + 1; k < 6; k++)
			x[r] -= A[6*r + k]*x[k];
		x[r] /= A[6*r + r];
	}
	return 0;
}

int hawser__rod_motion_rates(struct hawser__rod_motion *motion, double t)
{
	struct hawser__rod_mesh *mesh = motion->mesh;

	for (int i = 0; i < mesh->nodes; i++)
		for (int k = 0; k < HAWSER__ROD_FREE; k++)
			if (!mesh->held[HAWSER__ROD_FREE*i + k])
				motion->rate[i][k] = 0.0;
	if (hawser__rod_motion_form(motion, t, 0))
		return 1;
	for (int i = 0; i < mesh->nodes; i++) {
		double rates[36], velocities[36], turns[36], add_to[6];
		const unsigned char *held = mesh->held + (long)HAWSER__ROD_FREE*i;

		inertia_tangent(rates, velocities, turns, motion, body_of(motion, i), i);
		for (int k = 0; k < HAWSER__ROD_FREE; k++)
			for (int j = 0; j < HAWSER__ROD_FREE && held[k]; j++)
				rates[6*k + j] = j == k;
		if (solve6(add_to, rates, mesh->r + (long)HAWSER__ROD_FREE*i))
			return 1;
		for (int k = 0; k < HAWSER__ROD_FREE; k++)
			motion->rate[i][k] += add_to[k];
	}
	return hawser__rod_motion_form(motion, t, 0);
}
