/* rom/build/expanded_inertia.h - second-order shapes as coordinates behind the modes of a model from an
 * expanded energy: see expanded_inertia.c. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_EXPANDED_INERTIA_H
#define HAWSER_ROM_EXPANDED_INERTIA_H

#include <hawser/rom.h>

#include "core/hold.h"
#include "rom/condense/inertia_choice.h"

/* What the shapes of a model are made of. */
struct hawser__inertia_by {
	const void *of;
	int n;                 /* modes */
	size_t width;          /* of a displacement, a row */
	double *second;        /* [pairs][width] what follows the modes */
	double (*amplitude)(const void *of, int mode);
	/* Products of displacements in mass; in stiffness, of shapes. */
	double (*mass)(const void *of, const double *x, const double *y);
	double (*stiffness)(const void *of, const double *x, const double *y);
	/* A shape that can vibrate, of what follows; NULL: this itself. */
	enum hawser_status (*vibrates)(const void *of, double *to, const double *from,
	                               struct hawser_report *report);
	/* The part along a shape of the stiffness kappa2 of what follows modes j and k. */
	double (*part)(const void *of, int j, int k, const double *row, double kappa2);
};

struct hawser__inertia {
	struct hawser_rom_inertia found;
	double *by;            /* [shapes][pairs] what they are made of */
	double *row;           /* [shapes][width] of the mass 1 */
	double kappa2[HAWSER__INERTIA_MOST]; /* their stiffness */
	double *part;          /* [shapes][pairs] of what follows along them, which is taken out of it */
};

/* Expected amplitude of a mode of the stiffness omega2 and the second and fourth derivatives quad and
 * own of its own force: under a force over its damping, or of slopes that the expansion bears; turning:
 * mean square of its slopes. */
double hawser__inertia_expected(double omega2, double quad, double own, double size, double turning);
/* Which shapes matter. */
enum hawser_status hawser__inertia_find(struct hawser__inertia *of, struct hawser__hold *hold,
                                        const struct hawser__inertia_by *by,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;
/* Those shapes. */
enum hawser_status hawser__inertia_make(struct hawser__inertia *of, struct hawser__hold *hold,
                                        const struct hawser__inertia_by *by,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;
/* Their forces and those on the modes. */
enum hawser_status hawser__inertia_quads(struct hawser_rom *rom, const struct hawser__inertia *of,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;

#endif
