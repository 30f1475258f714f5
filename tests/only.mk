# With TESTS=... on the command line, make check builds the programs among them and no others. automake does not
# understand conditions of make, so make includes this file itself. The targets of make check are read before it; so the
# shorter list is passed on to the makes that make check starts.
ifeq ($(origin TESTS),command line)
check_PROGRAMS := $(filter $(TESTS) $(TESTS:=$(EXEEXT)),$(check_PROGRAMS))
AM_MAKEFLAGS = check_PROGRAMS='$(check_PROGRAMS)'
endif

# libtool's script takes three times as long as the link that it starts, and there are a hundred test programs. They
# link the archives that libtool made. (private: the archives themselves are made as before.)
$(check_PROGRAMS): private LINK = $(CC) $(AM_CFLAGS) $(CFLAGS) $(AM_LDFLAGS) $(LDFLAGS) -o $@
