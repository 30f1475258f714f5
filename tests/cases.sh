#!/bin/sh
# tests/cases.sh SOURCES: the table of cases of a program of tests (tests/cases.h), on standard output. A source
# tests/KIND/test-NAME.c is the case KIND/NAME, and defines the function KIND_NAME; other sources are none.
# SPDX-License-Identifier: GPL-3.0-or-later
rows= declarations=
for source; do
	case $source in
		*/test-*.c) ;;
		*) continue ;;
	esac
	kind=${source%/*}
	kind=${kind##*/}
	name=${source##*/test-}
	name=${name%.c}
	function=$(echo "${kind}_$name" | tr - _)
	declarations="$declarations
int $function(void);"
	rows="$rows
	{\"$kind/$name\", $function},"
done
cat <<END
#include "tests/cases.h"
$declarations

const struct test_case test_cases[] = {$rows
	{0, 0}
};
END
