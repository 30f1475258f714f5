/* scene/page/manpage.h - parts of the program of the build that writes hawser-scene(5).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_SCENE_MANPAGE_H
#define HAWSER_SCENE_MANPAGE_H

/* Text with the characters escaped that are special in roff; a sentence in lines of 72 columns. */
void manpage_text(const char *from);
void manpage_sentence(const char *from);
/* manpage_kinds.c: a key, by its first row in the table of keys, with all its forms; all kinds of
 * scenes but spans. */
struct hawser__tree_key;
void manpage_key(const struct hawser__tree_key *row);
void manpage_kinds(void);

#endif
