# man/page.awk - a manual page from man/PAGE.in: shared text, and the lists of columns and keys that the program
# has (hawser help columns). SPDX-License-Identifier: GPL-3.0-or-later
#
#   awk -v hawser=PROGRAM -v shared=FOLDER -f page.awk PAGE.in
#
# In the sections OPTIONS and OPTIONS OF A COMMAND the paragraphs of the options are written in the order of the command's --help, below its
# headings; what follows an option, up to the next one, goes with it.
#
#   .\" @include NAME WORDS      the text of shared/NAME, in which @1@ are the words
#   .\" @commands                the commands with their summaries
#   .\" @columns COMMAND         the lists of the command, each below its title
#   .\" @columns COMMAND: TITLE  those whose titles begin so

function fail(message) {
	print "page.awk: " message >"/dev/stderr"
	failed = 1
	exit 1
}

# A line of the page; those of options wait for all of them.
function put(line) {
	if (line ~ /^\.SH/) {
		write_options()
		print line
		options_of(line)
	} else if (command != "") {
		held[++lines] = line
	} else {
		print line
	}
}

# The command whose options the section has, or "".
function options_of(line) {
	command = ""
	if (line ~ /^\.SH "?OPTIONS"?$/)
		command = page
	else if (line ~ /^\.SH "?OPTIONS OF /) {
		command = tolower(line)
		gsub(/^\.sh "?options of |"/, "", command)
	}
	lines = 0
}

# The long name of the first option in a line, or "".
function option_in(line) {
	gsub(/\\-/, "-", line)
	gsub(/\\f[A-Z]/, "", line)
	return match(line, /--[A-Za-z0-9-]+/) ? substr(line, RSTART, RLENGTH) : ""
}

# What is held: paragraph[option] are its lines, 0 what precedes the first one.
function divide(i, name) {
	for (name in paragraph)
		delete paragraph[name]
	name = 0
	for (i = 1; i <= lines; i++) {
		if (held[i] == ".TP" && held[i + 1] ~ /^\.B \\-/)
			name = option_in(held[i + 1])
		paragraph[name] = paragraph[name] held[i] "\n"
	}
}

function write_options(run, line, on, heading, name) {
	if (command == "")
		return
	divide()
	printf "%s", paragraph[0]
	delete paragraph[0]
	run = hawser " " command " --help"
	while ((run | getline line) > 0) {
		if (line ~ /^[^ ]/) {
			on = line ~ /:$/
			heading = line == "Options:" ? "" : substr(line, 1, length(line) - 1)
		}
		name = on && line ~ /^  (-|    --)/ ? option_in(line) : ""
		if (name == "" || !(name in paragraph))
			continue
		if (heading != "")
			print ".SS " plain(heading)
		heading = ""
		printf "%s", paragraph[name]
		delete paragraph[name]
	}
	if (close(run) != 0)
		fail(run ": no options")
	for (name in paragraph)
		fail(name " is no option of " command)
}

function include(name, words, file, line, at, found) {
	file = shared "/" name
	while ((getline line <file) > 0) {
		if ((at = index(line, "@1@")) > 0)
			line = substr(line, 1, at - 1) words substr(line, at + 3)
		put(line)
		found = 1
	}
	close(file)
	if (!found)
		fail("no text in " file)
}

# Text that roff shows as it stands.
function plain(text) {
	gsub(/\\/, "\\e", text)
	gsub(/-/, "\\-", text)
	return text ~ /^[.']/ ? "\\&" text : text
}

# A line of the list: "  name   meaning"; the indentation of inner ones is their level.
function item(line, level, name, at) {
	match(line, /^ */)
	level = RLENGTH/2
	line = substr(line, RLENGTH + 1)
	at = index(line, "  ")
	name = substr(line, 1, at - 1)
	sub(/^ */, "", line)
	line = substr(line, at)
	sub(/^ */, "", line)
	for (; depth < level; depth++)
		print ".RS 3"
	for (; depth > level; depth--)
		print ".RE"
	print ".TP 26"
	print ".B " plain(name)
	print plain(line)
}

function columns(command, wanted, run, line, on, title) {
	run = hawser " help columns " command
	depth = 1
	while ((run | getline line) > 0) {
		if (line ~ /^[^ ].*:$/) {
			for (; depth > 1; depth--)
				print ".RE"
			on = wanted == "" || index(line, wanted) == 1
			title = substr(line, 1, length(line) - 1)
			if (on) {
				print ".PP"
				print plain(title) ":"
				print ".PD 0"
				count++
			}
		} else if (line ~ /^ / && on) {
			item(line)
		} else if (line == "" && on) {
			for (; depth > 1; depth--)
				print ".RE"
			print ".PD"
			on = 0
		}
	}
	for (; depth > 1; depth--)
		print ".RE"
	if (on)
		print ".PD"
	if (close(run) != 0 || !count)
		fail(run ": no such list")
}

# Lines "  name   summary" of hawser --help, below the titles of their groups, which one blank indents.
function commands(run, line, on, name, first) {
	run = hawser " --help"
	while ((run | getline line) > 0) {
		if (line ~ /^[^ ]/)
			on = line == "Commands:"
		if (on && line ~ /^ [^ ]/)
			print ".SS " plain(substr(line, 2))
		if (!on || line !~ /^  /)
			continue
		match(line, /^  [^ ]+( [^ ]+)?/)
		name = substr(line, 3, RLENGTH - 2)
		sub(/^ +/, "", line)
		sub(/^[^ ]+( [^ ]+)? +/, "", line)
		first = name
		sub(/ .*/, "", first)
		if (name != first)
			name = "\"" name "\""
		print ".TP"
		print ".BR " name " \" \\- see \" hawser\\-" first " (1)"
		print line "."
		count++
	}
	if (close(run) != 0 || !count)
		fail(run ": no commands")
}

/^\.TH HAWSER\\-/ {
	page = tolower($2)
	sub(/^hawser\\-/, "", page)
}
/^\.\\" @include / {
	sub(/^[^ ]* @include /, "")
	at = index($0 " ", " ")
	include(substr($0, 1, at - 1), substr($0, at + 1))
	next
}
/^\.\\" @commands/ {
	commands()
	next
}
/^\.\\" @columns / {
	rest = substr($0, 13)
	at = index(rest, ": ")
	columns(at ? substr(rest, 1, at - 1) : rest, at ? substr(rest, at + 2) : "")
	next
}
{ put($0) }
END {
	if (!failed)
		write_options()
	exit failed
}
