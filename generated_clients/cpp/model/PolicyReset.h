/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * PolicyReset.h
 *
 * The policy is ready for this attempt and no other.
 */

#ifndef PROCTOR_MODEL_PolicyReset_MODEL_H_
#define PROCTOR_MODEL_PolicyReset_MODEL_H_

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
/// The policy is ready for this attempt and no other.
/// </summary>
class PolicyReset
{
public:
    PolicyReset() = default;
    explicit PolicyReset(boost::json::value const& value);
    virtual ~PolicyReset() = default;

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
    /// PolicyReset members

    /// <summary>
    ///
    /// </summary>
    std::string getSessionId() const;
    void setSessionId(std::string value);

    /// <summary>
    ///
    /// </summary>
    std::string getEpisodeId() const;
    void setEpisodeId(std::string value);

    /// <summary>
    ///
    /// </summary>
    std::int32_t getAttempt() const;
    void setAttempt(std::int32_t value);

protected:
    //////////////////////////////////////
    // Override these for customization //
    //////////////////////////////////////

    virtual boost::json::object toJsonObject_internal() const;
    virtual void fromJsonObject_internal(boost::json::object const& object);
    virtual bool isKnownJsonProperty(boost::json::string_view name) const;


protected:
    std::string m_Session_id = "";
    std::string m_Episode_id = "";
    std::int32_t m_Attempt = 0;
    ExtraJsonProperties m_extraJsonProperties;
};

std::string createJsonStringFromModelVector(const std::vector<std::shared_ptr<PolicyReset>>& data);

void createModelVectorFromJsonString(std::vector<std::shared_ptr<PolicyReset>>& vec, const std::string& json);

PolicyReset fromJsonValue_PolicyReset(boost::json::value const& value);

}
}
#endif /* PROCTOR_MODEL_PolicyReset_MODEL_H_ */
