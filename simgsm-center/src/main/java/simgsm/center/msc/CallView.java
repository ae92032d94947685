package simgsm.center.msc;

import simgsm.air.Msisdn;

/**
 * A call as the operator sees it at one moment.
 *
 * @param to the number as dialled; empty if there was none to be read
 * @param activeSeconds for how long both have been talking; 0 before
 */
public record CallView(Msisdn from, String to, CallProgress state, long activeSeconds) {
    static CallView of(NetworkCall call) {
        return new CallView(call.from(), call.to().map(Msisdn::digits).orElse(""), call.state(), call.activeSeconds());
    }
}
