# With TESTS=... on the command line, make check builds the programs that have these cases and no others. automake does not
# understand conditions of make, so make includes this file itself.
ifeq ($(origin TESTS),command line)
ifneq (,$(strip $(TESTS)))
ifeq (,$(findstring *,$(TESTS)))
wanted_cases = $(subst /test-,/,$(patsubst tests/%,%,$(TESTS:.c=)))
cases_of = $(subst /test-,/,$(patsubst tests/%.c,%,$(tests_$(notdir $(1))_SOURCES)) \
	$(if $(filter tests/commands,$(1)),$(patsubst tests/%.table,%,$(CLI_TABLES))))
test_programs := $(foreach program,$(test_programs),$(if $(filter $(TESTS),$(program))$(filter $(wanted_cases),$(call \
	cases_of,$(program))),$(program)))
check_PROGRAMS := tests/run $(test_programs) $(if $(filter tests/cli/%.sh cli/%,$(TESTS)),tests/commands) $(if $(filter tests/reference/%.sh reference/%,$(TESTS)),$(test_helpers))
endif
endif
endif

# libtool's script takes three times as long as the link that it starts. The test programs link the archives that libtool made.
# (private: the archives themselves are made as before.)
$(check_PROGRAMS): private LINK = $(CC) $(AM_CFLAGS) $(CFLAGS) $(AM_LDFLAGS) $(FAST_LINK) $(LDFLAGS) -o $@
