/* hawser/plausible.h - warnings about values that look like a mistake, such as a missing prefix or
 * a wrong unit.
 *
 * A scene may be valid and still describe no real cable: EA = 400 N in place of 400 MN. Some
 * quantities that follow from a scene and its static shape, such as the strain, lie within known
 * bounds for every real material. A quantity outside its bounds is reported with the key to check.
 * The scene is not changed.
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
	const char *formula; /* "largest tension/EA"; "" if the name needs no explanation */
	const char *unit;    /* of the bounds, SI; "" for a pure number */
	double low, high;    /* low 0: no lower bound */
	const char *keys;    /* keys to check, the most likely first, separated by blanks; "tension" and
	                      * "damping" stand for the key of that section which the scene gives */
	const char *why;     /* one sentence for the manual page */
};
/* Row `index` of the table of rules, from 0; NULL beyond the last. Static storage. */
const struct hawser_plausible_rule *hawser_plausible_rule(int index);

/* A quantity outside its bounds. */
struct hawser_doubt {
	const struct hawser_plausible_rule *rule;
	double value;   /* of the rule's quantity, in the rule's unit */
	char key[32];   /* "cable.EA" */
	char text[320]; /* a sentence: key, value, the quantity, and its plausible range */
};
enum { HAWSER_DOUBTS = 16 };

/* Fill doubt [HAWSER_DOUBTS]; returns the number of doubts. If multiplying or dividing the value of
 * one key by 1e3, 1e6 or 1e9 brings all quantities within their bounds, only that key is reported.
 * Scaled beams are not checked. */
int hawser_scene_doubts(struct hawser_doubt *doubt, const struct hawser_scene *scene);

#ifdef __cplusplus
}
#endif
#endif
