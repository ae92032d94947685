package simgsm.center.smpp;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static simgsm.center.smpp.SmppClient.text;
import static simgsm.center.smpp.SmppClient.with;
import static simgsm.center.smpp.SmppClient.withReceipt;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simgsm.octets.OctetString;
import simgsm.smpp.SmppAddress;
import simgsm.smpp.SmppCommand;
import simgsm.smpp.SmppMessage;
import simgsm.smpp.SmppPdu;
import simgsm.smpp.SmppStatus;
import simgsm.smpp.Tlv;

/** What became of a message: receipts, questions, recalls. */
class SmppReceiptTest extends SmppStage {
    @Test
    void aReceiptSaysWhatBecameOfTheMessage() {
        TestCenter.Application receiver = receiver(SERVICE);
        TestCenter.Application sender = network.bound(SmppCommand.BIND_TRANSCEIVER, "sender", "");
        sender.submit(1, withReceipt(text("5550100", SERVICE, "how do you do, dear reader?")));
        network.commit();
        network.passSeconds(20);
        receiver.answer(receiver.all(SmppPdu.Message.class).get(0), SmppStatus.OK);
        network.commit();
        SmppMessage receipt = sender.last(SmppPdu.Message.class).message();
        assertEquals(SmppMessage.RECEIPT, receipt.esmClass());
        assertEquals(
                "id:1 sub:001 dlvrd:001 submit date:2611211200 done date:2611211201 stat:DELIVRD err:000"
                        + " text:how do you do, dear ",
                textOf(sender.last(SmppPdu.Message.class)));
        assertEquals(SERVICE, receipt.source().value());
        assertEquals("5550100", receipt.destination().value());
        assertEquals(
                List.of(new Tlv(0x001e, OctetString.ofHex("3100")), new Tlv(0x0427, OctetString.ofHex("02"))),
                receipt.parameters());
    }

    @Test
    void aReceiptWaitsForAnApplicationThatOnlySends() {
        receiver(SERVICE);
        TestCenter.Application sender = sender();
        sender.submit(1, with(withReceipt(text("1", "5559999", "x")), "000000000100000R", 1, List.of()));
        network.commit();
        network.passSeconds(61);
        network.commit();
        assertEquals(1, sender.all(SmppPdu.Message.class).size() + network.center.waitingCount());
        TestCenter.Application fetching = network.bound(SmppCommand.BIND_RECEIVER, "sender", "");
        assertTrue(
                texts(fetching).get(0).contains("stat:EXPIRED err:070"),
                texts(fetching).get(0));
    }

    @ParameterizedTest
    @CsvSource({"0, 0, 0", "1, 1, 1", "2, 0, 1"})
    void receiptsComeAsTheyWereAskedFor(int registered, int onDelivery, int onFailure) {
        TestCenter.Application receiver = receiver(SERVICE);
        TestCenter.Application sender = network.bound(SmppCommand.BIND_TRANSCEIVER, "sender", "");
        sender.submit(1, with(text("1", SERVICE, "x"), "", registered, List.of()));
        network.commit();
        receiver.answer(receiver.last(SmppPdu.Message.class), SmppStatus.OK);
        network.commit();
        assertEquals(onDelivery, sender.all(SmppPdu.Message.class).size());
        sender.heard.clear();
        sender.submit(2, with(text("1", SERVICE, "x"), "", registered, List.of()));
        network.commit();
        receiver.answer(receiver.last(SmppPdu.Message.class), 0x65);
        network.commit();
        assertEquals(onFailure, sender.all(SmppPdu.Message.class).size());
    }

    @Test
    void aMessageThatWaitsCanBeAskedAboutAndCalledBack() {
        TestCenter.Application sender = network.bound(SmppCommand.BIND_TRANSCEIVER, "sender", "");
        sender.submit(1, withReceipt(text("5550100", SERVICE, "x")));
        network.commit();
        SmppAddress source = new SmppAddress(1, 1, "5550100");
        sender.say(new SmppPdu.Query(2, "1", source));
        assertEquals(
                new SmppPdu.QueryResponse(SmppStatus.OK, 2, "1", "", 1, 0), sender.last(SmppPdu.QueryResponse.class));
        sender.say(new SmppPdu.Cancel(3, "", "1", source, new SmppAddress(1, 1, SERVICE)));
        network.commit();
        assertTrue(sender.heard.contains(new SmppPdu.PlainResponse(SmppCommand.CANCEL_SM, SmppStatus.OK, 3)));
        network.commit();
        assertTrue(sender.all(SmppPdu.Message.class).stream()
                .anyMatch(each -> textOf(each).contains("stat:DELETED")));
        sender.say(new SmppPdu.Query(4, "1", source));
        SmppPdu.QueryResponse answer = sender.last(SmppPdu.QueryResponse.class);
        assertEquals(4, answer.state());
        assertEquals("261121120045000+", answer.finalDate());
        assertEquals(List.of(), texts(receiver(SERVICE)));
    }

    @Test
    void anApplicationHearsNothingOfTheMessagesOfOthers() {
        sender().submit(1, text("5550100", SERVICE, "x"));
        network.commit();
        TestCenter.Application other = network.bound(SmppCommand.BIND_TRANSMITTER, "other", "");
        other.say(new SmppPdu.Query(1, "1", SmppAddress.NONE));
        assertEquals(
                SmppStatus.QUERY_FAILED, other.last(SmppPdu.QueryResponse.class).status());
        other.say(new SmppPdu.Cancel(2, "", "1", SmppAddress.NONE, SmppAddress.NONE));
        assertEquals(
                SmppStatus.CANCEL_FAILED,
                other.last(SmppPdu.PlainResponse.class).status());
        other.say(new SmppPdu.Query(3, "no number", SmppAddress.NONE));
        assertEquals(
                SmppStatus.QUERY_FAILED, other.last(SmppPdu.QueryResponse.class).status());
    }

    @Test
    void aMessageUnderWayCannotBeCalledBack() {
        receiver(SERVICE);
        TestCenter.Application sender = sender();
        sender.submit(1, text("1", SERVICE, "x"));
        network.commit();
        sender.say(new SmppPdu.Cancel(2, "", "1", SmppAddress.NONE, SmppAddress.NONE));
        assertEquals(
                SmppStatus.CANCEL_FAILED,
                sender.last(SmppPdu.PlainResponse.class).status());
    }
}
