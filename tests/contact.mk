# tests of contact with friction
test_programs += tests/contact
tests_contact_SOURCES = tests/cases.c \
	tests/extremes/test-friction-extremes.c \
	tests/property/test-friction-methods.c \
	tests/reference/test-friction.c \
	tests/unit/test-friction-law.c \
	tests/unit/test-surface.c
nodist_tests_contact_SOURCES = tests/contact-cases.c
tests_contact_LDADD = $(UPTO_CONTACT)
noinst_HEADERS += tests/friction-random.h
