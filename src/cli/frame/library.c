/* cli/frame/library.c - a model in a shared library (--model-library, hawser/plugin.h).
 *
 * The library stays loaded until the program ends: its structure and functions are used as long as the
 * model.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <dlfcn.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/plugin.h>

#include "cli/frame/cli.h"
#include "core/report.h"

enum hawser_status cli_store_library(void *field, const struct cli_option *option,
                                     const char *const *values, struct hawser_report *report)
{
	struct cli_common *common = field;

	if (common->input)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "options",
		                    "--%s %s is the model, and so is %s: give one of them", option->name,
		                    values[0], common->input);
	common->input = common->library = values[0];
	return HAWSER_OK;
}

enum hawser_status cli_library_open(struct hawser_rom_source *source, const char *path,
                                    struct hawser_report *report)
{
	char *whole = realpath(path, NULL); /* a name without a folder would be searched for elsewhere */
	void *library = dlopen(whole ? whole : path, RTLD_NOW | RTLD_LOCAL);
	union {
		void *symbol;
		const struct hawser_plugin *(*plugin)(void);
	} found;

	free(whole);
	if (!library)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "model", "--model-library %s: %s", path,
		                    dlerror());
	found.symbol = dlsym(library, "hawser_plugin");
	if (!found.symbol)
		/* cppcheck-suppress resourceLeak ; loaded until the program ends */
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "model",
		                    "--model-library %s does not define hawser_plugin(), which "
		                    "hawser/plugin.h describes", path);
	/* cppcheck-suppress resourceLeak ; loaded until the program ends */
	return hawser_rom_source_plugin(source, found.plugin(), path, report);
}
