package simgsm.center.smpp;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static simgsm.center.smpp.SmppClient.text;
import static simgsm.center.smpp.SmppClient.with;
import static simgsm.center.smpp.SmppClient.withReceipt;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simgsm.center.smsc.WaitReason;
import simgsm.octets.OctetString;
import simgsm.smpp.SmppAddress;
import simgsm.smpp.SmppCodec;
import simgsm.smpp.SmppCommand;
import simgsm.smpp.SmppMessage;
import simgsm.smpp.SmppPdu;
import simgsm.smpp.SmppStatus;
import simgsm.smpp.Tlv;

/** submit_multi, schedule_delivery_time, replace_sm; cancel_sm and query_sm for submissions of several messages. */
class SmppOperationsTest extends SmppStage {
    private static final String OTHER_SERVICE = "5550301";

    private final TestCenter.Application receiver = receiver(SERVICE);
    private final TestCenter.Application sender = network.bound(SmppCommand.BIND_TRANSCEIVER, "sender", "");

    private static SmppAddress number(String digits) {
        return new SmppAddress(1, 1, digits);
    }

    private static SmppMessage scheduled(String text, String schedule, String validity) {
        SmppMessage m = withReceipt(text("1", SERVICE, text));
        return new SmppMessage(
                m.serviceType(),
                m.source(),
                m.destination(),
                m.esmClass(),
                m.protocolId(),
                m.priority(),
                schedule,
                validity,
                m.registeredDelivery(),
                m.replaceIfPresent(),
                m.dataCoding(),
                m.defaultMessageId(),
                m.shortMessage(),
                m.parameters());
    }

    private static SmppMessage ofThreeParts() {
        byte[] text = "a".repeat(400).getBytes(StandardCharsets.US_ASCII);
        return with(text("1", SERVICE, ""), "", 1, List.of(new Tlv(Tlv.MESSAGE_PAYLOAD, OctetString.of(text))));
    }

    private static SmppPdu.Replace replacement(String id, String text) {
        return new SmppPdu.Replace(
                9, id, number("1"), "", "", 1, 0, OctetString.of(text.getBytes(StandardCharsets.ISO_8859_1)));
    }

    private int statusOf(SmppPdu request) {
        sender.say(request);
        network.commit();
        return lastResponse().status();
    }

    private SmppPdu.Response lastResponse() {
        List<SmppPdu.Response> responses = sender.all(SmppPdu.Response.class);
        return responses.get(responses.size() - 1);
    }

    /** Time passes; the applications test their links, so that the centre does not. */
    private void pass(int seconds) {
        for (int left = seconds; left > 0; left -= 30) {
            network.passSeconds(Math.min(left, 30));
            for (TestCenter.Application each : List.of(receiver, sender)) {
                each.say(new SmppPdu.Plain(SmppCommand.ENQUIRE_LINK, 77));
                each.heard.removeIf(pdu -> pdu.sequence() == 77);
            }
        }
    }

    private int query(String id) {
        sender.say(new SmppPdu.Query(5, id, number("1")));
        return ((SmppPdu.QueryResponse) lastResponse()).state();
    }

    @Test
    void oneRequestReachesSeveralReceiversAndNamesTheOnesThatItDoesNot() {
        TestCenter.Application other = receiver(OTHER_SERVICE);
        List<SmppAddress> destinations = List.of(number(SERVICE), new SmppAddress(5, 0, "Bar"), number(OTHER_SERVICE));
        sender.say(new SmppPdu.SubmitMulti(7, withReceipt(text("1", "", "to all")), destinations));
        assertTrue(sender.heard.isEmpty(), "answered when stored");
        network.commit();
        assertEquals(
                new SmppPdu.SubmitMultiResponse(
                        SmppStatus.OK,
                        7,
                        "2",
                        List.of(new SmppPdu.Refused(new SmppAddress(5, 0, "Bar"), SmppStatus.INVALID_DESTINATION))),
                sender.last(SmppPdu.SubmitMultiResponse.class));
        assertEquals(List.of("to all"), texts(receiver));
        assertEquals(List.of("to all"), texts(other));
    }

    @Test
    void aMessageToSeveralReceiversHasOneIdAndAReceiptForEach() {
        TestCenter.Application other = receiver(OTHER_SERVICE);
        sender.say(new SmppPdu.SubmitMulti(
                7, withReceipt(text("1", "", "x")), List.of(number(SERVICE), number(OTHER_SERVICE))));
        network.commit();
        receiver.answer(receiver.last(SmppPdu.Message.class), SmppStatus.OK);
        network.commit();
        assertEquals(1, query("2"), "en route while one waits");
        other.answer(other.last(SmppPdu.Message.class), 0x65);
        network.commit();
        assertEquals(5, query("2"), "undeliverable, since one was refused");
        List<String> receipts = texts(sender);
        assertEquals(2, receipts.size());
        assertTrue(receipts.get(0).startsWith("id:2 ") && receipts.get(0).contains("stat:DELIVRD"), receipts.get(0));
        assertTrue(receipts.get(1).startsWith("id:2 ") && receipts.get(1).contains("stat:UNDELIV"), receipts.get(1));
    }

    @Test
    void severalReceiversOfWhichNoneCanBeServedAreRefused() {
        List<SmppAddress> letters = List.of(new SmppAddress(5, 0, "Bar"), new SmppAddress(5, 0, "Foo"));
        assertEquals(SmppStatus.SUBMIT_FAILED, statusOf(new SmppPdu.SubmitMulti(7, text("1", "", "x"), letters)));
        assertEquals(0, network.center.waitingCount());
    }

    @Test
    void tooManyPartsAndReceiversAtOnceAreRefused() {
        List<SmppAddress> many = IntStream.range(0, 254)
                .mapToObj(i -> number(String.valueOf(6_000_000 + i)))
                .toList();
        assertEquals(SmppStatus.OK, statusOf(new SmppPdu.SubmitMulti(7, ofThreeParts(), many)));
        assertEquals(3 * 254, network.center.waitingCount());
        byte[] text = "a".repeat(153 * 4).getBytes(StandardCharsets.US_ASCII);
        SmppMessage fourParts =
                with(text("1", "", ""), "", 0, List.of(new Tlv(Tlv.MESSAGE_PAYLOAD, OctetString.of(text))));
        assertEquals(SmppStatus.SUBMIT_FAILED, statusOf(new SmppPdu.SubmitMulti(8, fourParts, many)));
    }

    @ParameterizedTest
    @CsvSource({"0, 0x33", "2, 0x34", "3, 0x40"})
    void aDestinationOtherThanAnAddressIsRefusedWithTheStandardsStatus(int flag, String status) {
        byte[] octets = SmppCodec.encode(new SmppPdu.SubmitMulti(7, text("1", "", "x"), List.of(number(SERVICE))));
        // service_type, source: 1 + 2 + 2 octets; then number_of_dests and dest_flag.
        int count = SmppCodec.HEADER_LENGTH + 5;
        octets[flag == 0 ? count : count + 1] = (byte) flag;
        sender.say(octets);
        assertEquals(Integer.decode(status), lastResponse().status());
    }

    @ParameterizedTest
    @CsvSource({"000000000100000R, 60", "261121120145000+, 60", "261121130145004+, 60"})
    void aScheduledMessageIsDeliveredAtItsTime(String schedule, int seconds) {
        sender.submit(1, scheduled("later", schedule, ""));
        network.commit();
        assertEquals(SmppStatus.OK, lastResponse().status());
        assertEquals(
                WaitReason.SCHEDULED,
                network.center.messages().history(1).orElseThrow().waitReason());
        pass(seconds - 1);
        assertEquals(List.of(), texts(receiver));
        pass(1);
        assertEquals(List.of("later"), texts(receiver));
        receiver.answer(receiver.last(SmppPdu.Message.class), SmppStatus.OK);
        network.commit();
        assertEquals(List.of(), network.center.messages().waiting());
    }

    @Test
    void aScheduledMessageHoldsUpNoOther() {
        sender.submit(1, scheduled("later", "000000000100000R", ""));
        sender.submit(2, text("1", SERVICE, "now"));
        network.commit();
        assertEquals(List.of("now"), texts(receiver));
        pass(60);
        assertEquals(List.of("now", "later"), texts(receiver));
    }

    @ParameterizedTest
    @CsvSource({"rubbish, '', 0x61", "030000000000000R, '', 0x61", "000000000100000R, 000000000059000R, 0x62"})
    void aScheduleThatCannotBeIsRefused(String schedule, String validity, String status) {
        sender.submit(1, scheduled("x", schedule, validity));
        assertEquals(Integer.decode(status), lastResponse().status());
        assertEquals(0, network.center.waitingCount());
    }

    @Test
    void theValidityOfAScheduledMessageEndsAfterItsTime() {
        receiver.leave();
        sender.submit(1, scheduled("x", "000000000100000R", "000000000200000R"));
        network.commit();
        pass(119);
        assertEquals(1, query("1"));
        pass(1);
        network.commit();
        assertEquals(3, query("1"), "expired");
    }

    @Test
    void aScheduledMessageCanBeCancelled() {
        sender.submit(1, scheduled("x", "000000000100000R", ""));
        network.commit();
        assertEquals(SmppStatus.OK, statusOf(new SmppPdu.Cancel(2, "", "1", number("1"), SmppAddress.NONE)));
        pass(61);
        assertEquals(List.of(), texts(receiver));
        assertEquals(4, query("1"));
    }

    @Test
    void whatWaitsIsReplacedAndKeepsItsPlace() {
        receiver.leave();
        sender.submit(1, text("1", SERVICE, "first"));
        sender.submit(2, text("1", SERVICE, "second"));
        network.commit();
        sender.say(replacement("1", "other"));
        assertEquals(2, sender.all(SmppPdu.Response.class).size(), "answered when stored");
        network.commit();
        assertEquals(new SmppPdu.PlainResponse(SmppCommand.REPLACE_SM, SmppStatus.OK, 9), lastResponse());
        TestCenter.Application next = receiver(SERVICE);
        assertEquals(List.of("other", "second"), texts(next));
        next.answer(next.all(SmppPdu.Message.class).get(0), SmppStatus.OK);
        network.commit();
        assertTrue(texts(sender).get(0).contains("stat:DELIVRD"), "registered_delivery is new too");
    }

    @Test
    void nothingIsDeliveredWhileItsReplacementIsStored() {
        receiver.leave();
        sender.submit(1, text("1", SERVICE, "first"));
        network.commit();
        sender.say(replacement("1", "other"));
        TestCenter.Application next = receiver(SERVICE);
        assertEquals(List.of(), texts(next));
        network.center.committed(network.tickets.remove(), false);
        assertEquals(SmppStatus.SYSTEM_ERROR, lastResponse().status());
        assertEquals(List.of("first"), texts(next), "the old text holds");
    }

    @Test
    void aReplacementChangesTheTimeOfDeliveryAndTheValidity() {
        sender.submit(1, scheduled("x", "000000000100000R", ""));
        network.commit();
        SmppPdu.Replace later = new SmppPdu.Replace(
                9, "1", number("1"), "000000001000000R", "000000002000000R", 0, 0, OctetString.ofHex("79"));
        assertEquals(SmppStatus.OK, statusOf(later));
        pass(599);
        assertEquals(List.of(), texts(receiver));
        pass(1);
        assertEquals(List.of("y"), texts(receiver));
        assertEquals(
                TestCenter.START.plusSeconds(1_200),
                network.center.messages().waiting().get(0).expiresAt());
    }

    @Test
    void whatIsUnderWayOrUnknownOrLongIsNotReplaced() {
        sender.submit(1, text("1", SERVICE, "under way"));
        network.commit();
        assertEquals(SmppStatus.REPLACE_FAILED, statusOf(replacement("1", "x")));
        assertEquals(SmppStatus.REPLACE_FAILED, statusOf(replacement("99", "x")));
        receiver.leave();
        sender.submit(2, ofThreeParts());
        sender.submit(3, text("1", SERVICE, "x"));
        network.commit();
        assertEquals(SmppStatus.REPLACE_FAILED, statusOf(replacement("4", "x")), "of three parts");
        assertEquals(SmppStatus.INVALID_MESSAGE_LENGTH, statusOf(replacement("5", "y".repeat(161))));
        assertEquals(SmppStatus.OK, statusOf(replacement("5", "y".repeat(160))));
    }

    @Test
    void cancellingALongMessageCancelsAllItsParts() {
        receiver.leave();
        sender.submit(1, ofThreeParts());
        network.commit();
        assertEquals(3, network.center.waitingCount());
        assertEquals(SmppStatus.OK, statusOf(new SmppPdu.Cancel(2, "", "3", number("1"), SmppAddress.NONE)));
        assertEquals(0, network.center.messages().waiting().size());
        assertEquals(4, query("3"));
    }

    /** A message of this service type, with replace_if_present_flag or without. */
    private void submit(String type, String from, String to, String text, int replaces) {
        SmppMessage m = text(from, to, text);
        sender.submit(
                1,
                new SmppMessage(
                        type,
                        m.source(),
                        m.destination(),
                        0,
                        0,
                        0,
                        "",
                        "",
                        1,
                        replaces,
                        0,
                        0,
                        m.shortMessage(),
                        text.length() < 200 ? List.of() : List.of(new Tlv(Tlv.MESSAGE_PAYLOAD, m.shortMessage()))));
        network.commit();
    }

    private List<String> waiting() {
        return network.center.messages().waiting().stream()
                .map(message -> message.text())
                .toList();
    }

    @Test
    void aMessageReplacesTheLatestThatWaitsOfItsSourceDestinationAndServiceType() {
        receiver.leave();
        submit("CMT", "1", SERVICE, "one", 0);
        submit("CMT", "1", SERVICE, "two", 1);
        assertEquals(List.of("two"), waiting());
        assertTrue(texts(sender).get(0).contains("stat:DELETED"), "the receipt of the first");
        submit("", "1", SERVICE, "other type", 1);
        submit("CMT", "2", SERVICE, "other source", 1);
        submit("CMT", "1", OTHER_SERVICE, "other destination", 1);
        submit("CMT", "1", SERVICE, "without the flag", 0);
        assertEquals(List.of("two", "other type", "other source", "other destination", "without the flag"), waiting());
        submit("CMT", "1", SERVICE, "three", 1);
        assertEquals(List.of("two", "other type", "other source", "other destination", "three"), waiting());
    }

    @Test
    void aMessageReplacesAllPartsOfALongOneButNoneOfAnotherApplicationNorOneUnderWay() {
        submit("", "1", SERVICE, "under way", 0);
        receiver.leave();
        TestCenter.Application next = receiver(SERVICE);
        assertEquals(List.of("under way"), texts(next));
        TestCenter.Application other = network.bound(SmppCommand.BIND_TRANSMITTER, "other", "");
        other.submit(1, text("1", SERVICE, "another's"));
        other.submit(1, ofThreeParts());
        sender.submit(1, ofThreeParts());
        submit("", "1", OTHER_SERVICE, "waits", 0);
        network.commit();
        int before = network.center.messages().waiting().size();
        submit("", "1", OTHER_SERVICE, "instead", 1);
        assertEquals(before, network.center.messages().waiting().size());
        next.leave();
        submit("", "1", SERVICE, "short", 1);
        assertEquals(before - 3 + 1, network.center.messages().waiting().size());
        assertTrue(waiting().contains("another's"));
    }

    @Test
    void aMessageThatIsNotStoredReplacesNothing() {
        receiver.leave();
        submit("", "1", SERVICE, "one", 0);
        SmppMessage m = text("1", SERVICE, "two");
        sender.submit(
                2,
                new SmppMessage(
                        "", m.source(), m.destination(), 0, 0, 0, "", "", 0, 1, 0, 0, m.shortMessage(), List.of()));
        network.center.committed(network.tickets.remove(), false);
        assertEquals(List.of("one"), waiting());
    }

    @ParameterizedTest
    @CsvSource({"'', 0, 3", "CMT, 0, 4", "CPT, 0x11, 5"})
    void cancelWithoutAnIdEndsAllFromTheSourceToTheDestination(String type, String status, int left) {
        receiver.leave();
        submit("", "1", SERVICE, "a", 0);
        submit("CMT", "1", SERVICE, "b", 0);
        submit("CMT", "2", SERVICE, "other source", 0);
        submit("CMT", "1", OTHER_SERVICE, "other destination", 0);
        network.bound(SmppCommand.BIND_TRANSMITTER, "other", "").submit(1, text("1", SERVICE, "another's"));
        network.commit();
        assertEquals(Integer.decode(status), statusOf(new SmppPdu.Cancel(9, type, "", number("1"), number(SERVICE))));
        assertEquals(left, waiting().size());
    }

    @Test
    void cancellingThousandsLeavesTurnsToOthers() {
        receiver.leave();
        for (int i = 0; i < 3_500; i++) {
            sender.submit(i, text("1", SERVICE, "x"));
        }
        network.commit();
        sender.heard.clear();
        sender.say(new SmppPdu.Cancel(9, "", "", number("1"), number(SERVICE)));
        assertEquals(List.of(), sender.heard);
        assertEquals(2_500, waiting().size());
        network.center.cancel(1);
        network.timers.advance(network.timers.nowNanos() + 3_000_000);
        assertEquals(SmppStatus.OK, lastResponse().status());
        assertEquals(0, waiting().size());
    }

    @ParameterizedTest
    @CsvSource({"1, 7, 0x50", "1, 1, 0x0b"})
    void cancelWithoutAnIdNamesWhatIsWrongWithItsDestination(int plan, int type, String status) {
        SmppAddress to = new SmppAddress(type, plan, "letters");
        assertEquals(Integer.decode(status), statusOf(new SmppPdu.Cancel(9, "", "", number("1"), to)));
    }

    @Test
    void theIdOfAPartIsNotThatOfAMessage() {
        receiver.leave();
        sender.submit(1, ofThreeParts());
        network.commit();
        assertEquals(SmppStatus.CANCEL_FAILED, statusOf(new SmppPdu.Cancel(2, "", "2", number("1"), SmppAddress.NONE)));
    }

    @Test
    void everyRequestCountsTowardsTheRateOfAnApplicationElsewhere() {
        network.server.admit(SmppUsers.only(java.util.Map.of("far", "")));
        TestCenter.Application far = network.open(false);
        bind(far, "far", "");
        List<Integer> statuses = new ArrayList<>();
        for (int i = 0; i < RequestLimits.PER_SECOND + 10; i++) {
            far.heard.clear();
            far.say(new SmppPdu.Cancel(i, "", "1", SmppAddress.NONE, SmppAddress.NONE));
            statuses.add(far.last(SmppPdu.PlainResponse.class).status());
        }
        assertEquals(SmppStatus.CANCEL_FAILED, statuses.get(0));
        assertEquals(SmppStatus.THROTTLED, statuses.get(statuses.size() - 1));
        far.say(new SmppPdu.Plain(SmppCommand.ENQUIRE_LINK, 1));
        assertEquals(SmppStatus.OK, far.last(SmppPdu.PlainResponse.class).status(), "the link itself is always tested");
        pass(1);
        far.say(new SmppPdu.Cancel(1, "", "1", SmppAddress.NONE, SmppAddress.NONE));
        assertEquals(
                SmppStatus.CANCEL_FAILED, far.last(SmppPdu.PlainResponse.class).status());
    }
}
