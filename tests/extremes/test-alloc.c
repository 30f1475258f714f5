/* Every allocation of every command fails once. The program must end with status 4 and a message, or
 * with the same result as without the failure. It must not end by a signal, hang, or leave a file.
 *
 * The program runs with alloc.c preloaded. A first run lists the places that allocate, identified by
 * their callers. Then there is one run per place in which that place fails. `make check` tests SHORT
 * places per command, evenly spaced and the same in every run; HAWSER_LONG=1 tests all. Under gcc's
 * AddressSanitizer leaks are errors too.
 *
 * If a thread of a map with two threads cannot be created, the other threads must do its work.
 *
 * Two libraries are excluded, because they end the program themselves: udunits2 2.2.28 exits with
 * status 2, fails an assertion or dereferences a null pointer (the scenes here have no units, so that
 * udunits2 is not called); OpenBLAS 0.3.21 writes to a null pointer in its kernels for small matrix
 * products on processors with AVX-512 (dgemm_small_kernel_*). alloc.c has the backtrace, and lets these
 * calls succeed.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/tap.h"

enum { SHORT = 8, WORDS = 24, MOST = 20000, BYTES = 1 << 20 };

static const char scene[] =
	"cable: {EA: 4e8, rho: 6}\nspan: {d: 250, h: 10}\ntension: {T0: 8e4}\n"
	"damping: {alpha: 0.08}\nload: {frame: local, per_length: [0.8, 0.8, 0.8]}\n"
	"model: {modes: 2, basis: 10}\n";
static const char travelling[] =
	"cable: {EA: 4e8, rho: 6}\nspan: {d: 250, h: 0}\ntension: {T0: 8e4}\n"
	"travel: {speed: 20, hold: tension}\nmodel: {modes: 2, basis: 10}\n";

/* Words of a command line (~ is a blank within a word). `most` limits the number of places tested.
 * timed: the output contains times, so it is not compared with that of a run without failure. */
static const struct {
	const char *line;
	int most, timed;
} commands[] = {
	{"statics s.yaml --points 3 --json o.json --tsv o.tsv", MOST, 0},
	{"modes s.yaml --tsv o.tsv --json o.json", MOST, 0},
	{"modes travel.yaml --tsv o.tsv", MOST, 0},
	{"modes s.yaml --method fdm --set model.basis=30 --tsv o.tsv", MOST, 0},
	{"irvine s.yaml --tsv o.tsv", MOST, 0},
	{"campbell travel.yaml -n 2 --tsv o.tsv", 300, 0},
	{"rom s.yaml --json o.json", MOST, 0},
	{"rom o-model.json --export auto oscillator", MOST, 0},
	{"integrate s.yaml --Omega 1w1 --until 0.5 --every 0.25 --json o.json", MOST, 0},
	{"integrate o-model.json --Omega 1 --until 0.5 --every 0.25 --tsv o.tsv", MOST, 0},
	{"frf o-model.json --from 0.7 --to 0.75 --json o.json --tsv o.tsv", MOST, 0},
	{"frf s.yaml -n 1 --from 0.7w1 --to 0.72w1 --tsv o.tsv", MOST, 0},
	{"folds o-model.json --json o.json", 300, 0},
	{"map o-model.json --x Omega=1:2 --y factor.load=1:3 --points 3x3 --threads 1 "
	 "--checkpoint o.check --tsv o.tsv", MOST, 0},
	{"map o-model.json --x Omega=1:2 --y factor.load=1:3 --points 3x3 --threads 2 "
	 "--tsv o.tsv", MOST, 0},
	{"mms o-model.json --tsv o.tsv", 300, 0},
	{"hill o-model.json --Omega 1 --tsv o.tsv", 300, 0},
	{"beam beam.yaml --tsv o.tsv", 300, 0},
	{"plan s.yaml --fidelities raw~2,condensed~2 --tsv o.tsv", 300, 1},
	{"compare modes s.yaml --method fdm --from 10 --to 20", 100, 1},
	{"compare s.yaml --fidelities raw~1,raw~2 --from 0.9w1 --to 0.92w1 --limit 50", 100, 1},
};

static const char *hawser, *preload;
static char *wanted, *got;
static size_t wanted_size;

static void put(const char *name, const char *text)
{
	FILE *stream = fopen(name, "w");

	if (!stream || fputs(text, stream) < 0 || fclose(stream) != 0) {
		perror(name);
		exit(99);
	}
}

/* The first BYTES bytes of a file; -1 if there is no file. */
static long slurp(char *text, const char *name)
{
	FILE *stream = fopen(name, "r");
	size_t size;

	if (!stream)
		return -1;
	size = fread(text, 1, BYTES - 1, stream);
	text[size] = '\0';
	fclose(stream);
	return (long)size;
}

/* Times are not compared: "wall_time_secs": 0.00434. */
static void hide_times(char *text, const char *before)
{
	for (char *at = text; (at = strstr(at, before)); ) {
		at += strlen(before);
		memmove(at, at + strspn(at, "0123456789.e+-"), strlen(at + strspn(at, "0123456789.e+-")) + 1);
	}
}

/* All output of a run in one string: its files by name, and its messages. Files that are not inputs
 * are removed. */
static size_t gather(char *text)
{
	static const char *const outputs[] = {"out", "o.json", "o.tsv", "oscillator.f90",
		"c.oscillator", "oscillator.auto", NULL};
	size_t size = 0;

	for (int i = 0; outputs[i]; i++) {
		long more = slurp(text + size, outputs[i]);

		size += more > 0 ? (size_t)more : 0;
		size = size < BYTES ? size : BYTES - 1;
		if (i > 0)
			unlink(outputs[i]);
	}
	unlink("o.check");
	text[size] = '\0';
	hide_times(text, "_secs\": ");
	hide_times(text, "\"seconds\": ");
	return strlen(text);
}

/* Number of files in the folder that no run should leave, and the name of the first. */
static int strangers(char *name, size_t size)
{
	static const char known[] =
		" . .. s.yaml travel.yaml beam.yaml o-model.json out err list o.check ";
	DIR *folder = opendir(".");
	struct dirent *entry;
	char spaced[300];
	int count = 0;

	while (folder && (entry = readdir(folder))) {
		snprintf(spaced, sizeof spaced, " %s ", entry->d_name);
		if (strstr(known, spaced))
			continue;
		if (count++ == 0)
			snprintf(name, size, "%s", entry->d_name);
		unlink(entry->d_name);
	}
	if (folder)
		closedir(folder);
	return count;
}

static void redirect(int fd, const char *name)
{
	int to = open(name, O_WRONLY | O_CREAT | O_TRUNC, 0666);

	if (to < 0 || dup2(to, fd) < 0)
		_exit(98);
	close(to);
}

/* Run a command line with one environment variable set. Returns the status of wait(). */
static int run(const char *line, const char *variable, const char *value)
{
	char copy[256], *word[WORDS + 1] = {(char *)hawser}, *rest = copy;
	int status, n = 1;
	pid_t child;

	snprintf(copy, sizeof copy, "%s", line);
	for (; n < WORDS && (word[n] = strsep(&rest, " ")); n++)
		for (char *blank = word[n]; (blank = strchr(blank, '~')); )
			*blank = ' ';
	word[n] = NULL;
	fflush(stdout);
	child = fork();
	if (child == 0) {
		redirect(1, "out");
		redirect(2, "err");
		setenv(variable, value, 1);
		/* recording the list loads a library permanently */
		setenv("ASAN_OPTIONS", strstr(variable, "LIST")
		       ? "detect_leaks=0:verify_asan_link_order=0:exitcode=77"
		       : "detect_leaks=1:verify_asan_link_order=0:exitcode=77", 1);
		setenv("LD_PRELOAD", preload, 1);
		alarm(60);
		execv(hawser, word);
		_exit(97);
	}
	while (waitpid(child, &status, 0) < 0 && errno == EINTR)
		;
	return status;
}

/* The first call of each place, in *call. Returns their number. */
static int list(long **call)
{
	FILE *stream = fopen("list", "r");
	long total = 0, one;
	int count = 0;

	*call = calloc(MOST, sizeof **call);
	if (!stream || !*call || fscanf(stream, "%ld", &total) != 1)
		total = 0;
	while (total && count < MOST && fscanf(stream, "%ld", &one) == 1)
		(*call)[count++] = one;
	if (stream)
		fclose(stream);
	return count;
}

/* If an allocation fails in its number conversion, jansson 2.14 writes a number with a wrong or missing
 * last digit and reports no error. The difference is a few characters in a result of thousands. */
static int costs_digits(size_t have)
{
	size_t i = 0, j = 0;

	if (have + 8 < wanted_size || have > wanted_size + 8)
		return 0;
	while (i < have && got[i] == wanted[i])
		i++;
	while (j < have - i && j < wanted_size - i && got[have - 1 - j] == wanted[wanted_size - 1 - j])
		j++;
	return have - i - j < 16 && strspn(got + i, "0123456789") >= have - i - j;
}

/* Why the end of a run with a failed allocation is wrong, or NULL. */
static const char *fault(int status, int timed, char *name, size_t size)
{
	static char said[BYTES];
	size_t have;
	int strange;

	if (slurp(said, "err") < 0)
		said[0] = '\0';
	have = gather(got);
	strange = strangers(name, size);
	if (strstr(said, "Sanitizer") || strstr(said, "runtime error"))
		return "a sanitizer's report";
	if (WIFSIGNALED(status))
		return WTERMSIG(status) == SIGALRM ? "a hang" : "ended by a signal";
	if (strange)
		return "a file is left";
	if (WEXITSTATUS(status) == 0)
		return timed || (have == wanted_size && !memcmp(got, wanted, have)) ||
		       costs_digits(have) ? NULL : "it says that all is well, with another result";
	if (WEXITSTATUS(status) != 4)
		return "status";
	return strncmp(said, "hawser: ", 8) || !strchr(said, '\n') ? "no message" : NULL;
}

static void sweep(const char *line, int most, int timed)
{
	long *call;
	char number[32], name[300] = "";
	const char *why, *first = NULL;
	long first_call = 0;
	int status, count, bad = 0, tried = 0, step;

	status = run(line, "HAWSER_ALLOC_LIST", "list");
	wanted_size = gather(wanted);
	strangers(name, sizeof name);
	count = list(&call);
	if (!getenv("HAWSER_LONG") && most > SHORT)
		most = SHORT;
	step = (count + most - 1)/most;
	ok(WIFEXITED(status) && WEXITSTATUS(status) == 0 && count > 20,
	   "hawser %s: status %d, %d places allocate", line, WEXITSTATUS(status), count);
	for (int i = 0; i < count; i += step, tried++) {
		snprintf(number, sizeof number, "%ld", call[i]);
		status = run(line, "HAWSER_ALLOC_FAIL", number);
		why = fault(status, timed, name, sizeof name);
		if (why && bad++ == 0) {
			first = why;
			first_call = call[i];
		}
		if (why && bad < 20) {
			slurp(got, "err");
			printf("# call %ld: %s (status %#x) %s%.200s\n", call[i], why, (unsigned)status,
			       name, got);
		}
	}
	ok(bad == 0, "failing one by one, %d of them are told, or do not matter%s%s", tried,
	   first ? "; first: " : "", first ? first : "");
	if (bad)
		printf("# HAWSER_ALLOC_FAIL=%ld, %d in all\n", first_call, bad);
	free(call);
}

/* 1: the preloaded library receives the allocations of the program. */
static int works(void)
{
	long *call;
	int status = run("--version", "HAWSER_ALLOC_LIST", "list"), count = list(&call);

	free(call);
	return WIFEXITED(status) && WEXITSTATUS(status) == 0 && count > 0;
}

CASE(extremes_alloc)
{
	char folder[] = "alloc-XXXXXX", clean[64], libraries[4096];

	hawser = getenv("HAWSER_REAL");
	preload = getenv("HAWSER_PRELOAD");
	wanted = malloc(8*BYTES);
	got = malloc(8*BYTES);
	if (!hawser || !strchr(hawser, '/') || !preload || !wanted || !got || !mkdtemp(folder) ||
	    chdir(folder) != 0)
		return 99;
	setenv("OMP_NUM_THREADS", "1", 1);
	snprintf(libraries, sizeof libraries, "%.*s", (int)(strrchr(hawser, '/') - hawser), hawser);
	setenv("LD_LIBRARY_PATH", libraries, 1);
	put("s.yaml", scene);
	put("travel.yaml", travelling);
	put("beam.yaml", "beam: {mu: 1, rho: 10}\n");
	put("o-model.json", "{\"hawser_rom\": 1, \"n\": 1, \"D\": [[0.05]], \"K\": [[1]], "
	    "\"C\": [[0, 0, 0, 0, 0.1]], \"harmonics\": [{\"k\": 1, \"phase\": \"cos\", "
	    "\"omega_power\": 0, \"f\": [0.2]}]}\n");
	if (!works())
		ok(1, "# SKIP allocations can't be seen in this build (a static program, or clang's "
		   "sanitizers)");
	else
		for (size_t i = 0; i < sizeof commands/sizeof *commands; i++)
			sweep(commands[i].line, commands[i].most, commands[i].timed);
	if (chdir("..") == 0) {
		snprintf(clean, sizeof clean, "rm -rf %s", folder);
		ok(system(clean) == 0, "clean again");
	}
	free(wanted);
	free(got);
	return done_testing();
}
