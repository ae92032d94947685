package simgsm.modem;

import java.util.Optional;
import simgsm.air.Cause;
import simgsm.air.Msisdn;
import simgsm.air.RejectCause;
import simgsm.air.RpCause;
import simgsm.dtmf.DtmfDigit;
import simgsm.dtmf.DtmfKey;

/** What a modem tells the one whom it serves, on the thread that owns the station. Every act of the modem may be called from within. */
public interface ModemListener {
    default void registered(Msisdn number) {}

    /** @param cause if the network refused */
    default void unregistered(Optional<RejectCause> cause) {}

    /** A call has come; the modem answers it in either case. @param from empty if the network does not say */
    CallDecision call(Optional<Msisdn> from);

    /** The accepted call is up: the first key can come now. */
    default void connected(Optional<Msisdn> from) {}

    /** What the accepted caller says, 20 ms of it, for whoever shows it; told before the keys that are decided in it. */
    default void heard(short[] samples) {}

    /** A key of the caller, when it is decided, its tone still sounding. Never told in a denied call. */
    default void key(DtmfDigit digit) {}

    /** Speech of the accepted call has come, lost frames included; told after the keys that were decided in it. */
    default void speechTime(int samples) {}

    /** A tone of {@link Modem#sendTone} or of the decision has left whole. */
    default void toneSent(DtmfKey key) {}

    /** Once for each call that {@link #call} has told. */
    default void callEnded(Cause cause) {}

    /** @param from a number, or a name where the sender has one */
    default void sms(String from, String text) {}

    /** @param id what {@link Modem#sendSms} or {@link Modem#reply} returned */
    default void smsSent(int id, Msisdn to, int parts) {}

    default void smsFailed(int id, Msisdn to, RpCause cause) {}
}
