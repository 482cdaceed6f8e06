/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * Timing.h
 *
 * Server time of this turn, in seconds.
 */

#ifndef PROCTOR_MODEL_Timing_MODEL_H_
#define PROCTOR_MODEL_Timing_MODEL_H_

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
/// Server time of this turn, in seconds.
/// </summary>
class Timing
{
public:
    Timing() = default;
    explicit Timing(boost::json::value const& value);
    virtual ~Timing() = default;

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
    /// Timing members

    /// <summary>
    ///
    /// </summary>
    double getTotalS() const;
    void setTotalS(double value);

    /// <summary>
    ///
    /// </summary>
    double getQueueS() const;
    void setQueueS(double value);

    /// <summary>
    ///
    /// </summary>
    double getSimulateS() const;
    void setSimulateS(double value);

    /// <summary>
    ///
    /// </summary>
    double getRenderS() const;
    void setRenderS(double value);

    /// <summary>
    /// Encoding of images.
    /// </summary>
    double getEncodeS() const;
    void setEncodeS(double value);

protected:
    //////////////////////////////////////
    // Override these for customization //
    //////////////////////////////////////

    virtual boost::json::object toJsonObject_internal() const;
    virtual void fromJsonObject_internal(boost::json::object const& object);
    virtual bool isKnownJsonProperty(boost::json::string_view name) const;


protected:
    double m_Total_s = 0.0;
    double m_Queue_s = 0.0;
    double m_Simulate_s = 0.0;
    double m_Render_s = 0.0;
    double m_Encode_s = 0.0;
    ExtraJsonProperties m_extraJsonProperties;
};

std::string createJsonStringFromModelVector(const std::vector<std::shared_ptr<Timing>>& data);

void createModelVectorFromJsonString(std::vector<std::shared_ptr<Timing>>& vec, const std::string& json);

Timing fromJsonValue_Timing(boost::json::value const& value);

}
}
#endif /* PROCTOR_MODEL_Timing_MODEL_H_ */
