/* cli/sweep_run.c - compute the variations of a sweep by several processes. See sweep.h.
 *
 * Processes and not threads: what a command shares in the program is one for all (the units and
 * the picture that the user has chosen, where warnings go, handlers of signals, the table of
 * units of udunits2), and a command that crashes costs one variation. Each process is a fork of
 * this one, waits for numbers of variations on one pipe and sends packed results on another. A
 * result depends on its variation alone, and is kept by its number: so the table has the same
 * bytes with any number of them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <errno.h>
#include <math.h>
#include <poll.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "cli/progress.h"
#include "cli/sweep.h"
#include "core/progress.h"
#include "core/report.h"

enum { MOST_PROCESSES = 1024 }; /* two pipes each, of the 1024 or more files a process may open */

/* --- one variation --- */

/* Cut off what a message begins with if it is of this variation, "--set KEY=VALUE: ": all
 * places where it is shown name the variation. */
static void shorten(struct cli_sweep_packed *packed, const struct cli_study *sweep, long variation)
{
	static const char begins[] = "\nM --set ";
	char set[CLI_SWEEP_SET], *at = strstr(packed->text, begins);

	for (int k = 0; k < sweep->plan.keys && at; k++) {
		char *text = at + sizeof begins - 1;
		size_t length;

		cli_sweep_set(set, &sweep->plan, k, variation);
		length = strlen(set);
		if (strncmp(text, set, length) != 0 || strncmp(text + length, ": ", 2) != 0)
			continue;
		length += 2 + (size_t)(text - (at + 3));
		memmove(at + 3, at + 3 + length, strlen(at + 3 + length) + 1);
		packed->size -= length;
		return;
	}
}

enum hawser_status cli_sweep_compute(struct cli_sweep_packed *packed, const struct cli_study *sweep,
                                     long variation, struct hawser_report *report)
{
	const struct cli_sweep_plan *plan = &sweep->plan;
	int count = sweep->words + 2*plan->keys, words = sweep->words;
	char **word = calloc((size_t)count + 1, sizeof *word);
	char (*set)[CLI_SWEEP_SET] = malloc(((size_t)plan->keys + 1)*sizeof *set);
	static char option[] = "--set";
	enum hawser_status status = word && set ? HAWSER_OK : hawser__no_memory(report, "sweep");

	if (!status) {
		memcpy(word, sweep->word, (size_t)words*sizeof *word);
		for (int k = 0; k < plan->keys; k++) {
			cli_sweep_set(set[k], plan, k, variation);
			word[words++] = option;
			word[words++] = set[k];
		}
		status = cli_sweep_pack(packed, &sweep->choice, words, word, report);
	}
	if (!status)
		shorten(packed, sweep, variation);
	free(word);
	free(set);
	return status;
}

/* --- what is common to one process and to several --- */

struct run {
	struct cli_study *sweep;
	struct cli_sweep_file file;
	long done, fresh; /* fresh: not from the checkpoint */
	long next;        /* the first that is neither done nor handed out */
	long first;       /* all before this are done, and have no result */
	int checked;      /* 1: the first result has been looked at */
	double began;
	struct cli_watch watch;
};

/* The first variation that has a result must have what is asked for. */
static enum hawser_status check_first(struct run *run, struct hawser_report *report)
{
	const struct cli_study *sweep = run->sweep;

	while (!run->checked && run->first < sweep->plan.count && sweep->packed[run->first].text) {
		const char *text = sweep->packed[run->first++].text;
		const char *missing = strstr(text, "\nX ");

		run->checked = text[2] == '0';
		if (run->checked && missing)
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "sweep", "%.*s",
			                    (int)strcspn(missing + 3, "\n"), missing + 3);
	}
	return HAWSER_OK;
}

static enum hawser_status finish(struct run *run, long variation, struct cli_sweep_packed packed,
                                 struct hawser_report *report)
{
	enum hawser_status status = cli_sweep_file_add(&run->file, variation, &packed, report);

	run->sweep->packed[variation] = packed;
	run->done++;
	run->fresh++;
	return status ? status : check_first(run, report);
}

/* The next variation to compute; count: none is left. */
static long next(struct run *run)
{
	while (run->next < run->sweep->plan.count && run->sweep->packed[run->next].text)
		run->next++;
	return run->next < run->sweep->plan.count ? run->next++ : run->next;
}

/* Returns nonzero if the user has interrupted. */
static int show(struct run *run)
{
	long count = run->sweep->plan.count;
	struct hawser_progress_state state = hawser__progress_state("sweep", "variations", run->done,
	                                                            run->began);

	state.expected = count;
	state.fresh = run->fresh;
	state.fraction = (double)run->done/(double)count;
	if (run->fresh > 0)
		state.left = state.seconds*(double)(count - run->done)/(double)run->fresh;
	return cli_watch(&run->watch, &state);
}

static enum hawser_status interrupted(const struct run *run, struct hawser_report *report)
{
	return hawser__fail(report, HAWSER_ERR_CONVERGENCE, "sweep", "interrupted after %ld of %ld "
	                    "variations: no result is written%s", run->done, run->sweep->plan.count,
	                    run->sweep->checkpoint ? "; the same command continues from the checkpoint"
	                                           : " (--checkpoint FILE would keep them)");
}

static enum hawser_status alone(struct run *run, struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;
	long variation;

	while (!status && (variation = next(run)) < run->sweep->plan.count) {
		struct cli_sweep_packed packed;

		if (show(run))
			return interrupted(run, report);
		status = cli_sweep_compute(&packed, run->sweep, variation, report);
		if (cli_interrupted()) {
			if (!status)
				free(packed.text);
			return interrupted(run, report);
		}
		if (!status)
			status = finish(run, variation, packed, report);
	}
	return status;
}

/* --- processes --- */

struct process {
	pid_t pid;
	int to, from;    /* ends of the pipes; -1: it has ended */
	long variation;  /* -1: none */
	struct cli_sweep_packed got;
	size_t wanted, room; /* wanted: bytes of the result and of its size before it; 0: not known */
};

static int put_all(int to, const void *bytes, size_t size)
{
	const char *at = bytes;

	while (size > 0) {
		ssize_t put = write(to, at, size);

		if (put < 0 && errno != EINTR)
			return -1;
		at += put > 0 ? put : 0;
		size -= put > 0 ? (size_t)put : 0;
	}
	return 0;
}

static int get_all(int from, void *bytes, size_t size)
{
	char *at = bytes;

	while (size > 0) {
		ssize_t got = read(from, at, size);

		if (got == 0 || (got < 0 && errno != EINTR))
			return -1;
		at += got > 0 ? got : 0;
		size -= got > 0 ? (size_t)got : 0;
	}
	return 0;
}

/* What the process does. Signals that interrupt the program end it at once: it writes no files. */
static void work(const struct cli_study *sweep, int from, int to)
{
	struct hawser_report report = {0};
	long variation;

	while (get_all(from, &variation, sizeof variation) == 0) {
		struct cli_sweep_packed packed;

		if (cli_sweep_compute(&packed, sweep, variation, &report) != HAWSER_OK ||
		    put_all(to, &packed.size, sizeof packed.size) != 0 ||
		    put_all(to, packed.text, packed.size) != 0)
			break;
		free(packed.text);
	}
}

static void begin_work(const struct cli_study *sweep, int from, int to)
{
	static const int ends[] = {SIGINT, SIGTERM, SIGHUP, SIGALRM, SIGUSR1};

	prctl(PR_SET_PDEATHSIG, SIGTERM);
	for (size_t i = 0; i < sizeof ends/sizeof *ends; i++)
		(void)signal(ends[i], ends[i] == SIGUSR1 ? SIG_IGN : SIG_DFL);
	setenv("OMP_NUM_THREADS", "1", 1); /* each process has a processor already */
	work(sweep, from, to);
	_exit(0);
}

/* `all` [count]: the other processes, whose pipes the new one closes. */
static enum hawser_status begin(struct process *process, const struct process *all, int count,
                                const struct cli_study *sweep, struct hawser_report *report)
{
	int down[2], up[2];

	*process = (struct process){.to = -1, .from = -1, .variation = -1};
	if (pipe(down) != 0)
		return hawser__fail(report, HAWSER_ERR_IO, "sweep",
		                    "cannot make a pipe: %s", strerror(errno));
	if (pipe(up) != 0 || (fflush(NULL), process->pid = fork()) < 0) {
		close(down[0]);
		close(down[1]);
		return hawser__fail(report, HAWSER_ERR_IO, "sweep", "cannot start a process: %s",
		                    strerror(errno));
	}
	if (process->pid == 0) {
		for (int i = 0; i < count; i++) {
			close(all[i].to);
			close(all[i].from);
		}
		close(down[1]);
		close(up[0]);
		begin_work(sweep, down[0], up[1]);
	}
	close(down[0]);
	close(up[1]);
	process->to = down[1];
	process->from = up[0];
	return HAWSER_OK;
}

static void end(struct process *process, int *how)
{
	if (process->to < 0)
		return;
	close(process->to);
	close(process->from);
	process->to = process->from = -1;
	while (waitpid(process->pid, how, 0) < 0 && errno == EINTR)
		;
	free(process->got.text);
	process->got = (struct cli_sweep_packed){NULL, 0};
}

static void hand_out(struct run *run, struct process *process)
{
	long variation = next(run);

	process->variation = variation < run->sweep->plan.count ? variation : -1;
	process->wanted = 0;
	process->got = (struct cli_sweep_packed){NULL, 0};
	process->room = 0;
	/* a process that is gone is found when its answer is read */
	if (process->variation >= 0)
		(void)put_all(process->to, &variation, sizeof variation);
}

/* The process has ended: its variation has no result, and another process takes its place. */
static enum hawser_status replace(struct run *run, struct process *process, struct process *all,
                                  int count, struct hawser_report *report)
{
	struct cli_sweep_packed packed;
	long variation = process->variation;
	char message[160];
	int how = 0;
	enum hawser_status status;

	end(process, &how);
	if (WIFSIGNALED(how))
		snprintf(message, sizeof message, "its process was ended by signal %d (%s)", WTERMSIG(how),
		         strsignal(WTERMSIG(how)));
	else
		snprintf(message, sizeof message, "its process ended without a result, for lack of memory");
	status = cli_sweep_pack_failure(&packed, HAWSER_ERR_PROGRAM, message, report);
	if (!status)
		status = finish(run, variation, packed, report);
	if (!status)
		status = begin(process, all, count, run->sweep, report);
	if (!status)
		hand_out(run, process);
	return status;
}

/* Read what has come from the process. */
static enum hawser_status receive(struct run *run, struct process *process, struct process *all,
                                  int count, struct hawser_report *report)
{
	struct cli_sweep_packed *got = &process->got;
	enum hawser_status status;
	ssize_t more;

	if (got->size + 65536 > process->room) {
		size_t room = 2*process->room + 131072;
		char *grown = realloc(got->text, room);

		if (!grown)
			return hawser__no_memory(report, "sweep");
		got->text = grown;
		process->room = room;
	}
	more = read(process->from, got->text + got->size, 65536);
	if (more < 0 && errno == EINTR)
		return HAWSER_OK;
	if (more <= 0)
		return replace(run, process, all, count, report);
	got->size += (size_t)more;
	if (!process->wanted && got->size >= sizeof process->wanted) {
		memcpy(&process->wanted, got->text, sizeof process->wanted);
		process->wanted += sizeof process->wanted;
	}
	if (!process->wanted || got->size < process->wanted)
		return HAWSER_OK;
	got->size -= sizeof process->wanted;
	memmove(got->text, got->text + sizeof process->wanted, got->size);
	got->text[got->size] = '\0';
	got->text = realloc(got->text, got->size + 1);
	status = finish(run, process->variation, *got, report);
	*got = (struct cli_sweep_packed){NULL, 0};
	hand_out(run, process);
	return status;
}

/* Until all that were handed out have come. */
static enum hawser_status serve(struct run *run, struct process *process, int count,
                                struct hawser_report *report)
{
	struct pollfd poll_on[MOST_PROCESSES];
	enum hawser_status status = HAWSER_OK;
	int busy = 1;

	while (!status && busy) {
		busy = 0;
		for (int i = 0; i < count; i++) {
			int waits = process[i].variation >= 0;

			poll_on[i] = (struct pollfd){.fd = waits ? process[i].from : -1, .events = POLLIN};
			busy |= waits;
		}
		if (busy && poll(poll_on, (nfds_t)count, 100) < 0 && errno != EINTR)
			return hawser__fail(report, HAWSER_ERR_IO, "sweep", "cannot wait for results: %s",
			                    strerror(errno));
		if (show(run))
			return interrupted(run, report);
		for (int i = 0; i < count && !status; i++)
			if (poll_on[i].fd >= 0 && poll_on[i].revents)
				status = receive(run, &process[i], process, count, report);
	}
	return status;
}

static enum hawser_status together(struct run *run, int count, struct hawser_report *report)
{
	struct process *process = calloc((size_t)count, sizeof *process);
	void (*before)(int) = signal(SIGPIPE, SIG_IGN);
	enum hawser_status status = process ? HAWSER_OK : hawser__no_memory(report, "sweep");
	int begun = 0, how;

	for (; begun < count && !status; begun++)
		status = begin(&process[begun], process, begun, run->sweep, report);
	for (int i = 0; i < begun && !status; i++)
		hand_out(run, &process[i]);
	if (!status)
		status = serve(run, process, begun, report);
	for (int i = 0; i < begun; i++) {
		if (status && process[i].to >= 0)
			kill(process[i].pid, SIGTERM);
		end(&process[i], &how);
	}
	(void)signal(SIGPIPE, before);
	free(process);
	return status;
}

enum hawser_status cli_sweep_run(struct cli_study *sweep, struct hawser_report *report)
{
	struct run run = {.sweep = sweep, .file = {.fd = -1}, .began = hawser__wall_seconds(),
	                  .watch = {.progress = {.quiet = sweep->common->quiet}}};
	enum hawser_status status = HAWSER_OK;
	long left = 0, count;

	sweep->packed = calloc((size_t)sweep->plan.count, sizeof *sweep->packed);
	if (!sweep->packed)
		return hawser__no_memory(report, "sweep");
	if (sweep->checkpoint)
		status = cli_sweep_file_open(&run.file, sweep, report);
	for (long i = 0; i < sweep->plan.count; i++)
		left += !sweep->packed[i].text;
	run.done = sweep->plan.count - left;
	count = sweep->processes < left ? sweep->processes : left;
	count = count < MOST_PROCESSES ? count : MOST_PROCESSES;
	if (!status)
		status = check_first(&run, report);
	if (!status)
		status = count > 1 ? together(&run, (int)count, report) : alone(&run, report);
	cli_progress_end(&run.watch.progress);
	cli_sweep_file_close(&run.file);
	return status;
}
