/* rom/file/read_ends.c - the given motions of the ends in a reduced-model file (hawser-rom(5), `ends`).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdio.h>

#include "rom/terms/ends.h"
#include "rom/file/read.h"

static enum hawser_status read_harmonics(const struct hawser__parser *reader,
                                         struct hawser_rom_ends *ends, json_t *object)
{
	const size_t shape[2] = {(size_t)ends->terms, (size_t)ends->count};
	enum hawser_status status = HAWSER_OK;
	char where[24];
	double k;

	for (int t = 0; !status && t < ends->terms; t++) {
		snprintf(where, sizeof where, "ends.k[%d]", t);
		status = hawser__read_number(reader, &k, json_array_get(json_object_get(object, "k"),
		                                                        (size_t)t), where);
		if (!status && !(k >= 0.0 && k <= HAWSER__SUPPORT_TOP && k == (int)k))
			return hawser__wrong(reader, "%s is %g; an integer from 0 to %d is wanted", where, k,
			                     HAWSER__SUPPORT_TOP);
		if (!status)
			ends->k[t] = (int)k;
	}
	if (!status)
		status = hawser__read_array(reader, ends->cosine, json_object_get(object, "cos"), shape, 2,
		                            "ends.cos");
	return status ? status : hawser__read_array(reader, ends->sine, json_object_get(object, "sin"),
	                                            shape, 2, "ends.sin");
}

enum hawser_status hawser__read_ends(const struct hawser__parser *reader, struct hawser_rom *rom,
                                     json_t *object)
{
	static const char *const keys[] = {"k", "cos", "sin", "slope", "second_shape", "second_slope",
	                                   NULL};
	const size_t terms = json_array_size(json_object_get(object, "k"));
	const size_t count = json_array_size(json_object_get(object, "slope"));
	const size_t points = (size_t)rom->shapes.points;
	const int second = rom->shapes.second_shape != NULL;
	enum hawser_status status = hawser__read_keys(reader, object, keys, "ends");
	size_t pairs;

	if (status)
		return status;
	if (points == 0)
		return hawser__wrong(reader, "ends: there are no shapes that say at which points");
	if (terms < 1 || terms > HAWSER__SUPPORT_TOP + 1)
		return hawser__wrong(reader, "ends.k: a list of 1 to %d integers is wanted",
		                     HAWSER__SUPPORT_TOP + 1);
	if (count < 1 || count > HAWSER__SUPPORT_MOST)
		return hawser__wrong(reader, "ends.slope: a list of 1 to %d shapes is wanted",
		                     HAWSER__SUPPORT_MOST);
	status = hawser__ends_make(rom, (int)count, (int)terms, second, reader->report);
	if (!status)
		status = read_harmonics(reader, rom->ends, object);
	if (!status)
		status = hawser__read_array(reader, rom->ends->slope, json_object_get(object, "slope"),
		                            (size_t[]){count, points, 3}, 3, "ends.slope");
	if (status || !second)
		return status;
	pairs = hawser__ends_pairs(rom->ends);
	status = hawser__read_array(reader, rom->ends->second_shape,
	                            json_object_get(object, "second_shape"),
	                            (size_t[]){pairs, points, 3}, 3, "ends.second_shape");
	return status ? status : hawser__read_array(reader, rom->ends->second_slope,
	                                            json_object_get(object, "second_slope"),
	                                            (size_t[]){pairs, points, 3}, 3, "ends.second_slope");
}
