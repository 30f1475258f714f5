/* rom/file/writer.c - JSON written to a stream as it is generated, in the layouts of reduced-model
 * files.
 *
 * Errors of the stream are not looked at: its owner finds them with ferror().
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <jansson.h>
#include <math.h>

#include "rom/file/writer.h"

void hawser__writer_begin(struct hawser__writer *to, FILE *stream, enum hawser__layout layout)
{
	to->stream = stream;
	to->layout = layout;
	to->failed = to->invalid = to->depth = to->keyed = 0;
	if (stream)
		hawser__powers_make(&to->powers);
	if (layout == HAWSER__WRITE_MEMBERS) /* the caller has written "{" */
		to->container[to->depth++] = (struct hawser__container){'{', 1, 0};
}

static void new_line(struct hawser__writer *to)
{
	int width = to->layout == HAWSER__WRITE_FILE ? 2 : 1;

	fprintf(to->stream, "\n%*s", width*to->depth, "");
}

/* What stands before a member: nothing after a key. */
static void separate(struct hawser__writer *to)
{
	struct hawser__container *in;

	if (to->keyed || to->depth == 0) {
		to->keyed = 0;
		return;
	}
	in = &to->container[to->depth - 1];
	if (in->count > 0)
		fputs(in->broken ? "," : ", ", to->stream);
	/* the caller has written the line end before the first member of all */
	if (in->broken && (in->count > 0 || to->depth > 1 || to->layout == HAWSER__WRITE_FILE))
		new_line(to);
	in->count++;
}

static int is_broken(const struct hawser__writer *to, char bracket, int nested)
{
	if (to->depth == 0)
		return 1;
	if (to->layout == HAWSER__WRITE_FILE)
		return nested;
	return nested && to->depth == 1 && bracket == '[';
}

void hawser__write_begin(struct hawser__writer *to, char bracket, int nested)
{
	if (!to->stream)
		return;
	separate(to);
	fputc(bracket, to->stream);
	to->container[to->depth] = (struct hawser__container){bracket, is_broken(to, bracket, nested), 0};
	to->depth++;
}

void hawser__write_end(struct hawser__writer *to)
{
	const struct hawser__container *in;

	if (!to->stream)
		return;
	in = &to->container[--to->depth];
	if (in->broken && in->count > 0)
		new_line(to);
	fputc(in->bracket == '{' ? '}' : ']', to->stream);
}

void hawser__write_key(struct hawser__writer *to, const char *key)
{
	if (!to->stream)
		return;
	separate(to);
	fprintf(to->stream, "\"%s\": ", key);
	to->keyed = 1;
}

void hawser__write_number(struct hawser__writer *to, double value)
{
	char text[HAWSER__DIGITS_SIZE];

	to->invalid |= !isfinite(value);
	if (!to->stream || !isfinite(value))
		return;
	separate(to);
	/* cppcheck-suppress uninitvar ; it is filled there */
	fwrite(text, 1, hawser__digits(text, value, &to->powers), to->stream);
}

void hawser__write_integer(struct hawser__writer *to, int value)
{
	if (!to->stream)
		return;
	separate(to);
	fprintf(to->stream, "%d", value);
}

void hawser__write_word(struct hawser__writer *to, const char *word)
{
	json_t *string = json_string(word);

	/* a second attempt distinguishes a failed allocation from invalid UTF-8 */
	if (!string)
		string = json_string(word);
	to->invalid |= !string;
	if (string && to->stream) {
		separate(to);
		to->failed |= json_dumpf(string, to->stream, JSON_ENCODE_ANY) != 0;
	}
	json_decref(string);
}

void hawser__write_numbers(struct hawser__writer *to, const double *value, const size_t *shape,
                           int rank)
{
	size_t below = 1;

	for (int i = 1; i < rank; i++)
		below *= shape[i];
	hawser__write_begin(to, '[', rank > 1 && shape[0] > 0);
	for (size_t i = 0; i < shape[0]; i++) {
		if (rank == 1)
			hawser__write_number(to, value[i]);
		else
			hawser__write_numbers(to, value + i*below, shape + 1, rank - 1);
	}
	hawser__write_end(to);
}

/* One call of fwrite: nearly all of a large model is such lists. */
void hawser__write_entry(struct hawser__writer *to, const int *index, int count, double value)
{
	char text[4*16 + HAWSER__DIGITS_SIZE + 2], *end = text;

	to->invalid |= !isfinite(value);
	if (!to->stream || !isfinite(value))
		return;
	separate(to);
	*end++ = '[';
	for (int i = 0; i < count; i++) {
		if (index[i] >= 0 && index[i] < 100) {
			if (index[i] > 9)
				*end++ = (char)('0' + index[i]/10);
			*end++ = (char)('0' + index[i]%10);
		} else {
			end += sprintf(end, "%d", index[i]);
		}
		*end++ = ',';
		*end++ = ' ';
	}
	end += hawser__digits(end, value, &to->powers);
	*end++ = ']';
	fwrite(text, 1, (size_t)(end - text), to->stream);
}
