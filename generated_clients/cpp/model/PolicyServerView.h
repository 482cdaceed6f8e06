/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * PolicyServerView.h
 *
 * The policy server of a run with mode &#x60;push&#x60;, with what was left open filled in, and without its key.
 */

#ifndef PROCTOR_MODEL_PolicyServerView_MODEL_H_
#define PROCTOR_MODEL_PolicyServerView_MODEL_H_

#include "PolicyProtocol.h"
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
/// The policy server of a run with mode &#x60;push&#x60;, with what was left open filled in, and without its key.
/// </summary>
class PolicyServerView
{
public:
    PolicyServerView() = default;
    explicit PolicyServerView(boost::json::value const& value);
    virtual ~PolicyServerView() = default;

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
    /// PolicyServerView members

    /// <summary>
    ///
    /// </summary>
    std::string getUrl() const;
    void setUrl(std::string value);

    /// <summary>
    ///
    /// </summary>
    PolicyProtocol getProtocol() const;
    void setProtocol(PolicyProtocol value);

    /// <summary>
    ///
    /// </summary>
    bool isHasApiKey() const;
    void setHasApiKey(bool value);

    /// <summary>
    ///
    /// </summary>
    std::string getModel() const;
    void setModel(std::string value);

    /// <summary>
    ///
    /// </summary>
    double getCallTimeoutS() const;
    void setCallTimeoutS(double value);

    /// <summary>
    ///
    /// </summary>
    std::int32_t getMaxConcurrent() const;
    void setMaxConcurrent(std::int32_t value);

    /// <summary>
    ///
    /// </summary>
    std::int32_t getMaxRetries() const;
    void setMaxRetries(std::int32_t value);

    /// <summary>
    ///
    /// </summary>
    std::map<std::string, double> getGeneration() const;
    void setGeneration(std::map<std::string, double> value);

protected:
    //////////////////////////////////////
    // Override these for customization //
    //////////////////////////////////////

    virtual boost::json::object toJsonObject_internal() const;
    virtual void fromJsonObject_internal(boost::json::object const& object);
    virtual bool isKnownJsonProperty(boost::json::string_view name) const;


protected:
    std::string m_Url = "";
    PolicyProtocol m_Protocol;
    bool m_Has_api_key = false;
    std::string m_Model = "";
    bool m_ModelIsSet = false;
    double m_Call_timeout_s = 0.0;
    std::int32_t m_Max_concurrent = 0;
    std::int32_t m_Max_retries = 0;
    std::map<std::string, double> m_Generation;
    bool m_GenerationIsSet = false;
    ExtraJsonProperties m_extraJsonProperties;
};

std::string createJsonStringFromModelVector(const std::vector<std::shared_ptr<PolicyServerView>>& data);

void createModelVectorFromJsonString(std::vector<std::shared_ptr<PolicyServerView>>& vec, const std::string& json);

PolicyServerView fromJsonValue_PolicyServerView(boost::json::value const& value);

}
}
#endif /* PROCTOR_MODEL_PolicyServerView_MODEL_H_ */
