/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * AttachWorker.h
 *
 *
 */

#ifndef PROCTOR_MODEL_AttachWorker_MODEL_H_
#define PROCTOR_MODEL_AttachWorker_MODEL_H_

#include <string>
#include <map>
#include <vector>
#include "Assumptions.h"
#include <utility>
#include <memory>
#include <boost/json.hpp>
#include "NullableField.h"

namespace proctor {
namespace model {



/// <summary>
///
/// </summary>
class AttachWorker
{
public:
    AttachWorker() = default;
    explicit AttachWorker(boost::json::value const& value);
    virtual ~AttachWorker() = default;

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
    /// AttachWorker members

    /// <summary>
    /// Chosen anew for every attachment; repeated only to repeat a lost request.
    /// </summary>
    std::string getAttachKey() const;
    void setAttachKey(std::string value);

    /// <summary>
    /// Fence out a live session; false when absent.
    /// </summary>
    bool isTakeover() const;
    void setTakeover(bool value);

    /// <summary>
    ///
    /// </summary>
    Assumptions getAssumes() const;
    void setAssumes(Assumptions value);

protected:
    //////////////////////////////////////
    // Override these for customization //
    //////////////////////////////////////

    virtual boost::json::object toJsonObject_internal() const;
    virtual void fromJsonObject_internal(boost::json::object const& object);
    virtual bool isKnownJsonProperty(boost::json::string_view name) const;


protected:
    std::string m_Attach_key = "";
    bool m_Takeover = false;
    bool m_TakeoverIsSet = false;
    Assumptions m_Assumes;
    bool m_AssumesIsSet = false;
    ExtraJsonProperties m_extraJsonProperties;
};

std::string createJsonStringFromModelVector(const std::vector<std::shared_ptr<AttachWorker>>& data);

void createModelVectorFromJsonString(std::vector<std::shared_ptr<AttachWorker>>& vec, const std::string& json);

AttachWorker fromJsonValue_AttachWorker(boost::json::value const& value);

}
}
#endif /* PROCTOR_MODEL_AttachWorker_MODEL_H_ */
