/* study/accuracy/instead.c - when a response of a reduced model is not good enough, and how the
 * exact energy is looked for in its place (model.energy: auto; accuracy.h).
 *
 * A polynomial of degree 4 on a few modes is right for taut cables and small motions. Its
 * truncation cannot be made up for by modes; what they leave out matters where it is large.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */

#include <hawser/accuracy.h>

/* The part of the estimated error that no number of modes makes up for, and its factor of safety:
 * from which on the reduced model is not good enough. */
static const double enough = 0.01, safety = 1.5;
/* The whole error, modes left out included, from which on it is not; and from which on a part of the
 * range that is right is worth more than the whole of the modes; chosen. */
static const double much = 0.02, rough = 0.1;
/* What is asked of the full-order models, and their largest basis: the load or a mode of the range
 * may need as many. */
static const double asked = 0.01;
enum { FUNCTIONS = 24 };
/* Seconds of processor time, as counted (hawser_orbit_work), that nobody has to ask for; chosen, so
 * that the range reaches beyond the first resonance of conductor.yaml and inclined.yaml. */
static const double bearable = 15.0;

int hawser_accuracy_truncated(double truncation)
{
	return safety*truncation > enough;
}

int hawser_accuracy_poor(const struct hawser_accuracy_fixed *fixed, double limit)
{
	return hawser_accuracy_truncated(fixed->truncation) ||
	       fixed->estimated > (limit > 0.0 ? limit : much);
}

struct hawser_accuracy_options hawser_accuracy_instead(const struct hawser_accuracy_fixed *fixed,
                                                       int own,
                                                       const struct hawser_frf_options *frf)
{
	struct hawser_accuracy_options choice = {.frf = *frf, .agreed = 1, .partial = 1,
		.accuracy = own ? 0.0 : asked, .near = own ? 0.0 : much, .bearable = bearable,
		.most_functions = FUNCTIONS};

	if (fixed && !hawser_accuracy_truncated(fixed->truncation))
		choice.partial = fixed->estimated > rough;
	choice.frf.most_work = 0.0;
	if (choice.frf.max_points == 0 || choice.frf.max_points > HAWSER_INSTEAD_POINTS)
		choice.frf.max_points = HAWSER_INSTEAD_POINTS;
	return choice;
}
