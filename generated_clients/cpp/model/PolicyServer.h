/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * PolicyServer.h
 *
 * Where the server finds the policy of a run with mode &#x60;push&#x60;, and how it calls it.
 */

#ifndef PROCTOR_MODEL_PolicyServer_MODEL_H_
#define PROCTOR_MODEL_PolicyServer_MODEL_H_

#include "PolicyProtocol.h"
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
/// Where the server finds the policy of a run with mode &#x60;push&#x60;, and how it calls it.
/// </summary>
class PolicyServer
{
public:
    PolicyServer() = default;
    explicit PolicyServer(boost::json::value const& value);
    virtual ~PolicyServer() = default;

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
    /// PolicyServer members

    /// <summary>
    /// Base URL, without user, query or fragment; the path of an operation is appended to it.
    /// </summary>
    std::string getUrl() const;
    void setUrl(std::string value);

    /// <summary>
    ///
    /// </summary>
    PolicyProtocol getProtocol() const;
    void setProtocol(PolicyProtocol value);

    /// <summary>
    /// Sent as bearer token with every call, and shown to nobody.
    /// </summary>
    std::string getApiKey() const;
    void setApiKey(std::string value);

    /// <summary>
    /// Which model is asked, where a protocol knows several.
    /// </summary>
    std::string getModel() const;
    void setModel(std::string value);

    /// <summary>
    /// Time for one call, from connecting to the last byte of its answer; 30 when absent.
    /// </summary>
    double getCallTimeoutS() const;
    void setCallTimeoutS(double value);

    /// <summary>
    /// Most episodes played and calls made at a time; as many as the policy, the run and the server allow when absent.
    /// </summary>
    std::int32_t getMaxConcurrent() const;
    void setMaxConcurrent(std::int32_t value);

    /// <summary>
    /// How often a call that was not answered is repeated; 3 when absent.
    /// </summary>
    std::int32_t getMaxRetries() const;
    void setMaxRetries(std::int32_t value);

    /// <summary>
    /// Numbers that a chat completion is asked with, such as &#x60;temperature&#x60; and &#x60;max_tokens&#x60;; for &#x60;openai_chat&#x60; alone.
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
    std::string m_Api_key = "";
    bool m_Api_keyIsSet = false;
    std::string m_Model = "";
    bool m_ModelIsSet = false;
    double m_Call_timeout_s = 0.0;
    bool m_Call_timeout_sIsSet = false;
    std::int32_t m_Max_concurrent = 0;
    bool m_Max_concurrentIsSet = false;
    std::int32_t m_Max_retries = 0;
    bool m_Max_retriesIsSet = false;
    std::map<std::string, double> m_Generation;
    bool m_GenerationIsSet = false;
    ExtraJsonProperties m_extraJsonProperties;
};

std::string createJsonStringFromModelVector(const std::vector<std::shared_ptr<PolicyServer>>& data);

void createModelVectorFromJsonString(std::vector<std::shared_ptr<PolicyServer>>& vec, const std::string& json);

PolicyServer fromJsonValue_PolicyServer(boost::json::value const& value);

}
}
#endif /* PROCTOR_MODEL_PolicyServer_MODEL_H_ */
