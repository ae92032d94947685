package simgsm.center.msc;

import java.util.Optional;
import simgsm.air.Cause;
import simgsm.air.Msisdn;
import simgsm.center.msc.call.CallProgress;
import simgsm.center.smsc.MessageState;
import simgsm.event.EventLine;

/** An event for the operator. */
public sealed interface ExchangeEvent {
    @EventLine("attached number=")
    record Attached(Msisdn number) implements ExchangeEvent {}

    @EventLine("detached number=")
    record Detached(Msisdn number) implements ExchangeEvent {}

    /**
     * A call has entered this state; RELEASED is reported once, with the first clearing message.
     *
     * @param id rising from 1 in the order of SETUP
     * @param cause why it was released; empty before
     */
    @EventLine("call from= to= state=")
    record CallChanged(long id, Msisdn from, Msisdn to, CallProgress state, Optional<Cause> cause)
            implements ExchangeEvent {}

    @EventLine("sms id= from=from.digits to=to.digits state=")
    record MessageChanged(long id, Msisdn from, Msisdn to, MessageState state) implements ExchangeEvent {}
}
