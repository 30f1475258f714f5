/* hawser/rom.h - the reduced-order model: modal equations with quadratic and cubic terms.
 *
 *   u_j'' + D_jk u_k' + K_jk u_k + sum Q_jkl u_k u_l + sum C_jklm u_k u_l u_m
 *     = sum over harmonics of Omega^omega_power * cos|sin(k Omega t) * (f_j - D_jk u_k' - K_jk u_k)
 *
 * Everything here is scaled (statics.h) unless the name or comment says SI. Tensors are kept as
 * lists of unique nonzero entries in lexicographic order, k <= l (<= m): a listed value is the
 * whole coefficient of its monomial in equation j.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_H
#define HAWSER_ROM_H

#include <hawser/modes.h>

#ifdef __cplusplus
extern "C" {
#endif

struct hawser_quad {
	int j, k, l; /* k <= l */
	double value;
};

struct hawser_cubic {
	int j, k, l, m; /* k <= l <= m */
	double value;
};

enum hawser_phase { HAWSER_COS = 0, HAWSER_SIN };

struct hawser_harmonic {
	int k; /* >= 1 */
	enum hawser_phase phase;
	int omega_power; /* 0, 1 or 2 */
	double *f;       /* [n], or NULL for none */
	double *D, *K;   /* [n][n] row-major, or NULL */
	/* What the force does to the modes that are not kept, at the shape points and along the line (a
	 * harmonic's answer[0] + (k Omega)^2 answer[1]: the static answer, and what the inertia of that
	 * adds to it), or NULL. It moves the probes and changes the tension; the equations do not have
	 * it. */
	double *answer;      /* [2][points][4] P, Q, B, and the strain a */
	double *answer_line; /* [2][line points] a */
	double *known;       /* [known.modes] force on the known condensed modes, or NULL */
};

/* What changes once and for all: with s = t/time up to t = time and s = 1 from there on, the right side
 * has s, s^2 and ds/dt = 1/time (0 from `time` on) times (f - D u' - K u) of a term each. For
 * _integrate alone: a response that repeats itself has no place for it. */
enum hawser_ramp_power {
	HAWSER_RAMP_LINEAR = 0,
	HAWSER_RAMP_SQUARE,
	HAWSER_RAMP_RATE,
	HAWSER_RAMP_TERMS
};

struct hawser_ramp_term {
	double *f;     /* [n], or NULL for none */
	double *D, *K; /* [n][n] row-major, or NULL */
	/* As of a harmonic, but the static answer alone; or NULL. */
	double *answer;      /* [points][4] */
	double *answer_line; /* [line points] */
};

struct hawser_ramp {
	double time; /* > 0, scaled */
	struct hawser_ramp_term term[HAWSER_RAMP_TERMS];
};

/* What turns coordinates into metres and newtons at a few points of the cable. */
struct hawser_rom_shapes {
	double mach2; /* of struct hawser_motion: what turns the apparent tension into the actual one */
	int points;
	char **name;     /* [points] "quarter", "mid", "three_quarter", ... */
	double *s;       /* [points] scaled arclength */
	double *tangent; /* [points][2] ex, ey of the static profile */
	double *stretch; /* [points] static stretch |x'| */
	double *shape;   /* [n][points][3] P, Q, B */
	double *slope;   /* [n][points][3] a, b, c */
	/* what the condensed modes add, times u_j u_k (half of it for j = k), or NULL: pairs j <= k
	 * stand at k(k+1)/2 + j */
	double *second_shape; /* [n(n+1)/2][points][3] P, Q, B */
	double *second_slope; /* [n(n+1)/2][points][3] a, b, c */
	double EA;       /* N */
};

/* Points along the whole cable at which only the tension is looked at; as struct hawser_rom_shapes. */
struct hawser_rom_line {
	int points;      /* 0 in a model that came from a file */
	double *s;       /* [points] scaled arclength, the ends among them */
	double *stretch; /* [points] */
	double *slope;   /* [n][points][3] a, b, c */
	double *second_slope; /* [n(n+1)/2][points][3], or NULL */
};

/* Condensed modes whose frequency and shape are known. The series in a harmonic's `answer` holds for
 * modes far above the frequency W = k Omega of the force. What it lacks of mode s is the force times
 * H_s = 1/(omega_s^2 - W^2 + i W D_s) - 1/omega_s^2 - W^2/omega_s^4, which is added to displacement and
 * tension, so that the linear response of these modes is exact at every W. */
struct hawser_rom_known {
	int modes;       /* 0 where none is known or excited */
	double *K, *D;   /* [modes] omega_s^2 and damping */
	double *shape;   /* [modes][points][4] P, Q, B, and the strain a, at the shape points */
	double *line;    /* [modes][line points] a; NULL in a model that came from a file */
	double reach;    /* every mode below this frequency (scaled) is a coordinate or known, or has
	                  * no force; 0: not known */
};

/* Coordinates that are no modes: the last ones of a model can be shapes of what the modes that are not
 * kept do to second order (doc/theory-rom.md, "The inertia of what follows"). */
struct hawser_rom_inertia {
	int shapes;   /* so many, the last of n */
	double shift; /* part by which resonances would come out too high without them, at the amplitudes
	               * that load and damping make for, and by which ... */
	double left;  /* ... they do with them; both 0 where that was not looked at */
};

struct hawser_rom {
	int n;
	double *D, *K;             /* [n][n] row-major */
	int quads, cubics;
	struct hawser_quad *Q;     /* [quads] */
	struct hawser_cubic *C;    /* [cubics] */
	int harmonics;
	struct hawser_harmonic *harmonic; /* [harmonics] */
	struct hawser_ramp *ramp;  /* NULL where nothing changes */
	char **label;              /* [n], or NULL */
	double length, time, force; /* units in SI: m, s, N; 1, 1, 1 when scaled is 0 */
	int scaled;                /* whether the units above are known */
	struct hawser_rom_shapes shapes; /* points is 0 when unknown */
	struct hawser_rom_line line;
	struct hawser_rom_known known;
	struct hawser_rom_inertia inertia;
	struct hawser_rom_kernel *kernel; /* compiled form for the hot loops; made by _compile */
	struct hawser_rom_exact *exact;   /* the strain energy itself, in place of K, Q and C in the hot
	                                   * loops; NULL but for _build_exact and _build_full */
};

/* Project the exact strain energy, expanded to fourth order, on all modes of `modes` (doc/theory.md,
 * "The reduced model"); damping and load from the scene, when `scene` is not NULL. Statuses:
 * HAWSER_ERR_ARGUMENT (complex modes), HAWSER_ERR_NO_SOLUTION (inextensible cable), HAWSER_ERR_NAN,
 * HAWSER_ERR_MEMORY. */
enum hawser_status hawser_rom_build(struct hawser_rom *rom, const struct hawser_modes *modes,
                                    const struct hawser_scene *scene,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;

/* The same without Q, C and second-order shapes, for linear questions (linear.h): much cheaper. Where
 * the scene condenses modes, the harmonics have what these make of the load and of the changes of
 * speed. */
enum hawser_status hawser_rom_build_linear(struct hawser_rom *rom, const struct hawser_modes *modes,
                                           const struct hawser_scene *scene,
                                           struct hawser_report *report) HAWSER_MUST_CHECK;

/* Fill rom->known with the modes of `all` that are not kept. `all` is a model of the same scene whose
 * coordinates are the lowest modes of the cable (of _build_linear, or of _build with no second-order
 * shapes); kept[count] are the indices in it of the modes that are coordinates of rom. Does nothing in
 * a model without `answer`. HAWSER_ERR_ARGUMENT (models of different forces or shape points),
 * HAWSER_ERR_MEMORY. */
enum hawser_status hawser_rom_know(struct hawser_rom *rom, const struct hawser_rom *all,
                                   const int *kept, int count,
                                   struct hawser_report *report) HAWSER_MUST_CHECK;

/* The same for a model that _build made of `modes`, the lowest ones of the cable: computes more of
 * them, as many as it takes to have all below `top` (scaled), 100 at the most; rom->known.reach says
 * how far they go, which is to the last of `modes` where more do not converge. Statuses of
 * hawser_modes_solve too. */
enum hawser_status hawser_rom_know_below(struct hawser_rom *rom, const struct hawser_modes *modes,
                                         const struct hawser_scene *scene, double top,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;

/* The strain energy itself, not expanded, on all modes of `modes` and nothing else: K is diag(omega^2),
 * Q and C are empty, and the hot loops below integrate (|q'| - 1)^2/(2 epsilon) over the modes' grid
 * (doc/theory-rom.md, "The full-order model"). Damping and load as above. The model cannot be
 * written to a file or exported. HAWSER_ERR_ARGUMENT (too many modes), HAWSER_ERR_NO_SOLUTION
 * (inextensible cable), HAWSER_ERR_NAN, HAWSER_ERR_MEMORY. */
enum hawser_status hawser_rom_build_exact(struct hawser_rom *rom, const struct hawser_modes *modes,
                                          const struct hawser_scene *scene,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;

/* The same on everything that a basis of `functions` functions a component carries: the full-order
 * model, of about 3*functions coordinates, ascending omega. functions is 1 to 33, 0 stands for 16;
 * for a model of the plane alone, or with planes unlike each other, hawser_modes_basis and the
 * call above do the same. Statuses of these two. */
enum hawser_status hawser_rom_build_full(struct hawser_rom *rom,
                                         const struct hawser_statics *statics,
                                         const struct hawser_scene *scene, int functions,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;

/* Largest relative error that the basis of the full-order model `full` makes in the natural
 * frequencies of `modes` (by a method that converges, on the same statics) up to `to` (scaled), and
 * at least in the first of each plane: *worst is the mode, from 0. INFINITY where the model has no
 * such mode. From 1 on the model says nothing of the cable. */
double hawser_rom_full_error(int *worst, const struct hawser_rom *full,
                             const struct hawser_modes *modes, double to);

/* The reduced-model file (JSON, hawser-rom(5)). Reading checks shapes and indices:
 * HAWSER_ERR_SCENE names file, key and entry, HAWSER_ERR_ARGUMENT says that there is no such
 * file, and HAWSER_ERR_IO that it may not be read. Writing is whole or not at all:
 * HAWSER_ERR_IO. "-" is a standard stream. */
enum hawser_status hawser_rom_open(struct hawser_rom *rom, const char *path,
                                   struct hawser_report *report) HAWSER_MUST_CHECK;
enum hawser_status hawser_rom_save(const struct hawser_rom *rom, const char *path,
                                   struct hawser_report *report) HAWSER_MUST_CHECK;

/* The same as text, of which the caller frees *text: for a result that says more. */
enum hawser_status hawser_rom_text(const struct hawser_rom *rom, char **text,
                                   struct hawser_report *report) HAWSER_MUST_CHECK;

/* AUTO-07p: `stem`.f90 with the same equations and a converged first orbit, c.`stem` with the
 * constants, and the script `stem`.auto, all in stem's folder: `auto-07p stem.auto` follows the
 * frequency response from `from` to `to` (scaled Omega). The last part of `stem` is letters, digits, _
 * and -. HAWSER_ERR_ARGUMENT (options, a model without harmonics), HAWSER_ERR_CONVERGENCE (no first
 * orbit), HAWSER_ERR_IO, HAWSER_ERR_MEMORY. */
struct hawser_auto_options {
	double from, to;   /* scaled Omega, range of the response; the branch starts at `from` */
	double tolerance;  /* EPSL = EPSU; EPSS is 100 times this; 0: 1e-9 */
	int ntst, ncol;    /* mesh intervals and collocation points; 0: 80 and 4 */
	int nmx;           /* points at most; 0: 20000 */
	double ds, dsmax;  /* first and largest step; 0: a 4000th and a 400th of the range */
};
void hawser_auto_settle(struct hawser_auto_options *options);
enum hawser_status hawser_rom_export_auto(const struct hawser_rom *rom, const char *stem,
                                          const struct hawser_auto_options *options,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;

/* After filling a model by hand: merge, sort and check the entries, and make the kernel. The three
 * calls above have done it already. HAWSER_ERR_ARGUMENT names the entry that is out of range. */
enum hawser_status hawser_rom_compile(struct hawser_rom *rom, struct hawser_report *report)
	HAWSER_MUST_CHECK;

void hawser_rom_clear(struct hawser_rom *rom);

/* --- the hot loops: no allocation, no checks. Throughout, the coordinates u and their velocities v,
 * restoring, acceleration and by_omega are [n]; tangent, by_u and by_v are [n][n] row-major --- */

/* restoring [n] = K u + Q u u + C u u u. */
void hawser_rom_restoring(const struct hawser_rom *rom, double *restoring, const double *u);

/* The same with its Jacobian tangent [n][n] = d restoring_j / d u_k. */
void hawser_rom_tangent(const struct hawser_rom *rom, double *restoring, double *tangent,
                        const double *u);

/* Acceleration [n] of the forced model at phase tau = Omega t, for u, v = du/dt [n]. */
void hawser_rom_acceleration(const struct hawser_rom *rom, double *acceleration, const double *u,
                             const double *v, double tau, double omega);

/* The same with its exact derivatives: by u and by v, [n][n] each, and by Omega at fixed tau, [n]. */
void hawser_rom_acceleration_jacobian(const struct hawser_rom *rom, double *acceleration,
                                      double *by_u, double *by_v, double *by_omega,
                                      const double *u, const double *v, double tau, double omega);

/* Whether a harmonic has a force that is not zero; parametric terms do not count. */
int hawser_rom_loaded(const struct hawser_rom *rom);

/* Kinetic plus potential energy (scaled; times force*length in J), without forcing. The potential
 * exists when Q and C come from one; *error receives the largest asymmetry found, relative. */
double hawser_rom_energy(const struct hawser_rom *rom, const double *u, const double *v);
double hawser_rom_asymmetry(const struct hawser_rom *rom);

/* Displacement xyz [3] in global axes (scaled; times length in m) at shape point p, by the
 * coordinates u [n] alone. */
void hawser_rom_displacement(const struct hawser_rom *rom, double *xyz, int p, const double *u);

/* Tension at shape point p, N (SI): from the exact strain |q'| - 1, or to second order in the
 * coordinates where others follow to second order; of a travelling cable the actual one. */
double hawser_rom_tension(const struct hawser_rom *rom, int p, const double *u);

/* *least and *most tension anywhere on the cable, N (SI): at the points of `line`, or at the shape
 * points of a model without. Returns 0 and leaves them alone where the model has neither. */
int hawser_rom_tensions(const struct hawser_rom *rom, double *least, double *most, const double *u);

/* A moment of a forced motion: what the modes that are not kept do follows from it. */
struct hawser_rom_moment {
	double tau, omega; /* phase of the harmonics, and scaled frequency */
	double time;       /* scaled, of a ramp that began at 0; not read in a model without one */
};

/* The same as the three calls above, with the answer of the modes that are not kept to the forces of
 * that moment (`answer` of struct hawser_harmonic and hawser_ramp_term); where the model has none of
 * these, the same numbers. xyz is [3], u [n]; *least and *most are in N. */
void hawser_rom_displacement_at(const struct hawser_rom *rom, double *xyz, int p, const double *u,
                                const struct hawser_rom_moment *moment);
double hawser_rom_tension_at(const struct hawser_rom *rom, int p, const double *u,
                             const struct hawser_rom_moment *moment);
int hawser_rom_tensions_at(const struct hawser_rom *rom, double *least, double *most,
                           const double *u, const struct hawser_rom_moment *moment);

/* d/dt of that displacement, xyz [3], for the coordinates u and velocities v [n]. */
void hawser_rom_velocity_at(const struct hawser_rom *rom, double *xyz, int p, const double *u,
                            const double *v, const struct hawser_rom_moment *moment);

#ifdef __cplusplus
}
#endif
#endif
