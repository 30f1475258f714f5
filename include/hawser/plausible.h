/* hawser/plausible.h - what in a scene looks like a slip: a prefix forgotten, another unit meant.
 *
 * A scene may be right in every key and still be no cable: EA = 400 N where 400 MN was meant. From
 * a scene and its static shape follow quantities that lie within known bounds for whatever is made
 * of a real material; one that does not is told, with the key to look at. Nothing is changed.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_PLAUSIBLE_H
#define HAWSER_PLAUSIBLE_H

#include <hawser/scene.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A quantity, and the bounds within which it is plausible. */
struct hawser_plausible_rule {
	const char *name;    /* "the static strain" */
	const char *formula; /* "largest tension/EA"; "" where the name says it */
	const char *unit;    /* of the bounds, SI; "" for a pure number */
	double low, high;    /* low 0: none */
	const char *keys;    /* keys to look at, the likeliest first, separated by blanks; "tension" and
	                      * "damping" stand for the one that the scene gives */
	const char *why;     /* one sentence for the manual page */
};
const struct hawser_plausible_rule *hawser_plausible_rules(size_t *count);

/* Something that looks wrong. */
struct hawser_doubt {
	const struct hawser_plausible_rule *rule;
	double value;   /* of the rule's quantity */
	char key[32];   /* "cable.EA" */
	char text[320]; /* a sentence: key, value, the quantity, and what would be plausible */
};
enum { HAWSER_DOUBTS = 16 };

/* doubt [HAWSER_DOUBTS]: returns how many there are. One alone where one value that is a
 * thousand, a million or 10^9 times as large or as small would settle all of them. Scaled beams
 * have none. */
int hawser_scene_doubts(struct hawser_doubt *doubt, const struct hawser_scene *scene);

#ifdef __cplusplus
}
#endif
#endif
