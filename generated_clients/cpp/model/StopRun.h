/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * StopRun.h
 *
 *
 */

#ifndef PROCTOR_MODEL_StopRun_MODEL_H_
#define PROCTOR_MODEL_StopRun_MODEL_H_

#include <string>
#include "StopMode.h"
#include <map>
#include <vector>
#include <utility>
#include <memory>
#include <boost/json.hpp>
#include "NullableField.h"

namespace proctor {
namespace model {



/// <summary>
///
/// </summary>
class StopRun
{
public:
    StopRun() = default;
    explicit StopRun(boost::json::value const& value);
    virtual ~StopRun() = default;

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
    /// StopRun members

    /// <summary>
    ///
    /// </summary>
    StopMode getMode() const;
    void setMode(StopMode value);

protected:
    //////////////////////////////////////
    // Override these for customization //
    //////////////////////////////////////

    virtual boost::json::object toJsonObject_internal() const;
    virtual void fromJsonObject_internal(boost::json::object const& object);
    virtual bool isKnownJsonProperty(boost::json::string_view name) const;


protected:
    StopMode m_Mode;
    bool m_ModeIsSet = false;
    ExtraJsonProperties m_extraJsonProperties;
};

std::string createJsonStringFromModelVector(const std::vector<std::shared_ptr<StopRun>>& data);

void createModelVectorFromJsonString(std::vector<std::shared_ptr<StopRun>>& vec, const std::string& json);

StopRun fromJsonValue_StopRun(boost::json::value const& value);

}
}
#endif /* PROCTOR_MODEL_StopRun_MODEL_H_ */
