/* tests/fuzz/fuzz.h - code common to the fuzz targets.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_TESTS_FUZZ_H
#define HAWSER_TESTS_FUZZ_H

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/scene.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/* A condition that every input must meet: otherwise print it and abort, as a sanitizer does. */
static inline void demand(int kept, const char *promise, const char *message)
{
	if (kept)
		return;
	fprintf(stderr, "broken promise: %s\nmessage: %s\n", promise, message);
	abort();
}

/* Properties of every valid scene. */
static inline int is_sound(const struct hawser_scene *scene)
{
	return scene->cable.EA > 0.0 && scene->cable.rho > 0.0 && scene->span.d > 0.0 &&
	       isfinite(scene->cable.rho) && isfinite(scene->span.d) && isfinite(scene->span.h) &&
	       scene->g > 0.0 && scene->tension.value > 0.0 && isfinite(scene->tension.value) &&
	       scene->tension.given != HAWSER_GIVEN_NONE &&
	       scene->load.extent[0] < scene->load.extent[1] && scene->model.modes >= 0 &&
	       scene->model.tolerance > 0.0 && scene->name;
}

/* A message for a user is a nonempty text on one line. */
static inline int is_message(const char *message)
{
	size_t length = strlen(message);

	return length > 10 && length == strcspn(message, "\n\r\t\033");
}

/* The scene as text; the caller frees it. */
static inline char *text_of(const struct hawser_scene *scene)
{
	struct hawser_report report = {.message = ""};
	char *text = NULL;
	size_t size = 0;
	FILE *stream = open_memstream(&text, &size);
	enum hawser_status status = hawser_scene_write(scene, stream, &report);

	demand(!status, "a scene can be written", report.message);
	fclose(stream);
	return text;
}

static inline enum hawser_status read_scene(struct hawser_scene *scene, const char *text,
                                            size_t size, const char *const *set, size_t nset,
                                            struct hawser_report *report)
{
	/* fmemopen refuses an empty buffer */
	FILE *stream = size ? fmemopen((void *)text, size, "r") : fopen("/dev/null", "r");
	enum hawser_status status = hawser_scene_read(scene, stream, "s.yaml", set, nset, report);

	fclose(stream);
	return status;
}

/* A scene that was read is valid; written and read again it gives the same text. */
static inline void check_scene(const struct hawser_scene *scene)
{
	struct hawser_report report = {.message = ""};
	struct hawser_scene again;
	char *first, *second;
	enum hawser_status status;

	demand(is_sound(scene), "a scene that is read is sound", scene->name);
	first = text_of(scene);
	status = read_scene(&again, first, strlen(first), NULL, 0, &report);
	demand(!status, "a scene that was written can be read", report.message);
	second = text_of(&again);
	demand(!strcmp(first, second), "reading and writing change nothing", second);
	hawser_scene_clear(&again);
	free(first);
	free(second);
}

#endif
