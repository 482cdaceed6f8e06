/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */

import { mapValues } from '../runtime';
import { checkMembers } from '../shapes';
/**
 * The `select` of a run, as it was submitted.
 * @export
 * @interface SelectionView
 */
export interface SelectionView {
    [key: string]: any | any;
    /**
     *
     */
    tasks?: Array<string>;
    /**
     *
     */
    splits?: Array<string>;
}

/**
 * Check if a given object implements the SelectionView interface.
 */
export function instanceOfSelectionView(value: object): value is SelectionView {
    return true;
}

export function SelectionViewFromJSON(json: any): SelectionView {
    return SelectionViewFromJSONTyped(json, false);
}

export function SelectionViewFromJSONTyped(json: any, ignoreDiscriminator: boolean): SelectionView {
    if (json == null) {
        return json;
    }
    checkMembers('SelectionView', json);
    return {

            ...json,
        'tasks': json['tasks'] == null ? undefined : json['tasks'],
        'splits': json['splits'] == null ? undefined : json['splits'],
    };
}

export function SelectionViewToJSON(json: any): SelectionView {
    return SelectionViewToJSONTyped(json, false);
}

export function SelectionViewToJSONTyped(value?: SelectionView | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

            ...value,
        'tasks': value['tasks'],
        'splits': value['splits'],
    };
}
