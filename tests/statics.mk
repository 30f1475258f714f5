# tests of the statics stage
