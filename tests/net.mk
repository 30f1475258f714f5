# tests of nets
NET_TESTS = tests/reference/test-net tests/reference/test-net-contact tests/reference/test-net-impact tests/reference/test-net-belt \
	tests/property/test-net-catenary \
	tests/property/test-net-equilibria tests/reference/test-net-contact-modes
check_PROGRAMS += $(NET_TESTS)
TESTS += $(NET_TESTS)
tests_reference_test_net_SOURCES = tests/reference/test-net.c
tests_reference_test_net_LDADD = $(UPTO_NET)
tests_reference_test_net_contact_SOURCES = tests/reference/test-net-contact.c
tests_reference_test_net_contact_LDADD = $(UPTO_NET)
tests_reference_test_net_impact_SOURCES = tests/reference/test-net-impact.c
tests_reference_test_net_belt_SOURCES = tests/reference/test-net-belt.c
tests_reference_test_net_belt_LDADD = $(UPTO_NET)
tests_reference_test_net_impact_LDADD = $(UPTO_NET)
tests_reference_test_net_contact_modes_SOURCES = tests/reference/test-net-contact-modes.c
tests_reference_test_net_contact_modes_LDADD = $(UPTO_NET)
tests_property_test_net_catenary_SOURCES = tests/property/test-net-catenary.c
tests_property_test_net_catenary_LDADD = $(UPTO_NET)
tests_property_test_net_equilibria_SOURCES = tests/property/test-net-equilibria.c
tests_property_test_net_equilibria_LDADD = $(UPTO_NET)
noinst_HEADERS += tests/net-random.h

NET_MOTION_TESTS = tests/reference/test-net-motion tests/reference/test-net-modes \
	tests/property/test-net-steps tests/property/test-net-error tests/property/test-net-cvode \
	tests/property/test-net-damping tests/extremes/test-net-motion-extremes \
	tests/property/test-net-eigen tests/property/test-net-symmetry
check_PROGRAMS += $(NET_MOTION_TESTS)
TESTS += $(NET_MOTION_TESTS)
tests_reference_test_net_motion_SOURCES = tests/reference/test-net-motion.c
tests_reference_test_net_motion_LDADD = $(UPTO_NET)
tests_reference_test_net_modes_SOURCES = tests/reference/test-net-modes.c
tests_reference_test_net_modes_LDADD = $(UPTO_NET)
tests_property_test_net_steps_SOURCES = tests/property/test-net-steps.c
tests_property_test_net_steps_LDADD = $(UPTO_NET)
tests_property_test_net_cvode_SOURCES = tests/property/test-net-cvode.c
tests_property_test_net_cvode_LDADD = $(UPTO_NET)
tests_extremes_test_net_motion_extremes_SOURCES = tests/extremes/test-net-motion-extremes.c
tests_extremes_test_net_motion_extremes_LDADD = $(UPTO_NET)
tests_property_test_net_damping_SOURCES = tests/property/test-net-damping.c
tests_property_test_net_damping_LDADD = $(UPTO_NET)
tests_property_test_net_error_SOURCES = tests/property/test-net-error.c
tests_property_test_net_error_LDADD = $(UPTO_NET)

NET_SPAN_TESTS = tests/property/test-net-span tests/property/test-net-span-modes
check_PROGRAMS += $(NET_SPAN_TESTS)
TESTS += $(NET_SPAN_TESTS)
tests_property_test_net_span_SOURCES = tests/property/test-net-span.c
tests_property_test_net_span_LDADD = $(UPTO_ROM)
tests_property_test_net_symmetry_SOURCES = tests/property/test-net-symmetry.c
tests_property_test_net_symmetry_LDADD = $(UPTO_NET)
tests_property_test_net_eigen_SOURCES = tests/property/test-net-eigen.c
tests_property_test_net_eigen_LDADD = $(UPTO_NET)
tests_property_test_net_span_modes_SOURCES = tests/property/test-net-span-modes.c
tests_property_test_net_span_modes_LDADD = $(UPTO_NET)

NET_IMPACT_TESTS = tests/property/test-net-impact-order
check_PROGRAMS += $(NET_IMPACT_TESTS)
TESTS += $(NET_IMPACT_TESTS)
tests_property_test_net_impact_order_SOURCES = tests/property/test-net-impact-order.c
tests_property_test_net_impact_order_LDADD = $(UPTO_NET)

NET_METHODS_TESTS = tests/property/test-net-methods
check_PROGRAMS += $(NET_METHODS_TESTS)
TESTS += $(NET_METHODS_TESTS)
tests_property_test_net_methods_SOURCES = tests/property/test-net-methods.c
tests_property_test_net_methods_LDADD = $(UPTO_NET)

NET_PROFILE_TESTS = tests/property/test-net-profile
check_PROGRAMS += $(NET_PROFILE_TESTS)
TESTS += $(NET_PROFILE_TESTS)
tests_property_test_net_profile_SOURCES = tests/property/test-net-profile.c
tests_property_test_net_profile_LDADD = $(UPTO_NET)
