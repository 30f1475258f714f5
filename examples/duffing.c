/* examples/duffing.c - a model for hawser frf and integrate: u'' + delta u' + u + eps u^3 = F cos(tau).
 *
 *     cc -shared -fPIC -O2 duffing.c $(pkg-config --cflags hawser) -o duffing.so
 *     hawser frf --model-library ./duffing.so --from 0.5 --to 2 --set eps=0.2
 *     hawser frf --model-library ./duffing.so --over eps=0.02:1 --Omega 1.2
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stddef.h>
#include <hawser/plugin.h>

enum { DELTA, EPS, F, PARAMETERS };
static const char *const name[PARAMETERS] = {"delta", "eps", "F"};
static const double value[PARAMETERS] = {0.05, 0.1, 0.18};

static int acceleration(double *a, double *by_u, double *by_v, double *by_omega, const double *u,
                        const double *v, double tau, double omega, const double *p)
{
	(void)omega;
	a[0] = p[F]*cos(tau) - p[DELTA]*v[0] - u[0] - p[EPS]*u[0]*u[0]*u[0];
	if (by_u) {
		by_u[0] = -1.0 - 3.0*p[EPS]*u[0]*u[0];
		by_v[0] = -p[DELTA];
		by_omega[0] = 0.0;
	}
	return 0;
}

const struct hawser_plugin *hawser_plugin(void)
{
	static const struct hawser_plugin plugin = {HAWSER_PLUGIN_VERSION, 1, PARAMETERS, name, value,
	                                            acceleration, NULL};

	return &plugin;
}
