/* hawser/net_rom.h - the nonlinear response of a net: its modes as the coordinates of a reduced model
 * (rom.h), with the harmonic loads of nodes and cables and the harmonic motions of supports.
 *
 * The strain energy of all elements to fourth order, and the static response of the modes that are not
 * kept, are in the tensors Q and C; what the load makes of these modes is in the energy too, and in
 * `answer` and `known` of its harmonics (doc/theory-rom.md, "Nets"). A model is that of a net that
 * stays taut, without obstacles. In water it has the whole force of a current and of a regular wave of
 * its frequency Omega, as a function (doc/waves.md). What is left of the error by the length of the
 * elements is of fourth order: models of the mesh, with a multiple of 8 elements a cable, and of one
 * with half as many are extrapolated. Where the modes of the two meshes are not alike, which takes a
 * cable of few elements for its modes, the model is of the first mesh alone, and that error is of
 * second order.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_NET_ROM_H
#define HAWSER_NET_ROM_H

#include <hawser/damped.h>
#include <hawser/net_motion.h>
#include <hawser/rom.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { HAWSER_NET_ROM_MODES = 60 }; /* most coordinates of a model */

struct hawser_net_rom_options {
	int n;              /* the lowest modes; 0: 6, and those whose frequency is that of the last one
	                     * within 1 % */
	const int *kept;    /* [count] indices of those that are coordinates, ascending; NULL: all. The
	                     * others follow */
	int count;
	int raw;            /* 1: of one mesh, without extrapolation: for comparison */
	int condensed;      /* 1: without coordinates for the inertia of what follows */
	int bare;           /* 1: the same, and the static response to the load of the modes that are not
	                     * kept changes the stiffness alone, without a field of the energy: for
	                     * comparison */
	int linear;         /* 1: K and D alone, of small motions; not compiled */
	int *alone;         /* [1] or NULL: becomes 1 where the model is of one mesh though `raw` is 0,
	                     * else 0 */
};

/* A model, and in *modes n, mode and time_unit of its coordinates. The frequency Omega of the model is
 * that of the loads whose multiple is 1, or the lowest one of loads with given frequencies, of which
 * the others must be multiples. Shape points are the nodes that move, by their names, and on each
 * cable "NAME_mid" and, of at most two cables, "NAME_quarter" and "NAME_three_quarter"; displacements
 * are along x, y, z. Both are overwritten; release them with hawser_rom_clear and hawser_modes_clear.
 * Statuses of hawser_net_modes_solve; HAWSER_ERR_ARGUMENT also for obstacles, frequencies that are not
 * multiples of one (of the waves, if there are), motions by tables, seas and currents over time. */
enum hawser_status hawser_net_rom_build(struct hawser_rom *rom, struct hawser_modes *modes,
                                        const struct hawser_net *net,
                                        const struct hawser_net_rom_options *options,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;

/* Damped modes of the net about its equilibrium, in the wind or a current too; release with
 * hawser_damped_clear.
 * `basis` is the number of modes without damping that they are sums of. Statuses of
 * hawser_net_rom_build, HAWSER_ERR_CONVERGENCE. */
enum hawser_status hawser_net_damped_solve(struct hawser_damped *damped, const struct hawser_net *net,
                                           int n, struct hawser_report *report) HAWSER_MUST_CHECK;

/* A motion of a model, as a motion of the whole net. */
struct hawser_net_rom_motion {
	const double *u;     /* [rows][n] coordinates at equal phases of the motion, from 0 */
	int rows;
	int periods;         /* of the load in one of the motion */
	double duration;     /* s, of a period of the motion */
	/* Called for each row, without T; not 0 ends it. */
	int (*frame)(void *data, const struct hawser_net_frame *frame);
	void *data;
};

/* The mesh in a motion of the model with these options: coordinates, what follows them to second order,
 * and the static response to the load; what the frequency makes of that response is left out. Statuses
 * of hawser_net_rom_build. */
enum hawser_status hawser_net_rom_show(const struct hawser_net *net,
                                       const struct hawser_net_rom_options *options,
                                       const struct hawser_net_rom_motion *motion,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;

#ifdef __cplusplus
}
#endif
#endif
