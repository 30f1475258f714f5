/* hawser/plugin.h - a model in C: the equations of motion as a function in a shared library, which
 * hawser frf and hawser integrate take in place of a scene.
 *
 *     cc -shared -fPIC -O2 duffing.c $(pkg-config --cflags hawser) -o duffing.so
 *     hawser frf --model-library ./duffing.so --from 0.5 --to 2 --set eps=0.1
 *
 * examples/duffing.c is such a library.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_PLUGIN_H
#define HAWSER_PLUGIN_H

#ifdef __cplusplus
extern "C" {
#endif

#define HAWSER_PLUGIN_VERSION 2 /* of 1, which has no `rate`, libraries are taken too */

struct hawser_plugin {
	int version;                  /* HAWSER_PLUGIN_VERSION */
	int n;                        /* coordinates, 1 to 100 */
	int parameters;               /* 0 to 64 */
	const char *const *parameter; /* [parameters] names: a letter, then up to 30 letters, digits, _ */
	const double *value;          /* [parameters] their values unless the user gives others */

	/* u'' = acceleration [n] of the coordinates u [n] with the velocities v [n] at the phase tau =
	 * Omega t, 2 pi periodic in tau; parameter [parameters]. by_u and by_v [n][n] row-major (by_u[j*n +
	 * k] = d acceleration[j]/d u[k]) and by_omega [n] are its derivatives; the last one at fixed tau.
	 * All three are NULL where only the acceleration is asked for, and all zero on entry otherwise.
	 * Several threads may call it at the same time. It returns 0, or another number where there is
	 * no value: a computation that needs it then fails. */
	int (*acceleration)(double *acceleration,                              /* [n] */
	                    double *by_u, double *by_v, double *by_omega,      /* [n][n], [n][n], [n] */
	                    const double *u, const double *v,                  /* [n] */
	                    double tau, double omega, const double *parameter); /* [parameters] */

	/* Instead of it (NULL): equations of first order, u' = rate [n], without an excitation. by_u
	 * [n][n] is its derivative, and bend [n][n] that of by_u v with v fixed: bend[j*n + k] = sum over l
	 * of d by_u[j*n + l]/d u[k] v[l]. All are zero on entry. It returns what `acceleration` does. */
	int (*rate)(double *rate, double *by_u, double *bend,     /* [n], [n][n], [n][n] */
	            const double *u, const double *v,             /* [n] */
	            const double *parameter);                     /* [parameters] */
};

/* The library defines a function without arguments, hawser_plugin, that returns a pointer to a constant
 * struct hawser_plugin, which stays as it is while the library is loaded. */

#ifdef __cplusplus
}
#endif

#endif
