/* hawser/rom_source.h - what reduced models with other values of parameters are made from.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_SOURCE_H
#define HAWSER_ROM_SOURCE_H

#include <stddef.h>

#include <hawser/document.h>
#include <hawser/plugin.h>
#include <hawser/rom.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A number of a model file that has a name. */
enum { HAWSER_PARAMETERS = 64 };
struct hawser_parameter {
	char name[32];
	double value;
	int set; /* 1: not the value of the file, from which others may follow */
};

/* The text of a model file, or a function (plugin.h), from which models with other values of its
 * parameters are made. */
struct hawser_rom_source {
	char *text, *name; /* name: of the file, for messages */
	size_t size;
	const struct hawser_plugin *plugin; /* NULL: the text */
	int parameters;
	struct hawser_parameter *parameter; /* [parameters] with the values that the next model has */
};

/* _open reads the text and its parameters ("-" is standard input), _of copies them from a document;
 * _set changes one of them, and *known is 0 if there is none of this name; _model makes the model.
 * Statuses as of hawser_rom_open. */
enum hawser_status hawser_rom_source_open(struct hawser_rom_source *source, const char *path,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;
enum hawser_status hawser_rom_source_of(struct hawser_rom_source *source,
                                        const struct hawser_document *from,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_rom_source_set(struct hawser_rom_source *source, const char *name, double value,
                           int *known);
enum hawser_status hawser_rom_source_model(struct hawser_rom *rom,
                                           const struct hawser_rom_source *source,
                                           struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_rom_source_clear(struct hawser_rom_source *source);

/* The same of a function, which must exist as long as the models. _model compares its derivatives with
 * differences at random states: HAWSER_ERR_ARGUMENT names one that differs. Such models are for
 * integration and for shooting, as those with terms; their energy is the kinetic one. */
enum hawser_status hawser_rom_source_plugin(struct hawser_rom_source *source,
                                            const struct hawser_plugin *plugin, const char *name,
                                            struct hawser_report *report) HAWSER_MUST_CHECK;

#ifdef __cplusplus
}
#endif

#endif
