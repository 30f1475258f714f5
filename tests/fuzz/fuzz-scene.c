/* tests/fuzz/fuzz-scene.c - any bytes as a scene. The result must be a scene error with its place,
 * or a valid scene that can be written and read again, and whose statics has a solution or a reason
 * why not.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <hawser/statics.h>

#include "tests/fuzz/fuzz.h"

static void solve(const struct hawser_scene *scene)
{
	struct hawser_report report = {.message = ""};
	struct hawser_statics statics;
	enum hawser_status status = hawser_statics_scene(&statics, scene, &report);

	if (status)
		demand(is_message(report.message), "a refusal says why", report.message);
	else
		demand(isfinite(statics.H) && statics.H > 0.0, "a static shape has a tension", "");
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
	struct hawser_report report = {.message = ""};
	struct hawser_scene scene;
	enum hawser_status status = read_scene(&scene, (const char *)data, size, NULL, 0, &report);

	if (status) {
		demand(status == HAWSER_ERR_SCENE && !strncmp(report.message, "s.yaml:", 7) &&
		       is_message(report.message), "a scene error says where", report.message);
	} else {
		check_scene(&scene);
		solve(&scene);
	}
	hawser_scene_clear(&scene);
	return 0;
}
