# tests of nets
NET_TESTS = tests/reference/test-net
check_PROGRAMS += $(NET_TESTS)
TESTS += $(NET_TESTS)
tests_reference_test_net_SOURCES = tests/reference/test-net.c
tests_reference_test_net_LDADD = $(UPTO_NET)
