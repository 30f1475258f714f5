/* tests/fuzz/fuzz-document.c - any bytes as a scene of any kind: the kind is found, and its reader
 * gives a scene, or a scene error with its place. The same document gives the same answer again.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <hawser/net.h>
#include <hawser/obstacles.h>
#include <hawser/rod.h>
#include <hawser/ropeway.h>
#include <hawser/tow.h>

#include "tests/fuzz/fuzz.h"

union any {
	struct hawser_net net;
	struct hawser_obstacles obstacles;
	struct hawser_ropeway ropeway;
	struct hawser_rod rod;
	struct hawser_tow tow;
};

static enum hawser_status read_any(const struct hawser_document *document,
                                   struct hawser_report *report)
{
	enum hawser_status status = HAWSER_ERR_SCENE;
	union any any;

	switch (document->kind) {
	case HAWSER_KIND_NET:
		status = hawser_net_of(&any.net, document, NULL, 0, report);
		hawser_net_clear(&any.net);
		break;
	case HAWSER_KIND_OBSTACLES:
		status = hawser_obstacles_of(&any.obstacles, document, NULL, 0, report);
		hawser_obstacles_clear(&any.obstacles);
		break;
	case HAWSER_KIND_ROPEWAY:
		status = hawser_ropeway_of(&any.ropeway, document, NULL, 0, report);
		hawser_ropeway_clear(&any.ropeway);
		break;
	case HAWSER_KIND_ROD:
		status = hawser_rod_of(&any.rod, document, NULL, 0, report);
		hawser_rod_clear(&any.rod);
		break;
	case HAWSER_KIND_TOW:
		status = hawser_tow_of(&any.tow, document, NULL, 0, report);
		hawser_tow_clear(&any.tow);
		break;
	default: /* spans and models have targets of their own */
		snprintf(report->message, sizeof report->message, "s.yaml: another kind");
	}
	return status;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
	struct hawser_report first = {.message = ""}, second = {.message = ""};
	struct hawser_document document;
	/* fmemopen refuses an empty buffer */
	FILE *stream = size ? fmemopen((void *)data, size, "r") : fopen("/dev/null", "r");
	enum hawser_status status = hawser_document_read(&document, stream, "s.yaml", &first);

	fclose(stream);
	demand(!status, "any text is read", first.message);
	status = read_any(&document, &first);
	demand(!status || (status == HAWSER_ERR_SCENE && !strncmp(first.message, "s.yaml:", 7) &&
	                   is_message(first.message)), "a scene error says where", first.message);
	demand(read_any(&document, &second) == status && !strcmp(first.message, second.message),
	       "the second reader gets what the first got", second.message);
	hawser_document_clear(&document);
	return 0;
}
