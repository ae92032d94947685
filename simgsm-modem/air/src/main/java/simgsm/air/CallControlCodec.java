package simgsm.air;

import java.util.Optional;
import simgsm.air.OptionalElements.FixedElements;
import simgsm.octets.OctetString;
import simgsm.octets.OctetWriter;

/** What follows the message type in call control messages (TS 24.008, 9.3). */
final class CallControlCodec {
    private static final int BEARER_CAPABILITY = 0x04;
    private static final int CAUSE = 0x08;
    private static final int PROGRESS_INDICATOR = 0x1e;
    private static final int BACKUP_BEARER = 0x3b;
    private static final int KEYPAD_FACILITY = 0x2c;
    private static final int SIGNAL = 0x34;
    private static final int CONNECTED_NUMBER = 0x4c;
    private static final int CALLING_NUMBER = 0x5c;
    private static final int CALLED_NUMBER = 0x5e;

    /** Speech: full rate preferred, versions 4, 2, 0 (half rate) and 5, 1 as a common handset lists them. */
    private static final OctetString SPEECH_FROM_MOBILE = OctetString.ofHex("0406600402000581");
    /** Speech: full rate. */
    private static final OctetString SPEECH_FROM_NETWORK = OctetString.ofHex("0401a0");
    /** Coding GSM, public network serving the local user; in-band information is now available. */
    private static final OctetString IN_BAND_TONES = OctetString.ofHex("02e288");

    private static final int IN_BAND_AVAILABLE = 8;

    /** Coding standard GSM, in the octet of the call state. */
    private static final int GSM_CALL_STATE = 0xc0;

    private CallControlCodec() {}

    static void write(OctetWriter out, CallControl message, Direction direction) {
        CauseLocation sender = CauseLocation.of(direction, false);
        if (message instanceof CallControl.Setup setup) {
            writeSetup(out, setup, direction);
        } else if (message instanceof CallControl.CallConfirmed confirmed) {
            writeOptionalCause(out, confirmed.cause(), Optional.of(sender));
        } else if (message instanceof CallControl.Progress) {
            out.string(IN_BAND_TONES);
        } else if (message instanceof CallControl.StartDtmf start) {
            out.octet(KEYPAD_FACILITY).octet(start.key());
        } else if (message instanceof CallControl.StartDtmfAcknowledge acknowledge) {
            out.octet(KEYPAD_FACILITY).octet(acknowledge.key());
        } else if (message instanceof CallControl.Rejection reject) {
            CauseElement.write(out, reject.cause(), sender);
        } else if (message instanceof CallControl.Facility facility) {
            out.octet(facility.facility().length()).string(facility.facility());
        } else if (message instanceof CallControl.Alerting alerting) {
            writeInBand(out, alerting.inBand());
        } else if (message instanceof CallControl.Connect connect) {
            connect.connected().ifPresent(number -> NumberElements.writeShown(out.octet(CONNECTED_NUMBER), number));
        } else if (message instanceof CallControl.Disconnect disconnect) {
            CauseElement.write(out, disconnect.cause(), disconnect.location());
            writeInBand(out, disconnect.inBand());
        } else if (message instanceof CallControl.Releasing release) {
            writeOptionalCause(out, release.cause(), release.location());
        } else if (message instanceof CallControl.Status status) {
            CauseElement.write(out, status.cause(), sender);
            out.octet(GSM_CALL_STATE | status.callState());
        }
    }

    private static void writeSetup(OctetWriter out, CallControl.Setup setup, Direction direction) {
        out.string(direction == Direction.UPLINK ? SPEECH_FROM_MOBILE : SPEECH_FROM_NETWORK);
        setup.signal().ifPresent(signal -> out.octet(SIGNAL).octet(signal.code()));
        setup.calling().ifPresent(number -> NumberElements.writeShown(out.octet(CALLING_NUMBER), number));
        setup.called().ifPresent(number -> NumberElements.writeCalled(out.octet(CALLED_NUMBER), number));
    }

    private static void writeInBand(OctetWriter out, boolean inBand) {
        if (inBand) {
            out.octet(PROGRESS_INDICATOR).string(IN_BAND_TONES);
        }
    }

    private static void writeOptionalCause(OctetWriter out, Optional<Cause> cause, Optional<CauseLocation> location) {
        cause.ifPresent(value -> CauseElement.write(out.octet(CAUSE), value, location.orElseThrow()));
    }

    static CallControl read(Layer3Type type, TransactionIdentifier ti, MessageReader in, Direction direction)
            throws ProtocolViolation {
        CallControl message = switch (type) {
            case SETUP -> readSetup(ti, in, direction);
            case CALL_CONFIRMED ->
                new CallControl.CallConfirmed(ti, readOptionalCause(in).map(CauseElement::cause));
            case CALL_PROCEEDING -> new CallControl.CallProceeding(ti);
            case PROGRESS -> readProgress(ti, in);
            case ALERTING -> new CallControl.Alerting(ti, readInBand(in));
            case CONNECT -> readConnect(ti, in, direction);
            case CONNECT_ACKNOWLEDGE -> new CallControl.ConnectAcknowledge(ti);
            case START_DTMF -> new CallControl.StartDtmf(ti, readKey(in));
            case START_DTMF_ACKNOWLEDGE -> new CallControl.StartDtmfAcknowledge(ti, readKey(in));
            case START_DTMF_REJECT ->
                new CallControl.StartDtmfReject(ti, CauseElement.read(in).cause());
            case STOP_DTMF -> new CallControl.StopDtmf(ti);
            case STOP_DTMF_ACKNOWLEDGE -> new CallControl.StopDtmfAcknowledge(ti);
            case HOLD -> new CallControl.Hold(ti);
            case HOLD_ACKNOWLEDGE -> new CallControl.HoldAcknowledge(ti);
            case HOLD_REJECT ->
                new CallControl.HoldReject(ti, CauseElement.read(in).cause());
            case RETRIEVE -> new CallControl.Retrieve(ti);
            case RETRIEVE_ACKNOWLEDGE -> new CallControl.RetrieveAcknowledge(ti);
            case RETRIEVE_REJECT ->
                new CallControl.RetrieveReject(ti, CauseElement.read(in).cause());
            case DISCONNECT -> readDisconnect(ti, in);
            case RELEASE, RELEASE_COMPLETE -> readRelease(type, ti, in);
            case FACILITY ->
                new CallControl.Facility(ti, in.lengthAndValue("facility").rest());
            case STATUS_ENQUIRY -> new CallControl.StatusEnquiry(ti);
            default -> new CallControl.Status(ti, CauseElement.read(in).cause(), in.octet("call state") & 0x3f);
        };
        optional(in).skipAll();
        return message;
    }

    private static CallControl readProgress(TransactionIdentifier transaction, MessageReader in)
            throws ProtocolViolation {
        in.lengthAndValue("progress indicator");
        return new CallControl.Progress(transaction);
    }

    /** Uplink a called number is mandatory; one that cannot be read, such as *21#, is left out: the network answers with cause 28. */
    private static CallControl.Setup readSetup(TransactionIdentifier transaction, MessageReader in, Direction direction)
            throws ProtocolViolation {
        Optional<CallControl.Signal> signal = Optional.empty();
        Optional<Msisdn> calling = Optional.empty();
        Optional<Msisdn> called = Optional.empty();
        boolean isCalledThere = false;
        OptionalElements elements = new OptionalElements(in, FixedElements.CALL_CONTROL, BEARER_CAPABILITY);
        for (int identifier = elements.next(); identifier >= 0; identifier = elements.next()) {
            if (identifier == SIGNAL && direction == Direction.DOWNLINK) {
                signal =
                        Coded.find(CallControl.Signal.values(), elements.value().octet("signal"));
            } else if (identifier == CALLING_NUMBER && calling.isEmpty()) {
                calling = NumberElements.readOptional(elements.value());
            } else if (identifier == CALLED_NUMBER && called.isEmpty()) {
                called = NumberElements.readOptional(elements.value());
                isCalledThere = true;
            }
        }
        if (!isCalledThere && direction == Direction.UPLINK) {
            throw ProtocolViolation.invalid("the called number is missing");
        }
        return new CallControl.Setup(transaction, signal, calling, called);
    }

    /** Clears the call even if its cause cannot be read; cause 96 then stands for it (TS 24.008, 8.5.2). */
    private static CallControl.Disconnect readDisconnect(TransactionIdentifier transaction, MessageReader in) {
        try {
            CauseElement cause = CauseElement.read(in);
            return new CallControl.Disconnect(transaction, cause.cause(), cause.location(), readInBand(in));
        } catch (ProtocolViolation broken) {
            in.skipRest();
            return new CallControl.Disconnect(transaction, Cause.INVALID_MANDATORY_INFORMATION);
        }
    }

    private static CallControl readRelease(Layer3Type type, TransactionIdentifier transaction, MessageReader in) {
        Optional<CauseElement> given = readOptionalCause(in);
        Optional<Cause> cause = given.map(CauseElement::cause);
        Optional<CauseLocation> location = given.map(CauseElement::location);
        return type == Layer3Type.RELEASE
                ? new CallControl.Release(transaction, cause, location)
                : new CallControl.ReleaseComplete(transaction, cause, location);
    }

    private static CallControl.Connect readConnect(
            TransactionIdentifier transaction, MessageReader in, Direction direction) throws ProtocolViolation {
        Optional<Msisdn> connected = direction == Direction.DOWNLINK
                ? optional(in).first(CONNECTED_NUMBER).flatMap(NumberElements::readOptional)
                : Optional.empty();
        return new CallControl.Connect(transaction, connected);
    }

    /** Clears the call whatever the elements say (TS 24.008, 8.5.3 and 8.5.4). */
    private static Optional<CauseElement> readOptionalCause(MessageReader in) {
        try {
            return new OptionalElements(in, FixedElements.CALL_CONTROL, CAUSE)
                    .first(CAUSE)
                    .flatMap(CauseElement::readOptional);
        } catch (ProtocolViolation broken) {
            return Optional.of(new CauseElement(Cause.INVALID_MANDATORY_INFORMATION, CauseLocation.USER));
        } finally {
            in.skipRest();
        }
    }

    private static OptionalElements optional(MessageReader in) {
        return new OptionalElements(in, FixedElements.CALL_CONTROL, BEARER_CAPABILITY, BACKUP_BEARER);
    }

    /** Whether a progress indicator asks the mobile to listen to what the network plays (TS 24.008, 10.5.4.21, value 8). */
    private static boolean readInBand(MessageReader in) throws ProtocolViolation {
        Optional<MessageReader> progress = optional(in).first(PROGRESS_INDICATOR);
        if (progress.isEmpty() || progress.get().remaining() != 2) {
            return false;
        }
        progress.get().octet("progress location");
        return (progress.get().octet("progress description") & 0x7f) == IN_BAND_AVAILABLE;
    }

    private static char readKey(MessageReader in) throws ProtocolViolation {
        if (in.octet("keypad facility") != KEYPAD_FACILITY) {
            throw ProtocolViolation.invalid("keypad facility is missing");
        }
        char key = (char) (in.octet("key") & 0x7f);
        if (!CallControl.isKey(key)) {
            throw ProtocolViolation.invalid("key " + (int) key + " is none of 0-9 * # A-D");
        }
        return key;
    }
}
