package simgsm.center.msc;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import simgsm.air.Cause;
import simgsm.air.Imsi;
import simgsm.air.MobilityManagement;
import simgsm.air.Msisdn;
import simgsm.center.msc.call.CallProgress;
import simgsm.center.msc.call.CallView;
import simgsm.octets.OctetString;
import simgsm.sms.SmsAddress;
import simgsm.sms.SubmitTpdu;
import simgsm.sms.TpduCodec;
import simgsm.sms.UserData;

class SnapshotTest {
    private final TestNetwork network = new TestNetwork();

    @Test
    void aRegistrationIsALadderOfNamedMessages() {
        TestMobile mobile = network.connect("5550100").register();
        ExchangeSnapshot snapshot = network.exchange.snapshot();
        assertEquals(
                List.of(
                        "Location Updating Request",
                        "Identity Request",
                        "Identity Response",
                        "Location Updating Accept",
                        "TMSI Reallocation Complete",
                        "MM Information",
                        "Channel Release"),
                snapshot.ladder().stream().map(LadderEntry::name).toList());
        LadderEntry first = snapshot.ladder().get(0);
        assertEquals("5550100", first.from());
        assertEquals(LadderEntry.CENTER, first.to());
        LadderEntry last = snapshot.ladder().get(6);
        assertEquals(LadderEntry.CENTER, last.from());
        assertEquals("5550100", last.to());
        assertEquals(OctetString.ofHex("060d00"), last.octets());
        assertEquals(7, snapshot.ladderCount());
        assertEquals(
                List.of(new ExchangeSnapshot.SubscriberRow(
                        new Msisdn("5550100"), true, "001010005550100", mobile.imei.digits())),
                snapshot.subscribers());
        assertEquals(1, snapshot.attached());
        assertEquals(TestNetwork.START, snapshot.time());
    }

    @Test
    void aTerminalBearsTheNumberOfItsFirstMessageAndKeepsItWhenItHasLeft() {
        TestMobile mobile = network.connect("5550100");
        mobile.requestUpdate(Imsi.ofOpenNumber(new Msisdn("5550100")));
        assertEquals("5550100", network.exchange.snapshot().ladder().get(0).from());
        mobile.register();
        mobile.vanish();
        assertEquals("5550100", network.exchange.snapshot().ladder().get(0).from());
    }

    @Test
    void aTerminalOfAnotherNetworkBearsItsImsi() {
        network.connect("5550100").requestUpdate(new Imsi("262011234567890"));
        assertEquals(
                "IMSI 262011234567890",
                network.exchange.snapshot().ladder().get(0).from());
    }

    @Test
    void anEmergencyCallerWithoutANumberBearsItsCallbackNumber() {
        TestMobile mobile = network.connect("5550100");
        mobile.establish(new MobilityManagement.CmServiceRequest(
                MobilityManagement.ServiceType.EMERGENCY_CALL, MobilityManagement.NO_KEY, mobile.imei));
        String digits = mobile.imei.digits();
        assertEquals(
                "911" + digits.substring(digits.length() - 7),
                network.exchange.snapshot().ladder().get(0).from());
    }

    @Test
    void theLadderForgetsItsOldestMessagesAndCountsThem() {
        TestMobile mobile = network.attach("5550100");
        for (int i = 0; i < Ladder.MAX_ENTRIES; i++) {
            mobile.requestService(MobilityManagement.ServiceType.SHORT_MESSAGE);
        }
        ExchangeSnapshot snapshot = network.exchange.snapshot();
        assertEquals(Ladder.MAX_ENTRIES, snapshot.ladder().size());
        assertTrue(snapshot.ladderCount() > 2L * Ladder.MAX_ENTRIES);
    }

    @Test
    void aClearedCallStaysInViewWithItsCause() {
        TestMobile mobile = network.attach("5550100");
        mobile.dial("5550200");

        ExchangeSnapshot snapshot = network.exchange.snapshot();
        assertEquals(List.of(), snapshot.calls());
        CallView ended = snapshot.endedCalls().get(0);
        assertEquals("5550200", ended.to());
        assertEquals(CallProgress.RELEASED, ended.state());
        assertEquals(Optional.of(Cause.UNASSIGNED_NUMBER), ended.cause());
        assertEquals(0, ended.activeSeconds());
    }

    @Test
    void onlyTheLatestHundredClearedCallsStayInView() {
        TestMobile mobile = network.attach("5550100");
        for (int i = 0; i <= 100; i++) {
            mobile.dial(String.valueOf(5550200 + i));
            mobile.received.clear();
        }
        List<CallView> ended = network.exchange.snapshot().endedCalls();
        assertEquals(100, ended.size());
        assertEquals("5550300", ended.get(0).to());
    }

    @Test
    void theLatestTransactionIsInView() {
        TestMobile mobile = network.attach("5550100");
        assertEquals(Optional.empty(), network.exchange.snapshot().latest());
        mobile.dial("5550200");
        assertEquals(
                Optional.of(new ExchangeSnapshot.Passing(new Msisdn("5550100"), "5550200", "")),
                network.exchange.snapshot().latest());
        mobile.received.clear();
        mobile.requestService(MobilityManagement.ServiceType.SHORT_MESSAGE);
        SubmitTpdu submit = SubmitTpdu.of(1, SmsAddress.of(new Msisdn("5550200")), UserData.of("** #**20 **"));
        mobile.sendMessage(0, 1, TpduCodec.encode(submit));
        ExchangeSnapshot snapshot = network.exchange.snapshot();
        assertEquals(
                Optional.of(new ExchangeSnapshot.Passing(new Msisdn("5550100"), "5550200", "** #**20 **")),
                snapshot.latest());
        assertEquals("** #**20 **", snapshot.messages().get(0).text());
        assertEquals(1, snapshot.waiting());
    }

    @Test
    void aShortMessageShowsBothItsLayers() {
        TestMobile mobile = network.attach("5550100");
        mobile.requestService(MobilityManagement.ServiceType.SHORT_MESSAGE);
        SubmitTpdu submit = SubmitTpdu.of(1, SmsAddress.of(new Msisdn("5550200")), UserData.of("hello"));
        mobile.sendMessage(0, 1, TpduCodec.encode(submit));
        List<String> names = network.exchange.snapshot().ladder().stream()
                .map(LadderEntry::name)
                .toList();
        assertEquals(
                List.of("CP-DATA (RP-DATA SUBMIT)", "CP-ACK", "CP-DATA (RP-ACK)"),
                names.subList(names.size() - 3, names.size()));
    }
}
