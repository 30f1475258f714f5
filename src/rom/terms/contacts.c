/* rom/terms/contacts.c - see dampers.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include "core/report.h"
#include "rom/terms/dampers.h"

enum { MOST = 10000 }; /* sheaves in a file */

enum hawser_status hawser__rom_init_contacts(struct hawser_rom *rom, int count,
                                             struct hawser_report *report)
{
	struct hawser_rom_contacts *contacts = &rom->contacts;

	contacts->count = count;
	contacts->name = calloc((size_t)count + 1, sizeof *contacts->name);
	contacts->turn = calloc((size_t)rom->n*(size_t)count + 1, sizeof *contacts->turn);
	return contacts->name && contacts->turn ? HAWSER_OK : hawser__no_memory(report, "rom");
}

void hawser__rom_contacts_clear(struct hawser_rom_contacts *contacts)
{
	for (int i = 0; contacts->name && i < contacts->count; i++)
		free(contacts->name[i]);
	free(contacts->name);
	free(contacts->turn);
	*contacts = (struct hawser_rom_contacts){.count = 0};
}

enum hawser_status hawser__read_contacts(const struct hawser__parser *reader, struct hawser_rom *rom,
                                         json_t *object)
{
	static const char *const keys[] = {"names", "turn", NULL};
	const json_t *names = json_object_get(object, "names");
	const size_t shape[2] = {(size_t)rom->n, json_array_size(names)};
	enum hawser_status status = hawser__read_keys(reader, object, keys, "contacts");

	if (status)
		return status;
	if (shape[1] < 1 || shape[1] > MOST)
		return hawser__wrong(reader, "contacts.names: a list of 1 to %d names is wanted", MOST);
	status = hawser__rom_init_contacts(rom, (int)shape[1], reader->report);
	if (!status)
		status = hawser__read_words(reader, rom->contacts.name, names, shape[1], "contacts.names");
	return status ? status : hawser__read_array(reader, rom->contacts.turn,
	                                            json_object_get(object, "turn"), shape, 2,
	                                            "contacts.turn");
}
