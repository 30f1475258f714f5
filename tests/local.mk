# Every test speaks TAP. Each program links its own stage and the stages upstream of it, so that an
# upward call does not link.
TEST_EXTENSIONS = .sh
LOG_DRIVER = env AM_TAP_AWK='$(AWK)' $(SHELL) $(top_srcdir)/build-aux/tap-driver.sh
SH_LOG_DRIVER = $(LOG_DRIVER)
# Each test's log ends with its processor time; `make times` lists them.
LOG_COMPILER = $(top_srcdir)/%D%/timed.sh
SH_LOG_COMPILER = $(LOG_COMPILER)
EXTRA_DIST += %D%/timed.sh %D%/times.sh
.PHONY: times
times:
	@$(SHELL) $(srcdir)/%D%/times.sh

# Automake takes tests/cli/units, without .sh, for a test that has passed if the log of tests/cli/units.sh
# is there. A name that is none of a test fails instead.
check-local:
	@for test in $(TESTS); do \
		test -f $$test || test -f $(srcdir)/$$test || { \
			echo "TESTS: $$test is no test; write its path with its suffix, such as" \
			     "tests/cli/units.sh" >&2; exit 1; }; \
	done

# Tests run side by side: the BLAS's threads must leave the processors to the others.
AM_TESTS_ENVIRONMENT = \
	HAWSER='$(abs_top_builddir)/hawser'; export HAWSER; \
	SRCDIR='$(abs_top_srcdir)'; export SRCDIR; \
	OPENBLAS_NUM_THREADS=1; export OPENBLAS_NUM_THREADS;
noinst_HEADERS += %D%/tap.h %D%/balance-model.h %D%/gsl_mathieu.h %D%/fields-text.h

# The stages' archives, which need no libtool to link (see only.mk).
UPTO_CORE = src/core/.libs/libcore.a
UPTO_CONTINUATION = src/continuation/.libs/libcontinuation.a $(UPTO_CORE) -lm
UPTO_SCENE = src/scene/.libs/libscene.a $(UPTO_CONTINUATION) $(YAML_LIBS) $(UDUNITS_LIBS)
UPTO_STATICS = src/statics/.libs/libstatics.a $(UPTO_SCENE) $(GSL_LIBS)
UPTO_MODES = src/modes/.libs/libmodes.a $(UPTO_STATICS) $(SLICOT_LIBS) $(LAPACKE_LIBS) $(BLAS_LIBS)
UPTO_BEAM = src/beam/.libs/libbeam.a $(UPTO_MODES)
UPTO_CONTACT = src/contact/.libs/libcontact.a $(UPTO_BEAM) $(CHOLMOD_LIBS)
UPTO_NET = src/net/.libs/libnet.a $(UPTO_CONTACT) $(CHOLMOD_LIBS) $(SUNDIALS_LIBS)
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

include %D%/checks.mk
include %D%/core.mk
include %D%/scene.mk
include %D%/statics.mk
include %D%/modes.mk
include %D%/beam.mk
include %D%/contact.mk
include %D%/net.mk
include %D%/ropeway.mk
include %D%/rod.mk
include %D%/tow.mk
include %D%/rom.mk
include %D%/response.mk
include %D%/integrate.mk
include %D%/study.mk
include %D%/cli.mk
include %D%/fuzz.mk
include %D%/sweeps.mk

# make check TESTS=... builds what it runs; make check-programs builds all test programs and runs none.
# It waits for all-am, not for all: all starts a second make in the same folder, and with make -j both would write the
# same objects (tests/checks/targets.sh).
-include $(top_srcdir)/%D%/only.mk
EXTRA_DIST += %D%/only.mk
.PHONY: check-programs
check-programs: all-am $(check_PROGRAMS) $(check_DATA)
# This test needs a program beside its own.
%D%/reference/rom-auto.log: %D%/reference/rom-auto-export$(EXEEXT)
%D%/reference/rom-export.log: %D%/reference/rom-export-values$(EXEEXT)
