# tests of the stage scene
test_programs += tests/scene
tests_scene_SOURCES = tests/cases.c \
	tests/unit/test-scene-cases.c \
	tests/unit/test-scene-errors.c \
	tests/unit/test-scene-files.c \
	tests/unit/test-scene-fuzz.c \
	tests/unit/test-scene-property.c \
	tests/unit/test-scene-suggest.c \
	tests/unit/test-scene-units.c \
	tests/unit/test-scene.c \
	src/scene/page/example.c
nodist_tests_scene_SOURCES = tests/scene-cases.c
tests_scene_LDADD = $(UPTO_SCENE)
