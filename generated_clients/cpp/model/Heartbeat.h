/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * Heartbeat.h
 *
 *
 */

#ifndef PROCTOR_MODEL_Heartbeat_MODEL_H_
#define PROCTOR_MODEL_Heartbeat_MODEL_H_

#include <string>
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
class Heartbeat
{
public:
    Heartbeat() = default;
    explicit Heartbeat(boost::json::value const& value);
    virtual ~Heartbeat() = default;

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
    /// Heartbeat members

    /// <summary>
    ///
    /// </summary>
    std::string getSessionId() const;
    void setSessionId(std::string value);

protected:
    //////////////////////////////////////
    // Override these for customization //
    //////////////////////////////////////

    virtual boost::json::object toJsonObject_internal() const;
    virtual void fromJsonObject_internal(boost::json::object const& object);
    virtual bool isKnownJsonProperty(boost::json::string_view name) const;


protected:
    std::string m_Session_id = "";
    ExtraJsonProperties m_extraJsonProperties;
};

std::string createJsonStringFromModelVector(const std::vector<std::shared_ptr<Heartbeat>>& data);

void createModelVectorFromJsonString(std::vector<std::shared_ptr<Heartbeat>>& vec, const std::string& json);

Heartbeat fromJsonValue_Heartbeat(boost::json::value const& value);

}
}
#endif /* PROCTOR_MODEL_Heartbeat_MODEL_H_ */
