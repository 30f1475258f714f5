/* rom/file/read_known.c - the known condensed modes of a reduced-model file (known.c).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdio.h>
#include <stdlib.h>

#include "core/report.h"
#include "rom/condense/known.h"
#include "rom/file/read.h"

enum { MOST = 10000 }; /* modes in a file */

static enum hawser_status read_modes(const struct hawser__parser *reader, struct hawser_rom *rom,
                                     const json_t *object, size_t modes)
{
	const size_t shape[3] = {modes, (size_t)rom->shapes.points, 4};
	struct hawser_rom_known *known = &rom->known;
	enum hawser_status status = hawser__rom_known_make(rom, (int)modes, reader->report);

	if (!status)
		status = hawser__read_array(reader, known->K, json_object_get(object, "K"), shape, 1,
		                            "known.K");
	if (!status)
		status = hawser__read_array(reader, known->D, json_object_get(object, "D"), shape, 1,
		                            "known.D");
	if (!status)
		status = hawser__read_array(reader, known->shape, json_object_get(object, "shape"),
		                            shape, 3, "known.shape");
	for (size_t s = 0; !status && s < modes; s++)
		if (!(known->K[s] > 0.0))
			return hawser__wrong(reader, "known.K[%zu] is %g; a positive number is wanted", s,
			                     known->K[s]);
	return status;
}

static enum hawser_status read_force(const struct hawser__parser *reader, struct hawser_rom *rom,
                                     int h, const json_t *force)
{
	const size_t modes = (size_t)rom->known.modes;
	char where[40];

	snprintf(where, sizeof where, "harmonics[%d].known", h);
	if (modes == 0)
		return hawser__wrong(reader, "%s: the model has no known modes (known.K)", where);
	rom->harmonic[h].known = calloc(modes, sizeof(double));
	if (!rom->harmonic[h].known)
		return hawser__no_memory(reader->report, "rom");
	return hawser__read_array(reader, rom->harmonic[h].known, force, &modes, 1, where);
}

enum hawser_status hawser__read_known(const struct hawser__parser *reader, struct hawser_rom *rom,
                                      const json_t *root)
{
	static const char *const keys[] = {"reach", "K", "D", "shape", NULL};
	json_t *object = json_object_get(root, "known");
	const json_t *list = json_object_get(root, "harmonics"), *force;
	size_t modes = json_array_size(json_object_get(object, "K"));
	enum hawser_status status = HAWSER_OK;

	if (object)
		status = hawser__read_keys(reader, object, keys, "known");
	if (!status && object)
		status = hawser__read_positive(reader, &rom->known.reach, object, "reach", "known");
	if (!status && json_object_get(object, "K")) {
		if (modes < 1 || modes > MOST)
			return hawser__wrong(reader, "known.K: a list of 1 to %d numbers is wanted", MOST);
		if (rom->shapes.points == 0)
			return hawser__wrong(reader, "known.shape: there are no shapes that say at which "
			                             "points");
		status = read_modes(reader, rom, object, modes);
	}
	for (int h = 0; !status && h < rom->harmonics; h++)
		if ((force = json_object_get(json_array_get(list, (size_t)h), "known")))
			status = read_force(reader, rom, h, force);
	return status;
}
