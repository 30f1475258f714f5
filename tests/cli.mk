# tests of the program
CLI_TESTS = \
	%D%/cli/bad-input.sh \
	%D%/cli/beam.sh \
	%D%/cli/choice.sh \
	%D%/cli/travel-motion.sh \
	%D%/cli/disk.sh \
	%D%/cli/editors.sh \
	%D%/cli/every-scene.sh \
	%D%/cli/colour.sh \
	%D%/cli/picture-choice.sh \
	%D%/cli/files.sh \
	%D%/cli/folds.sh \
	%D%/cli/locus.sh \
	%D%/cli/nnm.sh \
	%D%/cli/locus-exact.sh \
	%D%/cli/exact.sh \
	%D%/cli/full.sh \
	%D%/cli/help-vs-man.sh \
	%D%/cli/identify.sh \
	%D%/cli/interrupt.sh \
	%D%/cli/irvine.sh \
	%D%/cli/long.sh \
	%D%/cli/motion.sh \
	%D%/cli/net-contact.sh \
	%D%/cli/net.sh \
	%D%/cli/obstacles.sh \
	%D%/cli/rod.sh %D%/cli/rod-motion.sh %D%/cli/rod-water.sh %D%/cli/rod-winch.sh \
	%D%/cli/ropeway.sh \
	%D%/cli/ropeway-modes.sh \
	%D%/cli/ropeway-rom.sh \
	%D%/cli/ropeway-sweeps.sh \
	%D%/cli/transient.sh \
	%D%/cli/net-modes.sh \
	%D%/cli/net-motion.sh \
	%D%/cli/fe.sh \
	%D%/cli/net-plan.sh \
	%D%/cli/net-attached.sh \
	%D%/cli/net-rom.sh \
	%D%/cli/net-wind.sh \
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
	%D%/cli/report.sh \
	%D%/cli/ratios.sh \
	%D%/cli/results.sh \
	%D%/cli/same-bytes.sh \
	%D%/cli/beside.sh \
	%D%/cli/scales.sh \
	%D%/cli/signals.sh \
	%D%/cli/slack.sh \
	%D%/cli/kinds.sh \
	%D%/cli/kinds-units.sh \
	%D%/cli/standard-input.sh \
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
	%D%/cli/warnings.sh \
	%D%/cli/tow-steady.sh \
	%D%/cli/mooring-files.sh \
	%D%/cli/tow.sh \
	%D%/cli/trajectory.sh \
	%D%/cli/usage.sh
test_scripts += $(CLI_TESTS)
EXTRA_DIST += %D%/cli/lib.sh %D%/cli/serve.py %D%/reference/wave.yaml

# Tables of command lines, run in forks of one program.
CLI_TABLES = %D%/cli/mistakes.table %D%/cli/models.table %D%/cli/moorings.table %D%/cli/range.table %D%/cli/refusals.table %D%/cli/wind.table
EXTRA_DIST += $(CLI_TABLES)
test_programs += tests/commands
tests_commands_SOURCES = %D%/commands.c %D%/serve.c
tests_commands_LDADD = src/cli/libcli.a src/cli/.libs/libloaded.a src/output/.libs/liboutput.a $(UPTO_STUDY)
