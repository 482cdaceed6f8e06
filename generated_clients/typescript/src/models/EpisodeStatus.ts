/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */


/**
 *
 * @export
 */
export const EpisodeStatus = {
    Pending: 'pending',
    InProgress: 'in_progress',
    Scored: 'scored',
} as const;
export type EpisodeStatus = typeof EpisodeStatus[keyof typeof EpisodeStatus];


export function instanceOfEpisodeStatus(value: any): boolean {
    for (const key in EpisodeStatus) {
        if (Object.prototype.hasOwnProperty.call(EpisodeStatus, key)) {
            if (EpisodeStatus[key as keyof typeof EpisodeStatus] === value) {
                return true;
            }
        }
    }
    return false;
}

export function EpisodeStatusFromJSON(json: any): EpisodeStatus {
    return EpisodeStatusFromJSONTyped(json, false);
}

export function EpisodeStatusFromJSONTyped(json: any, ignoreDiscriminator: boolean): EpisodeStatus {
    return json as EpisodeStatus;
}

export function EpisodeStatusToJSON(value?: EpisodeStatus | null): any {
    return value as any;
}

export function EpisodeStatusToJSONTyped(value: any, ignoreDiscriminator: boolean): EpisodeStatus {
    return value as EpisodeStatus;
}
