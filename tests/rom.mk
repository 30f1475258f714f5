# tests of the rom stage
