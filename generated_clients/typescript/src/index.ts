/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */

export * from './apis/ControlApi';
export * from './apis/DataApi';
export * from './models';
export { Configuration, FetchError, RequiredError, ResponseError, isOfProctor, isPage, mayPass, type Answer, type ConfigurationParameters } from './runtime';
export { BadSetting } from './settings';
export { InvalidAnswer, read } from './answers';
