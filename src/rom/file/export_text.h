/* rom/file/export_text.h - the parts of exported files that are the same for all models. $ is the name.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_EXPORT_TEXT_H
#define HAWSER_ROM_EXPORT_TEXT_H

/* Of COCO, MATCONT and BifurcationKit: before the line that says what this is, before and after the
 * numbers of the model. */
extern const char *const hawser__export_text[3][3];

#endif
