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

/* A cable that travels along itself at a steady speed v is a resting cable in disguise: with
 * m = rho v^2/EA, its shape and all its motions are those of a cable at rest of the same EA, of
 * mass (1 - m) rho a length S/(1 - m), and of the apparent tension A = (1 - m) T - m EA, but for the
 * gyroscopic force 2 nu Phi' du/dt (doc/theory-travel.md: exact, for large motions too). A speed that
 * fluctuates, v + V sin(Omega t), counts by its mean square. */
struct hawser_motion {
	double speed, fluctuation; /* v and V, m/s */
	enum hawser_hold hold;
	double mach2;     /* m = rho (v^2 + V^2/2)/EA; 0 at rest */
	double nu, swing; /* v and V scaled: v sqrt(rho/((1 - m) H)) with the apparent H */
	double tension;   /* N, actual tension at S = 0, and */
	double tension1;  /* at S = L */
};

/* At rest: the cable itself. Travelling: the resting cable of struct hawser_motion, whose span.rho, H,
 * T0, T1, V0, V1, length0, delta, epsilon and lengths S are the apparent ones; d, h, shape, sag and
 * `length` are the actual ones. */
struct hawser_statics {
	struct hawser_motion motion; /* all zero, but for both tensions, at rest */
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
	/* largest relative error, by round-off, of H, T0, T1, length0, length and sag, the given quantity
	 * and the span being exact; 0 of a model that is no elastic catenary */
	double error;
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

/* The span travelling at motion->speed and ->fluctuation with ->hold (the rest of *motion is not
 * read): its steady state. The cable at rest is solved first, for `given`; HAWSER_HOLD_TENSION then
 * keeps what was given of H, T0 and T1, and T0 of the cable at rest otherwise, HAWSER_HOLD_LENGTH keeps
 * its unstretched length. At speed 0 it is the cable at rest to the last bit. Statuses as above;
 * HAWSER_ERR_NO_SOLUTION too at a speed beyond the limit, which the message states. */
enum hawser_status hawser_statics_travel(struct hawser_statics *statics,
                                         const struct hawser_span *span, enum hawser_given given,
                                         double value, enum hawser_branch branch,
                                         const struct hawser_motion *motion,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;

/* *limit: the speed (m/s) up to which the span has its steady state, without fluctuation: with the
 * tension held that of the least apparent tension with which the span can hang; sqrt(EA/rho) with the
 * length held, and with H held where nothing else ends it. Statuses of hawser_statics_solve. */
enum hawser_status hawser_statics_limit(double *limit, const struct hawser_span *span,
                                        enum hawser_given given, double value,
                                        enum hawser_branch branch, enum hawser_hold hold,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;

/* The actual tension (N) where the apparent one is A (N), and a point of the profile at actual S. */
double hawser_statics_actual_tension(const struct hawser_statics *statics, double A);
struct hawser_profile_point hawser_statics_actual_at(const struct hawser_statics *statics, double S);

/* For people: a copy with the actual span.rho, H (horizontal part of the tension at S = 0), T0, T1,
 * V0, V1 and length0. Not for other calls, which expect the apparent ones. */
struct hawser_statics hawser_statics_actual(const struct hawser_statics *statics);

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
