package simgsm.center.msc;

import simgsm.air.Msisdn;
import simgsm.center.smsc.MessageState;

/** What an operator hears about. */
public sealed interface ExchangeEvent {
    record Attached(Msisdn number) implements ExchangeEvent {}

    record Detached(Msisdn number) implements ExchangeEvent {}

    /** A call has entered this state; released comes once, with the first clearing message. */
    record CallChanged(Msisdn from, Msisdn to, CallProgress state) implements ExchangeEvent {}

    record MessageChanged(long id, Msisdn from, Msisdn to, MessageState state) implements ExchangeEvent {}
}
