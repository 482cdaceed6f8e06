/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */


/**
 *
 * @export
 */
export const Profile = {
    Core: 'core',
    Msgpack: 'msgpack',
    Compare: 'compare',
    Events: 'events',
    Push: 'push',
    Ebench: 'ebench',
    Flageval: 'flageval',
} as const;
export type Profile = typeof Profile[keyof typeof Profile];


export function instanceOfProfile(value: any): boolean {
    for (const key in Profile) {
        if (Object.prototype.hasOwnProperty.call(Profile, key)) {
            if (Profile[key as keyof typeof Profile] === value) {
                return true;
            }
        }
    }
    return false;
}

export function ProfileFromJSON(json: any): Profile {
    return ProfileFromJSONTyped(json, false);
}

export function ProfileFromJSONTyped(json: any, ignoreDiscriminator: boolean): Profile {
    return json as Profile;
}

export function ProfileToJSON(value?: Profile | null): any {
    return value as any;
}

export function ProfileToJSONTyped(value: any, ignoreDiscriminator: boolean): Profile {
    return value as Profile;
}
