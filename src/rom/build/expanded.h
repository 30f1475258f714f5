/* rom/build/expanded.h - terms of a model from an energy that is expanded in shapes: of a span
 * (rom/energy/project.c), of a rope over sheaves (ropeway/expand/expand.h), or of a net
 * (net/expand/expand.h).
 *
 * The first shapes are the modes that are coordinates of the model (second-order shapes that are, too,
 * are none of these shapes); behind them come fields, whose motion is known:
 * the static response to the load of the modes that are not kept.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_EXPANDED_H
#define HAWSER_ROM_EXPANDED_H

#include <hawser/rom.h>

#include "core/hold.h"
#include "modes/driven.h"
#include "rom/condense/fields.h"
#include "rom/condense/inertia.h"

/* All scaled. A place is the number of a shape point of the model; behind these come the points of its
 * line, where u is not asked for. At it, u is P, Q, B and slope a, b, c. */
struct hawser__expanded {
	const void *of;
	int n;                     /* shapes, of which the first `equations` are coordinates */
	int equations;
	const double *third;       /* [n][n][n] third derivatives of the energy */
	double (*fourth)(const void *of, const int index[4]);
	/* 0: the fourth derivative vanishes, by symmetry. */
	int (*even)(const void *of, const int index[4]);
	/* Of a shape; of the second-order displacement of pair k(k + 1)/2 + j of shapes; of a row of
	 * modes/driven.h. */
	void (*shape_at)(double u[3], double slope[3], const void *of, int shape, int place);
	void (*pair_at)(double u[3], double slope[3], const void *of, int pair, int place);
	void (*field_at)(double u[3], double slope[3], const void *of, const double *row, int place);
	/* Change of the tension by the slopes of a shape, relative, if they stretched its part of the
	 * structure alone. */
	double (*tightens)(const void *of, int shape);
	/* Damping of a motion of modes/driven.h. */
	double (*damping)(const void *of, const double *row, double omega2);
};

/* What the modes that are not kept do under each harmonic of the load. */
struct hawser__answers {
	int count;
	struct hawser__driven *driven;   /* [count] in the order of the model's harmonics */
	double factor;                   /* of each */
	int fields;                      /* displacements that are shapes, behind the coordinates: */
	int ends;                        /* so many by moving supports, then static parts of answers */
	struct {
		int k, sine;                 /* the shape has the factor factor*cos(k tau), or sine */
		double factor;
	} field[HAWSER__LOAD_FIELDS];
};
void hawser__answers_clear(struct hawser__answers *answers);

/* Entries of Q and C of the equations of the modes, in the first n shapes, of which the last of an
 * entry is at least number `least`. */
enum hawser_status hawser__expanded_tensors(struct hawser_rom *rom, const struct hawser__expanded *e,
                                            int n, int least, struct hawser_report *report);
/* Displacement and strains of what follows the coordinates. */
enum hawser_status hawser__expanded_pairs(struct hawser_rom *rom, const struct hawser__expanded *e,
                                          struct hawser_report *report);
/* Displacement and strains of `pairs` pairs of the expansion, from number `first` on, at the shape
 * points, [pairs][points][3], and strains along the line. */
void hawser__expanded_second(double *shape, double *slope, double *line, const struct hawser_rom *rom,
                             const struct hawser__expanded *e, int first, int pairs);
/* `answer` of the harmonics and the known motions. expanded_answer.c. */
enum hawser_status hawser__expanded_answers(struct hawser_rom *rom, const struct hawser__expanded *e,
                                            const struct hawser__answers *answers,
                                            struct hawser_report *report);
/* The displacement by moving supports that is field i, as a harmonic without force.
 * expanded_answer.c. */
enum hawser_status hawser__expanded_lift(struct hawser_rom *rom, const struct hawser__expanded *e,
                                         const struct hawser__answers *answers, int i,
                                         struct hawser_report *report);
/* Terms of the energy with the fields. expanded_answer.c. */
enum hawser_status hawser__expanded_fields(struct hawser_rom *rom, const struct hawser__expanded *e,
                                           const struct hawser__answers *answers,
                                           struct hawser_report *report);

/* --- expanded_inertia.c: second-order shapes as coordinates behind the modes of a model from an
 * expanded energy --- */

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
