/* cli/frame/hdf5.c - tables as HDF5.
 *
 * The library is loaded when a file is written, as MPI's (mpi.c): linked, it would make each start of
 * the program half as long again. Data sets grow by blocks of rows, compressed where the library has
 * zlib. They have no time stamps: the same map gives the same bytes.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/frame/hdf5.h"
#include "core/file.h"
#include "core/loaded.h"
#include "core/report.h"
#include "output/fields/fields.h"

#ifdef HAVE_HDF5
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include <hdf5.h>

enum { BLOCK = 16384 }; /* rows of a chunk: 128 kB of doubles; chosen */
enum { LEVEL = 1 };    /* of deflate, the fastest: a stronger one saves little; chosen */
enum { TRUNCATE = 2 }; /* H5F_ACC_TRUNC, whose macro calls functions by name */

/* Its functions, of the types that its header declares. */
#define FUNCTIONS(X) \
	X(H5dont_atexit) X(H5open) X(H5get_libversion) X(H5Eset_auto2) X(H5Fcreate) \
	X(H5Fclose) X(H5Gcreate2) X(H5Gclose) \
	X(H5Screate) X(H5Screate_simple) X(H5Sclose) X(H5Sselect_hyperslab) X(H5Pcreate) X(H5Pclose) \
	X(H5Pset_chunk) X(H5Pset_shuffle) X(H5Pset_deflate) X(H5Pset_obj_track_times) \
	X(H5Pset_link_creation_order) \
	X(H5Zfilter_avail) X(H5Dcreate2) X(H5Dset_extent) \
	X(H5Dget_space) X(H5Dwrite) X(H5Dclose) X(H5Acreate2) X(H5Awrite) X(H5Aclose) X(H5Tcopy) \
	X(H5Tset_size) X(H5Tset_cset) X(H5Tclose)
#define MEMBER(name) __typeof__(&(name)) name;
static struct {
	void *library;
	int is_ready;
	FUNCTIONS(MEMBER)
	const hid_t *real, *text, *set_creation, *group_creation;
} h5;

#define LOADED(member, name) hawser__loaded(&h5.member, sizeof h5.member, h5.library, name)

static int load(void)
{
	unsigned major = 0, minor = 0, release = 0;
	int all = 1;

	if (h5.library)
		return h5.is_ready;
	h5.library = dlopen(HDF5_LIBRARY, RTLD_LAZY | RTLD_LOCAL);
	if (!h5.library)
		return 0;
#define FIND(name) all = all && LOADED(name, #name);
	FUNCTIONS(FIND)
	all = all && LOADED(real, "H5T_NATIVE_DOUBLE_g") &&
	      LOADED(text, "H5T_C_S1_g") &&
	      LOADED(set_creation, "H5P_CLS_DATASET_CREATE_ID_g") &&
	      LOADED(group_creation, "H5P_CLS_GROUP_CREATE_ID_g");
	/* After a disk that was full, its own work at exit() would end in a segmentation fault: all is
	 * closed here. The constants are those of the headers' version. */
	all = all && h5.H5dont_atexit() >= 0 && h5.H5get_libversion(&major, &minor, &release) >= 0 &&
	      major == H5_VERS_MAJOR && minor == H5_VERS_MINOR && h5.H5open() >= 0 &&
	      h5.H5Eset_auto2(H5E_DEFAULT, NULL, NULL) >= 0;
	h5.is_ready = all;
	return all;
}

static enum hawser_status fail(const char *path, struct hawser_report *report)
{
	return hawser__fail(report, HAWSER_ERR_IO, "hdf5",
	                    "cannot write %s as HDF5: is there room on the disk?", path);
}

/* --- a column --- */

struct column {
	hid_t set, type;
	int words;
	char *block; /* [BLOCK] doubles, or texts of CLI_HDF5_WORD characters */
	size_t size; /* of one */
};

/* Data set `name` for at most `rows` rows. */
static int open_column(struct column *column, hid_t group, const char *name, int words, size_t rows)
{
	const hsize_t none = 0, chunk = rows < 1 ? 1 : rows < BLOCK ? rows : BLOCK, most = H5S_UNLIMITED;
	hid_t space = h5.H5Screate_simple(1, &none, &most), how = h5.H5Pcreate(*h5.set_creation);

	column->words = words;
	column->size = words ? CLI_HDF5_WORD : sizeof(double);
	column->block = calloc(BLOCK, column->size);
	column->type = h5.H5Tcopy(words ? *h5.text : *h5.real);
	if (words)
		h5.H5Tset_size(column->type, CLI_HDF5_WORD);
	h5.H5Pset_obj_track_times(how, 0);
	h5.H5Pset_chunk(how, 1, &chunk);
	if (h5.H5Zfilter_avail(H5Z_FILTER_DEFLATE) > 0) {
		h5.H5Pset_shuffle(how);
		h5.H5Pset_deflate(how, LEVEL);
	}
	column->set = h5.H5Dcreate2(group, name, column->type, space, H5P_DEFAULT, how, H5P_DEFAULT);
	h5.H5Pclose(how);
	h5.H5Sclose(space);
	return column->block && column->set >= 0;
}

/* 0: the cell is not of the column's kind, or too long for it. */
static int put(struct column *column, size_t at, const struct hawser__cell *cell)
{
	char *to = column->block + at*column->size;
	double number = cell->word ? NAN : cell->number;
	size_t length = cell->word ? strlen(cell->word) : 0;

	memset(to, 0, column->size);
	if (column->words && cell->word && length < CLI_HDF5_WORD)
		memcpy(to, cell->word, length);
	else if (!column->words && length == 0)
		memcpy(to, &number, sizeof number);
	else
		return 0;
	return 1;
}

static int flush(struct column *column, size_t done, size_t count)
{
	const hsize_t all = done + count, from = done, some = count;
	hid_t file, memory;
	int good;

	if (count == 0)
		return 1;
	good = h5.H5Dset_extent(column->set, &all) >= 0;
	file = h5.H5Dget_space(column->set);
	memory = h5.H5Screate_simple(1, &some, NULL);
	good = good && h5.H5Sselect_hyperslab(file, H5S_SELECT_SET, &from, NULL, &some, NULL) >= 0 &&
	       h5.H5Dwrite(column->set, column->type, memory, file, H5P_DEFAULT, column->block) >= 0;
	h5.H5Sclose(memory);
	h5.H5Sclose(file);
	return good;
}

static void close_column(struct column *column)
{
	if (column->set >= 0)
		h5.H5Dclose(column->set);
	if (column->type >= 0)
		h5.H5Tclose(column->type);
	free(column->block);
}

/* --- a table --- */

struct writer {
	const struct cli_hdf5_table *of;
	struct hawser__table row;
	struct column *column; /* [columns] */
	size_t done, waiting;
	hid_t group;
};

static int has_words(const struct hawser__field *field, const char *name)
{
	for (; !hawser__is_end(field); field++)
		if (field->column && strcmp(field->column, name) == 0)
			return field->kind == HAWSER__TEXT || field->kind == HAWSER__CHARS ||
			       field->kind == HAWSER__LABEL || field->kind == HAWSER__CONSTANT;
	return 0;
}

static int open_columns(struct writer *writer)
{
	const struct hawser__table *table = writer->of->table;
	size_t columns = (size_t)table->columns;
	int good = 1;

	for (size_t k = 0; k < columns; k++)
		good &= open_column(&writer->column[k], writer->group, table->column[k],
		                    has_words(writer->of->field, table->column[k]),
		                    table->rows + table->cells/columns);
	return good;
}

static int flush_all(struct writer *writer)
{
	int good = 1;

	for (int k = 0; k < writer->of->table->columns; k++)
		good &= flush(&writer->column[k], writer->done, writer->waiting);
	writer->done += writer->waiting;
	writer->waiting = 0;
	return good;
}

static int put_row(struct writer *writer, const struct hawser__cell *cell)
{
	int good = 1;

	for (int k = 0; k < writer->of->table->columns && good; k++)
		good = put(&writer->column[k], writer->waiting, &cell[k]);
	if (good && ++writer->waiting == BLOCK)
		good = flush_all(writer);
	return good;
}

static int put_rows(struct writer *writer)
{
	const struct hawser__table *table = writer->of->table;
	size_t columns = (size_t)table->columns;
	int good = open_columns(writer);

	for (size_t i = 0; i < table->rows && good; i++) {
		writer->row.cells = 0;
		table->fill(&writer->row, table->context, i);
		good = !writer->row.failed;
		if (good && writer->row.cells == columns)
			good = put_row(writer, writer->row.cell);
	}
	for (size_t at = 0; at + columns <= table->cells && good && columns > 0; at += columns)
		good = put_row(writer, table->cell + at);
	return good && flush_all(writer);
}

static int put_text(hid_t to, const char *name, const char *text)
{
	hid_t type = h5.H5Tcopy(*h5.text), space = h5.H5Screate(H5S_SCALAR), attribute;
	int good;

	h5.H5Tset_size(type, H5T_VARIABLE); /* h5py reads such a text as str */
	h5.H5Tset_cset(type, H5T_CSET_UTF8);
	attribute = h5.H5Acreate2(to, name, type, space, H5P_DEFAULT, H5P_DEFAULT);
	good = attribute >= 0 && h5.H5Awrite(attribute, type, &text) >= 0;
	h5.H5Aclose(attribute);
	h5.H5Sclose(space);
	h5.H5Tclose(type);
	return good;
}

static int put_number(hid_t to, const char *name, double number)
{
	hid_t space = h5.H5Screate(H5S_SCALAR);
	hid_t attribute = h5.H5Acreate2(to, name, *h5.real, space, H5P_DEFAULT, H5P_DEFAULT);
	int good = attribute >= 0 && h5.H5Awrite(attribute, *h5.real, &number) >= 0;

	h5.H5Aclose(attribute);
	h5.H5Sclose(space);
	return good;
}

/* The comments of the table in one text. */
static int put_comments(hid_t to, const struct hawser__table *table)
{
	size_t length = 1;
	char *text, *at;
	int good;

	for (int k = 0; k < table->comments; k++)
		length += strlen(table->comment[k]) + 1;
	text = at = calloc(length, 1);
	for (int k = 0; text && k < table->comments; k++)
		at += sprintf(at, "%s\n", table->comment[k]);
	good = text && put_text(to, "comments", text);
	free(text);
	return good;
}

/* Its data sets keep their order: readers have the columns as the table has them. */
static hid_t open_group(hid_t file, const char *name)
{
	hid_t how = h5.H5Pcreate(*h5.group_creation), group;

	h5.H5Pset_obj_track_times(how, 0);
	h5.H5Pset_link_creation_order(how, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED);
	group = h5.H5Gcreate2(file, name, H5P_DEFAULT, how, H5P_DEFAULT);
	h5.H5Pclose(how);
	return group;
}

static int put_table(hid_t file, const struct cli_hdf5_table *of)
{
	struct writer writer = {.of = of};
	int good;

	writer.column = malloc(((size_t)of->table->columns + 1)*sizeof *writer.column);
	if (!writer.column)
		return 0;
	for (int k = 0; k < of->table->columns; k++)
		writer.column[k] = (struct column){.set = -1, .type = -1};
	writer.group = open_group(file, of->name);
	good = writer.group >= 0 && put_comments(writer.group, of->table) && put_rows(&writer);
	for (int k = 0; k < of->table->columns; k++)
		close_column(&writer.column[k]);
	if (writer.group >= 0)
		h5.H5Gclose(writer.group);
	hawser__table_clear(&writer.row);
	free(writer.column);
	return good;
}

enum hawser_status cli_hdf5_check(const char *path, struct hawser_report *report)
{
	struct stat info;

	if (!path)
		return HAWSER_OK;
	if (strcmp(path, "-") == 0 || (stat(path, &info) == 0 && !S_ISREG(info.st_mode)))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "hdf5",
		                    "--hdf5 %s: HDF5 is written to a regular file only", path);
	if (!load())
		return hawser__fail(report, HAWSER_ERR_PROGRAM, "hdf5",
		                    "--hdf5: %s, with which this program was built, can't be loaded: install "
		                    "its Debian package, such as libhdf5-103-1, or use --tsv", HDF5_LIBRARY);
	return hawser__file_check(path, report);
}

enum hawser_status cli_hdf5_write(const char *path, const struct cli_hdf5_table *tables, int count,
                                  const struct cli_hdf5_fact *fact, int facts,
                                  struct hawser_report *report)
{
	struct hawser__file output;
	enum hawser_status status = cli_hdf5_check(path, report);
	hid_t file = -1;
	int good = 1;

	for (int k = 0; k < count && !status; k++)
		status = hawser__table_check(tables[k].table, report);
	if (!status)
		status = hawser__file_begin(&output, path, report);
	if (status)
		return status;
	if (output.temporary) /* empty so far */
		file = h5.H5Fcreate(output.temporary, TRUNCATE, H5P_DEFAULT, H5P_DEFAULT);
	good = file >= 0;
	for (int k = 0; k < facts && good; k++)
		good = fact[k].word ? put_text(file, fact[k].name, fact[k].word)
		                    : put_number(file, fact[k].name, fact[k].number);
	for (int k = 0; k < count && good; k++)
		good = put_table(file, &tables[k]);
	if (file >= 0)
		good &= h5.H5Fclose(file) >= 0;
	if (good)
		return hawser__file_commit(&output, report);
	hawser__file_abort(&output);
	return fail(path, report);
}

#else

enum hawser_status cli_hdf5_check(const char *path, struct hawser_report *report)
{
	return !path ? HAWSER_OK
	       : hawser__fail(report, HAWSER_ERR_PROGRAM, "hdf5",
	                      "--hdf5: this program is built without HDF5: build it where libhdf5-dev is "
	                      "installed, or use --tsv");
}

enum hawser_status cli_hdf5_write(const char *path, const struct cli_hdf5_table *tables, int count,
                                  const struct cli_hdf5_fact *fact, int facts,
                                  struct hawser_report *report)
{
	(void)tables, (void)count, (void)fact, (void)facts;
	return cli_hdf5_check(path, report);
}

#endif
