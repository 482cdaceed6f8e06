/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * Limits.h
 *
 *
 */

#ifndef PROCTOR_MODEL_Limits_MODEL_H_
#define PROCTOR_MODEL_Limits_MODEL_H_

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
class Limits
{
public:
    Limits() = default;
    explicit Limits(boost::json::value const& value);
    virtual ~Limits() = default;

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
    /// Limits members

    /// <summary>
    /// Longest request body that is read.
    /// </summary>
    std::int64_t getMaxBodyBytes() const;
    void setMaxBodyBytes(std::int64_t value);

    /// <summary>
    /// Most live workers a run may ask for.
    /// </summary>
    std::int32_t getMaxWorkers() const;
    void setMaxWorkers(std::int32_t value);

    /// <summary>
    /// Most actions in one predict; a benchmark may allow fewer.
    /// </summary>
    std::int32_t getMaxChunk() const;
    void setMaxChunk(std::int32_t value);

    /// <summary>
    ///
    /// </summary>
    double getIdleTimeoutSMin() const;
    void setIdleTimeoutSMin(double value);

    /// <summary>
    ///
    /// </summary>
    double getIdleTimeoutSMax() const;
    void setIdleTimeoutSMax(double value);

    /// <summary>
    /// Longest wait that a long-poll is granted.
    /// </summary>
    std::int32_t getWaitSMax() const;
    void setWaitSMax(std::int32_t value);

protected:
    //////////////////////////////////////
    // Override these for customization //
    //////////////////////////////////////

    virtual boost::json::object toJsonObject_internal() const;
    virtual void fromJsonObject_internal(boost::json::object const& object);
    virtual bool isKnownJsonProperty(boost::json::string_view name) const;


protected:
    std::int64_t m_Max_body_bytes = 0L;
    std::int32_t m_Max_workers = 0;
    std::int32_t m_Max_chunk = 0;
    double m_Idle_timeout_s_min = 0.0;
    double m_Idle_timeout_s_max = 0.0;
    std::int32_t m_Wait_s_max = 0;
    ExtraJsonProperties m_extraJsonProperties;
};

std::string createJsonStringFromModelVector(const std::vector<std::shared_ptr<Limits>>& data);

void createModelVectorFromJsonString(std::vector<std::shared_ptr<Limits>>& vec, const std::string& json);

Limits fromJsonValue_Limits(boost::json::value const& value);

}
}
#endif /* PROCTOR_MODEL_Limits_MODEL_H_ */
