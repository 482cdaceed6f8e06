/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */


/**
 * `proctor` is policy.yaml. `openai_chat` asks for a chat completion at `chat/completions` below the URL, for benchmarks that are answered in words. `openai_completions` asks for the completion of a text at `completions` below the URL, for such benchmarks without images.
 * @export
 */
export const PolicyProtocol = {
    Proctor: 'proctor',
    OpenaiChat: 'openai_chat',
    OpenaiCompletions: 'openai_completions',
} as const;
export type PolicyProtocol = typeof PolicyProtocol[keyof typeof PolicyProtocol];


export function instanceOfPolicyProtocol(value: any): boolean {
    for (const key in PolicyProtocol) {
        if (Object.prototype.hasOwnProperty.call(PolicyProtocol, key)) {
            if (PolicyProtocol[key as keyof typeof PolicyProtocol] === value) {
                return true;
            }
        }
    }
    return false;
}

export function PolicyProtocolFromJSON(json: any): PolicyProtocol {
    return PolicyProtocolFromJSONTyped(json, false);
}

export function PolicyProtocolFromJSONTyped(json: any, ignoreDiscriminator: boolean): PolicyProtocol {
    return json as PolicyProtocol;
}

export function PolicyProtocolToJSON(value?: PolicyProtocol | null): any {
    return value as any;
}

export function PolicyProtocolToJSONTyped(value: any, ignoreDiscriminator: boolean): PolicyProtocol {
    return value as PolicyProtocol;
}
