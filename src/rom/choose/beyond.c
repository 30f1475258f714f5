/* rom/choose/beyond.c - what the modes above the candidates add, by the measures of the highest ones.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "rom/choose/weigh.h"

#define SLOWEST 1.2     /* smallest exponent with which measures are assumed to fall with the mode
                         * number; chosen */

/* Largest measure of the modes number last - 1 and last of a plane, one of each symmetry. */
static double about(const struct hawser_choice *choice, enum hawser_plane plane, int last)
{
	double most = 0.0;

	for (int j = 0; j < choice->n; j++) {
		const struct hawser_mode *mode = &choice->modes->mode[j];

		if (mode->plane == plane && mode->number >= last - 1 && mode->number <= last &&
		    choice->mode[j].reason != HAWSER_PARAMETRIC)
			most = fmax(most, choice->mode[j].measure);
	}
	return most;
}

/* m(n) = m(N) (n/N)^-p with p from N and N/2, summed over every second number above N. */
static double beyond(const struct hawser_choice *choice, enum hawser_plane plane)
{
	int count = 0;
	double last, p;

	for (int j = 0; j < choice->n; j++)
		count += choice->modes->mode[j].plane == plane;
	last = about(choice, plane, count);
	if (!(last > HAWSER__NEGLIGIBLE) || count < 4)
		return 0.0;
	p = fmax(log2(about(choice, plane, count/2)/last), SLOWEST);
	return 0.5*last*count/(p - 1.0);
}

/* Frequencies of a line with several spans are in groups, and their measures don't fall evenly: the
 * modes above count as much as the highest quarter. Chosen. */
static double as_highest(const struct hawser_choice *choice)
{
	double sum = 0.0;

	for (int j = choice->n - choice->n/4; j < choice->n; j++)
		sum += choice->mode[j].reason == HAWSER_PARAMETRIC ? 0.0 : choice->mode[j].measure;
	return sum;
}

double hawser_choice_beyond(const struct hawser_choice *choice)
{
	if (choice->answered)
		return as_highest(choice);
	return beyond(choice, HAWSER_IN_PLANE) + beyond(choice, HAWSER_OUT_OF_PLANE);
}
