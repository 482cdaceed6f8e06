/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * SessionEnd.h
 *
 * What ended the session, as far as the server still knows; &#x60;unknown&#x60; after a restart, and for a session that was taken over and whose successor has ended.
 */

#ifndef PROCTOR_MODEL_SessionEnd_MODEL_H_
#define PROCTOR_MODEL_SessionEnd_MODEL_H_

#include <string>
#include <map>
#include <vector>
#include <utility>
#include <boost/json.hpp>
#include "ValidationTypes.h"

namespace proctor {
namespace model {

/// <summary>
/// What ended the session, as far as the server still knows; &#x60;unknown&#x60; after a restart, and for a session that was taken over and whose successor has ended.
/// </summary>
using SessionEnd = std::string;

boost::json::value toJsonValue_SessionEnd(SessionEnd const& value);
SessionEnd fromJsonValue_SessionEnd(boost::json::value const& value);


}
}

#endif /* PROCTOR_MODEL_SessionEnd_MODEL_H_ */
