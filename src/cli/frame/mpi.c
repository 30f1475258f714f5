/* cli/frame/mpi.c - messages between ranks by Open MPI.
 *
 * Its library is loaded when a command finds itself among several ranks: linked, it would make each
 * start of the program a sixth longer (src/README.md), and the program would need it where nobody has
 * it. Its headers are needed at compile time only.
 *
 * MPI is called by one thread, and never waits: Open MPI waits by polling, which keeps a processor
 * busy.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/frame/ranks.h"
#include "core/loaded.h"
#include "core/report.h"

#ifdef HAVE_MPI
#include <errno.h>
#include <limits.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <mpi.h>

enum { TAG = 1, HOST_SIZE = 64 };

/* Its functions, of the types that its header declares, and two of its constants. */
static struct {
	void *library;
	__typeof__(&MPI_Init_thread) init;
	__typeof__(&MPI_Finalize) finalize;
	__typeof__(&MPI_Comm_rank) rank;
	__typeof__(&MPI_Comm_size) size;
	__typeof__(&MPI_Allgather) allgather;
	__typeof__(&MPI_Isend) send;
	__typeof__(&MPI_Test) test;
	__typeof__(&MPI_Iprobe) probe;
	__typeof__(&MPI_Get_count) count;
	__typeof__(&MPI_Recv) receive;
	MPI_Comm world;
	MPI_Datatype byte;
} mpi;

struct process {
	long id;
	char host[HOST_SIZE];
};

/* A message that may be on its way. */
struct sent {
	struct sent *next;
	MPI_Request request;
	unsigned char message[];
};

struct link {
	struct process *process; /* [count] */
	struct process own;
	struct sent *sent;
};

#define FIND(member, name) hawser__loaded(&mpi.member, sizeof mpi.member, mpi.library, name)

/* Its own modules look for its functions among those of the program: RTLD_GLOBAL. */
static int load(void)
{
	mpi.library = dlopen("libmpi.so.40", RTLD_LAZY | RTLD_GLOBAL); /* of Open MPI 3, 4 and 5 */
	return mpi.library && FIND(init, "MPI_Init_thread") && FIND(finalize, "MPI_Finalize") &&
	       FIND(rank, "MPI_Comm_rank") && FIND(size, "MPI_Comm_size") &&
	       FIND(allgather, "MPI_Allgather") && FIND(send, "MPI_Isend") && FIND(test, "MPI_Test") &&
	       FIND(probe, "MPI_Iprobe") && FIND(count, "MPI_Get_count") && FIND(receive, "MPI_Recv") &&
	       FIND(world, "ompi_mpi_comm_world") && FIND(byte, "ompi_mpi_byte");
}

/* Release the messages that have left. */
static void clean(struct link *link)
{
	struct sent **at = &link->sent;

	while (*at) {
		struct sent *sent = *at;
		int done = 0;

		mpi.test(&sent->request, &done, MPI_STATUS_IGNORE);
		if (done) {
			*at = sent->next;
			free(sent);
		} else {
			at = &sent->next;
		}
	}
}

static enum hawser_status send(void *context, int to, const void *message, size_t length,
                               struct hawser_report *report)
{
	struct link *link = context;
	struct sent *sent;

	if (length > INT_MAX) /* MPI counts by int */
		return hawser__fail(report, HAWSER_ERR_PROGRAM, "mpi", "a message of %zu bytes is more than "
		                    "MPI sends at once: use --part in place of ranks", length);
	clean(link);
	sent = malloc(sizeof *sent + length);
	if (!sent)
		return hawser__no_memory(report, "mpi");
	memcpy(sent->message, message, length);
	sent->next = link->sent;
	link->sent = sent;
	hawser__leaks_begin();
	mpi.send(sent->message, (int)length, mpi.byte, to, TAG, mpi.world, &sent->request);
	hawser__leaks_end();
	return HAWSER_OK;
}

static int receive(void *context, int *from, struct hawser__bytes *message)
{
	MPI_Status about;
	int is_there = 0, length = 0;

	hawser__leaks_begin();
	if (((struct link *)context)->sent)
		clean(context);
	mpi.probe(MPI_ANY_SOURCE, TAG, mpi.world, &is_there, &about);
	if (is_there) {
		mpi.count(&about, mpi.byte, &length);
		hawser__bytes_empty(message); /* without memory now, it is tried again */
		hawser__bytes_reserve(message, (size_t)length);
		is_there = !message->short_of_memory;
	}
	if (is_there) {
		mpi.receive(message->at, length, mpi.byte, about.MPI_SOURCE, TAG, mpi.world,
		            MPI_STATUS_IGNORE);
		message->used = (size_t)length;
		*from = about.MPI_SOURCE;
	}
	hawser__leaks_end();
	return is_there;
}

/* Processes of other machines are their own daemon's affair, which ends all. */
static int lost(void *context, int rank, char *name, size_t size)
{
	const struct link *link = context;
	const struct process *process = &link->process[rank];

	if (strcmp(process->host, link->own.host) != 0 || kill((pid_t)process->id, 0) == 0 ||
	    errno != ESRCH)
		return 0;
	snprintf(name, size, "process %ld on %s", process->id, process->host);
	return 1;
}

enum hawser_status cli_mpi_open(struct hawser__ranks *ranks, struct hawser_report *report)
{
	struct link *link = calloc(1, sizeof *link);
	int level;

	if (!link)
		return hawser__no_memory(report, "mpi");
	hawser__leaks_begin();
	if (!load()) {
		const char *why = dlerror();

		hawser__leaks_end();
		free(link);
		return hawser__fail(report, HAWSER_ERR_PROGRAM, "mpi", "there are several ranks, but the "
		                    "library of Open MPI can't be loaded (%.200s): install libopenmpi3, or use "
		                    "--part", why ? why : "a function is missing");
	}
	mpi.init(NULL, NULL, MPI_THREAD_FUNNELED, &level);
	mpi.rank(mpi.world, &ranks->rank);
	mpi.size(mpi.world, &ranks->count);
	link->own.id = (long)getpid();
	gethostname(link->own.host, HOST_SIZE - 1);
	link->process = calloc((size_t)ranks->count, sizeof *link->process);
	if (link->process)
		mpi.allgather(&link->own, (int)sizeof link->own, mpi.byte, link->process,
		              (int)sizeof link->own, mpi.byte, mpi.world);
	hawser__leaks_end();
	ranks->by = (struct hawser__transport){link, send, receive, lost};
	if (!link->process)
		return hawser__no_memory(report, "mpi");
	return HAWSER_OK;
}

void cli_mpi_close(struct hawser__ranks *ranks, int in_order)
{
	struct link *link = ranks->by.context;

	if (in_order) {
		while (link->sent)
			clean(link);
		hawser__leaks_begin();
		mpi.finalize();
		hawser__leaks_end();
	}
	free(link->process);
	free(link);
}

#else

enum hawser_status cli_mpi_open(struct hawser__ranks *ranks, struct hawser_report *report)
{
	(void)ranks;
	return hawser__fail(report, HAWSER_ERR_PROGRAM, "mpi",
	                    "there are several ranks, but this program is built without MPI: build it "
	                    "where libopenmpi-dev is installed, start one process, or use --part");
}

void cli_mpi_close(struct hawser__ranks *ranks, int in_order)
{
	(void)ranks, (void)in_order;
}

#endif
