/* cli/frame/hawser.c - main() of the program hawser; the tests of the command line have another.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/frame/within.h"

int main(int argc, char **argv)
{
	return cli_main(argc, argv);
}
