# tests of the scene stage
