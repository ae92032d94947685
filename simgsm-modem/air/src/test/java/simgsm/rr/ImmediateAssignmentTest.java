package simgsm.rr;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import simgsm.air.ChannelDescription;
import simgsm.air.ChannelNumber;
import simgsm.air.ProtocolViolation;
import simgsm.octets.OctetString;

class ImmediateAssignmentTest {
    private static final RequestReference REFERENCE = new RequestReference(0x07, 0x1234);

    /** The octets that osmo-bsc 1.9 sends for its first SDCCH of ARFCN 100, training sequence code 2. */
    @Test
    void theRealGrantIsWrittenAndRead() throws ProtocolViolation {
        ImmediateAssignment grant =
                new ImmediateAssignment(new ChannelDescription(ChannelNumber.ofCode(0x20), 2, 100), REFERENCE, 0);
        OctetString octets = OctetString.ofHex("2d063f03204064071234" + "0000" + "2b".repeat(11));
        assertEquals(octets, grant.encode());
        assertTrue(ImmediateAssignment.isOne(octets));
        assertFalse(ImmediateAssignmentReject.isOne(octets));
        assertEquals(grant, ImmediateAssignment.decode(octets));
    }

    @Test
    void aRefusalFillsItsFourPlaces() throws ProtocolViolation {
        RequestReference second = new RequestReference(0xe1, 5);
        ImmediateAssignmentReject refusal = new ImmediateAssignmentReject(List.of(REFERENCE, second), 10);
        OctetString octets = OctetString.ofHex("4d063a03" + "0712340a" + "e100050a".repeat(3) + "2b".repeat(3));
        assertEquals(octets, refusal.encode());
        assertTrue(ImmediateAssignmentReject.isOne(octets));
        assertFalse(ImmediateAssignment.isOne(octets));
        assertEquals(refusal, ImmediateAssignmentReject.decode(octets));
    }

    @Test
    void aCutMessageIsRefused() {
        assertThrows(ProtocolViolation.class, () -> ImmediateAssignment.decode(OctetString.ofHex("2d063f032040")));
        assertThrows(ProtocolViolation.class, () -> ImmediateAssignmentReject.decode(OctetString.ofHex("4d063a03")));
    }
}
