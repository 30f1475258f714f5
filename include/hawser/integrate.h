/* hawser/integrate.h - time response of a reduced model, and amplitude spectra.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_INTEGRATE_H
#define HAWSER_INTEGRATE_H

#include <hawser/progress.h>
#include <hawser/rom.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A time integrator. */
struct hawser_integrate_method {
	const char *name;    /* "gauss", "radau", "adams", "bdf" */
	const char *summary; /* one line, for --help and the man page */
};

/* The methods in order, index from 0; NULL past the last. Static storage. */
const struct hawser_integrate_method *hawser_integrate_method(int index);

struct hawser_integrate_options {
	double omega;      /* scaled forcing frequency; > 0 if the model has harmonics */
	double omega_to;   /* a slow sweep: the frequency changes linearly from omega at `begin` to this
	                    * value at `until`; 0: it is constant. Forces that contain a power of the
	                    * frequency have that of the instant */
	double begin;      /* scaled time of the first row, >= 0. The phase of the forcing at time t is
	                    * omega*t and the integral of the change of the frequency, and a ramp
	                    * begins at t = 0 */
	double until;      /* scaled end time, > begin */
	double every;      /* scaled output interval, > 0 and <= until - begin */
	double rtol, atol; /* local tolerances of u and u', relative and absolute (scaled); 0: 1e-10 and
	                    * 1e-13. 1e-15 <= rtol < 1 */
	const char *method; /* name of a method; NULL or "auto": gauss or radau, chosen during the run;
	                     * radau if a coordinate is damped faster than the fastest one swings */
	const double *initial; /* [2n] u then u' at `begin`; NULL: rest. At rest coordinates that are not
	                        * modes (hawser_rom_inertia) are in steady state under the load, as
	                        * the other modes that are not kept */
	long max_steps;    /* largest number of integrator steps in the whole run; 0: 100 million */
	struct hawser_progress progress; /* called after each row */
};

/* A run. The output times are `begin`, the multiples of `every` between, and `until`. A run that is
 * continued by another one therefore has the same output times as a single run, and in addition the
 * time at which the first run ended. */
struct hawser_trajectory {
	int n, rows;
	double *time;   /* [rows] scaled */
	double *state;  /* [rows][2n] u then u' */
	double *energy; /* [rows] scaled energy; includes the potential of a ramp (rom.h) at that time */
	const char *method; /* name of the method of most of the run; static string */
	long steps, evaluations, jacobians; /* numbers of steps and of evaluations of acceleration and
	                                     * Jacobian by the integrator */
	int interrupted;
};

/* Integrate `rom` from `begin` to `until`. No step of the integrator extends across the end of a ramp,
 * where the equations are not smooth. Release with hawser_trajectory_clear, whatever the status: after
 * HAWSER_ERR_CONVERGENCE (the motion escapes, too many steps) and HAWSER_ERR_NAN the rows before the
 * failure are kept. Other statuses: HAWSER_ERR_ARGUMENT, HAWSER_ERR_MEMORY. */
enum hawser_status hawser_integrate(struct hawser_trajectory *trajectory,
                                    const struct hawser_rom *rom,
                                    const struct hawser_integrate_options *options,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;

/* Phase and frequency of the forcing at time t of a run with these options. */
struct hawser_rom_moment hawser_integrate_moment(const struct hawser_integrate_options *options,
                                                 double t);

/* error [trajectory->rows]: estimated error of the state of each row, relative to the largest state of
 * the run. The estimate is the difference from a second run with smaller tolerances; it never
 * decreases from row to row. It is infinite for the rows after the second run was interrupted.
 * `options` are those of the trajectory. Statuses as above. */
enum hawser_status hawser_integrate_error(double *error, const struct hawser_trajectory *trajectory,
                                          const struct hawser_rom *rom,
                                          const struct hawser_integrate_options *options,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_trajectory_clear(struct hawser_trajectory *trajectory);

/* The extremes of the tension in a run whose travel speed changes, including the axial waves that this
 * change excites. Condensed modes have no such waves, so that the tension of the model omits them.
 * Times are scaled. */
struct hawser_surge {
	double least, most;       /* N, smallest and largest tension anywhere on the cable in the run */
	double least_at, most_at; /* times of these */
	double error;             /* N, estimated error of both, since the waves are linear */
	double spare;             /* N, smallest value of T - rho v^2. Where it is negative, the cable
	                           * travels faster than transverse waves and does not keep its line */
	double spare_at;          /* time of this value */
	double beyond;            /* N, largest excess over the tension of the model at the same time */
};

/* Compute the axial waves of `run`, a run of the model `rom` of a scene whose speed changes
 * (fluctuation or braking), forced at the scaled frequency omega. At t = 0 all modes that are not
 * kept are at rest. Between the rows the motion of the model is interpolated; if the rows are far
 * apart, it is computed again. If the run lasts more than some thousand transits of an axial wave,
 * the tension is sampled at larger intervals. Statuses: HAWSER_ERR_ARGUMENT (a cable that does not
 * travel, a model from a file or with the exact energy, a run of fewer than two rows),
 * HAWSER_ERR_NAN, HAWSER_ERR_MEMORY. */
enum hawser_status hawser_surge_look(struct hawser_surge *result, const struct hawser_trajectory *run,
                                     const struct hawser_rom *rom,
                                     const struct hawser_statics *statics,
                                     const struct hawser_scene *scene, double omega,
                                     struct hawser_report *report) HAWSER_MUST_CHECK;

/* The amplitude (N) of the largest tension that the acceleration `acceleration`*cos(omega t) of the
 * travel speed (m/s^2, rad/s) causes in a straight cable of unstretched `length` (m), mass rho (kg/m)
 * and stiffness EA (N), in steady state without damping. A model without axial modes omits this
 * tension. It is infinite if omega is an axial natural frequency. */
double hawser_surge_steady(double rho, double EA, double length, double acceleration, double omega);

/* A window of whole periods, so that the frequency 1/(dt*period) and its multiples lie on bins. */
struct hawser_spectrum_window {
	int rows;       /* number of samples in the window */
	double periods; /* rows/period: the position of the frequency in bins */
	double off;     /* distance of `periods` from the nearest bin (bin 0 excluded), in bins; 0 to
	                 * round-off if the frequency is on that bin */
	double loss;    /* part of the amplitude of a sine of this frequency that this bin does not show */
};

/* The longest window of at most `most` samples that is a whole number of periods; a period has
 * `period` samples, which need not be a whole number. If there is no such window of most/2 samples or
 * more, the window in this range with the least |off|. */
struct hawser_spectrum_window hawser_spectrum_window(int most, double period);

/* One-sided amplitude spectrum of `rows` equidistant samples `dt` apart (any time unit), after removal
 * of the mean and with a Hann window: *bins bins, frequency[i] in cycles per time unit. The amplitudes
 * are normalised such that a sine of amplitude A on a bin yields A. Both arrays, rows/2 + 1 long, are
 * allocated by the caller.
 * HAWSER_ERR_ARGUMENT (fewer than 4 samples, dt), HAWSER_ERR_NAN, HAWSER_ERR_MEMORY. */
enum hawser_status hawser_spectrum(double *frequency, double *amplitude, int *bins,
                                   const double *samples, int rows, double dt,
                                   struct hawser_report *report) HAWSER_MUST_CHECK;

/* The largest line of this spectrum that is folded (aliased), as its frequency is above the highest
 * one, 1/(2 dt): its *amplitude, and the *frequency at which it appears (cycles per time unit); told by
 * rates[rows], the derivatives of samples[rows] by time. What is left by leakage and errors of the
 * rates is some 1e-4 of the largest line at most; 0: nothing. If the line is folded once, its true
 * frequency is 1/dt - *frequency; if it is folded further, the amplitude is that many times too large.
 * Statuses: as hawser_spectrum. */
enum hawser_status hawser_spectrum_folded(double *amplitude, double *frequency,
                                          const double *samples, const double *rates, int rows,
                                          double dt, struct hawser_report *report) HAWSER_MUST_CHECK;

#ifdef __cplusplus
}
#endif
#endif
