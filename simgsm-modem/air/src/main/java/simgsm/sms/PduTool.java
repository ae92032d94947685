package simgsm.sms;

import java.util.Locale;
import java.util.Optional;
import java.util.StringJoiner;
import simgsm.air.Direction;
import simgsm.air.ProtocolViolation;
import simgsm.octets.OctetString;

/** The words of {@code pdu encode} and {@code pdu decode}. */
public final class PduTool {
    private PduTool() {}

    /**
     * One user part a line, {@code udhi,dcs,udl,ud-hex}, all numbers decimal.
     *
     * @param reference of the message, 0 to 255; shows only when there are several parts
     * @throws IllegalArgumentException for a text of more than 255 parts
     */
    public static String encode(String text, int reference) {
        StringJoiner lines = new StringJoiner("\n");
        for (UserData part : MessageSplitter.split(text, reference)) {
            lines.add((part.hasHeader() ? 1 : 0) + "," + part.coding().octet() + "," + part.length() + ","
                    + part.octets());
        }
        return lines.toString();
    }

    /**
     * A SUBMIT, DELIVER or STATUS-REPORT in words, a field a line as {@code name: value}. Blanks in the digits are
     * ignored.
     *
     * @throws IllegalArgumentException for what is not hexadecimal, or no such unit; the text says why
     */
    public static String decode(String hex) {
        OctetString octets = octets(hex);
        try {
            Direction direction = isSubmit(octets) ? Direction.UPLINK : Direction.DOWNLINK;
            return words(TpduCodec.decode(octets, direction));
        } catch (ProtocolViolation violation) {
            throw new IllegalArgumentException("not a TPDU: " + violation.getMessage(), violation);
        }
    }

    private static OctetString octets(String hex) {
        try {
            return OctetString.ofHex(hex.replaceAll("\\s", ""));
        } catch (IllegalArgumentException wrong) {
            throw new IllegalArgumentException("a TPDU is an even number of hexadecimal digits", wrong);
        }
    }

    private static boolean isSubmit(OctetString octets) {
        return octets.length() > 0 && (octets.toArray()[0] & 0x03) == 1;
    }

    /** The fields in the order of the octets. */
    public static String words(Tpdu tpdu) {
        StringJoiner lines = new StringJoiner("\n");
        if (tpdu instanceof SubmitTpdu submit) {
            addSubmit(lines, submit);
        } else if (tpdu instanceof DeliverTpdu deliver) {
            addDeliver(lines, deliver);
        } else {
            addReport(lines, (StatusReportTpdu) tpdu);
        }
        return lines.toString();
    }

    private static void addSubmit(StringJoiner lines, SubmitTpdu submit) {
        lines.add("SMS-SUBMIT");
        lines.add("TP-RD: " + (submit.rejectDuplicates() ? "reject duplicates" : "take duplicates"));
        lines.add("TP-SRR: " + (submit.statusReportRequest() ? "status report requested" : "no status report"));
        addReplyPath(lines, submit.replyPath());
        lines.add("TP-MR: " + submit.reference());
        lines.add("TP-DA: " + address(submit.destination()));
        lines.add("TP-PID: " + submit.protocolIdentifier());
        lines.add("TP-DCS: " + coding(submit.userData().coding()));
        submit.validity().ifPresent(validity -> lines.add("TP-VP: " + validity(validity)));
        addUserData(lines, submit.userData());
    }

    private static void addDeliver(StringJoiner lines, DeliverTpdu deliver) {
        lines.add("SMS-DELIVER");
        lines.add("TP-MMS: " + more(deliver.moreMessages()));
        lines.add("TP-SRI: "
                + (deliver.statusReportIndication() ? "the sender gets a status report" : "no status report"));
        addReplyPath(lines, deliver.replyPath());
        lines.add("TP-OA: " + address(deliver.originator()));
        lines.add("TP-PID: " + deliver.protocolIdentifier());
        lines.add("TP-DCS: " + coding(deliver.userData().coding()));
        lines.add("TP-SCTS: " + deliver.timestamp().toOffsetDateTime());
        addUserData(lines, deliver.userData());
    }

    private static void addReport(StringJoiner lines, StatusReportTpdu report) {
        lines.add("SMS-STATUS-REPORT");
        lines.add("TP-MMS: " + more(report.moreMessages()));
        lines.add("TP-MR: " + report.reference());
        lines.add("TP-RA: " + address(report.recipient()));
        lines.add("TP-SCTS: " + report.timestamp().toOffsetDateTime());
        lines.add("TP-DT: " + report.discharged().toOffsetDateTime());
        lines.add("TP-ST: " + report.status() + " " + DeliveryStatus.title(report.status()));
    }

    private static void addReplyPath(StringJoiner lines, boolean replyPath) {
        if (replyPath) {
            lines.add("TP-RP: reply path set");
        }
    }

    private static String more(boolean moreMessages) {
        return moreMessages ? "more messages wait" : "no more messages";
    }

    private static String address(SmsAddress address) {
        String[] types = {
            "unknown",
            "international",
            "national",
            "network specific",
            "subscriber",
            "alphanumeric",
            "abbreviated",
            "reserved"
        };
        return address.value() + " (" + types[address.type()] + ", plan " + address.plan() + ")";
    }

    private static String coding(DataCodingScheme coding) {
        String[] alphabets = {"GSM 7-bit", "8-bit data", "UCS-2"};
        String messageClass = coding.messageClass().isPresent()
                ? ", class " + coding.messageClass().getAsInt()
                : "";
        return coding.octet() + " " + alphabets[coding.alphabet().ordinal()] + messageClass;
    }

    private static String validity(ValidityPeriod validity) {
        if (validity instanceof ValidityPeriod.Relative relative) {
            return relative.octet() + ", " + hours(relative.duration().toMinutes());
        }
        return validity instanceof ValidityPeriod.Absolute absolute
                ? "until " + absolute.time().toOffsetDateTime()
                : "enhanced " + ((ValidityPeriod.Enhanced) validity).octets();
    }

    private static String hours(long minutes) {
        return minutes % 60 == 0 ? minutes / 60 + " h" : minutes + " min";
    }

    private static void addUserData(StringJoiner lines, UserData userData) {
        String unit = userData.coding().alphabet() == Alphabet.GSM_7BIT ? " septets" : " octets";
        lines.add("TP-UDL: " + userData.length() + unit);
        Optional<Concatenation> place = userData.concatenation();
        if (userData.hasHeader()) {
            lines.add("TP-UDH: " + place.map(PduTool::place).orElse("no concatenation"));
        }
        boolean isData = userData.coding().alphabet() == Alphabet.OCTETS;
        lines.add(isData ? "data: " + userData.body() : "text: " + userData.text());
    }

    private static String place(Concatenation place) {
        return String.format(
                Locale.ROOT, "part %d of %d, reference %d", place.part(), place.total(), place.reference());
    }
}
