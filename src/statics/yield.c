/* statics/yield.c - ends on springs, in a state other than the one whose tension is given.
 *
 *   F0, F0+F   force in the cable (along +S) at end A: where both ends are at their places, and now
 *   t          change of the loads between the ends: end B has the force of there and F + t more
 *   CA, CB     compliances of the springs of ends A and B, 0 where they are rigid; C = CA + CB
 *   uA, uB     displacements of the ends: CA F and -CB (F + t)
 *   r          end B seen from end A (space.c); K its derivative by F
 *
 * The cable pulls end A by its force there and end B against it, so that the springs give way by the
 * changes of these forces. With the chord c between the places,
 *
 *   r(F0 + F) + C F = c - CB t,
 *
 * three equations for F, however many springs there are. t is known, since the length is. The left
 * side is the gradient of the complementary energy of the cable and its springs, which is strictly
 * convex: one equilibrium, and the Newton iteration of space.c with K + C finds it. The change F is the
 * unknown, and not the force: of springs so soft that they keep the force, as a counterweight does,
 * C F would else be lost in the round-off of F0.
 * Then the span is solved once more, as any other, between the ends where they are now; what its
 * forces leave of the balance of the springs (`imbalance`) certifies both solutions.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "core/report.h"
#include "core/vec3.h"
#include "statics/loaded.h"
#include "statics/travel.h"

static const char where[] = "statics";
/* Largest displacement of an end over the distance of the ends: beyond, springs that keep their
 * directions and their stiffness are no model of a support. */
static const double most = 0.1;

int hawser__on_springs(const struct hawser_scene *scene)
{
	struct hawser_held held[2];

	return hawser_statics_held(held, scene);
}

void hawser__end_forces(double force[2][3], const struct hawser_statics *st)
{
	const double ends[2] = {0.0, st->length0}, V[2] = {st->V0, st->V1};

	for (int end = 0; end < 2; end++) {
		double f[3] = {st->H, V[end], 0.0};

		if (st->space) {
			struct hawser_profile_point at = hawser_statics_at(st, ends[end]);

			for (int c = 0; c < 3; c++)
				f[c] = at.T*at.tangent[c];
		}
		hawser_statics_to_global(st, force[end], f);
	}
}

static double compliance(const struct hawser_held *held, int axis)
{
	return 1.0/held->stiffness[axis]; /* 0 where it is infinite */
}

/* C of *soft, along the axes of the span. */
static void add_compliance(struct hawser__soft *soft, const struct hawser_equivalent *equal)
{
	for (int i = 0; i < 3; i++)
		for (int k = 0; k < 3; k++)
			for (int a = 0; a < 3; a++)
				soft->C[i][k] += equal->axes[i][a]*equal->axes[k][a]*
				                 (compliance(&equal->held[0], a) + compliance(&equal->held[1], a));
}

/* t along the axes of the span. */
static void change_of_force(double t[3], const struct hawser__loaded *cable)
{
	for (int c = 0; c < 3; c++) {
		t[c] = c == 1 ? cable->w*cable->L : 0.0;
		for (int i = 0; i < cable->count; i++)
			t[c] -= cable->load[i].force[c];
	}
}

static void outward(double global[3], const struct hawser_equivalent *equal, const double v[3])
{
	for (int c = 0; c < 3; c++)
		global[c] = equal->axes[0][c]*v[0] + equal->axes[1][c]*v[1] + equal->axes[2][c]*v[2];
}

static void inward(double v[3], const struct hawser_equivalent *equal, const double global[3])
{
	for (int i = 0; i < 3; i++)
		v[i] = equal->axes[i][0]*global[0] + equal->axes[i][1]*global[1] +
		       equal->axes[i][2]*global[2];
}

static enum hawser_status check(const struct hawser_equivalent *equal, const double chord[3],
                                const struct hawser_scene *scene, struct hawser_report *report)
{
	double distance = hypot(scene->span.d, scene->span.h);

	for (int end = 0; end < 2; end++) {
		const double *u = equal->moved[end];

		if (!(hawser__norm(u) <= most*distance))
			return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, where,
			                    "on its springs end %c moves by (%g, %g, %g) m between the state "
			                    "whose tension is given and the other one, more than a tenth of "
			                    "the distance of the ends, %g m: springs that soft do not hold the "
			                    "cable; raise support.%c.stiffness", "AB"[end], u[0], u[1], u[2],
			                    distance, "AB"[end]);
	}
	if (chord[0] > 0.0)
		return HAWSER_OK;
	return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, where,
	                    "on their springs the ends move past each other: their horizontal distance "
	                    "span.d = %g m becomes %g m; raise support.A.stiffness and "
	                    "support.B.stiffness", scene->span.d, chord[0]);
}

enum hawser_status hawser__yield(struct hawser_equivalent *equal, double chord[3],
                                 const struct hawser_scene *scene, double rest[2][3],
                                 struct hawser_report *report)
{
	struct hawser__soft soft = {.chord = {equal->span.d, equal->span.h, 0.0}};
	struct hawser_attachment attach[HAWSER_ATTACH_MAX];
	int order[HAWSER_ATTACH_MAX];
	struct hawser__loaded cable;
	double F[3], t[3], turn[3], force[2][3];
	enum hawser_status status;

	equal->yields = hawser_statics_held(equal->held, scene);
	hawser__attached_along(attach, equal, scene);
	hawser__loaded_begin(&cable, order, &equal->span, attach, scene->attachments,
	                     equal->gravity, equal->value);
	cable.soft = &soft;
	add_compliance(&soft, equal);
	inward(soft.rest, equal, rest[0]);
	change_of_force(t, &cable);
	outward(turn, equal, t);
	for (int c = 0; c < 3; c++) {
		t[c] = turn[c] - (rest[1][c] - rest[0][c]);
		turn[c] = compliance(&equal->held[1], c)*t[c];
	}
	inward(force[0], equal, turn);
	for (int c = 0; c < 3; c++)
		soft.chord[c] -= force[0][c];
	status = hawser__space_force(F, &cable, order, &equal->span, report);
	if (status)
		return status;
	outward(force[0], equal, F);
	for (int c = 0; c < 3; c++) {
		equal->moved[0][c] = compliance(&equal->held[0], c)*force[0][c] + 0.0;
		equal->moved[1][c] = 0.0 - compliance(&equal->held[1], c)*(force[0][c] + t[c]);
		equal->preload[0][c] = rest[0][c];
		equal->preload[1][c] = -rest[1][c];
	}
	chord[0] = scene->span.d + equal->moved[1][0] - equal->moved[0][0];
	chord[1] = scene->span.h + equal->moved[1][1] - equal->moved[0][1];
	chord[2] = equal->moved[1][2] - equal->moved[0][2];
	return check(equal, chord, scene, report);
}

void hawser__yield_moved(struct hawser_statics *st, const struct hawser_equivalent *equal)
{
	double force[2][3];

	memcpy(st->moved, equal->moved, sizeof st->moved);
	st->imbalance = 0.0;
	if (!equal->yields)
		return;
	hawser__end_forces(force, st);
	for (int end = 0; end < 2; end++)
		for (int c = 0; c < 3; c++) {
			double k = equal->held[end].stiffness[c];
			double pull = end ? -force[end][c] : force[end][c];

			if (isfinite(k))
				st->imbalance = fmax(st->imbalance, fabs(pull - equal->preload[end][c] -
				                                         k*equal->moved[end][c]));
		}
}
