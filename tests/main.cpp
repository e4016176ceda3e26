#define CATCH_CONFIG_RUNNER  // in version 2 this compiles Catch itself: slow, therefore once, here
#include "catch.hpp"

int main(int argc, char** argv) { return Catch::Session().run(argc, argv); }
