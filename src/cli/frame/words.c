/* cli/frame/words.c - options whose argument is one of a few words.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <ctype.h>
#include <string.h>

#include "cli/frame/kinds.h"
#include "core/append.h"
#include "core/report.h"

enum hawser_status cli_choose(int *index, const char *command, const char *option, const char *text,
                              const char *const *words, int count, struct hawser_report *report)
{
	char list[160] = "";

	for (*index = 0; *index < count; (*index)++) {
		if (strcmp(text, words[*index]) == 0)
			return HAWSER_OK;
		hawser__append(list, sizeof list, ", ", "%s", words[*index]);
	}
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, command, "--%s %s: must be one of %s", option,
	                    text, list);
}

int cli_input_word(char word[CLI_INPUT_WORD], const struct cli_command *command, int index)
{
	const char *text = command->input + strspn(command->input, "[");

	if (!strchr(text, '|') || !islower((unsigned char)*text)) /* SCENE|MODEL */
		text = "";
	for (; *text && *text != ']' && index > 0; index--) {
		text += strcspn(text, "|]");
		text += *text == '|';
	}
	snprintf(word, CLI_INPUT_WORD, "%.*s", (int)strcspn(text, "|]"), text);
	return *word != '\0';
}

enum hawser_status cli_choose_input(int *index, const struct cli_command *command, const char *text,
                                    struct hawser_report *report)
{
	char word[CLI_INPUT_WORD];

	for (*index = 0; cli_input_word(word, command, *index); (*index)++)
		if (!text || strcmp(text, word) == 0)
			return HAWSER_OK;
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, command->name, "%s %s: must be one of %s",
	                    command->name, text, command->input);
}

enum hawser_status cli_choose_method(const char *command, const char *text, int travels,
                                     struct hawser_report *report)
{
	const char *words[16] = {NULL};
	const struct hawser_modes_method *(*row)(int index) =
		travels ? hawser_complex_modes_method : hawser_modes_method;
	int count = 0, i;

	for (; count < 16 && row(count); count++)
		words[count] = row(count)->name;
	return cli_choose(&i, command, "method", text, words, count, report);
}
