# tests of nets
test_programs += tests/net
tests_net_SOURCES = tests/cases.c \
	tests/extremes/test-net-motion-extremes.c \
	tests/property/test-net-balance.c \
	tests/property/test-net-catenary.c \
	tests/property/test-net-cvode.c \
	tests/property/test-net-damping.c \
	tests/property/test-net-eigen.c \
	tests/property/test-net-equilibria.c \
	tests/property/test-net-error.c \
	tests/property/test-net-floor.c \
	tests/property/test-net-form.c \
	tests/property/test-net-impact-order.c \
	tests/property/test-net-methods.c \
	tests/property/test-net-profile.c \
	tests/property/test-net-span-modes.c \
	tests/property/test-net-steps.c \
	tests/property/test-net-symmetry.c \
	tests/property/test-net-tension.c \
	tests/property/test-net-touchdown.c \
	tests/reference/test-net-bed.c \
	tests/reference/test-net-ground.c \
	tests/reference/test-net-belt.c \
	tests/reference/test-net-body.c \
	tests/reference/test-net-body-bed.c \
	tests/reference/test-net-body-waves.c \
	tests/reference/test-net-contact-modes.c \
	tests/reference/test-net-contact.c \
	tests/reference/test-net-events.c \
	tests/reference/test-net-impact.c \
	tests/reference/test-net-law.c \
	tests/reference/test-net-modes.c \
	tests/reference/test-net-motion.c \
	tests/reference/test-net-round.c \
	tests/reference/test-net-water-motion.c \
	tests/reference/test-net-water.c \
	tests/reference/test-net-stiffness.c \
	tests/reference/test-net-waves.c \
	tests/reference/test-net.c \
	tests/unit/test-document.c
nodist_tests_net_SOURCES = tests/net-cases.c
tests_net_LDADD = tests/libnets.a $(UPTO_NET)
# other methods of the statics of nets, which the library does not have, and all on random cables
EXTRA_LIBRARIES += tests/libnets.a
CLEANFILES += tests/libnets.a
tests_libnets_a_SOURCES = \
	tests/nets/cables.c \
	tests/nets/certificate.c \
	tests/nets/comparison.c \
	tests/nets/descent.c \
	tests/nets/mixed.c \
	tests/nets/older.c \
	tests/nets/regularised.c \
	tests/nets/relaxation.c \
	tests/nets/two_sided.c
EXTRA_DIST += tests/reference/net-bed-corner.yaml tests/reference/net-bight.yaml tests/reference/net-damped.yaml tests/reference/net-law.yaml
