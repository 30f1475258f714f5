# tests of towed bodies
TOW_TESTS = tests/reference/test-trajectory tests/reference/test-tow-steady tests/unit/test-drag
check_PROGRAMS += $(TOW_TESTS)
TESTS += $(TOW_TESTS)
tests_reference_test_trajectory_SOURCES = tests/reference/test-trajectory.c
tests_reference_test_trajectory_LDADD = $(UPTO_TOW)
tests_unit_test_drag_SOURCES = tests/unit/test-drag.c
tests_unit_test_drag_LDADD = $(UPTO_TOW)
tests_reference_test_tow_steady_SOURCES = tests/reference/test-tow-steady.c
tests_reference_test_tow_steady_LDADD = $(UPTO_TOW)
TESTS += tests/cli/tow-steady.sh
EXTRA_DIST += tests/cli/tow-steady.sh
TESTS += tests/cli/trajectory.sh
EXTRA_DIST += tests/cli/trajectory.sh
