# tests of contact with friction
CONTACT_TESTS = tests/unit/test-surface tests/unit/test-friction-law tests/property/test-friction-methods \
	tests/reference/test-friction tests/extremes/test-friction-extremes
check_PROGRAMS += $(CONTACT_TESTS)
TESTS += $(CONTACT_TESTS)
tests_reference_test_friction_SOURCES = tests/reference/test-friction.c
tests_reference_test_friction_LDADD = $(UPTO_CONTACT)
tests_unit_test_friction_law_SOURCES = tests/unit/test-friction-law.c
tests_unit_test_friction_law_LDADD = $(UPTO_CONTACT)
tests_property_test_friction_methods_SOURCES = tests/property/test-friction-methods.c
tests_property_test_friction_methods_LDADD = $(UPTO_CONTACT)
tests_extremes_test_friction_extremes_SOURCES = tests/extremes/test-friction-extremes.c
tests_extremes_test_friction_extremes_LDADD = $(UPTO_CONTACT)
noinst_HEADERS += tests/friction-random.h
tests_unit_test_surface_SOURCES = tests/unit/test-surface.c
tests_unit_test_surface_LDADD = $(UPTO_CONTACT)
