/* hawser/net_waves.h - linear response of a net to waves, over the frequency.
 *
 * About the equilibrium of the statics (with its current and contacts) the mesh has the stiffness K,
 * the mass M with the added mass, and the damping C: that of the scene, and linear drag, which for the
 * relative velocity of water and line has the work (regular waves) or the least error (a sea) of the
 * quadratic one. C follows from the response, which follows from C: found by iteration, for the waves
 * of the scene. In regular waves each frequency has its own C, by the height of the scene; a sea has
 * one. Responses are per metre of the amplitude of a wave (doc/waves.md).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_NET_WAVES_H
#define HAWSER_NET_WAVES_H

#include <hawser/net_motion.h>

#ifdef __cplusplus
extern "C" {
#endif

struct hawser_net_waves_options {
	double from, to;    /* rad/s; 0: the end of the sea's range, or 0.5 and 2 times the frequency of
	                     * regular waves */
	int points;         /* from one to the other; 0: 100 */
	const struct hawser_net_probe *probe; /* [probes] */
	int probes;
	double tolerance;   /* of C, relative; 0: 1e-8 */
	int iterations;     /* most; 0: 100 */
	struct hawser_progress progress;
};

/* Amplitudes of displacements and tensions and their phases: displacement(t) = amplitude times
 * cos(omega t - phase), where the wave has its crest at x = z = 0 at t = 0. */
struct hawser_net_waves {
	int points, probes, cables;
	double *omega;      /* [points] rad/s */
	double *spectrum;   /* [points] m^2 s: that of the sea; NULL: regular waves */
	double *x;          /* [points*probes*3] m/m */
	double *phase;      /* [points*probes*3] rad, -pi to pi */
	double *T;          /* [points*cables*2] N/m: at the ends `from` and `to` of cables */
	double *T_phase;    /* [points*cables*2] rad */
	/* Of a sea, standard deviations; of regular waves of the scene's height, the largest amplitudes
	 * over the frequencies. */
	double (*size)[3];  /* [probes] m */
	double (*T_size)[2]; /* [cables] N */
	double *T_mean;     /* [cables*2] N, of the equilibrium */
	void *held; /* memory of the arrays */
	double height;      /* m: the height, or Hs, that C belongs to */
	int iterations;     /* most of a point */
	double change;      /* largest relative change of C in the last iteration */
	int unknowns, touching; /* of the mesh; contacts, which stay */
	int interrupted;    /* 1: the caller ended it; `points` are those that there are */
};
/* Overwrites *waves; release it with hawser_net_waves_clear. HAWSER_ERR_ARGUMENT without waves, or with
 * damping by modes, harmonic loads or moving supports, which the response does not have; statuses of
 * the statics; HAWSER_ERR_CONVERGENCE. */
enum hawser_status hawser_net_waves_solve(struct hawser_net_waves *waves, const struct hawser_net *net,
                                          const struct hawser_net_waves_options *options,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_net_waves_clear(struct hawser_net_waves *waves);

#ifdef __cplusplus
}
#endif
#endif
