/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * PolicyInfo.h
 *
 *
 */

#ifndef PROCTOR_MODEL_PolicyInfo_MODEL_H_
#define PROCTOR_MODEL_PolicyInfo_MODEL_H_

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
class PolicyInfo
{
public:
    PolicyInfo() = default;
    explicit PolicyInfo(boost::json::value const& value);
    virtual ~PolicyInfo() = default;

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
    /// PolicyInfo members

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
    std::string getSubmitter() const;
    void setSubmitter(std::string value);

    /// <summary>
    ///
    /// </summary>
    std::string getHomepage() const;
    void setHomepage(std::string value);

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
    std::string m_Submitter = "";
    bool m_SubmitterIsSet = false;
    std::string m_Homepage = "";
    bool m_HomepageIsSet = false;
    ExtraJsonProperties m_extraJsonProperties;
};

std::string createJsonStringFromModelVector(const std::vector<std::shared_ptr<PolicyInfo>>& data);

void createModelVectorFromJsonString(std::vector<std::shared_ptr<PolicyInfo>>& vec, const std::string& json);

PolicyInfo fromJsonValue_PolicyInfo(boost::json::value const& value);

}
}
#endif /* PROCTOR_MODEL_PolicyInfo_MODEL_H_ */
