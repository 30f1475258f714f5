# tests of the program and of its output
CLI_TESTS = \
	%D%/cli/bad-input.sh \
	%D%/cli/beam.sh \
	%D%/cli/choice.sh \
	%D%/cli/travel-motion.sh \
	%D%/cli/disk.sh \
	%D%/cli/editors.sh \
	%D%/cli/colour.sh \
	%D%/cli/picture-choice.sh \
	%D%/cli/files.sh \
	%D%/cli/folds.sh \
	%D%/cli/locus.sh \
	%D%/cli/nnm.sh \
	%D%/cli/locus-exact.sh \
	%D%/cli/full.sh \
	%D%/cli/help-vs-man.sh \
	%D%/cli/identify.sh \
	%D%/cli/interrupt.sh \
	%D%/cli/irvine.sh \
	%D%/cli/long.sh \
	%D%/cli/motion.sh \
	%D%/cli/net-contact.sh \
	%D%/cli/net.sh \
	%D%/cli/net-profile.sh \
	%D%/cli/obstacles.sh \
	%D%/cli/rod.sh %D%/cli/rod-motion.sh %D%/cli/rod-winch.sh \
	%D%/cli/ropeway.sh \
	%D%/cli/ropeway-modes.sh \
	%D%/cli/ropeway-rom.sh \
	%D%/cli/ropeway-sweeps.sh \
	%D%/cli/transient.sh \
	%D%/cli/net-modes.sh \
	%D%/cli/net-motion.sh \
	%D%/cli/fe.sh \
	%D%/cli/net-plan.sh \
	%D%/cli/section.sh \
	%D%/cli/map.sh \
	%D%/cli/pairs.sh \
	%D%/cli/peaks.sh \
	%D%/cli/units-plot.sh \
	%D%/cli/units.sh \
	%D%/cli/pictures.sh \
	%D%/cli/plausible.sh \
	%D%/cli/python.sh \
	%D%/cli/ranks.sh \
	%D%/cli/refusals.sh \
	%D%/cli/report.sh \
	%D%/cli/ratios.sh \
	%D%/cli/results.sh \
	%D%/cli/same-bytes.sh \
	%D%/cli/beside.sh \
	%D%/cli/scales.sh \
	%D%/cli/signals.sh \
	%D%/cli/slack.sh \
	%D%/cli/stiff.sh \
	%D%/cli/study.sh \
	%D%/cli/sweep.sh \
	%D%/cli/static-load.sh \
	%D%/cli/attach.sh \
	%D%/cli/bending.sh \
	%D%/cli/loads.sh \
	%D%/cli/travel.sh \
	%D%/cli/branches.sh \
	%D%/cli/label.sh \
	%D%/cli/over.sh \
	%D%/cli/tori.sh \
	%D%/cli/library.sh \
	%D%/cli/own.sh \
	%D%/cli/published.sh \
	%D%/cli/published-forced.sh \
	%D%/cli/unstable.sh \
	%D%/cli/usage.sh
TESTS += $(CLI_TESTS)
dist_check_SCRIPTS += $(CLI_TESTS)
EXTRA_DIST += %D%/cli/lib.sh

check_PROGRAMS += %D%/unit/test-output
TESTS += %D%/unit/test-output
tests_unit_test_output_SOURCES = %D%/unit/test-output.c
tests_unit_test_output_LDADD = src/output/.libs/liboutput.a $(UPTO_RESPONSE)

check_PROGRAMS += %D%/unit/test-fields
TESTS += %D%/unit/test-fields
tests_unit_test_fields_SOURCES = %D%/unit/test-fields.c
tests_unit_test_fields_LDADD = src/output/.libs/liboutput.a $(UPTO_RESPONSE)

check_PROGRAMS += %D%/unit/test-fields-read
TESTS += %D%/unit/test-fields-read
tests_unit_test_fields_read_SOURCES = %D%/unit/test-fields-read.c
tests_unit_test_fields_read_LDADD = src/output/.libs/liboutput.a $(UPTO_RESPONSE)

check_PROGRAMS += %D%/unit/test-fields-computed
TESTS += %D%/unit/test-fields-computed
tests_unit_test_fields_computed_SOURCES = %D%/unit/test-fields-computed.c
tests_unit_test_fields_computed_LDADD = src/output/.libs/liboutput.a $(UPTO_RESPONSE)

check_PROGRAMS += %D%/unit/test-axis
TESTS += %D%/unit/test-axis
tests_unit_test_axis_SOURCES = %D%/unit/test-axis.c src/cli/axis.c
tests_unit_test_axis_LDADD = src/output/.libs/liboutput.a $(UPTO_SCENE) $(JANSSON_LIBS)
