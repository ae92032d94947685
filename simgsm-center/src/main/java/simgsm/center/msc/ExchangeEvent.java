package simgsm.center.msc;

import java.util.Optional;
import simgsm.air.Cause;
import simgsm.air.Msisdn;
import simgsm.center.msc.call.CallProgress;
import simgsm.center.smsc.MessageState;

/** An event for the operator. */
public sealed interface ExchangeEvent {
    record Attached(Msisdn number) implements ExchangeEvent {}

    record Detached(Msisdn number) implements ExchangeEvent {}

    /**
     * A call has entered this state; RELEASED is reported once, with the first clearing message.
     *
     * @param id rising from 1 in the order of SETUP
     * @param cause why it was released; empty before
     */
    record CallChanged(long id, Msisdn from, Msisdn to, CallProgress state, Optional<Cause> cause)
            implements ExchangeEvent {}

    record MessageChanged(long id, Msisdn from, Msisdn to, MessageState state) implements ExchangeEvent {}
}
