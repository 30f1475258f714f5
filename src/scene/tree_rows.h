/* scene/tree_rows.h - how the tables of keys of the kinds are written: KIND_rows.c in the folder of
 * each kind, which is data alone and belongs to the library of the scene.
 *
 * A path is the kind of the scene and the keys down to the value; [] is an item of a list, * a name
 * of the user, ** one of another sort in the same mapping. Rows of one path are other forms of its
 * value. `at` is where its value goes in the structure of the nearest list item or mapping of names
 * above it, else that of the scene: a double (of a list several), an int of an integer or a word, a
 * char * of a text; or NOWHERE: code of the kind reads it. `given` is a default as a scene has it, or
 * words about it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_SCENE_TREE_ROWS_H
#define HAWSER_SCENE_TREE_ROWS_H

#include "scene/tree_keys.h"

#define ANY HAWSER__TREE_ANY
#define POSITIVE HAWSER__TREE_POSITIVE
#define POSITIVE_OR_INF HAWSER__TREE_POSITIVE_OR_INF
#define NOT_NEGATIVE HAWSER__TREE_NOT_NEGATIVE
#define NOT_NEGATIVE_OR_INF HAWSER__TREE_NOT_NEGATIVE_OR_INF
#define RIGHT_ANGLE HAWSER__TREE_RIGHT_ANGLE
#define OPEN_UNIT HAWSER__TREE_OPEN_UNIT
#define INCREASING HAWSER__TREE_INCREASING
#define CHANGE HAWSER__TREE_CHANGE
#define WITHIN HAWSER__TREE_WITHIN
#define INSIDE HAWSER__TREE_INSIDE
#define OPTIONAL HAWSER__TREE_OPTIONAL
#define REQUIRED HAWSER__TREE_REQUIRED
#define ONE_OF HAWSER__TREE_ONE_OF
#define AT_MOST_ONE HAWSER__TREE_AT_MOST_ONE
#define TOGETHER HAWSER__TREE_TOGETHER
#define MESH HAWSER__TREE_MESH
#define NOWHERE HAWSER__TREE_NOWHERE
#define CHECKED HAWSER__TREE_CHECKED

#define ROW(path, type, count, unit, range, least, most, need, at, copies, pick, given, doc) \
	{path, HAWSER__TREE_##type, count, unit, range, least, most, need, at, copies, pick, 0, given, doc},
#define NUMBER(path, need, unit, range, at, given, doc) \
	ROW(path, NUMBER, 0, unit, range, 0, 0, need, at, 1, NOWHERE, given, doc)
/* At most this; the line says why. */
#define LIMITED(path, need, unit, range, most, at, given, doc) \
	ROW(path, NUMBER, 0, unit, range, 0, most, need, at, 1, NOWHERE, given, doc)
/* One number for two places. */
#define BOTH(path, need, unit, range, at, given, doc) \
	ROW(path, NUMBER, 0, unit, range, 0, 0, need, at, 2, NOWHERE, given, doc)
/* Exactly one of those of the mapping: its number goes to `pick`. */
#define CHOICE(path, unit, at, pick, doc) \
	ROW(path, NUMBER, 0, unit, POSITIVE, 0, 0, ONE_OF, at, 1, pick, NULL, doc)
#define VECTOR(path, count, need, unit, range, at, given, doc) \
	ROW(path, NUMBER, count, unit, range, 0, 0, need, at, 1, NOWHERE, given, doc)
#define INTEGER(path, need, least, most, at, given, doc) \
	ROW(path, INTEGER, 0, "1", least ? POSITIVE : NOT_NEGATIVE, least, most, need, at, 1, NOWHERE, \
	    given, doc)
#define WORD(path, need, words, at, given, doc) \
	ROW(path, WORD, 0, words, ANY, 0, 0, need, at, 1, NOWHERE, given, doc)
#define TEXT(path, need, at, given, doc) \
	ROW(path, TEXT, 0, "", ANY, 0, 0, need, at, 1, NOWHERE, given, doc)
/* Words for 0 and infinity, another form of a number; a position on the cable. */
#define LIMIT(path, words, at, given, doc) \
	ROW(path, LIMIT, 0, words, ANY, 0, 0, OPTIONAL, at, 1, NOWHERE, given, doc)
#define POSITION(path, need, range, at, given, doc) \
	ROW(path, POSITION, 0, "1", range, 0, 0, need, at, 1, NOWHERE, given, doc)
/* A mapping whose keys are of the same structure, and one of another. */
#define SECTION(path, need, doc) ROW(path, MAPPING, 0, "", ANY, 0, 0, need, 0, 1, NOWHERE, NULL, doc)
#define MAPPING(path, need, doc) \
	ROW(path, MAPPING, 0, "", ANY, 0, 0, need, NOWHERE, 1, NOWHERE, NULL, doc)
#define SHAPE(path, need, pick, doc) ROW(path, MAPPING, 0, "", ANY, 0, 0, need, 0, 1, pick, NULL, doc)
#define LIST(path, need, doc) ROW(path, LIST, 0, "", ANY, 0, 0, need, NOWHERE, 1, NOWHERE, NULL, doc)

/* What several kinds have. */
#define HEAD(kind, word, range, at) \
	WORD(kind ".kind", OPTIONAL, word, CHECKED, NULL, "kind of the scene") \
	NUMBER(kind ".g", OPTIONAL, "m/s^2", range, at, "9.81", "acceleration of gravity, downwards")
#define DRAG(path, need, across, along) \
	SECTION(path, OPTIONAL, "coefficients of the drag of air") \
	NUMBER(path ".normal", REQUIRED, "1", NOT_NEGATIVE, across, NULL, \
	       "across the axis, referred to the diameter") \
	NUMBER(path ".tangential", OPTIONAL, "1", NOT_NEGATIVE, along, "0", \
	       "along it, referred to the surface")
#define ADDED_MASS(path, across, along) \
	SECTION(path, OPTIONAL, "added mass over the mass of the water that is displaced") \
	NUMBER(path ".normal", REQUIRED, "1", NOT_NEGATIVE, across, NULL, "across the cable") \
	NUMBER(path ".tangential", OPTIONAL, "1", NOT_NEGATIVE, along, "0", "along it")
/* AT: where the members of a struct hawser_water_line `line` go. */
#define LINE_IN_WATER(path, AT) \
	NUMBER(path ".diameter", OPTIONAL, "m", NOT_NEGATIVE, AT(line.diameter), NULL, \
	       "diameter, in water: of the buoyancy, the drag and the added mass") \
	SECTION(path ".drag", OPTIONAL, "coefficients of the drag of the water") \
	NUMBER(path ".drag.normal", REQUIRED, "1", NOT_NEGATIVE, AT(line.normal), NULL, \
	       "across the cable, referred to the diameter") \
	NUMBER(path ".drag.tangential", OPTIONAL, "1", NOT_NEGATIVE, AT(line.tangential), "0", \
	       "along it, referred to the surface") \
	ADDED_MASS(path ".added_mass", AT(line.added_normal), AT(line.added_tangential))
/* AT: where the members of a struct hawser_water `water` go. */
#define WATER(path, AT) \
	SECTION(path, OPTIONAL, "the water around the cables") \
	NUMBER(path ".density", REQUIRED, "kg/m^3", POSITIVE, AT(water.density), NULL, \
	       "its density") \
	NUMBER(path ".surface", OPTIONAL, "m", ANY, AT(water.surface), "0", \
	       "mean height of its surface, above which it is dry") \
	VECTOR(path ".current", 3, OPTIONAL, "m/s", ANY, NOWHERE, "[0, 0, 0]", \
	       "velocity of the water") \
	MAPPING(path ".current", OPTIONAL, "velocity of the water over the height, or over time") \
	LIST(path ".current.table", OPTIONAL, "heights, upwards, with velocities: linear between, " \
	     "and as at the ends beyond them") \
	TEXT(path ".current.file", OPTIONAL, NOWHERE, NULL, "file of velocities over time, lines of " \
	     "time in s and velocities along x, y, z in m/s; statics takes that of t = 0") \
	VECTOR(path ".current.table[]", 4, OPTIONAL, "m, m/s, m/s, m/s", ANY, NOWHERE, NULL, \
	       "[y, ux, uy, uz]") \
	NUMBER(path ".depth", OPTIONAL, "m", POSITIVE_OR_INF, AT(water.depth), NULL, \
	       "depth of the bed below the surface, of waves; .inf: deep water") \
	SECTION(path ".waves", OPTIONAL, "linear waves: regular ones, or a sea") \
	NUMBER(path ".waves.height", ONE_OF, "m", POSITIVE, AT(water.given.height), NULL, \
	       "of regular waves, from trough to crest") \
	NUMBER(path ".waves.period", OPTIONAL, "s", POSITIVE, AT(water.given.period), NULL, "of these") \
	NUMBER(path ".waves.phase", OPTIONAL, "rad", ANY, AT(water.given.phase), "0", \
	       "of these: the elevation at x = z = 0 is height/2 cos(omega t - phase)") \
	SECTION(path ".waves.jonswap", ONE_OF, "a sea by its spectrum") \
	NUMBER(path ".waves.jonswap.Hs", REQUIRED, "m", POSITIVE, AT(water.given.Hs), NULL, \
	       "significant height: 4 standard deviations of the elevation") \
	NUMBER(path ".waves.jonswap.Tp", REQUIRED, "s", POSITIVE, AT(water.given.Tp), NULL, \
	       "period of the peak") \
	NUMBER(path ".waves.jonswap.gamma", OPTIONAL, "1", POSITIVE, AT(water.given.gamma), "3.3", \
	       "enhancement of the peak, 1 or more; 1: Pierson-Moskowitz") \
	INTEGER(path ".waves.components", OPTIONAL, 1, 100000, AT(water.given.components), "400", \
	        "components of a sea") \
	INTEGER(path ".waves.seed", OPTIONAL, 0, 2147483647, AT(water.given.seed), "0", \
	        "of its random phases, and frequencies within their bins: so it does not repeat") \
	VECTOR(path ".waves.frequencies", 2, OPTIONAL, "rad/s", POSITIVE, AT(water.given.range), \
	       "0.5 and 5 times that of the peak", "range of its frequencies") \
	NUMBER(path ".waves.heading", OPTIONAL, "rad", ANY, AT(water.given.heading), "0", \
	       "direction in which waves run, from x towards z") \
	WORD(path ".stretching", OPTIONAL, "wheeler|none|vertical|extrapolate", \
	     AT(water.given.stretching), "wheeler", "of the velocity of waves up to their crests") \
	NUMBER(path ".ramp", OPTIONAL, "s", NOT_NEGATIVE, AT(water.given.ramp), "0", \
	       "time from t = 0 on in which waves grow")
#define CIRCLE(path, need, pick, centre, radius) \
	SHAPE(path, need, pick, "a circle, which extends along z") \
	VECTOR(path ".centre", 2, REQUIRED, "m", ANY, centre, NULL, "[x, y] of its centre") \
	NUMBER(path ".radius", REQUIRED, "m", NOT_NEGATIVE, radius, NULL, "its radius; 0: a point")
#define HANGER(path, at) \
	NUMBER(path, OPTIONAL, "m", NOT_NEGATIVE, at, "0", \
	       "length at which the mass hangs below the rope, as a pendulum")
#define WINCH(path, WINCH_AT) \
	MAPPING(path, OPTIONAL, "the first segment is paid out or hauled in, in motions") \
	NUMBER(path ".speed", ONE_OF, "m/s", ANY, WINCH_AT(speed), NULL, \
	       "paid out in this time; negative: hauled in") \
	NUMBER(path ".rise", OPTIONAL, "s", NOT_NEGATIVE, WINCH_AT(rise), "0", \
	       "time in which the speed grows from 0") \
	LIST(path ".times", OPTIONAL, "times of speeds or lengths, in place of speed") \
	NUMBER(path ".times[]", OPTIONAL, "s", ANY, 0, NULL, "a time") \
	LIST(path ".speeds", ONE_OF, "speeds at these times") \
	NUMBER(path ".speeds[]", OPTIONAL, "m/s", ANY, 0, NULL, "a speed") \
	LIST(path ".lengths", ONE_OF, "unstretched lengths of the segment at these times") \
	NUMBER(path ".lengths[]", OPTIONAL, "m", POSITIVE, 0, NULL, "a length") \
	NUMBER(path ".least", OPTIONAL, "m", POSITIVE, WINCH_AT(least), "5 % of its length", \
	       "the segment must not become shorter")

#endif
