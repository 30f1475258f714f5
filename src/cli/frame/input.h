/* cli/frame/input.h - the input of commands that is a word: "bash|zsh|fish", or "[cable|net]"
 * where it may be left out. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_INPUT_H
#define HAWSER_CLI_INPUT_H

#include "cli/frame/cli.h"

/* Word `index` of the input of a command, from 0 on; returns 0 beyond the last, and where the input is
 * a file. */
enum { CLI_INPUT_WORD = 24 };
int cli_input_word(char word[CLI_INPUT_WORD], const struct cli_command *command, int index);

/* The index of `text`, or 0 where it is NULL; otherwise the message names all words. */
enum hawser_status cli_choose_input(int *index, const struct cli_command *command, const char *text,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;

#endif
