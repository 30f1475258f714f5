/* What a text describes, by its keys: in each style, in part damaged, and beside keys that only look
 * so. SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>

#include <hawser/hawser.h>
#include "tests/tap.h"

static const struct {
	const char *what, *text;
	enum hawser_kind kind;
} table[] = {
	{"nothing", "", HAWSER_KIND_SPAN},
	{"a span", "cable: {EA: 1e7, rho: 1}\nspan: {d: 100, h: 0}\ntension: {H: 1e4}\n",
	 HAWSER_KIND_SPAN},
	{"a net by its nodes", "nodes: {A: [0, 0, 0]}\n", HAWSER_KIND_NET},
	{"flow style", "{span: {d: 1, h: 0}, nodes: {}}", HAWSER_KIND_NET},
	{"indented", "   rod:\n     length: 1\n", HAWSER_KIND_ROD},
	{"JSON", "{\"loads\": {}, \"nodes\": {\"n\": 1, \"K\": 2}}", HAWSER_KIND_NET},
	{"the key kind wins", "nodes: {}\nropeway: {}\nkind: rod\n", HAWSER_KIND_ROD},
	{"kind: span", "kind: span\nobstacles: []\n", HAWSER_KIND_SPAN},
	{"an unknown kind is the net reader's", "kind: web\n", HAWSER_KIND_NET},
	{"an unknown kind with a sign", "kind: web\ntow: {}\n", HAWSER_KIND_TOW},
	{"names in quotation marks", "'ropeway': {}\n", HAWSER_KIND_ROPEWAY},
	{"circles", "obstacles: [{circle: {radius: 1}}]\n", HAWSER_KIND_OBSTACLES},
	{"contact alone", "contact: {sliding: none}\n", HAWSER_KIND_OBSTACLES},
	{"contact of a ropeway", "contact: {}\nropeway: {}\n", HAWSER_KIND_ROPEWAY},
	{"a plane makes a mesh", "obstacles: [{circle: {}}, {plane: {y: 0}}]\n", HAWSER_KIND_NET},
	{"water makes a mesh", "span: {d: 1}\nwater: {density: 1}\n", HAWSER_KIND_NET},
	{"also of kind span", "kind: span\nspan: {d: 1}\nwater: {density: 1}\n", HAWSER_KIND_NET},
	{"a profile makes a mesh", "obstacles: [{profile: [[0, 0], [1, 0]]}]\n", HAWSER_KIND_NET},
	{"a plane that is a name", "obstacles: [{name: plane, circle: {}}]\n", HAWSER_KIND_OBSTACLES},
	{"a comment is no sign", "# nodes:\ncable: {EA: 1e7}\n", HAWSER_KIND_SPAN},
	{"an inner key is no sign", "cable:\n  rod: 1\n", HAWSER_KIND_SPAN},
	{"damaged behind its sign", "nodes: {}\ncables: [\n", HAWSER_KIND_NET},
	{"damaged before its sign", "cables: ]\nnodes: {}\n", HAWSER_KIND_SPAN},
	{"a key twice", "tow: {}\ntow: {}\n", HAWSER_KIND_TOW},
	{"a model by its version", "{\"hawser_rom\": 1, \"cable\": {}}", HAWSER_KIND_MODEL},
	{"a model by n and K", "{\"name\": \"cable\", \"K\": [[1]], \"n\": 1}", HAWSER_KIND_MODEL},
	{"a damaged model", "{\"n\": 1, \"K\": [[1, \"C\": {", HAWSER_KIND_MODEL},
	{"a damaged model with its version", "{\"hawser_rom\": 1, \"K\": [[", HAWSER_KIND_MODEL},
	{"braces in a string", "{\"text\": \"}\\\"\", \"n\": 1, \"K\": []}", HAWSER_KIND_MODEL},
	{"n without K", "{\"n\": 1}", HAWSER_KIND_SPAN},
	{"a scene in JSON with n and K", "{\"cable\": {}, \"n\": 1, \"K\": 1}", HAWSER_KIND_SPAN},
};

static enum hawser_status read(struct hawser_document *document, const char *text)
{
	FILE *stream = tmpfile();
	enum hawser_status status = HAWSER_ERR_IO;

	if (stream && fputs(text, stream) >= 0) {
		rewind(stream);
		status = hawser_document_read(document, stream, "text", NULL);
	}
	if (stream)
		fclose(stream);
	return status;
}

static void kinds(void)
{
	struct hawser_document document;

	for (size_t i = 0; i < sizeof table/sizeof *table; i++) {
		enum hawser_status status = read(&document, table[i].text);

		ok(status == HAWSER_OK, "%s: read", table[i].what);
		if (status)
			continue;
		ok(document.kind == table[i].kind, "%s: a %s", table[i].what,
		       hawser_kind_name(table[i].kind));
		ok(document.length == strlen(table[i].text) &&
		       !memcmp(document.text, table[i].text, document.length), "%s: its text", table[i].what);
		hawser_document_clear(&document);
	}
}

/* One document serves every reader, any number of times: overrides of one do not reach the next. */
static void twice(void)
{
	static const char text[] = "nodes: {A: [0 m, 0 m, 0 m], B: [9 m, 0 m, 0 m]}\n"
		"cables: [{name: c, from: A, to: B, EA: 1 MN, rho: 1 kg/m, length0: 10 m}]\n"
		"supports: {A: fixed, B: fixed}\n";
	const char *const set[] = {"cables.c.EA=2 MN"};
	struct hawser_document document;
	struct hawser_net first, second;

	if (read(&document, text)) {
		ok(0, "the text of a net");
		return;
	}
	ok(hawser_net_of(&first, &document, set, 1, NULL) == HAWSER_OK, "with an override");
	ok(hawser_net_of(&second, &document, NULL, 0, NULL) == HAWSER_OK, "without");
	ok(first.cables == 1 && second.cables == 1 && first.cable[0].EA == 2e6 &&
	       second.cable[0].EA == 1e6, "each has its own number");
	hawser_net_clear(&first);
	hawser_net_clear(&second);
	hawser_document_clear(&document);
}

CASE(unit_document)
{
	struct hawser_document document;
	struct hawser_report report = {0};

	kinds();
	twice();
	ok(hawser_document_open(&document, "/nowhere/scene.yaml", &report) == HAWSER_ERR_ARGUMENT &&
	       strstr(report.message, "/nowhere/scene.yaml"), "no such file: %s", report.message);
	ok(hawser_kind_name(HAWSER_KINDS) == NULL, "no name beyond the last kind");
	return done_testing();
}
