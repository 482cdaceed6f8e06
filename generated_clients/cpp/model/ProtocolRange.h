/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * ProtocolRange.h
 *
 *
 */

#ifndef PROCTOR_MODEL_ProtocolRange_MODEL_H_
#define PROCTOR_MODEL_ProtocolRange_MODEL_H_

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
class ProtocolRange
{
public:
    ProtocolRange() = default;
    explicit ProtocolRange(boost::json::value const& value);
    virtual ~ProtocolRange() = default;

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
    /// ProtocolRange members

    /// <summary>
    ///
    /// </summary>
    std::string getMin() const;
    void setMin(std::string value);

    /// <summary>
    ///
    /// </summary>
    std::string getMax() const;
    void setMax(std::string value);

protected:
    //////////////////////////////////////
    // Override these for customization //
    //////////////////////////////////////

    virtual boost::json::object toJsonObject_internal() const;
    virtual void fromJsonObject_internal(boost::json::object const& object);
    virtual bool isKnownJsonProperty(boost::json::string_view name) const;


protected:
    std::string m_Min = "";
    std::string m_Max = "";
    ExtraJsonProperties m_extraJsonProperties;
};

std::string createJsonStringFromModelVector(const std::vector<std::shared_ptr<ProtocolRange>>& data);

void createModelVectorFromJsonString(std::vector<std::shared_ptr<ProtocolRange>>& vec, const std::string& json);

ProtocolRange fromJsonValue_ProtocolRange(boost::json::value const& value);

}
}
#endif /* PROCTOR_MODEL_ProtocolRange_MODEL_H_ */
