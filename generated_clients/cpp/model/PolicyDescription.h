/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * PolicyDescription.h
 *
 * What a policy server says of itself; see policy.yaml.
 */

#ifndef PROCTOR_MODEL_PolicyDescription_MODEL_H_
#define PROCTOR_MODEL_PolicyDescription_MODEL_H_

#include "ProtocolRange.h"
#include <string>
#include <map>
#include <vector>
#include "Assumptions.h"
#include "AnyType.h"
#include <utility>
#include <memory>
#include <boost/json.hpp>
#include "NullableField.h"

namespace proctor {
namespace model {



/// <summary>
/// What a policy server says of itself; see policy.yaml.
/// </summary>
class PolicyDescription
{
public:
    PolicyDescription() = default;
    explicit PolicyDescription(boost::json::value const& value);
    virtual ~PolicyDescription() = default;

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
    /// PolicyDescription members

    /// <summary>
    ///
    /// </summary>
    std::string getName() const;
    void setName(std::string value);

    /// <summary>
    ///
    /// </summary>
    std::string getVersion() const;
    void setVersion(std::string value);

    /// <summary>
    ///
    /// </summary>
    ProtocolRange getProtocol() const;
    void setProtocol(ProtocolRange value);

    /// <summary>
    /// Most episodes that it plays at a time.
    /// </summary>
    std::int32_t getMaxSessions() const;
    void setMaxSessions(std::int32_t value);

    /// <summary>
    ///
    /// </summary>
    Assumptions getAssumes() const;
    void setAssumes(Assumptions value);

protected:
    //////////////////////////////////////
    // Override these for customization //
    //////////////////////////////////////

    virtual boost::json::object toJsonObject_internal() const;
    virtual void fromJsonObject_internal(boost::json::object const& object);
    virtual bool isKnownJsonProperty(boost::json::string_view name) const;


protected:
    std::string m_Name = "";
    std::string m_Version = "";
    bool m_VersionIsSet = false;
    ProtocolRange m_Protocol;
    std::int32_t m_Max_sessions = 0;
    Assumptions m_Assumes;
    bool m_AssumesIsSet = false;
    ExtraJsonProperties m_extraJsonProperties;
};

std::string createJsonStringFromModelVector(const std::vector<std::shared_ptr<PolicyDescription>>& data);

void createModelVectorFromJsonString(std::vector<std::shared_ptr<PolicyDescription>>& vec, const std::string& json);

PolicyDescription fromJsonValue_PolicyDescription(boost::json::value const& value);

}
}
#endif /* PROCTOR_MODEL_PolicyDescription_MODEL_H_ */
