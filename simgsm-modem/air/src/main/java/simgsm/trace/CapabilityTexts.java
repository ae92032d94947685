package simgsm.trace;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import simgsm.air.CallControl;
import simgsm.air.Direction;
import simgsm.air.Layer3Message;
import simgsm.air.MessageReader;
import simgsm.air.MobilityManagement;
import simgsm.air.OptionalElements;
import simgsm.air.OptionalElements.FixedElements;
import simgsm.air.ProtocolViolation;
import simgsm.air.RadioResource;
import simgsm.octets.OctetString;
import simgsm.trace.MessageText.Field;

/**
 * The capabilities of a terminal in words. No part of the suite depends on them, so the messages' records leave them out,
 * and they are read from the octets here.
 */
final class CapabilityTexts {
    private static final int BEARER_CAPABILITY = 0x04;
    private static final int BACKUP_BEARER = 0x3b;
    private static final int EXTENSION = 0x80;
    /** Information transfer capabilities (TS 24.008, 10.5.4.5) by code. */
    private static final List<String> TRANSFERS =
            List.of("speech", "unrestricted digital", "3.1 kHz audio", "fax", "reserved", "other", "reserved", "other");
    /** Radio channel requirements of a mobile, by code. */
    private static final List<String> RATES =
            List.of("reserved", "full rate only", "half rate preferred", "full rate preferred");
    /** Revision levels (10.5.1.5) by code. */
    private static final List<String> REVISIONS = List.of("phase 1", "phase 2", "release 99 or later", "reserved");
    /** Index of the classmark octet: after the message type, after the location area, after the CM service type. */
    private static final int AFTER_TYPE = 2;

    private static final int AFTER_AREA = 8;
    private static final int AFTER_SERVICE = 4;

    private CapabilityTexts() {}

    /** @param octets a message that has been decoded as the given one */
    static void add(List<Field> fields, Layer3Message message, OctetString octets, Direction direction)
            throws ProtocolViolation {
        if (message instanceof CallControl.Setup) {
            addBearer(fields, new MessageReader(octets), direction);
        } else if (message instanceof MobilityManagement.LocationUpdatingRequest) {
            addClassmark(fields, octets, AFTER_AREA);
        } else if (message instanceof MobilityManagement.ImsiDetachIndication) {
            addClassmark(fields, octets, AFTER_TYPE);
        } else if (message instanceof MobilityManagement.CmServiceRequest
                || message instanceof RadioResource.PagingResponse) {
            addClassmark(fields, octets, AFTER_SERVICE);
        }
    }

    private static void addBearer(List<Field> fields, MessageReader in, Direction direction) throws ProtocolViolation {
        in.part(2, "header");
        Optional<MessageReader> bearer = new OptionalElements(
                        in, FixedElements.CALL_CONTROL, BEARER_CAPABILITY, BACKUP_BEARER)
                .first(BEARER_CAPABILITY)
                .filter(MessageReader::hasMore);
        if (bearer.isPresent()) {
            fields.add(new Field("bearer capability", bearer(bearer.get(), direction)));
        }
    }

    private static String bearer(MessageReader in, Direction direction) throws ProtocolViolation {
        int octet = in.octet("bearer capability");
        List<String> words = new ArrayList<>();
        words.add(TRANSFERS.get(octet & 0x07));
        if (direction == Direction.UPLINK) {
            words.add(RATES.get(octet >> 5 & 0x03));
        }
        StringBuilder versions = new StringBuilder();
        while ((octet & EXTENSION) == 0 && in.hasMore()) {
            octet = in.octet("speech version");
            versions.append(' ').append(speechVersion(octet & 0x0f));
        }
        if (versions.length() > 0) {
            words.add("versions" + versions);
        }
        return String.join(", ", words);
    }

    /** FR3 is full rate speech version 3: odd codes are half rate, versions count from 1. */
    private static String speechVersion(int code) {
        return (code % 2 == 0 ? "FR" : "HR") + (code / 2 + 1);
    }

    private static void addClassmark(List<Field> fields, OctetString octets, int index) {
        int classmark = octets.octet(index);
        fields.add(new Field(
                "classmark", REVISIONS.get(classmark >> 5 & 0x03) + ", power class " + ((classmark & 0x07) + 1)));
    }
}
