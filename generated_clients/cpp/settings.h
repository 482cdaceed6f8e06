/* Written by hand, beside what is generated from the specification. */


/* The base URL and the token of a server: what copying adds to their ends is taken off, any other fault is refused. */
#pragma once

#include <stdexcept>
#include <string>

namespace proctor {

/// A setting that cannot be used. Nothing was sent; what() says what is wrong, and repeats no secret.
struct BadSetting : std::invalid_argument {
    using std::invalid_argument::invalid_argument;
};

/// The token without what editors, shells and web pages add to it. Throws BadSetting for what no header can carry.
std::string clean_token(std::string const& text);

/// The base URL without a slash at its end. Throws BadSetting.
std::string clean_base_url(std::string const& text);

/// Whether a base URL names this machine, which no proxy can reach.
bool is_this_machine(std::string const& url);

} // namespace proctor
