/* hawser/rom.h - the reduced-order model: modal equations with quadratic and cubic terms.
 *
 *   u_j'' + D_jk u_k' + K_jk u_k + sum Q_jkl u_k u_l + sum C_jklm u_k u_l u_m + terms
 *     = sum over harmonics of Omega^omega_power * cos|sin(k Omega t)
 *       * (f_j - D_jk u_k' - K_jk u_k - sum Q_jkl u_k u_l - terms)
 *
 * Terms are products of any coordinates and velocities. Models of cables have them in a wind only.
 *
 * Everything here is scaled (statics.h) unless the name or comment says SI. Tensors are kept as
 * lists of unique nonzero entries in lexicographic order, k <= l (<= m): a listed value is the
 * whole coefficient of its monomial in equation j.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_H
#define HAWSER_ROM_H

#include <stdio.h>

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

enum { HAWSER_TERM_FACTORS = 9 };
/* value times the product of the coordinates factor[0 .. factors - rates - 1] and of the velocities of
 * the coordinates factor[factors - rates .. factors - 1], in equation j. */
struct hawser_term {
	int j;
	int factors, rates;              /* 1 to HAWSER_TERM_FACTORS; 0 to factors */
	int factor[HAWSER_TERM_FACTORS]; /* indices of coordinates */
	double value;
};

enum hawser_phase { HAWSER_COS = 0, HAWSER_SIN };

struct hawser_harmonic {
	int k; /* >= 0; 0, of phase HAWSER_COS: the term is constant, and has no D if omega_power is 0 */
	enum hawser_phase phase;
	int omega_power; /* 0 to 3; 0 if there is a Q */
	int load_power;  /* power of the load factor (folds.h, map.h) that multiplies the term; 0: 1 */
	double *f;       /* [n], or NULL for none */
	double *D, *K;   /* [n][n] row-major, or NULL */
	int quads;
	struct hawser_quad *Q; /* [quads], or NULL */
	int terms;
	struct hawser_term *term; /* [terms], or NULL */
	/* The displacement and the strain that the force causes in the modes that are not kept, at the
	 * shape points and along the line, or NULL: answer[0] + (k Omega)^2 answer[1], the static
	 * response and the first correction for inertia. They change probes and tension only, not the
	 * equations. */
	double *answer;      /* [2][points][4] P, Q, B, and the strain a */
	double *answer_line; /* [2][line points] a */
	double *known;       /* [known.modes] force on the known condensed modes, or NULL */
};

/* Forces that change once. With s = t/time up to t = time and s = 1 afterwards, the right side has
 * the factors s, s^2 and ds/dt (1/time, then 0), each times (f - D u' - K u) of its term. Only
 * hawser_integrate reads them, since a model with a ramp has no periodic response. */
enum hawser_ramp_power {
	HAWSER_RAMP_LINEAR = 0,
	HAWSER_RAMP_SQUARE,
	HAWSER_RAMP_RATE,
	HAWSER_RAMP_TERMS
};

struct hawser_ramp_term {
	double *f;     /* [n], or NULL for none */
	double *D, *K; /* [n][n] row-major, or NULL */
	/* As in struct hawser_harmonic, but the static response only; or NULL. */
	double *answer;      /* [points][4] */
	double *answer_line; /* [line points] */
	int quads;           /* 0 but in a history */
	struct hawser_quad *Q; /* [quads]: - Q u u beside - K u; or NULL */
};

struct hawser_ramp {
	double time; /* > 0, scaled */
	struct hawser_ramp_term term[HAWSER_RAMP_TERMS];
};

/* Shapes that convert coordinates to displacements in metres and tensions in newtons at a few
 * points of the cable. */
struct hawser_rom_shapes {
	double mach2; /* of struct hawser_motion: converts the apparent tension to the actual one */
	int points;
	char **name;     /* [points] "quarter", "mid", "three_quarter", ... */
	double *s;       /* [points] scaled arclength */
	double *tangent; /* [points][2] ex, ey of the static profile */
	double *stretch; /* [points] static stretch |x'| */
	double *shape;   /* [n][points][3] P, Q, B */
	double *slope;   /* [n][points][3] a, b, c */
	/* the contribution of the condensed modes, which is multiplied by u_j u_k (by half of it if j =
	 * k), or NULL. The pair j <= k has the index k(k+1)/2 + j */
	double *second_shape; /* [n(n+1)/2][points][3] P, Q, B */
	double *second_slope; /* [n(n+1)/2][points][3] a, b, c */
	double EA;       /* N */
	int turned;      /* of struct hawser_statics; 0: the axes of the cable are x, y, z */
	double axes[3][3];
};

/* Points along the whole cable, at which only the tension is evaluated; members as in struct
 * hawser_rom_shapes. */
struct hawser_rom_line {
	int points;      /* 0 if the model was read from a file */
	double *s;       /* [points] scaled arclength, including both ends */
	double *stretch; /* [points] */
	double *slope;   /* [n][points][3] a, b, c */
	double *second_slope; /* [n(n+1)/2][points][3], or NULL */
};

/* The sheaves on which the rope of a model lies (line_rom.h). The angle of contact of sheave i is,
 * relative to that at rest, 1 + sum_j turn[j][i] u_j by the linear motion; at 0 the rope leaves. */
struct hawser_rom_contacts {
	int count;       /* 0: none */
	char **name;     /* [count] */
	double *turn;    /* [n][count] */
};

/* Forces with a given history (hawser integrate --load, --motion): at the time t the sum over the terms
 * of factor(t) (f - D u' - K u - Q u u). A factor is a signal, a derivative of one by the scaled time,
 * or a product of signals; a signal is the cubic spline through given values. */
struct hawser_history_factor {
	int count;     /* of signals that are multiplied, 1 to 3 */
	int signal[3];
	int rate;      /* 0 to 2: derivative; 0 if several are multiplied */
};

struct hawser_history_signal {
	int rows;      /* 0: not given yet, or not used */
	double *time;  /* [rows] scaled, ascending */
	double *value; /* [rows] */
	double *bend;  /* [rows] second derivatives of the spline */
};

enum { HAWSER_MOTION_SIGNALS = 6 }; /* displacements of end B relative to A, and of A */

struct hawser_rom_history {
	int terms;
	struct hawser_ramp_term *term;        /* [terms] forces of the factor 1 */
	struct hawser_history_factor *factor; /* [terms] */
	int signals;
	struct hawser_history_signal *signal; /* [signals] */
	int moves;     /* 1: the first HAWSER_MOTION_SIGNALS signals are those of moving ends */
	int motions;   /* of the terms, the first ones: by moving ends */
	/* signal i = sum of weight[i][3*end + axis] times the displacement of the end along that axis */
	double weight[HAWSER_MOTION_SIGNALS][6];
};

/* Condensed modes whose frequency and shape are known. The series in `answer` of a harmonic is
 * valid for modes far above the frequency W = k Omega of the force. For mode s it omits the force
 * times H_s = 1/(omega_s^2 - W^2 + i W D_s) - 1/omega_s^2 - W^2/omega_s^4. This is added to
 * displacement and tension, so that the linear response of these modes is exact at every W. */
struct hawser_rom_known {
	int modes;       /* 0 if no mode is known or excited */
	double *K, *D;   /* [modes] omega_s^2 and damping */
	double *shape;   /* [modes][points][4] P, Q, B, and the strain a, at the shape points */
	double *line;    /* [modes][line points] a; NULL if the model was read from a file */
	double reach;    /* each mode below this scaled frequency is a coordinate, is known, or has no
	                  * force; 0: not known */
};

/* Coordinates that are not modes. The last coordinates of a model can be second-order shapes:
 * motions of the condensed modes that products of the kept coordinates cause, and whose inertia
 * matters (doc/theory-rom.md, "The inertia of what follows"). */
struct hawser_rom_inertia {
	int shapes;   /* number of these coordinates, the last of n */
	double shift; /* relative error of the resonance frequencies without these coordinates, at the
	               * amplitudes that load and damping cause, and */
	double left;  /* with them; both 0 if not estimated */
};

struct hawser_rom {
	int n;
	double *D, *K;             /* [n][n] row-major */
	int quads, cubics;
	struct hawser_quad *Q;     /* [quads] */
	struct hawser_cubic *C;    /* [cubics] */
	int terms;
	struct hawser_term *term;  /* [terms] or NULL. A model with terms, here or in harmonics, is only
	                            * for integration, periodic orbits and exports; what else takes models
	                            * refuses it */
	int harmonics;
	struct hawser_harmonic *harmonic; /* [harmonics] */
	struct hawser_ramp *ramp;  /* NULL if nothing changes once */
	struct hawser_rom_history *history; /* NULL if there is none; for integration only */
	struct hawser_rom_ends *ends; /* displacement and strain by given motions of the ends; or NULL */
	char **label;              /* [n], or NULL */
	double length, time, force; /* units in SI: m, s, N; 1, 1, 1 if `scaled` is 0 */
	int scaled;                /* 1: the units above are known */
	struct hawser_rom_shapes shapes; /* 0 points if unknown */
	struct hawser_rom_line line;
	struct hawser_rom_contacts contacts;
	struct hawser_rom_known known;
	struct hawser_rom_inertia inertia;
	struct hawser_rom_range *range; /* [n], found by hawser_law_range; NULL of models that have none */
	struct hawser_rom_kernel *kernel; /* compiled form for the hot loops; made by _compile */
	struct hawser_rom_drag *drag;     /* quadratic drag, or the exact force of a wind; motions and
	                                   * responses have it, and what cannot refuses it. Or NULL */
	double *mass;              /* [n][n] by whose inverse the equations of a file were multiplied, for
	                            * the energy; NULL: the unit matrix */
	struct hawser_rom_plug *plug; /* forces by a function, besides; or NULL */
	double *carried;           /* [n][n]: coordinate j of the modes is the sum of carried[j*n + e] u_e,
	                            * where shapes that carry the inertia of what follows take their places;
	                            * or NULL */
	int periods;               /* b: Omega in the equations above is a b-th part of the frequency that
	                            * hawser_frf_trace, hawser_sweep_run and hawser_integrate are given,
	                            * whose motions have b of its periods; 0: 1. What else has loads
	                            * refuses it */
	int base;                  /* the load's frequency is this multiple of Omega; 0: 1. Only for plug */
	struct hawser_rom *first;  /* of a file of equations u' = g(u, tau): the model u'' = g, from which
	                            * initial velocities follow; NULL for others */
	struct hawser_rom_exact *exact;   /* strain energy without expansion, in place of K, Q and C in
	                                   * the hot loops; NULL except in models of _build_exact and
	                                   * _build_full */
};

/* Project the strain energy, expanded to fourth order, on all modes of `modes` (doc/theory-rom.md).
 * Damping and load are taken from `scene` unless it is NULL. Statuses: HAWSER_ERR_ARGUMENT (complex
 * modes), HAWSER_ERR_NO_SOLUTION (inextensible cable), HAWSER_ERR_NAN, HAWSER_ERR_MEMORY. */
enum hawser_status hawser_rom_build(struct hawser_rom *rom, const struct hawser_modes *modes,
                                    const struct hawser_scene *scene,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;

/* The same for a model that is only written: its forces cannot be evaluated before hawser_rom_compile,
 * which takes most of the memory and time of a model of many modes. The same statuses. */
enum hawser_status hawser_rom_build_entries(struct hawser_rom *rom,
                                            const struct hawser_modes *modes,
                                            const struct hawser_scene *scene,
                                            struct hawser_report *report) HAWSER_MUST_CHECK;

/* The same without Q, C and second-order shapes, which is much cheaper, for linear questions
 * (linear.h). If the scene condenses modes, the parametric terms of the harmonics include the
 * response of these modes to the load and to the changes of speed. */
enum hawser_status hawser_rom_build_linear(struct hawser_rom *rom, const struct hawser_modes *modes,
                                           const struct hawser_scene *scene,
                                           struct hawser_report *report) HAWSER_MUST_CHECK;

/* Fill rom->known with the modes of `all` that are not kept. `all` is a model of the same scene
 * whose coordinates are the lowest modes of the cable (from _build_linear, or from _build without
 * second-order shapes). kept[count] are the indices, in `all`, of the modes that are coordinates of
 * rom. A model without `answer` is not changed. HAWSER_ERR_ARGUMENT (models with different forces
 * or shape points), HAWSER_ERR_MEMORY. */
enum hawser_status hawser_rom_know(struct hawser_rom *rom, const struct hawser_rom *all,
                                   const int *kept, int count,
                                   struct hawser_report *report) HAWSER_MUST_CHECK;

/* The same for a model that _build made of `modes`, the lowest modes of the cable. Further modes
 * are computed until all below `top` (scaled) are known, at most 100. rom->known.reach is the
 * frequency up to which all are known; if further modes do not converge, it is that of the last of
 * `modes`. Statuses of hawser_modes_solve too. */
enum hawser_status hawser_rom_know_below(struct hawser_rom *rom, const struct hawser_modes *modes,
                                         const struct hawser_scene *scene, double top,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;

/* A model with the strain energy without expansion, with all modes of `modes` as coordinates: K is
 * diag(omega^2), Q and C are empty, and the hot loops below integrate (|q'| - 1)^2/(2 epsilon) over
 * the grid of the modes (doc/theory-rom.md, "The full-order model"). Damping and load as above. The
 * model cannot be written to a file or exported. HAWSER_ERR_ARGUMENT (too many modes),
 * HAWSER_ERR_NO_SOLUTION (inextensible cable), HAWSER_ERR_NAN, HAWSER_ERR_MEMORY. */
enum hawser_status hawser_rom_build_exact(struct hawser_rom *rom, const struct hawser_modes *modes,
                                          const struct hawser_scene *scene,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;

/* The full-order model: the same with all modes of a basis of `functions` functions per component,
 * about 3*functions coordinates by ascending omega. functions is 1 to 33; 0: 16, up to 24 where the
 * load needs them (hawser_rom_full_lacks), or 24 with bending stiffness, whose elements resolve the
 * layers at held ends. For a model of the plane only, or with different numbers of functions in and
 * out of the plane, call hawser_modes_basis and hawser_rom_build_exact. Statuses of these two. */
enum hawser_status hawser_rom_build_full(struct hawser_rom *rom,
                                         const struct hawser_statics *statics,
                                         const struct hawser_scene *scene, int functions,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;

/* *lacks (scalar): the part of the static response to the scene's varying load, of its energy, that the
 * basis of a full-order model lacks against the largest; 0 without a load. Statuses of
 * hawser_modes_basis; HAWSER_ERR_SCENE. */
enum hawser_status hawser_rom_full_lacks(double *lacks, const struct hawser_statics *statics,
                                         const struct hawser_scene *scene, int functions,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;

/* Largest relative error of the natural frequencies of the full-order model `full`, due to its
 * basis. `modes` are reference modes of the same statics by a method that converges. Compared are
 * the modes up to the scaled frequency `to`, and at least the first of each plane; *worst is the
 * index of the worst. INFINITY if the model has no such mode. A model with an error of 1 or more
 * does not describe the cable. */
double hawser_rom_full_error(int *worst, const struct hawser_rom *full,
                             const struct hawser_modes *modes, double to);

/* A model of a file in the coordinates of its own modes, which must be real: K becomes diagonal, and
 * the old coordinate j is the sum over i of V[j*n + i] q_i, V [n][n] with V' M V = 1.
 * HAWSER_ERR_ARGUMENT (K is not symmetric, the model has terms, functions, shapes or more than 24
 * coordinates), HAWSER_ERR_CONVERGENCE (the mass is not positive definite), HAWSER_ERR_MEMORY; the
 * model is then to be cleared. */
enum hawser_status hawser_rom_modal(struct hawser_rom *rom, double *V,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;

/* The largest entry of K off the diagonal, over the largest on it: up to 1e-12 K is diagonal for what
 * needs modes. */
double hawser_rom_off_diagonal(const struct hawser_rom *rom);

/* Read and write the reduced-model file (JSON, hawser-rom(5)). "-" is a standard stream. Reading
 * checks shapes and indices: HAWSER_ERR_SCENE with file, key and entry, HAWSER_ERR_ARGUMENT if the
 * file does not exist, HAWSER_ERR_IO if it cannot be read. If writing fails (HAWSER_ERR_IO), no
 * file is left. */
enum hawser_status hawser_rom_open(struct hawser_rom *rom, const char *path,
                                   struct hawser_report *report) HAWSER_MUST_CHECK;
enum hawser_status hawser_rom_save(const struct hawser_rom *rom, const char *path,
                                   struct hawser_report *report) HAWSER_MUST_CHECK;

/* The members of the JSON object in such a file, without its braces, for the outermost object of
 * another JSON file: each on a line after the first, as are the entries of their lists. With
 * stream NULL the model is only checked, so that a caller can refuse it before writing anything.
 * Nothing of the model is copied. HAWSER_ERR_NAN if a number is not finite, HAWSER_ERR_ARGUMENT for
 * a model with the
 * exact strain energy; errors of the stream are left to the caller (ferror). */
enum hawser_status hawser_rom_write_members(const struct hawser_rom *rom, FILE *stream,
                                            struct hawser_report *report) HAWSER_MUST_CHECK;

/* The text of such a file, to be included in another one; the caller frees *text. */
enum hawser_status hawser_rom_text(const struct hawser_rom *rom, char **text,
                                   struct hawser_report *report) HAWSER_MUST_CHECK;

/* Export to AUTO-07p: `stem`.f90 with the equations and a converged first orbit, c.`stem` with the
 * constants, and the script `stem`.auto. The command `auto-07p stem.auto`, run in the folder of the
 * files, follows the frequency response from `from` to `to` (scaled Omega). The last part of `stem`
 * consists of letters, digits, _ and -. HAWSER_ERR_ARGUMENT (options, a model without harmonics),
 * HAWSER_ERR_CONVERGENCE (no first orbit), HAWSER_ERR_IO, HAWSER_ERR_MEMORY. */
struct hawser_auto_options {
	double from, to;   /* scaled Omega, range of the response; the branch starts at `from` */
	double tolerance;  /* EPSL = EPSU; EPSS is 100 times this; 0: 1e-9 */
	int ntst, ncol;    /* mesh intervals and collocation points; 0: 80 and 4 */
	int nmx;           /* largest number of points; 0: 20000 */
	double ds, dsmax;  /* first and largest step; 0: a 4000th and a 400th of the range */
};
void hawser_auto_settle(struct hawser_auto_options *options);
enum hawser_status hawser_rom_export_auto(const struct hawser_rom *rom, const char *stem,
                                          const struct hawser_auto_options *options,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;

/* Programs for which equations are written: row `index`, from 0; NULL beyond the last. */
struct hawser_export_format {
	const char *name, *program, *suffix; /* "coco", "COCO", ".m" */
};
const struct hawser_export_format *hawser_export_format(int index);

/* Export to another program than AUTO-07p: the file `stem` with the format's suffix has the right side
 * and its exact derivatives, as functions of states and of Omega and a load factor. The last part of
 * `stem` names a function. Terms are written too. HAWSER_ERR_ARGUMENT (format, name, model),
 * HAWSER_ERR_IO, HAWSER_ERR_MEMORY. */
enum hawser_status hawser_rom_export(const struct hawser_rom *rom, const char *format,
                                     const char *stem, struct hawser_report *report) HAWSER_MUST_CHECK;

/* To be called after filling a model by hand: merges, sorts and checks the entries, and makes the
 * kernel. The functions above that make or read a model call it. HAWSER_ERR_ARGUMENT names the
 * entry that is out of range. */
enum hawser_status hawser_rom_compile(struct hawser_rom *rom, struct hawser_report *report)
	HAWSER_MUST_CHECK;

/* Give the model forces with a history, in place of earlier ones but for those of moving ends. unit
 * [terms] are models of the same modes, each of which has a load of value 1 as its only harmonic; what
 * is needed of them is copied. value [terms][rows] are the loads at the scaled times time [rows],
 * which ascend.
 * HAWSER_ERR_ARGUMENT, HAWSER_ERR_NAN, HAWSER_ERR_MEMORY. */
enum hawser_status hawser_rom_history_set(struct hawser_rom *rom,
                                          const struct hawser_rom *const *unit, int terms,
                                          const double *time, const double *value, int rows,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;

/* Displacements of the ends (or of the foundations of their springs) over time. */
struct hawser_rom_motion {
	int rows;
	const double *time;     /* [rows] scaled, ascending */
	const double *value[6]; /* [rows] each: along x, y and z of end A, then of end B, in lengths of the
	                         * model (rom.length); NULL: at rest */
};

/* The motion of a model that was built with `given` of scene.support (before that it cannot be
 * integrated), in place of an earlier one. The displacements must be those that are given there.
 * HAWSER_ERR_ARGUMENT, HAWSER_ERR_NAN, HAWSER_ERR_MEMORY. */
enum hawser_status hawser_rom_motion_set(struct hawser_rom *rom,
                                         const struct hawser_rom_motion *motion,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;

/* Scaled speed of the ends at a scaled time of their table, the faster one; 0 if it is below a
 * hundredth of the largest one at its rows, or there is no table. */
double hawser_rom_motion_speed(const struct hawser_rom *rom, double time);

void hawser_rom_clear(struct hawser_rom *rom);

/* --- the hot loops: no allocation, no checks. Throughout, the coordinates u and their velocities v,
 * restoring, acceleration and by_omega are [n]; tangent, by_u and by_v are [n][n] row-major --- */

/* restoring [n] = K u + Q u u + C u u u. */
void hawser_rom_restoring(const struct hawser_rom *rom, double *restoring, const double *u);

/* The same with its Jacobian tangent [n][n] = d restoring_j / d u_k. */
void hawser_rom_tangent(const struct hawser_rom *rom, double *restoring, double *tangent,
                        const double *u);

/* Acceleration [n] of the forced model at phase tau = Omega t, for the coordinates u and velocities
 * v = du/dt [n]. */
void hawser_rom_acceleration(const struct hawser_rom *rom, double *acceleration, const double *u,
                             const double *v, double tau, double omega);

/* The same with its exact derivatives: by u and by v, [n][n] each, and by Omega at fixed tau, [n]. */
void hawser_rom_acceleration_jacobian(const struct hawser_rom *rom, double *acceleration,
                                      double *by_u, double *by_v, double *by_omega,
                                      const double *u, const double *v, double tau, double omega);

/* 1: nothing in the model depends on time: there is nothing with a harmonic above 0. */
int hawser_rom_autonomous(const struct hawser_rom *rom);

/* 1: a harmonic has a force that is not zero; parametric terms do not count. */
int hawser_rom_loaded(const struct hawser_rom *rom);

/* _energy: kinetic plus potential energy without forcing (scaled; times force*length in J). The
 * potential exists if Q and C derive from one. _asymmetry: the largest relative difference of
 * coefficients that should then agree. */
double hawser_rom_energy(const struct hawser_rom *rom, const double *u, const double *v);
double hawser_rom_asymmetry(const struct hawser_rom *rom);

/* One line about what forces are evaluated from: the tensors, the strains of the modes at points of the
 * cable ("functions"; the same energy, in less time if there are many modes), or each of them where it
 * is estimated to be faster. text: of `size` bytes, 240 are enough; "" for a model of
 * _build_entries. */
void hawser_rom_forces_text(const struct hawser_rom *rom, char *text, size_t size);

/* Displacement xyz [3] of shape point p in global axes (scaled; times length in m), from the
 * coordinates u [n] only. */
void hawser_rom_displacement(const struct hawser_rom *rom, double *xyz, int p, const double *u);

/* Tension at shape point p, N (SI), from the strain |q'| - 1; if the model has condensed modes,
 * from its expansion to second order in the coordinates. If the cable travels, it is the actual
 * tension. */
double hawser_rom_tension(const struct hawser_rom *rom, int p, const double *u);

/* Smallest and largest tension anywhere on the cable, N (SI): at the points of `line`, or at the
 * shape points if the model has no line. Returns 1; or 0 if the model has neither, and *least and
 * *most are not changed. */
int hawser_rom_tensions(const struct hawser_rom *rom, double *least, double *most, const double *u);

/* An instant of a forced motion, from which the response of the modes that are not kept follows. */
struct hawser_rom_moment {
	double tau, omega; /* phase of the harmonics, and scaled frequency */
	double time;       /* scaled; a ramp begins at 0. Not read if the model has neither a ramp nor a
	                    * history */
};

/* The same as the three functions above, including the response of the modes that are not kept to
 * the forces at that instant (`answer` of struct hawser_harmonic and hawser_ramp_term) and, to second
 * order, the motion of the ends. The results are identical if the model has neither. xyz is [3], u [n];
 * *least and *most are in N. */
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
