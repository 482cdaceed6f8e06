/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * Predict.h
 *
 *
 */

#ifndef PROCTOR_MODEL_Predict_MODEL_H_
#define PROCTOR_MODEL_Predict_MODEL_H_

#include <string>
#include "Observe.h"
#include <map>
#include <vector>
#include "Action.h"
#include <utility>
#include <memory>
#include <boost/json.hpp>
#include "NullableField.h"

namespace proctor {
namespace model {



/// <summary>
///
/// </summary>
class Predict
{
public:
    Predict() = default;
    explicit Predict(boost::json::value const& value);
    virtual ~Predict() = default;

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
    /// Predict members

    /// <summary>
    ///
    /// </summary>
    std::string getSessionId() const;
    void setSessionId(std::string value);

    /// <summary>
    ///
    /// </summary>
    std::int64_t getSeq() const;
    void setSeq(std::int64_t value);

    /// <summary>
    ///
    /// </summary>
    std::vector<Action> getActions() const;
    void setActions(std::vector<Action> value);

    /// <summary>
    ///
    /// </summary>
    Observe getObserve() const;
    void setObserve(Observe value);

protected:
    //////////////////////////////////////
    // Override these for customization //
    //////////////////////////////////////

    virtual boost::json::object toJsonObject_internal() const;
    virtual void fromJsonObject_internal(boost::json::object const& object);
    virtual bool isKnownJsonProperty(boost::json::string_view name) const;


protected:
    std::string m_Session_id = "";
    std::int64_t m_Seq = 0L;
    std::vector<Action> m_Actions;
    Observe m_Observe;
    bool m_ObserveIsSet = false;
    ExtraJsonProperties m_extraJsonProperties;
};

std::string createJsonStringFromModelVector(const std::vector<std::shared_ptr<Predict>>& data);

void createModelVectorFromJsonString(std::vector<std::shared_ptr<Predict>>& vec, const std::string& json);

Predict fromJsonValue_Predict(boost::json::value const& value);

}
}
#endif /* PROCTOR_MODEL_Predict_MODEL_H_ */
