package simgsm.center.msc;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simgsm.abis.CcmMessage;
import simgsm.abis.IpaFrame;
import simgsm.abis.RslMessage;
import simgsm.air.CallControl;
import simgsm.air.Cause;
import simgsm.air.Direction;
import simgsm.air.Imsi;
import simgsm.air.Layer3Codec;
import simgsm.air.Layer3Message;
import simgsm.air.LocationArea;
import simgsm.air.MobilityManagement;
import simgsm.air.Msisdn;
import simgsm.air.RadioResource;
import simgsm.air.RejectCause;
import simgsm.air.RelayMessage;
import simgsm.air.RpCause;
import simgsm.air.ShortMessageControl;
import simgsm.air.TransactionIdentifier;
import simgsm.center.msc.call.CallProgress;
import simgsm.center.msc.call.CallView;
import simgsm.octets.OctetString;
import simgsm.sim.SimCard;
import simgsm.sms.SmsAddress;
import simgsm.sms.SubmitTpdu;
import simgsm.sms.TpduCodec;
import simgsm.sms.UserData;

/**
 * Mobiles that say anything at any time, sound and damaged, vanish and come back, while the store fails now and then.
 * Whatever they do, the exchange throws nothing, holds no number twice, and keeps nothing of links that have gone. A seed
 * that fails fails again.
 */
class RandomTrafficTest {
    private static final String[] NUMBERS = {"5550100", "5550101", "5550200", "5550201"};
    private static final int STEPS = 1_500;

    private TestNetwork network;
    private final List<TestMobile> mobiles = new ArrayList<>();
    private SplittableRandom random;

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20})
    void nothingIsStuckAndNothingIsLeft(long seed) {
        network = new TestNetwork();
        misbehave(seed);
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10})
    void norInAClosedNetworkAndNoMobileRegistersUnproved(long seed) {
        network = new TestNetwork(
                List.of(NUMBERS).stream().map(RandomTrafficTest::card).toList());
        misbehave(seed);
        for (String number : NUMBERS) {
            TestMobile thief = network.connect(number);
            thief.received.clear();
            thief.requestUpdate(thief.imsi);
            thief.next(MobilityManagement.AuthenticationRequest.class);
            thief.tell(thief.responseOf(card("1" + number)));
            thief.next(MobilityManagement.AuthenticationReject.class);
        }
    }

    private static SimCard card(String number) {
        OctetString key = OctetString.ofHex("0".repeat(32 - number.length()) + number);
        return new SimCard(Imsi.ofOpenNumber(new Msisdn(number)), new Msisdn(number), key, key);
    }

    private void misbehave(long seed) {
        random = new SplittableRandom(seed);
        network.commitsAtOnce = false;
        for (String number : NUMBERS) {
            mobiles.add(network.attach(number));
        }
        for (int step = 0; step < STEPS; step++) {
            step();
            assertSound();
        }
        network.commitAll(true);
        network.everybodyVanishes();
        assertEquals(0, network.exchange.linkCount());
        assertTrue(network.exchange.calls().isEmpty());
        assertEquals(count(CallProgress.INITIATED), count(CallProgress.RELEASED));
        // First the messages expire, then the reports about them.
        for (int i = 0; i < 2; i++) {
            network.leap(Duration.ofDays(20));
            network.commitAll(true);
        }
        assertEquals(0, network.exchange.shortMessages().waitingCount());
    }

    private long count(CallProgress state) {
        return network.callStates().stream().filter(state::equals).count();
    }

    private void assertSound() {
        long attached = network.exchange.subscribers().stream()
                .filter(subscriber -> subscriber.isAttached())
                .count();
        assertTrue(attached <= network.exchange.linkCount());
        for (CallView call : network.exchange.calls()) {
            assertTrue(call.state() != CallProgress.RELEASED);
        }
    }

    private void step() {
        int index = random.nextInt(mobiles.size());
        TestMobile mobile = mobiles.get(index);
        switch (random.nextInt(20)) {
            case 0 -> {
                mobile.vanish();
                mobiles.set(index, network.connect(NUMBERS[index], mobile.imei));
            }
            case 1 -> mobiles.set(index, network.connect(NUMBERS[index], mobile.imei));
            case 2 -> network.passSeconds(random.nextInt(70));
            case 3 -> network.commitAll(random.nextInt(4) > 0);
            case 4, 5 -> mobile.leaveChannel();
            case 6, 7, 8 -> mobile.establish(message(mobile));
            case 9 -> mobile.frame(damaged(message(mobile)));
            case 10 -> mobile.ccm(new CcmMessage.Pong());
            case 11 -> network.exchange.broadcast(network.nowNanos, BroadcastOrder.once(50, "all"));
            default -> mobile.tell(message(mobile));
        }
        mobile.received.clear();
        if (mobile.closedFor.isPresent()) {
            mobiles.set(index, network.connect(NUMBERS[index], mobile.imei));
        }
    }

    private IpaFrame damaged(Layer3Message message) {
        byte[] layer3 = Layer3Codec.encode(message, Direction.UPLINK, random.nextInt(2));
        byte[] octets = new RslMessage.DataIndication(RslMessage.Sapi.SIGNALLING, OctetString.of(layer3)).encode();
        octets[random.nextInt(octets.length)] ^= (byte) (1 << random.nextInt(8));
        return new IpaFrame(IpaFrame.RSL, octets);
    }

    private Layer3Message message(TestMobile mobile) {
        TransactionIdentifier transaction = new TransactionIdentifier(random.nextInt(2), random.nextBoolean());
        Msisdn number = new Msisdn(NUMBERS[random.nextInt(NUMBERS.length)]);
        int reference = random.nextInt(3);
        return switch (random.nextInt(network.cards.isEmpty() ? 22 : 26)) {
            case 0, 1 ->
                new MobilityManagement.LocationUpdatingRequest(
                        MobilityManagement.LocationUpdatingType.NORMAL,
                        MobilityManagement.NO_KEY,
                        LocationArea.TEST,
                        random.nextBoolean() ? mobile.imsi : mobile.identity());
            case 2, 3 -> new MobilityManagement.IdentityResponse(mobile.imei);
            case 4 -> new MobilityManagement.TmsiReallocationComplete();
            case 5, 6 ->
                new MobilityManagement.CmServiceRequest(
                        random.nextBoolean()
                                ? MobilityManagement.ServiceType.MOBILE_ORIGINATED_CALL
                                : MobilityManagement.ServiceType.SHORT_MESSAGE,
                        MobilityManagement.NO_KEY,
                        mobile.identity());
            case 7 -> new MobilityManagement.ImsiDetachIndication(mobile.identity());
            case 8, 9 -> new RadioResource.PagingResponse(MobilityManagement.NO_KEY, mobile.identity());
            case 10, 11 ->
                new CallControl.Setup(new TransactionIdentifier(0, false), Optional.empty(), Optional.of(number));
            case 12 -> new CallControl.CallConfirmed(transaction);
            case 13 -> new CallControl.Alerting(transaction);
            case 14 -> new CallControl.Connect(transaction);
            case 15 -> new CallControl.ConnectAcknowledge(transaction);
            case 16 -> new CallControl.Disconnect(transaction, Cause.NORMAL_CALL_CLEARING);
            case 17 -> new CallControl.ReleaseComplete(transaction, Optional.empty());
            case 18 ->
                new ShortMessageControl.CpData(
                        new TransactionIdentifier(0, false),
                        new RelayMessage.RpData(reference, new Msisdn("3003"), submit(number)));
            case 19 -> new ShortMessageControl.CpAck(transaction);
            case 22, 23, 24, 25 -> answerTo(mobile);
            case 20 -> new ShortMessageControl.CpData(transaction, new RelayMessage.RpAck(reference, Optional.empty()));
            default ->
                new ShortMessageControl.CpData(
                        transaction, new RelayMessage.RpError(reference, RpCause.MEMORY_CAPACITY_EXCEEDED));
        };
    }

    /** The right one mostly. */
    private Layer3Message answerTo(TestMobile mobile) {
        if (mobile.challenge.isEmpty() || random.nextInt(8) == 0) {
            return new MobilityManagement.AuthenticationFailure(RejectCause.MAC_FAILURE, Optional.empty());
        }
        return mobile.responseOf(card(NUMBERS[random.nextInt(8) == 0 ? 0 : mobiles.indexOf(mobile)]));
    }

    private static OctetString submit(Msisdn to) {
        return TpduCodec.encode(SubmitTpdu.of(1, SmsAddress.of(to), UserData.of("** #**20 **")));
    }
}
