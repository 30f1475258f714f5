# tests of nets
NET_TESTS = tests/reference/test-net tests/property/test-net-catenary
check_PROGRAMS += $(NET_TESTS)
TESTS += $(NET_TESTS)
tests_reference_test_net_SOURCES = tests/reference/test-net.c
tests_reference_test_net_LDADD = $(UPTO_NET)
tests_property_test_net_catenary_SOURCES = tests/property/test-net-catenary.c
tests_property_test_net_catenary_LDADD = $(UPTO_NET)
noinst_HEADERS += tests/net-random.h
