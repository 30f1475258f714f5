# Checks of the repository itself, and the suite run in other ways.
REPO_CHECKS = \
	%D%/checks/compilable.sh \
	%D%/checks/docs.sh \
	%D%/checks/includes.sh \
	%D%/checks/installed.sh \
	%D%/checks/man.sh \
	%D%/checks/messages.sh \
	%D%/checks/packages.sh \
	%D%/checks/shapes.sh \
	%D%/checks/size.sh \
	%D%/checks/symbols.sh
dist_check_SCRIPTS = $(REPO_CHECKS)
EXTRA_DIST += %D%/checks/lib.sh %D%/checks/shapes.awk examples/frf.c examples/statics.c

# They look at sources and at a plain build; one run of them is enough.
if !SANITIZERS
TESTS += $(REPO_CHECKS)
endif

# What the checks need to know about the build.
AM_TESTS_ENVIRONMENT += \
	CC='$(CC)'; NM='$(NM)'; PKG_CONFIG='$(PKG_CONFIG)'; MAKE='$(MAKE)'; \
	LIBDIR='$(libdir)'; INCLUDEDIR='$(includedir)'; BINDIR='$(bindir)'; \
	export CC NM PKG_CONFIG MAKE LIBDIR INCLUDEDIR BINDIR;

.PHONY: check-sanitizers check-valgrind check-long check-compilers

# The suite under AddressSanitizer (with its leak check) and UBSan, in a build of its own. CC may be
# clang; make check-sanitizers TESTS=... runs less.
check-sanitizers:
	@$(MKDIR_P) sanitizers
	@test -f sanitizers/config.status || { cd sanitizers && \
		$(abs_top_srcdir)/configure -q --enable-sanitizers --disable-shared CC='$(CC)' CFLAGS='-O1 -g'; }
	cd sanitizers && $(MAKE) && $(MAKE) check

# The unit tests under valgrind. The leaks that count are definite ones: udunits2 keeps tables that
# valgrind finds possibly lost.
RUN_VALGRIND = $(LIBTOOL) --mode=execute $(VALGRIND) -q --leak-check=full --show-leak-kinds=definite \
	--errors-for-leak-kinds=definite --error-exitcode=9
VALGRIND_TESTS = $(filter-out %-fuzz,$(filter tests/unit/%,$(check_PROGRAMS:$(EXEEXT)=)))
check-valgrind:
	@test '$(VALGRIND)' != no || { echo 'valgrind is not installed'; exit 1; }
	$(MAKE) check TESTS='$(VALGRIND_TESTS)' TEST_SUITE_LOG=test-valgrind.log \
		LOG_COMPILER='$(RUN_VALGRIND)'

# The suite with HAWSER_LONG=1, by which tests with more to try than fits in a coffee break know it.
check-long:
	HAWSER_LONG=1 $(MAKE) check

# Every program and test compiled by both compilers, a warning being an error.
check-compilers:
	@for cc in gcc clang; do \
		$(MKDIR_P) werror-$$cc && { test -f werror-$$cc/config.status || ( cd werror-$$cc && \
			$(abs_top_srcdir)/configure -q --enable-werror --disable-static CC=$$cc CFLAGS=-O2 ); } && \
		$(MAKE) -C werror-$$cc && $(MAKE) -C werror-$$cc check TESTS= || exit 1; done

# A read-only tree is checked by distcheck itself; warnings count there too.
AM_DISTCHECK_CONFIGURE_FLAGS = --enable-werror

clean-local: clean-checks
clean-checks:
	rm -rf fuzzing sanitizers werror-gcc werror-clang test-valgrind.log
