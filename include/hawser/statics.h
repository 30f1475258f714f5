/* hawser/statics.h - the elastic catenary between two fixed ends.
 *
 * Notation (doc/theory.md): x along the span, y up, S unstretched arclength from end A, tension
 * positive. Scaled by length d, force H, time d*sqrt(rho/H): epsilon = H/EA, delta = rho*g*d/H,
 * l = L/d, hs = h/d, eta = vertical over horizontal force at S = 0, u(S) = eta + delta*S.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STATICS_H
#define HAWSER_STATICS_H

#include <hawser/scene.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The cable and where its ends are; SI. */
struct hawser_span {
	double EA;  /* N, may be INFINITY */
	double rho; /* kg/m */
	double g;   /* m/s^2 */
	double d, h; /* m */
};

struct hawser_statics {
	struct hawser_span span;
	enum hawser_given given;
	enum hawser_branch branch; /* taut unless T0 or T1 was given and slack was asked for */
	double H, T0, T1, V0, V1; /* N; V is the vertical component of the tension along +S */
	double length0, length;   /* m, unstretched and stretched */
	double sag;               /* m, largest vertical distance from the chord */
	double eta, epsilon, delta, l, hs; /* scaled, see above */
	/* Irvine's lambda, INFINITY for an inextensible cable: classical (0 where a steep cable gets
	 * perpendicular to its chord), and by B (4.60), as the source's figures use it */
	double irvine, irvine_source;
	double closure;       /* m, by which the forward formulas miss end B; round-off of `length` */
	int iterations;
};

/* A point of the profile. */
struct hawser_profile_point {
	double S;        /* m, unstretched arclength */
	double x, y;     /* m */
	double T;        /* N */
	double slope;    /* dy/dx = u(S) */
};

/* Solve the span for any one given quantity `value` (N or m). The solve is a bracketed monotone
 * scalar problem, in forms that do not cancel; it cannot miss. Statuses: HAWSER_ERR_ARGUMENT (EA,
 * rho, g, d or value not positive, or not finite but for EA; |h| > 1e9 d), HAWSER_ERR_NO_SOLUTION
 * (tension below the minimum, which the message states; an inextensible cable no longer than the
 * chord; results beyond the range of double), HAWSER_ERR_CONVERGENCE (the closure doesn't confirm
 * the answer: a defect of the library). On failure *statics is undefined. */
enum hawser_status hawser_statics_solve(struct hawser_statics *statics,
                                        const struct hawser_span *span, enum hawser_given given,
                                        double value, enum hawser_branch branch,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;

/* The same for a scene. */
enum hawser_status hawser_statics_scene(struct hawser_statics *statics,
                                        const struct hawser_scene *scene,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;

/* Profile and tension at S (m, 0..length0). */
struct hawser_profile_point hawser_statics_at(const struct hawser_statics *statics, double S);

/* Geometry the later stages need, all scaled, at scaled arclength s = S/d in [0, l]. */
struct hawser_frame_point {
	double u;         /* eta + delta*s, the slope dy/dx */
	double ex, ey;    /* unit tangent e; n = (-ey, ex) */
	double curvature; /* kappa with respect to the unstretched arclength: e' = kappa*n */
	double strain;    /* epsilon*sqrt(1+u^2); the static stretch |x'| is 1 + strain */
};
struct hawser_frame_point hawser_statics_frame(const struct hawser_statics *statics, double s);

/* --- cheap models beside the elastic catenary --- */

/* A static model is a row: its name, one line about it, its source, and two functions, as
 * hawser_statics_solve and hawser_statics_at are those of the first row, the elastic catenary. The
 * others leave out the stretch: they set span.EA and both of Irvine's parameters to INFINITY,
 * epsilon to 0. `solve` returns the statuses of hawser_statics_solve. */
struct hawser_statics_model {
	const char *name, *summary, *source;
	enum hawser_status (*solve)(struct hawser_statics *statics, const struct hawser_span *span,
	                            enum hawser_given given, double value, enum hawser_branch branch,
	                            struct hawser_report *report);
	/* Of what this row's `solve` has filled, at S (m, 0..length0). */
	struct hawser_profile_point (*at)(const struct hawser_statics *statics, double S);
};
/* The rows, *count of them, the elastic catenary first. Static storage. */
const struct hawser_statics_model *hawser_statics_models(int *count);

/* What a model makes of a span against the elastic catenary of the same given quantity. */
struct hawser_statics_error {
	double H, T0, T1, length0, length, sag; /* value over that of the catenary, minus 1 */
	double position; /* m, largest vertical distance between the two curves, of 201 points */
};
void hawser_statics_compare(struct hawser_statics_error *error,
                            const struct hawser_statics_model *model,
                            const struct hawser_statics *statics,
                            const struct hawser_statics *catenary);

#ifdef __cplusplus
}
#endif
#endif
