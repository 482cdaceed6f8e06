/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */


/**
 *
 * @export
 */
export const Rotation = {
    None: 'none',
    QuaternionWxyz: 'quaternion_wxyz',
    QuaternionXyzw: 'quaternion_xyzw',
    AxisAngle: 'axis_angle',
    EulerXyz: 'euler_xyz',
    Rot6dColumns: 'rot6d_columns',
} as const;
export type Rotation = typeof Rotation[keyof typeof Rotation];


export function instanceOfRotation(value: any): boolean {
    for (const key in Rotation) {
        if (Object.prototype.hasOwnProperty.call(Rotation, key)) {
            if (Rotation[key as keyof typeof Rotation] === value) {
                return true;
            }
        }
    }
    return false;
}

export function RotationFromJSON(json: any): Rotation {
    return RotationFromJSONTyped(json, false);
}

export function RotationFromJSONTyped(json: any, ignoreDiscriminator: boolean): Rotation {
    return json as Rotation;
}

export function RotationToJSON(value?: Rotation | null): any {
    return value as any;
}

export function RotationToJSONTyped(value: any, ignoreDiscriminator: boolean): Rotation {
    return value as Rotation;
}
