/* hawser/integrate.h - time response of a reduced model, and amplitude spectra.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_INTEGRATE_H
#define HAWSER_INTEGRATE_H

#include <hawser/rom.h>

#ifdef __cplusplus
extern "C" {
#endif

/* One way to integrate; its name is what options.method takes. */
struct hawser_integrate_method {
	const char *name;    /* "gauss", "adams", "bdf" */
	const char *summary; /* one line, for --help and the man page */
};

/* The methods in order, index from 0; NULL past the last. Static storage. */
const struct hawser_integrate_method *hawser_integrate_method(int index);

struct hawser_integrate_options {
	double omega;      /* scaled forcing frequency, > 0 where the model has harmonics */
	double begin;      /* scaled time of the first row, 0 or more: the phase of the forcing there is
	                    * omega*begin, and of a ramp so much is over */
	double until;      /* scaled end time, > begin */
	double every;      /* scaled output interval, > 0 and <= until - begin */
	double rtol, atol; /* local tolerances on u and u', relative and absolute (scaled); 0 stands
	                    * for the defaults, 1e-10 and 1e-13; rtol from 1e-15, below 1 */
	const char *method; /* a name of the table, or NULL or "auto": chosen for the model */
	const double *initial; /* [2n] u then u' at `begin`, or NULL: rest */
	long max_steps;    /* of the integrator, in the whole run; 0 stands for 100 million */
	/* called after each output; nonzero ends the run cleanly with what is there. May be NULL. */
	int (*progress)(void *context, double t, double until);
	void *progress_context;
};

/* A run: one row an output time, which are `begin`, every multiple of `every` between, and
 * `until`. Runs that follow each other have the output times of one that goes through, and those
 * of their ends. */
struct hawser_trajectory {
	int n, rows;
	double *time;   /* [rows] scaled */
	double *state;  /* [rows][2n] u then u' */
	double *energy; /* [rows] scaled; with what a ramp (rom.h) has added to the potential by then */
	const char *method; /* what was used: a name of the table, static */
	long steps, evaluations, jacobians; /* the integrator's cost */
	int interrupted;
};

/* Integrate `rom` at phase Omega t from `begin`; a ramp begins at t = 0, and a step ends where it
 * does. Release with hawser_trajectory_clear whatever the
 * status: after HAWSER_ERR_CONVERGENCE (the motion escapes, too many steps) and HAWSER_ERR_NAN the
 * rows before the failure are kept. Other statuses: HAWSER_ERR_ARGUMENT, HAWSER_ERR_MEMORY. */
enum hawser_status hawser_integrate(struct hawser_trajectory *trajectory,
                                    const struct hawser_rom *rom,
                                    const struct hawser_integrate_options *options,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;

/* error [trajectory->rows]: how far each row's state is from the true one, estimated by integrating
 * again with tighter tolerances; over the run's largest state, and never less than in a row before.
 * Infinite where progress() ended that run. `options` are those of the trajectory. Statuses as
 * above. */
enum hawser_status hawser_integrate_error(double *error, const struct hawser_trajectory *trajectory,
                                          const struct hawser_rom *rom,
                                          const struct hawser_integrate_options *options,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_trajectory_clear(struct hawser_trajectory *trajectory);

/* Part by which a suddenly applied load moves a mode of the damping ratio `ratio` beyond its static
 * answer: 1 without damping. */
double hawser_surge_overshoot(double ratio);

/* Largest tension (N), of either sign, that a change of the travel speed by `change` (m/s), at constant
 * rate within `time` (s), puts on a straight cable of unstretched `length` (m) with the mass rho (kg/m)
 * and the stiffness EA (N), whose first axial mode has the damping ratio `ratio`. With the axial waves
 * of the sudden start that is up to rho times the rate times the length, twice the static answer, and
 * not more than rho times the wave speed times `change`. */
double hawser_surge_ramp(double rho, double EA, double length, double change, double time,
                         double ratio);

/* The same where the cable's acceleration is acceleration*cos(omega t), in steady state without
 * damping: m/s^2, rad/s. A start from rest adds its waves: the overshoot times as much again
 * where omega is low.
 * Infinite where omega is an axial natural frequency. */
double hawser_surge_steady(double rho, double EA, double length, double acceleration, double omega);

/* A window of whole periods, so that a frequency 1/(dt*period) and its multiples are on bins. */
struct hawser_spectrum_window {
	int rows;       /* samples in the window; the one after them would be the first of the next */
	double periods; /* rows/period, so that the frequency is `periods` bins above bin 0 */
	double off;     /* bins from the nearest bin but bin 0; 0 within round-off: on that bin */
	double loss;    /* part of its amplitude that a sine of this frequency lacks on that bin */
};

/* Of at most `most` samples, `period` samples (not necessarily a whole number) to a period: the
 * largest number of samples that is a whole number of periods. Where no number from most/2 to `most`
 * is, the one of these with the least |off|. */
struct hawser_spectrum_window hawser_spectrum_window(int most, double period);

/* One-sided amplitude spectrum of `rows` equidistant samples `dt` apart (any time unit), after a
 * Hann window and removal of the mean: *bins bins, frequency[i] in cycles per time unit, amplitude[i]
 * such that a sine of amplitude A on a bin shows A. Both arrays hold rows/2 + 1; caller-owned.
 * HAWSER_ERR_ARGUMENT (fewer than 4 samples, dt), HAWSER_ERR_NAN, HAWSER_ERR_MEMORY. */
enum hawser_status hawser_spectrum(double *frequency, double *amplitude, int *bins,
                                   const double *samples, int rows, double dt,
                                   struct hawser_report *report) HAWSER_MUST_CHECK;

#ifdef __cplusplus
}
#endif
#endif
