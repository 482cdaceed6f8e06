/* tslint:disable */
/* eslint-disable */
export * from './runtime';
export { InvalidAnswer } from './shapes';
export * from './apis/index';
export * from './models/index';
