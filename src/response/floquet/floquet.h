/* response/floquet/floquet.h - hawser_floquet_product without its allocation and checks.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_FLOQUET_H
#define HAWSER_RESPONSE_FLOQUET_H

#include <hawser/orbit.h>

/* Doubles that `work` must hold. */
size_t hawser__floquet_work(int segments, int m);

enum hawser_status hawser__floquet(double *log_modulus, double *argument, double *segment,
                                   int segments, int m, double *work, struct hawser_report *report);

/* Sort [m] by falling modulus; complex pairs stay together. */
void hawser__floquet_sort(double *log_modulus, double *argument, int m);

#endif
