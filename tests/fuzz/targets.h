#pragma once

// What a fuzz target is: a function that is called with any bytes. With clang's libFuzzer
// (`./meshgrade fuzz`) bytes are made up for as long as one likes; without it, replay_main.cpp
// feeds the kept corpus and mutations of it, in every run of the tests.

#include <cstddef>
#include <cstdint>

/// Reads the bytes as its target's kind of file. Whatever they are, the only exceptions that
/// leave a reader are those of its contract; all others end the program.
// NOLINTNEXTLINE(readability-identifier-naming): the name is libFuzzer's
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
