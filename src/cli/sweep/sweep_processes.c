/* cli/sweep/sweep_processes.c - the variations of a sweep by several processes of this machine.
 *
 * Processes and not threads: what a command shares in the program is one for all (the units and the
 * picture that the user has chosen, where warnings go, handlers of signals, the table of units of
 * udunits2), and a command that crashes costs one variation. Each process is a fork of this one,
 * waits for numbers of variations on one pipe and sends packed results on another.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <errno.h>
#include <poll.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "cli/sweep/sweep.h"
#include "core/report.h"

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
	int down[2] = {-1, -1}, up[2] = {-1, -1};

	*process = (struct process){.to = -1, .from = -1, .variation = -1};
	fflush(NULL); /* what is buffered would be written by both */
	if (pipe(down) != 0 || pipe(up) != 0 || (process->pid = fork()) < 0) {
		enum hawser_status status = hawser__fail(report, HAWSER_ERR_IO, "sweep",
		                                         "cannot start a process: %s", strerror(errno));

		for (int i = 0; i < 2; i++) {
			close(down[i]);
			close(up[i]);
		}
		return status;
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

static void hand_out(struct cli_sweep_run *run, struct process *process)
{
	long variation = cli_sweep_next(run);

	process->variation = variation < run->sweep->plan.count ? variation : -1;
	process->wanted = 0;
	process->got = (struct cli_sweep_packed){NULL, 0};
	process->room = 0;
	/* a process that is gone is found when its answer is read */
	if (process->variation >= 0)
		(void)put_all(process->to, &variation, sizeof variation);
}

/* The process has ended: its variation has no result, and another process takes its place. */
static enum hawser_status replace(struct cli_sweep_run *run, struct process *process,
                                  struct process *all, int count, struct hawser_report *report)
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
		status = cli_sweep_finish(run, variation, packed, report);
	if (!status)
		status = begin(process, all, count, run->sweep, report);
	if (!status)
		hand_out(run, process);
	return status;
}

/* Read what has come from the process. */
static enum hawser_status receive(struct cli_sweep_run *run, struct process *process,
                                  struct process *all, int count, struct hawser_report *report)
{
	struct cli_sweep_packed *got = &process->got;
	enum hawser_status status;
	ssize_t more;
	char *cut;

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
	cut = realloc(got->text, got->size + 1);
	if (cut)
		got->text = cut;
	status = cli_sweep_finish(run, process->variation, *got, report);
	*got = (struct cli_sweep_packed){NULL, 0};
	hand_out(run, process);
	return status;
}

/* Until all that were handed out have come. */
static enum hawser_status serve(struct cli_sweep_run *run, struct process *process, int count,
                                struct hawser_report *report)
{
	struct pollfd poll_on[CLI_SWEEP_PROCESSES];
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
		if (cli_sweep_watch(run))
			return cli_sweep_interrupted(run, report);
		for (int i = 0; i < count && !status; i++)
			if (poll_on[i].fd >= 0 && poll_on[i].revents)
				status = receive(run, &process[i], process, count, report);
	}
	return status;
}

enum hawser_status cli_sweep_together(struct cli_sweep_run *run, int count,
                                      struct hawser_report *report)
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
