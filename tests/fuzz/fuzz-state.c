/* tests/fuzz/fuzz-state.c - any bytes as the file of --initial and --start, for a model with one to
 * eight coordinates (selected by the first byte). The result must be an error that names the file,
 * or a state of finite numbers that can be written and read again in each format.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/frame/cli.h"
#include "tests/fuzz/fuzz.h"

enum { MOST = 8 };

/* Units of the model: powers of two, so that the conversion does not round. */
static const double length = 2.0, omega = 0.5;

double cli_per_length(const struct cli_model *model)
{
	(void)model;
	return length;
}

double cli_per_omega(const struct cli_model *model)
{
	(void)model;
	return omega;
}

/* The file is standard input, which is faster than a file by name. */
static enum hawser_status open_text(double **state, const char *text, size_t size, int n,
                                    struct hawser_report *report)
{
	struct cli_model model = {.rom = {.n = n}};
	FILE *input = stdin;
	enum hawser_status status;

	/* fmemopen refuses an empty buffer */
	stdin = size ? fmemopen((void *)text, size, "r") : fopen("/dev/null", "r");
	status = cli_state_open(state, "-", &model, report);
	fclose(stdin);
	stdin = input;
	return status;
}

/* As text, as a list, and as two lists with names. */
static void write_again(const double *state, int n)
{
	static const char *const begin[] = {"# u, then velocities\n", "[", "{\"u\": ["};
	static const char *const comma[] = {" ", ", ", ", "};
	static const char *const middle[] = {"\n", ", ", "], \"v\": ["};
	static const char *const end[] = {"\n", "]", "]}"};

	for (int form = 0; form < 3; form++) {
		struct hawser_report report = {.message = ""};
		char text[2*MOST*32 + 64];
		double *again;
		size_t used = (size_t)sprintf(text, "%s", begin[form]);

		for (int i = 0; i < 2*n; i++)
			used += (size_t)sprintf(text + used, "%s%.17g",
			                        i == n ? middle[form] : i > 0 ? comma[form] : "",
			                        state[i]*(i < n ? length : length*omega));
		sprintf(text + used, "%s", end[form]);
		demand(!open_text(&again, text, strlen(text), n, &report),
		       "a state that was written can be read", report.message);
		for (int i = 0; i < 2*n; i++)
			demand(again[i] == state[i], "reading and writing change nothing", text);
		free(again);
	}
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
	struct hawser_report report = {.message = ""};
	int n = 1 + (size ? data[0] % MOST : 0), large = 0;
	double *state = NULL;
	enum hawser_status status = open_text(&state, (const char *)data + (size > 0),
	                                      size - (size > 0), n, &report);

	if (status) {
		demand(status == HAWSER_ERR_ARGUMENT && !strncmp(report.message, "-:", 2) &&
		       is_message(report.message), "a state error names the file", report.message);
		demand(!state, "what is refused is not kept", report.message);
		return 0;
	}
	for (int i = 0; i < 2*n; i++) {
		demand(isfinite(state[i]), "a state is finite", "");
		large |= fabs(state[i]) > 1e308/length;
	}
	if (!large)
		write_again(state, n);
	free(state);
	return 0;
}
