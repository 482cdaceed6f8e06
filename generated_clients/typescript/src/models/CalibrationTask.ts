/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */


/**
 *
 * @export
 */
export const CalibrationTask = {
    Score: 'score',
    Count: 'count',
    Echo: 'echo',
    Delay: 'delay',
    Fault: 'fault',
} as const;
export type CalibrationTask = typeof CalibrationTask[keyof typeof CalibrationTask];


export function instanceOfCalibrationTask(value: any): boolean {
    for (const key in CalibrationTask) {
        if (Object.prototype.hasOwnProperty.call(CalibrationTask, key)) {
            if (CalibrationTask[key as keyof typeof CalibrationTask] === value) {
                return true;
            }
        }
    }
    return false;
}

export function CalibrationTaskFromJSON(json: any): CalibrationTask {
    return CalibrationTaskFromJSONTyped(json, false);
}

export function CalibrationTaskFromJSONTyped(json: any, ignoreDiscriminator: boolean): CalibrationTask {
    return json as CalibrationTask;
}

export function CalibrationTaskToJSON(value?: CalibrationTask | null): any {
    return value as any;
}

export function CalibrationTaskToJSONTyped(value: any, ignoreDiscriminator: boolean): CalibrationTask {
    return value as CalibrationTask;
}
