/* hawser/net_comparison.h - methods of the statics of nets beside each other, on one net and on random
 * cables.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_NET_COMPARISON_H
#define HAWSER_NET_COMPARISON_H

#include <hawser/net.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A cable between two supports, (0, 0, 0) and (d, h, 0). */
struct hawser_net_random {
	double d, h;        /* m */
	double length0;     /* m */
	double rho, EA, g;  /* kg/m, N, m/s2 */
	int elements;
};
/* Problem `number` of the family `seed`; the same on every machine. d is 1 to 1000 m and |h| at most d,
 * length0/chord - 1 is 1e-3 to 3.2 or (one in five) -1e-4 to -1e-2, rho 0.1 to 30 kg/m, EA over the
 * weight 32 to 1e7, and there are 10 to 100 elements. All but h and elements are uniform in their
 * logarithms. */
struct hawser_net_random hawser_net_random(unsigned seed, unsigned number);
/* This cable as a net. */
enum hawser_status hawser_net_random_open(struct hawser_net *net,
                                          const struct hawser_net_random *cable,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;

#ifdef __cplusplus
}
#endif
#endif
