# tests of the scene stage
SCENE_TESTS = tests/unit/test-scene tests/unit/test-scene-errors tests/unit/test-scene-files \
	tests/unit/test-scene-fuzz tests/unit/test-scene-property \
	tests/unit/test-scene-suggest tests/unit/test-scene-units
check_PROGRAMS += $(SCENE_TESTS)
TESTS += $(SCENE_TESTS)
noinst_HEADERS += tests/unit/scene-text.h
tests_unit_test_scene_SOURCES = tests/unit/test-scene.c src/scene/example.c
tests_unit_test_scene_LDADD = $(UPTO_SCENE)
tests_unit_test_scene_errors_SOURCES = tests/unit/test-scene-errors.c
tests_unit_test_scene_errors_LDADD = $(UPTO_SCENE)
tests_unit_test_scene_files_SOURCES = tests/unit/test-scene-files.c
tests_unit_test_scene_files_LDADD = $(UPTO_SCENE)
tests_unit_test_scene_fuzz_SOURCES = tests/unit/test-scene-fuzz.c
tests_unit_test_scene_fuzz_LDADD = $(UPTO_SCENE)
tests_unit_test_scene_property_SOURCES = tests/unit/test-scene-property.c
tests_unit_test_scene_property_LDADD = $(UPTO_SCENE)
tests_unit_test_scene_suggest_SOURCES = tests/unit/test-scene-suggest.c
tests_unit_test_scene_suggest_LDADD = $(UPTO_SCENE)
tests_unit_test_scene_units_SOURCES = tests/unit/test-scene-units.c
tests_unit_test_scene_units_LDADD = $(UPTO_SCENE)

check_PROGRAMS += tests/unit/test-scene-cases
TESTS += tests/unit/test-scene-cases
tests_unit_test_scene_cases_SOURCES = tests/unit/test-scene-cases.c
tests_unit_test_scene_cases_LDADD = $(UPTO_SCENE)
