/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * SimulatorInfo.h
 *
 *
 */

#ifndef PROCTOR_MODEL_SimulatorInfo_MODEL_H_
#define PROCTOR_MODEL_SimulatorInfo_MODEL_H_

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
///
/// </summary>
class SimulatorInfo
{
public:
    SimulatorInfo() = default;
    explicit SimulatorInfo(boost::json::value const& value);
    virtual ~SimulatorInfo() = default;

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
    /// SimulatorInfo members

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
    /// Named rendering quality, where there is one.
    /// </summary>
    std::string getQuality() const;
    void setQuality(std::string value);

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
    std::string m_Quality = "";
    bool m_QualityIsSet = false;
    ExtraJsonProperties m_extraJsonProperties;
};

std::string createJsonStringFromModelVector(const std::vector<std::shared_ptr<SimulatorInfo>>& data);

void createModelVectorFromJsonString(std::vector<std::shared_ptr<SimulatorInfo>>& vec, const std::string& json);

SimulatorInfo fromJsonValue_SimulatorInfo(boost::json::value const& value);

}
}
#endif /* PROCTOR_MODEL_SimulatorInfo_MODEL_H_ */
