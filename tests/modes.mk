# tests of the modes stage
