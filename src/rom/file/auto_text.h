/* rom/file/auto_text.h - the part of an exported AUTO-07p equations file that is the same in all.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_AUTO_TEXT_H
#define HAWSER_ROM_AUTO_TEXT_H

/* In this order; the numbers of the model follow the head, those of the first orbit follow FUNC. */
extern const char hawser__auto_head[], hawser__auto_func[], hawser__auto_tail[];

#endif
