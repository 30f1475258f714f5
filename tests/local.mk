# The tests: a program a stage, whose cases are the sources tests/KIND/test-NAME.c, and scripts. All speak TAP, and tests/run runs
# them. A program links its own stage and the stages upstream of it, so that an upward call does not link.
test_programs =
test_scripts =
test_helpers =
TEST_ENVIRONMENT =
EXTRA_DIST += %D%/cases.sh %D%/longer.txt %D%/slow.txt
check_PROGRAMS += %D%/run
tests_run_SOURCES = %D%/run.c %D%/run_list.c

# The stages' archives, which need no libtool to link (see only.mk).
UPTO_CORE = src/core/.libs/libcore.a
UPTO_CONTINUATION = src/continuation/.libs/libcontinuation.a $(UPTO_CORE) -lm
UPTO_SCENE = src/scene/.libs/libscene.a $(UPTO_CONTINUATION) $(YAML_LIBS) $(JANSSON_LIBS) $(UDUNITS_LIBS)
UPTO_STATICS = src/statics/.libs/libstatics.a $(UPTO_SCENE) $(GSL_LIBS)
UPTO_MODES = src/modes/.libs/libmodes.a $(UPTO_STATICS) $(SLICOT_LIBS) $(LAPACKE_LIBS) $(BLAS_LIBS)
UPTO_BEAM = src/beam/.libs/libbeam.a $(UPTO_MODES)
UPTO_CONTACT = src/contact/.libs/libcontact.a $(UPTO_BEAM) $(CHOLMOD_LIBS)
UPTO_WATER = src/water/.libs/libwater.a $(UPTO_CONTACT)
UPTO_NET = src/net/.libs/libnet.a $(UPTO_WATER) $(CHOLMOD_LIBS) $(SUNDIALS_LIBS)
UPTO_ROPEWAY = src/ropeway/.libs/libropeway.a $(UPTO_NET)
UPTO_ROD = src/rod/.libs/librod.a $(UPTO_ROPEWAY)
UPTO_TOW = src/tow/.libs/libtow.a $(UPTO_ROD)
UPTO_ROM = src/rom/.libs/librom.a $(UPTO_TOW) $(JANSSON_LIBS)
UPTO_RESPONSE = src/response/.libs/libresponse.a $(UPTO_ROM) $(SUNDIALS_LIBS) $(FFTW_LIBS) $(SLICOT_LIBS)
UPTO_STUDY = src/study/.libs/libstudy.a $(UPTO_RESPONSE)

src/core/.libs/libcore.a: src/core/libcore.la
	@:
src/continuation/.libs/libcontinuation.a: src/continuation/libcontinuation.la
	@:
src/scene/.libs/libscene.a: src/scene/libscene.la
	@:
src/statics/.libs/libstatics.a: src/statics/libstatics.la
	@:
src/modes/.libs/libmodes.a: src/modes/libmodes.la
	@:
src/beam/.libs/libbeam.a: src/beam/libbeam.la
	@:
src/contact/.libs/libcontact.a: src/contact/libcontact.la
	@:
src/water/.libs/libwater.a: src/water/libwater.la
	@:
src/net/.libs/libnet.a: src/net/libnet.la
	@:
src/ropeway/.libs/libropeway.a: src/ropeway/libropeway.la
	@:
src/rod/.libs/librod.a: src/rod/librod.la
	@:
src/tow/.libs/libtow.a: src/tow/libtow.la
	@:
src/rom/.libs/librom.a: src/rom/librom.la
	@:
src/response/.libs/libresponse.a: src/response/libresponse.la
	@:
src/study/.libs/libstudy.a: src/study/libstudy.la
	@:
src/output/.libs/liboutput.a: src/output/liboutput.la
	@:
src/cli/.libs/libloaded.a: src/cli/libloaded.la
	@:

include %D%/core.mk
include %D%/continuation.mk
include %D%/scene.mk
include %D%/statics.mk
include %D%/modes.mk
include %D%/beam.mk
include %D%/contact.mk
include %D%/water.mk
include %D%/net.mk
include %D%/ropeway.mk
include %D%/rod.mk
include %D%/tow.mk
include %D%/rom.mk
include %D%/response.mk
include %D%/study.mk
include %D%/output.mk
include %D%/cli.mk
include %D%/fuzz.mk
include %D%/checks.mk
check_PROGRAMS += $(test_programs) $(test_helpers)
dist_check_SCRIPTS = $(test_scripts)

# The table of a program's cases, from the names of its sources.
test_tables = $(patsubst %,%-cases.c,$(filter-out tests/commands,$(test_programs:$(EXEEXT)=)))
MOSTLYCLEANFILES += $(test_tables)
$(test_tables): tests/%-cases.c: Makefile $(srcdir)/tests/cases.sh
	$(AM_V_GEN)$(MKDIR_P) tests && $(SHELL) $(srcdir)/tests/cases.sh $(tests_$*_SOURCES) >$@.tmp && mv -f $@.tmp $@

# python3 may be a script that looks for the python to start (pyenv), which takes ten times as long as that: tests start it.
PYTHON_SETTING = python=`python3 -S -c 'import os, sys; print(os.path.realpath(sys.executable))' 2>/dev/null`; \
	if test -x "$$python" && $(MKDIR_P) %D%/bin && ln -sf "$$python" %D%/bin/python3; then \
		PATH=$(abs_top_builddir)/%D%/bin:$$PATH; export PATH; fi;
MOSTLYCLEANFILES += %D%/bin/python3

# What tests get to know. Tests run side by side: the BLAS's threads must leave the processors to the others.
TEST_ENVIRONMENT += $(PYTHON_SETTING) \
	HAWSER='$(abs_top_builddir)/$(TEST_HAWSER)'; export HAWSER; \
	$(SERVER_SETTING) SRCDIR='$(abs_top_srcdir)'; export SRCDIR; \
	OPENBLAS_NUM_THREADS=1; export OPENBLAS_NUM_THREADS; $(KERNEL_SETTING)

# make check runs all tests, make check TESTS="property/frf tests/cli/net.sh tests/rom" those; RUN_FLAGS are further options of
# tests/run, and RUN_RESULTS is where the results go. JOBS is how many run at the same time: by default as many as make
# would, which it does not tell, so the processors' number.
JOBS =
TEST_HAWSER = hawser
# The scripts' commands run in forks of one program (tests/serve.c). make check builds it, so that it is never an old one.
SERVER_SETTING = HAWSER_SERVER='$(abs_top_builddir)/tests/commands$(EXEEXT)'; export HAWSER_SERVER;
RUN_RESULTS = tests/results.tsv
RUN_FLAGS =
RUN_TESTS = unset MAKEFLAGS MFLAGS MAKELEVEL; $(TEST_ENVIRONMENT) jobs='$(JOBS)'; \
	%D%/run -j "$${jobs:-`nproc 2>/dev/null || echo 1`}" -o $(RUN_RESULTS) $(RUN_FLAGS)
RUN_ALL = $(RUN_TESTS) $(patsubst %,-t '%',$(TESTS)) $(test_programs) $(addprefix $(srcdir)/,$(test_scripts))
check-local: all-am
	@$(RUN_ALL)
# The processor time of each test of the last run, longest first.
.PHONY: times
times:
	@sort -t "`printf '\t'`" -k 6,6nr $(RUN_RESULTS) | awk -F '\t' 'NR > 1 && NR <= 31 { print $$6, $$1 } NR > 1 { s += $$6; n++ } END { print s, "all", n }'

# make check TESTS=... builds what it runs; make check-programs builds all test programs and runs none.
# It waits for all-am, not for all: all starts a second make in the same folder, and with make -j both would write the
# same objects (tests/checks/targets.sh).
-include $(top_srcdir)/%D%/only.mk
EXTRA_DIST += %D%/only.mk
.PHONY: check-programs
check-programs: all-am $(check_PROGRAMS) $(check_DATA)

# make test-response: the tests of one stage, without the program and its manual pages. This is the shortest way from an edit to
# its tests.
test-%: tests/% tests/run
	@$(RUN_TESTS) -X $(srcdir)/tests/longer.txt $<
