/* statics/space.c - the equilibrium of a cable in space: point forces beside the force per length.
 *
 *   y        against the force w per length; W_i the point forces, any direction
 *   F        force in the cable (along +S) at end A, three components: the unknowns
 *   (X, V, Z) the force at S: F + w S y minus the W_i with S_i <= S; h = hypot(X, Z)
 *   r, K     position of end B that F gives, and its derivative by F
 *
 * Between two point forces X and Z are constant: the piece is the elastic catenary of loaded.c with
 * h in place of H, in a plane that contains y. With A = D/EA + (asinh Vb/h - asinh Va/h)/w it reaches
 * (X A, dy, Z A), and
 *
 *   d(X A)/dX = A + X^2 B,  d(X A)/dZ = X Z B,  B = (x_h - A)/h^2,  d(X A)/dV = X x_V/h,
 *
 * where x_h, x_V are the derivatives in the plane. K is the integral of 1/EA + (1 - e e')/T, e the
 * tangent: symmetric, positive definite. It is the second derivative of the complementary energy
 * Phi(F) = integral of T + T^2/(2 EA), r = dPhi/dF. Phi - F.c, with the chord c, is strictly convex:
 * a cable of given length has one equilibrium, and Newton's method with steps that end where the
 * derivative along the step has decreased converges from any F. It begins with the force of the plane
 * catenary under all loads, spread evenly, with the moment of the loads where they are.
 *
 * Of ends on springs (yield.c) the unknown is the change F of the force, C F is added to r, and C to K:
 * Phi gains the energy of the springs and remains convex.
 *
 * A tension at an end is searched over the length, on the given side of its least value, as in
 * loaded_solve.c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <float.h>
#include <math.h>

#include "core/report.h"
#include "core/vec3.h"
#include "statics/catenary.h"
#include "statics/loaded.h"
#include "statics/search.h"

static const char where[] = "statics";
enum { ITERATIONS = 300 };

struct reach {
	double r[3], K[3][3], r_L[3]; /* r_L: derivative by the length L */
	double length;                /* stretched */
};

struct solved {
	double F[3];
	struct reach at;
	double F_L[3]; /* derivative of F by L along the equilibria */
};

/* Add the piece of length D that begins with the force f; D_L and V_L are derivatives by L. */
static void piece(struct reach *to, const struct hawser__loaded *cable, const double f[3], double D,
                  double D_L, double V_L)
{
	double w = cable->w, E = cable->EA, V = f[1], Vb = V + w*D, both = V + Vb;
	double h = fmax(hypot(f[0], f[2]), DBL_MIN/DBL_EPSILON*(fabs(V) + fabs(Vb) + 1.0));
	double Ta = hypot(h, V), Tb = hypot(h, Vb);
	double t = hawser__angle_between(V/h, Vb/h, w*D/h), sine = sinh(t);
	double turn = sine*(h/Ta)*(h/Tb), A = D/E + t/w, B = -sine/Ta/Tb/w;
	double cross = -D*(both/Ta/Tb)/(Ta + Tb); /* x_V/h */
	double lift = D/E + turn/w, push = (1.0/E + 1.0/Tb)*D_L + cross*V_L;

	to->length += D + 0.5*((Ta*Tb + V*Vb)*sine + h*h*t)/w/E;
	for (int i = 0; i < 3; i += 2) {
		to->r[i] += f[i]*A;
		to->r_L[i] += f[i]*push;
		to->K[i][i] += A;
		to->K[i][1] += f[i]*cross;
		to->K[1][i] += f[i]*cross;
		for (int k = 0; k < 3; k += 2)
			to->K[i][k] += f[i]*f[k]*B;
	}
	to->r[1] += D*both*(0.5/E + 1.0/(Ta + Tb));
	to->r_L[1] += Vb*(1.0/E + 1.0/Tb)*D_L + lift*V_L;
	to->K[1][1] += lift;
}

/* The springs, and the force at end A. */
static void yield(struct reach *to, double f[3], const struct hawser__soft *soft, const double F[3])
{
	for (int i = 0; i < 3; i++) {
		f[i] += soft->rest[i];
		for (int k = 0; k < 3; k++) {
			to->r[i] += soft->C[i][k]*F[k];
			to->K[i][k] += soft->C[i][k];
		}
	}
}

/* From F to end B. */
static void reach_of(struct reach *to, const struct hawser__loaded *cable, const double F[3])
{
	double f[3] = {F[0], F[1], F[2]}, from = 0.0, from_L = 0.0;

	*to = (struct reach){.length = 0.0};
	if (cable->soft)
		yield(to, f, cable->soft, F);
	for (int i = 0; i <= cable->count; i++) {
		double S_L = 1.0, S = i < cable->count ? hawser__load_place(cable, i, &S_L) : cable->L;

		piece(to, cable, f, S - from, S_L - from_L, cable->w*from_L);
		if (i == cable->count)
			return;
		f[1] += cable->w*(S - from);
		for (int c = 0; c < 3; c++)
			f[c] -= cable->load[i].force[c];
		from = S;
		from_L = S_L;
	}
}

/* x = K^-1 b. K is positive definite, but for a straight inextensible cable between rigid ends. */
static void solve(double x[3], double K[3][3], const double b[3], const struct hawser__soft *soft)
{
	double trace = K[0][0] + K[1][1] + K[2][2];

	hawser__solve3(x, K, b, soft ? DBL_MIN : 4.0*DBL_EPSILON*DBL_EPSILON*trace);
}

/* The span of a cable under all loads, spread over the length, in its plane; axis: x' and y' of it. */
static enum hawser_status spread(struct hawser_span *level, double axis[2][3],
                                 const struct hawser__loaded *cable, const struct hawser_span *span,
                                 struct hawser_report *report)
{
	double q[3] = {0.0, -cable->w, 0.0}, *across = axis[0], *up = axis[1], normal[3], force;

	for (int i = 0; i < cable->count; i++)
		for (int c = 0; c < 3; c++)
			q[c] += cable->load[i].force[c]/cable->L;
	force = hawser__norm(q);
	for (int c = 0; c < 3; c++)
		up[c] = -q[c]/force;
	normal[0] = span->h*up[2];
	normal[1] = -span->d*up[2];
	normal[2] = span->d*up[1] - span->h*up[0];
	*level = *span;
	level->d = hawser__norm(normal);
	level->h = span->d*up[0] + span->h*up[1];
	level->g = force/span->rho;
	for (int c = 0; c < 3; c++)
		across[c] = (up[(c + 1)%3]*normal[(c + 2)%3] - up[(c + 2)%3]*normal[(c + 1)%3])/level->d;
	if (level->d > 1e-9*hypot(span->d, span->h))
		return HAWSER_OK;
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
	                    "the weight, load.static and the attachments together act along the chord of "
	                    "the span: such a cable hangs like a vertical one, which H does not describe; "
	                    "change the load or the attachments");
}

/* The force at end A of the catenary of the loads that are spread, changed so that the mean force is
 * that of the loads where they are. */
static enum hawser_status begin(double F[3], double *length0, const struct hawser__loaded *cable,
                                const struct hawser_span *span, enum hawser_given given,
                                double value, enum hawser_branch branch,
                                struct hawser_report *report)
{
	double axis[2][3], unused;
	struct hawser_span level;
	struct hawser_statics even;
	enum hawser_status status = spread(&level, axis, cable, span, report);

	if (!status)
		status = hawser_statics_solve(&even, &level, given, value, branch, report);
	if (status)
		return status;
	*length0 = even.length0;
	for (int c = 0; c < 3; c++) {
		F[c] = even.H*axis[0][c] + even.V0*axis[1][c];
		for (int i = 0; i < cable->count; i++)
			F[c] += cable->load[i].force[c]*
			        (0.5 - hawser__load_place(cable, i, &unused)/cable->L);
	}
	return HAWSER_OK;
}

/* One step of Newton's method, shortened until the derivative along it has decreased. Returns 0 where
 * it is round-off. */
static int improve(struct solved *at, const struct hawser__loaded *cable, const double chord[3])
{
	double gap[3], step[3], to[3], slope, size = 1.0, before, moved;
	struct reach next;

	for (int c = 0; c < 3; c++)
		gap[c] = chord[c] - at->at.r[c];
	solve(step, at->at.K, gap, cable->soft);
	slope = hawser__dot(gap, step);
	before = hawser__norm(gap);
	moved = hawser__norm(step)/fmax(hawser__norm(at->F), DBL_MIN);
	for (int tries = 0; tries < 60; tries++) {
		double left;

		for (int c = 0; c < 3; c++)
			to[c] = at->F[c] + size*step[c];
		reach_of(&next, cable, to);
		for (int c = 0; c < 3; c++)
			gap[c] = chord[c] - next.r[c];
		left = hawser__dot(gap, step);
		if (hawser__norm(gap) < before || (fabs(left) < 0.5*slope && moved > 1e-10)) {
			for (int c = 0; c < 3; c++)
				at->F[c] = to[c];
			at->at = next;
			return moved > DBL_EPSILON;
		}
		if (moved < 1e-12)
			return 0;
		size *= left < 0.0 ? fmax(0.1, fmin(0.7, slope/(slope - left))) : 0.5;
	}
	return 0;
}

/* The equilibrium at the length of *cable. */
static enum hawser_status at_length(struct solved *at, struct hawser__loaded *cable, int *order,
                                    const struct hawser_span *span, struct hawser_report *report)
{
	const struct hawser__soft *soft = cable->soft;
	const double rigid[3] = {span->d, span->h, 0.0}, *chord = soft ? soft->chord : rigid;
	double gap[3], unused;
	enum hawser_status status;

	hawser__loaded_sort(cable, order);
	status = begin(at->F, &unused, cable, span, HAWSER_GIVEN_LENGTH0, cable->L, HAWSER_BRANCH_TAUT,
	               soft ? NULL : report);
	if (status && !soft)
		return status;
	for (int c = 0; c < 3 && soft; c++) /* springs may let hang what does not reach rigid ends */
		at->F[c] = status ? 0.0 : at->F[c] - soft->rest[c];
	reach_of(&at->at, cable, at->F);
	for (int i = 0; i < ITERATIONS; i++) {
		cable->iterations++;
		if (!improve(at, cable, chord))
			break;
	}
	for (int c = 0; c < 3; c++)
		gap[c] = at->at.r[c] - chord[c];
	solve(at->F_L, at->at.K, at->at.r_L, soft);
	for (int c = 0; c < 3; c++)
		at->F_L[c] = -at->F_L[c];
	if (hawser__norm(gap) <= 1e-9*(hawser__norm(rigid) + at->at.length))
		return HAWSER_OK;
	return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, where,
	                    "no equilibrium of this span with its attachments and its static load was "
	                    "found within the range of double-precision numbers: check loads, masses, "
	                    "tension, EA and the stiffness of supports");
}

enum hawser_status hawser__space_force(double F[3], struct hawser__loaded *cable, int *order,
                                       const struct hawser_span *span, struct hawser_report *report)
{
	struct solved at;
	enum hawser_status status = at_length(&at, cable, order, span, report);

	for (int c = 0; c < 3; c++)
		F[c] = at.F[c];
	return status;
}

/* Tension at the given end, and its logarithmic derivative by L. */
static double tension(double *slope, const struct solved *at, const struct hawser__loaded *cable,
                      enum hawser_given given)
{
	double f[3], f_L[3], T;

	for (int c = 0; c < 3; c++) {
		f[c] = at->F[c];
		f_L[c] = at->F_L[c];
	}
	if (given == HAWSER_GIVEN_T1) {
		f[1] += cable->w*cable->L;
		f_L[1] += cable->w;
		for (int i = 0; i < cable->count; i++)
			for (int c = 0; c < 3; c++)
				f[c] -= cable->load[i].force[c];
	}
	T = hawser__norm(f);
	*slope = hawser__dot(f, f_L)*cable->L/(T*T);
	return T;
}

/* Search over L for a tension at an end; an inextensible cable that does not reach is too short. */
static enum hawser_status over_length(struct solved *at, struct hawser__loaded *cable, int *order,
                                      const struct hawser__load_case *of,
                                      struct hawser_report *report)
{
	int taut = of->branch == HAWSER_BRANCH_TAUT, below;
	struct hawser__search search = {.x = cable->L, .hi = INFINITY, .step = INFINITY};
	double F = -INFINITY, slope = 0.0, newton;
	enum hawser_status status;

	if (begin(at->F, &search.x, cable, of->span, of->given, of->value, of->branch, NULL))
		search.x = cable->L;
	do {
		cable->L = search.x;
		status = at_length(at, cable, order, of->span, report);
		if (status && !(status == HAWSER_ERR_NO_SOLUTION && isinf(cable->EA)))
			return status;
		if (status) {
			below = 0;
			newton = 0.0;
			continue;
		}
		F = log(tension(&slope, at, cable, of->given)/of->value);
		if (fabs(F) <= 8.0*DBL_EPSILON*(2.0 + fmin(fabs(slope), 1e6)))
			return HAWSER_OK;
		below = taut ? !(F > 0.0 && slope < 0.0) : F > 0.0 && slope > 0.0;
		newton = (slope < 0.0) == taut ? -F/slope : 0.0;
	} while (hawser__search_next(&search, below, newton));
	if (status || fabs(F) <= 1e-9)
		return status;
	return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, where,
	                    "the tension %s = %.10g N is below the least one with which this span, its "
	                    "static load and its attachments can hang, %.10g N (at length0 = %.10g m): "
	                    "give at least that", of->given == HAWSER_GIVEN_T0 ? "T0" : "T1", of->value,
	                    of->value*exp(F), cable->L);
}

/* Irvine's parameters of the cable on which all loads are spread, with the mean force across them. */
static enum hawser_status irvine(struct hawser_statics *st, const struct hawser__loaded *cable,
                                 const double F[3], struct hawser_report *report)
{
	double axis[2][3], H = 0.0, unused;
	struct hawser_span level;
	struct hawser_statics even;
	enum hawser_status status = spread(&level, axis, cable, &st->span, report);

	for (int c = 0; c < 3; c++) {
		double mean = F[c] + (c == 1 ? 0.5*cable->w*cable->L : 0.0);

		for (int i = 0; i < cable->count; i++)
			mean -= cable->load[i].force[c]*(1.0 - hawser__load_place(cable, i, &unused)/cable->L);
		H += mean*axis[0][c];
	}
	if (!status) /* H may be negative where heavy masses make parts of the cable run back */
		status = hawser_statics_solve(&even, &level, H > 0.0 ? HAWSER_GIVEN_H : HAWSER_GIVEN_LENGTH0,
		                              H > 0.0 ? H : cable->L, HAWSER_BRANCH_TAUT, report);
	if (status)
		return status;
	st->irvine = even.irvine;
	st->irvine_source = even.irvine_source;
	return HAWSER_OK;
}

static void fill(struct hawser_statics *st, const struct hawser__loaded *cable,
                 const struct solved *at)
{
	double d = cable->d, end[3], size = hawser__norm(at->F);

	st->space = 1;
	st->H = hypot(at->F[0], at->F[2]);
	st->azimuth[0] = at->F[0]/st->H;
	st->azimuth[1] = at->F[2]/st->H;
	for (int c = 0; c < 3; c++)
		end[c] = at->F[c];
	end[1] += cable->w*cable->L;
	for (int i = 0; i < cable->count; i++)
		for (int c = 0; c < 3; c++)
			end[c] -= cable->load[i].force[c];
	st->V0 = at->F[1];
	st->V1 = end[1];
	st->T0 = size;
	st->T1 = hawser__norm(end);
	st->eta = st->V0/st->H;
	st->epsilon = st->H/cable->EA;
	st->delta = cable->w*d/st->H;
	st->length0 = cable->L;
	st->l = cable->L/d;
	st->hs = cable->h/d;
	st->length = at->at.length;
	st->motion.tension = st->T0;
	st->motion.tension1 = st->T1;
	st->iterations = cable->iterations;
	/* of x a few units relative to the length, which act like a change of L */
	st->error = 4.0*DBL_EPSILON*(1 + cable->count)*(1.0 + hawser__norm(at->F_L)*cable->L/size);
}

enum hawser_status hawser__space_solve(struct hawser_statics *st, struct hawser__loaded *cable,
                                       int *order, const struct hawser__load_case *of,
                                       struct hawser_report *report)
{
	struct solved at;
	enum hawser_status status;

	if (of->given == HAWSER_GIVEN_H || of->given == HAWSER_GIVEN_SAG)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
		                    "tension: the %s is given of a cable that attachments turn out of one "
		                    "plane, or pull along the span or upwards: it is not the same along "
		                    "such a cable, or not in one plane; give T0, T1 or length0 or, if only "
		                    "load.static turns it, the tension of the reference state",
		                    of->given == HAWSER_GIVEN_H ? "horizontal tension H" : "sag");
	if (of->given == HAWSER_GIVEN_LENGTH0) {
		cable->L = of->value;
		status = at_length(&at, cable, order, of->span, report);
	} else {
		status = over_length(&at, cable, order, of, report);
	}
	if (status)
		return status;
	*st = (struct hawser_statics){.span = *of->span, .given = of->given,
	                              .branch = of->given == HAWSER_GIVEN_LENGTH0 ? HAWSER_BRANCH_TAUT
	                                                                          : of->branch};
	fill(st, cable, &at);
	return irvine(st, cable, at.F, report);
}
