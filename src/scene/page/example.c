/* scene/page/example.c - the complete scene that hawser-scene(5) shows.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "scene/page/schema.h"

const char hawser__scene_example[] =
	"# A chairlift span under a harmonic load on its middle half.\n"
	"g: 9.81 m/s^2\n"
	"cable:   {EA: 400 MN, rho: 6 kg/m}\n"
	"span:    {d: 250 m, h: 10 m}\n"
	"tension: {T0: 80 kN, branch: taut}\n"
	"damping: {alpha: 0.08 kg/m/s}\n"
	"load:\n"
	"  frame: local\n"
	"  per_length: [0.8 N/m, 0.8, 0.8]\n"
	"  extent: [25 %, 75 %]\n"
	"model:   {modes: 5, tolerance: 1e-10}\n";
