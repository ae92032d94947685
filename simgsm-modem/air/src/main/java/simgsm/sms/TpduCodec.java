package simgsm.sms;

import java.util.Optional;
import simgsm.air.Cause;
import simgsm.air.Direction;
import simgsm.air.MessageReader;
import simgsm.air.ProtocolViolation;
import simgsm.octets.OctetString;
import simgsm.octets.OctetWriter;
import simgsm.octets.Timestamp;

/** Converts transfer units to the octets of an RP-DATA and back (TS 23.040, 9.2.2). */
public final class TpduCodec {
    private static final int TYPE_MASK = 0x03;
    private static final int DELIVER = 0x00;
    private static final int SUBMIT = 0x01;
    private static final int STATUS_REPORT = 0x02;

    private static final int NO_MORE_MESSAGES = 0x04;
    private static final int REJECT_DUPLICATES = 0x04;
    private static final int STATUS_REPORT_BIT = 0x20;
    private static final int HAS_HEADER = 0x40;
    private static final int REPLY_PATH = 0x80;

    private static final int VALIDITY_ENHANCED = 1;
    private static final int VALIDITY_RELATIVE = 2;
    private static final int VALIDITY_ABSOLUTE = 3;

    private TpduCodec() {}

    /** The octets of a unit. */
    public static OctetString encode(Tpdu tpdu) {
        OctetWriter out = new OctetWriter();
        if (tpdu instanceof SubmitTpdu submit) {
            writeSubmit(out, submit);
        } else if (tpdu instanceof DeliverTpdu deliver) {
            writeDeliver(out, deliver);
        } else {
            writeReport(out, (StatusReportTpdu) tpdu);
        }
        return out.toOctetString();
    }

    /**
     * The unit in these octets.
     *
     * @param direction selects the meaning of types: SUBMIT is uplink, DELIVER and STATUS-REPORT are downlink
     * @throws ProtocolViolation for any other or broken unit
     */
    public static Tpdu decode(OctetString octets, Direction direction) throws ProtocolViolation {
        MessageReader in = new MessageReader(octets);
        int first = in.octet("first octet");
        int type = first & TYPE_MASK;
        if (direction == Direction.UPLINK && type == SUBMIT) {
            return readSubmit(first, in);
        }
        if (direction == Direction.DOWNLINK && type == DELIVER) {
            return readDeliver(first, in);
        }
        if (direction == Direction.DOWNLINK && type == STATUS_REPORT) {
            return readReport(first, in);
        }
        throw new ProtocolViolation(
                Cause.MESSAGE_TYPE_NON_EXISTENT, "TP message type " + type + " " + direction + " is not supported");
    }

    private static void writeSubmit(OctetWriter out, SubmitTpdu submit) {
        int format = submit.validity().map(TpduCodec::validityFormat).orElse(0);
        out.octet(SUBMIT
                | format << 3
                | bit(submit.rejectDuplicates(), REJECT_DUPLICATES)
                | bit(submit.statusReportRequest(), STATUS_REPORT_BIT)
                | bit(submit.userData().hasHeader(), HAS_HEADER)
                | bit(submit.replyPath(), REPLY_PATH));
        out.octet(submit.reference());
        submit.destination().write(out);
        out.octet(submit.protocolIdentifier()).octet(submit.userData().coding().octet());
        submit.validity().ifPresent(validity -> writeValidity(out, validity));
        writeUserData(out, submit.userData());
    }

    private static void writeDeliver(OctetWriter out, DeliverTpdu deliver) {
        out.octet(DELIVER
                | bit(!deliver.moreMessages(), NO_MORE_MESSAGES)
                | bit(deliver.statusReportIndication(), STATUS_REPORT_BIT)
                | bit(deliver.userData().hasHeader(), HAS_HEADER)
                | bit(deliver.replyPath(), REPLY_PATH));
        deliver.originator().write(out);
        out.octet(deliver.protocolIdentifier())
                .octet(deliver.userData().coding().octet());
        out.string(deliver.timestamp().octets());
        writeUserData(out, deliver.userData());
    }

    private static void writeReport(OctetWriter out, StatusReportTpdu report) {
        out.octet(STATUS_REPORT | bit(!report.moreMessages(), NO_MORE_MESSAGES)).octet(report.reference());
        report.recipient().write(out);
        out.string(report.timestamp().octets())
                .string(report.discharged().octets())
                .octet(report.status());
    }

    private static int bit(boolean set, int mask) {
        return set ? mask : 0;
    }

    private static int validityFormat(ValidityPeriod validity) {
        if (validity instanceof ValidityPeriod.Relative) {
            return VALIDITY_RELATIVE;
        }
        return validity instanceof ValidityPeriod.Absolute ? VALIDITY_ABSOLUTE : VALIDITY_ENHANCED;
    }

    private static void writeValidity(OctetWriter out, ValidityPeriod validity) {
        if (validity instanceof ValidityPeriod.Relative relative) {
            out.octet(relative.octet());
        } else if (validity instanceof ValidityPeriod.Absolute absolute) {
            out.string(absolute.time().octets());
        } else {
            out.string(((ValidityPeriod.Enhanced) validity).octets());
        }
    }

    private static void writeUserData(OctetWriter out, UserData userData) {
        out.octet(userData.length()).string(userData.octets());
    }

    private static SubmitTpdu readSubmit(int first, MessageReader in) throws ProtocolViolation {
        int reference = in.octet("TP-MR");
        SmsAddress destination = SmsAddress.read(in);
        int protocolIdentifier = in.octet("TP-PID");
        DataCodingScheme coding = new DataCodingScheme(in.octet("TP-DCS"));
        Optional<ValidityPeriod> validity = readValidity(first >> 3 & 0x03, in);
        return new SubmitTpdu(
                (first & REJECT_DUPLICATES) != 0,
                (first & STATUS_REPORT_BIT) != 0,
                (first & REPLY_PATH) != 0,
                reference,
                destination,
                protocolIdentifier,
                validity,
                readUserData(first, coding, in));
    }

    private static DeliverTpdu readDeliver(int first, MessageReader in) throws ProtocolViolation {
        SmsAddress originator = SmsAddress.read(in);
        int protocolIdentifier = in.octet("TP-PID");
        DataCodingScheme coding = new DataCodingScheme(in.octet("TP-DCS"));
        Timestamp timestamp = readTimestamp(in);
        return new DeliverTpdu(
                (first & NO_MORE_MESSAGES) == 0,
                (first & STATUS_REPORT_BIT) != 0,
                (first & REPLY_PATH) != 0,
                originator,
                protocolIdentifier,
                timestamp,
                readUserData(first, coding, in));
    }

    private static StatusReportTpdu readReport(int first, MessageReader in) throws ProtocolViolation {
        int reference = in.octet("TP-MR");
        SmsAddress recipient = SmsAddress.read(in);
        Timestamp timestamp = readTimestamp(in);
        Timestamp discharged = readTimestamp(in);
        return new StatusReportTpdu(
                (first & NO_MORE_MESSAGES) == 0, reference, recipient, timestamp, discharged, in.octet("TP-ST"));
    }

    private static Optional<ValidityPeriod> readValidity(int format, MessageReader in) throws ProtocolViolation {
        return switch (format) {
            case VALIDITY_RELATIVE -> Optional.of(new ValidityPeriod.Relative(in.octet("TP-VP")));
            case VALIDITY_ABSOLUTE -> Optional.of(new ValidityPeriod.Absolute(readTimestamp(in)));
            case VALIDITY_ENHANCED -> Optional.of(new ValidityPeriod.Enhanced(in.string(Timestamp.LENGTH, "TP-VP")));
            default -> Optional.empty();
        };
    }

    private static Timestamp readTimestamp(MessageReader in) throws ProtocolViolation {
        return new Timestamp(in.string(Timestamp.LENGTH, "time stamp"));
    }

    private static UserData readUserData(int first, DataCodingScheme coding, MessageReader in)
            throws ProtocolViolation {
        int length = in.octet("TP-UDL");
        OctetString octets = in.string(UserData.octetCount(coding, length), "TP-UD");
        try {
            return new UserData((first & HAS_HEADER) != 0, coding, length, octets);
        } catch (IllegalArgumentException wrong) {
            throw ProtocolViolation.invalid(wrong.getMessage());
        }
    }
}
