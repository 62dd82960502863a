// What a shell needs to complete verbs and options, from the same tables as --help.
#pragma once

#include <string>

namespace goniolux::app {

/// The script for "bash", "zsh" or "fish". Throws core::InputError (rule "usage") for another shell.
std::string completionFor(const std::string& shell);

}  // namespace goniolux::app
