/* tests/run.c - run the cases of the test programs and the test scripts, several at the same time.
 *
 *   tests/run [OPTIONS] PROGRAM... SCRIPT...
 *
 *   -j JOBS       so many at the same time (1)
 *   -t PATTERN    only these tests: property/frf, 'cli/net*', tests/cli/net.sh, or tests/rom, which
 *                 is all cases of this program
 *   -T FILE       only those whose names are the first words of its lines
 *   -x PATTERN    without these
 *   -X FILE       without those whose names are the first words of its lines; up to 4 files
 *   -w COMMAND    words before the name of a program, such as valgrind's; scripts run as they are
 *   -s SECONDS    a test that takes more processor time, on a machine that is not busy, fails,
 *   -r FILE       unless its name is the first word of a line here, with the reason behind it
 *   -g FOLDER     what a build with --coverage counts goes to FOLDER/NAME, test by test (absolute)
 *   -l FOLDER     of the logs (tests/log)
 *   -o FILE       a row a test: result, checks, times. What took longest by this file is started first
 *
 * A test is a case of a program (tests/cases.c) or a script. Each runs in a process of its own, and
 * prints the Test Anything Protocol.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "tests/run.h"

/* Seconds of the clock after which a test counts as one that does not end. */
static const int patience_secs = 1800;
/* Seconds between lines of progress where standard output is no terminal. */
static const double silence_secs = 10;

static double now(void)
{
	struct timespec t;

	clock_gettime(CLOCK_MONOTONIC, &t);
	return (double)t.tv_sec + 1e-9*(double)t.tv_nsec;
}

/* --- the last run's times, and those of this one */

static void read_times(struct run *run)
{
	char line[512], name[NAME];
	FILE *file = run->results ? fopen(run->results, "r") : NULL;
	double seconds;

	while (file && fgets(line, sizeof line, file))
		if (sscanf(line, "%127s %*s %*s %*s %*s %lf", name, &seconds) == 2)
			for (int i = 0; i < run->count; i++)
				if (strcmp(run->tests[i].name, name) == 0)
					run->tests[i].expected_secs = seconds;
	if (file)
		fclose(file);
}

/* The longest first; what has not run yet before all. */
static int longest_first(const void *a, const void *b)
{
	double x = ((const struct test *)a)->expected_secs, y = ((const struct test *)b)->expected_secs;

	return x < 0 || y < 0 ? (y < 0) - (x < 0) : (x < y) - (x > y);
}

static const char *result(const struct test *test)
{
	return test->failed || test->status ? "fail" : test->passed ? "pass" : "skip";
}

static void write_results(const struct run *run)
{
	FILE *file = run->results ? fopen(run->results, "w") : NULL;

	if (!run->results)
		return;
	if (!file)
		stop("cannot write", run->results);
	fputs("test\tresult\tpassed\tfailed\tskipped\tprocessor_s\tclock_s\n", file);
	for (int i = 0; i < run->count; i++) {
		const struct test *test = &run->tests[i];

		if (test->done)
			fprintf(file, "%s\t%s\t%d\t%d\t%d\t%.3f\t%.3f\n", test->name, result(test),
			        test->passed, test->failed, test->skipped, test->processor, test->clock);
	}
	if (fclose(file))
		stop("cannot write", run->results);
}

/* --- one test */

static void log_path(char path[4*NAME], const struct run *run, const struct test *test)
{
	snprintf(path, 4*NAME, "%s/%s.log", run->logs, test->name);
}

/* The folders of a file. */
static void make_folders(const char *path)
{
	char part[4*NAME];

	for (const char *slash = path + 1; (slash = strchr(slash, '/')); slash++) {
		snprintf(part, sizeof part, "%.*s", (int)(slash - path), path);
		if (mkdir(part, 0777) && errno != EEXIST)
			stop("cannot make", part);
	}
}

/* In the child: standard output and error to the log, then the test. */
static void become(const struct run *run, const struct test *test, const char *log)
{
	char words[4*NAME], *word[32];
	int n = 0, null = open("/dev/null", O_RDONLY);
	int file = open(log, O_WRONLY | O_CREAT | O_TRUNC, 0666);

	if (file < 0 || null < 0 || dup2(null, 0) < 0 || dup2(file, 1) < 0 || dup2(file, 2) < 0)
		_exit(126);
	close(file);
	close(null);
	setpgid(0, 0);
	if (run->counts) {
		snprintf(words, sizeof words, "%s/%s", run->counts, test->name);
		setenv("GCOV_PREFIX", words, 1);
	}
	snprintf(words, sizeof words, "%s", run->wrapper && !test->script ? run->wrapper : "");
	for (char *w = strtok(words, " "); w && n < 28; w = strtok(NULL, " "))
		word[n++] = w;
	word[n++] = (char *)test->program;
	if (!test->script)
		word[n++] = (char *)test->name;
	word[n] = NULL;
	execvp(word[0], word);
	printf("cannot start %s: %s\n", word[0], strerror(errno));
	fflush(stdout);
	_exit(127);
}

static void start(struct run *run, struct test *test)
{
	char path[4*NAME];

	log_path(path, run, test);
	make_folders(path);
	fflush(NULL);
	test->began = now();
	test->pid = fork();
	if (test->pid < 0)
		stop("cannot start", test->name);
	if (test->pid == 0)
		become(run, test, path);
}

/* Count the checks in the log, and show those that failed with the line below. */
static void read_log(struct run *run, struct test *test)
{
	char line[4096], path[4*NAME];
	FILE *log;
	int note = 0;

	log_path(path, run, test);
	log = fopen(path, "r");
	while (log && fgets(line, sizeof line, log)) {
		if (strncmp(line, "ok ", 3) == 0)
			*(strstr(line, "# SKIP") ? &test->skipped : &test->passed) += 1;
		else if (strncmp(line, "1..", 3) == 0)
			test->planned = atoi(line + 3);
		if (strncmp(line, "not ok ", 7) == 0)
			printf("FAIL: %s: %s", test->name, line + 7);
		else if (note && line[0] == '#')
			printf("      %s", line);
		note = strncmp(line, "not ok ", 7) == 0 ? 1 : note && line[0] == '#' && note < 5 ? note + 1 : 0;
		test->failed += strncmp(line, "not ok ", 7) == 0;
	}
	if (log)
		fclose(log);
}

/* On a busy machine a test waits for the processor, and takes more of its time as well. */
static int waited(const struct test *test)
{
	return test->clock > 1.3*test->processor;
}

/* Errors besides failed checks. */
static void judge(struct run *run, struct test *test)
{
	char why[256] = "";
	int checks = test->passed + test->failed + test->skipped;

	if (WIFSIGNALED(test->status))
		snprintf(why, sizeof why, "ended by signal %d (%s)", WTERMSIG(test->status),
		         strsignal(WTERMSIG(test->status)));
	else if (test->status && !test->failed)
		snprintf(why, sizeof why, "no check failed, but exit status %d",
		         WEXITSTATUS(test->status));
	else if (test->planned != checks)
		snprintf(why, sizeof why, "%d checks, but the plan is %d", checks, test->planned);
	else if (run->limit_secs > 0 && test->processor > run->limit_secs && !waited(test) &&
	         !is_listed(run->exceptions, test->name))
		snprintf(why, sizeof why, "took %.1f s of processor time; more than %.1f s needs a line "
		         "in %s", test->processor, run->limit_secs, run->exceptions);
	if (!why[0])
		return;
	test->failed++;
	printf("FAIL: %s: %s (%s/%s.log)\n", test->name, why, run->logs, test->name);
}

static double seconds_of(const struct rusage *use)
{
	return (double)(use->ru_utime.tv_sec + use->ru_stime.tv_sec) +
	       1e-6*(double)(use->ru_utime.tv_usec + use->ru_stime.tv_usec);
}

static void progress(struct run *run)
{
	int terminal = isatty(1), last = run->ran == run->count;

	if (!terminal && !last && now() - run->told < silence_secs)
		return;
	run->told = now();
	printf("%stests: %d of %d, %d failed, %.0f s%s", terminal ? "\r" : "", run->ran, run->count,
	       run->broken, now() - run->began, terminal && !last ? "  " : "\n");
	fflush(stdout);
}

static void finish(struct run *run, struct test *test, int status, const struct rusage *use)
{
	test->processor = seconds_of(use);
	test->clock = now() - test->began;
	test->status = status;
	test->done = 1;
	test->pid = 0;
	if (isatty(1))
		printf("\r\033[K");
	read_log(run, test);
	judge(run, test);
	run->broken += test->failed > 0;
	run->ran++;
	progress(run);
}

static struct test *test_of(struct run *run, pid_t pid)
{
	for (int i = 0; i < run->count; i++)
		if (run->tests[i].pid == pid)
			return &run->tests[i];
	return NULL;
}

/* A signal that ends this program ends what it started: each test is a process group. */
static struct run *interrupted;
static void end_all(int number)
{
	for (int i = 0; i < interrupted->count; i++)
		if (interrupted->tests[i].pid > 0)
			kill(-interrupted->tests[i].pid, number);
	_exit(128 + number);
}

static void nothing(int number)
{
	(void)number;
}

/* The alarm only ends the call that waits: for progress, and for tests that do not end. */
static void handle_signals(struct run *run)
{
	struct sigaction end = {.sa_handler = end_all}, wake = {.sa_handler = nothing};
	struct itimerval often = {{(time_t)silence_secs, 0}, {(time_t)silence_secs, 0}};

	interrupted = run;
	sigaction(SIGINT, &end, NULL);
	sigaction(SIGTERM, &end, NULL);
	sigaction(SIGALRM, &wake, NULL);
	setitimer(ITIMER_REAL, &often, NULL);
}

static void overdue(struct run *run)
{
	for (int i = 0; i < run->count; i++)
		if (run->tests[i].pid > 0 && now() - run->tests[i].began > patience_secs)
			kill(-run->tests[i].pid, SIGKILL);
}

static void run_all(struct run *run)
{
	int next = 0, running = 0, status;
	struct rusage use;
	pid_t pid;

	run->began = run->told = now();
	while (next < run->count || running) {
		for (; next < run->count && running < run->jobs; running++)
			start(run, &run->tests[next++]);
		pid = wait4(-1, &status, 0, &use);
		if (pid < 0) {
			overdue(run);
			progress(run);
		} else if (test_of(run, pid)) {
			finish(run, test_of(run, pid), status, &use);
			running--;
		}
	}
}

static int summary(const struct run *run)
{
	int passed = 0, failed = 0, skipped = 0;
	double processor = 0;

	for (int i = 0; i < run->count; i++) {
		passed += run->tests[i].passed;
		failed += run->tests[i].failed;
		skipped += run->tests[i].skipped;
		processor += run->tests[i].processor;
	}
	printf("# TESTS: %d in %.0f s, %.1f s of processor time\n# PASS: %d\n# FAIL: %d\n# SKIP: %d\n",
	       run->count, now() - run->began, processor, passed, failed, skipped);
	return failed;
}

static void options(struct run *run, int argc, char **argv)
{
	for (int option; (option = getopt(argc, argv, "j:o:l:x:X:t:T:w:s:r:g:")) != -1;)
		switch (option) {
		case 'j': run->jobs = atoi(optarg); break;
		case 'o': run->results = optarg; break;
		case 'l': run->logs = optarg; break;
		case 'w': run->wrapper = optarg; break;
		case 's': run->limit_secs = atof(optarg); break;
		case 'r': run->exceptions = optarg; break;
		case 'T': run->chosen = optarg; break;
		case 'X': run->out[run->out_count++%FILES] = optarg; break;
		case 'g': run->counts = optarg; break;
		case 'x': run->without[run->without_count++%PATTERNS] = optarg; break;
		case 't': run->only[run->only_count++%PATTERNS] = optarg; break;
		default: exit(2);
		}
	if (run->jobs < 1 || run->jobs > JOBS)
		run->jobs = 1;
}

int main(int argc, char **argv)
{
	struct run run = {.jobs = 1, .logs = "tests/log"};
	int failed;

	options(&run, argc, argv);
	gather(&run, argc - optind, argv + optind);
	read_times(&run);
	qsort(run.tests, (size_t)run.count, sizeof *run.tests, longest_first);
	handle_signals(&run);
	run_all(&run);
	write_results(&run);
	failed = summary(&run) != 0;
	free(run.tests);
	return failed;
}
