# With TESTS=... on the command line, make check builds the programs among them and no others. automake does not
# understand conditions of make, so make includes this file itself. The targets of make check are read before it; so the
# shorter list is passed on to the makes that make check starts.
ifeq ($(origin TESTS),command line)
check_PROGRAMS := $(filter $(TESTS) $(TESTS:=$(EXEEXT)),$(check_PROGRAMS))
AM_MAKEFLAGS = check_PROGRAMS='$(check_PROGRAMS)'
endif
