# Fuzzing: `make fuzz` builds the targets with clang's libFuzzer, AddressSanitizer and UBSan in
# fuzzing/ and runs each for FUZZ_SECONDS, or FUZZ_RUNS inputs if that is set, from the
# committed seeds. What it finds stays in fuzzing/findings/.
FUZZ_TARGETS = tests/fuzz/fuzz-scene tests/fuzz/fuzz-set tests/fuzz/fuzz-model
EXTRA_PROGRAMS += $(FUZZ_TARGETS)
noinst_HEADERS += tests/fuzz/fuzz.h
FUZZER_LINK = $(AM_LDFLAGS) -fsanitize=fuzzer -Wl,--wrap=ut_read_xml -Wl,--wrap=ut_free_system
tests_fuzz_fuzz_scene_SOURCES = tests/fuzz/fuzz-scene.c tests/fuzz/units.c
tests_fuzz_fuzz_scene_LDADD = $(UPTO_STATICS) -lm
tests_fuzz_fuzz_scene_LDFLAGS = $(FUZZER_LINK)
tests_fuzz_fuzz_set_SOURCES = tests/fuzz/fuzz-set.c tests/fuzz/units.c
tests_fuzz_fuzz_set_LDADD = $(UPTO_SCENE) -lm
tests_fuzz_fuzz_set_LDFLAGS = $(FUZZER_LINK)
tests_fuzz_fuzz_model_SOURCES = tests/fuzz/fuzz-model.c tests/fuzz/units.c
tests_fuzz_fuzz_model_LDADD = $(UPTO_ROM) -lm
tests_fuzz_fuzz_model_LDFLAGS = $(FUZZER_LINK)
CLEANFILES += $(FUZZ_TARGETS)

FUZZ_SECONDS = 60
FUZZ_RUNS = -1
FUZZ_CFLAGS = -O1 -g -fno-omit-frame-pointer -fno-sanitize-recover=undefined \
	-fsanitize=fuzzer-no-link,address,undefined
EXTRA_DIST += tests/fuzz/run.sh tests/fuzz/leaks.supp tests/fuzz/corpus
.PHONY: fuzz
fuzz:
	@SRCDIR='$(abs_top_srcdir)' FUZZ_CFLAGS='$(FUZZ_CFLAGS)' FUZZ_SECONDS='$(FUZZ_SECONDS)' \
		FUZZ_RUNS='$(FUZZ_RUNS)' FUZZ_TARGETS='$(FUZZ_TARGETS)' MAKE='$(MAKE)' \
		$(SHELL) $(srcdir)/tests/fuzz/run.sh
