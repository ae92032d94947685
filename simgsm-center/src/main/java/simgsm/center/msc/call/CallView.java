package simgsm.center.msc.call;

import java.util.Optional;
import simgsm.air.Cause;
import simgsm.air.Msisdn;
import simgsm.event.EventLine;

/**
 * A call at one moment, for the operator.
 *
 * <p>As a line: answer to {@code calls}; seconds since it became active.
 *
 * @param to the dialled number; empty if it could not be decoded
 * @param activeSeconds duration of the active call
 * @param cause of the clearing; empty before
 */
@EventLine("call from= to= state= seconds=activeSeconds")
public record CallView(Msisdn from, String to, CallProgress state, long activeSeconds, Optional<Cause> cause) {
    /** Creates a call that has not been cleared. */
    public CallView(Msisdn from, String to, CallProgress state, long activeSeconds) {
        this(from, to, state, activeSeconds, Optional.empty());
    }

    public static CallView of(NetworkCall call) {
        return new CallView(
                call.from(),
                call.to().map(Msisdn::digits).orElse(""),
                call.state(),
                call.activeSeconds(),
                call.cause());
    }
}
