/* The exceptions of this library; every message says what happened and what to do.
 *
 * A refusal of the server and an error found here have the same class, with the members of
 * the specification's schema Problem.
 */
#pragma once

#include <optional>
#include <stdexcept>
#include <string>

#include "models.h"

namespace proctor {

/// A request was refused, could not be sent, or would be refused if it were sent.
struct Error : std::runtime_error {
    /// code: one of the specification's, or `unreachable`, `bad_answer`, `run_failed`, `run_stopped`.
    Error(std::string const& code, std::string const& detail, bool retryable = false, std::string side_effects = "none");
    /// A refusal; retry_after_s is 0 without a Retry-After.
    Error(Problem const& why, long status, double retry_after_s);

    /// The same error with one more sentence.
    Error explained(std::string const& more) const;

    std::string code;
    std::string detail;       ///< What happened and what to do about it.
    bool retryable;           ///< Whether the same request can succeed later.
    std::string side_effects; ///< `possible` when the request may have been carried out.
    long status = 0;          ///< Of HTTP; 0 without an answer.
    double retry_after_s = 0;
    std::optional<Problem> problem{}; ///< As the server sent it.
};

/// What to call to go on with a run, as a part of a sentence.
std::string how_to_resume(std::string const& run_id);

/// The run is `failed`; `retryable`: whether it may be resumed.
struct RunFailed : Error {
    explicit RunFailed(Run const& run);
};

/// The run was stopped during the evaluation.
struct RunStopped : Error {
    explicit RunStopped(Run const& run);
};

/// The caller's StopSignal ended a wait. The run remains on the server.
struct Interrupted : std::runtime_error {
    Interrupted() : std::runtime_error("the evaluation was interrupted") {}
};

} // namespace proctor
