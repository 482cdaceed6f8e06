/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * BenchmarkList.h
 *
 *
 */

#ifndef PROCTOR_MODEL_BenchmarkList_MODEL_H_
#define PROCTOR_MODEL_BenchmarkList_MODEL_H_

#include "BenchmarkSummary.h"
#include <string>
#include <map>
#include <vector>
#include "AnyType.h"
#include <utility>
#include <memory>
#include <boost/json.hpp>
#include "NullableField.h"

namespace proctor {
namespace model {



/// <summary>
///
/// </summary>
class BenchmarkList
{
public:
    BenchmarkList() = default;
    explicit BenchmarkList(boost::json::value const& value);
    virtual ~BenchmarkList() = default;

    std::string toJsonString(bool prettyJson = false) const;
    void fromJsonString(std::string const& jsonString);
    boost::json::value toJsonValue() const;
    void fromJsonValue(boost::json::value const& value);
    using ExtraJsonProperties = std::map<std::string, boost::json::value>;

    ExtraJsonProperties const& getExtraJsonProperties() const noexcept
    {
        return m_extraJsonProperties;
    }

    void setExtraJsonProperties(ExtraJsonProperties extraJsonProperties)
    {
        m_extraJsonProperties = std::move(extraJsonProperties);
    }

    /////////////////////////////////////////////
    /// BenchmarkList members

    /// <summary>
    ///
    /// </summary>
    std::vector<BenchmarkSummary> getBenchmarks() const;
    void setBenchmarks(std::vector<BenchmarkSummary> value);

protected:
    //////////////////////////////////////
    // Override these for customization //
    //////////////////////////////////////

    virtual boost::json::object toJsonObject_internal() const;
    virtual void fromJsonObject_internal(boost::json::object const& object);
    virtual bool isKnownJsonProperty(boost::json::string_view name) const;


protected:
    std::vector<BenchmarkSummary> m_Benchmarks;
    ExtraJsonProperties m_extraJsonProperties;
};

std::string createJsonStringFromModelVector(const std::vector<std::shared_ptr<BenchmarkList>>& data);

void createModelVectorFromJsonString(std::vector<std::shared_ptr<BenchmarkList>>& vec, const std::string& json);

BenchmarkList fromJsonValue_BenchmarkList(boost::json::value const& value);

}
}
#endif /* PROCTOR_MODEL_BenchmarkList_MODEL_H_ */
