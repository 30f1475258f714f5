/* statics/loaded.c - the profile of a cable with point masses, for given H, V0 and L.
 *
 * Between two masses the cable is an elastic catenary. With p, q the hyperbolic angles of a piece of
 * length D, sinh p = V_a/H, and t = q - p,
 *
 *   dx = H*D/EA + (H/w)*t                 dy = D*(V_a + V_b)*(1/(2 EA) + 1/(T_a + T_b))
 *   integral of T = [(T_a*T_b + V_a*V_b)*sinh(t) + H^2*t]/(2 w)
 *
 * and the derivatives by the force at its beginning are
 *
 *   d(dx)/dV = d(dy)/dH = -integral of H*V/T^3 = -H*D*(V_a + V_b)/(T_a*T_b*(T_a + T_b))
 *   d(dy)/dV = D/EA + integral of H^2/T^3 = D/EA + (tanh q - tanh p)/w
 *   d(dx)/dH = D/EA + integral of V^2/T^3 = D/EA + (t - tanh q + tanh p)/w
 *   d(dx, dy)/dD = (H, V_b)*(1/EA + 1/T_b)
 *
 * with tanh q - tanh p = sinh(t)/(cosh p*cosh q). x, y and the length are sums without cancellation.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "statics/catenary.h"
#include "statics/loaded.h"

double hawser__load_place(const struct hawser__loaded *cable, int i, double *by_L)
{
	const struct hawser__load_point *load = &cable->load[i];
	double S = load->fixed ? load->at : load->at*cable->L;

	*by_L = load->fixed ? 0.0 : load->at;
	if (S <= cable->L)
		return S;
	*by_L = 1.0; /* a search passes a length that is too short: the end carries the load */
	return cable->L;
}

/* Add the piece of length D from the force V on; D_L and V_L are derivatives by L. */
static void piece(struct hawser__reach *r, const struct hawser__loaded *cable, double V, double D,
                  double D_L, double V_L)
{
	double H = cable->H, w = cable->w, E = cable->EA, Vb = V + w*D;
	double Ta = hypot(H, V), Tb = hypot(H, Vb), both = V + Vb;
	double t = hawser__angle_between(V/H, Vb/H, w*D/H), sine = sinh(t);
	double turn = sine*(H/Ta)*(H/Tb); /* tanh q - tanh p */
	double cross = -H*D*(both/Ta/Tb)/(Ta + Tb), lift = D/E + turn/w;

	r->x += H*(D/E) + H/w*t;
	r->y += D*both*(0.5/E + 1.0/(Ta + Tb));
	r->length += D + 0.5*((Ta*Tb + V*Vb)*sine + H*H*t)/w/E;
	r->xH += D/E + (t - turn)/w;
	r->xV += cross;
	r->yH += cross;
	r->yV += lift;
	r->xL += H*(1.0/E + 1.0/Tb)*D_L + cross*V_L;
	r->yL += Vb*(1.0/E + 1.0/Tb)*D_L + lift*V_L;
}

void hawser__loaded_reach(struct hawser__reach *r, const struct hawser__loaded *cable, double S,
                          double S_L)
{
	double from = 0.0, from_L = 0.0, V = cable->V0;

	*r = (struct hawser__reach){0};
	for (int i = 0; i <= cable->count; i++) {
		double to_L = S_L, to = i < cable->count ? hawser__load_place(cable, i, &to_L) : S;
		int last = i == cable->count || to >= S;

		if (last) {
			to = S;
			to_L = S_L;
		}
		piece(r, cable, V, to - from, to_L - from_L, cable->w*from_L);
		if (last)
			return;
		V += cable->w*(to - from) + cable->load[i].W;
		from = to;
		from_L = to_L;
	}
}

/* The chord's vertical distance is largest where the slope V/H passes h/d: inside a piece, where the
 * position does not matter to first order, or at a mass. */
double hawser__loaded_sag(const struct hawser__loaded *cable, double V_H, double L_H,
                          double *derivative)
{
	double chord = cable->h/cable->d, target = chord*cable->H, S_L = 0.0, S = 0.0;
	double V = cable->V0, from = 0.0;
	struct hawser__reach r;

	for (int i = 0; i <= cable->count; i++) {
		double to_L = 1.0, to = i < cable->count ? hawser__load_place(cable, i, &to_L) : cable->L;
		double end = V + cable->w*(to - from);

		S = to;
		S_L = to_L;
		if (end >= target) { /* >= also at the end */
			S = fmax(from, from + (target - V)/cable->w);
			S_L = S/cable->L;
			break;
		}
		if (i == cable->count || end + cable->load[i].W >= target)
			break;
		V = end + cable->load[i].W;
		from = to;
	}
	hawser__loaded_reach(&r, cable, S, S_L);
	*derivative = chord*(r.xH + r.xV*V_H + r.xL*L_H) - (r.yH + r.yV*V_H + r.yL*L_H);
	return chord*r.x - r.y;
}
