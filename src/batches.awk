# src/batches.awk - which sources can be compiled as one: those that share no name at file scope. See batches.sh.
#
#   awk -f batches.awk [-v most=12] FILE...     lines of the batches, each behind the number of its batch
#
# A name is what a line in column 1 defines: a function, a variable, a structure, or a constant of an enumeration; headers of tests
# define functions too. What this misses is found by the compiler, since a name is then defined twice. Macros end with their
# files; files that define some for the headers that follow are kept apart.
# SPDX-License-Identifier: GPL-3.0-or-later

# The text without comments and strings; `inside` is 1 within a comment.
function code(text,    at, out) {
	gsub(/\\./, "", text)
	gsub(/"[^"]*"/, "\"\"", text)
	out = ""
	while (text != "") {
		at = index(text, inside ? "*/" : "/*")
		if (!at)
			return inside ? out : out text
		if (!inside)
			out = out substr(text, 1, at - 1) " "
		text = substr(text, at + 2)
		inside = !inside
	}
	return out
}

# A name of the file, which stands in `origin`: the file itself or a header.
function define(file, origin, name) {
	if (name == "" || name ~ /^(static|const|int|double|void|char|struct|enum)$/ || ((name, file) in from))
		return
	from[name, file] = origin
	defines[file] = defines[file] " " name
}

# The names of a list of constants, "A, B = 3, C".
function constants(file, origin, list,    part, n, i) {
	sub(/}.*/, "", list)
	n = split(list, part, ",")
	for (i = 1; i <= n; i++) {
		sub(/=.*/, "", part[i])
		gsub(/[^A-Za-z0-9_]/, "", part[i])
		define(file, origin, part[i])
	}
}

# The last words before ( [ = or ; in a line, and those before its commas.
function variables(file, origin, line,    part, n, i) {
	if (line ~ /^[^=]*\(/) {
		sub(/\(.*/, "", line)
	} else {
		gsub(/\[[^]]*\]/, "", line)
		gsub(/=[^,]*/, "", line)
	}
	n = split(line, part, ",")
	for (i = 1; i <= n; i++) {
		sub(/[^A-Za-z0-9_]+$/, "", part[i])
		sub(/.*[^A-Za-z0-9_]/, "", part[i])
		define(file, origin, part[i])
	}
}

# #define and #include; `raw` has its strings.
function directive(file, origin, line, raw,    name) {
	if (line ~ /^#[ \t]*define/) {
		sub(/^#[ \t]*define[ \t]+/, "", line)
		sub(/[^A-Za-z0-9_].*/, "", line)
		if (file == origin)
			macros[file] = macros[file] " " line
		else
			define(file, origin, line)
	} else if (line ~ /^#[ \t]*include/) {
		if (macros[file] != "" && file == origin)
			alone[file]
		if (raw ~ /"tests\//) {
			sub(/^[^"]*"/, "", raw)
			sub(/".*/, "", raw)
			read(file, raw)
		}
	}
}

function read(file, path,    raw, line, listing, outer) {
	if ((file, path) in done)
		return
	done[file, path]
	outer = inside
	inside = 0
	while ((getline raw <path) > 0) {
		line = code(raw)
		if (line ~ /^#/) {
			directive(file, path, line, raw)
		} else if (listing) {
			constants(file, path, line)
			listing = line !~ /}/
		} else if (line ~ /^enum( [A-Za-z_0-9]+)? \{/) {
			raw = line
			sub(/ *\{.*/, "", raw)
			sub(/^enum */, "", raw)
			define(file, path, raw)
			sub(/^[^{]*\{/, "", line)
			constants(file, path, line)
			listing = line !~ /}/
		} else if (line ~ /^[A-Z_]+\(/) { # a macro that makes a function: LABELS(name, ...)
			sub(/^[A-Z_]+\( */, "", line)
			sub(/[^A-Za-z0-9_].*/, "", line)
			define(file, path, line)
		} else if (line ~ /^(struct|union) [A-Za-z_0-9]+ \{/) {
			sub(/^[a-z]+ /, "", line)
			sub(/ .*/, "", line)
			define(file, path, line)
		} else if (line ~ /^(}[ \t]*)?[a-zA-Z]/) {
			variables(file, path, line)
		}
	}
	close(path)
	inside = outer
}

# Can this file go to that batch?
function fits(file, batch,    part, n, i) {
	if (size[batch] >= most || closed[batch] || (size[batch] && file in alone))
		return 0
	n = split(defines[file], part, " ")
	for (i = 1; i <= n; i++)
		if (((part[i], batch) in has) && has[part[i], batch] != from[part[i], file])
			return 0
	return 1
}

function put(file, batch,    part, n, i) {
	size[batch]++
	closed[batch] = file in alone
	n = split(defines[file], part, " ")
	for (i = 1; i <= n; i++)
		has[part[i], batch] = from[part[i], file]
	print batch " #include \"" file "\""
	n = split(macros[file], part, " ")
	for (i = 1; i <= n; i++)
		print batch " #undef " part[i]
}

BEGIN {
	if (!most)
		most = 12
	for (f = 1; f < ARGC; f++) {
		if (ARGV[f] ~ /=/)
			continue
		read(ARGV[f], ARGV[f])
		for (b = 1; b <= batches && !fits(ARGV[f], b); b++)
			;
		if (b > batches)
			batches = b
		put(ARGV[f], b)
	}
}
