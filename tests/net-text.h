/* tests/net-text.h - a net from the text of its scene.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_TESTS_NET_TEXT_H
#define HAWSER_TESTS_NET_TEXT_H

#include <stdio.h>
#include <string.h>

#include <hawser/document.h>
#include <hawser/net.h>

#include "tests/tap.h"

/* set: KEY=VALUE, or NULL. Returns 0, after a failed check, if the scene was not read. */
static inline int net_opened(struct hawser_net *net, const char *text, const char *set)
{
	struct hawser_report report = {0};
	struct hawser_document document;
	FILE *stream = fmemopen((void *)text, strlen(text), "r");
	enum hawser_status status = hawser_document_read(&document, stream, "scene", &report);

	fclose(stream);
	if (!status)
		status = hawser_net_of(net, &document, &set, set != NULL, &report);
	hawser_document_clear(&document);
	return ok(!status, "the scene is read: %s", report.message);
}

#endif
