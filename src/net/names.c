/* net/names.c - nodes and cables by name: an index in order of the names, and binary search in it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "net/read/read.h"

/* `first` is the name of item 0, of `size` bytes. */
static int search(const int *order, const char *first, size_t size, int count, const char *name)
{
	int low = 0, high = count - 1;

	while (low <= high) {
		int mid = low + (high - low)/2, at = order[mid];
		int sign = strcmp(name, first + (size_t)at*size);

		if (sign == 0)
			return at;
		if (sign < 0)
			high = mid - 1;
		else
			low = mid + 1;
	}
	return -1;
}

int hawser__net_node_of(const struct hawser_net *net, const char *name)
{
	return net->nodes ? search(net->order, net->node[0].name, sizeof *net->node, net->nodes, name) : -1;
}

int hawser__net_cable_of(const struct hawser_net *net, const char *name)
{
	return net->cables ? search(net->order + net->nodes, net->cable[0].name, sizeof *net->cable,
	                            net->cables, name) : -1;
}

enum hawser_status hawser__net_find_node(struct hawser__reader *reader, int *node,
                                         const struct hawser_net *net,
                                         const struct hawser__tree *tree, const char *name,
                                         const char *what)
{
	char shown[HAWSER__SHOWN];

	*node = hawser__net_node_of(net, name);
	return *node >= 0 ? HAWSER_OK
	                  : hawser__reader_fail(reader, &tree->at, "%s: there is no node %s", what,
	                                        hawser__shown(shown, name));
}

struct named {
	char name[HAWSER_NET_NAME];
	int at;
};

static int by_name(const void *a, const void *b)
{
	return strcmp(((const struct named *)a)->name, ((const struct named *)b)->name);
}

/* order [count] = numbers of the items by name; `first` is the name of item 0. */
static enum hawser_status sort(int *order, const char *first, size_t size, int count,
                               struct hawser_report *report)
{
	struct named *list = malloc(((size_t)count + 1)*sizeof *list);

	if (!list)
		return hawser__no_memory(report, "scene");
	for (int i = 0; i < count; i++) {
		memcpy(list[i].name, first + (size_t)i*size, HAWSER_NET_NAME);
		list[i].at = i;
	}
	qsort(list, (size_t)count, sizeof *list, by_name);
	for (int i = 0; i < count; i++)
		order[i] = list[i].at;
	free(list);
	return HAWSER_OK;
}

enum hawser_status hawser__net_index(struct hawser__reader *reader, struct hawser_net *net)
{
	size_t count = (size_t)net->nodes + (size_t)net->cables;
	int *order = realloc(net->order, (count + 1)*sizeof *order);
	enum hawser_status status;

	if (!order)
		return hawser__no_memory(reader->report, "scene");
	net->order = order;
	status = sort(order, net->node[0].name, sizeof *net->node, net->nodes, reader->report);
	if (!status && net->cables)
		status = sort(order + net->nodes, net->cable[0].name, sizeof *net->cable, net->cables,
		              reader->report);
	return status;
}
