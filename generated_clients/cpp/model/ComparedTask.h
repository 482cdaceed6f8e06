/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * ComparedTask.h
 *
 *
 */

#ifndef PROCTOR_MODEL_ComparedTask_MODEL_H_
#define PROCTOR_MODEL_ComparedTask_MODEL_H_

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
class ComparedTask
{
public:
    ComparedTask() = default;
    explicit ComparedTask(boost::json::value const& value);
    virtual ~ComparedTask() = default;

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
    /// ComparedTask members

    /// <summary>
    ///
    /// </summary>
    std::int32_t getPaired() const;
    void setPaired(std::int32_t value);

    /// <summary>
    ///
    /// </summary>
    std::optional<double> getBaselineMean() const;
    void setBaselineMean(std::optional<double> value);

    /// <summary>
    ///
    /// </summary>
    std::optional<double> getMean() const;
    void setMean(std::optional<double> value);

    /// <summary>
    ///
    /// </summary>
    std::optional<double> getDifference() const;
    void setDifference(std::optional<double> value);

protected:
    //////////////////////////////////////
    // Override these for customization //
    //////////////////////////////////////

    virtual boost::json::object toJsonObject_internal() const;
    virtual void fromJsonObject_internal(boost::json::object const& object);
    virtual bool isKnownJsonProperty(boost::json::string_view name) const;


protected:
    std::int32_t m_Paired = 0;
    std::optional<double> m_Baseline_mean;
    std::optional<double> m_Mean;
    std::optional<double> m_Difference;
    ExtraJsonProperties m_extraJsonProperties;
};

std::string createJsonStringFromModelVector(const std::vector<std::shared_ptr<ComparedTask>>& data);

void createModelVectorFromJsonString(std::vector<std::shared_ptr<ComparedTask>>& vec, const std::string& json);

ComparedTask fromJsonValue_ComparedTask(boost::json::value const& value);

}
}
#endif /* PROCTOR_MODEL_ComparedTask_MODEL_H_ */
