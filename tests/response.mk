# tests of the response stage: orbits and frequency response
RESPONSE_TESTS = tests/unit/test-floquet tests/unit/test-flow tests/unit/test-balance tests/unit/test-balance-blocks \
	tests/unit/test-frf-events \
	tests/unit/test-frf-vanish tests/unit/test-cover tests/unit/test-collide \
	tests/unit/test-monodromy tests/unit/test-varying tests/property/test-support tests/property/test-loads tests/property/test-frf tests/property/test-event-errors \
	tests/property/test-linear-condensed tests/unit/test-hill-matrix \
	tests/reference/test-frf-published tests/extremes/test-frf-extremes \
	tests/property/test-family tests/property/test-branches tests/property/test-whirling tests/property/test-mathieu-duffing tests/property/test-resonance tests/unit/test-folds tests/unit/test-locus tests/property/test-folds tests/property/test-folds-least tests/reference/test-folds \
	tests/extremes/test-folds-extremes tests/extremes/test-folds-memory
noinst_HEADERS += tests/folds-duffing.h
check_PROGRAMS += $(RESPONSE_TESTS)
TESTS += $(RESPONSE_TESTS)
tests_unit_test_floquet_SOURCES = tests/unit/test-floquet.c
tests_unit_test_floquet_LDADD = $(UPTO_RESPONSE)
tests_unit_test_collide_SOURCES = tests/unit/test-collide.c
tests_unit_test_collide_LDADD = $(UPTO_RESPONSE)
tests_unit_test_flow_SOURCES = tests/unit/test-flow.c
tests_unit_test_flow_LDADD = $(UPTO_RESPONSE)
tests_unit_test_monodromy_SOURCES = tests/unit/test-monodromy.c
tests_unit_test_monodromy_LDADD = $(UPTO_RESPONSE)
tests_property_test_loads_SOURCES = tests/property/test-loads.c
tests_property_test_loads_LDADD = $(UPTO_RESPONSE)
tests_property_test_support_SOURCES = tests/property/test-support.c
tests_property_test_support_LDADD = $(UPTO_RESPONSE)
tests_unit_test_varying_SOURCES = tests/unit/test-varying.c
tests_unit_test_varying_LDADD = $(UPTO_RESPONSE)
tests_unit_test_frf_events_SOURCES = tests/unit/test-frf-events.c
tests_unit_test_frf_events_LDADD = $(UPTO_RESPONSE)
tests_unit_test_cover_SOURCES = tests/unit/test-cover.c
tests_unit_test_cover_LDADD = $(UPTO_RESPONSE)
tests_unit_test_frf_vanish_SOURCES = tests/unit/test-frf-vanish.c
tests_unit_test_frf_vanish_LDADD = $(UPTO_RESPONSE)
tests_unit_test_balance_SOURCES = tests/unit/test-balance.c
tests_unit_test_balance_blocks_SOURCES = tests/unit/test-balance-blocks.c
tests_unit_test_balance_LDADD = $(UPTO_RESPONSE)
tests_unit_test_balance_blocks_LDADD = $(UPTO_RESPONSE)
tests_unit_test_hill_matrix_SOURCES = tests/unit/test-hill-matrix.c
tests_unit_test_hill_matrix_LDADD = $(UPTO_RESPONSE)
tests_property_test_linear_condensed_SOURCES = tests/property/test-linear-condensed.c
tests_property_test_linear_condensed_LDADD = $(UPTO_RESPONSE)
tests_property_test_event_errors_SOURCES = tests/property/test-event-errors.c
tests_property_test_event_errors_LDADD = $(UPTO_RESPONSE)
tests_property_test_frf_SOURCES = tests/property/test-frf.c
tests_property_test_frf_LDADD = $(UPTO_RESPONSE)
tests_reference_test_frf_published_SOURCES = tests/reference/test-frf-published.c
tests_reference_test_frf_published_LDADD = $(UPTO_RESPONSE)
tests_extremes_test_frf_extremes_SOURCES = tests/extremes/test-frf-extremes.c
tests_extremes_test_frf_extremes_LDADD = $(UPTO_RESPONSE)
tests_unit_test_folds_SOURCES = tests/unit/test-folds.c
tests_unit_test_folds_LDADD = $(UPTO_RESPONSE)
tests_unit_test_locus_SOURCES = tests/unit/test-locus.c
tests_unit_test_locus_LDADD = $(UPTO_RESPONSE)
tests_property_test_resonance_SOURCES = tests/property/test-resonance.c
tests_property_test_resonance_LDADD = $(UPTO_RESPONSE)
tests_property_test_mathieu_duffing_SOURCES = tests/property/test-mathieu-duffing.c
tests_property_test_mathieu_duffing_LDADD = $(UPTO_RESPONSE)
tests_property_test_whirling_SOURCES = tests/property/test-whirling.c
tests_property_test_whirling_LDADD = $(UPTO_RESPONSE)
tests_property_test_branches_SOURCES = tests/property/test-branches.c
tests_property_test_branches_LDADD = $(UPTO_RESPONSE)
tests_property_test_family_SOURCES = tests/property/test-family.c
tests_property_test_family_LDADD = $(UPTO_STUDY)
tests_property_test_folds_SOURCES = tests/property/test-folds.c
tests_property_test_folds_LDADD = $(UPTO_RESPONSE)
tests_property_test_folds_least_SOURCES = tests/property/test-folds-least.c
tests_property_test_folds_least_LDADD = $(UPTO_RESPONSE)
tests_reference_test_folds_SOURCES = tests/reference/test-folds.c
tests_reference_test_folds_LDADD = $(UPTO_RESPONSE)
tests_extremes_test_folds_extremes_SOURCES = tests/extremes/test-folds-extremes.c
tests_extremes_test_folds_extremes_LDADD = $(UPTO_RESPONSE)
tests_extremes_test_folds_memory_SOURCES = tests/extremes/test-folds-memory.c
tests_extremes_test_folds_memory_LDADD = $(UPTO_RESPONSE)
EXTRA_DIST += tests/reference/absorber.json tests/reference/frf-cases.txt tests/reference/duffing-nlvib-01.json \
	tests/reference/pair-2to1.json tests/reference/springs-nlvib-06-f1e-3.json \
	tests/reference/springs-nlvib-06-f3e-3.json tests/reference/pair-quintic.json
check_PROGRAMS += tests/property/test-frf-full
TESTS += tests/property/test-frf-full
tests_property_test_frf_full_SOURCES = tests/property/test-frf-full.c
tests_property_test_frf_full_LDADD = $(UPTO_RESPONSE)
check_PROGRAMS += tests/property/test-drag
TESTS += tests/property/test-drag
tests_property_test_drag_SOURCES = tests/property/test-drag.c
tests_property_test_drag_LDADD = $(UPTO_RESPONSE)
check_PROGRAMS += tests/property/test-undamped
TESTS += tests/property/test-undamped
tests_property_test_undamped_SOURCES = tests/property/test-undamped.c
tests_property_test_undamped_LDADD = $(UPTO_RESPONSE)
check_PROGRAMS += tests/property/test-travel-motion
TESTS += tests/property/test-travel-motion
tests_property_test_travel_motion_SOURCES = tests/property/test-travel-motion.c
tests_property_test_travel_motion_LDADD = $(UPTO_RESPONSE) $(GSL_LIBS)

SCALES_TESTS = tests/property/test-scales tests/property/test-backbone tests/property/test-nnm tests/property/test-nnm-whirl
check_PROGRAMS += $(SCALES_TESTS)
TESTS += $(SCALES_TESTS)
tests_property_test_scales_SOURCES = tests/property/test-scales.c
tests_property_test_scales_LDADD = $(UPTO_RESPONSE)
tests_property_test_nnm_SOURCES = tests/property/test-nnm.c
tests_property_test_nnm_whirl_SOURCES = tests/property/test-nnm-whirl.c
tests_property_test_nnm_whirl_LDADD = $(UPTO_RESPONSE) $(GSL_LIBS)
tests_property_test_nnm_LDADD = $(UPTO_RESPONSE)
tests_property_test_backbone_SOURCES = tests/property/test-backbone.c
tests_property_test_backbone_LDADD = $(UPTO_RESPONSE)

check_PROGRAMS += tests/unit/test-guards-response
TESTS += tests/unit/test-guards-response
tests_unit_test_guards_response_SOURCES = tests/unit/test-guards-response.c
tests_unit_test_guards_response_LDADD = $(UPTO_RESPONSE)

check_PROGRAMS += tests/property/test-combined
TESTS += tests/property/test-combined
tests_property_test_combined_SOURCES = tests/property/test-combined.c tests/lumped-chain.h
tests_property_test_combined_LDADD = $(UPTO_RESPONSE)

check_PROGRAMS += tests/property/test-own
TESTS += tests/property/test-own
tests_property_test_own_SOURCES = tests/property/test-own.c
tests_property_test_own_LDADD = $(UPTO_RESPONSE)

check_PROGRAMS += tests/property/test-balance-terms
TESTS += tests/property/test-balance-terms
tests_property_test_balance_terms_SOURCES = tests/property/test-balance-terms.c
tests_property_test_balance_terms_LDADD = $(UPTO_RESPONSE)

check_PROGRAMS += tests/property/test-plugin
TESTS += tests/property/test-plugin
tests_property_test_plugin_SOURCES = tests/property/test-plugin.c
tests_property_test_plugin_LDADD = $(UPTO_RESPONSE)

check_PROGRAMS += tests/reference/test-feigenbaum
TESTS += tests/reference/test-feigenbaum
tests_reference_test_feigenbaum_SOURCES = tests/reference/test-feigenbaum.c
tests_reference_test_feigenbaum_LDADD = $(UPTO_RESPONSE)

check_PROGRAMS += tests/property/test-normal-form
TESTS += tests/property/test-normal-form
tests_property_test_normal_form_SOURCES = tests/property/test-normal-form.c
tests_property_test_normal_form_LDADD = $(UPTO_RESPONSE)
