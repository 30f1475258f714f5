/* hawser/integrate.h - time response of a reduced model, and amplitude spectra.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_INTEGRATE_H
#define HAWSER_INTEGRATE_H

#include <hawser/progress.h>
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
	struct hawser_progress progress; /* called after each row */
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
 * Infinite where progress.function ended that run. `options` are those of the trajectory. Statuses as
 * above. */
enum hawser_status hawser_integrate_error(double *error, const struct hawser_trajectory *trajectory,
                                          const struct hawser_rom *rom,
                                          const struct hawser_integrate_options *options,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_trajectory_clear(struct hawser_trajectory *trajectory);

/* What the tension of a run is with the axial waves of a change of the travel speed, which condensed
 * modes do not have. Times are scaled. */
struct hawser_surge {
	double least, most;       /* N, anywhere on the cable during the run */
	double least_at, most_at;
	double error;             /* N, estimate of how far both are off: the waves are linear */
	double spare;             /* N, least of the tension less rho v^2: below 0 the cable travels faster
	                           * than waves run along it across its line, and does not keep its line */
	double spare_at;
	double beyond;            /* N, by which it goes at most beyond the model's own tension of the
	                           * same moment */
};

/* That of `run`, of the model `rom` of a scene whose speed changes (fluctuation or braking), forced
 * at the scaled frequency omega from t = 0 on, where all is at rest but for what run says of the
 * kept modes. Between the rows the model's motion is interpolated, or computed again where they are
 * far apart. A run of more than some thousand crossings of an axial wave is sampled less closely.
 * Statuses: HAWSER_ERR_ARGUMENT (a cable that does not travel, a model from a file or with the
 * exact energy, a run of fewer than two rows), HAWSER_ERR_NAN, HAWSER_ERR_MEMORY. */
enum hawser_status hawser_surge_look(struct hawser_surge *result, const struct hawser_trajectory *run,
                                     const struct hawser_rom *rom,
                                     const struct hawser_statics *statics,
                                     const struct hawser_scene *scene, double omega,
                                     struct hawser_report *report) HAWSER_MUST_CHECK;

/* Largest tension (N), of either sign, that an acceleration*cos(omega t) of the travel speed
 * (m/s^2, rad/s) puts on a straight cable of unstretched `length` (m) with the mass rho (kg/m) and
 * the stiffness EA (N), in steady state without damping: what a model lacks whose other modes stand
 * still. Infinite where omega is an axial natural frequency. */
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
