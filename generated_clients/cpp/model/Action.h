/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * Action.h
 *
 *
 */

#ifndef PROCTOR_MODEL_Action_MODEL_H_
#define PROCTOR_MODEL_Action_MODEL_H_

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
///
/// </summary>
class Action
{
public:
    Action() = default;
    explicit Action(boost::json::value const& value);
    virtual ~Action() = default;

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
    /// Action members

    /// <summary>
    /// Name \342\206\222 vector, exactly the entries of the benchmark&#39;s action space.
    /// </summary>
    std::map<std::string, std::vector<double>> getValues() const;
    void setValues(std::map<std::string, std::vector<double>> value);

protected:
    //////////////////////////////////////
    // Override these for customization //
    //////////////////////////////////////

    virtual boost::json::object toJsonObject_internal() const;
    virtual void fromJsonObject_internal(boost::json::object const& object);
    virtual bool isKnownJsonProperty(boost::json::string_view name) const;


protected:
    std::map<std::string, std::vector<double>> m_Values;
    ExtraJsonProperties m_extraJsonProperties;
};

std::string createJsonStringFromModelVector(const std::vector<std::shared_ptr<Action>>& data);

void createModelVectorFromJsonString(std::vector<std::shared_ptr<Action>>& vec, const std::string& json);

Action fromJsonValue_Action(boost::json::value const& value);

}
}
#endif /* PROCTOR_MODEL_Action_MODEL_H_ */
