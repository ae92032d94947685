package simgsm.station.context;

import java.time.OffsetDateTime;
import java.util.Optional;
import simgsm.air.Cause;
import simgsm.air.Direction;
import simgsm.air.Layer3Message;
import simgsm.air.Msisdn;
import simgsm.air.RejectCause;
import simgsm.air.RpCause;
import simgsm.dtmf.DtmfKey;
import simgsm.event.EventLine;
import simgsm.octets.OctetString;
import simgsm.sim.PinLock;
import simgsm.sms.DeliveryStatus;
import simgsm.ss.ServiceStatus;
import simgsm.ss.SsError;
import simgsm.ss.SsOperation;

/**
 * Reports of a station, and of a terminal built on it. Events are delivered on the owner thread once the station's
 * state is settled, so the receiver may call every command of the station.
 */
public sealed interface StationEvent {
    /** An event of a phone or a modem besides its station's. */
    non-sealed interface OfTerminal extends StationEvent {}

    /** Registration is accepted. */
    @EventLine("registered number=")
    record StationRegistered(Msisdn number) implements StationEvent {}

    /** Registration is refused or lost; once for each cause. @param cause if the network refused */
    @EventLine("unregistered [cause=]")
    record StationUnregistered(Optional<RejectCause> cause) implements StationEvent {}

    /**
     * What the card demands of its user has changed, or its tries. @param tries left for the PIN, or in the state puk for
     * the PUK
     */
    @EventLine("sim state= tries=")
    record SimStateChanged(PinLock.State state, int tries) implements StationEvent {}

    /** The network has told the time (MM INFORMATION). @param time with the local time zone */
    @EventLine("network-time time=")
    record NetworkTimeReceived(OffsetDateTime time) implements StationEvent {}

    /** The snapshot has changed. */
    record StationChanged() implements StationEvent {}

    /** A layer 3 message was sent or received. */
    record MessagePassed(Direction direction, Layer3Message message) implements StationEvent {}

    /** 30 s have passed since the station was asked for a reminder. */
    record ReminderDue() implements StationEvent {}

    /**
     * This number of consecutive speech frames did not arrive; as many {@link SpeechReceived} with substitutes
     * follow.
     */
    record SpeechLost(int frames) implements StationEvent {}

    /**
     * The next 20 ms from the far end or the network.
     *
     * @param samples 160, 8 kHz, 16 bit; 0 for a lost frame
     */
    record SpeechReceived(short[] samples) implements StationEvent {}

    /** The progress of a call. */
    sealed interface OfCall extends StationEvent {}

    /** An outgoing call begins; {@code service=emergency} with 112 and 911. */
    @EventLine("calling number= [service=]")
    record Calling(Msisdn number) implements OfCall {
        /** The word {@code emergency}, or nothing. */
        public Optional<String> service() {
            return number.isEmergency() ? Optional.of("emergency") : Optional.empty();
        }
    }

    /** The network forwards the call to another number (TS 24.082). */
    @EventLine("forwarded")
    record CallForwarded() implements OfCall {}

    /** The network forwards a call to this terminal, which is busy or does not answer, to another number (TS 24.082). */
    @EventLine("incoming-forwarded")
    record IncomingCallForwarded() implements OfCall {}

    /** The terminal makes a call while all calls to it are forwarded (TS 24.082). */
    @EventLine("forwarding-active")
    record ForwardingActive() implements OfCall {}

    /** The called terminal rings. */
    @EventLine("alerting")
    record CalledPartyAlerted() implements OfCall {}

    /** A call rings. @param from empty if the network does not give it */
    @EventLine("ringing from=")
    record Ringing(Optional<Msisdn> from) implements OfCall {}

    /** The ringing call was dialled to this number and forwarded by it (Redirecting Number). */
    @EventLine("forwarded-by number=")
    record ForwardedBy(Msisdn number) implements OfCall {}

    /** A time requested by {@link simgsm.station.MobileStation#remindToAnswer} is over; the call still rings. */
    record AnswerDue() implements OfCall {}

    /** A second call waits. @param from empty if the network does not give it */
    @EventLine("waiting from=")
    record CallWaits(Optional<Msisdn> from) implements OfCall {}

    /** The active call is held. @param peer empty if the network does not give it */
    @EventLine("held number=peer")
    record CallHeld(Optional<Msisdn> peer) implements OfCall {}

    /** The held call is active again. @param peer empty if the network does not give it */
    @EventLine("retrieved number=peer")
    record CallRetrieved(Optional<Msisdn> peer) implements OfCall {}

    /** The held call has ended. */
    @EventLine("held-over cause=")
    record HeldCallEnded(Cause cause) implements OfCall {}

    /** The other party holds the call. */
    @EventLine("on-hold")
    record HeldByPeer() implements OfCall {}

    /** The other party has retrieved it. */
    @EventLine("on-hold-over")
    record RetrievedByPeer() implements OfCall {}

    /** The network does not hold the call, or does not retrieve it. */
    record HoldRefused() implements OfCall {}

    /** The waiting call has ended. */
    @EventLine("waiting-over")
    record WaitingCallEnded() implements OfCall {}

    /** A call is answered. @param peer empty if the network does not give it */
    @EventLine("connected number=peer")
    record Connected(Optional<Msisdn> peer) implements OfCall {}

    /** Once for each call, at the first clearing message sent or received; 16: the user's own hang-up. */
    @EventLine("released cause= text=cause.title")
    record Released(Cause cause) implements OfCall {}

    /**
     * The network starts or stops playing tones instead of the terminal (TS 24.008, 5.5.1 and 5.4.4.1.1.1). {@link
     * SpeechReceived} contains them, also before the call is connected and after its release.
     */
    record NetworkPlaysTones(boolean playing) implements OfCall {}

    /** A key signalled to the network; for each key, in this order, the first three or {@link KeysRefused}. */
    sealed interface OfKey extends StationEvent {}

    /** The network plays the key's tone from now on. */
    record KeyStarted(DtmfKey key) implements OfKey {}

    /** The network has been asked to end the tone. */
    record KeyStopping(DtmfKey key) implements OfKey {}

    /** The tone has ended. */
    record KeyCompleted(DtmfKey key) implements OfKey {}

    /** The network has refused a key or has not answered; the keys queued after it are dropped, too. */
    record KeysRefused(Cause cause) implements OfKey {}

    /** A short message or a broadcast. */
    sealed interface OfMessage extends StationEvent {}

    /** A message submitted here. */
    sealed interface OfSubmittedMessage extends OfMessage {
        /** The number that identifies the message at this station. */
        int id();

        /** TP-MR of the message's first part, 0 to 255. */
        default int reference() {
            return id() & 0xff;
        }
    }

    /** The network has acknowledged all parts. */
    @EventLine("sms-sent to= parts= id=reference")
    record MessageSent(int id, Msisdn to, int parts) implements OfSubmittedMessage {}

    /** The message is refused, or not answered. */
    @EventLine("sms-failed to= cause= text=cause.title")
    record MessageFailed(int id, Msisdn to, RpCause cause) implements OfSubmittedMessage {}

    /** The status report: delivered. */
    @EventLine("sms-delivered to= id=reference")
    record MessageDelivered(int id, Msisdn to) implements OfSubmittedMessage {}

    /**
     * The status report: not delivered.
     *
     * @param status TP-ST, see {@link simgsm.sms.DeliveryStatus}
     */
    @EventLine("sms-undelivered to= id=reference status= text=")
    record MessageUndelivered(int id, Msisdn to, int status) implements OfSubmittedMessage {
        /** The status in words. */
        public String text() {
            return DeliveryStatus.title(status);
        }
    }

    /** A message is received, once. @param from a number, or an alphanumeric address */
    @EventLine("sms from= text=")
    record ShortMessageReceived(String from, String text) implements OfMessage {}

    /** A cell broadcast is received. */
    @EventLine("broadcast channel= pages= text=")
    record BroadcastReceived(int channel, int pages, String text) implements OfMessage {}

    /** USSD (TS 24.090). */
    sealed interface OfUssd extends StationEvent {}

    /**
     * A text of the network. With {@code reply=expected} the next {@code ussd TEXT} is the reply.
     *
     * @param replyExpected true if the network waits for a reply; else the dialogue is over, or the text is for
     *     information
     */
    @EventLine("ussd text= [reply=]")
    record UssdReceived(String text, boolean replyExpected) implements OfUssd {
        /** The word {@code expected} if a reply is. */
        public Optional<String> reply() {
            return replyExpected ? Optional.of("expected") : Optional.empty();
        }
    }

    /**
     * A service code such as {@code **21*NUMBER#} is performed: active, registered or inactive. @param status current
     * state of the service
     */
    @EventLine(
            "service code=status.service.typed state=status.state [to=status.forwardedTo] [seconds=status.noReplySeconds]")
    record ServiceAnswered(SsOperation operation, ServiceStatus status) implements OfUssd {}

    /** No text: the error of TS 24.080, or the reason. @param error if the network refused with a known one */
    @EventLine("ussd-failed [cause=error] text=")
    record UssdEnded(UssdEnding how, Optional<SsError> error) implements OfUssd {
        /** The error's name, or the way the dialogue has ended. */
        public String text() {
            return error.map(SsError::title).orElse(how.title());
        }
    }

    /**
     * A delivery of the network, part by part in order of arrival and without duplicates; the events above follow
     * from it.
     *
     * @param tpdu DELIVER or STATUS-REPORT (TS 23.040, 9.2.2)
     */
    record TransferUnitReceived(OctetString tpdu) implements OfMessage {}

    /** @param octets one page of a broadcast, 88 octets; the cell may repeat it */
    record BroadcastPageReceived(OctetString octets) implements OfMessage {}
}
