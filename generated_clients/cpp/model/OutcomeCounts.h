/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * OutcomeCounts.h
 *
 *
 */

#ifndef PROCTOR_MODEL_OutcomeCounts_MODEL_H_
#define PROCTOR_MODEL_OutcomeCounts_MODEL_H_

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
class OutcomeCounts
{
public:
    OutcomeCounts() = default;
    explicit OutcomeCounts(boost::json::value const& value);
    virtual ~OutcomeCounts() = default;

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
    /// OutcomeCounts members

    /// <summary>
    ///
    /// </summary>
    std::int32_t getTotal() const;
    void setTotal(std::int32_t value);

    /// <summary>
    ///
    /// </summary>
    std::int32_t getSuccess() const;
    void setSuccess(std::int32_t value);

    /// <summary>
    ///
    /// </summary>
    std::int32_t getFailure() const;
    void setFailure(std::int32_t value);

    /// <summary>
    ///
    /// </summary>
    std::int32_t getAbandoned() const;
    void setAbandoned(std::int32_t value);

    /// <summary>
    ///
    /// </summary>
    std::int32_t getUnscored() const;
    void setUnscored(std::int32_t value);

protected:
    //////////////////////////////////////
    // Override these for customization //
    //////////////////////////////////////

    virtual boost::json::object toJsonObject_internal() const;
    virtual void fromJsonObject_internal(boost::json::object const& object);
    virtual bool isKnownJsonProperty(boost::json::string_view name) const;


protected:
    std::int32_t m_Total = 0;
    std::int32_t m_Success = 0;
    std::int32_t m_Failure = 0;
    std::int32_t m_Abandoned = 0;
    std::int32_t m_Unscored = 0;
    ExtraJsonProperties m_extraJsonProperties;
};

std::string createJsonStringFromModelVector(const std::vector<std::shared_ptr<OutcomeCounts>>& data);

void createModelVectorFromJsonString(std::vector<std::shared_ptr<OutcomeCounts>>& vec, const std::string& json);

OutcomeCounts fromJsonValue_OutcomeCounts(boost::json::value const& value);

}
}
#endif /* PROCTOR_MODEL_OutcomeCounts_MODEL_H_ */
