package simgsm.center.msc;

import simgsm.air.Msisdn;
import simgsm.center.msc.call.CallProgress;
import simgsm.center.smsc.MessageState;

/** An event for the operator. */
public sealed interface ExchangeEvent {
    record Attached(Msisdn number) implements ExchangeEvent {}

    record Detached(Msisdn number) implements ExchangeEvent {}

    /** A call has entered this state; RELEASED is reported once, with the first clearing message. */
    record CallChanged(Msisdn from, Msisdn to, CallProgress state) implements ExchangeEvent {}

    record MessageChanged(long id, Msisdn from, Msisdn to, MessageState state) implements ExchangeEvent {}
}
