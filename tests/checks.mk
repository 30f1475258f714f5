# Checks of the repository itself, and the suite run in other ways.
REPO_CHECKS = \
	%D%/checks/bindings.sh \
	%D%/checks/columns.sh \
	%D%/checks/compilable.sh \
	%D%/checks/docs.sh \
	%D%/checks/includes.sh \
	%D%/checks/installed.sh \
	%D%/checks/man.sh \
	%D%/checks/messages.sh \
	%D%/checks/packages.sh \
	%D%/checks/quickstart.sh \
	%D%/checks/shapes.sh \
	%D%/checks/shown.sh \
	%D%/checks/site.sh \
	%D%/checks/size.sh \
	%D%/checks/symbols.sh \
	%D%/checks/targets.sh
dist_check_SCRIPTS = $(REPO_CHECKS)
EXTRA_DIST += %D%/checks/bindings/frf.cpp %D%/checks/bindings/frf.py %D%/checks/columns.py %D%/checks/lib.sh %D%/checks/messages.py %D%/checks/shapes.awk %D%/checks/shown.py examples/duffing.c examples/frf.c examples/statics.c

# They look at sources and at a plain build; one run of them is enough.
if !SANITIZERS
TESTS += $(REPO_CHECKS)
endif

# What the checks need to know about the build.
AM_TESTS_ENVIRONMENT += \
	CC='$(CC)'; NM='$(NM)'; PKG_CONFIG='$(PKG_CONFIG)'; MAKE='$(MAKE)'; \
	LIBDIR='$(libdir)'; INCLUDEDIR='$(includedir)'; BINDIR='$(bindir)'; \
	export CC NM PKG_CONFIG MAKE LIBDIR INCLUDEDIR BINDIR;

# The page of all messages, from the sources.
messages:
	cd $(srcdir) && python3 tests/checks/messages.py list >doc/messages.md

# The tests that take more than 3 s of processor time (`make times`). ./quickstart check leaves them out, so that its verdict comes
# soon; make check has them, and .ci/run runs each of them once more: under the sanitizers, or without where those leave it out.
LONGER = %D%/checks/bindings.sh %D%/checks/compilable.sh %D%/checks/docs.sh %D%/checks/installed.sh \
	%D%/checks/messages.sh %D%/checks/shown.sh %D%/checks/site.sh %D%/cli/attach.sh %D%/cli/bad-input.sh %D%/cli/beam.sh \
	%D%/cli/bending.sh %D%/cli/branches.sh %D%/cli/choice.sh %D%/cli/disk.sh %D%/cli/fe.sh %D%/cli/files.sh \
	%D%/cli/folds.sh %D%/cli/full.sh %D%/cli/help-vs-man.sh %D%/cli/identify.sh %D%/cli/interrupt.sh %D%/cli/irvine.sh \
	%D%/cli/label.sh %D%/cli/library.sh %D%/cli/loads.sh %D%/cli/locus-exact.sh %D%/cli/locus.sh %D%/cli/long.sh \
	%D%/cli/map.sh %D%/cli/motion.sh %D%/cli/net-contact.sh %D%/cli/net-motion.sh %D%/cli/net-plan.sh %D%/cli/net.sh \
	%D%/cli/nnm.sh %D%/cli/obstacles.sh %D%/cli/over.sh %D%/cli/own.sh %D%/cli/pairs.sh %D%/cli/peaks.sh \
	%D%/cli/pictures.sh %D%/cli/plausible.sh %D%/cli/published.sh %D%/cli/python.sh %D%/cli/ranks.sh %D%/cli/ratios.sh \
	%D%/cli/refusals.sh %D%/cli/report.sh %D%/cli/results.sh %D%/cli/rod-motion.sh %D%/cli/ropeway-modes.sh \
	%D%/cli/ropeway-rom.sh %D%/cli/ropeway-sweeps.sh %D%/cli/ropeway.sh %D%/cli/same-bytes.sh %D%/cli/scales.sh \
	%D%/cli/signals.sh %D%/cli/slack.sh %D%/cli/static-load.sh %D%/cli/stiff.sh %D%/cli/study.sh %D%/cli/sweep.sh \
	%D%/cli/tori.sh %D%/cli/tow.sh %D%/cli/transient.sh %D%/cli/travel-motion.sh %D%/cli/travel.sh %D%/cli/units-plot.sh \
	%D%/cli/usage.sh %D%/property/test-campbell %D%/property/test-combined %D%/property/test-estimates \
	%D%/property/test-hill-boundaries %D%/property/test-identify %D%/property/test-identify-bending \
	%D%/property/test-modes %D%/property/test-study %D%/property/test-study-chosen %D%/reference/rom-export.sh \
	%D%/extremes/test-alloc %D%/extremes/test-beam-sweep %D%/extremes/test-gyroscopic-sweep %D%/extremes/test-irvine \
	%D%/extremes/test-modes-sweep %D%/extremes/test-sweep-curves
quick_tests = $(filter-out $(LONGER),$(TESTS:$(EXEEXT)=))
rest_of_tests = $(filter $(SANITIZERS_OUT),$(filter $(LONGER),$(TESTS:$(EXEEXT)=)))
check-quick:
	$(MAKE) check TESTS='$(quick_tests)'
check-rest:
	$(MAKE) check TESTS='$(rest_of_tests)' TEST_SUITE_LOG=test-rest.log

.PHONY: messages check-quick check-rest check-analyzers check-kernels check-kernel-sample check-provoked check-sanitizers check-sanitizers-sample check-valgrind check-valgrind-all check-long check-more \
	check-compilers check-syntax

# The suite under AddressSanitizer (with its leak check) and UBSan, in a build of its own. CC may be
# clang; make check-sanitizers TESTS=... runs less.
check-sanitizers:
	@$(MKDIR_P) sanitizers
	@test -f sanitizers/config.status || { cd sanitizers && \
		$(abs_top_srcdir)/configure -q --enable-sanitizers --disable-shared CC='$(CC)' CFLAGS='-O1 -g'; }
	cd sanitizers && $(MAKE) && $(MAKE) check

# What .ci/run takes of it. Left out are the tests that take longest and whose code others run as well (check-long has them), and the
# ranks, since Open MPI leaks.
SANITIZERS_OUT = %D%/checks/% %-sweep %-estimates %-estimate %/test-sweep-curves %/test-sweep-mms %/test-study \
	%/test-study-chosen %/test-accuracy %/test-campbell %/test-irvine %/test-modes %/test-map-threads %/test-frf-full \
	%/test-map-mathieu %/same-bytes.sh %/study.sh %/beam.sh %/pictures.sh %/long.sh %/scales.sh %/travel.sh %/disk.sh %/irvine.sh \
	%/locus-exact.sh %/units-plot.sh %/plausible.sh %/travel-motion.sh %/ranks.sh
check-sanitizers-sample:
	$(MAKE) check-sanitizers TESTS='$(filter-out $(SANITIZERS_OUT),$(TESTS:$(EXEEXT)=))'

# The unit tests under valgrind. The leaks that count are definite ones: udunits2 keeps tables that
# valgrind finds possibly lost.
RUN_VALGRIND = $(SHELL) $(abs_top_builddir)/libtool --mode=execute $(VALGRIND) -q --leak-check=full --show-leak-kinds=definite \
	--errors-for-leak-kinds=definite --error-exitcode=9
VALGRIND_TESTS = $(filter-out %-fuzz %-memory,$(filter tests/unit/%,$(check_PROGRAMS:$(EXEEXT)=)))
check-valgrind:
	@test '$(VALGRIND)' != no || { echo 'valgrind is not installed'; exit 1; }
	$(MAKE) check TESTS='$(VALGRIND_TESTS)' TEST_SUITE_LOG=test-valgrind.log \
		LOG_COMPILER='$(RUN_VALGRIND)'

# All programs of the suite, and the program itself in the tests of the command line, under valgrind.
# Left out are: test-alloc, whose library stands in for the allocator, as valgrind does; the sweeps of
# parameters, whose oracles need a long double, which valgrind computes as a double; tests of the memory
# that a run takes, and of how long an interrupt or a full disk may take, since valgrind's own counts; the
# checks of the repository; and what starts the program from Python. It takes hours: VALGRIND_ALL=... runs less.
VALGRIND_OUT = %-fuzz %-sweep tests/extremes/test-sweep-% %-alloc %-memory %/test-map-threads
VALGRIND_CLI_OUT = %/disk.sh %/full.sh %/files.sh %/interrupt.sh %/help-vs-man.sh
VALGRIND_ALL = $(filter-out $(VALGRIND_OUT),$(filter tests/%,$(check_PROGRAMS:$(EXEEXT)=))) \
	$(filter-out $(VALGRIND_CLI_OUT),$(filter tests/cli/%.sh,$(TESTS)))
check-valgrind-all: all-am
	@test '$(VALGRIND)' != no || { echo 'valgrind is not installed'; exit 1; }
	@printf '#!/bin/sh\nexec %s "$$@"\n' "$(RUN_VALGRIND) $(abs_top_builddir)/hawser" >hawser-valgrind
	@chmod +x hawser-valgrind
	$(MAKE) check TESTS='$(VALGRIND_ALL)' TEST_SUITE_LOG=test-valgrind-all.log \
		LOG_COMPILER='$(RUN_VALGRIND)' \
		TESTS_ENVIRONMENT='HAWSER=$(abs_top_builddir)/hawser-valgrind; export HAWSER;'

# gcc -fanalyzer, clang-tidy (.clang-tidy) and cppcheck; what is no mistake is annotated with why.
EXTRA_DIST += .clang-tidy %D%/analyzers/run.sh %D%/analyzers/gcc.txt
# The flags are a variable because a backslash in quotes would reach the tools.
ANALYZER_FLAGS = $(DEFS) -I$(abs_top_builddir) -I$(abs_top_builddir)/src -Iinclude -Isrc -I. -std=c11 -pthread \
	$(GSL_CFLAGS) $(LAPACKE_CFLAGS) $(BLAS_CFLAGS) $(FFTW_CFLAGS) $(YAML_CFLAGS) \
	$(JANSSON_CFLAGS) $(UDUNITS_CFLAGS) $(SUNDIALS_CFLAGS)
check-analyzers:
	@SRCDIR='$(abs_top_srcdir)' ANALYZER_FLAGS='$(ANALYZER_FLAGS)' \
		$(SHELL) $(srcdir)/%D%/analyzers/run.sh

# Which messages no test provokes: the suite where lines are counted, in provoked/, then gcov. A test that
# fails because counts are written at the end of a program is no matter here.
EXTRA_DIST += %D%/checks/provoked.py %D%/checks/provoked.txt
check-provoked:
	@$(MKDIR_P) provoked
	@test -f provoked/config.status || { cd provoked && \
		$(abs_top_srcdir)/configure -q --disable-shared CC=gcc CFLAGS='-O1 -g --coverage'; }
	cd provoked && $(MAKE) && find . -name '*.gcda' -exec rm -f {} + && { $(MAKE) -k check; :; }
	cd $(srcdir) && python3 tests/checks/provoked.py $(abs_top_builddir)/provoked

# The numerical tests under every kernel of OpenBLAS that the processor runs, and with Debian's reference BLAS and
# LAPACK; logs in kernels/. KERNELS=... and TESTS=... run less. Left out are tests without numbers.
KERNELS_X86 = Prescott Core2 Penryn Dunnington Atom Nehalem Nano Opteron Opteron_SSE3 Barcelona Bobcat Bulldozer Piledriver \
	Steamroller Excavator Sandybridge Haswell Zen SkylakeX Cooperlake SapphireRapids
KERNELS = $(KERNELS_X86) reference
KERNEL_OUT = %D%/checks/% %D%/unit/test-scene% %D%/unit/test-status %-memory %/disk.sh %/files.sh %/full.sh \
	%/help-vs-man.sh %/interrupt.sh %/pictures.sh %/usage.sh %/bad-input.sh
KERNEL_TESTS = $(filter-out $(KERNEL_OUT),$(TESTS))
EXTRA_DIST += %D%/kernels/run.sh
check_PROGRAMS += %D%/kernels/probe
%C%_kernels_probe_SOURCES = %D%/kernels/probe.c
%C%_kernels_probe_LDADD = $(LAPACKE_LIBS) $(BLAS_LIBS)
check-kernels: all-am %D%/kernels/probe$(EXEEXT)
	@MAKE='$(MAKE)' KERNELS='$(KERNELS)' KERNEL_TESTS='$(KERNEL_TESTS:$(EXEEXT)=)' \
		$(SHELL) $(srcdir)/%D%/kernels/run.sh

# What .ci/run takes of it, three minutes of two processors at most: an old kernel, two with AVX, one with AVX-512 and the
# reference; the tests that have failed under some kernel, and cheap ones of each stage.
KERNEL_SAMPLE = Prescott Sandybridge Haswell SkylakeX reference
KERNEL_SAMPLE_TESTS = \
	$(filter-out %/test-map %/test-map-mathieu %/rom-auto.sh %/rom-export.sh,$(filter %D%/unit/% %D%/reference/%,$(KERNEL_TESTS))) \
	$(filter %/test-choose %/test-folds %/test-frf %/test-gyroscopic %/test-modes-basis %/test-modes-chain \
		%/test-modes-compare %/test-primary %/test-quadratic %/test-rom-auto %/test-rom-condense %/test-rom-inertia \
		%/test-scales %/test-travel,\
		$(filter %D%/property/%,$(KERNEL_TESTS))) \
	$(filter %-alloc %/test-folds-extremes %/test-modes-extremes %/test-sweep-folds %/test-sweep-hill %/test-sweep-load \
		%/test-sweep-rom,$(KERNEL_TESTS)) \
	%D%/cli/refusals.sh
check-kernel-sample:
	$(MAKE) check-kernels KERNELS='$(KERNEL_SAMPLE)' TESTS='$(KERNEL_SAMPLE_TESTS:$(EXEEXT)=)'

# All that takes longer than a coffee break, one after another: the analyzers, the suite with
# HAWSER_LONG=1, by which tests with more to try know it, the suite under sanitizers and under valgrind. Each goes on to the next; what failed is said at the end.
check-long:
	@failed=; for step in check-analyzers check-more check-sanitizers check-valgrind-all; do \
		echo "== $$step"; $(MAKE) $$step || failed="$$failed $$step"; done; \
	test -z "$$failed" || { echo "failed:$$failed"; exit 1; }

check-more:
	HAWSER_LONG=1 $(MAKE) check

# Every source in C with warnings as errors: compiled by gcc, which finds some of them only where it optimises; only read by clang,
# which finds them all then and takes a third of the time.
COMPILERS = gcc clang
check-compilers:
	@for cc in $(COMPILERS); do \
		case $$cc in clang) target=check-syntax ;; *) target=check-programs ;; esac; \
		$(MKDIR_P) werror-$$cc && { test -f werror-$$cc/config.status || ( cd werror-$$cc && \
			$(abs_top_srcdir)/configure -q --enable-werror --disable-static CC=$$cc CFLAGS=-O2 ); } && \
		$(MAKE) -C werror-$$cc $$target || exit 1; done

# The compiler reads several files in one process: that many at most. Examples and fuzz targets are compiled in their own ways by
# other checks.
SYNTAX_FILES = 40
check-syntax: $(BUILT_SOURCES)
	@cd $(srcdir) && find src tests bench -name '*.c' ! -path 'tests/fuzz/*' | sort | xargs -P 2 -n $(SYNTAX_FILES) $(CC) $(DEFS) -I$(abs_builddir) \
		-I$(abs_top_builddir)/src -Iinclude -Isrc -I. $(AM_CFLAGS) $(SICONOS_CFLAGS) $(CFLAGS) -fsyntax-only

# A read-only tree is checked by distcheck itself; warnings count there too.
AM_DISTCHECK_CONFIGURE_FLAGS = --enable-werror

clean-local: clean-checks
clean-checks:
	rm -rf analyzers fuzzing kernels provoked sanitizers werror-gcc werror-clang test-rest.log test-valgrind.log test-valgrind-all.log hawser-valgrind site site-work
