/* rom/whole.h - a file that appears whole or not at all.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_WHOLE_H
#define HAWSER_ROM_WHOLE_H

#include <stddef.h>

#include <hawser/status.h>

/* Put text [size] into the file `path`: what was there before stays until everything has reached
 * the disk's file system. "-" is standard output. HAWSER_ERR_IO names the file and the cause. */
enum hawser_status hawser__write_whole(const char *path, const char *text, size_t size,
                                       struct hawser_report *report);

#endif
