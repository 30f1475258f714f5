# Fuzzing: `make fuzz` builds the targets with clang's libFuzzer in the tree of make check-sanitizers,
# sanitizers/, and runs each in fuzzing/ for FUZZ_SECONDS, or FUZZ_RUNS inputs if that is set, from the
# committed seeds. What it finds stays in fuzzing/findings/.
FUZZ_TARGETS = tests/fuzz/fuzz-scene tests/fuzz/fuzz-document tests/fuzz/fuzz-set tests/fuzz/fuzz-model \
	tests/fuzz/fuzz-state tests/fuzz/fuzz-checkpoint
EXTRA_PROGRAMS += $(FUZZ_TARGETS)
FUZZER_LINK = $(AM_LDFLAGS) -fsanitize=fuzzer -Wl,--wrap=ut_read_xml -Wl,--wrap=ut_free_system
tests_fuzz_fuzz_scene_SOURCES = tests/fuzz/fuzz-scene.c tests/fuzz/units.c
tests_fuzz_fuzz_scene_LDADD = $(UPTO_STATICS) -lm
tests_fuzz_fuzz_scene_LDFLAGS = $(FUZZER_LINK)
tests_fuzz_fuzz_document_SOURCES = tests/fuzz/fuzz-document.c tests/fuzz/units.c
tests_fuzz_fuzz_document_LDADD = $(UPTO_TOW) -lm
tests_fuzz_fuzz_document_LDFLAGS = $(FUZZER_LINK)
tests_fuzz_fuzz_set_SOURCES = tests/fuzz/fuzz-set.c tests/fuzz/units.c
tests_fuzz_fuzz_set_LDADD = $(UPTO_SCENE) -lm
tests_fuzz_fuzz_set_LDFLAGS = $(FUZZER_LINK)
tests_fuzz_fuzz_model_SOURCES = tests/fuzz/fuzz-model.c tests/fuzz/units.c
tests_fuzz_fuzz_model_LDADD = $(UPTO_ROM) -lm
tests_fuzz_fuzz_model_LDFLAGS = $(FUZZER_LINK)
# states are read by the program alone; the units in which they are written stand in for its model's
tests_fuzz_fuzz_state_SOURCES = tests/fuzz/fuzz-state.c src/cli/model/state.c
tests_fuzz_fuzz_state_LDADD = $(UPTO_CORE) $(JANSSON_LIBS) -lm
tests_fuzz_fuzz_state_LDFLAGS = $(AM_LDFLAGS) -fsanitize=fuzzer
tests_fuzz_fuzz_checkpoint_SOURCES = tests/fuzz/fuzz-checkpoint.c
tests_fuzz_fuzz_checkpoint_LDADD = $(UPTO_STUDY) -lm
tests_fuzz_fuzz_checkpoint_LDFLAGS = $(AM_LDFLAGS) -fsanitize=fuzzer
CLEANFILES += $(FUZZ_TARGETS)

FUZZ_SECONDS = 60
FUZZ_RUNS = -1
# targets that run at the same time
FUZZ_JOBS = 1
# 0: another one each time. With FUZZ_RUNS it makes a run that another machine repeats.
FUZZ_SEED = 0
# Seconds from which one input counts as a hang.
FUZZ_TIMEOUT = 1
EXTRA_DIST += tests/fuzz/run.sh tests/fuzz/leaks.supp tests/fuzz/corpus
.PHONY: fuzz
fuzz:
	@SRCDIR='$(abs_top_srcdir)' FUZZ_SECONDS='$(FUZZ_SECONDS)' \
		FUZZ_JOBS='$(FUZZ_JOBS)' FUZZ_RUNS='$(FUZZ_RUNS)' FUZZ_SEED='$(FUZZ_SEED)' FUZZ_TIMEOUT='$(FUZZ_TIMEOUT)' \
		FUZZ_TARGETS='$(FUZZ_TARGETS)' MAKE='$(MAKE)' \
		$(SHELL) $(srcdir)/tests/fuzz/run.sh

# Allocations that fail: the program under a library that refuses one of them. It is compiled by
# itself, since the program's own sanitizers are none of its business.
test_programs += tests/memory
tests_memory_SOURCES = tests/cases.c \
	tests/extremes/test-alloc.c
nodist_tests_memory_SOURCES = tests/memory-cases.c
EXTRA_DIST += tests/fuzz/alloc.c
check_DATA = tests/fuzz/alloc.so
CLEANFILES += tests/fuzz/alloc.so
tests/fuzz/alloc.so: tests/fuzz/alloc.c
	@$(MKDIR_P) tests/fuzz
	$(AM_V_CCLD)$(CC) $(CPPFLAGS) -std=c11 -O1 -g -fPIC -shared -o $@ $(srcdir)/tests/fuzz/alloc.c -ldl
# The program itself, not libtool's script in front of it.
TEST_ENVIRONMENT += \
	HAWSER_PRELOAD='$(abs_top_builddir)/tests/fuzz/alloc.so'; export HAWSER_PRELOAD; \
	HAWSER_REAL='$(abs_top_builddir)/hawser'; \
	test ! -x '$(abs_top_builddir)/.libs/hawser' || HAWSER_REAL='$(abs_top_builddir)/.libs/hawser'; \
	export HAWSER_REAL;
