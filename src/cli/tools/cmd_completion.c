/* cli/tools/cmd_completion.c - hawser completion: completion of commands and options in shells,
 * from the tables of the program.
 *
 * Each shell is a row: how it begins and ends, a command, and an option. An option completes files if
 * one of its arguments is a FILE.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <string.h>

#include <hawser/schema.h>

#include "cli/frame/kinds.h"

static const struct cli_option options[] = {
	CLI_HELP_OPTION,
	CLI_NO_OPTION,
};
static const char *const notes[] = {
	"Writes a script that completes commands, options and files. make install puts it where the shells",
	"look; in a shell of your own: eval \"$(hawser completion bash)\" (zsh: after compinit), or",
	"hawser completion fish | source.",
	NULL,
};

static int takes_file(const struct cli_option *option)
{
	return strstr(option->arguments, "FILE") != NULL;
}

/* The length of the first word of a name; the object of a name of two words, or "". */
static int first(const char *name)
{
	return (int)strcspn(name, " ");
}

static const char *object(const char *name)
{
	return name[first(name)] ? name + first(name) + 1 : "";
}

/* 1 if an earlier command has the same first word. */
static int known(int index)
{
	const char *name = cli_command_row(index)->name;

	for (int i = 0; i < index; i++) {
		const char *other = cli_command_row(i)->name;

		if (first(other) == first(name) && strncmp(other, name, (size_t)first(name)) == 0)
			return 1;
	}
	return 0;
}

/* Text with a backslash before each of these characters, and in single quotes of a shell. */
static void quoted(FILE *stream, const char *text, const char *special)
{
	for (; *text; text++)
		if (*text == '\'')
			fputs("'\\''", stream);
		else
			fprintf(stream, "%s%c", strchr(special, *text) ? "\\" : "", *text);
}

/* Names of options, "--json --tsv"; `files`: only those that take a file (1), another argument (0);
 * -1: all. */
static void names(FILE *stream, const struct cli_command *command, int files)
{
	const struct cli_option *row;

	for (int i = 0; (row = cli_option_row(command, i)); i++)
		if (files < 0 || (*row->arguments && takes_file(row) == files))
			fprintf(stream, row->letter ? " --%s -%c" : " --%s", row->name, row->letter);
}

/* The words that an option may have. */
static void option_words(FILE *stream, const struct cli_option *option)
{
	for (const char *c = option->words; *c; c++)
		putc(*c == '|' ? ' ' : *c, stream);
}

static int takes_word(const struct cli_command *command)
{
	char word[CLI_INPUT_WORD];

	return cli_input_word(word, command, 0);
}

/* The words that the input of a command may be. */
static void input_words(FILE *stream, const struct cli_command *command)
{
	char word[CLI_INPUT_WORD];

	for (int k = 0; cli_input_word(word, command, k); k++)
		fprintf(stream, "%s%s", k ? " " : "", word);
}

/* --- bash --- */

static void bash_words(FILE *stream)
{
	const struct cli_command *command;

	for (int i = 0; (command = cli_command_row(i)); i++)
		if (!known(i))
			fprintf(stream, " %.*s", first(command->name), command->name);
	fputs(" help", stream);
}

/* The second words of commands of two. */
static void bash_objects(FILE *stream)
{
	const struct cli_command *command;

	for (int i = 0; (command = cli_command_row(i)); i++)
		if (*object(command->name))
			fprintf(stream, "\t\t%.*s) objects+=' %s' ;;&\n", first(command->name), command->name,
			        object(command->name));
		else if (takes_word(command)) {
			fprintf(stream, "\t\t%s) files= objects='", command->name);
			input_words(stream, command);
			fputs("' ;;&\n", stream);
		}
}

/* Options whose words are known. */
static void bash_values(FILE *stream)
{
	const struct cli_command *command;
	const struct cli_option *row;

	fputs("\tcase \"$command $prev\" in\n", stream);
	for (int i = 0; (command = cli_command_row(i)); i++)
		for (int k = 0; (row = cli_option_row(command, k)); k++) {
			if (!row->words)
				continue;
			fprintf(stream, "\t'%.*s --%s') mapfile -t COMPREPLY < <(compgen -W '",
			        first(command->name), command->name, row->name);
			option_words(stream, row);
			fputs("' -- \"$cur\")\n\t\treturn ;;\n", stream);
		}
	fputs("\tesac\n", stream);
}

/* Keys of scenes behind --set and --over. */
static void bash_keys(FILE *stream)
{
	char key[HAWSER_SCHEMA_KEY];

	fputs("\tcase $prev in --set | --over)\n\t\tcompopt -o nospace 2>/dev/null\n"
	      "\t\tmapfile -t COMPREPLY < <(compgen -S = -W '", stream);
	for (int i = 0; hawser_schema_key(key, i); i++)
		if (*key)
			fprintf(stream, " %s", key);
	fputs("' -- \"$cur\")\n\t\treturn ;;\n\tesac\n", stream);
}

static void bash(FILE *stream)
{
	const struct cli_command *command;

	fputs("# bash completion for hawser; written by: hawser completion bash\n"
	      "_hawser() {\n"
	      "\tlocal cur=${COMP_WORDS[COMP_CWORD]} prev=${COMP_WORDS[COMP_CWORD - 1]}\n"
	      "\tlocal command=${COMP_WORDS[1]} options= with_file= with_other= objects= files=1\n"
	      "\tCOMPREPLY=()\n"
	      "\tif [ \"$COMP_CWORD\" -eq 1 ] ||\n"
	      "\t\t{ [ \"$COMP_CWORD\" -eq 2 ] && [ \"$command\" = help ]; }; then\n"
	      "\t\tmapfile -t COMPREPLY < <(compgen -W '", stream);
	bash_words(stream);
	fputs("' -- \"$cur\")\n\t\treturn\n\tfi\n\tif [ \"$COMP_CWORD\" -eq 2 ]; then\n"
	      "\t\tcase $command in\n", stream);
	bash_objects(stream);
	fputs("\t\tesac\n\tfi\n\tcase \"$command ${COMP_WORDS[2]}\" in\n", stream);
	for (int two = 1; two >= 0; two--) /* the longer name first */
		for (int i = 0; (command = cli_command_row(i)); i++) {
			if ((*object(command->name) != 0) != two)
				continue;
			fprintf(stream, two ? "\t'%s')\n\t\toptions='" : "\t'%s '*)\n\t\toptions='", command->name);
			names(stream, command, -1);
			fputs("'\n\t\twith_file='", stream);
			names(stream, command, 1);
			fputs(" '\n\t\twith_other='", stream);
			names(stream, command, 0);
			fputs(" ' ;;\n", stream);
		}
	fputs("\tesac\n", stream);
	bash_values(stream);
	bash_keys(stream);
	fputs("\tcase $with_other in *\" $prev \"*) return ;; esac\n"
	      "\tcase $cur in\n\t-*) mapfile -t COMPREPLY < <(compgen -W \"$options\" -- \"$cur\")\n"
	      "\t\treturn ;;\n\tesac\n"
	      "\tcase $with_file in *\" $prev \"*) objects= files=1 ;; esac\n"
	      "\tmapfile -t COMPREPLY < <(compgen -W \"$objects\" -- \"$cur\"; "
	      "[ -z \"$files\" ] || compgen -f -- \"$cur\")\n"
	      "}\n"
	      "complete -o filenames -F _hawser hawser\n", stream);
}

/* --- zsh --- */

static void zsh_option(FILE *stream, const struct cli_option *option)
{
	const char *argument = option->arguments;

	fputs(" \\\n\t\t\t", stream);
	if (option->letter)
		fprintf(stream, "'(-%c --%s)'{-%c%s,--%s%s}'[", option->letter, option->name,
		        option->letter, *argument ? "+" : "", option->name, *argument ? "=" : "");
	else
		fprintf(stream, "'%s--%s%s[", strcmp(option->name, "set") ? "" : "*", option->name,
		        *argument ? "=" : "");
	quoted(stream, option->doc, "[]:\\");
	fputc(']', stream);
	while (*argument) { /* one word an argument */
		int length = (int)strcspn(argument, " ");

		fprintf(stream, ":%.*s:%s", length, argument, option->words ? "(" :
		        strncmp(argument, "FILE", 4) ? " " : "_files");
		if (option->words) {
			option_words(stream, option);
			putc(')', stream);
		}
		argument += length + (argument[length] == ' ');
	}
	fputc('\'', stream);
}

static void zsh_commands(FILE *stream, const char *of)
{
	const struct cli_command *command;

	for (int i = 0; (command = cli_command_row(i)); i++) {
		const char *name = command->name;

		if (of ? strncmp(name, of, strlen(of)) != 0 || !*object(name) : known(i))
			continue;
		fputs("\n\t\t'", stream);
		fprintf(stream, "%.*s:", of ? (int)strlen(object(name)) : first(name),
		        of ? object(name) : name);
		quoted(stream, command->summary, ":\\");
		fputc('\'', stream);
	}
}

static void zsh(FILE *stream)
{
	const struct cli_command *command;

	fputs("#compdef hawser\n# zsh completion for hawser; written by: hawser completion zsh\n"
	      "_hawser() {\n\tlocal -a commands\n\tlocal command\n\tcommands=(", stream);
	zsh_commands(stream, NULL);
	fputs("\n\t\t'help:options of a command'\n\t)\n"
	      "\tif (( CURRENT == 2 )) || [[ $words[2] = help ]]; then\n"
	      "\t\t_describe command commands\n\t\treturn\n\tfi\n"
	      "\tcommand=$words[2]\n\tcase \"$words[2] $words[3]\" in\n", stream);
	for (int i = 0; (command = cli_command_row(i)); i++)
		if (*object(command->name))
			fprintf(stream, "\t('%s') (( CURRENT > 3 )) && command='%s' && shift words && "
			        "(( CURRENT-- )) ;;\n", command->name, command->name);
	fputs("\tesac\n\tshift words\n\t(( CURRENT-- ))\n\tcase $command in\n", stream);
	for (int i = 0; (command = cli_command_row(i)); i++) {
		const struct cli_option *row;

		fprintf(stream, "\t('%s')\n", command->name);
		for (int k = 0; cli_command_row(k); k++)
			if (!*object(command->name) && *object(cli_command_row(k)->name) &&
			    first(cli_command_row(k)->name) == (int)strlen(command->name) &&
			    strncmp(cli_command_row(k)->name, command->name, strlen(command->name)) == 0) {
				fputs("\t\tif (( CURRENT == 2 )); then\n\t\tcommands=(", stream);
				zsh_commands(stream, command->name);
				fputs("\n\t\t)\n\t\t_describe object commands\n\t\tfi\n", stream);
				break;
			}
		fputs("\t\t_arguments -s", stream);
		for (int k = 0; (row = cli_option_row(command, k)); k++)
			zsh_option(stream, row);
		if (takes_word(command)) {
			fputs(" \\\n\t\t\t'1:word:(", stream);
			input_words(stream, command);
			fputs(")' ;;\n", stream);
		} else {
			fputs(" \\\n\t\t\t'*:scene:_files' ;;\n", stream);
		}
	}
	fputs("\tesac\n}\n"
	      "if [ \"$funcstack[1]\" = _hawser ]; then\n\t_hawser \"$@\"\nelse\n"
	      "\tcompdef _hawser hawser\nfi\n", stream);
}

/* --- fish --- */

static void fish_condition(FILE *stream, const char *name)
{
	fprintf(stream, "complete -c hawser -n '__fish_seen_subcommand_from %.*s", first(name), name);
	if (*object(name))
		fprintf(stream, "; and __fish_seen_subcommand_from %s", object(name));
}

static void fish(FILE *stream)
{
	const struct cli_command *command;

	fputs("# fish completion for hawser; written by: hawser completion fish\n"
	      "complete -c hawser -f\n"
	      "complete -c hawser -n 'not __fish_use_subcommand' -F\n", stream);
	for (int i = 0; (command = cli_command_row(i)); i++) {
		const struct cli_option *row;

		if (!known(i)) {
			fprintf(stream, "complete -c hawser -n __fish_use_subcommand -a %.*s -d '",
			        first(command->name), command->name);
			quoted(stream, command->summary, "");
			fputs("'\n", stream);
		}
		if (*object(command->name)) {
			fprintf(stream, "complete -c hawser -n '__fish_seen_subcommand_from %.*s' -a %s -d '",
			        first(command->name), command->name, object(command->name));
			quoted(stream, command->summary, "");
			fputs("'\n", stream);
		}
		if (takes_word(command)) {
			fish_condition(stream, command->name);
			fputs("' -f -a '", stream);
			input_words(stream, command);
			fputs("'\n", stream);
		}
		for (int k = 0; (row = cli_option_row(command, k)); k++) {
			fish_condition(stream, command->name);
			fprintf(stream, "' -l %s", row->name);
			if (row->letter)
				fprintf(stream, " -s %c", row->letter);
			fprintf(stream, "%s -d '", !*row->arguments ? "" : takes_file(row) ? " -r -F" : " -x");
			quoted(stream, row->doc, "");
			if (row->words) {
				fputs("' -a '", stream);
				option_words(stream, row);
			}
			fputs("'\n", stream);
		}
	}
}

/* --- the command --- */

static enum hawser_status run(void *context, struct hawser_report *report)
{
	static void (*const write[])(FILE *stream) = {bash, zsh, fish}; /* in the order of the input */
	const struct cli_common *common = context;
	int index = 0;
	enum hawser_status status = cli_choose_input(&index, &cli_completion, common->input, report);

	if (!status)
		write[index](stdout);
	return status;
}

const struct cli_command cli_completion = {
	"completion", "bash|zsh|fish", "Completion of commands and options in bash, zsh and fish", notes,
	options, NULL, sizeof(struct cli_common), 1, run, NULL,
	.takes = 0,
};
