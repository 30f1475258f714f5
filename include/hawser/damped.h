/* hawser/damped.h - complex modes of a cable at rest with dampers.
 *
 * Eigenvalues lambda = re + i im of lambda^2 M + lambda D + K for the cable with its attachments: the
 * dampers (attach) and the damping of the scene. The shapes have kinks at the dampers, so that few
 * functions suffice for any size of the dampers; the error is estimated by a second, smaller basis.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_DAMPED_H
#define HAWSER_DAMPED_H

#include <hawser/modes.h>
#include <hawser/scene.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A damped mode: a pair of complex conjugate eigenvalues. */
struct hawser_damped_mode {
	double omega;    /* scaled damped frequency, the imaginary part of the eigenvalue, > 0 */
	double re;       /* its real part, <= 0 without a wind */
	double ratio;    /* damping ratio, -re/|lambda| */
	double residual; /* estimated error of the eigenvalue over its modulus */
	enum hawser_plane plane; /* of the larger share of the kinetic energy */
	int number;      /* from 1, by damped frequency, among those of its plane */
};

struct hawser_damped {
	int n;            /* number of modes, by ascending omega, both planes together */
	int basis;        /* functions per component */
	int overdamped;   /* real eigenvalues of a modulus up to that of the last mode: motions that
	                   * creep without oscillation */
	double slowest;   /* scaled, the largest of them; 0 if there is none */
	double time_unit; /* d*sqrt(rho/H), s */
	struct hawser_damped_mode *mode; /* [n] */
};

struct hawser_damped_options {
	int n;            /* number of modes, >= 1 */
	double tolerance; /* of the eigenvalues, relative; 0: 1e-8 */
};
void hawser_damped_settle(struct hawser_damped_options *options);

/* Damped modes of the cable at rest. Of the scene, only `damping` and `wind` are read; NULL: dampers
 * alone.
 * *damped is overwritten; release it with hawser_damped_clear. HAWSER_ERR_ARGUMENT (n < 1, a cable
 * that travels, more modes than the largest basis has), HAWSER_ERR_CONVERGENCE (the estimated error
 * exceeds 1e-4), HAWSER_ERR_NO_SOLUTION (inextensible cable), HAWSER_ERR_NAN, HAWSER_ERR_MEMORY. */
enum hawser_status hawser_damped_solve(struct hawser_damped *damped,
                                       const struct hawser_statics *statics,
                                       const struct hawser_scene *scene,
                                       const struct hawser_damped_options *options,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_damped_clear(struct hawser_damped *damped);

/* Damped modes over a key of the scene. */
struct hawser_damped_sweep_options {
	const char *key;     /* such as "attach.0.damper[1]" or "attach.0.at" (hawser_scene_set) */
	const double *value; /* [points] of the key, SI */
	int points;          /* >= 1 */
	int threads;         /* 0: as many as there are processors */
	struct hawser_damped_options modes;
};
/* A value of the key at which the damping of a mode changes its sign. */
struct hawser_damped_event {
	double value;     /* SI */
	double frequency; /* Hz */
	int onset;        /* 1: beyond, in the direction of the sweep, the mode grows; 0: no longer */
	enum hawser_plane plane; /* of struct hawser_damped_mode */
	int number;
};
struct hawser_damped_sweep {
	int points;
	double *value;               /* [points] of the key, SI */
	struct hawser_damped *state; /* [points] */
	int events;
	struct hawser_damped_event *event; /* [events] in the order of the values */
};
/* *sweep is overwritten; release it with hawser_damped_sweep_clear. Statuses of hawser_scene_set,
 * hawser_statics_solve and hawser_damped_solve, with the value in the message. */
enum hawser_status hawser_damped_trace(struct hawser_damped_sweep *sweep,
                                       const struct hawser_scene *scene,
                                       const struct hawser_damped_sweep_options *options,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;
/* The same of anything else, whose damped modes `solve` finds at a value; of the options `key`, which
 * only messages name, and the values. */
struct hawser_damped_source {
	enum hawser_status (*solve)(void *context, struct hawser_damped *damped, double value,
	                            struct hawser_report *report);
	void *context;
};
enum hawser_status hawser_damped_follow(struct hawser_damped_sweep *sweep,
                                        const struct hawser_damped_source *source,
                                        const struct hawser_damped_sweep_options *options,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_damped_sweep_clear(struct hawser_damped_sweep *sweep);

#ifdef __cplusplus
}
#endif
#endif
