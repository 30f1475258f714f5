/* hawser/study.h - one scene at several fidelities: models of different cost and accuracy, what each
 * of them makes of the scene's frequency response, and how far apart they are.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STUDY_H
#define HAWSER_STUDY_H

#include <hawser/frf.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A fidelity is a row: its name, one line about it, its source, whether a number of modes goes with
 * it ("raw 9"), and the function that makes its model of a scene whose statics are solved. */
struct hawser_fidelity {
	const char *name, *summary, *source;
	int counted;
	/* n: number of modes, where counted. Statuses of hawser_modes_solve and hawser_rom_build. */
	enum hawser_status (*build)(struct hawser_rom *rom, const struct hawser_statics *statics,
	                            const struct hawser_scene *scene, int n,
	                            struct hawser_report *report);
};
/* The rows, *count of them, from cheap to accurate. Static storage. */
const struct hawser_fidelity *hawser_fidelities(int *count);

#ifdef __cplusplus
}
#endif
#endif
