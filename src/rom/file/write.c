/* rom/file/write.c - the reduced-model file (hawser-rom(5)): numbers have 17 digits, so that reading
 * restores the same bits; each entry is a line, so that two models can be compared line by line.
 *
 * The model is written member by member: a model of 60 modes has 1.2e6 entries, and a tree or a text
 * of them would take ten times the memory of the model.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdio.h>
#include <stdlib.h>

#include "core/file.h"
#include "core/report.h"
#include "rom/file/entries.h"
#include "rom/terms/drag.h"
#include "rom/terms/ends.h"
#include "rom/energy/law.h"
#include "rom/file/read.h"
#include "rom/terms/terms.h"
#include "rom/file/writer.h"

/* --- parts of the model --- */

static void vector(struct hawser__writer *to, const char *key, const double *value, int n)
{
	hawser__write_key(to, key);
	hawser__write_numbers(to, value, (size_t[]){(size_t)n}, 1);
}

static void matrix(struct hawser__writer *to, const char *key, const double *value, int rows,
                   int columns)
{
	hawser__write_key(to, key);
	hawser__write_numbers(to, value, (size_t[]){(size_t)rows, (size_t)columns}, 2);
}

/* [shape[0]][shape[1]][shape[2]] */
static void block(struct hawser__writer *to, const char *key, const double *value,
                  const size_t shape[3])
{
	hawser__write_key(to, key);
	hawser__write_numbers(to, value, shape, 3);
}

static void number(struct hawser__writer *to, const char *key, double value)
{
	hawser__write_key(to, key);
	hawser__write_number(to, value);
}

static void integer(struct hawser__writer *to, const char *key, int value)
{
	hawser__write_key(to, key);
	hawser__write_integer(to, value);
}

static void words(struct hawser__writer *to, const char *key, char *const *word, int n)
{
	hawser__write_key(to, key);
	hawser__write_begin(to, '[', 0);
	for (int i = 0; i < n; i++)
		hawser__write_word(to, word[i]);
	hawser__write_end(to);
}

static void entries(struct hawser__writer *to, const char *key, const void *list, int indices,
                    int count)
{
	hawser__write_key(to, key);
	hawser__write_begin(to, '[', count > 0);
	for (int i = 0; i < count; i++) {
		struct hawser__entry entry = hawser__entry(list, indices, i);

		hawser__write_entry(to, entry.index, indices, entry.value);
	}
	hawser__write_end(to);
}

static void products(struct hawser__writer *to, const struct hawser_term *term, int count)
{
	if (count == 0)
		return;
	hawser__write_key(to, "terms");
	hawser__write_begin(to, '[', 1);
	for (int i = 0; i < count; i++) {
		const struct hawser_term *t = &term[i];

		hawser__write_begin(to, '[', 0);
		hawser__write_integer(to, t->j);
		for (int part = 0; part < 2; part++) {
			hawser__write_begin(to, '[', 0);
			for (int f = part ? t->factors - t->rates : 0;
			     f < (part ? t->factors : t->factors - t->rates); f++)
				hawser__write_integer(to, t->factor[f]);
			hawser__write_end(to);
		}
		hawser__write_number(to, t->value);
		hawser__write_end(to);
	}
	hawser__write_end(to);
}

static void term(struct hawser__writer *to, const double *f, const double *D, const double *K, int n)
{
	if (f)
		vector(to, "f", f, n);
	if (D)
		matrix(to, "D", D, n, n);
	if (K)
		matrix(to, "K", K, n, n);
}

static void harmonic(struct hawser__writer *to, const struct hawser_harmonic *h, int n, int points,
                     int known)
{
	hawser__write_begin(to, '{', h->D || h->K || h->quads > 0 || h->terms > 0 || h->answer);
	integer(to, "k", h->k);
	hawser__write_key(to, "phase");
	hawser__write_word(to, h->phase == HAWSER_COS ? "cos" : "sin");
	integer(to, "omega_power", h->omega_power);
	if (h->load_power > 1)
		integer(to, "load_power", h->load_power);
	term(to, h->f, h->D, h->K, n);
	if (h->quads > 0)
		entries(to, "Q", h->Q, 3, h->quads);
	products(to, h->term, h->terms);
	if (h->answer)
		block(to, "answer", h->answer, (size_t[]){2, (size_t)points, 4});
	if (h->known)
		vector(to, "known", h->known, known);
	hawser__write_end(to);
}

static void ramp(struct hawser__writer *to, const struct hawser_ramp *from, int n, int points)
{
	hawser__write_key(to, "ramp");
	hawser__write_begin(to, '{', 1);
	number(to, "time", from->time);
	for (int p = 0; p < HAWSER_RAMP_TERMS; p++) {
		const struct hawser_ramp_term *part = &from->term[p];

		hawser__write_key(to, hawser__ramp_names[p]);
		hawser__write_begin(to, '{', part->D || part->K || (part->answer && points > 0));
		term(to, part->f, part->D, part->K, n);
		if (part->answer)
			matrix(to, "answer", part->answer, points, 4);
		hawser__write_end(to);
	}
	hawser__write_end(to);
}

/* One that drives nothing, as where no mode feels the load: the reader takes it for a mistake. */
static int is_empty(const struct hawser_harmonic *h)
{
	return !h->f && !h->D && !h->K && h->quads == 0 && h->terms == 0 && !h->answer && !h->known;
}

static void harmonics(struct hawser__writer *to, const struct hawser_rom *rom)
{
	hawser__write_key(to, "harmonics");
	hawser__write_begin(to, '[', rom->harmonics > 0);
	for (int h = 0; h < rom->harmonics; h++)
		if (!is_empty(&rom->harmonic[h]))
			harmonic(to, &rom->harmonic[h], rom->n, rom->shapes.points, rom->known.modes);
	hawser__write_end(to);
}

static void scale(struct hawser__writer *to, const struct hawser_rom *rom)
{
	hawser__write_key(to, "scale");
	hawser__write_begin(to, '{', 0);
	number(to, "length", rom->length);
	number(to, "time", rom->time);
	number(to, "force", rom->force);
	hawser__write_end(to);
}

static void shapes(struct hawser__writer *to, const struct hawser_rom *rom)
{
	const struct hawser_rom_shapes *s = &rom->shapes;
	const size_t shape[3] = {(size_t)rom->n, (size_t)s->points, 3};

	hawser__write_key(to, "shapes");
	hawser__write_begin(to, '{', 1);
	words(to, "names", s->name, s->points);
	vector(to, "s", s->s, s->points);
	matrix(to, "tangent", s->tangent, s->points, 2);
	if (s->turned)
		matrix(to, "axes", s->axes[0], 3, 3);
	vector(to, "stretch", s->stretch, s->points);
	block(to, "shape", s->shape, shape);
	block(to, "slope", s->slope, shape);
	number(to, "EA", s->EA);
	if (s->mach2 != 0.0)
		number(to, "mach2", s->mach2);
	if (s->second_shape) {
		const size_t second[3] = {(size_t)rom->n*(rom->n + 1)/2, (size_t)s->points, 3};

		block(to, "second_shape", s->second_shape, second);
		block(to, "second_slope", s->second_slope, second);
	}
	hawser__write_end(to);
}

static void contacts(struct hawser__writer *to, const struct hawser_rom *rom)
{
	hawser__write_key(to, "contacts");
	hawser__write_begin(to, '{', 1);
	words(to, "names", rom->contacts.name, rom->contacts.count);
	matrix(to, "turn", rom->contacts.turn, rom->n, rom->contacts.count);
	hawser__write_end(to);
}

static void known(struct hawser__writer *to, const struct hawser_rom *rom)
{
	const struct hawser_rom_known *k = &rom->known;
	const size_t shape[3] = {(size_t)k->modes, (size_t)rom->shapes.points, 4};

	hawser__write_key(to, "known");
	hawser__write_begin(to, '{', k->modes > 0);
	number(to, "reach", k->reach);
	if (k->modes > 0) {
		vector(to, "K", k->K, k->modes);
		vector(to, "D", k->D, k->modes);
		block(to, "shape", k->shape, shape);
	}
	hawser__write_end(to);
}

static void ends(struct hawser__writer *to, const struct hawser_rom *rom)
{
	const struct hawser_rom_ends *e = rom->ends;
	const size_t points = (size_t)rom->shapes.points;

	hawser__write_key(to, "ends");
	hawser__write_begin(to, '{', 1);
	hawser__write_key(to, "k");
	hawser__write_begin(to, '[', 0);
	for (int t = 0; t < e->terms; t++)
		hawser__write_integer(to, e->k[t]*e->base);
	hawser__write_end(to);
	matrix(to, "cos", e->cosine, e->terms, e->count);
	matrix(to, "sin", e->sine, e->terms, e->count);
	block(to, "slope", e->slope, (size_t[]){(size_t)e->count, points, 3});
	if (e->second_shape) {
		const size_t second[3] = {hawser__ends_pairs(e), points, 3};

		block(to, "second_shape", e->second_shape, second);
		block(to, "second_slope", e->second_slope, second);
	}
	hawser__write_end(to);
}

static void ranges(struct hawser__writer *to, const struct hawser_rom *rom)
{
	int known = 0;

	for (int j = 0; j < rom->n; j++)
		known |= rom->range[j].end != HAWSER_RANGE_UNKNOWN;
	if (!known)
		return;
	hawser__write_key(to, "range");
	hawser__write_begin(to, '[', 1);
	for (int j = 0; j < rom->n; j++) {
		if (rom->range[j].end == HAWSER_RANGE_UNKNOWN)
			continue;
		hawser__write_begin(to, '{', 0);
		integer(to, "coordinate", j);
		number(to, "amplitude", rom->range[j].amplitude);
		number(to, "largest", rom->range[j].largest);
		hawser__write_key(to, "end");
		hawser__write_word(to, hawser__range_ends[rom->range[j].end]);
		hawser__write_end(to);
	}
	hawser__write_end(to);
}

static void members(struct hawser__writer *to, const struct hawser_rom *rom)
{
	integer(to, "hawser_rom", 1);
	integer(to, "n", rom->n);
	matrix(to, "D", rom->D, rom->n, rom->n);
	matrix(to, "K", rom->K, rom->n, rom->n);
	entries(to, "Q", rom->Q, 3, rom->quads);
	entries(to, "C", rom->C, 4, rom->cubics);
	products(to, rom->term, rom->terms);
	if (rom->periods > 1)
		integer(to, "periods", rom->periods);
	harmonics(to, rom);
	if (rom->ramp)
		ramp(to, rom->ramp, rom->n, rom->shapes.points);
	if (rom->label)
		words(to, "labels", rom->label, rom->n);
	if (rom->inertia.shapes > 0)
		integer(to, "second_order_shapes", rom->inertia.shapes);
	if (rom->scaled)
		scale(to, rom);
	if (rom->shapes.points > 0)
		shapes(to, rom);
	if (rom->range)
		ranges(to, rom);
	if (rom->contacts.count > 0)
		contacts(to, rom);
	if (rom->known.reach > 0.0)
		known(to, rom);
	if (rom->ends && rom->shapes.points > 0)
		ends(to, rom);
}

/* --- the file --- */

/* The same pass as for writing, without a stream, so that nothing is written of a model that cannot be
 * written completely. */
static enum hawser_status check(const struct hawser_rom *rom, struct hawser_report *report)
{
	struct hawser__writer to;

	if (rom->drag)
		return hawser__drag_refuse(rom, "a reduced-model file", report);
	if (rom->plug)
		return hawser__more_refuse(rom, "a reduced-model file", report);
	if (rom->exact)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
		                    "a model with the exact strain energy can't be written as a "
		                    "reduced-model file, which holds quadratic and cubic terms: take "
		                    "model.energy: quartic, or pass the scene on");
	hawser__writer_begin(&to, NULL, HAWSER__WRITE_FILE);
	members(&to, rom);
	if (to.invalid)
		return hawser__fail(report, HAWSER_ERR_NAN, "rom",
		                    "the model can't be written: a number in it is not finite, or a name "
		                    "is not UTF-8");
	return to.failed ? hawser__no_memory(report, "rom") : HAWSER_OK;
}

/* Returns nonzero if memory ran out; errors of the stream are the caller's to look for. */
static int print(FILE *stream, const struct hawser_rom *rom)
{
	struct hawser__writer to;

	hawser__writer_begin(&to, stream, HAWSER__WRITE_FILE);
	hawser__write_begin(&to, '{', 1);
	members(&to, rom);
	hawser__write_end(&to);
	fputc('\n', stream);
	return to.failed;
}

enum hawser_status hawser_rom_write_members(const struct hawser_rom *rom, FILE *stream,
                                            struct hawser_report *report)
{
	struct hawser__writer to;

	if (!stream)
		return check(rom, report);
	hawser__writer_begin(&to, stream, HAWSER__WRITE_MEMBERS);
	members(&to, rom);
	return to.failed ? hawser__no_memory(report, "rom") : HAWSER_OK;
}

enum hawser_status hawser_rom_text(const struct hawser_rom *rom, char **text,
                                   struct hawser_report *report)
{
	enum hawser_status status = check(rom, report);
	FILE *stream;
	size_t size;
	int bad;

	*text = NULL;
	if (status)
		return status;
	stream = open_memstream(text, &size);
	bad = !stream || print(stream, rom);
	bad |= stream && ferror(stream);
	/* when memory is short, glibc's fclose returns 0 but sets no text */
	if (stream && (fclose(stream) != 0 || !*text))
		bad = 1;
	if (!bad)
		return HAWSER_OK;
	free(*text);
	*text = NULL;
	return hawser__no_memory(report, "rom");
}

enum hawser_status hawser_rom_save(const struct hawser_rom *rom, const char *path,
                                   struct hawser_report *report)
{
	enum hawser_status status = check(rom, report);
	struct hawser__file file;

	if (!status)
		status = hawser__file_begin(&file, path, report);
	if (status)
		return status;
	if (print(file.stream, rom)) {
		hawser__file_abort(&file);
		return hawser__no_memory(report, "rom");
	}
	return hawser__file_commit(&file, report);
}
