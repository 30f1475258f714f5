/* hawser/statics.h - the elastic catenary between two fixed ends.
 *
 * Notation (doc/theory.md): x along the span, y up, S unstretched arclength from end A, tension
 * positive. Scaled by length d, force H, time d*sqrt(rho/H): epsilon = H/EA, delta = rho*g*d/H,
 * l = L/d, hs = h/d, eta = vertical over horizontal force at S = 0, u(S) = eta + delta*S.
 *
 * Under a static load the cable hangs in another plane; x and y are then axes of this plane.
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

/* A cable that travels along itself at a constant speed v is equivalent to a cable at rest, called
 * the apparent cable. With m = rho v^2/EA it has the same EA, the mass (1 - m) rho per length
 * S/(1 - m), and the tension A = (1 - m) T - m EA. Shape and motions of the two are the same but
 * for the gyroscopic force 2 nu Phi' du/dt; this is exact, for large motions too
 * (doc/theory-travel.md). Of a fluctuating speed, v + V sin(Omega t), the mean square takes the
 * place of v^2. */
struct hawser_motion {
	double speed, fluctuation; /* v and V, m/s */
	enum hawser_hold hold;
	double mach2;     /* m = rho (v^2 + V^2/2)/EA; 0 at rest */
	double nu, swing; /* v and V scaled: v sqrt(rho/((1 - m) H)) with the apparent H */
	double tension;   /* N, actual tension at S = 0 */
	double tension1;  /* N, actual tension at S = L */
};

/* An attachment on the solved cable; the list is sorted by S. */
struct hawser_attached {
	int index;        /* in the scene's list */
	double S, s;      /* m and scaled: unstretched arclength from end A */
	double mass, m;   /* kg, and scaled: mass/(rho*d) */
	double jump[3];   /* change of the force in the cable, along the axes of its plane, over w*d with
	                   * the static force w per length: (0, m, 0) where only weight acts */
	double spring[3]; /* N/m along x, y, z */
	double damper[3]; /* N s/m along the axes of hawser_statics_damper, */
	int damper_local; /* 1: those of the cable at rest, */
	int damper_to;    /* to the ground (0), or to what end A (1) or B (2) is fixed to */
	/* Of the absorber, whose mass is part of `mass` and `m`: */
	double absorber;           /* its share of m, scaled; 0: none */
	double absorber_stiffness; /* N/m */
	double absorber_damping;   /* N s/m */
	double absorber_cubic;     /* N/m^3 */
	double absorber_axis[3];   /* unit vector along x, y, z */
};

/* An elastic support: springs along x, y and z between the end of the cable and a fixed foundation,
 * and a mass that moves with the end. The ends are at the places of the scene in the state whose
 * tension is given, where the preload of the springs balances the cable; in the other state they have
 * moved by the change of its force over the stiffness. */
struct hawser_held {
	double stiffness[3]; /* N/m, INFINITY: rigid */
	double mass, m;      /* kg, and scaled: mass/(rho*d) */
};

/* Bending stiffness, which acts against changes of the static shape (doc/theory-bending.md). */
struct hawser_bending {
	double EI;          /* N m^2; 0: none */
	double rotation[2]; /* N m: stiffness against rotation at ends A and B; INFINITY: clamped */
};

/* A static solution. Of a travelling cable, span.rho, H, T0, T1, V0, V1, length0, delta, epsilon
 * and lengths S are those of the apparent cable (struct hawser_motion); d, h, shape, sag and
 * `length` are the same for both. */
struct hawser_statics {
	struct hawser_motion motion; /* at rest all zero except for the two tensions */
	struct hawser_span span;
	enum hawser_given given;
	enum hawser_branch branch; /* slack only if T0 or T1 was given and slack was requested */
	double H, T0, T1, V0, V1; /* N; V is the vertical component of the tension along +S */
	double length0, length;   /* m, unstretched and stretched */
	double sag;               /* m, largest distance from the chord along y: the vertical one, but
	                           * for a static load */
	double eta, epsilon, delta, l, hs; /* scaled, see above */
	/* Irvine's lambda, INFINITY for an inextensible cable: `irvine` by the classical definition (0
	 * if a steep cable has a tangent perpendicular to its chord), `irvine_source` by B (4.60), as
	 * in the figures of B */
	double irvine, irvine_source;
	double closure;       /* m, distance of the computed profile from end B; a few units of
	                       * round-off relative to `length` */
	/* estimate of the largest relative round-off error of H, T0, T1, length0, length and sag, for
	 * an exact given quantity and an exact span; 0 for models other than the elastic catenary */
	double error;
	int iterations;
	/* Attachments. Their weights and forces make u(s) jump: u(s) = eta + delta*(s + the sum of jump[1]
	 * with s_i <= s). The two parameters of Irvine and `plausible` are then those of a cable on which
	 * the weights and forces are spread evenly. */
	int attachments;
	struct hawser_attached attached[HAWSER_ATTACH_MAX];
	/* 1 if an end is on springs, set by hawser_statics_hold; if 0, `held` is not set */
	int elastic;
	struct hawser_held held[2]; /* ends A and B */
	struct hawser_bending bending; /* from the scene, by hawser_statics_scene; else 0 */
	/* 1 if the cable hangs in another plane, or upwards, under a static load. All quantities above
	 * are then those in its own plane, whose axes x', y' (against the static force) and z' have the
	 * components axes[0], axes[1] and axes[2] along x, y and z. If `turned` is 0, the axes are x, y
	 * and z, and `axes` is not set. */
	int turned;
	double axes[3][3];
	double swing; /* rad, angle about the chord from the vertical plane to that of the cable,
	               * positive towards z; only if `turned` */
	/* 1 if forces at attachments turn the cable out of one plane: each piece between them is a curve
	 * in a plane of its own, parallel to the static force per length (y'). The axes are still those
	 * of the plane of the chord and this force; H, eta and the scaled quantities are those of the
	 * first piece, H the component of its force across y', azimuth[2] the direction of this component
	 * along x' and z'. The swing is that of the plane of the chord and of all static forces together,
	 * of which Irvine's two parameters are, too. If 0, azimuth is not set. */
	int space;
	double azimuth[2];
	/* of ends on springs that the static load or the change of temperature has moved, set by
	 * hawser_statics_turn; else 0 */
	double moved[2][3]; /* m, of ends A and B along x, y, z: the origin of the axes is where A is */
	double imbalance;   /* N, largest component of spring force plus change of the cable's force */
};

/* A point of the profile, in the plane of the cable. */
struct hawser_profile_point {
	double S;        /* m, unstretched arclength */
	double x, y;     /* m */
	double T;        /* N */
	double slope;    /* dy/dx = u(S); in space the slope within the plane of its piece */
	double z;        /* m; 0 but in space */
	double tangent[3]; /* unit tangent, only in space */
};

/* Solve the span for one given quantity `value` (N or m). The problem is a monotone scalar equation
 * with a bracketed root, in a form without cancellation; the search always converges. Statuses:
 * HAWSER_ERR_ARGUMENT (EA, rho, g, d or value is not positive, or is infinite, which is legal for
 * EA alone; |h| > 1e9 d), HAWSER_ERR_NO_SOLUTION (tension below the minimum, which the message
 * states; an inextensible cable no longer than the chord; results beyond the range of double),
 * HAWSER_ERR_CONVERGENCE (the closure exceeds round-off: a defect of the library). On failure
 * *statics is undefined. */
enum hawser_status hawser_statics_solve(struct hawser_statics *statics,
                                        const struct hawser_span *span, enum hawser_given given,
                                        double value, enum hawser_branch branch,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;

/* The same with `count` attachments attach[count], at most HAWSER_ATTACH_MAX, in any order. Several
 * lengths may have the given H or sag if the cable is steep on both sides of a heavy mass; one of
 * them is found. HAWSER_ERR_ARGUMENT also for attachments outside the cable or at the same point. */
enum hawser_status hawser_statics_loaded(struct hawser_statics *statics,
                                         const struct hawser_span *span, enum hawser_given given,
                                         double value, enum hawser_branch branch,
                                         const struct hawser_attachment *attach, int count,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;

/* The same where the acceleration gravity[3] acts on the masses of the attachments, along the axes
 * (x', y', z') of the plane of the chord and the force per length, and need not be (0, -g, 0) with g
 * of the span; the forces of the attachments are along these axes, too. Unless all act along -y', the
 * cable hangs in space (struct hawser_statics); then HAWSER_ERR_ARGUMENT also for a given H or sag.
 * `turned` and `axes` are left to the caller. */
enum hawser_status hawser_statics_weighted(struct hawser_statics *statics,
                                           const struct hawser_span *span, enum hawser_given given,
                                           double value, enum hawser_branch branch,
                                           const struct hawser_attachment *attach, int count,
                                           const double gravity[3], struct hawser_report *report)
	HAWSER_MUST_CHECK;

/* held[2]: ends A and B of a scene. Returns 1 if one of them is on springs. */
int hawser_statics_held(struct hawser_held *held, const struct hawser_scene *scene);

/* Put the ends of a solved span on springs, or make them rigid again: held[2] for ends A and B, of
 * which the members stiffness and mass are read. The static solution remains as it is; one that is
 * turned becomes one in space, since springs along x, y, z join its planes.
 * HAWSER_ERR_ARGUMENT if a stiffness is not positive, or a mass negative or infinite, or not zero at
 * an end that is rigid in all directions; or if the cable travels. */
enum hawser_status hawser_statics_hold(struct hawser_statics *statics, const struct hawser_held *held,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;

/* Mass of the cable and its attachments over rho*d. */
double hawser_statics_mass(const struct hawser_statics *statics);

/* The span of a scene with its static load and its change of temperature, as a span under its weight
 * in the plane in which it hangs (doc/theory-statics.md), and what gives its tension at rest. Without
 * both it is the span of the scene with the given tension. */
struct hawser_equivalent {
	struct hawser_span span; /* rho with the mass of what adheres; g: static force per length over
	                          * rho; d, h: distance of the ends across and against this force */
	enum hawser_given given; /* if the tension belongs to the reference state: LENGTH0, or, of a
	                          * travelling cable, H or T1 if the scene gives this one */
	double value;            /* N or m */
	enum hawser_branch branch;
	int turned;              /* these three as in struct hawser_statics, but axes is always set */
	double axes[3][3];
	double swing;
	double gravity[3];       /* m/s^2, acceleration of the masses of attachments, along the axes */
	/* 1 if the ends have moved on springs, so that d, h and the axes are those of where they are now */
	int yields;
	double moved[2][3];      /* m, displacements of ends A and B along x, y, z; 0 if `yields` is 0 */
	/* of the springs, not set if `yields` is 0: stiffness, and force of the cable on each support (N,
	 * along x, y, z) where the end is at its place */
	struct hawser_held held[2];
	double preload[2][3];
};

/* Statuses of hawser_statics_solve; HAWSER_ERR_NO_SOLUTION too if the load balances the weight,
 * HAWSER_ERR_ARGUMENT if both together act along the chord, if the temperature leaves no length, or if
 * the scene has attachments that a force per length beside the weight does not allow. */
enum hawser_status hawser_statics_equivalent(struct hawser_equivalent *equal,
                                             const struct hawser_scene *scene,
                                             struct hawser_report *report) HAWSER_MUST_CHECK;

/* The reference state of a scene, at rest: without static load and change of temperature. The same
 * statuses. */
enum hawser_status hawser_statics_reference(struct hawser_statics *statics,
                                            const struct hawser_scene *scene,
                                            struct hawser_report *report) HAWSER_MUST_CHECK;

/* *to: a copy of the scene in load case `index`, with the length of cable of the scene's reference
 * state. It must not be cleared. Statuses of hawser_statics_reference. */
enum hawser_status hawser_statics_case(struct hawser_scene *to, const struct hawser_scene *scene,
                                       int index, struct hawser_report *report) HAWSER_MUST_CHECK;

/* Set turned, axes, swing, moved and imbalance of a solution for equal->span. */
void hawser_statics_turn(struct hawser_statics *statics, const struct hawser_equivalent *equal);

/* Convert a vector [3] in the axes of the cable's plane to one along x, y, z, and back. The two
 * arguments may be the same array. */
void hawser_statics_to_global(const struct hawser_statics *statics, double global[3],
                              const double v[3]);
void hawser_statics_from_global(const struct hawser_statics *statics, double v[3],
                                const double global[3]);

/* The static solution of a scene; of a travelling cable its steady state. Static load and change of
 * temperature are included. */
enum hawser_status hawser_statics_scene(struct hawser_statics *statics,
                                        const struct hawser_scene *scene,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;

/* The steady state of a span that travels at motion->speed and ->fluctuation with ->hold; the other
 * members of *motion are not read. The cable at rest is solved first, for `given`.
 * HAWSER_HOLD_TENSION then keeps the given one of H, T0 and T1, or, if length0 or the sag is given,
 * T0 of the cable at rest. HAWSER_HOLD_LENGTH keeps the unstretched length. At speed 0 the result
 * equals that of hawser_statics_solve to the last bit. Statuses as above; also
 * HAWSER_ERR_NO_SOLUTION if the speed exceeds the limit, which the message states. */
enum hawser_status hawser_statics_travel(struct hawser_statics *statics,
                                         const struct hawser_span *span, enum hawser_given given,
                                         double value, enum hawser_branch branch,
                                         const struct hawser_motion *motion,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;

/* *limit: the speed (m/s) up to which the span has a steady state, without fluctuation. If T0 or T1
 * is held, the apparent tension has there the least value with which the span can hang. If the
 * length or H is held, the limit is sqrt(EA/rho). Statuses of hawser_statics_solve. */
enum hawser_status hawser_statics_limit(double *limit, const struct hawser_span *span,
                                        enum hawser_given given, double value,
                                        enum hawser_branch branch, enum hawser_hold hold,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;

/* The point of the profile at the actual arclength S (m), with the actual tension. */
struct hawser_profile_point hawser_statics_actual_at(const struct hawser_statics *statics, double S);

/* A copy with the actual span.rho, H (horizontal part of the tension at S = 0), T0, T1, V0, V1 and
 * length0, for output. Do not pass it to other functions: they expect the apparent quantities. */
struct hawser_statics hawser_statics_actual(const struct hawser_statics *statics);

/* Profile and tension at S (m, 0..length0). */
struct hawser_profile_point hawser_statics_at(const struct hawser_statics *statics, double S);

/* The same at attachment i, on the side of end A. */
struct hawser_profile_point hawser_statics_before(const struct hawser_statics *statics, int i);

/* *most: the largest n . x over the profile x of a cable in space, n[3] along its axes. */
void hawser_statics_farthest(double *most, const struct hawser_statics *statics, const double n[3]);

/* Scaled geometry of the profile at the scaled arclength s = S/d in [0, l]; at a point mass the limit
 * from the side of end B. */
struct hawser_frame_point {
	double u;         /* eta + delta*s, the slope dy/dx */
	double ex, ey;    /* unit tangent e; n = (-ey, ex) */
	double curvature; /* kappa with respect to the unstretched arclength: e' = kappa*n */
	double strain;    /* epsilon*sqrt(1+u^2), in space epsilon*tension; the static stretch |x'| is
	                   * 1 + strain */
	double tension;   /* T/H */
	/* e, n and the normal of the plane along the axes of the cable; in one plane (ex, ey, 0),
	 * (-ey, ex, 0) and (0, 0, 1) */
	double axis[3][3];
};
struct hawser_frame_point hawser_statics_frame(const struct hawser_statics *statics, double s);

/* Unit vectors along which the dampers of attachment i act: x, y, z, or the local axes, of which at a
 * kink the tangent halves the angle. */
void hawser_statics_damper(double axis[3][3], const struct hawser_statics *statics, int i);

/* --- approximate static models, to be compared with the elastic catenary --- */

/* A static model: its name, a summary of one line, its source, and two functions. Those of the
 * first row, the elastic catenary, are hawser_statics_solve and hawser_statics_at. The other models
 * neglect the stretch: they set span.EA and both of Irvine's parameters to INFINITY and epsilon to
 * 0. `solve` returns the statuses of hawser_statics_solve. */
struct hawser_statics_model {
	const char *name, *summary, *source;
	enum hawser_status (*solve)(struct hawser_statics *statics, const struct hawser_span *span,
	                            enum hawser_given given, double value, enum hawser_branch branch,
	                            struct hawser_report *report);
	/* A point of the profile that `solve` of this row computed, at S (m, 0..length0). */
	struct hawser_profile_point (*at)(const struct hawser_statics *statics, double S);
};
/* Row `index` of the table of static models, from 0, the elastic catenary first; NULL beyond the
 * last. Static storage. */
const struct hawser_statics_model *hawser_statics_model(int index);

/* Errors of a model: its solution compared with the elastic catenary for the same given
 * quantity. */
struct hawser_statics_error {
	double H, T0, T1, length0, length, sag; /* relative errors: model/catenary - 1 */
	double position; /* m, largest vertical distance of the two curves at 201 points */
};
void hawser_statics_compare(struct hawser_statics_error *error,
                            const struct hawser_statics_model *model,
                            const struct hawser_statics *statics,
                            const struct hawser_statics *catenary);

#ifdef __cplusplus
}
#endif
#endif
