/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * Interval.h
 *
 * 95 % interval.
 */

#ifndef PROCTOR_MODEL_Interval_MODEL_H_
#define PROCTOR_MODEL_Interval_MODEL_H_

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
/// 95 % interval.
/// </summary>
class Interval
{
public:
    Interval() = default;
    explicit Interval(boost::json::value const& value);
    virtual ~Interval() = default;

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
    /// Interval members

    /// <summary>
    ///
    /// </summary>
    double getLow() const;
    void setLow(double value);

    /// <summary>
    ///
    /// </summary>
    double getHigh() const;
    void setHigh(double value);

protected:
    //////////////////////////////////////
    // Override these for customization //
    //////////////////////////////////////

    virtual boost::json::object toJsonObject_internal() const;
    virtual void fromJsonObject_internal(boost::json::object const& object);
    virtual bool isKnownJsonProperty(boost::json::string_view name) const;


protected:
    double m_Low = 0.0;
    double m_High = 0.0;
    ExtraJsonProperties m_extraJsonProperties;
};

std::string createJsonStringFromModelVector(const std::vector<std::shared_ptr<Interval>>& data);

void createModelVectorFromJsonString(std::vector<std::shared_ptr<Interval>>& vec, const std::string& json);

Interval fromJsonValue_Interval(boost::json::value const& value);

}
}
#endif /* PROCTOR_MODEL_Interval_MODEL_H_ */
