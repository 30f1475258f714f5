# tests of contact with friction
test_programs += tests/contact
tests_contact_SOURCES = tests/cases.c \
	tests/extremes/test-friction-extremes.c \
	tests/property/test-friction-methods.c \
	tests/reference/test-friction.c \
	tests/unit/test-friction-law.c \
	tests/unit/test-surface.c
nodist_tests_contact_SOURCES = tests/contact-cases.c
tests_contact_LDADD = tests/libsiconos.a $(UPTO_CONTACT)
# Siconos is loaded at run time: its headers are all that is needed here.
EXTRA_LIBRARIES += tests/libsiconos.a
CLEANFILES += tests/libsiconos.a
tests_libsiconos_a_SOURCES = tests/friction-siconos.c
tests_libsiconos_a_CFLAGS = $(AM_CFLAGS) $(SICONOS_CFLAGS)
