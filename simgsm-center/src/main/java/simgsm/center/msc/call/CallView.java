package simgsm.center.msc.call;

import simgsm.air.Msisdn;

/**
 * A call at one moment, for the operator.
 *
 * @param to the number as dialled; empty if it could not be decoded
 * @param activeSeconds time since the call became active; 0 before
 */
public record CallView(Msisdn from, String to, CallProgress state, long activeSeconds) {
    public static CallView of(NetworkCall call) {
        return new CallView(call.from(), call.to().map(Msisdn::digits).orElse(""), call.state(), call.activeSeconds());
    }
}
