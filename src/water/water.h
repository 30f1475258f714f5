/* water/water.h - what nets need of the water. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_WATER_WATER_H
#define HAWSER_WATER_WATER_H

#include <hawser/water.h>

/* The current at a height y (m), and its derivative u_y[3] (1/s). */
void hawser__water_current(double u[3], double u_y[3], const struct hawser_water *water, double y);

#endif
