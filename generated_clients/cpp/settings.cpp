/* Written by hand, beside what is generated from the specification. */


#include "settings.h"

#include <regex>
#include <utility>
#include <vector>

namespace proctor {
namespace {

using Pairs = std::vector<std::pair<std::string, std::string>>;

Pairs const quotes{ {"\"", "\""}, {"'", "'"}, {"`", "`"}, {"\u201c", "\u201d"}, {"\u2018", "\u2019"} };
/// Invisible characters beside those of ASCII: byte order mark, spaces, marks of direction.
std::vector<std::string> const invisible{
    "\ufeff", "\u00a0", "\u00ad", "\u200b", "\u200c", "\u200d", "\u200e", "\u200f", "\u2028", "\u2029", "\u202f", "\u2060", "\u3000",
};
std::regex const place_of("^https?://([^/?#]*)", std::regex::icase);

bool begins(std::string const& text, std::size_t at, std::string const& part) { return text.compare(at, part.size(), part) == 0; }

/// The bytes of the invisible character that begins here, or 0.
std::size_t invisible_at(std::string const& text, std::size_t at) {
    auto const byte = static_cast<unsigned char>(text[at]);
    if (byte <= ' ' || byte == 0x7f) return 1;
    for (auto const& one : invisible)
        if (begins(text, at, one)) return one.size();
    return 0;
}

std::string trimmed(std::string text) {
    for (bool changed = true; changed;) {
        std::size_t const whole = text.size();
        while (!text.empty() && invisible_at(text, 0)) text.erase(0, invisible_at(text, 0));
        for (std::size_t at = text.size(); at-- > 0 && text.size() - at <= 3;)
            if (at + invisible_at(text, at) == text.size() && invisible_at(text, at)) text.erase(at);
        for (auto const& [open, close] : quotes)
            if (text.size() >= open.size() + close.size() && begins(text, 0, open) && begins(text, text.size() - close.size(), close))
                text = text.substr(open.size(), text.size() - open.size() - close.size());
        changed = text.size() != whole;
    }
    return text;
}

std::string fault_of(std::string const& url, std::string const& place) {
    auto const has = [&](char const* any) { return place.find_first_of(any) != std::string::npos; };
    if (has("@")) return "has a user or a password, which no request would carry: a server is given a token";
    if (has("%"))
        return "names a network interface (a zone id, behind %), which only this machine knows: use another address, or the name of the server";
    if (place.find(':') != place.rfind(':') && place[0] != '[') return "has an IPv6 address without brackets: write http://[::1]:8460";
    if (url.find_first_of("?#") != std::string::npos) return "ends with a query: give the part before the ? or #";
    static std::regex const host("(\\[[0-9A-Fa-f:.]+\\]|[^\\[\\]:]+)(:[0-9]{1,5})?");
    if (!std::regex_match(place, host)) return "has an invalid host or port";
    for (std::size_t at = 0; at < url.size(); ++at)
        if (invisible_at(url, at)) return "has a space or an invisible character in it";
    return "";
}

} // namespace

std::string clean_token(std::string const& text) {
    static std::regex const scheme("^(authorization:\\s*)?bearer\\s+", std::regex::icase);
    auto const token = std::regex_replace(trimmed(text), scheme, "", std::regex_constants::format_first_only);
    for (std::size_t at = 0; at < token.size(); ++at) {
        if (token[at] >= '!' && token[at] <= '~') continue;
        auto const what = token[at] == ' ' ? "a space" : invisible_at(token, at) ? "an invisible character" : "a character that is not ASCII";
        throw BadSetting(std::string("the token has ") + what + " at byte " + std::to_string(at + 1) + " of " + std::to_string(token.size()) +
                         ": copy it again, as it was printed");
    }
    return token;
}

std::string clean_base_url(std::string const& text) {
    auto url = trimmed(text);
    while (!url.empty() && url.back() == '/') url.pop_back();
    std::smatch match;
    if (!std::regex_search(url, match, place_of))
        throw BadSetting("the base URL must be like http://127.0.0.1:8460 or https://robots.example/path");
    if (auto const fault = fault_of(url, match[1]); !fault.empty()) throw BadSetting("the base URL " + fault);
    return url;
}

bool is_this_machine(std::string const& url) {
    static std::regex const loopback("^https?://(localhost|127\\.[0-9.]+|\\[::1\\])(:[0-9]+)?(/.*)?$", std::regex::icase);
    return std::regex_match(url, loopback);
}

} // namespace proctor
