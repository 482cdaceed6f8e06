/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * Fault.h
 *
 * The simulator broke; the episode began again, at no cost to the policy. Nothing of the chunk counts as executed.
 */

#ifndef PROCTOR_MODEL_Fault_MODEL_H_
#define PROCTOR_MODEL_Fault_MODEL_H_

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
/// The simulator broke; the episode began again, at no cost to the policy. Nothing of the chunk counts as executed.
/// </summary>
class Fault
{
public:
    Fault() = default;
    explicit Fault(boost::json::value const& value);
    virtual ~Fault() = default;

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
    /// Fault members

    /// <summary>
    ///
    /// </summary>
    std::string getEpisodeId() const;
    void setEpisodeId(std::string value);

    /// <summary>
    /// Faults of this episode so far.
    /// </summary>
    std::int32_t getFaults() const;
    void setFaults(std::int32_t value);

    /// <summary>
    ///
    /// </summary>
    std::string getDetail() const;
    void setDetail(std::string value);

protected:
    //////////////////////////////////////
    // Override these for customization //
    //////////////////////////////////////

    virtual boost::json::object toJsonObject_internal() const;
    virtual void fromJsonObject_internal(boost::json::object const& object);
    virtual bool isKnownJsonProperty(boost::json::string_view name) const;


protected:
    std::string m_Episode_id = "";
    std::int32_t m_Faults = 0;
    std::string m_Detail = "";
    ExtraJsonProperties m_extraJsonProperties;
};

std::string createJsonStringFromModelVector(const std::vector<std::shared_ptr<Fault>>& data);

void createModelVectorFromJsonString(std::vector<std::shared_ptr<Fault>>& vec, const std::string& json);

Fault fromJsonValue_Fault(boost::json::value const& value);

}
}
#endif /* PROCTOR_MODEL_Fault_MODEL_H_ */
