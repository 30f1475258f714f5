# tests of contact with friction
CONTACT_TESTS = tests/reference/test-friction
check_PROGRAMS += $(CONTACT_TESTS)
TESTS += $(CONTACT_TESTS)
tests_reference_test_friction_SOURCES = tests/reference/test-friction.c
tests_reference_test_friction_LDADD = $(UPTO_CONTACT)
