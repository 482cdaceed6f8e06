/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * GroupScore.h
 *
 *
 */

#ifndef PROCTOR_MODEL_GroupScore_MODEL_H_
#define PROCTOR_MODEL_GroupScore_MODEL_H_

#include <string>
#include <map>
#include <vector>
#include "AnyType.h"
#include "OutcomeCounts.h"
#include <utility>
#include <memory>
#include <boost/json.hpp>
#include "NullableField.h"

namespace proctor {
namespace model {



/// <summary>
///
/// </summary>
class GroupScore
{
public:
    GroupScore() = default;
    explicit GroupScore(boost::json::value const& value);
    virtual ~GroupScore() = default;

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
    /// GroupScore members

    /// <summary>
    ///
    /// </summary>
    OutcomeCounts getCounts() const;
    void setCounts(OutcomeCounts value);

    /// <summary>
    ///
    /// </summary>
    std::optional<double> getMean() const;
    void setMean(std::optional<double> value);

    /// <summary>
    ///
    /// </summary>
    std::optional<double> getSuccessRate() const;
    void setSuccessRate(std::optional<double> value);

protected:
    //////////////////////////////////////
    // Override these for customization //
    //////////////////////////////////////

    virtual boost::json::object toJsonObject_internal() const;
    virtual void fromJsonObject_internal(boost::json::object const& object);
    virtual bool isKnownJsonProperty(boost::json::string_view name) const;


protected:
    OutcomeCounts m_Counts;
    std::optional<double> m_Mean;
    std::optional<double> m_Success_rate;
    ExtraJsonProperties m_extraJsonProperties;
};

std::string createJsonStringFromModelVector(const std::vector<std::shared_ptr<GroupScore>>& data);

void createModelVectorFromJsonString(std::vector<std::shared_ptr<GroupScore>>& vec, const std::string& json);

GroupScore fromJsonValue_GroupScore(boost::json::value const& value);

}
}
#endif /* PROCTOR_MODEL_GroupScore_MODEL_H_ */
