/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * EpisodeStatus.h
 *
 *
 */

#ifndef PROCTOR_MODEL_EpisodeStatus_MODEL_H_
#define PROCTOR_MODEL_EpisodeStatus_MODEL_H_

#include <string>
#include <map>
#include <vector>
#include <utility>
#include <boost/json.hpp>
#include "ValidationTypes.h"

namespace proctor {
namespace model {

/// <summary>
///
/// </summary>
using EpisodeStatus = std::string;

boost::json::value toJsonValue_EpisodeStatus(EpisodeStatus const& value);
EpisodeStatus fromJsonValue_EpisodeStatus(boost::json::value const& value);


}
}

#endif /* PROCTOR_MODEL_EpisodeStatus_MODEL_H_ */
