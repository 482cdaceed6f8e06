#include "proctor/error.h"

#include <cstdio>
#include <map>

namespace proctor {
namespace {

/// What helps in this library, beside the words of the server.
std::map<std::string, std::string> const hints{
    {"unauthenticated", " In this library: Server::token."},
    {"worker_busy", " In this library: EvaluateOptions::takeover."},
    {"session_superseded", " In this library: EvaluateOptions::takeover and resume_evaluation."},
};

/// With an escape for each control character but tab and line feed: they act in a terminal.
std::string printable(std::string const& text) {
    std::string shown;
    for (std::size_t i = 0; i < text.size(); ++i) {
        auto const byte = static_cast<unsigned char>(text[i]);
        auto const next = i + 1 < text.size() ? static_cast<unsigned char>(text[i + 1]) : 0;
        bool const is_c1 = byte == 0xc2 && next >= 0x80 && next <= 0x9f;
        bool const acts = (byte < 0x20 && byte != '\t' && byte != '\n') || byte == 0x7f;
        if (!acts && !is_c1) {
            shown += text[i];
            continue;
        }
        char escape[5];
        std::snprintf(escape, sizeof escape, "\\x%02x", is_c1 ? next : byte);
        shown += escape;
        i += is_c1;
    }
    return shown;
}

std::string with_hint(Problem const& why) {
    auto const hint = hints.find(why.code);
    return hint == hints.end() ? why.detail : why.detail + hint->second;
}

/// The message: detail and code, then each member that is wrong.
std::string message(Problem const& why) {
    std::string text = with_hint(why) + " [" + why.code + "]";
    if (why.errors)
        for (auto const& item : *why.errors) text += "\n  " + item.pointer + ": " + item.detail;
    return printable(text);
}

std::string kept(Run const& run) {
    return " Scored episodes are kept; " + how_to_resume(run.run_id) + ".";
}

} // namespace

std::string how_to_resume(std::string const& run_id) {
    return "resume_evaluation(server, \"" + run_id + "\", policy) continues it";
}

Error::Error(std::string const& code, std::string const& detail, bool retryable, std::string side_effects)
    : std::runtime_error(printable(detail + " [" + code + "]")), code(printable(code)), detail(printable(detail)),
      retryable(retryable), side_effects(std::move(side_effects)) {}

Error::Error(Problem const& why, long status, double retry_after_s)
    : std::runtime_error(message(why)), code(printable(why.code)), detail(printable(with_hint(why))), retryable(why.retryable),
      side_effects(why.side_effects), status(status), retry_after_s(retry_after_s), problem(why) {}

Error Error::explained(std::string const& more) const {
    if (!problem) return Error(code, detail + more, retryable, side_effects);
    auto why = *problem;
    why.detail += more;
    return Error(why, status, retry_after_s);
}

RunFailed::RunFailed(Run const& run)
    : Error("run_failed",
            "Run " + run.run_id + " failed: " + run.reason.value_or("") +
                (run.retryable.value_or(false) ? kept(run) : " It cannot be resumed."),
            run.retryable.value_or(false)) {}

RunStopped::RunStopped(Run const& run)
    : Error("run_stopped", "Run " + run.run_id + " is stopped: " + run.reason.value_or("") + kept(run), true) {}

} // namespace proctor
