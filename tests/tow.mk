# tests of towed bodies
test_programs += tests/tow
tests_tow_SOURCES = tests/cases.c \
	tests/property/test-tow-loads.c \
	tests/reference/test-tow-motion.c \
	tests/reference/test-tow-steady.c \
	tests/reference/test-tow-water.c \
	tests/reference/test-trajectory.c \
	tests/unit/test-set-keys.c \
	tests/unit/test-tree-keys.c \
	src/cli/tools/init_scenes.c
nodist_tests_tow_SOURCES = tests/tow-cases.c
tests_tow_LDADD = $(UPTO_TOW)
