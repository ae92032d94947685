package simgsm.trace;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import simgsm.sms.Alphabet;
import simgsm.sms.Concatenation;
import simgsm.sms.DataCodingScheme;
import simgsm.sms.DeliverTpdu;
import simgsm.sms.DeliveryStatus;
import simgsm.sms.SmsAddress;
import simgsm.sms.StatusReportTpdu;
import simgsm.sms.SubmitTpdu;
import simgsm.sms.Tpdu;
import simgsm.sms.UserData;
import simgsm.sms.ValidityPeriod;

/** Transfer units of short messages in words. */
public final class TpduText {
    /** Type of number (TS 23.040, 9.1.2.5) by code. */
    private static final List<String> ADDRESS_TYPES = List.of(
            "unknown",
            "international",
            "national",
            "network specific",
            "subscriber",
            "alphanumeric",
            "abbreviated",
            "reserved");

    private TpduText() {}

    /** A line for each field, {@code name: value}, in the order of the octets; the unit's name comes first. */
    public static String of(Tpdu tpdu) {
        return String.join("\n", lines(tpdu));
    }

    private static List<String> lines(Tpdu tpdu) {
        List<String> lines = new ArrayList<>();
        if (tpdu instanceof SubmitTpdu submit) {
            addSubmit(lines, submit);
        } else if (tpdu instanceof DeliverTpdu deliver) {
            addDeliver(lines, deliver);
        } else {
            addReport(lines, (StatusReportTpdu) tpdu);
        }
        return lines;
    }

    /** The lines of {@link #of} as fields; the unit's name is the value of TP-MTI. */
    public static List<MessageText.Field> fieldsOf(Tpdu tpdu) {
        return lines(tpdu).stream().map(TpduText::field).toList();
    }

    private static MessageText.Field field(String line) {
        int colon = line.indexOf(": ");
        return colon < 0
                ? new MessageText.Field("TP-MTI", line)
                : new MessageText.Field(line.substring(0, colon), line.substring(colon + 2));
    }

    private static void addSubmit(List<String> lines, SubmitTpdu submit) {
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

    private static void addDeliver(List<String> lines, DeliverTpdu deliver) {
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

    private static void addReport(List<String> lines, StatusReportTpdu report) {
        lines.add("SMS-STATUS-REPORT");
        lines.add("TP-MMS: " + more(report.moreMessages()));
        lines.add("TP-MR: " + report.reference());
        lines.add("TP-RA: " + address(report.recipient()));
        lines.add("TP-SCTS: " + report.timestamp().toOffsetDateTime());
        lines.add("TP-DT: " + report.discharged().toOffsetDateTime());
        lines.add("TP-ST: " + report.status() + " " + DeliveryStatus.title(report.status()));
    }

    private static void addReplyPath(List<String> lines, boolean replyPath) {
        if (replyPath) {
            lines.add("TP-RP: reply path set");
        }
    }

    private static String more(boolean moreMessages) {
        return moreMessages ? "more messages wait" : "no more messages";
    }

    private static String address(SmsAddress address) {
        return address.value() + " (" + ADDRESS_TYPES.get(address.type()) + ", plan " + address.plan() + ")";
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

    private static void addUserData(List<String> lines, UserData userData) {
        String unit = userData.coding().alphabet() == Alphabet.GSM_7BIT ? " septets" : " octets";
        lines.add("TP-UDL: " + userData.length() + unit);
        Optional<Concatenation> place = userData.concatenation();
        if (userData.hasHeader()) {
            lines.add("TP-UDH: " + place.map(TpduText::place).orElse("no concatenation"));
        }
        boolean isData = userData.coding().alphabet() == Alphabet.OCTETS;
        lines.add(isData ? "data: " + userData.body() : "text: " + userData.text());
    }

    private static String place(Concatenation place) {
        return String.format(
                Locale.ROOT, "part %d of %d, reference %d", place.part(), place.total(), place.reference());
    }
}
