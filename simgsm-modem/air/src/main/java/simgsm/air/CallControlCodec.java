package simgsm.air;

import java.util.Arrays;
import java.util.Optional;
import simgsm.air.CallControl.Alerting;
import simgsm.air.CallControl.CallConfirmed;
import simgsm.air.CallControl.CallProceeding;
import simgsm.air.CallControl.Connect;
import simgsm.air.CallControl.ConnectAcknowledge;
import simgsm.air.CallControl.Disconnect;
import simgsm.air.CallControl.Progress;
import simgsm.air.CallControl.Release;
import simgsm.air.CallControl.ReleaseComplete;
import simgsm.air.CallControl.Setup;
import simgsm.air.CallControl.Signal;
import simgsm.air.CallControl.StartDtmf;
import simgsm.air.CallControl.StartDtmfAcknowledge;
import simgsm.air.CallControl.StartDtmfReject;
import simgsm.air.CallControl.Status;
import simgsm.air.CallControl.StatusEnquiry;
import simgsm.air.CallControl.StopDtmf;
import simgsm.air.CallControl.StopDtmfAcknowledge;
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
        if (message instanceof Setup setup) {
            writeSetup(out, setup, direction);
        } else if (message instanceof CallConfirmed confirmed) {
            writeOptionalCause(out, confirmed.cause());
        } else if (message instanceof Progress) {
            out.string(IN_BAND_TONES);
        } else if (message instanceof StartDtmf start) {
            out.octet(KEYPAD_FACILITY).octet(start.key());
        } else if (message instanceof StartDtmfAcknowledge acknowledge) {
            out.octet(KEYPAD_FACILITY).octet(acknowledge.key());
        } else if (message instanceof StartDtmfReject reject) {
            CauseElement.write(out, reject.cause());
        } else if (message instanceof Alerting alerting) {
            writeInBand(out, alerting.inBand());
        } else if (message instanceof Disconnect disconnect) {
            CauseElement.write(out, disconnect.cause());
            writeInBand(out, disconnect.inBand());
        } else if (message instanceof Release release) {
            writeOptionalCause(out, release.cause());
        } else if (message instanceof ReleaseComplete complete) {
            writeOptionalCause(out, complete.cause());
        } else if (message instanceof Status status) {
            CauseElement.write(out, status.cause());
            out.octet(GSM_CALL_STATE | status.callState());
        }
    }

    private static void writeSetup(OctetWriter out, Setup setup, Direction direction) {
        out.string(direction == Direction.UPLINK ? SPEECH_FROM_MOBILE : SPEECH_FROM_NETWORK);
        setup.signal().ifPresent(signal -> out.octet(SIGNAL).octet(signal.code()));
        setup.calling().ifPresent(number -> NumberElements.writeCalling(out.octet(CALLING_NUMBER), number));
        setup.called().ifPresent(number -> NumberElements.writeCalled(out.octet(CALLED_NUMBER), number));
    }

    private static void writeInBand(OctetWriter out, boolean inBand) {
        if (inBand) {
            out.octet(PROGRESS_INDICATOR).string(IN_BAND_TONES);
        }
    }

    private static void writeOptionalCause(OctetWriter out, Optional<Cause> cause) {
        cause.ifPresent(value -> CauseElement.write(out.octet(CAUSE), value));
    }

    static CallControl read(Layer3Type type, TransactionIdentifier transaction, MessageReader in, Direction direction)
            throws ProtocolViolation {
        switch (type) {
            case SETUP:
                return readSetup(transaction, in, direction);
            case CALL_CONFIRMED:
                return new CallConfirmed(transaction, readOptionalCause(in));
            case RELEASE:
                return new Release(transaction, readOptionalCause(in));
            case RELEASE_COMPLETE:
                return new ReleaseComplete(transaction, readOptionalCause(in));
            case DISCONNECT:
                return readDisconnect(transaction, in);
            case ALERTING:
                return new Alerting(transaction, readInBand(in));
            default:
                CallControl message = readPlain(type, transaction, in);
                checkOptional(in);
                return message;
        }
    }

    private static CallControl readPlain(Layer3Type type, TransactionIdentifier transaction, MessageReader in)
            throws ProtocolViolation {
        switch (type) {
            case CALL_PROCEEDING:
                return new CallProceeding(transaction);
            case PROGRESS:
                in.lengthAndValue("progress indicator");
                return new Progress(transaction);
            case CONNECT:
                return new Connect(transaction);
            case CONNECT_ACKNOWLEDGE:
                return new ConnectAcknowledge(transaction);
            case START_DTMF:
                return new StartDtmf(transaction, readKey(in));
            case START_DTMF_ACKNOWLEDGE:
                return new StartDtmfAcknowledge(transaction, readKey(in));
            case START_DTMF_REJECT:
                return new StartDtmfReject(transaction, CauseElement.read(in));
            case STOP_DTMF:
                return new StopDtmf(transaction);
            case STOP_DTMF_ACKNOWLEDGE:
                return new StopDtmfAcknowledge(transaction);
            case STATUS_ENQUIRY:
                return new StatusEnquiry(transaction);
            default:
                return new Status(transaction, CauseElement.read(in), in.octet("call state") & 0x3f);
        }
    }

    /** Uplink a called number is mandatory; one that cannot be read, such as *21#, is left out (cause 28 is the network's). */
    private static Setup readSetup(TransactionIdentifier transaction, MessageReader in, Direction direction)
            throws ProtocolViolation {
        Optional<Signal> signal = Optional.empty();
        Optional<Msisdn> calling = Optional.empty();
        Optional<Msisdn> called = Optional.empty();
        boolean isCalledThere = false;
        OptionalElements elements = new OptionalElements(in, FixedElements.CALL_CONTROL, BEARER_CAPABILITY);
        for (int identifier = elements.next(); identifier >= 0; identifier = elements.next()) {
            if (identifier == SIGNAL && direction == Direction.DOWNLINK) {
                signal = readSignal(elements.value());
            } else if (identifier == CALLING_NUMBER && calling.isEmpty()) {
                calling = NumberElements.readOptional(elements.value());
            } else if (identifier == CALLED_NUMBER && called.isEmpty()) {
                called = NumberElements.readOptional(elements.value());
                isCalledThere = true;
            }
        }
        if (!isCalledThere && direction == Direction.UPLINK) {
            throw new ProtocolViolation(Cause.INVALID_MANDATORY_INFORMATION, "the called number is missing");
        }
        return new Setup(transaction, signal, calling, called);
    }

    /** A signal that we do not know is passed over. */
    private static Optional<Signal> readSignal(MessageReader value) throws ProtocolViolation {
        int code = value.octet("signal");
        return Arrays.stream(Signal.values())
                .filter(each -> each.code() == code)
                .findFirst();
    }

    /** Clears the call even if its cause cannot be read; cause 96 then stands for it (TS 24.008, 8.5.2). */
    private static Disconnect readDisconnect(TransactionIdentifier transaction, MessageReader in) {
        try {
            return new Disconnect(transaction, CauseElement.read(in), readInBand(in));
        } catch (ProtocolViolation broken) {
            return new Disconnect(transaction, Cause.INVALID_MANDATORY_INFORMATION);
        }
    }

    /** Clears the call whatever the elements say (TS 24.008, 8.5.3 and 8.5.4). */
    private static Optional<Cause> readOptionalCause(MessageReader in) {
        OptionalElements elements = new OptionalElements(in, FixedElements.CALL_CONTROL, CAUSE);
        try {
            for (int identifier = elements.next(); identifier >= 0; identifier = elements.next()) {
                if (identifier == CAUSE) {
                    return CauseElement.readOptional(elements.value());
                }
            }
            return Optional.empty();
        } catch (ProtocolViolation broken) {
            return Optional.of(Cause.INVALID_MANDATORY_INFORMATION);
        }
    }

    /** Whether a progress indicator asks the mobile to listen to what the network plays (TS 24.008, 10.5.4.21, value 8). */
    private static boolean readInBand(MessageReader in) throws ProtocolViolation {
        OptionalElements elements =
                new OptionalElements(in, FixedElements.CALL_CONTROL, BEARER_CAPABILITY, BACKUP_BEARER);
        boolean inBand = false;
        for (int identifier = elements.next(); identifier >= 0; identifier = elements.next()) {
            if (identifier == PROGRESS_INDICATOR && elements.value().remaining() == 2) {
                elements.value().octet("progress location");
                inBand = (elements.value().octet("progress description") & 0x7f) == IN_BAND_AVAILABLE;
            }
        }
        return inBand;
    }

    private static char readKey(MessageReader in) throws ProtocolViolation {
        if (in.octet("keypad facility") != KEYPAD_FACILITY) {
            throw new ProtocolViolation(Cause.INVALID_MANDATORY_INFORMATION, "keypad facility is missing");
        }
        char key = (char) (in.octet("key") & 0x7f);
        if (!CallControl.isKey(key)) {
            throw new ProtocolViolation(
                    Cause.INVALID_MANDATORY_INFORMATION, "key " + (int) key + " is none of 0-9 * # A-D");
        }
        return key;
    }

    /** Reads over what follows; a bearer capability may stand in several messages, and all ours carry speech. */
    private static void checkOptional(MessageReader in) throws ProtocolViolation {
        OptionalElements elements =
                new OptionalElements(in, FixedElements.CALL_CONTROL, BEARER_CAPABILITY, BACKUP_BEARER);
        while (elements.next() >= 0) {
            continue;
        }
    }
}
