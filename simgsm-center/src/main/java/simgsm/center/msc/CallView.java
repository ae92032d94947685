package simgsm.center.msc;

import simgsm.air.Msisdn;

/**
 * A call as the operator sees it.
 *
 * @param to the number as dialled; empty if there was none to be read
 */
public record CallView(Msisdn from, String to, CallState state) {
    static CallView of(Call call) {
        return new CallView(call.from(), call.to().map(Msisdn::digits).orElse(""), call.state());
    }
}
