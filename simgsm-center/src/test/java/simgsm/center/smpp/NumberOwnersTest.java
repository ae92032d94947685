package simgsm.center.smpp;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static simgsm.center.smpp.SmppClient.text;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simgsm.octets.OctetString;
import simgsm.smpp.SmppAddress;
import simgsm.smpp.SmppCommand;
import simgsm.smpp.SmppMessage;
import simgsm.smpp.SmppPdu;
import simgsm.smpp.SmppStatus;

/** Who may serve and send as which number: the lines {@code id.numbers}, and the numbers of subscribers. */
class NumberOwnersTest extends SmppStage {
    private static final String PHONE = "5550100";

    /** alice and phone have lists, bob and carol have none. */
    private void admit() {
        network.server.admit(SmppUsers.only(Map.of(
                "alice",
                "",
                "alice.numbers",
                "7000-7099, 6245,Alarm",
                "bob",
                "",
                "carol",
                "",
                "desk",
                "",
                "desk.numbers",
                PHONE + ",70123")));
        network.subscribers.add(PHONE);
        network.subscribers.add("5550101");
    }

    private TestCenter.Application bound(String systemId, String range) {
        TestCenter.Application application = network.open(true);
        assertEquals(SmppStatus.OK, bindReceiver(application, systemId, range));
        return application;
    }

    @ParameterizedTest
    @CsvSource({
        "alice, 7000,    0x00",
        "alice, 7099,    0x00",
        "alice, +6245,   0x00",
        "alice, 7100,    0x0d",
        "alice, 70000,   0x0d",
        "alice, 5550300, 0x0d",
        "alice, 70.*,    0x00",
        "alice, 705*,    0x00",
        "alice, 7.*,     0x0d",
        "alice, 555.*,   0x0d",
        "alice, '',      0x00",
        "bob,   7000,    0x0d",
        "bob,   6245,    0x0d",
        "bob,   7.*,     0x0d",
        "bob,   7050*,   0x0d",
        "bob,   71.*,    0x00",
        "bob,   7100,    0x00",
        "bob,   5550100, 0x0d",
        "bob,   5550101, 0x0d",
        "bob,   5550300, 0x00",
        "bob,   55503.*, 0x00",
        "desk,  5550100, 0x00",
        "desk,  5550101, 0x0d",
    })
    void anApplicationServesItsOwnNumbersAndNoOther(String systemId, String range, String status) {
        admit();
        assertEquals(Integer.decode(status), bindReceiver(network.open(true), systemId, range));
    }

    @ParameterizedTest
    @CsvSource({
        "alice, 1, 7000,    0x00",
        "alice, 1, +7042,   0x00",
        "alice, 5, Alarm,   0x00",
        "alice, 5, Fire,    0x0a",
        "alice, 1, 7100,    0x0a",
        "alice, 1, 5550100, 0x0a",
        "bob,   1, 7000,    0x0a",
        "bob,   5, Alarm,   0x0a",
        "bob,   5, ALARM,   0x0a",
        "bob,   5, Fire,    0x00",
        "bob,   1, 7100,    0x00",
        "bob,   1, 5550100, 0x0a",
        "bob,   5, 5550100, 0x0a",
        "bob,   0, +5550101, 0x0a",
        "desk,  1, 5550100, 0x00",
    })
    void anApplicationSendsAsItsOwnNumbersAndNames(String systemId, int type, String source, String status) {
        admit();
        TestCenter.Application sender = network.bound(SmppCommand.BIND_TRANSMITTER, systemId, "");
        sender.submit(
                2,
                SmppMessage.of(
                        new SmppAddress(type, type == 5 ? 0 : 1, source),
                        new SmppAddress(1, 1, SERVICE),
                        0,
                        0,
                        0,
                        OctetString.ofHex("41"),
                        List.of()));
        network.commit();
        assertEquals(
                Integer.decode(status),
                sender.last(SmppPdu.MessageResponse.class).status());
    }

    @Test
    void whatWaitsForAnApplicationIsNotGivenToAnother() {
        admit();
        TestCenter.Application sender = network.bound(SmppCommand.BIND_TRANSMITTER, "carol", "");
        List.of("7001", "70123", "7100").forEach(to -> sender.submit(1, text("1", to, to)));
        network.commit();
        assertEquals(List.of(), texts(bound("bob", "8*")));
        assertEquals(List.of("7001"), texts(bound("alice", "70*")), "70123 is desk's");
        assertEquals(List.of("70123"), texts(bound("desk", "70123")));
        assertEquals(List.of("7100"), texts(bound("bob", "71*")));
    }

    @Test
    void anApplicationThatListsNumbersServesNoOthersOfItsPrefix() {
        admit();
        TestCenter.Application alice = bound("alice", "70*");
        TestCenter.Application sender = network.bound(SmppCommand.BIND_TRANSMITTER, "carol", "");
        List.of("7001", "700", "70012").forEach(to -> sender.submit(1, text("1", to, to)));
        network.commit();
        assertEquals(List.of("7001"), texts(alice));
    }

    @Test
    void twoApplicationsWithListsOnOnePrefixGetEachItsOwn() {
        network.server.admit(SmppUsers.only(
                Map.of("a", "", "a.numbers", "7000-7099", "b", "", "b.numbers", "70000-70999", "sender", "")));
        TestCenter.Application a = bound("a", "70*");
        TestCenter.Application b = bound("b", "70*");
        TestCenter.Application sender = sender();
        List.of("7001", "70001", "7002", "70002").forEach(to -> sender.submit(1, text("1", to, to)));
        network.commit();
        assertEquals(List.of("7001", "7002"), texts(a));
        assertEquals(List.of("70001", "70002"), texts(b));
    }

    @Test
    void aNumberThatASubscriberRegistersUnderIsServedNoLonger() {
        TestCenter.Application exact = bound("bob", "5550300");
        TestCenter.Application prefix = bound("carol", "555*");
        TestCenter.Application sender = sender();
        List.of("5550300", "5550301").forEach(to -> sender.submit(1, text("1", to, "before")));
        network.commit();
        network.subscribers.addAll(List.of("5550300", "5550301"));
        List.of("5550300", "5550301", "5550302").forEach(to -> sender.submit(1, text("1", to, "after")));
        network.commit();
        assertEquals(List.of("before"), texts(exact));
        assertEquals(List.of("before", "after"), texts(prefix), "5550302 is no subscriber's");
        assertEquals(0x0d, bindReceiver(network.open(true), "bob", "5550300"));
    }

    @Test
    void withoutAFileAnApplicationServesWhatIsNoSubscribers() {
        network.subscribers.add(PHONE);
        assertEquals(SmppStatus.BIND_FAILED, bindReceiver(network.open(true), "any", PHONE));
        assertEquals(SmppStatus.OK, bindReceiver(network.open(true), "any", "7001"));
    }

    @ParameterizedTest
    @ValueSource(strings = {"7099-7000", "70-7099", "", "7000,,6245", "muchTooLongAName", "12345678901234567890x"})
    void aListThatIsNoneIsRefusedByItsLine(String list) {
        IllegalArgumentException refused = assertThrows(
                IllegalArgumentException.class, () -> SmppUsers.only(Map.of("alice", "", "alice.numbers", list)));
        assertTrue(refused.getMessage().startsWith("alice.numbers: "), refused.getMessage());
    }

    @ParameterizedTest
    @CsvSource({"7050, 7050", "'6000-6999,7099', 7099", "7000-7200, 7000-7200", "alarm, alarm"})
    void aNumberThatTwoApplicationsListIsRefused(String list, String named) {
        Map<String, String> lines = new HashMap<>(Map.of("alice", "", "bob", "", "alice.numbers", "7000-7099,Alarm"));
        lines.put("bob.numbers", list);
        IllegalArgumentException refused = assertThrows(IllegalArgumentException.class, () -> SmppUsers.only(lines));
        assertEquals("bob.numbers: " + named + " is listed by alice", refused.getMessage());
    }
}
