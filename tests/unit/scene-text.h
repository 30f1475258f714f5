/* tests/unit/scene-text.h - read a scene from a string.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_TESTS_SCENE_TEXT_H
#define HAWSER_TESTS_SCENE_TEXT_H

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/scene.h>

#include "tests/tap.h"

/* `length` bytes as "s.yaml", with overrides. */
static inline enum hawser_status read_bytes(struct hawser_scene *scene, const char *text,
                                            size_t length, const char *const *set, size_t nset,
                                            struct hawser_report *report)
{
	/* fmemopen refuses an empty buffer, so an empty text comes from /dev/null */
	FILE *stream = length ? fmemopen((void *)text, length, "r") : fopen("/dev/null", "r");
	enum hawser_status status;

	if (!stream) {
		perror("fmemopen");
		exit(99);
	}
	status = hawser_scene_read(scene, stream, "s.yaml", set, nset, report);
	fclose(stream);
	return status;
}

static inline enum hawser_status read_text(struct hawser_scene *scene, const char *text,
                                           const char *set, struct hawser_report *report)
{
	return read_bytes(scene, text, strlen(text), &set, set != NULL, report);
}

/* A check that it is read. */
static inline int is_read(struct hawser_scene *scene, const char *text)
{
	struct hawser_report report = {.message = ""};

	return ok(!read_text(scene, text, NULL, &report), "scene %s", report.message);
}

#endif
