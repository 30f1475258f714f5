/* modes/cable_space.c - the cable in space (statics/space.c) on the grid of cable.c: three strains and
 * three displacements.
 *
 *   F        force over H, (X, V, Z); h = hypot(X, Z), T = |F|; index m: at mid-length
 *   E, N, B  tangent, normal and binormal at mid-length: the axes of the displacements
 *   R        e, n and b along E, N, B: what a strain displaces, over the root of its compliance
 *   phi      angle of the force above the plane across y', alpha: of (X, Z) from that at mid-length
 *
 * With C = cos phi and S = sin phi, e = C a + S y', n = -S a + C y', b = a x y', where a is the unit
 * vector along (X, Z). The differences F - Fm are sums of weights, without cancellation, and so are
 *
 *   sin(phi - phi_m) = (dV hm - Vm dh)/(T Tm),     dh = ((X + Xm) dX + (Z + Zm) dZ)/(h + hm)
 *   sin(alpha) = (Xm dZ - Zm dX)/(h hm),           v = 1 - cos(alpha)
 *
 * of which R is made, so that the small angles of a nearly straight cable are accurate. The strains
 * of n and b have the same stiffness: in the local frame a piece is a cable in its plane, and only
 * kinks couple the components.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "modes/cable.h"

static void force_middle(double F[3], struct hawser_frame_point *middle,
                         const struct hawser_statics *st)
{
	*middle = hawser_statics_frame(st, 0.5*st->l);
	for (int c = 0; c < 3; c++)
		F[c] = middle->tension*middle->axis[0][c];
}

/* F - Fm at s: the weight and the attachments between the middle, with those at it, and s. */
static void difference(double d[3], const struct hawser_statics *st, double s)
{
	double middle = 0.5*st->l;

	d[0] = d[2] = 0.0;
	d[1] = s - middle;
	for (int i = 0; i < st->attachments; i++) {
		int before = st->attached[i].s <= s, sign = before - (st->attached[i].s <= middle);

		for (int c = 0; c < 3 && sign; c++)
			d[c] += sign*st->attached[i].jump[c];
	}
	for (int c = 0; c < 3; c++)
		d[c] *= st->delta;
}

double hawser__space_slopes(double *first, double *last, const struct hawser_statics *st, int i)
{
	double F[3] = {st->azimuth[0], st->eta, st->azimuth[1]}, h;
	double from = i > 0 ? st->attached[i - 1].s : 0.0;
	double to = i < st->attachments ? st->attached[i].s : st->l;

	for (int k = 0; k < i; k++)
		for (int c = 0; c < 3; c++)
			F[c] += st->delta*st->attached[k].jump[c];
	h = hypot(F[0], F[2]);
	*first = (F[1] + st->delta*from)/h;
	*last = (F[1] + st->delta*to)/h;
	return st->delta/h;
}

/* R [3][3], and the tension. */
static double rotation(double R[9], const struct hawser_statics *st, const double Fm[3], double Tm,
                       double s)
{
	double d[3], F[3], hm = hypot(Fm[0], Fm[2]), h, T, Cm = hm/Tm, Sm = Fm[1]/Tm, C, S, sine, cosine;
	double turn, straight, v;

	difference(d, st, s);
	for (int c = 0; c < 3; c++)
		F[c] = Fm[c] + d[c];
	h = hypot(F[0], F[2]);
	T = hypot(h, F[1]);
	C = h/T;
	S = F[1]/T;
	sine = (d[1]*(hm/Tm) - Sm*((F[0] + Fm[0])*d[0] + (F[2] + Fm[2])*d[2])/(h + hm))/T;
	cosine = C*Cm + S*Sm;
	turn = (Fm[0]*d[2] - Fm[2]*d[0])/h/hm;
	straight = (F[0]*Fm[0] + F[2]*Fm[2])/h/hm;
	v = straight > 0.0 ? turn*turn/(1.0 + straight) : 1.0 - straight;
	R[0] = cosine - C*Cm*v;
	R[1] = sine + C*Sm*v;
	R[2] = C*turn;
	R[3] = -sine + S*Cm*v;
	R[4] = cosine - S*Sm*v;
	R[5] = -S*turn;
	R[6] = -Cm*turn;
	R[7] = Sm*turn;
	R[8] = 1.0 - v;
	return T;
}

void hawser__space_fields(struct hawser__cable *t, const struct hawser_statics *st)
{
	int points = t->grid.points;
	double *sb = t->field + 9*points, Fm[3], R[9];
	struct hawser_frame_point middle;

	force_middle(Fm, &middle, st);
	for (int i = 0; i < points; i++) {
		double T = rotation(R, st, Fm, middle.tension, t->grid.s[i]);

		sb[i] = sqrt((1.0 + st->epsilon*T)/T);
		for (int k = 0; k < 9; k++) {
			t->field[k*points + i] = R[k];
			t->direction[k*points + i] = (k < 3 ? t->sa : sb[i])*R[k];
		}
	}
	t->plane[HAWSER_IN_PLANE] = (struct hawser__plane){.D = 3, .direction = t->direction};
	t->plane[HAWSER_OUT_OF_PLANE] = (struct hawser__plane){.D = 0, .direction = t->direction};
}

void hawser__space_axes(double axis[3][HAWSER__MAX_D], const struct hawser_statics *st)
{
	struct hawser_frame_point middle = hawser_statics_frame(st, 0.5*st->l);

	for (int a = 0; a < 3; a++) {
		double v[3] = {a == 0, a == 1, a == 2};

		hawser_statics_from_global(st, v, v);
		for (int c = 0; c < 3; c++)
			axis[a][c] = v[0]*middle.axis[c][0] + v[1]*middle.axis[c][1] + v[2]*middle.axis[c][2];
	}
}

void hawser__space_shape(double *shape, double *slope, const struct hawser__cable *cable,
                         const double *strain, const double *displacement)
{
	int points = cable->grid.points;
	const double *R = cable->field, *sb = R + 9*points;

	for (int i = 0; i < points; i++, shape += 3, slope += 3)
		for (int k = 0; k < 3; k++) {
			for (int c = 0; c < 3; c++)
				shape[k] += R[(3*k + c)*points + i]*displacement[c*points + i];
			slope[k] = (k == 0 ? cable->sa : sb[i])*strain[k*points + i];
		}
}
