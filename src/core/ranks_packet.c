/* core/ranks_packet.c - packets of tasks and their answers as messages.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include "core/progress.h"
#include "core/ranks_packet.h"
#include "core/report.h"
#include "core/share.h"

enum hawser_status hawser__packet_ask(struct hawser__bytes *message, const struct hawser__tasks *tasks,
                                      long first, int count, struct hawser_report *report)
{
	struct hawser__bytes question = {.at = NULL};
	enum hawser_status status = HAWSER_OK;

	hawser__bytes_empty(message);
	hawser__bytes_add_long(message, HAWSER__WORK);
	hawser__bytes_add_long(message, first);
	hawser__bytes_add_long(message, count);
	for (long k = first; k < first + count && !status; k++) {
		hawser__bytes_empty(&question);
		if (tasks->ask)
			status = tasks->ask(tasks->context, &question, k, report);
		hawser__bytes_add_long(message, (long)question.used);
		hawser__bytes_add(message, question.at, question.used);
		message->short_of_memory |= question.short_of_memory;
	}
	if (!status && message->short_of_memory)
		status = hawser__no_memory(report, tasks->what);
	hawser__bytes_clear(&question);
	return status;
}

struct packet {
	const struct hawser__tasks *tasks;
	struct hawser__task *task;    /* [count] */
	struct hawser__bytes *answer; /* [count] status and answer, or message */
	int worker;
};

static void put(struct hawser__bytes *to, enum hawser_status status, const struct hawser_report *report)
{
	hawser__bytes_empty(to);
	hawser__bytes_add_long(to, (long)status);
	if (status)
		hawser__bytes_add_text(to, report->message);
}

static void one(void *context, long item, int thread)
{
	struct packet *packet = context;
	struct hawser__bytes *answer = &packet->answer[item];
	struct hawser_report report = {.status = HAWSER_OK};
	enum hawser_status status;

	put(answer, HAWSER_OK, &report);
	status = packet->tasks->work(packet->tasks->context, answer, &packet->task[item],
	                             packet->worker + thread, &report);
	if (!status && answer->short_of_memory)
		status = hawser__no_memory(&report, packet->tasks->what);
	if (status)
		put(answer, status, &report);
}

/* A failure of the packet is that of each of its tasks. */
static void compute(struct packet *packet, int count, int threads)
{
	const struct hawser__tasks *tasks = packet->tasks;
	struct hawser_report report = {.status = HAWSER_OK};
	enum hawser_status status = HAWSER_OK;

	if (tasks->prepare)
		status = tasks->prepare(tasks->context, packet->task, count, &report);
	for (int k = 0; k < count && status; k++)
		put(&packet->answer[k], status, &report);
	if (!status)
		hawser__share(count, threads, one, packet);
}

/* The answers of a packet for which there is no memory. */
static void refuse(struct hawser__bytes *answers, const struct hawser__tasks *tasks, int count)
{
	struct hawser_report report = {.status = HAWSER_OK};
	struct hawser__bytes answer = {.at = NULL};

	put(&answer, hawser__no_memory(&report, tasks->what), &report);
	for (int k = 0; k < count; k++) {
		hawser__bytes_add_long(answers, (long)answer.used);
		hawser__bytes_add(answers, answer.at, answer.used);
	}
	hawser__bytes_clear(&answer);
}

void hawser__packet_work(struct hawser__bytes *answers, const struct hawser__bytes *message,
                         const struct hawser__tasks *tasks, int threads, int worker)
{
	struct hawser__extract view = {message->at, message->used, 0};
	double began = hawser__wall_seconds();
	long kind = hawser__extract_long(&view), first = hawser__extract_long(&view);
	int count = (int)hawser__extract_long(&view);
	struct packet packet = {.tasks = tasks, .worker = worker};

	(void)kind;
	packet.task = calloc((size_t)count + 1, sizeof *packet.task);
	packet.answer = calloc((size_t)count + 1, sizeof *packet.answer);
	for (int k = 0; k < count && packet.task && packet.answer; k++)
		packet.task[k] = (struct hawser__task){first + k, hawser__extract_part(&view)};
	if (packet.task && packet.answer)
		compute(&packet, count, threads);
	hawser__bytes_empty(answers);
	hawser__bytes_add_long(answers, HAWSER__ANSWER);
	hawser__bytes_add_long(answers, first);
	hawser__bytes_add_long(answers, count);
	hawser__bytes_add_double(answers, hawser__wall_seconds() - began);
	for (int k = 0; k < count && packet.task && packet.answer; k++) {
		hawser__bytes_add_long(answers, (long)packet.answer[k].used);
		hawser__bytes_add(answers, packet.answer[k].at, packet.answer[k].used);
		hawser__bytes_clear(&packet.answer[k]);
	}
	if (!packet.task || !packet.answer)
		refuse(answers, tasks, count);
	free(packet.task);
	free(packet.answer);
}
