/* tslint:disable */
/* eslint-disable */
export * from './ControlApi';
export * from './DataApi';
