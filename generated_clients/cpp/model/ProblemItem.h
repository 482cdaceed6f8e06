/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * ProblemItem.h
 *
 *
 */

#ifndef PROCTOR_MODEL_ProblemItem_MODEL_H_
#define PROCTOR_MODEL_ProblemItem_MODEL_H_

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
class ProblemItem
{
public:
    ProblemItem() = default;
    explicit ProblemItem(boost::json::value const& value);
    virtual ~ProblemItem() = default;

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
    /// ProblemItem members

    /// <summary>
    /// JSON pointer into the body, to the faulty member or a part of it; or &#x60;query:name&#x60;, &#x60;header:name&#x60;, &#x60;path:name&#x60;.
    /// </summary>
    std::string getPointer() const;
    void setPointer(std::string value);

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
    std::string m_Pointer = "";
    std::string m_Detail = "";
    ExtraJsonProperties m_extraJsonProperties;
};

std::string createJsonStringFromModelVector(const std::vector<std::shared_ptr<ProblemItem>>& data);

void createModelVectorFromJsonString(std::vector<std::shared_ptr<ProblemItem>>& vec, const std::string& json);

ProblemItem fromJsonValue_ProblemItem(boost::json::value const& value);

}
}
#endif /* PROCTOR_MODEL_ProblemItem_MODEL_H_ */
