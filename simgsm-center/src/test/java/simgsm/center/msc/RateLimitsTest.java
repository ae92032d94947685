package simgsm.center.msc;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import simgsm.abis.CcmMessage;
import simgsm.air.Imei;
import simgsm.air.MobilityManagement;
import simgsm.air.Msisdn;
import simgsm.air.RejectCause;
import simgsm.air.RelayMessage;
import simgsm.air.RpCause;
import simgsm.air.ShortMessageControl;
import simgsm.center.msc.link.NetworkTimer;
import simgsm.center.msc.link.TerminalRateLimits;
import simgsm.octets.OctetString;
import simgsm.sms.SmsAddress;
import simgsm.sms.SubmitTpdu;
import simgsm.sms.TpduCodec;
import simgsm.sms.UserData;

/** Floods and silence, with a clock moved by hand. */
class RateLimitsTest {
    private final TestNetwork network = new TestNetwork();

    private TestMobile remote(String number) {
        TestMobile mobile = new TestMobile(network, number, new Imei("490154203237518"), false);
        mobile.received.clear();
        return mobile;
    }

    @Test
    void aPeerThatSaysNothingIsDroppedAfter15Seconds() {
        TestMobile silent = network.connect("5550100");
        network.leap(Duration.ofNanos(NetworkTimer.IDENTIFICATION.nanos() - 1));
        assertEquals(Optional.empty(), silent.closedFor);
        network.leap(Duration.ofNanos(1));
        assertEquals(Optional.of("has not identified itself"), silent.closedFor);
        assertEquals(0, network.exchange.linkCount());
        assertTrue(network.exchange.nextDeadlineNanos().isEmpty());
    }

    @Test
    void whoeverSaysWhatItIsMayStaySwitchedOff() {
        TestMobile off = network.connect("5550100");
        off.ccm(new CcmMessage.IdentityResponse("SimGSM phone", off.imei.digits()));
        network.passSeconds(300);
        assertEquals(Optional.empty(), off.closedFor);
    }

    @Test
    void aRegisteredTerminalHasSentItsIdentity() {
        TestMobile mobile = network.attach("5550100");
        network.passSeconds(300);
        assertEquals(Optional.empty(), mobile.closedFor);
    }

    private RejectCause registrationAnswer(TestMobile mobile) {
        mobile.received.clear();
        mobile.requestUpdate(mobile.imsi);
        return mobile.received.peek() instanceof MobilityManagement.LocationUpdatingReject reject
                ? reject.cause()
                : null;
    }

    @Test
    void registrationsOfAnotherMachineAreAnsweredTenAtOnceAndThenOneASecond() {
        TestMobile flooder = remote("5550100");
        for (int i = 0; i < TerminalRateLimits.REGISTRATIONS_AT_ONCE; i++) {
            assertEquals(null, registrationAnswer(flooder));
        }
        assertEquals(RejectCause.CONGESTION, registrationAnswer(flooder));
        network.attach("5550101");
        network.passSeconds(1);
        assertEquals(null, registrationAnswer(flooder));
        assertEquals(RejectCause.CONGESTION, registrationAnswer(flooder));
    }

    @Test
    void aTerminalOfThisMachineIsNotHeldToIt() {
        TestMobile busy = network.connect("5550100");
        for (int i = 0; i < 1_000; i++) {
            assertEquals(null, registrationAnswer(busy));
        }
    }

    private static RelayMessage send(TestMobile sender, int number) {
        sender.requestService(MobilityManagement.ServiceType.SHORT_MESSAGE);
        OctetString tpdu = TpduCodec.encode(new SubmitTpdu(
                false,
                false,
                false,
                number % 256,
                SmsAddress.of(new Msisdn("5550200")),
                0,
                Optional.empty(),
                UserData.of("text " + number)));
        sender.sendMessage(0, number % 256, tpdu);
        sender.next(ShortMessageControl.CpAck.class);
        ShortMessageControl.CpData answer = sender.next(ShortMessageControl.CpData.class);
        sender.tell(new ShortMessageControl.CpAck(answer.transaction().answered()));
        sender.leaveReleasedChannel();
        return answer.relay();
    }

    @Test
    void messagesOfAnotherMachineAreTakenInALongTextsNumberAtOnceAndThenTenASecond() {
        TestMobile flooder = remote("5550100").register();
        for (int i = 0; i < TerminalRateLimits.MESSAGES_AT_ONCE; i++) {
            assertEquals(new RelayMessage.RpAck(i % 256, Optional.empty()), send(flooder, i));
        }
        assertEquals(new RelayMessage.RpError(255, RpCause.CONGESTION), send(flooder, 511));
        network.leap(Duration.ofMillis(100));
        assertEquals(new RelayMessage.RpAck(255, Optional.empty()), send(flooder, 511));
    }

    @Test
    void callsOfAnotherMachineAreTakenTwentyAtOnceAndThenTwoASecond() {
        TestMobile flooder = remote("5550100").register();
        for (int i = 0; i < TerminalRateLimits.CALLS_AT_ONCE; i++) {
            flooder.dial("5559999");
            flooder.received.clear();
            flooder.leaveChannel();
        }
        flooder.establish(new MobilityManagement.CmServiceRequest(
                MobilityManagement.ServiceType.MOBILE_ORIGINATED_CALL, MobilityManagement.NO_KEY, flooder.identity()));
        assertEquals(
                RejectCause.CONGESTION,
                flooder.next(MobilityManagement.CmServiceReject.class).cause());
        flooder.leaveReleasedChannel();
        network.leap(Duration.ofMillis(500));
        flooder.requestService(MobilityManagement.ServiceType.MOBILE_ORIGINATED_CALL);
    }
}
