# Checks of the repository itself, and the suite run in other ways.
REPO_CHECKS = \
	%D%/checks/awks.sh \
	%D%/checks/bindings.sh \
	%D%/checks/columns.sh \
	%D%/checks/compilable.sh \
	%D%/checks/docs.sh \
	%D%/checks/faults.sh \
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
EXTRA_DIST += %D%/checks/bindings/frf.cpp %D%/checks/bindings/frf.py %D%/checks/bindings/settle.py %D%/checks/columns.py %D%/checks/lib.sh %D%/checks/messages.py %D%/checks/shapes.awk %D%/checks/shown.py examples/duffing.c examples/frf.c examples/statics.c

# They look at sources and at a plain build; one run of them is enough.
if SANITIZERS
EXTRA_DIST += $(REPO_CHECKS)
else
test_scripts += $(REPO_CHECKS)
endif

# What the checks need to know about the build.
TEST_ENVIRONMENT += \
	CC='$(CC)'; NM='$(NM)'; PKG_CONFIG='$(PKG_CONFIG)'; MAKE='$(MAKE)'; \
	LIBDIR='$(libdir)'; INCLUDEDIR='$(includedir)'; BINDIR='$(bindir)'; \
	export CC NM PKG_CONFIG MAKE LIBDIR INCLUDEDIR BINDIR;

# What ./quickstart check runs: all tests but those of longer.txt, which has the reason for each. A test that takes more than
# QUICK_SECS of processor time fails, unless it is in slow.txt with a reason. Memory that is read before it is written has another
# content than 0 in them.
QUICK_SECS = 3
check-quick: all-am $(check_PROGRAMS) $(check_DATA)
	@MALLOC_PERTURB_=165 $(MAKE) --no-print-directory check-local \
		RUN_FLAGS='-X $(srcdir)/%D%/longer.txt -s $(QUICK_SECS) -r $(srcdir)/%D%/slow.txt'
# The tests of longer.txt, and these alone; LONGER_FLAGS are further options of tests/run.
LONGER_FLAGS =
check-longer: all-am $(check_PROGRAMS) $(check_DATA)
	@$(MAKE) --no-print-directory check-local RUN_RESULTS=tests/longer.tsv RUN_FLAGS='-T $(srcdir)/%D%/longer.txt $(LONGER_FLAGS)'

.PHONY: check-quick check-longer check-analyzers check-kernels check-kernel-sample check-provoked check-sanitizers check-sanitizers-sample check-cover check-valgrind check-valgrind-all check-faults check-long check-more \
	check-compilers check-syntax

# The program and the tests under AddressSanitizer (with its leak check) and UBSan, by clang, in a build of their own, which fuzzing
# uses as well. clang's warnings are errors there. Not an error is NULL + 0, which clang counts as one and C2y defines; other
# pointers beyond an array, or to nothing, are AddressSanitizer's. The checks of null pointers and sizes besides, and of alignment,
# which src/batches.sh asks for where it may go wrong, take 40 % of the compilation. make check-sanitizers TESTS=... runs less.
SANITIZERS_CC = clang
sanitizers/config.status:
	@$(MKDIR_P) sanitizers
	cd sanitizers && $(abs_top_srcdir)/configure -q --enable-sanitizers --enable-werror --disable-shared CC='$(SANITIZERS_CC)' \
		CFLAGS='-O1 -g1 -fsanitize-coverage=inline-8bit-counters,pc-table -fno-sanitize=pointer-overflow,null,object-size,alignment'
	$(SHELL) $(abs_top_srcdir)/src/batches.sh sanitizers
check-sanitizers: sanitizers/config.status
	$(MAKE) -C sanitizers check-programs
	$(MAKE) -C sanitizers check-local

# What .ci/run takes of it: the tests that reach most of the sources in the least time, and every command with every scene. Left out
# are those of unsanitized.txt, which check-cover writes; there are the ranks too, since Open MPI leaks.
EXTRA_DIST += %D%/unsanitized.txt
WITHOUT_LONGER = $(addprefix -x ,$(filter-out cli/every-scene,$(shell cut -d ' ' -f 1 $(srcdir)/%D%/longer.txt)))
check-sanitizers-sample: sanitizers/config.status
	$(MAKE) -C sanitizers check-programs
	$(MAKE) -C sanitizers check-local RUN_FLAGS="-X $(abs_srcdir)/%D%/unsanitized.txt $(WITHOUT_LONGER)"

# Valgrind sees what the sanitizers don't: values that were never written, also on their way through BLAS, LAPACK and SuiteSparse,
# which are not compiled with MemorySanitizer. The leaks that count are definite ones: udunits2 keeps tables that
# valgrind finds possibly lost. A cheap test or two of each stage.
RUN_VALGRIND = $(VALGRIND) -q --leak-check=full --show-leak-kinds=definite --errors-for-leak-kinds=definite --error-exitcode=9
VALGRIND_TESTS = unit/status unit/scene-cases unit/scene-files reference/statics-cases reference/statics-spans unit/modes-grid \
	reference/modes unit/gyroscopic unit/beam-integrals unit/friction-law reference/friction reference/net-modes reference/line \
	reference/line-closed unit/rod-element unit/rod-band unit/drag unit/rom-file unit/rom-full unit/rom-kernel unit/own-file \
	unit/floquet unit/flow unit/balance unit/balance-blocks unit/folds unit/locus unit/frf-vanish unit/guards unit/linear unit/map \
	unit/hill-matrix unit/integrate-spectrum unit/study-landmarks unit/fields unit/output
check-valgrind: all-am $(check_PROGRAMS)
	@test '$(VALGRIND)' != no || { echo 'valgrind is not installed'; exit 1; }
	@$(MAKE) --no-print-directory check-local RUN_RESULTS=tests/valgrind.tsv \
		RUN_FLAGS="-w '$(RUN_VALGRIND)' -l tests/valgrind $(addprefix -t ,$(VALGRIND_TESTS))"

# All test programs, and the program itself in the tests of the command line, under valgrind.
# Left out are: extremes/alloc, whose library stands in for the allocator, as valgrind does; the sweeps of
# parameters, whose oracles need a long double, which valgrind computes as a double; tests of the memory
# that a run takes, and of how long an interrupt or a full disk may take, since valgrind's own counts; the
# checks of the repository; and what starts the program from Python. It takes hours: make check-valgrind-all TESTS=... runs less.
VALGRIND_ALL_OUT = '*-fuzz' '*-sweep' '*/sweep-*' '*/alloc' '*-memory' '*/map-threads' 'checks/*' cli/disk cli/full cli/files cli/interrupt \
	cli/help-vs-man
check-valgrind-all: all-am $(check_PROGRAMS)
	@test '$(VALGRIND)' != no || { echo 'valgrind is not installed'; exit 1; }
	@printf '#!/bin/sh\nexec %s "$$@"\n' "$(SHELL) $(abs_top_builddir)/libtool --mode=execute $(RUN_VALGRIND) \
		$(abs_top_builddir)/hawser" >hawser-valgrind
	@chmod +x hawser-valgrind
	@$(MAKE) --no-print-directory check-local TEST_HAWSER=hawser-valgrind SERVER_SETTING= RUN_RESULTS=tests/valgrind.tsv \
		RUN_FLAGS="-w '$(RUN_VALGRIND)' -l tests/valgrind $(addprefix -x ,$(VALGRIND_ALL_OUT))"

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
provoked/config.status:
	@$(MKDIR_P) provoked
	cd provoked && $(abs_top_srcdir)/configure -q --disable-shared CC=gcc CFLAGS='-O1 -g --coverage'
check-provoked: provoked/config.status
	cd provoked && $(MAKE) && find . -name '*.gcda' -exec rm -f {} + && { $(MAKE) -k check; :; }
	cd $(srcdir) && python3 tests/checks/provoked.py $(abs_top_builddir)/provoked

# Which tests reach what cheaper ones don't: all tests under the sanitizers, with programs that write down what they reach (clang counts
# it for fuzzing anyway). The list is sanitizers/unsanitized.txt; make it anew when the sanitizers' step of .ci/run takes too long.
EXTRA_DIST += %D%/checks/cover.py %D%/checks/cover.c
COVERED = $(addprefix sanitizers/,hawser $(check_PROGRAMS))
check-cover: sanitizers/config.status
	$(MAKE) -C sanitizers check-programs
	$(SANITIZERS_CC) -D_GNU_SOURCE -O1 -c -o sanitizers/cover.o $(srcdir)/%D%/checks/cover.c
	rm -rf sanitizers/cover $(COVERED)
	$(MAKE) -C sanitizers check-programs LDFLAGS=$(abs_builddir)/sanitizers/cover.o
	-$(MAKE) -C sanitizers -k check-local LDFLAGS=$(abs_builddir)/sanitizers/cover.o \
		RUN_FLAGS="-g $(abs_builddir)/sanitizers/cover $(WITHOUT_LONGER)"
	cd sanitizers && python3 $(abs_srcdir)/%D%/checks/cover.py cover tests/results.tsv cli/every-scene >unsanitized.txt
	rm -f $(COVERED)

# The numerical tests under every kernel of OpenBLAS that the processor runs, and with Debian's reference BLAS and
# LAPACK; logs in kernels/. KERNELS=... and TESTS=... run less. Left out are tests without numbers.
KERNELS_X86 = Prescott Core2 Penryn Dunnington Atom Nehalem Nano Opteron Opteron_SSE3 Barcelona Bobcat Bulldozer Piledriver \
	Steamroller Excavator Sandybridge Haswell Zen SkylakeX Cooperlake SapphireRapids
KERNELS = $(KERNELS_X86) reference
KERNEL_OUT = 'checks/*' 'unit/scene*' unit/status '*-memory' cli/disk cli/files cli/full cli/help-vs-man cli/interrupt cli/pictures \
	cli/usage cli/bad-input
EXTRA_DIST += %D%/kernels/run.sh
check_PROGRAMS += %D%/kernels/probe
%C%_kernels_probe_SOURCES = %D%/kernels/probe.c
%C%_kernels_probe_LDADD = $(LAPACKE_LIBS) $(BLAS_LIBS)
check-kernels: all-am $(check_PROGRAMS)
	@MAKE='$(MAKE)' KERNELS='$(KERNELS)' KERNEL_FLAGS="$(addprefix -x ,$(KERNEL_OUT)) $(KERNEL_SAMPLE_FLAGS)" \
		KERNEL_TESTS='$(TESTS)' $(SHELL) $(srcdir)/%D%/kernels/run.sh

# What .ci/run takes of it: an old kernel, two with AVX, one with AVX-512 and the reference; the tests that have failed under some
# kernel, and cheap ones of each stage.
KERNEL_SAMPLE = Prescott Sandybridge Haswell SkylakeX reference
KERNEL_SAMPLE_TESTS = 'unit/*' 'reference/*' property/choose property/folds property/frf property/gyroscopic property/modes-basis \
	property/modes-chain property/modes-compare property/primary property/quadratic property/rom-auto property/rom-condense \
	property/branches property/rom-inertia property/scales property/travel property/undamped \
	extremes/alloc extremes/folds-extremes extremes/modes-extremes extremes/sweep-folds extremes/sweep-hill extremes/sweep-load extremes/sweep-rom cli/refusals
KERNEL_SAMPLE_OUT = unit/map reference/map-mathieu reference/rom-auto reference/rom-export
check-kernel-sample:
	@$(MAKE) --no-print-directory check-kernels KERNELS='$(KERNEL_SAMPLE)' \
		KERNEL_SAMPLE_FLAGS="$(addprefix -t ,$(KERNEL_SAMPLE_TESTS)) $(addprefix -x ,$(KERNEL_SAMPLE_OUT))"

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

# Which step of the checks catches each of the seeded faults: a tree with all of them, two builds and the suite, in faults/. FAULTS=... are
# the numbers of those that are tried.
EXTRA_DIST += %D%/faults/fault.c %D%/faults/faults.tsv %D%/faults/run.sh %D%/faults/seed.awk %D%/faults/seed.sh %D%/faults/suite.sh \
	%D%/faults/sums.awk
check-faults:
	CC='$(CC)' AWK='$(AWK)' $(SHELL) $(srcdir)/%D%/faults/run.sh faults $(FAULTS)

# A read-only tree is checked by distcheck itself; warnings count there too.
AM_DISTCHECK_CONFIGURE_FLAGS = --enable-werror

clean-local: clean-checks
clean-checks:
	rm -rf analyzers faults fuzzing kernels provoked sanitizers werror-gcc werror-clang tests/log tests/valgrind hawser-valgrind tests/*.tsv site site-work
