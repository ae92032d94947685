package simgsm.trace;

import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import simgsm.air.Direction;
import simgsm.air.ProtocolViolation;
import simgsm.octets.OctetString;
import simgsm.octets.Timestamp;
import simgsm.sms.Alphabet;
import simgsm.sms.Concatenation;
import simgsm.sms.DataCodingScheme;
import simgsm.sms.DeliverTpdu;
import simgsm.sms.DeliveryStatus;
import simgsm.sms.SmsAddress;
import simgsm.sms.StatusReportTpdu;
import simgsm.sms.SubmitTpdu;
import simgsm.sms.Tpdu;
import simgsm.sms.TpduCodec;
import simgsm.sms.UserData;
import simgsm.sms.ValidityPeriod;
import simgsm.trace.MessageText.Field;

/** Transfer units of short messages in words. */
public final class TpduText {
    private static final int FIRST_OCTET = 1;

    private final FieldList fields;
    private final FieldTexts texts;
    private final OctetString octets;
    private final int start;
    /** Octets of the unit that have fields. */
    private int taken = FIRST_OCTET;

    private TpduText(FieldList fields, OctetString octets, int start) {
        this.fields = fields;
        this.texts = fields.texts();
        this.octets = octets;
        this.start = start;
    }

    /** One line per field, {@code name: value}, in order of the octets; the unit's name is the first. */
    public static String of(Tpdu tpdu, Locale language) {
        FieldList fields = new FieldList(FieldTexts.in(language));
        new TpduText(fields, TpduCodec.encode(tpdu), 0).add(tpdu);
        return fields.fields().stream()
                .map(field -> field.name().equals("TP-MTI") ? field.value() : field.toString())
                .collect(Collectors.joining("\n"));
    }

    /** Adds the fields of a unit, its text first. @param start index of the unit in the message */
    static void add(FieldList fields, OctetString octets, Direction direction, int start) throws ProtocolViolation {
        Tpdu tpdu = TpduCodec.decode(octets, direction);
        int first = fields.fields().size();
        new TpduText(fields, octets, start).add(tpdu);
        List<Field> added = fields.fields().subList(first, fields.fields().size());
        Field last = added.get(added.size() - 1);
        if (last.name().equals(fields.texts().of("text"))) {
            Collections.rotate(added, 1);
        }
    }

    private void add(Tpdu tpdu) {
        if (tpdu instanceof SubmitTpdu submit) {
            addSubmit(submit);
        } else if (tpdu instanceof DeliverTpdu deliver) {
            addDeliver(deliver);
        } else {
            addReport((StatusReportTpdu) tpdu);
        }
    }

    private void addSubmit(SubmitTpdu submit) {
        flag("TP-MTI", "SMS-SUBMIT");
        flag("TP-RD", texts.of(submit.rejectDuplicates() ? "rejectDuplicates" : "takeDuplicates"));
        flag("TP-SRR", texts.of(submit.statusReportRequest() ? "statusReportRequested" : "noStatusReport"));
        addReplyPath(submit.replyPath());
        next("TP-MR", submit.reference(), 1);
        next("TP-DA", address(submit.destination()), addressLength());
        next("TP-PID", submit.protocolIdentifier(), 1);
        next("TP-DCS", coding(submit.userData().coding()), 1);
        submit.validity()
                .ifPresent(validity -> next(
                        "TP-VP",
                        validity(validity),
                        validity instanceof ValidityPeriod.Relative ? 1 : Timestamp.LENGTH));
        addUserData(submit.userData());
    }

    private void addDeliver(DeliverTpdu deliver) {
        flag("TP-MTI", "SMS-DELIVER");
        flag("TP-MMS", more(deliver.moreMessages()));
        flag("TP-SRI", texts.of(deliver.statusReportIndication() ? "statusReportIndicated" : "noStatusReport"));
        addReplyPath(deliver.replyPath());
        next("TP-OA", address(deliver.originator()), addressLength());
        next("TP-PID", deliver.protocolIdentifier(), 1);
        next("TP-DCS", coding(deliver.userData().coding()), 1);
        next("TP-SCTS", deliver.timestamp().toOffsetDateTime(), Timestamp.LENGTH);
        addUserData(deliver.userData());
    }

    private void addReport(StatusReportTpdu report) {
        flag("TP-MTI", "SMS-STATUS-REPORT");
        flag("TP-MMS", more(report.moreMessages()));
        next("TP-MR", report.reference(), 1);
        next("TP-RA", address(report.recipient()), addressLength());
        next("TP-SCTS", report.timestamp().toOffsetDateTime(), Timestamp.LENGTH);
        next("TP-DT", report.discharged().toOffsetDateTime(), Timestamp.LENGTH);
        next("TP-ST", report.status() + " " + DeliveryStatus.title(report.status()), 1);
    }

    /** Adds a field of the first octet. */
    private void flag(String name, String value) {
        fields.addNamed(name, value, start, start + FIRST_OCTET);
    }

    /** Octets of the next address: number of digits, type, and two digits per octet. */
    private void next(String name, Object value, int length) {
        fields.addNamed(name, String.valueOf(value), start + taken, start + taken + length);
        taken += length;
    }

    /** Octets of the address that is next: number of digits, type, and two digits an octet. */
    private int addressLength() {
        return 2 + (octets.octet(taken) + 1) / 2;
    }

    private void addReplyPath(boolean replyPath) {
        if (replyPath) {
            flag("TP-RP", texts.of("replyPathSet"));
        }
    }

    private String more(boolean moreMessages) {
        return texts.of(moreMessages ? "moreMessages" : "noMoreMessages");
    }

    /** Type of number as in TS 23.040, 9.1.2.5. */
    private String address(SmsAddress address) {
        return texts.of("address", address.value(), texts.of("number." + address.type()), address.plan());
    }

    private String coding(DataCodingScheme coding) {
        String messageClass = coding.messageClass().isPresent()
                ? ", " + texts.of("messageClass", coding.messageClass().getAsInt())
                : "";
        return coding.octet() + " " + texts.of(coding.alphabet().name()) + messageClass;
    }

    private String validity(ValidityPeriod validity) {
        if (validity instanceof ValidityPeriod.Relative relative) {
            long minutes = relative.duration().toMinutes();
            return relative.octet() + ", " + (minutes % 60 == 0 ? minutes / 60 + " h" : minutes + " min");
        }
        return validity instanceof ValidityPeriod.Absolute absolute
                ? texts.of("until", absolute.time().toOffsetDateTime())
                : texts.of("enhanced", ((ValidityPeriod.Enhanced) validity).octets());
    }

    private void addUserData(UserData userData) {
        boolean isSeptets = userData.coding().alphabet() == Alphabet.GSM_7BIT;
        next("TP-UDL", texts.of(isSeptets ? "septets" : "octets", userData.length()), 1);
        if (userData.hasHeader()) {
            String place = userData.concatenation().map(this::place).orElseGet(() -> texts.of("noConcatenation"));
            next("TP-UDH", place, 1 + octets.octet(taken));
        }
        boolean isData = userData.coding().alphabet() == Alphabet.OCTETS;
        next(texts.of(isData ? "data" : "text"), isData ? userData.body() : userData.text(), octets.length() - taken);
    }

    private String place(Concatenation place) {
        return texts.of("part", place.part(), place.total(), place.reference());
    }
}
