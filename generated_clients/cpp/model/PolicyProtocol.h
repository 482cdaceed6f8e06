/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * PolicyProtocol.h
 *
 * &#x60;proctor&#x60; is policy.yaml. &#x60;openai_chat&#x60; asks for a chat completion at &#x60;chat/completions&#x60; below the URL, for benchmarks that are answered in words.
 */

#ifndef PROCTOR_MODEL_PolicyProtocol_MODEL_H_
#define PROCTOR_MODEL_PolicyProtocol_MODEL_H_

#include <string>
#include <map>
#include <vector>
#include <utility>
#include <boost/json.hpp>
#include "ValidationTypes.h"

namespace proctor {
namespace model {

/// <summary>
/// &#x60;proctor&#x60; is policy.yaml. &#x60;openai_chat&#x60; asks for a chat completion at &#x60;chat/completions&#x60; below the URL, for benchmarks that are answered in words.
/// </summary>
using PolicyProtocol = std::string;

boost::json::value toJsonValue_PolicyProtocol(PolicyProtocol const& value);
PolicyProtocol fromJsonValue_PolicyProtocol(boost::json::value const& value);


}
}

#endif /* PROCTOR_MODEL_PolicyProtocol_MODEL_H_ */
