package simgsm.sms;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simgsm.air.Msisdn;
import simgsm.octets.OctetString;

class ReassemblerTest {
    private static final SmsAddress ALICE = SmsAddress.of(new Msisdn("5550100"));
    private static final SmsAddress BOB = SmsAddress.of(new Msisdn("5550101"));
    private static final String TEXT = "Avanza 20 cm, gira 90 grados. ".repeat(20) + "€";

    private final Reassembler reassembler = new Reassembler();

    @Test
    void aMessageOfOnePartIsThereAtOnce() {
        assertEquals(Optional.of("hello"), reassembler.accept(ALICE, UserData.of("hello"), 0));
    }

    @Test
    void partsMayComeInAnyOrderAndTwice() {
        List<UserData> parts = new ArrayList<>(MessageSplitter.split(TEXT, 1));
        Collections.shuffle(parts, new Random(1));
        UserData last = parts.remove(parts.size() - 1);
        for (UserData part : parts) {
            assertEquals(Optional.empty(), reassembler.accept(ALICE, part, 0));
            assertEquals(Optional.empty(), reassembler.accept(ALICE, part, 0));
        }

        assertEquals(Optional.of(TEXT), reassembler.accept(ALICE, last, 0));
        assertEquals(Optional.empty(), reassembler.accept(ALICE, last, 0));
    }

    @Test
    void sendersWithTheSameReferenceAreKeptApart() {
        List<UserData> fromAlice = MessageSplitter.split("a".repeat(200), 1);
        List<UserData> fromBob = MessageSplitter.split("b".repeat(200), 1);
        reassembler.accept(ALICE, fromAlice.get(0), 0);
        reassembler.accept(BOB, fromBob.get(1), 0);

        assertEquals(Optional.of("a".repeat(200)), reassembler.accept(ALICE, fromAlice.get(1), 0));
        assertEquals(Optional.of("b".repeat(200)), reassembler.accept(BOB, fromBob.get(0), 0));
    }

    @Test
    void aReferenceThatComesRoundAgainBeginsANewMessage() {
        List<UserData> old = MessageSplitter.split("a".repeat(200), 1);
        List<UserData> young = MessageSplitter.split("b".repeat(200), 1);
        reassembler.accept(ALICE, old.get(0), 0);

        assertEquals(Optional.empty(), reassembler.accept(ALICE, young.get(0), 0));
        assertEquals(Optional.of("b".repeat(200)), reassembler.accept(ALICE, young.get(1), 0));
    }

    @Test
    void memoryIsBoundedAndTheOldestGoesFirst() {
        for (int reference = 0; reference <= Reassembler.MAX_MESSAGES; reference++) {
            reassembler.accept(
                    ALICE, MessageSplitter.split("a".repeat(200), reference).get(0), 0);
        }

        assertEquals(
                Optional.empty(),
                reassembler.accept(
                        ALICE, MessageSplitter.split("a".repeat(200), 0).get(1), 0));
        assertEquals(
                Optional.of("a".repeat(200)),
                reassembler.accept(
                        ALICE, MessageSplitter.split("a".repeat(200), 2).get(1), 0));
    }

    @Test
    void anUnfinishedMessageIsForgottenAfterADay() {
        List<UserData> parts = MessageSplitter.split("a".repeat(200), 1);
        reassembler.accept(ALICE, parts.get(0), 5);

        assertEquals(Optional.empty(), reassembler.accept(ALICE, parts.get(1), 6 + Reassembler.EXPIRY_NANOS));
        assertEquals(
                Optional.of("a".repeat(200)), reassembler.accept(ALICE, parts.get(0), 6 + Reassembler.EXPIRY_NANOS));
    }

    @ParameterizedTest
    @CsvSource({"000102,0x000102", "62696e,bin", "0a0d41,'\n\rA'", "80,0x80", "e9,é", "'',''"})
    void octetsThatAreNoTextAreShownAsSuch(String octets, String shown) {
        OctetString body = OctetString.ofHex(octets);
        UserData data = new UserData(false, DataCodingScheme.OCTETS, body.length(), body);
        assertEquals(Optional.of(shown), new Reassembler().accept(SmsAddress.ofLetters("App"), data, 0));
    }
}
