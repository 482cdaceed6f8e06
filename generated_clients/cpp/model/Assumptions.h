/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * Assumptions.h
 *
 * What the policy takes for granted; refused when the benchmark says otherwise.
 */

#ifndef PROCTOR_MODEL_Assumptions_MODEL_H_
#define PROCTOR_MODEL_Assumptions_MODEL_H_

#include <string>
#include "Assumption.h"
#include <map>
#include <vector>
#include <utility>
#include <memory>
#include <boost/json.hpp>
#include "NullableField.h"

namespace proctor {
namespace model {



/// <summary>
/// What the policy takes for granted; refused when the benchmark says otherwise.
/// </summary>
class Assumptions
{
public:
    Assumptions() = default;
    explicit Assumptions(boost::json::value const& value);
    virtual ~Assumptions() = default;

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
    /// Assumptions members

    /// <summary>
    ///
    /// </summary>
    double getControlRateHz() const;
    void setControlRateHz(double value);

    /// <summary>
    ///
    /// </summary>
    std::map<std::string, Assumption> getAction() const;
    void setAction(std::map<std::string, Assumption> value);

    /// <summary>
    ///
    /// </summary>
    std::map<std::string, Assumption> getState() const;
    void setState(std::map<std::string, Assumption> value);

protected:
    //////////////////////////////////////
    // Override these for customization //
    //////////////////////////////////////

    virtual boost::json::object toJsonObject_internal() const;
    virtual void fromJsonObject_internal(boost::json::object const& object);
    virtual bool isKnownJsonProperty(boost::json::string_view name) const;


protected:
    double m_Control_rate_hz = 0.0;
    bool m_Control_rate_hzIsSet = false;
    std::map<std::string, Assumption> m_Action;
    bool m_ActionIsSet = false;
    std::map<std::string, Assumption> m_State;
    bool m_StateIsSet = false;
    ExtraJsonProperties m_extraJsonProperties;
};

std::string createJsonStringFromModelVector(const std::vector<std::shared_ptr<Assumptions>>& data);

void createModelVectorFromJsonString(std::vector<std::shared_ptr<Assumptions>>& vec, const std::string& json);

Assumptions fromJsonValue_Assumptions(boost::json::value const& value);

}
}
#endif /* PROCTOR_MODEL_Assumptions_MODEL_H_ */
