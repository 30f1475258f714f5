# tests of the response stage
