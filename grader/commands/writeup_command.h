#pragma once

namespace CLI {
class App;
}

namespace meshgrade {

/// Adds `meshgrade writeup`: the pictures that a course asks for, by the student's functions.
void add_writeup_command(CLI::App& app, int& exit_code);

}  // namespace meshgrade
