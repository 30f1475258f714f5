/* rom/terms/contacts.h - the angles by which the rope of a model lies on its sheaves.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_CONTACTS_H
#define HAWSER_ROM_CONTACTS_H

#include <hawser/rom.h>

#include "rom/file/read.h"

/* Allocate, all zero. */
enum hawser_status hawser__rom_init_contacts(struct hawser_rom *rom, int count,
                                             struct hawser_report *report);
void hawser__rom_contacts_clear(struct hawser_rom_contacts *contacts);
/* The member `contacts` of a reduced-model file. */
enum hawser_status hawser__read_contacts(const struct hawser__parser *reader, struct hawser_rom *rom,
                                         json_t *object);

#endif
