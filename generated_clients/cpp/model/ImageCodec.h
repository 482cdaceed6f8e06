/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * ImageCodec.h
 *
 *
 */

#ifndef PROCTOR_MODEL_ImageCodec_MODEL_H_
#define PROCTOR_MODEL_ImageCodec_MODEL_H_

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
using ImageCodec = std::string;

boost::json::value toJsonValue_ImageCodec(ImageCodec const& value);
ImageCodec fromJsonValue_ImageCodec(boost::json::value const& value);


}
}

#endif /* PROCTOR_MODEL_ImageCodec_MODEL_H_ */
