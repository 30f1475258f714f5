/* rom/file/entries.h - see entries.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_ENTRIES_H
#define HAWSER_ROM_ENTRIES_H

#include <hawser/rom.h>

/* An entry of a list Q (struct hawser_quad, 3 indices) or C (struct hawser_cubic, 4): j, k, l, m. */
struct hawser__entry {
	int index[4];
	double value;
};
struct hawser__entry hawser__entry(const void *list, int indices, int at);
void hawser__entry_put(void *list, int indices, int at, struct hawser__entry entry);
/* Room for `count` entries; release with free(). */
void *hawser__entries_room(int indices, size_t count);

/* Check that every number is finite, and every index and harmonic in its range; HAWSER_ERR_ARGUMENT
 * names the entry. */
enum hawser_status hawser__entries_check(const struct hawser_rom *rom,
                                         struct hawser_report *report);

/* Check that every number of K, D, the harmonics and the ramp is finite; `kind` names the entry that is
 * not. Otherwise a response would report an undamped resonance. The tensors are checked when they are
 * compiled. */
enum hawser_status hawser__numbers_check(const struct hawser_rom *rom, enum hawser_status kind,
                                         struct hawser_report *report);

/* Sort, sum repeats and drop zeros, in place. HAWSER_ERR_ARGUMENT: repeats whose sum overflows. */
enum hawser_status hawser__entries_merge(struct hawser_rom *rom, struct hawser_report *report);

#endif
