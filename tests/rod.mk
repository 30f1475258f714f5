# tests of geometrically exact rods
test_programs += tests/rod
tests_rod_SOURCES = tests/cases.c \
	tests/property/test-rod-cvode.c \
	tests/property/test-rod-winch.c \
	tests/property/test-rod.c \
	tests/reference/test-rod-motion.c \
	tests/reference/test-rod-statics.c \
	tests/reference/test-rod-water.c \
	tests/unit/test-rod-band.c \
	tests/unit/test-rod-element.c \
	tests/unit/test-rod-motion.c \
	tests/unit/test-rod-water.c \
	tests/unit/test-rod-winch.c
nodist_tests_rod_SOURCES = tests/rod-cases.c
tests_rod_LDADD = $(UPTO_ROD) $(SUNDIALS_LIBS) -lsundials_sunlinsolband -lsundials_sunmatrixband
